// A source is compiled, and the lines are those of the compiled axioms.
#include "extracted.hpp"

#include <algorithm>
#include <functional>
#include <span>

#include "reasoning/modules/module.hpp"
#include "support/written.hpp"

namespace geminga::modules {
namespace {

owl::Ontology copied(const owl::Ontology& source, const std::function<bool(std::size_t axiom)>& is_wanted,
                     const std::function<std::uint32_t(std::size_t axiom)>& line_of) {
  owl::Ontology copy;
  const owl::FileId file = copy.add_file("copy");
  std::vector<owl::TermId> terms;
  const auto mapped = [&](std::span<const owl::TermId> from) {
    std::vector<owl::TermId> to;
    for (const owl::TermId id : from) to.push_back(terms[static_cast<std::size_t>(id)]);
    return to;
  };
  for (std::uint32_t id = 0; id < source.term_count(); ++id) {
    const owl::Term term = source.term(owl::TermId{id});
    terms.push_back(copy.copy(term.kind, source.name(term.name), term.number, mapped(term.arguments)));
  }
  for (std::size_t at = 0; at < source.axiom_count(); ++at) {
    const owl::Axiom axiom = source.axiom(at);
    if (is_wanted(at)) copy.add(axiom.kind, mapped(axiom.arguments), file, line_of(at));
  }
  return copy;
}

}  // namespace

owl::Ontology numbered(const owl::Ontology& source) {
  return copied(
      source, [](std::size_t) { return true; },
      [](std::size_t axiom) { return static_cast<std::uint32_t>(axiom) + 1; });
}

owl::Ontology only(const owl::Ontology& numbered, const std::vector<std::uint32_t>& lines) {
  owl::Ontology part = copied(
      numbered, [&](std::size_t axiom) { return std::ranges::binary_search(lines, numbered.axiom(axiom).line); },
      [&](std::size_t axiom) { return numbered.axiom(axiom).line; });
  // A class that no axiom of the module uses is classified, too.
  for (std::uint32_t id = 0; id < part.term_count(); ++id) {
    const owl::TermId term{id};
    if (part.kind(term) == owl::TermKind::named_class) {
      part.add(owl::AxiomKind::declaration, std::span(&term, 1), owl::FileId{0}, 0);
    }
  }
  return part;
}

std::vector<std::uint32_t> lines_of_module(const owl::Ontology& source, const std::vector<std::string>& signature) {
  const compiled::Ontology ontology = owl::loaded(source);
  const taxonomy::ClassifiedView& view = ontology.axioms();
  std::vector<taxonomy::ClassNumber> classes;
  std::vector<std::uint32_t> terms;
  for (const std::string& iri : signature) {
    if (const auto found = ontology.find_iri(iri)) classes.push_back(*found);
    for (std::uint32_t term = 0; term < view.term_count(); ++term) {
      const bool is_property_or_individual =
          is_entity(view.kind_of_term(term)) && view.kind_of_term(term) != owl::TermKind::named_class;
      if (is_property_or_individual && view.name_of_term(term) == iri) terms.push_back(term);
    }
  }
  std::vector<std::uint32_t> lines;
  for (const std::uint32_t axiom : extract_module(ontology.module_index(), classes, terms)) {
    lines.push_back(view.axiom_line[axiom]);
  }
  std::ranges::sort(lines);
  return lines;
}

}  // namespace geminga::modules
