// The uses of expressions that can be judged only when all axioms are known.
#ifndef GEMINGA_REASONING_EL_NORMALISER_PENDING_USES_HPP
#define GEMINGA_REASONING_EL_NORMALISER_PENDING_USES_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/owl/construct.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// Axioms that are not used in full, each with the construct that has no rules.
using UnusedAxioms = std::vector<std::pair<std::uint32_t, owl::Construct>>;

/// The first of two constructs that is not used.
[[nodiscard]] constexpr owl::Construct first_unused(owl::Construct one, owl::Construct other) {
  return one != owl::Construct::none ? one : other;
}

/// The side of SubClassOf on which a term stands.
enum class Side : std::uint8_t { left, right };

/// A property that must be simple. If it is not, `construct` is not used in full.
struct SimpleUse {
  RoleId role{};
  owl::Construct construct = owl::Construct::none;
};

/// A universal, by its number among those of UniversalNormaliser.
struct UniversalUse {
  std::size_t universal = 0;
};

/// A datatype of which nothing is known, that values are said to be in.
struct OpaqueUse {
  owl::NameId datatype{};
};

struct PendingUse {
  /// A datatype that values are said to be in, one of which nothing is known, the family of a literal whose value is
  /// not exact, a property that must be simple, or a universal.
  using What = std::variant<owl::Datatype, owl::DataFamily, SimpleUse, UniversalUse, OpaqueUse>;

  std::uint32_t axiom = 0;
  What what;
};

/// Keeps each use with its axiom. The rules of a term are made once, but each axiom that holds the term has its uses.
class PendingUses {
 public:
  /// Makes this axiom the current one, to which the next notes belong.
  void begin(std::uint32_t axiom) { axiom_ = axiom; }
  [[nodiscard]] std::uint32_t axiom() const { return axiom_; }

  void note(const PendingUse::What& what) { uses_.push_back({axiom_, what}); }
  [[nodiscard]] std::span<const PendingUse> all() const { return uses_; }

  /// Keeps the uses from number `begin` on as those of the term on this side.
  void keep(owl::TermId term, Side side, std::size_t begin) {
    if (uses_.size() != begin) uses_of_term_[{term, side}] = {begin, uses_.size(), axiom_};
  }
  /// Notes the uses of the term again, for the current axiom.
  void repeat(owl::TermId term, Side side) {
    if (uses_of_term_.empty()) return;
    const auto found = uses_of_term_.find({term, side});
    if (found == uses_of_term_.end() || found->second.axiom == axiom_) return;  // once for each axiom
    found->second.axiom = axiom_;
    for (std::size_t at = found->second.begin; at < found->second.end; ++at) note(PendingUse(uses_[at]).what);
  }

 private:
  /// A range of uses_, and the axiom for which they were noted last.
  struct TermUses {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::uint32_t axiom = 0;
  };

  std::uint32_t axiom_ = 0;
  std::vector<PendingUse> uses_;
  std::map<std::pair<owl::TermId, Side>, TermUses> uses_of_term_;
};

}  // namespace geminga::el

#endif
