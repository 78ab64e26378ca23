// The known and the possible subsumers of each class: two bounds between which a taxonomy is completed.
#ifndef GEMINGA_REASONING_REASONER_SUBSUMERS_HPP
#define GEMINGA_REASONING_REASONER_SUBSUMERS_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "reasoning/reasoner/taxonomy.hpp"

namespace geminga::reasoner {

/// Representatives of classes, ascending.
using ClassNumbers = std::vector<std::uint32_t>;

/// The subsumers of each class, by representatives of the classification: at first those of a taxonomy that may be
/// incomplete. Derivation and answers add to what is known, and models take from what is possible.
class Subsumers {
 public:
  explicit Subsumers(const taxonomy::Classification& classification);

  [[nodiscard]] std::uint32_t representative(std::uint32_t of) const {
    return static_cast<std::uint32_t>(classification_.representative[of]);
  }
  /// Whether this class stands for its node and is neither owl:Thing nor owl:Nothing.
  [[nodiscard]] bool is_asked(std::uint32_t of) const {
    return representative(of) == of && of != top_ && of != bottom_;
  }
  [[nodiscard]] std::uint32_t top() const { return top_; }
  /// The known ones, strictly above the class and without owl:Thing.
  [[nodiscard]] const ClassNumbers& known(std::uint32_t of) const { return known_[of]; }
  /// Whether some model has shown an instance of the class, or its subsumers are all known.
  [[nodiscard]] bool has_bound(std::uint32_t of) const { return possible_[of].has_value(); }
  [[nodiscard]] bool is_empty(std::uint32_t of) const { return is_empty_[of]; }
  /// Whether all subsumers of the class are known, or that it is empty.
  [[nodiscard]] bool is_closed(std::uint32_t of) const;
  /// Whether the second may be above the first. Some model has shown an instance of the first.
  [[nodiscard]] bool is_open(std::uint32_t of, std::uint32_t above) const;
  /// Classes that may be above this one, the most specific first: a yes answers all of its subsumers.
  [[nodiscard]] ClassNumbers open_above(std::uint32_t of) const;
  /// The classes with the most subsumers first: their models are models of all their subsumers, too.
  [[nodiscard]] ClassNumbers lowest_first() const;

  /// The class has no subsumers but those that are known.
  void close(std::uint32_t of) { possible_[of] = known_[of]; }
  /// A model has an instance that is in these classes and in no others.
  void learn(const ClassNumbers& label);
  /// Some model has an instance that is in this class and its known subsumers, and in no other class.
  void learn_plain(std::uint32_t of);
  void add(std::uint32_t sub, std::uint32_t super);
  void set_empty(std::uint32_t of);
  /// Adds what was found about the known subsumers of the class.
  void inherit(std::uint32_t of);

  /// All that was added, which follows if the callers were right.
  [[nodiscard]] const Subsumptions& found() const { return found_; }

 private:
  void narrow(std::uint32_t of, const ClassNumbers& label, std::size_t closed);

  const taxonomy::Classification& classification_;
  std::uint32_t top_;
  std::uint32_t bottom_;
  std::vector<ClassNumbers> known_;
  std::vector<std::optional<ClassNumbers>> possible_;  ///< the class itself (but owl:Thing) included
  std::vector<bool> is_empty_;
  Subsumptions found_;
};

}  // namespace geminga::reasoner

#endif
