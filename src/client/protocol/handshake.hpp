// A consumer's half of the handshake with one publisher (src/client/CHANNELS.md, The handshake).
#ifndef GEMINGA_CLIENT_PROTOCOL_HANDSHAKE_HPP
#define GEMINGA_CLIENT_PROTOCOL_HANDSHAKE_HPP

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

#include "base/time.hpp"
#include "client/protocol/frame.hpp"
#include "client/protocol/limits.hpp"

namespace geminga::client {

/// Knows when to say hello, and with which payload. Pure: the caller sends, and gives what was opened.
class Handshake {
 public:
  /// The next step after a floor.
  enum class Next : std::uint8_t {
    nothing,
    say_hello,  ///< at once, with the new cookie
    go_on,      ///< the hello has been accepted
  };

  Handshake(Life publisher, Life own, std::uint64_t challenge)
      : publisher_(publisher), own_(own), challenge_(challenge) {}

  /// The payload of the next hello, and of the end.
  [[nodiscard]] Greeting greeting() const { return {publisher_, challenge_, cookie_}; }
  /// A hello was said: the instant at which the next one is due.
  base::Instant said(base::Instant now) {
    const std::chrono::milliseconds wait = is_accepted_ ? hello_interval : wait_;
    if (!is_accepted_) wait_ = wait_ < last_hello_wait ? wait_ * 2 : hello_interval;
    return now + wait;
  }
  /// Takes a floor that was opened, or came without a key. `is_proved`: it was opened with a key.
  Next on_floor(const Frame& frame, bool is_proved) {
    const auto greeting = answer(frame);
    if (!greeting) return Next::nothing;
    if (is_proved && !floor_) floor_ = frame.sequence;
    if (greeting->cookie == 0) {
      is_accepted_ = true;
      was_refused_ = false;
      wait_ = first_hello_wait;
      return Next::go_on;
    }
    is_accepted_ = false;
    if (greeting->cookie == cookie_) return Next::nothing;
    cookie_ = greeting->cookie;
    return Next::say_hello;
  }
  /// Takes a full. True: the program is to be told that there is no place.
  bool on_full(const Frame& frame) {
    if (!answer(frame)) return false;
    if (is_accepted_) wait_ = hello_interval;
    is_accepted_ = false;
    return !std::exchange(was_refused_, true);
  }
  [[nodiscard]] bool is_accepted() const { return is_accepted_; }
  /// The sequence after which messages are believed that were opened with a key; nothing until a proved floor came.
  [[nodiscard]] const std::optional<std::uint64_t>& floor() const { return floor_; }

 private:
  /// The payload of a frame that answers this consumer's challenge.
  [[nodiscard]] std::optional<Greeting> answer(const Frame& frame) const {
    const auto greeting = read_greeting(frame.payload);
    return greeting && greeting->life == own_ && greeting->challenge == challenge_ ? greeting : std::nullopt;
  }

  Life publisher_;
  Life own_;
  std::uint64_t challenge_;
  std::uint64_t cookie_ = 0;
  std::chrono::milliseconds wait_ = first_hello_wait;
  bool is_accepted_ = false;
  bool was_refused_ = false;
  std::optional<std::uint64_t> floor_;
};

}  // namespace geminga::client

#endif
