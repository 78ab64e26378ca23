// The challenges of each kind of axiom. Those of classes and object properties need no nominals, so that every engine
// can answer.
//
// Legend: C D E class expressions, r s object properties, U V W data properties, D E data ranges, a b individuals, N M
// classes of no other axiom, G the class that a challenge asks about, C < D "C SubClassOf D", T owl:Thing, F
// owl:Nothing. A challenge "in C and not in D" is G < C and (G and D) < F.
#include "reasoning/reasoner/challenge.hpp"

#include <span>
#include <string_view>
#include <utility>

namespace geminga::reasoner {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

namespace {

constexpr std::string_view rdfs_literal = "http://www.w3.org/2000/01/rdf-schema#Literal";

}  // namespace

Challenger::Challenger(Excerpt& excerpt) : excerpt_(excerpt), any_value_(excerpt.source.datatype(rdfs_literal)) {}

Refutation Challenger::refute(AxiomKind kind, const Terms& terms) {
  Refutation result;
  if (kind == AxiomKind::dl_safe_rule) {
    // Its body would have to hold of individuals that nothing else is known of.
    result.undecided = "rules follow only where they are stated";
  } else if (kind >= AxiomKind::same_individual) {
    refute_fact(result, kind, terms);
  } else if (kind >= AxiomKind::sub_data_property_of) {
    refute_data_property_axiom(result, kind, terms);
  } else if (kind >= AxiomKind::sub_object_property_of) {
    refute_object_property_axiom(result, kind, terms);
  } else {
    refute_class_axiom(result, kind, terms);
  }
  return result;
}

Refutation Challenger::refute_emptiness_everywhere(TermId expression) {
  Refutation result;
  Challenge& none = result.all.emplace_back();
  none.statements.push_back({AxiomKind::sub_class_of, {expression, owl::nothing_term}});
  none.first_axiom = none.last_axiom = next();
  return result;
}

Challenge Challenger::challenge(const Terms& in, const Terms& not_in, std::size_t first) {
  Challenge result;
  result.of = excerpt_.fresh(TermKind::named_class);
  for (const TermId above : in) excerpt_.add({AxiomKind::sub_class_of, {*result.of, above}});
  for (const TermId apart : not_in) excerpt_.add({AxiomKind::disjoint_classes, {*result.of, apart}});
  result.first_axiom = first;
  result.last_axiom = next();
  return result;
}

TermId Challenger::some(TermId property, TermId filler) {
  return excerpt_.source.term(TermKind::object_some_values_from, {property, filler});
}

TermId Challenger::inverse(TermId property) {
  if (excerpt_.source.kind(property) == TermKind::object_inverse_of)
    return excerpt_.source.term(property).arguments.front();
  return excerpt_.source.term(TermKind::object_inverse_of, {property});
}

bool Challenger::is_named(TermId property, std::string_view iri) const {
  const owl::Term term = excerpt_.source.term(property);
  return term.kind == TermKind::object_inverse_of ? excerpt_.source.name_of(term.arguments.front()) == iri
                                                  : excerpt_.source.name(term.name) == iri;
}

void Challenger::for_pairs(Refutation& into, const Terms& members, const std::function<void(TermId, TermId)>& use) {
  if (members.size() * (members.size() - 1) / 2 > max_pairs_of_members) {
    into.undecided = "an axiom of " + std::to_string(members.size()) + " members has too many pairs";
    return;
  }
  for (std::size_t first = 0; first < members.size(); ++first) {
    for (std::size_t second = first + 1; second < members.size(); ++second) use(members[first], members[second]);
  }
}

/// C or D < E holds if C < E and D < E do. Each of these is easier.
void Challenger::subsume(Refutation& into, TermId sub, TermId super) {
  const owl::Term term = excerpt_.source.term(sub);
  if (term.kind != TermKind::object_union_of) {
    into.all.push_back(challenge({sub}, {super}));
    return;
  }
  const Terms parts(term.arguments.begin(), term.arguments.end());
  for (const TermId part : parts) into.all.push_back(challenge({part}, {super}));
}

void Challenger::refute_class_axiom(Refutation& into, AxiomKind kind, const Terms& terms) {
  const auto keep_apart = [&](const Terms& members) {
    for_pairs(into, members, [&](TermId a, TermId b) { into.all.push_back(challenge({a, b})); });
  };
  if (kind == AxiomKind::sub_class_of) {
    subsume(into, terms[0], terms[1]);
  } else if (kind == AxiomKind::equivalent_classes) {
    for (std::size_t at = 0; at < terms.size(); ++at) subsume(into, terms[at], terms[(at + 1) % terms.size()]);
  } else if (kind == AxiomKind::disjoint_classes) {
    keep_apart(terms);
  } else if (kind == AxiomKind::disjoint_union) {
    const Terms parts(terms.begin() + 1, terms.end());
    const TermId whole = excerpt_.source.term(TermKind::object_union_of, parts);
    subsume(into, terms[0], whole);
    subsume(into, whole, terms[0]);
    keep_apart(parts);
  }
}

/// r1 o ... o rn < s: for any N, what is in (r1 some ... (rn some N)) is in (s some N).
void Challenger::include(Refutation& into, const Terms& chain, TermId super) {
  if (is_named(super, owl::owl_top_object_property)) return;
  TermId reached = excerpt_.fresh(TermKind::named_class);
  const TermId target = reached;
  for (auto step = chain.rbegin(); step != chain.rend(); ++step) {
    if (is_named(*step, owl::owl_bottom_object_property)) return;
    reached = some(*step, reached);
  }
  into.all.push_back(challenge({reached}, {some(super, target)}));
}

/// Disjoint(r s): nothing is in (t some T), where t < r and t < s. Asymmetric(r) is Disjoint(r r-).
void Challenger::share_pair(Refutation& into, TermId first, TermId second) {
  const std::size_t begin = next();
  const TermId shared = excerpt_.fresh(TermKind::object_property);
  excerpt_.add({AxiomKind::sub_object_property_of, {shared, first}});
  excerpt_.add({AxiomKind::sub_object_property_of, {shared, second}});
  into.all.push_back(challenge({some(shared, owl::thing_term)}, {}, begin));
}

/// Range(r C): nothing is in (r some N), where N and C < F.
void Challenger::reach_outside(Refutation& into, TermId property, TermId range) {
  const std::size_t begin = next();
  const TermId outside = excerpt_.fresh(TermKind::named_class);
  excerpt_.add({AxiomKind::disjoint_classes, {outside, range}});
  into.all.push_back(challenge({some(property, outside)}, {}, begin));
}

/// Functional(r): nothing is in (r some N) and (r some M), where N and M < F.
void Challenger::reach_two(Refutation& into, TermId property) {
  const std::size_t begin = next();
  const TermId one = excerpt_.fresh(TermKind::named_class);
  const TermId other = excerpt_.fresh(TermKind::named_class);
  excerpt_.add({AxiomKind::disjoint_classes, {one, other}});
  into.all.push_back(challenge({some(property, one), some(property, other)}, {}, begin));
}

/// Irreflexive(r): nothing is in (s Self), where s < r. The new property s is simple, as Self requires.
void Challenger::reach_itself(Refutation& into, TermId property) {
  const std::size_t begin = next();
  const TermId below = excerpt_.fresh(TermKind::object_property);
  excerpt_.add({AxiomKind::sub_object_property_of, {below, property}});
  into.all.push_back(challenge({excerpt_.source.term(TermKind::object_has_self, {below})}, {}, begin));
}

void Challenger::refute_object_property_axiom(Refutation& into, AxiomKind kind, const Terms& terms) {
  const TermId property = terms[0];
  switch (kind) {
    case AxiomKind::sub_object_property_of: {
      const owl::Term sub = excerpt_.source.term(property);
      const bool is_chain = sub.kind == TermKind::object_property_chain;
      return include(into, is_chain ? Terms(sub.arguments.begin(), sub.arguments.end()) : Terms{property}, terms[1]);
    }
    case AxiomKind::equivalent_object_properties:
      for (std::size_t at = 0; at < terms.size(); ++at) include(into, {terms[at]}, terms[(at + 1) % terms.size()]);
      return;
    case AxiomKind::disjoint_object_properties:
      return for_pairs(into, terms, [&](TermId a, TermId b) { share_pair(into, a, b); });
    case AxiomKind::inverse_object_properties:
      include(into, {property}, inverse(terms[1]));
      return include(into, {inverse(terms[1])}, property);
    case AxiomKind::object_property_domain:
      into.all.push_back(challenge({some(property, owl::thing_term)}, {terms[1]}));
      return;
    case AxiomKind::object_property_range:
      return reach_outside(into, property, terms[1]);
    case AxiomKind::functional_object_property:
      return reach_two(into, property);
    case AxiomKind::inverse_functional_object_property:
      return reach_two(into, inverse(property));
    case AxiomKind::reflexive_object_property: {
      const TermId any = excerpt_.fresh(TermKind::named_class);
      into.all.push_back(challenge({any}, {some(property, any)}));
      return;
    }
    case AxiomKind::irreflexive_object_property:
      return reach_itself(into, property);
    case AxiomKind::symmetric_object_property:
      return include(into, {property}, inverse(property));
    case AxiomKind::asymmetric_object_property:
      return share_pair(into, property, inverse(property));
    case AxiomKind::transitive_object_property:
      return include(into, {property, property}, property);
    default:
      return;
  }
}

// Axioms about data properties, datatypes, keys and facts.

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
  // A rule holds for named individuals only, and whether it holds for others is not asked.
  for (std::size_t axiom = 0; axiom < source.axiom_count(); ++axiom) {
    if (source.axiom(axiom).kind == AxiomKind::dl_safe_rule) into.undecided = "keys are not refuted beside rules";
  }
  if (!into.undecided.empty()) return;
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
