// `query match`: the publications that meet an identity, best first.
#include <algorithm>
#include <array>
#include <tuple>

#include "gcnp/event.hpp"
#include "participant/naming.hpp"
#include "participant/queries/lines.hpp"

namespace geminga::participant {
namespace {

constexpr std::array all_modes{ChannelMode::one_to_one, ChannelMode::one_to_many_stream,
                               ChannelMode::one_to_many_pubsub};

/// The order of arbitration (matching/matcher.hpp), without an incumbent.
bool is_better(const matching::Ranked& a, const matching::Ranked& b) {
  const auto rank = [](const matching::Ranked& one) {
    return std::tuple(-std::int64_t{one.publication->publication.priority}, one.match, one.publication->key);
  };
  return rank(a) < rank(b);
}

Line line_of(const Core& core, const matching::Ranked& ranked) {
  const registry::PublicationEntry& entry = *ranked.publication;
  Line line;
  append(line, "service", to_string(entry.key));
  append(line, "provider", gcnp::peer_word(entry.key));
  append_known(line, "name", entry.peer_name);
  gcnp::append_identity(line, named(core.ontology, entry.publication.identity));
  append(line, "degree", std::string(to_string(ranked.match.degree)));
  append(line, "distance", ranked.match.distance);
  append_channel(line, entry.publication);
  append(line, "age", age(core, entry));
  append_known(line, "participant_name", entry.participant_name);
  gcnp::append_attributes(line, entry.publication.attributes);
  return line;
}

/// Every publication that the rest of the request lets through: each is asked for by its own identity.
std::vector<matching::Ranked> match_any(const Core& core, const gcnp::QueryMatch& query, Subscription request) {
  std::vector<matching::Ranked> found;
  core.matcher.for_each_publication([&](const registry::PublicationEntry& entry) {
    if (query.mode && *query.mode != entry.publication.mode) return;
    request.mode = entry.publication.mode;
    request.identity = entry.publication.identity;
    registry::SubscriptionEntry asking;
    asking.subscription = request;
    if (const auto match = core.matcher.why(asking, entry)) found.push_back({.publication = &entry, .match = *match});
  });
  return found;
}

std::size_t publication_count(const Core& core) {
  std::size_t count = 0;
  core.matcher.for_each_publication([&](const auto&) { ++count; });
  return count;
}

}  // namespace

Answered answer(Core& core, const gcnp::QueryMatch& query) {
  if (!query.where.empty()) {
    if (auto error = matching::check_where(query.where)) return std::unexpected(std::move(*error));
  }
  Subscription request;
  request.weakest = query.weakest;
  request.providers = query.providers;
  request.where = query.where;
  std::vector<matching::Ranked> found;
  if (query.identity) {
    auto identity = resolve(core.expressions, core.ontology, *query.identity);
    if (!identity) return std::unexpected(identity.error());
    request.identity = std::move(*identity);
    for (const ChannelMode mode : all_modes) {
      if (query.mode && *query.mode != mode) continue;
      request.mode = mode;
      const auto ranked = core.matcher.match(request);
      found.insert(found.end(), ranked.begin(), ranked.end());
    }
  } else {
    found = match_any(core, query, request);
  }
  const std::size_t looked_through = query.identity ? found.size() : publication_count(core);
  std::ranges::sort(found, is_better);
  if (query.limit != 0 && found.size() > query.limit) found.resize(query.limit);
  Answer answer{.kind = "match", .lines = {}, .end = {}, .looked_through = looked_through};
  for (const matching::Ranked& one : found) answer.lines.push_back(line_of(core, one));
  return answer;
}

}  // namespace geminga::participant
