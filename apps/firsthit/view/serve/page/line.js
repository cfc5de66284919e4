// line.js - the WebSocket to the program; it is made again when it drops.

const RETRY_MS = 1000;
const ENDED = 1001, REFUSED = 1008;

/// hears  {opens(), text(message), picture(buffer, answer), closes(why)}; an answer goes to the line that the picture came by
export function openLine(hears) {
    const address = new URL('socket', location.href);
    address.protocol = address.protocol.replace('http', 'ws');
    let send = null;

    function connect() {
        const socket = new WebSocket(address);
        let opened = false;
        send = message => {
            if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
        };
        const answer = send;
        socket.binaryType = 'arraybuffer';
        socket.onopen = () => {
            opened = true;
            hears.opens();
        };
        socket.onmessage = ({data}) =>
            typeof data === 'string' ? hears.text(JSON.parse(data)) : hears.picture(data, answer);
        socket.onclose = ({code, reason}) => {
            if (opened) // else what was said before is still so
                hears.closes(code === ENDED ? 'the program has ended' : code === REFUSED ? reason : 'the line is down');
            setTimeout(connect, RETRY_MS);
        };
    }

    connect();
    return {send: message => send(message)};
}
