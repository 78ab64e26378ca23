// Datatypes by layers, facets by intervals (OWL 2 structural specification, sections 4 and 7).
#include "reasoning/dl/hypertableau/values/value_ranges.hpp"

#include <algorithm>
#include <array>

#include "base/sorted.hpp"
#include "reasoning/owl/datatypes.hpp"

namespace geminga::hypertableau {
namespace {

using clauses::no_term;
using owl::DataFamily;
using owl::TermId;
using owl::TermKind;

constexpr std::string_view xsd = "http://www.w3.org/2001/XMLSchema#";
/// Definitions nest at most as deep, terms at most 500.
constexpr unsigned max_depth = 1000;

struct IntegerType {
  std::string_view name;
  std::string_view low;
  std::string_view high;
};
constexpr std::array integer_types = {
    IntegerType{"integer", "", ""},
    IntegerType{"nonNegativeInteger", "0", ""},
    IntegerType{"positiveInteger", "1", ""},
    IntegerType{"nonPositiveInteger", "", "0"},
    IntegerType{"negativeInteger", "", "-1"},
    IntegerType{"long", "-9223372036854775808", "9223372036854775807"},
    IntegerType{"int", "-2147483648", "2147483647"},
    IntegerType{"short", "-32768", "32767"},
    IntegerType{"byte", "-128", "127"},
    IntegerType{"unsignedLong", "0", "18446744073709551615"},
    IntegerType{"unsignedInt", "0", "4294967295"},
    IntegerType{"unsignedShort", "0", "65535"},
    IntegerType{"unsignedByte", "0", "255"},
};
/// The chain of texts, each with the first layer that is in it.
constexpr std::array<std::string_view, 7> text_types = {"string", "normalizedString", "token",   "NMTOKEN",
                                                        "Name",   "NCName",           "language"};

ValueSet layers(DataFamily family, std::uint8_t first, std::uint8_t end) {
  ValueSet result;
  for (std::uint8_t layer = first; layer < end; ++layer) {
    result = result.union_with(ValueSet::layer(family, layer, Intervals::all()));
  }
  return result;
}

/// The values of a datatype of OWL 2's map; nothing for others.
std::optional<ValueSet> built_in(std::string_view iri) {
  const auto type = owl::Datatype::find(iri);
  if (!type) return std::nullopt;
  const std::string_view name = iri.substr(iri.find('#') + 1);
  if (type->family() == DataFamily::number) {
    if (name == "real") return layers(DataFamily::number, 0, 4);
    if (name == "rational") return layers(DataFamily::number, 0, 3);
    if (name == "decimal") return layers(DataFamily::number, 0, 2);
    const auto* const found = std::ranges::find(integer_types, name, &IntegerType::name);
    if (found == integer_types.end()) return std::nullopt;
    Intervals intervals = Intervals::all();
    if (!found->low.empty()) intervals = Intervals::from({Number(std::string(found->low)), false});
    if (!found->high.empty()) {
      intervals = intervals.intersection(Intervals::to({Number(std::string(found->high)), true}));
    }
    return ValueSet::layer(DataFamily::number, 0, intervals);
  }
  if (type->family() == DataFamily::text) {
    if (name == "PlainLiteral") return layers(DataFamily::text, 0, text_layers);
    if (name == "langString") return layers(DataFamily::text, language_layer, text_layers);
    const auto* const found = std::ranges::find(text_types, name);
    if (found == text_types.end()) return std::nullopt;
    return layers(DataFamily::text, static_cast<std::uint8_t>(found - text_types.begin()), language_layer);
  }
  if (name == "dateTimeStamp") return layers(DataFamily::time, 0, 1);
  return layers(type->family(), 0, layer_count(type->family()));
}

/// Whether a set of values is known to be all of them, without regard to opaque sets.
bool is_everything(const KnownSet& set) { return set.reason.empty() && set.most.complement().count() == 0; }

}  // namespace

void KnownSet::restrict_to(const KnownSet& other) {
  least = least.intersection(other.least);
  most = most.intersection(other.most);
  if (reason.empty()) reason = other.reason;
  opaque.insert(opaque.end(), other.opaque.begin(), other.opaque.end());
  base::sort_unique(opaque);
  const auto is_opposite = [](const OpaqueSet& a, const OpaqueSet& b) { return a.term == b.term; };
  if (std::ranges::adjacent_find(opaque, is_opposite) != opaque.end()) *this = exactly(ValueSet::nothing());
}

void KnownSet::extend_by(const KnownSet& other) {
  KnownSet part = other;
  part.forget_opaque();
  forget_opaque();
  least = least.union_with(part.least);
  most = most.union_with(part.most);
  if (reason.empty()) reason = part.reason;
}

KnownSet KnownSet::complement() const {
  if (opaque.size() == 1 && is_everything(*this)) {
    KnownSet result = *this;
    result.opaque.front().is_complement = !result.opaque.front().is_complement;
    return result;
  }
  KnownSet whole = *this;
  whole.forget_opaque();
  return {whole.most.complement(), whole.least.complement(), whole.reason};
}

void KnownSet::forget_opaque() {
  if (opaque.empty()) return;
  least = ValueSet::nothing();
  reason = "a datatype is not known";
  opaque.clear();
}

ValueRanges::ValueRanges(const owl::Ontology& source, const clauses::ClauseSet& set) : source_(source), set_(set) {
  for (const clauses::DatatypeDefinition& one : set.datatype_definitions) {
    definitions_.try_emplace(one.datatype, one.range);
  }
}

const std::optional<Value>& ValueRanges::value(TermId term) {
  const auto [found, is_new] = literals_.try_emplace(term);
  if (is_new) found->second = value_of(source_, term);
  return found->second;
}

const KnownSet& ValueRanges::known_set(clauses::DataRangeId range) {
  const auto [found, is_new] = known_.try_emplace(clauses::number(range));
  if (!is_new) return found->second;
  const clauses::DataRange& one = set_.data_ranges[clauses::number(range)];
  TermId term = one.term;
  if (term != no_term && source_.kind(term) == TermKind::data_one_of && source_.term(term).arguments.size() == 1)
    term = source_.term(term).arguments[0];
  KnownSet set = KnownSet::exactly(ValueSet::everything());
  if (term != no_term && is_literal(term)) {
    set = set_of_literal(term, one.is_complement);
  } else {
    if (term != no_term) set = evaluate(term, 0);
    if (one.is_complement) set = set.complement();
  }
  return known_.insert_or_assign(clauses::number(range), std::move(set)).first->second;
}

KnownSet ValueRanges::evaluate(TermId id, unsigned depth) {
  if (const auto found = evaluated_.find(id); found != evaluated_.end()) return found->second;
  const owl::Term term = source_.term(id);
  KnownSet set;
  switch (term.kind) {
    case TermKind::datatype:
      set = datatype(id, depth);
      break;
    case TermKind::datatype_restriction:
      set = restriction(term, depth);
      break;
    case TermKind::data_complement_of:
      set = evaluate(term.arguments[0], depth + 1).complement();
      break;
    case TermKind::data_intersection_of:
      set = KnownSet::exactly(ValueSet::everything());
      for (const TermId argument : term.arguments) set.restrict_to(evaluate(argument, depth + 1));
      break;
    case TermKind::data_union_of:
      set = KnownSet::exactly(ValueSet::nothing());
      for (const TermId argument : term.arguments) set.extend_by(evaluate(argument, depth + 1));
      break;
    case TermKind::data_one_of:
      set = enumeration(term);
      break;
    case TermKind::literal:
      set = set_of_literal(id);
      break;
    default:
      break;
  }
  evaluated_.insert_or_assign(id, set);
  return set;
}

bool ValueRanges::are_all_known() {
  for (std::uint32_t range = 0; range < set_.data_ranges.size(); ++range) {
    const KnownSet& set = known_set(clauses::DataRangeId{range});
    if (!set.reason.empty() || !set.opaque.empty()) return false;
  }
  return true;
}

std::optional<TermId> ValueRanges::literal_of(std::uint32_t range) const {
  // The first two are all values, and none.
  const bool is_of_literal = range > 1 && is_literal(set_.data_ranges[range].term);
  if (!is_of_literal || set_.data_ranges[range].is_complement) return std::nullopt;
  return set_.data_ranges[range].term;
}

KnownSet ValueRanges::set_of_literal(TermId literal, bool is_complement) {
  if (const auto& one = value(literal)) {
    const ValueSet set = ValueSet::one(*one);
    return KnownSet::exactly(is_complement ? set.complement() : set);
  }
  const ValueSet everything = ValueSet::everything();
  // A literal of OWL 2's datatypes that has no value here is not worked out, e.g. XML.
  const TermId type = source_.term(literal).arguments[0];
  if (owl::Datatype::find(source_.name_of(type)) || definitions_.contains(type))
    return {ValueSet::nothing(), everything, "literals whose values are not worked out"};
  if (is_complement) return {everything, everything, {}, {{literal, true}}};
  KnownSet set{everything, everything, {}, {{literal, false}, {type, false}}};
  std::ranges::sort(set.opaque);
  return set;
}

KnownSet ValueRanges::datatype(TermId id, unsigned depth) {
  const std::string_view iri = source_.name_of(id);
  if (iri == owl::rdfs_literal) return KnownSet::exactly(ValueSet::everything());
  if (const auto set = built_in(iri)) return KnownSet::exactly(*set);
  const auto definition = definitions_.find(id);
  if (definition == definitions_.end()) return {ValueSet::everything(), ValueSet::everything(), {}, {{id, false}}};
  if (depth < max_depth) return evaluate(definition->second, depth + 1);
  return {ValueSet::nothing(), ValueSet::everything(), "the datatype <" + std::string(iri) + "> is not known"};
}

KnownSet ValueRanges::enumeration(const owl::Term& term) {
  if (term.arguments.size() > max_enumerated_values) {
    return {ValueSet::nothing(), ValueSet::everything(),
            "an enumeration has more than " + std::to_string(max_enumerated_values) + " values"};
  }
  std::vector<Value> values;
  for (const TermId literal : term.arguments) {
    if (const auto& one = value(literal)) values.push_back(*one);
  }
  const bool is_known = values.size() == term.arguments.size();
  ValueSet listed = ValueSet::enumerated(values);
  if (is_known) return KnownSet::exactly(listed);
  return {std::move(listed), ValueSet::everything(), "literals of datatypes that are not known"};
}

KnownSet ValueRanges::restriction(const owl::Term& term, unsigned depth) {
  KnownSet set = evaluate(term.arguments[0], depth + 1);
  // The values that a facet leaves of a datatype of which nothing is known are some of its values.
  if (!set.opaque.empty())
    return {ValueSet::nothing(), set.most, "a facet of a datatype that is not known", set.opaque};
  if (term.arguments.size() - 1 > max_facets) {
    set.least = ValueSet::nothing();
    set.reason = "a restriction has more than " + std::to_string(max_facets) + " facets";
    return set;
  }
  for (const TermId one : term.arguments.subspan(1)) {
    const owl::Term term_of_facet = source_.term(one);
    const std::string_view name = source_.name(term_of_facet.name);
    const auto allowed = facet(name, term_of_facet.arguments[0]);
    if (allowed) {
      set.least = set.least.intersection(*allowed);
      set.most = set.most.intersection(*allowed);
    } else {
      set.least = ValueSet::nothing();
      set.reason = "the facet <" + std::string(name) + "> is not worked out";
    }
  }
  return set;
}

std::optional<ValueSet> ValueRanges::facet(std::string_view name, TermId literal) {
  if (!name.starts_with(xsd)) return std::nullopt;
  name.remove_prefix(xsd.size());
  const auto& value = this->value(literal);
  if (!value) return std::nullopt;
  const bool is_low = name == "minInclusive" || name == "minExclusive";
  const bool is_inclusive = name == "minInclusive" || name == "maxInclusive";
  const auto beyond = [&](const Number& at) {
    // Before the number where it is the first one in, or the first one out.
    const Cut cut{at, is_low != is_inclusive};
    return is_low ? Intervals::from(cut) : Intervals::to(cut);
  };
  if (is_low || is_inclusive || name == "maxExclusive") {
    ValueSet result;
    switch (value->family) {
      case DataFamily::number:
        for (std::uint8_t layer = 0; layer < number_layers; ++layer) {
          result = result.union_with(ValueSet::layer(DataFamily::number, layer, beyond(value->position)));
        }
        return result;
      case DataFamily::double_:
      case DataFamily::float_: {
        if (value->layer == 1) return is_inclusive ? ValueSet::one(*value) : ValueSet::nothing();
        // -0 and 0 are different values, but neither is less than the other; their ranks are -1 and 0.
        Number rank = value->position;
        const bool is_zero = rank == 0 || rank == -1;
        if (is_zero) rank = (is_low == is_inclusive) ? -1 : 0;
        return ValueSet::layer(value->family, 0, beyond(rank));
      }
      case DataFamily::time: {
        // With and without a zone: comparable only where the fourteen hours of zones do not matter.
        const Number shift = Number(14 * 3600) * (is_low ? 1 : -1);
        const std::uint8_t other = value->layer == 0 ? 1 : 0;
        Cut away{value->position + shift, is_low};
        const Intervals far = is_low ? Intervals::from(away) : Intervals::to(away);
        return ValueSet::layer(DataFamily::time, value->layer, beyond(value->position))
            .union_with(ValueSet::layer(DataFamily::time, other, far));
      }
      default:
        return std::nullopt;
    }
  }
  if (name != "length" && name != "minLength" && name != "maxLength") return std::nullopt;
  if (value->family != DataFamily::number || value->layer != 0) return std::nullopt;
  Intervals lengths = name == "maxLength" ? Intervals::all() : Intervals::from({value->position, false});
  if (name != "minLength") lengths = lengths.intersection(Intervals::to({value->position, true}));
  ValueSet result;
  for (const DataFamily family : {DataFamily::text, DataFamily::hex, DataFamily::base64, DataFamily::uri}) {
    for (std::uint8_t layer = 0; layer < layer_count(family); ++layer) {
      result = result.union_with(ValueSet::layer(family, layer, lengths));
    }
  }
  return result;
}

}  // namespace geminga::hypertableau
