{
  const known = [...namesBefore, "namesBefore"];
  const added = Object.getOwnPropertyNames(globalThis).filter((name) => !known.includes(name));
  if (added.join() !== "quatlas") throw new Error(`the script left ${added} behind`);
  document.title = checkQuatlas(quatlas);
}
