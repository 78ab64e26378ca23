// Copies terms bottom up, each once.
#include "reasoning/reasoner/excerpt.hpp"

#include <limits>

namespace geminga::reasoner {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

Excerpt::Excerpt(const el::OntologySource& from, std::span<const std::uint32_t> axioms)
    : from_(from), numbers_(from.term_count(), none) {
  for (const el::LoadedFile& file : from.files()) source.add_file(file.path, file.ontology_iri);
  if (from.files().empty()) source.add_file("");
  std::vector<el::TermId> arguments;
  for (const std::uint32_t number : axioms) {
    const el::Axiom axiom = from.axiom(number);
    arguments.clear();
    for (const el::TermId argument : axiom.arguments) arguments.push_back(term(argument));
    source.add(axiom.kind, arguments, axiom.file, axiom.line);
  }
  copied = source.axiom_count();
}

// Terms of axioms nest at most as deep as SourceLimits::nesting says, so the recursion is bounded.
el::TermId Excerpt::term(el::TermId original) {
  const auto at = static_cast<std::size_t>(original);
  if (numbers_[at] != none) return el::TermId{numbers_[at]};
  const el::Term from = from_.term(original);
  std::vector<el::TermId> arguments;
  arguments.reserve(from.arguments.size());
  for (const el::TermId argument : from.arguments) arguments.push_back(term(argument));
  const el::TermId copy = source.copy(from.kind, from_.name(from.name), from.number, arguments);
  numbers_[at] = static_cast<std::uint32_t>(copy);
  return copy;
}

el::TermId Excerpt::fresh(el::TermKind kind) {
  std::string name;
  do {
    name = "urn:geminga:asked:" + std::to_string(fresh_count_++);
  } while (from_.find_name(name));
  return source.entity(kind, name);
}

void Excerpt::add(el::AxiomKind kind, std::span<const el::TermId> arguments) {
  source.add(kind, arguments, el::FileId{0}, 0);
}

}  // namespace geminga::reasoner
