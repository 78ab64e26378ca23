#include "ontology/findings/axioms.hpp"

#include <boost/json.hpp>

namespace geminga::ontology {

std::string place(const std::string& file, std::uint32_t line) {
  return line == 0 ? file : file + ':' + std::to_string(line);
}

std::string axiom_line(const explanation::ExplainedAxiom& axiom) {
  return axiom.file.empty() ? axiom.text : axiom.text + "   [" + place(axiom.file, axiom.line) + ']';
}

boost::json::object axiom_object(const explanation::ExplainedAxiom& axiom) {
  return {{"axiom", axiom.text}, {"file", axiom.file}, {"line", axiom.line}};
}

boost::json::array axiom_array(const std::vector<explanation::ExplainedAxiom>& axioms) {
  boost::json::array list;
  for (const explanation::ExplainedAxiom& axiom : axioms) list.push_back(axiom_object(axiom));
  return list;
}

}  // namespace geminga::ontology
