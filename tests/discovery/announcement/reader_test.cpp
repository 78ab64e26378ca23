// A reader that remembers reads what one reads that does not.
#include "discovery/announcement/reader.hpp"

#include <gtest/gtest.h>

#include "discovery/announcement/announcements.hpp"

namespace geminga::announcement {
namespace {

TEST(Reader, DecodesEqualOctetsOnceWhileItRemembersThem) {
  const Datagram datagram = encode(worked_example()).front();
  Reader reader(8);
  for (int receiver = 0; receiver < 3; ++receiver) {
    const auto read = reader.read(datagram);
    ASSERT_TRUE(read);
    EXPECT_EQ(**read, worked_example());
  }
  EXPECT_EQ(reader.decoded(), 1U);
  Reader alone;
  for (int receiver = 0; receiver < 3; ++receiver) EXPECT_EQ(**alone.read(datagram), worked_example());
  EXPECT_EQ(alone.decoded(), 3U);
}

TEST(Reader, ReadsTheSameWhateverItRemembers) {
  base::Random random(11);
  std::vector<Datagram> datagrams;
  for (int i = 0; i < 60; ++i) {
    for (Datagram& one : encode(i % 3 == 0 ? random_presence(random) : random_announcement(random)))
      datagrams.push_back(std::move(one));
    if (i % 5 == 0 && !datagrams.back().empty())
      datagrams.back()[random.below(datagrams.back().size())] ^= std::byte{4};
  }
  datagrams.emplace_back();
  Reader few(2);
  Reader many(512);
  for (int i = 0; i < 1000; ++i) {
    const Datagram& datagram = datagrams[random.below(datagrams.size())];
    const auto expected = decode(datagram);
    for (Reader* reader : {&few, &many}) {
      const auto read = reader->read(datagram);
      ASSERT_EQ(read.has_value(), expected.has_value()) << "step " << i;
      if (expected) {
        ASSERT_EQ(**read, *expected) << "step " << i;
      } else {
        ASSERT_EQ(read.error(), expected.error()) << "step " << i;
      }
    }
  }
  EXPECT_LT(many.decoded(), few.decoded());
}

}  // namespace
}  // namespace geminga::announcement
