// Two pieces of work at the same time.
#ifndef GEMINGA_BASE_PARALLEL_BOTH_HPP
#define GEMINGA_BASE_PARALLEL_BOTH_HPP

#include <functional>

namespace geminga::parallel {

/// Does both, and returns when both are done. Where two threads or more may be used and the system gives one, `second`
/// is done there, so that neither may write what the other one looks at. Otherwise `first` is done first. If one
/// throws, the other one goes on to its end, and the exception is thrown again.
void do_both(unsigned threads, const std::function<void()>& first, const std::function<void()>& second);

}  // namespace geminga::parallel

#endif
