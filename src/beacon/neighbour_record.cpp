// One participant: how announcements become changes.
#include "beacon/neighbour_record.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "beacon/address.hpp"
#include "beacon/limits.hpp"

namespace geminga::beacon {
namespace {

using base::Duration;
using base::Instant;

/// Earlier lives that are remembered, so that their late datagrams are told from a further restart.
constexpr std::size_t max_retired = 4;
/// What was heard again without a change is told again at most once in this share of the interval (and this time), so
/// that copies on several interfaces and the quick copies of a change cost the caller nothing.
constexpr int refreshes_per_interval = 16;
constexpr Duration min_refresh_time = std::chrono::milliseconds(20);

/// The addresses of a sender as they are used here: link-local ones of IPv6 need our interface.
std::vector<std::string> usable(const Announcement& announcement, const Arrival& arrival) {
  std::vector<std::string> addresses;
  const auto add = [&](std::string_view text) {
    auto address = parse_address(text);
    if (!address) return;
    const bool needs_zone = address->is_ipv6() && address->scope() == AddressScope::link_local;
    address->zone = needs_zone ? std::string(arrival.interface_name) : std::string();
    addresses.push_back(address->text());
  };
  for (const auto& address : announcement.addresses) add(address);
  if (addresses.empty()) add(arrival.source);
  return addresses;
}

}  // namespace

NeighbourRecord::NeighbourRecord(const Announcement& first, ServiceRoom& room)
    : id_(first.participant), boot_(first.boot), room_(room) {}

NeighbourRecord::~NeighbourRecord() { room_.taken -= entries_.size(); }

bool NeighbourRecord::is_retired(BootNonce boot) const { return std::ranges::find(retired_, boot) != retired_.end(); }

void NeighbourRecord::restart(BootNonce boot) {
  if (retired_.size() == max_retired) retired_.erase(retired_.begin());
  retired_.push_back(boot_);
  boot_ = boot;
  revision_ = 0;
  is_complete_ = false;
  ways_.clear();
}

Duration NeighbourRecord::refresh_time() const {
  return std::max(interval_ / refreshes_per_interval, min_refresh_time);
}

Instant NeighbourRecord::way_deadline(const Way& way) const {
  return deadline_of(way.path.heard, interval_, way.losses.loss());
}

double NeighbourRecord::loss() const {
  double best = ways_.empty() ? 0 : 1;
  for (const auto& way : ways_) best = std::min(best, way.losses.loss());
  return best;
}

NeighbourRecord::Way* NeighbourRecord::find_way(const Announcement& announcement, const Arrival& arrival) {
  const auto position =
      std::ranges::lower_bound(ways_, std::tuple(arrival.interface, announcement.link), {},
                               [](const Way& way) { return std::tuple(way.path.interface, way.path.link); });
  if (position != ways_.end() && position->path.interface == arrival.interface &&
      position->path.link == announcement.link) {
    return &*position;
  }
  if (ways_.size() == max_paths) return nullptr;
  Way way;
  way.path.interface = arrival.interface;
  way.path.link = announcement.link;
  return &*ways_.insert(position, std::move(way));
}

void NeighbourRecord::hear_on(Way& way, const Announcement& announcement, const Arrival& arrival) {
  way.losses.count(announcement.sequence);
  way.path.heard = arrival.now;
  way.path.loss = way.losses.loss();
  if (announcement.revision < way.revision) return;
  way.revision = announcement.revision;
  way.path.interface_name = arrival.interface_name;
  way.path.addresses = usable(announcement, arrival);
}

void NeighbourRecord::update_header(const Announcement& announcement) {
  interval_ = announcement.interval;
  ontology_digest_ = announcement.ontology_digest;
  auto name = announcement.name.empty() ? to_string(id_) : announcement.name;
  if (name == name_) return;
  name_ = std::move(name);
  for (auto& [number, entry] : entries_) entry.is_changed = true;
}

void NeighbourRecord::hear(const Announcement& announcement, const Arrival& arrival, std::vector<Change>& changes) {
  heard_ = arrival.now;
  const bool is_current = announcement.revision >= revision_;
  if (is_current) update_header(announcement);
  deadline_ = std::max(deadline_, deadline_of(heard_, interval_, loss()));
  auto* way = find_way(announcement, arrival);
  if (way != nullptr) {
    hear_on(*way, announcement, arrival);
    choose_address();
  }
  // An overtaken datagram proves that its sender lives, but what it says is out of date.
  if (!is_current) return;
  if (announcement.revision > revision_) {
    revision_ = announcement.revision;
    is_complete_ = false;
  }
  if (!is_complete_ && way != nullptr && way->assembly.add(announcement)) {
    is_complete_ = true;
    remove_absent(way->assembly.services(), changes);
    for (auto& each : ways_) each.assembly.clear();
  }
  apply_part(announcement, changes);
  tell(arrival.now, changes);
}

void NeighbourRecord::choose_address() {
  // (rank, not the one in use, interface, link, place in its list): the smallest is chosen.
  using Order = std::tuple<int, bool, env::InterfaceIndex, std::uint32_t, std::size_t>;
  const std::string* chosen = nullptr;
  const Way* chosen_way = nullptr;
  Order best{};
  for (const auto& way : ways_) {
    for (std::size_t i = 0; i < way.path.addresses.size(); ++i) {
      const auto& text = way.path.addresses[i];
      const auto address = parse_address(text);
      if (!address) continue;
      const bool is_other = text != address_ || way.path.interface_name != zone_;
      const Order order{address_rank(*address), is_other, way.path.interface, way.path.link, i};
      if (chosen != nullptr && best < order) continue;
      best = order;
      chosen = &text;
      chosen_way = &way;
    }
  }
  if (chosen == nullptr || (*chosen == address_ && chosen_way->path.interface_name == zone_)) return;
  address_ = *chosen;
  zone_ = chosen_way->path.interface_name;
  for (auto& [number, entry] : entries_) {
    if (depends_on_way(entry)) entry.is_changed = true;
  }
}

void NeighbourRecord::remove_absent(const std::vector<ServiceNumber>& present, std::vector<Change>& changes) {
  std::erase_if(entries_, [&](const auto& item) {
    const auto& [number, entry] = item;
    if (std::ranges::binary_search(present, number)) return false;
    if (std::holds_alternative<Publication>(entry.service)) {
      changes.emplace_back(RemovePublication{key(number), Departure::withdrawn});
    } else {
      changes.emplace_back(RemoveSubscription{key(number), Departure::withdrawn});
    }
    --room_.taken;
    return true;
  });
}

template <typename Service>
void NeighbourRecord::apply(ServiceNumber number, const Service& service, const std::string& peer_name,
                            std::vector<Change>& changes) {
  auto position = entries_.lower_bound(number);
  if (position == entries_.end() || position->first != number) {
    if (entries_.size() == max_services_per_participant || room_.taken == max_remote_services) {
      ++room_.refused;
      return;
    }
    ++room_.taken;
    entries_.emplace_hint(position, number, Entry{service, peer_name, {}, {}});
    return;
  }
  auto& entry = position->second;
  entry.is_present = true;
  if (!std::holds_alternative<Service>(entry.service)) {
    // The number was given back and used for the other kind between two announcements that we heard.
    if (std::holds_alternative<Publication>(entry.service)) {
      changes.emplace_back(RemovePublication{key(number), Departure::withdrawn});
    } else {
      changes.emplace_back(RemoveSubscription{key(number), Departure::withdrawn});
    }
  } else if (std::get<Service>(entry.service) == service && entry.peer_name == peer_name) {
    return;
  }
  entry.service = service;
  entry.peer_name = peer_name;
  entry.is_changed = true;
}

void NeighbourRecord::apply_part(const Announcement& announcement, std::vector<Change>& changes) {
  // In a complete revision everything is present in every datagram, as the revision number proves.
  for (auto& [number, entry] : entries_) entry.is_present = is_complete_;
  for (const auto& peer : announcement.peers) {
    const auto name = peer.name.empty() ? std::to_string(std::to_underlying(peer.id)) : peer.name;
    for (const auto& entry : peer.publications) apply({peer.id, entry.number}, entry.publication, name, changes);
    for (const auto& entry : peer.subscriptions) apply({peer.id, entry.number}, entry.subscription, name, changes);
  }
}

void NeighbourRecord::tell(Instant now, std::vector<Change>& changes) {
  for (auto& [number, entry] : entries_) {
    if (entry.is_present && (entry.is_changed || now - entry.heard >= refresh_time())) {
      entry.heard = now;
      entry.deadline = deadline_of(now, interval_, loss());
      entry.is_changed = true;
    }
    if (!entry.is_changed) continue;
    put(number, entry, changes);
    entry.is_changed = false;
  }
}

void NeighbourRecord::put(ServiceNumber number, const Entry& entry, std::vector<Change>& changes) const {
  if (const auto* publication = std::get_if<Publication>(&entry.service)) {
    auto& put = std::get<PutPublication>(changes.emplace_back(
        PutPublication{key(number), *publication, entry.peer_name, name_, entry.heard, entry.deadline}));
    put.publication.address = effective_address(publication->address);
  } else {
    const auto& subscription = std::get<Subscription>(entry.service);
    auto& put = std::get<PutSubscription>(changes.emplace_back(
        PutSubscription{key(number), subscription, entry.peer_name, name_, entry.heard, entry.deadline}));
    put.subscription.address = effective_address(subscription.address);
  }
}

std::string NeighbourRecord::effective_address(const std::string& announced) const {
  if (announced.empty()) return address_;
  auto address = parse_address(announced);
  if (!address || !address->is_ipv6() || address->scope() != AddressScope::link_local) return announced;
  address->zone = zone_;
  return address->text();
}

bool NeighbourRecord::depends_on_way(const Entry& entry) const {
  const auto& announced =
      std::visit([](const auto& service) -> const std::string& { return service.address; }, entry.service);
  if (announced.empty()) return true;
  const auto address = parse_address(announced);
  return address && address->is_ipv6() && address->scope() == AddressScope::link_local;
}

void NeighbourRecord::expire(Instant now, std::vector<Change>& changes) {
  const auto lost = std::erase_if(ways_, [&](const Way& way) { return way_deadline(way) <= now; });
  if (lost > 0) choose_address();
  if (!is_complete_) {
    std::vector<ServiceNumber> alive;
    for (const auto& [number, entry] : entries_) {
      if (entry.deadline > now) alive.push_back(number);
    }
    const auto first = changes.size();
    remove_absent(alive, changes);
    for (auto i = first; i < changes.size(); ++i) {
      if (auto* publication = std::get_if<RemovePublication>(&changes[i])) publication->reason = Departure::expired;
      if (auto* subscription = std::get_if<RemoveSubscription>(&changes[i])) subscription->reason = Departure::expired;
    }
  }
  for (auto& [number, entry] : entries_) entry.is_present = false;
  tell(now, changes);
}

void NeighbourRecord::forget_interface(env::InterfaceIndex interface, std::vector<Change>& changes) {
  if (std::erase_if(ways_, [&](const Way& way) { return way.path.interface == interface; }) == 0) return;
  choose_address();
  for (auto& [number, entry] : entries_) entry.is_present = false;
  tell(heard_, changes);
}

Instant NeighbourRecord::next_deadline() const {
  auto next = deadline_;
  for (const auto& way : ways_) next = std::min(next, way_deadline(way));
  if (!is_complete_) {
    for (const auto& [number, entry] : entries_) next = std::min(next, entry.deadline);
  }
  return next;
}

Neighbour NeighbourRecord::snapshot() const {
  Neighbour neighbour;
  neighbour.id = id_;
  neighbour.boot = boot_;
  neighbour.name = name_;
  neighbour.ontology_digest = ontology_digest_;
  neighbour.interval = interval_;
  neighbour.heard = heard_;
  neighbour.deadline = deadline_;
  neighbour.address = address_;
  for (const auto& way : ways_) neighbour.paths.push_back(way.path);
  neighbour.loss = loss();
  neighbour.publications = static_cast<std::size_t>(std::ranges::count_if(
      entries_, [](const auto& item) { return std::holds_alternative<Publication>(item.second.service); }));
  neighbour.subscriptions = entries_.size() - neighbour.publications;
  neighbour.is_complete = is_complete_;
  return neighbour;
}

}  // namespace geminga::beacon
