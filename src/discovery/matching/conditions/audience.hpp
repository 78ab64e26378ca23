// The audience of a publication: its `scope` and its condition `for`.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_AUDIENCE_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_AUDIENCE_HPP

#include <optional>

#include "discovery/matching/conditions/scope.hpp"
#include "discovery/matching/conditions/where.hpp"
#include "discovery/registry/entry.hpp"

namespace geminga::matching {

/// The parsed scope and condition of a publication. Without scope and condition everybody is admitted.
struct Audience {
  std::optional<Scope> scope = Scope();      ///< nothing: it cannot be read, and admits nobody
  std::optional<Where> condition = Where();  ///< nothing: it cannot be read, and admits nobody

  [[nodiscard]] static const Audience& everybody() {
    static const Audience all;
    return all;
  }
  [[nodiscard]] static bool is_stated(const Publication& publication) {
    return !publication.scope.empty() || !publication.for_whom.empty();
  }
  [[nodiscard]] static Audience parse(const Publication& publication) {
    Audience audience;
    if (!publication.scope.empty()) {
      auto scope = Scope::parse(publication.scope);
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
