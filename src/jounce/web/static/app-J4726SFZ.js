import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-EQQFDMCH.js");await import("./main-3OEDTONL.js");
