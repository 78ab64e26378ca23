#include "reasoning/signature/score.hpp"

#include <algorithm>

#include "reasoning/signature/assignment.hpp"

namespace geminga::signature {
namespace {

/// The share of offered parameters that no required one is assigned to.
double surplus_share(std::size_t required, std::size_t offered) {
  return offered > required ? static_cast<double>(offered - required) / static_cast<double>(offered) : 0;
}

double sum_of(const std::vector<Pair>& pairs) {
  double sum = 0;
  for (const Pair& pair : pairs) sum += pair.value;
  return sum;
}

/// Every required output weighs the same; one that the service lacks counts 0.
double of_outputs(const std::vector<Pair>& pairs, std::size_t offered) {
  const double coverage = pairs.empty() ? 1 : sum_of(pairs) / static_cast<double>(pairs.size());
  return coverage * (1 - weight::surplus * surplus_share(pairs.size(), offered));
}

/// An input that the request lacks weighs less than one for which it has the wrong concept. A request without inputs
/// leaves them open, so that every input counts as given and right.
double of_inputs(const std::vector<Pair>& pairs, std::size_t given) {
  const std::size_t paired = std::min(pairs.size(), given);
  const double unsaid = given == 0 ? 1 : 0;
  const double all = static_cast<double>(paired) + weight::lone_input * static_cast<double>(pairs.size() - paired);
  const double coverage = pairs.empty() ? 1 : (unsaid + sum_of(pairs)) / (unsaid + all);
  return coverage * (1 - weight::lone_input * surplus_share(pairs.size(), given));
}

double softened(double value, double least) { return least + (1 - least) * value; }

}  // namespace

std::string_view to_string(Relation relation) {
  switch (relation) {
    case Relation::equivalent:
      return "equivalent";
    case Relation::narrower:
      return "narrower";
    case Relation::broader:
      return "broader";
    case Relation::related:
      return "related";
    case Relation::none:
      break;
  }
  return "none";
}

const Meaning& Scorer::meaning(Concept of) {
  const auto [found, is_new] = meanings_.try_emplace(static_cast<std::uint32_t>(of));
  if (is_new) found->second = hierarchy_.meaning(of);
  return found->second;
}

double Scorer::satisfaction(Concept required, Concept offered) {
  const Meaning& wanted = meaning(required);
  const Meaning& given = meaning(offered);
  if (wanted.node == given.node) return 1;
  const double shared = hierarchy_.shared_bits(wanted, given);
  // The square lowers the weight of ancestors at the top of a taxonomy, which most concepts share.
  const double met = wanted.bits > 0 ? shared / wanted.bits : 1;
  const double surplus = given.bits > 0 ? 1 - shared / given.bits : 0;
  return met * met * (1 - weight::surplus * surplus);
}

Relation Scorer::relation(Concept required, Concept offered) {
  const Meaning& wanted = meaning(required);
  const Meaning& given = meaning(offered);
  if (wanted.node == given.node) return Relation::equivalent;
  if (is_under(given, wanted)) return Relation::narrower;
  if (is_under(wanted, given)) return Relation::broader;
  return hierarchy_.shared_bits(wanted, given) > 0 ? Relation::related : Relation::none;
}

std::vector<Pair> Scorer::pairs(const std::vector<Concept>& required, const std::vector<Concept>& offered) {
  Worth worth(required.size(), offered.size());
  for (std::size_t row = 0; row < required.size(); ++row) {
    for (std::size_t column = 0; column < offered.size(); ++column)
      worth.at(row, column) = satisfaction(required[row], offered[column]);
  }
  const auto column_of = best_assignment(worth);
  std::vector<Pair> pairs(required.size());
  for (std::size_t row = 0; row < required.size(); ++row) {
    pairs[row].required = row;
    if (!column_of[row]) continue;
    pairs[row].offered = column_of[row];
    pairs[row].relation = relation(required[row], offered[*column_of[row]]);
    pairs[row].value = worth.at(row, *column_of[row]);
  }
  return pairs;
}

Score Scorer::score(const Signature& request, const Signature& service) {
  Score score;
  score.output_pairs = pairs(request.outputs, service.outputs);
  score.input_pairs = pairs(service.inputs, request.inputs);
  score.outputs = of_outputs(score.output_pairs, service.outputs.size());
  score.inputs = of_inputs(score.input_pairs, request.inputs.size());
  score.total = softened(score.outputs, weight::wrong_outputs) * softened(score.inputs, weight::wrong_inputs);
  return score;
}

}  // namespace geminga::signature
