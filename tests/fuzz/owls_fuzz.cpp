// Any octets as an OWL-S description: read within small limits, mended or not, or refused in one line of valid text.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "reasoning/syntax/owls/profile.hpp"

namespace {

void expect_one_line(const geminga::syntax::LoadError& error) {
  const std::string text = to_string(error);
  GEMINGA_ASSERT(!error.text.empty());
  GEMINGA_ASSERT(geminga::base::is_valid_utf8(text) && !geminga::base::has_control_character(text));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  geminga::syntax::FileLimits limits;
  limits.triples = 2'000;
  limits.literal_bytes = 300;
  limits.iri_bytes = 200;
  limits.nesting = 20;
  limits.prefixes = 20;
  limits.attributes = 20;
  limits.tag_bytes = 2'000;
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("geminga-fuzz-" + std::to_string(::getpid()))).string() + ".owls";
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(reinterpret_cast<const char*>(octets), static_cast<std::streamsize>(size));
  const auto document = geminga::owls::read_profiles(path, limits);
  std::filesystem::remove(path);
  if (!document) {
    expect_one_line(document.error());
    return 0;
  }
  if (document->broken_off) expect_one_line(*document->broken_off);
  GEMINGA_ASSERT(document->profiles.size() <= geminga::owls::max_profiles);
  for (const geminga::owls::Profile& profile : document->profiles) {
    GEMINGA_ASSERT(profile.inputs.size() <= geminga::owls::max_parameters);
    GEMINGA_ASSERT(profile.outputs.size() <= geminga::owls::max_parameters);
    for (const auto* side : {&profile.inputs, &profile.outputs}) {
      for (const std::string& type : *side) GEMINGA_ASSERT(geminga::base::is_valid_utf8(type));
    }
  }
  return 0;
}
