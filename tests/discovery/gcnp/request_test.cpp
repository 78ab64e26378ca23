#include "discovery/gcnp/request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>

#include "discovery/gcnp/limits.hpp"
#include "discovery/gcnp/reserved.hpp"

namespace geminga::gcnp {
namespace {

using testing::HasSubstr;

std::expected<Request, Error> read(const std::string& line) {
  const auto statement = parse(line);
  EXPECT_TRUE(statement) << line;
  return statement ? read_request(*statement) : std::unexpected(statement.error().error);
}

/// The error of a line with a value of this length behind a key.
std::optional<Error> error_with(const std::string& before, std::size_t length) {
  const auto request = read(before + std::string(length, 'x'));
  return request ? std::nullopt : std::optional(request.error());
}

TEST(Request, OfAPublicationHasItsDefaults) {
  const auto request = read("5 pub create mode=otm/stream concept=s:Ball port=5000");
  ASSERT_TRUE(request);
  NamedPublication expected;
  expected.mode = ChannelMode::one_to_many_stream;
  expected.identity = ConceptNames{"s:Ball", ""};
  expected.port = 5000;
  EXPECT_EQ(std::get<PubCreate>(*request).publication, expected);
  EXPECT_EQ(expected.protocol, "udp");
}

TEST(Request, OfASubscriptionHasTheLimitOfItsModeUnlessTold) {
  const auto limit_of = [](const std::string& line) {
    const auto request = read(line);
    return with_identity(std::get<SubCreate>(*request).subscription, NumericIdentity{7}).limit;
  };
  EXPECT_EQ(limit_of("5 sub create mode=oto id=7"), 1U);
  EXPECT_EQ(limit_of("5 sub create mode=otm/stream id=7"), 0U);
  EXPECT_EQ(limit_of("5 sub create mode=otm/pubsub id=7"), 0U);
  EXPECT_EQ(limit_of("5 sub create mode=oto id=7 limit=0"), 0U);
  EXPECT_EQ(limit_of("5 sub create mode=otm/stream id=7 limit=3"), 3U);
}

TEST(Request, KeepsEveryFieldWhenItsIdentityIsResolved) {
  const auto pub = read("5 pub create mode=oto id=7 port=5 address=::1 protocol=tcp priority=-2 a=b");
  const Publication publication = with_identity(std::get<PubCreate>(*pub).publication, TextIdentity{"t"});
  EXPECT_EQ(publication, (Publication{ChannelMode::one_to_one, TextIdentity{"t"}, "::1", 5, "tcp", -2, {{"a", "b"}}}));
  const auto sub =
      read("5 sub create mode=oto id=7 port=5 address=::1 match=exact provider=a/b where=x limit=9 priority=3 a=b");
  const Subscription subscription = with_identity(std::get<SubCreate>(*sub).subscription, TextIdentity{"t"});
  EXPECT_EQ(
      subscription,
      (Subscription{
          ChannelMode::one_to_one, TextIdentity{"t"}, Degree::exact, {{"a", "b"}}, "x", 9, 3, 5, "::1", {{"a", "b"}}}));
}

TEST(Request, OfAModifyChangesOnlyWhatIsGiven) {
  Publication publication{ChannelMode::one_to_one, NumericIdentity{7}, "::1", 5, "tcp", -2, {{"a", "b"}, {"c", "d"}}};
  apply(std::get<PubModify>(*read("5 pub modify")), publication);
  EXPECT_EQ(publication,
            (Publication{ChannelMode::one_to_one, NumericIdentity{7}, "::1", 5, "tcp", -2, {{"a", "b"}, {"c", "d"}}}));
  apply(std::get<PubModify>(
            *read("5 pub modify mode=otm/stream address=\"\" port=6 protocol=udp priority=1 a=x e=f id=8")),
        publication);
  EXPECT_EQ(
      publication,
      (Publication{
          ChannelMode::one_to_many_stream, NumericIdentity{7}, "", 6, "udp", 1, {{"a", "x"}, {"c", "d"}, {"e", "f"}}}));
  Subscription subscription;
  subscription.where = "x";
  subscription.providers = {{"a", ""}};
  apply(std::get<SubModify>(*read("5 sub modify match=broader where=\"\" provider=\"\" limit=4")), subscription);
  EXPECT_EQ(subscription.weakest, Degree::broader);
  EXPECT_EQ(subscription.where, "");
  EXPECT_TRUE(subscription.providers.empty());
  EXPECT_EQ(subscription.limit, 4U);
}

TEST(Request, SaysWhatConversionsMayCost) {
  const auto accepted = [](const std::string& words) {
    const auto request = read("5 sub create mode=oto concept=s:Ball " + words);
    EXPECT_TRUE(request) << words;
    if (!request) return std::uint32_t{7};
    EXPECT_EQ(read_request(to_statement(5, *request)), request);
    return std::get<SubCreate>(*request).subscription.convert;
  };
  EXPECT_EQ(accepted(""), 0U);
  EXPECT_EQ(accepted("convert=no"), 0U);
  EXPECT_EQ(accepted("convert=0"), 0U);
  EXPECT_EQ(accepted("convert=1"), 1U);
  EXPECT_EQ(accepted("convert=4294967294"), 4294967294U);
  EXPECT_EQ(accepted("convert=4294967295"), any_cost);
  EXPECT_EQ(accepted("convert=yes"), any_cost);
  Subscription subscription;
  apply(std::get<SubModify>(*read("5 sub modify convert=3")), subscription);
  EXPECT_EQ(subscription.convert, 3U);
  apply(std::get<SubModify>(*read("5 sub modify limit=3")), subscription);
  EXPECT_EQ(subscription.convert, 3U);
  apply(std::get<SubModify>(*read("5 sub modify convert=no")), subscription);
  EXPECT_EQ(subscription.convert, 0U);
}

TEST(Request, OfAModifyMayNameARepresentationAlone) {
  const auto request = read("5 pub modify representation=s:Polar");
  ASSERT_TRUE(request);
  EXPECT_EQ(std::get<PubModify>(*request).identity, (IdentityChange{ConceptChange{std::nullopt, "s:Polar"}}));
}

TEST(Request, RefusesEveryReservedKeyAsAnAttributeWithoutItsPrefix) {
  for (const auto key : reserved_keys) {
    const std::string line = "5 pub create mode=oto text=t port=1 ";
    const std::string word(key);
    const auto request = read(line + word + "=3");
    if (request) {
      EXPECT_THAT((std::vector<std::string_view>{"priority", "protocol", "scope", "for"}), testing::Contains(key));
    } else if (key != "address") {
      EXPECT_EQ(request.error().code, ErrorCode::malformed) << word;
    }
    EXPECT_TRUE(read(line + "my-" + word + "=3")) << word;
    const auto prefixed = read(line + "attr." + word + "=3");
    ASSERT_TRUE(prefixed) << word;
    EXPECT_EQ(std::get<PubCreate>(*prefixed).publication.attributes, (Attributes{{word, "3"}}));
  }
}

/// Every word that is one slip away from `key`.
std::vector<std::string> slips_of(const std::string& key) {
  std::vector<std::string> slips;
  for (std::size_t i = 0; i <= key.size(); ++i) slips.push_back(key.substr(0, i) + 'q' + key.substr(i));
  for (std::size_t i = 0; i < key.size(); ++i) {
    slips.push_back(key.substr(0, i) + key.substr(i + 1));
    slips.push_back(key.substr(0, i) + 'q' + key.substr(i + 1));
    slips.push_back(key.substr(0, i) + static_cast<char>(std::toupper(key[i])) + key.substr(i + 1));
    if (i > 0) slips.push_back(key.substr(0, i - 1) + key[i] + key[i - 1] + key.substr(i + 1));
  }
  slips.push_back(key + 's');
  std::erase_if(slips, [](const std::string& slip) { return is_reserved(slip); });
  return slips;
}

TEST(Request, TakesNoMistypedKeyForAnAttribute) {
  for (const auto key : reserved_keys) {
    for (const std::string& slip : slips_of(std::string(key))) {
      for (const std::string before :
           {"5 pub create mode=oto id=1 port=1 ", "5 pub modify ", "5 sub create mode=oto id=1 ", "5 sub modify "}) {
        const auto request = read(before + slip + "=1");
        ASSERT_FALSE(request) << before << slip;
        EXPECT_EQ(request.error().code, ErrorCode::malformed) << slip;
        EXPECT_THAT(request.error().text, HasSubstr("did you mean ")) << slip;
        EXPECT_TRUE(read(before + "attr." + slip + "=1")) << slip;
      }
    }
  }
}

TEST(Request, TakesAConversionForAnAttributeOfAPublication) {
  for (const std::string before :
       {"5 pub create mode=oto id=1 port=1 ", "5 pub modify ", "9 query why text=a offer.text=a offer."}) {
    const auto bare = read(before + "converts=a>b");
    ASSERT_TRUE(bare) << before;
    EXPECT_EQ(*bare, *read(before + "attr.converts=a>b")) << before;
    EXPECT_TRUE(read(before + "converts=\"\"")) << "nothing any more";
    EXPECT_FALSE(read(before + "converts=a"));
    EXPECT_TRUE(read(before + "attr.converts=a")) << "an attribute and no more";
    EXPECT_FALSE(read(before + "convers=a>b"));
    EXPECT_FALSE(read(before + "converts=a>" + std::string(max_attribute_value_bytes - 1, 'b')));
    EXPECT_TRUE(read(before + "converts=a>" + std::string(max_attribute_value_bytes - 2, 'b')));
  }
  EXPECT_FALSE(read("5 sub create mode=oto id=1 converts=a>b"));
}

TEST(Request, SaysWhichKeyWasMeant) {
  const auto text = [](const std::string& line) { return read(line).error().text; };
  EXPECT_EQ(text("5 sub create mode=oto id=1 wehre=\"rate > 50\""),
            "wehre is no key: did you mean where?; an attribute of this name is written attr.wehre");
  EXPECT_THAT(text("5 sub modify Where=x"), HasSubstr("did you mean where?"));
  EXPECT_THAT(text("5 pub create mode=oto id=1 port=1 ports=2"), HasSubstr("did you mean port?"));
  EXPECT_THAT(text("5 pub create mode=oto id=1 port=1 Attr.rate=2"), HasSubstr("did you mean attr.rate?"));
  EXPECT_THAT(text("5 pub create mode=oto id=1 port=1 where=x"), HasSubstr("is written attr.where"));
  EXPECT_EQ(text("5 query match limti=3"), "limti is no key of query match: did you mean limit?");
  EXPECT_EQ(text("5 query services colour=red"), "colour is no key of query services");
  EXPECT_THAT(text("5 sub create mode=oto id=1 convert=perhaps"), HasSubstr("yes, no or the largest cost"));
  EXPECT_THAT(text("5 sub create mode=oto id=1 match=converted"),
              HasSubstr("exact, equivalent, narrower, broader or overlapping"));
}

TEST(Request, KeepsTheBareFormOfWhatIsNearNoKey) {
  for (const std::string name : {"rate", "range", "frame", "camera", "colour", "shirt", "note", "period", "purpose",
                                 "calibrated", "resolution", "fps", "side", "team", "role", "size", "a", "k1", "x.y"}) {
    const auto request = read("5 pub create mode=oto id=1 port=1 " + name + "=1");
    ASSERT_TRUE(request) << name << ": " << request.error().text;
    EXPECT_EQ(to_line(to_statement(5, *request)), "5 pub create mode=oto id=1 port=1 " + name + "=1\r\n");
  }
}

TEST(Request, AsksForProtocols) {
  const auto create = read("5 sub create mode=oto id=1 protocol=udp,tcp");
  ASSERT_TRUE(create);
  EXPECT_EQ(std::get<SubCreate>(*create).subscription.protocols, (std::vector<std::string>{"udp", "tcp"}));
  Subscription subscription = with_identity(std::get<SubCreate>(*create).subscription, NumericIdentity{1});
  apply(std::get<SubModify>(*read("5 sub modify limit=1")), subscription);
  EXPECT_EQ(subscription.protocols.size(), 2U);
  apply(std::get<SubModify>(*read("5 sub modify protocol=\"\"")), subscription);
  EXPECT_TRUE(subscription.protocols.empty());
  for (const char* bad : {",", "udp,", ",udp", "udp,,tcp"}) {
    EXPECT_EQ(read("5 sub create mode=oto id=1 protocol=" + std::string(bad)).error().code, ErrorCode::malformed)
        << bad;
  }
  const auto count = [](std::size_t words) {
    std::string list = "p";
    for (std::size_t i = 1; i < words; ++i) list += ",p";
    return read("5 sub create mode=oto id=1 protocol=" + list);
  };
  EXPECT_TRUE(count(max_accepted_protocols - 1));
  EXPECT_TRUE(count(max_accepted_protocols));
  EXPECT_EQ(count(max_accepted_protocols + 1).error().code, ErrorCode::too_large);
}

TEST(Request, HasTextsUpToTheirLimits) {
  const struct {
    std::string before;
    std::size_t limit;
  } cases[] = {
      {"5 pub create mode=oto port=1 concept=", max_concept_bytes},
      {"5 pub create mode=oto port=1 concept=c representation=", max_concept_bytes},
      {"5 pub create mode=oto port=1 text=", max_text_identity_bytes},
      {"5 pub create mode=oto port=1 id=1 protocol=", max_protocol_bytes},
      {"5 pub create mode=oto port=1 id=1 key=", max_attribute_value_bytes},
      {"5 pub create mode=oto port=1 id=1 ", max_attribute_key_bytes},
      {"5 pub create mode=oto port=1 id=1 attr.", max_attribute_key_bytes},
      {"5 sub create mode=oto id=1 protocol=udp,", max_protocol_bytes},
      {"5 sub create mode=oto id=1 where=", max_where_bytes},
      {"5 sub create mode=oto id=1 prefer=", max_prefer_bytes},
      {"5 sub create mode=oto id=1 rank=", max_rank_bytes},
      {"5 sub create mode=oto id=1 scope=", max_scope_bytes},
      {"5 sub create mode=oto id=1 on=", max_concept_bytes},
      {"5 pub create mode=oto id=1 port=1 scope=", max_scope_bytes},
      {"5 pub create mode=oto id=1 port=1 for=", max_where_bytes},
      {"5 sub create mode=oto id=1 provider=", max_name_bytes},
      {"5 sub create mode=oto id=1 provider=a/", max_name_bytes},
      {"5 query services filter=", max_filter_bytes},
      {"5 query explain super=s sub=", max_concept_bytes},
  };
  for (const auto& [before, limit] : cases) {
    EXPECT_EQ(error_with(before, limit - 1), std::nullopt) << before;
    EXPECT_EQ(error_with(before, limit), std::nullopt) << before;
    const auto error = error_with(before, limit + 1);
    ASSERT_TRUE(error) << before;
    EXPECT_EQ(error->code, ErrorCode::too_large) << before;
    EXPECT_THAT(error->text, HasSubstr(std::to_string(limit))) << before;
  }
}

TEST(Request, HasAsManyAttributesAndProvidersAsTheirLimits) {
  const auto attributes = [](std::size_t count) {
    std::string line = "5 pub create mode=oto port=1 id=1";
    for (std::size_t i = 0; i < count; ++i) line += " k" + std::to_string(i) + "=v";
    return read(line);
  };
  EXPECT_TRUE(attributes(max_attributes - 1));
  EXPECT_TRUE(attributes(max_attributes));
  EXPECT_EQ(attributes(max_attributes + 1).error().code, ErrorCode::too_large);
  const auto providers = [](std::size_t count) {
    std::string line = "5 sub create mode=oto id=1 provider=p";
    for (std::size_t i = 1; i < count; ++i) line += ",p" + std::to_string(i);
    return read(line);
  };
  EXPECT_TRUE(providers(max_provider_filters - 1));
  EXPECT_TRUE(providers(max_provider_filters));
  EXPECT_EQ(providers(max_provider_filters + 1).error().code, ErrorCode::too_large);
}

TEST(Request, HasListsWithBlanksBetweenTheirEntries) {
  const auto create = std::get<SubCreate>(*read(
      "5 sub create mode=oto id=1 provider=\"robot1, robot 2/left eye ,r3\" favour=\" a , b\" protocol=\"udp, tcp\""));
  EXPECT_THAT(create.subscription.providers,
              testing::ElementsAre(ProviderFilter{"robot1", ""}, ProviderFilter{"robot 2", "left eye"},
                                   ProviderFilter{"r3", ""}));
  EXPECT_THAT(create.subscription.favoured, testing::ElementsAre(ProviderFilter{"a", ""}, ProviderFilter{"b", ""}));
  EXPECT_THAT(create.subscription.protocols, testing::ElementsAre("udp", "tcp"));
  for (const char* bad :
       {"provider=\" \"", "provider=\"a, ,b\"", "favour=\"a, \"", "protocol=\"udp, \"", "protocol=\" \""}) {
    const auto request = read("5 sub create mode=oto id=1 " + std::string(bad));
    ASSERT_FALSE(request) << bad;
    EXPECT_EQ(request.error().code, ErrorCode::malformed) << bad;
  }
}

TEST(Request, HasNumbersUpToTheirEdges) {
  for (const char* good : {"port=1", "port=65535", "port=1 priority=-2147483648", "port=1 priority=2147483647"}) {
    EXPECT_TRUE(read("5 pub create mode=oto id=1 " + std::string(good))) << good;
  }
  for (const char* bad : {"port=0", "port=65536", "port=-1", "port=+1", "port=1.0", "port=0x1", "port=\" 1\"",
                          "port=\"\"", "port=1 priority=-2147483649", "port=1 priority=2147483648"}) {
    const auto request = read("5 pub create mode=oto id=1 " + std::string(bad));
    ASSERT_FALSE(request) << bad;
    EXPECT_EQ(request.error().code, ErrorCode::malformed) << bad;
  }
  EXPECT_EQ(std::get<NumericIdentity>(*std::get<QueryMatch>(*read("5 query match id=0xffffffff")).identity).number,
            0xffffffffU);
  for (const char* bad : {"4294967296", "0x100000000", "-1", "0x", "1e3", "\"\""}) {
    EXPECT_FALSE(read("5 query match id=" + std::string(bad))) << bad;
  }
}

TEST(Request, HasAnAddressInNumbersThatCanBeSentTo) {
  for (const char* good : {"10.0.0.2", "::1", "2001:db8::1", "fe80::1%eth0", "239.1.2.3", "ff02::1", "127.0.0.1"}) {
    EXPECT_TRUE(read("5 pub create mode=oto id=1 port=1 address=" + std::string(good))) << good;
  }
  for (const char* bad : {"robot2", "10.0.0", "10.0.0.256", "1.2.3.4:80", "[::1]", "0.0.0.0", "::", "2001:db8::1%eth0",
                          "fe80::1%", "10.0.0.2%eth0", "\"10.0.0.2 \""}) {
    const auto request = read("5 pub create mode=oto id=1 port=1 address=" + std::string(bad));
    ASSERT_FALSE(request) << bad;
    EXPECT_EQ(request.error().code, ErrorCode::impossible) << bad;
  }
}

TEST(Request, SaysWhatIsWrongInOneLineThatNamesTheKey) {
  EXPECT_THAT(read("5 pub create id=1 port=1").error().text, HasSubstr("mode is missing"));
  EXPECT_THAT(read("5 pub create mode=oto id=1").error().text, HasSubstr("port is missing"));
  EXPECT_THAT(read("5 pub create mode=oto port=1").error().text, HasSubstr("identity is missing"));
  EXPECT_THAT(read("5 pub create mode=oto port=1 id=1 text=x").error().text, HasSubstr("two identities"));
  EXPECT_THAT(read("5 pub create mode=\"\\n\" port=1 id=1").error().text, HasSubstr("mode=? cannot be read"));
  EXPECT_THAT(read("5 pub shout").error().text, HasSubstr("create, modify, remove"));
  EXPECT_THAT(read("5 shout pub").error().text, HasSubstr("sys, pub, sub and query"));
}

TEST(MatchesText, LooksIntoEveryValue) {
  const Statement line{1, "msg", "services", {{"name", "left eye"}, {"flag", std::nullopt}}};
  EXPECT_TRUE(matches_text(line, ""));
  EXPECT_TRUE(matches_text(line, "t e"));
  EXPECT_FALSE(matches_text(line, "flag"));
  EXPECT_FALSE(matches_text(line, "EYE"));
}

}  // namespace
}  // namespace geminga::gcnp
