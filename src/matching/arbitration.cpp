// Arbitration with incumbents, incrementally.
#include "matching/arbitration.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/assert.hpp"

namespace geminga::matching {

bool is_strictly_better(const Rank& a, const Rank& b) {
  if (a.priority != b.priority) return a.priority > b.priority;
  return a.match < b.match;
}

void Choice::offer(const Rank& rank, const registry::StoredPublication& publication, bool is_incumbent) {
  auto& ranking = is_incumbent ? chosen_ : waiting_;
  const bool is_new = ranking.emplace(rank, Candidate{&publication, rank.match}).second;
  GEMINGA_ASSERT(is_new);
}

void Choice::change(const Rank& before, const Rank& now) {
  const bool was_chosen = chosen_.contains(before);
  auto& ranking = was_chosen ? chosen_ : waiting_;
  auto node = ranking.extract(before);
  GEMINGA_ASSERT(!node.empty());
  node.key() = now;
  ranking.insert(std::move(node));
  if (was_chosen) touched_.push_back(now);
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

void Choice::promote_best(Verdict& verdict) {
  const auto& [rank, candidate] = *waiting_.begin();
  verdict.come.push_back({candidate.publication, rank.match});
  auto node = waiting_.extract(waiting_.begin());
  node.mapped().told = node.key().match;
  chosen_.insert(std::move(node));
}

void Choice::demote_worst(Verdict& verdict) {
  const auto worst = std::prev(chosen_.end());
  verdict.gone.push_back({worst->second.publication, worst->second.told, Reason::outranked});
  waiting_.insert(chosen_.extract(worst));
}

// Nothing that is promoted here is demoted again, nor the other way round: after the first two loops the choice is full
// or nobody waits, and each swap puts a strictly better candidate into the place of the worst.
Verdict Choice::settle() {
  Verdict verdict;
  verdict.gone = std::exchange(gone_, {});
  while (chosen_.size() > limit_) demote_worst(verdict);
  while (chosen_.size() < limit_ && !waiting_.empty()) promote_best(verdict);
  while (!waiting_.empty() && is_strictly_better(waiting_.begin()->first, std::prev(chosen_.end())->first)) {
    demote_worst(verdict);
    promote_best(verdict);
  }
  std::ranges::sort(touched_, BestFirst{});
  for (const Rank& rank : std::exchange(touched_, {})) {
    const auto at = chosen_.find(rank);
    if (at == chosen_.end()) continue;
    verdict.kept.push_back({at->second.publication, at->second.told, rank.match});
    at->second.told = rank.match;
  }
  std::ranges::sort(verdict.gone, {}, [](const Verdict::Gone& gone) { return gone.publication->entry.key; });
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
