// The naive fixpoint, and the generator of its inputs.
#include "reference.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace geminga::owl {
namespace {

using Terms = std::set<TermId>;

/// Elements of a canonical model: one for each filler and set of ranges.
class Reference {
 public:
  explicit Reference(const Ontology& source) : source_(source) {
    for (std::uint32_t id = 0; id < source.term_count(); ++id) all_.push_back(TermId{id});
    read();
    for (const TermId term : all_) {
      if (source.kind(term) == TermKind::named_class) element(term, {});
    }
    while (step()) {
    }
  }

  [[nodiscard]] bool has_range_over_chain() const {
    for (const auto& [first, second, result] : chains_) {
      const Terms of_last = ranges_of(second);
      for (const TermId range : ranges_of(result)) {
        if (!of_last.contains(range)) return true;
      }
    }
    return false;
  }

  std::vector<std::string> closure() {
    std::vector<std::string> lines;
    for (const TermId sub : all_) {
      if (source_.kind(sub) != TermKind::named_class || sub == nothing_term) continue;
      const Terms& above = elements_[element(sub, {})];
      if (sub == thing_term && above.contains(nothing_term)) return {"inconsistent"};
      if (above.contains(nothing_term)) {
        lines.push_back(name(sub) + " < Nothing");
        continue;
      }
      for (const TermId super : above) {
        if (source_.kind(super) == TermKind::named_class && super != sub && super != thing_term) {
          lines.push_back(name(sub) + " < " + name(super));
        }
      }
    }
    std::ranges::sort(lines);
    return lines;
  }

 private:
  using Element = std::pair<TermId, Terms>;

  [[nodiscard]] std::string name(TermId id) const {
    const std::string iri(source_.name_of(id));
    return iri.substr(iri.find('#') + 1);
  }

  std::size_t element(TermId term, const Terms& ranges) {
    const auto [entry, is_new] = number_.try_emplace({term, ranges}, elements_.size());
    if (is_new) {
      Terms initial = ranges;
      initial.insert(term);
      initial.insert(thing_term);
      elements_.push_back(initial);
    }
    return entry->second;
  }

  void include_roles(TermId sub, TermId super) { role_axioms_.emplace_back(sub, super); }

  void read() {
    for (std::size_t at = 0; at < source_.axiom_count(); ++at) {
      const Axiom axiom = source_.axiom(at);
      const auto args = axiom.arguments;
      switch (axiom.kind) {
        case AxiomKind::sub_class_of:
          inclusions_.emplace_back(args[0], args[1]);
          break;
        case AxiomKind::equivalent_classes:
          inclusions_.emplace_back(args[0], args[1]);
          inclusions_.emplace_back(args[1], args[0]);
          break;
        case AxiomKind::disjoint_classes:
          disjoint_.emplace_back(args.begin(), args.end());
          break;
        case AxiomKind::sub_object_property_of:
          if (source_.kind(args[0]) == TermKind::object_property_chain) {
            const auto chain = source_.term(args[0]).arguments;
            chains_.emplace_back(chain[0], chain[1], args[1]);
          } else {
            include_roles(args[0], args[1]);
          }
          break;
        case AxiomKind::transitive_object_property:
          chains_.emplace_back(args[0], args[0], args[0]);
          break;
        case AxiomKind::reflexive_object_property:
          reflexive_.push_back(args[0]);
          break;
        case AxiomKind::object_property_domain:
          domains_.emplace_back(args[0], args[1]);
          break;
        case AxiomKind::object_property_range:
          ranges_.emplace_back(args[0], args[1]);
          break;
        default:
          break;
      }
    }
  }

  [[nodiscard]] bool is_sub_role(TermId sub, TermId super) const {
    Terms seen = {sub};
    for (bool grown = true; grown;) {
      grown = false;
      for (const auto& [below, above] : role_axioms_) {
        if (seen.contains(below)) grown |= seen.insert(above).second;
      }
    }
    return seen.contains(super);
  }

  [[nodiscard]] Terms ranges_of(TermId role) const {
    Terms found;
    for (const auto& [of, range] : ranges_) {
      if (is_sub_role(role, of)) found.insert(range);
    }
    return found;
  }

  bool add(std::size_t to, TermId term) { return elements_[to].insert(term).second; }
  bool link(std::size_t from, TermId role, std::size_t to) { return links_.insert({from, role, to}).second; }

  bool add_self(std::size_t to, TermId role) {
    bool changed = selfs_.insert({to, role}).second;
    changed |= link(to, role, to);
    for (const TermId range : ranges_of(role)) changed |= add(to, range);
    return changed;
  }

  bool step_term(std::size_t at, TermId term) {
    bool changed = false;
    const Term shape = source_.term(term);
    const Terms known = elements_[at];
    if (known.contains(term)) {
      for (const auto& [sub, super] : inclusions_) {
        if (sub == term) changed |= add(at, super);
      }
      if (shape.kind == TermKind::object_intersection_of) {
        for (const TermId part : shape.arguments) changed |= add(at, part);
      } else if (shape.kind == TermKind::object_some_values_from) {
        const std::size_t to = element(shape.arguments[1], ranges_of(shape.arguments[0]));
        changed |= link(at, shape.arguments[0], to);
      } else if (shape.kind == TermKind::object_has_self) {
        changed |= add_self(at, shape.arguments[0]);
      }
    } else if (shape.kind == TermKind::object_intersection_of) {
      if (std::ranges::all_of(shape.arguments, [&](TermId part) { return known.contains(part); }))
        changed |= add(at, term);
    } else if (shape.kind == TermKind::object_some_values_from) {
      for (const auto& [from, role, to] : links_) {
        if (from == at && elements_[to].contains(shape.arguments[1]) && is_sub_role(role, shape.arguments[0])) {
          changed |= add(at, term);
          break;
        }
      }
    } else if (shape.kind == TermKind::object_has_self) {
      for (const auto& [of, role] : selfs_) {
        if (of == at && is_sub_role(role, shape.arguments[0])) {
          changed |= add(at, term);
          break;
        }
      }
    }
    return changed;
  }

  bool step() {
    bool changed = false;
    for (std::size_t at = 0; at < elements_.size(); ++at) {
      for (const TermId term : all_) changed |= step_term(at, term);
      for (const TermId role : reflexive_) changed |= add_self(at, role);
      for (const auto& members : disjoint_) {
        const auto count =
            std::ranges::count_if(members, [&](TermId member) { return elements_[at].contains(member); });
        if (count > 1) changed |= add(at, nothing_term);
      }
    }
    const auto links = links_;
    for (const auto& [from, role, to] : links) {
      if (elements_[to].contains(nothing_term)) changed |= add(from, nothing_term);
      for (const auto& [of, domain] : domains_) {
        if (is_sub_role(role, of)) changed |= add(from, domain);
      }
      for (const auto& [first, second, result] : chains_) {
        if (!is_sub_role(role, first)) continue;
        for (const auto& [next_from, next_role, next_to] : links) {
          if (next_from == to && is_sub_role(next_role, second)) changed |= link(from, result, next_to);
        }
      }
    }
    const auto selfs = selfs_;
    for (const auto& [at, role] : selfs) {
      for (const auto& [first, second, result] : chains_) {
        if (is_sub_role(role, first) && std::ranges::any_of(selfs, [&](const auto& other) {
              return other.first == at && is_sub_role(other.second, second);
            })) {
          changed |= add_self(at, result);
        }
      }
    }
    return changed;
  }

  const Ontology& source_;
  std::vector<TermId> all_;
  std::map<Element, std::size_t> number_;
  std::vector<Terms> elements_;
  std::set<std::tuple<std::size_t, TermId, std::size_t>> links_;
  std::set<std::pair<std::size_t, TermId>> selfs_;
  std::vector<std::pair<TermId, TermId>> inclusions_;
  std::vector<std::vector<TermId>> disjoint_;
  std::vector<std::pair<TermId, TermId>> role_axioms_;
  std::vector<std::tuple<TermId, TermId, TermId>> chains_;
  std::vector<TermId> reflexive_;
  std::vector<std::pair<TermId, TermId>> domains_;
  std::vector<std::pair<TermId, TermId>> ranges_;
};

/// Writes random axioms.
class Generator {
 public:
  explicit Generator(base::Random& random, std::size_t size) : random_(random), classes_(size / 2 + 3) {}

  std::string name() { return "C" + std::to_string(random_.below(classes_)); }
  std::string role() { return "r" + std::to_string(random_.below(4)); }

  std::string expression(int depth) {
    const std::uint64_t choice = random_.below(depth == 0 ? 6 : 12);
    if (choice < 6) return random_.chance(0.03) ? (random_.chance(0.5) ? "Thing" : "Nothing") : name();
    if (choice < 8) return "ObjectIntersectionOf(" + expression(depth - 1) + " " + expression(depth - 1) + ")";
    if (choice == 11 && random_.chance(0.3)) return "ObjectHasSelf(" + role() + ")";
    return "ObjectSomeValuesFrom(" + role() + " " + expression(depth - 1) + ")";
  }

  std::string axiom() {
    switch (random_.below(20)) {
      case 0:
        return "EquivalentClasses(" + name() + " " + expression(2) + ")";
      case 1:
        return "EquivalentClasses(" + name() + " " + expression(1) + ")";
      case 2: {
        std::string text = "DisjointClasses(" + name();
        for (std::uint64_t more = 1 + random_.below(5); more > 0; --more) text += " " + name();
        return random_.chance(0.4) ? text + ")" : "SubClassOf(" + name() + " " + name() + ")";
      }
      case 3:
        return "SubObjectPropertyOf(" + role() + " " + role() + ")";
      case 4:
        return random_.chance(0.5)
                   ? "SubObjectPropertyOf(ObjectPropertyChain(" + role() + " " + role() + ") " + role() + ")"
                   : "TransitiveObjectProperty(" + role() + ")";
      case 5:
        return random_.chance(0.3) ? "ReflexiveObjectProperty(" + role() + ")"
                                   : "ObjectPropertyDomain(" + role() + " " + name() + ")";
      case 6:
        return "ObjectPropertyRange(" + role() + " " + expression(1) + ")";
      default:
        return "SubClassOf(" + expression(2) + " " + expression(2) + ")";
    }
  }

 private:
  base::Random& random_;
  std::size_t classes_;
};

}  // namespace

std::vector<std::string> reference_closure(const Ontology& source) { return Reference(source).closure(); }

bool has_range_over_chain(const Ontology& source) { return Reference(source).has_range_over_chain(); }

std::string random_ontology(base::Random& random, std::size_t size) {
  Generator generator(random, size);
  std::string text;
  for (std::size_t at = 0; at < size; ++at) text += generator.axiom() + "\n";
  return text;
}

}  // namespace geminga::owl
