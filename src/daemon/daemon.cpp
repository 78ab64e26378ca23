#include "daemon/daemon.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <system_error>

#include "base/text.hpp"
#include "daemon/ontology_loader.hpp"
#include "daemon/preparation.hpp"
#include "daemon/state_folder.hpp"
#include "daemon/usage.hpp"
#include "discovery/participant/participant.hpp"

namespace geminga::daemon {
namespace {

namespace net = boost::asio;
using Lines = std::vector<std::string>;
using base::LogLevel;

/// How long a stop may take when a client does not read its last lines: with what the loop is just busy with, less than
/// the half second that is promised.
constexpr std::chrono::milliseconds stop_patience{400};

std::string digest_of(const vocabulary::Vocabulary& vocabulary) {
  return vocabulary.is_loaded() ? base::to_hex(vocabulary.digest(), 16) : "none";
}

/// How long a start waits for the ontology before it serves without it.
constexpr std::chrono::milliseconds start_patience{500};

/// A line for each file or folder that is not there: a slip in a flag, which nobody should find in a log days later.
Lines missing_files(const std::vector<std::string>& paths) {
  Lines lines;
  for (const std::string& path : paths) {
    std::error_code error;
    if (std::filesystem::exists(path, error)) continue;
    lines.push_back(path + ": cannot be opened: " +
                    (error ? error : std::make_error_code(std::errc::no_such_file_or_directory)).message());
  }
  return lines;
}

std::string decimal(double number) {
  char digits[32];
  const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), number, std::chars_format::fixed, 3);
  return error == std::errc() ? std::string(std::begin(digits), end) : "0";
}

}  // namespace

class Daemon::State final : private env::EventSink {
 public:
  State(Configuration configuration, Reread reread, Log& log)
      : configuration_(std::move(configuration)),
        reread_(std::move(reread)),
        log_(log),
        signals_(context_, SIGTERM, SIGINT, SIGHUP),
        start_patience_(context_),
        patience_(context_),
        loader_(context_, find_compiler()),
        preparation_(context_) {}

  std::expected<void, Lines> check() {
    load([this](Loaded loaded) {
      loaded = without_contradiction(std::move(loaded));
      if (!loaded) fail(std::move(loaded.error()));
    });
    return go();
  }

  std::expected<void, Lines> run() {
    if (Lines missing = missing_files(configuration_.ontologies); !missing.empty()) return std::unexpected(missing);
    await_signal();
    open();
    return go();
  }

  [[nodiscard]] bool is_at_work() const { return preparation_.is_at_work() || loader_.is_at_work(); }

 private:
  std::expected<void, Lines> go() {
    context_.run();
    if (!failure_.empty()) return std::unexpected(failure_);
    return {};
  }

  void fail(Lines lines) {
    failure_ = std::move(lines);
    context_.stop();
  }

  using Loaded = std::expected<LoadedOntology, Lines>;

  /// An ontology that contradicts itself is a failure where there is a choice.
  [[nodiscard]] Loaded without_contradiction(Loaded loaded) const {
    if (!loaded) return loaded;
    auto contradiction = contradiction_in(*loaded, configuration_.ontologies);
    return contradiction ? Loaded(std::unexpected(Lines{std::move(*contradiction)})) : std::move(loaded);
  }

  /// Starts to load the configured ontologies; a load that is under way is given up.
  template <typename Then>
  void load(Then then) {
    const auto began = std::chrono::steady_clock::now();
    loader_.load(configuration_.ontologies, configuration_.prefixes, [this, then, began](Loaded loaded) {
      if (loaded) {
        load_time_ = std::chrono::steady_clock::now() - began;
        for (const std::string& remark : loaded->remarks) log_.write(LogLevel::warning, "ontology: " + remark);
      }
      then(std::move(loaded));
    });
  }

  /// Opens the doors and begins to load. Clients wait in the backlog until the ontology is there, so that with a small
  /// one nobody ever sees a daemon without; a large or hard one is waited for only so long.
  void open() {
    for (const GcnpAddress& address : configuration_.gcnp) {
      const auto listening = env_.listen(address.endpoint, address.may_be_missing);
      if (!listening) return fail({listening.error()});
    }
    if (!configuration_.gcnp_socket.empty()) {
      const auto listening = env_.listen(configuration_.gcnp_socket);
      if (!listening) return fail({listening.error()});
    }
    start_patience_.expires_after(start_patience);
    start_patience_.async_wait([this](const boost::system::error_code& error) {
      if (!error && participant_ == nullptr) begin();
    });
    load([this](Loaded loaded) { take(std::move(loaded)); });
  }

  /// Serves, with what is there of the ontology.
  void begin() {
    start_patience_.cancel();
    env_.open_air(configuration_.air);
    participant::Settings settings;
    settings.name = configuration_.name;
    settings.group = configuration_.group;
    settings.interval = configuration_.interval;
    settings.sealing = configuration_.sealing;
    settings.version = GEMINGA_VERSION;
    settings.lasting = lasting();
    env_.event([&] {
      participant_ = std::make_unique<participant::Participant>(env_, settings, vocabulary_);
      participant_->set_status_source([this] { return status(); });
      if (loader_.is_loading()) participant_->ontology_begun();
      participant_->start();
    });
    say_sealing();
    env_.serve(*this);
    after_event();
    if (must_reload_) reload();
  }

  /// Who we are in all our lives; 0: nothing is kept.
  [[nodiscard]] std::uint32_t lasting() {
    if (configuration_.state_folder.empty()) return 0;
    const auto identity = lasting_identity(configuration_.state_folder, [this] { return env_.random_bits(); });
    if (identity) return *identity;
    log_.write(LogLevel::warning, identity.error() + ": going on without an identity that lasts");
    return 0;
  }

  /// Puts in force what was loaded. A load that failed is reported and changes nothing else.
  void take(Loaded loaded) {
    if (is_stopping_) return;
    if (participant_ == nullptr) return take_first(std::move(loaded));
    if (!loaded) {
      say_kept(loaded.error(), vocabulary_.is_loaded() ? "the ontology in force is kept: " + digest_of(vocabulary_)
                                                       : "serving without an ontology: mend it and send SIGHUP");
      env_.event([&] { participant_->ontology_failed(loaded.error()); });
    } else if (loaded->ontology != nullptr && participant_->uses_expressions()) {
      // The one in force stays until this one can place expressions, so that nobody loses a match meanwhile.
      is_next_in_preparation_ = true;
      preparation_.start(vocabulary::Vocabulary(std::move(loaded->ontology)), [this](vocabulary::Vocabulary prepared) {
        if (is_stopping_) return;
        is_next_in_preparation_ = false;
        put_in_force(std::move(prepared));
        after_event();
      });
    } else {
      put_in_force(vocabulary::Vocabulary(std::move(loaded->ontology)));
    }
    after_event();
  }

  void put_in_force(vocabulary::Vocabulary vocabulary) {
    preparation_.cancel();
    vocabulary_ = std::move(vocabulary);
    env_.event([&] { participant_->set_vocabulary(vocabulary_); });
    log_.write(LogLevel::info, "ontology: " + digest_of(vocabulary_) + " is in force");
  }

  /// Has the vocabulary in force prepared where an event has asked for that.
  void look_for_expressions() {
    const vocabulary::Vocabulary* wanted = participant_->wants_prepared();
    if (wanted == nullptr || !wanted->has_ontology_of(vocabulary_) || is_next_in_preparation_) return;
    if (preparation_.is_preparing(*wanted)) return;
    preparation_.start(*wanted, [this](vocabulary::Vocabulary prepared) {
      env_.event([&] { participant_->on_prepared(std::move(prepared)); });
      after_event();
    });
  }

  /// The same before anybody is served.
  void take_first(Loaded loaded) {
    if (loaded) vocabulary_ = vocabulary::Vocabulary(std::move(loaded->ontology));
    begin();
    if (!loaded) take(std::move(loaded));
  }

  void on_timer() override {
    participant_->on_timer();
    after_event();
  }
  void on_datagram(env::InterfaceIndex interface, std::string_view source,
                   std::span<const std::byte> datagram) override {
    participant_->on_datagram(interface, source, datagram);
    after_event();
  }
  void on_interfaces_changed() override {
    log_.write(LogLevel::info, "interfaces: " + interface_words());
    participant_->on_interfaces_changed();
    after_event();
  }
  void on_stream_opened(env::StreamId stream, std::string_view user) override {
    participant_->on_stream_opened(stream, user);
  }
  void on_stream_bytes(env::StreamId stream, std::string_view bytes) override {
    participant_->on_stream_bytes(stream, bytes);
    after_event();
  }
  void on_stream_drained(env::StreamId stream) override { participant_->on_stream_drained(stream); }
  void on_stream_closed(env::StreamId stream) override { participant_->on_stream_closed(stream); }

  /// Looks whether the participant has come to be ready, or to its end.
  void after_event() {
    log_.catch_up();
    look_for_expressions();
    if (!is_announced_ && participant_->is_ready()) {
      is_announced_ = true;
      log_.write(LogLevel::info, ready_words());
    }
    if (!participant_->is_stopped()) return;
    if (!is_stopping_) return fail({participant_->failure()});
    finish();
  }

  /// Leaves the loop when the last lines are with the clients; patience_ bounds the wait.
  void finish() {
    if (!env_.is_writing()) context_.stop();
  }

  void await_signal() {
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

  void stop() {
    if (is_stopping_ || participant_ == nullptr) return context_.stop();  // before the start, or asked again
    is_stopping_ = true;
    log_.write(LogLevel::info, "stopping: saying goodbye");
    env_.stop_listening();
    patience_.expires_after(stop_patience);
    patience_.async_wait([this](const boost::system::error_code& error) {
      if (!error) context_.stop();
    });
    env_.event([&] { participant_->stop(); });
    after_event();
  }

  void reload() {
    must_reload_ = participant_ == nullptr;  // not yet, and then with what is configured at that time
    if (must_reload_ || is_stopping_) return;
    log_.write(LogLevel::info, "reading configuration and ontologies again");
    auto read = reread_();
    if (!read) {
      say_kept(read.error(), "the configuration in force is kept");
      configuration_failure_ = read.error().empty() ? "unknown" : read.error().front();
      return;
    }
    configuration_failure_.clear();
    const Configuration before = std::exchange(configuration_, std::move(*read));
    log_.set(configuration_.log_level, configuration_.log_format);
    if (configuration_.name != before.name || configuration_.group != before.group ||
        configuration_.gcnp != before.gcnp || configuration_.gcnp_socket != before.gcnp_socket ||
        configuration_.interval != before.interval || configuration_.state_folder != before.state_folder) {
      log_.write(LogLevel::warning,
                 "name, group, gcnp, gcnp-socket, interval and state-folder take effect at the next start");
    }
    if (configuration_.air != before.air) env_.open_air(configuration_.air);
    if (configuration_.sealing != before.sealing) {
      env_.event([&] { participant_->set_sealing(configuration_.sealing); });
      say_sealing();
    }
    if (std::exchange(is_next_in_preparation_, false)) preparation_.cancel();  // what is read now is newer
    env_.event([&] { participant_->ontology_begun(); });
    load([this](Loaded loaded) { take(without_contradiction(std::move(loaded))); });
  }

  void say_sealing() {
    std::vector<std::string> ids;
    for (const sealing::Key& key : configuration_.sealing.keys.keys()) ids.push_back(to_string(key.id()));
    if (ids.empty()) return log_.write(LogLevel::info, "announcements are not sealed: there is no key");
    log_.write(LogLevel::info, "announcements: " + std::string(to_string(configuration_.sealing.mode)) + ", keys " +
                                   base::joined(ids, ", "));
  }

  void say_kept(const Lines& errors, const std::string& kept) {
    for (const std::string& error : errors) log_.write(LogLevel::error, error);
    log_.write(LogLevel::error, "reading failed: " + kept);
  }

  [[nodiscard]] std::string interface_words() const {
    std::vector<std::string> words;
    for (const env::Interface& interface : env_.interfaces()) {
      if (interface.twin_of) continue;
      words.push_back(interface.name + (interface.addresses.empty() ? "" : " " + interface.addresses.front()));
    }
    return words.empty() ? "none: nobody can be heard" : base::joined(words, ", ");
  }

  [[nodiscard]] std::string ready_words() const {
    std::vector<std::string> addresses;
    for (const GcnpAddress& address : configuration_.gcnp) addresses.push_back(env::to_string(address.endpoint));
    if (!configuration_.gcnp_socket.empty()) addresses.push_back(base::printable(configuration_.gcnp_socket));
    return "ready: gcnp " + base::joined(addresses, ", ") + "; interfaces " + interface_words() + "; ontology " +
           (loader_.is_loading() ? "is being loaded" : digest_of(vocabulary_));
  }

  [[nodiscard]] std::vector<gcnp::Parameter> status() const {
    const Usage usage = read_usage();
    std::vector<gcnp::Parameter> line{{"memory", std::to_string(usage.resident_bytes)},
                                      {"peak_memory", std::to_string(usage.peak_resident_bytes)},
                                      {"cpu", decimal(usage.processor_seconds)},
                                      {"ontology_load", decimal(std::chrono::duration<double>(load_time_).count())},
                                      {"log_dropped", std::to_string(log_.dropped())}};
    const env::AirCounts& dropped = env_.air_counts();
    const auto append = [&](const char* key, std::uint64_t count) {
      if (count != 0) line.push_back({key, std::to_string(count)});
    };
    append("dropped_off_link", dropped.off_link);
    append("dropped_no_peer", dropped.no_peer);
    append("dropped_wrong_way", dropped.wrong_way);
    append("dropped_overrun", dropped.overrun);
    const env::UnicastCounts unicast = env_.unicast_counts();
    append("peers_named", unicast.named);
    append("peers_silent", unicast.silent);
    append("peers_unnamed", unicast.guests);
    if (!configuration_failure_.empty()) line.push_back({"configuration_failed", configuration_failure_});
    return line;
  }

  Configuration configuration_;
  Reread reread_;
  Log& log_;
  net::io_context context_{1};
  net::signal_set signals_;
  net::steady_timer start_patience_;
  net::steady_timer patience_;
  OntologyLoader loader_;
  env::AsioEnv env_{context_, log_};
  vocabulary::Vocabulary vocabulary_;    ///< what the participant was given last
  bool is_next_in_preparation_ = false;  ///< one is loaded, and not in force until it is prepared
  std::unique_ptr<participant::Participant> participant_;
  Preparation preparation_;
  std::chrono::steady_clock::duration load_time_{};
  Lines failure_;
  std::string configuration_failure_;  ///< the first line of why it could not be read again; empty: it could
  bool is_announced_ = false;
  bool is_stopping_ = false;
  bool must_reload_ = false;
};

Daemon::Daemon(Configuration configuration, Reread reread, Log& log)
    : state_(std::make_unique<State>(std::move(configuration), std::move(reread), log)) {}
Daemon::~Daemon() = default;
bool Daemon::is_at_work() const { return state_->is_at_work(); }
std::expected<void, std::vector<std::string>> Daemon::check() { return state_->check(); }
std::expected<void, std::vector<std::string>> Daemon::run() { return state_->run(); }

}  // namespace geminga::daemon
