// A graph is a set of triples, filled from files as they stand there, and the same whatever their order.
#include "reasoning/syntax/graph/graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::graph {
namespace {

using testing::HasSubstr;

const std::string a = "http://e/a";
const std::string b = "http://e/b";

std::string n_triples(Graph& graph) {
  graph.sort();
  return graph.write(Format::n_triples, {}).value_or("not written");
}

TEST(Graph, HoldsEachTripleOnceInAnOrderOfItsOwn) {
  Graph one;
  one.add(iri(a), iri(rdfs_label), {Node::Kind::literal, "x\"\n", {}, "en"});
  one.add(iri(a), iri(rdfs_sub_class_of), iri(b));
  one.add(iri(a), iri(rdfs_sub_class_of), iri(b));
  Graph other;
  other.add(iri(a), iri(rdfs_sub_class_of), iri(b));
  other.add(iri(a), iri(rdfs_label), {Node::Kind::literal, "x\"\n", {}, "en"});
  EXPECT_EQ(n_triples(one), n_triples(other));
  EXPECT_EQ(one.size(), 2U);
  EXPECT_EQ(n_triples(one),
            "<http://e/a> <http://www.w3.org/2000/01/rdf-schema#label> \"x\\\"\\n\"@en .\n"
            "<http://e/a> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <http://e/b> .\n");
}

TEST(Graph, TakesOutWhatAnotherHas) {
  Graph all;
  all.add(iri(a), iri(rdf_type), iri(b));
  all.add(iri(b), iri(rdf_type), iri(a));
  Graph known;
  known.add(iri(a), iri(rdf_type), iri(b));
  all.sort();
  known.sort();
  all.remove(known);
  EXPECT_EQ(n_triples(all), "<http://e/b> <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> <http://e/a> .\n");
}

TEST(Graph, ReadsFilesWithTheirCommentsAndKeepsTheirBlankNodesApart) {
  const rdf::Scratch scratch;
  const std::string first = scratch.write("a.ttl", "_:x <http://e/p> [] . <http://e/a> <http://e/p> \"x\" .");
  const std::string second = scratch.write("b.nt", "_:x <http://e/p> <http://e/a> .\n");
  Graph graph;
  ASSERT_FALSE(graph.add_file(first, 0));
  ASSERT_FALSE(graph.add_file(second, 1));
  EXPECT_EQ(n_triples(graph),
            "<http://e/a> <http://e/p> \"x\" .\n_:f0ux <http://e/p> _:f0g1 .\n_:f1ux <http://e/p> <http://e/a> .\n");
}

TEST(Graph, PassesOverWhatItsFilterDoesNotKeep) {
  const rdf::Scratch scratch;
  Graph graph;
  graph.set_filter([](const Node&, std::string_view predicate, const Node&) { return predicate != "http://e/p"; });
  ASSERT_FALSE(graph.add_file(scratch.write("a.ttl", "<http://e/a> <http://e/p> 1 ; <http://e/q> 2 ."), 0));
  graph.add(iri(a), iri("http://e/p"), iri(b));
  EXPECT_EQ(graph.size(), 1U);
}

TEST(Graph, RefusesTriplesBeyondItsLimit) {
  for (const std::size_t count : {2U, 3U, 4U}) {
    Graph graph({.triples = 3});
    for (std::size_t at = 0; at < count; ++at) graph.add(iri(a), iri("http://e/p" + std::to_string(at)), iri(b));
    EXPECT_EQ(graph.problem().value_or(""), count <= 3 ? "" : "more than 3 triples in all: give fewer files");
  }
}

TEST(Graph, RefusesAFileThatIsBrokenOrHostileAsTheLoaderDoes) {
  const rdf::Scratch scratch;
  Graph graph;
  const auto error = graph.add_file(scratch.write("a.owl",
                                                  "<!DOCTYPE rdf:RDF [<!ENTITY % x '<!ENTITY y \"z\">'> %x;]>"
                                                  "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'>"
                                                  "&y;</rdf:RDF>"),
                                    0);
  ASSERT_TRUE(error);
  EXPECT_THAT(syntax::to_string(*error), HasSubstr("a.owl:1: "));
}

/// Writes a graph, reads it again, and returns that as N-Triples; or why that is impossible.
std::string read_again(const std::string& triples, Format format, std::string* text = nullptr) {
  const rdf::Scratch scratch;
  Graph graph;
  if (const auto error = graph.add_file(scratch.write("a.ttl", triples), 0)) return syntax::to_string(*error);
  graph.sort();
  const auto written = graph.write(format, {{"", "http://e/"}, {"rdf", std::string(syntax::rdf_namespace)}});
  if (!written) return written.error();
  if (text != nullptr) *text = *written;
  const std::string name = format == Format::turtle ? "b.ttl" : format == Format::rdf_xml ? "b.rdf" : "b.nt";
  const std::string file = scratch.write(name, *written);
  const auto loaded = rdf::load(std::span(&file, 1));
  if (!loaded) return syntax::to_string(loaded.error());
  Graph again;
  if (const auto error = again.add_file(file, 0)) return syntax::to_string(*error);
  return n_triples(again);
}

TEST(Graph, WritesNumbersInTurtleAsTheyStand) {
  const std::string xsd = "http://www.w3.org/2001/XMLSchema#";
  const auto written = [&](const std::string& words, const std::string& datatype, std::string* text = nullptr) {
    const std::string literal = '"' + words + "\"^^<" + xsd + datatype + '>';
    const std::string line = "<http://e/a> <http://e/b> " + literal + " .\n";
    return read_again(line, Format::turtle, text) == line;
  };
  const std::pair<std::string, std::string> numbers[] = {
      {"1", "decimal"},  {"-.5", "decimal"},  {"5.", "decimal"}, {"1", "double"},    {"1.5E3", "double"},
      {"1", "boolean"},  {"true", "boolean"}, {"07", "integer"}, {"+7", "integer"},  {"1.5", "float"},
      {"INF", "double"}, {"x", "integer"},    {" 7", "integer"}, {"1.5", "integer"}, {"1.50", "decimal"}};
  for (const auto& [words, datatype] : numbers) EXPECT_TRUE(written(words, datatype)) << words << ' ' << datatype;
  std::string text;
  EXPECT_TRUE(written("-1.5e3", "double", &text));
  EXPECT_THAT(text, HasSubstr(":a\n    :b -1.5e3 .\n"));
}

TEST(Graph, WritesBlankNodesInPlaceInListsOrByLabelsAndLosesNone) {
  const std::string rdf = "@prefix rdf: <" + std::string(syntax::rdf_namespace) + "> . ";
  std::string long_list = ":a :b (";
  for (std::size_t at = 0; at < 2000; ++at) long_list += " :m" + std::to_string(at);
  std::string deep = ":a :b ";
  for (std::size_t at = 0; at < 400; ++at) deep += "[ :p ";
  deep += '1';
  for (std::size_t at = 0; at < 400; ++at) deep += " ]";
  const std::string graphs[] = {
      "_:x :p _:y . _:y :p _:x ; :q 1 .",                                      // a cycle
      "_:x :p _:x .",                                                          // a cycle of one
      "_:x :p _:y . _:y :p _:x ; :q [ :r [] ] .",                              // a cycle with more below
      ":a :p _:l . :b :q _:l . _:l rdf:first :c ; rdf:rest ( :d ) .",          // a list of two references
      ":a :p [ rdf:first :c ; rdf:rest [ rdf:first :d ] ] .",                  // a list without an end
      ":a :p [ rdf:first :c ; rdf:rest () ; rdf:rest ( :d ) ] .",              // of two ends
      ":a :p [ a rdf:List ; rdf:first :c ; rdf:rest () ] .",                   // with a type
      ":a :p ( 1 [ :q ( ( :b ) [] ) ] \"x\" () ), () .",                       // lists in lists
      "() :p :a . ( :a ) :p :b . [ :q :r ] :s 1 . [] :p :q .",                 // as subjects
      ":a :p \"a\\\"\\\\b\\nc\\td\\re <&>\"@en, \"x\"^^:t, \" \", \"]]>\" .",  // texts
      long_list + ") .",
      deep + " .",
  };
  for (const std::string& graph : graphs) {
    const std::string triples = "@prefix : <http://e/> . " + rdf + graph;
    std::string lines = read_again(triples, Format::n_triples);
    for (const Format format : {Format::turtle, Format::rdf_xml}) {
      std::string text;
      const std::string again = read_again(triples, format, &text);
      const auto count = [](const std::string& in) { return std::ranges::count(in, '\n'); };
      ASSERT_EQ(count(again), count(lines)) << graph.substr(0, 200) << '\n'
                                            << text.substr(0, 2000) << again.substr(0, 300);
      EXPECT_LT(text.size(), 20 * lines.size()) << "indentation grows with depth only up to a limit";
      if (!lines.contains("_:")) {
        EXPECT_EQ(again, lines) << text;
      }
    }
  }
}

std::string problem_of(const Graph& graph, Format format) {
  const auto text = graph.write(format, {});
  return text ? *text : text.error();
}

TEST(Graph, WritesANameInFullThatNoPrefixFitsAndRefusesOneThatCannotBeRead) {
  std::string text;
  const std::string names =
      "<http://e/1a> a <http://e/a.> , <http://e/-a>, <http://e/a%20b>, <http://e/a/b>, <http://e/>, <urn:x:y>, "
      "<http://e/\u00e9> .";
  EXPECT_EQ(read_again(names, Format::turtle, &text), read_again(names, Format::n_triples));
  EXPECT_THAT(text,
              HasSubstr(":1a\n    a <http://e/>, <http://e/-a>, <http://e/a%20b>, <http://e/a.>, <http://e/a/b>"));
  EXPECT_EQ(read_again(names, Format::rdf_xml), read_again(names, Format::n_triples));
  Graph graph;
  graph.add(iri("http://e/a b"), iri("http://e/1"), iri(b));
  graph.sort();
  const std::string refusal =
      "the name http://e/a b has a character that no IRI may have: write --to rdfxml, or mend the name";
  EXPECT_EQ(problem_of(graph, Format::turtle), refusal);
  EXPECT_EQ(problem_of(graph, Format::n_triples), refusal);
  EXPECT_EQ(problem_of(graph, Format::rdf_xml),
            "the property http://e/1 has no name that an XML element can have: write --to turtle or ntriples");
  Graph control;
  control.add(iri(a), iri(b), {Node::Kind::literal, "\x01", {}, {}});
  control.sort();
  EXPECT_THAT(problem_of(control, Format::rdf_xml), HasSubstr("control character 1, which no XML can have"));
  EXPECT_THAT(control.write(Format::turtle, {}).value_or(""), HasSubstr("\\u0001"));
}

TEST(Graph, MakesPrefixesForPropertiesInXmlThatAreNotTaken) {
  const rdf::Scratch scratch;
  Graph graph;
  graph.add(iri(a), iri("http://other/p"), iri(b));
  graph.add(iri(a), iri("http://third#q.1"), {Node::Kind::literal, "x", {}, {}});
  graph.add(iri(a), iri(std::string(syntax::rdf_namespace) + "_1"), iri(b));
  graph.sort();
  const Prefixes prefixes = {{"rdf", "http://e/"}, {"ns1", "http://e/n"}, {"xmlx", "http://third#"}, {"", "http://e/"}};
  const auto text = graph.write(Format::rdf_xml, prefixes);
  ASSERT_TRUE(text) << text.error();
  Graph again;
  ASSERT_FALSE(again.add_file(scratch.write("a.rdf", *text), 0)) << *text;
  EXPECT_EQ(n_triples(again), n_triples(graph)) << *text;
}

TEST(Graph, KnowsItsFormatsByNameAndByTheNamesOfFiles) {
  EXPECT_EQ(find_format("turtle"), Format::turtle);
  EXPECT_EQ(find_format("rdfxml"), Format::rdf_xml);
  EXPECT_EQ(find_format("ntriples"), Format::n_triples);
  EXPECT_EQ(find_format("json"), std::nullopt);
  EXPECT_EQ(format_of_file("a.owl"), Format::rdf_xml);
  EXPECT_EQ(format_of_file("a.ttl"), Format::turtle);
  EXPECT_EQ(format_of_file("a.nt"), Format::n_triples);
  EXPECT_EQ(format_of_file("a.ofn"), std::nullopt);
}

}  // namespace
}  // namespace geminga::graph
