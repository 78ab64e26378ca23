// Teams that are switched on at one instant: how soon all know all, and what that takes.
#ifndef GEMINGA_TESTS_SCENARIOS_STARTS_HPP
#define GEMINGA_TESTS_SCENARIOS_STARTS_HPP

#include <cstdint>
#include <functional>
#include <string>

#include "base/time.hpp"
#include "scenarios/conditions.hpp"

namespace geminga::scenarios {

/// One start.
struct Start {
  std::uint64_t seed = 0;
  base::Duration took{};     ///< until all views were right; longest_start: they were not
  std::uint64_t octets = 0;  ///< that a host has sent until settled_after, with 42 of headers for each datagram
};

/// A start that takes longer is given up.
inline constexpr base::Duration longest_start = std::chrono::seconds(60);
/// The octets of a start are counted until then: whoever is late has asked, and copies that were due are out.
inline constexpr base::Duration settled_after = std::chrono::seconds(3);

/// Switches a team on. `tell`, which may be empty, gets a line for each datagram.
[[nodiscard]] Start measure_start(const Conditions& conditions,
                                  const std::function<void(const std::string& line)>& tell = {});

}  // namespace geminga::scenarios

#endif
