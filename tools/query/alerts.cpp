// geminga-query alerts: what should hold in the team and does not, as events.
#include <CLI/CLI.hpp>
#include <boost/json/object.hpp>
#include <chrono>
#include <csignal>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "answers/differences.hpp"
#include "query/alerts/alert_watch.hpp"
#include "query/alerts/rules.hpp"
#include "query/alerts/words.hpp"
#include "query/command.hpp"
#include "shell/command_queue.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"
#include "shell/timestamp.hpp"

namespace geminga::query {
namespace {

struct AlertFlags {
  std::string rules;
  std::string command;
  std::optional<double> command_seconds;
  bool is_check_only = false;
};

/// The instant of this host's steady clock.
base::Instant steady_now() {
  return base::Instant(std::chrono::duration_cast<base::Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

/// Looks at all rules again and again, and tells what changes.
class Alerting {
 public:
  Alerting(const Context& context, const std::vector<alerts::Rule>& rules, shell::CommandQueue* commands)
      : context_(context), rules_(rules), watch_(rules), commands_(commands) {}

  /// Looks until a signal or the daemon's end.
  shell::ExitStatus run(Client& client) {
    for (bool is_first = true;; is_first = false) {
      if (const auto end = look(client, is_first)) return *end;
      if (!std::cout) return shell::ExitStatus::wrong_use;
      if (is_stopped()) return shell::ExitStatus::found;
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<shell::ExitStatus> look(Client& client, bool is_first) {
    for (std::size_t rule = 0; rule < rules_.size(); ++rule) {
      const auto& question = rules_[rule].question;
      const auto answer = client.query(question.kind, question.parameters);
      if (answer) {
        tell(rule, watch_.counted(rule, answer->records.size(), steady_now()));
        continue;
      }
      const ClientError& error = answer.error();
      if (error.kind != ClientError::Kind::refused) return shell::report(program, error);
      const bool is_of_rule = error.code != ErrorCode::not_ready && error.code != ErrorCode::too_many;
      if (is_first && is_of_rule) {
        shell::complain(program, rules_[rule].origin + ": " + error.text);
        return shell::ExitStatus::wrong_use;
      }
      tell(rule, watch_.not_counted(rule, error.text));
    }
    return std::nullopt;
  }

  void tell(std::size_t rule, const std::optional<alerts::Happening>& happening) const {
    if (!happening) return;
    if (commands_ != nullptr && commands_->has_room()) {
      commands_->add(shell::stamped(alerts::to_json(rules_[rule], *happening)));
    } else if (context_.common.is_json) {
      shell::print(std::cout, shell::stamped(alerts::to_json(rules_[rule], *happening)));
    } else {
      std::cout << shell::timestamp() << ' ' << shell::printable(alerts::line(rules_[rule], *happening)) << '\n';
    }
    std::cout << std::flush;
  }

  /// Waits for the next look; true where a signal came.
  bool is_stopped() {
    const auto until = Clock::now() + answers::watch_pause;
    while (true) {
      auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
      if (left.count() <= 0) return false;
      if (const auto limit = commands_ == nullptr ? std::nullopt : commands_->time_left())
        left = std::min(left, *limit);
      const auto woken = signals_.wait(-1, left, commands_ == nullptr ? -1 : commands_->descriptor());
      if (commands_ != nullptr) commands_->process();
      if (woken != shell::StopSignals::Woken::stopped) continue;
      if (commands_ != nullptr) commands_->stop(SIGTERM);
      return true;
    }
  }

  const Context& context_;
  const std::vector<alerts::Rule>& rules_;
  alerts::AlertWatch watch_;
  shell::CommandQueue* commands_;
  shell::StopSignals signals_;
};

shell::ExitStatus run_alerts(const Context& context, const AlertFlags& flags) {
  const auto rules = alerts::read_rules_file(flags.rules);
  if (!rules) {
    for (const std::string& line : rules.error()) shell::complain(program, line);
    return shell::ExitStatus::wrong_use;
  }
  if (flags.is_check_only) return shell::ExitStatus::found;
  std::unique_ptr<shell::CommandQueue> commands;
  if (!flags.command.empty()) {
    shell::CommandOptions options{.command = flags.command, .connect = context.common.connect};
    if (flags.command_seconds) options.time = shell::in_milliseconds(*flags.command_seconds);
    commands = std::make_unique<shell::CommandQueue>(program, std::move(options));
  }
  auto client = Client::connect(client_options(context));
  if (!client) return shell::report(program, client.error());
  return Alerting(context, *rules, commands.get()).run(*client);
}

constexpr const char* alert_words =
    R"(FILE is TOML with a table for each rule:
  [[rule]]
  name = "ball"                     # of the alert
  concept = "soccer:BallInfo"       # or text, id: services are counted, as geminga-query match finds them, also with
  at-least = 1                      # representation, mode, degree, where, provider; at-most instead or beside
  for = 3                           # seconds for which the count must be wrong; default: 0
  [[rule]]
  name = "eyes"
  participants = "canSee some WarmThing" # participants are counted, as geminga-query participants finds them
  where = "battery >= 30 %"
  at-least = 2
  for = 5
Alerts use a closed world: a service that this daemon does not know counts as absent, and a robot that is not known to see people
counts as one that cannot. A name that the ontology no longer has is a problem, and raises no alert.
Events are raised, cleared and problem. Each is a line that begins with the time, or an object with --json. With --exec each event
runs COMMAND by /bin/sh -c instead, with GEMINGA_EVENT, GEMINGA_ALERT, GEMINGA_COUNT, ... in its environment and the object on its
standard input.

Examples:
  geminga-query alerts --rules alerts.toml
  geminga-query --json alerts --rules alerts.toml
  geminga-query alerts --rules alerts.toml --exec 'logger -t alerts "$GEMINGA_EVENT $GEMINGA_ALERT"'
  geminga-query alerts --rules alerts.toml --check
Exit status: 0 ended by Ctrl-C, 2 a rule cannot be read (file, line, what to do), 3 the daemon is gone.)";

}  // namespace

void add_alerts(CLI::App& app, RunAlone& selected) {
  CLI::App* command =
      app.add_subcommand("alerts", "Tell when a rule about the team stops holding, and when it holds again");
  const auto flags = std::make_shared<AlertFlags>();
  command->add_option("--rules", flags->rules, "The rules, in TOML")->type_name("FILE")->required();
  auto* exec = command->add_option("--exec", flags->command, "Run this for each event instead of printing it");
  exec->type_name("COMMAND");
  shell::add_seconds(*command, "--exec-timeout", flags->command_seconds,
                     "How long a command may run before it is ended (default: 60)")
      ->needs(exec);
  command->add_flag("--check", flags->is_check_only, "Check the rules, and end");
  command->footer(alert_words);
  command->callback(
      [flags, &selected] { selected = [flags](const Context& context) { return run_alerts(context, *flags); }; });
}

}  // namespace geminga::query
