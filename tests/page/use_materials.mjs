// Looks at the atlases of an object with two materials, one after the other, and opens the address that says which:
//   node use_materials.mjs CHROMIUM FOLDER
import assert from 'node:assert/strict';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {Browser} from './browser.mjs';

const [chromium, folder] = process.argv.slice(2);
const address = pathToFileURL(join(resolve(folder), 'index.html')).href;
const browser = await Browser.start(chromium, 600, 500);

// The page's picture once it is drawn, and its address, which follows a moment later.
async function shown() {
    await browser.until(`document.documentElement.dataset.state === 'ready'`);
    await new Promise((done) => setTimeout(done, 400));
    await browser.settled();
    await browser.settled();
    const {x, y, width, height} = await browser.value(`(({x, y, width, height}) => ({x, y, width, height}))(
        document.getElementById('view').getBoundingClientRect())`);
    return [await browser.picture({x, y, width, height}), await browser.value('location.href')];
}

try {
    await browser.open(`${address}#show=atlas`);
    const [first] = await shown();
    await browser.press('m');
    const [second, link] = await shown();
    assert.match(link, /material=1/);
    assert.ok(!first.equals(second), 'M changed nothing');
    await browser.open('about:blank');
    await browser.open(link);
    assert.ok(second.equals((await shown())[0]), `${link} shows another material`);
    await browser.press('m');
    const [again, back] = await shown();
    assert.doesNotMatch(back, /material/);
    assert.ok(first.equals(again), 'the first material did not come round');
    assert.deepEqual(browser.complaints, []);
} finally {
    await browser.stop();
}
