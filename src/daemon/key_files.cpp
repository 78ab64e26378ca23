#include "daemon/key_files.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/text.hpp"
#include "discovery/sealing/key_file.hpp"
#include "env/asio/descriptor.hpp"

namespace geminga::daemon {
namespace {

std::string last_error() { return std::generic_category().message(errno); }

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

std::expected<sealing::Key, std::string> read_key_file(const std::string& path) {
  const std::string name = base::printable(path, 4096);
  // Without O_NONBLOCK, open() of a FIFO would wait for a writer.
  const env::Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.get() < 0) return std::unexpected(name + ": " + last_error() + ": name a key file");
  struct stat status{};
  if (::fstat(file.get(), &status) != 0) return std::unexpected(name + ": " + last_error());
  if (!S_ISREG(status.st_mode)) return std::unexpected(name + ": is not a regular file: name a key file");
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    return std::unexpected(name + ": its group or others may read or change it, so the key is no secret: chmod 600 " +
                           name);
  }
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
  const std::string id = to_string(sealing::Key(secret).id());
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
