// Repeated declarations are added once, and made-up names are limited.
#include "reasoning/syntax/rdf/mapping/axiom_writer.hpp"

#include <utility>

#include "reasoning/syntax/document/lists.hpp"

namespace geminga::rdf {
namespace {

/// Different constructs that are left out by name. A file can make up as many names of OWL's as it likes.
constexpr std::size_t max_constructs = 250;

/// Entities are the kinds 0 to 5 of owl::TermKind.
constexpr std::size_t entity_kinds = 6;

}  // namespace

AxiomWriter::AxiomWriter(const Graph& graph, owl::Ontology& ontology, std::vector<owl::FileId> files)
    : graph_(graph),
      ontology_(ontology),
      files_(std::move(files)),
      declared_(graph.node_count() * entity_kinds, false) {}

void AxiomWriter::add(std::uint32_t triple, owl::AxiomKind kind, std::initializer_list<Mapped> arguments) {
  std::vector<owl::TermId> terms;
  for (const Mapped& argument : arguments) {
    if (!argument) return leave_out(triple, argument.error());
    terms.push_back(*argument);
  }
  add(triple, kind, terms);
}

void AxiomWriter::add(std::uint32_t triple, owl::AxiomKind kind, const std::vector<owl::TermId>& arguments) {
  const auto axioms = static_cast<std::uint32_t>(ontology_.axiom_count());
  const auto ill_typed = static_cast<std::uint32_t>(ontology_.ill_typed_count());
  ontology_.add(kind, arguments, file_of(triple), graph_.triple(triple).line);
  if (place_of_.empty()) return;
  if (ontology_.axiom_count() > axioms) place_of_[triple] = axioms;
  if (ontology_.ill_typed_count() > ill_typed) place_of_[triple] = ill_typed | ill_typed_place;
}

std::optional<AxiomWriter::Place> AxiomWriter::axiom_of(std::uint32_t triple) const {
  const std::uint32_t place = place_of_.empty() ? no_place : place_of_[triple];
  if (place == no_place) return std::nullopt;
  return Place{place & ~ill_typed_place, (place & ill_typed_place) != 0};
}

owl::TermId AxiomWriter::term_of_list(std::uint32_t triple, owl::TermKind kind,
                                      const std::vector<owl::TermId>& members) {
  return document::term_of_list(ontology_, kind, members, file_of(triple), graph_.triple(triple).line);
}

void AxiomWriter::add_of_list(std::uint32_t triple, owl::AxiomKind kind, const std::vector<owl::TermId>& members) {
  if (!document::says_nothing(ontology_, kind, members.size(), file_of(triple), graph_.triple(triple).line))
    add(triple, kind, members);
}

void AxiomWriter::declare(std::uint32_t triple, owl::TermKind kind) {
  const NodeId node = graph_.triple(triple).subject;
  const std::size_t slot = static_cast<std::size_t>(node) * entity_kinds + static_cast<std::size_t>(kind);
  if (!graph_.is_iri(node) || declared_[slot]) return;
  declared_[slot] = true;
  add(triple, owl::AxiomKind::declaration, {ontology_.entity(kind, graph_.text(node))});
}

void AxiomWriter::leave_out(std::uint32_t triple, std::string_view construct) {
  if (constructs_.size() < max_constructs) {
    constructs_.emplace(construct);
  } else if (!constructs_.contains(construct)) {
    construct = "other names that OWL 2 does not have";
  }
  ontology_.leave_out(construct, file_of(triple), graph_.triple(triple).line);
}

void AxiomWriter::remark(std::uint32_t triple, std::string_view text) {
  ontology_.remark(text, file_of(triple), graph_.triple(triple).line);
}

}  // namespace geminga::rdf
