import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-Y6XQPMBK.js");await import("./main-O42JEZWW.js");
