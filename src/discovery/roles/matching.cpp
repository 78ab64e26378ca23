#include "discovery/roles/matching.hpp"

#include <utility>

namespace geminga::roles {
namespace {

/// One shortest augmenting path after the other; places and robots are counted from 1, and 0 is nobody.
class Hungarian {
 public:
  Hungarian(std::size_t places, std::size_t robots, const std::vector<Cost>& costs)
      : robots_(robots),
        costs_(costs),
        of_place_(places + 1),
        of_robot_(robots + 1),
        place_of_(robots + 1),
        before_(robots + 1) {}

  /// Whether this place and all before it have a robot.
  bool fill(std::size_t place) {
    place_of_[0] = place;
    std::vector<Cost> least(robots_ + 1, forbidden);
    std::vector<bool> is_reached(robots_ + 1);
    std::size_t at = 0;
    do {
      is_reached[at] = true;
      const std::size_t from = place_of_[at];
      Cost step = forbidden;
      std::size_t next = 0;
      for (std::size_t robot = 1; robot <= robots_; ++robot) {
        if (is_reached[robot]) continue;
        const Cost cost = costs_[(from - 1) * robots_ + robot - 1];
        if (cost != forbidden && cost - of_place_[from] - of_robot_[robot] < least[robot]) {
          least[robot] = cost - of_place_[from] - of_robot_[robot];
          before_[robot] = at;
        }
        if (least[robot] < step) {
          step = least[robot];
          next = robot;
        }
      }
      if (next == 0) return false;
      for (std::size_t robot = 0; robot <= robots_; ++robot) {
        if (is_reached[robot]) {
          of_place_[place_of_[robot]] += step;
          of_robot_[robot] -= step;
        } else if (least[robot] != forbidden) {
          least[robot] -= step;
        }
      }
      at = next;
    } while (place_of_[at] != 0);
    for (; at != 0; at = before_[at]) place_of_[at] = place_of_[before_[at]];
    return true;
  }

  [[nodiscard]] Matching matching(std::size_t places) const {
    Matching found{.robot_of = std::vector<std::uint32_t>(places),
                   .price_of_place = {of_place_.begin() + 1, of_place_.end()},
                   .price_of_robot = {of_robot_.begin() + 1, of_robot_.end()}};
    for (std::size_t robot = 1; robot <= robots_; ++robot) {
      if (place_of_[robot] == 0) continue;
      found.robot_of[place_of_[robot] - 1] = static_cast<std::uint32_t>(robot - 1);
      found.cost += costs_[(place_of_[robot] - 1) * robots_ + robot - 1];
    }
    return found;
  }

 private:
  std::size_t robots_;
  const std::vector<Cost>& costs_;
  std::vector<Cost> of_place_;  ///< potentials
  std::vector<Cost> of_robot_;
  std::vector<std::size_t> place_of_;
  std::vector<std::size_t> before_;  ///< the robot before this one on the path
};

}  // namespace

std::optional<Matching> cheapest_matching(std::size_t places, std::size_t robots, const std::vector<Cost>& costs) {
  Hungarian hungarian(places, robots, costs);
  for (std::size_t place = 1; place <= places; ++place) {
    if (!hungarian.fill(place)) return std::nullopt;
  }
  return hungarian.matching(places);
}

}  // namespace geminga::roles
