#include "bridge/team/foreign_services.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "bridge/team/limits.hpp"

namespace geminga::bridge {
namespace {

bool is_publication(const Foreign& foreign) { return std::holds_alternative<NamedPublication>(foreign.stated); }

client::Session::Stated by_concept(const Foreign& foreign) {
  client::Session::Stated stated = foreign.stated;
  std::visit([&](auto& one) { one.identity = ConceptNames{foreign.concept_name, {}}; }, stated);
  return stated;
}

/// The change that makes the one publication the other; nothing where none does, since a change takes no attribute
/// away.
std::optional<PublicationChange> change_between(const Foreign& before, const Foreign& after) {
  const auto* from = std::get_if<NamedPublication>(&before.stated);
  const auto* to = std::get_if<NamedPublication>(&after.stated);
  if (from == nullptr || to == nullptr || before.concept_name != after.concept_name) return std::nullopt;
  if (from->identity != to->identity || from->mode != to->mode || from->protocol != to->protocol) return std::nullopt;
  if (from->priority != to->priority || from->scope != to->scope || from->for_whom != to->for_whom) return std::nullopt;
  PublicationChange change;
  for (const auto& [key, value] : from->attributes) {
    if (!to->attributes.contains(key)) return std::nullopt;
  }
  change.attributes = to->attributes;
  change.address = to->address;
  change.port = to->port;
  return change;
}

}  // namespace

bool ForeignServices::has_room(const Foreign& foreign) const {
  return (is_publication(foreign) ? publications_ : stated_.size() - publications_) < max_stated;
}

void ForeignServices::state(const std::string& key, Foreign foreign, bool as_concept) {
  const ChannelNumber number = session_.next_number();
  client::Session::Stated stated = as_concept ? by_concept(foreign) : client::Session::Stated(foreign.stated);
  if (client::Session::fault(stated)) return tally_.count("services that cannot be stated");
  if (is_publication(foreign)) ++publications_;
  stated_.insert_or_assign(key, Stated{std::move(foreign), number, as_concept});
  keys_.insert_or_assign(number, key);
  session_.create(number, std::move(stated));
}

void ForeignServices::forget(std::map<std::string, Stated>::iterator at) {
  if (is_publication(at->second.foreign)) --publications_;
  keys_.erase(at->second.number);
  session_.remove(at->second.number);
  stated_.erase(at);
}

void ForeignServices::put(const std::string& key, Foreign foreign) {
  if (const auto found = stated_.find(key); found != stated_.end()) {
    Stated& known = found->second;
    if (known.foreign == foreign) return;
    const auto change = change_between(known.foreign, foreign);
    if (change && session_.modify(known.number, *change)) {
      known.foreign = std::move(foreign);
      return;
    }
    forget(found);
  }
  const bool has_name = !foreign.concept_name.empty();
  if (has_room(foreign)) {
    waiting_.erase(key);
    return state(key, std::move(foreign), has_name);
  }
  if (waiting_.contains(key) || waiting_.size() < max_waiting) {
    if (!waiting_.contains(key)) tally_.count("services over the limit of a peer, which wait");
    waiting_.insert_or_assign(key, std::move(foreign));
  } else {
    tally_.count("services over the limit");
  }
}

void ForeignServices::state_waiting() {
  for (auto at = waiting_.begin(); at != waiting_.end();) {
    if (!has_room(at->second)) {
      ++at;
      continue;
    }
    const bool has_name = !at->second.concept_name.empty();
    state(at->first, std::move(at->second), has_name);
    at = waiting_.erase(at);
  }
}

void ForeignServices::drop(const std::string& key) {
  waiting_.erase(key);
  const auto found = stated_.find(key);
  if (found == stated_.end()) return;
  forget(found);
  state_waiting();
}

void ForeignServices::clear() {
  waiting_.clear();
  while (!stated_.empty()) forget(stated_.begin());
}

void ForeignServices::on_up() {
  // Names that a former daemon did not know, this one may know.
  std::vector<std::string> texts;
  for (const auto& [key, one] : stated_) {
    if (!one.is_concept && !one.foreign.concept_name.empty()) texts.push_back(key);
  }
  for (const std::string& key : texts) {
    const auto found = stated_.find(key);
    Foreign foreign = found->second.foreign;
    forget(found);
    state(key, std::move(foreign), true);
  }
}

void ForeignServices::on_other_ontology() {
  for (const auto& [key, one] : stated_) {
    if (one.is_concept || one.foreign.concept_name.empty()) continue;
    const IdentityChange identity = ConceptChange{one.foreign.concept_name, std::nullopt};
    client::Session::Change change;
    if (is_publication(one.foreign)) {
      change.emplace<PublicationChange>().identity = identity;
    } else {
      change.emplace<SubscriptionChange>().identity = identity;
    }
    // The daemon refuses a name that it does not know and changes nothing.
    [[maybe_unused]] const auto asked = session_.modify(one.number, change);
  }
}

bool ForeignServices::on_settled(const client::Session::Settled& settled) {
  const auto found = keys_.find(settled.number);
  if (found == keys_.end()) return false;
  const std::string key = found->second;
  const auto at = stated_.find(key);
  Stated& one = at->second;
  if (settled.is_change) {
    const client::Session::Request* request = session_.find(settled.number);
    const auto is_concept = [](const auto& stated) { return std::holds_alternative<ConceptNames>(stated.identity); };
    if (request != nullptr) one.is_concept = std::visit(is_concept, request->stated);
    return true;
  }
  if (!settled.error || settled.error->code == ErrorCode::not_ready) return true;
  Foreign foreign = one.foreign;
  const bool was_concept = one.is_concept;
  forget(at);
  if (was_concept) {
    state(key, std::move(foreign), false);
  } else {
    tally_.count("services that the daemon refused");
    state_waiting();
  }
  return true;
}

std::size_t ForeignServices::concepts() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(stated_, [](const auto& one) { return one.second.is_concept; }));
}

std::string_view ForeignServices::key_of(ChannelNumber number) const {
  const auto found = keys_.find(number);
  return found == keys_.end() ? std::string_view() : std::string_view(found->second);
}

}  // namespace geminga::bridge
