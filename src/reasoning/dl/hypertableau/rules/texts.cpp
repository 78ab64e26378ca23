// Texts are UTF-8; positions and lengths count characters.
#include "reasoning/dl/hypertableau/rules/texts.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/letter_case.hpp"
#include "base/utf8.hpp"
#include "reasoning/dl/hypertableau/rules/patterns.hpp"

namespace geminga::hypertableau {
namespace {

using clauses::BuiltIn;
using owl::DataFamily;

bool is_text(const Value& value) { return value.family == DataFamily::text; }

Computed text_value(std::string_view text) {
  if (text.size() > max_text_octets) return {Holds::unknown, std::nullopt};
  bool is_ill_formed = false;
  auto read = owl::DataValue::read(text, "http://www.w3.org/2001/XMLSchema#string", {}, is_ill_formed);
  if (!read || is_ill_formed) return {};  // a character that no text may have
  auto value = value_of(std::move(*read));
  if (!value) return {};
  return {Holds::yes, std::move(value)};
}

Computed text_in_case(std::string_view text, base::LetterCase wanted) {
  const auto changed = base::in_case(text, wanted);
  return changed ? text_value(*changed) : Computed{Holds::unknown, std::nullopt};
}

/// Whether something holds of two texts in lower case.
template <typename Compare>
Holds same_but_for_case(std::string_view text, std::string_view part, const Compare& compare) {
  const auto whole = base::in_case(text, base::LetterCase::lower);
  const auto other = base::in_case(part, base::LetterCase::lower);
  if (!whole || !other) return Holds::unknown;
  return compare(*whole, *other) ? Holds::yes : Holds::no;
}

/// A number rounded as fn:round() does, as the double that fn:substring() takes.
std::optional<double> rounded(const Value& value) {
  const std::array<Value, 1> operand{value};
  const Computed result = compute(BuiltIn::round, operand);
  return result.holds == Holds::yes ? std::optional(double_of(*result.value)) : std::nullopt;
}

/// The octets of the character that begins here.
std::string_view character_at(std::string_view text, std::size_t at) {
  std::size_t next = at + 1;
  while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0U) == 0x80U) ++next;
  return text.substr(at, next - at);
}

/// The characters whose position p, from 1, has  start <= p < start + length: none where one of them is NaN.
Computed substring(std::span<const Value> operands) {
  const std::string_view text = text_of(operands[0]);
  const auto start = rounded(operands[1]);
  if (!start) return {};
  double end = std::numeric_limits<double>::infinity();
  if (operands.size() > 2) {
    const auto length = rounded(operands[2]);
    if (!length) return {};
    end = *start + *length;
  }
  std::string result;
  double position = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view character = character_at(text, at);
    ++position;
    if (*start <= position && position < end) result += character;
    at += character.size();
  }
  return text_value(result);
}

std::string without_surplus_space(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool is_space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (is_space && (result.empty() || result.back() == ' ')) continue;
    result += is_space ? ' ' : c;
  }
  if (result.ends_with(' ')) result.pop_back();
  return result;
}

std::vector<std::string_view> characters_of(std::string_view text) {
  std::vector<std::string_view> characters;
  for (std::size_t at = 0; at < text.size(); at += characters.back().size())
    characters.push_back(character_at(text, at));
  return characters;
}

/// Each character that is in `from` becomes the one at its first place there in `to`, or goes where `to` is shorter.
std::string translated(std::string_view text, std::string_view from, std::string_view to) {
  const auto targets = characters_of(to);
  std::map<std::string_view, std::string_view> become;
  std::size_t place = 0;
  for (const std::string_view character : characters_of(from)) {
    become.try_emplace(character, place < targets.size() ? targets[place] : std::string_view());
    ++place;
  }
  std::string result;
  for (const std::string_view character : characters_of(text)) {
    const auto found = become.find(character);
    result += found == become.end() ? character : found->second;
  }
  return result;
}

}  // namespace

std::string_view text_of(const Value& value) {
  if (value.family != DataFamily::text || value.text.empty()) return {};
  const std::string_view canonical = value.text;
  return value.layer == language_layer ? canonical.substr(canonical.find('\0') + 1) : canonical.substr(1);
}

Computed make_text(BuiltIn built_in, std::span<const Value> operands) {
  if (operands.empty() || !is_text(operands[0])) return {};
  const std::string_view text = text_of(operands[0]);
  if (text.size() > max_text_octets) return {Holds::unknown, std::nullopt};
  switch (built_in) {
    case BuiltIn::string_concat: {
      std::string all;
      for (const Value& one : operands) {
        if (!is_text(one)) return {};
        all += text_of(one);
        if (all.size() > max_text_octets) return {Holds::unknown, std::nullopt};
      }
      return text_value(all);
    }
    case BuiltIn::substring:
      return substring(operands);
    case BuiltIn::string_length:
      return {Holds::yes, value_of_number(Number(base::count_characters(text)))};
    case BuiltIn::normalize_space:
      return text_value(without_surplus_space(text));
    case BuiltIn::upper_case:
      return text_in_case(text, base::LetterCase::upper);
    case BuiltIn::lower_case:
      return text_in_case(text, base::LetterCase::lower);
    case BuiltIn::substring_before:
    case BuiltIn::substring_after: {
      if (!is_text(operands[1])) return {};
      const std::string_view part = text_of(operands[1]);
      const std::size_t at = text.find(part);
      if (built_in == BuiltIn::substring_before)
        return text_value(at == std::string_view::npos ? std::string_view() : text.substr(0, at));
      return text_value(at == std::string_view::npos ? std::string_view() : text.substr(at + part.size()));
    }
    case BuiltIn::translate:
      if (!is_text(operands[1]) || !is_text(operands[2])) return {};
      return text_value(translated(text, text_of(operands[1]), text_of(operands[2])));
    case BuiltIn::replace: {
      if (!is_text(operands[1]) || !is_text(operands[2])) return {};
      const auto result = replaced(text, text_of(operands[1]), text_of(operands[2]), max_text_octets);
      return result ? text_value(*result) : Computed{Holds::unknown, std::nullopt};
    }
    default:
      return {};
  }
}

Holds compare_texts(BuiltIn built_in, const Value& first, const Value& second) {
  if (!is_text(first) || !is_text(second)) return Holds::no;
  const std::string_view text = text_of(first);
  const std::string_view part = text_of(second);
  if (text.size() > max_text_octets || part.size() > max_text_octets) return Holds::unknown;
  const auto answer = [](bool holds) { return holds ? Holds::yes : Holds::no; };
  switch (built_in) {
    case BuiltIn::contains:
      return answer(text.find(part) != std::string_view::npos);
    case BuiltIn::starts_with:
      return answer(text.starts_with(part));
    case BuiltIn::ends_with:
      return answer(text.ends_with(part));
    case BuiltIn::string_equal_ignore_case:
      if (text == part) return Holds::yes;
      return same_but_for_case(text, part, [](const auto& whole, const auto& other) { return whole == other; });
    case BuiltIn::contains_ignore_case:
      if (text.find(part) != std::string_view::npos) return Holds::yes;
      return same_but_for_case(
          text, part, [](const auto& whole, const auto& other) { return whole.find(other) != std::string::npos; });
    case BuiltIn::matches: {
      const auto is_match = has_match(text, part);
      return is_match ? answer(*is_match) : Holds::unknown;
    }
    default:
      return Holds::unknown;
  }
}

}  // namespace geminga::hypertableau
