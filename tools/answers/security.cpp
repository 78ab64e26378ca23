#include "answers/security.hpp"

#include <boost/json/array.hpp>
#include <utility>

#include "answers/records.hpp"
#include "shell/json.hpp"

namespace geminga::answers {

Security security_of(const Answer& answer) {
  const std::vector<Record> heads = with_field(answer, "mode");
  return {heads.empty() ? Record{} : heads.front(), with_field(answer, "datagrams"), with_field(answer, "participant"),
          with_field(answer, "source")};
}

boost::json::object security_document(const Security& security) {
  boost::json::object object = shell::to_json(security.head);
  if (!object.contains("keys")) object["keys"] = boost::json::array();
  object["datagrams"] = shell::to_json(security.datagrams);
  boost::json::array participants = shell::to_json(security.participants);
  for (auto& participant : participants) {
    for (const char* list : {"keys", "lacks"}) {
      if (!participant.as_object().contains(list)) participant.as_object()[list] = boost::json::array();
    }
  }
  object["participants"] = std::move(participants);
  object["rejected"] = shell::to_json(security.rejected);
  return object;
}

}  // namespace geminga::answers
