#include "discovery/participant/knowledge/ontology_change.hpp"

#include <utility>

namespace geminga::participant {

void OntologyChange::begin(vocabulary::Vocabulary next, LeftOut left_out) {
  Next coming{std::move(next), reading_.begun, std::move(left_out)};
  if (is_under_way()) {
    queued_ = std::move(coming);
  } else {
    start(std::move(coming));
  }
}

void OntologyChange::give_up() {
  if (!editions_.vocabulary().is_loaded() && !is_under_way()) start({});
}

void OntologyChange::start(Next next) {
  from_reading_ = next.reading;
  left_out_ = std::move(next.left_out);
  filing_.begin(next.vocabulary);
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

OntologyChange::Due OntologyChange::step() {
  switch (stage_) {
    case Stage::filing:
      if (filing_.file_next()) return Due::nothing;
      put_in_force();
      return Due::came_into_force;
    case Stage::matching:
      return match_or_restate();
    case Stage::restating:
      return Due::restate_next;
    case Stage::none:
      break;
  }
  return Due::nothing;
}

void OntologyChange::put_in_force() {
  // A later reading is reported when its own ontology comes into force.
  if (from_reading_ == reading_.begun) {
    const bool is_whole = left_out_.lines.empty();
    if (is_whole && !reading_.failure.empty())
      log_.write(base::LogLevel::info, "ontology: read at last, the failure is mended");
    reading_.succeed();
    if (!is_whole) reading_.fail(left_out_.lines, left_out_.at);
  }
  filing_.put_in_force();
  must_take_up_ = false;  // all statements are resolved anew
  must_place_ = false;
  must_restate_ = true;
  stage_ = Stage::matching;
}

OntologyChange::Due OntologyChange::match_or_restate() {
  if (filing_.rematch_next()) return Due::nothing;
  if (must_restate_ || must_take_up_) {
    const Due due = must_restate_ ? Due::list_all : Due::list_awaited;
    must_place_ = must_place_ || !must_restate_;
    must_restate_ = must_take_up_ = false;
    stage_ = Stage::restating;
    return due;
  }
  if (std::exchange(must_place_, false)) {
    filing_.place_again();
    return Due::nothing;
  }
  stage_ = Stage::none;
  if (queued_) start(std::move(*std::exchange(queued_, std::nullopt)));
  return Due::nothing;
}

}  // namespace geminga::participant
