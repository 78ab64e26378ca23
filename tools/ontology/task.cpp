// `geminga-ontology task`: the tasks of a file as JSON, for `geminga-query team FILE`.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/json.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/loading/classified_files.hpp"
#include "ontology/tasks/tasks.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {
namespace {

struct TaskRequest {
  std::string task;
  std::vector<std::string> files;  ///< that say what the properties are
};

std::optional<owl::FileId> task_file(const owl::Ontology& source, const std::string& path) {
  const auto at = std::ranges::find(source.files(), path, &owl::LoadedFile::path);
  if (at == source.files().end()) return std::nullopt;
  return owl::FileId{static_cast<std::uint32_t>(at - source.files().begin())};
}

/// The first property of the file that no file declares, whose statements are no facts therefore.
const rdf::UsedName* first_undeclared(const rdf::Loaded& loaded, owl::FileId file) {
  const rdf::UsedName* first = nullptr;
  for (const rdf::UsedName& one : loaded.undeclared_predicates) {
    if (owl::FileId{one.file} == file && (first == nullptr || one.line < first->line)) first = &one;
  }
  return first;
}

/// Labels where there are some, else short names.
owl::ShortName names_of(const rdf::Loaded& loaded) {
  std::map<std::string, std::string, std::less<>> labels;
  for (const owl::Annotation& one : loaded.annotations) {
    const bool is_label = one.of == owl::Annotation::Of::name && one.is_literal &&
                          one.property == "http://www.w3.org/2000/01/rdf-schema#label";
    if (is_label) labels.emplace(one.subject, one.value);
  }
  return [labels = std::move(labels), short_name = short_names(loaded.source)](std::string_view iri) {
    const auto label = labels.find(iri);
    return label == labels.end() ? short_name(iri) : label->second;
  };
}

boost::json::object as_json(const Task& task) {
  boost::json::array roles;
  for (const Role& role : task.roles) {
    roles.push_back(boost::json::object{{"iri", role.iri},
                                        {"name", role.name},
                                        {"expression", role.expression},
                                        {"where", role.condition},
                                        {"count", role.count},
                                        {"shared", role.is_shared},
                                        {"line", role.line}});
  }
  return {{"iri", task.iri},
          {"name", task.name},
          {"prefer", task.prefer},
          {"line", task.line},
          {"roles", std::move(roles)}};
}

Exit task(const TaskRequest& request, const WorkLimits&) {
  std::vector<std::string> files{request.task};
  files.insert(files.end(), request.files.begin(), request.files.end());
  Progress progress(true);
  const LoadOptions options{.says_files = false, .annotations = KeptAnnotations::all};
  auto loaded = load(files, progress, options);
  const auto lacks_words = [&] {
    const auto file = task_file(loaded->source, request.task);
    return file && first_undeclared(*loaded, *file) != nullptr;
  };
  const std::filesystem::path shipped = shipped_ontologies() / "capability.ttl";
  std::error_code error;
  if (loaded && lacks_words() && std::filesystem::exists(shipped, error)) {
    files.push_back(shipped.string());
    loaded = load(files, progress, options);
  }
  progress.clear();
  if (!loaded) return say_error(loaded.error().text);
  const std::string name = base::printable(request.task, 4096);
  const auto place = [&](std::uint32_t line) { return name + ':' + (line == 0 ? " " : std::to_string(line) + ": "); };
  const auto file = task_file(loaded->source, request.task);
  if (!file) return say_error(name + ": is no file: name one with a task");
  if (const rdf::UsedName* one = first_undeclared(*loaded, *file)) {
    return say_error(place(one->line) + base::printable(short_names(loaded->source)(one->iri), 400) +
                     " is declared in no file: mend the word, or name its ontology behind the task");
  }
  const auto tasks = read_tasks(loaded->source, *file, names_of(*loaded));
  if (!tasks) return say_error(place(tasks.error().line) + base::printable(tasks.error().text, 1000));
  if (tasks->empty()) {
    return say_error(name + ": has no task: state an individual with the class capability:Task (<" +
                     std::string(task_words) + "Task>)");
  }
  boost::json::array all;
  for (const Task& one : *tasks) all.push_back(as_json(one));
  return print_or_say(json_text(boost::json::object{{"tasks", std::move(all)}}) + '\n');
}

}  // namespace

void add_task(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<TaskRequest>();
  CLI::App* command = program.add_subcommand("task", "Write the tasks of a file and their roles as JSON");
  command->add_option("TASK", request->task, "a file with tasks, in any syntax")->required()->type_name("FILE");
  command->add_option("FILES", request->files, "ontology files, or folders of them, that declare the properties")
      ->type_name("");
  add_run_limits(*command, choice);
  command->footer(
      "\nA task is an individual of the class capability:Task and capability:hasRole, each with what its holder is\n"
      "(capability:heldBy with its class, or capability:expression with a class expression as text), and perhaps\n"
      "capability:count, capability:shared and capability:where. The task may have capability:prefer.\n"
      "This is how geminga-query team reads a FILE.\n"
      "\nExample:\n  geminga-ontology task task.ttl team/");
  run_when_named(*command, choice, request, task);
}

}  // namespace geminga::ontology
