// The facts of the model under construction, against a plain list of them.
#include "reasoning/dl/hypertableau/graph/graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace geminga::hypertableau {
namespace {

bool is_found(const Graph& graph, const Fact& fact) {
  return graph.find(fact.kind, fact.predicate, fact.a, fact.b) != none;
}

TEST(LabelFilter, AnswersForMostAbsentConceptsBesideFortyAndForgetsThem) {
  LabelFilter filter;
  for (std::uint32_t of = 0; of < 40; ++of) filter.add_concept(1000 + 7 * of);
  std::uint32_t claimed = 0;
  for (std::uint32_t of = 0; of < 40; ++of) EXPECT_TRUE(filter.may_have_concept(1000 + 7 * of));
  for (std::uint32_t of = 5000; of < 6000; ++of) claimed += filter.may_have_concept(of) ? 1 : 0;
  EXPECT_LT(claimed, 300U);
  filter.forget_concepts();
  for (std::uint32_t of = 0; of < 40; ++of) EXPECT_FALSE(filter.may_have_concept(1000 + 7 * of));
}

// Branches are taken back over and over, so that filters are made again.
TEST(Graph, FindsExactlyTheFactsThatAreThereAfterAnyCuts) {
  constexpr std::uint32_t predicates = 400;
  std::mt19937 random(26);
  const auto below = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(random() % bound); };
  Graph graph(std::vector<bool>(std::size_t{2} * predicates, false));
  std::vector<Fact> there;
  std::vector<Mark> marks = {graph.mark()};
  for (int step = 0; step < 4000; ++step) {
    if (graph.node_count() == 0 || below(50) == 0) graph.add_node(NodeKind::root, none);
    if (below(8) == 0) marks.push_back(graph.mark());
    if (below(24) == 0) {
      const Mark mark =
          marks[marks.size() - 1 - below(static_cast<std::uint32_t>(std::min<std::size_t>(marks.size(), 6)))];
      while (marks.size() > 1 && marks.back().facts >= mark.facts) marks.pop_back();
      graph.cut(mark);
      there.resize(mark.facts);
      continue;
    }
    const auto nodes = static_cast<std::uint32_t>(graph.node_count());
    const auto kind = static_cast<FactKind>(below(8));
    const Fact fact{
        .kind = kind, .predicate = below(predicates), .a = below(nodes), .b = is_label(kind) ? 0 : below(nodes)};
    const bool is_known = std::ranges::any_of(there, [&](const Fact& one) {
      return one.kind == fact.kind && one.predicate == fact.predicate && one.a == fact.a && one.b == fact.b;
    });
    ASSERT_EQ(is_found(graph, fact), is_known) << "step " << step;
    if (is_known) continue;
    graph.add(fact);
    there.push_back(fact);
  }
  for (const Fact& fact : there) EXPECT_TRUE(is_found(graph, fact));
}

}  // namespace
}  // namespace geminga::hypertableau
