#include "support/lab_team.hpp"

#include <algorithm>
#include <csignal>

namespace geminga::system {

void LabTeam::start_together() {
  for (std::size_t host = 0; host < size(); ++host) lab_.begin(host, flags_of_(host));
  for (std::size_t host = 0; host < size(); ++host) {
    lab_.wait_until_ready(host);
    connect(host);
  }
}

void LabTeam::start(std::size_t host) {
  lab_.start(host, flags_of_(host));
  connect(host);
}

bool LabTeam::end(std::size_t host, int signal) {
  // The connections end with the daemon. If they were closed before, it would still tell that the services are
  // withdrawn.
  lab_.daemon(host).signal(signal);
  const auto status = lab_.daemon(host).wait();
  Robot& robot = robots_.at(host);
  robot.module.reset();
  robot.observer.reset();
  robot.publications = 0;
  return status == (signal == SIGKILL ? 128 + SIGKILL : 0);
}

void LabTeam::connect(std::size_t host) {
  Robot& robot = robots_.at(host);
  robot.module.emplace(lab_.talk(host));
  robot.observer.emplace(lab_.talk(host));
  for (std::uint32_t number = 0; number < publications_each; ++number) {
    publish(host, 10 + number, "service" + std::to_string(number));
  }
  for (std::size_t number = 0; number < subscriptions_each; ++number) {
    const std::string text = std::to_string(number);
    robot.module->say(std::to_string(30 + number) + " sub create mode=otm/stream reach=any text=service" + text);
  }
  robot.module->say("40 sub create mode=otm/stream reach=any text=news");
}

void LabTeam::publish(std::size_t host, std::uint32_t id, const std::string& text) {
  const std::string number = std::to_string(id);
  module(host).say(number + " pub create mode=otm/stream text=" + text + " port=" + std::to_string(5000 + id));
  ++robots_.at(host).publications;
}

void LabTeam::withdraw(std::size_t host, std::uint32_t id) {
  module(host).say(std::to_string(id) + " pub remove");
  --robots_.at(host).publications;
}

bool LabTeam::wait_until_right() {
  std::size_t participants = 0;
  std::size_t publications = 0;
  for (const Robot& robot : robots_) {
    participants += robot.module ? 1 : 0;
    publications += robot.publications;
  }
  const auto is_right = [&](const std::vector<std::string>& lines) {
    return lines.size() == 1 && field(lines[0], "participants") == std::to_string(participants) &&
           field(lines[0], "publications") == std::to_string(publications);
  };
  // A robot that is right stays right, since nothing changes meanwhile. So each is waited for in turn.
  return std::ranges::all_of(
      robots_, [&](Robot& robot) { return !robot.observer || robot.observer->wait_until("status", is_right); });
}

std::string LabTeam::knowledge(std::size_t host) {
  std::string text;
  for (const char* query : {"status", "participants"}) {
    for (const std::string& line : robots_.at(host).observer->query(query)) text += line + '\n';
  }
  return text;
}

LabTeam::Sent LabTeam::sent() {
  Sent all;
  for (Robot& robot : robots_) {
    if (!robot.observer) continue;
    const auto status = robot.observer->query("status");
    all.datagrams += std::stod(field(status.at(0), "datagrams_sent"));
    all.octets += std::stod(field(status.at(0), "bytes_sent"));
  }
  return all;
}

std::size_t LabTeam::departures() {
  std::size_t count = 0;
  for (Robot& robot : robots_) {
    if (!robot.module) continue;
    count += static_cast<std::size_t>(std::ranges::count_if(robot.module->lines_until_pong(), [](const auto& line) {
      return line.find(" del ") != std::string::npos && line.find("reason=expired") != std::string::npos;
    }));
  }
  return count;
}

}  // namespace geminga::system
