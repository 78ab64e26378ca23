// geminga-bridge-dds: the readers and writers of a DDS domain, a robot with ROS 2 among them, for the team.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdlib>
#include <set>
#include <string>

#include "base/text.hpp"
#include "bridge/cyclone/domain.hpp"
#include "bridge/loop/loop.hpp"
#include "bridge/ros/endpoint.hpp"
#include "bridge/team/team.hpp"
#include "shell/report.hpp"
#include "shell/whole_lines.hpp"

namespace geminga::bridge {
namespace {

constexpr std::string_view program = "geminga-bridge-dds";
/// The time between two looks at what Cyclone has discovered. Shorter: the team is told earlier. Longer: less work.
constexpr std::chrono::milliseconds look{100};

constexpr const char* examples = R"(Examples:
  geminga-bridge-dds --domain 0
  geminga-bridge dds
  geminga-query services topic
  geminga-query requests --unmatched
  geminga-subscribe geminga:RangeScan --mode otm/stream

Writers of a domain become publications and readers become subscriptions, with mode otm/stream and protocol dds. Servers and
clients of services of ROS 2 become publications and subscriptions with mode oto. Each is of the concept whose class has
geminga:messageType of its type in the team's ontology (ontology/ros.ttl), else of the text, e.g. my_msgs/msg/Thing. Topic, type,
domain and policies are attributes. The policies of a reader are its condition: geminga-query why says which one does not fit. No
message passes through the bridge, and the bridge tells DDS nothing about the team. One bridge in a domain is enough.

Exit status: 0 ended by a signal, 2 wrong usage, or the domain cannot be joined.)";

struct Flags {
  shell::CommonOptions common;
  std::string domain;
  bool has_plumbing = false;

  void add_to(CLI::App& app) {
    common.add_without_json_to(app, "How long to wait for the daemon's hello (default: 5)");
    app.add_option("--domain", domain, "The domain (default: $ROS_DOMAIN_ID, else 0)")
        ->type_name("0.." + std::to_string(max_domain));
    app.add_flag("--plumbing", has_plumbing, "Also show what every ROS 2 node has: parameters, logs, its discovery");
  }
  /// The number of the domain. The error says what is wrong.
  [[nodiscard]] std::expected<std::uint32_t, std::string> number() const {
    const char* variable = std::getenv("ROS_DOMAIN_ID");
    const bool is_told = !domain.empty();
    const std::string text = is_told ? domain : variable != nullptr && *variable != '\0' ? variable : "0";
    const auto number = base::parse_number<std::uint32_t>(text);
    if (number && *number <= max_domain) return *number;
    return std::unexpected((is_told ? "--domain" : "ROS_DOMAIN_ID") + (": " + base::printable(text)) +
                           " is no domain: write a number from 0 to " + std::to_string(max_domain));
  }
};

int fail(const std::string& text) {
  shell::complain(program, text);
  return static_cast<int>(shell::ExitStatus::wrong_use);
}

int run(int argc, char** argv) {
  CLI::App app("Shows the readers and writers of a DDS domain to the team.", std::string(program));
  app.footer(examples);
  Flags flags;
  flags.add_to(app);
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);
  const auto number = flags.number();
  if (!number) return fail(number.error());
  Loop loop(program, flags.common);
  if (!loop.is_ready()) return static_cast<int>(shell::ExitStatus::wrong_use);
  Team& team = loop.team();
  const auto on_found = [&team, &flags, number = *number](const std::string& key, const Endpoint& endpoint) {
    auto foreign = foreign_of(endpoint, number, flags.has_plumbing);
    if (foreign) return team.foreign().put(key, std::move(*foreign));
    if (!foreign.error().empty()) team.tally().count(foreign.error());
  };
  auto domain =
      Domain::join(*number, team.tally(),
                   {.found = on_found, .gone = [&team](const std::string& key) { team.foreign().drop(key); }});
  if (!domain) return fail(domain.error());
  client::Reactor::Timer timer(loop.reactor(), [&] {
    (*domain)->look();
    timer.set(loop.reactor().now() + look);
  });
  timer.set(loop.reactor().now());
  shell::complain(program, "looking at domain " + std::to_string(*number));
  return loop.run();
}

}  // namespace
}  // namespace geminga::bridge

int main(int argc, char** argv) {
  const geminga::shell::WholeLines lines;
  return geminga::bridge::run(argc, argv);
}
