// Canonical forms and their 32-bit hash; src/identity/IDENTITY.md is the specification.
#include "geminga/identity.hpp"

#include <xxhash.h>

namespace geminga {
namespace {

struct CanonicalForm {
  std::string operator()(const NumericIdentity& identity) const { return std::to_string(identity.number); }
  std::string operator()(const TextIdentity& identity) const { return identity.text; }
  std::string operator()(const SemanticIdentity& identity) const {
    std::string form = '<' + identity.concept_iri + '>';
    if (!identity.representation_iri.empty()) form += '<' + identity.representation_iri + '>';
    return form;
  }
};

}  // namespace

std::string canonical_form(const Identity& identity) { return std::visit(CanonicalForm{}, identity); }

Id32 id32(const Identity& identity) {
  if (const auto* numeric = std::get_if<NumericIdentity>(&identity)) return numeric->number;
#ifdef GEMINGA_CONSTANT_ID32
  return GEMINGA_CONSTANT_ID32;  // a test build in which everything collides: nothing but speed may change
#else
  const std::string form = canonical_form(identity);
  return XXH32(form.data(), form.size(), 0);
#endif
}

}  // namespace geminga
