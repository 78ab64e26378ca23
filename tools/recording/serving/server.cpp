#include "recording/serving/server.hpp"

#include <algorithm>
#include <csignal>
#include <utility>

#include "env/asio/endpoint.hpp"

namespace geminga::recording {
namespace {

/// A client's next answer waits while it has more octets than this to read, as with a daemon.
constexpr std::size_t unread_before_more = std::size_t{64} * 1024;

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
  context_.run();
}

void Server::end() {
  timer_.cancel();
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
