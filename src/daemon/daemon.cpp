#include "daemon/daemon.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "daemon/state_folder.hpp"
#include "daemon/status.hpp"

namespace geminga::daemon {
namespace {

/// Seconds since 1970. Shown only: nothing in here depends on it.
double wall_clock() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

using Lines = std::vector<std::string>;
using base::LogLevel;

/// The wait at the end for clients that do not read their last lines. A stop is promised within half a second.
constexpr std::chrono::milliseconds max_stop_wait{400};
/// The wait at the start for the ontology. After it the daemon serves without one.
constexpr std::chrono::milliseconds max_start_wait{500};

/// One line for each file or folder that the configuration names and that does not exist. They end the start, so that a
/// mistyped flag is seen at once.
Lines missing_files(const Configuration& configuration) {
  Lines named = configuration.ontologies;
  if (configuration.describes_by_file()) named.push_back(configuration.description);
  Lines lines;
  for (const std::string& path : named) {
    std::error_code error;
    if (std::filesystem::exists(path, error)) continue;
    lines.push_back(path + ": cannot be opened: " +
                    (error ? error : std::make_error_code(std::errc::no_such_file_or_directory)).message());
  }
  return lines;
}

participant::Settings settings_of(const Configuration& configuration, std::uint32_t lasting) {
  participant::Settings settings;
  settings.name = configuration.name;
  settings.group = configuration.group;
  settings.interval = configuration.interval;
  settings.sealing = configuration.sealing;
  settings.relay = configuration.relay;
  settings.diagnoses = configuration.diagnoses;
  settings.version = GEMINGA_VERSION;
  settings.lasting = lasting;
  if (!configuration.describes_by_file()) settings.description = configuration.description;
  return settings;
}

}  // namespace

Daemon::Daemon(Configuration configuration, ConfigurationInForce::Reader read, const Supervisor& supervisor, Log& log)
    : configuration_(std::move(configuration), std::move(read)),
      supervisor_(supervisor),
      log_(log),
      signals_(context_, SIGTERM, SIGINT, SIGHUP),
      patience_(context_),
      watchdog_(context_, supervisor),
      readiness_(supervisor, log, [this] { return ready_line(configuration_.current(), env_, ontology_); }),
      env_(context_, log),
      ontology_(context_, env_, log, [this] { after_event(); }),
      adoption_(context_, [this] { adopt(); }),
      description_(context_, env_, log, [this] { after_event(); }) {}

std::expected<void, Lines> Daemon::check() {
  if (Lines missing = missing_files(configuration_.current()); !missing.empty())
    return std::unexpected(std::move(missing));
  ontology_.load_consistent(configuration_.current(), [this](OntologyInForce::Loaded loaded) {
    if (!loaded) return fail(std::move(loaded.error()));
    description_.check(configuration_.current(), participant::Participant::Vocabulary(std::move(loaded->ontology)),
                       [this](Lines faults) {
                         if (!faults.empty()) fail(std::move(faults));
                       });
  });
  return run_loop();
}

std::expected<void, Lines> Daemon::run() {
  if (Lines missing = missing_files(configuration_.current()); !missing.empty())
    return std::unexpected(std::move(missing));
  await_signal();
  open();
  return run_loop();
}

std::expected<void, Lines> Daemon::run_loop() {
  try {
    context_.run();
  } catch (const std::bad_alloc&) {
    // One event has used up the reserve as well, and was left half done. Nothing can rely on what is there.
    std::fputs("gemingad: memory has ended, and so has what was kept back: ending at once\n", stderr);
    std::_Exit(exit_wrong);
  }
  if (!failure_.empty()) return std::unexpected(failure_);
  return {};
}

void Daemon::fail(Lines lines) {
  failure_ = std::move(lines);
  context_.stop();
}

/// Listens, closes the cage, and begins to load. Clients wait in the backlog until the ontology is there, so that with
/// a small one no client sees a daemon without it. The wait for a large or hard one is bounded.
void Daemon::open() {
  const Configuration& configuration = configuration_.current();
  if (const auto listening = listen(); !listening) return fail({listening.error()});
  watchdog_.start();
  lasting_ = lasting();
  // Before any other thread begins, which the cage would not hold.
  if (const auto closed = cage_.close(configuration, log_); !closed) return fail({closed.error()});
  patience_.expires_after(max_start_wait);
  patience_.async_wait([this](const boost::system::error_code& error) {
    if (!error && participant_ == nullptr) begin();
  });
  adoption_.watch(configuration.adopted);
  ontology_.start(configuration, [this] { begin(); });
}

std::expected<void, std::string> Daemon::listen() {
  for (const int descriptor : supervisor_.sockets()) {
    const auto place = env_.adopt(descriptor);
    if (!place) return std::unexpected("socket " + std::to_string(descriptor) + " of the supervisor " + place.error());
    log_.write(LogLevel::info, "listening on a socket of the supervisor: " + base::printable(*place));
  }
  const Configuration& configuration = configuration_.current();
  for (const GcnpAddress& address : configuration.gcnp) {
    if (auto listening = env_.listen(address.endpoint, address.may_be_missing); !listening) return listening;
  }
  if (configuration.gcnp_socket.empty()) return {};
  return env_.listen(configuration.gcnp_socket);
}

/// Serves, with the ontology or without.
void Daemon::begin() {
  patience_.cancel();
  const Configuration& configuration = configuration_.current();
  env_.open_air(configuration.air);
  const participant::Settings settings = settings_of(configuration, lasting_);
  env_.event([&] {
    participant_ = std::make_unique<participant::Participant>(env_, settings, ontology_.vocabulary());
    participant_->set_status_source([this, started = wall_clock()] {
      return status_fields(configuration_, cage_, env_, ontology_, log_, started);
    });
    ontology_.serve(*participant_);
    participant_->start();
  });
  log_.write(LogLevel::info, sealing_line(configuration.sealing));
  env_.serve(*this);
  description_.load(configuration, *participant_);
  after_event();
  if (must_reload_) reload();
}

/// The identity that the daemon keeps across restarts; 0: it keeps none.
std::uint32_t Daemon::lasting() {
  const std::string& folder = configuration_.current().state_folder;
  if (folder.empty()) return 0;
  const auto identity = lasting_identity(folder, [this] { return env_.random_bits(); });
  if (identity) {
    if (!identity->remark.empty()) log_.write(LogLevel::warning, identity->remark);
    return identity->number;
  }
  log_.write(LogLevel::warning, identity.error() + ": going on without an identity that lasts");
  return 0;
}

void Daemon::on_datagram(env::InterfaceIndex interface, std::string_view source, std::span<const std::byte> datagram) {
  participant_->on_datagram(interface, source, datagram);
  after_event();
}

void Daemon::on_interfaces_changed() {
  log_.write(LogLevel::info, interfaces_line(env_));
  participant_->on_interfaces_changed();
  after_event();
}

void Daemon::on_routes_changed() {
  participant_->on_routes_changed();
  after_event();
}

void Daemon::on_stream_bytes(env::StreamId stream, std::string_view bytes) {
  participant_->on_stream_bytes(stream, bytes);
  after_event();
}

void Daemon::update_readiness() { readiness_.update(participant_->is_ready(), ontology_.is_loading()); }

/// Tells that the participant is ready, and leaves the loop when it has stopped.
void Daemon::after_event() {
  log_.catch_up();
  if (memory_.is_short(env_.now())) env_.event([this] { participant_->shed(); });
  ontology_.prepare_if_wanted();
  update_readiness();
  if (!participant_->is_stopped()) return;
  if (!is_stopping_) return fail({participant_->failure()});
  if (!env_.is_writing()) context_.stop();  // the clients have their last lines; else patience_ bounds the wait
}

void Daemon::await_signal() {
  signals_.async_wait([this](const boost::system::error_code& error, int number) {
    if (error) return;
    await_signal();
    if (number == SIGHUP) {
      reload();
    } else {
      stop();
    }
  });
}

void Daemon::stop() {
  if (is_stopping_ || participant_ == nullptr) return context_.stop();  // before the start, or asked again
  is_stopping_ = true;
  ontology_.stop();
  description_.stop();
  log_.write(LogLevel::info, "stopping: saying goodbye");
  supervisor_.say_stopping();
  env_.stop_listening();
  patience_.expires_after(max_stop_wait);
  patience_.async_wait([this](const boost::system::error_code& error) {
    if (!error) context_.stop();
  });
  env_.event([&] { participant_->stop(); });
  after_event();
}

void Daemon::reload() {
  must_reload_ = participant_ == nullptr;  // begin() reloads then
  if (must_reload_ || is_stopping_) return;
  log_.write(LogLevel::info, "reading configuration and ontologies again");
  env_.event([&] { readiness_.begin_reload(env_.now()); });
  const auto change = configuration_.reload();
  if (!change) {
    log_.write_failed_reading(change.error(), "the configuration in force is kept");
    return update_readiness();
  }
  const Configuration& configuration = configuration_.current();
  log_.set(configuration.log_level, configuration.log_format);
  if (change->awaits_a_start) {
    log_.write(LogLevel::warning,
               "name, group, gcnp, gcnp-socket, interval, state-folder and cage take effect at the next start");
  }
  if (change->air) env_.open_air(configuration.air);
  if (change->sealing) {
    env_.event([&] { participant_->set_sealing(configuration.sealing); });
    log_.write(LogLevel::info, sealing_line(configuration.sealing));
  }
  if (change->description && !configuration.describes_by_file()) {
    env_.event([&] { participant_->describe(configuration.description); });
  }
  description_.load(configuration, *participant_);
  adoption_.watch(configuration.adopted);
  ontology_.reload(configuration);
  update_readiness();
}

void Daemon::adopt() {
  must_reload_ = must_reload_ || participant_ == nullptr;  // begin() reloads then
  if (participant_ == nullptr || is_stopping_) return;
  log_.write(LogLevel::info, "reading the ontologies again: another one has come to be adopted");
  ontology_.reload(configuration_.current());
}

}  // namespace geminga::daemon
