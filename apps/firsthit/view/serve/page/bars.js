// bars.js - the times of stages as stacked bars over time, the last frame at the right.

const KEPT = 100;

export function makeBars(places) {
    const {head, canvas, legend, counts} = places;
    const context = canvas.getContext('2d');
    const frames = [];
    let stages = [];

    /// What the bars' full height stands for: all of them, but for few that are much longer.
    function fullHeight() {
        const ms = frames.map(frame => frame.ms).sort((a, b) => a - b);
        return Math.max(1, Math.min(ms.at(-1), 3 * ms[Math.floor(ms.length / 2)]));
    }

    function draw(full) {
        const {width, height} = canvas, step = width / KEPT;
        context.clearRect(0, 0, width, height);
        frames.forEach((frame, k) => {
            const x = width - (frames.length - k) * step;
            let y = height;
            frame.stages.forEach((ms, stage) => {
                const up = Math.max(0, y - ms * height / full);
                context.fillStyle = stages[stage].css;
                context.fillRect(x, up, Math.max(1, step - 0.5), y - up);
                y = up;
            });
        });
    }

    function drawLegend(frame) {
        const entries = frame.stages.map((ms, k) => ({ms, ...stages[k]})).filter(entry => entry.ms > 0);
        legend.replaceChildren(...entries.map(({name, ms, css}) => {
            const entry = document.createElement('span');
            const value = document.createElement('span');
            entry.style.color = css;
            value.textContent = ms.toFixed(1);
            entry.append(name, value);
            return entry;
        }));
    }

    return {
        name(all) {
            stages = all.map(({name, color}) => ({name, css: `rgb(${color.join(' ')})`}));
        },
        add(bars) {
            frames.push(...bars.frames);
            frames.splice(0, Math.max(0, frames.length - KEPT));
            if (!frames.length) return;
            const last = frames.at(-1), full = fullHeight();
            head.textContent = `last frame ${last.ms.toFixed(1)} ms, full height ${full.toFixed(1)} ms`;
            draw(full);
            drawLegend(last);
            counts.textContent = `${bars.rate} frames a second, 1 % low ${bars.low}\n` +
                `${bars.engine} | ${bars.triangles} triangles, ${bars.in_view} in view | ${bars.memory_mb} MB`;
        },
    };
}
