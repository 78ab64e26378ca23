// The answer to `query explain` as a JSON document.
#ifndef GEMINGA_ANSWERS_EXPLAIN_HPP
#define GEMINGA_ANSWERS_EXPLAIN_HPP

#include <boost/json/object.hpp>
#include <string>

#include "geminga/client.hpp"

namespace geminga::answers {

/// The concepts that were asked about.
struct Names {
  std::string sub;
  std::string super;
};

[[nodiscard]] inline bool is_subsumed(const Answer& answer) { return answer.end["subsumed"] == "1"; }

[[nodiscard]] boost::json::object explain_document(const Names& names, const Answer& answer);

}  // namespace geminga::answers

#endif
