#include "ontology/explaining/question.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "ontology/command/words.hpp"
#include "ontology/loading/argument.hpp"
#include "ontology/loading/class_expressions.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/explanation/explain_module.hpp"

namespace geminga::ontology {
namespace {

using reasoner::Answer;
using reasoner::Verdict;

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

namespace {

/// The two sides as expressions; nothing after saying what is wrong.
std::optional<std::pair<manchester::Expression, manchester::Expression>> read_or_say(const compiled::Ontology& ontology,
                                                                                     const QuestionWords& words,
                                                                                     bool as_json) {
  const compiled::EntityNames names(ontology);
  const bool is_about_individual = !words.individual.empty();
  const std::string narrower = is_about_individual ? '{' + words.individual + '}' : words.sub;
  auto sub = read_expression_or_say(ontology, names, narrower, as_json);
  if (!sub) return std::nullopt;
  if (is_about_individual && !is_one_individual(*sub)) {
    say_failure('\'' + base::printable(words.individual) + "' is no name of an individual", as_json);
    return std::nullopt;
  }
  auto super = read_expression_or_say(ontology, names, words.super, as_json);
  if (!super) return std::nullopt;
  return std::pair(std::move(*sub), std::move(*super));
}

/// Opens the files again with the classes that the sides define. Nothing after saying what is wrong.
std::optional<Opened> open_with_definitions(Opened before, const manchester::Expression& sub,
                                            const manchester::Expression& super, Question& question,
                                            const LoadOptions& options) {
  if (!before.classified) {
    say_failure("a compiled file explains classes alone: give the files for a class expression or an individual",
                options.as_json);
    return std::nullopt;
  }
  rdf::Loaded loaded = std::move(before.classified->loaded);
  owl::Ontology& source = loaded.source;
  const owl::FileId none = source.add_file("");
  const auto iri_of = [&](const QuestionSide& side, const manchester::Expression& expression, std::string_view name) {
    if (!side.is_defined) return side.name;
    return define_class(source, name, source.copy(expression.source, expression.term), none);
  };
  const std::string below = iri_of(question.sub, sub, question.is_about_individual ? "about:individual" : "about:sub");
  const std::string above = iri_of(question.super, super, "about:super");
  if (source.problem()) {
    say_failure(*source.problem(), options.as_json);
    return std::nullopt;
  }
  auto opened = classify_and_compile_or_say(std::move(loaded), options);
  if (!opened) return std::nullopt;
  question.sub.number = opened->ontology.find_iri(below).value_or(taxonomy::ClassNumber{});
  question.super.number = opened->ontology.find_iri(above).value_or(taxonomy::ClassNumber{});
  return opened;
}

}  // namespace

std::optional<Question> open_question(const std::vector<std::string>& files, const QuestionWords& words,
                                      const LoadOptions& options) {
  auto opened = open_or_say(files, options);
  const auto sides = opened ? read_or_say(opened->ontology, words, options.as_json) : std::nullopt;
  if (!sides) return std::nullopt;
  const auto& [sub, super] = *sides;
  const bool is_about_individual = !words.individual.empty();
  Question question{std::move(*opened), {}, {}, is_about_individual};
  question.sub = is_about_individual ? individual_of(question.ontology(), sub) : side_of(question.ontology(), sub);
  question.super = side_of(question.ontology(), super);
  if (!question.has_definitions()) return question;
  opened = open_with_definitions(std::move(question.opened), sub, super, question, options);
  if (!opened) return std::nullopt;
  question.opened = std::move(*opened);
  return question;
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
    if (is_undecided(opened.classified->classification, sub))
      return {Verdict::unknown, why_undecided(*opened.classified).value_or("")};
    // Of classes of the files explanation::why_not() says that axioms were left out.
    auto unread = question.has_definitions() ? find_unread(opened.classified->loaded.source, {}, true) : std::nullopt;
    if (unread) return {Verdict::unknown, std::move(*unread)};
    return {Verdict::no, {}};
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
