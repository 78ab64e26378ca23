#include "manual/man_page.hpp"

#include <utf8.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <string_view>

namespace geminga::manual {
namespace {

/// Words that begin a section where a line below the flags begins with one of them and a colon.
constexpr auto headings = std::to_array<std::string_view>({"Examples", "Environment", "Signals", "Exit status"});

char in_upper_case(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string upper(std::string_view text) {
  std::string word(text);
  std::ranges::transform(word, word.begin(), in_upper_case);
  return word;
}

/// Escapes a text for roff: characters that roff interprets, or that its fonts show otherwise.
std::string escaped(std::string_view text) {
  std::string valid;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  std::string roff;
  for (auto at = valid.begin(); at != valid.end();) {
    const char32_t c = utf8::next(at, valid.end());
    switch (c) {
      case U'\\':
        roff += "\\e";
        break;
      case U'-':
        roff += "\\-";
        break;
      case U'\'':
        roff += "\\(aq";
        break;
      case U'`':
        roff += "\\(ga";
        break;
      case U'^':
        roff += "\\(ha";
        break;
      case U'~':
        roff += "\\(ti";
        break;
      case U'"':
        roff += "\\(dq";
        break;
      default:
        if (c < 0x80) {
          roff += static_cast<char>(c);
        } else {
          std::array<char, 16> name{};
          std::snprintf(name.data(), name.size(), "\\[u%04X]", static_cast<unsigned>(c));
          roff += name.data();
        }
    }
  }
  // roff takes a dot at the beginning of a line for a request.
  return roff.starts_with('.') ? "\\&" + roff : roff;
}

std::string bold(std::string_view text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string line(std::string_view text) { return escaped(text) + '\n'; }

std::string heading(std::string_view text) { return ".SH " + escaped(upper(text)) + '\n'; }

/// The text below the flags: paragraphs, and indented lines, which stay as they are.
class More {
 public:
  /// `has_headings`: lines such as `Examples:` begin a section.
  explicit More(bool has_headings) : has_headings_(has_headings) {}

  std::string roff(std::string_view text) {
    while (!text.empty()) {
      const auto end = std::min(text.find('\n'), text.size());
      take(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    leave_literal();
    return std::move(roff_);
  }

 private:
  void take(std::string_view text) {
    if (text.find_first_not_of(' ') == std::string_view::npos) {
      leave_literal();
      is_after_gap_ = true;
      return;
    }
    if (text.starts_with(' ')) return take_literal(text);
    leave_literal();
    if (has_headings_ && begin_section(text)) {
      if (text.empty()) return;
      roff_ += in_upper_case(text.front());
      text.remove_prefix(1);
    } else if (is_after_gap_ || is_after_literal_) {
      if (has_headings_ && is_after_gap_ && section_ != "NOTES") {
        begin("Notes");
      } else if (!is_after_heading_) {
        roff_ += ".PP\n";
      }
    }
    roff_ += line(text);
    is_after_gap_ = is_after_heading_ = is_after_literal_ = false;
  }

  /// Takes a heading from the front of the text. False where there is none.
  bool begin_section(std::string_view& text) {
    const auto* const found = std::ranges::find_if(headings, [&](std::string_view word) {
      return text.starts_with(word) && text.substr(word.size()).starts_with(':');
    });
    if (found == headings.end()) return false;
    begin(*found);
    text.remove_prefix(found->size() + 1);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    return true;
  }
  void begin(std::string_view name) {
    roff_ += heading(name);
    section_ = upper(name);
    is_after_heading_ = true;
    is_after_gap_ = is_after_literal_ = false;
  }

  void take_literal(std::string_view text) {
    if (!is_literal_) roff_ += is_after_heading_ ? ".EX\n" : ".PP\n.EX\n";
    is_literal_ = true;
    is_after_gap_ = is_after_heading_ = false;
    roff_ += line(text);
  }
  void leave_literal() {
    if (is_literal_) roff_ += ".EE\n";
    is_after_literal_ = is_after_literal_ || is_literal_;
    is_literal_ = false;
  }

  bool has_headings_;
  std::string roff_;
  std::string section_;
  bool is_literal_ = false;
  bool is_after_gap_ = true;
  bool is_after_heading_ = false;
  bool is_after_literal_ = false;
};

/// `[WORD...]`
std::string synopsis_of(const Flag& word) {
  const std::string name = italic(word.names.front()) + (word.is_repeated ? " ..." : "");
  return word.is_required ? name : '[' + name + ']';
}

std::string synopsis(const Outline& outline, std::string_view called) {
  std::string text = bold(called) + " [" + italic("OPTIONS") + ']';
  for (const Flag& word : outline.words) text += ' ' + synopsis_of(word);
  if (!outline.commands.empty()) text += ' ' + italic("COMMAND") + " ...";
  return text + '\n';
}

std::string entry(const Flag& flag, bool is_word) {
  std::string roff = ".TP\n";
  for (const std::string& name : flag.names) {
    if (&name != &flag.names.front()) roff += ", ";
    roff += is_word ? italic(name) : bold(name);
  }
  if (!is_word && !flag.value.empty()) roff += ' ' + italic(flag.value);
  if (flag.is_repeated) roff += " ...";
  return roff + '\n' + line(flag.meaning.empty() ? "(no more is said)" : flag.meaning);
}

/// Words and flags, each group below its heading.
std::string entries(const Outline& outline) {
  std::string roff;
  for (const Flag& word : outline.words) roff += entry(word, true);
  std::string_view group;
  for (const Flag& flag : outline.flags) {
    if (flag.group != group) roff += ".PP\n" + line(flag.group + ':');
    group = flag.group;
    roff += entry(flag, false);
  }
  return roff;
}

/// The flags but for those of every command.
Outline without_help(Outline command) {
  std::erase_if(command.flags, [](const Flag& flag) { return flag.names.back() == "--help"; });
  return command;
}

}  // namespace

std::string man_page(const Outline& program, int section, const std::string& date) {
  const auto end_of_line = program.about.find('\n');
  std::string_view first = std::string_view(program.about).substr(0, end_of_line);
  if (first.starts_with(program.name + ' ')) first.remove_prefix(program.name.size() + 1);
  if (first.ends_with('.')) first.remove_suffix(1);
  // The word behind the program's name; versions of protocols may follow in brackets.
  const auto space = program.version.find(' ');
  const std::string behind = space == std::string::npos ? program.version : program.version.substr(space + 1);
  const std::string version = behind.substr(0, behind.find(' '));

  std::string roff = ".\\\" Made from the text of " + escaped(program.name) + " \\-\\-help.\n";
  roff += ".TH " + escaped(upper(program.name)) + ' ' + std::to_string(section) + ' ' + date + " \"Geminga " +
          escaped(version) + "\" \"Geminga\"\n";
  roff += ".SH NAME\n" + escaped(program.name) + " \\- " + escaped(first) + '\n';
  roff += ".SH SYNOPSIS\n" + synopsis(program, program.name);
  roff += ".SH DESCRIPTION\n" + line(program.about);
  roff += ".SH OPTIONS\n" + entries(program);
  if (!program.commands.empty()) roff += ".SH COMMANDS\n";
  for (const Outline& command : program.commands) {
    roff += ".SS " + escaped(command.name) + '\n' + synopsis(command, program.name + ' ' + command.name);
    roff += ".PP\n" + line(command.about) + entries(without_help(command)) + More(false).roff(command.more);
  }
  return roff + More(true).roff(program.more);
}

}  // namespace geminga::manual
