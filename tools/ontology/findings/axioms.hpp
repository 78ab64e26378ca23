// Axioms with the files and lines where they stand, in text and in JSON.
#ifndef GEMINGA_ONTOLOGY_FINDINGS_AXIOMS_HPP
#define GEMINGA_ONTOLOGY_FINDINGS_AXIOMS_HPP

#include <boost/json/fwd.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "reasoning/explanation/explain.hpp"

namespace geminga::ontology {

/// FILE:LINE, or FILE where the line is not known.
[[nodiscard]] std::string place(const std::string& file, std::uint32_t line);

/// `AXIOM   [FILE:LINE]` without a line end; AXIOM alone where the file is not known.
[[nodiscard]] std::string axiom_line(const explanation::ExplainedAxiom& axiom);

/// {"axiom": ..., "file": ..., "line": ...}
[[nodiscard]] boost::json::object axiom_object(const explanation::ExplainedAxiom& axiom);
[[nodiscard]] boost::json::array axiom_array(const std::vector<explanation::ExplainedAxiom>& axioms);

}  // namespace geminga::ontology

#endif
