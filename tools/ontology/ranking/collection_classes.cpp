#include "ontology/ranking/collection_classes.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "base/text.hpp"
#include "ontology/loading/readers.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/base_iri.hpp"
#include "reasoning/syntax/files.hpp"
#include "reasoning/syntax/inflate.hpp"
#include "reasoning/syntax/rdf/catalog.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "reasoning/syntax/rdf/mapping/mapping.hpp"
#include "reasoning/syntax/rdf/tolerant/told_classes.hpp"
#include "reasoning/syntax/rdf/tolerant/tolerant.hpp"

namespace geminga::ontology {
namespace {

using rdf::Graph;
using syntax::Word;

/// One file of triples, or the header of another one.
struct Part {
  std::string path;
  Graph graph;  ///< indexed
  std::vector<std::string> imports;
  bool has_triples = true;
};

std::string file_name_of(std::string_view iri) {
  if (const std::size_t hash = iri.find('#'); hash != std::string_view::npos) iri = iri.substr(0, hash);
  while (iri.ends_with('/')) iri.remove_suffix(1);
  return base::in_lower_case(iri.substr(iri.rfind('/') + 1));
}

std::string without_hash(std::string_view iri) {
  iri = base::trimmed(iri);
  while (iri.ends_with('#') || iri.ends_with('/')) iri.remove_suffix(1);
  return std::string(iri);
}

class Collection {
 public:
  Collection(std::span<const std::string> folders, const WorkLimits& limits) : limits_(limits) {
    for (const std::string& folder : folders) read_catalog_in(folder);
  }

  void read(const std::string& path) {
    auto file = rdf::read_tolerantly(path);
    if (!file) return classes_.problems.push_back(syntax::to_string(file.error()));
    Part part;
    part.path = path;
    part.has_triples = syntax::has_triples(file->syntax);
    if (!part.has_triples && !read_other(path)) return;
    if (file->broken_off)
      classes_.problems.push_back(syntax::to_string(*file->broken_off) + ": only what stands before counts");
    ++classes_.files;
    part.graph = std::move(file->graph);
    part.graph.index();
    add_told(part.graph, path);
    add_header(part);
    parts_.push_back(std::move(part));
  }

  CollectionClasses finish() {
    classify_all();
    return std::move(classes_);
  }

 private:
  void read_catalog_in(const std::string& folder) {
    const std::string path = (std::filesystem::path(folder) / rdf::catalog_name).string();
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return;
    const auto bytes = syntax::FileBytes::read(path, {});
    if (!bytes) return classes_.problems.push_back(syntax::to_string(bytes.error()));
    const auto entries = rdf::read_catalog(path, bytes->view(), {});
    if (!entries) return classes_.problems.push_back(syntax::to_string(entries.error()));
    for (const rdf::CatalogEntry& entry : *entries) {
      const bool is_url = entry.file.starts_with("file://");
      const std::filesystem::path file(is_url ? entry.file.substr(7) : entry.file);
      catalog_.emplace(without_hash(entry.iri), (std::filesystem::path(folder) / file).lexically_normal().string());
    }
  }

  void add_told(const Graph& graph, const std::string& path) {
    const rdf::ToldClasses told = rdf::told_classes(graph);
    for (const rdf::NodeId declared : told.declared) declare(graph.text(declared), path);
    for (const auto& [sub, super] : told.inclusions) include(graph.text(sub), graph.text(super));
  }

  void declare(std::string_view iri, const std::string& path) {
    const std::uint32_t number = classes_.add(iri);
    classes_.is_declared[number] = true;
    classes_.declared_in.emplace_back(std::filesystem::path(syntax::name_without_gz(path)).filename().string(), number);
  }

  void include(std::string_view sub, std::string_view super) {
    if (sub == iri_of(Word::owl_nothing)) return;
    const std::uint32_t below = classes_.add(sub);
    const std::uint32_t above = classes_.add(super);
    if (below != above) classes_.inclusions.emplace_back(below, above);
  }

  void add_header(Part& part) {
    const std::size_t number = parts_.size();
    file_names_.emplace(
        base::in_lower_case(std::filesystem::path(syntax::name_without_gz(part.path)).filename().string()), number);
    paths_.emplace(std::filesystem::path(part.path).lexically_normal().string(), number);
    names_.emplace(syntax::base_iri(part.path), number);
    for (std::uint32_t at = 0; at < part.graph.triple_count(); ++at) {
      const rdf::Triple& triple = part.graph.triple(at);
      const std::string_view object = part.graph.text(triple.object);
      if (triple.predicate == rdf::node_of(Word::rdf_type) && triple.object == rdf::node_of(Word::owl_ontology)) {
        if (part.graph.is_iri(triple.subject)) names_.emplace(without_hash(part.graph.text(triple.subject)), number);
      } else if (triple.predicate == rdf::node_of(Word::owl_version_iri)) {
        names_.emplace(without_hash(object), number);
      } else if (triple.predicate == rdf::node_of(Word::owl_imports)) {
        part.imports.push_back(without_hash(object));
      }
    }
  }

  /// Finds an imported part by the ontology's own IRI, by the catalogue, or by the last part of the IRI as a file name.
  [[nodiscard]] std::optional<std::size_t> find_import(const std::string& iri) const {
    if (const auto named = names_.find(iri); named != names_.end()) return named->second;
    if (const auto entry = catalog_.find(iri); entry != catalog_.end()) {
      if (const auto at = paths_.find(entry->second); at != paths_.end()) return at->second;
    }
    const std::string name = file_name_of(iri);
    for (const std::string& ending : {std::string(), std::string(".owl"), std::string(".rdf"), std::string(".ttl")}) {
      if (const auto at = file_names_.find(name + ending); at != file_names_.end()) return at->second;
    }
    return std::nullopt;
  }

  /// The numbers of a file and all that it imports, ascending.
  [[nodiscard]] std::set<std::size_t> closure_of(std::size_t part) const {
    std::set<std::size_t> closure{part};
    std::vector<std::size_t> open{part};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (const std::size_t found : imported_[at]) {
        if (closure.insert(found).second) open.push_back(found);
      }
    }
    return closure;
  }

  void find_imports() {
    for (const Part& part : parts_) {
      std::set<std::size_t> found;
      for (const std::string& import : part.imports) {
        if (const auto at = find_import(import)) found.insert(*at);
      }
      imported_.emplace_back(found.begin(), found.end());
    }
  }

  /// Classifies parts that no other imports first: their closures include those of their imports. The imports are
  /// classified by themselves only where such a closure contradicts itself.
  void classify_all() {
    find_imports();
    std::vector<bool> is_imported(parts_.size());
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      for (const std::size_t other : imported_[part]) is_imported[other] = is_imported[other] || other != part;
    }
    std::vector<std::size_t> order;
    for (const bool wanted : {false, true}) {
      for (std::size_t part = 0; part < parts_.size(); ++part) {
        if (parts_[part].has_triples && is_imported[part] == wanted) order.push_back(part);
      }
    }
    std::vector<bool> is_done(parts_.size());
    for (const std::size_t part : order) {
      if (is_done[part]) continue;
      is_done[part] = true;
      const std::set<std::size_t> closure = closure_of(part);
      if (!classify(closure, part)) continue;
      for (const std::size_t member : closure) is_done[member] = true;
    }
  }

  bool classify(const std::set<std::size_t>& closure, std::size_t part) {
    Graph graph;
    owl::Ontology source;
    std::vector<owl::FileId> files;
    for (const std::size_t member : closure) {
      graph.begin_file();
      graph.append(parts_[member].graph);
      files.push_back(source.add_file(parts_[member].path));
    }
    graph.index();
    rdf::map_to_axioms(graph, source, std::move(files));
    return add_inferred(source, parts_[part].path);
  }

  /// Adds the inclusions that follow; false where there are none and only the told ones count.
  bool add_inferred(const owl::Ontology& source, const std::string& path) {
    // A ranking uses mostly told inclusions; those that are hard to find are not worth minutes.
    constexpr std::uint64_t default_steps = 200'000'000;
    WorkLimits limits = limits_;
    if (limits.steps == WorkLimits::default_steps) limits.steps = default_steps;
    limits.steps = std::max<std::uint64_t>(1, limits.steps / std::max<std::size_t>(1, parts_.size()));
    base::Budget budget = budget_of(limits);
    if (source.problem()) {
      classes_.remarks.push_back(path + ": " + *source.problem() + ": it counts as it is written");
      return false;
    }
    const auto found = reasoner::classify(source, {.budget = &budget});
    if (!found) {
      classes_.remarks.push_back(path + ": " + found.error().text + ": it counts as it is written");
      return false;
    }
    if (!found->is_consistent) {
      classes_.remarks.push_back(path + ": contradicts itself: it counts as it is written");
      return false;
    }
    if (found->is_cut_off) classes_.remarks.push_back(path + ": not all that follows was found within the limits");
    const auto iri = [&](taxonomy::ClassNumber number) {
      return source.name(found->classes[static_cast<std::size_t>(number)]);
    };
    const taxonomy::ClassNumber empty = found->representative[static_cast<std::size_t>(found->nothing)];
    for (std::uint32_t at = 0; at < found->class_count(); ++at) {
      const taxonomy::ClassNumber number{at};
      const taxonomy::ClassNumber same = found->representative[at];
      if (same == empty) continue;  // below every class, which says nothing of its meaning
      if (same != number) {
        include(iri(number), iri(same));
        include(iri(same), iri(number));
      }
      for (const taxonomy::ClassNumber parent : found->parents_of(number)) include(iri(number), iri(parent));
    }
    return true;
  }

  /// Reads a file in a syntax without triples; false where it is broken.
  bool read_other(const std::string& path) {
    Readers readers(false);
    const std::vector<std::string> files{path};
    const auto loaded = rdf::load(files, {}, &readers);
    if (!loaded) {
      classes_.problems.push_back(syntax::to_string(loaded.error()));
      return false;
    }
    for (const owl::TermId term : classes_in(loaded->source)) declare(loaded->source.name_of(term), path);
    for (std::size_t at = 0; at < loaded->source.axiom_count(); ++at) {
      const owl::Axiom axiom = loaded->source.axiom(at);
      const auto is_named = [&](owl::TermId term) { return loaded->source.kind(term) == owl::TermKind::named_class; };
      if (axiom.kind == owl::AxiomKind::sub_class_of && std::ranges::all_of(axiom.arguments, is_named))
        include(loaded->source.name_of(axiom.arguments[0]), loaded->source.name_of(axiom.arguments[1]));
    }
    (void)add_inferred(loaded->source, path);
    return true;
  }

  static std::vector<owl::TermId> classes_in(const owl::Ontology& source) {
    std::vector<owl::TermId> found;
    for (std::uint32_t at = 0; at < source.term_count(); ++at) {
      if (source.kind(owl::TermId{at}) == owl::TermKind::named_class) found.push_back(owl::TermId{at});
    }
    return found;
  }

  const WorkLimits& limits_;
  CollectionClasses classes_;
  std::vector<Part> parts_;
  std::vector<std::vector<std::size_t>> imported_;  ///< by part
  std::map<std::string, std::size_t> names_;        ///< parts by IRI
  std::map<std::string, std::size_t> paths_;        ///< parts by path
  std::map<std::string, std::size_t> file_names_;   ///< parts by file name in lower case, without folders
  std::map<std::string, std::string> catalog_;      ///< from IRIs to paths
};

}  // namespace

std::uint32_t CollectionClasses::add(std::string_view iri) {
  const auto [found, is_new] = number_of.try_emplace(std::string(iri), static_cast<std::uint32_t>(iris.size()));
  if (is_new) {
    iris.emplace_back(iri);
    is_declared.push_back(false);
  }
  return found->second;
}

CollectionClasses read_collection(const std::vector<std::string>& files, const std::vector<std::string>& folders,
                                  const WorkLimits& limits) {
  Collection collection(folders, limits);
  for (const std::string& file : files) collection.read(file);
  return collection.finish();
}

}  // namespace geminga::ontology
