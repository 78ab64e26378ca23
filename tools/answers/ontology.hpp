// The answer to `query ontology` by the kinds of its lines, and as a JSON document.
#ifndef GEMINGA_ANSWERS_ONTOLOGY_HPP
#define GEMINGA_ANSWERS_ONTOLOGY_HPP

#include <boost/json/object.hpp>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::answers {

/// The lines of the answer by kind (src/discovery/participant/QUERIES.md).
struct Ontology {
  Record head;
  std::vector<Record> files;
  std::vector<Record> left_out;
  std::vector<Record> gaps;
  std::vector<Record> others;
  std::vector<Record> failures;  ///< errors of the last reading
};

[[nodiscard]] Ontology ontology_of(const Answer& answer);

[[nodiscard]] boost::json::object ontology_document(const Ontology& ontology);

}  // namespace geminga::answers

#endif
