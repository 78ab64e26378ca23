#include "discovery/participant/ontology_watch.hpp"

#include <string>
#include <utility>

#include "base/text.hpp"
#include "discovery/participant/knowledge/naming.hpp"

namespace geminga::participant {
namespace {

std::string name_of(const membership::Neighbours& neighbours, ParticipantId id, std::uint64_t digest) {
  const auto neighbour = neighbours.find(id);
  const std::string name = neighbour ? neighbour->name : to_string(id);
  return base::printable(name) + " (" + digest_word(digest) + ")";
}

}  // namespace

void OntologyWatch::look(const membership::Neighbours& neighbours, std::uint64_t own_digest, env::Env& env) {
  const base::Instant now = env.now();
  if (now < next_look_) return;
  next_look_ = now + ontology_look_interval;
  const bool is_known = std::exchange(roster_, neighbours.roster()) == roster_ && own_ == own_digest;
  if (is_known) return;
  Others others;
  neighbours.for_each([&](const membership::Neighbour& one) {
    if (one.ontology_digest != own_digest) others.emplace(one.id, one.ontology_digest);
  });
  const bool is_same = others == others_ && (others.empty() || own_ == own_digest);
  const bool is_mended = !is_same && others.empty();
  own_ = own_digest;
  others_ = std::move(others);
  if (is_same) return;
  if (is_mended) {
    env.log().write(base::LogLevel::info, "ontology: no participant has another one than ours any more",
                    {.code = "ontology_same"});
    return;
  }
  std::string line = "ontology: " + std::to_string(others_.size()) +
                     (others_.size() == 1 ? " participant has" : " participants have") + " another one than ours (" +
                     digest_word(own_digest) + "): ";
  std::size_t named = 0;
  for (const auto& [id, digest] : others_) {
    if (named == max_named_others) {
      line += ", ...";
      break;
    }
    line += (named++ == 0 ? "" : ", ") + name_of(neighbours, id, digest);
  }
  env.log().write(base::LogLevel::warning, line + ": geminga-query ontology lists them", {.code = "ontology_differs"});
}

}  // namespace geminga::participant
