// Konclude as a second opinion: runs it on a document, and reads the taxonomy that it writes.
#ifndef GEMINGA_TESTS_COMPARE_KONCLUDE_HPP
#define GEMINGA_TESTS_COMPARE_KONCLUDE_HPP

#include <expected>
#include <filesystem>
#include <string>

#include "cases/taxonomy.hpp"
#include "compare/timed_run.hpp"

namespace geminga::compare {

/// Whether there is a program of that name on the PATH.
[[nodiscard]] bool is_konclude_installed();

/// Whether it has a model. The error says what happened: Konclude did not end within `seconds`, or said neither.
[[nodiscard]] std::expected<bool, std::string> konclude_consistency(const std::filesystem::path& file,
                                                                    unsigned seconds = 60, Effort* effort = nullptr);

/// The closure as cases::closure_of() gives it, with whole IRIs. `file` is in functional-style syntax or RDF/XML. The
/// error says what happened: it did not end within `seconds`, or said no word that is understood.
/// Konclude 0.7 hangs with one thread (`-w 1`), so it gets two. `effort`, if not null, is what its last run took.
[[nodiscard]] std::expected<cases::Closure, std::string> konclude_closure(const std::filesystem::path& file,
                                                                          unsigned seconds = 60,
                                                                          Effort* effort = nullptr);

/// The types of named individuals, one `INDIVIDUAL < CLASS` line each, sorted and without owl:Thing, or the one line
/// `inconsistent`. Errors as konclude_closure().
[[nodiscard]] std::expected<cases::Closure, std::string> konclude_types(const std::filesystem::path& file,
                                                                        unsigned seconds = 60,
                                                                        Effort* effort = nullptr);

/// Reads the OWL/XML that Konclude writes for a taxonomy.
[[nodiscard]] std::expected<cases::Closure, std::string> closure_of_owl_xml(const std::filesystem::path& file);

}  // namespace geminga::compare

#endif
