// The names of constructs.
#include "reasoning/owl/construct.hpp"

#include <array>

namespace geminga::owl {

std::string_view to_string(Construct construct) {
  static constexpr std::array<std::string_view, 31> words = {
      "",
      "owl:unionOf",
      "owl:complementOf",
      "owl:oneOf",
      "owl:allValuesFrom",
      "owl:minCardinality over 1",
      "owl:maxCardinality",
      "owl:inverseOf",
      "owl:FunctionalProperty",
      "owl:InverseFunctionalProperty",
      "owl:SymmetricProperty",
      "owl:AsymmetricProperty",
      "owl:propertyDisjointWith",
      "owl:topObjectProperty",
      "owl:hasKey",
      "owl:disjointUnionOf",
      "rdfs:range of a property chain",
      "owl:withRestrictions",
      "owl:datatypeComplementOf",
      "owl:unionOf data ranges",
      "nominals in too many classes",
      "datatypes with finitely many values",
      "functional properties with too many successors",
      "datatypes that overlap",
      "literals whose equality is not known",
      "owl:maxCardinality of a property that is not simple",
      "owl:FunctionalProperty of a property that is not simple",
      "owl:InverseFunctionalProperty of a property that is not simple",
      "owl:IrreflexiveProperty of a property that is not simple",
      "owl:hasSelf of a property that is not simple",
      "swrl:Imp",
  };
  return words[static_cast<std::size_t>(construct)];
}

}  // namespace geminga::owl
