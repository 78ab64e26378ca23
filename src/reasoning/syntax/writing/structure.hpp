// The walk over a document in the order of the structural specification, for the syntaxes that follow it.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_STRUCTURE_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_STRUCTURE_HPP

#include "reasoning/syntax/writing/form.hpp"
#include "reasoning/syntax/writing/output.hpp"

namespace geminga::writing {

/// Shows all parts of a document to a form. Expressions nest a bounded number of levels (owl::SourceLimits).
void write_structure(const Document& document, Form& form, const Output& output);

}  // namespace geminga::writing

#endif
