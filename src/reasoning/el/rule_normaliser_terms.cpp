// From terms to expressions, whatever their polarity.
#include <xxhash.h>

#include <algorithm>

#include "base/assert.hpp"
#include "reasoning/el/rule_normaliser.hpp"

namespace geminga::el {
namespace {

constexpr std::uint32_t none = base::NumberTable::none;
constexpr std::string_view owl = "http://www.w3.org/2002/07/owl#";

bool is_in_owl(std::string_view iri, std::string_view local) {
  return iri.size() == owl.size() + local.size() && iri.starts_with(owl) && iri.ends_with(local);
}

}  // namespace

RuleNormaliser::RuleNormaliser(const owl::Ontology& source, IndexedOntology& index)
    : source_(source),
      index_(index),
      exprs_(source.term_count(), none),
      negative_(source.term_count(), 0),
      positive_(source.term_count(), 0),
      roles_(source.term_count(), none) {}

RuleNormaliser::Property RuleNormaliser::property(owl::TermId id) {
  const owl::Term term = source_.term(id);
  if (term.kind == owl::TermKind::object_inverse_of) {
    Property inverse = property(term.arguments[0]);
    inverse.is_inverse = !inverse.is_top;  // the inverse of the top property is itself
    return inverse;
  }
  Property result;
  result.is_data = term.kind == owl::TermKind::data_property;
  const std::string_view iri = source_.name(term.name);
  result.is_top = is_in_owl(iri, result.is_data ? "topDataProperty" : "topObjectProperty");
  std::uint32_t& role = roles_[static_cast<std::size_t>(id)];
  if (role == none) {
    role = static_cast<std::uint32_t>(index_.roles().add());
    if (result.is_data) index_.mark_data(RoleId{role});
    if (is_in_owl(iri, result.is_data ? "bottomDataProperty" : "bottomObjectProperty")) {
      const ExprId some = index_.existential(RoleId{role}, top_expr);
      index_.mark_negative(some);
      index_.add_told(some, bottom_expr);
    }
  }
  result.role = RoleId{role};
  return result;
}

ExprId RuleNormaliser::expression(owl::TermId id) {
  const auto index = static_cast<std::size_t>(id);
  if (exprs_[index] == none) exprs_[index] = number(make_expression(id));
  return ExprId{exprs_[index]};
}

ExprId RuleNormaliser::make_expression(owl::TermId id) {
  const owl::Term term = source_.term(id);
  switch (term.kind) {
    case owl::TermKind::named_class: {
      const std::string_view iri = source_.name(term.name);
      if (iri == owl::owl_thing) return top_expr;
      if (iri == owl::owl_nothing) return bottom_expr;
      return index_.add_atom();
    }
    case owl::TermKind::datatype:
      return make_datatype(term);
    case owl::TermKind::literal:
      return make_literal(id, term);
    case owl::TermKind::individual:
    case owl::TermKind::anonymous_individual:
      individuals_.push_back(index_.add_nominal());
      return individuals_.back();
    case owl::TermKind::object_intersection_of:
    case owl::TermKind::data_intersection_of: {
      std::vector<ExprId> parts;
      for (const owl::TermId part : term.arguments) parts.push_back(expression(part));
      return index_.conjunction(std::move(parts));
    }
    case owl::TermKind::object_union_of:
    case owl::TermKind::data_union_of:
    case owl::TermKind::object_one_of:
    case owl::TermKind::data_one_of: {
      std::vector<ExprId> parts;
      for (const owl::TermId part : term.arguments) parts.push_back(expression(part));
      return make_union(parts);
    }
    case owl::TermKind::object_complement_of:
    case owl::TermKind::data_complement_of: {
      const ExprId part = expression(term.arguments[0]);
      if (part == top_expr) return bottom_expr;
      if (part == bottom_expr) return top_expr;
      if (source_.kind(term.arguments[0]) == term.kind) return expression(source_.term(term.arguments[0]).arguments[0]);
      return opaque(owl::TermKind::object_complement_of, 0, {number(part)});
    }
    case owl::TermKind::datatype_restriction:
      return index_.add_atom();
    default:
      return make_restriction(id, term);
  }
}

ExprId RuleNormaliser::make_union(const std::vector<ExprId>& parts) {
  std::vector<std::uint32_t> key;
  for (const ExprId part : parts) {
    if (part == top_expr) return top_expr;
    if (part != bottom_expr) key.push_back(number(part));
  }
  std::ranges::sort(key);
  key.erase(std::unique(key.begin(), key.end()), key.end());
  if (key.empty()) return bottom_expr;
  if (key.size() == 1) return ExprId{key.front()};
  return opaque(owl::TermKind::object_union_of, 0, std::move(key));
}

ExprId RuleNormaliser::filler_of(const owl::Term& term) {
  return is_qualified(term) ? expression(term.arguments[1]) : top_expr;
}

ExprId RuleNormaliser::make_some(const Property& property, ExprId filler, owl::TermId) {
  if (filler == bottom_expr) return bottom_expr;
  if (property.is_inverse) return opaque_restriction(owl::TermKind::object_some_values_from, 0, property, filler);
  return index_.existential(property.role, filler);
}

ExprId RuleNormaliser::make_restriction(owl::TermId id, const owl::Term& term) {
  const Property role = property(term.arguments[0]);
  switch (term.kind) {
    case owl::TermKind::object_some_values_from:
    case owl::TermKind::data_some_values_from:
    case owl::TermKind::object_has_value:
    case owl::TermKind::data_has_value:
      return make_some(role, expression(term.arguments[1]), id);
    case owl::TermKind::object_has_self:
      return index_.self(role.role);
    case owl::TermKind::object_all_values_from:
    case owl::TermKind::data_all_values_from: {
      const ExprId filler = expression(term.arguments[1]);
      return filler == top_expr ? top_expr : opaque_restriction(owl::TermKind::object_all_values_from, 0, role, filler);
    }
    case owl::TermKind::object_min_cardinality:
    case owl::TermKind::data_min_cardinality:
      if (term.number == 0) return top_expr;
      if (term.number == 1 || filler_of(term) == bottom_expr) return make_some(role, filler_of(term), id);
      return opaque_restriction(owl::TermKind::object_min_cardinality, term.number, role, filler_of(term));
    case owl::TermKind::object_max_cardinality:
    case owl::TermKind::data_max_cardinality:
      if (filler_of(term) == bottom_expr) return top_expr;
      return opaque_restriction(owl::TermKind::object_max_cardinality, term.number, role, filler_of(term));
    case owl::TermKind::object_exact_cardinality:
    case owl::TermKind::data_exact_cardinality: {
      const ExprId filler = filler_of(term);
      if (filler == bottom_expr) return term.number == 0 ? top_expr : bottom_expr;
      const ExprId most = opaque_restriction(owl::TermKind::object_max_cardinality, term.number, role, filler);
      if (term.number == 0) return most;
      const ExprId least = term.number == 1
                               ? make_some(role, filler, id)
                               : opaque_restriction(owl::TermKind::object_min_cardinality, term.number, role, filler);
      return index_.conjunction({least, most});
    }
    default:
      GEMINGA_ASSERT(false);  // a term that is no class expression or data range
      return bottom_expr;
  }
}

ExprId RuleNormaliser::opaque_restriction(owl::TermKind kind, std::uint32_t limit, const Property& property,
                                          ExprId filler) {
  return opaque(kind, limit,
                {static_cast<std::uint32_t>(property.role), property.is_inverse ? 1U : 0U, number(filler)});
}

ExprId RuleNormaliser::opaque(owl::TermKind kind, std::uint32_t limit, std::vector<std::uint32_t> key) {
  key.push_back(limit);
  key.push_back(static_cast<std::uint32_t>(kind));
  const auto filed = [&](std::uint32_t entry) {
    return std::span(opaque_keys_).subspan(opaque_spans_[entry].first, opaque_spans_[entry].second);
  };
  const std::uint64_t hash = XXH3_64bits(key.data(), key.size() * sizeof key[0]);
  const std::uint32_t found =
      opaque_table_.find(hash, [&](std::uint32_t entry) { return std::ranges::equal(filed(entry), key); });
  if (found != none) return opaque_exprs_[found];
  const auto entry = static_cast<std::uint32_t>(opaque_exprs_.size());
  opaque_spans_.emplace_back(static_cast<std::uint32_t>(opaque_keys_.size()), static_cast<std::uint32_t>(key.size()));
  opaque_keys_.insert(opaque_keys_.end(), key.begin(), key.end());
  opaque_exprs_.push_back(index_.add_atom());
  opaque_table_.insert(hash, entry);
  return opaque_exprs_.back();
}

}  // namespace geminga::el
