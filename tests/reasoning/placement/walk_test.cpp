// A random walk of additions and removals of axioms and class expressions; each step is compared with a fresh start.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/random.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/placement/expression_classifier.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::placement {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

void shuffle(std::vector<std::string>& lines, base::Random& random) {
  for (std::size_t at = lines.size(); at > 1; --at) std::swap(lines[at - 1], lines[random.below(at)]);
}

std::string expression(base::Random& random, std::uint64_t classes, int depth) {
  const std::string role = "r" + std::to_string(random.below(4));
  if (depth == 0 || random.chance(0.3)) return "C" + std::to_string(random.below(classes));
  if (random.chance(0.5)) return "ObjectSomeValuesFrom(" + role + " " + expression(random, classes, depth - 1) + ")";
  return "ObjectIntersectionOf(" + expression(random, classes, depth - 1) + " " +
         expression(random, classes, depth - 1) + ")";
}

/// The axioms and expressions that the walk changes.
class Live {
 public:
  explicit Live(std::string names) : names_(std::move(names)) { owl::write_into(source_, names_, "names"); }

  void add(const std::string& axiom) {
    axioms_.push_back(axiom);
    owl::write_into(source_, axiom, "step");
  }
  /// Copies the remaining axioms into a new source, term by term.
  void remove(std::size_t at) {
    owl::Ontology rest;
    rest.add_prefix("t", "https://t.example/#");
    const owl::FileId file = rest.add_file("rest");
    const std::size_t names = lines_of(names_).size();
    for (std::size_t number = 0; number < source_.axiom_count(); ++number) {
      if (number == names + at) continue;
      const owl::Axiom axiom = source_.axiom(number);
      std::vector<owl::TermId> arguments;
      for (const owl::TermId argument : axiom.arguments) arguments.push_back(rest.copy(source_, argument));
      rest.add(axiom.kind, arguments, file, axiom.line);
    }
    source_ = std::move(rest);
    axioms_.erase(axioms_.begin() + static_cast<std::ptrdiff_t>(at));
  }
  [[nodiscard]] const owl::Ontology& source() const { return source_; }
  [[nodiscard]] std::size_t size() const { return axioms_.size(); }
  /// Every line, in another order.
  [[nodiscard]] std::string from_scratch(base::Random& random) const {
    std::vector<std::string> lines = axioms_;
    for (const std::string& name : lines_of(names_)) lines.push_back(name);
    shuffle(lines, random);
    return joined(lines);
  }

 private:
  std::string names_;
  std::vector<std::string> axioms_;
  owl::Ontology source_;
};

std::set<std::string> place_by_overlay(const compiled::Ontology& ontology, const ExpressionClassifier& classifier,
                                       const std::string& expression) {
  const owl::Ontology query = owl::written("SubClassOf(TheExpression " + expression + ")");
  const ExpressionPlace place = classifier.classify(query, query.axiom(0).arguments[1]);
  if (!place.is_satisfiable) return {"nothing"};
  std::set<std::string> found;
  for (std::uint32_t other = 0; other < ontology.class_count(); ++other) {
    const std::string iri(ontology.iri(taxonomy::ClassNumber{other}));
    if (is_below(place, taxonomy::ClassNumber{other}, ontology)) found.insert("above " + iri);
    if (is_above(place, taxonomy::ClassNumber{other}, ontology)) found.insert("below " + iri);
  }
  return found;
}

std::set<std::string> place_from_scratch(const std::string& text, const std::string& expression) {
  const compiled::Ontology ontology = owl::loaded(text + "EquivalentClasses(TheExpression " + expression + ")\n");
  const taxonomy::ClassNumber own = owl::named(ontology, "TheExpression");
  if (!ontology.is_satisfiable(own)) return {"nothing"};
  std::set<std::string> found;
  for (std::uint32_t other = 0; other < ontology.class_count(); ++other) {
    if (taxonomy::ClassNumber{other} == own) continue;
    const std::string iri(ontology.iri(taxonomy::ClassNumber{other}));
    if (ontology.is_subsumed(own, taxonomy::ClassNumber{other})) found.insert("above " + iri);
    if (ontology.is_subsumed(taxonomy::ClassNumber{other}, own)) found.insert("below " + iri);
  }
  return found;
}

TEST(Walk, OfAxiomsAndExpressionsIsWhereFromScratchIs) {
  constexpr std::uint64_t classes = 12;
  int complete = 0;
  int compared_places = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(12U); ++seed) {
    base::Random random(seed);
    std::string names;
    for (std::uint64_t at = 0; at < classes; ++at) names += "Declaration(C" + std::to_string(at) + ")\n";
    for (int role = 0; role < 4; ++role)
      names += "SubObjectPropertyOf(r" + std::to_string(role) + " r" + std::to_string(role) + ")\n";
    std::vector<std::string> pool = lines_of(owl::random_ontology(random, 18));  // whose names are C0 to C11
    Live live(names);
    std::set<std::string> expressions;
    for (int step = 0; step < 24; ++step) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      if (random.chance(0.3)) {
        expressions.insert(expression(random, classes, 2));
        if (expressions.size() > 3) expressions.erase(expressions.begin());
      } else if (live.size() != 0 && random.chance(0.35)) {
        live.remove(random.below(live.size()));
      } else {
        live.add(pool[random.below(pool.size())]);
      }
      const std::string scratch = live.from_scratch(random);
      SCOPED_TRACE(scratch);
      const taxonomy::Classification classification =
          *el::classify(live.source(), {.threads = 1 + static_cast<unsigned>(step % 3)});
      const compiled::Ontology ontology = owl::loaded(live.source());
      ASSERT_EQ(owl::closure(ontology), owl::closure(scratch));
      if (!classification.unused.empty()) continue;
      ++complete;
      ASSERT_EQ(owl::closure(ontology), owl::reference_closure(owl::written(scratch)));
      const auto classifier = ExpressionClassifier::build(ontology);
      if (!classifier) continue;
      for (const std::string& one : expressions) {
        ++compared_places;
        ASSERT_EQ(place_by_overlay(ontology, *classifier, one), place_from_scratch(scratch, one)) << one;
      }
    }
  }
  EXPECT_GT(complete, test::rounds(60));
  EXPECT_GT(compared_places, test::rounds(60));
}

/// The same axioms in the same order, all on one line, because line numbers are part of the bytes.
owl::Ontology without_lines(const owl::Ontology& source) {
  owl::Ontology copy;
  const owl::FileId file = copy.add_file("f");
  for (std::size_t number = 0; number < source.axiom_count(); ++number) {
    const owl::Axiom axiom = source.axiom(number);
    std::vector<owl::TermId> arguments;
    for (const owl::TermId argument : axiom.arguments) arguments.push_back(copy.copy(source, argument));
    copy.add(axiom.kind, arguments, file, 1);
  }
  return copy;
}

TEST(Order, OfAxiomsAndNumberOfThreadsLeaveTheBytesAsTheyAre) {
  for (std::uint64_t seed = 1; seed <= test::rounds(40U); ++seed) {
    base::Random random(seed);
    std::vector<std::string> lines = lines_of(owl::random_ontology(random, 10 + random.below(60)));
    if (random.chance(0.3)) lines.emplace_back("FunctionalObjectProperty(r0)");
    if (random.chance(0.3)) lines.emplace_back("SubClassOf(C0 ObjectHasValue(r1 i:a))");
    const auto bytes_of = [&](unsigned threads) {
      const owl::Ontology source = without_lines(owl::written(joined(lines)));
      return compiled::compile(source, *el::classify(source, {.threads = threads}));
    };
    const auto first = bytes_of(1);
    for (const unsigned threads : {1U, 2U, 3U}) {
      shuffle(lines, random);
      ASSERT_EQ(first, bytes_of(threads)) << "seed " << seed << ", " << threads << " threads\n" << joined(lines);
    }
  }
}

}  // namespace
}  // namespace geminga::placement
