// The room for remote services: a reserve for every participant, and a pool that is shared fairly.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SERVICE_ROOM_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SERVICE_ROOM_HPP

#include <cstddef>
#include <cstdint>

namespace geminga::membership {

class NeighbourServices;

/// Asked for more room in the pool when it is full.
class ServiceRoom {
 public:
  explicit ServiceRoom(bool tells_affirmed) : tells_affirmed_(tells_affirmed) {}
  virtual ~ServiceRoom() = default;

  /// Whether what is heard again is told again.
  [[nodiscard]] bool tells_affirmed() const { return tells_affirmed_; }

  /// Takes room for one more service of a participant that has `count`; false: there is none, and it was counted.
  [[nodiscard]] bool take(const NeighbourServices& who, std::size_t count);
  /// Gives back the room of one service of a participant that has `count`, itself included.
  void give(std::size_t count);

  [[nodiscard]] std::uint64_t refused() const { return refused_; }
  void refuse() { ++refused_; }

  std::size_t withdrawn = 0;  ///< services that are remembered though they are withdrawn

 protected:
  /// Makes somebody with more than its share give up one service, which gives back its room.
  virtual bool make_room(const NeighbourServices& who) = 0;

 private:
  bool tells_affirmed_;
  std::size_t pool_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace geminga::membership

#endif
