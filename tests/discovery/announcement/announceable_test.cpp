// The answers to a peer whose service cannot be announced.
#include "discovery/announcement/announceable.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <optional>

#include "discovery/announcement/announcements.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

using Edit = std::function<void(Publication&)>;
using SubscriptionEdit = std::function<void(Subscription&)>;

std::optional<ErrorCode> code_of(const Edit& edit) {
  auto publication = simple_publication();
  edit(publication);
  const auto error = check(publication);
  return error ? std::optional(error->code) : std::nullopt;
}

std::optional<ErrorCode> subscription_code_of(const SubscriptionEdit& edit) {
  auto subscription = simple_subscription();
  edit(subscription);
  const auto error = check(subscription);
  return error ? std::optional(error->code) : std::nullopt;
}

/// Whether a field may have limit - 1 and limit octets, and gets 413 for limit + 1.
void expect_limit(std::size_t limit, const std::function<std::optional<ErrorCode>(std::size_t)>& with) {
  EXPECT_EQ(with(limit - 1), std::nullopt) << limit;
  EXPECT_EQ(with(limit), std::nullopt) << limit;
  EXPECT_EQ(with(limit + 1), ErrorCode::too_large) << limit;
}

TEST(Announceable, KeepsEachNamedLimitOfAPublication) {
  expect_limit(max_text_identity_bytes, [](std::size_t n) {
    return code_of([&](Publication& p) { p.identity = TextIdentity{std::string(n, 't')}; });
  });
  expect_limit(max_iri_bytes, [](std::size_t n) {
    return code_of([&](Publication& p) { p.identity = SemanticIdentity{std::string(n, 'c'), ""}; });
  });
  expect_limit(max_iri_bytes, [](std::size_t n) {
    return code_of([&](Publication& p) { p.identity = SemanticIdentity{"urn:c", std::string(n, 'r')}; });
  });
  expect_limit(max_protocol_bytes,
               [](std::size_t n) { return code_of([&](Publication& p) { p.protocol = std::string(n, 'p'); }); });
  expect_limit(max_scope_bytes,
               [](std::size_t n) { return code_of([&](Publication& p) { p.scope = std::string(n, 's'); }); });
  expect_limit(max_where_bytes,
               [](std::size_t n) { return code_of([&](Publication& p) { p.for_whom = std::string(n, 'w'); }); });
  expect_limit(max_attribute_key_bytes,
               [](std::size_t n) { return code_of([&](Publication& p) { p.attributes[std::string(n, 'k')] = "v"; }); });
  expect_limit(max_attribute_value_bytes,
               [](std::size_t n) { return code_of([&](Publication& p) { p.attributes["k"] = std::string(n, 'v'); }); });
  expect_limit(max_attributes, [](std::size_t n) {
    return code_of([&](Publication& p) {
      for (std::size_t i = 0; i < n; ++i) p.attributes["k" + std::to_string(i)] = "v";
    });
  });
}

TEST(Announceable, KeepsEachNamedLimitOfASubscription) {
  expect_limit(max_expression_bytes, [](std::size_t n) {
    return subscription_code_of(
        [&](Subscription& s) { s.identity = SemanticIdentity{"not <" + std::string(n - 6, 'c') + ">", "urn:r"}; });
  });
  expect_limit(max_where_bytes, [](std::size_t n) {
    return subscription_code_of([&](Subscription& s) { s.where = std::string(n, 'w'); });
  });
  expect_limit(max_provider_filters, [](std::size_t n) {
    return subscription_code_of([&](Subscription& s) { s.providers.assign(n, {"robot2", "vision"}); });
  });
  expect_limit(max_provider_filters, [](std::size_t n) {
    return subscription_code_of([&](Subscription& s) { s.favoured.assign(n, {"robot2", "vision"}); });
  });
  expect_limit(max_prefer_bytes, [](std::size_t n) {
    return subscription_code_of([&](Subscription& s) { s.prefer = std::string(n, 'p'); });
  });
  expect_limit(max_rank_bytes, [](std::size_t n) {
    return subscription_code_of([&](Subscription& s) { s.rank = std::string(n, 'r'); });
  });
  expect_limit(max_scope_bytes, [](std::size_t n) {
    return subscription_code_of([&](Subscription& s) { s.scope = std::string(n, 's'); });
  });
  expect_limit(max_expression_bytes, [](std::size_t n) {
    return subscription_code_of([&](Subscription& s) { s.on = '<' + std::string(n - 2, 'o') + '>'; });
  });
  expect_limit(max_accepted_protocols, [](std::size_t n) {
    return subscription_code_of([&](Subscription& s) { s.protocols.assign(n, "udp"); });
  });
  expect_limit(max_protocol_bytes, [](std::size_t n) {
    return subscription_code_of([&](Subscription& s) { s.protocols = {std::string(n, 'p')}; });
  });
}

TEST(Announceable, ADescriptionMayHaveALongerExpressionThanAService) {
  const auto expression = [](std::size_t n) { return SemanticIdentity{"not <" + std::string(n - 6, 'c') + ">", ""}; };
  expect_limit(max_expression_bytes,
               [&](std::size_t n) { return code_of([&](Publication& p) { p.identity = expression(n); }); });
  expect_limit(max_described_bytes, [&](std::size_t n) {
    Publication description;
    description.mode = ChannelMode::participant;
    description.identity = expression(n);
    description.attributes = {{"battery", "80 %"}};
    const auto error = check(description);
    return error ? std::optional(error->code) : std::nullopt;
  });
}

TEST(Announceable, KeepsTheLimitOfAllTogetherExactly) {
  auto publication = simple_publication();
  publication.attributes = {{"a", std::string(max_attribute_value_bytes, 'x')},
                            {"b", std::string(max_attribute_value_bytes, 'x')},
                            {"c", ""}};
  std::size_t largest = 0;
  for (std::size_t size = 0; size <= max_attribute_value_bytes; ++size) {
    publication.attributes["c"] = std::string(size, 'x');
    const auto error = check(publication);
    if (!error) {
      largest = size;
      continue;
    }
    EXPECT_EQ(error->code, ErrorCode::too_large);
    EXPECT_THAT(error->text, ::testing::HasSubstr(std::to_string(max_entry_bytes + 1)));
    break;
  }
  EXPECT_GT(largest, 0U);
  EXPECT_LT(largest, max_attribute_value_bytes);
}

TEST(Announceable, SaysWhatCannotBeReadAndWhatIsImpossible) {
  EXPECT_EQ(code_of([](Publication&) {}), std::nullopt);
  EXPECT_EQ(code_of([](Publication& p) { p.port = 0; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.protocol = ""; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.identity = TextIdentity{""}; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.identity = TextIdentity{"\xff"}; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.identity = SemanticIdentity{"", ""}; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.identity = SemanticIdentity{"urn:a>", ""}; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.identity = SemanticIdentity{"urn:a", "urn: b"}; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.attributes["a b"] = ""; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.attributes["a"] = "\x07"; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.attributes["a"] = "\xc3"; }), ErrorCode::malformed);
  EXPECT_EQ(code_of([](Publication& p) { p.address = "robot2"; }), ErrorCode::impossible);
  EXPECT_EQ(code_of([](Publication& p) { p.address = "0.0.0.0"; }), ErrorCode::impossible);
  EXPECT_EQ(code_of([](Publication& p) { p.address = "fe80::1%eth0"; }), std::nullopt);
  EXPECT_EQ(subscription_code_of([](Subscription&) {}), std::nullopt);
  EXPECT_EQ(subscription_code_of([](Subscription& s) { s.providers = {{"", "x"}}; }), ErrorCode::malformed);
  EXPECT_EQ(subscription_code_of([](Subscription& s) { s.where = std::string(1, '\0'); }), ErrorCode::malformed);
  EXPECT_EQ(subscription_code_of([](Subscription& s) { s.address = "::"; }), ErrorCode::impossible);
}

TEST(Announceable, AnswersInOnePrintableLine) {
  for (const auto& edit : std::vector<Edit>{
           [](Publication& p) { p.address = "\x1b[2J\n"; },
           [](Publication& p) { p.protocol = "a\nb"; },
           [](Publication& p) { p.attributes["k\n"] = ""; },
           [](Publication& p) { p.attributes[std::string(9, '\n')] = std::string(400, 'v'); },
           [](Publication& p) { p.identity = SemanticIdentity{"\xff\n", ""}; },
       }) {
    auto publication = simple_publication();
    edit(publication);
    const auto error = check(publication);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->text.find_first_of("\n\x1b\xff"), std::string::npos) << error->text;
  }
}

TEST(Announceable, KnowsNames) {
  EXPECT_TRUE(is_valid_name("robot 2 – Ölstand"));
  EXPECT_TRUE(is_valid_name(std::string(max_name_bytes - 1, 'n')));
  EXPECT_TRUE(is_valid_name(std::string(max_name_bytes, 'n')));
  EXPECT_FALSE(is_valid_name(std::string(max_name_bytes + 1, 'n')));
  for (const auto* name : {"", "a/b", "a,b", "a\nb", "\xff"}) EXPECT_FALSE(is_valid_name(name)) << name;
}

}  // namespace
}  // namespace geminga::announcement
