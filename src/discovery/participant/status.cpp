#include "discovery/participant/status.hpp"

#include <map>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/gcnp/parameters.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "geminga/match.hpp"

namespace geminga::participant {
namespace {

void append_over_zero(Line& line, std::string_view key, std::uint64_t count) {
  if (count != 0) append(line, key, count);
}

/// The number of peers of each user of the host, e.g. "robot:2,tcp:1".
std::string users(const Sessions& sessions) {
  std::map<std::string, std::size_t> counts;
  for (const Session* session : sessions.peers()) ++counts[session->user.empty() ? "tcp" : session->user];
  std::vector<std::string> words;
  for (const auto& [user, count] : counts) words.push_back(user + ":" + std::to_string(count));
  return base::joined(words, ",");
}

/// Services that requests were given, by degree, and participants that were lost.
void append_matches(Line& line, const ClientCounters& clients, const AirCounters& counters) {
  for (std::size_t i = 0; i < clients.matched.size(); ++i) {
    append_over_zero(line, "matched_" + std::string(to_string(static_cast<Degree>(i))), clients.matched.at(i));
  }
  append_over_zero(line, "participants_lost", counters.lost);
}

void append_counters(Line& line, const ClientCounters& clients, const AirCounters& counters) {
  append(line, "statements", clients.statements);
  append(line, "errors", clients.errors);
  append(line, "events", clients.events);
  append(line, "clients", clients.clients);
  append(line, "clients_refused", clients.clients_refused);
  append(line, "datagrams_sent", counters.datagrams_sent);
  append(line, "bytes_sent", counters.bytes_sent);
  append(line, "datagrams_received", counters.datagrams_received);
  append(line, "bytes_received", counters.bytes_received);
  append(line, "clashes", counters.clashes);
  for (std::size_t i = 0; i < counters.undecodable.size(); ++i) {
    append_over_zero(line,
                     "rejected_" + std::string(announcement::to_string(static_cast<announcement::DecodeError>(i))),
                     counters.undecodable.at(i));
  }
  for (std::size_t i = 0; i < counters.hearings.size(); ++i) {
    append_over_zero(line, "heard_" + std::string(membership::to_string(static_cast<membership::Hearing>(i))),
                     counters.hearings.at(i));
  }
}

void append_ontology(Line& line, const vocabulary::Vocabulary& vocabulary, const OntologyReading& reading,
                     const membership::Neighbours& neighbours) {
  if (reading.is_loading) append_flag(line, "ontology_loading", true);
  if (!reading.failure.empty()) append(line, "ontology_failed", reading.failure.front());
  if (!vocabulary.is_consistent()) append_flag(line, "ontology_contradiction", true);
  if (const auto undecided = vocabulary.undecided()) append(line, "ontology_undecided", *undecided);
  std::size_t others = 0;
  neighbours.for_each(
      [&](const membership::Neighbour& one) { others += one.ontology_digest == vocabulary.digest() ? 0 : 1; });
  append_over_zero(line, "ontology_others", others);
}

/// The mode in which announcements are sealed, and the datagrams that were not heard for it.
void append_sealing(Line& line, const sealing::Seal& seal) {
  append(line, "sealing", std::string(to_string(seal.policy().mode)));
  for (std::size_t i = 0; i < sealing::rejection_count; ++i) {
    const auto rejection = static_cast<sealing::Rejection>(i);
    append_over_zero(line, "sealing_" + std::string(to_string(rejection)), seal.ledger().rejected(rejection));
  }
}

/// Datagrams of others in our name, where there are any.
void append_contest(Line& line, const AirCounters& counters, const Contest& contest, base::Instant now) {
  append_over_zero(line, "redraws", counters.redraws);
  append_over_zero(line, "contested", counters.contested);
  append_over_zero(line, "contradicted", counters.contradicted);
  if (!contest.since()) return;
  append(line, "contested_for", seconds(now - *contest.since()));
  append(line, "contested_from", contest.from());
}

/// The number of participants that say that they do not hear us, though we hear them.
void append_deaf(Line& line, const membership::Neighbours& neighbours) {
  std::size_t deaf = 0;
  neighbours.for_each([&](const membership::Neighbour& one) { deaf += one.is_deaf ? 1 : 0; });
  append_over_zero(line, "unheard_by", deaf);
}

/// The hosts that are tried alone, and the octets that all such copies have taken.
void append_tried(Line& line, const DeafHosts& deaf_hosts) {
  append_over_zero(line, "tried_alone", deaf_hosts.size());
  append_over_zero(line, "bytes_alone", deaf_hosts.octets_sent());
}

/// The words of others that were passed on, and those that were not believed or not passed on.
void append_relayed(Line& line, const Beyond& beyond) {
  if (beyond.is_relay()) append_flag(line, "relay", true);
  append_over_zero(line, "relay_passed", beyond.words());
  append_over_zero(line, "relay_kept", beyond.kept());
  append_over_zero(line, "recalled", beyond.recalled());
  for (const auto& [reason, count] : beyond.refusals()) append_over_zero(line, "relay_" + std::string(reason), count);
}

}  // namespace

Answer answer_status(const Settings& settings, Course course, const Knowledge& knowledge, const Air& air,
                     const Sessions& sessions, base::Instant now) {
  const vocabulary::Vocabulary& vocabulary = knowledge.vocabulary();
  Line line;
  append(line, "version", settings.version);
  append(line, "state", std::string(course.phase));
  append(line, "participant", to_string(knowledge.self.id));
  append(line, "name", knowledge.self.name());
  append(line, "group", settings.group);
  append(line, "uptime", seconds(course.uptime));
  append(line, "interval", seconds(settings.interval));
  append(line, "peers", sessions.peer_count());
  append(line, "participants", air.table().neighbours().size() + 1);
  append(line, "publications", knowledge.matcher.publications().size());
  append(line, "subscriptions", knowledge.matcher.subscriptions().size());
  append(line, "local_publications", sessions.publication_count());
  append(line, "local_subscriptions", sessions.subscription_count());
  append(line, "ontology", digest_word(vocabulary.digest()));
  append_counters(line, sessions.counters, air.counters());
  append_ontology(line, vocabulary, knowledge.reading, air.table().neighbours());
  append_contest(line, air.counters(), air.announcer().contest(), now);
  append_deaf(line, air.table().neighbours());
  append_tried(line, air.deaf_hosts());
  append_sealing(line, air.seal());
  append_relayed(line, air.beyond());
  const Expressions::Counts& expressions = knowledge.expressions.counts();
  append_over_zero(line, "expressions_classified", expressions.classified);
  append_over_zero(line, "expressions_unknown", expressions.unknown);
  append_over_zero(line, "expressions_postponed", expressions.postponed);
  const Overlaps::Counts& overlaps = knowledge.overlaps.counts();
  append_over_zero(line, "overlaps_decided", overlaps.decided);
  append_over_zero(line, "overlaps_undecided", overlaps.undecided);
  append_over_zero(line, "overlaps_postponed", overlaps.postponed);
  append_over_zero(line, "converters_postponed", knowledge.held_converters());
  append_over_zero(line, "refused_services", air.table().refused_services());
  append_matches(line, sessions.counters, air.counters());
  append(line, "clients_closed", sessions.counters.clients_closed);
  append(line, "lags", sessions.counters.lags);
  append_stated(line, "users", users(sessions));
  line.insert(line.end(), course.of_owner.begin(), course.of_owner.end());
  return Answer{.kind = "status", .lines = {std::move(line)}};
}

}  // namespace geminga::participant
