#include "sim/links.hpp"

namespace geminga::sim {

bool Links::is_cut(std::uint32_t from, std::uint32_t to) const {
  return from < links_.size() && to < links_[from].size() && links_[from][to].is_cut;
}

bool Links::is_lost_in_burst(std::uint32_t from, std::uint32_t to, const Air& air, base::Random& random) {
  Link& link = at(from, to);
  // In the long run a share of air.burst is in the bad state: it is left as often as it is entered.
  const double ends = 1 / air.burst_length;
  const double begins = ends * air.burst / (1 - air.burst);
  if (random.chance(link.is_in_burst ? ends : begins)) link.is_in_burst = !link.is_in_burst;
  return link.is_in_burst;
}

Links::Link& Links::at(std::uint32_t from, std::uint32_t to) {
  if (links_.size() <= from) links_.resize(from + 1);
  if (links_[from].size() <= to) links_[from].resize(to + 1);
  return links_[from][to];
}

}  // namespace geminga::sim
