// `geminga-ontology draw`: a picture of the taxonomy, one box for each node of equivalent classes.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <memory>

#include "closure.hpp"
#include "command.hpp"
#include "knowledge.hpp"
#include "words.hpp"

extern char** environ;

namespace geminga::ontology {
namespace {

struct Request {
  std::vector<std::string> files;
  std::string root;
  std::string format = "dot";
};

struct Box {
  el::ClassNumber node{};
  std::vector<std::string> names;
  std::vector<el::ClassNumber> parents;  ///< those that are in the picture
};

/// The nodes below a root, itself included, or below owl:Thing without it; ascending.
std::vector<Box> boxes(const el::Ontology& ontology, const el::Classification& classification,
                       std::optional<el::ClassNumber> root) {
  const auto members = equivalents(classification);
  const auto index = [](el::ClassNumber number) { return static_cast<std::size_t>(number); };
  const auto representative = [&](el::ClassNumber number) { return classification.representative[index(number)]; };
  const auto is_in = [&](el::ClassNumber node) {
    if (members[index(node)].empty()) return false;
    if (root && representative(*root) == node) return true;
    if (node == representative(classification.nothing)) return members[index(node)].size() > 1 && !root;
    return root ? ontology.is_subsumed(node, *root)
                : node != representative(classification.thing) || members[index(node)].size() > 1;
  };
  std::vector<Box> found;
  for (std::uint32_t number = 0; number < classification.class_count(); ++number) {
    const el::ClassNumber node{number};
    if (!is_in(node)) continue;
    Box box{node, {}, {}};
    for (const el::ClassNumber member : members[number]) {
      const std::string_view label = ontology.label(member);
      const std::string name = ontology.short_name(member);
      box.names.push_back(name.starts_with('<') && !label.empty() ? std::string(label) : name);
    }
    for (const el::ClassNumber parent : classification.parents_of(node)) {
      if (is_in(parent)) box.parents.push_back(parent);
    }
    found.push_back(std::move(box));
  }
  return found;
}

std::string escaped(std::string_view text, std::string_view special, std::string_view before) {
  std::string safe;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) safe += before;
    safe += c;
  }
  return safe;
}

std::string as_dot(const std::vector<Box>& boxes) {
  std::string text =
      "digraph taxonomy {\n  rankdir=RL;\n  ranksep=0.6;\n  nodesep=0.12;\n"
      "  node [shape=box, style=\"rounded,filled\", fillcolor=\"#f4f6fa\", color=\"#5b6b8c\", fontname=\"Helvetica\", "
      "fontsize=11, height=0.3, margin=\"0.12,0.04\"];\n  edge [color=\"#8896b3\", arrowhead=empty, arrowsize=0.6];\n";
  for (const Box& box : boxes) {
    text += "  c" + std::to_string(static_cast<std::uint32_t>(box.node)) + " [label=\"";
    for (std::size_t name = 0; name < box.names.size(); ++name)
      text += (name == 0 ? "" : "\\n= ") + escaped(box.names[name], "\"\\", "\\");
    text += box.names.size() > 1 ? "\", fillcolor=\"#e3ecdb\"];\n" : "\"];\n";
  }
  for (const Box& box : boxes) {
    for (const el::ClassNumber parent : box.parents)
      text += "  c" + std::to_string(static_cast<std::uint32_t>(box.node)) + " -> c" +
              std::to_string(static_cast<std::uint32_t>(parent)) + ";\n";
  }
  return text + "}\n";
}

/// Mermaid reads character references inside quotes, and nothing else is special there.
std::string for_mermaid(std::string_view name) {
  std::string safe;
  for (const char c : name) {
    if (std::string_view("\"<>&#;").find(c) != std::string_view::npos) {
      safe += '#' + std::to_string(static_cast<int>(c)) + ';';
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string as_mermaid(const std::vector<Box>& boxes) {
  std::string text = "graph RL\n";
  for (const Box& box : boxes) {
    text += "  c" + std::to_string(static_cast<std::uint32_t>(box.node)) + "[\"";
    for (std::size_t name = 0; name < box.names.size(); ++name)
      text += (name == 0 ? "" : "<br/>= ") + for_mermaid(box.names[name]);
    text += "\"]\n";
  }
  for (const Box& box : boxes) {
    for (const el::ClassNumber parent : box.parents)
      text += "  c" + std::to_string(static_cast<std::uint32_t>(box.node)) + " --> c" +
              std::to_string(static_cast<std::uint32_t>(parent)) + "\n";
  }
  return text;
}

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
  const auto picture = boxes(*ontology, knowledge->classification, root);
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
  command->add_option("--format", request->format, "dot, mermaid, or svg (which needs the program dot)")
      ->check(CLI::IsMember({"dot", "mermaid", "svg"}))
      ->type_name("FORMAT");
  command->footer("\nExample:\n  geminga-ontology draw team/ --root soccer:BallInfo --format svg > ball.svg");
  command->callback([request, &choice] {
    choice.may_execute = request->format == "svg";
    choice.run = [request] { return draw(*request); };
  });
}

}  // namespace geminga::ontology
