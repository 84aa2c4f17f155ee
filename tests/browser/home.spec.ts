// The addresses of the site and of the repository: what needs one is there where it is set, and left
// out where it is not.
import { repositoryLinks } from "../../www/model/repository.ts";
import { headOf, homeOf, homeOfBuild } from "../../www/tasks/home.ts";
import { expect, test } from "./support/page.ts";

const site = "https://example.org/quatlas/";
const repository = "https://example.org/code/quatlas";

test("the addresses are those of the environment, or of package.json, or none", () => {
  expect(homeOf({}, {})).toEqual({ site: undefined, repository: undefined });
  const manifest = {
    homepage: "https://example.org/quatlas",
    repository: { url: "git+https://example.org/code/quatlas.git" },
  };
  expect(homeOf({}, manifest)).toEqual({ site, repository });
  expect(homeOf({}, { repository })).toEqual({ site: undefined, repository });
  const environment = {
    QUATLAS_SITE: "https://example.net",
    QUATLAS_REPOSITORY: "https://example.net/code/",
  };
  expect(homeOf(environment, manifest)).toEqual({
    site: "https://example.net/",
    repository: "https://example.net/code",
  });
  // What is no address of the web is none.
  for (const text of ["", "github:some/one", "javascript:alert(1)", "https://"]) {
    const none = homeOf({ QUATLAS_SITE: text, QUATLAS_REPOSITORY: text }, {});
    expect(none, text).toEqual({ site: undefined, repository: undefined });
  }
});

test("the head and the foot say an address where there is one", () => {
  expect(headOf({ site: undefined, repository })).toEqual([]);
  expect(headOf({ site, repository: undefined })).toEqual([
    { tag: "link", attrs: { rel: "canonical", href: site } },
    { tag: "meta", attrs: { property: "og:url", content: site } },
    { tag: "meta", attrs: { property: "og:image", content: `${site}icon_512.png` } },
  ]);
  expect(repositoryLinks(undefined)).toEqual([]);
  expect(repositoryLinks(repository).map(({ href }) => href)).toEqual([
    repository,
    `${repository}/issues`,
  ]);
});

test("the built page has the addresses of its build, and what it says of itself names no case", async ({
  page,
}) => {
  const addresses = homeOfBuild();
  await page.goto("/#read?quaternion=1+0+0+0");
  const content = (property: string) =>
    page.locator(`meta[property="${property}"]`).getAttribute("content");
  expect(await content("og:type")).toBe("website");
  expect(await content("og:title")).toBe("quatlas: one rotation, every convention");
  expect(await content("og:description")).toMatch(/^Type a quaternion/);
  const ofSite = page.locator('[rel=canonical], [property="og:url"], [property="og:image"]');
  await expect(ofSite).toHaveCount(headOf(addresses).length);
  const links = page.getByRole("contentinfo").getByRole("link");
  const names =
    repositoryLinks(addresses.repository).length > 0 ? ["Source", "Report a problem"] : [];
  await expect(links).toHaveText([...names, "Licences"]);
});
