// Recursive descent over one document: its head, frames, sections; class expressions are those of
// src/reasoning/syntax/manchester.
//
// Every function below reads one piece of the grammar; once one has failed, nothing more is read, and all return.
#ifndef GEMINGA_REASONING_SYNTAX_FRAMES_PARSER_HPP
#define GEMINGA_REASONING_SYNTAX_FRAMES_PARSER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/frames/limits.hpp"
#include "reasoning/syntax/frames/read.hpp"
#include "reasoning/syntax/frames/sections.hpp"
#include "reasoning/syntax/manchester/parser.hpp"

namespace geminga::frames {

/// Reads one file once.
class Parser final : private manchester::Parser {
 public:
  /// The bytes are valid UTF-8 without NUL. All arguments must outlive the parser.
  Parser(std::string_view bytes, owl::FileId file, owl::Ontology& source, const Declared& declared,
         const Limits& limits, std::vector<owl::Annotation>* annotations = nullptr);

  [[nodiscard]] std::expected<Document, ReadError> run();
  /// Reads prefixes, and the names of frames of properties and datatypes, up to the first problem.
  void look_ahead(Declared& declared);

 private:
  // parser.cpp: the document and its head.
  void prefix_declaration();
  void ontology();
  void import();
  void frame();
  [[nodiscard]] bool is_section() const { return tokens_.token().kind == manchester::TokenKind::section; }
  [[nodiscard]] bool is_section(std::string_view word) const { return is_section() && tokens_.token().text == word; }
  /// The line of an octet. Octets only grow from one call to the next but for those of problems.
  [[nodiscard]] std::uint32_t line_of(std::size_t octet);
  std::uint32_t line() { return line_of(tokens_.token().begin); }

  // parser_frames.cpp
  void class_frame();
  void object_property_frame();
  void data_property_frame();
  void annotation_property_frame();
  void datatype_frame();
  void individual_frame();
  /// A section that consists of a list of members; false: it is none of this frame. `name` is the subject's.
  bool list_section(Frame frame, Term subject, std::string_view name = {});
  void characteristics(Term subject, bool is_data);
  void disjoint_union(Term subject);
  void has_key(Term subject);
  void property_chain(Term subject);
  void facts(Term subject);
  /// EquivalentClasses: and its like, outside of frames.
  void misc(std::string_view word);
  void rule();
  /// Whether this is the begin of a text that never ends: to look behind it for others would be quadratic.
  [[nodiscard]] bool is_endless_text() const {
    const manchester::Token& token = tokens_.token();
    return token.kind == manchester::TokenKind::bad && (token.text == "\"" || token.text == "'");
  }
  Term member(Member kind);
  Term object_property_expression();
  /// A property, of which its declaration says whether it is one of objects.
  Term any_property();
  void add(owl::AxiomKind kind, std::span<const Term> arguments, std::uint32_t line);
  void declare(Term entity, std::uint32_t line);
  bool take_comma();

  // parser_annotations.cpp
  void annotations();
  /// The subject of annotations of the ontology; no blank node has this name.
  static constexpr std::string_view of_ontology = "_:ontology";
  /// A frame's own annotations, or the ontology's; labels are kept where the subject is an IRI.
  void own_annotations(std::string_view subject);
  void annotation_list(std::string_view subject);
  void annotation(std::string_view subject);
  /// `SubPropertyOf: Q` of an annotation property and its like.
  void annotation_axiom(std::string_view subject, std::string_view word, std::string object);

  // parser_names.cpp
  std::string iri(std::string_view what);
  [[nodiscard]] std::expected<std::string, std::string> expand(const manchester::Token& token) const;
  std::expected<std::string, std::string> iri_of(owl::TermKind kind, const manchester::Token& token) override;
  std::expected<owl::TermKind, std::string> kind_of_property(const manchester::Token& token) override;
  Term literal_of(const manchester::Token& text, std::string_view datatype, std::string_view language) override;
  Term individual() override;
  [[nodiscard]] bool is_value_of_data(manchester::Tokenizer behind) const;

  struct TextHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };

  const owl::FileId file_;
  const Declared& declared_;
  const Limits& frame_limits_;
  const std::string_view bytes_;
  owl::AnnotationStack annotations_;
  Document document_;
  std::unordered_map<std::string, std::string, TextHash, std::equal_to<>> prefixes_;
  std::unordered_set<std::string> imported_;
  std::unordered_set<Term> declarations_;
  std::string blank_prefix_;  ///< the same for the same file on every host: made of its content
  std::size_t counted_ = 0;   ///< lines were counted up to here
  std::uint32_t line_ = 1;    ///< of counted_
  std::size_t annotation_depth_ = 0;
  std::string last_text_;      ///< of the literal that was read last
  std::string last_language_;  ///< of that literal, in lower case
  std::string last_datatype_;  ///< of that literal
};

}  // namespace geminga::frames

#endif
