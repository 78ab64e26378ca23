#include "reasoning/reasoner/repairs.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "reasoning/reasoner/data_use.hpp"
#include "reasoning/reasoner/ill_typed_values.hpp"

namespace geminga::reasoner {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

/// So many ill-typed literals may have equal or different values.
constexpr std::size_t max_alike = 4;

/// One ill-typed literal of one axiom. The same text elsewhere may stand for another value.
struct Slot {
  std::size_t axiom = 0;  ///< position among the ill-typed ones
  TermId literal{};
  std::vector<TermId> values;
};

class Repairs {
 public:
  Repairs(owl::Ontology& source, std::span<const std::size_t> ill_typed)
      : source_(source), ill_typed_(ill_typed), uses_(source) {}

  std::expected<std::vector<std::vector<Statement>>, std::string> run(std::span<const std::uint32_t> premise,
                                                                      std::span<const std::uint32_t> conclusion) {
    for (const std::uint32_t number : premise) uses_.add(source_.axiom(number), true);
    for (const std::uint32_t number : conclusion) uses_.add(source_.axiom(number), false);
    for (const std::size_t number : ill_typed_) uses_.add(source_.ill_typed(number), true);
    for (std::size_t at = 0; at < ill_typed_.size(); ++at) {
      // Axioms that use the datatype are not among those of the axiom's properties.
      if (source_.ill_typed(ill_typed_[at]).kind == AxiomKind::datatype_definition)
        return std::unexpected("the definition of a datatype is damaged");
      if (!find_slots(at)) return std::unexpected("a bound of a datatype is damaged");
    }
    if (std::ranges::count_if(slots_, [&](const Slot& slot) { return !is_fact(slot.axiom); }) >
        static_cast<std::ptrdiff_t>(max_repairs))
      return std::unexpected("there are too many of them");
    are_facts_ = std::ranges::all_of(slots_, [&](const Slot& slot) { return is_fact(slot.axiom); });
    std::size_t repairs = 1;
    for (Slot& slot : slots_) {
      auto values = values_in(slot);
      if (!values) return std::unexpected(std::move(values.error()));
      slot.values = std::move(*values);
      repairs *= slot.values.size();
      if (repairs > max_repairs)
        return std::unexpected("there are more than " + std::to_string(max_repairs) + " readings of it");
    }
    std::vector<std::vector<Statement>> all;
    all.reserve(repairs);
    for (std::size_t repair = 0; repair < repairs; ++repair) all.push_back(written(repair));
    return all;
  }

 private:
  /// False if a bound is ill-typed: what lies between two bounds depends on more than their order.
  bool find_slots(std::size_t axiom) {
    const auto terms = owl::terms_in(source_, source_.ill_typed(ill_typed_[axiom]).arguments);
    for (const TermId id : terms) {
      if (source_.is_well_typed(id)) continue;
      if (source_.kind(id) == TermKind::facet || source_.kind(id) == TermKind::datatype_restriction) return false;
      if (source_.kind(id) == TermKind::literal) slots_.push_back({axiom, id, {}});
    }
    return true;
  }

  [[nodiscard]] bool is_fact(std::size_t axiom) const {
    return source_.ill_typed(ill_typed_[axiom]).kind == AxiomKind::data_property_assertion;
  }

  /// The property of all ill-typed axioms that mention these properties, if all of them are facts about one property.
  /// Then a value of one individual can be exchanged without those of others.
  [[nodiscard]] std::optional<TermId> property_of_facts(const DataUse& use) const {
    std::optional<TermId> property;
    if (!are_facts_) return std::nullopt;
    for (const std::size_t number : ill_typed_) {
      const TermId its = source_.ill_typed(number).arguments[0];
      if (!use.facts.contains(its)) continue;
      if (property && *property != its) return std::nullopt;
      property = its;
    }
    return use.is_key ? std::nullopt : property;
  }

  /// The values for a slot. Facts about one property with literals of one datatype may be many, and share them.
  std::expected<std::vector<TermId>, std::string> values_in(const Slot& slot) {
    const owl::Axiom axiom = source_.ill_typed(ill_typed_[slot.axiom]);
    const TermId datatype = source_.term(slot.literal).arguments[0];
    if (!is_fact(slot.axiom)) return values_in(uses_.use_in(axiom), datatype);
    const std::pair key{axiom.arguments[0], datatype};
    if (const auto known = values_.find(key); known != values_.end()) return known->second;
    auto values = values_in(uses_.use_in(axiom), datatype);
    if (values) values_.emplace(key, *values);
    return values;
  }

  std::expected<std::vector<TermId>, std::string> values_in(const DataUse& use, TermId type) {
    Distinctions distinctions{use.datatypes, use.literals, use.facets};
    std::set<TermId> taken;
    const std::optional<TermId> alone = property_of_facts(use);
    for (const auto& [property, literals] : use.facts)
      (alone == property ? taken : distinctions.literals).insert(literals.begin(), literals.end());
    const std::size_t alike = use.is_counted || !are_facts_ ? slots_.size() : 1;
    if (alike > max_alike) return std::unexpected("there are " + std::to_string(alike) + " of them");
    const std::string datatype(source_.name_of(type));
    return values_of(source_, datatype, distinctions, taken, alike);
  }

  /// The axioms of one repair. Its number, in a mixed base, gives the value of each slot.
  std::vector<Statement> written(std::size_t repair) {
    std::vector<std::map<TermId, TermId>> meanings(ill_typed_.size());
    for (const Slot& slot : slots_) {
      meanings[slot.axiom].emplace(slot.literal, slot.values[repair % slot.values.size()]);
      repair /= slot.values.size();
    }
    std::vector<Statement> statements;
    for (std::size_t axiom = 0; axiom < ill_typed_.size(); ++axiom) {
      const owl::Axiom ill_typed = source_.ill_typed(ill_typed_[axiom]);
      const std::vector<TermId> arguments(ill_typed.arguments.begin(), ill_typed.arguments.end());
      Statement& statement = statements.emplace_back(ill_typed.kind, std::vector<TermId>{});
      for (const TermId id : arguments) statement.arguments.push_back(mended(id, meanings[axiom]));
    }
    return statements;
  }

  /// The term with values in place of its ill-typed literals. Nesting is bounded. The result is remembered, because
  /// another term may contain the term twice.
  TermId mended(TermId id, std::map<TermId, TermId>& meanings) {
    if (source_.is_well_typed(id)) return id;
    if (const auto known = meanings.find(id); known != meanings.end()) return known->second;
    const owl::Term term = source_.term(id);
    const std::vector<TermId> parts(term.arguments.begin(), term.arguments.end());
    std::vector<TermId> arguments;
    arguments.reserve(parts.size());
    for (const TermId part : parts) arguments.push_back(mended(part, meanings));
    const TermId made = source_.term(term.kind, arguments, term.number);
    meanings.emplace(id, made);
    return made;
  }

  owl::Ontology& source_;
  std::span<const std::size_t> ill_typed_;
  DataUses uses_;
  std::vector<Slot> slots_;
  bool are_facts_ = false;                                           ///< all ill-typed axioms are facts
  std::map<std::pair<TermId, TermId>, std::vector<TermId>> values_;  ///< of facts: by property and datatype
};

}  // namespace

std::expected<std::vector<std::vector<Statement>>, std::string> find_repairs(owl::Ontology& source,
                                                                             std::span<const std::uint32_t> premise,
                                                                             std::span<const std::uint32_t> conclusion,
                                                                             std::span<const std::size_t> ill_typed) {
  return Repairs(source, ill_typed).run(premise, conclusion);
}

}  // namespace geminga::reasoner
