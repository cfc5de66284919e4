// picture.js - shows the pictures that come, as large as the page allows, and tells the program that it has.

const HEAD_BYTES = 12; // in front of each: its number, whether it is without loss, and the number of the state

export function makePicture(canvas) {
    const context = canvas.getContext('2d', {alpha: false});
    const size = {width: 0, height: 0}; // of the session's picture; one that moves may have fewer pixels
    let latest = null;                  // a Blob without loss, or null

    /// As large as the page, with the picture's shape.
    function fit() {
        if (!size.width) return;
        const scale = Math.min(innerWidth / size.width, innerHeight / size.height);
        const near = Math.abs(scale * devicePixelRatio - 1) < 0.01 ? 1 / devicePixelRatio : scale;
        canvas.style.width = `${size.width * near}px`;
        canvas.style.height = `${size.height * near}px`;
    }

    async function show(buffer, answer) {
        const head = new DataView(buffer, 0, HEAD_BYTES);
        try {
            await draw(buffer, head);
        } finally {
            answer({do: 'seen', number: head.getUint32(0, true)}); // the next one may come
        }
    }

    async function draw(buffer, head) {
        const lossless = head.getUint32(4, true) === 1;
        const blob = new Blob([new Uint8Array(buffer, HEAD_BYTES)], {type: lossless ? 'image/png' : 'image/jpeg'});
        const bitmap = await createImageBitmap(blob, {colorSpaceConversion: 'none'});
        if (canvas.width !== bitmap.width || canvas.height !== bitmap.height) {
            canvas.width = bitmap.width;
            canvas.height = bitmap.height;
        }
        context.drawImage(bitmap, 0, 0);
        bitmap.close();
        latest = lossless ? blob : null;
        canvas.dataset.lossless = lossless;
        canvas.dataset.state = head.getUint32(8, true);
    }

    addEventListener('resize', fit);
    return {
        show,
        resize(width, height) {
            if (size.width === width && size.height === height) return;
            Object.assign(size, {width, height});
            fit();
        },
        /// Where an event is, in pixels of the session's picture.
        place(event) {
            const box = canvas.getBoundingClientRect();
            return {
                x: (event.clientX - box.left) * size.width / Math.max(1, box.width),
                y: (event.clientY - box.top) * size.height / Math.max(1, box.height),
            };
        },
        /// Saves what is shown; false where it is not at rest.
        save() {
            if (!latest) return false;
            const link = document.createElement('a');
            link.href = URL.createObjectURL(latest);
            link.download = 'firsthit.png';
            link.click();
            setTimeout(() => URL.revokeObjectURL(link.href), 1000);
            return true;
        },
    };
}
