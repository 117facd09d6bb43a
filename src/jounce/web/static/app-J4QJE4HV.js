import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-7W446T4S.js");await import("./main-P2KAFLFV.js");
