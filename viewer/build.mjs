// Bundles the viewer of reports and the page of the workbench, each into one script and one style sheet.
// node build.mjs [FOLDER]: into FOLDER/viewer and FOLDER/static, or where the package has them.
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2]
  ? resolve(process.argv[2], "viewer")
  : join(here, "../src/jounce/report/viewer");
const page = process.argv[2]
  ? resolve(process.argv[2], "static")
  : join(here, "../src/jounce/web/static");
for (const folder of [out, page]) mkdirSync(folder, { recursive: true });

const bundled = (entryPoints, outdir) =>
  build({
    absWorkingDir: here,
    entryPoints,
    bundle: true,
    minify: true,
    format: "iife",
    globalName: "jounce",
    target: ["es2022"],
    charset: "utf8",
    legalComments: "none", // licences.txt has them whole
    outdir,
    write: false,
    metafile: true,
    define: { "process.env.NODE_ENV": '"production"' },
  });

const result = await bundled({ viewer: "src/main.ts", page: "src/plain.ts" }, out);
const app = await bundled({ app: "src/workbench/main.ts" }, page);
for (const name of ["index.html", "icon.svg"])
  copyFileSync(join(here, "src/workbench", name), join(page, name));
for (const file of app.outputFiles) writeFileSync(file.path, file.text);
for (const file of result.outputFiles) {
  if (/<\/(script|style)/i.test(file.text))
    throw new Error(`${file.path} would end the element that it stands in`);
  writeFileSync(file.path, file.text);
}

const packages = [
  ...new Set(
    Object.keys(result.metafile.inputs)
      .filter((path) => path.startsWith("node_modules/"))
      .map((path) =>
        path
          .split("/")
          .slice(1, path.split("/")[1].startsWith("@") ? 3 : 2)
          .join("/"),
      ),
  ),
].sort();
const licences = packages.map((name) => {
  const { version, license } = JSON.parse(
    readFileSync(join(here, "node_modules", name, "package.json"), "utf8"),
  );
  const text = readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim();
  return `${name} ${version} (${license})\n\n${text}\n`;
});
writeFileSync(join(out, "licences.txt"), licences.join(`\n${"-".repeat(80)}\n\n`));

// What the bundle was made of: without node, too, a test sees an edit that was not bundled.
const sources = [
  "build.mjs",
  "package.json",
  "package-lock.json",
  "tsconfig.json",
  ...readdirSync(join(here, "src"), { recursive: true, withFileTypes: true })
    .filter((one) => one.isFile())
    .map((one) => relative(here, join(one.parentPath, one.name)).replaceAll("\\", "/"))
    .sort(),
];
const sum = createHash("sha256");
for (const name of sources) {
  sum.update(`${name}\0`);
  sum.update(readFileSync(join(here, name), "utf8").replaceAll("\r\n", "\n"));
}
writeFileSync(join(out, "sources.sha256"), `${sum.digest("hex")}\n`);
console.log(
  [...result.outputFiles, ...app.outputFiles]
    .map((file) => `${file.path.split("/").pop()} ${file.contents.length}`)
    .join(", "),
);
