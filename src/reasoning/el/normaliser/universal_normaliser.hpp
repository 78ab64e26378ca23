// Universals right of SubClassOf, and the ranges that OWL 2 EL does not allow. Legend as in expressions.hpp.
//
// A range of R is a universal of everything, T < R only C. If the last property of each chain below R has the range,
// too (OWL 2 profiles, section 2.2.6), it is enough that the fillers of existentials are in C (Baader, Brandt, Lutz:
// Pushing the EL Envelope Further, 2008). Otherwise the end of a chain is in C only after the rest of the chain. So C
// travels along the automaton of R, whose states are atoms (Horrocks, Kutz, Sattler: The Even More Irresistible SROIQ,
// 2006, section 4). Universals of properties with chains travel the same way.
#ifndef GEMINGA_REASONING_EL_NORMALISER_UNIVERSAL_NORMALISER_HPP
#define GEMINGA_REASONING_EL_NORMALISER_UNIVERSAL_NORMALISER_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/normaliser/pending_uses.hpp"
#include "reasoning/el/normaliser/property_roles.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::el {

/// Says whether the index gets universals, which only a saturation has rules for.
enum class Universals : std::uint8_t {
  left_out,
  used,
  tested,  ///< as used; but if nothing else needs universals, ranges of chains become open parts without rules
};

/// Collects universals and ranges, and makes rules of them when all chains are known.
class UniversalNormaliser {
 public:
  UniversalNormaliser(IndexBuilder& index, PendingUses& pending, OpenParts& open)
      : index_(index), pending_(pending), open_(open) {}

  /// Adds `restricting` < property only filler. Requires a property that is no inverse.
  void add_universal(ExprId restricting, const Property& property, ExprId filler);
  /// Adds a range of the current axiom.
  void add_range(RoleId role, ExprId range);
  [[nodiscard]] bool has_universals() const { return !universals_.empty(); }

  /// Makes the rules, and adds the axioms whose universals are not used to `unused`. Requires roles whose hierarchy is
  /// closed, and the told chains. To be called once, after the last axiom.
  void finish(const Roles& closed, std::span<const owl::RoleChain> chains, Universals universals, UnusedAxioms& unused);
  /// The axioms of which a part became a universal rule, ascending. Requires finish().
  [[nodiscard]] const UnusedAxioms& uses() const { return uses_; }

 private:
  struct Range {
    std::uint32_t axiom = 0;
    RoleId role{};
    ExprId range{};
  };
  struct Universal {
    ExprId restricting{};
    Property property;
    ExprId filler{};
  };

  [[nodiscard]] std::vector<std::size_t> find_ranges_over_chains(const Roles& closed) const;
  void leave_out(std::span<const std::size_t> over_chains, UnusedAxioms& unused) const;
  void leave_ranges_open(std::span<const std::size_t> ranges);
  void make_universal(const Universal& universal, const owl::RoleBox& box);
  void make_range_over_chains(RoleId role, std::span<const ExprId> ranges, const owl::RoleBox& box);

  IndexBuilder& index_;
  PendingUses& pending_;
  OpenParts& open_;
  std::vector<Range> ranges_;
  std::vector<Universal> universals_;
  UnusedAxioms uses_;
};

}  // namespace geminga::el

#endif
