// Names of attributes beside the keys of GCNP, so that a mistyped key is not taken for an attribute.
#ifndef GEMINGA_ATTRIBUTE_HPP
#define GEMINGA_ATTRIBUTE_HPP

#include <string>
#include <string_view>

#include "geminga/error.hpp"
#include "geminga/result.hpp"

namespace geminga {

/// The prefix that makes any name the name of an attribute: `attr.rate=33` states `rate`, `attr.where=left` states
/// `where`.
inline constexpr std::string_view attribute_prefix = "attr.";

/// The attribute that a user means by a word before `=`: the name behind `attr.`, or the word itself. The error, with
/// the likely meaning, is for a word that GCNP reserves, and for one that is a single slip away from a reserved one: a
/// letter wrong, missing, too many, of the other case, or swapped with its neighbour (src/discovery/gcnp/GCNP.md,
/// Attributes).
[[nodiscard]] Result<std::string, Error> attribute_name(std::string_view written);

}  // namespace geminga

#endif
