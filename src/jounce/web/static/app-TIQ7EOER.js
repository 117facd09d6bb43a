import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-L3ZSPU7H.js");await import("./main-NQ7VCT22.js");
