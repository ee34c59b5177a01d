// SPDX-License-Identifier: Apache-2.0
// Builds what the page shows of its data: elements, tables, and numbers as the terminal writes them (results/format.h).

// `content`: texts and elements; null ones are left out.
function element(name, attributes, ...content) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes ?? {})) {
    if (value !== null && value !== undefined) made.setAttribute(key, String(value));
  }
  made.append(...content.filter(one => one !== null && one !== undefined && one !== ""));
  return made;
}

function errorText(value) {
  return value === null || value === undefined ? "n/a" : value.toFixed(5);
}

function intervalText(interval) {
  return interval ? `${errorText(interval.value)} [${errorText(interval.low)}, ${errorText(interval.high)}]` : "n/a";
}

// Four digits: 0.01234, 123.5, 1.235e+6.
function significantText(value, digits = 4) {
  if (value === null || value === undefined) return "n/a";
  const rounded = Number(value.toPrecision(digits));
  return Math.abs(rounded) >= 1e6 || rounded !== 0 && Math.abs(rounded) < 1e-4 ? rounded.toExponential() : String(rounded);
}

function significantInterval(interval, digits, unit) {
  if (!interval) return "n/a";
  const text = value => significantText(value, digits);
  return `${text(interval.value)}${unit} [${text(interval.low)}, ${text(interval.high)}]`;
}

function bytesText(bytes) {
  return `${(bytes / 1048576).toFixed(1)} MiB`;
}

// Cells: the one that names its row, a number that sorts by its full value (null: absent, last), a text.
function nameCell(content) {
  return element("th", {scope: "row"}, content);
}

function numberCell(column, value, text) {
  return element("td", {class: "number", "data-column": column, "data-value": value ?? ""}, text);
}

function textCell(content, className) {
  return element("td", {class: className}, content);
}

function scrollBox(name, table) {
  return element("div", {class: "table-scroll", tabindex: 0, role: "region", "aria-label": name}, table);
}

// `headings`: texts; those of columns of numbers begin with #. `rows`: cells of each. Scrolls within itself where it is too wide.
function makeTable(name, headings, rows) {
  const head = element("tr", {}, ...headings.map(heading => element("th", {scope: "col", "data-sort": heading.startsWith("#") ? "number" : "text"},
                                                                    element("button", {type: "button"}, heading.replace(/^#/, "")))));
  const table = element("table", {class: "sortable"}, element("thead", {}, head), element("tbody", {}, ...rows.map(cells => element("tr", {}, ...cells))));
  return scrollBox(name, table);
}

const kFoldFrom = 180;  // letters

// A long text behind its beginning.
function foldedText(text) {
  if (text.length <= kFoldFrom) return text;
  return element("details", {}, element("summary", {}, text.slice(0, kFoldFrom * 2 / 3).replace(/\s\S*$/, "") + " ..."), text);
}

function warningList(texts) {
  return texts.length === 0 ? null : element("ul", {class: "warnings"}, ...texts.map(text => element("li", {}, text)));
}

function plotBox(role, title, note) {
  return element("div", {class: "plot"}, element("h4", {}, title), note ? element("p", {class: "note"}, note) : null,
                 element("div", {class: "plot-area"}, element("canvas", {"data-role": role, role: "img", "aria-label": `${title}; the numbers are in the table below`})));
}
