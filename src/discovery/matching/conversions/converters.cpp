#include "discovery/matching/conversions/converters.hpp"

#include <algorithm>
#include <utility>

#include "base/hash.hpp"
#include "discovery/matching/conversions/converter.hpp"

namespace geminga::matching {
namespace {

using vocabulary::ClassNumber;

/// Converters come behind all declared conversions.
constexpr std::uint64_t first_arrival = std::uint64_t{1} << 32;

/// Whether chains, and the events about them, stay the same.
bool is_same(const Converter& one, const registry::PublicationEntry& entry, const vocabulary::Step& step) {
  const Publication& was = one.entry.publication;
  const Publication& is = entry.publication;
  return one.step.from == step.from && one.step.to == step.to && one.step.cost == step.cost &&
         was.protocol == is.protocol && was.address == is.address && was.port == is.port && was.scope == is.scope &&
         was.for_whom == is.for_whom && one.entry.peer_name == entry.peer_name &&
         one.entry.participant_name == entry.participant_name && one.entry.is_local == entry.is_local &&
         one.entry.is_reachable == entry.is_reachable;
}

}  // namespace

void Converters::put(const registry::PublicationEntry& entry, const Audience& audience, std::uint64_t arrival) {
  const auto step = step_of(entry.publication.attributes, vocabulary_);
  const auto known = known_.find(entry.key);
  if (known != known_.end() && step && is_same(known->second.converter, entry, *step)) return;
  if (!step) {
    erase(entry.key);
    return;
  }
  const bool is_new = known == known_.end();
  Known& one = is_new ? known_[entry.key] : known->second;
  const bool was_active = one.place.has_value();
  if (was_active) deactivate(one);
  if (!is_new && !was_active) await_no_more(one);
  one.converter = {.entry = entry, .audience = audience, .step = *step};
  one.arrival = arrival;
  if (was_active || has_room_for(one)) {
    activate(one);
  } else if (!displace(one)) {
    await(one);
  }
}

void Converters::erase(std::span<const ServiceKey> keys) {
  std::size_t freed = 0;
  for (const bool is_active : {false, true}) {  // those that wait first: else they would be given the places
    for (const ServiceKey& key : keys) {
      const auto known = known_.find(key);
      if (known == known_.end() || known->second.place.has_value() != is_active) continue;
      if (is_active) {
        deactivate(known->second);
        ++freed;
      } else {
        await_no_more(known->second);
      }
      known_.erase(known);
    }
  }
  while (freed-- > 0) promote();
}

bool Converters::may_have_another(ParticipantId participant) const {
  const auto of_participant = active_of_.find(participant);
  return of_participant == active_of_.end() || of_participant->second.size() < max_converters_of_participant;
}

bool Converters::has_room_for(const Known& known) const {
  if (active_.size() >= max_converters || !may_have_another(known.converter.entry.key.participant)) return false;
  return known.converter.entry.is_local || remote_ < max_remote_converters;
}

void Converters::await(const Known& known) {
  const registry::PublicationEntry& entry = known.converter.entry;
  waiting_[entry.key.participant].keys.insert(entry.key);
  put_in_line(entry);
}

void Converters::await_no_more(const Known& known) {
  const registry::PublicationEntry& entry = known.converter.entry;
  waiting_[entry.key.participant].keys.erase(entry.key);
  put_in_line(entry);
}

void Converters::put_in_line(const registry::PublicationEntry& any_of_host) {
  const ParticipantId participant = any_of_host.key.participant;
  const auto waiting = waiting_.find(participant);
  if (waiting == waiting_.end()) return;
  Queue& queue = waiting->second;
  if (queue.next) next(any_of_host.is_local).erase({*std::exchange(queue.next, {}), participant});
  if (queue.keys.empty()) {
    waiting_.erase(waiting);
  } else if (may_have_another(participant)) {
    queue.next = known_.at(*queue.keys.begin()).arrival;
    next(any_of_host.is_local).emplace(*queue.next, participant);
  }
}

void Converters::activate(Known& known) {
  if (!graph_) {
    graph_ = vocabulary_.conversions();
    declared_ = static_cast<std::uint32_t>(graph_->size());
  }
  std::uint32_t free = 0;
  while (active_.contains(free)) ++free;
  known.place = free;
  active_.emplace(free, &known);
  active_of_[known.converter.entry.key.participant].insert(known.converter.entry.key);
  put_in_line(known.converter.entry);
  if (!known.converter.entry.is_local) ++remote_;
  change(free);
  graph_->put(in_graph(free), known.converter.step, first_arrival + known.arrival);
  concern(known);
}

void Converters::deactivate(Known& known) {
  const std::uint32_t place = *known.place;
  change(place);
  concern(known);
  graph_->erase(in_graph(place));
  outdated_.insert(place);
  if (!known.converter.entry.is_local) --remote_;
  const auto of_participant = active_of_.find(known.converter.entry.key.participant);
  of_participant->second.erase(known.converter.entry.key);
  if (of_participant->second.empty()) active_of_.erase(of_participant);
  put_in_line(known.converter.entry);
  active_.erase(place);
  known.place.reset();
}

void Converters::promote() {
  const Next::value_type* first = nullptr;
  const auto look_at = [&](const Next& line) {
    if (line.empty()) return;
    ++work_;
    if (first == nullptr || line.begin()->first < first->first) first = &*line.begin();
  };
  if (active_.size() < max_converters) look_at(next_local_);
  if (active_.size() < max_converters && remote_ < max_remote_converters) look_at(next_remote_);
  if (first == nullptr) return;
  Known& known = known_.at(*waiting_.at(first->second).keys.begin());
  await_no_more(known);
  activate(known);
}

bool Converters::displace(Known& newcomer) {
  const ServiceKey& key = newcomer.converter.entry.key;
  if (may_have_another(key.participant)) return false;
  const ServiceKey greatest = *active_of_.at(key.participant).rbegin();
  if (greatest < key) return false;
  Known& other = known_.at(greatest);
  deactivate(other);
  activate(newcomer);
  await(other);
  return true;
}

void Converters::change(std::uint32_t place) { changed_.at(place) = ++version_; }

void Converters::concern(const Known& known) {
  const auto led_to = graph_->behind(in_graph(*known.place));
  work_ += graph_->size();
  if (watched_.empty()) return;
  for (const auto& [number, cost] : led_to) {
    for (const ClassNumber above : vocabulary_.subsumers(number)) {
      ++work_;
      const auto group = watched_.find(above);
      if (group == watched_.end()) continue;
      group->second.concerned = version_;
      group->second.least = std::min(group->second.least, cost);
      stale_groups_.insert(above);
    }
  }
}

void Converters::watch(const std::shared_ptr<const Consumer>& consumer, ClassNumber requested) {
  const ServiceKey& key = consumer->entry.key;
  unwatch(key);
  requested_.emplace(key, requested);
  watched_[requested].consumers.emplace(key, consumer);
  refresh(key);
}

void Converters::unwatch(const ServiceKey& subscription) {
  const auto requested = requested_.find(subscription);
  if (requested == requested_.end()) return;
  const auto group = watched_.find(requested->second);
  group->second.consumers.erase(subscription);
  if (group->second.consumers.empty()) {
    stale_groups_.erase(requested->second);
    watched_.erase(group);
  }
  requested_.erase(requested);
}

void Converters::bring_up(const Consumer& consumer) const {
  if (consumer.version == version_) return;
  work_ += changed_.size() / 64;
  for (std::uint32_t place = 0; place < changed_.size(); ++place) {
    if (changed_[place] <= consumer.version) continue;
    ++work_;
    const bool did = consumer.partners.contains(place);
    const auto active = active_.find(place);
    const bool does = active != active_.end() && consumer.takes_part(active->second->converter);
    consumer.has_changed = consumer.has_changed || did || does;
    does ? consumer.partners.insert(place) : consumer.partners.erase(place);
  }
  consumer.version = version_;
}

bool Converters::is_stale(const Group& group, const Consumer& consumer) const {
  if (consumer.reviewed >= group.concerned || consumer.entry.subscription.convert < group.least) return false;
  bring_up(consumer);
  return consumer.has_changed;
}

bool Converters::is_stale(const ServiceKey& subscription) const {
  if (stale_groups_.empty()) return false;
  const auto requested = requested_.find(subscription);
  if (requested == requested_.end() || !stale_groups_.contains(requested->second)) return false;
  const Group& group = watched_.at(requested->second);
  return is_stale(group, *group.consumers.at(subscription));
}

std::optional<ServiceKey> Converters::next_stale() {
  for (std::size_t looked = 0; looked < max_looked_at && !stale_groups_.empty();) {
    Group& group = watched_.at(*stale_groups_.begin());
    if (!group.at) group.walked = group.concerned;
    auto next = group.at ? group.consumers.upper_bound(*group.at) : group.consumers.begin();
    for (; next != group.consumers.end() && looked < max_looked_at; ++next, ++looked) {
      ++work_;
      if (is_stale(group, *next->second)) return next->first;
      group.at = next->first;
    }
    if (next != group.consumers.end()) break;
    group.at.reset();
    if (group.walked != group.concerned) continue;  // those that were passed may be concerned again
    group.least = std::numeric_limits<std::uint32_t>::max();
    stale_groups_.erase(stale_groups_.begin());
  }
  return std::nullopt;
}

void Converters::refresh(const ServiceKey& subscription) {
  const auto requested = requested_.find(subscription);
  if (requested == requested_.end()) return;
  const Consumer& consumer = *watched_.at(requested->second).consumers.at(subscription);
  bring_up(consumer);
  consumer.reviewed = version_;
  consumer.has_changed = false;
}

void Converters::forget_outdated() const {
  if (outdated_.is_empty()) return;
  std::erase_if(remembered_, [this](const auto& one) { return std::get<Places>(one.first).meets(outdated_); });
  work_ += remembered_.size() / 16;
  outdated_ = {};
}

std::string Converters::via_of(const std::vector<std::uint32_t>& way) const {
  std::string via;
  bool has_service = false;
  for (const std::uint32_t place : way) {
    const bool is_service = place >= declared_;
    has_service |= is_service;
    via += via.empty() ? "" : ",";
    via += is_service ? place_of(active_.at(place - declared_)->converter.entry) : "-";
  }
  return has_service ? via : "";
}

Converters::Chain Converters::chain(const Consumer& consumer, ClassNumber offered, ClassNumber requested) const {
  if (active_.empty()) return vocabulary_.conversion(offered, requested);
  bring_up(consumer);
  const Places& partners = consumer.partners;
  if (partners.is_empty()) return vocabulary_.conversion(offered, requested);
  forget_outdated();
  const std::tuple question(offered, requested, partners);
  if (const auto known = remembered_.find(question); known != remembered_.end()) return known->second;
  work_ += graph_->size();
  const auto way = graph_->cheapest(offered, requested, [&](std::uint32_t place) {
    return place < declared_ || partners.contains(place - declared_);
  });
  Chain found;
  if (!way.empty()) {
    vocabulary::Chain chain = graph_->chain_of(way, offered, requested);
    chain.via = via_of(way);
    // Classes alone do not tell such a chain from others: its mark also depends on cost, distance and converters.
    if (!chain.via.empty()) {
      chain.mark = base::hash32(std::to_string(chain.mark) + " " + std::to_string(chain.cost) + " " +
                                std::to_string(chain.distance) + " " + chain.via);
    }
    found = std::make_shared<const vocabulary::Chain>(std::move(chain));
  }
  if (remembered_.size() >= max_remembered) remembered_.clear();
  remembered_.emplace(question, found);
  return found;
}

}  // namespace geminga::matching
