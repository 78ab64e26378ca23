// The loss of one sender on one way, measured by the sequence numbers of its last datagrams.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LOSS_WINDOW_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_LOSS_WINDOW_HPP

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>

namespace geminga::membership {

/// So many sequence numbers, and how many of them were not heard.
struct LossSample {
  int missed = 0;
  int numbers = 0;
  friend bool operator==(const LossSample&, const LossSample&) = default;
};

/// A window over the last 64 sequence numbers, for what has to follow the loss, and one over the last 256, for what has
/// to be sure of it. Copies and reordering do not count as loss.
class LossWindow {
 public:
  /// The share of lost ones means nothing before so many numbers were in the window.
  static constexpr int least_span = 16;
  static constexpr int full_span = 64;
  static constexpr int long_span = 256;

  /// Takes in that a datagram with this number was heard. A number from before the window means that the sender counts
  /// anew.
  void count(std::uint64_t sequence) {
    if (span_ == 0 || (sequence < newest_ && newest_ - sequence >= width)) {
      restart(sequence);
    } else if (sequence > newest_) {
      const auto step = static_cast<int>(std::min(sequence - newest_, std::uint64_t{long_span}));
      shift(step);
      span_ = std::min(full_span, span_ + step);
      newest_ = sequence;
    } else {
      const auto back = newest_ - sequence;
      heard_.set(static_cast<std::size_t>(back));
      span_ = std::max(span_, static_cast<int>(back) + 1);
      long_ = std::max(long_, span_);
    }
  }

  /// Counts anew from this number, since the numbers before were not the sender's.
  void restart(std::uint64_t sequence) {
    newest_ = sequence;
    heard_.reset();
    heard_.set(0);
    span_ = 1;
    long_ = 1;
  }

  /// Takes over what was heard of the same sender before it was given up and came back: for those who have to be sure.
  /// Call when the first number was counted.
  void go_on_from(const LossWindow& former) {
    if (former.span_ == 0 || newest_ <= former.newest_ || newest_ - former.newest_ >= long_span) return;
    const auto since = heard_;
    heard_ = former.heard_;
    long_ = former.long_;
    shift(static_cast<int>(newest_ - former.newest_));
    heard_ |= since;
  }

  [[nodiscard]] bool is_empty() const { return span_ == 0; }
  /// The highest number since the last restart.
  [[nodiscard]] std::uint64_t newest() const { return newest_; }
  /// Whether this number is in the window and was heard.
  [[nodiscard]] bool has(std::uint64_t sequence) const {
    return span_ != 0 && sequence <= newest_ && newest_ - sequence < static_cast<std::uint64_t>(span_) &&
           heard_.test(static_cast<std::size_t>(newest_ - sequence));
  }

  /// The numbers in the window of 64 since the first one heard, and how many of them were heard.
  [[nodiscard]] int span() const { return span_; }
  [[nodiscard]] int heard() const { return heard_within(span_); }
  /// The share of these that were not heard, in [0, 1); 0 before the first.
  [[nodiscard]] double loss() const {
    return span_ == 0 ? 0 : 1 - static_cast<double>(heard()) / static_cast<double>(span_);
  }
  /// The last 64 numbers and the last 256, as far back as the sender is known, also before it was given up.
  [[nodiscard]] LossSample lately() const { return sample_of(std::min(long_, full_span)); }
  [[nodiscard]] LossSample for_long() const { return sample_of(long_); }

 private:
  /// Moves on by so many numbers, of which the last was heard.
  void shift(int step) {
    heard_ <<= static_cast<std::size_t>(step);
    heard_.set(0);
    long_ = std::min(long_span, long_ + step);
  }
  [[nodiscard]] int heard_within(int numbers) const {
    return static_cast<int>((heard_ << static_cast<std::size_t>(long_span - numbers)).count());
  }
  [[nodiscard]] LossSample sample_of(int numbers) const {
    return {.missed = numbers - heard_within(numbers), .numbers = numbers};
  }

  static constexpr std::uint64_t width = full_span;
  std::uint64_t newest_ = 0;
  std::bitset<long_span> heard_;  ///< bit n: newest_ - n was heard
  int span_ = 0;                  ///< numbers in the window of 64 since the first one heard
  int long_ = 0;                  ///< numbers in the window of 256
};

}  // namespace geminga::membership

#endif
