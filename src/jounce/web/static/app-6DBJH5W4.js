import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-3S6LGT5L.js");await import("./main-MSZPS7QG.js");
