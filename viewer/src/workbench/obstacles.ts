/** Single obstacles that pages offer, with their sizes. */

export const OBSTACLES: Record<string, string[]> = {
  "half-sine": ["height", "length"],
  versine: ["height", "length"],
  rectangle: ["height", "length"],
  triangle: ["height", "length"],
  step: ["height"],
  pothole: ["depth", "length"],
};
export const USUAL: Record<string, string> = { height: "10 mm", depth: "10 mm", length: "60 mm" };
