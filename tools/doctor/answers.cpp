#include "doctor/answers.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

namespace geminga::doctor {
namespace {

/// The participants with another ontology that are looked at, and the names of each that are tried.
constexpr std::size_t max_compared = 4;
constexpr std::size_t max_tried = 64;

/// The names that the ontology here does not know, of the services and requests of each participant with another one.
std::expected<void, ClientError> find_unknown(Client& client, const std::vector<Record>& requests, Answers& answers) {
  std::string_view own;
  for (const Record& one : answers.participants) {
    if (one["self"] == "1") own = one["ontology"];
  }
  for (const Record& one : answers.participants) {
    if (one["ontology"] == own || own == "-" || answers.unknown.size() == max_compared) continue;
    std::set<std::string> names;
    for (const std::vector<Record>* list : {&std::as_const(answers.services), &requests}) {
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

}  // namespace

std::expected<Answers, ClientError> ask(Client& client) {
  Answers answers;
  std::vector<Record> status;
  std::vector<Record> requests;
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
      {"requests", {}, &requests},
      {"requests", {{"unmatched", "1"}}, &answers.unmatched},
  };
  for (const auto& [kind, parameters, records] : questions) {
    auto answer = client.query(kind, parameters);
    if (!answer && answer.error().kind != ClientError::Kind::refused) return std::unexpected(answer.error());
    if (answer) *records = std::move(answer->records);
  }
  if (!status.empty()) answers.status = std::move(status.front());
  if (auto found = find_unknown(client, requests, answers); !found) return std::unexpected(found.error());
  return answers;
}

std::expected<void, ClientError> confirm_deaf(Client& client, Answers& answers) {
  const auto is_deaf = [](const Record& one) { return one["hears_us"] == "0"; };
  if (std::ranges::none_of(answers.participants, is_deaf)) return {};
  const double interval = std::strtod(std::string(answers.status["interval"]).c_str(), nullptr);
  const auto time = std::chrono::milliseconds(std::lround(1000 * std::clamp(3 * interval, 0.1, 6.0)));
  if (auto waited = client.next_event(time); !waited) return std::unexpected(waited.error());  // no event is asked for
  auto again = client.query("participants");
  if (!again) return std::unexpected(again.error());
  for (Record& one : answers.participants) {
    const bool is_so = std::ranges::any_of(
        again->records, [&](const Record& other) { return other["id"] == one["id"] && is_deaf(other); });
    if (!is_so) std::erase_if(one.fields, [](const auto& field) { return field.first == "hears_us"; });
  }
  return {};
}

}  // namespace geminga::doctor
