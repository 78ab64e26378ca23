// Axioms about data properties, datatypes, keys and facts.
//
// Legend: U V W data properties, D E data ranges, a b individuals, r an object property, C a class expression, G the
// class that a challenge asks about, T owl:Thing, F owl:Nothing; see challenge.cpp.
#include <span>
#include <string_view>
#include <utility>

#include "reasoning/reasoner/challenge.hpp"

namespace geminga::reasoner {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

void Challenger::refute_data_property_axiom(Refutation& into, AxiomKind kind, const Terms& terms) {
  owl::Ontology& source = excerpt_.source;
  switch (kind) {
    case AxiomKind::sub_data_property_of:
      include_data(into, terms[0], terms[1]);
      break;
    case AxiomKind::equivalent_data_properties:
      for (std::size_t at = 0; at < terms.size(); ++at) include_data(into, terms[at], terms[(at + 1) % terms.size()]);
      break;
    case AxiomKind::disjoint_data_properties:
      for_pairs(into, terms, [&](TermId a, TermId b) { share_value(into, a, b); });
      break;
    case AxiomKind::data_property_domain:
      into.all.push_back(challenge({source.term(TermKind::data_some_values_from, {terms[0], any_value_})}, {terms[1]}));
      break;
    case AxiomKind::data_property_range: {
      const TermId outside = source.term(TermKind::data_complement_of, {terms[1]});
      into.all.push_back(challenge({source.term(TermKind::data_some_values_from, {terms[0], outside})}));
      break;
    }
    case AxiomKind::functional_data_property:
      into.all.push_back(challenge({source.term(TermKind::data_min_cardinality, {terms[0]}, 2)}));
      break;
    case AxiomKind::datatype_definition:
      define_datatype(into, terms[0], terms[1]);
      break;
    case AxiomKind::has_key:
      identify_by_key(into, terms);
      break;
    default:
      break;
  }
}

/// U < V: nothing is in (W some Literal), where W < U and Disjoint(W V).
void Challenger::include_data(Refutation& into, TermId sub, TermId super) {
  const std::size_t begin = next();
  const TermId only_sub = excerpt_.fresh(TermKind::data_property);
  excerpt_.add({AxiomKind::sub_data_property_of, {only_sub, sub}});
  excerpt_.add({AxiomKind::disjoint_data_properties, {only_sub, super}});
  into.all.push_back(
      challenge({excerpt_.source.term(TermKind::data_some_values_from, {only_sub, any_value_})}, {}, begin));
}

/// Disjoint(U V): nothing is in (W some Literal), where W < U and W < V.
void Challenger::share_value(Refutation& into, TermId first, TermId second) {
  const std::size_t begin = next();
  const TermId shared = excerpt_.fresh(TermKind::data_property);
  excerpt_.add({AxiomKind::sub_data_property_of, {shared, first}});
  excerpt_.add({AxiomKind::sub_data_property_of, {shared, second}});
  into.all.push_back(
      challenge({excerpt_.source.term(TermKind::data_some_values_from, {shared, any_value_})}, {}, begin));
}

/// D = E: nothing is in (U some (D and not E)) or in (U some (E and not D)), for a new U.
void Challenger::define_datatype(Refutation& into, TermId datatype, TermId range) {
  owl::Ontology& source = excerpt_.source;
  const TermId property = excerpt_.fresh(TermKind::data_property);
  const auto differ = [&](TermId in, TermId not_in) {
    const TermId outside = source.term(TermKind::data_complement_of, {not_in});
    const TermId between = source.term(TermKind::data_intersection_of, {in, outside});
    into.all.push_back(challenge({source.term(TermKind::data_some_values_from, {property, between})}));
  };
  differ(datatype, range);
  differ(range, datatype);
}

/// Two named individuals that agree on the values of a key and differ. No axiom can leave open which values these are,
/// so data properties only give witnesses.
void Challenger::identify_by_key(Refutation& into, const Terms& terms) {
  owl::Ontology& source = excerpt_.source;
  const TermId one = excerpt_.fresh(TermKind::individual);
  const TermId other = excerpt_.fresh(TermKind::individual);
  Challenge pair;
  pair.statements = {{AxiomKind::class_assertion, {terms[0], one}},
                     {AxiomKind::class_assertion, {terms[0], other}},
                     {AxiomKind::different_individuals, {one, other}}};
  Terms data;
  for (const TermId property : std::span(terms).subspan(1)) {
    if (source.kind(property) == TermKind::data_property) {
      data.push_back(property);
      continue;
    }
    const TermId shared = excerpt_.fresh(TermKind::individual);
    pair.statements.push_back({AxiomKind::object_property_assertion, {property, one, shared}});
    pair.statements.push_back({AxiomKind::object_property_assertion, {property, other, shared}});
  }
  pair.first_axiom = pair.last_axiom = next();
  if (data.empty()) {
    into.all.push_back(std::move(pair));
    return;
  }
  into.undecided = "keys of data properties are only refuted by trying values";
  const std::string_view xsd = "http://www.w3.org/2001/XMLSchema#";
  for (const auto& [lexical, type] : {std::pair{"geminga", "string"}, {"982451653", "integer"}, {"true", "boolean"}}) {
    const TermId value = source.literal(lexical, std::string(xsd) + type);
    Challenge tried = pair;
    for (const TermId property : data) {
      tried.statements.push_back({AxiomKind::data_property_assertion, {property, one, value}});
      tried.statements.push_back({AxiomKind::data_property_assertion, {property, other, value}});
    }
    into.witnesses.push_back(std::move(tried));
  }
}

TermId Challenger::one_of(TermId individual) { return excerpt_.source.term(TermKind::object_one_of, {individual}); }

/// C(a): nothing is in {a} and not in C. r(a b): nothing is in {a} and not in (r value b). a = b: nothing is in {a} and
/// not in {b}. For a negative fact it is the reverse.
void Challenger::refute_fact(Refutation& into, AxiomKind kind, const Terms& terms) {
  owl::Ontology& source = excerpt_.source;
  const auto value = [&] {
    const bool is_data = source.kind(terms[0]) == TermKind::data_property;
    return source.term(is_data ? TermKind::data_has_value : TermKind::object_has_value, {terms[0], terms[2]});
  };
  switch (kind) {
    case AxiomKind::same_individual:
      for (std::size_t at = 1; at < terms.size(); ++at)
        into.all.push_back(challenge({one_of(terms[0])}, {one_of(terms[at])}));
      break;
    case AxiomKind::different_individuals:
      for_pairs(into, terms, [&](TermId a, TermId b) { into.all.push_back(challenge({one_of(a), one_of(b)})); });
      break;
    case AxiomKind::class_assertion:
      into.all.push_back(challenge({one_of(terms[1])}, {terms[0]}));
      break;
    case AxiomKind::object_property_assertion:
    case AxiomKind::data_property_assertion:
      into.all.push_back(challenge({one_of(terms[1])}, {value()}));
      break;
    case AxiomKind::negative_object_property_assertion:
    case AxiomKind::negative_data_property_assertion:
      into.all.push_back(challenge({one_of(terms[1]), value()}));
      break;
    default:
      break;
  }
}

}  // namespace geminga::reasoner
