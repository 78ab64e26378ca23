#include "discovery/participant/queries/proofs.hpp"

#include "base/text.hpp"
#include "discovery/participant/queries/checks.hpp"
#include "reasoning/vocabulary/explanation.hpp"
#include "reasoning/vocabulary/expression.hpp"

namespace geminga::participant {
namespace {

/// Adds the axioms by which the first name is below the second; none where the names are equal or it is not below.
void add_proof(const vocabulary::Vocabulary& vocabulary, const std::string& sub_iri, const std::string& super_iri,
               std::string& proof) {
  if (sub_iri == super_iri) return;
  const auto sub = vocabulary.find_iri(sub_iri);
  const auto super = vocabulary.find_iri(super_iri);
  if (!sub || !super || !vocabulary.is_subsumed(*sub, *super)) return;
  const auto explanation = vocabulary.explain(*sub, *super);
  if (!explanation) return;
  for (const auto& axiom : explanation->axioms) append_axiom(axiom.text, proof);
}

}  // namespace

void append_axiom(const std::string& axiom, std::string& proof) {
  const std::string line = base::printable(axiom, max_proof_bytes);
  if (proof.size() + line.size() + 1 <= max_proof_bytes) proof += (proof.empty() ? "" : "\n") + line;
}

void add_proof_of_concepts(const vocabulary::Vocabulary& vocabulary, const std::string& sub, const std::string& super,
                           std::string& proof) {
  if (!has_expression(SemanticIdentity{sub, ""}) && !has_expression(SemanticIdentity{super, ""})) {
    return add_proof(vocabulary, sub, super, proof);
  }
  if (sub == super || !vocabulary.check_expressions()) return;
  const auto text = [](const std::string& name) {
    return has_expression(SemanticIdentity{name, ""}) ? name : "<" + name + ">";
  };
  const auto below = vocabulary.read(text(sub), vocabulary::max_expression_bytes);
  const auto above = vocabulary.read(text(super), vocabulary::max_expression_bytes);
  if (!below || !above) return;
  for (const auto& axiom : vocabulary.proof(*below, *above)) append_axiom(axiom.text, proof);
}

std::string proof_of(const vocabulary::Vocabulary& vocabulary, const Identity& offered, const Identity& requested,
                     const std::optional<matching::Match>& match) {
  const auto* offer = std::get_if<SemanticIdentity>(&offered);
  const auto* request = std::get_if<SemanticIdentity>(&requested);
  std::string proof;
  if (offer == nullptr || request == nullptr || !vocabulary.is_loaded()) return proof;
  const bool has_expressions = has_expression(*offer) || has_expression(*request);
  const auto add = [&](const std::string& one, const std::string& other) {
    const std::size_t before = proof.size();
    if (has_expressions && &one == &offer->concept_iri) {
      const bool is_broader = match && match->degree == Degree::broader;
      if (match) add_proof_of_concepts(vocabulary, is_broader ? other : one, is_broader ? one : other, proof);
      return;
    }
    add_proof(vocabulary, one, other, proof);
    if (proof.size() == before) add_proof(vocabulary, other, one, proof);
  };
  add(offer->concept_iri, request->concept_iri);
  if (!offer->representation_iri.empty() && !request->representation_iri.empty()) {
    add(offer->representation_iri, request->representation_iri);
  }
  return proof;
}

}  // namespace geminga::participant
