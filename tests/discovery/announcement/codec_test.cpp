// Announcements survive the way through datagrams, whatever their content, and large states are split.
#include "discovery/announcement/codec.hpp"

#include <gmock/gmock.h>

#include <set>

#include "discovery/announcement/announceable.hpp"
#include "discovery/announcement/announcements.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

std::vector<Announcement> decode_all(const std::vector<Datagram>& datagrams) {
  std::vector<Announcement> parts;
  for (const auto& datagram : datagrams) {
    EXPECT_LE(datagram.size(), max_datagram_bytes);
    auto part = decode(datagram);
    EXPECT_TRUE(part) << to_string(part.error());
    if (part) parts.push_back(std::move(*part));
  }
  return parts;
}

/// A state of `count` publications, each with `padding` octets more than needed.
Announcement state_of(std::size_t count, std::size_t padding = 0) {
  auto state = worked_example();
  state.peers.resize(1);
  state.peers[0].publications.clear();
  state.peers[0].subscriptions.clear();
  for (std::size_t i = 0; i < count; ++i) {
    auto publication = simple_publication();
    if (padding > 0) publication.attributes["p"] = std::string(padding, 'x');
    state.peers[0].publications.push_back({static_cast<std::uint32_t>(i + 1), publication});
  }
  return state;
}

TEST(Codec, GivesBackWhatWasEncoded) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    base::Random random(seed);
    const auto announcement = random_announcement(random, seed % 5 == 0 ? 150 : 12);
    const auto datagrams = encode(announcement);
    const auto parts = decode_all(datagrams);
    ASSERT_EQ(parts.size(), datagrams.size()) << "seed " << seed;
    EXPECT_EQ(joined(parts), announcement) << "seed " << seed;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_EQ(parts[i].part, i) << "seed " << seed;
      EXPECT_EQ(parts[i].part_count, parts.size()) << "seed " << seed;
      EXPECT_EQ(parts[i].sequence, announcement.sequence + i) << "seed " << seed;
    }
  }
}

TEST(Codec, GivesBackEveryPresence) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    base::Random random(seed);
    const auto presence = random_presence(random);
    const auto datagrams = encode(presence);
    ASSERT_EQ(datagrams.size(), 1U) << "seed " << seed;
    const auto decoded = decode(datagrams[0]);
    ASSERT_TRUE(decoded) << "seed " << seed;
    EXPECT_EQ(*decoded, presence) << "seed " << seed;
  }
}

TEST(Codec, GivesBackEveryChange) {
  int fitting = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    base::Random random(seed);
    const auto change = random_change(random);
    const auto datagrams = encode(change);
    if (datagrams.empty()) continue;
    ++fitting;
    const auto decoded = decode(datagrams[0]);
    ASSERT_TRUE(decoded) << "seed " << seed << ": " << to_string(decoded.error());
    EXPECT_EQ(*decoded, change) << "seed " << seed;
  }
  EXPECT_GT(fitting, 100);
}

TEST(Codec, WritesEqualOctetsForEqualAnnouncements) {
  base::Random one(7);
  base::Random other(7);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(encode(random_announcement(one, 60)), encode(random_announcement(other, 60)));
}

TEST(Codec, WritesOneDatagramForAnEmptyState) {
  const auto datagrams = encode(state_of(0));
  ASSERT_EQ(datagrams.size(), 1U);
  const auto decoded = decode(datagrams[0]);
  ASSERT_TRUE(decoded);
  EXPECT_TRUE(decoded->peers.empty());
}

TEST(Codec, FillsADatagramToItsLastOctetBeforeItSplits) {
  std::set<std::size_t> sizes;
  std::size_t first_split = 0;
  for (std::size_t padding = 1; padding <= max_attribute_value_bytes && first_split == 0; ++padding) {
    const auto datagrams = encode(state_of(5, padding));
    if (datagrams.size() == 1) {
      sizes.insert(datagrams[0].size());
    } else {
      first_split = padding;
    }
  }
  ASSERT_NE(first_split, 0U);
  // Each step adds five octets, so the last whole one is within them of the limit.
  EXPECT_GT(*sizes.rbegin() + 5, max_said_bytes);
  EXPECT_LE(*sizes.rbegin(), max_said_bytes);
  EXPECT_EQ(encode(state_of(5, first_split)).size(), 2U);
}

TEST(Codec, SplitsBetweenServicesAndRepeatsWhatEachPartNeeds) {
  auto state = state_of(0);
  for (std::uint32_t i = 1; i <= 40; ++i) {
    auto publication = simple_publication();
    publication.identity = SemanticIdentity{"https://geminga.example/soccer#Concept" + std::to_string(i),
                                            "https://geminga.example/soccer#CartesianFieldFrame"};
    state.peers[0].publications.push_back({i, publication});
  }
  const auto datagrams = encode(state);
  ASSERT_GT(datagrams.size(), 1U);
  std::size_t services = 0;
  for (const auto& part : decode_all(datagrams)) {
    ASSERT_EQ(part.peers.size(), 1U);
    EXPECT_EQ(part.peers[0].name, "vision");
    services += part.peers[0].publications.size();
  }
  EXPECT_EQ(services, 40U);
}

TEST(Codec, CarriesTheMostServicesAndLeavesOutWhatIsOver) {
  for (const std::size_t count :
       {max_services_per_participant - 1, max_services_per_participant, max_services_per_participant + 1}) {
    const auto parts = decode_all(encode(state_of(count)));
    EXPECT_EQ(joined(parts).peers[0].publications.size(), std::min(count, max_services_per_participant));
  }
}

TEST(Codec, NeedsNoMorePartsThanAllowedForTheLargestState) {
  const auto parts = decode_all(encode(state_of(max_services_per_participant, max_attribute_value_bytes)));
  EXPECT_LE(parts.size(), max_parts);
  EXPECT_EQ(joined(parts).peers[0].publications.size(), max_services_per_participant);
}

TEST(Codec, LeavesOutOnlyTheServiceThatCannotBeAnnounced) {
  auto state = state_of(3);
  state.peers[0].publications[1].publication.port = 0;
  const auto parts = decode_all(encode(state));
  ASSERT_EQ(parts.size(), 1U);
  ASSERT_EQ(parts[0].peers[0].publications.size(), 2U);
  EXPECT_EQ(parts[0].peers[0].publications[1].number, 3U);
}

TEST(Codec, LeavesOutOnlyTheServiceThatIsLargerThanADatagram) {
  for (const std::size_t place : {0U, 2U, 5U}) {
    const auto without = state_of(5);
    auto state = without;
    auto huge = simple_publication();
    huge.identity = SemanticIdentity{std::string(max_iri_bytes - 1, 'c') + "/", std::string(max_iri_bytes, 'r')};
    for (const auto* key : {"a", "b", "c"}) huge.attributes[key] = std::string(max_attribute_value_bytes, 'x');
    auto& publications = state.peers[0].publications;
    publications.insert(publications.begin() + static_cast<std::ptrdiff_t>(place), {99, huge});
    EXPECT_EQ(joined(decode_all(encode(state))), without) << place;
  }
}

TEST(Codec, LeavesOutAPeerWithoutServices) {
  auto state = state_of(1);
  state.peers.push_back({PeerId{2}, "idle", {}, {}, {}, {}});
  EXPECT_EQ(decode_all(encode(state))[0].peers.size(), 1U);
}

TEST(Codec, CutsAnOverlongNameBetweenTwoCharacters) {
  auto state = state_of(0);
  state.name = std::string(max_name_bytes - 1, 'n') + "ö";
  const auto parts = decode_all(encode(state));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].name, std::string(max_name_bytes - 1, 'n'));
}

TEST(Codec, FitsTheLargestServiceUnderTheLargestHeader) {
  auto state = state_of(0);
  const auto full = std::numeric_limits<std::uint32_t>::max();
  state.group = std::string(max_name_bytes, 'g');
  state.name = std::string(max_name_bytes, 'n');
  state.link = full;
  state.sequence = std::numeric_limits<std::uint64_t>::max() / 2;
  state.revision = std::numeric_limits<std::uint64_t>::max();
  state.interval = max_interval;
  state.addresses.assign(max_addresses, "2001:db8::1");
  state.peers[0].id = PeerId{full};
  state.peers[0].name = std::string(max_name_bytes, 'p');
  auto publication = simple_publication(65535);
  publication.identity = SemanticIdentity{std::string(max_iri_bytes - 1, 'c') + "/", std::string(max_iri_bytes, 'r')};
  // The service is as large as check() admits.
  for (std::size_t size = 0; !check(publication); ++size) publication.attributes["a"] = std::string(size, 'x');
  publication.attributes["a"].pop_back();
  ASSERT_FALSE(check(publication));
  for (std::uint32_t i = 0; i < 3; ++i) state.peers[0].publications.push_back({full - i, publication});
  const auto parts = decode_all(encode(state));
  EXPECT_EQ(parts.size(), 3U);
  EXPECT_EQ(joined(parts).peers, state.peers);
}

TEST(Codec, CarriesAPresenceInFewOctetsHoweverManyServicesThereAre) {
  Announcement presence = worked_example();
  presence.kind = Kind::presence;
  presence.witness = {.members = 0x1234, .heard = std::vector<HeardWithin>(10, HeardWithin::quarter)};
  const auto datagrams = encode(presence);
  ASSERT_EQ(datagrams.size(), 1U);
  EXPECT_EQ(datagrams[0].size(), 36U);
  const auto decoded = decode(datagrams[0]);
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(decoded->revision, presence.revision);
  EXPECT_EQ(decoded->group, "default");
  EXPECT_TRUE(decoded->peers.empty());
  EXPECT_EQ(decoded->witness.members, 0x1234);
  ASSERT_EQ(decoded->witness.heard.size(), 12U);
  EXPECT_EQ(decoded->witness.heard[9], HeardWithin::quarter);
  EXPECT_EQ(decoded->witness.heard[10], HeardWithin::longer);
}

TEST(Codec, NamesNoMoreParticipantsInAPresenceThanItMay) {
  Announcement presence = worked_example();
  presence.kind = Kind::presence;
  presence.lacks.assign(max_named + 1, ParticipantId{7});
  presence.doubts.assign(max_named + 1, ParticipantId{8});
  presence.introductions.assign(max_introductions + 1, {ParticipantId{9}, "10.0.0.9"});
  presence.witness.heard.assign(max_participants + 2, HeardWithin::half);
  const auto decoded = decode(encode(presence)[0]);
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(decoded->lacks.size(), max_named);
  EXPECT_EQ(decoded->doubts.size(), max_named);
  EXPECT_EQ(decoded->introductions.size(), max_introductions);
  EXPECT_EQ(decoded->witness.heard.size(), max_participants + 4);
}

TEST(Codec, TellsAChangeInFewOctetsOrNotAtAll) {
  Announcement change = worked_example();
  change.kind = Kind::change;
  change.since = change.revision - 1;
  change.peers[0].subscriptions.clear();
  change.peers[0].publications[0].publication.attributes.clear();
  change.peers[0].removed = {43};
  const auto datagrams = encode(change);
  ASSERT_EQ(datagrams.size(), 1U);
  EXPECT_LT(datagrams[0].size(), encode(worked_example())[0].size());
  const auto decoded = decode(datagrams[0]);
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(decoded->since, change.since);
  EXPECT_EQ(decoded->peers, change.peers);
  EXPECT_EQ(decoded->name, "") << "is as the state says";

  for (std::uint32_t number = 100; number < 200; ++number) {
    change.peers[0].publications.push_back({number, simple_publication()});
  }
  EXPECT_TRUE(encode(change).empty());
}

TEST(Codec, RefusesAChangeThatBeginsFromItsOwnRevision) {
  Announcement change = worked_example();
  change.kind = Kind::change;
  change.since = change.revision;
  const auto decoded = decode(encode(change)[0]);
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error(), DecodeError::bad_change);
}

TEST(Codec, WritesAnInquiryThatNoDiagnosisIsLongerThan) {
  Announcement inquiry = worked_diagnosis();
  inquiry.kind = Kind::inquiry;
  inquiry.lines.clear();
  const auto asked = encode(inquiry);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked[0].size(), max_datagram_bytes);
  const auto decoded = decode(asked[0]);
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(*decoded, inquiry);

  Announcement diagnosis = worked_diagnosis();
  diagnosis.lines.assign(max_diagnosis_lines, std::string(max_diagnosis_line_bytes, 'x'));
  const auto answered = encode(diagnosis);
  ASSERT_EQ(answered.size(), 1U);
  EXPECT_LE(answered[0].size(), asked[0].size());
  EXPECT_EQ(decode(answered[0])->lines.size(), fitting_lines(diagnosis));
}

TEST(Codec, WritesLinesOfADiagnosisWithinTheirLimits) {
  for (const auto& [count, octets, fitting] :
       {std::tuple(max_diagnosis_lines - 1, std::size_t{10}, max_diagnosis_lines - 1),
        std::tuple(max_diagnosis_lines, std::size_t{10}, max_diagnosis_lines),
        std::tuple(max_diagnosis_lines + 1, std::size_t{10}, max_diagnosis_lines),
        std::tuple(std::size_t{1}, max_diagnosis_line_bytes - 1, std::size_t{1}),
        std::tuple(std::size_t{1}, max_diagnosis_line_bytes, std::size_t{1}),
        std::tuple(std::size_t{1}, max_diagnosis_line_bytes + 1, std::size_t{0})}) {
    Announcement diagnosis = worked_diagnosis();
    diagnosis.lines.assign(count, std::string(octets, 'x'));
    EXPECT_EQ(decode(encode(diagnosis)[0])->lines.size(), fitting) << count << " lines of " << octets;
  }
}

TEST(Codec, RefusesADiagnosisOfNobodyAndLinesThatCouldSteerATerminal) {
  Announcement nobody = worked_diagnosis();
  nobody.partner = ParticipantId{};
  EXPECT_EQ(decode(encode(nobody)[0]).error(), DecodeError::bad_diagnosis);
  for (const char* line : {"", "status a=\x1b[2J", "status\nstatus"}) {
    Announcement diagnosis = worked_diagnosis();
    diagnosis.lines = {line};
    EXPECT_EQ(decode(encode(diagnosis)[0]).error(), DecodeError::bad_diagnosis) << line;
  }
}

TEST(Codec, ReadsWhatWasRemovedInAChangeOnly) {
  auto state = worked_example();
  state.peers[0].removed = {77};
  const auto decoded = decode(encode(state)[0]);
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_TRUE(decoded->peers[0].removed.empty());
}

TEST(Codec, CarriesClaimsAndGoodbyes) {
  for (const auto kind : {Kind::claim, Kind::goodbye}) {
    auto announcement = state_of(0);
    announcement.peers.clear();
    announcement.kind = kind;
    const auto parts = decode_all(encode(announcement));
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0], announcement);
  }
}

}  // namespace
}  // namespace geminga::announcement
