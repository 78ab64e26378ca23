// The answer to `query security` by the kinds of its lines, and as a JSON document.
#ifndef GEMINGA_ANSWERS_SECURITY_HPP
#define GEMINGA_ANSWERS_SECURITY_HPP

#include <boost/json/object.hpp>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::answers {

/// The lines of the answer by kind (src/discovery/participant/QUERIES.md).
struct Security {
  Record head;
  std::vector<Record> datagrams;
  std::vector<Record> participants;
  std::vector<Record> rejected;
};

[[nodiscard]] Security security_of(const Answer& answer);

[[nodiscard]] boost::json::object security_document(const Security& security);

}  // namespace geminga::answers

#endif
