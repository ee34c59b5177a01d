"use strict";

// The cell that stands in column `index`, counting columns that a spanning cell covers.
function cellAt(row, index) {
  let column = 0;
  for (const cell of row.cells) {
    column += cell.colSpan;
    if (index < column) return cell.colSpan > 1 ? null : cell;
  }
  return null;
}

function sortKey(row, index, kind) {
  const cell = cellAt(row, index);
  if (kind === "text") return cell.textContent;
  return cell && cell.dataset.value !== "" ? Number(cell.dataset.value) : null;
}

// Absent values stay last in both directions.
function compareKeys(a, b, direction) {
  if (a === null || b === null) return (a === null) - (b === null);
  return direction * (typeof a === "string" ? a.localeCompare(b, "en", {numeric: true}) : a - b);
}

function sortTable(table, header) {
  const ascending = header.getAttribute("aria-sort") !== "ascending";
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  header.setAttribute("aria-sort", ascending ? "ascending" : "descending");
  const body = table.tBodies[0];
  const keyed = Array.from(body.rows, row => ({row, key: sortKey(row, header.cellIndex, header.dataset.sort)}));
  keyed.sort((a, b) => compareKeys(a.key, b.key, ascending ? 1 : -1));
  body.append(...keyed.map(item => item.row));
}

function applyTheme(button, isDark) {
  document.documentElement.dataset.theme = isDark ? "dark" : "light";
  button.textContent = isDark ? "Light" : "Dark";
  button.setAttribute("aria-pressed", String(isDark));
}

const table = document.getElementById("results");
for (const header of table.tHead.rows[0].cells) {
  header.querySelector("button").addEventListener("click", () => sortTable(table, header));
}

const themeButton = document.getElementById("theme");
let isDark = matchMedia("(prefers-color-scheme: dark)").matches;
applyTheme(themeButton, isDark);
themeButton.addEventListener("click", () => {
  isDark = !isDark;
  applyTheme(themeButton, isDark);
});
