// The datagrams of the local daemon, as they leave for the team beyond a server and come from there.
#ifndef GEMINGA_BRIDGE_WORDS_DAEMON_SOCKET_HPP
#define GEMINGA_BRIDGE_WORDS_DAEMON_SOCKET_HPP

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "bridge/team/tally.hpp"
#include "bridge/words/allowance.hpp"
#include "client/channels/endpoint.hpp"
#include "client/channels/reactor.hpp"
#include "client/channels/socket.hpp"

namespace geminga::bridge {

/// The longest datagram that is carried: what fits into an Ethernet frame. Announcements are shorter
/// (src/discovery/announcement/ANNOUNCEMENT.md).
inline constexpr std::size_t max_word_bytes = 1472;
/// Datagrams a second in each direction: a team of a thousand that starts. More are dropped and counted.
inline constexpr std::uint32_t words_per_second = 4096;

/// A UDP socket that the daemon names as its peer. It speaks with the daemon's port only. Neither copies nor moves.
class DaemonSocket {
 public:
  using Word = std::span<const std::byte>;
  /// Called within Reactor::process().
  struct Told {
    std::function<void(Word)> word;     ///< a datagram of the daemon for others
    std::function<void(Word)> frame{};  ///< one for this bridge: discovery/keeping/frame.hpp
    std::function<void()> began{};      ///< the daemon seals with another session than before
  };

  /// Opens the socket at `own`, towards the daemon at `daemon`. The error is one line. Borrows reactor and tally.
  [[nodiscard]] static std::expected<std::unique_ptr<DaemonSocket>, std::string> open(const client::Endpoint& own,
                                                                                      const client::Endpoint& daemon,
                                                                                      client::Reactor& reactor,
                                                                                      Tally& tally, Told told);
  DaemonSocket(const DaemonSocket&) = delete;
  DaemonSocket& operator=(const DaemonSocket&) = delete;

  /// The fate of a word that came from beyond.
  enum class Given : std::uint8_t { given, too_long, too_many };
  /// Gives a word from beyond to the daemon. May be called by any thread.
  Given give(Word word);
  /// Says a frame to the daemon. May be called by any thread.
  void tell(Word frame);

 private:
  DaemonSocket(client::Socket socket, client::Reactor& reactor, Tally& tally, Told told);
  void read();
  void look_at_session(Word word);

  client::Socket socket_;
  client::Reactor& reactor_;
  Tally& tally_;
  Told told_;
  std::uint64_t session_ = 0;  ///< of the daemon's last sealed datagram
  Allowance out_;
  std::mutex mutex_;
  Allowance in_;  ///< under the mutex
  std::array<std::byte, max_word_bytes + 1> room_{};
  client::Reactor::Watch watch_;
};

}  // namespace geminga::bridge

#endif
