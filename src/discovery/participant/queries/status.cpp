// `query status`: the daemon itself.
#include <algorithm>
#include <map>

#include "base/text.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/participant/naming.hpp"
#include "discovery/participant/queries/lines.hpp"

namespace geminga::participant {
namespace {

/// How many peers each user of the host runs, e.g. "robot:2,tcp:1".
std::string users(const Core& core) {
  std::map<std::string, std::size_t> counts;
  for (const Session* session : core.peers()) ++counts[session->user.empty() ? "tcp" : session->user];
  std::vector<std::string> words;
  for (const auto& [user, count] : counts) words.push_back(user + ":" + std::to_string(count));
  return base::joined(words, ",");
}

void append_counters(Line& line, const Counters& counters) {
  append(line, "statements", counters.statements);
  append(line, "errors", counters.errors);
  append(line, "events", counters.events);
  append(line, "clients", counters.clients);
  append(line, "clients_refused", counters.clients_refused);
  append(line, "datagrams_sent", counters.datagrams_sent);
  append(line, "bytes_sent", counters.bytes_sent);
  append(line, "datagrams_received", counters.datagrams_received);
  append(line, "bytes_received", counters.bytes_received);
  append(line, "clashes", counters.clashes);
  for (std::size_t i = 0; i < counters.undecodable.size(); ++i) {
    if (counters.undecodable.at(i) == 0) continue;
    append(line, "rejected_" + std::string(announcement::to_string(static_cast<announcement::DecodeError>(i))),
           counters.undecodable.at(i));
  }
  for (std::size_t i = 0; i < counters.hearings.size(); ++i) {
    if (counters.hearings.at(i) == 0) continue;
    append(line, "heard_" + std::string(membership::to_string(static_cast<membership::Hearing>(i))),
           counters.hearings.at(i));
  }
}

void append_ontology_state(Line& line, const Core& core) {
  if (core.ontology_state.is_loading) append_flag(line, "ontology_loading", true);
  if (!core.ontology_state.failure.empty()) append(line, "ontology_failed", core.ontology_state.failure.front());
  if (!core.vocabulary().is_consistent()) append_flag(line, "ontology_contradiction", true);
  if (const auto undecided = core.vocabulary().undecided()) append(line, "ontology_undecided", *undecided);
  std::size_t others = 0;
  core.neighbours.for_each(
      [&](const membership::Neighbour& one) { others += one.ontology_digest == core.digest() ? 0 : 1; });
  if (others != 0) append(line, "ontology_others", others);
}

/// How announcements are sealed, and how many were not heard for it.
void append_sealing(Line& line, const sealing::Seal& seal) {
  append(line, "sealing", std::string(to_string(seal.policy().mode)));
  for (std::size_t i = 0; i < sealing::rejection_count; ++i) {
    const auto rejection = static_cast<sealing::Rejection>(i);
    const std::uint64_t count = seal.ledger().rejected(rejection);
    if (count != 0) append(line, "sealing_" + std::string(to_string(rejection)), count);
  }
}

/// What others do in our name, where they do.
void append_contest(Line& line, const Core& core) {
  if (core.counters.redraws != 0) append(line, "redraws", core.counters.redraws);
  if (core.counters.contested != 0) append(line, "contested", core.counters.contested);
  if (core.counters.contradicted != 0) append(line, "contradicted", core.counters.contradicted);
  if (!core.contest.since()) return;
  append(line, "contested_for", seconds(core.env.now() - *core.contest.since()));
  append(line, "contested_from", core.contest.from());
}

/// How many say that they do not hear us, though we hear them.
void append_deaf(Line& line, const Core& core) {
  std::size_t deaf = 0;
  core.neighbours.for_each([&](const membership::Neighbour& one) { deaf += one.is_deaf ? 1 : 0; });
  if (deaf != 0) append(line, "unheard_by", deaf);
}

}  // namespace

Answered answer(Core& core, const gcnp::QueryStatus&) {
  std::size_t own_publications = 0;
  std::size_t own_subscriptions = 0;
  for (const auto& [stream, session] : core.sessions) {
    own_publications += session->publications.size();
    own_subscriptions += session->subscriptions.size();
  }
  const std::size_t publications = core.matcher.publication_count();
  const std::size_t subscriptions = core.matcher.subscription_count();
  Line line;
  append(line, "version", core.settings.version);
  append(line, "state", std::string(to_string(core.phase)));
  append(line, "participant", to_string(core.id));
  append(line, "name", core.name());
  append(line, "group", core.settings.group);
  append(line, "uptime", seconds(core.env.now() - core.started));
  append(line, "interval", seconds(core.settings.interval));
  append(line, "peers", core.peer_count());
  append(line, "participants", core.neighbours.size() + 1);
  append(line, "publications", publications);
  append(line, "subscriptions", subscriptions);
  append(line, "local_publications", own_publications);
  append(line, "local_subscriptions", own_subscriptions);
  append(line, "ontology", digest_word(core.digest()));
  append_counters(line, core.counters);
  append_ontology_state(line, core);
  append_contest(line, core);
  append_deaf(line, core);
  append_sealing(line, core.seal);
  const Expressions::Counts& expressions = core.expressions.counts();
  if (expressions.classified != 0) append(line, "expressions_classified", expressions.classified);
  if (expressions.unknown != 0) append(line, "expressions_unknown", expressions.unknown);
  if (expressions.postponed != 0) append(line, "expressions_postponed", expressions.postponed);
  const Overlaps::Counts& overlaps = core.overlaps.counts();
  if (overlaps.decided != 0) append(line, "overlaps_decided", overlaps.decided);
  if (overlaps.undecided != 0) append(line, "overlaps_undecided", overlaps.undecided);
  if (overlaps.postponed != 0) append(line, "overlaps_postponed", overlaps.postponed);
  if (core.neighbours.refused_services() != 0) append(line, "refused_services", core.neighbours.refused_services());
  append(line, "clients_closed", core.counters.clients_closed);
  append(line, "lags", core.counters.lags);
  append_stated(line, "users", users(core));
  if (core.status_source) {
    for (gcnp::Parameter& parameter : core.status_source()) line.push_back(std::move(parameter));
  }
  return Answer{.kind = "status", .lines = {std::move(line)}, .end = {}};
}

}  // namespace geminga::participant
