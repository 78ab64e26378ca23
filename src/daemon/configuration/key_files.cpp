#include "daemon/configuration/key_files.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include "base/text.hpp"
#include "discovery/sealing/key_file.hpp"
#include "env/asio/descriptor.hpp"

namespace geminga::daemon {
namespace {

namespace fs = std::filesystem;

std::string last_error() { return std::generic_category().message(errno); }

/// This process's user, as chown(1) takes it.
std::string user() { return std::to_string(::geteuid()); }

/// A text that the destructor wipes. It never grows, so that no copy is left behind.
class SecretText {
 public:
  explicit SecretText(std::string text) : text_(std::move(text)) {}
  ~SecretText() { ::explicit_bzero(text_.data(), text_.size()); }
  SecretText(const SecretText&) = delete;
  SecretText& operator=(const SecretText&) = delete;
  [[nodiscard]] std::string& text() { return text_; }

 private:
  std::string text_;
};

/// The path of an open file after all symbolic links; empty where the system does not tell.
fs::path real_path(const env::Descriptor& file) {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/fd/" + std::to_string(file.get()), ignored);
}

/// Whether the file lies in $CREDENTIALS_DIRECTORY. systemd keeps others out of it, and gives files that belong to root
/// to the service's user by an access list, which looks like a right of their group.
bool is_credential(const fs::path& real) {
  const char* folder = std::getenv("CREDENTIALS_DIRECTORY");
  if (folder == nullptr || *folder == '\0') return false;
  std::error_code error;
  const fs::path credentials = fs::canonical(folder, error);
  return !error && real.parent_path() == credentials;
}

bool is_ours_or_roots(const struct stat& status) { return status.st_uid == ::geteuid() || status.st_uid == 0; }

/// The harm that others can do to the files in a folder, with the remedy; nothing where they can do none. In a folder
/// with the sticky bit, such as /tmp, they can neither rename nor remove what is not theirs.
std::optional<std::string> fault_of_folder(const fs::path& folder) {
  const std::string name = base::printable(folder.string(), 4096);
  struct stat status{};
  if (::stat(folder.c_str(), &status) != 0) return name + ": " + last_error();
  if (!is_ours_or_roots(status)) {
    return "its folder " + name + " belongs to another user, who may put another key there: chown " + user() + ' ' +
           name;
  }
  if ((status.st_mode & (S_IWGRP | S_IWOTH)) == 0 || (status.st_mode & S_ISVTX) != 0) return std::nullopt;
  return "others may write into its folder " + name + " and put another key there: chmod go-w " + name;
}

/// The reason why the key in this file is no secret, or not the owner's, with the remedy.
std::optional<std::string> fault_of(const struct stat& status, const fs::path& path, const fs::path& real) {
  if (!S_ISREG(status.st_mode)) return "is not a regular file: name a key file";
  const std::string name = base::printable(path.string(), 4096);
  const ::mode_t open = status.st_mode & (is_credential(real) ? S_IWGRP | S_IRWXO : S_IRWXG | S_IRWXO);
  if (open != 0) return "its group or others may read or change it, so the key is no secret: chmod 600 " + name;
  if (is_credential(real)) return std::nullopt;
  if (!is_ours_or_roots(status)) return "belongs to another user, who knows the key: chown " + user() + ' ' + name;
  for (const fs::path& file : {path, real}) {
    if (file.empty()) continue;
    const fs::path folder = file.parent_path();
    if (auto fault = fault_of_folder(folder.empty() ? "." : folder)) return fault;
  }
  return std::nullopt;
}

std::expected<sealing::Key, std::string> read_key_file(const std::string& path) {
  const std::string name = base::printable(path, 4096);
  // Without O_NONBLOCK, open() of a FIFO would wait for a writer.
  const env::Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.get() < 0) return std::unexpected(name + ": " + last_error() + ": name a key file");
  struct stat status{};
  if (::fstat(file.get(), &status) != 0) return std::unexpected(name + ": " + last_error());
  if (const auto fault = fault_of(status, path, real_path(file))) return std::unexpected(name + ": " + *fault);
  // Of a longer file one octet more than a key file may have is read, so that it is refused.
  SecretText secret(std::string(sealing::max_key_file_bytes + 1, '\0'));
  if (!env::read_all(file.get(), secret.text())) return std::unexpected(name + ": " + last_error());
  auto key = sealing::read_key(secret.text());
  if (!key) return std::unexpected(name + ':' + std::to_string(key.error().line) + ": " + key.error().text);
  return *key;
}

}  // namespace

std::expected<sealing::Keyring, std::vector<std::string>> read_keys(const std::vector<std::string>& paths) {
  sealing::Keyring ring;
  std::vector<std::string> errors;
  for (const std::string& path : paths) {
    const auto key = read_key_file(path);
    if (!key) {
      errors.push_back(key.error());
      continue;
    }
    switch (ring.add(*key)) {
      case sealing::Keyring::Added::yes:
        break;
      case sealing::Keyring::Added::full:
        errors.push_back(base::printable(path, 4096) + ": one key more than the " + std::to_string(sealing::max_keys) +
                         " that there may be: remove old ones");
        break;
      case sealing::Keyring::Added::id_taken:
        errors.push_back(base::printable(path, 4096) + ": a second key " + to_string(key->id()) +
                         ": name each key once; if they differ, make another one");
        break;
    }
  }
  if (!errors.empty()) return std::unexpected(std::move(errors));
  return ring;
}

std::expected<std::string, std::string> generate_key(const std::string& path) {
  const std::string name = base::printable(path, 4096);
  sealing::Key::Secret secret{};
  // getrandom(2) waits until the pool is ready, and gives so few octets whole.
  while (::getrandom(secret.data(), secret.size(), 0) != static_cast<ssize_t>(secret.size())) {
    if (errno != EINTR) return std::unexpected(name + ": no random bits: " + last_error());
  }
  SecretText text(sealing::write_key(secret));
  std::string id = to_string(sealing::Key(secret).id());
  ::explicit_bzero(secret.data(), secret.size());
  const env::Descriptor file(
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, S_IRUSR | S_IWUSR));
  if (file.get() < 0) {
    return std::unexpected(errno == EEXIST ? name + ": is there already, and a key is never overwritten: name another"
                                           : name + ": " + last_error());
  }
  if (!env::write_all(file.get(), text.text())) {
    const std::string why = last_error();
    ::unlink(path.c_str());
    return std::unexpected(name + ": " + why);
  }
  return id;
}

}  // namespace geminga::daemon
