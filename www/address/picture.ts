// How the picture is shown, as texts of the fragment; what is as at the opening is left out.
import type { PictureState } from "../model/picture_state.ts";
import { firstLook, firstPicture, type Look } from "../model/picture_state.ts";

/** The parameters of a picture that is not as at the opening. */
export function pictureToTexts({ look, reading, poses, step }: PictureState): [string, string][] {
  const texts: [string, string][] = [];
  const [azimuth, elevation] = [Math.round(look.azimuthDeg), Math.round(look.elevationDeg)];
  if (azimuth !== firstLook.azimuthDeg || elevation !== firstLook.elevationDeg) {
    texts.push(["look", `${azimuth},${elevation}`]);
  }
  if (reading) texts.push(["picture", reading]);
  if (poses !== firstPicture.poses) texts.push(["poses", poses]);
  if (step !== firstPicture.step) texts.push(["step", String(step)]);
  return texts;
}

export function pictureFrom(parameters: URLSearchParams): PictureState {
  const reading = parameters.get("picture");
  const step = parameters.get("step");
  return {
    look: lookFrom(parameters.get("look")) ?? firstLook,
    reading: reading === "active" || reading === "passive" ? reading : undefined,
    poses: parameters.get("poses") === "both" ? "both" : "one",
    step: step === "0" ? 0 : step === "1" ? 1 : 2,
  };
}

/** `azimuth,elevation` in whole degrees. */
function lookFrom(text: string | null): Look | undefined {
  const [, azimuth, elevation] = text?.match(/^(-?\d{1,3}),(-?\d{1,2})$/) ?? [];
  return azimuth === undefined || elevation === undefined
    ? undefined
    : { azimuthDeg: Number(azimuth), elevationDeg: Number(elevation) };
}
