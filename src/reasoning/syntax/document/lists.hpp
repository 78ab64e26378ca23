// Expressions and axioms over fewer operands than OWL 2 allows. OWL 1 allowed them, and tools still write them.
#ifndef GEMINGA_REASONING_SYNTAX_DOCUMENT_LISTS_HPP
#define GEMINGA_REASONING_SYNTAX_DOCUMENT_LISTS_HPP

#include <cstdint>
#include <span>

#include "reasoning/owl/source.hpp"

namespace geminga::document {

/// A union, intersection or enumeration of classes or data ranges. Over nothing, an intersection is everything
/// (owl:Thing, rdfs:Literal), and a union or enumeration is nothing (owl:Nothing, the complement of rdfs:Literal). A
/// union or intersection of one operand is this operand. Either is noted as a remark. A chain or a restriction of a
/// datatype that has one argument is this argument. Every other term is made as it stands.
owl::TermId term_of_list(owl::Ontology& source, owl::TermKind kind, std::span<const owl::TermId> operands,
                         owl::FileId file, std::uint32_t line);

/// Whether an axiom over a list needs two operands to say anything. One that has fewer says nothing, which is noted as
/// a remark.
bool says_nothing(owl::Ontology& source, owl::AxiomKind kind, std::size_t operands, owl::FileId file,
                  std::uint32_t line);

/// A disjoint union of no class: the class is owl:Nothing, which is added as an axiom and noted as a remark.
void add_empty_union(owl::Ontology& source, owl::TermId named, owl::FileId file, std::uint32_t line);

}  // namespace geminga::document

#endif
