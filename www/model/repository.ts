// The links to the repository of quatlas.

export type RepositoryLink = "source" | "report";

/** None where the build knows no address of it. */
export function repositoryLinks(
  repository: string | undefined,
): { name: RepositoryLink; href: string }[] {
  if (repository === undefined) return [];
  return [
    { name: "source", href: repository },
    { name: "report", href: `${repository}/issues` },
  ];
}
