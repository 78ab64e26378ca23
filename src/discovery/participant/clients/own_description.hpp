// The description of this participant: a class expression of what it is, with attributes, which is announced as an
// entry of its own.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_OWN_DESCRIPTION_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_OWN_DESCRIPTION_HPP

#include <cstddef>
#include <optional>
#include <string>

#include "discovery/announcement/announcement.hpp"
#include "discovery/gcnp/request.hpp"
#include "discovery/matching/matcher.hpp"
#include "discovery/participant/clients/rate_gate.hpp"
#include "discovery/participant/clients/session.hpp"
#include "discovery/participant/knowledge/resolver.hpp"
#include "discovery/participant/knowledge/self.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Changes by clients in one second. Each is announced several times, and placed by every host of the team.
inline constexpr std::size_t max_descriptions_per_second = 4;

/// Sets the identity that the ontology gives to the names of a description. The error: there is none, or it cannot be
/// announced.
[[nodiscard]] Refusal identify(StatedPublication& stated, Resolver& resolver);

/// Enters the description into the matcher under description_key(), and takes it out again. It belongs to the host and
/// not to the client that stated it, so that it stays when that goes. A description that the ontology in force does not
/// know is kept, and comes into force with one that does.
class OwnDescription {
 public:
  /// Borrows all for its life.
  OwnDescription(const env::Env& env, const Self& self, matching::Matcher& matcher, Resolver& resolver)
      : env_(env), self_(self), matcher_(matcher), resolver_(resolver) {}

  /// Takes what a client states. 404 for attributes where there is no description; 422 and 413 as for a publication,
  /// and 503 while the expression waits for the ontology; 429 over max_descriptions_per_second. A refused change has
  /// changed nothing.
  [[nodiscard]] Refusal change(const gcnp::Describe& change);
  /// Takes what the owner of the participant states; empty: nothing. It takes the place of what clients have stated,
  /// and is kept although the ontology may not know it. Gives whether what is announced has changed.
  bool set(const std::string& concept_name);
  /// Enters it under the identifier that is held now. Gives whether what is announced has changed.
  bool enter();
  /// Resolves its names by the ontology in force; only if it waits for one where not `is_always`. Gives whether what is
  /// announced has changed.
  bool restate(bool is_always);

  /// The peer 0 of what is announced; nothing where nothing is in force.
  [[nodiscard]] std::optional<announcement::PeerState> announced() const;
  /// The places that it takes among the services of the host: 1 or 0.
  [[nodiscard]] std::size_t count() const { return stated_ ? 1 : 0; }
  /// The error for which what was stated is not in force; empty where it is, or there is none.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  [[nodiscard]] Refusal resolve(StatedPublication& stated);
  bool withdraw();

  const env::Env& env_;
  const Self& self_;
  matching::Matcher& matcher_;
  Resolver& resolver_;
  RateGate gate_{max_descriptions_per_second, std::size_t{1} << 30U};
  std::optional<StatedPublication> stated_;
  std::string problem_;
};

}  // namespace geminga::participant

#endif
