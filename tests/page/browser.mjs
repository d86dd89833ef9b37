// A headless Chromium that is driven through the pipe of its DevTools protocol: real keys and pointers, and pictures of what it shows.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

// No name resolves, so that whoever asks for the network fails.
const flags = ['--headless', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage',
    '--host-resolver-rules=MAP * ~NOTFOUND', '--force-device-scale-factor=1', '--remote-debugging-pipe'];

const codes = {ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Tab: 9, Enter: 13, Escape: 27, Home: 36, ' ': 32};

export class Browser {
    #next = 1;
    #waiting = new Map();
    requests = []; // the addresses of all files that pages asked for
    complaints = []; // errors on the console and uncaught

    static async start(chromium, width, height) {
        const browser = new Browser();
        browser.profile = mkdtempSync(join(tmpdir(), 'page-'));
        browser.program = spawn(chromium, [...flags, `--user-data-dir=${browser.profile}`, `--window-size=${width},${height}`, 'about:blank'],
            {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
        let text = Buffer.alloc(0);
        browser.program.stdio[4].on('data', (piece) => {
            text = Buffer.concat([text, piece]);
            for (let end; (end = text.indexOf(0)) >= 0; text = text.subarray(end + 1)) browser.#take(JSON.parse(text.subarray(0, end)));
        });
        const {targetInfos} = await browser.#send('Target.getTargets');
        const {targetId} = targetInfos.find(({type}) => type === 'page');
        browser.session = (await browser.#send('Target.attachToTarget', {targetId, flatten: true})).sessionId;
        for (const domain of ['Page', 'Runtime', 'Network', 'Log']) await browser.do(`${domain}.enable`);
        await browser.do('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: false});
        return browser;
    }

    #take(message) {
        if (message.id) {
            const {resolve, reject} = this.#waiting.get(message.id);
            this.#waiting.delete(message.id);
            message.error ? reject(new Error(message.error.message)) : resolve(message.result);
        } else if (message.method === 'Network.requestWillBeSent') this.requests.push(message.params.request.url);
        else if (message.method === 'Runtime.exceptionThrown') this.complaints.push(message.params.exceptionDetails.exception?.description);
        else if (message.method === 'Log.entryAdded' && message.params.entry.level === 'error') this.complaints.push(message.params.entry.text);
        else if (message.method === 'Runtime.consoleAPICalled' && ['error', 'warning'].includes(message.params.type)) {
            this.complaints.push(message.params.args.map((a) => a.value ?? a.description).join(' '));
        }
    }

    #send(method, params = {}, sessionId = undefined) {
        const id = this.#next++;
        this.program.stdio[3].write(JSON.stringify({id, method, params, sessionId}) + '\0');
        return new Promise((resolve, reject) => this.#waiting.set(id, {resolve, reject}));
    }

    do(method, params) { return this.#send(method, params, this.session); }

    async open(address) { await this.do('Page.navigate', {url: address}); }

    // The value of an expression in the page.
    async value(expression) {
        const {result, exceptionDetails} = await this.do('Runtime.evaluate', {expression, returnByValue: true, awaitPromise: true});
        if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
        return result.value;
    }

    // Waits until the expression is true, at most a minute.
    async until(expression) {
        for (const end = Date.now() + 60000; Date.now() < end;) {
            if (await this.value(expression).catch(() => false)) return;
            await new Promise((resolve) => setTimeout(resolve, 20));
        }
        throw new Error(`It did not become so in a minute: ${expression}; complaints: ${this.complaints.join('; ')}`);
    }

    // Two frames later all that was asked for is on the screen.
    async settled() { await this.value('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))'); }

    // Presses a key as a keyboard does; `modifiers`: 1 alt, 2 control, 8 shift.
    async press(key, modifiers = 0) {
        const code = codes[key] ?? key.toUpperCase().charCodeAt(0), text = key.length === 1 ? key : key === 'Enter' ? '\r' : undefined;
        const which = {key, modifiers, windowsVirtualKeyCode: code, text};
        await this.do('Input.dispatchKeyEvent', {type: text ? 'keyDown' : 'rawKeyDown', ...which});
        await this.do('Input.dispatchKeyEvent', {type: 'keyUp', ...which, text: undefined});
        await this.settled();
    }

    async mouse(type, x, y, extra = {}) {
        await this.do('Input.dispatchMouseEvent', {type, x, y, button: 'left', buttons: type === 'mouseReleased' ? 0 : 1, clickCount: 1, ...extra});
    }

    async click(x, y) {
        await this.mouse('mousePressed', x, y);
        await this.mouse('mouseReleased', x, y);
        await this.settled();
    }

    async drag([x, y], [toX, toY], steps = 8) {
        await this.mouse('mousePressed', x, y);
        for (let i = 1; i <= steps; ++i) await this.mouse('mouseMoved', x + (toX - x) * i / steps, y + (toY - y) * i / steps);
        await this.mouse('mouseReleased', toX, toY);
        await this.settled();
    }

    async wheel(x, y, deltaY) {
        await this.do('Input.dispatchMouseEvent', {type: 'mouseWheel', x, y, deltaX: 0, deltaY});
        await this.settled();
    }

    // The PNG of a rectangle of the window; of all of it without one.
    async picture(clip = undefined) {
        const {data} = await this.do('Page.captureScreenshot', {format: 'png', clip: clip && {...clip, scale: 1}});
        return Buffer.from(data, 'base64');
    }

    async stop() {
        this.program.kill('SIGKILL');
        await new Promise((resolve) => setTimeout(resolve, 300));
        rmSync(this.profile, {recursive: true, force: true, maxRetries: 5});
    }
}
