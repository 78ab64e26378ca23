// One role of a task as it is written on the command line.
#ifndef GEMINGA_QUERY_NEED_HPP
#define GEMINGA_QUERY_NEED_HPP

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

namespace geminga::query {

/// `[COUNT] [shared]: EXPRESSION [where CONDITION]`, or an expression alone.
struct Need {
  std::string text;  ///< as it was written
  std::uint32_t count = 1;
  bool is_shared = false;  ///< a robot may hold it beside another
  std::string expression;
  std::string condition;  ///< about the attributes of the robot; empty: none
};

/// Reads one. The error says what is wrong and what to write. A colon belongs to the head if only a count and `shared`
/// are before it, so that `soccer:Robot` is an expression.
[[nodiscard]] std::expected<Need, std::string> read_need(std::string_view text);

/// The attribute by which robots are preferred.
struct Wish {
  std::string attribute;  ///< empty: there is none
  bool is_descending = false;
};

/// Reads `KEY asc` or `KEY desc`.
[[nodiscard]] std::expected<Wish, std::string> read_wish(std::string_view text);

}  // namespace geminga::query

#endif
