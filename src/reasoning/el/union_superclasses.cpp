// The atoms above all parts, part by part.
#include "reasoning/el/union_superclasses.hpp"

#include <optional>

#include "reasoning/el/closure/atoms_above.hpp"

namespace geminga::el {

std::vector<std::pair<ExprId, ExprId>> find_union_superclasses(const IndexedOntology& index,
                                                               const Saturation& saturation, const OpenParts& open) {
  std::vector<std::pair<ExprId, ExprId>> found;
  AtomsAbove above(index, saturation);
  for (const OpenUnion& one : open.unions) {
    if (!one.has_all_parts) continue;
    std::optional<std::vector<ExprId>> shared;
    for (const ExprId part : one.parts) {
      const Context* context = saturation.find(index.representative(part));
      if (context != nullptr && context->is_unsatisfiable) continue;
      const auto of_part = above.gather(part);
      if (!shared) {
        shared.emplace(of_part.begin(), of_part.end());
      } else {
        std::erase_if(*shared, [&](ExprId atom) { return !above.contains(atom); });
      }
    }
    if (!shared) {
      found.emplace_back(one.whole, bottom_expr);
      continue;
    }
    (void)above.gather(one.whole);
    for (const ExprId atom : *shared) {
      if (!above.contains(atom)) found.emplace_back(one.whole, atom);
    }
  }
  return found;
}

}  // namespace geminga::el
