// The answers to `query`, one kind a file; src/discovery/participant/QUERIES.md specifies them.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_QUERIES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_QUERIES_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/statement.hpp"
#include "discovery/participant/core.hpp"
#include "discovery/participant/queries/answering.hpp"
#include "geminga/error.hpp"

namespace geminga::participant {

/// `N msg KIND ...` for each line, and what `N msg end count=K` says beside the count.
struct Answer {
  std::string kind;
  std::vector<Line> lines;
  Line end;
  /// Entries that were looked through for it: what the query cost, found or not.
  std::size_t looked_through = 0;
};
using Answered = std::expected<Answer, Error>;

// None of these changes anything. Cost: linear in what they look through, which is little.
[[nodiscard]] Answered answer(Core& core, const gcnp::QueryParticipants& query);
[[nodiscard]] Answered answer(Core& core, const gcnp::QueryExplain& query);
[[nodiscard]] Answered answer(Core& core, const gcnp::QueryOntology& query);
[[nodiscard]] Answered answer(Core& core, const gcnp::QueryStatus& query);
[[nodiscard]] Answered answer(Core& core, const gcnp::QueryInterfaces& query);
[[nodiscard]] Answered answer(Core& core, const gcnp::QueryPeers& query);
[[nodiscard]] Answered answer(Core& core, const gcnp::QuerySecurity& query);

// Those that go through the registry do so piece by piece.
[[nodiscard]] std::expected<Answering, Error> begin(Core& core, const gcnp::QueryServices& query);
[[nodiscard]] std::expected<Answering, Error> begin(Core& core, const gcnp::QueryRequests& query);
[[nodiscard]] std::expected<Answering, Error> begin(Core& core, const gcnp::QueryMatch& query);
[[nodiscard]] std::expected<Answering, Error> begin(Core& core, const gcnp::QueryWhy& query);
/// An answer that is ready, to be told piece by piece.
[[nodiscard]] Answering telling(Answer answer);

/// Begins to tell an answer to the peer: the first piece at once, the others by proceed_answer(). An error is the
/// caller's to write.
[[nodiscard]] std::optional<Error> reply(Core& core, Session& session, std::uint32_t id,
                                         std::expected<Answering, Error> answering);
/// Tells the next piece of the answer under way, which there must be.
void proceed_answer(Core& core, Session& session);

}  // namespace geminga::participant

#endif
