import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-O3LSSASB.js");await import("./main-7GNVUG2Z.js");
