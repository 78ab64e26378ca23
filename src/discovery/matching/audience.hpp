// Whom a publication is for: its `scope` and its condition `for`.
#ifndef GEMINGA_DISCOVERY_MATCHING_AUDIENCE_HPP
#define GEMINGA_DISCOVERY_MATCHING_AUDIENCE_HPP

#include <optional>

#include "discovery/matching/scope.hpp"
#include "discovery/matching/where.hpp"
#include "discovery/registry/entry.hpp"

namespace geminga::matching {

/// What is computed once a publication. Without scope or condition everybody is admitted.
struct Audience {
  std::optional<Scope> scope = Scope();      ///< nothing: it cannot be read, and nobody is admitted
  std::optional<Where> condition = Where();  ///< nothing: it cannot be read, and nobody is admitted

  [[nodiscard]] static const Audience& everybody() {
    static const Audience all;
    return all;
  }
  [[nodiscard]] static bool is_stated(const Publication& publication) {
    return !publication.scope.empty() || !publication.for_whom.empty();
  }
  [[nodiscard]] static Audience of(const Publication& publication) {
    Audience audience;
    if (!publication.scope.empty()) {
      auto scope = Scope::of(publication.scope);
      audience.scope = scope ? std::optional(std::move(*scope)) : std::nullopt;
    }
    if (!publication.for_whom.empty()) {
      auto condition = Where::parse_with_any_unit(publication.for_whom);
      audience.condition = condition ? std::optional(std::move(*condition)) : std::nullopt;
    }
    return audience;
  }
};

[[nodiscard]] inline Party party(const registry::PublicationEntry& entry) {
  return {entry.key, entry.participant_name, entry.peer_name};
}
[[nodiscard]] inline Party party(const registry::SubscriptionEntry& entry) {
  return {entry.key, entry.participant_name, entry.peer_name};
}

}  // namespace geminga::matching

#endif
