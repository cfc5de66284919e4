"""serve_random_test.py - the page's server under seeded random requests: well formed, malformed, huge and slow. It does not
end, it takes no more memory in the end than when it had warmed up, and one who looks meanwhile is served.

Usage: serve_random_test.py PROGRAM. FIRSTHIT_RANDOM_REQUESTS_S: seconds, default 60; FIRSTHIT_RANDOM_REQUESTS_SEED.
"""
import json
import os
import random
import subprocess
import sys
import tempfile
import threading
import time

import web_socket
from served import Served

SECONDS = float(os.environ.get('FIRSTHIT_RANDOM_REQUESTS_S', '60'))
SEED = int(os.environ.get('FIRSTHIT_RANDOM_REQUESTS_SEED', '1'))
HANDS = 4
SWITCHES = {'look': 'color items depth light difference plaid', 'samples': '1 2 17', 'aa': '1 3', 'sky': '0 4 -1',
            'shadows': 'none map exact', 'play': 'on off', 'time': '0 1.5 nan', 'clip': '0 -1 7', 'studio': 'on off',
            'speed': '-2 1 3', 'interleave': '1 4', 'selected': '-1 0 2 99999', 'engine': 'cpu', 'hold': 'on off',
            'exposure': '0 1 1e99', 'turntable': 'on off', 'bogus': 'x'}
KEYS = 'w a s d q e 1 3 7 0 f shift+f home left up + - space . , [ ] l t v h r pageup escape c x shift+1'.split()


def message(r):
    """What a page says, or might."""
    name = r.choice(list(SWITCHES))
    well = [{'do': 'move', 'x': r.uniform(-5, 330), 'y': r.uniform(-5, 250)},
            {'do': 'button', 'button': r.choice(['left', 'middle', 'right']), 'down': r.random() < 0.5,
             'shift': r.random() < 0.3},
            {'do': 'scroll', 'steps': r.uniform(-3, 3)},
            {'do': 'key', 'name': r.choice(KEYS), 'down': r.random() < 0.6}, {'do': 'release'},
            {'do': 'choose', 'switch': name, 'value': r.choice(SWITCHES[name].split())},
            {'do': 'resize', 'width': r.randrange(1, 400), 'height': r.randrange(1, 300)}]
    text = json.dumps(r.choice(well))
    if r.random() < 0.04:
        at = r.randrange(len(text))
        text = text[:at] + r.choice(['', '"', '{', '\\', '1e999', 'null', '[' * 50]) + text[at + r.randrange(3):]
    return text


def look(served, r):
    """A page that says much, reads now and then, acknowledges most pictures, and is gone."""
    line = web_socket.WebSocket(served.address, f'/{served.token}/socket',
                                receive_buffer=r.choice([None, 2048]))
    if line.status != 101:
        return line.close()
    line.sock.settimeout(0.02)
    try:
        for _ in range(r.randrange(1, 80)):
            line.send(message(r))
            try:
                kind, payload = line.receive()
                if kind == web_socket.BINARY and r.random() < 0.9:
                    line.send(json.dumps({'do': 'seen', 'number': int.from_bytes(payload[:4], 'little')}))
            except TimeoutError:
                pass
            if r.random() < 0.02:
                line.sock.sendall(web_socket.frame(r.randrange(16), r.randbytes(r.randrange(200)), fin=r.random() < 0.5,
                                                   mask=r.random() < 0.8,
                                                   length=r.choice([None, None, 1 << 20, 1 << 62])))
    finally:
        line.close()


def request(served, r):
    """HTTP, or what is none."""
    head = f'GET /{served.token}/ HTTP/1.1\r\nHost: localhost\r\n'
    text = r.choice([
        f'GET /{served.token}/{r.choice(["", "main.js", "../x", "socket", "%00"])} HTTP/1.1\r\nHost: localhost\r\n\r\n',
        f'GET /{r.randbytes(16).hex()}/ HTTP/1.1\r\nHost: localhost\r\n\r\n',
        head + 'X: ' + 'y' * r.randrange(200000) + '\r\n\r\n', head + 'Content-Length: 1000000000\r\n\r\n' + 'z' * 9999,
        head + 'Transfer-Encoding: chunked\r\n\r\nffffffff\r\n', head + f'Host: {"a" * r.randrange(300)}\r\n\r\n',
        head + 'Upgrade: websocket\r\nConnection: Upgrade\r\n\r\n', r.randbytes(r.randrange(3000)).decode('latin-1')])
    raw = bytearray(text.encode('latin-1'))
    for _ in range(r.randrange(3)):
        raw[r.randrange(len(raw) or 1):][:1] = r.randbytes(1)
    web_socket.ask(served.address, '', raw=bytes(raw) + b'\r\n\r\n')


def slow(served, r):
    """A line that says half of something, and is left open for a while."""
    with web_socket.connect(served.address) as sock:
        for byte in f'GET /{served.token}/ HTTP/1.1\r\nHost: localhost\r\n'[:r.randrange(40)].encode():
            sock.sendall(bytes([byte]))
            time.sleep(0.02)
        time.sleep(r.random())


def hand(served, seed, end):
    r = random.Random(seed)
    while time.monotonic() < end and served.is_alive():
        try:
            r.choices([look, request, slow], [4, 4, 1])[0](served, r)
        except (OSError, web_socket.Closed):
            pass  # refused


def calm(served):
    """The memory when the session rests as at first: an own page takes everything back."""
    page = served.page()
    for switch, value in (('play', 'off'), ('turntable', 'off'), ('look', 'color'), ('samples', 1), ('sky', 0),
                          ('interleave', 1), ('engine', 'cpu'), ('selected', -1)):
        page.choose(switch, value)
    rests = page.rest(play='off', turntable='off', look='color', samples=1)
    page.close()
    return served.memory_mb() if rests else None


def trial(served):
    """What went wrong; empty: nothing."""
    begin, memory, wrong = time.monotonic(), [], []
    for part in range(3):
        end = begin + SECONDS * (part + 1) / 3
        hands = [threading.Thread(target=hand, args=(served, f'{SEED} {part} {k}', end)) for k in range(HANDS)]
        for one in hands:
            one.start()
        longest = 0
        while time.monotonic() < end:
            asked = time.monotonic()
            try:
                if served.ask()[0] != 200:
                    wrong.append('the page was not sent')
            except OSError as error:
                wrong.append(f'the page was not sent: {error}')
            longest = max(longest, time.monotonic() - asked)
            time.sleep(0.2)
        for one in hands:
            one.join()
        print(f'the page was sent after {longest:.2f} s at most')
        if not served.is_alive():
            return [f'the program ended: {served.end()}']
        memory.append(calm(served))
        if memory[-1] is None:
            wrong.append('no picture at rest')
    print(f'memory {memory} MB')
    if None not in memory and memory[2] > 1.1 * memory[1] + 20:
        wrong.append(f'memory grew: {memory}')
    return wrong


if __name__ == '__main__':
    program = os.path.abspath(sys.argv[1])
    said = subprocess.run([program, 'view', 'missing.off', '--serve'], stderr=subprocess.PIPE, text=True).stderr
    if 'built without a server of pages' in said:
        print('skipped: this firsthit was built without a server of pages')
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with Served(program, 'builtin:robots', '--size', '320x240') as served:
            found = trial(served)
            code, _, errors, _ = served.end()
        if code != 0 or errors:
            found.append(f'exit code {code}: {errors[-2000:]}')
        if os.listdir():
            found.append(f'files were written: {os.listdir()}')
        os.chdir('/')
    for one in found[:10]:
        print(f'FAILED, seed {SEED}: {one}')
    sys.exit(bool(found))
