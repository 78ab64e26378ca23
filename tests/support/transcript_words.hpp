// The words of transcripts (discovery/participant/transcripts/README.md), for all programs that play them.
#ifndef GEMINGA_TESTS_SUPPORT_TRANSCRIPT_WORDS_HPP
#define GEMINGA_TESTS_SUPPORT_TRANSCRIPT_WORDS_HPP

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::test {

/// Removes the first word and returns it.
[[nodiscard]] std::string next_word(std::string_view& rest);
/// Replaces \r, \n, \t, \\ and \xHH by their octets.
[[nodiscard]] std::string unescaped(std::string_view text);

/// The values of each `{name}` in one file.
class BoundWords {
 public:
  /// The text with its values for each `{name}`, and a hundred x for `{x*100}`; nothing if a name is not known yet.
  [[nodiscard]] std::optional<std::string> substituted(std::string_view text) const;
  /// Whether a line matches the pattern. From then on the values of its names are known.
  [[nodiscard]] bool matches(std::string_view pattern, const std::string& text);

 private:
  std::map<std::string, std::string> bound_;
};

}  // namespace geminga::test

#endif
