import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-BX673MTI.js");await import("./main-6PFPRY6B.js");
