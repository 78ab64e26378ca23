// Publications or subscriptions by every key that matching needs (paper section 3.6).
#ifndef GEMINGA_DISCOVERY_REGISTRY_TABLE_HPP
#define GEMINGA_DISCOVERY_REGISTRY_TABLE_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/time.hpp"
#include "discovery/registry/entry.hpp"
#include "discovery/registry/stored.hpp"

namespace geminga::registry {

/// The dense number of a class in the caller's ontology. The registry knows nothing else about classes.
using ClassIndex = std::uint32_t;

/// Where an entry is filed in the semantic index. A publication is filed under its own class and below every subsumer
/// of it, so that a semantic request is one look-up. A subscription is filed under its own class, so that a new
/// publication finds it by walking its concept's subsumers; below the subsumers too when it accepts broader concepts.
struct Filing {
  std::optional<ClassIndex> own;      ///< nothing: the concept is unknown or the identity is not semantic
  std::span<const ClassIndex> below;  ///< each less than the table's class count, none twice
  /// More classes that it is filed under, none of them `own`, none twice: of a subscription for an expression those
  /// right below it.
  std::span<const ClassIndex> further_own{};
  /// Whose classes these are.
  Generation generation = Generation::even;
};

/// Entries of one kind, unique by ServiceKey. Resource: neither copied nor moved. Not thread-safe. Spans and vectors of
/// entries that are given out are valid until the next change of the table.
template <typename Entry>
class Table {
 public:
  using StoredEntry = Stored<Entry>;

  Table();
  ~Table();
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  /// Adds an entry whose key is not there yet. O(log n + filings).
  const StoredEntry& insert(Entry entry, const Filing& filing);
  /// Puts another entry with the same key into the place of one; its slot and address stay, and what it was filed by
  /// of either generation is forgotten. O(log n + filings).
  void replace(const StoredEntry& stored, Entry entry, const Filing& filing);
  /// Says that an entry was heard of again, as it is. O(1).
  void refresh(const StoredEntry& stored, base::Instant updated);
  /// Removes an entry. O(log n + filings), however many entries share its buckets.
  void erase(const StoredEntry& stored);

  /// Makes the semantic index of a generation, in which nothing must be filed, one for classes [0, count).
  void set_class_count(std::size_t count, Generation generation = Generation::even);
  /// Files an entry anew in the semantic index of the filing's generation.
  void refile(const StoredEntry& stored, const Filing& filing);
  /// Takes an entry out of the semantic index of a generation. O(filings).
  void unfile(const StoredEntry& stored, Generation generation);

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] const StoredEntry* find(const ServiceKey& key) const;
  /// Entries with exactly this identity: candidates by `id`, which must be id32(identity), then the full identity.
  /// O(1).
  [[nodiscard]] std::span<const Filed<Entry>> with_identity(const Identity& identity, Id32 id) const;
  /// Entries whose identity has this 32-bit form, those of one full identity together: more than one such group where
  /// a number is that of a concept, or two names have the same. O(groups).
  [[nodiscard]] std::vector<std::span<const Filed<Entry>>> with_number(Id32 id) const;
  /// Entries with this concept and any representation or none. O(1). For concepts that the ontology does not know.
  [[nodiscard]] std::span<const Filed<Entry>> with_concept(std::string_view concept_iri) const;
  /// Entries filed under exactly this class. O(1).
  [[nodiscard]] std::span<const Filed<Entry>> own(ClassIndex number, Generation generation = Generation::even) const;
  /// Entries filed below this class, which for publications includes its own. O(1).
  [[nodiscard]] std::span<const Filed<Entry>> below(ClassIndex number, Generation generation = Generation::even) const;

  /// In ascending order of key.
  [[nodiscard]] std::vector<const StoredEntry*> of_participant(ParticipantId participant) const;
  [[nodiscard]] std::vector<const StoredEntry*> of_peer(ParticipantId participant, PeerId peer) const;
  void for_each(const std::function<void(const StoredEntry&)>& visit) const;
  /// Those behind `after`, or all, in ascending order of key, until `visit` gives false. Whether all were visited.
  /// O(log n + visited), so that a walk can be interrupted and go on after changes.
  bool visit_after(const std::optional<ServiceKey>& after, const std::function<bool(const StoredEntry&)>& visit) const;

 private:
  struct Indexes;
  std::unique_ptr<Indexes> indexes_;
};

extern template class Table<PublicationEntry>;
extern template class Table<SubscriptionEntry>;

using Publications = Table<PublicationEntry>;
using Subscriptions = Table<SubscriptionEntry>;

}  // namespace geminga::registry

#endif
