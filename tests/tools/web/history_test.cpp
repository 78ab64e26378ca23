// The last hour, with a daemon whose answers the test gives and a clock that it sets.
#include "web/site/history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/parse.hpp>
#include <chrono>
#include <string>
#include <vector>

#include "tools/web/fake_asker.hpp"

namespace geminga::web {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr History::Time noon{std::chrono::hours(12)};

Record service(const std::string& key, const std::string& priority = "0") {
  return record("services", {{"service", key}, {"provider", key.substr(0, key.rfind('/'))}, {"priority", priority}});
}

struct Rig {
  explicit Rig(seconds span = usual_history) : history(asker, span) {
    be({});
    asker.outcomes["participants"] =
        answered({record("participants", {{"id", "1a"}, {"self", "1"}, {"heard", "0.1"}})});
    asker.outcomes["requests"] = answered({});
    asker.outcomes["status"] = answered({record("status", {{"datagrams_received", "7"}})});
  }
  void be(std::vector<Record> services) { asker.outcomes["services"] = answered(std::move(services)); }
  boost::json::value told() { return boost::json::parse(history.document()); }
  /// `TIME EVENT SERVICE` of each change.
  std::vector<std::string> changes() {
    std::vector<std::string> lines;
    const auto document = told();
    for (const auto& one : document.at("changes").as_array()) {
      const auto& record = one.at("record");
      lines.push_back(std::string(one.at("time").as_string()).substr(11, 8) + ' ' +
                      std::string(one.at("event").as_string()) +
                      (record.is_object() ? " " + std::string(record.at("service").as_string()) : "") +
                      (one.at("reason").as_string().empty() ? "" : " " + std::string(one.at("reason").as_string())));
    }
    return lines;
  }
  std::size_t services_before() { return told().at("before").at("services").as_array().size(); }

  FakeAsker asker;
  History history;
};

TEST(History, TellsWhatWasThereWhenItBeganAndEachChangeSince) {
  Rig rig;
  EXPECT_TRUE(rig.told().at("begin").is_null());
  rig.be({service("1a/1/1")});
  rig.history.look(noon);
  EXPECT_EQ(rig.services_before(), 1U);
  EXPECT_THAT(rig.changes(), IsEmpty());
  rig.be({service("1a/1/1", "5"), service("1a/1/2")});
  rig.history.look(noon + seconds(1));
  rig.be({service("1a/1/1", "5"), service("2b/1/1")});
  rig.history.look(noon + seconds(2));
  rig.be({service("1a/1/1", "5")});
  rig.history.look(noon + seconds(3));
  EXPECT_THAT(rig.changes(),
              ElementsAre("12:00:01 modify 1a/1/1", "12:00:01 add 1a/1/2", "12:00:02 del 1a/1/2 withdrawn",
                          "12:00:02 add 2b/1/1", "12:00:03 del 2b/1/1 gone"));
  EXPECT_EQ(rig.services_before(), 1U);
  const auto document = rig.told();
  ASSERT_THAT(document.at("samples").as_array(), SizeIs(1));
  EXPECT_EQ(document.at("samples").at(0).as_array().size(), 7U);
}

TEST(History, ForgetsWhatIsOverItsSpanButNotWhatItDid) {
  Rig rig(minutes(10));
  rig.history.look(noon);
  rig.be({service("1a/1/1")});
  rig.history.look(noon + seconds(1));
  rig.history.look(noon + seconds(1) + minutes(10));
  EXPECT_THAT(rig.changes(), SizeIs(1));
  EXPECT_EQ(rig.services_before(), 0U);
  rig.history.look(noon + seconds(2) + minutes(10));
  EXPECT_THAT(rig.changes(), IsEmpty());
  EXPECT_EQ(rig.services_before(), 1U);
  EXPECT_EQ(std::string(rig.told().at("begin").as_string()).substr(11, 8), "12:00:02");
  EXPECT_THAT(rig.told().at("samples").as_array(), IsEmpty());
}

TEST(History, KeepsItsLimitsOfHappeningsAndOctets) {
  Rig rig;
  rig.history.look(noon);
  // Each service is a happening when it comes.
  std::vector<Record> services;
  for (std::size_t at = 0; at < max_happenings - 1; ++at) services.push_back(service("1a/1/" + std::to_string(at)));
  for (const std::size_t count : {max_happenings - 1, max_happenings, max_happenings + 1}) {
    rig.be(services);
    rig.history.look(noon + seconds(1));
    EXPECT_EQ(rig.told().at("changes").as_array().size(), std::min(count, max_happenings));
    EXPECT_EQ(rig.services_before(), count > max_happenings ? 1U : 0U);
    services.push_back(service("1a/1/more" + std::to_string(count)));
  }
  Rig other;
  other.history.look(noon);
  const std::string great(max_history_octets / 8, 'x');
  for (int at = 1; at <= 9; ++at) {
    other.be({service("1a/1/1", great + std::to_string(at))});
    other.history.look(noon + seconds(at));
  }
  EXPECT_THAT(other.changes(), SizeIs(7));
  EXPECT_EQ(other.services_before(), 1U);
}

TEST(History, SaysWhenTheDaemonWasAway) {
  Rig rig;
  rig.history.look(noon);
  rig.asker.outcomes["requests"] = failed(ClientError::Kind::unreachable, "no daemon there");
  rig.history.look(noon + seconds(1));
  rig.history.look(noon + seconds(2));
  rig.asker.outcomes["requests"] = answered({});
  rig.be({service("1a/1/1")});
  rig.history.look(noon + seconds(3));
  EXPECT_THAT(rig.changes(), ElementsAre("12:00:01 del no daemon there", "12:00:03 add", "12:00:03 add 1a/1/1"));
  EXPECT_EQ(rig.told().at("changes").at(0).at("of"), "daemon");
}

TEST(History, AsksOnceAtATimeAndNothingWhereItKeepsNothing) {
  Rig rig;
  rig.asker.is_held = true;
  rig.history.look(noon);
  rig.history.look(noon + seconds(1));
  EXPECT_THAT(rig.asker.asked, SizeIs(3));
  rig.asker.release();
  EXPECT_FALSE(rig.told().at("begin").is_null());
  Rig none(seconds(0));
  none.history.look(noon);
  EXPECT_THAT(none.asker.asked, IsEmpty());
}

}  // namespace
}  // namespace geminga::web
