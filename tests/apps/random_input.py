"""random_input.py - writes a script of random input for `firsthit view`.

Usage: random_input.py SECONDS SEED. First everything that takes memory once is used once. After two thirds of the time and at the end, the window shows the same scene at
rest, and measures: view_random_input_test.sh compares the two.
"""
import random
import sys

KEYS = ('w a s d q e 1 3 7 0 f shift+f home left right up down + - space . , [ ] l t v shift+v g h tab b i ? c r '
        'pageup pagedown shift+1').split()
SWITCHES = {
    'samples': '1 2', 'aa': '1 3', 'interleave': '1 2 4', 'sky': '0 8', 'shadows': 'none map exact auto',
    'shadow-filter': '1 5', 'shadow-map-size': '0 64 1024', 'hold': 'on off', 'rate': '20 90', 'tile-size': '8 64 128',
    'exposure': '0 1', 'item-format': 'r32ui rgba8 rgb8', 'depth-format': 'float32 fixed24', 'readback': 'sync async',
    'multisample': 'none lazy3 full5 exact', 'gpu-passes': 'single multi', 'selected': '-1 0 2', 'studio': 'on off',
    'environment': 'given none studio', 'engine': 'cpu hybrid gpu auto', 'look': 'color items depth light difference',
    'time': '0 1.5 4', 'clip': '0 -1', 'speed': '-2 1 3', 'play': 'on off', 'tonemap': 'none aces'}
FILES = ['builtin:torus', 'builtin:robots', 'none.off']
REST = ['resize 640 480', 'open builtin:robots', 'choose play off', 'choose turntable off', 'choose samples 1',
        'choose look color', 'choose engine cpu', 'key home', 'wait rest', 'measure']
WARM = ['resize 800 600', 'choose shadows map', 'choose shadow-map-size 1024', 'choose multisample exact'] + [
    line for engine in ('hybrid', 'gpu', 'cpu') for scene in ('torus', 'robots') for look in ('wrong', 'difference', 'color')
    for line in (f'choose engine {engine}', f'open builtin:{scene}', f'choose look {look}', 'wait rest')]
STEP_S = 0.25  # what an action and the pause after it take, about


def action(r):
    point = lambda: f'{r.randrange(640)} {r.randrange(480)}'
    name = r.choice(list(SWITCHES))
    return r.choice([
        f'key {r.choice(KEYS)} 0.1',
        f'key {r.choice(KEYS)}',
        f"click {point()} {r.choice(['left', 'right', 'middle'])}",
        f"drag {point()} {point()} {r.choice(['left', 'right', 'middle', 'shift'])} {r.randrange(2, 12)}",
        f'scroll {point()} {r.randrange(-5, 6)}',
        f'choose {name} {r.choice(SWITCHES[name].split())}',
        f'mouse {point()}',
        f'resize {r.randrange(60, 800)} {r.randrange(60, 600)}',
        f'open {r.choice(FILES)}',
    ])


def main():
    seconds, r = float(sys.argv[1]), random.Random(int(sys.argv[2]))
    print('\n'.join(WARM))
    for share in (2 / 3, 1 / 3):
        for step in range(int(share * seconds / STEP_S)):
            print(action(r))
            print('wait 0.1 seconds')
            if step % 40 == 39:
                print('key home')  # back to where something is seen
        print('\n'.join(REST))


main()
