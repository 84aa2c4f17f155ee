// Where q goes from here.
import type { ReadReport } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import { CarryLinks } from "../parts/CarryLinks.tsx";

export function CaseLinks({ report, store }: { report: ReadReport; store: Store }) {
  return (
    <CarryLinks store={store} of="q" quaternion={report.quaternion} to={["translate", "compose"]} />
  );
}
