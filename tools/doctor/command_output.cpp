#include "doctor/command_output.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>

namespace geminga::doctor {

std::optional<std::string> output_of(const std::string& command) {
  const std::string line = "PATH=$PATH:/usr/sbin:/sbin timeout 5 " + command + " 2>/dev/null";
  std::FILE* const output = ::popen(line.c_str(), "re");
  if (output == nullptr) return std::nullopt;
  std::string text;
  std::array<char, 8192> chunk{};
  for (std::size_t size = 0; text.size() <= max_output_bytes;) {
    size = std::fread(chunk.data(), 1, chunk.size(), output);
    if (size == 0) break;
    text.append(chunk.data(), size);
  }
  const int status = ::pclose(output);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || text.size() > max_output_bytes) return std::nullopt;
  return text;
}

}  // namespace geminga::doctor
