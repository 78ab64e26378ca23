// Atoms for expressions that have no rules.
#ifndef GEMINGA_REASONING_EL_NORMALISER_OPAQUE_ATOMS_HPP
#define GEMINGA_REASONING_EL_NORMALISER_OPAQUE_ATOMS_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "base/interner.hpp"
#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// Gives equal expressions without rules one atom, so that an expression is at least equal to itself.
class OpaqueAtoms {
 public:
  explicit OpaqueAtoms(IndexBuilder& index) : index_(index) {}

  /// The atom of the expression with this kind, count and operands, which `key` lists in the order of the kind.
  ExprId find(owl::TermKind kind, std::uint32_t count, std::vector<std::uint32_t> key);

 private:
  IndexBuilder& index_;
  std::vector<std::uint32_t> keys_;                             ///< all keys in a row
  std::vector<std::pair<std::uint32_t, std::uint32_t>> spans_;  ///< by entry: where its key begins, and its length
  std::vector<ExprId> atoms_;                                   ///< by entry
  base::NumberTable table_;                                     ///< entries by key
};

}  // namespace geminga::el

#endif
