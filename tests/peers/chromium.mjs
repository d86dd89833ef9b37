// Runs a page of this folder in a headless Chromium and answers what it asks of its server.
import {spawn} from 'node:child_process';
import {createServer} from 'node:http';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {basename, dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const types = {'.mjs': 'text/javascript', '.js': 'text/javascript', '.html': 'text/html'};
const flags = ['--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage'];

// Opens `page` in the program `chromium`. `find(url)` gives a file's bytes, or null for one of this folder; `receive(url, body)` takes
// what the page posts. Ends when the page posts to /done, and fails with what it posts to /failed, or after five minutes without either.
export function browse(chromium, page, find, receive) {
    const profile = mkdtempSync(join(tmpdir(), 'peer-'));
    return new Promise((resolve, reject) => {
        let browser, timer;
        const finish = (failure) => {
            clearTimeout(timer);
            browser?.kill('SIGKILL');
            server.close();
            setTimeout(() => {
                rmSync(profile, {recursive: true, force: true, maxRetries: 5});
                failure ? reject(new Error(failure)) : resolve();
            }, 300);
        };
        const posted = (url, body) => {
            if (url === '/failed') finish(body.toString());
            else if (url === '/done') finish(null);
            else receive(url, body);
        };
        const answer = (url, response) => {
            try {
                const body = find(url) ?? readFileSync(join(here, basename(url)));
                response.setHeader('Content-Type', types[url.slice(url.lastIndexOf('.'))] ?? 'application/octet-stream');
                response.end(body);
            } catch {
                response.statusCode = 404;
                response.end();
            }
        };
        const server = createServer((request, response) => {
            const parts = [];
            request.on('data', (part) => parts.push(part));
            request.on('end', () => {
                if (request.method !== 'POST') return answer(request.url, response);
                response.end();
                posted(request.url, Buffer.concat(parts));
            });
        });
        server.listen(0, '127.0.0.1', () => {
            browser = spawn(chromium, [...flags, `--user-data-dir=${profile}`, `http://127.0.0.1:${server.address().port}/${page}`],
                {stdio: process.env.PEER_LOG ? 'inherit' : 'ignore'});
            browser.on('error', (error) => finish(error.message));
            timer = setTimeout(() => finish('Chromium did not answer in five minutes.'), 300000);
        });
    });
}
