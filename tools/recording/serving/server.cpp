#include "recording/serving/server.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <utility>

#include "env/asio/endpoint.hpp"

namespace geminga::recording {
namespace {

/// A client's next answer waits while it has more octets than this to read, as with a daemon.
constexpr std::size_t unread_before_more = std::size_t{64} * 1024;

/// A longer line of the user is no word.
constexpr std::size_t max_word_octets = 4096;

/// The longest wait for the next entry at once, so that no sum of times can overflow.
constexpr std::chrono::nanoseconds longest_wait = std::chrono::hours(1);

}  // namespace

Server::Server(Player& player, Options options) : player_(player), options_(std::move(options)) {
  env::Streams::Handlers handlers;
  handlers.opened = [this](env::StreamId stream, const std::string&) {
    clients_.emplace(stream, Client{Talk(++last_peer_)});
  };
  handlers.bytes = [this](env::StreamId stream, std::string_view octets) { hear(stream, octets); };
  handlers.drained = [this](env::StreamId stream) { answer(stream); };
  handlers.closed = [this](env::StreamId stream) { clients_.erase(stream); };
  streams_ = std::make_shared<env::Streams>(context_, std::move(handlers));
}

Server::~Server() { streams_->shut_down(); }

std::expected<void, std::string> Server::listen() {
  // A signal waits for run() from here on, since a user who reads where this listens may end it at once.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) signals_.add(signal);
  if (options_.where.starts_with('/')) return streams_->listen(options_.where);
  const auto endpoint = env::parse_endpoint(options_.where);
  if (!endpoint) return std::unexpected(options_.where + " " + endpoint.error() + ": write ADDRESS:PORT or /PATH");
  const auto listening = streams_->listen(*endpoint);
  if (listening) return {};
  return std::unexpected("cannot listen on " + options_.where + ": " + listening.error().text +
                         ": choose another place with --gcnp");
}

void Server::run() {
  signals_.async_wait([this](const boost::system::error_code& error, int) {
    if (!error) end();
  });
  begin_ = Clock::now();
  streams_->serve();
  if (!options_.is_paused) wait_for_next();
  if (const int words = ::fcntl(options_.words, F_DUPFD_CLOEXEC, 0); words >= 0) {
    boost::system::error_code error;
    words_.assign(words, error);  // a file or /dev/null cannot be waited for, and has no words
    if (error) ::close(words);
  }
  if (words_.is_open()) wait_for_word();
  context_.run();
}

void Server::end() {
  timer_.cancel();
  words_timer_.cancel();
  words_.close();
  signals_.cancel();
  streams_->shut_down();
  context_.stop();
}

void Server::move() {
  if (options_.is_paused) return;
  const auto moved = player_.move_to(Clock::now() - begin_);
  if (!player_.is_over() || std::exchange(is_told_, true)) return;
  if (options_.ended) options_.ended(moved ? std::nullopt : std::optional(moved.error()));
  if (options_.ends) end();
}

void Server::wait_for_next() {
  const auto due = player_.next_due();
  if (!due) return move();
  timer_.expires_at(std::min(begin_ + std::chrono::duration_cast<Clock::duration>(*due), Clock::now() + longest_wait));
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (error) return;
    move();
    if (!player_.is_over()) wait_for_next();
  });
}

void Server::wait_for_word() {
  words_.async_wait(boost::asio::posix::stream_descriptor::wait_read, [this](const boost::system::error_code& error) {
    if (error) return;
    // In the background of a shell, reading would stop this process, and the word is for the shell.
    if (::isatty(words_.native_handle()) != 0 && ::tcgetpgrp(words_.native_handle()) != ::getpgrp()) {
      words_timer_.expires_after(std::chrono::seconds(1));
      words_timer_.async_wait([this](const boost::system::error_code& late) {
        if (!late) wait_for_word();
      });
      return;
    }
    std::array<char, 256> piece{};
    const ssize_t size = ::read(words_.native_handle(), piece.data(), piece.size());
    if (size <= 0) return;  // the user has nothing more to say
    said_.append(piece.data(), static_cast<std::size_t>(size));
    for (auto end = said_.find('\n'); end != std::string::npos; end = said_.find('\n')) {
      follow(said_.substr(0, end));
      said_.erase(0, end + 1);
    }
    if (said_.size() > max_word_octets) said_.clear();
    if (words_.is_open()) wait_for_word();
  });
}

void Server::follow(std::string_view line) {
  move();
  const auto read = read_control(line);
  const auto done = read ? control(*read) : std::unexpected(read.error());
  begin_ = Clock::now();
  player_.set_speed(player_.speed());
  timer_.cancel();
  if (!player_.is_over()) is_told_ = false;
  if (options_.followed) options_.followed(!options_.is_paused && !player_.is_over(), done ? "" : done.error());
  if (!options_.is_paused) wait_for_next();
}

std::expected<void, std::string> Server::control(const Control& control) {
  const auto seek = [this](const Moment& moment) -> std::expected<void, std::string> {
    const auto sought = player_.seek(moment);
    if (sought) return {};
    return std::unexpected(sought.error().text);
  };
  if (std::holds_alternative<Toggle>(control)) options_.is_paused = !options_.is_paused;
  if (std::holds_alternative<Pause>(control)) options_.is_paused = true;
  if (std::holds_alternative<Play>(control)) options_.is_paused = false;
  if (const auto* speed = std::get_if<SetSpeed>(&control)) player_.set_speed(speed->speed);
  if (const auto* to = std::get_if<Seek>(&control)) return seek(to->moment);
  if (const auto* skip = std::get_if<Skip>(&control)) return seek(std::max(At{}, player_.now() + skip->time));
  return {};
}

void Server::hear(env::StreamId stream, std::string_view octets) {
  const auto client = clients_.find(stream);
  if (client == clients_.end()) return;
  client->second.talk.hear(octets);
  answer(stream);
}

void Server::answer(env::StreamId stream) {
  const auto found = clients_.find(stream);
  if (found == clients_.end()) return;
  auto& [talk, unwritten] = found->second;
  move();
  bool has_said_all = false;
  while (!has_said_all && streams_->unsent(stream) <= unread_before_more) {
    if (unwritten.empty()) unwritten = talk.next_answer(player_.state());
    has_said_all = unwritten.empty();
    const std::string_view piece = std::string_view(unwritten).substr(0, unread_before_more);
    streams_->write(stream, piece);
    unwritten.erase(0, piece.size());
  }
  // Input that comes meanwhile waits with the system, which holds the client back.
  streams_->want(stream, has_said_all);
  if (talk.is_over() && has_said_all) {
    streams_->close(stream);
    clients_.erase(found);
  }
  streams_->flush();
}

}  // namespace geminga::recording
