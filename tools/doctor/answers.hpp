// The daemon's answers that the doctor reads.
#ifndef GEMINGA_DOCTOR_ANSWERS_HPP
#define GEMINGA_DOCTOR_ANSWERS_HPP

#include <string>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::doctor {

/// The records of `query KIND` (src/discovery/participant/QUERIES.md).
struct Answers {
  Record status;
  std::vector<Record> interfaces;
  std::vector<Record> participants;
  std::vector<Record> security;
  std::vector<Record> ontology;
  std::vector<Record> unmatched;  ///< requests that nobody serves, with the likely reason of each
};

/// Asks the daemon for all of them. An answer that the daemon refuses, as while its ontology is being taken up, is
/// empty.
[[nodiscard]] std::expected<Answers, ClientError> ask(Client& client);

}  // namespace geminga::doctor

#endif
