// Prepares an ontology for class expressions on a thread of its own, while the event loop serves.
#ifndef GEMINGA_DAEMON_PREPARATION_HPP
#define GEMINGA_DAEMON_PREPARATION_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "el/ontology.hpp"
#include "participant/prepared_ontology.hpp"

namespace boost::asio {
class io_context;
}

namespace geminga::daemon {

/// One ontology at a time, and never two threads. The thread shares the ontology and nothing else with the event loop,
/// so that it can be left to itself: preparing cannot be broken off, and neither a reload nor the end of the daemon
/// waits for it.
class Preparation {
 public:
  using Done = std::function<void(std::unique_ptr<const participant::PreparedOntology>)>;

  /// Borrows the context for its life.
  explicit Preparation(boost::asio::io_context& context);
  /// What is being prepared is dropped when it is done.
  ~Preparation();
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  /// Prepares `ontology`, which lives at least until `done` has been called: on the event loop, in an event of its own.
  /// One that was asked for earlier is given up, and its `done` never called.
  void start(std::shared_ptr<const el::Ontology> ontology, Done done);
  /// Gives up what is being prepared.
  void cancel();
  /// What is being prepared; null: nothing.
  [[nodiscard]] const el::Ontology* current() const { return wanted_ ? wanted_->ontology.get() : nullptr; }
  /// Whether the thread is at work, be it for what was given up. The process must not take down then what it uses.
  [[nodiscard]] bool is_at_work() const { return is_at_work_; }

 private:
  struct Wanted {
    std::shared_ptr<const el::Ontology> ontology;
    Done done;
    std::uint64_t number = 0;
  };
  using Result = std::unique_ptr<const participant::PreparedOntology>;
  struct Way;

  void set_to_work();
  void come_back(std::uint64_t number, Result result);

  std::shared_ptr<Way> way_;
  std::optional<Wanted> wanted_;
  std::uint64_t last_number_ = 0;
  bool is_at_work_ = false;
};

}  // namespace geminga::daemon

#endif
