// The values of data ranges: datatypes, facets, enumerations, defined datatypes, and datatypes of which nothing is
// known.
//
// A datatype that is neither of OWL 2 nor defined is a name for some set of values, and a literal of it is a name for
// some value in that set. An ontology entails what holds for every such set, so a model may choose the set, too: it is
// a predicate over values. Its values are told from those outside of it by nothing but inequality.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_VALUE_RANGES_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_VALUE_RANGES_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/values/value_set.hpp"

namespace geminga::hypertableau {

/// Larger enumerations, and restrictions by more facets, are not worked out.
inline constexpr std::size_t max_enumerated_values = 20'000;
inline constexpr std::size_t max_facets = 1000;

/// A set of values that a model may choose: those of a datatype of which nothing is known, or the value of a literal of
/// such a datatype; or all other values.
struct OpaqueSet {
  owl::TermId term{};
  bool is_complement = false;
  friend auto operator<=>(const OpaqueSet&, const OpaqueSet&) = default;
};

/// A set of which two bounds are known: it has all values of `least` and no value outside of `most`, as far as they are
/// in each of the opaque sets.
struct KnownSet {
  ValueSet least;
  ValueSet most;
  /// Why they differ; empty: they do not.
  std::string reason;
  std::vector<OpaqueSet> opaque = {};  ///< ascending

  [[nodiscard]] static KnownSet exactly(const ValueSet& set) { return {set, set, {}}; }
  /// Makes it the intersection with another set.
  void restrict_to(const KnownSet& other);
  /// Makes it the union with another set.
  void extend_by(const KnownSet& other);
  [[nodiscard]] KnownSet complement() const;

 private:
  /// The bounds without the opaque sets.
  void forget_opaque();
};

/// The sets of the data ranges of one source. A facet that is not worked out (a pattern, a language range) leaves the
/// set between nothing and the set that it restricts.
class ValueRanges {
 public:
  ValueRanges(const owl::Ontology& source, const clauses::ClauseSet& set);

  [[nodiscard]] const KnownSet& known_set(clauses::DataRangeId range);
  /// Whether all ranges of the set are known, of each value, and none is opaque.
  [[nodiscard]] bool are_all_known();
  /// The literal of a range of its one value; nothing of other ranges.
  [[nodiscard]] std::optional<owl::TermId> literal_of(std::uint32_t range) const;
  /// Gives a value to a literal that is in no source.
  void set_value(owl::TermId literal, const Value& value) { literals_.insert_or_assign(literal, value); }
  /// The set of the value of a literal, or of all other values.
  [[nodiscard]] KnownSet set_of_literal(owl::TermId literal, bool is_complement = false);
  [[nodiscard]] bool is_literal(owl::TermId term) const { return source_.kind(term) == owl::TermKind::literal; }
  /// Of a literal; its value is kept.
  [[nodiscard]] const std::optional<Value>& value(owl::TermId literal);

 private:
  /// `depth` bounds definitions that define each other in a circle.
  KnownSet evaluate(owl::TermId term, unsigned depth);
  KnownSet datatype(owl::TermId term, unsigned depth);
  KnownSet enumeration(const owl::Term& term);
  KnownSet restriction(const owl::Term& term, unsigned depth);
  /// The values of the base type that a facet allows.
  std::optional<ValueSet> facet(std::string_view name, owl::TermId value);

  const owl::Ontology& source_;
  const clauses::ClauseSet& set_;
  std::unordered_map<owl::TermId, owl::TermId> definitions_;
  std::unordered_map<std::uint32_t, KnownSet> known_;
  std::unordered_map<owl::TermId, KnownSet> evaluated_;
  std::unordered_map<owl::TermId, std::optional<Value>> literals_;
};

}  // namespace geminga::hypertableau

#endif
