// From the files and folders that the user names to ontology files.
#ifndef GEMINGA_REASONING_SYNTAX_FOLDERS_HPP
#define GEMINGA_REASONING_SYNTAX_FOLDERS_HPP

#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/limits.hpp"

namespace geminga::syntax {

/// The files that the arguments mean.
struct Listing {
  std::vector<std::string> files;    ///< in the order of the arguments; of a folder, sorted by path
  std::vector<std::string> folders;  ///< those that were walked, each before those in it
  /// Files in these folders that are no ontology files by their name or, for .xml, by their beginning; and links to
  /// folders, which are not followed. Hidden files are not listed.
  std::vector<std::string> skipped;
};

/// A file stands for itself. A folder stands for every ontology file in it and in the folders below (.ttl .nt .rdf .owl
/// .xml .owx .omn .ofn .fss, also with .gz), except hidden files and Protégé's catalogues. A file that is named twice
/// counts once. A folder without any ontology file is an error, and so is one with a link to a file outside of it.
/// `also` are further endings of names that count, also with .gz.
[[nodiscard]] std::expected<Listing, LoadError> list_files(std::span<const std::string> arguments,
                                                           const FileLimits& limits,
                                                           std::span<const std::string_view> also = {});

}  // namespace geminga::syntax

#endif
