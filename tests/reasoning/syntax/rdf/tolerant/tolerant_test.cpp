// Results for files that are not quite right, and the files that are refused.
#include "reasoning/syntax/rdf/tolerant/tolerant.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reasoning/syntax/rdf/scratch.hpp"
#include "reasoning/syntax/rdf/tolerant/told_classes.hpp"

namespace geminga::rdf {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr std::string_view head =
    "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
    "xmlns:rdfs='http://www.w3.org/2000/01/rdf-schema#' xmlns:owl='http://www.w3.org/2002/07/owl#' "
    "xml:base='http://e/o'>\n";

std::expected<Tolerated, syntax::LoadError> read(const Scratch& scratch, const std::string& content,
                                                 const std::string& name = "o.owl") {
  return read_tolerantly(scratch.write(name, content));
}

/// "sub super" of each inclusion, without what is before the `#`.
std::vector<std::string> inclusions(Tolerated& read) {
  read.graph.index();
  std::vector<std::string> found;
  const auto name = [&](NodeId node) {
    const std::string text(read.graph.text(node));
    return text.substr(text.find('#') + 1);
  };
  for (const auto& [sub, super] : told_classes(read.graph).inclusions) found.push_back(name(sub) + ' ' + name(super));
  return found;
}

TEST(Tolerant, ReadsWhatIsRightAsItIs) {
  const Scratch scratch;
  auto file = read(
      scratch, std::string(head) + "<owl:Class rdf:ID='A'><rdfs:subClassOf rdf:resource='#B'/></owl:Class></rdf:RDF>");
  ASSERT_TRUE(file);
  EXPECT_FALSE(file->broken_off);
  EXPECT_THAT(inclusions(*file), ElementsAre("A B"));
}

TEST(Tolerant, MendsNamesAndEncodings) {
  const Scratch scratch;
  auto file = read(scratch, "<?xml version='1.0' encoding='WINDOWS-1252'?>\n" + std::string(head) +
                                "<owl:Class rdf:ID='4 wheels'><rdfs:subClassOf rdf:resource='#B'/>"
                                "<rdfs:label>caf\xe9 & bar</rdfs:label></owl:Class>"
                                "<owl:Class rdf:ID='B'/><owl:Class rdf:ID='B'/></rdf:RDF>");
  ASSERT_TRUE(file);
  EXPECT_FALSE(file->broken_off) << file->broken_off->text;
  EXPECT_THAT(inclusions(*file), ElementsAre("4 wheels B"));
}

TEST(Tolerant, KeepsWhatStandsBeforeAnErrorAndNamesItsLine) {
  const Scratch scratch;
  auto file = read(scratch, std::string(head) +
                                "<owl:Class rdf:ID='A'><rdfs:subClassOf rdf:resource='#B'/></owl:Class>\n</oops>\n"
                                "<owl:Class rdf:ID='C'><rdfs:subClassOf rdf:resource='#D'/></owl:Class></rdf:RDF>");
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->broken_off);
  EXPECT_EQ(file->broken_off->line, 3U);
  EXPECT_THAT(inclusions(*file), ElementsAre("A B"));
}

TEST(Tolerant, RefusesWhatRedlandMustNotSeeAndWhatIsNoOntology) {
  const Scratch scratch;
  const auto entity =
      read(scratch, "<!DOCTYPE rdf:RDF [<!ENTITY % x '<!ENTITY y \"z\">'> %x;]>" + std::string(head) + "&y;</rdf:RDF>");
  ASSERT_FALSE(entity);
  EXPECT_THAT(entity.error().file, HasSubstr("o.owl"));
  EXPECT_FALSE(read(scratch, std::string("<rdf:RDF>\0</rdf:RDF>", 20)));
  EXPECT_FALSE(read(scratch, "<html><body>404</body></html>"));
  EXPECT_FALSE(read_tolerantly((scratch.path() / "none.owl").string()));
}

TEST(Tolerant, KnowsOwlsFilesByTheirContentAndLeavesOtherSyntaxesEmpty) {
  const Scratch scratch;
  EXPECT_TRUE(read(scratch, std::string(head) + "</rdf:RDF>", "s.owls"));
  const auto functional = read(scratch, "Ontology(<http://e/o>)");
  ASSERT_TRUE(functional);
  EXPECT_EQ(functional->syntax, syntax::Syntax::functional);
  EXPECT_EQ(functional->graph.triple_count(), 0U);
}

TEST(ToldClasses, AreThoseOfExpressionsToo) {
  const Scratch scratch;
  auto file =
      read(scratch,
           "@prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> . "
           "@prefix : <http://e#> . :A a owl:Class ; rdfs:subClassOf [ owl:intersectionOf ( :B [ owl:intersectionOf "
           "( :C [ a owl:Restriction ] ) ] ) ] . :D owl:equivalentClass :E , [ owl:unionOf ( :F :G ) ] . "
           ":H owl:unionOf ( :I ) ; owl:intersectionOf ( :J ) . "
           ":K <http://www.daml.org/2001/03/daml+oil#subClassOf> :L . [] rdfs:subClassOf :M .",
           "o.ttl");
  ASSERT_TRUE(file);
  EXPECT_THAT(inclusions(*file), UnorderedElementsAre("A B", "A C", "D E", "E D", "F D", "G D", "I H", "H J", "K L"));
}

TEST(ToldClasses, EndsOnListsThatAreCircles) {
  const Scratch scratch;
  auto file = read(scratch,
                   "@prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdf: "
                   "<http://www.w3.org/1999/02/22-rdf-syntax-ns#> . @prefix : <http://e#> . "
                   ":A owl:intersectionOf _:l . _:l rdf:first _:l ; rdf:rest _:l ; owl:intersectionOf _:l .",
                   "o.ttl");
  ASSERT_TRUE(file);
  EXPECT_THAT(inclusions(*file), IsEmpty());
}

}  // namespace
}  // namespace geminga::rdf
