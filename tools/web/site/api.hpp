// The questions that can be asked below /api/, and their documents.
#ifndef GEMINGA_WEB_SITE_API_HPP
#define GEMINGA_WEB_SITE_API_HPP

#include <boost/json/value.hpp>
#include <expected>
#include <string_view>

#include "web/asking/asker.hpp"
#include "web/site/response.hpp"

namespace geminga::web {

/// The question `/api/KIND?KEY=VALUE&...`: KIND and keys are those of `query` (src/discovery/participant/QUERIES.md). A
/// key without a meaning there is an error, so that a slip of a letter is not taken for an answer to what was asked.
[[nodiscard]] std::expected<Query, Response> read_question(std::string_view kind, const Parameters& parameters);

/// The field that names a record of a listing for its whole life; empty: the kind is no listing, and has no events.
[[nodiscard]] std::string_view key_of(std::string_view kind);

/// The document that geminga-query --json prints for this answer.
[[nodiscard]] boost::json::value document_of(const Query& query, const Answer& answer);

/// The response to a question that was not answered: the code of a refusal is its status; 503 where there is no daemon,
/// 504 where it is late.
[[nodiscard]] Response failure_of(const ClientError& error);

}  // namespace geminga::web

#endif
