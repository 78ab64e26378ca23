// Labels, conversions and units that annotations add to a source, and those that are left out by name.
#include "reasoning/syntax/document/name_annotations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace geminga::document {
namespace {

using Form = AnnotationValue::Form;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::string_view label = "http://www.w3.org/2000/01/rdf-schema#label";

class NameAnnotationsTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> left_out() const {
    std::vector<std::string> constructs;
    for (const auto& omission : source_.omissions()) constructs.emplace_back(source_.name(omission.construct));
    return constructs;
  }

  owl::Ontology source_;
  owl::FileId file_ = source_.add_file("a.ofn");
  NameAnnotations annotations_{source_, file_};
};

TEST_F(NameAnnotationsTest, AddsLabelsOfNamesOnlyAndNoNumbers) {
  annotations_.add(label, "http://e/A", {Form::text, "ball", "en"}, 1);
  annotations_.add(label, "_:a", {Form::text, "nobody"}, 2);
  annotations_.add(label, "", {Form::text, "an axiom"}, 3);
  annotations_.add(label, "http://e/A", {Form::number, "7"}, 4);
  annotations_.add(label, "http://e/A", {Form::iri, "http://e/B"}, 5);
  ASSERT_THAT(source_.labels(), SizeIs(1));
  EXPECT_EQ(source_.name(source_.labels()[0].text), "ball");
  EXPECT_THAT(left_out(), IsEmpty());
}

TEST_F(NameAnnotationsTest, AddsAConversionWithTheCostThatStandsBeforeIt) {
  annotations_.set_cost("7", 1);
  annotations_.add(owl::converts_to, "http://e/A", {Form::iri, "http://e/B"}, 2);
  annotations_.forget_cost();
  annotations_.add(owl::converts_to, "http://e/B", {Form::iri, "http://e/C"}, 3);
  ASSERT_THAT(source_.conversions(), SizeIs(2));
  EXPECT_EQ(source_.conversions()[0].cost, 7U);
  EXPECT_EQ(source_.conversions()[1].cost, owl::usual_conversion_cost);
}

TEST_F(NameAnnotationsTest, LeavesOutConversionsAndCostsThatAreNone) {
  annotations_.add(owl::converts_to, "http://e/A", {Form::text, "B"}, 1);
  annotations_.add(owl::converts_to, "http://e/A", {Form::number, "1"}, 2);
  annotations_.add(owl::converts_to, "http://e/A", {Form::blank, {}}, 3);
  annotations_.add(owl::converts_to, "_:a", {Form::iri, "http://e/B"}, 4);
  annotations_.add(owl::conversion_cost, "http://e/A", {Form::number, "1"}, 5);
  EXPECT_THAT(source_.conversions(), IsEmpty());
  EXPECT_THAT(left_out(), testing::UnorderedElementsAre(owl::conversion_to_literal, owl::conversion_without_name,
                                                        owl::cost_of_nothing));
}

TEST_F(NameAnnotationsTest, IsInterestedInLabelsConversionsAndUnitsOnly) {
  for (const std::string_view property : {label, owl::converts_to, owl::conversion_cost})
    EXPECT_TRUE(NameAnnotations::is_of_interest(property)) << property;
  EXPECT_TRUE(NameAnnotations::is_of_interest("http://qudt.org/schema/qudt/symbol"));
  EXPECT_FALSE(NameAnnotations::is_of_interest("http://www.w3.org/2000/01/rdf-schema#comment"));
}

}  // namespace
}  // namespace geminga::document
