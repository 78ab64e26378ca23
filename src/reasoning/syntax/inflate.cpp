#include "reasoning/syntax/inflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <optional>

#include "base/text.hpp"
#include "reasoning/syntax/long_text_watch.hpp"

namespace geminga::syntax {
namespace {

constexpr std::string_view suffix = ".gz";
constexpr std::string_view magic = "\x1f\x8b\x08";
constexpr std::size_t step_bytes = std::size_t{1} << 20;  ///< given to zlib, and looked at, at a time
/// How many times its packed size a text usually has.
constexpr std::size_t usual_growth = 8;

/// zlib's stream, which ends with its reader.
class Inflating {
 public:
  Inflating(const std::string& path, FileBytes& packed, const FileLimits& limits)
      : path_(path),
        packed_(packed),
        most_(std::min(limits.file_bytes,
                       std::max(limits.inflated_free_bytes, packed.view().size() * limits.inflated_growth))),
        watch_(path, packed.view().size() * usual_growth, limits) {}
  Inflating(const Inflating&) = delete;
  Inflating& operator=(const Inflating&) = delete;
  ~Inflating() { inflateEnd(&stream_); }

  std::expected<FileBytes, LoadError> run() {
    constexpr int gzip_only = 15 + 16;  // the largest window; the header of gzip and its checksum
    if (inflateInit2(&stream_, gzip_only) != Z_OK) return std::unexpected(refuse("memory is short"));
    FileBytes bytes;
    while (!is_done_) {
      if (auto error = step(bytes)) return std::unexpected(std::move(*error));
    }
    bytes.give_back_room();
    return bytes;
  }

 private:
  LoadError refuse(const std::string& what) const {
    return {base::printable(path_, 4096), 0, "cannot be unpacked: " + what + at(), true};
  }
  std::string at() const { return ", at octet " + std::to_string(place_) + " of the packed file"; }

  /// Some octets in, some octets out.
  std::optional<LoadError> step(FileBytes& bytes) {
    const std::string_view view = packed_.view();
    const std::size_t offered = std::min(view.size() - place_, step_bytes);
    char* room = bytes.room_for(step_bytes);
    if (room == nullptr) return refuse("memory is short");
    // zlib does not declare its input as constant, but does not change it.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(view.data() + place_));
    stream_.avail_in = static_cast<uInt>(offered);
    stream_.next_out = reinterpret_cast<Bytef*>(room);
    stream_.avail_out = static_cast<uInt>(step_bytes);
    const int result = ::inflate(&stream_, Z_NO_FLUSH);
    place_ += offered - stream_.avail_in;
    const std::size_t count = step_bytes - stream_.avail_out;
    const std::string_view stretch = bytes.take_room(count);
    released_ = packed_.release(released_, place_);
    if (bytes.view().size() > most_)
      return LoadError{base::printable(path_, 4096), 0,
                       "unpacks to more than " + std::to_string(most_) + " bytes, the most for its size" + at(), true};
    if (result == Z_STREAM_END) return end_of_member(stretch);
    if (result == Z_BUF_ERROR || (result == Z_OK && offered == 0 && count == 0)) return refuse("it ends too early");
    if (result != Z_OK) return refuse(stream_.msg == nullptr ? "it is damaged" : base::printable(stream_.msg));
    return watch_.look_at(stretch);
  }

  /// A gzip file may be several that follow each other (RFC 1952, section 2.2).
  std::optional<LoadError> end_of_member(std::string_view stretch) {
    const std::string_view rest = packed_.view().substr(place_);
    is_done_ = rest.empty();
    if (!is_done_ && !is_gzip(rest)) return refuse("something else follows what gzip wrote");
    if (!is_done_ && inflateReset(&stream_) != Z_OK) return refuse("memory is short");
    return watch_.look_at(stretch);
  }

  const std::string& path_;
  FileBytes& packed_;
  const std::size_t most_;
  LongTextWatch watch_;
  z_stream stream_{};
  std::size_t place_ = 0;     ///< in the packed file
  std::size_t released_ = 0;  ///< of the packed file
  bool is_done_ = false;
};

}  // namespace

bool is_gzip(std::string_view content) { return content.starts_with(magic); }

std::string_view name_without_gz(std::string_view path) {
  if (path.ends_with(suffix) && path.size() > suffix.size()) path.remove_suffix(suffix.size());
  return path;
}

std::expected<FileBytes, LoadError> inflate(const std::string& path, FileBytes& packed, const FileLimits& limits) {
  return Inflating(path, packed, limits).run();
}

}  // namespace geminga::syntax
