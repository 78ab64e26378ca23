// Which of the publications that meet a subscription are chosen under its limit (paper section 3.6, arbitration).
#ifndef GEMINGA_DISCOVERY_MATCHING_ARBITRATION_HPP
#define GEMINGA_DISCOVERY_MATCHING_ARBITRATION_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "discovery/matching/degree.hpp"
#include "discovery/matching/event.hpp"
#include "discovery/registry/stored.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// Where a candidate stands by what its consumer prefers, number by number, the lesser the better (preferences.hpp).
using Score = std::vector<double>;

/// Where a candidate stands: the lesser score, then greater priority, better degree, smaller distance, then the smaller
/// key. All ranks of one subscription have scores of one length, which is 0 where it prefers nothing.
struct Rank {
  std::int32_t priority = 0;
  Match match;
  ServiceKey key;
  Score score{};
};

/// Whether `a` is better by more than its key.
[[nodiscard]] bool is_strictly_better(const Rank& a, const Rank& b);
/// Whether `a` may take the place of an incumbent: it is strictly better, and where a number of the scores decides
/// that, it is so by its margin at least. Numbers without margin have 0.
[[nodiscard]] bool is_better_by(const Score& margins, const Rank& a, const Rank& incumbent);

struct BestFirst {
  bool operator()(const Rank& a, const Rank& b) const {
    if (is_strictly_better(a, b)) return true;
    return !is_strictly_better(b, a) && a.key < b.key;
  }
};

/// How many candidates beyond its limit a subscription remembers at first. Without a bound, one team member that
/// announces thousands of services and another that asks for them thousands of times would cost memory for every pair.
/// When all that are remembered have gone, the registry is searched again, and from then on as many are remembered as
/// the square root of those that were passed over: a search through a million pays for a thousand departures.
inline constexpr std::size_t first_waiting = 16;
inline constexpr std::size_t max_waiting = 1024;

/// What one settling changed. Each publication is in at most one of the lists.
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
  std::vector<Gone> gone;       ///< candidates no more; ascending by key
  std::vector<Gone> outranked;  ///< still candidates, which others have pushed out; ascending by key
  std::vector<Kept> kept;       ///< chosen before and after, and touched in between; best first
  std::vector<Come> come;       ///< best first
};

/// The candidates of one subscription. The chosen ones are the first `limit` in the order of Rank, except that a chosen
/// candidate keeps its place against one that is no better but by its key, or by less than a margin: a tie never makes
/// a consumer change its provider, nor does noise in a value. It is the best of the others that must be better. Changes
/// are collected and take effect in settle(), so that one cause gives one verdict.
///
/// Of those that are not chosen only the best wait here, at most `limit + max_waiting` and few at first; the others are
/// dropped, and when it comes to them, settle() asks for all candidates again.
///
/// Borrows the publications; one that was withdrawn must live until the next settle(). Each operation is O(log n).
class Choice {
 public:
  static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
  using Dropped = std::vector<const registry::StoredPublication*>;

  /// 0 is no limit, as in Subscription::limit.
  void set_limit(std::uint32_t limit) { limit_ = limit == 0 ? unlimited : limit; }

  /// By how much each number of a score must be better to push out an incumbent.
  void set_margins(Score margins) { margins_ = std::move(margins); }
  /// The scores mean something else from here on: those that wait are dropped, and all candidates must be offered, or
  /// changed where they are chosen.
  void release_waiting();

  /// Whether somebody was dropped since the last refill.
  [[nodiscard]] bool has_passed_over() const { return bound_.has_value(); }
  /// Whether a new candidate would be dropped at once: then it need not be offered.
  [[nodiscard]] bool passes_over(const Rank& rank) {
    const bool is_behind = bound_ && !BestFirst{}(rank, *bound_);
    if (is_behind) ++passed_over_;
    return is_behind;
  }
  /// A new candidate. `is_incumbent` tells that it was chosen before this Choice heard of it.
  void offer(const Rank& rank, const registry::StoredPublication& publication, bool is_incumbent = false);
  /// A candidate that stays one, perhaps with another rank.
  void change(const Rank& before, const Rank& now);
  /// A candidate that is none any more.
  void withdraw(const Rank& rank, Reason reason);

  /// Chooses, and says what became different since the last time. Calls `refill` when those that were dropped may
  /// matter: it must offer() every candidate that is neither chosen nor waiting.
  [[nodiscard]] Verdict settle(const std::function<void()>& refill);

  /// Those that were dropped since the last call: candidates no more, until they are offered again.
  [[nodiscard]] Dropped take_dropped() { return std::exchange(dropped_, {}); }

  /// Whether it had to choose: there may be candidates that it has not chosen.
  [[nodiscard]] bool is_contested() const { return !waiting_.empty() || has_passed_over(); }
  [[nodiscard]] bool is_chosen(const Rank& rank) const { return chosen_.contains(rank); }
  /// Best first.
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
  /// The best that waits, after a refill if that could matter; nullptr where nobody does.
  const Rank* best_waiting(const std::function<void()>& refill);
  void promote_best(Verdict& verdict);
  void demote_worst(Verdict& verdict);

  std::size_t limit_ = unlimited;
  Score margins_;
  Ranking chosen_;
  Ranking waiting_;
  std::optional<Rank> bound_;  ///< every dropped candidate ranks here or behind; nothing: none was dropped
  Dropped dropped_;
  std::size_t room_ = first_waiting;  ///< how many wait beyond the limit
  std::size_t passed_over_ = 0;       ///< how many were dropped since the last refill
  std::vector<Verdict::Gone> gone_;
  std::vector<Rank> touched_;
};

}  // namespace geminga::matching

#endif
