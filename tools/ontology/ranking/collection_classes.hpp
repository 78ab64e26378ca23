// The classes of a collection's ontologies. Each ontology is read and classified with its imports alone, so that a
// fault in one costs no other.
#ifndef GEMINGA_ONTOLOGY_RANKING_COLLECTION_CLASSES_HPP
#define GEMINGA_ONTOLOGY_RANKING_COLLECTION_CLASSES_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ontology/command/limits.hpp"

namespace geminga::ontology {

/// The named classes of all ontologies together, and their inclusions. Classes are numbers in the order of reading.
struct CollectionClasses {
  std::vector<std::string> iris;
  std::vector<bool> is_declared;  ///< by class: an ontology declares it
  /// Names of files without their folders, each with a class that the file declares.
  std::vector<std::pair<std::string, std::uint32_t>> declared_in;
  std::unordered_map<std::string, std::uint32_t> number_of;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> inclusions;  ///< subclass, superclass
  std::size_t files = 0;                                            ///< read
  std::vector<std::string> problems;                                ///< lines that name broken files
  std::vector<std::string> remarks;                                 ///< lines that name incomplete results

  std::uint32_t add(std::string_view iri);
};

/// Reads files and folders. A broken file of triples counts up to its fault. An ontology that contradicts itself, or is
/// not classified within the limits, counts as it is written.
[[nodiscard]] CollectionClasses read_collection(const std::vector<std::string>& files,
                                                const std::vector<std::string>& folders, const WorkLimits& limits);

}  // namespace geminga::ontology

#endif
