// Limits of the questions that wait for a daemon, and of its answers.
#ifndef GEMINGA_WEB_ASKING_LIMITS_HPP
#define GEMINGA_WEB_ASKING_LIMITS_HPP

#include <chrono>
#include <cstddef>

namespace geminga::web {

/// Different questions that wait for their answers; one more is refused with 429.
inline constexpr std::size_t max_open_questions = 64;
/// Octets of one answer: keys and values, and what each line and parameter costs beside them. A daemon that says more
/// is left.
inline constexpr std::size_t max_answer_octets = std::size_t{32} * 1024 * 1024;
inline constexpr std::size_t line_cost = 64;
inline constexpr std::size_t parameter_cost = 64;

/// The time for which an answer is given again to the same question. Shorter: fresher answers, more work for the
/// daemon. Longer: the reverse. It is that of two looks of --watch, so that nobody sees less than geminga-query shows.
inline constexpr std::chrono::milliseconds answer_life{200};
/// Answers that are kept for that, and their octets; the eldest gives way.
inline constexpr std::size_t max_recent_answers = 32;
inline constexpr std::size_t max_recent_octets = std::size_t{32} * 1024 * 1024;

}  // namespace geminga::web

#endif
