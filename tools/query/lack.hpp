// The least that a team lacks where nobody can do a task.
#ifndef GEMINGA_QUERY_LACK_HPP
#define GEMINGA_QUERY_LACK_HPP

#include <boost/json/object.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geminga/client.hpp"
#include "query/situation.hpp"

namespace geminga::query {

/// A robot that would hold these roles if more were known of it.
struct LackOfRobot {
  std::string id;
  std::string name;
  std::vector<std::size_t> roles{};       ///< for which it lacks something, ascending
  std::vector<std::string> missing{};     ///< conjuncts that are not known of it
  std::vector<std::string> conditions{};  ///< conditions over attributes that it does not meet
  std::size_t count = 0;                  ///< of both, conjuncts within others one by one
};

struct TeamLack {
  bool is_least = false;                            ///< nothing less makes a team, as far as near misses are proven
  std::vector<LackOfRobot> robots{};                ///< by id
  std::vector<std::uint32_t> to_come{};             ///< by role: holders that nobody who is there comes near to
  std::vector<std::vector<std::string>> holders{};  ///< by role: the ids of those who would hold it

  [[nodiscard]] std::size_t count() const;
};

/// Asks what each robot lacks for each role, and chooses the robots with which the team lacks least: holders that are
/// to come first, then what is missing. What contradicts a description is not added to it. Nothing where the daemon
/// cannot say what is missing.
[[nodiscard]] std::optional<TeamLack> least_lack(Client& client, const Plan& plan);

[[nodiscard]] boost::json::object to_json(const TeamLack& lack);
/// Lines for a person.
[[nodiscard]] std::vector<std::string> lack_lines(const TeamLack& lack, const Plan& plan);

}  // namespace geminga::query

#endif
