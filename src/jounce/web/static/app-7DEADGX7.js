import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-PKBPKQMO.js");await import("./main-IJSQF5JB.js");
