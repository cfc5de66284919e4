// main.js - joins the parts of the page: the line to the program, the picture, the hand, and the panels.
import {makeBars} from './bars.js';
import {listen} from './hand.js';
import {drawKeys} from './keys.js';
import {openLine} from './line.js';
import {makePicture} from './picture.js';
import {makeStatus} from './status.js';
import {makeSwitches} from './switches.js';

const MOST_SIDE = 4096; // of a picture that is asked for, pixels
const RESIZE_MS = 150;

const at = id => document.getElementById(id);
const send = message => line.send(message);
const picture = makePicture(at('picture'));
const switches = makeSwitches(at('groups'), send);
const status = makeStatus(at('corner'), at('message'), at('pixel'));
const bars = makeBars({head: at('times-head'), canvas: at('bars'), legend: at('legend'), counts: at('counts')});
let told = null; // the last status

function toggle(id) {
    at(id).hidden = !at(id).hidden;
    return true;
}

function save() {
    if (!picture.save()) status.say('nothing is saved: the picture is not at rest');
    return true;
}

function hover() {
    status.hover = !status.hover;
    if (told) status.show(told, pointer);
    return true;
}

function closeKeys() {
    return !at('keys').hidden && toggle('keys'); // else the key is the program's
}

function askForSize() {
    const side = length => Math.max(1, Math.min(MOST_SIDE, Math.round(length * devicePixelRatio)));
    send({do: 'resize', width: side(innerWidth), height: side(innerHeight)});
}

const pointer = listen(at('picture'), picture, send, {
    tab: () => toggle('panel'), 'shift+tab': () => toggle('panel'),
    b: () => toggle('times'), i: hover,
    '?': () => toggle('keys'), f1: () => toggle('keys'),
    f12: save, escape: closeKeys,
});

async function copied(text) {
    try {
        await navigator.clipboard.writeText(text);
    } catch {
        status.say(text); // to be copied by hand: a page from another machine may not
    }
}

const heard = {
    session(message) {
        at('scene').textContent = message.scene;
        document.title = `firsthit - ${message.scene}`;
        bars.name(message.stages);
        drawKeys(at('key-rows'), message.keys);
        switches.draw(message.switches);
    },
    status(message) {
        told = message;
        picture.resize(message.width, message.height);
        switches.show(message);
        status.show(message, pointer);
    },
    bars: message => bars.add(message),
    copied: message => copied(message.text),
    refused: message => status.say(message.text),
};

const line = openLine({
    opens: askForSize,
    text: message => heard[message.kind]?.(message),
    picture: (buffer, answer) => picture.show(buffer, answer),
    closes: why => status.lose(why),
});

let timer = 0;
addEventListener('resize', () => {
    clearTimeout(timer);
    timer = setTimeout(askForSize, RESIZE_MS);
});
at('save').addEventListener('click', save);
at('copy').addEventListener('click', () => send({do: 'key', name: 'c', down: true}));
at('help').addEventListener('click', () => toggle('keys'));
