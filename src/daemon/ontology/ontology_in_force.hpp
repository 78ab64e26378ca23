// The ontology that the daemon serves with: loaded, prepared for class expressions where these are in use, put in
// force.
#ifndef GEMINGA_DAEMON_ONTOLOGY_ONTOLOGY_IN_FORCE_HPP
#define GEMINGA_DAEMON_ONTOLOGY_ONTOLOGY_IN_FORCE_HPP

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "daemon/configuration/configuration.hpp"
#include "daemon/log/log.hpp"
#include "daemon/ontology/ontology_loader.hpp"
#include "daemon/ontology/preparation.hpp"
#include "discovery/participant/participant.hpp"
#include "env/asio/asio_env.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::daemon {

class OntologyInForce {
 public:
  using Loaded = OntologyLoader::Loaded;

  /// Borrows all for its life. `after_event` is called on the event loop after each event in which the ontology
  /// changed.
  OntologyInForce(boost::asio::io_context& context, env::AsioEnv& env, Log& log, std::function<void()> after_event)
      : env_(env),
        log_(log),
        after_event_(std::move(after_event)),
        loader_(context, find_compiler()),
        preparation_(context) {}

  /// Loads the ontologies of this configuration and gives them to `done` alone. A contradiction in them is an error.
  void load_consistent(const Configuration& configuration, std::function<void(Loaded)> done,
                       bool leaves_out_refused = false);
  /// Loads the ontologies of this configuration for the first time, whether they contradict themselves or not, and
  /// unless it is strict without those files of folders that cannot be read. When that has ended before serve() was
  /// called, calls `done`, which has to call serve().
  void start(const Configuration& configuration, std::function<void()> done);
  /// Loads them again. What fails, or contradicts itself, leaves the ontology in force as it is. Where none is in
  /// force, files are left out as at a start. Requires serve().
  void reload(const Configuration& configuration);

  /// Tells `participant` of each change from now on. It has been made with vocabulary(), and is borrowed for the life
  /// of this object. To be called within an event of the participant, before its start().
  void serve(participant::Participant& participant);
  /// Prepares the ontology in force where the participant asks for that. To be called after each event.
  void prepare_if_wanted();
  /// Changes nothing from now on.
  void stop() { is_stopped_ = true; }

  [[nodiscard]] const vocabulary::Vocabulary& vocabulary() const { return vocabulary_; }
  [[nodiscard]] bool is_loading() const { return loader_.is_loading(); }
  /// The time that the last successful load took.
  [[nodiscard]] std::chrono::steady_clock::duration load_time() const { return load_time_; }
  /// Whether a thread is still at work. It cannot be stopped, and the process must not destroy what the thread uses.
  [[nodiscard]] bool is_at_work() const { return preparation_.is_at_work() || loader_.is_at_work(); }

 private:
  void load(const Configuration& configuration, bool leaves_out_refused, std::function<void(Loaded)> done);
  void load_with(const Configuration& configuration, const std::vector<std::string>& adopted, bool leaves_out_refused,
                 std::function<void(Loaded)> done);
  void load_adopting(const Configuration& configuration, std::size_t level, bool leaves_out_refused,
                     std::function<void(Loaded)> done);
  void change_to(Loaded loaded);
  void report_failure(const std::vector<std::string>& lines);
  void put_in_force(vocabulary::Vocabulary vocabulary, const std::vector<std::string>& left_out);

  env::AsioEnv& env_;
  Log& log_;
  std::function<void()> after_event_;
  OntologyLoader loader_;
  participant::Participant* participant_ = nullptr;  ///< null until serve()
  vocabulary::Vocabulary vocabulary_;                ///< in force
  bool is_next_in_preparation_ = false;              ///< one is loaded, and comes into force when it is prepared
  bool is_stopped_ = false;
  std::chrono::steady_clock::duration load_time_{};
  Preparation preparation_;
};

/// The digest of the ontology, or "none".
[[nodiscard]] std::string digest_of(const vocabulary::Vocabulary& vocabulary);

}  // namespace geminga::daemon

#endif
