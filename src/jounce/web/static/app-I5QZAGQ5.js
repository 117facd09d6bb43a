import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-PD7TBB2R.js");await import("./main-52SS2B7T.js");
