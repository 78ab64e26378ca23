// Compares every #include with the DEPENDS of the modules, and tests the comparison itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "law/source_tree.hpp"

namespace geminga::law {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

const Law small = {{"base", {}},           {"env", {"base"}},        {"env/asio", {"base", "env"}},
                   {"registry", {"base"}}, {"tools/shell", {"env"}}, {"tools/query", {"tools/shell"}}};

TEST(IncludeLaw, HoldsForEveryFileOfTheProject) {
  const Law law = read_law();
  ASSERT_GE(law.size(), 12U);
  for (const char* folder : {"src", "include", "tools"}) {
    for (const auto& file : source_files(folder)) EXPECT_THAT(violations(law, file), IsEmpty());
  }
}

TEST(IncludeLaw, HasNoCycle) {
  const Law law = read_law();
  std::map<std::string, int> state;  // 1: being visited, 2: done
  std::function<bool(const std::string&)> is_acyclic = [&](const std::string& module) {
    if (state[module] == 1) return false;
    if (state[module] == 2) return true;
    state[module] = 1;
    for (const auto& other : law.at(module)) {
      if (!law.contains(other) || !is_acyclic(other)) return false;
    }
    state[module] = 2;
    return true;
  };
  for (const auto& [module, depends] : law) EXPECT_TRUE(is_acyclic(module)) << module;
}

TEST(IncludeLaw, KeepsRdfOutOfTheDaemon) {
  const Law law = read_law();
  for (const auto& [module, depends] : law) {
    if (module.starts_with("reasoning/syntax") || module.starts_with("tools/ontology")) continue;
    for (const char* folder : {"rdf", "rdf/scan", "rdf/triples", "rdf/mapping", "rdf/tolerant", "graph", "owlxml"})
      EXPECT_FALSE(depends.contains(std::string("reasoning/syntax/") + folder)) << module << ' ' << folder;
  }
}

TEST(IncludeLaw, FindsAnIncludeThatDependsDoNotName) {
  EXPECT_THAT(violations(small, {"src/env/clock.hpp", {"#include \"registry/entry.hpp\""}}), SizeIs(1));
  EXPECT_THAT(violations(small, {"src/env/clock.hpp", {"#include \"base/time.hpp\"", "#include <vector>"}}), IsEmpty());
}

TEST(IncludeLaw, FindsAnIncludeThatAProgramDoesNotName) {
  EXPECT_THAT(violations(small, {"tools/shell/json.cpp", {"#include \"query/filter.hpp\""}}), SizeIs(1));
  EXPECT_THAT(violations(small, {"tools/query/why.cpp", {"#include \"base/text.hpp\""}}), SizeIs(1));
  EXPECT_THAT(violations(small, {"tools/query/why.cpp", {"#include \"shell/json.hpp\""}}), IsEmpty());
  EXPECT_THAT(violations(small, {"tools/other/main.cpp", {}}), SizeIs(1));
}

TEST(IncludeLaw, FindsTheDoorOpenedFromInside) {
  EXPECT_THAT(violations(small, {"src/env/env.hpp", {"#include \"env/asio/streams.hpp\""}}), SizeIs(1));
}

TEST(IncludeLaw, FindsALibraryOutsideItsFolder) {
  EXPECT_THAT(violations(small, {"src/env/env.hpp", {"#include <boost/multi_index_container.hpp>"}}), SizeIs(1));
}

TEST(IncludeLaw, FindsAPublicHeaderThatLooksInside) {
  EXPECT_THAT(violations(small, {"include/geminga/error.hpp", {"#include \"base/text.hpp\""}}), SizeIs(1));
}

}  // namespace
}  // namespace geminga::law
