// `geminga-ontology subsumes`: is one class subsumed by another?
#include <CLI/CLI.hpp>
#include <memory>

#include "command.hpp"
#include "knowledge.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

struct Request {
  std::vector<std::string> files;
  std::string sub;
  std::string super;
};

Exit subsumes(const Request& request) {
  const auto knowledge = learn_or_say(request.files);
  if (!knowledge) return Exit::usage;
  const auto ontology = open_or_say(*knowledge);
  if (!ontology) return Exit::usage;
  const auto sub = find_or_say(*ontology, request.sub);
  const auto super = find_or_say(*ontology, request.super);
  if (!sub || !super) return Exit::usage;
  const bool is_subsumed = is_unsatisfiable(knowledge->classification, *sub) || ontology->is_subsumed(*sub, *super);
  const std::string answer = is_subsumed ? " is subsumed by " : " is not subsumed by ";
  if (!print(ontology->short_name(*sub) + answer + ontology->short_name(*super) + '\n'))
    return say_error("standard output cannot be written");
  return is_subsumed ? Exit::yes : Exit::no;
}

}  // namespace

void add_subsumes(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<Request>();
  CLI::App* command =
      program.add_subcommand("subsumes", "Tell whether class A is subsumed by class B: exit 0 yes, 1 no");
  add_files(*command, request->files);
  command->add_option("--sub", request->sub, "the class that may be the narrower one")->required()->type_name("A");
  command->add_option("--super", request->super, "the class that may be the broader one")->required()->type_name("B");
  command->footer("\nExample:\n  geminga-ontology subsumes team/ --sub soccer:BallInfo --super geminga:TrackedObject");
  command->callback([request, &choice] { choice.run = [request] { return subsumes(*request); }; });
}

}  // namespace geminga::ontology
