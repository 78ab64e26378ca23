// Numbers that are the 32-bit identity of two different concepts. Such a number connects neither concept with a peer
// that states the number. Two peers that both state the number are connected all the same.
#ifndef GEMINGA_DISCOVERY_MATCHING_CLASHES_HPP
#define GEMINGA_DISCOVERY_MATCHING_CLASHES_HPP

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "discovery/registry/table.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// A message to a local peer about its publication or subscription whose identity has such a number.
struct Clash {
  ServiceKey to;
  std::string text;  ///< one line: which concepts, and what to do
};

class Clashes {
 public:
  /// The event of an entry with the number that is looked at.
  enum class Change : std::uint8_t { came, stayed, went };

  Clashes(const registry::Publications& publications, const registry::Subscriptions& subscriptions)
      : publications_(publications), subscriptions_(subscriptions) {}
  Clashes(const Clashes&) = delete;
  Clashes& operator=(const Clashes&) = delete;

  [[nodiscard]] bool contains(Id32 number) const { return numbers_.contains(number); }
  /// Whether a number and a concept do not meet because the number is that of another concept, too.
  [[nodiscard]] bool is_kept_apart(const Identity& offered, const Identity& requested) const;

  /// Finds out whether a number is that of two concepts, after an entry came or went. Gives the subscriptions that must
  /// be judged anew, in ascending order of key. All that have the number are told of it when the clash begins, and
  /// again when an entry came to have it.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> review(Id32 number, Change change);
  /// The same after an entry with the number `before` came to have `now`, which may be the same. `change`: whether the
  /// entry came to have its identity, or stayed with it.
  [[nodiscard]] std::vector<const registry::StoredSubscription*> review_change(Id32 before, Id32 now, Change change);

  /// The messages since the last call.
  [[nodiscard]] std::vector<Clash> take() { return std::exchange(messages_, {}); }

 private:
  void tell(Id32 number, std::span<const Identity* const> concepts);

  const registry::Publications& publications_;
  const registry::Subscriptions& subscriptions_;
  std::set<Id32> numbers_;
  std::vector<Clash> messages_;
};

}  // namespace geminga::matching

#endif
