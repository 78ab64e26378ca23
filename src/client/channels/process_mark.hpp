// Tells a process from those that were forked from it.
#ifndef GEMINGA_CLIENT_CHANNELS_PROCESS_MARK_HPP
#define GEMINGA_CLIENT_CHANNELS_PROCESS_MARK_HPP

#include <sys/types.h>

namespace geminga::client {

/// A page that the system clears in a forked process, so that looking costs no system call. Where the system has no
/// such page, it asks for the number of the process. Neither copies nor moves.
class ProcessMark {
 public:
  ProcessMark();
  ~ProcessMark();
  ProcessMark(const ProcessMark&) = delete;
  ProcessMark& operator=(const ProcessMark&) = delete;

  /// Whether this is the process that made the mark.
  [[nodiscard]] bool is_own() const { return page_ != nullptr ? *page_ != 0 : is_same_number(); }

 private:
  [[nodiscard]] bool is_same_number() const;

  volatile unsigned char* page_ = nullptr;
  pid_t number_;
};

}  // namespace geminga::client

#endif
