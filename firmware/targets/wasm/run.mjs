// SPDX-License-Identifier: MIT
// Runs the WebAssembly module in node: run_wasm.mjs MODULE PORTS. Every port write goes to the file
// PORTS as a record (tests/targets/records.sh); exit status 1 if the board reports a violation.
import { readFileSync, writeFileSync } from 'node:fs';

const [modulePath, portsPath] = process.argv.slice(2);
let records = new Uint8Array(1 << 20);
let used = 0;

function portWrite(port, value, width) {
    if (used + 5 > records.length) {
        const more = new Uint8Array(2 * records.length);
        more.set(records);
        records = more;
    }
    records.set([port & 0xff, port >> 8, width, value & 0xff, value >> 8], used);
    used += 5;
}

const { instance } = await WebAssembly.instantiate(readFileSync(modulePath), {
    env: { port_write: portWrite },
});
const firmware = instance.exports;
firmware.superframe_reset();
firmware.superframe_draw(0, firmware.superframe_height());
writeFileSync(portsPath, records.subarray(0, used));

const pixels = new Uint8Array(firmware.memory.buffer, firmware.superframe_pixels(), 640 * 400 * 3);
const lit = pixels.some((level) => level !== 0);
if (firmware.superframe_violations() !== 0 || !lit) {
    console.error(`violations: ${firmware.superframe_violations()}; picture lit: ${lit}`);
    process.exit(1);
}
