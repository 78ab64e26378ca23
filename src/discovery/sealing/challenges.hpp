// The open questions of freshness: which sessions must still prove that they are no recording, and to which we owe a
// proof.
#ifndef GEMINGA_DISCOVERY_SEALING_CHALLENGES_HPP
#define GEMINGA_DISCOVERY_SEALING_CHALLENGES_HPP

#include <cstddef>
#include <optional>
#include <vector>

#include "base/time.hpp"
#include "discovery/sealing/greeting.hpp"
#include "env/env.hpp"

namespace geminga::sealing {

/// The exchange between participants about freshness, which rides in their announcements (after RFC 8967, section 4.3).
class Challenges {
 public:
  /// Begins our session with this challenge, and calls everybody for calling_time.
  void begin(Session own, Challenge challenge, base::Instant now);
  /// Replaces our challenge: from now on only this one proves anything.
  void renew(Challenge challenge) { own_challenge_ = challenge; }

  /// Takes in the greeting of a sender with our key: we owe what it asks of us. It may be a recording.
  void hear(const Greeting& greeting, Session from, env::InterfaceIndex interface, base::Instant now);
  /// Whether it gives our challenge back, so that it was made after that was drawn.
  [[nodiscard]] bool is_proof(const Greeting& greeting) const;
  /// Takes in that a session without a proof has spoken, so it is asked.
  void ask(Session session, env::InterfaceIndex interface, base::Instant now);
  /// Takes in that it has proved itself.
  void settle(Session session);

  /// Whether a session is asked. While one is, something is to be said soon, and again and again.
  [[nodiscard]] bool asks(base::Instant now);
  /// Whether somebody waits for a proof of ours that no datagram has carried yet.
  [[nodiscard]] bool is_asked(base::Instant now) const;

  /// Whether a session is asked on this interface that was not heard on the other one.
  [[nodiscard]] bool asks_only_on(env::InterfaceIndex interface, env::InterfaceIndex other, base::Instant now);
  /// Forgets what is owed on this interface, since nothing is said there.
  void forget_owed(env::InterfaceIndex interface);

  /// The greeting of the next datagram on this interface, in at most `room` octets; it counts as said. `keys` are named
  /// if there are several.
  [[nodiscard]] Greeting greeting(env::InterfaceIndex interface, const Keyring& keys, std::size_t room,
                                  base::Instant now);

 private:
  struct Asked {
    Session session{};
    env::InterfaceIndex interface{};
    base::Instant heard{};
  };
  struct Owed {
    Session to{};
    env::InterfaceIndex interface{};
    Challenge challenge{};
    base::Instant since{};
    int copies = 0;           ///< still to be said; 0: kept to know that it was said
    bool is_carried = false;  ///< by one datagram at least
  };

  void owe(Session to, env::InterfaceIndex interface, Challenge challenge, bool is_named, base::Instant now);
  void forget_silent(base::Instant now);

  Session own_{};
  Challenge own_challenge_{};
  base::Instant calls_until_ = base::Instant::min();
  std::vector<Asked> asked_;   ///< in the order in which they last spoke
  bool are_too_many_ = false;  ///< more than can be named
  std::vector<Owed> owed_;     ///< in the order in which they last asked
};

}  // namespace geminga::sealing

#endif
