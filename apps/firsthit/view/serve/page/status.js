// status.js - what is on the screen, what was said, and what is under the pointer.

const SAID_MS = 5000, ASIDE_PX = 18;

export function makeStatus(corner, message, pixel) {
    let told = '', own = '', timer = 0;

    function showMessage() {
        message.textContent = own || told;
        message.hidden = !message.textContent;
    }

    return {
        hover: true, // whether the pixel is shown
        /// Of the program.
        show(status, pointer) {
            const others = status.viewers - 1;
            corner.textContent = status.corner + (others > 0 ? ` | ${others + 1} viewers` : '');
            corner.dataset.rest = status.rest;
            corner.dataset.state = status.state ?? 0;
            told = status.message;
            showMessage();
            const here = this.hover && status.pick && Math.trunc(pointer.x) === status.pick.x &&
                Math.trunc(pointer.y) === status.pick.y;
            pixel.hidden = !here;
            if (!here) return;
            pixel.textContent = status.pick.lines.join('\n');
            // On the side of the pointer where there is room.
            const left = pointer.left > innerWidth * 0.65, up = pointer.top > innerHeight * 0.65;
            pixel.style.left = left ? '' : `${pointer.left + ASIDE_PX}px`;
            pixel.style.right = left ? `${innerWidth - pointer.left + ASIDE_PX}px` : '';
            pixel.style.top = up ? '' : `${pointer.top + ASIDE_PX}px`;
            pixel.style.bottom = up ? `${innerHeight - pointer.top + ASIDE_PX}px` : '';
        },
        /// Of the page itself, for some seconds.
        say(text) {
            own = text;
            showMessage();
            clearTimeout(timer);
            timer = setTimeout(() => { own = ''; showMessage(); }, SAID_MS);
        },
        lose(why) {
            corner.textContent = why;
            corner.dataset.rest = false;
        },
    };
}
