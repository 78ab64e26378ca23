// Scopes: the hosts and peers that a publication or a subscription is meant for (SCOPE.md).
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_SCOPE_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_SCOPE_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/error.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// How many entries a scope may have; one more is refused with 422.
inline constexpr std::size_t max_scope_entries = 16;

/// The key and the names of a provider or a consumer. Borrows the names.
struct Party {
  ServiceKey key;
  std::string_view participant_name;
  std::string_view peer_name;
};

/// A value: copies and moves.
class Scope {
 public:
  /// Admits everybody.
  Scope() = default;
  /// Reads a scope. The empty one admits everybody. The error (422) says what cannot be read.
  [[nodiscard]] static std::expected<Scope, Error> parse(std::string_view text);

  [[nodiscard]] bool is_everybody() const { return entries_.empty(); }
  /// Whether the scope of `own` admits the other: no entry excludes it, and an entry admits it or no entry admits
  /// anybody. O(length).
  [[nodiscard]] bool admits(const Party& own, const Party& other) const;

 private:
  struct Entry {
    enum class Host : std::uint8_t { own, any, named } host = Host::any;
    bool excludes = false;
    std::string participant;  ///< named: an identifier, a name or a pattern
    std::string peer;         ///< an identifier, a name or a pattern; empty: any
  };
  [[nodiscard]] static std::optional<Entry> entry(std::string_view text);
  [[nodiscard]] static bool suits(const Entry& entry, const Party& own, const Party& other);

  std::vector<Entry> entries_;
};

/// The error of a scope, to refuse it with 422.
[[nodiscard]] std::optional<Error> check_scope(std::string_view text);

}  // namespace geminga::matching

#endif
