// geminga-query status: the daemon itself.
#include <boost/json/object.hpp>
#include <iostream>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

void print_words(const Context& context, const Answer& answer) {
  shell::Table table({{"WHAT"}, {"VALUE"}});
  for (const auto& record : answer.records) {
    for (const auto& [key, value] : record.fields) {
      const bool is_duration = key == "uptime" || key == "interval";
      std::string words = key;
      std::ranges::replace(words, '_', ' ');
      table.add({words, is_duration ? shell::duration_words(value) : value});
    }
  }
  table.print(std::cout, context.terminal);
}

}  // namespace

void add_status(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("status", "The daemon itself: uptime, counts, traffic, memory, timings");
  command->footer("Examples:\n  geminga-query status\n  geminga-query --json status | jq .uptime");
  command->callback([&selected] {
    selected = [](const Context& context, Client& client) {
      if (refuses_watch(context, "status")) return shell::ExitStatus::wrong_use;
      const auto answer = client.query("status");
      if (!answer) return shell::report(program, answer.error());
      if (context.common.is_json) {
        boost::json::object object;
        for (const auto& record : answer->records) {
          for (const auto& member : shell::to_json(record)) object[member.key()] = member.value();
        }
        shell::print(std::cout, object);
      } else {
        print_words(context, *answer);
      }
      return shell::ExitStatus::found;
    };
  });
}

}  // namespace geminga::query
