#include "owlxml/reading.hpp"

#include <utility>

#include "rdf/functional.hpp"

namespace geminga::owlxml {

Reading::Reading(std::string_view text, const Limits& limits) {
  auto result = read(text, source.add_file("t.owx"), source, limits);
  if (result) {
    document = std::move(*result);
  } else {
    error = result.error().file + ':' + std::to_string(result.error().line) + ": " + result.error().text;
  }
}

std::vector<std::string> Reading::axioms() const {
  std::vector<std::string> lines = rdf::functional(source, true);
  for (const el::OntologySource::Omission& omission : source.omissions())
    lines.push_back("left out: " + std::string(source.name(omission.construct)) + ", line " +
                    std::to_string(omission.line));
  return lines;
}

std::vector<std::string> Reading::labels() const {
  std::vector<std::string> lines;
  for (const el::OntologySource::Label& label : source.labels()) {
    const std::string language(source.name(label.language));
    lines.push_back(std::string(source.name(label.entity)) + ' ' + std::string(source.name(label.text)) +
                    (language.empty() ? "" : '@' + language));
  }
  return lines;
}

std::string ontology(std::string_view lines) {
  return "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" xml:base=\"http://e/\">\n" + std::string(lines) +
         "\n</Ontology>\n";
}

}  // namespace geminga::owlxml
