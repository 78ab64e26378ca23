#include "ontology/travel/manifest.hpp"

#include <algorithm>
#include <limits>

#include "base/harmless.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "ontology/travel/digest.hpp"
#include "reasoning/syntax/folders.hpp"

namespace geminga::ontology {
namespace {

constexpr std::string_view first_line = "geminga-ontology 1\n";
bool has_harmful_character(std::string_view name) {
  for (std::size_t at = 0; at < name.size(); at += base::character_bytes(static_cast<unsigned char>(name[at]))) {
    if (base::is_harmful(base::character_at(name.data() + at))) return true;
  }
  return false;
}

/// Takes the next line that begins with `word` and a blank, without these; nothing where the next line is another one.
std::optional<std::string_view> take_line(std::string_view& text, std::string_view word) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos || !text.starts_with(word) || text.size() == word.size()) return std::nullopt;
  if (text[word.size()] != ' ') return std::nullopt;
  const std::string_view rest = text.substr(word.size() + 1, end - word.size() - 1);
  text.remove_prefix(end + 1);
  return rest;
}

std::optional<TravellingFile> file_of(std::string_view line) {
  const std::size_t blank = line.find(' ');
  if (blank == std::string_view::npos) return std::nullopt;
  const auto octets = base::parse_number<std::size_t>(line.substr(0, blank));
  if (!octets) return std::nullopt;
  return TravellingFile{std::string(line.substr(blank + 1)), *octets};
}

/// Why files, their order or their sizes are not believed.
std::optional<std::string> fault_of_files(const std::vector<TravellingFile>& files) {
  std::size_t octets = 0;
  for (std::size_t number = 0; number < files.size(); ++number) {
    const TravellingFile& file = files[number];
    if (const auto fault = fault_of_name(file.name)) return base::printable(file.name) + ' ' + *fault;
    if (number > 0 && files[number - 1].name >= file.name) return "its files do not stand in order";
    if (file.octets > max_travelling_octets - octets) return "it is too large";
    octets += file.octets;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> fault_of_name(std::string_view name) {
  if (name.empty()) return "is no name";
  if (name.size() > max_travelling_name) return "is too long a name";
  if (!base::is_valid_utf8(name)) return "is not UTF-8";
  if (has_harmful_character(name)) return "has a control character";
  if (name.find_first_of("/\\") != std::string_view::npos) return "is a path";
  if (name.starts_with('.')) return "is hidden";
  if (!syntax::is_ontology_name(name)) return "does not end as an ontology file does";
  return std::nullopt;
}

std::size_t Manifest::octets() const {
  std::size_t sum = 0;
  for (const TravellingFile& file : files) sum += file.octets;
  return sum;
}

std::size_t Manifest::octets_of(std::size_t piece) const {
  return std::min(piece_octets, octets() - piece * piece_octets);
}

std::string Manifest::text() const {
  std::string text(first_line);
  text += "version " + std::to_string(version) + '\n';
  for (const TravellingFile& file : files) text += "file " + std::to_string(file.octets) + ' ' + file.name + '\n';
  for (const std::string& piece : pieces) text += "piece " + piece + '\n';
  return text;
}

std::expected<Manifest, std::string> Manifest::read(std::string_view text) {
  const std::string_view whole = text;
  if (text.size() > max_manifest_octets) return std::unexpected("its manifest is too long");
  if (!text.starts_with(first_line)) return std::unexpected("it has no manifest of this kind");
  text.remove_prefix(first_line.size());
  Manifest manifest;
  const auto version = take_line(text, "version");
  const auto number = version ? base::parse_number<std::uint64_t>(*version) : std::nullopt;
  if (!number || *number > max_travelling_version) return std::unexpected("its manifest states no version");
  manifest.version = *number;
  while (const auto line = take_line(text, "file")) {
    auto file = file_of(*line);
    if (!file) return std::unexpected("its manifest has a file without a size");
    if (manifest.files.size() == max_travelling_files) return std::unexpected("it has too many files");
    manifest.files.push_back(std::move(*file));
  }
  if (manifest.files.empty()) return std::unexpected("it has no files");
  if (auto fault = fault_of_files(manifest.files)) return std::unexpected(std::move(*fault));
  while (const auto line = take_line(text, "piece")) {
    if (!is_blake2b(*line)) return std::unexpected("its manifest has a piece without a digest");
    manifest.pieces.emplace_back(*line);
  }
  if (manifest.pieces.size() != piece_count(manifest.octets()) || manifest.text() != whole)
    return std::unexpected("its manifest does not say one thing in one way");
  return manifest;
}

}  // namespace geminga::ontology
