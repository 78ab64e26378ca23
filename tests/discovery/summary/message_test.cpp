// Messages between sites as octets and back, and octets that are none.
#include "discovery/summary/message.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "discovery/summary/limits.hpp"
#include "discovery/summary/magnitude.hpp"

namespace geminga::summary {
namespace {

Message answer() {
  return {.kind = Kind::answer,
          .site = SiteId{0x0102030405060708},
          .topic = {.digest = 0x1122334455667788, .rank = 300},
          .digest = 0x1122334455667788,
          .magnitude = 5};
}

std::string hex(std::string_view octets) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const char one : octets) {
    const auto octet = static_cast<unsigned char>(one);
    text += {digits[octet / 16], digits[octet % 16]};
  }
  return text;
}

TEST(SummaryMessage, IsTheWorkedExampleOfItsSpecification) {
  EXPECT_EQ(hex(encode(answer())),
            "0d474d53011002190807060504030201"
            "20ac02"
            "318877665544332211"
            "3805");
  EXPECT_EQ(decode(encode(answer())), answer());
}

TEST(SummaryMessage, ComesBackAsItWas) {
  const Topic iri{.digest = 0, .rank = 0, .iri = "https://example.org/Ball"};
  EXPECT_EQ(decode(encode({.kind = Kind::question, .site = SiteId{1}, .topic = iri, .digest = 7, .magnitude = 3})),
            (Message{.kind = Kind::question, .site = SiteId{1}, .topic = iri, .digest = 7, .magnitude = 3}));
  const Message listing{.kind = Kind::listing,
                        .site = SiteId{2},
                        .topic = iri,
                        .page = 3,
                        .has_more = true,
                        .announcements = {"a", std::string("\0b", 2)}};
  EXPECT_EQ(decode(encode(listing)), listing);
}

TEST(SummaryMessage, KeepsItsLimits) {
  Message message = answer();
  message.magnitude = max_magnitude;
  EXPECT_TRUE(decode(encode(message)));
  message.magnitude = max_magnitude + 1;
  EXPECT_EQ(decode(encode(message)), std::unexpected(Fault::bad_magnitude));
  for (const std::size_t size : {max_iri_bytes - 1, max_iri_bytes, max_iri_bytes + 1}) {
    message = {.site = SiteId{1}, .topic = {.digest = 0, .rank = 0, .iri = std::string(size, 'x')}};
    EXPECT_EQ(decode(encode(message)).has_value(), size <= max_iri_bytes) << size;
  }
  message = {.kind = Kind::listing, .site = SiteId{1}, .topic = {.digest = 0, .rank = 0, .iri = "x"}};
  for (const std::size_t size : {max_listed_bytes - 1, max_listed_bytes, max_listed_bytes + 1}) {
    message.announcements = {std::string(size, 'x')};
    EXPECT_EQ(decode(encode(message)).has_value(), size <= max_listed_bytes) << size;
  }
  for (const std::size_t count : {max_listed - 1, max_listed, max_listed + 1}) {
    message.announcements.assign(count, "x");
    EXPECT_EQ(decode(encode(message)).has_value(), count <= max_listed) << count;
  }
  EXPECT_NE(decode(std::string(max_message_bytes, 'x')), std::unexpected(Fault::too_large));
  EXPECT_EQ(decode(std::string(max_message_bytes + 1, 'x')), std::unexpected(Fault::too_large));
}

TEST(SummaryMessage, IsRefusedWithTheWordForWhatIsWrong) {
  EXPECT_EQ(decode("x"), std::unexpected(Fault::not_protobuf));
  EXPECT_EQ(decode(""), std::unexpected(Fault::not_geminga));
  EXPECT_EQ(decode(std::string("\x0d\x47\x4d\x53\x02", 5)), std::unexpected(Fault::other_version));
  EXPECT_EQ(decode(std::string("\x0d\x47\x4d\x53\x01", 5)), std::unexpected(Fault::bad_kind));
  Message message = answer();
  message.site = {};
  EXPECT_EQ(decode(encode(message)), std::unexpected(Fault::bad_site));
  message = answer();
  message.digest = 0;
  EXPECT_EQ(decode(encode(message)), std::unexpected(Fault::bad_topic)) << "a rank in no ontology";
  message = answer();
  message.topic = {};
  EXPECT_EQ(decode(encode(message)), std::unexpected(Fault::bad_topic));
  message.topic.iri = "no UTF-8: \xff";
  EXPECT_EQ(decode(encode(message)), std::unexpected(Fault::bad_topic));
  message.topic.iri = "line\nbreak";
  EXPECT_EQ(decode(encode(message)), std::unexpected(Fault::bad_topic));
}

TEST(SummaryMessage, SurvivesWhatIsNotOne) {
  base::Random random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string octets = encode(answer());
    for (auto left = 1 + random.below(4); left > 0; --left) {
      octets[random.below(octets.size())] = static_cast<char>(random.below(256));
    }
    const auto message = decode(octets.substr(0, random.below(octets.size() + 1)));
    EXPECT_TRUE(!message || message->magnitude <= max_magnitude) << "step " << i;
  }
}

TEST(Listings, HoldAllInPagesWithinTheLimits) {
  const Topic topic{.digest = 0, .rank = 0, .iri = std::string(max_iri_bytes, 'i')};
  std::vector<std::string> announcements(700, std::string(max_listed_bytes, 'x'));
  announcements.emplace_back(max_listed_bytes + 1, 'x');
  const auto pages = listings(SiteId{1}, topic, 7, announcements);
  std::size_t listed = 0;
  for (std::size_t page = 0; page < pages.size(); ++page) {
    EXPECT_LE(encode(pages[page]).size(), max_message_bytes);
    EXPECT_TRUE(decode(encode(pages[page])));
    EXPECT_EQ(pages[page].page, page);
    EXPECT_EQ(pages[page].has_more, page + 1 < pages.size());
    listed += pages[page].announcements.size();
  }
  EXPECT_EQ(listed, 700U);
  const auto many = listings(SiteId{1}, topic, 7, std::vector<std::string>(max_listed + 1, "x"));
  ASSERT_EQ(many.size(), 2U);
  EXPECT_EQ(many.front().announcements.size(), max_listed);
  EXPECT_EQ(listings(SiteId{1}, topic, 7, {}).size(), 1U);
}

TEST(Magnitude, IsTheBitsOfANumberAndStaysForOneLess) {
  EXPECT_EQ(magnitude_of(0), 0U);
  EXPECT_EQ(magnitude_of(1), 1U);
  EXPECT_EQ(magnitude_of(7), 3U);
  EXPECT_EQ(magnitude_of(8), 4U);
  EXPECT_EQ(least_of(4), 8U);
  EXPECT_FALSE(is_other(4, 8));
  EXPECT_FALSE(is_other(4, 7)) << "around a power of two";
  EXPECT_TRUE(is_other(4, 3));
  EXPECT_TRUE(is_other(4, 16));
  EXPECT_TRUE(is_other(1, 0)) << "none any more";
}

}  // namespace
}  // namespace geminga::summary
