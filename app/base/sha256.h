#pragma once
// SHA-256 (FIPS 180-4): a digest of a file's content that anyone can check, with `sha256sum`, say.
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace burl {

class Sha256 {
  public:
    void add(std::span<const std::uint8_t> bytes);
    void add(std::string_view text);
    /// The digest of all bytes added, as 64 lower-case hexadecimal digits; nothing may be added
    /// after.
    std::string digest();

  private:
    void compress(const std::uint8_t* block);

    std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<std::uint8_t, 64> block_{};
    std::uint64_t length_ = 0;  ///< the number of bytes added
};

/// The digest of a text, as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view text);

/// The digest of a file's content, which is read in pieces. Throws Error(io) naming the path.
std::string sha256_of_file(const std::string& path);

/// A cache of digests of files, keyed by real path. A digest is that of the content at the file's
/// first use; content read later may be newer than its digest, never older.
class FileDigests {
  public:
    /// The file's digest, computed at the first call. Throws Error(io) naming the path.
    const std::string& of(const std::string& path);
    /// Stores the digest of content that the caller has read anyway; a digest already stored stays.
    void add(const std::string& path, std::span<const std::uint8_t> content);

  private:
    std::map<std::string, std::string> known_;
};

}  // namespace burl
