// Every description of an attitude, the five axes, and Euler angles, by keyboard.
import {
  expect,
  haveNoLetters,
  matrix,
  numberOf,
  numbersOf,
  quaternionField,
  tabTo,
  test,
  textsOf,
  typeOver,
  violationsOf,
} from "./support/page.ts";

/** Yaw 30°, pitch 20°, roll 10°: half angles multiplied out with 40 digits, rounded as shown. */
const yawPitchRoll = "w 0.951549 x 0.038135 y 0.189308 z 0.239298";

const descriptions: [string, RegExp][] = [
  ["ZYX 30° 20° 10°", /Read as Euler angles ZYX, about the moving axes, 30°, 20°, 10°:/],
  ["rpy 10deg 20deg 30deg", /Read as Euler angles xyz, about the fixed axes, 10°, 20°, 30°:/],
  ["35.817017560deg about 0.12402 0.61564 0.77820", /Read as 35.817018° about/],
  [
    "gibbs 0.040076334 0.198947140 0.251483063",
    /Read as a Gibbs vector, tan\(angle\/2\) times the axis, \[0.040/,
  ],
  [
    "mrp 0.019540676 0.097003920 0.122619722",
    /Read as modified Rodrigues parameters, tan\(angle\/4\) times the axis, \[0.019/,
  ],
  [
    "halfangle 0.038762658 0.192425784 0.243239615",
    /Read as a half-angle vector, angle\/2 times the axis, \[0.038.* rad:/,
  ],
  [
    "0.8137976813493737 -0.4409696105298824 0.3785223063697925 0.4698463103929542 0.8825641192593856 0.01802831123629729 -0.3420201433256687 0.16317591116653482 0.9254165783983234",
    /Read as a matrix, body → world:/,
  ],
];
for (const [text, words] of descriptions) {
  test(`reads ${text.slice(0, 24)} and says as what`, async ({ page }) => {
    await page.goto("/");
    await tabTo(page, quaternionField(page));
    await typeOver(page, text);
    await expect(page.locator(".read-as")).toContainText(words);
    const cells = await textsOf(page.locator(".hamilton .strip dd"));
    const digits = text.includes("about") ? 4 : 6;
    const expected = yawPitchRoll.split(/ ?[wxyz] /).slice(1);
    expect(cells.map((cell) => Number(cell).toFixed(digits))).toEqual(
      expected.map((number) => Number(number).toFixed(digits)),
    );
  });
}

test("angles without a unit are read with a note", async ({ page }) => {
  await page.goto("/#read?quaternion=ZYX+30+20+10");
  await expect(page.locator(".notes")).toContainText("read as degrees");
  await page.goto("/#read?quaternion=ZYX+0.3+0.2+0.1");
  await expect(page.locator(".notes")).toContainText("read as radians");
});

test("a matrix that is not quite one is mended with a note, a reflection is refused", async ({
  page,
}) => {
  await page.goto("/");
  await quaternionField(page).fill("0.81 -0.44 0.38, 0.47 0.88 0.02, -0.34 0.16 0.93");
  await expect(page.locator(".notes")).toContainText("the nearest rotation is used, 0.0");
  await quaternionField(page).fill("1 0 0 0 1 0 0 0 -1");
  await expect(page.locator(".problem")).toContainText(
    "this matrix is a reflection, not a rotation",
  );
});

test("the five axes are chosen by keyboard and make a convention of one's own", async ({
  page,
}) => {
  await page.goto("/");
  const more = page.locator(".more > summary");
  await tabTo(page, more);
  await page.keyboard.press("Enter");
  await tabTo(page, page.getByRole("radio", { name: "body to world from the body" }).first());
  await page.keyboard.press("ArrowDown");
  // Right, passive, world to body: the same numbers name the inverse attitude.
  const declared = page.getByRole("region", { name: "Your convention" });
  await expect
    .poll(() => textsOf(declared.locator(".strip dd")))
    .toEqual(["0.923880", "0", "0", "0.382683"]);
  const hamilton = page.locator(".hamilton .strip dd");
  expect(await textsOf(hamilton)).toEqual(["0.923880", "0", "0", "−0.382683"]);
  expect(await numbersOf(matrix(page, "matrix of q as declared"))).toEqual([
    0.707107, -0.707107, 0, 0.707107, 0.707107, 0, 0, 0, 1,
  ]);
  await expect(page.getByRole("radio", { name: /^Custom/ })).toBeChecked();
  await expect(page).toHaveURL(/direction=world-to-body/);
  await expect(page.locator(".badge")).toHaveText(["as declared"]);
  // A preset takes all five back.
  await page.getByRole("radio", { name: /^Hamilton/ }).focus();
  await page.keyboard.press("Space");
  await expect(declared).toBeHidden();
  await expect(page).not.toHaveURL(/direction/);
});

test("conventions with a name are called by it", async ({ page }) => {
  await page.goto("/#read?function=active&direction=world-to-body");
  await expect(page.getByRole("heading", { name: "“My Lab” of the field guide" })).toBeVisible();
  await expect(page.getByLabel("What this convention multiplies")).toContainText(
    "those of Hamilton",
  );
  await page.goto("/#read?as=jpl&direction=body-to-world");
  await expect(page.getByRole("heading", { name: "JPL of Yoosefian 2021" })).toBeVisible();
  await expect(page.getByLabel("What this convention multiplies")).toContainText("conjugate");
  await expect(page.locator(".relation")).toContainText("This is what you declared.");
});

test("nine numbers are read with the function and direction of a matrix", async ({ page }) => {
  await page.goto("/#read?quaternion=0+-1+0+1+0+0+0+0+1");
  await expect(page.getByRole("textbox", { name: "yaw in degrees" })).toHaveValue("90");
  await page.locator(".more > summary").click();
  const direction = page.getByRole("radiogroup", { name: "Direction of the matrix" });
  await direction.getByRole("radio", { name: "body to world" }).focus();
  await page.keyboard.press("ArrowDown");
  await expect(page.getByRole("textbox", { name: "yaw in degrees" })).toHaveValue("−90");
  await expect(page.locator(".read-as")).toContainText("a matrix, world → body");
});

test("Euler angles follow the chosen sequence, and gimbal lock is told", async ({ page }) => {
  await page.goto("/#read?quaternion=ZYX+30%C2%B0+90%C2%B0+10%C2%B0");
  const fact = page.locator(".fact-euler");
  await expect(fact).toContainText(
    "the first and third axes coincide, only yaw − roll = 20° is determined, and roll is set to 0",
  );
  const select = page.getByRole("combobox", { name: "Euler axes" });
  await tabTo(page, select);
  await page.keyboard.type("z-x-z");
  await expect(fact).not.toContainText("Gimbal lock");
  // Rz(20°) Ry(90°) = Rz(110°) Rx(90°) Rz(−90°).
  const angles = async () => (await textsOf(page.locator(".euler-angles dd"))).map(numberOf);
  await expect.poll(angles).toEqual([110, 90, -90]);
  await page.getByRole("combobox", { name: "Intrinsic or extrinsic" }).selectOption("extrinsic");
  await expect.poll(angles).toEqual([-90, 90, 110]);
  await expect(page).toHaveURL(/euler=zxz/);
});

test("an address restores axes, matrix and sequence", async ({ page }) => {
  const address =
    "/#read?order=scalar-last&handedness=left&function=active&perturbation=global&matrix=active&rows=world-to-body&euler=zyz";
  await page.goto(address);
  const declared = page.getByRole("region", { name: "Your convention" });
  await expect(declared).toContainText("scalar last, left, active, body to world, global");
  await expect(declared.locator(".strip dt")).toHaveText(["x", "y", "z", "w"]);
  await expect(page.getByRole("combobox", { name: "Euler axes" })).toHaveValue("zyz");
  await page.locator(".more > summary").click();
  const matrixFunction = page.getByRole("radiogroup", { name: "Function of the matrix" });
  await expect(matrixFunction.getByRole("radio", { name: "active" })).toBeChecked();
});

test("the numbers of a preset in another order are shown, copied and told as declared", async ({
  page,
  context,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("/#read?order=scalar-last&quaternion=0+0.6+0+-0.9");
  const declared = page.getByRole("region", { name: "Hamilton as Eigen and ROS store it" });
  await expect(declared.locator(".strip dt")).toHaveText(["x", "y", "z", "w"]);
  await expect(page.locator(".badge")).toHaveCount(1);
  await expect(declared.locator(".badge")).toHaveText("as declared");
  await expect(page).toHaveTitle(/Hamilton \(x y z w\) 0 0\.6 0 −0\.9/);
  await page.keyboard.press("c");
  await expect
    .poll(() => page.evaluate(() => navigator.clipboard.readText()))
    .toBe("[0, 0.6, 0, -0.9]");
  await page.goto("/#compose?as=jpl&order=scalar-first&p=0.5+0.5+0.5+0.5&q=0.1+0.2+0.3+0.9");
  const product = page.locator(".product").filter({ hasText: "as declared" });
  await expect(product.locator(".strip dt")).toHaveText(["w", "x", "y", "z"]);
});

test("Compose takes other descriptions and other conventions", async ({ page }) => {
  await page.goto("/#compose?p=90%C2%B0+about+z&q=90%C2%B0+about+x&direction=world-to-body");
  await expect(page.locator(".read-as").first()).toContainText("90° about z");
  // Right, passive, world to body: p ⊙ q leads from the world over B to B′.
  const road = page.locator(".road");
  await expect(road.locator("h2")).toHaveText("p ⊙ q: first q, then p");
  await expect(road.locator(".road-frame").first()).toHaveText("v on the axes of W");
  // JPL of Yoosefian's eq. 18: (1 + 2i + 3j + 4k) ⊗ (1 + i) = −1 + 3i − j + 7k.
  await page.goto("/#compose?as=jpl&direction=body-to-world&p=1+%2B+2i+%2B+3j+%2B+4k&q=1+%2B+i");
  await expect(road.locator("h2")).toHaveText("p ⊗ q: first q, then p");
  const declared = page.getByRole("region", { name: "JPL of Yoosefian 2021, eq. 18: p ⊗ q" });
  await expect(declared.locator(".strip dd")).toHaveText(["3", "−1", "7", "−1"]);
  await expect(declared.locator(".badge")).toHaveText("as declared");
  await expect(road).toContainText("In JPL of Yoosefian 2021, eq. 18, body → world");
  await expect(page.getByRole("status")).toContainText("x 3, y −1, z 7, w −1");
});

for (const fragment of [
  "quaternion=ZYX+30+90+10",
  "handedness=left&quaternion=1+0+0+0+0+-1+0+1+0",
]) {
  for (const colorScheme of ["light", "dark"] as const) {
    test(`no accessibility violation: ${colorScheme}, ${fragment}`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.goto(`/#read?${fragment}`);
      expect(await violationsOf(page)).toEqual([]);
    });
  }
}

test("nothing is wider than a phone with everything open, whatever its letters", async ({
  page,
}) => {
  await haveNoLetters(page);
  await page.setViewportSize({ width: 320, height: 740 });
  await page.goto("/#read?handedness=left&quaternion=ZYX+30+90+10&digits=all");
  for (const summary of await page.locator("summary").all()) await summary.click();
  const excess = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(excess).toBeLessThanOrEqual(0);
});
