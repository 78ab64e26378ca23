// The rules about the hierarchy of classes, one function each.
#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "ontology/command/words.hpp"
#include "ontology/lint/rules.hpp"
#include "ontology/loading/hierarchy.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {
namespace {

/// The most names that one finding lists.
constexpr std::size_t max_named = 8;

class HierarchyRules {
 public:
  HierarchyRules(const ClassifiedFiles& classified, const Entities& entities, LintFindings& findings)
      : source_(classified.loaded.source),
        classification_(classified.classification),
        entities_(entities),
        findings_(findings),
        hierarchy_(class_hierarchy(source_, classification_)) {
    for (const Entity& entity : entities_.all()) {
      if (entity.kind == owl::TermKind::named_class) classes_.emplace(entity.iri, &entity);
    }
    for (std::uint32_t number = 0; number < hierarchy_.iris.size(); ++number)
      number_of_.emplace(hierarchy_.iris[number], number);
  }

  void run() {
    if (!classification_.is_consistent)
      return findings_.add("contradiction", "", 0, "the files contradict themselves: geminga-ontology check says why");
    check_empty();
    check_equivalents();
    check_roots();
    check_cycles();
    check_superfluous();
  }

 private:
  [[nodiscard]] std::string name(std::uint32_t number) const { return entities_.short_name(hierarchy_.iris[number]); }

  [[nodiscard]] std::string listed(std::span<const std::uint32_t> numbers) const {
    std::string text;
    for (std::size_t at = 0; at < std::min(numbers.size(), max_named); ++at)
      text += (at == 0 ? "" : ", ") + name(numbers[at]);
    return numbers.size() > max_named ? text + " and " + std::to_string(numbers.size() - max_named) + " more" : text;
  }

  void check_empty() {
    for (const auto& [iri, entity] : classes_) {
      const auto found = number_of_.find(iri);
      if (found != number_of_.end() && hierarchy_.is_empty(found->second))
        findings_.add("unsatisfiable", *entity,
                      entity->short_name + " can have no instance: geminga-ontology check says why");
    }
  }

  void check_equivalents() {
    for (std::uint32_t node = 0; node < hierarchy_.members.row_count(); ++node) {
      const std::span members = hierarchy_.members[node];
      if (members.size() < 2 || hierarchy_.is_empty(members.front())) continue;
      const auto entity = classes_.find(hierarchy_.iris[members[1]]);
      if (entity != classes_.end()) findings_.add("synonyms", *entity->second, listed(members) + " are equivalent");
    }
  }

  void check_roots() {
    std::vector<std::uint32_t> roots;
    for (std::uint32_t node = 0; node < hierarchy_.iris.size(); ++node) {
      const auto parents = hierarchy_.parents_of(node);
      if (parents.size() == 1 && parents[0] == hierarchy_.representative[hierarchy_.top]) roots.push_back(node);
    }
    if (roots.size() > 1)
      findings_.add("several-roots", "", 0,
                    counted(roots.size(), "class has", "classes have") + " nothing above: " + listed(roots));
  }

  /// The inclusions between named classes that the files tell, with their axioms.
  [[nodiscard]] std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> told() const {
    std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> supers;
    for (std::uint32_t axiom = 0; axiom < source_.axiom_count(); ++axiom) {
      const owl::Axiom one = source_.axiom(axiom);
      if (one.kind != owl::AxiomKind::sub_class_of) continue;
      const auto is_class = [&](owl::TermId id) { return source_.kind(id) == owl::TermKind::named_class; };
      if (!is_class(one.arguments[0]) || !is_class(one.arguments[1])) continue;
      const auto sub = number_of_.find(source_.name_of(one.arguments[0]));
      const auto super = number_of_.find(source_.name_of(one.arguments[1]));
      if (sub != number_of_.end() && super != number_of_.end()) supers[sub->second].emplace_back(super->second, axiom);
    }
    return supers;
  }

  void add_at(std::string_view code, std::uint32_t axiom, std::string words) {
    const owl::Axiom one = source_.axiom(axiom);
    findings_.add(code, source_.files()[static_cast<std::size_t>(one.file)].path, one.line, std::move(words));
  }

  /// A told inclusion closes a cycle if both classes are equivalent. Each group of equivalents is told of once.
  void check_cycles() {
    std::set<std::uint32_t> seen;
    for (const auto& [sub, supers] : told()) {
      for (const auto& [super, axiom] : supers) {
        const std::uint32_t node = hierarchy_.representative[sub];
        if (sub == super) {
          add_at("cycle", axiom, name(sub) + " is told to be below itself");
        } else if (node == hierarchy_.representative[super] && !hierarchy_.is_empty(sub) && seen.insert(node).second) {
          add_at("cycle", axiom,
                 name(sub) + " is told to be below " + name(super) + ", which is below it: they are one");
        }
      }
    }
  }

  [[nodiscard]] bool is_above(std::uint32_t above, std::uint32_t below) {
    std::vector<std::uint32_t> stack{hierarchy_.representative[below]};
    std::set<std::uint32_t> seen(stack.begin(), stack.end());
    while (!stack.empty()) {
      const std::uint32_t node = stack.back();
      stack.pop_back();
      if (node == hierarchy_.representative[above]) return true;
      for (const std::uint32_t parent : hierarchy_.parents_of(node)) {
        if (seen.insert(parent).second) stack.push_back(parent);
      }
    }
    return false;
  }

  /// A told inclusion is superfluous if another one of the same class leads to a class below its super.
  void check_superfluous() {
    for (const auto& [sub, supers] : told()) {
      for (const auto& [super, axiom] : supers) {
        for (const auto& [nearer, other] : supers) {
          const bool is_other = hierarchy_.representative[nearer] != hierarchy_.representative[super] &&
                                hierarchy_.representative[nearer] != hierarchy_.representative[sub];
          if (!is_other || hierarchy_.is_empty(sub) || super == hierarchy_.top || !is_above(super, nearer)) continue;
          add_at("superfluous", axiom,
                 name(sub) + " is below " + name(super) + " because it is below " + name(nearer) + ", too");
          break;
        }
      }
    }
  }

  const owl::Ontology& source_;
  const taxonomy::Classification& classification_;
  const Entities& entities_;
  LintFindings& findings_;
  const Hierarchy hierarchy_;
  std::map<std::string_view, const Entity*> classes_;
  std::map<std::string_view, std::uint32_t> number_of_;
};

}  // namespace

void check_hierarchy(const ClassifiedFiles& classified, const Entities& entities, LintFindings& findings) {
  HierarchyRules(classified, entities, findings).run();
}

}  // namespace geminga::ontology
