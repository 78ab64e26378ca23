// Foreign services as they are stated: by concept where the daemon knows it, else by text, and within the limits.
#include "bridge/team/foreign_services.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bridge/team/limits.hpp"
#include "discovery/gcnp/statement.hpp"

namespace geminga::bridge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Foreign printer(const std::string& address = "10.0.0.2", const std::string& concept_name = "_ipp._tcp") {
  return {NamedPublication{.identity = TextIdentity{"_ipp._tcp"},
                           .mode = ChannelMode::one_to_one,
                           .address = address,
                           .port = 631,
                           .protocol = "dns-sd",
                           .priority = 0,
                           .attributes = {{"bridge", "dns-sd"}}},
          concept_name};
}

class Stating : public testing::Test {
 protected:
  /// Settles the requests so far: those with these numbers are refused with the code.
  void answer(const std::vector<std::uint32_t>& refused, ErrorCode code = ErrorCode::impossible) {
    for (const std::uint32_t number : refused) {
      if (const auto settled = session_.on_error(number, Error{code, "no"})) foreign_.on_settled(*settled);
    }
    while (pings_ > 0) {
      --pings_;
      for (const auto& settled : session_.on_pong()) foreign_.on_settled(settled);
    }
  }
  std::vector<std::string> said() { return std::exchange(said_, {}); }

  client::Reactor reactor_{[](const std::string&) {}};
  Tally tally_{reactor_, [](const std::string&) {}};
  std::vector<std::string> said_;
  int pings_ = 0;
  client::Session session_{[this](const gcnp::Statement& statement) {
    if (statement.subcommand == "ping") {
      ++pings_;
    } else {
      const std::string line = gcnp::to_line(statement);
      said_.push_back(line.substr(0, line.size() - 2));
    }
  }};
  ForeignServices foreign_{session_, tally_};
};

TEST_F(Stating, TriesTheConceptFirstAndThenTheText) {
  foreign_.on_up();
  session_.on_up();
  foreign_.put("a", printer());
  EXPECT_THAT(said(), ElementsAre(HasSubstr("1 pub create mode=oto concept=_ipp._tcp")));
  answer({1});
  EXPECT_THAT(said(), ElementsAre(HasSubstr("2 pub create mode=oto text=_ipp._tcp")));
  answer({});
  EXPECT_EQ(foreign_.concepts(), 0U);
  foreign_.on_other_ontology();
  EXPECT_THAT(said(), ElementsAre("2 pub modify concept=_ipp._tcp"));
  answer({});
  EXPECT_EQ(foreign_.concepts(), 1U) << "the new ontology knows it, and the service stays the same";
  foreign_.drop("a");
  EXPECT_THAT(said(), ElementsAre("2 pub remove"));
  EXPECT_EQ(foreign_.stated(), 0U);
}

TEST_F(Stating, AsksAnotherDaemonForTheConceptAgain) {
  foreign_.put("a", printer());
  foreign_.on_up();
  session_.on_up();
  said();
  answer({1});
  said();
  session_.on_down();
  foreign_.on_up();
  session_.on_up();
  EXPECT_THAT(said(), ElementsAre(HasSubstr(" pub create mode=oto concept=_ipp._tcp")));
}

TEST_F(Stating, ChangesWhatHasChangedAndStatesAnewWhatLostAnAttribute) {
  foreign_.on_up();
  session_.on_up();
  foreign_.put("a", printer());
  answer({});
  said();
  foreign_.put("a", printer());
  EXPECT_THAT(said(), IsEmpty());
  foreign_.put("a", printer("10.0.0.3"));
  EXPECT_THAT(said(), ElementsAre(HasSubstr("1 pub modify address=10.0.0.3")));
  answer({});
  Foreign bare = printer("10.0.0.3");
  std::get<NamedPublication>(bare.stated).attributes.clear();
  foreign_.put("a", bare);
  EXPECT_THAT(said(), ElementsAre("1 pub remove", HasSubstr("2 pub create")));
}

TEST_F(Stating, IsCountedWhereTheDaemonRefusesTheTextToo) {
  foreign_.on_up();
  session_.on_up();
  foreign_.put("a", printer("10.0.0.2", ""));
  answer({1}, ErrorCode::too_many);
  EXPECT_EQ(foreign_.stated(), 0U);
  EXPECT_EQ(tally_.of("services that the daemon refused"), 1U);
}

TEST_F(Stating, KeepsTheLimitOfAPeerAndLetsOthersWait) {
  foreign_.on_up();
  session_.on_up();
  for (std::size_t i = 0; i + 1 < max_stated; ++i) foreign_.put("k" + std::to_string(i), printer());
  EXPECT_EQ(foreign_.stated(), max_stated - 1);
  foreign_.put("last", printer());
  EXPECT_EQ(foreign_.stated(), max_stated);
  EXPECT_EQ(foreign_.waiting(), 0U);
  foreign_.put("over", printer());
  EXPECT_EQ(foreign_.stated(), max_stated);
  EXPECT_EQ(foreign_.waiting(), 1U);
  NamedSubscription request;
  request.identity = TextIdentity{"x"};
  foreign_.put("request", {request, ""});
  EXPECT_EQ(foreign_.stated(), max_stated + 1) << "requests have room of their own";
  foreign_.drop("k7");
  EXPECT_EQ(foreign_.waiting(), 0U);
  EXPECT_TRUE(foreign_.has("over"));
  for (std::size_t i = 0; i < max_waiting + 1; ++i) foreign_.put("w" + std::to_string(i), printer());
  EXPECT_EQ(foreign_.waiting(), max_waiting);
  EXPECT_EQ(tally_.of("services over the limit"), 1U);
  foreign_.clear();
  EXPECT_EQ(foreign_.stated() + foreign_.waiting(), 0U);
}

}  // namespace
}  // namespace geminga::bridge
