// Texts that are too long, and what a syntax cannot say, give no document and one line that says why.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/writing/reading_again.hpp"

namespace geminga::writing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

Read small() {
  Read original;
  const owl::FileId file = original.source.add_file("t");
  original.source.add(owl::AxiomKind::sub_class_of,
                      {original.source.named_class("http://e/A"), original.source.named_class("http://e/B")}, file, 1);
  return original;
}

TEST(WritingLimit, OfOctetsIsHeld) {
  for (const syntax::Syntax syntax : syntaxes) {
    const std::size_t octets = written(small(), syntax).size();
    EXPECT_EQ(written(small(), syntax, {.octets = octets - 1}),
              "cannot: the text has more than " + std::to_string(octets - 1) + " octets: write fewer files");
    EXPECT_EQ(written(small(), syntax, {.octets = octets}).size(), octets);
    EXPECT_EQ(written(small(), syntax, {.octets = octets + 1}).size(), octets);
  }
}

TEST(Writing, RefusesATextThatTheSyntaxCannotHave) {
  Read original = small();
  owl::Annotation& annotation = original.annotations.emplace_back(owl::annotation_of("http://e/A", "http://e/note"));
  annotation.is_literal = true;
  annotation.value = "a bell \a rings";
  EXPECT_THAT(written(original, syntax::Syntax::owl_xml), StartsWith("cannot: a text has the control character 7"));
  EXPECT_THAT(written(original, syntax::Syntax::functional), HasSubstr("a bell \a rings"));
}

TEST(Writing, RefusesANameThatNoIriCanBe) {
  Read original = small();
  original.source.add(owl::AxiomKind::declaration, {original.source.named_class("http://e/A B")}, owl::FileId{0}, 1);
  EXPECT_THAT(written(original, syntax::Syntax::functional), StartsWith("cannot: the name http://e/A B has"));
  EXPECT_THAT(written(original, syntax::Syntax::manchester), StartsWith("cannot: the name http://e/A B has"));
}

TEST(Writing, NamesPropertiesThatManchesterSyntaxDoesNotTellApart) {
  Read original = small();
  const owl::TermId of_objects = original.source.object_property("http://e/p");
  const owl::TermId of_data = original.source.data_property("http://e/p");
  original.source.add(owl::AxiomKind::functional_object_property, {of_objects}, owl::FileId{0}, 1);
  original.source.add(owl::AxiomKind::functional_data_property, {of_data}, owl::FileId{0}, 1);
  const owl::Annotations annotations(original.annotations);
  const Document document{original.source, annotations, {}, {}, {}, {0, 1, 2}};
  const Sink sink = [](std::string_view) { return true; };
  EXPECT_THAT(write(document, syntax::Syntax::manchester, sink).ambiguous_properties, ElementsAre("http://e/p"));
  EXPECT_THAT(write(document, syntax::Syntax::functional, sink).ambiguous_properties, IsEmpty());
}

TEST(Writing, StopsWhereTheSinkTakesNoMore) {
  const Read original = small();
  const owl::Annotations annotations(original.annotations);
  const Document document{original.source, annotations, {}, {}, {}, {0}};
  const Sink sink = [](std::string_view) { return false; };
  EXPECT_EQ(write(document, syntax::Syntax::functional, sink).problem, "the output takes no more");
}

}  // namespace
}  // namespace geminga::writing
