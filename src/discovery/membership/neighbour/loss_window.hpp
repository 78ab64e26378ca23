// The loss of one sender on one way, measured by the sequence numbers of its last datagrams.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LOSS_WINDOW_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LOSS_WINDOW_HPP

#include <algorithm>
#include <bit>
#include <cstdint>

namespace geminga::membership {

/// A window over the last 64 sequence numbers. Copies and reordering do not count as loss.
class LossWindow {
 public:
  /// The share of lost ones means nothing before so many numbers were in the window.
  static constexpr int least_span = 16;
  static constexpr int full_span = 64;

  /// Takes in that a datagram with this number was heard. A number from before the window means that the sender counts
  /// anew.
  void count(std::uint64_t sequence) {
    if (span_ == 0 || (sequence < newest_ && newest_ - sequence >= width)) {
      restart(sequence);
    } else if (sequence > newest_) {
      const auto step = sequence - newest_;
      heard_ = step >= width ? 1 : (heard_ << step) | 1;
      span_ =
          static_cast<int>(std::min<std::uint64_t>(width, static_cast<std::uint64_t>(span_) + std::min(step, width)));
      newest_ = sequence;
    } else {
      const auto back = newest_ - sequence;
      heard_ |= std::uint64_t{1} << back;
      span_ = std::max(span_, static_cast<int>(back) + 1);
    }
  }

  /// Counts anew from this number, since the numbers before were not the sender's.
  void restart(std::uint64_t sequence) {
    newest_ = sequence;
    heard_ = 1;
    span_ = 1;
  }

  [[nodiscard]] bool is_empty() const { return span_ == 0; }
  /// The highest number since the last restart.
  [[nodiscard]] std::uint64_t newest() const { return newest_; }
  /// Whether this number is in the window and was heard.
  [[nodiscard]] bool has(std::uint64_t sequence) const {
    return span_ != 0 && sequence <= newest_ && newest_ - sequence < width &&
           ((heard_ >> (newest_ - sequence)) & 1) != 0;
  }

  /// The numbers in the window since the first one heard, and how many of them were heard.
  [[nodiscard]] int span() const { return span_; }
  [[nodiscard]] int heard() const { return std::popcount(heard_); }
  /// The share of the numbers in the window that were not heard, in [0, 1); 0 before the first.
  [[nodiscard]] double loss() const {
    return span_ == 0 ? 0 : 1 - static_cast<double>(std::popcount(heard_)) / static_cast<double>(span_);
  }

 private:
  static constexpr std::uint64_t width = full_span;
  std::uint64_t newest_ = 0;
  std::uint64_t heard_ = 0;  ///< bit n: newest_ - n was heard
  int span_ = 0;             ///< numbers in the window since the first one heard
};

}  // namespace geminga::membership

#endif
