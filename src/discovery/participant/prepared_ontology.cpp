// Saturates, and turns every way in which that is impossible into an error.
#include "discovery/participant/prepared_ontology.hpp"

#include <new>
#include <utility>

namespace geminga::participant {
namespace {

std::expected<PreparedOntology::Parts, Error> parts_of(const compiled::Ontology& ontology) {
  try {
    auto classifier = placement::ExpressionClassifier::build(ontology);
    if (!classifier) return std::unexpected(Error{ErrorCode::impossible, classifier.error().text});
    return PreparedOntology::Parts{std::move(*classifier), compiled::EntityNames(ontology)};
  } catch (const std::bad_alloc&) {
    return std::unexpected(
        Error{ErrorCode::impossible, "not enough memory for class expressions: name a class instead"});
  }
}

}  // namespace

std::unique_ptr<const PreparedOntology> PreparedOntology::make(const compiled::Ontology& ontology) {
  return std::unique_ptr<const PreparedOntology>(new PreparedOntology(ontology, parts_of(ontology)));
}

}  // namespace geminga::participant
