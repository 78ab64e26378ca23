// Tables of publications and subscriptions, with an index for every key that matching needs (paper section 3.6).
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

/// The place of an entry in the semantic index. A publication is filed under its own class and below every subsumer of
/// it, so that a semantic request is one look-up. A subscription is filed under its own class, where a new publication
/// finds it among the subsumers of its concept; where it accepts broader concepts, it is also filed below its
/// subsumers.
struct Filing {
  std::optional<ClassIndex> own;      ///< nothing: the concept is unknown or the identity is not semantic
  std::span<const ClassIndex> below;  ///< each less than the table's class count, none twice
  /// Further classes that it is filed under, none of them `own`, none twice. A subscription for an expression has those
  /// right below the expression.
  std::span<const ClassIndex> further_own{};
  /// The ontology that the classes are of.
  Generation generation = Generation::even;
};

/// Entries of one kind, unique by ServiceKey. Resource: neither copied nor moved. Not thread-safe. Spans and vectors of
/// entries that are given out are valid until the next change of the table.
///
/// The indexes stand behind a pointer, so that Boost.MultiIndex, which takes long to compile, is seen in table.cpp
/// alone.
template <typename Entry>
class Table {
 public:
  using StoredEntry = Stored<Entry>;

  Table();
  ~Table();
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  /// Keeps entries that are equal to those of other tables of the process once. Call before the first one is added.
  void share(std::shared_ptr<SharedEntries> entries);

  /// Adds an entry whose key is not there yet. O(log n + filings).
  const StoredEntry& insert(Entry entry, const Filing& filing);
  /// Puts another entry with the same key into the place of one, and gives the one that was there. Slot and address
  /// stay. The entry is filed by its names and by `filing` alone. O(log n + filings).
  std::shared_ptr<const Entry> replace(const StoredEntry& stored, Entry entry, const Filing& filing);
  /// An entry was heard again, unchanged. O(1).
  void refresh(const StoredEntry& stored, base::Instant updated);
  /// Removes an entry. O(log n + filings), however many entries share its buckets.
  void erase(const StoredEntry& stored);

  /// Makes a semantic index for the classes [0, count). Requires that nothing is filed in that generation.
  void set_class_count(std::size_t count, Generation generation = Generation::even);
  /// Files an entry anew in the semantic index of the generation of the filing.
  void refile(const StoredEntry& stored, const Filing& filing);
  /// Takes an entry out of the semantic index of a generation. O(filings).
  void unfile(const StoredEntry& stored, Generation generation);

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] const StoredEntry* find(const ServiceKey& key) const;
  /// The entry alone; null where there is none.
  [[nodiscard]] const Entry* find_entry(const ServiceKey& key) const {
    const StoredEntry* stored = find(key);
    return stored == nullptr ? nullptr : &stored->entry;
  }
  /// The entries with exactly this identity. `id` must be id32(identity). O(1).
  [[nodiscard]] std::span<const Filed<Entry>> with_identity(const Identity& identity, Id32 id) const;
  /// The entries whose identity has this 32-bit form, in one group for each full identity. There is more than one group
  /// where a number is that of a concept, or two names have the same number. O(groups).
  [[nodiscard]] std::vector<std::span<const Filed<Entry>>> with_number(Id32 id) const;
  /// The entries with this concept and any representation or none, for concepts that the ontology does not know. O(1).
  [[nodiscard]] std::span<const Filed<Entry>> with_concept(std::string_view concept_iri) const;
  /// The entries filed under exactly this class. O(1).
  [[nodiscard]] std::span<const Filed<Entry>> own(ClassIndex number, Generation generation = Generation::even) const;
  /// The entries filed below this class. Publications of the class itself are among them. O(1).
  [[nodiscard]] std::span<const Filed<Entry>> below(ClassIndex number, Generation generation = Generation::even) const;

  /// The entries of a participant or a peer, in ascending order of key.
  [[nodiscard]] std::vector<const StoredEntry*> of_participant(ParticipantId participant) const;
  [[nodiscard]] std::vector<const StoredEntry*> of_peer(ParticipantId participant, PeerId peer) const;
  /// Visits the entries behind `after`, or all, in ascending order of key, until `visit` gives false. Whether all were
  /// visited. A walk can be interrupted and go on after changes. O(log n + visited).
  bool visit_after(const std::optional<ServiceKey>& after, const std::function<bool(const StoredEntry&)>& visit) const;

 private:
  struct Indexes;
  /// An entry as it is kept.
  [[nodiscard]] std::shared_ptr<const Entry> kept(Entry entry) const;

  std::unique_ptr<Indexes> indexes_;
  std::shared_ptr<SharedEntries> shared_;  ///< null: entries are kept for this table alone
};

extern template class Table<PublicationEntry>;
extern template class Table<SubscriptionEntry>;

using Publications = Table<PublicationEntry>;
using Subscriptions = Table<SubscriptionEntry>;

}  // namespace geminga::registry

#endif
