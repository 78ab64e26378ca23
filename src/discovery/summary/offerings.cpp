#include "discovery/summary/offerings.hpp"

#include <algorithm>
#include <variant>

#include "discovery/summary/limits.hpp"
#include "discovery/summary/magnitude.hpp"

namespace geminga::summary {
namespace {

/// So many answers in answer_spread are few.
constexpr unsigned few_answers_magnitude = 7;

/// The time in which answers come, by the magnitude of the sites that are known to give one.
base::Duration spread_of(unsigned sites) {
  const unsigned doublings = sites > few_answers_magnitude ? std::min(sites - few_answers_magnitude, 8U) : 0;
  return answer_spread * (1 << doublings);
}

void count_one(std::uint32_t& count, bool is_there) {
  if (is_there) {
    ++count;
  } else if (count > 0) {
    --count;
  }
}

}  // namespace

std::uint32_t Offerings::count_of_iri(const std::string& iri) const {
  if (vocabulary_.is_loaded()) {
    if (const auto number = vocabulary_.find_iri(iri)) {
      const auto found = below_.find(*number);
      return found == below_.end() ? 0 : found->second;
    }
  }
  const auto found = unknown_.find(iri);
  return found == unknown_.end() ? 0 : found->second;
}

std::uint32_t Offerings::count(const Topic& topic) const {
  if (topic.digest == 0) return count_of_iri(topic.iri);
  if (topic.digest != digest_) return 0;
  const auto found = below_.find(vocabulary::ClassNumber{topic.rank});
  return found == below_.end() ? 0 : found->second;
}

void Offerings::change(const Identity& identity, bool is_there, base::Instant now) {
  const auto* semantic = std::get_if<SemanticIdentity>(&identity);
  if (semantic == nullptr) return;
  const auto number = vocabulary_.is_loaded() ? vocabulary_.find_iri(semantic->concept_iri) : std::nullopt;
  if (!number) {
    std::uint32_t& count = unknown_[semantic->concept_iri];
    count_one(count, is_there);
    if (count == 0) unknown_.erase(semantic->concept_iri);
    changed({.digest = 0, .rank = 0, .iri = semantic->concept_iri}, now);
    return;
  }
  for (const vocabulary::ClassNumber above : vocabulary_.subsumers(*number)) {
    std::uint32_t& count = below_[above];
    count_one(count, is_there);
    if (count == 0) below_.erase(above);
    changed({.digest = digest_, .rank = std::to_underlying(above)}, now);
    changed({.digest = 0, .rank = 0, .iri = std::string(vocabulary_.iri(above))}, now);
  }
}

void Offerings::changed(const Topic& topic, base::Instant now) {
  const auto one = asked_.find(topic);
  if (one == asked_.end() || one->second.until <= now || one->second.is_question) return;
  const bool is_due = is_other(one->second.magnitude, count(topic));
  const bool was_said = one->second.said != base::Instant::min();
  set_due(one, !is_due ? base::never : was_said ? std::max(now, one->second.said + change_spacing) : now);
}

void Offerings::set_due(Topics::iterator one, base::Instant due) {
  if (one->second.due != base::never) dues_.erase({one->second.due, one->first});
  one->second.due = due;
  if (due != base::never) dues_.emplace(due, one->first);
}

void Offerings::forget_old(base::Instant now) {
  for (auto one = asked_.begin(); one != asked_.end();) {
    if (one->second.until > now) {
      ++one;
      continue;
    }
    set_due(one, base::never);
    one = asked_.erase(one);
  }
}

void Offerings::hear(const Message& question, base::Instant now, base::Random& random) {
  if (question.kind != Kind::question || question.site == site_) return;
  const bool is_rank = question.topic.digest != 0;
  // A site with another ontology numbers classes differently; one with ours asks for the rank, too.
  if (is_rank && question.topic.digest != digest_) return;
  if (!is_rank && digest_ != 0 && question.digest == digest_ && vocabulary_.find_iri(question.topic.iri)) return;
  if (asked_.size() == max_asked && !asked_.contains(question.topic)) {
    forget_old(now);
    if (asked_.size() == max_asked) {
      ++refused_;
      return;
    }
  }
  const auto one = asked_.try_emplace(question.topic).first;
  one->second.until = now + asked_for;
  if (count(question.topic) == 0 && one->second.magnitude == 0) return;
  one->second.is_question = true;
  set_due(one, now + random.between(base::Duration(0), spread_of(question.magnitude)));
}

std::vector<Message> Offerings::take_answers(base::Instant now) {
  std::vector<Message> answers;
  while (next_due() <= now) {
    const auto one = asked_.find(dues_.begin()->second);
    set_due(one, base::never);
    one->second.is_question = false;
    one->second.said = now;
    one->second.magnitude = magnitude_of(count(one->first));
    answers.push_back({.kind = Kind::answer,
                       .site = site_,
                       .topic = one->first,
                       .digest = digest_,
                       .magnitude = one->second.magnitude});
  }
  return answers;
}

}  // namespace geminga::summary
