// Which hosts hear which: what is cut, and which links are in a burst of loss.
#ifndef GEMINGA_TESTS_SIM_LINKS_HPP
#define GEMINGA_TESTS_SIM_LINKS_HPP

#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "sim/air.hpp"

namespace geminga::sim {

/// A link is one direction between two hosts, by their numbers.
class Links {
 public:
  /// `to` hears nothing of `from` any more, whoever else does.
  void cut(std::uint32_t from, std::uint32_t to) { at(from, to).is_cut = true; }
  void mend(std::uint32_t from, std::uint32_t to) { at(from, to).is_cut = false; }
  [[nodiscard]] bool is_cut(std::uint32_t from, std::uint32_t to) const;
  /// Draws whether the next datagram is lost in a burst.
  [[nodiscard]] bool is_lost_in_burst(std::uint32_t from, std::uint32_t to, const Air& air, base::Random& random);

 private:
  struct Link {
    bool is_cut = false;
    bool is_in_burst = false;
  };
  Link& at(std::uint32_t from, std::uint32_t to);

  std::vector<std::vector<Link>> links_;  ///< by sender, by receiver
};

}  // namespace geminga::sim

#endif
