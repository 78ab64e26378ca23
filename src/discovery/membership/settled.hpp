// A value that a sender says again and again, with what it was until a short while ago: so that a lie can be undone.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_SETTLED_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_SETTLED_HPP

#include <optional>
#include <utility>

#include "base/time.hpp"

namespace geminga::membership {

/// What is believed of one thing. Which value is taken is the caller's to decide; this only remembers. The former value
/// is the one from before the first change within `hold`, so a lie that is told in several steps is undone as a whole.
template <typename Value>
class Settled {
 public:
  Settled(Value value, base::Instant now) : value_(std::move(value)), said_(now) {}

  [[nodiscard]] const Value& value() const { return value_; }
  /// When the sender last said so.
  [[nodiscard]] base::Instant said() const { return said_; }
  /// Whether it was said within `hold`.
  [[nodiscard]] bool is_held(base::Instant now, base::Duration hold) const { return now - said_ < hold; }
  /// Whether the sender said it more than once.
  [[nodiscard]] bool is_repeated() const { return is_repeated_; }
  /// The value that was replaced less than `hold` ago; nullptr: there is none.
  [[nodiscard]] const Value* former(base::Instant now, base::Duration hold) const {
    return former_ && now - replaced_ < hold ? &*former_ : nullptr;
  }

  /// The sender says it again.
  void affirm(base::Instant now) {
    said_ = now;
    is_repeated_ = true;
  }
  /// The sender says something else.
  void replace(Value value, base::Instant now, base::Duration hold) {
    if (former(now, hold) == nullptr) {
      former_ = std::move(value_);
      former_said_ = said_;
      replaced_ = now;
    }
    value_ = std::move(value);
    said_ = now;
    is_repeated_ = false;
  }
  /// Undoes what was replaced less than `hold` ago; whether there was anything.
  bool roll_back(base::Instant now, base::Duration hold) {
    const bool is_recent = former(now, hold) != nullptr;
    if (is_recent) {
      value_ = std::move(*former_);
      said_ = former_said_;
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
  Value value_;
  base::Instant said_;
  bool is_repeated_ = false;
  std::optional<Value> former_;
  base::Instant former_said_;
  base::Instant replaced_;
};

}  // namespace geminga::membership

#endif
