// Bundles the viewer of reports into one script and one style sheet, and the workbench into scripts that are loaded
// when their page is opened; the names of the latter contain their digest, so that browsers keep them.
// node build.mjs [FOLDER]: into FOLDER/viewer and FOLDER/static, or where the package has them.
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2]
  ? resolve(process.argv[2], "viewer")
  : join(here, "../src/jounce/report/viewer");
const page = process.argv[2]
  ? resolve(process.argv[2], "static")
  : join(here, "../src/jounce/web/static");
rmSync(page, { recursive: true, force: true }); // scripts of earlier builds
for (const folder of [out, page]) mkdirSync(folder, { recursive: true });

/** Styles of a report's blocks, for the part of the workbench that shows a report. */
const reported = {
  name: "reported",
  setup: ({ onLoad }) =>
    onLoad({ filter: /templates.blocks\.css$/ }, ({ path }) => ({
      contents: `.reported {\n${readFileSync(path, "utf8")}}`,
      loader: "css",
    })),
};
const bundled = (entryPoints, outdir, options) =>
  build({
    absWorkingDir: here,
    entryPoints,
    bundle: true,
    minify: true,
    target: ["es2022"],
    plugins: [reported],
    charset: "utf8",
    legalComments: "none", // licences.txt has them whole
    outdir,
    write: false,
    metafile: true,
    define: { "process.env.NODE_ENV": '"production"' },
    ...options,
  });

const result = await bundled({ viewer: "src/main.ts", page: "src/plain.ts" }, out, {
  format: "iife",
  globalName: "jounce",
});
const app = await bundled({ app: "src/workbench/start.ts" }, page, {
  format: "esm",
  splitting: true,
  entryNames: "[name]-[hash]",
  chunkNames: "[name]-[hash]",
  target: ["es2022", "chrome111", "firefox110", "safari16.4"], // their style sheets have no nested rules
});
for (const file of app.outputFiles) writeFileSync(file.path, file.text);
const html = readFileSync(join(here, "src/workbench/index.html"), "utf8").replace(
  /\/app\.(css|js)/g,
  (_, kind) =>
    `/${app.outputFiles.map(({ path }) => basename(path)).find((name) => name.startsWith("app-") && name.endsWith(kind))}`,
);
writeFileSync(join(page, "index.html"), html);
copyFileSync(join(here, "src/workbench/icon.svg"), join(page, "icon.svg"));
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
  ...["blocks", "chart", "colours"].map((name) => `../src/jounce/report/templates/${name}.css`),
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
