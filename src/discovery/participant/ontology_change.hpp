// The change of a participant to another ontology, in turns of bounded work beside those of its clients.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_ONTOLOGY_CHANGE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_ONTOLOGY_CHANGE_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "discovery/participant/work.hpp"
#include "env/env.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

struct Core;

/// Another ontology concerns all that is known of the team: what is offered is looked up in it, then it comes into
/// force, then one subscription after the other is matched anew, and at last the names in what our own peers have said.
/// Each of those is a step, and events, statements and datagrams come between any two (matching/matcher.hpp says what
/// holds meanwhile).
class OntologyChange {
 public:
  /// Another one, or none, is to come into force: behind the change that is under way, and only the one that came last.
  /// Where it is not prepared for class expressions, what asks for one waits for that.
  void begin(Core& core, vocabulary::Vocabulary next);
  /// Reading has failed. Where none is in force and none is to come, what waited for one is told.
  void give_up(Core& core);
  /// The ontology in force is prepared for class expressions: what waits for that comes into force, or gets its 422.
  void take_up_expressions();
  /// Subscriptions whose expressions have no place are to be asked for again.
  void place_again();
  /// Whether proceed() has something to do.
  [[nodiscard]] bool is_under_way() const { return stage_ != Stage::none; }
  /// Takes steps until so much work is done, or nothing is left.
  void proceed(Core& core, Work most);

 private:
  enum class Stage : std::uint8_t {
    none,
    filing,     ///< the matcher files what is offered by the next ontology
    matching,   ///< the next one is in force; the matcher judges by it, or asks for places
    restating,  ///< the names in statements are resolved anew
  };
  struct Next {
    vocabulary::Vocabulary vocabulary;
    std::optional<std::uint64_t> reading;  ///< OntologyState::readings when it came; nothing: it was not read
  };
  struct Statement {
    env::StreamId stream{};
    std::uint32_t number = 0;
  };

  void start(Core& core, Next next);
  void file_or_put_in_force(Core& core);
  void put_in_force(Core& core);
  void match_or_restate(Core& core);
  void restate_or_end(Core& core);
  void list_statements(const Core& core, bool is_of_all);

  Stage stage_ = Stage::none;
  /// OntologyState::readings when the next one came; nothing: it was not read. Meaningful while filing.
  std::optional<std::uint64_t> reading_;
  std::optional<Next> queued_;       ///< comes after the change under way
  bool must_restate_ = false;        ///< all statements, when matching is over
  bool must_take_up_ = false;        ///< the awaited ones, when matching and the others are over
  bool must_place_ = false;          ///< the matcher is to ask for places again, when statements are over
  std::vector<Statement> restated_;  ///< to be resolved anew, the next one last
};

}  // namespace geminga::participant

#endif
