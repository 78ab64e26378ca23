// A node: the publishers and subscribers of one program, which go on while its daemon is restarted.
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

/// Whether a call waits for the answer of the daemon.
enum class Wait : std::uint8_t {
  for_answer,   ///< if there is a daemon; if there is none, it is asked later
  for_nothing,  ///< the answer is an event: Accepted or Refused
};

/// Offers one service and sends to its consumers. The destructor withdraws the service. Moves and does not copy; must
/// end before its node.
class Publisher {
 public:
  Publisher(Publisher&& other) noexcept;
  Publisher& operator=(Publisher&& other) noexcept;
  ~Publisher();

  /// Sends to every consumer. Never waits: a TCP consumer that does not keep up is left out until it has room, which
  /// count() and the sequence of its next message show. Costs one comparison if there is no consumer. Errors:
  /// too_large, closed.
  Result<void, SendError> send(std::span<const std::byte> payload);
  Result<void, SendError> send(std::string_view payload) {
    return send(std::as_bytes(std::span(payload.data(), payload.size())));
  }
  /// Whether every consumer has room for one more message of this size.
  [[nodiscard]] bool has_room(std::size_t payload_bytes) const;
  /// Waits until has_room() holds. False if the timeout passes first.
  [[nodiscard]] bool wait_for_room(std::size_t payload_bytes, std::chrono::milliseconds timeout);

  /// The number that stands in events about it.
  [[nodiscard]] ChannelNumber number() const { return number_; }
  /// The life that its messages carry.
  [[nodiscard]] Life life() const;
  [[nodiscard]] SendCount count() const;
  /// Changes the publication. Mode, protocol, port and address cannot be changed. Errors: wrong_use, refused.
  Result<void, ClientError> modify(const PublicationChange& change, Wait wait = Wait::for_answer);
  /// Sends the messages that wait, tells the consumers the end, and withdraws the service. Waits until the consumers
  /// have all of it; one that takes nothing for 5 s does not get the rest.
  void withdraw();
  /// Begins to withdraw and does not wait: the rest happens while the program drives the node.
  void begin_withdraw();
  /// Whether the publisher is withdrawn altogether, or the daemon has refused it.
  [[nodiscard]] bool has_ended() const;

 private:
  friend Node;
  Publisher(NodeState& node, ChannelNumber number) : node_(&node), number_(number) {}
  NodeState* node_;
  ChannelNumber number_;
};

/// Asks for one service and receives from its providers. The destructor withdraws the request. Moves and does not copy;
/// must end before its node.
class Subscriber {
 public:
  Subscriber(Subscriber&& other) noexcept;
  Subscriber& operator=(Subscriber&& other) noexcept;
  ~Subscriber();

  /// The next message, for which it waits up to `timeout`. Nothing if none comes.
  [[nodiscard]] std::optional<Message> receive(std::chrono::milliseconds timeout);
  /// The next message that is here already. Reads no socket.
  [[nodiscard]] std::optional<Message> poll();
  /// Gives every further message to this function, within Node::process() and the other calls that drive the node.
  void on_message(std::function<void(Message)> receive);

  /// The number that stands in events about it.
  [[nodiscard]] ChannelNumber number() const { return number_; }
  [[nodiscard]] Life life() const;
  [[nodiscard]] ReceiveCount count() const;
  /// Changes the subscription. Mode, protocols, port and address cannot be changed. Errors: wrong_use, refused.
  Result<void, ClientError> modify(const SubscriptionChange& change, Wait wait = Wait::for_answer);
  void withdraw();
  /// Whether the subscriber was withdrawn, or the daemon has refused it.
  [[nodiscard]] bool has_ended() const;

 private:
  friend Node;
  Subscriber(NodeState& node, ChannelNumber number) : node_(&node), number_(number) {}
  NodeState* node_;
  ChannelNumber number_;
};

/// A program's connection to its daemon, with publishers and subscribers (src/client/CHANNELS.md). The daemon may start
/// later, end and come back: the node states its requests again, and channels go on meanwhile.
///
/// Starts no thread: bytes move within its calls and those of its channels. A program that waits elsewhere polls
/// descriptor() and calls process(). A subscriber's inbox holds 1024 messages or 16 MiB; a full one loses its eldest
/// datagram. Not thread-safe. Moves and does not copy. The destructor withdraws everything, as close() does.
class Node {
 public:
  /// Begins to look for the daemon and does not wait for it. Error: wrong_use for an address that cannot be read.
  [[nodiscard]] static Result<Node, ClientError> open(const ClientOptions& options = {});

  Node(Node&&) noexcept;
  Node& operator=(Node&&) noexcept;
  ~Node();

  /// Offers a service; port 0 is any. Errors: wrong_use, also for a port that is taken; refused.
  [[nodiscard]] Result<Publisher, ClientError> publish(const NamedPublication& publication,
                                                       Wait wait = Wait::for_answer);
  /// Asks for a service; port 0 is any, and an empty list of protocols means udp and tcp. Errors as of publish().
  [[nodiscard]] Result<Subscriber, ClientError> subscribe(const NamedSubscription& subscription,
                                                          Conversions conversions = {}, Wait wait = Wait::for_answer);

  /// The next event, for which it waits up to `timeout`. At most 4096 wait: one more takes the place of the eldest, and
  /// then the next event is a Problem of channel 0 that says how many were thrown away.
  [[nodiscard]] std::optional<ChannelEvent> next_event(std::chrono::milliseconds timeout = {});
  /// Gives every further event to this function, within process() and the other calls that drive the node. The function
  /// may call everything that does not wait.
  void on_event(std::function<void(const ChannelEvent&)> tell);

  /// Gives further lines of the log to this function in the place of ClientOptions::log.
  void on_log(std::function<void(std::string_view line)> write);

  [[nodiscard]] bool is_connected() const;
  /// A descriptor for poll(2): readable when process() has something to do, and when another call has read messages or
  /// events that the program has not taken. Messages that were here when process() was called do not make it readable:
  /// take them first. Owned by the node.
  [[nodiscard]] int descriptor() const;
  /// Reads and writes what is ready, and never waits.
  void process();
  /// As process(). If no message and no event comes of it, waits up to `timeout` for more to do.
  void wait(std::chrono::milliseconds timeout);
  /// Drives the node for so long, for example between two messages.
  void run_for(std::chrono::milliseconds duration);

  /// Withdraws everything cleanly, and waits until consumers have what was sent, as Publisher::withdraw() does.
  void close();
  /// Begins to close and does not wait: the rest happens while the program drives the node, until has_ended().
  void begin_close();
  [[nodiscard]] bool has_ended();

 private:
  explicit Node(std::unique_ptr<NodeState> state);
  std::unique_ptr<NodeState> state_;
};

}  // namespace geminga

#endif
