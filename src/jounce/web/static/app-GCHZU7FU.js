import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-DJNGMN3W.js");await import("./main-5U55RO35.js");
