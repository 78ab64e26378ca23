#include "base/text.hpp"

#include <utf8.h>

#include <algorithm>
#include <iterator>

#include "base/harmless.hpp"
#include "base/utf8.hpp"

namespace geminga::base {

bool is_valid_utf8(std::string_view bytes) { return utf8::is_valid(bytes.begin(), bytes.end()); }

bool has_control_character(std::string_view bytes) {
  return std::ranges::any_of(bytes, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

std::optional<std::uint32_t> parse_id32(std::string_view text) {
  if (!text.starts_with("0x") && !text.starts_with("0X")) return parse_number<std::uint32_t>(text);
  text.remove_prefix(2);
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string to_hex(std::uint64_t number, int digits) {
  std::string text(static_cast<std::size_t>(digits), '0');
  for (auto place = text.rbegin(); place != text.rend(); ++place, number >>= 4U)
    *place = "0123456789abcdef"[number & 15U];
  return text;
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
  return lower;
}

bool is_key(std::string_view text) { return !text.empty() && std::ranges::all_of(text, is_key_octet); }

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view without_mark(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  return bytes;
}

std::string joined(std::span<const std::string> words, std::string_view separator) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : separator).append(word);
  return text;
}

std::string printable(std::string_view bytes, std::size_t max_bytes) {
  std::string text = harmless(bytes, "?");
  if (text.size() <= max_bytes) return text;
  return std::string(first_characters(text, max_bytes)) + "...";
}

}  // namespace geminga::base
