// Frames and their sections. The productions of FRAMES.md stand above each function.
#include <array>

#include "reasoning/syntax/document/lists.hpp"
#include "reasoning/syntax/frames/parser.hpp"

namespace geminga::frames {

using manchester::Token;
using manchester::TokenKind;
using owl::AxiomKind;
using owl::TermKind;

bool Parser::take_comma() { return take_symbol(","); }

void Parser::add(AxiomKind kind, std::span<const Term> arguments, std::uint32_t line) {
  if (failed()) return;
  const std::size_t before = source_.axiom_count();
  const std::size_t ill_typed = source_.ill_typed_count();
  source_.add(kind, arguments, file_, line);
  document_.axioms += source_.axiom_count() - before;
  annotations_.attach(source_, before, ill_typed);
}

void Parser::declare(Term entity, std::uint32_t line) {
  if (!failed() && declarations_.insert(entity).second) add(AxiomKind::declaration, std::array{entity}, line);
}

owl::TermId Parser::member(Member kind) {
  switch (kind) {
    case Member::class_expression:
      return description();
    case Member::object_property:
      return object_property_expression();
    case Member::data_property:
      return is_name() ? entity(TermKind::data_property, take()) : expected("a data property");
    case Member::data_range:
      return data_range();
    case Member::individual:
      return individual();
    case Member::annotation_property:
    case Member::iri:
      break;  // no terms
  }
  return owl::thing_term;
}

// objectPropertyExpression = name / "inverse" name / "inverse" "(" name ")"
owl::TermId Parser::object_property_expression() {
  if (failed()) return owl::thing_term;
  if (is_keyword("inverse")) return property();
  return is_name() ? entity(TermKind::object_property, take()) : expected("an object property");
}

owl::TermId Parser::any_property() {
  if (failed()) return owl::thing_term;
  return is_name() || is_keyword("inverse") ? property() : expected("a property");
}

// section = WORD annotations member *( "," annotations member )
bool Parser::list_section(Frame frame, Term subject, std::string_view name) {
  if (failed() || !is_section()) return false;
  const Section* section = find_section(frame, tokens_.token().text);
  if (section == nullptr) return false;
  take();
  // OWL tools write a section without members if they have none.
  if (is_section() && !is_section("Annotations:")) return true;
  if (tokens_.token().kind == TokenKind::end) return true;
  do {
    annotations();
    if (failed()) return true;
    parts_ = 0;
    const std::uint32_t line = this->line();
    if (!section->is_axiom) {
      annotation_axiom(name, section->word,
                       iri(section->member == Member::iri ? "an IRI" : "the name of an annotation property"));
      continue;
    }
    const Term of = member(section->member);
    if (failed()) return true;
    if (section->is_subject_last) {
      add(section->kind, std::array{of, subject}, line);
    } else {
      add(section->kind, std::array{subject, of}, line);
    }
  } while (take_comma());
  return true;
}

// frame = WORD subject *section
void Parser::frame_of(Frame frame) {
  take();
  const std::uint32_t line = this->line();
  const Term subject = subject_of(frame);
  if (failed()) return;
  const TermKind kind = source_.kind(subject);
  if (kind <= TermKind::individual) declare(subject, line);
  const std::string name(kind <= TermKind::anonymous_individual ? source_.name_of(subject) : std::string_view());
  while (!failed()) {
    if (is_section("Annotations:")) {
      own_annotations(name);
    } else if (!special_section(frame, subject) && !list_section(frame, subject, name)) {
      break;
    }
    if (failed() && !leave_out_wrong("a section that cannot be read", false)) break;
  }
}

owl::TermId Parser::subject_of(Frame frame) {
  switch (frame) {
    case Frame::of_class:
      return description();
    case Frame::of_object_property:
      return object_property_expression();
    case Frame::of_data_property:
      return member(Member::data_property);
    case Frame::of_datatype:
      return is_name() ? entity(TermKind::datatype, take()) : expected("a datatype");
    case Frame::of_individual:
      return individual();
    case Frame::of_annotation_property:
      break;
  }
  const std::string name = iri("the name of an annotation property");
  return failed() ? owl::thing_term : source_.annotation_property(name);
}

bool Parser::special_section(Frame frame, Term subject) {
  const auto is_of = [&](Frame other, std::string_view word) { return frame == other && is_section(word); };
  if (is_of(Frame::of_class, "DisjointUnionOf:")) {
    disjoint_union(subject);
  } else if (is_of(Frame::of_class, "HasKey:")) {
    has_key(subject);
  } else if (is_of(Frame::of_object_property, "Characteristics:")) {
    characteristics(subject, false);
  } else if (is_of(Frame::of_data_property, "Characteristics:")) {
    characteristics(subject, true);
  } else if (is_of(Frame::of_object_property, "SubPropertyChain:")) {
    property_chain(subject);
  } else if (is_of(Frame::of_individual, "Facts:")) {
    facts(subject);
  } else {
    return false;
  }
  return true;
}

// "Characteristics:" annotations WORD *( "," annotations WORD )
void Parser::characteristics(Term subject, bool is_data) {
  take();
  do {
    annotations();
    if (failed()) return;
    const std::uint32_t line = this->line();
    const Token& word = tokens_.token();
    const Characteristic* found = word.kind == TokenKind::name ? find_characteristic(word.text, is_data) : nullptr;
    if (found == nullptr) {
      expected(is_data ? "Functional"
                       : "Functional, InverseFunctional, Reflexive, Irreflexive, Symmetric, Asymmetric or Transitive");
      return;
    }
    take();
    add(found->kind, std::array{subject}, line);
  } while (take_comma());
}

// "DisjointUnionOf:" annotations description *( "," description )
void Parser::disjoint_union(Term subject) {
  const std::uint32_t line = this->line();
  take();
  annotations();
  std::vector<Term> arguments{subject};
  do arguments.push_back(description());
  while (take_comma());
  add(AxiomKind::disjoint_union, arguments, line);
}

// "HasKey:" annotations property *( [ "," ] property )
void Parser::has_key(Term subject) {
  const std::uint32_t line = this->line();
  take();
  annotations();
  std::vector<Term> arguments{subject};
  std::vector<Term> of_data;
  do {
    const Term key = any_property();
    if (failed()) return;
    (source_.kind(key) == TermKind::data_property ? of_data : arguments).push_back(key);
  } while (take_comma() || is_name() || is_keyword("inverse"));
  arguments.insert(arguments.end(), of_data.begin(), of_data.end());
  add(AxiomKind::has_key, arguments, line);
}

// "SubPropertyChain:" annotations property 1*( "o" property ) *( "," ... )
void Parser::property_chain(Term subject) {
  take();
  do {
    annotations();
    if (failed()) return;
    const std::uint32_t line = this->line();
    std::vector<Term> chain{object_property_expression()};
    while (!failed() && tokens_.token().kind == TokenKind::name && tokens_.token().text == "o") {
      take();
      chain.push_back(object_property_expression());
    }
    if (failed()) return;
    const Term whole = document::term_of_list(source_, TermKind::object_property_chain, chain, file_, line);
    add(AxiomKind::sub_object_property_of, std::array{whole, subject}, line);
  } while (take_comma());
}

// "Facts:" annotations [ "not" ] property ( individual / literal ) *( "," ... )
void Parser::facts(Term subject) {
  take();
  do {
    annotations();
    if (failed()) return;
    parts_ = 0;
    const std::uint32_t line = this->line();
    const bool is_negative = take_keyword("not");
    const Term of = any_property();
    if (failed()) return;
    if (is_literal()) {
      const Term value = literal();
      add(is_negative ? AxiomKind::negative_data_property_assertion : AxiomKind::data_property_assertion,
          std::array{of, subject, value}, line);
    } else {
      const Term value = individual();
      add(is_negative ? AxiomKind::negative_object_property_assertion : AxiomKind::object_property_assertion,
          std::array{of, subject, value}, line);
    }
  } while (take_comma());
}

// misc = WORD annotations member 1*( "," member )
void Parser::misc(std::string_view word) {
  const std::uint32_t line = this->line();
  Member members = Member::class_expression;
  AxiomKind kind = AxiomKind::equivalent_classes;
  bool are_properties = false;
  if (word == "EquivalentClasses:") {
    kind = AxiomKind::equivalent_classes;
  } else if (word == "DisjointClasses:") {
    kind = AxiomKind::disjoint_classes;
  } else if (word == "EquivalentProperties:" || word == "DisjointProperties:") {
    are_properties = true;
  } else if (word == "SameIndividual:" || word == "DifferentIndividuals:") {
    members = Member::individual;
    kind = word == "SameIndividual:" ? AxiomKind::same_individual : AxiomKind::different_individuals;
  } else {
    expected("a frame like Class:, an axiom like DisjointClasses:, or the end");
    return;
  }
  take();
  annotations();
  std::vector<Term> arguments;
  do {
    arguments.push_back(are_properties ? any_property() : member(members));
  } while (!failed() && take_comma());
  if (failed()) return annotations_.drop();
  if (are_properties) {
    const bool is_data = source_.kind(arguments.front()) == TermKind::data_property;
    const bool is_disjoint = word == "DisjointProperties:";
    kind = is_data ? (is_disjoint ? AxiomKind::disjoint_data_properties : AxiomKind::equivalent_data_properties)
                   : (is_disjoint ? AxiomKind::disjoint_object_properties : AxiomKind::equivalent_object_properties);
  }
  if (document::says_nothing(source_, kind, arguments.size(), file_, line)) return annotations_.drop();
  add(kind, arguments, line);
}

}  // namespace geminga::frames
