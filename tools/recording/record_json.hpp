// A daemon's record back from its JSON: the inverse of shell::to_json().
#ifndef GEMINGA_RECORDING_RECORD_JSON_HPP
#define GEMINGA_RECORDING_RECORD_JSON_HPP

#include <boost/json/object.hpp>
#include <expected>
#include <string>
#include <string_view>

#include "discovery/gcnp/statement.hpp"
#include "geminga/client.hpp"

namespace geminga::recording {

/// The record of an object. Its values are those that the daemon said, but for zeros at the end of decimals. The error
/// is a half sentence: a key that is no word of GCNP, a value that is neither text, number, flag nor list, or more than
/// a line of GCNP can hold.
[[nodiscard]] std::expected<Record, std::string> record_of(std::string_view kind, const boost::json::object& object);

/// The line of an answer that tells a record. Requires one that record_of() or a daemon gave.
[[nodiscard]] gcnp::Statement statement_of(std::uint32_t id, const Record& record);

}  // namespace geminga::recording

#endif
