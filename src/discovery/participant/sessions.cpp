#include "discovery/participant/sessions.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "discovery/participant/own_services.hpp"
#include "discovery/participant/telling.hpp"
#include "discovery/participant/turns.hpp"

namespace geminga::participant {
namespace {

void refuse_connection(Core& core, env::StreamId stream, const Error& error) {
  ++core.counters.clients_refused;
  core.env.write(stream, gcnp::to_line(0, error));
  core.env.close(stream);
}

using Sessions = std::map<env::StreamId, std::unique_ptr<Session>>;

/// Ends the connection. What the peer offered and asked for goes at once, or is withdrawn in later turns where it is
/// much. Gives the next session.
Sessions::iterator leave(Core& core, Sessions::iterator one) {
  Session& session = *one->second;
  if (is_small(core, session)) {
    withdraw_all(core, session);
    return core.sessions.erase(one);
  }
  session.is_leaving = true;
  session.is_closing = false;
  session.answering.reset();
  session.held.reset();
  session.to_rename.clear();
  session.pictures.clear();
  return std::next(one);
}

Sessions::iterator close(Core& core, Sessions::iterator one) {
  core.env.write(one->first, one->second->take_outbox());
  core.env.close(one->first);
  return leave(core, one);
}

/// Whom a new client may take the place of: the first of those that never said anything, else the one that has been
/// quiet for longest among those that could come again without anybody noticing.
Sessions::iterator find_silent(Core& core) {
  auto quietest = core.sessions.end();
  for (auto one = core.sessions.begin(); one != core.sessions.end(); ++one) {
    const Session& session = *one->second;
    if (session.is_leaving) continue;
    if (session.statements == 0 && !has_work(core, *one->second)) return one;  // they stand in the order of arrival
    if (session.service_count() > 0 || core.env.now() - session.heard < core.settings.limits.quiet_patience) continue;
    if (quietest == core.sessions.end() || session.heard < quietest->second->heard) quietest = one;
  }
  return quietest;
}

/// The last peer of the user that runs the most, if that is at least two more than `user` does. TCP, which does not
/// tell who connects, counts as one user.
Sessions::iterator find_of_greediest(Core& core, std::string_view user) {
  std::map<std::string_view, std::size_t> peers;
  for (const auto& [stream, session] : core.sessions) {
    if (!session->is_leaving) ++peers[session->user];
  }
  const auto greediest = std::ranges::max_element(peers, {}, [](const auto& entry) { return entry.second; });
  const auto own = peers.find(user);
  const std::size_t least = (own == peers.end() ? 0 : own->second) + 2;
  if (greediest == peers.end() || greediest->second < least) return core.sessions.end();
  auto last = core.sessions.end();
  for (auto one = core.sessions.begin(); one != core.sessions.end(); ++one) {
    const Session& session = *one->second;
    if (session.is_leaving || session.user != greediest->first) continue;
    if (last == core.sessions.end() || last->second->peer() < session.peer()) last = one;
  }
  return last;
}

bool make_place(Core& core, std::string_view user) {
  auto giving_way = find_silent(core);
  std::string why = "closed: this connection is silent, and another one needs its place";
  if (giving_way == core.sessions.end()) {
    giving_way = find_of_greediest(core, user);
    why = "closed: nobody on this host has more clients than its user, and another user needs a place";
  }
  if (giving_way == core.sessions.end()) return false;
  core.refuse(*giving_way->second, 0, {ErrorCode::too_many, why});
  ++core.counters.clients_closed;
  close(core, giving_way);
  return true;
}

/// Whether it lags and has read nothing for too long.
bool is_stuck(Core& core, Session& session) {
  if (!session.lags_since) return false;
  if (!has_picture(session)) {
    session.lags_since.reset();  // what it has missed is about no request that it still has
    return false;
  }
  const std::size_t backlog = core.backlog(session);
  if (backlog < session.lag_backlog) {
    session.lag_backlog = backlog;
    session.lags_since = core.env.now();
  }
  return core.env.now() - *session.lags_since >= core.settings.limits.lag_patience;
}

}  // namespace

void open_session(Core& core, env::StreamId stream, std::string_view user) {
  if (core.phase == Phase::stopping || core.phase == Phase::stopped || core.phase == Phase::failed) {
    return refuse_connection(core, stream, {ErrorCode::not_ready, "not ready: the daemon is stopping"});
  }
  const std::size_t limit = core.settings.limits.peers;
  if (core.peer_count() >= limit && !make_place(core, user)) {
    return refuse_connection(core, stream,
                             {ErrorCode::too_many, "too many clients: the limit is " + std::to_string(limit)});
  }
  ++core.counters.clients;
  auto session = std::make_unique<Session>(stream, PeerId(core.next_peer++), user, core.settings.limits);
  session->heard = core.env.now();
  core.sessions.emplace(stream, std::move(session));
}

void hear_session(Core& core, env::StreamId stream, std::string_view bytes) {
  const auto found = core.sessions.find(stream);
  if (found == core.sessions.end() || found->second->is_leaving || found->second->is_closing) return;
  Session& session = *found->second;
  if (session.first_word.take(bytes) == gcnp::FirstWord::Verdict::foreign) {
    core.refuse(session, 0,
                {ErrorCode::malformed,
                 "octet 1: this port speaks GCNP, whose lines begin with a number: no HTTP, TLS or anything else"});
    session.is_closing = true;
    return;
  }
  session.reader.feed(bytes);
}

void lose_session(Core& core, env::StreamId stream) {
  const auto found = core.sessions.find(stream);
  if (found != core.sessions.end() && !found->second->is_leaving) leave(core, found);
}

void close_due_sessions(Core& core) {
  for (auto next = core.sessions.begin(); next != core.sessions.end();) {
    const auto one = next++;
    Session& session = *one->second;
    if (session.is_leaving) {
      if (session.service_count() == 0) core.sessions.erase(one);
      continue;
    }
    if (is_stuck(core, session)) {
      core.log(base::LogLevel::warning, "peer " + session.name + " does not read what it is told: it is closed");
      core.refuse(session, 0, {ErrorCode::too_many, "closed: nothing that this client is told was read for too long"});
      session.is_closing = true;
    }
    if (!session.is_closing) continue;
    if (!session.says_bye) ++core.counters.clients_closed;
    close(core, one);
  }
}

void write_sessions(Core& core) {
  for (const auto& [stream, session] : core.sessions) {
    if (session->is_leaving) continue;
    if (session->outbox_bytes() > 0) core.env.write(stream, session->take_outbox());
    const bool is_wanted = !has_business(*session);
    if (is_wanted == session->is_wanted) continue;
    session->is_wanted = is_wanted;
    core.env.want(stream, is_wanted);
  }
}

void close_all_sessions(Core& core, const std::optional<Error>& error) {
  for (const auto& [stream, session] : core.sessions) {
    if (session->is_leaving) continue;
    if (error) core.refuse(*session, 0, *error);
    core.env.write(stream, session->take_outbox());
    core.env.close(stream);
  }
  core.sessions.clear();
}

base::Instant session_deadline(const Core& core) {
  base::Instant first = base::never;
  for (const auto& [stream, session] : core.sessions) {
    if (session->lags_since) first = std::min(first, *session->lags_since + core.settings.limits.lag_patience);
  }
  return first;
}

}  // namespace geminga::participant
