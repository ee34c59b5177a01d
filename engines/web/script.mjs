// SPDX-License-Identifier: Apache-2.0
// Libraries that are no modules.

// What the script at `path` leaves as window[name].
export function loadScript(path, name) {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = path;
    script.onload = () => resolve(window[name]);
    script.onerror = () => reject(new Error(`${path} is not there`));
    document.head.append(script);
  });
}
