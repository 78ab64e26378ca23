// How many converters take part in chains, and what it costs when they come and go.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/conversions/converters.hpp"
#include "discovery/matching/conversions/converting_team.hpp"
#include "discovery/matching/matcher.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using ConverterLimits = ConvertersTest;

TEST_F(ConverterLimits, OfOneParticipantAreSixteen) {
  matcher.put(ball(key(2, 1, 2), "E"));
  matcher.put(asks(key(here, 1, 1), "F"));
  for (std::uint32_t number = 0; number < max_converters_of_participant; ++number) {
    matcher.put(converter(key(3, 1, 2 + 2 * number), "I", "J"));
  }
  const ServiceKey late = key(3, 1, 100);
  matcher.put(converter(late, "E", "F"));
  EXPECT_THAT(told(), IsEmpty()) << "one too many";
  matcher.put(converter(key(4, 1, 2), "E", "F", 9));
  EXPECT_THAT(told(), ElementsAre(HasSubstr("add p2.1.2 converted 1 E>F 9")));
  PublicationEntry moved = converter(key(3, 1, 2), "I", "J");
  moved.publication.port = 9;
  matcher.put(moved);
  EXPECT_THAT(told(), IsEmpty()) << "who changes keeps his place";
  matcher.remove_publication(key(3, 1, 2), Reason::withdrawn);
  EXPECT_THAT(told(), ElementsAre(HasSubstr("modify p2.1.2 converted 1 E>F 1 ")));
}

TEST_F(ConverterLimits, OfOneParticipantAreThoseWithTheSmallestKeysInWhateverOrderTheyCome) {
  matcher.put(ball(key(2, 1, 2), "E"));
  matcher.put(asks(key(here, 1, 1), "F"));
  matcher.put(asks(key(here, 1, 3), "J"));
  matcher.put(ball(key(2, 1, 4), "I"));
  for (std::uint32_t number = 1; number < max_converters_of_participant; ++number) {
    matcher.put(converter(key(3, 1, 10 + 2 * number), "A", "B"));
  }
  matcher.put(converter(key(3, 2, 2), "E", "F"));
  EXPECT_THAT(told(), ElementsAre(HasSubstr("add p2.1.2 converted 1 E>F 1 ")));
  matcher.put(converter(key(3, 2, 4), "I", "J"));
  EXPECT_THAT(told(), IsEmpty()) << "one too many";
  matcher.put(converter(key(3, 1, 4), "I", "J"));
  EXPECT_THAT(told(), testing::UnorderedElementsAre("p1.1.1 pub del p2.1.2 changed",
                                                    HasSubstr("add p2.1.4 converted 1 I>J 1 ")));
  matcher.remove_publication(key(3, 1, 4), Reason::withdrawn);
  EXPECT_THAT(told(), testing::UnorderedElementsAre("p1.1.3 pub del p2.1.4 changed",
                                                    HasSubstr("add p2.1.2 converted 1 E>F 1 ")))
      << "the smaller of those that wait";
}

TEST_F(ConverterLimits, OfOtherHostsLeaveRoomForThoseOfThisOne) {
  matcher.put(ball(key(2, 1, 2), "E"));
  matcher.put(asks(key(here, 1, 1), "F"));
  std::uint32_t count = 0;
  for (; count < max_remote_converters; ++count) {
    matcher.put(converter(key(10 + count / 16, 1, 2 + 2 * (count % 16)), "I", "J"));
  }
  matcher.put(converter(key(9, 1, 2), "E", "F"));
  EXPECT_THAT(told(), IsEmpty()) << "one too many of other hosts";
  for (std::uint32_t own = 0; own < max_converters_of_participant; ++own) {
    matcher.put(converter(key(here, 2, 2 + 2 * own), "E", "F"));
  }
  EXPECT_THAT(told(), ElementsAre(HasSubstr("add p2.1.2 converted 1 E>F 1 udp://10.0.0.1:6002")));
  matcher.remove_peer(ParticipantId{here}, PeerId{2}, Reason::withdrawn);
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub del p2.1.2 changed"));
  matcher.remove_publication(key(11, 1, 2), Reason::withdrawn);
  EXPECT_THAT(told(), ElementsAre(HasSubstr("add p2.1.2 converted 1 E>F 1 udp://10.0.0.9:6002")));
}

TEST_F(ConverterLimits, TouchOnlyTheRequestsWhoseChainsTheyCanChange) {
  constexpr std::uint32_t many = 300;
  for (std::uint32_t number = 0; number < many; ++number) {
    matcher.put(ball(key(2, 1, 2 * number), "E"));
    matcher.put(asks(key(4, 1, 1 + 2 * number), "F", 0));  // accepts no conversion
    matcher.put(asks(key(5, 1, 1 + 2 * number), "G"));     // asks for what the converter does not lead to
    matcher.put(asks(key(6, 1, 1 + 2 * number), "F", 2));  // accepts less than it costs
    matcher.put(request(key(7, 1, 1 + 2 * number), semantic("Ball", "E")));
  }
  matcher.put(asks(key(here, 1, 1), "F"));
  static_cast<void>(told());
  const std::uint64_t judged = matcher.judged();
  matcher.put(converter(key(3, 1, 2), "E", "F", 3));
  EXPECT_LT(matcher.judged() - judged, many) << "one request may meet more than are looked at at once";
  while (matcher.take_step()) {
  }
  EXPECT_EQ(matcher.judged() - judged, many) << "each pair of the one request, once";
  EXPECT_EQ(told().size(), many);
  matcher.put(converter(key(3, 1, 4), "E", "F", 4));
  EXPECT_EQ(matcher.judged() - judged, many) << "the request is looked at, and no chain is another one";
  EXPECT_FALSE(matcher.has_steps());
  matcher.put(converter(key(3, 1, 6), "I", "J"));
  EXPECT_EQ(matcher.judged() - judged, many);
  matcher.put(ball(key(2, 2, 2), "I"));
  EXPECT_THAT(told(), IsEmpty());
}

TEST_F(ConverterLimits, JudgeManyInSteps) {
  matcher.put(ball(key(2, 1, 2), "E"));
  const auto count = static_cast<std::uint32_t>(max_rejudged_at_once) + 3;
  for (std::uint32_t number = 0; number < count; ++number) matcher.put(asks(key(here, 1, 1 + 2 * number), "F"));
  matcher.put(converter(key(3, 1, 2), "E", "F"));
  EXPECT_EQ(told().size(), max_rejudged_at_once);
  EXPECT_TRUE(matcher.has_steps());
  matcher.catch_up(key(here, 1, 1 + 2 * (count - 1)));
  EXPECT_EQ(told().size(), 1U);
  EXPECT_TRUE(matcher.take_step());
  EXPECT_EQ(told().size(), 1U);
  EXPECT_TRUE(matcher.take_step());
  EXPECT_FALSE(matcher.take_step());
  EXPECT_EQ(told().size(), 1U);
  EXPECT_FALSE(matcher.has_steps());
  matcher.begin_departure(ParticipantId{3}, Reason::expired);
  EXPECT_THAT(told(), IsEmpty());
  while (matcher.publications().find(key(3, 1, 2)) != nullptr) EXPECT_TRUE(matcher.take_step());
  // One of them changes before its step: it is told how things are, once.
  matcher.put(asks(key(here, 1, 1), "F", 7));
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub del p2.1.2 changed"));
  while (matcher.take_step()) {
  }
  EXPECT_EQ(told().size(), count - 1);
}

/// The work when one converter of other hosts goes and one of host 9 takes its place, while host 3 has so many that
/// wait.
std::uint64_t work_of_taking_turns(std::uint32_t that_wait) {
  Taxonomy taxonomy;
  taxonomy.sub("E", "Frame").sub("F", "Frame");
  const auto ontology = taxonomy.classified();
  Converters converters(ontology);
  std::uint64_t arrival = 0;
  const auto put = [&](const ServiceKey& one) { converters.put(converter(one, "E", "F"), {}, ++arrival); };
  for (std::uint32_t number = 0; number < max_converters_of_participant + that_wait; ++number) put(key(3, 1, number));
  for (std::uint32_t count = 16; count < max_remote_converters; ++count) put(key(10 + count / 16, 1, count % 16));
  put(key(9, 1, 1));
  EXPECT_EQ(converters.waiting_count(), that_wait + 1);
  static_cast<void>(converters.take_work());
  converters.erase(key(12, 1, 0));
  EXPECT_EQ(converters.waiting_count(), that_wait) << "one has got the place";
  const std::uint64_t work = converters.take_work();
  for (std::uint32_t number = 0; number < that_wait; ++number) converters.erase(key(3, 1, number));
  EXPECT_EQ(converters.waiting_count(), 0);
  converters.erase(key(9, 1, 1));
  put(key(50, 1, 0));
  EXPECT_EQ(converters.waiting_count(), 0) << "host 9 had got the place";
  put(key(51, 1, 0));
  EXPECT_EQ(converters.waiting_count(), 1);
  return work;
}

TEST(Converters, DoNotLookThroughAllThatWaitOfOneHost) {
  EXPECT_EQ(work_of_taking_turns(1000), work_of_taking_turns(0));
}

TEST(Converters, RememberSoManyAnswers) {
  Taxonomy taxonomy;
  constexpr int names = 65;
  static_assert(names * (names - 1) > static_cast<int>(Converters::max_remembered));
  const auto name = [](int number) { return "Frame" + std::to_string(number); };
  for (int number = 0; number < names; ++number) taxonomy.sub(name(number), "Frame");
  const auto ontology = taxonomy.classified();
  const auto number_of = [&](int number) { return *ontology.find_iri(iri(name(number))); };
  Converters converters(ontology);
  converters.put(converter(key(3, 1, 2), name(0), name(1)), {}, 1);
  const Consumer consumer{.entry = asks(key(here, 1, 1), name(1)), .scope = Scope()};
  const auto first = converters.chain(consumer, number_of(0), number_of(1));
  ASSERT_NE(first, nullptr);
  std::size_t remembered = 1;
  const auto ask_until = [&](std::size_t count) {
    for (int from = 0; from < names; ++from) {
      for (int to = 0; to < names && remembered < count; ++to) {
        if (from == to || (from == 0 && to == 1)) continue;
        EXPECT_EQ(converters.chain(consumer, number_of(from), number_of(to)), nullptr);
        ++remembered;
      }
    }
  };
  ask_until(Converters::max_remembered);
  EXPECT_EQ(converters.chain(consumer, number_of(0), number_of(1)), first);
  EXPECT_EQ(converters.chain(consumer, number_of(names - 1), number_of(names - 2)), nullptr) << "one more";
  const auto again = converters.chain(consumer, number_of(0), number_of(1));
  ASSERT_NE(again, nullptr);
  EXPECT_NE(again, first) << "all were forgotten";
  EXPECT_EQ(again->via, first->via);
}

}  // namespace
}  // namespace geminga::matching
