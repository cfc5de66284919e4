"""serve_browser_test.py - the page of `firsthit view --serve` in headless Chromium: hands, keys, switches, panels, two
viewers, a wrong token. Ends with 77, which ctest counts as skipped, where there is no Chromium.

Usage: serve_browser_test.py PROGRAM [FOLDER of screenshots]
"""
import os
import subprocess
import sys
import tempfile
import time

import browser
import png_pixels
from served import Served

REST = ('document.getElementById("corner") && document.getElementById("corner").dataset.rest === "true" && '
        'document.getElementById("picture").dataset.lossless === "true" && '
        'document.getElementById("picture").dataset.state === document.getElementById("corner").dataset.state')
STATE = 'document.getElementById("picture").dataset.state'
SIZE = ('--size', '480x360')
checks, failures = 0, 0


def check(holds, what):
    global checks, failures
    checks += 1
    if not holds:
        failures += 1
        print(f'FAILED: {what}')


def rendered(*options):
    subprocess.run([program, 'render', *options, '-o', 'render.png', '-q'], check=True, timeout=120)
    with open('render.png', 'rb') as file:
        return png_pixels.pixels(file.read())[3]


def shown(tab):
    """The rows of the page's picture, without alpha."""
    width, height, channels, rows = png_pixels.pixels(tab.canvas())
    if channels == 3:
        return rows
    return [bytes(value for k, value in enumerate(row) if k % 4 != 3) for row in rows]


def rests(tab, what):
    check(tab.until(REST), f'{what}: comes to rest')


def changes(tab, what, act):
    """The picture at rest is another after an action."""
    before, state = tab.canvas(), tab.evaluate(STATE)
    act()
    check(tab.until(f'{STATE} !== "{state}" && {REST}'), f'{what}: comes to rest')
    check(tab.canvas() != before, f'{what} changes the picture')


def choose(tab, name, value):
    """As a hand that takes another value of a list or a slider."""
    kind = 'input' if tab.evaluate(f'document.getElementById("switch-{name}").type') == 'range' else 'change'
    tab.evaluate(f'''{{const one = document.getElementById("switch-{name}");
        one.value = "{value}"; one.dispatchEvent(new Event("{kind}"));}}''')


def is_shown(name):
    return f'!document.getElementById("{name}").hidden'


def look(tab):
    rests(tab, 'the page')
    check(shown(tab) == rendered('builtin:robots', *SIZE), 'the page shows what render makes')
    for what, act in (('drag', lambda: tab.drag(700, 500, 760, 540)),
                      ('drag with shift', lambda: tab.drag(700, 500, 760, 540, modifiers=8)),
                      ('right drag', lambda: tab.drag(700, 500, 720, 510, 'right')),
                      ('middle drag', lambda: tab.drag(700, 500, 730, 520, 'middle')),
                      ('wheel', lambda: tab.wheel(800, 400, -300)), ('key F', lambda: tab.press('F')),
                      ('flying', lambda: tab.press('w', 0.4)),
                      ('flying aside', lambda: tab.press('a', 0.4)),
                      ('key 1', lambda: tab.press('1')), ('key left', lambda: tab.press('left')),
                      ('key v', lambda: tab.press('v')),
                      ('key V', lambda: tab.press('V')), ('key h', lambda: tab.press('h')),
                      ('key home', lambda: tab.press('home'))):
        changes(tab, what, act)
    changes(tab, 'shadows', lambda: choose(tab, 'shadows', 'auto'))
    check(shown(tab) == rendered('builtin:robots', *SIZE), 'the first camera again')
    for name, value in (('look', 'items'), ('look', 'color'), ('shadows', 'none'), ('aa', 1), ('samples', 2), ('sky', 6),
                        ('exposure', 1), ('tonemap', 'aces'), ('time', 2), ('clip', -1)):
        changes(tab, f'{name} {value}', lambda: choose(tab, name, value))
    choose(tab, 'clip', 0)
    choose(tab, 'exposure', 999)
    check(tab.until(f'{is_shown("message")} && document.getElementById("message").textContent.includes("exposure")'),
          'what is not accepted is told')


def play(tab):
    state = tab.evaluate(STATE)
    tab.press('space')
    check(tab.until('document.getElementById("switch-play").checked'), 'it plays')
    check(tab.until(f'Number({STATE}) > {int(state) + 20}'), 'pictures come')
    check(tab.until('Number(document.getElementById("switch-time").value) > 0'), 'the time goes on')
    check('frames a second' in tab.evaluate('document.getElementById("counts").textContent'), 'the bars count')
    tab.screenshot(os.path.join(folder, 'playing.png'))
    tab.press('space')
    rests(tab, 'playing stops')
    # Scrubbing by the mouse.
    box = tab.evaluate('''(() => {const one = document.getElementById("switch-time"); one.scrollIntoView({block: "center"});
        const b = one.getBoundingClientRect(); return {x: b.left, y: b.top + b.height / 2, width: b.width};})()''')
    changes(tab, 'scrubbing', lambda: tab.drag(box['x'] + box['width'] * 0.5, box['y'], box['x'] + box['width'] * 0.8,
                                               box['y']))
    # A slider that a hand has touched keeps no key from the picture.
    changes(tab, 'key . after scrubbing', lambda: tab.press('.'))


def panels(tab):
    for key, name in (('tab', 'panel'), ('b', 'times')):
        check(tab.evaluate(is_shown(name)), f'{name} is shown')
        tab.press(key)
        check(not tab.evaluate(is_shown(name)), f'{key} hides {name}')
        tab.press(key)
    check(not tab.evaluate(is_shown('keys')), 'the page of keys is hidden')
    tab.press('?')
    check(tab.evaluate(is_shown('keys')) and 'turn round' in tab.evaluate('document.getElementById("keys").textContent'),
          '? shows the keys')
    tab.screenshot(os.path.join(folder, 'keys.png'))
    tab.press('escape')
    check(not tab.evaluate(is_shown('keys')), 'escape hides them')
    # What is under the pointer; a click selects it.
    rests(tab, 'panels')
    tab.mouse('Moved', 640, 420)
    check(tab.until(f'{is_shown("pixel")} && document.getElementById("pixel").textContent.includes("triangle")'),
          'what is under the pointer')
    tab.screenshot(os.path.join(folder, 'pixel.png'))
    changes(tab, 'a click', lambda: tab.click(640, 420))
    tab.press('i')
    check(not tab.evaluate(is_shown('pixel')), 'i hides what is under the pointer')
    tab.press('i')


def saving(tab):
    tab.call('Browser.setDownloadBehavior', behavior='allow', downloadPath=os.getcwd())
    rests(tab, 'saving')
    tab.press('f12')
    for _ in range(100):
        if os.path.exists('firsthit.png'):
            break
        time.sleep(0.1)
    time.sleep(0.2)
    check(os.path.exists('firsthit.png'), 'F12 saves the picture')
    if os.path.exists('firsthit.png'):
        with open('firsthit.png', 'rb') as file:
            check(png_pixels.pixels(file.read())[3] == shown(tab), 'the file is the picture')


def viewers(chromium, served, tab):
    other = chromium.tab(served.url, width=900, height=600)
    rests(other, 'a second page')
    check(other.canvas() == tab.canvas(), 'both show the same')
    changes(tab, 'look in the other page', lambda: choose(other, 'look', 'normals'))
    check(tab.until('document.getElementById("switch-look").value === "normals"'), 'both panels say so')
    check(tab.until('document.getElementById("corner").textContent.includes("2 viewers")'), 'the corner says how many look')
    rests(other, 'a second page')
    check(other.canvas() == tab.canvas(), 'both show the same again')
    other.screenshot(os.path.join(folder, 'second.png'))
    wrong = chromium.tab(served.url[:-5] + 'abcd/')
    check(wrong.until('document.body && document.body.textContent.includes("not the one")'), 'a wrong token')
    # The page of another site cannot speak to the session, even with the token.
    foreign = chromium.tab('data:text/html,<title>foreign</title>')
    address = served.url.replace('http', 'ws') + 'socket'
    check(foreign.evaluate(f'''new Promise(done => {{const line = new WebSocket("{address}");
        line.onopen = () => done("open"); line.onerror = () => done("refused");}})''') == 'refused',
          'a foreign page is refused')
    for page in (tab, other):
        check(not page.complaints, f'the page complains: {page.complaints}')


def resizing(chromium):
    with Served(program, 'builtin:torus') as served:
        tab = chromium.tab(served.url, width=700, height=500)
        size = '`${document.getElementById("picture").width}x${document.getElementById("picture").height}`'
        check(tab.until(f'{REST} && {size} === "700x500"'), 'the picture has the page\'s size')
        tab.call('Emulation.setDeviceMetricsOverride', width=500, height=400, deviceScaleFactor=1, mobile=False)
        check(tab.until(f'{REST} && {size} === "500x400"'), 'and follows it')
        check(shown(tab) == rendered('builtin:torus', '--size', '500x400'), 'as render makes it')
        served.end()
        check(tab.until('document.getElementById("corner").textContent.includes("the program has ended")'),
              'the page says that the program has ended')
        tab.evaluate('new Promise(done => setTimeout(done, 1500))')
        check('has ended' in tab.evaluate('document.getElementById("corner").textContent'), 'it goes on saying so')


def run(chromium):
    with Served(program, 'builtin:robots', *SIZE) as served:
        tab = chromium.tab(served.url)
        look(tab)
        play(tab)
        panels(tab)
        saving(tab)
        viewers(chromium, served, tab)
        check(served.is_alive(), 'the program lives')
    resizing(chromium)


if __name__ == '__main__':
    program = os.path.abspath(sys.argv[1])
    if not browser.find():
        print('skipped: no Chromium (apt-get install chromium)')
        sys.exit(77)
    said = subprocess.run([program, 'view', 'missing.off', '--serve'], stderr=subprocess.PIPE, text=True).stderr
    if 'built without a server of pages' in said:
        print('skipped: this firsthit was built without a server of pages')
        sys.exit(77)
    with tempfile.TemporaryDirectory() as own, browser.Browser() as chromium:
        folder = os.path.abspath(sys.argv[2]) if sys.argv[2:] else own
        os.chdir(own)
        try:
            run(chromium)
        except (OSError, RuntimeError) as error:
            check(False, f'{type(error).__name__} {error}')
        os.chdir('/')
    print(f'{checks} checks, {failures} failures')
    sys.exit(failures != 0)
