// Loads and classifies, with the clock running.
#include "knowledge.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "readers.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/container.hpp"
#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/compiled/similar.hpp"
#include "reasoning/owl/print.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

/// From these on it is said at once what is being done; what is smaller is done in a moment.
constexpr std::uintmax_t large_octets = std::uintmax_t{8} << 20U;
constexpr std::size_t large_axioms = 50'000;
/// Of the files in folders that are no ontologies, so many are named.
constexpr std::size_t max_skipped_shown = 3;

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Of the files, and of those in the folders.
std::uintmax_t size_of(const std::vector<std::string>& files) {
  std::uintmax_t octets = 0;
  const auto listing = syntax::list_files(files, {});
  if (!listing) return octets;  // whoever reads them says why
  for (const std::string& file : listing->files) {
    std::error_code error;
    const std::uintmax_t size =
        std::filesystem::is_regular_file(file, error) ? std::filesystem::file_size(file, error) : 0;
    if (!error) octets += size;
  }
  return octets;
}

/// What was found where folders were walked, in one line: whoever named a folder does not know what is in it.
std::string words_of(const rdf::Loaded& loaded) {
  std::map<std::string_view, std::size_t> by_syntax;
  for (const syntax::Syntax syntax : loaded.syntaxes) ++by_syntax[syntax::to_string(syntax)];
  const syntax::Listing& listing = loaded.listing;
  std::string text = "read " + counted(listing.files.size(), "file", "files") + " in " +
                     counted(listing.folders.size(), "folder", "folders") + ':';
  std::string_view separator = " ";
  for (const auto& [syntax, count] : by_syntax) {
    text.append(separator).append(std::to_string(count)).append(" ").append(syntax);
    separator = ", ";
  }
  if (listing.skipped.empty()) return text;
  text += "; skipped " + counted(listing.skipped.size(), "other", "others") + ": ";
  separator = "";
  for (std::size_t at = 0; at < std::min(listing.skipped.size(), max_skipped_shown); ++at) {
    text.append(separator).append(base::printable(listing.skipped[at], 200));
    separator = ", ";
  }
  return listing.skipped.size() > max_skipped_shown ? text + ", ..." : text;
}

}  // namespace

std::expected<rdf::Loaded, NoKnowledge> load(const std::vector<std::string>& files, Progress& progress,
                                             const Learning& how) {
  if (const std::uintmax_t octets = size_of(files); octets >= large_octets)
    progress.show("reading " + std::to_string(octets >> 20U) + " MiB", 0, true);
  Readers readers(how.keeps_annotations);
  auto loaded = rdf::load(files, {}, &readers, how.threads);
  if (!loaded) return std::unexpected(NoKnowledge{syntax::to_string(loaded.error()), loaded.error().is_unreadable});
  if (how.says_files && !loaded->listing.folders.empty()) {
    progress.clear();
    say_error(words_of(*loaded));
  }
  return std::move(*loaded);
}

std::expected<Knowledge, NoKnowledge> learn(const std::vector<std::string>& files, const Learning& how) {
  Progress progress(!how.as_json);
  const auto start = std::chrono::steady_clock::now();
  auto loaded = load(files, progress, how);
  if (!loaded) return std::unexpected(std::move(loaded.error()));
  return learn(std::move(*loaded), milliseconds_since(start), progress, how);
}

std::expected<Knowledge, NoKnowledge> learn(rdf::Loaded loaded, double load_ms, Progress& progress,
                                            const Learning& how) {
  const auto read = std::chrono::steady_clock::now();
  const bool is_long = loaded.source.axiom_count() >= large_axioms;
  const auto show = [&](std::string_view phase, double done) { progress.show(phase, done, is_long && done == 0); };
  auto classification =
      reasoner::classify(loaded.source, {.threads = how.threads, .budget = how.budget, .progress = show});
  if (!classification) return std::unexpected(NoKnowledge{classification.error().text, false});
  return Knowledge{std::move(loaded), std::move(*classification), load_ms, milliseconds_since(read)};
}

std::optional<Knowledge> learn_or_say(const std::vector<std::string>& files, const Learning& how) {
  auto knowledge = learn(files, how);
  if (knowledge) return std::move(*knowledge);
  say_failure(knowledge.error().text, how.as_json);
  return std::nullopt;
}

std::optional<std::string> describe_undecided(const Knowledge& knowledge) {
  const reasoner::Undecided& undecided = knowledge.classification.undecided;
  const std::size_t count = undecided.classes.size();
  if (count == 0 && !undecided.consistency) return std::nullopt;
  const auto short_name = short_names(knowledge.loaded.source);
  const auto iri = [&](taxonomy::ClassNumber of) {
    return knowledge.loaded.source.name(knowledge.classification.classes[static_cast<std::size_t>(of)]);
  };
  const auto is_individual = [&](taxonomy::ClassNumber of) { return iri(of).starts_with(only_individual); };
  const auto name = [&](taxonomy::ClassNumber of) {
    return short_name(is_individual(of) ? iri(of).substr(only_individual.size()) : iri(of));
  };
  const auto individuals = static_cast<std::size_t>(std::ranges::count_if(undecided.classes, is_individual));
  std::string line(compiled::undecided_words);
  if (count > individuals) line += counted(count - individuals, "class", "classes");
  if (individuals > 0) line += (count > individuals ? " and " : "") + counted(individuals, "individual", "individuals");
  if (count > 0) line += " (" + name(undecided.classes.front()) + (count == 1 ? ")" : ", ...)");
  if (undecided.consistency) line += std::string(count > 0 ? ", and " : "") + "whether there is a contradiction";
  if (undecided.held_up_by) line += "; held up by " + name(*undecided.held_up_by);
  return line;
}

std::vector<std::string> gaps_of(const Knowledge& knowledge) {
  std::vector<std::string> gaps = knowledge.classification.gaps;
  if (auto line = describe_undecided(knowledge)) gaps.push_back(std::move(*line));
  return gaps;
}

Exit exit_of(const Knowledge& knowledge, Exit exit) {
  if (!knowledge.classification.is_cut_off) return exit;
  return say_error(base::joined(knowledge.classification.gaps, ", ") + ", and what is settled by then counts: " +
                       describe_undecided(knowledge).value_or("everything is decided") + ": raise the limit",
                   Exit::timed_out);
}

std::optional<compiled::Ontology> open_or_say(const Knowledge& knowledge) {
  const std::vector<std::string> gaps = gaps_of(knowledge);
  auto ontology = compiled::Ontology::from_bytes(
      compiled::compile(knowledge.loaded.source, knowledge.classification, {.gaps = gaps, .folder = {}}));
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

std::optional<compiled::Ontology> learn_ontology_or_say(const std::vector<std::string>& files, const Learning& how) {
  if (!is_compiled(files)) {
    const auto knowledge = learn_or_say(files, how);
    return knowledge ? open_or_say(*knowledge) : std::nullopt;
  }
  auto ontology = open_compiled(files.front());
  const auto stale = ontology ? ontology->stale_source() : std::nullopt;
  if (ontology && !stale) return std::move(*ontology);
  say_failure(ontology ? files.front() + ": " + *stale : ontology.error().text, how.as_json);
  return std::nullopt;
}

std::string describe(const compiled::Ontology& ontology, const std::string& name, const compiled::NameError& error) {
  if (error.kind != compiled::NameError::Kind::unknown) return error.text;
  return error.text + compiled::did_you_mean(compiled::find_similar(ontology, name));
}

std::expected<taxonomy::ClassNumber, std::string> find_class(const compiled::Ontology& ontology,
                                                             const std::string& name) {
  const auto number = ontology.find(name);
  if (number) return *number;
  if (number.error().kind != compiled::NameError::Kind::unknown) return std::unexpected(number.error().text);
  std::vector<taxonomy::ClassNumber> found;
  for (std::uint32_t at = 0; at < ontology.class_count(); ++at) {
    if (compiled::end_of_iri(ontology.iri(taxonomy::ClassNumber{at})) == name)
      found.push_back(taxonomy::ClassNumber{at});
  }
  if (found.size() == 1) return found.front();
  if (found.empty()) return std::unexpected(describe(ontology, name, number.error()));
  std::vector<std::string> candidates;
  for (const taxonomy::ClassNumber candidate : found) candidates.push_back(ontology.short_name(candidate));
  return std::unexpected('\'' + base::printable(name) + "' may be " + compiled::alternatives(candidates) +
                         ": say which");
}

std::optional<taxonomy::ClassNumber> find_or_say(const compiled::Ontology& ontology, const std::string& name,
                                                 bool as_json) {
  const auto number = find_class(ontology, name);
  if (number) return *number;
  say_failure(number.error(), as_json);
  return std::nullopt;
}

std::function<std::string(std::string_view)> short_names(const owl::Ontology& source) {
  std::vector<std::pair<std::string_view, std::string_view>> prefixes;
  for (const owl::Ontology::Prefix& prefix : source.prefixes())
    prefixes.emplace_back(source.name(prefix.prefix), source.name(prefix.iri));
  std::ranges::sort(prefixes);
  return [prefixes = std::move(prefixes)](std::string_view iri) { return owl::shorten(iri, prefixes); };
}

std::size_t class_count(const Knowledge& knowledge) { return knowledge.classification.class_count() - 2; }

bool is_unsatisfiable(const taxonomy::Classification& classification, taxonomy::ClassNumber number) {
  const auto representative = [&](taxonomy::ClassNumber c) {
    return classification.representative[static_cast<std::size_t>(c)];
  };
  return !classification.is_consistent || representative(number) == representative(classification.nothing);
}

bool is_undecided(const reasoner::Classified& classification, taxonomy::ClassNumber number) {
  const reasoner::Undecided& undecided = classification.undecided;
  return undecided.consistency || std::ranges::binary_search(undecided.classes, number);
}

std::filesystem::path shipped_ontologies() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share" / "geminga" / "ontology";
}

}  // namespace geminga::ontology
