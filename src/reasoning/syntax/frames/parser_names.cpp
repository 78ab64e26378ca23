// IRIs, properties of either kind, individuals and literals.

#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "reasoning/owl/blank_prefix.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/plain_literal.hpp"
#include "reasoning/syntax/frames/parser.hpp"

namespace geminga::frames {

using manchester::ParseError;
using manchester::Token;
using manchester::TokenKind;
using owl::TermKind;

namespace {

constexpr std::string_view xsd = "http://www.w3.org/2001/XMLSchema#";
constexpr std::string_view rdfs_literal = "http://www.w3.org/2000/01/rdf-schema#Literal";
constexpr std::string_view not_in_iris = " <>\"{}|\\^`";

/// Section 2.3 of the note: datatypes that need no prefix.
bool is_short_datatype(std::string_view word) {
  return word == "integer" || word == "decimal" || word == "float" || word == "string";
}

bool is_language(std::string_view tag) {
  bool is_first = true;
  while (true) {
    const std::size_t end = std::min(tag.find('-'), tag.size());
    const auto fits = [&](char c) {
      const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
      return is_letter || (!is_first && c >= '0' && c <= '9');
    };
    if (end == 0 || !std::ranges::all_of(tag.substr(0, end), fits)) return false;
    if (end == tag.size()) return true;
    tag.remove_prefix(end + 1);
    is_first = false;
  }
}

}  // namespace

std::expected<std::string, std::string> Parser::expand(const Token& token) const {
  if (token.kind == TokenKind::label)
    return std::unexpected("names in single quotation marks are not read in documents: write prefix:Name");
  std::string_view word = token.text;
  if (word.starts_with('<')) {
    word = word.substr(1, word.size() - 2);
    if (word.size() > frame_limits_.iri_bytes)
      return std::unexpected("an IRI of more than " + std::to_string(frame_limits_.iri_bytes) + " bytes");
    if (base::has_control_character(word)) return std::unexpected("an IRI with a control character");
    return std::string(word);
  }
  const std::size_t colon = word.find(':');
  const std::string_view prefix = colon == std::string_view::npos ? std::string_view() : word.substr(0, colon);
  const std::string_view local = colon == std::string_view::npos ? word : word.substr(colon + 1);
  const std::string* known = head_.iri_of(prefix);
  if (known == nullptr) {
    return std::unexpected(colon == std::string_view::npos
                               ? "'" + base::printable(word, 60) + "' has no prefix, and no default one is declared"
                               : document::Head::undeclared(prefix));
  }
  if (local.find_first_of(not_in_iris) != std::string_view::npos || base::has_control_character(local))
    return std::unexpected("'" + base::printable(word, 60) + "' has a character that no IRI may have");
  std::string full = *known + std::string(local);
  if (full.size() > frame_limits_.iri_bytes)
    return std::unexpected("an IRI of more than " + std::to_string(frame_limits_.iri_bytes) + " bytes");
  return full;
}

std::string Parser::iri(std::string_view what) {
  if (failed()) return {};
  if (!is_name() || tokens_.token().text.starts_with("_:")) {
    expected(what);
    return {};
  }
  const Token token = take();
  auto name = expand(token);
  if (name) return std::move(*name);
  fail(ParseError::Kind::name, token.begin, name.error());
  return {};
}

std::expected<std::string, std::string> Parser::iri_of(TermKind kind, const Token& token) {
  if (token.text.starts_with("_:")) return std::unexpected("a blank node where a name is wanted");
  if (kind == TermKind::datatype && is_short_datatype(token.text)) return std::string(xsd) += token.text;
  return expand(token);
}

// The next word is the kind of restriction. The word behind it shows the kind of values.
bool Parser::is_value_of_data(manchester::Tokenizer behind) const {
  const auto is = [&](TokenKind kind, std::string_view text) {
    return behind.token().kind == kind && behind.token().text == text;
  };
  while (behind.token().kind == TokenKind::keyword && !is(TokenKind::keyword, "true") &&
         !is(TokenKind::keyword, "false")) {
    const bool is_counted =
        is(TokenKind::keyword, "min") || is(TokenKind::keyword, "max") || is(TokenKind::keyword, "exactly");
    behind.advance();
    if (is_counted && behind.token().kind == TokenKind::number) behind.advance();
  }
  while (is(TokenKind::symbol, "{") || is(TokenKind::symbol, "(") || is(TokenKind::keyword, "not")) behind.advance();
  const Token& token = behind.token();
  if (token.kind == TokenKind::string || token.kind == TokenKind::number || is(TokenKind::keyword, "true") ||
      is(TokenKind::keyword, "false"))
    return true;
  return token.kind == TokenKind::name && names_datatype(token);
}

bool Parser::names_datatype(const Token& token) const {
  if (is_short_datatype(token.text)) return true;
  const auto name = expand(token);
  return name &&
         (owl::Datatype::find(*name).has_value() || *name == rdfs_literal || declared_.has(TermKind::datatype, *name));
}

std::expected<TermKind, std::string> Parser::kind_of_property(const Token& token) {
  const auto name = iri_of(TermKind::object_property, token);
  if (!name) return std::unexpected(name.error());
  const bool is_object = declared_.has(TermKind::object_property, *name) || *name == owl::owl_top_object_property ||
                         *name == owl::owl_bottom_object_property;
  const bool is_data = declared_.has(TermKind::data_property, *name) || *name == owl::owl_top_data_property ||
                       *name == owl::owl_bottom_data_property;
  if (is_object != is_data) return is_data ? TermKind::data_property : TermKind::object_property;
  return is_value_of_data(tokens_) ? TermKind::data_property : TermKind::object_property;
}

owl::TermId Parser::literal_of(const Token& text, std::string_view datatype, std::string_view language) {
  if (text.value.size() > frame_limits_.literal_bytes)
    return fail(ParseError::Kind::too_large, text.begin,
                "a text of more than " + std::to_string(frame_limits_.literal_bytes) + " bytes");
  if (!language.empty() && !is_language(language))
    return fail(ParseError::Kind::malformed, text.begin,
                "a language tag that is none: @" + base::printable(language, 60));
  last_text_ = text.value;
  last_language_ = base::in_lower_case(language);
  std::string& kind = last_datatype_;
  kind = datatype;
  if (kind == owl::plain_literal_datatype) {
    kind.clear();
    auto plain = owl::split_plain_literal(last_text_);
    last_language_ = std::move(plain.language);
    last_text_.resize(plain.text.size());
  }
  return source_.literal(last_text_, kind, last_language_);
}

owl::TermId Parser::individual() {
  if (failed()) return owl::thing_term;
  const Token& token = tokens_.token();
  if (!is_name() || !token.text.starts_with("_:")) return manchester::Parser::individual();
  if (token.text.size() == 2) return expected("the name of a blank node behind '_:'");
  if (blank_prefix_.empty()) blank_prefix_ = owl::blank_prefix_of(bytes_);
  return source_.anonymous_individual(blank_prefix_ + std::string(take().text.substr(2)));
}

}  // namespace geminga::frames
