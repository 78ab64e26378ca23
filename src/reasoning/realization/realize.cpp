// The types of all individuals: certain ones from one model, the rest by questions.
#include <algorithm>
#include <map>
#include <utility>

#include "base/sorted.hpp"
#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/realization/facts.hpp"
#include "reasoning/realization/memberships.hpp"
#include "reasoning/realization/realization.hpp"
#include "reasoning/realization/rows.hpp"
#include "reasoning/realization/told.hpp"
#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::realization {
namespace {

using clauses::ConceptId;
using clauses::IndividualId;
using clauses::number;
using hypertableau::FactModel;
using hypertableau::Verdict;
using taxonomy::ClassNumber;

/// The most facts that are asked about one by one, each by a model of its own.
constexpr std::size_t max_fact_questions = 1000;

class Realizing {
 public:
  Realizing(owl::Ontology& source, const taxonomy::Classification& classification, const Options& options)
      : source_(source), classification_(classification), options_(options), types_(classification) {}

  Realization run() {
    report("translating to clauses", 0);
    auto clauses = clauses::clausify(source_, std::nullopt, {}, {}, {.budget = options_.budget});
    if (!clauses) {
      Realization told = realize_told(source_, classification_, options_.with_facts ? options_.most_fact_octets : 0);
      told.gaps.push_back(clauses.error().text);
      return told;
    }
    set_ = std::move(*clauses);
    note_unused(source_, set_, gaps_);
    result_.is_consistency_open = !set_.unused.empty();
    const std::vector<IndividualId> named = named_individuals(source_, set_);
    const reasoner::NamedConcepts concepts(source_, classification_, set_);
    report("building a model", 0);
    OpenQuestions open;
    {
      FactModel model(source_, set_, limits_for(set_, options_));
      const hypertableau::Answer answer = model.build();
      if (answer.verdict == Verdict::no) {
        result_.is_consistent = false;
        return std::move(result_);
      }
      rows_ = find_rows(model.individuals(), named, concepts, types_);
      if (options_.with_facts) copy_facts(model);
      if (answer.verdict == Verdict::unknown) {
        gaps_.insert(answer.reason);
        result_.is_consistency_open = true;
        is_open_.assign(rows_.size(), true);
      } else {
        open = find_open(model, concepts);
      }
      if (open.is_empty()) write_facts(model.individuals(), {});
    }
    if (!open.is_empty()) ask(open);
    return finish();
  }

 private:
  void report(std::string_view phase, double done) const {
    if (options_.progress) options_.progress(phase, done);
  }

  /// Copies the certain facts, and the forms of literals that the source does not have.
  void copy_facts(FactModel& model) {
    certain_ = {model.individuals().certain_links(), model.certain_values()};
    std::erase_if(certain_.values, [&](const FactModel::Value& value) { return !copy_literal(model, value.literal); });
  }

  /// Copies the form of a literal that the source does not have. False if it has none.
  bool copy_literal(FactModel& model, owl::TermId literal) {
    if (!FactModel::is_made(literal) || made_.contains(literal)) return true;
    auto written = model.written(literal);
    if (written) made_.emplace(literal, std::move(*written));
    if (!written) gaps_.insert("a value that a rule or a range has made has no written form here");
    return written.has_value();
  }

  /// Finds what the model leaves open. Adds the concepts that questions need to the clauses.
  OpenQuestions find_open(FactModel& model, const reasoner::NamedConcepts& concepts) {
    OpenQuestions open;
    for (const auto& [first, second] : possible_pairs(rows_)) open.pairs.push_back({first, second});
    std::map<ClassNumber, std::vector<IndividualId>> candidates;
    for (const Row& row : rows_) {
      if (row.possible == row.known) continue;
      for (const ClassNumber of : types_.set(row.possible)) {
        if (!std::ranges::binary_search(types_.set(row.known), of)) candidates[of].push_back(row.names.front());
      }
    }
    add_columns(std::move(candidates), concepts, open);
    if (options_.with_facts) add_links(model, open);
    sort_clauses(set_);
    return open;
  }

  /// The highest classes first, because what is in none of them is in no class below.
  void add_columns(std::map<ClassNumber, std::vector<IndividualId>> candidates, const reasoner::NamedConcepts& concepts,
                   OpenQuestions& open) {
    std::vector<std::pair<std::size_t, ClassNumber>> order;
    for (const auto& [of, individuals] : candidates) order.emplace_back(types_.set(types_.number_of({of})).size(), of);
    std::ranges::sort(order);
    std::map<ClassNumber, std::size_t> column_of;
    for (const auto& [depth, of] : order) {
      const auto id = concept_of(of, concepts);
      if (!id) continue;  // no clause mentions it, so no label has it
      Column& column = open.columns.emplace_back();
      column.of = *id;
      column.complement = add_complement(set_, *id);
      column.open = std::move(candidates[of]);
      std::ranges::sort(column.open);
      for (const ClassNumber above : types_.set(types_.number_of({of}))) {
        if (const auto found = column_of.find(above); found != column_of.end()) column.above.push_back(found->second);
      }
      column_of.emplace(of, open.columns.size() - 1);
      classes_.push_back(of);
    }
  }

  /// The concept of a class, or of one that is equivalent to it.
  [[nodiscard]] std::optional<ConceptId> concept_of(ClassNumber of, const reasoner::NamedConcepts& concepts) const {
    if (const auto found = concepts.concept_of(static_cast<std::uint32_t>(of))) return found;
    for (std::uint32_t other = 0; other < classification_.class_count(); ++other) {
      if (classification_.representative[other] != of) continue;
      if (const auto found = concepts.concept_of(other)) return found;
    }
    return std::nullopt;
  }

  void add_links(FactModel& model, OpenQuestions& open) {
    std::map<clauses::PropertyId, std::pair<ConceptId, ConceptId>> unlinked;
    for (const UncertainLink& link : uncertain_links(model.individuals(), rows_)) {
      const auto [place, is_new] = unlinked.try_emplace(link.property);
      if (is_new) place->second = add_unlinked(set_, link.property);
      open.links.push_back({link.property, link.first, link.second, place->second.first, place->second.second});
    }
    open_facts_ = uncertain_values(model, set_, rows_);
    for (const UncertainFact& fact : open_facts_) copy_literal(model, fact.literal);
    const auto paths = uncertain_paths(model.individuals(), LinkNames(source_, set_), rows_, options_.budget, gaps_);
    open_facts_.insert(open_facts_.end(), paths.begin(), paths.end());
  }

  /// Asks about facts that no link of the model is the reason for, one by one.
  void ask_facts() {
    std::size_t questions = 0;
    std::size_t undecided = 0;
    for (const UncertainFact& fact : open_facts_) {
      if (result_.has_too_many_facts) return;
      const owl::TermId subject = set_.individuals[number(fact.subject)];
      const owl::TermId object = fact.object ? set_.individuals[number(*fact.object)] : fact.literal;
      if (std::ranges::binary_search(result_.facts, Fact{subject, fact.property, object})) continue;
      const bool may_ask =
          ++questions <= max_fact_questions && (options_.budget == nullptr || !options_.budget->is_spent());
      const owl::TermId value = source_.term(
          fact.object ? owl::TermKind::object_has_value : owl::TermKind::data_has_value, {fact.property, object});
      const owl::TermId one = source_.term(owl::TermKind::object_one_of, {subject});
      const Verdict verdict =
          may_ask ? reasoner::entails(source_, std::nullopt, one, value, options_.budget).verdict : Verdict::unknown;
      if (verdict == Verdict::unknown) ++undecided;
      if (verdict == Verdict::yes) add_fact(fact, object);
    }
    if (undecided > 0) gaps_.insert(std::to_string(undecided) + " facts of chains or values were not decided");
  }

  /// Adds a fact for all names of its individuals.
  void add_fact(const UncertainFact& fact, owl::TermId literal) {
    const auto row_of = [&](IndividualId name) {
      return std::ranges::find_if(
          rows_, [&](const Row& row) { return std::ranges::find(row.names, name) != row.names.end(); });
    };
    const Row& subject = *row_of(fact.subject);
    FactList facts(source_, options_.most_fact_octets, std::move(result_.facts));
    for (const IndividualId first : subject.names) {
      const owl::TermId term = set_.individuals[number(first)];
      if (!fact.object) facts.add({term, fact.property, literal});
      if (!fact.object) continue;
      for (const IndividualId second : row_of(*fact.object)->names)
        facts.add({term, fact.property, set_.individuals[number(second)]});
    }
    take(facts);
  }

  void ask(OpenQuestions& open) {
    FactModel model(source_, set_, limits_for(set_, options_));
    const hypertableau::Answer answer = model.build();
    if (answer.verdict == Verdict::yes) {
      decide(model, open, options_, gaps_);
    } else {
      gaps_.insert(answer.reason.empty() ? "there is not enough time for questions about individuals" : answer.reason);
    }
    std::vector<std::pair<IndividualId, IndividualId>> same;
    std::vector<IndividualId> undecided;
    for (const Pair& pair : open.pairs) {
      if (pair.are_same == Verdict::yes) same.emplace_back(pair.first, pair.second);
      if (pair.are_same == Verdict::unknown) undecided.insert(undecided.end(), {pair.first, pair.second});
    }
    std::map<IndividualId, Classes> found;
    for (std::size_t at = 0; at < open.columns.size(); ++at) {
      for (const IndividualId individual : open.columns[at].found) found[individual].push_back(classes_[at]);
      undecided.insert(undecided.end(), open.columns[at].open.begin(), open.columns[at].open.end());
    }
    for (Row& row : rows_) {
      const auto more = found.find(row.names.front());
      if (more == found.end()) continue;
      Classes known = types_.set(row.known);
      known.insert(known.end(), more->second.begin(), more->second.end());
      row.known = types_.number_of(std::move(known));
    }
    base::sort_unique(undecided);
    add_found_links(open);
    write_facts(model.individuals(), same);
    unite(rows_, same, types_);
    is_open_.clear();
    for (const Row& row : rows_) {
      is_open_.push_back(std::ranges::any_of(
          row.names, [&](IndividualId name) { return std::ranges::binary_search(undecided, name); }));
    }
  }

  void add_found_links(const OpenQuestions& open) {
    std::map<IndividualId, hypertableau::NodeId> node_of;
    if (!open.links.empty()) {
      for (const Row& row : rows_) node_of.emplace(row.names.front(), row.certain);
    }
    std::size_t undecided = 0;
    for (const OpenLink& link : open.links) {
      if (link.holds == Verdict::yes)
        certain_.links.push_back({link.property, node_of.at(link.first), node_of.at(link.second)});
      if (link.holds == Verdict::unknown) ++undecided;
    }
    if (undecided > 0) gaps_.insert(std::to_string(undecided) + " facts about individuals were not decided");
  }

  /// Facts are found for the rows of the model. Names that are the same share them.
  void write_facts(const hypertableau::Individuals& individuals,
                   const std::vector<std::pair<IndividualId, IndividualId>>& same) {
    if (!options_.with_facts) return;
    report("collecting facts", 0);
    std::vector<Row> rows = rows_;
    if (!same.empty()) {
      // A row of several nodes takes the facts of all of them.
      std::map<IndividualId, hypertableau::NodeId> node_of;
      for (const Row& row : rows_) node_of.emplace(row.names.front(), row.certain);
      unite(rows, same, types_);
      std::map<hypertableau::NodeId, hypertableau::NodeId> moved;
      for (const Row& row : rows) {
        for (const IndividualId name : row.names) {
          if (const auto found = node_of.find(name); found != node_of.end()) moved[found->second] = row.certain;
        }
      }
      const auto move = [&](hypertableau::NodeId& node) {
        if (const auto found = moved.find(node); found != moved.end()) node = found->second;
      };
      for (auto& link : certain_.links) {
        move(link.first);
        move(link.second);
      }
      for (auto& value : certain_.values) move(value.subject);
    }
    FactList facts(source_, options_.most_fact_octets);
    FactNames(source_, set_, rows).write(individuals, certain_, options_.budget, facts, gaps_);
    take(facts);
  }

  void take(FactList& facts) {
    result_.facts = facts.take();
    result_.has_too_many_facts = facts.is_full();
  }

  /// Adds the literals that were made, when no model of the source is left.
  void add_made_literals() {
    std::map<owl::TermId, owl::TermId> added;
    for (const auto& [literal, written] : made_)
      added.emplace(literal, source_.literal(written.lexical, written.datatype, written.language));
    for (Fact& fact : result_.facts) {
      if (const auto found = added.find(fact.object); found != added.end()) fact.object = found->second;
    }
    for (UncertainFact& fact : open_facts_) {
      if (const auto found = added.find(fact.literal); found != added.end()) fact.literal = found->second;
    }
    std::erase_if(open_facts_, [](const UncertainFact& fact) { return FactModel::is_made(fact.literal); });
    if (!added.empty()) base::sort_unique(result_.facts);
  }

  Realization finish() {
    add_made_literals();
    ask_facts();
    struct Entry {
      std::string_view iri;
      owl::TermId term;
      std::size_t row;
    };
    std::vector<Entry> entries;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (const IndividualId name : rows_[row].names) {
        const owl::TermId term = set_.individuals[number(name)];
        entries.push_back({source_.name_of(term), term, row});
      }
    }
    std::ranges::sort(entries, {}, &Entry::iri);
    std::vector<std::optional<std::uint32_t>> first(rows_.size());
    for (std::uint32_t at = 0; at < entries.size(); ++at) {
      const Entry& entry = entries[at];
      if (!first[entry.row]) first[entry.row] = at;
      result_.individuals.push_back(entry.term);
      result_.representative.push_back(*first[entry.row]);
      result_.types.push_back(rows_[entry.row].known);
      if (!is_open_.empty() && is_open_[entry.row]) result_.undecided.push_back(at);
    }
    result_.type_sets = types_.take();
    result_.gaps.assign(gaps_.begin(), gaps_.end());
    return std::move(result_);
  }

  owl::Ontology& source_;
  const taxonomy::Classification& classification_;
  const Options& options_;
  clauses::ClauseSet set_;
  TypeSets types_;
  std::vector<Row> rows_;
  std::vector<bool> is_open_;         ///< by row
  std::vector<ClassNumber> classes_;  ///< by column
  CertainFacts certain_;
  std::map<owl::TermId, hypertableau::WrittenValue> made_;  ///< literals that the source does not have
  std::vector<UncertainFact> open_facts_;                   ///< to be asked one by one
  Gaps gaps_;
  Realization result_;
};

}  // namespace

Realization realize(owl::Ontology& source, const taxonomy::Classification& classification, const Options& options) {
  if (!classification.is_consistent) {
    Realization none;
    none.is_consistent = false;
    return none;
  }
  return Realizing(source, classification, options).run();
}

}  // namespace geminga::realization
