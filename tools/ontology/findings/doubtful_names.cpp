// A name is doubtful where the files declare other names of its namespace and kind, or where a declared name differs
// from it in the namespace alone.
#include "ontology/findings/doubtful_names.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/edit_distance.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/rdf/reserved_words.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::ontology {
namespace {

using owl::TermKind;

constexpr std::size_t max_similar = 3;
/// The most differing characters of two namespaces that count as one: http for https, a slash for a number sign.
constexpr std::size_t namespace_slips = 2;

/// The sorts of names that an author declares.
enum class Sort : std::uint8_t { of_class, of_property, of_datatype };

std::optional<Sort> sort_of(TermKind kind) {
  switch (kind) {
    case TermKind::named_class:
      return Sort::of_class;
    case TermKind::object_property:
    case TermKind::data_property:
    case TermKind::annotation_property:
      return Sort::of_property;
    case TermKind::datatype:
      return Sort::of_datatype;
    default:
      return std::nullopt;  // an individual need not be declared (OWL 2, section 5.8.2)
  }
}

std::string_view to_string(Sort sort) {
  switch (sort) {
    case Sort::of_class:
      return "class";
    case Sort::of_property:
      return "property";
    case Sort::of_datatype:
      break;
  }
  return "datatype";
}

std::size_t local_begin(std::string_view iri) {
  const std::size_t end = iri.find_last_of("#/:");
  return end == std::string_view::npos ? 0 : end + 1;
}
std::string_view namespace_of(std::string_view iri) { return iri.substr(0, local_begin(iri)); }
std::string_view local_name(std::string_view iri) { return iri.substr(local_begin(iri)); }

/// The first use of a name.
struct Use {
  Sort sort{};
  bool is_in_axiom = false;  ///< else it is the predicate of an annotation
  std::string_view iri;
  std::string_view file;
  std::uint32_t line = 0;
};

class Search {
 public:
  explicit Search(const rdf::Loaded& loaded)
      : loaded_(loaded), source_(loaded.source), short_name_(short_names(loaded.source)) {}

  NameFindings run() {
    gather();
    for (const rdf::UsedName& word : loaded_.unknown_words) {
      // A later version of OWL may have the word. The axioms with it are left out under its name.
      if (word.iri.starts_with(syntax::owl_namespace) && rdf::similar_words(word.iri).empty()) continue;
      add_unknown_word(word.iri, path_of(word.file), word.line);
    }
    std::map<std::string_view, OtherNamespace> others;
    for (const Use& use : uses_) judge(use, others);
    for (auto& [iri, other] : others) found_.others.push_back(std::move(other));
    sort_by_place(found_.unknown_words);
    sort_by_place(found_.undeclared);
    find_clashes();
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::string_view path_of(std::uint32_t file) const { return source_.files()[file].path; }

  /// Gathers the declarations, and the first use of each other name.
  void gather() {
    std::vector<bool> is_seen(source_.term_count(), false);
    std::vector<std::pair<owl::TermId, std::uint32_t>> first_axiom;
    std::vector<owl::TermId> stack;
    for (std::uint32_t number = 0; number < source_.axiom_count(); ++number) {
      const owl::Axiom axiom = source_.axiom(number);
      if (axiom.kind == owl::AxiomKind::declaration) {
        declare(axiom.arguments.front());
        continue;
      }
      if (sort_of(source_.kind(axiom.arguments.front())))
        described_.insert(namespace_of(source_.name_of(axiom.arguments.front())));
      stack.assign(axiom.arguments.begin(), axiom.arguments.end());
      while (!stack.empty()) {
        const owl::TermId term = stack.back();
        stack.pop_back();
        if (is_seen[static_cast<std::size_t>(term)]) continue;
        is_seen[static_cast<std::size_t>(term)] = true;
        if (sort_of(source_.kind(term))) first_axiom.emplace_back(term, number);
        const auto arguments = source_.term(term).arguments;
        stack.insert(stack.end(), arguments.begin(), arguments.end());
      }
    }
    for (const auto& [term, number] : first_axiom) {
      const owl::Axiom axiom = source_.axiom(number);
      add_use({*sort_of(source_.kind(term)), true, source_.name_of(term),
               path_of(static_cast<std::uint32_t>(axiom.file)), axiom.line});
    }
    for (const rdf::UsedName& name : loaded_.undeclared_predicates)
      add_use({Sort::of_property, false, name.iri, path_of(name.file), name.line});
  }

  void declare(owl::TermId term) {
    const std::string_view iri = source_.name_of(term);
    declared_.insert(iri);
    const auto sort = sort_of(source_.kind(term));
    if (!sort) return;
    declaring_.emplace(*sort, namespace_of(iri));
    by_local_name_[local_name(iri)].push_back(iri);
  }

  void add_use(const Use& use) {
    if (declared_.contains(use.iri) || !used_.insert(use.iri).second) return;
    uses_.push_back(use);
  }

  void add_unknown_word(std::string_view iri, std::string_view file, std::uint32_t line) {
    if (!words_.insert(iri).second) return;
    found_.unknown_words.push_back(
        {short_name_(iri), std::string(iri), "word", std::string(file), line, rdf::similar_words(iri)});
  }

  void judge(const Use& use, std::map<std::string_view, OtherNamespace>& others) {
    if (rdf::is_reserved(use.iri)) {
      if (!rdf::is_reserved_word(use.iri)) add_unknown_word(use.iri, use.file, use.line);
      return;
    }
    const std::string_view space = namespace_of(use.iri);
    std::vector<std::string> similar;
    bool is_missing = declaring_.contains({use.sort, space});
    if (is_missing && explained_++ < max_explained_names) similar = similar_names(use.iri, use.is_in_axiom);
    // Files often declare one or two names of a vocabulary that they use for annotations.
    if (!use.is_in_axiom && similar.empty()) is_missing = false;
    if (!is_missing) {
      const auto meant = same_but_for_namespace(use.iri);
      if (!meant && !described_.contains(space))
        ++others.try_emplace(space, std::string(space), 0U, short_name_(use.iri)).first->second.names;
      if (!meant) return;
      similar.push_back(short_name_(*meant));
    }
    found_.undeclared.push_back({short_name_(use.iri), std::string(use.iri), to_string(use.sort), std::string(use.file),
                                 use.line, std::move(similar)});
  }

  [[nodiscard]] std::optional<std::string_view> same_but_for_namespace(std::string_view iri) const {
    const auto named = by_local_name_.find(local_name(iri));
    if (named == by_local_name_.end()) return std::nullopt;
    for (const std::string_view other : named->second) {
      if (base::edit_distance(namespace_of(iri), namespace_of(other), namespace_slips) <= namespace_slips) return other;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::vector<std::string> similar_names(std::string_view iri, bool from_anywhere) const {
    const std::string_view local = local_name(iri);
    const std::size_t limit = base::tolerated_slips(local);
    std::vector<std::tuple<std::size_t, bool, std::string_view>> near;  // names of its own namespace first
    for (const auto& [other, iris] : by_local_name_) {
      const std::size_t distance = base::edit_distance(local, other, limit);
      if (distance > limit) continue;
      for (const std::string_view of : iris) {
        const bool is_elsewhere = namespace_of(of) != namespace_of(iri);
        if (from_anywhere || !is_elsewhere) near.emplace_back(distance, is_elsewhere, of);
      }
    }
    std::ranges::sort(near);
    std::vector<std::string> names;
    for (const auto& [distance, is_elsewhere, of] : near) {
      if (names.size() == max_similar) break;
      names.push_back(short_name_(of));
    }
    return names;
  }

  static void sort_by_place(std::vector<DoubtfulName>& names) {
    std::ranges::sort(names, {}, [](const DoubtfulName& name) { return std::tie(name.file, name.line, name.iri); });
  }

  void find_clashes() {
    std::map<std::string_view, std::set<std::string_view>> classes_of;
    const auto is_class = class_names();
    for (const owl::Ontology::Label& label : source_.labels()) {
      const std::string_view entity = source_.name(label.entity);
      if (is_class.contains(entity)) classes_of[source_.name(label.text)].insert(entity);
    }
    for (const auto& [label, classes] : classes_of) {
      if (classes.size() < 2) continue;
      LabelClash clash{std::string(label), {}};
      for (const std::string_view of : classes) clash.classes.push_back(short_name_(of));
      found_.clashes.push_back(std::move(clash));
    }
  }

  [[nodiscard]] std::set<std::string_view> class_names() const {
    std::set<std::string_view> names;
    for (std::uint32_t id = 0; id < source_.term_count(); ++id) {
      if (source_.kind(owl::TermId{id}) == TermKind::named_class) names.insert(source_.name_of(owl::TermId{id}));
    }
    return names;
  }

  const rdf::Loaded& loaded_;
  const owl::Ontology& source_;
  std::function<std::string(std::string_view)> short_name_;
  std::set<std::string_view> declared_;
  std::set<std::string_view> described_;                   ///< namespaces of the first argument of an axiom
  std::set<std::pair<Sort, std::string_view>> declaring_;  ///< namespaces in which names of a sort are declared
  std::map<std::string_view, std::vector<std::string_view>> by_local_name_;  ///< declared names
  std::set<std::string_view> used_;
  std::set<std::string_view> words_;
  std::vector<Use> uses_;
  std::size_t explained_ = 0;
  NameFindings found_;
};

}  // namespace

NameFindings find_doubtful_names(const rdf::Loaded& loaded) { return Search(loaded).run(); }

}  // namespace geminga::ontology
