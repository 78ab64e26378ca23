// The words of transcripts (discovery/participant/transcripts/README.md), whoever plays them.
#ifndef GEMINGA_TESTS_SUPPORT_TRANSCRIPT_WORDS_HPP
#define GEMINGA_TESTS_SUPPORT_TRANSCRIPT_WORDS_HPP

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::test {

/// Takes the first word off.
[[nodiscard]] std::string next_word(std::string_view& rest);
/// Turns \r, \n, \t, \\ and \xHH into what they stand for.
[[nodiscard]] std::string unescaped(std::string_view text);

/// What `{name}` stands for in one file.
class BoundWords {
 public:
  /// With what was told before in place of each `{name}`, and a hundred x in place of `{x*100}`; nothing where a name
  /// is not known yet.
  [[nodiscard]] std::optional<std::string> substituted(std::string_view text) const;
  /// Whether a line is as the pattern says. What its names stand for is known from then on.
  [[nodiscard]] bool matches(std::string_view pattern, const std::string& text);

 private:
  std::map<std::string, std::string> bound_;
};

}  // namespace geminga::test

#endif
