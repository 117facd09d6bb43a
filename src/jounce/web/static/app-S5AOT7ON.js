import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-62GK65PI.js");await import("./main-YFFD4RBS.js");
