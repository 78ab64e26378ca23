// Triples as they are written: Turtle or N-Triples.
#ifndef GEMINGA_QUERY_TRIPLES_TRIPLES_HPP
#define GEMINGA_QUERY_TRIPLES_TRIPLES_HPP

#include <cstdint>
#include <string>
#include <string_view>

namespace geminga::query {

enum class TripleSyntax : std::uint8_t { turtle, n_triples };

inline constexpr std::string_view core_namespace = "https://geminga.example/core#";

/// A node in the syntax of N-Triples, which Turtle shares (RDF 1.1 N-Triples). Whatever the text is, the node is one
/// node: what an IRI must not hold is written in percent, what a literal must not is escaped, bad UTF-8 is replaced.
[[nodiscard]] std::string iri_node(std::string_view iri);
[[nodiscard]] std::string literal_node(std::string_view text);
/// A literal of a datatype of XML Schema, e.g. `decimal`.
[[nodiscard]] std::string literal_node(std::string_view text, std::string_view datatype);
/// A decimal where the text is one, e.g. `-12.5`; else a literal.
[[nodiscard]] std::string value_node(std::string_view text);

/// Collects a document. In Turtle the triples of one subject that follow each other are one statement.
class Triples {
 public:
  explicit Triples(TripleSyntax syntax);

  /// The subject and the predicate are IRIs, the object is a node.
  void add(std::string_view subject, std::string_view predicate, std::string_view object) {
    add_nodes(iri_node(subject), predicate, object);
  }
  /// The subject is a node, too, which may be a blank one such as `_:g1`.
  void add_nodes(const std::string& subject, std::string_view predicate, std::string_view object);
  /// A triple with a word of the core vocabulary's namespace as its predicate.
  void add_word(std::string_view subject, std::string_view word, std::string_view object) {
    add(subject, std::string(core_namespace) + std::string(word), object);
  }
  void add_type(std::string_view subject, std::string_view class_iri);
  [[nodiscard]] std::string finish() &&;

 private:
  [[nodiscard]] std::string predicate_node(std::string_view predicate) const;

  TripleSyntax syntax_;
  std::string text_;
  std::string subject_;  ///< of the statement that is open, in Turtle
};

}  // namespace geminga::query

#endif
