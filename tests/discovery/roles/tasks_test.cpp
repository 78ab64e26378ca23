// The 200 tasks of tests/cases/tasks: who suits a role follows by the vocabulary, and the choice is as good as
// expected.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "discovery/roles/completion.hpp"
#include "discovery/roles/holders.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "reasoning/vocabulary/expression.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"
#include "support/written.hpp"

namespace geminga::roles {
namespace {

const std::filesystem::path folder = std::filesystem::path(GEMINGA_SOURCE_DIR) / "tests" / "cases" / "tasks";

struct Described {
  std::string name;
  std::uint32_t battery = 0;
  std::string description;
};

struct Need {
  std::uint32_t count = 0;
  bool is_shared = false;
  std::uint32_t battery = 0;
  std::string expression;
};

struct Case {
  std::string title;
  std::vector<std::string> robots;
  std::vector<Need> needs;
  bool prefers = false;
  std::string expected;
};

std::vector<Described> robots() {
  std::vector<Described> all;
  std::ifstream file(folder / "robots.txt");
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream fields(line);
    Described one;
    fields >> one.name >> one.battery >> std::ws;
    std::getline(fields, one.description);
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<Case> tasks() {
  std::vector<Case> all;
  std::ifstream file(folder / "tasks.txt");
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string word;
    fields >> word;
    if (word == "task") all.push_back({.title = line, .robots = {}, .needs = {}, .expected = {}});
    if (word == "robots") {
      for (std::string name; fields >> name;) all.back().robots.push_back(name);
    } else if (word == "need") {
      Need need;
      std::string kind;
      fields >> need.count >> kind >> need.battery >> std::ws;
      need.is_shared = kind == "shared";
      std::getline(fields, need.expression);
      all.back().needs.push_back(std::move(need));
    } else if (word == "prefer") {
      all.back().prefers = true;
    } else if (word == "expect") {
      all.back().expected = line.substr(line.find(' ') + 1);
    }
  }
  return all;
}

/// Whether a robot is what is asked for. Each question is asked once.
class Suitability {
 public:
  Suitability() {
    std::ifstream file(folder / "team.ofn");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    owl::Ontology source;
    EXPECT_TRUE(functional::read(text, source.add_file("team.ofn"), source, {.wrong_axioms = 0}));
    vocabulary_ = vocabulary::Vocabulary(owl::loaded(source)).with_expressions();
  }

  bool operator()(const std::string& description, const std::string& asked) {
    const auto known = known_.find({description, asked});
    if (known != known_.end()) return known->second;
    const auto& one = placed(description);
    const auto& other = placed(asked);
    using Relation = vocabulary::Comparison::Relation;
    const auto found = vocabulary_.compare(one.first, one.second, other.first, other.second);
    EXPECT_TRUE(found.gaps.empty()) << description << " against " << asked;
    const bool is_it = found.relation == Relation::narrower || found.relation == Relation::equivalent;
    return known_.emplace(std::pair(description, asked), is_it).first->second;
  }

  /// The smallest way that contradicts nothing to make a robot what is asked for.
  std::optional<vocabulary::NearMiss> missing(const std::string& description, const std::string& asked) {
    constexpr std::size_t questions = 64;
    const auto found = vocabulary_.near_misses(placed(asked).first, placed(description).first, questions);
    if (found.ranked.empty() || found.ranked.front().contradicting_count > 0) return std::nullopt;
    return found.ranked.front();
  }

  /// Whether something can be that at all.
  bool is_possible(const std::string& description) { return placed(description).second.is_satisfiable; }

 private:
  using Placed = std::pair<vocabulary::Expression, vocabulary::Place>;
  const Placed& placed(const std::string& text) {
    if (const auto at = placed_.find(text); at != placed_.end()) return at->second;
    const bool is_name = text.find(' ') == std::string::npos;
    const auto read = vocabulary_.read(is_name ? "<https://geminga.example/tasks#" + text + ">" : text,
                                       vocabulary::max_expression_bytes);
    EXPECT_TRUE(read) << text << ": " << (read ? "" : read.error().text);
    return placed_.emplace(text, Placed(*read, vocabulary_.place(*read))).first->second;
  }

  vocabulary::Vocabulary vocabulary_;
  std::map<std::string, Placed> placed_;
  std::map<std::pair<std::string, std::string>, bool> known_;
};

TEST(Tasks, OfTheSuiteAreDoneByAsFewRobotsAsExpected) {
  const auto all_robots = robots();
  const auto all_tasks = tasks();
  ASSERT_EQ(all_robots.size(), 50U);
  ASSERT_EQ(all_tasks.size(), 200U);
  Suitability suits;
  for (const Case& one : all_tasks) {
    SCOPED_TRACE(one.title);
    std::vector<Described> there;
    for (const Described& robot : all_robots) {
      if (std::ranges::find(one.robots, robot.name) != one.robots.end()) there.push_back(robot);
    }
    ASSERT_EQ(there.size(), one.robots.size());
    Task task{.robots = static_cast<std::uint32_t>(there.size()), .roles = {}, .former = {}};
    for (const Need& need : one.needs) {
      Role role{.count = need.count, .is_shared = need.is_shared, .suited = {}};
      for (std::uint32_t robot = 0; robot < there.size(); ++robot) {
        if (there[robot].battery < need.battery || !suits(there[robot].description, need.expression)) continue;
        const auto better =
            std::ranges::count_if(there, [&](const Described& other) { return other.battery > there[robot].battery; });
        role.suited.push_back({robot, static_cast<std::uint32_t>(one.prefers ? better : 0)});
      }
      task.roles.push_back(std::move(role));
    }
    const Holders found = best_holders(task);
    const std::string answer = found.verdict == Holders::Verdict::nobody
                                   ? "nobody"
                                   : std::to_string(found.robots) + " " + std::to_string(found.cost);
    EXPECT_EQ(answer, one.expected);
    EXPECT_TRUE(found.verdict == Holders::Verdict::best || found.verdict == Holders::Verdict::nobody);
  }
}

TEST(Tasks, ThatNobodyCanDoAreDoneOnceTheLeastThatIsMissingIsAdded) {
  const auto all_robots = robots();
  Suitability suits;
  std::size_t completed = 0;
  for (const Case& one : tasks()) {
    if (one.expected != "nobody") continue;
    SCOPED_TRACE(one.title);
    std::vector<Described> there;
    for (const Described& robot : all_robots) {
      if (std::ranges::find(one.robots, robot.name) != one.robots.end()) there.push_back(robot);
    }
    std::map<std::pair<std::uint32_t, std::size_t>, std::string> added;
    Task near{.robots = static_cast<std::uint32_t>(there.size()), .roles = {}, .former = {}};
    for (const Need& need : one.needs) {
      Role role{.count = need.count, .is_shared = need.is_shared, .suited = {}};
      for (std::uint32_t robot = 0; robot < there.size(); ++robot) {
        if (there[robot].battery < need.battery) continue;
        const auto way = suits.missing(there[robot].description, need.expression);
        if (!way) continue;
        EXPECT_EQ(way->lacking_count == 0, suits(there[robot].description, need.expression));
        role.suited.push_back({robot, static_cast<std::uint32_t>(way->lacking_count)});
        added.emplace(std::pair(robot, near.roles.size()), way->added);
      }
      near.roles.push_back(std::move(role));
    }
    const auto found = least_completion(near);
    ASSERT_TRUE(found);
    const bool is_short = std::ranges::any_of(found->lacking, [](std::uint32_t count) { return count > 0; });
    EXPECT_TRUE(is_short || found->missing > 0);
    for (std::size_t role = 0; role < found->of_role.size(); ++role) {
      for (const std::uint32_t robot : found->of_role[role]) {
        const std::string& more = added.at({robot, role});
        if (more.empty()) continue;
        const std::string whole = "(" + there[robot].description + ") and (" + more + ")";
        EXPECT_TRUE(suits(whole, one.needs[role].expression)) << whole;
        EXPECT_TRUE(suits.is_possible(whole)) << whole;
      }
    }
    if (!is_short) ++completed;
  }
  EXPECT_GT(completed, 0U);
}

}  // namespace
}  // namespace geminga::roles
