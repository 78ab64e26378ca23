// The octets that announcements have in common, for their compression. The dictionary is part of the format: another
// one takes another bit of the envelope.
#ifndef GEMINGA_DISCOVERY_SEALING_DICTIONARY_HPP
#define GEMINGA_DISCOVERY_SEALING_DICTIONARY_HPP

#include <span>

namespace geminga::sealing {

/// A zstd dictionary, made by tools/dev/train-dictionary. Static storage.
[[nodiscard]] std::span<const unsigned char> dictionary();

}  // namespace geminga::sealing

#endif
