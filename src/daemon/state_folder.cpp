#include "daemon/state_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/text.hpp"
#include "env/asio/descriptor.hpp"

namespace geminga::daemon {
namespace {

constexpr std::string_view file_comment =
    "# Who this daemon is to its team, in all its lives. Not to be copied to another host: without this file it draws\n"
    "# another one.\n";
constexpr std::string_view file_keyword = "identity ";
constexpr int identity_digits = 8;

std::string errno_words() { return std::generic_category().message(errno); }

/// Reads a text of lines that begin with `#` and one line `identity XXXXXXXX`; nothing where it is another.
std::optional<std::uint32_t> identity_in(std::string_view text) {
  if (text.size() > max_identity_file_bytes) return std::nullopt;
  std::optional<std::uint32_t> identity;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty() || line.starts_with('#')) continue;
    if (identity || !line.starts_with(file_keyword) ||
        line.size() != file_keyword.size() + std::size_t{identity_digits})
      return std::nullopt;
    std::uint32_t number = 0;
    const auto read = std::from_chars(line.data() + file_keyword.size(), line.data() + line.size(), number, 16);
    if (read.ec != std::errc() || read.ptr != line.data() + line.size() || number == 0) return std::nullopt;
    identity = number;
  }
  return identity;
}

bool is_blank(std::string_view text) {
  return text.size() <= max_identity_file_bytes && std::ranges::all_of(text, [](char octet) { return octet == 0; });
}

/// Writes a draft beside the file and renames it, so that the file is never half written. False with errno, and without
/// a draft.
bool write_whole(const std::string& path, std::string_view text) {
  const std::string draft = path + ".new";
  {
    const env::Descriptor file(::open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644));
    if (file.get() < 0) return false;
    if (env::write_all(file.get(), text) && ::rename(draft.c_str(), path.c_str()) == 0) return true;
  }
  const int error = errno;
  ::unlink(draft.c_str());
  errno = error;
  return false;
}

/// Draws an identity and writes it.
std::expected<LastingIdentity, std::string> draw(const std::string& path, const std::string& shown,
                                                 const std::function<std::uint64_t()>& random_bits) {
  LastingIdentity identity;
  while (identity.number == 0) identity.number = static_cast<std::uint32_t>(random_bits());
  const std::string digits = base::to_hex(identity.number, identity_digits);
  if (!write_whole(path, std::string(file_comment) + std::string(file_keyword) + digits + '\n'))
    return std::unexpected(shown + ": " + errno_words());
  return identity;
}

}  // namespace

std::expected<LastingIdentity, std::string> lasting_identity(const std::string& folder,
                                                             const std::function<std::uint64_t()>& random_bits) {
  const std::string path = folder + '/' + identity_file;
  const std::string shown = base::printable(path, 4096);
  // Without O_NONBLOCK, open() of a FIFO would wait for a writer.
  const env::Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.get() >= 0) {
    std::string text(max_identity_file_bytes + 1, '\0');
    if (!env::read_all(file.get(), text)) return std::unexpected(shown + ": " + errno_words());
    if (const auto identity = identity_in(text)) return LastingIdentity{*identity, ""};
    if (is_blank(text)) {
      auto identity = draw(path, shown, random_bits);
      if (identity) identity->remark = shown + ": was empty: another identity is drawn";
      return identity;
    }
    return std::unexpected(shown + ": is no identity: remove it, and another one is drawn");
  }
  if (errno != ENOENT) return std::unexpected(shown + ": " + errno_words());
  if (::mkdir(folder.c_str(), 0755) != 0 && errno != EEXIST) return std::unexpected(shown + ": " + errno_words());
  return draw(path, shown, random_bits);
}

}  // namespace geminga::daemon
