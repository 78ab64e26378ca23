// Messages that wait to be taken by the program.
#ifndef GEMINGA_CLIENT_CHANNELS_INBOX_HPP
#define GEMINGA_CLIENT_CHANNELS_INBOX_HPP

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

#include "client/channels/limits.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// Full at either limit: nothing more is read then, so that nothing has to be thrown away.
class Inbox {
 public:
  [[nodiscard]] bool is_full() const {
    return messages_.size() >= max_waiting_messages || octets_ >= max_waiting_octets;
  }
  [[nodiscard]] bool is_empty() const { return messages_.empty(); }
  void put(Message message) {
    octets_ += message.payload.size();
    messages_.push_back(std::move(message));
  }
  std::optional<Message> take() {
    if (messages_.empty()) return std::nullopt;
    std::optional<Message> message(std::move(messages_.front()));
    messages_.pop_front();
    octets_ -= message->payload.size();
    return message;
  }

 private:
  std::deque<Message> messages_;
  std::size_t octets_ = 0;
};

}  // namespace geminga::client

#endif
