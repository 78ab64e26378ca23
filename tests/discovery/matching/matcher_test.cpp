// The events of the matcher: its promises one by one.
#include "discovery/matching/matcher.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "discovery/matching/taxonomy.hpp"
#include "discovery/matching/team.hpp"
#include "identity/service_limits.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using enum ChannelMode;

const Identity ball = TextIdentity{"ball"};

TEST(Matcher, TellsAConsumerWhicheverComesFirst) {
  for (const bool offer_comes_first : {true, false}) {
    Matcher matcher;
    if (offer_comes_first) matcher.put(offer(key(2, 1, 7), ball));
    matcher.put(request(key(here, 1, 1), ball));
    if (!offer_comes_first) matcher.put(offer(key(2, 1, 7), ball));
    EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.7 exact 0"));
    EXPECT_THAT(told(matcher), IsEmpty());
  }
}

TEST(Matcher, AnEventCarriesTheWholeEntry) {
  Matcher matcher;
  auto entry = offer(key(2, 1, 7), ball, 3);
  entry.publication.address = "192.0.2.7";
  entry.publication.attributes["rate"] = "30";
  matcher.put(entry);
  matcher.put(request(key(here, 1, 1), ball));
  const auto events = matcher.take_events();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_TRUE(std::get<0>(events[0].about)->same_as(entry));
  EXPECT_EQ(events[0].to, key(here, 1, 1));
}

TEST(Matcher, APeerMayUseItsOwnService) {
  Matcher matcher;
  matcher.put(offer(key(here, 1, 1), ball));
  matcher.put(request(key(here, 1, 2), ball));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.2 pub add p1.1.1 exact 0", "p1.1.1 sub add p1.1.2 exact 0"));
}

TEST(Matcher, APutOfWhatIsThereOnlyMovesItsAge) {
  Matcher matcher;
  auto service = offer(key(2, 1, 7), ball);
  auto wish = request(key(3, 1, 8), ball);
  matcher.put(offer(key(here, 1, 2), ball));
  matcher.put(request(key(here, 1, 1), ball));
  matcher.put(service);
  matcher.put(wish);
  EXPECT_EQ(matcher.take_events().size(), 4U);
  service.updated = wish.updated = at(4);
  matcher.put(service);
  matcher.put(wish);
  EXPECT_THAT(told(matcher), IsEmpty());
  EXPECT_EQ(matcher.publications().find(key(2, 1, 7))->updated, at(4));
  EXPECT_EQ(matcher.subscriptions().find(key(3, 1, 8))->updated, at(4));
}

TEST(Matcher, ProvidersAreToldOfConsumersWhereTheModeNeedsIt) {
  for (const auto& [mode, is_told] :
       {std::pair(one_to_one, true), std::pair(one_to_many_pubsub, true), std::pair(one_to_many_stream, false)}) {
    Matcher matcher;
    matcher.put(offer(key(here, 1, 1), ball, 0, mode));
    matcher.put(request(key(2, 1, 8), ball, 0, Degree::narrower, mode));
    const auto events = told(matcher);
    if (is_told) {
      EXPECT_THAT(events, ElementsAre("p1.1.1 sub add p2.1.8 exact 0")) << to_string(mode);
    } else {
      EXPECT_THAT(events, IsEmpty()) << to_string(mode);
    }
    remove_participant(matcher, ParticipantId{2}, Reason::left);
    EXPECT_EQ(told(matcher).size(), is_told ? 1U : 0U) << to_string(mode);
  }
}

TEST(Matcher, AProviderIsToldOnlyOfConsumersThatChooseIt) {
  Matcher matcher;
  matcher.put(offer(key(here, 1, 1), ball, 1));
  matcher.put(offer(key(2, 1, 1), ball, 2));
  matcher.put(request(key(3, 1, 8), ball, 1));
  EXPECT_THAT(told(matcher), IsEmpty()) << "the consumer takes the other one";
  remove_participant(matcher, ParticipantId{2}, Reason::expired);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub add p3.1.8 exact 0"));
  matcher.put(offer(key(2, 1, 1), ball, 2));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub del p3.1.8 outranked"));
}

TEST(Matcher, ARemoteConsumerOfVeryManyProvidersIsToldToAllOfThem) {
  for (const auto& [limit, is_told] : {std::pair(15U, false), std::pair(16U, false), std::pair(17U, true)}) {
    Matcher matcher;
    for (std::uint32_t number = 0; number < 17; ++number) matcher.put(offer(key(2, 1, number), ball, 2));
    matcher.put(offer(key(here, 1, 1), ball, 1));
    matcher.put(request(key(3, 1, 8), ball, limit));
    EXPECT_EQ(matcher.take_events().size(), is_told ? 1U : 0U) << limit;
  }
}

TEST(Matcher, OneThatFellBehindAllOthersIsNotForgotten) {
  Matcher matcher;
  matcher.put(request(key(here, 1, 1), ball, 1));
  matcher.put(offer(key(3, 1, 1), ball, 9));
  for (std::uint32_t number = 0; number < 30; ++number) matcher.put(offer(key(2, 1, number), ball, 1));
  matcher.put(offer(key(3, 1, 1), ball, 0));
  matcher.put(offer(key(3, 1, 1), ball, -1));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p3.1.1 exact 0", "p1.1.1 pub add p2.1.0 exact 0",
                                         "p1.1.1 pub del p3.1.1 outranked"));
  remove_participant(matcher, ParticipantId{2}, Reason::left);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.0 left", "p1.1.1 pub add p3.1.1 exact 0"));
}

TEST(Matcher, ModesAreNotMixed) {
  Matcher matcher;
  matcher.put(offer(key(2, 1, 1), ball, 0, one_to_many_stream));
  matcher.put(request(key(here, 1, 1), ball, 0, Degree::narrower, one_to_many_pubsub));
  EXPECT_THAT(told(matcher), IsEmpty());
}

TEST(Matcher, NothingThatIsAboutToGoTakesAnothersPlace) {
  Matcher matcher;
  matcher.put(offer(key(2, 1, 1), ball, 3));
  matcher.put(offer(key(2, 1, 2), ball, 2));
  matcher.put(offer(key(3, 1, 1), ball, 1));
  matcher.put(request(key(here, 1, 1), ball, 1));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
  remove_participant(matcher, ParticipantId{2}, Reason::left);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.1 left", "p1.1.1 pub add p3.1.1 exact 0"));
}

TEST(Matcher, AConsumerHasTheBetterServiceBeforeTheOutrankedOneGoes) {
  Matcher matcher;
  matcher.put(request(key(here, 1, 1), ball, 1));
  matcher.put(offer(key(2, 1, 1), ball, 1));
  matcher.put(offer(key(3, 1, 1), ball, 1));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 exact 0")) << "a tie changes nothing";
  matcher.put(offer(key(3, 1, 1), ball, 2));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p3.1.1 exact 0", "p1.1.1 pub del p2.1.1 outranked"));
}

TEST(Matcher, ADelCarriesTheServiceAsItWasLastTold) {
  Matcher matcher;
  matcher.put(request(key(here, 1, 1), ball));
  matcher.put(offer(key(2, 1, 1), ball, 4));
  told(matcher);
  matcher.put(offer(key(2, 1, 1), TextIdentity{"goal"}, 9));
  const auto events = matcher.take_events();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(in_words(events[0]), "p1.1.1 pub del p2.1.1 changed");
  EXPECT_TRUE(std::get<0>(events[0].about)->same_as(offer(key(2, 1, 1), ball, 4)));
}

TEST(Matcher, AModifiedServiceIsToldOnceAndOnlyToThoseWhoHaveIt) {
  Matcher matcher;
  matcher.put(request(key(here, 1, 1), ball));
  matcher.put(request(key(here, 1, 2), TextIdentity{"goal"}));
  matcher.put(offer(key(2, 1, 1), ball));
  told(matcher);
  auto changed = offer(key(2, 1, 1), ball);
  changed.publication.port = 6000;
  matcher.put(changed);
  matcher.put(changed);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub modify p2.1.1 exact 0"));
}

TEST(Matcher, AModifiedSubscriptionIsToldToItsProvidersNotToItself) {
  Matcher matcher;
  matcher.put(offer(key(here, 1, 1), ball));
  matcher.put(request(key(here, 2, 1), ball));
  told(matcher);
  auto changed = request(key(here, 2, 1), ball);
  changed.subscription.port = 7000;
  matcher.put(changed);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub modify p1.2.1 exact 0"));
}

TEST(Matcher, ASubscriptionThatAsksForSomethingElseLosesAndGains) {
  Matcher matcher;
  matcher.put(offer(key(2, 1, 1), ball));
  matcher.put(offer(key(2, 1, 2), TextIdentity{"goal"}));
  matcher.put(offer(key(here, 9, 1), ball));
  matcher.put(request(key(here, 1, 1), ball));
  told(matcher);
  matcher.put(request(key(here, 1, 1), TextIdentity{"goal"}));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p1.9.1 changed", "p1.9.1 sub del p1.1.1 changed",
                                         "p1.1.1 pub del p2.1.1 changed", "p1.1.1 pub add p2.1.2 exact 0"));
}

TEST(Matcher, ItsOwnEndIsNotToldToAPeer) {
  Matcher matcher;
  matcher.put(offer(key(here, 1, 1), ball));
  matcher.put(request(key(here, 1, 2), ball));
  matcher.put(request(key(here, 2, 1), ball));
  told(matcher);
  matcher.remove_peer(ParticipantId{here}, PeerId{1}, Reason::withdrawn);
  EXPECT_THAT(told(matcher), ElementsAre("p1.2.1 pub del p1.1.1 withdrawn"));
  EXPECT_FALSE(matcher.remove_publication(key(here, 1, 1), Reason::withdrawn));
  EXPECT_FALSE(matcher.remove_subscription(key(here, 1, 2), Reason::withdrawn));
  EXPECT_TRUE(matcher.remove_subscription(key(here, 2, 1), Reason::withdrawn));
  EXPECT_THAT(told(matcher), IsEmpty());
}

TEST(Matcher, ProvidersAreFilteredByIdAndByName) {
  const std::vector<std::pair<ProviderFilter, bool>> cases{{{"00000002", ""}, true},        {{"robot2", ""}, true},
                                                           {{"00000003", ""}, false},       {{"robot3", ""}, false},
                                                           {{"robot2", "module5"}, true},   {{"robot2", "5"}, true},
                                                           {{"00000002", "module5"}, true}, {{"robot2", "6"}, false},
                                                           {{"robot2", "module6"}, false},  {{"2", ""}, false},
                                                           {{"ROBOT2", ""}, false},         {{"", "module5"}, true}};
  for (const auto& [filter, fits] : cases) {
    Matcher matcher;
    matcher.put(offer(key(2, 5, 1), ball));
    auto wish = request(key(here, 1, 1), ball);
    wish.subscription.providers = {filter};
    matcher.put(wish);
    EXPECT_EQ(matcher.take_events().size(), fits ? 1U : 0U) << filter.participant << '/' << filter.peer;
    wish.subscription.providers = {{"nobody", ""}, filter};
    matcher.put(wish);
    EXPECT_EQ(matcher.search().is_served(wish), fits) << filter.participant << '/' << filter.peer;
  }
}

TEST(Matcher, AFilterDecidesAndAnUnreadableOneNeverMatches) {
  Matcher matcher;
  auto service = offer(key(2, 1, 1), ball);
  service.publication.attributes["rate"] = "30";
  matcher.put(service);
  auto wish = request(key(here, 1, 1), ball);
  wish.subscription.where = "rate >= 30";
  matcher.put(wish);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
  service.publication.attributes["rate"] = "29";
  matcher.put(service);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.1 changed"));
  wish.subscription.where = "rate >=";
  matcher.put(wish);
  EXPECT_THAT(told(matcher), IsEmpty());
  EXPECT_FALSE(matcher.search().is_served(wish));
}

TEST(Matcher, CollidingIdentitiesNeverMatchInWhateverOrderTheyCome) {
  const std::vector<Identity> names{
      TextIdentity{"service-3352"},
      TextIdentity{"service-724358"},
      NumericIdentity{0x9ddb3b5f},
      SemanticIdentity{"http://example.org/team#Concept77900", "http://example.org/team#Frame"},
      SemanticIdentity{"http://example.org/team#Concept122468", "http://example.org/team#Frame"},
      NumericIdentity{0x4eb69222}};
  ASSERT_EQ(id32(names[0]), id32(names[1]));
  ASSERT_EQ(id32(names[3]), id32(names[4]));
  // Two services and two requests with colliding names, in each of the 24 orders.
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = 0; j < names.size(); ++j) {
      if (i == j || is_number_of(names[i], names[j]) || is_number_of(names[j], names[i])) continue;
      std::vector<int> order{0, 1, 2, 3};
      do {
        Matcher matcher;
        for (const int step : order) {
          if (step == 0) matcher.put(offer(key(2, 1, 1), names[i]));
          if (step == 1) matcher.put(offer(key(2, 1, 2), names[j]));
          if (step == 2) matcher.put(request(key(here, 1, 1), names[i]));
          if (step == 3) matcher.put(request(key(here, 1, 2), names[j]));
        }
        auto words = told(matcher);
        std::ranges::sort(words);
        EXPECT_THAT(words, ElementsAre("p1.1.1 pub add p2.1.1 exact 0", "p1.1.2 pub add p2.1.2 exact 0"))
            << i << ' ' << j;
      } while (std::ranges::next_permutation(order).found);
    }
  }
}

TEST(Matcher, AProviderFollowsTheChoiceThatItsConsumerAnnounces) {
  Matcher matcher;
  auto wish = request(key(2, 1, 1), ball, 1);
  matcher.put(wish);
  matcher.put(offer(key(here, 1, 1), ball));
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub add p2.1.1 exact 0"));
  // By its own view the smaller key would win.
  wish.subscription.chosen = {key(3, 1, 1)};
  matcher.put(wish);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub del p2.1.1 outranked"));
  matcher.put(offer(key(3, 1, 1), ball, -5));
  EXPECT_THAT(told(matcher), IsEmpty());
  wish.subscription.chosen = {key(here, 1, 1), key(3, 1, 1)};
  matcher.put(wish);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub add p2.1.1 exact 0"));
  wish.subscription.chosen = {key(here, 1, 1)};
  matcher.put(wish);
  EXPECT_THAT(told(matcher), IsEmpty()) << "nothing that the provider sees has changed";
  matcher.remove_publication(key(3, 1, 1), Reason::left);
  wish.subscription.chosen = {};
  matcher.put(wish);
  EXPECT_THAT(told(matcher), IsEmpty()) << "it was chosen, and is the only one now";
}

TEST(Matcher, AnnouncesAChoiceOnlyWhereItHadToChoose) {
  Matcher matcher;
  matcher.put(request(key(here, 1, 1), ball, 1));
  EXPECT_FALSE(matcher.take_choice_change());
  matcher.put(offer(key(3, 1, 1), ball));
  EXPECT_FALSE(matcher.take_choice_change());
  matcher.put(offer(key(2, 1, 1), ball));
  EXPECT_TRUE(matcher.take_choice_change());
  EXPECT_FALSE(matcher.take_choice_change());
  EXPECT_THAT(matcher.choices().announced(key(here, 1, 1)), ElementsAre(key(3, 1, 1))) << "it was there first";
  matcher.put(offer(key(2, 1, 1), ball, 1));
  EXPECT_TRUE(matcher.take_choice_change());
  EXPECT_THAT(matcher.choices().announced(key(here, 1, 1)), ElementsAre(key(2, 1, 1)));
  matcher.remove_publication(key(3, 1, 1), Reason::left);
  EXPECT_TRUE(matcher.take_choice_change());
  EXPECT_THAT(matcher.choices().announced(key(here, 1, 1)), IsEmpty());
  // Requests whose providers are not told, that take all, and that take more than are announced.
  matcher.put(request(key(here, 1, 2), ball, 0));
  matcher.put(request(key(here, 1, 3), ball, 1, Degree::narrower, one_to_many_stream));
  matcher.put(request(key(here, 1, 4), ball, max_announced_choice));
  matcher.put(request(key(here, 1, 5), ball, max_announced_choice + 1));
  for (std::uint32_t host = 3; host < 3 + max_announced_choice + 2; ++host) {
    matcher.put(offer(key(host, 1, 1), ball));
    matcher.put(offer(key(host, 1, 2), ball, 0, one_to_many_stream));
  }
  EXPECT_THAT(matcher.choices().announced(key(here, 1, 2)), IsEmpty());
  EXPECT_THAT(matcher.choices().announced(key(here, 1, 3)), IsEmpty());
  EXPECT_EQ(matcher.choices().announced(key(here, 1, 4)).size(), max_announced_choice);
  EXPECT_THAT(matcher.choices().announced(key(here, 1, 5)), IsEmpty());
}

TEST(Matcher, OnlyTheProtocolsThatAreAskedForMatch) {
  Matcher matcher;
  auto service = offer(key(2, 1, 1), ball);
  service.publication.protocol = "tcp";
  auto wish = request(key(here, 1, 1), ball);
  wish.subscription.protocols = {"udp", "rtp"};
  matcher.put(service);
  matcher.put(wish);
  EXPECT_THAT(told(matcher), IsEmpty());
  EXPECT_FALSE(matcher.search().is_served(wish));
  EXPECT_EQ(matcher.examination().why(wish, service).error(), "protocol: tcp is offered, and none of those asked for");
  wish.subscription.protocols = {"udp", "tcp"};
  matcher.put(wish);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
  service.publication.protocol = "TCP";
  matcher.put(service);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.1 changed")) << "a protocol is a word with case";
}

}  // namespace
}  // namespace geminga::matching
