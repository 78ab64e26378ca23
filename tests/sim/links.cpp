#include "sim/links.hpp"

namespace geminga::sim {

bool Links::is_cut(std::uint32_t from, std::uint32_t to) const {
  return from < links_.size() && to < links_[from].size() && links_[from][to].is_cut;
}

bool Links::is_in_burst(std::uint32_t to, base::Instant now, const Air& air, base::Random& random) {
  if (receivers_.size() <= to) receivers_.resize(to + 1);
  Receiver& receiver = receivers_[to];
  // Each stay is drawn evenly from nothing to twice its mean, in whole microseconds.
  const double burst = std::chrono::duration<double, std::micro>(air.burst_length).count();
  const auto length = static_cast<std::int64_t>(burst);
  const auto pause = static_cast<std::int64_t>(burst * (1 - air.burst) / air.burst);
  while (receiver.until <= now) {
    receiver.is_in_burst = !receiver.is_in_burst;
    const std::chrono::microseconds mean(receiver.is_in_burst ? length : pause);
    receiver.until += random.between(std::chrono::microseconds(1), 2 * mean + std::chrono::microseconds(1));
  }
  return receiver.is_in_burst;
}

Links::Link& Links::at(std::uint32_t from, std::uint32_t to) {
  if (links_.size() <= from) links_.resize(from + 1);
  if (links_[from].size() <= to) links_[from].resize(to + 1);
  return links_[from][to];
}

}  // namespace geminga::sim
