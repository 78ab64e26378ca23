#include "discovery/matching/vocabulary_change.hpp"

#include <cstddef>
#include <utility>

#include "base/assert.hpp"

namespace geminga::matching {
namespace {

using registry::StoredPublication;
using registry::StoredSubscription;

/// How many entries one step of a walk may pass while it looks for one that needs work.
constexpr std::size_t entries_in_step = 64;

/// The first entry behind `at`, to which `at` moves; null where there is none.
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

void VocabularyChange::begin(const vocabulary::Vocabulary& next) {
  agenda_.finish();
  editions_.begin_filing(next);
  directory_.offers().open_index(editions_.other());
  directory_.requests().open_index(editions_.other());
  at_.reset();
}

bool VocabularyChange::file_next() {
  GEMINGA_ASSERT(editions_.stage() == ChangeStage::filing);
  const auto* stored = next_after(directory_.offers().table(), at_);
  if (stored == nullptr) return false;
  directory_.offers().file(*stored, editions_.other());
  return true;
}

void VocabularyChange::put_in_force() {
  editions_.begin_rematching();
  at_.reset();
  place_walk_.reset();  // all are asked for their places now
}

bool VocabularyChange::rematch_next() {
  GEMINGA_ASSERT(editions_.stage() != ChangeStage::filing);
  if (editions_.stage() == ChangeStage::none) return place_next();
  if (editions_.stage() == ChangeStage::unfiling) {
    unfile_next();
    return true;
  }
  const auto before = at_;
  const auto* stored = next_after(directory_.requests().table(), at_);
  if (stored == nullptr) {
    editions_.begin_unfiling();
    at_.reset();
    return true;
  }
  const bool is_due = directory_.requests().edition_of(*stored).generation != editions_.in_force().generation;
  if (is_due && !rematch_if_answered(*stored)) at_ = before;
  return true;
}

void VocabularyChange::catch_up(const ServiceKey& subscription) {
  const StoredSubscription* stored = directory_.requests().table().find(subscription);
  if (stored == nullptr || directory_.requests().edition_of(*stored).generation == editions_.in_force().generation)
    return;
  rematch(*stored, preparation_.prepare(stored->entry));
}

bool VocabularyChange::asks_all(const StoredSubscription& subscription, const Request& request) const {
  if (!request.asks.overlaps && !request.asks.compares && !(request.on && request.on->compares)) return true;
  bool waits = false;
  directory_.visit_publications_for(
      subscription.entry.subscription, request, [&](const StoredPublication& publication) {
        if (directory_.offers().is_going(publication)) return false;
        waits = judge_.judge(subscription.entry, request, publication, editions_.in_force()).waits;
        return waits;
      });
  return !waits;
}

bool VocabularyChange::rematch_if_answered(const StoredSubscription& subscription) {
  Request request = preparation_.prepare(subscription.entry);
  const bool may_wait = subscription.entry.is_local && !directory_.requests().is_going(subscription);
  if (may_wait && !asks_all(subscription, request)) return false;
  rematch(subscription, std::move(request));
  return true;
}

void VocabularyChange::rematch(const StoredSubscription& subscription, Request request) {
  directory_.requests().unfile(subscription);
  if (directory_.requests().is_going(subscription)) return;
  const Request former = directory_.requests().file(subscription, std::move(request));
  pairs_.prepare(subscription, &former);
  Cause cause;
  pairs_.judge_all(subscription, cause);
  pairs_.settle(subscription, cause);
}

void VocabularyChange::unfile_next() {
  const auto* stored = next_after(directory_.offers().table(), at_);
  if (stored != nullptr) {
    directory_.offers().unfile(*stored, editions_.other());
    return;
  }
  directory_.offers().close_index(editions_.other());
  directory_.requests().close_index(editions_.other());
  editions_.end_change();
}

void VocabularyChange::place_again() {
  if (place_walk_) {
    place_walk_->must_repeat = true;
  } else {
    place_walk_ = PlaceWalk();
  }
}

bool VocabularyChange::place_next() {
  if (!place_walk_) return false;
  if (!place_walk_->is_among_subscriptions) {
    if (place_publications()) {
      place_walk_->at.reset();
      place_walk_->is_among_subscriptions = true;
    }
  } else if (place_subscriptions()) {
    const bool must_repeat = place_walk_->must_repeat;
    place_walk_ = must_repeat ? std::optional(PlaceWalk()) : std::nullopt;
  }
  return true;
}

bool VocabularyChange::place_publications() {
  const Edition& edition = editions_.in_force();
  const StoredPublication* waiting = nullptr;
  std::size_t passed = 0;
  const bool is_over = directory_.offers().table().visit_after(place_walk_->at, [&](const StoredPublication& stored) {
    place_walk_->at = stored.entry.key;
    const bool is_due = has_expression(stored.entry.publication.identity) &&
                        directory_.offers().classes(stored, edition).place == nullptr &&
                        !directory_.offers().is_going(stored);
    if (is_due) waiting = &stored;
    return waiting == nullptr && ++passed < entries_in_step;
  });
  passed_ += passed;
  if (waiting == nullptr) return is_over;
  directory_.offers().file(*waiting, edition);
  if (directory_.offers().classes(*waiting, edition).place) {
    agenda_.judge(*waiting, nullptr, directory_.subscriptions_found_for(*waiting), Agenda::LookBack::none);
    if (waiting->entry.publication.mode == ChannelMode::participant)
      agenda_.judge_services_of(waiting->entry.key.participant);
  }
  return false;
}

bool VocabularyChange::place_subscriptions() {
  const StoredSubscription* waiting = nullptr;
  std::size_t passed = 0;
  std::optional<ServiceKey> before;
  const bool is_over =
      directory_.requests().table().visit_after(place_walk_->at, [&](const StoredSubscription& stored) {
        before = std::exchange(place_walk_->at, stored.entry.key);
        const bool is_placed = directory_.requests().request(stored).classes.place != nullptr;
        const auto& on = directory_.requests().request(stored).on;
        const bool is_on_unplaced = on && has_expression(on->identity) && on->classes.place == nullptr;
        const bool must_be_placed =
            is_on_unplaced || (!is_placed && has_expression(stored.entry.subscription.identity));
        const bool is_due = must_be_placed || pairs_.is_waiting(stored);
        if (is_due && !directory_.requests().is_going(stored)) waiting = &stored;
        return waiting == nullptr && ++passed < entries_in_step;
      });
  passed_ += passed;
  if (waiting == nullptr) return is_over;
  if (!rematch_if_answered(*waiting)) place_walk_->at = before;
  return false;
}

}  // namespace geminga::matching
