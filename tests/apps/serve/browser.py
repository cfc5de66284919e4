"""browser.py - a headless Chromium for tests, driven by the DevTools protocol."""
import base64
import json
import os
import re
import shutil
import subprocess
import tempfile
import time
import urllib.request

import web_socket

KEYS = {'space': (' ', 'Space'), 'left': ('ArrowLeft', 'ArrowLeft'), 'escape': ('Escape', 'Escape'), 'tab': ('Tab', 'Tab'),
        'home': ('Home', 'Home'), 'f12': ('F12', 'F12')}


def find():
    """The program of a browser, or None."""
    for name in ('chromium', 'chromium-browser', 'google-chrome'):
        if shutil.which(name):
            return name
    return None


class Browser:
    def __init__(self, width=1280, height=720):
        self.folder = tempfile.mkdtemp()
        words = [find(), '--headless=new', '--disable-gpu', '--remote-debugging-port=0', f'--user-data-dir={self.folder}',
                 f'--window-size={width},{height}', '--no-first-run', '--disable-dev-shm-usage',
                 '--disable-background-networking', '--force-device-scale-factor=1']
        if os.geteuid() == 0:
            words.append('--no-sandbox')
        self.said = tempfile.TemporaryFile()
        self.process = subprocess.Popen([*words, 'about:blank'], stdout=subprocess.DEVNULL, stderr=self.said)
        self.address = None
        end = time.monotonic() + 60
        while not self.address:
            if time.monotonic() > end or self.process.poll() is not None:
                raise RuntimeError('the browser does not start')
            time.sleep(0.1)
            self.said.seek(0)
            found = re.search(rb'DevTools listening on ws://127\.0\.0\.1:(\d+)/', self.said.read())
            self.address = found and ('127.0.0.1', int(found[1]))

    def tab(self, url, **options):
        """A new tab."""
        request = urllib.request.Request(f'http://127.0.0.1:{self.address[1]}/json/new?about:blank', method='PUT')
        with urllib.request.urlopen(request, timeout=30) as answer:
            target = json.loads(answer.read())
        return Tab(self, re.sub(r'^ws://[^/]+', '', target['webSocketDebuggerUrl']), url, **options)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(20)
        shutil.rmtree(self.folder, ignore_errors=True)


class Tab:
    def __init__(self, browser, path, url, width=1280, height=720):
        self.line = web_socket.WebSocket(browser.address, path)
        self.count, self.complaints = 0, []
        for domain in ('Page', 'Runtime', 'Log', 'Network'):
            self.call(f'{domain}.enable')
        self.call('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.call('Page.navigate', url=url)

    def call(self, method, **parameters):
        self.count += 1
        self.line.send(json.dumps({'id': self.count, 'method': method, 'params': parameters}))
        while True:
            message = json.loads(self.line.receive()[1])
            if message.get('id') == self.count:
                if 'error' in message:
                    raise RuntimeError(f'{method}: {message["error"]}')
                return message['result']
            self.note(message)

    def note(self, event):
        """What the page should not do: exceptions, errors in the log, such as a policy that is violated."""
        if event['method'] == 'Runtime.exceptionThrown':
            self.complaints.append(json.dumps(event['params']['exceptionDetails'])[:500])
        if event['method'] == 'Log.entryAdded' and event['params']['entry']['level'] == 'error':
            self.complaints.append(event['params']['entry']['text'])

    def evaluate(self, script):
        result = self.call('Runtime.evaluate', expression=script, returnByValue=True, awaitPromise=True)
        if 'exceptionDetails' in result:
            raise RuntimeError(f'{script}: {json.dumps(result["exceptionDetails"])[:500]}')
        return result['result'].get('value')

    def until(self, script, seconds=60):
        """Waits until an expression holds. False: it took longer."""
        end = time.monotonic() + seconds
        while not self.evaluate(f'Boolean({script})'):
            if time.monotonic() > end:
                return False
            time.sleep(0.05)
        return True

    def mouse(self, kind, x, y, button='none', **more):
        self.call('Input.dispatchMouseEvent', type=f'mouse{kind}', x=x, y=y, button=button,
                  buttons={'none': 0, 'left': 1, 'right': 2, 'middle': 4}[button], clickCount=1, **more)

    def drag(self, x, y, x2, y2, button='left', modifiers=0):
        self.mouse('Moved', x, y)
        self.mouse('Pressed', x, y, button, modifiers=modifiers)
        for k in range(1, 6):
            self.mouse('Moved', x + (x2 - x) * k / 5, y + (y2 - y) * k / 5, button, modifiers=modifiers)
        self.mouse('Released', x2, y2, button, modifiers=modifiers)

    def click(self, x, y):
        self.mouse('Moved', x, y)
        self.mouse('Pressed', x, y, 'left')
        self.mouse('Released', x, y, 'left')

    def wheel(self, x, y, delta):
        self.call('Input.dispatchMouseEvent', type='mouseWheel', x=x, y=y, deltaX=0, deltaY=delta)

    def press(self, name, held_s=0):
        """A key with what it writes: "w", "F", "?", "space"."""
        key, code = KEYS.get(name, (name, f'Digit{name}' if name.isdigit() else f'Key{name.upper()}'))
        modifiers = 8 if len(name) == 1 and name.isupper() else 0
        self.call('Input.dispatchKeyEvent', type='keyDown', key=key, code=code, modifiers=modifiers)
        time.sleep(held_s)
        self.call('Input.dispatchKeyEvent', type='keyUp', key=key, code=code, modifiers=modifiers)

    def screenshot(self, path=None):
        data = base64.b64decode(self.call('Page.captureScreenshot')['data'])
        if path:
            with open(path, 'wb') as file:
                file.write(data)
        return data

    def canvas(self):
        """The picture that the page shows, as .png."""
        return base64.b64decode(self.evaluate('document.getElementById("picture").toDataURL("image/png").split(",")[1]'))
