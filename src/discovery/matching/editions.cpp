#include "discovery/matching/editions.hpp"

#include <utility>

#include "base/assert.hpp"

namespace geminga::matching {

Editions::Editions(const vocabulary::Vocabulary& vocabulary)
    : in_force_{.vocabulary = vocabulary, .converters = std::make_shared<Converters>(vocabulary)} {}

void Editions::begin_filing(const vocabulary::Vocabulary& next) {
  GEMINGA_ASSERT(stage_ == ChangeStage::none);
  other_ = {next, registry::other(in_force_.generation), std::make_shared<Converters>(next)};
  stage_ = ChangeStage::filing;
}

void Editions::begin_rematching() {
  GEMINGA_ASSERT(stage_ == ChangeStage::filing);
  std::swap(in_force_, other_);
  stage_ = ChangeStage::rematching;
}

void Editions::begin_unfiling() {
  GEMINGA_ASSERT(stage_ == ChangeStage::rematching);
  stage_ = ChangeStage::unfiling;
}

void Editions::end_change() {
  GEMINGA_ASSERT(stage_ == ChangeStage::unfiling);
  other_ = {};
  stage_ = ChangeStage::none;
}

bool Editions::take_prepared(vocabulary::Vocabulary prepared) {
  const bool is_news = !in_force_.vocabulary.is_prepared() && prepared.is_prepared();
  if (!is_news || !prepared.has_ontology_of(in_force_.vocabulary)) return false;
  in_force_.vocabulary = std::move(prepared);
  return true;
}

}  // namespace geminga::matching
