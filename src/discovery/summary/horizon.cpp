#include "discovery/summary/horizon.hpp"

#include <algorithm>

#include "discovery/summary/limits.hpp"
#include "discovery/summary/magnitude.hpp"

namespace geminga::summary {
namespace {

/// Spread, so that sites which began together do not ask together.
base::Duration until_next(base::Random& random) { return random.between(ask_again * 4 / 5, ask_again * 6 / 5); }

}  // namespace

bool Horizon::want(const std::string& iri, std::optional<std::uint32_t> rank, base::Instant now) {
  if (interests_.contains(iri)) return true;
  if (interests_.size() == max_interests) return false;
  Interest& interest = interests_[iri];
  if (rank && digest_ != 0) interest.topics.push_back({.digest = digest_, .rank = *rank});
  interest.topics.push_back({.digest = 0, .rank = 0, .iri = iri});
  for (const Topic& topic : interest.topics) ask_at(topics_.emplace(topic, Asking{.iri = iri}).first, now);
  return true;
}

void Horizon::end(const std::string& iri) {
  const auto interest = interests_.find(iri);
  if (interest == interests_.end()) return;
  for (const Topic& topic : interest->second.topics) {
    const auto asking = topics_.find(topic);
    ask_at(asking, base::never);
    topics_.erase(asking);
  }
  remembered_ -= interest->second.said.size();
  interests_.erase(interest);
}

std::vector<Topic> Horizon::topics(const std::string& iri) const {
  const auto interest = interests_.find(iri);
  return interest == interests_.end() ? std::vector<Topic>() : interest->second.topics;
}

void Horizon::ask_at(Topics::iterator topic, base::Instant due) {
  if (topic->second.due != base::never) dues_.erase({topic->second.due, topic->first});
  topic->second.due = due;
  if (due != base::never) dues_.emplace(due, topic->first);
}

void Horizon::hear(const Message& message, base::Instant now, base::Random& random) {
  if (message.site == site_) return;
  if (message.kind == Kind::answer) return hear_answer(message, now);
  if (message.kind != Kind::question) return;
  const auto topic = topics_.find(message.topic);
  if (topic == topics_.end()) return;
  // Sites with our ontology do not answer a question by IRI that a site of our ontology asks.
  const bool is_as_ours = message.topic.digest != 0 || message.digest == digest_;
  // A question that we have not asked yet ourselves is asked: the answers to this one may have gone by.
  if (is_as_ours && topic->second.due > now) ask_at(topic, now + until_next(random));
}

void Horizon::hear_answer(const Message& answer, base::Instant now) {
  const auto topic = topics_.find(answer.topic);
  if (topic == topics_.end()) return;
  Interest& interest = interests_.find(topic->second.iri)->second;
  // A site with our ontology says ranks; by IRI it answers others, and says the same.
  const bool is_said_twice = answer.topic.digest == 0 && answer.digest == digest_ && interest.topics.size() > 1;
  if (is_said_twice) return;
  const auto known = interest.said.find(answer.site);
  if (answer.magnitude == 0) {
    if (known == interest.said.end()) return;
    interest.said.erase(known);
    --remembered_;
    return;
  }
  if (known != interest.said.end()) {
    known->second = {.magnitude = answer.magnitude, .at = now};
    return;
  }
  if (remembered_ == max_remembered) forget_old(now);
  if (remembered_ == max_remembered) {
    ++refused_;
    return;
  }
  interest.said.emplace(answer.site, Said{.magnitude = answer.magnitude, .at = now});
  ++remembered_;
}

void Horizon::forget_old(base::Instant now) {
  for (auto& [iri, interest] : interests_) {
    remembered_ -= std::erase_if(interest.said, [&](const auto& one) { return one.second.at + remembered_for <= now; });
  }
}

void Horizon::forget(SiteId site) {
  for (auto& [iri, interest] : interests_) remembered_ -= interest.said.erase(site);
}

std::vector<Message> Horizon::take_questions(base::Instant now, base::Random& random) {
  std::vector<Message> questions;
  while (next_due() <= now) {
    const auto topic = topics_.find(dues_.begin()->second);
    const auto known = interests_.find(topic->second.iri)->second.said.size();
    questions.push_back({.kind = Kind::question,
                         .site = site_,
                         .topic = topic->first,
                         .digest = digest_,
                         .magnitude = magnitude_of(static_cast<std::uint32_t>(known))});
    ask_at(topic, now + until_next(random));
  }
  return questions;
}

std::vector<Offerer> Horizon::offerers(const std::string& iri, base::Instant now) const {
  std::vector<Offerer> all;
  const auto interest = interests_.find(iri);
  if (interest == interests_.end()) return all;
  for (const auto& [site, said] : interest->second.said) {
    if (said.at + remembered_for > now) all.push_back({.site = site, .magnitude = said.magnitude});
  }
  std::ranges::stable_sort(all, std::ranges::greater{}, &Offerer::magnitude);
  return all;
}

std::vector<Offerer> Horizon::enough(const std::string& iri, std::uint64_t services, base::Instant now) const {
  auto all = offerers(iri, now);
  std::uint64_t sum = 0;
  std::size_t count = 0;
  while (count < all.size() && sum < services) sum += least_of(all[count++].magnitude);
  all.resize(count);
  return all;
}

}  // namespace geminga::summary
