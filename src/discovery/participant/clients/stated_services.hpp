// The services that one peer has stated: what it offers and what it asks for.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_STATED_SERVICES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_STATED_SERVICES_HPP

#include <cstddef>
#include <cstdint>
#include <map>

#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// A publication as its peer stated it. The names are kept, so that another ontology can resolve them anew.
struct StatedPublication {
  NamedIdentity named;
  Publication service;      ///< its identity is resolved while it is in force; the address is the stated one
  bool is_in_force = true;  ///< false: the loaded ontology does not know its names, or there is none yet
  bool is_awaited = false;  ///< not in force because the ontology is not ready; its peer has not been told
};

struct StatedSubscription {
  NamedIdentity named;
  Subscription service;
  bool has_limit = false;  ///< the limit was stated; else it follows the mode
  bool is_quiet = false;   ///< it has a place of the room that its peer asked for, and is not announced
  bool is_in_force = true;
  bool is_awaited = false;

  /// Whether the request is announced: requests for participants (descriptions) are not.
  [[nodiscard]] bool is_announced() const { return !is_quiet && service.mode != ChannelMode::participant; }
};

/// The numbers of publications and subscriptions are one space: an event is about one of them only.
struct StatedServices {
  std::map<std::uint32_t, StatedPublication> publications;
  std::map<std::uint32_t, StatedSubscription> subscriptions;
  std::size_t room = 0;   ///< how many quiet subscriptions the peer may have
  std::size_t quiet = 0;  ///< and has

  [[nodiscard]] std::size_t count() const { return publications.size() + subscriptions.size(); }
  /// Those that are announced, and count for the limits that all peers share.
  [[nodiscard]] std::size_t shared_count() const { return count() - quiet; }
  [[nodiscard]] bool contains(std::uint32_t number) const {
    return publications.contains(number) || subscriptions.contains(number);
  }

  /// Calls `what` with the number and the statement of each.
  template <typename What>
  void for_each(const What& what) const {
    for (const auto& [number, stated] : publications) what(number, stated);
    for (const auto& [number, stated] : subscriptions) what(number, stated);
  }
  /// Calls `what` with the statement of this number, if there is one.
  template <typename What>
  void with(std::uint32_t number, const What& what) {
    if (const auto one = publications.find(number); one != publications.end()) what(one->second);
    if (const auto one = subscriptions.find(number); one != subscriptions.end()) what(one->second);
  }

  void erase(std::uint32_t number) {
    publications.erase(number);
    const auto one = subscriptions.find(number);
    if (one == subscriptions.end()) return;
    if (one->second.is_quiet) --quiet;
    subscriptions.erase(one);
  }
  void clear() {
    publications.clear();
    subscriptions.clear();
    quiet = 0;
  }
};

}  // namespace geminga::participant

#endif
