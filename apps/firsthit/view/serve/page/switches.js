// switches.js - the panel of switches, drawn from what the program says that there are.

const OPEN = ['look', 'animation', 'frame']; // groups that are open at first

function element(tag, properties = {}, ...children) {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children);
    return made;
}

function option(value, shown) {
    return element('option', {value, textContent: shown});
}

/// A row of the panel: {row, show(value, status)}, or null for what cannot be chosen.
function makeControl(one, choose) {
    const row = control => element('label', {title: one.text}, element('span', {textContent: one.name}), control);
    if (one.name === 'selected') {
        const text = element('span');
        const show = value => {
            text.textContent = value === '-1' ? 'click selects an instance' : `instance ${value}`;
        };
        return {row: row(text), show};
    }
    if (one.values.length === 2 && one.values[0] === 'off') {
        const box = element('input', {type: 'checkbox', id: `switch-${one.name}`});
        box.addEventListener('change', () => choose(one.name, box.checked ? 'on' : 'off'));
        return {row: row(box), show: value => { box.checked = value === 'on'; }};
    }
    if (one.values.length) {
        const list = element('select', {id: `switch-${one.name}`}, ...one.values.map((v, k) => option(v, one.shown[k])));
        list.addEventListener('change', () => choose(one.name, list.value));
        return {row: row(list), show: value => { list.value = value; }};
    }
    if (one.name === 'camera') return null; // of a file without any
    return one.slides || one.name === 'time' ? makeSlider(one, choose, row) : makeNumber(one, choose, row);
}

function makeSlider(one, choose, row) {
    const slider = element('input', {type: 'range', id: `switch-${one.name}`, min: one.least, max: one.most,
        step: one.whole ? 1 : 'any'});
    const shown = element('output');
    const tell = value => { shown.textContent = one.whole ? value : `${Number(value).toFixed(3)} s`; };
    slider.addEventListener('input', () => {
        tell(slider.value);
        choose(one.name, slider.value);
    });
    const all = row(element('span', {className: 'number'}, slider, shown));
    return {row: all, show(value, status) {
        if (one.name === 'time') {
            all.hidden = !(status.end > status.begin);
            slider.min = status.begin;
            slider.max = status.end;
        }
        if (slider.matches(':active')) return; // a hand has it
        slider.value = value;
        tell(value);
    }};
}

function makeNumber(one, choose, row) {
    const field = element('input', {type: 'number', id: `switch-${one.name}`, min: one.least, max: one.most,
        step: one.whole ? 1 : 'any'});
    field.addEventListener('change', () => choose(one.name, field.value));
    return {row: row(field), show: value => {
        if (document.activeElement !== field) field.value = Number(Number(value).toPrecision(6));
    }};
}

export function makeSwitches(place, send) {
    const choose = (name, value) => send({do: 'choose', switch: name, value: String(value)});
    const controls = new Map();
    return {
        draw(switches) {
            controls.clear();
            const opened = new Map([...place.children].map(group => [group.dataset.name, group.open]));
            const groups = new Map();
            for (const one of switches) {
                const control = makeControl(one, choose);
                if (!control) continue;
                if (!groups.has(one.group)) {
                    const group = element('details', {open: opened.get(one.group) ?? OPEN.includes(one.group)},
                        element('summary', {textContent: one.group}));
                    group.dataset.name = one.group;
                    groups.set(one.group, group);
                }
                groups.get(one.group).append(control.row);
                controls.set(one.name, control);
            }
            place.replaceChildren(...groups.values());
        },
        show(status) {
            for (const [name, control] of controls) control.show(status.values[name], status);
        },
    };
}
