#include "ontology/loading/classified_files.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "ontology/command/words.hpp"
#include "ontology/loading/readers.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/owl/prefixes/prefixes.hpp"

namespace geminga::ontology {
namespace {

/// The most files in folders that are named because they are no ontologies.
constexpr std::size_t max_skipped_shown = 3;

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The octets of the files, and of those in the folders.
std::uintmax_t size_of(const std::vector<std::string>& files) {
  std::uintmax_t octets = 0;
  const auto listing = syntax::list_files(files, {});
  if (!listing) return octets;  // load() says why
  for (const std::string& file : listing->files) {
    std::error_code error;
    const std::uintmax_t size =
        std::filesystem::is_regular_file(file, error) ? std::filesystem::file_size(file, error) : 0;
    if (!error) octets += size;
  }
  return octets;
}

/// The files that the folders hold, in one line.
std::string folders_line(const rdf::Loaded& loaded) {
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

std::expected<rdf::Loaded, LoadFailure> load(const std::vector<std::string>& files, Progress& progress,
                                             const LoadOptions& options) {
  const std::uintmax_t octets = size_of(files);
  progress.show("reading" + (octets >> 20U == 0 ? "" : ' ' + std::to_string(octets >> 20U) + " MiB"));
  Readers readers(options.annotations != KeptAnnotations::none, options.threads);
  std::vector<syntax::LoadError> left_out;
  const syntax::FileLimits limits{.keeps_annotations = options.annotations == KeptAnnotations::all,
                                  .is_lenient = options.is_lenient};
  auto loaded = rdf::load(files, limits, &readers, options.threads, options.leaves_out_refused ? &left_out : nullptr);
  progress.clear();
  for (const syntax::LoadError& error : left_out)
    say_error(std::string(compiled::left_out_words) + syntax::to_string(error));
  if (!loaded) return std::unexpected(LoadFailure{syntax::to_string(loaded.error()), loaded.error().is_unreadable});
  if (options.says_files && !loaded->listing.folders.empty()) say_error(folders_line(*loaded));
  return std::move(*loaded);
}

std::expected<ClassifiedFiles, LoadFailure> classify_files(const std::vector<std::string>& files,
                                                           const LoadOptions& options) {
  Progress progress(!options.as_json);
  const auto start = std::chrono::steady_clock::now();
  auto loaded = load(files, progress, options);
  if (!loaded) return std::unexpected(std::move(loaded.error()));
  return classify_files(std::move(*loaded), milliseconds_since(start), progress, options);
}

std::expected<ClassifiedFiles, LoadFailure> classify_files(rdf::Loaded loaded, double load_ms, Progress& progress,
                                                           const LoadOptions& options) {
  const auto read = std::chrono::steady_clock::now();
  progress.show("classifying");
  const auto show = [&](std::string_view phase, double done) { progress.show(phase, done); };
  auto classification =
      reasoner::classify(loaded.source, {.threads = options.threads, .budget = options.budget, .progress = show});
  progress.clear();
  if (!classification) return std::unexpected(LoadFailure{classification.error().text, false});
  return ClassifiedFiles{std::move(loaded), std::move(*classification), load_ms, milliseconds_since(read)};
}

std::optional<ClassifiedFiles> classify_or_say(const std::vector<std::string>& files, const LoadOptions& options) {
  auto classified = classify_files(files, options);
  if (classified) return std::move(*classified);
  say_failure(classified.error().text, options.as_json);
  return std::nullopt;
}

std::optional<std::string> describe_undecided(const ClassifiedFiles& classified) {
  const reasoner::Undecided& undecided = classified.classification.undecided;
  const std::size_t count = undecided.classes.size();
  if (count == 0 && !undecided.consistency) return std::nullopt;
  const auto short_name = short_names(classified.loaded.source);
  const auto name = [&](taxonomy::ClassNumber of) {
    return short_name(classified.loaded.source.name(classified.classification.classes[static_cast<std::size_t>(of)]));
  };
  std::string line(compiled::undecided_words);
  if (count > 0) line += counted(count, "class", "classes");
  if (count > 0) line += " (" + name(undecided.classes.front()) + (count == 1 ? ")" : ", ...)");
  if (undecided.consistency) line.append(count > 0 ? ", and " : "").append(contradiction_question);
  if (undecided.held_up_by) line += "; held up by " + name(*undecided.held_up_by);
  return line;
}

std::optional<std::string> why_undecided(const ClassifiedFiles& classified) {
  constexpr std::size_t max_shown = 3;
  auto line = describe_undecided(classified);
  const std::vector<std::string>& gaps = classified.classification.gaps;
  if (!line || gaps.empty()) return line;
  *line += "; because " + base::joined(std::span(gaps).first(std::min(gaps.size(), max_shown)), ", ");
  if (gaps.size() > max_shown) *line += ", ...";
  return line;
}

std::vector<std::string> gaps_of(const ClassifiedFiles& classified) {
  std::vector<std::string> gaps = classified.classification.gaps;
  if (auto line = describe_undecided(classified)) gaps.push_back(std::move(*line));
  return gaps;
}

Exit exit_of(const ClassifiedFiles& classified, Exit exit) {
  if (!classified.classification.is_cut_off) return exit;
  const std::vector<std::string>& gaps = classified.classification.gaps;
  // The constructs that take long are told by check. A reader needs the limit here (base::Budget::reason).
  const auto limit = std::ranges::find_if(gaps, [](const std::string& gap) { return gap.ends_with(" was reached"); });
  return say_error((limit == gaps.end() ? base::joined(gaps, ", ") : *limit) +
                       ", and what is settled by then counts; " +
                       describe_undecided(classified).value_or("everything is decided") + "; raise the limit",
                   Exit::timed_out);
}

std::function<std::string(std::string_view)> short_names(const owl::Ontology& source) {
  // Shared, because a function is copied and the prefixes are many.
  return [prefixes = std::make_shared<const owl::Prefixes>(source)](std::string_view iri) {
    return prefixes->short_name(iri);
  };
}

std::size_t class_count(const ClassifiedFiles& classified) { return classified.classification.class_count() - 2; }

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
