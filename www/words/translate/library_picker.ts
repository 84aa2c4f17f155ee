// The words of the field in which a library or a convention is picked.

export const list = (label: string) => `${label}: libraries and conventions`;

export const none = (asked: string) =>
  `No library here is called “${asked}”. Try a module, a class or a language; or choose a convention.`;

export const conventions = "Conventions";
export const libraries = "Libraries, formats, devices";

export const convention = {
  hamilton: { name: "Hamilton", about: "w x y z, ij = k, body → world" },
  jpl: { name: "JPL", about: "x y z w, ij = −k, world → body (Shuster)" },
  custom: { name: "Custom convention…", about: "five axes, each by itself" },
};

/** A word by which all conventions are found. */
export const conventionWord = "convention";
