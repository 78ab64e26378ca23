#include "ontology/cage.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <utility>

#include "env/cage/cage.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {
namespace {

/// Adds the sources of a compiled form, which the program compares with it.
void add_sources(const std::string& file, std::vector<std::string>& readable) {
  if (!is_compiled({file})) return;
  const auto ontology = compiled::Ontology::map(file);
  if (!ontology) return;
  for (const owl::LoadedFile& source : ontology->files()) readable.push_back(source.path);
}

}  // namespace

std::expected<void, std::string> close_cage(const CLI::App& command, const Choice& choice) {
  cage::Freedom freedom;
  freedom.readable = choice.readable;
  freedom.readable.push_back(shipped_ontologies().string());
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& word : option->results()) {
      freedom.readable.push_back(word);  // a word that names no file gives no right
      add_sources(word, freedom.readable);
    }
  }
  for (const std::string& output : choice.outputs) {
    const std::filesystem::path folder = std::filesystem::path(output).parent_path();
    freedom.writable_folders.push_back(folder.empty() ? "." : folder.string());
  }
  freedom.may_talk = choice.may_talk;
  freedom.may_make_folders = choice.may_make_folders;
  cage::Held held = cage::close(freedom);
  if (!held.fault.empty()) return std::unexpected(std::move(held.fault));
  return {};
}

}  // namespace geminga::ontology
