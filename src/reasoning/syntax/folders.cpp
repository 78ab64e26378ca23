#include "reasoning/syntax/folders.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/inflate.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::syntax {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 11> extensions{".ttl", ".nt",  ".trig", ".nq",  ".rdf", ".owl",
                                                      ".xml", ".owx", ".omn",  ".ofn", ".fss"};
/// How much of a file is looked at whose name ends in .xml, because many programs use this ending.
constexpr std::size_t begin_bytes = std::size_t{1} << 16;

LoadError unreadable(const std::string& file, std::string text) {
  return {base::printable(file, 4096), 0, std::move(text), true};
}

bool has_ending(std::string_view given, std::span<const std::string_view> endings) {
  const std::string name = base::in_lower_case(name_without_gz(given));
  return std::ranges::any_of(endings, [&](std::string_view ending) { return name.ends_with(ending); });
}

bool is_wanted_name(std::string_view given, std::span<const std::string_view> also) {
  if (base::in_lower_case(given).starts_with("catalog-v")) return false;
  return has_ending(given, extensions) || has_ending(given, also);
}

/// Whether a file that is only XML by its name says early that it is about RDF or OWL.
bool is_ontology_xml(const fs::path& path) {
  std::string begin(begin_bytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  return begin.empty() || !is_foreign_xml(begin);
}

/// One folder that was named, with all below it.
class Walk {
 public:
  Walk(std::string folder, const FileLimits& limits, std::span<const std::string_view> also, Listing& listing,
       std::vector<LoadError>* left_out)
      : folder_(std::move(folder)), limits_(limits), also_(also), listing_(listing), left_out_(left_out) {}

  std::optional<LoadError> run() {
    std::error_code error;
    inside_ = fs::canonical(folder_, error);
    if (error) return unreadable(folder_, "cannot be resolved: " + error.message());
    const std::size_t before = listing_.files.size();
    if (auto failed = enter(folder_, 0)) return failed;
    if (listing_.files.size() == before)
      return unreadable(
          folder_,
          "holds no ontology file: put files named .ttl, .nt, .trig, .nq, .rdf, .owl, .owx, .omn or .ofn there");
    std::ranges::sort(listing_.files.begin() + static_cast<std::ptrdiff_t>(before), listing_.files.end());
    return std::nullopt;
  }

 private:
  /// Calls itself once for each level, of which there are few.
  std::optional<LoadError> enter(const fs::path& folder, std::size_t level) {
    if (level > limits_.folder_levels)
      return unreadable(folder.string(), "is more than " + std::to_string(limits_.folder_levels) +
                                             " folders deep: name the folders of the ontologies");
    listing_.folders.push_back(folder.string());
    std::error_code error;
    std::vector<fs::path> names;
    fs::directory_iterator entries(folder, error);
    for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
      if (++entries_ > limits_.folder_entries)
        return unreadable(folder_, "holds more than " + std::to_string(limits_.folder_entries) +
                                       " files: name the folders of the ontologies");
      if (!entries->path().filename().string().starts_with('.')) names.push_back(entries->path());
    }
    if (error) return refuse(unreadable(folder.string(), "cannot be listed: " + error.message()), level > 0);
    std::ranges::sort(names);
    for (const fs::path& path : names) {
      if (auto failed = take(path, level)) return failed;
    }
    return std::nullopt;
  }

  std::optional<LoadError> take(const fs::path& path, std::size_t level) {
    std::error_code error;
    const bool is_link = fs::is_symlink(path, error);
    if (fs::is_directory(path, error)) {
      // A link may lead in circles. What is inside the folder is found without it.
      if (!is_link) return enter(path, level + 1);
      listing_.skipped.push_back(path.string());
      return std::nullopt;
    }
    const std::string name = path.filename().string();
    if (!is_wanted_name(name, also_)) {
      if (!name.starts_with("catalog-v")) listing_.skipped.push_back(path.string());
      return std::nullopt;
    }
    const fs::path target = fs::canonical(path, error);
    if (error) return refuse(unreadable(path.string(), "cannot be resolved: " + error.message()));
    const auto [end, rest] = std::mismatch(inside_.begin(), inside_.end(), target.begin(), target.end());
    if (end != inside_.end())
      return refuse(unreadable(path.string(), "is a link that leads out of its folder: name the file itself"));
    const bool is_foreign =
        base::in_lower_case(name).ends_with(".xml") && fs::is_regular_file(target, error) && !is_ontology_xml(target);
    (is_foreign ? listing_.skipped : listing_.files).push_back(path.string());
    return std::nullopt;
  }

  /// Leaves out what was refused, where that is wanted and possible; else the error ends the walk.
  std::optional<LoadError> refuse(LoadError error, bool can_be_left_out = true) {
    if (left_out_ == nullptr || !can_be_left_out || left_out_->size() >= max_left_out) return error;
    left_out_->push_back(std::move(error));
    return std::nullopt;
  }

  const std::string folder_;
  const FileLimits& limits_;
  std::span<const std::string_view> also_;
  Listing& listing_;
  std::vector<LoadError>* left_out_;  ///< null: nothing is left out
  fs::path inside_;
  std::size_t entries_ = 0;
};

}  // namespace

bool is_ontology_name(std::string_view text) { return has_ending(text, extensions) && !text.contains("://"); }

std::expected<Listing, LoadError> list_files(std::span<const std::string> arguments, const FileLimits& limits,
                                             std::span<const std::string_view> also, std::vector<LoadError>* left_out) {
  Listing listing;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (!fs::is_directory(argument, error)) {
      listing.files.push_back(argument);
    } else if (auto failed = Walk(argument, limits, also, listing, left_out).run()) {
      return std::unexpected(std::move(*failed));
    }
  }
  std::set<std::pair<dev_t, ino_t>> seen;
  std::erase_if(listing.files, [&](const std::string& path) {
    struct stat status{};
    return stat(path.c_str(), &status) == 0 && !seen.emplace(status.st_dev, status.st_ino).second;
  });
  if (listing.files.size() > limits.files)
    return std::unexpected(
        unreadable("", "more than " + std::to_string(limits.files) + " ontology files are named: merge some"));
  return listing;
}

}  // namespace geminga::syntax
