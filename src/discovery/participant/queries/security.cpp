// `query security`: the sealing of ours and of others, the recent datagrams, and what was rejected and why.
#include <algorithm>

#include "base/text.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"

namespace geminga::participant {
namespace {

std::string words_of(const std::vector<sealing::KeyId>& keys) {
  std::vector<std::string> words;
  for (const sealing::KeyId key : keys) words.push_back(sealing::to_string(key));
  return base::joined(words, ",");
}

std::vector<sealing::KeyId> own_keys(const sealing::Seal& seal) {
  std::vector<sealing::KeyId> keys;
  for (const sealing::Key& key : seal.policy().keys.keys()) keys.push_back(key.id());
  return keys;
}

Line our_line(const sealing::Seal& seal) {
  Line line;
  append(line, "mode", std::string(to_string(seal.policy().mode)));
  append_stated(line, "keys", words_of(own_keys(seal)));
  return line;
}

void append_outcome(Line& line, const sealing::Outcome& outcome) {
  append(line, "protection", std::string(to_string(outcome.protection)));
  if (outcome.key) append(line, "key", sealing::to_string(*outcome.key));
  if (outcome.rejection) append(line, "rejected", std::string(to_string(*outcome.rejection)));
}

Line outcome_line(const sealing::Outcome& outcome, std::size_t count) {
  Line line;
  append(line, "datagrams", count);
  append_outcome(line, outcome);
  return line;
}

/// How a participant seals, and which of our keys it does not open with.
Line member_line(const sealing::Seal& seal, const membership::Neighbour& neighbour) {
  Line line;
  append(line, "participant", to_string(neighbour.id));
  append(line, "name", neighbour.name);
  const auto sealing = seal.sealing_of(neighbour.id);
  if (!sealing) {
    append(line, "protection", std::string(to_string(sealing::Protection::plain)));
    return line;
  }
  append(line, "protection", std::string(to_string(sealing->protection)));
  append(line, "key", sealing::to_string(sealing->key));
  append(line, "keys", words_of(sealing->keys));
  std::vector<sealing::KeyId> lacks = own_keys(seal);
  std::erase_if(lacks,
                [&](sealing::KeyId key) { return std::ranges::find(sealing->keys, key) != sealing->keys.end(); });
  append_stated(line, "lacks", words_of(lacks));
  return line;
}

Line source_line(base::Instant now, const sealing::Rejected& rejected) {
  Line line;
  append(line, "source", rejected.source);
  append_outcome(line, rejected.outcome);
  append(line, "count", rejected.count);
  append(line, "age", seconds(now - rejected.last));
  return line;
}

}  // namespace

Answer answer_security(const sealing::Seal& seal, const membership::Neighbours& neighbours, base::Instant now) {
  Answer answer{.kind = "security", .lines = {our_line(seal)}, .end = {}};
  for (const auto& [outcome, count] : seal.ledger().recent()) answer.lines.push_back(outcome_line(outcome, count));
  neighbours.for_each([&](const membership::Neighbour& one) { answer.lines.push_back(member_line(seal, one)); });
  for (const sealing::Rejected& rejected : seal.ledger().sources()) {
    answer.lines.push_back(source_line(now, rejected));
  }
  return answer;
}

}  // namespace geminga::participant
