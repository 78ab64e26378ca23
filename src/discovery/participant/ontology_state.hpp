// What is known of the team's ontology beside the one in force: whether another is being read, and why reading failed.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_ONTOLOGY_STATE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_ONTOLOGY_STATE_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "base/time.hpp"

namespace geminga::participant {

/// Lines of a failure that are kept, and octets of each; the log has them all.
inline constexpr std::size_t max_failure_lines = 16;
inline constexpr std::size_t max_failure_bytes = 400;

/// The owner of a participant reads ontologies and says how it goes; queries show it until it is mended.
struct OntologyState {
  bool is_loading = false;
  std::uint64_t readings = 0;        ///< that were begun
  base::Instant begun_at{};          ///< meaningful while it is loading
  std::vector<std::string> failure;  ///< why the last reading failed, made printable; empty: it did not
  base::Instant failed_at{};         ///< meaningful where it failed

  void begin(base::Instant now) {
    is_loading = true;
    ++readings;
    begun_at = now;
  }
  void fail(const std::vector<std::string>& lines, base::Instant now) {
    is_loading = false;
    failed_at = now;
    failure.clear();
    for (const std::string& line : lines) {
      if (failure.size() == max_failure_lines) break;
      failure.push_back(base::printable(line, max_failure_bytes));
    }
    if (failure.empty()) failure.emplace_back("reading failed, and nothing says why");
  }
  void succeed() {
    is_loading = false;
    failure.clear();
  }
};

}  // namespace geminga::participant

#endif
