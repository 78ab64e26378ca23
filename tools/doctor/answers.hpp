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
  std::vector<Record> unmatched;  ///< requests that nobody serves, with the likely reason of each
  std::vector<Record> requests{};
  std::vector<UnknownNames> unknown{};  ///< of participants with another ontology
  /// The wall clock before the status was asked for and when it was there, in seconds since 1970; 0: unknown.
  double asked_from = 0;
  double asked_until = 0;
  Record earlier_status{};  ///< of a look some time before; empty where there was none
};

/// Asks the daemon for all of them but `unknown`. An answer that the daemon refuses, as while its ontology is being
/// taken up, is empty.
[[nodiscard]] std::expected<Answers, ClientError> ask(Client& client);

/// Finds the names that the ontology here does not know, of the services and requests of participants with another one.
[[nodiscard]] std::expected<void, ClientError> find_unknown(Client& client, Answers& answers);

}  // namespace geminga::doctor

#endif
