// Records of the choices that were tried and of those that failed.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_CHOICE_RECORDS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_CHOICE_RECORDS_HPP

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "reasoning/dl/hypertableau/choice.hpp"

namespace geminga::hypertableau {

/// How often choices of one kind about one predicate were tried in this search, and how often they were to blame for a
/// clash.
class ChoiceRecords {
 public:
  void note_try(const Choice& choice) { ++record_of(choice).tries; }
  void note_failure(const Choice& choice) {
    ++record_of(choice).failures;
    has_failed_ = true;
  }
  [[nodiscard]] std::uint64_t failures_of(std::span<const Choice> alternatives);
  /// Whether a choice of this question failed.
  [[nodiscard]] bool has_failed() const { return has_failed_; }

  /// Sorts the alternatives by the order in which they are tried.
  void order_by_promise(std::vector<Choice>& alternatives);

  void begin_question() { has_failed_ = false; }
  void clear() { records_.clear(); }

 private:
  struct Record {
    std::uint64_t tries = 0;
    std::uint64_t failures = 0;
  };
  Record& record_of(const Choice& choice) {
    return records_[(std::uint64_t{choice.predicate} << 8) | static_cast<std::uint64_t>(choice.kind)];
  }

  std::unordered_map<std::uint64_t, Record> records_;
  bool has_failed_ = false;
};

}  // namespace geminga::hypertableau

#endif
