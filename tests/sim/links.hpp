// Which hosts hear which: what is cut, and which receivers are in a burst of loss.
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
  /// Whether a receiver is in a burst now, in which it hears nothing. Time must not fall from call to call.
  [[nodiscard]] bool is_in_burst(std::uint32_t to, base::Instant now, const Air& air, base::Random& random);

 private:
  struct Link {
    bool is_cut = false;
  };
  /// Whether it is in a burst, and until when that holds.
  struct Receiver {
    bool is_in_burst = true;  // the first stay begins with a change
    base::Instant until{};
  };
  Link& at(std::uint32_t from, std::uint32_t to);

  std::vector<std::vector<Link>> links_;  ///< by sender, by receiver
  std::vector<Receiver> receivers_;
};

}  // namespace geminga::sim

#endif
