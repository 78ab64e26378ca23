#include "discovery/matching/pairs.hpp"

#include <functional>
#include <utility>

#include "discovery/matching/interest.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;
using registry::SubscriptionEntry;

void Pairs::add(const StoredPublication& publication) {
  if (publication.slot >= considered_by_.size()) considered_by_.resize(publication.slot + 1);
}

void Pairs::prepare(const StoredSubscription& subscription, const Request* former) {
  if (subscription.slot >= choosers_.size()) choosers_.resize(subscription.slot + 1);
  Chooser* chooser = find_chooser(subscription);
  if (chooser == nullptr) return;
  if (former != nullptr && former->preferences != directory_.requests().request(subscription).preferences) {
    chooser->choice.release_waiting();
    forget_dropped(subscription);
  }
  set_terms(subscription, *chooser);
  chooser->is_waiting = chooser->has_withheld = false;
}

void Pairs::set_terms(const StoredSubscription& subscription, Chooser& chooser) const {
  chooser.choice.set_margins(directory_.requests().request(subscription).preferences.margins());
  chooser.choice.set_limit(arbitrated_limit(subscription.entry));
}

Pairs::Chooser& Pairs::chooser_of(const StoredSubscription& subscription) {
  auto& chooser = choosers_[subscription.slot];
  if (!chooser) {
    chooser = std::make_unique<Chooser>();
    set_terms(subscription, *chooser);
  }
  return *chooser;
}

bool Pairs::was_chosen_unseen(const StoredPublication& publication, const Cause& cause) const {
  const auto* replaced = cause.replaced_subscription();
  if (replaced == nullptr) return false;
  const SubscriptionEntry& before = *replaced->before.entry;
  const Edition& edition = directory_.requests().edition_of(replaced->before);
  const bool was_kept_apart =
      replaced->was_clashing && before.subscription.identity.index() != publication.entry.publication.identity.index();
  const bool was_announced = before.subscription.chosen.empty() || is_announced_choice(before, publication.entry);
  if (!was_announced || was_kept_apart || !is_provider_told(before.subscription.mode)) return false;
  if (is_of_interest(before, publication.entry)) return false;
  const Request& request = replaced->before.request;
  const Offer offer = judge_.described(directory_.offers().offer(publication, edition), request, edition);
  return meets(before, request, offer, edition.vocabulary).has_value();
}

bool Pairs::is_hopeless(const StoredSubscription& subscription, const StoredPublication& publication,
                        const Cause& cause) {
  // A replaced subscription without a limit may have been given this publication unseen. Only judging the pair shows
  // it.
  if (cause.replaced_subscription() != nullptr) return false;
  constexpr Match best_possible;
  Choice& choice = chooser_of(subscription).choice;
  return choice.has_passed_over() &&
         choice.passes_over(directory_.requests().request(subscription).rank(publication.entry, best_possible));
}

void Pairs::judge(const StoredSubscription& subscription, const StoredPublication& publication, const Cause& cause) {
  auto& considered = considered_by_[publication.slot];
  const bool is_interesting = is_of_interest(subscription.entry, publication.entry);
  const auto known = considered.find(subscription.slot);
  if (!is_interesting && known == considered.end()) return;
  auto& choice = chooser_of(subscription).choice;
  if (known == considered.end() && is_hopeless(subscription, publication, cause)) return;
  const auto [match, waits, is_kept_back] = judge_.judge(subscription, publication);
  if (waits) chooser_of(subscription).is_waiting = true;
  if (is_kept_back) chooser_of(subscription).has_withheld = true;
  if (!match || !is_interesting) {
    if (known == considered.end()) return;
    // A match that is of no interest: its consumer has chosen others.
    const Reason reason = match ? Reason::outranked : is_kept_back ? Reason::unreachable : Reason::changed;
    choice.withdraw(known->second, directory_.offers().reason_to_go(publication).value_or(reason));
    considered.erase(known);
    return;
  }
  const Rank rank = directory_.requests().request(subscription).rank(publication.entry, *match);
  if (known != considered.end()) {
    choice.change(std::exchange(known->second, rank), rank);
  } else {
    const bool is_incumbent = was_chosen_unseen(publication, cause);
    if (!is_incumbent && choice.passes_over(rank)) return;
    if (is_turned_away(subscription, publication)) return;
    considered.emplace(subscription.slot, rank);
    if (&publication == watched_) takers_.insert(subscription.slot);
    choice.offer(rank, publication, is_incumbent);
  }
  forget_dropped(subscription);
}

void Pairs::judge_all(const StoredSubscription& subscription, const Cause& cause) {
  end_refill(subscription);
  for (const auto& [rank, publication] : choice(subscription).candidates()) judge(subscription, *publication, cause);
  directory_.visit_publications_for(subscription, [&](const StoredPublication& publication) {
    if (!considered_by(publication).contains(subscription.slot)) judge(subscription, publication, cause);
    return false;
  });
}

void Pairs::refill(const StoredSubscription& subscription, const Cause& cause) {
  forget_dropped(subscription);
  std::vector<const StoredPublication*> found;
  directory_.visit_publications_for(subscription, [&](const StoredPublication& publication) {
    found.push_back(&publication);
    return found.size() > max_refilled_at_once;
  });
  if (found.size() > max_refilled_at_once) {
    chooser_of(subscription).choice.postpone_refill();
    postponed_.push_back(&subscription);
    return;
  }
  for (const auto* publication : found) {
    const bool is_candidate =
        !directory_.offers().is_going(*publication) && !considered_by(*publication).contains(subscription.slot);
    if (is_candidate) judge(subscription, *publication, cause);
  }
}

void Pairs::forget_dropped(const StoredSubscription& subscription) {
  Chooser* chooser = find_chooser(subscription);
  if (chooser == nullptr) return;
  for (const auto* dropped : chooser->choice.take_dropped()) considered_by_[dropped->slot].erase(subscription.slot);
}

void Pairs::settle(const StoredSubscription& subscription, Cause& cause) {
  Chooser* chooser = find_chooser(subscription);
  const auto refill_choice = [&] { refill(subscription, cause); };
  const Verdict verdict = chooser == nullptr ? Verdict() : chooser->choice.settle(std::ref(refill_choice));
  forget_dropped(subscription);
  events_.tell(subscription, verdict, cause);
  if (!subscription.entry.is_local) return;
  const bool is_same = verdict.gone.empty() && verdict.come.empty() && verdict.outranked.empty();
  const bool is_contested = choice(subscription).is_contested() || (chooser != nullptr && chooser->has_withheld);
  announced_.update(subscription, choice(subscription), is_contested, !is_same || cause.replaces(subscription));
}

void Pairs::settle_all(const StoredSubscription& subscription, Cause& cause) {
  Chooser* chooser = find_chooser(subscription);
  if (chooser != nullptr && cause.replaces(subscription)) chooser->choice.touch_all();
  settle(subscription, cause);
}

bool Pairs::concerns(const StoredSubscription& subscription, const StoredPublication& publication) const {
  return is_of_interest(subscription.entry, publication.entry) ||
         considered_by(publication).contains(subscription.slot);
}

void Pairs::judge_anew(const std::vector<const StoredSubscription*>& subscriptions, Cause& cause) {
  for (const auto* subscription : subscriptions) {
    judge_all(*subscription, cause);
    settle(*subscription, cause);
  }
}

bool Pairs::is_turned_away(const StoredSubscription& subscription, const StoredPublication& publication) {
  // A consumer with a limit remembers few candidates anyway, however many publications there are.
  const bool takes_all = !subscription.entry.is_local && arbitrated_limit(subscription.entry) == 0;
  if (!takes_all || considered_by(publication).size() < max_consumers) return false;
  crowded_.insert(publication.entry.key);
  return true;
}

std::vector<const StoredPublication*> Pairs::take_relieved() {
  std::vector<const StoredPublication*> relieved;
  for (auto at = crowded_.begin(); at != crowded_.end();) {
    const StoredPublication* stored = directory_.offers().table().find(*at);
    if (stored != nullptr && considered_by(*stored).size() > max_consumers / 2) {
      ++at;
      continue;
    }
    at = crowded_.erase(at);
    if (stored != nullptr) relieved.push_back(stored);
  }
  return relieved;
}

std::vector<const StoredSubscription*> Pairs::withdraw(const std::vector<const StoredPublication*>& publications,
                                                       Reason reason) {
  std::vector<const StoredSubscription*> concerned;
  for (const auto* publication : publications) {
    for (const auto& [slot, rank] : considered_by(*publication)) {
      choosers_[slot]->choice.withdraw(rank, reason);
      concerned.push_back(&directory_.requests().at(slot));
    }
    considered_by_[publication->slot].clear();
  }
  passed_ += concerned.size();
  order_by_key(concerned);
  return concerned;
}

void Pairs::end(const StoredSubscription& subscription, Reason reason, Cause& cause) {
  const Choice& choice = this->choice(subscription);
  events_.tell_end(subscription, choice.chosen(), reason, cause);
  for (const auto& [rank, publication] : choice.candidates()) {
    considered_by_[publication->slot].erase(subscription.slot);
    ++passed_;
  }
  choosers_[subscription.slot].reset();
  announced_.erase(subscription);
}

std::optional<Match> Pairs::chosen_match(const StoredSubscription& subscription,
                                         const StoredPublication& publication) const {
  const auto& considered = considered_by(publication);
  const auto known = considered.find(subscription.slot);
  const bool is_chosen = known != considered.end() && choice(subscription).is_chosen(known->second);
  return is_chosen ? std::optional(known->second.match) : std::nullopt;
}

}  // namespace geminga::matching
