// The air: datagrams out and in, and the other participants that are heard.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_AIR_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_AIR_HPP

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "discovery/membership/neighbour_table.hpp"
#include "discovery/participant/air/announcer.hpp"
#include "discovery/participant/air/beyond.hpp"
#include "discovery/participant/air/counters.hpp"
#include "discovery/participant/air/deaf_hosts.hpp"
#include "discovery/participant/air/diagnoses.hpp"
#include "discovery/participant/air/dual_stack.hpp"
#include "discovery/participant/air/introductions.hpp"
#include "discovery/participant/air/one_way.hpp"
#include "discovery/participant/air/presence.hpp"
#include "discovery/sealing/seal.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Owns the table of neighbours, the seal, the dual stack and the announcer. It knows neither clients nor the registry:
/// what is announced comes from OwnState, and what is heard is given by take_changes().
class Air {
 public:
  /// Borrows `env` and `settings` for its life.
  Air(env::Env& env, const TeamSettings& settings, OwnState own);
  Air(const Air&) = delete;
  Air& operator=(const Air&) = delete;

  /// Begins to claim an identifier.
  void start();
  void adopt(const sealing::Policy& policy);
  /// Takes in one datagram, whatever is in it. `served` is the identifier that our services have at present; it differs
  /// from the announcer's while another one is claimed. The result says what follows for our own identifier;
  /// nothing where the datagram was not heard.
  [[nodiscard]] std::optional<Announcer::Consequence> hear(env::InterfaceIndex interface, std::string_view source,
                                                           std::span<const std::byte> datagram, ParticipantId served);
  /// Gives up each neighbour that was not heard before its deadline.
  void expire();
  /// Gives up the participants that were heard last, and takes in no further ones for a while
  /// (NeighbourTable::shed()).
  void shed();
  void forget_interface(env::InterfaceIndex interface) { table_.forget_interface(interface); }
  /// Judges anew which participants can be reached: Env::route() may answer otherwise than before.
  void judge_reach() { table_.judge_reach(); }
  /// The changes of neighbours since the last call, in the order in which the registry must make them.
  [[nodiscard]] std::vector<membership::Change> take_changes();
  /// Whether all that we say is said on this interface, too.
  [[nodiscard]] bool speaks_on(const env::Interface& interface) {
    return dual_stack_.speaks_on(interface, seal_, env_.now());
  }

  /// The answer of another participant to an inquiry, which is said where there is none; null until it comes.
  [[nodiscard]] const Diagnoses::Diagnosis* diagnosis_of(ParticipantId participant);

  [[nodiscard]] Announcer& announcer() { return announcer_; }
  [[nodiscard]] const Announcer& announcer() const { return announcer_; }
  [[nodiscard]] const membership::NeighbourTable& table() const { return table_; }
  [[nodiscard]] const sealing::Seal& seal() const { return seal_; }
  [[nodiscard]] const AirCounters& counters() const { return counters_; }
  [[nodiscard]] const DeafHosts& deaf_hosts() const { return deaf_hosts_; }
  [[nodiscard]] Beyond& beyond() { return beyond_; }
  [[nodiscard]] const Beyond& beyond() const { return beyond_; }

 private:
  /// Takes in a word that a relay has wrapped.
  [[nodiscard]] std::optional<Announcer::Consequence> take_in_relayed(const announcement::Announcement& heard,
                                                                      const env::Interface& on, bool is_sealed,
                                                                      ParticipantId served);
  /// Takes in the kept words for which a presence testifies. False: no identifier can be held.
  [[nodiscard]] bool recall(const announcement::Announcement& presence, sealing::Session session,
                            membership::Hearing hearing, const env::Interface& on, ParticipantId served);
  [[nodiscard]] std::optional<Announcer::Consequence> take_in(env::InterfaceIndex interface, std::string_view source,
                                                              std::span<const std::byte> datagram,
                                                              ParticipantId served);
  /// An announcement that came in a datagram of its own. Borrows all of it for the call.
  struct Received {
    const announcement::Announcement& announcement;
    const sealing::Opened& opened;
    std::span<const std::byte> datagram;
    const sealing::Arrival& arrival;
    const env::Interface& on;
  };
  [[nodiscard]] std::optional<Announcer::Consequence> take_in_direct(const Received& received, ParticipantId served);
  /// Opens a datagram; nothing: it is rejected, and counted.
  [[nodiscard]] std::optional<sealing::Opened> open(std::span<const std::byte> datagram,
                                                    const sealing::Arrival& arrival);
  /// Decodes it, borrowed until the next call; null: it cannot be read, or is not in the name of its sender.
  [[nodiscard]] const announcement::Announcement* decode(const sealing::Opened& opened,
                                                         const sealing::Arrival& arrival);
  /// Takes in an inquiry or a diagnosis.
  void hear_exchange(const announcement::Announcement& heard, bool is_sealed);
  /// Whether announcements are sealed, and only sealed ones are heard.
  [[nodiscard]] bool is_sealed() const { return seal_.policy().mode >= sealing::Mode::authenticated; }
  /// Begins or ends to try the sender alone, by what it says of us.
  void reach(const announcement::Announcement& heard, const env::Interface& on, std::string_view source);
  /// Tries those alone that its sender hears and we do not.
  void meet(const announcement::Announcement& heard, const env::Interface& on);
  /// Tries those alone whose deadlines have passed.
  void reach_lost(base::Instant now);
  void speak_to(const announcement::Announcement& heard, const env::Interface& on, membership::Hearing hearing,
                bool is_sealed);

  env::Env& env_;
  const TeamSettings& settings_;
  OwnState own_;
  AirCounters counters_;
  membership::NeighbourTable table_;
  sealing::Seal seal_;  ///< all that goes out or comes in passes it
  DualStack dual_stack_;
  OneWay one_way_;
  DeafHosts deaf_hosts_;
  Introductions introductions_;
  Diagnoses diagnoses_;
  announcement::Reader own_reader_;
  announcement::Reader& reader_;  ///< the shared one, or our own
  Announcer announcer_;
  Beyond beyond_;
};

}  // namespace geminga::participant

#endif
