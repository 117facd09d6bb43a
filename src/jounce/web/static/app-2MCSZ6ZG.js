import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-AOWZN6ZW.js");await import("./main-3V3WEABI.js");
