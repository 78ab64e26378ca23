#include "answers/why.hpp"

#include <algorithm>
#include <array>
#include <boost/json/array.hpp>
#include <sstream>

#include "shell/json.hpp"

namespace geminga::answers {
namespace {

constexpr std::string_view offer_prefix = "offer.";

/// The fields of a record, with the axioms of the proof one by one.
boost::json::object object_of(const Record& record) {
  auto object = shell::to_json(record);
  if (record["proof"].empty()) return object;
  boost::json::array proof;
  std::istringstream lines{std::string(record["proof"])};
  for (std::string line; std::getline(lines, line);) proof.emplace_back(line);
  object["proof"] = std::move(proof);
  return object;
}

boost::json::array array_of(const std::vector<Record>& records) {
  boost::json::array array;
  for (const Record& record : records) array.push_back(object_of(record));
  return array;
}

/// The question: the words of existing requests and services, and the fields of hypothetical ones.
boost::json::object asked(const Question& question) {
  boost::json::object object;
  boost::json::object request;
  boost::json::object offer;
  if (!question.subscription.empty()) object["subscription"] = question.subscription;
  if (!question.service.empty()) object["service"] = question.service;
  for (const auto& [key, value] : question.parameters) {
    if (key.starts_with(offer_prefix)) {
      offer[key.substr(offer_prefix.size())] = value;
    } else {
      request[key] = value;
    }
  }
  if (!request.empty()) object["request"] = std::move(request);
  if (!offer.empty()) object["offer"] = std::move(offer);
  return object;
}

}  // namespace

const std::string* Question::find(std::string_view key) const {
  const auto at = std::ranges::find(parameters, key, &std::pair<std::string, std::string>::first);
  return at == parameters.end() ? nullptr : &at->second;
}

bool Question::has_any(std::initializer_list<std::string_view> keys) const {
  return std::ranges::any_of(keys, [&](std::string_view key) { return find(key) != nullptr; });
}

bool Question::has_service() const {
  return !service.empty() ||
         std::ranges::any_of(parameters, [](const auto& one) { return one.first.starts_with(offer_prefix); });
}

bool Question::has_request() const {
  return !subscription.empty() ||
         std::ranges::any_of(parameters, [](const auto& one) { return !one.first.starts_with(offer_prefix); });
}

About about(const Question& question) {
  if (!question.has_service()) return About::request;
  return question.has_request() ? About::pair : About::service;
}

boost::json::object why_document(const Question& question, const Answer& answer) {
  boost::json::object object = asked(question);
  if (about(question) == About::pair) {
    object["matches"] = answer.end["matches"] == "1";
    object["outranked"] = is_outranked(answer);
  }
  for (const auto& member : shell::to_json(answer.end)) {
    if (member.key() != "count" && !object.contains(member.key())) object[member.key()] = member.value();
  }
  constexpr auto lists = std::to_array<const char*>({"checks", "services", "subscriptions"});
  object[lists[std::to_underlying(about(question))]] = array_of(answer.records);
  return object;
}

}  // namespace geminga::answers
