// An ontology is prepared while the event loop reads it. A preparation that is given up has no result.
#include "daemon/ontology/preparation.hpp"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <string>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"

namespace geminga::daemon {
namespace {

using vocabulary::Vocabulary;

/// A chain of classes, each with a label.
std::shared_ptr<const compiled::Ontology> ontology_of(int classes) {
  owl::Ontology source;
  const owl::FileId file = source.add_file("chain.ttl");
  const auto iri = [](int number) { return "http://chain.example/#C" + std::to_string(number); };
  for (int number = 1; number < classes; ++number) {
    source.add(owl::AxiomKind::sub_class_of, {source.named_class(iri(number)), source.named_class(iri(number - 1))},
               file, static_cast<std::uint32_t>(number));
    source.add_label(iri(number), "class " + std::to_string(number));
  }
  return std::make_shared<const compiled::Ontology>(
      compiled::Ontology::from_bytes(compiled::compile(source, el::classify(source).value())).value());
}

class PreparationTest : public testing::Test {
 protected:
  /// Reads the parts of the ontology that are verified on first use, again and again while it is prepared.
  void read(const compiled::Ontology& ontology) {
    if (!preparation.is_at_work()) return;
    ++reads;
    EXPECT_TRUE(ontology.find("class 7"));
    EXPECT_TRUE(ontology.check_whole());
    boost::asio::post(context, [&] { read(ontology); });
  }

  boost::asio::io_context context{1};
  Preparation preparation{context};
  int reads = 0;
};

TEST_F(PreparationTest, GoesOnBesideAnEventLoopThatReadsTheSameOntology) {
  const auto ontology = ontology_of(2000);
  Vocabulary result;
  preparation.start(Vocabulary(ontology), [&](Vocabulary prepared) { result = std::move(prepared); });
  EXPECT_TRUE(preparation.is_preparing(Vocabulary(ontology)));
  read(*ontology);
  context.run();
  EXPECT_GT(reads, 0);
  EXPECT_FALSE(preparation.is_at_work());
  EXPECT_FALSE(preparation.is_preparing(Vocabulary(ontology)));
  ASSERT_TRUE(result.is_prepared());
  EXPECT_TRUE(result.has_ontology_of(Vocabulary(ontology)));
  EXPECT_TRUE(result.check_expressions());
}

TEST_F(PreparationTest, DropsWhatIsGivenUpForAnother) {
  const auto second = ontology_of(10);
  std::weak_ptr<const compiled::Ontology> given_up;
  int stale = 0;
  Vocabulary result;
  {
    const auto first = ontology_of(500);
    given_up = first;
    preparation.start(Vocabulary(first), [&](const Vocabulary&) { ++stale; });
  }
  preparation.start(Vocabulary(second), [&](Vocabulary prepared) { result = std::move(prepared); });
  context.run();
  EXPECT_EQ(stale, 0);
  ASSERT_TRUE(result.is_prepared());
  EXPECT_TRUE(result.has_ontology_of(Vocabulary(second)));
}

TEST_F(PreparationTest, BringsNothingOnceItIsCancelled) {
  int brought = 0;
  preparation.start(Vocabulary(ontology_of(100)), [&](const Vocabulary&) { ++brought; });
  preparation.cancel();
  context.run();
  EXPECT_EQ(brought, 0);
  EXPECT_FALSE(preparation.is_at_work());
}

TEST(Preparation, MayEndBeforeItsThread) {
  boost::asio::io_context context(1);
  for (int round = 0; round < 20; ++round) {
    Preparation preparation(context);
    preparation.start(Vocabulary(ontology_of(50)), [](const Vocabulary&) { FAIL(); });
  }
  context.run();
}

}  // namespace
}  // namespace geminga::daemon
