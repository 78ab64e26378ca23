// A small team as an ontology, for tests of the programs that write ontologies.
#ifndef GEMINGA_TESTS_TOOLS_ONTOLOGY_TEAM_HPP
#define GEMINGA_TESTS_TOOLS_ONTOLOGY_TEAM_HPP

#include <string>
#include <string_view>

#include "program.hpp"

namespace geminga::ontology {

/// Robots that are defined by their tasks, and an individual that is one by its task.
inline constexpr std::string_view team =
    "<http://e/> a owl:Ontology ; rdfs:comment \"the team\" . "
    ":Thing a owl:Class . :Robot a owl:Class ; rdfs:subClassOf :Thing . :sees a owl:ObjectProperty ; rdfs:domain "
    ":Robot . "
    ":observes a owl:ObjectProperty ; rdfs:subPropertyOf :sees . :Goalie a owl:Class ; owl:equivalentClass "
    "[ owl:intersectionOf ( :Robot [ a owl:Restriction ; owl:onProperty :observes ; owl:someValuesFrom :Thing ] ) ] . "
    ":Keeper a owl:Class ; owl:equivalentClass :Goalie . :Ball a owl:Class ; rdfs:subClassOf :Thing . "
    ":ball a :Ball . :bob :observes :ball . :observes rdfs:comment \"a comment\" .";

/// The closure that `classify` prints for a file; where it fails, its errors.
inline std::string closure_of(const Program& program, const std::string& file) {
  const Outcome outcome = program.run({"classify", "--closure", file});
  return outcome.status == 0 ? outcome.out : outcome.err;
}

}  // namespace geminga::ontology

#endif
