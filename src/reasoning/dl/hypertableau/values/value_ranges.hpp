// The values of data ranges: datatypes, facets, enumerations, and defined datatypes.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_VALUE_RANGES_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_VALUE_RANGES_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/values/value_set.hpp"

namespace geminga::hypertableau {

/// Larger enumerations, and restrictions by more facets, are not worked out.
inline constexpr std::size_t max_enumerated_values = 20'000;
inline constexpr std::size_t max_facets = 1000;

/// A set of which two bounds are known: it has all values of `least` and no value outside of `most`.
struct KnownSet {
  ValueSet least;
  ValueSet most;
  /// Why they differ; empty: they do not.
  std::string reason;
};

/// The sets of the data ranges of one source. A facet that is not worked out (a pattern, a language range) leaves the
/// set between nothing and the set that it restricts; so does a datatype that is not in the OWL 2 datatype map.
class ValueRanges {
 public:
  ValueRanges(const owl::Ontology& source, const clauses::ClauseSet& set);

  [[nodiscard]] const KnownSet& known_set(clauses::DataRangeId range);
  /// Whether it is a datatype that is neither of OWL 2 nor defined. It is taken to have values.
  [[nodiscard]] bool is_unknown_datatype(clauses::DataRangeId range) const;
  /// Gives a value to a literal that is in no source.
  void set_value(owl::TermId literal, const Value& value) { literals_.insert_or_assign(literal, value); }
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
