// Chains through converters: which consumers are told of them, and what happens when converters come and go.
#include "discovery/matching/conversions/converters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/matching/conversions/converter.hpp"
#include "discovery/matching/conversions/converting_team.hpp"

namespace geminga::matching {
namespace {

using registry::PublicationEntry;
using registry::SubscriptionEntry;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Converter, IsReadFromItsAttributes) {
  const auto ontology = frames();
  const auto refusal = [&](const Attributes& attributes) {
    const auto error = check_conversion(attributes, ontology);
    return error ? std::to_string(std::to_underlying(error->code)) + " " + error->text : "";
  };
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({{"converts", "whatever"}}), "") << "an attribute and no more";
  EXPECT_EQ(refusal({{"converts", converts("A", "B")}}), "");
  EXPECT_EQ(refusal({{"converts", iri("A") + " > " + iri("B")}, {"cost", "1000000"}}), "");
  EXPECT_THAT(refusal({{"converts", iri("A") + ">"}}), HasSubstr("422 converts: "));
  EXPECT_THAT(refusal({{"converts", ">" + iri("A")}}), HasSubstr("is not FROM>TO"));
  EXPECT_THAT(refusal({{"converts", iri("A") + ">" + iri("B") + ">" + iri("C")}}), HasSubstr("is not FROM>TO"));
  EXPECT_THAT(refusal({{"converts", converts("A", "Z")}}), HasSubstr("422 converts: "));
  EXPECT_THAT(refusal({{"converts", converts("Ghost", "A")}}), HasSubstr("unsatisfiable"));
  for (const char* cost : {"0", "1000001", "-1", "1.5", "cheap", ""}) {
    EXPECT_THAT(refusal({{"converts", converts("A", "B")}, {"cost", cost}}), HasSubstr("422 cost: ")) << cost;
    EXPECT_FALSE(step_of({{"converts", converts("A", "B")}, {"cost", cost}}, ontology)) << cost;
  }
  const auto step = step_of({{"converts", converts("A", "B")}, {"cost", "7"}}, ontology);
  ASSERT_TRUE(step);
  EXPECT_EQ(step->from, *ontology.find_iri(iri("A")));
  EXPECT_EQ(step->to, *ontology.find_iri(iri("B")));
  EXPECT_EQ(step->cost, 7U);
  EXPECT_EQ(step_of({{"converts", converts("A", "B")}}, ontology)->cost, 1U);
  EXPECT_FALSE(step_of({{"converts", converts("A", "Z")}}, ontology));
  EXPECT_FALSE(step_of({{"converts", converts("A", "Ghost")}}, ontology));
  EXPECT_FALSE(step_of({{"converts", converts("A", "B")}}, {}));
  EXPECT_FALSE(check_conversion({{"converts", converts("A", "Z")}}, {})) << "nothing is looked up without an ontology";
}

TEST_F(ConvertersTest, AreStepsOfChainsAndOfTheirLife) {
  matcher.put(ball(key(2, 1, 2), "MyA"));
  matcher.put(asks(key(here, 1, 1), "D"));
  EXPECT_THAT(told(), IsEmpty());
  matcher.put(converter(key(3, 1, 2), "B", "C", 3));
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub add p2.1.2 converted 2 A>B>C>D 6 -,udp://10.0.0.3:6002/00000003/1/2,-"));
  matcher.put(converter(key(4, 1, 2), "B", "D", 4));
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub modify p2.1.2 converted 2 A>B>D 6 -,udp://10.0.0.4:6002/00000004/1/2"))
      << "it costs the same with as many converters, and is shorter";
}

TEST_F(ConvertersTest, GiveWayToWhatIsCheaperAndToNothingElse) {
  matcher.put(ball(key(2, 1, 2), "A"));
  matcher.put(asks(key(here, 1, 1), "B"));
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub add p2.1.2 converted 1 A>B 2 "));
  matcher.put(converter(key(3, 1, 2), "A", "B", 2));
  EXPECT_THAT(told(), IsEmpty()) << "what is declared is as cheap";
  matcher.put(converter(key(4, 1, 2), "A", "B", 1));
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub modify p2.1.2 converted 1 A>B 1 udp://10.0.0.4:6002/00000004/1/2"));
  matcher.put(converter(key(3, 1, 2), "A", "B", 1));
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub modify p2.1.2 converted 1 A>B 1 udp://10.0.0.3:6002/00000003/1/2"))
      << "of two that are equal the one that this host knew first";
  matcher.remove_publication(key(3, 1, 2), Reason::withdrawn);
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub modify p2.1.2 converted 1 A>B 1 udp://10.0.0.4:6002/00000004/1/2"));
  remove_participant(matcher, ParticipantId{4}, Reason::expired);
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub modify p2.1.2 converted 1 A>B 2 "));
}

TEST_F(ConvertersTest, TakeTheirMatchesWithThem) {
  matcher.put(ball(key(2, 1, 2), "E"));
  matcher.put(converter(key(3, 1, 2), "E", "F"));
  matcher.put(asks(key(here, 1, 1), "F"));
  EXPECT_THAT(told(), ElementsAre(HasSubstr("pub add p2.1.2 converted")));
  PublicationEntry moved = converter(key(3, 1, 2), "E", "F");
  moved.publication.port = 7000;
  matcher.put(moved);
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub modify p2.1.2 converted 1 E>F 1 udp://10.0.0.3:7000/00000003/1/2"));
  moved.publication.attributes["rate"] = "30";
  matcher.put(moved);
  EXPECT_THAT(told(), IsEmpty());
  moved.publication.attributes.erase("converts");
  matcher.put(moved);
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub del p2.1.2 changed"));
  matcher.put(converter(key(3, 1, 2), "E", "F"));
  EXPECT_THAT(told(), ElementsAre(HasSubstr("pub add p2.1.2")));
  matcher.begin_departure(ParticipantId{3}, Reason::expired);
  while (matcher.take_step()) {
  }
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub del p2.1.2 changed"));
}

TEST_F(ConvertersTest, TakeNoPartWhereTheyCannotBeReached) {
  matcher.put(ball(key(2, 1, 2), "E"));
  matcher.put(asks(key(here, 1, 1), "F"));
  PublicationEntry far = converter(key(3, 1, 2), "E", "F");
  far.is_reachable = false;
  matcher.put(far);
  EXPECT_THAT(told(), IsEmpty());
  far.is_reachable = true;
  matcher.put(far);
  EXPECT_THAT(told(), ElementsAre(HasSubstr("pub add p2.1.2 converted")));
  far.is_reachable = false;
  matcher.put(far);
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub del p2.1.2 changed"));
  SubscriptionEntry any = asks(key(here, 1, 1), "F");
  any.subscription.reach = RequiredReach::any;
  matcher.put(any);
  EXPECT_THAT(told(), ElementsAre(HasSubstr("pub add p2.1.2 converted")));
}

TEST_F(ConvertersTest, MayChangeWhatTheyTakeBehindAnotherStep) {
  Taxonomy taxonomy;
  taxonomy.sub("Ball", "Tracked").sub("A", "Frame").sub("B", "Above").sub("Above", "Frame").sub("C", "Frame");
  change_vocabulary(matcher, taxonomy.convert("A", "B", 2).classified());
  matcher.put(ball(key(2, 1, 2), "A"));
  matcher.put(asks(key(here, 1, 1), "C"));
  matcher.put(converter(key(3, 1, 2), "B", "C"));
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub add p2.1.2 converted 1 A>B>C 3 -,udp://10.0.0.3:6002/00000003/1/2"));
  matcher.put(converter(key(3, 1, 2), "Above", "C"));
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub modify p2.1.2 converted 2 A>B>C 3 -,udp://10.0.0.3:6002/00000003/1/2"));
}

TEST_F(ConvertersTest, TellTheProviderOfItsConsumer) {
  matcher.put(ball(key(here, 1, 2), "E"));
  matcher.put(asks(key(2, 1, 1), "F"));
  matcher.put(converter(key(3, 1, 2), "E", "F"));
  EXPECT_THAT(told(), ElementsAre("p1.1.2 sub add p2.1.1 converted 1"));
  matcher.remove_publication(key(3, 1, 2), Reason::left);
  EXPECT_THAT(told(), ElementsAre("p1.1.2 sub del p2.1.1 changed"));
}

TEST_F(ConvertersTest, CountInArbitrationByWhatTheyCost) {
  matcher.put(ball(key(2, 1, 2), "E"));
  matcher.put(ball(key(3, 1, 2), "G"));
  matcher.put(converter(key(4, 1, 2), "E", "F", 5));
  matcher.put(asks(key(here, 1, 1), "F", any_cost, 1));
  EXPECT_THAT(told(), ElementsAre(HasSubstr("add p2.1.2")));
  matcher.put(converter(key(4, 1, 4), "G", "F", 4));
  EXPECT_THAT(told(), ElementsAre(HasSubstr("add p3.1.2"), "p1.1.1 pub del p2.1.2 outranked"));
  matcher.remove_publication(key(4, 1, 4), Reason::withdrawn);
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub del p3.1.2 changed", HasSubstr("add p2.1.2")));
}

TEST_F(ConvertersTest, AreNoDearerThanWhatIsAccepted) {
  matcher.put(ball(key(2, 1, 2), "E"));
  matcher.put(asks(key(here, 1, 1), "F", 4));
  matcher.put(asks(key(here, 1, 3), "F", 5));
  matcher.put(asks(key(here, 1, 5), "F", 0));
  matcher.put(converter(key(3, 1, 2), "E", "F", 5));
  EXPECT_THAT(told(), ElementsAre(HasSubstr("p1.1.3 pub add p2.1.2")));
}

TEST_F(ConvertersTest, AreThoseThatTheConsumerTakesPartWith) {
  matcher.put(ball(key(2, 1, 2), "E"));
  const auto is_converted = [&](const SubscriptionEntry& asked, const PublicationEntry& by) {
    matcher.put(by);
    matcher.put(asked);
    const bool is_met = !matcher.choices().chosen(asked.key).empty();
    matcher.remove_subscription(asked.key, Reason::withdrawn);
    matcher.remove_publication(by.key, Reason::withdrawn);
    // The same, in the other order.
    matcher.put(asked);
    EXPECT_TRUE(matcher.choices().chosen(asked.key).empty());
    matcher.put(by);
    EXPECT_EQ(!matcher.choices().chosen(asked.key).empty(), is_met);
    matcher.remove_publication(by.key, Reason::withdrawn);
    EXPECT_TRUE(matcher.choices().chosen(asked.key).empty());
    matcher.remove_subscription(asked.key, Reason::withdrawn);
    return is_met;
  };
  const SubscriptionEntry usual = asks(key(here, 1, 1), "F");
  const PublicationEntry plain = converter(key(3, 1, 2), "E", "F");
  EXPECT_TRUE(is_converted(usual, plain));
  SubscriptionEntry asked = usual;
  asked.subscription.protocols = {"tcp"};
  EXPECT_FALSE(is_converted(asked, plain));
  asked.subscription.protocols = {"tcp", "udp"};
  EXPECT_TRUE(is_converted(asked, plain));
  asked = usual;
  asked.subscription.providers = {{.participant = "robot2", .peer = ""}};
  EXPECT_FALSE(is_converted(asked, plain));
  asked.subscription.providers.push_back({.participant = "robot3", .peer = ""});
  EXPECT_TRUE(is_converted(asked, plain));
  asked = usual;
  asked.subscription.scope = "any, !robot3";
  EXPECT_FALSE(is_converted(asked, plain));
  asked.subscription.where = "port < 5500";
  asked.subscription.scope = "";
  EXPECT_TRUE(is_converted(asked, plain)) << "a condition is about what is offered";
  PublicationEntry other = plain;
  other.publication.scope = "robot7";
  EXPECT_FALSE(is_converted(usual, other));
  other.publication.scope = "";
  other.publication.for_whom = "name = nobody";
  EXPECT_FALSE(is_converted(usual, other));
  other.publication.for_whom = "name = module*";
  EXPECT_TRUE(is_converted(usual, other));
  other.publication.mode = ChannelMode::one_to_many_stream;
  EXPECT_TRUE(is_converted(usual, other)) << "the mode is about what is offered";
}

TEST_F(ConvertersTest, AreEightStepsInOneChainAtMost) {
  // A>B is declared, C>D too.
  for (char from = 'B'; from < 'K'; ++from) {
    if (from == 'C') continue;
    const auto number = static_cast<std::uint32_t>(from);
    matcher.put(converter(key(3, 1, number), std::string(1, from), std::string(1, static_cast<char>(from + 1))));
  }
  matcher.put(ball(key(2, 1, 2), "A"));
  matcher.put(asks(key(here, 1, 1), "I"));
  EXPECT_THAT(told(), ElementsAre(HasSubstr("A>B>C>D>E>F>G>H>I 9 -,")));
  matcher.put(asks(key(here, 1, 3), "J"));
  EXPECT_THAT(told(), IsEmpty());
  matcher.put(converter(key(3, 1, 200), "A", "C"));
  EXPECT_THAT(told(), testing::UnorderedElementsAre(HasSubstr("p1.1.1 pub modify p2.1.2 converted 1 A>C>D"),
                                                    HasSubstr("p1.1.3 pub add p2.1.2 converted 1 A>C>D")));
}

TEST_F(ConvertersTest, LeadInCirclesWithoutEnd) {
  matcher.put(converter(key(3, 1, 2), "E", "E"));
  matcher.put(converter(key(3, 1, 4), "E", "F"));
  matcher.put(converter(key(3, 1, 6), "F", "E"));
  matcher.put(ball(key(2, 1, 2), "E"));
  matcher.put(asks(key(here, 1, 1), "G"));
  EXPECT_THAT(told(), IsEmpty());
  matcher.put(asks(key(here, 1, 3), "F"));
  EXPECT_THAT(told(), ElementsAre(HasSubstr("E>F 1 udp")));
}

TEST_F(ConvertersTest, GoWithWhatIsNotAConcept) {
  matcher.put(offer(key(2, 1, 2), semantic("Ball")));
  matcher.put(offer(key(2, 1, 4), TextIdentity{"ball"}));
  matcher.put(ball(key(2, 1, 6), "Unknown"));
  matcher.put(asks(key(here, 1, 1), "F"));
  matcher.put(asks(key(here, 1, 3), ""));
  static_cast<void>(told());
  matcher.put(converter(key(3, 1, 2), "Frame", "F"));
  EXPECT_THAT(told(), IsEmpty()) << "an offer that states no representation is never converted";
}

TEST_F(ConvertersTest, ChangeWithTheOntology) {
  matcher.put(ball(key(2, 1, 2), "E"));
  matcher.put(asks(key(here, 1, 1), "F"));
  matcher.put(converter(key(3, 1, 2), "E", "F", 3));
  static_cast<void>(told());
  Taxonomy other;
  other.sub("Ball", "Tracked").sub("E", "Frame").sub("F", "Frame").convert("E", "F", 2);
  change_vocabulary(matcher, other.classified());
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub modify p2.1.2 converted 1 E>F 2 "));
  Taxonomy without;
  without.sub("Ball", "Tracked").sub("E", "Frame").sub("F", "Frame");
  change_vocabulary(matcher, without.classified());
  EXPECT_THAT(told(), ElementsAre(HasSubstr("modify p2.1.2 converted 1 E>F 3 udp")));
  change_vocabulary(matcher, {});
  EXPECT_THAT(told(), ElementsAre("p1.1.1 pub del p2.1.2 changed"));
}

TEST(Converters, ForgetWhatTheyRemember) {
  const auto ontology = frames();
  Converters converters(ontology);
  const auto number = [&](std::string_view name) { return *ontology.find_iri(iri(name)); };
  const Consumer consumer{.entry = asks(key(here, 1, 1), "F"), .scope = Scope()};
  converters.put(converter(key(3, 1, 2), "E", "F"), {}, 1);
  const auto first = converters.chain(consumer, number("E"), number("F"));
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(converters.chain(consumer, number("E"), number("F")), first) << "it is remembered";
  EXPECT_EQ(converters.chain(consumer, number("F"), number("E")), nullptr);
  converters.erase(key(3, 1, 2));
  EXPECT_EQ(converters.chain(consumer, number("E"), number("F")), nullptr);
  EXPECT_TRUE(converters.is_empty());
  PublicationEntry ipv6 = converter(key(3, 1, 2), "E", "F");
  ipv6.publication.address = "fe80::1%eth0";
  ipv6.publication.protocol = "tcp";
  converters.put(ipv6, {}, 2);
  EXPECT_EQ(converters.chain(consumer, number("E"), number("F"))->via, "tcp://[fe80::1%eth0]:6002/00000003/1/2");
}

}  // namespace
}  // namespace geminga::matching
