// What a visitor chooses for himself, beside the state of the page.

export const themes = ["system", "light", "dark"] as const;
export type Theme = (typeof themes)[number];

/** Whether a key alone does something; who speaks to the computer may want none to. */
export const shortcutChoices = ["on", "off"] as const;
export type ShortcutsChoice = (typeof shortcutChoices)[number];
