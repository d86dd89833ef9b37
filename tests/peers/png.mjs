// 8-bit RGB pictures as PNG files.
import {deflateSync, inflateSync} from 'node:zlib';

// The sRGB code of linear light.
export const encoded = (v) => Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * Math.min(v, 1) ** (1 / 2.4) - 0.055));

function crc32(bytes) {
    let crc = ~0;
    for (const byte of bytes) {
        crc ^= byte;
        for (let k = 0; k < 8; ++k) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return ~crc >>> 0;
}

function chunk(type, data) {
    const body = Buffer.concat([Buffer.from(type, 'latin1'), data]), out = Buffer.alloc(body.length + 8);
    out.writeUInt32BE(data.length);
    body.copy(out, 4);
    out.writeUInt32BE(crc32(body), body.length + 4);
    return out;
}

// The file of an 8-bit RGB picture, rows from the top.
export function png(picture, width, height) {
    const head = Buffer.alloc(13), rows = Buffer.alloc(height * (3 * width + 1));
    head.writeUInt32BE(width);
    head.writeUInt32BE(height, 4);
    head.set([8, 2], 8);
    for (let y = 0; y < height; ++y) picture.copy(rows, y * (3 * width + 1) + 1, 3 * y * width, 3 * (y + 1) * width);
    return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head), chunk('IDAT', deflateSync(rows)),
        chunk('IEND', Buffer.alloc(0))]);
}

// What a filtered byte of a PNG's row adds to: its left, upper or upper left neighbour, or a mixture.
function predicted(kind, left, up, corner) {
    if (kind < 3) return [0, left, up][kind];
    if (kind === 3) return (left + up) >> 1;
    const p = left + up - corner, away = [left, up, corner].map((v) => Math.abs(p - v));
    return away[0] <= away[1] && away[0] <= away[2] ? left : away[1] <= away[2] ? up : corner;
}

// The picture of a file of 8-bit RGB as `burl render` and png() write it: {width, height, data}.
export function readPng(bytes) {
    const parts = [];
    let width = 0, height = 0;
    for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at)) {
        const size = bytes.readUInt32BE(at), type = bytes.toString('latin1', at + 4, at + 8), data = bytes.subarray(at + 8, at + 8 + size);
        if (type === 'IHDR') {
            [width, height] = [data.readUInt32BE(0), data.readUInt32BE(4)];
            if (data[8] !== 8 || data[9] !== 2 || data[12] !== 0) throw new Error('a picture is not 8-bit RGB');
        }
        if (type === 'IDAT') parts.push(data);
    }
    const rows = inflateSync(Buffer.concat(parts)), data = Buffer.alloc(3 * width * height), stride = 3 * width;
    for (let y = 0; y < height; ++y) {
        const kind = rows[y * (stride + 1)];
        for (let x = 0; x < stride; ++x) {
            const left = x >= 3 ? data[y * stride + x - 3] : 0, up = y > 0 ? data[(y - 1) * stride + x] : 0;
            const corner = x >= 3 && y > 0 ? data[(y - 1) * stride + x - 3] : 0;
            data[y * stride + x] = rows[y * (stride + 1) + 1 + x] + predicted(kind, left, up, corner);
        }
    }
    return {width, height, data};
}
