// Stored entries: an entry with its 32-bit identity, its slot, and every bucket that it is filed in.
#ifndef GEMINGA_DISCOVERY_REGISTRY_STORED_HPP
#define GEMINGA_DISCOVERY_REGISTRY_STORED_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/shared_values.hpp"
#include "base/time.hpp"
#include "discovery/registry/entry.hpp"
#include "geminga/identity.hpp"

namespace geminga::registry {

template <typename Entry>
class Bucket;
template <typename Entry>
class Name;

/// The semantic index of one of two ontologies that are at work while one takes the place of the other. An entry may be
/// filed in both indexes.
enum class Generation : std::uint8_t { even, odd };
[[nodiscard]] constexpr Generation other(Generation one) {
  return one == Generation::even ? Generation::odd : Generation::even;
}

/// The kind of a filing: by names, or by the classes of one ontology.
enum class FiledBy : std::uint8_t { names, even_classes, odd_classes };
[[nodiscard]] constexpr FiledBy filed_by(Generation one) {
  return one == Generation::even ? FiledBy::even_classes : FiledBy::odd_classes;
}

/// The name of an entry that it is filed by.
enum class NameFiling : std::uint8_t { identity, concept_alone };

/// The position of an entry among those with one name, or those of one class. It makes the cost of removing an entry
/// independent of how many they are.
template <typename Entry>
struct NamedAt {
  const Name<Entry>* name = nullptr;
  std::uint32_t position = 0;
};
struct ClassedAt {
  std::uint32_t bucket = 0;  ///< of the semantic index: twice the class, and one more for those below it
  std::uint32_t position = 0;
  [[nodiscard]] std::uint32_t number() const { return bucket / 2; }
  [[nodiscard]] bool is_below() const { return bucket % 2 != 0; }
};

/// An entry in the registry. Its address stays the same until it is erased. Only the registry changes it.
template <typename Entry>
struct Stored {
  explicit Stored(std::shared_ptr<const Entry> known) : kept(std::move(known)), entry(*kept) {}

  /// Owned by the table, by events about it, and by all tables of the process that share it (SharedEntries).
  std::shared_ptr<const Entry> kept;
  const Entry& entry;       ///< the one that `kept` owns
  base::Instant updated{};  ///< when it was last stated
  /// The 32-bit identity: candidates, never proof.
  Id32 identity = 0;
  /// A small number that no other entry of the same table has. It is used again after the entry was erased. Others can
  /// keep what they know about entries in an array by slot.
  std::uint32_t slot = 0;

  /// Used by the registry alone; mutable because none of it is part of a key of the container.
  mutable std::array<NamedAt<Entry>, 2> names;            ///< by NameFiling
  mutable std::array<std::vector<ClassedAt>, 2> classes;  ///< by Generation
  /// Updates its position in the bucket that `by` and `back` name.
  void move_to(FiledBy by, std::uint32_t back, std::uint32_t position) const {
    if (by == FiledBy::names) {
      names[back].position = position;
    } else {
      classes[by == FiledBy::even_classes ? 0 : 1][back].position = position;
    }
  }
};

/// Entries with one name or class, in an arbitrary order. A caller that shows them or decides by them sorts them first.
/// A single entry needs no allocation, because most identities have one provider. A bucket must not be moved while an
/// entry is filed in it.
template <typename Entry>
class Bucket {
 public:
  struct Filed {
    const Stored<Entry>* stored = nullptr;
    std::uint32_t by : 2 = 0;     ///< FiledBy
    std::uint32_t back : 30 = 0;  ///< which of its filings of this kind points here
  };

  /// Appends, as its filing `back` of this kind, and gives the position. Amortised O(1).
  std::uint32_t file(const Stored<Entry>& stored, FiledBy by, std::size_t back) {
    if (size_ == capacity_) grow();
    begin()[size_] = {&stored, std::to_underlying(by) & 3U, static_cast<std::uint32_t>(back) & max_filings};
    return size_++;
  }

  /// Puts the last entry into the hole and tells it its new place; O(1). The caller forgets the filing itself.
  void remove(std::uint32_t position) {
    const Filed last = begin()[--size_];
    begin()[position] = last;
    last.stored->move_to(FiledBy{static_cast<std::uint8_t>(last.by)}, last.back, position);
  }

  [[nodiscard]] std::span<const Filed> entries() const { return {many_ ? many_.get() : &only_, size_}; }
  [[nodiscard]] bool is_empty() const { return size_ == 0; }

 private:
  static constexpr std::uint32_t max_filings = (std::uint32_t{1} << 30) - 1;  ///< more classes than there can be

  Filed* begin() { return many_ ? many_.get() : &only_; }

  void grow() {
    const std::uint32_t capacity = capacity_ * 2;
    auto more = std::make_unique<Filed[]>(capacity);
    std::copy_n(begin(), size_, more.get());
    many_ = std::move(more);
    capacity_ = capacity;
  }

  Filed only_;
  std::unique_ptr<Filed[]> many_;
  std::uint32_t size_ = 0;
  std::uint32_t capacity_ = 1;
};

template <typename Entry>
using Filed = typename Bucket<Entry>::Filed;

/// The entries that the tables of several participants in one process have, each once.
struct SharedEntries {
  base::SharedValues<ServiceKey, PublicationEntry> publications;
  base::SharedValues<ServiceKey, SubscriptionEntry> subscriptions;
};

using StoredPublication = Stored<PublicationEntry>;
using StoredSubscription = Stored<SubscriptionEntry>;

}  // namespace geminga::registry

#endif
