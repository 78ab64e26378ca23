#include "discovery/matching/agenda.hpp"

#include <algorithm>
#include <utility>

#include "discovery/matching/candidates.hpp"

namespace geminga::matching {

using registry::StoredPublication;
using registry::StoredSubscription;

class Agenda::Step {
 public:
  explicit Step(const Judge& judge, std::uint64_t& passed) : judge_(judge), passed_(passed) {}
  void pass() { ++passed_; }
  [[nodiscard]] bool has_room() const {
    return judge_.judged() - judged_before_ < max_judged_in_step && passed_ - passed_before_ < max_passed_in_step;
  }

 private:
  const Judge& judge_;
  std::uint64_t& passed_;
  std::uint64_t judged_before_ = judge_.judged();
  std::uint64_t passed_before_ = passed_;
};

namespace {

template <typename Stored>
void replace_by_null(std::vector<const Stored*>& entries, const Stored& gone) {
  std::ranges::replace(entries, &gone, static_cast<const Stored*>(nullptr));
}

}  // namespace

bool Agenda::is_empty() const {
  if (!spreads_.empty() || !reviews_.empty() || !anew_.empty() || !described_.empty()) return false;
  if (pairs_.has_postponed()) return false;
  const auto& other = editions_.other().converters;
  return !editions_.in_force().converters->has_stale() && (other == nullptr || !other->has_stale());
}

bool Agenda::next() {
  take_postponed();
  if (!spreads_.empty()) {
    proceed(spreads_.front());
    if (spreads_.front().is_over()) {
      pairs_.watch_takers(nullptr);
      spreads_.pop_front();
    }
    return true;
  }
  if (reviews_.empty() && !anew_.empty()) {
    const StoredSubscription* subscription = anew_.back();
    anew_.pop_back();
    ++passed_;
    if (subscription != nullptr) reviews_.push_back(review(*subscription, Review::Kind::all));
    if (reviews_.empty()) return true;
  }
  if (reviews_.empty() && !described_.empty()) {
    take_described();
    if (reviews_.empty()) return true;
  }
  if (!reviews_.empty()) {
    proceed(reviews_.front());
    if (reviews_.front().left.empty()) reviews_.pop_front();
    return true;
  }
  return take_stale();
}

void Agenda::take_some() {
  const std::uint64_t judged = judge_.judged();
  const std::uint64_t passed = passed_;
  for (std::size_t count = 0; count < max_rejudged_at_once; ++count) {
    const bool is_enough =
        judge_.judged() - judged >= 4 * max_judged_in_step || passed_ - passed >= 8 * max_passed_in_step;
    if (is_enough || !next()) return;
  }
}

void Agenda::judge(const StoredPublication& publication, std::unique_ptr<Cause> cause,
                   std::vector<const StoredSubscription*> concerned, LookBack look_back) {
  if (concerned.size() <= max_passed_in_step) order_by_key(concerned);
  std::ranges::reverse(concerned);  // taken from the back
  if (cause != nullptr) pairs_.watch_takers(cause->modifies(publication) ? &publication : nullptr);
  spreads_.push_back(
      {.publication = &publication,
       .cause = std::move(cause),
       .left = std::move(concerned),
       .look_back = look_back == LookBack::at_candidates ? std::optional<std::uint32_t>(0) : std::nullopt,
       .is_done = std::vector<bool>(directory_.requests().slots())});
}

Agenda::Review Agenda::review(const StoredSubscription& subscription, Review::Kind kind) const {
  Review review{.subscription = &subscription, .kind = kind, .cause = nullptr, .candidates = {}, .left = {}};
  if (kind == Review::Kind::all) {
    for (const auto& [rank, publication] : pairs_.choice(subscription).candidates()) {
      review.candidates.push_back(publication);
    }
  }
  directory_.visit_publications_for(subscription, [&](const StoredPublication& publication) {
    review.left.push_back(&publication);
    return false;
  });
  std::ranges::reverse(review.left);  // taken from the back
  return review;
}

void Agenda::judge(const StoredSubscription& subscription, std::unique_ptr<Cause> cause) {
  reviews_.push_back(review(subscription, Review::Kind::all));
  reviews_.back().cause = std::move(cause);
}

void Agenda::judge_services_of(ParticipantId participant) {
  for (const ServiceKey& subscription : directory_.requests().asking_on())
    described_.emplace(subscription, participant);
}

void Agenda::judge_anew(const std::vector<const StoredSubscription*>& subscriptions) {
  anew_.insert(anew_.begin(), subscriptions.rbegin(), subscriptions.rend());  // taken from the back
}

void Agenda::relieve() {
  for (const auto* publication : pairs_.take_relieved()) {
    judge(*publication, nullptr, directory_.subscriptions_found_for(*publication), LookBack::none);
  }
}

void Agenda::proceed(Spread& spread) {
  Step step(judge_, passed_);
  while (!spread.left.empty() && step.has_room()) {
    const StoredSubscription* subscription = spread.left.back();
    spread.left.pop_back();
    step.pass();
    if (subscription != nullptr) judge_one(spread, *subscription);
  }
  while (spread.left.empty() && spread.look_back && step.has_room()) {
    const ConsideredBy& considered_by = pairs_.considered_by(*spread.publication);
    const auto next = considered_by.lower_bound(*spread.look_back);
    step.pass();
    if (next == considered_by.end()) {
      spread.look_back.reset();
    } else {
      spread.look_back = next->first + 1;
      judge_one(spread, directory_.requests().at(next->first));
    }
  }
}

void Agenda::judge_one(Spread& spread, const StoredSubscription& subscription) {
  if (subscription.slot >= spread.is_done.size() || spread.is_done[subscription.slot]) return;
  spread.is_done[subscription.slot] = true;
  if (directory_.requests().is_going(subscription) || !pairs_.concerns(subscription, *spread.publication)) return;
  // A subscription that has taken it up since then was told of it as it is.
  const bool knew_it = spread.cause != nullptr && !pairs_.has_taken(subscription.slot);
  Cause nothing;
  Cause& cause = knew_it ? *spread.cause : nothing;
  pairs_.judge(subscription, *spread.publication, cause);
  pairs_.settle(subscription, cause);
}

void Agenda::proceed(Review& review) {
  const StoredSubscription& subscription = *review.subscription;
  Step step(judge_, passed_);
  if (directory_.requests().is_going(subscription)) {
    review.left.clear();
    return;
  }
  Cause nothing;
  Cause& cause = review.cause == nullptr ? nothing : *review.cause;
  // They are at most as many as a subscription may have, and each is looked at in this step, so that none goes
  // meanwhile.
  for (const auto* candidate : std::exchange(review.candidates, {})) {
    step.pass();
    if (candidate != nullptr) pairs_.judge(subscription, *candidate, cause);
  }
  while (!review.left.empty() && step.has_room()) {
    const StoredPublication* publication = review.left.back();
    review.left.pop_back();
    step.pass();
    if (publication == nullptr || directory_.offers().is_going(*publication)) continue;
    if (review.kind == Review::Kind::chains) {
      judge_chain(subscription, *publication, cause);
    } else if (!pairs_.considered_by(*publication).contains(subscription.slot)) {
      pairs_.judge(subscription, *publication, cause);
    }
  }
  if (!review.left.empty()) return;
  if (review.kind == Review::Kind::refill) pairs_.end_refill(subscription);
  pairs_.settle_all(subscription, cause);
}

void Agenda::judge_chain(const StoredSubscription& subscription, const StoredPublication& publication,
                         const Cause& cause) {
  const auto& considered = pairs_.considered_by(publication);
  const auto known = considered.find(subscription.slot);
  const auto chain = directory_.chain(subscription, publication);
  const bool is_converted = chain != nullptr && chain->cost <= subscription.entry.subscription.convert;
  const std::uint32_t mark = is_converted ? chain->mark : 0;
  // The mark is 0 for a pair without a conversion, and for a publication that is no candidate.
  const std::uint32_t was = known == considered.end() ? 0 : known->second.match.chain;
  if (mark != was) pairs_.judge(subscription, publication, cause);
  passed_ += directory_.requests().edition_of(subscription).converters->take_work();
}

void Agenda::take_postponed() {
  for (const auto* subscription : pairs_.take_postponed()) {
    reviews_.push_back(review(*subscription, Review::Kind::refill));
  }
}

void Agenda::take_described() {
  const auto [key, participant] = *described_.begin();
  described_.erase(described_.begin());
  ++passed_;
  const StoredSubscription* subscription = directory_.requests().table().find(key);
  if (subscription == nullptr || directory_.requests().is_going(*subscription)) return;
  Review one{.subscription = subscription, .kind = Review::Kind::all, .cause = nullptr, .candidates = {}, .left = {}};
  for (const StoredPublication* publication : directory_.offers().table().of_participant(participant)) {
    const bool is_considered = pairs_.considered_by(*publication).contains(subscription->slot);
    (is_considered ? one.candidates : one.left).push_back(publication);
  }
  if (!one.candidates.empty() || !one.left.empty()) reviews_.push_back(std::move(one));
}

bool Agenda::take_stale() {
  if (is_empty()) return false;
  Converters& converters =
      editions_.in_force().converters->has_stale() ? *editions_.in_force().converters : *editions_.other().converters;
  const auto key = converters.next_stale();
  passed_ += converters.take_work();
  if (!key) return converters.has_stale() || !is_empty();
  converters.refresh(*key);
  const auto* subscription = directory_.requests().table().find(*key);
  if (subscription == nullptr || directory_.requests().is_going(*subscription)) return true;
  reviews_.push_back(review(*subscription, Review::Kind::chains));
  proceed(reviews_.back());
  if (reviews_.back().left.empty()) reviews_.pop_back();
  return true;
}

void Agenda::catch_up(const StoredSubscription& subscription) {
  Converters& converters = *directory_.requests().edition_of(subscription).converters;
  if (!converters.is_stale(subscription.entry.key)) return;
  converters.refresh(subscription.entry.key);
  Review all = review(subscription, Review::Kind::chains);
  do {
    proceed(all);
  } while (!all.left.empty());
}

void Agenda::forget(const StoredPublication& publication) {
  supersede(publication);
  for (Review& review : reviews_) {
    replace_by_null(review.candidates, publication);
    replace_by_null(review.left, publication);
  }
}

void Agenda::forget(const StoredSubscription& subscription) {
  supersede(subscription);
  for (Spread& spread : spreads_) replace_by_null(spread.left, subscription);
}

void Agenda::supersede(const StoredPublication& publication) {
  const auto gone = std::erase_if(spreads_, [&](const Spread& spread) { return spread.publication == &publication; });
  if (gone > 0) pairs_.watch_takers(nullptr);
}

void Agenda::supersede(const StoredSubscription& subscription) {
  std::erase_if(reviews_, [&](const Review& review) { return review.subscription == &subscription; });
  replace_by_null(anew_, subscription);
  pairs_.forget_postponed(subscription);
}

}  // namespace geminga::matching
