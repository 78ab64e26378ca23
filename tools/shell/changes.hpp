// Differences between two states of one service or request, for lines and objects that tell of a change.
#ifndef GEMINGA_SHELL_CHANGES_HPP
#define GEMINGA_SHELL_CHANGES_HPP

#include <boost/json/object.hpp>
#include <string>

namespace geminga::shell {

/// The members of `before` that differ or are missing in `now`, and null for members that only `now` has. Nested
/// objects (the attributes) are compared member by member.
[[nodiscard]] boost::json::object former(const boost::json::object& before, const boost::json::object& now);

/// `port was 5000, rate was absent`, from the result of former(). The text is not made printable.
[[nodiscard]] std::string words_of(const boost::json::object& former);

}  // namespace geminga::shell

#endif
