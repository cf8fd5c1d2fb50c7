// SPDX-License-Identifier: BSD-3-Clause
// The pointer and the keyboard on the picture.

const TURN = 0.08, PAN = 30, ZOOM = 1.2;  // of a key: radians, pixels, factor

function listenToPointer(viewer) {
  const {canvas, camera} = viewer;
  let last = null, moved = 0;
  const at = (event) => { const box = canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
  canvas.addEventListener('pointerdown', (event) => { last = at(event); moved = 0; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener('pointermove', (event) => {
    if (!last) return;
    const now = at(event), dx = now[0] - last[0], dy = now[1] - last[1];
    moved += Math.abs(dx) + Math.abs(dy);
    last = now;
    if (event.buttons & 2 || event.shiftKey) camera.pan(dx, dy); else camera.turn(0.008 * dx, 0.008 * dy);
    viewer.isTouched = true;
    viewer.draw();
  });
  canvas.addEventListener('pointerup', (event) => {
    if (last && moved < 4 && event.button === 0) viewer.selection.set(viewer.pickAt(...at(event)), event.shiftKey);
    last = null;
  });
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    const [x, y] = at(event);
    camera.zoom(Math.exp(-0.0015 * event.deltaY), x - viewer.panes.at(x).left, y);
    viewer.isTouched = true;
    viewer.draw();
  }, {passive: false});
}

function listenToKeys(viewer) {
  const {canvas, camera, selection} = viewer;
  const moves = {
    ArrowLeft: () => camera.turn(-TURN, 0), ArrowRight: () => camera.turn(TURN, 0), ArrowUp: () => camera.turn(0, TURN), ArrowDown: () => camera.turn(0, -TURN),
    '+': () => camera.zoom(ZOOM), '=': () => camera.zoom(ZOOM), '-': () => camera.zoom(1 / ZOOM),
  };
  const movesWithShift = {ArrowLeft: () => camera.pan(PAN, 0), ArrowRight: () => camera.pan(-PAN, 0), ArrowUp: () => camera.pan(0, PAN), ArrowDown: () => camera.pan(0, -PAN)};
  const others = {
    1: () => viewer.look('side'), 2: () => viewer.look('top'), 3: () => viewer.look('front'), 4: () => viewer.look('oblique'), 0: () => viewer.fit(),
    n: () => selection.step(1), p: () => selection.step(-1), PageDown: () => selection.stepPart(1), PageUp: () => selection.stepPart(-1),
    Enter: (event) => selection.set(viewer.pickAt(camera.width / 2, camera.height / 2), event.shiftKey), Escape: () => selection.set(null),
  };
  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const move = (event.shiftKey && movesWithShift[event.key]) || moves[event.key], act = move || others[event.key];
    if (!act) return;
    act(event);
    viewer.isTouched = viewer.isTouched || Boolean(move);
    event.preventDefault();
    viewer.draw();
  });
}
