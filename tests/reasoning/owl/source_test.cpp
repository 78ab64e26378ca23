// The axioms that a source takes, those that it leaves out as malformed, and its limits.
#include "reasoning/owl/source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/el/classify.hpp"
#include "reasoning/owl/canonical.hpp"

namespace geminga::owl {
namespace {

using testing::HasSubstr;

TEST(Ontology, InternsEqualTerms) {
  Ontology source;
  const TermId a = source.named_class("urn:a");
  const TermId r = source.object_property("urn:r");
  EXPECT_EQ(source.named_class("urn:a"), a);
  EXPECT_NE(source.individual("urn:a"), a);
  const TermId some = source.term(TermKind::object_some_values_from, {r, a});
  EXPECT_EQ(source.term(TermKind::object_some_values_from, {r, a}), some);
  EXPECT_NE(source.term(TermKind::object_min_cardinality, {r, a}, 1),
            source.term(TermKind::object_min_cardinality, {r, a}, 2));
  EXPECT_EQ(source.depth(some), 1);
  EXPECT_EQ(source.named_class(owl_thing), thing_term);
  EXPECT_EQ(source.literal("1", ""), source.literal("1", "http://www.w3.org/2001/XMLSchema#string"));
  EXPECT_NE(source.literal("1", "", "en"), source.literal("1", ""));
}

// 16 MiB, and 256 octets for each name.
TEST(Ontology, TakesLongNamesButNotOnlyToFillTheMemory) {
  const auto with_names = [](std::size_t count, std::size_t size) {
    Ontology source;
    for (std::size_t at = 0; at < count; ++at) {
      std::string name = std::to_string(at);
      name.resize(size, 'n');
      source.named_class(name);
    }
    return source.problem().value_or("");
  };
  EXPECT_EQ(with_names(256, 65'536), "");
  EXPECT_THAT(with_names(258, 65'536), HasSubstr("bytes together"));
  EXPECT_EQ(with_names(100'000, 250), "") << "as many octets of usual names are no problem";
}

TEST(Ontology, LeavesOutWhatIsMalformed) {
  Ontology source;
  const FileId file = source.add_file("f");
  const TermId a = source.named_class("urn:a");
  const TermId r = source.object_property("urn:r");
  source.add(AxiomKind::sub_class_of, {a, r}, file, 3);
  source.add(AxiomKind::sub_class_of, {a}, file, 4);
  source.add(AxiomKind::sub_class_of, {a, source.term(TermKind::object_some_values_from, {a, r})}, file, 5);
  const TermId inner = source.term(TermKind::object_complement_of, {r});
  source.add(AxiomKind::sub_class_of, {a, source.term(TermKind::object_intersection_of, {a, inner})}, file, 6);
  EXPECT_EQ(source.axiom_count(), 0);
  ASSERT_EQ(source.omissions().size(), 1);
  EXPECT_EQ(source.omissions()[0].count, 4);
  EXPECT_EQ(source.omissions()[0].line, 3);
  EXPECT_EQ(source.name(source.omissions()[0].construct), "malformed SubClassOf");
}

TEST(Ontology, LeavesOutLiteralsThatAreNotOfTheirDatatypeWhereverTheyAre) {
  Ontology source;
  const FileId file = source.add_file("f");
  const TermId a = source.named_class("urn:a");
  const TermId u = source.data_property("urn:u");
  const std::string integer = "http://www.w3.org/2001/XMLSchema#integer";
  const TermId bad = source.literal("x", integer);
  EXPECT_FALSE(source.is_well_typed(bad));
  EXPECT_TRUE(source.is_well_typed(source.literal("1", integer)));
  EXPECT_TRUE(source.is_well_typed(source.literal("x", "urn:unknown")));
  source.add(AxiomKind::data_property_assertion, {u, source.individual("urn:i"), bad}, file, 3);
  const TermId values = source.term(TermKind::data_one_of, {source.literal("1", integer), bad});
  source.add(AxiomKind::sub_class_of, {a, source.term(TermKind::data_some_values_from, {u, values})}, file, 4);
  EXPECT_EQ(source.axiom_count(), 0);
  ASSERT_EQ(source.omissions().size(), 1);
  EXPECT_EQ(source.omissions()[0].count, 2);
  EXPECT_EQ(source.name(source.omissions()[0].construct), "a literal that is not of its datatype");
}

TEST(Ontology, LeavesOutWhatIsNestedTooDeeply) {
  const SourceLimits limits{.nesting = 5};
  Ontology source(limits);
  const FileId file = source.add_file("f");
  const TermId a = source.named_class("urn:a");
  TermId nested = a;
  for (std::uint32_t depth = 1; depth <= 6; ++depth) {
    source.add(AxiomKind::sub_class_of, {a, nested}, file, depth);
    nested = source.term(TermKind::object_complement_of, {nested});
  }
  EXPECT_EQ(source.axiom_count(), 5);  // with 0 to 4 levels of complements, the axiom being one
  ASSERT_EQ(source.omissions().size(), 1);
  EXPECT_EQ(source.omissions()[0].line, 6);
  EXPECT_FALSE(source.problem());
}

TEST(Ontology, SurvivesNestingWithoutEnd) {
  Ontology source;
  const FileId file = source.add_file("f");
  TermId nested = source.named_class("urn:a");
  for (int depth = 0; depth < 200'000; ++depth) nested = source.term(TermKind::object_complement_of, {nested});
  source.add(AxiomKind::sub_class_of, {nested, nested}, file, 1);
  EXPECT_EQ(source.axiom_count(), 0);
  EXPECT_TRUE(el::classify(source));
}

TEST(Ontology, TakesAsMuchAsItsLimitsAndSaysWhatIsOver) {
  const struct {
    const char* what;
    SourceLimits limits;
    std::size_t fits;
    void (*add)(Ontology&, std::size_t);
  } cases[] = {
      {"bytes", {.name_bytes = 40}, 40, [](Ontology& s, std::size_t n) { s.named_class(std::string(n, 'x')); }},
      {"bytes", {.literal_bytes = 50}, 50, [](Ontology& s, std::size_t n) { s.literal(std::string(n, 'x'), "urn:d"); }},
      {"terms",
       {.terms = 12},
       10,
       [](Ontology& s, std::size_t n) {
         for (std::size_t at = 0; at < n; ++at) s.named_class("urn:" + std::to_string(at));
       }},
      {"axioms",
       {.axioms = 7},
       7,
       [](Ontology& s, std::size_t n) {
         const FileId file = s.add_file("f");
         for (std::size_t at = 0; at < n; ++at) s.add(AxiomKind::sub_class_of, {thing_term, thing_term}, file, 1);
       }},
      {"arguments",
       {.arguments = 20},
       10,
       [](Ontology& s, std::size_t n) {
         const FileId file = s.add_file("f");
         for (std::size_t at = 0; at < n; ++at) s.add(AxiomKind::sub_class_of, {thing_term, thing_term}, file, 1);
       }},
      {"files",
       {.files = 3},
       3,
       [](Ontology& s, std::size_t n) {
         for (std::size_t at = 0; at < n; ++at) s.add_file("f" + std::to_string(at));
       }},
      {"bytes together",
       {.all_name_bytes = owl_thing.size() + owl_nothing.size() + owl_top_object_property.size() +
                          owl_bottom_object_property.size() + owl_top_data_property.size() +
                          owl_bottom_data_property.size() + 100},
       100,  // beside the two names of OWL
       [](Ontology& s, std::size_t n) { s.named_class(std::string(n, 'x')); }},
  };
  for (const auto& one : cases) {
    for (const std::size_t amount : {one.fits - 1, one.fits}) {
      Ontology source(one.limits);
      one.add(source, amount);
      EXPECT_FALSE(source.problem()) << one.what << " " << amount << ": " << *source.problem();
    }
    Ontology source(one.limits);
    one.add(source, one.fits + 1);
    ASSERT_TRUE(source.problem()) << one.what;
    EXPECT_THAT(*source.problem(), HasSubstr(one.what));
    EXPECT_FALSE(el::classify(source));
  }
}

TEST(Ontology, KeepsNamesThatAreLongerThanALabelMayBeOutOfLabels) {
  const SourceLimits limits{.name_bytes = 100};
  Ontology source(limits);
  source.add_label("urn:a", std::string(101, 'x'));
  EXPECT_FALSE(source.problem());
  EXPECT_TRUE(source.labels().empty());
}

TEST(Conversions, HaveACostFromOneUpAndTheLowestOfAPairCounts) {
  Ontology source;
  const FileId file = source.add_file("a.ttl");
  source.add_conversion("urn:a", "urn:b", "5", file, 1);
  source.add_conversion("urn:a", "urn:b", "3", file, 2);
  source.add_conversion("urn:a", "urn:b", "4", file, 3);
  source.add_conversion("urn:b", "urn:a", "", file, 4);
  source.add_conversion("urn:c", "urn:d", "1", file, 5);
  source.add_conversion("urn:d", "urn:c", "1000000", file, 6);
  std::vector<std::uint32_t> costs;
  for (const auto& one : source.conversions()) costs.push_back(one.cost);
  EXPECT_EQ(costs, (std::vector<std::uint32_t>{3, 1, 1, max_conversion_cost}));
  for (const char* wrong : {"0", "-1", "1000001", "1.5", "two", "99999999999999999999"}) {
    source.add_conversion("urn:e", "urn:f", wrong, file, 7, 9);
  }
  EXPECT_EQ(source.conversions().size(), 4U);
  ASSERT_EQ(source.omissions().size(), 1U);
  EXPECT_EQ(source.omissions()[0].count, 6U);
  EXPECT_EQ(source.omissions()[0].line, 9U) << "the line of the cost";
  EXPECT_THAT(source.name(source.omissions()[0].construct), HasSubstr("geminga:conversionCost"));
}

TEST(Conversions, AreLimited) {
  Ontology source;
  const FileId file = source.add_file("a.ttl");
  const auto add = [&](std::size_t number) {
    source.add_conversion("urn:a", "urn:" + std::to_string(number), "", file, 1);
  };
  for (std::size_t number = 0; number < max_conversions; ++number) add(number);
  add(0);
  EXPECT_FALSE(source.problem());
  add(max_conversions);
  ASSERT_TRUE(source.problem());
  EXPECT_THAT(*source.problem(), HasSubstr("more than 1024 conversions"));
}

TEST(Conversions, ArePartOfTheDigestInAnyOrder) {
  const auto digest_of = [](const std::vector<std::pair<const char*, const char*>>& conversions, const char* cost) {
    Ontology source;
    const FileId file = source.add_file("a.ttl");
    for (const auto& [from, to] : conversions) source.add_conversion(from, to, cost, file, 1);
    return digest(source);
  };
  EXPECT_EQ(digest_of({{"urn:a", "urn:b"}, {"urn:b", "urn:a"}}, ""),
            digest_of({{"urn:b", "urn:a"}, {"urn:a", "urn:b"}}, "1"));
  EXPECT_NE(digest_of({{"urn:a", "urn:b"}}, "1"), digest_of({{"urn:a", "urn:b"}}, "2"));
  EXPECT_NE(digest_of({{"urn:a", "urn:b"}}, "1"), digest_of({{"urn:b", "urn:a"}}, "1"));
  EXPECT_NE(digest_of({{"urn:a", "urn:b"}}, "1"), digest_of({}, "1"));
}

}  // namespace
}  // namespace geminga::owl
