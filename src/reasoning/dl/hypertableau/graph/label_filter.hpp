// A filter of the label of a node: most facts that are not there are known from one cache line not to be.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_GRAPH_LABEL_FILTER_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_GRAPH_LABEL_FILTER_HPP

#include <algorithm>
#include <array>
#include <cstdint>

namespace geminga::hypertableau {

/// A Bloom filter with one hash function (Bloom: Space/time trade-offs in hash coding with allowable errors, 1970), of
/// concepts and, apart from them, of number restrictions and ranges, because a node has many of one and few of the
/// other. 192 bits answer for four of five absent concepts beside 40 present ones. A fact that is taken back leaves its
/// bit, so that a filter may claim too much but never too little.
class LabelFilter {
 public:
  void add_concept(std::uint32_t predicate) {
    const std::uint32_t bit = bit_of_concept(predicate);
    words_[bit / word_bits] |= std::uint64_t{1} << (bit % word_bits);
  }
  [[nodiscard]] bool may_have_concept(std::uint32_t predicate) const {
    const std::uint32_t bit = bit_of_concept(predicate);
    return (words_[bit / word_bits] >> (bit % word_bits) & 1U) != 0;
  }
  void forget_concepts() { std::fill_n(words_.begin(), concept_words, 0U); }

  /// Another part of the label. The kind is less than 8.
  void add_other(std::uint32_t kind, std::uint32_t predicate) { words_.back() |= bit_of_other(kind, predicate); }
  [[nodiscard]] bool may_have_other(std::uint32_t kind, std::uint32_t predicate) const {
    return (words_.back() & bit_of_other(kind, predicate)) != 0;
  }

 private:
  static constexpr std::uint32_t word_bits = 64;
  static constexpr std::uint32_t concept_words = 3;

  [[nodiscard]] static constexpr std::uint32_t hash_of(std::uint32_t number) { return number * 0x9e3779b1U; }
  [[nodiscard]] static constexpr std::uint32_t bit_of_concept(std::uint32_t predicate) {
    return static_cast<std::uint32_t>((std::uint64_t{hash_of(predicate)} * concept_words * word_bits) >> 32);
  }
  [[nodiscard]] static constexpr std::uint64_t bit_of_other(std::uint32_t kind, std::uint32_t predicate) {
    return std::uint64_t{1} << (hash_of((predicate << 3) | kind) >> 26);
  }

  std::array<std::uint64_t, concept_words + 1> words_{};
};

}  // namespace geminga::hypertableau

#endif
