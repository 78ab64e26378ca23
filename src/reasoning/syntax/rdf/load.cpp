// Lists, reads, scans, parses and maps files; then matches imports and chooses prefixes among all of them.
#include "reasoning/syntax/rdf/load.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/parallel/both.hpp"
#include "base/text.hpp"
#include "reasoning/owl/fingerprint.hpp"
#include "reasoning/syntax/base_iri.hpp"
#include "reasoning/syntax/files.hpp"
#include "reasoning/syntax/inflate.hpp"
#include "reasoning/syntax/rdf/catalog.hpp"
#include "reasoning/syntax/rdf/declared_prefixes.hpp"
#include "reasoning/syntax/rdf/mapping/mapping.hpp"
#include "reasoning/syntax/rdf/scan/encoding.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"
#include "reasoning/syntax/rdf/triples/redland.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::rdf {
namespace {

/// Ontology headers: what the files call themselves, and what they import.
class Headers {
 public:
  explicit Headers(const std::vector<std::string>& paths) : own_(paths.size()) {
    for (const std::string& path : paths) {
      names_.insert(syntax::base_iri(path));
      std::error_code error;
      const std::filesystem::path absolute = std::filesystem::absolute(path, error).lexically_normal();
      if (!error) names_.insert("file://" + absolute.string());
    }
  }

  /// A file is the first ontology that it declares.
  void name(std::size_t file, std::string_view iri) {
    if (own_[file].empty()) own_[file] = iri;
    names_.emplace(iri);
  }
  void version(std::string_view iri) { names_.emplace(iri); }
  void import(std::size_t file, std::string_view iri, std::uint32_t line) {
    if (seen_.emplace(iri).second) imports_.push_back({std::string(iri), file, line});
  }

  void read(const Graph& graph) {
    for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
      const Triple& triple = graph.triple(number);
      const auto object = [&] { return graph.text(triple.object); };
      if (triple.predicate == node_of(syntax::Word::rdf_type) && triple.object == node_of(syntax::Word::owl_ontology)) {
        if (graph.is_iri(triple.subject)) name(graph.file_of(number), graph.text(triple.subject));
      } else if (triple.predicate == node_of(syntax::Word::owl_version_iri)) {
        version(object());
      } else if (triple.predicate == node_of(syntax::Word::owl_imports)) {
        import(graph.file_of(number), object(), triple.line);
      }
    }
  }

  [[nodiscard]] const std::string& own(std::size_t file) const { return own_[file]; }

  /// Leaves out the imports that no file answers, and returns them. So many of them are left out under names of their
  /// own, because every left-out is compared with each.
  [[nodiscard]] std::vector<UnresolvedImport> leave_out_unanswered(const std::vector<std::string>& paths,
                                                                   std::size_t max_named, owl::Ontology& source) const {
    std::vector<UnresolvedImport> missing;
    std::set<std::string> own_in_lower_case;
    for (const std::string& own : own_) own_in_lower_case.insert(base::in_lower_case(own));
    for (const Import& import : imports_) {
      // The case of letters is ignored, because file systems may ignore it: SOMA-HOME imports .../SOMA-ALL.owl, whose
      // name is .../SOMA-All.owl.
      if (is_known(import.iri) || own_in_lower_case.contains(base::in_lower_case(import.iri))) continue;
      const bool is_named = missing.size() < max_named;
      missing.push_back({import.iri, paths[import.file], import.line});
      source.leave_out(is_named ? "owl:imports <" + import.iri + ">" : "other owl:imports",
                       owl::FileId{static_cast<std::uint32_t>(import.file)}, import.line);
    }
    return missing;
  }

 private:
  struct Import {
    std::string iri;
    std::size_t file;
    std::uint32_t line;
  };

  [[nodiscard]] bool is_known(std::string_view iri) const {
    if (names_.contains(iri)) return true;
    // A trailing # is not part of an ontology's IRI, but often written.
    return iri.ends_with('#') ? names_.contains(iri.substr(0, iri.size() - 1))
                              : names_.contains(std::string(iri) + '#');
  }

  std::vector<std::string> own_;
  std::set<std::string, std::less<>> names_;
  std::set<std::string, std::less<>> seen_;
  std::vector<Import> imports_;
};

/// A file that was unpacked if necessary, and scanned.
struct ScannedFile {
  syntax::FileBytes bytes;
  owl::Fingerprint content;  ///< of the file as it is on the disk
  syntax::Syntax syntax = syntax::Syntax::turtle;
  Layout layout;
  /// Texts about faults that were mended, with the first line of each.
  std::map<std::string_view, std::uint32_t> remarks;
};

std::expected<ScannedFile, syntax::LoadError> read_and_scan(const std::string& path, const syntax::FileLimits& limits,
                                                            unsigned threads) {
  const auto refuse = [&](std::uint32_t line, std::string text) {
    return std::unexpected(syntax::LoadError{base::printable(path, 4096), line, std::move(text)});
  };
  auto bytes = path == syntax::standard_input_name ? syntax::FileBytes::read_standard_input(limits)
                                                   : syntax::FileBytes::read(path, limits, threads);
  if (!bytes) return std::unexpected(std::move(bytes.error()));
  const owl::Fingerprint content{bytes->view().size(), bytes->hash()};
  if (syntax::is_gzip(bytes->view())) bytes = inflate(path, *bytes, limits);
  if (bytes) bytes = decoded(path, std::move(*bytes));
  if (!bytes) return std::unexpected(std::move(bytes.error()));
  // Standard input has no name: it is Turtle, which N-Triples are, too, unless its content says another syntax.
  const auto syntax = syntax::detect_syntax(path == syntax::standard_input_name ? "-.ttl" : path, bytes->view());
  if (!syntax) return std::unexpected(syntax::LoadError{base::printable(path, 4096), 0, syntax.error(), true});
  auto layout = scan(*syntax, bytes->view(), limits, threads);
  std::map<std::string_view, std::uint32_t> remarks;
  if (layout && !layout->graph_marks.empty()) {
    remarks.emplace("graphs of TriG or N-Quads, read as one graph",
                    line_of(bytes->view(), layout->graph_marks.front().begin));
    auto text = syntax::FileBytes::copy_of(without_marks(bytes->view(), layout->graph_marks));
    if (!text) return refuse(0, "is too large for the memory");
    *bytes = std::move(*text);
    layout = scan(*syntax, bytes->view(), limits, threads);
  }
  if (layout && (syntax::has_triples(*syntax) || is_xml(*syntax))) {
    Bases bases;
    std::vector<Rewrite> rewrites;
    if (syntax::has_triples(*syntax)) rewrites = bases.mark(bytes->view(), layout->base_texts, is_xml(*syntax));
    for (Repair& repair : layout->repairs) {
      if (!repair.remark.empty() && !remarks.contains(repair.remark))
        remarks.emplace(repair.remark, line_of(bytes->view(), repair.rewrite.begin));
      rewrites.push_back(std::move(repair.rewrite));
    }
    if (!rewrites.empty()) {
      auto text = syntax::FileBytes::copy_of(rewritten(bytes->view(), std::move(rewrites)));
      if (!text) return refuse(0, "is too large for the memory");
      *bytes = std::move(*text);
      layout = scan(*syntax, bytes->view(), limits, threads);
      if (layout) layout->bases = std::move(bases);
    }
  }
  if (!layout) return refuse(layout.error().line, std::move(layout.error().text));
  return ScannedFile{std::move(*bytes), content, *syntax, std::move(*layout), std::move(remarks)};
}

/// Octets of a file that are looked at for the namespaces of an ontology.
constexpr std::size_t begin_bytes = std::size_t{1} << 16;

/// An error of a parser, with what the file is instead where that shows.
syntax::LoadError explained(syntax::LoadError error, syntax::Syntax syntax, bool is_foreign) {
  if (is_foreign) error.text += " (it names neither RDF's nor OWL's namespace: is it an ontology?)";
  if (syntax != syntax::Syntax::turtle) return error;
  if (error.text.contains("{ ... }") || error.text.contains("Graph URI literal {"))
    error.text = "has { ... } where TriG has none: Notation 3 is not read, convert it to Turtle";
  return error;
}

/// One load, file by file.
class Loading {
 public:
  Loading(const std::vector<std::string>& paths, const syntax::FileLimits& limits, OtherReader* other, unsigned threads)
      : paths_(paths), limits_(limits), other_(other), threads_(threads), redland_(limits, threads), headers_(paths) {
    if (limits.is_lenient) loaded_.source.read_leniently();
  }

  std::optional<syntax::LoadError> read(std::size_t number) {
    const std::string& path = paths_[number];
    const owl::FileId file = loaded_.source.add_file(path);
    auto scanned = read_and_scan(path, limits_, threads_);
    if (!scanned) return std::move(scanned.error());
    const syntax::Syntax syntax = scanned->syntax;
    loaded_.source.set_content(file, scanned->content);
    for (const auto& [remark, line] : scanned->remarks) loaded_.source.remark(remark, file, line);
    loaded_.syntaxes.push_back(syntax);
    if (syntax::has_triples(syntax)) {
      // Before it is read, because what was read is given back to the kernel.
      const bool is_foreign = is_xml(syntax) && syntax::is_foreign_xml(scanned->bytes.view().substr(0, begin_bytes));
      if (auto error = redland_.read(path, syntax, scanned->bytes, scanned->layout, graph_))
        return explained(std::move(*error), syntax, is_foreign);
      leave_out_passed(file);
      return take_prefixes(number, redland_.prefixes());
    }
    graph_.begin_file();  // without triples, so that the graph's files have the source's numbers
    if (auto error = refuse_other(number, syntax)) return error;
    if (!syntax::is_read_last(syntax)) return read_other(number, syntax, scanned->bytes.view());
    other_->look_ahead(syntax, scanned->bytes.view());
    waiting_.push_back({number, std::move(scanned->bytes)});
    return std::nullopt;
  }

  /// Takes the catalogue of a folder, if there is one: an import for which it names one of our files is answered.
  std::optional<syntax::LoadError> read_catalog_in(const std::string& folder) {
    const std::filesystem::path path = std::filesystem::path(folder) / catalog_name;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    const auto bytes = syntax::FileBytes::read(path.string(), limits_);
    if (!bytes) return bytes.error();
    const auto entries = read_catalog(path.string(), bytes->view(), limits_);
    if (!entries) return entries.error();
    const auto resolved = [&](const std::filesystem::path& file) {
      return std::filesystem::weakly_canonical(file, error).string();
    };
    std::set<std::string> ours;
    for (const std::string& ours_path : paths_) ours.insert(resolved(ours_path));
    for (const CatalogEntry& entry : *entries) {
      const bool is_url = entry.file.starts_with("file://");
      if (ours.contains(resolved(std::filesystem::path(folder) / (is_url ? entry.file.substr(7) : entry.file))))
        headers_.version(entry.iri);
    }
    return std::nullopt;
  }

  std::expected<Loaded, syntax::LoadError> finish() {
    loaded_.triples = redland_.triple_count();
    map_triples();
    for (const Waiting& waiting : waiting_) {
      if (auto error = read_other(waiting.number, loaded_.syntaxes[waiting.number], waiting.bytes.view()))
        return std::unexpected(std::move(*error));
    }
    loaded_.conflicts = prefixes_.choose(loaded_.source);
    for (std::uint32_t number = 0; number < paths_.size(); ++number)
      loaded_.source.set_ontology_iri(owl::FileId{number}, headers_.own(number));
    loaded_.unresolved = headers_.leave_out_unanswered(paths_, limits_.named_imports, loaded_.source);
    if (const auto& problem = loaded_.source.problem()) return std::unexpected(syntax::LoadError{{}, 0, *problem});
    return std::move(loaded_);
  }

 private:
  /// A file in a syntax in which other files decide what a name means.
  struct Waiting {
    std::size_t number;
    syntax::FileBytes bytes;
  };

  /// Turns the triples of all files into axioms, and looks at their names meanwhile.
  void map_triples() {
    // Few triples take less time than a thread that begins.
    constexpr std::size_t worth_a_thread = 100'000;
    const unsigned threads = graph_.triple_count() < worth_a_thread ? 1 : threads_;
    const auto look_at_names = [&] {
      headers_.read(graph_);
      loaded_.unknown_words = unknown_words(graph_);
    };
    parallel::do_both(threads, [&] { graph_.index(); }, look_at_names);
    std::vector<owl::FileId> files;
    for (std::uint32_t number = 0; number < paths_.size(); ++number) files.push_back(owl::FileId{number});
    const auto map = [&] {
      map_to_axioms(graph_, loaded_.source, std::move(files),
                    limits_.keeps_annotations ? &loaded_.annotations : nullptr);
    };
    parallel::do_both(threads, map, [&] { loaded_.undeclared_predicates = undeclared_predicates(graph_); });
  }

  /// Names what raptor passed over. A file cannot make up more than 250 names.
  void leave_out_passed(owl::FileId file) {
    constexpr std::size_t max_named = 250;
    std::set<std::string_view> named;
    for (const Passed& passed : redland_.passed()) {
      if (passed.is_harmless) {
        loaded_.source.remark(passed.fault, file, passed.line);
        continue;
      }
      const bool is_named = named.contains(passed.fault) || named.size() < max_named;
      if (is_named) named.insert(passed.fault);
      const std::string_view fault = is_named ? std::string_view(passed.fault) : "and others";
      loaded_.source.leave_out("a statement that cannot be read (" + std::string(fault) + ")", file, passed.line);
    }
  }

  std::optional<syntax::LoadError> refuse_other(std::size_t number, syntax::Syntax syntax) const {
    if (other_ != nullptr) return std::nullopt;
    return syntax::LoadError{
        base::printable(paths_[number], 4096), 0,
        "is in " + std::string(to_string(syntax)) + ", which is not read here: convert it to RDF/XML or Turtle"};
  }

  std::optional<syntax::LoadError> read_other(std::size_t number, syntax::Syntax syntax, std::string_view bytes) {
    const auto document = other_->read(syntax, bytes, owl::FileId{static_cast<std::uint32_t>(number)}, loaded_.source,
                                       loaded_.annotations);
    if (!document) return syntax::LoadError{document.error().file, document.error().line, document.error().text};
    if (!document->ontology_iri.empty()) headers_.name(number, document->ontology_iri);
    if (!document->version_iri.empty()) headers_.version(document->version_iri);
    for (const owl::Import& import : document->imports) headers_.import(number, import.iri, import.line);
    return take_prefixes(number, document->prefixes);
  }

  std::optional<syntax::LoadError> take_prefixes(std::size_t number, std::span<const owl::DeclaredPrefix> prefixes) {
    prefixes_.add(prefixes);
    if (prefixes_.size() <= limits_.all_prefixes) return std::nullopt;
    return syntax::LoadError{base::printable(paths_[number], 4096), 0,
                             "is beyond " + std::to_string(limits_.all_prefixes) + " different prefixes of all files"};
  }

  const std::vector<std::string>& paths_;
  const syntax::FileLimits& limits_;
  OtherReader* other_;
  unsigned threads_;
  Redland redland_;
  Graph graph_;
  Headers headers_;
  DeclaredPrefixes prefixes_;
  std::vector<Waiting> waiting_;
  Loaded loaded_;
};

}  // namespace

std::expected<TextFile, syntax::LoadError> read_text(const std::string& path, const syntax::FileLimits& limits) {
  auto scanned = read_and_scan(path, limits, 1);
  if (!scanned) return std::unexpected(std::move(scanned.error()));
  return TextFile{std::move(scanned->bytes), scanned->syntax, syntax::base_iri(path), std::move(scanned->layout.bases)};
}

namespace {

/// Loads the files of a listing. A catalogue that is refused is added to `left_out`, or refuses everything where that
/// is null.
std::expected<Loaded, syntax::LoadError> load_listed(const syntax::Listing& listing, const syntax::FileLimits& limits,
                                                     OtherReader* other, unsigned threads,
                                                     std::vector<syntax::LoadError>* left_out) {
  if (other != nullptr) other->begin();
  Loading loading(listing.files, limits, other, threads);
  for (std::size_t number = 0; number < listing.files.size(); ++number) {
    if (auto error = loading.read(number)) return std::unexpected(std::move(*error));
  }
  std::vector<syntax::LoadError> refused;
  for (const std::string& folder : listing.folders) {
    auto error = loading.read_catalog_in(folder);
    if (!error) continue;
    if (left_out == nullptr || left_out->size() + refused.size() >= syntax::max_left_out)
      return std::unexpected(std::move(*error));
    refused.push_back(std::move(*error));
  }
  auto loaded = loading.finish();
  if (loaded && left_out != nullptr) left_out->insert(left_out->end(), refused.begin(), refused.end());
  return loaded;
}

}  // namespace

std::expected<Loaded, syntax::LoadError> load(std::span<const std::string> arguments, const syntax::FileLimits& limits,
                                              OtherReader* other, unsigned threads,
                                              std::vector<syntax::LoadError>* left_out) {
  auto listing = list_files(arguments, limits, {}, left_out);
  if (!listing) return std::unexpected(std::move(listing.error()));
  while (true) {
    auto loaded = load_listed(*listing, limits, other, threads, left_out);
    if (loaded) loaded->listing = std::move(*listing);
    if (loaded && left_out != nullptr) loaded->refused = *left_out;
    if (loaded || left_out == nullptr || left_out->size() >= syntax::max_left_out) return loaded;
    const auto is_refused = [&](const std::string& path) {
      return loaded.error().file == path || loaded.error().file == base::printable(path, 4096);
    };
    const auto bad = std::ranges::find_if(listing->files, is_refused);
    const bool is_of_folder = bad != listing->files.end() && std::ranges::find(arguments, *bad) == arguments.end();
    if (!is_of_folder || listing->files.size() == 1) return loaded;
    left_out->push_back(std::move(loaded.error()));
    listing->files.erase(bad);
  }
}

}  // namespace geminga::rdf
