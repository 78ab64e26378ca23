// Recursive descent over the tokens of one file, from the document down to names and literals.
//
// Each function reads one piece of the grammar and returns whether it was there. After the first error the tokenizer
// gives no more tokens, and all functions return. Terms that were read stand on a stack.
#ifndef GEMINGA_REASONING_SYNTAX_FUNCTIONAL_PARSER_HPP
#define GEMINGA_REASONING_SYNTAX_FUNCTIONAL_PARSER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/document/head.hpp"
#include "reasoning/syntax/document/name_annotations.hpp"
#include "reasoning/syntax/functional/grammar.hpp"
#include "reasoning/syntax/functional/limits.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "reasoning/syntax/functional/tokenizer.hpp"

namespace geminga::functional {

/// Reads one file once.
class Parser {
 public:
  /// The bytes have passed check_text(). All arguments must outlive the parser.
  Parser(std::string_view bytes, owl::FileId file, owl::Ontology& source, const FunctionalLimits& limits,
         std::vector<owl::Annotation>* annotations);

  [[nodiscard]] std::expected<Document, Problem> run();

 private:
  // parser.cpp: the document, its header, and what all others use.
  bool prefix_declaration();
  bool ontology();
  bool header();
  bool import();
  bool expect(TokenKind kind, std::string_view what);
  /// Fails with the words "expected ..., found ...". Always false.
  bool expected(std::string_view what);
  /// Fails with a fault that costs the axiom in which it is, and not the file. Always false.
  bool fault(std::string text);
  /// Leaves out the axiom that begins at this place and has a fault. False: the fault costs the file, as no axiom
  /// begins there, its end is not found, or there are too many.
  bool leave_out_wrong(const Tokenizer::Place& place);
  /// Walks from the word of an axiom behind its last bracket, or up to the next axiom if brackets are missing. False:
  /// neither is there.
  bool skip_axiom();

  // parser_axioms.cpp
  bool axiom();
  /// The operands of an axiom, behind its bracket and annotations. Terms go to the stack.
  bool axiom_operands(const Production& production);
  bool declaration();
  bool bracketed(Operand wanted);
  bool extension(std::string_view construct, std::uint32_t line);
  /// Declares the entity on the stack, once in a file.
  void declare(std::uint32_t line);
  /// Adds the terms on the stack as one axiom, or leaves the axiom out if something in it has no term.
  void add(owl::AxiomKind kind, std::uint32_t line);
  /// The same for an axiom that the grammar's table describes. One over too short a list may say something else, or
  /// nothing.
  void add_list_or_other(const Production& production, std::uint32_t line);

  // parser_annotations.cpp
  bool annotation();
  bool annotations();
  bool annotation_value();
  bool annotation_assertion();
  bool annotation_axiom(std::string_view word);
  /// Adds an annotation whose value was read last.
  void keep(owl::Annotation annotation, TokenKind value, std::size_t level);

  // parser_expressions.cpp
  bool operand(Operand wanted);
  bool operands(const Production& production);
  bool expression(Operand wanted);
  bool n_ary_data();
  /// The operands of a part of a rule that the table does not describe, and the IRI that it begins with.
  bool rule_operands(const Production& production, std::string& name);
  bool facet();
  bool counted(std::uint32_t& number);
  /// One or more, up to the closing bracket, which is left.
  bool repeated(Operand wanted);
  bool too_many_operands();
  /// Goes one level deeper if the limit allows it. The caller goes back.
  bool descend();

  // parser_names.cpp
  [[nodiscard]] bool is_name() const { return tokens_.is(TokenKind::full_iri) || tokens_.is(TokenKind::prefixed_name); }
  /// Reads a name; its IRI is in iri_.
  bool iri(std::string_view what);
  bool resolve(const Token& name);
  /// These two leave a term on the stack.
  bool entity(owl::TermKind kind, std::string_view what);
  bool individual(std::string_view what);
  /// The name of a blank node, which no other file has; valid until the next name.
  std::string_view blank_name(std::string_view label);
  /// Reads a literal; it is in lexical_, language_ and, the datatype, iri_.
  bool literal();
  void take_language(std::string_view tag);

  owl::Ontology& source_;
  const owl::FileId file_;
  const FunctionalLimits& limits_;
  const std::string_view bytes_;
  owl::AnnotationStack annotations_;
  Tokenizer tokens_;
  Document document_;

  document::Head head_;
  std::string last_prefix_;                       ///< its IRI is last_prefix_iri_
  const std::string* last_prefix_iri_ = nullptr;  ///< in head_
  document::NameAnnotations names_;
  std::string blank_prefix_;  ///< the same for the same file on every host: made of its content

  std::string_view iri_;  ///< the last name; valid until the next
  std::string iri_buffer_;
  std::string_view lexical_;   ///< of the last literal, without escapes
  std::string_view language_;  ///< of the last literal, in lower case
  std::string lexical_buffer_;
  std::string language_buffer_;

  std::vector<owl::TermId> terms_;
  std::size_t depth_ = 0;        ///< of expressions or annotations
  bool is_of_ontology_ = false;  ///< an annotation of the ontology is being read
  bool has_fault_ = false;       ///< the problem of the tokens costs an axiom only
  std::size_t wrong_axioms_ = 0;
  const char* obstacle_ = nullptr;  ///< the part of the current axiom that has no term
  std::vector<bool> declared_;      ///< by term
};

}  // namespace geminga::functional

#endif
