#include "discovery/participant/participant.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "discovery/participant/announcer.hpp"
#include "discovery/participant/core.hpp"
#include "discovery/participant/neighbour_feed.hpp"
#include "discovery/participant/own_services.hpp"
#include "discovery/participant/sessions.hpp"
#include "discovery/participant/telling.hpp"
#include "discovery/participant/turns.hpp"

namespace geminga::participant {
/// Handles one event at a time; settle() ends each of them.
class Participant::State {
 public:
  State(env::Env& env, Settings settings, Vocabulary vocabulary)
      : core(env, std::move(settings), std::move(vocabulary)), announcer(core) {}

  Core core;
  Announcer announcer;
  std::set<env::InterfaceIndex> interfaces;

  void start() {
    GEMINGA_ASSERT(core.phase == Phase::created);
    core.started = core.env.now();
    core.phase = Phase::claiming;
    core.seal.adopt(core.settings.sealing, core.env.now());
    remember_interfaces();
    core.neighbours.set_secret(core.env.random_bits());
    announcer.start();
    settle();
  }

  void stop() {
    if (is_over() || core.phase == Phase::stopping) return;
    const Phase was = std::exchange(core.phase, Phase::stopping);
    close_all_sessions(core, was == Phase::ready
                                 ? std::nullopt
                                 : std::optional(Error{ErrorCode::not_ready, "not ready: the daemon is stopping"}));
    announcer.stop();
    settle();
  }

  [[nodiscard]] bool is_over() const { return core.phase == Phase::stopped || core.phase == Phase::failed; }

  void open(env::StreamId stream, std::string_view user) {
    open_session(core, stream, user);
    settle();
  }

  void read(env::StreamId stream, std::string_view bytes) {
    hear_session(core, stream, bytes);
    settle();
  }

  void closed(env::StreamId stream) {
    lose_session(core, stream);
    settle();
  }

  /// A client has room again: its turn may be due.
  void drained() { settle(); }

  void timer() {
    if (is_over() || core.phase == Phase::created) return;
    proceed_feed(core, work_in_turn);
    core.ontology_change.proceed(core, work_in_turn);
    // Only here, and not when a client's bytes come in: whoever has spoken meanwhile is heard before the next turn.
    if (core.phase == Phase::ready) take_turn(core);
    settle();
  }

  void datagram(env::InterfaceIndex interface, std::string_view source, std::span<const std::byte> bytes) {
    if (core.phase != Phase::claiming && core.phase != Phase::ready) return;
    if (hear(core, announcer, interface, source, bytes) == Announcer::Consequence::failed) fail();
    if (const auto complaint = core.seal.take_complaint()) core.log(base::LogLevel::warning, *complaint);
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

  void set_sealing(const sealing::Policy& policy) {
    if (core.phase == Phase::created || is_over()) return;
    core.seal.adopt(policy, core.env.now());
    announcer.show();
    settle();
  }

  void set_vocabulary(Vocabulary vocabulary) {
    core.ontology_change.begin(core, std::move(vocabulary));
    change_ontology();
  }

  void prepared(Vocabulary prepared) {
    if (!core.matcher.take_prepared(std::move(prepared))) return;
    core.ontology_change.take_up_expressions();
    change_ontology();
  }

  void ontology_failed(const std::vector<std::string>& lines) {
    core.ontology_state.fail(lines, core.env.now());
    core.ontology_change.give_up(core);
    change_ontology();
  }

 private:
  /// Begins at once, so that a small team has changed when this event is over.
  void change_ontology() {
    if (is_over()) return;
    core.ontology_change.proceed(core, work_in_turn);
    if (core.phase != Phase::created) settle();
  }

  void remember_interfaces() {
    interfaces.clear();
    for (const env::Interface& interface : core.env.interfaces()) interfaces.insert(interface.index);
  }

  void claimed() {
    if (core.phase == Phase::ready) {
      change_identifier(core, announcer.id());
    } else {
      core.id = announcer.id();  // nobody has stated anything: statements wait for it
    }
    core.phase = Phase::ready;
    core.is_changed = true;
    core.log(base::LogLevel::info,
             "participant " + to_string(core.id) + " (" + base::printable(core.name()) + ") is ready");
    proceed_feed(core, work_in_turn);
    take_turn(core);  // what waited for the identifier is announced with it
  }

  void fail() {
    core.log(base::LogLevel::error, announcer.failure());
    core.phase = Phase::failed;
    close_all_sessions(core, Error{ErrorCode::not_ready, "not ready: no identifier could be claimed, the daemon ends"});
  }

  /// Ends an event: everything that follows from it is handed to Env, and the timer is set.
  void settle() {
    if (core.phase == Phase::claiming || core.phase == Phase::ready) {
      expire(core, announcer);
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
      if (core.overlaps.take_waiting(core.env.now())) core.ontology_change.place_again();
      close_due_sessions(core);
      deliver_events(core);
      write_sessions(core);
    }
    if (!is_over()) announcer.announce();
    if (core.phase == Phase::stopping && announcer.is_finished()) core.phase = Phase::stopped;
    core.env.wake_at(is_over() ? base::never : std::min(announcer.due(), deadline()));
  }

  [[nodiscard]] base::Instant deadline() {
    if (core.phase == Phase::stopping) return base::never;
    if (is_turn_due(core) || is_feed_due(core) || core.ontology_change.is_under_way()) return core.env.now();
    return std::min(core.neighbours.next_deadline(), session_deadline(core));
  }
};

Participant::Participant(env::Env& env, Settings settings, Vocabulary vocabulary)
    : state_(std::make_unique<State>(env, std::move(settings), std::move(vocabulary))) {}

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
void Participant::on_stream_opened(env::StreamId stream, std::string_view user) { state_->open(stream, user); }
void Participant::on_stream_bytes(env::StreamId stream, std::string_view bytes) { state_->read(stream, bytes); }
void Participant::on_stream_drained(env::StreamId) { state_->drained(); }
void Participant::on_stream_closed(env::StreamId stream) { state_->closed(stream); }
void Participant::set_sealing(const sealing::Policy& policy) { state_->set_sealing(policy); }
void Participant::set_vocabulary(Vocabulary vocabulary) { state_->set_vocabulary(std::move(vocabulary)); }
const vocabulary::Vocabulary* Participant::wants_prepared() const {
  const Core& core = state_->core;
  return core.expressions.is_waiting(core.vocabulary()) ? &core.vocabulary() : nullptr;
}
bool Participant::uses_expressions() const { return state_->core.expressions.is_used(state_->core.vocabulary()); }
void Participant::on_prepared(Vocabulary prepared) { state_->prepared(std::move(prepared)); }
void Participant::ontology_begun() { state_->core.ontology_state.begin(state_->core.env.now()); }
void Participant::ontology_failed(const std::vector<std::string>& lines) { state_->ontology_failed(lines); }
void Participant::set_status_source(StatusSource source) { state_->core.status_source = std::move(source); }

}  // namespace geminga::participant
