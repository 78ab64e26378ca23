// The services that would be understood with the links to another ontology.
#include "query/aligning/understood.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace geminga::query {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

Record service(const std::string& key, const std::string& iri, const std::string& representation = "") {
  Record record{"services", {{"service", key}, {"mode", "otm/stream"}, {"concept", '<' + iri + '>'}}, {}};
  if (!representation.empty()) record.fields.emplace_back("representation", '<' + representation + '>');
  return record;
}

Record request(const std::string& key, const std::string& iri, const std::string& representation = "") {
  Record record = service("", iri, representation);
  record.kind = "requests";
  record.fields.emplace_back("subscription", key);
  return record;
}

Closure closure(const std::string& lines) {
  std::istringstream in(lines);
  return Closure::read(in, {"their:Dog", "their:Fur", "our:Pet", "our:Animal", "our:Ball"});
}

std::vector<std::string> meetings(const Understood& understood) {
  std::vector<std::string> pairs;
  for (const Meeting& one : understood.meetings)
    pairs.push_back(std::string(one.service["service"]) + ' ' + std::string(one.request["subscription"]));
  return pairs;
}

const auto is_ours = [](const std::string& iri) { return iri.starts_with("our:"); };
const Closure today = closure("our:Pet\tour:Animal\n");
const Closure with = closure(
    "our:Pet\tour:Animal\ntheir:Dog\tour:Animal\ntheir:Dog\tour:Pet\ntheir:Dog\ttheir:Thing\ntheir:Fur\tour:Coat\n"
    "their:Cat\tour:Pet\nno line\n");

TEST(Closures, KeepWhatIsWanted) {
  EXPECT_THAT(with.above("their:Dog"), ElementsAre("our:Animal", "our:Pet", "their:Thing"));
  EXPECT_THAT(with.above("their:Cat"), IsEmpty()) << "not wanted";
  EXPECT_TRUE(with.is_below("their:Cat", "their:Cat"));
  EXPECT_FALSE(with.is_below("our:Animal", "our:Pet"));
}

TEST(Iris, StandAloneInTheirBrackets) {
  EXPECT_EQ(iri_in("<urn:a>"), "urn:a");
  for (const char* other : {"", "<>", "urn:a", "(<urn:a> and <urn:b>)", "<urn:a> and <urn:b>", "soccer:Ball"})
    EXPECT_EQ(iri_in(other), "") << other;
}

TEST(Understood, IsWhatMeetsWithTheLinksAndDoesNotToday) {
  const auto understood =
      understood_with({service("dog", "their:Dog"), service("pet", "our:Pet")},
                      {request("animals", "our:Animal"), request("balls", "our:Ball")}, today, with, is_ours);
  EXPECT_THAT(meetings(understood), ElementsAre("dog animals")) << "our pet is an animal already";
  ASSERT_THAT(understood.meanings, SizeIs(1));
  EXPECT_EQ(understood.meanings.front().service["service"], "dog");
  EXPECT_THAT(understood.meanings.front().classes, ElementsAre("our:Pet")) << "the most specific one of ours";
}

TEST(Understood, NeedsModeAndRepresentation) {
  Record stream = request("stream", "our:Pet");
  stream.fields[1].second = "oto";
  const auto understood = understood_with({service("plain", "their:Dog"), service("furry", "their:Dog", "their:Fur")},
                                          {stream, request("coats", "our:Pet", "our:Coat"), request("any", "our:Pet")},
                                          today, with, is_ours);
  EXPECT_THAT(meetings(understood), ElementsAre("plain any", "furry coats", "furry any"));
}

TEST(Understood, ComparesNoExpressions) {
  Record expression = request("e", "x");
  expression.fields[2].second = "(<our:Pet> and <our:Ball>)";
  const auto understood = understood_with({service("dog", "their:Dog")}, {expression}, today, with, is_ours);
  EXPECT_EQ(understood.expressions, 1U);
  EXPECT_THAT(understood.meetings, IsEmpty());
}

}  // namespace
}  // namespace geminga::query
