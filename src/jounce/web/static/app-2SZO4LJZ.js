import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-YY25O3MU.js");await import("./main-FUIDJ5H4.js");
