// `query hearing`: what each other participant says of whom it hears.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/queries/ways.hpp"

namespace geminga::participant {
namespace {

using announcement::HeardWithin;

/// Identifiers that are listed cost so much less than an entry of the registry.
constexpr std::size_t names_per_entry = 32;

constexpr std::array<std::pair<HeardWithin, std::string_view>, 4> heard_words{{{HeardWithin::quarter, "quarter"},
                                                                               {HeardWithin::half, "half"},
                                                                               {HeardWithin::interval, "whole"},
                                                                               {HeardWithin::longer, "longer"}}};

struct Witness {
  ParticipantId id{};
  std::string name;
};

Line line_of(const Witness& witness, const std::optional<membership::NamedTestimony>& testimony, base::Instant now) {
  Line line;
  append(line, "witness", to_string(witness.id));
  append(line, "name", witness.name);
  if (!testimony) return line;
  append(line, "age", seconds(now - testimony->said));
  for (const auto& [within, word] : heard_words) {
    std::vector<std::string> ids;
    for (const auto& [id, heard] : testimony->heard) {
      if (heard == within) ids.push_back(to_string(id));
    }
    append_stated(line, word, base::joined(ids, ","));
  }
  return line;
}

}  // namespace

Answering begin_hearing(const env::Env& env, const membership::NeighbourTable& table) {
  std::vector<Witness> witnesses;
  table.neighbours().for_each([&](const membership::Neighbour& one) { witnesses.push_back({one.id, one.name}); });
  std::ranges::sort(witnesses, {}, &Witness::id);
  Answering answering{.kind = "hearing", .proceed = {}};
  answering.proceed = [&env, &table, witnesses = std::move(witnesses), next = std::size_t{0}](Piece& piece) mutable {
    for (; next < witnesses.size(); ++next) {
      if (piece.is_full()) return false;
      piece.look_at(1 + witnesses.size() / names_per_entry);
      Line line = line_of(witnesses[next], table.witnesses().last_word(witnesses[next].id), env.now());
      append_way(line, witnesses[next].id, table.neighbours());
      piece.tell(std::move(line));
    }
    return true;
  };
  return answering;
}

}  // namespace geminga::participant
