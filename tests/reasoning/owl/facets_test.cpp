// Facets and literals that are outside of OWL 2 DL cost their axiom, or are read as numbers where that is wanted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "reasoning/owl/print.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::owl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string xsd = "http://www.w3.org/2001/XMLSchema#";
const std::string rdf = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";

std::string short_name(std::string_view iri) { return std::string(iri.substr(iri.find('#') + 1)); }

/// A source with one axiom about a range, and what became of it.
struct Said {
  explicit Said(bool is_lenient = false) {
    source.add_file("t");
    if (is_lenient) source.read_leniently();
  }

  void range(TermId range, std::uint32_t line = 7) {
    source.add(AxiomKind::data_property_range, {source.data_property("u"), range}, FileId{0}, line);
  }
  void restriction(const std::string& base, const std::string& facet, const std::string& lexical,
                   const std::string& datatype) {
    range(source.term(TermKind::datatype_restriction,
                      {source.datatype(base), source.facet(facet, source.literal(lexical, datatype))}));
  }
  [[nodiscard]] std::vector<std::string> axioms() const {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < source.axiom_count(); ++at)
      lines.push_back(print(source, source.axiom(at).arguments[1], short_name));
    return lines;
  }
  [[nodiscard]] static std::vector<std::string> texts(const Ontology& source,
                                                      std::span<const Ontology::Omission> notes) {
    std::vector<std::string> lines;
    for (const Ontology::Omission& note : notes)
      lines.push_back(std::string(source.name(note.construct)) + ' ' + std::to_string(note.count) + " line " +
                      std::to_string(note.line));
    return lines;
  }
  [[nodiscard]] std::vector<std::string> left_out() const { return texts(source, source.omissions()); }
  [[nodiscard]] std::vector<std::string> remarks() const { return texts(source, source.remarks()); }

  Ontology source;
};

struct Facet {
  std::string base, facet, lexical, datatype;
};

TEST(Facets, OfTheDatatypeAreTaken) {
  const std::vector<Facet> good{
      {xsd + "double", xsd + "maxInclusive", "1", xsd + "double"},
      {xsd + "integer", xsd + "minExclusive", "1.5", xsd + "decimal"},
      {xsd + "decimal", xsd + "minInclusive", "7", xsd + "byte"},
      {xsd + "dateTime", xsd + "minInclusive", "2020-01-01T00:00:00Z", xsd + "dateTime"},
      {xsd + "string", xsd + "pattern", "[a-z]*", xsd + "string"},
      {xsd + "string", xsd + "maxLength", "3", xsd + "integer"},
      {xsd + "hexBinary", xsd + "length", "3", xsd + "nonNegativeInteger"},
      {xsd + "anyURI", xsd + "pattern", "http.*", xsd + "string"},
      {rdf + "PlainLiteral", rdf + "langRange", "en", xsd + "string"},
      {"http://e/#unknown", xsd + "maxInclusive", "1", xsd + "integer"},
      {xsd + "integer", xsd + "maxInclusive", "1", "http://e/#unknown"},
  };
  for (const Facet& one : good) {
    Said said;
    said.restriction(one.base, one.facet, one.lexical, one.datatype);
    EXPECT_THAT(said.left_out(), IsEmpty()) << one.base << ' ' << one.facet << ' ' << one.lexical;
    EXPECT_EQ(said.source.axiom_count(), 1U);
  }
}

TEST(Facets, ThatTheDatatypeDoesNotHaveCostTheirAxiom) {
  const std::vector<Facet> foreign{
      {xsd + "double", xsd + "maxInclusive", "1", xsd + "integer"},
      {xsd + "float", xsd + "minInclusive", "1", xsd + "double"},
      {xsd + "integer", xsd + "minInclusive", "1", xsd + "double"},
      {xsd + "integer", xsd + "minInclusive", "1", xsd + "string"},
      {xsd + "integer", xsd + "pattern", "[0-9]*", xsd + "string"},
      {xsd + "decimal", xsd + "fractionDigits", "2", xsd + "integer"},
      {xsd + "string", xsd + "minInclusive", "a", xsd + "string"},
      {xsd + "string", xsd + "length", "-1", xsd + "integer"},
      {xsd + "string", rdf + "langRange", "en", xsd + "string"},
      {xsd + "boolean", xsd + "pattern", "t.*", xsd + "string"},
      {xsd + "dateTime", xsd + "minInclusive", "1", xsd + "integer"},
      {"http://www.w3.org/2000/01/rdf-schema#Literal", xsd + "minInclusive", "1", xsd + "integer"},
  };
  for (const Facet& one : foreign) {
    Said said;
    said.restriction(one.base, one.facet, one.lexical, one.datatype);
    EXPECT_THAT(said.left_out(), ElementsAre(std::string(foreign_facet) + " 1 line 7")) << one.base << ' ' << one.facet;
    EXPECT_EQ(said.source.axiom_count(), 0U);
    EXPECT_EQ(said.source.ill_typed_count(), 1U);
  }
}

TEST(Facets, WithAValueOutOfItsLexicalSpaceAreIllTyped) {
  Said said;
  said.restriction(xsd + "integer", xsd + "minInclusive", "one", xsd + "integer");
  EXPECT_THAT(said.left_out(), ElementsAre(std::string(ill_typed_literal) + " 1 line 7"));
}

TEST(LenientReading, TakesABoundOfAnotherNumericDatatypeAsTheNumber) {
  Said said(true);
  said.restriction(xsd + "double", xsd + "maxInclusive", "1", xsd + "integer");
  said.restriction(xsd + "float", xsd + "minExclusive", "1.5", xsd + "integer");
  said.restriction(xsd + "integer", xsd + "maxInclusive", "7", xsd + "string");
  EXPECT_THAT(said.axioms(),
              ElementsAre("double[<= \"1\"^^double]", "float[> \"1.5\"^^float]", "integer[<= \"7\"^^integer]"));
  EXPECT_THAT(said.left_out(), IsEmpty());
  EXPECT_THAT(said.remarks(), ElementsAre(std::string(read_as_number) + " 3 line 7"));
}

TEST(LenientReading, TakesALiteralThatIsADecimalAsTheNumber) {
  Said said(true);
  said.range(said.source.term(TermKind::data_one_of,
                              {said.source.literal("5.0", xsd + "integer"), said.source.literal("3.", xsd + "byte")}));
  EXPECT_THAT(said.axioms(), ElementsAre("{\"5.0\"^^decimal, \"3.\"^^decimal}"));
  EXPECT_THAT(said.remarks(), ElementsAre(std::string(read_as_number) + " 1 line 7"));
}

TEST(LenientReading, LeavesOutANumberThatItsDatatypeDoesNotHave) {
  const std::vector<std::pair<std::string, std::string>> strange{
      {"7.5", "int"}, {"300", "byte"}, {"-1", "nonNegativeInteger"}, {"0.0", "positiveInteger"}};
  for (const auto& [lexical, datatype] : strange) {
    Said said(true);
    said.range(said.source.term(TermKind::data_one_of, {said.source.literal(lexical, xsd + datatype)}));
    EXPECT_THAT(said.left_out(), ElementsAre(std::string(ill_typed_literal) + " 1 line 7")) << lexical;
    EXPECT_THAT(said.remarks(), IsEmpty());
    Said bound(true);
    bound.restriction(xsd + datatype, xsd + "minInclusive", lexical, xsd + datatype);
    EXPECT_THAT(bound.left_out(), ElementsAre(std::string(ill_typed_literal) + " 1 line 7")) << lexical;
  }
}

TEST(LenientReading, LeavesOutWhatIsNoNumber) {
  Said said(true);
  said.restriction(xsd + "double", xsd + "maxInclusive", "one", xsd + "string");
  said.restriction(xsd + "integer", xsd + "pattern", "[0-9]", xsd + "string");
  said.range(said.source.term(TermKind::data_one_of, {said.source.literal("twelve", xsd + "integer")}));
  EXPECT_EQ(said.source.axiom_count(), 0U);
  EXPECT_THAT(said.remarks(), IsEmpty());
  said.restriction(xsd + "double", xsd + "maxInclusive", "1", xsd + "double");
  EXPECT_THAT(said.remarks(), IsEmpty()) << "what is right is not read otherwise";
}

}  // namespace
}  // namespace geminga::owl
