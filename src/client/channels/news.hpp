// News for the program: events, and messages of its subscribers.
#ifndef GEMINGA_CLIENT_CHANNELS_NEWS_HPP
#define GEMINGA_CLIENT_CHANNELS_NEWS_HPP

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "client/channels/channel_host.hpp"
#include "client/channels/log.hpp"
#include "client/channels/reactor.hpp"
#include "client/protocol/session.hpp"

namespace geminga::client {

/// Keeps events until they are taken, and which subscribers have got messages; the messages themselves stay with their
/// channels. The program takes both itself, or gives functions for them. Neither copies nor moves.
class News {
 public:
  using OnEvent = std::function<void(const ChannelEvent&)>;
  using OnMessage = std::function<void(Message)>;
  /// Takes the next message of a subscriber; nothing where there is none.
  using Take = std::function<std::optional<Message>(ChannelNumber)>;

  /// Borrows both for its life.
  News(Reactor& reactor, Log& log) : reactor_(reactor), log_(log), reminder_(reactor, [] {}) {}

  /// Keeps an event, at most max_waiting_events: then the eldest is thrown away.
  void tell(ChannelEvent event);
  /// A message has come for a subscriber.
  void on_message(ChannelNumber channel);
  /// A subscriber has ended.
  void forget(ChannelNumber channel);

  /// The next event that was not taken. If events were thrown away, the first one is a Problem of channel 0 with their
  /// number.
  [[nodiscard]] std::optional<ChannelEvent> next_event();
  /// Gives further events, or messages of a subscriber, to these functions in hand_out(); to none if it is empty.
  void on_events(OnEvent on_event) { on_event_ = std::move(on_event); }
  void on_messages(ChannelNumber number, OnMessage on_message);
  /// Calls the functions of the program. Whether a message or an event has come since the last call.
  bool hand_out(const Take& take);

  /// Whether messages or events have come for which the program has not looked since.
  [[nodiscard]] bool is_any() const { return !unseen_.empty(); }
  /// The program has looked for a message of this subscriber; or 0: for an event.
  void has_looked(ChannelNumber number) { unseen_.erase(number); }
  /// The program is about to look for everything.
  void will_look() { unseen_.clear(); }
  /// Makes the descriptor readable until the next Reactor::process(), if there are any.
  void remind() {
    if (is_any()) reminder_.set(reactor_.now());
  }

 private:
  Reactor& reactor_;
  Log& log_;
  std::deque<ChannelEvent> events_;
  std::uint64_t lost_events_ = 0;  ///< thrown away since the program was last told
  OnEvent on_event_;
  std::map<ChannelNumber, OnMessage> on_message_;
  bool has_event_come_ = false;
  std::vector<ChannelNumber> ready_;  ///< subscribers that have got a message
  std::set<ChannelNumber> unseen_;    ///< subscribers with news, and 0 for events
  Reactor::Timer reminder_;
};

}  // namespace geminga::client

#endif
