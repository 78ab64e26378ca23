// What a node states to its daemons: each publication and subscription, and what became of it.
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

/// Session keep their numbers while daemons come and go. What a daemon is asked is followed by a ping, whose answer
/// settles it. Pure: what is to be said goes to `say`, which is told whether there is a daemon.
class Session {
 public:
  using Stated = std::variant<NamedPublication, NamedSubscription>;
  using Change = std::variant<PublicationChange, SubscriptionChange>;
  enum class State : std::uint8_t {
    asked,     ///< no daemon has answered yet
    accepted,  ///< one has taken it
    refused,   ///< one has refused it, or taken it back: it is not stated again
  };
  struct Request {
    Stated stated;
    State state = State::asked;
    std::optional<Error> refusal{};      ///< of the request
    std::optional<Error> last_change{};  ///< why the last change that was settled was refused
    std::uint32_t open_changes = 0;
  };
  /// What an answer of the daemon settled.
  struct Settled {
    ChannelNumber number = 0;
    std::optional<Error> error;  ///< nothing: accepted
    bool is_change = false;
    bool is_news = false;  ///< the program is to be told
  };
  using Say = std::function<void(const gcnp::Statement&)>;

  explicit Session(Say say) : say_(std::move(say)) {}

  /// Why a daemon would not even read it; nothing where it would.
  [[nodiscard]] static std::optional<Error> fault(const Stated& stated);

  /// A number that nobody has.
  [[nodiscard]] ChannelNumber next_number() { return ++last_; }
  void create(ChannelNumber number, Stated stated);
  /// The error is a change that cannot be written or read. Requires that the request is there and not refused.
  [[nodiscard]] std::expected<void, Error> modify(ChannelNumber number, const Change& change);
  void remove(ChannelNumber number);

  /// A daemon is there: it is asked for everything that was not refused.
  void on_up();
  /// It is gone; changes that it did not answer go with the request to the next one.
  void on_down();
  /// `0 msg pong`
  std::vector<Settled> on_pong();
  /// `N EEE text`. Nothing where it belongs to something that was asked, and comes with its pong.
  [[nodiscard]] std::optional<Settled> on_error(ChannelNumber number, const Error& error);

  [[nodiscard]] const Request* find(ChannelNumber number) const;

 private:
  struct Asked {
    ChannelNumber number = 0;
    std::optional<Stated> changed;  ///< what it is after the change, where it is one
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
