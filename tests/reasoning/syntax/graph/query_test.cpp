// SELECT, ASK and CONSTRUCT are answered; what would fetch or change something is refused.
#include "reasoning/syntax/graph/query.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/graph/axiom_triples.hpp"

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

  [[nodiscard]] std::expected<Answer, std::string> ask(const std::string& query, const GraphLimits& limits = {}) const {
    return graph::ask(graph_, query, prefixes, Format::n_triples, limits);
  }
  [[nodiscard]] std::string refusal(const std::string& query) const {
    const auto answer = ask(query);
    return answer ? "answered" : answer.error();
  }

  Graph graph_;
};

TEST_F(Query, SelectsRowsInTheOrderThatItAsksFor) {
  const auto answer =
      ask("SELECT ?x ?l ?none WHERE { ?x rdfs:subClassOf e:d ; rdfs:label ?l } ORDER BY DESC(?l) LIMIT 2");
  ASSERT_TRUE(answer) << answer.error();
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
  ASSERT_TRUE(answer) << answer.error();
  EXPECT_EQ(answer->text,
            "<http://e/a> <http://e/below> <http://e/d> .\n<http://e/c> <http://e/below> <http://e/d> .\n");
}

TEST_F(Query, MayDeclareItsPrefixesItself) {
  const auto answer = ask("PREFIX e: <http://other/> SELECT ?x WHERE { ?x rdfs:subClassOf e:d }");
  ASSERT_TRUE(answer) << answer.error();
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
  EXPECT_THAT(refusal("DESCRIBE e:a"), HasSubstr("write SELECT, ASK or CONSTRUCT"));
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

}  // namespace
}  // namespace geminga::graph
