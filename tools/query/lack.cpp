#include "query/lack.hpp"

#include <algorithm>
#include <boost/json/array.hpp>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "base/text.hpp"
#include "discovery/roles/completion.hpp"
#include "query/listing.hpp"
#include "query/near.hpp"

namespace geminga::query {
namespace {

/// Choices whose additions contradict each other are made again without one of them, at most so often.
constexpr int max_choices = 8;

/// All that a robot lacks for a role.
struct Lack {
  std::vector<std::string> missing{};
  std::size_t count = 0;
  bool fails_condition = false;

  [[nodiscard]] std::size_t whole() const { return count + (fails_condition ? 1 : 0); }
};

/// Everybody who comes near to some role.
struct Near {
  std::map<std::string, std::string> names{};          ///< by id
  std::vector<std::map<std::string, Lack>> of_role{};  ///< by id
  bool is_proven = true;
};

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Lack lack_of(const Record& record) {
  return {.missing = lines_of(record["missing"]),
          .count = base::parse_number<std::size_t>(record["missing_count"]).value_or(0),
          .fails_condition = false};
}

/// Participants that come near to an expression. Nothing where the daemon does not say it.
std::optional<Answer> near_to(Client& client, const std::string& expression) {
  auto answer = client.query("match", {{"mode", "participant"},
                                       {"concept", expression},
                                       {"missing", "1"},
                                       {"limit", std::to_string(roles::max_robots)}});
  return answer ? std::optional(std::move(*answer)) : std::nullopt;
}

bool is_proven(const Answer& answer) {
  return answer.end["uncompared"].empty() &&
         std::ranges::all_of(answer.records, [](const Record& one) { return one["reservation"].empty(); });
}

/// False where the daemon cannot say it.
bool look_near(Client& client, const Need& need, Near& near) {
  auto& lacks = near.of_role.emplace_back();
  const auto answer = near_to(client, need.expression);
  if (!answer) return false;
  near.is_proven = near.is_proven && is_proven(*answer);
  for (const Record& record : answer->records) {
    if (!record["contradicting"].empty()) continue;
    const std::string id = participant_of(record);
    near.names.emplace(id, record["participant_name"]);
    lacks.emplace(id, is_match(record) ? Lack() : lack_of(record));
  }
  if (need.condition.empty()) return true;
  const auto meeting = described(client, "owl:Thing", need.condition);
  if (!meeting) return false;
  std::set<std::string, std::less<>> meets;
  for (const Record& record : meeting->records) meets.emplace(record["id"]);
  for (auto& [id, lack] : lacks) lack.fails_condition = !meets.contains(id);
  return true;
}

/// The task with what is missing as costs, and the ids of its robots.
std::pair<roles::Task, std::vector<std::string>> task_of(const Plan& plan, const Near& near) {
  std::vector<std::string> ids;
  for (const auto& [id, name] : near.names) ids.push_back(id);
  roles::Task task{.robots = static_cast<std::uint32_t>(ids.size()), .roles = {}, .former = {}};
  for (std::size_t role = 0; role < plan.needs.size(); ++role) {
    roles::Role one{.count = plan.needs[role].count, .is_shared = plan.needs[role].is_shared, .suited = {}};
    for (const auto& [id, lack] : near.of_role[role]) {
      const auto robot = static_cast<std::uint32_t>(std::ranges::lower_bound(ids, id) - ids.begin());
      const auto cost = std::min<std::size_t>(lack.whole(), roles::max_missing);
      one.suited.push_back({robot, static_cast<std::uint32_t>(cost)});
    }
    task.roles.push_back(std::move(one));
  }
  return {std::move(task), std::move(ids)};
}

/// All that a robot lacks for several roles at once: what two of them lack counts once. Nothing where the roles
/// together contradict what it is.
std::optional<Lack> together(Client& client, const Plan& plan, const LackOfRobot& robot) {
  std::string all;
  for (const std::size_t role : robot.roles) {
    all += (all.empty() ? "(" : " and (") + plan.needs[role].expression + ")";
  }
  const auto answer = near_to(client, all);
  if (!answer) return std::nullopt;
  const auto record = std::ranges::find(answer->records, robot.id, participant_of);
  if (record == answer->records.end() || !(*record)["contradicting"].empty()) return std::nullopt;
  return lack_of(*record);
}

/// Puts together what the chosen robots lack. Returns a robot whose roles do not go together, if there is one.
std::optional<LackOfRobot> gather_lacks(Client& client, const Plan& plan, const Near& near, TeamLack& team) {
  std::map<std::string, LackOfRobot> robots;
  for (std::size_t role = 0; role < team.holders.size(); ++role) {
    for (const std::string& id : team.holders[role]) {
      const Lack& lack = near.of_role[role].at(id);
      if (lack.whole() == 0) continue;
      LackOfRobot& one = robots.try_emplace(id, LackOfRobot{.id = id, .name = near.names.at(id)}).first->second;
      one.roles.push_back(role);
      one.missing = lack.missing;
      one.count += lack.whole();
      if (lack.fails_condition &&
          std::ranges::find(one.conditions, plan.needs[role].condition) == one.conditions.end()) {
        one.conditions.push_back(plan.needs[role].condition);
      }
    }
  }
  for (auto& [id, one] : robots) {
    if (one.roles.size() > 1) {
      const auto lack = together(client, plan, one);
      if (!lack) return one;
      one.missing = lack->missing;
      one.count = lack->count + one.conditions.size();
    }
    team.robots.push_back(std::move(one));
  }
  return std::nullopt;
}

}  // namespace

std::size_t TeamLack::count() const {
  std::size_t all = 0;
  for (const LackOfRobot& robot : robots) all += robot.count;
  return all;
}

std::optional<TeamLack> least_lack(Client& client, const Plan& plan) {
  Near near;
  for (const Need& need : plan.needs) {
    if (!look_near(client, need, near)) return std::nullopt;
  }
  for (int choice = 0; choice < max_choices; ++choice) {
    const auto [task, ids] = task_of(plan, near);
    const auto found = roles::least_completion(task);
    if (!found) return std::nullopt;
    TeamLack team{.is_least = near.is_proven, .robots = {}, .to_come = found->lacking, .holders = {}};
    for (const auto& robots : found->of_role) {
      auto& holders = team.holders.emplace_back();
      for (const std::uint32_t robot : robots) holders.push_back(ids[robot]);
    }
    const auto clash = gather_lacks(client, plan, near, team);
    if (!clash) return team;
    // It keeps the role for which it lacks least.
    const auto most = std::ranges::max_element(
        clash->roles, {}, [&](std::size_t role) { return near.of_role[role].at(clash->id).whole(); });
    near.of_role[*most].erase(clash->id);
    near.is_proven = false;
  }
  return std::nullopt;
}

boost::json::object to_json(const TeamLack& lack) {
  boost::json::array robots;
  for (const LackOfRobot& one : lack.robots) {
    boost::json::array roles;
    for (const std::size_t role : one.roles) roles.push_back(role + 1);
    robots.push_back(
        boost::json::object{{"id", one.id},
                            {"name", one.name},
                            {"roles", std::move(roles)},
                            {"missing", boost::json::array(one.missing.begin(), one.missing.end())},
                            {"conditions", boost::json::array(one.conditions.begin(), one.conditions.end())},
                            {"count", one.count}});
  }
  boost::json::array holders;
  for (const auto& ids : lack.holders) holders.push_back(boost::json::array(ids.begin(), ids.end()));
  return {{"least", lack.is_least},
          {"count", lack.count()},
          {"to_come", boost::json::array(lack.to_come.begin(), lack.to_come.end())},
          {"robots", std::move(robots)},
          {"holders", std::move(holders)}};
}

std::vector<std::string> lack_lines(const TeamLack& lack, const Plan& plan) {
  std::vector<std::string> lines;
  for (std::size_t role = 0; role < lack.to_come.size(); ++role) {
    if (lack.to_come[role] == 0) continue;
    lines.push_back(role_words(plan, role) + " needs " + std::to_string(lack.to_come[role]) +
                    " more, and no present robot nearly suits it");
  }
  for (const LackOfRobot& one : lack.robots) {
    std::string line = one.name + " (" + one.id + ") would hold role";
    for (const std::size_t role : one.roles)
      line += (role == one.roles.front() ? " " : ", ") + std::to_string(role + 1);
    if (!one.missing.empty()) line += ": not known: " + base::joined(one.missing, ", ");
    for (const std::string& condition : one.conditions) line += ": it does not meet '" + condition + "'";
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace geminga::query
