// The publications that are known, with what each vocabulary at work makes of them.
#ifndef GEMINGA_DISCOVERY_MATCHING_OFFERS_HPP
#define GEMINGA_DISCOVERY_MATCHING_OFFERS_HPP

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "discovery/matching/arbitration/reason.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/preparation.hpp"
#include "discovery/registry/table.hpp"

namespace geminga::matching {

/// Files what comes and takes out what goes; judges nothing.
class Offers {
 public:
  Offers(const Editions& editions, const Preparation& preparation);
  Offers(const Offers&) = delete;
  Offers& operator=(const Offers&) = delete;

  [[nodiscard]] const registry::Publications& table() const { return table_; }
  /// registry::Table::share().
  void share(const std::shared_ptr<registry::SharedEntries>& entries) { table_.share(entries); }

  /// Adds an entry whose key is not there yet.
  const registry::StoredPublication& add(registry::PublicationEntry entry);
  /// Puts an entry with the same key into the place of one, and gives what was there.
  std::shared_ptr<const registry::PublicationEntry> replace(const registry::StoredPublication& stored,
                                                            registry::PublicationEntry entry);
  /// Says that an entry was heard of again, as it is.
  void refresh(const registry::StoredPublication& stored, base::Instant updated) { table_.refresh(stored, updated); }
  /// Marks entries as about to be erased: they meet and convert nothing.
  void retire(const std::vector<const registry::StoredPublication*>& publications, Reason reason);
  void erase(const registry::StoredPublication& stored);

  /// Makes the index of an edition that has come, and drops that of one that goes.
  void open_index(const Edition& edition);
  void close_index(const Edition& edition) { table_.set_class_count(0, edition.generation); }
  /// Looks up a publication in the vocabulary of an edition, and files it by that.
  void file(const registry::StoredPublication& stored, const Edition& edition);
  /// Takes a publication out of the index of an edition.
  void unfile(const registry::StoredPublication& stored, const Edition& edition);

  /// Whether it is about to be erased.
  [[nodiscard]] bool is_going(const registry::StoredPublication& stored) const {
    return known(stored).leaves.has_value();
  }
  /// Why it is about to be erased; nothing where it is not.
  [[nodiscard]] std::optional<Reason> reason_to_go(const registry::StoredPublication& stored) const {
    return known(stored).leaves;
  }
  [[nodiscard]] const Classes& classes(const registry::StoredPublication& stored, const Edition& edition) const {
    return known(stored).classes[std::to_underlying(edition.generation)];
  }
  /// A publication with all that an edition knows of it.
  [[nodiscard]] Offer offer(const registry::StoredPublication& stored, const Edition& edition) const;

  /// How many entries were filed or unfiled in an index since the start.
  [[nodiscard]] std::uint64_t filed() const { return filed_; }

 private:
  struct Known {
    std::array<Classes, 2> classes;                              ///< by generation
    std::array<std::unique_ptr<const Signature>, 2> signatures;  ///< by generation; null: none is stated
    std::unique_ptr<const Audience> audience;                    ///< null: it is for everybody
    std::optional<Reason> leaves;                                ///< why it is about to be erased
    std::uint64_t arrival = 0;                                   ///< greater than that of those that came before it
  };

  [[nodiscard]] Known& known(const registry::StoredPublication& stored) { return known_[stored.slot]; }
  [[nodiscard]] const Known& known(const registry::StoredPublication& stored) const { return known_[stored.slot]; }
  [[nodiscard]] static const Audience& audience(const Known& publication) {
    return publication.audience ? *publication.audience : Audience::everybody();
  }
  /// Looks up and files a publication that was just stored.
  void take_in(const registry::StoredPublication& stored);

  const Editions& editions_;
  const Preparation& preparation_;
  registry::Publications table_;
  std::vector<Known> known_;  ///< by slot
  std::uint64_t arrivals_ = 0;
  std::uint64_t filed_ = 0;
};

}  // namespace geminga::matching

#endif
