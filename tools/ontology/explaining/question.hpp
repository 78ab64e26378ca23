// A question of explain: whether one class, class expression or individual is below a class or class expression.
#ifndef GEMINGA_ONTOLOGY_EXPLAINING_QUESTION_HPP
#define GEMINGA_ONTOLOGY_EXPLAINING_QUESTION_HPP

#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/taxonomy/class_number.hpp"

namespace geminga::ontology {

/// The words of a question as a user writes them. An individual stands in place of the narrower class.
struct QuestionWords {
  std::string sub;
  std::string super;
  std::string individual;
};

/// One side of a question.
struct QuestionSide {
  taxonomy::ClassNumber number{};
  std::string words;        ///< with short names
  std::string name;         ///< the IRI of a class or individual; the words of an expression
  bool is_defined = false;  ///< the class is none of the files
};

/// A question about two classes of an ontology. For each class expression, and for an individual, the ontology has a
/// class that is defined by it, so that all that explains subsumptions explains these, too.
struct Question {
  Opened opened;
  QuestionSide sub;
  QuestionSide super;
  bool is_about_individual = false;

  [[nodiscard]] const compiled::Ontology& ontology() const { return opened.ontology; }
  /// Whether a side is none of the classes of the files.
  [[nodiscard]] bool has_definitions() const { return sub.is_defined || super.is_defined; }
  /// Whether it asks if the ontology contradicts itself: if owl:Thing is below owl:Nothing.
  [[nodiscard]] bool is_about_contradiction() const;
};

/// Opens the files for a question; nothing after saying what is wrong. A compiled file answers for classes alone.
[[nodiscard]] std::optional<Question> open_question(const std::vector<std::string>& files, const QuestionWords& words,
                                                    const LoadOptions& options);

/// Whether the answer is yes, and why that is not known. Work is taken from the budget.
[[nodiscard]] reasoner::Answer decide(const Question& question, base::Budget& budget);

}  // namespace geminga::ontology

#endif
