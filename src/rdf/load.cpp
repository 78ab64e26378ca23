// Lists, reads, scans, parses and maps; then settles imports and prefixes among all files.
#include "rdf/load.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "rdf/files.hpp"
#include "rdf/graph.hpp"
#include "rdf/mapping.hpp"
#include "rdf/redland.hpp"
#include "rdf/scan.hpp"
#include "rdf/syntax.hpp"
#include "rdf/turtle_lines.hpp"

namespace geminga::rdf {
namespace {

/// What more unresolved imports than this have to say is said by their number.
constexpr std::size_t max_unresolved = 1000;

/// What a file's relative IRIs are relative to: its name, not its place, so that they are the same on every robot.
std::string base_iri(const std::string& path) {
  std::string iri = "file:///";
  for (const char c : std::filesystem::path(path).filename().string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain =
        (byte > 0x20 && byte < 0x7f && std::string_view("<>\"{}|\\^`%#?").find(c) == std::string_view::npos);
    if (is_plain) {
      iri += c;
    } else {
      iri += '%' + base::to_hex(byte, 2);
    }
  }
  return iri;
}

std::optional<LoadError> read_file(const std::string& path, const Limits& limits, Redland& redland, Graph& graph) {
  auto bytes = FileBytes::read(path, limits);
  if (!bytes) return std::move(bytes.error());
  const auto syntax = detect_syntax(path, bytes->view());
  if (!syntax) return LoadError{base::printable(path, 4096), 0, syntax.error()};
  TurtleLines lines;
  if (auto problem = scan(*syntax, bytes->view(), limits, lines))
    return LoadError{base::printable(path, 4096), problem->line, std::move(problem->text)};
  return redland.read(path, *syntax, *bytes, base_iri(path), lines.take(), graph);
}

/// Ontology headers: what each file calls itself, and what it imports.
class Headers {
 public:
  Headers(const Graph& graph, const std::vector<std::string>& paths) : graph_(graph), own_(paths.size()) {
    for (std::uint32_t number = 0; number < graph.triple_count(); ++number) {
      const Triple& triple = graph.triple(number);
      if (triple.predicate == node_of(Word::rdf_type) && triple.object == node_of(Word::owl_ontology)) {
        const std::string_view iri = graph.text(triple.subject);
        std::string& own = own_[graph.file_of(number)];
        if (graph.is_iri(triple.subject) && own.empty()) own = iri;
        known_.emplace(iri);
      } else if (triple.predicate == node_of(Word::owl_version_iri)) {
        known_.emplace(graph.text(triple.object));
      } else if (triple.predicate == node_of(Word::owl_imports)) {
        imports_.push_back(number);
      }
    }
    for (const std::string& path : paths) {
      known_.insert(base_iri(path));
      std::error_code error;
      const std::filesystem::path absolute = std::filesystem::absolute(path, error).lexically_normal();
      if (!error) known_.insert("file://" + absolute.string());
    }
  }

  [[nodiscard]] const std::string& own(std::size_t file) const { return own_[file]; }

  [[nodiscard]] std::vector<UnresolvedImport> unresolved(const std::vector<std::string>& paths) const {
    std::vector<UnresolvedImport> missing;
    std::set<std::string_view> seen;
    for (const std::uint32_t number : imports_) {
      const Triple& triple = graph_.triple(number);
      const std::string_view iri = graph_.text(triple.object);
      if (is_known(iri) || !seen.insert(iri).second || missing.size() == max_unresolved) continue;
      missing.push_back({std::string(iri), paths[graph_.file_of(number)], triple.line});
    }
    return missing;
  }

 private:
  [[nodiscard]] bool is_known(std::string_view iri) const {
    if (known_.contains(iri)) return true;
    // A trailing # is not part of an ontology's IRI, but often written.
    return iri.ends_with('#') ? known_.contains(iri.substr(0, iri.size() - 1))
                              : known_.contains(std::string(iri) + '#');
  }

  const Graph& graph_;
  std::vector<std::string> own_;
  std::set<std::string, std::less<>> known_;
  std::vector<std::uint32_t> imports_;
};

/// Gives every prefix one IRI: the one that most files declare, the smallest among equals, so that neither the order of
/// files nor that of lines decides. The empty prefix means another thing in every file and counts only where it does
/// not.
std::vector<PrefixConflict> settle_prefixes(const std::vector<DeclaredPrefix>& declared, el::OntologySource& source) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> fixed{
      {{"rdf", rdf_namespace}, {"rdfs", rdfs_namespace}, {"owl", owl_namespace}, {"xsd", xsd_namespace}}};
  std::map<std::string, std::map<std::string, std::set<std::uint32_t>>> files_of;
  for (const DeclaredPrefix& prefix : declared) files_of[prefix.prefix][prefix.iri].insert(prefix.file);
  for (const auto& [prefix, iri] : fixed) {
    auto& iris = files_of[std::string(prefix)];
    iris[std::string(iri)];
  }
  std::vector<PrefixConflict> conflicts;
  for (const auto& [prefix, iris] : files_of) {
    auto chosen = std::ranges::max_element(iris, {}, [](const auto& entry) { return entry.second.size(); });
    for (const auto& [name, iri] : fixed) {
      if (name == prefix) chosen = iris.find(std::string(iri));
    }
    if (prefix.empty() && iris.size() > 1) continue;
    source.add_prefix(prefix, chosen->first);
    if (iris.size() == 1) continue;
    PrefixConflict conflict{prefix, chosen->first, {}};
    for (const auto& [iri, files] : iris) {
      if (iri != chosen->first) conflict.others.push_back(iri);
    }
    conflicts.push_back(std::move(conflict));
  }
  return conflicts;
}

}  // namespace

std::expected<Loaded, LoadError> load(std::span<const std::string> arguments, const Limits& limits) {
  const auto paths = list_files(arguments, limits);
  if (!paths) return std::unexpected(paths.error());
  Loaded loaded;
  Graph graph;
  {
    Redland redland(limits);
    for (const std::string& path : *paths) {
      if (auto error = read_file(path, limits, redland, graph)) return std::unexpected(std::move(*error));
    }
    loaded.triples = redland.triple_count();
    loaded.conflicts = settle_prefixes(redland.prefixes(), loaded.source);
  }
  graph.index();
  const Headers headers(graph, *paths);
  std::vector<el::FileId> files;
  for (std::size_t file = 0; file < paths->size(); ++file)
    files.push_back(loaded.source.add_file((*paths)[file], headers.own(file)));
  Mapping(graph, loaded.source, files).run();
  loaded.unresolved = headers.unresolved(*paths);
  for (const UnresolvedImport& import : loaded.unresolved) {
    const auto file = std::ranges::find(*paths, import.file) - paths->begin();
    loaded.source.leave_out("owl:imports <" + import.iri + ">", files[static_cast<std::size_t>(file)], import.line);
  }
  if (const auto& problem = loaded.source.problem()) return std::unexpected(LoadError{{}, 0, *problem});
  return loaded;
}

}  // namespace geminga::rdf
