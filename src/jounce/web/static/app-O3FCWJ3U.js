import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-O3LSSASB.js");await import("./main-RKOQYNCH.js");
