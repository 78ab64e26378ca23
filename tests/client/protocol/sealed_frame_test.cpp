// Sealed frames against the vectors of all languages, and what opens no other one.
#include "client/protocol/sealed_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "client/protocol/channel_keys.hpp"
#include "client/protocol/intake.hpp"
#include "client/protocol/life.hpp"
#include "client/protocol/vector_file.hpp"
#include "discovery/gcnp/channel_keyring.hpp"

namespace geminga::client {
namespace {

constexpr const char* forward_digits = "618408bc05ef2b7c262ac0676abe39df9dfe9db66ca3fe78e3e00d4cda7f5fc8";
constexpr const char* back_digits = "201c6285b39c9e9b12c712d9f5045fc698f675d1d8957dbca1d05d6fbceea32b";

/// The line of a daemon with these keys in the ring, first the one of the vectors.
std::string line_of(const std::string& mode, const std::vector<std::string>& others = {}) {
  std::string line = "5 pub keys life=0123456789abcdef mode=" + mode;
  line += std::string(" ring=6208:") + forward_digits + ':' + back_digits;
  for (const std::string& other : others) line += ',' + other;
  return line;
}

std::optional<StatedKeys> read(const std::string& line) { return read_keys(*gcnp::parse(line)); }
ChannelKeys keys_of(const std::string& mode) { return read(line_of(mode))->keys; }

FrameKind kind_of(const std::string& word) {
  if (word == "message") return FrameKind::message;
  if (word == "hello") return FrameKind::hello;
  if (word == "end") return FrameKind::end;
  return word == "floor" ? FrameKind::floor : FrameKind::full;
}

Direction direction_of(const std::string& word) { return word == "forward" ? Direction::forward : Direction::back; }

TEST(SealedFrame, IsSealedAndOpenedAsEveryLanguageDoes) {
  const auto rows = vector_rows("sealed.tsv", 4);
  ASSERT_GE(rows.size(), 20U);
  for (const auto& row : rows) {
    std::vector<std::byte> room;
    if (row[0] == "refused") {
      const auto octets = from_hex(row[2]);
      const auto frame = read_frame(octets);
      EXPECT_FALSE(frame && open_frame(*frame, keys_of("encrypted"), direction_of(row[1]), room)) << row[3];
      continue;
    }
    ASSERT_EQ(row.size(), 10U) << row[0];
    const auto keys = keys_of(row[1] == "2" ? "encrypted" : "authenticated");
    const Life life = *read_life(row[3]);
    const auto payload = from_hex(row[8]);
    const auto octets = from_hex(row[9]);
    Sealer sealer(life, direction_of(row[0]));
    sealer.count_from(std::stoull(row[7]) - 1);
    const auto sealed = sealer.frame(keys, kind_of(row[2]), std::stoull(row[4]), payload,
                                     static_cast<std::uint16_t>(std::stoul(row[6])));
    ASSERT_TRUE(sealed);
    EXPECT_EQ(*sealed, octets) << row[9];
    const auto frame = read_frame(octets);
    ASSERT_TRUE(frame) << row[9];
    EXPECT_EQ(seal_fields(*frame).hello_port, std::stoul(row[6]));
    EXPECT_EQ(seal_fields(*frame).counter, std::stoull(row[7]));
    const auto opened = open_frame(*frame, keys, direction_of(row[0]), room);
    ASSERT_TRUE(opened) << row[9];
    EXPECT_EQ(opened->kind, kind_of(row[2]));
    EXPECT_EQ(opened->life, life);
    EXPECT_EQ(opened->sequence, std::stoull(row[4]));
    EXPECT_TRUE(std::ranges::equal(opened->payload, payload)) << row[9];
  }
}

TEST(SealedFrame, OfADatagramHasALargestPayload) {
  const auto keys = keys_of("encrypted");
  for (const std::size_t size : {max_datagram_payload - 1, max_datagram_payload, max_datagram_payload + 1}) {
    Sealer sealer(Life{1}, Direction::forward);
    const auto octets = sealer.frame(keys, FrameKind::message, 1, std::vector<std::byte>(size));
    ASSERT_TRUE(octets);
    EXPECT_EQ(octets->size(), sealed_size(size));
    EXPECT_EQ(read_frame(*octets).has_value(), size <= max_datagram_payload) << size;
  }
}

TEST(Sealer, UsesNoCounterTwiceAndEndsWithTheLastOne) {
  const auto keys = keys_of("encrypted");
  for (const auto& [direction, last] :
       {std::pair{Direction::forward, ~std::uint64_t{0}}, std::pair{Direction::back, std::uint64_t{0xffff'ffff}}}) {
    Sealer sealer(Life{1}, direction);
    sealer.count_from(last - 2);
    const auto first = sealer.frame(keys, FrameKind::end, 1);
    const auto second = sealer.frame(keys, FrameKind::end, 1);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(seal_fields(*read_frame(*first)).counter, last - 1);
    EXPECT_EQ(seal_fields(*read_frame(*second)).counter, last);
    EXPECT_NE(*first, *second);
    EXPECT_FALSE(sealer.frame(keys, FrameKind::end, 1));
    EXPECT_FALSE(sealer.frame(keys, FrameKind::end, 1));
  }
}

TEST(ChannelKeys, AreReadFromTheLineOfADaemon) {
  const auto stated = read(line_of("encrypted", {std::string("beef:") + back_digits + ':' + forward_digits}));
  ASSERT_TRUE(stated);
  EXPECT_EQ(stated->life, Life{0x0123456789abcdef});
  ASSERT_EQ(stated->keys.ring().size(), 2U);
  EXPECT_EQ(stated->keys.ring()[0].id, 0x6208);
  EXPECT_EQ(stated->keys.ring()[1].id, 0xbeef);
  EXPECT_TRUE(stated->keys.ring()[1].forward == stated->keys.ring()[0].back);
  const auto plain = read("5 pub keys life=0123456789abcdef mode=plain");
  ASSERT_TRUE(plain);
  EXPECT_TRUE(plain->keys == ChannelKeys());
  const std::string ring = std::string(" ring=6208:") + forward_digits + ':' + back_digits;
  for (const std::string& line :
       {std::string("5 pub keys mode=plain"), std::string("5 pub keys life=0123456789abcdef"),
        std::string("5 pub keys life=0123456789abcdef mode=encrypted"),
        "5 pub keys life=0123456789abcdef mode=plain" + ring, "5 pub keys life=0123456789abcdef mode=secret" + ring,
        "5 pub keys life=0123456789abcdef mode=mixed" + ring + ",beef",
        "5 pub keys life=0123456789abcdef mode=mixed" + ring.substr(0, ring.size() - 1),
        "5 pub keys life=0123456789abcdef mode=mixed" + ring + "0",
        "5 pub keys life=0123456789ABCDEF mode=mixed" + ring}) {
    EXPECT_FALSE(read(line)) << line;
  }
}

TEST(ChannelKeys, HaveALargestRing) {
  for (const std::size_t size : {gcnp::max_channel_keys - 1, gcnp::max_channel_keys, gcnp::max_channel_keys + 1}) {
    const std::vector<std::string> others(size - 1, std::string("beef:") + back_digits + ':' + forward_digits);
    EXPECT_EQ(read(line_of("mixed", others)).has_value(), size <= gcnp::max_channel_keys) << size;
  }
}

TEST(ChannelKeys, OpenWhatAnyKeyOfTheRingHasSealed) {
  const auto old = keys_of("encrypted");
  const auto both = ChannelKeys(SealingMode::encrypted, {{0xbeef, Secret::random(), Secret::random()}, old.ring()[0]});
  const auto other = ChannelKeys(SealingMode::encrypted, {{0x6208, Secret::random(), Secret::random()}, old.ring()[0]});
  std::vector<std::byte> room;
  Sealer sealer(Life{1}, Direction::forward);
  const auto by_old = *sealer.frame(old, FrameKind::message, 1, from_hex("62616c6c"));
  const auto by_new = *sealer.frame(both, FrameKind::message, 2, from_hex("62616c6c"));
  EXPECT_TRUE(open_frame(*read_frame(by_old), both, Direction::forward, room));
  EXPECT_TRUE(open_frame(*read_frame(by_new), both, Direction::forward, room));
  EXPECT_FALSE(open_frame(*read_frame(by_new), old, Direction::forward, room)) << "an unknown id";
  EXPECT_TRUE(open_frame(*read_frame(by_old), other, Direction::forward, room)) << "two keys with one id";
}

/// Whether a host of this mode takes a frame in this form.
bool takes(const std::string& mode, FrameForm form) {
  const auto keys = mode == "plain" ? ChannelKeys() : keys_of(mode);
  const auto senders =
      form == FrameForm::plain ? ChannelKeys() : keys_of(form == FrameForm::encrypted ? "encrypted" : "authenticated");
  Sealer sealer(Life{1}, Direction::forward);
  const auto octets = *sealer.frame(senders, FrameKind::message, 1);
  std::vector<std::byte> room;
  return Intake(keys).open(*read_frame(octets), room).has_value();
}

TEST(Intake, TakesTheFormsOfItsMode) {
  for (const std::string mode : {"plain", "prepared", "mixed", "authenticated", "encrypted"}) {
    const bool is_strict = mode == "authenticated" || mode == "encrypted";
    EXPECT_EQ(takes(mode, FrameForm::plain), !is_strict) << mode;
    EXPECT_EQ(takes(mode, FrameForm::encrypted), mode != "plain") << mode;
    EXPECT_EQ(takes(mode, FrameForm::authenticated), mode != "plain") << mode;
  }
  EXPECT_EQ(keys_of("prepared").form(), FrameForm::plain);
  EXPECT_EQ(keys_of("mixed").form(), FrameForm::encrypted);
  EXPECT_EQ(keys_of("authenticated").form(), FrameForm::authenticated);
  EXPECT_EQ(keys_of("encrypted").form(), FrameForm::encrypted);
}

TEST(Intake, TakesNoPlainFrameAfterASealedOne) {
  Intake intake(keys_of("mixed"));
  Sealer sealer(Life{1}, Direction::forward);
  const auto plain = frame_bytes({FrameKind::message, Life{1}, 1, {}});
  const auto sealed = *sealer.frame(keys_of("encrypted"), FrameKind::message, 2);
  auto forged = sealed;
  forged.back() ^= std::byte{1};
  std::vector<std::byte> room;
  EXPECT_FALSE(intake.open(*read_frame(forged), room));
  EXPECT_TRUE(intake.open(*read_frame(plain), room)) << "a forged one counts for nothing";
  EXPECT_TRUE(intake.open(*read_frame(sealed), room));
  EXPECT_FALSE(intake.open(*read_frame(plain), room));
  intake.set_keys(ChannelKeys());
  EXPECT_TRUE(intake.open(*read_frame(plain), room)) << "keys are gone";
}

}  // namespace
}  // namespace geminga::client
