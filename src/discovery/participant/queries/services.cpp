// `query services`: every known publication, or those that nobody asks for.
#include <optional>
#include <utility>

#include "discovery/gcnp/event.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/queries/reasons.hpp"
#include "discovery/participant/queries/use.hpp"

namespace geminga::participant {
namespace {

/// `reason` says why nobody asks for it, where that was asked for.
Line line_of(const Listed& by, const registry::PublicationEntry& entry, bool is_used, const Reason* reason) {
  Line line;
  append(line, "service", to_string(entry.key));
  append(line, "provider", peer_word(entry.key));
  append_stated(line, "name", entry.peer_name);
  append_stated(line, "participant_name", entry.participant_name);
  gcnp::append_identity(line, named(by.matcher.vocabulary(), entry.publication.identity));
  append_channel(line, entry.publication);
  append(line, "age", age(by.neighbours, by.env.now(), entry));
  append_flag(line, "local", entry.is_local);
  append_flag(line, "used", is_used);
  append_stated(line, "scope", entry.publication.scope);
  append_stated(line, "for", entry.publication.for_whom);
  if (reason != nullptr) append_because(line, *reason);
  gcnp::append_attributes(line, entry.publication.attributes);
  return line;
}

}  // namespace

std::expected<Answering, Error> begin_list(const Listed& by, const gcnp::QueryServices& query) {
  auto sieve = Sieve::make(by.resolver, query.filter);
  if (!sieve) return std::unexpected(sieve.error());
  return Answering{
      .kind = "services",
      .proceed = [sieve = std::move(*sieve), is_unused_only = query.unused, last = std::optional<ServiceKey>(),
                  reasons = Reasons(by.matcher, by.neighbours), use = Use(), by](Piece& piece) mutable {
        return by.matcher.walk_publications(last, [&](const registry::PublicationEntry& entry) {
          last = entry.key;
          piece.look_at_one();
          const bool passes = sieve.passes(by.matcher.vocabulary(), entry.key, entry.participant_name, entry.peer_name,
                                           entry.publication.identity, entry.publication.mode);
          const bool is_used = passes && use.is_of(by.matcher, entry);
          const bool is_told = passes && !(is_unused_only && is_used);
          Line line = is_told ? line_of(by, entry, is_used, nullptr) : Line{};
          if (is_told && sieve.passes(line)) {
            if (is_unused_only) {
              const Reason reason = reasons.likely(piece, entry);
              line = line_of(by, entry, is_used, &reason);
            }
            piece.tell(std::move(line));
          }
          return !piece.is_full();
        });
      }};
}

}  // namespace geminga::participant
