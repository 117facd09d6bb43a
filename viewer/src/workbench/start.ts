/** First script of the workbench: it stores the token, and sets the language before any other module reads it. */

import "./token";
import { language } from "./language";
import "uplot/dist/uPlot.min.css";
import "../../../src/jounce/report/templates/blocks.css";
import "../../../src/jounce/report/templates/chart.css";
import "../../../src/jounce/report/templates/colours.css";
import "../viewer.css";
import "./workbench.css";
import "./work.css";
import "./data.css";

if (language === "de") await import("./german");
await import("./main");
