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

bool begins_document(std::string_view word) { return word == "Prefix" || word == "Ontology"; }

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
  if (ontology() && !tokens_.is(TokenKind::end)) {
    const bool is_second = tokens_.is(TokenKind::word) && begins_document(tokens_.token().text);
    if (is_second) tokens_.fail("holds a second ontology: put each into a file of its own");
    expected("the end of the file behind the ontology");
  }
  if (tokens_.problem()) return std::unexpected(*tokens_.problem());
  if (const auto& problem = source_.problem()) return std::unexpected(Problem{0, *problem});
  return std::move(document_);
}

bool Parser::expected(std::string_view what) {
  return fault("expected " + std::string(what) + ", found " + describe(tokens_.token()));
}

bool Parser::fault(std::string text) {
  if (!tokens_.problem()) has_fault_ = true;
  tokens_.fail(std::move(text));
  return false;
}

bool Parser::leave_out_wrong(const Tokenizer::Place& place) {
  if (!has_fault_ || wrong_axioms_ >= limits_.wrong_axioms) return false;
  const Tokenizer::Place found = tokens_.place();
  const Problem problem = *tokens_.problem();
  tokens_.go_back(place);
  if (!skip_axiom()) {
    tokens_.go_back(found);
    tokens_.fail(problem);
    return false;
  }
  has_fault_ = false;
  ++wrong_axioms_;
  depth_ = 0;
  annotations_.drop();
  source_.leave_out("an axiom that cannot be read (" + problem.text + ")", file_, problem.line);
  return true;
}

bool Parser::skip_axiom() {
  if (!tokens_.is(TokenKind::word)) return false;
  tokens_.advance();
  if (!tokens_.is(TokenKind::open)) return false;
  std::uint64_t open = 0;
  do {
    if (tokens_.is(TokenKind::end) || tokens_.is(TokenKind::failed)) return false;
    if (tokens_.is(TokenKind::open)) ++open;
    if (tokens_.is(TokenKind::close)) --open;
    // The word of an axiom stands within no other one, so that a closing bracket is missing.
    const Production* const production = tokens_.is(TokenKind::word) ? find_production(tokens_.token().text) : nullptr;
    if (production != nullptr && (production->form >= Form::axiom || production->form == Form::import)) return true;
    tokens_.advance();
  } while (open != 0);
  return true;
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
    const Tokenizer::Place begin = tokens_.place();
    const bool is_word = tokens_.is(TokenKind::word);
    const Production* production = is_word ? find_production(tokens_.token().text) : nullptr;
    const Form form = production == nullptr ? Form::axiom : production->form;
    is_of_ontology_ = form == Form::annotation;
    const bool is_read = form == Form::import ? import() : form == Form::annotation ? annotation() : axiom();
    if (!is_read && (form == Form::import || !leave_out_wrong(begin))) return false;
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
