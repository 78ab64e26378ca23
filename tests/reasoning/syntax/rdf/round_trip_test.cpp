// Random ontologies of every kind of axiom and expression, written as triples in any order, come back as they were.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.hpp"
#include "reasoning/syntax/rdf/forward_mapping.hpp"
#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"
#include "reasoning/syntax/vocabulary.hpp"
#include "support/rounds.hpp"

namespace geminga::rdf {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

/// Names are used for a class, an individual and a property at once: punning must not matter.
class Author {
 public:
  Author(std::uint64_t seed, owl::Ontology& source) : random_(seed), source_(source) {}

  void write(std::size_t axioms) {
    const owl::FileId file = source_.add_file("random.nt");
    for (const char* name : {"a", "b", "c"}) {
      for (const TermKind kind : {TermKind::named_class, TermKind::object_property, TermKind::individual})
        source_.add(AxiomKind::declaration, {source_.entity(kind, iri(name))}, file, 1);
    }
    for (const char* name : {"d", "e"})
      source_.add(AxiomKind::declaration, {source_.data_property(iri(name))}, file, 1);
    source_.add(AxiomKind::declaration, {source_.datatype(iri("t"))}, file, 1);
    source_.add(AxiomKind::declaration, {source_.annotation_property(iri("note"))}, file, 1);
    while (source_.axiom_count() < axioms + 13) {
      const auto kind = static_cast<AxiomKind>(
          1 + random_.below(static_cast<std::uint64_t>(AxiomKind::negative_data_property_assertion)));
      source_.add(kind, arguments(kind), file, 1);
    }
  }

 private:
  std::size_t below(std::uint64_t end) { return static_cast<std::size_t>(random_.below(end)); }
  static std::string iri(std::string_view name) { return "http://e/" + std::string(name); }
  std::string any_name() { return iri(std::string(1, static_cast<char>('a' + below(3)))); }

  TermId property() {
    return source_.object_property(below(8) == 0 ? iri_of(syntax::Word::owl_top_object_property) : any_name());
  }
  TermId property_expression() {
    return below(3) == 0 ? source_.term(TermKind::object_inverse_of, {property()}) : property();
  }
  TermId data_property() { return source_.data_property(below(2) == 0 ? iri("d") : iri("e")); }
  TermId individual() { return below(6) == 0 ? source_.anonymous_individual("_:x") : source_.individual(any_name()); }
  TermId literal() {
    switch (below(4)) {
      case 0:
        return source_.literal("text", {}, "en-gb");
      case 1:
        return source_.literal(std::to_string(below(9)), std::string(syntax::xsd_namespace) + "integer");
      case 2:
        return source_.literal("v", iri("t"));
      default:
        return source_.literal("plain", {});
    }
  }

  template <typename Make>
  std::vector<TermId> several(std::size_t least, Make make) {
    std::vector<TermId> terms;
    for (std::size_t count = least + below(3); count > 0; --count) terms.push_back(make());
    return terms;
  }

  TermId data_range(int depth = 0) {
    const auto inner = [&] { return data_range(depth + 1); };
    switch (depth > 2 ? 9 : below(10)) {
      case 0:
        return source_.term(TermKind::data_intersection_of, several(2, inner));
      case 1:
        return source_.term(TermKind::data_union_of, several(2, inner));
      case 2:
        return source_.term(TermKind::data_complement_of, {inner()});
      case 3:
        return source_.term(TermKind::data_one_of, several(1, [&] { return literal(); }));
      case 4: {
        std::vector<TermId> parts{source_.datatype(std::string(syntax::xsd_namespace) + "integer")};
        for (const char* facet : {"minInclusive", "maxExclusive"})
          parts.push_back(source_.facet(std::string(syntax::xsd_namespace) + facet, literal()));
        return source_.term(TermKind::datatype_restriction, parts);
      }
      case 5:
        return source_.datatype(iri_of(syntax::Word::rdfs_literal));
      case 6:
        return source_.datatype(iri("t"));
      default:
        return source_.datatype(std::string(syntax::xsd_namespace) + "string");
    }
  }

  TermId class_expression(int depth = 0) {
    const auto inner = [&] { return class_expression(depth + 1); };
    const auto kind = static_cast<TermKind>(static_cast<std::uint64_t>(TermKind::object_intersection_of) +
                                            below(static_cast<std::uint64_t>(TermKind::data_exact_cardinality) -
                                                  static_cast<std::uint64_t>(TermKind::object_intersection_of) + 1));
    if (depth > 2 || below(3) == 0) return source_.named_class(below(8) == 0 ? owl::owl_thing : any_name());
    switch (kind) {
      case TermKind::object_intersection_of:
      case TermKind::object_union_of:
        return source_.term(kind, several(2, inner));
      case TermKind::object_complement_of:
        return source_.term(kind, {inner()});
      case TermKind::object_one_of:
        return source_.term(kind, several(1, [&] { return individual(); }));
      case TermKind::object_some_values_from:
      case TermKind::object_all_values_from:
        return source_.term(kind, {property_expression(), inner()});
      case TermKind::object_has_value:
        return source_.term(kind, {property_expression(), individual()});
      case TermKind::object_has_self:
        return source_.term(kind, {property_expression()});
      case TermKind::data_some_values_from:
      case TermKind::data_all_values_from:
        return source_.term(kind, {data_property(), data_range()});
      case TermKind::data_has_value:
        return source_.term(kind, {data_property(), literal()});
      default:
        break;
    }
    const bool is_of_data = kind >= TermKind::data_min_cardinality;
    std::vector<TermId> parts{is_of_data ? data_property() : property_expression()};
    if (below(2) == 0) parts.push_back(is_of_data ? data_range() : inner());
    return source_.term(kind, parts, static_cast<std::uint32_t>(below(4)));
  }

  std::vector<TermId> arguments(AxiomKind kind) {
    const auto c = [&] { return class_expression(); };
    const auto p = [&] { return property_expression(); };
    const auto d = [&] { return data_property(); };
    switch (kind) {
      case AxiomKind::sub_class_of:
      case AxiomKind::equivalent_classes:
        return {c(), c()};
      case AxiomKind::disjoint_classes:
        return several(2, c);
      case AxiomKind::disjoint_union: {
        std::vector<TermId> terms = several(2, c);
        terms.insert(terms.begin(), source_.named_class(any_name()));
        return terms;
      }
      case AxiomKind::sub_object_property_of:
        return {below(2) == 0 ? p() : source_.term(TermKind::object_property_chain, several(2, p)), p()};
      case AxiomKind::equivalent_object_properties:
        return {p(), p()};
      case AxiomKind::disjoint_object_properties:
        return several(2, p);
      case AxiomKind::inverse_object_properties:
        return {property(), property()};
      case AxiomKind::object_property_domain:
      case AxiomKind::object_property_range:
        return {p(), c()};
      case AxiomKind::sub_data_property_of:
      case AxiomKind::equivalent_data_properties:
        return {d(), d()};
      case AxiomKind::disjoint_data_properties:
        return several(2, d);
      case AxiomKind::data_property_domain:
        return {d(), c()};
      case AxiomKind::data_property_range:
        return {d(), data_range()};
      case AxiomKind::functional_data_property:
        return {d()};
      case AxiomKind::datatype_definition:
        return {source_.datatype(iri("t")), data_range()};
      case AxiomKind::has_key:
        return {c(), p(), property(), d()};
      case AxiomKind::same_individual:
        return {individual(), individual()};
      case AxiomKind::different_individuals:
        return several(2, [&] { return individual(); });
      case AxiomKind::class_assertion:
        return {c(), individual()};
      case AxiomKind::object_property_assertion:
        return {property(), individual(), individual()};
      case AxiomKind::negative_object_property_assertion:
        return {p(), individual(), individual()};
      case AxiomKind::data_property_assertion:
      case AxiomKind::negative_data_property_assertion:
        return {d(), individual(), literal()};
      default:
        return {p()};  // characteristics of object properties
    }
  }

  base::Random random_;
  owl::Ontology& source_;
};

std::vector<std::string> sorted_axioms(const owl::Ontology& source) {
  std::vector<std::string> axioms = functional(source, true);
  std::ranges::sort(axioms);
  const auto repeated = std::ranges::unique(axioms);
  axioms.erase(repeated.begin(), repeated.end());
  return axioms;
}

TEST(RoundTrip, RandomOntologiesComeBackFromTheirTriplesInAnyOrder) {
  constexpr std::uint64_t seeds = 300;
  const Scratch scratch;
  for (std::uint64_t seed = 1; seed <= test::rounds(seeds); ++seed) {
    owl::Ontology written;
    Author(seed, written).write(60);
    ASSERT_FALSE(written.problem());
    base::Random random(seed);
    std::vector<std::string> triples = triples_of(written, [&](std::size_t) { return random.below(4) == 0; });
    for (std::size_t place = triples.size(); place > 1; --place)
      std::swap(triples[place - 1], triples[random.below(place)]);
    std::string text;
    for (const std::string& line : triples) text += line + '\n';
    const auto loaded = load(std::vector{scratch.write("random.nt", text)});
    ASSERT_TRUE(loaded) << to_string(loaded.error()) << ", seed " << seed;
    ASSERT_EQ(sorted_axioms(loaded->source), sorted_axioms(written)) << "seed " << seed;
    for (const auto& omission : loaded->source.omissions())
      ADD_FAILURE() << loaded->source.name(omission.construct) << ", seed " << seed;
  }
}

}  // namespace
}  // namespace geminga::rdf
