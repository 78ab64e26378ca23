#include "daemon/log/journal_writer.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <cstdint>
#include <utility>

#include "daemon/supervisor/notice_socket.hpp"

namespace geminga::daemon {
namespace {

/// The priorities of syslog(3).
char priority_of(base::LogLevel level) {
  switch (level) {
    case base::LogLevel::debug:
      return '7';
    case base::LogLevel::info:
      return '6';
    case base::LogLevel::warning:
      return '4';
    case base::LogLevel::error:
      return '3';
  }
  return '3';
}

/// Appends a field with its length before its octets, so that a value can hold any octet.
void append(std::string& entry, std::string_view name, std::string_view value) {
  if (value.empty()) return;
  entry.append(name).push_back('\n');
  std::uint64_t size = value.size();
  for (int octet = 0; octet < 8; ++octet, size >>= 8U) entry.push_back(static_cast<char>(size & 0xffU));
  entry.append(value).push_back('\n');
}

/// Takes a decimal number and the character behind it from the text.
template <typename Number>
bool take(std::string_view& text, char end, Number& number) {
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  if (end == '\0') return text.empty();
  if (!text.starts_with(end)) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

bool is_journal_stream(int descriptor, std::string_view variable) {
  dev_t device = 0;
  ino_t inode = 0;
  if (!take(variable, ':', device) || !take(variable, '\0', inode)) return false;
  struct stat status{};
  return ::fstat(descriptor, &status) == 0 && status.st_dev == device && status.st_ino == inode;
}

std::optional<JournalWriter> JournalWriter::open(const std::string& path) {
  const int descriptor = connect_for_notices(path);
  if (descriptor < 0) return std::nullopt;
  return JournalWriter(descriptor);
}

JournalWriter::~JournalWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

JournalWriter::JournalWriter(JournalWriter&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

JournalWriter& JournalWriter::operator=(JournalWriter&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

bool JournalWriter::write(base::LogLevel level, std::string_view text, const base::LogFields& fields) const {
  std::string entry = "SYSLOG_IDENTIFIER=gemingad\nPRIORITY=";
  entry.append(1, priority_of(level)).push_back('\n');
  append(entry, "MESSAGE", text);
  append(entry, "GEMINGA_PARTICIPANT", fields.participant);
  append(entry, "GEMINGA_PEER", fields.peer);
  append(entry, "GEMINGA_CODE", fields.code);
  return send_notice(descriptor_, entry);
}

}  // namespace geminga::daemon
