#include "reasoning/owl/blank_prefix.hpp"

#include "base/hash.hpp"
#include "base/text.hpp"

namespace geminga::owl {

std::string blank_prefix_of(std::string_view octets) { return blank_prefix_of(base::hash64(octets)); }

std::string blank_prefix_of(std::uint64_t hash) { return "_:" + base::to_hex(hash, 16) + '.'; }

}  // namespace geminga::owl
