#include "ontology/format.hpp"

#include <CLI/CLI.hpp>

#include "ontology/command/options.hpp"
#include "ontology/command/output.hpp"

namespace geminga::ontology {

void add_output(CLI::App& command, std::string& out, std::string& format) {
  add_output(command, out);
  command
      .add_option("--to", format,
                  std::string("the syntax to write: ") + format_names + "; without it, by the name of OUT")
      ->type_name(format_choices);
}

std::expected<graph::Format, std::string> chosen_format(const std::string& name, const std::string& out) {
  if (name.empty() && out == to_standard_output) return graph::Format::turtle;
  const auto format = name.empty() ? graph::format_of_file(out) : graph::find_format(name);
  if (format) return *format;
  return std::unexpected(name.empty() ? out + ": the name ends in none of .ttl, .nt, .owl, .rdf and .xml: write --to " +
                                            format_names
                                      : name + " is no format: write --to " + format_names);
}

}  // namespace geminga::ontology
