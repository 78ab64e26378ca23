#include "reasoning/syntax/owlxml/reading.hpp"

#include <utility>

#include "reasoning/syntax/rdf/functional.hpp"

namespace geminga::owlxml {

Reading::Reading(std::string_view text, const XmlLimits& limits, unsigned threads) {
  auto result = read(text, source.add_file("t.owx"), source, limits, nullptr, threads);
  if (result) {
    document = std::move(*result);
  } else {
    error = to_string(result.error());
  }
}

std::vector<std::string> Reading::axioms() const { return rdf::functional_with_left_out(source); }

std::vector<std::string> Reading::remarks() const {
  std::vector<std::string> lines;
  for (const owl::Ontology::Omission& remark : source.remarks())
    lines.push_back(std::string(source.name(remark.construct)) + ", " + std::to_string(remark.count) + ", line " +
                    std::to_string(remark.line));
  return lines;
}

std::vector<std::string> Reading::labels() const { return rdf::labels(source); }

std::string ontology(std::string_view lines) {
  return "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" xml:base=\"http://e/\">\n" + std::string(lines) +
         "\n</Ontology>\n";
}

}  // namespace geminga::owlxml
