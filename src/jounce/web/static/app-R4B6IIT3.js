import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-L6QD7JQM.js");await import("./main-CQP4OKTL.js");
