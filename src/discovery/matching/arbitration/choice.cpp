#include "discovery/matching/arbitration/choice.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/assert.hpp"

namespace geminga::matching {

void Choice::release_waiting() {
  for (const auto& [rank, candidate] : waiting_) dropped_.push_back(candidate.publication);
  waiting_.clear();
  bound_.reset();
  awaits_refill_ = false;
}

void Choice::offer(const Rank& rank, const registry::StoredPublication& publication, bool is_incumbent) {
  const Candidate candidate{&publication, rank.match};
  if (!is_incumbent) {
    wait(rank, candidate);
    return;
  }
  const bool is_new = chosen_.emplace(rank, candidate).second;
  GEMINGA_ASSERT(is_new);
}

void Choice::wait(const Rank& rank, const Candidate& candidate) {
  if (passes_over(rank)) {
    dropped_.push_back(candidate.publication);  // whether it is better than those dropped before is unknown
    return;
  }
  const bool is_new = waiting_.emplace(rank, candidate).second;
  GEMINGA_ASSERT(is_new);
  const bool is_bounded = limit_ < unlimited - max_waiting;
  if (!is_bounded || waiting_.size() <= limit_ + room_) return;
  const auto worst = std::prev(waiting_.end());
  ++passed_over_;
  bound_ = worst->first;
  dropped_.push_back(worst->second.publication);
  waiting_.erase(worst);
}

void Choice::change(const Rank& before, const Rank& now) {
  if (const auto at = chosen_.find(before); at != chosen_.end()) {
    auto node = chosen_.extract(at);
    node.key() = now;
    chosen_.insert(std::move(node));
    touched_.push_back(now);
    return;
  }
  const auto node = waiting_.extract(before);
  GEMINGA_ASSERT(!node.empty());
  wait(now, node.mapped());
}

void Choice::withdraw(const Rank& rank, Reason reason) {
  if (const auto at = chosen_.find(rank); at != chosen_.end()) {
    gone_.push_back({at->second.publication, at->second.told, reason});
    chosen_.erase(at);
    return;
  }
  const auto erased = waiting_.erase(rank);
  GEMINGA_ASSERT(erased == 1);
}

const Rank* Choice::best_waiting(const std::function<void()>& refill) {
  const bool is_full = chosen_.size() >= limit_;
  if (waiting_.empty() && bound_ && (!is_full || is_strictly_better(*bound_, std::prev(chosen_.end())->first))) {
    bound_.reset();
    const auto passed_over = static_cast<double>(std::exchange(passed_over_, 0));
    room_ = std::clamp(static_cast<std::size_t>(std::sqrt(passed_over)), first_waiting, max_waiting);
    refill();
  }
  return waiting_.empty() ? nullptr : &waiting_.begin()->first;
}

void Choice::promote_best(Verdict& verdict) {
  auto node = waiting_.extract(waiting_.begin());
  node.mapped().told = node.key().match;
  verdict.come.push_back({node.mapped().publication, node.key().match});
  chosen_.insert(std::move(node));
}

void Choice::demote_worst(Verdict& verdict) {
  const auto node = chosen_.extract(std::prev(chosen_.end()));
  verdict.outranked.push_back({node.mapped().publication, node.mapped().told, Reason::outranked});
  wait(node.key(), node.mapped());
}

// Nothing that is promoted here is demoted again, nor the other way round. After the first two loops the choice is full
// or nobody waits, and each swap puts a strictly better candidate into the place of the worst. A swap promotes first,
// because demoting may drop the worst that waits.
Verdict Choice::settle(const std::function<void()>& refill) {
  Verdict verdict;
  verdict.gone = std::exchange(gone_, {});
  while (chosen_.size() > limit_) demote_worst(verdict);
  while (chosen_.size() < limit_ && best_waiting(refill) != nullptr) promote_best(verdict);
  while (const Rank* best = best_waiting(refill)) {
    if (!is_better_by(margins_, *best, std::prev(chosen_.end())->first)) break;
    promote_best(verdict);
    demote_worst(verdict);
  }
  std::ranges::sort(touched_, BestFirst{});
  // A candidate may have been judged twice.
  const auto twice = std::ranges::unique(touched_, [](const Rank& a, const Rank& b) { return !BestFirst{}(a, b); });
  touched_.erase(twice.begin(), twice.end());
  for (const Rank& rank : std::exchange(touched_, {})) {
    const auto at = chosen_.find(rank);
    if (at == chosen_.end()) continue;
    verdict.kept.push_back({at->second.publication, at->second.told, rank.match});
    at->second.told = rank.match;
  }
  for (auto* gone : {&verdict.gone, &verdict.outranked}) {
    std::ranges::sort(*gone, {}, [](const Verdict::Gone& one) { return one.publication->entry.key; });
  }
  return verdict;
}

std::vector<Verdict::Come> Choice::chosen() const {
  std::vector<Verdict::Come> all;
  for (const auto& [rank, candidate] : chosen_) all.push_back({candidate.publication, candidate.told});
  return all;
}

std::vector<std::pair<Rank, const registry::StoredPublication*>> Choice::candidates() const {
  std::vector<std::pair<Rank, const registry::StoredPublication*>> all;
  all.reserve(chosen_.size() + waiting_.size());
  for (const auto* ranking : {&chosen_, &waiting_}) {
    for (const auto& [rank, candidate] : *ranking) all.emplace_back(rank, candidate.publication);
  }
  return all;
}

}  // namespace geminga::matching
