#include "doctor/answers.hpp"

#include <chrono>
#include <set>
#include <tuple>
#include <utility>

namespace geminga::doctor {
namespace {

/// The participants with another ontology that are looked at, and the names of each that are tried.
constexpr std::size_t max_compared = 4;
constexpr std::size_t max_tried = 64;

double wall_clock() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

std::expected<void, ClientError> find_unknown(Client& client, Answers& answers) {
  std::string_view own;
  for (const Record& one : answers.participants) {
    if (one["self"] == "1") own = one["ontology"];
  }
  for (const Record& one : answers.participants) {
    if (one["ontology"].empty() || one["ontology"] == own || own.empty() || own == "-" ||
        answers.unknown.size() == max_compared)
      continue;
    std::set<std::string> names;
    for (const std::vector<Record>* list : {&std::as_const(answers.services), &std::as_const(answers.requests)}) {
      for (const Record& entry : *list) {
        const std::string_view owner = entry["provider"].empty() ? entry["consumer"] : entry["provider"];
        if (!owner.starts_with(std::string(one["id"]) + '/')) continue;
        if (!entry["concept"].empty()) names.emplace(entry["concept"]);
      }
    }
    UnknownNames unknown{.participant = std::string(one["id"]), .names = {}};
    std::size_t tried = 0;
    for (const std::string& name : names) {
      if (unknown.names.size() == max_unknown_names || ++tried > max_tried) break;
      auto known = client.query("match", {{"concept", name}, {"limit", "1"}});
      if (known) continue;
      if (known.error().kind != ClientError::Kind::refused) return std::unexpected(known.error());
      unknown.names.push_back(name);
    }
    answers.unknown.push_back(std::move(unknown));
  }
  return {};
}

std::expected<Answers, ClientError> ask(Client& client) {
  Answers answers;
  std::vector<Record> status;
  struct Question {
    const char* kind;
    std::vector<std::pair<std::string, std::string>> parameters;
    std::vector<Record>* records;
  };
  const Question questions[] = {
      {"status", {}, &status},
      {"interfaces", {}, &answers.interfaces},
      {"participants", {}, &answers.participants},
      {"security", {}, &answers.security},
      {"ontology", {}, &answers.ontology},
      {"services", {}, &answers.services},
      {"requests", {}, &answers.requests},
      {"requests", {{"unmatched", "1"}}, &answers.unmatched},
  };
  for (const auto& [kind, parameters, records] : questions) {
    const double from = wall_clock();
    auto answer = client.query(kind, parameters);
    if (records == &status) std::tie(answers.asked_from, answers.asked_until) = std::pair(from, wall_clock());
    if (!answer && answer.error().kind != ClientError::Kind::refused) return std::unexpected(answer.error());
    if (answer) *records = std::move(answer->records);
  }
  if (!status.empty()) answers.status = std::move(status.front());
  return answers;
}

}  // namespace geminga::doctor
