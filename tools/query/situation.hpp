// The living robots for a plan of roles, and the task that they make.
#ifndef GEMINGA_QUERY_SITUATION_HPP
#define GEMINGA_QUERY_SITUATION_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/roles/task.hpp"
#include "geminga/client.hpp"
#include "query/need.hpp"

namespace geminga::query {

/// Roles, and by what robots are preferred.
struct Plan {
  std::vector<Need> needs;
  Wish wish;
};

/// A robot that suits at least one role.
struct Robot {
  std::string id;
  std::string name;
  std::optional<double> value;  ///< of the attribute that is preferred
};

struct Situation {
  std::vector<Robot> robots;  ///< by id
  roles::Task task;
};

/// The reason why a plan is beyond the limits of discovery/roles/task.hpp.
[[nodiscard]] std::optional<std::string> too_much(const Plan& plan);

/// `role 2 (hasPart some Gripper)`, as it is called in errors.
[[nodiscard]] std::string role_words(const Plan& plan, std::size_t role);

/// The participants that an expression describes and that meet the condition, if any.
[[nodiscard]] Result<Answer, ClientError> described(Client& client, const std::string& expression,
                                                    const std::string& condition);

/// Asks for the robots that suit each role. An error says which role was refused.
[[nodiscard]] std::expected<Situation, ClientError> look(Client& client, const Plan& plan);

}  // namespace geminga::query

#endif
