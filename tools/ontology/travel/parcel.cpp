#include "ontology/travel/parcel.hpp"

#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "base/text.hpp"
#include "ontology/travel/digest.hpp"

namespace geminga::ontology {
namespace {

namespace fs = std::filesystem;

/// A piece with its number, most significant octet first, before its compressed octets.
std::string message_of_piece(std::size_t number, std::string_view octets) {
  std::string message(piece_mark);
  for (int shift = 24; shift >= 0; shift -= 8) message.push_back(static_cast<char>((number >> shift) & 0xffU));
  uLongf packed = ::compressBound(octets.size());
  const std::size_t begin = message.size();
  message.resize(begin + packed);
  ::compress2(reinterpret_cast<Bytef*>(message.data() + begin), &packed, reinterpret_cast<const Bytef*>(octets.data()),
              octets.size(), Z_BEST_COMPRESSION);
  message.resize(begin + packed);
  return message;
}

/// The content of a regular file; nothing where it cannot be read or has more octets than `most`.
std::expected<std::string, std::string> content_of(const std::string& path, std::size_t most) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::unexpected(path + ": is no file that can be read");
  std::ifstream file(path, std::ios::binary);
  std::string content;
  std::string chunk(piece_octets, '\0');
  while (file.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || file.gcount() > 0) {
    content.append(chunk, 0, static_cast<std::size_t>(file.gcount()));
    if (content.size() > most)
      return std::unexpected("the files have more than " + std::to_string(max_travelling_octets >> 20U) +
                             " MiB together: pack them by gzip, or serve fewer");
  }
  if (!file.eof()) return std::unexpected(path + ": cannot be read");
  return content;
}

}  // namespace

std::expected<Parcel, std::string> Parcel::pack(const std::map<std::string, std::string>& files,
                                                std::uint64_t version) {
  Parcel parcel;
  parcel.manifest_.version = version;
  std::string content;
  for (const auto& [name, octets] : files) {
    if (const auto fault = fault_of_name(name))
      return std::unexpected(base::printable(name) + ' ' + *fault + ": give the file another name");
    parcel.manifest_.files.push_back({name, octets.size()});
    content += octets;
  }
  for (std::size_t begin = 0; begin < content.size(); begin += piece_octets) {
    const auto piece = std::string_view(content).substr(begin, piece_octets);
    parcel.pieces_.push_back(message_of_piece(parcel.pieces_.size(), piece));
    parcel.manifest_.pieces.push_back(blake2b(piece));
  }
  const std::string text = parcel.manifest_.text();
  if (const auto read = Manifest::read(text); !read)
    return std::unexpected("the ontology cannot travel, since " + read.error());
  parcel.digest_ = blake2b(text);
  parcel.manifest_message_ = std::string(manifest_mark) + text;
  return parcel;
}

std::expected<std::map<std::string, std::string>, std::string> read_files(std::span<const std::string> paths) {
  std::map<std::string, std::string> files;
  std::set<std::string> read;
  std::size_t octets = 0;
  for (const std::string& path : paths) {
    if (!read.insert(path).second) continue;
    auto content = content_of(path, max_travelling_octets - octets);
    if (!content) return std::unexpected(content.error());
    octets += content->size();
    const std::string name = fs::path(path).filename().string();
    if (!files.emplace(name, std::move(*content)).second)
      return std::unexpected("two files have the name " + base::printable(name) + ": give one another name");
  }
  return files;
}

}  // namespace geminga::ontology
