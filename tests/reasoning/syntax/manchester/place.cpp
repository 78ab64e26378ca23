#include "place.hpp"

#include <gtest/gtest.h>

#include "reasoning/syntax/manchester/canonical.hpp"
#include "support/written.hpp"

namespace geminga::manchester {
namespace {

std::string listed(const std::vector<taxonomy::ClassNumber>& classes, const compiled::Ontology& ontology) {
  std::string text;
  for (const taxonomy::ClassNumber number : classes)
    text += " " + std::string(compiled::end_of_iri(ontology.iri(number)));
  return text;
}

}  // namespace

Asked::Asked(std::string_view ontology, const placement::ExpressionLimits& limits)
    : Asked(owl::written(ontology), limits) {}

Asked::Asked(const owl::Ontology& source, const placement::ExpressionLimits& limits)
    : ontology_(std::make_unique<compiled::Ontology>(owl::loaded(source))),
      names_(std::make_unique<compiled::EntityNames>(*ontology_)) {
  auto classifier = placement::ExpressionClassifier::build(*ontology_, limits);
  if (!classifier) {
    ADD_FAILURE() << classifier.error().text;
    return;
  }
  classifier_ = std::make_unique<placement::ExpressionClassifier>(std::move(*classifier));
}

placement::ExpressionPlace Asked::place_of(std::string_view expression) const {
  const auto read = parse(expression, *names_);
  if (!read) {
    ADD_FAILURE() << expression << ": " << to_string(read.error());
    return {};
  }
  return classifier_->classify(read->source, read->term);
}

std::string Asked::place(std::string_view expression) const {
  const placement::ExpressionPlace place = place_of(expression);
  const std::string gap = place.gaps.empty() ? "" : " ?";
  if (!place.is_satisfiable) return "nothing" + gap;
  if (place.equivalent) return "=" + listed({*place.equivalent}, *ontology_) + gap;
  const std::string below = listed(place.children, *ontology_);
  return "<" + listed(place.parents, *ontology_) + (below.empty() ? "" : " >" + below) + gap;
}

std::string Asked::is_subsumed(std::string_view sub, std::string_view super) const {
  // Both are terms of one source.
  const auto both = parse("(" + std::string(sub) + ") or (" + std::string(super) + ")", *names_);
  if (!both) {
    ADD_FAILURE() << to_string(both.error());
    return {};
  }
  const owl::Term term = both->source.term(both->term);
  const auto answer = classifier_->is_subsumed(both->source, term.arguments[0], term.arguments[1]);
  return answer.holds ? "yes" : answer.gaps.empty() ? "no" : "no?";
}

std::string Asked::read(std::string_view expression, const ExpressionLimits& limits) const {
  const auto read = parse(expression, *names_, limits);
  return read ? canonical(read->source, read->term) : to_string(read.error());
}

}  // namespace geminga::manchester
