// The words of one participant that are kept: a state in its parts, and the changes that lead on from it.
#include "discovery/relaying/word_chain.hpp"

#include <gtest/gtest.h>

#include "discovery/keeping/frame.hpp"

namespace geminga::relaying {
namespace {

using announcement::Kind;

WordPlace state_place(std::uint64_t revision, std::uint32_t part = 0, std::uint32_t part_count = 1) {
  return {.kind = Kind::state, .revision = revision, .part = part, .part_count = part_count};
}
WordPlace change_place(std::uint64_t revision, std::uint64_t since) {
  return {.kind = Kind::change, .revision = revision, .since = since};
}

TEST(WordChain, LeadsToTheRevisionOfItsStateWhenAllPartsAreThere) {
  WordChain chain;
  EXPECT_FALSE(chain.leads_to(0));
  EXPECT_TRUE(chain.add(state_place(4, 1, 2), {}));
  EXPECT_FALSE(chain.leads_to(4));
  EXPECT_FALSE(chain.add(state_place(4, 1, 2), {})) << "a copy";
  EXPECT_TRUE(chain.add(state_place(4, 0, 2), {}));
  EXPECT_TRUE(chain.leads_to(4));
  EXPECT_FALSE(chain.leads_to(3));
}

TEST(WordChain, LeadsOnByChangesAndLeavesOutThoseThatALaterOneContains) {
  WordChain chain;
  EXPECT_FALSE(chain.add(change_place(2, 1), {})) << "it has no state";
  EXPECT_TRUE(chain.add(state_place(4), {}));
  EXPECT_TRUE(chain.add(change_place(5, 4), {}));
  EXPECT_TRUE(chain.add(change_place(6, 4), {}));
  EXPECT_EQ(chain.words().size(), 2U);
  EXPECT_TRUE(chain.leads_to(6));
  EXPECT_TRUE(chain.add(change_place(8, 2), {})) << "it begins before the state, and has all since then";
  EXPECT_EQ(chain.words().size(), 2U);
  EXPECT_FALSE(chain.add(change_place(10, 9), {})) << "one in between is missing";
  EXPECT_FALSE(chain.leads_to(10));
  EXPECT_FALSE(chain.add(state_place(7), {})) << "an older state";
  EXPECT_TRUE(chain.add(state_place(10), {}));
  EXPECT_TRUE(chain.leads_to(10));
  EXPECT_EQ(chain.words().size(), 1U);
}

TEST(WordChain, TakesWordsOfOneLinkAndOneIncarnation) {
  WordChain chain;
  chain.add(state_place(4), {});
  WordPlace elsewhere = state_place(4);
  elsewhere.link = 2;
  EXPECT_FALSE(chain.add(elsewhere, {})) << "the addresses of another link";
  elsewhere = change_place(5, 4);
  elsewhere.link = 2;
  EXPECT_FALSE(chain.add(elsewhere, {}));
  WordPlace reborn = state_place(1);
  reborn.boot = announcement::BootNonce{7};
  EXPECT_TRUE(chain.add(reborn, {}));
  EXPECT_TRUE(chain.leads_to(1));
}

TEST(WordChain, HasRoomForSoManyWordsAndLeadsNowhereWithMore) {
  WordChain chain;
  chain.add(state_place(1), {});
  for (std::uint64_t i = 1; i < keeping::max_kept_words; ++i) EXPECT_TRUE(chain.add(change_place(i + 1, i), {})) << i;
  EXPECT_TRUE(chain.leads_to(keeping::max_kept_words));
  EXPECT_FALSE(chain.add(change_place(keeping::max_kept_words + 1, keeping::max_kept_words), {}));
  EXPECT_FALSE(chain.leads_to(keeping::max_kept_words + 1));
}

}  // namespace
}  // namespace geminga::relaying
