// Loads and classifies, with the clock running.
#include "knowledge.hpp"

#include <chrono>
#include <system_error>

#include "el/compile.hpp"
#include "functional/read.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The syntax in which SOMA and its like are published has a reader of its own.
std::expected<rdf::OtherDocument, rdf::LoadError> read_functional(std::string_view bytes, el::FileId file,
                                                                  el::OntologySource& source) {
  auto document = functional::read(bytes, file, source);
  if (!document)
    return std::unexpected(
        rdf::LoadError{std::move(document.error().file), document.error().line, std::move(document.error().text)});
  rdf::OtherDocument other{std::move(document->ontology_iri), std::move(document->version_iri), {}, {}};
  for (functional::Import& import : document->imports) other.imports.push_back({std::move(import.iri), import.line});
  for (functional::DeclaredPrefix& prefix : document->prefixes)
    other.prefixes.emplace_back(std::move(prefix.prefix), std::move(prefix.iri));
  return other;
}

}  // namespace

std::expected<Knowledge, NoKnowledge> learn(const std::vector<std::string>& files, unsigned threads) {
  const auto start = std::chrono::steady_clock::now();
  auto loaded = rdf::load(files, {}, read_functional);
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
