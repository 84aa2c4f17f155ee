export function ComposePicture() {
  return null;
}
