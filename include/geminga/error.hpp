// Errors between Geminga and the programs that use it, with the codes of GCNP.
#ifndef GEMINGA_ERROR_HPP
#define GEMINGA_ERROR_HPP

#include <cstdint>
#include <string>

namespace geminga {

/// The three-digit error codes of GCNP (paper section 3.4). Numbers are only ever appended.
enum class ErrorCode : std::uint16_t {
  malformed = 400,        ///< cannot be read
  unknown_request = 404,  ///< no such request
  already_exists = 409,   ///< the identifier is in use
  too_large = 413,        ///< a named limit on size is exceeded
  impossible = 422,       ///< understood, but impossible: an unknown concept, an unsatisfiable class
  too_many = 429,         ///< a named limit on number or rate is exceeded
  not_ready = 503,        ///< not now: starting or stopping
};

/// One error: a code that a program can act on and a text that says what is wrong and what to do about it.
/// The text is one line of UTF-8 without control characters.
struct Error {
  ErrorCode code = ErrorCode::malformed;
  std::string text;

  friend bool operator==(const Error&, const Error&) = default;
};

}  // namespace geminga

#endif
