// Random ontologies of every kind of axiom, mapped to triples, written in each syntax, and read again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/reading.hpp"
#include "support/random_ontology.hpp"
#include "support/rounds.hpp"

namespace geminga::graph {
namespace {

constexpr std::pair<Format, const char*> formats[] = {
    {Format::turtle, "t.ttl"}, {Format::rdf_xml, "t.owl"}, {Format::n_triples, "t.nt"}};

/// In any order, with n classes that mean the same as n - 1 pairs, as triples say it.
std::vector<std::string> sorted_axioms(const owl::Ontology& source) {
  owl::Ontology pairs;
  const owl::FileId file = pairs.add_file("");
  for (std::size_t number = 0; number < source.axiom_count(); ++number) {
    const owl::Axiom axiom = source.axiom(number);
    std::vector<owl::TermId> arguments;
    for (const owl::TermId id : axiom.arguments) arguments.push_back(pairs.copy(source, id));
    const bool is_chained = axiom.kind == owl::AxiomKind::equivalent_classes ||
                            axiom.kind == owl::AxiomKind::equivalent_object_properties ||
                            axiom.kind == owl::AxiomKind::equivalent_data_properties ||
                            axiom.kind == owl::AxiomKind::same_individual;
    for (std::size_t at = 0; is_chained && at + 1 < arguments.size(); ++at)
      pairs.add(axiom.kind, {arguments[at], arguments[at + 1]}, file, 0);
    if (!is_chained) pairs.add(axiom.kind, arguments, file, 0);
  }
  std::vector<std::string> lines = rdf::functional(pairs);
  std::ranges::sort(lines);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

void declare_all(owl::Ontology& source) {
  const owl::FileId file{0};
  for (std::uint32_t number = 0; number < source.term_count(); ++number) {
    const owl::TermKind kind = source.kind(owl::TermId{number});
    const bool is_of_owl =
        kind <= owl::TermKind::individual && (source.name_of(owl::TermId{number}).starts_with("http://www.w3.org/"));
    if (kind <= owl::TermKind::individual && !is_of_owl)
      source.add(owl::AxiomKind::declaration, {owl::TermId{number}}, file, 0);
  }
}

TEST(RoundTrip, OfAxiomsThroughTriplesGivesTheSameAxioms) {
  for (const compare::Profile profile : compare::profiles) {
    for (std::uint64_t seed = 1; seed <= test::rounds(15U); ++seed) {
      owl::Ontology source = compare::random_ontology(profile, seed, 40);
      declare_all(source);
      Graph graph;
      AxiomTriples triples(source, [&](const Node& s, const Node& p, const Node& o) { graph.add(s, p, o); });
      for (std::size_t number = 0; number < source.axiom_count(); ++number) triples.add(source.axiom(number));
      ASSERT_EQ(graph.problem().value_or(""), "");
      graph.sort();
      for (const auto& [format, name] : formats) {
        const auto text = graph.write(format, {{"r", "http://random.example/"}});
        ASSERT_TRUE(text) << text.error();
        const auto loaded = rdf::load_text(name, *text);
        ASSERT_TRUE(loaded) << name << ' ' << syntax::to_string(loaded.error()) << '\n' << *text;
        ASSERT_EQ(sorted_axioms(loaded->source), sorted_axioms(source))
            << compare::to_string(profile) << ' ' << seed << ' ' << name << '\n'
            << *text;
      }
    }
  }
}

TEST(RoundTrip, OfInverseAxiomsKeepsWhatTheySayOfInverses) {
  owl::Ontology source;
  const owl::FileId file = source.add_file("");
  const owl::TermId p = source.object_property("http://e/p");
  const owl::TermId q = source.object_property("http://e/q");
  const owl::TermId of_p = source.term(owl::TermKind::object_inverse_of, {p});
  const owl::TermId of_q = source.term(owl::TermKind::object_inverse_of, {q});
  const auto axiom = [&](owl::TermId one, owl::TermId other) {
    source.add(owl::AxiomKind::inverse_object_properties, {one, other}, file, 0);
  };
  axiom(of_p, q);
  axiom(q, of_p);
  axiom(of_p, p);
  axiom(of_p, of_q);
  Graph graph;
  AxiomTriples triples(source, [&](const Node& subject, const Node& predicate, const Node& object) {
    graph.add(subject, predicate, object);
  });
  for (std::size_t number = 0; number < source.axiom_count(); ++number) triples.add(source.axiom(number));
  graph.sort();
  for (const auto& [format, name] : formats) {
    const auto text = graph.write(format, {});
    ASSERT_TRUE(text) << text.error();
    const auto loaded = rdf::load_text(name, *text);
    ASSERT_TRUE(loaded) << name;
    EXPECT_EQ(loaded->source.omissions().size(), 0U) << *text;
    EXPECT_THAT(
        sorted_axioms(loaded->source),
        testing::IsSupersetOf({"InverseObjectProperties(:p :q)", "InverseObjectProperties(:p ObjectInverseOf(:p))",
                               "InverseObjectProperties(:q ObjectInverseOf(:p))"}))
        << *text;
  }
}

}  // namespace
}  // namespace geminga::graph
