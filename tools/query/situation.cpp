#include "query/situation.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "query/listing.hpp"

namespace geminga::query {
namespace {

/// The number that a text begins with: `80 %` is 80.
std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end != text.data() ? std::optional(value) : std::nullopt;
}

/// The place of each robot by the wish, from 0; those of equal value share one, and those without a value are last.
std::vector<std::uint32_t> places(const std::vector<Robot>& robots, const Wish& wish) {
  std::vector<std::uint32_t> all;
  const auto is_better = [&](const Robot& one, const Robot& other) {
    if (!one.value || !other.value) return one.value.has_value() && !other.value.has_value();
    return wish.is_descending ? *one.value > *other.value : *one.value < *other.value;
  };
  for (const Robot& robot : robots) {
    all.push_back(wish.attribute.empty() ? 0
                                         : static_cast<std::uint32_t>(std::ranges::count_if(
                                               robots, [&](const Robot& other) { return is_better(other, robot); })));
  }
  return all;
}

}  // namespace

std::optional<std::string> too_much(const Plan& plan) {
  std::uint64_t holders = 0;
  for (const Need& need : plan.needs) holders += need.count;
  if (plan.needs.size() <= roles::max_roles && holders <= roles::max_holders) return std::nullopt;
  return "there are " + std::to_string(plan.needs.size()) + " roles for " + std::to_string(holders) +
         " holders: a task has at most " + std::to_string(roles::max_roles) + " roles and " +
         std::to_string(roles::max_holders) + " holders";
}

std::string role_words(const Plan& plan, std::size_t role) {
  return "role " + std::to_string(role + 1) + " (" + plan.needs[role].text + ")";
}

Result<Answer, ClientError> described(Client& client, const std::string& expression, const std::string& condition) {
  Parameters asked{{"concept", expression}};
  if (!condition.empty()) asked.emplace_back("where", condition);
  return client.query("participants", asked);
}

std::expected<Situation, ClientError> look(Client& client, const Plan& plan) {
  std::map<std::string, Robot> by_id;
  std::vector<std::vector<std::string>> suited;
  for (const Need& need : plan.needs) {
    auto answer = described(client, need.expression, need.condition);
    if (!answer) {
      answer.error().text = role_words(plan, suited.size()) + ": " + answer.error().text;
      return std::unexpected(answer.error());
    }
    suited.emplace_back();
    for (const Record& record : answer->records) {
      Robot robot{.id = std::string(record["id"]), .name = std::string(record["name"]), .value = {}};
      const auto attribute = record.attributes.find(plan.wish.attribute);
      if (attribute != record.attributes.end()) robot.value = number_of(attribute->second);
      suited.back().push_back(robot.id);
      by_id.emplace(robot.id, std::move(robot));
    }
  }
  Situation found;
  std::map<std::string, std::uint32_t> number_of_id;
  for (auto& [id, robot] : by_id) {
    number_of_id.emplace(id, static_cast<std::uint32_t>(found.robots.size()));
    found.robots.push_back(std::move(robot));
  }
  const auto place = places(found.robots, plan.wish);
  found.task.robots = static_cast<std::uint32_t>(found.robots.size());
  for (std::size_t role = 0; role < plan.needs.size(); ++role) {
    roles::Role one{.count = plan.needs[role].count, .is_shared = plan.needs[role].is_shared, .suited = {}};
    for (const std::string& id : suited[role]) one.suited.push_back({number_of_id.at(id), place[number_of_id.at(id)]});
    found.task.roles.push_back(std::move(one));
  }
  return found;
}

}  // namespace geminga::query
