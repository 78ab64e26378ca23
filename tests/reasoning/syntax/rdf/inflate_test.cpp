// Packed files give the same axioms as unpacked ones, and bombs cost no more than their limit.
#include "reasoning/syntax/inflate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/packed.hpp"
#include "reasoning/syntax/rdf/reading.hpp"

namespace geminga::rdf {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string turtle = std::string(turtle_prefixes) + ":A a owl:Class ; rdfs:subClassOf :B .\n<#x> a :A .\n";

std::vector<std::string> axioms_of(const std::string& name, std::string_view content) {
  const auto loaded = load_text(name, content);
  if (!loaded) return {to_string(loaded.error())};
  return functional(loaded->source, false);
}

TEST(Inflate, SaysWhatTheFileSaysWithoutIt) {
  // Relative IRIs, too: they are relative to the name without .gz.
  EXPECT_EQ(axioms_of("a.ttl.gz", packed(turtle)), axioms_of("a.ttl", turtle));
  EXPECT_EQ(axioms_of("a.ttl", packed(turtle)), axioms_of("a.ttl", turtle)) << "known by its content";
  EXPECT_EQ(axioms_of("a.ttl.gz", turtle), axioms_of("a.ttl", turtle)) << "unpacked, and not renamed";
  const std::string rdf_xml = xml("<rdf:Description rdf:about='#A'/>");
  EXPECT_EQ(axioms_of("a.owl.gz", packed(rdf_xml)), axioms_of("a.owl", rdf_xml));
}

TEST(Inflate, ReadsMembersThatFollowEachOther) {
  const std::string both = packed(turtle.substr(0, 50)) + packed("") + packed(turtle.substr(50));
  EXPECT_EQ(axioms_of("a.ttl.gz", both), axioms_of("a.ttl", turtle));
}

TEST(Inflate, NamesTheLineOfTheTextThatWasPacked) {
  EXPECT_THAT(refusal("a.ttl.gz", packed("\n\nwrong")), StartsWith("a.ttl.gz:3: "));
}

TEST(Inflate, RefusesWhatIsCutDamagedOrFollowedBySomethingElseWithItsOctet) {
  const std::string whole = packed(turtle);
  for (const std::size_t size : {3U, 10U, 20U, 60U})
    EXPECT_EQ(refusal("a.ttl.gz", whole.substr(0, size)), "a.ttl.gz: cannot be unpacked: it ends too early, at octet " +
                                                              std::to_string(size) + " of the packed file");
  std::string bent = whole;
  bent[bent.size() - 6] ^= 1;  // of the checksum
  EXPECT_THAT(refusal("a.ttl.gz", bent), HasSubstr("cannot be unpacked: incorrect data check, at octet "));
  EXPECT_EQ(refusal("a.ttl.gz", whole + "more"),
            "a.ttl.gz: cannot be unpacked: something else follows what gzip wrote, at octet " +
                std::to_string(whole.size()) + " of the packed file");
  EXPECT_EQ(refusal("a.ttl.gz", packed(whole)), "a.ttl.gz: is packed twice by gzip: unpack it once");
}

TEST(Inflate, GrowsToItsLimitAndNotBeyond) {
  constexpr std::size_t limit = 5000;
  for (const std::size_t size : {limit - 1, limit, limit + 1}) {
    syntax::FileLimits limits;
    limits.inflated_free_bytes = limit;
    limits.inflated_growth = 0;
    const std::string text = turtle + std::string(size - turtle.size(), '\n');
    const std::string said = refusal("a.ttl.gz", packed(text), limits);
    if (size <= limit) {
      EXPECT_EQ(said, "accepted") << size;
    } else {
      EXPECT_THAT(said, StartsWith("a.ttl.gz: unpacks to more than 5000 bytes, the most for its size, at octet "));
    }
  }
}

TEST(Inflate, GrowsWithTheSizeOfThePackedFileAndNeverBeyondThatOfAnyFile) {
  const std::string text = turtle + std::string(100'000, '\n');
  const std::string bytes = packed(text);
  syntax::FileLimits limits;
  limits.inflated_free_bytes = 0;
  limits.inflated_growth = text.size() / bytes.size() + 1;
  EXPECT_EQ(refusal("a.ttl.gz", bytes, limits), "accepted");
  limits.inflated_growth -= 1;
  EXPECT_THAT(refusal("a.ttl.gz", bytes, limits), HasSubstr("the most for its size"));
  limits = {};
  limits.file_bytes = text.size() - 1;
  EXPECT_THAT(refusal("a.ttl.gz", bytes, limits), HasSubstr("unpacks to more than "));
  limits.file_bytes = text.size();
  EXPECT_EQ(refusal("a.ttl.gz", bytes, limits), "accepted");
}

TEST(Inflate, ABombCostsNoMoreThanItsLimit) {
  const std::string bomb = packed(std::string(std::size_t{64} << 20, ' '));
  EXPECT_THAT(refusal("a.ttl.gz", bomb), StartsWith("a.ttl.gz: unpacks to more than 16777216 bytes"));
}

TEST(Inflate, FindsATextThatIsTooLongBeforeTheRestIsUnpacked) {
  syntax::FileLimits limits;
  limits.watched_bytes = 100;
  limits.literal_bytes = 5000;
  limits.inflated_growth = 100'000;
  const std::string text = turtle + ":A rdfs:label \"" + times(3'000'000, "x") + "\" .\n\xff";
  EXPECT_EQ(refusal("a.ttl.gz", packed(text), limits), "a.ttl.gz:4: has a literal of more than 5000 bytes");
}

TEST(Inflate, TakesTheSuffixFromNamesThatHaveMoreThanIt) {
  EXPECT_EQ(syntax::name_without_gz("in/a.owl.gz"), "in/a.owl");
  EXPECT_EQ(syntax::name_without_gz("a.owl"), "a.owl");
  EXPECT_EQ(syntax::name_without_gz(".gz"), ".gz");
}

}  // namespace
}  // namespace geminga::rdf
