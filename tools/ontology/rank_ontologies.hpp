// The ontologies of a collection of services: each is read and classified for itself with what it imports, so that what
// is wrong with one costs no other.
#ifndef GEMINGA_ONTOLOGY_RANK_ONTOLOGIES_HPP
#define GEMINGA_ONTOLOGY_RANK_ONTOLOGIES_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "limits.hpp"

namespace geminga::ontology {

/// Which named class is above which, in all ontologies together. Classes are numbers in the order of reading.
struct CollectionClasses {
  std::vector<std::string> iris;
  std::vector<bool> is_declared;  ///< by class: some ontology says that it is one
  /// The names of files without their folders, and a class that each declares.
  std::vector<std::pair<std::string, std::uint32_t>> declared_in;
  std::unordered_map<std::string, std::uint32_t> number_of;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> inclusions;  ///< subclass, superclass
  std::size_t files = 0;                                            ///< that were read
  std::vector<std::string> problems;                                ///< a line each: files that are broken
  std::vector<std::string> remarks;                                 ///< what is less than it could be

  std::uint32_t add(std::string_view iri);
};

/// Reads files and folders, as load() names them. An ontology of triples that is broken counts up to there; one that
/// contradicts itself, and one that is not classified within the limits, counts as it is written.
[[nodiscard]] CollectionClasses read_collection(const std::vector<std::string>& files,
                                                const std::vector<std::string>& folders, const WorkLimits& limits);

}  // namespace geminga::ontology

#endif
