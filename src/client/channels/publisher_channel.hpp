// A publisher's half of a channel: its consumers, whatever carries their messages.
#ifndef GEMINGA_CLIENT_CHANNELS_PUBLISHER_CHANNEL_HPP
#define GEMINGA_CLIENT_CHANNELS_PUBLISHER_CHANNEL_HPP

#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "client/channels/channel_host.hpp"
#include "client/protocol/counterparts.hpp"
#include "client/protocol/places.hpp"
#include "client/protocol/sealed_frame.hpp"
#include "geminga/channel.hpp"
#include "geminga/named.hpp"
#include "geminga/result.hpp"

namespace geminga::client {

/// Events go to the host. Neither copies nor moves. Not thread-safe.
class PublisherChannel {
 public:
  /// Opens the sockets that are open from the beginning, and fills port and life into `publication`. The error is one
  /// line about a port or address that cannot be had.
  [[nodiscard]] static std::expected<std::unique_ptr<PublisherChannel>, std::string> open(
      ChannelHost& host, ChannelNumber number, NamedPublication& publication);
  virtual ~PublisherChannel() = default;
  PublisherChannel(const PublisherChannel&) = delete;
  PublisherChannel& operator=(const PublisherChannel&) = delete;

  /// Sends to every consumer; costs a comparison if there is none. Never waits.
  [[nodiscard]] Result<void, SendError> send(std::span<const std::byte> payload);
  /// Whether every consumer has room for one more message of this size.
  [[nodiscard]] virtual bool has_room(std::size_t payload_bytes) const = 0;
  [[nodiscard]] const SendCount& count() const { return count_; }
  [[nodiscard]] Life life() const { return life_; }

  /// Takes the keys of the own life. Until then nothing is sent or answered.
  void set_keys(ChannelKeys keys);
  /// Takes an event of the daemon about a consumer.
  void on_event(const ConsumerEvent& event);
  void on_daemon_gone() { counterparts_.doubt(); }
  /// The daemon is back and has had its time to confirm every consumer.
  void on_settled();
  /// The daemon has taken the request back.
  void on_refused();

  /// Writes what waits and sends the end. After it send() fails.
  virtual void finish() = 0;
  /// Whether finish() is complete, or its time is over.
  [[nodiscard]] virtual bool is_finished() const = 0;

 protected:
  struct Consumer {
    ConsumerEvent event;
    PeerAddress address;            ///< port 0: none
    bool was_told = false;          ///< whether the program was told of it
    bool has_greeted = false;       ///< its hello was accepted, over UDP
    std::uint64_t challenge = 0;    ///< of that hello
    std::uint64_t counter = 0;      ///< of its last sealed hello
    bool was_told_of_life = false;  ///< the program knows that its channel cannot be sealed
  };

  PublisherChannel(ChannelHost& host, ChannelNumber number, Life life);

  [[nodiscard]] virtual bool has_consumer() const = 0;
  [[nodiscard]] virtual std::size_t max_payload() const = 0;
  /// Sends a message with the present sequence_. Called where there are keys.
  virtual void transmit(std::span<const std::byte> payload) = 0;
  /// There are other keys. `seals_newly`: frames were plain until then.
  virtual void on_keys(bool seals_newly) = 0;
  [[nodiscard]] virtual Counterparts::Carrier carrier_of(Counterparts::Number consumer) const = 0;
  /// A consumer was added, or has another address.
  virtual void on_consumer(Counterparts::Number consumer) = 0;
  /// A consumer is gone. `is_final`: messages that wait are still sent to it.
  virtual void on_consumer_gone(Counterparts::Number consumer, bool is_final) = 0;
  /// Whether messages reach the consumer, so that the program is told of it.
  [[nodiscard]] virtual bool is_reached(Counterparts::Number consumer) const = 0;

  /// Messages reach the consumer from now on.
  void appear(Counterparts::Number consumer);
  /// The connection of a consumer has ended. A matched consumer may connect again; any other is gone.
  void vanish(Counterparts::Number consumer, std::string_view reason = Counterparts::lost_reason);
  /// Forgets a consumer and tells the program.
  void remove(Counterparts::Number consumer, std::string_view reason, bool is_final = false);
  [[nodiscard]] base::Instant now() const { return host_.reactor().now(); }
  [[nodiscard]] bool seals() const { return keys_ && keys_->sends_sealed(); }
  [[nodiscard]] bool takes_plain() const { return keys_ && keys_->takes_plain(); }
  /// Whether a consumer cannot be served because it states no life.
  [[nodiscard]] bool lacks_life(Counterparts::Number consumer) const;
  void problem(std::string text) { host_.tell(Problem{number_, std::move(text)}); }
  /// Tells that all places of this kind are taken, or are not any more, and states it.
  void tell_crowding(Crowding::News news, const Places& places, std::string_view kind);

  ChannelHost& host_;
  ChannelNumber number_;
  Life life_;
  std::optional<ChannelKeys> keys_;  ///< nothing: the daemon has not told them yet
  Sealer sealer_;
  std::uint64_t sequence_ = 0;
  bool is_closed_ = false;
  SendCount count_;
  Counterparts counterparts_;
  std::map<Counterparts::Number, Consumer> consumers_;

 private:
  void tell(ConsumerChange::What what, Counterparts::Number consumer, std::string_view reason);
  void set_timer() { timer_.set(counterparts_.next_end()); }

  Reactor::Timer timer_;
};

}  // namespace geminga::client

#endif
