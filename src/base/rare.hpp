// An optional value that is mostly absent, and then takes the room of a pointer.
#ifndef GEMINGA_BASE_RARE_HPP
#define GEMINGA_BASE_RARE_HPP

#include <memory>
#include <utility>

namespace geminga::base {

/// As std::optional, but the value is on the heap: for a member of many records, of which nearly none has the
/// value. A copy has a value of its own.
template <typename Value>
class Rare {
 public:
  Rare() = default;
  Rare(Value value)
      : value_(std::make_unique<Value>(std::move(value))) {}  // NOLINT(google-explicit-constructor): as std::optional
  Rare(const Rare& other) : value_(other ? std::make_unique<Value>(*other) : nullptr) {}
  Rare(Rare&&) noexcept = default;
  Rare& operator=(const Rare& other) {
    if (this != &other) value_ = other ? std::make_unique<Value>(*other) : nullptr;
    return *this;
  }
  Rare& operator=(Rare&&) noexcept = default;
  ~Rare() = default;

  explicit operator bool() const { return value_ != nullptr; }
  [[nodiscard]] Value& operator*() { return *value_; }
  [[nodiscard]] const Value& operator*() const { return *value_; }
  [[nodiscard]] Value* operator->() { return value_.get(); }
  [[nodiscard]] const Value* operator->() const { return value_.get(); }
  void reset() { value_.reset(); }
  /// The value; a default one is made where there is none.
  [[nodiscard]] Value& made() {
    if (value_ == nullptr) value_ = std::make_unique<Value>();
    return *value_;
  }

 private:
  std::unique_ptr<Value> value_;
};

}  // namespace geminga::base

#endif
