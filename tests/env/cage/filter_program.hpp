// A seccomp filter as the kernel sees it: a program of classic BPF, evaluated for system calls of any processor.
#ifndef GEMINGA_TESTS_ENV_CAGE_FILTER_PROGRAM_HPP
#define GEMINGA_TESTS_ENV_CAGE_FILTER_PROGRAM_HPP

#include <linux/filter.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "env/cage/system_calls.hpp"

namespace geminga::cage {

/// A system call as a filter is asked about it.
struct AskedCall {
  Processor processor = Processor::x86_64;
  int number = 0;
  std::array<std::uint64_t, 6> arguments{};
};

/// The answers of a filter.
enum class Verdict { allowed, forbidden, unknown_to_kernel, ended };  // EACCES, ENOSYS, the process is ended

class FilterProgram {
 public:
  /// The filter of src/env/cage for this freedom on such a processor; without an instruction where there is none.
  FilterProgram(const Freedom& freedom, Processor processor);

  /// The number of its instructions. The kernel takes 4096 (BPF_MAXINSNS).
  [[nodiscard]] std::size_t size() const { return instructions_.size(); }
  /// The answer to a call; nothing where an instruction is none of those that seccomp(2) allows, leads out of the
  /// program or returns another answer. An instruction can only jump forwards, so that every call is answered.
  [[nodiscard]] std::optional<Verdict> ask(const AskedCall& call) const;

 private:
  std::vector<sock_filter> instructions_;
};

}  // namespace geminga::cage

#endif
