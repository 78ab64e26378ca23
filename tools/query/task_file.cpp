#include "query/task_file.hpp"

#include <boost/json.hpp>
#include <vector>

#include "answers/ontology.hpp"
#include "base/text.hpp"
#include "discovery/roles/task.hpp"
#include "query/command.hpp"
#include "query/ontology_program.hpp"
#include "shell/report.hpp"

namespace geminga::query {
namespace {

/// Octets of the tasks of one file.
constexpr std::size_t max_task_bytes = std::size_t{1} << 20;

std::string text_of(const boost::json::object& object, std::string_view key) {
  const boost::json::value* value = object.if_contains(key);
  return value != nullptr && value->is_string() ? std::string(value->as_string()) : std::string();
}

std::uint64_t number_in(const boost::json::object& object, std::string_view key) {
  const boost::json::value* value = object.if_contains(key);
  boost::system::error_code error;
  const auto number = value == nullptr ? 0 : value->to_number<std::uint64_t>(error);
  return error ? 0 : number;
}

std::expected<Need, std::string> need_of(const boost::json::object& role, const std::string& file) {
  Need need;
  need.expression = text_of(role, "expression");
  need.condition = text_of(role, "where");
  const boost::json::value* shared = role.if_contains("shared");
  need.is_shared = shared != nullptr && shared->is_bool() && shared->as_bool();
  need.text = text_of(role, "name");
  if (need.text.empty()) need.text = need.expression;
  const std::uint64_t count = number_in(role, "count");
  if (count == 0 || count > roles::max_holders) {
    return std::unexpected(file + ':' + std::to_string(number_in(role, "line")) + ": the role asks for " +
                           std::to_string(count) + " robots: ask for 1 to " + std::to_string(roles::max_holders));
  }
  need.count = static_cast<std::uint32_t>(count);
  return need;
}

std::expected<Plan, std::string> plan_of_task(const boost::json::object& task, const std::string& file) {
  Plan plan;
  const boost::json::value* list = task.if_contains("roles");
  for (const boost::json::value& role : list != nullptr && list->is_array() ? list->as_array() : boost::json::array()) {
    if (!role.is_object()) continue;
    auto need = need_of(role.as_object(), file);
    if (!need) return std::unexpected(need.error());
    plan.needs.push_back(std::move(*need));
  }
  const std::string place = file + ':' + std::to_string(number_in(task, "line")) + ": ";
  if (auto fault = too_much(plan)) return std::unexpected(place + *fault);
  const std::string prefer = text_of(task, "prefer");
  if (prefer.empty()) return plan;
  auto wish = read_wish(prefer);
  if (!wish) return std::unexpected(place + "capability:prefer '" + prefer + "' " + wish.error());
  plan.wish = std::move(*wish);
  return plan;
}

}  // namespace

std::expected<Plan, std::string> read_task(std::string_view json, const std::string& file, const std::string& name) {
  boost::system::error_code error;
  const boost::json::value document = boost::json::parse(json, error);
  const auto* list = error || !document.is_object() ? nullptr : document.as_object().if_contains("tasks");
  if (list == nullptr || !list->is_array()) {
    return std::unexpected(file + ": geminga-ontology wrote no tasks: install programs of one release");
  }
  const boost::json::object* found = nullptr;
  std::string names;
  std::size_t count = 0;
  for (const boost::json::value& one : list->as_array()) {
    if (!one.is_object()) continue;
    const boost::json::object& task = one.as_object();
    const std::string its_name = text_of(task, "name");
    names += (names.empty() ? "'" : ", '") + its_name + "'";
    if (!name.empty() && name != its_name && name != text_of(task, "iri")) continue;
    found = &task;
    ++count;
  }
  if (count == 1) return plan_of_task(*found, file);
  const std::string problem = count == 0 ? " has no task '" + name + "'" : " has several tasks";
  return std::unexpected(file + problem + ": name one by --task, there are " + names);
}

std::expected<Plan, shell::ExitStatus> plan_of_file(Client& client, const std::string& file, const std::string& name) {
  const auto ontology = client.query("ontology");
  if (!ontology) return std::unexpected(shell::report(program, ontology.error()));
  std::vector<std::string> files;
  for (const Record& one : answers::ontology_of(*ontology).files) files.emplace_back(one["file"]);
  const auto json = ask_ontology_program("task", file, files, max_task_bytes);
  if (!json) return std::unexpected(shell::ExitStatus::wrong_use);
  auto plan = read_task(*json, file, name);
  if (plan) return std::move(*plan);
  shell::complain(program, plan.error());
  return std::unexpected(shell::ExitStatus::wrong_use);
}

}  // namespace geminga::query
