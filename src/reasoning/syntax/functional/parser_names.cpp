// IRIs, entities, individuals and literals.

#include "base/text.hpp"
#include "reasoning/owl/blank_prefix.hpp"
#include "reasoning/owl/plain_literal.hpp"
#include "reasoning/syntax/document/head.hpp"
#include "reasoning/syntax/functional/parser.hpp"

namespace geminga::functional {
bool Parser::iri(std::string_view what) {
  const Token& token = tokens_.token();
  if (token.kind == TokenKind::full_iri) {
    iri_ = token.text;
    if (iri_.empty()) return expected(what);
  } else if (token.kind == TokenKind::prefixed_name) {
    if (!resolve(token)) return false;
  } else {
    return expected(what);
  }
  tokens_.advance();
  return true;
}

bool Parser::resolve(const Token& name) {
  const std::string_view prefix = name.text.substr(0, name.prefix_bytes);
  if (last_prefix_iri_ == nullptr || last_prefix_ != prefix) {
    const std::string* known = head_.iri_of(prefix);
    if (known == nullptr) {
      fault(document::Head::undeclared(prefix));
      return false;
    }
    last_prefix_ = prefix;
    last_prefix_iri_ = known;
  }
  const std::string_view local = name.text.substr(name.prefix_bytes + 1);
  iri_buffer_.assign(*last_prefix_iri_);
  if (name.has_escapes) {
    append_unescaped(iri_buffer_, local);
  } else {
    iri_buffer_.append(local);
  }
  if (iri_buffer_.size() > limits_.iri_bytes || iri_buffer_.empty()) {
    tokens_.fail(iri_buffer_.empty() ? std::string("a name that stands for an empty IRI")
                                     : "an IRI of more than " + std::to_string(limits_.iri_bytes) + " bytes");
    return false;
  }
  iri_ = iri_buffer_;
  return true;
}

bool Parser::entity(owl::TermKind kind, std::string_view what) {
  if (!iri(what)) return false;
  terms_.push_back(source_.entity(kind, iri_));
  return true;
}

bool Parser::individual(std::string_view what) {
  if (!tokens_.is(TokenKind::node_id)) return entity(owl::TermKind::individual, what);
  terms_.push_back(source_.anonymous_individual(blank_name(tokens_.token().text)));
  tokens_.advance();
  return true;
}

std::string_view Parser::blank_name(std::string_view label) {
  if (blank_prefix_.empty()) blank_prefix_ = owl::blank_prefix_of(bytes_);
  return iri_buffer_.assign(blank_prefix_).append(label);
}

void Parser::take_language(std::string_view tag) {
  language_buffer_ = base::in_lower_case(tag);
  language_ = language_buffer_;
}

bool Parser::literal() {
  const Token token = tokens_.token();
  if (token.kind != TokenKind::string) return expected(to_string(Operand::literal));
  lexical_ = token.text;
  if (token.has_escapes) {
    lexical_buffer_.clear();
    if (append_unescaped_text(lexical_buffer_, token.text))
      source_.remark(document::odd_backslash, file_, tokens_.line());
    lexical_ = lexical_buffer_;
  }
  language_ = {};
  iri_ = {};
  tokens_.advance();
  if (tokens_.is(TokenKind::language)) {
    take_language(tokens_.token().text);
    tokens_.advance();
    return true;
  }
  if (!tokens_.is(TokenKind::carets)) return !tokens_.is(TokenKind::failed);
  tokens_.advance();
  if (!iri("the name of a datatype behind '^^'")) return false;
  if (iri_ != owl::plain_literal_datatype) return true;
  iri_ = {};
  const auto plain = owl::split_plain_literal(lexical_);
  take_language(plain.language);
  lexical_ = plain.text;
  return true;
}

}  // namespace geminga::functional
