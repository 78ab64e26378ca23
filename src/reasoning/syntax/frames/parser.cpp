#include "reasoning/syntax/frames/parser.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"

namespace geminga::frames {

using manchester::ParseError;
using manchester::Token;
using manchester::Tokenizer;
using manchester::TokenKind;

Parser::Parser(std::string_view bytes, owl::FileId file, owl::Ontology& source, const Declared& declared,
               const Limits& limits, std::vector<owl::Annotation>* annotations)
    : manchester::Parser(Tokenizer(bytes, section_words()), limits.expression, source),
      file_(file),
      declared_(declared),
      frame_limits_(limits),
      bytes_(bytes),
      annotations_(annotations) {
  // Section 2.1 of the note: every document knows these.
  prefixes_.emplace("owl", "http://www.w3.org/2002/07/owl#");
  prefixes_.emplace("rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#");
  prefixes_.emplace("rdfs", "http://www.w3.org/2000/01/rdf-schema#");
  prefixes_.emplace("xsd", "http://www.w3.org/2001/XMLSchema#");
}

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
  while (!failed() && tokens_.token().kind != TokenKind::end) frame();
  if (failed()) return std::unexpected(ReadError{{}, line_of(problem()->octet), problem()->text});
  if (const auto& problem = source_.problem()) return std::unexpected(ReadError{{}, 0, *problem});
  return std::move(document_);
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
  if (name.kind != TokenKind::name || name.text.find(':') + 1 != name.text.size() || name.text.front() == '<') {
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
  const auto [known, is_new] = prefixes_.try_emplace(prefix, full);
  if (known->second != full) {
    fail(ParseError::Kind::malformed, name.begin,
         "the prefix " + base::printable(prefix, 60) + ": already stands for <" + base::printable(known->second, 60) +
             '>');
    return;
  }
  const auto is_same = [&](const owl::DeclaredPrefix& declared) { return declared.prefix == prefix; };
  if (!is_new && std::ranges::any_of(document_.prefixes, is_same)) return;
  if (document_.prefixes.size() >= frame_limits_.prefixes) {
    fail(ParseError::Kind::too_large, name.begin, "more than " + std::to_string(frame_limits_.prefixes) + " prefixes");
    return;
  }
  document_.prefixes.push_back({prefix, full});
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
  std::string name = iri("the IRI of an ontology");
  if (failed() || !imported_.insert(name).second) return;
  if (document_.imports.size() >= frame_limits_.imports) {
    fail(ParseError::Kind::too_large, octet, "more than " + std::to_string(frame_limits_.imports) + " imports");
    return;
  }
  document_.imports.push_back({std::move(name), line});
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
