"""served.py - `firsthit view --serve` for tests: the program, and a page without a browser."""
import json
import os
import re
import signal
import struct
import subprocess
import time

import web_socket


class Served:
    """The program, while it serves. `with Served(program, 'builtin:torus', '--size', '64x64') as served:`"""

    def __init__(self, program, *options, address=None):
        words = [program, 'view', *options, '--serve'] + ([address] if address else [])
        environment = {**os.environ, 'DISPLAY': '', 'WAYLAND_DISPLAY': '', 'EGL_PLATFORM': 'surfaceless'}
        self.process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                        env=environment)
        self.url = self.process.stdout.readline().strip()
        match = re.fullmatch(r'http://(\[?[^/\]]+\]?):(\d+)/([0-9a-f]{32})/', self.url)
        if not match:
            self.process.kill()
            raise RuntimeError(f'no address: {self.url!r} {self.process.communicate()}')
        self.host, self.port, self.token = match[1].strip('[]'), int(match[2]), match[3]
        self.address = ('127.0.0.1' if self.host not in ('::1',) else self.host, self.port)

    def page(self, **options):
        return Page(self, **options)

    def ask(self, name='', **options):
        return web_socket.ask(self.address, f'/{self.token}/{name}', **options)

    def is_alive(self):
        return self.process.poll() is None

    def memory_mb(self):
        with open(f'/proc/{self.process.pid}/statm') as file:
            return int(file.read().split()[1]) * os.sysconf('SC_PAGESIZE') / 1e6

    def end(self, with_signal=signal.SIGINT):
        """(exit code, the rest of its output, what it said on stderr, seconds that its end took)"""
        begin = time.monotonic()
        if self.is_alive():
            self.process.send_signal(with_signal)
        try:
            said = self.process.communicate(timeout=30)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise
        return self.process.returncode, *said, time.monotonic() - begin

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.is_alive():
            self.end()


class Page:
    """What a page hears: the latest of everything. Pictures are acknowledged at once, unless told otherwise."""

    def __init__(self, served, acknowledges=True, **options):
        self.line = web_socket.WebSocket(served.address, f'/{served.token}/socket', **options)
        self.session = self.status = self.bars = None
        self.picture, self.number, self.state, self.lossless = b'', 0, 0, False
        self.copied = self.refused = None
        self.pictures, self.unseen = 0, 0  # that have come; that were not acknowledged
        self.acknowledges = acknowledges

    def say(self, **message):
        self.line.send(json.dumps(message))

    def choose(self, switch, value):
        self.say(do='choose', switch=switch, value=str(value))

    def key(self, name):
        self.say(do='key', name=name, down=True)
        self.say(do='key', name=name, down=False)

    def hear(self):
        """The next message."""
        kind, payload = self.line.receive()
        if kind == web_socket.BINARY:
            self.number, flags, self.state = struct.unpack('<III', payload[:12])
            self.picture, self.lossless = payload[12:], flags == 1
            self.pictures += 1
            self.unseen += 1
            if self.acknowledges:
                self.see()
            return 'picture'
        if kind == web_socket.PING:
            return 'ping'
        message = json.loads(payload)
        if message['kind'] in ('copied', 'refused'):
            setattr(self, message['kind'], message['text'])
        else:
            setattr(self, message['kind'], message)
        return message['kind']

    def see(self):
        self.unseen = 0
        self.say(do='seen', number=self.number)

    def until(self, holds, seconds=60):
        """Hears until something holds. False: it took longer."""
        end = time.monotonic() + seconds
        while not holds(self):
            if time.monotonic() > end:
                return False
            self.hear()
        return True

    def rest(self, **values):
        """Waits for the picture at rest, without loss, with switches that have these values."""
        names = {name.replace('_', '-'): str(value) for name, value in values.items()}
        return self.until(lambda page: page.status and page.status['rest'] and page.lossless and
                          page.state == page.status['state'] and
                          all(page.status['values'][name] == value for name, value in names.items()))

    def close(self):
        self.line.close()
