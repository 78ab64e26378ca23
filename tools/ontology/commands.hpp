// The commands of geminga-ontology: each adds itself to the command line.
#ifndef GEMINGA_ONTOLOGY_COMMANDS_HPP
#define GEMINGA_ONTOLOGY_COMMANDS_HPP

#include <CLI/App.hpp>
#include <memory>

#include "ontology/command/choice.hpp"
#include "ontology/command/output.hpp"

namespace geminga::ontology {

void add_check(CLI::App& program, Choice& choice);
void add_classify(CLI::App& program, Choice& choice);
void add_subsumes(CLI::App& program, Choice& choice);
void add_entails(CLI::App& program, Choice& choice);
void add_consistent(CLI::App& program, Choice& choice);
void add_explain(CLI::App& program, Choice& choice);
void add_id(CLI::App& program, Choice& choice);
void add_compile(CLI::App& program, Choice& choice);
void add_describe(CLI::App& program, Choice& choice);
void add_draw(CLI::App& program, Choice& choice);
void add_infer(CLI::App& program, Choice& choice);
void add_convert(CLI::App& program, Choice& choice);
void add_merge(CLI::App& program, Choice& choice);
void add_query(CLI::App& program, Choice& choice);
void add_realize(CLI::App& program, Choice& choice);
void add_instances(CLI::App& program, Choice& choice);
void add_rank(CLI::App& program, Choice& choice);
void add_repair(CLI::App& program, Choice& choice);
void add_diff(CLI::App& program, Choice& choice);
void add_extract(CLI::App& program, Choice& choice);
void add_report(CLI::App& program, Choice& choice);
void add_align(CLI::App& program, Choice& choice);
void add_serve(CLI::App& program, Choice& choice);
void add_fetch(CLI::App& program, Choice& choice);
void add_adopt(CLI::App& program, Choice& choice);
void add_task(CLI::App& program, Choice& choice);

/// Chooses `run` for this request when the command line names `command`. Where the request has an output, that is the
/// command's output.
template <typename Request>
void run_when_named(CLI::App& command, Choice& choice, const std::shared_ptr<Request>& request,
                    Exit (*run)(const Request&, const WorkLimits&)) {
  command.callback([&choice, request, run] {
    if constexpr (requires { request->out; }) {
      if (request->out != to_standard_output) choice.outputs.push_back(request->out);
    }
    choice.run = [&choice, request, run] { return run(*request, choice.limits); };
  });
}

}  // namespace geminga::ontology

#endif
