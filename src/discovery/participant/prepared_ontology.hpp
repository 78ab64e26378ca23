// What class expressions need of an ontology: it saturated, and its names looked up.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_PREPARED_ONTOLOGY_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_PREPARED_ONTOLOGY_HPP

#include <expected>
#include <memory>

#include "geminga/error.hpp"
#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/placement/expression_classifier.hpp"

namespace geminga::participant {

/// Made once an ontology, at the cost of its classification: seconds for a large one, so that no participant makes it
/// within an event. Immutable; safe to read from many threads.
class PreparedOntology {
 public:
  /// What expressions are read and placed with.
  struct Parts {
    placement::ExpressionClassifier classifier;
    compiled::EntityNames names;
  };

  /// Borrows `ontology`, which must outlive it. May run on any thread, beside others that read the ontology. Where
  /// memory runs out there is an error in place of the parts, as for an ontology that is over a limit.
  [[nodiscard]] static std::unique_ptr<const PreparedOntology> make(const compiled::Ontology& ontology);

  [[nodiscard]] const compiled::Ontology& ontology() const { return ontology_; }
  /// 422 where expressions are impossible in this ontology.
  [[nodiscard]] const std::expected<Parts, Error>& parts() const { return parts_; }

 private:
  PreparedOntology(const compiled::Ontology& ontology, std::expected<Parts, Error> parts)
      : ontology_(ontology), parts_(std::move(parts)) {}

  const compiled::Ontology& ontology_;
  std::expected<Parts, Error> parts_;
};

}  // namespace geminga::participant

#endif
