// `query why` and the reasons of `requests unmatched=1`: what they cost, and that their limits hold.
#include "discovery/participant/why.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "discovery/matching/meeting/obstacle.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "discovery/participant/queries/survey.hpp"

namespace geminga::participant {
namespace {

using std::chrono::milliseconds;
using testing::AllOf;
using testing::AnyOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::SizeIs;

TEST_F(WhyTest, TellsTheBestFewAndCountsAll) {
  for (int number = 1; number <= 20; ++number) {
    offer(number, "mode=oto concept=soccer:Ball port=1 rate=" + std::to_string(number));
    offer(100 + number, "mode=otm/stream concept=soccer:Ball port=1");
  }
  const auto answer = ask("why concept=soccer:TrackedObject mode=oto prefer=\"rate desc\" limit=10");
  ASSERT_THAT(answer, SizeIs(2 * max_told_matches + max_told_misfits + 1));
  for (std::size_t i = 0; i + 1 < answer.size(); ++i) {
    const bool is_given = i < max_told_matches;
    const bool meets = i < 2 * max_told_matches;
    EXPECT_THAT(answer[i], HasSubstr(is_given ? " ok=1 " : " ok=0 "));
    EXPECT_THAT(answer[i], HasSubstr(is_given ? "proof=" : meets ? "code=outranked" : "code=mode")) << i;
  }
  EXPECT_THAT(answer[0], HasSubstr("/20 "));
  EXPECT_THAT(answer[max_told_matches], HasSubstr("it ranks 11 of 20, the limit is 10: outranked by "));
  EXPECT_THAT(answer.back(), HasSubstr("count=12 served=1 offers=40 matching=20"));
}

TEST_F(WhyTest, KeepsTheRanksOfSoManyAndStillCountsAll) {
  constexpr int local = 1000;
  constexpr int all = static_cast<int>(max_ranked_matches) + 3;
  sim::Host& other = world.add_host("robot2");
  other.settings.limits.services_per_peer = 1024;
  other.switch_on();
  world.run_for(milliseconds(200));
  sim::Client& further = world.add_client("further");
  further.connect(other);
  for (int number = 1; number <= all; ++number) {
    const std::string what = "mode=otm/stream text=x port=1 priority=" + std::to_string(number);
    if (number <= local) {
      offer(number, what);
    } else {
      further.say(std::to_string(number) + " pub create " + what);
    }
  }
  world.run_for(std::chrono::seconds(5));
  EXPECT_THAT(ask("why text=x").back(), HasSubstr("served=1 offers=1027 matching=1027"));
  const std::string worst = provider.participant() + "/1/1";
  const auto last = ask("why text=x limit=2000 service=" + worst);
  EXPECT_THAT(last.back(), HasSubstr("matches=1 "));
  EXPECT_THAT(last[last.size() - 2], HasSubstr("it ranks 1027 of 1027, the limit is 2000"));
  EXPECT_THAT(ask("why text=x limit=1026 service=" + worst).back(), HasSubstr("outranked=1 code=outranked"));
}

TEST_F(WhyTest, RanksAPairTheSameAtOnceAndPieceByPiece) {
  asking.say("1 sub create mode=otm/pubsub text=x limit=2");
  const std::string subscription = "why subscription=" + provider.participant() + "/2/1 ";
  const std::string worst = "service=" + provider.participant() + "/1/1";
  for (int number = 1; number <= static_cast<int>(max_ranked_at_once) + 1; ++number) {
    offer(number, "mode=otm/pubsub text=x port=1 priority=" + std::to_string(number));
    if (number < static_cast<int>(max_ranked_at_once)) continue;
    const std::string count = std::to_string(number);
    const std::string rival = provider.participant() + "/1/" + std::to_string(number - 1);
    const std::string words = "it ranks " + count + " of " + count + ", the limit is 2: outranked by " + rival +
                              ", whose priority is " + std::to_string(number - 1) + " against 1";
    EXPECT_THAT(ask(subscription + worst).at(5), HasSubstr(words));
    EXPECT_THAT(ask("why text=x mode=otm/pubsub limit=2 " + worst).at(5), HasSubstr(words));
    const auto imagined = ask(subscription + "offer.text=x offer.priority=500").at(5);
    EXPECT_THAT(imagined, HasSubstr("it ranks 1 of " + std::to_string(number + 1) +
                                    ", the limit is 2: it takes the place of " + rival));
  }
}

TEST_F(WhyTest, IsAnsweredPieceByPiece) {
  constexpr int services = 900;
  for (int number = 1; number <= services; ++number) offer(number, "mode=otm/stream text=x port=1");
  world.run_for(milliseconds(50));
  constexpr int queries = 20;
  int ends = 0;
  sim::Client& curious = world.add_client("curious");
  curious.on_line = [&](std::string_view line, const gcnp::Statement&) { ends += line.contains(" msg end ") ? 1 : 0; };
  curious.connect(host);
  const std::string worst = "service=" + provider.participant() + "/1/1\n";
  std::string question;
  for (int number = 1; number <= queries; ++number) {
    question +=
        std::to_string(number) + (number % 2 == 0 ? " query why text=y\n" : " query why text=x limit=1 " + worst);
  }
  curious.send_bytes(question);
  sim::Client& victim = world.add_client("victim");
  int ends_before_pong = -1;
  victim.on_line = [&](std::string_view, const gcnp::Statement&) { ends_before_pong = ends; };
  victim.connect(host);
  victim.say("0 sys ping");
  world.run_for(milliseconds(100));
  EXPECT_GE(ends_before_pong, 0) << "no pong came";
  EXPECT_LE(ends_before_pong, static_cast<int>(work_in_turn / services) + 1);
  EXPECT_EQ(ends, queries);
}

TEST_F(WhyTest, TheReasonOfARequestIsFoundAmongSoManyOffers) {
  const int last = static_cast<int>(max_examined_offers);
  for (int number = 1; number < last; ++number) offer(number, "mode=otm/stream concept=soccer:Ball port=1");
  offer(last, "mode=oto concept=soccer:Ball port=1 rate=3");
  asking.say("1 sub create mode=oto concept=soccer:Ball where=\"rate > 5\"");
  EXPECT_THAT(ask("requests unmatched=1").front(), HasSubstr("why=where because=\""));
  for (int number = last + 1; number <= 4 * last; ++number) offer(number, "mode=otm/stream concept=soccer:Ball port=1");
  EXPECT_THAT(ask("requests unmatched=1").front(), AnyOf(HasSubstr("why=where "), HasSubstr("why=mode ")));
  EXPECT_THAT(ask("why subscription=" + provider.participant() + "/2/1").back(),
              HasSubstr("offers=256 matching=0 code=where"));
}

TEST_F(WhyTest, ATextIsComparedWithSoManyOthers) {
  const auto reason = [&] { return ask("requests unmatched=1").front(); };
  for (int number = 1; number < static_cast<int>(max_compared_offers); ++number) {
    offer(number, "mode=oto text=lidar" + std::to_string(number) + " port=1");
  }
  offer(static_cast<int>(max_compared_offers), "mode=oto text=camera port=1");
  asking.say("1 sub create mode=oto text=camrea");
  EXPECT_THAT(reason(), HasSubstr("why=similar_text"));
  provider.say("1 pub remove");
  offer(static_cast<int>(max_compared_offers) + 1, "mode=oto text=lidar port=1");
  EXPECT_THAT(reason(), HasSubstr("why=similar_text"));
  provider.say(std::to_string(max_compared_offers) + " pub remove");
  offer(1, "mode=oto text=lidar1 port=1");
  offer(static_cast<int>(max_compared_offers) + 2, "mode=oto text=camera port=1");
  EXPECT_THAT(reason(), HasSubstr("why=nobody")) << "it is one behind those that are compared";
  EXPECT_THAT(ask("why subscription=" + provider.participant() + "/2/1").back(), HasSubstr("code=similar_text"));
}

TEST_F(WhyTest, LooksForTheNamesThatWereMeantForSoManyUnknownOnes) {
  sim::Host& other = world.add_host("robot2");
  other.ontology = sim::small_ontology("misspelt");
  other.switch_on();
  world.run_for(milliseconds(200));
  sim::Client& misspelling = world.add_client("misspelling");
  misspelling.connect(other);
  constexpr int all = static_cast<int>(max_searched_names) + 1;
  for (int number = 1; number <= all; ++number) {
    misspelling.say(std::to_string(number) + " sub create mode=oto concept=soccer:Bal");
  }
  world.run_for(std::chrono::seconds(3));
  const auto answer = ask("requests unmatched=1");
  ASSERT_THAT(answer, SizeIs(all + 1));
  EXPECT_THAT(answer[all - 2],
              HasSubstr("why=ontology_differs because=\"'soccer:Bal' is neither a class nor a label: did "
                        "you mean soccer:Ball?"));
  EXPECT_THAT(answer[all - 1], HasSubstr("why=ontology_differs because=\"soccer:Bal is unknown to the ontology;"));
}

TEST_F(WhyTest, NamesSoManyRepresentationsThatAreOffered) {
  int number = 0;
  for (const char* name : {"PolarFrame", "Information", "TrackedObject", "Ball", "Opponent", "PolarFrame"}) {
    offer(++number, std::string("mode=oto concept=soccer:Ball port=1 representation=soccer:") + name);
  }
  asking.say("1 sub create mode=oto concept=soccer:Ball representation=soccer:CartesianFrame");
  EXPECT_THAT(ask("requests unmatched=1").front(),
              HasSubstr("; offered are soccer:PolarFrame, soccer:Information, soccer:TrackedObject, soccer:Ball: ask"));
}

TEST_F(WhyTest, TellsSoMuchOfAProof) {
  host.reload(sim::small_ontology("deep"));
  const auto proof_up_to = [&](int level) {
    const std::string identity =
        ask("why concept=soccer:Level" + std::to_string(level) + " offer.concept=soccer:Level100").at(1);
    return identity.substr(identity.find("proof=\"") + 7);
  };
  const std::string axiom = "soccer:Level100 SubClassOf soccer:Level101";
  const int most = static_cast<int>((max_proof_bytes + 1) / (axiom.size() + 1));
  const std::string last = "SubClassOf soccer:Level" + std::to_string(100 + most) + "\"";
  EXPECT_THAT(proof_up_to(100 + most), AllOf(HasSubstr(axiom), EndsWith(last)));
  EXPECT_THAT(proof_up_to(101 + most), EndsWith(last));
  EXPECT_THAT(proof_up_to(220), EndsWith(last));
}

TEST_F(WhyTest, HasAnAttributeOfTheSameNameBesideTheReason) {
  asking.say("1 sub create mode=oto text=x why=me because=you");
  EXPECT_THAT(ask("requests unmatched=1").front(), HasSubstr(" attr.because=you attr.why=me"));
}

TEST(WhyCodes, AreListedInTheOrderOfTheCode) {
  std::ifstream file(GEMINGA_SOURCE_DIR "/src/discovery/participant/QUERIES.md");
  ASSERT_TRUE(file);
  std::vector<std::string> listed;
  bool is_there = false;
  for (std::string line; std::getline(file, line);) {
    is_there = is_there || line.starts_with("| code | check |");
    if (is_there && line.starts_with("| `")) listed.push_back(line.substr(3, line.find('`', 3) - 3));
  }
  std::vector<std::string> known;
  for (int number = 1; number <= static_cast<int>(matching::Obstacle::unreachable); ++number) {
    known.emplace_back(to_string(static_cast<matching::Obstacle>(number)));
  }
  EXPECT_EQ(listed, known);
}

}  // namespace
}  // namespace geminga::participant
