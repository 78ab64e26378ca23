#include "discovery/participant/participant.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "discovery/participant/owners.hpp"

namespace geminga::participant {

Participant::Participant(env::Env& env, Settings settings, Vocabulary vocabulary)
    : owners_(std::make_unique<Owners>(env, std::move(settings), std::move(vocabulary))) {}

Participant::~Participant() = default;

void Participant::start() {
  Owners& all = *owners_;
  GEMINGA_ASSERT(all.phase == Phase::created);
  all.started = all.env.now();
  all.phase = Phase::claiming;
  remember_interfaces();
  all.air.start();
  settle();
}

void Participant::stop() {
  Owners& all = *owners_;
  if (is_over() || all.phase == Phase::stopping) return;
  const Phase was = std::exchange(all.phase, Phase::stopping);
  all.clients.close_all(was == Phase::ready
                            ? std::nullopt
                            : std::optional(Error{ErrorCode::not_ready, "not ready: the daemon is stopping"}));
  all.air.announcer().stop();
  settle();
}

bool Participant::is_over() const { return owners_->phase == Phase::stopped || owners_->phase == Phase::failed; }

bool Participant::is_stopped() const { return is_over(); }

bool Participant::is_ready() const { return owners_->phase == Phase::ready; }

std::string Participant::failure() const {
  return owners_->phase == Phase::failed ? owners_->air.announcer().failure() : std::string();
}

void Participant::on_stream_opened(env::StreamId stream, std::string_view user) {
  if (is_over() || owners_->phase == Phase::stopping) {
    owners_->clients.refuse(stream, {ErrorCode::not_ready, "not ready: the daemon is stopping"});
  } else {
    owners_->clients.open(stream, user);
  }
  settle();
}

void Participant::on_stream_bytes(env::StreamId stream, std::string_view bytes) {
  owners_->clients.hear(stream, bytes);
  settle();
}

void Participant::on_stream_closed(env::StreamId stream) {
  owners_->clients.lose(stream);
  settle();
}

/// The client has room again: its turn may be due.
void Participant::on_stream_drained(env::StreamId) { settle(); }

void Participant::on_timer() {
  Owners& all = *owners_;
  if (is_over() || all.phase == Phase::created) return;
  proceed_feed();
  proceed_ontology_change();
  // Only here, and not when a client's octets come in: a client that has spoken meanwhile is heard before the next
  // turn.
  if (all.phase == Phase::ready) all.clients.turns().take();
  settle();
}

void Participant::on_datagram(env::InterfaceIndex interface, std::string_view source,
                              std::span<const std::byte> datagram) {
  Owners& all = *owners_;
  if (all.phase != Phase::claiming && all.phase != Phase::ready) return;
  const auto consequence = all.air.hear(interface, source, datagram, all.knowledge.self.id);
  if (consequence) {
    feed();
    all.knowledge.resume_postponed_expressions();
  }
  if (consequence == Announcer::Consequence::failed) fail();
  settle();
}

void Participant::on_interfaces_changed() {
  Owners& all = *owners_;
  if (all.phase == Phase::created || is_over()) return;
  const std::set<env::InterfaceIndex> before = all.interfaces;
  remember_interfaces();
  for (const env::InterfaceIndex index : before) {
    if (!all.interfaces.contains(index)) all.air.forget_interface(index);
  }
  feed();
  all.air.announcer().changed();
  settle();
}

void Participant::on_routes_changed() {
  if (owners_->phase == Phase::created || is_over()) return;
  owners_->air.judge_reach();
  feed();
  settle();
}

void Participant::shed() {
  Owners& all = *owners_;
  if (all.phase != Phase::claiming && all.phase != Phase::ready) return;
  all.air.shed();
  feed();
  settle();
}

void Participant::set_sealing(const sealing::Policy& policy) {
  if (owners_->phase == Phase::created || is_over()) return;
  const bool is_other = owners_->air.seal().policy() != policy;
  owners_->air.adopt(policy);
  if (is_other) owners_->clients.keys().change();
  settle();
}

void Participant::describe(const std::string& expression) {
  if (is_over()) return;
  owners_->clients.own().describe(expression);
  if (owners_->phase != Phase::created) settle();
}

/// Logs once why a description is not in force.
void Participant::report_description() {
  const std::string& problem = owners_->clients.own().description().problem();
  if (std::exchange(owners_->description_problem, problem) == problem || problem.empty()) return;
  owners_->env.log().write(base::LogLevel::warning, "describe: " + problem, {.code = "description"});
}

void Participant::set_vocabulary(Vocabulary vocabulary, const std::vector<std::string>& left_out) {
  owners_->knowledge.ontology_change.begin(std::move(vocabulary), {left_out, owners_->env.now()});
  change_ontology();
}

const vocabulary::Vocabulary* Participant::wants_prepared() const {
  const Knowledge& knowledge = owners_->knowledge;
  return knowledge.resolver.is_waiting() ? &knowledge.vocabulary() : nullptr;
}

bool Participant::uses_expressions() const {
  return owners_->knowledge.expressions.is_used(owners_->knowledge.vocabulary());
}

void Participant::on_prepared(Vocabulary prepared) {
  if (!owners_->knowledge.matcher.vocabulary_change().take_prepared(std::move(prepared))) return;
  owners_->knowledge.ontology_change.take_up_expressions();
  change_ontology();
}

void Participant::ontology_begun() { owners_->knowledge.reading.begin(owners_->env.now()); }

void Participant::ontology_failed(const std::vector<std::string>& lines) {
  owners_->knowledge.reading.fail(lines, owners_->env.now());
  owners_->knowledge.ontology_change.give_up();
  change_ontology();
}

void Participant::set_status_source(StatusSource source) { owners_->status_source = std::move(source); }

void Participant::change_ontology() {
  if (is_over()) return;
  proceed_ontology_change();
  if (owners_->phase != Phase::created) settle();
}

void Participant::remember_interfaces() {
  owners_->interfaces.clear();
  for (const env::Interface& interface : owners_->env.interfaces()) owners_->interfaces.insert(interface.index);
}

void Participant::claimed() {
  Owners& all = *owners_;
  Knowledge& knowledge = all.knowledge;
  if (all.phase == Phase::ready) {
    // All that our peers have stated leaves under the former identifier and returns under this one.
    knowledge.matcher.begin_departure(knowledge.self.id, matching::Reason::renamed);
    all.clients.reentry().list_returning();
  }
  knowledge.self.id = all.air.announcer().id();
  if (all.phase != Phase::ready) all.clients.own().begin_description(all.settings.description);
  all.phase = Phase::ready;
  all.air.announcer().changed();
  const std::string who = to_string(knowledge.self.id);
  const std::string line = "participant " + who + " (" + base::printable(knowledge.self.name()) + ") is ready";
  all.env.log().write(base::LogLevel::info, line, {.participant = who, .code = "ready"});
  proceed_feed();
  all.clients.turns().take();  // what waited for the identifier is announced with it
}

void Participant::fail() {
  Owners& all = *owners_;
  all.env.log().write(base::LogLevel::error, all.air.announcer().failure(), {.code = "no_identifier"});
  all.phase = Phase::failed;
  all.clients.close_all(Error{ErrorCode::not_ready, "not ready: no identifier could be claimed, the daemon ends"});
}

bool Participant::is_feed_due() const {
  return owners_->knowledge.is_behind() || owners_->clients.reentry().has_returning();
}

void Participant::feed() {
  const bool is_behind = is_feed_due();
  owners_->knowledge.queue(owners_->air.take_changes());
  // A feed that is behind already goes on in turns, so that a flood of datagrams leaves time for the turns of clients.
  if (!is_behind) proceed_feed();
}

void Participant::proceed_feed() {
  Knowledge& knowledge = owners_->knowledge;
  Clients& clients = owners_->clients;
  while (is_feed_due() && knowledge.work.done() - owners_->before_event < work_in_turn) {
    knowledge.overlaps.begin_step();
    if (!knowledge.matcher.take_step() && !clients.reentry().return_next()) knowledge.take_next_change();
    clients.telling().deliver_events();
    knowledge.work.add(cost_of_entry);
  }
}

void Participant::proceed_ontology_change() {
  Owners& all = *owners_;
  OntologyChange& change = all.knowledge.ontology_change;
  const Work begin = all.knowledge.work.done();
  while (change.is_under_way() && all.knowledge.work.done() - begin < work_in_change) {
    all.knowledge.overlaps.begin_step();
    switch (change.step()) {
      case OntologyChange::Due::nothing:
        break;
      case OntologyChange::Due::came_into_force:
        all.clients.end_answers();
        all.air.announcer().changed();  // the digest is announced
        break;
      case OntologyChange::Due::list_all:
        all.clients.reentry().list_for_restating(true);
        break;
      case OntologyChange::Due::list_awaited:
        all.clients.reentry().list_for_restating(false);
        break;
      case OntologyChange::Due::restate_next:
        if (!all.clients.reentry().restate_next()) change.end_restating();
        break;
    }
    all.clients.telling().deliver_events();
    all.knowledge.work.add(cost_of_entry);
  }
}

void Participant::settle() {
  Owners& all = *owners_;
  if (all.phase == Phase::claiming || all.phase == Phase::ready) {
    all.air.expire();
    feed();
    all.air.announcer().end_contest();
    switch (all.air.announcer().step_claim()) {
      case Announcer::Step::nothing:
        break;
      case Announcer::Step::claimed:
        claimed();
        break;
      case Announcer::Step::failed:
        fail();
        break;
    }
    const vocabulary::Vocabulary& ours = all.knowledge.vocabulary();
    const bool is_ours_to_come = !ours.is_loaded() && all.knowledge.reading.is_loading;
    if (!is_ours_to_come) all.ontology_watch.look(all.air.table().neighbours(), ours.digest(), all.env);
    all.knowledge.resume_postponed_overlaps();
    all.clients.close_due();
    all.clients.telling().deliver_events();
    all.clients.write();
  }
  report_description();
  const bool is_changed = all.clients.own().take_change();
  if (all.knowledge.matcher.take_choice_change() || is_changed) all.air.announcer().changed();
  all.air.beyond().proceed();
  if (!is_over()) all.air.announcer().announce();
  if (all.phase == Phase::stopping && all.air.announcer().is_finished()) all.phase = Phase::stopped;
  all.before_event = all.knowledge.work.done();
  all.env.wake_at(is_over() ? base::never : std::min(all.air.announcer().due(), deadline()));
}

base::Instant Participant::deadline() const {
  Owners& all = *owners_;
  if (all.phase == Phase::stopping) return base::never;
  const bool is_turn_due = all.phase == Phase::ready && all.clients.turns().is_due();
  if (is_turn_due || is_feed_due() || all.knowledge.ontology_change.is_under_way()) return all.env.now();
  return std::min(
      {all.air.table().next_deadline(), all.air.beyond().due(), all.clients.deadline(), all.knowledge.next_due()});
}

}  // namespace geminga::participant
