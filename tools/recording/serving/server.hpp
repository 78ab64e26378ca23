// Serves a recording to every program that speaks GCNP, as a daemon serves its team.
#ifndef GEMINGA_RECORDING_SERVING_SERVER_HPP
#define GEMINGA_RECORDING_SERVING_SERVER_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "env/asio/streams.hpp"
#include "recording/control.hpp"
#include "recording/player.hpp"
#include "recording/talk.hpp"

namespace geminga::recording {

/// One thread, which run() takes. Neither copies nor moves.
class Server {
 public:
  struct Options {
    std::string where;       ///< ADDRESS:PORT with a numeric address, or the path of a Unix socket
    bool is_paused = false;  ///< stays at the first moment
    bool ends = false;       ///< run() returns at the end of the recording
    /// Told when the recording has come to its end, or cannot be read further (with the reason).
    std::function<void(const std::optional<Finding>&)> ended;
    /// A descriptor with a word for the replay in each line (control.hpp), which stays the caller's; negative: none.
    int words = -1;
    /// Told what became of a word: whether the replay plays, or why the word was not followed.
    std::function<void(bool plays, const std::string& error)> followed{};
  };

  /// Borrows the player for its life.
  Server(Player& player, Options options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Listens. The error is one line that says what to do.
  [[nodiscard]] std::expected<void, std::string> listen();
  /// Plays and serves until SIGINT, SIGTERM or SIGHUP, or the end of the recording where it is told to.
  void run();

 private:
  using Clock = std::chrono::steady_clock;

  struct Client {
    Talk talk;
    std::string unwritten{};  ///< of its answer
  };

  void move();
  void wait_for_next();
  /// Reads the next word of the user.
  void wait_for_word();
  void follow(std::string_view line);
  /// Does what a word says; the error says why it cannot be done.
  std::expected<void, std::string> control(const Control& control);
  void hear(env::StreamId stream, std::string_view octets);
  /// Answers what a client has said, as long as it reads the answers.
  void answer(env::StreamId stream);
  void end();

  Player& player_;
  Options options_;
  boost::asio::io_context context_;
  boost::asio::signal_set signals_{context_};
  boost::asio::steady_timer timer_{context_};
  boost::asio::posix::stream_descriptor words_{context_};
  boost::asio::steady_timer words_timer_{context_};  ///< until a shell gives the terminal back
  std::string said_;                                 ///< of a word
  std::shared_ptr<env::Streams> streams_;
  std::map<env::StreamId, Client> clients_;
  std::uint32_t last_peer_ = 0;
  Clock::time_point begin_;
  bool is_told_ = false;
};

}  // namespace geminga::recording

#endif
