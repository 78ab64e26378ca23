// The living team as RDF in the words of ontology/team.ttl.
#ifndef GEMINGA_QUERY_TRIPLES_TEAM_GRAPH_HPP
#define GEMINGA_QUERY_TRIPLES_TEAM_GRAPH_HPP

#include <string>
#include <vector>

#include "geminga/client.hpp"
#include "query/triples/triples.hpp"

namespace geminga::query {

/// The answers to `query participants`, and to `services`, twice, and `requests` with `iris=1`.
struct Team {
  std::vector<Record> participants;
  std::vector<Record> descriptions;  ///< `services` of mode participant
  std::vector<Record> services;
  std::vector<Record> requests;
};

/// The document, in the order of the records. An offered class is the type of the publication's information, and what
/// describes a participant its type, so that what is subsumed is found by inference; a class expression is one as OWL
/// writes it, and beside that a text. Attributes are properties of https://geminga.example/attribute#, which are
/// declared. Linear in the records.
[[nodiscard]] std::string team_document(const Team& team, TripleSyntax syntax);

}  // namespace geminga::query

#endif
