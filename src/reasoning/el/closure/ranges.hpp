// The ranges that chains may break: does a closure that has no rules for them satisfy them all the same?
//
// A closure by inheritance is a model: its elements are the nodes that may have an instance, and S leads from x to N if
// the node `R some N` with R <* S is above x (Kazakov, Kroetzsch, Simancik: The Incredible ELK, 2014). It satisfies all
// axioms that have rules, but may miss the range C of S at N. So N gets a second node, which is below N and all such C,
// and each `R some N` leads there instead. If this tells `R some N` nothing that it has not known, the changed model is
// one of the ranges, too, and says the same of all classes: nothing else follows. The proof is in ../README.md.
#ifndef GEMINGA_REASONING_EL_CLOSURE_RANGES_HPP
#define GEMINGA_REASONING_EL_CLOSURE_RANGES_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/rows.hpp"
#include "reasoning/el/closure/inheritance_worker.hpp"
#include "reasoning/el/index/open_parts.hpp"

namespace geminga::el {

/// Makes the links of a finished and consistent closure end in their ranges. What the nodes hold is of no use after it.
class RangeTest {
 public:
  RangeTest(SharedNodes& shared, InheritanceWorker& worker, std::span<const OpenRange> ranges);

  /// True if all links end in their ranges and nothing new followed for an atom. False says only that rules are needed,
  /// or that a limit was passed. The cost is about that of closing the ends outside their ranges and all that is above
  /// them.
  [[nodiscard]] bool passes();

 private:
  /// The end of links: a node, and the ranges that are not above it.
  struct End {
    std::vector<std::uint32_t> links;  ///< nodes of existentials
    std::vector<ExprId> ranges;
    std::size_t links_narrowed = 0;
    std::uint32_t narrowed = no_node;  ///< the node below this one and all `ranges`
  };
  /// The sizes of an existential's node before it was narrowed.
  struct Known {
    std::uint32_t link = 0;
    std::uint32_t items = 0;
    std::uint32_t above = 0;
  };

  void reach(std::uint32_t node);
  void find_links();
  bool narrow_ends();
  [[nodiscard]] std::vector<ExprId> missing_ranges(std::uint32_t at, const End& end);
  void find_above(std::uint32_t node);
  void narrow(std::uint32_t at, End& end, std::span<const ExprId> missing);
  bool take_news();
  [[nodiscard]] std::uint32_t vertex_of(std::uint32_t node) const;
  [[nodiscard]] base::Rows<std::uint32_t> find_below() const;
  [[nodiscard]] bool is_news_harmless() const;

  SharedNodes& shared_;
  NodeStore& nodes_;
  InheritanceWorker& worker_;
  const IndexedOntology& index_;
  std::vector<std::vector<ExprId>> ranges_of_;  ///< by role
  std::map<std::uint32_t, End> ends_;           ///< by node
  std::vector<bool> is_reached_;                ///< by node: some element is below it
  std::vector<std::uint32_t> reached_;          ///< of these, those that find_links() has not looked at
  std::vector<Known> known_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> news_;  ///< new items, each with the links that heard of it
  std::vector<std::uint32_t> seen_for_;  ///< by expression, and behind them by node: the last search that saw it
  std::uint32_t search_ = 0;
};

}  // namespace geminga::el

#endif
