// The channels whose keys one peer was told.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_TOLD_KEYS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_TOLD_KEYS_HPP

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

#include "geminga/life.hpp"

namespace geminga::participant {

/// Channels of one session whose keys are remembered as told. At one more all are forgotten, and told again when they
/// are due: a client takes keys that it has as no change.
inline constexpr std::size_t max_told_channels = 4096;

class ToldKeys {
 public:
  /// Notes whether the peer asks for the keys of its channels. Whether it begins to.
  bool ask(bool asks) {
    const bool was_asked_for = std::exchange(is_asked_for_, asks);
    return asks && !was_asked_for;
  }
  [[nodiscard]] bool is_asked_for() const { return is_asked_for_; }
  /// Whether the peer was ever given a key.
  [[nodiscard]] bool has_any() const { return has_any_; }

  [[nodiscard]] bool has(std::uint32_t request, Life life) const { return channels_.contains({request, life}); }
  void add(std::uint32_t request, Life life) {
    has_any_ = true;
    if (channels_.size() == max_told_channels) channels_.clear();
    channels_.emplace(request, life);
  }
  /// A request of the peer is over.
  void forget(std::uint32_t request) {
    std::erase_if(channels_, [request](const auto& one) { return one.first == request; });
  }
  /// All are to be told anew.
  void clear() { channels_.clear(); }

 private:
  bool is_asked_for_ = false;
  bool has_any_ = false;
  std::set<std::pair<std::uint32_t, Life>> channels_;  ///< by request
};

}  // namespace geminga::participant

#endif
