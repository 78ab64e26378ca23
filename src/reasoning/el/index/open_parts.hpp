// Open parts: the parts of axioms that the rules do not use, in a form that a model can be tested for
// (model/model_check.hpp). Legend as in expressions.hpp; X stands for an expression that has no rules.
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
  std::vector<ExprId> parts;  ///< the parts that are atoms
  bool has_all_parts = true;  ///< all parts are atoms
};

/// X < at most `count` R C, or X < at least `count` R C. The filler C is not looked at.
struct OpenCount {
  ExprId whole{};
  RoleId role{};
  std::uint32_t count = 0;
};

/// Links of `role` or a sub-role end in the atom `range`. The rules make it true of the links that are told, but not of
/// those that chains compose.
struct OpenRange {
  RoleId role{};
  ExprId range{};
};

struct OpenParts {
  std::vector<InverseInclusion> inverses;
  std::vector<OpenRange> ranges;
  std::vector<OpenUnion> unions;
  std::vector<OpenCount> at_most;
  std::vector<OpenCount> at_least;
  bool is_mirrored = true;  ///< the mirror images of chains have been told (RoleChains::mirror)
  bool is_more = false;     ///< some part of an axiom that is not used has no form above

  /// Notes that the construct, unless it is none, is not used and has no form above. Returns it.
  owl::Construct beyond(owl::Construct construct) {
    is_more = is_more || construct != owl::Construct::none;
    return construct;
  }
};

}  // namespace geminga::el

#endif
