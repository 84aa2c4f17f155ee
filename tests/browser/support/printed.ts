// What stands on the pages of a print, without a reader of PDF.
import { inflateSync } from "node:zlib";
import type { Page } from "@playwright/test";

/** How many pieces of text stand on each page of a print on A4, as Chromium writes it. */
export async function piecesPrinted(page: Page, bottomMarginPx: number): Promise<number[]> {
  const pdf = await page.pdf({ format: "A4", margin: { bottom: bottomMarginPx } });
  const source = pdf.toString("latin1");
  const contents = [...source.matchAll(/\/Type\s*\/Page\b[\s\S]*?\/Contents (\d+) 0 R/g)];
  const stream = "stream\n";
  return contents.map(([, object]) => {
    const start = source.indexOf(stream, source.indexOf(`\n${object} 0 obj`));
    const drawn = inflateSync(pdf.subarray(start + stream.length)).toString("latin1");
    return drawn.match(/\bT[jJ]\b/g)?.length ?? 0;
  });
}
