// SPDX-License-Identifier: Apache-2.0
// How long a frame takes on the device that draws it.

const yielded = () => new Promise(resolve => setTimeout(resolve, 0));

// Milliseconds of up to `timed_frames` frames that draw() submits, none begun after `timed_seconds`; none without a timer.
export async function timeFrames(gl, {timed_frames = 0, timed_seconds = 0}, draw) {
  const timer = gl.getExtension("EXT_disjoint_timer_query_webgl2");
  if (timed_frames === 0 || timer === null) return {};
  const end = performance.now() + 1000 * timed_seconds;
  const frame_ms = [];
  while (frame_ms.length < timed_frames && performance.now() < end) {
    const query = gl.createQuery(), begun = performance.now();
    gl.beginQuery(timer.TIME_ELAPSED_EXT, query);
    draw();
    gl.endQuery(timer.TIME_ELAPSED_EXT);
    while (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)) await yielded();
    const spent_ms = gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6;
    // llvmpipe may count a query from the start of the machine.
    const is_sound = !gl.getParameter(timer.GPU_DISJOINT_EXT) && spent_ms <= performance.now() - begun;
    if (is_sound) frame_ms.push(spent_ms);
    gl.deleteQuery(query);
  }
  return {frame_ms, timer: "EXT_disjoint_timer_query_webgl2"};
}
