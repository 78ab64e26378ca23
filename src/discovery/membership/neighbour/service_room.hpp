// The room for remote services: a reserve for every participant, and a pool that is shared fairly.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_SERVICE_ROOM_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_SERVICE_ROOM_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "discovery/membership/neighbour/offer.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// Counts the services of all participants. Its owner says who gives up a service when the pool is full.
class ServiceRoom {
 public:
  ServiceRoom() = default;
  ServiceRoom(const ServiceRoom&) = delete;
  ServiceRoom& operator=(const ServiceRoom&) = delete;
  virtual ~ServiceRoom() = default;

  /// Takes room for one more service of a participant that has `count`. False: there is none, which is counted.
  [[nodiscard]] bool take(ParticipantId asks, std::size_t count);
  /// Gives back the room of one service of a participant that has `count`, this one included.
  void give(std::size_t count);

  /// Takes room to remember a withdrawn service; false: there is none.
  [[nodiscard]] bool remember_withdrawn();
  void forget_withdrawn() { --withdrawn_; }

  /// Services that found no room.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }
  void refuse() { ++refused_; }

  /// The offers that this table shares with others of the process; null: it shares none.
  [[nodiscard]] Offers* offers() const { return offers_.get(); }
  void set_offers(std::shared_ptr<Offers> offers) { offers_ = std::move(offers); }

 protected:
  /// Another datagram is taken in. Within one datagram no more room is looked for once none was found.
  void begin_datagram() { is_exhausted_ = false; }
  /// Makes a participant with more than its share give up one service, which gives back its room.
  virtual bool make_room(ParticipantId asks) = 0;

 private:
  std::size_t pool_ = 0;
  std::size_t withdrawn_ = 0;
  std::uint64_t refused_ = 0;
  bool is_exhausted_ = false;
  std::shared_ptr<Offers> offers_;  ///< owned by all tables that share them
};

}  // namespace geminga::membership

#endif
