// Prefixes and imports: what is noted once, what is refused, and the limits.
#include "reasoning/syntax/document/head.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geminga::document {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::Pointee;
using testing::SizeIs;

constexpr std::string_view owl_namespace = "http://www.w3.org/2002/07/owl#";

TEST(Head, KnowsFourPrefixesAndListsThemOnlyWhereTheyAreDeclared) {
  Head head(10, 10);
  owl::Document document;
  EXPECT_THAT(head.iri_of("owl"), Pointee(std::string(owl_namespace)));
  for (const char* prefix : {"rdf", "rdfs", "xsd"}) EXPECT_NE(head.iri_of(prefix), nullptr) << prefix;
  EXPECT_EQ(head.iri_of("e"), nullptr);
  EXPECT_EQ(head.declare("owl", owl_namespace, document), std::nullopt);
  EXPECT_EQ(head.declare("owl", owl_namespace, document), std::nullopt);
  EXPECT_THAT(document.prefixes, ElementsAre(Field(&owl::DeclaredPrefix::prefix, "owl")));
}

TEST(Head, RefusesASecondMeaningOfAPrefix) {
  Head head(10, 10);
  owl::Document document;
  EXPECT_EQ(head.declare("", "http://e/a#", document), std::nullopt);
  EXPECT_EQ(head.declare("", "http://e/a#", document), std::nullopt);
  EXPECT_EQ(head.declare("", "http://e/b#", document), "the prefix : already stands for <http://e/a#>");
  EXPECT_EQ(head.declare("xsd", "http://e/a#", document),
            "the prefix xsd: already stands for <http://www.w3.org/2001/XMLSchema#>");
  EXPECT_THAT(head.iri_of(""), Pointee(std::string("http://e/a#")));
  EXPECT_THAT(document.prefixes, SizeIs(1));
}

TEST(Head, TakesAsManyPrefixesAsItsLimitAndNoMore) {
  Head head(2, 0);
  owl::Document document;
  EXPECT_EQ(head.declare("a", "http://e/a#", document), std::nullopt);
  EXPECT_EQ(head.declare("b", "http://e/b#", document), std::nullopt);
  EXPECT_EQ(head.declare("c", "http://e/c#", document), "more than 2 prefixes");
  EXPECT_EQ(head.declare("b", "http://e/b#", document), std::nullopt);
  EXPECT_THAT(document.prefixes, SizeIs(2));
}

TEST(Head, NotesAnImportOnceAndRefusesOneTooMany) {
  Head head(0, 2);
  owl::Document document;
  EXPECT_EQ(head.import("http://e/a", 3, document), std::nullopt);
  EXPECT_EQ(head.import("http://e/b", 4, document), std::nullopt);
  EXPECT_EQ(head.import("http://e/a", 5, document), std::nullopt);
  EXPECT_EQ(head.import("http://e/c", 6, document), "more than 2 imports");
  EXPECT_THAT(document.imports, ElementsAre(Field(&owl::Import::line, 3), Field(&owl::Import::line, 4)));
  EXPECT_THAT(document.prefixes, IsEmpty());
}

}  // namespace
}  // namespace geminga::document
