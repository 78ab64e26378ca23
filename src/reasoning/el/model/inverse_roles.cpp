// Each link has letters along it and against it; the automaton of a role says which words go along and against links.
#include "reasoning/el/model/inverse_roles.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::el {
namespace {

constexpr std::size_t max_states = 200;                          // of an automaton
constexpr std::size_t max_inverse_pairs = std::size_t{1} << 22;  // of roles that are asked for and roles of links

owl::Role role_of(RoleId role, bool is_inverse) {
  return {owl::PropertyId{static_cast<std::uint32_t>(role)}, is_inverse};
}

/// The states whose moves are all moves of the beginning, too: the rest of a word from there is a word of its own, or
/// nothing is left.
std::vector<bool> find_beginnings(const owl::Automaton& automaton) {
  std::vector<bool> found(automaton.state_count(), true);
  for (const owl::Automaton::Move& move : automaton.moves()) {
    if (move.from == owl::Automaton::begin) continue;
    if (!std::ranges::binary_search(automaton.moves(),
                                    owl::Automaton::Move{owl::Automaton::begin, move.label, move.to}))
      found[move.from] = false;
  }
  return found;
}

}  // namespace

InverseRoles::InverseRoles(const IndexedOntology& index, std::span<const InverseInclusion> inverses)
    : index_(index),
      implied_(find_implied_roles(index.roles(), inverses)),
      learning_(index.roles().count()),
      tells_end_(index.roles().count(), false),
      hands_on_(index.roles().count(), HandsOn::nothing),
      is_known_(index.roles().count(), true),
      ranges_(index.roles().count()) {
  if (inverses.empty()) return;
  const Roles& roles = index.roles();
  std::vector<owl::RoleInclusion> inclusions;
  for (const auto& [sub, super] : roles.told_supers())
    inclusions.push_back({role_of(RoleId{sub}, false), role_of(super, false)});
  for (const InverseInclusion& told : inverses)
    inclusions.push_back({role_of(told.sub, false), role_of(told.super, true)});
  std::vector<owl::RoleChain> chains;
  for (const Roles::Chain& chain : roles.chains()) {
    chains.push_back({{role_of(chain.first, false), role_of(chain.second, false)},
                      role_of(chain.result, false),
                      static_cast<std::uint32_t>(chains.size())});
  }
  const owl::RoleBox box(roles.count(), inclusions, chains, max_states);
  if (!box.left_out().empty()) {
    is_known_.assign(roles.count(), false);
    return;
  }
  forward_.resize(roles.count());
  backward_.resize(roles.count());
  for (std::uint32_t link = 0; link < roles.count(); ++link) {
    const auto add = [&](RoleId role, bool is_backward) {
      forward_[link].push_back(box.canonical(role_of(role, is_backward)));
      backward_[link].push_back(box.canonical(role_of(role, !is_backward)));
    };
    for (const RoleId super : roles.supers(RoleId{link})) add(super, false);
    for (const ImpliedRole& implied : implied_[link]) add(implied.role, implied.is_backward);
    base::sort_unique(forward_[link]);
    base::sort_unique(backward_[link]);
  }
  std::vector<bool> is_recognised(roles.count(), false);
  for (std::uint32_t id = 0; id < index.size(); ++id) {
    for (const ExistentialRule& rule : index.existentials(ExprId{id}))
      is_recognised[static_cast<std::size_t>(rule.role)] = true;
  }
  std::size_t pairs = 0;
  for (std::uint32_t heard = 0; heard < roles.count(); ++heard) {
    if (!is_recognised[heard] && index.range_of(RoleId{heard}) == top_expr) continue;
    const owl::Role role = box.canonical(role_of(RoleId{heard}, false));
    owl::Automaton one_link;
    one_link.add_move(owl::Automaton::begin, role, owl::Automaton::end);
    pairs += roles.count();
    if (pairs > max_inverse_pairs) {
      is_known_.assign(roles.count(), false);
      return;
    }
    learn(RoleId{heard}, box.is_simple(role) ? one_link : box.automaton(role), is_recognised[heard], box);
  }
}

// Every element is in T, so that the end of a link learns `S some T` by its filler wherever it could be handed on.
bool InverseRoles::hands_on(ExprId existential) const {
  const Expr& known = index_.expr(existential);
  switch (hands_on_[known.first]) {
    case HandsOn::nothing:
      return false;
    case HandsOn::also_told:
      return index_.representative(ExprId{known.second}) != index_.representative(top_expr);
    case HandsOn::only_further:
      break;
  }
  return true;
}

void InverseRoles::learn(RoleId heard, const owl::Automaton& automaton, bool is_existential, const owl::RoleBox& box) {
  for (std::uint32_t link = 0; link < learning_.size(); ++link) learn(RoleId{link}, heard, automaton, is_existential);
  const std::vector<bool> begins = find_beginnings(automaton);
  const auto goes_back = [&](const owl::Automaton::Move& move) {
    return begins[move.from] && std::ranges::any_of(backward_, [&](const std::vector<owl::Role>& letters) {
             return std::ranges::binary_search(letters, move.label);
           });
  };
  if (index_.range_of(heard) == top_expr || std::ranges::none_of(automaton.moves(), goes_back)) return;
  // A word that begins with a step back may end with any last letter, so each last letter must imply the range.
  for (const owl::Automaton::Move& move : automaton.moves()) {
    if (!automaton.is_final(move.to)) continue;
    for (std::uint32_t link = 0; link < learning_.size(); ++link) {
      const bool is_last = std::ranges::binary_search(forward_[link], move.label);
      if (is_last && !index_.roles().is_sub_role(RoleId{link}, heard) &&
          !std::ranges::binary_search(forward_[link], box.canonical(role_of(heard, false))))
        is_known_.assign(is_known_.size(), false);
    }
  }
}

//  A walk along a word of S comes from y to x by the inverse of the link, and from x to y by the link.
void InverseRoles::learn(RoleId link, RoleId heard, const owl::Automaton& automaton, bool is_existential) {
  const auto at = static_cast<std::size_t>(link);
  const auto& moves = automaton.moves();
  const std::vector<bool> begins = find_beginnings(automaton);
  const auto is_letter = [](const std::vector<owl::Role>& letters, owl::Role label) {
    return std::ranges::binary_search(letters, label);
  };
  const auto has_moves = [&](owl::Automaton::State state) {
    return std::ranges::any_of(moves, [&](const owl::Automaton::Move& move) { return move.from == state; });
  };
  Learning found{.role = heard};
  for (const owl::Automaton::Move& move : moves) {
    if (is_letter(backward_[at], move.label)) {
      // A walk must not go along the link and back by the same link.
      const bool comes_back = std::ranges::any_of(moves, [&](const owl::Automaton::Move& before) {
        return before.to == move.from && is_letter(forward_[at], before.label);
      });
      // The rest of a word after a step back must be a word again, which an expression stands for. A state in y that is
      // no beginning is never reached, because no walk leads into it by this link.
      const bool is_lost = begins[move.from] && !begins[move.to];
      if (comes_back || is_lost) is_known_[at] = false;
      if (begins[move.from]) {
        found.filler = found.filler || automaton.is_final(move.to);
        // The rest must be any word of S, not one of some words only.
        if (move.to != owl::Automaton::begin && has_moves(move.to)) is_known_[at] = false;
        found.further = found.further || move.to == owl::Automaton::begin;
        if (automaton.is_final(move.to)) ranges_[at].push_back(heard);
      }
    }
    if (is_letter(forward_[at], move.label) && begins[move.from]) {
      found.recognises = found.recognises || automaton.is_final(move.to);
      found.carries = found.carries || move.to == owl::Automaton::begin;
    }
  }
  base::sort_unique(ranges_[at]);
  if (!is_existential) return;
  tells_end_[at] = tells_end_[at] || found.filler || found.further;
  HandsOn& hands_on = hands_on_[static_cast<std::size_t>(heard)];
  if (found.further) hands_on = std::max(hands_on, found.filler ? HandsOn::also_told : HandsOn::only_further);
  if (found.filler || found.further || found.recognises || found.carries) learning_[at].push_back(found);
}

}  // namespace geminga::el
