// The test of a connection's first octets: whether they can be GCNP, decided as early as possible.
#ifndef GEMINGA_DISCOVERY_GCNP_FIRST_WORD_HPP
#define GEMINGA_DISCOVERY_GCNP_FIRST_WORD_HPP

#include <cstdint>
#include <string_view>

namespace geminga::gcnp {

/// The first word of a connection is a number, as that of every statement. Another beginning is another protocol (HTTP,
/// TLS, STUN, ...), whatever follows. Decides at the first octet that settles it.
class FirstWord {
 public:
  enum class Verdict : std::uint8_t {
    open,     ///< only digits yet
    number,   ///< GCNP, or an attempt at it
    foreign,  ///< another protocol
  };

  /// Looks at the next octets of the stream, until it is settled.
  Verdict take(std::string_view bytes) {
    for (const char octet : bytes) {
      if (verdict_ != Verdict::open) break;
      if (octet >= '0' && octet <= '9') {
        has_digit_ = true;
      } else {
        const bool is_end = octet == ' ' || octet == '\r' || octet == '\n';
        verdict_ = has_digit_ && is_end ? Verdict::number : Verdict::foreign;
      }
    }
    return verdict_;
  }

 private:
  Verdict verdict_ = Verdict::open;
  bool has_digit_ = false;
};

}  // namespace geminga::gcnp

#endif
