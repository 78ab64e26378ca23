// Choices: facts and equalities that may be made true, alone or as one of several alternatives.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_CHOICE_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_CHOICE_HPP

#include <cstdint>
#include <vector>

#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// One thing that may be made true.
enum class ChoiceKind : std::uint8_t {
  concept_of,
  role,
  data_role,
  equal,
  at_least,
  at_most,
  data_range,
  data_at_least,
  introduce,  ///< NI rule: a is the individual number `predicate` of those that bound `bound` allows b
  // How the at-least `predicate` of a is satisfied, the existential number `bound`. One of the two always succeeds if
  // there is a model: the second.
  share_neighbours,  ///< neighbours that are there, and differ, are among those that it asks for
  make_neighbours,   ///< all that are not known to be are made
};
/// Whether Expansion offers such choices.
[[nodiscard]] constexpr bool is_of_expansion(ChoiceKind kind) {
  return kind == ChoiceKind::share_neighbours || kind == ChoiceKind::make_neighbours;
}
struct Choice {
  ChoiceKind kind = ChoiceKind::concept_of;
  std::uint32_t predicate = 0;
  NodeId a = 0;
  NodeId b = 0;
  std::uint32_t bound = 0;
  bool meets_neighbour = false;  ///< Neighbours::meets() when it was offered
  bool crowds = false;           ///< Neighbours::crowds() when it was offered
};

/// The choice that a clause's head atom stands for, with these nodes for its variables.
[[nodiscard]] Choice choice_of(const Program& program, const clauses::Atom& atom, NodeId a, NodeId b);

/// A bound that a node may exceed.
struct Suspect {
  NodeId node = none;
  std::uint32_t bound = none;
};

/// Two or more alternatives, one of which must hold.
struct Decision {
  std::vector<Choice> alternatives;
  DependencySet dependency = no_dependency;
  Suspect suspect;  ///< to be checked again after each alternative
};

}  // namespace geminga::hypertableau

#endif
