#include "compare/genealogies.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "compare/shape_writer.hpp"

namespace geminga::compare {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

class Genealogy {
 public:
  Genealogy(std::uint64_t seed, std::size_t persons) : seed_(seed), random_(seed) {
    for (std::size_t at = 0; at < persons; ++at) {
      persons_.push_back(writer_.individual("i" + std::to_string(at)));
      is_male_.push_back(random_.chance(0.5));
    }
  }

  owl::Ontology write() {
    add_hierarchy();
    add_chains();
    add_ends();
    add_sexes();
    add_definitions();
    add_persons();
    return writer_.take();
  }

 private:
  using Names = std::vector<std::string>;

  [[nodiscard]] bool has(std::uint64_t feature) const { return (seed_ >> feature) % 2 == 1; }
  TermId named(const std::string& name) { return writer_.named(name); }
  TermId role(const std::string& name) { return writer_.property(name); }
  TermId all_of(std::vector<TermId> parts) { return writer_.term(TermKind::object_intersection_of, std::move(parts)); }
  TermId some(const std::string& along, TermId filler) {
    return writer_.term(TermKind::object_some_values_from, {role(along), filler});
  }
  TermId value(const std::string& along, TermId individual) {
    return writer_.term(TermKind::object_has_value, {role(along), individual});
  }
  void below(const std::string& sub, const std::string& super) {
    writer_.add(AxiomKind::sub_object_property_of, {role(sub), role(super)});
  }
  void chain(const Names& word, const std::string& super) {
    std::vector<TermId> parts;
    for (const std::string& part : word) parts.push_back(role(part));
    writer_.add(AxiomKind::sub_object_property_of, {writer_.term(TermKind::object_property_chain, parts), role(super)});
  }
  void define(const std::string& name, TermId meaning) {
    writer_.add(AxiomKind::equivalent_classes, {named(name), all_of({named("Person"), meaning})});
  }

  void add_hierarchy() {
    for (const auto* name : {"hasFather", "hasMother"}) {
      below(name, "hasParent");
      writer_.add(AxiomKind::functional_object_property, {role(name)});
    }
    below("hasParent", "hasAncestor");
    for (const auto* name : {"hasBrother", "hasSister"}) below(name, "hasSibling");
    writer_.add(AxiomKind::inverse_object_properties, {role("hasParent"), role("hasChild")});
    writer_.add(AxiomKind::inverse_object_properties, {role("hasAncestor"), role("hasDescendant")});
    writer_.add(AxiomKind::transitive_object_property, {role("hasAncestor")});
    for (const auto* name : {"hasSibling", "hasSpouse"})
      writer_.add(AxiomKind::symmetric_object_property, {role(name)});
    if (has(0)) writer_.add(AxiomKind::transitive_object_property, {role("hasSibling")});
    if (has(3)) writer_.add(AxiomKind::asymmetric_object_property, {role("hasParent")});
    if (has(3)) writer_.add(AxiomKind::irreflexive_object_property, {role("hasSpouse")});
  }

  void add_chains() {
    chain({"hasParent", "hasBrother"}, "hasUncle");
    chain({"hasParent", "hasParent"}, "hasGrandparent");
    chain({"hasParent", "hasSibling", "hasChild"}, "hasCousin");
    for (const auto* name : {"hasUncle", "hasAncestor", "hasDescendant", "hasSibling", "hasCousin"})
      below(name, "hasRelative");
    if (!has(1)) return;
    writer_.add(AxiomKind::transitive_object_property, {role("hasRelative")});
    writer_.add(AxiomKind::symmetric_object_property, {role("hasRelative")});
  }

  void add_ends() {
    Names names = {"hasParent", "hasAncestor", "hasSpouse", "hasUncle", "hasGrandparent", "hasCousin", "hasRelative"};
    if (!has(4)) names.emplace_back("hasSibling");  // without it paths say more than their edges
    for (const std::string& name : names) {
      writer_.add(AxiomKind::object_property_domain, {role(name), named("Person")});
      writer_.add(AxiomKind::object_property_range, {role(name), named(name == "hasUncle" ? "Man" : "Person")});
    }
    for (const auto* name : {"hasFather", "hasBrother"})
      writer_.add(AxiomKind::object_property_range, {role(name), named("Man")});
    for (const auto* name : {"hasMother", "hasSister"})
      writer_.add(AxiomKind::object_property_range, {role(name), named("Woman")});
  }

  void add_sexes() {
    writer_.add(AxiomKind::disjoint_classes, {named("Man"), named("Woman")});
    writer_.add(AxiomKind::sub_class_of,
                {named("Person"), all_of({some("hasFather", named("Man")), some("hasMother", named("Woman"))})});
    if (!has(2)) {
      writer_.add(AxiomKind::equivalent_classes,
                  {named("Person"), writer_.term(TermKind::object_union_of, {named("Man"), named("Woman")})});
      return;
    }
    define("Man", value("hasSex", writer_.individual("male")));
    define("Woman", value("hasSex", writer_.individual("female")));
    writer_.add(AxiomKind::functional_object_property, {role("hasSex")});
    writer_.add(AxiomKind::different_individuals, {writer_.individual("male"), writer_.individual("female")});
  }

  void add_definitions() {
    const TermId person = named("Person");
    const TermId one = persons_[random_.below(persons_.size())];
    define("Parent", some("hasChild", person));
    define("Grandparent", some("hasChild", named("Parent")));
    define("Uncle", all_of({named("Man"), some("hasSibling", named("Parent"))}));
    define("Cousin", some("hasParent", all_of({person, some("hasSibling", some("hasChild", person))})));
    define("FarCousin", some("hasAncestor", all_of({person, some("hasSibling", some("hasDescendant", person))})));
    define("Relative", some("hasRelative", person));
    define("AncestorOfOne", value("hasDescendant", one));
    define("GrandparentOfOne", some("hasChild", all_of({person, value("hasChild", one)})));
    define("BigFamily", writer_.term(TermKind::object_min_cardinality, {role("hasChild"), person}, 4));
    define("SmallFamily", all_of({writer_.term(TermKind::object_min_cardinality, {role("hasChild"), person}, 1),
                                  writer_.term(TermKind::object_max_cardinality, {role("hasChild"), person}, 2)}));
  }

  /// Couples of each generation, and their children in the next one.
  void add_persons() {
    for (std::size_t at = 0; at < persons_.size(); ++at) {
      const std::string sex = random_.chance(0.2) ? "Person" : is_male_[at] ? "Man" : "Woman";
      writer_.add(AxiomKind::class_assertion, {named(sex), persons_[at]});
    }
    if (has(3)) writer_.add(AxiomKind::different_individuals, persons_);
    const std::size_t size = std::max<std::size_t>(3, persons_.size() / 6);
    std::vector<std::pair<std::size_t, std::size_t>> former;
    for (std::size_t first = 0; first < persons_.size(); first += size) {
      const std::size_t end = std::min(first + size, persons_.size());
      if (!former.empty()) add_children(former, first, end);
      former = couples(first, end);
      if (former.empty()) return;
    }
  }

  std::vector<std::pair<std::size_t, std::size_t>> couples(std::size_t first, std::size_t end) {
    std::vector<std::size_t> men;
    std::vector<std::size_t> women;
    for (std::size_t at = first; at < end; ++at) (is_male_[at] ? men : women).push_back(at);
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t at = 0; at < std::min(men.size(), women.size()); ++at) {
      found.emplace_back(men[at], women[at]);
      writer_.add(AxiomKind::object_property_assertion, {role("hasSpouse"), persons_[men[at]], persons_[women[at]]});
    }
    return found;
  }

  void add_children(const std::vector<std::pair<std::size_t, std::size_t>>& parents, std::size_t first,
                    std::size_t end) {
    std::vector<std::size_t> youngest(parents.size(), persons_.size());
    for (std::size_t child = first; child < end; ++child) {
      if (random_.chance(0.2)) continue;  // of unknown parents
      const std::size_t at = random_.below(parents.size());
      const auto tell = [&](const char* name, std::size_t other) {
        writer_.add(AxiomKind::object_property_assertion, {role(name), persons_[child], persons_[other]});
      };
      if (random_.chance(0.9)) tell("hasFather", parents[at].first);
      if (random_.chance(0.9)) tell("hasMother", parents[at].second);
      const std::size_t sibling = std::exchange(youngest[at], child);
      if (sibling < persons_.size()) tell(is_male_[sibling] ? "hasBrother" : "hasSister", sibling);
    }
  }

  std::uint64_t seed_;
  base::Random random_;
  ShapeWriter writer_;
  std::vector<TermId> persons_;
  std::vector<bool> is_male_;
};

}  // namespace

owl::Ontology genealogy(std::uint64_t seed, std::size_t persons) { return Genealogy(seed, persons).write(); }

}  // namespace geminga::compare
