#include "discovery/membership/neighbour/neighbour_services.hpp"

#include <algorithm>
#include <utility>

#include "base/address.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::membership {

using base::Instant;

NeighbourServices::NeighbourServices(Owner owner, ServiceRoom& room) : owner_(std::move(owner)), room_(room) {}

NeighbourServices::~NeighbourServices() { clear(); }

void NeighbourServices::clear() {
  while (!entries_.empty()) drop(std::prev(entries_.end()));
}

void NeighbourServices::forget_told() {
  for (auto& [number, entry] : entries_) {
    entry.told = Told::nothing;
    entry.is_changed = true;
  }
  has_changes_ = true;
}

template <typename Visit>
void NeighbourServices::for_each_service(const announcement::Announcement& announcement, Visit visit) {
  for (const auto& peer : announcement.peers) {
    const bool is_self = peer.id == PeerId{};
    const auto name = peer.name.empty() && !is_self ? std::to_string(std::to_underlying(peer.id)) : peer.name;
    for (const auto& entry : peer.publications) visit(ServiceNumber{peer.id, entry.number}, entry.publication, name);
    for (const auto& entry : peer.subscriptions) visit(ServiceNumber{peer.id, entry.number}, entry.subscription, name);
  }
}

bool NeighbourServices::denies(const announcement::Announcement& announcement,
                               const std::vector<ServiceNumber>* complete) const {
  bool is_denied = false;
  for_each_service(announcement, [&](ServiceNumber number, const auto& service, const std::string& peer_name) {
    if (is_denied) return;
    const auto known = entries_.find(number);
    if (known == entries_.end() || !known->second.offer.value()) {
      is_denied = complete != nullptr && !std::ranges::binary_search(*complete, number);
      return;
    }
    if (complete == nullptr && known->second.revision != announcement.revision) return;
    is_denied = !is_of(*known->second.offer.value(), service, peer_name);
  });
  return is_denied || denies_removal(announcement, complete);
}

bool NeighbourServices::denies_removal(const announcement::Announcement& change,
                                       const std::vector<ServiceNumber>* complete) const {
  const auto is_there = [&](ServiceNumber number) {
    if (complete != nullptr) return std::ranges::binary_search(*complete, number);
    const auto known = entries_.find(number);
    return known != entries_.end() && known->second.offer.value() && known->second.revision == change.revision;
  };
  return std::ranges::any_of(change.peers, [&](const announcement::PeerState& peer) {
    return std::ranges::any_of(peer.removed, [&](std::uint32_t number) { return is_there({peer.id, number}); });
  });
}

void NeighbourServices::apply(const announcement::Announcement& announcement, const Moment& moment,
                              std::vector<Change>& changes) {
  catch_up();
  if (announcement.part == 0 && announcement.kind == announcement::Kind::state) is_short_ = false;
  for_each_service(announcement, [&](ServiceNumber number, const auto& service, const std::string& peer_name) {
    apply_one(number, service, peer_name, announcement.revision, moment, changes);
  });
}

template <typename Service>
void NeighbourServices::apply_one(ServiceNumber number, const Service& service, const std::string& peer_name,
                                  std::uint64_t revision, const Moment& moment, std::vector<Change>& changes) {
  auto position = entries_.find(number);
  if (position == entries_.end() || !position->second.offer.value()) {
    add(number, service, peer_name, revision, moment);
    return;
  }
  auto& entry = position->second;
  auto& offer = entry.offer;
  if (is_of(*offer.value(), service, peer_name)) {
    offer.affirm(moment.now);
  } else {
    if (moment.is_contested && offer.is_held(moment.now, moment.hold)) return;
    // The number may have been given back and used for the other kind between two announcements that we heard.
    const bool is_same_kind = std::holds_alternative<Service>(offer.value()->service);
    if (!is_same_kind) untell(number, entry, Departure::withdrawn, changes);
    offer.replace(shared(number, service, peer_name), moment.now, moment.hold);
    entry.is_changed = true;
  }
  entry.revision = revision;
  has_changes_ |= entry.is_changed || (!moment.is_complete && moment.now - entry.heard >= moment.refresh);
}

template <typename Service>
SharedOffer NeighbourServices::shared(ServiceNumber number, const Service& service,
                                      const std::string& peer_name) const {
  if (Offers* offers = room_.offers()) return offers->share(key(number), service, peer_name);
  return std::make_shared<const Offer>(Offer{service, peer_name});
}

template <typename Service>
void NeighbourServices::add(ServiceNumber number, const Service& service, const std::string& peer_name,
                            std::uint64_t revision, const Moment& moment) {
  if (!take_room()) {
    is_short_ = true;
    return;
  }
  // Making room may have removed what was remembered under this number.
  auto position = entries_.find(number);
  const bool is_remembered = position != entries_.end();
  if (is_remembered && position->second.offer.former(moment.now, moment.hold) != nullptr) {
    room_.forget_withdrawn();
    position->second.offer.replace(shared(number, service, peer_name), moment.now, moment.hold);
  } else {
    // A new service has no former value: undoing the addition would withdraw what may be true.
    if (is_remembered) drop(position);
    position = entries_.emplace(number, Entry{{shared(number, service, peer_name), moment.now}, 0, {}, {}}).first;
  }
  ++present_;
  position->second.revision = revision;
  position->second.is_changed = true;
  has_changes_ = true;
}

bool NeighbourServices::take_room() {
  if (present_ == announcement::max_services_per_participant) {
    room_.refuse();
    return false;
  }
  if (entries_.size() >= announcement::max_services_per_participant) forget_withdrawn();
  return room_.take(owner_.id, present_);
}

void NeighbourServices::forget_withdrawn() {
  for (auto position = entries_.begin(); position != entries_.end();) {
    position = position->second.offer.value() ? std::next(position) : drop(position);
  }
}

NeighbourServices::Entries::iterator NeighbourServices::drop(const Entries::iterator& position) {
  if (position->second.offer.value()) {
    room_.give(present_--);
  } else {
    room_.forget_withdrawn();
  }
  return entries_.erase(position);
}

void NeighbourServices::untell(ServiceNumber number, Entry& entry, Departure reason,
                               std::vector<Change>& changes) const {
  if (entry.told == Told::publication) changes.emplace_back(RemovePublication{key(number), reason});
  if (entry.told == Told::subscription) changes.emplace_back(RemoveSubscription{key(number), reason});
  entry.told = Told::nothing;
}

NeighbourServices::Entries::iterator NeighbourServices::withdraw(const Entries::iterator& position,
                                                                 const Moment& moment, Departure reason,
                                                                 std::vector<Change>& changes) {
  auto& [number, entry] = *position;
  untell(number, entry, reason, changes);
  if (!room_.remember_withdrawn()) return drop(position);
  entry.offer.replace(nullptr, moment.now, moment.hold);
  room_.give(present_--);
  return std::next(position);
}

void NeighbourServices::withdraw_absent(const std::vector<ServiceNumber>& present, const Moment& moment,
                                        std::vector<Change>& changes) {
  for (auto position = entries_.begin(); position != entries_.end();) {
    auto& [number, entry] = *position;
    if (!entry.offer.value()) {
      const bool is_old = entry.offer.former(moment.now, moment.hold) == nullptr;
      position = is_old ? drop(position) : std::next(position);
    } else if (std::ranges::binary_search(present, number)) {
      entry.offer.prune(moment.now, moment.hold);
      ++position;
    } else {
      position = withdraw(position, moment, Departure::withdrawn, changes);
    }
  }
}

void NeighbourServices::withdraw_removed(const announcement::Announcement& change, const Moment& moment,
                                         std::vector<Change>& changes) {
  for (const auto& peer : change.peers) {
    for (const auto number : peer.removed) {
      const auto position = entries_.find({peer.id, number});
      if (position == entries_.end() || !position->second.offer.value()) continue;
      withdraw(position, moment, Departure::withdrawn, changes);
    }
  }
}

Instant NeighbourServices::lapse(const Moment& moment, std::vector<Change>& changes) {
  auto next = base::never;
  for (auto position = entries_.begin(); position != entries_.end();) {
    auto& [number, entry] = *position;
    if (!entry.offer.value() || entry.offer.is_held(moment.now, moment.hold)) {
      if (entry.offer.value()) next = std::min(next, entry.offer.said() + moment.hold);
      ++position;
    } else {
      untell(number, entry, Departure::withdrawn, changes);
      position = drop(position);
    }
  }
  return next;
}

void NeighbourServices::expire(const Moment& moment, std::vector<Change>& changes) {
  catch_up();
  for (auto position = entries_.begin(); position != entries_.end();) {
    auto& [number, entry] = *position;
    if (!entry.offer.value() || entry.deadline > moment.now) {
      ++position;
    } else {
      untell(number, entry, Departure::expired, changes);
      position = drop(position);
    }
  }
}

void NeighbourServices::roll_back(Instant affirmed, const Moment& moment, std::vector<Change>& changes) {
  catch_up();
  for (auto position = entries_.begin(); position != entries_.end();) {
    auto& [number, entry] = *position;
    const bool was_there = entry.offer.value() != nullptr;
    if (entry.offer.roll_back(moment.now, moment.hold)) {
      const bool is_there = entry.offer.value() != nullptr;
      entry.is_changed = is_there;
      has_changes_ |= is_there;
      if (is_there && !was_there) {
        room_.forget_withdrawn();
        // Its room may have been given away. Then it is taken in again when it is heard again.
        if (!room_.take(owner_.id, present_)) {
          position = entries_.erase(position);
          continue;
        }
        ++present_;
        entry.deadline = std::max(entry.deadline, moment.deadline);
      } else if (is_there && entry.told == (std::holds_alternative<Publication>(entry.offer.value()->service)
                                                ? Told::subscription
                                                : Told::publication)) {
        untell(number, entry, Departure::withdrawn, changes);
      }
    }
    if (entry.offer.value() && entry.offer.said() < affirmed) entry.offer.affirm(affirmed);
    ++position;
  }
}

bool NeighbourServices::give_way(std::vector<Change>& changes) {
  if (present_ <= announcement::reserved_services) return false;
  is_short_ = true;
  forget_withdrawn();
  const auto last = std::prev(entries_.end());
  untell(last->first, last->second, Departure::expired, changes);
  drop(last);
  return true;
}

void NeighbourServices::tell(const Moment& moment, std::vector<Change>& changes) {
  const bool is_all = moment.is_heard && moment.is_complete && moment.now - refreshed_ >= moment.refresh;
  if (!is_all && !has_changes_) return;
  if (!has_changes_) {
    refreshed_ = moment.now;
    // All present services were heard at the last affirmation, which is long enough ago.
    affirmed_ = {moment.now, moment.deadline, affirmed_ ? base::Duration::zero() : moment.refresh};
    return;
  }
  catch_up();
  if (is_all) refreshed_ = moment.now;
  for (auto& [number, entry] : entries_) {
    if (!entry.offer.value()) continue;
    const bool is_heard_of = moment.is_heard && (moment.is_complete || entry.offer.said() == moment.now);
    if (is_heard_of && (entry.is_changed || moment.now - entry.heard >= moment.refresh)) {
      entry.heard = moment.now;
      entry.deadline = moment.deadline;
      entry.is_changed |= !moment.is_complete;
    }
    if (entry.is_changed) put(number, entry, changes);
  }
  has_changes_ = false;
}

void NeighbourServices::catch_up() {
  if (!affirmed_) return;
  for (auto& [number, entry] : entries_) {
    if (!entry.offer.value() || affirmed_->at - entry.heard < affirmed_->refresh) continue;
    entry.heard = affirmed_->at;
    entry.deadline = affirmed_->deadline;
  }
  affirmed_.reset();
}

void NeighbourServices::put(ServiceNumber number, Entry& entry, std::vector<Change>& changes) const {
  const auto& offer = *entry.offer.value();
  if (const auto* publication = std::get_if<Publication>(&offer.service)) {
    auto& put = std::get<PutPublication>(
        changes.emplace_back(PutPublication{key(number), *publication, offer.peer_name, owner_.name, entry.heard}));
    put.publication.address = effective_address(publication->address);
    put.is_reachable = owner_.is_reachable || put.publication.address != owner_.address;
    entry.told = Told::publication;
  } else {
    const auto& subscription = std::get<Subscription>(offer.service);
    auto& put = std::get<PutSubscription>(
        changes.emplace_back(PutSubscription{key(number), subscription, offer.peer_name, owner_.name, entry.heard}));
    put.subscription.address = effective_address(subscription.address);
    put.is_reachable = owner_.is_reachable || put.subscription.address != owner_.address;
    entry.told = Told::subscription;
  }
  entry.is_changed = false;
}

void NeighbourServices::shorten(Instant deadline) {
  catch_up();
  for (auto& [number, entry] : entries_) entry.deadline = std::min(entry.deadline, deadline);
}

void NeighbourServices::set_name(const std::string& name) {
  if (name == owner_.name) return;
  owner_.name = name;
  for (auto& [number, entry] : entries_) entry.is_changed = true;
  has_changes_ = true;
}

void NeighbourServices::set_address(const std::string& address, const std::string& zone) {
  owner_.address = address;
  owner_.zone = zone;
  for (auto& [number, entry] : entries_) {
    if (!entry.offer.value() || !depends_on_way(*entry.offer.value())) continue;
    entry.is_changed = true;
    has_changes_ = true;
  }
}

void NeighbourServices::set_reachable(bool is_reachable) {
  if (is_reachable == owner_.is_reachable) return;
  owner_.is_reachable = is_reachable;
  for (auto& [number, entry] : entries_) {
    if (!entry.offer.value()) continue;
    const auto& announced = std::visit([](const auto& service) -> const std::string& { return service.address; },
                                       entry.offer.value()->service);
    if (effective_address(announced) != owner_.address) continue;
    entry.is_changed = true;
    has_changes_ = true;
  }
}

std::string NeighbourServices::effective_address(const std::string& announced) const {
  if (announced.empty()) return owner_.address;
  auto address = base::parse_address(announced);
  if (!address || !address->is_ipv6() || address->scope() != base::AddressScope::link_local) return announced;
  address->zone = owner_.zone;
  return address->text();
}

bool NeighbourServices::depends_on_way(const Offer& offer) {
  const auto& announced =
      std::visit([](const auto& service) -> const std::string& { return service.address; }, offer.service);
  if (announced.empty()) return true;
  const auto address = base::parse_address(announced);
  return address && address->is_ipv6() && address->scope() == base::AddressScope::link_local;
}

std::size_t NeighbourServices::publications() const {
  return static_cast<std::size_t>(std::ranges::count_if(entries_, [](const auto& item) {
    const auto& offer = item.second.offer.value();
    return item.first.peer != PeerId{} && offer && std::holds_alternative<Publication>(offer->service);
  }));
}

Instant NeighbourServices::earliest_deadline() {
  catch_up();
  auto next = base::never;
  for (const auto& [number, entry] : entries_) {
    if (entry.offer.value()) next = std::min(next, entry.deadline);
  }
  return next;
}

}  // namespace geminga::membership
