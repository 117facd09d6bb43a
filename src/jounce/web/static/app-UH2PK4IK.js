import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-UGXELDM7.js");await import("./main-DXLNJBDW.js");
