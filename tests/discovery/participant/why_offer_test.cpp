// `query why` of an offer alone and the reasons of `services unused=1`: what they tell, and that their limits hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/matcher.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "discovery/participant/queries/demand.hpp"
#include "discovery/participant/why.hpp"

namespace geminga::participant {
namespace {

using std::chrono::milliseconds;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::SizeIs;

class WhyOfferTest : public WhyTest {
 protected:
  void request(int number, const std::string& what) { asking.say(std::to_string(number) + " sub create " + what); }

  [[nodiscard]] std::string own(int number) const { return provider.participant() + "/1/" + std::to_string(number); }
};

TEST_F(WhyOfferTest, TellsTheFirstFewAndCountsAll) {
  offer(900, "mode=oto text=x port=1 priority=5");
  offer(1, "mode=oto text=x port=1");
  for (int number = 1; number <= 20; ++number) {
    request(number, "mode=oto text=x");
    request(100 + number, "mode=oto text=x limit=2");
    request(200 + number, "mode=otm/stream text=x");
  }
  const auto answer = ask("why service=" + own(1));
  ASSERT_THAT(answer, SizeIs(2 * max_told_matches + max_told_misfits + 1));
  for (std::size_t i = 0; i + 1 < answer.size(); ++i) {
    EXPECT_THAT(answer[i], HasSubstr(i < max_told_matches       ? "check=identity ok=1"
                                     : i < 2 * max_told_matches ? "check=arbitration ok=0"
                                                                : "check=mode ok=0"));
  }
  EXPECT_THAT(answer.back(), HasSubstr("count=12 used=1 requests=60 matching=40 taken=20"));
  EXPECT_THAT(ask("why offer.text=x offer.mode=oto offer.priority=6").back(), HasSubstr("matching=40 taken=40"));
  EXPECT_THAT(ask("why offer.text=x offer.mode=oto").back(), HasSubstr("matching=40 taken=0 code=outranked"));
  EXPECT_THAT(ask("why offer.text=x").back(), HasSubstr("matching=60 taken=20"));
}

TEST_F(WhyOfferTest, RanksTheOffersForSoManyConsumersWhoseChoiceNobodySays) {
  sim::Host& other = world.add_host("robot2");
  other.settings.limits.services_per_peer = 1024;
  other.switch_on();
  world.run_for(milliseconds(200));
  sim::Client& listener = world.add_client("listener");
  listener.connect(other);
  offer(1, "mode=otm/stream text=x port=1");
  const auto taken = [&] { return ask("why service=" + own(1)).back(); };
  const int most = static_cast<int>(max_ranked_requests);
  const auto listen = [&](int first, int last) {
    for (int i = first; i <= last; ++i) listener.say(std::to_string(i) + " sub create mode=otm/stream text=x limit=1");
    world.run_for(std::chrono::seconds(3));
  };
  listen(1, most - 1);
  EXPECT_THAT(taken(), HasSubstr("matching=63 taken=63"));
  listen(most, most);
  EXPECT_THAT(taken(), HasSubstr("matching=64 taken=64"));
  listen(most + 1, most + 1);
  EXPECT_THAT(taken(), HasSubstr("matching=65 taken=64"));
  offer(2, "mode=otm/stream text=x port=1 priority=2");
  EXPECT_THAT(taken(), HasSubstr("matching=65 taken=0 code=outranked"));
}

TEST_F(WhyOfferTest, IsAnsweredPieceByPiece) {
  constexpr int requests = 900;
  for (int number = 1; number <= requests; ++number) request(number, "mode=otm/stream text=x");
  offer(1, "mode=oto text=x port=1");
  world.run_for(milliseconds(50));
  constexpr int queries = 20;
  int ends = 0;
  sim::Client& curious = world.add_client("curious");
  curious.on_line = [&](std::string_view line, const gcnp::Statement&) { ends += line.contains(" msg end ") ? 1 : 0; };
  curious.connect(host);
  std::string question;
  for (int number = 1; number <= queries; ++number) question += std::to_string(number) + " query why offer.text=y\n";
  curious.send_bytes(question);
  sim::Client& victim = world.add_client("victim");
  int ends_before_pong = -1;
  victim.on_line = [&](std::string_view, const gcnp::Statement&) { ends_before_pong = ends; };
  victim.connect(host);
  victim.say("0 sys ping");
  world.run_for(milliseconds(100));
  EXPECT_GE(ends_before_pong, 0) << "no pong came";
  EXPECT_LE(ends_before_pong, static_cast<int>(work_in_turn / requests) + 1);
  EXPECT_EQ(ends, queries);
}

TEST_F(WhyOfferTest, TheReasonOfAServiceIsFoundAmongSoManyRequests) {
  const int most = static_cast<int>(max_examined_requests);
  for (int number = 1; number < most; ++number) request(number, "mode=otm/stream concept=soccer:Ball");
  request(most, "mode=oto concept=soccer:Ball where=\"rate > 5\"");
  offer(1, "mode=oto concept=soccer:Ball port=1 rate=3");
  EXPECT_THAT(ask("services unused=1").front(), HasSubstr("why=mode because=\""));
  asking.say(std::to_string(most) + " sub modify protocol=tcp");
  asking.say("1 sub modify mode=otm/pubsub protocol=tcp");
  EXPECT_THAT(ask("services unused=1").front(), HasSubstr("why=mode "));
  for (int number = 1; number < most; ++number) asking.say(std::to_string(number) + " sub modify scope=!host");
  asking.say(std::to_string(most) + " sub modify protocol=\"\"");
  EXPECT_THAT(ask("services unused=1").front(), HasSubstr("why=where ")) << "one thing is wrong, not two";
  request(1000, "mode=oto concept=soccer:Ball where=\"rate > 5\"");
  asking.say(std::to_string(most) + " sub modify scope=!host");
  EXPECT_THAT(ask("services unused=1").front(), HasSubstr("why=mode ")) << "it is one behind those that are looked at";
  EXPECT_THAT(ask("why service=" + own(1)).back(), HasSubstr("code=where"));
}

TEST_F(WhyOfferTest, ATextIsComparedWithSoManyOthers) {
  const auto reason = [&] { return ask("services unused=1").front(); };
  const int most = static_cast<int>(max_compared_requests);
  sim::Client& further = world.add_client("further");
  for (int number = 1; number < most; ++number) request(number, "mode=oto text=lidar" + std::to_string(number));
  further.connect(host);
  further.say("1 sub create mode=oto text=camera");
  offer(1, "mode=oto text=camrea port=1");
  EXPECT_THAT(reason(), HasSubstr("why=similar_text"));
  request(most, "mode=oto text=lidar");
  EXPECT_THAT(reason(), HasSubstr("why=nobody")) << "it is one behind those that are compared";
  EXPECT_THAT(ask("why service=" + own(1)).back(), HasSubstr("code=similar_text"));
}

TEST_F(WhyOfferTest, OnlyWhatIsNarrowerMayBeAskedForFarBelow) {
  host.reload(sim::small_ontology("deep"));
  offer(1, "mode=oto concept=soccer:Level400 port=1");
  const int most = static_cast<int>(matching::max_searched_classes);
  request(1, "mode=oto concept=soccer:Level" + std::to_string(400 - most + 1));
  EXPECT_THAT(ask("services unused=1").front(), HasSubstr("why=broader "));
  asking.say("1 sub remove");
  request(1, "mode=oto concept=soccer:Level" + std::to_string(400 - most));
  EXPECT_THAT(ask("services unused=1").front(), HasSubstr("why=nobody ")) << "it is one behind the last class";
  EXPECT_THAT(ask("why service=" + own(1)).back(), HasSubstr("code=broader"));
}

TEST_F(WhyOfferTest, SaysThatTheProvidersOntologyDiffers) {
  sim::Host& other = world.add_host("robot2");
  other.ontology = sim::small_ontology("misspelt");
  other.switch_on();
  world.run_for(milliseconds(200));
  sim::Client& misspelling = world.add_client("misspelling");
  misspelling.connect(other);
  misspelling.say("1 pub create mode=oto concept=soccer:Bal port=1");
  request(1, "mode=oto concept=soccer:Ball");
  world.run_for(std::chrono::seconds(3));
  EXPECT_THAT(
      ask("services unused=1").front(),
      AllOf(HasSubstr("why=ontology_differs because=\"'soccer:Bal' is neither a class nor a label: did you mean "
                      "soccer:Ball?; robot2 has the ontology "),
            EndsWith("geminga-query ontology lists the hosts that have others\"")));
}

}  // namespace
}  // namespace geminga::participant
