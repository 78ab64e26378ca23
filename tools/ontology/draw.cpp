// `geminga-ontology draw`: a picture of the taxonomy, one box for each node of equivalent classes.
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cerrno>
#include <csignal>
#include <memory>

#include "base/harmless.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/individuals/realized_files.hpp"
#include "ontology/loading/class_names.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "ontology/loading/refused.hpp"
#include "ontology/picture/picture.hpp"

namespace geminga::ontology {
namespace {

struct DrawRequest {
  std::vector<std::string> files;
  std::string root;
  std::string format = "dot";
  unsigned depth = 0;  ///< 0: all
  bool is_compact = false;
  bool is_lenient = false;
  bool is_strict = false;
};

/// Graphviz as a child process, which turns a graph in its language into SVG on standard output.
class Graphviz {
 public:
  /// Starts the program dot, which waits for its input. False where there is none. To be called before the cage is
  /// closed, which lets no program start.
  bool start() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    std::string program = "dot";
    std::string flag = "-Tsvg";
    char* arguments[] = {program.data(), flag.data(), nullptr};
    const int error = posix_spawnp(&child_, program.c_str(), &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    input_ = ends[1];
    return error == 0;
  }

  /// Gives dot the text and waits for its end. False where it failed.
  [[nodiscard]] bool draw(std::string_view text) const {
    std::signal(SIGPIPE, SIG_IGN);
    while (!text.empty()) {
      const ssize_t count = write(input_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    close(input_);
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    return text.empty() && status == 0;
  }

 private:
  int input_ = -1;
  pid_t child_ = 0;
};

Exit draw(const DrawRequest& request, const WorkLimits& limits, const Graphviz& graphviz) {
  base::Budget budget = budget_of(limits);
  const auto classified = classify_or_say(
      request.files, {.leaves_out_refused = !request.is_strict, .is_lenient = request.is_lenient, .budget = &budget});
  if (!classified) return Exit::usage;
  const auto ontology = compile_or_say(*classified);
  if (!ontology) return Exit::usage;
  if (!classified->classification.is_consistent) say_error(contradiction_words);
  std::optional<taxonomy::ClassNumber> root;
  if (!request.root.empty()) {
    root = find_or_say(*ontology, request.root);
    if (!root) return Exit::usage;
  }
  const std::optional<unsigned> depth = request.depth == 0 ? std::nullopt : std::optional(request.depth);
  Picture picture = make_picture(classified->loaded.source, classified->classification, *ontology, root, depth);
  if (request.is_compact) picture = with_lists_of_leaves(std::move(picture));
  if (request.format == "svg") {
    return graphviz.draw(base::harmless_lines(as_dot(picture)))
               ? exit_of(*classified, exit_of_list(classified->loaded, Exit::yes))
               : say_error("the program dot failed: ask for --format dot, or draw less with --root");
  }
  const Exit exit = print_or_say(request.format == "dot" ? as_dot(picture) : as_mermaid(picture));
  return exit == Exit::yes ? exit_of(*classified, exit_of_list(classified->loaded, exit)) : exit;
}

}  // namespace

void add_draw(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<DrawRequest>();
  CLI::App* command = program.add_subcommand("draw", "Draw the taxonomy, or the part below one class");
  add_files(*command, request->files);
  command->add_option("--root", request->root, "draw this class and what is below it")->type_name("CLASS");
  add_number(*command, "--depth", request->depth, 1, 1000,
             "draw so many levels below the root, and say how many classes are hidden below them");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  command->add_flag("--compact", request->is_compact, "list leaves below the same class in one box");
  command->add_option("--format", request->format, "dot, mermaid, or svg (which needs the program dot)")
      ->check(CLI::IsMember({"dot", "mermaid", "svg"}))
      ->type_name("FORMAT");
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nExit status 4: a limit was reached, and classes may stand too high in the picture. 1: a file of a folder\n"
      "cannot be read; it is named, and the picture is that of the others.\n"
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
    choice.run = [request, graphviz, &choice] { return draw(*request, choice.limits, *graphviz); };
  });
}

}  // namespace geminga::ontology
