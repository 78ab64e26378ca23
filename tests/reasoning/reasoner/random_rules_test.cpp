// Random rules over random facts, compared with a naive forward chainer.
#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/functional/read.hpp"

namespace geminga::reasoner {
namespace {

constexpr int individuals = 4;
constexpr int values = 4;
constexpr int variables = 3;

enum class Form : std::uint8_t { of_class, of_objects, of_data, less };
/// Classes A0 .. A2, object properties p0 .. p1, one data property d; `first` and `second` are variables or, in facts,
/// individuals and values. `less` compares the value variables.
struct Atom {
  Form form = Form::of_class;
  int predicate = 0;
  int first = 0;
  int second = 0;
  friend auto operator<=>(const Atom&, const Atom&) = default;
};
struct Rule {
  std::vector<Atom> body;
  Atom head;
};

class Chainer {
 public:
  std::set<Atom> run(std::set<Atom> facts, const std::vector<Rule>& rules) {
    facts_ = std::move(facts);
    for (std::size_t before = 0; before != facts_.size();) {
      before = facts_.size();
      for (const Rule& rule : rules) try_all(rule);
    }
    return facts_;
  }

 private:
  static int power(int base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }

  void try_all(const Rule& rule) {
    for (int objects = 0; objects < power(individuals, variables); ++objects) {
      for (int numbers = 0; numbers < power(values, variables); ++numbers) {
        std::array<int, variables> object{};
        std::array<int, variables> number{};
        for (int at = 0; at < variables; ++at) {
          object[static_cast<std::size_t>(at)] = objects / power(individuals, at) % individuals;
          number[static_cast<std::size_t>(at)] = numbers / power(values, at) % values;
        }
        const auto instance = [&](Atom atom) {
          const auto first = static_cast<std::size_t>(atom.first);
          const auto second = static_cast<std::size_t>(atom.second);
          const bool is_of_values = atom.form == Form::less;
          atom.first = is_of_values ? number[first] : object[first];
          if (atom.form != Form::of_class)
            atom.second = atom.form == Form::of_objects ? object[second] : number[second];
          return atom;
        };
        bool holds = true;
        for (const Atom& atom : rule.body) {
          const Atom ground = instance(atom);
          holds = holds && (ground.form == Form::less ? ground.first < ground.second : facts_.contains(ground));
        }
        if (holds) facts_.insert(instance(rule.head));
      }
    }
  }

  std::set<Atom> facts_;
};

class Author {
 public:
  explicit Author(std::uint64_t seed) : random_(seed) {}

  std::set<Atom> facts() {
    std::set<Atom> facts;
    for (int at = 0; at < 6; ++at) facts.insert(atom(individuals));
    return facts;
  }
  std::vector<Rule> rules() {
    std::vector<Rule> rules;
    while (rules.size() < 4) {
      Rule rule;
      for (int at = below(3); at >= 0; --at) rule.body.push_back(atom(variables));
      std::set<int> bound_values;
      std::set<int> bound;
      for (const Atom& one : rule.body) {
        bound.insert(one.first);
        if (one.form == Form::of_objects) bound.insert(one.second);
        if (one.form == Form::of_data) bound_values.insert(one.second);
      }
      if (bound_values.size() > 1) rule.body.push_back({Form::less, 0, *bound_values.begin(), *bound_values.rbegin()});
      rule.head = atom(variables);
      const bool is_safe = bound.contains(rule.head.first) &&
                           (rule.head.form != Form::of_objects || bound.contains(rule.head.second)) &&
                           (rule.head.form != Form::of_data || bound_values.contains(rule.head.second));
      if (is_safe) rules.push_back(rule);
    }
    return rules;
  }

 private:
  int below(int end) { return static_cast<int>(random_.below(static_cast<std::uint64_t>(end))); }
  Atom atom(int objects) {
    switch (below(3)) {
      case 0:
        return {Form::of_class, below(3), below(objects), 0};
      case 1:
        return {Form::of_objects, below(2), below(objects), below(objects)};
      default:
        return {Form::of_data, 0, below(objects), below(objects == variables ? variables : values)};
    }
  }
  base::Random random_;
};

std::string written(const Atom& fact) {
  const std::string first = ":i" + std::to_string(fact.first);
  switch (fact.form) {
    case Form::of_class:
      return "ClassAssertion(:A" + std::to_string(fact.predicate) + ' ' + first + ")\n";
    case Form::of_objects:
      return "ObjectPropertyAssertion(:p" + std::to_string(fact.predicate) + ' ' + first + " :i" +
             std::to_string(fact.second) + ")\n";
    default:
      return "DataPropertyAssertion(:d " + first + " \"" + std::to_string(fact.second) + "\"^^xsd:integer)\n";
  }
}

std::string atom_of_rule(const Atom& atom) {
  const auto object = [](int at) { return " Variable(:x" + std::to_string(at) + ')'; };
  const auto value = [](int at) { return " Variable(:v" + std::to_string(at) + ')'; };
  switch (atom.form) {
    case Form::of_class:
      return "ClassAtom(:A" + std::to_string(atom.predicate) + object(atom.first) + ')';
    case Form::of_objects:
      return "ObjectPropertyAtom(:p" + std::to_string(atom.predicate) + object(atom.first) + object(atom.second) + ')';
    case Form::of_data:
      return "DataPropertyAtom(:d" + object(atom.first) + value(atom.second) + ')';
    default:
      return "BuiltInAtom(b:lessThan" + value(atom.first) + value(atom.second) + ')';
  }
}

std::string written(const Rule& rule) {
  std::string text = "DLSafeRule(Body(";
  for (const Atom& atom : rule.body) text += atom_of_rule(atom) + ' ';
  return text + ") Head(" + atom_of_rule(rule.head) + "))\n";
}

std::set<Atom> all_facts() {
  std::set<Atom> all;
  for (int first = 0; first < individuals; ++first) {
    for (int predicate = 0; predicate < 3; ++predicate) all.insert({Form::of_class, predicate, first, 0});
    for (int second = 0; second < individuals; ++second) {
      all.insert({Form::of_objects, 0, first, second});
      all.insert({Form::of_objects, 1, first, second});
    }
    for (int second = 0; second < values; ++second) all.insert({Form::of_data, 0, first, second});
  }
  return all;
}

TEST(RandomRules, ConcludeWhatAForwardChainerDoes) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Author author(seed);
    const std::set<Atom> facts = author.facts();
    const std::vector<Rule> rules = author.rules();
    std::string text =
        "Prefix(:=<http://e/>)Prefix(b:=<http://www.w3.org/2003/11/swrlb#>)Prefix(xsd:=<http://www.w3.org/2001/"
        "XMLSchema#>)Ontology(\n";
    for (const Rule& rule : rules) text += written(rule);
    for (const Atom& fact : facts) text += written(fact);
    owl::Ontology source;
    const owl::FileId file = source.add_file("a.ofn");
    const std::set<Atom> all = all_facts();
    std::string asked;
    for (const Atom& fact : all) asked += written(fact);
    ASSERT_TRUE(functional::read(text + asked + ')', file, source, {.wrong_axioms = 0})) << text;
    std::vector<std::uint32_t> premise(rules.size() + facts.size());
    std::iota(premise.begin(), premise.end(), 0U);
    std::vector<std::uint32_t> conclusion(all.size());
    std::iota(conclusion.begin(), conclusion.end(), static_cast<std::uint32_t>(premise.size()));
    const std::vector<Answer> answers = entails_each(source, premise, conclusion);
    const std::set<Atom> derived = Chainer().run(facts, rules);
    std::size_t at = 0;
    for (const Atom& fact : all) {
      EXPECT_EQ(answers[at].verdict, derived.contains(fact) ? Verdict::yes : Verdict::no)
          << "seed " << seed << ": " << written(fact) << text << answers[at].reason;
      ++at;
    }
  }
}

}  // namespace
}  // namespace geminga::reasoner
