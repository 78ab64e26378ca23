#include "client/channels/process_mark.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>

namespace geminga::client {
namespace {

/// The system gives whole pages.
constexpr std::size_t page_bytes = 4096;

}  // namespace

ProcessMark::ProcessMark() : number_(::getpid()) {
  void* const page = ::mmap(nullptr, page_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) return;
  if (::madvise(page, page_bytes, MADV_WIPEONFORK) != 0) {
    ::munmap(page, page_bytes);
    return;
  }
  page_ = static_cast<volatile unsigned char*>(page);
  *page_ = 1;
}

ProcessMark::~ProcessMark() {
  if (page_ != nullptr) ::munmap(const_cast<unsigned char*>(page_), page_bytes);
}

bool ProcessMark::is_same_number() const { return ::getpid() == number_; }

}  // namespace geminga::client
