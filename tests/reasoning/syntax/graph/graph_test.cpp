// A graph is a set of triples, filled from files as they stand there, and the same whatever their order.
#include "reasoning/syntax/graph/graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"

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
                                                  "<!DOCTYPE rdf:RDF [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>"
                                                  "<rdf:RDF xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'>"
                                                  "&x;</rdf:RDF>"),
                                    0);
  ASSERT_TRUE(error);
  EXPECT_THAT(syntax::to_string(*error), HasSubstr("a.owl:1: "));
}

TEST(Graph, WritesNumbersInTurtleThatKeepTheirDatatypes) {
  const std::string xsd = "http://www.w3.org/2001/XMLSchema#";
  const auto written = [&](const std::string& text, const std::string& datatype) {
    Graph graph;
    graph.add(iri(a), iri(b), {Node::Kind::literal, text, xsd + datatype, {}});
    graph.sort();
    const auto turtle = graph.write(Format::turtle, {});
    if (!turtle) return turtle.error();
    const rdf::Scratch scratch;
    Graph again;
    if (const auto error = again.add_file(scratch.write("a.ttl", *turtle), 0)) return syntax::to_string(*error);
    std::string line = n_triples(again);
    return line.substr(26, line.size() - 29);
  };
  EXPECT_EQ(written("1", "decimal"), "\"1.0\"^^<" + xsd + "decimal>");
  EXPECT_EQ(written("-.5", "decimal"), "\"-0.5\"^^<" + xsd + "decimal>");
  EXPECT_EQ(written("1", "double"), "\"1.0e0\"^^<" + xsd + "double>");
  EXPECT_EQ(written("1.5E3", "double"), "\"1.5e3\"^^<" + xsd + "double>");
  EXPECT_EQ(written("1", "boolean"), "\"true\"^^<" + xsd + "boolean>");
  EXPECT_EQ(written("7", "integer"), "\"7\"^^<" + xsd + "integer>");
  EXPECT_EQ(written("1.5", "float"), "\"1.5\"^^<" + xsd + "float>");
  EXPECT_EQ(written("INF", "double"), "\"INF\"^^<" + xsd + "double>");
  EXPECT_EQ(written("x", "integer"), "\"x\"^^<" + xsd + "integer>") << "what is damaged stays as it is";
  EXPECT_EQ(written("a-geminga-in-quotes", "string"), "\"a-geminga-in-quotes\"^^<" + xsd + "string>");
  EXPECT_THAT(written("a-geminga-in-quotes", "boolean"), HasSubstr("write --to rdfxml or ntriples"));
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
