#include "discovery/participant/description_check.hpp"

#include "base/text.hpp"
#include "discovery/matching/editions.hpp"
#include "discovery/participant/clients/own_description.hpp"
#include "reasoning/vocabulary/expression.hpp"

namespace geminga::participant {

std::optional<Error> check_description(const env::Env& env, const vocabulary::Vocabulary& vocabulary,
                                       const std::string& expression) {
  if (expression.empty()) return std::nullopt;
  if (!vocabulary.is_loaded()) {
    const auto fault = vocabulary::check_grammar(expression);
    if (!fault) return std::nullopt;
    return Error{ErrorCode::impossible, "concept=" + base::printable(expression) + ": " + *fault};
  }
  const bool must_prepare = vocabulary.is_expression(expression) && !vocabulary.is_prepared();
  const matching::Editions editions(must_prepare ? vocabulary.with_expressions() : vocabulary);
  Expressions expressions;
  const OntologyReading reading;
  Resolver resolver(env, editions, expressions, reading);
  StatedPublication stated;
  stated.named = ConceptNames{expression, {}};
  stated.service.mode = ChannelMode::participant;
  return identify(stated, resolver);
}

}  // namespace geminga::participant
