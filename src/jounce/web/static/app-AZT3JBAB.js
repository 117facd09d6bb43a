import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-TCLNZAXR.js");await import("./main-GH4H4LMR.js");
