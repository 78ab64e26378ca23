#include "answers/ontology.hpp"

#include <boost/json/array.hpp>
#include <string_view>
#include <utility>

#include "answers/records.hpp"
#include "shell/json.hpp"

namespace geminga::answers {
namespace {

/// The records as objects in which the key `from` is called `to`.
boost::json::array renamed(const std::vector<Record>& records, std::string_view from, std::string_view to) {
  boost::json::array rows;
  for (const auto& record : records) {
    auto row = shell::to_json(record);
    row[to] = row[from];
    row.erase(from);
    rows.push_back(std::move(row));
  }
  return rows;
}

boost::json::array values(const std::vector<Record>& records, std::string_view key) {
  boost::json::array texts;
  for (const auto& record : records) texts.push_back(boost::json::string(record[key]));
  return texts;
}

}  // namespace

Ontology ontology_of(const Answer& answer) {
  const std::vector<Record> heads = with_field(answer, "loaded");
  Ontology ontology{heads.empty() ? Record{} : heads.front(),
                    with_field(answer, "file"),
                    with_field(answer, "left_out"),
                    with_field(answer, "gap"),
                    with_field(answer, "other"),
                    with_field(answer, "failed")};
  // The head counts what is left out under the same key.
  std::erase_if(ontology.left_out, [](const Record& record) { return !record["loaded"].empty(); });
  return ontology;
}

boost::json::object ontology_document(const Ontology& ontology) {
  boost::json::object object;
  const auto head = shell::to_json(ontology.head);
  for (const auto* key : {"loaded", "digest", "classes"}) {
    if (head.contains(key)) object[key] = head.at(key);
  }
  if (!ontology.head["complete"].empty()) object["complete"] = ontology.head["complete"] == "1";
  object["contradiction"] = ontology.head["contradiction"] == "1";
  object["files"] = shell::to_json(ontology.files);
  object["left_out"] = renamed(ontology.left_out, "left_out", "construct");
  object["gaps"] = values(ontology.gaps, "gap");
  object["others"] = renamed(ontology.others, "other", "participant");
  object["loading"] = ontology.head["loading"] == "1";
  object["failed"] = values(ontology.failures, "failed");
  return object;
}

}  // namespace geminga::answers
