// Literals of xsd:dateTime and xsd:date in SPARQL's expressions.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_FORMULAS_TIMES_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_FORMULAS_TIMES_HPP

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

#include "reasoning/syntax/graph/axioms/node.hpp"

namespace geminga::graph {

/// The parts of a time as they are written.
struct Instant {
  std::int64_t year = 0;
  int month = 0;
  int day = 0;
  int hours = 0;
  int minutes = 0;
  std::string seconds;       ///< with a fraction
  std::optional<int> zone;   ///< minutes east of Greenwich
  std::string written_zone;  ///< Z, or as +01:00; empty without one
  bool is_date = false;

  /// Seconds since 1970 as if in Greenwich, without the fraction.
  [[nodiscard]] std::int64_t local_seconds() const;
  /// The fraction of a second in nanoseconds.
  [[nodiscard]] std::int64_t nanoseconds() const;
};

/// The time of a literal; nothing for another one, or for a day that does not exist.
[[nodiscard]] std::optional<Instant> instant_of(const Node& node);
/// The order in time. Unordered are a date and a time, and one with and one without a zone unless fourteen hours do not
/// matter (XML Schema 1.1 part 2, section E.3.3).
[[nodiscard]] std::partial_ordering compare(const Instant& a, const Instant& b);

}  // namespace geminga::graph

#endif
