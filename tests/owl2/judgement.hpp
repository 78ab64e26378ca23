// Whether an answer to a question is as it must be, and the table of those that need not be answered.
#ifndef GEMINGA_TESTS_OWL2_JUDGEMENT_HPP
#define GEMINGA_TESTS_OWL2_JUDGEMENT_HPP

#include <expected>
#include <map>
#include <string>
#include <string_view>

namespace geminga::owl2 {

/// Question to reason, as OUTSIDE.tsv has them.
using Outside = std::map<std::string, std::string, std::less<>>;

/// Reads `NAME<TAB>REASON` lines; those that begin with `#` say nothing. The error says which line is wrong.
[[nodiscard]] std::expected<Outside, std::string> read_outside(std::string_view text);

struct Judgement {
  bool is_passed = false;
  std::string words;
};

/// Judges an exit status of `consistent` or `entails`: 0 yes, 1 no, anything else no answer. A wrong answer never
/// passes. No answer passes only for a question outside, and an answer fails for one, so that the table stays true.
[[nodiscard]] Judgement judge(std::string_view question, bool is_yes, int status, const Outside& outside);

}  // namespace geminga::owl2

#endif
