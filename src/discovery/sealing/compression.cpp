#include "discovery/sealing/compression.hpp"

#include <zstd.h>

#include <algorithm>
#include <array>

#include "base/assert.hpp"
#include "discovery/sealing/dictionary.hpp"
#include "discovery/sealing/limits.hpp"

namespace geminga::sealing {
namespace {

/// Higher levels take longer and gain some octets in a hundred.
constexpr int level = 6;
/// The beginning of each zstd frame (RFC 8878, section 3.1.1); it is not sent.
constexpr std::array<std::byte, 4> frame_magic{std::byte{0x28}, std::byte{0xb5}, std::byte{0x2f}, std::byte{0xfd}};

}  // namespace

class Compression::Contexts {
 public:
  Contexts()
      : writer(ZSTD_createCCtx(), &ZSTD_freeCCtx),
        reader(ZSTD_createDCtx(), &ZSTD_freeDCtx),
        to_write(ZSTD_createCDict(dictionary().data(), dictionary().size(), level), &ZSTD_freeCDict),
        to_read(ZSTD_createDDict(dictionary().data(), dictionary().size()), &ZSTD_freeDDict) {
    GEMINGA_ASSERT(writer && reader && to_write && to_read);
    // The frame says neither its length nor dictionary nor checksum: the envelope knows all of that.
    for (const auto flag : {ZSTD_c_contentSizeFlag, ZSTD_c_checksumFlag, ZSTD_c_dictIDFlag}) {
      GEMINGA_ASSERT(ZSTD_isError(ZSTD_CCtx_setParameter(writer.get(), flag, 0)) == 0);
    }
    GEMINGA_ASSERT(ZSTD_isError(ZSTD_CCtx_refCDict(writer.get(), to_write.get())) == 0);
  }

  std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> writer;
  std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> reader;
  std::unique_ptr<ZSTD_CDict, std::size_t (*)(ZSTD_CDict*)> to_write;
  std::unique_ptr<ZSTD_DDict, std::size_t (*)(ZSTD_DDict*)> to_read;
  std::array<std::byte, frame_magic.size() + env::max_datagram_bytes> frame{};
};

Compression::Compression() : contexts_(std::make_unique<Contexts>()) {}
Compression::~Compression() = default;

std::size_t Compression::compress(std::span<const std::byte> text, std::span<std::byte> octets) {
  if (text.size() < min_compressed_bytes) return 0;
  const std::size_t most = std::min(contexts_->frame.size(), frame_magic.size() + text.size() - min_saved_bytes);
  const std::size_t size =
      ZSTD_compress2(contexts_->writer.get(), contexts_->frame.data(), most, text.data(), text.size());
  if (ZSTD_isError(size) != 0) return 0;  // it would have been larger
  GEMINGA_ASSERT(std::equal(frame_magic.begin(), frame_magic.end(), contexts_->frame.begin()));
  std::copy_n(contexts_->frame.data() + frame_magic.size(), size - frame_magic.size(), octets.data());
  return size - frame_magic.size();
}

std::expected<std::size_t, Rejection> Compression::expand(std::span<const std::byte> octets,
                                                          std::span<std::byte> text) {
  if (octets.empty() || octets.size() > env::max_datagram_bytes) return std::unexpected(Rejection::malformed);
  std::ranges::copy(frame_magic, contexts_->frame.begin());
  std::copy_n(octets.data(), octets.size(), contexts_->frame.data() + frame_magic.size());
  const std::size_t size =
      ZSTD_decompress_usingDDict(contexts_->reader.get(), text.data(), text.size(), contexts_->frame.data(),
                                 frame_magic.size() + octets.size(), contexts_->to_read.get());
  if (ZSTD_isError(size) != 0) return std::unexpected(Rejection::malformed);
  return size;
}

}  // namespace geminga::sealing
