// Answers the queries of GCNP from one moment of a recording.
#ifndef GEMINGA_RECORDING_ANSWERING_HPP
#define GEMINGA_RECORDING_ANSWERING_HPP

#include <cstdint>
#include <expected>
#include <vector>

#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/statement.hpp"
#include "recording/state.hpp"

namespace geminga::recording {

/// The lines of the answer, the end line last (src/discovery/participant/QUERIES.md). Errors: 422 for a statement that
/// would change something and for a question that needs an ontology, 404 for a request that is not there at this
/// moment, 503 while the daemon could not be asked, and before its answer was recorded. Requires a query, a `pub` or a
/// `sub`. Linear in the records of its kind.
[[nodiscard]] std::expected<std::vector<gcnp::Statement>, Error> answer(const State& state, std::uint32_t id,
                                                                        const gcnp::Request& request);

/// The answer to `0 sys hello` of a peer.
[[nodiscard]] gcnp::Statement welcome(const State& state, std::uint32_t peer, const std::string& name);

}  // namespace geminga::recording

#endif
