// The words of the place of the picture, before it is there.

export const name = "Picture";
export const waits = {
  loading: "The picture …",
  failed: "The picture could not be loaded. Reload the page to try again.",
};
