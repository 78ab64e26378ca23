// The services that our own peers state, on their way into the registry and out of it.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_OWN_SERVICES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_OWN_SERVICES_HPP

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "discovery/announcement/announcement.hpp"
#include "discovery/matching/matcher.hpp"
#include "discovery/participant/clients/own_description.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/clients/telling.hpp"
#include "discovery/participant/knowledge/resolver.hpp"
#include "discovery/participant/knowledge/self.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// The address of a service that states none, as it is told to peers on the same host.
inline constexpr const char* local_address = "127.0.0.1";
/// Pairs of services on one host that may change in one event: a change of one service never makes more events for
/// local peers than the host has services.
inline constexpr std::size_t max_pairs_at_once = 1024;

/// The only one that puts services of our own into the matcher and takes them out again. Statements themselves stand in
/// the sessions.
class OwnServices {
 public:
  /// Borrows all for its life.
  OwnServices(const env::Env& env, const Self& self, matching::Matcher& matcher, Resolver& resolver, Sessions& sessions,
              Telling& telling, WorkMeter& work)
      : env_(env),
        self_(self),
        matcher_(matcher),
        resolver_(resolver),
        sessions_(sessions),
        telling_(telling),
        work_(work),
        description_(env, self, matcher, resolver) {}

  /// Enters a statement that is in force, or its change, into the registry. `telling` is about a subscription.
  void enter(const Session& session, std::uint32_t number, const StatedPublication& stated,
             matching::Matcher::Telling telling = matching::Matcher::Telling::all);
  void enter(const Session& session, std::uint32_t number, const StatedSubscription& stated,
             matching::Matcher::Telling telling = matching::Matcher::Telling::all);
  /// Puts a statement out of force until the ontology is there. The peer is told that everything it was told of is
  /// gone, and keeps its request.
  template <typename Stated>
  void suspend(Session& session, std::uint32_t number, const Stated& stated);
  /// Withdraws a service, and forgets all that is known of it here.
  void forget(Session& session, std::uint32_t number);

  /// Whether all services of the peer may change at once.
  [[nodiscard]] bool is_small(const Session& session) const;
  /// Withdraws all services of a peer at once, so that none that is about to go is chosen in place of one that has
  /// gone.
  void withdraw_all(Session& session);
  /// Withdraws one service of a peer that is not small; there must be one.
  void withdraw_one(Session& session);
  /// Enters all services of the peer under its new name: at once, or by rename_one() in turns where they are many.
  void rename(Session& session);
  /// Enters the next service of a peer under its new name; there must be one.
  void rename_one(Session& session);

  /// Has all that our peers have stated return under the identifier that is held now, request by request.
  void list_returning();
  [[nodiscard]] bool has_returning() const { return !returning_.empty(); }
  /// Enters one request again: its peer is told that all it was told of for this request is gone, and then what there
  /// is. False: none was left.
  bool return_next();

  /// Lists the statements whose names are to be resolved by the ontology in force: all, or those that wait for one.
  void list_for_restating(bool is_of_all);
  /// Resolves the names of one listed statement. What the ontology does not know is withdrawn and told to its peer;
  /// what an earlier one did not know comes back. False: none was left.
  bool restate_next();

  /// Changes the description of this participant as OwnDescription::change() does.
  [[nodiscard]] Refusal describe(const gcnp::Describe& change) { return noting(description_.change(change)); }
  /// Sets or takes back the description that the owner of the participant has given.
  void describe(const std::string& concept_name) { is_changed_ |= description_.set(concept_name); }
  /// The participant has its identifier: announces the description that came before, else this one. Empty: none.
  void begin_description(const std::string& concept_name) {
    is_changed_ |=
        description_.count() == 0 && !concept_name.empty() ? description_.set(concept_name) : description_.enter();
  }
  [[nodiscard]] const OwnDescription& description() const { return description_; }

  /// Notes that the announced state has changed.
  void change() { is_changed_ = true; }
  /// Whether the announced state has changed since the last call.
  [[nodiscard]] bool take_change() { return std::exchange(is_changed_, false); }
  /// All that is announced of our peers.
  [[nodiscard]] std::vector<announcement::PeerState> announced() const;

 private:
  struct Statement {
    env::StreamId stream{};
    std::uint32_t number = 0;
  };

  [[nodiscard]] ServiceKey key_of(const Session& session, std::uint32_t number) const;
  [[nodiscard]] Refusal noting(Refusal refusal) {
    is_changed_ |= !refusal;
    return refusal;
  }
  void withdraw(const Session& session, std::uint32_t number, const StatedPublication& stated, matching::Reason reason);
  void withdraw(const Session& session, std::uint32_t number, const StatedSubscription& stated,
                matching::Reason reason);
  template <typename Stated>
  [[nodiscard]] bool resolve_again(Session& session, std::uint32_t number, Stated& stated);

  const env::Env& env_;
  const Self& self_;
  matching::Matcher& matcher_;
  Resolver& resolver_;
  Sessions& sessions_;
  Telling& telling_;
  WorkMeter& work_;
  OwnDescription description_;
  bool is_changed_ = false;
  std::vector<Statement> returning_;  ///< the next one last
  std::vector<Statement> restated_;   ///< the next one last
};

}  // namespace geminga::participant

#endif
