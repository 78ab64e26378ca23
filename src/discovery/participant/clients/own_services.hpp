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
  /// Borrows all for its life. Only the description needs the resolver.
  OwnServices(const env::Env& env, const Self& self, matching::Matcher& matcher, Resolver& resolver, Sessions& sessions,
              Telling& telling)
      : env_(env),
        self_(self),
        matcher_(matcher),
        sessions_(sessions),
        telling_(telling),
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
  /// Takes a statement out of the registry. It stays in its session.
  void withdraw(const Session& session, std::uint32_t number, const StatedPublication& stated, matching::Reason reason);
  void withdraw(const Session& session, std::uint32_t number, const StatedSubscription& stated,
                matching::Reason reason);
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

  /// Changes the description of this participant as OwnDescription::change() does.
  [[nodiscard]] Refusal describe(const gcnp::Describe& change) { return noting(description_.change(change)); }
  /// Sets or takes back the description that the owner of the participant has given.
  void describe(const std::string& concept_name) { is_changed_ |= description_.set(concept_name); }
  /// The participant has its identifier: announces the description that came before, else this one. Empty: none.
  void begin_description(const std::string& concept_name) {
    is_changed_ |=
        description_.count() == 0 && !concept_name.empty() ? description_.set(concept_name) : description_.enter();
  }
  /// Enters the description under the identifier that is held now.
  void enter_description() { is_changed_ |= description_.enter(); }
  /// Resolves its names by the ontology in force, as OwnDescription::restate() does.
  void restate_description(bool is_always) { is_changed_ |= description_.restate(is_always); }
  [[nodiscard]] const OwnDescription& description() const { return description_; }

  /// Notes that the announced state has changed.
  void change() { is_changed_ = true; }
  /// Whether the announced state has changed since the last call.
  [[nodiscard]] bool take_change() { return std::exchange(is_changed_, false); }
  /// All that is announced of our peers.
  [[nodiscard]] std::vector<announcement::PeerState> announced() const;

 private:
  [[nodiscard]] ServiceKey key_of(const Session& session, std::uint32_t number) const;
  [[nodiscard]] Refusal noting(Refusal refusal) {
    is_changed_ |= !refusal;
    return refusal;
  }

  const env::Env& env_;
  const Self& self_;
  matching::Matcher& matcher_;
  Sessions& sessions_;
  Telling& telling_;
  OwnDescription description_;
  bool is_changed_ = false;
};

}  // namespace geminga::participant

#endif
