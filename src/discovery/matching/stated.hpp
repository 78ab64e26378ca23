// What a publication or a subscription says under a key, as conditions and wishes name it.
#ifndef GEMINGA_DISCOVERY_MATCHING_STATED_HPP
#define GEMINGA_DISCOVERY_MATCHING_STATED_HPP

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "discovery/registry/entry.hpp"

namespace geminga::matching {

/// Borrows an entry, from which it is made silently.
class Stated {
 public:
  Stated(const registry::PublicationEntry& entry) : entry_(&entry) {}   // NOLINT(google-explicit-constructor)
  Stated(const registry::SubscriptionEntry& entry) : entry_(&entry) {}  // NOLINT(google-explicit-constructor)

  /// The attribute behind `attr.`, otherwise a field, otherwise an attribute; nothing where it says nothing. WHERE.md
  /// lists the fields. A field that is no text is written into `room`, which the value then borrows; else it borrows
  /// the entry.
  [[nodiscard]] std::optional<std::string_view> under(std::string_view key, std::string& room) const;

 private:
  std::variant<const registry::PublicationEntry*, const registry::SubscriptionEntry*> entry_;
};

}  // namespace geminga::matching

#endif
