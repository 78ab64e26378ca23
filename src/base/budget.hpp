// How much work a question may cost, shared by everybody who works on it.
#ifndef GEMINGA_BASE_BUDGET_HPP
#define GEMINGA_BASE_BUDGET_HPP

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace geminga::base {

/// Counted steps, and a question to whoever waits whether it still does. Steps make an answer the same everywhere; the
/// question is for people and robots whose patience is measured in seconds. Thread-safe.
class Budget {
 public:
  static constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
  using IsOver = std::function<bool()>;

  /// `is_over` is asked from any thread, about once for each `between` steps, until it says yes.
  explicit Budget(std::uint64_t steps = unlimited, IsOver is_over = nullptr, std::uint64_t between = 10'000)
      : steps_(steps), between_(between), is_over_(std::move(is_over)) {}
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Counts steps that were done. False once there are none left, or time is over: then every worker ends soon, and
  /// keeps what is certain.
  bool spend(std::uint64_t steps);
  [[nodiscard]] bool is_spent() const { return end_.load(std::memory_order_relaxed) != End::open; }
  [[nodiscard]] std::uint64_t spent() const { return spent_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t left() const { return is_spent() || spent() >= steps_ ? 0 : steps_ - spent(); }
  /// Why it is spent, in one line; nothing while it is not.
  [[nodiscard]] std::optional<std::string> reason() const;

 private:
  enum class End : std::uint8_t { open, steps, time };

  const std::uint64_t steps_;
  const std::uint64_t between_;
  const IsOver is_over_;
  std::atomic<std::uint64_t> spent_{0};
  std::atomic<std::uint64_t> next_question_{0};
  std::atomic<End> end_{End::open};
};

/// What one worker does, told to a budget in batches, so that counting costs nothing. Not thread-safe.
class BudgetUse {
 public:
  /// Nothing: everything may be spent.
  explicit BudgetUse(Budget* budget) : budget_(budget) {}

  /// False where the budget is spent.
  bool spend(std::uint64_t steps) {
    if (budget_ == nullptr) return true;
    waiting_ += steps;
    return waiting_ < batch ? !budget_->is_spent() : settle();
  }

 private:
  static constexpr std::uint64_t batch = 1024;
  bool settle() {
    const bool goes_on = budget_->spend(waiting_);
    waiting_ = 0;
    return goes_on;
  }

  Budget* budget_;
  std::uint64_t waiting_ = 0;
};

}  // namespace geminga::base

#endif
