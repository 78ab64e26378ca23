#include "participant/participant.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "participant/announcer.hpp"
#include "participant/core.hpp"
#include "participant/neighbour_feed.hpp"
#include "participant/own_services.hpp"
#include "participant/statements.hpp"

namespace geminga::participant {
namespace {

/// Whether a first line shows that the client speaks HTTP or TLS: a browser that was made to talk to us.
bool is_web(std::string_view line) {
  const std::size_t last_word = line.rfind(' ');
  return line.starts_with("\x16\x03") ||
         (last_word != std::string_view::npos && line.substr(last_word + 1).starts_with("HTTP/"));
}

/// What is said to a peer within one event is written together, but not more than this: Env, which knows what is still
/// unread, closes a client for which too much waits.
constexpr std::size_t max_outbox_bytes = std::size_t{256} * 1024;

}  // namespace

/// Handles one event at a time; settle() ends each of them.
class Participant::State {
 public:
  State(env::Env& env, Settings settings, const el::Ontology* ontology)
      : core(env, std::move(settings), ontology), announcer(core) {}

  Core core;
  Announcer announcer;
  std::set<env::InterfaceIndex> interfaces;
  std::uint32_t next_peer = 1;

  void start() {
    GEMINGA_ASSERT(core.phase == Phase::created);
    core.started = core.env.now();
    core.phase = Phase::claiming;
    remember_interfaces();
    announcer.start();
    settle();
  }

  void stop() {
    if (is_over() || core.phase == Phase::stopping) return;
    const Phase was = std::exchange(core.phase, Phase::stopping);
    close_all(was == Phase::ready ? std::nullopt
                                  : std::optional(Error{ErrorCode::not_ready, "not ready: the daemon is stopping"}));
    announcer.stop();
    settle();
  }

  [[nodiscard]] bool is_over() const { return core.phase == Phase::stopped || core.phase == Phase::failed; }

  void open(env::StreamId stream) {
    const bool is_stopping = core.phase == Phase::stopping || is_over();
    if (is_stopping || core.sessions.size() >= core.settings.limits.peers) {
      ++core.counters.clients_refused;
      core.env.write(
          stream,
          gcnp::to_line(0, is_stopping ? Error{ErrorCode::not_ready, "not ready: the daemon is stopping"}
                                       : Error{ErrorCode::too_many, "too many clients: the limit is " +
                                                                        std::to_string(core.settings.limits.peers)}));
      core.env.close(stream);
      return;
    }
    ++core.counters.clients;
    core.sessions.emplace(stream, std::make_unique<Session>(stream, PeerId(next_peer++), core.settings.limits));
  }

  void read(env::StreamId stream, std::string_view bytes) {
    const auto found = core.sessions.find(stream);
    if (found == core.sessions.end()) return;
    Session& session = *found->second;
    session.reader.feed(bytes);
    while (!session.is_closing) {
      const auto line = session.reader.next();
      if (!line) break;
      take_line(session, *line);
    }
    settle();
  }

  void closed(env::StreamId stream) {
    const auto found = core.sessions.find(stream);
    if (found == core.sessions.end()) return;
    withdraw_all(core, *found->second);
    core.sessions.erase(found);
    settle();
  }

  void timer() {
    if (!is_over() && core.phase != Phase::created) settle();
  }

  void datagram(env::InterfaceIndex interface, std::string_view source, std::span<const std::byte> bytes) {
    if (core.phase != Phase::claiming && core.phase != Phase::ready) return;
    if (hear(core, announcer, interface, source, bytes) == Announcer::Consequence::failed) fail();
    settle();
  }

  void interfaces_changed() {
    if (core.phase == Phase::created || is_over()) return;
    const std::set<env::InterfaceIndex> before = interfaces;
    remember_interfaces();
    for (const env::InterfaceIndex index : before) {
      if (!interfaces.contains(index)) core.neighbours.forget_interface(index);
    }
    feed(core);
    core.is_changed = true;
    settle();
  }

  void set_ontology(const el::Ontology* ontology) {
    if (!core.ontology_state.failure.empty())
      core.log(base::LogLevel::info, "ontology: read at last, the failure is mended");
    core.ontology_state.succeed();
    change_ontology(core, ontology);
    if (core.phase != Phase::created && !is_over()) settle();
  }

 private:
  void remember_interfaces() {
    interfaces.clear();
    for (const env::Interface& interface : core.env.interfaces()) interfaces.insert(interface.index);
  }

  void take_line(Session& session, const gcnp::LineReader::Line& line) {
    ++core.counters.statements;
    if (session.statements++ == 0 && is_web(line.text)) {
      core.refuse(session, 0, {ErrorCode::malformed, "this port speaks GCNP, not HTTP"});
      session.is_closing = true;
      return;
    }
    switch (session.gate.count(core.env.now())) {
      case RateGate::Verdict::pass:
        break;
      case RateGate::Verdict::refuse:
        refuse(session, line, too_fast());
        return;
      case RateGate::Verdict::flood:
        core.log(base::LogLevel::warning, "peer " + session.name + " floods: its connection is closed");
        refuse(session, line, too_fast());
        withdraw_all(core, session);
        session.is_closing = true;
        return;
    }
    if (line.is_too_long) {
      refuse(session, line,
             {ErrorCode::too_large,
              "the line is too long: the limit is " + std::to_string(gcnp::max_line_bytes) + " octets"});
    } else if (core.phase == Phase::ready) {
      take_statement(session, line.text);
    } else if (!session.hold(line.text, core.settings.limits)) {
      refuse(session, line,
             {ErrorCode::not_ready, "not ready: an identifier is being claimed and too many statements wait already"});
    }
  }

  [[nodiscard]] Error too_fast() const {
    return {ErrorCode::too_many, "too many statements: the limit is " +
                                     std::to_string(core.settings.limits.statements_per_second) + " in a second"};
  }

  /// Answers a line that was not read, by the id that it begins with.
  void refuse(Session& session, const gcnp::LineReader::Line& line, const Error& error) {
    const std::string_view beginning = line.text.substr(0, gcnp::LineReader::beginning_bytes);
    const std::string_view word = beginning.substr(0, beginning.find(' '));
    core.refuse(session, base::parse_number<std::uint32_t>(word).value_or(0), error);
  }

  void take_statement(Session& session, std::string_view line) {
    const auto statement = gcnp::parse(line);
    if (!statement) {
      core.refuse(session, statement.error().id, statement.error().error);
      return;
    }
    const std::uint64_t events_before = core.counters.events;
    const std::uint64_t classified_before = core.expressions.counts().classified;
    const auto request = gcnp::read_request(*statement);
    const Refusal refusal = request ? handle(core, session, statement->id, *request) : Refusal(request.error());
    if (refusal) core.refuse(session, statement->id, *refusal);
    // Now, so that an answer to what comes next stands behind the events of this.
    core.deliver_events();
    session.gate.charge((core.counters.events - events_before) / work_per_statement +
                        (core.expressions.counts().classified - classified_before) * statements_per_expression);
    if (session.outbox_bytes() > max_outbox_bytes) core.env.write(session.stream(), session.take_outbox());
  }

  void claimed() {
    if (core.phase == Phase::ready) leave_all(core);
    core.id = announcer.id();
    core.phase = Phase::ready;
    core.is_changed = true;
    core.log(base::LogLevel::info,
             "participant " + to_string(core.id) + " (" + base::printable(core.name()) + ") is ready");
    enter_all(core);
    core.deliver_events();
    for (const auto& [stream, session] : core.sessions) {
      while (session->has_held() && !session->is_closing) take_statement(*session, session->take_held());
    }
  }

  void fail() {
    core.log(base::LogLevel::error, announcer.failure());
    core.phase = Phase::failed;
    close_all(Error{ErrorCode::not_ready, "not ready: no identifier could be claimed, the daemon ends"});
  }

  void close_all(const std::optional<Error>& error) {
    for (const auto& [stream, session] : core.sessions) {
      if (error) core.refuse(*session, 0, *error);
      core.env.write(stream, session->take_outbox());
      core.env.close(stream);
    }
    core.sessions.clear();
  }

  void close_closing() {
    for (auto next = core.sessions.begin(); next != core.sessions.end();) {
      const auto one = next++;
      if (!one->second->is_closing) continue;
      withdraw_all(core, *one->second);
      core.env.write(one->first, one->second->take_outbox());
      core.env.close(one->first);
      core.sessions.erase(one);
    }
  }

  /// Ends an event: everything that follows from it is handed to Env, and the timer is set.
  void settle() {
    if (core.phase == Phase::claiming || core.phase == Phase::ready) {
      expire(core);
      announcer.end_contest();
      switch (announcer.step_claim()) {
        case Announcer::Step::nothing:
          break;
        case Announcer::Step::claimed:
          claimed();
          break;
        case Announcer::Step::failed:
          fail();
          break;
      }
      core.ontology_watch.look(core);
      close_closing();
      core.deliver_events();
      for (const auto& [stream, session] : core.sessions) {
        if (const std::string said = session->take_outbox(); !said.empty()) core.env.write(stream, said);
      }
    }
    if (!is_over()) announcer.announce();
    if (core.phase == Phase::stopping && announcer.is_finished()) core.phase = Phase::stopped;
    core.env.wake_at(is_over() ? base::never : std::min(announcer.due(), deadline()));
  }

  [[nodiscard]] base::Instant deadline() const {
    return core.phase == Phase::stopping ? base::never : core.neighbours.next_deadline();
  }
};

Participant::Participant(env::Env& env, Settings settings, const el::Ontology* ontology)
    : state_(std::make_unique<State>(env, std::move(settings), ontology)) {}

Participant::~Participant() = default;

void Participant::start() { state_->start(); }
void Participant::stop() { state_->stop(); }
bool Participant::is_stopped() const { return state_->is_over(); }
std::string Participant::failure() const {
  return state_->core.phase == Phase::failed ? state_->announcer.failure() : std::string();
}
bool Participant::is_ready() const { return state_->core.phase == Phase::ready; }
void Participant::on_timer() { state_->timer(); }
void Participant::on_datagram(env::InterfaceIndex interface, std::string_view source,
                              std::span<const std::byte> datagram) {
  state_->datagram(interface, source, datagram);
}
void Participant::on_interfaces_changed() { state_->interfaces_changed(); }
void Participant::on_stream_opened(env::StreamId stream) { state_->open(stream); }
void Participant::on_stream_bytes(env::StreamId stream, std::string_view bytes) { state_->read(stream, bytes); }
void Participant::on_stream_closed(env::StreamId stream) { state_->closed(stream); }
void Participant::set_ontology(const el::Ontology* ontology) { state_->set_ontology(ontology); }
void Participant::ontology_begun() { state_->core.ontology_state.begin(); }
void Participant::ontology_failed(const std::vector<std::string>& lines) {
  state_->core.ontology_state.fail(lines, state_->core.env.now());
}
void Participant::set_status_source(StatusSource source) { state_->core.status_source = std::move(source); }

}  // namespace geminga::participant
