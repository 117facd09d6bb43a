import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-KP25TFWE.js");await import("./main-UEYAX6K4.js");
