// The printed form of terms, small and large.
#include "reasoning/owl/print.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::owl {
namespace {

std::string name_of(std::string_view iri) { return std::string(iri); }

TEST(Print, EndsWhereATermSharesItsPartsWithoutEnd) {
  Ontology source;
  const TermId shared = source.object_property("r");
  TermId term = source.named_class("A");
  for (int level = 0; level < 200; ++level) {
    const TermId some = source.term(TermKind::object_some_values_from, {shared, term});
    term = source.term(TermKind::object_intersection_of, {some, some});
  }
  const std::string text = print(source, term, name_of);
  EXPECT_LT(text.size(), 100'000U);
  EXPECT_NE(text.find("..."), std::string::npos);
}

TEST(Print, CutsOffTheTermAfterTheLastOne) {
  Ontology source;
  std::vector<TermId> members;
  for (std::size_t at = 0; at + 1 < max_printed_terms; ++at)
    members.push_back(source.named_class("A" + std::to_string(at)));
  const std::string last = "A" + std::to_string(max_printed_terms - 2);
  const std::string whole = print(source, source.term(TermKind::object_union_of, members), name_of);
  EXPECT_TRUE(whole.ends_with(" or " + last));
  members.push_back(source.named_class("B"));
  members.push_back(source.named_class("C"));
  const std::string cut = print(source, source.term(TermKind::object_union_of, members), name_of);
  EXPECT_TRUE(cut.ends_with(last + " or ..."));
  const std::string parsed =
      print(source, source.term(TermKind::object_union_of, members), name_of, PrintStyle::parsing);
  EXPECT_TRUE(parsed.ends_with(last + " or B or C"));
}

}  // namespace
}  // namespace geminga::owl
