// The questions that the base of a search depends on (lemma 8 of README.md).
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_SUPPOSITIONS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_SUPPOSITIONS_HPP

#include <cstddef>
#include <cstdint>

namespace geminga::hypertableau {

/// Says on which branch a question depends, and whether its model may become part of the base.
///
/// Each question is supposed: its facts depend on a branch without alternatives. The branches of all questions stand
/// before all choices, used or not, and so stay among the reasons of later branches.
class Suppositions {
 public:
  /// The most questions that leave something in a base with nominals.
  static constexpr std::uint32_t most = 1024;

  /// Suppositions for so many questions, one after the other.
  explicit Suppositions(std::uint32_t count) : count_(count) {}

  [[nodiscard]] std::uint32_t count() const { return count_; }
  [[nodiscard]] bool is_one(std::uint32_t branch) const { return branch < count_; }
  /// The branch of the question. Those before are of former questions, which the base has kept.
  [[nodiscard]] std::uint32_t current() const { return current_; }

  /// Whether a model that left the base, and so is a new model of the facts, may become the base.
  [[nodiscard]] bool may_keep() const { return current_ + 1 < count_; }
  /// Whether a model beside the base may become part of it, which took so many steps for so many facts. A question that
  /// former ones misled is asked again, beside a new model of the facts, which is dear. So not where too many were
  /// misled. Nor where a fact takes many steps: if the kept things are all neighbours of one individual, each thing
  /// that becomes one more looks through them.
  [[nodiscard]] bool may_keep_beside(std::size_t steps, std::size_t facts) const {
    return may_keep() && kept_for_one * misled_ < kept_ + kept_for_one && steps <= steps_a_fact * facts;
  }
  /// The model is kept, and the next question has a branch of its own.
  void keep() {
    ++current_;
    ++kept_;
  }
  void note_misled() { ++misled_; }
  /// The base depends on no question any more.
  void forget() { current_ = 0; }

 private:
  static constexpr std::size_t kept_for_one = 16;  ///< models, for each question that was misled
  static constexpr std::size_t steps_a_fact = 8;

  std::uint32_t count_;
  std::uint32_t current_ = 0;
  std::size_t kept_ = 0;
  std::size_t misled_ = 0;
};

}  // namespace geminga::hypertableau

#endif
