// Ends of a translation that print another order than they store, or no quaternion at all.
import type { Page } from "@playwright/test";
import { expect, matrix, numbersOf, quaternionField, test } from "./support/page.ts";

const strip = (page: Page, at: number) => page.locator(".translation-end").nth(at).locator("dd");
const headline = (page: Page) => page.locator("#translation-name");

test("numbers stand as a library prints them, which need not be as it stores them", async ({
  page,
}) => {
  await page.goto("/#translate?from=usd&to=eigen");
  await quaternionField(page).fill("(0.3, -0.7, 0.6, 0.2)");
  await expect(page.locator(".read-as")).toContainText(
    "OpenUSD Gf prints w x y z and stores x y z w: read as printed.",
  );
  await expect(strip(page, 1)).toHaveText(["−0.700000", "0.600000", "0.200000", "0.300000"]);
  const from = page.getByRole("group", { name: "From", exact: true });
  await expect(from.getByRole("radio", { name: "w x y z as it prints them" })).toBeChecked();
  await from.getByRole("radio", { name: "x y z w its array" }).check();
  await expect(strip(page, 1)).toHaveText(["0.300000", "−0.700000", "0.600000", "0.200000"]);
  await expect(page.getByText("read as printed")).toHaveCount(0);
});

test("from one robot to another, each in its own numbers, and back", async ({ page }) => {
  await page.goto("/#translate?from=kuka-abc&to=ur-rotvec");
  await quaternionField(page).fill("-118.4 21.3 76.9");
  await expect(headline(page)).toHaveText("From Euler angles to a rotation vector");
  // Computed with numpy.
  const vector = ["1.163317", "−1.199443", "−1.915499"];
  await expect(strip(page, 0)).toHaveText(["−118.400000", "21.300000", "76.900000"]);
  await expect(strip(page, 1)).toHaveText(vector);
  await expect(page.locator(".translation-end").nth(1).locator("dt")).toHaveText([
    "Rx",
    "Ry",
    "Rz",
  ]);
  await expect(page.getByRole("status")).toHaveText(
    "Result for Universal Robots Rx, Ry, Rz: Rx 1.163317, Ry −1.199443, Rz −1.915499. From Euler angles to a rotation vector.",
  );
  await expect(page.locator(".why")).toContainText(
    "KUKA A, B, C takes body coordinates to world coordinates by Rz(A) Ry(B) Rx(C).",
  );
  // Nothing of four numbers: no order, no conjugate, no product.
  await expect(page.getByText("Its numbers stand as")).toHaveCount(0);
  await expect(page.getByText("What goes wrong")).toHaveCount(0);
  await page.getByRole("button", { name: "Swap sides" }).click();
  await expect(strip(page, 0)).toHaveText(vector);
  await expect(strip(page, 1)).toHaveText(["−118.400000", "21.300000", "76.900000"]);
});

test("a matrix is written where a format has one, and left-handed axes are told", async ({
  page,
}) => {
  await page.goto(
    "/#translate?translated=0.8+0.2+-0.4+0.4&from=nuscenes-rotation&to=kalibr-camchain",
  );
  await expect(headline(page)).toHaveText("From a quaternion to a matrix");
  // The inverse of the pose: by hand, R(q) of these has the columns that are the rows here.
  const rows = await numbersOf(matrix(page, "matrix: Kalibr camchain (T_cam_imu)"));
  expect(rows).toEqual([0.36, 0.48, 0.8, -0.8, 0.6, 0, -0.48, -0.64, 0.6]);
  await page.goto("/#translate?from=ros-geometry-msgs&to=carla-rotation");
  await expect(page.locator(".translation")).toContainText("CARLA Rotation are left-handed");
  await page.goto("/#translate?from=unity&to=carla-rotation");
  await expect(headline(page)).toHaveText("From a quaternion to Euler angles");
  await expect(page.locator(".translation")).not.toContainText("are left-handed");
});
