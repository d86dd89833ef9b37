// The page's buttons, lists and panels. They tell what a visitor asks for by `ask(changes)`.
import {levelColors} from './channels.js';

export function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [key, value] of Object.entries(attributes)) {
        if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
        else if (value !== null && value !== false) made.setAttribute(key, value === true ? '' : value);
    }
    made.append(...children);
    return made;
}

function list(id, label, key, change) {
    const select = element('select', {id, 'aria-keyshortcuts': key, onchange: () => change(select.value)});
    return {label: element('label', {for: id}, label, element('kbd', {}, key), select), select};
}

function fill(select, options, chosen) {
    const same = select.options.length === options.length &&
        options.every(({value, title}, i) => select.options[i].value === value && select.options[i].text === title);
    if (!same) select.replaceChildren(...options.map(({value, title}) => element('option', {value}, title)));
    select.value = chosen;
}

const named = (value, title) => ({value, title});
const shows = [named('object', 'Object'), named('both', 'Both'), named('atlas', 'Atlas')];
const lines = [named('none', 'None'), named('charts', 'Chart borders'), named('triangles', 'Triangles')];
const behinds = [named('grey', 'Grey'), named('light', 'The light')];

export const keys = [
    ['Arrow keys', 'Turn the object; move the atlas'], ['Shift + arrow keys', 'In smaller steps'], ['+ and -', 'Nearer, farther'],
    ['0', 'First view'], ['C', 'Next channel'], ['L', 'Next MIP level'], ['E', 'Next light'], ['[ and ]', 'Turn the light'],
    ['A', 'Object, both, atlas'], ['W', 'Chart borders, triangles'], ['B', 'What is behind the object'], ['M', 'Next material in the atlas'],
    ['N', 'Next object'], ['G', 'All objects'], ['Space', 'Stop or go on, where it moves'], ['?', 'These keys'],
    ['Shift', 'With a letter: the one before'],
];

export class Controls {
    constructor(contents, ask) {
        this.contents = contents;
        const set = (key) => (value) => ask({[key]: value});
        this.asset = list('asset', 'Object', 'N', set('asset'));
        this.light = list('light', 'Light', 'E', set('light'));
        this.channel = list('channel', 'Channel', 'C', set('channel'));
        this.level = list('level', 'MIP level', 'L', (value) => ask({level: value === 'auto' ? value : Number(value)}));
        this.show = list('show', 'Show', 'A', set('show'));
        this.lines = list('lines', 'Lines', 'W', set('lines'));
        this.behind = list('behind', 'Behind', 'B', set('behind'));
        const button = (text, key, action) => element('button', {type: 'button', 'aria-keyshortcuts': key, onclick: action}, text,
            element('kbd', {}, key));
        this.gallery = button('All objects', 'G', () => ask({asset: ''}));
        this.gallery.hidden = contents.assets.length < 2;
        this.asset.label.hidden = contents.assets.length < 2;
        this.save = element('a', {id: 'save', href: '#', download: ''}, 'Save .glb');
        const lists = [this.asset, this.channel, this.level, this.light, this.show, this.lines, this.behind].map(({label}) => label);
        this.bar = element('form', {id: 'bar', 'aria-label': 'What is shown', onsubmit: (event) => event.preventDefault()},
            this.gallery, ...lists, this.save, button('Keys', '?', () => this.help.showModal()));
        this.facts = element('p', {id: 'facts'});
        this.legend = element('ol', {id: 'legend', start: 0, 'aria-label': 'Colours of MIP levels'},
            ...levelColors.map((color, i) => element('li', {style: `--color: ${color}`}, `${i}`)));
        this.status = element('p', {id: 'status', role: 'status', 'aria-live': 'polite'});
        this.help = element('dialog', {id: 'help', 'aria-label': 'Keys'}, element('h2', {}, 'Keys'),
            element('dl', {}, ...keys.flatMap(([key, what]) => [element('dt', {}, key), element('dd', {}, what)])),
            element('form', {method: 'dialog'}, element('button', {}, 'Close')));
    }

    // Brings all lists to the state; `levels` is the number of MIP levels, 1 where a file's sampler reads level 0 alone.
    update(state, channels, levels) {
        fill(this.asset.select, this.contents.assets.map(({name}) => named(name, name)), state.asset);
        fill(this.light.select, this.contents.lights.map(({name}) => named(name, name)), state.light);
        fill(this.channel.select, channels.map(({name, title}) => named(name, title)), state.channel);
        const each = Array.from({length: levels}, (_, i) => named(`${i}`, `${i}`));
        fill(this.level.select, [named('auto', 'By distance'), ...each], String(state.level));
        fill(this.show.select, shows, state.show);
        fill(this.lines.select, lines, state.lines);
        fill(this.behind.select, behinds, state.behind);
        this.legend.hidden = state.channel !== 'level';
    }

    say(sentence, failed = false) {
        this.status.textContent = sentence;
        this.status.classList.toggle('failed', failed);
    }
}

// All objects as pictures; `choose(name)` opens one.
export function galleryOf(contents, choose) {
    const cards = contents.assets.map((asset) => element('li', {}, element('button',
        {type: 'button', 'data-name': asset.name, onclick: () => choose(asset.name)}, asset.picture ? element('img', {src: asset.picture, alt: '', width: 256, height: 256, loading: 'lazy'}) : '',
        element('span', {}, asset.name))));
    const gallery = element('main', {id: 'gallery'}, element('h1', {}, contents.title), element('ul', {}, ...cards));
    gallery.addEventListener('keydown', (event) => {
        const buttons = [...gallery.querySelectorAll('button')], at = buttons.indexOf(document.activeElement);
        const columns = buttons.filter((b) => b.offsetTop === buttons[0].offsetTop).length;
        const by = {ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns, ArrowUp: -columns}[event.key];
        if (by === undefined || at < 0) return;
        event.preventDefault();
        buttons[Math.min(Math.max(at + by, 0), buttons.length - 1)].focus();
    });
    return gallery;
}
