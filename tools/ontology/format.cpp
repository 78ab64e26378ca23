#include "ontology/format.hpp"

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

#include "base/text.hpp"
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
  writing::Written written;
  const Exit exit = put_pieces(out, [&](const PutPiece& piece) {
    written = writing::write(document, syntax, piece);
    return written.problem;
  });
  if (exit != Exit::yes) return exit;
  const auto first_of = [](const std::vector<std::string>& names) {
    return "<" + base::printable(names.front(), 200) + (names.size() == 1 ? ">" : ">, ...");
  };
  if (written.unsaid_annotations > 0)
    say_error(counted(written.unsaid_annotations, "annotation of a declaration is", "annotations of declarations are") +
              " not written: Manchester syntax has no place for them");
  if (!written.declared_subjects.empty())
    say_error(
        counted(written.declared_subjects.size(), "name that is", "names that are") +
        " the subject of annotations alone " +
        (written.declared_subjects.size() == 1 ? "is written as an individual" : "are written as individuals") +
        ", because Manchester syntax has no other place for the annotations: " + first_of(written.declared_subjects));
  if (!written.ambiguous_properties.empty())
    say_error(counted(written.ambiguous_properties.size(), "property is", "properties are") +
              " both of objects and of data, which Manchester syntax does not tell apart; restrictions may be read as "
              "those of the other kind: " +
              first_of(written.ambiguous_properties));
  return exit;
}

}  // namespace geminga::ontology
