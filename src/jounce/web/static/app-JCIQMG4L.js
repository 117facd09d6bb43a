import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-QNQCQ7RY.js");await import("./main-VE3ACMJK.js");
