// The compiled form: what is damaged is refused with a reason, and nothing in it is trusted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <xxhash.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/random.hpp"
#include "el/compile.hpp"
#include "el/container.hpp"
#include "el/module.hpp"
#include "written.hpp"

namespace geminga::el {
namespace {

using testing::HasSubstr;

std::vector<std::byte> small() {
  OntologySource source = written(
      "SubClassOf(A ObjectSomeValuesFrom(r B))\nEquivalentClasses(C ObjectIntersectionOf(A B))\nSubClassOf(D A)\n"
      "SubClassOf(D B)\nDisjointClasses(E C)\nSubClassOf(X C)\nSubClassOf(Y X)\nSubClassOf(Y D)\n"
      "SubClassOf(A ObjectUnionOf(D E))");
  source.add_label("https://t.example/#A", "a");
  return compile(source, classified(source));
}

std::string refusal(std::vector<std::byte> bytes) {
  const auto ontology = Ontology::from_bytes(std::move(bytes));
  return ontology ? std::string() : ontology.error().text;
}

/// Puts the right checksum over a payload that was changed, as one would who means harm.
void seal(std::vector<std::byte>& bytes) {
  const std::uint64_t size = bytes.size() - container_header_bytes;
  const std::uint64_t sum = XXH3_64bits_withSeed(bytes.data() + container_header_bytes, size, size);
  std::memcpy(bytes.data() + 16, &size, sizeof size);
  std::memcpy(bytes.data() + 24, &sum, sizeof sum);
}

/// Asks everything of an ontology that was accepted; nothing may crash or run forever.
void ask_everything(const Ontology& ontology) {
  (void)ontology.files();
  (void)ontology.left_out();
  (void)ontology.digest();
  for (const char* name : {"t:A", "a", "owl:Thing", "nobody", "<x>"}) (void)ontology.find(name);
  const std::uint32_t count = std::min(ontology.class_count(), 12U);
  for (std::uint32_t one = 0; one < count; ++one) {
    const ClassNumber first{one};
    (void)ontology.iri(first);
    (void)ontology.label(first);
    (void)ontology.short_name(first);
    (void)ontology.parents(first);
    (void)ontology.children(first);
    (void)ontology.subsumers(first);
    for (std::uint32_t other = 0; other < count; ++other) {
      (void)ontology.is_subsumed(first, ClassNumber{other});
      (void)ontology.distance(first, ClassNumber{other});
    }
    (void)extract_module(ontology.module_index(), {{first, ClassNumber{(one + 3) % count}}});
  }
}

TEST(Compiled, IsReadBack) { EXPECT_EQ(refusal(small()), ""); }

TEST(Compiled, IsRefusedWithEveryBitFlipped) {
  const std::vector<std::byte> whole = small();
  for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
    std::vector<std::byte> bytes = whole;
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    ASSERT_NE(refusal(std::move(bytes)), "") << "bit " << bit;
  }
}

TEST(Compiled, IsRefusedWhereverItIsCut) {
  const std::vector<std::byte> whole = small();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    ASSERT_NE(refusal({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}), "") << size << " bytes";
  }
  std::vector<std::byte> longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_THAT(refusal(longer), HasSubstr("promises"));
}

TEST(Compiled, SaysWhatIsWrong) {
  const std::vector<std::byte> whole = small();
  EXPECT_THAT(refusal({}), HasSubstr("0 bytes are less than its header"));
  EXPECT_THAT(refusal(std::vector<std::byte>(100)), HasSubstr("not a compiled ontology: the magic at offset 0"));
  std::vector<std::byte> newer = whole;
  newer[8] = std::byte{2};
  EXPECT_THAT(refusal(newer), HasSubstr("version 2, this program reads 1: compile it again"));
  std::vector<std::byte> damaged = whole;
  damaged.back() ^= std::byte{1};
  EXPECT_THAT(refusal(damaged), HasSubstr("checksum"));
}

TEST(Compiled, SurvivesDamageUnderARightChecksum) {
  const std::vector<std::byte> whole = small();
  int accepted = 0;
  for (std::size_t bit = container_header_bytes * 8; bit < whole.size() * 8; ++bit) {
    std::vector<std::byte> bytes = whole;
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    seal(bytes);
    SCOPED_TRACE("bit " + std::to_string(bit));
    if (const auto ontology = Ontology::from_bytes(std::move(bytes))) {
      ++accepted;
      ask_everything(*ontology);
    }
  }
  EXPECT_GT(accepted, 0);
}

TEST(Compiled, SurvivesRandomDamageUnderARightChecksum) {
  const std::vector<std::byte> whole = small();
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    base::Random random(seed);
    std::vector<std::byte> bytes = whole;
    for (std::uint64_t changes = 1 + random.below(6); changes > 0; --changes) {
      const std::size_t at = container_header_bytes + random.below((bytes.size() - container_header_bytes) / 4) * 4;
      const auto value = static_cast<std::uint32_t>(random.chance(0.7) ? random.below(40) : random.next());
      std::memcpy(bytes.data() + at, &value, std::min<std::size_t>(4, bytes.size() - at));
    }
    seal(bytes);
    SCOPED_TRACE("seed " + std::to_string(seed));
    if (const auto ontology = Ontology::from_bytes(std::move(bytes))) ask_everything(*ontology);
  }
}

TEST(Compiled, SurvivesRandomBytesUnderARightHeader) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    base::Random random(seed);
    std::vector<std::uint8_t> payload(random.below(300));
    for (std::uint8_t& octet : payload) octet = static_cast<std::uint8_t>(random.below(random.chance(0.5) ? 256 : 4));
    ASSERT_NE(refusal(wrap(payload)), "") << "seed " << seed;
  }
}

TEST(Compiled, IsMappedFromAFile) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "geminga-el-compiled-test.gemo";
  const std::vector<std::byte> whole = small();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(whole.data()), static_cast<std::streamsize>(whole.size()));
  const auto ontology = Ontology::map(path);
  ASSERT_TRUE(ontology) << ontology.error().text;
  EXPECT_TRUE(ontology->find("t:A"));
  std::filesystem::remove(path);
  const auto missing = Ontology::map(path);
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().text, HasSubstr(path.string()));
  EXPECT_FALSE(Ontology::map(testing::TempDir()));
}

TEST(Compiled, IsRefusedEmptyFromAFile) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "geminga-el-empty-test.gemo";
  std::ofstream(path, std::ios::binary).flush();
  EXPECT_FALSE(Ontology::map(path));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace geminga::el
