// Questions to the search about the facts.
#include "reasoning/dl/hypertableau/fact_model.hpp"

#include <utility>

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {

FactModel::FactModel(const owl::Ontology& source, const clauses::ClauseSet& clauses, const QuestionLimits& limits)
    : search_(std::make_unique<Search>(source, clauses, limits, true)) {}

FactModel::~FactModel() = default;

Individuals FactModel::individuals() const { return search_->individuals(); }

std::vector<FactModel::Value> FactModel::values(bool are_certain) {
  std::vector<Value> found;
  for (const Individuals::Value& fact : individuals().values(are_certain)) {
    const auto literal = search_->known_value(fact.value, are_certain);
    if (literal) found.push_back({fact.property, fact.subject, *literal});
  }
  return found;
}

bool FactModel::is_made(owl::TermId literal) { return static_cast<std::uint32_t>(literal) >= first_made_value; }

std::optional<WrittenValue> FactModel::written(owl::TermId literal) {
  if (!is_made(literal)) return std::nullopt;
  const auto& value = search_->value_of(literal);
  return value ? hypertableau::written(*value) : std::nullopt;
}

Answer FactModel::build() {
  switch (rebuild(true)) {
    case Outcome::model:
      return {Verdict::yes, {}};
    case Outcome::no_model:
      return {Verdict::no, {}};
    case Outcome::unknown:
      break;
  }
  return {Verdict::unknown, search_->reason()};
}

Outcome FactModel::rebuild(bool is_first) {
  if (is_first) search_->reset();
  const Outcome outcome = is_first ? search_->find_world() : search_->find_world_again();
  if (outcome == Outcome::model) search_->keep();
  is_pure_ = true;
  return outcome;
}

void FactModel::end_question() {
  if (!last_) return;
  const bool was_lost = !search_->has_base();
  search_->end_supposing(*last_);
  if (was_lost) is_pure_ = false;
  last_.reset();
}

Outcome FactModel::ask(const Supposition& supposed) {
  end_question();
  if (!search_->has_base()) {
    if (const Outcome outcome = rebuild(false); outcome != Outcome::model) return Outcome::unknown;
  }
  const Outcome outcome = search_->find_supposing(supposed);
  last_ = outcome;
  return outcome;
}

Answer FactModel::is_possible(const Supposition& supposed) {
  end_question();
  const bool was_pure = is_pure_ || !search_->has_base();
  Outcome outcome = ask(supposed);
  // The supposition of an earlier question may be to blame.
  if (outcome == Outcome::no_model && !was_pure) {
    end_question();
    outcome = rebuild(false);
    if (outcome == Outcome::model) outcome = ask(supposed);
  }
  switch (outcome) {
    case Outcome::model:
      return {Verdict::yes, {}};
    case Outcome::no_model:
      return {Verdict::no, {}};
    case Outcome::unknown:
      break;
  }
  return {Verdict::unknown, search_->reason()};
}

}  // namespace geminga::hypertableau
