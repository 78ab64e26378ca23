#include "reasoning/realization/rows.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace geminga::realization {
namespace {

using clauses::ConceptId;
using clauses::IndividualId;
using hypertableau::NodeId;
using SamePairs = std::vector<std::pair<IndividualId, IndividualId>>;

Classes classes_of(const std::vector<ConceptId>& label, const reasoner::NamedConcepts& concepts) {
  Classes classes;
  for (const ConceptId id : label) {
    if (const auto named = concepts.class_of(id)) classes.push_back(taxonomy::ClassNumber{*named});
  }
  return classes;
}

}  // namespace

std::vector<Row> find_rows(const hypertableau::Individuals& individuals, const std::vector<IndividualId>& named,
                           const reasoner::NamedConcepts& concepts, TypeSets& types) {
  std::vector<Row> rows;
  std::unordered_map<NodeId, std::size_t> row_of;
  for (const IndividualId individual : named) {
    const NodeId certain = individuals.certain_node(individual);
    const auto [place, is_new] = row_of.try_emplace(certain, rows.size());
    if (is_new) {
      Row& row = rows.emplace_back();
      row.certain = certain;
      row.node = individuals.node(individual);
      row.known = types.number_of(classes_of(individuals.certain_label(certain), concepts));
      row.possible = types.number_of(classes_of(individuals.label(row.node), concepts));
    }
    rows[place->second].names.push_back(individual);
  }
  return rows;
}

void unite(std::vector<Row>& rows, const SamePairs& same, TypeSets& types) {
  if (same.empty()) return;
  std::unordered_map<IndividualId, std::size_t> row_of;
  for (std::size_t at = 0; at < rows.size(); ++at) {
    for (const IndividualId name : rows[at].names) row_of[name] = at;
  }
  std::vector<std::size_t> into(rows.size());
  std::iota(into.begin(), into.end(), std::size_t{0});
  const auto first_of = [&](std::size_t at) {
    while (into[at] != at) at = into[at];
    return at;
  };
  for (const auto& [one, other] : same) {
    const std::size_t first = first_of(row_of.at(one));
    const std::size_t second = first_of(row_of.at(other));
    into[std::max(first, second)] = std::min(first, second);
  }
  std::vector<Row> united;
  std::vector<std::size_t> place(rows.size());
  for (std::size_t at = 0; at < rows.size(); ++at) {
    const std::size_t first = first_of(at);
    if (first == at) {
      place[at] = united.size();
      united.push_back(std::move(rows[at]));
      continue;
    }
    Row& row = united[place[first]];
    row.names.insert(row.names.end(), rows[at].names.begin(), rows[at].names.end());
    Classes known = types.set(row.known);
    known.insert(known.end(), types.set(rows[at].known).begin(), types.set(rows[at].known).end());
    row.known = types.number_of(std::move(known));
  }
  rows = std::move(united);
}

SamePairs possible_pairs(const std::vector<Row>& rows) {
  std::unordered_map<NodeId, const Row*> first_with;
  SamePairs pairs;
  for (const Row& row : rows) {
    const auto [place, is_new] = first_with.try_emplace(row.node, &row);
    if (!is_new) pairs.emplace_back(place->second->names.front(), row.names.front());
  }
  return pairs;
}

}  // namespace geminga::realization
