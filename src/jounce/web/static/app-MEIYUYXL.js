import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-T6R4VQQB.js");await import("./main-NL7IMFCW.js");
