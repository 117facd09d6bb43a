import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-WGRJ24PP.js");await import("./main-5B7C7WEQ.js");
