// One thing that is wrong: what it is, how it was seen, and what to do.
#ifndef GEMINGA_DOCTOR_FINDING_HPP
#define GEMINGA_DOCTOR_FINDING_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace geminga::doctor {

/// The worst first.
enum class Severity : std::uint8_t {
  failure,  ///< something does not work
  risk,     ///< something works and may fail
};

struct Finding {
  Severity severity = Severity::failure;
  std::string code;     ///< a word for the cause, the same in every version: `daemon_away`
  std::string what;     ///< a sentence for the user
  std::string seen;     ///< how it was seen
  std::string remedy;   ///< a remedy in words
  std::string command;  ///< one command to copy; empty where there is none
};

using Findings = std::vector<Finding>;

}  // namespace geminga::doctor

#endif
