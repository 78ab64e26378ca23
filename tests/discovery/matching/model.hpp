// A model of the matcher without indexes: it works everything out from scratch after each step.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_MODEL_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_MODEL_HPP

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/meeting/request.hpp"

namespace geminga::matching {

/// The last that a peer was told about a service or consumer.
struct Told {
  decltype(Event::about) about;
  Match match;
};

/// All that local peers were told: by the key of the peer's own service or request, then by the key of the other side.
/// Publications and subscriptions share one space of keys, as in GCNP.
using View = std::map<std::pair<ServiceKey, ServiceKey>, Told>;

[[nodiscard]] bool is_same(const Told& a, const Told& b);

class Model {
 public:
  explicit Model(Placing placing = {}) : placing_(std::move(placing)) {}
  Model(const Model&) = delete;  // `overlapping` knows its place
  Model& operator=(const Model&) = delete;

  std::map<ServiceKey, registry::PublicationEntry> publications;
  std::map<ServiceKey, registry::SubscriptionEntry> subscriptions;
  vocabulary::Vocabulary ontology;
  /// The subscriptions that are still judged by the former ontology while it changes.
  std::set<ServiceKey> former;
  vocabulary::Vocabulary former_ontology;
  /// Says which concepts overlap. Answers are remembered, since the reasoner has to search.
  Overlapping overlapping = [this](const vocabulary::Vocabulary& by, const Meaning& offered, const Meaning& requested,
                                   ParticipantId) {
    auto& answer = overlaps_[{by.digest(), offered.identity.concept_iri, requested.identity.concept_iri}];
    if (answer == nullptr) answer = decided_at_once(by, offered, requested);
    return answer;
  };

  /// Chooses anew for every subscription, with those chosen last time as incumbents.
  void work_out();
  /// All that local peers know after work_out().
  [[nodiscard]] View view() const;
  /// The match of two entries that are known since the last work_out().
  [[nodiscard]] std::optional<Match> meets(const registry::SubscriptionEntry& subscription,
                                           const registry::PublicationEntry& publication) const;
  /// The same for changed forms of both; conversions are those of the subscription as it was.
  [[nodiscard]] std::optional<Match> would_meet(const registry::SubscriptionEntry& subscription,
                                                const registry::PublicationEntry& publication) const;
  /// The publications that a subscription of any host is given, by all that is known, as far as it chooses for itself.
  [[nodiscard]] bool is_chosen(const ServiceKey& subscription, const ServiceKey& publication) const {
    return chosen_.at(subscription).contains(publication);
  }

 private:
  /// The match of two entries, with the description of the provider's participant where there is one.
  [[nodiscard]] std::optional<Match> met(const registry::SubscriptionEntry& subscription, const Request& request,
                                         const registry::PublicationEntry& publication,
                                         const vocabulary::Vocabulary& by) const;

  Placing placing_;
  std::map<std::tuple<std::uint64_t, std::string, std::string>, OverlapAnswer> overlaps_;
  std::map<ServiceKey, Request> requests_;
  std::uint64_t arrivals_ = 0;
  std::map<ServiceKey, std::uint64_t> arrival_;  ///< of publications, in the order in which they came
  /// Whether one is a number, the other a concept, and the number is that of two different concepts.
  [[nodiscard]] bool is_kept_apart(const Identity& offered, const Identity& requested) const;
  std::map<Id32, std::set<Identity>> concepts_;               ///< by their number
  std::map<ServiceKey, std::map<ServiceKey, Match>> chosen_;  ///< by subscription, then by publication
};

/// Checks events against two views, and gives the error; empty where there is none. `reason` is that of the step.
class Replay {
 public:
  explicit Replay(View view) : view_(std::move(view)) {}

  /// Applies the events to the view: for each pair add (modify)* del, each at most once in a step, a del as last told.
  [[nodiscard]] std::string apply(const std::vector<Event>& events, Reason reason, const Model& model);
  [[nodiscard]] const View& view() const { return view_; }
  /// The end of a peer's own request is not told to it.
  void forget(const ServiceKey& to);

 private:
  [[nodiscard]] std::string apply(const Event& event, Reason reason, const Model& model);

  View view_;
};

/// The difference of two views; empty where there is none.
[[nodiscard]] std::string difference(const View& told, const View& wanted);

}  // namespace geminga::matching

#endif
