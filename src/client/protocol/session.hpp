// The requests of a node: each publication and subscription, and the answers of the daemons to it.
#ifndef GEMINGA_CLIENT_PROTOCOL_SESSION_HPP
#define GEMINGA_CLIENT_PROTOCOL_SESSION_HPP

#include <cstdint>
#include <deque>
#include <expected>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "discovery/gcnp/statement.hpp"
#include "geminga/channel.hpp"
#include "geminga/named.hpp"

namespace geminga::client {

/// Session keep their numbers while daemons come and go. A ping follows each request; its answer settles the request.
/// Pure: the lines go to `say`; on_up() and on_down() tell whether there is a daemon.
class Session {
 public:
  using Stated = std::variant<NamedPublication, NamedSubscription>;
  using Change = std::variant<PublicationChange, SubscriptionChange>;
  enum class State : std::uint8_t {
    asked,     ///< no daemon has answered yet
    accepted,  ///< a daemon has accepted it
    refused,   ///< a daemon has refused it or taken it back; it is not stated again
  };
  struct Request {
    Stated stated;
    State state = State::asked;
    std::optional<Error> refusal{};      ///< of the request
    std::optional<Error> last_change{};  ///< why the last settled change was refused
    std::uint32_t open_changes = 0;
  };
  /// A request or change that an answer of the daemon has settled.
  struct Settled {
    ChannelNumber number = 0;
    std::optional<Error> error;  ///< nothing if it was accepted
    bool is_change = false;
    bool is_news = false;  ///< whether the program is to be told
  };
  using Say = std::function<void(const gcnp::Statement&)>;

  explicit Session(Say say) : say_(std::move(say)) {}

  /// The error that a daemon would find when it reads the request; nothing if it would find none.
  [[nodiscard]] static std::optional<Error> fault(const Stated& stated);

  /// The words of a request for a person: `mode=M IDENTITY` and what else it states, but for its life.
  [[nodiscard]] static std::string words(const Stated& stated);

  /// A number that no request has.
  [[nodiscard]] ChannelNumber next_number() { return ++last_; }
  void create(ChannelNumber number, Stated stated);
  /// Changes a request. The error is a change that cannot be written or read. Requires a request that is not refused.
  [[nodiscard]] std::expected<void, Error> modify(ChannelNumber number, const Change& change);
  void remove(ChannelNumber number);

  /// A daemon is there: states every request that was not refused.
  void on_up();
  /// The daemon is gone. Changes that it did not answer are part of the request for the next one.
  void on_down();
  /// Takes `0 msg pong`.
  std::vector<Settled> on_pong();
  /// Takes `N EEE text`. Nothing if it answers a request that waits for its pong, which will settle it.
  [[nodiscard]] std::optional<Settled> on_error(ChannelNumber number, const Error& error);

  [[nodiscard]] const Request* find(ChannelNumber number) const;

 private:
  struct Asked {
    ChannelNumber number = 0;
    std::optional<Stated> changed;  ///< the request after the change, if it is a change
    std::optional<Error> error{};
    bool has_ping = false;
  };

  void ask(ChannelNumber number, const gcnp::Statement& statement, std::optional<Stated> changed, bool has_ping);
  Settled settle(Asked asked);

  Say say_;
  std::map<ChannelNumber, Request> session_;
  std::deque<Asked> asked_;
  ChannelNumber last_ = 0;
  bool is_up_ = false;
};

}  // namespace geminga::client

#endif
