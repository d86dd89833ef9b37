#include "app/image/deflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include <libdeflate.h>

#include "atlas/base/error.h"

namespace burl {
namespace {

constexpr std::size_t most_code_bits = 15;
constexpr std::size_t end_of_block = 256, first_length = 257;

Error no_stream() {
    return Error(ExitCode::runtime, "the compressed data could not be joined: it is damaged");
}

/// Reads bits from the lowest of each byte on.
class Bits {
  public:
    explicit Bits(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    std::size_t at() const { return at_; }
    /// At least the next 32 bits; zeros follow the last byte.
    std::uint64_t peek() const {
        const std::size_t byte = at_ / 8;
        std::uint64_t word = 0;
        if (byte + sizeof word <= bytes_.size() && std::endian::native == std::endian::little)
            std::memcpy(&word, &bytes_[byte], sizeof word);
        else
            for (std::size_t k = 0; k < sizeof word && byte + k < bytes_.size(); ++k)
                word |= std::uint64_t(bytes_[byte + k]) << (8 * k);
        return word >> (at_ % 8);
    }
    void skip(std::size_t count) {
        at_ += count;
        if (at_ > 8 * bytes_.size()) throw no_stream();
    }
    std::size_t take(std::size_t count) {
        const auto value = std::size_t(peek() & ((std::uint64_t(1) << count) - 1));
        skip(count);
        return value;
    }

  private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

/// A prefix code's symbols by the next most_code_bits bits.
class PrefixCode {
  public:
    struct Entry {
        std::uint16_t symbol = 0, bits = 0;  // bits 0: no code begins so
    };

    /// The code whose symbol i has `lengths[i]` bits, 0 for none (RFC 1951, 3.2.2).
    explicit PrefixCode(std::span<const std::uint8_t> lengths) {
        const std::uint8_t longest = std::ranges::max(lengths);
        if (longest > most_code_bits) throw no_stream();
        width_ = longest;
        entries_.resize(std::size_t(1) << width_);
        std::size_t code = 0;
        for (std::size_t bits = 1; bits <= width_; ++bits, code <<= 1)
            for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol)
                if (lengths[symbol] == bits) set(code++, bits, symbol);
    }

    Entry at(const Bits& bits) const {
        const Entry entry = entries_[bits.peek() & (entries_.size() - 1)];
        if (entry.bits == 0) throw no_stream();
        return entry;
    }

  private:
    /// Sets all entries whose lowest bits are the code's, of which the first comes first.
    void set(std::size_t code, std::size_t bits, std::size_t symbol) {
        std::size_t reversed = 0;
        for (std::size_t k = 0; k < bits; ++k) reversed |= (code >> k & 1) << (bits - 1 - k);
        for (std::size_t i = reversed; i < entries_.size(); i += std::size_t(1) << bits)
            entries_[i] = {std::uint16_t(symbol), std::uint16_t(bits)};
    }

    std::size_t width_ = 0;
    std::vector<Entry> entries_;
};

/// The number of further bits of a match's length, by its symbol from first_length on, and of its
/// distance, by its symbol (RFC 1951, 3.2.5).
std::size_t length_bits(std::size_t index) {
    return index < 8 || index == 28 ? 0 : index / 4 - 1;
}
std::size_t distance_bits(std::size_t symbol) {
    return symbol < 4 ? 0 : symbol / 2 - 1;
}

void skip_codes(Bits& bits, const PrefixCode& literals, const PrefixCode& distances) {
    while (true) {
        const PrefixCode::Entry entry = literals.at(bits);
        bits.skip(entry.bits);
        if (entry.symbol == end_of_block) return;
        if (entry.symbol < first_length) continue;
        bits.skip(length_bits(entry.symbol - first_length));
        const PrefixCode::Entry distance = distances.at(bits);
        bits.skip(distance.bits + distance_bits(distance.symbol));
    }
}

void skip_stored(Bits& bits) {
    bits.skip(-bits.at() % 8);
    const std::size_t length = bits.take(16);
    bits.skip(16 + 8 * length);
}

void skip_fixed(Bits& bits) {
    std::array<std::uint8_t, 288> literals{};
    std::fill_n(literals.begin(), 144, std::uint8_t(8));
    std::fill_n(literals.begin() + 144, 112, std::uint8_t(9));
    std::fill_n(literals.begin() + 256, 24, std::uint8_t(7));
    std::fill_n(literals.begin() + 280, 8, std::uint8_t(8));
    std::array<std::uint8_t, 32> distances{};
    distances.fill(5);
    skip_codes(bits, PrefixCode(literals), PrefixCode(distances));
}

/// The lengths of `count` codes, which are coded themselves (RFC 1951, 3.2.7).
std::vector<std::uint8_t> code_lengths(Bits& bits, const PrefixCode& code, std::size_t count) {
    std::vector<std::uint8_t> lengths;
    while (lengths.size() < count) {
        const PrefixCode::Entry entry = code.at(bits);
        bits.skip(entry.bits);
        if (entry.symbol < 16) {
            lengths.push_back(std::uint8_t(entry.symbol));
        } else if (entry.symbol == 16) {
            if (lengths.empty()) throw no_stream();
            lengths.insert(lengths.end(), 3 + bits.take(2), std::uint8_t(lengths.back()));
        } else {
            const bool many = entry.symbol == 18;
            lengths.resize(lengths.size() + (many ? 11 + bits.take(7) : 3 + bits.take(3)));
        }
    }
    if (lengths.size() > count) throw no_stream();
    return lengths;
}

void skip_dynamic(Bits& bits) {
    constexpr std::array<std::uint8_t, 19> order{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                 11, 4,  12, 3, 13, 2, 14, 1, 15};
    const std::size_t literals = 257 + bits.take(5), distances = 1 + bits.take(5);
    const std::size_t count = 4 + bits.take(4);
    std::array<std::uint8_t, 19> of_lengths{};
    for (std::size_t i = 0; i < count; ++i) of_lengths[order[i]] = std::uint8_t(bits.take(3));
    const std::vector<std::uint8_t> lengths =
        code_lengths(bits, PrefixCode(of_lengths), literals + distances);
    skip_codes(bits, PrefixCode(std::span(lengths).first(literals)),
               PrefixCode(std::span(lengths).last(distances)));
}

}  // namespace

LastBlock last_block(std::span<const std::uint8_t> stream) {
    Bits bits(stream);
    while (true) {
        const std::size_t begin = bits.at();
        const bool is_last = bits.take(1) == 1;
        const std::size_t kind = bits.take(2);
        if (kind == 3) throw no_stream();
        if (kind == 0) skip_stored(bits);
        if (kind == 1) skip_fixed(bits);
        if (kind == 2) skip_dynamic(bits);
        if (is_last) return {begin, bits.at()};
    }
}

void Deflater::Free::operator()(libdeflate_compressor* compressor) const {
    ::libdeflate_free_compressor(compressor);
}

Deflater::Deflater(int level) : compressor_(::libdeflate_alloc_compressor(level)) {
    if (!compressor_) throw std::bad_alloc();
}

std::vector<std::uint8_t> Deflater::stream(std::span<const std::uint8_t> bytes) const {
    std::vector<std::uint8_t> out(
        ::libdeflate_deflate_compress_bound(compressor_.get(), bytes.size()));
    out.resize(::libdeflate_deflate_compress(compressor_.get(), bytes.data(), bytes.size(),
                                             out.data(), out.size()));
    if (out.empty()) throw Error(ExitCode::runtime, "the data could not be compressed");
    return out;
}

std::vector<std::uint8_t> Deflater::piece(std::span<const std::uint8_t> bytes) const {
    std::vector<std::uint8_t> out = stream(bytes);
    const auto [begin, end] = last_block(out);
    out[begin / 8] = std::uint8_t(out[begin / 8] & ~(1u << (begin % 8)));
    constexpr std::size_t header_bits = 3;  // zeros: a stored block, not the last
    out.resize((end + header_bits + 7) / 8);
    out.insert(out.end(), {0, 0, 0xff, 0xff});
    return out;
}

}  // namespace burl
