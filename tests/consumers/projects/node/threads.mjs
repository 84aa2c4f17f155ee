import "../check.js";
import { isMainThread, parentPort, Worker } from "node:worker_threads";
import * as quatlas from "quatlas";

if (isMainThread) {
  const answer = () =>
    new Promise((resolve, reject) => {
      new Worker(new URL(import.meta.url)).on("message", resolve).on("error", reject);
    });
  // Two at once, and this thread meanwhile.
  const answers = Promise.all([answer(), answer()]);
  console.log([checkQuatlas(quatlas), ...(await answers)].join() === "ok,ok,ok" ? "ok" : "differs");
} else {
  parentPort.postMessage(checkQuatlas(quatlas));
}
