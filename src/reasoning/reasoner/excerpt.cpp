// Copies terms, each once, arguments first.
#include "reasoning/reasoner/excerpt.hpp"

#include <limits>

#include "reasoning/owl/loaded_file.hpp"

namespace geminga::reasoner {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

Excerpt::Excerpt(const owl::Ontology& from, std::span<const std::uint32_t> axioms)
    : from_(from), numbers_(from.term_count(), none) {
  for (const owl::LoadedFile& file : from.files()) source.add_file(file.path, file.ontology_iri);
  if (from.files().empty()) source.add_file("");
  std::vector<owl::TermId> arguments;
  for (const std::uint32_t number : axioms) {
    const owl::Axiom axiom = from.axiom(number);
    arguments.clear();
    for (const owl::TermId argument : axiom.arguments) arguments.push_back(term(argument));
    source.add(axiom.kind, arguments, axiom.file, axiom.line);
  }
  copied = source.axiom_count();
}

// Terms of axioms nest at most as deep as SourceLimits::nesting, so the recursion is bounded.
owl::TermId Excerpt::term(owl::TermId original) {
  const auto at = static_cast<std::size_t>(original);
  if (numbers_[at] != none) return owl::TermId{numbers_[at]};
  const owl::Term from = from_.term(original);
  std::vector<owl::TermId> arguments;
  arguments.reserve(from.arguments.size());
  for (const owl::TermId argument : from.arguments) arguments.push_back(term(argument));
  const owl::TermId copy = source.copy(from.kind, from_.name(from.name), from.number, arguments);
  numbers_[at] = static_cast<std::uint32_t>(copy);
  return copy;
}

owl::TermId Excerpt::fresh(owl::TermKind kind) {
  std::string name;
  do {
    name = "urn:geminga:asked:" + std::to_string(fresh_count_++);
  } while (from_.find_name(name));
  return source.entity(kind, name);
}

void Excerpt::add(owl::AxiomKind kind, std::span<const owl::TermId> arguments) {
  source.add(kind, arguments, owl::FileId{0}, 0);
}

}  // namespace geminga::reasoner
