// Speaks for a participant on the air: claims its identifier, announces its state when it is due, says goodbye.
#ifndef GEMINGA_PARTICIPANT_ANNOUNCER_HPP
#define GEMINGA_PARTICIPANT_ANNOUNCER_HPP

#include <cstdint>
#include <map>

#include "beacon/announcement.hpp"
#include "beacon/identifier_claim.hpp"
#include "beacon/schedule.hpp"
#include "participant/core.hpp"

namespace geminga::participant {

class Announcer {
 public:
  /// Draws its boot nonce and its seeds from Env. Borrows `core` for its life.
  explicit Announcer(Core& core);

  /// Begins to claim an identifier.
  void start();
  /// From now on only goodbyes are due, if there is an identifier to give up.
  void stop();
  /// Whether nothing is left to say after stop().
  [[nodiscard]] bool is_finished() const;

  /// What a step of the claim came to.
  enum class Step : std::uint8_t { nothing, claimed, failed };
  /// Sends the claims that are due. Says `claimed` once for each identifier, which id() then is.
  [[nodiscard]] Step step_claim();
  /// Announces what has changed or is due; after stop() says goodbye.
  void announce();
  /// When step_claim() or announce() has something to do, or base::never.
  [[nodiscard]] base::Instant due() const;

  /// What was heard of others, so that newcomers are answered and claims contested.
  enum class Consequence : std::uint8_t { nothing, dropped, failed };
  /// `dropped`: the identifier was given up, and another one is being claimed.
  [[nodiscard]] Consequence heard(beacon::Hearing hearing, beacon::Kind kind);

  [[nodiscard]] ParticipantId id() const { return claim_.id(); }
  [[nodiscard]] beacon::BootNonce boot() const { return boot_; }

 private:
  void send(beacon::Announcement announcement);
  [[nodiscard]] beacon::Announcement header(beacon::Kind kind, ParticipantId id) const;
  [[nodiscard]] beacon::Announcement state() const;

  Core& core_;
  beacon::BootNonce boot_;
  beacon::IdentifierClaim claim_;
  beacon::Schedule schedule_;
  std::uint64_t revision_ = 0;
  beacon::Announcement state_;  ///< what is announced at present, without anything of an interface
  std::map<env::InterfaceIndex, std::uint64_t> sequences_;
  bool is_stopping_ = false;
  ParticipantId farewell_{};  ///< whose goodbye is said after stop(); 0: nobody knows us
};

}  // namespace geminga::participant

#endif
