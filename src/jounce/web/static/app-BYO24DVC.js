import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-6RGJG2HE.js");await import("./main-5CEALV6H.js");
