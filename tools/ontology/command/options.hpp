// Options that several commands have.
#ifndef GEMINGA_ONTOLOGY_COMMAND_OPTIONS_HPP
#define GEMINGA_ONTOLOGY_COMMAND_OPTIONS_HPP

#include <string>
#include <vector>

#include "ontology/command/choice.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace geminga::ontology {

/// Adds the positional FILES, required.
CLI::Option* add_files(CLI::App& command, std::vector<std::string>& files);
/// Adds `--connect`, for a command that talks to the daemon.
void add_connect(CLI::App& command, std::string& connect);
/// Adds `--lenient`, for a command that reads files.
void add_lenient(CLI::App& command, bool& is_lenient);
/// Adds `-o OUT`, required.
void add_output(CLI::App& command, std::string& out);
/// Adds an option that takes a decimal number between two bounds and nothing else.
CLI::Option* add_number(CLI::App& command, const std::string& flag, unsigned& number, unsigned low, unsigned high,
                        const std::string& description);
/// Adds `--strict`: a file of a folder that cannot be read refuses everything.
void add_strict(CLI::App& command, bool& is_strict);
/// The least that --memory-limit takes, in MiB: with less, libraries of others crash where they get no memory.
inline constexpr unsigned min_memory_limit_mib = 96;
/// Adds `--memory-limit`.
void add_memory_limit(CLI::App& command, Choice& choice);
/// Adds `--graph-limit`.
void add_graph_limit(CLI::App& command, WorkLimits& limits);
/// Adds `--time-limit` and `--steps`, for a command that searches.
void add_work_limits(CLI::App& command, WorkLimits& limits);
/// Adds `--memory-limit`, and a `--time-limit` beyond which nothing is written, for a command without a search.
void add_run_limits(CLI::App& command, Choice& choice);

}  // namespace geminga::ontology

#endif
