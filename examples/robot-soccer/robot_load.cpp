// The messages of a host of the soccer team (the paper's section 4), counted: each module is a process of its own that
// sends and receives through channels. Usage: robot_load LOAD.tsv HOST-KIND SECONDS
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>

#include "load_module.hpp"

namespace {

/// The process of one module; its counts go into the pipe.
int be(const std::vector<Row>& rows, const std::string& name, Clock::time_point begin, Clock::time_point end,
       int pipe) {
  geminga::ClientOptions options;
  options.name = name;
  auto node = geminga::Node::open(options);
  if (!node) {
    std::cerr << "robot_load: " << node.error().text << '\n';
    return 3;
  }
  const Counts counts = Module(std::move(*node), rows, name).run(begin, end);
  return ::write(pipe, &counts, sizeof counts) == sizeof counts ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc == 4 ? std::strtod(argv[3], nullptr) : 0;
  if (seconds <= 0 || seconds > 3600) {
    std::cerr << "robot_load: three arguments are needed: LOAD.tsv HOST-KIND SECONDS, up to 3600\n";
    return 2;
  }
  const auto rows = read_rows(argv[1], argv[2]);
  std::set<std::string> modules;
  for (const Row& row : rows) modules.insert(row.module);
  if (modules.empty()) {
    std::cerr << "robot_load: " << argv[1] << " has no modules for a host of kind " << argv[2] << '\n';
    return 2;
  }
  // Messages are counted only after all modules know each other.
  const auto begin = Clock::now() + std::chrono::seconds(3);
  const auto end = begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) return 1;
  for (const std::string& module : modules) {
    // The others still receive what is under way when the count ends.
    if (::fork() == 0) std::_Exit(be(rows, module, begin, end, pipe[1]));
  }
  ::close(pipe[1]);
  Counts all;
  std::size_t ended = 0;
  for (Counts one; ::read(pipe[0], &one, sizeof one) == sizeof one; ++ended) {
    all.inside += one.inside;
    all.received += one.received;
    all.sent += one.sent;
    all.missed += one.missed;
  }
  while (::wait(nullptr) > 0) {
  }
  if (ended != modules.size()) return 1;
  const auto a_second = [seconds](std::uint64_t count) { return static_cast<double>(count) / seconds; };
  std::cout << "inside " << a_second(all.inside) << " in " << a_second(all.received) << " out " << a_second(all.sent)
            << " missed " << all.missed << '\n';
  return 0;
}
