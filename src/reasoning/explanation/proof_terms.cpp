// Terms become the normal form, and text as people write it.
#include "reasoning/explanation/proof_terms.hpp"

#include "base/sorted.hpp"

namespace geminga::explanation {
namespace {

using owl::Term;
using owl::TermId;
using owl::TermKind;

constexpr std::string_view literal_datatype = "http://www.w3.org/2000/01/rdf-schema#Literal";

std::vector<TermId> copied(std::span<const TermId> terms) { return {terms.begin(), terms.end()}; }

}  // namespace

TermId ProofTerms::singleton(TermId individual) {
  return source_.term(source_.kind(individual) == TermKind::literal ? TermKind::data_one_of : TermKind::object_one_of,
                      {individual});
}

TermId ProofTerms::some(TermId role, TermId filler) {
  return source_.term(is_data(role) ? TermKind::data_some_values_from : TermKind::object_some_values_from,
                      {role, filler});
}

TermId ProofTerms::at_least(std::uint32_t count, TermId role, TermId filler) {
  if (count == 0) return owl::thing_term;
  if (count == 1) return some(role, filler);
  return source_.term(is_data(role) ? TermKind::data_min_cardinality : TermKind::object_min_cardinality, {role, filler},
                      count);
}

TermId ProofTerms::at_most(std::uint32_t count, TermId role, TermId filler) {
  return source_.term(is_data(role) ? TermKind::data_max_cardinality : TermKind::object_max_cardinality, {role, filler},
                      count);
}

TermId ProofTerms::inverse(TermId role) {
  const Term term = source_.term(role);
  if (term.kind == TermKind::object_inverse_of) return term.arguments[0];
  return source_.term(TermKind::object_inverse_of, {role});
}

TermId ProofTerms::conjunction(const std::vector<TermId>& parts) {
  std::vector<TermId> flat;
  for (const TermId part : parts) {
    if (part == owl::nothing_term) return part;
    const Term term = source_.term(part);
    if (term.kind == TermKind::object_intersection_of) {
      flat.insert(flat.end(), term.arguments.begin(), term.arguments.end());
    } else if (part != owl::thing_term) {
      flat.push_back(part);
    }
  }
  base::sort_unique(flat);
  if (flat.empty()) return owl::thing_term;
  return flat.size() == 1 ? flat.front() : source_.term(TermKind::object_intersection_of, flat);
}

TermId ProofTerms::restriction(const Term& term) {
  const TermId role = term.arguments[0];
  const std::uint32_t count = term.number;
  const bool is_of_data = is_data(role);
  TermId filler = is_of_data ? source_.datatype(literal_datatype) : owl::thing_term;
  if (term.arguments.size() == 2) filler = normal(term.arguments[1]);
  switch (term.kind) {
    case TermKind::object_min_cardinality:
    case TermKind::data_min_cardinality:
      return at_least(count, role, filler);
    case TermKind::object_max_cardinality:
    case TermKind::data_max_cardinality:
      return at_most(count, role, filler);
    default:
      return conjunction({at_least(count, role, filler), at_most(count, role, filler)});
  }
}

TermId ProofTerms::normal(TermId id) {
  if (const auto known = normal_.find(id); known != normal_.end()) return known->second;
  const TermId made = normalise(id);
  normal_.emplace(id, made);
  return made;
}

TermId ProofTerms::normalise(TermId id) {
  // A copy, because the source grows.
  const Term view = source_.term(id);
  const std::vector<TermId> arguments = copied(view.arguments);
  const Term term{view.kind, view.name, view.number, arguments};
  switch (term.kind) {
    case TermKind::object_has_value:
    case TermKind::data_has_value:
      return some(arguments[0], singleton(arguments[1]));
    case TermKind::object_some_values_from:
    case TermKind::data_some_values_from:
    case TermKind::object_all_values_from:
    case TermKind::data_all_values_from:
      return source_.term(term.kind, {arguments[0], normal(arguments[1])});
    case TermKind::object_min_cardinality:
    case TermKind::object_max_cardinality:
    case TermKind::object_exact_cardinality:
    case TermKind::data_min_cardinality:
    case TermKind::data_max_cardinality:
    case TermKind::data_exact_cardinality:
      return restriction(term);
    case TermKind::object_complement_of: {
      const TermId part = normal(arguments[0]);
      if (part == owl::thing_term) return owl::nothing_term;
      if (part == owl::nothing_term) return owl::thing_term;
      const Term inner = source_.term(part);
      return inner.kind == term.kind ? inner.arguments[0] : source_.term(term.kind, {part});
    }
    case TermKind::object_intersection_of:
    case TermKind::object_union_of: {
      std::vector<TermId> parts;
      for (const TermId part : arguments) parts.push_back(normal(part));
      if (term.kind == TermKind::object_intersection_of) return conjunction(parts);
      base::sort_unique(parts);
      if (parts.empty()) return owl::nothing_term;
      return parts.size() == 1 ? parts.front() : source_.term(term.kind, parts);
    }
    default:
      return id;
  }
}

TermId ProofTerms::as_written(TermId id) {
  if (const auto known = written_.find(id); known != written_.end()) return known->second;
  const TermId written = write(id);
  written_.emplace(id, written);
  return written;
}

TermId ProofTerms::write(TermId id) {
  const Term view = source_.term(id);
  std::vector<TermId> arguments = copied(view.arguments);
  const TermKind kind = view.kind;
  const std::uint32_t number = view.number;
  const bool is_some = kind == TermKind::object_some_values_from || kind == TermKind::data_some_values_from;
  const bool is_restriction = is_some || (kind >= TermKind::object_all_values_from && arguments.size() == 2 &&
                                          kind <= TermKind::data_exact_cardinality);
  if (is_some) {
    const Term filler = source_.term(arguments[1]);
    const bool is_one = filler.kind == TermKind::object_one_of || filler.kind == TermKind::data_one_of;
    if (is_one && filler.arguments.size() == 1) {
      const TermId value = filler.arguments[0];
      return source_.term(is_data(arguments[0]) ? TermKind::data_has_value : TermKind::object_has_value,
                          {arguments[0], value});
    }
  }
  if (is_restriction && number > 0 && arguments[1] == owl::thing_term)
    return source_.term(kind, {arguments[0]}, number);
  if (!is_restriction && kind != TermKind::object_intersection_of && kind != TermKind::object_union_of &&
      kind != TermKind::object_complement_of) {
    return id;
  }
  for (TermId& argument : arguments) {
    const TermKind of = source_.kind(argument);
    if (owl::is_class_expression(of)) argument = as_written(argument);
  }
  return source_.term(kind, arguments, number);
}

std::string ProofTerms::readable(TermId sub, TermId super, const owl::ShortName& short_name) {
  using owl::AxiomKind;
  const Term left = source_.term(sub);
  std::vector<TermId> arguments;
  AxiomKind kind = AxiomKind::sub_class_of;
  if (left.kind == TermKind::object_one_of && left.arguments.size() == 1) {
    const TermId individual = left.arguments[0];
    const TermId type = as_written(super);
    const Term right = source_.term(type);
    if (right.kind == TermKind::object_has_value || right.kind == TermKind::data_has_value) {
      kind = right.kind == TermKind::object_has_value ? AxiomKind::object_property_assertion
                                                      : AxiomKind::data_property_assertion;
      arguments = {right.arguments[0], individual, right.arguments[1]};
    } else if (right.kind == TermKind::object_one_of && right.arguments.size() == 1) {
      kind = AxiomKind::same_individual;
      arguments = {individual, right.arguments[0]};
    } else {
      kind = AxiomKind::class_assertion;
      arguments = {type, individual};
    }
  } else {
    arguments = {as_written(sub), as_written(super)};
  }
  return owl::print(source_, {kind, {}, 0, arguments}, short_name);
}

}  // namespace geminga::explanation
