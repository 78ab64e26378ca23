#include "query/triples/class_triples.hpp"

#include <expected>
#include <string>

#include "base/text.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/manchester/parser.hpp"

namespace geminga::query {
namespace {

using graph::Node;
using manchester::Token;
using manchester::TokenKind;
using owl::TermKind;

constexpr std::string_view rdfs_literal = "http://www.w3.org/2000/01/rdf-schema#Literal";
constexpr manchester::ExpressionLimits limits{};

/// Reads expressions whose names are all `<IRI>`. Without an ontology, the kind of a property is told by what follows.
class FullReader final : public manchester::Parser {
 public:
  FullReader(std::string_view text, owl::Ontology& source) : Parser(manchester::Tokenizer(text), limits, source) {}

  /// The expression that the whole text is. owl::Thing after a problem.
  owl::TermId read() {
    const owl::TermId term = description();
    return tokens_.token().kind == TokenKind::end ? term : expected("the end");
  }

 private:
  static bool is_full(const Token& token) {
    return token.kind == TokenKind::name && token.text.size() > 2 && token.text.front() == '<';
  }
  std::expected<std::string, std::string> iri_of(TermKind /*kind*/, const Token& token) override {
    if (!is_full(token)) return std::unexpected("no full IRI");
    return std::string(token.text.substr(1, token.text.size() - 2));
  }
  std::expected<TermKind, std::string> kind_of_property(const Token& /*token*/) override {
    return is_data_next(tokens_) ? TermKind::data_property : TermKind::object_property;
  }
  owl::TermId literal_of(const Token& text, std::string_view datatype, std::string_view language) override {
    return source_.literal(text.value, datatype, language);
  }

  /// Whether behind `some`, `min 2` and the like there is a literal or a datatype of OWL 2.
  static bool is_data_next(manchester::Tokenizer behind) {
    const auto is = [&](TokenKind kind, std::string_view text) {
      return behind.token().kind == kind && behind.token().text == text;
    };
    const auto is_truth = [&] { return is(TokenKind::keyword, "true") || is(TokenKind::keyword, "false"); };
    while (behind.token().kind == TokenKind::keyword && !is_truth()) {
      const bool is_counted =
          is(TokenKind::keyword, "min") || is(TokenKind::keyword, "max") || is(TokenKind::keyword, "exactly");
      behind.advance();
      if (is_counted && behind.token().kind == TokenKind::number) behind.advance();
    }
    while (is(TokenKind::symbol, "{") || is(TokenKind::symbol, "(") || is(TokenKind::keyword, "not")) behind.advance();
    const Token& token = behind.token();
    if (token.kind == TokenKind::string || token.kind == TokenKind::number || is_truth()) return true;
    if (!is_full(token)) return false;
    const std::string_view iri = token.text.substr(1, token.text.size() - 2);
    return owl::Datatype::find(iri).has_value() || iri == rdfs_literal;
  }
};

std::string text_of(const Node& node) {
  if (node.kind == Node::Kind::blank) return "_:" + node.text;
  if (node.kind == Node::Kind::iri) return iri_node(node.text);
  if (!node.language.empty()) return literal_node(node.text) + '@' + node.language;
  return literal_node(node.text) + (node.datatype.empty() ? "" : "^^" + iri_node(node.datatype));
}

}  // namespace

bool ClassTriples::add(std::string_view individual_iri, std::string_view expression) {
  if (expression.size() > limits.text_bytes || !base::is_valid_utf8(expression)) return false;
  FullReader reader(expression, source_);
  const owl::TermId term = reader.read();
  if (reader.problem() || source_.problem()) return false;
  const std::size_t before = source_.axiom_count();
  source_.add(owl::AxiomKind::class_assertion, {term, source_.individual(individual_iri)}, file_, 0);
  return source_.axiom_count() > before;
}

void ClassTriples::write(Triples& triples) const {
  graph::AxiomTriples writer(source_, [&](const Node& subject, const Node& predicate, const Node& object) {
    triples.add_nodes(text_of(subject), predicate.text, text_of(object));
  });
  for (std::size_t index = 0; index < source_.axiom_count(); ++index) writer.add(source_.axiom(index));
}

}  // namespace geminga::query
