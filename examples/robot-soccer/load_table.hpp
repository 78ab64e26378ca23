// The table of what each module of a host sends and receives (load.tsv).
#ifndef GEMINGA_EXAMPLES_ROBOT_SOCCER_LOAD_TABLE_HPP
#define GEMINGA_EXAMPLES_ROBOT_SOCCER_LOAD_TABLE_HPP

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// One row of load.tsv.
struct Row {
  std::string kind, module, direction, concept_name, mode, scope;
  double hz = 0;
  std::size_t octets = 0;
  [[nodiscard]] bool is_inside() const { return scope == "host"; }
};

/// The rows of one kind of host.
inline std::vector<Row> read_rows(const std::string& file, const std::string& kind) {
  std::vector<Row> rows;
  std::ifstream table(file);
  for (std::string line; std::getline(table, line);) {
    Row row;
    std::istringstream fields(line);
    fields >> row.kind >> row.module >> row.direction >> row.concept_name >> row.mode >> row.scope >> row.hz >>
        row.octets;
    if (fields && row.kind == kind) rows.push_back(std::move(row));
  }
  return rows;
}

#endif
