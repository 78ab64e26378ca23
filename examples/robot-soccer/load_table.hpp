// The table of what each module of a host sends and receives (load.tsv).
#ifndef GEMINGA_EXAMPLES_ROBOT_SOCCER_LOAD_TABLE_HPP
#define GEMINGA_EXAMPLES_ROBOT_SOCCER_LOAD_TABLE_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using Clock = std::chrono::steady_clock;

/// One row of load.tsv.
struct Row {
  std::string kind, module, direction, concept_name, mode, scope;
  double hz = 0;
  std::size_t octets = 0;
  [[nodiscard]] bool is_for_others() const { return scope == "others"; }
  [[nodiscard]] Clock::duration period() const {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / hz));
  }
  /// The scope as publications and subscriptions state it.
  [[nodiscard]] std::string stated_scope() const { return is_for_others() ? "any,!host" : "host"; }
};

/// Ends the program: a daemon does not take what a row states.
[[noreturn]] inline void complain(const Row& row, const std::string& text) {
  std::cerr << "robot_load: " << row.module << ": " << row.concept_name << ": " << text << '\n';
  std::exit(2);
}

/// Messages of one module, or of a host.
struct Counts {
  std::uint64_t inside = 0;    ///< received from the same host
  std::uint64_t received = 0;  ///< from other hosts
  std::uint64_t sent = 0;      ///< of services that are for other hosts
  std::uint64_t missed = 0;
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
