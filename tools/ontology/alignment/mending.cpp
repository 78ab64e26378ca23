#include "ontology/alignment/mending.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "ontology/loading/closure.hpp"
#include "ontology/loading/hierarchy.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/explanation/explain.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/reasoner/excerpt.hpp"

namespace geminga::ontology {
namespace {

/// Each round classifies anew, and takes out one link for each of so many faults.
constexpr std::size_t most_faults_of_a_round = 50;
constexpr std::size_t most_rounds = 200;

/// A subsumption that follows with the links and is not wanted; `super` is owl:Nothing for a class without instances.
struct Fault {
  std::string sub;
  std::string super;
  std::string words;
};

/// The subsumptions of one side, by which new ones are known.
class Known {
 public:
  explicit Known(const ClassifiedFiles& files)
      : hierarchy_(class_hierarchy(files.loaded.source, files.classification)),
        is_consistent_(files.classification.is_consistent) {
    for (std::uint32_t number = 0; number < hierarchy_.iris.size(); ++number)
      numbers_.emplace(hierarchy_.iris[number], number);
    closure_ = closure_of(hierarchy_, numbers_);
  }
  [[nodiscard]] bool has(std::string_view iri) const { return numbers_.contains(iri); }
  [[nodiscard]] bool is_empty(std::string_view iri) const {
    const auto found = numbers_.find(iri);
    return found != numbers_.end() && hierarchy_.is_empty(found->second);
  }
  [[nodiscard]] bool is_consistent() const { return is_consistent_; }
  /// Whether a subsumption of classes that this side has follows from it; true as well where it cannot be told.
  [[nodiscard]] bool follows(std::string_view sub, std::string_view super) const {
    if (!closure_ || is_empty(sub)) return true;
    const Subsumption pair{taxonomy::ClassNumber{numbers_.at(sub)}, taxonomy::ClassNumber{numbers_.at(super)}};
    return std::ranges::binary_search(closure_->pairs, pair);
  }

 private:
  Hierarchy hierarchy_;
  bool is_consistent_;
  ClassNumbers numbers_;
  std::optional<Closure> closure_;
};

class Mending {
 public:
  Mending(rdf::Loaded& both, std::vector<Link> links, const Sides& sides, base::Budget& budget)
      : source_(both.source),
        one_(sides.one),
        other_(sides.other),
        is_conservative_(sides.is_conservative),
        budget_(budget),
        short_name_(short_names(both.source)) {
    for (std::uint32_t number = 0; number < source_.axiom_count(); ++number) axioms_.push_back(number);
    for (Link& link : links) add(std::move(link));
    const owl::ContentHashes hashes(source_);
    for (const auto& [axiom, link] : links_) link_of_.emplace(hashes.hash_of(source_.axiom(axiom)), axiom);
  }

  Mended run() {
    for (std::size_t round = 0; round < most_rounds; ++round) {
      if (!take_out_faults()) break;
    }
    for (const auto& [axiom, link] : links_) mended_.links.push_back(link);
    return std::move(mended_);
  }

 private:
  void add(Link link) {
    const bool is_class = link.kind == owl::TermKind::named_class;
    const bool is_object = link.kind == owl::TermKind::object_property;
    const bool is_equivalence = link.relation == Relation::equivalent;
    const owl::AxiomKind kind = !is_equivalence ? owl::AxiomKind::sub_class_of
                                : is_class      ? owl::AxiomKind::equivalent_classes
                                : is_object     ? owl::AxiomKind::equivalent_object_properties
                                                : owl::AxiomKind::equivalent_data_properties;
    const auto number = static_cast<std::uint32_t>(source_.axiom_count());
    owl::TermId first = source_.entity(link.kind, link.one);
    owl::TermId second = source_.entity(link.kind, link.other);
    if (link.relation == Relation::broader) std::swap(first, second);
    source_.add(kind, {first, second}, owl::FileId{0}, 0);
    links_.emplace(number, std::move(link));
  }

  /// Classifies with the links that are left. Returns whether one was taken out.
  bool take_out_faults() {
    std::vector<std::uint32_t> axioms = axioms_;
    for (const auto& [axiom, link] : links_) axioms.push_back(axiom);
    const reasoner::Excerpt excerpt(source_, axioms);
    const auto classified = reasoner::classify(excerpt.source, {.budget = &budget_});
    if (!classified || budget_.is_spent()) {
      mended_.is_certain = false;
      return false;
    }
    mended_.is_certain = classified->gaps.empty();
    const std::vector<Fault> faults = faults_in(excerpt.source, *classified);
    if (faults.empty()) return false;
    const auto ontology = compiled::Ontology::from_bytes(compiled::compile(excerpt.source, *classified, {}));
    if (!ontology) {
      mended_.is_certain = false;
      return false;
    }
    return take_out(*ontology, faults);
  }

  [[nodiscard]] std::vector<Fault> faults_in(const owl::Ontology& source,
                                             const reasoner::Classified& classified) const {
    std::vector<Fault> faults;
    const std::string nothing(owl::owl_nothing);
    if (!classified.is_consistent) {
      if (one_.is_consistent() && other_.is_consistent())
        faults.push_back({std::string(owl::owl_thing), nothing, "both contradict each other"});
      return faults;
    }
    const Hierarchy hierarchy = class_hierarchy(source, classified);
    for (std::uint32_t number = 0; number < hierarchy.iris.size() && faults.size() < most_faults_of_a_round; ++number) {
      const std::string_view iri = hierarchy.iris[number];
      if (iri == owl::owl_nothing || !hierarchy.is_empty(number) || one_.is_empty(iri) || other_.is_empty(iri))
        continue;
      faults.push_back({std::string(iri), nothing, short_name_(iri) + " can have no instance"});
    }
    if (faults.empty() && is_conservative_) add_new_subsumptions(hierarchy, faults);
    return faults;
  }

  void add_new_subsumptions(const Hierarchy& hierarchy, std::vector<Fault>& faults) const {
    ClassNumbers numbers;
    for (std::uint32_t number = 0; number < hierarchy.iris.size(); ++number)
      numbers.emplace(hierarchy.iris[number], number);
    const auto closure = closure_of(hierarchy, numbers);
    if (!closure) return;
    for (const Subsumption& pair : closure->pairs) {
      const std::string_view sub = hierarchy.iris[static_cast<std::size_t>(pair.sub)];
      const std::string_view super = hierarchy.iris[static_cast<std::size_t>(pair.super)];
      for (const Known* side : {&one_, &other_}) {
        if (!side->has(sub) || !side->has(super) || side->follows(sub, super)) continue;
        faults.push_back(
            {std::string(sub), std::string(super), short_name_(sub) + " is subsumed by " + short_name_(super)});
      }
      if (faults.size() >= most_faults_of_a_round) return;
    }
  }

  /// Takes out the link with the least confidence of a minimal set for each fault that no earlier one has undone.
  bool take_out(const compiled::Ontology& ontology, const std::vector<Fault>& faults) {
    std::set<std::uint32_t> taken;
    for (const Fault& fault : faults) {
      const auto sub = ontology.find_iri(fault.sub);
      const auto super = ontology.find_iri(fault.super);
      if (!sub || !super || budget_.is_spent()) continue;
      explanation::Explainer explainer(ontology, *sub, *super, explanation::Patience::of_a_person, &budget_);
      const auto set = explainer.find_one();
      if (!set) continue;
      const std::vector<std::uint32_t> links = links_in(explainer.module().source(), *set);
      const bool is_undone = std::ranges::any_of(links, [&](std::uint32_t link) { return taken.contains(link); });
      if (links.empty() || is_undone) continue;
      const std::uint32_t worst = *std::ranges::min_element(links, {}, [this](std::uint32_t link) {
        return std::pair(links_.at(link).confidence, -static_cast<double>(link));
      });
      taken.insert(worst);
      mended_.rejected.push_back({links_.at(worst), fault.words});
    }
    for (const std::uint32_t link : taken) links_.erase(link);
    mended_.is_certain = mended_.is_certain && !taken.empty();
    return !taken.empty();
  }

  /// The links among axioms of a module, which hold the same two entities.
  [[nodiscard]] std::vector<std::uint32_t> links_in(const owl::Ontology& module,
                                                    const explanation::AxiomSet& set) const {
    const owl::ContentHashes hashes(module);
    std::vector<std::uint32_t> found;
    for (const std::uint32_t axiom : set) {
      if (const auto link = link_of_.find(hashes.hash_of(module.axiom(axiom))); link != link_of_.end())
        found.push_back(link->second);
    }
    return found;
  }

  owl::Ontology& source_;
  const Known one_;
  const Known other_;
  bool is_conservative_;
  base::Budget& budget_;
  std::function<std::string(std::string_view)> short_name_;
  std::vector<std::uint32_t> axioms_;                          ///< of the files
  std::map<std::uint32_t, Link> links_;                        ///< that are left, by their axiom
  std::map<owl::ContentHashes::Hash, std::uint32_t> link_of_;  ///< the axiom of each link that was given
  Mended mended_;
};

}  // namespace

Mended mend(rdf::Loaded& both, std::vector<Link> links, const Sides& sides, base::Budget& budget) {
  return Mending(both, std::move(links), sides, budget).run();
}

}  // namespace geminga::ontology
