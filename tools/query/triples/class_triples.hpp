// Class expressions of the team as OWL writes them in RDF, so that what reads the export can infer with them.
#ifndef GEMINGA_QUERY_TRIPLES_CLASS_TRIPLES_HPP
#define GEMINGA_QUERY_TRIPLES_CLASS_TRIPLES_HPP

#include <string_view>

#include "query/triples/triples.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::query {

/// Collects individuals with the expressions that they are instances of.
class ClassTriples {
 public:
  ClassTriples() : file_(source_.add_file("")) {}

  /// Says that an individual is an instance of an expression in Manchester syntax with full IRIs. An expression that
  /// cannot be read is left out: it may be anybody's. False: it is one.
  bool add(std::string_view individual_iri, std::string_view expression);
  /// Adds the triples of all of them, each expression as a blank node.
  void write(Triples& triples) const;

 private:
  owl::Ontology source_;
  owl::FileId file_;
};

}  // namespace geminga::query

#endif
