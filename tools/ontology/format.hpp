// The syntax in which convert, merge, infer and query write triples.
#ifndef GEMINGA_ONTOLOGY_FORMAT_HPP
#define GEMINGA_ONTOLOGY_FORMAT_HPP

#include <expected>
#include <string>

#include "ontology/command/exit_status.hpp"
#include "reasoning/syntax/graph/graph.hpp"

namespace CLI {
class App;
}

namespace geminga::ontology {

inline constexpr const char* format_names = "turtle, rdfxml or ntriples";
inline constexpr const char* format_choices = "turtle|rdfxml|ntriples";  ///< the type of a flag

/// Adds `-o OUT`, required, and `--to FORMAT`.
void add_output(CLI::App& command, std::string& out, std::string& format);

/// Finds the format by its name, or, without one, by the name of the output; Turtle on standard output. The error is a
/// line for the user.
[[nodiscard]] std::expected<graph::Format, std::string> chosen_format(const std::string& name, const std::string& out);

/// The exit status for the problem of a graph.
[[nodiscard]] inline Exit exit_of(const graph::Graph& graph) {
  return graph.is_over_limit() ? Exit::timed_out : Exit::usage;
}

}  // namespace geminga::ontology

#endif
