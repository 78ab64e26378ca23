// `geminga-ontology draw`: a picture of the taxonomy, one box for each node of equivalent classes.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <memory>

#include "command.hpp"
#include "draw_picture.hpp"
#include "knowledge.hpp"
#include "words.hpp"

extern char** environ;

namespace geminga::ontology {
namespace {

struct Request {
  std::vector<std::string> files;
  std::string root;
  std::string format = "dot";
  unsigned depth = 0;  ///< 0: all
  bool is_compact = false;
};

/// Runs Graphviz over the text; its picture goes to our standard output.
Exit print_svg(const std::string& dot_text) {
  std::FILE* file = std::tmpfile();
  if (file == nullptr || std::fwrite(dot_text.data(), 1, dot_text.size(), file) != dot_text.size() ||
      std::fflush(file) != 0 || std::fseek(file, 0, SEEK_SET) != 0)
    return say_error("a temporary file cannot be written: set TMPDIR to a folder with space");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(file), STDIN_FILENO);
  std::string program = "dot";
  std::string flag = "-Tsvg";
  char* arguments[] = {program.data(), flag.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  std::fclose(file);
  if (error != 0) return say_error("the program dot cannot be run: install graphviz, or ask for --format dot");
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (status != 0) return say_error("the program dot failed: ask for --format dot, or draw less with --root");
  return Exit::yes;
}

Exit draw(const Request& request) {
  const auto knowledge = learn_or_say(request.files);
  if (!knowledge) return Exit::usage;
  const auto ontology = open_or_say(*knowledge);
  if (!ontology) return Exit::usage;
  std::optional<el::ClassNumber> root;
  if (!request.root.empty()) {
    root = find_or_say(*ontology, request.root);
    if (!root) return Exit::usage;
  }
  const std::optional<unsigned> depth = request.depth == 0 ? std::nullopt : std::optional(request.depth);
  Picture picture = make_picture(knowledge->loaded.source, knowledge->classification, *ontology, root, depth);
  if (request.is_compact) picture = with_lists_of_leaves(std::move(picture));
  if (request.format == "svg") return print_svg(as_dot(picture));
  return print(request.format == "dot" ? as_dot(picture) : as_mermaid(picture))
             ? Exit::yes
             : say_error("standard output cannot be written");
}

}  // namespace

void add_draw(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<Request>();
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
    choice.may_execute = request->format == "svg";
    choice.run = [request] { return draw(*request); };
  });
}

}  // namespace geminga::ontology
