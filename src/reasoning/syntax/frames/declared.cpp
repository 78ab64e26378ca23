#include "reasoning/syntax/frames/declared.hpp"

namespace geminga::frames {
namespace {

/// Entities have the first numbers of all terms.
std::uint8_t bit_of(el::TermKind kind) { return static_cast<std::uint8_t>(1U << static_cast<unsigned>(kind)); }

}  // namespace

void Declared::add(el::TermKind kind, std::string_view iri) {
  const auto found = kinds_.find(iri);
  if (found == kinds_.end()) {
    kinds_.emplace(iri, bit_of(kind));
  } else {
    found->second = static_cast<std::uint8_t>(found->second | bit_of(kind));
  }
}

void Declared::add(const el::OntologySource& source) {
  for (std::uint32_t number = 0; number < source.term_count(); ++number) {
    const el::TermKind kind = source.kind(el::TermId{number});
    const bool is_told_apart =
        kind == el::TermKind::object_property || kind == el::TermKind::data_property || kind == el::TermKind::datatype;
    if (is_told_apart) add(kind, source.name_of(el::TermId{number}));
  }
}

bool Declared::has(el::TermKind kind, std::string_view iri) const {
  const auto found = kinds_.find(iri);
  return found != kinds_.end() && (found->second & bit_of(kind)) != 0;
}

}  // namespace geminga::frames
