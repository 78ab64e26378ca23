// geminga-unseal: opens sealed datagrams with the keys of a team, for who looks at a recording of the air. It judges no
// freshness: a recording is always old.
#include <CLI/CLI.hpp>
#include <array>
#include <boost/json/object.hpp>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/sealing/compression.hpp"
#include "discovery/sealing/envelope.hpp"
#include "discovery/sealing/greeting.hpp"
#include "discovery/sealing/key_file.hpp"
#include "discovery/sealing/seal.hpp"
#include "manual/describe.hpp"
#include "shell/json.hpp"
#include "shell/options.hpp"
#include "shell/report.hpp"

namespace geminga::wireshark {
namespace {

constexpr std::string_view program = "geminga-unseal";

constexpr const char* about = R"(Opens sealed datagrams with the keys of a team, for a look at a recording of the air.
Datagrams are hexadecimal words, as tshark prints them: on the command line, or one a line on standard input.)";

constexpr const char* notes = R"(Examples:
  geminga-unseal --key-file old.key --key-file new.key 47116208112233445566778800000003...
  tshark -r field-test.pcapng -T fields -e udp.payload udp.port==4717 | geminga-unseal --key-file team.key

Each datagram is answered by one line: "opened encrypted KEY GREETING ANNOUNCEMENT", in hexadecimal, - for an empty part;
"opened authenticated ..." in the same way; "plain", or "rejected WORD": too-short, other-version, unknown-key, forged, malformed.
Whether it is a repetition of an older one cannot be told from a recording.

Exit status: 0 all were opened or plain, 1 one was rejected, 2 wrong usage, or a key file that cannot be read.)";

/// The largest key file (SEALING.md, "Keys").
constexpr std::size_t max_key_file_bytes = 4096;

/// The longest line: the largest datagram of UDP with a colon between its octets.
constexpr std::size_t max_line_bytes = std::size_t{3} * 65'535;

using Octets = std::vector<std::byte>;

/// The value of a hexadecimal digit.
std::optional<unsigned> digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  return std::nullopt;
}

/// The octets of a hexadecimal word, with or without colons between them.
std::optional<Octets> octets_of(std::string_view word) {
  Octets octets;
  while (!word.empty()) {
    if (word.starts_with(':') && !octets.empty()) word.remove_prefix(1);
    if (word.size() < 2) return std::nullopt;
    const auto high = digit(word[0]);
    const auto low = digit(word[1]);
    if (!high || !low) return std::nullopt;
    octets.push_back(static_cast<std::byte>(*high * 16 + *low));
    word.remove_prefix(2);
  }
  return octets;
}

std::string hexadecimal(std::span<const std::byte> octets) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string word;
  for (const std::byte octet : octets) {
    word += digits[std::to_integer<unsigned>(octet) >> 4U];
    word += digits[std::to_integer<unsigned>(octet) & 15U];
  }
  return word;
}

/// The content of an opened datagram.
struct Content {
  sealing::Header header;
  Octets greeting;
  Octets announcement;
};

/// Opens datagrams of one team.
class Opener {
 public:
  explicit Opener(const sealing::Keyring& keys) : keys_(keys) {}

  std::expected<Content, sealing::Rejection> open(std::span<const std::byte> datagram) {
    if (datagram.size() > env::max_datagram_bytes) return std::unexpected(sealing::Rejection::too_large);
    const auto header = sealing::read_header(datagram);
    if (!header) return std::unexpected(header.error());
    const sealing::Key* const key = keys_.find(header->key);
    if (key == nullptr) return std::unexpected(sealing::Rejection::unknown_key);
    const auto size = sealing::open(*key, *header, datagram, text_);
    if (!size) return std::unexpected(size.error());
    std::span<const std::byte> text = std::span(text_).first(*size);
    Content content{.header = *header, .greeting = {}, .announcement = {}};
    if (header->has_greeting) {
      const auto greeting = sealing::read_greeting(text);
      if (!greeting) return std::unexpected(greeting.error());
      content.greeting.assign(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(greeting->size));
      text = text.subspan(greeting->size);
    }
    if (header->is_compressed) {
      const auto expanded = compression_.expand(text, expanded_);
      if (!expanded) return std::unexpected(expanded.error());
      text = std::span(expanded_).first(*expanded);
    }
    content.announcement.assign(text.begin(), text.end());
    return content;
  }

 private:
  const sealing::Keyring& keys_;
  sealing::Compression compression_;
  std::array<std::byte, env::max_datagram_bytes> text_{};
  std::array<std::byte, sealing::max_text_bytes> expanded_{};
};

/// The answer to one datagram as words, or as an object.
class Printer {
 public:
  explicit Printer(bool is_json) : is_json_(is_json) {}

  void plain() const { print({{"result", "plain"}}, "plain"); }
  void rejected(sealing::Rejection why) const {
    const std::string word(to_string(why));
    print({{"result", "rejected"}, {"reason", word}}, "rejected " + word);
  }
  void opened(const Content& content) const {
    const std::string protection(to_string(content.header.protection));
    const std::string key = to_string(content.header.key);
    const std::string greeting = hexadecimal(content.greeting);
    const std::string announcement = hexadecimal(content.announcement);
    print({{"result", "opened"},
           {"protection", protection},
           {"key", key},
           {"greeting", greeting},
           {"announcement", announcement}},
          "opened " + protection + ' ' + key + ' ' + (greeting.empty() ? "-" : greeting) + ' ' +
              (announcement.empty() ? "-" : announcement));
  }

 private:
  void print(const boost::json::object& object, std::string_view words) const {
    if (is_json_) {
      shell::print(std::cout, object);
    } else {
      std::cout << words << '\n' << std::flush;
    }
  }
  bool is_json_;
};

/// Adds the key of a file. The error says what is wrong with it, and never a part of the key.
std::optional<std::string> add_key(sealing::Keyring& keys, const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(max_key_file_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (in.bad() || (text.empty() && !in.eof())) return file + ": cannot be read: name a key file of the team";
  const auto key = sealing::read_key(text);
  if (!key) return file + ':' + std::to_string(key.error().line) + ": " + key.error().text;
  switch (keys.add(*key)) {
    case sealing::Keyring::Added::full:
      return file + ": one key more than a team has: name at most " + std::to_string(sealing::max_keys);
    case sealing::Keyring::Added::id_taken:  // the same key in two files
    case sealing::Keyring::Added::yes:
      break;
  }
  return std::nullopt;
}

/// Answers one word. False: it was rejected; nothing: it is no datagram, which has been said.
std::optional<bool> answer(Opener& opener, const Printer& printer, std::string_view word) {
  while (word.ends_with('\r') || word.ends_with(' ')) word.remove_suffix(1);
  const auto datagram = octets_of(word);
  if (!datagram || datagram->empty()) {
    shell::complain(program,
                    "'" + std::string(word.substr(0, 40)) + "' is no datagram: write its octets in hexadecimal");
    return std::nullopt;
  }
  if (!sealing::is_sealed(*datagram)) {
    printer.plain();
    return true;
  }
  const auto content = opener.open(*datagram);
  if (!content) {
    printer.rejected(content.error());
    return false;
  }
  printer.opened(*content);
  return true;
}

int run(int argc, char** argv) {
  CLI::App app(about, std::string(program));
  app.footer(notes);
  std::vector<std::string> key_files;
  std::vector<std::string> words;
  bool is_json = false;
  app.add_option("DATAGRAMS", words, "Sealed datagrams in hexadecimal; none: one a line on standard input");
  app.add_option("--key-file", key_files, "A key of the team, as gemingad has it; may be given several times")
      ->required()
      ->allow_extra_args(false)
      ->type_name("FILE");
  app.add_flag("--json", is_json, "Print one JSON object a datagram");
  app.set_version_flag("--version", std::string(program) + " " GEMINGA_VERSION, "Print the version and exit");
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);

  sealing::Keyring keys;
  for (const std::string& file : key_files) {
    if (const auto fault = add_key(keys, file)) {
      shell::complain(program, *fault);
      return static_cast<int>(shell::ExitStatus::wrong_use);
    }
  }
  Opener opener(keys);
  const Printer printer(is_json);
  auto status = shell::ExitStatus::found;
  const auto take = [&](std::string_view word) {
    const auto is_opened = answer(opener, printer, word);
    if (!is_opened) {
      status = shell::ExitStatus::wrong_use;
    } else if (!*is_opened && status == shell::ExitStatus::found) {
      status = shell::ExitStatus::nothing;
    }
  };
  for (const std::string& word : words) take(word);
  if (words.empty()) {
    std::string line(max_line_bytes + 1, '\0');
    while (std::cout && std::cin.getline(line.data(), static_cast<std::streamsize>(line.size())),
           std::cin.gcount() > 0) {
      const bool is_whole = std::cin.eof() || !std::cin.fail();
      const std::string_view read(line.data(), static_cast<std::size_t>(std::cin.gcount()) - (std::cin.eof() ? 0 : 1));
      if (is_whole) {
        take(read);
        continue;
      }
      std::cin.clear();
      std::cin.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
      take("a line of more than " + std::to_string(max_line_bytes) + " octets");
    }
  }
  return static_cast<int>(shell::written(program, status));
}

}  // namespace
}  // namespace geminga::wireshark

int main(int argc, char** argv) { return geminga::wireshark::run(argc, argv); }
