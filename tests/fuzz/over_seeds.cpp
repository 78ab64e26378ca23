// Runs a fuzz target without libFuzzer: over each seed file, all its truncations, and bent copies by seed.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <vector>

#include "base/random.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size);

namespace {

constexpr int copies_per_seed = 2000;

std::vector<std::uint8_t> read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Changes, inserts or removes a few octets.
std::vector<std::uint8_t> bend(std::vector<std::uint8_t> octets, geminga::base::Random& random) {
  for (auto edits = 1 + random.below(6); edits > 0 && !octets.empty(); --edits) {
    const auto place = static_cast<std::ptrdiff_t>(random.below(octets.size()));
    switch (random.below(3)) {
      case 0:
        octets[static_cast<std::size_t>(place)] = static_cast<std::uint8_t>(random.next());
        break;
      case 1:
        octets.insert(octets.begin() + place, static_cast<std::uint8_t>(random.next()));
        break;
      default:
        octets.erase(octets.begin() + place);
    }
  }
  return octets;
}

void run(const std::vector<std::uint8_t>& octets) {
  // A copy of exactly that size, so that the sanitizers see a read behind it.
  const std::vector<std::uint8_t> exact(octets.begin(), octets.end());
  LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || !std::filesystem::is_directory(argv[1])) {
    std::cerr << "usage: " << argv[0] << " FOLDER-OF-SEEDS\n";
    return 2;
  }
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.insert(entry.path());
  if (files.empty()) {
    std::cerr << argv[1] << ": there are no seeds\n";
    return 1;
  }
  for (const auto& file : files) {
    const auto seed = read(file);
    for (std::size_t size = 0; size <= seed.size(); ++size) {
      run({seed.begin(), seed.begin() + static_cast<std::ptrdiff_t>(size)});
    }
    geminga::base::Random random(seed.size());
    for (int i = 0; i < copies_per_seed; ++i) run(bend(seed, random));
  }
  std::cout << files.size() << " seeds\n";
  return 0;
}
