import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-3YOGYDG4.js");await import("./main-MYOCKNSU.js");
