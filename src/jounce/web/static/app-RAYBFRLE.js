import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-DDXCY3OG.js");await import("./main-7HCSEZDK.js");
