#include "reasoning/dl/consequence/conclusions.hpp"

namespace geminga::consequence {

void Conclusions::add_side(const ClauseStore& store, Premise premise) {
  add_body(body_of(store, premise));
  for (const Literal literal : head_of(store, premise)) {
    if (literal != premise.literal) head_.push_back(literal);
  }
}

void Conclusions::finish(ClauseStore& store, std::span<const Literal> head) {
  const std::size_t alternatives = head_.size() + head.size();
  if (body_.empty() && alternatives <= 1) {
    if (alternatives == 0) {
      has_contradiction_ = true;
    } else {
      const Literal unit = head.empty() ? head_[0] : head[0];
      if (!store.has(unit, ClauseStore::unit)) units_.push_back(unit);
    }
    return;
  }
  if (alternatives > 1 && !may_have_alternatives(store)) return;
  if (literals_.size() > max_waiting_literals) return effort_.stop();
  sizes_.push_back({body_.size(), alternatives});
  literals_.insert(literals_.end(), body_.begin(), body_.end());
  literals_.insert(literals_.end(), head_.begin(), head_.end());
  literals_.insert(literals_.end(), head.begin(), head.end());
}

void Conclusions::conclude(ClauseStore& store, Premise premise, Literal instead) {
  if (premise.clause == no_clause) {
    if (!store.has(instead, ClauseStore::unit)) units_.push_back(instead);
    return;
  }
  begin();
  add_side(store, premise);
  finish(store, std::span(&instead, 1));
}

// A context with many alternatives would derive every combination of them. It goes on without them. All that
// it derives from the rest is sound; the gap says that something may be missing.
bool Conclusions::may_have_alternatives(ClauseStore& store) {
  if (store.is_cut()) return false;
  if (store.count_alternative(shared_.max_alternatives())) return true;
  shared_.count_cut_context();
  return false;
}

// At-mosts match every combination of the neighbours. Nearly all of these matches conclude nothing that is new.
bool Conclusions::may_match_alternatives(ClauseStore& store) {
  const bool was_cut = store.is_cut();
  if (store.count_match(shared_.max_matches())) return true;
  if (!was_cut) shared_.count_cut_context();
  return false;
}

}  // namespace geminga::consequence
