import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-ES2I6WDT.js");await import("./main-OI4XD64J.js");
