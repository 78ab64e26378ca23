// How reading the team's ontology goes: whether it is being read, and why the last reading failed.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_ONTOLOGY_READING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_ONTOLOGY_READING_HPP

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

/// The owner of a participant reads ontologies and reports how it goes; queries show the report until it is mended.
struct OntologyReading {
  bool is_loading = false;
  std::uint64_t begun = 0;           ///< how many readings were begun
  base::Instant begun_at{};          ///< of the last; meaningful while it is loading
  std::vector<std::string> failure;  ///< why the last reading failed, made printable; empty: it did not fail
  base::Instant failed_at{};         ///< meaningful where it failed

  void begin(base::Instant now) {
    is_loading = true;
    ++begun;
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
