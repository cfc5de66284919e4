// hand.js - what the mouse and the keyboard do, in the words of the program.

const NAMES = {' ': 'space', ArrowLeft: 'left', ArrowRight: 'right', ArrowUp: 'up', ArrowDown: 'down',
    Home: 'home', PageUp: 'pageup', PageDown: 'pagedown', Escape: 'escape', Tab: 'tab', F1: 'f1', F5: 'f5', F12: 'f12'};
const SIGNS = '.,[]+-=?';
const BUTTONS = ['left', 'middle', 'right'];
const PIXELS_A_STEP = 100, LINES_A_STEP = 3;

/// "a", "shift+f", "space"; null: no key of the program's.
function keyName(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return null;
    if (SIGNS.includes(event.key)) return event.key;
    const digit = /^(?:Digit|Numpad)([0-9])$/.exec(event.code);
    const name = NAMES[event.key] ?? (digit ? digit[1] : /^[a-zA-Z]$/.test(event.key) ? event.key.toLowerCase() : null);
    return name && event.shiftKey ? `shift+${name}` : name;
}

function isTyping() {
    return document.activeElement?.matches('input[type="number"], select') ?? false;
}

/// own  keys that the page answers itself, by name
export function listen(canvas, picture, send, own) {
    const pointer = {x: -1, y: -1};
    const move = event => {
        Object.assign(pointer, picture.place(event), {left: event.clientX, top: event.clientY});
        send({do: 'move', x: pointer.x, y: pointer.y});
    };
    const press = (event, down) => {
        if (event.button > 2) return;
        move(event);
        send({do: 'button', button: BUTTONS[event.button], down, shift: event.shiftKey});
    };
    canvas.addEventListener('pointermove', move);
    canvas.addEventListener('pointerdown', event => {
        document.activeElement?.blur(); // a field gives up the keyboard
        canvas.setPointerCapture(event.pointerId);
        press(event, true);
        event.preventDefault();
    });
    canvas.addEventListener('pointerup', event => press(event, false));
    canvas.addEventListener('pointercancel', () => send({do: 'release'}));
    canvas.addEventListener('pointerleave', () => {
        Object.assign(pointer, {x: -1, y: -1});
        send({do: 'move', x: -1, y: -1});
    });
    canvas.addEventListener('contextmenu', event => event.preventDefault());
    canvas.addEventListener('wheel', event => {
        move(event);
        const steps = -event.deltaY / (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINES_A_STEP : PIXELS_A_STEP);
        if (steps) send({do: 'scroll', steps: Math.max(-20, Math.min(20, steps))});
        event.preventDefault();
    }, {passive: false});

    addEventListener('keydown', event => {
        const name = keyName(event);
        if (!name || (isTyping() && name !== 'escape')) return;
        if (isTyping()) return document.activeElement.blur();
        event.preventDefault();
        if (own[name]?.()) return;
        if (!name.startsWith('shift+f12') && !(event.repeat && 'wasdqe'.includes(name)))
            send({do: 'key', name, down: true});
    });
    addEventListener('keyup', event => {
        const name = keyName(event);
        if (!name || own[name]) return;
        send({do: 'key', name, down: false});
        // A key that was pressed with shift may be let go without it, and the other way round.
        const other = name.startsWith('shift+') ? name.slice(6) : null;
        if (other && !own[other]) send({do: 'key', name: other, down: false});
    });
    addEventListener('blur', () => send({do: 'release'}));
    return pointer;
}
