import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-UFB3BZDL.js");await import("./main-QBSLLCFR.js");
