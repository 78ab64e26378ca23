// From the heads of clauses to choices.
#include "reasoning/dl/hypertableau/facts/choice.hpp"

namespace geminga::hypertableau {

using clauses::AtomKind;

Choice choice_of(const Program& program, const clauses::Atom& atom, NodeId a, NodeId b) {
  switch (atom.kind) {
    case AtomKind::concept_of:
      return {ChoiceKind::concept_of, atom.predicate, a, a};
    case AtomKind::role:
      return {ChoiceKind::role, atom.predicate, a, b};
    case AtomKind::data_range:
      return {ChoiceKind::data_range, atom.predicate, a, a};
    case AtomKind::at_least:
      return {ChoiceKind::at_least, atom.predicate, a, a};
    case AtomKind::data_at_least:
      return {ChoiceKind::data_at_least, atom.predicate, a, a};
    case AtomKind::at_most:
    case AtomKind::data_at_most:
      return {ChoiceKind::at_most, program.bound_of_atom(atom), a, a};
    case AtomKind::data_role:
      return {ChoiceKind::data_role, atom.predicate, a, b};
    case AtomKind::equal:
    case AtomKind::data_equal:
      break;
  }
  return {ChoiceKind::equal, 0, a, b};
}

}  // namespace geminga::hypertableau
