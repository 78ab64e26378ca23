// geminga-query: asks the local daemon what it knows.
#include <CLI/CLI.hpp>
#include <array>
#include <string>

#include "query/command.hpp"
#include "shell/report.hpp"
#include "shell/whole_lines.hpp"

namespace geminga::query {
namespace {

constexpr const char* examples = R"(Examples:
  geminga-query participants
  geminga-query services mode=otm/stream
  geminga-query requests --unmatched
  geminga-query match soccer:TrackedObject --limit 3
  geminga-query doctor
  geminga-query top
  geminga-query record field-test.jsonl
  geminga-query explain soccer:SharedBallInfo soccer:TrackedObject
  geminga-query services --unused
  geminga-query --watch --json services
  geminga-query --connect 127.0.0.1:4718 status

On a terminal tables fit its width, and a reason that several rows share stands above them. Elsewhere, and with --json, a record is
one line with every text whole. With --watch a line begins with + for a new record, ~ for a change (with the former values), or -
for a record that is gone, with the reason: withdrawn, gone (with its participant), changed (it no longer fits).

Exit status: 0 found, 1 nothing found or the answer is no, 2 wrong usage (also a name that the ontology does not know),
3 the daemon cannot be reached, 4 timed out.)";

}  // namespace

ClientOptions client_options(const Context& context) {
  ClientOptions options;
  options.connect = context.common.connect;
  options.name = program;
  options.timeout = context.common.timeout_or(std::chrono::seconds(5));
  return options;
}

namespace {

int run(int argc, char** argv) {
  CLI::App app("Asks the local Geminga daemon: who is there, what is offered and asked for, what matches, and why.",
               std::string(program));
  app.footer(examples);
  app.require_subcommand(1);
  app.fallthrough();
  Context context;
  Run selected;
  RunEvenAlone selected_even_alone;
  RunAlone selected_alone;
  context.common.add_to(app, "How long to wait for the daemon (default: 5)");
  app.add_flag("--timestamps", context.has_timestamps,
               "With --watch: begin each line with the time (RFC 3339, UTC); JSON always has it");
  app.add_flag("--watch", context.is_watching,
               "Print what is there and then every change, until Ctrl-C or the daemon's end (exit status 3)");
  for (const auto add : std::array{add_participants, add_team, add_services, add_requests, add_match, add_explain,
                                   add_why, add_ontology, add_export, add_describe, add_status, add_security}) {
    add(app, selected);
  }
  add_doctor(app, selected_even_alone);
  add_alerts(app, selected_alone);
  add_mcp(app, selected_alone);
  add_record(app, selected_alone);
  add_replay(app, selected_alone);
  add_top(app, selected_alone);
  add_complete(app, selected_even_alone);
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);

  if (context.has_timestamps && !context.is_watching) {
    shell::complain(program, "--timestamps goes with --watch: see geminga-query --help");
    return static_cast<int>(shell::ExitStatus::wrong_use);
  }
  context.terminal = shell::Terminal::of_standard_output();
  if (selected_alone) return static_cast<int>(shell::written(program, selected_alone(context)));
  auto client = Client::connect(client_options(context));
  if (selected_even_alone) return static_cast<int>(shell::written(program, selected_even_alone(context, client)));
  if (!client) return static_cast<int>(shell::report(program, client.error()));
  return static_cast<int>(shell::written(program, selected(context, *client)));
}

}  // namespace
}  // namespace geminga::query

int main(int argc, char** argv) {
  const geminga::shell::WholeLines lines;
  return geminga::query::run(argc, argv);
}
