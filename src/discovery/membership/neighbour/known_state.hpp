// The known state of a participant: its revision, and whether that is known in whole.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_KNOWN_STATE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_KNOWN_STATE_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour/rising_count.hpp"
#include "discovery/membership/neighbour/state_assembly.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// The believed revision of one participant's state, and the services of a revision that is known in whole.
class KnownState {
 public:
  KnownState(std::uint64_t revision, base::Instant now) : revision_(revision), said_(revision), rises_(revision, now) {}

  /// The revision that is believed.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The last revision of which a state was heard.
  [[nodiscard]] std::uint64_t said() const { return said_; }
  /// The last revision that was known in whole; 0: none.
  [[nodiscard]] std::uint64_t held() const { return held_; }
  /// Whether the believed revision is known in whole.
  [[nodiscard]] bool is_complete() const { return is_complete_; }
  /// The services of a revision that is known in whole; null: it is not.
  [[nodiscard]] const std::vector<ServiceNumber>* services() const { return is_complete_ ? &services_ : nullptr; }
  /// When a datagram last proved that a complete revision still holds.
  [[nodiscard]] base::Instant affirmed() const { return affirmed_; }
  /// Whether a lower revision comes too late to have been overtaken.
  [[nodiscard]] bool is_late(std::uint64_t revision, base::Instant now) const { return rises_.is_late(revision, now); }
  /// Whether somebody else seems to have a newer state.
  [[nodiscard]] bool is_suspected() const { return is_suspected_; }

  void say(std::uint64_t revision) { said_ = revision; }
  void set_suspected(bool is_suspected) { is_suspected_ = is_suspected; }
  /// Believes a revision. Returns whether it is another one, which is not known in whole.
  bool believe(std::uint64_t revision, base::Instant now) {
    if (revision == revision_) return false;
    if (revision < revision_) rises_.restart(revision, now);
    rises_.rise(revision, now);
    revision_ = revision;
    is_complete_ = false;
    return true;
  }
  /// Takes in all services of the believed revision.
  const std::vector<ServiceNumber>& complete(std::vector<ServiceNumber> services) {
    is_complete_ = true;
    return services_ = std::move(services);
  }
  /// Completes the believed revision by a change of the one that was known in whole. Returns whether there was room.
  bool complete_by(const announcement::Announcement& change) {
    if (!update_services(services_, change)) return false;
    is_complete_ = true;
    return true;
  }
  /// Takes in that the complete revision still holds.
  void affirm(base::Instant now) {
    affirmed_ = now;
    held_ = revision_;
  }
  /// Takes in testimony that the complete revision held at that instant.
  void affirm_seen(base::Instant seen) { affirmed_ = seen; }
  /// Forgets the services, because somebody has lied about them.
  void forget() {
    is_complete_ = false;
    services_.clear();
  }

 private:
  std::uint64_t revision_;
  std::uint64_t said_;
  RisingCount rises_;  ///< when the believed revision and those before it were first heard
  bool is_complete_ = false;
  bool is_suspected_ = false;
  std::uint64_t held_ = 0;
  std::vector<ServiceNumber> services_;
  base::Instant affirmed_;
};

}  // namespace geminga::membership

#endif
