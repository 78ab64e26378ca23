// The description of a participant on its way through datagrams, and what those make of it who do not know the field.
#include <gtest/gtest.h>

#include <string>

#include "discovery/announcement/announceable.hpp"
#include "discovery/announcement/announcement.pb.h"
#include "discovery/announcement/announcements.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

constexpr const char* expression =
    "<https://a.example/r#Robot> and (<https://a.example/r#hasPart> some <https://a.example/r#Gripper>)";

Publication description_of(const std::string& concept_iri) {
  return {.mode = ChannelMode::participant,
          .identity = SemanticIdentity{concept_iri, {}},
          .address = {},
          .attributes = {{"battery", "80 %"}}};
}

PeerState self_of(const Publication& description) {
  PeerState self;
  self.publications.push_back({description_key({}).number, description});
  return self;
}

Announcement described(const std::string& concept_iri) {
  Announcement state = worked_example();
  state.peers.insert(state.peers.begin(), self_of(description_of(concept_iri)));
  return state;
}

wire::Announcement message_of(const Datagram& datagram) {
  wire::Announcement message;
  EXPECT_TRUE(message.ParseFromArray(datagram.data(), static_cast<int>(datagram.size())));
  return message;
}

Datagram datagram_of(const wire::Announcement& message) {
  const std::string octets = message.SerializeAsString();
  const auto* begin = reinterpret_cast<const std::byte*>(octets.data());
  return {begin, begin + octets.size()};
}

TEST(Description, ComesBackFromAState) {
  for (const std::string concept_iri : {expression, "https://a.example/r#Robot"}) {
    const Announcement state = described(concept_iri);
    const auto datagrams = encode(state);
    ASSERT_EQ(datagrams.size(), 1U);
    const auto read = decode(datagrams.front());
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(*read, state);
  }
}

TEST(Description, ComesAndGoesInAChange) {
  Announcement change = worked_example();
  change.kind = Kind::change;
  change.since = change.revision - 1;
  PeerState gone;
  gone.removed.push_back(description_key({}).number);
  for (const PeerState& self : {self_of(description_of(expression)), gone}) {
    change.peers = {self};
    const auto datagrams = encode(change);
    ASSERT_EQ(datagrams.size(), 1U);
    const auto read = decode(datagrams.front());
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read->peers, change.peers);
  }
}

TEST(Description, IsSkippedByWhoDoesNotKnowTheField) {
  wire::Announcement message = message_of(encode(described(expression)).front());
  EXPECT_TRUE(message.has_description());
  message.clear_description();
  auto without = described(expression);
  without.peers.erase(without.peers.begin());
  EXPECT_EQ(*decode(datagram_of(message)), without);
}

TEST(Description, StandsInThePartWhereItFitsAndInNoOther) {
  Announcement state = described(expression);
  Publication long_one = simple_publication();
  long_one.attributes["note"] = std::string(max_attribute_value_bytes, 'x');
  for (std::uint32_t number = 100; number < 110; ++number)
    state.peers.back().publications.push_back({number, long_one});
  const auto datagrams = encode(state);
  ASSERT_GT(datagrams.size(), 1U);
  std::size_t count = 0;
  for (const Datagram& datagram : datagrams) count += message_of(datagram).has_description() ? 1 : 0;
  EXPECT_EQ(count, 1U);
}

TEST(Description, IsRefusedWithoutAClassOrOverItsLimits) {
  EXPECT_FALSE(check(description_of(expression)));
  EXPECT_TRUE(check(description_of("")));
  Publication number = description_of(expression);
  number.identity = NumericIdentity{7};
  ASSERT_TRUE(check(number));
  EXPECT_EQ(check(number)->code, ErrorCode::malformed);
  Publication large = description_of(expression);
  large.attributes["a"] = std::string(max_attribute_value_bytes, 'x');
  EXPECT_FALSE(check(large));
  large.attributes["b"] = std::string(max_attribute_value_bytes, 'x');
  large.attributes["c"] = std::string(max_attribute_value_bytes, 'x');
  ASSERT_TRUE(check(large));
  EXPECT_EQ(check(large)->code, ErrorCode::too_large);
}

TEST(Description, RefusesTheDatagramWhereItCannotBeRead) {
  wire::Announcement message = message_of(encode(described(expression)).front());
  message.mutable_description()->set_text("no expression");
  EXPECT_EQ(decode(datagram_of(message)).error(), DecodeError::bad_identity);
  message.mutable_description()->set_text(expression);
  message.mutable_description()->mutable_attributes(0)->set_key("two words");
  EXPECT_EQ(decode(datagram_of(message)).error(), DecodeError::bad_attribute);
}

}  // namespace
}  // namespace geminga::announcement
