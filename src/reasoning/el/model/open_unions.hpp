// The contexts that are in a union and known to be in none of its parts, and the parts that the model may choose.
#ifndef GEMINGA_REASONING_EL_MODEL_OPEN_UNIONS_HPP
#define GEMINGA_REASONING_EL_MODEL_OPEN_UNIONS_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/rows.hpp"
#include "reasoning/el/closure/atoms_above.hpp"
#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/model/element_test.hpp"
#include "reasoning/el/model/failing_contexts.hpp"

namespace geminga::el {

/// If x is in A or B but known in neither, the model may put x in either part that lies below all other subsumers of x
/// (Lemma 3). For a successor, one part suffices that tells its source nothing new. For a class, an atom that is not
/// above all such parts is not above the class (Lemma 4).
class OpenUnions {
 public:
  OpenUnions(const IndexedOntology& index, const Saturation& saturation, const OpenParts& open,
             std::span<const ExprId> classes);

  /// True if the context is in a union and in none of its parts.
  [[nodiscard]] bool is_open(std::uint32_t context) const { return union_of_[context] != none; }
  /// True if the expression is told to be in a union.
  [[nodiscard]] bool is_whole(ExprId expr) const { return !unions_of_[number(expr)].empty(); }
  /// Lemma 3: whether a link to an open context may lead to a part instead. `from` is the source with the role.
  [[nodiscard]] bool can_lead_to_a_part(ElementTest& test, const HeardRoles& heard, const FailingContexts& failing,
                                        Link from, std::uint32_t context) {
    return can_lead_to_a_part(test, heard, failing, from, context, 0);
  }
  /// Lemma 4: whether all classes above a context are known. Requires that `failing` does not change from then on.
  [[nodiscard]] bool is_settled(const FailingContexts& failing, std::uint32_t context) {
    return is_settled(failing, context, 0);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  void index_unions(const OpenParts& open);
  void find_plain(const OpenParts& open);
  [[nodiscard]] std::uint32_t find_union(std::uint32_t context) const;
  [[nodiscard]] bool may_be(const FailingContexts& failing, std::uint32_t context, std::uint32_t part);
  template <typename Visit>
  bool visit_parts(const FailingContexts& failing, std::uint32_t context, Visit&& visit);
  [[nodiscard]] bool can_lead_to_a_part(ElementTest& test, const HeardRoles& heard, const FailingContexts& failing,
                                        Link from, std::uint32_t context, unsigned depth);
  [[nodiscard]] bool is_settled(const FailingContexts& failing, std::uint32_t context, unsigned depth);
  [[nodiscard]] bool has_nothing_more(const FailingContexts& failing, std::uint32_t context, unsigned depth);

  const IndexedOntology& index_;
  const Saturation& saturation_;
  std::vector<std::vector<std::uint32_t>> parts_of_;  ///< by union: the representatives of its parts, ascending
  base::Rows<std::uint32_t> unions_of_;               ///< by expression: the unions that it is told to be in
  std::vector<bool> is_plain_;           ///< by expression: nothing follows from it but what is told to be above it
  std::vector<std::uint32_t> union_of_;  ///< by context: the first open union
  enum class Answer : std::uint8_t { unknown, busy, open, settled };
  std::vector<Answer> answers_;  ///< by context
  std::vector<bool> is_class_;   ///< by atom
  AtomsAbove above_;
  std::size_t steps_ = 0;
};

}  // namespace geminga::el

#endif
