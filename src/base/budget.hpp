// The budget of work of a question, shared by all threads that work on it.
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

/// Counts steps, and asks the waiting caller now and then whether it gives up. Steps make an answer the same
/// everywhere; the question serves people and robots whose patience is measured in seconds. Thread-safe.
class Budget {
 public:
  static constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
  using IsOver = std::function<bool()>;

  /// `is_over` is called from any thread, about once for each `between` steps, until it returns true.
  explicit Budget(std::uint64_t steps = unlimited, IsOver is_over = nullptr, std::uint64_t between = 10'000)
      : steps_(steps), between_(between), is_over_(std::move(is_over)) {}
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Counts steps that were done. Returns false once there are none left or time is over: then every worker ends soon,
  /// and keeps what is certain.
  bool spend(std::uint64_t steps);
  [[nodiscard]] bool is_spent() const { return end_.load(std::memory_order_relaxed) != End::open; }
  [[nodiscard]] std::uint64_t spent() const { return spent_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t left() const { return is_spent() || spent() >= steps_ ? 0 : steps_ - spent(); }
  /// The reason why it is spent, in one line; nothing while it is not.
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

/// The steps of one worker, told to a budget in batches, so that counting costs nothing. Not thread-safe.
class BudgetUse {
 public:
  /// Null: everything may be spent.
  explicit BudgetUse(Budget* budget) : budget_(budget) {}

  /// Returns false if the budget is spent.
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
