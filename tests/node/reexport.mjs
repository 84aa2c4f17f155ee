// Copied into a project that has the package installed; resolves it by its name.
export * from "quatlas";
