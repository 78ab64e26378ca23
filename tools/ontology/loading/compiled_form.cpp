#include "ontology/loading/compiled_form.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "ontology/command/words.hpp"
#include "ontology/loading/consistency.hpp"
#include "ontology/loading/refused.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/container.hpp"

namespace geminga::ontology {

std::optional<compiled::Ontology> compile_or_say(const ClassifiedFiles& classified) {
  const std::vector<std::string> gaps = gaps_of(classified);
  auto ontology = compiled::Ontology::from_bytes(
      compiled::compile(classified.loaded.source, classified.classification, {.gaps = gaps, .folder = {}}));
  if (ontology) return std::move(*ontology);
  say_error(ontology.error().text);
  return std::nullopt;
}

bool is_compiled(const std::vector<std::string>& files) {
  std::error_code error;
  if (files.size() != 1 || !std::filesystem::is_regular_file(files.front(), error)) return false;
  std::array<char, compiled::compiled_magic.size()> begin{};
  std::ifstream(files.front(), std::ios::binary).read(begin.data(), begin.size());
  return begin == compiled::compiled_magic;
}

std::expected<compiled::Ontology, compiled::CompiledError> open_compiled(const std::string& file) {
  auto ontology = compiled::Ontology::map(file);
  if (!ontology) return std::unexpected(std::move(ontology.error()));
  if (const auto whole = ontology->check_whole(); !whole) {
    return std::unexpected(compiled::CompiledError{file + ": " + whole.error().text});
  }
  return ontology;
}

namespace {

std::optional<Opened> open_classified(std::optional<ClassifiedFiles> classified, const LoadOptions& options) {
  auto compiled = classified ? compile_or_say(*classified) : std::nullopt;
  if (!compiled) return std::nullopt;
  auto refused = describe_refused(classified->loaded);
  reasoner::Answer consistency = consistency_of(*classified, options.budget);
  return Opened{std::move(*compiled), std::move(consistency), std::move(refused), std::move(classified)};
}

}  // namespace

std::optional<Opened> classify_and_compile_or_say(rdf::Loaded loaded, const LoadOptions& options) {
  Progress progress(!options.as_json);
  auto classified = classify_files(std::move(loaded), 0, progress, options);
  if (classified) return open_classified(std::move(*classified), options);
  say_failure(classified.error().text, options.as_json);
  return std::nullopt;
}

std::optional<Opened> open_or_say(const std::vector<std::string>& files, const LoadOptions& options) {
  if (!is_compiled(files)) return open_classified(classify_or_say(files, options), options);
  auto ontology = open_compiled(files.front());
  const auto stale = ontology ? ontology->stale_source() : std::nullopt;
  if (ontology && !stale) {
    reasoner::Answer consistency = consistency_of(*ontology);
    return Opened{std::move(*ontology), std::move(consistency), {}};
  }
  say_failure(ontology ? files.front() + ": " + *stale : ontology.error().text, options.as_json);
  return std::nullopt;
}

}  // namespace geminga::ontology
