#include "reasoning/syntax/frames/declared.hpp"

namespace geminga::frames {
namespace {

/// Entities are the first kinds of terms.
std::uint8_t bit_of(owl::TermKind kind) { return static_cast<std::uint8_t>(1U << static_cast<unsigned>(kind)); }

}  // namespace

void Declared::add(owl::TermKind kind, std::string_view iri) {
  const auto found = kinds_.find(iri);
  if (found == kinds_.end()) {
    kinds_.emplace(iri, bit_of(kind));
  } else {
    found->second = static_cast<std::uint8_t>(found->second | bit_of(kind));
  }
}

void Declared::add(const owl::Ontology& source) {
  for (std::uint32_t number = 0; number < source.term_count(); ++number) {
    const owl::TermKind kind = source.kind(owl::TermId{number});
    const bool is_told_apart = kind == owl::TermKind::object_property || kind == owl::TermKind::data_property ||
                               kind == owl::TermKind::datatype;
    if (is_told_apart) add(kind, source.name_of(owl::TermId{number}));
  }
}

bool Declared::has(owl::TermKind kind, std::string_view iri) const {
  const auto found = kinds_.find(iri);
  return found != kinds_.end() && (found->second & bit_of(kind)) != 0;
}

}  // namespace geminga::frames
