#include "web/site/api.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "answers/explain.hpp"
#include "answers/ontology.hpp"
#include "answers/security.hpp"
#include "answers/status.hpp"
#include "answers/why.hpp"
#include "shell/json.hpp"

namespace geminga::web {
namespace {

using Keys = std::span<const std::string_view>;

constexpr auto filter_keys = std::to_array<std::string_view>(
    {"concept", "representation", "id", "text", "mode", "provider", "filter", "unused"});
constexpr auto request_filter_keys = std::to_array<std::string_view>(
    {"concept", "representation", "id", "text", "mode", "provider", "filter", "unmatched"});
constexpr auto match_keys = std::to_array<std::string_view>(
    {"concept", "representation", "id", "text", "degree", "mode", "where", "provider", "limit", "convert"});
constexpr auto explain_keys = std::to_array<std::string_view>({"sub", "super"});
constexpr auto why_keys = std::to_array<std::string_view>({"subscription",
                                                           "service",
                                                           "concept",
                                                           "representation",
                                                           "id",
                                                           "text",
                                                           "mode",
                                                           "match",
                                                           "provider",
                                                           "favour",
                                                           "prefer",
                                                           "rank",
                                                           "where",
                                                           "protocol",
                                                           "scope",
                                                           "limit",
                                                           "convert",
                                                           "offer.concept",
                                                           "offer.representation",
                                                           "offer.id",
                                                           "offer.text",
                                                           "offer.mode",
                                                           "offer.address",
                                                           "offer.port",
                                                           "offer.protocol",
                                                           "offer.priority",
                                                           "offer.scope",
                                                           "offer.for",
                                                           "offer.provider"});
/// Before the name of an attribute, in `why`.
constexpr auto attribute_prefixes = std::to_array<std::string_view>({"attr.", "offer.attr."});

struct Kind {
  std::string_view word;
  std::string_view key;  ///< of its records, for a listing
  Keys keys;
};

constexpr auto all_kinds = std::to_array<Kind>({{"participants", "id", {}},
                                                {"services", "service", filter_keys},
                                                {"requests", "subscription", request_filter_keys},
                                                {"match", "service", match_keys},
                                                {"explain", "", explain_keys},
                                                {"why", "", why_keys},
                                                {"ontology", "", {}},
                                                {"status", "", {}},
                                                {"security", "", {}}});

const Kind* find_kind(std::string_view word) {
  const auto found = std::ranges::find(all_kinds, word, &Kind::word);
  return found == all_kinds.end() ? nullptr : &*found;
}

bool takes(const Kind& kind, std::string_view key) {
  if (std::ranges::find(kind.keys, key) != kind.keys.end()) return true;
  if (kind.word != "why" || !std::ranges::all_of(key, [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
               c == '-';
      })) {
    return false;
  }
  return std::ranges::any_of(attribute_prefixes, [&](std::string_view prefix) {
    return key.size() > prefix.size() && key.starts_with(prefix);
  });
}

template <typename Words>
std::string listed(const Words& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text.empty() ? "none" : text;
}

answers::Question question_of(const Parameters& parameters) {
  answers::Question question;
  for (const auto& [key, value] : parameters) {
    if (key == "subscription") {
      question.subscription = value;
    } else if (key == "service") {
      question.service = value;
    } else {
      question.parameters.emplace_back(key, value);
    }
  }
  return question;
}

std::string value_of(const Parameters& parameters, std::string_view key) {
  const auto found = std::ranges::find(parameters, key, &Parameters::value_type::first);
  return found == parameters.end() ? "" : found->second;
}

}  // namespace

std::vector<std::string> kinds() {
  std::vector<std::string> words;
  for (const Kind& kind : all_kinds) words.emplace_back(kind.word);
  return words;
}

std::string_view key_of(std::string_view kind) {
  const Kind* found = find_kind(kind);
  return found == nullptr ? std::string_view() : found->key;
}

std::expected<Query, Response> read_question(std::string_view word, const Parameters& parameters) {
  const Kind* kind = find_kind(word);
  if (kind == nullptr) return std::unexpected(failure(404, "there is no such question: there are " + listed(kinds())));
  for (const auto& [key, value] : parameters) {
    if (!takes(*kind, key)) {
      return std::unexpected(
          failure(400, "no key '" + key + "' goes with " + std::string(word) + ": these do: " + listed(kind->keys)));
    }
    if (value.empty()) return std::unexpected(failure(400, key + "= has nothing behind it"));
  }
  return Query{std::string(word), parameters};
}

boost::json::value document_of(const Query& query, const Answer& answer) {
  if (query.kind == "status") return answers::status_document(answer);
  if (query.kind == "security") return answers::security_document(answers::security_of(answer));
  if (query.kind == "ontology") return answers::ontology_document(answers::ontology_of(answer));
  if (query.kind == "why") return answers::why_document(question_of(query.parameters), answer);
  if (query.kind == "explain") {
    const answers::Names names{value_of(query.parameters, "sub"), value_of(query.parameters, "super")};
    return answers::explain_document(names, answer);
  }
  return shell::to_json(answer.records);
}

Response failure_of(const ClientError& error) {
  switch (error.kind) {
    case ClientError::Kind::wrong_use:
      return failure(400, error.text);
    case ClientError::Kind::unreachable:
    case ClientError::Kind::closed:
      return failure(503, error.text);
    case ClientError::Kind::timed_out:
      return failure(504, error.text);
    case ClientError::Kind::refused:
      break;
  }
  const auto code = static_cast<unsigned>(error.code);
  Response refusal = failure(code >= 400 && code <= 599 ? code : 502, error.text);
  if (error.code == ErrorCode::too_many) refusal.fields.emplace_back("Retry-After", "1");
  return refusal;
}

}  // namespace geminga::web
