// The lexical form of xsd:dateTime (XSD 1.1 part 2, section 3.3.7).
#ifndef GEMINGA_REASONING_OWL_TIME_FORM_HPP
#define GEMINGA_REASONING_OWL_TIME_FORM_HPP

#include <optional>
#include <string>
#include <string_view>

namespace geminga::owl {

/// The canonical form: Z for a zero offset, no superfluous zeros. Nothing for a time that does not exist, such as
/// 2000-02-30T00:00:00. 24:00:00 is 00:00:00 of the next day.
[[nodiscard]] std::optional<std::string> canonical_time(std::string_view text);

}  // namespace geminga::owl

#endif
