#include "reasoning/dl/consequence/rules/range_conflicts.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "reasoning/dl/consequence/rules/gaps.hpp"
#include "reasoning/owl/literal_value.hpp"

namespace geminga::consequence {
namespace {

using owl::TermKind;

/// A range, as far as it is understood.
struct Understood {
  enum class Kind : std::uint8_t { everything, datatype, unknown_datatype, value, other } kind = Kind::other;
  bool is_complement = false;
  std::optional<owl::Datatype> datatype;
  std::optional<owl::DataValue> value;
  owl::TermId term{};
};

constexpr int max_definitions = 100;  ///< that lead from one datatype to another; beyond, it is not understood

class Reading {
 public:
  Reading(const owl::Ontology& source, std::span<const clauses::DatatypeDefinition> definitions) : source_(source) {
    for (const auto& definition : definitions) definitions_.try_emplace(definition.datatype, definition.range);
  }

  [[nodiscard]] Understood read(const clauses::DataRange& range) const {
    Understood result;
    result.is_complement = range.is_complement;
    result.term = range.term;
    if (range.term == clauses::no_term) {
      result.kind = Understood::Kind::everything;
      return result;
    }
    for (int step = 0; step < max_definitions; ++step) {
      const owl::Term term = source_.term(result.term);
      if (term.kind == TermKind::data_complement_of) {
        result.is_complement = !result.is_complement;
        result.term = term.arguments[0];
      } else if (term.kind == TermKind::data_one_of && term.arguments.size() == 1) {
        result.term = term.arguments[0];
      } else if (const auto found = definitions_.find(result.term); found != definitions_.end()) {
        result.term = found->second;
      } else {
        return finish(result, term);
      }
    }
    return result;
  }

 private:
  [[nodiscard]] Understood finish(Understood result, const owl::Term& term) const {
    if (term.kind == TermKind::datatype) {
      const std::string_view iri = source_.name(term.name);
      result.datatype = owl::Datatype::find(iri);
      result.kind = result.datatype ? Understood::Kind::datatype : Understood::Kind::unknown_datatype;
      if (iri == "http://www.w3.org/2000/01/rdf-schema#Literal") result.kind = Understood::Kind::everything;
    } else if (term.kind == TermKind::literal) {
      result.value = owl::value_of(source_, term);
      result.kind = Understood::Kind::value;
    }
    return result;
  }

  const owl::Ontology& source_;
  std::map<owl::TermId, owl::TermId> definitions_;
};

using Kind = Understood::Kind;

[[nodiscard]] bool is_empty(const Understood& range) { return range.kind == Kind::everything && range.is_complement; }

/// Whether every value of `a` is one of `b`, without regard to complements. False if that is not known.
[[nodiscard]] bool is_within(const Understood& a, const Understood& b) {
  if (a.term == b.term || b.kind == Kind::everything) return true;
  if (a.kind == Kind::datatype && b.kind == Kind::datatype) return a.datatype->is_within(*b.datatype);
  if (a.kind != Kind::value || !a.value) return false;
  if (b.kind == Kind::datatype) return a.value->is_in(*b.datatype);
  return b.kind == Kind::value && b.value && a.value->family == b.value->family &&
         a.value->canonical == b.value->canonical;
}

/// Whether they have no value in common. False if that is not known.
[[nodiscard]] bool are_disjoint(const Understood& a, const Understood& b) {
  if (a.kind == Kind::datatype && b.kind == Kind::datatype) return a.datatype->is_disjoint(*b.datatype);
  if (b.kind == Kind::value && a.kind == Kind::datatype) return are_disjoint(b, a);
  if (a.kind != Kind::value || !a.value) return false;
  if (b.kind == Kind::datatype) return a.value->is_exact && !a.value->is_in(*b.datatype);
  if (b.kind != Kind::value || !b.value) return false;
  if (a.value->family != b.value->family) return true;
  return a.value->is_exact && b.value->is_exact && a.value->canonical != b.value->canonical;
}

/// Whether pairs do not tell everything about the two, or one of them is not understood.
[[nodiscard]] bool may_hide_more(const Understood& a, const Understood& b) {
  if (is_empty(a) || is_empty(b) || a.kind == Kind::everything || b.kind == Kind::everything) return false;
  if (a.kind == Kind::unknown_datatype || b.kind == Kind::unknown_datatype) return false;  // mark_opaque()
  // Two complements always have values in common. With a third range, its pairs with them decide.
  if (a.is_complement && b.is_complement) return false;
  if (a.is_complement) return may_hide_more(b, a);
  // Infinitely many values without some are still infinitely many.
  if (b.is_complement && b.kind == Kind::value && a.kind == Kind::datatype && !a.datatype->is_finite()) return false;
  const bool is_known = is_within(a, b) || are_disjoint(a, b);
  return b.is_complement ? !is_known : !is_known && !is_within(b, a);
}

/// Numbers the values of literals that are certainly different.
[[nodiscard]] std::vector<std::uint32_t> number_values(const std::vector<Understood>& ranges) {
  std::map<std::pair<owl::DataFamily, std::string>, std::uint32_t> values;
  std::vector<std::uint32_t> numbers(ranges.size(), 0);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Understood& range = ranges[i];
    if (range.kind != Kind::value || !range.value || !range.value->is_exact || range.is_complement) continue;
    numbers[i] =
        values.try_emplace({range.value->family, range.value->canonical}, static_cast<std::uint32_t>(values.size() + 1))
            .first->second;
  }
  return numbers;
}

/// Marks the datatypes of which nothing is known that single values may be in and may not be in.
///
/// A model chooses the values of such a datatype U. If it occurs without its complement, or only its complement occurs,
/// it is chosen to hold all values or none. Otherwise a value in U must differ from each value outside of it. Let every
/// value of a model have infinitely many others in the same ranges, of which finitely many tell it apart: then the
/// values can be exchanged for others so that infinitely many are left over, inside of U and outside of it, for any
/// other model beside it. So only values of which there are finitely many matter.
void mark_opaque(const std::vector<Understood>& ranges, std::vector<bool>& is_unclear) {
  const bool has_few = std::ranges::any_of(ranges, [](const Understood& range) {
    return range.kind == Kind::value || (range.kind == Kind::datatype && range.datatype->is_finite());
  });
  if (!has_few) return;
  std::map<owl::TermId, std::array<bool, 2>> has_sign;
  for (const Understood& range : ranges) {
    if (range.kind == Kind::unknown_datatype) has_sign[range.term][range.is_complement ? 1 : 0] = true;
  }
  for (std::size_t at = 0; at < ranges.size(); ++at) {
    if (ranges[at].kind != Kind::unknown_datatype) continue;
    const auto& signs = has_sign.at(ranges[at].term);
    if (signs[0] && signs[1]) is_unclear[at] = true;
  }
}

}  // namespace

/// The most ranges that splitting may make. Beyond it ranges stay whole and are not understood.
constexpr std::size_t max_ranges = 100'000;

std::vector<RangeParts> take_apart(const owl::Ontology& source,
                                   std::span<const clauses::DatatypeDefinition> definitions,
                                   std::vector<clauses::DataRange>& ranges) {
  const Reading reading(source, definitions);
  std::map<clauses::DataRange, std::size_t> known;
  for (std::size_t i = 0; i < ranges.size(); ++i) known.try_emplace(ranges[i], i);
  std::vector<RangeParts> result;
  for (std::size_t i = 0; i < ranges.size() && ranges.size() < max_ranges; ++i) {
    const Understood range = reading.read(ranges[i]);
    if (range.kind != Kind::other) continue;
    const owl::Term term = source.term(range.term);
    const bool is_union = term.kind == TermKind::data_union_of || term.kind == TermKind::data_one_of;
    if (!is_union && term.kind != TermKind::data_intersection_of) continue;
    RangeParts& made = result.emplace_back(RangeParts{i, is_union != range.is_complement, {}});
    for (const owl::TermId part : term.arguments) {
      const clauses::DataRange wanted{part, range.is_complement};
      const auto [found, is_new] = known.try_emplace(wanted, ranges.size());
      if (is_new) ranges.push_back(wanted);
      made.parts.push_back(found->second);
    }
  }
  return result;
}

ValueConflicts conflicts_of(const owl::Ontology& source, std::span<const clauses::DatatypeDefinition> definitions,
                            std::span<const clauses::DataRange> ranges, std::span<const RangeParts> apart) {
  const Reading reading(source, definitions);
  std::vector<Understood> understood;
  for (const clauses::DataRange& range : ranges) understood.push_back(reading.read(range));
  // These ranges are known by their parts.
  for (const RangeParts& parts : apart) {
    understood[parts.range] = Understood();
    understood[parts.range].kind = Kind::everything;
  }
  ValueConflicts result;
  result.value_number = number_values(understood);
  std::vector<bool> is_unknown(understood.size(), false);
  // Numbered values are compared by their numbers. Only the few other ranges are compared pair by pair.
  std::vector<std::size_t> others;
  std::map<owl::TermId, std::vector<std::size_t>> not_understood;
  for (std::size_t i = 0; i < understood.size(); ++i) {
    const Understood& range = understood[i];
    if (is_empty(range)) result.empty.push_back(i);
    if (range.kind == Kind::other) is_unknown[i] = true;
    if (range.kind == Kind::value && !range.value) is_unknown[i] = true;
    if (range.kind == Kind::value || (range.kind == Kind::datatype && range.datatype->is_finite())) {
      result.is_finite = true;
    }
    // Nothing is known about a range that is not understood beside another one, except beside its own complement.
    if (range.kind == Kind::other) {
      std::vector<std::size_t>& same = not_understood[range.term];
      for (const std::size_t other : same) {
        if (understood[other].is_complement != range.is_complement) result.disjoint.emplace_back(other, i);
      }
      same.push_back(i);
      continue;
    }
    if (result.value_number[i] == 0) others.push_back(i);
  }
  // Marking the unknown ranges as unclear is enough; the others need not be marked because of them.
  result.is_unclear = is_unknown;
  for (std::size_t i = 0; i < understood.size(); ++i) {
    for (const std::size_t j : others) {
      if (result.value_number[i] == 0 && understood[i].kind != Kind::other && j <= i) continue;
      const Understood& a = understood[i].is_complement ? understood[j] : understood[i];
      const Understood& b = understood[i].is_complement ? understood[i] : understood[j];
      if (!a.is_complement && (b.is_complement ? is_within(a, b) : are_disjoint(a, b))) {
        result.disjoint.emplace_back(i, j);
      } else if (!is_unknown[i] && !is_unknown[j] && may_hide_more(a, b)) {
        result.is_unclear[i] = result.is_unclear[j] = true;
      }
    }
  }
  mark_opaque(understood, result.is_unclear);
  if (std::ranges::find(result.is_unclear, true) != result.is_unclear.end()) result.gaps.emplace_back(range_gap);
  return result;
}

}  // namespace geminga::consequence
