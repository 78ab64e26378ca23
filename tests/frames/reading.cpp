#include "frames/reading.hpp"

#include <utility>

#include "rdf/functional.hpp"

namespace geminga::frames {

Reading::Reading(std::string_view text, const Limits& limits, Declared declared) {
  look_ahead(text, declared, limits);
  auto result = read(text, source.add_file("t.omn"), source, declared, limits);
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

std::vector<std::string> said(std::string_view lines) {
  const Reading reading(ontology(lines));
  if (!reading.error.empty()) return {reading.error};
  std::vector<std::string> axioms = reading.axioms();
  std::erase_if(axioms, [](const std::string& axiom) { return axiom.starts_with("Declaration("); });
  return axioms;
}

}  // namespace geminga::frames
