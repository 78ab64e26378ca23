// Where the sources of a compiled ontology are: kept relative to its own folder, so that both can be moved together.
#ifndef GEMINGA_REASONING_OWL_SOURCE_PATHS_HPP
#define GEMINGA_REASONING_OWL_SOURCE_PATHS_HPP

#include <string>

namespace geminga::owl {

/// The folder of a file: absolute, without `.` and `..`.
[[nodiscard]] std::string folder_of(const std::string& path);

/// A path as it is written into a compiled form in `folder`, which folder_of() gave: relative to it.
[[nodiscard]] std::string seen_from_folder(const std::string& folder, const std::string& path);

/// The other way round: the absolute path of what a compiled form in `folder` names. Where `folder` is empty, and for
/// an absolute path, it is the path itself.
[[nodiscard]] std::string seen_from_here(const std::string& folder, const std::string& path);

}  // namespace geminga::owl

#endif
