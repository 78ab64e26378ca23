// The classes and properties of one ontology as an alignment sees them: their names in words, and their neighbours.
#ifndef GEMINGA_ONTOLOGY_ALIGNMENT_LEXICON_HPP
#define GEMINGA_ONTOLOGY_ALIGNMENT_LEXICON_HPP

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// A name in words.
struct EntityName {
  std::vector<std::string> words;
  std::string preposition;  ///< of a property (words.hpp)
  double worth = 1;         ///< in (0, 1]: less for one that no file gives, but that others may give the entity
};

/// A class or a property.
struct LexiconEntry {
  owl::TermKind kind{};
  std::string iri;
  /// The words of its local name, its labels and its synonyms, each once; the local name first. Then these without the
  /// words that every name of the ontology may have, or that a property's domain and range have.
  std::vector<EntityName> names;
  /// Of a class: the classes that are told above and below it. Of a property: those of its domain, and of its range.
  std::vector<std::uint32_t> above;
  std::vector<std::uint32_t> below;
};

/// The entities that an ontology declares or describes, without those of reserved vocabularies. Requires annotations.
class Lexicon {
 public:
  explicit Lexicon(const rdf::Loaded& loaded);

  [[nodiscard]] const std::vector<LexiconEntry>& entities() const { return entities_; }

 private:
  void add_names(const rdf::Loaded& loaded);
  void add_neighbours(const owl::Ontology& source);
  void add_shorter_names();

  std::vector<LexiconEntry> entities_;                          ///< by IRI and kind
  std::unordered_map<std::uint32_t, std::uint32_t> number_of_;  ///< by term
};

}  // namespace geminga::ontology

#endif
