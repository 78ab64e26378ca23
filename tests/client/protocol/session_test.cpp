// The lines of a node to daemons that come and go.
#include "client/protocol/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geminga::client {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class SessionTest : public testing::Test {
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
  Session session_{[this](const gcnp::Statement& statement) { said_.push_back(statement); }};
};

constexpr Session::State accepted = Session::State::accepted;
constexpr Session::State refused = Session::State::refused;

TEST_F(SessionTest, WaitForADaemonAndAreSettledByItsPong) {
  session_.create(1, ball());
  EXPECT_THAT(said(), IsEmpty());
  session_.on_up();
  EXPECT_THAT(said(), ElementsAre("1 pub create mode=oto text=ball port=5000", "0 sys ping"));
  const auto settled = session_.on_pong();
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_TRUE(settled[0].is_news);
  EXPECT_EQ(session_.find(1)->state, accepted);
}

TEST_F(SessionTest, AreStatedAgainToTheNextDaemonWithOnePingAndNoNews) {
  session_.create(1, ball());
  session_.create(2, any_ball());
  session_.on_up();
  EXPECT_EQ(session_.on_pong().size(), 2U);
  session_.on_down();
  said();
  session_.on_up();
  EXPECT_THAT(said(), ElementsAre("1 pub create mode=oto text=ball port=5000", "2 sub create mode=oto text=ball",
                                  "0 sys ping"));
  for (const auto& settled : session_.on_pong()) EXPECT_FALSE(settled.is_news);
}

TEST_F(SessionTest, AreNotStatedAgainWhenTheyWereRefused) {
  session_.on_up();
  session_.create(1, ball());
  EXPECT_EQ(session_.on_error(1, {ErrorCode::impossible, "no"}), std::nullopt) << "its pong tells";
  const auto settled = session_.on_pong();
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_EQ(settled[0].error->text, "no");
  EXPECT_EQ(session_.find(1)->state, refused);
  said();
  session_.on_down();
  session_.on_up();
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(SessionTest, AreStatedToTheNextDaemonWhenThisOneIsNotReady) {
  session_.on_up();
  session_.create(1, ball());
  EXPECT_EQ(session_.on_error(1, {ErrorCode::not_ready, "stopping"}), std::nullopt);
  session_.on_pong();
  EXPECT_EQ(session_.find(1)->state, Session::State::asked);
}

TEST_F(SessionTest, AreTakenBack) {
  session_.on_up();
  session_.create(1, ball());
  session_.on_pong();
  const auto taken = session_.on_error(1, {ErrorCode::too_many, "taken back"});
  ASSERT_TRUE(taken);
  EXPECT_EQ(session_.find(1)->state, refused);
  said();
  session_.remove(1);
  EXPECT_THAT(said(), IsEmpty()) << "there is nothing to remove";
}

TEST_F(SessionTest, ChangeWhenTheDaemonAgrees) {
  session_.on_up();
  session_.create(1, ball());
  session_.on_pong();
  said();
  PublicationChange change;
  change.attributes["rate"] = "3";
  ASSERT_TRUE(session_.modify(1, change));
  change.attributes["rate"] = "4";
  ASSERT_TRUE(session_.modify(1, change));
  EXPECT_THAT(said(), ElementsAre("1 pub modify rate=3", "0 sys ping", "1 pub modify rate=4", "0 sys ping"));
  session_.on_pong();
  EXPECT_EQ(session_.find(1)->open_changes, 1U);
  EXPECT_EQ(session_.on_error(1, {ErrorCode::impossible, "no"}), std::nullopt);
  session_.on_pong();
  EXPECT_EQ(session_.find(1)->last_change->text, "no");
  EXPECT_EQ(std::get<NamedPublication>(session_.find(1)->stated).attributes.at("rate"), "3");
  EXPECT_EQ(session_.find(1)->state, accepted) << "a refused change changes nothing";
}

TEST_F(SessionTest, TakeOpenChangesToTheNextDaemon) {
  session_.on_up();
  session_.create(1, ball());
  session_.on_pong();
  PublicationChange change;
  change.attributes["rate"] = "3";
  ASSERT_TRUE(session_.modify(1, change));
  session_.on_down();
  change.priority = 5;
  ASSERT_TRUE(session_.modify(1, change));
  said();
  session_.on_up();
  EXPECT_THAT(said(), ElementsAre("1 pub create mode=oto text=ball port=5000 priority=5 rate=3", "0 sys ping"));
  const auto settled = session_.on_pong();
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_TRUE(settled[0].is_news);
  EXPECT_EQ(session_.find(1)->open_changes, 0U);
}

TEST_F(SessionTest, ThatNoDaemonWouldReadAreNotStated) {
  EXPECT_FALSE(Session::fault(ball()));
  auto bad = ball();
  bad.identity = TextIdentity{std::string("a\x01", 2)};
  EXPECT_TRUE(Session::fault(bad));
  bad = ball();
  bad.port = 0;
  EXPECT_TRUE(Session::fault(bad));
  for (const std::size_t size : {254UL, 255UL, 256UL}) {
    auto sized = ball();
    sized.identity = TextIdentity{std::string(size, 'a')};
    EXPECT_EQ(Session::fault(sized).has_value(), size > 255) << size;
  }
}

}  // namespace
}  // namespace geminga::client
