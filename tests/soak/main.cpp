// Kills daemons of a team at random for an hour: nothing may be lost, left over, or grow.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "soak/soak.hpp"

int main(int argc, char** argv) {
  using namespace geminga;
  soak::Plan plan;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string_view option = argv[i];
    const auto number = std::strtoul(argv[i + 1], nullptr, 10);
    if (option == "--hosts") plan.hosts = number;
    if (option == "--minutes") plan.time = std::chrono::minutes(number);
    if (option == "--rounds") plan.rounds = number;
    if (option == "--loss") plan.loss = static_cast<double>(number) / 100;
    if (option == "--seed") plan.seed = number;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  try {
    soak::Soak(plan).run();
  } catch (const std::exception& failure) {
    std::printf("failed, with --seed %lu: %s\n", static_cast<unsigned long>(plan.seed), failure.what());
    return 1;
  }
  std::printf("nothing lost, nothing left over, nothing grown\n");
}
