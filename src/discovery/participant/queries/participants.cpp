// `query participants`: everybody who is known, ourselves among them.
#include <algorithm>

#include "base/text.hpp"
#include "discovery/membership/neighbour/least_loss.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/queries/ways.hpp"

namespace geminga::participant {
namespace {

std::string addresses_of(const membership::Neighbour& neighbour) {
  std::vector<std::string> addresses;
  for (const membership::Path& path : neighbour.paths) {
    for (const std::string& address : path.addresses) {
      if (std::ranges::find(addresses, address) == addresses.end()) addresses.push_back(address);
    }
  }
  return base::joined(addresses, ",");
}

/// Appends what a participant says that it is, in short names.
void append_description(Line& line, const Listed& by, ParticipantId id) {
  const registry::PublicationEntry* entry = by.matcher.publications().find_entry(description_key(id));
  if (entry == nullptr) return;
  const auto& identity = std::get<SemanticIdentity>(entry->publication.identity);
  append(line, "description",
         std::get<ConceptNames>(named(by.matcher.editions().vocabulary(), entry->publication.identity)).concept_name);
  if (!has_expression(identity)) return;
  append_stated(line, "unplaced", base::printable(by.resolver.problem(identity.concept_iri), max_problem_bytes));
}

Line ourselves(const Listed& by, const Self& self, base::Duration interval, const Sessions& sessions,
               const std::string& undescribed) {
  std::vector<std::string> addresses;
  for (const env::Interface& interface : by.env.interfaces()) {
    if (interface.ipv6_side_of) continue;
    addresses.insert(addresses.end(), interface.addresses.begin(), interface.addresses.end());
  }
  Line line;
  append(line, "id", to_string(self.id));
  append(line, "name", self.name());
  append_stated(line, "addresses", base::joined(addresses, ","));
  append(line, "heard", "0.000");
  append(line, "interval", seconds(interval));
  append(line, "loss", "0.000");
  append(line, "loss_least", "0.000");
  append(line, "ontology", digest_word(by.matcher.editions().vocabulary().digest()));
  append(line, "publications", sessions.publication_count());
  append(line, "subscriptions", sessions.subscription_count());
  append_flag(line, "self", true);
  append_description(line, by, self.id);
  append_stated(line, "undescribed", base::printable(undescribed, max_problem_bytes));
  return line;
}

Line line_of(const Listed& by, const membership::Neighbour& neighbour) {
  Line line;
  append(line, "id", to_string(neighbour.id));
  append(line, "name", neighbour.name);
  append_stated(line, "addresses", addresses_of(neighbour));
  append(line, "heard", seconds(by.env.now() - neighbour.heard));
  append(line, "interval", seconds(neighbour.interval));
  append(line, "loss", decimal(neighbour.loss));
  append(line, "loss_least", decimal(membership::least_loss(neighbour)));
  append(line, "ontology", digest_word(neighbour.ontology_digest));
  append(line, "publications", neighbour.publications);
  append(line, "subscriptions", neighbour.subscriptions);
  append_flag(line, "self", false);
  if (neighbour.is_deaf) append_flag(line, "hears_us", false);
  append_stated(line, "observed", observed_address(neighbour.id, by.neighbours));
  append_way(line, neighbour.id, by.neighbours);
  append_description(line, by, neighbour.id);
  return line;
}

}  // namespace

std::optional<Line> participant_line(const Listed& by, const Self& self, base::Duration interval,
                                     const Sessions& sessions, ParticipantId participant) {
  if (participant == self.id) return ourselves(by, self, interval, sessions, {});
  const auto neighbour = by.neighbours.find(participant);
  return neighbour ? std::optional(line_of(by, *neighbour)) : std::nullopt;
}

Answer answer_participants(const Listed& by, const Self& self, base::Duration interval, const Sessions& sessions,
                           const std::string& undescribed) {
  Answer answer{.kind = "participants", .lines = {ourselves(by, self, interval, sessions, undescribed)}, .end = {}};
  by.neighbours.for_each([&](const membership::Neighbour& one) { answer.lines.push_back(line_of(by, one)); });
  // All identifiers have the same number of digits, so that they are in the order of their texts.
  std::ranges::sort(answer.lines, {}, [](const Line& line) { return *line.front().value; });
  return answer;
}

}  // namespace geminga::participant
