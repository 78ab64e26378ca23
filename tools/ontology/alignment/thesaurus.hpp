// The synonyms of English words, from WordNet's index files (Fellbaum: WordNet, an Electronic Lexical Database, 1998;
// the format is wndb(5WN)). Debian has them in wordnet-base.
#ifndef GEMINGA_ONTOLOGY_ALIGNMENT_THESAURUS_HPP
#define GEMINGA_ONTOLOGY_ALIGNMENT_THESAURUS_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::ontology {

/// Where Debian installs WordNet.
inline constexpr std::string_view wordnet_folder = "/usr/share/wordnet";

/// Nouns and verbs with their senses. Immutable once it is read.
class Thesaurus {
 public:
  /// A sense of a word: words of one sense are synonyms.
  struct Sense {
    std::uint64_t number = 0;  ///< senses of verbs and of nouns have different ones
    bool is_frequent = false;  ///< one of the word's first two
  };
  /// Rarer senses of a word are not looked at.
  static constexpr std::size_t most_senses = 4;
  /// A longer index file is refused.
  static constexpr std::size_t most_octets = 64U << 20U;

  /// Knows no word.
  Thesaurus() = default;
  /// Reads index.noun and index.verb of a folder; the error names the file.
  [[nodiscard]] static std::expected<Thesaurus, std::string> read(const std::filesystem::path& folder);

  /// The senses of a word in small letters, or of several joined by `_`; none for an unknown one. A form of a verb in
  /// -ed or -ing has those of the verb.
  [[nodiscard]] std::vector<Sense> senses_of(std::string_view lemma) const;

 private:
  /// The text of a file, and where each of its lines begins, by lemma.
  struct Index {
    std::string text;
    std::vector<std::uint32_t> lines;
  };
  [[nodiscard]] static std::expected<Index, std::string> read_index(const std::filesystem::path& file);
  static void add_senses(const Index& index, std::string_view lemma, std::uint64_t part_of_speech,
                         std::vector<Sense>& senses);

  Index nouns_;
  Index verbs_;
};

}  // namespace geminga::ontology

#endif
