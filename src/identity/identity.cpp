// Canonical forms and their 32-bit hash; src/identity/IDENTITY.md is the specification.
#include "geminga/identity.hpp"

#include "base/hash.hpp"

namespace geminga {
namespace {

struct CanonicalForm {
  std::string operator()(const NumericIdentity& identity) const { return std::to_string(identity.number); }
  std::string operator()(const TextIdentity& identity) const { return identity.text; }
  std::string operator()(const SemanticIdentity& identity) const {
    const bool is_named = !has_expression(identity);
    std::string form = (is_named ? '<' : '(') + identity.concept_iri + (is_named ? '>' : ')');
    if (!identity.representation_iri.empty()) form += '<' + identity.representation_iri + '>';
    return form;
  }
};

}  // namespace

bool has_expression(const SemanticIdentity& identity) { return identity.concept_iri.find('<') != std::string::npos; }

bool has_expression(const Identity& identity) {
  const auto* semantic = std::get_if<SemanticIdentity>(&identity);
  return semantic != nullptr && has_expression(*semantic);
}

std::string canonical_form(const Identity& identity) { return std::visit(CanonicalForm{}, identity); }

Id32 id32(const Identity& identity) {
  if (const auto* numeric = std::get_if<NumericIdentity>(&identity)) return numeric->number;
#ifdef GEMINGA_CONSTANT_ID32
  return GEMINGA_CONSTANT_ID32;  // in a test build where everything collides, only speed may change
#else
  return base::hash32(canonical_form(identity));
#endif
}

}  // namespace geminga
