// Hosts that multicast does not reach, and that are tried alone: ANNOUNCEMENT.md, "Who is not heard".
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_DEAF_HOSTS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_DEAF_HOSTS_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "env/env.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// The hosts that are tried at the same time. A further one waits until one of them is reached or given up.
inline constexpr std::size_t max_deaf_hosts = 8;
/// A try: copies of all that is said, for so many intervals or octets, whichever ends first. A host that can be reached
/// proves us within two intervals, and says within one more that it hears us.
inline constexpr int try_intervals = 8;
inline constexpr std::size_t max_try_bytes = std::size_t{16} * 1024;
/// The pause behind a try, doubled after each up to the longest.
inline constexpr int first_pause_intervals = 8;
inline constexpr int longest_pause_intervals = 256;
/// The tries for a host that is not heard at all, after which it has to be introduced again. One that is heard is tried
/// for as long as it is.
inline constexpr std::size_t max_tries_of_unheard = 8;

/// Works only where announcements are sealed: only a seal proves who sent a datagram to us alone.
class DeafHosts {
 public:
  /// A participant's way: our interface, and its address there.
  struct Way {
    ParticipantId participant{};
    env::InterfaceIndex interface{};
    std::string address;
  };

  /// It is heard, and says that it does not hear us. Begins to try it where there is room; a host that is not heard at
  /// all gives way, and among those an introduced one first.
  void hear_deaf(const Way& way, base::Duration interval, base::Instant now);
  /// Its deadline has passed, and it said no goodbye. Begins to try it where there is room; an introduced one gives
  /// way.
  void lose(const Way& way, base::Duration interval, base::Instant now);
  /// Somebody else hears it, and we do not. Begins to try it where there is room.
  void introduce(const Way& way, base::Duration interval, base::Instant now);
  /// It is heard, and nothing says that it does not hear us. A deaf host is *reached* then: it hears our copies, and
  /// goes on getting them.
  void hear(ParticipantId participant);
  /// It said goodbye.
  void forget(ParticipantId participant);
  void forget_all() { hosts_.clear(); }

  /// The addresses that a copy of a datagram of so many octets on this interface goes to. Counts it.
  [[nodiscard]] std::vector<std::string> take(env::InterfaceIndex interface, std::size_t octets, base::Instant now);

  [[nodiscard]] std::size_t size() const { return hosts_.size(); }
  /// Octets of all copies since the start.
  [[nodiscard]] std::uint64_t octets_sent() const { return octets_sent_; }

 private:
  /// Why it is tried: the later ones come first.
  enum class Cause : std::uint8_t { introduced, lost, deaf };
  struct Host {
    Way way;
    Cause cause{};
    bool is_reached = false;
    base::Duration interval{};
    base::Instant begin{};  ///< of the try under way, or of the next one
    base::Instant end{};    ///< of that try
    std::size_t octets = 0;
    std::size_t tries = 1;
    [[nodiscard]] bool is_given_up() const { return cause != Cause::deaf && tries > max_tries_of_unheard; }
  };

  void add(const Way& way, Cause cause, base::Duration interval, base::Instant now);
  /// Ends the try: the next one begins after a pause.
  static void pause(Host& host, base::Instant now);
  [[nodiscard]] Host* find(ParticipantId participant);

  std::vector<Host> hosts_;
  std::uint64_t octets_sent_ = 0;
};

}  // namespace geminga::participant

#endif
