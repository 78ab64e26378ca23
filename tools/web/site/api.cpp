#include "web/site/api.hpp"

#include "answers/questions.hpp"

namespace geminga::web {

std::string_view key_of(std::string_view kind) {
  const answers::Kind* found = answers::find_kind(kind);
  return found == nullptr ? std::string_view() : found->id;
}

std::expected<Query, Response> read_question(std::string_view word, const Parameters& parameters) {
  const answers::Kind* kind = answers::find_kind(word);
  if (kind == nullptr) {
    return std::unexpected(failure(404, "there is no such question: there are " + answers::kind_words()));
  }
  if (const auto checked = answers::check(*kind, parameters); !checked) {
    return std::unexpected(failure(400, checked.error()));
  }
  return Query{std::string(word), parameters};
}

boost::json::value document_of(const Query& query, const Answer& answer) {
  return answers::document_of(query.kind, query.parameters, answer);
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
