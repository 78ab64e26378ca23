// The gaps of a closure: the parts of an ontology that the calculus cannot use fully, as users are told.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_GAPS_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_GAPS_HPP

#include <string_view>

namespace geminga::consequence {

/// The gaps. The first four are about facts alone. If there is no other gap, the subsumers of named classes are
/// complete as long as the facts are consistent, which is then undecided unless is_consistent is false.
inline constexpr std::string_view fact_gap = "facts about properties, together with alternatives";
inline constexpr std::string_view key_gap = "owl:hasKey";
inline constexpr std::string_view rule_gap = "swrl:Imp";
inline constexpr std::string_view apart_gap = "many individuals that differ from each other";
inline constexpr std::string_view nominal_gap = "owl:oneOf, owl:hasValue";
inline constexpr std::string_view range_gap = "data ranges that are more than datatypes and single values";
inline constexpr std::string_view alternative_gap = "classes with many alternatives";
inline constexpr std::string_view number_gap = "numbers of neighbours that are too great to write out";
inline constexpr std::string_view value_gap = "numbers of values of finite data ranges";

}  // namespace geminga::consequence

#endif
