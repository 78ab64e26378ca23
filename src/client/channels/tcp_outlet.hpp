// The outlet of a publisher over TCP: it listens, and a connection becomes a consumer by its hello.
#ifndef GEMINGA_CLIENT_CHANNELS_TCP_OUTLET_HPP
#define GEMINGA_CLIENT_CHANNELS_TCP_OUTLET_HPP

#include <cstdint>
#include <map>
#include <optional>

#include "client/channels/publisher_channel.hpp"
#include "client/protocol/frame_reader.hpp"
#include "client/protocol/places.hpp"
#include "client/protocol/send_queue.hpp"

namespace geminga::client {

class TcpOutlet : public PublisherChannel {
 public:
  [[nodiscard]] static std::expected<std::unique_ptr<PublisherChannel>, std::string> open(
      ChannelHost& host, ChannelNumber number, Life life, NamedPublication& publication);

  [[nodiscard]] bool has_room(std::size_t payload_bytes) const override;
  void finish() override;
  [[nodiscard]] bool is_finished() const override { return is_closed_ && connections_.empty(); }
  /// The octets of frames that wait for all consumers.
  [[nodiscard]] std::size_t waiting_octets() const { return waiting_.octets(); }

 private:
  enum class Role : std::uint8_t {
    stranger,  ///< not a consumer's yet
    consumer,
    leaving,  ///< gets the frames that wait for it and nothing more
  };
  struct Connection {
    Socket socket;
    PeerAddress from;
    Reactor::Watch watch{};
    FrameReader reader{greeting_bytes};  ///< a consumer says no more than a hello
    SendQueue queue{};
    Life life = no_life;  ///< of its hello
    std::uint64_t challenge = 0;
    std::uint64_t cookie = 0;          ///< that it has to say; 0: none
    std::uint64_t counter = 0;         ///< of its last sealed frame
    bool is_proved = false;            ///< its hello was sealed
    bool has_greeted = false;          ///< its hello is accepted
    bool was_told_slow = false;        ///< the program knows that messages to it are left out
    base::Instant took = base::never;  ///< the instant at which it took something of what waits
    Role role = Role::stranger;
    Places::Number place = 0;  ///< of a consumer
    bool has_ended = false;    ///< everything is written and our half is closed
    base::Instant until = base::never;
  };
  /// Ordered as the connections came.
  using Number = Places::Number;

  TcpOutlet(ChannelHost& host, ChannelNumber number, Life life, ChannelMode mode);

  [[nodiscard]] bool has_consumer() const override { return consumer_connections_ > 0; }
  [[nodiscard]] std::size_t max_payload() const override { return max_stream_payload; }
  void transmit(std::span<const std::byte> payload) override;
  void on_keys(bool seals_newly) override;
  [[nodiscard]] Counterparts::Carrier carrier_of(Counterparts::Number consumer) const override;
  void on_consumer(Counterparts::Number consumer) override;
  void on_consumer_gone(Counterparts::Number consumer, bool is_final) override;
  [[nodiscard]] bool is_reached(Counterparts::Number consumer) const override;

  void accept_all();
  void add(Socket socket);
  void on_ready(Number connection, Reactor::Ready ready);
  /// Reads a connection. False if it is gone.
  bool read(Number connection);
  bool take(Number connection, const ReadFrame& frame);
  /// Takes the hello of a stranger. False if it is none that is believed.
  bool greet(Number connection, const Frame& hello, std::optional<std::uint64_t> counter);
  /// Takes the sealed hello of a consumer that was asked for it, because its first one was plain.
  void prove(Connection& connection, const ReadFrame& hello);
  bool write(Number connection);
  bool become_consumer(Number connection);
  /// Queues a floor, a full or an end.
  void put(Number connection, FrameKind kind, std::span<const std::byte> payload);
  void put_greeting(Number connection, FrameKind kind, std::uint64_t cookie);
  /// Closes consumers that take nothing until no more waits than may.
  void relieve();
  [[nodiscard]] std::optional<Number> consumer_of(Life life) const;
  /// Writes the frames that wait, and then closes.
  void leave(Number connection);
  void close(Number connection);
  /// Gives back the place of a stranger or a consumer.
  void leave_place(Number connection);
  /// Closes a connection that has failed, and tells the channel.
  void lose(Number connection, std::string_view reason = Counterparts::lost_reason);
  void set_deadline();

  ChannelMode mode_;
  Socket listener_;
  Reactor::Watch watch_;
  WaitingFrames waiting_;  ///< outlives the connections, which hold its frames
  std::map<Number, Connection> connections_;
  Places strangers_{max_strangers};
  Places consumer_places_{max_tcp_consumers};
  Crowding crowding_;
  std::size_t consumer_connections_ = 0;
  Number last_ = 0;
  Places::Number last_place_ = 0;
  std::vector<std::byte> opened_;  ///< room for the payload of a sealed frame
  Reactor::Timer deadline_;
  Reactor::Timer retry_;  ///< accepts again, after no descriptor was left
};

}  // namespace geminga::client

#endif
