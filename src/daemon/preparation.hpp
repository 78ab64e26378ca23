// Prepares an ontology for class expressions on a thread of its own, while the event loop serves.
#ifndef GEMINGA_DAEMON_PREPARATION_HPP
#define GEMINGA_DAEMON_PREPARATION_HPP

#include <functional>
#include <memory>

#include "daemon/background.hpp"
#include "discovery/participant/prepared_ontology.hpp"
#include "reasoning/compiled/ontology.hpp"

namespace geminga::daemon {

/// One ontology at a time. The thread shares the ontology and nothing else with the event loop.
class Preparation {
 public:
  using Done = std::function<void(std::unique_ptr<const participant::PreparedOntology>)>;

  /// Borrows the context for its life.
  explicit Preparation(boost::asio::io_context& context) : background_(context) {}

  /// Prepares `ontology`, which lives at least until `done` has been called: on the event loop, in an event of its own.
  /// One that was asked for earlier is given up, and its `done` never called.
  void start(std::shared_ptr<const compiled::Ontology> ontology, Done done);
  /// Gives up what is being prepared.
  void cancel() { background_.cancel(); }
  /// What is being prepared; null: nothing.
  [[nodiscard]] const compiled::Ontology* current() const {
    return background_.is_wanted() ? ontology_.get() : nullptr;
  }
  /// Whether the thread is at work, be it for what was given up. The process must not take down then what it uses.
  [[nodiscard]] bool is_at_work() const { return background_.is_at_work(); }

 private:
  std::shared_ptr<const compiled::Ontology> ontology_;  ///< that was started last
  Background background_;
};

}  // namespace geminga::daemon

#endif
