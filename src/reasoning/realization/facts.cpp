#include "reasoning/realization/facts.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "base/sorted.hpp"

namespace geminga::realization {

using clauses::number;
using hypertableau::FactModel;
using hypertableau::Individuals;
using hypertableau::NodeId;

namespace {

/// Repeats are kept up to so many times the limit, because a fact in this list takes few of the octets that it is
/// counted with.
constexpr std::size_t repeats = 4;

}  // namespace

std::size_t FactList::octets_of(const Fact& fact) const {
  const auto text = [&](owl::TermId id) {
    return hypertableau::FactModel::is_made(id) ? 0 : source_.name_of(id).size();
  };
  return fact_octets + text(fact.subject) + text(fact.property) + text(fact.object);
}

void FactList::drop_repeats() {
  base::sort_unique(facts_);
  added_octets_ = 0;
  std::size_t octets = 0;
  for (const Fact& fact : facts_) {
    octets += octets_of(fact);
    if (octets <= most_octets_) continue;
    is_full_ = true;
    facts_ = {};
    return;
  }
}

void FactList::add(const Fact& fact) {
  if (is_full_) return;
  facts_.push_back(fact);
  added_octets_ += octets_of(fact);
  if (added_octets_ / repeats > most_octets_) drop_repeats();
}

std::vector<Fact> FactList::take() {
  if (!is_full_) drop_repeats();
  return std::move(facts_);
}

FactNames::FactNames(const owl::Ontology& source, const clauses::ClauseSet& set, const std::vector<Row>& rows)
    : source_(source), set_(set), links_(source, set) {
  for (const Row& row : rows) rows_.emplace(row.certain, &row);
}

const Row* FactNames::row_of(NodeId node) const {
  const auto found = rows_.find(node);
  return found == rows_.end() ? nullptr : found->second;
}

void FactNames::write(const Individuals& individuals, const CertainFacts& certain, base::Budget* budget,
                      FactList& facts, Gaps& gaps) const {
  const auto term = [&](clauses::IndividualId name) { return set_.individuals[number(name)]; };
  const UseLink use = [&](owl::TermId property, NodeId from, NodeId to) {
    const Row* const subject = row_of(from);
    const Row* const object = row_of(to);
    if (subject == nullptr || object == nullptr) return;
    for (const clauses::IndividualId first : subject->names) {
      if (facts.is_full()) return;
      for (const clauses::IndividualId second : object->names) facts.add({term(first), property, term(second)});
    }
  };
  for (const Individuals::Link& link : certain.links) links_.name(link, use);
  const Paths paths = links_.follow(certain.links, individuals, budget, use);
  if (paths.is_cut_off) gaps.insert(budget->reason().value_or(""));
  if (paths.are_open) gaps.insert("chains of properties were not followed through everything without a name");
  for (const FactModel::Value& value : certain.values) {
    const Row* const subject = row_of(value.subject);
    if (subject == nullptr) continue;
    const owl::TermId property = set_.data_properties[number(value.property)];
    if (source_.name_of(property) == owl::owl_top_data_property) continue;
    for (const clauses::IndividualId name : subject->names) facts.add({term(name), property, value.literal});
  }
}

namespace {

/// The rows that each node of the model stands for.
std::unordered_map<NodeId, std::vector<const Row*>> rows_by_node(const std::vector<Row>& rows) {
  std::unordered_map<NodeId, std::vector<const Row*>> found;
  for (const Row& row : rows) found[row.node].push_back(&row);
  return found;
}

}  // namespace

std::vector<UncertainLink> uncertain_links(const Individuals& individuals, const std::vector<Row>& rows) {
  std::set<std::tuple<clauses::PropertyId, NodeId, NodeId>> certain;
  for (const Individuals::Link& link : individuals.certain_links())
    certain.emplace(link.property, link.first, link.second);
  const auto rows_of = rows_by_node(rows);
  std::vector<UncertainLink> found;
  for (const Individuals::Link& link : individuals.links()) {
    const auto subjects = rows_of.find(link.first);
    const auto objects = rows_of.find(link.second);
    if (subjects == rows_of.end() || objects == rows_of.end()) continue;
    for (const Row* const subject : subjects->second) {
      for (const Row* const object : objects->second) {
        if (!certain.contains({link.property, subject->certain, object->certain}))
          found.push_back({link.property, subject->names.front(), object->names.front()});
      }
    }
  }
  return found;
}

std::vector<UncertainFact> uncertain_values(FactModel& model, const clauses::ClauseSet& set,
                                            const std::vector<Row>& rows) {
  std::set<std::tuple<clauses::DataPropertyId, NodeId, owl::TermId>> certain;
  for (const FactModel::Value& value : model.certain_values())
    certain.emplace(value.property, value.subject, value.literal);
  const auto rows_of = rows_by_node(rows);
  std::vector<UncertainFact> found;
  for (const FactModel::Value& value : model.values()) {
    const auto subjects = rows_of.find(value.subject);
    if (subjects == rows_of.end()) continue;
    for (const Row* const subject : subjects->second) {
      if (!certain.contains({value.property, subject->certain, value.literal}))
        found.push_back(
            {set.data_properties[number(value.property)], subject->names.front(), std::nullopt, value.literal});
    }
  }
  return found;
}

std::vector<UncertainFact> uncertain_paths(const Individuals& individuals, const LinkNames& links,
                                           const std::vector<Row>& rows, base::Budget* budget, Gaps& gaps) {
  std::vector<UncertainFact> found;
  if (!links.has_paths() || !individuals.has_uncertain_links()) return found;
  const auto rows_of = rows_by_node(rows);
  const Paths paths =
      links.follow(individuals.links(), individuals, budget, [&](owl::TermId property, NodeId from, NodeId to) {
        const auto subjects = rows_of.find(from);
        const auto objects = rows_of.find(to);
        if (subjects == rows_of.end() || objects == rows_of.end()) return;
        for (const Row* const subject : subjects->second) {
          for (const Row* const object : objects->second)
            found.push_back({property, subject->names.front(), object->names.front(), {}});
        }
      });
  if (paths.is_cut_off) gaps.insert(budget->reason().value_or(""));
  if (paths.are_open) gaps.insert("chains of properties were not followed through everything without a name");
  return found;
}

}  // namespace geminga::realization
