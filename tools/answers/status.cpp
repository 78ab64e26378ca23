#include "answers/status.hpp"

#include "shell/json.hpp"

namespace geminga::answers {

boost::json::object status_document(const Answer& answer) {
  boost::json::object object;
  for (const auto& record : answer.records) {
    for (const auto& member : shell::to_json(record)) object[member.key()] = member.value();
  }
  return object;
}

}  // namespace geminga::answers
