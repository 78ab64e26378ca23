// From what the user names, files and folders, to the ontology files that are meant.
#ifndef GEMINGA_REASONING_SYNTAX_FOLDERS_HPP
#define GEMINGA_REASONING_SYNTAX_FOLDERS_HPP

#include <cstddef>
#include <expected>
#include <span>
#include <string>
#include <vector>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/limits.hpp"

namespace geminga::syntax {

/// What the arguments mean.
struct Listing {
  std::vector<std::string> files;    ///< in the order of the arguments; of a folder, sorted by path
  std::vector<std::string> folders;  ///< those that were walked, each before those in it
  /// What stands in these folders and is no ontology file by its name and, where it is named .xml, by its begin; not
  /// what is hidden. Links to folders, which are not followed, too.
  std::vector<std::string> skipped;
};

/// A file is itself; a folder is every ontology file in it and in the folders below (.ttl .nt .rdf .owl .xml .owx .omn
/// .ofn .fss, also with .gz behind it), not what is hidden and not a Protégé catalogue. What is named twice is taken
/// once. A folder without any is an error, and so is one that holds a link to a file outside of it.
[[nodiscard]] std::expected<Listing, LoadError> list_files(std::span<const std::string> arguments,
                                                           const Limits& limits);

}  // namespace geminga::syntax

#endif
