// What a visitor sees, as one value that stands in the page's address, so that a link shows the same.

export const start = {
    asset: '', light: 'studio', turn: 0, channel: 'material', level: 'auto', show: 'object', lines: 'none', behind: 'grey',
    view: [30, 20, 3.5], material: 0,
};

const words = {show: ['object', 'both', 'atlas'], lines: ['none', 'charts', 'triangles'], behind: ['grey', 'light']};

function numberIn(text, low, high, otherwise) {
    const value = Number(text);
    return text !== '' && Number.isFinite(value) ? Math.min(Math.max(value, low), high) : otherwise;
}

function viewOf(text) {
    const numbers = text.split(',').map(Number);
    if (numbers.length !== 3 || !numbers.every(Number.isFinite)) return start.view;
    return [numbers[0], numberIn(numbers[1], -89, 89), numberIn(numbers[2], 1.2, 100)];
}

// The state of an address's part behind '#'. What it does not say, or says wrongly, is as at the start.
export function stateOf(hash) {
    const given = new URLSearchParams(hash.replace(/^#/, '')), state = {...start};
    for (const key of ['asset', 'light', 'channel']) if (given.has(key)) state[key] = given.get(key);
    for (const [key, allowed] of Object.entries(words)) if (allowed.includes(given.get(key))) state[key] = given.get(key);
    if (given.has('turn')) state.turn = numberIn(given.get('turn'), -3600, 3600, start.turn);
    if (given.has('level')) {
        const level = numberIn(given.get('level'), 0, 16, -1);
        state.level = level < 0 ? 'auto' : Math.round(level);
    }
    if (given.has('material')) state.material = Math.round(numberIn(given.get('material'), 0, 9999, 0));
    if (given.has('view')) state.view = viewOf(given.get('view'));
    return state;
}

// The part behind '#', with what differs from the start alone.
export function hashOf(state) {
    const parts = new URLSearchParams();
    for (const key of Object.keys(start)) {
        const text = key === 'view' ? state.view.map((v) => +v.toFixed(3)).join(',') : String(state[key]);
        if (text !== String(start[key])) parts.set(key, text);
    }
    return '#' + parts.toString().replaceAll('%2C', ',');
}

// The word of a list that stands `by` places behind `word`, round its end.
export function next(list, word, by) {
    const at = Math.max(list.indexOf(word), 0);
    return list[(at + by + list.length) % list.length];
}
