// Heard and rejected datagrams, at the limits of what is remembered of them.
#include "discovery/sealing/ledger.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/sealing/rig.hpp"

namespace geminga::sealing {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;
using testing::SizeIs;

const Outcome forged{Protection::encrypted, KeyId(0x3fa9), Rejection::forged};
const Outcome heard{Protection::encrypted, KeyId(0x3fa9), std::nullopt};

Arrival from(std::string_view source, base::Instant now) {
  return {.interface = wlan, .interface_name = "wlan0", .source = source, .now = now};
}

constexpr base::Instant start{std::chrono::hours(1)};

TEST(Ledger, RemembersTheLastThousandDatagrams) {
  Ledger ledger;
  for (std::size_t i = 0; i < remembered_datagrams + 1; ++i) ledger.enter(i < 10 ? forged : heard, from("a", start));
  EXPECT_EQ(ledger.recent().at(forged), 9U);
  EXPECT_EQ(ledger.recent().at(heard), remembered_datagrams - 9);
  EXPECT_EQ(ledger.rejected(Rejection::forged), 10U);
  EXPECT_EQ(ledger.rejected(Rejection::plain), 0U);
}

TEST(Ledger, RemembersSixtyFourSourcesAndForgetsWhoWasRejectedLongestAgo) {
  Ledger ledger;
  for (std::size_t i = 0; i < max_sources; ++i) {
    ledger.enter(forged, from("10.0.0." + std::to_string(i), start + seconds(i)));
  }
  ledger.enter(forged, from("10.0.0.0", start + seconds(100)));
  EXPECT_THAT(ledger.sources(), SizeIs(max_sources));
  EXPECT_EQ(ledger.sources().front().source, "10.0.0.0 on wlan0");
  EXPECT_EQ(ledger.sources().front().count, 2U);
  ledger.enter(forged, from("10.0.0.200", start + seconds(101)));
  EXPECT_THAT(ledger.sources(), SizeIs(max_sources));
  const auto sources = ledger.sources();
  EXPECT_TRUE(std::ranges::none_of(sources, [](const Rejected& one) { return one.source == "10.0.0.1 on wlan0"; }));
}

TEST(Ledger, KeepsReasonsAndKeysOfOneSourceApart) {
  Ledger ledger;
  ledger.enter(forged, from("a", start));
  ledger.enter({Protection::plain, std::nullopt, Rejection::plain}, from("a", start));
  ledger.enter({Protection::encrypted, KeyId(1), Rejection::unknown_key}, from("a", start));
  ledger.enter({Protection::encrypted, KeyId(2), Rejection::unknown_key}, from("a", start));
  EXPECT_THAT(ledger.sources(), SizeIs(4));
}

TEST(Ledger, TellsTheLogOfOneReasonOnceInAMinute) {
  Ledger ledger;
  ledger.enter(heard, from("a", start));
  EXPECT_FALSE(ledger.take_complaint());
  ledger.enter(forged, from("10.0.0.66", start));
  EXPECT_THAT(ledger.take_complaint().value_or(""),
              testing::AllOf(HasSubstr("1 datagram was rejected as forged"), HasSubstr("10.0.0.66 on wlan0"),
                             HasSubstr("(key 3fa9)")));
  EXPECT_FALSE(ledger.take_complaint());
  for (int i = 1; i < 60; ++i) {
    ledger.enter(forged, from("10.0.0.66", start + seconds(i)));
    EXPECT_FALSE(ledger.take_complaint()) << i;
  }
  ledger.enter(forged, from("10.0.0.66", start + complaint_spacing));
  EXPECT_THAT(ledger.take_complaint().value_or(""), HasSubstr("60 datagrams were"));
}

TEST(Ledger, TellsTheLogOfUnprovedOnesOnlyWhenTheyGoOn) {
  Ledger ledger;
  const Outcome unproved{Protection::encrypted, KeyId(1), Rejection::unproved};
  for (int i = 1; i < 100; ++i) {
    ledger.enter(unproved, from("a", start));
    EXPECT_FALSE(ledger.take_complaint()) << i;
  }
  ledger.enter(unproved, from("a", start));
  EXPECT_TRUE(ledger.take_complaint());
}

}  // namespace
}  // namespace geminga::sealing
