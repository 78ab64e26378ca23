// The counterparts of a channel: the providers of a subscriber, or the consumers of a publisher.
#ifndef GEMINGA_CLIENT_PROTOCOL_COUNTERPARTS_HPP
#define GEMINGA_CLIENT_PROTOCOL_COUNTERPARTS_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/time.hpp"
#include "geminga/channel.hpp"
#include "geminga/service.hpp"

namespace geminga::client {

/// The daemon's events match a counterpart or take it back. One that the daemons have only lost sight of goes on as an
/// orphan (src/client/CHANNELS.md, How a channel ends). A counterpart is known by its life, or by its service key if it
/// has none. Pure: the caller gives the time and owns the sockets. Lookups are logarithmic, the rest is linear in the
/// counterparts.
class Counterparts {
 public:
  /// A counterpart's number in this object. It is never used again.
  using Number = std::uint64_t;

  enum class State : std::uint8_t {
    matched,    ///< the daemon matches it
    doubted,    ///< the daemon that matched it is gone, and the next one has not confirmed it
    orphaned,   ///< the daemons have lost sight of it
    finishing,  ///< withdrawn; messages of it may be on their way
  };
  /// Reasons for the end of a counterpart that no daemon has given.
  static constexpr std::string_view disconnected_reason = "disconnected";
  static constexpr std::string_view lost_reason = "lost";
  static constexpr std::string_view refused_reason = "refused";

  struct Counterpart {
    Life life = no_life;
    ServiceKey key;
    State state = State::matched;
    base::Instant until = base::never;  ///< the instant at which it is over
    std::string reason{};               ///< why it is not matched
  };
  struct Added {
    Number number = 0;
    bool is_new = false;  ///< false: it continues
  };
  /// The caller's task after the daemon has taken a counterpart back.
  enum class Parting : std::uint8_t { none, close, finish, go_on };
  struct Parted {
    Number number = 0;
    Parting parting = Parting::none;
  };
  /// The carrier of a channel, which decides how long the channel outlives its match.
  enum class Carrier : std::uint8_t {
    datagrams,
    connection,     ///< a connection that is open
    no_connection,  ///< a connection that is not open
  };

  /// `add` or `modify` of an event.
  Added add(Life life, const ServiceKey& key);
  /// `del` of an event. Forgets the counterpart where it is to be closed.
  Parted del(const ServiceKey& key, std::string_view reason, Carrier carrier, base::Instant now);
  /// The key of a counterpart names another life, though its own life may only have got another key. False if there is
  /// no channel that could go on.
  bool lose_sight(Number number, std::string_view reason, Carrier carrier, base::Instant now);
  /// The number of the counterpart with this key, for the `carrier` of del().
  [[nodiscard]] std::optional<Number> find(const ServiceKey& key) const;
  [[nodiscard]] std::optional<Number> find(Life life) const;

  /// The own daemon is gone: all counterparts that have not ended are doubted, and their keys are void.
  void doubt();
  /// A daemon is back and has had its time: counterparts that it has not confirmed become orphans. The result is those
  /// that are over at once, by their carriers.
  template <typename CarrierOf>
  std::vector<Number> settle(const CarrierOf& carrier_of, base::Instant now) {
    std::vector<Number> over;
    for (auto& [number, counterpart] : counterparts_) {
      if (counterpart.state != State::doubted) continue;
      if (!orphan(counterpart, disconnected_reason, carrier_of(number), now)) over.push_back(number);
    }
    return over;
  }
  /// The orphans, if `limit` counterparts are matched; none if the limit is 0.
  [[nodiscard]] std::vector<Number> superfluous(std::uint32_t limit) const;
  /// The counterparts whose time is over.
  [[nodiscard]] std::vector<Number> expired(base::Instant now) const;
  /// The next instant at which one is over.
  [[nodiscard]] base::Instant next_end() const;

  /// A frame came from a counterpart that is finishing: its time begins anew.
  void go_on_finishing(Number number, base::Instant now);
  void erase(Number number);
  [[nodiscard]] const Counterpart& at(Number number) const { return counterparts_.at(number); }
  [[nodiscard]] const std::map<Number, Counterpart>& all() const { return counterparts_; }
  [[nodiscard]] bool contains(Number number) const { return counterparts_.contains(number); }

 private:
  /// False if there is no channel that could go on.
  static bool orphan(Counterpart& counterpart, std::string_view reason, Carrier carrier, base::Instant now);

  std::map<Number, Counterpart> counterparts_;
  std::map<Life, Number> by_life_;  ///< of those that have one
  std::map<ServiceKey, Number> by_key_;
  Number last_ = 0;
};

}  // namespace geminga::client

#endif
