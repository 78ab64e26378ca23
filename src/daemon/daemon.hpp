// gemingad as a whole: one participant in the real world, its configuration, its ontologies, and the signals it obeys.
#ifndef GEMINGA_DAEMON_DAEMON_HPP
#define GEMINGA_DAEMON_DAEMON_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <expected>
#include <memory>
#include <string>
#include <vector>

#include "daemon/adoption/adoption.hpp"
#include "daemon/cage_in_force.hpp"
#include "daemon/configuration/configuration_in_force.hpp"
#include "daemon/description_in_force.hpp"
#include "daemon/log/log.hpp"
#include "daemon/memory/memory_watch.hpp"
#include "daemon/ontology/ontology_in_force.hpp"
#include "daemon/readiness.hpp"
#include "daemon/supervisor/supervisor.hpp"
#include "daemon/supervisor/watchdog.hpp"
#include "discovery/participant/participant.hpp"
#include "env/asio/asio_env.hpp"
#include "env/asio/event_sink.hpp"

namespace geminga::daemon {

/// Exit statuses of the contract.
inline constexpr int exit_done = 0;
inline constexpr int exit_wrong = 2;

/// Routes events between the world (AsioEnv), the participant, the configuration and the ontology, each of which has an
/// owner of its own.
class Daemon final : private env::EventSink {
 public:
  /// `read` reads the configuration again, for SIGHUP. Borrows the supervisor and the log for its life.
  Daemon(Configuration configuration, ConfigurationInForce::Reader read, const Supervisor& supervisor, Log& log);
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  /// Loads the ontologies and nothing more. The errors are lines for the user.
  [[nodiscard]] std::expected<void, std::vector<std::string>> check();
  /// Serves until SIGTERM or SIGINT. The errors are lines for the user and say why it could not begin.
  [[nodiscard]] std::expected<void, std::vector<std::string>> run();
  /// Whether a thread is still at work. It cannot be stopped, and the process must not destroy what the thread uses.
  [[nodiscard]] bool is_at_work() const { return ontology_.is_at_work(); }

 private:
  std::expected<void, std::vector<std::string>> run_loop();
  void fail(std::vector<std::string> lines);

  void open();
  /// Listens where the supervisor and the configuration say. The error is a line for the user.
  [[nodiscard]] std::expected<void, std::string> listen();
  void begin();
  /// Tells the log and the supervisor where the start or a reload is over.
  void update_readiness();
  [[nodiscard]] std::uint32_t lasting();
  void after_event();
  void await_signal();
  void reload();
  /// Loads the ontologies again, with what the owner adopts.
  void adopt();
  void stop();

  void on_timer() override {
    participant_->on_timer();
    after_event();
  }
  void on_datagram(env::InterfaceIndex interface, std::string_view source,
                   std::span<const std::byte> datagram) override;
  void on_interfaces_changed() override;
  void on_routes_changed() override;
  void on_stream_opened(env::StreamId stream, std::string_view user) override {
    participant_->on_stream_opened(stream, user);
  }
  void on_stream_bytes(env::StreamId stream, std::string_view bytes) override;
  void on_stream_drained(env::StreamId stream) override { participant_->on_stream_drained(stream); }
  void on_stream_closed(env::StreamId stream) override { participant_->on_stream_closed(stream); }

  MemoryWatch memory_;
  ConfigurationInForce configuration_;
  const Supervisor& supervisor_;
  Log& log_;
  CageInForce cage_;
  boost::asio::io_context context_{1};
  boost::asio::signal_set signals_;
  boost::asio::steady_timer patience_;  ///< bounds the wait for the ontology at the start, and for clients at the end
  Watchdog watchdog_;
  Readiness readiness_;
  env::AsioEnv env_;
  std::unique_ptr<participant::Participant> participant_;  ///< null until begin()
  OntologyInForce ontology_;
  AdoptionWatch adoption_;
  DescriptionInForce description_;
  std::uint32_t lasting_ = 0;         ///< the identity that the daemon keeps across restarts; 0: it keeps none
  std::vector<std::string> failure_;  ///< lines for the user
  bool is_stopping_ = false;
  bool must_reload_ = false;  ///< SIGHUP came before begin()
};

}  // namespace geminga::daemon

#endif
