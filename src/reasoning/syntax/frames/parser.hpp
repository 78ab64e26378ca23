// Recursive descent over one document: its head, frames and sections. src/reasoning/syntax/manchester parses class
// expressions.
//
// Each function reads one production. After the first error nothing more is read, and all functions return.
#ifndef GEMINGA_REASONING_SYNTAX_FRAMES_PARSER_HPP
#define GEMINGA_REASONING_SYNTAX_FRAMES_PARSER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/document/head.hpp"
#include "reasoning/syntax/document/name_annotations.hpp"
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
         const FrameLimits& limits, std::vector<owl::Annotation>* annotations = nullptr);

  [[nodiscard]] std::expected<Document, ReadError> run();
  /// Reads prefixes, and which frames are of properties and datatypes, up to the first problem.
  void look_ahead(Declared& declared);

 private:
  // parser.cpp: the document and its head.
  void prefix_declaration();
  void ontology();
  void import();
  void frame();
  /// Leaves out the section or frame in which a problem is, by name, and goes on with the next one. False: the problem
  /// refuses the file. An axiom that was read before it counts.
  bool leave_out_wrong(std::string_view what, bool is_whole_frame);
  [[nodiscard]] bool is_section() const { return tokens_.token().kind == manchester::TokenKind::section; }
  [[nodiscard]] bool is_section(std::string_view word) const { return is_section() && tokens_.token().text == word; }
  /// The line of an octet. From call to call octets must not descend, except for problems.
  [[nodiscard]] std::uint32_t line_of(std::size_t octet);
  std::uint32_t line() { return line_of(tokens_.token().begin); }

  // parser_frames.cpp
  void frame_of(Frame frame);
  Term subject_of(Frame frame);
  /// A section that only this kind of frame has. False: it is none of these.
  bool special_section(Frame frame, Term subject);
  /// A section that is a list of members. False: this frame has no such section. `name` is the subject's.
  bool list_section(Frame frame, Term subject, std::string_view name);
  void characteristics(Term subject, bool is_data);
  void disjoint_union(Term subject);
  void has_key(Term subject);
  void property_chain(Term subject);
  void facts(Term subject);
  /// EquivalentClasses: and the other axioms outside of frames.
  void misc(std::string_view word);

  // parser_rules.cpp
  void rule();
  void skip_rule(std::uint32_t line);
  Term atoms();
  Term atom();
  Term named_atom(const manchester::Token& predicate, const std::vector<Term>& arguments);
  Term made_atom(owl::TermKind kind, Term predicate, std::vector<Term> arguments);
  std::vector<Term> rule_arguments();
  Term rule_argument();

  // parser_frames.cpp, for all of them.
  /// Whether a text begins here that never ends. Looking for other sections behind it would be quadratic.
  [[nodiscard]] bool is_endless_text() const {
    const manchester::Token& token = tokens_.token();
    return token.kind == manchester::TokenKind::bad && (token.text == "\"" || token.text == "'");
  }
  Term member(Member kind);
  Term object_property_expression();
  /// A property, whose declaration says whether it is an object property.
  Term any_property();
  void add(owl::AxiomKind kind, std::span<const Term> arguments, std::uint32_t line);
  void declare(Term entity, std::uint32_t line);
  bool take_comma();

  // parser_annotations.cpp
  void annotations();
  /// The subject of annotations of the ontology; no blank node has this name.
  static constexpr std::string_view of_ontology = "_:ontology";
  /// The annotations of a frame or of the ontology. Labels are kept if the subject is an IRI.
  void own_annotations(std::string_view subject);
  void annotation_list(std::string_view subject);
  void annotation(std::string_view subject);
  /// `SubPropertyOf: Q` and the other sections of an annotation property.
  void annotation_axiom(std::string_view subject, std::string_view word, std::string object);

  // parser_names.cpp
  std::string iri(std::string_view what);
  [[nodiscard]] std::expected<std::string, std::string> expand(const manchester::Token& token) const;
  std::expected<std::string, std::string> iri_of(owl::TermKind kind, const manchester::Token& token) override;
  std::expected<owl::TermKind, std::string> kind_of_property(const manchester::Token& token) override;
  Term literal_of(const manchester::Token& text, std::string_view datatype, std::string_view language) override;
  Term individual() override;
  void remark(std::string_view text) override { source_.remark(text, file_, line()); }
  [[nodiscard]] bool is_value_of_data(manchester::Tokenizer behind) const;
  /// Whether a name is that of a datatype that is known or declared.
  [[nodiscard]] bool names_datatype(const manchester::Token& token) const;

  const owl::FileId file_;
  const Declared& declared_;
  const FrameLimits& frame_limits_;
  const std::string_view bytes_;
  owl::AnnotationStack annotations_;
  Document document_;
  document::Head head_;
  document::NameAnnotations names_;
  std::unordered_set<Term> declarations_;
  std::string blank_prefix_;  ///< the same for the same file on every host: made of its content
  std::size_t counted_ = 0;   ///< lines were counted up to here
  std::uint32_t line_ = 1;    ///< of counted_
  std::size_t annotation_depth_ = 0;
  std::size_t wrong_parts_ = 0;  ///< sections and frames that were left out
  std::string last_text_;        ///< of the literal that was read last
  std::string last_language_;    ///< of that literal, in lower case
  std::string last_datatype_;    ///< of that literal
};

}  // namespace geminga::frames

#endif
