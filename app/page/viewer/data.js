// The files of a page are scripts, since a page that was opened from a disk may load scripts and pictures, and nothing else: each
// calls burlData(FILE, TEXT) with its bytes in base64 (app/page/page_files.h).

const waiting = new Map(), loaded = new Map();

window.burlData = (file, text) => {
    waiting.get(file)?.(text);
    waiting.delete(file);
};

function bytesOf(text) {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
    const codes = atob(text), bytes = new Uint8Array(codes.length);
    for (let i = 0; i < codes.length; ++i) bytes[i] = codes.charCodeAt(i);
    return bytes;
}

// The bytes of a file of the page. Fails with a sentence for people.
export function bytesOfFile(file) {
    return new Promise((resolve, reject) => {
        waiting.set(file, (text) => resolve(bytesOf(text)));
        const script = document.createElement('script');
        script.src = file;
        script.onload = () => {
            script.remove();
            if (waiting.delete(file)) reject(new Error(`${file} is not what this page was made with; make the page anew.`));
        };
        script.onerror = () => {
            script.remove();
            waiting.delete(file);
            reject(new Error(`${file} is missing; copy the whole folder of this page.`));
        };
        document.head.append(script);
    });
}

// The bytes of a file that is needed again and again, read once.
export function keptBytes(file) {
    if (!loaded.has(file)) {
        const reading = bytesOfFile(file);
        reading.catch(() => loaded.delete(file));
        loaded.set(file, reading);
    }
    return loaded.get(file);
}

// The bytes of a stream of DEFLATE.
export async function inflated(bytes) {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}
