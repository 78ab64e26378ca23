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

/// The most files that are left out because they cannot be read; with one more, everything is refused.
inline constexpr std::size_t max_left_out = 16;

/// Whether a text is the name of a file and not something else that may stand in its place: it ends as the names of
/// ontology files do (.ttl .nt .trig .nq .rdf .owl .xml .owx .omn .ofn .fss, also with .gz), and is no IRI with `://`.
[[nodiscard]] bool is_ontology_name(std::string_view text);

/// The files that the arguments mean.
struct Listing {
  std::vector<std::string> files;    ///< in the order of the arguments; of a folder, sorted by path
  std::vector<std::string> folders;  ///< those that were walked, each before those in it
  /// Files in these folders that are no ontology files by their name or, for .xml, by their beginning; and links to
  /// folders, which are not followed. Hidden files are not listed.
  std::vector<std::string> skipped;
};

/// A file stands for itself. A folder stands for every ontology file in it and in the folders below (.ttl .nt .trig .nq
/// .rdf .owl .xml .owx .omn .ofn .fss, also with .gz), except hidden files and Protégé's catalogues. A file that is
/// named twice counts once. A folder without any ontology file is an error, and so is one with a link to a file outside
/// of it. `also` are further endings of names that count, also with .gz. Where `left_out` is not null, what cannot be
/// resolved or listed below a folder, and a link to a file outside of it, are left out and added there, up to
/// max_left_out.
[[nodiscard]] std::expected<Listing, LoadError> list_files(std::span<const std::string> arguments,
                                                           const FileLimits& limits,
                                                           std::span<const std::string_view> also = {},
                                                           std::vector<LoadError>* left_out = nullptr);

}  // namespace geminga::syntax

#endif
