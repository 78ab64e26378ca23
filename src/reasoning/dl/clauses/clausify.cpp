// The order of the translation: properties first, because everything else depends on their automata.
#include "reasoning/dl/clauses/clausify.hpp"

#include <algorithm>
#include <tuple>

#include "base/sorted.hpp"
#include "reasoning/dl/clauses/clausifier.hpp"

namespace geminga::clauses {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

namespace {

/// The limit of clauses grows with the number of arguments that are written. So one axiom in a small file, whose
/// members are pairwise disjoint, takes the memory of a small file.
constexpr std::size_t always_clauses = 1'000'000;
constexpr std::size_t clauses_per_axiom = 100;

}  // namespace

Clausifier::Clausifier(const owl::Ontology& source, const ClausifyLimits& limits)
    : source_(source), limits_(limits), hashes_(source), vocabulary_(source, hashes_, set_) {
  limits_.clauses = std::min(limits_.clauses, always_clauses + clauses_per_axiom * source.axiom_count());
  is_seen_.assign(source.term_count(), false);
}

void Clausifier::order(std::optional<std::span<const std::uint32_t>> axioms) {
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
  for (const Entry& entry : entries) {
    const auto arguments = source_.axiom(entry.axiom).arguments;
    axioms_.push_back(
        {entry.axiom, entry.kind, hashes_.sorted(arguments, owl::set_begin(entry.kind, arguments.size()))});
  }
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

void Clausifier::run(std::optional<std::span<const std::uint32_t>> axioms, std::span<const TermId> queries,
                     std::span<const TermId> complements) {
  order(axioms);
  for (const Ordered& axiom : axioms_) {
    if (axiom.kind == AxiomKind::declaration) continue;
    std::span<const TermId> arguments(axiom.arguments);
    // R SubPropertyOf owl:topObjectProperty says nothing.
    const bool has_super = axiom.kind == AxiomKind::sub_object_property_of;
    if (has_super && source_.name_of(arguments[1]) == owl::owl_top_object_property) arguments = arguments.first(1);
    find_properties(arguments);
  }
  find_properties(queries);
  find_properties(complements);
  build_roles();
  for (const Ordered& axiom : axioms_) {
    if (problem_) return;
    const std::string_view reason = problem_of(axiom);
    if (!reason.empty()) set_.unused.push_back({axiom.axiom, reason});
    // Other inclusions of the same axiom may still be used.
    const bool has_parts = axiom.kind == AxiomKind::equivalent_classes || axiom.kind == AxiomKind::disjoint_union ||
                           axiom.kind == AxiomKind::disjoint_classes;
    if (reason.empty() || has_parts) add(axiom);
    if (translator_->is_full() || set_.equalities.size() > limits_.clauses) {
      problem_ = "the axioms need more than " + std::to_string(limits_.clauses) + " clauses";
    }
  }
  ask(queries, false, set_.queries);
  ask(complements, true, set_.complements);
  translator_->define_names();
  if (translator_->is_full()) problem_ = "the axioms need more than " + std::to_string(limits_.clauses) + " clauses";
  base::sort_unique(set_.clauses);
  std::ranges::sort(set_.unused, {}, &Unused::axiom);
}

void Clausifier::ask(std::span<const TermId> expressions, bool is_complement, std::vector<ConceptId>& answers) {
  for (const TermId expression : expressions) {
    const Literal literal{expression, is_complement, Part::whole};
    if (const std::string_view reason = allowed_->problem(literal); !reason.empty()) {
      problem_ = "the expression that is asked for has " + std::string(reason);
    }
    if (problem_) return;
    answers.push_back(translator_->below(literal));
  }
}

std::expected<ClauseSet, ClausifyError> clausify(const owl::Ontology& source,
                                                 std::optional<std::span<const std::uint32_t>> axioms,
                                                 std::span<const TermId> queries, std::span<const TermId> complements,
                                                 const ClausifyLimits& limits) {
  Clausifier clausifier(source, limits);
  clausifier.run(axioms, queries, complements);
  if (clausifier.problem()) return std::unexpected(ClausifyError{*clausifier.problem()});
  return clausifier.take();
}

}  // namespace geminga::clauses
