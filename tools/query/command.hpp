// The commands of geminga-query, and the settings that all of them share.
#ifndef GEMINGA_QUERY_COMMAND_HPP
#define GEMINGA_QUERY_COMMAND_HPP

#include <CLI/App.hpp>
#include <functional>
#include <string_view>

#include "geminga/client.hpp"
#include "shell/exit_status.hpp"
#include "shell/options.hpp"
#include "shell/terminal.hpp"

namespace geminga::query {

inline constexpr std::string_view program = "geminga-query";

/// The settings that hold for every command.
struct Context {
  shell::CommonOptions common;
  bool is_watching = false;
  bool has_timestamps = false;  ///< lines of --watch begin with the time; its objects always have it
  shell::Terminal terminal;
};

/// Asks the daemon and prints the answer. The flags of the command have been read.
using Run = std::function<shell::ExitStatus(const Context&, Client&)>;

/// Does so for a command that has something to say even where there is no daemon: its client, or why there is none.
using RunEvenAlone = std::function<shell::ExitStatus(const Context&, Result<Client, ClientError>&)>;

/// Does so for a command that reaches the daemon by itself, or asks none.
using RunAlone = std::function<shell::ExitStatus(const Context&)>;

/// The daemon that the flags name, and how long to wait for it.
[[nodiscard]] ClientOptions client_options(const Context& context);

/// Each function adds one command to the program. When the command line names the command, its Run is put into
/// `selected`, which lives as long as `app`. May throw CLI::ValidationError while the command line is read.
void add_participants(CLI::App& app, Run& selected);
void add_team(CLI::App& app, Run& selected);
void add_services(CLI::App& app, Run& selected);
void add_requests(CLI::App& app, Run& selected);
void add_match(CLI::App& app, Run& selected);
void add_describe(CLI::App& app, Run& selected);
void add_explain(CLI::App& app, Run& selected);
void add_why(CLI::App& app, Run& selected);
void add_ontology(CLI::App& app, Run& selected);
void add_security(CLI::App& app, Run& selected);
void add_export(CLI::App& app, Run& selected);
void add_status(CLI::App& app, Run& selected);
/// Ends without a word where there is no daemon, or none that answers in two seconds.
void add_complete(CLI::App& app, RunEvenAlone& selected);
void add_doctor(CLI::App& app, RunEvenAlone& selected);
void add_alerts(CLI::App& app, RunAlone& selected);
void add_mcp(CLI::App& app, RunAlone& selected);
void add_record(CLI::App& app, RunAlone& selected);
void add_replay(CLI::App& app, RunAlone& selected);
void add_top(CLI::App& app, RunAlone& selected);

}  // namespace geminga::query

#endif
