// Finds equivalent roles, checks regularity and builds the automata.
#include "reasoning/owl/role_box.hpp"

#include <optional>
#include <tuple>

#include "base/sorted.hpp"

namespace geminga::owl {

RoleBox::RoleBox(std::size_t property_count, std::span<const RoleInclusion> inclusions,
                 std::span<const RoleChain> chains, std::size_t max_states) {
  canonical_.resize(property_count * 2);
  find_equivalents(inclusions);
  keep_regular_chains(chains);
  find_composites();
  build_automata(max_states);
  base::sort_unique(left_out_);
}

void RoleBox::find_equivalents(std::span<const RoleInclusion> inclusions) {
  std::vector<std::vector<std::uint32_t>> edges(canonical_.size());
  for (const auto& [sub, super] : inclusions) {
    edges[index(sub)].push_back(static_cast<std::uint32_t>(index(super)));
    edges[index(inverse(sub))].push_back(static_cast<std::uint32_t>(index(inverse(super))));
  }
  const auto components = base::find_components(static_cast<std::uint32_t>(canonical_.size()),
                                                [&](std::uint32_t node) { return std::span(edges[node]); });
  std::vector<std::optional<Role>> first(components.count);
  for (std::size_t at = 0; at < canonical_.size(); ++at) {
    auto& chosen = first[components.component[at]];
    if (!chosen) chosen = role_at(at);
    canonical_[at] = *chosen;
  }
  supers_.resize(canonical_.size());
  subs_.resize(canonical_.size());
  for (std::size_t at = 0; at < canonical_.size(); ++at) {
    for (const std::uint32_t above : edges[at]) {
      const std::size_t sub = index(canonical_[at]);
      const std::size_t super = index(canonical_[above]);
      if (sub == super) continue;
      supers_[sub].push_back(static_cast<std::uint32_t>(super));
      subs_[super].push_back(static_cast<std::uint32_t>(sub));
    }
  }
  for (auto* lists : {&supers_, &subs_}) {
    for (auto& list : *lists) {
      base::sort_unique(list);
    }
  }
}

base::Components RoleBox::components_of_families(std::span<const RoleChain> chains) const {
  std::vector<std::vector<std::uint32_t>> below(canonical_.size());
  for (std::size_t super = 0; super < canonical_.size(); ++super) {
    for (const std::uint32_t sub : subs_[super]) {
      below[family(role_at(super))].push_back(static_cast<std::uint32_t>(family(role_at(sub))));
    }
  }
  for (const RoleChain& chain : chains) {
    for (const Role part : chain.word) {
      below[family(chain.super)].push_back(static_cast<std::uint32_t>(family(part)));
    }
  }
  return base::find_components(static_cast<std::uint32_t>(canonical_.size()),
                               [&](std::uint32_t node) { return std::span(below[node]); });
}

void RoleBox::keep_regular_chains(std::span<const RoleChain> chains) {
  // The chains are regular if the families of roles have an order in which the family of each chain's super-role is
  // above those of its links. So this relation must have no cycle.
  const base::Components all = components_of_families(chains);
  for (const RoleChain& chain : chains) {
    RoleChain kept = chain;
    kept.super = canonical(chain.super);
    for (Role& part : kept.word) part = canonical(part);
    const auto is_of_family = [&](Role part) { return family(part) == family(kept.super); };
    const auto inner = std::span(kept.word).subspan(1, kept.word.size() - 2);
    const bool has_in_the_middle = std::ranges::any_of(inner, is_of_family);
    const bool has_at_both_ends = is_of_family(kept.word.front()) && is_of_family(kept.word.back());
    const bool has_inverse =
        std::ranges::any_of(kept.word, [&](Role part) { return is_of_family(part) && part != kept.super; });
    const bool is_in_cycle = std::ranges::any_of(kept.word, [&](Role part) {
      return !is_of_family(part) && all.component[family(part)] == all.component[family(kept.super)];
    });
    if (has_in_the_middle || has_inverse || is_in_cycle || (has_at_both_ends && kept.word.size() > 2)) {
      left_out_.push_back(chain.axiom);
      continue;
    }
    RoleChain mirrored = kept;
    std::ranges::reverse(mirrored.word);
    for (Role& part : mirrored.word) part = canonical(inverse(part));
    mirrored.super = canonical(inverse(kept.super));
    chains_.push_back(std::move(kept));
    chains_.push_back(std::move(mirrored));
  }
  std::ranges::sort(chains_, {}, [](const RoleChain& chain) { return std::tie(chain.super, chain.word, chain.axiom); });
  const base::Components regular = components_of_families(chains_);
  for (std::size_t at = 0; at < canonical_.size(); ++at) {
    if (canonical_[at] == role_at(at) && family(role_at(at)) == at) family_order_.push_back(at);
  }
  std::ranges::sort(family_order_, {}, [&](std::size_t at) { return std::pair(regular.component[at], at); });
}

void RoleBox::find_composites() {
  is_composite_.assign(canonical_.size(), false);
  std::vector<std::size_t> queue;
  const auto add = [&](std::size_t at) {
    if (is_composite_[at]) return;
    is_composite_[at] = true;
    queue.push_back(at);
  };
  for (const RoleChain& chain : chains_) add(index(chain.super));
  for (std::size_t at = 0; at < queue.size(); ++at) {
    for (const std::uint32_t super : supers_[queue[at]]) add(super);
  }
}

void RoleBox::build_automata(std::size_t max_states) {
  std::vector<std::vector<bool>> supers(canonical_.size());  // of those asked about
  for (const std::size_t at : family_order_) {
    for (const Role role : {role_at(at), canonical(inverse(role_at(at)))}) {
      if (is_simple(role) || automata_.contains(role)) continue;
      Automaton automaton = build(role, max_states);
      if (automaton.state_count() > max_states) {
        // Without its irregular chains a role has only its own edges. Less is derived, and the chains are reported as
        // left out.
        for (const RoleChain& chain : chains_) {
          if (chain.super == role) left_out_.push_back(chain.axiom);
        }
        automaton = Automaton();
        automaton.add_move(Automaton::begin, role, Automaton::end);
      }
      const auto includes = [&](Role first, Role second) {
        std::vector<bool>& found = supers[index(first)];
        if (found.empty()) found = supers_of(first);
        return static_cast<bool>(found[index(second)]);
      };
      automata_.emplace(role, automaton.reduced(includes));
    }
  }
}

std::vector<bool> RoleBox::supers_of(Role role) const {
  std::vector<bool> result(canonical_.size(), false);
  std::vector<std::size_t> queue = {index(role)};
  result[index(role)] = true;
  for (std::size_t at = 0; at < queue.size(); ++at) {
    for (const std::uint32_t super : supers_[queue[at]]) {
      if (!result[super]) queue.push_back(super);
      result[super] = true;
    }
  }
  return result;
}

Automaton RoleBox::build(Role role, std::size_t max_states) const {
  Automaton automaton;
  automaton.add_move(Automaton::begin, role, Automaton::end);
  // Clauses make the edges of simple sub-properties edges of this role. The paths of the others are added here.
  for (const std::uint32_t sub : subs_[index(role)]) {
    if (!is_composite_[sub] || automaton.state_count() > max_states) continue;
    automaton.add_copy(Automaton::begin, automata_.at(role_at(sub)), Automaton::end);
  }
  for (const RoleChain& chain : chains_) {
    if (chain.super == role && automaton.state_count() <= max_states)
      add_chain(automaton, role, chain.word, max_states);
  }
  return automaton;
}

void RoleBox::add_chain(Automaton& automaton, Role role, std::span<const Role> word, std::size_t max_states) const {
  //   R o R -> R        the end leads back to the beginning
  //   R o S.. -> R      S.. loops at the end
  //   S.. o R -> R      S.. loops at the beginning
  //   S.. -> R          S.. leads from the beginning to the end
  if (word.size() == 2 && word[0] == role && word[1] == role) {
    automaton.add_empty_move(Automaton::end, Automaton::begin);
    return;
  }
  Automaton::State from = Automaton::begin;
  Automaton::State to = Automaton::end;
  if (word.front() == role) {
    word = word.subspan(1);
    from = Automaton::end;
  } else if (word.back() == role) {
    word = word.first(word.size() - 1);
    to = Automaton::begin;
  }
  for (std::size_t at = 0; at < word.size() && automaton.state_count() <= max_states; ++at) {
    const Automaton::State next = at + 1 == word.size() ? to : automaton.add_state();
    if (is_simple(word[at])) {
      automaton.add_move(from, word[at], next);
    } else {
      automaton.add_copy(from, automata_.at(word[at]), next);
    }
    from = next;
  }
}

}  // namespace geminga::owl
