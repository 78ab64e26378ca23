// Datagrams as a capture file, a folder for it, and a team key in a file.
#ifndef GEMINGA_TESTS_TOOLS_WIRESHARK_CAPTURE_HPP
#define GEMINGA_TESTS_TOOLS_WIRESHARK_CAPTURE_HPP

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/sealing/key.hpp"

namespace geminga::tools {

using Datagram = std::vector<std::byte>;

/// Writes the datagrams as a capture of IPv4 from 10.0.0.2 to the team's group and port, in the classic format of pcap.
void write_capture(const std::filesystem::path& file, const std::vector<Datagram>& datagrams);

/// `64 67 ...` without spaces.
[[nodiscard]] std::string hexadecimal(std::span<const std::byte> octets);

/// A folder with two key files; the keys are in `keys`.
class WithKeys : public testing::Test {
 protected:
  WithKeys();
  ~WithKeys() override;

  std::filesystem::path folder_;
  std::filesystem::path key_file_;
  std::filesystem::path other_file_;
  std::vector<sealing::Key> keys_;  ///< that of key_file_, and that of other_file_
};

/// A datagram sealed with this key.
[[nodiscard]] Datagram sealed(const sealing::Key& key, std::span<const std::byte> announcement, std::string_view mode,
                              std::uint32_t counter);

}  // namespace geminga::tools

#endif
