#include "ontology/format.hpp"

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

#include "ontology/command/options.hpp"
#include "ontology/command/output.hpp"
#include "ontology/command/words.hpp"
#include "reasoning/syntax/writing/write.hpp"

namespace geminga::ontology {
namespace {

std::optional<syntax::Syntax> find_syntax(std::string_view name) {
  if (name == "functional" || name == "ofn" || name == "fss") return syntax::Syntax::functional;
  if (name == "manchester" || name == "omn") return syntax::Syntax::manchester;
  if (name == "owlxml" || name == "owx") return syntax::Syntax::owl_xml;
  return std::nullopt;
}

}  // namespace

void add_output(CLI::App& command, std::string& out, std::string& format) {
  add_output(command, out);
  command
      .add_option("--to", format,
                  std::string("the syntax to write: ") + document_format_names + "; without it, by the name of OUT")
      ->type_name(document_format_choices);
}

std::expected<graph::Format, std::string> chosen_format(const std::string& name, const std::string& out) {
  if (name.empty() && out == to_standard_output) return graph::Format::turtle;
  const auto format = name.empty() ? graph::format_of_file(out) : graph::find_format(name);
  if (format) return *format;
  return std::unexpected(name.empty() ? out + ": the name ends in none of .ttl, .nt, .owl, .rdf and .xml: write --to " +
                                            format_names
                                      : name + " is no format: write --to " + format_names);
}

std::expected<DocumentFormat, std::string> chosen_document_format(const std::string& name, const std::string& out) {
  const std::size_t dot = out.rfind('.');
  const std::string_view end = dot == std::string::npos ? std::string_view() : std::string_view(out).substr(dot + 1);
  if (const auto syntax = find_syntax(name.empty() ? end : name)) return DocumentFormat(*syntax);
  const auto triples = chosen_format(name, out);
  if (triples) return DocumentFormat(*triples);
  return std::unexpected(name.empty()
                             ? out +
                                   ": the name ends in none of .ttl, .nt, .owl, .rdf, .xml, .ofn, .omn and .owx: "
                                   "write --to " +
                                   document_format_names
                             : name + " is no format: write --to " + document_format_names);
}

Exit put_document(const std::string& out, const writing::Document& document, syntax::Syntax syntax) {
  std::size_t unsaid = 0;
  std::vector<std::string> ambiguous;
  const Exit exit = put_pieces(out, [&](const PutPiece& piece) {
    writing::Written written = writing::write(document, syntax, piece);
    unsaid = written.unsaid_annotations;
    ambiguous = std::move(written.ambiguous_properties);
    return written.problem;
  });
  if (exit == Exit::yes && unsaid > 0)
    say_error(counted(unsaid, "annotation of a declaration is", "annotations of declarations are") +
              " not written: Manchester syntax has no place for them");
  if (exit == Exit::yes && !ambiguous.empty())
    say_error(counted(ambiguous.size(), "property is", "properties are") +
              " both of objects and of data, which Manchester syntax does not tell apart; restrictions may be read as "
              "those of the "
              "other kind: <" +
              ambiguous.front() + (ambiguous.size() == 1 ? ">" : ">, ..."));
  return exit;
}

}  // namespace geminga::ontology
