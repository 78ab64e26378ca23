// The statements of clients, each handled as a whole: `sys`, `pub` and `sub` here, `query` by whom it is handed to.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_STATEMENTS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_STATEMENTS_HPP

#include <cstdint>
#include <utility>

#include "discovery/gcnp/request.hpp"
#include "discovery/participant/clients/admission.hpp"
#include "discovery/participant/clients/answering.hpp"
#include "discovery/participant/clients/greeting.hpp"
#include "discovery/participant/clients/key_telling.hpp"
#include "discovery/participant/clients/own_services.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/clients/statement_names.hpp"
#include "discovery/participant/knowledge/resolver.hpp"
#include "discovery/participant/knowledge/work.hpp"

namespace geminga::participant {

class Statements {
 public:
  /// Borrows all but `ask` for its life.
  Statements(Greeting& greeting, StatementNames& names, Admission& admission, OwnServices& own, KeyTelling& keys,
             WorkMeter& work, Ask ask)
      : greeting_(greeting),
        names_(names),
        admission_(admission),
        own_(own),
        keys_(keys),
        work_(work),
        ask_(std::move(ask)) {}

  /// Requires that an identifier is held. A refused request has changed nothing.
  [[nodiscard]] Refusal handle(Session& session, std::uint32_t id, const gcnp::Request& request);

 private:
  [[nodiscard]] Refusal on(Session& session, std::uint32_t id, const gcnp::Hello& hello);
  [[nodiscard]] Refusal on(Session& session, std::uint32_t id, const gcnp::Describe& describe);
  [[nodiscard]] Refusal on(Session& session, std::uint32_t id, const gcnp::PubCreate& create);
  [[nodiscard]] Refusal on(Session& session, std::uint32_t id, const gcnp::PubModify& modify);
  [[nodiscard]] Refusal on(Session& session, std::uint32_t id, const gcnp::PubRemove& remove);
  [[nodiscard]] Refusal on(Session& session, std::uint32_t id, const gcnp::SubCreate& create);
  [[nodiscard]] Refusal on(Session& session, std::uint32_t id, const gcnp::SubModify& modify);
  [[nodiscard]] Refusal on(Session& session, std::uint32_t id, const gcnp::SubRemove& remove);

  Greeting& greeting_;
  StatementNames& names_;
  Admission& admission_;
  OwnServices& own_;
  KeyTelling& keys_;
  WorkMeter& work_;
  Ask ask_;
};

}  // namespace geminga::participant

#endif
