// Spares raptor the search for namespaces that end with an XML element, where none began with one of its depth.
//
// Raptor 2.0.15 walks over all 1024 slots of its table of namespaces at the end of every element of RDF/XML, which is a
// third of its time. It calls itself by two functions of its public interface to begin and end namespaces
// (raptor_namespaces_start_namespace, raptor_namespaces_end_for_depth). Those of namespace_ends.cpp take their place in
// this program, as ELF has it for names that a program and a library define, and hand on every call that can change
// anything. A raptor that is linked without such calls, as by -Bsymbolic, walks as ever.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_NAMESPACE_ENDS_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_NAMESPACE_ENDS_HPP

#include <cstdint>

namespace geminga::rdf {

/// Says that this thread opens another parser. To be called before each, so that nothing is known of a stack that lies
/// where an earlier one lay.
void forget_namespace_depths();

/// How many ends of depths this thread has not handed on to raptor.
[[nodiscard]] std::uint64_t spared_namespace_ends();

}  // namespace geminga::rdf

#endif
