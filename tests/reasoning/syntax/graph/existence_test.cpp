// FILTER EXISTS and NOT EXISTS, the variables of SELECT *, and DESCRIBE.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reasoning/syntax/graph/query.hpp"

namespace geminga::graph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// a knows b and c, b knows c; their ages are 1, 2 and 3; b has a blank node with a blank node.
class Existence : public testing::Test {
 protected:
  Existence() {
    const auto name = [](const char* local) { return iri(std::string("http://e/") + local); };
    for (const auto& [one, other] : {std::pair{"a", "b"}, {"a", "c"}, {"b", "c"}})
      graph_.add(name(one), name("knows"), name(other));
    for (const auto& [one, age] : {std::pair{"a", "1"}, {"b", "2"}, {"c", "3"}})
      graph_.add(name(one), name("age"), {Node::Kind::literal, age, "http://www.w3.org/2001/XMLSchema#integer", {}});
    graph_.add(name("b"), name("has"), blank("x"));
    graph_.add(blank("x"), name("has"), blank("y"));
    graph_.add(blank("y"), name("has"), blank("x"));
    graph_.add(blank("y"), name("knows"), name("a"));
    graph_.sort();
  }

  [[nodiscard]] std::expected<Answer, AskError> ask(const std::string& query, const GraphLimits& limits = {}) const {
    return graph::ask(graph_, query, {.prefixes = {{"e", "http://e/"}}, .format = Format::n_triples, .limits = limits});
  }
  /// The first column, names without their namespace and in order; or the refusal.
  [[nodiscard]] std::string found(const std::string& query) const {
    const auto answer = ask(query);
    if (!answer) return answer.error().text;
    if (answer->kind == Answer::Kind::truth) return answer->is_true ? "yes" : "no";
    std::vector<std::string> names;
    for (const auto& row : answer->rows)
      names.push_back(row[0] ? row[0]->text.substr(row[0]->text.rfind('/') + 1) : "-");
    std::ranges::sort(names);
    std::string text;
    for (const std::string& name : names) text += name;
    return text;
  }

  Graph graph_;
};

TEST_F(Existence, KeepsRowsByAPatternThatBindsNothing) {
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n FILTER EXISTS { ?x e:knows ?y } }"), "ab");
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n FILTER NOT EXISTS { ?x e:knows ?y } }"), "c");
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n filter(not exists { ?x e:knows ?y }) }"), "c");
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n FILTER # why\n( EXISTS\n{ ?x e:knows e:c } ) . ?x e:knows e:b }"), "a");
  EXPECT_EQ(found("SELECT ?x { FILTER NOT EXISTS { ?y e:knows ?x } ?x e:age ?n }"), "") << "_:y knows a";
  EXPECT_EQ(
      found("SELECT ?x { ?x e:age ?n FILTER NOT EXISTS { e:a e:knows ?x } FILTER NOT EXISTS { e:b e:knows ?x } }"),
      "a");
  EXPECT_EQ(found("ASK { FILTER EXISTS { e:a e:knows e:b } }"), "yes");
  EXPECT_EQ(found("ASK { FILTER NOT EXISTS { e:a e:knows e:b } }"), "no");
  EXPECT_EQ(found("ASK { FILTER NOT EXISTS { e:b e:knows e:a } }"), "yes");
  EXPECT_EQ(found("ASK { FILTER EXISTS { } }"), "yes");
  EXPECT_EQ(found("ASK { FILTER NOT EXISTS { } }"), "no");
}

TEST_F(Existence, HandsTheValuesOfTheRowIntoThePattern) {
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n FILTER NOT EXISTS { ?y e:age ?m FILTER(?m > ?n) } }"), "c");
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n FILTER EXISTS { ?y e:age ?m FILTER(?m = ?n + 2) } }"), "a");
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n FILTER NOT EXISTS { { ?x e:knows e:b } UNION { ?y e:knows e:none } } }"),
            "bc");
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n FILTER EXISTS { ?x e:knows ?y FILTER NOT EXISTS { ?y e:knows ?z } } }"),
            "ab");
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n FILTER EXISTS { VALUES ?x { e:a e:c } } }"), "ac");
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n FILTER EXISTS { ?x e:age 1 OPTIONAL { ?x e:has ?h } } }"), "a");
}

TEST_F(Existence, HoldsForItsGroupAlone) {
  EXPECT_EQ(found("SELECT ?x { { ?x e:age 1 } UNION { ?x e:age ?n FILTER NOT EXISTS { ?x e:knows ?y } } }"), "ac");
  EXPECT_EQ(found("SELECT ?y { ?x e:age ?n OPTIONAL { ?x e:knows ?y FILTER NOT EXISTS { ?y e:knows ?z } } }"), "-cc");
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n MINUS { ?x e:knows ?y FILTER EXISTS { ?y e:knows ?z } } }"), "bc");
  EXPECT_EQ(found("SELECT ?x { { SELECT ?x { ?x e:age ?n FILTER NOT EXISTS { ?x e:knows ?y } } } }"), "c");
}

TEST_F(Existence, IsRefusedWhereItsMeaningIsOpenOrRasqalCannotHoldIt) {
  EXPECT_THAT(found("SELECT * { ?s ?p ?o FILTER(?o = 1 && EXISTS { ?s ?p e:d }) }"),
              HasSubstr("write it as a filter of its own, FILTER EXISTS { ... }"));
  EXPECT_THAT(found("SELECT * { ?s ?p ?o FILTER EXISTS { ?s ?p e:d MINUS { ?s ?q ?r } } }"), HasSubstr("MINUS within"));
  EXPECT_THAT(found("SELECT * { ?s ?p ?o FILTER EXISTS { ?s ?p e:d { SELECT ?s { ?s ?q ?r } } } }"),
              HasSubstr("SELECT within"));
  EXPECT_THAT(found("SELECT * { ?s ?p ?o FILTER EXISTS { BIND(1 AS ?o) } }"), HasSubstr("BIND within"));
}

TEST_F(Existence, SeesOnlyWhatIsBoundInItsGroupBesideAnother) {
  EXPECT_EQ(
      found("SELECT ?x { ?x e:age ?n { FILTER EXISTS { ?x e:knows e:b } FILTER NOT EXISTS { ?x e:knows e:d } } }"),
      "abc")
      << "nothing is bound in the inner group, so that both hold for every row";
  EXPECT_EQ(found("SELECT ?x { ?x e:age ?n { BIND(1 AS ?b) FILTER NOT EXISTS { ?x e:knows ?y } } }"), "");
}

TEST_F(Existence, IsRefusedAloneInAGroupThatRasqalWouldDissolve) {
  for (const char* alone :
       {"{ FILTER NOT EXISTS { ?x e:knows ?y } }", "{ FILTER NOT EXISTS { ?x e:knows ?y } . }",
        "OPTIONAL {filter ( exists { ?x e:knows ?y } )}", "{ ?x e:age 1 } UNION { FILTER EXISTS { ?x e:knows ?y } }"})
    EXPECT_THAT(found(std::string("SELECT ?x { ?x e:age ?n ") + alone + " }"), HasSubstr("beside the triples"));
}

TEST_F(Existence, BindsNoVariableOfSelectAll) {
  const auto variables = [&](const std::string& query) { return ask(query)->variables; };
  EXPECT_THAT(variables("SELECT * { ?x e:age ?n FILTER NOT EXISTS { ?x e:knows ?y } }"), ElementsAre("x", "n"));
  EXPECT_THAT(variables("SELECT * { ?x e:age ?n MINUS { ?x e:knows ?y } }"), ElementsAre("x", "n"));
  EXPECT_THAT(variables("SELECT * { ?x e:age ?n MINUS { ?x e:knows ?y } ?y e:age 1 . BIND(1 AS ?b) }"),
              testing::UnorderedElementsAre("x", "n", "y", "b"));
  EXPECT_THAT(variables("SELECT * { { SELECT ?x { ?x e:age ?n } } VALUES ?v { 1 } }"),
              testing::UnorderedElementsAre("x", "v"));
}

TEST_F(Existence, EndsAtTheLimitOfAQuery) {
  const std::string query = "SELECT ?x { ?x e:age ?n FILTER NOT EXISTS { ?y ?p ?q . ?q ?r ?z FILTER(?z = ?n) } }";
  const auto asked = [&](base::Budget& budget) {
    return graph::ask(graph_, query,
                      {.prefixes = {{"e", "http://e/"}}, .format = Format::n_triples, .budget = &budget});
  };
  base::Budget plenty;
  ASSERT_TRUE(asked(plenty));
  base::Budget scarce(plenty.spent() - 1);
  const auto answer = asked(scarce);
  ASSERT_FALSE(answer);
  EXPECT_TRUE(answer.error().is_limit);
}

TEST_F(Existence, DescribesAResourceByItsStatements) {
  const auto text = [&](const std::string& query, const GraphLimits& limits = {}) {
    const auto answer = ask(query, limits);
    return answer ? answer->text : answer.error().text;
  };
  const std::string of_c = "<http://e/c> <http://e/age> \"3\"^^<http://www.w3.org/2001/XMLSchema#integer> .\n";
  EXPECT_EQ(text("DESCRIBE e:c"), of_c);
  EXPECT_EQ(text("PREFIX f: <http://e/> DESCRIBE f:c <http://e/none>"), of_c);
  EXPECT_EQ(text("DESCRIBE ?x { ?x e:age ?n FILTER NOT EXISTS { ?x e:knows ?y } }"), of_c);
  EXPECT_EQ(text("# DESCRIBE *\nDESCRIBE ?x { e:b e:knows ?x . ?x e:age ?describe }"), of_c);
  EXPECT_THAT(text("describe # all\n* { e:b e:knows ?x }"), HasSubstr("name the variables"));
  EXPECT_EQ(text("DESCRIBE e:none"), "");
  const std::string of_b = text("DESCRIBE e:b");
  EXPECT_EQ(std::ranges::count(of_b, '\n'), 6) << "with the blank nodes, each once: " << of_b;
  GraphLimits limits;
  for (const std::size_t most : {5U, 6U, 7U}) {
    limits.rows = most;
    const auto answer = ask("DESCRIBE e:b", limits);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->is_cut, most < 6) << most;
    EXPECT_EQ(std::ranges::count(answer->text, '\n'), std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(most), 6));
  }
}

}  // namespace
}  // namespace geminga::graph
