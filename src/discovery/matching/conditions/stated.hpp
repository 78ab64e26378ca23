// The value of a publication or subscription under a key, as conditions and wishes name it.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_STATED_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_STATED_HPP

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "discovery/registry/entry.hpp"

namespace geminga::matching {

/// Borrows an entry, and is implicitly made from it.
class Stated {
 public:
  Stated(const registry::PublicationEntry& entry) : entry_(&entry) {}   // NOLINT(google-explicit-constructor)
  Stated(const registry::SubscriptionEntry& entry) : entry_(&entry) {}  // NOLINT(google-explicit-constructor)

  /// The attribute that `attr.NAME` names, otherwise a field (WHERE.md lists them), otherwise an attribute; nothing
  /// where there is none. A field that is no text is written into `room`, and the value borrows from `room`. Every
  /// other value borrows from the entry.
  [[nodiscard]] std::optional<std::string_view> under(std::string_view key, std::string& room) const;

  /// The key of a field or an attribute of this entry that is most similar to `key`, of several the first by its name;
  /// empty where none is. Borrows from the entry. O(fields and attributes).
  [[nodiscard]] std::string_view similar_key(std::string_view key) const;

 private:
  std::variant<const registry::PublicationEntry*, const registry::SubscriptionEntry*> entry_;
};

}  // namespace geminga::matching

#endif
