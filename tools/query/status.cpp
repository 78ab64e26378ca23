// geminga-query status: the daemon itself.
#include "answers/status.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

/// A value with its unit.
std::string words_of(const std::string& key, const std::string& value) {
  if (key == "uptime" || key == "interval" || key == "cpu") return shell::duration_words(value);
  if (key != "memory" && key != "peak_memory") return value;
  return shell::number_words(std::strtod(value.c_str(), nullptr) / (1024.0 * 1024.0), "MiB");
}

void print_words(const Context& context, const Answer& answer) {
  shell::Table table({{"WHAT"}, {"VALUE", false, 20}});
  for (const auto& record : answer.records) {
    for (const auto& [key, value] : record.fields) {
      std::string title = key;
      std::ranges::replace(title, '_', ' ');
      table.add({title, words_of(key, value)});
    }
  }
  table.print(std::cout, context.terminal);
}

}  // namespace

void add_status(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("status", "Show the daemon itself: uptime, counts, traffic, memory, timings");
  command->footer("Examples:\n  geminga-query status\n  geminga-query --json status | jq .uptime");
  command->callback([&selected] {
    selected = [](const Context& context, Client& client) {
      return show_once(context, client, "status", {}, [&](const Answer& answer) {
        if (context.common.is_json) {
          shell::print(std::cout, answers::status_document(answer));
        } else {
          print_words(context, answer);
        }
        return shell::ExitStatus::found;
      });
    };
  });
}

}  // namespace geminga::query
