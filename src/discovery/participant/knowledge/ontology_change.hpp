// The change of a participant to another ontology, in steps of bounded work beside the turns of its clients.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_ONTOLOGY_CHANGE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_ONTOLOGY_CHANGE_HPP

#include <cstdint>
#include <optional>

#include "base/log.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/matching/vocabulary_change.hpp"
#include "discovery/participant/knowledge/ontology_reading.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

/// Lines about files that are not in an ontology, and the time when they were read.
struct LeftOut {
  std::vector<std::string> lines;
  base::Instant at{};
};

/// Another ontology concerns all that is known of the team. First the matcher files what is offered by it. Then it
/// comes into force, and the matcher judges one subscription after the other by it. At last the names in what our own
/// peers have stated are resolved anew. Events, statements and datagrams may come between any two steps
/// (matching/vocabulary_change.hpp says what holds meanwhile).
class OntologyChange {
 public:
  /// Borrows all four for its life. `filing` files and judges what is known of the team.
  OntologyChange(const matching::Editions& editions, matching::VocabularyChange& filing, OntologyReading& reading,
                 base::LogSink& log)
      : editions_(editions), filing_(filing), reading_(reading), log_(log) {}

  /// Another ontology, or none, is to come into force. It waits for the change under way; of several that wait only the
  /// last one comes. Where it is not prepared for class expressions, requests for these wait until it is.
  void begin(vocabulary::Vocabulary next, LeftOut left_out = {});
  /// Reading has failed. Where no ontology is in force and none is to come, what waited for one is told so.
  void give_up();
  /// The ontology in force is prepared for class expressions: what waits for that comes into force, or gets its 422.
  void take_up_expressions();
  /// Subscriptions whose expressions have no place are to be asked for again.
  void place_again();
  /// Whether step() has something to do.
  [[nodiscard]] bool is_under_way() const { return stage_ != Stage::none; }

  /// Work of a step that is left to the owner of our peers' statements.
  enum class Due : std::uint8_t {
    nothing,
    came_into_force,  ///< answers under way are about the former ontology, and the digest is another one
    list_all,         ///< all statements are to be listed for restating
    list_awaited,     ///< only those that wait for the ontology
    restate_next,     ///< one listed statement is to be resolved anew; end_restating() where none is left
  };
  [[nodiscard]] Due step();
  void end_restating() { stage_ = Stage::matching; }

 private:
  enum class Stage : std::uint8_t {
    none,
    filing,     ///< the matcher files what is offered by the next ontology
    matching,   ///< the next one is in force; the matcher judges by it, or asks for places
    restating,  ///< the names in statements are resolved anew
  };
  struct Next {
    vocabulary::Vocabulary vocabulary;
    std::optional<std::uint64_t> reading;  ///< OntologyReading::begun when it came; nothing: it was not read
    LeftOut left_out;
  };

  void start(Next next);
  void put_in_force();
  [[nodiscard]] Due match_or_restate();

  const matching::Editions& editions_;
  matching::VocabularyChange& filing_;
  OntologyReading& reading_;
  base::LogSink& log_;
  Stage stage_ = Stage::none;
  std::optional<std::uint64_t> from_reading_;  ///< Next::reading of the one that is filed; meaningful while filing
  LeftOut left_out_;                           ///< of the one that is filed
  std::optional<Next> queued_;                 ///< comes after the change under way
  bool must_restate_ = false;                  ///< all statements, when matching is over
  bool must_take_up_ = false;                  ///< the awaited statements, when matching and the others are over
  bool must_place_ = false;                    ///< the matcher is to ask for places again, when statements are over
};

}  // namespace geminga::participant

#endif
