// The cost of a saturation and its limits: the counts of all threads together, and those of each thread.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_EFFORT_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_EFFORT_HPP

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/budget.hpp"

namespace geminga::consequence {

struct SaturationLimits {
  std::size_t clauses = 0;         ///< of all contexts together
  std::uint32_t alternatives = 0;  ///< of one context, see Options
  base::Budget* budget = nullptr;  ///< pays for all of it, if there is one
};

/// The counts of all threads. Any thread may call any function. When a limit is passed, all threads stop.
class SharedEffort {
 public:
  explicit SharedEffort(const SaturationLimits& limits) : limits_(limits) {}

  /// Counts derived clauses. False: the threads stop.
  bool count_clauses(std::size_t clauses) {
    if (clauses_.fetch_add(clauses, std::memory_order_relaxed) + clauses > limits_.clauses) give_up();
    if (limits_.budget != nullptr && !limits_.budget->spend(clauses * steps_per_clause)) give_up();
    return !is_cut_off();
  }
  /// Counts attempts to match a body, most of which give nothing new. False: the threads stop.
  bool count_attempts(std::size_t attempts) {
    const std::size_t all = attempts_.fetch_add(attempts, std::memory_order_relaxed) + attempts;
    if (all / attempts_per_clause > limits_.clauses) give_up();
    if (limits_.budget != nullptr && !limits_.budget->spend(attempts)) give_up();
    return !is_cut_off();
  }
  /// Counts a message that is sent. False: too many wait, and the threads stop.
  bool count_message() {
    if (waiting_.fetch_add(1, std::memory_order_relaxed) < max_messages()) return true;
    is_flooded_.store(true, std::memory_order_relaxed);
    give_up();
    return false;
  }
  /// Counts messages that were taken out of a mailbox.
  void count_received(std::size_t messages) { waiting_.fetch_sub(messages, std::memory_order_relaxed); }
  /// Counts a context that dropped its alternatives.
  void count_cut_context() { cut_contexts_.fetch_add(1, std::memory_order_relaxed); }
  /// The most alternatives of one context. Once many contexts had more, others probably have, too, and the number is
  /// smaller.
  [[nodiscard]] std::uint32_t max_alternatives() const {
    return cut_contexts_.load(std::memory_order_relaxed) < many_cut_contexts
               ? limits_.alternatives
               : std::min(limits_.alternatives, few_alternatives);
  }
  /// The most steps of one context in which rules with alternatives are matched.
  [[nodiscard]] std::size_t max_matches() const {
    return always_matches + max_alternatives() * matches_per_alternative;
  }

  void give_up() { is_cut_off_.store(true, std::memory_order_relaxed); }
  /// Notes that an individual cannot exist. Everything follows from that, so all threads stop.
  void contradict() {
    is_contradictory_.store(true, std::memory_order_relaxed);
    give_up();
  }

  [[nodiscard]] bool is_cut_off() const { return is_cut_off_.load(std::memory_order_relaxed); }
  [[nodiscard]] bool is_contradictory() const { return is_contradictory_.load(std::memory_order_relaxed); }
  /// Whether too many messages waited at once.
  [[nodiscard]] bool is_flooded() const { return is_flooded_.load(std::memory_order_relaxed); }
  [[nodiscard]] bool has_cut_context() const { return cut_contexts_.load(std::memory_order_relaxed) > 0; }
  [[nodiscard]] std::size_t clause_count() const { return clauses_.load(std::memory_order_relaxed); }
  /// The messages that may wait at once.
  [[nodiscard]] std::size_t max_messages() const { return always_waiting + limits_.clauses; }

 private:
  /// This many attempts count as one clause, so that work that derives little ends, too.
  static constexpr std::size_t attempts_per_clause = 100;
  /// Filing a clause takes about as long as this many attempts.
  static constexpr std::size_t steps_per_clause = 8;
  static constexpr std::size_t many_cut_contexts = 256;
  static constexpr std::size_t always_matches = 10'000;
  static constexpr std::size_t matches_per_alternative = 500;
  static constexpr std::uint32_t few_alternatives = 16;
  /// The messages that may wait at once, in addition to as many as there may be clauses. Each has some forty octets.
  static constexpr std::size_t always_waiting = 1'000'000;

  SaturationLimits limits_;
  std::atomic<std::size_t> clauses_{0};
  std::atomic<std::size_t> attempts_{0};
  std::atomic<std::size_t> waiting_{0};  ///< messages
  std::atomic<std::size_t> cut_contexts_{0};
  std::atomic<bool> is_flooded_{false};
  std::atomic<bool> is_cut_off_{false};
  std::atomic<bool> is_contradictory_{false};
};

/// The counts of one thread, which are added to those of all threads from time to time.
class Effort {
 public:
  explicit Effort(SharedEffort& shared) : shared_(shared) {}

  void count_unit() { ++derived_; }
  /// Counts a clause with this many literals. A long one counts several times, so that the count bounds the memory.
  void count_clause(std::size_t literals) { derived_ += 1 + literals / literals_per_clause; }
  void count_attempt() { count_attempts(1); }
  /// Counts comparisons of a new clause with others.
  void count_compared(std::size_t clauses) {
    compared_ += clauses;
    count_attempts(compared_ / compared_per_attempt);
    compared_ %= compared_per_attempt;
  }

  /// Whether the rule that is being applied must stop.
  [[nodiscard]] bool is_stopped() const { return is_stopped_; }
  /// Makes all threads stop.
  void stop() {
    shared_.give_up();
    is_stopped_ = true;
  }
  /// Whether the context may be worked on. Reports the derived clauses if there are many.
  [[nodiscard]] bool may_continue() { return !is_stopped_ && (derived_ <= clauses_at_once || report()); }
  /// Adds the derived clauses to those of all threads. False: the threads stop.
  bool report() { return shared_.count_clauses(std::exchange(derived_, 0)); }

 private:
  static constexpr std::size_t attempts_at_once = 4096;
  static constexpr std::size_t clauses_at_once = 1000;
  static constexpr std::size_t literals_per_clause = 8;
  /// Comparing a new clause with this many others takes as long as an attempt.
  static constexpr std::size_t compared_per_attempt = 8;

  void count_attempts(std::size_t attempts) {
    attempts_ += attempts;
    if (attempts_ < attempts_at_once) return;
    if (!shared_.count_attempts(std::exchange(attempts_, 0))) is_stopped_ = true;
  }

  SharedEffort& shared_;
  std::size_t derived_ = 0;   ///< clauses that are not reported
  std::size_t attempts_ = 0;  ///< that are not reported
  std::size_t compared_ = 0;  ///< clauses that are not counted as attempts
  bool is_stopped_ = false;
};

}  // namespace geminga::consequence

#endif
