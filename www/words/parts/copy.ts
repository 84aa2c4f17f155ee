// The words of the copy button and its menu.
import type { Format } from "../../model/copy_formats.ts";

/** What the formats are called, in the menu and in `copied as …`. */
export const formatNames: Record<Format, string> = {
  numbers: "Numbers",
  eigen: "C++, Eigen",
  scipy: "Python, SciPy",
  numpy: "Python, NumPy",
  ros: "ROS YAML",
  nalgebra: "Rust, nalgebra",
  javascript: "JavaScript",
  three: "three.js",
  matlab: "MATLAB",
  latex: "LaTeX",
  json: "JSON",
  "test-vector": "Test vector",
};

export const copyWords = {
  copy: (of: string, format: Format) =>
    format === "numbers" ? `Copy ${of}` : `Copy ${of} as ${formatNames[format]}`,
  copied: (of: string, format: Format) =>
    format === "numbers" ? `${of} copied` : `${of} copied as ${formatNames[format]}`,
  notAllowed: (of: string) => `${of} not copied: the browser does not allow it`,
  /** On the button whose line of code is seen. */
  as: (format: Format) => `Copy · ${formatNames[format]}`,
  /** Opens the formats from the button. */
  formatsKey: "ArrowDown",
  choose: (of: string) => `Formats of ${of}`,
  menu: (of: string) => `Copy ${of} as`,
};
