import{a as e}from"./chunk-HPP44AMD.js";import"./chunk-M433OT7A.js";e==="de"&&await import("./german-AUO7UHDB.js");await import("./main-S63ONK7H.js");
