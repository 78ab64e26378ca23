// A recording as an MCAP file, for Foxglove and other tools that show what robots record.
#ifndef GEMINGA_RECORDING_MCAP_EXPORT_HPP
#define GEMINGA_RECORDING_MCAP_EXPORT_HPP

#include <cstdint>
#include <expected>
#include <ostream>

#include "recording/reader.hpp"

namespace geminga::recording::mcap {

/// Writes each entry as one message, the line of the recording in JSON, to the channel of its kind (RECORDING.md,
/// "MCAP"). Returns the number of messages. The error is one of the reader; what was read until then is in the file,
/// which is whole all the same.
[[nodiscard]] std::expected<std::uint64_t, Finding> export_recording(Reader& reader, std::ostream& out);

}  // namespace geminga::recording::mcap

#endif
