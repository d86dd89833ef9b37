// Pieces of a stream, which zlib inflates as one.
#include "app/image/deflate.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "atlas/base/error.h"

namespace burl {
namespace {

using DeflateBytes = std::vector<std::uint8_t>;

/// Bytes of which libdeflate makes blocks of every kind: noise, what repeats, both by turns.
DeflateBytes mixed_bytes(std::size_t count, std::uint32_t seed) {
    DeflateBytes bytes(count);
    std::uint32_t state = seed;
    for (std::size_t i = 0; i < count; ++i) {
        state = state * 1664525u + 1013904223u;
        const bool is_noise = (i / 30000 + seed) % 3 == 0;
        bytes[i] = std::uint8_t(is_noise ? state >> 24 : (i / 7 % 5) * (state >> 30));
    }
    return bytes;
}

/// The bytes of a raw stream, by zlib; empty where it is damaged, unfinished or has more behind it.
DeflateBytes inflated(DeflateBytes stream, std::size_t size) {
    DeflateBytes out(size + 1);
    z_stream z{};
    inflateInit2(&z, -15);
    z.next_in = stream.data(), z.avail_in = uInt(stream.size());
    z.next_out = out.data(), z.avail_out = uInt(out.size());
    const int result = inflate(&z, Z_FINISH);
    out.resize(result == Z_STREAM_END && z.avail_in == 0 ? z.total_out : 0);
    inflateEnd(&z);
    return out;
}

TEST(Deflate, PiecesAreOneStream) {
    for (int level = 0; level <= 12; ++level) {
        const Deflater deflater(level);
        DeflateBytes all, stream;
        for (const std::size_t size : {1, 3, 70000, 0, 250000, 40, 399999}) {
            const DeflateBytes bytes = mixed_bytes(size, std::uint32_t(size));
            all.insert(all.end(), bytes.begin(), bytes.end());
            const bool is_last = size == 399999;
            const DeflateBytes part = is_last ? deflater.stream(bytes) : deflater.piece(bytes);
            stream.insert(stream.end(), part.begin(), part.end());
        }
        EXPECT_EQ(inflated(stream, all.size()), all) << level;
    }
}

TEST(Deflate, PiecesOfEveryLengthEndOnAByte) {
    const Deflater deflater(6);
    for (std::size_t size = 0; size < 300; ++size) {
        const DeflateBytes first = mixed_bytes(size, 1), second = mixed_bytes(size, 2);
        DeflateBytes all = first, stream = deflater.piece(first);
        all.insert(all.end(), second.begin(), second.end());
        const DeflateBytes end = deflater.stream(second);
        stream.insert(stream.end(), end.begin(), end.end());
        ASSERT_EQ(inflated(stream, all.size()), all) << size;
    }
}

TEST(Deflate, TheLastBlockEndsWithTheStream) {
    for (const int level : {0, 1, 6, 9}) {
        const DeflateBytes stream = Deflater(level).stream(mixed_bytes(500000, 5));
        const LastBlock last = last_block(stream);
        EXPECT_EQ((last.end + 7) / 8, stream.size()) << level;
        EXPECT_GT(last.begin, 0u) << level;
    }
}

TEST(Deflate, WhatIsCutOffIsNoStream) {
    const DeflateBytes stream = Deflater(6).stream(mixed_bytes(20000, 3));
    for (std::size_t size = 0; size < stream.size(); size += 7)
        EXPECT_THROW(last_block(std::span(stream).first(size)), Error) << size;
}

TEST(Deflate, DamageLeadsNowhereElse) {
    const DeflateBytes stream = Deflater(6).stream(mixed_bytes(20000, 3));
    std::size_t refused = 0;
    for (std::size_t i = 0; i < 8 * stream.size(); ++i) {
        DeflateBytes damaged = stream;
        damaged[i / 8] ^= std::uint8_t(1u << i % 8);
        try {
            EXPECT_LE(last_block(damaged).end, 8 * damaged.size());
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::runtime);
            ++refused;
        }
    }
    EXPECT_GT(refused, 0u);
}

}  // namespace
}  // namespace burl
