import{a as e}from"./chunk-CKZ2Q74R.js";import"./chunk-FYQXRTBU.js";e==="de"&&await import("./german-KV37K4ZK.js");await import("./main-5CEALV6H.js");
