// The language stands behind the last @.
#include "reasoning/owl/plain_literal.hpp"

#include "base/text.hpp"

namespace geminga::owl {

PlainLiteral split_plain_literal(std::string_view lexical) {
  const std::size_t at = lexical.rfind('@');
  if (at == std::string_view::npos) return {lexical, {}};
  return {lexical.substr(0, at), base::in_lower_case(lexical.substr(at + 1))};
}

}  // namespace geminga::owl
