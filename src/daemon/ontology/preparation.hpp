// Prepares a vocabulary for class expressions on a thread of its own, while the event loop serves.
#ifndef GEMINGA_DAEMON_ONTOLOGY_PREPARATION_HPP
#define GEMINGA_DAEMON_ONTOLOGY_PREPARATION_HPP

#include <functional>

#include "daemon/ontology/background.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::daemon {

/// Prepares one vocabulary at a time. The thread shares only the vocabulary with the event loop.
class Preparation {
 public:
  using Done = std::function<void(vocabulary::Vocabulary)>;

  /// Borrows the context for its life.
  explicit Preparation(boost::asio::io_context& context) : background_(context) {}

  /// Prepares this vocabulary by with_expressions() and gives the result to `done` on the event loop, in an event of
  /// its own. An earlier preparation is given up, and its `done` never called.
  void start(const vocabulary::Vocabulary& vocabulary, Done done);
  /// Gives up the preparation.
  void cancel() { background_.cancel(); }
  /// Whether the ontology of this vocabulary is being prepared.
  [[nodiscard]] bool is_preparing(const vocabulary::Vocabulary& vocabulary) const {
    return background_.is_wanted() && started_.is_of(vocabulary);
  }
  /// Whether the thread is at work, even on an ontology that was given up. Until it is done, the process must not
  /// destroy what the thread uses.
  [[nodiscard]] bool is_at_work() const { return background_.is_at_work(); }

 private:
  vocabulary::OntologyMark started_;  ///< of the last start()
  Background background_;
};

}  // namespace geminga::daemon

#endif
