// Messages that wait until the program takes them (src/client/CHANNELS.md, A full inbox).
#ifndef GEMINGA_CLIENT_PROTOCOL_INBOX_HPP
#define GEMINGA_CLIENT_PROTOCOL_INBOX_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "client/protocol/limits.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// Full at either limit. A datagram that comes then takes the place of the eldest one; a stream is to be read no more.
/// The message behind one that was lost says so in `missed`. A put of a datagram into a full inbox is linear in what
/// waits, everything else is logarithmic in the lives of which messages were lost.
class Inbox {
 public:
  explicit Inbox(std::size_t max_messages = max_waiting_messages) : max_messages_(max_messages) {}

  [[nodiscard]] bool is_full() const { return waiting_.size() >= max_messages_ || octets_ >= max_waiting_octets; }
  [[nodiscard]] bool is_empty() const { return waiting_.empty(); }

  /// Keeps a message of a stream, which cannot be lost.
  void put_streamed(Message message) { put(std::move(message), false); }
  /// Keeps a message that came in a datagram. The result is how many messages are lost for it: the eldest datagrams, or
  /// the message itself where only streamed ones wait.
  std::size_t put_datagram(Message message) {
    std::size_t lost = 0;
    while (is_full()) {
      const auto eldest = std::ranges::find(waiting_, true, &Waiting::is_datagram);
      ++lost;
      if (eldest == waiting_.end()) {
        lose(message);
        return lost;
      }
      lose(eldest->message);
      octets_ -= eldest->message.payload.size();
      waiting_.erase(eldest);
    }
    put(std::move(message), true);
    return lost;
  }
  std::optional<Message> take() {
    if (waiting_.empty()) return std::nullopt;
    std::optional<Message> message(std::move(waiting_.front().message));
    waiting_.pop_front();
    octets_ -= message->payload.size();
    if (const auto lost = lost_.find(message->life); lost != lost_.end()) {
      message->missed += lost->second;
      lost_.erase(lost);
    }
    return message;
  }

 private:
  struct Waiting {
    Message message;
    bool is_datagram = false;
  };

  void put(Message message, bool is_datagram) {
    octets_ += message.payload.size();
    waiting_.push_back({std::move(message), is_datagram});
  }
  /// Adds up what the next message of this life has to say.
  void lose(const Message& message) {
    if (message.life == no_life) return;
    if (lost_.size() == max_remembered_lives && !lost_.contains(message.life)) lost_.erase(lost_.begin());
    lost_[message.life] += message.missed + 1;
  }

  std::size_t max_messages_;
  std::deque<Waiting> waiting_;
  std::size_t octets_ = 0;
  std::map<Life, std::uint64_t> lost_;  ///< since the last message of this life that was taken
};

}  // namespace geminga::client

#endif
