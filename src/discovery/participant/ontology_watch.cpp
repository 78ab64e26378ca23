#include "discovery/participant/ontology_watch.hpp"

#include <string>
#include <utility>

#include "base/text.hpp"
#include "discovery/participant/core.hpp"
#include "discovery/participant/naming.hpp"

namespace geminga::participant {
namespace {

std::string name_of(const Core& core, ParticipantId id, std::uint64_t digest) {
  const auto neighbour = core.neighbours.find(id);
  const std::string name = neighbour ? neighbour->name : to_string(id);
  return base::printable(name) + " (" + digest_word(digest) + ")";
}

}  // namespace

void OntologyWatch::look(Core& core) {
  const base::Instant now = core.env.now();
  const bool is_waiting_for_ours = !core.vocabulary().is_loaded() && core.ontology_state.is_loading;
  if (now < next_look_ || is_waiting_for_ours) return;
  next_look_ = now + ontology_look_interval;
  const bool is_known = std::exchange(roster_, core.neighbours.roster()) == roster_ && own_ == core.digest();
  if (is_known) return;
  Others others;
  core.neighbours.for_each([&](const membership::Neighbour& one) {
    if (one.ontology_digest != core.digest()) others.emplace(one.id, one.ontology_digest);
  });
  const bool is_same = others == others_ && (others.empty() || own_ == core.digest());
  const bool is_mended = !is_same && others.empty();
  own_ = core.digest();
  others_ = std::move(others);
  if (is_same) return;
  if (is_mended) {
    core.log(base::LogLevel::info, "ontology: no participant has another one than ours any more");
    return;
  }
  std::string line = "ontology: " + std::to_string(others_.size()) +
                     (others_.size() == 1 ? " participant has" : " participants have") + " another one than ours (" +
                     digest_word(core.digest()) + "): ";
  std::size_t named = 0;
  for (const auto& [id, digest] : others_) {
    if (named == max_named_others) {
      line += ", ...";
      break;
    }
    line += (named++ == 0 ? "" : ", ") + name_of(core, id, digest);
  }
  core.log(base::LogLevel::warning, line + ": geminga-query ontology lists them");
}

}  // namespace geminga::participant
