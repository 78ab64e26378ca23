// The outlet of a publisher over TCP: it listens, and a connection becomes a consumer by its hello.
#ifndef GEMINGA_CLIENT_CHANNELS_TCP_OUTLET_HPP
#define GEMINGA_CLIENT_CHANNELS_TCP_OUTLET_HPP

#include <cstdint>
#include <map>
#include <optional>

#include "client/channels/publisher_channel.hpp"
#include "client/protocol/frame_reader.hpp"
#include "client/protocol/send_queue.hpp"

namespace geminga::client {

class TcpOutlet : public PublisherChannel {
 public:
  [[nodiscard]] static std::expected<std::unique_ptr<PublisherChannel>, std::string> open(
      ChannelHost& host, ChannelNumber number, Life life, NamedPublication& publication);

  [[nodiscard]] bool has_room(std::size_t payload_bytes) const override;
  void finish() override;
  [[nodiscard]] bool is_finished() const override { return is_closed_ && connections_.empty(); }

 private:
  enum class Role : std::uint8_t {
    stranger,  ///< not a consumer's yet
    consumer,
    leaving,  ///< gets the frames that wait for it and nothing more
  };
  struct Connection {
    Socket socket;
    Reactor::Watch watch;
    FrameReader reader{0};  ///< a consumer says no more than a hello
    SendQueue queue;
    Life life = no_life;  ///< of its hello
    Role role = Role::stranger;
    bool has_ended = false;  ///< everything is written and our half is closed
    base::Instant until = base::never;
  };
  /// Ordered as the connections came.
  using Number = std::uint64_t;

  TcpOutlet(ChannelHost& host, ChannelNumber number, Life life, ChannelMode mode);

  [[nodiscard]] bool has_consumer() const override { return consumer_connections_ > 0; }
  [[nodiscard]] std::size_t max_payload() const override { return max_stream_payload; }
  void transmit(const FrameHeader& header, std::span<const std::byte> payload) override;
  [[nodiscard]] Counterparts::Carrier carrier_of(Counterparts::Number consumer) const override;
  void on_consumer(Counterparts::Number consumer) override;
  void on_consumer_gone(Counterparts::Number consumer, bool is_final) override;
  [[nodiscard]] bool is_reached(Counterparts::Number consumer) const override;

  void accept_all();
  void on_ready(Number connection, Reactor::Ready ready);
  /// Reads a connection. False if it is gone.
  bool read(Number connection);
  bool take(Number connection, const Frame& frame);
  bool write(Number connection);
  bool become_consumer(Number connection);
  [[nodiscard]] std::optional<Number> consumer_of(Life life) const;
  /// Writes the frames that wait, and then closes.
  void leave(Number connection);
  void close(Number connection);
  /// Closes a connection that has failed, and tells the channel.
  void lose(Number connection);
  void set_deadline();

  ChannelMode mode_;
  Socket listener_;
  Reactor::Watch watch_;
  std::map<Number, Connection> connections_;
  std::size_t consumer_connections_ = 0;
  Number last_ = 0;
  Reactor::Timer deadline_;
  Reactor::Timer retry_;  ///< accepts again, after no descriptor was left
};

}  // namespace geminga::client

#endif
