// The commands of geminga-ontology: each adds itself to the command line and leaves its exit status behind.
#ifndef GEMINGA_ONTOLOGY_COMMAND_HPP
#define GEMINGA_ONTOLOGY_COMMAND_HPP

#include <functional>
#include <string>
#include <vector>

#include "limits.hpp"

namespace CLI {
class App;
}

namespace geminga::ontology {

/// The exit statuses of the contract.
enum class Exit : int {
  yes = 0,        ///< done, or found
  no = 1,         ///< the answer is no, or there is a problem
  usage = 2,      ///< wrong usage, or a file that cannot be loaded
  timed_out = 4,  ///< --time-limit was exceeded
};

/// What the chosen command wants to be run with, once the whole command line has been read.
struct Choice {
  std::function<Exit()> run;
  /// What must be done before this program shuts itself in, e.g. starting another; Exit::yes where it goes on.
  std::function<Exit()> prepare;
  std::vector<std::string> outputs;   ///< files that it writes
  std::vector<std::string> readable;  ///< what it reads beside what the command line names
  unsigned memory_limit_mib = 0;      ///< 0: none
  WorkLimits limits;                  ///< of those that search
};

void add_check(CLI::App& program, Choice& choice);
void add_classify(CLI::App& program, Choice& choice);
void add_subsumes(CLI::App& program, Choice& choice);
void add_entails(CLI::App& program, Choice& choice);
void add_consistent(CLI::App& program, Choice& choice);
void add_explain(CLI::App& program, Choice& choice);
void add_id(CLI::App& program, Choice& choice);
void add_compile(CLI::App& program, Choice& choice);
void add_draw(CLI::App& program, Choice& choice);
void add_infer(CLI::App& program, Choice& choice);
void add_convert(CLI::App& program, Choice& choice);
void add_merge(CLI::App& program, Choice& choice);
void add_query(CLI::App& program, Choice& choice);
void add_rank(CLI::App& program, Choice& choice);

}  // namespace geminga::ontology

#endif
