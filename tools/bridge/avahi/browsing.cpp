#include "bridge/avahi/browsing.hpp"

#include <array>
#include <utility>

#include "bridge/avahi/limits.hpp"

namespace geminga::bridge {
namespace {

std::string text(const char* given) { return given == nullptr ? std::string() : std::string(given); }

/// A service as it was resolved.
FoundService found_service(const char* host, const AvahiAddress& address, std::uint16_t port,
                           const AvahiStringList* txt) {
  std::array<char, AVAHI_ADDRESS_STR_MAX> shown{};
  avahi_address_snprint(shown.data(), shown.size(), &address);
  FoundService found{
      .name = {}, .type = {}, .domain = {}, .host = text(host), .address = shown.data(), .port = port, .txt = {}};
  for (; txt != nullptr; txt = txt->next) {
    found.txt.emplace(found.txt.begin(), reinterpret_cast<const char*>(txt->text),
                      txt->size);  // Avahi's list is reversed
  }
  return found;
}

}  // namespace

Browsing::Browsing(std::set<std::string> types, Tally& tally, Told told)
    : types_(std::move(types)), tally_(tally), told_(std::move(told)) {}

void Browsing::begin(AvahiClient* client) {
  if (client_ != nullptr) return;
  client_ = client;
  for (const std::string& type : types_) browse(type);
  if (!types_.empty()) return;
  const auto on_type = [](AvahiServiceTypeBrowser*, AvahiIfIndex, AvahiProtocol, AvahiBrowserEvent event,
                          const char* type, const char*, AvahiLookupResultFlags,
                          void* user) { static_cast<Browsing*>(user)->on_type(event, type); };
  type_browser_ = avahi_service_type_browser_new(client, AVAHI_IF_UNSPEC, AVAHI_PROTO_UNSPEC, nullptr,
                                                 AvahiLookupFlags{}, on_type, this);
  if (type_browser_ == nullptr) tally_.count("questions that Avahi refused");
}

void Browsing::end() {
  while (!sightings_.empty()) forget(sightings_.begin());
  for (const auto& [type, one] : browsers_) avahi_service_browser_free(one.browser);
  browsers_.clear();
  if (type_browser_ != nullptr) avahi_service_type_browser_free(std::exchange(type_browser_, nullptr));
  client_ = nullptr;
}

void Browsing::on_type(AvahiBrowserEvent event, const char* type) {
  const std::string name = text(type);
  if (event == AVAHI_BROWSER_REMOVE) return leave(name);
  if (event != AVAHI_BROWSER_NEW || is_own_type(name)) return;
  if (!is_service_type(name)) return tally_.count("types that are none of DNS-SD");
  browse(name);
}

void Browsing::browse(const std::string& type) {
  if (const auto known = browsers_.find(type); known != browsers_.end()) {
    ++known->second.seen;
    return;
  }
  if (browsers_.size() >= max_types) return tally_.count("types over the limit");
  const auto on_service = [](AvahiServiceBrowser*, AvahiIfIndex interface, AvahiProtocol protocol,
                             AvahiBrowserEvent event, const char* name, const char* kind, const char* domain,
                             AvahiLookupResultFlags flags, void* user) {
    static_cast<Browsing*>(user)->on_service(event, {interface, protocol, text(name), text(kind), text(domain)}, flags);
  };
  AvahiServiceBrowser* browser = avahi_service_browser_new(client_, AVAHI_IF_UNSPEC, AVAHI_PROTO_UNSPEC, type.c_str(),
                                                           nullptr, AvahiLookupFlags{}, on_service, this);
  if (browser == nullptr) return tally_.count("questions that Avahi refused");
  browsers_.emplace(type, TypeBrowser{browser, 1});
}

void Browsing::leave(const std::string& type) {
  const auto known = browsers_.find(type);
  if (known == browsers_.end() || --known->second.seen > 0) return;
  avahi_service_browser_free(known->second.browser);
  browsers_.erase(known);
  for (auto at = sightings_.begin(); at != sightings_.end();) {
    const auto next = std::next(at);
    if (at->first.type == type) forget(at);
    at = next;
  }
  resolve_waiting();
}

void Browsing::on_service(AvahiBrowserEvent event, Place place, AvahiLookupResultFlags flags) {
  const auto known = sightings_.find(place);
  if (event == AVAHI_BROWSER_REMOVE) {
    if (known != sightings_.end()) forget(known);
    return resolve_waiting();
  }
  if (event != AVAHI_BROWSER_NEW || known != sightings_.end()) return;
  if ((flags & AVAHI_LOOKUP_RESULT_OUR_OWN) != 0 || is_own_type(place.type)) return;
  if (sightings_.size() >= max_resolved + max_unresolved) return tally_.count("services over the limit");
  auto sighting = std::make_unique<Sighting>(Sighting{this, place});
  Sighting& made = *sightings_.emplace(std::move(place), std::move(sighting)).first->second;
  if (resolvers_ < max_resolved) return resolve(made);
  tally_.count("services over the limit of resolvers, which wait");
}

void Browsing::resolve(Sighting& sighting) {
  const auto on_resolved = [](AvahiServiceResolver*, AvahiIfIndex, AvahiProtocol, AvahiResolverEvent event, const char*,
                              const char*, const char*, const char* host, const AvahiAddress* address,
                              std::uint16_t port, AvahiStringList* txt, AvahiLookupResultFlags, void* user) {
    Sighting& one = *static_cast<Sighting*>(user);
    if (event != AVAHI_RESOLVER_FOUND || address == nullptr) return one.owner->on_failure(one);
    one.owner->on_found(one, found_service(host, *address, port, txt));
  };
  const Place& place = sighting.place;
  sighting.resolver =
      avahi_service_resolver_new(client_, place.interface, place.protocol, place.name.c_str(), place.type.c_str(),
                                 place.domain.c_str(), sighting.family, AvahiLookupFlags{}, on_resolved, &sighting);
  if (sighting.resolver == nullptr) return tally_.count("questions that Avahi refused");
  ++resolvers_;
}

void Browsing::on_found(Sighting& sighting, FoundService found) {
  if (sighting.family == AVAHI_PROTO_UNSPEC && !is_shareable(found.address)) {
    sighting.family = AVAHI_PROTO_INET;
    free_resolver(sighting);
    return resolve(sighting);
  }
  found.name = sighting.place.name;
  found.type = sighting.place.type;
  found.domain = sighting.place.domain;
  sighting.found = std::move(found);
  tell(sighting.place);
}

void Browsing::on_failure(Sighting& sighting) {
  const bool has_other_address = sighting.family == AVAHI_PROTO_INET;
  tally_.count(has_other_address ? no_shareable_address : "services without an answer");
  // A host that has answered once may be slow; its service goes when Avahi says so.
  if (sighting.found) return;
  sighting.pause.fail();
  sighting.family = AVAHI_PROTO_UNSPEC;
  free_resolver(sighting);
  resolve_waiting();
}

void Browsing::free_resolver(Sighting& sighting) {
  if (sighting.resolver == nullptr) return;
  avahi_service_resolver_free(std::exchange(sighting.resolver, nullptr));
  --resolvers_;
}

void Browsing::retry() {
  for (const auto& [place, sighting] : sightings_) sighting->pause.pass();
  resolve_waiting();
}

void Browsing::resolve_waiting() {
  while (client_ != nullptr && resolvers_ < max_resolved && resolvers_ < sightings_.size()) {
    Sighting* next = nullptr;
    for (const auto& [place, sighting] : sightings_) {
      if (sighting->resolver == nullptr && sighting->pause.is_over() &&
          (next == nullptr || sighting->pause.failures() < next->pause.failures())) {
        next = sighting.get();
      }
    }
    if (next == nullptr) return;
    const std::size_t before = resolvers_;
    resolve(*next);
    if (resolvers_ == before) return;  // Avahi refuses
  }
}

void Browsing::forget(std::map<Place, std::unique_ptr<Sighting>>::iterator at) {
  const std::unique_ptr<Sighting> sighting = std::move(at->second);
  sightings_.erase(at);
  free_resolver(*sighting);
  if (sighting->found) tell(sighting->place);
}

/// Tells how a service stands: IPv4 is preferred to IPv6, and the lowest interface to others.
void Browsing::tell(const Place& place) {
  const std::string key = key_of(place);
  const FoundService* best = nullptr;
  std::string_view reason;
  // The places of one service differ in interface and family alone, which come first.
  for (const auto& [at, sighting] : sightings_) {
    if (!sighting->found || at.name != place.name || at.type != place.type || at.domain != place.domain) continue;
    if (const auto foreign = foreign_of(*sighting->found); !foreign) {
      reason = foreign.error();
      continue;
    }
    if (best == nullptr || (best->address.contains(':') && !sighting->found->address.contains(':'))) {
      best = &*sighting->found;
    }
  }
  if (best != nullptr) {
    services_.insert(key);
    return told_.found(key, *best);
  }
  if (!reason.empty()) tally_.count(reason);
  if (services_.erase(key) > 0) told_.gone(key);
}

}  // namespace geminga::bridge
