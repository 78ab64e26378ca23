// The converters that one vocabulary knows: the chains through them, and the requests that a change of one concerns.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONVERSIONS_CONVERTERS_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONVERSIONS_CONVERTERS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "discovery/matching/conversions/consumer.hpp"
#include "discovery/registry/entry.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// Not thread-safe.
class Converters {
 public:
  using Chain = std::shared_ptr<const vocabulary::Chain>;
  /// How many answers are remembered. Beyond that, all are forgotten.
  static constexpr std::size_t max_remembered = 4096;
  /// How many requests one step looks at for the next one that is stale.
  static constexpr std::size_t max_looked_at = 64;

  explicit Converters(vocabulary::Vocabulary vocabulary) : vocabulary_(std::move(vocabulary)) {}

  /// A publication has come or changed: it becomes a converter, changes, or ceases to be one. `arrival` says in which
  /// order this host came to know of publications.
  void put(const registry::PublicationEntry& entry, const Audience& audience, std::uint64_t arrival);
  void erase(const ServiceKey& key) { erase(std::span(&key, 1)); }
  /// Removes all of these at once, so that none of them takes the place of another.
  void erase(std::span<const ServiceKey> keys);
  /// Whether no converter is known, as in most teams, which then pay nothing.
  [[nodiscard]] bool is_empty() const { return known_.empty(); }

  /// From here on a request becomes stale when a converter concerns it. It asks for the class `requested`.
  void watch(const std::shared_ptr<const Consumer>& consumer, vocabulary::ClassNumber requested);
  /// Ends watch(). The request is no longer stale.
  void unwatch(const ServiceKey& subscription);
  /// Whether a request may be stale: its chains may have changed since it was watched or judged.
  [[nodiscard]] bool has_stale() const { return !stale_groups_.empty(); }
  /// Whether this request is stale.
  [[nodiscard]] bool is_stale(const ServiceKey& subscription) const;
  /// The next stale request; nothing where none was found among max_looked_at. Then a further call looks at others, as
  /// long as has_stale().
  [[nodiscard]] std::optional<ServiceKey> next_stale();
  /// A request is about to be judged, and not stale any longer.
  void refresh(const ServiceKey& subscription);

  /// The best chain for this consumer; null where there is none. Both classes must be satisfiable.
  [[nodiscard]] Chain chain(const Consumer& consumer, vocabulary::ClassNumber offered,
                            vocabulary::ClassNumber requested) const;
  /// How many requests and steps were looked at since the last call because a converter came or went, and to find
  /// chains.
  [[nodiscard]] std::uint64_t take_work() { return std::exchange(work_, 0); }
  /// How many known converters take part in no chain.
  [[nodiscard]] std::size_t waiting_count() const { return known_.size() - active_.size(); }

 private:
  struct Known {
    Converter converter;
    std::uint64_t arrival = 0;
    std::optional<std::uint32_t> place{};  ///< nothing: it waits for one
  };

  /// The converters of one host that wait for a place. While the host may have another place, the first of them stands
  /// in `next_` by its arrival.
  struct Queue {
    std::set<ServiceKey> keys;
    std::optional<std::uint64_t> next{};
  };
  using Next = std::set<std::pair<std::uint64_t, ParticipantId>>;

  /// The requests for one class. A change of a converter concerns the group at once, and its requests one by one when
  /// they are looked at: so the change costs the same however many they are.
  struct Group {
    std::map<ServiceKey, std::shared_ptr<const Consumer>> consumers;
    std::uint64_t concerned = 0;                                      ///< the last version that may concern it
    std::uint64_t walked = 0;                                         ///< `concerned` when the walk through it began
    std::uint32_t least = std::numeric_limits<std::uint32_t>::max();  ///< the least cost at which one leads here
    std::optional<ServiceKey> at{};                                   ///< where the walk is
  };

  [[nodiscard]] bool may_have_another(ParticipantId participant) const;
  [[nodiscard]] bool has_room_for(const Known& known) const;
  [[nodiscard]] Next& next(bool is_local) { return is_local ? next_local_ : next_remote_; }
  void await(const Known& known);
  void await_no_more(const Known& known);
  /// Updates `next_` after the waiting converters of a host, or the number of its places, have changed.
  void put_in_line(const registry::PublicationEntry& any_of_host);
  void activate(Known& known);
  void deactivate(Known& known);
  /// Gives a free place to the first waiting converter that may have it. Converters of a host that has all its places
  /// are not looked at, however many they are.
  void promote();
  /// Gives a newcomer the place of the converter of its host with the greatest key, where the host has all its places
  /// and the newcomer's key is smaller. So all hosts take the same converters of a host, in whatever order they became
  /// known. Whether it was done.
  bool displace(Known& newcomer);
  /// Makes the groups stale that the step of an active converter leads to.
  void concern(const Known& known);
  /// A place has got another converter, or none.
  void change(std::uint32_t place);
  /// Brings the partners of a consumer up to date, place by place.
  void bring_up(const Consumer& consumer) const;
  [[nodiscard]] bool is_stale(const Group& group, const Consumer& consumer) const;
  /// Forgets the answers that converters which went may have been part of.
  void forget_outdated() const;
  [[nodiscard]] std::uint32_t in_graph(std::uint32_t place) const { return declared_ + place; }
  [[nodiscard]] std::string via_of(const std::vector<std::uint32_t>& way) const;

  vocabulary::Vocabulary vocabulary_;
  std::map<ServiceKey, Known> known_;
  std::map<std::uint32_t, const Known*> active_;  ///< by place
  std::map<ParticipantId, Queue> waiting_;
  Next next_local_;
  Next next_remote_;
  std::map<ParticipantId, std::set<ServiceKey>> active_of_;  ///< by whose they are
  std::size_t remote_ = 0;                                   ///< active ones of other hosts
  std::optional<vocabulary::StepGraph> graph_;               ///< nothing until the first converter comes
  std::uint32_t declared_ = 0;                               ///< the places of declared conversions are below this
  std::uint64_t version_ = 1;                                ///< grows when a converter comes or goes
  std::map<ServiceKey, vocabulary::ClassNumber> requested_;  ///< by watched subscription
  std::map<vocabulary::ClassNumber, Group> watched_;
  std::set<vocabulary::ClassNumber> stale_groups_;
  std::array<std::uint64_t, max_converters> changed_{};  ///< by place: the version of its last change
  mutable std::uint64_t work_ = 0;
  mutable Places outdated_{};  ///< places whose answers are still remembered though they have changed
  mutable std::map<std::tuple<vocabulary::ClassNumber, vocabulary::ClassNumber, Places>, Chain> remembered_;
};

}  // namespace geminga::matching

#endif
