// SELECT, ASK and CONSTRUCT are answered; what would fetch or change something is refused.
#include "reasoning/syntax/graph/query.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/graph/formulas/formulas.hpp"

namespace geminga::graph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Prefixes prefixes{{"e", "http://e/"}, {"rdfs", "http://www.w3.org/2000/01/rdf-schema#"}};

class Query : public testing::Test {
 protected:
  Query() {
    for (const std::string name : {"a", "b", "c"}) {
      graph_.add(iri("http://e/" + name), iri(rdfs_sub_class_of), iri("http://e/d"));
      graph_.add(iri("http://e/" + name), iri(rdfs_label), {Node::Kind::literal, "the " + name, {}, "en"});
    }
    graph_.sort();
  }

  [[nodiscard]] std::expected<Answer, AskError> ask(const std::string& query, const GraphLimits& limits = {}) const {
    return graph::ask(graph_, query, {.prefixes = prefixes, .format = Format::n_triples, .limits = limits});
  }
  [[nodiscard]] std::string refusal(const std::string& query) const {
    const auto answer = ask(query);
    return answer ? "answered" : answer.error().text;
  }

  Graph graph_;
};

TEST_F(Query, SelectsRowsInTheOrderThatItAsksFor) {
  const auto answer =
      ask("SELECT ?x ?l ?none WHERE { ?x rdfs:subClassOf e:d ; rdfs:label ?l } ORDER BY DESC(?l) LIMIT 2");
  ASSERT_TRUE(answer) << answer.error().text;
  EXPECT_EQ(answer->kind, Answer::Kind::rows);
  EXPECT_THAT(answer->variables, ElementsAre("x", "l", "none"));
  ASSERT_EQ(answer->rows.size(), 2U);
  EXPECT_EQ(answer->rows[0][0], iri("http://e/c"));
  EXPECT_EQ(answer->rows[0][1], (Node{Node::Kind::literal, "the c", {}, "en"}));
  EXPECT_EQ(answer->rows[0][2], std::nullopt);
  EXPECT_EQ(answer->rows[1][0], iri("http://e/b"));
}

TEST_F(Query, AsksAndConstructs) {
  EXPECT_TRUE(ask("ASK { e:a rdfs:subClassOf e:d }")->is_true);
  EXPECT_FALSE(ask("ASK { e:d rdfs:subClassOf e:a }")->is_true);
  const auto answer = ask("CONSTRUCT { ?x e:below e:d } WHERE { ?x rdfs:subClassOf e:d . FILTER(?x != e:b) }");
  ASSERT_TRUE(answer) << answer.error().text;
  EXPECT_EQ(answer->text,
            "<http://e/a> <http://e/below> <http://e/d> .\n<http://e/c> <http://e/below> <http://e/d> .\n");
}

TEST_F(Query, MayBeginWithABase) {
  const auto answer = ask("BASE <http://e/> SELECT ?x { ?x rdfs:subClassOf <d> }");
  ASSERT_TRUE(answer) << answer.error().text;
  EXPECT_EQ(answer->rows.size(), 3U);
}

TEST_F(Query, FindsATextOfXsdStringOnce) {
  Graph graph;
  graph.add(iri("http://e/a"), iri(rdfs_label), {Node::Kind::literal, "x", {}, {}});
  graph.add(iri("http://e/a"), iri(rdfs_label), {Node::Kind::literal, "x", std::string(xsd_string), {}});
  graph.sort();
  for (const std::string wanted : {"?l", "\"x\"", "\"x\"^^<http://www.w3.org/2001/XMLSchema#string>"}) {
    const auto answer = graph::ask(graph, "SELECT * { ?s ?p " + wanted + " }", {.prefixes = prefixes});
    EXPECT_EQ(answer->rows.size(), 1U) << wanted;
  }
}

TEST_F(Query, MayDeclareItsPrefixesItself) {
  const auto answer = ask("PREFIX e: <http://other/> SELECT ?x WHERE { ?x rdfs:subClassOf e:d }");
  ASSERT_TRUE(answer) << answer.error().text;
  EXPECT_TRUE(answer->rows.empty());
}

TEST_F(Query, FetchesAndChangesNothing) {
  EXPECT_THAT(refusal("SELECT * FROM <file:///etc/passwd> WHERE { ?s ?p ?o }"), HasSubstr("FROM would fetch"));
  EXPECT_THAT(refusal("SELECT * FROM NAMED <http://127.0.0.1/x> WHERE { GRAPH ?g { ?s ?p ?o } }"),
              HasSubstr("FROM would fetch"));
  EXPECT_THAT(refusal("SELECT * WHERE { SERVICE <http://127.0.0.1/sparql> { ?s ?p ?o } }"), testing::Ne("answered"));
  EXPECT_THAT(refusal("SELECT * WHERE { ?s ?p ?o OPTIONAL { { SERVICE <http://127.0.0.1/x> { ?a ?b ?c } } } }"),
              testing::Ne("answered"));
  for (const std::string change :
       {"LOAD <http://127.0.0.1/x>", "INSERT DATA { e:a e:p e:b }", "DELETE WHERE { ?s ?p ?o }", "CLEAR ALL"})
    EXPECT_THAT(refusal(change), testing::Ne("answered")) << change;
}

TEST_F(Query, IsRefusedByNameWhereRasqalDoesNotKnowAnOperation) {
  for (const std::string path : {"e:p+", "e:p/e:q", "^e:p", "e:p|e:q", "e:p*", "!e:p"})
    EXPECT_THAT(refusal("SELECT * WHERE { ?s " + path + " ?o }"), HasSubstr("does not know paths of properties"))
        << path;
  EXPECT_THAT(refusal("SELECT ?x WHERE { ?x e:p 'MINUS EXISTS' . ?x e:p <x:exists> # exists\n"),
              testing::Not(HasSubstr("EXISTS")));
}

/// The answers of a query over a few numbers, as text: a row after another, unbound values as -.
std::string answered(const std::string& query) {
  Graph graph;
  const auto number = [](const std::string& value, const std::string& type) {
    return Node{Node::Kind::literal, value, "http://www.w3.org/2001/XMLSchema#" + type, {}};
  };
  const auto add = [&](const std::string& subject, const std::string& property, const Node& object) {
    graph.add(iri("http://e/" + subject), iri("http://e/" + property), object);
  };
  add("a", "n", number("1", "integer"));
  add("b", "n", number("2", "integer"));
  add("c", "n", number("10", "integer"));
  add("d", "n", number("2", "integer"));
  add("a", "p", iri("http://e/b"));
  add("a", "p", iri("http://e/c"));
  add("b", "p", iri("http://e/c"));
  add("a", "l", {Node::Kind::literal, "Anna", {}, "de"});
  add("b", "l", {Node::Kind::literal, "Bert", {}, {}});
  add("c", "l", number("true", "boolean"));
  graph.sort();
  const Prefixes own{{"e", "http://e/"}, {"xsd", "http://www.w3.org/2001/XMLSchema#"}};
  const auto answer = graph::ask(graph, query, {.prefixes = own, .format = Format::n_triples});
  if (!answer) return answer.error().text;
  if (answer->kind == Answer::Kind::triples) return answer->text;
  std::string text;
  for (const auto& row : answer->rows) {
    for (const auto& node : row) {
      text.append(text.empty() || text.ends_with('|') ? "" : " ");
      text += !node ? "-" : node->kind == Node::Kind::iri ? node->text.substr(node->text.rfind('/') + 1) : node->text;
    }
    text += '|';
  }
  return text;
}

TEST(Sparql, CountsWhatIsBoundAndCountsNothingAsZero) {
  EXPECT_EQ(answered("SELECT (COUNT(*) AS ?n) { ?x e:none ?y }"), "0|");
  EXPECT_EQ(answered("SELECT (COUNT(?l) AS ?n) (COUNT(*) AS ?m) { ?x e:n ?a OPTIONAL { ?x e:l ?l } }"), "3 4|");
  EXPECT_EQ(answered("SELECT (COUNT(DISTINCT ?a) AS ?n) (SUM(?a) AS ?s) (AVG(?a) AS ?v) { ?x e:n ?a }"), "3 15 3.75|");
  EXPECT_EQ(answered("SELECT (COUNT(*) AS ?n) { ?x e:none ?y } GROUP BY ?x"), "");
}

TEST(Sparql, GroupsWithConditionsAndSeparators) {
  EXPECT_EQ(answered("SELECT ?x (GROUP_CONCAT(?l; SEPARATOR='+') AS ?s) { ?x e:p ?y . ?y e:n ?l } GROUP BY ?x"),
            "a 2+10|b 10|");
  EXPECT_EQ(answered("SELECT ?x (MAX(?a) AS ?m) { ?x e:p ?y . ?y e:n ?a } GROUP BY ?x HAVING (MIN(?a) > 5)"), "b 10|");
  EXPECT_EQ(answered("SELECT ?k (COUNT(?x) AS ?c) { ?x e:n ?a } GROUP BY (?a > 1 AS ?k) ORDER BY ?k"),
            "false 1|true 3|");
  EXPECT_EQ(answered("SELECT ?a { ?x e:n ?a } GROUP BY ?a ORDER BY ?a"), "1|2|10|");
  EXPECT_THAT(answered("SELECT ?x (COUNT(*) AS ?c) { ?x e:n ?a }"),
              HasSubstr("?x has a value for each row of a group"));
}

TEST(Sparql, OrdersWhatIsDistinctByNumber) {
  EXPECT_EQ(answered("SELECT DISTINCT ?a { ?x e:n ?a } ORDER BY DESC(?a) LIMIT 2"), "10|2|");
  EXPECT_EQ(answered("SELECT ?x { ?x e:n ?a } ORDER BY ?a DESC(?x) OFFSET 1 LIMIT 2"), "d|b|");
}

TEST(Sparql, ReadsValuesAndQueriesWithinQueries) {
  EXPECT_EQ(answered("SELECT ?x { VALUES ?a { 1 10 } ?x e:n ?a }"), "a|c|");
  EXPECT_EQ(answered("SELECT ?x ?a { ?x e:n ?a } VALUES (?x ?a) { (e:a 1) (<http://e/b> UNDEF) (e:c 7) }"), "a 1|b 2|");
  EXPECT_EQ(answered("SELECT ?x ?m { { SELECT ?x (MAX(?a) AS ?m) { ?x e:p ?y . ?y e:n ?a } GROUP BY ?x } "
                     "FILTER(?m > 2) }"),
            "a 10|b 10|");
  EXPECT_EQ(answered("SELECT ?y { ?x e:p ?y { SELECT ?x { ?x e:n ?a } ORDER BY DESC(?a) LIMIT 3 } } ORDER BY ?y"),
            "c|");
}

TEST(Sparql, KeepsRowsWhoseValuesAreErrors) {
  EXPECT_EQ(answered("SELECT ?x ?b { ?x e:n 2 BIND(1 / 0 AS ?b) } ORDER BY ?x"), "b -|d -|");
  EXPECT_EQ(answered("SELECT ?x { ?x e:l ?l FILTER(?l < 'Z') }"), "b|") << "a language and a truth value are no texts";
  EXPECT_EQ(answered("SELECT ?x { ?x e:l ?l FILTER(isNumeric(?l)) }"), "");
}

TEST(Sparql, MakesTextsOfNumbers) {
  EXPECT_EQ(answered("SELECT (CONCAT(STR(?x), '-', STR(?a)) AS ?t) { ?x e:n ?a FILTER(?a = 10) }"), "http://e/c-10|");
  EXPECT_EQ(answered("SELECT (REPLACE(?l, '(B)(e)', '$2$1') AS ?t) (UCASE(?l) AS ?u) { e:b e:l ?l }"), "eBrt BERT|");
}

TEST(Sparql, TakesAwayWhatIsThere) {
  EXPECT_EQ(answered("SELECT ?x { ?x e:n ?a MINUS { ?x e:p ?y } } ORDER BY ?x"), "c|d|");
  EXPECT_EQ(answered("SELECT ?x { ?x e:n ?a MINUS { ?z e:p ?y } } ORDER BY ?x"), "a|b|c|d|") << "no variable is shared";
}

TEST(Sparql, ReadsSignsBetweenOperandsAsOperators) {
  EXPECT_EQ(
      answered("SELECT (3-1 AS ?d) (?a -1 AS ?b) (1+1*2 AS ?c) (?a-1 AS ?e) (-1 AS ?f) (IF(?a > -1e-1, -2, 0) AS ?g) "
               "{ e:b e:n ?a VALUES (?a ?q) { (2 -5) } FILTER(?q < -4 && ?q = -5) } # a comment at the end"),
      "2 1 3 1 -1 -2|");
}

TEST(Sparql, WorksOutConstantsItself) {
  EXPECT_EQ(
      answered("SELECT ?a ?b ?c ?d ?e { BIND(2147483647 + 1 AS ?a) BIND(isNumeric(false) AS ?b) "
               "BIND(- -1 - .5 AS ?c) BIND(UCASE(\"\u00e4#(\"@en) AS ?d) BIND(COALESCE(STRLEN(-1), 'x') AS ?e) }"),
      "2147483648 false 0.5 \u00c4#( x|")
      << "rasqal says -2147483648, true, nothing, the small letter and 2";
  EXPECT_EQ(answered("SELECT ?x { ?x e:n ?n . FILTER(1 = 1) FILTER(?n IN (1, -1, 10)) } # (1"), "a|c|");
  EXPECT_EQ(answered("SELECT (GROUP_CONCAT(?a; SEPARATOR=\"5\") AS ?all) { VALUES (?x) { (e:a) (e:b) } ?x e:n ?a "
                     "{ SELECT (true AS ?t) { e:a e:p ?y } ORDER BY (7) LIMIT 1 } }"),
            "152|");
  EXPECT_EQ(answered("SELECT ?l { ?l e:is (1 \"2\"^^xsd:string) }"), "") << "the members of a list are no expressions";
  EXPECT_THAT(answered("SELECT (COALESCE(1, RAND()) AS ?r) {}"), HasSubstr("rand"));
}

TEST(Sparql, HasALimitOfLevelsOfAnExpression) {
  for (const std::size_t levels : {max_formula_levels - 1, max_formula_levels, max_formula_levels + 1}) {
    std::string sum = "?a";
    for (std::size_t level = 1; level < levels; ++level) sum += " + 1";
    const std::string answer = answered("SELECT (" + sum + " AS ?s) { e:a e:n ?a }");
    EXPECT_EQ(answer == std::to_string(levels) + '|', levels <= max_formula_levels) << levels << ": " << answer;
  }
}

TEST(Sparql, NamesWhatItDoesNotCompute) {
  EXPECT_THAT(answered("SELECT (MD5(?l) AS ?h) { ?x e:l ?l }"), HasSubstr("md5 is not computed here"));
  EXPECT_THAT(answered("SELECT ?x { ?x e:n ?a { FILTER(!bound(?x)) } }"), HasSubstr("does not bind"));
}

TEST_F(Query, IsRefusedWhereItCannotBeRead) {
  EXPECT_THAT(refusal("SELECT WHERE"), HasSubstr("the query cannot be read: "));
  EXPECT_THAT(refusal(""), HasSubstr("the query cannot be read: "));
  EXPECT_THAT(refusal("SELECT ?x WHERE { ?x \xff ?y }"), HasSubstr("no text in UTF-8"));
  EXPECT_THAT(refusal("SELECT ?x WHERE { ?x nobody:knows ?y }"), testing::Ne("answered"));
}

TEST_F(Query, HasLimitsOfRowsAndOfItsOwnLength) {
  for (const std::size_t most : {2U, 3U, 4U}) {
    const auto answer = ask("SELECT ?x WHERE { ?x rdfs:subClassOf e:d }", {.rows = most});
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->rows.size(), std::min<std::size_t>(most, 3));
    EXPECT_EQ(answer->is_cut, most < 3);
  }
  const std::string query = "ASK { e:a rdfs:subClassOf e:d }";
  EXPECT_TRUE(ask(query, {.query_bytes = query.size()}));
  EXPECT_FALSE(ask(query, {.query_bytes = query.size() - 1}));
}

TEST_F(Query, FindsTriplesByEachOfTheirParts) {
  const auto rows = [&](const std::string& pattern) {
    const auto answer = ask("SELECT * WHERE { " + pattern + " }");
    return answer ? static_cast<int>(answer->rows.size()) : -1;
  };
  EXPECT_EQ(rows("?s ?p ?o"), 6);
  EXPECT_EQ(rows("e:a ?p ?o"), 2);
  EXPECT_EQ(rows("e:a rdfs:label ?o"), 1);
  EXPECT_EQ(rows("?s rdfs:label ?o"), 3);
  EXPECT_EQ(rows("?s ?p e:d"), 3);
  EXPECT_EQ(rows("?s rdfs:subClassOf e:d"), 3);
  EXPECT_EQ(rows("e:a ?p e:d"), 1);
  EXPECT_EQ(rows("?s ?p \"the b\"@en"), 1);
  EXPECT_EQ(rows("?s ?p \"the b\""), 0);
  EXPECT_EQ(rows("?s rdfs:label ?l . ?s rdfs:subClassOf ?d . ?other rdfs:subClassOf ?d"), 9);
  EXPECT_EQ(rows("e:a rdfs:subClassOf ?x OPTIONAL { ?x rdfs:label ?l }"), 1);
  EXPECT_EQ(rows("e:nobody ?p ?o"), 0);
}

TEST_F(Query, EndsAtItsLimitOfSteps) {
  const std::string query = "SELECT * WHERE { ?x rdfs:subClassOf e:d . ?x rdfs:label ?l }";
  const auto asked = [&](base::Budget& budget) {
    return graph::ask(graph_, query, {.prefixes = prefixes, .format = Format::n_triples, .budget = &budget});
  };
  base::Budget plenty;
  ASSERT_TRUE(asked(plenty));
  const std::uint64_t needed = plenty.spent();
  for (const std::uint64_t steps : {needed - 1, needed, needed + 1}) {
    base::Budget budget(steps);
    const auto answer = asked(budget);
    EXPECT_EQ(answer.has_value(), steps > needed - 1) << steps << " of " << needed;
    EXPECT_TRUE(answer || answer.error().is_limit);
  }
}

/// A query whose braces nest so deep.
std::string nested(std::size_t levels) {
  std::string query = "SELECT * WHERE { ?s ?p ?o ";
  for (std::size_t level = 1; level < levels; ++level) query += "OPTIONAL { ?s ?p ?o ";
  return query + std::string(levels, '}');
}

TEST_F(Query, HasALimitOfNestedGroups) {
  for (const std::size_t most : {4U, 5U, 6U}) EXPECT_EQ(ask(nested(5), {.query_levels = most}).has_value(), most >= 5);
  EXPECT_THAT(refusal(nested(3000)), HasSubstr("nests groups deeper than 10 levels"));
  const auto in_brackets = [](std::size_t levels) {
    return "SELECT ?s WHERE { ?s ?p ?o FILTER " + std::string(levels, '(') + "?s = ?s" + std::string(levels, ')') +
           " }";
  };
  for (const std::size_t most : {4U, 5U, 6U})
    EXPECT_EQ(ask(in_brackets(5), {.query_brackets = most}).has_value(), most >= 5);
  EXPECT_THAT(refusal(in_brackets(15'000)), HasSubstr("nests brackets deeper than 1000 levels"));
  const std::string braces(20, '{');
  for (const std::string& harmless :
       std::vector<std::string>{"ASK { ?s ?p \"" + braces + "\" }", "ASK { ?s ?p '''" + braces + "' \\'''' }",
                                "ASK { ?s ?p ?o } # " + braces + "\n", "ASK { ?s ?p ?o . FILTER(?o < 3 && ?o > 2) }"})
    EXPECT_TRUE(ask(harmless)) << harmless << refusal(harmless);
  EXPECT_THAT(refusal("ASK { ?s ?p '}}}}}}}}}}}}' " + nested(12)), HasSubstr("nests groups deeper"));
  EXPECT_THAT(refusal("# it's\n" + nested(12)), HasSubstr("nests groups deeper"));
  EXPECT_THAT(refusal("PREFIX a: <http://e/'> " + nested(12)), HasSubstr("nests groups deeper"));
}

TEST_F(Query, EndsAtItsLimitOfOctets) {
  const auto answer = ask("SELECT * WHERE { ?s ?p ?o }", {.query_octets = 1});
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->is_cut);
  EXPECT_EQ(answer->rows.size(), 1U);
}

TEST(GraphLimit, OfOctetsCountsTriplesAndTheirTexts) {
  const std::size_t one = triple_octets + 3 * std::string("http://e/a").size();
  for (const std::size_t most : {2 * one - 1, 2 * one, 2 * one + 1}) {
    Graph graph({.octets = most});
    graph.add(iri("http://e/a"), iri("http://e/b"), iri("http://e/c"));
    EXPECT_FALSE(graph.problem());
    graph.add(iri("http://e/a"), iri("http://e/b"), iri("http://e/d"));
    EXPECT_EQ(graph.problem().has_value(), most < 2 * one) << most;
    EXPECT_EQ(graph.is_over_limit(), most < 2 * one) << most;
  }
}

}  // namespace
}  // namespace geminga::graph
