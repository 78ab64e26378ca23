// The choice of one subscription: which of the publications that match it are given to it (paper section 3.6).
#ifndef GEMINGA_DISCOVERY_MATCHING_ARBITRATION_CHOICE_HPP
#define GEMINGA_DISCOVERY_MATCHING_ARBITRATION_CHOICE_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "discovery/matching/arbitration/rank.hpp"
#include "discovery/matching/arbitration/reason.hpp"
#include "discovery/registry/stored.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// How many candidates beyond its limit a subscription remembers at first, and at most. Without a bound, a member that
/// announces thousands of services and another that asks for them thousands of times would cost memory for every pair.
/// When all remembered candidates have gone, the registry is searched again. From then on as many are remembered as the
/// square root of those that were passed over: a search through a million pays for a thousand departures.
inline constexpr std::size_t first_waiting = 16;
inline constexpr std::size_t max_waiting = 1024;

/// The changes of one settling. Each publication is in at most one of the lists.
struct Verdict {
  struct Gone {
    const registry::StoredPublication* publication = nullptr;
    Match told;
    Reason reason = Reason::withdrawn;
  };
  struct Kept {
    const registry::StoredPublication* publication = nullptr;
    Match told;
    Match match;
  };
  struct Come {
    const registry::StoredPublication* publication = nullptr;
    Match match;
  };
  std::vector<Gone> gone;       ///< chosen before, and not candidates any longer; ascending by key
  std::vector<Gone> outranked;  ///< chosen before, and still candidates; ascending by key
  std::vector<Kept> kept;       ///< chosen before and after, and judged in between; best first
  std::vector<Come> come;       ///< best first
};

/// The candidates of one subscription. The first `limit` in the order of Rank are chosen, with one exception: a chosen
/// candidate (the incumbent) keeps its place against one that is better only by its key or by less than a margin. So
/// neither a tie nor noise in a value makes a consumer change its provider. Changes are collected and take effect in
/// settle(), so that one cause gives one verdict.
///
/// Of the others only the best wait here, at most `limit + max_waiting` and few at first. The rest is dropped. When a
/// dropped candidate may be chosen, settle() asks for all candidates again.
///
/// Borrows the publications; one that was withdrawn must live until the next settle(). Each operation is O(log n).
class Choice {
 public:
  static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
  using Dropped = std::vector<const registry::StoredPublication*>;

  /// 0 is no limit, as in Subscription::limit.
  void set_limit(std::uint32_t limit) { limit_ = limit == 0 ? unlimited : limit; }

  /// How much better each number of a score must be to push out an incumbent.
  void set_margins(Score margins) { margins_ = std::move(margins); }
  /// Drops those that wait, because scores have another meaning from here on. All candidates must then be offered, or
  /// changed where they are chosen.
  void release_waiting();

  /// Whether a candidate was dropped since the last refill.
  [[nodiscard]] bool has_passed_over() const { return bound_.has_value(); }
  /// Whether a new candidate would be dropped at once: then it need not be offered. Counts it as passed over.
  [[nodiscard]] bool passes_over(const Rank& rank) {
    const bool is_behind = bound_ && !BestFirst{}(rank, *bound_);
    if (is_behind) ++passed_over_;
    return is_behind;
  }
  /// Adds a candidate. `is_incumbent`: it was chosen before this Choice heard of it.
  void offer(const Rank& rank, const registry::StoredPublication& publication, bool is_incumbent = false);
  /// Judges a candidate anew, perhaps with another rank.
  void change(const Rank& before, const Rank& now);
  /// Takes a candidate out.
  void withdraw(const Rank& rank, Reason reason);

  /// Chooses, and gives what changed since the last time. Calls `refill` when dropped candidates may be chosen: it must
  /// offer() every candidate that is neither chosen nor waiting.
  [[nodiscard]] Verdict settle(const std::function<void()>& refill);
  /// Called by `refill`: the candidates are offered later, and end_refill() is called then. Until then the choice is
  /// among those that are there.
  void postpone_refill() { awaits_refill_ = true; }
  void end_refill() { awaits_refill_ = false; }
  /// The next verdict names all that stay chosen.
  void touch_all() {
    for (const auto& [rank, candidate] : chosen_) touched_.push_back(rank);
  }

  /// The publications dropped since the last call: no candidates until they are offered again.
  [[nodiscard]] Dropped take_dropped() { return std::exchange(dropped_, {}); }

  /// Whether there may be candidates that are not chosen.
  [[nodiscard]] bool is_contested() const { return !waiting_.empty() || has_passed_over() || awaits_refill_; }
  [[nodiscard]] bool is_chosen(const Rank& rank) const { return chosen_.contains(rank); }
  /// The chosen ones, best first.
  [[nodiscard]] std::vector<Verdict::Come> chosen() const;
  /// All candidates with their ranks, the chosen first.
  [[nodiscard]] std::vector<std::pair<Rank, const registry::StoredPublication*>> candidates() const;

 private:
  struct Candidate {
    const registry::StoredPublication* publication = nullptr;
    Match told;  ///< meaningful while it is chosen
  };
  using Ranking = std::map<Rank, Candidate, BestFirst>;

  /// Puts a candidate among the waiting, or drops it or the worst of them.
  void wait(const Rank& rank, const Candidate& candidate);
  /// The best waiting candidate, after a refill if that could matter; null where none waits.
  const Rank* best_waiting(const std::function<void()>& refill);
  void promote_best(Verdict& verdict);
  void demote_worst(Verdict& verdict);

  std::size_t limit_ = unlimited;
  Score margins_;
  Ranking chosen_;
  Ranking waiting_;
  std::optional<Rank> bound_;  ///< all dropped candidates rank here or behind; nothing: none was dropped
  Dropped dropped_;
  std::size_t room_ = first_waiting;  ///< how many wait beyond the limit
  std::size_t passed_over_ = 0;       ///< how many were dropped since the last refill
  bool awaits_refill_ = false;
  std::vector<Verdict::Gone> gone_;
  std::vector<Rank> touched_;
};

}  // namespace geminga::matching

#endif
