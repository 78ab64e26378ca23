// A task as a file describes it in RDF or another syntax of OWL.
#ifndef GEMINGA_QUERY_TASK_FILE_HPP
#define GEMINGA_QUERY_TASK_FILE_HPP

#include <expected>
#include <string>
#include <string_view>

#include "geminga/client.hpp"
#include "query/situation.hpp"
#include "shell/exit_status.hpp"

namespace geminga::query {

/// Reads `geminga-ontology task` of a file: its one task, or that with this name or IRI. The error names the file, and
/// says what to do.
[[nodiscard]] std::expected<Plan, std::string> read_task(std::string_view json, const std::string& file,
                                                         const std::string& name);

/// Has geminga-ontology read the file, with the files of the daemon's ontology, by which the words of expressions are
/// known. The exit status of the program after an error that was said.
[[nodiscard]] std::expected<Plan, shell::ExitStatus> plan_of_file(Client& client, const std::string& file,
                                                                  const std::string& name);

}  // namespace geminga::query

#endif
