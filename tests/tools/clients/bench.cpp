#include "tools/clients/bench.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <boost/json/parse.hpp>
#include <csignal>

namespace geminga::tools {

Bench::Bench(std::vector<std::string> flags) : lab_(1), flags_(std::move(flags)) {
  flags_.insert(flags_.end(), {"--ontology", GEMINGA_SOURCE_DIR "/ontology"});
  start_daemon();
}

void Bench::start_daemon() { lab_.start(0, flags_); }

void Bench::stop_daemon() {
  lab_.daemon(0).signal(SIGTERM);
  EXPECT_EQ(lab_.daemon(0).wait(), 0);
}

Process::Start Bench::start_of(const std::string& program, const std::vector<std::string>& words) const {
  std::vector<std::string> line{program.starts_with('/') ? program : system::program(program)};
  line.insert(line.end(), words.begin(), words.end());
  Process::Start start = lab_.on(0, std::move(line));
  start.environment = {{"GEMINGA_CONNECT", "127.0.0.1:" + std::to_string(lab_.gcnp_port(0))}};
  return start;
}

Outcome Bench::run(const std::string& program, const std::vector<std::string>& words) const {
  std::array<int, 2> errors{};
  if (::pipe2(errors.data(), O_CLOEXEC) != 0) return {};
  Process::Start start = start_of(program, words);
  start.before = [inner = start.before, end = errors[1]] {
    if (inner) inner();
    ::dup2(end, STDERR_FILENO);
  };
  // The error text of a program fits into the pipe, so it may be read after the program's end.
  const system::Ran ran = system::run(start);
  ::close(errors[1]);
  Outcome outcome{ran.status, ran.said, ""};
  std::array<char, 4096> chunk{};
  for (ssize_t size = 0; (size = ::read(errors[0], chunk.data(), chunk.size())) > 0;) {
    outcome.errors.append(chunk.data(), static_cast<std::size_t>(size));
  }
  ::close(errors[0]);
  return outcome;
}

boost::json::value Bench::json(std::vector<std::string> words) const {
  words.emplace_back("--json");
  return parsed(query(words).out);
}

std::unique_ptr<Process> Bench::start(const std::string& program, const std::vector<std::string>& words) const {
  return std::make_unique<Process>(start_of(program, words));
}

boost::json::value parsed(const std::string& text) {
  boost::system::error_code error;
  auto value = boost::json::parse(text, error);
  EXPECT_FALSE(error) << error.message() << ": " << text;
  return value;
}

std::string nobody() {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  EXPECT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), size), 0);
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  ::close(socket);
  return "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
}

}  // namespace geminga::tools
