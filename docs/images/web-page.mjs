// A picture of a page of `burl page`: node web-page.mjs CHROMIUM INDEX.html#STATE OUT.png
import {writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';
import {Browser} from '../../tests/page/browser.mjs';

const [chromium, page, out] = process.argv.slice(2), [path, hash] = page.split('#');
const browser = await Browser.start(chromium, 1200, 800);
await browser.open(`${pathToFileURL(path).href}#${hash}`);
await browser.until(`document.documentElement.dataset.state === 'ready'`);
await browser.settled();
await browser.settled();
writeFileSync(out, await browser.picture());
await browser.stop();
