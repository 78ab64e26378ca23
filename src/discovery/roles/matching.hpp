// The cheapest way to give each of some places a robot of its own.
#ifndef GEMINGA_DISCOVERY_ROLES_MATCHING_HPP
#define GEMINGA_DISCOVERY_ROLES_MATCHING_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace geminga::roles {

using Cost = std::int64_t;
/// The cost of a robot that cannot have the place.
inline constexpr Cost forbidden = Cost{1} << 62;

/// Prices prove that no other matching is cheaper (linear duality): no cost is less than the price of its place and
/// that of its robot together, and where the place has the robot it is as much. Robots that have no place have the
/// price 0, the others 0 or less. Places of equal costs have equal prices.
struct Matching {
  std::vector<std::uint32_t> robot_of;  ///< by place
  std::vector<Cost> price_of_place;
  std::vector<Cost> price_of_robot;
  Cost cost = 0;
};

/// `costs[place * robots + robot]` is not negative, and `forbidden` where the robot does not suit. Nothing if not all
/// places can be filled. The Hungarian method with potentials (Kuhn 1955, Munkres 1957): places * places * robots
/// steps.
[[nodiscard]] std::optional<Matching> cheapest_matching(std::size_t places, std::size_t robots,
                                                        const std::vector<Cost>& costs);

}  // namespace geminga::roles

#endif
