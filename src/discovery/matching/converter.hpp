// A service that turns one representation into another: what its attributes say (CONVERSIONS.md).
#ifndef GEMINGA_DISCOVERY_MATCHING_CONVERTER_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONVERTER_HPP

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

/// What `converts=FROM>TO` and `cost` say, by names.
struct StatedConversion {
  std::string from;
  std::string to;
  std::uint32_t cost = 1;  ///< 1 to owl::max_conversion_cost
  friend bool operator==(const StatedConversion&, const StatedConversion&) = default;
};

/// Whether the attributes are meant as those of a converter: `converts` has an arrow.
[[nodiscard]] bool is_converter(const Attributes& attributes);
/// The error says what cannot be read. Requires is_converter().
[[nodiscard]] std::expected<StatedConversion, std::string> stated_conversion(const Attributes& attributes);
/// Where a converter is, as Chain::via says it: "udp://10.0.0.7:6000/5e6f7a8b/2/1".
[[nodiscard]] std::string place_of(const registry::PublicationEntry& entry);
/// The step that a converter does; nothing where it is none, cannot be read, or names what the vocabulary does not know
/// or what can have no instance.
[[nodiscard]] std::optional<vocabulary::Step> step_of(const Attributes& attributes,
                                                      const vocabulary::Vocabulary& vocabulary);
/// Why the attributes of a converter are refused with 422; nothing where they are well, or it is none. Without an
/// ontology names are not looked up.
[[nodiscard]] std::optional<Error> check_conversion(const Attributes& attributes,
                                                    const vocabulary::Vocabulary& vocabulary);

}  // namespace geminga::matching

#endif
