// Collects the parts of a participant's state on one way, until all parts of a revision were heard.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_STATE_ASSEMBLY_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_STATE_ASSEMBLY_HPP

#include <bitset>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "discovery/announcement/announcement.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

/// The number of a service within its participant.
struct ServiceNumber {
  PeerId peer{};
  std::uint32_t number = 0;
  friend auto operator<=>(const ServiceNumber&, const ServiceNumber&) = default;
};

/// Applies a change to a list in ascending order. Returns whether it has at most max_services_per_participant then.
bool update_services(std::vector<ServiceNumber>& services, const announcement::Announcement& change);

/// Collects the parts of the newest revision. Each way has its own, because a state is split differently where other
/// addresses are valid.
class StateAssembly {
 public:
  /// Takes in a part. Returns whether it completes the revision, once for each revision.
  bool add(const announcement::Announcement& part);
  /// The services of the complete revision, withheld ones included, in ascending order.
  [[nodiscard]] const std::vector<ServiceNumber>& services() const { return services_; }
  /// Forgets what was collected.
  void clear();

 private:
  bool has_begun_ = false;
  bool is_overfull_ = false;
  std::uint64_t revision_ = 0;
  std::uint32_t part_count_ = 0;
  std::bitset<announcement::max_parts> parts_;
  std::vector<ServiceNumber> services_;
};

}  // namespace geminga::membership

#endif
