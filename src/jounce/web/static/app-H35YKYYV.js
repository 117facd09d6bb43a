import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-HOPI2ESJ.js");await import("./main-EZJLDOE4.js");
