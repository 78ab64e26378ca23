// The questions that a program may pass on to the daemon for others, with their keys and their documents: those of
// geminga-web and of geminga-query mcp.
#ifndef GEMINGA_ANSWERS_QUESTIONS_HPP
#define GEMINGA_ANSWERS_QUESTIONS_HPP

#include <boost/json/value.hpp>
#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::answers {

using Parameters = std::vector<std::pair<std::string, std::string>>;

/// A parameter of a question (src/discovery/participant/QUERIES.md).
struct Key {
  enum class Type : std::uint8_t { text, number, flag };
  std::string_view name;
  std::string_view meaning;  ///< one sentence without its full stop
  Type type = Type::text;
};

/// A kind of question.
struct Kind {
  std::string_view word;
  std::string_view meaning;  ///< one or two sentences
  std::string_view id;       ///< the field that names a record for its whole life; empty: the answer is no listing
  std::span<const Key> keys;
  bool takes_attributes = false;  ///< also attr.NAME and offer.attr.NAME
};

/// All kinds, in their order. None of them changes anything.
[[nodiscard]] std::span<const Kind> kinds();
/// Null: there is no such kind.
[[nodiscard]] const Kind* find_kind(std::string_view word);
/// The words of all kinds, separated by commas.
[[nodiscard]] std::string kind_words();

/// An error in one line for a key without a meaning there, so that a slip of a letter is not taken for an answer to
/// what was asked, and for a value that is empty.
[[nodiscard]] std::expected<void, std::string> check(const Kind& kind, const Parameters& parameters);

/// The document that geminga-query --json prints for this answer.
[[nodiscard]] boost::json::value document_of(std::string_view kind, const Parameters& parameters, const Answer& answer);

}  // namespace geminga::answers

#endif
