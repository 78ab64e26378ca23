// Documents as published ones are written: relative names against bases of all shapes, entities, UTF-16, empty IRIs,
// leftovers of OWL 1, literals that are not of their datatype.
#ifndef GEMINGA_TESTS_COMPARE_DISGUISES_HPP
#define GEMINGA_TESTS_COMPARE_DISGUISES_HPP

#include <cstdint>
#include <string>

#include "reasoning/owl/source.hpp"

namespace geminga::compare {

/// One ontology, written twice.
struct Disguised {
  std::string file_name;
  std::string plain;     ///< whole names, UTF-8
  std::string document;  ///< the same in disguise
};

/// The parts of a disguise.
enum class Disguise : std::uint8_t {
  all,
  as_others_read,  ///< without what other reasoners are known to read otherwise or not at all
};

/// The axioms of a random ontology or shape, with a declaration of every name. The same for the same arguments.
[[nodiscard]] Disguised in_owl_xml(const owl::Ontology& source, std::uint64_t seed, Disguise disguise);
[[nodiscard]] Disguised in_rdf_xml(const owl::Ontology& source, std::uint64_t seed, Disguise disguise);

}  // namespace geminga::compare

#endif
