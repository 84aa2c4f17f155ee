// Fragments of an address as an attacker, a broken mailer or a careless script would write them.
import { axes } from "../../../www/model/conventions.ts";

/** Texts with markup, addresses, handlers and words of other languages, to be put into any parameter. */
export const hostileTexts = [
  "<script>document.title='run'</script>",
  "</textarea><script>document.title='run'</script>",
  "<img src=x onerror=\"document.title='run'\">",
  "<svg onload=\"document.title='run'\"></svg>",
  "<iframe srcdoc=\"<script>parent.document.title='run'</script>\"></iframe>",
  "javascript:document.title='run'",
  '"><a href="javascript:document.title=\'run\'" autofocus onfocus="document.title=\'run\'">',
  "{{constructor.constructor('document.title=`run`')()}}",
  // biome-ignore lint/suspicious/noTemplateCurlyInString: the text is to look like a template.
  "${document.title='run'}",
  "'; DROP TABLE rotations; --",
  "../../../../etc/passwd",
  "__proto__",
  "constructor(1,2,3,4)",
  "\u0000\u0001\u0007\u001b[31m\u007f",
  "\u202e1 0 0 0\u202c\u2066\u200f\u200b\ufeff",
  "🙂👩‍👩‍👧‍👦 e\u0301\u0301\u0301\u0301 ﷽",
  "1\u2028 0\u2029 0 0",
  "1e999 -1e999 1e-999 5e-324",
  "NaN Infinity -Infinity undefined",
  "-0 -0 -0 -0",
  "1/0 0/0 (-1)^(1/2) sqrt(-1)",
  "9".repeat(400),
  "2^2^2^2^2^2^2^2",
];

const textParameters = [
  ...["read?quaternion", "read?vector", "compose?p", "compose?q"],
  ...["translate?translated", "translate?world", "translate?body"],
  ...["identify?name", "libraries?find"],
];

/** Names that every object has, and names of other things. */
const inheritedNames = ["__proto__", "constructor", "hasOwnProperty", "toString", "<b>", ""];
const choices = [
  ...axes,
  ...["as", "matrix", "rows", "euler", "digits", "unit", "from", "to", "language", "unavailable"],
  ...["library", "probe", "__proto__", "constructor.prototype", "version", "v"],
];

const brokenEncodings = [
  ...["%", "%%", "%E0%A4%A", "%ED%A0%80", "%C0%AF", "%FF%FE", "%00", "%u0041", "%0D%0A"],
  ...["+", "&&&=&=", "?", "??", "#", "=", "&quaternion", "quaternion==1", "%26%3D%23"],
];

const many = (times: number, text: string) => Array.from({ length: times }, () => text).join("&");

const oversized = [
  `read?quaternion=${"1+".repeat(50_000)}1`,
  `read?quaternion=${"(".repeat(50_000)}`,
  `read?quaternion=${"[".repeat(3000)}1 0 0 0${"]".repeat(3000)}`,
  `read?quaternion=${"sqrt(".repeat(3000)}2${")".repeat(3000)}`,
  `read?quaternion=${"-".repeat(30_000)}1 0 0 0`,
  `read?quaternion=${"1/".repeat(20_000)}1`,
  `read?quaternion=${"2^".repeat(20_000)}2`,
  `read?quaternion=${"x: 1\n".repeat(10_000)}`,
  `read?quaternion=${'{"w":'.repeat(5000)}`,
  `read?quaternion=${"a".repeat(100_000)}(1,2,3,4)`,
  `read?quaternion=${"🙂".repeat(10_000)}`,
  `read?vector=${"0 ".repeat(50_000)}`,
  `compose?p=${"1 0 0 0 ".repeat(12_500)}&q=${"e\u0301".repeat(20_000)}`,
  `translate?translated=${"<b>".repeat(20_000)}&world=${"x".repeat(20_000)}`,
  `identify?name=${"<".repeat(50_000)}`,
  `identify?${many(5000, "probe=product;1;2;3")}`,
  `identify?probe=product;${"(".repeat(20_000)};${"9".repeat(20_000)};oops`,
  `identify?probe=${";".repeat(50_000)}&probe=${"~".repeat(50_000)}`,
  `libraries?find=${"a ".repeat(50_000)}`,
  `read?${many(5000, "quaternion=1+0+0+0")}`,
  `read?${many(5000, "order=scalar-last&order=neither")}`,
];

const contradictory = [
  "read?quaternion=1+0+0+0&quaternion=<script>&as=jpl&as=hamilton&digits=all&digits=4",
  "identify?probe=&probe=&probe=product",
  "identify?probe=matrix;i;1;__proto__&probe=constructor;1;2",
  "translate?from=:jpl&from=eigen&to=eigen~eigen~scalar-first~scalar-last",
  "translate?from=:scalar-last,left,passive,world-to-body,local,more&to=:,,,,",
  "translate?from=eigen~constructor~__proto__&to=~~~~",
  "libraries?library=__proto__&find=[.*+?^(",
  "compose?p=0+0+0+0&q=0&vector=",
];

const encoded = (text: string) => encodeURIComponent(text);

/** Two hundred and more, each with the view that is to open. */
export const hostileFragments: readonly { fragment: string; view: string }[] = [
  ...hostileTexts.flatMap((text) => [
    ...textParameters.map((parameter) => `${parameter}=${encoded(text)}`),
    `identify?probe=product;${encoded(text)};1;2&probe=${encoded(text)}`,
    encoded(text),
  ]),
  ...choices.flatMap((choice) => inheritedNames.map((name) => `read?${choice}=${encoded(name)}`)),
  ...inheritedNames.map((name) => `${encoded(name)}?quaternion=1+0+0+0`),
  ...brokenEncodings.flatMap((text) => [text, `read?${text}`, `compose?p=${text}&q=${text}`]),
  ...oversized,
  ...contradictory,
].map((fragment) => ({
  fragment,
  view: /^(compose|translate|identify|libraries)\?/.exec(fragment)?.[1] ?? "read",
}));
