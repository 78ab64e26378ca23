// Large files are cut and read by several threads, and the result must be that of one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/random.hpp"
#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/reading.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"

namespace geminga::rdf {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

/// The whole result of a load, one item a line.
std::vector<std::string> everything(const std::vector<std::string>& files, const syntax::FileLimits& limits,
                                    unsigned threads) {
  const auto loaded = load(files, limits, {}, threads);
  if (!loaded) return {to_string(loaded.error())};
  const owl::Ontology& source = loaded->source;
  std::vector<std::string> lines = functional(source, true);
  for (std::size_t index = 0; index < source.axiom_count(); ++index)
    lines[index] += " in line " + std::to_string(source.axiom(index).line);
  for (const auto& omission : source.omissions())
    lines.push_back(std::string(source.name(omission.construct)) + " in line " + std::to_string(omission.line));
  for (const auto& prefix : source.prefixes())
    lines.push_back(std::string(source.name(prefix.prefix)) + ": " + std::string(source.name(prefix.iri)));
  for (const auto* names : {&loaded->unknown_words, &loaded->undeclared_predicates}) {
    for (const UsedName& name : *names) lines.push_back(name.iri + " in line " + std::to_string(name.line));
  }
  lines.push_back(std::to_string(loaded->triples) + " triples");
  return lines;
}

syntax::FileLimits in_pieces_of(std::size_t bytes) {
  syntax::FileLimits limits;
  limits.piece_bytes = bytes;
  return limits;
}

TEST(Pieces, AreInvisibleInEveryCase) {
  for (const auto& entry : fs::directory_iterator(fs::path(GEMINGA_SOURCE_DIR) / "tests/reasoning/syntax/rdf/cases")) {
    if (entry.path().extension() == ".axioms") continue;
    const std::vector files{entry.path().string()};
    const auto whole = everything(files, {}, 1);
    for (const std::size_t bytes : {1U, 200U}) {
      for (const unsigned threads : {1U, 2U, 3U})
        EXPECT_EQ(everything(files, in_pieces_of(bytes), threads), whole) << entry.path() << " in pieces of " << bytes;
    }
  }
}

std::string many_descriptions(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    text += "<rdf:Description rdf:about='&g;A" + n + "'>\n  <rdfs:subClassOf rdf:resource='#A" + std::to_string(i / 2) +
            "'/><!-- </rdf:RDF> -->\n  <e:p>\n<rdf:Description><e:q rdf:nodeID='shared'/></rdf:Description></e:p>\n"
            "  <e:in xml:lang='de'>a &lt;b></e:in></rdf:Description>\n";
  }
  return text;
}

std::string document(std::string_view content) {
  return "<?xml version=\"1.0\"?>\n<!DOCTYPE r:RDF [\n<!ENTITY g 'http://e/x#'>\n]>\n<r:RDF "
         "xmlns:r='http://www.w3.org/1999/02/22-rdf-syntax-ns#' "
         "xmlns:rdf='http://www.w3.org/1999/02/22-rdf-syntax-ns#'\n"
         "  xmlns:rdfs='http://www.w3.org/2000/01/rdf-schema#' xmlns:e='http://e/' xml:base='http://e/x'>\n" +
         std::string(content) + "</r:RDF>\n";
}

const std::string kinds =
    "<rdf:Property rdf:about='http://e/p'><rdfs:range rdf:resource='http://e/R'/></rdf:Property>"
    "<rdf:Property rdf:about='http://e/q'><rdfs:range rdf:resource='http://e/R'/></rdf:Property>";

TEST(Pieces, OfXmlKeepWhatTheRootDeclares) {
  const Scratch scratch;
  const std::vector files{scratch.write("a.owl", document(kinds + many_descriptions(40)))};
  const auto whole = everything(files, {}, 1);
  EXPECT_THAT(whole, testing::Contains("SubClassOf(:x#A9 :x#A4) in line 53"));
  EXPECT_EQ(whole.back(), "164 triples");
  for (const std::size_t bytes : {1U, 100U, 1000U, 5000U}) {
    for (const unsigned threads : {1U, 2U, 5U})
      EXPECT_EQ(everything(files, in_pieces_of(bytes), threads), whole) << bytes << " bytes, " << threads << " threads";
  }
}

TEST(Pieces, OfALargeFileAreLookedAtByTwoThreadsAsByOne) {
  const Scratch scratch;
  const std::string unknown = "<rdfs:Klass rdf:about='http://e/K'><e:none>1</e:none></rdfs:Klass>\n";
  const std::string many = many_descriptions(26'000) + unknown;
  for (const auto& [extra, last] : {std::pair{"", "104002 triples"},
                                    {"<!-- \xff --><rdf:Description", "a.owl:130008: holds bytes that are no UTF-8"}}) {
    const std::vector files{scratch.write("a.owl", document(many + extra))};
    syntax::FileLimits limits = in_pieces_of(100'000);
    const auto by_one = everything(files, limits, 1);
    EXPECT_THAT(by_one.back(), HasSubstr(last));
    limits.watched_bytes = 1;  // so that it is large
    EXPECT_EQ(everything(files, limits, 2), by_one);
  }
}

TEST(Pieces, OfTurtleKeepDirectivesAndLines) {
  std::string text =
      "# many\n@prefix : <http://e/> .\nPREFIX rdfs: <http://www.w3.org/2000/01/rdf-schema#>\n@base <http://e/b/> .\n";
  for (int i = 0; i < 40; ++i) {
    const std::string n = std::to_string(i);
    text += ":A" + n + " rdfs:subClassOf :B\\. . # not. here.\n:A" + n + " rdfs:subClassOf\n  <x" + n +
            "> ; :p [ :q 1.5, \"\"\". \"\"\"@en.x ] .\n";
  }
  const Scratch scratch;
  for (const auto& [name, extra] :
       {std::pair{"a.ttl", ""}, {"late.ttl", "@prefix : <http://f/> . :a rdfs:subClassOf :b .\n"}}) {
    const std::vector files{scratch.write(name, text + extra)};
    const auto whole = everything(files, {}, 1);
    for (const std::size_t bytes : {1U, 300U}) {
      for (const unsigned threads : {1U, 4U}) EXPECT_EQ(everything(files, in_pieces_of(bytes), threads), whole) << name;
    }
  }
}

TEST(Pieces, GiveTheErrorThatTheWholeFileGives) {
  const std::string good = many_descriptions(20);
  const Scratch scratch;
  for (const std::string& content :
       {good + "<e:A><e:b></e:A>\n" + good, good + "<e:A>\n" + good, good + "</e:A>" + good,
        good + "<e:A rdf:about='<'/>", good + "<e:A>&none;</e:A>\n" + good, good + "<f:A/>" + good, "</r:RDF>" + good,
        "<e:A rdf:ID='one'/>" + good + "<e:A rdf:ID='one'/>", good + "<e:A rdf:about='http://e/&lt;'/>" + good}) {
    const std::vector files{scratch.write("a.owl", document(content))};
    const auto whole = everything(files, {}, 1);
    const std::string place = whole.front().substr(0, whole.front().find(": "));
    const auto in_turn = everything(files, in_pieces_of(1), 1);
    EXPECT_THAT(in_turn.front(), StartsWith(place)) << whole.front();
    EXPECT_EQ(everything(files, in_pieces_of(1), 2), in_turn);
  }
}

TEST(Pieces, OfABentFileAreReadWhereTheWholeFileIs) {
  std::vector<std::pair<std::string, std::string>> texts{{"a.owl", document(kinds + many_descriptions(2))}};
  for (const char* name : {"Restriction.ttl", "SubClassOfTriples.nt", "RestrictionXml.rdf"}) {
    std::ifstream file(fs::path(GEMINGA_SOURCE_DIR) / "tests/reasoning/syntax/rdf/cases" / name);
    texts.emplace_back(name, std::string(std::istreambuf_iterator<char>(file), {}));
  }
  constexpr std::string_view likely = "<>/\"':.#@_[](),; \n&!-ar";
  const Scratch scratch;
  std::size_t accepted = 0;
  constexpr std::uint64_t seeds = 200;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    base::Random random(seed);
    auto [name, text] = texts[static_cast<std::size_t>(seed % texts.size())];
    for (auto edits = 1 + random.below(3); edits > 0; --edits) {
      const auto place = static_cast<std::size_t>(random.below(text.size()));
      const char byte = likely[static_cast<std::size_t>(random.below(likely.size()))];
      switch (random.below(3)) {
        case 0:
          text[place] = byte;
          break;
        case 1:
          text.insert(place, 1, byte);
          break;
        default:
          text.erase(place, 1 + static_cast<std::size_t>(random.below(20)));
      }
    }
    const std::vector files{scratch.write(name, text)};
    const auto whole = everything(files, {}, 1);
    const auto pieces = everything(files, in_pieces_of(1), 1 + static_cast<unsigned>(seed % 3));
    const bool is_refused = whole.size() == 1 && whole.front().starts_with(files.front());
    if (is_refused) {
      EXPECT_THAT(pieces.front(), StartsWith(files.front())) << "seed " << seed;
    } else {
      ++accepted;
      EXPECT_EQ(pieces, whole) << "seed " << seed;
    }
  }
  EXPECT_GT(accepted, seeds / 10);
  EXPECT_LT(accepted, seeds);
}

TEST(Pieces, CountTogetherAgainstTheLimits) {
  const Scratch scratch;
  const std::vector files{scratch.write("a.owl", document(many_descriptions(40)))};
  for (const unsigned threads : {1U, 2U}) {
    syntax::FileLimits limits = in_pieces_of(1);
    limits.triples = 160;
    EXPECT_EQ(everything(files, limits, threads).back(), "160 triples");
    limits.triples = 159;
    EXPECT_THAT(everything(files, limits, threads).front(), testing::HasSubstr("is beyond 159 triples in all files"));
  }
}

}  // namespace
}  // namespace geminga::rdf
