// The change from one vocabulary to another, in steps between which everything else goes on.
#include <algorithm>
#include <utility>

#include "base/assert.hpp"
#include "discovery/matching/state.hpp"

namespace geminga::matching {
namespace {

using registry::StoredPublication;
using registry::StoredSubscription;

/// How many entries one step of a walk may pass while it looks for one that needs work.
constexpr std::size_t entries_in_step = 64;

/// The first entry behind `at`, and moves `at` there; null where there is none.
template <typename Table>
auto next_after(const Table& table, std::optional<ServiceKey>& at) {
  const typename Table::StoredEntry* found = nullptr;
  table.visit_after(at, [&](const auto& stored) {
    found = &stored;
    return false;
  });
  if (found != nullptr) at = found->entry.key;
  return found;
}

}  // namespace

Matcher::State::State(vocabulary::Vocabulary vocabulary, Placing placing, Overlapping overlapping)
    : in_force_{.vocabulary = vocabulary, .converters = std::make_shared<Converters>(vocabulary)},
      placing_(std::move(placing)) {
  if (overlapping) {
    overlapping_ = [this, overlapping = std::move(overlapping)](const auto&... question) {
      OverlapAnswer answer = overlapping(question...);
      if (answer == nullptr) has_waited_ = true;
      return answer;
    };
  }
  publications_.set_class_count(in_force_.vocabulary.class_count());
  subscriptions_.set_class_count(in_force_.vocabulary.class_count());
}

void Matcher::State::begin_vocabulary(vocabulary::Vocabulary next) {
  GEMINGA_ASSERT(stage_ == Stage::none);
  other_ = {next, registry::other(in_force_.generation), std::make_shared<Converters>(next)};
  publications_.set_class_count(other_.vocabulary.class_count(), other_.generation);
  subscriptions_.set_class_count(other_.vocabulary.class_count(), other_.generation);
  stage_ = Stage::filing;
  at_.reset();
}

bool Matcher::State::file_next() {
  GEMINGA_ASSERT(stage_ == Stage::filing);
  const auto* stored = next_after(publications_, at_);
  if (stored == nullptr) return false;
  file(*stored, other_);
  return true;
}

void Matcher::State::put_in_force() {
  GEMINGA_ASSERT(stage_ == Stage::filing);
  std::swap(in_force_, other_);
  stage_ = Stage::rematching;
  at_.reset();
  placing_walk_.reset();  // all are asked for their places now
}

bool Matcher::State::rematch_next() {
  GEMINGA_ASSERT(stage_ != Stage::filing);
  if (stage_ == Stage::unfiling) return unfile_next();
  if (stage_ == Stage::none) return place_next();
  const auto before = at_;
  const auto* stored = next_after(subscriptions_, at_);
  if (stored == nullptr) {
    stage_ = Stage::unfiling;
    at_.reset();
    return true;
  }
  if (of(*stored).generation != in_force_.generation && !rematch_if_answered(*stored)) at_ = before;
  return true;
}

bool Matcher::State::asks_overlaps(const StoredSubscription& subscription, const Request& request) const {
  if (!request.overlaps) return true;
  has_waited_ = false;
  const Subscription& asked = subscription.entry.subscription;
  visit_publications(publications_, asked.identity, request.classes, asked.weakest, in_force_,
                     [&](const StoredPublication& publication) {
                       if (of_publication_[publication.slot].leaves) return false;
                       static_cast<void>(meet(subscription.entry, request, publication, in_force_));
                       return has_waited_;
                     });
  return !has_waited_;
}

bool Matcher::State::rematch_if_answered(const StoredSubscription& subscription) {
  Request request = prepare(subscription.entry, false);
  const bool may_wait = subscription.entry.is_local && !of(subscription).is_leaving;
  if (may_wait && !asks_overlaps(subscription, request)) return false;
  rematch(subscription, std::move(request));
  return true;
}

void Matcher::State::rematch(const StoredSubscription& subscription, Request request) {
  begin_cause();
  unwatch(subscription);
  subscriptions_.unfile(subscription, of(subscription).generation);
  of(subscription).generation = in_force_.generation;
  of(subscription).is_waiting = false;
  if (of(subscription).is_leaving) return;
  release_if_others(subscription, request.preferences);
  of(subscription).choice.set_margins(request.preferences.margins());
  of(subscription).request.preferences = std::move(request.preferences);
  of(subscription).request.where = std::move(request.where);
  of(subscription).request.signature = std::move(request.signature);
  of(subscription).request.overlaps = std::move(request.overlaps);
  of(subscription).request.chains = std::move(request.chains);
  of(subscription).request.consumer = std::move(request.consumer);
  const auto& known = of(subscription).request.classes = std::move(request.classes);
  const FilingPlan plan = FilingPlan::of_subscription(known, subscription.entry.subscription.weakest, in_force_);
  subscriptions_.refile(subscription, plan.filing());
  filed_ += 1 + plan.size();
  watch(subscription);
  judge_all(subscription);
  settle(subscription);
}

bool Matcher::State::unfile_next() {
  const auto* stored = next_after(publications_, at_);
  if (stored == nullptr) {
    publications_.set_class_count(0, other_.generation);
    subscriptions_.set_class_count(0, other_.generation);
    other_ = {};
    stage_ = Stage::none;
    return true;
  }
  filed_ += 1 + stored->classes[std::to_underlying(other_.generation)].size();
  publications_.unfile(*stored, other_.generation);
  of(*stored).classes[std::to_underlying(other_.generation)] = {};
  of(*stored).signatures[std::to_underlying(other_.generation)] = nullptr;
  return true;
}

bool Matcher::State::take_prepared(vocabulary::Vocabulary prepared) {
  const bool is_news = !in_force_.vocabulary.is_prepared() && prepared.is_prepared();
  if (!is_news || !prepared.has_ontology_of(in_force_.vocabulary)) return false;
  in_force_.vocabulary = std::move(prepared);
  return true;
}

void Matcher::State::place_again() {
  if (placing_walk_) {
    placing_walk_->must_repeat = true;
  } else {
    placing_walk_ = PlaceWalk{std::nullopt, false};
  }
}

bool Matcher::State::place_next() {
  if (!placing_walk_) return false;
  const StoredSubscription* waiting = nullptr;
  std::size_t passed = 0;
  std::optional<ServiceKey> before;
  const bool is_over = subscriptions_.visit_after(placing_walk_->at, [&](const StoredSubscription& stored) {
    before = std::exchange(placing_walk_->at, stored.entry.key);
    const bool is_placed = of(stored).request.classes.place != nullptr;
    const bool must_be_placed = !is_placed && has_expression(stored.entry.subscription.identity);
    if (must_be_placed || of(stored).is_waiting) waiting = &stored;
    return waiting == nullptr && ++passed < entries_in_step;
  });
  filed_ += passed;
  if (waiting != nullptr) {
    if (!rematch_if_answered(*waiting)) placing_walk_->at = before;
  } else if (is_over) {
    placing_walk_ = placing_walk_->must_repeat ? std::optional(PlaceWalk{std::nullopt, false}) : std::nullopt;
  }
  return true;
}

std::vector<const StoredSubscription*> Matcher::State::subscriptions_for(const StoredPublication& publication) const {
  std::vector<const StoredSubscription*> found;
  add_subscriptions_for(subscriptions_, publication, classes(publication, in_force_), in_force_, found);
  if (stage_ == Stage::rematching) {
    add_subscriptions_for(subscriptions_, publication, classes(publication, other_), other_, found);
  }
  order_by_key(found);
  return found;
}

}  // namespace geminga::matching
