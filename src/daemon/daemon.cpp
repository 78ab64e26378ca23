#include "daemon/daemon.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <charconv>
#include <chrono>
#include <csignal>

#include "base/text.hpp"
#include "daemon/ontology_loader.hpp"
#include "daemon/usage.hpp"
#include "participant/participant.hpp"

namespace geminga::daemon {
namespace {

namespace net = boost::asio;
using Lines = std::vector<std::string>;
using base::LogLevel;

/// How long a stop may take when a client does not read its last lines or the participant its goodbyes.
constexpr std::chrono::milliseconds stop_patience{500};

std::string digest_of(const el::Ontology* ontology) {
  return ontology == nullptr ? "none" : base::to_hex(ontology->digest(), 16);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
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
        patience_(context_),
        loader_(context_, find_compiler()) {}

  std::expected<void, Lines> check() {
    load([](LoadedOntology) {});
    return go();
  }

  std::expected<void, Lines> run() {
    await_signal();
    load([this](LoadedOntology loaded) { begin(std::move(loaded)); });
    return go();
  }

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

  /// Loads the configured ontologies before anything is open; what is wrong with them ends the daemon.
  template <typename Then>
  void load(Then then) {
    const auto began = std::chrono::steady_clock::now();
    loader_.load(configuration_.ontologies, configuration_.prefixes,
                 [this, then, began](std::expected<LoadedOntology, Lines> loaded) {
                   if (!loaded) return fail(std::move(loaded.error()));
                   load_time_ = std::chrono::steady_clock::now() - began;
                   for (const std::string& remark : loaded->remarks)
                     log_.write(LogLevel::warning, "ontology: " + remark);
                   then(std::move(*loaded));
                 });
  }

  void begin(LoadedOntology loaded) {
    for (const GcnpAddress& address : configuration_.gcnp) {
      const auto listening = env_.listen(address.endpoint, address.may_be_missing);
      if (!listening) return fail({listening.error()});
    }
    if (!configuration_.gcnp_socket.empty()) {
      const auto listening = env_.listen(configuration_.gcnp_socket);
      if (!listening) return fail({listening.error()});
    }
    ontology_ = std::move(loaded.ontology);
    env_.open_air(configuration_.air);
    participant::Settings settings;
    settings.name = configuration_.name;
    settings.group = configuration_.group;
    settings.interval = configuration_.interval;
    settings.version = GEMINGA_VERSION;
    env_.event([&] {
      participant_ = std::make_unique<participant::Participant>(env_, settings, ontology_.get());
      participant_->set_status_source([this] { return status(); });
      participant_->start();
    });
    env_.serve(*this);
    after_event();
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
    if (participant_ == nullptr || is_stopping_) return;
    log_.write(LogLevel::info, "reading configuration and ontologies again");
    auto read = reread_();
    if (!read) {
      say_kept(read.error(), "the configuration in force is kept");
      return;
    }
    const Configuration before = std::exchange(configuration_, std::move(*read));
    log_.set(configuration_.log_level, configuration_.log_format);
    if (configuration_.name != before.name || configuration_.group != before.group ||
        configuration_.gcnp != before.gcnp || configuration_.gcnp_socket != before.gcnp_socket ||
        configuration_.interval != before.interval) {
      log_.write(LogLevel::warning, "name, group, gcnp, gcnp-socket and interval take effect at the next start");
    }
    if (configuration_.air != before.air) env_.open_air(configuration_.air);
    reload_ontologies();
  }

  /// The old ontology serves until the new one is whole.
  void reload_ontologies() {
    const auto began = std::chrono::steady_clock::now();
    participant_->ontology_begun();
    loader_.load(configuration_.ontologies, configuration_.prefixes,
                 [this, began](std::expected<LoadedOntology, Lines> loaded) {
                   if (is_stopping_) return;
                   if (!loaded) {
                     participant_->ontology_failed(loaded.error());
                     say_kept(loaded.error(), "the ontology in force is kept: " + digest_of(ontology_.get()));
                     return;
                   }
                   load_time_ = std::chrono::steady_clock::now() - began;
                   for (const std::string& remark : loaded->remarks)
                     log_.write(LogLevel::warning, "ontology: " + remark);
                   env_.event([&] { participant_->set_ontology(loaded->ontology.get()); });
                   ontology_ = std::move(loaded->ontology);
                   log_.write(LogLevel::info, "ontology: " + digest_of(ontology_.get()) + " is in force");
                 });
  }

  void say_kept(const Lines& errors, const std::string& kept) {
    for (const std::string& error : errors) log_.write(LogLevel::error, error);
    log_.write(LogLevel::error, "reading again failed: " + kept);
  }

  [[nodiscard]] std::string interface_words() const {
    std::vector<std::string> words;
    for (const env::Interface& interface : env_.interfaces()) {
      words.push_back(interface.name + (interface.addresses.empty() ? "" : " " + interface.addresses.front()));
    }
    return words.empty() ? "none: nobody can be heard" : joined(words);
  }

  [[nodiscard]] std::string ready_words() const {
    std::vector<std::string> addresses;
    for (const GcnpAddress& address : configuration_.gcnp) addresses.push_back(env::to_string(address.endpoint));
    if (!configuration_.gcnp_socket.empty()) addresses.push_back(base::printable(configuration_.gcnp_socket));
    return "ready: gcnp " + joined(addresses) + "; interfaces " + interface_words() + "; ontology " +
           digest_of(ontology_.get());
  }

  [[nodiscard]] std::vector<gcnp::Parameter> status() const {
    const Usage usage = read_usage();
    std::vector<gcnp::Parameter> line{{"memory", std::to_string(usage.resident_bytes)},
                                      {"peak_memory", std::to_string(usage.peak_resident_bytes)},
                                      {"cpu", decimal(usage.processor_seconds)},
                                      {"ontology_load", decimal(std::chrono::duration<double>(load_time_).count())}};
    const env::AirCounts& dropped = env_.air_counts();
    const auto append = [&](const char* key, std::uint64_t count) {
      if (count != 0) line.push_back({key, std::to_string(count)});
    };
    append("dropped_off_link", dropped.off_link);
    append("dropped_no_peer", dropped.no_peer);
    append("dropped_wrong_way", dropped.wrong_way);
    append("dropped_overrun", dropped.overrun);
    return line;
  }

  Configuration configuration_;
  Reread reread_;
  Log& log_;
  net::io_context context_{1};
  net::signal_set signals_;
  net::steady_timer patience_;
  OntologyLoader loader_;
  env::AsioEnv env_{context_, log_};
  std::unique_ptr<el::Ontology> ontology_;
  std::unique_ptr<participant::Participant> participant_;
  std::chrono::steady_clock::duration load_time_{};
  Lines failure_;
  bool is_announced_ = false;
  bool is_stopping_ = false;
};

Daemon::Daemon(Configuration configuration, Reread reread, Log& log)
    : state_(std::make_unique<State>(std::move(configuration), std::move(reread), log)) {}
Daemon::~Daemon() = default;
std::expected<void, std::vector<std::string>> Daemon::check() { return state_->check(); }
std::expected<void, std::vector<std::string>> Daemon::run() { return state_->run(); }

}  // namespace geminga::daemon
