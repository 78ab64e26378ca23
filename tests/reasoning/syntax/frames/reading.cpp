#include "reasoning/syntax/frames/reading.hpp"

#include <utility>

#include "reasoning/syntax/rdf/functional.hpp"

namespace geminga::frames {

Reading::Reading(std::string_view text, const FrameLimits& limits, Declared declared) {
  look_ahead(text, declared, limits);
  auto result = read(text, source.add_file("t.omn"), source, declared, limits);
  if (result) {
    document = std::move(*result);
  } else {
    error = to_string(result.error());
  }
}

std::vector<std::string> Reading::axioms() const { return rdf::functional_with_left_out(source); }

std::vector<std::string> Reading::labels() const { return rdf::labels(source); }

std::vector<std::string> said(std::string_view lines) {
  const Reading reading(ontology(lines));
  if (!reading.error.empty()) return {reading.error};
  std::vector<std::string> axioms = reading.axioms();
  std::erase_if(axioms, [](const std::string& axiom) { return axiom.starts_with("Declaration("); });
  return axioms;
}

}  // namespace geminga::frames
