// `?module` or `?classic`: which of the two workers.
const isModule = location.search.includes("module");
const file = isModule ? "module_worker.mjs" : "classic_worker.js";
const worker = new Worker(file, { type: isModule ? "module" : "classic" });
worker.onmessage = ({ data }) => {
  document.title = data;
};
worker.onerror = ({ message }) => {
  document.title = message;
};
