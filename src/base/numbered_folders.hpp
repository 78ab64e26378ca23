// Folders whose names are numbers.
#ifndef GEMINGA_BASE_NUMBERED_FOLDERS_HPP
#define GEMINGA_BASE_NUMBERED_FOLDERS_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace geminga::base {

/// The folders in a folder that are named by a whole number without needless zeros, ascending. Links are not followed.
/// A folder that cannot be read has none.
[[nodiscard]] std::vector<std::uint64_t> numbered_folders(const std::string& folder);

}  // namespace geminga::base

#endif
