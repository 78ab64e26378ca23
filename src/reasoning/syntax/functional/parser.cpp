// The document: prefixes, the ontology with its name and imports, and what is in it.
#include "reasoning/syntax/functional/parser.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"

namespace geminga::functional {
namespace {

constexpr std::size_t shown_bytes = 60;  ///< of what was found in place of what was expected

std::string describe(const Token& token) {
  switch (token.kind) {
    case TokenKind::end:
      return "the end of the file";
    case TokenKind::failed:
      return "nothing";
    case TokenKind::word: {
      const std::string word = base::printable(token.text, shown_bytes);
      return find_production(token.text) != nullptr ? word : word + ", which is no word of this syntax";
    }
    case TokenKind::full_iri:
      return '<' + base::printable(token.text, shown_bytes) + '>';
    case TokenKind::node_id:
      return "_:" + base::printable(token.text, shown_bytes);
    case TokenKind::language:
      return '@' + base::printable(token.text, shown_bytes);
    case TokenKind::string:
      return "a text";
    case TokenKind::number:
    case TokenKind::prefixed_name:
      return base::printable(token.text, shown_bytes);
    default:
      return '\'' + std::string(token.text) + '\'';
  }
}

}  // namespace

Parser::Parser(std::string_view bytes, owl::FileId file, owl::Ontology& source, const FunctionalLimits& limits,
               std::vector<owl::Annotation>* annotations)
    : source_(source),
      file_(file),
      limits_(limits),
      bytes_(bytes),
      annotations_(annotations),
      tokens_(bytes, limits),
      head_(limits.prefixes, limits.imports),
      names_(source, file) {}

std::expected<Document, Problem> Parser::run() {
  while (tokens_.is(TokenKind::word) && tokens_.token().text == "Prefix") {
    if (!prefix_declaration()) break;
  }
  if (ontology() && !tokens_.is(TokenKind::end)) expected("the end of the file behind the ontology");
  if (tokens_.problem()) return std::unexpected(*tokens_.problem());
  if (const auto& problem = source_.problem()) return std::unexpected(Problem{0, *problem});
  return std::move(document_);
}

bool Parser::expected(std::string_view what) {
  tokens_.fail("expected " + std::string(what) + ", found " + describe(tokens_.token()));
  return false;
}

bool Parser::expect(TokenKind kind, std::string_view what) {
  if (!tokens_.is(kind)) return expected(what);
  tokens_.advance();
  return true;
}

bool Parser::prefix_declaration() {
  tokens_.advance();
  if (!expect(TokenKind::open, "'(' behind Prefix")) return false;
  const Token name = tokens_.token();
  if (name.kind != TokenKind::prefixed_name || name.prefix_bytes + 1 != name.text.size())
    return expected("a prefix that ends in a colon");
  const std::string_view prefix = name.text.substr(0, name.prefix_bytes);
  tokens_.advance();
  if (!expect(TokenKind::equals, "'=' behind the prefix")) return false;
  if (!tokens_.is(TokenKind::full_iri)) return expected("an IRI in angle brackets");
  const std::string_view iri = tokens_.token().text;
  if (auto refusal = head_.declare(prefix, iri, document_)) {
    tokens_.fail(std::move(*refusal));
    return false;
  }
  tokens_.advance();
  return expect(TokenKind::close, "')' behind the prefix");
}

bool Parser::ontology() {
  if (!tokens_.is(TokenKind::word) || tokens_.token().text != "Ontology") return expected("Prefix or Ontology");
  tokens_.advance();
  if (!expect(TokenKind::open, "'(' behind Ontology") || !header()) return false;
  while (!tokens_.is(TokenKind::close)) {
    const bool is_word = tokens_.is(TokenKind::word);
    const Production* production = is_word ? find_production(tokens_.token().text) : nullptr;
    const Form form = production == nullptr ? Form::axiom : production->form;
    is_of_ontology_ = form == Form::annotation;
    const bool is_read = form == Form::import ? import() : form == Form::annotation ? annotation() : axiom();
    if (!is_read) return false;
  }
  tokens_.advance();
  return true;
}

bool Parser::header() {
  if (!is_name()) return true;
  if (!iri("the IRI of the ontology")) return false;
  document_.ontology_iri = iri_;
  source_.set_ontology_iri(file_, iri_);
  if (!is_name()) return true;
  if (!iri("the version IRI of the ontology")) return false;
  document_.version_iri = iri_;
  return true;
}

bool Parser::import() {
  const std::uint32_t line = tokens_.line();
  tokens_.advance();
  if (!expect(TokenKind::open, "'(' behind Import") || !iri("the IRI of an ontology")) return false;
  if (auto refusal = head_.import(iri_, line, document_)) {
    tokens_.fail(std::move(*refusal));
    return false;
  }
  return expect(TokenKind::close, "')' behind the imported IRI");
}

}  // namespace geminga::functional
