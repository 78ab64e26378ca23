#include "discovery/participant/clients/greeting.hpp"

#include <cstdint>
#include <string>

#include "discovery/gcnp/version.hpp"
#include "discovery/participant/knowledge/naming.hpp"

namespace geminga::participant {

gcnp::Statement Greeting::answer(Session& session, const gcnp::Hello& hello) {
  gcnp::Statement answer{.id = 0,
                         .command = "msg",
                         .subcommand = "hello",
                         .parameters = {{"version", std::to_string(gcnp::gcnp_version)},
                                        {"participant", to_string(self_.id)},
                                        {"peer", std::to_string(static_cast<std::uint32_t>(session.peer()))},
                                        {"name", session.name},
                                        {"ontology", digest_word(editions_.vocabulary().digest())},
                                        {"participant_name", self_.name()}}};
  if (hello.keys && keys_.ask(session, *hello.keys) && *hello.keys) {
    answer.parameters.push_back({"keys", "yes"});
    answer.parameters.push_back({"sealing", keys_.mode()});
  }
  if (session.services.room > 0) answer.parameters.push_back({"room", std::to_string(session.services.room)});
  return answer;
}

}  // namespace geminga::participant
