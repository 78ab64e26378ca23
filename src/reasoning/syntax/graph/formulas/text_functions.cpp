#include "reasoning/syntax/graph/formulas/text_functions.hpp"

#include <re2/re2.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/letter_case.hpp"
#include "base/utf8.hpp"

namespace geminga::graph {
namespace {

/// The most octets of a text that is made.
constexpr std::size_t most_octets = std::size_t{1} << 20;

/// Whether the second text may be looked for in the first (section 17.4.3.1.2).
bool are_compatible(const Scalar& first, const Scalar& second) {
  return is_string(first) && is_string(second) && (second->language.empty() || first->language == second->language);
}
Scalar with_language_of(const Node& of, std::string value) {
  return Node{Node::Kind::literal, std::move(value), {}, of.language};
}

/// The octet at which the character of this number, from 1, begins.
std::size_t octet_of(std::string_view value, double character) {
  std::size_t at = 0;
  for (double passed = 1; passed < character && at < value.size(); ++passed)
    at += base::character_bytes(static_cast<unsigned char>(value[at]));
  return std::min(at, value.size());
}

/// A regular expression of a query with its flags; null where RE2 cannot read it.
std::unique_ptr<re2::RE2> pattern_of(const Scalar& pattern, const Scalar* flags) {
  if (!pattern || !is_text(*pattern)) return nullptr;
  re2::RE2::Options options;
  options.set_log_errors(false);
  std::string before;
  if (flags != nullptr) {
    if (!*flags || !is_text(**flags)) return nullptr;
    for (const char flag : (*flags)->text) {
      if (flag == 'i') options.set_case_sensitive(false);
      if (flag == 's') options.set_dot_nl(true);
      if (flag == 'm') before = "(?m)";
      if (std::string_view("ism").find(flag) == std::string_view::npos) return nullptr;
    }
  }
  auto compiled = std::make_unique<re2::RE2>(before + pattern->text, options);
  return compiled->ok() ? std::move(compiled) : nullptr;
}

}  // namespace

bool is_string(const Scalar& value) {
  return value && value->kind == Node::Kind::literal && (!value->language.empty() || is_text(*value));
}

Scalar part_of(const std::vector<Scalar>& given) {
  if (given.size() < 2 || !is_string(given[0]) || !given[1]) return std::nullopt;
  const auto begin = number_of(*given[1]);
  if (!begin) return std::nullopt;
  const double first = std::floor(as_type(*begin, Numeric::Type::double_).approximate + 0.5);
  double end = static_cast<double>(given[0]->text.size()) + 1;
  if (given.size() > 2) {
    const auto length = given[2] ? number_of(*given[2]) : std::nullopt;
    if (!length) return std::nullopt;
    end = first + std::floor(as_type(*length, Numeric::Type::double_).approximate + 0.5);
  }
  if (std::isnan(first) || std::isnan(end)) return with_language_of(*given[0], {});
  const std::size_t from = octet_of(given[0]->text, first);
  const std::size_t to = octet_of(given[0]->text, end);
  return with_language_of(*given[0], from < to ? given[0]->text.substr(from, to - from) : std::string());
}

Scalar matches(const std::vector<Scalar>& given) {
  if (given.size() < 2 || !is_string(given[0])) return std::nullopt;
  const auto pattern = pattern_of(given[1], given.size() > 2 ? &given[2] : nullptr);
  return pattern == nullptr ? Scalar() : boolean(re2::RE2::PartialMatch(given[0]->text, *pattern));
}

Scalar replaced(const std::vector<Scalar>& given) {
  if (given.size() < 3 || !is_string(given[0]) || !given[2] || !is_text(*given[2])) return std::nullopt;
  const auto pattern = pattern_of(given[1], given.size() > 3 ? &given[3] : nullptr);
  if (pattern == nullptr || re2::RE2::FullMatch("", *pattern)) return std::nullopt;  // FORX0003
  std::string written;                                                               // $1 is \1 of RE2
  const std::string& wanted = given[2]->text;
  for (std::size_t at = 0; at < wanted.size(); ++at) {
    const bool is_escape = wanted[at] == '\\' || wanted[at] == '$';
    const char next = at + 1 < wanted.size() ? wanted[at + 1] : ' ';
    if (!is_escape) {
      written += wanted[at];
    } else if (wanted[at] == '$' && next >= '0' && next <= '9') {
      written.append(1, '\\').append(1, next);
      ++at;
    } else if (wanted[at] == '\\' && (next == '$' || next == '\\')) {
      written.append(next == '\\' ? "\\\\" : "$");
      ++at;
    } else {
      return std::nullopt;
    }
  }
  std::string result = given[0]->text;
  if (!pattern->CheckRewriteString(written, nullptr)) return std::nullopt;
  re2::RE2::GlobalReplace(&result, *pattern, written);
  return result.size() > most_octets ? Scalar() : with_language_of(*given[0], std::move(result));
}

Scalar joined(const std::vector<Scalar>& given) {
  std::string all;
  bool is_one_language = !given.empty();
  for (const Scalar& part : given) {
    if (!is_string(part)) return std::nullopt;
    is_one_language = is_one_language && part->language == given.front()->language;
    all += part->text;
  }
  if (all.size() > most_octets) return std::nullopt;
  return is_one_language ? with_language_of(*given.front(), std::move(all)) : Scalar(text(std::move(all)));
}

Scalar text_in_case(const Scalar& value, bool is_upper) {
  if (!is_string(value)) return std::nullopt;
  auto changed = base::in_case(value->text, is_upper ? base::LetterCase::upper : base::LetterCase::lower);
  if (!changed) return std::nullopt;
  return with_language_of(*value, std::move(*changed));
}

Scalar compare_texts(rasqal_op op, const Scalar& first, const Scalar& second) {
  if (!are_compatible(first, second)) return std::nullopt;
  const std::string& value = first->text;
  const std::string& wanted = second->text;
  if (op == RASQAL_EXPR_STRSTARTS) return boolean(value.starts_with(wanted));
  if (op == RASQAL_EXPR_STRENDS) return boolean(value.ends_with(wanted));
  const std::size_t place = value.find(wanted);
  if (op == RASQAL_EXPR_CONTAINS) return boolean(place != std::string::npos);
  if (place == std::string::npos) return text({});
  return with_language_of(*first,
                          op == RASQAL_EXPR_STRBEFORE ? value.substr(0, place) : value.substr(place + wanted.size()));
}

std::string for_uri(std::string_view value) {
  std::string written;
  for (const char c : value) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          std::string_view("-_.~").find(c) != std::string_view::npos;
    if (is_plain) {
      written += c;
    } else {
      constexpr std::string_view digits = "0123456789ABCDEF";
      const auto octet = static_cast<unsigned char>(c);
      written.append(1, '%').append(1, digits[octet >> 4U]).append(1, digits[octet & 15U]);
    }
  }
  return written;
}

}  // namespace geminga::graph
