// Uses a page of `burl page` as a visitor does, from a disk and without a network, with keys, a pointer and a wheel:
//   node use_page.mjs CHROMIUM FOLDER PICTURES
// FOLDER holds the page of oak and gold; PICTURES gets what it shows, NAME.png each, which page.sh holds to `burl render`. Fails with
// the first thing that is not as a visitor would expect.
import assert from 'node:assert/strict';
import {renameSync, writeFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {Browser} from './browser.mjs';

const [chromium, folder, pictures] = process.argv.slice(2);
const address = pathToFileURL(join(resolve(folder), 'index.html')).href;
const browser = await Browser.start(chromium, 1100, 700);
const chosen = (id) => browser.value(`document.getElementById('${id}').value`);
const place = (selector) => browser.value(`(({x, y, width, height}) => ({x, y, width, height}))(
    document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect())`);
const view = async () => browser.picture(await place('#view'));
const linked = async () => { // an address follows what is asked for a moment later
    for (let i = 0; i < 3; ++i) {
        await new Promise((done) => setTimeout(done, 200));
        await browser.settled();
    }
    return browser.value('location.href');
};
const frames = () => browser.value('Number(document.documentElement.dataset.frames)');

async function ready() {
    await browser.until(`document.documentElement.dataset.state === 'ready'`);
    await browser.settled();
    await browser.settled();
}

// What is drawn changes by the action, to something else again than `before`.
async function changes(what, action) {
    const before = await view();
    await action();
    await ready();
    assert.ok(!before.equals(await view()), `${what} changed nothing`);
}

async function stays(what, action) {
    const before = await view();
    await action();
    await ready();
    assert.ok(before.equals(await view()), `${what} changed the picture`);
}

const tests = {
    async 'a gallery is walked by keys and opened'() {
        await browser.open(address);
        await browser.until(`document.documentElement.dataset.state === 'gallery'`);
        assert.equal(await browser.value(`document.querySelectorAll('#gallery img').length`), 2);
        await browser.until(`[...document.images].every((image) => image.complete && image.naturalWidth === 256)`);
        await browser.press('Tab');
        await browser.press('ArrowRight');
        await browser.press('Enter');
        await ready();
        assert.equal(await chosen('asset'), 'gold');
        assert.equal(await browser.value('document.activeElement.id'), 'view');
    },
    async 'keys turn, and the first view comes back'() {
        const first = await view();
        await changes('an arrow', () => browser.press('ArrowRight'));
        await changes('an arrow with shift', () => browser.press('ArrowUp', 8));
        await changes('+', () => browser.press('+'));
        await browser.press('0');
        await ready();
        assert.ok(first.equals(await view()), '0 did not bring the first view back');
    },
    async 'a pointer turns, a wheel comes nearer, a double click goes back'() {
        const {x, y, width, height} = await place('#view'), middle = [x + width / 2, y + height / 2];
        const first = await view();
        await changes('a drag', () => browser.drag(middle, [middle[0] + 120, middle[1] + 40]));
        await changes('a wheel', () => browser.wheel(...middle, -300));
        await browser.mouse('mousePressed', ...middle, {clickCount: 1});
        await browser.mouse('mouseReleased', ...middle, {clickCount: 1});
        await browser.mouse('mousePressed', ...middle, {clickCount: 2});
        await browser.mouse('mouseReleased', ...middle, {clickCount: 2});
        await browser.settled();
        assert.ok(first.equals(await view()), 'a double click did not bring the first view back');
    },
    async 'every light looks otherwise, turns, and comes round'() {
        const seen = [await view()];
        for (let i = 1; i < 6; ++i) {
            await browser.press('e');
            await ready();
            const now = await view();
            assert.ok(seen.every((one) => !one.equals(now)), `light ${i} looks like another`);
            seen.push(now);
        }
        await browser.press('e');
        await ready();
        assert.ok(seen[0].equals(await view()), 'the first light did not come round');
        await changes(']', () => browser.press(']'));
        await browser.press('0');
    },
    async 'channels are those of the file, one after the other'() {
        await browser.press('n');
        await ready();
        assert.equal(await chosen('asset'), 'oak');
        const names = await browser.value(`[...document.getElementById('channel').options].map((o) => o.value)`);
        for (const name of ['material', 'base', 'roughness', 'normal', 'level']) assert.ok(names.includes(name), `${name} is missing`);
        const seen = [];
        for (const name of names) {
            assert.equal(await chosen('channel'), name);
            const now = await view();
            assert.ok(seen.every((one) => !one.equals(now)) || name === 'metallic', `${name} looks like another channel`);
            seen.push(now);
            await browser.press('c');
            await ready();
        }
        await browser.press('C', 8);
        await ready();
        assert.equal(await chosen('channel'), 'level');
        assert.equal(await browser.value(`document.getElementById('legend').hidden`), false);
        await browser.press('c');
    },
    async 'a level that is held blurs, the last is one colour'() {
        const last = await browser.value(`document.getElementById('level').options.length - 2`);
        assert.equal(last, 8, 'levels of 256 x 256');
        await browser.value(`document.getElementById('channel').focus()`);
        await browser.press('ArrowDown');
        await ready();
        assert.equal(await chosen('channel'), 'base');
        await changes('level 0 of the level by distance', () => browser.press('l'));
        await changes('L back by two', async () => {
            await browser.press('L', 8);
            await browser.press('L', 8);
        });
        assert.equal(await chosen('level'), String(last));
        writeFileSync(join(pictures, 'last-level.png'), await view());
        await browser.press('l');
        await browser.value(`document.getElementById('view').focus()`);
        assert.equal(await chosen('level'), 'auto');
    },
    async 'the atlas stands beside and alone, moves and comes nearer'() {
        await changes('A', () => browser.press('a'));
        await changes('W', () => browser.press('w'));
        await changes('W again', () => browser.press('w'));
        await browser.press('w');
        const {x, y, width, height} = await place('#view'), right = [x + 0.75 * width, y + height / 2];
        const turned = await linked();
        await changes('a wheel over the atlas', () => browser.wheel(...right, -800));
        await changes('a drag of the atlas', () => browser.drag(right, [right[0] - 60, right[1]]));
        assert.equal(await linked(), turned, 'the atlas turned the object');
        await changes('A again', () => browser.press('a'));
        await browser.press('0');
        await ready();
        writeFileSync(join(pictures, 'atlas.png'), await view());
        await browser.press('a');
        await ready();
    },
    async 'keys belong to whoever has the focus'() {
        await browser.press('?');
        assert.equal(await browser.value(`document.getElementById('help').open`), true);
        await stays('a key below the list of keys', () => browser.press('c'));
        await browser.press('Escape');
        assert.equal(await browser.value(`document.getElementById('help').open`), false);
        await stays('a key with control', () => browser.press('e', 2));
        await browser.press('C', 8);
        await ready();
        assert.equal(await chosen('channel'), 'material');
        await browser.value(`document.getElementById('light').focus()`);
        await changes('an arrow in the list of lights', () => browser.press('ArrowDown'));
        assert.equal(await chosen('light'), 'overcast');
        await browser.value(`document.getElementById('view').focus()`);
    },
    async 'nothing is drawn while nothing happens'() {
        await ready();
        const before = await frames();
        await new Promise((done) => setTimeout(done, 500));
        assert.equal(await frames(), before);
    },
    async 'an address shows what it showed'() {
        await browser.press('ArrowLeft');
        await browser.press('c');
        await ready();
        const before = await view(), link = await linked();
        await browser.open('about:blank');
        await browser.open(link);
        await ready();
        await browser.value(`document.getElementById('view').focus()`);
        assert.ok(before.equals(await view()), link);
        await browser.open('about:blank');
        await browser.open(`${address}#asset=oak&light=none&level=x&view=a,b&channel=no`);
        await ready();
        assert.equal(await chosen('light'), 'studio');
    },
    async 'pictures for page.sh'() {
        for (const [name, hash] of Object.entries({studio: 'asset=gold', sun: 'asset=oak&light=sun&turn=90', base: 'asset=oak&channel=base'})) {
            await browser.open('about:blank');
            await browser.open(`${address}#${hash}`);
            await ready();
            writeFileSync(join(pictures, `${name}.png`), await view());
        }
        const {width, height} = await place('#view');
        writeFileSync(join(pictures, 'size'), `${width}x${height}`);
    },
    async 'what is missing is a sentence'() {
        renameSync(join(folder, 'objects/gold.js'), join(folder, 'objects/away.js'));
        await browser.open('about:blank');
        await browser.open(`${address}#asset=gold`);
        await browser.until(`document.documentElement.dataset.state === 'failed'`);
        const sentence = await browser.value(`document.getElementById('status').textContent`);
        assert.match(sentence, /objects.gold.js is missing; copy the whole folder/);
        browser.complaints = browser.complaints.filter((text) => !/ERR_FILE_NOT_FOUND/.test(text));
        renameSync(join(folder, 'objects/away.js'), join(folder, 'objects/gold.js'));
        await browser.press('n'); // on to the next object, which is there
        await ready();
        assert.equal(await chosen('asset'), 'oak');
    },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
    try {
        await test();
        console.log(`passed: ${name}`);
    } catch (error) {
        console.log(`FAILED: ${name}: ${error.message}`);
        ++failed;
    }
}
const far = browser.requests.filter((url) => !/^(file|data|blob|about):/.test(url));
if (far.length > 0) console.log(`FAILED: the page asked for ${far.join(', ')}`);
if (browser.complaints.length > 0) console.log(`FAILED: the browser complained: ${browser.complaints.join('; ')}`);
await browser.stop();
process.exit(failed + far.length + browser.complaints.length > 0 ? 1 : 0);
