// The rows of a SPARQL answer as a table, JSON, CSV or TSV.
#ifndef GEMINGA_ONTOLOGY_QUERY_OUTPUT_HPP
#define GEMINGA_ONTOLOGY_QUERY_OUTPUT_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/graph/query.hpp"

namespace geminga::ontology {

enum class Rows : std::uint8_t {
  table,  ///< for people: aligned, with short names
  json,   ///< SPARQL 1.1 Query Results JSON Format
  csv,    ///< SPARQL 1.1 Query Results CSV and TSV Formats
  tsv,
};

[[nodiscard]] std::optional<Rows> find_rows(std::string_view name);

/// Writes the rows, or the truth, of an answer.
[[nodiscard]] std::string written(const graph::Answer& answer, Rows rows,
                                  const std::function<std::string(std::string_view)>& short_name);

}  // namespace geminga::ontology

#endif
