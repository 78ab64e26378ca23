// The constructs that an axiom may be left out for, by the names that users know.
#ifndef GEMINGA_REASONING_OWL_CONSTRUCT_HPP
#define GEMINGA_REASONING_OWL_CONSTRUCT_HPP

#include <cstdint>
#include <string_view>

namespace geminga::owl {

/// Why an axiom, or a part of it, is not used. `none`: all of it is.
enum class Construct : std::uint8_t {
  none,
  union_of,
  complement_of,
  one_of,
  all_values_from,
  min_cardinality,
  max_cardinality,
  inverse_of,
  functional,
  inverse_functional,
  symmetric,
  asymmetric,
  disjoint_properties,
  top_property,
  has_key,
  disjoint_union_of,
  range_over_chain,
  datatype_restriction,
  datatype_complement,
  datatype_union,
  too_many_nominals,
  finite_datatype,
  too_many_merged,
  overlapping_datatypes,
  inexact_literal,
  max_cardinality_not_simple,
  functional_not_simple,
  inverse_functional_not_simple,
  irreflexive_not_simple,
  self_not_simple,
  rule,
};

[[nodiscard]] std::string_view to_string(Construct construct);

}  // namespace geminga::owl

#endif
