// Writes a source as OWL/XML, so that a test can read it again.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_OWLXML_WRITER_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_OWLXML_WRITER_HPP

#include <string>

#include "reasoning/owl/source.hpp"

namespace geminga::owlxml {

/// One axiom a line, in the order of the source.
[[nodiscard]] std::string owl_xml(const owl::Ontology& source);

}  // namespace geminga::owlxml

#endif
