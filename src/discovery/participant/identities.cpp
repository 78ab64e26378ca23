#include "discovery/participant/identities.hpp"

#include "base/text.hpp"
#include "discovery/participant/naming.hpp"

namespace geminga::participant {
namespace {

/// The name of a concept that only an ontology can give an identity, where there is none.
const ConceptNames* needs_ontology(const Core& core, const NamedIdentity& named) {
  return core.vocabulary().is_loaded() ? nullptr : std::get_if<ConceptNames>(&named);
}

std::unexpected<Error> without_ontology(const Core& core, const ConceptNames& names) {
  Error error = no_ontology(core);
  if (error.code == ErrorCode::impossible)
    error.text = "concept=" + base::printable(names.concept_name) + ": " + error.text;
  return std::unexpected(std::move(error));
}

}  // namespace

std::expected<Identity, Error> resolve_offered(Core& core, const NamedIdentity& named) {
  if (const ConceptNames* names = needs_ontology(core, named)) return without_ontology(core, *names);
  return resolve(core.vocabulary(), named);
}

std::expected<Identity, Error> resolve_asked(Core& core, const NamedIdentity& named) {
  if (const ConceptNames* names = needs_ontology(core, named)) return without_ontology(core, *names);
  return resolve(core.expressions, core.vocabulary(), named);
}

bool is_awaited(const Core& core, const std::expected<Identity, Error>& identity) {
  return !core.vocabulary().is_loaded() && !identity && identity.error().code == ErrorCode::not_ready;
}

Error no_ontology(const Core& core) {
  const OntologyState& state = core.ontology_state;
  if (state.is_loading) {
    const auto since = std::chrono::duration_cast<std::chrono::seconds>(core.env.now() - state.begun_at);
    return {ErrorCode::not_ready,
            "not ready: the ontology is being loaded (" + std::to_string(since.count()) + " s): ask again"};
  }
  if (!state.failure.empty()) return {ErrorCode::impossible, "no ontology is loaded: " + state.failure.front()};
  return {ErrorCode::impossible, "no ontology is loaded: start gemingad with --ontology"};
}

}  // namespace geminga::participant
