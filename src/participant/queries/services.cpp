// `query services`: every known publication, or those that nobody asks for.
#include "gcnp/event.hpp"
#include "participant/naming.hpp"
#include "participant/queries/lines.hpp"

namespace geminga::participant {
namespace {

Line line_of(const Core& core, const registry::PublicationEntry& entry) {
  Line line;
  append(line, "service", to_string(entry.key));
  append(line, "provider", gcnp::peer_word(entry.key));
  append_known(line, "name", entry.peer_name);
  append_known(line, "participant_name", entry.participant_name);
  gcnp::append_identity(line, named(core.ontology, entry.publication.identity));
  append_channel(line, entry.publication);
  append(line, "age", age(core, entry));
  append_flag(line, "local", entry.is_local);
  append_flag(line, "used", core.matcher.is_used(entry));
  gcnp::append_attributes(line, entry.publication.attributes);
  return line;
}

}  // namespace

Answered answer(Core& core, const gcnp::QueryServices& query) {
  const auto sieve = Sieve::make(core, query.filter);
  if (!sieve) return std::unexpected(sieve.error());
  Answer answer{.kind = "services", .lines = {}, .end = {}};
  core.matcher.for_each_publication([&](const registry::PublicationEntry& entry) {
    ++answer.looked_through;
    if (query.unused && core.matcher.is_used(entry)) return;
    if (!sieve->passes(entry.key, entry.participant_name, entry.peer_name, entry.publication.identity,
                       entry.publication.mode)) {
      return;
    }
    Line line = line_of(core, entry);
    if (sieve->passes(line)) answer.lines.push_back(std::move(line));
  });
  return answer;
}

}  // namespace geminga::participant
