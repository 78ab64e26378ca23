#include "bridge/avahi/publishing.hpp"

#include <avahi-common/alternative.h>
#include <avahi-common/error.h>
#include <avahi-common/malloc.h>

#include <utility>

#include "bridge/avahi/limits.hpp"

namespace geminga::bridge {
namespace {

constexpr AvahiPublishFlags no_flags{};
constexpr std::string_view refused_by_avahi = "services of ours that Avahi refused";

struct FreeList {
  void operator()(AvahiStringList* list) const { avahi_string_list_free(list); }
};
using StringList = std::unique_ptr<AvahiStringList, FreeList>;

StringList list_of(const OwnService& service) {
  AvahiStringList* list = nullptr;
  for (const std::string& one : service.txt) {
    list = avahi_string_list_add_arbitrary(list, reinterpret_cast<const std::uint8_t*>(one.data()), one.size());
  }
  return StringList(avahi_string_list_reverse(list));
}

}  // namespace

void Publishing::set(const std::map<std::string, OwnService>& services) {
  for (auto at = entries_.begin(); at != entries_.end();) {
    const auto next = std::next(at);
    if (!services.contains(at->first)) {
      free_group(*at->second);
      entries_.erase(at);
    }
    at = next;
  }
  for (const auto& [word, service] : services) {
    if (const auto known = entries_.find(word); known != entries_.end()) {
      Entry& entry = *known->second;
      if (entry.service == service || update(entry, service)) continue;
      entry.service = service;
      entry.pause = {};
      announce(entry);
      continue;
    }
    if (entries_.size() >= max_announced) {
      tally_.count("services of ours over the limit");
      continue;
    }
    auto entry = std::make_unique<Entry>(Entry{.owner = this, .service = service, .label = {}});
    announce(*entries_.emplace(word, std::move(entry)).first->second);
  }
}

void Publishing::begin(AvahiClient* client) {
  client_ = client;
  for (const auto& [word, entry] : entries_) {
    if (entry->group == nullptr) announce(*entry);
  }
}

void Publishing::retry() {
  if (client_ == nullptr) return;
  for (const auto& [word, entry] : entries_) {
    if (entry->pause.pass()) announce(*entry);
  }
}

void Publishing::end() {
  for (const auto& [word, entry] : entries_) {
    free_group(*entry);
    entry->pause = {};  // the next Avahi may take it at once
  }
  client_ = nullptr;
}

void Publishing::free_group(Entry& entry) {
  if (entry.group != nullptr) avahi_entry_group_free(std::exchange(entry.group, nullptr));
}

void Publishing::announce(Entry& entry) {
  free_group(entry);
  entry.label = entry.service.label;
  entry.names_tried = 1;
  if (client_ == nullptr) return;
  const auto on_state = [](AvahiEntryGroup* group, AvahiEntryGroupState state, void* user) {
    Entry& one = *static_cast<Entry*>(user);
    one.owner->on_state(one, group, state);
  };
  entry.group = avahi_entry_group_new(client_, on_state, &entry);
  if (entry.group == nullptr) return refuse(entry, refused_by_avahi);
  fill(entry, entry.group);
}

void Publishing::refuse(Entry& entry, std::string_view reason) {
  if (entry.pause.failures() == 0) tally_.count(reason);
  entry.pause.fail();
}

void Publishing::fill(Entry& entry, AvahiEntryGroup* group) {
  const OwnService& service = entry.service;
  const std::string host = service.host.empty() ? "" : service.host + ".local";
  int result = AVAHI_OK;
  if (!host.empty()) {
    AvahiAddress address{};
    if (avahi_address_parse(service.address.c_str(), AVAHI_PROTO_UNSPEC, &address) == nullptr) {
      return refuse(entry, "services of ours without an address that others can use");
    }
    result = avahi_entry_group_add_address(group, AVAHI_IF_UNSPEC, AVAHI_PROTO_UNSPEC, AVAHI_PUBLISH_NO_REVERSE,
                                           host.c_str(), &address);
  }
  if (result == AVAHI_OK) {
    const StringList txt = list_of(service);
    result = avahi_entry_group_add_service_strlst(group, AVAHI_IF_UNSPEC, AVAHI_PROTO_UNSPEC, no_flags,
                                                  entry.label.c_str(), service.type.c_str(), nullptr,
                                                  host.empty() ? nullptr : host.c_str(), service.port, txt.get());
  }
  if (result == AVAHI_OK) result = avahi_entry_group_commit(group);
  if (result == AVAHI_ERR_COLLISION) return rename(entry, group);
  if (result != AVAHI_OK) refuse(entry, refused_by_avahi);
}

void Publishing::rename(Entry& entry, AvahiEntryGroup* group) {
  if (entry.names_tried++ >= max_names_tried) return refuse(entry, "services of ours whose names others have");
  char* const other = avahi_alternative_service_name(entry.label.c_str());
  entry.label = other;
  avahi_free(other);
  avahi_entry_group_reset(group);
  fill(entry, group);
}

void Publishing::on_state(Entry& entry, AvahiEntryGroup* group, AvahiEntryGroupState state) {
  if (state == AVAHI_ENTRY_GROUP_COLLISION) rename(entry, group);
  if (state == AVAHI_ENTRY_GROUP_FAILURE) refuse(entry, refused_by_avahi);
  if (state == AVAHI_ENTRY_GROUP_ESTABLISHED) entry.pause = {};
}

/// Changes the TXT record alone, if nothing else differs: consumers see no departure.
bool Publishing::update(Entry& entry, const OwnService& service) {
  OwnService changed = service;
  changed.txt = entry.service.txt;
  changed.is_cut = entry.service.is_cut;
  if (changed != entry.service) return false;
  entry.service = service;
  if (entry.group == nullptr || !entry.pause.is_over()) return true;  // announced with it later
  const StringList txt = list_of(service);
  return avahi_entry_group_update_service_txt_strlst(entry.group, AVAHI_IF_UNSPEC, AVAHI_PROTO_UNSPEC, no_flags,
                                                     entry.label.c_str(), service.type.c_str(), nullptr,
                                                     txt.get()) == AVAHI_OK;
}

}  // namespace geminga::bridge
