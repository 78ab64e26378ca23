// The queue of bytes to one client: they come in at the end and go out at the front.
#ifndef GEMINGA_ENV_ASIO_SEND_QUEUE_HPP
#define GEMINGA_ENV_ASIO_SEND_QUEUE_HPP

#include <cstddef>
#include <string>
#include <string_view>

namespace geminga::env {

/// Holds at most about twice what waits, and almost nothing when nothing waits: sent bytes are dropped even if the
/// queue never runs empty. Each octet is moved at most twice, so sending stays linear. Not thread-safe.
class SendQueue {
 public:
  /// The memory that an empty queue keeps for the next lines.
  static constexpr std::size_t kept_bytes = std::size_t{16} * 1024;

  void append(std::string_view bytes) { bytes_ += bytes; }
  /// The bytes that wait; borrowed until the next change.
  [[nodiscard]] std::string_view waiting() const { return std::string_view(bytes_).substr(sent_); }
  /// The memory that is held, which a limit has to count.
  [[nodiscard]] std::size_t held() const { return bytes_.capacity(); }

  /// Drops sent bytes from the front. Requires that so many wait.
  void drop(std::size_t count) {
    sent_ += count;
    const std::size_t rest = bytes_.size() - sent_;
    if (sent_ < rest) return;  // moving the rest now would cost more than it gives back
    if (bytes_.capacity() > kept_bytes && bytes_.capacity() > 4 * rest) {
      std::string(waiting()).swap(bytes_);  // an assignment would keep the memory
    } else {
      bytes_.erase(0, sent_);
    }
    sent_ = 0;
  }

  void clear() {
    std::string().swap(bytes_);
    sent_ = 0;
  }

 private:
  std::string bytes_;
  std::size_t sent_ = 0;
};

}  // namespace geminga::env

#endif
