// Random facts under axioms that name individuals: keys, nominals, values, chains, self restrictions and rules. What
// realisation finds is what follows when each fact is asked by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "reasoning/realization/realization.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "support/rounds.hpp"

namespace geminga::realization {
namespace {

using reasoner::Verdict;

constexpr std::uint64_t individuals = 4;
constexpr std::uint64_t classes = 4;
constexpr std::uint64_t simple_properties = 3;  // s0 .. s2; t0 and t1 have chains
constexpr std::uint64_t data_properties = 2;
constexpr std::array<std::string_view, 4> literals{"\"0\"^^xsd:integer", "\"1\"^^xsd:integer", "\"2\"^^xsd:integer",
                                                   "\"a\""};

/// Writes axioms of functional syntax, a line each.
class Writer {
 public:
  explicit Writer(std::uint64_t seed) : random_(seed) {}

  std::string world(std::size_t axiom_count, std::size_t fact_count) {
    std::string text;
    for (std::size_t at = 0; at < axiom_count; ++at) text += axiom() + '\n';
    for (std::size_t at = 0; at < fact_count; ++at) text += fact() + '\n';
    return text;
  }

 private:
  std::uint64_t below(std::uint64_t end) { return random_.below(end); }
  std::string numbered(std::string_view name, std::uint64_t end) {
    return ':' + std::string(name) + std::to_string(below(end));
  }
  std::string class_name() { return numbered("C", classes); }
  std::string individual() { return numbered("i", individuals); }
  std::string simple() { return numbered("s", simple_properties); }
  std::string data() { return numbered("d", data_properties); }
  std::string literal() { return std::string(literals[below(literals.size())]); }
  std::string property() { return random_.chance(0.3) ? numbered("t", 2) : simple(); }
  static std::string call(std::string_view name, std::initializer_list<std::string> arguments) {
    std::string text = std::string(name) + '(';
    for (const std::string& argument : arguments) text += argument + ' ';
    text.back() = ')';
    return text;
  }

  std::string expression() {
    switch (below(15)) {
      case 0:
        return call("ObjectHasValue", {property(), individual()});
      case 1:
        return call("DataHasValue", {data(), literal()});
      case 2:
        return call("ObjectOneOf", {individual(), individual()});
      case 3:
        return call("ObjectHasSelf", {simple()});
      case 4:
        return call("ObjectUnionOf", {class_name(), class_name()});
      case 5:
        return call("ObjectAllValuesFrom", {property(), class_name()});
      case 6:
        return call("ObjectMaxCardinality", {"1", simple()});
      case 7:
        return call("DataSomeValuesFrom", {data(), "DataOneOf(" + literal() + ' ' + literal() + ')'});
      case 8:
        return call("ObjectComplementOf", {class_name()});
      case 9:
        return call("ObjectSomeValuesFrom", {property(), call("ObjectOneOf", {individual(), individual()})});
      case 10:
        return call("ObjectSomeValuesFrom", {property(), call("ObjectHasValue", {property(), individual()})});
      case 11:
        return call("DataSomeValuesFrom",
                    {data(), "DatatypeRestriction(xsd:integer xsd:minInclusive " + std::string(literals[1]) +
                                 " xsd:maxInclusive " + std::string(literals[below(2) + 1]) + ')'});
      case 12:
        return call("ObjectIntersectionOf", {class_name(), class_name()});
      default:
        return call("ObjectSomeValuesFrom", {property(), class_name()});
    }
  }

  std::string axiom() {
    switch (below(22)) {
      case 0:
        return call("HasKey", {random_.chance(0.5) ? "owl:Thing" : class_name(), "()", '(' + data() + ')'});
      case 1:
        return call("HasKey", {class_name(), '(' + simple() + ')', random_.chance(0.5) ? "()" : '(' + data() + ')'});
      case 2:
        return call("FunctionalObjectProperty", {simple()});
      case 3:
        return call("InverseFunctionalObjectProperty", {simple()});
      case 4:
        return call("FunctionalDataProperty", {data()});
      case 5:
        return call("SubObjectPropertyOf", {simple(), property()});
      case 6:
        return call("InverseObjectProperties", {simple(), simple()});
      case 7:
        return call("TransitiveObjectProperty", {":t0"});
      case 8:
        return call("SubObjectPropertyOf", {call("ObjectPropertyChain", {simple(), simple()}), ":t0"});
      case 9:
        return call("SubObjectPropertyOf", {call("ObjectPropertyChain", {simple(), ":t0"}), ":t1"});
      case 10:
        return call("SymmetricObjectProperty", {simple()});
      case 11:
        return call(random_.chance(0.5) ? "ReflexiveObjectProperty" : "SymmetricObjectProperty", {property()});
      case 12:
        return call("SubDataPropertyOf", {":d0", ":d1"});
      case 13:
        return call(
            "DLSafeRule",
            {call("Body", {call("ObjectPropertyAtom", {property(), x, y}), call("ClassAtom", {class_name(), x})}),
             call("Head", {rule_head()})});
      case 14:
        return call("DLSafeRule",
                    {call("Body", {call("DataPropertyAtom", {data(), x, v}), call("DataPropertyAtom", {data(), y, v})}),
                     call("Head", {rule_head()})});
      case 15:
        return call("ObjectPropertyRange", {property(), class_name()});
      case 16:
        return call("EquivalentClasses", {class_name(), expression()});
      case 17:
      case 18:
        return call("SubClassOf", {expression(), class_name()});
      default:
        return call("SubClassOf", {class_name(), expression()});
    }
  }

  std::string rule_head() {
    switch (below(4)) {
      case 0:
        return call("SameIndividualAtom", {x, y});
      case 1:
        return call("ClassAtom", {class_name(), y});
      case 2:
        return call("ObjectPropertyAtom", {property(), y, x});
      default:
        return call("DataPropertyAtom", {data(), y, literal()});
    }
  }

  std::string fact() {
    switch (below(9)) {
      case 0:
      case 1:
        return call("ClassAssertion", {random_.chance(0.6) ? class_name() : expression(), individual()});
      case 2:
        return call("DifferentIndividuals", {":i0", numbered("i", 3) == ":i1" ? ":i1" : ":i2"});
      case 3:
        return random_.chance(0.3) ? call("SameIndividual", {individual(), individual()})
                                   : call("ClassAssertion", {class_name(), individual()});
      case 4:
      case 5:
        return call("DataPropertyAssertion", {data(), individual(), literal()});
      default:
        return call("ObjectPropertyAssertion", {property(), individual(), individual()});
    }
  }

  static constexpr const char* x = "Variable(:x)";
  static constexpr const char* y = "Variable(:y)";
  static constexpr const char* v = "Variable(:v)";
  base::Random random_;
};

/// Every statement about the names of a world, a line each.
std::vector<std::string> statements() {
  std::vector<std::string> all;
  const auto name = [](std::string_view of, std::uint64_t number) {
    return " :" + std::string(of) + std::to_string(number);
  };
  for (std::uint64_t first = 0; first < individuals; ++first) {
    const std::string subject = name("i", first);
    for (std::uint64_t at = 0; at < classes; ++at) all.push_back("ClassAssertion(" + name("C", at) + subject + ')');
    for (std::uint64_t second = 0; second < individuals; ++second) {
      const std::string object = name("i", second);
      if (first != second) all.push_back("SameIndividual(" + subject + object + ')');
      for (std::uint64_t at = 0; at < simple_properties; ++at)
        all.push_back("ObjectPropertyAssertion(" + name("s", at) + subject + object + ')');
      for (std::uint64_t at = 0; at < 2; ++at)
        all.push_back("ObjectPropertyAssertion(" + name("t", at) + subject + object + ')');
    }
    for (std::uint64_t at = 0; at < data_properties; ++at) {
      for (const std::string_view literal : literals)
        all.push_back("DataPropertyAssertion(" + name("d", at) + subject + ' ' + std::string(literal) + ')');
    }
  }
  return all;
}

std::size_t read_lines(const std::string& lines, owl::Ontology& source) {
  const std::string text =
      "Prefix(:=<http://e/>)Prefix(xsd:=<http://www.w3.org/2001/XMLSchema#>)Prefix(owl:=<http://www.w3.org/2002/07/"
      "owl#>)Ontology(\n" +
      lines + ')';
  const auto read = functional::read(text, source.add_file("a.ofn"), source, {.wrong_axioms = 0});
  EXPECT_TRUE(read) << text;
  return source.axiom_count();
}

/// Whether realisation has found the statement of an axiom.
bool is_found(const owl::Ontology& source, const Realization& found, const taxonomy::Classification& classification,
              const owl::Axiom& axiom) {
  const auto place = [&](owl::TermId individual) {
    const auto entry = std::ranges::find(found.individuals, individual);
    return static_cast<std::size_t>(entry - found.individuals.begin());
  };
  switch (axiom.kind) {
    case owl::AxiomKind::class_assertion: {
      const std::size_t at = place(axiom.arguments[1]);
      if (at == found.individuals.size()) return false;
      for (std::size_t of = 0; of < classification.class_count(); ++of) {
        if (source.name(classification.classes[of]) != source.name_of(axiom.arguments[0])) continue;
        const auto number = classification.representative[of];
        return number == classification.representative[static_cast<std::size_t>(classification.thing)] ||
               std::ranges::binary_search(found.type_sets[found.types[at]], number);
      }
      return false;
    }
    case owl::AxiomKind::same_individual: {
      const std::size_t first = place(axiom.arguments[0]);
      const std::size_t second = place(axiom.arguments[1]);
      if (first == found.individuals.size() || second == found.individuals.size()) return false;
      return found.representative[first] == found.representative[second];
    }
    default:
      return std::ranges::binary_search(found.facts, Fact{axiom.arguments[1], axiom.arguments[0], axiom.arguments[2]});
  }
}

/// Whether the individuals of a statement are those of the world.
bool names_only(const owl::Ontology& source, const Realization& found, const owl::Axiom& statement) {
  return std::ranges::all_of(statement.arguments, [&](owl::TermId term) {
    return source.kind(term) != owl::TermKind::individual ||
           std::ranges::find(found.individuals, term) != found.individuals.end();
  });
}

TEST(RandomWorlds, AreRealisedAsEachFactIsEntailed) {
  const std::vector<std::string> asked = statements();
  std::string asked_lines;
  for (const std::string& line : asked) asked_lines += line + '\n';
  std::size_t complete = 0;
  std::size_t consistent = 0;
  const std::uint64_t worlds = test::rounds<std::uint64_t>(100);
  for (std::uint64_t seed = 1; seed <= worlds; ++seed) {
    const std::string world = Writer(seed).world(2 + seed % 7, 4 + seed % 5);
    SCOPED_TRACE("seed " + std::to_string(seed) + '\n' + world);
    owl::Ontology source;
    const std::size_t count = read_lines(world, source);
    const auto classification = reasoner::classify(source);
    ASSERT_TRUE(classification);
    const Realization found = realize(source, *classification, {.with_facts = true});
    if (!found.is_consistent) {
      EXPECT_EQ(reasoner::is_consistent(source).verdict, Verdict::no);
      continue;
    }
    ++consistent;
    const bool is_complete = found.gaps.empty() && classification->gaps.empty() && classification->unused.empty();
    complete += is_complete ? 1U : 0U;
    const std::size_t total = read_lines(world + asked_lines, source) - count;
    std::vector<std::uint32_t> premise(count);
    std::iota(premise.begin(), premise.end(), 0U);
    ASSERT_EQ(total, count + asked.size());
    std::vector<std::uint32_t> conclusion(asked.size());
    std::iota(conclusion.begin(), conclusion.end(), static_cast<std::uint32_t>(count + count));
    const std::vector<reasoner::Answer> answers = reasoner::entails_each(source, premise, conclusion);
    for (std::size_t at = 0; at < asked.size(); ++at) {
      if (!names_only(source, found, source.axiom(conclusion[at]))) continue;
      const bool has = is_found(source, found, *classification, source.axiom(conclusion[at]));
      if (has) {
        EXPECT_NE(answers[at].verdict, Verdict::no) << asked[at] << " is found and does not follow";
      } else if (is_complete) {
        EXPECT_NE(answers[at].verdict, Verdict::yes) << asked[at] << " follows and is not found";
      }
    }
    if (HasFailure()) return;  // one ontology at a time is enough to look at
  }
  EXPECT_GT(complete * 2, consistent) << "the comparison says little where most is left open";
}

}  // namespace
}  // namespace geminga::realization
