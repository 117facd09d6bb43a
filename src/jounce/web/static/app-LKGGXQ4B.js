import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-ELJJPRM3.js");await import("./main-AXJU2X6K.js");
