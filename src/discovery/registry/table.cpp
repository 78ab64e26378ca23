#include "discovery/registry/table.hpp"

#include <algorithm>
#include <array>
#include <boost/multi_index/hashed_index.hpp>
#include <boost/multi_index/identity.hpp>
#include <boost/multi_index/mem_fun.hpp>
#include <boost/multi_index/ordered_index.hpp>
#include <boost/multi_index_container.hpp>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "base/assert.hpp"
#include "discovery/registry/fields.hpp"
#include "discovery/registry/name_index.hpp"
#include "discovery/registry/semantic_index.hpp"

namespace geminga::registry {
namespace {

namespace mi = boost::multi_index;

struct ByKey {};
struct InKeyOrder {};

/// Spreads the bits of a number over a word (the finaliser of splitmix64).
std::size_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  return static_cast<std::size_t>(bits ^ (bits >> 31));
}

std::size_t hash_of(ParticipantId participant, PeerId peer, std::uint32_t number) {
  const auto high = static_cast<std::uint64_t>(std::to_underlying(participant)) << 32;
  return mixed(mixed(high | std::to_underlying(peer)) + number);
}

struct KeyHash {
  std::size_t operator()(const ServiceKey& key) const { return hash_of(key.participant, key.peer, key.number); }
};

/// The element of the container: a stored entry and the keys that are read from it.
template <typename Entry>
struct Element : Stored<Entry> {
  using Stored<Entry>::Stored;
  [[nodiscard]] const ServiceKey& key() const { return this->entry.key; }
};

template <typename Entry>
using Container = mi::multi_index_container<
    Element<Entry>,
    mi::indexed_by<
        mi::hashed_unique<mi::tag<ByKey>, mi::const_mem_fun<Element<Entry>, const ServiceKey&, &Element<Entry>::key>,
                          KeyHash>,
        mi::ordered_unique<mi::tag<InKeyOrder>,
                           mi::const_mem_fun<Element<Entry>, const ServiceKey&, &Element<Entry>::key>>>>;

/// Compares a key with a participant, so that the entries of a participant are one range of the key order. InPeer does
/// the same for a peer.
struct InParticipant {
  bool operator()(const ServiceKey& key, ParticipantId participant) const { return key.participant < participant; }
  bool operator()(ParticipantId participant, const ServiceKey& key) const { return participant < key.participant; }
};

using PeerPrefix = std::pair<ParticipantId, PeerId>;
struct InPeer {
  static PeerPrefix prefix(const ServiceKey& key) { return {key.participant, key.peer}; }
  bool operator()(const ServiceKey& key, const PeerPrefix& peer) const { return prefix(key) < peer; }
  bool operator()(const PeerPrefix& peer, const ServiceKey& key) const { return peer < prefix(key); }
};

template <typename Range>
auto pointers(const Range& range) {
  using StoredEntry = std::remove_cvref_t<decltype(*range.first)>;
  std::vector<const StoredEntry*> entries;
  for (auto at = range.first; at != range.second; ++at) entries.push_back(&*at);
  return entries;
}

template <typename Entry, typename Elements>
std::vector<const Stored<Entry>*> plain(const Elements& elements) {
  return {elements.begin(), elements.end()};
}

}  // namespace

template <typename Entry>
struct Table<Entry>::Indexes {
  Container<Entry> container;
  NameIndex<Entry> names;
  std::array<SemanticIndex<Entry>, 2> classes;  ///< by generation
  std::vector<std::uint32_t> free_slots;
  std::uint32_t next_slot = 0;

  auto position_of(const Stored<Entry>& stored) {
    return container.iterator_to(static_cast<const Element<Entry>&>(stored));
  }

  std::uint32_t take_slot() {
    if (free_slots.empty()) return next_slot++;
    const std::uint32_t slot = free_slots.back();
    free_slots.pop_back();
    return slot;
  }

  SemanticIndex<Entry>& index_of(Generation generation) { return classes[std::to_underlying(generation)]; }

  void file(const Stored<Entry>& stored, const Filing& filing) {
    names.file(stored);
    index_of(filing.generation).file(stored, filing);
  }

  void unfile(const Stored<Entry>& stored) {
    names.unfile(stored);
    for (const Generation generation : {Generation::even, Generation::odd})
      index_of(generation).unfile(stored, generation);
  }
};

template <typename Entry>
Table<Entry>::Table() : indexes_(std::make_unique<Indexes>()) {}

template <typename Entry>
Table<Entry>::~Table() = default;

template <typename Entry>
const Stored<Entry>& Table<Entry>::insert(Entry entry, const Filing& filing) {
  const base::Instant updated = std::exchange(entry.updated, {});
  Element<Entry> element(kept(std::move(entry)));
  element.updated = updated;
  element.identity = id32(identity_of(element.entry));
  element.slot = indexes_->take_slot();
  const auto [at, is_new] = indexes_->container.insert(std::move(element));
  GEMINGA_ASSERT(is_new);
  indexes_->file(*at, filing);
  return *at;
}

template <typename Entry>
void Table<Entry>::share(std::shared_ptr<SharedEntries> entries) {
  shared_ = std::move(entries);
}

template <typename Entry>
std::shared_ptr<const Entry> Table<Entry>::kept(Entry entry) const {
  if (shared_ == nullptr) return std::make_shared<const Entry>(std::move(entry));
  const auto is_same = [&](const Entry& known) { return known.is_local == entry.is_local && known.same_as(entry); };
  const auto make = [&] { return std::move(entry); };
  if constexpr (std::is_same_v<Entry, PublicationEntry>) {
    return shared_->publications.share(entry.key, is_same, make);
  } else {
    return shared_->subscriptions.share(entry.key, is_same, make);
  }
}

template <typename Entry>
std::shared_ptr<const Entry> Table<Entry>::replace(const StoredEntry& stored, Entry entry, const Filing& filing) {
  GEMINGA_ASSERT(stored.entry.key == entry.key);
  const auto at = indexes_->position_of(stored);
  indexes_->unfile(stored);
  auto before = stored.kept;
  const bool is_replaced = indexes_->container.modify(at, [&](Element<Entry>& element) {
    const base::Instant updated = std::exchange(entry.updated, {});
    const std::uint32_t slot = element.slot;
    // The element refers to its entry, so another one is made in its place. It was taken out of all buckets.
    std::destroy_at(&element);
    std::construct_at(&element, kept(std::move(entry)));
    element.updated = updated;
    element.identity = id32(identity_of(element.entry));
    element.slot = slot;
  });
  GEMINGA_ASSERT(is_replaced);
  indexes_->file(*at, filing);
  return before;
}

template <typename Entry>
void Table<Entry>::refresh(const StoredEntry& stored, base::Instant updated) {
  indexes_->container.modify(indexes_->position_of(stored),
                             [&](Element<Entry>& element) { element.updated = updated; });
}

template <typename Entry>
void Table<Entry>::erase(const StoredEntry& stored) {
  indexes_->unfile(stored);
  indexes_->free_slots.push_back(stored.slot);
  indexes_->container.erase(indexes_->position_of(stored));
}

template <typename Entry>
void Table<Entry>::set_class_count(std::size_t count, Generation generation) {
  indexes_->index_of(generation).set_class_count(count);
}

template <typename Entry>
void Table<Entry>::refile(const StoredEntry& stored, const Filing& filing) {
  auto& index = indexes_->index_of(filing.generation);
  index.unfile(stored, filing.generation);
  index.file(stored, filing);
}

template <typename Entry>
void Table<Entry>::unfile(const StoredEntry& stored, Generation generation) {
  indexes_->index_of(generation).unfile(stored, generation);
  stored.classes[std::to_underlying(generation)].shrink_to_fit();
}

template <typename Entry>
std::size_t Table<Entry>::size() const {
  return indexes_->container.size();
}

template <typename Entry>
const Stored<Entry>* Table<Entry>::find(const ServiceKey& key) const {
  const auto& index = indexes_->container.template get<ByKey>();
  const auto at = index.find(key);
  return at == index.end() ? nullptr : &*at;
}

template <typename Entry>
std::span<const Filed<Entry>> Table<Entry>::with_identity(const Identity& identity, Id32 id) const {
  return indexes_->names.with_identity(identity, id);
}

template <typename Entry>
std::vector<std::span<const Filed<Entry>>> Table<Entry>::with_number(Id32 id) const {
  return indexes_->names.with_number(id);
}

template <typename Entry>
std::span<const Filed<Entry>> Table<Entry>::with_concept(std::string_view concept_iri) const {
  return indexes_->names.with_concept(concept_iri);
}

template <typename Entry>
std::span<const Filed<Entry>> Table<Entry>::own(ClassIndex number, Generation generation) const {
  return indexes_->index_of(generation).own(number);
}

template <typename Entry>
std::span<const Filed<Entry>> Table<Entry>::below(ClassIndex number, Generation generation) const {
  return indexes_->index_of(generation).below(number);
}

template <typename Entry>
std::vector<const Stored<Entry>*> Table<Entry>::of_participant(ParticipantId participant) const {
  const auto& index = indexes_->container.template get<InKeyOrder>();
  return plain<Entry>(pointers(index.equal_range(participant, InParticipant{})));
}

template <typename Entry>
std::vector<const Stored<Entry>*> Table<Entry>::of_peer(ParticipantId participant, PeerId peer) const {
  const auto& index = indexes_->container.template get<InKeyOrder>();
  return plain<Entry>(pointers(index.equal_range(PeerPrefix{participant, peer}, InPeer{})));
}

template <typename Entry>
bool Table<Entry>::visit_after(const std::optional<ServiceKey>& after,
                               const std::function<bool(const StoredEntry&)>& visit) const {
  const auto& index = indexes_->container.template get<InKeyOrder>();
  for (auto at = after ? index.upper_bound(*after) : index.begin(); at != index.end(); ++at) {
    if (!visit(*at)) return false;
  }
  return true;
}

template class Table<PublicationEntry>;
template class Table<SubscriptionEntry>;

}  // namespace geminga::registry
