// What Motion asks the core.
import type { Request } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import { choicesOf } from "../../model/motion_choices.ts";
import type { PageState } from "../../model/page_state.ts";

export function askedOfMotion(state: PageState): Request {
  const { quaternion, rate, rateEnd, duration, increment, matrix, euler } = state;
  const { rateAxes, incrementSign, steps } = choicesOf(state);
  return {
    view: "motion",
    quaternion,
    convention: declaredConvention(state),
    matrix,
    euler,
    rate,
    rateEnd,
    rateAxes,
    duration,
    steps,
    increment,
    incrementSign,
  };
}
