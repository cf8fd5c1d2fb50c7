// SPDX-License-Identifier: BSD-3-Clause
// How the page begins.

/** A page without WebGL keeps its report and its pictures, and says why there is no more. */
function stayStatic(reason) {
  $('status').textContent = `${reason} The report and the pictures below do not need it.`;
  $('status').hidden = false;
  $('app').hidden = true;
  document.documentElement.dataset.ready = 'static';
}

async function begin() {
  const data = JSON.parse($('data').textContent);
  const results = await Promise.all(data.results.map(decodeResult));
  $('app').hidden = false;
  let viewer;
  try {
    viewer = new Viewer(data.style, results);
  } catch (error) {
    stayStatic('This browser does not draw in three dimensions (WebGL is switched off or missing).');
    return;
  }
  await viewer.start();
  window.netloftViewer = viewer;
  $('pictures').hidden = true;
  viewer.drawNow();
  document.documentElement.dataset.ready = 'yes';
}

begin().catch((error) => stayStatic(`The page cannot be shown: ${error.message}.`));
