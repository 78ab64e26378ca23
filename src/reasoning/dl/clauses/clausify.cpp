// The order of the translation: properties first, because everything else depends on their automata.
#include "reasoning/dl/clauses/clausify.hpp"

#include <algorithm>
#include <tuple>

#include "base/sorted.hpp"
#include "reasoning/dl/clauses/body_nominals.hpp"
#include "reasoning/dl/clauses/class_clauses.hpp"
#include "reasoning/dl/clauses/fact_clauses.hpp"
#include "reasoning/dl/clauses/property_clauses.hpp"
#include "reasoning/dl/clauses/rule_clauses.hpp"
#include "reasoning/dl/clauses/told_ends.hpp"

namespace geminga::clauses {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

/// The limit of clauses grows with the number of axioms. So one axiom in a small file, whose members are pairwise
/// disjoint, takes the memory of a small file.
constexpr std::size_t always_clauses = 1'000'000;
constexpr std::size_t clauses_per_axiom = 100;

/// The translation of one ontology. The clauses depend on the contents of the axioms only: axioms are taken in the
/// order of their hashes.
class Clausifier {
 public:
  Clausifier(const owl::Ontology& source, const ClausifyLimits& limits)
      : source_(source), limits_(limits), hashes_(source), vocabulary_(source, hashes_, set_) {
    limits_.clauses = std::min(limits_.clauses, always_clauses + clauses_per_axiom * source.axiom_count());
    is_seen_.assign(source.term_count(), false);
  }

  [[nodiscard]] std::expected<ClauseSet, ClausifyError> run(std::optional<std::span<const std::uint32_t>> axioms,
                                                            std::span<const TermId> queries,
                                                            std::span<const TermId> complements);

 private:
  [[nodiscard]] std::vector<OrderedAxiom> ordered(std::optional<std::span<const std::uint32_t>> axioms) const;
  /// Gives numbers to the properties in these terms, and finds the top and bottom properties.
  void find_properties(std::span<const TermId> terms);
  void find_property(TermId term);
  [[nodiscard]] std::unexpected<ClausifyError> too_many_clauses() const {
    return std::unexpected(ClausifyError{"the axioms need more than " + std::to_string(limits_.clauses) + " clauses"});
  }

  const owl::Ontology& source_;
  ClausifyLimits limits_;
  owl::ContentHashes hashes_;
  ClauseSet set_;
  Vocabulary vocabulary_;
  std::vector<bool> is_seen_;  ///< by term, in find_properties()
  bool has_named_ = false;     ///< some axiom or query names an individual
  std::optional<Role> top_role_;
  std::optional<Role> bottom_role_;
  std::optional<DataPropertyId> bottom_data_;
};

std::vector<OrderedAxiom> Clausifier::ordered(std::optional<std::span<const std::uint32_t>> axioms) const {
  struct Entry {
    AxiomKind kind;
    owl::ContentHashes::Hash hash;
    std::uint32_t axiom;
  };
  std::vector<Entry> entries;
  const auto add = [&](std::uint32_t number) {
    const owl::Axiom axiom = source_.axiom(number);
    entries.push_back({axiom.kind, hashes_.hash_of(axiom), number});
  };
  if (axioms) {
    std::ranges::for_each(*axioms, add);
  } else {
    for (std::uint32_t number = 0; number < source_.axiom_count(); ++number) add(number);
  }
  // No defaulted <=>: GCC 12 loses that of the pair in a hash when it optimises.
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return std::tie(a.kind, a.hash, a.axiom) < std::tie(b.kind, b.hash, b.axiom);
  });
  std::vector<OrderedAxiom> result;
  for (const Entry& entry : entries) {
    const auto arguments = source_.axiom(entry.axiom).arguments;
    result.push_back(
        {entry.axiom, entry.kind, hashes_.sorted(arguments, owl::set_begin(entry.kind, arguments.size()))});
  }
  return result;
}

void Clausifier::find_properties(std::span<const TermId> terms) {
  std::vector<TermId> open(terms.rbegin(), terms.rend());
  while (!open.empty()) {
    const TermId id = open.back();
    open.pop_back();
    if (is_seen_[static_cast<std::size_t>(id)]) continue;
    is_seen_[static_cast<std::size_t>(id)] = true;
    find_property(id);
    const owl::Term term = source_.term(id);
    has_named_ = has_named_ || term.kind == TermKind::individual;
    const auto arguments = hashes_.sorted(term.arguments, owl::set_begin(term.kind, term.arguments.size()));
    open.insert(open.end(), arguments.rbegin(), arguments.rend());
  }
}

void Clausifier::find_property(TermId term) {
  const std::string_view name = source_.name_of(term);
  if (source_.kind(term) == TermKind::object_property) {
    const Role role = vocabulary_.role(term);
    if (name == owl::owl_top_object_property) top_role_ = role;
    if (name == owl::owl_bottom_object_property) bottom_role_ = role;
  } else if (source_.kind(term) == TermKind::data_property && name == owl::owl_bottom_data_property) {
    bottom_data_ = vocabulary_.data_property(term);
  }
}

/// Why the axiom has no clauses, or not all. Empty if it has.
std::string_view problem_of(const OrderedAxiom& axiom, const owl::Ontology& source, Allowed& allowed,
                            ClassClauses& of_classes, PropertyClauses& of_properties) {
  if (axiom.kind == AxiomKind::declaration) return {};
  const bool is_trivial = axiom.kind == AxiomKind::sub_data_property_of;  // owl:topDataProperty may be the super
  for (const TermId argument : std::span(axiom.arguments).first(is_trivial ? 1 : axiom.arguments.size())) {
    if (source.kind(argument) == TermKind::data_property && allowed.is_top_data(argument)) return "owl:topDataProperty";
  }
  const std::string_view found = of_classes.problem(axiom);
  return found.empty() ? of_properties.problem(axiom) : found;
}

/// Whether an axiom with a problem has clauses for the rest of it: other inclusions of the same axiom; and of what is
/// said of a property that is not simple, what it says of the edges that clauses derive. Its paths are no edges.
bool is_used_in_part(AxiomKind kind) {
  switch (kind) {
    case AxiomKind::equivalent_classes:
    case AxiomKind::disjoint_union:
    case AxiomKind::disjoint_classes:
    case AxiomKind::functional_object_property:
    case AxiomKind::inverse_functional_object_property:
    case AxiomKind::irreflexive_object_property:
    case AxiomKind::asymmetric_object_property:
    case AxiomKind::disjoint_object_properties:
      return true;
    default:
      return false;
  }
}

std::expected<ClauseSet, ClausifyError> Clausifier::run(std::optional<std::span<const std::uint32_t>> axioms,
                                                        std::span<const TermId> queries,
                                                        std::span<const TermId> complements) {
  const std::vector<OrderedAxiom> all = ordered(axioms);
  for (const OrderedAxiom& axiom : all) {
    if (axiom.kind == AxiomKind::declaration) {
      has_named_ = has_named_ || source_.kind(axiom.arguments[0]) == TermKind::individual;
      continue;
    }
    std::span<const TermId> arguments(axiom.arguments);
    // R SubPropertyOf owl:topObjectProperty says nothing.
    const bool has_super = axiom.kind == AxiomKind::sub_object_property_of;
    if (has_super && source_.name_of(arguments[1]) == owl::owl_top_object_property) arguments = arguments.first(1);
    find_properties(arguments);
  }
  find_properties(queries);
  find_properties(complements);

  std::vector<owl::RoleInclusion> inclusions;
  std::vector<owl::RoleChain> chains;
  for (const OrderedAxiom& axiom : all) collect_roles(axiom, vocabulary_, inclusions, chains);
  if (top_role_) {
    // Everything is connected with one individual, and thus with everything else.
    inclusions.push_back({inverse(*top_role_), *top_role_});
    chains.push_back({{*top_role_, *top_role_}, *top_role_, 0});
  }
  owl::RoleBox roles(set_.properties.size(), inclusions, chains, limits_.automaton_states);
  Allowed allowed(vocabulary_, roles, limits_.cardinality);
  ToldEnds ends(vocabulary_, roles, inclusions, allowed, all);
  Translator translator(vocabulary_, roles, ends, set_, limits_.clauses);
  PropertyClauses of_properties(vocabulary_, allowed, translator);
  ClassClauses of_classes(vocabulary_, allowed, translator, set_);
  FactClauses of_facts(vocabulary_, translator, set_, limits_.clauses, all);
  RuleClauses of_rules(vocabulary_, roles, allowed, translator, set_);
  for (const std::uint32_t axiom : roles.left_out()) set_.unused.push_back({axiom, "an irregular property chain"});
  of_properties.add_hierarchy(inclusions, roles, set_.properties.size());
  if (top_role_) {
    const AtLeast connection{1, roles.canonical(*top_role_), vocabulary_.nominal(vocabulary_.fresh_individual())};
    translator.add_clause({{}, {{AtomKind::at_least, centre, centre, vocabulary_.index(connection)}}});
  }
  if (bottom_role_) translator.add_every(*bottom_role_, bottom, bottom);
  if (bottom_data_) translator.add_clause({{{AtomKind::data_role, centre, 1, number(*bottom_data_)}}, {}});

  base::BudgetUse budget(limits_.budget);
  for (const OrderedAxiom& axiom : all) {
    if (!budget.spend(1)) return std::unexpected(ClausifyError{limits_.budget->reason().value_or("")});
    const std::string_view reason = problem_of(axiom, source_, allowed, of_classes, of_properties);
    if (!reason.empty()) set_.unused.push_back({axiom.axiom, reason});
    if (!reason.empty() && !is_used_in_part(axiom.kind)) continue;
    if (axiom.kind == AxiomKind::declaration) {
      const TermKind kind = source_.kind(axiom.arguments[0]);
      if (kind == TermKind::named_class) vocabulary_.concept_of(axiom.arguments[0]);
      if (kind == TermKind::individual) vocabulary_.individual(axiom.arguments[0]);
    } else if (axiom.kind == AxiomKind::datatype_definition) {
      set_.datatype_definitions.push_back({axiom.arguments[0], axiom.arguments[1]});
    } else if (axiom.kind == AxiomKind::dl_safe_rule) {
      // Without named individuals a rule says nothing.
      if (!has_named_) continue;
      if (const std::string_view problem = of_rules.add(axiom); !problem.empty())
        set_.unused.push_back({axiom.axiom, problem});
    } else {
      of_classes.add(axiom);
      of_properties.add(axiom);
      of_facts.add(axiom);
    }
    if (translator.is_full() || set_.equalities.size() > limits_.clauses) return too_many_clauses();
  }
  for (const bool is_complement : {false, true}) {
    for (const TermId expression : is_complement ? complements : queries) {
      const Literal literal{expression, is_complement, Part::whole};
      if (const std::string_view reason = allowed.problem(literal); !reason.empty()) {
        return std::unexpected(ClausifyError{"the expression that is asked for has " + std::string(reason)});
      }
      (is_complement ? set_.complements : set_.queries).push_back(translator.below(literal));
    }
  }
  translator.define_names();
  if (translator.is_full()) return too_many_clauses();
  base::sort_unique(set_.clauses);
  replace_body_nominals(set_);
  std::ranges::sort(set_.unused, {}, &Unused::axiom);
  set_.roles.emplace(std::move(roles));
  return std::move(set_);
}

}  // namespace

std::expected<ClauseSet, ClausifyError> clausify(const owl::Ontology& source,
                                                 std::optional<std::span<const std::uint32_t>> axioms,
                                                 std::span<const TermId> queries, std::span<const TermId> complements,
                                                 const ClausifyLimits& limits) {
  return Clausifier(source, limits).run(axioms, queries, complements);
}

}  // namespace geminga::clauses
