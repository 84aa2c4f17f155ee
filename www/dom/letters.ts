// The letters of the page, which come after its first result.

// first.js reads the same key.
const key = "quatlas-letters";

/** Has the browser keep the files of the letters; from the next visit on the page is written in them. */
export async function keepLetters() {
  const links = document.querySelectorAll<HTMLLinkElement>("link[data-letters]");
  try {
    const answers = await Promise.all([...links].map(({ href }) => fetch(href)));
    // Read to the end, or it is not kept.
    await Promise.all(answers.map((answer) => answer.arrayBuffer()));
    if (answers.every(({ ok }) => ok)) localStorage.setItem(key, "kept");
  } catch {
    // Without a network, or where nothing may be stored: the letters of the system.
  }
}
