// All ways on which one participant is heard, and who may open another one.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_WAYS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_WAYS_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "discovery/membership/neighbour_way.hpp"

namespace geminga::membership {

class NeighbourWays {
 public:
  [[nodiscard]] const std::vector<NeighbourWay>& all() const { return ways_; }
  [[nodiscard]] std::vector<NeighbourWay>& all() { return ways_; }

  /// The way that a datagram came on, from whatever address; null: there is none.
  [[nodiscard]] NeighbourWay* find(const announcement::Announcement& announcement, const Arrival& arrival);
  /// The same if the datagram is from the address that the way belongs to.
  [[nodiscard]] const NeighbourWay* find_bound(const announcement::Announcement& announcement,
                                               const Arrival& arrival) const;
  /// Opens a way for a datagram; null: nobody may, or there are max_paths. `hold`: a way that was heard within that
  /// time lives.
  [[nodiscard]] NeighbourWay* open(const announcement::Announcement& announcement, const Arrival& arrival,
                                   base::Duration hold, bool is_contested);
  /// The address that a way belongs to has spoken: whether ways were closed that somebody has opened in its name.
  bool close_later(const NeighbourWay& way, const Arrival& arrival);

  /// Of the one that loses least. 1: there is none that was measured; 0: there is none at all.
  [[nodiscard]] double loss() const;
  /// Whether so many datagrams were heard on one of them that its loss means something.
  [[nodiscard]] bool is_loss_known() const;

 private:
  /// A way that somebody wants to open.
  struct Opening {
    env::InterfaceIndex interface{};
    std::uint32_t link = 0;
    std::string source;
    std::uint64_t sequence = 0;
  };
  [[nodiscard]] bool may_open(const announcement::Announcement& announcement, const Arrival& arrival,
                              base::Duration hold, bool is_contested);

  std::vector<NeighbourWay> ways_;  ///< by interface and link
  std::optional<Opening> opening_;
  bool was_misled_ = false;  ///< a way was opened beside another one that went on speaking
};

}  // namespace geminga::membership

#endif
