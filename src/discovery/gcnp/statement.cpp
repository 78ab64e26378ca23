#include "discovery/gcnp/statement.hpp"

#include <utf8.h>

#include <algorithm>
#include <utility>

#include "base/text.hpp"

namespace geminga::gcnp {
namespace {

constexpr std::string_view escapes = "\"\\nrt";
constexpr std::string_view escaped = "\"\\\n\r\t";

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

bool is_bare_character(char c) { return c != ' ' && c != '"' && !is_control(c); }

Error malformed_at(std::size_t offset, std::string_view text) {
  return {ErrorCode::malformed, "octet " + std::to_string(offset + 1) + ": " + std::string(text)};
}

/// Walks one line from left to right; every octet is looked at once.
class Cursor {
 public:
  explicit Cursor(std::string_view line) : line_(line) {}

  [[nodiscard]] bool at_end() const { return at_ == line_.size(); }
  [[nodiscard]] std::size_t offset() const { return at_; }
  [[nodiscard]] char peek() const { return line_[at_]; }
  void step() { ++at_; }
  void skip_spaces() {
    while (!at_end() && peek() == ' ') step();
  }
  template <typename Predicate>
  std::string_view take_while(Predicate accepts) {
    const std::size_t begin = at_;
    while (!at_end() && accepts(peek())) step();
    return line_.substr(begin, at_ - begin);
  }
  [[nodiscard]] bool is_at_word_end() const { return at_end() || peek() == ' '; }

 private:
  std::string_view line_;
  std::size_t at_ = 0;
};

/// The octets that no line may have at any position.
std::optional<Error> forbidden_octet(std::string_view line) {
  const auto control = std::ranges::find_if(line, is_control);
  const auto* const bad = utf8::find_invalid(line.begin(), line.end());
  const auto* const first = std::min<const char*>(control, bad);
  if (first == line.end()) return std::nullopt;
  const auto offset = static_cast<std::size_t>(first - line.begin());
  if (first == control) {
    return malformed_at(offset, "a control character: write \\n, \\r or \\t inside quotes, and leave out any other");
  }
  return malformed_at(offset, "not UTF-8");
}

std::expected<std::uint32_t, Error> read_id(Cursor& cursor) {
  const std::size_t begin = cursor.offset();
  const std::string_view word = cursor.take_while([](char c) { return c != ' '; });
  if (const auto id = base::parse_number<std::uint32_t>(word)) return *id;
  return std::unexpected(malformed_at(
      begin, "a statement begins with an id, a decimal number from 0 to 4294967295: <id> <command> <subcommand> ..."));
}

std::expected<std::string, Error> read_word(Cursor& cursor, std::string_view what) {
  cursor.skip_spaces();
  if (cursor.at_end()) return std::unexpected(malformed_at(cursor.offset(), std::string(what) + " is missing"));
  std::string word(cursor.take_while(base::is_key_octet));
  if (word.empty() || !cursor.is_at_word_end()) {
    return std::unexpected(malformed_at(cursor.offset(), "no character of a " + std::string(what)));
  }
  return word;
}

/// Requires that the cursor is at the opening quote.
std::expected<std::string, Error> read_quoted(Cursor& cursor) {
  const std::size_t begin = cursor.offset();
  cursor.step();
  std::string value;
  while (true) {
    value += cursor.take_while([](char c) { return c != '"' && c != '\\'; });
    if (cursor.at_end()) return std::unexpected(malformed_at(begin, "the closing quote is missing"));
    const char c = cursor.peek();
    cursor.step();
    if (c == '"') break;
    const auto escape = cursor.at_end() ? std::string_view::npos : escapes.find(cursor.peek());
    if (escape == std::string_view::npos) {
      return std::unexpected(malformed_at(cursor.offset() - 1, R"(no escape: there are \" \\ \n \r \t)"));
    }
    value += escaped[escape];
    cursor.step();
  }
  if (!cursor.is_at_word_end()) {
    return std::unexpected(malformed_at(cursor.offset(), "a space is missing after the closing quote"));
  }
  return value;
}

std::expected<Parameter, Error> read_parameter(Cursor& cursor) {
  const std::size_t begin = cursor.offset();
  Parameter parameter;
  parameter.key = cursor.take_while(base::is_key_octet);
  if (parameter.key.empty()) {
    return std::unexpected(malformed_at(begin, "a key is missing: letters, digits, '_', '.' and '-'"));
  }
  if (cursor.is_at_word_end()) return parameter;
  if (cursor.peek() != '=') {
    return std::unexpected(malformed_at(cursor.offset(), "no character of a key: letters, digits, '_', '.' and '-'"));
  }
  cursor.step();
  if (!cursor.at_end() && cursor.peek() == '"') {
    auto value = read_quoted(cursor);
    if (!value) return std::unexpected(std::move(value.error()));
    parameter.value = std::move(*value);
    return parameter;
  }
  parameter.value = cursor.take_while(is_bare_character);
  if (!cursor.is_at_word_end()) {
    return std::unexpected(malformed_at(cursor.offset(), "a quote inside a bare value: put the whole value in quotes"));
  }
  return parameter;
}

std::expected<void, Error> read_rest(Cursor& cursor, Statement& statement) {
  auto command = read_word(cursor, "command");
  if (!command) return std::unexpected(std::move(command.error()));
  statement.command = std::move(*command);
  auto subcommand = read_word(cursor, "subcommand");
  if (!subcommand) return std::unexpected(std::move(subcommand.error()));
  statement.subcommand = std::move(*subcommand);
  for (cursor.skip_spaces(); !cursor.at_end(); cursor.skip_spaces()) {
    if (statement.parameters.size() == max_parameters) {
      return std::unexpected(
          Error{ErrorCode::too_large, "a statement has at most " + std::to_string(max_parameters) + " parameters"});
    }
    auto parameter = read_parameter(cursor);
    if (!parameter) return std::unexpected(std::move(parameter.error()));
    statement.parameters.push_back(std::move(*parameter));
  }
  return {};
}

/// The text as to_line() writes it: well-formed UTF-8 without control characters that have no escape.
std::string clean(std::string_view text) {
  std::string cleaned;
  if (base::is_valid_utf8(text)) {
    cleaned = text;
  } else {
    utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(cleaned));
  }
  std::ranges::replace_if(
      cleaned, [](char c) { return is_control(c) && escaped.find(c) == std::string_view::npos; }, '?');
  return cleaned;
}

void append_value(std::string& line, std::string_view value) {
  const std::string text = clean(value);
  if (!text.empty() && std::ranges::all_of(text, is_bare_character)) {
    line += text;
    return;
  }
  line += '"';
  for (const char c : text) {
    const auto escape = escaped.find(c);
    if (escape == std::string_view::npos) {
      line += c;
    } else {
      line += '\\';
      line += escapes[escape];
    }
  }
  line += '"';
}

}  // namespace

std::optional<std::string_view> Statement::value(std::string_view key) const {
  const auto parameter = std::ranges::find(parameters, key, &Parameter::key);
  if (parameter == parameters.end() || !parameter->value) return std::nullopt;
  return *parameter->value;
}

bool Statement::has(std::string_view key) const {
  return std::ranges::find(parameters, key, &Parameter::key) != parameters.end();
}

std::expected<Statement, Malformed> parse(std::string_view line) {
  Malformed malformed;
  // The id is told even if the rest cannot be read, so that the error reaches the request that it belongs to.
  Cursor cursor(line.substr(0, max_line_bytes));
  auto id = read_id(cursor);
  if (id) malformed.id = *id;
  if (line.size() > max_line_bytes) {
    malformed.error = line_too_long();
    return std::unexpected(std::move(malformed));
  }
  if (auto forbidden = forbidden_octet(line)) {
    malformed.error = std::move(*forbidden);
    return std::unexpected(std::move(malformed));
  }
  if (!id) {
    malformed.error = std::move(id.error());
    return std::unexpected(std::move(malformed));
  }
  Statement statement;
  statement.id = *id;
  if (auto rest = read_rest(cursor, statement); !rest) {
    malformed.error = std::move(rest.error());
    return std::unexpected(std::move(malformed));
  }
  return statement;
}

Error line_too_long() {
  return {ErrorCode::too_large, "a line has at most " + std::to_string(max_line_bytes) + " octets"};
}

std::string to_line(const Statement& statement) {
  std::string line = std::to_string(statement.id) + ' ' + statement.command + ' ' + statement.subcommand;
  for (const auto& parameter : statement.parameters) {
    line += ' ';
    line += parameter.key;
    if (!parameter.value) continue;
    line += '=';
    append_value(line, *parameter.value);
  }
  line += "\r\n";
  return line;
}

std::string to_line(std::uint32_t id, const Error& error) {
  return std::to_string(id) + ' ' + std::to_string(std::to_underlying(error.code)) + ' ' +
         base::printable(error.text, max_error_text_bytes) + "\r\n";
}

}  // namespace geminga::gcnp
