// Small ontologies built in memory for tests of matching.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_TAXONOMY_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_TAXONOMY_HPP

#include <functional>
#include <string>
#include <string_view>

#include "geminga/identity.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/axiom.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

inline std::string iri(std::string_view name) { return "http://example.org/" + std::string(name); }

inline Identity semantic(std::string_view concept_name, std::string_view representation = {}) {
  return SemanticIdentity{iri(concept_name), representation.empty() ? "" : iri(representation)};
}

/// Collects axioms about classes of http://example.org/ and classifies them.
class Taxonomy {
 public:
  Taxonomy() : file_(source_.add_file("test.ttl", "http://example.org/")) {}

  Taxonomy& sub(std::string_view sub, std::string_view super) {
    source_.add(owl::AxiomKind::sub_class_of, {named(sub), named(super)}, file_, ++line_);
    return *this;
  }
  Taxonomy& equivalent(std::string_view a, std::string_view b) {
    source_.add(owl::AxiomKind::equivalent_classes, {named(a), named(b)}, file_, ++line_);
    return *this;
  }
  Taxonomy& disjoint(std::string_view a, std::string_view b) {
    source_.add(owl::AxiomKind::disjoint_classes, {named(a), named(b)}, file_, ++line_);
    return *this;
  }
  /// Every `sub` has a value of the property that is a `filler`.
  Taxonomy& some(std::string_view sub, std::string_view property, std::string_view filler) {
    const owl::TermId role = source_.object_property(iri(property));
    const owl::TermId some = source_.term(owl::TermKind::object_some_values_from, {role, named(filler)});
    source_.add(owl::AxiomKind::sub_class_of, {named(sub), some}, file_, ++line_);
    return *this;
  }
  /// Leaves an axiom out, as if it could not be read.
  Taxonomy& leave_out(std::string_view construct) {
    source_.leave_out(construct, file_, ++line_);
    return *this;
  }
  Taxonomy& convert(std::string_view from, std::string_view to, int cost = 1) {
    source_.add_conversion(iri(from), iri(to), std::to_string(cost), file_, ++line_);
    return *this;
  }
  Taxonomy& unsatisfiable(std::string_view name) {
    source_.add(owl::AxiomKind::sub_class_of, {named(name), source_.named_class(owl::owl_nothing)}, file_, ++line_);
    return *this;
  }

  [[nodiscard]] vocabulary::Vocabulary classified() const {
    auto classification = el::classify(source_);
    return vocabulary::Vocabulary(
        std::move(compiled::Ontology::from_bytes(compiled::compile(source_, classification.value()))).value());
  }

 private:
  owl::TermId named(std::string_view name) { return source_.named_class(iri(name)); }

  owl::Ontology source_;
  owl::FileId file_;
  std::uint32_t line_ = 0;
};

/// Tracked things and frames as in robot soccer: an own ball is a ball is a tracked object, a sphere is just another
/// word for a ball, nothing can be a ghost.
inline vocabulary::Vocabulary soccer(const std::function<void(Taxonomy&)>& add = {}) {
  Taxonomy taxonomy;
  taxonomy.sub("Ball", "Tracked").sub("OwnBall", "Ball").sub("Robot", "Tracked").equivalent("Sphere", "Ball");
  taxonomy.sub("FieldFrame", "Frame").sub("PolarFieldFrame", "FieldFrame").equivalent("Pitch", "FieldFrame");
  taxonomy.sub("Ghost", "Ball").unsatisfiable("Ghost").unsatisfiable("Phantom");
  if (add) add(taxonomy);
  return taxonomy.classified();
}

}  // namespace geminga::matching

#endif
