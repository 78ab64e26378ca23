#include "discovery/participant/clients/own_description.hpp"

#include <utility>

#include "discovery/announcement/announceable.hpp"

namespace geminga::participant {

Refusal identify(StatedPublication& stated, Resolver& resolver) {
  auto identity = resolver.resolve(stated.named);
  if (!identity) return identity.error();
  stated.service.identity = std::move(*identity);
  return announcement::check(stated.service);
}

Refusal OwnDescription::change(const gcnp::Describe& change) {
  const bool is_end = change.concept_name && change.concept_name->empty();
  StatedPublication stated = stated_ && !is_end ? *stated_ : StatedPublication{};
  if (!stated_ && !change.concept_name) {
    return Error{ErrorCode::unknown_request, "this participant has no description: give concept=EXPRESSION, too"};
  }
  if (!is_end) {
    stated.service.mode = ChannelMode::participant;
    if (change.concept_name) stated.named = ConceptNames{*change.concept_name, {}};
    for (const auto& [key, value] : change.attributes) stated.service.attributes.insert_or_assign(key, value);
    if (auto refusal = resolve(stated)) return refusal;
  }
  if (gate_.count(env_.now()) != RateGate::Verdict::pass) {
    return Error{ErrorCode::too_many,
                 "too many descriptions: the limit is " + std::to_string(max_descriptions_per_second) + " in a second"};
  }
  problem_.clear();
  if (is_end) {
    stated_.reset();
    withdraw();
  } else {
    stated_ = std::move(stated);
    enter();
  }
  return std::nullopt;
}

bool OwnDescription::set(const std::string& concept_name) {
  problem_.clear();
  if (concept_name.empty()) {
    stated_.reset();
    return withdraw();
  }
  if (!stated_) stated_.emplace();
  stated_->named = ConceptNames{concept_name, {}};
  stated_->service.mode = ChannelMode::participant;
  return restate(true);
}

bool OwnDescription::enter() {
  if (!stated_ || !stated_->is_in_force || !self_.is_claimed()) return false;
  matcher_.put(registry::PublicationEntry{.key = description_key(self_.id),
                                          .publication = stated_->service,
                                          .peer_name = {},
                                          .participant_name = self_.name(),
                                          .is_local = true,
                                          .updated = env_.now()});
  return true;
}

bool OwnDescription::withdraw() {
  return matcher_.remove_publication(description_key(self_.id), matching::Reason::withdrawn);
}

bool OwnDescription::restate(bool is_always) {
  if (!stated_ || !(is_always || stated_->is_awaited)) return false;
  const Refusal refusal = resolve(*stated_);
  problem_ = refusal && !stated_->is_awaited ? refusal->text : "";
  return refusal ? withdraw() : enter();
}

Refusal OwnDescription::resolve(StatedPublication& stated) {
  const Refusal refusal = identify(stated, resolver_);
  stated.is_in_force = !refusal;
  stated.is_awaited = is_awaited(refusal);
  return refusal;
}

std::optional<announcement::PeerState> OwnDescription::announced() const {
  if (!stated_ || !stated_->is_in_force) return std::nullopt;
  announcement::PeerState self;
  self.publications.push_back({.number = description_key({}).number, .publication = stated_->service});
  return self;
}

}  // namespace geminga::participant
