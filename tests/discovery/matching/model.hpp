// A matcher that knows nothing of indexes: it works everything out from scratch after each step and compares.
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
#include "discovery/matching/request.hpp"

namespace geminga::matching {

/// What one peer has been told about one thing.
struct Told {
  decltype(Event::about) about;
  Match match;
};

/// What all local peers have been told: by who was told, then by whom it is about. Publications and subscriptions share
/// one space of keys in GCNP, and so they do here.
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
  /// While an ontology changes: the subscriptions that are still judged by the former one.
  std::set<ServiceKey> former;
  vocabulary::Vocabulary former_ontology;
  /// Which concepts overlap; remembered, since the reasoner has to search.
  Overlapping overlapping = [this](const vocabulary::Vocabulary& by, vocabulary::ClassNumber offered,
                                   const SemanticIdentity& requested, const Classes& classes, ParticipantId) {
    auto& answer = overlaps_[{by.digest(), offered, requested.concept_iri}];
    if (answer == nullptr) answer = decided_at_once(by, offered, requested, classes);
    return answer;
  };

  /// Chooses anew for every subscription, with those chosen last time as incumbents.
  void work_out();
  /// What every local peer knows after work_out().
  [[nodiscard]] View view() const;
  /// Between entries that are here since the last work_out().
  [[nodiscard]] std::optional<Match> meets(const registry::SubscriptionEntry& subscription,
                                           const registry::PublicationEntry& publication) const;
  /// The same of both in another form; what is converted for the subscription is as it was.
  [[nodiscard]] std::optional<Match> would_meet(const registry::SubscriptionEntry& subscription,
                                                const registry::PublicationEntry& publication) const;
  /// What a subscription of any host is given by the whole of what is known, as far as it chooses for itself.
  [[nodiscard]] bool is_chosen(const ServiceKey& subscription, const ServiceKey& publication) const {
    return chosen_.at(subscription).contains(publication);
  }

 private:
  Placing placing_;
  std::map<std::tuple<std::uint64_t, vocabulary::ClassNumber, std::string>, OverlapAnswer> overlaps_;
  std::map<ServiceKey, Request> requests_;
  std::uint64_t arrivals_ = 0;
  std::map<ServiceKey, std::uint64_t> arrival_;  ///< of publications, in the order in which they came
  /// Whether one is a number and the other a concept, and the number that of two different concepts.
  [[nodiscard]] bool is_kept_apart(const Identity& offered, const Identity& requested) const;
  std::map<Id32, std::set<Identity>> concepts_;               ///< by their number
  std::map<ServiceKey, std::map<ServiceKey, Match>> chosen_;  ///< by subscription, then by publication
};

/// Checks events against two views, and says what is wrong; empty where nothing is. `reason` is that of the step.
class Replay {
 public:
  explicit Replay(View view) : view_(std::move(view)) {}

  /// Applies the events to the view: per pair add (modify)* del, each at most once a step, a del as last told.
  [[nodiscard]] std::string apply(const std::vector<Event>& events, Reason reason, const Model& model);
  [[nodiscard]] const View& view() const { return view_; }
  /// The end of a peer's own request is not told to it.
  void forget(const ServiceKey& to);

 private:
  [[nodiscard]] std::string apply(const Event& event, Reason reason, const Model& model);

  View view_;
};

/// Where two views differ; empty where they do not.
[[nodiscard]] std::string difference(const View& told, const View& wanted);

}  // namespace geminga::matching

#endif
