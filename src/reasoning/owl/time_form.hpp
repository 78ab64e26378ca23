// The lexical form of xsd:dateTime (XSD 1.1 part 2, section 3.3.7).
#ifndef GEMINGA_REASONING_OWL_TIME_FORM_HPP
#define GEMINGA_REASONING_OWL_TIME_FORM_HPP

#include <optional>
#include <string>
#include <string_view>

namespace geminga::owl {

/// The form with Z for a zero offset and without zeros that say nothing; nothing where it is no time that there is, as
/// 2000-02-30T00:00:00. `is_exact` is false where another form is the same time: 24:00:00 is the next day's 00:00:00.
[[nodiscard]] std::optional<std::string> canonical_time(std::string_view text, bool& is_exact);

}  // namespace geminga::owl

#endif
