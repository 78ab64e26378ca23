// The C++ client: one connection to the local daemon, to offer services, ask for them and be told.
#ifndef GEMINGA_CLIENT_HPP
#define GEMINGA_CLIENT_HPP

#include <chrono>
#include <cstdint>
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

/// Where the daemon is and who is calling.
struct ClientOptions {
  /// `ADDRESS:PORT` or `[ADDRESS]:PORT`, the address in numbers; or the path of a Unix socket, as `/PATH` or
  /// `unix:PATH`. Empty: the environment variable GEMINGA_CONNECT, and where that is empty 127.0.0.1:4717 and then
  /// [::1]:4717.
  std::string connect;
  /// The peer's name as others see it, e.g. "vision": at most 64 octets without `/` and `,`. Empty: none.
  std::string name;
  /// How long connecting may take, and how long an answer.
  std::chrono::milliseconds timeout = std::chrono::seconds(5);
  /// How many subscriptions to streams it needs beside the 256 that every client may have
  /// (src/discovery/gcnp/GCNP.md, Room); at most 16384. 0: none.
  std::uint32_t room = 0;
};

/// Why a call of the client failed. `text` is one line that says what is wrong and what to do.
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
  ErrorCode code = ErrorCode::malformed;  ///< what the daemon said; for refused only
};

/// What the daemon says about itself and this client when they meet.
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
/// A client does not connect again by itself: after `closed` everything that it was told of is in doubt. A program that
/// makes a new client and states its requests again has, by the time that these calls return, been sent the events of
/// all that is there; what it knew and was not told of again is gone.
///
/// A call that waits for the daemon (all but poll() and next_event() with events waiting) takes one round trip on the
/// local host; events that come meanwhile are kept for next_event(), at most max_waiting_events of them.
class Client {
 public:
  /// Events that are kept while nobody takes them; one more closes the connection, as the daemon would.
  static constexpr std::size_t max_waiting_events = 65'536;

  /// Connects and says hello. Errors: wrong_use, unreachable, timed_out, refused.
  [[nodiscard]] static Result<Client, ClientError> connect(const ClientOptions& options = {});

  Client(Client&&) noexcept;
  Client& operator=(Client&&) noexcept;
  ~Client();

  /// What the daemon said when it was met.
  [[nodiscard]] const Welcome& welcome() const;

  /// Offers a service. Returns the number that stands in its events and that modify() and withdraw() take.
  [[nodiscard]] Result<std::uint32_t, ClientError> publish(const NamedPublication& publication);
  /// Asks for a service; its events follow.
  [[nodiscard]] Result<std::uint32_t, ClientError> subscribe(const NamedSubscription& subscription);
  /// Changes what publish() or subscribe() stated; refused changes change nothing.
  [[nodiscard]] Result<void, ClientError> modify(std::uint32_t request, const PublicationChange& change);
  [[nodiscard]] Result<void, ClientError> modify(std::uint32_t request, const SubscriptionChange& change);
  /// Ends one publication or subscription.
  [[nodiscard]] Result<void, ClientError> withdraw(std::uint32_t request);

  /// The next event, in the order of the daemon; waits for it up to `timeout`, and returns nothing if none came.
  [[nodiscard]] Result<std::optional<Event>, ClientError> next_event(std::chrono::milliseconds timeout);
  /// The next event if there is one already; never waits.
  [[nodiscard]] Result<std::optional<Event>, ClientError> poll();
  /// For a program's own poll() or select(): readable when something came. Before waiting on it call poll() until it
  /// gives nothing, since events may be kept here already. Owned by the client.
  [[nodiscard]] int file_descriptor() const;

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
