// Class expressions in a query ask their finder for names, which join with the triples of the graph.
#include "reasoning/syntax/graph/expressions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/graph/query.hpp"

namespace geminga::graph {
namespace {

using testing::HasSubstr;

/// A finder of names that notes what it is asked for. It answers with the individuals e:a and e:c, the classes e:b and
/// e:c below an expression, and e:c and e:d above it.
struct Finder {
  std::vector<AskedExpression> asked;
  FindNames find = [this](const AskedExpression& expression) -> std::expected<FoundNames, std::string> {
    asked.push_back(expression);
    return FoundNames{{"http://e/c", "http://e/a"}, {"http://e/b", "http://e/c"}, {"http://e/c", "http://e/d"}};
  };
};

class ClassExpressions : public testing::Test {
 protected:
  ClassExpressions() {
    for (const std::string name : {"a", "b", "c"}) {
      graph_.add(iri("http://e/" + name), iri(rdfs_sub_class_of), iri("http://e/d"));
      graph_.add(iri("http://e/" + name), iri(rdfs_label), {Node::Kind::literal, "the " + name, {}, "en"});
    }
    graph_.sort();
  }

  [[nodiscard]] std::expected<Answer, AskError> ask(const std::string& query, Finder& finder) const {
    const Prefixes prefixes{{"e", "http://e/"},
                            {"owl", std::string(syntax::owl_namespace)},
                            {"rdfs", "http://www.w3.org/2000/01/rdf-schema#"}};
    return graph::ask(graph_, query, {.prefixes = prefixes, .format = Format::n_triples, .find_names = finder.find});
  }
  /// The last letters of the IRIs that ?x stands for, one for each row.
  [[nodiscard]] std::string rows(const std::string& pattern) const {
    Finder finder;
    const auto answer = ask("SELECT ?x WHERE { " + pattern + " }", finder);
    if (!answer) return answer.error().text;
    std::string text;
    for (const auto& row : answer->rows) text += row[0] ? row[0]->text.substr(9) : "-";
    return text + (answer->has_asserted_expressions ? " asserted" : "");
  }
  [[nodiscard]] std::string refusal(const std::string& pattern) const {
    Finder finder;
    const auto answer = ask("SELECT * WHERE { " + pattern + " }", finder);
    return answer ? "answered" : answer.error().text;
  }

  Graph graph_;
};

TEST_F(ClassExpressions, JoinTheirInstancesWithTheGraph) {
  const std::string some = "[ a owl:Restriction ; owl:onProperty e:p ; owl:someValuesFrom [ owl:oneOf ( e:a e:b ) ] ]";
  EXPECT_EQ(rows("?x a " + some), "ac");
  EXPECT_EQ(rows("e:a a " + some + " . ?x rdfs:label ?l"), "abc");
  EXPECT_EQ(rows("e:b a " + some + " . ?x rdfs:label ?l"), "");
  EXPECT_EQ(rows("?x rdfs:label \"the c\"@en . ?x a " + some), "c");
  EXPECT_EQ(rows("?x a " + some + " . ?x a [ owl:complementOf e:d ]"), "ac");
  EXPECT_EQ(rows("{ ?x a [ owl:unionOf ( e:a e:b ) ] } UNION { ?x rdfs:subClassOf e:d }"), "acabc");
  EXPECT_EQ(rows("?x rdfs:subClassOf e:d OPTIONAL { ?y a " + some + " . FILTER(?y = ?x) }"), "abc");
  EXPECT_EQ(rows("{ SELECT ?x WHERE { ?x a " + some + " } }"), "ac");
  EXPECT_EQ(rows("?y a " + some + " . ?z owl:onProperty ?x"), "") << "the expression is no triple of the graph";
  EXPECT_EQ(rows("?y a " + some + " . ?y a ?x"), "");
}

TEST_F(ClassExpressions, JoinTheClassesBesideThemWithTheGraph) {
  const std::string some = "[ owl:onProperty e:p ; owl:someValuesFrom e:d ]";
  EXPECT_EQ(rows("?x rdfs:subClassOf " + some), "bc");
  EXPECT_EQ(rows(some + " rdfs:subClassOf ?x"), "cd");
  EXPECT_EQ(rows("?x owl:equivalentClass " + some), "c");
  EXPECT_EQ(rows(some + " owl:equivalentClass ?x"), "c");
  EXPECT_EQ(rows("?x rdfs:subClassOf " + some + " ; a " + some), "c");
  EXPECT_EQ(rows("?x rdfs:subClassOf " + some + " FILTER NOT EXISTS { ?x a " + some + " }"), "b");
  EXPECT_EQ(rows("?x rdfs:subClassOf _:b ; a _:b . _:b owl:onProperty e:p ; owl:someValuesFrom e:d"), "c");
  EXPECT_EQ(rows("?x rdfs:subClassOf [ owl:onProperty e:p ; owl:someValuesFrom ?y ]"), " asserted");
  EXPECT_EQ(rows("?x owl:disjointWith " + some), " asserted");
  EXPECT_EQ(rows("?x rdfs:subClassOf e:d . ?r owl:onProperty e:p"), "") << "a variable is no class expression";
}

TEST_F(ClassExpressions, AreGivenAsTheirTriplesAlone) {
  Finder finder;
  const auto answer =
      ask("SELECT ?x WHERE { ?x a [ a owl:Restriction ; owl:onProperty "
          "e:p ; owl:maxCardinality 1 ] ; rdfs:label ?l }",
          finder);
  ASSERT_TRUE(answer) << answer.error().text;
  ASSERT_EQ(finder.asked.size(), 1U);
  const AskedExpression& asked = finder.asked.front();
  ASSERT_EQ(asked.triples.size(), 3U);
  for (const auto& triple : asked.triples) EXPECT_EQ(triple.subject, asked.root);
  EXPECT_EQ(asked.triples.back().object,
            (Node{Node::Kind::literal, "1", "http://www.w3.org/2001/XMLSchema#integer", {}}));
}

TEST_F(ClassExpressions, AreRefusedWhereTheyCannotBeAskedFor) {
  EXPECT_THAT(refusal("?x a [ owl:onProperty ?p ; owl:someValuesFrom e:d ]"), HasSubstr("a variable stands in"));
  EXPECT_THAT(refusal("?x a [ owl:onProperty e:p ; ?q e:d ]"), HasSubstr("a variable stands in"));
  EXPECT_THAT(refusal("?x a _:b . _:b owl:complementOf e:d . ?y owl:disjointWith _:b"), HasSubstr("stand elsewhere"));
  EXPECT_THAT(refusal("?x a _:b . _:b owl:complementOf e:d . ?y ?p _:b"), HasSubstr("stand elsewhere"));
  EXPECT_THAT(refusal("[ owl:complementOf e:d ] rdfs:subClassOf [ owl:complementOf e:c ]"),
              HasSubstr("does not compare two class expressions"));
  EXPECT_EQ(refusal("?x a _:b . _:b owl:complementOf e:d . ?y rdfs:subClassOf _:b"), "answered");
  for (const std::size_t count : {max_expressions - 1, max_expressions, max_expressions + 1}) {
    std::string pattern;
    for (std::size_t at = 0; at < count; ++at) pattern += "?x a [ owl:complementOf e:d ] . ";
    EXPECT_EQ(refusal(pattern) == "answered", count <= max_expressions) << count;
  }
}

}  // namespace
}  // namespace geminga::graph
