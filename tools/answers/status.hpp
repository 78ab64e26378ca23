// The answer to `query status` as a JSON document.
#ifndef GEMINGA_ANSWERS_STATUS_HPP
#define GEMINGA_ANSWERS_STATUS_HPP

#include <boost/json/object.hpp>

#include "geminga/client.hpp"

namespace geminga::answers {

/// One object with all fields.
[[nodiscard]] boost::json::object status_document(const Answer& answer);

}  // namespace geminga::answers

#endif
