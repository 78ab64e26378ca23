// One step after the other.
#include "discovery/participant/ontology_change.hpp"

#include <algorithm>
#include <string>

#include "discovery/participant/core.hpp"
#include "discovery/participant/own_services.hpp"
#include "discovery/participant/telling.hpp"

namespace geminga::participant {
namespace {

/// Ends the answers under way: what is left of them would be about classes of the former ontology.
void end_answers(Core& core) {
  for (const auto& [stream, session] : core.sessions) {
    if (!session->answering) continue;
    core.refuse(*session, session->answering->id,
                {ErrorCode::not_ready, "not ready: the ontology was changed meanwhile, ask again"});
    session->answering.reset();
  }
}

}  // namespace

void OntologyChange::begin(Core& core, vocabulary::Vocabulary next) {
  Next coming{std::move(next), core.ontology_state.readings};
  if (is_under_way()) {
    queued_ = std::move(coming);
  } else {
    start(core, std::move(coming));
  }
}

void OntologyChange::give_up(Core& core) {
  if (!core.vocabulary().is_loaded() && !is_under_way()) start(core, {});
}

void OntologyChange::start(Core& core, Next next) {
  reading_ = next.reading;
  core.matcher.begin_vocabulary(std::move(next.vocabulary));
  stage_ = Stage::filing;
}

void OntologyChange::take_up_expressions() {
  must_take_up_ = true;
  if (!is_under_way()) stage_ = Stage::matching;
}

void OntologyChange::place_again() {
  must_place_ = true;
  if (!is_under_way()) stage_ = Stage::matching;
}

void OntologyChange::proceed(Core& core, Work most) {
  const Work begin = core.work();
  while (is_under_way() && core.work() - begin < most) {
    core.overlaps.begin_step();
    switch (stage_) {
      case Stage::filing:
        file_or_put_in_force(core);
        break;
      case Stage::matching:
        match_or_restate(core);
        break;
      case Stage::restating:
        restate_or_end(core);
        break;
      case Stage::none:
        break;
    }
    deliver_events(core);
    core.worked += cost_of_entry;
  }
}

void OntologyChange::file_or_put_in_force(Core& core) {
  if (!core.matcher.file_next()) put_in_force(core);
}

void OntologyChange::put_in_force(Core& core) {
  // What was read since is told of when it comes into force itself.
  if (reading_ == core.ontology_state.readings) {
    if (!core.ontology_state.failure.empty())
      core.log(base::LogLevel::info, "ontology: read at last, the failure is mended");
    core.ontology_state.succeed();
  }
  end_answers(core);
  core.matcher.put_in_force();
  core.is_changed = true;  // the digest is announced
  must_take_up_ = false;   // all is resolved anew
  must_place_ = false;
  must_restate_ = true;
  stage_ = Stage::matching;
}

void OntologyChange::match_or_restate(Core& core) {
  if (core.matcher.rematch_next()) return;
  if (must_restate_ || must_take_up_) {
    list_statements(core, must_restate_);
    must_place_ = must_place_ || (must_take_up_ && !must_restate_);
    must_restate_ = must_take_up_ = false;
    stage_ = Stage::restating;
    return;
  }
  if (std::exchange(must_place_, false)) {
    core.matcher.place_again();
    return;
  }
  stage_ = Stage::none;
  if (queued_) start(core, std::move(*std::exchange(queued_, std::nullopt)));
}

void OntologyChange::list_statements(const Core& core, bool is_of_all) {
  restated_.clear();
  for (const auto& [stream, session] : core.sessions) {
    for (const auto& [number, stated] : session->publications) {
      if (is_of_all || stated.is_awaited) restated_.push_back({stream, number});
    }
    for (const auto& [number, stated] : session->subscriptions) {
      if (is_of_all || stated.is_awaited) restated_.push_back({stream, number});
    }
  }
  std::ranges::reverse(restated_);
}

void OntologyChange::restate_or_end(Core& core) {
  if (restated_.empty()) {
    stage_ = Stage::matching;  // for what has come up meanwhile
    return;
  }
  const Statement next = restated_.back();
  restated_.pop_back();
  const auto session = core.sessions.find(next.stream);
  if (session != core.sessions.end() && !session->second->is_leaving) restate(core, *session->second, next.number);
}

}  // namespace geminga::participant
