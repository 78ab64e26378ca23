// Loads and classifies, with the clock running.
#include "knowledge.hpp"

#include <chrono>
#include <system_error>

#include "el/compile.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::expected<Knowledge, NoKnowledge> learn(const std::vector<std::string>& files, unsigned threads) {
  const auto start = std::chrono::steady_clock::now();
  auto loaded = rdf::load(files);
  if (!loaded) return std::unexpected(NoKnowledge{rdf::to_string(loaded.error()), loaded.error().is_unreadable});
  const double load_ms = milliseconds_since(start);
  const auto read = std::chrono::steady_clock::now();
  auto classification = el::classify(loaded->source, {.threads = threads});
  if (!classification) return std::unexpected(NoKnowledge{classification.error().text, false});
  return Knowledge{std::move(*loaded), std::move(*classification), load_ms, milliseconds_since(read)};
}

std::optional<Knowledge> learn_or_say(const std::vector<std::string>& files, unsigned threads) {
  auto knowledge = learn(files, threads);
  if (knowledge) return std::move(*knowledge);
  say_error(knowledge.error().text);
  return std::nullopt;
}

std::optional<el::Ontology> open_or_say(const Knowledge& knowledge) {
  auto ontology = el::Ontology::from_bytes(el::compile(knowledge.loaded.source, knowledge.classification));
  if (ontology) return std::move(*ontology);
  say_error(ontology.error().text);
  return std::nullopt;
}

std::optional<el::ClassNumber> find_or_say(const el::Ontology& ontology, const std::string& name) {
  const auto number = ontology.find(name);
  if (number) return *number;
  say_error(number.error().text);
  return std::nullopt;
}

std::size_t class_count(const Knowledge& knowledge) { return knowledge.classification.class_count() - 2; }

bool is_unsatisfiable(const el::Classification& classification, el::ClassNumber number) {
  const auto representative = [&](el::ClassNumber c) {
    return classification.representative[static_cast<std::size_t>(c)];
  };
  return !classification.is_consistent || representative(number) == representative(classification.nothing);
}

std::filesystem::path shipped_ontologies() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share" / "geminga" / "ontology";
}

}  // namespace geminga::ontology
