// SCOPE.md: the hosts and peers that a service or a request is meant for.
#include "discovery/matching/conditions/scope.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "discovery/matching/team.hpp"

namespace geminga::matching {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Identity ball = TextIdentity{"ball"};

/// Which of peer 1 (module1) on robot1, robot2 and robot12 the scope of a module on robot1 admits.
std::vector<std::string> admitted(const std::string& text) {
  const auto scope = Scope::parse(text);
  EXPECT_TRUE(scope) << text << ": " << scope.error().text;
  const Party own{key(1, 9, 9), "robot1", "module9"};
  std::vector<std::string> names;
  for (const std::uint32_t host : {1U, 2U, 12U}) {
    const std::string host_name = "robot" + std::to_string(host);
    if (scope && scope->admits(own, Party{key(host, 1, 1), host_name, "module1"})) names.push_back(host_name);
  }
  return names;
}

TEST(Scope, AdmitsWhoSuitsAnEntryAndNobodyWhoIsExcluded) {
  for (const char* all : {"", "any", "group", "any/module1", "any/1", "robot*", "*", "*/module*", "!robot3", "!any/2",
                          "host,!host/module2,robot*", " any , robot2 "}) {
    EXPECT_THAT(admitted(all), ElementsAre("robot1", "robot2", "robot12")) << all;
  }
  EXPECT_THAT(admitted("host"), ElementsAre("robot1"));
  EXPECT_THAT(admitted("host/module1"), ElementsAre("robot1"));
  EXPECT_THAT(admitted("host/module2"), IsEmpty());
  EXPECT_THAT(admitted("localhost/module1"), ElementsAre("robot1"));
  EXPECT_THAT(admitted("robot*/module1, !localhost/module1"), ElementsAre("robot2", "robot12"));
  EXPECT_THAT(admitted("!host"), ElementsAre("robot2", "robot12"));
  EXPECT_THAT(admitted("! host"), ElementsAre("robot2", "robot12"));
  EXPECT_THAT(admitted("robot1*,!host"), ElementsAre("robot12"));
  EXPECT_THAT(admitted("robot2,robot12"), ElementsAre("robot2", "robot12"));
  EXPECT_THAT(admitted("00000002"), ElementsAre("robot2"));
  EXPECT_THAT(admitted("0000000c/1"), ElementsAre("robot12"));
  EXPECT_THAT(admitted("any,!any"), IsEmpty());
  EXPECT_THAT(admitted("robot"), IsEmpty()) << "a name is no prefix";
  EXPECT_THAT(admitted("Host"), IsEmpty()) << "words have case";
}

TEST(Scope, ThatCannotBeReadIsRefused) {
  for (const char* text : {",", "host,", ",host", "!", "a/b/c", "a/", "/b", " ", "host,,any", "!!host", "! !host"}) {
    const auto error = check_scope(text);
    ASSERT_TRUE(error) << text;
    EXPECT_EQ(error->code, ErrorCode::impossible);
    EXPECT_THAT(error->text, HasSubstr("scope: ")) << text;
  }
  const auto entries = [](std::size_t count) {
    std::string text = "host";
    for (std::size_t i = 1; i < count; ++i) text += ",host";
    return text;
  };
  EXPECT_FALSE(check_scope(entries(max_scope_entries - 1)));
  EXPECT_FALSE(check_scope(entries(max_scope_entries)));
  EXPECT_TRUE(check_scope(entries(max_scope_entries + 1)));
}

TEST(Scope, OfEitherSideKeepsAPairApart) {
  for (const bool is_of_provider : {false, true}) {
    Matcher matcher;
    auto service = offer(key(2, 1, 1), ball);
    auto wish = request(key(here, 1, 1), ball);
    auto& scope = is_of_provider ? service.publication.scope : wish.subscription.scope;
    scope = "host";
    matcher.put(service);
    matcher.put(wish);
    EXPECT_THAT(told(matcher), IsEmpty());
    EXPECT_FALSE(matcher.search().is_served(wish));
    EXPECT_THAT(matcher.examination().why(wish, service).error(),
                is_of_provider ? "scope: the provider's, host, does not admit the consumer"
                               : "scope: the consumer's, host, does not admit the provider");
    scope = "!host";
    matcher.put(service);
    matcher.put(wish);
    EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub add p2.1.1 exact 0"));
    scope = "two//slashes";
    matcher.put(service);
    matcher.put(wish);
    EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 pub del p2.1.1 changed")) << "from the air; it admits nobody";
    EXPECT_EQ(matcher.examination().why(wish, service).error(), "scope: it cannot be read");
  }
}

TEST(Scope, AProviderMayHaveAConditionOnItsConsumers) {
  Matcher matcher;
  auto service = offer(key(here, 1, 1), ball, 0, ChannelMode::one_to_many_pubsub);
  service.publication.for_whom = "participant_name = robot* and rate <= 30 and not has protocol";
  auto wish = request(key(2, 1, 1), ball, 0, Degree::narrower, ChannelMode::one_to_many_pubsub);
  matcher.put(service);
  matcher.put(wish);
  EXPECT_THAT(told(matcher), IsEmpty());
  EXPECT_EQ(matcher.examination().why(wish, service).error(),
            "for: participant_name = robot* and rate <= 30 and not has protocol does not hold: rate is absent");
  wish.subscription.attributes["rate"] = "10";
  matcher.put(wish);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub add p2.1.1 exact 0"));
  wish.subscription.attributes["rate"] = "33";
  matcher.put(wish);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub del p2.1.1 changed"));
  service.publication.for_whom = "rate in (33)";
  matcher.put(service);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub add p2.1.1 exact 0"));
  service.publication.for_whom = "rate in";
  matcher.put(service);
  EXPECT_THAT(told(matcher), ElementsAre("p1.1.1 sub del p2.1.1 changed"));
  EXPECT_EQ(matcher.examination().why(wish, service).error(), "for: it cannot be read");
}

}  // namespace
}  // namespace geminga::matching
