// Who is believed to be at the other end: the providers of a subscriber, or the consumers of a publisher.
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

/// What the daemon says makes a counterpart matched or takes it back; what is only lost out of sight goes on as an
/// orphan (src/client/CHANNELS.md, How a channel ends). A counterpart is known by its life; one without by its service
/// key. Pure: the time is given, and nothing is opened here. Lookups are logarithmic, the rest is linear in the
/// counterparts.
class Counterparts {
 public:
  /// Names a counterpart for as long as it is here; never used again.
  using Number = std::uint64_t;

  enum class State : std::uint8_t {
    matched,    ///< the daemon says so
    doubted,    ///< the daemon that said so is gone, or its next one has not said it yet
    orphaned,   ///< the daemons have lost sight of it
    finishing,  ///< withdrawn; it may still write what waits
  };
  /// Why a counterpart is gone where no daemon has said it.
  static constexpr std::string_view disconnected_reason = "disconnected";
  static constexpr std::string_view lost_reason = "lost";
  static constexpr std::string_view refused_reason = "refused";

  struct Counterpart {
    Life life = no_life;
    ServiceKey key;
    State state = State::matched;
    base::Instant until = base::never;  ///< then it is over
    std::string reason{};               ///< why it is not matched any more
  };
  struct Added {
    Number number = 0;
    bool is_new = false;  ///< else it is the same as before, or went on
  };
  /// What is to be done about a counterpart that the daemon does not match any more.
  enum class Parting : std::uint8_t { none, close, finish, go_on };
  struct Parted {
    Number number = 0;
    Parting parting = Parting::none;
  };
  /// What carries the channel of a counterpart, which decides how long it outlives its match.
  enum class Carrier : std::uint8_t {
    datagrams,
    connection,     ///< one that lives
    no_connection,  ///< one that is not there
  };

  /// `add` or `modify` of an event.
  Added add(Life life, const ServiceKey& key);
  /// `del` of an event. Forgets the counterpart where it is to be closed.
  Parted del(const ServiceKey& key, std::string_view reason, Carrier carrier, base::Instant now);
  /// The number of whom a key names, so that del() can be told its carrier.
  [[nodiscard]] std::optional<Number> find(const ServiceKey& key) const;
  [[nodiscard]] std::optional<Number> find(Life life) const;

  /// The own daemon is gone: everybody is doubted, and their keys mean nothing any more.
  void doubt();
  /// A daemon is back and has had its time: whoever is doubted still becomes an orphan. The carriers are asked for by
  /// `carrier_of`; gives those who are over at once.
  template <typename CarrierOf>
  std::vector<Number> settle(const CarrierOf& carrier_of, base::Instant now) {
    std::vector<Number> over;
    for (auto& [number, counterpart] : counterparts_) {
      if (counterpart.state != State::doubted) continue;
      if (!orphan(counterpart, disconnected_reason, carrier_of(number), now)) over.push_back(number);
    }
    return over;
  }
  /// The orphans, where `limit` others are matched; nobody where the limit is 0.
  [[nodiscard]] std::vector<Number> superfluous(std::uint32_t limit) const;
  /// Those whose time is over.
  [[nodiscard]] std::vector<Number> expired(base::Instant now) const;
  /// When the next one's time is over.
  [[nodiscard]] base::Instant next_end() const;

  /// Somebody who is finishing has given a sign of life.
  void go_on_finishing(Number number, base::Instant now);
  void erase(Number number);
  [[nodiscard]] const Counterpart& at(Number number) const { return counterparts_.at(number); }
  [[nodiscard]] const std::map<Number, Counterpart>& all() const { return counterparts_; }
  [[nodiscard]] bool contains(Number number) const { return counterparts_.contains(number); }

 private:
  /// False where there is nothing that could go on.
  static bool orphan(Counterpart& counterpart, std::string_view reason, Carrier carrier, base::Instant now);

  std::map<Number, Counterpart> counterparts_;
  std::map<Life, Number> by_life_;  ///< of those who have one
  std::map<ServiceKey, Number> by_key_;
  Number last_ = 0;
};

}  // namespace geminga::client

#endif
