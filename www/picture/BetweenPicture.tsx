// The picture of the way between two rotations: the body at its part, and the outlines of both ends.
import { useId } from "preact/hooks";
import type { BetweenReport, Column, ReadQuaternion } from "../engine.ts";
import { shown } from "../number/format.ts";
import type { Store } from "../state/store.ts";
import * as words from "../words/compose/between.tsx";
import { pictureWords } from "../words/picture.ts";
import { cameraOf } from "./camera.ts";
import { Stage } from "./Stage.tsx";
import { bodyAxes, ground, outline, scene, worldAxes } from "./scene.ts";
import { ofNormOne, type Quaternion } from "./space.ts";

export function BetweenPicture({ store, report }: { store: Store; report: BetweenReport }) {
  const describedBy = useId();
  const { look } = store.state.value.picture;
  const camera = cameraOf(look);
  const pose = poseOf(store, report.way);
  const ends = (["p", "q"] as const).map((end) => outline(poseOf(store, report[end]), camera, end));
  const parts = [{ lines: ground(), labels: [] }, worldAxes(), ...ends, bodyAxes(pose, "B")];
  return (
    <>
      <Stage
        scene={scene(pose, parts)}
        look={look}
        label={words.picture}
        describedBy={describedBy}
        onLook={(turned) => store.set({ picture: { ...store.state.peek().picture, look: turned } })}
      />
      <p class="picture-says" id={describedBy}>
        {words.pictureSays(shown(report.part, store.state.value.digits))}{" "}
        <span class="visually-hidden">{pictureWords.lookOnly}</span>
      </p>
    </>
  );
}

/** How the body stands, by the sign that the convention gives the vector part. */
function poseOf(store: Store, of: Column | ReadQuaternion): Quaternion {
  const { w, x, y, z } = "unit" in of ? of.unit : of.components;
  const sign = store.engine.describe(of.convention).rules.isCanonical ? 1 : -1;
  return ofNormOne({ w, x: sign * x, y: sign * y, z: sign * z });
}
