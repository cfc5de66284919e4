// keys.js - the page of keys.

export function drawKeys(rows, keys) {
    rows.replaceChildren(...keys.map(line => {
        const row = document.createElement('tr');
        row.className = line[0] ? '' : 'gap';
        for (const text of line) row.insertCell().textContent = text;
        return row;
    }));
}
