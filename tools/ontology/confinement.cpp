#include "confinement.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "env/cage/cage.hpp"
#include "knowledge.hpp"

namespace geminga::ontology {
namespace {

/// A compiled form is asked whether its sources have changed since.
void add_sources(const std::string& file, std::vector<std::string>& readable) {
  if (!is_compiled({file})) return;
  const auto ontology = compiled::Ontology::map(file);
  if (!ontology) return;
  for (const owl::LoadedFile& source : ontology->files()) readable.push_back(source.path);
}

}  // namespace

void shut_in(const CLI::App& command, const std::vector<std::string>& outputs,
             const std::vector<std::string>& readable) {
  cage::Freedom freedom;
  freedom.readable = readable;
  freedom.readable.push_back(shipped_ontologies().string());
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& word : option->results()) {
      freedom.readable.push_back(word);  // what names no file gives no right
      add_sources(word, freedom.readable);
    }
  }
  for (const std::string& output : outputs) {
    const std::filesystem::path folder = std::filesystem::path(output).parent_path();
    freedom.writable_folders.push_back(folder.empty() ? "." : folder.string());
  }
  cage::close(freedom);
}

}  // namespace geminga::ontology
