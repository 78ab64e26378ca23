// A value that a sender repeats, with the value before it, so that a lie can be undone.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_REVOCABLE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_REVOCABLE_HPP

#include <utility>

#include "base/rare.hpp"
#include "base/time.hpp"

namespace geminga::membership {

/// The believed value of one property of a sender. The caller decides which value is taken. The former value is the one
/// from before the first change within `hold`, so a lie that is told in several steps is undone as a whole.
template <typename Value>
class Revocable {
 public:
  Revocable(Value value, base::Instant now) : value_(std::move(value)), said_(now) {}

  [[nodiscard]] const Value& value() const { return value_; }
  /// When the sender last said the value.
  [[nodiscard]] base::Instant said() const { return said_; }
  /// Whether the value was said within `hold`.
  [[nodiscard]] bool is_held(base::Instant now, base::Duration hold) const { return now - said_ < hold; }
  /// Whether the sender said the value more than once.
  [[nodiscard]] bool is_repeated() const { return is_repeated_; }
  /// The value that was replaced less than `hold` ago; nullptr: there is none.
  [[nodiscard]] const Value* former(base::Instant now, base::Duration hold) const {
    return former_ && now - former_->replaced < hold ? &former_->value : nullptr;
  }

  /// Takes in that the sender says the value again.
  void affirm(base::Instant now) {
    said_ = now;
    is_repeated_ = true;
  }
  /// Takes in another value.
  void replace(Value value, base::Instant now, base::Duration hold) {
    if (former(now, hold) == nullptr) former_ = Former{std::move(value_), said_, now};
    value_ = std::move(value);
    said_ = now;
    is_repeated_ = false;
  }
  /// Undoes what was replaced less than `hold` ago; whether there was anything.
  bool roll_back(base::Instant now, base::Duration hold) {
    const bool is_recent = former(now, hold) != nullptr;
    if (is_recent) {
      value_ = std::move(former_->value);
      said_ = former_->said;
      is_repeated_ = true;
    }
    former_.reset();
    return is_recent;
  }
  /// Forgets a former value that is older than `hold`.
  void prune(base::Instant now, base::Duration hold) {
    if (former(now, hold) == nullptr) former_.reset();
  }

 private:
  struct Former {
    Value value;
    base::Instant said;
    base::Instant replaced;
  };

  Value value_;
  base::Instant said_;
  bool is_repeated_ = false;
  base::Rare<Former> former_;  ///< few senders change anything
};

}  // namespace geminga::membership

#endif
