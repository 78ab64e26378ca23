// The stack of nodes that may block others.
#include "reasoning/dl/hypertableau/graph/blockers.hpp"

#include <gtest/gtest.h>

namespace geminga::hypertableau {
namespace {

constexpr auto any = [](NodeId) { return true; };

TEST(Blockers, GiveTheNewestNodeThatIsWanted) {
  Blockers blockers;
  EXPECT_EQ(blockers.find(7, any), none);
  blockers.push(1, 7);
  blockers.push(4, 7);
  blockers.push(5, 8);
  EXPECT_EQ(blockers.find(7, any), 4U);
  EXPECT_EQ(blockers.find(7, [](NodeId node) { return node < 4; }), 1U);
  EXPECT_EQ(blockers.find(8, any), 5U);
  EXPECT_EQ(blockers.find(9, any), none);
}

TEST(Blockers, ForgetWhatIsCutOffAndKeepWhatIsOlder) {
  // More than the table begins with, so that it grows on the way.
  constexpr NodeId count = 1000;
  Blockers blockers;
  for (NodeId node = 0; node < count; ++node) blockers.push(node, node % 10);
  for (const NodeId first : {count - 1, NodeId{500}, NodeId{3}}) {
    blockers.cut(first);
    for (std::uint64_t key = 0; key < 10; ++key) {
      const NodeId found = blockers.find(key, any);
      if (key >= first) {
        EXPECT_EQ(found, none) << key;
      } else {
        EXPECT_LT(found, first);
        EXPECT_EQ(found % 10, key);
        EXPECT_GE(found + 10, first) << "the newest";
      }
    }
  }
  blockers.push(3, 5);
  EXPECT_EQ(blockers.find(5, any), 3U);
}

}  // namespace
}  // namespace geminga::hypertableau
