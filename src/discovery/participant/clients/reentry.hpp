// Services of our peers that are entered again, one in a step: under another identifier, or by another ontology.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_REENTRY_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_REENTRY_HPP

#include <cstdint>
#include <vector>

#include "discovery/participant/clients/own_services.hpp"
#include "discovery/participant/clients/sessions.hpp"
#include "discovery/participant/clients/statement_names.hpp"
#include "discovery/participant/clients/telling.hpp"
#include "discovery/participant/knowledge/self.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Keeps the lists of what is still to be entered. A statement whose peer has gone meanwhile is passed over.
class Reentry {
 public:
  /// Borrows all for its life.
  Reentry(const Self& self, Sessions& sessions, Telling& telling, OwnServices& own, StatementNames& names,
          WorkMeter& work)
      : self_(self), sessions_(sessions), telling_(telling), own_(own), names_(names), work_(work) {}

  /// Has all that our peers have stated return under the identifier that is held now, request by request.
  void list_returning();
  [[nodiscard]] bool has_returning() const { return !returning_.empty(); }
  /// Enters one request again: its peer is told that all it was told of for this request is gone, and then what there
  /// is. False: none was left.
  bool return_next();

  /// Lists the statements whose names are to be resolved by the ontology in force: all, or those that wait for one.
  void list_for_restating(bool is_of_all);
  /// Resolves the names of one listed statement. What the ontology does not know is withdrawn and told to its peer;
  /// what an earlier one did not know comes back. False: none was left.
  bool restate_next();

 private:
  struct Statement {
    env::StreamId stream{};
    std::uint32_t number = 0;
  };
  /// Turned round at the end, so that the next one is the last one.
  using List = std::vector<Statement>;

  struct Found {
    Session* session = nullptr;  ///< null: its peer has gone
    std::uint32_t number = 0;
  };

  /// Takes the next one off the list, which is not empty.
  [[nodiscard]] Found take(List& list);
  template <typename Stated>
  [[nodiscard]] bool resolve_again(Session& session, std::uint32_t number, Stated& stated);

  const Self& self_;
  Sessions& sessions_;
  Telling& telling_;
  OwnServices& own_;
  StatementNames& names_;
  WorkMeter& work_;
  List returning_;
  List restated_;
};

}  // namespace geminga::participant

#endif
