import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-Y6Q4R2BZ.js");await import("./main-LZEDYIA7.js");
