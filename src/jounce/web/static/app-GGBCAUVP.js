import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-DI2FHTSF.js");await import("./main-P2KAFLFV.js");
