// Records of the choices that were tried and of those that failed.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_CHOICE_RECORDS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_CHOICE_RECORDS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/hypertableau/facts/choice.hpp"

namespace geminga::hypertableau {

/// How often choices of one kind about one predicate were tried in this search, and how often they were to blame for a
/// clash. Those that meet a neighbour have a record of their own.
class ChoiceRecords {
 public:
  void note_try(const Choice& choice) { ++record_of(choice).tries; }
  void note_failure(const Choice& choice) {
    ++record_of(choice).failures;
    has_failed_ = true;
  }
  /// Whether the choice failed more often than not.
  [[nodiscard]] bool is_hopeless(const Choice& choice) const;
  /// Of their kinds, whether they meet a neighbour or not.
  [[nodiscard]] std::uint64_t failures_of(std::span<const Choice> alternatives);
  /// Whether a choice of this question failed.
  [[nodiscard]] bool has_failed() const { return has_failed_; }

  /// Sorts the alternatives by the order in which they are tried.
  void order_by_promise(std::vector<Choice>& alternatives, const Burdens& burdens);

  void begin_question() { has_failed_ = false; }
  void clear() { records_ = {}; }

 private:
  struct Record {
    std::uint64_t tries = 0;
    std::uint64_t failures = 0;
  };
  using Records = std::array<Record, 4>;  ///< by whether a neighbour is met, and whether neighbours are too many
  Records& records_of(const Choice& choice) {
    std::vector<Records>& records = records_[static_cast<std::size_t>(choice.kind)];
    if (choice.predicate >= records.size()) records.resize(choice.predicate + std::size_t{1});
    return records[choice.predicate];
  }
  Record& record_of(const Choice& choice) {
    return records_of(choice)[(choice.meets_neighbour ? 1U : 0U) + (choice.crowds ? 2U : 0U)];
  }

  static constexpr std::size_t kind_count = static_cast<std::size_t>(ChoiceKind::make_neighbours) + 1;
  /// By kind and predicate.
  std::array<std::vector<Records>, kind_count> records_;
  bool has_failed_ = false;
};

}  // namespace geminga::hypertableau

#endif
