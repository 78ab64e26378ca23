// The messages of a host of the soccer team (the paper's section 4), counted: each module is a process of its own that
// sends and receives through channels. Usage: robot_load LOAD.tsv HOST-KIND SECONDS
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "geminga/node.hpp"

namespace {

using Clock = std::chrono::steady_clock;

/// One row of load.tsv.
struct Row {
  std::string kind, module, direction, concept_name, mode, scope;
  double hz = 0;
  std::size_t octets = 0;
  [[nodiscard]] bool is_inside() const { return scope == "host"; }
};

std::vector<Row> read_rows(const std::string& file, const std::string& kind) {
  std::vector<Row> rows;
  std::ifstream table(file);
  for (std::string line; std::getline(table, line);) {
    Row row;
    std::istringstream fields(line);
    fields >> row.kind >> row.module >> row.direction >> row.concept_name >> row.mode >> row.scope >> row.hz >>
        row.octets;
    if (fields && row.kind == kind) rows.push_back(std::move(row));
  }
  return rows;
}

/// Messages of one module, or of a host.
struct Counts {
  std::uint64_t inside = 0;    ///< received from the same host
  std::uint64_t received = 0;  ///< from other hosts
  std::uint64_t sent = 0;      ///< of services that are for other hosts
  std::uint64_t missed = 0;
};

/// What is sent again and again.
struct Sender {
  geminga::Publisher publisher;
  Clock::duration period;
  std::string payload;
  bool is_for_others;
  Clock::time_point due;
};

struct Receiver {
  geminga::Subscriber subscriber;
  bool is_inside;
};

class Module {
 public:
  Module(geminga::Node node, const std::vector<Row>& rows, const std::string& name) : node_(std::move(node)) {
    for (const Row& row : rows) {
      if (row.module == name) state(row);
    }
  }

  /// Sends and receives until `end`, and counts what happens from `begin` on.
  Counts run(Clock::time_point begin, Clock::time_point end) {
    Counts counts;
    for (;;) {
      const auto now = Clock::now();
      if (now >= end) return counts;
      const bool counts_now = now >= begin;
      auto next = end;
      for (Sender& sender : senders_) {
        if (sender.due <= now) {
          const bool was_sent = sender.publisher.send(sender.payload).has_value();
          sender.due += sender.period;
          if (was_sent && counts_now && sender.is_for_others) ++counts.sent;
        }
        next = std::min(next, sender.due);
      }
      node_.wait(
          std::max(std::chrono::milliseconds(1), std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now())));
      for (Receiver& receiver : receivers_) {
        while (const auto message = receiver.subscriber.poll()) {
          if (!counts_now) continue;
          ++(receiver.is_inside ? counts.inside : counts.received);
          counts.missed += message->missed;
        }
      }
    }
  }

 private:
  void state(const Row& row) {
    const auto mode = geminga::channel_mode(row.mode).value_or(geminga::ChannelMode::one_to_many_stream);
    if (row.direction == "pub") {
      geminga::NamedPublication offer;
      offer.identity = geminga::ConceptNames{row.concept_name, ""};
      offer.mode = mode;
      offer.scope = row.scope == "others" ? "any,!host" : "host";
      offer.attributes["load"] = "1";  // the modules of the demo offer the same, and send nothing
      const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / row.hz));
      if (auto publisher = node_.publish(offer)) {
        senders_.push_back({std::move(*publisher), period, std::string(row.octets, 'x'), row.scope == "others",
                            Clock::now() + period});
      } else {
        complain(row, publisher.error().text);
      }
      return;
    }
    geminga::NamedSubscription wish;
    wish.identity = geminga::ConceptNames{row.concept_name, ""};
    wish.mode = mode;
    wish.weakest = geminga::Degree::exact;
    wish.where = "load = 1";
    wish.scope = row.scope == "others" ? "any,!host" : "host";
    if (auto subscriber = node_.subscribe(wish)) {
      receivers_.push_back({std::move(*subscriber), row.is_inside()});
    } else {
      complain(row, subscriber.error().text);
    }
  }
  static void complain(const Row& row, const std::string& text) {
    std::cerr << "robot_load: " << row.module << ": " << row.concept_name << ": " << text << '\n';
    std::exit(2);
  }

  geminga::Node node_;
  std::vector<Sender> senders_;
  std::vector<Receiver> receivers_;
};

/// The life of one module's process: what it counts goes into the pipe.
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
  // What is sent before everybody knows everybody is not counted.
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
