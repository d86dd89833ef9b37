#include "tests/fuzz/mutate.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include <fmt/format.h>

namespace burl::fuzz {
namespace {

/// The JSON chunk of a GLB, and all behind it.
struct Container {
    std::string json, rest;
};

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

std::string number_bytes(std::size_t number) {
    const auto small = std::uint32_t(number);
    std::string bytes(sizeof small, '\0');
    std::memcpy(bytes.data(), &small, sizeof small);
    return bytes;
}

bool is_glb(const std::string& bytes) {
    return bytes.size() >= 20 && bytes.starts_with("glTF") &&
           number_at(bytes, 12) <= bytes.size() - 20;
}

std::string glb_of(Container parts) {
    parts.json.resize((parts.json.size() + 3) / 4 * 4, ' ');
    const std::size_t whole = 20 + parts.json.size() + parts.rest.size();
    return "glTF" + number_bytes(2) + number_bytes(whole) + number_bytes(parts.json.size()) +
           "JSON" + parts.json + parts.rest;
}

/// CRC-32 as PNG has it (ISO/IEC 15948, annex D), bit by bit.
std::uint32_t crc_of(std::string_view bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int k = 0; k < 8; ++k) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

std::string big_endian(std::size_t number) {
    std::string bytes = number_bytes(number);
    std::ranges::reverse(bytes);
    return bytes;
}

/// The chunks behind a PNG's signature, each its type and data.
std::vector<std::string> png_chunks(const std::string& bytes) {
    std::vector<std::string> chunks;
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        std::string length = bytes.substr(at, 4);
        std::ranges::reverse(length);
        const std::size_t count =
            std::min<std::size_t>(number_at(length, 0), bytes.size() - at - 12);
        chunks.push_back(bytes.substr(at + 4, 4 + count));
        at += 12 + count;
    }
    return chunks;
}

template <class Value>
void overwrite(std::string& bytes, Random& random, Value value) {
    if (bytes.size() < sizeof value) return;
    std::memcpy(bytes.data() + below(random, bytes.size() - sizeof value + 1), &value,
                sizeof value);
}

constexpr std::array<std::uint32_t, 14> odd_integers{
    0, 1, 2, 3, 127, 128, 255, 256, 32767, 65535, 65536, 0x7fffffff, 0x80000000, 0xffffffff};

std::array<double, 12> odd_numbers() {
    using Limits = std::numeric_limits<double>;
    return {0.0,
            -0.0,
            1.0,
            -1.0,
            1e-30,
            1e30,
            1e300,
            Limits::denorm_min(),
            Limits::max(),
            Limits::infinity(),
            Limits::quiet_NaN(),
            0.5};
}

void write_odd_number(std::string& bytes, Random& random) {
    const double number = odd_numbers()[below(random, 12)];
    if (below(random, 2) == 0)
        overwrite(bytes, random, number);
    else
        overwrite(bytes, random, float(number));
}

/// Moves a part of the bytes elsewhere, or doubles it.
void copy_part(std::string& bytes, Random& random) {
    const std::size_t begin = below(random, bytes.size());
    const std::size_t count = 1 + below(random, std::min<std::size_t>(bytes.size() - begin, 64));
    bytes.insert(below(random, bytes.size()), bytes.substr(begin, count));
}

}  // namespace

std::string mutated_bytes(std::string bytes, Random& random) {
    if (bytes.empty()) return std::string(1 + below(random, 16), char(random()));
    switch (below(random, 8)) {
        case 0:
            bytes[below(random, bytes.size())] ^= char(1u << below(random, 8));
            break;
        case 1:
            bytes[below(random, bytes.size())] = char(random());
            break;
        case 2:
            bytes.insert(below(random, bytes.size() + 1), 1, char(random()));
            break;
        case 3: {
            const std::size_t at = below(random, bytes.size());
            bytes.erase(at, 1 + below(random, std::min<std::size_t>(bytes.size() - at, 32)));
            break;
        }
        case 4:
            copy_part(bytes, random);
            break;
        case 5:
            overwrite(bytes, random, odd_integers[below(random, odd_integers.size())]);
            break;
        case 6:
            overwrite(bytes, random,
                      std::uint16_t(odd_integers[below(random, odd_integers.size())]));
            break;
        default:
            write_odd_number(bytes, random);
    }
    return bytes;
}

std::string mutated_glb(const std::string& bytes, const JsonPool& pool, Random& random) {
    if (!is_glb(bytes)) return mutated_json(bytes, pool, random);
    const std::size_t length = number_at(bytes, 12);
    Container parts{bytes.substr(20, length), bytes.substr(20 + length)};
    if (parts.rest.size() > 8 && below(random, 4) == 0)
        parts.rest = parts.rest.substr(0, 8) + mutated_bytes(parts.rest.substr(8), random);
    else
        parts.json = mutated_json(parts.json, pool, random);
    return glb_of(std::move(parts));
}

std::string mutated_png(const std::string& bytes, Random& random) {
    std::vector<std::string> chunks = png_chunks(bytes);
    if (chunks.empty()) return mutated_bytes(bytes, random);
    const std::size_t i = below(random, chunks.size()), j = below(random, chunks.size());
    switch (below(random, 8)) {
        case 0:
            chunks.erase(chunks.begin() + std::ptrdiff_t(i));
            break;
        case 1:
            chunks.insert(chunks.begin() + std::ptrdiff_t(i), std::string(chunks[j]));
            break;
        case 2:
            std::swap(chunks[i], chunks[j]);
            break;
        case 3: {
            constexpr std::array<std::string_view, 5> types{"PLTE", "tRNS", "gAMA", "IDAT", "iCCP"};
            chunks[i].replace(0, 4, types[below(random, types.size())]);
            break;
        }
        default:
            chunks[i] = chunks[i].substr(0, 4) + mutated_bytes(chunks[i].substr(4), random);
    }
    std::string result = bytes.substr(0, 8);
    for (const std::string& chunk : chunks)
        result += big_endian(chunk.size() - 4) + chunk + big_endian(crc_of(chunk));
    return result;
}

Mutator::Mutator(const Target& target) : target_(target), inputs_(first_inputs(target)) {
    for (const std::string_view word : target.words) pool_.words.emplace_back(word);
    for (const std::string& input : inputs_)
        add_to_pool(is_glb(input) ? input.substr(20, number_at(input, 12)) : input, pool_);
}

std::string Mutator::once(const std::string& bytes, std::size_t most, Random& random) const {
    if (below(random, 8) == 0) return mutated_bytes(bytes, random);
    switch (target_.form) {
        case Form::text:
            return mutated_text(bytes, target_.words, most, random);
        case Form::json:
            return mutated_json(bytes, pool_, random);
        case Form::glb:
            return mutated_glb(bytes, pool_, random);
        case Form::png:
            return mutated_png(bytes, random);
        case Form::binary:
            break;
    }
    return mutated_bytes(bytes, random);
}

std::string Mutator::operator()(std::string bytes, std::size_t most, Random& random) const {
    for (std::size_t left = 1 + below(random, 4); left > 0; --left)
        bytes = once(bytes, most, random);
    if (bytes.size() > most) bytes.resize(most);
    return bytes;
}

}  // namespace burl::fuzz
