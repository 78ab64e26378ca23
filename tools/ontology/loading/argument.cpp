#include "ontology/loading/argument.hpp"

#include <filesystem>
#include <set>
#include <system_error>

#include "ontology/command/words.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/folders.hpp"

namespace geminga::ontology {
namespace {

/// One path for a file, however it was named.
std::string resolved(const std::string& path) {
  std::error_code error;
  const std::filesystem::path found = std::filesystem::weakly_canonical(path, error);
  return error ? path : found.string();
}

/// Those that cannot be listed are told by load().
std::expected<std::set<std::string>, LoadFailure> files_of(const std::string& argument, const LoadOptions& options) {
  std::vector<syntax::LoadError> left_out;
  const auto paths =
      syntax::list_files(std::vector{argument}, {}, {}, options.leaves_out_refused ? &left_out : nullptr);
  if (!paths) return std::unexpected(LoadFailure{syntax::to_string(paths.error()), paths.error().is_unreadable});
  std::set<std::string> files;
  for (const std::string& path : paths->files) files.insert(resolved(path));
  return files;
}

}  // namespace

std::optional<std::string> find_unread(const owl::Ontology& source, const std::vector<bool>& files,
                                       bool with_ill_typed) {
  for (const owl::Ontology::Omission& omission : source.omissions()) {
    const auto file = static_cast<std::size_t>(omission.file);
    if (!files.empty() && !files[file]) continue;
    const std::string_view construct = source.name(omission.construct);
    if (construct.starts_with(import_words) || (!with_ill_typed && owl::is_ill_typed(construct))) continue;
    std::string text = std::string(construct) + " is not understood: " + source.files()[file].path;
    if (omission.line != 0) text += ':' + std::to_string(omission.line);
    return text;
  }
  return std::nullopt;
}

void say_unresolved(const rdf::Loaded& loaded) {
  for (const rdf::UnresolvedImport& import : loaded.unresolved)
    say_error(import.file + ':' + std::to_string(import.line) + ": imports <" + import.iri +
              ">, which no given file answers, and is decided without it: put both into one folder and name that");
}

std::expected<Argument, LoadFailure> load_argument(const std::string& premise, const std::string& conclusion,
                                                   Progress& progress, const LoadOptions& options) {
  const auto premise_files = files_of(premise, options);
  if (!premise_files) return std::unexpected(premise_files.error());
  const auto conclusion_files = files_of(conclusion, options);
  if (!conclusion_files) return std::unexpected(conclusion_files.error());
  auto loaded = load({premise, conclusion}, progress, options);
  if (!loaded) return std::unexpected(std::move(loaded.error()));
  Argument argument{std::move(*loaded), {}, {}, {}, {}, {}};
  const owl::Ontology& source = argument.loaded.source;
  std::vector<bool> in_premise;
  std::vector<bool> in_conclusion;
  for (const owl::LoadedFile& file : source.files()) {
    in_premise.push_back(premise_files->contains(resolved(file.path)));
    in_conclusion.push_back(conclusion_files->contains(resolved(file.path)));
  }
  for (std::uint32_t axiom = 0; axiom < source.axiom_count(); ++axiom) {
    const auto file = static_cast<std::size_t>(source.axiom(axiom).file);
    if (in_premise[file]) argument.premise.push_back(axiom);
    if (in_conclusion[file]) argument.conclusion.push_back(axiom);
  }
  for (std::size_t axiom = 0; axiom < source.ill_typed_count(); ++axiom) {
    if (in_premise[static_cast<std::size_t>(source.ill_typed(axiom).file)]) argument.ill_typed.push_back(axiom);
  }
  argument.unread_premise = find_unread(source, in_premise, false);
  argument.unread_conclusion = find_unread(source, in_conclusion, true);
  for (const syntax::LoadError& refused : argument.loaded.refused) {
    const std::string why = "a file cannot be read: " + syntax::to_string(refused);
    const std::string file = resolved(refused.file);
    if (!conclusion_files->contains(file) || premise_files->contains(file)) argument.unread_premise = why;
    if (!premise_files->contains(file) || conclusion_files->contains(file)) argument.unread_conclusion = why;
  }
  return argument;
}

}  // namespace geminga::ontology
