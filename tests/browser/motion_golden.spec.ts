// The golden cases of increments, derivatives, Jacobians and steps, read off the page.
import { readFileSync } from "node:fs";
import type { Page } from "@playwright/test";
import { shown, shownArray } from "../../www/number/format.ts";
import { expect, test } from "./support/page.ts";

type Numbers = readonly number[];
interface Case {
  id: string;
  convention: { handedness: string; function: string; direction: "B2W" | "W2B" };
  input: Record<string, Numbers>;
  output: Record<string, Numbers>;
}

const file = new URL("../vectors/golden.json", import.meta.url);
const cases: Case[] = JSON.parse(readFileSync(file, "utf8")).cases;
const outputOf = (id: string) => cases.find((of) => of.id === id)?.output ?? {};

const attitude = "rotvec 0.4 -0.7 1.1";
const rate = "0.11 -0.23 0.37";
const increment = "0.02 -0.03 0.05";
const directions = { B2W: "body-to-world", W2B: "world-to-body" };

async function open(page: Page, asked: Record<string, string>) {
  await page.goto("about:blank");
  await page.goto(`/#motion?${new URLSearchParams({ v: "1", "to-rate": "", ...asked })}`);
  await expect(page.locator(".result.motion.current")).toBeVisible();
  // Matrices stand in folds.
  await page.evaluate(() => {
    for (const details of document.querySelectorAll("details")) details.open = true;
  });
}

const card = (page: Page, name: string) => page.getByRole("region", { name, exact: true });

/** The components as they stand under their names. */
const strip = (numbers: Numbers = []) =>
  ["w", "x", "y", "z"].map((name, at) => `${name}${shown(numbers[at] ?? 0, "6")}`).join("");

async function rowsOf(page: Page, name: string): Promise<number[][]> {
  const rows = await page.getByRole("table", { name, exact: true }).getByRole("row").all();
  const cells = rows.map((row) => row.getByRole("cell").allTextContents());
  return (await Promise.all(cells)).map((row) => row.map((text) => Number(text.replace("−", "-"))));
}

function expectClose(got: Numbers, wanted: Numbers = []) {
  expect(got).toHaveLength(wanted.length);
  for (const [at, number] of wanted.entries()) expect(got[at]).toBeCloseTo(number, 5);
}

test("G01 to G08: every convention's q ⊕ δ on both axes, and its q̇", async ({ page }) => {
  for (const { convention, output } of cases.slice(0, 8)) {
    await open(page, {
      handedness: convention.handedness.toLowerCase(),
      function: convention.function.toLowerCase(),
      direction: directions[convention.direction],
      quaternion: attitude,
      rate,
      increment,
    });
    await expect(card(page, "A small turn")).toContainText(strip(output["q_plus_local"]));
    await expect(card(page, "A small turn")).toContainText(strip(output["q_plus_global"]));
    const derivative = card(page, "The derivative");
    await expect(derivative).toContainText(strip(output["q_dot"]));
    await expect(derivative).toContainText(shownArray(output["omega_W"] ?? [], "6"));
  }
});

test("G24 and G26: rates of Euler angles and of a rotation vector, and its Jacobians", async ({
  page,
}) => {
  const { omega_B: bodyRate = [] } = outputOf("G24");
  await open(page, { unit: "rad", quaternion: "ZYX 0.7 -0.4 1.1 rad", rate: bodyRate.join(" ") });
  const rates = cases.find(({ id }) => id === "G24")?.input["rates"] ?? [];
  await expect(card(page, "The derivative")).toContainText(shownArray(rates, "6"));
  await open(page, { quaternion: attitude, rate });
  const { Jr = [], Jr_inv: inverse = [], v_dot: vectorRate = [] } = outputOf("G26");
  expectClose((await rowsOf(page, "right Jacobian")).flat(), Jr.flat());
  expectClose((await rowsOf(page, "inverse of the right Jacobian")).flat(), inverse.flat());
  await expect(card(page, "The derivative")).toContainText(shownArray(vectorRate, "6"));
});

test("G31 and G33: Ω q of both conventions, and the matrix after a small turn on both axes", async ({
  page,
}) => {
  await open(page, { quaternion: "0.8 0.2 0.4 0.4", rate: "1 2 3" });
  const timesOmega = async (name: string, array: Numbers) =>
    (await rowsOf(page, `Ω of ${name}, q̇ = ½ Ω q`)).map((row) =>
      row.reduce((sum, entry, at) => sum + entry * (array[at] ?? 0), 0),
    );
  const { OmegaH_q: hamilton, OmegaJ_q_xyzw: jpl } = outputOf("G31");
  expectClose(await timesOmega("Hamilton", [0.8, 0.2, 0.4, 0.4]), hamilton);
  expectClose(await timesOmega("JPL", [0.2, 0.4, 0.4, 0.8]), jpl);
  for (const perturbation of ["local", "global"]) {
    await open(page, { quaternion: attitude, increment, perturbation });
    const rows = await rowsOf(page, "matrix after the small turn");
    expectClose(rows.flat(), outputOf("G33")[`R_WB_${perturbation}`]?.flat());
  }
});

test("G34: how far off one step of fourth order is", async ({ page }) => {
  // Both rates stand at the Gauss points of a step of 0.1 s, (½ ∓ √3/6) h.
  const [early, late] = [
    [0.3, -0.2, 0.5],
    [0.1, 0.4, -0.6],
  ] as const;
  const at = (side: number) =>
    early.map((first, axis) => {
      const last = late[axis] ?? 0;
      return (first + last) / 2 + side * (last - first) * (Math.sqrt(3) / 2);
    });
  await open(page, {
    digits: "all",
    quaternion: "1 0 0 0",
    rate: at(-1).join(" "),
    "to-rate": at(1).join(" "),
    in: "100 ms",
    motion: "n1",
  });
  const path = card(page, "Over time");
  const shownEnd = await path.locator(".strip dd").allTextContents();
  const end = shownEnd.map((text) => Number(text.replace("−", "-")));
  const [w = 0, x = 0, y = 0, z = 0] = outputOf("G34")["q_step"] ?? [];
  const [a = 0, b = 0, c = 0, d = 0] = end;
  // The vector part of q* q_step is half of the angle.
  const between = [
    a * x - b * w - c * z + d * y,
    a * y + b * z - c * w - d * x,
    a * z - b * y + c * x - d * w,
  ];
  const off = 2 * Math.hypot(...between);
  const row = path.getByRole("row", { name: /Magnus/ });
  const told = Number((await row.getByRole("cell").first().textContent())?.replace("−", "-"));
  expect(off).toBeGreaterThan(1e-9);
  expect(Math.abs(told / off - 1)).toBeLessThan(0.006);
});
