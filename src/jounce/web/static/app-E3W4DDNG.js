import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-2ZAR4B4H.js");await import("./main-QBSLLCFR.js");
