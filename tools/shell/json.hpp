// The daemon's records and events as JSON (RFC 8259).
#ifndef GEMINGA_SHELL_JSON_HPP
#define GEMINGA_SHELL_JSON_HPP

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/value.hpp>
#include <ostream>
#include <vector>

#include "geminga/client.hpp"
#include "geminga/event.hpp"

namespace geminga::shell {

/// A record as an object: numbers, flags and lists by the meaning of their key, everything else a string; attributes of
/// a service in an object `attributes`.
[[nodiscard]] boost::json::object to_json(const Record& record);
[[nodiscard]] boost::json::array to_json(const std::vector<Record>& records);

/// An event as an object: `event` is add, modify or del; the other members are named as in GCNP.
[[nodiscard]] boost::json::object to_json(const ServiceEvent& event);
[[nodiscard]] boost::json::object to_json(const ConsumerEvent& event);

/// Adds `time`, the present time in the form of RFC 3339, behind the first member of an event.
[[nodiscard]] boost::json::object stamped(const boost::json::object& event);

/// Writes one document and a line end. Characters that could steer a terminal are written as \u escapes.
void print(std::ostream& out, const boost::json::value& document);

}  // namespace geminga::shell

#endif
