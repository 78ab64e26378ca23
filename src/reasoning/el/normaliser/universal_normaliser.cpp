// Universals as rules: one for a simple role, and else one for each move of the role's automaton.
#include "reasoning/el/normaliser/universal_normaliser.hpp"

#include <algorithm>
#include <map>
#include <variant>

namespace geminga::el {
namespace {

constexpr std::size_t max_automaton_states = 1000;  // of one property

/// The roles whose automata are incomplete, because a chain below them is not regular or one of too many.
std::vector<bool> find_partial(const Roles& closed, const owl::RoleBox& box, std::span<const owl::RoleChain> chains) {
  std::vector<bool> is_partial(closed.count(), false);
  const auto touch = [&](owl::Role role) {
    bool is_new = false;
    for (const RoleId super : closed.supers(RoleId{static_cast<std::uint32_t>(role.property)})) {
      is_new = is_new || !is_partial[static_cast<std::size_t>(super)];
      is_partial[static_cast<std::size_t>(super)] = true;
    }
    return is_new;
  };
  for (const std::uint32_t chain : box.left_out()) touch(chains[chain].super);
  const auto has_partial = [&](const owl::RoleChain& chain) {
    return std::ranges::any_of(chain.word,
                               [&](owl::Role part) { return is_partial[static_cast<std::size_t>(part.property)]; });
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (const owl::RoleChain& chain : chains) changed = (has_partial(chain) && touch(chain.super)) || changed;
  }
  return is_partial;
}

RoleId label_of(const owl::Automaton::Move& move) { return RoleId{static_cast<std::uint32_t>(move.label.property)}; }

}  // namespace

void UniversalNormaliser::add_universal(ExprId restricting, const Property& property, ExprId filler) {
  pending_.note(UniversalUse{universals_.size()});
  universals_.push_back({restricting, property, filler});
}

void UniversalNormaliser::add_range(RoleId role, ExprId range) { ranges_.push_back({pending_.axiom(), role, range}); }

// Finds the ranges that the last property of some chain below their property does not have.
std::vector<std::size_t> UniversalNormaliser::find_ranges_over_chains(const Roles& closed) const {
  std::vector<std::size_t> found;
  for (std::size_t at = 0; at < ranges_.size(); ++at) {
    const Range& range = ranges_[at];
    const auto escapes = [&](const Roles::Chain& chain) {
      if (!closed.is_sub_role(chain.result, range.role) || closed.is_sub_role(chain.second, range.role)) return false;
      return std::ranges::none_of(ranges_, [&](const Range& other) {
        return other.range == range.range && closed.is_sub_role(chain.second, other.role);
      });
    };
    if (std::ranges::any_of(closed.chains(), escapes)) found.push_back(at);
  }
  return found;
}

// Without the automata, which a question about a few axioms would take longer to make than to answer.
void UniversalNormaliser::leave_out(std::span<const std::size_t> over_chains, UnusedAxioms& unused) const {
  for (const std::size_t at : over_chains) unused.emplace_back(ranges_[at].axiom, owl::Construct::range_over_chain);
  for (const PendingUse& pending : pending_.all()) {
    if (std::holds_alternative<UniversalUse>(pending.what))
      unused.emplace_back(pending.axiom, owl::Construct::all_values_from);
  }
}

void UniversalNormaliser::leave_ranges_open(std::span<const std::size_t> ranges) {
  for (const std::size_t at : ranges) {
    open_.ranges.push_back({ranges_[at].role, ranges_[at].range});
    // So that a link with the range does not end in a context without it.
    index_.watch(ranges_[at].range);
  }
}

void UniversalNormaliser::finish(const Roles& closed, std::span<const owl::RoleChain> chains, Universals universals,
                                 UnusedAxioms& unused) {
  const std::vector<std::size_t> over_chains = find_ranges_over_chains(closed);
  if (over_chains.empty() && universals_.empty()) return;
  if (universals == Universals::left_out) return leave_out(over_chains, unused);
  const auto is_of_atom = [&](std::size_t at) { return index_.is_atom(ranges_[at].range); };
  if (universals == Universals::tested && universals_.empty() && std::ranges::all_of(over_chains, is_of_atom))
    return leave_ranges_open(over_chains);
  std::vector<owl::RoleInclusion> inclusions;
  for (const auto& [sub, super] : closed.told_supers()) inclusions.push_back({role_of(RoleId{sub}), role_of(super)});
  const owl::RoleBox box(closed.count(), inclusions, chains, max_automaton_states);
  const std::vector<bool> is_partial = find_partial(closed, box, chains);
  const auto can_use = [&](RoleId role) { return !is_partial[static_cast<std::size_t>(role)]; };

  std::map<RoleId, std::vector<ExprId>> ranges_of;
  for (const std::size_t at : over_chains) {
    const Range& range = ranges_[at];
    const bool is_used = can_use(range.role);
    if (is_used) ranges_of[range.role].push_back(range.range);
    (is_used ? uses_ : unused).emplace_back(range.axiom, owl::Construct::range_over_chain);
  }
  for (const auto& [role, ranges] : ranges_of) make_range_over_chains(role, ranges, box);
  for (const Universal& universal : universals_) {
    if (can_use(universal.property.role)) make_universal(universal, box);
  }
  for (const PendingUse& pending : pending_.all()) {
    const auto* use = std::get_if<UniversalUse>(&pending.what);
    if (use == nullptr) continue;
    const bool is_used = can_use(universals_[use->universal].property.role);
    (is_used ? uses_ : unused).emplace_back(pending.axiom, owl::Construct::all_values_from);
  }
  std::ranges::sort(uses_);
}

//  Q < R only C  is  Q < S only Q'  for each move S of the automaton of R from its first state to Q', the same for its
//  other states, and Q'' < C for the final ones
void UniversalNormaliser::make_universal(const Universal& universal, const owl::RoleBox& box) {
  const auto& [restricting, property, filler] = universal;
  const owl::Role role = role_of(property.role);
  if (property.is_data || box.is_simple(role)) {
    // A conclusion about values must not reach other elements of the same atom.
    const ExprId target = property.is_data ? index_.add_atom() : filler;
    if (property.is_data) index_.add_told(target, filler);
    index_.add_universal(restricting, property.role, target);
    return;
  }
  const owl::Automaton& automaton = box.automaton(box.canonical(role));
  std::vector<ExprId> states(automaton.state_count(), restricting);
  for (owl::Automaton::State state = 0; state < automaton.state_count(); ++state) {
    if (state != owl::Automaton::begin) states[state] = index_.add_atom();
    if (automaton.is_final(state)) index_.add_told(states[state], filler);
  }
  for (const owl::Automaton::Move& move : automaton.moves()) {
    index_.add_universal(states[move.from], label_of(move), states[move.to]);
  }
}

//  T < R only C  is the same with T as the first state, of which Q < S only Q' is the range Q' of S
void UniversalNormaliser::make_range_over_chains(RoleId role, std::span<const ExprId> ranges, const owl::RoleBox& box) {
  const owl::Automaton& automaton = box.automaton(box.canonical(role_of(role)));
  std::vector<ExprId> states(automaton.state_count(), top_expr);
  for (owl::Automaton::State state = 0; state < automaton.state_count(); ++state) {
    if (state == owl::Automaton::begin) continue;
    states[state] = index_.add_atom();
    if (!automaton.is_final(state)) continue;
    for (const ExprId range : ranges) index_.add_told(states[state], range);
  }
  for (const owl::Automaton::Move& move : automaton.moves()) {
    if (move.to == owl::Automaton::begin) continue;
    if (move.from == owl::Automaton::begin) {
      index_.add_told(index_.range_atom(label_of(move)), states[move.to]);
    } else {
      index_.add_universal(states[move.from], label_of(move), states[move.to]);
    }
  }
}

}  // namespace geminga::el
