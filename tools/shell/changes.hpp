// What is different between two states of one thing, for lines and objects that tell of a change.
#ifndef GEMINGA_SHELL_CHANGES_HPP
#define GEMINGA_SHELL_CHANGES_HPP

#include <boost/json/object.hpp>
#include <string>

namespace geminga::shell {

/// The members of `before` that `now` has otherwise or not at all, and null for those that only `now` has. Objects
/// within (the attributes) are compared member by member.
[[nodiscard]] boost::json::object former(const boost::json::object& before, const boost::json::object& now);

/// `port was 5000, rate was absent`, from what former() gave; not made printable.
[[nodiscard]] std::string words_of(const boost::json::object& former);

}  // namespace geminga::shell

#endif
