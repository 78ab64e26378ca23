// Terms of a query become shapes, one kind after the other.
#include "reasoning/placement/expression_shape.hpp"

#include <algorithm>
#include <compare>
#include <tuple>
#include <utility>

#include "reasoning/owl/literal_value.hpp"

namespace geminga::placement {
namespace {

constexpr std::string_view owl = "http://www.w3.org/2002/07/owl#";
constexpr std::string_view rdfs_literal = "http://www.w3.org/2000/01/rdf-schema#Literal";

bool is_top_property(std::string_view iri) {
  return iri.starts_with(owl) &&
         (iri.substr(owl.size()) == "topObjectProperty" || iri.substr(owl.size()) == "topDataProperty");
}

/// A number in canonical form: digits, perhaps a sign, and a point only before a fraction.
struct Decimal {
  bool is_negative = false;
  std::string_view whole;
  std::string_view fraction;

  static std::optional<Decimal> read(std::string_view text) {
    Decimal read{.is_negative = text.starts_with('-'), .whole = {}, .fraction = {}};
    if (read.is_negative) text.remove_prefix(1);
    if (text.empty() || text.find_first_not_of("0123456789.") != std::string_view::npos) return std::nullopt;
    const std::size_t point = std::min(text.find('.'), text.size());
    read.whole = text.substr(0, point);
    read.whole.remove_prefix(std::min(read.whole.find_first_not_of('0'), read.whole.size()));
    if (point < text.size()) read.fraction = text.substr(point + 1);
    return read;
  }
  [[nodiscard]] std::strong_ordering compare_size(const Decimal& other) const {
    return std::tuple(whole.size(), whole, fraction) <=> std::tuple(other.whole.size(), other.whole, other.fraction);
  }
  [[nodiscard]] std::strong_ordering compare(const Decimal& other) const {
    if (is_negative != other.is_negative) return other.is_negative <=> is_negative;
    return is_negative ? other.compare_size(*this) : compare_size(other);
  }
};

/// True if a value is within a bound. False for facets that are not evaluated here, such as patterns and lengths.
bool is_certainly_met(std::string_view facet, const owl::DataValue& value, const owl::DataValue& bound) {
  constexpr std::string_view xsd = "http://www.w3.org/2001/XMLSchema#";
  const bool are_numbers = value.family == owl::DataFamily::number && bound.family == owl::DataFamily::number;
  if (!facet.starts_with(xsd) || !are_numbers || !value.is_exact || !bound.is_exact) return false;
  facet.remove_prefix(xsd.size());
  const auto is = Decimal::read(value.canonical);
  const auto limit = Decimal::read(bound.canonical);
  if (!is || !limit) return false;
  const auto order = is->compare(*limit);
  return facet == "minInclusive"   ? order >= 0
         : facet == "minExclusive" ? order > 0
         : facet == "maxInclusive" ? order <= 0
         : facet == "maxExclusive" ? order < 0
                                   : false;
}

}  // namespace

ShapeId ShapeReader::add(Shape shape) {
  shapes_.push_back(std::move(shape));
  return static_cast<ShapeId>(shapes_.size() - 1);
}

ShapeId ShapeReader::atom(el::ExprId expr) { return add({.kind = ShapeKind::atom, .atom = expr}); }

bool ShapeReader::is(ShapeId id, el::ExprId expr) const {
  return shapes_[id].kind == ShapeKind::atom && shapes_[id].atom == base_.index().representative(expr);
}

el::ExprId ShapeReader::known_atom(owl::TermId id) const {
  const auto known = in_base(id);
  return known && base_.index().is_atom(base_.expr(*known)) ? base_.expr(*known) : el::top_expr;
}

std::optional<owl::TermId> ShapeReader::in_base(owl::TermId id) const {
  const owl::Term term = query_.term(id);
  std::vector<owl::TermId> arguments;
  for (const owl::TermId argument : term.arguments) {
    const auto found = in_base(argument);
    if (!found) return std::nullopt;
    arguments.push_back(*found);
  }
  return base_.find_term(term.kind, query_.name(term.name), term.number, arguments);
}

ShapeId ShapeReader::unknown(owl::TermId id, std::string_view words) {
  add_gap(words);
  return add({.kind = ShapeKind::opaque, .atom = known_atom(id)});
}

std::optional<el::RoleId> ShapeReader::role_of(owl::TermId property) {
  const owl::Term term = query_.term(property);
  if (term.kind == owl::TermKind::object_inverse_of || is_top_property(query_.name(term.name))) return std::nullopt;
  const auto known = in_base(property);
  if (!known) return std::nullopt;
  return base_.role(*known);
}

bool ShapeReader::has_negation(ShapeId id) const {
  return shapes_[id].kind == ShapeKind::negation ||
         std::ranges::any_of(shapes_[id].parts, [&](ShapeId part) { return has_negation(part); });
}

//  not not C is C;  not (C or D) is not C and not D;  not (R only C) is R some not C
ShapeId ShapeReader::negated(ShapeId id) {
  const Shape shape = shapes_[id];
  switch (shape.kind) {
    case ShapeKind::negation:
      return shape.parts[0];
    case ShapeKind::any_of: {
      std::vector<ShapeId> parts;
      for (const ShapeId part : shape.parts) parts.push_back(negated(part));
      return all_of(parts);
    }
    case ShapeKind::only:
      return add({.kind = ShapeKind::some, .role = shape.role, .parts = {negated(shape.parts[0])}});
    case ShapeKind::at_most:
      if (shape.count == 0) return add({.kind = ShapeKind::some, .role = shape.role, .parts = shape.parts});
      return add({.kind = ShapeKind::at_least, .role = shape.role, .count = shape.count + 1, .parts = shape.parts});
    case ShapeKind::at_least:
      return add({.kind = ShapeKind::at_most, .role = shape.role, .count = shape.count - 1, .parts = shape.parts});
    default:
      if (is(id, el::top_expr)) return atom(base_.index().representative(el::bottom_expr));
      if (is(id, el::bottom_expr)) return atom(base_.index().representative(el::top_expr));
      return add({.kind = ShapeKind::negation, .parts = {id}});
  }
}

ShapeId ShapeReader::all_of(const std::vector<ShapeId>& parts) {
  std::vector<ShapeId> kept;
  for (const ShapeId part : parts) {
    if (is(part, el::bottom_expr)) return part;
    if (!is(part, el::top_expr)) kept.push_back(part);
  }
  if (kept.empty()) return atom(base_.index().representative(el::top_expr));
  if (kept.size() == 1) return kept.front();
  return add({.kind = ShapeKind::all_of, .parts = std::move(kept)});
}

// not C or not D is not (C and D), which is evaluated more exactly.
ShapeId ShapeReader::any_of(const std::vector<ShapeId>& parts) {
  std::vector<ShapeId> kept;
  for (const ShapeId part : parts) {
    if (is(part, el::top_expr)) return part;
    if (!is(part, el::bottom_expr)) kept.push_back(part);
  }
  if (kept.empty()) return atom(base_.index().representative(el::bottom_expr));
  if (kept.size() == 1) return kept.front();
  const auto is_negation = [&](ShapeId part) { return shapes_[part].kind == ShapeKind::negation; };
  if (std::ranges::all_of(kept, is_negation)) {
    for (ShapeId& part : kept) part = shapes_[part].parts[0];
    return negated(all_of(kept));
  }
  if (std::ranges::any_of(kept, is_negation)) add_gap("a complement in a union");
  return add({.kind = ShapeKind::any_of, .parts = std::move(kept)});
}

ShapeId ShapeReader::restriction(ShapeKind kind, owl::TermId term, ShapeId part, std::uint32_t count) {
  const owl::TermId property = query_.term(term).arguments[0];
  const auto role = role_of(property);
  if (!role) {
    const bool is_inverse = query_.kind(property) == owl::TermKind::object_inverse_of;
    return unknown(term, is_inverse ? "owl:inverseOf in the expression" : "a property that the ontology does not use");
  }
  return add({.kind = kind, .atom = known_atom(term), .role = *role, .count = count, .parts = {part}});
}

ShapeId ShapeReader::at_least(owl::TermId term, std::uint32_t count, ShapeId part) {
  if (count == 0) return atom(base_.index().representative(el::top_expr));
  if (is(part, el::bottom_expr)) return part;
  return restriction(count == 1 ? ShapeKind::some : ShapeKind::at_least, term, part, count);
}

ShapeId ShapeReader::at_most(owl::TermId term, std::uint32_t count, ShapeId part) {
  const ShapeId all = atom(base_.index().representative(el::top_expr));
  if (is(part, el::bottom_expr)) return all;
  if (count > 0) {
    // Everything is in R max n C if R is functional and n > 0.
    const auto role = role_of(query_.term(term).arguments[0]);
    const auto is_functional = [&](el::RoleId super) { return base_.index().is_functional(super); };
    if (role && std::ranges::any_of(base_.index().roles().supers(*role), is_functional)) return all;
    return restriction(ShapeKind::at_most, term, part, count);
  }
  const ShapeId some = restriction(ShapeKind::some, term, part);
  return shapes_[some].kind == ShapeKind::some ? negated(some) : some;
}

ShapeId ShapeReader::read_restriction(owl::TermId id, const owl::Term& term) {
  const bool is_qualified = term.arguments.size() == 2;
  const auto part = [&] {
    return is_qualified ? read(term.arguments[1]) : atom(base_.index().representative(el::top_expr));
  };
  switch (term.kind) {
    case owl::TermKind::object_some_values_from:
    case owl::TermKind::data_some_values_from:
    case owl::TermKind::object_has_value:
    case owl::TermKind::data_has_value:
      return at_least(id, 1, part());
    case owl::TermKind::object_has_self: {
      const auto role = role_of(term.arguments[0]);
      return role ? add({.kind = ShapeKind::self, .role = *role}) : unknown(id, "Self of such a property");
    }
    case owl::TermKind::object_all_values_from:
    case owl::TermKind::data_all_values_from: {
      const ShapeId filler = part();
      return is(filler, el::top_expr) ? filler : restriction(ShapeKind::only, id, filler);
    }
    case owl::TermKind::object_min_cardinality:
    case owl::TermKind::data_min_cardinality:
      return at_least(id, term.number, part());
    case owl::TermKind::object_max_cardinality:
    case owl::TermKind::data_max_cardinality:
      return at_most(id, term.number, part());
    default: {
      const ShapeId filler = part();
      return all_of({at_least(id, term.number, filler), at_most(id, term.number, filler)});
    }
  }
}

ShapeId ShapeReader::read_literal(owl::TermId id, const owl::Term& term) {
  if (const auto known = in_base(id)) return atom(base_.expr(*known));
  const auto value = value_of(query_, term);
  if (!value) return unknown(id, "a literal of an unknown datatype");
  if (const auto known = base_.find_value(*value)) return atom(*known);
  Shape shape{.kind = ShapeKind::value};
  for (const auto& [type, expr] : base_.datatypes()) {
    if (value->is_in(type)) shape.above.push_back(expr);
  }
  return add(std::move(shape));
}

ShapeId ShapeReader::read_datatype(owl::TermId id, const owl::Term& term) {
  if (query_.name(term.name) == rdfs_literal) return atom(base_.index().representative(el::top_expr));
  if (const auto known = in_base(id)) return atom(base_.expr(*known));
  const auto type = owl::Datatype::find(query_.name(term.name));
  if (!type) return unknown(id, "a datatype that the ontology does not use");
  Shape shape{.kind = ShapeKind::value};
  for (const auto& [other, expr] : base_.datatypes()) {
    if (type->is_within(other)) shape.above.push_back(expr);
    if (other.is_within(*type)) shape.below.push_back(expr);
  }
  for (const auto& [value, expr] : base_.values()) {
    if (value.is_in(*type)) shape.below.push_back(expr);
  }
  return add(std::move(shape));
}

// Values of the ontology that are certainly in the restriction are below it, and datatypes with all its values are
// above. Other ranges are left open.
ShapeId ShapeReader::read_facets(owl::TermId id, const owl::Term& term) {
  add_gap("owl:withRestrictions in the expression");
  const auto type = owl::Datatype::find(query_.name(query_.term(term.arguments[0]).name));
  if (!type) return add({.kind = ShapeKind::opaque, .atom = known_atom(id)});
  std::vector<std::pair<std::string_view, owl::DataValue>> facets;
  for (const owl::TermId facet : term.arguments.subspan(1)) {
    const owl::Term named = query_.term(facet);
    auto bound = value_of(query_, query_.term(named.arguments[0]));
    if (!bound) return add({.kind = ShapeKind::opaque, .atom = known_atom(id)});
    facets.emplace_back(query_.name(named.name), std::move(*bound));
  }
  Shape shape{.kind = ShapeKind::value, .atom = known_atom(id)};
  for (const auto& [other, expr] : base_.datatypes()) {
    if (type->is_within(other)) shape.above.push_back(expr);
  }
  for (const auto& [value, expr] : base_.values()) {
    const auto is_met = [&](const auto& facet) { return is_certainly_met(facet.first, value, facet.second); };
    if (value.is_in(*type) && std::ranges::all_of(facets, is_met)) shape.below.push_back(expr);
  }
  return add(std::move(shape));
}

ShapeId ShapeReader::read(owl::TermId id) {
  const owl::Term term = query_.term(id);
  std::vector<ShapeId> parts;
  const auto read_parts = [&] {
    for (const owl::TermId part : term.arguments) parts.push_back(read(part));
  };
  switch (term.kind) {
    case owl::TermKind::named_class:
    case owl::TermKind::individual:
    case owl::TermKind::anonymous_individual: {
      const auto known = in_base(id);
      return known ? atom(base_.expr(*known)) : unknown(id, "a name that the ontology does not use");
    }
    case owl::TermKind::literal:
      return read_literal(id, term);
    case owl::TermKind::datatype:
      return read_datatype(id, term);
    case owl::TermKind::object_intersection_of:
    case owl::TermKind::data_intersection_of:
      read_parts();
      return all_of(parts);
    case owl::TermKind::object_union_of:
    case owl::TermKind::data_union_of:
    case owl::TermKind::object_one_of:
    case owl::TermKind::data_one_of:
      read_parts();
      return any_of(parts);
    case owl::TermKind::object_complement_of: {
      const ShapeId complement = negated(read(term.arguments[0]));
      if (shapes_[complement].kind == ShapeKind::negation) shapes_[complement].atom = known_atom(id);
      return complement;
    }
    case owl::TermKind::data_complement_of:
      return unknown(id, "owl:datatypeComplementOf in the expression");
    case owl::TermKind::datatype_restriction:
      return read_facets(id, term);
    default:
      return read_restriction(id, term);
  }
}

std::vector<ShapeId> ShapeReader::alternatives_of(ShapeId id) {
  const Shape shape = shapes_[id];
  std::vector<ShapeId> found;
  const auto give_up = [&] {
    add_gap("too many alternatives");
    return std::vector<ShapeId>{id};
  };
  if (shape.kind == ShapeKind::any_of) {
    for (const ShapeId part : shape.parts) {
      for (const ShapeId alternative : alternatives_of(part)) found.push_back(alternative);
      if (found.size() > base_.limits().parts) return give_up();
    }
    return found;
  }
  if (shape.kind == ShapeKind::all_of) {
    std::vector<std::vector<ShapeId>> products(1);
    for (const ShapeId part : shape.parts) {
      const std::vector<ShapeId> alternatives = alternatives_of(part);
      if (products.size() * alternatives.size() > base_.limits().parts) return give_up();
      std::vector<std::vector<ShapeId>> longer;
      for (const auto& product : products) {
        for (const ShapeId alternative : alternatives) {
          longer.push_back(product);
          longer.back().push_back(alternative);
        }
      }
      products = std::move(longer);
    }
    if (products.size() == 1) {
      // This level has no union. A level below may have had one.
      return products.front() == shape.parts ? std::vector<ShapeId>{id}
                                             : std::vector<ShapeId>{all_of(products.front())};
    }
    for (auto& product : products) found.push_back(all_of(product));
    return found;
  }
  if (shape.kind == ShapeKind::some) {
    const std::vector<ShapeId> alternatives = alternatives_of(shape.parts[0]);
    if (alternatives.size() == 1 && alternatives.front() == shape.parts[0]) return {id};
    for (const ShapeId alternative : alternatives) {
      found.push_back(add({.kind = ShapeKind::some, .role = shape.role, .parts = {alternative}}));
    }
    return found;
  }
  return {id};
}

}  // namespace geminga::placement
