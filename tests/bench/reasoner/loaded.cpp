#include "bench/reasoner/loaded.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "bench/table.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/explain.hpp"
#include "reasoning/placement/expression_classifier.hpp"

namespace geminga::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Pair = std::pair<taxonomy::ClassNumber, taxonomy::ClassNumber>;

constexpr std::size_t small_ontology = 20'000;
constexpr std::size_t asked_to_explain = 40;
constexpr std::size_t asked_expressions = 60;

double milliseconds_since(Clock::time_point began) {
  return std::chrono::duration<double, std::milli>(Clock::now() - began).count();
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

/// Makes pairs: half are random, half are a class and one above it, so that both answers occur.
std::vector<Pair> pairs_of(const compiled::Ontology& ontology, std::size_t count) {
  base::Random random(1);
  const auto any = [&] {
    return taxonomy::ClassNumber{static_cast<std::uint32_t>(random.below(ontology.class_count()))};
  };
  std::vector<Pair> pairs;
  while (pairs.size() < count) {
    const taxonomy::ClassNumber sub = any();
    const auto above = ontology.subsumers(sub);
    pairs.emplace_back(sub, any());
    pairs.emplace_back(sub, above[random.below(above.size())]);
  }
  return pairs;
}

void measure_subsumption(const compiled::Ontology& ontology, const std::string& name, const std::string& size,
                         std::size_t queries) {
  const std::vector<Pair> pairs = pairs_of(ontology, queries);
  std::vector<double> nanoseconds;
  std::size_t held = 0;
  for (int round = 0; round < 5; ++round) {
    const auto began = Clock::now();
    for (const auto& [sub, super] : pairs) held += ontology.is_subsumed(sub, super) ? 1U : 0U;
    nanoseconds.push_back(milliseconds_since(began) * 1e6 / static_cast<double>(pairs.size()));
  }
  const bool is_small = ontology.class_count() <= small_ontology;
  // The sum is shown, so that no compiler leaves the loop out: more than half of the pairs hold.
  row(name + ": is A under B (" + std::to_string(held * 100 / (5 * pairs.size())) + " % yes)", size,
      quantile(nanoseconds, 0.5), "ns", {.limit = is_small ? 10.0 : 25.0});
}

void measure_explanations(const compiled::Ontology& ontology, const std::string& name, const std::string& size) {
  std::vector<double> times;
  for (const auto& [sub, super] : pairs_of(ontology, asked_to_explain * 20)) {
    if (times.size() == asked_to_explain) break;
    if (sub == super || !ontology.is_subsumed(sub, super) || !ontology.is_satisfiable(sub)) continue;
    const auto began = Clock::now();
    const auto steps = explanation::explain(ontology, sub, super);
    if (!steps) return row_without(name + ": an explanation", size, "a subsumption without an explanation");
    if (steps->empty()) continue;
    times.push_back(milliseconds_since(began));
  }
  if (times.empty()) return row_without(name + ": an explanation", size, "nothing is there to explain");
  row(name + ": an explanation, median", size, quantile(times, 0.5), "ms", {.limit = 10});
  row(name + ": an explanation, worst", size, quantile(times, 1), "ms");
}

/// Asks for a number of expressions and prints the times of the median and of the slowest.
void measure_asking(const placement::ExpressionClassifier& classifier, const std::string& what, const std::string& size,
                    const std::function<owl::TermId(owl::Ontology&)>& make) {
  std::vector<double> times;
  for (std::size_t asked = 0; asked < asked_expressions; ++asked) {
    owl::Ontology query;
    const owl::TermId asks = make(query);
    const auto start = Clock::now();
    (void)classifier.classify(query, asks);
    times.push_back(milliseconds_since(start));
  }
  row(what + ", median", size, quantile(times, 0.5), "ms", {.limit = 1});
  row(what + ", worst", size, quantile(times, 1), "ms");
}

/// `A and (p some B)` and `A and not B` over random classes and properties.
void measure_expressions(const compiled::Ontology& ontology, const std::string& name, const std::string& size) {
  const auto began = Clock::now();
  const auto classifier = placement::ExpressionClassifier::build(ontology);
  if (!classifier) return row_without(name + ": a class expression", size, classifier.error().text);
  row(name + ": ready for class expressions", size, milliseconds_since(began), "ms");
  base::Random random(2);
  const auto any = [&](owl::Ontology& query) {
    return query.named_class(
        ontology.iri(taxonomy::ClassNumber{static_cast<std::uint32_t>(random.below(ontology.class_count()))}));
  };
  std::vector<std::string_view> properties;
  const taxonomy::ClassifiedView& view = ontology.axioms();
  for (std::uint32_t term = 0; term < view.term_count(); ++term) {
    if (view.kind_of_term(term) == owl::TermKind::object_property) properties.push_back(view.name_of_term(term));
  }
  if (properties.empty()) return row_without(name + ": a class expression", size, "there are no properties");
  measure_asking(*classifier, name + ": a class expression", size, [&](owl::Ontology& query) {
    const owl::TermId property = query.object_property(properties[random.below(properties.size())]);
    const owl::TermId filler = query.term(owl::TermKind::object_some_values_from, {property, any(query)});
    return query.term(owl::TermKind::object_intersection_of, {any(query), filler});
  });
  measure_asking(*classifier, name + ": one with a complement", size, [&](owl::Ontology& query) {
    const owl::TermId complement = query.term(owl::TermKind::object_complement_of, {any(query)});
    return query.term(owl::TermKind::object_intersection_of, {any(query), complement});
  });
}

}  // namespace

void measure_loaded(const std::filesystem::path& compiled, const std::string& name, const std::string& size,
                    std::size_t queries) {
  std::vector<double> times;
  for (int round = 0; round < 5; ++round) {
    const auto began = Clock::now();
    const auto ontology = compiled::Ontology::map(compiled);
    if (!ontology) return row_without(name + ": mapped until the first answer", size, ontology.error().text);
    if (!ontology->is_subsumed(taxonomy::ClassNumber{0}, *ontology->find_iri(owl::owl_thing)))
      return row_without(name + ": mapped until the first answer", size, "a wrong answer");
    times.push_back(milliseconds_since(began));
  }
  row(name + ": mapped until the first answer", size, quantile(times, 0.5), "ms", {.limit = 40});
  const auto ontology = compiled::Ontology::map(compiled);
  row(name + ": compiled file, a class", size,
      static_cast<double>(std::filesystem::file_size(compiled)) / ontology->class_count(), "B");
  const taxonomy::ClassifiedView& view = ontology->view();
  const std::size_t index_bytes = view.reach.size_bytes() + view.further.size_bytes();
  row(name + ": subsumption index, a class", size, static_cast<double>(index_bytes) / ontology->class_count(), "B",
      {.limit = 32});
  measure_subsumption(*ontology, name, size, queries);
  measure_explanations(*ontology, name, size);
  measure_expressions(*ontology, name, size);
}

}  // namespace geminga::bench
