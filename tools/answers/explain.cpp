#include "answers/explain.hpp"

#include <boost/json/array.hpp>

#include "shell/json.hpp"

namespace geminga::answers {

boost::json::object explain_document(const Names& names, const Answer& answer) {
  boost::json::object object{{"sub", names.sub},
                             {"super", names.super},
                             {"subsumed", is_subsumed(answer)},
                             {"axioms", shell::to_json(answer.records)}};
  // Where it is not subsumed, the end of the answer has the nearest common superclasses.
  for (const auto& member : shell::to_json(answer.end)) {
    if (member.key() == "common" || member.key() == "text") object[member.key()] = member.value();
  }
  return object;
}

}  // namespace geminga::answers
