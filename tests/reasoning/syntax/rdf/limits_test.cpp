// Every named limit one below, at, and one above.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "reasoning/syntax/rdf/reading.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"

namespace geminga::rdf {
namespace {

using testing::HasSubstr;

/// A limit, and a file that is as much as it says.
struct Boundary {
  std::string name;
  std::function<void(syntax::FileLimits&, std::size_t)> set;
  std::string file;
  std::function<std::string(std::size_t)> content;
};

std::string statement(std::string_view object) { return "<http://e/a> <http://e/b> " + std::string(object) + " .\n"; }

std::vector<Boundary> boundaries() {
  const auto brackets = [](std::size_t n) { return statement(times(n, "[ <http://e/b> ") + "1" + times(n, " ]")); };
  const auto elements = [](std::size_t n) {
    return xml(times((n - 1) / 2, "<e:A><e:p>") + times((n - 1) / 2, "</e:p></e:A>"));
  };
  return {
      {"file bytes", [](syntax::FileLimits& l, std::size_t n) { l.file_bytes = n; }, "a.ttl",
       [](std::size_t n) { return times(n, "\n"); }},
      {"triples", [](syntax::FileLimits& l, std::size_t n) { l.triples = n; }, "a.nt",
       [](std::size_t n) { return times(n, statement("\"x\"")); }},
      {"literal bytes", [](syntax::FileLimits& l, std::size_t n) { l.literal_bytes = n - 1; }, "a.nt",
       [](std::size_t n) { return statement("\"" + times(n - 2, "x") + "\""); }},
      {"text bytes", [](syntax::FileLimits& l, std::size_t n) { l.literal_bytes = n + 100; }, "a.owl",
       [](std::size_t n) { return xml("<e:A><e:p>" + times(n + 100, "x") + "</e:p></e:A>"); }},
      {"iri bytes", [](syntax::FileLimits& l, std::size_t n) { l.iri_bytes = n + 40; }, "a.owl",
       [](std::size_t n) { return xml("<e:A rdf:about=\"http://e/" + times(n + 31, "x") + "\"/>"); }},
      {"blank bytes", [](syntax::FileLimits& l, std::size_t n) { l.blank_bytes = n; }, "a.nt",
       [](std::size_t n) { return statement("\"x\"") + times(n - 1, "\n") + statement("\"x\""); }},
      {"brackets", [](syntax::FileLimits& l, std::size_t n) { l.nesting = n; }, "a.ttl", brackets},
      {"elements", [](syntax::FileLimits& l, std::size_t n) { l.nesting = (n - 1) / 2 * 2 + 1; }, "a.owl",
       [elements](std::size_t n) { return elements((n - 1) / 2 * 2 + 1); }},
      {"statement triples", [](syntax::FileLimits& l, std::size_t n) { l.statement_triples = n; }, "a.ttl",
       [](std::size_t n) { return statement("1" + times(n - 1, ", 1")); }},
      {"prefixes", [](syntax::FileLimits& l, std::size_t n) { l.prefixes = n; }, "a.ttl",
       [](std::size_t n) {
         std::string text;
         for (std::size_t i = 0; i < n; ++i) text += "@prefix p" + std::to_string(i) + ": <http://e/> .\n";
         return text;
       }},
      {"graphs", [](syntax::FileLimits& l, std::size_t n) { l.graphs = n; }, "a.trig",
       [](std::size_t n) { return times(n, "<g> {}\n"); }},
      {"prefixes of elements", [](syntax::FileLimits& l, std::size_t n) { l.prefixes = n + 3; }, "a.owl",
       [](std::size_t n) {  // the root declares three
         std::string text;
         for (std::size_t i = 0; i < n; ++i) text += "<e:A xmlns:p='http://e/" + std::to_string(i) + "'/>";
         return xml(text + text);
       }},
      {"repairs", [](syntax::FileLimits& l, std::size_t n) { l.repairs = n; }, "a.owl",
       [](std::size_t n) { return xml(times(n, "<e:A rdf:nodeID='_:a'/>")); }},
      {"attributes", [](syntax::FileLimits& l, std::size_t n) { l.attributes = n; }, "a.owl",
       [](std::size_t n) {
         std::string text = "<e:A";
         for (std::size_t i = 0; i < n; ++i) text += " e:p" + std::to_string(i) + "='x'";
         return xml(text + "/>");
       }},
      {"tag bytes", [](syntax::FileLimits& l, std::size_t n) { l.tag_bytes = 300 + n; }, "a.owl",
       [](std::size_t n) { return xml("<e:A" + times(300 + n - 5, " ") + "/>"); }},
      {"entities", [](syntax::FileLimits& l, std::size_t n) { l.entities = n; }, "a.owl",
       [](std::size_t n) {
         std::string doctype = "<!DOCTYPE rdf:RDF [";
         for (std::size_t i = 0; i < n; ++i) doctype += "<!ENTITY a" + std::to_string(i) + " 'x'>";
         return xml("", doctype + "]>\n");
       }},
      {"entity bytes", [](syntax::FileLimits& l, std::size_t n) { l.entity_bytes = n; }, "a.owl",
       [](std::size_t n) { return xml("", "<!DOCTYPE rdf:RDF [<!ENTITY a '" + times(n, "x") + "'>]>\n"); }},
  };
}

TEST(Limits, HoldOneBelowAtAndOneAbove) {
  constexpr std::size_t at = 21;
  for (const Boundary& boundary : boundaries()) {
    syntax::FileLimits limits;
    boundary.set(limits, at);
    const auto told = [&](std::size_t size) { return refusal(boundary.file, boundary.content(size), limits); };
    EXPECT_EQ(told(at - 1), "accepted") << boundary.name;
    EXPECT_EQ(told(at), "accepted") << boundary.name;
    EXPECT_THAT(told(at + 2), testing::Not("accepted")) << boundary.name;
    if (boundary.name != "elements") {  // they come in twos
      EXPECT_THAT(told(at + 1), testing::Not("accepted")) << boundary.name;
    }
  }
}

TEST(Limits, ExpansionsOfEntitiesAreCountedTogether) {
  syntax::FileLimits limits;
  limits.entity_growth = 0;
  limits.expansion_bytes = 50;
  const auto told = [&](std::size_t count) {
    return refusal("a.owl",
                   xml(times(count, "<e:A><e:p>&a;</e:p></e:A>\n"), "<!DOCTYPE rdf:RDF [<!ENTITY a '0123456789'>]>\n"),
                   limits);
  };
  EXPECT_EQ(told(4), "accepted");
  EXPECT_EQ(told(5), "accepted");
  EXPECT_THAT(told(6), HasSubstr("a.owl:9: expands its entities to more than 50 bytes"));
}

/// Loads files that declare prefixes with these numbers, from the first to before the last.
std::string told_of(const std::vector<std::pair<std::size_t, std::size_t>>& files, const syntax::FileLimits& limits) {
  const Scratch scratch;
  std::vector<std::string> paths;
  for (const auto& [first, last] : files) {
    std::string text;
    for (std::size_t i = first; i < last; ++i) text += "@prefix p: <http://e/" + std::to_string(i) + "> .\n";
    paths.push_back(scratch.write(std::to_string(paths.size()) + ".ttl", text));
  }
  const auto loaded = load(paths, limits);
  return loaded ? "accepted" : loaded.error().text;
}

TEST(Limits, ADeclarationThatManyFilesShareCountsOnce) {
  syntax::FileLimits limits;
  limits.prefixes = 4;
  limits.all_prefixes = 6;
  EXPECT_EQ(told_of({{0, 4}, {0, 4}, {0, 4}, {0, 4}}, limits), "accepted");
  EXPECT_EQ(told_of({{0, 4}, {1, 5}}, limits), "accepted");
  EXPECT_EQ(told_of({{0, 4}, {2, 6}}, limits), "accepted");
  EXPECT_EQ(told_of({{0, 4}, {3, 7}}, limits), "is beyond 6 different prefixes of all files");
  EXPECT_EQ(told_of({{0, 5}}, limits), "declares more than 4 prefixes");
}

TEST(Limits, UnansweredImportsBeyondThoseWithNamesAreCounted) {
  syntax::FileLimits limits;
  limits.named_imports = 2;
  const auto left_out = [&](std::size_t count) {
    std::string text = std::string(turtle_prefixes) + "<http://e/o> a owl:Ontology .\n";
    for (std::size_t i = 0; i < count; ++i) text += "<http://e/o> owl:imports <http://e/" + std::to_string(i) + "> .\n";
    const auto loaded = load_text("a.ttl", text, limits);
    if (!loaded) return to_string(loaded.error());
    EXPECT_EQ(loaded->unresolved.size(), count);
    std::string all;
    for (const auto& omission : loaded->source.omissions())
      all += std::string(loaded->source.name(omission.construct)) + " x" + std::to_string(omission.count) + '\n';
    return all;
  };
  const std::string first = "owl:imports <http://e/0> x1\n";
  const std::string second = "owl:imports <http://e/1> x1\n";
  EXPECT_EQ(left_out(1), first);
  EXPECT_EQ(left_out(2), first + second);
  EXPECT_EQ(left_out(3), first + second + "other owl:imports x1\n");
  EXPECT_EQ(left_out(5), first + second + "other owl:imports x3\n");
}

TEST(Limits, HoldForTheNumberOfFiles) {
  const Scratch scratch;
  syntax::FileLimits limits;
  limits.files = 2;
  std::vector<std::string> files{scratch.write("a.ttl", ""), scratch.write("b.ttl", "")};
  EXPECT_TRUE(load(files, limits));
  files.push_back(scratch.write("c.ttl", ""));
  const auto loaded = load(files, limits);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(to_string(loaded.error()), "more than 2 ontology files are named: merge some");
}

}  // namespace
}  // namespace geminga::rdf
