// SPDX-License-Identifier: Apache-2.0
// Tables: sorted by a heading; the summary is filtered by words and a choice, too.

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

// Rows that have every word, in the scene, the technique or anything else they say.
function filterTable(table) {
  const words = document.getElementById("filter").value.toLowerCase().split(/\s+/).filter(word => word);
  const scene = document.getElementById("filter-scene").value;
  let shown = 0;
  for (const row of table.tBodies[0].rows) {
    const text = row.textContent.toLowerCase();
    row.hidden = !words.every(word => text.includes(word)) || (scene !== "" && row.dataset.scene !== scene);
    shown += row.hidden ? 0 : 1;
  }
  document.getElementById("filter-count").textContent = `${shown} of ${table.tBodies[0].rows.length} runs`;
}

function listenToHeadings(table) {
  for (const header of table.tHead.rows[0].cells) {
    header.querySelector("button").addEventListener("click", () => sortTable(table, header));
  }
}

function listenToFilter(table) {
  const choice = document.getElementById("filter-scene");
  for (const scene of results.scenes) addOption(choice, scene.name, scene.name);
  for (const id of ["filter", "filter-scene"]) {
    document.getElementById(id).addEventListener("input", () => filterTable(table));
  }
  filterTable(table);
}
