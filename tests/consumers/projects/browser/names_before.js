globalThis.namesBefore = Object.getOwnPropertyNames(globalThis);
