// What main() and the commands of geminga-query know of each other.
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

/// What holds for every command.
struct Context {
  shell::CommonOptions common;
  bool is_watching = false;
  bool has_timestamps = false;  ///< of lines; objects of --watch always have them
  shell::Terminal terminal;
};

/// Asks the daemon, prints the answer, and says how it went. Has read its own flags before it is called.
using Run = std::function<shell::ExitStatus(const Context&, Client&)>;

/// One a command: adds it to the program. When the command line names it, its Run is put into `selected`, which lives
/// as long as `app`. May throw CLI::ValidationError while the command line is read.
void add_participants(CLI::App& app, Run& selected);
void add_services(CLI::App& app, Run& selected);
void add_requests(CLI::App& app, Run& selected);
void add_match(CLI::App& app, Run& selected);
void add_explain(CLI::App& app, Run& selected);
void add_why(CLI::App& app, Run& selected);
void add_ontology(CLI::App& app, Run& selected);
void add_security(CLI::App& app, Run& selected);
void add_status(CLI::App& app, Run& selected);

}  // namespace geminga::query

#endif
