#include "functional/reading.hpp"

#include "rdf/functional.hpp"

namespace geminga::functional {

std::vector<std::string> Reading::axioms() const {
  std::vector<std::string> lines = rdf::functional(source, true);
  for (const el::OntologySource::Omission& omission : source.omissions())
    lines.push_back("left out: " + std::string(source.name(omission.construct)) + ", " +
                    std::to_string(omission.count) + ", line " + std::to_string(omission.line));
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

}  // namespace geminga::functional
