// What a node says to daemons that come and go, line by line.
#include "client/channels/requests.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geminga::client {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class RequestsTest : public testing::Test {
 protected:
  static NamedPublication ball() {
    NamedPublication publication;
    publication.identity = TextIdentity{"ball"};
    publication.port = 5000;
    return publication;
  }
  static NamedSubscription any_ball() {
    NamedSubscription subscription;
    subscription.identity = TextIdentity{"ball"};
    return subscription;
  }
  std::vector<std::string> said() {
    std::vector<std::string> lines;
    for (const auto& statement : said_) {
      const std::string line = gcnp::to_line(statement);
      lines.push_back(line.substr(0, line.size() - 2));
    }
    said_.clear();
    return lines;
  }

  std::vector<gcnp::Statement> said_;
  Requests requests_{[this](const gcnp::Statement& statement) { said_.push_back(statement); }};
};

constexpr Requests::State accepted = Requests::State::accepted;
constexpr Requests::State refused = Requests::State::refused;

TEST_F(RequestsTest, WaitForADaemonAndAreSettledByItsPong) {
  requests_.create(1, ball());
  EXPECT_THAT(said(), IsEmpty());
  requests_.on_up();
  EXPECT_THAT(said(), ElementsAre("1 pub create mode=oto text=ball port=5000", "0 sys ping"));
  const auto settled = requests_.on_pong();
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_TRUE(settled[0].is_news);
  EXPECT_EQ(requests_.find(1)->state, accepted);
}

TEST_F(RequestsTest, AreStatedAgainToTheNextDaemonWithOnePingAndNoNews) {
  requests_.create(1, ball());
  requests_.create(2, any_ball());
  requests_.on_up();
  EXPECT_EQ(requests_.on_pong().size(), 2U);
  requests_.on_down();
  said();
  requests_.on_up();
  EXPECT_THAT(said(), ElementsAre("1 pub create mode=oto text=ball port=5000", "2 sub create mode=oto text=ball",
                                  "0 sys ping"));
  for (const auto& settled : requests_.on_pong()) EXPECT_FALSE(settled.is_news);
}

TEST_F(RequestsTest, AreNotStatedAgainWhenTheyWereRefused) {
  requests_.on_up();
  requests_.create(1, ball());
  EXPECT_EQ(requests_.on_error(1, {ErrorCode::impossible, "no"}), std::nullopt) << "its pong tells";
  const auto settled = requests_.on_pong();
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_EQ(settled[0].error->text, "no");
  EXPECT_EQ(requests_.find(1)->state, refused);
  said();
  requests_.on_down();
  requests_.on_up();
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(RequestsTest, AreStatedToTheNextDaemonWhenThisOneIsNotReady) {
  requests_.on_up();
  requests_.create(1, ball());
  EXPECT_EQ(requests_.on_error(1, {ErrorCode::not_ready, "stopping"}), std::nullopt);
  requests_.on_pong();
  EXPECT_EQ(requests_.find(1)->state, Requests::State::asked);
}

TEST_F(RequestsTest, AreTakenBack) {
  requests_.on_up();
  requests_.create(1, ball());
  requests_.on_pong();
  const auto taken = requests_.on_error(1, {ErrorCode::too_many, "taken back"});
  ASSERT_TRUE(taken);
  EXPECT_EQ(requests_.find(1)->state, refused);
  said();
  requests_.remove(1);
  EXPECT_THAT(said(), IsEmpty()) << "there is nothing to remove";
}

TEST_F(RequestsTest, ChangeWhenTheDaemonAgrees) {
  requests_.on_up();
  requests_.create(1, ball());
  requests_.on_pong();
  said();
  PublicationChange change;
  change.attributes["rate"] = "3";
  ASSERT_TRUE(requests_.modify(1, change));
  change.attributes["rate"] = "4";
  ASSERT_TRUE(requests_.modify(1, change));
  EXPECT_THAT(said(), ElementsAre("1 pub modify rate=3", "0 sys ping", "1 pub modify rate=4", "0 sys ping"));
  requests_.on_pong();
  EXPECT_EQ(requests_.find(1)->open_changes, 1U);
  EXPECT_EQ(requests_.on_error(1, {ErrorCode::impossible, "no"}), std::nullopt);
  requests_.on_pong();
  EXPECT_EQ(requests_.find(1)->last_change->text, "no");
  EXPECT_EQ(std::get<NamedPublication>(requests_.find(1)->stated).attributes.at("rate"), "3");
  EXPECT_EQ(requests_.find(1)->state, accepted) << "a refused change changes nothing";
}

TEST_F(RequestsTest, TakeOpenChangesToTheNextDaemon) {
  requests_.on_up();
  requests_.create(1, ball());
  requests_.on_pong();
  PublicationChange change;
  change.attributes["rate"] = "3";
  ASSERT_TRUE(requests_.modify(1, change));
  requests_.on_down();
  change.priority = 5;
  ASSERT_TRUE(requests_.modify(1, change));
  said();
  requests_.on_up();
  EXPECT_THAT(said(), ElementsAre("1 pub create mode=oto text=ball port=5000 priority=5 rate=3", "0 sys ping"));
  const auto settled = requests_.on_pong();
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_TRUE(settled[0].is_news);
  EXPECT_EQ(requests_.find(1)->open_changes, 0U);
}

TEST_F(RequestsTest, ThatNoDaemonWouldReadAreNotStated) {
  EXPECT_FALSE(Requests::fault(ball()));
  auto bad = ball();
  bad.identity = TextIdentity{std::string("a\x01", 2)};
  EXPECT_TRUE(Requests::fault(bad));
  bad = ball();
  bad.port = 0;
  EXPECT_TRUE(Requests::fault(bad));
  for (const std::size_t size : {254UL, 255UL, 256UL}) {
    auto sized = ball();
    sized.identity = TextIdentity{std::string(size, 'a')};
    EXPECT_EQ(Requests::fault(sized).has_value(), size > 255) << size;
  }
}

}  // namespace
}  // namespace geminga::client
