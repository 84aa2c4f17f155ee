// Putting text on the clipboard, also text that has to be loaded first.

/**
 * Whether the browser allowed it. A text that is still to come is handed over as a promise: Safari
 * allows no copying later than in the click itself.
 */
export async function putOnClipboard(text: string | Promise<string>): Promise<boolean> {
  try {
    if (typeof text !== "string" && (await putPromise(text))) return true;
    await navigator.clipboard.writeText(await text);
    return true;
  } catch {
    return false;
  }
}

async function putPromise(text: Promise<string>): Promise<boolean> {
  const type = "text/plain";
  try {
    const blob = text.then((loaded) => new Blob([loaded], { type }));
    await navigator.clipboard.write([new ClipboardItem({ [type]: blob })]);
    return true;
  } catch {
    // Older browsers have no ClipboardItem, or none that takes a promise.
    return false;
  }
}
