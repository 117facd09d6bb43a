import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-YFSN2FCM.js");await import("./main-GCOLVI5D.js");
