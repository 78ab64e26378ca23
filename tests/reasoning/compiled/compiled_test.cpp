// The compiled form: what is damaged is refused with a reason, and nothing in it is trusted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <tuple>
#include <utility>

#include "base/random.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/compiled/container.hpp"
#include "reasoning/modules/module.hpp"
#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "small_units.hpp"
#include "support/written.hpp"

namespace geminga::compiled {
namespace {

using testing::HasSubstr;

std::vector<std::byte> small() {
  owl::Ontology source = owl::written(
      "SubClassOf(A ObjectSomeValuesFrom(r B))\nEquivalentClasses(C ObjectIntersectionOf(A B))\nSubClassOf(D A)\n"
      "SubClassOf(D B)\nDisjointClasses(E C)\nSubClassOf(X C)\nSubClassOf(Y X)\nSubClassOf(Y D)\n"
      "SubClassOf(A ObjectUnionOf(D E))");
  source.add_label("https://t.example/#A", "a");
  source.add_conversion("https://t.example/#X", "https://t.example/#Y", "7", owl::FileId{0}, 1);
  source.add_conversion("https://t.example/#A", "https://t.example/#B", "", owl::FileId{0}, 2);
  source.add_conversion("https://t.example/#A", "https://t.example/#Unknown", "", owl::FileId{0}, 3);
  add_small_units(source);
  return compile(source, owl::classified(source));
}

/// The error of a file that is refused, or of a section when it is first asked for.
std::string refusal(std::vector<std::byte> bytes) {
  const auto ontology = Ontology::from_bytes(std::move(bytes));
  if (!ontology) return ontology.error().text;
  if (const auto whole = ontology->check_whole(); !whole) return whole.error().text;
  return {};
}

/// The sections of a file, to be written again.
std::array<std::span<const std::uint8_t>, section_count> sections_of(const std::vector<std::byte>& whole) {
  const auto file = Container::open(whole);
  EXPECT_TRUE(file);
  std::array<std::span<const std::uint8_t>, section_count> sections;
  for (std::size_t at = 0; at < section_count; ++at) {
    const auto bytes = file->section(static_cast<Section>(at));
    sections[at] = {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  }
  return sections;
}

/// Asks everything of an ontology that was accepted; nothing may crash or run forever.
void ask_everything(const Ontology& ontology) {
  (void)ontology.files();
  (void)ontology.left_out();
  (void)ontology.gaps();
  (void)ontology.digest();
  (void)ontology.conversions();
  (void)ontology.units_left_out();
  for (const char* name : {"pitch", "m", "https://t.example/#Cup"}) (void)ontology.units().find(name);
  for (const char* name : {"t:A", "a", "owl:Thing", "nobody", "<x>"}) (void)ontology.find(name);
  const std::uint32_t count = std::min(ontology.class_count(), 12U);
  for (std::uint32_t one = 0; one < count; ++one) {
    const taxonomy::ClassNumber first{one};
    (void)ontology.iri(first);
    (void)ontology.label(first);
    (void)ontology.short_name(first);
    (void)ontology.parents(first);
    (void)ontology.children(first);
    (void)ontology.subsumers(first);
    for (std::uint32_t other = 0; other < count; ++other) {
      (void)ontology.is_subsumed(first, taxonomy::ClassNumber{other});
      (void)ontology.distance(first, taxonomy::ClassNumber{other});
    }
    for (const std::uint32_t axiom :
         extract_module(ontology.module_index(), {{first, taxonomy::ClassNumber{(one + 3) % count}}})) {
      for (const std::uint32_t term : ontology.axioms().arguments_of_axiom(axiom)) {
        (void)ontology.axioms().name_of_term(term);
        (void)ontology.axioms().number_of_term(term);
      }
    }
  }
}

TEST(Compiled, IsReadBack) { EXPECT_EQ(refusal(small()), ""); }

TEST(Compiled, HasTheConversionsBetweenItsClassesByTheirNumbers) {
  const auto ontology = Ontology::from_bytes(small());
  ASSERT_TRUE(ontology);
  const auto number = [&](const char* name) { return static_cast<std::uint32_t>(*ontology->find(name)); };
  ASSERT_EQ(ontology->conversions().size(), 2U);
  const taxonomy::Conversion& first = ontology->conversions()[0];
  EXPECT_EQ(std::tuple(first.from, first.to, first.cost), std::tuple(number("t:A"), number("t:B"), 1U));
  const taxonomy::Conversion& second = ontology->conversions()[1];
  EXPECT_EQ(std::tuple(second.from, second.to, second.cost), std::tuple(number("t:X"), number("t:Y"), 7U));
  const auto left_out = ontology->left_out();
  const auto unknown = std::ranges::find(left_out, "geminga:convertsTo of what is no class", &owl::LeftOut::construct);
  ASSERT_NE(unknown, left_out.end());
  EXPECT_EQ(unknown->first, "written.ofn:3");
}

TEST(Compiled, IsRefusedWhereANumberOfAConversionIsWrong) {
  const auto refused = [](const auto& change) {
    std::vector<std::byte> bytes = small();
    const auto view = view_taxonomy(*Container::open(bytes));
    EXPECT_TRUE(view);
    const auto conversions = conversions_of(*view);
    const auto at = reinterpret_cast<const std::byte*>(conversions.data()) - bytes.data();
    change(reinterpret_cast<taxonomy::Conversion*>(bytes.data() + at), view->view.class_count());
    seal(bytes);
    return refusal(std::move(bytes));
  };
  using taxonomy::Conversion;
  EXPECT_EQ(refused([](Conversion*, std::uint32_t) {}), "");
  EXPECT_EQ(refused([](Conversion* all, std::uint32_t count) { all[1].to = count - 1; }), "");
  EXPECT_THAT(refused([](Conversion* all, std::uint32_t count) { all[1].to = count; }), HasSubstr("is converted"));
  EXPECT_THAT(refused([](Conversion* all, std::uint32_t count) { all[1].from = count; }), HasSubstr("is converted"));
  EXPECT_THAT(refused([](Conversion* all, std::uint32_t) { all[0].cost = 0; }), HasSubstr("the cost of a conversion"));
  EXPECT_EQ(refused([](Conversion* all, std::uint32_t) { all[0].cost = owl::max_conversion_cost; }), "");
  EXPECT_THAT(refused([](Conversion* all, std::uint32_t) { all[0].cost = owl::max_conversion_cost + 1; }),
              HasSubstr("the cost of a conversion"));
  EXPECT_THAT(refused([](Conversion* all, std::uint32_t) { std::swap(all[0], all[1]); }), HasSubstr("the order"));
  EXPECT_THAT(refused([](Conversion* all, std::uint32_t) { all[1] = all[0]; }), HasSubstr("the order"));
}

TEST(Compiled, IsRefusedWithEveryBitFlipped) {
  const std::vector<std::byte> whole = small();
  for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
    std::vector<std::byte> bytes = whole;
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    ASSERT_NE(refusal(std::move(bytes)), "") << "bit " << bit;
  }
}

TEST(Compiled, IsRefusedAtTheStartWhereTheHeaderOrTheTaxonomyIsDamaged) {
  const std::vector<std::byte> whole = small();
  const std::size_t end = container_header_bytes + sections_of(whole)[0].size();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::vector<std::byte> bytes = whole;
    bytes[at] ^= std::byte{0x10};
    ASSERT_EQ(Ontology::from_bytes(std::move(bytes)).has_value(), at >= end) << "octet " << at;
  }
}

TEST(Compiled, AnswersWithoutItsAxiomsAndLabelsWhereTheseAreDamaged) {
  const std::vector<std::byte> whole = small();
  const auto sections = sections_of(whole);
  const std::size_t labels_at = container_header_bytes + sections[0].size();
  std::vector<std::byte> damaged = whole;
  damaged[labels_at + sections[1].size() / 2] ^= std::byte{1};
  damaged.back() ^= std::byte{1};
  const auto ontology = Ontology::from_bytes(damaged);
  ASSERT_TRUE(ontology) << ontology.error().text;
  const auto d = ontology->find("t:D");
  ASSERT_TRUE(d);
  EXPECT_TRUE(ontology->is_subsumed(*d, *ontology->find("t:C")));
  EXPECT_THAT(ontology->check_labels().error().text,
              HasSubstr("the checksum at offset 40 is not that of the labels at offset " + std::to_string(labels_at)));
  EXPECT_THAT(ontology->check_axioms().error().text,
              HasSubstr("the checksum at offset 56 is not that of the axioms at offset " +
                        std::to_string(labels_at + sections[1].size())));
  EXPECT_EQ(ontology->label(*d), "");
  EXPECT_THAT(ontology->find("a").error().text, HasSubstr("labels cannot be read: the compiled ontology is damaged"));
  EXPECT_EQ(ontology->axioms().axiom_count(), 0U);
  EXPECT_TRUE(extract_module(ontology->module_index(), {{*d}}).empty());
  ask_everything(*ontology);
}

TEST(Compiled, IsRefusedWhereSectionsAreOfDifferentFiles) {
  const std::vector<std::byte> one = small();
  owl::Ontology source = owl::written("SubClassOf(A B)");
  const std::vector<std::byte> other = compile(source, owl::classified(source));
  auto mixed = sections_of(one);
  mixed[2] = sections_of(other)[2];
  EXPECT_THAT(refusal(wrap(mixed)), HasSubstr("cannot be right"));
}

TEST(Compiled, IsRefusedWhereverItIsCut) {
  const std::vector<std::byte> whole = small();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::vector<std::byte> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    ASSERT_FALSE(Ontology::from_bytes(cut)) << size << " bytes";
  }
  std::vector<std::byte> longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_THAT(refusal(longer), HasSubstr("promises"));
}

TEST(Compiled, SaysWhatIsWrong) {
  const std::vector<std::byte> whole = small();
  EXPECT_THAT(refusal({}), HasSubstr("0 bytes are less than its header"));
  EXPECT_THAT(refusal(std::vector<std::byte>(100)), HasSubstr("not a compiled ontology: the magic at offset 0"));
  std::vector<std::byte> older = whole;
  older[8] = std::byte{1};
  EXPECT_THAT(refusal(older), HasSubstr("version 1, this program reads 2: compile it again"));
  std::vector<std::byte> damaged = whole;
  damaged[container_header_bytes + 100] ^= std::byte{1};
  EXPECT_THAT(refusal(damaged), HasSubstr("the checksum at offset 24 is not that of the taxonomy at offset 64"));
  std::vector<std::byte> more = whole;
  more[12] = std::byte{4};
  EXPECT_THAT(refusal(more), HasSubstr("the number of sections at offset 12"));
}

TEST(Compiled, SaysWhereANumberIsThatCannotBeRight) {
  std::vector<std::byte> bytes = small();
  const auto ontology = Ontology::from_bytes(bytes);
  ASSERT_TRUE(ontology);
  // The same place in our copy of the bytes.
  const auto* parents = reinterpret_cast<const std::byte*>(ontology->view().parents.data());
  const auto* text = reinterpret_cast<const std::byte*>(ontology->view().class_text.data());
  const auto found = std::ranges::search(bytes, std::span(text, ontology->view().class_text.size()));
  const auto at = static_cast<std::size_t>(found.begin() - bytes.begin() + (parents - text));
  const std::uint32_t wrong = 1'000'000;
  std::memcpy(bytes.data() + at, &wrong, sizeof wrong);
  seal(bytes);
  EXPECT_EQ(refusal(bytes), "the compiled ontology is damaged: a parent at offset " + std::to_string(at) +
                                " cannot be right: compile it again");
}

TEST(Compiled, NestsTermsUpToTheLimitOfReaders) {
  for (const std::uint32_t levels : {499U, 500U, 501U}) {
    owl::Ontology source({.nesting = 1000});
    const owl::FileId file = source.add_file("deep");
    owl::TermId term = source.named_class("https://t.example/#A");
    const owl::TermId role = source.object_property("https://t.example/#r");
    for (std::uint32_t level = 0; level < levels; ++level) {
      term = source.term(owl::TermKind::object_some_values_from, {role, term});
    }
    source.add(owl::AxiomKind::sub_class_of, {source.named_class("https://t.example/#B"), term}, file, 1);
    const std::string words = refusal(compile(source, owl::classified(source)));
    if (levels <= owl::SourceLimits{}.nesting) {
      EXPECT_EQ(words, "") << levels;
    } else {
      EXPECT_THAT(words, HasSubstr("the nesting of a term")) << levels;
    }
  }
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
  const std::vector<std::byte> whole = small();
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    base::Random random(seed);
    std::vector<std::uint8_t> payload(random.below(300));
    for (std::uint8_t& octet : payload) octet = static_cast<std::uint8_t>(random.below(random.chance(0.5) ? 256 : 4));
    const auto sections = sections_of(whole);
    for (std::size_t at = 0; at < section_count; ++at) {
      auto changed = sections;
      changed[at] = payload;
      ASSERT_NE(refusal(wrap(changed)), "") << "seed " << seed << ", section " << at;
    }
  }
}

TEST(Compiled, KeepsWhyAnswersMayBeMissing) {
  owl::Ontology source = owl::written("SubClassOf(ObjectAllValuesFrom(r B) A)\nSubClassOf(A B)");
  source.leave_out("swrl:Imp", owl::FileId{0}, 7, 3);
  const std::vector<std::string> gaps = {"one reason", "two reasons"};
  const taxonomy::Classification classification = owl::classified(source);
  const auto ontology = Ontology::from_bytes(compile(source, classification, {.gaps = gaps, .folder = {}}));
  ASSERT_TRUE(ontology);
  EXPECT_EQ(ontology->gaps(), gaps);
  EXPECT_EQ(ontology->axiom_count(), 2U);
  const std::vector<owl::LeftOut> left_out = ontology->left_out();
  const std::vector<owl::LeftOut> told = taxonomy::left_out(source, classification);
  ASSERT_EQ(left_out.size(), told.size());
  ASSERT_EQ(left_out.size(), 2U);
  for (std::size_t at = 0; at < told.size(); ++at) {
    EXPECT_EQ(left_out[at].construct, told[at].construct);
    EXPECT_EQ(left_out[at].count, told[at].count);
    EXPECT_EQ(left_out[at].first, told[at].first);
  }
  // Which axioms of them there are: the one with the universal, of the construct that is named second or first.
  const taxonomy::ClassifiedView& view = ontology->axioms();
  ASSERT_EQ(view.unused_axiom.size(), 1U);
  EXPECT_EQ(view.axiom_line[view.unused_axiom[0]], 1U);
  EXPECT_NE(left_out[view.unused_group[0]].construct, "swrl:Imp");
}

/// The place of a file that no other process has.
std::filesystem::path own_file(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("geminga-" + name + '-' + std::to_string(::getpid()) + ".gemo");
}

TEST(Compiled, IsMappedFromAFile) {
  const std::filesystem::path path = own_file("mapped");
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
  const std::filesystem::path path = own_file("empty");
  std::ofstream(path, std::ios::binary).flush();
  EXPECT_FALSE(Ontology::map(path));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace geminga::compiled
