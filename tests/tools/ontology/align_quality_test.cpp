// The links that `align` finds between ontologies whose right links are known (alignments/README.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using Pairs = std::set<std::pair<std::string, std::string>>;

const std::filesystem::path alignments = GEMINGA_ALIGNMENTS;

/// Two ontologies of one subject, by the columns of its links.
struct Pair {
  std::string subject;
  std::size_t one;
  std::size_t other;

  [[nodiscard]] std::string file(std::size_t column) const {
    return (alignments / (subject + '-' + std::string(1, "abc"[column]) + ".ttl")).string();
  }
};

const std::vector<Pair> all_pairs{
    {"hospital", 0, 1}, {"hospital", 0, 2}, {"hospital", 1, 2}, {"library", 0, 1}, {"warehouse", 0, 1}};

Pairs right_links(const Pair& pair) {
  Pairs links;
  std::ifstream file(alignments / (pair.subject + ".links"));
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::vector<std::string> names;
    for (std::string name; words >> name;) names.push_back(name);
    if (names.empty() || names[0] == "#") continue;
    if (names[pair.one] != "-" && names[pair.other] != "-") links.emplace(names[pair.one], names[pair.other]);
  }
  return links;
}

std::string local_name(const std::string& iri) { return iri.substr(iri.find_last_of("#/") + 1); }

/// The two names of each line of `align`.
Pairs links_in(const std::string& text) {
  Pairs links;
  std::istringstream lines(text);
  for (std::string one, sign, other, rest; std::getline(lines, one, '\t');) {
    std::getline(lines, sign, '\t');
    std::getline(lines, other, '\t');
    std::getline(lines, rest);
    links.emplace(local_name(one), local_name(other));
  }
  return links;
}

struct Quality {
  double precision = 0;
  double recall = 0;
};

/// Over the links of all pairs together.
Quality quality_with(const std::vector<std::string>& flags) {
  const Program program;
  std::size_t right = 0;
  std::size_t found = 0;
  std::size_t expected = 0;
  for (const Pair& pair : all_pairs) {
    std::vector<std::string> arguments{"align", pair.file(pair.one), pair.file(pair.other)};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const Outcome outcome = program.run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const Pairs links = links_in(outcome.out);
    const Pairs wanted = right_links(pair);
    found += links.size();
    expected += wanted.size();
    for (const auto& link : links) right += wanted.count(link);
  }
  return {static_cast<double>(right) / static_cast<double>(found),
          static_cast<double>(right) / static_cast<double>(expected)};
}

TEST(AlignmentQuality, IsAsStatedWithWordNet) {
  const Quality quality = quality_with({});
  EXPECT_GE(quality.precision, 0.98);
  EXPECT_GE(quality.recall, 0.78) << "the package wordnet-base must be installed";
}

TEST(AlignmentQuality, IsAsStatedWithoutIt) {
  const Program program;
  program.write("index.noun", "");
  program.write("index.verb", "");
  const Quality quality = quality_with({"--wordnet", (program.folder() / "in").string()});
  EXPECT_GE(quality.precision, 0.97);
  EXPECT_GE(quality.recall, 0.59);
}

}  // namespace
}  // namespace geminga::ontology
