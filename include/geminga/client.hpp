// A client of the local daemon: it offers services, asks for them, and receives events about them.
#ifndef GEMINGA_CLIENT_HPP
#define GEMINGA_CLIENT_HPP

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geminga/error.hpp"
#include "geminga/event.hpp"
#include "geminga/named.hpp"
#include "geminga/result.hpp"
#include "geminga/service.hpp"

namespace geminga {

/// The daemon to connect to, and the name of the calling program.
struct ClientOptions {
  /// `ADDRESS:PORT` or `[ADDRESS]:PORT` with a numeric address, or the path of a Unix socket, as `/PATH` or
  /// `unix:PATH`. Empty: the environment variable GEMINGA_CONNECT; if that is empty, too, 127.0.0.1:4717 and then
  /// [::1]:4717.
  std::string connect;
  /// The peer's name as others see it, e.g. "vision": at most 64 octets without `/` and `,`. Empty: none.
  std::string name;
  /// The longest time for connecting, and for an answer.
  std::chrono::milliseconds timeout = std::chrono::seconds(5);
  /// The number of subscriptions to streams that the program needs beside the 256 of every client
  /// (src/discovery/gcnp/GCNP.md, Room); at most 16384. 0: none.
  std::uint32_t room = 0;
  /// Of a Node: takes each line that says what it waits for and what was refused, without an end. Empty: lines go to
  /// standard error, with `geminga: ` before them. Called within the calls of the node.
  std::function<void(std::string_view line)> log{};
};

/// The reason why a call failed. `text` is one line that says what is wrong and what to do.
struct ClientError {
  enum class Kind : std::uint8_t {
    wrong_use,    ///< an address that cannot be read, a request that is not there
    unreachable,  ///< nobody listens there, or it is no daemon
    closed,       ///< the daemon ended or closed the connection; the client cannot be used any more
    timed_out,    ///< no answer in time; the client cannot be used any more
    refused,      ///< the daemon refused the request and said why; everything else goes on
  };
  Kind kind = Kind::wrong_use;
  std::string text;
  ErrorCode code = ErrorCode::malformed;  ///< the code of the daemon, for refused only
};

/// The daemon's answer to the hello: who it is, and who the client is.
struct Welcome {
  ParticipantId participant{};
  PeerId peer{};
  std::string participant_name;
  std::string ontology;  ///< digest of the daemon's ontology in hexadecimal digits, or "-"
};

/// One line of an answer, e.g. one service. Fields stand in the order of the answer
/// (src/discovery/participant/QUERIES.md).
struct Record {
  std::string kind;
  std::vector<std::pair<std::string, std::string>> fields;
  Attributes attributes;  ///< of a service or request

  /// The value of a field, or an empty view.
  [[nodiscard]] std::string_view operator[](std::string_view key) const;
};

/// The whole answer of a query.
struct Answer {
  std::vector<Record> records;
  Record end;  ///< fields about the answer as a whole, e.g. `subsumed`
};

/// A connection to the local daemon. Everything offered and asked for ends with it: the destructor withdraws all.
/// Moves but does not copy. Keeps no thread: bytes are read within its calls only. Not thread-safe.
///
/// A client does not connect again by itself: after `closed` all events so far are in doubt. A program then makes a new
/// client and states its requests again. When these calls return, the events of all that is there have been sent; a
/// service of which no event came is gone.
///
/// A call that waits for the daemon (all but poll() and next_event() with events waiting) takes one round trip on the
/// local host. Events that come meanwhile are kept for next_event(), at most max_waiting_events of them.
class Client {
 public:
  /// The most events that wait to be taken; one more closes the connection, as the daemon would do.
  static constexpr std::size_t max_waiting_events = 65'536;

  /// Connects and says hello. Errors: wrong_use, unreachable, timed_out, refused.
  [[nodiscard]] static Result<Client, ClientError> connect(const ClientOptions& options = {});

  Client(Client&&) noexcept;
  Client& operator=(Client&&) noexcept;
  ~Client();

  /// The daemon's answer to the hello.
  [[nodiscard]] const Welcome& welcome() const;

  /// Offers a service. Returns the number that stands in its events and that modify() and withdraw() take.
  [[nodiscard]] Result<std::uint32_t, ClientError> publish(const NamedPublication& publication);
  /// Asks for a service; its events follow.
  [[nodiscard]] Result<std::uint32_t, ClientError> subscribe(const NamedSubscription& subscription);
  /// Changes a publication or a subscription. A refused change changes nothing.
  [[nodiscard]] Result<void, ClientError> modify(std::uint32_t request, const PublicationChange& change);
  [[nodiscard]] Result<void, ClientError> modify(std::uint32_t request, const SubscriptionChange& change);
  /// Ends one publication or subscription.
  [[nodiscard]] Result<void, ClientError> withdraw(std::uint32_t request);

  /// The next event, in the order of the daemon, for which it waits up to `timeout`. Nothing if none comes.
  [[nodiscard]] Result<std::optional<Event>, ClientError> next_event(std::chrono::milliseconds timeout);
  /// The next event that is here already. Never waits.
  [[nodiscard]] Result<std::optional<Event>, ClientError> poll();
  /// The descriptor for a program's own poll(2) or select(2): readable when something came. Call poll() until it gives
  /// nothing before you wait on the descriptor, because events may be kept here already. Owned by the client.
  [[nodiscard]] int file_descriptor() const;

  /// Says what the participant of this host is: a class or a class expression, and attributes, which are added to those
  /// that there are. Without an expression that stays; an empty one ends the description. It stays when this client
  /// ends.
  [[nodiscard]] Result<void, ClientError> describe(const std::optional<std::string>& expression,
                                                   const Attributes& attributes = {});

  /// Asks `query KIND key=value...`. An error of the daemon is `refused` with its code.
  [[nodiscard]] Result<Answer, ClientError> query(
      std::string_view kind, const std::vector<std::pair<std::string, std::string>>& parameters = {});

 private:
  class State;
  explicit Client(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace geminga

#endif
