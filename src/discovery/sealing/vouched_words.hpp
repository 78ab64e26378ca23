// The words that a relay hears or is given, each once: SEALING.md, "Relayed words".
#ifndef GEMINGA_DISCOVERY_SEALING_VOUCHED_WORDS_HPP
#define GEMINGA_DISCOVERY_SEALING_VOUCHED_WORDS_HPP

#include <cstddef>
#include <cstdint>

#include "base/time.hpp"
#include "discovery/sealing/envelope.hpp"
#include "discovery/sealing/replay_window.hpp"
#include "discovery/sealing/sessions.hpp"

namespace geminga::sealing {

/// A word is known by its session and counter. Of one session each counter counts once, on whatever way it comes, at
/// most window_counters behind the highest and at most overtaken_time after a higher one. At most max_sessions sessions
/// are remembered; for one more the half that was silent for longest is forgotten. A forgotten session begins anew with
/// the next word that a relay vouches for, so an old copy of it can come only from a holder of the key.
class VouchedWords {
 public:
  /// Takes in a word that somebody vouches for. Whether it is new.
  [[nodiscard]] bool take(Session session, std::uint32_t counter, base::Instant now);
  void clear() { sessions_.clear(); }
  [[nodiscard]] std::size_t size() const { return sessions_.size(); }

 private:
  struct Known {
    ReplayWindow window;
    base::Instant heard{};
  };

  Sessions<Known> sessions_;
};

}  // namespace geminga::sealing

#endif
