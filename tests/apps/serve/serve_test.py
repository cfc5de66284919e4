"""serve_test.py - `firsthit view --serve` over its line: pictures beside those of `render`, switches, hands, several
viewers, and whom it refuses. A page is played by a small client.

Usage: serve_test.py PROGRAM
"""
import os
import signal
import subprocess
import sys
import tempfile
import time

import png_pixels
import web_socket
from served import Page, Served

SMALL = ('--size', '120x90')
checks, failures = 0, 0


def check(holds, what):
    global checks, failures
    checks += 1
    if not holds:
        failures += 1
        print(f'FAILED: {what}')


def run(*words):
    """(exit code, what was said on stderr)"""
    done = subprocess.run([program, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120,
                          env={**os.environ, 'DISPLAY': '', 'WAYLAND_DISPLAY': ''})
    return done.returncode, done.stderr


def rendered(*options):
    code, said = run('render', *options, '-o', 'render.png', '-q')
    check(code == 0, f'render {options}: {said}')
    with open('render.png', 'rb') as file:
        return file.read()


def same_picture(page, *options):
    check(png_pixels.pixels(page.picture) == png_pixels.pixels(rendered(*options)),
          f'the page shows what render makes: {options}')


def pictures():
    for scene, options in (('builtin:robots', ()), ('builtin:torus', ('--shadows', 'map')),
                           ('builtin:robots', ('--samples', '3', '--sky', '6', '--time', '2')),
                           ('builtin:torus', ('--studio', 'on', '--tonemap', 'aces', '--background', '0.1,0.2,0.4'))):
        with Served(program, scene, *SMALL, *options) as served:
            page = served.page()
            check(page.rest(), f'{scene} {options} comes to rest')
            check(page.status['corner'].startswith(('exact', 'final')), f'the corner says {page.status["corner"]}')
            same_picture(page, scene, *SMALL, *options)


def switches():
    with Served(program, 'builtin:robots', *SMALL) as served:
        page = served.page()
        page.rest()
        names = [one['name'] for one in page.session['switches']]
        for name in ('look', 'engine', 'shadows', 'samples', 'sky', 'clip', 'camera', 'play', 'time', 'speed', 'studio',
                     'item-format', 'hold', 'rate'):
            check(name in names, f'there is a switch {name}')
        check(not {'panel', 'bars', 'help'} & set(names), 'panels are the page\'s own')
        first = page.picture
        for name, value, options in (('shadows', 'none', ('--shadows', 'none')), ('samples', '2', ('--samples', '2')),
                                     ('time', '1.5', ('--time', '1.5')), ('exposure', '1', ('--exposure', '1'))):
            page.choose(name, value)
            check(page.rest(**{name: value}), f'{name} {value} comes to rest')
            check(page.picture != first, f'{name} {value} changes the picture')
            same_picture(page, 'builtin:robots', *SMALL, *options)
            page.choose(name, {'shadows': 'auto', 'samples': '1', 'time': '0', 'exposure': '0'}[name])
            if name == 'samples':
                page.choose('aa', 4)
            check(page.rest(**({'aa': '4'} if name == 'samples' else {})), f'{name} is taken back')
            page.until(lambda p: p.picture == first, 20)
            check(page.picture == first, f'{name} taken back makes the first picture')
        for look in ('items', 'instances', 'depth', 'normals', 'light', 'difference'):
            page.choose('look', look)
            check(page.rest(look=look) and page.picture != first, f'look {look} changes the picture')
        page.choose('look', 'plaid')
        check(page.until(lambda p: p.refused) and 'accepted are color' in page.refused, 'a look that there is not')
        page.choose('bogus', '1')
        check(page.until(lambda p: 'bogus' in p.refused), 'a switch that there is not')
        page.choose('clip', '99')
        check(page.until(lambda p: 'clip' in p.refused), 'a clip that there is not')


def moves(page, what):
    """What changes the camera: the picture at rest is another."""
    before, state = page.picture, page.state
    what()
    check(page.until(lambda p: p.state != state and p.rest()) and page.picture != before, f'{what.__name__} moves')


def hands():
    with Served(program, 'builtin:robots', *SMALL) as served:
        page = served.page()
        page.rest()

        def drag():
            page.say(do='move', x=40, y=40)
            page.say(do='button', button='left', down=True, shift=False)
            for k in range(5):
                page.say(do='move', x=40 + 5 * k, y=40)
            page.say(do='button', button='left', down=False, shift=False)

        def wheel():
            page.say(do='scroll', steps=2)

        def fly():
            page.say(do='key', name='w', down=True)
            page.until(lambda p: p.status and not p.status['rest'])
            page.say(do='key', name='w', down=False)

        for what in (drag, wheel, fly, *(key_of(page, name) for name in ('1', 'shift+3', 'left', 'home'))):
            moves(page, what)
        # The camera that the page copies is that of its picture.
        moves(page, drag)
        page.key('c')
        check(page.until(lambda p: p.copied), 'the camera is copied')
        same_picture(page, 'builtin:robots', *SMALL, *(page.copied or '').split())
        # What is under the pointer, and a click on it.
        page.say(do='move', x=60, y=50)
        check(page.until(lambda p: p.status.get('pick', {}).get('y') == 50), 'what is under the pointer')
        check(any('triangle' in line for line in page.status['pick']['lines']), f'lines: {page.status["pick"]}')
        for down in (True, False):
            page.say(do='button', button='left', down=down, shift=False)
        check(page.until(lambda p: p.status['values']['selected'] != '-1'), 'a click selects')
        # It plays, and bars come.
        page.key('space')
        pictures = page.pictures
        check(page.until(lambda p: p.pictures > pictures + 5 and not p.lossless), 'it plays')
        check(page.picture[:2] == b'\xff\xd8', 'pictures that move are .jpg')
        check(page.until(lambda p: p.bars and len(p.bars['frames']) > 0), 'bars come')
        page.key('space')
        check(page.rest(play='off'), 'it stops')
        # Keys of the one who sits at the machine.
        page.key('escape')
        page.key('escape')
        time.sleep(0.3)
        check(served.is_alive(), 'escape does not end the program')


def key_of(page, name):
    def press():
        page.key(name)
    press.__name__ = f'key {name}'
    return press


def two_viewers():
    with Served(program, 'builtin:robots', *SMALL) as served:
        first, second = served.page(), served.page()
        check(first.rest() and second.rest(), 'two viewers see the picture')
        check(first.picture == second.picture, 'they see the same')
        check(second.status['viewers'] == 2, 'they know of one another')
        first.choose('look', 'items')
        check(second.rest(look='items') and first.rest(look='items'), 'what one chooses the other sees')
        check(first.picture == second.picture, 'they see the same again')
        # One that reads nothing does not hold up the other.
        second.acknowledges = False
        first.choose('look', 'color')
        first.key('space')
        pictures = first.pictures
        check(first.until(lambda p: p.pictures > pictures + 30), 'the other one does not wait')
        end = time.monotonic() + 1
        while time.monotonic() < end:
            second.hear()
        check(second.unseen <= 1, f'{second.unseen} pictures that were not acknowledged')
        # A hand that holds a button and is gone lets go.
        second.say(do='button', button='left', down=True, shift=False)
        second.close()
        first.key('space')
        check(first.until(lambda p: p.status['viewers'] == 1), 'one has gone')
        first.rest(play='off')
        before, state = first.picture, first.state
        first.say(do='move', x=30, y=30)
        first.say(do='move', x=90, y=30)
        time.sleep(0.3)
        first.say(do='key', name='g', down=False)
        check(first.rest() and first.state == state, 'nobody holds the camera')


def refusals():
    with Served(program, 'builtin:torus', *SMALL) as served:
        ask, port = served.ask, served.port
        status, headers, body = ask()
        check(status == 200 and b'<canvas' in body, f'the page: {status}')
        check("default-src 'none'" in headers.get('Content-Security-Policy', '') and
              'unsafe' not in headers['Content-Security-Policy'], 'the page has a strict policy')
        for name in ('main.js', 'page.css', 'icon.svg'):
            check(ask(name)[0] == 200, f'{name} is there')
        wrong = served.token[:-1] + ('0' if served.token[-1] != '0' else '1')
        for target in ('/', '', f'/{wrong}/', f'/{wrong}/main.js', f'/{served.token}x/', '/main.js', '/favicon.ico',
                       f'/{served.token[:-1]}/', f'/x/{served.token}/', '/' + 'a' * 4000, '*',
                       f'//{served.token}/', f'/{wrong}/socket'):
            status = web_socket.ask(served.address, target or ' ')[0]
            check(status in ((400, 403) if not target else (403,)), f'{target[:60]} is refused: {status}')
        for name in ('../main.js', '..%2f..%2fetc/passwd', '/etc/passwd', 'none.js', 'socket/', 'page/main.js'):
            check(ask(name)[0] == 404, f'{name} is not there')
        check(ask('socket')[0] == 426, 'the socket is a WebSocket')
        for method in ('POST', 'PUT', 'DELETE', 'HEAD', 'OPTIONS'):
            check(ask('', method=method)[0] in (405, 413), f'{method} is refused')
        # Names that lead here by a name server, and pages of others.
        for host in ('evil.example', f'evil.example:{port}', '', 'localhost.evil.example', '127.0.0.1.evil.example',
                     f'127.0.0.1@evil:{port}', '[::1', None, "127.0.0.1:80; img-src *"):
            check(ask('', headers={'Host': host})[0] == 403, f'host {host} is refused')
        for host in (f'localhost:{port}', 'LOCALHOST', '127.0.0.1', '127.0.0.1:9', f'[::1]:{port}', '192.168.1.2:80'):
            check(ask('', headers={'Host': host})[0] == 200, f'host {host} is accepted')
        own = f'127.0.0.1:{port}'
        for origin in ('http://evil.example', 'null', f'http://{own}.evil.example', 'file://', '', f'ftp://{own}'):
            line = web_socket.WebSocket(served.address, f'/{served.token}/socket', headers={'Origin': origin})
            check(line.status == 403, f'origin {origin} is refused: {line.status}')
        for origin in (f'http://{own}', f'https://{own}'):
            line = web_socket.WebSocket(served.address, f'/{served.token}/socket', headers={'Origin': origin})
            check(line.status == 101, f'origin {origin} is accepted: {line.status}')
            line.close()
        check(web_socket.WebSocket(served.address, f'/{wrong}/socket').status == 403, 'a wrong token has no socket')
        # Requests that are none, or too large.
        for raw, statuses in ((b'\0' * 100, (400, 0)), (b'GET\r\n\r\n', (400,)), (b'GET / HTTP/9.9\r\n\r\n', (400,)),
                              (b'GET / HTTP/1.1\r\nA: ' + b'b' * 100000 + b'\r\n\r\n', (431, 0)),
                              (b'GET /' + b'a' * 100000 + b' HTTP/1.1\r\n\r\n', (431, 0)),
                              (b'A: b\r\n' * 20000, (400, 431, 0)),
                              (f'GET /{served.token}/ HTTP/1.1\r\nHost: {own}\r\nContent-Length: 99999999999\r\n\r\n'
                               .encode(), (413, 400)),
                              (b'\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03' + os.urandom(100), (400, 0))):
            status = web_socket.ask(served.address, '', raw=raw)[0]
            check(status in statuses, f'{raw[:40]} is refused: {status}')
        check(ask()[0] == 200, 'the page is still there')


def closes(served, payload, opcode=web_socket.TEXT, codes=(1008,), **how):
    """A message that ends the line, by one of these codes."""
    line = web_socket.WebSocket(served.address, f'/{served.token}/socket')
    try:
        line.sock.sendall(web_socket.frame(opcode, payload, **how))
        while True:
            line.receive()
    except web_socket.Closed as closed:
        check(closed.code in codes, f'{payload[:60]}: closed by {closed.code} {closed.reason}')
    except OSError as error:
        check(None in codes, f'{payload[:60]}: {error}')
    line.close()


def bad_messages():
    with Served(program, 'builtin:torus', *SMALL) as served:
        for text in ('', '{', 'null', '[]', '{}', '{"do": 1}', '{"do": "jump"}', '{"do": "move"}', '{"do":"move","x":"1","y":1}',
                     '{"do":"move","x":1e999,"y":1}', '{"do":"move","x":1e30,"y":1}', '{"do":"scroll","steps":1e9}',
                     '{"do":"button","button":"fourth","down":true,"shift":false}',
                     '{"do":"button","button":"left","down":1,"shift":false}',
                     '{"do":"resize","width":0,"height":9}', '{"do":"resize","width":1e5,"height":9}',
                     '{"do":"resize","width":9.5,"height":9}', '{"do":"seen","number":-1}', '{"do":"seen","number":77}',
                     '{"do":"key","name":"f12","down":true}', '{"do":"key","name":"shift+f12","down":true}',
                     '{"do":"key","name":"' + 'a' * 100 + '","down":true}', '{"do":"open","file":"/etc/passwd"}',
                     '[' * 900, '{"do":{"do":{}}}', '{"do":"choose","switch":"look"}'):
            closes(served, text.encode())
        closes(served, b'{"do":"move","x":1,"y":1}', opcode=web_socket.BINARY)
        closes(served, b'\xff\xfe{}', codes=(1007,))
        closes(served, b' ' * 2000 + b'{}', codes=(1009,))
        closes(served, b'x', length=1 << 62, codes=(1009,))
        closes(served, b'{}', mask=False, codes=(1002,))
        closes(served, b'{}', opcode=3, codes=(1002,))
        closes(served, b'{}', opcode=0, codes=(1002,))
        closes(served, b'a' * 126, opcode=web_socket.PING, codes=(1002,))
        page = served.page()
        check(page.rest(), 'others still look')


def slow_readers():
    with Served(program, 'builtin:robots', '--size', '640x480') as served:
        page = served.page()
        page.rest()
        before = served.memory_mb()
        # They read nothing at all, with buffers as small as can be.
        slow = [web_socket.WebSocket(served.address, f'/{served.token}/socket', receive_buffer=2048) for _ in range(6)]
        page.choose('play', 'on')
        pictures, end = page.pictures, time.monotonic() + 6
        while time.monotonic() < end:
            page.hear()
        check(page.pictures - pictures > 5, f'{page.pictures - pictures} pictures in 6 s beside slow readers')
        check(served.memory_mb() < before + 60, f'memory from {before:.0f} to {served.memory_mb():.0f} MB')
        # Silence is taken for a dropped line.
        check(page.until(lambda p: p.status['viewers'] == 1, 90), 'slow readers are left')
        # One that says half a request, and one that says nothing.
        for part in (b'', b'GET / HT'):
            with web_socket.connect(served.address, 30) as sock:
                sock.sendall(part)
                begin = time.monotonic()
                check(sock.recv(100) == b'' and time.monotonic() - begin < 20, 'half a request is waited for too long')
        for line in slow:
            line.close()
        page.close()  # which has answered no pings meanwhile
        check(served.page().until(lambda p: p.pictures > 5), 'all is well')


def many_lines():
    with Served(program, 'builtin:torus', *SMALL) as served:
        lines = [web_socket.connect(served.address) for _ in range(200)]
        time.sleep(0.5)
        check(served.is_alive(), '200 lines that say nothing are survived')
        for line in lines:
            line.close()
        time.sleep(0.5)
        pages = [served.page() for _ in range(16)]
        check(pages[-1].rest(), 'sixteen pages')
        check(web_socket.WebSocket(served.address, f'/{served.token}/socket').status != 101, 'the seventeenth is refused')
        for page in pages:
            page.close()
        time.sleep(0.3)
        check(served.page().rest(), 'there is room again')


def ends():
    for sign in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        with Served(program, 'builtin:robots', *SMALL, '--measure') as served:
            page = served.page()
            page.rest()
            page.choose('play', 'on')
            page.hear()
            code, said, errors, seconds = served.end(sign)
            check(code == 0 and not errors, f'{sign.name}: {code} {errors}')
            check('frames a second' in said or 'a second' in said, f'--measure: {said}')
            check(seconds < 10, f'{sign.name} takes {seconds:.1f} s')
            try:
                while True:
                    page.hear()
            except web_socket.Closed as closed:
                check(closed.code in (1001, None), f'the page hears of the end: {closed.code}')
            except OSError:
                pass
    # Under nohup it outlives its terminal.
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    with Served(program, 'builtin:torus', *SMALL) as served:
        served.process.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        check(served.is_alive() and served.ask()[0] == 200, 'a SIGHUP that is ignored')
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
    before = set(os.listdir())
    with Served(program, 'builtin:torus', *SMALL, address='0.0.0.0') as served:
        code, _, errors, _ = served.end()
        check(errors.count('warning') == 1 and 'other machines' in errors, f'a warning: {errors}')
    with Served(program, 'builtin:torus', *SMALL) as served:
        code, said = run('view', 'builtin:torus', '--serve', f'127.0.0.1:{served.port}')
        check(code == 1 and 'no page can be served' in said, f'a port that is taken: {code} {said}')
        check(served.end()[2] == '', 'no warning on the loopback')
    check(set(os.listdir()) == before, 'files were written')
    for words, message in ((('--serve', 'nowhere:1'), 'no address to serve at'), (('--serve', '1.2.3.4:99999'), 'no address'),
                           (('--serve', '--no-window'), 'go without it'), (('--serve', '--script', 'a.txt'), 'go without it')):
        code, said = run('view', 'builtin:torus', *words)
        check(code == 2 and message in said, f'{words}: {code} {said}')
    code, said = run('view', 'missing.off', '--serve')
    check(code == 1 and 'missing.off' in said, f'a file that is missing: {code} {said}')


def files():
    """A file that changes is read again; one that fails leaves the old scene."""
    with open('one.off', 'w') as file:
        file.write('OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n')
    with Served(program, 'one.off', *SMALL) as served:
        page = served.page()
        page.rest()
        first, state = page.picture, page.state
        with open('one.off', 'w') as file:
            file.write('OFF\n3 1 0\n0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n')
        check(page.until(lambda p: p.picture != first and p.rest()), 'the file is read again')
        with open('one.off', 'w') as file:
            file.write('OFF\n3 1')
        check(page.until(lambda p: 'one.off' in p.status['message']), 'the error is shown')


if __name__ == '__main__':
    program = os.path.abspath(sys.argv[1])
    if 'built without a server of pages' in run('view', 'missing.off', '--serve')[1]:
        print('skipped: this firsthit was built without a server of pages')
        sys.exit(77)
    parts = [pictures, switches, hands, two_viewers, refusals, bad_messages, slow_readers, many_lines, ends, files]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for part in parts:
            if sys.argv[2:] and part.__name__ not in sys.argv[2:]:
                continue
            try:
                part()
            except (OSError, web_socket.Closed, RuntimeError) as error:
                check(False, f'{part.__name__}: {type(error).__name__} {error}')
        os.chdir('/')
    print(f'{checks} checks, {failures} failures')
    sys.exit(failures != 0)
