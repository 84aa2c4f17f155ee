/** What one licence or several are for, and their texts. */
export interface Licensed {
  names: string[];
  licence: string;
  texts: string[];
}

export function ownLicences(): Licensed;
export function cratesInWasm(): Licensed[];
export function nodePackage(packageName: string): Licensed;
export function licencesText(title: string, parts: readonly Licensed[]): string;
