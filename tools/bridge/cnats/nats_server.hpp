// A server of NATS that carries words, by libnats.
#ifndef GEMINGA_BRIDGE_CNATS_NATS_SERVER_HPP
#define GEMINGA_BRIDGE_CNATS_NATS_SERVER_HPP

#include <nats/nats.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <span>
#include <string>

#include "bridge/team/tally.hpp"
#include "bridge/words/daemon_socket.hpp"
#include "bridge/words/keeper.hpp"
#include "bridge/words/word_options.hpp"
#include "client/channels/reactor.hpp"

namespace geminga::bridge {

/// Octets that the server has not taken yet. A word over it is dropped and counted: the air would have lost it, too.
inline constexpr int max_unsent_octets = 256 * 1024;
/// Words to keep give way to those that are said.
inline constexpr int max_unsent_kept_octets = max_unsent_octets / 2;

/// Says each word on the subject `geminga.TEAM.word.SITE`, and hears those of all other sites. Connects again by
/// itself, each second. Words from there go to the daemon on libnats' threads; everything else happens on that of the
/// reactor. Neither copies nor moves.
///
/// Where the server has JetStream, the bucket `geminga_TEAM` of keys and values keeps words under
/// `SITE.PARTICIPANT.INDEX`. They are written without waiting for the server: what is lost is written again.
class NatsServer : public Shelf {
 public:
  /// By what NATS knows us, beside the name and password of WordSettings; files that only libnats reads. Empty: none.
  struct Credentials {
    std::string file;       ///< a user's credentials: a JWT and an NKey
    std::string nkey;       ///< a public NKey, which is no secret
    std::string nkey_seed;  ///< the file with its seed
    std::string domain;     ///< the domain of JetStream in which words are kept; empty: the server's own
  };
  using Tell = std::function<void(const std::string& line)>;

  /// Borrows reactor, tally and daemon.
  NatsServer(client::Reactor& reactor, WordSettings settings, Credentials credentials, Tally& tally,
             DaemonSocket& daemon, Tell tell);
  ~NatsServer() override;
  NatsServer(const NatsServer&) = delete;
  NatsServer& operator=(const NatsServer&) = delete;

  /// Begins to connect. The error is one line: what libnats cannot use.
  [[nodiscard]] std::expected<void, std::string> start();
  /// Says a word, if the server is there.
  void say(Word word);
  /// Takes what the server keeps of ours away.
  void leave();
  /// Takes the daemon's frames.
  [[nodiscard]] Keeper& keeper() { return keeper_; }

  void put(const std::string& participant, unsigned index, Word word) override;
  void remove(const std::string& participant, unsigned index) override;
  void read() override;

 private:
  [[nodiscard]] natsStatus set_options();
  /// Waits for the server for a second at most.
  [[nodiscard]] natsStatus connect();
  void disconnect();
  [[nodiscard]] bool is_up() const;
  void tell_once(const std::string& line);
  void on_message(const natsMsg* message);
  void on_kept(natsMsg* message);
  void on_second();
  /// Makes the bucket, or finds it. Waits for the server for a second at most.
  [[nodiscard]] natsStatus open_bucket();
  void begin_keeping();
  [[nodiscard]] std::string subject(const std::string& participant, unsigned index) const {
    return written_subject_ + settings_.site + '.' + participant + '.' + std::to_string(index);
  }

  client::Reactor& reactor_;
  WordSettings settings_;
  Credentials credentials_;
  Tally& tally_;
  DaemonSocket& daemon_;
  Tell tell_;
  std::string own_;              ///< the subject of this site
  std::string bucket_;           ///< the name of the bucket
  std::string written_subject_;  ///< the same where they are written, which differs for another domain
  std::string kept_subject_;     ///< the beginning of the subjects of all kept words
  natsOptions* options_ = nullptr;
  natsConnection* connection_ = nullptr;
  natsSubscription* subscription_ = nullptr;
  jsCtx* stream_ = nullptr;
  natsSubscription* reading_ = nullptr;  ///< of the kept words
  std::atomic<bool> is_read_ = false;    ///< all of them have come
  std::string last_line_;
  std::atomic<std::uint32_t> too_long_ = 0;  ///< counted by libnats' threads, told by ours
  std::atomic<std::uint32_t> too_many_ = 0;
  Keeper keeper_;
  client::Reactor::Timer second_;
};

}  // namespace geminga::bridge

#endif
