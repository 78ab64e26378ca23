// The subscriptions that have a publication among their candidates, and its ranks there.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONSIDERED_BY_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONSIDERED_BY_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>

#include "discovery/matching/arbitration/choice.hpp"

namespace geminga::matching {

/// Ranks by the slot of the subscription. No subscription of this host considers most publications of a large
/// team, so an empty one costs a pointer.
class ConsideredBy {
 public:
  using Ranks = std::map<std::uint32_t, Rank>;
  using iterator = Ranks::iterator;
  using const_iterator = Ranks::const_iterator;

  [[nodiscard]] iterator begin() { return ranks().begin(); }
  [[nodiscard]] iterator end() { return ranks().end(); }
  [[nodiscard]] const_iterator begin() const { return ranks().begin(); }
  [[nodiscard]] const_iterator end() const { return ranks().end(); }
  [[nodiscard]] iterator find(std::uint32_t slot) { return ranks().find(slot); }
  [[nodiscard]] const_iterator find(std::uint32_t slot) const { return ranks().find(slot); }
  [[nodiscard]] const_iterator lower_bound(std::uint32_t slot) const { return ranks().lower_bound(slot); }
  [[nodiscard]] bool contains(std::uint32_t slot) const { return ranks().contains(slot); }
  [[nodiscard]] bool empty() const { return ranks_ == nullptr; }
  [[nodiscard]] std::size_t size() const { return ranks().size(); }

  void emplace(std::uint32_t slot, const Rank& rank) {
    if (!ranks_) ranks_ = std::make_unique<Ranks>();
    ranks_->emplace(slot, rank);
  }
  void erase(iterator at) {
    ranks_->erase(at);
    if (ranks_->empty()) ranks_.reset();
  }
  void erase(std::uint32_t slot) {
    if (const auto at = find(slot); at != end()) erase(at);
  }
  void clear() { ranks_.reset(); }

 private:
  [[nodiscard]] Ranks& ranks() const {
    static Ranks none;
    return ranks_ ? *ranks_ : none;
  }

  std::unique_ptr<Ranks> ranks_;
};

}  // namespace geminga::matching

#endif
