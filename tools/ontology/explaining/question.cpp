#include "ontology/explaining/question.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "ontology/command/words.hpp"
#include "ontology/loading/class_expressions.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/explanation/explain_module.hpp"

namespace geminga::ontology {
namespace {

using reasoner::Answer;
using reasoner::Verdict;

/// Adds a class that is equivalent to the expression. Returns its IRI, which no file has.
std::string define(owl::Ontology& source, std::string_view iri, const manchester::Expression& expression,
                   owl::FileId file) {
  std::string free(iri);
  while (source.find_name(free)) free += '-';
  const owl::TermId term = source.copy(expression.source, expression.term);
  source.add(owl::AxiomKind::equivalent_classes, {source.named_class(free), term}, file, 0);
  return free;
}

/// A side as it is written. Its class has no number yet where it is none of the files.
QuestionSide side_of(const compiled::Ontology& ontology, const manchester::Expression& expression) {
  QuestionSide side;
  side.words = words_of(ontology, expression);
  const auto number = class_of(ontology, expression);
  side.is_defined = !number;
  side.number = number.value_or(taxonomy::ClassNumber{});
  side.name = number ? std::string(ontology.iri(*number)) : side.words;
  return side;
}

/// Whether an expression is the enumeration of one individual. Words with brackets or commas of their own make others.
bool is_one_individual(const manchester::Expression& expression) {
  return expression.source.kind(expression.term) == owl::TermKind::object_one_of &&
         expression.source.term(expression.term).arguments.size() == 1;
}

/// An individual as it is written, from its enumeration.
QuestionSide individual_of(const compiled::Ontology& ontology, const manchester::Expression& enumeration) {
  QuestionSide side = side_of(ontology, enumeration);
  const owl::Term term = enumeration.source.term(enumeration.term);
  side.name = enumeration.source.name_of(term.arguments.front());
  side.words = ontology.short_name(side.name);
  return side;
}

}  // namespace

bool Question::is_about_contradiction() const { return sub.name == owl::owl_thing && super.name == owl::owl_nothing; }

std::optional<Question> open_question(const std::vector<std::string>& files, const QuestionWords& words,
                                      const LoadOptions& options) {
  auto opened = open_or_say(files, options);
  if (!opened) return std::nullopt;
  const bool is_about_individual = !words.individual.empty();
  const auto read = [&](const std::string& text) {
    const compiled::EntityNames names(opened->ontology);
    return read_expression_or_say(opened->ontology, names, text, options.as_json);
  };
  const auto sub = read(is_about_individual ? '{' + words.individual + '}' : words.sub);
  const auto super = sub ? read(words.super) : std::nullopt;
  if (!sub || !super) return std::nullopt;
  if (is_about_individual && !is_one_individual(*sub)) {
    say_failure('\'' + base::printable(words.individual) + "' is no name of an individual", options.as_json);
    return std::nullopt;
  }
  QuestionSide below = is_about_individual ? individual_of(opened->ontology, *sub) : side_of(opened->ontology, *sub);
  QuestionSide above = side_of(opened->ontology, *super);
  if (below.is_defined || above.is_defined) {
    if (!opened->classified) {
      say_failure("a compiled file explains classes alone: give the files for a class expression or an individual",
                  options.as_json);
      return std::nullopt;
    }
    rdf::Loaded loaded = std::move(opened->classified->loaded);
    const owl::FileId none = loaded.source.add_file("");
    const std::string below_iri =
        below.is_defined ? define(loaded.source, is_about_individual ? "about:individual" : "about:sub", *sub, none)
                         : below.name;
    const std::string above_iri = above.is_defined ? define(loaded.source, "about:super", *super, none) : above.name;
    opened = classify_and_compile_or_say(std::move(loaded), options);
    if (!opened) return std::nullopt;
    below.number = opened->ontology.find_iri(below_iri).value_or(taxonomy::ClassNumber{});
    above.number = opened->ontology.find_iri(above_iri).value_or(taxonomy::ClassNumber{});
  }
  return Question{std::move(*opened), std::move(below), std::move(above), is_about_individual};
}

Answer decide(const Question& question, base::Budget& budget) {
  const Opened& opened = question.opened;
  const taxonomy::ClassNumber sub = question.sub.number;
  const taxonomy::ClassNumber super = question.super.number;
  if (question.is_about_contradiction()) {
    if (!opened.ontology.is_consistent()) return {Verdict::yes, {}};
    const Answer& consistency = opened.consistency;
    return consistency.verdict == Verdict::unknown ? consistency : Answer{Verdict::no, {}};
  }
  if (opened.ontology.is_subsumed(sub, super)) return {Verdict::yes, {}};
  if (opened.refused) return {Verdict::unknown, *opened.refused};
  if (opened.classified) {
    if (!is_undecided(opened.classified->classification, sub)) return {Verdict::no, {}};
    return {Verdict::unknown, why_undecided(*opened.classified).value_or("")};
  }
  // A compiled form keeps how many classes are undecided, and not which.
  const std::vector<std::string> gaps = opened.ontology.gaps();
  const auto line =
      std::ranges::find_if(gaps, [](const std::string& gap) { return gap.starts_with(compiled::undecided_words); });
  if (line == gaps.end()) return {Verdict::no, {}};
  explanation::Module module(opened.ontology, std::array{sub, super});
  const owl::TermId below = module.term(sub);
  const Verdict verdict = reasoner::entails(module.source(), std::nullopt, below, module.term(super), &budget).verdict;
  return {verdict, verdict == Verdict::unknown ? *line : ""};
}

}  // namespace geminga::ontology
