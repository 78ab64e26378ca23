// What the rules do not use of the axioms, in a form that a model can be tested for.
//
// The contexts of a saturation are a model of what the rules use. Where they are a model of the rest, too, nothing is
// missing (settlement.hpp). Legend as in indexed_ontology.hpp; X stands for an expression that has no rules.
#ifndef GEMINGA_REASONING_EL_INDEX_OPEN_PARTS_HPP
#define GEMINGA_REASONING_EL_INDEX_OPEN_PARTS_HPP

#include <cstdint>
#include <vector>

#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/owl/construct.hpp"

namespace geminga::el {

/// sub(x, y) says super(y, x).
struct InverseInclusion {
  RoleId sub{};
  RoleId super{};
};

/// X < C or D ...
struct OpenUnion {
  ExprId whole{};
  std::vector<ExprId> parts;  ///< those that are atoms
  bool has_all_parts = true;  ///< all are
};

/// X < at most `count` R C, or X < at least `count` R C, of which C is not looked at.
struct OpenCount {
  ExprId whole{};
  RoleId role{};
  std::uint32_t count = 0;
};

struct OpenParts {
  std::vector<InverseInclusion> inverses;
  std::vector<OpenUnion> unions;
  std::vector<OpenCount> at_most;
  std::vector<OpenCount> at_least;
  bool is_mirrored = true;  ///< what inverses say of chains has been told of the properties themselves
  bool is_more = false;     ///< something else is not used, which has no form above

  /// Notes that the construct, if there is one, is not used and has no form above. Returns it.
  owl::Construct beyond(owl::Construct construct) {
    is_more = is_more || construct != owl::Construct::none;
    return construct;
  }
};

}  // namespace geminga::el

#endif
