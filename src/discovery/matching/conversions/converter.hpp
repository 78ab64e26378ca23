// The attributes of a converter: a service that turns one representation into another (CONVERSIONS.md).
#ifndef GEMINGA_DISCOVERY_MATCHING_CONVERSIONS_CONVERTER_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONVERSIONS_CONVERTER_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

#include "discovery/registry/entry.hpp"
#include "geminga/error.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

inline constexpr std::string_view converts_attribute = "converts";
inline constexpr std::string_view conversion_cost_attribute = "cost";

/// The conversion that `converts=FROM>TO` and `cost` state, by names.
struct StatedConversion {
  std::string from;
  std::string to;
  std::uint32_t cost = 1;  ///< 1 to owl::max_conversion_cost
  friend bool operator==(const StatedConversion&, const StatedConversion&) = default;
};

/// Whether these are attributes of a converter: `converts` has an arrow.
[[nodiscard]] bool is_converter(const Attributes& attributes);
/// Reads the attributes of a converter. The error says what cannot be read. Requires is_converter().
[[nodiscard]] std::expected<StatedConversion, std::string> stated_conversion(const Attributes& attributes);
/// The address of a converter, as in Chain::via: "udp://10.0.0.7:6000/5e6f7a8b/2/1".
[[nodiscard]] std::string place_of(const registry::PublicationEntry& entry);
/// The step that a converter does; nothing where it is no converter, cannot be read, or names a class that the
/// vocabulary does not know or that can have no instance.
[[nodiscard]] std::optional<vocabulary::Step> step_of(const Attributes& attributes,
                                                      const vocabulary::Vocabulary& vocabulary);
/// The error of attributes of a converter that are refused with 422; nothing where they are valid, or it is no
/// converter. Without an ontology names are not looked up.
[[nodiscard]] std::optional<Error> check_conversion(const Attributes& attributes,
                                                    const vocabulary::Vocabulary& vocabulary);

}  // namespace geminga::matching

#endif
