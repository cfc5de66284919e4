// line.js - the WebSocket to the program; it is made again when it drops.

const RETRY_MS = 1000;
const ENDED = 1001, REFUSED = 1008;

/// hears  {opens(), text(message), picture(buffer), closes(why)}
export function openLine(hears) {
    const address = new URL('socket', location.href);
    address.protocol = address.protocol.replace('http', 'ws');
    let socket = null;

    function connect() {
        socket = new WebSocket(address);
        socket.binaryType = 'arraybuffer';
        socket.onopen = () => hears.opens();
        socket.onmessage = ({data}) =>
            typeof data === 'string' ? hears.text(JSON.parse(data)) : hears.picture(data);
        socket.onclose = ({code, reason}) => {
            hears.closes(code === ENDED ? 'the program has ended'
                : code === REFUSED ? reason : 'the line is down');
            setTimeout(connect, RETRY_MS);
        };
    }

    connect();
    return {
        send(message) {
            if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
        },
    };
}
