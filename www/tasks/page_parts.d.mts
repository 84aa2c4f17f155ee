/** A file of the built page, with the name that its hash leaves. */
export interface Part {
  name: string;
  file: string;
  path: string;
  bytes: number;
  gzip: number;
}

export function mediaTypeOf(path: string): string;

export function partsOfPage(): { first: Part[]; lazy: Part[]; fonts: Part[] };

export function gzipTotal(parts: readonly Part[]): number;

export function brotliOf(part: Part): number;

export function missingParts(): string[];
