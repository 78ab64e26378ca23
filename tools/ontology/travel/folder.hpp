// An ontology that arrived, written as a folder: whole, or not at all.
#ifndef GEMINGA_ONTOLOGY_TRAVEL_FOLDER_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_FOLDER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/travel/manifest.hpp"

namespace geminga::ontology {

/// Whether a folder was written, or held the same files already.
enum class Written : std::uint8_t { made, was_there };

/// Writes the files into a new folder beside `folder`, and gives it that name when they are on the disk. `folder` may
/// be there if it is empty, or holds these very files and nothing else; its parent must be there. Temporary folders of
/// a writer that was cut off an hour ago are removed. The error, one line, says what is in the way. `tag` makes the
/// temporary name unlike those of other writers.
[[nodiscard]] std::expected<Written, std::string> write_folder(const std::string& folder, const Manifest& manifest,
                                                               std::string_view content, std::uint64_t tag);

/// A number that no other writer has, from the kernel's source of chance.
[[nodiscard]] std::uint64_t random_tag();

/// Removes all versions in a folder but the newest ones; each is a folder named by its number. Each is taken away as a
/// whole, so that no reader finds half of one.
void keep_newest_versions(const std::string& folder, std::size_t kept, std::uint64_t tag);

/// Whether a folder holds these files and nothing else. A folder that is not there does not.
[[nodiscard]] bool holds(const std::string& folder, const Manifest& manifest, std::string_view content);

}  // namespace geminga::ontology

#endif
