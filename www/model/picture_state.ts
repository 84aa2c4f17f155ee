// How the picture is shown.

/** The eye goes round the origin: azimuth from world x to y, elevation towards z. */
export interface Look {
  azimuthDeg: number;
  elevationDeg: number;
}

export const firstLook: Look = { azimuthDeg: 60, elevationDeg: 26 };

/** Whether the vector is turned or the axes are; as declared where it is not chosen. */
export type Reading = "active" | "passive";
/** One pose, or also the one that the same numbers give under the other product. */
export type Poses = "one" | "both";
/** How many turns of a composition have been made. */
export type Step = 0 | 1 | 2;

export interface PictureState {
  look: Look;
  reading: Reading | undefined;
  poses: Poses;
  step: Step;
}

export const firstPicture: PictureState = {
  look: firstLook,
  reading: undefined,
  poses: "one",
  step: 2,
};
