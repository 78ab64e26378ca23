// The question and the answer of `query why`, and the answer as a JSON document.
#ifndef GEMINGA_ANSWERS_WHY_HPP
#define GEMINGA_ANSWERS_WHY_HPP

#include <boost/json/object.hpp>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::answers {

/// The parameters of `query why` (src/discovery/participant/QUERIES.md).
struct Question {
  std::string subscription;
  std::string service;
  std::vector<std::pair<std::string, std::string>> parameters;  ///< beside these two

  [[nodiscard]] const std::string* find(std::string_view key) const;
  [[nodiscard]] bool has_any(std::initializer_list<std::string_view> keys) const;
  [[nodiscard]] bool has_service() const;
  [[nodiscard]] bool has_request() const;
};

/// The subject of an answer.
enum class About : std::uint8_t { pair, request, service };

[[nodiscard]] About about(const Question& question);

/// Whether the pair fits and the consumer has better providers.
[[nodiscard]] inline bool is_outranked(const Answer& answer) { return answer.end["outranked"] == "1"; }

[[nodiscard]] boost::json::object why_document(const Question& question, const Answer& answer);

}  // namespace geminga::answers

#endif
