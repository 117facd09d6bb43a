import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-WIX6TUAY.js");await import("./main-RGUQXSIV.js");
