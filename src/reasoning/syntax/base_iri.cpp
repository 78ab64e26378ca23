#include "reasoning/syntax/base_iri.hpp"

#include <filesystem>
#include <string_view>

#include "base/text.hpp"
#include "reasoning/syntax/inflate.hpp"

namespace geminga::syntax {

std::string base_iri(const std::string& path) {
  std::string iri = "file:///";
  for (const char c : std::filesystem::path(name_without_gz(path)).filename().string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain =
        (byte > 0x20 && byte < 0x7f && std::string_view("<>\"{}|\\^`%#?").find(c) == std::string_view::npos);
    if (is_plain) {
      iri += c;
    } else {
      iri += '%' + base::to_hex(byte, 2);
    }
  }
  return iri;
}

}  // namespace geminga::syntax
