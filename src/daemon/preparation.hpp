// Prepares a vocabulary for class expressions on a thread of its own, while the event loop serves.
#ifndef GEMINGA_DAEMON_PREPARATION_HPP
#define GEMINGA_DAEMON_PREPARATION_HPP

#include <functional>

#include "daemon/background.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::daemon {

/// One at a time. The thread shares the vocabulary and nothing else with the event loop.
class Preparation {
 public:
  using Done = std::function<void(vocabulary::Vocabulary)>;

  /// Borrows the context for its life.
  explicit Preparation(boost::asio::io_context& context) : background_(context) {}

  /// Gives `done` what with_expressions() makes of this one: on the event loop, in an event of its own. One that was
  /// asked for earlier is given up, and its `done` never called.
  void start(const vocabulary::Vocabulary& vocabulary, Done done);
  /// Gives up what is being prepared.
  void cancel() { background_.cancel(); }
  /// Whether this one's ontology is being prepared.
  [[nodiscard]] bool is_preparing(const vocabulary::Vocabulary& vocabulary) const {
    return background_.is_wanted() && started_.is_of(vocabulary);
  }
  /// Whether the thread is at work, even on an ontology that was given up. Until it is done, the process must not
  /// destroy what the thread uses.
  [[nodiscard]] bool is_at_work() const { return background_.is_at_work(); }

 private:
  vocabulary::OntologyMark started_;  ///< last
  Background background_;
};

}  // namespace geminga::daemon

#endif
