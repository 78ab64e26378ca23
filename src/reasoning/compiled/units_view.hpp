// The units of a compiled ontology, in place.
#ifndef GEMINGA_REASONING_COMPILED_UNITS_VIEW_HPP
#define GEMINGA_REASONING_COMPILED_UNITS_VIEW_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace geminga::compiled {

/// Arrays by unit, then by name. Names ascend by octets. All empty where there are no units.
struct UnitsView {
  /// For a unit that has no such name.
  static constexpr std::uint32_t none = 0xffffffff;

  std::span<const double> factor;
  std::span<const double> offset;
  std::span<const std::int8_t> dimension;  ///< owl::unit_base_count of each
  std::span<const std::uint32_t> alone;    ///< the unit of its own kind that it is a multiple of; or none
  std::span<const std::uint32_t> symbol;   ///< the name that it is usually written by; or none
  std::string_view text;
  std::span<const std::uint32_t> name_end;
  std::span<const std::uint32_t> unit_of_name;

  [[nodiscard]] std::size_t size() const { return factor.size(); }
  [[nodiscard]] std::string_view name(std::size_t at) const {
    const std::uint32_t begin = at == 0 ? 0 : name_end[at - 1];
    return text.substr(begin, name_end[at] - begin);
  }
  /// The unit whose name is `head` and `tail` together. O(log n), allocates nothing.
  [[nodiscard]] std::optional<std::uint32_t> find(std::string_view head, std::string_view tail = {}) const;
};

}  // namespace geminga::compiled

#endif
