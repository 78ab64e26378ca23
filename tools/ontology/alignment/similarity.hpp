// How alike two names are, word by word.
#ifndef GEMINGA_ONTOLOGY_ALIGNMENT_SIMILARITY_HPP
#define GEMINGA_ONTOLOGY_ALIGNMENT_SIMILARITY_HPP

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "ontology/alignment/lexicon.hpp"
#include "ontology/alignment/thesaurus.hpp"

namespace geminga::ontology {

/// Compares names of two ontologies: a word counts the more, the rarer it is in both (soft TF-IDF: Cohen, Ravikumar,
/// Fienberg: A Comparison of String Distance Metrics for Name-Matching Tasks, 2003). Synonyms, initials of several
/// words and words that are written together count, too.
class Similarity {
 public:
  Similarity(const Lexicon& one, const Lexicon& other, const Thesaurus& thesaurus);

  /// In [0, 1]: 1 for equal words in any order.
  [[nodiscard]] double of(const EntityName& one, const EntityName& other, bool are_classes) const;

  /// Names that share no key are not alike. A key is the beginning of a word, a sense of it or of the whole name, all
  /// words written together, or the initials of words that follow one another.
  [[nodiscard]] std::vector<std::string> keys_of(const EntityName& name) const;

 private:
  struct Word {
    std::size_t count = 0;
    std::vector<Thesaurus::Sense> senses;
  };

  void count(const Lexicon& lexicon, const Thesaurus& thesaurus);
  [[nodiscard]] double weight(const std::string& word) const;
  [[nodiscard]] double alike(const std::string& one, const std::string& other) const;
  [[nodiscard]] double by_meaning(const std::vector<std::string>& one, const std::vector<std::string>& other) const;
  [[nodiscard]] double by_words(const std::vector<std::string>& one, const std::vector<std::string>& other) const;

  std::unordered_map<std::string, Word> words_;
  std::unordered_map<std::string, std::vector<Thesaurus::Sense>> phrases_;  ///< the senses of names of several words
  std::size_t names_ = 1;
};

}  // namespace geminga::ontology

#endif
