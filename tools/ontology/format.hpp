// The syntax in which convert, merge, infer and query write.
#ifndef GEMINGA_ONTOLOGY_FORMAT_HPP
#define GEMINGA_ONTOLOGY_FORMAT_HPP

#include <expected>
#include <string>
#include <variant>

#include "ontology/command/exit_status.hpp"
#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/syntax.hpp"
#include "reasoning/syntax/writing/document.hpp"

namespace CLI {
class App;
}

namespace geminga::ontology {

/// The syntax of a document: one of triples, or one of OWL's own.
using DocumentFormat = std::variant<graph::Format, syntax::Syntax>;

inline constexpr const char* document_format_names = "turtle, rdfxml, ntriples, functional, manchester or owlxml";
inline constexpr const char* document_format_choices = "turtle|rdfxml|ntriples|functional|manchester|owlxml";
inline constexpr const char* format_names = "turtle, rdfxml or ntriples";
inline constexpr const char* format_choices = "turtle|rdfxml|ntriples";  ///< the type of a flag

/// Adds `-o OUT`, required, and `--to FORMAT` for a document.
void add_output(CLI::App& command, std::string& out, std::string& format);

/// Finds the format by its name, or, without one, by the name of the output; Turtle on standard output. The error is a
/// line for the user.
[[nodiscard]] std::expected<graph::Format, std::string> chosen_format(const std::string& name, const std::string& out);

/// The same for a document.
[[nodiscard]] std::expected<DocumentFormat, std::string> chosen_document_format(const std::string& name,
                                                                                const std::string& out);

/// Writes a document in a syntax of OWL's own, and says what has no place in it.
[[nodiscard]] Exit put_document(const std::string& out, const writing::Document& document, syntax::Syntax syntax);

/// The exit status for the problem of a graph.
[[nodiscard]] inline Exit exit_of(const graph::Graph& graph) {
  return graph.is_over_limit() ? Exit::timed_out : Exit::usage;
}

}  // namespace geminga::ontology

#endif
