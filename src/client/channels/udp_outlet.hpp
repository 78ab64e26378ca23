// The outlet of a publisher over UDP: it sends to each consumer, to each listener of a stream, or to a multicast group.
#ifndef GEMINGA_CLIENT_CHANNELS_UDP_OUTLET_HPP
#define GEMINGA_CLIENT_CHANNELS_UDP_OUTLET_HPP

#include <optional>
#include <vector>

#include "client/channels/publisher_channel.hpp"
#include "client/protocol/answer_budget.hpp"
#include "client/protocol/cookies.hpp"
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
  /// A hello or an end of a consumer that was opened, or may come without a key.
  struct Word {
    Frame frame;
    Greeting greeting;
    std::optional<std::uint64_t> counter;  ///< of a sealed frame
    PeerAddress from;
  };

  UdpOutlet(ChannelHost& host, ChannelNumber number, Life life, const NamedPublication& publication);

  [[nodiscard]] bool has_consumer() const override;
  [[nodiscard]] std::size_t max_payload() const override { return max_datagram_payload; }
  void transmit(std::span<const std::byte> payload) override;
  void on_keys(bool seals_newly) override;
  [[nodiscard]] Counterparts::Carrier carrier_of(Counterparts::Number) const override {
    return Counterparts::Carrier::datagrams;
  }
  void on_consumer(Counterparts::Number consumer) override;
  void on_consumer_gone(Counterparts::Number consumer, bool is_final) override;
  [[nodiscard]] bool is_reached(Counterparts::Number consumer) const override;

  std::expected<void, std::string> open_socket();
  void open_socket_of_first();
  void open_hello_socket();
  /// Counts the consumers that messages are sent to.
  void count_reachable();
  /// Whether messages are sent to the consumer, from its hello on where they are sealed.
  [[nodiscard]] bool is_sent_to(Counterparts::Number number, const Consumer& consumer) const;
  void send_to(const PeerAddress& to, std::span<const iovec> parts, unsigned interface);
  /// Sends `framed`, or `plain` to consumers without a life; an empty `plain` is not sent.
  void send_to_all(std::span<const iovec> framed, std::span<const iovec> plain);
  void transmit_sealed(std::span<const std::byte> payload);

  void read(const Socket& socket);
  /// Whether the datagram is believed.
  bool take(std::span<const std::byte> datagram, const PeerAddress& from);
  bool take_end(const Word& word);
  bool take_hello(const Word& word);
  /// Whether the hello of a consumer needs no cookie, because it said one of the same kind.
  [[nodiscard]] bool renews(Counterparts::Number number, const Word& word) const;
  bool accept(const Word& word);
  /// Says a floor or a full, as long as the budget of answers allows it.
  void answer(FrameKind kind, const PeerAddress& to, const Greeting& greeting);
  /// Says the floor of a hello that was accepted already, as long as newcomers have enough of the budget.
  void renew(const PeerAddress& to, const Greeting& greeting);
  void say(FrameKind kind, const PeerAddress& to, const Greeting& greeting);
  void set_listener_timer();

  ChannelMode mode_;
  Binding binding_;
  std::optional<PeerAddress> group_;  ///< of a multicast stream
  std::vector<unsigned> interfaces_;  ///< through which it is sent
  base::Instant interfaces_until_{};
  std::size_t addressed_ = 0;  ///< consumers that state an address
  std::size_t reachable_ = 0;  ///< those of them that messages are sent to
  Socket socket_;
  Reactor::Watch watch_;
  Socket hello_socket_;  ///< of a sealed multicast stream
  Reactor::Watch hello_watch_;
  std::uint16_t hello_port_ = 0;
  bool is_full_ = false;           ///< the system takes no more datagrams for now
  std::vector<std::byte> copied_;  ///< room for a frame with a small payload, or for a sealed one
  std::vector<std::byte> opened_;  ///< room for the payload of a sealed frame
  Cookies cookies_;
  AnswerBudget answers_;
  Listeners listeners_;
  Crowding crowding_;
  Reactor::Timer silence_;
};

}  // namespace geminga::client

#endif
