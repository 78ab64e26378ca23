// The promises of the score: the order of cases, and its ends.
#include "reasoning/signature/score.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/random.hpp"

namespace geminga::signature {
namespace {

constexpr Concept print{0};
constexpr Concept book{1};
constexpr Concept novel{2};
constexpr Concept romance{3};
constexpr Concept magazine{4};
constexpr Concept price{5};
constexpr Concept taxed{6};
constexpr Concept maximal{7};
constexpr Concept person{8};
constexpr Concept author{9};
constexpr Concept top{10};
constexpr std::uint32_t count = 11;

/// A bookshop.
struct Shop {
  Hierarchy hierarchy{count,
                      std::array<Inclusion, 8>{{{book, print},
                                                {novel, book},
                                                {romance, novel},
                                                {magazine, print},
                                                {taxed, price},
                                                {maximal, price},
                                                {author, person},
                                                {person, top}}},
                      top};
  Scorer scorer{hierarchy};

  double total(const Signature& request, const Signature& service) { return scorer.score(request, service).total; }
  /// True if each service is better than the next.
  void expect_order(const Signature& request, const std::vector<Signature>& services) {
    for (std::size_t at = 1; at < services.size(); ++at)
      EXPECT_GT(total(request, services[at - 1]), total(request, services[at])) << "number " << at;
  }
};

TEST(Satisfaction, GoesFromTheSameToNothingInCommon) {
  Shop shop;
  EXPECT_DOUBLE_EQ(shop.scorer.satisfaction(book, book), 1);
  const double narrower = shop.scorer.satisfaction(book, novel);
  const double broader = shop.scorer.satisfaction(book, print);
  const double sibling = shop.scorer.satisfaction(book, magazine);
  EXPECT_GT(narrower, shop.scorer.satisfaction(book, romance));
  EXPECT_GT(shop.scorer.satisfaction(book, romance), broader);
  EXPECT_GT(broader, sibling);
  EXPECT_GT(sibling, 0);
  EXPECT_DOUBLE_EQ(shop.scorer.satisfaction(book, price), 0);
}

TEST(Satisfaction, CostsWhatIsMissingInFullAndWhatIsSurplusAQuarterAtMost) {
  Shop shop;
  const double world = std::log2(2.0 * count);
  const double of_print = world - std::log2(5.0);
  const double of_book = world - std::log2(3.0);
  const double met = of_print / of_book;
  EXPECT_DOUBLE_EQ(shop.scorer.satisfaction(book, print), met * met);
  EXPECT_DOUBLE_EQ(shop.scorer.satisfaction(print, book), 1 - weight::surplus * (1 - met));
  EXPECT_DOUBLE_EQ(shop.scorer.satisfaction(magazine, book),
                   of_print / world * (of_print / world) * (1 - weight::surplus * (1 - met)));
}

TEST(Satisfaction, TakesAnythingForTheTopAndTheTopForNothing) {
  Shop shop;
  EXPECT_DOUBLE_EQ(shop.scorer.satisfaction(top, romance), 1 - weight::surplus);
  EXPECT_DOUBLE_EQ(shop.scorer.satisfaction(romance, top), 0);
  EXPECT_DOUBLE_EQ(shop.scorer.satisfaction(top, top), 1);
}

TEST(Relation, IsNamedFromTheSideOfWhoRequires) {
  Shop shop;
  EXPECT_EQ(shop.scorer.relation(book, book), Relation::equivalent);
  EXPECT_EQ(shop.scorer.relation(book, romance), Relation::narrower);
  EXPECT_EQ(shop.scorer.relation(book, print), Relation::broader);
  EXPECT_EQ(shop.scorer.relation(book, magazine), Relation::related);
  EXPECT_EQ(shop.scorer.relation(book, author), Relation::none);
  EXPECT_EQ(to_string(Relation::narrower), "narrower");
}

TEST(Score, IsOneForTheSameSignatureOnly) {
  Shop shop;
  EXPECT_DOUBLE_EQ(shop.total({{book}, {price}}, {{book}, {price}}), 1);
  EXPECT_DOUBLE_EQ(shop.total({{}, {}}, {{}, {}}), 1);
  EXPECT_DOUBLE_EQ(shop.total({{book, author}, {price, price}}, {{author, book}, {price, price}}), 1);
  EXPECT_LT(shop.total({{book}, {price}}, {{book}, {taxed}}), 1);
}

TEST(Score, TakesInputsContravariantAndOutputsCovariant) {
  Shop shop;
  // A service for all print suits a request with a book; one for novels may not. A taxed price is a price.
  shop.expect_order({{book}, {price}},
                    {{{print}, {price}}, {{novel}, {price}}, {{magazine}, {price}}, {{person}, {price}}});
  shop.expect_order({{book}, {taxed}}, {{{book}, {taxed}}, {{book}, {price}}, {{book}, {maximal}}, {{book}, {author}}});
}

TEST(Score, WantsBothSidesToBeRight) {
  Shop shop;
  shop.expect_order({{book}, {price}},
                    {{{novel}, {taxed}}, {{person}, {price}}, {{book}, {author}}, {{person}, {author}}});
  EXPECT_DOUBLE_EQ(shop.total({{book}, {price}}, {{person}, {price}}), weight::wrong_inputs);
  EXPECT_DOUBLE_EQ(shop.total({{book}, {price}}, {{book}, {author}}), weight::wrong_outputs);
}

TEST(Score, CountsEachWantedOutputTheSame) {
  Shop shop;
  const Signature request{{book}, {price, author}};
  shop.expect_order(request,
                    {{{book}, {author, price}}, {{book}, {price, author, person}}, {{book}, {price}}, {{book}, {}}});
  EXPECT_DOUBLE_EQ(shop.total(request, {{book}, {price}}), shop.total(request, {{book}, {author}}));
  const Score score = shop.scorer.score(request, {{book}, {author}});
  EXPECT_FALSE(score.output_pairs[0].offered);
  EXPECT_EQ(score.output_pairs[1].offered, 0U);
  EXPECT_DOUBLE_EQ(score.outputs, 0.5);
}

TEST(Score, CostsInputsThatTheRequestCannotGiveAndThoseThatAreNotUsed) {
  Shop shop;
  shop.expect_order({{book}, {price}}, {{{book}, {price}}, {{book, author}, {price}}, {{author}, {price}}});
  shop.expect_order({{book, author}, {price}},
                    {{{book, author}, {price}}, {{book}, {price}}, {{}, {price}}, {{magazine}, {taxed}}});
}

TEST(Score, LeavesOpenWhatARequestIsAboutThatGivesNothing) {
  Shop shop;
  shop.expect_order({{}, {price}},
                    {{{}, {price}}, {{book}, {price}}, {{book, author}, {price}}, {{}, {person}}, {{book}, {person}}});
  // The same as an input beyond the right ones.
  EXPECT_DOUBLE_EQ(shop.scorer.score({{}, {price}}, {{book}, {price}}).inputs,
                   shop.scorer.score({{author}, {price}}, {{author, book}, {price}}).inputs);
}

TEST(Score, StaysBetweenItsEndsForAnySignature) {
  base::Random random(7);
  Shop shop;
  const auto some = [&] {
    std::vector<Concept> concepts(random.below(4));
    for (Concept& one : concepts) one = Concept{static_cast<std::uint32_t>(random.below(count))};
    return concepts;
  };
  for (int round = 0; round < 2000; ++round) {
    const Signature request{some(), some()};
    const Signature service{some(), some()};
    const Score score = shop.scorer.score(request, service);
    EXPECT_GE(score.total, weight::wrong_inputs * weight::wrong_outputs - 1e-12);
    EXPECT_LE(score.total, 1 + 1e-12);
    EXPECT_LE(score.total, shop.total(request, request) + 1e-12);
  }
}

TEST(Score, TakesAsManyParametersAsThereMayBe) {
  Shop shop;
  const Signature request{std::vector<Concept>(max_parameters, book), std::vector<Concept>(max_parameters, price)};
  EXPECT_DOUBLE_EQ(shop.total(request, request), 1);
}

}  // namespace
}  // namespace geminga::signature
