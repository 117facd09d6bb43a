import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-77S2JQVA.js");await import("./main-BM76EXN6.js");
