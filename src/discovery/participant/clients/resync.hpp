// A resync: how things stand for one request, told piece by piece to a peer that cannot be told all at once.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_RESYNC_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_RESYNC_HPP

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geminga/service.hpp"

namespace geminga::participant {

/// A list of keys that is gone through piece by piece. While a key waits in the list, its changes need no event: when
/// its turn comes, it is told as it is then. Changes of all other keys are told by events.
class Resync {
 public:
  [[nodiscard]] bool has_begun() const { return has_begun_; }
  /// `current` are told first, in their order; then `former`, which the peer knows and which may be gone.
  void begin(std::vector<ServiceKey> current, std::vector<ServiceKey> former) {
    has_begun_ = true;
    keys_ = std::move(current);
    keys_.insert(keys_.end(), former.begin(), former.end());
    waiting_.reserve(keys_.size());
    for (std::size_t place = 0; place < keys_.size(); ++place) waiting_.emplace_back(keys_[place], place);
    std::ranges::sort(waiting_);
  }
  /// The next key; nothing when all have been told.
  [[nodiscard]] std::optional<ServiceKey> next() {
    return next_ == keys_.size() ? std::nullopt : std::optional(keys_[next_++]);
  }
  /// Whether the key's turn is still to come.
  [[nodiscard]] bool will_tell(const ServiceKey& key) const {
    if (!has_begun_) return true;
    const auto found = std::ranges::lower_bound(waiting_, key, {}, &std::pair<ServiceKey, std::size_t>::first);
    return found != waiting_.end() && found->first == key && found->second >= next_;
  }

 private:
  bool has_begun_ = false;
  std::vector<ServiceKey> keys_;
  std::size_t next_ = 0;
  std::vector<std::pair<ServiceKey, std::size_t>> waiting_;  ///< with the position in keys_, sorted by key
};

}  // namespace geminga::participant

#endif
