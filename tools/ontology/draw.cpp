// `geminga-ontology draw`: a picture of the taxonomy, one box for each node of equivalent classes.
#include <CLI/CLI.hpp>
#include <memory>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/loading/class_names.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "ontology/picture/graphviz.hpp"
#include "ontology/picture/picture.hpp"

namespace geminga::ontology {
namespace {

struct DrawRequest {
  std::vector<std::string> files;
  std::string root;
  std::string format = "dot";
  unsigned depth = 0;  ///< 0: all
  bool is_compact = false;
};

Exit draw(const DrawRequest& request, const Graphviz& graphviz) {
  const auto classified = classify_or_say(request.files);
  if (!classified) return Exit::usage;
  const auto ontology = compile_or_say(*classified);
  if (!ontology) return Exit::usage;
  std::optional<taxonomy::ClassNumber> root;
  if (!request.root.empty()) {
    root = find_or_say(*ontology, request.root);
    if (!root) return Exit::usage;
  }
  const std::optional<unsigned> depth = request.depth == 0 ? std::nullopt : std::optional(request.depth);
  Picture picture = make_picture(classified->loaded.source, classified->classification, *ontology, root, depth);
  if (request.is_compact) picture = with_lists_of_leaves(std::move(picture));
  if (request.format == "svg") {
    return graphviz.draw(as_dot(picture))
               ? Exit::yes
               : say_error("the program dot failed: ask for --format dot, or draw less with --root");
  }
  return print_or_say(request.format == "dot" ? as_dot(picture) : as_mermaid(picture));
}

}  // namespace

void add_draw(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<DrawRequest>();
  CLI::App* command = program.add_subcommand("draw", "Draw the taxonomy, or the part below one class");
  add_files(*command, request->files);
  command->add_option("--root", request->root, "draw this class and what is below it")->type_name("CLASS");
  add_number(*command, "--depth", request->depth, 1, 1000,
             "draw so many levels below the root, and say how many classes are hidden below them");
  command->add_flag("--compact", request->is_compact, "list leaves below the same class in one box");
  command->add_option("--format", request->format, "dot, mermaid, or svg (which needs the program dot)")
      ->check(CLI::IsMember({"dot", "mermaid", "svg"}))
      ->type_name("FORMAT");
  command->footer(
      "\nExamples:\n  geminga-ontology draw team/ --root soccer:BallInfo --format svg > ball.svg\n"
      "  geminga-ontology draw team/ --root geminga:Observation --depth 2 --format svg > observations.svg");
  command->callback([request, &choice] {
    const auto graphviz = std::make_shared<Graphviz>();
    if (request->format == "svg") {
      choice.prepare = [graphviz] {
        return graphviz->start()
                   ? Exit::yes
                   : say_error("the program dot cannot be run: install graphviz, or ask for --format dot");
      };
    }
    choice.run = [request, graphviz] { return draw(*request, *graphviz); };
  });
}

}  // namespace geminga::ontology
