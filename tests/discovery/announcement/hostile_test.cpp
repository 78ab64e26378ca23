// Datagrams that are truncated, random, bent bit by bit, or violate one rule each.
#include <gmock/gmock.h>

#include <functional>
#include <optional>
#include <set>

#include "discovery/announcement/announcement.pb.h"
#include "discovery/announcement/announcements.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

wire::Announcement valid_message() {
  const auto datagram = encode(worked_example()).front();
  wire::Announcement message;
  EXPECT_TRUE(message.ParseFromArray(datagram.data(), static_cast<int>(datagram.size())));
  return message;
}

std::expected<Announcement, DecodeError> decode_message(const wire::Announcement& message) {
  std::vector<std::byte> datagram(message.ByteSizeLong());
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(datagram.data()));
  return decode(datagram);
}

struct Bend {
  const char* what;
  std::function<void(wire::Announcement&)> bend;
  std::optional<DecodeError> expected;  ///< nothing: still valid
};

wire::Publication& publication(wire::Announcement& m) { return *m.mutable_peers(0)->mutable_publications(0); }
wire::Subscription& subscription(wire::Announcement& m) { return *m.mutable_peers(0)->mutable_subscriptions(0); }

void expect(const std::vector<Bend>& bends) {
  for (const auto& [what, bend, expected] : bends) {
    auto message = valid_message();
    bend(message);
    const auto decoded = decode_message(message);
    ASSERT_EQ(decoded.has_value(), !expected.has_value()) << what;
    if (expected) {
      EXPECT_EQ(to_string(decoded.error()), to_string(*expected)) << what;
    }
  }
}

TEST(Decode, RefusesEachViolationInTheHeaderByItsWord) {
  using M = wire::Announcement;
  const std::string long_name(max_name_bytes + 1, 'n');
  const std::string name(max_name_bytes, 'n');
  expect({
      {"no magic", [](M& m) { m.clear_format(); }, DecodeError::not_geminga},
      {"major 2", [](M& m) { m.set_format(0x024e4d47); }, DecodeError::other_version},
      {"major 0", [](M& m) { m.set_format(0x004e4d47); }, DecodeError::other_version},
      {"minor 9", [](M& m) { m.set_minor(9); }, {}},
      {"kind 0", [](M& m) { m.clear_kind(); }, DecodeError::bad_kind},
      {"kind 9", [](M& m) { m.set_kind(static_cast<wire::Kind>(9)); }, DecodeError::bad_kind},
      {"a word of nobody", [](M& m) { m.set_kind(wire::KIND_RELAYED); }, DecodeError::bad_relayed},
      {"participant 0", [](M& m) { m.set_participant(0); }, DecodeError::bad_identifier},
      {"long group", [&](M& m) { m.set_group(long_name); }, DecodeError::bad_name},
      {"full group", [&](M& m) { m.set_group(name); }, {}},
      {"long name", [&](M& m) { m.set_name(long_name); }, DecodeError::bad_name},
      {"full name", [&](M& m) { m.set_name(name); }, {}},
      {"control character", [](M& m) { m.set_name("a\x1b[2J"); }, DecodeError::bad_name},
      {"slash", [](M& m) { m.set_name("a/b"); }, DecodeError::bad_name},
      {"comma", [](M& m) { m.mutable_peers(0)->set_name("a,b"); }, DecodeError::bad_name},
      {"interval 0", [](M& m) { m.set_interval_ms(0); }, DecodeError::bad_interval},
      {"interval 49", [](M& m) { m.set_interval_ms(49); }, DecodeError::bad_interval},
      {"interval 50", [](M& m) { m.set_interval_ms(50); }, {}},
      {"interval 60000", [](M& m) { m.set_interval_ms(60000); }, {}},
      {"interval 60001", [](M& m) { m.set_interval_ms(60001); }, DecodeError::bad_interval},
      {"part 1 of 1", [](M& m) { m.set_part(1); }, DecodeError::bad_part},
      {"part 1023 of 1024", [](M& m) { m.set_part(1023), m.set_part_count(1024); }, {}},
      {"part 1024 of 1024", [](M& m) { m.set_part(1024), m.set_part_count(1024); }, DecodeError::bad_part},
      {"1025 parts", [](M& m) { m.set_part_count(1025); }, DecodeError::bad_part},
      {"address of 5", [](M& m) { m.set_addresses(0, "12345"); }, DecodeError::bad_address},
      {"address of 0", [](M& m) { m.set_addresses(0, ""); }, DecodeError::bad_address},
      {"unspecified", [](M& m) { m.set_addresses(0, std::string(4, '\0')); }, DecodeError::bad_address},
      {"multicast", [](M& m) { m.set_addresses(0, "\xe0\x01\x01\x01"); }, DecodeError::bad_address},
      {"8 addresses",
       [](M& m) {
         while (m.addresses_size() < 8) m.add_addresses("abcd");
       },
       {}},
      {"9 addresses",
       [](M& m) {
         while (m.addresses_size() < 9) m.add_addresses("abcd");
       },
       DecodeError::bad_address},
      {"namespace 2 of 1", [](M& m) { m.mutable_terms(0)->set_namespace_number(2); }, DecodeError::bad_table},
      {"empty term", [](M& m) { m.add_terms(); }, DecodeError::bad_identity},
      {"bracket", [](M& m) { m.mutable_terms(0)->set_local("a>b"); }, DecodeError::bad_identity},
      {"space", [](M& m) { m.mutable_terms(0)->set_local("a b"); }, DecodeError::bad_identity},
      {"IRI of 255", [](M& m) { m.mutable_terms(0)->set_local(std::string(255 - 31, 'a')); }, {}},
      {"IRI of 256", [](M& m) { m.mutable_terms(0)->set_local(std::string(256 - 31, 'a')); },
       DecodeError::bad_identity},
      {"peer 0", [](M& m) { m.mutable_peers(0)->set_id(0); }, DecodeError::bad_identifier},
      {"peer twice", [](M& m) { m.add_peers()->set_id(1); }, DecodeError::bad_identifier},
      {"withheld twice", [](M& m) { m.mutable_peers(0)->add_withheld(42); }, DecodeError::bad_identifier},
      {"withheld 0", [](M& m) { m.mutable_peers(0)->add_withheld(0); }, DecodeError::bad_identifier},
  });
}

TEST(Decode, RefusesEachViolationInAServiceByItsWord) {
  using M = wire::Announcement;
  const auto set_attributes = [](M& m, int count) {
    publication(m).clear_attributes();
    for (int i = 0; i < count; ++i) publication(m).add_attributes()->set_key("k" + std::to_string(i));
  };
  const auto set_filters = [](M& m, int count) {
    for (int i = 0; i < count; ++i) subscription(m).add_providers()->set_participant("p");
  };
  const auto set_chosen = [](M& m, int count) {
    for (int i = 0; i < count; ++i) {
      auto* chosen = subscription(m).add_chosen();
      chosen->set_participant(7);
      chosen->set_peer(1);
      chosen->set_number(static_cast<std::uint32_t>(i + 1));
    }
  };
  // Groups of a choice: their participants, their sizes, and the rest of each.
  const auto set_groups = [](M& m, const std::vector<std::vector<std::uint32_t>>& groups) {
    std::uint32_t participant = 0;
    for (const auto& group : groups) {
      subscription(m).add_chosen_hosts(++participant);
      for (const std::uint32_t number : group) subscription(m).add_chosen_services(number);
    }
  };
  const auto group_of = [](std::uint32_t count) {
    std::vector<std::uint32_t> group = {count};
    for (std::uint32_t number = 1; number <= count; ++number) group.insert(group.end(), {1, number});
    return group;
  };
  expect({
      {"number 0", [](M& m) { publication(m).set_number(0); }, DecodeError::bad_identifier},
      {"number twice", [](M& m) { publication(m).set_number(43); }, DecodeError::bad_identifier},
      {"mode 0", [](M& m) { publication(m).clear_mode(); }, DecodeError::bad_mode},
      {"mode 4", [](M& m) { publication(m).set_mode(static_cast<wire::Mode>(4)); }, DecodeError::bad_mode},
      {"no identity",
       [](M& m) {
         publication(m).clear_identity();
         publication(m).clear_representation_term();
       },
       DecodeError::bad_identity},
      {"number 0 as identity",
       [](M& m) {
         publication(m).set_numeric(0);
         publication(m).clear_representation_term();
       },
       {}},
      {"representation of a number", [](M& m) { publication(m).set_numeric(1); }, DecodeError::bad_identity},
      {"term 3 of 2", [](M& m) { publication(m).set_concept_term(3); }, DecodeError::bad_table},
      {"term 0", [](M& m) { publication(m).set_concept_term(0); }, DecodeError::bad_table},
      {"representation 3 of 2", [](M& m) { publication(m).set_representation_term(3); }, DecodeError::bad_table},
      {"text of 255", [](M& m) { subscription(m).set_text(std::string(255, 't')); }, {}},
      {"text of 256", [](M& m) { subscription(m).set_text(std::string(256, 't')); }, DecodeError::bad_identity},
      {"empty text", [](M& m) { subscription(m).set_text(""); }, DecodeError::bad_identity},
      {"NUL in text", [](M& m) { subscription(m).set_text(std::string(1, '\0')); }, DecodeError::bad_identity},
      {"port 0", [](M& m) { publication(m).set_port(0); }, DecodeError::bad_port},
      {"port 65535", [](M& m) { publication(m).set_port(65535); }, {}},
      {"port 65536", [](M& m) { publication(m).set_port(65536); }, DecodeError::bad_port},
      {"port 65536 of a subscription", [](M& m) { subscription(m).set_port(65536); }, DecodeError::bad_port},
      {"address of 3", [](M& m) { publication(m).set_address("123"); }, DecodeError::bad_address},
      {"address ::", [](M& m) { publication(m).set_address(std::string(16, '\0')); }, DecodeError::bad_address},
      {"multicast address", [](M& m) { publication(m).set_address("\xe0\x01\x01\x01"); }, {}},
      {"protocol of 32", [](M& m) { publication(m).set_protocol(std::string(32, 'p')); }, {}},
      {"protocol of 33", [](M& m) { publication(m).set_protocol(std::string(33, 'p')); }, DecodeError::bad_protocol},
      {"protocol with a space", [](M& m) { publication(m).set_protocol("a b"); }, DecodeError::bad_protocol},
      {"32 attributes", [&](M& m) { set_attributes(m, 32); }, {}},
      {"33 attributes", [&](M& m) { set_attributes(m, 33); }, DecodeError::bad_attribute},
      {"attribute twice", [](M& m) { publication(m).add_attributes()->set_key("rate"); }, DecodeError::bad_attribute},
      {"empty key", [](M& m) { publication(m).add_attributes(); }, DecodeError::bad_attribute},
      {"key with =", [](M& m) { publication(m).mutable_attributes(0)->set_key("a=b"); }, DecodeError::bad_attribute},
      {"key of 64", [](M& m) { publication(m).mutable_attributes(0)->set_key(std::string(64, 'k')); }, {}},
      {"key of 65", [](M& m) { publication(m).mutable_attributes(0)->set_key(std::string(65, 'k')); },
       DecodeError::bad_attribute},
      {"value of 255", [](M& m) { publication(m).mutable_attributes(0)->set_value(std::string(255, 'v')); }, {}},
      {"value of 256", [](M& m) { publication(m).mutable_attributes(0)->set_value(std::string(256, 'v')); },
       DecodeError::bad_attribute},
      {"line end in a value", [](M& m) { publication(m).mutable_attributes(0)->set_value("a\r\n\tb"); }, {}},
      {"escape in a value", [](M& m) { publication(m).mutable_attributes(0)->set_value("\x1b"); },
       DecodeError::bad_attribute},
      {"degree 4", [](M& m) { subscription(m).set_weakest(static_cast<wire::Degree>(4)); }, DecodeError::bad_degree},
      {"overlapping of a narrower degree", [](M& m) { subscription(m).set_overlapping(true); },
       DecodeError::bad_degree},
      {"16 filters", [&](M& m) { set_filters(m, 16); }, {}},
      {"17 filters", [&](M& m) { set_filters(m, 17); }, DecodeError::bad_filter},
      {"filter without participant", [](M& m) { subscription(m).add_providers()->set_peer("p"); },
       DecodeError::bad_filter},
      {"8 protocols",
       [](M& m) {
         for (int i = 0; i < 8; ++i) subscription(m).add_protocols("tcp");
       },
       {}},
      {"9 protocols",
       [](M& m) {
         for (int i = 0; i < 9; ++i) subscription(m).add_protocols("tcp");
       },
       DecodeError::bad_protocol},
      {"empty protocol", [](M& m) { subscription(m).add_protocols(""); }, DecodeError::bad_protocol},
      {"favourite without participant", [](M& m) { subscription(m).add_favoured()->set_peer("p"); },
       DecodeError::bad_filter},
      {"16 favourites",
       [](M& m) {
         for (int i = 0; i < 16; ++i) subscription(m).add_favoured()->set_participant("p");
       },
       {}},
      {"17 favourites",
       [](M& m) {
         for (int i = 0; i < 17; ++i) subscription(m).add_favoured()->set_participant("p");
       },
       DecodeError::bad_filter},
      {"prefer of 200", [](M& m) { subscription(m).set_prefer(std::string(200, 'p')); }, {}},
      {"prefer of 201", [](M& m) { subscription(m).set_prefer(std::string(201, 'p')); }, DecodeError::bad_filter},
      {"rank of 64", [](M& m) { subscription(m).set_rank(std::string(64, 'r')); }, {}},
      {"rank of 65", [](M& m) { subscription(m).set_rank(std::string(65, 'r')); }, DecodeError::bad_filter},
      {"16 chosen", [&](M& m) { set_chosen(m, 16); }, {}},
      {"17 chosen", [&](M& m) { set_chosen(m, 17); }, DecodeError::bad_identifier},
      {"chosen of nobody",
       [&](M& m) {
         set_chosen(m, 1);
         subscription(m).mutable_chosen(0)->set_participant(0);
       },
       DecodeError::bad_identifier},
      {"chosen twice",
       [&](M& m) {
         set_chosen(m, 2);
         subscription(m).mutable_chosen(0)->set_number(2);
       },
       DecodeError::bad_identifier},
      {"17 chosen in groups", [&](M& m) { set_groups(m, {group_of(16), {1, 1, 1}}); }, {}},
      {"64 chosen in groups", [&](M& m) { set_groups(m, {group_of(32), group_of(32)}); }, {}},
      {"65 chosen in groups", [&](M& m) { set_groups(m, {group_of(32), group_of(33)}); }, DecodeError::bad_identifier},
      {"65 chosen in one group", [&](M& m) { set_groups(m, {group_of(65)}); }, DecodeError::bad_identifier},
      {"a group of none", [&](M& m) { set_groups(m, {{0}}); }, DecodeError::bad_identifier},
      {"a group without size", [&](M& m) { set_groups(m, {{1, 1, 1}, {}}); }, DecodeError::bad_identifier},
      {"a group that is cut", [&](M& m) { set_groups(m, {{2, 1, 1, 1}}); }, DecodeError::bad_identifier},
      {"a group larger than all", [&](M& m) { set_groups(m, {{0xFFFFFFFF, 1, 1}}); }, DecodeError::bad_identifier},
      {"a group of nobody", [&](M& m) { subscription(m).add_chosen_services(0); }, DecodeError::bad_identifier},
      {"a group with a peer 0", [&](M& m) { set_groups(m, {{1, 0, 1}}); }, DecodeError::bad_identifier},
      {"a group that descends", [&](M& m) { set_groups(m, {{2, 1, 2, 1, 1}}); }, DecodeError::bad_identifier},
      {"chosen in both forms",
       [&](M& m) {
         set_chosen(m, 1);
         set_groups(m, {{1, 1, 1}});
       },
       DecodeError::bad_identifier},
      {"scope of 201", [](M& m) { subscription(m).set_scope(std::string(201, 's')); }, DecodeError::bad_filter},
      {"scope of 201 of a publication", [](M& m) { publication(m).set_scope(std::string(201, 's')); },
       DecodeError::bad_filter},
      {"for of 401", [](M& m) { publication(m).set_for_whom(std::string(401, 'w')); }, DecodeError::bad_filter},
      {"on of 401", [](M& m) { subscription(m).set_on(std::string(401, 'o')); }, DecodeError::bad_filter},
      {"escape in prefer", [](M& m) { subscription(m).set_prefer("rate\x1b"); }, DecodeError::bad_filter},
      {"where of 400", [](M& m) { subscription(m).set_where(std::string(400, 'w')); }, {}},
      {"expression of 400",
       [](M& m) {
         subscription(m).set_text("not <" + std::string(394, 'c') + ">");
         subscription(m).set_is_expression(true);
       },
       {}},
      {"expression of 401",
       [](M& m) {
         subscription(m).set_text("not <" + std::string(395, 'c') + ">");
         subscription(m).set_is_expression(true);
       },
       DecodeError::bad_identity},
      {"expression that is a name",
       [](M& m) {
         subscription(m).set_text("urn:c");
         subscription(m).set_is_expression(true);
       },
       DecodeError::bad_identity},
      {"expression with a line end",
       [](M& m) {
         subscription(m).set_text("not\n<urn:c>");
         subscription(m).set_is_expression(true);
       },
       DecodeError::bad_identity},
      {"expression without a text", [](M& m) { subscription(m).set_is_expression(true); }, DecodeError::bad_identity},
      {"where of 401", [](M& m) { subscription(m).set_where(std::string(401, 'w')); }, DecodeError::bad_filter},
  });
}

TEST(Decode, RefusesEachViolationInAPresenceByItsWord) {
  const auto presence = [](auto bend) {
    return [bend](wire::Announcement& m) {
      m.set_kind(wire::KIND_PRESENCE);
      bend(m);
    };
  };
  const auto introduces = [=](std::uint32_t participant, const char* address, std::size_t count = 1) {
    return presence([=](auto& m) {
      for (std::size_t i = 0; i < count; ++i) m.add_introductions()->set_participant(participant);
      for (auto& one : *m.mutable_introductions()) one.set_address(address);
    });
  };
  const auto most = witness_bytes(max_participants + 1);
  expect({
      {"nothing is said of others", presence([](auto&) {}), std::nullopt},
      {"the shortest witness", presence([](auto& m) { m.set_witness("abc"); }), std::nullopt},
      {"no witness in it", presence([](auto& m) { m.set_witness("ab"); }), DecodeError::bad_witness},
      {"the longest witness", presence([=](auto& m) { m.set_witness(std::string(most, 'x')); }), std::nullopt},
      {"a longer one", presence([=](auto& m) { m.set_witness(std::string(most + 1, 'x')); }), DecodeError::bad_witness},
      {"most lacks", presence([](auto& m) { m.mutable_lacks()->Resize(max_named, 7); }), std::nullopt},
      {"more lacks", presence([](auto& m) { m.mutable_lacks()->Resize(max_named + 1, 7); }), DecodeError::bad_witness},
      {"more doubts", presence([](auto& m) { m.mutable_doubts()->Resize(max_named + 1, 7); }),
       DecodeError::bad_witness},
      {"lacks nobody", presence([](auto& m) { m.add_lacks(0); }), DecodeError::bad_witness},
      {"doubts nobody", presence([](auto& m) { m.add_doubts(0); }), DecodeError::bad_witness},
      {"most introductions", introduces(7, "host", max_introductions), std::nullopt},
      {"more introductions", introduces(7, "host", max_introductions + 1), DecodeError::bad_witness},
      {"introduces nobody", introduces(0, "host"), DecodeError::bad_witness},
      {"introduces nowhere", introduces(7, ""), DecodeError::bad_witness},
      {"introduces a group", introduces(7, "\xef..."), DecodeError::bad_witness},
      {"a bad group", presence([](auto& m) { m.set_group("a,b"); }), DecodeError::bad_name},
      {"participant 0", presence([](auto& m) { m.set_participant(0); }), DecodeError::bad_identifier},
  });
}

TEST(Decode, RefusesOneOctetOverTheLimit) {
  for (const std::size_t size : {max_datagram_bytes - 1, max_datagram_bytes, max_datagram_bytes + 1}) {
    auto datagram = encode(worked_example()).front();
    // An unknown field 1000 of wire type 2 fills the rest: tag of two octets, length of two.
    const auto content = size - datagram.size() - 4;
    for (const auto octet : {0xc2, 0x3e, static_cast<int>((content & 0x7f) | 0x80), static_cast<int>(content >> 7)}) {
      datagram.push_back(static_cast<std::byte>(octet));
    }
    datagram.resize(size);
    const auto decoded = decode(datagram);
    if (size <= max_datagram_bytes) {
      ASSERT_TRUE(decoded) << size << " " << to_string(decoded.error());
      EXPECT_EQ(*decoded, worked_example());
    } else {
      ASSERT_FALSE(decoded);
      EXPECT_EQ(decoded.error(), DecodeError::too_large);
    }
  }
}

TEST(Decode, RefusesBadUtf8WithoutAWordOnStandardError) {
  auto datagram = encode(worked_example()).front();
  const auto text = to_hex_text(datagram);
  const auto place = text.find("726f626f7432") / 2;
  datagram[place] = std::byte{0xff};
  ::testing::internal::CaptureStderr();
  const auto decoded = decode(datagram);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error(), DecodeError::not_protobuf);
}

TEST(Decode, SurvivesEveryTruncation) {
  const auto datagram = encode(worked_example()).front();
  for (std::size_t size = 0; size < datagram.size(); ++size) {
    // A copy of exactly that size, so that the sanitizers see a read behind it.
    const std::vector<std::byte> cut(datagram.begin(), datagram.begin() + static_cast<std::ptrdiff_t>(size));
    const auto decoded = decode(cut);
    if (decoded) {
      EXPECT_NE(*decoded, worked_example()) << size;
    }
  }
  EXPECT_EQ(decode({}).error(), DecodeError::not_geminga);
}

TEST(Decode, SurvivesRandomOctets) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    base::Random random(seed);
    std::vector<std::byte> datagram(random.below(max_datagram_bytes + 10));
    for (auto& octet : datagram) octet = static_cast<std::byte>(random.next());
    EXPECT_FALSE(decode(datagram)) << "seed " << seed;
  }
}

TEST(Decode, SurvivesFlippedBitsAndWhatItAcceptsCanBeEncodedAgain) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    base::Random random(seed);
    auto datagram = encode(random_announcement(random)).front();
    for (auto flips = 1 + random.below(4); flips > 0; --flips) {
      datagram[random.below(datagram.size())] ^= static_cast<std::byte>(1U << random.below(8));
    }
    const auto decoded = decode(datagram);
    if (!decoded) continue;
    auto again = *decoded;
    again.part = 0;
    again.part_count = 1;
    for (const auto& written : encode(again)) EXPECT_TRUE(decode(written)) << "seed " << seed;
  }
}

TEST(Decode, HasADifferentWordForEachReason) {
  std::set<std::string_view> words;
  for (std::size_t i = 0; i < decode_error_count; ++i) words.insert(to_string(static_cast<DecodeError>(i)));
  EXPECT_EQ(words.size(), decode_error_count);
  EXPECT_FALSE(words.contains(""));
}

}  // namespace
}  // namespace geminga::announcement
