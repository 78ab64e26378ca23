// src/env/cage writes the filter; this reads it as seccomp(2) says.
#include "env/cage/filter_program.hpp"

#include <linux/audit.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>

namespace geminga::cage {
namespace {

/// The call as the kernel shows it to a filter.
seccomp_data seen(const AskedCall& call) {
  seccomp_data data{};
  data.nr = call.number;
  data.arch = call.processor == Processor::aarch64 ? AUDIT_ARCH_AARCH64 : AUDIT_ARCH_X86_64;
  for (std::size_t place = 0; place < call.arguments.size(); ++place) data.args[place] = call.arguments[place];
  return data;
}

std::optional<Verdict> meaning(std::uint32_t answer) {
  switch (answer) {
    case SECCOMP_RET_ALLOW:
      return Verdict::allowed;
    case SECCOMP_RET_ERRNO | EACCES:
      return Verdict::forbidden;
    case SECCOMP_RET_ERRNO | ENOSYS:
      return Verdict::unknown_to_kernel;
    case SECCOMP_RET_KILL_PROCESS:
    case SECCOMP_RET_KILL_THREAD:
      return Verdict::ended;
    default:
      return std::nullopt;
  }
}

/// The jump that follows from a comparison; nothing for one that there is not.
std::optional<std::uint8_t> jump(const sock_filter& instruction, std::uint32_t accumulator) {
  const std::uint32_t operand = instruction.k;
  bool holds = false;
  switch (BPF_OP(instruction.code)) {
    case BPF_JEQ:
      holds = accumulator == operand;
      break;
    case BPF_JGT:
      holds = accumulator > operand;
      break;
    case BPF_JGE:
      holds = accumulator >= operand;
      break;
    case BPF_JSET:
      holds = (accumulator & operand) != 0;
      break;
    default:
      return std::nullopt;
  }
  return holds ? instruction.jt : instruction.jf;
}

}  // namespace

FilterProgram::FilterProgram(const Freedom& freedom, Processor processor) {
  const int file = ::memfd_create("filter", MFD_CLOEXEC);
  if (file < 0) return;
  if (write_filter(freedom, processor, file)) {
    const auto octets = static_cast<std::size_t>(::lseek(file, 0, SEEK_END));
    instructions_.resize(octets / sizeof(sock_filter));
    if (::pread(file, instructions_.data(), octets, 0) != static_cast<ssize_t>(octets)) instructions_.clear();
  }
  ::close(file);
}

std::optional<Verdict> FilterProgram::ask(const AskedCall& call) const {
  const seccomp_data data = seen(call);
  std::uint32_t accumulator = 0;
  for (std::size_t at = 0; at < instructions_.size(); ++at) {
    const sock_filter& instruction = instructions_[at];
    if (instruction.code == (BPF_LD | BPF_W | BPF_ABS)) {
      if (instruction.k % 4 != 0 || instruction.k + 4 > sizeof data) return std::nullopt;
      std::memcpy(&accumulator, reinterpret_cast<const char*>(&data) + instruction.k, 4);
    } else if (instruction.code == (BPF_ALU | BPF_AND | BPF_K)) {
      accumulator &= instruction.k;
    } else if (instruction.code == (BPF_JMP | BPF_JA)) {
      at += instruction.k;
    } else if (BPF_CLASS(instruction.code) == BPF_JMP && BPF_SRC(instruction.code) == BPF_K) {
      const auto distance = jump(instruction, accumulator);
      if (!distance) return std::nullopt;
      at += *distance;
    } else if (instruction.code == (BPF_RET | BPF_K)) {
      return meaning(instruction.k);
    } else {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace geminga::cage
