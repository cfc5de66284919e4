"""web_socket.py - a small client of HTTP and WebSockets (RFC 6455), for tests: it can also do what no browser does."""
import base64
import os
import socket
import struct

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


class Closed(Exception):
    """The other side has closed the line; code is that of the close frame, or None."""

    def __init__(self, code=None, reason=''):
        super().__init__(f'closed: {code} {reason}')
        self.code, self.reason = code, reason


def connect(address, timeout=20):
    return socket.create_connection(address, timeout)


def read_head(sock):
    """The head of an answer and what came after it, as bytes."""
    got = b''
    while b'\r\n\r\n' not in got:
        more = sock.recv(4096)
        if not more:
            break
        got += more
    head, _, rest = got.partition(b'\r\n\r\n')
    return head, rest


def ask(address, target, method='GET', headers=None, raw=None):
    """One request: (status, headers, body); status 0 where the line is closed without an answer."""
    fields = {'Host': f'{address[0]}:{address[1]}', **(headers or {})}
    text = raw if raw is not None else (
        f'{method} {target} HTTP/1.1\r\n' + ''.join(f'{k}: {v}\r\n' for k, v in fields.items() if v is not None) +
        '\r\n').encode()
    with connect(address) as sock:
        try:
            sock.sendall(text)
        except OSError:
            pass  # refused before all was sent; the answer may be there
        try:
            head, body = read_head(sock)
            while True:
                more = sock.recv(65536)
                if not more:
                    break
                body += more
        except OSError:
            if 'head' not in locals():
                return 0, {}, b''
    if not head:
        return 0, {}, b''
    lines = head.decode('latin-1').split('\r\n')
    answered = dict(line.split(': ', 1) for line in lines[1:])
    return int(lines[0].split()[1]), answered, body


def frame(opcode, payload, fin=True, mask=True, length=None):
    """A frame; length may lie."""
    size = len(payload) if length is None else length
    head = bytes([(0x80 if fin else 0) | opcode])
    bit = 0x80 if mask else 0
    if size < 126:
        head += bytes([bit | size])
    elif size < 65536:
        head += struct.pack('>BH', bit | 126, size)
    else:
        head += struct.pack('>BQ', bit | 127, size)
    if not mask:
        return head + payload
    key = os.urandom(4)
    return head + key + bytes(b ^ key[k % 4] for k, b in enumerate(payload))


class WebSocket:
    """Pings are answered; everything else is up to who uses it."""

    def __init__(self, address, path, headers=None, receive_buffer=None):
        self.sock = socket.socket()
        self.sock.settimeout(20)
        if receive_buffer:
            self.sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        self.sock.connect(address)
        fields = {'Host': f'{address[0]}:{address[1]}', 'Upgrade': 'websocket', 'Connection': 'Upgrade',
                  'Sec-WebSocket-Version': '13',
                  'Sec-WebSocket-Key': base64.b64encode(os.urandom(16)).decode(), **(headers or {})}
        self.sock.sendall((f'GET {path} HTTP/1.1\r\n' + ''.join(f'{k}: {v}\r\n' for k, v in fields.items()) +
                           '\r\n').encode())
        head, self.buffer = read_head(self.sock)
        self.status = int(head.split()[1]) if head else 0

    def send(self, text):
        self.sock.sendall(frame(TEXT, text.encode()))

    def take(self, count):
        while len(self.buffer) < count:
            more = self.sock.recv(1 << 16)
            if not more:
                raise Closed()
            self.buffer += more
        taken, self.buffer = self.buffer[:count], self.buffer[count:]
        return taken

    def receive(self):
        """(opcode, payload) of the next message, or of a ping, which was answered. Raises Closed, socket.timeout."""
        whole, kind = b'', None
        while True:
            first, second = self.take(2)
            size = second & 127
            if size == 126:
                size, = struct.unpack('>H', self.take(2))
            elif size == 127:
                size, = struct.unpack('>Q', self.take(8))
            payload, opcode = self.take(size), first & 15
            if opcode == PING:
                self.sock.sendall(frame(PONG, payload))
                return PING, payload
            if opcode == CLOSE:
                code = struct.unpack('>H', payload[:2])[0] if len(payload) > 1 else None
                raise Closed(code, payload[2:].decode(errors='replace'))
            kind = kind or opcode
            whole += payload
            if first & 0x80:
                return kind, whole

    def close(self):
        self.sock.close()
