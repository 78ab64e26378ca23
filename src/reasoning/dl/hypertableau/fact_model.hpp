// A model of the facts, and questions that suppose more of their individuals.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACT_MODEL_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACT_MODEL_HPP

#include <memory>
#include <optional>
#include <vector>

#include "reasoning/dl/hypertableau/individuals.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/dl/hypertableau/values/written_value.hpp"

namespace geminga::hypertableau {

enum class Outcome : std::uint8_t;

/// Builds one model of an ontology with its facts. Each question changes as little of it as it must. Asks about one
/// ClauseSet, which must outlive it. Not thread-safe.
class FactModel {
 public:
  FactModel(const owl::Ontology& source, const clauses::ClauseSet& clauses, const QuestionLimits& limits);
  FactModel(const FactModel&) = delete;
  FactModel& operator=(const FactModel&) = delete;
  ~FactModel();

  /// Whether the ontology has a model; to be called once, first. Whatever the answer but no, what individuals() calls
  /// certain follows.
  [[nodiscard]] Answer build();
  /// Whether the ontology has a model in which this holds, too. Requires that build() said yes. Then individuals()
  /// tells of that model until the next question; only after build() does it tell what is certain.
  [[nodiscard]] Answer is_possible(const Supposition& supposed);
  [[nodiscard]] Individuals individuals() const;

  /// A fact about a value. The literal may be one that no ontology has: written() has its form.
  struct Value {
    clauses::DataPropertyId property{};
    NodeId subject = 0;
    owl::TermId literal{};
  };
  /// The facts about known values that hold in every model, or all of this model: values of literals, and those that
  /// are the only ones of their ranges.
  [[nodiscard]] std::vector<Value> certain_values() { return values(true); }
  [[nodiscard]] std::vector<Value> values() { return values(false); }
  /// The form of a literal that a rule or a range has made; nothing if it is the source's, or has no form here.
  [[nodiscard]] std::optional<WrittenValue> written(owl::TermId literal);
  [[nodiscard]] static bool is_made(owl::TermId literal);

 private:
  [[nodiscard]] std::vector<Value> values(bool are_certain);
  Outcome rebuild(bool is_first);
  Outcome ask(const Supposition& supposed);
  void end_question();

  std::unique_ptr<Search> search_;
  /// Of the last question, while its model is in the graph.
  std::optional<Outcome> last_;
  /// Whether nothing of an earlier question is supposed in the base.
  bool is_pure_ = false;
};

}  // namespace geminga::hypertableau

#endif
