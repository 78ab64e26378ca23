// Links that make a class unsatisfiable, or derive something new within one ontology, are taken out, cheapest first.
#ifndef GEMINGA_ONTOLOGY_ALIGNMENT_MENDING_HPP
#define GEMINGA_ONTOLOGY_ALIGNMENT_MENDING_HPP

#include <string>
#include <vector>

#include "base/budget.hpp"
#include "ontology/alignment/matching.hpp"
#include "ontology/loading/classified_files.hpp"

namespace geminga::ontology {

/// A link that was taken out.
struct Rejected {
  Link link;
  std::string because;  ///< the consequence that was not wanted, in words
};

struct Mended {
  std::vector<Link> links;         ///< in the order in which they came
  std::vector<Rejected> rejected;  ///< in the order in which they were taken out
  bool is_certain = true;          ///< false: something unwanted may be left, because a question was not decided
};

/// The two ontologies that are linked, each classified by itself.
struct Sides {
  const ClassifiedFiles& one;
  const ClassifiedFiles& other;
  bool is_conservative = false;  ///< no new subsumption within either
};

/// Takes out links until the two ontologies with the links have no class that can have no instance and could before:
/// of each minimal set of axioms that entails such a thing, the link with the least confidence (the idea of LogMap:
/// Jimenez-Ruiz, Cuenca Grau 2011). `both` are all files together; links are added to it.
[[nodiscard]] Mended mend(rdf::Loaded& both, std::vector<Link> links, const Sides& sides, base::Budget& budget);

}  // namespace geminga::ontology

#endif
