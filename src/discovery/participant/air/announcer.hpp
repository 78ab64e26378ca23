// The announcer speaks for a participant: claims its identifier, announces its state when it is due, says goodbye.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_ANNOUNCER_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_ANNOUNCER_HPP

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/claim/identifier_claim.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/schedule/schedule.hpp"
#include "discovery/membership/schedule/search.hpp"
#include "discovery/participant/air/change_log.hpp"
#include "discovery/participant/air/contest.hpp"
#include "discovery/participant/air/counters.hpp"
#include "discovery/participant/air/deaf_hosts.hpp"
#include "discovery/participant/air/dual_stack.hpp"
#include "discovery/participant/air/introductions.hpp"
#include "discovery/participant/air/outlet.hpp"
#include "discovery/participant/air/presence.hpp"
#include "discovery/sealing/seal.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// One announcement that came in. All is borrowed for the call.
struct Heard {
  const announcement::Announcement& announcement;
  membership::Hearing hearing;
  std::span<const std::byte> datagram;
  std::string_view source;
  const env::Interface& on;
};

/// Time between two lines in the log about copies of our disk.
inline constexpr base::Duration copy_report_spacing = std::chrono::minutes(10);

class Announcer {
 public:
  /// The parts that it reads and changes. All are borrowed for its life.
  struct Means {
    env::Env& env;
    const TeamSettings& settings;
    const OwnState& own;
    membership::NeighbourTable& table;
    sealing::Seal& seal;
    DualStack& dual_stack;
    DeafHosts& deaf_hosts;
    Introductions& introductions;
    AirCounters& counters;
    /// The testimony of a relay's presence about others on this interface; empty: it is no relay.
    std::function<std::vector<announcement::Behind>(const env::Interface&)> behind{};
  };
  /// Draws its boot nonce and its seeds from Env.
  explicit Announcer(const Means& means);

  /// Begins to claim an identifier.
  void start();
  /// Ends announcing. Only goodbyes are due then, if there is an identifier to give up.
  void stop();
  /// Whether nothing is left to say after stop().
  [[nodiscard]] bool is_finished() const;

  /// The outcome of a step of the claim.
  enum class Step : std::uint8_t { nothing, claimed, failed };
  /// Sends the claims that are due. Gives `claimed` once for each identifier; id() is that identifier then.
  [[nodiscard]] Step step_claim();
  /// Notes that the state differs from the one that was announced last.
  void changed() { is_changed_ = true; }
  /// Sends the announcements that are due; after stop() the goodbyes.
  void announce();
  /// Sends an inquiry or a diagnosis at once, if we have an identifier. Its number is that of the next datagram, so
  /// that receivers do not count it as lost.
  void exchange(announcement::Kind kind, ParticipantId partner, std::uint64_t token, std::vector<std::string> lines);
  /// The sender of datagrams, which also passes on the words of others.
  [[nodiscard]] Outlet& outlet() { return outlet_; }
  /// Whether an identifier is held, under which words of others can be passed on.
  [[nodiscard]] bool is_held() const { return claim_.is_held() && !is_stopping_; }
  /// Makes our presence due, since something is to be said with it.
  void show();
  /// The deadlines of so many participants have passed that may come back into reach.
  void lost(std::size_t participants) {
    search_.begin(means_.table.neighbours().size() + participants, means_.env.now());
  }
  /// The instant at which step_claim() or announce() has something to do, or base::never.
  [[nodiscard]] base::Instant due() const;

  /// Takes in what was heard: answers newcomers, contests claims of our identifier, contradicts lies about us. Where
  /// our identifier is given up, another one is claimed; step_claim() says when it is held.
  enum class Consequence : std::uint8_t { nothing, failed };
  [[nodiscard]] Consequence heard(const Heard& heard);
  /// Writes into the log that a contest is over; to be called at the end of each event.
  void end_contest();
  /// After `failed`: why no identifier could be claimed, and what to do.
  [[nodiscard]] std::string failure() const;

  [[nodiscard]] ParticipantId id() const { return claim_.id(); }
  [[nodiscard]] const Contest& contest() const { return contest_; }

 private:
  /// Sends on all interfaces that we speak on; returns the most datagrams that one of them took.
  std::size_t send(const announcement::Announcement& announcement);
  /// Drops what the seal owes on IPv6 sides where we do not speak.
  void be_silent_on_ipv6_sides();
  [[nodiscard]] bool is_new_to_others();
  /// Takes the state that is announced at present into the log. Done when it is sent and not with every change.
  void update_log(base::Instant now);
  [[nodiscard]] announcement::Announcement whole_state() const;
  [[nodiscard]] announcement::Announcement change() const;
  [[nodiscard]] bool seems_next_incarnation(const Heard& heard) const;
  [[nodiscard]] bool has_our_lasting_identity(const Heard& heard) const;
  void report_copy(const Heard& heard);
  void heard_presence(const Heard& heard);
  Consequence heard_clash(const Heard& heard);
  void heard_own(const Heard& heard);
  void report(const Heard& heard);
  /// The interval that others are told of.
  [[nodiscard]] base::Duration interval() const;
  [[nodiscard]] announcement::Announcement header(announcement::Kind kind, ParticipantId id) const;
  [[nodiscard]] announcement::Announcement presence();
  [[nodiscard]] announcement::Announcement state() const;

  Means means_;
  announcement::BootNonce boot_;
  membership::IdentifierClaim claim_;
  membership::Schedule schedule_;
  membership::Search search_;
  bool is_changed_ = false;
  ParticipantId testifies_for_{};  ///< the one that we are about to testify for; 0: nobody, or several
  bool is_untold_ = false;         ///< a change is to be said, with the next revision
  std::uint64_t revision_ = 0;
  base::Instant changed_{};     ///< when the revision came
  std::uint8_t doublings_ = 0;  ///< how often the interval is doubled
  ChangeLog log_;
  std::vector<env::Interface> announced_on_;  ///< the interfaces on which the state was last announced
  std::map<env::InterfaceIndex, std::uint64_t> sequences_;
  Outlet outlet_;
  Contest contest_;
  std::string clash_from_;  ///< where the last clash was heard
  std::optional<base::Instant>
      copy_reported_;  ///< the last line in the log about another participant with our lasting identity
  bool is_stopping_ = false;
  ParticipantId farewell_{};  ///< the identifier whose goodbye is said after stop(); 0: nobody knows us
};

}  // namespace geminga::participant

#endif
