/** The shipped rigs and vehicles: each with its drawing, which is asked for once it is seen, and its kind. */

import { make, whenLeft } from "../page";
import { isGerman, tr } from "../words";
import * as api from "./api";

const drawings = new Map<string, Promise<string>>();

/** Address of the picture of a shipped rig, made once. */
function drawing(name: string): Promise<string> {
  let address = drawings.get(name);
  if (!address) {
    address = api
      .asked("GET", `/api/drawing?${api.query({ name })}`, undefined, "image/svg+xml")
      .then((answer) => answer.blob())
      .then((picture) => URL.createObjectURL(picture));
    drawings.set(name, address);
    address.catch(() => drawings.delete(name));
  }
  return address;
}

const KINDS: Record<string, string> = {
  mcpherson: "McPherson",
  "half-car-4dof": "half car, 4 degrees of freedom",
  "full-car-3d": "full car, 3-D",
};
/** What a rig or vehicle is, in words. */
export const kindOf = ({ model }: api.Shipped): string =>
  isGerman
    ? tr(`model: ${model}`).replace(/^model: /, "")
    : (KINDS[model] ?? model.replaceAll("-", " "));

/** Cards of shipped rigs, each with its own links or buttons. */
export function gallery(
  rigs: api.Shipped[],
  actions: (shipped: api.Shipped) => Node[],
): HTMLElement {
  const seen = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        const picture = target as HTMLImageElement;
        if (!isIntersecting) continue;
        seen.unobserve(picture);
        drawing(picture.dataset.rig!).then(
          (address) => {
            picture.src = address;
          },
          () => picture.classList.add("missing"), // its name and kind tell what it is
        );
      }
    },
    { rootMargin: "200px" },
  );
  whenLeft(() => seen.disconnect());
  return make(
    "ul",
    { class: "gallery" },
    ...rigs.map((rig) => {
      const picture = make("img", { alt: "", width: "160", height: "110", "data-rig": rig.name });
      seen.observe(picture);
      return make(
        "li",
        { title: rig.source },
        picture,
        make("b", {}, rig.name),
        make("span", { class: "muted" }, kindOf(rig)),
        make("span", { class: "links" }, ...actions(rig)),
      );
    }),
  );
}
