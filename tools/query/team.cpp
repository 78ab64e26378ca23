// geminga-query team: which robots together fill the roles of a task.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "answers/differences.hpp"
#include "discovery/roles/holders.hpp"
#include "query/command.hpp"
#include "query/lack.hpp"
#include "query/listing.hpp"
#include "query/near.hpp"
#include "query/need.hpp"
#include "query/situation.hpp"
#include "query/task_file.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"
#include "shell/table.hpp"
#include "shell/timestamp.hpp"

namespace geminga::query {
namespace {

using roles::Holders;

struct TeamFlags {
  std::string file;
  std::string task;
  std::vector<std::string> needs;
  std::string prefer;
};

/// The id and the name of a robot.
using Holder = std::pair<std::string, std::string>;

/// Holders by role, so that they are known when the team has changed.
using Held = std::vector<std::vector<Holder>>;

Held held(const Situation& situation, const Holders& holders) {
  Held all;
  for (const auto& role : holders.of_role) {
    all.emplace_back();
    for (const std::uint32_t robot : role)
      all.back().emplace_back(situation.robots[robot].id, situation.robots[robot].name);
  }
  return all;
}

bool holds(const std::vector<Holder>& role, const std::string& id) {
  return std::ranges::find(role, id, &Holder::first) != role.end();
}

/// Makes those who are still there the former holders.
void keep(const Held& before, Situation& situation) {
  if (before.empty()) return;
  for (const auto& role : before) {
    situation.task.former.emplace_back();
    for (std::uint32_t robot = 0; robot < situation.robots.size(); ++robot) {
      if (holds(role, situation.robots[robot].id)) situation.task.former.back().push_back(robot);
    }
  }
}

/// Robots that come near a role that lacks holders, as many as it lacks; none where the daemon cannot say it.
std::vector<Record> near_to(Client& client, const Need& need, std::uint32_t lacking) {
  if (lacking == 0) return {};
  Listing listing = near_participants(need.expression, need.condition);
  listing.parameters.emplace_back("limit", std::to_string(lacking));
  auto records = ask(client, listing);
  if (!records) return {};
  std::erase_if(*records, is_match);
  return std::move(*records);
}

boost::json::object document(Client& client, const Plan& plan, const Situation& situation, const Holders& holders) {
  const auto lacking = roles::shortage(situation.task);
  boost::json::array list;
  for (std::size_t role = 0; role < plan.needs.size(); ++role) {
    boost::json::array robots;
    if (role < holders.of_role.size()) {
      for (const std::uint32_t robot : holders.of_role[role]) {
        robots.push_back(
            boost::json::object{{"id", situation.robots[robot].id}, {"name", situation.robots[robot].name}});
      }
    }
    boost::json::array near;
    for (const Record& record : near_to(client, plan.needs[role], lacking[role]))
      near.push_back(shell::to_json(record));
    list.push_back(boost::json::object{{"need", plan.needs[role].text},
                                       {"count", plan.needs[role].count},
                                       {"shared", plan.needs[role].is_shared},
                                       {"suited", situation.task.roles[role].suited.size()},
                                       {"lacking", lacking[role]},
                                       {"holders", std::move(robots)},
                                       {"near", std::move(near)}});
  }
  boost::json::object whole{{"found", !holders.of_role.empty()},
                            {"best", holders.verdict == Holders::Verdict::best},
                            {"robots", holders.robots},
                            {"changes", holders.changes},
                            {"roles", std::move(list)}};
  if (holders.verdict != Holders::Verdict::nobody) return whole;
  if (const auto lack = least_lack(client, plan)) whole["lack"] = to_json(*lack);
  return whole;
}

void print_table(const Context& context, const Plan& plan, const Situation& situation, const Holders& holders) {
  shell::Table table({{"ROLE", false, 20}, {"ROBOT", false, 8}, {"ID"}});
  for (std::size_t role = 0; role < plan.needs.size(); ++role) {
    for (const std::uint32_t robot : holders.of_role[role]) {
      table.add({plan.needs[role].text, situation.robots[robot].name, situation.robots[robot].id});
    }
  }
  table.print(std::cout, context.terminal);
}

/// Each role that lacks somebody, what those who come near to it lack, and the least that the team lacks.
void complain_of_lack(Client& client, const Plan& plan, const Situation& situation) {
  const auto lacking = roles::shortage(situation.task);
  for (std::size_t role = 0; role < plan.needs.size(); ++role) {
    if (lacking[role] == 0) continue;
    shell::complain(program, role_words(plan, role) + " lacks " + std::to_string(lacking[role]) + " of " +
                                 std::to_string(plan.needs[role].count) +
                                 "; known to suit it: " + std::to_string(situation.task.roles[role].suited.size()));
    for (const Record& record : near_to(client, plan.needs[role], lacking[role])) {
      shell::complain(program, "  " + std::string(record["name"]) + " (" + std::string(record["id"]) +
                                   ") comes near: " + lack_words(record));
    }
  }
  const auto lack = least_lack(client, plan);
  if (!lack) return;
  shell::complain(program,
                  lack->is_least ? "the least that the team lacks:" : "what the team lacks, and there may be less:");
  for (const std::string& line : lack_lines(*lack, plan)) shell::complain(program, "  " + line);
}

/// Says where a choice is not known to be the best.
void complain_of_end(Holders::Verdict verdict) {
  if (verdict == Holders::Verdict::good)
    shell::complain(program, "the search ended early: there may be a better choice");
  if (verdict == Holders::Verdict::too_large) {
    shell::complain(program, "more than " + std::to_string(roles::max_robots) +
                                 " robots suit these roles: nobody was chosen, ask for less common ones");
  }
}

shell::ExitStatus show_team(const Context& context, Client& client, const Plan& plan) {
  const auto situation = look(client, plan);
  if (!situation) return shell::report(program, situation.error());
  const Holders holders = roles::best_holders(situation->task);
  if (context.common.is_json) {
    shell::print(std::cout, document(client, plan, *situation, holders));
  } else if (!holders.of_role.empty()) {
    print_table(context, plan, *situation, holders);
  }
  complain_of_end(holders.verdict);
  if (!holders.of_role.empty()) return shell::ExitStatus::found;
  if (!context.common.is_json) complain_of_lack(client, plan, *situation);
  return shell::ExitStatus::nothing;
}

/// Prints who comes to a role and who leaves it.
void print_changes(const Context& context, const Plan& plan, const Held& before, const Held& now) {
  const std::string stamp = context.has_timestamps ? shell::timestamp() + ' ' : "";
  const auto print = [&](const char* sign, std::size_t role, const Held& all, const Held& others) {
    if (role >= all.size()) return;
    for (const Holder& one : all[role]) {
      if (role < others.size() && holds(others[role], one.first)) continue;
      std::cout << stamp << sign << ' ' << one.first << "  " << shell::printable(one.second) << "  "
                << shell::printable(plan.needs[role].text) << '\n';
    }
  };
  for (std::size_t role = 0; role < plan.needs.size(); ++role) {
    print("-", role, before, now);
    print("+", role, now, before);
  }
  std::cout << std::flush;
}

/// Holders stay as long as they suit; where somebody fails, as few as can be change.
shell::ExitStatus watch_team(const Context& context, Client& client, const Plan& plan) {
  const shell::StopSignals signals;
  Held before;
  std::optional<Held> told;
  while (true) {
    auto situation = look(client, plan);
    if (!situation) return shell::report(program, situation.error());
    keep(before, *situation);
    const Holders holders = roles::best_holders(situation->task);
    const Held now = held(*situation, holders);
    if (!told || *told != now) {
      if (context.common.is_json) {
        shell::print(std::cout, shell::stamped(document(client, plan, *situation, holders)));
      } else {
        print_changes(context, plan, told.value_or(Held()), now);
        complain_of_end(holders.verdict);
        if (now.empty()) complain_of_lack(client, plan, *situation);
      }
      told = now;
    }
    if (!now.empty()) before = now;
    if (!std::cout) return shell::ExitStatus::wrong_use;
    if (signals.wait(client.file_descriptor(), answers::watch_pause) == shell::StopSignals::Woken::stopped) {
      return shell::ExitStatus::found;
    }
  }
}

/// The roles of the flags. Throws CLI::ValidationError with the number of the role.
Plan plan_of(const TeamFlags& flags) {
  Plan plan;
  for (const std::string& text : flags.needs) {
    auto need = read_need(text);
    const std::string place = "--need " + std::to_string(plan.needs.size() + 1) + " (" + text + ")";
    if (!need) throw CLI::ValidationError(place, need.error());
    plan.needs.push_back(std::move(*need));
  }
  if (const auto fault = too_much(plan)) throw CLI::ValidationError("--need", *fault);
  if (flags.prefer.empty()) return plan;
  auto wish = read_wish(flags.prefer);
  if (!wish) throw CLI::ValidationError("--prefer", wish.error());
  plan.wish = std::move(*wish);
  return plan;
}

}  // namespace

void add_team(CLI::App& app, Run& selected) {
  CLI::App* command =
      app.add_subcommand("team", "Find the smallest set of robots that together fill the roles of a task");
  const auto flags = std::make_shared<TeamFlags>();
  CLI::Option* file =
      command->add_option("FILE", flags->file, "A task in any syntax of OWL, in the words of ontology/capability.ttl");
  file->type_name("FILE")->check(CLI::ExistingFile, "", "");
  command->add_option("--task", flags->task, "The name or IRI of the task, where the file has several")
      ->type_name("NAME")
      ->needs(file);
  command
      ->add_option(
          "--need", flags->needs,
          "A role, as EXPRESSION, 'COUNT: EXPRESSION' or 'COUNT shared: EXPRESSION', then perhaps 'where CONDITION': "
          "so "
          "many robots (default: 1) that the expression describes and whose attributes fulfil the condition. A robot "
          "holds one role, and any number of shared ones")
      ->type_name("ROLE")
      ->excludes(file)
      ->allow_extra_args(false);
  command->add_option("--prefer", flags->prefer, "Of several smallest sets, take the one whose attributes are best")
      ->type_name("'KEY asc|desc'");
  command->footer(
      "Examples:\n  geminga-query team task.ttl\n  geminga-query team --need '2: canSee some WarmThing where battery "
      ">= 30 %' --need 'hasPart some "
      "Gripper'\n"
      "  geminga-query team --need 'hasPart some Arm' --need '1 shared: hasPart some Radio' --prefer 'battery desc'\n"
      "  geminga-query --watch team --need 'hasPart some Gripper'\n"
      "With --watch robots keep their roles while they fit; when one fails, as few roles as possible change hands.\n"
      "Exit status 0: the roles are filled; 1: they cannot be; each role says what it lacks and who comes near.");
  command->callback([flags, &selected] {
    if (flags->file.empty() && flags->needs.empty()) throw CLI::RequiredError("FILE or --need");
    selected = [said = *flags, plan = plan_of(*flags)](const Context& context, Client& client) {
      if (said.file.empty()) {
        return context.is_watching ? watch_team(context, client, plan) : show_team(context, client, plan);
      }
      auto task = plan_of_file(client, said.file, said.task);
      if (!task) return task.error();
      if (!plan.wish.attribute.empty()) task->wish = plan.wish;
      return context.is_watching ? watch_team(context, client, *task) : show_team(context, client, *task);
    };
  });
}

}  // namespace geminga::query
