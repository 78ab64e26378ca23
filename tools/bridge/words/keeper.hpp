// The keeping of a relay's words on a server, for sites that join later.
#ifndef GEMINGA_BRIDGE_WORDS_KEEPER_HPP
#define GEMINGA_BRIDGE_WORDS_KEEPER_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "bridge/team/tally.hpp"
#include "bridge/words/daemon_socket.hpp"
#include "client/channels/reactor.hpp"
#include "discovery/keeping/frame.hpp"

namespace geminga::bridge {

/// The time after which a server forgets a kept word that was not written again. The daemon has each written again in a
/// third of it (relaying::keep_again).
inline constexpr std::chrono::seconds kept_time{60};
/// The time in which a server gives all that it has kept.
inline constexpr std::chrono::seconds reading_time{5};
/// Participants of which words are kept by one bridge: as many as a daemon knows. Words of more are counted.
inline constexpr std::size_t max_kept_participants = 1024;
/// Kept words that wait for the daemon: as many as it takes. More are counted.
inline constexpr std::size_t max_waiting_words = 4096;
/// Kept words that the daemon is given at once, and the pause behind them: a thousand take 60 ms.
inline constexpr int given_at_once = 32;
inline constexpr base::Duration giving_pause = std::chrono::milliseconds(2);
/// All are given a second time so long after the first, for a daemon that was too busy to take some.
inline constexpr base::Duration given_again = std::chrono::milliseconds(800);

/// The place on a server where words stand by participant and index.
class Shelf {
 public:
  using Word = std::span<const std::byte>;
  virtual ~Shelf() = default;
  /// Keeps a word in the place of the one that stands there, for kept_time.
  virtual void put(const std::string& participant, unsigned index, Word word) = 0;
  virtual void remove(const std::string& participant, unsigned index) = 0;
  /// Begins to give all words of other sites to Keeper::take().
  virtual void read() = 0;
};

/// Has the words kept that the daemon hands over, and gives it those of other sites when it begins and when the server
/// is back. Opens none. Neither copies nor moves.
class Keeper {
 public:
  using Word = std::span<const std::byte>;

  /// Borrows all; the shelf is used from begin() on.
  Keeper(client::Reactor& reactor, Tally& tally, Shelf& shelf);
  void set_daemon(DaemonSocket& daemon) { daemon_ = &daemon; }

  /// The server is there, and keeps nothing of ours.
  void begin();
  /// The server is gone, or keeps no words.
  void end();
  /// Takes our words away, since nobody writes them again.
  void leave();

  /// Takes a frame of the daemon.
  void on_frame(Word datagram);
  /// The daemon has begun a session: what the last one has sealed counts nowhere any more.
  void on_daemon_began();
  /// Takes a word that the server has kept. May be called by any thread.
  void take(Word word);

 private:
  void keep(const keeping::Keep& frame);
  void drop(ParticipantId participant);
  void greet();
  void give();
  void live_anew();

  client::Reactor& reactor_;
  Tally& tally_;
  Shelf& shelf_;
  DaemonSocket* daemon_ = nullptr;
  std::random_device chance_;
  std::uint64_t life_ = 0;                  ///< 0: no words are kept
  std::map<ParticipantId, unsigned> kept_;  ///< the words of each
  std::mutex mutex_;
  std::vector<std::vector<std::byte>> frames_;  ///< for the daemon; under the mutex
  std::size_t too_many_ = 0;                    ///< under the mutex
  std::size_t given_ = 0;                       ///< of them
  base::Instant again_at_ = base::never;
  base::Instant gives_until_{};
  client::Reactor::Timer hello_, giving_;
};

}  // namespace geminga::bridge

#endif
