// The daemon's answers that the doctor reads.
#ifndef GEMINGA_DOCTOR_ANSWERS_HPP
#define GEMINGA_DOCTOR_ANSWERS_HPP

#include <string>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::doctor {

/// Names that another participant uses and the ontology here does not know.
struct UnknownNames {
  std::string participant;
  std::vector<std::string> names;  ///< at most max_unknown_names
};
inline constexpr std::size_t max_unknown_names = 8;

/// The records of `query KIND` (src/discovery/participant/QUERIES.md).
struct Answers {
  Record status;
  std::vector<Record> interfaces;
  std::vector<Record> participants;
  std::vector<Record> security;
  std::vector<Record> ontology;
  std::vector<Record> services{};
  std::vector<Record> unmatched;        ///< requests that nobody serves, with the likely reason of each
  std::vector<UnknownNames> unknown{};  ///< of participants with another ontology
};

/// Asks the daemon for all of them. An answer that the daemon refuses, as while its ontology is being taken up, is
/// empty.
[[nodiscard]] std::expected<Answers, ClientError> ask(Client& client);

/// Asks for the participants once more, and leaves `hears_us=0` only with those that say so again: by loss alone one
/// neighbour in four hundred says so for a moment. Waits for three intervals,
/// six seconds at most.
[[nodiscard]] std::expected<void, ClientError> confirm_deaf(Client& client, Answers& answers);

}  // namespace geminga::doctor

#endif
