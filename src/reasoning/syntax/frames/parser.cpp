#include "reasoning/syntax/frames/parser.hpp"

#include <algorithm>
#include <utility>

#include "reasoning/syntax/document/head.hpp"

namespace geminga::frames {

using manchester::ParseError;
using manchester::Token;
using manchester::Tokenizer;
using manchester::TokenKind;

Parser::Parser(std::string_view bytes, owl::FileId file, owl::Ontology& source, const Declared& declared,
               const FrameLimits& limits, std::vector<owl::Annotation>* annotations)
    : manchester::Parser(Tokenizer(bytes, section_words()), limits.expression, source),
      file_(file),
      declared_(declared),
      frame_limits_(limits),
      bytes_(bytes),
      annotations_(annotations),
      head_(limits.prefixes, limits.imports),
      names_(source, file) {}

std::uint32_t Parser::line_of(std::size_t octet) {
  const auto begin = bytes_.begin();
  if (octet < counted_)
    return 1 + static_cast<std::uint32_t>(std::count(begin, begin + static_cast<std::ptrdiff_t>(octet), '\n'));
  line_ += static_cast<std::uint32_t>(
      std::count(begin + static_cast<std::ptrdiff_t>(counted_), begin + static_cast<std::ptrdiff_t>(octet), '\n'));
  counted_ = octet;
  return line_;
}

std::expected<Document, ReadError> Parser::run() {
  while (!failed() && is_section("Prefix:")) prefix_declaration();
  if (!failed()) ontology();
  while (!failed() && tokens_.token().kind != TokenKind::end) {
    const std::size_t begin = tokens_.token().begin;
    const bool is_import = is_section("Import:");
    frame();
    if (!failed()) continue;
    if (is_import) break;                                                         // what it would have given is unknown
    if (tokens_.token().begin == begin && !is_endless_text()) tokens_.advance();  // past what begins no frame
    if (!leave_out_wrong("a frame that cannot be read", true)) break;
  }
  if (failed()) return std::unexpected(ReadError{{}, line_of(problem()->octet), problem()->text});
  if (const auto odd = tokens_.odd_backslash()) source_.remark(document::odd_backslash, file_, line_of(*odd));
  if (const auto& problem = source_.problem()) return std::unexpected(ReadError{{}, 0, *problem});
  return std::move(document_);
}

bool Parser::leave_out_wrong(std::string_view what, bool is_whole_frame) {
  const bool may_go_on = problem()->kind != ParseError::Kind::too_large && !is_endless_text() && !source_.problem();
  if (!may_go_on || wrong_parts_ >= frame_limits_.wrong_parts) return false;
  ++wrong_parts_;
  const std::string text(what);
  source_.leave_out(text + " (" + problem()->text + ")", file_, line_of(problem()->octet));
  problem_.reset();
  annotations_.drop();
  annotation_depth_ = 0;
  const auto is_end = [&] {
    if (tokens_.token().kind == TokenKind::end) return true;
    return is_section() && (!is_whole_frame || begins_frame(tokens_.token().text));
  };
  while (!is_end()) {
    if (is_endless_text()) {
      expected("a section or a frame");
      return false;
    }
    tokens_.advance();
  }
  return true;
}

void Parser::look_ahead(Declared& declared) {
  while (!failed() && is_section("Prefix:")) prefix_declaration();
  while (!failed() && tokens_.token().kind != TokenKind::end && !is_endless_text()) {
    const std::string_view word = is_section() ? tokens_.token().text : std::string_view();
    tokens_.advance();
    owl::TermKind kind = owl::TermKind::named_class;
    if (word == "ObjectProperty:") kind = owl::TermKind::object_property;
    if (word == "DataProperty:") kind = owl::TermKind::data_property;
    if (word == "Datatype:") kind = owl::TermKind::datatype;
    if (kind == owl::TermKind::named_class || tokens_.token().kind != TokenKind::name) continue;
    if (const auto name = iri_of(kind, tokens_.token())) declared.add(kind, *name);
  }
}

void Parser::prefix_declaration() {
  take();
  const Token name = tokens_.token();
  // A prefix may be a word that begins a frame elsewhere.
  if ((name.kind != TokenKind::name && !is_section()) || name.text.find(':') + 1 != name.text.size() ||
      name.text.front() == '<') {
    expected("a prefix that ends in a colon");
    return;
  }
  const std::string prefix(name.text.substr(0, name.text.size() - 1));
  take();
  if (!tokens_.token().text.starts_with('<')) {
    expected("an IRI in angle brackets");
    return;
  }
  const std::string full = iri("an IRI in angle brackets");
  if (failed()) return;
  if (auto refusal = head_.declare(prefix, full, document_))
    fail(ParseError::Kind::malformed, name.begin, std::move(*refusal));
}

// ontology = "Ontology:" [ iri [ iri ] ] *( import / annotations ) *frame
void Parser::ontology() {
  if (!is_section("Ontology:")) {
    expected("Prefix: or Ontology:");
    return;
  }
  take();
  if (is_name()) {
    document_.ontology_iri = iri("the IRI of the ontology");
    if (failed()) return;
    source_.set_ontology_iri(file_, document_.ontology_iri);
    if (is_name()) document_.version_iri = iri("the version IRI of the ontology");
  }
}

void Parser::import() {
  const std::uint32_t line = this->line();
  const std::size_t octet = take().begin;
  const std::string name = iri("the IRI of an ontology");
  if (failed()) return;
  if (auto refusal = head_.import(name, line, document_)) fail(ParseError::Kind::too_large, octet, std::move(*refusal));
}

void Parser::frame() {
  const std::string_view word = is_section() ? tokens_.token().text : std::string_view();
  parts_ = 0;
  if (word == "Import:") return import();
  if (word == "Annotations:") return own_annotations(of_ontology);
  if (word == "Class:") return frame_of(Frame::of_class);
  if (word == "ObjectProperty:") return frame_of(Frame::of_object_property);
  if (word == "DataProperty:") return frame_of(Frame::of_data_property);
  if (word == "AnnotationProperty:") return frame_of(Frame::of_annotation_property);
  if (word == "Datatype:") return frame_of(Frame::of_datatype);
  if (word == "Individual:") return frame_of(Frame::of_individual);
  if (word == "Rule:") return rule();
  misc(word);
}

}  // namespace geminga::frames
