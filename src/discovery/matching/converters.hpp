// The converters that are there, by one vocabulary: the chains that go through them, and the requests that a change of
// one concerns.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONVERTERS_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONVERTERS_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "discovery/matching/consumer.hpp"
#include "discovery/registry/entry.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// Not thread-safe.
class Converters {
 public:
  using Chain = std::shared_ptr<const vocabulary::Chain>;
  /// How many answers are remembered. When there are more, all are forgotten.
  static constexpr std::size_t max_remembered = 4096;

  explicit Converters(vocabulary::Vocabulary vocabulary) : vocabulary_(std::move(vocabulary)) {}

  /// What is offered now under this key: it becomes a converter, changes, or is one no more. `arrival` grows with the
  /// order in which this host came to know of what is offered.
  void put(const registry::PublicationEntry& entry, const Audience& audience, std::uint64_t arrival);
  void erase(const ServiceKey& key);
  /// Whether none is known: most teams have none, and pay nothing.
  [[nodiscard]] bool is_empty() const { return known_.empty(); }

  /// From here on a request is told by stale() of what concerns it. It asks for the class `requested`.
  void watch(const std::shared_ptr<const Consumer>& consumer, vocabulary::ClassNumber requested);
  /// It is watched no more, and not stale.
  void unwatch(const ServiceKey& subscription);
  /// The requests whose chains may be others than when they were watched or judged.
  [[nodiscard]] const std::set<ServiceKey>& stale() const { return stale_; }
  /// It is about to be judged.
  void refresh(const ServiceKey& subscription) { stale_.erase(subscription); }

  /// The best chain for this consumer; null where there is none. Both classes must be satisfiable.
  [[nodiscard]] Chain chain(const Consumer& consumer, vocabulary::ClassNumber offered,
                            vocabulary::ClassNumber requested) const;
  /// Requests and steps that were looked at since the last call, because a converter has come or gone.
  [[nodiscard]] std::uint64_t take_work() { return std::exchange(work_, 0); }
  /// Those that take part in chains.
  [[nodiscard]] std::size_t active_count() const { return active_.size(); }
  /// Those that are known beside them.
  [[nodiscard]] std::size_t waiting_count() const { return known_.size() - active_.size(); }

 private:
  struct Known {
    Converter converter;
    std::uint64_t arrival = 0;
    std::optional<std::uint32_t> place{};  ///< nothing: it waits for one
  };

  /// The converters of one host that wait for a place. While the host may have another one, the arrival of the first is
  /// in `next_`.
  struct Queue {
    std::set<ServiceKey> keys;
    std::optional<std::uint64_t> next{};
  };
  using Next = std::set<std::pair<std::uint64_t, ParticipantId>>;

  [[nodiscard]] bool may_have_another(ParticipantId participant) const;
  [[nodiscard]] bool has_room_for(const Known& known) const;
  [[nodiscard]] Next& next(bool is_local) { return is_local ? next_local_ : next_remote_; }
  void await(const Known& known);
  void await_no_more(const Known& known);
  /// To be called when those that wait, or the room that their host has, may be others.
  void put_in_line(const registry::PublicationEntry& any_of_host);
  void activate(Known& known);
  void deactivate(Known& known);
  /// Gives a free place to the first that waits and may have it. Those of a host that has all it may have are not
  /// looked at, however many they are.
  void promote();
  /// Takes its place from the one with the greatest key of the same host, where that has as many as it may and this key
  /// is smaller: so everybody takes the same ones of a host, in whatever order they became known. Whether it did.
  bool displace(Known& newcomer);
  /// The requests that the step of an active converter may concern become stale.
  void concern(const Known& known);
  [[nodiscard]] const Places& partners_of(const Consumer& consumer) const;
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
  std::optional<vocabulary::StepGraph> graph_;               ///< since the first converter came
  std::uint32_t declared_ = 0;                               ///< the places of declared conversions are below this
  std::uint64_t version_ = 1;                                ///< grows when a converter comes or goes
  std::map<ServiceKey, vocabulary::ClassNumber> requested_;  ///< by those that are watched
  std::map<vocabulary::ClassNumber, std::map<ServiceKey, std::shared_ptr<const Consumer>>> watched_;
  std::set<ServiceKey> stale_;
  std::uint64_t work_ = 0;
  mutable std::map<std::tuple<vocabulary::ClassNumber, vocabulary::ClassNumber, Places>, Chain> remembered_;
};

}  // namespace geminga::matching

#endif
