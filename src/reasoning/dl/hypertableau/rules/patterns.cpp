#include "reasoning/dl/hypertableau/rules/patterns.hpp"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace geminga::hypertableau {
namespace {

/// Octets of a compiled pattern with its caches.
constexpr std::int64_t max_pattern_memory = std::int64_t{1} << 18;
constexpr std::size_t max_groups = 10;  ///< that a replacement can name, with the whole match

/// Characters that stand for themselves behind a backslash, in both syntaxes.
constexpr std::string_view punctuation = R"(\|.?*+(){}-[]^$)";

/// The general categories of Unicode that are named alike and mean the same. C and Cn hold characters that are not
/// assigned, which RE2 does not count.
constexpr std::string_view categories[] = {"L",  "Lu", "Ll", "Lt", "Lm", "Lo", "M",  "Mn", "Mc", "Me", "N", "Nd",
                                           "Nl", "No", "P",  "Pc", "Pd", "Ps", "Pe", "Pi", "Pf", "Po", "Z", "Zs",
                                           "Zl", "Zp", "S",  "Sm", "Sc", "Sk", "So", "Cc", "Cf", "Co"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads a pattern and writes it for RE2, until something is not known.
class Translation {
 public:
  explicit Translation(std::string_view pattern) : pattern_(pattern) {}

  std::optional<std::string> run() {
    while (!is_over()) {
      if (!take_piece()) return std::nullopt;
    }
    if (open_groups_ > 0) return std::nullopt;
    return std::move(written_);
  }

 private:
  [[nodiscard]] bool is_over() const { return at_ >= pattern_.size(); }
  [[nodiscard]] char here() const { return is_over() ? '\0' : pattern_[at_]; }
  [[nodiscard]] bool is_next(std::string_view text) const { return pattern_.substr(at_).starts_with(text); }
  void copy(std::size_t count = 1) {
    written_ += pattern_.substr(at_, count);
    at_ += count;
  }
  void put(std::string_view text, std::size_t instead_of) {
    written_ += text;
    at_ += instead_of;
  }

  bool take_piece() {
    switch (here()) {
      case '(':
        if (is_next("(?") && !is_next("(?:")) return false;
        copy(is_next("(?") ? 3 : 1);
        ++open_groups_;
        can_repeat_ = false;
        return true;
      case ')':
        if (open_groups_ == 0) return false;
        --open_groups_;
        copy();
        can_repeat_ = true;
        return true;
      case '|':
      case '^':
      case '$':
        copy();
        can_repeat_ = false;
        return true;
      case '*':
      case '+':
      case '?':
      case '{':
        return take_quantifier();
      case '}':
      case ']':
        return false;
      case '[':
        can_repeat_ = true;
        return take_class();
      case '\\':
        can_repeat_ = true;
        return take_escape(false);
      default:
        copy();
        can_repeat_ = true;
        return true;
    }
  }

  bool take_quantifier() {
    if (!can_repeat_) return false;
    can_repeat_ = false;
    if (here() == '{') {
      const std::size_t end = pattern_.find('}', at_);
      if (end == std::string_view::npos) return false;
      const std::string_view counts = pattern_.substr(at_ + 1, end - at_ - 1);
      const std::size_t comma = std::min(counts.find(','), counts.size());
      const auto is_number = [](std::string_view text) { return std::ranges::all_of(text, is_digit); };
      const std::string_view most = counts.substr(std::min(comma + 1, counts.size()));
      if (comma == 0 || !is_number(counts.substr(0, comma)) || !is_number(most)) return false;
      copy(counts.size() + 2);
    } else {
      copy();
    }
    if (here() == '?') copy();
    return true;
  }

  bool take_escape(bool is_in_class) {
    if (at_ + 1 >= pattern_.size()) return false;
    const char kind = pattern_[at_ + 1];
    const auto set = [&](std::string_view members, bool is_complement) {
      if (is_in_class) {
        written_ += members;
      } else {
        written_.append(is_complement ? "[^" : "[").append(members) += ']';
      }
      at_ += 2;
      return true;
    };
    constexpr std::string_view spaces = R"( \t\n\r)";
    constexpr std::string_view of_words = R"(\p{L}\p{M}\p{N}\p{S})";
    switch (kind) {
      case 'n':
      case 'r':
      case 't':
        copy(2);
        return true;
      case 'd':
        put(R"(\p{Nd})", 2);
        return true;
      case 'D':
        put(R"(\P{Nd})", 2);
        return true;
      case 's':
        return set(spaces, false);
      case 'S':
        return is_in_class ? set(R"(\x00-\x08\x0B\x0C\x0E-\x1F\x21-\x{10FFFF})", false) : set(spaces, true);
      case 'w':
        return set(of_words, false);
      case 'W':
        return !is_in_class && set(of_words, true);
      case 'p':
      case 'P':
        return take_category();
      default:
        if (punctuation.find(kind) == std::string_view::npos) return false;
        copy(2);
        return true;
    }
  }

  bool take_category() {
    const std::size_t end = pattern_.find('}', at_);
    if (end == std::string_view::npos || pattern_.substr(at_ + 2, 1) != "{") return false;
    const std::string_view name = pattern_.substr(at_ + 3, end - at_ - 3);
    if (std::ranges::find(categories, name) == std::end(categories)) return false;
    copy(end + 1 - at_);
    return true;
  }

  bool take_class() {
    copy();
    if (here() == '^') copy();
    for (bool is_first = true;; is_first = false) {
      if (is_over()) return false;
      if (here() == ']') {
        copy();
        return !is_first;
      }
      if (!take_member(is_first)) return false;
    }
  }

  /// A character, a range of them, or an escape, in a class.
  bool take_member(bool is_first) {
    if (here() == '-') {
      if (!is_first && !is_next("-]")) return false;
      put(R"(\-)", 1);
      return here() != '-';
    }
    bool is_single = false;
    if (!take_member_character(is_single)) return false;
    if (here() != '-' || is_next("-]")) return true;
    if (!is_single) return false;
    copy();
    return here() != '-' && take_member_character(is_single) && is_single && (here() != '-' || is_next("-]"));
  }

  bool take_member_character(bool& is_single) {
    const char c = here();
    if (is_over() || c == '[' || c == ']') return false;
    if (c == '\\') {
      is_single =
          at_ + 1 < pattern_.size() && (std::string_view("nrt").find(pattern_[at_ + 1]) != std::string_view::npos ||
                                        punctuation.find(pattern_[at_ + 1]) != std::string_view::npos);
      return take_escape(true);
    }
    is_single = true;
    if (c == '^') {
      put(R"(\^)", 1);
      return true;
    }
    // All octets of one character.
    do {
      copy();
    } while (!is_over() && (static_cast<unsigned char>(here()) & 0xC0U) == 0x80U);
    return true;
  }

  std::string_view pattern_;
  std::string written_;
  std::size_t at_ = 0;
  std::size_t open_groups_ = 0;
  bool can_repeat_ = false;
};

/// The compiled pattern for a text; null where it is not known what matches. A dot does not match a carriage return in
/// some versions of XPath.
std::unique_ptr<RE2> compiled(std::string_view pattern, std::string_view text) {
  if (text.find('\r') != std::string_view::npos && pattern.find('.') != std::string_view::npos) return nullptr;
  const auto translated = as_re2(pattern);
  if (!translated) return nullptr;
  RE2::Options options;
  options.set_log_errors(false);
  options.set_max_mem(max_pattern_memory);
  auto made = std::make_unique<RE2>(*translated, options);
  return made->ok() ? std::move(made) : nullptr;
}

/// Appends what a replacement means of one match. False where it is no replacement.
bool append(std::string& result, std::string_view replacement, const std::vector<re2::StringPiece>& groups) {
  for (std::size_t at = 0; at < replacement.size(); ++at) {
    const char c = replacement[at];
    if (c != '\\' && c != '$') {
      result += c;
      continue;
    }
    if (++at == replacement.size()) return false;
    const char next = replacement[at];
    if (c == '\\') {
      if (next != '\\' && next != '$') return false;
      result += next;
      continue;
    }
    if (!is_digit(next)) return false;
    // Two digits name a group only where there are ten.
    const auto group = static_cast<std::size_t>(next - '0');
    if (group < groups.size()) result.append(groups[group].data(), groups[group].size());
  }
  return true;
}

}  // namespace

std::optional<std::string> as_re2(std::string_view pattern) {
  if (pattern.size() > max_pattern_octets) return std::nullopt;
  return Translation(pattern).run();
}

std::optional<bool> has_match(std::string_view text, std::string_view pattern) {
  const auto compiled_pattern = compiled(pattern, text);
  if (compiled_pattern == nullptr) return std::nullopt;
  return RE2::PartialMatch(re2::StringPiece(text.data(), text.size()), *compiled_pattern);
}

std::optional<std::string> replaced(std::string_view text, std::string_view pattern, std::string_view replacement,
                                    std::size_t most) {
  const auto compiled_pattern = compiled(pattern, text);
  if (compiled_pattern == nullptr || RE2::FullMatch("", *compiled_pattern)) return std::nullopt;
  const auto count = static_cast<std::size_t>(compiled_pattern->NumberOfCapturingGroups()) + 1;
  if (count > max_groups) return std::nullopt;
  std::vector<re2::StringPiece> groups(count);
  if (std::string unused; !append(unused, replacement, groups)) return std::nullopt;
  const re2::StringPiece whole(text.data(), text.size());
  std::string result;
  std::size_t at = 0;
  while (compiled_pattern->Match(whole, at, text.size(), RE2::UNANCHORED, groups.data(), static_cast<int>(count))) {
    const auto begin = static_cast<std::size_t>(groups[0].data() - text.data());
    if (groups[0].empty()) return std::nullopt;
    result += text.substr(at, begin - at);
    if (!append(result, replacement, groups) || result.size() > most) return std::nullopt;
    at = begin + groups[0].size();
  }
  result += text.substr(at);
  if (result.size() > most) return std::nullopt;
  return result;
}

}  // namespace geminga::hypertableau
