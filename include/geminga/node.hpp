// A program's half of the team: it publishes and subscribes, and messages flow, while daemons come and go.
#ifndef GEMINGA_NODE_HPP
#define GEMINGA_NODE_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "geminga/channel.hpp"
#include "geminga/client.hpp"
#include "geminga/named.hpp"
#include "geminga/result.hpp"

namespace geminga {

class Node;
class NodeState;

/// Whether a call waits until the daemon has answered.
enum class Wait : std::uint8_t {
  for_answer,   ///< as long as there is a daemon; where there is none it is asked later
  for_nothing,  ///< the answer is an event: Accepted or Refused
};

/// Offers one service and sends to whoever consumes it. Withdraws it at its end. Moves and does not copy; must end
/// before its node.
class Publisher {
 public:
  Publisher(Publisher&& other) noexcept;
  Publisher& operator=(Publisher&& other) noexcept;
  ~Publisher();

  /// Sends to every consumer. Never waits: a TCP consumer that does not keep up is left out until it has room, which
  /// count() and its own sequence show. Without a consumer it costs next to nothing. Errors: too_large, closed.
  Result<void, SendError> send(std::span<const std::byte> payload);
  Result<void, SendError> send(std::string_view payload) {
    return send(std::as_bytes(std::span(payload.data(), payload.size())));
  }
  /// Whether every consumer has room for one more message of this size.
  [[nodiscard]] bool has_room(std::size_t payload_bytes) const;
  /// Waits until then; false where that took too long.
  [[nodiscard]] bool wait_for_room(std::size_t payload_bytes, std::chrono::milliseconds timeout);

  /// Names it in events.
  [[nodiscard]] ChannelNumber number() const { return number_; }
  /// The life that its messages carry.
  [[nodiscard]] Life life() const;
  [[nodiscard]] SendCount count() const;
  /// Changes what was stated but mode, protocol, port and address. Errors: wrong_use, refused.
  Result<void, ClientError> modify(const PublicationChange& change, Wait wait = Wait::for_answer);
  /// Writes what waits, says the end to the consumers, and withdraws. Waits until they have it; one that takes
  /// nothing for 5 s does not get the rest.
  void withdraw();
  /// The same without waiting: it goes on while the node is driven.
  void begin_withdraw();
  /// Whether that is over, or the daemon has refused the publication.
  [[nodiscard]] bool has_ended() const;

 private:
  friend Node;
  Publisher(NodeState& node, ChannelNumber number) : node_(&node), number_(number) {}
  NodeState* node_;
  ChannelNumber number_;
};

/// Asks for one service and receives from whoever provides it. Withdraws at its end. Moves and does not copy; must end
/// before its node.
class Subscriber {
 public:
  Subscriber(Subscriber&& other) noexcept;
  Subscriber& operator=(Subscriber&& other) noexcept;
  ~Subscriber();

  /// The next message; waits for it up to `timeout`, and gives nothing if none came.
  [[nodiscard]] std::optional<Message> receive(std::chrono::milliseconds timeout);
  /// The next message if there is one already; reads nothing.
  [[nodiscard]] std::optional<Message> poll();
  /// From now on messages go there, within Node::process() and whatever else drives the node.
  void on_message(std::function<void(Message)> receive);

  /// Names it in events.
  [[nodiscard]] ChannelNumber number() const { return number_; }
  [[nodiscard]] Life life() const;
  [[nodiscard]] ReceiveCount count() const;
  /// Changes what was stated but mode, protocols, port and address. Errors: wrong_use, refused.
  Result<void, ClientError> modify(const SubscriptionChange& change, Wait wait = Wait::for_answer);
  void withdraw();
  /// Whether it was withdrawn, or the daemon has refused the subscription.
  [[nodiscard]] bool has_ended() const;

 private:
  friend Node;
  Subscriber(NodeState& node, ChannelNumber number) : node_(&node), number_(number) {}
  NodeState* node_;
  ChannelNumber number_;
};

/// Everything of one program: a daemon, publishers and subscribers (src/client/CHANNELS.md). The daemon may come later,
/// end and come back: requests are stated again, and channels go on meanwhile.
///
/// Keeps no thread: bytes are moved within its calls and those of its channels. Who waits elsewhere polls descriptor()
/// and calls process(). Not thread-safe. Moves and does not copy; its end withdraws everything, as close() does.
class Node {
 public:
  /// Begins to look for the daemon and does not wait for it. Error: wrong_use, for an address that cannot be read.
  [[nodiscard]] static Result<Node, ClientError> open(const ClientOptions& options = {});

  Node(Node&&) noexcept;
  Node& operator=(Node&&) noexcept;
  ~Node();

  /// Offers a service; port 0 is any. Errors: wrong_use, also for a port that is taken; refused.
  [[nodiscard]] Result<Publisher, ClientError> publish(const NamedPublication& publication,
                                                       Wait wait = Wait::for_answer);
  /// Asks for a service; port 0 is any, and no protocols are udp and tcp. Errors as of publish().
  [[nodiscard]] Result<Subscriber, ClientError> subscribe(const NamedSubscription& subscription,
                                                          Conversions conversions = {}, Wait wait = Wait::for_answer);

  /// The next event; waits for it up to `timeout`. At most 4096 wait; one more takes the place of the eldest.
  [[nodiscard]] std::optional<ChannelEvent> next_event(std::chrono::milliseconds timeout = {});
  /// From now on events go there, within process() and whatever else drives the node. Who is told may call everything
  /// but what waits.
  void on_event(std::function<void(const ChannelEvent&)> tell);

  [[nodiscard]] bool is_connected() const;
  /// Readable when process() has something to do, and where another call has read messages or events that nobody has
  /// taken. What was there when process() was called does not make it readable: take it first. Owned by the node.
  [[nodiscard]] int descriptor() const;
  /// Does what is to be done and never waits.
  void process();
  /// Does what is to be done; where no message and no event comes of it, waits for more to do, so long at most.
  void wait(std::chrono::milliseconds timeout);
  /// Does what is to be done for so long, e.g. between two messages.
  void run_for(std::chrono::milliseconds duration);

  /// Withdraws everything cleanly: waits until consumers have what was sent, as Publisher::withdraw() does.
  void close();
  /// The same without waiting: it goes on while the node is driven, and is over when has_ended().
  void begin_close();
  [[nodiscard]] bool has_ended();

 private:
  explicit Node(std::unique_ptr<NodeState> state);
  std::unique_ptr<NodeState> state_;
};

}  // namespace geminga

#endif
