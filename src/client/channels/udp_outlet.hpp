// The outlet of a publisher over UDP: it sends to each consumer, to each listener of a stream, or to a multicast group.
#ifndef GEMINGA_CLIENT_CHANNELS_UDP_OUTLET_HPP
#define GEMINGA_CLIENT_CHANNELS_UDP_OUTLET_HPP

#include <optional>
#include <vector>

#include "client/channels/publisher_channel.hpp"
#include "client/protocol/listeners.hpp"

namespace geminga::client {

class UdpOutlet : public PublisherChannel {
 public:
  [[nodiscard]] static std::expected<std::unique_ptr<PublisherChannel>, std::string> open(
      ChannelHost& host, ChannelNumber number, Life life, NamedPublication& publication);

  [[nodiscard]] bool has_room(std::size_t /*payload_bytes*/) const override { return !is_full_; }
  void finish() override;
  [[nodiscard]] bool is_finished() const override { return is_closed_; }

 private:
  UdpOutlet(ChannelHost& host, ChannelNumber number, Life life, const NamedPublication& publication);

  [[nodiscard]] bool has_consumer() const override;
  [[nodiscard]] std::size_t max_payload() const override { return max_datagram_payload; }
  void transmit(const FrameHeader& header, std::span<const std::byte> payload) override;
  [[nodiscard]] Counterparts::Carrier carrier_of(Counterparts::Number) const override {
    return Counterparts::Carrier::datagrams;
  }
  void on_consumer(Counterparts::Number consumer) override;
  void on_consumer_gone(Counterparts::Number consumer, bool is_final) override;
  [[nodiscard]] bool is_reached(Counterparts::Number) const override { return true; }

  std::expected<void, std::string> open_socket();
  void open_socket_of_first();
  void send_to(const PeerAddress& to, std::span<const iovec> parts, unsigned interface);
  /// Sends `framed`, or `plain` to consumers without a life; an empty `plain` is not sent.
  void send_to_all(std::span<const iovec> framed, std::span<const iovec> plain);
  void read();
  void take(const Frame& frame, const PeerAddress& from);
  void set_listener_timer() { silence_.set(listeners_.next_end()); }

  ChannelMode mode_;
  Binding binding_;
  std::optional<PeerAddress> group_;  ///< of a multicast stream
  std::vector<unsigned> interfaces_;  ///< through which it is sent
  base::Instant interfaces_until_{};
  std::size_t reachable_ = 0;  ///< consumers that state an address
  Socket socket_;
  Reactor::Watch watch_;
  bool is_full_ = false;           ///< the system takes no more datagrams for now
  std::vector<std::byte> copied_;  ///< room for a frame with a small payload
  Listeners listeners_;
  Reactor::Timer silence_;
};

}  // namespace geminga::client

#endif
