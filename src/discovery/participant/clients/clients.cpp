#include "discovery/participant/clients/clients.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace geminga::participant {

Clients::Clients(env::Env& env, const ClientLimits& limits, const Knows& knows, Ask ask, KeysOf keys_of,
                 Wording::WayOf way_of)
    : env_(env),
      limits_(limits),
      keys_(std::move(keys_of), sessions_, knows.work),
      wording_(knows.self, knows.matcher.editions(), knows.matcher.choices(), std::move(way_of)),
      telling_(env, limits_, knows.matcher, sessions_, keys_, knows.work, wording_),
      catch_up_(knows.self, knows.matcher, keys_, telling_),
      own_(env, knows.self, knows.matcher, knows.resolver, sessions_, telling_),
      names_(knows.matcher.editions(), knows.resolver),
      reentry_(knows.self, sessions_, telling_, own_, names_, knows.work),
      admission_(limits_, sessions_, own_),
      greeting_(knows.self, knows.matcher.editions(), keys_),
      statements_(greeting_, names_, admission_, own_, keys_, knows.work, std::move(ask)),
      turns_({.env = env,
              .limits = limits_,
              .sessions = sessions_,
              .telling = telling_,
              .catch_up = catch_up_,
              .own = own_,
              .statements = statements_,
              .resolver = knows.resolver,
              .expressions = knows.expressions,
              .overlaps = knows.overlaps,
              .work = knows.work}) {}

void Clients::refuse(env::StreamId stream, const Error& error) {
  ++sessions_.counters.clients_refused;
  env_.write(stream, gcnp::to_line(0, error));
  env_.close(stream);
}

void Clients::open(env::StreamId stream, std::string_view user) {
  if (sessions_.peer_count() >= limits_.peers && !make_place(user)) {
    return refuse(stream, {ErrorCode::too_many, "too many clients: the limit is " + std::to_string(limits_.peers)});
  }
  ++sessions_.counters.clients;
  auto session = std::make_unique<Session>(stream, PeerId(next_peer_++), user, limits_);
  session->heard = env_.now();
  sessions_.all.emplace(stream, std::move(session));
}

void Clients::hear(env::StreamId stream, std::string_view bytes) {
  Session* session = sessions_.find(stream);
  if (session == nullptr || session->is_closing) return;
  if (session->first_word.take(bytes) == gcnp::FirstWord::Verdict::foreign) {
    sessions_.refuse(
        *session, 0,
        {ErrorCode::malformed,
         "octet 1: this port speaks GCNP, whose lines begin with a number: no HTTP, TLS or anything else"});
    session->is_closing = true;
    return;
  }
  session->reader.feed(bytes);
}

void Clients::lose(env::StreamId stream) {
  if (sessions_.find(stream) != nullptr) leave(sessions_.all.find(stream));
}

/// Ends the connection. What the peer offered and asked for goes at once, or is withdrawn in later turns where it is
/// much.
void Clients::leave(At one) {
  Session& session = *one->second;
  if (own_.is_small(session)) {
    own_.withdraw_all(session);
    sessions_.all.erase(one);
    return;
  }
  session.is_leaving = true;
  session.is_closing = false;
  session.answering.reset();
  session.held.reset();
  session.to_rename.clear();
  session.resyncs.clear();
}

void Clients::close(At one) {
  env_.write(one->first, one->second->take_outbox());
  env_.close(one->first);
  leave(one);
}

/// The session whose place a new client may take: the first of those that never said anything, else the one that has
/// been quiet for longest among those that could come again without anybody noticing.
Clients::At Clients::find_silent() {
  auto quietest = sessions_.all.end();
  for (auto one = sessions_.all.begin(); one != sessions_.all.end(); ++one) {
    Session& session = *one->second;
    if (session.is_leaving) continue;
    if (session.statements == 0 && !turns_.has_work(session)) return one;  // they stand in the order of arrival
    if (session.services.count() > 0 || env_.now() - session.heard < limits_.quiet_patience) continue;
    if (quietest == sessions_.all.end() || session.heard < quietest->second->heard) quietest = one;
  }
  return quietest;
}

/// The last peer of the user that runs the most, if that is at least two more than `user` does. TCP, which does not
/// tell who connects, counts as one user.
Clients::At Clients::find_of_greediest(std::string_view user) {
  std::map<std::string_view, std::size_t> peers;
  for (const auto& [stream, session] : sessions_.all) {
    if (!session->is_leaving) ++peers[session->user];
  }
  const auto greediest = std::ranges::max_element(peers, {}, [](const auto& entry) { return entry.second; });
  const auto own = peers.find(user);
  const std::size_t least = (own == peers.end() ? 0 : own->second) + 2;
  if (greediest == peers.end() || greediest->second < least) return sessions_.all.end();
  auto last = sessions_.all.end();
  for (auto one = sessions_.all.begin(); one != sessions_.all.end(); ++one) {
    const Session& session = *one->second;
    if (session.is_leaving || session.user != greediest->first) continue;
    if (last == sessions_.all.end() || last->second->peer() < session.peer()) last = one;
  }
  return last;
}

bool Clients::make_place(std::string_view user) {
  auto giving_way = find_silent();
  std::string why = "closed: this connection is silent, and another one needs its place";
  if (giving_way == sessions_.all.end()) {
    giving_way = find_of_greediest(user);
    why = "closed: nobody on this host has more clients than its user, and another user needs a place";
  }
  if (giving_way == sessions_.all.end()) return false;
  sessions_.refuse(*giving_way->second, 0, {ErrorCode::too_many, why});
  ++sessions_.counters.clients_closed;
  close(giving_way);
  return true;
}

/// Whether it lags and has read nothing for too long.
bool Clients::is_stuck(Session& session) {
  if (!session.lag.is_any()) return false;
  if (!session.is_resyncing()) {
    session.lag.end();  // what it has missed is about no request that it still has
    return false;
  }
  session.lag.note(session.backlog(env_), env_.now());
  return session.lag.deadline(limits_.lag_patience) <= env_.now();
}

void Clients::close_due() {
  for (auto next = sessions_.all.begin(); next != sessions_.all.end();) {
    const auto one = next++;
    Session& session = *one->second;
    if (session.is_leaving) {
      if (session.services.count() == 0) sessions_.all.erase(one);
      continue;
    }
    if (is_stuck(session)) {
      env_.log().write(base::LogLevel::warning, "peer " + session.name + " does not read what it is told: it is closed",
                       {.peer = session.name, .code = "peer_does_not_read"});
      sessions_.refuse(session, 0,
                       {ErrorCode::too_many, "closed: nothing that this client is told was read for too long"});
      session.is_closing = true;
    }
    if (!session.is_closing) continue;
    if (!session.says_bye) ++sessions_.counters.clients_closed;
    close(one);
  }
}

void Clients::write() {
  for (const auto& [stream, session] : sessions_.all) {
    if (session->is_leaving) continue;
    if (session->outbox_bytes() > 0) env_.write(stream, session->take_outbox());
    const bool is_wanted = !Turns::has_business(*session);
    if (is_wanted == session->is_wanted) continue;
    session->is_wanted = is_wanted;
    env_.want(stream, is_wanted);
  }
}

void Clients::close_all(const std::optional<Error>& error) {
  for (const auto& [stream, session] : sessions_.all) {
    if (session->is_leaving) continue;
    if (error) sessions_.refuse(*session, 0, *error);
    env_.write(stream, session->take_outbox());
    env_.close(stream);
  }
  sessions_.all.clear();
}

base::Instant Clients::deadline() const {
  base::Instant first = base::never;
  for (const auto& [stream, session] : sessions_.all) {
    first = std::min(first, session->lag.deadline(limits_.lag_patience));
  }
  return first;
}

void Clients::end_answers() {
  for (const auto& [stream, session] : sessions_.all) {
    if (!session->answering) continue;
    sessions_.refuse(*session, session->answering->id,
                     {ErrorCode::not_ready, "not ready: the ontology was changed meanwhile, ask again"});
    session->answering.reset();
  }
}

}  // namespace geminga::participant
