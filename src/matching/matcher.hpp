// Who is told of whom: publications and subscriptions in, GCNP events out (paper section 3.6).
#ifndef GEMINGA_MATCHING_MATCHER_HPP
#define GEMINGA_MATCHING_MATCHER_HPP

#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/time.hpp"
#include "el/ontology.hpp"
#include "geminga/error.hpp"
#include "geminga/match.hpp"
#include "geminga/service.hpp"
#include "registry/entry.hpp"

namespace geminga::matching {

/// How an offer meets a request.
struct Match {
  Degree degree = Degree::exact;
  std::uint32_t distance = 0;  ///< taxonomy edges of the concept plus those of the representation
  friend auto operator<=>(const Match&, const Match&) = default;
};

/// Why a service that was told of is gone; the `reason=` of GCNP. Words are only ever appended.
enum class Reason : std::uint8_t {
  withdrawn,  ///< its peer removed it or disconnected
  expired,    ///< its participant was not heard of before the deadline
  left,       ///< its participant said goodbye
  outranked,  ///< a better one took its place under the subscription's limit
  changed,    ///< it was modified and matches no more, or the ontology was
  renamed,    ///< its participant took a new identifier after a clash
};
[[nodiscard]] std::string_view to_string(Reason reason);

enum class Change : std::uint8_t { add, modify, del };
[[nodiscard]] std::string_view to_string(Change change);

/// What a local peer is to be told. `to` is its own subscription (for a PublicationEntry) or publication (for a SubscriptionEntry).
struct Event {
  Change change = Change::add;
  ServiceKey to;
  std::variant<registry::PublicationEntry, registry::SubscriptionEntry> about;  ///< as it is now; for del as it was last told
  Match match;
  Reason reason = Reason::withdrawn;  ///< for del only
};

/// One line of `geminga-query match`.
struct Ranked {
  const registry::PublicationEntry* publication = nullptr;  ///< borrowed until the next change of the matcher
  Match match;
};

/// Holds the registry, matches and arbitrates. Not thread-safe. Feeding it is idempotent: a put of what is there already
/// refreshes its deadline and causes no event. No event is ever doubled: per (to, about) the stream is add (modify)* del.
///
/// Arbitration order: greater priority, better degree, smaller distance, the incumbent, then the smaller key.
/// Providers are told of consumers in the modes oto and otm/pubsub only (paper section 3).
class Matcher {
 public:
  /// `ontology` may be null: then semantic identities match exactly or not at all. Borrowed until set_ontology().
  explicit Matcher(const el::Ontology* ontology);
  ~Matcher();

  /// Adds or changes an entry. Its identity is resolved by the caller (IRIs). An entry of another participant whose
  /// `where` cannot be read never matches.
  void put(registry::PublicationEntry entry);
  void put(registry::SubscriptionEntry entry);
  /// Removes one; false where there was none.
  bool remove_publication(const ServiceKey& key, Reason reason);
  bool remove_subscription(const ServiceKey& key, Reason reason);
  /// Removes all of a peer, or all of a participant.
  void remove_peer(ParticipantId participant, PeerId peer, Reason reason);
  void remove_participant(ParticipantId participant, Reason reason);
  /// Removes what has its deadline at or before `now`.
  void expire(base::Instant now);
  /// The earliest deadline, or base::never.
  [[nodiscard]] base::Instant next_deadline() const;
  /// Swaps the ontology and matches everything again; what stays matched gets no event.
  void set_ontology(const el::Ontology* ontology);

  /// The events since the last call, in the order in which they must be written.
  [[nodiscard]] std::vector<Event> take_events();

  /// The publications that meet a request, best first, arbitration's limit not applied.
  [[nodiscard]] std::vector<Ranked> match(const Subscription& request) const;
  /// How this offer meets this request by identity, mode, provider and filter; the error says what does not fit.
  [[nodiscard]] std::expected<Match, std::string> why(const registry::SubscriptionEntry& request,
                                                      const registry::PublicationEntry& offer) const;
  /// In ascending order of key.
  void for_each_publication(const std::function<void(const registry::PublicationEntry&)>& visit) const;
  void for_each_subscription(const std::function<void(const registry::SubscriptionEntry&)>& visit) const;
  [[nodiscard]] const registry::PublicationEntry* find_publication(const ServiceKey& key) const;
  [[nodiscard]] const registry::SubscriptionEntry* find_subscription(const ServiceKey& key) const;
  /// Whether anybody known, anywhere in the team, serves this subscription / asks for this publication.
  [[nodiscard]] bool is_served(const registry::SubscriptionEntry& subscription) const;
  [[nodiscard]] bool is_used(const registry::PublicationEntry& publication) const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Reads a `where` expression and says what is wrong with it at which octet; used to refuse a bad one with 422.
[[nodiscard]] std::optional<Error> check_where(std::string_view expression);

}  // namespace geminga::matching

#endif
