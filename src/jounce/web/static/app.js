"use strict";var jounce=(()=>{var ru=Object.defineProperty;var l_=Object.getOwnPropertyDescriptor;var c_=Object.getOwnPropertyNames;var h_=Object.prototype.hasOwnProperty;var u_=(i,e)=>{for(var t in e)ru(i,t,{get:e[t],enumerable:!0})},d_=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of c_(e))!h_.call(i,s)&&s!==t&&ru(i,s,{get:()=>e[s],enumerable:!(n=l_(e,s))||n.enumerable});return i};var f_=i=>d_(ru({},"__esModule",{value:!0}),i);var f1={};u_(f1,{live:()=>mf});var p_={light:"Light",dark:"Dark",showLight:"Show this page light",showDark:"Show this page dark",failed:"The interactive plots could not be made (#); the figures of this page show the same.",choice:"what is shown",previous:"previous ([)",next:"next (])",curves:"curves",channels:"channels",more:"# more",otherChannels:"all other channels",zoomIn:"zoom in (+)",zoomOut:"zoom out (−)",all:"All",everything:"everything (0, or double click)",event:"Event",zoomToEvent:"zoom to the event (9)",wide:"Full window",fillWindow:"fill the window (f)",play:"Play",pause:"Pause",speed:"speed",realTime:"real time",fast:"fast",hint:"Drag to zoom, double click for everything; Ctrl + wheel zooms, Shift + wheel pans. Keys: space plays, ← → step, + − 0 zoom, [ ] change what is shown, f fills the window.",view:"view",space:"3-D",front:"front",side:"side",top:"top",wheel:"wheel",names:"names",paths:"paths",mechanism:"The mechanism; drag to turn it, click on it to zoom with the wheel",noContact:"no contact",noWebGL:"The mechanism is drawn with WebGL, which this browser does not offer.",strut:"spring and damper",contactPoint:"contact point"},m_={light:"Hell",dark:"Dunkel",showLight:"Seite hell darstellen",showDark:"Seite dunkel darstellen",failed:"Die interaktiven Diagramme konnten nicht erstellt werden (#); die Abbildungen der Seite zeigen dasselbe.",choice:"Auswahl",previous:"zurück ([)",next:"weiter (])",curves:"Kurven",channels:"Kanäle",more:"# weitere",otherChannels:"alle weiteren Kanäle",zoomIn:"vergrößern (+)",zoomOut:"verkleinern (−)",all:"Alles",everything:"gesamter Bereich (0 oder Doppelklick)",event:"Ereignis",zoomToEvent:"auf das Ereignis zoomen (9)",wide:"Großansicht",fillWindow:"ganzes Fenster nutzen (f)",play:"Abspielen",pause:"Pause",speed:"Tempo",realTime:"Echtzeit",fast:"schnell",hint:"Bereich aufziehen zum Zoomen, Doppelklick zeigt alles; Strg + Mausrad zoomt, Umschalt + Mausrad verschiebt. Tasten: Leertaste spielt ab, ← → Einzelschritt, + − 0 Zoom, [ ] wechselt die Auswahl, f Großansicht.",view:"Ansicht",space:"3-D",front:"vorn",side:"Seite",top:"oben",wheel:"Rad",names:"Namen",paths:"Bahnkurven",mechanism:"Die Radaufhängung; ziehen dreht sie, nach einem Klick zoomt das Mausrad",noContact:"kein Bodenkontakt",noWebGL:"Die Radaufhängung wird mit WebGL gezeichnet, das dieser Browser nicht anbietet.",strut:"Feder und Dämpfer",contactPoint:"Radaufstandspunkt"},au=document.documentElement.lang.startsWith("de"),g_=au?m_:p_;function bt(i,e=""){return g_[i].replace("#",()=>e)}function cs(i){let e=i.replaceAll("-","−");return au?e.replace(".",","):e}var __={};function re(i,e=""){return(au&&__[i]||i).replace("#",()=>e)}function p(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))typeof r=="function"?n.addEventListener(s,r):typeof r=="boolean"?n.toggleAttribute(s,r):n.setAttribute(s,r);return n.append(...t),n}function Ci(i,e,t,n=""){let s=p("button",{type:"button","aria-pressed":String(e),title:n},i);return s.addEventListener("click",()=>{let r=s.getAttribute("aria-pressed")!=="true";s.setAttribute("aria-pressed",String(r)),t(r)}),s}function De(i,e=4){if(i==null||Number.isNaN(i))return"–";if(!Number.isFinite(i))return i>0?"∞":"−∞";if(i===0)return"0";let[t,n]=i.toExponential(e-1).split("e"),s=Number(n),r=s<-4||s>5?`${t}e${s}`:i.toFixed(Math.max(0,e-1-s));return cs(r)}function zf(i,e){if(!Number.isFinite(i)||!(e>0))return De(i);let t=Math.min(Math.max(0,Math.ceil(-Math.log10(e))),100),n=Number(i.toFixed(t));return n===0?"0":De(n)}function Tt(i){return getComputedStyle(document.documentElement).getPropertyValue(`--${i}`).trim()||"#888"}var ou=null;function Ka(){if(ou===null){let i=document.createElement("canvas").getContext("webgl2",{failIfMajorPerformanceCaveat:!0}),e=i?.getExtension("WEBGL_debug_renderer_info"),t=e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";ou=i!==null&&!/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t),i?.getExtension("WEBGL_lose_context")?.loseContext()}return ou}var Vf=new Set;function Ri(i){Vf.add(i)}function Bf(){for(let i of Vf)i()}function Gf(){let i=matchMedia("(prefers-color-scheme: dark)"),e=document.documentElement,t=()=>e.dataset.theme?e.dataset.theme==="dark":i.matches,n=p("button",{type:"button",class:"theme"}),s=()=>{n.textContent=bt(t()?"light":"dark"),n.title=bt(t()?"showLight":"showDark")};return n.addEventListener("click",()=>{e.dataset.theme=t()?"light":"dark",s(),Bf()}),i.addEventListener("change",()=>{s(),Bf()}),s(),n}async function Kn(i,e,t,n="application/json"){let s=t===void 0?{}:{body:JSON.stringify(t),headers:{"Content-Type":"application/json",Accept:n}},r;try{r=await fetch(e,{method:i,...s})}catch{throw new Error("The server does not answer: start it again with jounce serve.")}if(r.ok)return r;if(r.status===401)throw new Error("This page is not known here any more: open the address that jounce serve printed.");let a=await r.json().catch(()=>null);throw new Error(a?.error?.text??a?.detail?.map(o=>`${o.loc.slice(1).join(".")}: ${o.msg}`).join("; ")??r.statusText)}var Yi=i=>new URLSearchParams(i).toString(),Un=async i=>(await Kn("GET",i)).json(),xi=()=>Un("/api/project"),Os=()=>Un("/api/library"),$r=i=>Un(`/api/file?${Yi({path:i})}`),Hf=i=>Un(`/api/versions?${Yi({path:i})}`),Wf=i=>Un(`/api/check?${Yi({path:i})}`),Fs=i=>Un(`/api/rig?${Yi({name:i})}`),Xf=async(i,e)=>(await Kn("POST","/api/library",{name:i,path:e})).json(),or=async(i,e,t)=>(await Kn("PUT","/api/file",{path:i,text:e,was:t})).json(),lu=new Map;function $f(i){let e=lu.get(i);return e||(e=Un(`/api/schema?${Yi({model:i})}`),lu.set(i,e),e.catch(()=>lu.delete(i))),e}var Zi=async(i,e,t,n)=>(await Kn("POST","/api/form",{path:i,text:e,sets:t,changes:n})).json(),qr=async(i,e)=>(await Kn("POST",`/api/${i}`,e,"application/octet-stream")).arrayBuffer();var Ji=class i{constructor(e,t){this.content=e;this.bytes=t}content;bytes;made=[];static async open(e){let t=JSON.parse(e),n=atob(t.packed);t.packed="";let s=new Uint8Array(n.length);for(let a=0;a<n.length;a++)s[a]=n.charCodeAt(a);let r=new Blob([s]).stream().pipeThrough(new DecompressionStream("deflate"));return new i(t,new Uint8Array(await new Response(r).arrayBuffer()))}static of(e){let t=new DataView(e).getUint32(0,!0),n=4+t,s=JSON.parse(new TextDecoder().decode(new Uint8Array(e,4,t))),r=new i(s,new Uint8Array(0));s.arrays.forEach(({n:o,at:l},c)=>{let h=new Float64Array(e,n+l,o);r.made[c]=h.some(Number.isNaN)?Array.from(h,d=>Number.isNaN(d)?null:d):h});let a=o=>{let l=new Float64Array(e,n+s.arrays[o].at,s.arrays[o].n);return Array.from({length:l.length/3},(c,h)=>l.subarray(3*h,3*h+3))};for(let o of s.mechanisms){let{points:l,spin:c,contact:h}=o;Object.assign(o,{points:l.map(a),spin:a(c),contact:a(h)})}return r}step(e){let{even:t,step:n}=this.content.arrays[e];return t||!n?0:n}get(e){return this.made[e]??=v_(this.content.arrays[e],this.bytes)}},qf=65535;function v_(i,e){let{n:t,at:n,order:s,low:r,step:a,even:o}=i;if(o)return Float64Array.from({length:t},(u,f)=>o[0]+f*o[1]);let l=new Float64Array(t),c=0,h=0,d=!1;for(let u=0;u<t;u++){let f=e[n+u]|e[n+t+u]<<8;if(s===0)c=f;else{let m=f>>>1^-(f&1);s===1?c=c+m&65535:(h=h+m&65535,c=c+h&65535)}c===qf&&(d=!0),l[u]=c===qf?NaN:r+a*c}return d?Array.from(l,u=>Number.isNaN(u)?null:u):l}function lr(i,e,t){let n=i.length;if(n===0)return NaN;let s=ml(i,t),r=Math.min(s+1,n-1),a=i[s],o=i[r],l=e[s],c=e[r];if(l===null||c===null||l===void 0||c===void 0)return NaN;let h=o>a?Math.min(1,Math.max(0,(t-a)/(o-a))):0;return l+h*(c-l)}function ml(i,e){let t=0,n=i.length-1;for(;n>t;){let s=t+n+1>>1;i[s]<=e?t=s:n=s-1}return t}var Zs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Js={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Ep=0,zu=1,Tp=2;var No=1,Ap=2,va=3,Ks=0,Zn=1,ei=2,_r=0,xa=1,Vu=2,Gu=3,Hu=4,Cp=5;var vr=100,Rp=101,Pp=102,Lp=103,Ip=104,Dp=200,Np=201,Up=202,Op=203,Wu=204,Xu=205,Fp=206,kp=207,Bp=208,zp=209,Vp=210,Gp=211,Hp=212,Wp=213,Xp=214,zl=0,Vl=1,Gl=2,la=3,Hl=4,Wl=5,Xl=6,$l=7,Tc=0,$p=1,qp=2,es=0,$u=1,qu=2,Yu=3,Zu=4,Ju=5,Ku=6,ju=7;var Qu=300,xr=301,ya=302,Ac=303,Cc=304,ql=1e3,ji=1001,Yl=1002,Ln=1003,Yp=1004;var Uo=1005;var $n=1006,Rc=1007;var ws=1008;var ti=1009,ed=1010,td=1011,ba=1012,Pc=1013,Ni=1014,Ui=1015,Oi=1016,Lc=1017,Ic=1018,yr=1020,nd=35902,id=35899,sd=1021,rd=1022,Fi=1023,_s=1026,Es=1027,ad=1028,Dc=1029,js=1030,Nc=1031;var Uc=1033,Oo=33776,Fo=33777,ko=33778,Bo=33779,Oc=35840,Fc=35841,kc=35842,Bc=35843,zc=36196,Vc=37492,Gc=37496,Hc=37488,Wc=37489,zo=37490,Xc=37491,$c=37808,qc=37809,Yc=37810,Zc=37811,Jc=37812,Kc=37813,jc=37814,Qc=37815,eh=37816,th=37817,nh=37818,ih=37819,sh=37820,rh=37821,ah=36492,oh=36494,lh=36495,ch=36283,hh=36284,Vo=36285,uh=36286;var lo=2300,Zl=2301,kl=2302,Du=2303,Nu=2400,Uu=2401,Ou=2402;var Zp=3200;var dh=0,Jp=1,Ts="",ci="srgb",co="srgb-linear",ho="linear",Dt="srgb";var Bl=7680;var Kp=519,jp=512,Qp=513,em=514,od=515,tm=516,nm=517,ld=518,cd=519,im=35044;var hd="300 es",bi=2e3,ca=2001;function x_(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function y_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function uo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function sm(){let i=uo("canvas");return i.style.display="block",i}var Yf={},ha=null;function ud(...i){let e="THREE."+i.shift();ha?ha("log",e,...i):console.log(e,...i)}function rm(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ke(...i){i=rm(i);let e="THREE."+i.shift();if(ha)ha("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function ot(...i){i=rm(i);let e="THREE."+i.shift();if(ha)ha("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function io(...i){let e=i.join(" ");e in Yf||(Yf[e]=!0,Ke(...i))}function am(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var om={[zl]:zl,[Gl]:Xl,[Hl]:Hl,[la]:Wl,[Vl]:Vl,[Xl]:Gl,[$l]:$l,[Wl]:la},Di=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},On=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Zf=1234567,so=Math.PI/180,ua=180/Math.PI;function Sa(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(On[i&255]+On[i>>8&255]+On[i>>16&255]+On[i>>24&255]+"-"+On[e&255]+On[e>>8&255]+"-"+On[e>>16&15|64]+On[e>>24&255]+"-"+On[t&63|128]+On[t>>8&255]+"-"+On[t>>16&255]+On[t>>24&255]+On[n&255]+On[n>>8&255]+On[n>>16&255]+On[n>>24&255]).toLowerCase()}function mt(i,e,t){return Math.max(e,Math.min(t,i))}function dd(i,e){return(i%e+e)%e}function b_(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function S_(i,e,t){return i!==e?(t-i)/(e-i):0}function ro(i,e,t){return(1-t)*i+t*e}function M_(i,e,t,n){return ro(i,e,1-Math.exp(-t*n))}function w_(i,e=1){return e-Math.abs(dd(i,e*2)-e)}function E_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function T_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function A_(i,e){return i+Math.floor(Math.random()*(e-i+1))}function C_(i,e){return i+Math.random()*(e-i)}function R_(i){return i*(.5-Math.random())}function P_(i){i!==void 0&&(Zf=i);let e=Zf+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function L_(i){return i*so}function I_(i){return i*ua}function D_(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function N_(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function fd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function U_(i,e,t,n,s){let r=Math.cos,a=Math.sin,o=r(t/2),l=a(t/2),c=r((e+n)/2),h=a((e+n)/2),d=r((e-n)/2),u=a((e-n)/2),f=r((n-e)/2),m=a((n-e)/2);switch(s){case"XYX":i.set(o*h,l*d,l*u,o*c);break;case"YZY":i.set(l*u,o*h,l*d,o*c);break;case"ZXZ":i.set(l*d,l*u,o*h,o*c);break;case"XZX":i.set(o*h,l*m,l*f,o*c);break;case"YXY":i.set(l*f,o*h,l*m,o*c);break;case"ZYZ":i.set(l*m,l*f,o*h,o*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function pd(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function lm(i,e){if(e.constructor===Float32Array)return i;let t=pd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function cm(i,e){if(e.constructor===Float32Array)return i;let t=pd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var md={DEG2RAD:so,RAD2DEG:ua,generateUUID:Sa,clamp:mt,euclideanModulo:dd,mapLinear:b_,inverseLerp:S_,lerp:ro,damp:M_,pingpong:w_,smoothstep:E_,smootherstep:T_,randInt:A_,randFloat:C_,randFloatSpread:R_,seededRandom:P_,degToRad:L_,radToDeg:I_,isPowerOfTwo:D_,ceilPowerOfTwo:N_,floorPowerOfTwo:fd,setQuaternionFromProperEuler:U_,normalize:cm,denormalize:lm},ze=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(mt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*n-a*s+e.x,this.y=r*s+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},qn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,a,o){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[a+0],f=r[a+1],m=r[a+2],v=r[a+3];if(d!==v||l!==u||c!==f||h!==m){let _=l*u+c*f+h*m+d*v;_<0&&(u=-u,f=-f,m=-m,v=-v,_=-_);let g=1-o;if(_<.9995){let x=Math.acos(_),T=Math.sin(x);g=Math.sin(g*x)/T,o=Math.sin(o*x)/T,l=l*g+u*o,c=c*g+f*o,h=h*g+m*o,d=d*g+v*o}else{l=l*g+u*o,c=c*g+f*o,h=h*g+m*o,d=d*g+v*o;let x=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=x,c*=x,h*=x,d*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,a){let o=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[a],u=r[a+1],f=r[a+2],m=r[a+3];return e[t]=o*m+h*d+l*f-c*u,e[t+1]=l*m+h*u+c*d-o*f,e[t+2]=c*m+h*f+o*u-l*d,e[t+3]=h*m-o*d-l*u-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(s/2),d=o(r/2),u=l(n/2),f=l(s/2),m=l(r/2);switch(a){case"XYZ":this._x=u*h*d+c*f*m,this._y=c*f*d-u*h*m,this._z=c*h*m+u*f*d,this._w=c*h*d-u*f*m;break;case"YXZ":this._x=u*h*d+c*f*m,this._y=c*f*d-u*h*m,this._z=c*h*m-u*f*d,this._w=c*h*d+u*f*m;break;case"ZXY":this._x=u*h*d-c*f*m,this._y=c*f*d+u*h*m,this._z=c*h*m+u*f*d,this._w=c*h*d-u*f*m;break;case"ZYX":this._x=u*h*d-c*f*m,this._y=c*f*d+u*h*m,this._z=c*h*m-u*f*d,this._w=c*h*d+u*f*m;break;case"YZX":this._x=u*h*d+c*f*m,this._y=c*f*d+u*h*m,this._z=c*h*m-u*f*d,this._w=c*h*d-u*f*m;break;case"XZY":this._x=u*h*d-c*f*m,this._y=c*f*d-u*h*m,this._z=c*h*m+u*f*d,this._w=c*h*d+u*f*m;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=n+o+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(a-s)*f}else if(n>o&&n>d){let f=2*Math.sqrt(1+n-o-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+a)/f,this._z=(r+c)/f}else if(o>d){let f=2*Math.sqrt(1+o-n-d);this._w=(r-c)/f,this._x=(s+a)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-n-o);this._w=(a-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(mt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-n*c,this._z=r*h+a*c+n*l-s*o,this._w=a*h-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Jf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Jf.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*n),h=2*(o*t-r*s),d=2*(r*n-a*t);return this.x=t+l*c+a*d-o*h,this.y=n+l*h+o*c-r*d,this.z=s+l*d+r*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return cu.copy(this).projectOnVector(e),this.sub(cu)}reflect(e){return this.sub(cu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(mt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},cu=new V,Jf=new qn,ct=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c)}set(e,t,n,s,r,a,o,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=o,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],m=n[8],v=s[0],_=s[3],g=s[6],x=s[1],T=s[4],S=s[7],R=s[2],w=s[5],y=s[8];return r[0]=a*v+o*x+l*R,r[3]=a*_+o*T+l*w,r[6]=a*g+o*S+l*y,r[1]=c*v+h*x+d*R,r[4]=c*_+h*T+d*w,r[7]=c*g+h*S+d*y,r[2]=u*v+f*x+m*R,r[5]=u*_+f*T+m*w,r[8]=u*g+f*S+m*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-n*r*h+n*o*l+s*r*c-s*a*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=h*a-o*c,u=o*l-h*r,f=c*r-a*l,m=t*d+n*u+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/m;return e[0]=d*v,e[1]=(s*c-h*n)*v,e[2]=(o*n-s*a)*v,e[3]=u*v,e[4]=(h*t-s*l)*v,e[5]=(s*r-o*t)*v,e[6]=f*v,e[7]=(n*l-c*t)*v,e[8]=(a*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return io("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(hu.makeScale(e,t)),this}rotate(e){return io("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(hu.makeRotation(-e)),this}translate(e,t){return io("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(hu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},hu=new ct,Kf=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),jf=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function O_(){let i={enabled:!0,workingColorSpace:co,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Dt&&(s.r=gs(s.r),s.g=gs(s.g),s.b=gs(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Dt&&(s.r=oa(s.r),s.g=oa(s.g),s.b=oa(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ts?ho:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[co]:{primaries:e,whitePoint:n,transfer:ho,toXYZ:Kf,fromXYZ:jf,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ci},outputColorSpaceConfig:{drawingBufferColorSpace:ci}},[ci]:{primaries:e,whitePoint:n,transfer:Dt,toXYZ:Kf,fromXYZ:jf,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ci}}}),i}var St=O_();function gs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function oa(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Yr,Jl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Yr===void 0&&(Yr=uo("canvas")),Yr.width=e.width,Yr.height=e.height;let s=Yr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Yr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=uo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=gs(r[a]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(gs(t[n]/255)*255):t[n]=gs(t[n]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},F_=0,da=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:F_++}),this.uuid=Sa(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(uu(s[a].image)):r.push(uu(s[a]))}else r=uu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function uu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Jl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var k_=0,du=new V,Qn=class i extends Di{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ji,s=ji,r=$n,a=ws,o=Fi,l=ti,c=i.DEFAULT_ANISOTROPY,h=Ts){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:k_++}),this.uuid=Sa(),this.name="",this.source=new da(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new ze(0,0),this.repeat=new ze(1,1),this.center=new ze(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(du).x}get height(){return this.source.getSize(du).y}get depth(){return this.source.getSize(du).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Qu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ql:e.x=e.x-Math.floor(e.x);break;case ji:e.x=e.x<0?0:1;break;case Yl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ql:e.y=e.y-Math.floor(e.y);break;case ji:e.y=e.y<0?0:1;break;case Yl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Qn.DEFAULT_IMAGE=null;Qn.DEFAULT_MAPPING=Qu;Qn.DEFAULT_ANISOTROPY=1;var tn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*n+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],m=l[9],v=l[2],_=l[6],g=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-v)<.01&&Math.abs(m-_)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+v)<.1&&Math.abs(m+_)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,S=(f+1)/2,R=(g+1)/2,w=(h+u)/4,y=(d+v)/4,C=(m+_)/4;return T>S&&T>R?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=w/n,r=y/n):S>R?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=w/s,r=C/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=y/r,s=C/r),this.set(n,s,r,t),this}let x=Math.sqrt((_-m)*(_-m)+(d-v)*(d-v)+(u-h)*(u-h));return Math.abs(x)<.001&&(x=1),this.x=(_-m)/x,this.y=(d-v)/x,this.z=(u-h)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this.w=mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this.w=mt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(mt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Kl=class extends Di{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:$n,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new tn(0,0,e,t),this.scissorTest=!1,this.viewport=new tn(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Qn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:$n,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new da(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},di=class extends Kl{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},fo=class extends Qn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var jl=class extends Qn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Ln,this.minFilter=Ln,this.wrapR=ji,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Xt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,a,o,l,c,h,d,u,f,m,v,_){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c,h,d,u,f,m,v,_)}set(e,t,n,s,r,a,o,l,c,h,d,u,f,m,v,_){let g=this.elements;return g[0]=e,g[4]=t,g[8]=n,g[12]=s,g[1]=r,g[5]=a,g[9]=o,g[13]=l,g[2]=c,g[6]=h,g[10]=d,g[14]=u,g[3]=f,g[7]=m,g[11]=v,g[15]=_,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Zr.setFromMatrixColumn(e,0).length(),r=1/Zr.setFromMatrixColumn(e,1).length(),a=1/Zr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let u=a*h,f=a*d,m=o*h,v=o*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=f+m*c,t[5]=u-v*c,t[9]=-o*l,t[2]=v-u*c,t[6]=m+f*c,t[10]=a*l}else if(e.order==="YXZ"){let u=l*h,f=l*d,m=c*h,v=c*d;t[0]=u+v*o,t[4]=m*o-f,t[8]=a*c,t[1]=a*d,t[5]=a*h,t[9]=-o,t[2]=f*o-m,t[6]=v+u*o,t[10]=a*l}else if(e.order==="ZXY"){let u=l*h,f=l*d,m=c*h,v=c*d;t[0]=u-v*o,t[4]=-a*d,t[8]=m+f*o,t[1]=f+m*o,t[5]=a*h,t[9]=v-u*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let u=a*h,f=a*d,m=o*h,v=o*d;t[0]=l*h,t[4]=m*c-f,t[8]=u*c+v,t[1]=l*d,t[5]=v*c+u,t[9]=f*c-m,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let u=a*l,f=a*c,m=o*l,v=o*c;t[0]=l*h,t[4]=v-u*d,t[8]=m*d+f,t[1]=d,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=f*d+m,t[10]=u-v*d}else if(e.order==="XZY"){let u=a*l,f=a*c,m=o*l,v=o*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+v,t[5]=a*h,t[9]=f*d-m,t[2]=m*d-f,t[6]=o*h,t[10]=v*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(B_,e,z_)}lookAt(e,t,n){let s=this.elements;return oi.subVectors(e,t),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),ks.crossVectors(n,oi),ks.lengthSq()===0&&(Math.abs(n.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),ks.crossVectors(n,oi)),ks.normalize(),gl.crossVectors(oi,ks),s[0]=ks.x,s[4]=gl.x,s[8]=oi.x,s[1]=ks.y,s[5]=gl.y,s[9]=oi.y,s[2]=ks.z,s[6]=gl.z,s[10]=oi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],m=n[2],v=n[6],_=n[10],g=n[14],x=n[3],T=n[7],S=n[11],R=n[15],w=s[0],y=s[4],C=s[8],z=s[12],U=s[1],D=s[5],L=s[9],F=s[13],P=s[2],G=s[6],q=s[10],W=s[14],he=s[3],Z=s[7],Q=s[11],te=s[15];return r[0]=a*w+o*U+l*P+c*he,r[4]=a*y+o*D+l*G+c*Z,r[8]=a*C+o*L+l*q+c*Q,r[12]=a*z+o*F+l*W+c*te,r[1]=h*w+d*U+u*P+f*he,r[5]=h*y+d*D+u*G+f*Z,r[9]=h*C+d*L+u*q+f*Q,r[13]=h*z+d*F+u*W+f*te,r[2]=m*w+v*U+_*P+g*he,r[6]=m*y+v*D+_*G+g*Z,r[10]=m*C+v*L+_*q+g*Q,r[14]=m*z+v*F+_*W+g*te,r[3]=x*w+T*U+S*P+R*he,r[7]=x*y+T*D+S*G+R*Z,r[11]=x*C+T*L+S*q+R*Q,r[15]=x*z+T*F+S*W+R*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],f=e[14],m=e[3],v=e[7],_=e[11],g=e[15],x=l*f-c*u,T=o*f-c*d,S=o*u-l*d,R=a*f-c*h,w=a*u-l*h,y=a*d-o*h;return t*(v*x-_*T+g*S)-n*(m*x-_*R+g*w)+s*(m*T-v*R+g*y)-r*(m*S-v*w+_*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],h=e[10];return t*(a*h-o*c)-n*(r*h-o*l)+s*(r*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],f=e[11],m=e[12],v=e[13],_=e[14],g=e[15],x=t*o-n*a,T=t*l-s*a,S=t*c-r*a,R=n*l-s*o,w=n*c-r*o,y=s*c-r*l,C=h*v-d*m,z=h*_-u*m,U=h*g-f*m,D=d*_-u*v,L=d*g-f*v,F=u*g-f*_,P=x*F-T*L+S*D+R*U-w*z+y*C;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/P;return e[0]=(o*F-l*L+c*D)*G,e[1]=(s*L-n*F-r*D)*G,e[2]=(v*y-_*w+g*R)*G,e[3]=(u*w-d*y-f*R)*G,e[4]=(l*U-a*F-c*z)*G,e[5]=(t*F-s*U+r*z)*G,e[6]=(_*S-m*y-g*T)*G,e[7]=(h*y-u*S+f*T)*G,e[8]=(a*L-o*U+c*C)*G,e[9]=(n*U-t*L-r*C)*G,e[10]=(m*w-v*S+g*x)*G,e[11]=(d*S-h*w-f*x)*G,e[12]=(o*z-a*D-l*C)*G,e[13]=(t*D-n*z+s*C)*G,e[14]=(v*T-m*R-_*x)*G,e[15]=(h*R-d*T+u*x)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,a=e.x,o=e.y,l=e.z,c=r*a,h=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+n,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,a){return this.set(1,n,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,h=a+a,d=o+o,u=r*c,f=r*h,m=r*d,v=a*h,_=a*d,g=o*d,x=l*c,T=l*h,S=l*d,R=n.x,w=n.y,y=n.z;return s[0]=(1-(v+g))*R,s[1]=(f+S)*R,s[2]=(m-T)*R,s[3]=0,s[4]=(f-S)*w,s[5]=(1-(u+g))*w,s[6]=(_+x)*w,s[7]=0,s[8]=(m+T)*y,s[9]=(_-x)*y,s[10]=(1-(u+v))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let a=Zr.set(s[0],s[1],s[2]).length(),o=Zr.set(s[4],s[5],s[6]).length(),l=Zr.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Pi.copy(this);let c=1/a,h=1/o,d=1/l;return Pi.elements[0]*=c,Pi.elements[1]*=c,Pi.elements[2]*=c,Pi.elements[4]*=h,Pi.elements[5]*=h,Pi.elements[6]*=h,Pi.elements[8]*=d,Pi.elements[9]*=d,Pi.elements[10]*=d,t.setFromRotationMatrix(Pi),n.x=a,n.y=o,n.z=l,this}makePerspective(e,t,n,s,r,a,o=bi,l=!1){let c=this.elements,h=2*r/(t-e),d=2*r/(n-s),u=(t+e)/(t-e),f=(n+s)/(n-s),m,v;if(l)m=r/(a-r),v=a*r/(a-r);else if(o===bi)m=-(a+r)/(a-r),v=-2*a*r/(a-r);else if(o===ca)m=-a/(a-r),v=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,a,o=bi,l=!1){let c=this.elements,h=2/(t-e),d=2/(n-s),u=-(t+e)/(t-e),f=-(n+s)/(n-s),m,v;if(l)m=1/(a-r),v=a/(a-r);else if(o===bi)m=-2/(a-r),v=-(a+r)/(a-r);else if(o===ca)m=-1/(a-r),v=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Zr=new V,Pi=new Xt,B_=new V(0,0,0),z_=new V(1,1,1),ks=new V,gl=new V,oi=new V,Qf=new Xt,ep=new qn,vs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-mt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-mt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Qf.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Qf,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ep.setFromEuler(this),this.setFromQuaternion(ep,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};vs.DEFAULT_ORDER="XYZ";var po=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},V_=0,tp=new V,Jr=new qn,us=new Xt,_l=new V,ja=new V,G_=new V,H_=new qn,np=new V(1,0,0),ip=new V(0,1,0),sp=new V(0,0,1),rp={type:"added"},W_={type:"removed"},Kr={type:"childadded",child:null},fu={type:"childremoved",child:null},kn=class i extends Di{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:V_++}),this.uuid=Sa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new V,t=new vs,n=new qn,s=new V(1,1,1);function r(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Xt},normalMatrix:{value:new ct}}),this.matrix=new Xt,this.matrixWorld=new Xt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new po,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Jr.setFromAxisAngle(e,t),this.quaternion.multiply(Jr),this}rotateOnWorldAxis(e,t){return Jr.setFromAxisAngle(e,t),this.quaternion.premultiply(Jr),this}rotateX(e){return this.rotateOnAxis(np,e)}rotateY(e){return this.rotateOnAxis(ip,e)}rotateZ(e){return this.rotateOnAxis(sp,e)}translateOnAxis(e,t){return tp.copy(e).applyQuaternion(this.quaternion),this.position.add(tp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(np,e)}translateY(e){return this.translateOnAxis(ip,e)}translateZ(e){return this.translateOnAxis(sp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(us.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?_l.copy(e):_l.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ja.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?us.lookAt(ja,_l,this.up):us.lookAt(_l,ja,this.up),this.quaternion.setFromRotationMatrix(us),s&&(us.extractRotation(s.matrixWorld),Jr.setFromRotationMatrix(us),this.quaternion.premultiply(Jr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ot("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(rp),Kr.child=e,this.dispatchEvent(Kr),Kr.child=null):ot("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(W_),fu.child=e,this.dispatchEvent(fu),fu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),us.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),us.multiply(e.parent.matrixWorld)),e.applyMatrix4(us),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(rp),Kr.child=e,this.dispatchEvent(Kr),Kr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ja,e,G_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ja,H_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),d=a(e.shapes),u=a(e.skeletons),f=a(e.animations),m=a(e.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),m.length>0&&(n.nodes=m)}return n.object=s,n;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};kn.DEFAULT_UP=new V(0,1,0);kn.DEFAULT_MATRIX_AUTO_UPDATE=!0;kn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Xn=class extends kn{constructor(){super(),this.isGroup=!0,this.type="Group"}},X_={type:"move"},fa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Xn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Xn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Xn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let v of e.hand.values()){let _=t.getJointPose(v,n),g=this._getHandJoint(c,v);_!==null&&(g.matrix.fromArray(_.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=_.radius),g.visible=_!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,m=.005;c.inputState.pinching&&u>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(X_)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Xn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},hm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Bs={h:0,s:0,l:0},vl={h:0,s:0,l:0};function pu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var je=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ci){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=n,St.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=St.workingColorSpace){if(e=dd(e,1),t=mt(t,0,1),n=mt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,a=2*n-r;this.r=pu(a,r,e+1/3),this.g=pu(a,r,e),this.b=pu(a,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=ci){function n(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ci){let n=hm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=gs(e.r),this.g=gs(e.g),this.b=gs(e.b),this}copyLinearToSRGB(e){return this.r=oa(e.r),this.g=oa(e.g),this.b=oa(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ci){return St.workingToColorSpace(Fn.copy(this),e),Math.round(mt(Fn.r*255,0,255))*65536+Math.round(mt(Fn.g*255,0,255))*256+Math.round(mt(Fn.b*255,0,255))}getHexString(e=ci){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(Fn.copy(this),t);let n=Fn.r,s=Fn.g,r=Fn.b,a=Math.max(n,s,r),o=Math.min(n,s,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let d=a-o;switch(c=h<=.5?d/(a+o):d/(2-a-o),a){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(Fn.copy(this),t),e.r=Fn.r,e.g=Fn.g,e.b=Fn.b,e}getStyle(e=ci){St.workingToColorSpace(Fn.copy(this),e);let t=Fn.r,n=Fn.g,s=Fn.b;return e!==ci?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Bs),this.setHSL(Bs.h+e,Bs.s+t,Bs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Bs),e.getHSL(vl);let n=ro(Bs.h,vl.h,t),s=ro(Bs.s,vl.s,t),r=ro(Bs.l,vl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fn=new je;je.NAMES=hm;var mo=class extends kn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new vs,this.environmentIntensity=1,this.environmentRotation=new vs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Li=new V,ds=new V,mu=new V,fs=new V,jr=new V,Qr=new V,ap=new V,gu=new V,_u=new V,vu=new V,xu=new tn,yu=new tn,bu=new tn,Hs=class i{constructor(e=new V,t=new V,n=new V){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Li.subVectors(e,t),s.cross(Li);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Li.subVectors(s,t),ds.subVectors(n,t),mu.subVectors(e,t);let a=Li.dot(Li),o=Li.dot(ds),l=Li.dot(mu),c=ds.dot(ds),h=ds.dot(mu),d=a*c-o*o;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-o*h)*u,m=(a*h-o*l)*u;return r.set(1-f-m,m,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,fs)===null?!1:fs.x>=0&&fs.y>=0&&fs.x+fs.y<=1}static getInterpolation(e,t,n,s,r,a,o,l){return this.getBarycoord(e,t,n,s,fs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,fs.x),l.addScaledVector(a,fs.y),l.addScaledVector(o,fs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,a){return xu.setScalar(0),yu.setScalar(0),bu.setScalar(0),xu.fromBufferAttribute(e,t),yu.fromBufferAttribute(e,n),bu.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(xu,r.x),a.addScaledVector(yu,r.y),a.addScaledVector(bu,r.z),a}static isFrontFacing(e,t,n,s){return Li.subVectors(n,t),ds.subVectors(e,t),Li.cross(ds).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Li.subVectors(this.c,this.b),ds.subVectors(this.a,this.b),Li.cross(ds).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,a,o;jr.subVectors(s,n),Qr.subVectors(r,n),gu.subVectors(e,n);let l=jr.dot(gu),c=Qr.dot(gu);if(l<=0&&c<=0)return t.copy(n);_u.subVectors(e,s);let h=jr.dot(_u),d=Qr.dot(_u);if(h>=0&&d<=h)return t.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),t.copy(n).addScaledVector(jr,a);vu.subVectors(e,r);let f=jr.dot(vu),m=Qr.dot(vu);if(m>=0&&f<=m)return t.copy(r);let v=f*c-l*m;if(v<=0&&c>=0&&m<=0)return o=c/(c-m),t.copy(n).addScaledVector(Qr,o);let _=h*m-f*d;if(_<=0&&d-h>=0&&f-m>=0)return ap.subVectors(r,s),o=(d-h)/(d-h+(f-m)),t.copy(s).addScaledVector(ap,o);let g=1/(_+v+u);return a=v*g,o=u*g,t.copy(n).addScaledVector(jr,a).addScaledVector(Qr,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ws=class{constructor(e=new V(1/0,1/0,1/0),t=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ii.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ii.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ii.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,Ii):Ii.fromBufferAttribute(r,a),Ii.applyMatrix4(e.matrixWorld),this.expandByPoint(Ii);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),xl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),xl.copy(n.boundingBox)),xl.applyMatrix4(e.matrixWorld),this.union(xl)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ii),Ii.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Qa),yl.subVectors(this.max,Qa),ea.subVectors(e.a,Qa),ta.subVectors(e.b,Qa),na.subVectors(e.c,Qa),zs.subVectors(ta,ea),Vs.subVectors(na,ta),cr.subVectors(ea,na);let t=[0,-zs.z,zs.y,0,-Vs.z,Vs.y,0,-cr.z,cr.y,zs.z,0,-zs.x,Vs.z,0,-Vs.x,cr.z,0,-cr.x,-zs.y,zs.x,0,-Vs.y,Vs.x,0,-cr.y,cr.x,0];return!Su(t,ea,ta,na,yl)||(t=[1,0,0,0,1,0,0,0,1],!Su(t,ea,ta,na,yl))?!1:(bl.crossVectors(zs,Vs),t=[bl.x,bl.y,bl.z],Su(t,ea,ta,na,yl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ii).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ii).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ps[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ps[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ps[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ps[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ps[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ps[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ps[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ps[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ps),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ps=[new V,new V,new V,new V,new V,new V,new V,new V],Ii=new V,xl=new Ws,ea=new V,ta=new V,na=new V,zs=new V,Vs=new V,cr=new V,Qa=new V,yl=new V,bl=new V,hr=new V;function Su(i,e,t,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){hr.fromArray(i,r);let o=s.x*Math.abs(hr.x)+s.y*Math.abs(hr.y)+s.z*Math.abs(hr.z),l=e.dot(hr),c=t.dot(hr),h=n.dot(hr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var vn=new V,Sl=new ze,$_=0,jn=class extends Di{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:$_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=im,this.updateRanges=[],this.gpuType=Ui,this.version=0,this._normalizationScale=e!==void 0?pd(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Sl.fromBufferAttribute(this,t),Sl.applyMatrix3(e),this.setXY(t,Sl.x,Sl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix3(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix4(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)vn.fromBufferAttribute(this,t),vn.applyNormalMatrix(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)vn.fromBufferAttribute(this,t),vn.transformDirection(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):lm(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):cm(e,this.array)}};var go=class extends jn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var _o=class extends jn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var $t=class extends jn{constructor(e,t,n){super(new Float32Array(e),t,n)}},q_=new Ws,eo=new V,Mu=new V,fr=class{constructor(e=new V,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):q_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;eo.subVectors(e,this.center);let t=eo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(eo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Mu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(eo.copy(e.center).add(Mu)),this.expandByPoint(eo.copy(e.center).sub(Mu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Y_=0,yi=new Xt,wu=new kn,ia=new V,li=new Ws,to=new Ws,Pn=new V,un=class i extends Di{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Y_++}),this.uuid=Sa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(x_(e)?_o:go)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ct().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return yi.makeRotationFromQuaternion(e),this.applyMatrix4(yi),this}rotateX(e){return yi.makeRotationX(e),this.applyMatrix4(yi),this}rotateY(e){return yi.makeRotationY(e),this.applyMatrix4(yi),this}rotateZ(e){return yi.makeRotationZ(e),this.applyMatrix4(yi),this}translate(e,t,n){return yi.makeTranslation(e,t,n),this.applyMatrix4(yi),this}scale(e,t,n){return yi.makeScale(e,t,n),this.applyMatrix4(yi),this}lookAt(e){return wu.lookAt(e),wu.updateMatrix(),this.applyMatrix4(wu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ia).negate(),this.translate(ia.x,ia.y,ia.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new $t(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ws);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ot("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];li.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,li.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,li.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(li.min),this.boundingBox.expandByPoint(li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ot('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new fr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ot("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(e){let n=this.boundingSphere.center;if(li.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];to.setFromBufferAttribute(o),this.morphTargetsRelative?(Pn.addVectors(li.min,to.min),li.expandByPoint(Pn),Pn.addVectors(li.max,to.max),li.expandByPoint(Pn)):(li.expandByPoint(to.min),li.expandByPoint(to.max))}li.getCenter(n);let s=0;for(let r=0,a=e.count;r<a;r++)Pn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Pn));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)Pn.fromBufferAttribute(o,c),l&&(ia.fromBufferAttribute(e,c),Pn.add(ia)),s=Math.max(s,n.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ot('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ot("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new jn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(n.count);for(let z=0;z<n.count;z++)o[z]=new V,l[z]=new V;let h=new V,d=new V,u=new V,f=new ze,m=new ze,v=new ze,_=new V,g=new V;function x(z,U,D){c[z]=c[U]=c[D]=1,h.fromBufferAttribute(n,z),d.fromBufferAttribute(n,U),u.fromBufferAttribute(n,D),f.fromBufferAttribute(r,z),m.fromBufferAttribute(r,U),v.fromBufferAttribute(r,D),d.sub(h),u.sub(h),m.sub(f),v.sub(f);let L=1/(m.x*v.y-v.x*m.y);isFinite(L)&&(_.copy(d).multiplyScalar(v.y).addScaledVector(u,-m.y).multiplyScalar(L),g.copy(u).multiplyScalar(m.x).addScaledVector(d,-v.x).multiplyScalar(L),o[z].add(_),o[U].add(_),o[D].add(_),l[z].add(g),l[U].add(g),l[D].add(g))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let z=0,U=T.length;z<U;++z){let D=T[z],L=D.start,F=D.count;for(let P=L,G=L+F;P<G;P+=3)x(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let S=new V,R=new V,w=new V,y=new V;function C(z){w.fromBufferAttribute(s,z),y.copy(w);let U=o[z];S.copy(U),S.sub(w.multiplyScalar(w.dot(U))).normalize(),R.crossVectors(y,U);let L=R.dot(l[z])<0?-1:1;a.setXYZW(z,S.x,S.y,S.z,L)}for(let z=0,U=n.count;z<U;++z)c[z]&&C(z);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new jn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let s=new V,r=new V,a=new V,o=new V,l=new V,c=new V,h=new V,d=new V;if(e)for(let u=0,f=e.count;u<f;u+=3){let m=e.getX(u+0),v=e.getX(u+1),_=e.getX(u+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,v),a.fromBufferAttribute(t,_),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),o.fromBufferAttribute(n,m),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,_),o.add(h),l.add(h),c.add(h),n.setXYZ(m,o.x,o.y,o.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(_,c.x,c.y,c.z)}else for(let u=0,f=t.count;u<f;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),a.fromBufferAttribute(t,u+2),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Pn.fromBufferAttribute(e,t),Pn.normalize(),e.setXYZ(t,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function e(o,l){let c=o.array,h=o.itemSize,d=o.normalized,u=new c.constructor(l.length*h),f=0,m=0;for(let v=0,_=l.length;v<_;v++){o.isInterleavedBufferAttribute?f=l[v]*o.data.stride+o.offset:f=l[v]*h;for(let g=0;g<h;g++)u[m++]=c[f++]}return new jn(u,h,d)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=e(l,n);t.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=e(u,n);l.push(f)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,h=a.length;c<h;c++){let d=a[c];this.addGroup(d.start,d.count,d.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Eu=new V,Z_=new V,J_=new ct,hi=class{constructor(e=new V(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Eu.subVectors(n,t).cross(Z_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Eu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||J_.getNormalMatrix(e),s=this.coplanarPoint(Eu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},K_=0,xs=class extends Di{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:K_++}),this.uuid=Sa(),this.name="",this.type="Material",this.blending=xa,this.side=Ks,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wu,this.blendDst=Xu,this.blendEquation=vr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new je(0,0,0),this.blendAlpha=0,this.depthFunc=la,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Kp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Bl,this.stencilZFail=Bl,this.stencilZPass=Bl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new je().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new hi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new ze().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ze().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ms=new V,Tu=new V,Ml=new V,wl=new V,pr=class{constructor(e=new V,t=new V(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ms)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ms.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ms.copy(this.origin).addScaledVector(this.direction,t),ms.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Tu.copy(e).add(t).multiplyScalar(.5),Ml.copy(t).sub(e).normalize(),wl.copy(this.origin).sub(Tu);let r=e.distanceTo(t)*.5,a=-this.direction.dot(Ml),o=wl.dot(this.direction),l=-wl.dot(Ml),c=wl.lengthSq(),h=Math.abs(1-a*a),d,u,f,m;if(h>0)if(d=a*l-o,u=a*o-l,m=r*h,d>=0)if(u>=-m)if(u<=m){let v=1/h;d*=v,u*=v,f=d*(d+a*u+2*o)+u*(a*d+u+2*l)+c}else u=r,d=Math.max(0,-(a*u+o)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(a*u+o)),f=-d*d+u*(u+2*l)+c;else u<=-m?(d=Math.max(0,-(-a*r+o)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=m?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(a*r+o)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=a>0?-r:r,d=Math.max(0,-(a*u+o)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Tu).addScaledVector(Ml,u),f}intersectSphere(e,t){if(e.radius<0)return null;ms.subVectors(e.center,this.origin);let n=ms.dot(this.direction),s=ms.dot(ms)-n*n,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,a=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,a=(e.min.y-u.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),d>=0?(o=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(o=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ms)!==null}intersectTriangle(e,t,n,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,d=e.x-a.x,u=e.y-a.y,f=e.z-a.z,m=t.x-a.x,v=t.y-a.y,_=t.z-a.z,g=n.x-a.x,x=n.y-a.y,T=n.z-a.z,S=Math.abs(l),R=Math.abs(c),w=Math.abs(h),y,C,z,U,D,L,F,P,G,q,W,he;if(S>=R&&S>=w?(z=l,L=d,G=m,he=g,l>=0?(y=c,C=h,U=u,D=f,F=v,P=_,q=x,W=T):(y=h,C=c,U=f,D=u,F=_,P=v,q=T,W=x)):R>=w?(z=c,L=u,G=v,he=x,c>=0?(y=h,C=l,U=f,D=d,F=_,P=m,q=T,W=g):(y=l,C=h,U=d,D=f,F=m,P=_,q=g,W=T)):(z=h,L=f,G=_,he=T,h>=0?(y=l,C=c,U=d,D=u,F=m,P=v,q=g,W=x):(y=c,C=l,U=u,D=d,F=v,P=m,q=x,W=g)),z===0)return null;let Z=y/z,Q=C/z,te=1/z,ue=U-Z*L,de=D-Q*L,j=F-Z*G,me=P-Q*G,ve=q-Z*he,Ee=W-Q*he,xe=ve*me-Ee*j,qe=ue*Ee-de*ve,st=j*de-me*ue;if(s){if(xe<0||qe<0||st<0)return null}else if((xe<0||qe<0||st<0)&&(xe>0||qe>0||st>0))return null;let ae=xe+qe+st;if(ae===0)return null;let Xe=te*(xe*L+qe*G+st*he);return(ae>0?Xe<0:Xe>0)?null:this.at(Xe/ae,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ql=class extends xs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vs,this.combine=Tc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},op=new Xt,ur=new pr,El=new fr,lp=new V,Tl=new V,Al=new V,Cl=new V,Au=new V,Rl=new V,cp=new V,Pl=new V,dn=class extends kn{constructor(e=new un,t=new Ql){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){Rl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],d=r[l];h!==0&&(Au.fromBufferAttribute(d,e),a?Rl.addScaledVector(Au,h):Rl.addScaledVector(Au.sub(t),h))}t.add(Rl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),El.copy(n.boundingSphere),El.applyMatrix4(r),ur.copy(e.ray).recast(e.near),!(El.containsPoint(ur.origin)===!1&&(ur.intersectSphere(El,lp)===null||ur.origin.distanceToSquared(lp)>(e.far-e.near)**2))&&(op.copy(r).invert(),ur.copy(e.ray).applyMatrix4(op),!(n.boundingBox!==null&&ur.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,ur)))}_computeIntersections(e,t,n){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(o!==null)if(Array.isArray(a))for(let m=0,v=u.length;m<v;m++){let _=u[m],g=a[_.materialIndex],x=Math.max(_.start,f.start),T=Math.min(o.count,Math.min(_.start+_.count,f.start+f.count));for(let S=x,R=T;S<R;S+=3){let w=o.getX(S),y=o.getX(S+1),C=o.getX(S+2);s=Ll(this,g,e,n,c,h,d,w,y,C),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(o.count,f.start+f.count);for(let _=m,g=v;_<g;_+=3){let x=o.getX(_),T=o.getX(_+1),S=o.getX(_+2);s=Ll(this,a,e,n,c,h,d,x,T,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let m=0,v=u.length;m<v;m++){let _=u[m],g=a[_.materialIndex],x=Math.max(_.start,f.start),T=Math.min(l.count,Math.min(_.start+_.count,f.start+f.count));for(let S=x,R=T;S<R;S+=3){let w=S,y=S+1,C=S+2;s=Ll(this,g,e,n,c,h,d,w,y,C),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let _=m,g=v;_<g;_+=3){let x=_,T=_+1,S=_+2;s=Ll(this,a,e,n,c,h,d,x,T,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}}};function j_(i,e,t,n,s,r,a,o){let l;if(e.side===Zn?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,e.side===Ks,o),l===null)return null;Pl.copy(o),Pl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Pl);return c<t.near||c>t.far?null:{distance:c,point:Pl.clone(),object:i}}function Ll(i,e,t,n,s,r,a,o,l,c){i.getVertexPosition(o,Tl),i.getVertexPosition(l,Al),i.getVertexPosition(c,Cl);let h=j_(i,e,t,n,Tl,Al,Cl,cp);if(h){let d=new V;Hs.getBarycoord(cp,Tl,Al,Cl,d),s&&(h.uv=Hs.getInterpolatedAttribute(s,o,l,c,d,new ze)),r&&(h.uv1=Hs.getInterpolatedAttribute(r,o,l,c,d,new ze)),a&&(h.normal=Hs.getInterpolatedAttribute(a,o,l,c,d,new V),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a:o,b:l,c,normal:new V,materialIndex:0};Hs.getNormal(Tl,Al,Cl,u.normal),h.face=u,h.barycoord=d}return h}var ec=class extends Qn{constructor(e=null,t=1,n=1,s,r,a,o,l,c=Ln,h=Ln,d,u){super(null,a,o,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var dr=new fr,Q_=new ze(.5,.5),Il=new V,Xs=class{constructor(e=new hi,t=new hi,n=new hi,s=new hi,r=new hi,a=new hi){this.planes=[e,t,n,s,r,a]}set(e,t,n,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=bi,n=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],m=r[8],v=r[9],_=r[10],g=r[11],x=r[12],T=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-a,f-h,g-m,R-x).normalize(),s[1].setComponents(c+a,f+h,g+m,R+x).normalize(),s[2].setComponents(c+o,f+d,g+v,R+T).normalize(),s[3].setComponents(c-o,f-d,g-v,R-T).normalize(),n)s[4].setComponents(l,u,_,S).normalize(),s[5].setComponents(c-l,f-u,g-_,R-S).normalize();else if(s[4].setComponents(c-l,f-u,g-_,R-S).normalize(),t===bi)s[5].setComponents(c+l,f+u,g+_,R+S).normalize();else if(t===ca)s[5].setComponents(l,u,_,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),dr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),dr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(dr)}intersectsSprite(e){dr.center.set(0,0,0);let t=Q_.distanceTo(e.center);return dr.radius=.7071067811865476+t,dr.applyMatrix4(e.matrixWorld),this.intersectsSphere(dr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Il.x=s.normal.x>0?e.max.x:e.min.x,Il.y=s.normal.y>0?e.max.y:e.min.y,Il.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Il)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},hp=new Xt,tc=class i{constructor(){this.coordinateSystem=bi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];hp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Xs),n[s].setFromProjectionMatrix(hp,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Xs),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var ys=class extends xs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new je(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},nc=new V,ic=new V,up=new Xt,no=new pr,Dl=new fr,Cu=new V,dp=new V,bs=class extends kn{constructor(e=new un,t=new ys){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)nc.fromBufferAttribute(t,s-1),ic.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=nc.distanceTo(ic);e.setAttribute("lineDistance",new $t(n,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Dl.copy(n.boundingSphere),Dl.applyMatrix4(s),Dl.radius+=r,e.ray.intersectsSphere(Dl)===!1)return;up.copy(s).invert(),no.copy(e.ray).applyMatrix4(up);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let f=Math.max(0,a.start),m=Math.min(h.count,a.start+a.count);for(let v=f,_=m-1;v<_;v+=c){let g=h.getX(v),x=h.getX(v+1),T=Nl(this,e,no,l,g,x,v);T&&t.push(T)}if(this.isLineLoop){let v=h.getX(m-1),_=h.getX(f),g=Nl(this,e,no,l,v,_,m-1);g&&t.push(g)}}else{let f=Math.max(0,a.start),m=Math.min(u.count,a.start+a.count);for(let v=f,_=m-1;v<_;v+=c){let g=Nl(this,e,no,l,v,v+1,v);g&&t.push(g)}if(this.isLineLoop){let v=Nl(this,e,no,l,m-1,f,m-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function Nl(i,e,t,n,s,r,a){let o=i.geometry.attributes.position;if(nc.fromBufferAttribute(o,s),ic.fromBufferAttribute(o,r),t.distanceSqToSegment(nc,ic,Cu,dp)>n)return;Cu.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Cu);if(!(c<e.near||c>e.far))return{distance:c,point:dp.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var fp=new V,pp=new V,vo=class extends bs{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)fp.fromBufferAttribute(t,s),pp.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+fp.distanceTo(pp);e.setAttribute("lineDistance",new $t(n,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var xo=class extends Qn{constructor(e=[],t=xr,n,s,r,a,o,l,c,h){super(e,t,n,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ss=class extends Qn{constructor(e,t,n=Ni,s,r,a,o=Ln,l=Ln,c,h=_s,d=1){if(h!==_s&&h!==Es)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,s,r,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new da(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},yo=class extends Ss{constructor(e,t=Ni,n=xr,s,r,a=Ln,o=Ln,l,c=_s){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,n,s,r,a,o,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},bo=class extends Qn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Ms=class i extends un{constructor(e=1,t=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],d=[],u=0,f=0;m("z","y","x",-1,-1,n,t,e,a,r,0),m("z","y","x",1,-1,n,t,-e,a,r,1),m("x","z","y",1,1,e,n,t,s,a,2),m("x","z","y",1,-1,e,n,-t,s,a,3),m("x","y","z",1,-1,e,t,n,s,r,4),m("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new $t(c,3)),this.setAttribute("normal",new $t(h,3)),this.setAttribute("uv",new $t(d,2));function m(v,_,g,x,T,S,R,w,y,C,z){let U=S/y,D=R/C,L=S/2,F=R/2,P=w/2,G=y+1,q=C+1,W=0,he=0,Z=new V;for(let Q=0;Q<q;Q++){let te=Q*D-F;for(let ue=0;ue<G;ue++){let de=ue*U-L;Z[v]=de*x,Z[_]=te*T,Z[g]=P,c.push(Z.x,Z.y,Z.z),Z[v]=0,Z[_]=0,Z[g]=w>0?1:-1,h.push(Z.x,Z.y,Z.z),d.push(ue/y),d.push(1-Q/C),W+=1}}for(let Q=0;Q<C;Q++)for(let te=0;te<y;te++){let ue=u+te+G*Q,de=u+te+G*(Q+1),j=u+(te+1)+G*(Q+1),me=u+(te+1)+G*Q;l.push(ue,de,me),l.push(de,j,me),he+=6}o.addGroup(f,he,z),f+=he,u+=W}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var pa=class i extends un{constructor(e=1,t=1,n=1,s=32,r=1,a=!1,o=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],f=[],m=0,v=[],_=n/2,g=0;x(),a===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(h),this.setAttribute("position",new $t(d,3)),this.setAttribute("normal",new $t(u,3)),this.setAttribute("uv",new $t(f,2));function x(){let S=new V,R=new V,w=0,y=(t-e)/n;for(let C=0;C<=r;C++){let z=[],U=C/r,D=U*(t-e)+e;for(let L=0;L<=s;L++){let F=L/s,P=F*l+o,G=Math.sin(P),q=Math.cos(P);R.x=D*G,R.y=-U*n+_,R.z=D*q,d.push(R.x,R.y,R.z),S.set(G,y,q).normalize(),u.push(S.x,S.y,S.z),f.push(F,1-U),z.push(m++)}v.push(z)}for(let C=0;C<s;C++)for(let z=0;z<r;z++){let U=v[z][C],D=v[z+1][C],L=v[z+1][C+1],F=v[z][C+1];(e>0||z!==0)&&(h.push(U,D,F),w+=3),(t>0||z!==r-1)&&(h.push(D,L,F),w+=3)}c.addGroup(g,w,0),g+=w}function T(S){let R=m,w=new ze,y=new V,C=0,z=S===!0?e:t,U=S===!0?1:-1;for(let L=1;L<=s;L++)d.push(0,_*U,0),u.push(0,U,0),f.push(.5,.5),m++;let D=m;for(let L=0;L<=s;L++){let P=L/s*l+o,G=Math.cos(P),q=Math.sin(P);y.x=z*q,y.y=_*U,y.z=z*G,d.push(y.x,y.y,y.z),u.push(0,U,0),w.x=G*.5+.5,w.y=q*.5*U+.5,f.push(w.x,w.y),m++}for(let L=0;L<s;L++){let F=R+L,P=D+L;S===!0?h.push(P,P+1,F):h.push(P+1,P,F),C+=3}c.addGroup(g,C,S===!0?1:2),g+=C}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Si=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ke("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let a=1;a<=e;a++)n=this.getPoint(a/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,a;t?a=t:a=e*n[r-1];let o=0,l=r-1,c;for(;o<=l;)if(s=Math.floor(o+(l-o)/2),c=n[s]-a,c<0)o=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===a)return s/(r-1);let h=n[s],u=n[s+1]-h,f=(a-h)/u;return(s+f)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let a=this.getPoint(s),o=this.getPoint(r),l=t||(a.isVector2?new ze:new V);return l.copy(o).sub(a).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new V,s=[],r=[],a=[],o=new V,l=new Xt;for(let f=0;f<=e;f++){let m=f/e;s[f]=this.getTangentAt(m,new V)}r[0]=new V,a[0]=new V;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),d=Math.abs(s[0].y),u=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),d<=c&&(c=d,n.set(0,1,0)),u<=c&&n.set(0,0,1),o.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],o),a[0].crossVectors(s[0],r[0]);for(let f=1;f<=e;f++){if(r[f]=r[f-1].clone(),a[f]=a[f-1].clone(),o.crossVectors(s[f-1],s[f]),o.length()>Number.EPSILON){o.normalize();let m=Math.acos(mt(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(o,m))}a[f].crossVectors(s[f],r[f])}if(t===!0){let f=Math.acos(mt(r[0].dot(r[e]),-1,1));f/=e,s[0].dot(o.crossVectors(r[0],r[e]))>0&&(f=-f);for(let m=1;m<=e;m++)r[m].applyMatrix4(l.makeRotationAxis(s[m],f*m)),a[m].crossVectors(s[m],r[m])}return{tangents:s,normals:r,binormals:a}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},So=class extends Si{constructor(e=0,t=0,n=1,s=1,r=0,a=Math.PI*2,o=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=a,this.aClockwise=o,this.aRotation=l}getPoint(e,t=new ze){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,a=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(a?r=0:r=s),this.aClockwise===!0&&!a&&(r===s?r=-s:r=r-s);let o=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(o),c=this.aY+this.yRadius*Math.sin(o);if(this.aRotation!==0){let h=Math.cos(this.aRotation),d=Math.sin(this.aRotation),u=l-this.aX,f=c-this.aY;l=u*h-f*d+this.aX,c=u*d+f*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},sc=class extends So{constructor(e,t,n,s,r,a){super(e,t,n,n,s,r,a),this.isArcCurve=!0,this.type="ArcCurve"}};function gd(){let i=0,e=0,t=0,n=0;function s(r,a,o,l){i=r,e=o,t=-3*r+3*a-2*o-l,n=2*r-2*a+o+l}return{initCatmullRom:function(r,a,o,l,c){s(a,o,c*(o-r),c*(l-a))},initNonuniformCatmullRom:function(r,a,o,l,c,h,d){let u=(a-r)/c-(o-r)/(c+h)+(o-a)/h,f=(o-a)/h-(l-a)/(h+d)+(l-o)/d;u*=h,f*=h,s(a,o,u,f)},calc:function(r){let a=r*r,o=a*r;return i+e*r+t*a+n*o}}}var mp=new V,gp=new V,Ru=new gd,Pu=new gd,Lu=new gd,ma=class extends Si{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new V){let n=t,s=this.points,r=s.length,a=(r-(this.closed?0:1))*e,o=Math.floor(a),l=a-o;this.closed?o+=o>0?0:(Math.floor(Math.abs(o)/r)+1)*r:l===0&&o===r-1&&(o=r-2,l=1);let c,h;this.closed||o>0?c=s[(o-1)%r]:(gp.subVectors(s[0],s[1]).add(s[0]),c=gp);let d=s[o%r],u=s[(o+1)%r];if(this.closed||o+2<r?h=s[(o+2)%r]:(mp.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=mp),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,m=Math.pow(c.distanceToSquared(d),f),v=Math.pow(d.distanceToSquared(u),f),_=Math.pow(u.distanceToSquared(h),f);v<1e-4&&(v=1),m<1e-4&&(m=v),_<1e-4&&(_=v),Ru.initNonuniformCatmullRom(c.x,d.x,u.x,h.x,m,v,_),Pu.initNonuniformCatmullRom(c.y,d.y,u.y,h.y,m,v,_),Lu.initNonuniformCatmullRom(c.z,d.z,u.z,h.z,m,v,_)}else this.curveType==="catmullrom"&&(Ru.initCatmullRom(c.x,d.x,u.x,h.x,this.tension),Pu.initCatmullRom(c.y,d.y,u.y,h.y,this.tension),Lu.initCatmullRom(c.z,d.z,u.z,h.z,this.tension));return n.set(Ru.calc(l),Pu.calc(l),Lu.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new V().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function _p(i,e,t,n,s){let r=(n-e)*.5,a=(s-t)*.5,o=i*i,l=i*o;return(2*t-2*n+r+a)*l+(-3*t+3*n-2*r-a)*o+r*i+t}function ev(i,e){let t=1-i;return t*t*e}function tv(i,e){return 2*(1-i)*i*e}function nv(i,e){return i*i*e}function ao(i,e,t,n){return ev(i,e)+tv(i,t)+nv(i,n)}function iv(i,e){let t=1-i;return t*t*t*e}function sv(i,e){let t=1-i;return 3*t*t*i*e}function rv(i,e){return 3*(1-i)*i*i*e}function av(i,e){return i*i*i*e}function oo(i,e,t,n,s){return iv(i,e)+sv(i,t)+rv(i,n)+av(i,s)}var rc=class extends Si{constructor(e=new ze,t=new ze,n=new ze,s=new ze){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new ze){let n=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return n.set(oo(e,s.x,r.x,a.x,o.x),oo(e,s.y,r.y,a.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},ac=class extends Si{constructor(e=new V,t=new V,n=new V,s=new V){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new V){let n=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return n.set(oo(e,s.x,r.x,a.x,o.x),oo(e,s.y,r.y,a.y,o.y),oo(e,s.z,r.z,a.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},oc=class extends Si{constructor(e=new ze,t=new ze){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new ze){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new ze){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},lc=class extends Si{constructor(e=new V,t=new V){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new V){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new V){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},cc=class extends Si{constructor(e=new ze,t=new ze,n=new ze){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new ze){let n=t,s=this.v0,r=this.v1,a=this.v2;return n.set(ao(e,s.x,r.x,a.x),ao(e,s.y,r.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},Mo=class extends Si{constructor(e=new V,t=new V,n=new V){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new V){let n=t,s=this.v0,r=this.v1,a=this.v2;return n.set(ao(e,s.x,r.x,a.x),ao(e,s.y,r.y,a.y),ao(e,s.z,r.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},hc=class extends Si{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new ze){let n=t,s=this.points,r=(s.length-1)*e,a=Math.floor(r),o=r-a,l=s[a===0?a:a-1],c=s[a],h=s[a>s.length-2?s.length-1:a+1],d=s[a>s.length-3?s.length-1:a+2];return n.set(_p(o,l.x,c.x,h.x,d.x),_p(o,l.y,c.y,h.y,d.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new ze().fromArray(s))}return this}},ov=Object.freeze({__proto__:null,ArcCurve:sc,CatmullRomCurve3:ma,CubicBezierCurve:rc,CubicBezierCurve3:ac,EllipseCurve:So,LineCurve:oc,LineCurve3:lc,QuadraticBezierCurve:cc,QuadraticBezierCurve3:Mo,SplineCurve:hc});var wo=class i extends un{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(n),l=Math.floor(s),c=o+1,h=l+1,d=e/o,u=t/l,f=[],m=[],v=[],_=[];for(let g=0;g<h;g++){let x=g*u-a;for(let T=0;T<c;T++){let S=T*d-r;m.push(S,-x,0),v.push(0,0,1),_.push(T/o),_.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<o;x++){let T=x+c*g,S=x+c*(g+1),R=x+1+c*(g+1),w=x+1+c*g;f.push(T,S,w),f.push(S,R,w)}this.setIndex(f),this.setAttribute("position",new $t(m,3)),this.setAttribute("normal",new $t(v,3)),this.setAttribute("uv",new $t(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var mr=class i extends un{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(a+o,Math.PI),c=0,h=[],d=new V,u=new V,f=[],m=[],v=[],_=[];for(let g=0;g<=n;g++){let x=[],T=g/n,S=a+T*o,R=e*Math.cos(S),w=Math.sqrt(e*e-R*R),y=0;g===0&&a===0?y=.5/t:g===n&&l===Math.PI&&(y=-.5/t);for(let C=0;C<=t;C++){let z=C/t,U=s+z*r;d.x=-w*Math.cos(U),d.y=R,d.z=w*Math.sin(U),m.push(d.x,d.y,d.z),u.copy(d).normalize(),v.push(u.x,u.y,u.z),_.push(z+y,1-T),x.push(c++)}h.push(x)}for(let g=0;g<n;g++)for(let x=0;x<t;x++){let T=h[g][x+1],S=h[g][x],R=h[g+1][x],w=h[g+1][x+1];(g!==0||a>0)&&f.push(T,S,w),(g!==n-1||l<Math.PI)&&f.push(S,R,w)}this.setIndex(f),this.setAttribute("position",new $t(m,3)),this.setAttribute("normal",new $t(v,3)),this.setAttribute("uv",new $t(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Eo=class i extends un{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],d=[],u=new V,f=new V,m=new V;for(let v=0;v<=n;v++){let _=a+v/n*o;for(let g=0;g<=s;g++){let x=g/s*r;f.x=(e+t*Math.cos(_))*Math.cos(x),f.y=(e+t*Math.cos(_))*Math.sin(x),f.z=t*Math.sin(_),c.push(f.x,f.y,f.z),u.x=e*Math.cos(x),u.y=e*Math.sin(x),m.subVectors(f,u).normalize(),h.push(m.x,m.y,m.z),d.push(g/s),d.push(v/n)}}for(let v=1;v<=n;v++)for(let _=1;_<=s;_++){let g=(s+1)*v+_-1,x=(s+1)*(v-1)+_-1,T=(s+1)*(v-1)+_,S=(s+1)*v+_;l.push(g,x,S),l.push(x,T,S)}this.setIndex(l),this.setAttribute("position",new $t(c,3)),this.setAttribute("normal",new $t(h,3)),this.setAttribute("uv",new $t(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var To=class i extends un{constructor(e=new Mo(new V(-1,-1,0),new V(-1,1,0),new V(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let a=e.computeFrenetFrames(t,r);this.tangents=a.tangents,this.normals=a.normals,this.binormals=a.binormals;let o=new V,l=new V,c=new ze,h=new V,d=[],u=[],f=[],m=[];v(),this.setIndex(m),this.setAttribute("position",new $t(d,3)),this.setAttribute("normal",new $t(u,3)),this.setAttribute("uv",new $t(f,2));function v(){for(let T=0;T<t;T++)_(T);_(r===!1?t:0),x(),g()}function _(T){h=e.getPointAt(T/t,h);let S=a.normals[T],R=a.binormals[T];for(let w=0;w<=s;w++){let y=w/s*Math.PI*2,C=Math.sin(y),z=-Math.cos(y);l.x=z*S.x+C*R.x,l.y=z*S.y+C*R.y,l.z=z*S.z+C*R.z,l.normalize(),u.push(l.x,l.y,l.z),o.x=h.x+n*l.x,o.y=h.y+n*l.y,o.z=h.z+n*l.z,d.push(o.x,o.y,o.z)}}function g(){for(let T=1;T<=t;T++)for(let S=1;S<=s;S++){let R=(s+1)*(T-1)+(S-1),w=(s+1)*T+(S-1),y=(s+1)*T+S,C=(s+1)*(T-1)+S;m.push(R,w,C),m.push(w,y,C)}}function x(){for(let T=0;T<=t;T++)for(let S=0;S<=s;S++)c.x=T/t,c.y=S/s,f.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new ov[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}};function br(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(vp(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(vp(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Bn(i){let e={};for(let t=0;t<i.length;t++){let n=br(i[t]);for(let s in n)e[s]=n[s]}return e}function vp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function lv(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function _d(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var um={clone:br,merge:Bn},cv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,hv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Qi=class extends xs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=cv,this.fragmentShader=hv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=br(e.uniforms),this.uniformsGroups=lv(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new je().setHex(s.value);break;case"v2":this.uniforms[n].value=new ze().fromArray(s.value);break;case"v3":this.uniforms[n].value=new V().fromArray(s.value);break;case"v4":this.uniforms[n].value=new tn().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ct().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Xt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},uc=class extends Qi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Yn=class extends xs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=dh,this.normalScale=new ze(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vs,this.combine=Tc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},dc=class extends xs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Zp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},fc=class extends xs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var Ao=class extends ys{constructor(e){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(e)}copy(e){return super.copy(e),this.scale=e.scale,this.dashSize=e.dashSize,this.gapSize=e.gapSize,this}};function sa(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Ul(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var $s=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let a;t:{i:if(!(e<s)){for(let o=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=t[++n],e<s)break e}a=t.length;break t}if(!(e>=r)){let o=t[1];e<o&&(n=2,r=o);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}a=n,n=0;break t}break n}for(;n<a;){let o=n+a>>>1;e<t[o]?a=o:n=o+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=n[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},pc=class extends $s{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Nu,endingEnd:Nu}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Uu:r=e,o=2*t-n;break;case Ou:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Uu:a=e,l=2*n-t;break;case Ou:a=1,l=n+s[1]-s[0];break;default:a=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,m=(n-t)/(s-t),v=m*m,_=v*m,g=-u*_+2*u*v-u*m,x=(1+u)*_+(-1.5-2*u)*v+(-.5+u)*m+1,T=(-1-f)*_+(1.5+f)*v+.5*m,S=f*_-f*v;for(let R=0;R!==o;++R)r[R]=g*a[h+R]+x*a[c+R]+T*a[l+R]+S*a[d+R];return r}},mc=class extends $s{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=(n-t)/(s-t),d=1-h;for(let u=0;u!==o;++u)r[u]=a[c+u]*d+a[l+u]*h;return r}},gc=class extends $s{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},_c=class extends $s{interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this.inTangents,d=this.outTangents;if(!h||!d){let m=(n-t)/(s-t),v=1-m;for(let _=0;_!==o;++_)r[_]=a[c+_]*v+a[l+_]*m;return r}let u=o*2,f=e-1;for(let m=0;m!==o;++m){let v=a[c+m],_=a[l+m],g=f*u+m*2,x=d[g],T=d[g+1],S=e*u+m*2,R=h[S],w=h[S+1],y=dv(n,t,x,R,s);r[m]=dm(y,v,T,w,_)}return r}};function dm(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function uv(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function dv(i,e,t,n,s){let r=(i-e)/(s-e);for(let a=0;a<8;a++){let o=dm(r,e,t,n,s)-i;if(Math.abs(o)<1e-10)break;let l=uv(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var fi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=sa(t,this.TimeBufferType),this.values=sa(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:sa(e.times,Array),values:sa(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Ul(e.settings)&&(n.settings={inTangents:sa(e.settings.inTangents,Array),outTangents:sa(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new gc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new mc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new pc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new _c(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case lo:t=this.InterpolantFactoryMethodDiscrete;break;case Zl:t=this.InterpolantFactoryMethodLinear;break;case kl:t=this.InterpolantFactoryMethodSmooth;break;case Du:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ke("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return lo;case this.InterpolantFactoryMethodLinear:return Zl;case this.InterpolantFactoryMethodSmooth:return kl;case this.InterpolantFactoryMethodBezier:return Du}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Ul(this.settings)&&(xp(this.settings.inTangents,e),xp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Ul(this.settings)&&(yp(this.settings.inTangents,e),yp(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<e;)++r;for(;a!==-1&&n[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ot("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ot("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let l=n[o];if(typeof l=="number"&&isNaN(l)){ot("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){ot("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(s!==void 0&&y_(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){ot("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===kl,r=e.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=e[o],h=e[o+1];if(c!==h&&(o!==1||c!==e[0]))if(s)l=!0;else{let d=o*n,u=d-n,f=d+n;for(let m=0;m!==n;++m){let v=t[d+m];if(v!==t[u+m]||v!==t[f+m]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let d=o*n,u=a*n;for(let f=0;f!==n;++f)t[u+f]=t[d+f]}++a}}if(r>0){e[a]=e[r];for(let o=r*n,l=a*n,c=0;c!==n;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Ul(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function xp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function yp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}fi.prototype.ValueTypeName="";fi.prototype.TimeBufferType=Float32Array;fi.prototype.ValueBufferType=Float32Array;fi.prototype.DefaultInterpolation=Zl;var qs=class extends fi{constructor(e,t,n){super(e,t,n)}};qs.prototype.ValueTypeName="bool";qs.prototype.ValueBufferType=Array;qs.prototype.DefaultInterpolation=lo;qs.prototype.InterpolantFactoryMethodLinear=void 0;qs.prototype.InterpolantFactoryMethodSmooth=void 0;var vc=class extends fi{constructor(e,t,n,s){super(e,t,n,s)}};vc.prototype.ValueTypeName="color";var xc=class extends fi{constructor(e,t,n,s){super(e,t,n,s)}};xc.prototype.ValueTypeName="number";var yc=class extends $s{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(n-t)/(s-t),c=e*o;for(let h=c+o;c!==h;c+=4)qn.slerpFlat(r,0,a,c-o,a,c,l);return r}},Co=class extends fi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new yc(this.times,this.values,this.getValueSize(),e)}};Co.prototype.ValueTypeName="quaternion";Co.prototype.InterpolantFactoryMethodSmooth=void 0;var Ys=class extends fi{constructor(e,t,n){super(e,t,n)}};Ys.prototype.ValueTypeName="string";Ys.prototype.ValueBufferType=Array;Ys.prototype.DefaultInterpolation=lo;Ys.prototype.InterpolantFactoryMethodLinear=void 0;Ys.prototype.InterpolantFactoryMethodSmooth=void 0;var bc=class extends fi{constructor(e,t,n,s){super(e,t,n,s)}};bc.prototype.ValueTypeName="vector";var Sc=class{constructor(e,t,n){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],m=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},fm=new Sc,Mc=class{constructor(e){this.manager=e!==void 0?e:fm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Mc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ro=class extends kn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new je(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Iu=new Xt,bp=new V,Sp=new V,wc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ze(512,512),this.mapType=ti,this.map=null,this.mapPass=null,this.matrix=new Xt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Xs,this._frameExtents=new ze(1,1),this._viewportCount=1,this._viewports=[new tn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;bp.setFromMatrixPosition(e.matrixWorld),t.position.copy(bp),Sp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Sp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Iu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Iu,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===ca||e.reversedDepth?t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),t.multiply(Iu)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Ol=new V,Fl=new qn,Ki=new V,Po=class extends kn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Xt,this.projectionMatrix=new Xt,this.projectionMatrixInverse=new Xt,this.coordinateSystem=bi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ol,Fl,Ki),Ki.x===1&&Ki.y===1&&Ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ol,Fl,Ki.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Ol,Fl,Ki),Ki.x===1&&Ki.y===1&&Ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ol,Fl,Ki.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Gs=new V,Mp=new ze,wp=new ze,ui=class extends Po{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ua*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(so*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ua*2*Math.atan(Math.tan(so*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Gs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Gs.x,Gs.y).multiplyScalar(-e/Gs.z),Gs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Gs.x,Gs.y).multiplyScalar(-e/Gs.z)}getViewSize(e,t){return this.getViewBounds(e,Mp,wp),t.subVectors(wp,Mp)}setViewOffset(e,t,n,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(so*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var gr=class extends Po{constructor(e=-1,t=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,a=n+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Fu=class extends wc{constructor(){super(new gr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Lo=class extends Ro{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(kn.DEFAULT_UP),this.updateMatrix(),this.target=new kn,this.shadow=new Fu}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Io=class extends Ro{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var ra=-90,aa=1,ga=class extends kn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ui(ra,aa,e,t);s.layers=this.layers,this.add(s);let r=new ui(ra,aa,e,t);r.layers=this.layers,this.add(r);let a=new ui(ra,aa,e,t);a.layers=this.layers,this.add(a);let o=new ui(ra,aa,e,t);o.layers=this.layers,this.add(o);let l=new ui(ra,aa,e,t);l.layers=this.layers,this.add(l);let c=new ui(ra,aa,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,a,o,l]=t;for(let c of t)this.remove(c);if(e===bi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ca)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let _=!1;e.isWebGLRenderer===!0?_=e.state.buffers.depth.getReversed():_=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,f),e.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Ec=class extends ui{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var vd="\\[\\]\\.:\\/",fv=new RegExp("["+vd+"]","g"),xd="[^"+vd+"]",pv="[^"+vd.replace("\\.","")+"]",mv=/((?:WC+[\/:])*)/.source.replace("WC",xd),gv=/(WCOD+)?/.source.replace("WCOD",pv),_v=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",xd),vv=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",xd),xv=new RegExp("^"+mv+gv+_v+vv+"$"),yv=["material","materials","bones","map"],ku=class{constructor(e,t,n){let s=n||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},jt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(fv,"")}static parseTrackName(e){let t=xv.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);yv.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let l=n(o.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ot("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ot("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ot("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ot("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ot("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[s];if(a===void 0){let c=t.nodeName;ot("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=ku;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var R1=new Float32Array(1);var _a=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=mt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(mt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Bu=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var Do=class extends Di{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function yd(i,e,t,n){let s=bv(n);switch(t){case sd:return i*e;case ad:return i*e/s.components*s.byteLength;case Dc:return i*e/s.components*s.byteLength;case js:return i*e*2/s.components*s.byteLength;case Nc:return i*e*2/s.components*s.byteLength;case rd:return i*e*3/s.components*s.byteLength;case Fi:return i*e*4/s.components*s.byteLength;case Uc:return i*e*4/s.components*s.byteLength;case Oo:case Fo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ko:case Bo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Fc:case Bc:return Math.max(i,16)*Math.max(e,8)/4;case Oc:case kc:return Math.max(i,8)*Math.max(e,8)/2;case zc:case Vc:case Hc:case Wc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Gc:case zo:case Xc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case $c:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case qc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Yc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Zc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Jc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Kc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case jc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Qc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case eh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case th:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case nh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case ih:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case sh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case rh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case ah:case oh:case lh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case ch:case hh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Vo:case uh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function bv(i){switch(i){case ti:case ed:return{byteLength:1,components:1};case ba:case td:case Oi:return{byteLength:2,components:1};case Lc:case Ic:return{byteLength:2,components:4};case Ni:case Pc:case Ui:return{byteLength:4,components:1};case nd:case id:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Um(){let i=null,e=!1,t=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Mv(i){let e=new WeakMap;function t(o,l){let c=o.array,h=o.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),o.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:d}}function n(o,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,o),d.length===0)i.bufferSubData(c,0,h);else{d.sort((f,m)=>f.start-m.start);let u=0;for(let f=1;f<d.length;f++){let m=d[u],v=d[f];v.start<=m.start+m.count+1?m.count=Math.max(m.count,v.start+v.count-m.start):(++u,d[u]=v)}d.length=u+1;for(let f=0,m=d.length;f<m;f++){let v=d[f];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(i.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var wv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Ev=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Tv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Av=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Cv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Rv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Pv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Lv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Iv=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Dv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Nv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Uv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Ov=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Fv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,kv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Bv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,zv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Vv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Gv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Hv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Wv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Xv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,$v=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,qv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Yv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Zv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Jv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Kv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,jv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Qv="gl_FragColor = linearToOutputTexel( gl_FragColor );",ex=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,tx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,nx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ix=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,sx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,rx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,ax=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ox=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,lx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,cx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,hx=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,ux=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,dx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,fx=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,px=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,mx=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,gx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,_x=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,vx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,xx=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,yx=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,bx=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Sx=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Mx=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,wx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ex=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Tx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Ax=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Cx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Rx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Px=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Lx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Ix=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Dx=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Nx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Ux=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ox=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Fx=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,kx=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Bx=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,zx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Vx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Gx=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Hx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Wx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Xx=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,$x=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,qx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Yx=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Zx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Jx=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Kx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,jx=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Qx=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,ey=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ty=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,ny=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,iy=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,sy=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,ry=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,ay=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,oy=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,ly=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,cy=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,hy=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,uy=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,dy=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,fy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,py=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,my=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,gy=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,_y=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,vy=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,xy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,yy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,by=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Sy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,My=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,wy=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ey=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ty=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ay=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Cy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ry=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Py=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Ly=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Iy=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Dy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ny=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Uy=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Oy=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Fy=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,ky=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,By=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,zy=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vy=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Gy=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Hy=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Wy=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Xy=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$y=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qy=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Yy=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Zy=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Jy=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ky=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,jy=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Qy=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,eb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,tb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,nb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,gt={alphahash_fragment:wv,alphahash_pars_fragment:Ev,alphamap_fragment:Tv,alphamap_pars_fragment:Av,alphatest_fragment:Cv,alphatest_pars_fragment:Rv,aomap_fragment:Pv,aomap_pars_fragment:Lv,batching_pars_vertex:Iv,batching_vertex:Dv,begin_vertex:Nv,beginnormal_vertex:Uv,bsdfs:Ov,iridescence_fragment:Fv,bumpmap_pars_fragment:kv,clipping_planes_fragment:Bv,clipping_planes_pars_fragment:zv,clipping_planes_pars_vertex:Vv,clipping_planes_vertex:Gv,color_fragment:Hv,color_pars_fragment:Wv,color_pars_vertex:Xv,color_vertex:$v,common:qv,defaultnormal_vertex:Yv,displacementmap_pars_vertex:Zv,displacementmap_vertex:Jv,emissivemap_fragment:Kv,emissivemap_pars_fragment:jv,colorspace_fragment:Qv,colorspace_pars_fragment:ex,envmap_fragment:tx,envmap_common_pars_fragment:nx,envmap_pars_fragment:ix,envmap_pars_vertex:sx,envmap_physical_pars_fragment:mx,envmap_vertex:rx,fog_vertex:ax,fog_pars_vertex:ox,fog_fragment:lx,fog_pars_fragment:cx,gradientmap_pars_fragment:hx,lightmap_pars_fragment:ux,lights_lambert_fragment:dx,lights_lambert_pars_fragment:fx,lights_pars_begin:px,lights_toon_fragment:gx,lights_toon_pars_fragment:_x,lights_phong_fragment:vx,lights_phong_pars_fragment:xx,lights_physical_fragment:yx,lights_physical_pars_fragment:bx,lights_fragment_begin:Sx,lights_fragment_maps:Mx,lights_fragment_end:wx,lightprobes_pars_fragment:Ex,logdepthbuf_fragment:Tx,logdepthbuf_pars_fragment:Ax,logdepthbuf_pars_vertex:Cx,logdepthbuf_vertex:Rx,map_fragment:Px,map_pars_fragment:Lx,map_particle_fragment:Ix,map_particle_pars_fragment:Dx,metalnessmap_fragment:Nx,metalnessmap_pars_fragment:Ux,morphinstance_vertex:Ox,morphcolor_vertex:Fx,morphnormal_vertex:kx,morphtarget_pars_vertex:Bx,morphtarget_vertex:zx,normal_fragment_begin:Vx,normal_fragment_maps:Gx,normal_pars_fragment:Hx,normal_pars_vertex:Wx,normal_vertex:Xx,normalmap_pars_fragment:$x,clearcoat_normal_fragment_begin:qx,clearcoat_normal_fragment_maps:Yx,clearcoat_pars_fragment:Zx,iridescence_pars_fragment:Jx,opaque_fragment:Kx,packing:jx,premultiplied_alpha_fragment:Qx,project_vertex:ey,dithering_fragment:ty,dithering_pars_fragment:ny,roughnessmap_fragment:iy,roughnessmap_pars_fragment:sy,shadowmap_pars_fragment:ry,shadowmap_pars_vertex:ay,shadowmap_vertex:oy,shadowmask_pars_fragment:ly,skinbase_vertex:cy,skinning_pars_vertex:hy,skinning_vertex:uy,skinnormal_vertex:dy,specularmap_fragment:fy,specularmap_pars_fragment:py,tonemapping_fragment:my,tonemapping_pars_fragment:gy,transmission_fragment:_y,transmission_pars_fragment:vy,uv_pars_fragment:xy,uv_pars_vertex:yy,uv_vertex:by,worldpos_vertex:Sy,background_vert:My,background_frag:wy,backgroundCube_vert:Ey,backgroundCube_frag:Ty,cube_vert:Ay,cube_frag:Cy,depth_vert:Ry,depth_frag:Py,distance_vert:Ly,distance_frag:Iy,equirect_vert:Dy,equirect_frag:Ny,linedashed_vert:Uy,linedashed_frag:Oy,meshbasic_vert:Fy,meshbasic_frag:ky,meshlambert_vert:By,meshlambert_frag:zy,meshmatcap_vert:Vy,meshmatcap_frag:Gy,meshnormal_vert:Hy,meshnormal_frag:Wy,meshphong_vert:Xy,meshphong_frag:$y,meshphysical_vert:qy,meshphysical_frag:Yy,meshtoon_vert:Zy,meshtoon_frag:Jy,points_vert:Ky,points_frag:jy,shadow_vert:Qy,shadow_frag:eb,sprite_vert:tb,sprite_frag:nb},Ue={common:{diffuse:{value:new je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new ze(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new je(16777215)},opacity:{value:1},center:{value:new ze(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},ns={basic:{uniforms:Bn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:gt.meshbasic_vert,fragmentShader:gt.meshbasic_frag},lambert:{uniforms:Bn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new je(0)},envMapIntensity:{value:1}}]),vertexShader:gt.meshlambert_vert,fragmentShader:gt.meshlambert_frag},phong:{uniforms:Bn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new je(0)},specular:{value:new je(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:gt.meshphong_vert,fragmentShader:gt.meshphong_frag},standard:{uniforms:Bn([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag},toon:{uniforms:Bn([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new je(0)}}]),vertexShader:gt.meshtoon_vert,fragmentShader:gt.meshtoon_frag},matcap:{uniforms:Bn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:gt.meshmatcap_vert,fragmentShader:gt.meshmatcap_frag},points:{uniforms:Bn([Ue.points,Ue.fog]),vertexShader:gt.points_vert,fragmentShader:gt.points_frag},dashed:{uniforms:Bn([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:gt.linedashed_vert,fragmentShader:gt.linedashed_frag},depth:{uniforms:Bn([Ue.common,Ue.displacementmap]),vertexShader:gt.depth_vert,fragmentShader:gt.depth_frag},normal:{uniforms:Bn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:gt.meshnormal_vert,fragmentShader:gt.meshnormal_frag},sprite:{uniforms:Bn([Ue.sprite,Ue.fog]),vertexShader:gt.sprite_vert,fragmentShader:gt.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:gt.background_vert,fragmentShader:gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:gt.backgroundCube_vert,fragmentShader:gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:gt.cube_vert,fragmentShader:gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:gt.equirect_vert,fragmentShader:gt.equirect_frag},distance:{uniforms:Bn([Ue.common,Ue.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:gt.distance_vert,fragmentShader:gt.distance_frag},shadow:{uniforms:Bn([Ue.lights,Ue.fog,{color:{value:new je(0)},opacity:{value:1}}]),vertexShader:gt.shadow_vert,fragmentShader:gt.shadow_frag}};ns.physical={uniforms:Bn([ns.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new ze(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ct},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new ze},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new je(0)},specularColor:{value:new je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new ze},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag};var fh={r:0,b:0,g:0},ib=new Xt,Om=new ct;Om.set(-1,0,0,0,1,0,0,0,1);function sb(i,e,t,n,s,r){let a=new je(0),o=s===!0?0:1,l,c,h=null,d=0,u=null;function f(x){let T=x.isScene===!0?x.background:null;if(T&&T.isTexture){let S=x.backgroundBlurriness>0;T=e.get(T,S)}return T}function m(x){let T=!1,S=f(x);S===null?_(a,o):S&&S.isColor&&(_(S,1),T=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(x,T){let S=f(T);S&&S.isCubeTexture?(c===void 0&&(c=new dn(new Ms(1,1,1),new Qi({name:"BackgroundCubeMaterial",uniforms:br(ns.backgroundCube.uniforms),vertexShader:ns.backgroundCube.vertexShader,fragmentShader:ns.backgroundCube.fragmentShader,side:Zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,w,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(ib.makeRotationFromEuler(T.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Om),c.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,(h!==S||d!==S.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new dn(new wo(2,2),new Qi({name:"BackgroundMaterial",uniforms:br(ns.background.uniforms),vertexShader:ns.background.vertexShader,fragmentShader:ns.background.fragmentShader,side:Ks,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||d!==S.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function _(x,T){x.getRGB(fh,_d(i)),t.buffers.color.setClear(fh.r,fh.g,fh.b,T,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(x,T=1){a.set(x),o=T,_(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(x){o=x,_(a,o)},render:m,addToRenderList:v,dispose:g}}function rb(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,a=!1;function o(D,L,F,P,G){let q=!1,W=d(D,P,F,L);r!==W&&(r=W,c(r.object)),q=f(D,P,F,G),q&&m(D,P,F,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(q||a)&&(a=!1,S(D,L,F,P),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function d(D,L,F,P){let G=P.wireframe===!0,q=n[L.id];q===void 0&&(q={},n[L.id]=q);let W=D.isInstancedMesh===!0?D.id:0,he=q[W];he===void 0&&(he={},q[W]=he);let Z=he[F.id];Z===void 0&&(Z={},he[F.id]=Z);let Q=Z[G];return Q===void 0&&(Q=u(l()),Z[G]=Q),Q}function u(D){let L=[],F=[],P=[];for(let G=0;G<t;G++)L[G]=0,F[G]=0,P[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:L,enabledAttributes:F,attributeDivisors:P,object:D,attributes:{},index:null}}function f(D,L,F,P){let G=r.attributes,q=L.attributes,W=0,he=F.getAttributes();for(let Z in he)if(he[Z].location>=0){let te=G[Z],ue=q[Z];if(ue===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(ue=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(ue=D.instanceColor)),te===void 0||te.attribute!==ue||ue&&te.data!==ue.data)return!0;W++}return r.attributesNum!==W||r.index!==P}function m(D,L,F,P){let G={},q=L.attributes,W=0,he=F.getAttributes();for(let Z in he)if(he[Z].location>=0){let te=q[Z];te===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(te=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(te=D.instanceColor));let ue={};ue.attribute=te,te&&te.data&&(ue.data=te.data),G[Z]=ue,W++}r.attributes=G,r.attributesNum=W,r.index=P}function v(){let D=r.newAttributes;for(let L=0,F=D.length;L<F;L++)D[L]=0}function _(D){g(D,0)}function g(D,L){let F=r.newAttributes,P=r.enabledAttributes,G=r.attributeDivisors;F[D]=1,P[D]===0&&(i.enableVertexAttribArray(D),P[D]=1),G[D]!==L&&(i.vertexAttribDivisor(D,L),G[D]=L)}function x(){let D=r.newAttributes,L=r.enabledAttributes;for(let F=0,P=L.length;F<P;F++)L[F]!==D[F]&&(i.disableVertexAttribArray(F),L[F]=0)}function T(D,L,F,P,G,q,W){W===!0?i.vertexAttribIPointer(D,L,F,G,q):i.vertexAttribPointer(D,L,F,P,G,q)}function S(D,L,F,P){v();let G=P.attributes,q=F.getAttributes(),W=L.defaultAttributeValues;for(let he in q){let Z=q[he];if(Z.location>=0){let Q=G[he];if(Q===void 0&&(he==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),he==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let te=Q.normalized,ue=Q.itemSize,de=e.get(Q);if(de===void 0)continue;let j=de.buffer,me=de.type,ve=de.bytesPerElement,Ee=me===i.INT||me===i.UNSIGNED_INT||Q.gpuType===Pc;if(Q.isInterleavedBufferAttribute){let xe=Q.data,qe=xe.isInterleavedBuffer===!0?xe.stride:xe.itemSize,st=Q.offset;if(xe.isInstancedInterleavedBuffer||xe.isInstancedBufferAttribute){for(let ae=0;ae<Z.locationSize;ae++)g(Z.location+ae,xe.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=xe.meshPerAttribute*xe.count)}else for(let ae=0;ae<Z.locationSize;ae++)_(Z.location+ae);i.bindBuffer(i.ARRAY_BUFFER,j);for(let ae=0;ae<Z.locationSize;ae++)T(Z.location+ae,ue/Z.locationSize,me,te,qe*ve,(st+ue/Z.locationSize*ae)*ve,Ee)}else{if(Q.isInstancedBufferAttribute){for(let xe=0;xe<Z.locationSize;xe++)g(Z.location+xe,Q.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let xe=0;xe<Z.locationSize;xe++)_(Z.location+xe);i.bindBuffer(i.ARRAY_BUFFER,j);for(let xe=0;xe<Z.locationSize;xe++)T(Z.location+xe,ue/Z.locationSize,me,te,ue*ve,ue/Z.locationSize*xe*ve,Ee)}}else if(W!==void 0){let te=W[he];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(Z.location,te);break;case 3:i.vertexAttrib3fv(Z.location,te);break;case 4:i.vertexAttrib4fv(Z.location,te);break;default:i.vertexAttrib1fv(Z.location,te)}}}}x()}function R(){z();for(let D in n){let L=n[D];for(let F in L){let P=L[F];for(let G in P){let q=P[G];for(let W in q)h(q[W].object),delete q[W];delete P[G]}}delete n[D]}}function w(D){if(n[D.id]===void 0)return;let L=n[D.id];for(let F in L){let P=L[F];for(let G in P){let q=P[G];for(let W in q)h(q[W].object),delete q[W];delete P[G]}}delete n[D.id]}function y(D){for(let L in n){let F=n[L];for(let P in F){let G=F[P];if(G[D.id]===void 0)continue;let q=G[D.id];for(let W in q)h(q[W].object),delete q[W];delete G[D.id]}}}function C(D){for(let L in n){let F=n[L],P=D.isInstancedMesh===!0?D.id:0,G=F[P];if(G!==void 0){for(let q in G){let W=G[q];for(let he in W)h(W[he].object),delete W[he];delete G[q]}delete F[P],Object.keys(F).length===0&&delete n[L]}}}function z(){U(),a=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:z,resetDefaultState:U,dispose:R,releaseStatesOfGeometry:w,releaseStatesOfObject:C,releaseStatesOfProgram:y,initAttributes:v,enableAttribute:_,disableUnusedAttributes:x}}function ab(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function o(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];t.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function ob(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(y){return!(y!==Fi&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(y){let C=y===Oi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==ti&&y!==Ui&&!C&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),_=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:m,maxTextureSize:v,maxCubemapSize:_,maxAttributes:g,maxVertexUniforms:x,maxVaryings:T,maxFragmentUniforms:S,maxSamples:R,samples:w}}function lb(i){let e=this,t=null,n=0,s=!1,r=!1,a=new hi,o=new ct,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,f){let m=d.clippingPlanes,v=d.clipIntersection,_=d.clipShadows,g=i.get(d);if(!s||m===null||m.length===0||r&&!_)r?h(null):c();else{let x=r?0:n,T=x*4,S=g.clippingState||null;l.value=S,S=h(m,u,T,f);for(let R=0;R!==T;++R)S[R]=t[R];g.clippingState=S,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(d,u,f,m){let v=d!==null?d.length:0,_=null;if(v!==0){if(_=l.value,m!==!0||_===null){let g=f+v*4,x=u.matrixWorldInverse;o.getNormalMatrix(x),(_===null||_.length<g)&&(_=new Float32Array(g));for(let T=0,S=f;T!==v;++T,S+=4)a.copy(d[T]).applyMatrix4(x,o),a.normal.toArray(_,S),_[S+3]=a.constant}l.value=_,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,_}}var Wo=class extends di{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new xo(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ms(5,5,5),r=new Qi({name:"CubemapFromEquirect",uniforms:br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Zn,blending:_r});r.uniforms.tEquirect.value=t;let a=new dn(s,r),o=t.minFilter;return t.minFilter===ws&&(t.minFilter=$n),new ga(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,s);e.setRenderTarget(r)}},pm=256,cb=3,hb=20,Fm=256,km=16,ub=3,db=new V,fb=new je,mh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ga(1,10,null),this._boxMesh=new dn(new Ms(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:a=256,position:o=db}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(fb));let _=new ga(n,s,h);return _.position.copy(o),_.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=m,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=_m(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=gm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(pm,fd(e))}_fromTexture(e,t){e.mapping===xr||e.mapping===ya?this._setSize(e.image.length===0?pm:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=mm(e,!1,!1),n=Math.log2(e)-cb;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=mm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===xr||e.mapping===ya?(this._cubemapMaterial===null&&(this._cubemapMaterial=_m()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=gm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=pb(),this._integrationMaterial=mb());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/km);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-ub)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(Fm*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=gb());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function mm(i,e,t){return new Wo(i,{minFilter:ws,generateMipmaps:e,type:Oi,colorSpace:co,depthBuffer:t})}function Xo(i,e,t){return new Qi({name:i,uniforms:e,vertexShader:gt.cube_vert,fragmentShader:t,side:Zn,blending:_r,depthTest:!1,depthWrite:!1})}function pb(){return Xo("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Fm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function mb(){return Xo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:km}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function gb(){return Xo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${hb}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function gm(){return Xo("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function _m(){return Xo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function _b(i){let e=new WeakMap,t=new WeakMap,n=null;function s(u,f=!1){return u==null?null:f?a(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===Ac||f===Cc)if(e.has(u)){let m=e.get(u).texture;return o(m,u.mapping)}else{let m=u.image;if(m&&m.height>0){let v=new Wo(m.height);return v.fromEquirectangularTexture(i,u),e.set(u,v),u.addEventListener("dispose",c),o(v.texture,u.mapping)}else return null}}return u}function a(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,m=f===Ac||f===Cc,v=f===xr||f===ya;if(m||v){let _=t.get(u),g=_!==void 0?_.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return n===null&&(n=new mh(i)),_=m?n.fromEquirectangular(u,_):n.fromCubemap(u,_),_.texture.pmremVersion=u.pmremVersion,t.set(u,_),_.texture;if(_!==void 0)return _.texture;{let x=u.image;return m&&x&&x.height>0||v&&x&&l(x)?(n===null&&(n=new mh(i)),_=m?n.fromEquirectangular(u):n.fromCubemap(u),_.texture.pmremVersion=u.pmremVersion,t.set(u,_),u.addEventListener("dispose",h),_.texture):null}}}return u}function o(u,f){return f===Ac?u.mapping=xr:f===Cc&&(u.mapping=ya),u}function l(u){let f=0,m=6;for(let v=0;v<m;v++)u[v]!==void 0&&f++;return f===m}function c(u){let f=u.target;f.removeEventListener("dispose",c);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function vb(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&io("WebGLRenderer: "+n+" extension not supported."),s}}}function xb(i,e,t,n){let s={},r=new WeakMap,a=new FinalizationRegistry(m=>delete s[m]);function o(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let _ in m.attributes)e.remove(m.attributes[_]);m.removeEventListener("dispose",o),delete s[m.id],a.unregister(m);let v=r.get(m);v&&(e.remove(v),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,v){return s[v.id]!==void 0||(v.addEventListener("dispose",o),s[v.id]=new WeakRef(v),a.register(v,v.id,v),t.memory.geometries++),v}function h(m){let v=m.attributes;for(let _ in v)e.update(v[_],i.ARRAY_BUFFER)}function d(m){let v=m.index,_=m.attributes.position,g=0;if(_===void 0)return;let x=v!==null?v.array.length:_.array.length/3-1,T=_.count>=65535?_o:go,S=new T(Math.ceil(x/3)*6,1),R=S.array;if(v!==null){let y=v.array;g=v.version;for(let C=0,z=0;C<x;C+=3){let U=y[C+0],D=y[C+1],L=y[C+2];R[z++]=U,R[z++]=D,R[z++]=D,R[z++]=L,R[z++]=L,R[z++]=U}}else{g=_.version;for(let y=0,C=0;y<x;y+=3){let z=y+0,U=y+1,D=y+2;R[C++]=z,R[C++]=U,R[C++]=U,R[C++]=D,R[C++]=D,R[C++]=z}}S.version=g;let w=r.get(m);w&&e.remove(w),r.set(m,S)}function u(m){let v=r.get(m);if(v){let _=m.index;_!==null&&v.version<_.version&&d(m)}else d(m);return r.get(m)}function f(){for(let m in s){let v=s[m].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function yb(i,e,t){let n;function s(d){n=d}let r,a;function o(d){r=d.type,a=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*a),t.update(u,n,1)}function c(d,u,f){f!==0&&(i.drawElementsInstanced(n,u,r,d*a,f),t.update(u,n,f))}function h(d,u,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,f);let v=0;for(let _=0;_<f;_++)v+=u[_];t.update(v,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function bb(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(r/3);break;case i.LINES:t.lines+=o*(r/2);break;case i.LINE_STRIP:t.lines+=o*(r-1);break;case i.LINE_LOOP:t.lines+=o*r;break;case i.POINTS:t.points+=o*r;break;default:ot("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function Sb(i,e,t){let n=new WeakMap,s=new tn;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(o);if(u===void 0||u.count!==d){let z=function(){y.dispose(),n.delete(o),o.removeEventListener("dispose",z)};u!==void 0&&u.texture.dispose();let f=o.morphAttributes.position!==void 0,m=o.morphAttributes.normal!==void 0,v=o.morphAttributes.color!==void 0,_=o.morphAttributes.position||[],g=o.morphAttributes.normal||[],x=o.morphAttributes.color||[],T=0;f===!0&&(T=1),m===!0&&(T=2),v===!0&&(T=3);let S=o.attributes.position.count*T,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let w=new Float32Array(S*R*4*d),y=new fo(w,S,R,d);y.type=Ui,y.needsUpdate=!0;let C=T*4;for(let U=0;U<d;U++){let D=_[U],L=g[U],F=x[U],P=S*R*4*U;for(let G=0;G<D.count;G++){let q=G*C;f===!0&&(s.fromBufferAttribute(D,G),w[P+q+0]=s.x,w[P+q+1]=s.y,w[P+q+2]=s.z,w[P+q+3]=0),m===!0&&(s.fromBufferAttribute(L,G),w[P+q+4]=s.x,w[P+q+5]=s.y,w[P+q+6]=s.z,w[P+q+7]=0),v===!0&&(s.fromBufferAttribute(F,G),w[P+q+8]=s.x,w[P+q+9]=s.y,w[P+q+10]=s.z,w[P+q+11]=F.itemSize===4?s.w:1)}}u={count:d,texture:y,size:new ze(S,R)},n.set(o,u),o.addEventListener("dispose",z)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let m=o.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function Mb(i,e,t,n,s){let r=new WeakMap;function a(c){let h=s.render.frame,d=c.geometry,u=e.get(c,d);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}var wb={[$u]:"LINEAR_TONE_MAPPING",[qu]:"REINHARD_TONE_MAPPING",[Yu]:"CINEON_TONE_MAPPING",[Zu]:"ACES_FILMIC_TONE_MAPPING",[Ku]:"AGX_TONE_MAPPING",[ju]:"NEUTRAL_TONE_MAPPING",[Ju]:"CUSTOM_TONE_MAPPING"};function Eb(i,e,t,n,s,r){let a=new di(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new un;h.setAttribute("position",new $t([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new $t([0,2,0,0,2,0],2));let d=new uc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new dn(h,d),f=new gr(-1,1,1,-1,0,1),m=null,v=null,_=!1,g,x=null,T=[],S=!1;this.setSize=function(R,w){a.setSize(R,w),o!==null&&o.setSize(R,w),l!==null&&l.setSize(R,w);for(let y=0;y<T.length;y++){let C=T[y];C.setSize&&C.setSize(R,w)}},this.setEffects=function(R){T=R,S=T.length>0&&T[0].isRenderPass===!0;let w=a.width,y=a.height;T.length>0&&o===null&&(o=new di(w,y,{type:Oi,depthBuffer:!1,stencilBuffer:!1}),l=new di(w,y,{type:Oi,depthBuffer:!1,stencilBuffer:!1}));let C=s===!0&&T.some(z=>z.needsDepthTexture===!0);C!==(a.depthTexture!==null)&&(C===!0&&c===null&&(c=new Ss(w,y),r===!0&&(c.format=Es,c.type=yr)),a.dispose(),a.depthTexture=C?c:null,a.resolveDepthBuffer=C,a.storeMultisampledDepthBuffer=C);for(let z=0;z<T.length;z++){let U=T[z];U.setSize&&U.setSize(w,y),C&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(R,w){if(_||R.toneMapping===es&&T.length===0)return!1;if(x=w,w!==null){let y=w.width,C=w.height;(a.width!==y||a.height!==C)&&this.setSize(y,C)}return S===!1&&R.setRenderTarget(a),g=R.toneMapping,R.toneMapping=es,!0},this.hasRenderPass=function(){return S},this.end=function(R,w){R.toneMapping=g,_=!0;let y=a,C=o;for(let z=0;z<T.length;z++){let U=T[z];U.enabled!==!1&&(U.render(R,C,y,w),U.needsSwap!==!1&&(y=C,C=C===o?l:o))}if(m!==R.outputColorSpace||v!==R.toneMapping){m=R.outputColorSpace,v=R.toneMapping,d.defines={},St.getTransfer(m)===Dt&&(d.defines.SRGB_TRANSFER="");let z=wb[v];z&&(d.defines[z]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=y.texture,R.setRenderTarget(x),R.render(u,f),x=null,_=!1},this.isCompositing=function(){return _},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var Bm=new Qn,zm=new Ss(1,1),Vm=new yo(1),Gm=new fo,Hm=new jl,Wm=new xo,vm=[],xm=[],ym=new Float32Array(16),bm=new Float32Array(9),Sm=new Float32Array(4);function wa(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=vm[s];if(r===void 0&&(r=new Float32Array(s),vm[s]=r),e!==0){n.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(r,o)}return r}function bn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Sn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function _h(i,e){let t=xm[e];t===void 0&&(t=new Int32Array(e),xm[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Tb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function Ab(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2fv(this.addr,e),Sn(t,e)}}function Cb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(bn(t,e))return;i.uniform3fv(this.addr,e),Sn(t,e)}}function Rb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4fv(this.addr,e),Sn(t,e)}}function Pb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Sn(t,e)}else{if(bn(t,n))return;Sm.set(n),i.uniformMatrix2fv(this.addr,!1,Sm),Sn(t,n)}}function Lb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Sn(t,e)}else{if(bn(t,n))return;bm.set(n),i.uniformMatrix3fv(this.addr,!1,bm),Sn(t,n)}}function Ib(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Sn(t,e)}else{if(bn(t,n))return;ym.set(n),i.uniformMatrix4fv(this.addr,!1,ym),Sn(t,n)}}function Db(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Nb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2iv(this.addr,e),Sn(t,e)}}function Ub(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bn(t,e))return;i.uniform3iv(this.addr,e),Sn(t,e)}}function Ob(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4iv(this.addr,e),Sn(t,e)}}function Fb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function kb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2uiv(this.addr,e),Sn(t,e)}}function Bb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bn(t,e))return;i.uniform3uiv(this.addr,e),Sn(t,e)}}function zb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4uiv(this.addr,e),Sn(t,e)}}function vh(i){return i.version===0&&(i.compareFunction=cd,i.needsUpdate=!0),i}function Vb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=vh(zm):r=Bm,t.setTexture2D(e||r,s)}function Gb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Hm,s)}function Hb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=vh(Vm):r=Wm,t.setTextureCube(e||r,s)}function Wb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Gm,s)}function Xb(i){switch(i){case 5126:return Tb;case 35664:return Ab;case 35665:return Cb;case 35666:return Rb;case 35674:return Pb;case 35675:return Lb;case 35676:return Ib;case 5124:case 35670:return Db;case 35667:case 35671:return Nb;case 35668:case 35672:return Ub;case 35669:case 35673:return Ob;case 5125:return Fb;case 36294:return kb;case 36295:return Bb;case 36296:return zb;case 35678:case 36198:case 36298:case 36306:case 35682:return Vb;case 35679:case 36299:case 36307:return Gb;case 35680:case 36300:case 36308:case 36293:return Hb;case 36289:case 36303:case 36311:case 36292:return Wb}}function $b(i,e){i.uniform1fv(this.addr,e)}function qb(i,e){let t=wa(e,this.size,2);i.uniform2fv(this.addr,t)}function Yb(i,e){let t=wa(e,this.size,3);i.uniform3fv(this.addr,t)}function Zb(i,e){let t=wa(e,this.size,4);i.uniform4fv(this.addr,t)}function Jb(i,e){let t=wa(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Kb(i,e){let t=wa(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function jb(i,e){let t=wa(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Qb(i,e){i.uniform1iv(this.addr,e)}function eS(i,e){i.uniform2iv(this.addr,e)}function tS(i,e){i.uniform3iv(this.addr,e)}function nS(i,e){i.uniform4iv(this.addr,e)}function iS(i,e){i.uniform1uiv(this.addr,e)}function sS(i,e){i.uniform2uiv(this.addr,e)}function rS(i,e){i.uniform3uiv(this.addr,e)}function aS(i,e){i.uniform4uiv(this.addr,e)}function oS(i,e,t){let n=this.cache,s=e.length,r=_h(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=vh(zm):a=Bm;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function lS(i,e,t){let n=this.cache,s=e.length,r=_h(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||Hm,r[a])}function cS(i,e,t){let n=this.cache,s=e.length,r=_h(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=vh(Vm):a=Wm;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function hS(i,e,t){let n=this.cache,s=e.length,r=_h(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||Gm,r[a])}function uS(i){switch(i){case 5126:return $b;case 35664:return qb;case 35665:return Yb;case 35666:return Zb;case 35674:return Jb;case 35675:return Kb;case 35676:return jb;case 5124:case 35670:return Qb;case 35667:case 35671:return eS;case 35668:case 35672:return tS;case 35669:case 35673:return nS;case 5125:return iS;case 36294:return sS;case 36295:return rS;case 36296:return aS;case 35678:case 36198:case 36298:case 36306:case 35682:return oS;case 35679:case 36299:case 36307:return lS;case 35680:case 36300:case 36308:case 36293:return cS;case 36289:case 36303:case 36311:case 36292:return hS}}var Md=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Xb(t.type)}},wd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=uS(t.type)}},Ed=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],n)}}},bd=/(\w+)(\])?(\[|\.)?/g;function Mm(i,e){i.seq.push(e),i.map[e.id]=e}function dS(i,e,t){let n=i.name,s=n.length;for(bd.lastIndex=0;;){let r=bd.exec(n),a=bd.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Mm(t,c===void 0?new Md(o,i,e):new wd(o,i,e));break}else{let d=t.map[o];d===void 0&&(d=new Ed(o),Mm(t,d)),t=d}}}var Ma=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);dS(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&n.push(a)}return n}};function wm(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var fS=37297,pS=0;function mS(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}var Em=new ct;function gS(i){St._getMatrix(Em,St.workingColorSpace,i);let e=`mat3( ${Em.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(i)){case ho:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Tm(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+mS(i.getShaderSource(e),o)}else return r}function _S(i,e){let t=gS(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var vS={[$u]:"Linear",[qu]:"Reinhard",[Yu]:"Cineon",[Zu]:"ACESFilmic",[Ku]:"AgX",[ju]:"Neutral",[Ju]:"Custom"};function xS(i,e){let t=vS[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ph=new V;function yS(){St.getLuminanceCoefficients(ph);let i=ph.x.toFixed(4),e=ph.y.toFixed(4),t=ph.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function bS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ho).join(`
`)}function SS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function MS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function Ho(i){return i!==""}function Am(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Cm(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var wS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Td(i){return i.replace(wS,ES)}function ES(i,e){let t=gt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Td(t)}var TS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Rm(i){return i.replace(TS,AS)}function AS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Pm(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var CS={[No]:"SHADOWMAP_TYPE_PCF",[va]:"SHADOWMAP_TYPE_VSM"};function RS(i){return CS[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var PS={[ya]:"ENVMAP_MODE_REFRACTION"};function LS(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":PS[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var IS={[Tc]:"ENVMAP_BLENDING_MULTIPLY",[$p]:"ENVMAP_BLENDING_MIX",[qp]:"ENVMAP_BLENDING_ADD"};function DS(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":IS[i.combine]||"ENVMAP_BLENDING_NONE"}function NS(i,e,t,n){let s=i.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,l=RS(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=LS(t),d=DS(t),u=bS(t),f=SS(r),m=s.createProgram(),v,_,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ho).join(`
`),v.length>0&&(v+=`
`),_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ho).join(`
`),_.length>0&&(_+=`
`)):(v=[Pm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ho).join(`
`),_=[Pm(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==es?"#define TONE_MAPPING":"",t.toneMapping!==es?gt.tonemapping_pars_fragment:"",t.toneMapping!==es?xS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",gt.colorspace_pars_fragment,_S("linearToOutputTexel",t.outputColorSpace),yS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ho).join(`
`)),a=Td(a),a=Am(a,t),a=Cm(a,t),o=Td(o),o=Am(o,t),o=Cm(o,t),a=Rm(a),o=Rm(o),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,v=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,_=["#define varying in",t.glslVersion===hd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===hd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+_);let x=g+v+a,T=g+_+o,S=wm(s,s.VERTEX_SHADER,x),R=wm(s,s.FRAGMENT_SHADER,T);s.attachShader(m,S),s.attachShader(m,R),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function w(U){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(m)||"",L=s.getShaderInfoLog(S)||"",F=s.getShaderInfoLog(R)||"",P=D.trim(),G=L.trim(),q=F.trim(),W=!0,he=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(W=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,S,R);else{let Z=Tm(s,S,"vertex"),Q=Tm(s,R,"fragment");ot("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+P+`
`+Z+`
`+Q)}else P!==""?Ke("WebGLProgram: Program Info Log:",P):(G===""||q==="")&&(he=!1);he&&(U.diagnostics={runnable:W,programLog:P,vertexShader:{log:G,prefix:v},fragmentShader:{log:q,prefix:_}})}s.deleteShader(S),s.deleteShader(R),y=new Ma(s,m),C=MS(s,m)}let y;this.getUniforms=function(){return y===void 0&&w(this),y};let C;this.getAttributes=function(){return C===void 0&&w(this),C};let z=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return z===!1&&(z=s.getProgramParameter(m,fS)),z},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=pS++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=R,this}var US=0,Ad=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Cd(e),t.set(e,n)),n}},Cd=class{constructor(e){this.id=US++,this.code=e,this.usedTimes=0}};function OS(i){return i===js||i===zo||i===Vo}function FS(i,e,t,n,s,r){let a=new po,o=new Ad,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function m(y,C,z,U,D,L){let F=U.fog,P=D.geometry,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?U.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,W=e.get(y.envMap||G,q),he=u[y.type],Z=n.precision;y.precision!==null&&(Z=n.getMaxPrecision(y.precision),Z!==y.precision&&Ke("WebGLProgram.getParameters:",y.precision,"not supported, using",Z,"instead."));let Q=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,te=Q!==void 0?Q.length:0,ue=0;P.morphAttributes.position!==void 0&&(ue=1),P.morphAttributes.normal!==void 0&&(ue=2),P.morphAttributes.color!==void 0&&(ue=3);let de,j,me,ve;if(he){let Pe=ns[he];de=Pe.vertexShader,j=Pe.fragmentShader}else{de=y.vertexShader,j=y.fragmentShader;let Pe=o.getVertexShaderStage(y),dt=o.getFragmentShaderStage(y);o.update(y,Pe,dt),me=Pe.id,ve=dt.id}let Ee=i.getRenderTarget(),xe=i.state.buffers.depth.getReversed(),qe=D.isInstancedMesh===!0,st=D.isBatchedMesh===!0,ae=!!y.map,Xe=!!y.matcap,tt=!!W,rt=tt&&W.isPMREMTexture===!0,ft=!!y.aoMap,Ct=!!y.lightMap,qt=!!y.bumpMap&&y.wireframe===!1,wt=!!y.normalMap,sn=!!y.displacementMap,lt=!!y.emissiveMap,Bt=!!y.metalnessMap,Wt=!!y.roughnessMap,fn=y.anisotropy>0,B=y.clearcoat>0,Le=y.diffuseRoughness>0,Qe=y.dispersion>0,ut=y.retroreflectivity>0,Te=y.iridescence>0,Vt=y.sheen>0,$e=y.transmission>0,Je=fn&&!!y.anisotropyMap,I=B&&!!y.clearcoatMap,M=B&&!!y.clearcoatNormalMap,$=B&&!!y.clearcoatRoughnessMap,pe=Le&&!!y.diffuseRoughnessMap,le=Te&&!!y.iridescenceMap,be=Te&&!!y.iridescenceThicknessMap,Se=Vt&&!!y.sheenColorMap,ne=Vt&&!!y.sheenRoughnessMap,se=!!y.specularMap,_e=!!y.specularColorMap,k=!!y.specularIntensityMap,oe=$e&&!!y.transmissionMap,ie=$e&&!!y.thicknessMap,Ae=!!y.gradientMap,ye=!!y.alphaMap,we=y.alphaTest>0,Ye=!!y.alphaHash,nt=!!y.extensions,fe=es;y.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(fe=i.toneMapping);let Ve=rt?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,it={shaderID:he,shaderType:y.type,shaderName:y.name,vertexShader:de,fragmentShader:j,defines:y.defines,customVertexShaderID:me,customFragmentShaderID:ve,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Z,batching:st,batchingColor:st&&D._colorsTexture!==null,instancing:qe,instancingColor:qe&&D.instanceColor!==null,instancingMorph:qe&&D.morphTexture!==null,outputColorSpace:Ee===null?i.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:ae,matcap:Xe,envMap:tt,envMapMode:tt&&W.mapping,envMapPMREM:rt,envMapMaxLod:rt?Ve.length-1:null,envMapSize:rt?Ve[0].width:null,aoMap:ft,lightMap:Ct,bumpMap:qt,normalMap:wt,displacementMap:sn,emissiveMap:lt,normalMapObjectSpace:wt&&y.normalMapType===Jp,normalMapTangentSpace:wt&&y.normalMapType===dh,packedNormalMap:wt&&y.normalMapType===dh&&OS(y.normalMap.format),metalnessMap:Bt,roughnessMap:Wt,anisotropy:fn,anisotropyMap:Je,clearcoat:B,clearcoatMap:I,clearcoatNormalMap:M,clearcoatRoughnessMap:$,diffuseRoughness:Le,diffuseRoughnessMap:pe,dispersion:Qe,retroreflection:ut,iridescence:Te,iridescenceMap:le,iridescenceThicknessMap:be,sheen:Vt,sheenColorMap:Se,sheenRoughnessMap:ne,specularMap:se,specularColorMap:_e,specularIntensityMap:k,transmission:$e,transmissionMap:oe,thicknessMap:ie,gradientMap:Ae,opaque:y.transparent===!1&&y.blending===xa&&y.alphaToCoverage===!1,alphaMap:ye,alphaTest:we,alphaHash:Ye,combine:y.combine,mapUv:ae&&f(y.map.channel),aoMapUv:ft&&f(y.aoMap.channel),lightMapUv:Ct&&f(y.lightMap.channel),bumpMapUv:qt&&f(y.bumpMap.channel),normalMapUv:wt&&f(y.normalMap.channel),displacementMapUv:sn&&f(y.displacementMap.channel),emissiveMapUv:lt&&f(y.emissiveMap.channel),metalnessMapUv:Bt&&f(y.metalnessMap.channel),roughnessMapUv:Wt&&f(y.roughnessMap.channel),anisotropyMapUv:Je&&f(y.anisotropyMap.channel),clearcoatMapUv:I&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pe&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:le&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:be&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(y.sheenRoughnessMap.channel),specularMapUv:se&&f(y.specularMap.channel),specularColorMapUv:_e&&f(y.specularColorMap.channel),specularIntensityMapUv:k&&f(y.specularIntensityMap.channel),transmissionMapUv:oe&&f(y.transmissionMap.channel),thicknessMapUv:ie&&f(y.thicknessMap.channel),alphaMapUv:ye&&f(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(wt||fn),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!P.attributes.uv&&(ae||ye),fog:!!F,useFog:y.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&wt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:xe,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ue,numSunLights:C.sun.length,numDirLights:C.directional.length,numPointLights:C.point.length,numSpotLights:C.spot.length,numSpotLightMaps:C.spotLightMap.length,numRectAreaLights:C.rectArea.length,numHemiLights:C.hemi.length,numSunLightShadows:C.sunShadowMap.length,numDirLightShadows:C.directionalShadowMap.length,numPointLightShadows:C.pointShadowMap.length,numSpotLightShadows:C.spotShadowMap.length,numSpotLightShadowsWithMaps:C.numSpotLightShadowsWithMaps,numLightProbes:C.numLightProbes,numLightProbeGrids:L.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&z.length>0,shadowMapType:i.shadowMap.type,toneMapping:fe,decodeVideoTexture:ae&&y.map.isVideoTexture===!0&&St.getTransfer(y.map.colorSpace)===Dt,decodeVideoTextureEmissive:lt&&y.emissiveMap.isVideoTexture===!0&&St.getTransfer(y.emissiveMap.colorSpace)===Dt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===ei,flipSided:y.side===Zn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:nt&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(nt&&y.extensions.multiDraw===!0||st)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return it.vertexUv1s=l.has(1),it.vertexUv2s=l.has(2),it.vertexUv3s=l.has(3),l.clear(),it}function v(y){let C=[];if(y.shaderID?C.push(y.shaderID):(C.push(y.customVertexShaderID),C.push(y.customFragmentShaderID)),y.defines!==void 0)for(let z in y.defines)C.push(z),C.push(y.defines[z]);return y.isRawShaderMaterial===!1&&(_(C,y),g(C,y),C.push(i.outputColorSpace)),C.push(y.customProgramCacheKey),C.join()}function _(y,C){y.push(C.precision),y.push(C.outputColorSpace),y.push(C.envMapMode),y.push(C.envMapPMREM),y.push(C.envMapMaxLod),y.push(C.envMapSize),y.push(C.mapUv),y.push(C.alphaMapUv),y.push(C.lightMapUv),y.push(C.aoMapUv),y.push(C.bumpMapUv),y.push(C.normalMapUv),y.push(C.displacementMapUv),y.push(C.emissiveMapUv),y.push(C.metalnessMapUv),y.push(C.roughnessMapUv),y.push(C.anisotropyMapUv),y.push(C.clearcoatMapUv),y.push(C.clearcoatNormalMapUv),y.push(C.clearcoatRoughnessMapUv),y.push(C.diffuseRoughnessMapUv),y.push(C.iridescenceMapUv),y.push(C.iridescenceThicknessMapUv),y.push(C.sheenColorMapUv),y.push(C.sheenRoughnessMapUv),y.push(C.specularMapUv),y.push(C.specularColorMapUv),y.push(C.specularIntensityMapUv),y.push(C.transmissionMapUv),y.push(C.thicknessMapUv),y.push(C.combine),y.push(C.fogExp2),y.push(C.sizeAttenuation),y.push(C.morphTargetsCount),y.push(C.numSunLights),y.push(C.numDirLights),y.push(C.numPointLights),y.push(C.numSpotLights),y.push(C.numSpotLightMaps),y.push(C.numHemiLights),y.push(C.numRectAreaLights),y.push(C.numSunLightShadows),y.push(C.numDirLightShadows),y.push(C.numPointLightShadows),y.push(C.numSpotLightShadows),y.push(C.numSpotLightShadowsWithMaps),y.push(C.numLightProbes),y.push(C.numLightProbeGrids),y.push(C.shadowMapType),y.push(C.toneMapping),y.push(C.numClippingPlanes),y.push(C.numClipIntersection),y.push(C.depthPacking)}function g(y,C){a.disableAll(),C.instancing&&a.enable(0),C.instancingColor&&a.enable(1),C.instancingMorph&&a.enable(2),C.matcap&&a.enable(3),C.envMap&&a.enable(4),C.normalMapObjectSpace&&a.enable(5),C.normalMapTangentSpace&&a.enable(6),C.clearcoat&&a.enable(7),C.iridescence&&a.enable(8),C.alphaTest&&a.enable(9),C.vertexColors&&a.enable(10),C.vertexAlphas&&a.enable(11),C.vertexUv1s&&a.enable(12),C.vertexUv2s&&a.enable(13),C.vertexUv3s&&a.enable(14),C.vertexTangents&&a.enable(15),C.anisotropy&&a.enable(16),C.alphaHash&&a.enable(17),C.batching&&a.enable(18),C.dispersion&&a.enable(19),C.retroreflection&&a.enable(24),C.diffuseRoughness&&a.enable(25),C.batchingColor&&a.enable(20),C.gradientMap&&a.enable(21),C.packedNormalMap&&a.enable(22),C.vertexNormals&&a.enable(23),y.push(a.mask),a.disableAll(),C.fog&&a.enable(0),C.useFog&&a.enable(1),C.flatShading&&a.enable(2),C.logarithmicDepthBuffer&&a.enable(3),C.reversedDepthBuffer&&a.enable(4),C.skinning&&a.enable(5),C.morphTargets&&a.enable(6),C.morphNormals&&a.enable(7),C.morphColors&&a.enable(8),C.premultipliedAlpha&&a.enable(9),C.shadowMapEnabled&&a.enable(10),C.doubleSided&&a.enable(11),C.flipSided&&a.enable(12),C.useDepthPacking&&a.enable(13),C.dithering&&a.enable(14),C.transmission&&a.enable(15),C.sheen&&a.enable(16),C.opaque&&a.enable(17),C.pointsUvs&&a.enable(18),C.decodeVideoTexture&&a.enable(19),C.decodeVideoTextureEmissive&&a.enable(20),C.alphaToCoverage&&a.enable(21),C.numLightProbeGrids>0&&a.enable(22),C.hasPositionAttribute&&a.enable(23),y.push(a.mask)}function x(y){let C=u[y.type],z;if(C){let U=ns[C];z=um.clone(U.uniforms)}else z=y.uniforms;return z}function T(y,C){let z=h.get(C);return z!==void 0?++z.usedTimes:(z=new NS(i,C,y,s),c.push(z),h.set(C,z)),z}function S(y){if(--y.usedTimes===0){let C=c.indexOf(y);c[C]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function R(y){o.remove(y)}function w(){o.dispose()}return{getParameters:m,getProgramCacheKey:v,getUniforms:x,acquireProgram:T,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:w}}function kS(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function BS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Lm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Im(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function a(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function o(u,f,m,v,_,g){let x=i[e];return x===void 0?(x={id:u.id,object:u,geometry:f,material:m,materialVariant:a(u),groupOrder:v,renderOrder:u.renderOrder,z:_,group:g},i[e]=x):(x.id=u.id,x.object=u,x.geometry=f,x.material=m,x.materialVariant=a(u),x.groupOrder=v,x.renderOrder=u.renderOrder,x.z=_,x.group=g),e++,x}function l(u,f,m,v,_,g,x){x.reversedDepth===!0&&(_=-_);let T=o(u,f,m,v,_,g);m.transmission>0?n.push(T):m.transparent===!0?s.push(T):t.push(T)}function c(u,f,m,v,_,g){let x=o(u,f,m,v,_,g);m.transmission>0?n.unshift(x):m.transparent===!0?s.unshift(x):t.unshift(x)}function h(u,f){t.length>1&&t.sort(u||BS),n.length>1&&n.sort(f||Lm),s.length>1&&s.sort(f||Lm)}function d(){for(let u=e,f=i.length;u<f;u++){let m=i[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function zS(){let i=new WeakMap;function e(n,s){let r=i.get(n),a;return r===void 0?(a=new Im,i.set(n,[a])):s>=r.length?(a=new Im,r.push(a)):a=r[s],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function VS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new V,color:new je};break;case"SpotLight":t={position:new V,direction:new V,color:new je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new V,color:new je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new V,skyColor:new je,groundColor:new je};break;case"RectAreaLight":t={color:new je,position:new V,halfWidth:new V,halfHeight:new V};break}return i[e.id]=t,t}}}function GS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ze};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ze};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ze,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var HS=0;function WS(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function XS(i){let e=new VS,t=GS(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new V);let s=new V,r=new Xt,a=new Xt;function o(c){let h=0,d=0,u=0;for(let L=0;L<9;L++)n.probe[L].set(0,0,0);let f=0,m=0,v=0,_=0,g=0,x=0,T=0,S=0,R=0,w=0,y=0,C=0,z=0,U=0;c.sort(WS);for(let L=0,F=c.length;L<F;L++){let P=c[L],G=P.color,q=P.intensity,W=P.distance,he=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===js?he=P.shadow.map.texture:he=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=G.r*q,d+=G.g*q,u+=G.b*q;else if(P.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(P.sh.coefficients[Z],q);U++}else if(P.isSunLight){let Z=e.get(P);if(Z.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,te=t.get(P);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[m]=te,n.sunShadowMap[m]=he;let ue=Q.getViewportCount();for(let de=0;de<ue;de++)n.sunShadowMatrix[v+de]=Q.getMatrix(de),n.sunShadowCascade[v+de]=Q._cascadeData[de];v+=ue,m++}n.sun[f]=Z,f++}else if(P.isDirectionalLight){let Z=e.get(P);if(Z.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,te=t.get(P);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,n.directionalShadow[_]=te,n.directionalShadowMap[_]=he,n.directionalShadowMatrix[_]=P.shadow.matrix,R++}n.directional[_]=Z,_++}else if(P.isSpotLight){let Z=e.get(P);Z.position.setFromMatrixPosition(P.matrixWorld),Z.color.copy(G).multiplyScalar(q),Z.distance=W,Z.coneCos=Math.cos(P.angle),Z.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),Z.decay=P.decay,n.spot[x]=Z;let Q=P.shadow;if(P.map&&(n.spotLightMap[C]=P.map,C++,Q.updateMatrices(P),P.castShadow&&z++),n.spotLightMatrix[x]=Q.matrix,P.castShadow){let te=t.get(P);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,n.spotShadow[x]=te,n.spotShadowMap[x]=he,y++}x++}else if(P.isRectAreaLight){let Z=e.get(P);Z.color.copy(G).multiplyScalar(q),Z.halfWidth.set(P.width*.5,0,0),Z.halfHeight.set(0,P.height*.5,0),n.rectArea[T]=Z,T++}else if(P.isPointLight){let Z=e.get(P);if(Z.color.copy(P.color).multiplyScalar(P.intensity),Z.distance=P.distance,Z.decay=P.decay,P.castShadow){let Q=P.shadow,te=t.get(P);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,te.shadowCameraNear=Q.camera.near,te.shadowCameraFar=Q.camera.far,n.pointShadow[g]=te,n.pointShadowMap[g]=he,n.pointShadowMatrix[g]=P.shadow.matrix,w++}n.point[g]=Z,g++}else if(P.isHemisphereLight){let Z=e.get(P);Z.skyColor.copy(P.color).multiplyScalar(q),Z.groundColor.copy(P.groundColor).multiplyScalar(q),n.hemi[S]=Z,S++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ue.LTC_FLOAT_1,n.rectAreaLTC2=Ue.LTC_FLOAT_2):(n.rectAreaLTC1=Ue.LTC_HALF_1,n.rectAreaLTC2=Ue.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let D=n.hash;(D.sunLength!==f||D.directionalLength!==_||D.pointLength!==g||D.spotLength!==x||D.rectAreaLength!==T||D.hemiLength!==S||D.numSunShadows!==m||D.numDirectionalShadows!==R||D.numPointShadows!==w||D.numSpotShadows!==y||D.numSpotMaps!==C||D.numLightProbes!==U)&&(n.sun.length=f,n.directional.length=_,n.spot.length=x,n.rectArea.length=T,n.point.length=g,n.hemi.length=S,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+C-z,n.spotLightMap.length=C,n.numSpotLightShadowsWithMaps=z,n.numLightProbes=U,D.sunLength=f,D.directionalLength=_,D.pointLength=g,D.spotLength=x,D.rectAreaLength=T,D.hemiLength=S,D.numSunShadows=m,D.numDirectionalShadows=R,D.numPointShadows=w,D.numSpotShadows=y,D.numSpotMaps=C,D.numLightProbes=U,n.version=HS++)}function l(c,h){let d=0,u=0,f=0,m=0,v=0,_=0,g=h.matrixWorldInverse;for(let x=0,T=c.length;x<T;x++){let S=c[x];if(S.isSunLight){let R=n.sun[d];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(g),d++}else if(S.isDirectionalLight){let R=n.directional[u];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),u++}else if(S.isSpotLight){let R=n.spot[m];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(g),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(g),m++}else if(S.isRectAreaLight){let R=n.rectArea[v];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(g),a.identity(),r.copy(S.matrixWorld),r.premultiply(g),a.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(a),R.halfHeight.applyMatrix4(a),v++}else if(S.isPointLight){let R=n.point[f];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let R=n.hemi[_];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(g),_++}}}return{setup:o,setupView:l,state:n}}function Dm(i){let e=new XS(i),t=[],n=[],s=[];function r(d){h.camera=d,t.length=0,n.length=0,s.length=0}function a(d){d.isLightProbeGrid?s.push(d):t.push(d)}function o(d){n.push(d)}function l(){e.setup(t),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function $S(i){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new Dm(i),e.set(s,[o])):r>=a.length?(o=new Dm(i),a.push(o)):o=a[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}var qS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,YS=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,ZS=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],JS=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],Nm=new Xt,Go=new V,Sd=new V;function KS(i,e,t){let n=new Xs,s=new ze,r=new ze,a=new tn,o=new dc,l=new fc,c={},h=t.maxTextureSize,d={[Ks]:Zn,[Zn]:Ks,[ei]:ei},u=new Qi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ze},radius:{value:4}},vertexShader:qS,fragmentShader:YS}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let m=new un;m.setAttribute("position",new jn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new dn(m,u),_=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=No;let g=this.type;this.render=function(w,y,C){if(_.enabled===!1||_.autoUpdate===!1&&_.needsUpdate===!1||w.length===0)return;this.type===Ap&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=No);let z=i.getRenderTarget(),U=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),L=i.state;L.setBlending(_r),L.buffers.depth.getReversed()===!0?L.buffers.color.setClear(0,0,0,0):L.buffers.color.setClear(1,1,1,1),L.buffers.depth.setTest(!0),L.setScissorTest(!1);let F=g!==this.type;F&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(G=>G.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,G=w.length;P<G;P++){let q=w[P],W=q.shadow;if(W===void 0){Ke("WebGLShadowMap:",q,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let he=W.getFrameExtents();s.multiply(he),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/he.x),s.x=r.x*he.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/he.y),s.y=r.y*he.y,W.mapSize.y=r.y));let Z=i.state.buffers.depth.getReversed();if(W.camera._reversedDepth=Z,W.map===null||F===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===va){if(q.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new di(s.x,s.y,{format:js,type:Oi,minFilter:$n,magFilter:$n,generateMipmaps:!1}),W.map.texture.name=q.name+".shadowMap",W.map.depthTexture=new Ss(s.x,s.y,Ui),W.map.depthTexture.name=q.name+".shadowMapDepth",W.map.depthTexture.format=_s,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Ln,W.map.depthTexture.magFilter=Ln}else q.isPointLight?(W.map=new Wo(s.x),W.map.depthTexture=new yo(s.x,Ni)):(W.map=new di(s.x,s.y),W.map.depthTexture=new Ss(s.x,s.y,Ni)),W.map.depthTexture.name=q.name+".shadowMap",W.map.depthTexture.format=_s,this.type===No?(W.map.depthTexture.compareFunction=Z?ld:od,W.map.depthTexture.minFilter=$n,W.map.depthTexture.magFilter=$n):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Ln,W.map.depthTexture.magFilter=Ln);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let Q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();q.isPointLight!==!0&&W.updateMatrices(q,C);let te=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:C.layers;for(let ue=0;ue<Q;ue++){let de=W.getCamera(ue);if(q.isPointLight){let j=W.camera,me=W.matrix,ve=q.distance||j.far;ve!==j.far&&(j.far=ve,j.updateProjectionMatrix()),Go.setFromMatrixPosition(q.matrixWorld),j.position.copy(Go),Sd.copy(j.position),Sd.add(ZS[ue]),j.up.copy(JS[ue]),j.lookAt(Sd),j.updateMatrixWorld(),me.makeTranslation(-Go.x,-Go.y,-Go.z),Nm.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),W._frustum.setFromProjectionMatrix(Nm,j.coordinateSystem,j.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)i.setRenderTarget(W.map,ue),i.clear();else{ue===0&&(i.setRenderTarget(W.map),i.clear());let j=W.getViewport(ue);a.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),L.viewport(a)}n=W.getFrustum(ue),S(y,C,de,q,te,this.type)}W.isPointLightShadow!==!0&&this.type===va&&x(W,C),W.needsUpdate=!1}g=this.type,_.needsUpdate=!1,i.setRenderTarget(z,U,D)};function x(w,y){let C=e.update(v);u.defines.VSM_SAMPLES!==w.blurSamples&&(u.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new di(s.x,s.y,{format:js,type:Oi}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),u.uniforms.shadow_pass.value=w.map.depthTexture,u.uniforms.resolution.value.set(w.map.width,w.map.height),u.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(y,null,C,u,v,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(y,null,C,f,v,null)}function T(w,y,C,z){let U=null,D=C.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(D!==void 0)U=D;else if(U=C.isPointLight===!0?l:o,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let L=U.uuid,F=y.uuid,P=c[L];P===void 0&&(P={},c[L]=P);let G=P[F];G===void 0&&(G=U.clone(),P[F]=G,y.addEventListener("dispose",R)),U=G}if(U.visible=y.visible,U.wireframe=y.wireframe,z===va?U.side=y.shadowSide!==null?y.shadowSide:y.side:U.side=y.shadowSide!==null?y.shadowSide:d[y.side],U.alphaMap=y.alphaMap,U.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,U.map=y.map,U.clipShadows=y.clipShadows,U.clippingPlanes=y.clippingPlanes,U.clipIntersection=y.clipIntersection,U.displacementMap=y.displacementMap,U.displacementScale=y.displacementScale,U.displacementBias=y.displacementBias,U.wireframeLinewidth=y.wireframeLinewidth,U.linewidth=y.linewidth,C.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let L=i.properties.get(U);L.light=C}return U}function S(w,y,C,z,U,D){if(w.visible===!1)return;if(w.layers.test(U)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&D===va)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(C.matrixWorldInverse,w.matrixWorld);let P=e.update(w),G=w.material;if(Array.isArray(G)){let q=P.groups;for(let W=0,he=q.length;W<he;W++){let Z=q[W],Q=G[Z.materialIndex];if(Q&&Q.visible){let te=T(w,Q,z,D);w.onBeforeShadow(i,w,y,C,P,te,Z),i.renderBufferDirect(C,null,P,te,w,Z),w.onAfterShadow(i,w,y,C,P,te,Z)}}}else if(G.visible){let q=T(w,G,z,D);w.onBeforeShadow(i,w,y,C,P,q,null),i.renderBufferDirect(C,null,P,q,w,null),w.onAfterShadow(i,w,y,C,P,q,null)}}let F=w.children;for(let P=0,G=F.length;P<G;P++)S(F[P],y,C,z,U,D)}function R(w){w.target.removeEventListener("dispose",R);for(let C in c){let z=c[C],U=w.target.uuid;U in z&&(z[U].dispose(),delete z[U])}}}function jS(i,e){function t(){let k=!1,oe=new tn,ie=null,Ae=new tn(0,0,0,0);return{setMask:function(ye){ie!==ye&&!k&&(i.colorMask(ye,ye,ye,ye),ie=ye)},setLocked:function(ye){k=ye},setClear:function(ye,we,Ye,nt,fe){fe===!0&&(ye*=nt,we*=nt,Ye*=nt),oe.set(ye,we,Ye,nt),Ae.equals(oe)===!1&&(i.clearColor(ye,we,Ye,nt),Ae.copy(oe))},reset:function(){k=!1,ie=null,Ae.set(-1,0,0,0)}}}function n(){let k=!1,oe=!1,ie=null,Ae=null,ye=null;return{setReversed:function(we){if(oe!==we){let Ye=e.get("EXT_clip_control");we?Ye.clipControlEXT(Ye.LOWER_LEFT_EXT,Ye.ZERO_TO_ONE_EXT):Ye.clipControlEXT(Ye.LOWER_LEFT_EXT,Ye.NEGATIVE_ONE_TO_ONE_EXT),oe=we;let nt=ye;ye=null,this.setClear(nt)}},getReversed:function(){return oe},setTest:function(we){we?xe(i.DEPTH_TEST):qe(i.DEPTH_TEST)},setMask:function(we){ie!==we&&!k&&(i.depthMask(we),ie=we)},setFunc:function(we){if(oe&&(we=om[we]),Ae!==we){switch(we){case zl:i.depthFunc(i.NEVER);break;case Vl:i.depthFunc(i.ALWAYS);break;case Gl:i.depthFunc(i.LESS);break;case la:i.depthFunc(i.LEQUAL);break;case Hl:i.depthFunc(i.EQUAL);break;case Wl:i.depthFunc(i.GEQUAL);break;case Xl:i.depthFunc(i.GREATER);break;case $l:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ae=we}},setLocked:function(we){k=we},setClear:function(we){ye!==we&&(ye=we,oe&&(we=1-we),i.clearDepth(we))},reset:function(){k=!1,ie=null,Ae=null,ye=null,oe=!1}}}function s(){let k=!1,oe=null,ie=null,Ae=null,ye=null,we=null,Ye=null,nt=null,fe=null;return{setTest:function(Ve){k||(Ve?xe(i.STENCIL_TEST):qe(i.STENCIL_TEST))},setMask:function(Ve){oe!==Ve&&!k&&(i.stencilMask(Ve),oe=Ve)},setFunc:function(Ve,it,Pe){(ie!==Ve||Ae!==it||ye!==Pe)&&(i.stencilFunc(Ve,it,Pe),ie=Ve,Ae=it,ye=Pe)},setOp:function(Ve,it,Pe){(we!==Ve||Ye!==it||nt!==Pe)&&(i.stencilOp(Ve,it,Pe),we=Ve,Ye=it,nt=Pe)},setLocked:function(Ve){k=Ve},setClear:function(Ve){fe!==Ve&&(i.clearStencil(Ve),fe=Ve)},reset:function(){k=!1,oe=null,ie=null,Ae=null,ye=null,we=null,Ye=null,nt=null,fe=null}}}let r=new t,a=new n,o=new s,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,m=[],v=null,_=!1,g=null,x=null,T=null,S=null,R=null,w=null,y=null,C=new je(0,0,0),z=0,U=!1,D=null,L=null,F=null,P=null,G=null,q=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,he=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(he=parseFloat(/^WebGL (\d)/.exec(Z)[1]),W=he>=1):Z.indexOf("OpenGL ES")!==-1&&(he=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),W=he>=2);let Q=null,te={},ue=i.getParameter(i.SCISSOR_BOX),de=i.getParameter(i.VIEWPORT),j=new tn().fromArray(ue),me=new tn().fromArray(de);function ve(k,oe,ie,Ae){let ye=new Uint8Array(4),we=i.createTexture();i.bindTexture(k,we),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ye=0;Ye<ie;Ye++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(oe,0,i.RGBA,1,1,Ae,0,i.RGBA,i.UNSIGNED_BYTE,ye):i.texImage2D(oe+Ye,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ye);return we}let Ee={};Ee[i.TEXTURE_2D]=ve(i.TEXTURE_2D,i.TEXTURE_2D,1),Ee[i.TEXTURE_CUBE_MAP]=ve(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[i.TEXTURE_2D_ARRAY]=ve(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ee[i.TEXTURE_3D]=ve(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),xe(i.DEPTH_TEST),a.setFunc(la),qt(!1),wt(zu),xe(i.CULL_FACE),ft(_r);function xe(k){h[k]!==!0&&(i.enable(k),h[k]=!0)}function qe(k){h[k]!==!1&&(i.disable(k),h[k]=!1)}function st(k,oe){return u[k]!==oe?(i.bindFramebuffer(k,oe),u[k]=oe,k===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=oe),k===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=oe),!0):!1}function ae(k,oe){let ie=m,Ae=!1;if(k){ie=f.get(oe),ie===void 0&&(ie=[],f.set(oe,ie));let ye=k.textures;if(ie.length!==ye.length||ie[0]!==i.COLOR_ATTACHMENT0){for(let we=0,Ye=ye.length;we<Ye;we++)ie[we]=i.COLOR_ATTACHMENT0+we;ie.length=ye.length,Ae=!0}}else ie[0]!==i.BACK&&(ie[0]=i.BACK,Ae=!0);Ae&&i.drawBuffers(ie)}function Xe(k){return v!==k?(i.useProgram(k),v=k,!0):!1}let tt={[vr]:i.FUNC_ADD,[Rp]:i.FUNC_SUBTRACT,[Pp]:i.FUNC_REVERSE_SUBTRACT};tt[Lp]=i.MIN,tt[Ip]=i.MAX;let rt={[Dp]:i.ZERO,[Np]:i.ONE,[Up]:i.SRC_COLOR,[Wu]:i.SRC_ALPHA,[Vp]:i.SRC_ALPHA_SATURATE,[Bp]:i.DST_COLOR,[Fp]:i.DST_ALPHA,[Op]:i.ONE_MINUS_SRC_COLOR,[Xu]:i.ONE_MINUS_SRC_ALPHA,[zp]:i.ONE_MINUS_DST_COLOR,[kp]:i.ONE_MINUS_DST_ALPHA,[Gp]:i.CONSTANT_COLOR,[Hp]:i.ONE_MINUS_CONSTANT_COLOR,[Wp]:i.CONSTANT_ALPHA,[Xp]:i.ONE_MINUS_CONSTANT_ALPHA};function ft(k,oe,ie,Ae,ye,we,Ye,nt,fe,Ve){if(k===_r){_===!0&&(qe(i.BLEND),_=!1);return}if(_===!1&&(xe(i.BLEND),_=!0),k!==Cp){if(k!==g||Ve!==U){if((x!==vr||R!==vr)&&(i.blendEquation(i.FUNC_ADD),x=vr,R=vr),Ve)switch(k){case xa:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vu:i.blendFunc(i.ONE,i.ONE);break;case Gu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Hu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ot("WebGLState: Invalid blending: ",k);break}else switch(k){case xa:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Gu:ot("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Hu:ot("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ot("WebGLState: Invalid blending: ",k);break}T=null,S=null,w=null,y=null,C.set(0,0,0),z=0,g=k,U=Ve}return}ye=ye||oe,we=we||ie,Ye=Ye||Ae,(oe!==x||ye!==R)&&(i.blendEquationSeparate(tt[oe],tt[ye]),x=oe,R=ye),(ie!==T||Ae!==S||we!==w||Ye!==y)&&(i.blendFuncSeparate(rt[ie],rt[Ae],rt[we],rt[Ye]),T=ie,S=Ae,w=we,y=Ye),(nt.equals(C)===!1||fe!==z)&&(i.blendColor(nt.r,nt.g,nt.b,fe),C.copy(nt),z=fe),g=k,U=!1}function Ct(k,oe){k.side===ei?qe(i.CULL_FACE):xe(i.CULL_FACE);let ie=k.side===Zn;oe&&(ie=!ie),qt(ie),k.blending===xa&&k.transparent===!1?ft(_r):ft(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),a.setFunc(k.depthFunc),a.setTest(k.depthTest),a.setMask(k.depthWrite),r.setMask(k.colorWrite);let Ae=k.stencilWrite;o.setTest(Ae),Ae&&(o.setMask(k.stencilWriteMask),o.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),o.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),lt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?xe(i.SAMPLE_ALPHA_TO_COVERAGE):qe(i.SAMPLE_ALPHA_TO_COVERAGE)}function qt(k){D!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),D=k)}function wt(k){k!==Ep?(xe(i.CULL_FACE),k!==L&&(k===zu?i.cullFace(i.BACK):k===Tp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):qe(i.CULL_FACE),L=k}function sn(k){k!==F&&(W&&i.lineWidth(k),F=k)}function lt(k,oe,ie){k?(xe(i.POLYGON_OFFSET_FILL),(P!==oe||G!==ie)&&(P=oe,G=ie,a.getReversed()&&(oe=-oe,ie=-ie),i.polygonOffset(oe,ie))):qe(i.POLYGON_OFFSET_FILL)}function Bt(k){k?xe(i.SCISSOR_TEST):qe(i.SCISSOR_TEST)}function Wt(k){k===void 0&&(k=i.TEXTURE0+q-1),Q!==k&&(i.activeTexture(k),Q=k)}function fn(k,oe,ie){ie===void 0&&(Q===null?ie=i.TEXTURE0+q-1:ie=Q);let Ae=te[ie];Ae===void 0&&(Ae={type:void 0,texture:void 0},te[ie]=Ae),(Ae.type!==k||Ae.texture!==oe)&&(Q!==ie&&(i.activeTexture(ie),Q=ie),i.bindTexture(k,oe||Ee[k]),Ae.type=k,Ae.texture=oe)}function B(){let k=te[Q];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Le(){try{i.compressedTexImage2D(...arguments)}catch(k){ot("WebGLState:",k)}}function Qe(){try{i.compressedTexImage3D(...arguments)}catch(k){ot("WebGLState:",k)}}function ut(){try{i.texSubImage2D(...arguments)}catch(k){ot("WebGLState:",k)}}function Te(){try{i.texSubImage3D(...arguments)}catch(k){ot("WebGLState:",k)}}function Vt(){try{i.compressedTexSubImage2D(...arguments)}catch(k){ot("WebGLState:",k)}}function $e(){try{i.compressedTexSubImage3D(...arguments)}catch(k){ot("WebGLState:",k)}}function Je(){try{i.texStorage2D(...arguments)}catch(k){ot("WebGLState:",k)}}function I(){try{i.texStorage3D(...arguments)}catch(k){ot("WebGLState:",k)}}function M(){try{i.texImage2D(...arguments)}catch(k){ot("WebGLState:",k)}}function $(){try{i.texImage3D(...arguments)}catch(k){ot("WebGLState:",k)}}function pe(k){return d[k]!==void 0?d[k]:i.getParameter(k)}function le(k,oe){d[k]!==oe&&(i.pixelStorei(k,oe),d[k]=oe)}function be(k){j.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),j.copy(k))}function Se(k){me.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),me.copy(k))}function ne(k,oe){let ie=c.get(oe);ie===void 0&&(ie=new WeakMap,c.set(oe,ie));let Ae=ie.get(k);Ae===void 0&&(Ae=i.getUniformBlockIndex(oe,k.name),i.uniformBlockBinding(oe,Ae,Ae),ie.set(k,Ae))}function se(k,oe,ie){let ye=c.get(oe).get(k);l[ye]!==ie&&(i.bindBufferBase(i.UNIFORM_BUFFER,ye,ie),l[ye]=ie)}function _e(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,te={},u={},l={},f=new WeakMap,m=[],v=null,_=!1,g=null,x=null,T=null,S=null,R=null,w=null,y=null,C=new je(0,0,0),z=0,U=!1,D=null,L=null,F=null,P=null,G=null,j.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:xe,disable:qe,bindFramebuffer:st,drawBuffers:ae,useProgram:Xe,setBlending:ft,setMaterial:Ct,setFlipSided:qt,setCullFace:wt,setLineWidth:sn,setPolygonOffset:lt,setScissorTest:Bt,activeTexture:Wt,bindTexture:fn,unbindTexture:B,compressedTexImage2D:Le,compressedTexImage3D:Qe,texImage2D:M,texImage3D:$,pixelStorei:le,getParameter:pe,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:Je,texStorage3D:I,texSubImage2D:ut,texSubImage3D:Te,compressedTexSubImage2D:Vt,compressedTexSubImage3D:$e,scissor:be,viewport:Se,reset:_e}}function QS(i,e,t,n,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ze,h=new WeakMap,d=new Set,u,f=new WeakMap,m=new Set,v=new FinalizationRegistry(I=>m.delete(I)),_=!1;try{_=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,M){return _?new OffscreenCanvas(I,M):uo("canvas")}function x(I,M,$){let pe=1,le=Je(I);if((le.width>$||le.height>$)&&(pe=$/Math.max(le.width,le.height)),pe<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let be=Math.floor(pe*le.width),Se=Math.floor(pe*le.height);u===void 0&&(u=g(be,Se));let ne=M?g(be,Se):u;return ne.width=be,ne.height=Se,ne.getContext("2d").drawImage(I,0,0,be,Se),Ke("WebGLRenderer: Texture has been resized from ("+le.width+"x"+le.height+") to ("+be+"x"+Se+")."),ne}else return"data"in I&&Ke("WebGLRenderer: Image in DataTexture is too big ("+le.width+"x"+le.height+")."),I;return I}function T(I){return I.generateMipmaps}function S(I){i.generateMipmap(I)}function R(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(I,M,$,pe,le,be=!1){if(I!==null){if(i[I]!==void 0)return i[I];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let Se;pe&&(Se=e.get("EXT_texture_norm16"),Se||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=M;if(M===i.RED&&($===i.FLOAT&&(ne=i.R32F),$===i.HALF_FLOAT&&(ne=i.R16F),$===i.UNSIGNED_BYTE&&(ne=i.R8),$===i.UNSIGNED_SHORT&&Se&&(ne=Se.R16_EXT),$===i.SHORT&&Se&&(ne=Se.R16_SNORM_EXT)),M===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.R8UI),$===i.UNSIGNED_SHORT&&(ne=i.R16UI),$===i.UNSIGNED_INT&&(ne=i.R32UI),$===i.BYTE&&(ne=i.R8I),$===i.SHORT&&(ne=i.R16I),$===i.INT&&(ne=i.R32I)),M===i.RG&&($===i.FLOAT&&(ne=i.RG32F),$===i.HALF_FLOAT&&(ne=i.RG16F),$===i.UNSIGNED_BYTE&&(ne=i.RG8),$===i.UNSIGNED_SHORT&&Se&&(ne=Se.RG16_EXT),$===i.SHORT&&Se&&(ne=Se.RG16_SNORM_EXT)),M===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RG8UI),$===i.UNSIGNED_SHORT&&(ne=i.RG16UI),$===i.UNSIGNED_INT&&(ne=i.RG32UI),$===i.BYTE&&(ne=i.RG8I),$===i.SHORT&&(ne=i.RG16I),$===i.INT&&(ne=i.RG32I)),M===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGB8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGB16UI),$===i.UNSIGNED_INT&&(ne=i.RGB32UI),$===i.BYTE&&(ne=i.RGB8I),$===i.SHORT&&(ne=i.RGB16I),$===i.INT&&(ne=i.RGB32I)),M===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGBA16UI),$===i.UNSIGNED_INT&&(ne=i.RGBA32UI),$===i.BYTE&&(ne=i.RGBA8I),$===i.SHORT&&(ne=i.RGBA16I),$===i.INT&&(ne=i.RGBA32I)),M===i.RGB&&($===i.UNSIGNED_SHORT&&Se&&(ne=Se.RGB16_EXT),$===i.SHORT&&Se&&(ne=Se.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(ne=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(ne=i.R11F_G11F_B10F)),M===i.RGBA){let se=be?ho:St.getTransfer(le);$===i.FLOAT&&(ne=i.RGBA32F),$===i.HALF_FLOAT&&(ne=i.RGBA16F),$===i.UNSIGNED_BYTE&&(ne=se===Dt?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&Se&&(ne=Se.RGBA16_EXT),$===i.SHORT&&Se&&(ne=Se.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(ne=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(ne=i.RGB5_A1)}return(ne===i.R16F||ne===i.R32F||ne===i.RG16F||ne===i.RG32F||ne===i.RGBA16F||ne===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function y(I,M){let $;return I?M===null||M===Ni||M===yr?$=i.DEPTH24_STENCIL8:M===Ui?$=i.DEPTH32F_STENCIL8:M===ba&&($=i.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ni||M===yr?$=i.DEPTH_COMPONENT24:M===Ui?$=i.DEPTH_COMPONENT32F:M===ba&&($=i.DEPTH_COMPONENT16),$}function C(I,M){return T(I)===!0||I.isFramebufferTexture&&I.minFilter!==Ln&&I.minFilter!==$n?Math.log2(Math.max(M.width,M.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?M.mipmaps.length:1}function z(I){let M=new WeakRef(I);n.get(I).__ref=M,m.add(M),v.register(I,M,M)}function U(I){let M=n.get(I).__ref;M!==void 0&&(m.delete(M),v.unregister(M))}function D(I){F(I.target)}function L(I){P(I.target)}function F(I){I.removeEventListener("dispose",D),U(I),q(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&d.delete(I)}function P(I){I.removeEventListener("dispose",L),U(I),he(I)}function G(){for(let I of m){let M=I.deref();M!==void 0&&(M.isRenderTarget===!0?P(M):F(M))}m.clear(),d.clear()}function q(I){let M=n.get(I);if(M.__webglInit===void 0)return;let $=I.source,pe=f.get($);if(pe){let le=pe[M.__cacheKey];le.usedTimes--,le.usedTimes===0&&W(I),Object.keys(pe).length===0&&f.delete($)}n.remove(I)}function W(I){let M=n.get(I);i.deleteTexture(M.__webglTexture);let $=I.source,pe=f.get($);delete pe[M.__cacheKey],a.memory.textures--}function he(I){let M=n.get(I);M.__depthDisposeCallback&&M.__depthDisposeCallback();let $=I.depthTexture;if($&&$.renderTarget===I&&F($),I.isWebGLCubeRenderTarget)for(let le=0;le<6;le++){if(Array.isArray(M.__webglFramebuffer[le]))for(let be=0;be<M.__webglFramebuffer[le].length;be++)i.deleteFramebuffer(M.__webglFramebuffer[le][be]);else i.deleteFramebuffer(M.__webglFramebuffer[le]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[le])}else{if(Array.isArray(M.__webglFramebuffer))for(let le=0;le<M.__webglFramebuffer.length;le++)i.deleteFramebuffer(M.__webglFramebuffer[le]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let le=0;le<M.__webglColorRenderbuffer.length;le++)M.__webglColorRenderbuffer[le]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[le]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let pe=I.textures;for(let le=0,be=pe.length;le<be;le++){let Se=n.get(pe[le]);Se.__webglTexture&&(i.deleteTexture(Se.__webglTexture),a.memory.textures--),n.remove(pe[le])}n.remove(I)}let Z=0;function Q(){Z=0}function te(){return Z}function ue(I){Z=I}function de(){let I=Z;return I>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,I}function j(I){let M=[];return M.push(I.wrapS),M.push(I.wrapT),M.push(I.wrapR||0),M.push(I.magFilter),M.push(I.minFilter),M.push(I.anisotropy),M.push(I.internalFormat),M.push(I.format),M.push(I.type),M.push(I.generateMipmaps),M.push(I.mipmapsAutoUpdate),M.push(I.premultiplyAlpha),M.push(I.flipY),M.push(I.unpackAlignment),M.push(I.colorSpace),M.join()}function me(I,M){let $=n.get(I);if(I.isVideoTexture&&Vt(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&$.__version!==I.version){let pe=I.image;if(pe===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(pe.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Ct($,I,M);return}}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+M)}function ve(I,M){let $=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){Ct($,I,M);return}else I.isExternalTexture&&($.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+M)}function Ee(I,M){let $=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&$.__version!==I.version){Ct($,I,M);return}t.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+M)}function xe(I,M){let $=n.get(I);if(I.version>0&&$.__version!==I.version){qt($,I,M);return}t.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+M)}let qe={[ql]:i.REPEAT,[ji]:i.CLAMP_TO_EDGE,[Yl]:i.MIRRORED_REPEAT},st={[Ln]:i.NEAREST,[Yp]:i.NEAREST_MIPMAP_NEAREST,[Uo]:i.NEAREST_MIPMAP_LINEAR,[$n]:i.LINEAR,[Rc]:i.LINEAR_MIPMAP_NEAREST,[ws]:i.LINEAR_MIPMAP_LINEAR},ae={[jp]:i.NEVER,[cd]:i.ALWAYS,[Qp]:i.LESS,[od]:i.LEQUAL,[em]:i.EQUAL,[ld]:i.GEQUAL,[tm]:i.GREATER,[nm]:i.NOTEQUAL};function Xe(I,M){if(M.type===Ui&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===$n||M.magFilter===Rc||M.magFilter===Uo||M.magFilter===ws||M.minFilter===$n||M.minFilter===Rc||M.minFilter===Uo||M.minFilter===ws)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,qe[M.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,qe[M.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,qe[M.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,st[M.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,st[M.minFilter]),M.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,ae[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Ln||M.minFilter!==Uo&&M.minFilter!==ws||M.type===Ui&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function tt(I,M){let $=!1;I.__webglInit===void 0&&(I.__webglInit=!0,M.addEventListener("dispose",D),z(M));let pe=M.source,le=f.get(pe);le===void 0&&(le={},f.set(pe,le));let be=j(M);if(be!==I.__cacheKey){le[be]===void 0&&(le[be]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,$=!0),le[be].usedTimes++;let Se=le[I.__cacheKey];Se!==void 0&&(le[I.__cacheKey].usedTimes--,Se.usedTimes===0&&W(M)),I.__cacheKey=be,I.__webglTexture=le[be].texture}return $}function rt(I,M,$){return Math.floor(Math.floor(I/$)/M)}function ft(I,M,$,pe){let be=I.updateRanges;if(be.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,M.width,M.height,$,pe,M.data);else{be.sort((k,oe)=>k.start-oe.start);let Se=0;for(let k=1;k<be.length;k++){let oe=be[Se],ie=be[k],Ae=oe.start+oe.count,ye=rt(ie.start,M.width,4),we=rt(oe.start,M.width,4);ie.start<=Ae+1&&ye===we&&rt(ie.start+ie.count-1,M.width,4)===ye?oe.count=Math.max(oe.count,ie.start+ie.count-oe.start):(++Se,be[Se]=ie)}be.length=Se+1;let ne=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),_e=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,M.width);for(let k=0,oe=be.length;k<oe;k++){let ie=be[k],Ae=Math.floor(ie.start/4),ye=Math.ceil(ie.count/4),we=Ae%M.width,Ye=Math.floor(Ae/M.width),nt=ye,fe=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,we),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ye),t.texSubImage2D(i.TEXTURE_2D,0,we,Ye,nt,fe,$,pe,M.data)}I.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ne),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,_e)}}function Ct(I,M,$){let pe=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(pe=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(pe=i.TEXTURE_3D);let le=tt(I,M),be=M.source;t.bindTexture(pe,I.__webglTexture,i.TEXTURE0+$);let Se=n.get(be);if(be.version!==Se.__version||le===!0){if(t.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let fe=St.getPrimaries(St.workingColorSpace),Ve=M.colorSpace===Ts?null:St.getPrimaries(M.colorSpace),it=M.colorSpace===Ts||fe===Ve?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,it)}t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment);let se=x(M.image,!1,s.maxTextureSize);se=$e(M,se);let _e=r.convert(M.format,M.colorSpace),k=r.convert(M.type),oe=w(M.internalFormat,_e,k,M.normalized,M.colorSpace,M.isVideoTexture);Xe(pe,M);let ie,Ae=M.mipmaps,ye=M.isVideoTexture!==!0,we=Se.__version===void 0||le===!0,Ye=be.dataReady,nt=C(M,se);if(M.isDepthTexture)oe=y(M.format===Es,M.type),we&&(ye?t.texStorage2D(i.TEXTURE_2D,1,oe,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,_e,k,null));else if(M.isDataTexture)if(Ae.length>0){ye&&we&&t.texStorage2D(i.TEXTURE_2D,nt,oe,Ae[0].width,Ae[0].height);for(let fe=0,Ve=Ae.length;fe<Ve;fe++)ie=Ae[fe],ye?Ye&&t.texSubImage2D(i.TEXTURE_2D,fe,0,0,ie.width,ie.height,_e,k,ie.data):t.texImage2D(i.TEXTURE_2D,fe,oe,ie.width,ie.height,0,_e,k,ie.data);M.generateMipmaps=!1}else ye?(we&&t.texStorage2D(i.TEXTURE_2D,nt,oe,se.width,se.height),Ye&&ft(M,se,_e,k)):t.texImage2D(i.TEXTURE_2D,0,oe,se.width,se.height,0,_e,k,se.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ye&&we&&t.texStorage3D(i.TEXTURE_2D_ARRAY,nt,oe,Ae[0].width,Ae[0].height,se.depth);for(let fe=0,Ve=Ae.length;fe<Ve;fe++)if(ie=Ae[fe],M.format!==Fi)if(_e!==null)if(ye){if(Ye)if(M.layerUpdates.size>0){let it=yd(ie.width,ie.height,M.format,M.type);for(let Pe of M.layerUpdates){let dt=ie.data.subarray(Pe*it/ie.data.BYTES_PER_ELEMENT,(Pe+1)*it/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,fe,0,0,Pe,ie.width,ie.height,1,_e,dt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,fe,0,0,0,ie.width,ie.height,se.depth,_e,ie.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,fe,oe,ie.width,ie.height,se.depth,0,ie.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?Ye&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,fe,0,0,0,ie.width,ie.height,se.depth,_e,k,ie.data):t.texImage3D(i.TEXTURE_2D_ARRAY,fe,oe,ie.width,ie.height,se.depth,0,_e,k,ie.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ye&&we&&t.texStorage2D(i.TEXTURE_2D,nt,oe,Ae[0].width,Ae[0].height);for(let fe=0,Ve=Ae.length;fe<Ve;fe++)ie=Ae[fe],M.format!==Fi?_e!==null?ye?Ye&&t.compressedTexSubImage2D(i.TEXTURE_2D,fe,0,0,ie.width,ie.height,_e,ie.data):t.compressedTexImage2D(i.TEXTURE_2D,fe,oe,ie.width,ie.height,0,ie.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?Ye&&t.texSubImage2D(i.TEXTURE_2D,fe,0,0,ie.width,ie.height,_e,k,ie.data):t.texImage2D(i.TEXTURE_2D,fe,oe,ie.width,ie.height,0,_e,k,ie.data)}else if(M.isDataArrayTexture)if(ye){if(we&&t.texStorage3D(i.TEXTURE_2D_ARRAY,nt,oe,se.width,se.height,se.depth),Ye)if(M.layerUpdates.size>0){let fe=yd(se.width,se.height,M.format,M.type);for(let Ve of M.layerUpdates){let it=se.data.subarray(Ve*fe/se.data.BYTES_PER_ELEMENT,(Ve+1)*fe/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ve,se.width,se.height,1,_e,k,it)}M.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,_e,k,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,oe,se.width,se.height,se.depth,0,_e,k,se.data);else if(M.isData3DTexture)ye?(we&&t.texStorage3D(i.TEXTURE_3D,nt,oe,se.width,se.height,se.depth),Ye&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,_e,k,se.data)):t.texImage3D(i.TEXTURE_3D,0,oe,se.width,se.height,se.depth,0,_e,k,se.data);else if(M.isFramebufferTexture){if(we)if(ye)t.texStorage2D(i.TEXTURE_2D,nt,oe,se.width,se.height);else{let fe=se.width,Ve=se.height;for(let it=0;it<nt;it++)t.texImage2D(i.TEXTURE_2D,it,oe,fe,Ve,0,_e,k,null),fe>>=1,Ve>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in i){let fe=i.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),se.parentNode!==fe){fe.appendChild(se),d.add(M),fe.onpaint=Ve=>{let it=Ve.changedElements;for(let Pe of d)it.includes(Pe.image)&&(Pe.needsUpdate=!0)},fe.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let it=i.RGBA,Pe=i.RGBA,dt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,it,Pe,dt,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(ye&&we){let fe=Je(Ae[0]);t.texStorage2D(i.TEXTURE_2D,nt,oe,fe.width,fe.height)}for(let fe=0,Ve=Ae.length;fe<Ve;fe++)ie=Ae[fe],ye?Ye&&t.texSubImage2D(i.TEXTURE_2D,fe,0,0,_e,k,ie):t.texImage2D(i.TEXTURE_2D,fe,oe,_e,k,ie);M.generateMipmaps=!1}else if(ye){if(we){let fe=Je(se);t.texStorage2D(i.TEXTURE_2D,nt,oe,fe.width,fe.height)}Ye&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,_e,k,se)}else t.texImage2D(i.TEXTURE_2D,0,oe,_e,k,se);T(M)&&M.mipmapsAutoUpdate===!0&&S(pe),Se.__version=be.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function qt(I,M,$){if(M.image.length!==6)return;let pe=tt(I,M),le=M.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+$);let be=n.get(le);if(le.version!==be.__version||pe===!0){t.activeTexture(i.TEXTURE0+$);let Se=St.getPrimaries(St.workingColorSpace),ne=M.colorSpace===Ts?null:St.getPrimaries(M.colorSpace),se=M.colorSpace===Ts||Se===ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let _e=M.isCompressedTexture||M.image[0].isCompressedTexture,k=M.image[0]&&M.image[0].isDataTexture,oe=[];for(let Pe=0;Pe<6;Pe++)!_e&&!k?oe[Pe]=x(M.image[Pe],!0,s.maxCubemapSize):oe[Pe]=k?M.image[Pe].image:M.image[Pe],oe[Pe]=$e(M,oe[Pe]);let ie=oe[0],Ae=r.convert(M.format,M.colorSpace),ye=r.convert(M.type),we=w(M.internalFormat,Ae,ye,M.normalized,M.colorSpace),Ye=M.isVideoTexture!==!0,nt=be.__version===void 0||pe===!0,fe=le.dataReady,Ve=C(M,ie);Xe(i.TEXTURE_CUBE_MAP,M);let it;if(M.isDepthTexture){if(we=y(M.format===Es,M.type),nt)if(Ye)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,we,ie.width,ie.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,ie.width,ie.height,0,Ae,ye,null)}else if(_e){Ye&&nt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ve,we,ie.width,ie.height);for(let Pe=0;Pe<6;Pe++){it=oe[Pe].mipmaps;for(let dt=0;dt<it.length;dt++){let Yt=it[dt];M.format!==Fi?Ae!==null?Ye?fe&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt,0,0,Yt.width,Yt.height,Ae,Yt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt,we,Yt.width,Yt.height,0,Yt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt,0,0,Yt.width,Yt.height,Ae,ye,Yt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt,we,Yt.width,Yt.height,0,Ae,ye,Yt.data)}}}else{if(it=M.mipmaps,Ye&&nt){it.length>0&&Ve++;let Pe=Je(oe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ve,we,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(k){Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,oe[Pe].width,oe[Pe].height,Ae,ye,oe[Pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,oe[Pe].width,oe[Pe].height,0,Ae,ye,oe[Pe].data);for(let dt=0;dt<it.length;dt++){let zn=it[dt].image[Pe].image;Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt+1,0,0,zn.width,zn.height,Ae,ye,zn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt+1,we,zn.width,zn.height,0,Ae,ye,zn.data)}}else{Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Ae,ye,oe[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,Ae,ye,oe[Pe]);for(let dt=0;dt<it.length;dt++){let Yt=it[dt];Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt+1,0,0,Ae,ye,Yt.image[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt+1,we,Ae,ye,Yt.image[Pe])}}}T(M)&&M.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),be.__version=le.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function wt(I,M,$,pe,le,be){let Se=r.convert($.format,$.colorSpace),ne=r.convert($.type),se=w($.internalFormat,Se,ne,$.normalized,$.colorSpace),_e=n.get(M),k=n.get($);if(k.__renderTarget=M,!_e.__hasExternalTextures){let oe=Math.max(1,M.width>>be),ie=Math.max(1,M.height>>be);le===i.TEXTURE_3D||le===i.TEXTURE_2D_ARRAY?t.texImage3D(le,be,se,oe,ie,M.depth,0,Se,ne,null):t.texImage2D(le,be,se,oe,ie,0,Se,ne,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),Te(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,le,k.__webglTexture,0,ut(M)):(le===i.TEXTURE_2D||le>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&le<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,pe,le,k.__webglTexture,be),t.bindFramebuffer(i.FRAMEBUFFER,null)}function sn(I,M,$){if(i.bindRenderbuffer(i.RENDERBUFFER,I),M.depthBuffer){let pe=M.depthTexture,le=pe&&pe.isDepthTexture?pe.type:null,be=y(M.stencilBuffer,le),Se=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Te(M)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ut(M),be,M.width,M.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,ut(M),be,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,be,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Se,i.RENDERBUFFER,I)}else{let pe=M.textures;for(let le=0;le<pe.length;le++){let be=pe[le],Se=r.convert(be.format,be.colorSpace),ne=r.convert(be.type),se=w(be.internalFormat,Se,ne,be.normalized,be.colorSpace);Te(M)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ut(M),se,M.width,M.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,ut(M),se,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,se,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function lt(I,M,$){let pe=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let le=n.get(M.depthTexture);le.__renderTarget=M;let be=pe?M.depthTexture.image[0]:M.depthTexture.image;(!le.__webglTexture||be.width!==M.width||be.height!==M.height)&&(be.width=M.width,be.height=M.height,M.depthTexture.needsUpdate=!0),pe?xe(M.depthTexture,0):me(M.depthTexture,0);let Se=le.__webglTexture,ne=ut(M),se=pe?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,_e=M.depthTexture.format===Es?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(M.depthTexture.format===_s)Te(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_e,se,Se,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,_e,se,Se,0);else if(M.depthTexture.format===Es)Te(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_e,se,Se,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,_e,se,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Bt(I){let M=n.get(I),$=I.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==I.depthTexture){let pe=I.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),pe){let le=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,pe.removeEventListener("dispose",le)};pe.addEventListener("dispose",le),M.__depthDisposeCallback=le}M.__boundDepthTexture=pe}if(I.depthTexture&&!M.__autoAllocateDepthBuffer)if($)for(let pe=0;pe<6;pe++)lt(M.__webglFramebuffer[pe],I,pe);else I.texture.mipmaps.length>0?lt(M.__webglFramebuffer[0],I,0):lt(M.__webglFramebuffer,I,0);else if($){M.__webglDepthbuffer=[];for(let pe=0;pe<6;pe++)if(t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[pe]),M.__webglDepthbuffer[pe]===void 0)M.__webglDepthbuffer[pe]=i.createRenderbuffer(),sn(M.__webglDepthbuffer[pe],I,!1);else{let le=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=M.__webglDepthbuffer[pe];i.bindRenderbuffer(i.RENDERBUFFER,be),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,be)}}else if(I.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),sn(M.__webglDepthbuffer,I,!1);else{let le=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,be),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,be)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Wt(I,M,$){let pe=n.get(I);M!==void 0&&wt(pe.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&Bt(I)}function fn(I){let M=I.texture,$=n.get(I),pe=n.get(M);I.addEventListener("dispose",L),z(I);let le=I.textures,be=I.isWebGLCubeRenderTarget===!0,Se=le.length>1;if(Se||(pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture()),pe.__version=M.version,a.memory.textures++),be){$.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(M.mipmaps.length>0){$.__webglFramebuffer[ne]=[];for(let se=0;se<M.mipmaps.length;se++)$.__webglFramebuffer[ne][se]=i.createFramebuffer()}else $.__webglFramebuffer[ne]=i.createFramebuffer()}else{if(M.mipmaps.length>0){$.__webglFramebuffer=[];for(let ne=0;ne<M.mipmaps.length;ne++)$.__webglFramebuffer[ne]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(Se)for(let ne=0,se=le.length;ne<se;ne++){let _e=n.get(le[ne]);_e.__webglTexture===void 0&&(_e.__webglTexture=i.createTexture(),a.memory.textures++)}if(I.samples>0&&Te(I)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ne=0;ne<le.length;ne++){let se=le[ne];$.__webglColorRenderbuffer[ne]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[ne]);let _e=r.convert(se.format,se.colorSpace),k=r.convert(se.type),oe=w(se.internalFormat,_e,k,se.normalized,se.colorSpace,I.isXRRenderTarget===!0),ie=ut(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,ie,oe,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ne,i.RENDERBUFFER,$.__webglColorRenderbuffer[ne])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),sn($.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(be){t.bindTexture(i.TEXTURE_CUBE_MAP,pe.__webglTexture),Xe(i.TEXTURE_CUBE_MAP,M);for(let ne=0;ne<6;ne++)if(M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)wt($.__webglFramebuffer[ne][se],I,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else wt($.__webglFramebuffer[ne],I,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);T(M)?S(i.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let ne=0,se=le.length;ne<se;ne++){let _e=le[ne],k=n.get(_e),oe=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(oe=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(oe,k.__webglTexture),Xe(oe,_e),wt($.__webglFramebuffer,I,_e,i.COLOR_ATTACHMENT0+ne,oe,0),T(_e)&&S(oe)}t.unbindTexture()}else{let ne=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ne=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,pe.__webglTexture),Xe(ne,M),M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)wt($.__webglFramebuffer[se],I,M,i.COLOR_ATTACHMENT0,ne,se);else wt($.__webglFramebuffer,I,M,i.COLOR_ATTACHMENT0,ne,0);T(M)?S(ne):M.mipmaps.length>0&&i.texParameteri(ne,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}I.depthBuffer&&Bt(I)}function B(I){let M=I.textures;for(let $=0,pe=M.length;$<pe;$++){let le=M[$];if(T(le)&&le.mipmapsAutoUpdate===!0){let be=R(I),Se=n.get(le).__webglTexture;t.bindTexture(be,Se),S(be),t.unbindTexture()}}}let Le=[];function Qe(I){if(I.samples>0){if(Te(I)===!1){let M=I.textures,$=I.width,pe=I.height,le=i.COLOR_BUFFER_BIT,be=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Se=n.get(I),ne=M.length>1;if(ne)for(let _e=0;_e<M.length;_e++)t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let _e=0;_e<M.length;_e++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(le|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(le|=i.STENCIL_BUFFER_BIT)),ne){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Se.__webglColorRenderbuffer[_e]);let k=n.get(M[_e]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,k,0)}i.blitFramebuffer(0,0,$,pe,0,0,$,pe,le,i.NEAREST),l===!0&&(Le.length=0,Le.push(i.COLOR_ATTACHMENT0+_e),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Le.push(be),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ne)for(let _e=0;_e<M.length;_e++){t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.RENDERBUFFER,Se.__webglColorRenderbuffer[_e]);let k=n.get(M[_e]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.TEXTURE_2D,k,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let M=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function ut(I){return Math.min(s.maxSamples,I.samples)}function Te(I){let M=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Vt(I){let M=a.render.frame;h.get(I)!==M&&(h.set(I,M),I.update())}function $e(I,M){let $=I.colorSpace,pe=I.format,le=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||$!==co&&$!==Ts&&(St.getTransfer($)===Dt?(pe!==Fi||le!==ti)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ot("WebGLTextures: Unsupported texture color space:",$)),M}function Je(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=Q,this.getTextureUnits=te,this.setTextureUnits=ue,this.setTexture2D=me,this.setTexture2DArray=ve,this.setTexture3D=Ee,this.setTextureCube=xe,this.rebindTextures=Wt,this.setupRenderTarget=fn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Qe,this.setupDepthRenderbuffer=Bt,this.setupFrameBufferTexture=wt,this.useMultisampledRTT=Te,this.dispose=G}function eM(i,e){function t(n,s=Ts){let r,a=St.getTransfer(s);if(n===ti)return i.UNSIGNED_BYTE;if(n===Lc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Ic)return i.UNSIGNED_SHORT_5_5_5_1;if(n===nd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===id)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===ed)return i.BYTE;if(n===td)return i.SHORT;if(n===ba)return i.UNSIGNED_SHORT;if(n===Pc)return i.INT;if(n===Ni)return i.UNSIGNED_INT;if(n===Ui)return i.FLOAT;if(n===Oi)return i.HALF_FLOAT;if(n===sd)return i.ALPHA;if(n===rd)return i.RGB;if(n===Fi)return i.RGBA;if(n===_s)return i.DEPTH_COMPONENT;if(n===Es)return i.DEPTH_STENCIL;if(n===ad)return i.RED;if(n===Dc)return i.RED_INTEGER;if(n===js)return i.RG;if(n===Nc)return i.RG_INTEGER;if(n===Uc)return i.RGBA_INTEGER;if(n===Oo||n===Fo||n===ko||n===Bo)if(a===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Oo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Fo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ko)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Bo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Oo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Fo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ko)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Bo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Oc||n===Fc||n===kc||n===Bc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Oc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Fc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===kc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Bc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===zc||n===Vc||n===Gc||n===Hc||n===Wc||n===zo||n===Xc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===zc||n===Vc)return a===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Gc)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Hc)return r.COMPRESSED_R11_EAC;if(n===Wc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===zo)return r.COMPRESSED_RG11_EAC;if(n===Xc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===$c||n===qc||n===Yc||n===Zc||n===Jc||n===Kc||n===jc||n===Qc||n===eh||n===th||n===nh||n===ih||n===sh||n===rh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===$c)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===qc)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Yc)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Zc)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Jc)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Kc)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===jc)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Qc)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===eh)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===th)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===nh)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ih)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===sh)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===rh)return a===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===ah||n===oh||n===lh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===ah)return a===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===oh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===lh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===ch||n===hh||n===Vo||n===uh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===ch)return r.COMPRESSED_RED_RGTC1_EXT;if(n===hh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Vo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===uh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===yr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var tM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,nM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Rd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new bo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Qi({vertexShader:tM,fragmentShader:nM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new dn(new wo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Pd=class extends Di{constructor(e,t){super();let n=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,m=null,v=typeof XRWebGLBinding<"u",_=new Rd,g={},x=t.getContextAttributes(),T=null,S=null,R=[],w=[],y=new ze,C=null,z=null,U=new ui;U.viewport=new tn;let D=new ui;D.viewport=new tn;let L=[U,D],F=new Ec,P=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let me=R[j];return me===void 0&&(me=new fa,R[j]=me),me.getTargetRaySpace()},this.getControllerGrip=function(j){let me=R[j];return me===void 0&&(me=new fa,R[j]=me),me.getGripSpace()},this.getHand=function(j){let me=R[j];return me===void 0&&(me=new fa,R[j]=me),me.getHandSpace()};function q(j){let me=w.indexOf(j.inputSource);if(me===-1)return;let ve=R[me];ve!==void 0&&(ve.update(j.inputSource,j.frame,c||a),ve.dispatchEvent({type:j.type,data:j.inputSource}))}function W(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",he);for(let j=0;j<R.length;j++){let me=w[j];me!==null&&(w[j]=null,R[j].disconnect(me))}P=null,G=null,_.reset();for(let j in g)delete g[j];if(e.setRenderTarget(T),f=null,u=null,d=null,s=null,S=null,de.stop(),n.isPresenting=!1,e.setPixelRatio(C),e.setSize(y.width,y.height,!1),z!==null){let j=z.camera;j.fov=z.fov,j.zoom=z.zoom,j.updateProjectionMatrix(),z=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,n.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){o=j,n.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",W),s.addEventListener("inputsourceschange",he),x.xrCompatible!==!0&&await t.makeXRCompatible(),C=e.getPixelRatio(),e.getSize(y),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ee=null,xe=null;x.depth&&(xe=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=x.stencil?Es:_s,Ee=x.stencil?yr:Ni);let qe={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(qe),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),S=new di(u.textureWidth,u.textureHeight,{format:Fi,type:ti,depthTexture:new Ss(u.textureWidth,u.textureHeight,Ee,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let ve={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new di(f.framebufferWidth,f.framebufferHeight,{format:Fi,type:ti,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),de.setContext(s),de.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function he(j){for(let me=0;me<j.removed.length;me++){let ve=j.removed[me],Ee=w.indexOf(ve);Ee>=0&&(w[Ee]=null,R[Ee].disconnect(ve))}for(let me=0;me<j.added.length;me++){let ve=j.added[me],Ee=w.indexOf(ve);if(Ee===-1){for(let qe=0;qe<R.length;qe++)if(qe>=w.length){w.push(ve),Ee=qe;break}else if(w[qe]===null){w[qe]=ve,Ee=qe;break}if(Ee===-1)break}let xe=R[Ee];xe&&xe.connect(ve)}}function Z(j,me){me===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(me.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let me=j.near,ve=j.far;_.texture!==null&&(_.depthNear>0&&(me=_.depthNear),_.depthFar>0&&(ve=_.depthFar)),F.near=D.near=U.near=me,F.far=D.far=U.far=ve,(P!==F.near||G!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),P=F.near,G=F.far),F.layers.mask=j.layers.mask|6,U.layers.mask=F.layers.mask&-5,D.layers.mask=F.layers.mask&-3;let Ee=j.parent,xe=F.cameras;Z(F,Ee);for(let qe=0;qe<xe.length;qe++)Z(xe[qe],Ee);F.projectionMatrix.copy(U.projectionMatrix),F.projectionMatrixInverse.copy(U.projectionMatrixInverse),z===null&&j.isPerspectiveCamera&&(z={camera:j,fov:j.fov,zoom:j.zoom}),Q(j,F,Ee)};function Q(j,me,ve){ve===null?j.matrix.copy(me.matrixWorld):(j.matrix.copy(ve.matrixWorld),j.matrix.invert(),j.matrix.multiply(me.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(me.projectionMatrix),j.projectionMatrixInverse.copy(me.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=ua*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(j){l=j,u!==null&&(u.fixedFoveation=j),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=j)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(F)},this.getCameraTexture=function(j){return g[j]};let te=null;function ue(j,me){if(h=me.getViewerPose(c||a),m=me,h!==null){let ve=h.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let Ee=!1;ve.length!==F.cameras.length&&(F.cameras.length=0,Ee=!0);for(let ae=0;ae<ve.length;ae++){let Xe=ve[ae],tt=null;if(f!==null)tt=f.getViewport(Xe);else{let ft=d.getViewSubImage(u,Xe);tt=ft.viewport,ae===0&&(e.setRenderTargetTextures(S,ft.colorTexture,ft.depthStencilTexture),e.setRenderTarget(S))}let rt=L[ae];rt===void 0&&(rt=new ui,rt.layers.enable(ae),rt.viewport=new tn,L[ae]=rt),rt.matrix.fromArray(Xe.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(Xe.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(tt.x,tt.y,tt.width,tt.height),ae===0&&(F.matrix.copy(rt.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),Ee===!0&&F.cameras.push(rt)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=n.getBinding();let ae=d.getDepthInformation(ve[0]);ae&&ae.isValid&&ae.texture&&_.init(ae,s.renderState)}if(xe&&xe.includes("camera-access")&&v){e.state.unbindTexture(),d=n.getBinding();for(let ae=0;ae<ve.length;ae++){let Xe=ve[ae].camera;if(Xe){let tt=g[Xe];tt||(tt=new bo,g[Xe]=tt);let rt=d.getCameraImage(Xe);tt.sourceTexture=rt}}}}for(let ve=0;ve<R.length;ve++){let Ee=w[ve],xe=R[ve];Ee!==null&&xe!==void 0&&xe.update(Ee,me,c||a)}te&&te(j,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),m=null}let de=new Um;de.setAnimationLoop(ue),this.setAnimationLoop=function(j){te=j},this.dispose=function(){}}},iM=new Xt,Xm=new ct;Xm.set(-1,0,0,0,1,0,0,0,1);function sM(i,e){function t(_,g){_.matrixAutoUpdate===!0&&_.updateMatrix(),g.value.copy(_.matrix)}function n(_,g){g.color.getRGB(_.fogColor.value,_d(i)),g.isFog?(_.fogNear.value=g.near,_.fogFar.value=g.far):g.isFogExp2&&(_.fogDensity.value=g.density)}function s(_,g,x,T,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(_,g):g.isMeshLambertMaterial?(r(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(_,g),d(_,g)):g.isMeshPhongMaterial?(r(_,g),h(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(_,g),u(_,g),g.isMeshPhysicalMaterial&&f(_,g,S)):g.isMeshMatcapMaterial?(r(_,g),m(_,g)):g.isMeshDepthMaterial?r(_,g):g.isMeshDistanceMaterial?(r(_,g),v(_,g)):g.isMeshNormalMaterial?r(_,g):g.isLineBasicMaterial?(a(_,g),g.isLineDashedMaterial&&o(_,g)):g.isPointsMaterial?l(_,g,x,T):g.isSpriteMaterial?c(_,g):g.isShadowMaterial?(_.color.value.copy(g.color),_.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(_,g){_.opacity.value=g.opacity,g.color&&_.diffuse.value.copy(g.color),g.emissive&&_.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.bumpMap&&(_.bumpMap.value=g.bumpMap,t(g.bumpMap,_.bumpMapTransform),_.bumpScale.value=g.bumpScale,g.side===Zn&&(_.bumpScale.value*=-1)),g.normalMap&&(_.normalMap.value=g.normalMap,t(g.normalMap,_.normalMapTransform),_.normalScale.value.copy(g.normalScale),g.side===Zn&&_.normalScale.value.negate()),g.displacementMap&&(_.displacementMap.value=g.displacementMap,t(g.displacementMap,_.displacementMapTransform),_.displacementScale.value=g.displacementScale,_.displacementBias.value=g.displacementBias),g.emissiveMap&&(_.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,_.emissiveMapTransform)),g.specularMap&&(_.specularMap.value=g.specularMap,t(g.specularMap,_.specularMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest);let x=e.get(g),T=x.envMap,S=x.envMapRotation;T&&(_.envMap.value=T,_.envMapRotation.value.setFromMatrix4(iM.makeRotationFromEuler(S)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&_.envMapRotation.value.premultiply(Xm),_.reflectivity.value=g.reflectivity,_.ior.value=g.ior,_.refractionRatio.value=g.refractionRatio),g.lightMap&&(_.lightMap.value=g.lightMap,_.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,_.lightMapTransform)),g.aoMap&&(_.aoMap.value=g.aoMap,_.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,_.aoMapTransform))}function a(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform))}function o(_,g){_.dashSize.value=g.dashSize,_.totalSize.value=g.dashSize+g.gapSize,_.scale.value=g.scale}function l(_,g,x,T){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.size.value=g.size*x,_.scale.value=T*.5,g.map&&(_.map.value=g.map,t(g.map,_.uvTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function c(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.rotation.value=g.rotation,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function h(_,g){_.specular.value.copy(g.specular),_.shininess.value=Math.max(g.shininess,1e-4)}function d(_,g){g.gradientMap&&(_.gradientMap.value=g.gradientMap)}function u(_,g){_.metalness.value=g.metalness,g.metalnessMap&&(_.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,_.metalnessMapTransform)),_.roughness.value=g.roughness,g.roughnessMap&&(_.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,_.roughnessMapTransform)),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)}function f(_,g,x){_.ior.value=g.ior,g.diffuseRoughness>0&&(_.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(_.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,_.diffuseRoughnessMapTransform))),g.sheen>0&&(_.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),_.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(_.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,_.sheenColorMapTransform)),g.sheenRoughnessMap&&(_.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,_.sheenRoughnessMapTransform))),g.clearcoat>0&&(_.clearcoat.value=g.clearcoat,_.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(_.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,_.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(_.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,_.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(_.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,_.clearcoatNormalMapTransform),_.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Zn&&_.clearcoatNormalScale.value.negate())),g.dispersion>0&&(_.dispersion.value=g.dispersion),g.retroreflectivity>0&&(_.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(_.iridescence.value=g.iridescence,_.iridescenceIOR.value=g.iridescenceIOR,_.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,_.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(_.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,_.iridescenceMapTransform)),g.iridescenceThicknessMap&&(_.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,_.iridescenceThicknessMapTransform))),g.transmission>0&&(_.transmission.value=g.transmission,_.transmissionSamplerMap.value=x.texture,_.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(_.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,_.transmissionMapTransform)),_.thickness.value=g.thickness,g.thicknessMap&&(_.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,_.thicknessMapTransform)),_.attenuationDistance.value=g.attenuationDistance,_.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(_.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(_.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,_.anisotropyMapTransform))),_.specularIntensity.value=g.specularIntensity,_.specularColor.value.copy(g.specularColor),g.specularColorMap&&(_.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,_.specularColorMapTransform)),g.specularIntensityMap&&(_.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,_.specularIntensityMapTransform))}function m(_,g){g.matcap&&(_.matcap.value=g.matcap)}function v(_,g){let x=e.get(g).light;_.referencePosition.value.setFromMatrixPosition(x.matrixWorld),_.nearDistance.value=x.shadow.camera.near,_.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function rM(i,e,t,n){let s={},r={};function a(x,T){let S=T.program;n.uniformBlockBinding(x,S,s[x.id])}function o(x,T){let S=s[x.id];S===void 0&&(m(x),S=l(x),s[x.id]=S,x.addEventListener("dispose",_));let R=T.program;n.updateUBOMapping(x,R);let w=e.render.frame;r[x.id]!==w&&(c(x),r[x.id]=w)}function l(x){let T=i.createBuffer(),S=x.__size,R=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,S,R),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(x){let T=s[x.id],S=x.uniforms,R=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let w=0,y=S.length;w<y;w++){let C=S[w];if(Array.isArray(C))for(let z=0,U=C.length;z<U;z++)h(C[z],w,z,R);else h(C,w,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,T,S,R){if(u(x,T,S,R)===!0){let w=x.__offset,y=x.value;if(Array.isArray(y)){let C=0;for(let z=0;z<y.length;z++){let U=y[z],D=v(U,!0);d(U,x.__data,C),C+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(y,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,x.__data)}}function d(x,T,S){typeof x=="number"||typeof x=="boolean"?T[S]=x:x.isMatrix3?(T[S]=x.elements[0],T[S+1]=x.elements[1],T[S+2]=x.elements[2],T[S+3]=0,T[S+4]=x.elements[3],T[S+5]=x.elements[4],T[S+6]=x.elements[5],T[S+7]=0,T[S+8]=x.elements[6],T[S+9]=x.elements[7],T[S+10]=x.elements[8],T[S+11]=0):ArrayBuffer.isView(x)?T.set(x.subarray(0,T.length-S),S):x.toArray(T,S)}function u(x,T,S,R){let w=x.value,y=T+"_"+S;if(Array.isArray(w)){R[y]===void 0&&(R[y]=[]);let C=R[y],z=!1;for(let U=0;U<w.length;U++)f(w[U],C,U)===!0&&(z=!0);return z}return f(w,R,y)}function f(x,T,S){if(T[S]===void 0)return typeof x=="number"||typeof x=="boolean"?T[S]=x:ArrayBuffer.isView(x)?T[S]=x.slice():T[S]=x.clone(),!0;{let R=T[S];if(typeof x=="number"||typeof x=="boolean"){if(R!==x)return T[S]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(R.equals(x)===!1)return R.copy(x),!0}}return!1}function m(x){let T=x.uniforms,S=0,R=16;for(let y=0,C=T.length;y<C;y++){let z=Array.isArray(T[y])?T[y]:[T[y]];for(let U=0,D=z.length;U<D;U++){let L=z[U],F=Array.isArray(L.value)?L.value:[L.value],P=Array.isArray(T[y])||Array.isArray(L.value),G=S;for(let W=0,he=F.length;W<he;W++){let Z=F[W],Q=v(Z,P),te=S%R,ue=te%Q.boundary,de=te+ue;S+=ue,de!==0&&R-de<Q.storage&&(S+=R-de),W===0&&(G=S),S+=Q.storage}let q=L.type==="int"?Int32Array:L.type==="uint"?Uint32Array:Float32Array;L.__data=new q((S-G)/Float32Array.BYTES_PER_ELEMENT),L.__offset=G}}let w=S%R;return w>0&&(S+=R-w),x.__size=S,x.__cache={},this}function v(x,T){let S={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(S.boundary=4,S.storage=4):x.isVector2?(S.boundary=8,S.storage=8):x.isVector3||x.isColor?(S.boundary=16,S.storage=12):x.isVector4?(S.boundary=16,S.storage=16):x.isMatrix3?(S.boundary=16,S.storage=48):x.isMatrix4?(S.boundary=16,S.storage=64):x.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(S.boundary=16,S.storage=x.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",x),T===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function _(x){let T=x.target;T.removeEventListener("dispose",_),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function g(){for(let x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:a,update:o,dispose:g}}var aM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ts=null;function oM(){return ts===null&&(ts=new ec(aM,16,16,js,Oi),ts.name="DFG_LUT",ts.minFilter=$n,ts.magFilter=$n,ts.wrapS=ji,ts.wrapT=ji,ts.generateMipmaps=!1,ts.needsUpdate=!0),ts}var gh=class{constructor(e={}){let{canvas:t=sm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=ti}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=a;let v=f,_=new Set([Uc,Nc,Dc]),g=new Set([ti,Ni,ba,yr,Lc,Ic]),x=new Uint32Array(4),T=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,w=null,y=[],C=[],z=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=es,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,D=!1,L=null,F=null,P=null,G=null;this._outputColorSpace=ci;let q=0,W=0,he=null,Z=-1,Q=null,te=new tn,ue=new tn,de=null,j=new je(0),me=0,ve=t.width,Ee=t.height,xe=1,qe=null,st=null,ae=new tn(0,0,ve,Ee),Xe=new tn(0,0,ve,Ee),tt=!1,rt=new Xs,ft=new tc,Ct=!1,qt=!1,wt=new Xt,sn=new V,lt=new tn,Bt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Wt=!1;function fn(){return he===null?xe:1}let B=n;function Le(A,H){return t.getContext(A,H)}let Qe,ut,Te,Vt,$e,Je,I,M,$,pe,le,be,Se,ne,se,_e,k,oe,ie,Ae,ye,we,Ye;try{let A={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",it,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),B===null){let H="webgl2";if(B=Le(H,A),B===null)throw Le(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}nt()}catch(A){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),ot("WebGLRenderer: "+A.message),A}function nt(){Qe=new vb(B),Qe.init(),ye=new eM(B,Qe),ut=new ob(B,Qe,e,ye),Te=new jS(B,Qe),ut.reversedDepthBuffer&&u&&Te.buffers.depth.setReversed(!0),F=B.createFramebuffer(),P=B.createFramebuffer(),G=B.createFramebuffer(),Vt=new bb(B),$e=new kS,Je=new QS(B,Qe,Te,$e,ut,ye,Vt),I=new _b(U),M=new Mv(B),we=new rb(B,M),$=new xb(B,M,Vt,we),pe=new Mb(B,$,M,we,Vt),oe=new Sb(B,ut,Je),se=new lb($e),le=new FS(U,I,Qe,ut,we,se),be=new sM(U,$e),Se=new zS,ne=new $S(Qe),k=new sb(U,I,Te,pe,m,l),_e=new KS(U,pe,ut),Ye=new rM(B,Vt,ut,Te),ie=new ab(B,Qe,Vt),Ae=new yb(B,Qe,Vt),Vt.programs=le.programs,U.capabilities=ut,U.extensions=Qe,U.properties=$e,U.renderLists=Se,U.shadowMap=_e,U.state=Te,U.info=Vt}v!==ti&&(z=new Eb(v,t.width,t.height,o,s,r));let fe=new Pd(U,B);this.xr=fe,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=Qe.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Qe.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return xe},this.setPixelRatio=function(A){A!==void 0&&(xe=A,this.setSize(ve,Ee,!1))},this.getSize=function(A){return A.set(ve,Ee)},this.setSize=function(A,H,ee=!0){if(fe.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=A,Ee=H,t.width=Math.floor(A*xe),t.height=Math.floor(H*xe),ee===!0&&(t.style.width=A+"px",t.style.height=H+"px"),z!==null&&z.setSize(t.width,t.height),this.setViewport(0,0,A,H)},this.getDrawingBufferSize=function(A){return A.set(ve*xe,Ee*xe).floor()},this.setDrawingBufferSize=function(A,H,ee){ve=A,Ee=H,xe=ee,t.width=Math.floor(A*ee),t.height=Math.floor(H*ee),this.setViewport(0,0,A,H)},this.setEffects=function(A){if(v===ti){ot("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let H=0;H<A.length;H++)if(A[H].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}z.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(te)},this.getViewport=function(A){return A.copy(ae)},this.setViewport=function(A,H,ee,Y){A.isVector4?ae.set(A.x,A.y,A.z,A.w):ae.set(A,H,ee,Y),Te.viewport(te.copy(ae).multiplyScalar(fn()).round())},this.getScissor=function(A){return A.copy(Xe)},this.setScissor=function(A,H,ee,Y){A.isVector4?Xe.set(A.x,A.y,A.z,A.w):Xe.set(A,H,ee,Y),Te.scissor(ue.copy(Xe).multiplyScalar(fn()).round())},this.getScissorTest=function(){return tt},this.setScissorTest=function(A){Te.setScissorTest(tt=A)},this.setOpaqueSort=function(A){qe=A},this.setTransparentSort=function(A){st=A},this.getClearColor=function(A){return A.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(A=!0,H=!0,ee=!0){let Y=0;if(A){let J=!1;if(he!==null){let Ce=he.texture.format;J=_.has(Ce)}if(J){let Ce=he.texture.type,Ie=g.has(Ce),Re=k.getClearColor(),Ne=k.getClearAlpha(),We=Re.r,at=Re.g,_t=Re.b;Ie?(x[0]=We,x[1]=at,x[2]=_t,x[3]=Ne,B.clearBufferuiv(B.COLOR,0,x)):(T[0]=We,T[1]=at,T[2]=_t,T[3]=Ne,B.clearBufferiv(B.COLOR,0,T))}else Y|=B.COLOR_BUFFER_BIT}H&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ee&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),L=A},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),k.dispose(),Se.dispose(),ne.dispose(),Je.dispose(),$e.dispose(),I.dispose(),pe.dispose(),$.dispose(),we.dispose(),Ye.dispose(),le.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",ul),fe.removeEventListener("sessionend",Vi),ss.stop()};function Ve(A){A.preventDefault(),ud("WebGLRenderer: Context Lost."),D=!0}function it(){ud("WebGLRenderer: Context Restored."),D=!1;let A=Vt.autoReset,H=_e.enabled,ee=_e.autoUpdate,Y=_e.needsUpdate,J=_e.type;nt(),Vt.autoReset=A,_e.enabled=H,_e.autoUpdate=ee,_e.needsUpdate=Y,_e.type=J}function Pe(A){ot("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function dt(A){let H=A.target;H.removeEventListener("dispose",dt),Yt(H)}function Yt(A){zn(A),$e.remove(A)}function zn(A){let H=$e.get(A).programs;H!==void 0&&(H.forEach(function(ee){le.releaseProgram(ee)}),A.isShaderMaterial&&le.releaseShaderCache(A))}this.renderBufferDirect=function(A,H,ee,Y,J,Ce){H===null&&(H=Bt);let Ie=J.isMesh&&J.matrixWorld.determinantAffine()<0,Re=$a(A,H,ee,Y,J);Te.setMaterial(Y,Ie);let Ne=ee.index,We=1;if(Y.wireframe===!0){if(Ne=$.getWireframeAttribute(ee),Ne===void 0)return;We=2}let at=ee.drawRange,_t=ee.attributes.position,Ge=at.start*We,vt=(at.start+at.count)*We;Ce!==null&&(Ge=Math.max(Ge,Ce.start*We),vt=Math.min(vt,(Ce.start+Ce.count)*We)),Ne!==null?(Ge=Math.max(Ge,0),vt=Math.min(vt,Ne.count)):_t!=null&&(Ge=Math.max(Ge,0),vt=Math.min(vt,_t.count));let nn=vt-Ge;if(nn<0||nn===1/0)return;we.setup(J,Y,Re,ee,Ne);let Ot,Ft=ie;if(Ne!==null&&(Ot=M.get(Ne),Ft=Ae,Ft.setIndex(Ot)),J.isMesh)Y.wireframe===!0?(Te.setLineWidth(Y.wireframeLinewidth*fn()),Ft.setMode(B.LINES)):Ft.setMode(B.TRIANGLES);else if(J.isLine){let yn=Y.linewidth;yn===void 0&&(yn=1),Te.setLineWidth(yn*fn()),J.isLineSegments?Ft.setMode(B.LINES):J.isLineLoop?Ft.setMode(B.LINE_LOOP):Ft.setMode(B.LINE_STRIP)}else J.isPoints?Ft.setMode(B.POINTS):J.isSprite&&Ft.setMode(B.TRIANGLES);if(J.isBatchedMesh)if(Qe.get("WEBGL_multi_draw"))Ft.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let yn=J._multiDrawStarts,ke=J._multiDrawCounts,pn=J._multiDrawCount,yt=Ne?M.get(Ne).bytesPerElement:1,as=$e.get(Y).currentProgram.getUniforms();for(let mn=0;mn<pn;mn++)as.setValue(B,"_gl_DrawID",mn),Ft.render(yn[mn]/yt,ke[mn])}else if(J.isInstancedMesh)Ft.renderInstances(Ge,nn,J.count);else if(ee.isInstancedBufferGeometry){let yn=ee._maxInstanceCount!==void 0?ee._maxInstanceCount:1/0,ke=Math.min(ee.instanceCount,yn);Ft.renderInstances(Ge,nn,ke)}else Ft.render(Ge,nn)};function Ha(A,H,ee,Y){L!==null&&A.isNodeMaterial&&L.setObject(Y,A),Ct===!0&&se.setState(A,ee,!1),A.transparent===!0&&A.side===ei&&A.forceSinglePass===!1?(A.side=Zn,A.needsUpdate=!0,Gi(A,H,Y),A.side=Ks,A.needsUpdate=!0,Gi(A,H,Y),A.side=ei):Gi(A,H,Y)}this.compile=function(A,H,ee=null){ee===null&&(ee=A),L!==null&&L.renderStart(A,H,ee),w=ne.get(ee),w.init(H),C.push(w),ee.traverseVisible(function(J){J.isLight&&J.layers.test(H.layers)&&(w.pushLight(J),J.castShadow&&w.pushShadow(J))}),A!==ee&&A.traverseVisible(function(J){J.isLight&&J.layers.test(H.layers)&&(w.pushLight(J),J.castShadow&&w.pushShadow(J))}),w.setupLights(),L!==null&&L.updateLights(w.state.lightsArray),qt=this.localClippingEnabled,Ct=se.init(this.clippingPlanes,qt),Ct===!0&&se.setGlobalState(this.clippingPlanes,H),L!==null&&_e.render(w.state.shadowsArray,ee,H);let Y=new Set;return A.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Ce=J.material;if(Ce)if(Array.isArray(Ce))for(let Ie=0;Ie<Ce.length;Ie++){let Re=Ce[Ie];Ha(Re,ee,H,J),Y.add(Re)}else Ha(Ce,ee,H,J),Y.add(Ce)}),w=C.pop(),L!==null&&L.renderEnd(),Y},this.compileAsync=function(A,H,ee=null){let Y=this.compile(A,H,ee);return new Promise(J=>{function Ce(){if(Y.forEach(function(Ie){let Ne=$e.get(Ie).currentProgram;(Ne===void 0||Ne.isReady())&&Y.delete(Ie)}),Y.size===0){J(A);return}setTimeout(Ce,10)}Qe.get("KHR_parallel_shader_compile")!==null?Ce():setTimeout(Ce,10)})};let Ur=null;function Zh(A){Ur&&Ur(A)}function ul(){ss.stop()}function Vi(){ss.start()}let ss=new Um;ss.setAnimationLoop(Zh),typeof self<"u"&&ss.setContext(self),this.setAnimationLoop=function(A){Ur=A,fe.setAnimationLoop(A),A===null?ss.stop():ss.start()},fe.addEventListener("sessionstart",ul),fe.addEventListener("sessionend",Vi),this.render=function(A,H){if(H!==void 0&&H.isCamera!==!0){ot("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;L!==null&&L.renderStart(A,H);let ee=fe.enabled===!0&&fe.isPresenting===!0,Y=z!==null&&(he===null||ee)&&z.begin(U,he);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(z===null||z.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(H),H=fe.getCamera()),A.isScene===!0&&A.onBeforeRender(U,A,H,he),w=ne.get(A,C.length),w.init(H),w.state.textureUnits=Je.getTextureUnits(),C.push(w),wt.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?ft.setFromArrayCamera(H):rt.setFromProjectionMatrix(wt,bi,H.reversedDepth),qt=this.localClippingEnabled,Ct=se.init(this.clippingPlanes,qt),R=Se.get(A,y.length),R.init(),y.push(R),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let Ie=U.xr.getDepthSensingMesh();Ie!==null&&rs(Ie,H,-1/0,U.sortObjects)}rs(A,H,0,U.sortObjects),R.finish(),L!==null&&L.updateLights(w.state.lightsArray),U.sortObjects===!0&&R.sort(qe,st),Wt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,Wt&&k.addToRenderList(R,A),this.info.autoReset===!0&&this.info.reset(),Ct===!0&&se.beginShadows();let J=w.state.shadowsArray;if(_e.render(J,A,H),Ct===!0&&se.endShadows(),(Y&&z.hasRenderPass())===!1){let Ie=R.opaque,Re=R.transmissive;if(w.setupLights(),H.isArrayCamera){let Ne=H.cameras;if(Re.length>0)for(let We=0,at=Ne.length;We<at;We++){let _t=Ne[We];Ei(Ie,Re,A,_t)}Wt&&k.render(A);for(let We=0,at=Ne.length;We<at;We++){let _t=Ne[We];Wa(R,A,_t,_t.viewport)}}else Re.length>0&&Ei(Ie,Re,A,H),Wt&&k.render(A),Wa(R,A,H)}he!==null&&W===0&&(Je.updateMultisampleRenderTarget(he),Je.updateRenderTargetMipmap(he)),Y&&z.end(U),A.isScene===!0&&A.onAfterRender(U,A,H),we.resetDefaultState(),Z=-1,Q=null,C.pop(),C.length>0?(w=C[C.length-1],Je.setTextureUnits(w.state.textureUnits),Ct===!0&&se.setGlobalState(U.clippingPlanes,w.state.camera)):w=null,y.pop(),y.length>0?R=y[y.length-1]:R=null,L!==null&&L.renderEnd()};function rs(A,H,ee,Y){if(A.visible===!1)return;if(A.layers.test(H.layers)){if(A.isGroup)ee=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(H);else if(A.isLight)w.pushLight(A),A.castShadow&&w.pushShadow(A);else if(A.isSprite){let Ie=H.isArrayCamera?ft:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){Y&&lt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(wt);let Re=pe.update(A),Ne=A.material;Ne.visible&&R.push(A,Re,Ne,ee,lt.z,null,H)}}else if(A.isMesh||A.isLine||A.isPoints){let Ie=H.isArrayCamera?ft:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){let Re=pe.update(A),Ne=A.material;if(Y&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),lt.copy(A.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),lt.copy(Re.boundingSphere.center)),lt.applyMatrix4(A.matrixWorld).applyMatrix4(wt)),Array.isArray(Ne)){let We=Re.groups;for(let at=0,_t=We.length;at<_t;at++){let Ge=We[at],vt=Ne[Ge.materialIndex];vt&&vt.visible&&R.push(A,Re,vt,ee,lt.z,Ge,H)}}else Ne.visible&&R.push(A,Re,Ne,ee,lt.z,null,H)}}}let Ce=A.children;for(let Ie=0,Re=Ce.length;Ie<Re;Ie++)rs(Ce[Ie],H,ee,Y)}function Wa(A,H,ee,Y){let{opaque:J,transmissive:Ce,transparent:Ie}=A;w.setupLightsView(ee),Ct===!0&&se.setGlobalState(U.clippingPlanes,ee),Y&&Te.viewport(te.copy(Y)),J.length>0&&rn(J,H,ee),Ce.length>0&&rn(Ce,H,ee),Ie.length>0&&rn(Ie,H,ee),Te.buffers.depth.setTest(!0),Te.buffers.depth.setMask(!0),Te.buffers.color.setMask(!0),Te.setPolygonOffset(!1)}function Ei(A,H,ee,Y){if((ee.isScene===!0?ee.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[Y.id]===void 0){let Ge=Qe.has("EXT_color_buffer_half_float")||Qe.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[Y.id]=new di(1,1,{generateMipmaps:!0,type:Ge?Oi:ti,minFilter:ws,samples:Math.max(4,ut.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ce=w.state.transmissionRenderTarget[Y.id],Ie=Y.viewport||te;Ce.setSize(Ie.z*U.transmissionResolutionScale,Ie.w*U.transmissionResolutionScale);let Re=U.getRenderTarget(),Ne=U.getActiveCubeFace(),We=U.getActiveMipmapLevel();U.setRenderTarget(Ce),U.getClearColor(j),me=U.getClearAlpha(),me<1&&U.setClearColor(16777215,.5),U.clear(),Wt&&k.render(ee);let at=U.toneMapping;U.toneMapping=es;let _t=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),w.setupLightsView(Y),Ct===!0&&se.setGlobalState(U.clippingPlanes,Y),rn(A,ee,Y),Je.updateMultisampleRenderTarget(Ce),Je.updateRenderTargetMipmap(Ce),Qe.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let vt=0,nn=H.length;vt<nn;vt++){let Ot=H[vt],{object:Ft,geometry:yn,material:ke,group:pn}=Ot;if(ke.side===ei&&Ft.layers.test(Y.layers)){let yt=ke.side;ke.side=Zn,ke.needsUpdate=!0,cn(Ft,ee,Y,yn,ke,pn),ke.side=yt,ke.needsUpdate=!0,Ge=!0}}Ge===!0&&(Je.updateMultisampleRenderTarget(Ce),Je.updateRenderTargetMipmap(Ce))}U.setRenderTarget(Re,Ne,We),U.setClearColor(j,me),_t!==void 0&&(Y.viewport=_t),U.toneMapping=at}function rn(A,H,ee){let Y=H.isScene===!0?H.overrideMaterial:null;for(let J=0,Ce=A.length;J<Ce;J++){let Ie=A[J],{object:Re,geometry:Ne,group:We}=Ie,at=Ie.material;at.allowOverride===!0&&Y!==null&&(at=Y),Re.layers.test(ee.layers)&&cn(Re,H,ee,Ne,at,We)}}function cn(A,H,ee,Y,J,Ce){L!==null&&J.isNodeMaterial&&L.setObject(A,J),A.onBeforeRender(U,H,ee,Y,J,Ce),A.modelViewMatrix.multiplyMatrices(ee.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),J.onBeforeRender(U,H,ee,Y,A,Ce),J.transparent===!0&&J.side===ei&&J.forceSinglePass===!1?(J.side=Zn,J.needsUpdate=!0,U.renderBufferDirect(ee,H,Y,J,A,Ce),J.side=Ks,J.needsUpdate=!0,U.renderBufferDirect(ee,H,Y,J,A,Ce),J.side=ei):U.renderBufferDirect(ee,H,Y,J,A,Ce),A.onAfterRender(U,H,ee,Y,J,Ce)}function hn(A){let H=0;for(let ee of A)ee.texture!==null&&H++;return H}function Gi(A,H,ee){H.isScene!==!0&&(H=Bt);let Y=$e.get(A),J=w.state.lights,Ce=w.state.shadowsArray,Ie=J.state.version,Re=le.getParameters(A,J.state,Ce,H,ee,w.state.lightProbeGridArray),Ne=le.getProgramCacheKey(Re),We=Y.programs;Y.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?H.environment:null,Y.fog=H.fog;let at=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Y.envMap=I.get(A.envMap||Y.environment,at),Y.envMapRotation=Y.environment!==null&&A.envMap===null?H.environmentRotation:A.envMapRotation,We===void 0&&(A.addEventListener("dispose",dt),We=new Map,Y.programs=We,Y.programVariants=new Map);let _t=We.get(Ne);if(_t!==void 0){if(Y.currentProgram===_t&&Y.lightsStateVersion===Ie)return Xa(A,Re),_t}else Re.uniforms=le.getUniforms(A),L!==null&&A.isNodeMaterial&&L.build(A,ee,Re),A.onBeforeCompile(Re,U),_t=le.acquireProgram(Re,Ne),We.set(Ne,_t),Y.uniforms=Re.uniforms;let Ge=Y.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Ge.clippingPlanes=se.uniform),Xa(A,Re),Y.needsLights=Ls(A),Y.lightsStateVersion=Ie,Y.needsLights&&(Ge.ambientLightColor.value=J.state.ambient,Ge.lightProbe.value=J.state.probe,Ge.sunLights.value=J.state.sun,Ge.sunLightShadows.value=J.state.sunShadow,Ge.directionalLights.value=J.state.directional,Ge.directionalLightShadows.value=J.state.directionalShadow,Ge.spotLights.value=J.state.spot,Ge.spotLightShadows.value=J.state.spotShadow,Ge.rectAreaLights.value=J.state.rectArea,Ge.ltc_1.value=J.state.rectAreaLTC1,Ge.ltc_2.value=J.state.rectAreaLTC2,Ge.pointLights.value=J.state.point,Ge.pointLightShadows.value=J.state.pointShadow,Ge.hemisphereLights.value=J.state.hemi,Ge.sunShadowMatrix.value=J.state.sunShadowMatrix,Ge.sunShadowCascade.value=J.state.sunShadowCascade,Ge.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Ge.spotLightMatrix.value=J.state.spotLightMatrix,Ge.spotLightMap.value=J.state.spotLightMap,Ge.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=hn(w.state.lightProbeGridArray),Y.currentProgram=_t,Y.uniformsList=null,_t}function ii(A,H,ee,Y,J){let Ce=$e.get(A),Ie=Ce.currentProgram.id+","+Y+","+J,Re=Ce.programVariants.get(Ie);return Re===void 0?(Re=Gi(A,H,ee),Ce.programVariants.set(Ie,Re)):(Ce.currentProgram=Re,Ce.uniformsList=null,Ce.outputColorSpace=Y,Ce.toneMapping=J),Re}function Ps(A){if(A.uniformsList===null){let H=A.currentProgram.getUniforms();A.uniformsList=Ma.seqWithValue(H.seq,A.uniforms)}return A.uniformsList}function Xa(A,H){let ee=$e.get(A);ee.outputColorSpace=H.outputColorSpace,ee.batching=H.batching,ee.batchingColor=H.batchingColor,ee.instancing=H.instancing,ee.instancingColor=H.instancingColor,ee.instancingMorph=H.instancingMorph,ee.skinning=H.skinning,ee.morphTargets=H.morphTargets,ee.morphNormals=H.morphNormals,ee.morphColors=H.morphColors,ee.morphTargetsCount=H.morphTargetsCount,ee.numClippingPlanes=H.numClippingPlanes,ee.numIntersection=H.numClipIntersection,ee.vertexAlphas=H.vertexAlphas,ee.vertexTangents=H.vertexTangents,ee.toneMapping=H.toneMapping}function $a(A,H,ee,Y,J){H.isScene!==!0&&(H=Bt),Je.resetTextureUnits();let Ce=H.fog,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?H.environment:null,Re=he===null?U.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:St.workingColorSpace,Ne=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,We=I.get(Y.envMap||Ie,Ne),at=Y.vertexColors===!0&&!!ee.attributes.color&&ee.attributes.color.itemSize===4,_t=!!ee.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Ge=!!ee.morphAttributes.position,vt=!!ee.morphAttributes.normal,nn=!!ee.morphAttributes.color,Ot=es;Y.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(Ot=U.toneMapping);let Ft=ee.morphAttributes.position||ee.morphAttributes.normal||ee.morphAttributes.color,yn=Ft!==void 0?Ft.length:0,ke=$e.get(Y),pn=w.state.lights;if(Ct===!0&&(qt===!0||A!==Q)){let kt=A===Q&&Y.id===Z;se.setState(Y,A,kt)}let yt=!1,as=!1;Y.version===ke.__version?ke.needsLights&&ke.lightsStateVersion!==pn.state.version||J.isBatchedMesh&&ke.batching===!1||!J.isBatchedMesh&&ke.batching===!0||J.isBatchedMesh&&ke.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&ke.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&ke.instancing===!1||!J.isInstancedMesh&&ke.instancing===!0||J.isSkinnedMesh&&ke.skinning===!1||!J.isSkinnedMesh&&ke.skinning===!0||J.isInstancedMesh&&ke.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&ke.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&ke.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&ke.instancingMorph===!1&&J.morphTexture!==null||ke.envMap!==We||Y.fog===!0&&ke.fog!==Ce||ke.numClippingPlanes!==void 0&&(ke.numClippingPlanes!==se.numPlanes||ke.numIntersection!==se.numIntersection)||ke.vertexAlphas!==at||ke.vertexTangents!==_t||ke.morphTargets!==Ge||ke.morphNormals!==vt||ke.morphColors!==nn||ke.morphTargetsCount!==yn||ke.numLightProbeGrids!==hn(w.state.lightProbeGridArray)?yt=!0:(ke.outputColorSpace!==Re||ke.toneMapping!==Ot)&&(as=!0):(yt=!0,ke.__version=Y.version);let mn=ke.currentProgram;(yt===!0||as===!0)&&(mn=as===!0?ii(Y,H,J,Re,Ot):Gi(Y,H,J),L&&Y.isNodeMaterial&&L.onUpdateProgram(Y,mn,ke));let kr=!1,Hi=!1,os=!1,pt=mn.getUniforms(),an=ke.uniforms;if(Te.useProgram(mn.program)&&(kr=!0,Hi=!0,os=!0),Y.id!==Z&&(Z=Y.id,Hi=!0),kr||Q!==A){Te.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),pt.setValue(B,"projectionMatrix",A.projectionMatrix),pt.setValue(B,"viewMatrix",A.matrixWorldInverse);let gn=pt.map.cameraPosition;gn!==void 0&&gn.setValue(B,sn.setFromMatrixPosition(A.matrixWorld)),ut.logarithmicDepthBuffer&&pt.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&pt.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),Q!==A&&(Q=A,Hi=!0,os=!0)}if(ke.needsLights&&(pn.state.sunShadowMap.length>0&&pt.setValue(B,"sunShadowMap",pn.state.sunShadowMap,Je),pn.state.directionalShadowMap.length>0&&pt.setValue(B,"directionalShadowMap",pn.state.directionalShadowMap,Je),pn.state.spotShadowMap.length>0&&pt.setValue(B,"spotShadowMap",pn.state.spotShadowMap,Je),pn.state.pointShadowMap.length>0&&pt.setValue(B,"pointShadowMap",pn.state.pointShadowMap,Je)),J.isSkinnedMesh){pt.setOptional(B,J,"bindMatrix"),pt.setOptional(B,J,"bindMatrixInverse");let kt=J.skeleton;kt&&(kt.boneTexture===null&&kt.computeBoneTexture(),pt.setValue(B,"boneTexture",kt.boneTexture,Je))}J.isBatchedMesh&&(pt.setOptional(B,J,"batchingTexture"),pt.setValue(B,"batchingTexture",J._matricesTexture,Je),pt.setOptional(B,J,"batchingIdTexture"),pt.setValue(B,"batchingIdTexture",J._indirectTexture,Je),pt.setOptional(B,J,"batchingColorTexture"),J._colorsTexture!==null&&pt.setValue(B,"batchingColorTexture",J._colorsTexture,Je));let Vn=ee.morphAttributes;if((Vn.position!==void 0||Vn.normal!==void 0||Vn.color!==void 0)&&oe.update(J,ee,mn),(Hi||ke.receiveShadow!==J.receiveShadow)&&(ke.receiveShadow=J.receiveShadow,pt.setValue(B,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&H.environment!==null&&(an.envMapIntensity.value=H.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=oM()),Hi){if(pt.setValue(B,"toneMappingExposure",U.toneMappingExposure),ke.needsLights&&Or(an,os),Ce&&Y.fog===!0&&be.refreshFogUniforms(an,Ce),be.refreshMaterialUniforms(an,Y,xe,Ee,w.state.transmissionRenderTarget[A.id]),ke.needsLights&&ke.numLightProbeGrids>0){let kt=S,gn=0;for(let Nn of w.state.lightProbeGridArray)Nn.texture!==null&&(kt.textures[gn]=Nn.texture,kt.min[gn]=Nn.boundingBox.min,kt.max[gn]=Nn.boundingBox.max,kt.resolution[gn]=Nn.resolution,gn++);for(let Nn in kt)kt[Nn].length=gn;an.probesSH.value=kt.textures,an.probesMin.value=kt.min,an.probesMax.value=kt.max,an.probesResolution.value=kt.resolution}Ma.upload(B,Ps(ke),an,Je)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Ma.upload(B,Ps(ke),an,Je),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&pt.setValue(B,"center",J.center),pt.setValue(B,"modelViewMatrix",J.modelViewMatrix),pt.setValue(B,"normalMatrix",J.normalMatrix),pt.setValue(B,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let kt=Y.uniformsGroups;for(let gn=0,Nn=kt.length;gn<Nn;gn++){let dl=kt[gn];Ye.update(dl,mn),Ye.bind(dl,mn)}}return mn}function Or(A,H){A.ambientLightColor.needsUpdate=H,A.lightProbe.needsUpdate=H,A.sunLights.needsUpdate=H,A.sunLightShadows.needsUpdate=H,A.directionalLights.needsUpdate=H,A.directionalLightShadows.needsUpdate=H,A.pointLights.needsUpdate=H,A.pointLightShadows.needsUpdate=H,A.spotLights.needsUpdate=H,A.spotLightShadows.needsUpdate=H,A.rectAreaLights.needsUpdate=H,A.hemisphereLights.needsUpdate=H}function Ls(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return he},this.setRenderTargetTextures=function(A,H,ee){let Y=$e.get(A);Y.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),$e.get(A.texture).__webglTexture=H,$e.get(A.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:ee,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,H){let ee=$e.get(A);ee.__webglFramebuffer=H,ee.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(A,H=0,ee=0){he=A,q=H,W=ee;let Y=null,J=!1,Ce=!1;if(A){let Re=$e.get(A);if(Re.__useDefaultFramebuffer!==void 0){Te.bindFramebuffer(B.FRAMEBUFFER,Re.__webglFramebuffer),te.copy(A.viewport),ue.copy(A.scissor),de=A.scissorTest,Te.viewport(te),Te.scissor(ue),Te.setScissorTest(de),Z=-1;return}else if(Re.__webglFramebuffer===void 0)Je.setupRenderTarget(A);else if(Re.__hasExternalTextures)Je.rebindTextures(A,$e.get(A.texture).__webglTexture,$e.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let at=A.depthTexture;if(Re.__boundDepthTexture!==at){if(at!==null&&$e.has(at)&&(A.width!==at.image.width||A.height!==at.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Je.setupDepthRenderbuffer(A)}}let Ne=A.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ce=!0);let We=$e.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(We[H])?Y=We[H][ee]:Y=We[H],J=!0):A.samples>0&&Je.useMultisampledRTT(A)===!1?Y=$e.get(A).__webglMultisampledFramebuffer:Array.isArray(We)?Y=We[ee]:Y=We,te.copy(A.viewport),ue.copy(A.scissor),de=A.scissorTest}else te.copy(ae).multiplyScalar(xe).floor(),ue.copy(Xe).multiplyScalar(xe).floor(),de=tt;if(ee!==0&&(Y=F),Te.bindFramebuffer(B.FRAMEBUFFER,Y)&&Te.drawBuffers(A,Y),Te.viewport(te),Te.scissor(ue),Te.setScissorTest(de),J){let Re=$e.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+H,Re.__webglTexture,ee)}else if(Ce){let Re=H;for(let Ne=0;Ne<A.textures.length;Ne++){let We=$e.get(A.textures[Ne]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ne,We.__webglTexture,ee,Re)}}else if(A!==null&&ee!==0){let Re=$e.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Re.__webglTexture,ee)}Z=-1};function Fr(A){let H=$e.get(A);return(H.__readFormat!==A.format||H.__readType!==A.type)&&(H.__readFormat=A.format,H.__readType=A.type,H.__formatReadable=ut.textureFormatReadable(A.format),H.__typeReadable=ut.textureTypeReadable(A.type)),H}this.readRenderTargetPixels=function(A,H,ee,Y,J,Ce,Ie,Re=0){if(!(A&&A.isWebGLRenderTarget)){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=$e.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(Ne=Ne[Ie],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Te.bindFramebuffer(B.FRAMEBUFFER,Ne);try{let We=A.textures[Re],at=We.format,_t=We.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Re);let Ge=Fr(We);if(Ge.__formatReadable===!1){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=A.width-Y&&ee>=0&&ee<=A.height-J&&B.readPixels(H,ee,Y,J,ye.convert(at),ye.convert(_t),Ce)}finally{let We=he!==null?$e.get(he).__webglFramebuffer:null;Te.bindFramebuffer(B.FRAMEBUFFER,We)}}},this.readRenderTargetPixelsAsync=async function(A,H,ee,Y,J,Ce,Ie,Re=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=$e.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(Ne=Ne[Ie],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(H>=0&&H<=A.width-Y&&ee>=0&&ee<=A.height-J){Te.bindFramebuffer(B.FRAMEBUFFER,Ne);let We=A.textures[Re],at=We.format,_t=We.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Re);let Ge=Fr(We);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let vt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,vt),B.bufferData(B.PIXEL_PACK_BUFFER,Ce.byteLength,B.STREAM_READ),B.readPixels(H,ee,Y,J,ye.convert(at),ye.convert(_t),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let nn=he!==null?$e.get(he).__webglFramebuffer:null;Te.bindFramebuffer(B.FRAMEBUFFER,nn);let Ot=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await am(B,Ot,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,vt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ce),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(vt),B.deleteSync(Ot),Ce}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,H=null,ee=0){let Y=Math.pow(2,-ee),J=Math.floor(A.image.width*Y),Ce=Math.floor(A.image.height*Y),Ie=H!==null?H.x:0,Re=H!==null?H.y:0;Je.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,ee,0,0,Ie,Re,J,Ce),Te.unbindTexture()},this.copyTextureToTexture=function(A,H,ee=null,Y=null,J=0,Ce=0){let Ie,Re,Ne,We,at,_t,Ge,vt,nn,Ot=A.isCompressedTexture?A.mipmaps[Ce]:A.image;if(ee!==null)Ie=ee.max.x-ee.min.x,Re=ee.max.y-ee.min.y,Ne=ee.isBox3?ee.max.z-ee.min.z:1,We=ee.min.x,at=ee.min.y,_t=ee.isBox3?ee.min.z:0;else{let pt=Math.pow(2,-J);Ie=Math.floor(Ot.width*pt),Re=Math.floor(Ot.height*pt),A.isDataArrayTexture?Ne=Ot.depth:A.isData3DTexture?Ne=Math.floor(Ot.depth*pt):Ne=1,We=0,at=0,_t=0}Y!==null?(Ge=Y.x,vt=Y.y,nn=Y.z):(Ge=0,vt=0,nn=0);let Ft=ye.convert(H.format),yn=ye.convert(H.type),ke;H.isData3DTexture?(Je.setTexture3D(H,0),ke=B.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Je.setTexture2DArray(H,0),ke=B.TEXTURE_2D_ARRAY):(Je.setTexture2D(H,0),ke=B.TEXTURE_2D),Te.activeTexture(B.TEXTURE0),Te.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,H.flipY),Te.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Te.pixelStorei(B.UNPACK_ALIGNMENT,H.unpackAlignment);let pn=Te.getParameter(B.UNPACK_ROW_LENGTH),yt=Te.getParameter(B.UNPACK_IMAGE_HEIGHT),as=Te.getParameter(B.UNPACK_SKIP_PIXELS),mn=Te.getParameter(B.UNPACK_SKIP_ROWS),kr=Te.getParameter(B.UNPACK_SKIP_IMAGES);Te.pixelStorei(B.UNPACK_ROW_LENGTH,Ot.width),Te.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ot.height),Te.pixelStorei(B.UNPACK_SKIP_PIXELS,We),Te.pixelStorei(B.UNPACK_SKIP_ROWS,at),Te.pixelStorei(B.UNPACK_SKIP_IMAGES,_t);let Hi=A.isDataArrayTexture||A.isData3DTexture,os=H.isDataArrayTexture||H.isData3DTexture;if(A.isDepthTexture){let pt=$e.get(A),an=$e.get(H),Vn=$e.get(pt.__renderTarget),kt=$e.get(an.__renderTarget);Te.bindFramebuffer(B.READ_FRAMEBUFFER,Vn.__webglFramebuffer),Te.bindFramebuffer(B.DRAW_FRAMEBUFFER,kt.__webglFramebuffer);for(let gn=0;gn<Ne;gn++)Hi&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,$e.get(A).__webglTexture,J,_t+gn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,$e.get(H).__webglTexture,Ce,nn+gn)),B.blitFramebuffer(We,at,We+Ie,at+Re,Ge,vt,Ge+Ie,vt+Re,B.DEPTH_BUFFER_BIT,B.NEAREST);Te.bindFramebuffer(B.READ_FRAMEBUFFER,null),Te.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(J!==0||A.isRenderTargetTexture||$e.has(A)){let pt=$e.get(A),an=$e.get(H);Te.bindFramebuffer(B.READ_FRAMEBUFFER,P),Te.bindFramebuffer(B.DRAW_FRAMEBUFFER,G);for(let Vn=0;Vn<Ne;Vn++)Hi?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,pt.__webglTexture,J,_t+Vn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,pt.__webglTexture,J),os?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,an.__webglTexture,Ce,nn+Vn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,an.__webglTexture,Ce),J!==0?B.blitFramebuffer(We,at,We+Ie,at+Re,Ge,vt,Ge+Ie,vt+Re,B.COLOR_BUFFER_BIT,B.NEAREST):os?B.copyTexSubImage3D(ke,Ce,Ge,vt,nn+Vn,We,at,Ie,Re):B.copyTexSubImage2D(ke,Ce,Ge,vt,We,at,Ie,Re);Te.bindFramebuffer(B.READ_FRAMEBUFFER,null),Te.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else os?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(ke,Ce,Ge,vt,nn,Ie,Re,Ne,Ft,yn,Ot.data):H.isCompressedArrayTexture?B.compressedTexSubImage3D(ke,Ce,Ge,vt,nn,Ie,Re,Ne,Ft,Ot.data):B.texSubImage3D(ke,Ce,Ge,vt,nn,Ie,Re,Ne,Ft,yn,Ot):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ce,Ge,vt,Ie,Re,Ft,yn,Ot.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ce,Ge,vt,Ot.width,Ot.height,Ft,Ot.data):B.texSubImage2D(B.TEXTURE_2D,Ce,Ge,vt,Ie,Re,Ft,yn,Ot);Te.pixelStorei(B.UNPACK_ROW_LENGTH,pn),Te.pixelStorei(B.UNPACK_IMAGE_HEIGHT,yt),Te.pixelStorei(B.UNPACK_SKIP_PIXELS,as),Te.pixelStorei(B.UNPACK_SKIP_ROWS,mn),Te.pixelStorei(B.UNPACK_SKIP_IMAGES,kr),Ce===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&B.generateMipmap(ke),Te.unbindTexture()},this.initRenderTarget=function(A){$e.get(A).__webglFramebuffer===void 0&&Je.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Je.setTextureCube(A,0):A.isData3DTexture?Je.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Je.setTexture2DArray(A,0):Je.setTexture2D(A,0),Te.unbindTexture()},this.resetState=function(){q=0,W=0,he=null,Te.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var $m={type:"change"},Id={type:"start"},Ym={type:"end"},xh=new pr,qm=new hi,lM=Math.cos(70*md.DEG2RAD),Mn=new V,ni=2*Math.PI,Pt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Ld=1e-6,yh=class extends Do{constructor(e,t=null){super(e,t),this.state=Pt.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Zs.ROTATE,MIDDLE:Zs.DOLLY,RIGHT:Zs.PAN},this.touches={ONE:Js.ROTATE,TWO:Js.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new qn,this._lastTargetPosition=new V,this._quat=new qn().setFromUnitVectors(e.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new _a,this._sphericalDelta=new _a,this._scale=1,this._panOffset=new V,this._rotateStart=new ze,this._rotateEnd=new ze,this._rotateDelta=new ze,this._panStart=new ze,this._panEnd=new ze,this._panDelta=new ze,this._dollyStart=new ze,this._dollyEnd=new ze,this._dollyDelta=new ze,this._dollyDirection=new V,this._mouse=new ze,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=hM.bind(this),this._onPointerDown=cM.bind(this),this._onPointerUp=uM.bind(this),this._onContextMenu=vM.bind(this),this._onMouseWheel=pM.bind(this),this._onKeyDown=mM.bind(this),this._onTouchStart=gM.bind(this),this._onTouchMove=_M.bind(this),this._onMouseDown=dM.bind(this),this._onMouseMove=fM.bind(this),this._interceptControlDown=xM.bind(this),this._interceptControlUp=yM.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent($m),this.update(),this.state=Pt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Mn.copy(t).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Pt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ni:n>Math.PI&&(n-=ni),s<-Math.PI?s+=ni:s>Math.PI&&(s-=ni),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){let o=Mn.length();a=this._clampDistance(o*this._scale);let l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let o=new V(this._mouse.x,this._mouse.y,0);o.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new V(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(xh.origin.copy(this.object.position),xh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(xh.direction))<lM?this.object.lookAt(this.target):(qm.setFromNormalAndCoplanarPoint(this.object.up,this.target),xh.intersectPlane(qm,this.target))))}else if(this.object.isOrthographicCamera){let a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Ld||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Ld||this._lastTargetPosition.distanceToSquared(this.target)>Ld?(this.dispatchEvent($m),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ni/60*this.autoRotateSpeed*e:ni/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Mn.setFromMatrixColumn(t,0),Mn.multiplyScalar(-e),this._panOffset.add(Mn)}_panUp(e,t){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(t,1):(Mn.setFromMatrixColumn(t,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(e),this._panOffset.add(Mn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,a=n.width,o=n.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/t.clientHeight),this._rotateUp(ni*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/t.clientHeight),this._rotateUp(ni*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new ze,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function cM(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function hM(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function uM(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Ym),this.state=Pt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function dM(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Zs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Pt.DOLLY;break;case Zs.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pt.ROTATE}break;case Zs.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Pt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Pt.PAN}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Id)}function fM(i){switch(this.state){case Pt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Pt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Pt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function pM(i){this.enabled===!1||this.enableZoom===!1||this.state!==Pt.NONE||(i.preventDefault(),this.dispatchEvent(Id),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Ym))}function mM(i){this.enabled!==!1&&this._handleKeyDown(i)}function gM(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Js.ROTATE:if(this.enableRotate===!1){this.state=Pt.NONE;break}this._handleTouchStartRotate(i),this.state=Pt.TOUCH_ROTATE;break;case Js.PAN:if(this.enablePan===!1){this.state=Pt.NONE;break}this._handleTouchStartPan(i),this.state=Pt.TOUCH_PAN;break;default:this.state=Pt.NONE}break;case 2:switch(this.touches.TWO){case Js.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Pt.TOUCH_DOLLY_PAN;break;case Js.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Pt.TOUCH_DOLLY_ROTATE;break;default:this.state=Pt.NONE}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Id)}function _M(i){switch(this._trackPointer(i),this.state){case Pt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Pt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Pt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Pt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Pt.NONE}}function vM(i){this.enabled!==!1&&i.preventDefault()}function xM(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function yM(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Sr=new V(0,1,0),bM=16,SM=matchMedia("(max-width: 40rem)"),MM=13,Zm={space:[1,.75,.5],front:[1,0,0],side:[0,1,0],top:[0,0,1]},Mr=class{mesh;constructor(e,t,n){this.mesh=new dn(new pa(n,n,1,10),t),e.add(this.mesh)}between(e,t){let n=t.clone().sub(e),s=n.length()||1e-6;this.mesh.position.copy(e).addScaledVector(n,.5),this.mesh.quaternion.setFromUnitVectors(Sr,n.divideScalar(s)),this.mesh.scale.set(1,s,1)}};function wM(i,e){let t=[];for(let n=0;n<=16*e;n++){let s=n/(16*e),r=2*Math.PI*e*s;t.push(new V(i*Math.cos(r),s,i*Math.sin(r)))}return new un().setFromPoints(t)}var Qs=class{element=p("div",{class:"mechanism"});canvas=p("canvas",{tabindex:"0","aria-label":bt("mechanism")});state=p("div",{class:"state"});names=p("div",{class:"names"});legend=p("ul",{class:"legend"});space=new mo;camera=new gr;renderer=null;controls=null;group=new Xn;shown=null;motion=null;points=[];update=[];spin=new V(0,1,0);now={body:0,travel:0,ground:0,load:1,time:0};wheelGroup=new Xn;pathGroup=new Xn;labels=[];named=[];isDirty=!0;isLost=!1;isSeen=!1;size=300;reach=[300,300];centres=null;turned=[];chosen=null;halo=null;grabbed=null;way="view";constructor(e=!1){let t=p("div",{class:"group",role:"group","aria-label":bt("view")});for(let l of Object.keys(Zm))t.append(p("button",{type:"button",click:()=>this.look(l)},bt(l)));let n=Ci(bt("wheel"),!0,l=>{this.wheelGroup.visible=l,this.isDirty=!0}),s=Ci(bt("paths"),e,l=>{this.pathGroup.visible=l,this.isDirty=!0}),r=e&&!SM.matches,a=Ci(bt("names"),r,l=>{this.names.hidden=!l,this.isDirty=!0});this.names.hidden=!r,this.pathGroup.visible=e,this.element.append(p("div",{class:"bar"},t,p("div",{class:"group"},n,s,a)),p("div",{class:"stage"},this.canvas,this.names,this.state)),e&&this.element.append(this.legend),this.space.add(new Io(16777215,1.9),this.group);let o=new Lo(16777215,1.9);o.position.set(.6,.3,1),this.space.add(o),this.camera.up.set(0,0,1),this.controls=new yh(this.camera,this.canvas),this.controls.enableZoom=!1,this.canvas.addEventListener("focus",()=>{this.controls.enableZoom=!0}),this.canvas.addEventListener("blur",()=>{this.controls.enableZoom=!1}),this.canvas.addEventListener("pointerdown",()=>this.canvas.focus()),this.canvas.addEventListener("dblclick",()=>this.look("space")),this.controls.addEventListener("change",()=>{this.isDirty=!0}),this.canvas.parentElement.addEventListener("pointerdown",l=>this.take(l),{capture:!0}),new ResizeObserver(()=>this.resize()).observe(this.canvas.parentElement),new IntersectionObserver(l=>{this.isSeen=l.some(c=>c.isIntersecting)},{rootMargin:"300px"}).observe(this.element)}begin(){if(this.renderer||this.isLost)return!this.isLost;try{this.renderer=new gh({canvas:this.canvas,antialias:Ka(),alpha:!0}),this.renderer.setPixelRatio(Ka()?Math.min(devicePixelRatio,2):1)}catch{return this.isLost=!0,this.state.textContent=bt("noWebGL"),!1}return this.resize(),!0}show(e,t){let n=this.shown;this.motion=t,this.shown=e,n===null||Km(n)!==Km(e)?(this.build(e),this.look("space")):n!==e&&this.redraw(e),this.set(this.now)}set(e){let t=this.shown;if(this.now=e,!t)return;let{travel:n}=e,s=t.travel,r=s.length,a=Math.min(ml(s,n),Math.max(r-2,0)),o=Math.min(a+1,r-1),l=o>a?(n-s[a])/(s[o]-s[a]):0;t.points.forEach((d,u)=>{let f=d[a],m=d[o];this.points[u].set(f[0]+l*(m[0]-f[0]),f[1]+l*(m[1]-f[1]),f[2]+l*(m[2]-f[2])+e.body)});let c=t.spin[a],h=t.spin[o];this.spin.set(c[0]+l*(h[0]-c[0]),c[1]+l*(h[1]-c[1]),c[2]+l*(h[2]-c[2])).normalize();for(let d of this.update)d();this.turnAbout(l<.5?a:o),this.isLost||(this.state.textContent=e.load>0?"":bt("noContact")),this.isDirty=!0}draw(){!this.isDirty||!this.isSeen||!this.shown||!this.begin()||(this.isDirty=!1,this.renderer.render(this.space,this.camera),this.names.hidden||this.place())}showCentres(e){this.centres=e,this.set(this.now)}choose(e){this.chosen=e,this.set(this.now)}turnAbout(e){let t=this.shown,n=t.contact[e];for(let{line:r,mark:a,of:o}of this.turned){let l=this.centres?.[o][e];if(r.visible=a.visible=!!l&&!!n,!l||!n)continue;let c=new V(n[0],n[1],n[2]+this.now.body),h=o==="side"?new V(l[0],c.y,l[1]):new V(c.x,l[0],l[1]);h.z+=this.now.body,r.geometry.setFromPoints([c,h]),a.position.copy(h)}if(!this.halo)return;let s=this.chosen===null?-1:t.names.indexOf(this.chosen);this.halo.visible=s>=0,s>=0&&this.halo.position.copy(this.points[s])}take(e){let t=this.shown;if(!this.grabbed||!t||e.button!==0||e.target!==this.canvas)return;let n=this.canvas.getBoundingClientRect(),s=new V,r=bM,a=-1;if(t.names.forEach((m,v)=>{if(t.feet.includes(v))return;s.copy(this.points[v]).project(this.camera);let _=Math.hypot(n.left+(.5+.5*s.x)*n.width-e.clientX,n.top+(.5-.5*s.y)*n.height-e.clientY);_<r&&(r=_,a=v)}),a<0)return;e.stopPropagation(),e.preventDefault(),this.canvas.focus({preventScroll:!0});let o=t.names[a],l=(this.camera.right-this.camera.left)/this.camera.zoom/n.width,c=new V().setFromMatrixColumn(this.camera.matrixWorld,0),h=new V().setFromMatrixColumn(this.camera.matrixWorld,1),d=m=>{let v=l*(m.clientX-e.clientX),_=-l*(m.clientY-e.clientY);if(this.way==="view")return c.clone().multiplyScalar(v).addScaledVector(h,_).toArray();let g="xyz".indexOf(this.way),x=c.getComponent(g),T=h.getComponent(g),S=x*x+T*T,R=[0,0,0];return S>.02&&(R[g]=(v*x+_*T)/S),R},u=m=>this.grabbed?.(o,d(m),!1),f=m=>{removeEventListener("pointermove",u),removeEventListener("pointerup",f),removeEventListener("pointercancel",f),this.grabbed?.(o,m.type==="pointerup"?d(m):[0,0,0],!0)};addEventListener("pointermove",u),addEventListener("pointerup",f),addEventListener("pointercancel",f),this.grabbed(o,[0,0,0],!1)}look(e){if(!this.controls||!this.shown)return;let[t,n,s]=Zm[e],r=this.shown.side,a=new V(1/0,1/0,1/0),o=a.clone().negate();for(let v of this.points)a.min(v),o.max(v);let{centre:l,radius:c,width:h}=this.shown.wheel,d=this.points[l];a.min(new V(d.x-c,d.y-h/2,d.z-c)),o.max(new V(d.x+c,d.y+h/2,d.z+c));let u=a.clone().add(o).multiplyScalar(.5);this.size=.5*a.distanceTo(o),this.controls.target.copy(u),this.camera.position.copy(u).add(new V(t,r*n,s+(e==="top"?0:.001)).normalize().multiplyScalar(6*this.size)),e==="top"&&(this.camera.position.x-=.01*this.size),this.camera.zoom=1,this.camera.near=.1,this.camera.far=20*this.size,this.controls.update(),this.camera.updateMatrixWorld();let f=o.clone().sub(a).multiplyScalar(.5),m=new V;this.reach=[0,1].map(v=>(m.setFromMatrixColumn(this.camera.matrixWorld,v),Math.abs(m.x)*f.x+Math.abs(m.y)*f.y+Math.abs(m.z)*f.z)),this.frame(),this.isDirty=!0}repaint(){this.shown&&(this.build(this.shown),this.set(this.now))}frame(){let{clientWidth:e,clientHeight:t}=this.canvas.parentElement,[n,s]=this.reach,r=Math.max(e,1)/Math.max(t,1),a=1.15*Math.max(s,n/r),o=a*r;Object.assign(this.camera,{left:-o,right:o,top:a,bottom:-a}),this.camera.updateProjectionMatrix()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas.parentElement;!this.renderer||e<10||t<10||(this.renderer.setSize(e,t,!1),this.frame(),this.isDirty=!0)}redraw(e){for(let[t,n]of this.pathGroup.children.entries())n.geometry.setFromPoints(Jm(t?e.contact:e.points[e.wheel.centre]))}build(e){this.space.remove(this.group),this.group.traverse(r=>{(r instanceof dn||r instanceof bs)&&r.geometry.dispose()}),this.group=new Xn,this.space.add(this.group),this.update=[],this.points=e.points.map(r=>new V(r[0][0],r[0][1],r[0][2]));let t=e.wheel.radius/22,n=Tt("ink"),s=r=>r==="#22262b"?n:r;for(let r of e.parts){let a=new Yn({color:new je(s(r.colour))});if(r.coil){this.coil(a,r.points[0],r.points[1],e,t);continue}let o=r.points.map((l,c)=>[c,c+1]).slice(0,-1);r.plate&&o.push([r.points.length-1,0]);for(let[l,c]of o){let h=new Mr(this.group,a,t);this.update.push(()=>h.between(this.points[r.points[l]],this.points[r.points[c]]))}r.plate&&r.points.length>=3&&this.plate(r.points,s(r.colour))}for(let[r,[a,o,l,,c]]of e.brackets.entries()){let h=new Mr(this.group,new Yn({color:new je(s(c))}),.5*t);this.update.push(()=>h.between(this.points[a],this.points[o].clone().lerp(this.points[l],this.shown.brackets[r][3])))}this.strut(e,t),this.joints(e,t),this.wheel(e),this.road(e),this.axis(e),this.paths(e),this.marks(t),this.named=e.names.map((r,a)=>a).filter(r=>!e.feet.includes(r)),this.names.replaceChildren(...this.labels=this.named.map(r=>p("span",{},e.names[r].replaceAll("_"," ")))),this.legend.replaceChildren(...[...e.parts,{words:bt("strut"),colour:e.strut.colour}].map(r=>{let a=p("i",{class:"swatch"});return a.style.background=s(r.colour),p("li",{},a,r.words)}))}marks(e){let t={front:Tt("other-1"),side:Tt("other-3"),roll:Tt("accent")};this.turned=Object.keys(t).map(n=>{let s=new bs(new un().setFromPoints([Sr,Sr]),new ys({color:new je(t[n])})),r=new dn(n==="roll"?new Ms(3*e,3*e,3*e):new mr(2*e,12,8),new Yn({color:new je(t[n])}));return s.frustumCulled=!1,s.visible=r.visible=!1,this.group.add(s,r),{line:s,mark:r,of:n}}),this.halo=new dn(new mr(2.6*e,16,12),new Yn({color:new je(Tt("accent")),transparent:!0,opacity:.7})),this.halo.visible=!1,this.group.add(this.halo)}axis(e){if(!e.axis)return;let[t,n]=e.axis,s=new un().setFromPoints([Sr,Sr]),r=new bs(s,new Ao({color:new je(Tt("muted")),dashSize:12,gapSize:7}));r.frustumCulled=!1,this.group.add(r),this.update.push(()=>{let a=this.points[t],o=this.points[n].clone().sub(a);s.setFromPoints([a.clone().addScaledVector(o,-.3),a.clone().addScaledVector(o,1.3)]),r.computeLineDistances()})}paths(e){let t=this.pathGroup.visible,n=new ys({color:new je(Tt("accent"))});this.pathGroup=new Xn,this.pathGroup.visible=t;for(let s of[e.points[e.wheel.centre],e.contact])this.pathGroup.add(new bs(new un().setFromPoints(Jm(s)),n));this.group.add(this.pathGroup),this.update.push(()=>this.pathGroup.position.setZ(this.now.body))}plate(e,t){let n=new un,s=e.length-2,r=new Float32Array(9*s);n.setAttribute("position",new jn(r,3));let a=new Yn({color:new je(t),transparent:!0,opacity:.25,side:ei,depthWrite:!1}),o=new dn(n,a);o.frustumCulled=!1,this.group.add(o),this.update.push(()=>{for(let l=0;l<s;l++)[e[0],e[l+1],e[l+2]].forEach((c,h)=>this.points[c].toArray(r,9*l+3*h));n.attributes.position.needsUpdate=!0,n.computeVertexNormals()})}strut(e,t){let n=new Yn({color:new je(e.strut.colour)}),s=new Mr(this.group,n,.6*t),r=new Mr(this.group,n,1.7*t),[a,o]=e.strut.damper;this.update.push(()=>{let h=this.points[a],d=this.points[o];s.between(h,d),r.between(h,h.clone().addScaledVector(d.clone().sub(h).normalize(),e.strut.tube))});let[l,c]=e.strut.spring;this.coil(n,l,c,e,t)}coil(e,t,n,s,r){let a=wM(s.strut.radius,s.strut.coils),o=new ma(EM(a)),l=new To(o,14*s.strut.coils,1,5),c=l.attributes.position.array.slice(),h=o.getSpacedPoints(14*s.strut.coils),d=new dn(l,e);this.group.add(d);let u=.55*r,f=new qn;this.update.push(()=>{let m=this.points[t],v=this.points[n].clone().sub(m),_=v.length();f.setFromUnitVectors(Sr,v.normalize());let g=l.attributes.position,x=new V,T=6;for(let S=0;S<g.count;S++){let R=h[Math.floor(S/T)];x.set(c[3*S]-R.x,0,c[3*S+2]-R.z);let w=c[3*S+1]-R.y;x.multiplyScalar(u).add(new V(R.x,(.08+.84*R.y)*_+u*w,R.z)),x.applyQuaternion(f).add(m),g.setXYZ(S,x.x,x.y,x.z)}g.needsUpdate=!0,l.computeVertexNormals()}),d.frustumCulled=!1}joints(e,t){let n=new mr(1.5*t,12,8),s=new Ms(2.6*t,2.6*t,2.6*t),r=new Yn({color:new je(Tt("muted"))}),a=new Yn({color:new je(Tt("ink"))});e.names.forEach((o,l)=>{if(l===e.wheel.centre||e.feet.includes(l))return;let c=new dn(e.onBody[l]?s:n,e.onBody[l]?r:a);this.group.add(c),this.update.push(()=>c.position.copy(this.points[l]))})}wheel(e){let{radius:t,width:n,centre:s}=e.wheel,r=this.wheelGroup.visible;this.wheelGroup=new Xn,this.wheelGroup.visible=r,this.group.add(this.wheelGroup);let a=new Yn({color:new je(Tt("rubber")),transparent:!0,opacity:.3,depthWrite:!1,side:ei}),o=new dn(new pa(t,t,.8*n,48,1,!0),a),l=[-.4,.4].map(d=>{let u=new dn(new Eo(.93*t,.07*t,8,48),a);return u.rotateX(Math.PI/2),u.position.y=d*n,u}),c=new Xn,h=new Yn({color:new je(Tt("rubber"))});for(let d=0;d<5;d++){let u=new Mr(c,h,t/60),f=2*Math.PI*d/5,m=.4*n*e.side;u.between(new V(.12*t*Math.cos(f),m,.12*t*Math.sin(f)),new V(.8*t*Math.cos(f),m,.8*t*Math.sin(f)))}this.wheelGroup.add(o,...l,c),this.update.push(()=>{this.wheelGroup.position.copy(this.points[s]);let d=this.spin.clone().multiplyScalar(e.side);this.wheelGroup.quaternion.setFromUnitVectors(Sr,d);let u=this.motion?.road?this.motion.road.speed*this.now.time:0;c.rotation.y=u/t})}road(e){let t=2.4*e.wheel.radius,n=.8*e.wheel.width,s=121,r=new un,a=new Float32Array(6*s),o=[];for(let u=0;u<s-1;u++)o.push(2*u,2*u+1,2*u+2,2*u+1,2*u+3,2*u+2);r.setAttribute("position",new jn(a,3)),r.setIndex(o);let l=new dn(r,new Yn({color:new je(Tt("road")),side:ei}));l.frustumCulled=!1;let c=new un,h=new Float32Array(12*(s-1));c.setAttribute("position",new jn(h,3));let d=new vo(c,new ys({color:new je(Tt("muted"))}));d.frustumCulled=!1,this.group.add(l,d),this.update.push(()=>{let u=this.points[e.wheel.centre],f=this.motion?.road,m=f?f.speed*this.now.time:0;for(let v=0;v<s;v++){let _=-t+2*t*v/(s-1),g=f?TM(f,m+_):this.now.ground;a.set([u.x+_,u.y-n,g,u.x+_,u.y+n,g],6*v)}for(let v=0;v<s-1;v++)for(let _ of[0,3])h.set([...a.subarray(6*v+_,6*v+_+3),...a.subarray(6*v+6+_,6*v+9+_)],12*v+2*_);r.attributes.position.needsUpdate=c.attributes.position.needsUpdate=!0,r.computeVertexNormals()})}place(){let{clientWidth:e,clientHeight:t}=this.canvas.parentElement,n=new V,s=this.labels.map(a=>a.offsetWidth),r=this.labels.map((a,o)=>{n.copy(this.points[this.named[o]]).project(this.camera);let l=(.5+.5*n.x)*e,c=s[o];return{label:a,width:c,x:l+c+8<e?l+7:l-c-7,y:(.5-.5*n.y)*t-8}}).sort((a,o)=>a.y-o.y);r.forEach((a,o)=>{let l=r.slice(0,o).filter(c=>c.x<a.x+a.width&&a.x<c.x+c.width);a.y=Math.max(a.y,...l.map(c=>c.y+MM)),a.label.style.transform=`translate(${a.x}px, ${a.y}px)`})}};function Jm(i){return i.map(e=>new V(e[0],e[1],e[2]))}function Km({points:i,spin:e,contact:t,travel:n,brackets:s,...r}){return JSON.stringify([r,s.map(([a,o,l])=>[a,o,l])])}function EM(i){let e=i.attributes.position;return Array.from({length:e.count},(t,n)=>new V(e.getX(n),e.getY(n),e.getZ(n)))}function TM(i,e){let{x:t,z:n}=i,s=t.length;if(e<=t[0])return n[0];if(e>=t[s-1])return n[s-1];let r=ml(t,e),a=t[r],o=t[r+1];return o>a?n[r]+(n[r+1]-n[r])*(e-a)/(o-a):n[r+1]}var AM="uplot",CM="u-hz",RM="u-vt",PM="u-title",LM="u-wrap",IM="u-under",DM="u-over",NM="u-axis",Tr="u-off",UM="u-select",OM="u-cursor-x",FM="u-cursor-y",kM="u-cursor-pt",BM="u-legend",zM="u-live",VM="u-inline",GM="u-series",HM="u-marker",jm="u-label",WM="u-value",qo="width",Yo="height";var Qm="bottom",Ea="left",Dd="right",Jd="#000",eg=Jd+"0",Nd="mousemove",tg="mousedown",Ud="mouseup",ng="mouseenter",ig="mouseleave",sg="dblclick",XM="resize",$M="scroll",rg="change",Eh="dppxchange",Kd="--",Ia=typeof window<"u",zd=Ia?document:null,Aa=Ia?window:null,qM=Ia?navigator:null,Lt,bh;function Vd(){let i=devicePixelRatio;Lt!=i&&(Lt=i,bh&&Hd(rg,bh,Vd),bh=matchMedia(`(min-resolution: ${Lt-.001}dppx) and (max-resolution: ${Lt+.001}dppx)`),Ar(rg,bh,Vd),Aa.dispatchEvent(new CustomEvent(Eh)))}function pi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Gd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Qt(i,e,t){i.style[e]=t+"px"}function ki(i,e,t,n){let s=zd.createElement(i);return e!=null&&pi(s,e),t?.insertBefore(s,n),s}function Mi(i,e){return ki("div",i,e)}var ag=new WeakMap;function is(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",a=ag.get(i);r!=a&&(i.style.transform=r,ag.set(i,r),e<0||t<0||e>n||t>s?pi(i,Tr):Gd(i,Tr))}var og=new WeakMap;function lg(i,e,t){let n=e+t,s=og.get(i);n!=s&&(og.set(i,n),i.style.background=e,i.style.borderColor=t)}var cg=new WeakMap;function hg(i,e,t,n){let s=e+""+t,r=cg.get(i);s!=r&&(cg.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var jd={passive:!0},YM={...jd,capture:!0};function Ar(i,e,t,n){e.addEventListener(i,t,n?YM:jd)}function Hd(i,e,t,n){e.removeEventListener(i,t,jd)}Ia&&Vd();function Bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:mi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function kg(i){return(t,n,s)=>{let r=-1,a=-1;for(let o=n;o<=s;o++)if(i(t[o])){r=o;break}for(let o=s;o>=n;o--)if(i(t[o])){a=o;break}return[r,a]}}var Bg=i=>i!=null,zg=i=>i!=null&&i>0,Ch=kg(Bg),ZM=kg(zg);function JM(i,e,t,n=0,s=!1){let r=s?ZM:Ch,a=s?zg:Bg;[e,t]=r(i,e,t);let o=i[e],l=i[e];if(e>-1)if(n==1)o=i[e],l=i[t];else if(n==-1)o=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];a(h)&&(h<o?o=h:h>l&&(l=h))}return[o??Gt,l??-Gt]}function Rh(i,e,t,n){let s=fg(i),r=fg(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let a=t==10?As:Vg,o=s==1?mi:wi,l=r==1?wi:mi,c=o(a(En(i))),h=l(a(En(e))),d=Ca(t,c),u=Ca(t,h);return t==10&&(c<0&&(d=Ht(d,-c)),h<0&&(u=Ht(u,-h))),n||t==2?(i=d*s,e=u*r):(i=Xg(i,d),e=Ph(e,u)),[i,e]}function Qd(i,e,t,n){let s=Rh(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var ef=.1,ug={mode:3,pad:ef},Jo={pad:0,soft:null,mode:0},KM={min:Jo,max:Jo};function Th(i,e,t,n){return Lh(t)?dg(i,e,t):(Jo.pad=t,Jo.soft=n?0:null,Jo.mode=n?3:0,dg(i,e,KM))}function At(i,e){return i??e}function jM(i,e,t){for(e=At(e,0),t=At(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function dg(i,e,t){let n=t.min,s=t.max,r=At(n.pad,0),a=At(s.pad,0),o=At(n.hard,-Gt),l=At(s.hard,Gt),c=At(n.soft,Gt),h=At(s.soft,-Gt),d=At(n.mode,0),u=At(s.mode,0),f=e-i,m=As(f),v=Jn(En(i),En(e)),_=As(v),g=En(_-m);(f<1e-24||g>10)&&(f=0,(i==0||e==0)&&(f=1e-24,d==2&&c!=Gt&&(r=0),u==2&&h!=-Gt&&(a=0)));let x=f||v||1e3,T=As(x),S=Ca(10,mi(T)),R=x*(f==0?i==0?.1:1:r),w=Ht(Xg(i-R,S/10),24),y=i>=c&&(d==1||d==3&&w<=c||d==2&&w>=c)?c:Gt,C=Jn(o,w<y&&i>=y?y:zi(y,w)),z=x*(f==0?e==0?.1:1:a),U=Ht(Ph(e+z,S/10),24),D=e<=h&&(u==1||u==3&&U>=h||u==2&&U<=h)?h:-Gt,L=zi(l,U>D&&e<=D?D:Jn(D,U));return C==L&&C==0&&(L=100),[C,L]}var QM=new Intl.NumberFormat(Ia?qM.language:"en-US"),tf=i=>QM.format(i),gi=Math,wh=gi.PI,En=gi.abs,mi=gi.floor,wn=gi.round,wi=gi.ceil,zi=gi.min,Jn=gi.max,Ca=gi.pow,fg=gi.sign,As=gi.log10,Vg=gi.log2,ew=(i,e=1)=>gi.sinh(i)*e,Od=(i,e=1)=>gi.asinh(i/e),Gt=1/0;function pg(i){return(As((i^i>>31)-(i>>31))|0)+1}function Wd(i,e,t){return zi(Jn(i,e),t)}function Gg(i){return typeof i=="function"}function Mt(i){return Gg(i)?i:()=>i}var tw=()=>{},Hg=i=>i,Wg=(i,e)=>e,nw=i=>null,mg=i=>!0,gg=(i,e)=>i==e,iw=/\.\d*?(?=9{6,}|0{6,})/gm,Cr=i=>{if(qg(i)||tr.has(i))return i;let e=`${i}`,t=e.match(iw);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Cr(s)}e${r}`}return Ht(i,n)};function wr(i,e){return Cr(Ht(Cr(i/e))*e)}function Ph(i,e){return Cr(wi(Cr(i/e))*e)}function Xg(i,e){return Cr(mi(Cr(i/e))*e)}function Ht(i,e=0){if(qg(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return wn(n)/t}var tr=new Map;function $g(i){return((""+i).split(".")[1]||"").length}function jo(i,e,t,n){let s=[],r=n.map($g);for(let a=e;a<t;a++){let o=En(a),l=Ht(Ca(i,a),o);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${a}`:n[c]*l,d=(a>=0?0:o)+(a>=r[c]?0:r[c]),u=i==10?h:Ht(h,d);s.push(u),tr.set(u,d)}}return s}var Ko={},nf=[],Ra=[null,null],er=Array.isArray,qg=Number.isInteger,sw=i=>i===void 0;function _g(i){return typeof i=="string"}function Lh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function rw(i){return i!=null&&typeof i=="object"}var aw=Object.getPrototypeOf(Uint8Array),Yg="__proto__";function Pa(i,e=Lh){let t;if(er(i)){let n=i.find(s=>s!=null);if(er(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Pa(i[s],e)}else t=i.slice()}else if(i instanceof aw)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Yg&&(t[n]=Pa(i[n],e))}else t=i;return t}function xn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Yg&&(Lh(i[s])?xn(i[s],Pa(n[s])):i[s]=Pa(n[s]))}return i}var ow=0,lw=1,cw=2;function hw(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let a=e[n];if(a>r){for(s=a-1;s>=0&&i[s]==null;)i[s--]=null;for(s=a+1;s<t&&i[s]==null;)i[r=s++]=null}}}function uw(i,e){if(pw(i)){let a=i[0].slice();for(let o=1;o<i.length;o++)a.push(...i[o].slice(1));return mw(a[0])||(a=fw(a)),a}let t=new Set;for(let a=0;a<i.length;a++){let l=i[a][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((a,o)=>a-o)],s=n[0].length,r=new Map;for(let a=0;a<s;a++)r.set(n[0][a],a);for(let a=0;a<i.length;a++){let o=i[a],l=o[0];for(let c=1;c<o.length;c++){let h=o[c],d=Array(s).fill(void 0),u=e?e[a][c]:lw,f=[];for(let m=0;m<h.length;m++){let v=h[m],_=r.get(l[m]);v===null?u!=ow&&(d[_]=v,u==cw&&f.push(_)):d[_]=v}hw(d,f,s),n.push(d)}}return n}var dw=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function fw(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,a)=>e[r]-e[a]);let s=[];for(let r=0;r<i.length;r++){let a=i[r],o=Array(t);for(let l=0;l<t;l++)o[l]=a[n[l]];s.push(o)}return s}function pw(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function mw(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Jn(1,mi((s-n+1)/e));for(let a=i[n],o=n+r;o<=s;o+=r){let l=i[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}var Zg=["January","February","March","April","May","June","July","August","September","October","November","December"],Jg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Kg(i){return i.slice(0,3)}var gw=Jg.map(Kg),_w=Zg.map(Kg),vw={MMMM:Zg,MMM:_w,WWWW:Jg,WWW:gw};function $o(i){return(i<10?"0":"")+i}function xw(i){return(i<10?"00":i<100?"0":"")+i}var yw={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>$o(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>$o(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>$o(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>$o(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>$o(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>xw(i.getMilliseconds())};function sf(i,e){e=e||vw;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?yw[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<t.length;o++)a+=typeof t[o]=="string"?t[o]:t[o](r,e);return a}}var bw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Sw(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==bw?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var jg=i=>i%1==0,Ah=[1,2,2.5,5],Mw=jo(10,-32,0,Ah),Qg=jo(10,0,32,Ah),ww=Qg.filter(jg),Er=Mw.concat(Qg),rf=`
`,e0="{YYYY}",vg=rf+e0,t0="{M}/{D}",Zo=rf+t0,Sh=Zo+"/{YY}",n0="{aa}",Ew="{h}:{mm}",Ta=Ew+n0,xg=rf+Ta,yg=":{ss}",Nt=null;function i0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,a=s*365,l=(i==1?jo(10,0,3,Ah).filter(jg):jo(10,-3,0,Ah)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]),c=[[a,e0,Nt,Nt,Nt,Nt,Nt,Nt,1],[s*28,"{MMM}",vg,Nt,Nt,Nt,Nt,Nt,1],[s,t0,vg,Nt,Nt,Nt,Nt,Nt,1],[n,"{h}"+n0,Sh,Nt,Zo,Nt,Nt,Nt,1],[t,Ta,Sh,Nt,Zo,Nt,Nt,Nt,1],[e,yg,Sh+" "+Ta,Nt,Zo+" "+Ta,Nt,xg,Nt,1],[i,yg+".{fff}",Sh+" "+Ta,Nt,Zo+" "+Ta,Nt,xg,Nt,1]];function h(d){return(u,f,m,v,_,g)=>{let x=[],T=_>=a,S=_>=r&&_<a,R=d(m),w=Ht(R*i,3),y=Fd(R.getFullYear(),T?0:R.getMonth(),S||T?1:R.getDate()),C=Ht(y*i,3);if(S||T){let z=S?_/r:0,U=T?_/a:0,D=w==C?w:Ht(Fd(y.getFullYear()+U,y.getMonth()+z,1)*i,3),L=new Date(wn(D/i)),F=L.getFullYear(),P=L.getMonth();for(let G=0;D<=v;G++){let q=Fd(F+U*G,P+z*G,1),W=q-d(Ht(q*i,3));D=Ht((+q+W)*i,3),D<=v&&x.push(D)}}else{let z=_>=s?s:_,U=mi(m)-mi(w),D=C+U+Ph(w-C,z);x.push(D);let L=d(D),F=L.getHours()+L.getMinutes()/t+L.getSeconds()/n,P=_/n,G=u.axes[f]._space,q=g/G;for(;D=Ht(D+_,i==1?0:3),!(D>v);)if(P>1){let W=mi(Ht(F+P,6))%24,Q=d(D).getHours()-W;Q>1&&(Q=-1),D-=Q*n,F=(F+P)%24;let te=x[x.length-1];Ht((D-te)/_,3)*q>=.7&&x.push(D)}else x.push(D)}return x}}return[l,c,h]}var[Tw,Aw,Cw]=i0(1),[Rw,Pw,Lw]=i0(.001);jo(2,-53,53,[1]);function bg(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Sg(i,e){return(t,n,s,r,a)=>{let o=e.find(m=>a>=m[0])||e[e.length-1],l,c,h,d,u,f;return n.map(m=>{let v=i(m),_=v.getFullYear(),g=v.getMonth(),x=v.getDate(),T=v.getHours(),S=v.getMinutes(),R=v.getSeconds(),w=_!=l&&o[2]||g!=c&&o[3]||x!=h&&o[4]||T!=d&&o[5]||S!=u&&o[6]||R!=f&&o[7]||o[1];return l=_,c=g,h=x,d=T,u=S,f=R,w(v)})}}function Iw(i,e){let t=sf(e);return(n,s,r,a,o)=>s.map(l=>t(i(l)))}function Fd(i,e,t){return new Date(i,e,t)}function Mg(i,e){return e(i)}var Dw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function wg(i,e){return(t,n,s,r)=>r==null?Kd:e(i(n))}function Nw(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function Uw(i,e){return i.series[e].fill(i,e)}var Ow={show:!0,live:!0,isolate:!1,mount:tw,markers:{show:!0,width:2,stroke:Nw,fill:Uw,dash:"solid"},idx:null,idxs:null,values:[]};function Fw(i,e){let t=i.cursor.points,n=Mi(),s=t.size(i,e);Qt(n,qo,s),Qt(n,Yo,s);let r=s/-2;Qt(n,"marginLeft",r),Qt(n,"marginTop",r);let a=t.width(i,e,s);return a&&Qt(n,"borderWidth",a),n}function kw(i,e){let t=i.series[e].points;return t._fill||t._stroke}function Bw(i,e){let t=i.series[e].points;return t._stroke||t._fill}function zw(i,e){return i.series[e].points.size}var kd=[0,0];function Vw(i,e,t){return kd[0]=e,kd[1]=t,kd}function Mh(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Bd(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var Gw={show:!0,x:!0,y:!0,lock:!1,move:Vw,points:{one:!1,show:Fw,size:zw,width:0,stroke:Bw,fill:kw},bind:{mousedown:Mh,mouseup:Mh,click:Mh,dblclick:Mh,mousemove:Bd,mouseleave:Bd,mouseenter:Bd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},s0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},af=xn({},s0,{filter:Wg}),r0=xn({},af,{size:10}),a0=xn({},s0,{show:!1}),of='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',o0="bold "+of,l0=1.5,Eg={show:!0,scale:"x",stroke:Jd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:o0,side:2,grid:af,ticks:r0,border:a0,font:of,lineGap:l0,rotate:0},Hw="Value",Ww="Time",Tg={show:!0,scale:"x",auto:!1,sorted:1,min:Gt,max:-Gt,idxs:[]};function Xw(i,e,t,n,s){return e.map(r=>r==null?"":tf(r))}function $w(i,e,t,n,s,r,a){let o=[],l=tr.get(s)||0;t=a?t:Ht(Ph(t,s),l);for(let c=t;c<=n;c=Ht(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function Xd(i,e,t,n,s,r,a){let o=[],l=i.scales[i.axes[e].scale].log,c=l==10?As:Vg,h=mi(c(t));s=Ca(l,h),l==10&&(s=Er[Bi(s,Er)]);let d=t,u=s*l;l==10&&(u=Er[Bi(u,Er)]);do o.push(d),d=d+s,l==10&&!tr.has(d)&&(d=Ht(d,tr.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=Er[Bi(u,Er)]));while(d<=n);return o}function qw(i,e,t,n,s,r,a){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Xd(i,e,Jn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?Xd(i,e,Jn(l,-n),-t,s):[l]).reverse().map(u=>-u).concat(h,c)}var c0=/./,Yw=/[12357]/,Zw=/[125]/,Ag=/1/,$d=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Jw(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=i.scales[a],l=i.valToPos,c=r._space,h=l(10,a),d=l(9,a)-h>=c?c0:l(7,a)-h>=c?Yw:l(5,a)-h>=c?Zw:Ag;if(d==Ag){let u=En(l(1,a)-h);if(u<c)return $d(e.slice().reverse(),o.distr,d,wi(c/u)).reverse()}return $d(e,o.distr,d,1)}function Kw(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=r._space,l=i.valToPos,c=En(l(1,a)-l(2,a));return c<o?$d(e.slice().reverse(),3,c0,wi(o/c)).reverse():e}function jw(i,e,t,n){return n==null?Kd:e==null?"":tf(e)}var Cg={show:!0,scale:"y",stroke:Jd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:o0,side:3,grid:af,ticks:r0,border:a0,font:of,lineGap:l0,rotate:0};function Qw(i,e){let t=3+(i||1)*2;return Ht(t*e,3)}function eE(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),a=i.valToPos(s[n[1]],t,!0),o=En(a-r),l=i.series[e],c=o/(l.points.space*Lt);return n[1]-n[0]<=c}var Rg={scale:null,auto:!0,sorted:0,min:Gt,max:-Gt},h0=(i,e,t,n,s)=>s,Pg={show:!0,auto:!0,sorted:0,gaps:h0,alpha:1,facets:[xn({},Rg,{scale:"x"}),xn({},Rg,{scale:"y"})]},Lg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:h0,alpha:1,points:{show:eE,filter:null},values:null,min:Gt,max:-Gt,idxs:[],path:null,clip:null};function tE(i,e,t,n,s){return t/10}var u0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},nE=xn({},u0,{time:!1,ori:1}),Ig={};function d0(i,e){let t=Ig[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,a,o,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,a,o,l,c)}},i!=null&&(Ig[i]=t)),t}var La=1,qd=2;function Rr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,a=i.scales,o=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?a[s.facets[0].scale]:a[i.series[0].scale],d=n==2?a[s.facets[1].scale]:a[s.scale],u=o.left,f=o.top,m=o.width,v=o.height,_=i.valToPosH,g=i.valToPosV;return h.ori==0?t(s,l,c,h,d,_,g,u,f,m,v,Dh,Da,Uh,p0,g0):t(s,l,c,h,d,g,_,f,u,v,m,Nh,Na,hf,m0,_0)}function lf(i,e){let t=0,n=0,s=At(i.bands,nf);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==e?t=a.dir:a.series[1]==e&&(a.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function iE(i,e,t,n,s){let r=i.mode,a=i.series[e],o=r==2?a.facets[1].scale:a.scale,l=i.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Cs(i,e,t,n,s,r){return Rr(i,e,(a,o,l,c,h,d,u,f,m,v,_)=>{let g=a.pxRound,x=c.dir*(c.ori==0?1:-1),T=c.ori==0?Da:Na,S,R;x==1?(S=t,R=n):(S=n,R=t);let w=g(d(o[S],c,v,f)),y=g(u(l[S],h,_,m)),C=g(d(o[R],c,v,f)),z=g(u(r==1?h.max:h.min,h,_,m)),U=new Path2D(s);return T(U,C,z),T(U,w,z),T(U,w,y),U})}function Ih(i,e,t,n,s,r){let a=null;if(i.length>0){a=new Path2D;let o=e==0?Uh:hf,l=t;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let f=u[0]-l;f>0&&o(a,l,n,f,n+r),l=u[1]}}let c=t+s-l,h=10;c>0&&o(a,l,n-h/2,c,n+r+h)}return a}function sE(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function cf(i,e,t,n,s,r,a){let o=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let d=c,u=c;if(s==1)for(;++c<=n&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let f=r(i[d]),m=u==d?f:r(i[u]),v=d-s;f=a<=0&&v>=0&&v<l?r(i[v]):f;let g=u+s;m=a>=0&&g>=0&&g<l?r(i[g]):m,m>=f&&o.push([f,m])}return o}function Dg(i){return i==0?Hg:i==1?wn:e=>wr(e,i)}function f0(i){let e=i==0?Dh:Nh,t=i==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},n=i==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,h=0)=>{c==0&&h==0?n(s,r,a,o,l):(c=zi(c,o/2,l/2),h=zi(h,o/2,l/2),e(s,r+c,a),t(s,r+o,a,r+o,a+l,c),t(s,r+o,a+l,r,a+l,h),t(s,r,a+l,r,a,h),t(s,r,a,r+o,a,c),s.closePath())}}var Dh=(i,e,t)=>{i.moveTo(e,t)},Nh=(i,e,t)=>{i.moveTo(t,e)},Da=(i,e,t)=>{i.lineTo(e,t)},Na=(i,e,t)=>{i.lineTo(t,e)},Uh=f0(0),hf=f0(1),p0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},m0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},g0=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(e,t,n,s,r,a)},_0=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(t,e,s,n,a,r)};function v0(i){return(e,t,n,s,r)=>Rr(e,t,(a,o,l,c,h,d,u,f,m,v,_)=>{let{pxRound:g,points:x}=a,T,S;c.ori==0?(T=Dh,S=p0):(T=Nh,S=m0);let R=Ht(x.width*Lt,3),w=(x.size-x.width)/2*Lt,y=Ht(w*2,3),C=new Path2D,z=new Path2D,{left:U,top:D,width:L,height:F}=e.bbox;Uh(z,U-y,D-y,L+y*2,F+y*2);let P=G=>{if(l[G]!=null){let q=g(d(o[G],c,v,f)),W=g(u(l[G],h,_,m));T(C,q+w,W),S(C,q,W,w,0,wh*2)}};if(r)r.forEach(P);else for(let G=n;G<=s;G++)P(G);return{stroke:R>0?C:null,fill:C,clip:z,flags:La|qd}})}function x0(i){return(e,t,n,s,r,a)=>{n!=s&&(r!=n&&a!=n&&i(e,t,n),r!=s&&a!=s&&i(e,t,s),i(e,t,a))}}var rE=x0(Da),aE=x0(Na);function y0(i){let e=At(i?.alignGaps,0);return(t,n,s,r)=>Rr(t,n,(a,o,l,c,h,d,u,f,m,v,_)=>{[s,r]=Ch(l,s,r);let g=a.pxRound,x=F=>g(d(F,c,v,f)),T=F=>g(u(F,h,_,m)),S,R;c.ori==0?(S=Da,R=rE):(S=Na,R=aE);let w=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:La},C=y.stroke,z=!1;if(r-s>=v*4){let F=de=>t.posToVal(de,c.key,!0),P=null,G=null,q,W,he,Z=x(o[w==1?s:r]),Q=x(o[s]),te=x(o[r]),ue=F(w==1?Q+1:te-1);for(let de=w==1?s:r;de>=s&&de<=r;de+=w){let j=o[de],ve=(w==1?j<ue:j>ue)?Z:x(j),Ee=l[de];ve==Z?Ee!=null?(W=Ee,P==null?(S(C,ve,T(W)),q=P=G=W):W<P?P=W:W>G&&(G=W)):Ee===null&&(z=!0):(P!=null&&R(C,Z,T(P),T(G),T(q),T(W)),Ee!=null?(W=Ee,S(C,ve,T(W)),P=G=q=W):(P=G=null,Ee===null&&(z=!0)),Z=ve,ue=F(Z+w))}P!=null&&P!=G&&he!=Z&&R(C,Z,T(P),T(G),T(q),T(W))}else for(let F=w==1?s:r;F>=s&&F<=r;F+=w){let P=l[F];P===null?z=!0:P!=null&&S(C,x(o[F]),T(P))}let[D,L]=lf(t,n);if(a.fill!=null||D!=0){let F=y.fill=new Path2D(C),P=a.fillTo(t,n,a.min,a.max,D),G=T(P),q=x(o[s]),W=x(o[r]);w==-1&&([W,q]=[q,W]),S(F,W,G),S(F,q,G)}if(!a.spanGaps){let F=[];z&&F.push(...cf(o,l,s,r,w,x,e)),y.gaps=F=a.gaps(t,n,s,r,F),y.clip=Ih(F,c.ori,f,m,v,_)}return L!=0&&(y.band=L==2?[Cs(t,n,s,r,C,-1),Cs(t,n,s,r,C,1)]:Cs(t,n,s,r,C,L)),y})}function oE(i){let e=At(i.align,1),t=At(i.ascDesc,!1),n=At(i.alignGaps,0),s=At(i.extend,!1);return(r,a,o,l)=>Rr(r,a,(c,h,d,u,f,m,v,_,g,x,T)=>{[o,l]=Ch(d,o,l);let S=c.pxRound,{left:R,width:w}=r.bbox,y=Q=>S(m(Q,u,x,_)),C=Q=>S(v(Q,f,T,g)),z=u.ori==0?Da:Na,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:La},D=U.stroke,L=u.dir*(u.ori==0?1:-1),F=C(d[L==1?o:l]),P=y(h[L==1?o:l]),G=P,q=P;s&&e==-1&&(q=R,z(D,q,F)),z(D,P,F);for(let Q=L==1?o:l;Q>=o&&Q<=l;Q+=L){let te=d[Q];if(te==null)continue;let ue=y(h[Q]),de=C(te);e==1?z(D,ue,F):z(D,G,de),z(D,ue,de),F=de,G=ue}let W=G;s&&e==1&&(W=R+w,z(D,W,F));let[he,Z]=lf(r,a);if(c.fill!=null||he!=0){let Q=U.fill=new Path2D(D),te=c.fillTo(r,a,c.min,c.max,he),ue=C(te);z(Q,W,ue),z(Q,q,ue)}if(!c.spanGaps){let Q=[];Q.push(...cf(h,d,o,l,L,y,n));let te=c.width*Lt/2,ue=t||e==1?te:-te,de=t||e==-1?-te:te;Q.forEach(j=>{j[0]+=ue,j[1]+=de}),U.gaps=Q=c.gaps(r,a,o,l,Q),U.clip=Ih(Q,u.ori,_,g,x,T)}return Z!=0&&(U.band=Z==2?[Cs(r,a,o,l,D,-1),Cs(r,a,o,l,D,1)]:Cs(r,a,o,l,D,Z)),U})}function Ng(i,e,t,n,s,r,a=Gt){if(i.length>1){let o=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(o!=null){let h=En(i[l]-i[o]);h<c&&(c=h,a=En(t(i[l],n,s,r)-t(i[o],n,s,r)))}o=l}}return a}function lE(i){i=i||Ko;let e=At(i.size,[.6,Gt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Mt(s),a=1-e[0],o=At(e[1],Gt),l=At(e[2],1),c=At(i.disp,Ko),h=At(i.each,f=>{}),{fill:d,stroke:u}=c;return(f,m,v,_)=>Rr(f,m,(g,x,T,S,R,w,y,C,z,U,D)=>{let L=g.pxRound,F=t,P=n*Lt,G=o*Lt,q=l*Lt,W,he;S.ori==0?[W,he]=r(f,m):[he,W]=r(f,m);let Z=S.dir*(S.ori==0?1:-1),Q=S.ori==0?Uh:hf,te=S.ori==0?h:(Le,Qe,ut,Te,Vt,$e,Je)=>{h(Le,Qe,ut,Vt,Te,Je,$e)},ue=At(f.bands,nf).find(Le=>Le.series[0]==m),de=ue!=null?ue.dir:0,j=g.fillTo(f,m,g.min,g.max,de),me=L(y(j,R,D,z)),ve,Ee,xe,qe=U,st=L(g.width*Lt),ae=!1,Xe=null,tt=null,rt=null,ft=null;d!=null&&(st==0||u!=null)&&(ae=!0,Xe=d.values(f,m,v,_),tt=new Map,new Set(Xe).forEach(Le=>{Le!=null&&tt.set(Le,new Path2D)}),st>0&&(rt=u.values(f,m,v,_),ft=new Map,new Set(rt).forEach(Le=>{Le!=null&&ft.set(Le,new Path2D)})));let{x0:Ct,size:qt}=c;if(Ct!=null&&qt!=null){F=1,x=Ct.values(f,m,v,_),Ct.unit==2&&(x=x.map(ut=>f.posToVal(C+ut*U,S.key,!0)));let Le=qt.values(f,m,v,_);qt.unit==2?Ee=Le[0]*U:Ee=w(Le[0],S,U,C)-w(0,S,U,C),qe=Ng(x,T,w,S,U,C,qe),xe=qe-Ee+P}else qe=Ng(x,T,w,S,U,C,qe),xe=qe*a+P,Ee=qe-xe;xe<1&&(xe=0),st>=Ee/2&&(st=0),xe<5&&(L=Hg);let wt=xe>0,sn=qe-xe-(wt?st:0);Ee=L(Wd(sn,q,G)),ve=(F==0?Ee/2:F==Z?0:Ee)-F*Z*((F==0?P/2:0)+(wt?st/2:0));let lt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Bt=ae?null:new Path2D,Wt=null;if(ue!=null)Wt=f.data[ue.series[1]];else{let{y0:Le,y1:Qe}=c;Le!=null&&Qe!=null&&(T=Qe.values(f,m,v,_),Wt=Le.values(f,m,v,_))}let fn=W*Ee,B=he*Ee;for(let Le=Z==1?v:_;Le>=v&&Le<=_;Le+=Z){let Qe=T[Le];if(Qe==null)continue;if(Wt!=null){let $=Wt[Le]??0;if(Qe-$==0)continue;me=y($,R,D,z)}let ut=S.distr!=2||c!=null?x[Le]:Le,Te=w(ut,S,U,C),Vt=y(At(Qe,j),R,D,z),$e=L(Te-ve),Je=L(Jn(Vt,me)),I=L(zi(Vt,me)),M=Je-I;if(Qe!=null){let $=Qe<0?B:fn,pe=Qe<0?fn:B;ae?(st>0&&rt[Le]!=null&&Q(ft.get(rt[Le]),$e,I+mi(st/2),Ee,Jn(0,M-st),$,pe),Xe[Le]!=null&&Q(tt.get(Xe[Le]),$e,I+mi(st/2),Ee,Jn(0,M-st),$,pe)):Q(Bt,$e,I+mi(st/2),Ee,Jn(0,M-st),$,pe),te(f,m,Le,$e-st/2,I,Ee+st,M)}}return st>0?lt.stroke=ae?ft:Bt:ae||(lt._fill=g.width==0?g._fill:g._stroke??g._fill,lt.width=0),lt.fill=ae?tt:Bt,lt})}function cE(i,e){let t=At(e?.alignGaps,0);return(n,s,r,a)=>Rr(n,s,(o,l,c,h,d,u,f,m,v,_,g)=>{[r,a]=Ch(c,r,a);let x=o.pxRound,T=W=>x(u(W,h,_,m)),S=W=>x(f(W,d,g,v)),R,w,y;h.ori==0?(R=Dh,y=Da,w=g0):(R=Nh,y=Na,w=_0);let C=h.dir*(h.ori==0?1:-1),z=T(l[C==1?r:a]),U=z,D=[],L=[];for(let W=C==1?r:a;W>=r&&W<=a;W+=C)if(c[W]!=null){let Z=l[W],Q=T(Z);D.push(U=Q),L.push(S(c[W]))}let F={stroke:i(D,L,R,y,w,x),fill:null,clip:null,band:null,gaps:null,flags:La},P=F.stroke,[G,q]=lf(n,s);if(o.fill!=null||G!=0){let W=F.fill=new Path2D(P),he=o.fillTo(n,s,o.min,o.max,G),Z=S(he);y(W,U,Z),y(W,z,Z)}if(!o.spanGaps){let W=[];W.push(...cf(l,c,r,a,C,T,t)),F.gaps=W=o.gaps(n,s,r,a,W),F.clip=Ih(W,h.ori,m,v,_,g)}return q!=0&&(F.band=q==2?[Cs(n,s,r,a,P,-1),Cs(n,s,r,a,P,1)]:Cs(n,s,r,a,P,q)),F})}function hE(i){return cE(uE,i)}function uE(i,e,t,n,s,r){let a=i.length;if(a<2)return null;let o=new Path2D;if(t(o,i[0],e[0]),a==2)n(o,i[1],e[1]);else{let l=Array(a),c=Array(a-1),h=Array(a-1),d=Array(a-1);for(let u=0;u<a-1;u++)h[u]=e[u+1]-e[u],d[u]=i[u+1]-i[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<a-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[a-1]=c[a-2];for(let u=0;u<a-1;u++)s(o,i[u]+d[u]/3,e[u]+l[u]*d[u]/3,i[u+1]-d[u]/3,e[u+1]-l[u+1]*d[u]/3,i[u+1],e[u+1])}return o}var Yd=new Set;function Ug(){for(let i of Yd)i.syncRect(!0)}Ia&&(Ar(XM,Aa,Ug),Ar($M,Aa,Ug,!0),Ar(Eh,Aa,()=>{In.pxRatio=Lt}));var dE=y0(),fE=v0();function Og(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,a)=>Zd(r,a,e,t))}function pE(i,e){return i.map((t,n)=>n==0?{}:xn({},e,t))}function Zd(i,e,t,n){return xn({},e==0?t:n,i)}function b0(i,e,t){return e==null?Ra:[e,t]}var mE=b0;function gE(i,e,t){return e==null?Ra:Th(e,t,ef,!0)}function S0(i,e,t,n){return e==null?Ra:Rh(e,t,i.scales[n].log,!1)}var _E=S0;function M0(i,e,t,n){return e==null?Ra:Qd(e,t,i.scales[n].log,!1)}var vE=M0;function xE(i,e,t,n,s){let r=Jn(pg(i),pg(e)),a=e-i,o=Bi(s/n*a,t);do{let l=t[o],c=n*l/a;if(c>=s&&r+(l<5?tr.get(l):0)<=17)return[l,c]}while(++o<t.length);return[0,0]}function Fg(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=wn((t=+s)*Lt))+"px"),[i,e,t]}function yE(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ht(e[2]*Lt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function In(i,e,t){let n={mode:At(i.mode,1)},s=n.mode;function r(b,E,N,O){let X=E.valToPct(b);return O+N*(E.dir==-1?1-X:X)}function a(b,E,N,O){let X=E.valToPct(b);return O+N*(E.dir==-1?X:1-X)}function o(b,E,N,O){return E.ori==0?r(b,E,N,O):a(b,E,N,O)}n.valToPosH=r,n.valToPosV=a;let l=!1;n.status=0;let c=n.root=Mi(AM);if(i.id!=null&&(c.id=i.id),pi(c,i.class),i.title){let b=Mi(PM,c);b.textContent=i.title}let h=ki("canvas"),d=n.ctx=h.getContext("2d"),u=Mi(LM,c);Ar("click",u,b=>{b.target===m&&(Zt!=Vr||en!=Gr)&&Dn.click(n,b)},!0);let f=n.under=Mi(IM,u);u.appendChild(h);let m=n.over=Mi(DM,u);i=Pa(i);let v=+At(i.pxAlign,1),_=Dg(v);(i.plugins||[]).forEach(b=>{b.opts&&(i=b.opts(n,i)||i)});let g=i.ms||.001,x=n.series=s==1?Og(i.series||[],Tg,Lg,!1):pE(i.series||[null],Pg),T=n.axes=Og(i.axes||[],Eg,Cg,!0),S=n.scales={},R=n.bands=i.bands||[];R.forEach(b=>{b.fill=Mt(b.fill||null),b.dir=At(b.dir,-1)});let w=s==2?x[1].facets[0].scale:x[0].scale,y={axes:os,series:vt},C=(i.drawOrder||["axes","series"]).map(b=>y[b]);function z(b){let E=b.distr==3?N=>As(N>0?N:b.clamp(n,N,b.min,b.max,b.key)):b.distr==4?N=>Od(N,b.asinh):b.distr==100?N=>b.fwd(N):N=>N;return N=>{let O=E(N),{_min:X,_max:K}=b,ce=K-X;return(O-X)/ce}}function U(b){let E=S[b];if(E==null){let N=(i.scales||Ko)[b]||Ko;if(N.from!=null){U(N.from);let O=xn({},S[N.from],N,{key:b});O.valToPct=z(O),S[b]=O}else{E=S[b]=xn({},b==w?u0:nE,N),E.key=b;let O=E.time,X=E.range,K=er(X);if((b!=w||s==2&&!O)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?ug:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?ug:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&Lh(X))){let ce=X;X=(ge,Me,Oe)=>Me==null?Ra:Th(Me,Oe,ce)}E.range=Mt(X||(O?mE:b==w?E.distr==3?_E:E.distr==4?vE:b0:E.distr==3?S0:E.distr==4?M0:gE)),E.auto=Mt(K?!1:E.auto),E.clamp=Mt(E.clamp||tE),E._min=E._max=null,E.valToPct=z(E)}}}U("x"),U("y"),s==1&&x.forEach(b=>{U(b.scale)}),T.forEach(b=>{U(b.scale)});for(let b in i.scales)U(b);let D=S[w],L=D.distr,F,P;D.ori==0?(pi(c,CM),F=r,P=a):(pi(c,RM),F=a,P=r);let G={};for(let b in S){let E=S[b];(E.min!=null||E.max!=null)&&(G[b]={min:E.min,max:E.max},E.min=E.max=null)}let q=i.tzDate||(b=>new Date(wn(b/g))),W=i.fmtDate||sf,he=g==1?Cw(q):Lw(q),Z=Sg(q,bg(g==1?Aw:Pw,W)),Q=wg(q,Mg(Dw,W)),te=[],ue=n.legend=xn({},Ow,i.legend),de=n.cursor=xn({},Gw,{drag:{y:s==2}},i.cursor),j=ue.show,me=de.show,ve=ue.markers;ue.idxs=te,ve.width=Mt(ve.width),ve.dash=Mt(ve.dash),ve.stroke=Mt(ve.stroke),ve.fill=Mt(ve.fill);let Ee,xe,qe,st=[],ae=[],Xe,tt=!1,rt={};if(ue.live){let b=x[1]?x[1].values:null;tt=b!=null,Xe=tt?b(n,1,0):{_:0};for(let E in Xe)rt[E]=Kd}if(j)if(Ee=ki("table",BM,c),qe=ki("tbody",null,Ee),ue.mount(n,Ee),tt){xe=ki("thead",null,Ee,qe);let b=ki("tr",null,xe);ki("th",null,b);for(var ft in Xe)ki("th",jm,b).textContent=ft}else pi(Ee,VM),ue.live&&pi(Ee,zM);let Ct={show:!0},qt={show:!1};function wt(b,E){if(E==0&&(tt||!ue.live||s==2))return Ra;let N=[],O=ki("tr",GM,qe,qe.childNodes[E]);pi(O,b.class),b.show||pi(O,Tr);let X=ki("th",null,O);if(ve.show){let ge=Mi(HM,X);if(E>0){let Me=ve.width(n,E);Me&&(ge.style.border=Me+"px "+ve.dash(n,E)+" "+ve.stroke(n,E)),ge.style.background=ve.fill(n,E)}}let K=Mi(jm,X);b.label instanceof HTMLElement?K.appendChild(b.label):K.textContent=b.label,E>0&&(ve.show||(K.style.color=b.width>0?ve.stroke(n,E):ve.fill(n,E)),lt("click",X,ge=>{if(de._lock)return;nt(ge);let Me=x.indexOf(b);if((ge.ctrlKey||ge.metaKey)!=ue.isolate){let Oe=x.some((Fe,Be)=>Be>0&&Be!=Me&&Fe.show);x.forEach((Fe,Be)=>{Be>0&&Wi(Be,Oe?Be==Me?Ct:qt:Ct,!0,_n.setSeries)})}else Wi(Me,{show:!b.show},!0,_n.setSeries)},!1),it&&lt(ng,X,ge=>{de._lock||(nt(ge),Wi(x.indexOf(b),Wr,!0,_n.setSeries))},!1));for(var ce in Xe){let ge=ki("td",WM,O);ge.textContent="--",N.push(ge)}return[O,N]}let sn=new Map;function lt(b,E,N,O=!0){let X=sn.get(E)||{},K=de.bind[b](n,E,N,O);K&&(Ar(b,E,X[b]=K),sn.set(E,X))}function Bt(b,E,N){let O=sn.get(E)||{};for(let X in O)(b==null||X==b)&&(Hd(X,E,O[X]),delete O[X]);b==null&&sn.delete(E)}let Wt=0,fn=0,B=0,Le=0,Qe=0,ut=0,Te=Qe,Vt=ut,$e=B,Je=Le,I=0,M=0,$=0,pe=0;n.bbox={};let le=!1,be=!1,Se=!1,ne=!1,se=!1,_e=!1;function k(b,E,N){(N||b!=n.width||E!=n.height)&&oe(b,E),pt(!1),Se=!0,be=!0,Nn()}function oe(b,E){n.width=Wt=B=b,n.height=fn=Le=E,Qe=ut=0,we(),Ye();let N=n.bbox;I=N.left=wr(Qe*Lt,.5),M=N.top=wr(ut*Lt,.5),$=N.width=wr(B*Lt,.5),pe=N.height=wr(Le*Lt,.5)}let ie=3;function Ae(){let b=!1,E=0;for(;!b;){E++;let N=kr(E),O=Hi(E);b=E==ie||N&&O,b||(oe(n.width,n.height),be=!0)}}function ye({width:b,height:E}){k(b,E)}n.setSize=ye;function we(){let b=!1,E=!1,N=!1,O=!1;T.forEach((X,K)=>{if(X.show&&X._show){let{side:ce,_size:ge}=X,Me=ce%2,Oe=X.label!=null?X.labelSize:0,Fe=ge+Oe;Fe>0&&(Me?(B-=Fe,ce==3?(Qe+=Fe,O=!0):N=!0):(Le-=Fe,ce==0?(ut+=Fe,b=!0):E=!0))}}),Vi[0]=b,Vi[1]=N,Vi[2]=E,Vi[3]=O,B-=Ei[1]+Ei[3],Qe+=Ei[3],Le-=Ei[2]+Ei[0],ut+=Ei[0]}function Ye(){let b=Qe+B,E=ut+Le,N=Qe,O=ut;function X(K,ce){switch(K){case 1:return b+=ce,b-ce;case 2:return E+=ce,E-ce;case 3:return N-=ce,N+ce;case 0:return O-=ce,O+ce}}T.forEach((K,ce)=>{if(K.show&&K._show){let ge=K.side;K._pos=X(ge,K._size),K.label!=null&&(K._lpos=X(ge,K.labelSize))}})}if(de.dataIdx==null){let b=de.hover,E=b.skip=new Set(b.skip??[]);E.add(void 0);let N=b.prox=Mt(b.prox),O=b.bias??=0;de.dataIdx=(X,K,ce,ge)=>{if(K==0)return ce;let Me=ce,Oe=N(X,K,ce,ge)??Gt,Fe=Oe>=0&&Oe<Gt,Be=D.ori==0?B:Le,ht=de.left,Rt=e[0],Et=e[K];if(E.has(Et[ce])){Me=null;let xt=null,et=null,Ze;if(O==0||O==-1)for(Ze=ce;xt==null&&Ze-- >0;)E.has(Et[Ze])||(xt=Ze);if(O==0||O==1)for(Ze=ce;et==null&&Ze++<Et.length;)E.has(Et[Ze])||(et=Ze);if(xt!=null||et!=null)if(Fe){let Kt=xt==null?-1/0:F(Rt[xt],D,Be,0),on=et==null?1/0:F(Rt[et],D,Be,0),Rn=ht-Kt,zt=on-ht;Rn<=zt?Rn<=Oe&&(Me=xt):zt<=Oe&&(Me=et)}else Me=et==null?xt:xt==null?et:ce-xt<=et-ce?xt:et}else Fe&&En(ht-F(Rt[ce],D,Be,0))>Oe&&(Me=null);return Me}}let nt=b=>{de.event=b};de.idxs=te,de._lock=!1;let fe=de.points;fe.show=Mt(fe.show),fe.size=Mt(fe.size),fe.stroke=Mt(fe.stroke),fe.width=Mt(fe.width),fe.fill=Mt(fe.fill);let Ve=n.focus=xn({},i.focus||{alpha:.3},de.focus),it=Ve.prox>=0,Pe=it&&fe.one,dt=[],Yt=[],zn=[];function Ha(b,E){let N=fe.show(n,E);if(N instanceof HTMLElement)return pi(N,kM),pi(N,b.class),is(N,-10,-10,B,Le),m.insertBefore(N,dt[E]),N}function Ur(b,E){if(s==1||E>0){let N=s==1&&S[b.scale].time,O=b.value;b.value=N?_g(O)?wg(q,Mg(O,W)):O||Q:O||jw,b.label=b.label||(N?Ww:Hw)}if(Pe||E>0){b.width=b.width==null?1:b.width,b.paths=b.paths||dE||nw,b.fillTo=Mt(b.fillTo||iE),b.pxAlign=+At(b.pxAlign,v),b.pxRound=Dg(b.pxAlign),b.stroke=Mt(b.stroke||null),b.fill=Mt(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let N=Qw(Jn(1,b.width),1),O=b.points=xn({},{size:N,width:Jn(1,N*.2),stroke:b.stroke,space:N*2,paths:fE,_stroke:null,_fill:null},b.points);O.show=Mt(O.show),O.filter=Mt(O.filter),O.fill=Mt(O.fill),O.stroke=Mt(O.stroke),O.paths=Mt(O.paths),O.pxAlign=b.pxAlign}if(j){let N=wt(b,E);st.splice(E,0,N[0]),ae.splice(E,0,N[1]),ue.values.push(null)}if(me){te.splice(E,0,null);let N=null;Pe?E==0&&(N=Ha(b,E)):E>0&&(N=Ha(b,E)),dt.splice(E,0,N),Yt.splice(E,0,0),zn.splice(E,0,0)}Cn("addSeries",E)}function Zh(b,E){E=E??x.length,b=s==1?Zd(b,E,Tg,Lg):Zd(b,E,{},Pg),x.splice(E,0,b),Ur(x[E],E)}n.addSeries=Zh;function ul(b){if(x.splice(b,1),j){ue.values.splice(b,1),ae.splice(b,1);let E=st.splice(b,1)[0];Bt(null,E.firstChild),E.remove()}me&&(te.splice(b,1),dt.splice(b,1)[0].remove(),Yt.splice(b,1),zn.splice(b,1)),Cn("delSeries",b)}n.delSeries=ul;let Vi=[!1,!1,!1,!1];function ss(b,E){if(b._show=b.show,b.show){let N=b.side%2,O=S[b.scale];O==null&&(b.scale=N?x[1].scale:w,O=S[b.scale]);let X=O.time;b.size=Mt(b.size),b.space=Mt(b.space),b.rotate=Mt(b.rotate),er(b.incrs)&&b.incrs.forEach(ce=>{!tr.has(ce)&&tr.set(ce,$g(ce))}),b.incrs=Mt(b.incrs||(O.distr==2?ww:X?g==1?Tw:Rw:Er)),b.splits=Mt(b.splits||(X&&O.distr==1?he:O.distr==3?Xd:O.distr==4?qw:$w)),b.stroke=Mt(b.stroke),b.grid.stroke=Mt(b.grid.stroke),b.ticks.stroke=Mt(b.ticks.stroke),b.border.stroke=Mt(b.border.stroke);let K=b.values;b.values=er(K)&&!er(K[0])?Mt(K):X?er(K)?Sg(q,bg(K,W)):_g(K)?Iw(q,K):K||Z:K||Xw,b.filter=Mt(b.filter||(O.distr>=3&&O.log==10?Jw:O.distr==3&&O.log==2?Kw:Wg)),b.font=Fg(b.font),b.labelFont=Fg(b.labelFont),b._size=b.size(n,null,E,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(Vi[E]=!0,b._el=Mi(NM,u))}}function rs(b,E,N,O){let[X,K,ce,ge]=N,Me=E%2,Oe=0;return Me==0&&(ge||K)&&(Oe=E==0&&!X||E==2&&!ce?wn(Eg.size/3):0),Me==1&&(X||ce)&&(Oe=E==1&&!K||E==3&&!ge?wn(Cg.size/2):0),Oe}let Wa=n.padding=(i.padding||[rs,rs,rs,rs]).map(b=>Mt(At(b,rs))),Ei=n._padding=Wa.map((b,E)=>b(n,E,Vi,0)),rn,cn=null,hn=null,Gi=s==1?x[0].idxs:null,ii=null,Ps=!1;function Xa(b,E){if(e=b??[],n.data=n._data=e,s==2){rn=0;for(let N=1;N<x.length;N++)rn+=e[N][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ii=e[0],rn=ii.length;let N=e;if(L==2){N=e.slice();let O=N[0]=Array(rn);for(let X=0;X<rn;X++)O[X]=X}n._data=e=N}if(pt(!0),Cn("setData"),L==2&&(Se=!0),E!==!1){let N=D;N.auto(n,Ps)?$a():Ds(w,N.min,N.max),ne=ne||de.left>=0,_e=!0,Nn()}}n.setData=Xa;function $a(){Ps=!0;let b,E;s==1&&(rn>0?(cn=Gi[0]=0,hn=Gi[1]=rn-1,b=e[0][cn],E=e[0][hn],L==2?(b=cn,E=hn):b==E&&(L==3?[b,E]=Rh(b,b,D.log,!1):L==4?[b,E]=Qd(b,b,D.log,!1):D.time?E=b+wn(86400/g):[b,E]=Th(b,E,ef,!0))):(cn=Gi[0]=b=null,hn=Gi[1]=E=null)),Ds(w,b,E)}let Or,Ls,Fr,A,H,ee,Y,J,Ce,Ie;function Re(b,E,N,O,X,K){b??=eg,N??=nf,O??="butt",X??=eg,K??="round",b!=Or&&(d.strokeStyle=Or=b),X!=Ls&&(d.fillStyle=Ls=X),E!=Fr&&(d.lineWidth=Fr=E),K!=H&&(d.lineJoin=H=K),O!=ee&&(d.lineCap=ee=O),N!=A&&d.setLineDash(A=N)}function Ne(b,E,N,O){E!=Ls&&(d.fillStyle=Ls=E),b!=Y&&(d.font=Y=b),N!=J&&(d.textAlign=J=N),O!=Ce&&(d.textBaseline=Ce=O)}function We(b,E,N,O,X=0){if(O.length>0&&b.auto(n,Ps)&&(E==null||E.min==null)){let K=At(cn,0),ce=At(hn,O.length-1),ge=N.min==null?JM(O,K,ce,X,b.distr==3):[N.min,N.max];b.min=zi(b.min,N.min=ge[0]),b.max=Jn(b.max,N.max=ge[1])}}let at={min:null,max:null};function _t(){for(let O in S){let X=S[O];G[O]==null&&(X.min==null||G[w]!=null&&X.auto(n,Ps))&&(G[O]=at)}for(let O in S){let X=S[O];G[O]==null&&X.from!=null&&G[X.from]!=null&&(G[O]=at)}G[w]!=null&&pt(!0);let b={};for(let O in G){let X=G[O];if(X!=null){let K=b[O]=Pa(S[O],rw);if(X.min!=null)xn(K,X);else if(O!=w||s==2)if(rn==0&&K.from==null){let ce=K.range(n,null,null,O);K.min=ce[0],K.max=ce[1]}else K.min=Gt,K.max=-Gt}}if(rn>0){x.forEach((O,X)=>{if(s==1){let K=O.scale,ce=G[K];if(ce==null)return;let ge=b[K];if(X==0){let Me=ge.range(n,ge.min,ge.max,K);ge.min=Me[0],ge.max=Me[1],cn=Bi(ge.min,e[0]),hn=Bi(ge.max,e[0]),hn-cn>1&&(e[0][cn]<ge.min&&cn++,e[0][hn]>ge.max&&hn--),O.min=ii[cn],O.max=ii[hn]}else O.show&&O.auto&&We(ge,ce,O,e[X],O.sorted);O.idxs[0]=cn,O.idxs[1]=hn}else if(X>0&&O.show&&O.auto){let[K,ce]=O.facets,ge=K.scale,Me=ce.scale,[Oe,Fe]=e[X],Be=b[ge],ht=b[Me];Be!=null&&We(Be,G[ge],K,Oe,K.sorted),ht!=null&&We(ht,G[Me],ce,Fe,ce.sorted),O.min=ce.min,O.max=ce.max}});for(let O in b){let X=b[O],K=G[O];if(X.from==null&&(K==null||K.min==null)){let ce=X.range(n,X.min==Gt?null:X.min,X.max==-Gt?null:X.max,O);X.min=ce[0],X.max=ce[1]}}}for(let O in b){let X=b[O];if(X.from!=null){let K=b[X.from];if(K.min==null)X.min=X.max=null;else{let ce=X.range(n,K.min,K.max,O);X.min=ce[0],X.max=ce[1]}}}let E={},N=!1;for(let O in b){let X=b[O],K=S[O];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let ce=K.distr;K._min=ce==3?As(K.min):ce==4?Od(K.min,K.asinh):ce==100?K.fwd(K.min):K.min,K._max=ce==3?As(K.max):ce==4?Od(K.max,K.asinh):ce==100?K.fwd(K.max):K.max,E[O]=N=!0}}if(N){x.forEach((O,X)=>{s==2?X>0&&E.y&&(O._paths=null):E[O.scale]&&(O._paths=null)});for(let O in E)Se=!0,Cn("setScale",O);me&&de.left>=0&&(ne=_e=!0)}for(let O in G)G[O]=null}function Ge(b){let E=Wd(cn-1,0,rn-1),N=Wd(hn+1,0,rn-1);for(;b[E]==null&&E>0;)E--;for(;b[N]==null&&N<rn-1;)N++;return[E,N]}function vt(){if(rn>0){let b=x.some(E=>E._focus)&&Ie!=Ve.alpha;b&&(d.globalAlpha=Ie=Ve.alpha),x.forEach((E,N)=>{if(N>0&&E.show&&(nn(N,!1),nn(N,!0),E._paths==null)){let O=Ie;Ie!=E.alpha&&(d.globalAlpha=Ie=E.alpha);let X=s==2?[0,e[N][0].length-1]:Ge(e[N]);E._paths=E.paths(n,N,X[0],X[1]),Ie!=O&&(d.globalAlpha=Ie=O)}}),x.forEach((E,N)=>{if(N>0&&E.show){let O=Ie;Ie!=E.alpha&&(d.globalAlpha=Ie=E.alpha),E._paths!=null&&Ot(N,!1);{let X=E._paths!=null?E._paths.gaps:null,K=E.points.show(n,N,cn,hn,X),ce=E.points.filter(n,N,K,X);(K||ce)&&(E.points._paths=E.points.paths(n,N,cn,hn,ce),Ot(N,!0))}Ie!=O&&(d.globalAlpha=Ie=O),Cn("drawSeries",N)}}),b&&(d.globalAlpha=Ie=1)}}function nn(b,E){let N=E?x[b].points:x[b];N._stroke=N.stroke(n,b),N._fill=N.fill(n,b)}function Ot(b,E){let N=E?x[b].points:x[b],{stroke:O,fill:X,clip:K,flags:ce,_stroke:ge=N._stroke,_fill:Me=N._fill,_width:Oe=N.width}=N._paths;Oe=Ht(Oe*Lt,3);let Fe=null,Be=Oe%2/2;E&&Me==null&&(Me=Oe>0?"#fff":ge);let ht=N.pxAlign==1&&Be>0;if(ht&&d.translate(Be,Be),!E){let Rt=I-Oe/2,Et=M-Oe/2,xt=$+Oe,et=pe+Oe;Fe=new Path2D,Fe.rect(Rt,Et,xt,et)}E?ke(ge,Oe,N.dash,N.cap,Me,O,X,ce,K):Ft(b,ge,Oe,N.dash,N.cap,Me,O,X,ce,Fe,K),ht&&d.translate(-Be,-Be)}function Ft(b,E,N,O,X,K,ce,ge,Me,Oe,Fe){let Be=!1;Me!=0&&R.forEach((ht,Rt)=>{if(ht.series[0]==b){let Et=x[ht.series[1]],xt=e[ht.series[1]],et=(Et._paths||Ko).band;er(et)&&(et=ht.dir==1?et[0]:et[1]);let Ze,Kt=null;Et.show&&et&&jM(xt,cn,hn)?(Kt=ht.fill(n,Rt)||K,Ze=Et._paths.clip):et=null,ke(E,N,O,X,Kt,ce,ge,Me,Oe,Fe,Ze,et),Be=!0}}),Be||ke(E,N,O,X,K,ce,ge,Me,Oe,Fe)}let yn=La|qd;function ke(b,E,N,O,X,K,ce,ge,Me,Oe,Fe,Be){Re(b,E,N,O,X),(Me||Oe||Be)&&(d.save(),Me&&d.clip(Me),Oe&&d.clip(Oe)),Be?(ge&yn)==yn?(d.clip(Be),Fe&&d.clip(Fe),yt(X,ce),pn(b,K,E)):ge&qd?(yt(X,ce),d.clip(Be),pn(b,K,E)):ge&La&&(d.save(),d.clip(Be),Fe&&d.clip(Fe),yt(X,ce),d.restore(),pn(b,K,E)):(yt(X,ce),pn(b,K,E)),(Me||Oe||Be)&&d.restore()}function pn(b,E,N){N>0&&(E instanceof Map?E.forEach((O,X)=>{d.strokeStyle=Or=X,d.stroke(O)}):E!=null&&b&&d.stroke(E))}function yt(b,E){E instanceof Map?E.forEach((N,O)=>{d.fillStyle=Ls=O,d.fill(N)}):E!=null&&b&&d.fill(E)}function as(b,E,N,O){let X=T[b],K;if(O<=0)K=[0,0];else{let ce=X._space=X.space(n,b,E,N,O),ge=X._incrs=X.incrs(n,b,E,N,O,ce);K=xE(E,N,ge,O,ce)}return X._found=K}function mn(b,E,N,O,X,K,ce,ge,Me,Oe){let Fe=ce%2/2;v==1&&d.translate(Fe,Fe),Re(ge,ce,Me,Oe,ge),d.beginPath();let Be,ht,Rt,Et,xt=X+(O==0||O==3?-K:K);N==0?(ht=X,Et=xt):(Be=X,Rt=xt);for(let et=0;et<b.length;et++)E[et]!=null&&(N==0?Be=Rt=b[et]:ht=Et=b[et],d.moveTo(Be,ht),d.lineTo(Rt,Et));d.stroke(),v==1&&d.translate(-Fe,-Fe)}function kr(b){let E=!0;return T.forEach((N,O)=>{if(!N.show)return;let X=S[N.scale];if(X.min==null){N._show&&(E=!1,N._show=!1,pt(!1));return}else N._show||(E=!1,N._show=!0,pt(!1));let K=N.side,ce=K%2,{min:ge,max:Me}=X,[Oe,Fe]=as(O,ge,Me,ce==0?B:Le);if(Fe==0)return;let Be=X.distr==2,ht=N._splits=N.splits(n,O,ge,Me,Oe,Fe,Be),Rt=X.distr==2?ht.map(Ze=>ii[Ze]):ht,Et=X.distr==2?ii[ht[1]]-ii[ht[0]]:Oe,xt=N._values=N.values(n,N.filter(n,Rt,O,Fe,Et),O,Fe,Et);N._rotate=K==2?N.rotate(n,xt,O,Fe):0;let et=N._size;N._size=wi(N.size(n,xt,O,b)),et!=null&&N._size!=et&&(E=!1)}),E}function Hi(b){let E=!0;return Wa.forEach((N,O)=>{let X=N(n,O,Vi,b);X!=Ei[O]&&(E=!1),Ei[O]=X}),E}function os(){for(let b=0;b<T.length;b++){let E=T[b];if(!E.show||!E._show)continue;let N=E.side,O=N%2,X,K,ce=E.stroke(n,b),ge=N==0||N==3?-1:1,[Me,Oe]=E._found;if(E.label!=null){let Hn=E.labelGap*ge,ai=wn((E._lpos+Hn)*Lt);Ne(E.labelFont[0],ce,"center",N==2?"top":Qm),d.save(),O==1?(X=K=0,d.translate(ai,wn(M+pe/2)),d.rotate((N==3?-wh:wh)/2)):(X=wn(I+$/2),K=ai);let ar=Gg(E.label)?E.label(n,b,Me,Oe):E.label;d.fillText(ar,X,K),d.restore()}if(Oe==0)continue;let Fe=S[E.scale],Be=O==0?$:pe,ht=O==0?I:M,Rt=E._splits,Et=Fe.distr==2?Rt.map(Hn=>ii[Hn]):Rt,xt=Fe.distr==2?ii[Rt[1]]-ii[Rt[0]]:Me,et=E.ticks,Ze=E.border,Kt=et.show?et.size:0,on=wn(Kt*Lt),Rn=wn((E.alignTo==2?E._size-Kt-E.gap:E.gap)*Lt),zt=E._rotate*-wh/180,ln=_(E._pos*Lt),si=(on+Rn)*ge,Gn=ln+si;K=O==0?Gn:0,X=O==1?Gn:0;let _i=E.font[0],Ti=E.align==1?Ea:E.align==2?Dd:zt>0?Ea:zt<0?Dd:O==0?"center":N==3?Dd:Ea,$i=zt||O==1?"middle":N==2?"top":Qm;Ne(_i,ce,Ti,$i);let ri=E.font[1]*E.lineGap,vi=Rt.map(Hn=>_(o(Hn,Fe,Be,ht))),Ai=E._values;for(let Hn=0;Hn<Ai.length;Hn++){let ai=Ai[Hn];if(ai!=null){O==0?X=vi[Hn]:K=vi[Hn],ai=""+ai;let ar=ai.indexOf(`
`)==-1?[ai]:ai.split(/\n/gm);for(let Wn=0;Wn<ar.length;Wn++){let kf=ar[Wn];zt?(d.save(),d.translate(X,K+Wn*ri),d.rotate(zt),d.fillText(kf,0,0),d.restore()):d.fillText(kf,X,K+Wn*ri)}}}et.show&&mn(vi,et.filter(n,Et,b,Oe,xt),O,N,ln,on,Ht(et.width*Lt,3),et.stroke(n,b),et.dash,et.cap);let qi=E.grid;qi.show&&mn(vi,qi.filter(n,Et,b,Oe,xt),O,O==0?2:1,O==0?M:I,O==0?pe:$,Ht(qi.width*Lt,3),qi.stroke(n,b),qi.dash,qi.cap),Ze.show&&mn([ln],[1],O==0?1:0,O==0?1:2,O==1?M:I,O==1?pe:$,Ht(Ze.width*Lt,3),Ze.stroke(n,b),Ze.dash,Ze.cap)}Cn("drawAxes")}function pt(b){x.forEach((E,N)=>{N>0&&(E._paths=null,b&&(s==1?(E.min=null,E.max=null):E.facets.forEach(O=>{O.min=null,O.max=null})))})}let an=!1,Vn=!1,kt=[];function gn(){Vn=!1;for(let b=0;b<kt.length;b++)Cn(...kt[b]);kt.length=0}function Nn(){an||(dw(yf),an=!0)}function dl(b,E=!1){an=!0,Vn=E,b(n),yf(),E&&kt.length>0&&queueMicrotask(gn)}n.batch=dl;function yf(){if(le&&(_t(),le=!1),Se&&(Ae(),Se=!1),be){if(Qt(f,Ea,Qe),Qt(f,"top",ut),Qt(f,qo,B),Qt(f,Yo,Le),Qt(m,Ea,Qe),Qt(m,"top",ut),Qt(m,qo,B),Qt(m,Yo,Le),Qt(u,qo,Wt),Qt(u,Yo,fn),h.width=wn(Wt*Lt),h.height=wn(fn*Lt),T.forEach(({_el:b,_show:E,_size:N,_pos:O,side:X})=>{if(b!=null)if(E){let K=X===3||X===0?N:0,ce=X%2==1;Qt(b,ce?"left":"top",O-K),Qt(b,ce?"width":"height",N),Qt(b,ce?"top":"left",ce?ut:Qe),Qt(b,ce?"height":"width",ce?Le:B),Gd(b,Tr)}else pi(b,Tr)}),Or=Ls=Fr=H=ee=Y=J=Ce=A=null,Ie=1,Za(!0),Qe!=Te||ut!=Vt||B!=$e||Le!=Je){pt(!1);let b=B/$e,E=Le/Je;if(me&&!ne&&de.left>=0){de.left*=b,de.top*=E,Br&&is(Br,wn(de.left),0,B,Le),zr&&is(zr,0,wn(de.top),B,Le);for(let N=0;N<dt.length;N++){let O=dt[N];O!=null&&(Yt[N]*=b,zn[N]*=E,is(O,wi(Yt[N]),wi(zn[N]),B,Le))}}if(Jt.show&&!se&&Jt.left>=0&&Jt.width>0){Jt.left*=b,Jt.width*=b,Jt.top*=E,Jt.height*=E;for(let N in tu)Qt(Hr,N,Jt[N])}Te=Qe,Vt=ut,$e=B,Je=Le}Cn("setSize"),be=!1}Wt>0&&fn>0&&(d.clearRect(0,0,h.width,h.height),Cn("drawClear"),C.forEach(b=>b()),Cn("draw")),Jt.show&&se&&(fl(Jt),se=!1),me&&ne&&(rr(null,!0,!1),ne=!1),ue.show&&ue.live&&_e&&(Qh(),_e=!1),l||(l=!0,n.status=1,Cn("ready")),Ps=!1,an=!1}n.redraw=(b,E)=>{Se=E||!1,b!==!1?Ds(w,D.min,D.max):Nn()};function Jh(b,E){let N=S[b];if(N.from==null){if(rn==0){let O=N.range(n,E.min,E.max,b);E.min=O[0],E.max=O[1]}if(E.min>E.max){let O=E.min;E.min=E.max,E.max=O}if(rn>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;b==w&&N.distr==2&&rn>0&&(E.min=Bi(E.min,e[0]),E.max=Bi(E.max,e[0]),E.min==E.max&&E.max++),G[b]=E,le=!0,Nn()}}n.setScale=Jh;let Kh,jh,Br,zr,bf,Sf,Vr,Gr,Mf,wf,Zt,en,Is=!1,Dn=de.drag,Tn=Dn.x,An=Dn.y;me&&(de.x&&(Kh=Mi(OM,m)),de.y&&(jh=Mi(FM,m)),D.ori==0?(Br=Kh,zr=jh):(Br=jh,zr=Kh),Zt=de.left,en=de.top);let Jt=n.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Hr=Jt.show?Mi(UM,Jt.over?m:f):null;function fl(b,E){if(Jt.show){for(let N in b)Jt[N]=b[N],N in tu&&Qt(Hr,N,b[N]);E!==!1&&Cn("setSelect")}}n.setSelect=fl;function J0(b){if(x[b].show)j&&Gd(st[b],Tr);else if(j&&pi(st[b],Tr),me){let N=Pe?dt[0]:dt[b];N!=null&&is(N,-10,-10,B,Le)}}function Ds(b,E,N){Jh(b,{min:E,max:N})}function Wi(b,E,N,O){E.focus!=null&&t_(b),E.show!=null&&x.forEach((X,K)=>{K>0&&(b==K||b==null)&&(X.show=E.show,J0(K),s==2?(Ds(X.facets[0].scale,null,null),Ds(X.facets[1].scale,null,null)):Ds(X.scale,null,null),Nn())}),N!==!1&&Cn("setSeries",b,E),O&&Ja("setSeries",n,b,E)}n.setSeries=Wi;function K0(b,E){xn(R[b],E)}function j0(b,E){b.fill=Mt(b.fill||null),b.dir=At(b.dir,-1),E=E??R.length,R.splice(E,0,b)}function Q0(b){b==null?R.length=0:R.splice(b,1)}n.addBand=j0,n.setBand=K0,n.delBand=Q0;function e_(b,E){x[b].alpha=E,me&&dt[b]!=null&&(dt[b].style.opacity=E),j&&st[b]&&(st[b].style.opacity=E)}let ls,Ns,sr,Wr={focus:!0};function t_(b){if(b!=sr){let E=b==null,N=Ve.alpha!=1;x.forEach((O,X)=>{if(s==1||X>0){let K=E||X==0||X==b;O._focus=E?null:K,N&&e_(X,K?1:Ve.alpha)}}),sr=b,N&&Nn()}}j&&it&&lt(ig,Ee,b=>{de._lock||(nt(b),sr!=null&&Wi(null,Wr,!0,_n.setSeries))});function Xi(b,E,N){let O=S[E];N&&(b=b/Lt-(O.ori==1?ut:Qe));let X=B;O.ori==1&&(X=Le,b=X-b),O.dir==-1&&(b=X-b);let K=O._min,ce=O._max,ge=b/X,Me=K+(ce-K)*ge,Oe=O.distr;return Oe==3?Ca(10,Me):Oe==4?ew(Me,O.asinh):Oe==100?O.bwd(Me):Me}function n_(b,E){let N=Xi(b,w,E);return Bi(N,e[0],cn,hn)}n.valToIdx=b=>Bi(b,e[0]),n.posToIdx=n_,n.posToVal=Xi,n.valToPos=(b,E,N)=>S[E].ori==0?r(b,S[E],N?$:B,N?I:0):a(b,S[E],N?pe:Le,N?M:0),n.setCursor=(b,E,N)=>{Zt=b.left,en=b.top,rr(null,E,N)};function Ef(b,E){Qt(Hr,Ea,Jt.left=b),Qt(Hr,qo,Jt.width=E)}function Tf(b,E){Qt(Hr,"top",Jt.top=b),Qt(Hr,Yo,Jt.height=E)}let qa=D.ori==0?Ef:Tf,Ya=D.ori==1?Ef:Tf;function i_(){if(j&&ue.live)for(let b=s==2?1:0;b<x.length;b++){if(b==0&&tt)continue;let E=ue.values[b],N=0;for(let O in E)ae[b][N++].firstChild.nodeValue=E[O]}}function Qh(b,E){if(b!=null&&(b.idxs?b.idxs.forEach((N,O)=>{te[O]=N}):sw(b.idx)||te.fill(b.idx),ue.idx=te[0]),j&&ue.live){for(let N=0;N<x.length;N++)(N>0||s==1&&!tt)&&s_(N,te[N]);i_()}_e=!1,E!==!1&&Cn("setLegend")}n.setLegend=Qh;function s_(b,E){let N=x[b],O=b==0&&L==2?ii:e[b],X;tt?X=N.values(n,b,E)??rt:(X=N.value(n,E==null?null:O[E],b,E),X=X==null?rt:{_:X}),ue.values[b]=X}function rr(b,E,N){Mf=Zt,wf=en,[Zt,en]=de.move(n,Zt,en),de.left=Zt,de.top=en,me&&(Br&&is(Br,wn(Zt),0,B,Le),zr&&is(zr,0,wn(en),B,Le));let O,X=cn>hn;ls=Gt,Ns=null;let K=D.ori==0?B:Le,ce=D.ori==1?B:Le;if(Zt<0||rn==0||X){O=de.idx=null;for(let ge=0;ge<x.length;ge++){let Me=dt[ge];Me!=null&&is(Me,-10,-10,B,Le)}it&&Wi(null,Wr,!0,b==null&&_n.setSeries),ue.live&&(te.fill(O),_e=!0)}else{let ge,Me,Oe;s==1&&(ge=D.ori==0?Zt:en,Me=Xi(ge,w),O=de.idx=Bi(Me,e[0],cn,hn),Oe=F(e[0][O],D,K,0));let Fe=-10,Be=-10,ht=0,Rt=0,Et=!0,xt="",et="";for(let Ze=s==2?1:0;Ze<x.length;Ze++){let Kt=x[Ze],on=te[Ze],Rn=on==null?null:s==1?e[Ze][on]:e[Ze][1][on],zt=de.dataIdx(n,Ze,O,Me),ln=zt==null?null:s==1?e[Ze][zt]:e[Ze][1][zt];if(_e=_e||ln!=Rn||zt!=on,te[Ze]=zt,Ze>0&&Kt.show){let si=zt==null?-10:zt==O?Oe:F(s==1?e[0][zt]:e[Ze][0][zt],D,K,0),Gn=ln==null?-10:P(ln,s==1?S[Kt.scale]:S[Kt.facets[1].scale],ce,0);if(it&&ln!=null){let _i=D.ori==1?Zt:en,Ti=En(Ve.dist(n,Ze,zt,Gn,_i));if(Ti<ls){let $i=Ve.bias;if($i!=0){let ri=Xi(_i,Kt.scale),vi=ln>=0?1:-1,Ai=ri>=0?1:-1;Ai==vi&&(Ai==1?$i==1?ln>=ri:ln<=ri:$i==1?ln<=ri:ln>=ri)&&(ls=Ti,Ns=Ze)}else ls=Ti,Ns=Ze}}if(_e||Pe){let _i,Ti;D.ori==0?(_i=si,Ti=Gn):(_i=Gn,Ti=si);let $i,ri,vi,Ai,qi,Hn,ai=!0,ar=fe.bbox;if(ar!=null){ai=!1;let Wn=ar(n,Ze);vi=Wn.left,Ai=Wn.top,$i=Wn.width,ri=Wn.height}else vi=_i,Ai=Ti,$i=ri=fe.size(n,Ze);if(Hn=fe.fill(n,Ze),qi=fe.stroke(n,Ze),Pe)Ze==Ns&&ls<=Ve.prox&&(Fe=vi,Be=Ai,ht=$i,Rt=ri,Et=ai,xt=Hn,et=qi);else{let Wn=dt[Ze];Wn!=null&&(Yt[Ze]=vi,zn[Ze]=Ai,hg(Wn,$i,ri,ai),lg(Wn,Hn,qi),is(Wn,wi(vi),wi(Ai),B,Le))}}}}if(Pe){let Ze=Ve.prox,Kt=sr==null?ls<=Ze:ls>Ze||Ns!=sr;if(_e||Kt){let on=dt[0];on!=null&&(Yt[0]=Fe,zn[0]=Be,hg(on,ht,Rt,Et),lg(on,xt,et),is(on,wi(Fe),wi(Be),B,Le))}}}if(Jt.show&&Is)if(b!=null){let[ge,Me]=_n.scales,[Oe,Fe]=_n.match,[Be,ht]=b.cursor.sync.scales,Rt=b.cursor.drag;if(Tn=Rt._x,An=Rt._y,Tn||An){let{left:Et,top:xt,width:et,height:Ze}=b.select,Kt=b.scales[Be].ori,on=b.posToVal,Rn,zt,ln,si,Gn,_i=ge!=null&&Oe(ge,Be),Ti=Me!=null&&Fe(Me,ht);_i&&Tn?(Kt==0?(Rn=Et,zt=et):(Rn=xt,zt=Ze),ln=S[ge],si=F(on(Rn,Be),ln,K,0),Gn=F(on(Rn+zt,Be),ln,K,0),qa(zi(si,Gn),En(Gn-si))):qa(0,K),Ti&&An?(Kt==1?(Rn=Et,zt=et):(Rn=xt,zt=Ze),ln=S[Me],si=P(on(Rn,ht),ln,ce,0),Gn=P(on(Rn+zt,ht),ln,ce,0),Ya(zi(si,Gn),En(Gn-si))):Ya(0,ce)}else nu()}else{let ge=En(Mf-bf),Me=En(wf-Sf);if(D.ori==1){let ht=ge;ge=Me,Me=ht}Tn=Dn.x&&ge>=Dn.dist,An=Dn.y&&Me>=Dn.dist;let Oe=Dn.uni;Oe!=null?Tn&&An&&(Tn=ge>=Oe,An=Me>=Oe,!Tn&&!An&&(Me>ge?An=!0:Tn=!0)):Dn.x&&Dn.y&&(Tn||An)&&(Tn=An=!0);let Fe,Be;Tn&&(D.ori==0?(Fe=Vr,Be=Zt):(Fe=Gr,Be=en),qa(zi(Fe,Be),En(Be-Fe)),An||Ya(0,ce)),An&&(D.ori==1?(Fe=Vr,Be=Zt):(Fe=Gr,Be=en),Ya(zi(Fe,Be),En(Be-Fe)),Tn||qa(0,K)),!Tn&&!An&&(qa(0,0),Ya(0,0))}if(Dn._x=Tn,Dn._y=An,b==null){if(N){if(Ff!=null){let[ge,Me]=_n.scales;_n.values[0]=ge!=null?Xi(D.ori==0?Zt:en,ge):null,_n.values[1]=Me!=null?Xi(D.ori==1?Zt:en,Me):null}Ja(Nd,n,Zt,en,B,Le,O)}if(it){let ge=N&&_n.setSeries,Me=Ve.prox;sr==null?ls<=Me&&Wi(Ns,Wr,!0,ge):ls>Me?Wi(null,Wr,!0,ge):Ns!=sr&&Wi(Ns,Wr,!0,ge)}}_e&&(ue.idx=O,Qh()),E!==!1&&Cn("setCursor")}let Us=null;Object.defineProperty(n,"rect",{get(){return Us==null&&Za(!1),Us}});function Za(b=!1){b?Us=null:(Us=m.getBoundingClientRect(),Cn("syncRect",Us))}function Af(b,E,N,O,X,K,ce){de._lock||Is&&b!=null&&b.movementX==0&&b.movementY==0||(eu(b,E,N,O,X,K,ce,!1,b!=null),b!=null?rr(null,!0,!0):rr(E,!0,!1))}function eu(b,E,N,O,X,K,ce,ge,Me){if(Us==null&&Za(!1),nt(b),b!=null)N=b.clientX-Us.left,O=b.clientY-Us.top;else{if(N<0||O<0){Zt=-10,en=-10;return}let[Oe,Fe]=_n.scales,Be=E.cursor.sync,[ht,Rt]=Be.values,[Et,xt]=Be.scales,[et,Ze]=_n.match,Kt=E.axes[0].side%2==1,on=D.ori==0?B:Le,Rn=D.ori==1?B:Le,zt=Kt?K:X,ln=Kt?X:K,si=Kt?O:N,Gn=Kt?N:O;if(Et!=null?N=et(Oe,Et)?o(ht,S[Oe],on,0):-10:N=on*(si/zt),xt!=null?O=Ze(Fe,xt)?o(Rt,S[Fe],Rn,0):-10:O=Rn*(Gn/ln),D.ori==1){let _i=N;N=O,O=_i}}Me&&(E==null||E.cursor.event.type==Nd)&&((N<=1||N>=B-1)&&(N=wr(N,B)),(O<=1||O>=Le-1)&&(O=wr(O,Le))),ge?(bf=N,Sf=O,[Vr,Gr]=de.move(n,N,O)):(Zt=N,en=O)}let tu={width:0,height:0,left:0,top:0};function nu(){fl(tu,!1)}let Cf,Rf,Pf,Lf;function If(b,E,N,O,X,K,ce){Is=!0,Tn=An=Dn._x=Dn._y=!1,eu(b,E,N,O,X,K,ce,!0,!1),b!=null&&(lt(Ud,zd,Df,!1),Ja(tg,n,Vr,Gr,B,Le,null));let{left:ge,top:Me,width:Oe,height:Fe}=Jt;Cf=ge,Rf=Me,Pf=Oe,Lf=Fe}function Df(b,E,N,O,X,K,ce){Is=Dn._x=Dn._y=!1,eu(b,E,N,O,X,K,ce,!1,!0);let{left:ge,top:Me,width:Oe,height:Fe}=Jt,Be=Oe>0||Fe>0,ht=Cf!=ge||Rf!=Me||Pf!=Oe||Lf!=Fe;if(Be&&ht&&fl(Jt),Dn.setScale&&Be&&ht){let Rt=ge,Et=Oe,xt=Me,et=Fe;if(D.ori==1&&(Rt=Me,Et=Fe,xt=ge,et=Oe),Tn&&Ds(w,Xi(Rt,w),Xi(Rt+Et,w)),An)for(let Ze in S){let Kt=S[Ze];Ze!=w&&Kt.from==null&&Kt.min!=Gt&&Ds(Ze,Xi(xt+et,Ze),Xi(xt,Ze))}nu()}else de.lock&&(de._lock=!de._lock,rr(E,!0,b!=null));b!=null&&(Bt(Ud,zd),Ja(Ud,n,Zt,en,B,Le,null))}function r_(b,E,N,O,X,K,ce){if(de._lock)return;nt(b);let ge=Is;if(Is){let Me=!0,Oe=!0,Fe=10,Be,ht;D.ori==0?(Be=Tn,ht=An):(Be=An,ht=Tn),Be&&ht&&(Me=Zt<=Fe||Zt>=B-Fe,Oe=en<=Fe||en>=Le-Fe),Be&&Me&&(Zt=Zt<Vr?0:B),ht&&Oe&&(en=en<Gr?0:Le),rr(null,!0,!0),Is=!1}Zt=-10,en=-10,te.fill(null),rr(null,!0,!0),ge&&(Is=ge)}function Nf(b,E,N,O,X,K,ce){de._lock||(nt(b),$a(),nu(),b!=null&&Ja(sg,n,Zt,en,B,Le,null))}function Uf(){T.forEach(yE),k(n.width,n.height,!0)}Ar(Eh,Aa,Uf);let Xr={};Xr.mousedown=If,Xr.mousemove=Af,Xr.mouseup=Df,Xr.dblclick=Nf,Xr.setSeries=(b,E,N,O)=>{let X=_n.match[2];N=X(n,E,N),N!=-1&&Wi(N,O,!0,!1)},me&&(lt(tg,m,If),lt(Nd,m,Af),lt(ng,m,b=>{nt(b),Za(!1)}),lt(ig,m,r_),lt(sg,m,Nf),Yd.add(n),n.syncRect=Za);let pl=n.hooks=i.hooks||{};function Cn(b,E,N){Vn?kt.push([b,E,N]):b in pl&&pl[b].forEach(O=>{O.call(null,n,E,N)})}(i.plugins||[]).forEach(b=>{for(let E in b.hooks)pl[E]=(pl[E]||[]).concat(b.hooks[E])});let Of=(b,E,N)=>N,_n=xn({key:null,setSeries:!1,filters:{pub:mg,sub:mg},scales:[w,x[1]?x[1].scale:null],match:[gg,gg,Of],values:[null,null]},de.sync);_n.match.length==2&&_n.match.push(Of),de.sync=_n;let Ff=_n.key,iu=d0(Ff);function Ja(b,E,N,O,X,K,ce){_n.filters.pub(b,E,N,O,X,K,ce)&&iu.pub(b,E,N,O,X,K,ce)}iu.sub(n);function a_(b,E,N,O,X,K,ce){_n.filters.sub(b,E,N,O,X,K,ce)&&Xr[b](null,E,N,O,X,K,ce)}n.pub=a_;function o_(){iu.unsub(n),Yd.delete(n),sn.clear(),Hd(Eh,Aa,Uf),c.remove(),Ee?.remove(),Cn("destroy")}n.destroy=o_;function su(){Cn("init",i,e),Xa(e||i.data,!1),G[w]?Jh(w,G[w]):$a(),se=Jt.show&&(Jt.width>0||Jt.height>0),ne=_e=!0,k(i.width,i.height)}return x.forEach(Ur),T.forEach(ss),t?t instanceof HTMLElement?(t.appendChild(c),su()):t(n,su):su(),n}In.assign=xn;In.fmtNum=tf;In.rangeNum=Th;In.rangeLog=Rh;In.rangeAsinh=Qd;In.orient=Rr;In.pxRatio=Lt;In.join=uw;In.fmtDate=sf,In.tzDate=Sw;In.sync=d0;{In.addGap=sE,In.clipGaps=Ih;let i=In.paths={points:v0};i.linear=y0,i.stepped=oE,i.bars=lE,i.spline=hE}var bE=62,SE={measured:{width:2},before:{width:1.25,dash:[5,3]},after:{width:1.25}},ME=0,Oh=class{constructor(e,t=()=>{}){this.moved=e;this.zoomed=t;new ResizeObserver(()=>this.resize()).observe(this.element),this.element.addEventListener("wheel",n=>this.wheel(n),{passive:!1}),this.element.addEventListener("dblclick",()=>this.reset())}moved;zoomed;key=`plots-${ME++}`;element=p("div",{class:"plots"});plots=[];heads=[];marks=[];shown=null;range=[0,1];busy=!1;place=0;show(e,t=null){if(this.refresh(e,t))return;this.clear(),this.shown=e;let{x:n}=e,s=n[0],r=n[n.length-1];this.range=t??e.window??[s,r],e.panes.forEach((a,o)=>this.add(a,o===e.panes.length-1)),this.mark(this.place),this.zoomed(this.range)}refresh(e,t){let n=r=>JSON.stringify([r.xLabel,r.panes.map(a=>[a.title,a.unit,a.lines.map(o=>[o.label,o.role])])]);if(!this.shown||n(this.shown)!==n(e))return!1;this.shown=e;let{x:s}=e;return this.range=t??e.window??[s[0],s[s.length-1]],e.panes.forEach((r,a)=>{let o=this.plots[a];r.lines.forEach((l,c)=>{o.series[c+1].show!==l.shown&&o.setSeries(c+1,{show:l.shown})}),o.setData([s,...r.lines.map(l=>l.y)])}),this.mark(this.place),this.zoomed(this.range),!0}clear(){this.shown=null;for(let e of this.plots)e.destroy();this.plots=[],this.heads=[],this.marks=[],this.element.replaceChildren()}get window(){return this.range}get whole(){let e=this.shown?.x;return e&&e.length?[e[0],e[e.length-1]]:[0,1]}reset(){this.zoom(...this.whole)}zoom(e,t){let[n,s]=this.whole,r=(s-n)*1e-4||1,a=Math.min(Math.max(t-e,r),s-n),o=Math.min(Math.max(e,n),s-a);this.range=[o,o+a],this.busy=!0;for(let l of this.plots)l.setScale("x",{min:this.range[0],max:this.range[1]});this.busy=!1,this.mark(this.place),this.zoomed(this.range)}zoomBy(e,t=(this.range[0]+this.range[1])/2){this.zoom(t-(t-this.range[0])*e,t+(this.range[1]-t)*e)}pan(e){let t=this.range[1]-this.range[0];this.zoom(this.range[0]+e*t,this.range[1]+e*t)}setShown(e,t){this.shown?.panes.forEach((n,s)=>n.lines.forEach((r,a)=>{r.role===e&&(r.shown=t,this.plots[s].setSeries(a+1,{show:t}))})),this.mark(this.place)}mark(e){this.place=e;let t=this.shown;t&&t.panes.forEach((n,s)=>{let r=this.plots[s],a=r.valToPos(e,"x"),o=e>=this.range[0]&&e<=this.range[1];this.marks[s].style.transform=`translateX(${a}px)`,this.marks[s].hidden=!o;let l=this.heads[s].querySelectorAll("output");n.lines.forEach((c,h)=>{let d=l[h];d.parentElement.hidden=!c.shown,c.shown&&(d.textContent=zf(lr(t.x,c.y,e),c.step))})})}repaint(){let{shown:e,range:t}=this;e&&(this.clear(),this.show(e,t))}add(e,t){let n=this.shown,s=p("div",{class:"pane-head"},p("span",{},p("b",{},e.title),p("span",{class:"unit"},` [${e.unit||"–"}]`)));for(let f of e.lines)s.append(p("span",{class:"value"},...f.label?[p("i",{class:`swatch ${f.role}`}),`${f.label} `]:[],p("output",{},"–")));let r=p("div",{class:"pane"});this.element.append(s,r);let a=Tt("ink"),o={stroke:Tt("line"),width:1},l=Tt("span"),c="12px system-ui, sans-serif",h=(f,m)=>EE(m),d=wE(()=>new In({width:Math.max(this.element.clientWidth,200),height:this.height(t),padding:[6,12,0,0],legend:{show:!1},cursor:{sync:{key:this.key,setSeries:!1},drag:{x:!0,y:!1,setScale:!1},points:{show:!1},y:!1,bind:{dblclick:()=>null}},scales:{x:{time:!1,auto:!1,range:()=>this.range},y:{range:(f,m,v)=>TE(m,v)}},axes:[{stroke:a,grid:o,ticks:{show:!1},size:t?24:6,font:c,values:t?h:()=>[],label:t?n.xLabel:void 0,labelSize:16,labelFont:c,labelGap:0,gap:3},{stroke:a,grid:o,ticks:{show:!1},size:bE,font:c,values:h}],series:[{},...e.lines.map(f=>{let m=SE[f.role]??{width:1.25};return{label:f.label,stroke:Tt(f.role),points:{show:!1},show:f.shown,...m}})],hooks:{drawClear:[f=>{f.ctx.fillStyle=l;for(let[m,v]of n.spans){let _=Math.max(m,this.range[0]),g=Math.min(v,this.range[1]);g>_&&f.ctx.fillRect(f.valToPos(_,"x",!0),f.bbox.top,f.valToPos(g,"x",!0)-f.valToPos(_,"x",!0),f.bbox.height)}}],setSelect:[f=>{f.select.width>4&&this.zoom(f.posToVal(f.select.left,"x"),f.posToVal(f.select.left+f.select.width,"x")),f.setSelect({left:0,top:0,width:0,height:0},!1)}],setCursor:[f=>{this.busy||f.cursor.left===void 0||f.cursor.left===null||f.cursor.left<0||!f.cursor.event||this.moved(f.posToVal(f.cursor.left,"x"))}]}},[n.x,...e.lines.map(f=>f.y)],r)),u=p("div",{class:"mark-line"});d.over.append(u),d.over.style.touchAction="pan-y",this.plots.push(d),this.heads.push(s),this.marks.push(u)}height(e){let t=this.shown?.panes.length??1;return(t>3?96:t===3?120:t===2?165:250)+(e?40:6)+6}resize(){let e=this.element.clientWidth;e<50||(this.plots.forEach((t,n)=>t.setSize({width:e,height:this.height(n===this.plots.length-1)})),this.mark(this.place))}wheel(e){if(!e.ctrlKey&&!e.shiftKey)return;e.preventDefault();let t=this.plots[0];t&&(e.shiftKey?this.pan(Math.sign(e.deltaY||e.deltaX)*.1):this.zoomBy(e.deltaY>0?1.25:.8,t.posToVal(e.clientX-t.over.getBoundingClientRect().left,"x")))}};function wE(i){if(Ka())return i();let e=HTMLCanvasElement.prototype,t=e.getContext;e.getContext=function(n,s){return t.call(this,n,n==="2d"?{...s,willReadFrequently:!0}:s)};try{return i()}finally{e.getContext=t}}function EE(i){let e=i.map(n=>String(Number(n.toPrecision(10))));if(e.some(n=>n.includes("e")))return e.map(cs);let t=Math.max(0,...e.map(n=>n.split(".")[1]?.length??0));return i.map(n=>cs(n===0?"0":n.toFixed(t)))}function TE(i,e){if(i===null||e===null)return[0,1];if(e>i)return In.rangeNum(i,e,.1,!0);let t=.1*Math.abs(i)||1;return[i-t,i+t]}var AE=[1,2,5,10,20,50,100],CE=matchMedia("(max-width: 40rem)").matches?6:16,w0=matchMedia("(prefers-reduced-motion: reduce)"),Ua=class{constructor(e,t){this.model=e;this.store=t;this.scene=e.scenes[0],this.view=e.scenes.some(n=>n.motion)?new Qs(e.stage):null,e.scenes.forEach((n,s)=>this.choice.append(p("option",{value:String(s)},n.label))),this.build(),this.show(this.scene),Ri(()=>{this.plots.repaint(),this.view?.repaint(),this.draw()}),requestAnimationFrame(n=>this.step(n))}model;store;element=p("div",{class:"player",tabindex:"-1"});plots=new Oh(e=>{this.playing||this.goTo(e)},e=>this.seen(e));view;choice=p("select",{"aria-label":bt("choice")});note=p("span",{class:"mark"});overlays=p("div",{class:"group overlays",role:"group","aria-label":bt("curves")});channels=p("div",{class:"group channels",role:"group","aria-label":bt("channels")});play=p("button",{type:"button",class:"play"},bt("play"));slider=p("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":""});clock=p("output",{class:"clock"});speed=p("select",{"aria-label":bt("speed")});roles=new Map;panes=new Map;livelyPart=p("button",{type:"button",title:bt("zoomToEvent"),click:()=>this.lively()},bt("event"));scene;now=0;playing=!1;way=1;last=0;frames=[];choose(e){let t=this.model.scenes.findIndex(n=>n.name===e);return t<0?!1:(this.choice.value=String(t),this.show(this.model.scenes[t]),!0)}replace(e,t){let n=Math.max(this.model.scenes.indexOf(this.scene),0),s=this.plots.window,[r,a]=this.plots.whole,o=e.scenes[Math.min(n,e.scenes.length-1)],l=s[0]<=r&&s[1]>=a;e.roles.length!==this.model.roles.length&&this.offerRoles(e),this.model=e,this.store=t,this.scene=o;let c=t.get(o.x);this.slider.min=String(c[0]),this.slider.max=String(c[c.length-1]),this.plot(l?null:s),o.motion&&this.view&&this.view.show(t.content.mechanisms[o.motion.mechanism],o.motion),this.goTo(this.now)}zoom(e,t){this.plots.zoom(e,t)}goTo(e){let[t,n]=this.plots.whole;this.now=Math.min(Math.max(e,t),n),this.slider.value=String(this.now),this.clock.textContent=`${cs(this.now.toFixed(3))} ${this.model.x.unit}`,this.plots.mark(this.now);let s=this.scene.motion;if(s&&this.view){let r=this.store.get(this.scene.x),a=o=>lr(r,this.store.get(o),this.now);this.view.set({body:a(s.body),travel:a(s.travel),ground:a(s.ground),load:a(s.load),time:this.now})}}build(){let{model:e}=this;this.offerRoles(e);let t=h=>()=>this.stepScene(h),n=p("div",{class:"group"},p("button",{type:"button",title:bt("previous"),click:t(-1)},"‹"),this.choice,p("button",{type:"button",title:bt("next"),click:t(1)},"›"),this.note);this.choice.addEventListener("change",()=>this.show(e.scenes[Number(this.choice.value)])),e.scenes.length<2&&(n.hidden=!0);let s=p("div",{class:"group"},p("button",{type:"button",title:bt("zoomIn"),click:()=>this.plots.zoomBy(.5,this.now)},"+"),p("button",{type:"button",title:bt("zoomOut"),click:()=>this.plots.zoomBy(2,this.now)},"−"),p("button",{type:"button",title:bt("everything"),click:()=>this.plots.reset()},bt("all")),this.livelyPart),r=Ci(bt("wide"),!1,h=>{this.element.classList.toggle("wide",h),document.body.classList.toggle("behind",h)},bt("fillWindow"));r.classList.add("widen");let a=e.x.unit==="s",o=e.slower??(a?10:2),l=[...new Set([...AE,o])].sort((h,d)=>h-d);for(let h of l)this.speed.append(p("option",{value:String(h)},h>1?`1/${h}`:bt(a?"realTime":"fast")));this.speed.value=String(o),this.play.addEventListener("click",()=>this.toggle()),this.slider.addEventListener("input",()=>{this.pause(),this.goTo(Number(this.slider.value))});let c=p("div",{class:this.view?e.stage?"stage-and-plots stage-first":"stage-and-plots":"plots-only"},this.plots.element);this.view&&c.append(this.view.element),this.element.append(p("div",{class:"bar"},n,this.overlays,p("span",{class:"grow"}),s,r),p("div",{class:"bar"},this.channels),c,p("div",{class:"bar transport"},this.play,this.slider,this.clock,p("label",{},`${bt("speed")} `,this.speed)),p("p",{class:"hint"},bt("hint"))),this.element.addEventListener("keydown",h=>this.key(h))}offerRoles(e){let t=e.roles.map(({role:n,label:s,shown:r})=>{this.roles.has(n)||this.roles.set(n,r);let a=Ci(s,this.roles.get(n),o=>{this.roles.set(n,o),this.plots.setShown(n,o)});return a.prepend(p("i",{class:`swatch ${n}`})),a});this.overlays.replaceChildren(...t),this.overlays.hidden=t.length<2}show(e){let t=this.scene===e?null:this.keptWindow(e);this.scene=e,this.note.textContent=e.note,this.note.parentElement.className=`group ${e.tone}`,this.note.hidden=!e.note,this.livelyPart.hidden=!e.window;let n=this.store.get(e.x);this.offer(e),this.slider.min=String(n[0]),this.slider.max=String(n[n.length-1]),this.plot(t),e.motion&&this.view&&this.view.show(this.store.content.mechanisms[e.motion.mechanism],e.motion),this.goTo(this.now),this.draw()}offer(e){let t=e.panes.length>CE,n=0,s=e.panes.length<2?[]:e.panes.map(r=>{let a=this.isShown(r.name,r.shown),o=Ci(r.name,a,l=>{this.panes.set(r.name,l),this.plot(this.plots.window)},r.words);return t&&!a&&(o.classList.add("other"),n++),o});if(n){let r=this.channels.classList.contains("every");s.push(Ci(bt("more",String(n)),r,a=>{this.channels.classList.toggle("every",a)},bt("otherChannels")))}this.channels.replaceChildren(...s)}plot(e){let{scene:t}=this,n=t.panes.filter(s=>this.isShown(s.name,s.shown));n.length||(n=t.panes.slice(0,1)),this.slider.setAttribute("aria-label",this.model.x.words),this.plots.show({x:this.store.get(t.x),xLabel:`${this.model.x.words} [${this.model.x.unit}]`,spans:t.spans,window:t.window,panes:n.map(s=>({title:s.words,unit:s.unit,lines:s.curves.map(r=>({label:this.model.roles.length>1?r.label:"",role:r.role,y:this.store.get(r.y),step:this.store.step(r.y),shown:this.roles.get(r.role)??!0}))}))},e),this.plots.mark(this.now)}isShown(e,t){return this.panes.get(e)??t}keptWindow(e){let[t,n]=this.plots.window,[s,r]=this.plots.whole,a=this.store.get(e.x);if(t<=s&&n>=r)return[a[0],a[a.length-1]];let o=this.scene.window;return o&&Math.abs(t-o[0])<1e-9&&Math.abs(n-o[1])<1e-9?null:t>=a[0]&&n<=a[a.length-1]?[t,n]:null}lively(){this.scene.window?this.plots.zoom(...this.scene.window):this.plots.reset()}stepScene(e){let{scenes:t}=this.model,n=(t.indexOf(this.scene)+e+t.length)%t.length;this.choose(t[n].name)}seen([e,t]){(this.now<e||this.now>t)&&this.goTo(e)}toggle(){this.playing?this.pause():this.start()}start(){let[e,t]=this.plots.window;(this.now>=t-1e-9*(t-e)||this.now<e)&&this.goTo(e),this.playing=!0,this.way=1,this.last=0,this.frames.length=0,this.play.textContent=bt("pause")}get rate(){let[e,t]=this.plots.whole;return this.model.x.unit==="s"?1:(t-e)/2}pause(){this.playing=!1,this.play.textContent=bt("play")}step(e){if(this.playing){let t=this.last?e-this.last:0;this.last&&(this.frames.push(t),this.frames.length>600&&this.frames.shift()),this.last=e;let[n,s]=this.plots.window,r=this.now+this.way*this.rate*Math.min(t,250)/1e3/Number(this.speed.value);(r>s||r<n)&&(w0.matches&&this.pause(),this.model.x.unit!=="s"&&(this.way=-this.way),r=w0.matches||this.model.x.unit!=="s"?Math.min(Math.max(r,n),s):n),this.goTo(r)}this.draw(),requestAnimationFrame(t=>this.step(t))}draw(){this.view?.draw()}key(e){if(e.ctrlKey||e.metaKey||e.altKey||e.target instanceof HTMLSelectElement)return;let t=e.target instanceof HTMLButtonElement,n=e.target===this.slider,s=this.store.get(this.scene.x),r=(s[s.length-1]-s[0])/Math.max(s.length-1,1),a={"+":()=>this.plots.zoomBy(.5,this.now),"=":()=>this.plots.zoomBy(.5,this.now),"-":()=>this.plots.zoomBy(2,this.now),0:()=>this.plots.reset(),9:()=>this.lively(),"[":()=>this.stepScene(-1),"]":()=>this.stepScene(1),f:()=>this.element.querySelector(".widen").click(),...t?{}:{" ":()=>this.toggle()},...n?{}:{ArrowLeft:()=>{this.pause(),this.goTo(this.now-r*(e.shiftKey?20:1))},ArrowRight:()=>{this.pause(),this.goTo(this.now+r*(e.shiftKey?20:1))}}};e.key==="Escape"&&this.element.classList.contains("wide")&&(a.Escape=a.f);let o=a[e.key];o&&(e.preventDefault(),o())}};function He(i,e,t=""){return p("label",{class:"field"},p("span",{},i),e,...t?[p("small",{},t)]:[])}function Ut(i){return p("p",{class:"problem",role:"alert"},i instanceof Error?i.message:String(i))}function Pr(i,e){let t=p("button",{type:"button"},re("Copy"));return t.addEventListener("click",()=>{navigator.clipboard.writeText(e).then(()=>{t.textContent=re("Copied")},()=>{t.textContent=re("Select and copy")})}),p("section",{class:"code"},p("div",{class:"bar"},p("h3",{},i),t),p("pre",{tabindex:"0","aria-label":i},e))}function uf({python:i,command:e,files:t}){return[Pr(re("The same in Python"),i),Pr(re("The same on the command line"),e),...Object.entries(t).map(([n,s])=>Pr(n,s))]}var Lr=class{busy=!1;next=null;async ask(e){if(this.next=e,!this.busy){for(this.busy=!0;this.next;){let t=this.next;this.next=null,await t()}this.busy=!1}}},Oa=class{constructor(e,t,n,s={}){this.moved=n;let r=this.known;for(let l of e.numbers)r.set(l.path,l);let a=p("select",{"aria-label":re("another number")},p("option",{value:""},re("another number …")));for(let{path:l}of e.numbers)a.append(p("option",{value:l},l));a.addEventListener("change",()=>{let l=r.get(a.value);l&&this.add(l),a.value=""});for(let l of t){let c=r.get(l);c&&this.add(c)}for(let[l,c]of Object.entries(s)){let h=r.get(l);h&&Number.isFinite(c)&&(this.add(h),this.set(l,c))}let o=p("button",{type:"button"},re("All as they were"));o.addEventListener("click",()=>{for(let l of Object.keys(this.changes))delete this.changes[l];this.rows.querySelectorAll("input").forEach(l=>{l.value=l.defaultValue}),this.moved()}),this.element.append(this.rows,p("div",{class:"bar"},a,o))}moved;element=p("div",{class:"sliders"});changes={};rows=p("div",{});known=new Map;set(e,t){let n=this.known.get(e);if(!n)return;let s=Number((t*n.factor).toPrecision(7)),r=this.rows.querySelector(`[data-path="${CSS.escape(e)}"]`);Math.abs(t-n.value)<=1e-12*Math.max(Math.abs(t),1)?delete this.changes[e]:this.changes[e]=t,r?.querySelectorAll("input").forEach(a=>{a.value=String(s)})}add(e){if(this.rows.querySelector(`[data-path="${CSS.escape(e.path)}"]`))return;let t=e.value*e.factor,n=.5*Math.abs(t)||1,s=String(Number(t.toPrecision(6))),r=`${e.path} [${e.unit||"–"}]`,a=p("input",{type:"range",min:String(t-n),max:String(t+n),step:String(n/100),value:s,"aria-label":r}),o=p("input",{type:"number",step:"any",value:s,"aria-label":`${r}, ${re("typed")}`}),l=c=>{let h=Number(c);c===""||!Number.isFinite(h)||(c===s?delete this.changes[e.path]:this.changes[e.path]=h/e.factor,this.moved())};a.addEventListener("input",()=>{o.value=String(Number(Number(a.value).toPrecision(5))),l(o.value)}),o.addEventListener("input",()=>{a.value=o.value,l(o.value)}),this.rows.append(p("div",{class:"slider","data-path":e.path},p("span",{class:"name"},e.path),a,o,p("span",{class:"unit"},e.unit||"–")))}},Fh=class{constructor(e){this.question=e;this.element.append(this.state,this.place,this.ways)}question;element=p("div",{class:"live"});state=p("p",{class:"state",role:"status"});place=p("div",{});ways=p("div",{class:"ways"});player=null;busy=!1;again=!1;times=[];async ask(){if(this.again=this.busy,this.busy)return;this.busy=!0;let e=performance.now(),t=setTimeout(()=>{this.state.textContent=re("computing; the first time a model is compiled once, which takes some seconds")},500);try{let n=Ji.of(await this.question()),s=n.content.viewers[0];this.player?this.player.replace(s,n):(this.player=new Ua(s,n),this.place.replaceChildren(this.player.element)),this.ways.replaceChildren(...uf(n.content)),this.times.push(performance.now()-e),this.state.textContent=`${re("computed and drawn in")} ${De(this.times[this.times.length-1],2)} ms`,this.state.classList.remove("problem")}catch(n){this.state.textContent=n instanceof Error?n.message:String(n),this.state.classList.add("problem")}finally{clearTimeout(t),this.busy=!1,this.again&&this.ask()}}};var el=async(i,e,t)=>(await Kn(i,e,t)).json(),nl=i=>el("POST","/api/jobs",i),ff=i=>el("POST","/api/ask",i),il=i=>Un(`/api/jobs/${encodeURIComponent(i)}`),kh=new Map,Bh=null,Qo=null;function T0(){Qo=new WebSocket(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/api/live`),Qo.addEventListener("message",i=>{Bh=JSON.parse(i.data),RE()}),Qo.addEventListener("close",()=>{Qo=null,setTimeout(()=>{kh.size&&T0()},1e3)})}function RE(){for(let[i,e]of kh)e.node.isConnected&&(e.shown=!0),e.node.isConnected||!e.shown?i(Bh):kh.delete(i)}function pf(i,e){kh.set(e,{node:i,shown:!1}),Bh&&e(Bh),Qo||T0()}var PE={running:"running",cancelling:"stopping",done:"done",failed:"failed",cancelled:"cancelled",stopped:"stopped"},LE={running:"plain",cancelling:"fair",done:"good",failed:"bad",cancelled:"fair",stopped:"bad"};function df(i){let e=Math.max(0,Math.round(i));return e<60?`${e} s`:e<3600?`${Math.floor(e/60)} min ${e%60} s`:`${Math.floor(e/3600)} h ${Math.floor(e%3600/60)} min`}var tl=class{constructor(e,t){this.job=e;this.open=t;this.bar.setAttribute("aria-label",`share of ${e.title} that is done`),this.element.append(p("div",{class:"bar"},p("h3",{},e.title),this.state,this.times),this.bar,this.said,this.told,this.actions),this.show(e)}job;open;element=p("article",{class:"job"});state=p("span",{class:"mark"});times=p("span",{class:"muted"});said=p("p",{class:"state",role:"status"});bar=p("progress",{max:"1"});actions=p("div",{class:"bar"});told=p("div",{});shown="";timer=0;show(e){this.job=e;let t=e.state==="running"||e.state==="cancelling";if(this.state.textContent=PE[e.state],this.state.className=`mark ${LE[e.state]}`,this.bar.hidden=!t,e.share===null?this.bar.removeAttribute("value"):this.bar.value=e.share,this.said.hidden=!t,this.said.textContent=e.state==="cancelling"?"stopping; what is finished is kept":e.said||"starting",this.tick(),clearInterval(this.timer),t&&(this.timer=window.setInterval(()=>{this.element.isConnected?this.tick():clearInterval(this.timer)},1e3)),this.shown===e.state)return;this.shown=e.state,this.told.replaceChildren(...e.error?[Ut(e.error)]:[]);let n=(r,a,o=!1)=>{let l=p("button",{type:"button",...o?{class:"main"}:{},"aria-label":`${r}: ${e.title}`},r);return l.addEventListener("click",()=>{l.disabled=!0,a().catch(c=>{this.told.replaceChildren(Ut(c)),l.disabled=!1})}),l},s=`/api/jobs/${encodeURIComponent(e.id)}`;this.actions.replaceChildren(...e.state==="running"?[n("Cancel",()=>el("POST",`${s}/cancel`,{}))]:[],...this.open&&(e.state==="done"||e.kind==="sweep")?[n("Show the results",async()=>this.open(this.job),!0)]:[],...!t&&e.state!=="done"?[n(e.kind==="sweep"?"Resume":"Begin again",()=>el("POST",`${s}/again`,{}),!0)]:[],...t?[]:[n("Take off the list",()=>el("DELETE",s))]),this.actions.append(p("details",{},p("summary",{},"In Python, and on the command line"),nr(e)))}tick(){let{begun:e,ended:t,share:n,left:s,state:r}=this.job,a=(t??Date.now()/1e3)-e,o=[t?`took ${df(a)}`:`for ${df(a)}`];r==="running"&&n!==null&&o.push(`${De(100*n,3)} %`),r==="running"&&s!==null&&s>=1&&o.push(`about ${df(s)} left`),this.times.textContent=o.join(" · ")}};function ka(i,e,t){let n=p("div",{class:"jobs"},p("p",{class:"muted"},"asking …")),s=new Map;return pf(n,r=>{let a=r.filter(l=>!i||i.includes(l.kind));for(let l of a){let c=s.get(l.id);c?c.show(l):s.set(l.id,new tl(l,e))}for(let l of[...s.keys()])a.some(c=>c.id===l)||s.delete(l);let o=a.map(l=>s.get(l.id).element);o.length?(o.some((l,c)=>n.children[c]!==l)||n.children.length!==o.length)&&n.replaceChildren(...o):n.replaceChildren(p("p",{class:"empty"},t))}),n}function nr(i){return p("div",{class:"ways"},...i.python?[Pr("The same in Python",i.python)]:[],...i.command?[Pr("The same on the command line",i.command)]:[],...Object.entries(i.files??{}).map(([e,t])=>Pr(e,t)))}function sl(i,e){return p("section",{class:"whole"},p("div",{class:"bar"},p("h2",{},e),p("a",{href:i,target:"_blank",rel:"noopener"},"open it in a tab of its own")),p("iframe",{src:i,title:e,sandbox:"allow-scripts",class:"report"}))}function A0(i,e,t){let n=p("input",{type:"file",multiple:!0,"aria-label":e}),s=p("div",{"aria-live":"polite"}),r=p("div",{class:"drop"},p("p",{},e),n,s),a=async o=>{let l=[],c=[];for(let h of o??[]){let d=[i().replace(/\/+$/,""),h.name].filter(Boolean).join("/");s.replaceChildren(p("p",{class:"state"},`${h.name}: ${De(h.size/1e6,3)} MB on the way …`));try{await IE(d,h),l.push(d)}catch(u){c.push(Ut(u))}}s.replaceChildren(...c,...l.length?[p("p",{class:"good"},`${l.join(", ")}: here now.`)]:[]),n.value="",l.length&&t(l)};return n.addEventListener("change",()=>{a(n.files)}),r.addEventListener("dragover",o=>{o.preventDefault(),r.classList.add("over")}),r.addEventListener("dragleave",()=>r.classList.remove("over")),r.addEventListener("drop",o=>{o.preventDefault(),r.classList.remove("over"),a(o.dataTransfer?.files??null)}),r}var E0=25e7;async function IE(i,e){if(e.size>E0)throw new Error(`${e.name}: ${De(e.size/1e6,3)} MB; at most ${E0/1e6} MB are taken here. Copy it into the folder instead.`);let t=await fetch(`/api/upload?${new URLSearchParams({path:i})}`,{method:"PUT",body:e});if(t.ok)return;let n=await t.json().catch(()=>null);throw new Error(n?.error?.text??`${e.name}: ${t.statusText}`)}var Fa=class{constructor(e,t,n){this.task=t;this.show=n;this.button=p("button",{type:"button",class:"main"},e),this.button.addEventListener("click",()=>{this.ask()})}task;show;button;place=p("div",{"aria-live":"polite"});async ask(){this.button.disabled=!0;let e=p("p",{class:"state"},"working …");this.place.prepend(e);try{this.place.replaceChildren(...this.show(await ff(this.task())))}catch(t){this.place.replaceChildren(Ut(t))}finally{e.remove(),this.button.disabled=!1}}};var DE=["time","sprung.z","sprung.az","unsprung.z","unsprung.az","strut.deflection","strut.force","tyre.force","road.z"];function NE(i){let e=(_,g,x="")=>{let T=document.createElementNS("http://www.w3.org/2000/svg",_);for(let[S,R]of Object.entries(g))T.setAttribute(S,String(R));return T.textContent=x,T},[t,n,s,r]=[520,300,62,34],a=_=>{let g=Math.min(0,..._.slice(0,1)),x=g;for(let T of _)g=Math.min(g,T),x=Math.max(x,T);return x>g?[g,x]:[g-1,x+1]},[o,l]=a(i.x),[c,h]=a(i.y),d=_=>s+(t-s-12)*(_-o)/(l-o),u=_=>n-r-(n-r-10)*(_-c)/(h-c),f=e("svg",{viewBox:`0 0 ${t} ${n}`,class:"xy",role:"img","aria-label":`force from ${De(c,3)} to ${De(h,3)} N over deflections from ${De(o,3)} to ${De(l,3)} mm`});f.append(e("path",{class:"axis",d:`M${s} 6V${n-r}H${t-8}`}),e("path",{class:"zero",d:`M${d(0)} 6V${n-r}M${s} ${u(0)}H${t-8}`}));for(let _ of[o,l])f.append(e("text",{x:d(_),y:n-r+15,"text-anchor":_===o?"start":"end"},De(_,3)));for(let _ of[c,h])f.append(e("text",{x:s-5,y:u(_)+5,"text-anchor":"end"},De(_,3)));f.append(e("text",{x:(s+t)/2,y:n-6,"text-anchor":"middle"},"deflection, compression positive [mm]"),e("text",{x:13,y:n/2,transform:`rotate(-90 13 ${n/2})`,"text-anchor":"middle"},"force, compression positive [N]"));let m="";i.x.forEach((_,g)=>{m+=`M${d(_).toFixed(1)} ${u(i.y[g]).toFixed(1)}h.01`}),f.append(e("path",{class:"dots",d:m}));let v=p("figure",{});return v.append(f,p("figcaption",{class:"muted"},`${i.count} samples as they would be read`)),v}var rl=class{constructor(e,t,n={}){this.file=e;this.form=t;Object.assign(this.fields,n,{columns:{...n.columns}});let s=(a,o)=>{let l=p("select",{},p("option",{value:""},"not stated"),...o.map(c=>p("option",c===this.fields[a]?{value:c,selected:!0}:{value:c},`positive in ${c}`)));return l.addEventListener("change",()=>{this.fields[a]=l.value,this.ask()}),l},r=(a,o)=>{let l=p("input",{type:"text",value:this.fields[a],placeholder:o});return l.addEventListener("change",()=>{this.fields[a]=l.value.trim(),this.ask()}),l};this.question=new Fa("Preview",()=>({kind:"preview",files:[this.file],form:this.form,...this.asked()}),a=>this.shown(a.result,a)),this.names.append(...DE.map(a=>p("option",{value:a}))),this.element.append(p("div",{class:"form"},He("Stroke",s("stroke_positive",["compression","extension"])),He("Force",s("force_positive",["compression","tension"])),...t==="recording"?[He("Sample time, where the file has none",r("sample_time","1 ms"))]:[],He("Variable or group (.mat, .tdms)",r("variable","")),this.question.button),p("details",{open:!0},p("summary",{},"Columns"),this.names,p("div",{class:"table",tabindex:"0",role:"region","aria-label":"columns"},p("table",{},p("thead",{},p("tr",{},...["column of the file","unit","from","to","read as","unit, where the file has none"].map(a=>p("th",{scope:"col"},a)))),this.mapping))),this.question.place)}file;form;element=p("div",{class:"reading"});fields={columns:{},variable:"",sample_time:"",stroke_positive:"",force_positive:""};mapping=p("tbody",{});names=p("datalist",{id:"channels-to-read"});question;known=[];asked(){let{columns:e,variable:t,sample_time:n,stroke_positive:s,force_positive:r}=this.fields;return{columns:e,variable:t,stroke_positive:s,force_positive:r,...this.form==="recording"?{sample_time:n}:{}}}ask(){return this.question.ask()}shown(e,t){JSON.stringify(e.columns)!==JSON.stringify(this.known)&&(this.known=e.columns,this.offer());let n=[];if(e.problem&&n.push(p("p",{class:"problem",role:"alert"},e.problem)),n.push(...e.findings.map(s=>p("p",{class:s.severity==="problem"?"problem":"muted"},`${s.severity}: ${s.message}`))),e.more&&n.push(p("p",{class:"muted"},`and ${e.more} more columns`)),e.points&&n.push(NE(e.points)),e.content){let s=p("div",{});n.push(s),Ji.open(JSON.stringify(e.content)).then(r=>{let a=r.content.viewers[0];a&&s.replaceChildren(new Ua(a,r).element)})}return[...n,nr(t)]}offer(){let e=Object.fromEntries(Object.entries(this.fields.columns).map(([t,n])=>[n.replace(/ \[[^\]]*\]$/,""),{name:t,unit:/\[([^\]]*)\]$/.exec(n)?.[1]??""}]));this.mapping.replaceChildren(...this.known.map(t=>{let n=e[t.name],s=this.form==="recording"?p("input",{type:"text",list:"channels-to-read",value:n?.name??"",placeholder:"as it is","aria-label":`what ${t.name} is read as`,size:"16"}):p("select",{"aria-label":`what ${t.name} is read as`},...["","displacement","force"].map(o=>p("option",o===(n?.name??"")?{value:o,selected:!0}:{value:o},o||"as it is"))),r=p("input",{type:"text",value:n?.unit??"",placeholder:t.unit||"e.g. mm","aria-label":`unit of ${t.name}`,size:"8"}),a=()=>{for(let[o,l]of Object.entries(this.fields.columns))l.replace(/ \[[^\]]*\]$/,"")===t.name&&delete this.fields.columns[o];s.value&&(this.fields.columns[s.value]=r.value.trim()?`${t.name} [${r.value.trim()}]`:t.name),this.ask()};return s.addEventListener("change",a),r.addEventListener("change",a),p("tr",{},p("th",{scope:"row"},t.name),p("td",{},t.unit||"–"),p("td",{class:"right"},De(t.least)),p("td",{class:"right"},De(t.greatest)),p("td",{},s),p("td",{},r))}))}};var Ir=["rig"],It=(i,e={})=>`#/${i}?${new URLSearchParams(e)}`,mf=null;function Ba(i){mf=i}async function za(i,e,t,n,s=!1){let{entries:r}=await xi(),a=[...r.filter(o=>Ir.includes(o.kind)).map(o=>o.path),...s?(await Os()).map(o=>o.name):[]];i.replaceChildren(p("h1",{},t),a.length?p("ul",{},...a.map(o=>p("li",{},p("a",{href:It(e,{[n]:o})},o)))):p("p",{class:"empty"},"No rig lies here yet: ",p("a",{href:It("project")},"start from an example"),"."))}var R0={label:"Campaign",show:UE};async function UE(i,e){let t=e.get("job"),n=e.get("file");if(t){await GE(i,t);return}if(n){await OE(i,n,e.get("read")??"");return}let{entries:s}=await xi(),r=s.filter(h=>h.kind==="campaign"),a=p("input",{type:"text",value:"campaign",spellcheck:"false"}),o=p("div",{"aria-live":"polite"}),l=p("button",{type:"submit",class:"main"},"Start from it"),c=p("form",{class:"form"},He("Folder",a),l);c.addEventListener("submit",h=>{h.preventDefault(),l.disabled=!0,ff({kind:"new-campaign",out:a.value}).then(()=>{location.hash=It("campaign",{file:`${a.value}/campaign.toml`})},d=>{o.replaceChildren(Ut(d)),l.disabled=!1})}),i.replaceChildren(p("h1",{},"Campaigns"),p("p",{class:"muted"},"From measurements of springs, tyres, decays and trials to a model that holds: characterised, updated, compared with every trial."),r.length?p("ul",{class:"files"},...r.map(h=>p("li",{},p("a",{href:It("campaign",{file:h.path})},h.path)))):p("p",{class:"empty"},"No campaign lies here yet. Start from the one below, and put your own measurements in."),p("h2",{},"Runs"),ka(["campaign"],h=>{location.hash=It("campaign",{job:h.id})},"No campaign was run here yet."),p("h2",{},"A campaign to start from"),p("p",{class:"muted"},"It runs as it is, with synthetic recordings."),c,o)}async function OE(i,e,t){let n=await Un(`/api/campaign?${Yi({path:e})}`),s=e.includes("/")?e.slice(0,e.lastIndexOf("/")):"",r=v=>s?`${s}/${v}`:v,a=p("input",{type:"text",value:r("results"),spellcheck:"false"}),o=p("input",{type:"checkbox"}),l=p("div",{"aria-live":"polite"}),c=p("button",{type:"button",class:"main"},"Run the campaign");c.addEventListener("click",()=>{nl({kind:"campaign",campaign:e,out:a.value,force:o.checked}).then(v=>{location.hash=It("campaign",{job:v.id})},v=>l.replaceChildren(Ut(v)))});let h=p("button",{type:"button"},"Check it");h.addEventListener("click",()=>{Wf(e).then(({problems:v,notes:_})=>l.replaceChildren(...v.length?v.map(Ut):[p("p",{class:"good"},"Nothing is wrong with it.")],..._.map(g=>p("p",{class:"muted"},g))),v=>l.replaceChildren(Ut(v)))});let d=p("div",{}),u=(v,_,g={})=>{d.replaceChildren(BE(e,v,_,g,n)),d.scrollIntoView({block:"start"})},f=(v,_,g={})=>{let x=p("button",{type:"button","aria-label":`look at ${v}`},v.split("/").pop());return x.addEventListener("click",()=>u(v,_,g)),x},m=p("input",{type:"text",value:r("measured"),spellcheck:"false"});i.replaceChildren(p("h1",{},n.title),p("p",{class:"muted"},p("a",{href:It("campaign")},"All campaigns"),` · ${e} · rig ${n.rig}`),...n.synthetic?[p("p",{class:"mark fair"},n.synthetic)]:[],p("div",{class:"form"},He("Folder of the results",a),p("label",{class:"field"},p("span",{},"Replace what is there"),o),h,c),l,p("h2",{},"Parts"),...n.bench.length?n.bench.map(v=>FE(v,n,f)):[p("p",{class:"empty"},"Nothing was measured of the parts: the rig is taken as its file says.")],p("h2",{},"Trials"),ir("trials",["number","use","road","speed","tyre pressure","recording"],n.trials.map(v=>[String(v.number),String(v.use??"hold-out"),String(v.road??"measured support"),String(v.speed??"–"),String(v.tyre_pressure??"–"),v.file?f(String(v.file),"recording",v):p("span",{class:"mark bad"},`${String(v.recording)} is missing`)])),p("h2",{},"Updates"),n.updates.length?ir("updates",["name","free","trials","method"],n.updates.map(v=>[String(v.name),Object.entries(v.free).map(([_,g])=>`${_}: ${typeof g=="string"?g:JSON.stringify(g)}`).join(", "),JSON.stringify(v.trials??"fit").replaceAll('"',""),String(v.method??"least-squares")])):p("p",{class:"empty"},"Nothing is updated: the campaign compares the characterised model with the trials."),p("h2",{},"Measurements"),p("div",{class:"form"},He("Folder they go to",m)),A0(()=>m.value,"Drop measured files here, or choose them (up to 250 MB each).",v=>u(v[0],"recording")),d),t&&u(t,"recording")}function ir(i,e,t,n=[]){let s=r=>n.includes(r)?{class:"right"}:{};return p("div",{class:"table",tabindex:"0",role:"region","aria-label":i},p("table",{},p("thead",{},p("tr",{},...e.map((r,a)=>p("th",{scope:"col",...s(a)},r)))),p("tbody",{},...t.map(r=>p("tr",{},...r.map((a,o)=>o?p("td",s(o),a):p("th",{scope:"row"},a)))))))}function FE(i,e,t){let n=i.name==="decay",s=n?"recording":"force-deflection",r=m=>p("input",{type:"text",value:m}),a=r(i.discard_below??""),o=p("select",{},...["linear","polynomial","power","monotone-spline"].map(m=>p("option",m===i.law?{value:m,selected:!0}:{value:m},m))),l=p("select",{},...["drop","shift","keep"].map(m=>p("option",m===i.intercept?{value:m,selected:!0}:{value:m},m))),c=r(e.mass),h=r(i.from??""),d=r(i.to??""),u={files:i.found,columns:i.columns??{},variable:i.variable??"",stroke_positive:i.stroke_positive??""},f=new Fa(n?"Separate damping and friction":"Fit the stiffness",()=>n?{kind:"decay",...u,channel:i.channel??"sprung.z",mass:c.value,begin:h.value,end:d.value,sample_time:i.sample_time??""}:{kind:"stiffness",...u,force_positive:i.force_positive??"",law:o.value,discard_below:a.value,intercept:l.value,branch:i.branch??"loading"},m=>[kE(m.result),sl(m.report,n?"Decay and its bend by friction":"Fit, with the discarded zone"),nr(m)]);return p("section",{class:"job"},p("h3",{},i.name),i.found.length?p("p",{class:"bar"},"measured: ",...i.found.map(m=>t(m,s,i))):p("p",{class:"problem"},`no file is found for ${i.files.join(", ")}`),p("div",{class:"form"},...n?[He("Oscillating mass",c),He("From",h),He("To",d)]:[He("Law",o),He("Ignore smaller deflections",a),He("Force at zero",l)],f.button),f.place)}var C0={stiffness:"N/m",intercept:"N",damping_ratio:"1",damping_coefficient:"N·s/m",coulomb_force:"N",quadratic_drag:"N·s²/m²",natural_frequency_hz:"Hz",equilibrium:"m"};function kE(i){let e=Object.entries(i).flatMap(([n,s])=>{let r=s;return r&&typeof r=="object"&&typeof r.value=="number"&&n in C0?[[n.replaceAll("_"," ").replace(" hz",""),De(r.value),r.interval?`${De(r.interval[0])} … ${De(r.interval[1])}`:"–",C0[n]]]:[]}),t=i.findings??[];return p("div",{},ir("estimates",["quantity","value","95 % interval","unit"],e,[1,2]),...t.map(n=>p("p",{class:"muted"},`${n.severity}: ${n.message}`)))}function BE(i,e,t,n,s){let r=p("div",{}),a=p("div",{"aria-live":"polite"}),o=new rl(e,t,n),c=p("select",{},...[["trial","a trial"],["decay","a free decay"],["spring","the spring"],["tyre","a tyre at a pressure"]].map(([w,y])=>p("option",t==="force-deflection"==(w==="spring")&&(w==="trial"||w==="spring")?{value:w,selected:!0}:{value:w},y))),h=(w,y="")=>p("input",{type:"text",value:w,placeholder:y}),d=h("2 m/s"),u=h("","0.31 MPa"),f=p("select",{},...s.roads.map(w=>p("option",{value:w},w)),p("option",{value:""},"none: the support is measured")),m=h("","its file, with road.z"),v=p("select",{},p("option",{value:"undeformed"},"undeformed springs and tyre"),p("option",{value:"rest"},"the wheel at rest on it")),_=p("select",{},p("option",{value:"hold-out"},"judges only (hold-out)"),p("option",{value:"fit"},"is fitted")),g=p("input",{type:"checkbox"}),x=h("","2 mm"),T=p("span",{class:"sizes"}),S=()=>{let w=c.value==="spring"||c.value==="tyre"?"force-deflection":"recording";w!==o.form&&(o=new rl(e,w,o.fields),r.replaceChildren(o.element),o.ask()),T.replaceChildren(...c.value==="trial"?[He("Road",f),...f.value?[He("Speed",d)]:[He("File of the support",m),He("Its height counts from",v)],He("Tyre pressure",u),He("Use",_)]:c.value==="decay"?[He("In place of the files there",g)]:[He("In place of the files there",g),...c.value==="tyre"?[He("Pressure",u)]:[],He("Ignore smaller deflections",x)])};c.addEventListener("change",S),f.addEventListener("change",S);let R=p("button",{type:"button",class:"main"},"Enter it into the campaign");return R.addEventListener("click",()=>{let{columns:w,variable:y,sample_time:C,stroke_positive:z,force_positive:U}=o.fields,D={columns:w,variable:y,stroke_positive:z,...c.value==="decay"?{}:{force_positive:U},...o.form==="recording"?{sample_time:C}:{}},L=c.value==="trial"?{recording:e,...f.value?{road:f.value,speed:d.value}:{excitation:{file:m.value,datum:v.value}},tyre_pressure:u.value,use:_.value,...D}:{files:[e],replace:g.checked,...c.value==="tyre"?{pressure:u.value}:{},...c.value==="decay"?{}:{discard_below:x.value},...D};R.disabled=!0,Kn("POST","/api/campaign",{campaign:i,use:c.value,fields:L}).then(()=>{location.hash=It("campaign",{file:i,entered:String(Date.now())})},F=>{a.replaceChildren(Ut(F)),R.disabled=!1})}),r.append(o.element),S(),o.ask(),p("section",{class:"job"},p("h3",{},e),r,p("div",{class:"form"},He("It is a measurement of",c),T,R),a)}var zE={holds:"good","holds partly":"fair"},VE=i=>zE[i]??(/not|fail/.test(i)?"bad":"fair");async function GE(i,e){let t=await il(e),n=await XE(String(t.asked.campaign)),s=p("div",{}),r=p("div",{}),a=new tl(t),o=!1;i.replaceChildren(p("h1",{},t.title),p("p",{class:"muted"},p("a",{href:It("campaign")},"All campaigns")," · ",p("a",{href:It("campaign",{file:String(t.asked.campaign)})},String(t.asked.campaign))),a.element,r,s);let l=async c=>{if(a.show(c),c.steps?.length&&r.replaceChildren(HE(c.steps,c.state==="running",n)),c.state!=="done"||o)return;o=!0;let h=await il(e);h.result&&s.replaceChildren(...WE(h.result,n),...h.has_page?[sl(`/api/jobs/${e}/report`,"Report")]:[])};await l(t),pf(i,c=>{let h=c.find(d=>d.id===e);h&&l(h)})}function HE(i,e,t){let n=i[i.length-1],s=i.map(f=>Math.log10(Math.max(f.objective,1e-300))),r=Math.min(...s),a=Math.max(...s,r+1e-9),o=460,l=150,c=document.createElementNS("http://www.w3.org/2000/svg","svg"),h=document.createElementNS("http://www.w3.org/2000/svg","path");c.setAttribute("viewBox",`0 0 ${o} ${l}`),c.setAttribute("class","xy"),c.setAttribute("role","img"),c.setAttribute("aria-label",`objective from ${De(i[0].objective,4)} to ${De(n.objective,4)} in ${i.length} evaluations`),h.setAttribute("d",s.map((f,m)=>`${m?"L":"M"}${(8+(o-16)*m/Math.max(1,s.length-1)).toFixed(1)} ${(8+(l-16)*(a-f)/(a-r)).toFixed(1)}`).join("")),h.setAttribute("class","search"),c.append(h);let d=p("figure",{});d.append(c,p("figcaption",{class:"muted"},`objective, logarithmic: ${De(i[0].objective,4)} at first, ${De(n.objective,4)} after ${n.evaluation} evaluations`));let u=Object.entries(n.parameters).map(([f,m])=>{let v=(m.value-m.lower)/(m.upper-m.lower||1),{unit:_,factor:g}=t(f);return p("tr",{},p("th",{scope:"row"},f),p("td",{},_),p("td",{class:"right"},De(m.lower*g)),p("td",{},p("meter",{min:"0",max:"1",value:String(Math.min(1,Math.max(0,v))),"aria-label":`${f} between its bounds`})),p("td",{class:"right"},De(m.upper*g)),p("td",{class:"right"},De(m.initial*g)),p("td",{class:"right"},De(m.value*g,5)),p("td",{},v<.001||v>.999?p("span",{class:"mark fair"},"at its bound"):""))});return p("section",{class:"job"},p("h3",{},e?"The search goes on":"The last search"),d,p("div",{class:"table",tabindex:"0",role:"region","aria-label":"parameters"},p("table",{},p("thead",{},p("tr",{},...["parameter","unit","lower bound","","upper bound","at first","now",""].map((f,m)=>p("th",{scope:"col",...[2,4,5,6].includes(m)?{class:"right"}:{}},f)))),p("tbody",{},...u))))}function WE(i,e){let t=r=>{let a=Object.values(r?.channels??{}).map(o=>o.nrmse).filter(o=>o!==null);return a.length?a.reduce((o,l)=>o+l)/a.length:null},n=[];i.synthetic&&n.push(p("p",{class:"mark fair"},i.synthetic)),n.push(p("h2",{},"Verdicts"),ir("verdicts",["trial","use","speed [m/s]","error of the channels (NRMSE)","verdict"],i.trials.map(r=>[String(r.number),r.use,De(r.speed),Object.entries(r.channels).map(([a,o])=>`${a} ${De(o.nrmse,3)}`).join(", "),p("span",{class:`mark ${VE(r.verdict)}`},r.verdict)]))),i.characterisation.replaced.length&&n.push(p("h2",{},"Characterised"),ir("characterised",["number","unit","in the rig's file","measured","95 % ±","from"],i.characterisation.replaced.map(r=>{let{unit:a,factor:o}=e(r.path);return[r.path,a,De(r.described*o),De(r.measured*o),r.standard_error===null?"–":De(1.96*r.standard_error*o,2),r.source]}),[2,3,4]));for(let r of i.updates)n.push(p("h2",{},`Update: ${r.name}`),p("p",{},`The objective fell by ${De(r.reduction_percent,3)} %, from ${De(r.objective_before)} to ${De(r.objective_after)}, in ${r.evaluations} evaluations on trial ${r.trials.join(", ")}.`),ir("parameters",["parameter","unit","at first","value","95 % interval, noise only","bounds","known"],Object.entries(r.parameters).map(([a,o])=>{let l=r.discrepancy?.parameters[a],{unit:c,factor:h}=e(a);return[a,c,De(o.initial*h),De(o.value*h,5),o.interval?`${De(o.interval[0]*h)} … ${De(o.interval[1]*h)}`:"–",`${De(o.lower*h)} … ${De(o.upper*h)}`,o.at_bound?p("span",{class:"mark fair"},"at its bound"):l?.why?p("span",{class:"mark bad"},`not identified: ${l.why}`):l?p("span",{class:"mark good"},"identified"):"–"]}),[2,3,4,5]),p("h3",{},"What the data can tell"),p("p",{class:"muted"},`${r.identifiability.rank} of ${r.identifiability.parameters.length} directions are told apart; the condition is ${De(r.identifiability.condition,3)}.`),ir("identifiability",["unknown","sensitivity","most alike"],r.identifiability.parameters.map((a,o)=>{let l=r.identifiability.correlation[o]??[],c=l.reduce((h,d,u)=>u!==o&&Math.abs(d)>Math.abs(h<0?0:l[h])?u:h,-1);return[a,De(r.identifiability.sensitivity[o],3),c>=0?`${r.identifiability.parameters[c]} (${De(l[c],2)})`:"–"]}),[1]),...r.identifiability.findings.map(a=>p("p",{class:"muted"},`${a.place}: ${a.message}`)));let s=[...new Set(i.updates.flatMap(r=>r.comparisons.map(a=>a.number)))];return s.length&&n.push(p("h2",{},"Every update on every trial"),p("p",{class:"muted"},"Mean error of the channels (NRMSE) before and after each update; trials it was fitted on are marked."),ir("every update on every trial",["update",...s.map(r=>`trial ${r}`)],i.updates.map(r=>[r.name,...s.map(a=>{let o=r.comparisons.find(l=>l.number===a);return o?`${De(t(o.before),3)} → ${De(t(o.after),3)}${o.is_fitted?", fitted":""}${o.after?.verdict?`: ${o.after.verdict}`:""}`:"–"})]))),i.findings.length&&n.push(p("h2",{},"What to be careful about"),p("ul",{},...i.findings.map(r=>p("li",{class:r.severity==="problem"?"problem":""},`${r.place}: ${r.message}`)))),n}async function XE(i){let e=new Map;try{let{rig:t}=await Un(`/api/campaign?${Yi({path:i})}`),n=i.includes("/")?`${i.slice(0,i.lastIndexOf("/"))}/`:"";for(let s of(await Fs(t.endsWith(".toml")?n+t:t)).numbers)e.set(s.path,{unit:s.unit||"–",factor:s.factor})}catch{}return t=>e.get(t)??{unit:"SI",factor:1}}var P0={label:"Jobs",show:YE},$E={sweep:"studies",campaign:"campaign",compare:"ride",pareto:"ride",design:"kinematics",evaluate:"inspection"};function qE(i){let e=$E[i.kind];e&&e!=="kinematics"?location.hash=It(e,{job:i.id}):window.open(`/api/jobs/${encodeURIComponent(i.id)}/report`,"_blank","noopener")}async function YE(i){i.replaceChildren(p("h1",{},"Jobs"),p("p",{class:"muted"},"Long work goes on when this page is closed, and when the server is ended: it is found again here."),ka(null,qE,"No long work was begun here yet. Studies, campaigns, rides and designs begin it."))}var ZE=i=>Un(`/api/jobs/${encodeURIComponent(i)}`);function L0(i,e,t,n,s){let r=[...new Set(e.numbers.map(({path:m})=>/^(hardpoints\.\w+)\[/.exec(m)?.[1]).filter(m=>!!m&&!m.endsWith("wheel_centre")))],a=r.map(m=>p("input",{type:"checkbox",value:m,checked:/tie_rod|link_5/.test(m)})),o=p("input",{type:"text",value:"15 mm"}),l=p("input",{type:"number",min:"1",max:"100",value:"4"}),c=p("div",{"aria-live":"polite"}),h=p("button",{type:"submit",class:"main"},re("Search")),d=p("form",{},p("fieldset",{class:"free"},p("legend",{},re("Hardpoints that may move")),...a.map((m,v)=>p("label",{},m,` ${r[v].replace("hardpoints.","").replaceAll("_"," ")}`))),p("div",{class:"form"},He(re("Each coordinate by up to"),o),He(re("Searches"),l),h));d.addEventListener("submit",m=>{m.preventDefault();let v=a.filter(_=>_.checked).map(_=>_.value);if(!t.length||!v.length){c.replaceChildren(p("p",{class:"muted"},re("Add a target above, and choose a hardpoint that may move.")));return}h.disabled=!0,u(v).catch(_=>c.replaceChildren(Ut(_))).finally(()=>{h.disabled=!1})});async function u(m){let v=i.replace(/\.toml$/,"").replaceAll("/","-"),_=new Date().toISOString().replace(/\D/g,"").slice(2,14),g=`designs/${v}-${_}.toml`,x=D=>JSON.stringify(D),T=await $r(i),S=await Zi(i,T.text,[],n.changes),R=`designs/${v}-${_}-start.toml`;await or(R,S.text,"");let w=['schema = "jounce.design/1"',`rig = ${x(`${v}-${_}-start.toml`)}`,`starts = ${Number(l.value)||4}`,"",...m.flatMap(D=>["[[free]]",`point = ${x(D)}`,`within = ${x(o.value)}`,""]),...t.flatMap(D=>["[[target]]",...Object.entries(D).map(([L,F])=>`${L} = ${x(String(F))}`),""])].join(`
`);await or(g,w,"");let y=await(await Kn("POST","/api/jobs",{kind:"design",study:g,out:`designs/${v}-${_}`})).json(),C=p("progress",{max:"1","aria-label":re("share done")}),z=p("span",{}),U=p("button",{type:"button"},re("Cancel"));for(U.addEventListener("click",()=>{Kn("POST",`/api/jobs/${encodeURIComponent(y.id)}/cancel`,{})}),c.replaceChildren(p("p",{class:"bar"},C,z,U));;){let D=await ZE(y.id);if(!c.isConnected)return;if(D.share===null?C.removeAttribute("value"):C.value=D.share,z.textContent=[D.said,`${De(Date.now()/1e3-D.begun,2)} s`,D.left?re("# s left",De(D.left,2)):""].filter(Boolean).join(", "),D.state==="done"){f(D);return}if(!["running","cancelling"].includes(D.state)){c.replaceChildren(Ut(new Error(D.error??re("The search was ended."))));return}await new Promise(L=>setTimeout(L,400))}}function f(m){let v=m.result,_=p("button",{type:"button",class:"main"},re("Take this design"));_.addEventListener("click",()=>s(Object.fromEntries(Object.entries(v.moved).map(([x,T])=>[x,T.after]))));let g=new Map(e.numbers.map(x=>[x.path,x]));c.replaceChildren(p("p",{class:v.met?"good":"problem"},v.met?re("Every target is met."):re("# of the targets are missed.",String(v.targets.filter(x=>!x.met).length))),p("div",{class:"table",tabindex:"0",role:"region","aria-label":re("searches")},p("table",{},p("thead",{},p("tr",{},...[re("search"),re("targets"),re("cost, tolerances²"),re("moved, share of the boxes"),re("ended")].map(x=>p("th",{scope:"col"},x)))),p("tbody",{},...v.starts.map(x=>p("tr",{},p("th",{scope:"row"},String(x.start)),p("td",{},x.met?re("met"):re("missed")),p("td",{class:"right"},De(x.cost,3)),p("td",{class:"right"},De(x.travelled,2)),p("td",{},x.ended)))))),p("div",{class:"table",tabindex:"0",role:"region","aria-label":re("what was moved")},p("table",{},p("thead",{},p("tr",{},...[re("number"),re("before"),re("after"),re("unit")].map(x=>p("th",{scope:"col"},x)))),p("tbody",{},...Object.entries(v.moved).map(([x,T])=>{let S=g.get(x),R=S?.factor??1;return p("tr",{},p("th",{scope:"row"},x),p("td",{class:"right"},De(T.before*R,5)),p("td",{class:"right"},De(T.after*R,5)),p("td",{},S?.unit??""))})))),p("p",{class:"bar"},_,p("a",{href:`/api/jobs/${m.id}/report`,target:"_blank"},re("Its report"))))}return p("div",{},d,c)}var Rs=46,al=8,I0=6,JE=16,zh=104,Vh=class{constructor(e){this.moved=e;new ResizeObserver(()=>this.sized()).observe(this.element),Ri(()=>{this.colours={},this.draw()})}moved;element=p("div",{class:"multiples"});plots=[];x=[];kind="";wanted="";width=0;place=0;colours={};show(e,t,n){let s=e.scenes[0],r=s.panes.filter(o=>!o.name.startsWith("Δ"));this.x=t.get(s.x);let a=JSON.stringify([r.map(o=>[o.name,o.unit])]);a!==this.kind&&(this.kind=a,this.plots=r.map(o=>this.made(o.name,o.words,o.unit)),this.element.replaceChildren(...this.plots.map(o=>o.box)),this.filter(this.wanted)),r.forEach((o,l)=>{let c=this.plots[l];c.lines=o.curves.map(({role:h,y:d})=>({role:h,y:t.get(d)})),c.band=n.find(h=>h.quantity===o.name)??null,c.box.classList.toggle("wanted",c.band!==null)}),this.width?this.draw():this.sized(),this.mark(this.place)}filter(e){this.wanted=e;let t=e.toLowerCase().split(/\s+/).filter(Boolean);for(let n of this.plots)n.box.hidden=!t.every(s=>n.box.dataset.words.includes(s));this.draw()}mark(e){this.place=e;let[t,n]=this.ends(),s=n>t?(e-t)/(n-t):0,r=Rs+Math.min(Math.max(s,0),1)*(this.width-Rs-al);for(let a of this.plots){if(a.box.hidden)continue;a.mark.style.transform=`translateX(${r}px)`;let o=a.lines[0];a.value.textContent=o?De(lr(this.x,o.y,e),4):"–"}}ends(){return this.x.length?[this.x[0],this.x[this.x.length-1]]:[0,1]}made(e,t,n){let s=p("canvas",{"aria-hidden":"true"}),r=p("output",{},"–"),a=p("i",{class:"at"}),o=p("span",{class:"verdict"}),l=p("div",{class:"holder"},s,a);l.addEventListener("pointermove",h=>{let[d,u]=this.ends(),f=l.getBoundingClientRect();this.moved(d+Math.min(Math.max((h.clientX-f.left-Rs)/(f.width-Rs-al),0),1)*(u-d))});let c=p("figure",{"data-words":`${e} ${t}`.toLowerCase().replaceAll("_"," ")},p("figcaption",{title:t},p("b",{},e.replaceAll("_"," "))," ",r,p("span",{class:"unit"},` ${n||"–"}`),o),l);return{name:e,lines:[],band:null,canvas:s,value:r,mark:a,box:c,verdict:o}}sized(){let e=this.plots.find(n=>!n.box.hidden),t=e?Math.floor(e.box.clientWidth):0;if(!(t<60)){this.width=t;for(let{canvas:n}of this.plots)n.width=t,n.height=zh;this.draw(),this.mark(this.place)}}ink(e){return this.colours[e]??=Tt(e)}draw(){if(this.width)for(let e of this.plots)e.box.hidden||this.drawn(e)}drawn(e){let t=e.canvas.getContext("2d",{willReadFrequently:!0}),{x:n,width:s}=this,[r,a]=this.ends(),o=1/0,l=-1/0,c=m=>{m!==null&&Number.isFinite(m)&&(m<o&&(o=m),m>l&&(l=m))};for(let{y:m}of e.lines)for(let v=0;v<m.length;v++)c(m[v]);e.band?.low.forEach(c),e.band?.high.forEach(c),l>=o||([o,l]=[-1,1]);let h=1e-6*Math.max(Math.abs(o),Math.abs(l))||1e-9,d=l-o>h?.08*(l-o):.1*Math.abs(l)||1;o-=d,l+=d;let u=m=>Rs+(m-r)/(a-r||1)*(s-Rs-al),f=m=>I0+(l-m)/(l-o)*(zh-I0-JE);t.clearRect(0,0,s,zh),t.font="11px system-ui, sans-serif",t.lineWidth=1,t.strokeStyle=this.ink("line"),t.fillStyle=this.ink("muted"),t.textAlign="right",t.textBaseline="middle";for(let m of D0(o,l,3)){let v=Math.round(f(m))+.5;t.beginPath(),t.moveTo(Rs,v),t.lineTo(s-al,v),t.stroke(),t.fillText(N0(m),Rs-5,v)}t.textBaseline="alphabetic",t.textAlign="center";for(let m of D0(r,a,3))t.fillText(N0(m),Math.min(Math.max(u(m),Rs+8),s-al-8),zh-4);e.band?this.band(t,e,u,f,o,l):e.verdict.textContent="";for(let m=e.lines.length-1;m>=0;m--){let{role:v,y:_}=e.lines[m];t.strokeStyle=this.ink(v),t.lineWidth=m?1.25:2,t.setLineDash(m?[5,3]:[]),t.beginPath();let g=!1;for(let x=0;x<n.length;x++){let T=_[x];if(T==null||!Number.isFinite(T)){g=!1;continue}g?t.lineTo(u(n[x]),f(T)):t.moveTo(u(n[x]),f(T)),g=!0}t.stroke()}t.setLineDash([])}band(e,t,n,s,r,a){let o=t.band,l=o.at.length>1?0:4;e.fillStyle=this.ink("span"),e.strokeStyle=this.ink("other-1"),e.beginPath();let c=[...o.at.map((u,f)=>[n(u),s(o.high[f]??a)]),...o.at.map((u,f)=>[n(u),s(o.low[f]??r)]).reverse()];l?e.rect(c[0][0]-l,c[0][1],2*l,c[1][1]-c[0][1]):(c.forEach(([u,f],m)=>{m?e.lineTo(u,f):e.moveTo(u,f)}),e.closePath()),e.fill(),e.stroke();let h=t.lines[0]?.y,d=!!h&&o.at.every((u,f)=>{let m=lr(this.x,h,u);return m>=(o.low[f]??-1/0)-1e-9&&m<=(o.high[f]??1/0)+1e-9});t.verdict.textContent=d?" ✓":" ✗",t.verdict.className=`verdict ${d?"good":"missed"}`,t.verdict.title=d?"within the tolerance":"outside of the tolerance"}};function D0(i,e,t){let n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(o=>o*s).find(o=>o>=n),a=[];for(let o=Math.ceil(i/r);o*r<=e+1e-9*r;o++)a.push(o*r);return a}function N0(i){let e=Number(i.toPrecision(4));return cs(Math.abs(e)>=1e5||e!==0&&Math.abs(e)<.001?e.toExponential(0):String(e))}var U0=.001,Va=class{constructor(e,t){this.view=e;this.moved=t;let n=p("select",{},...[["view",re("in the plane of the picture")],["x",re("along x")],["y",re("along y")],["z",re("along z")]].map(([s,r])=>p("option",{value:s},r)));n.addEventListener("change",()=>{e.way=n.value}),e.grabbed=(s,r,a)=>this.drag(s,r,a),this.choice.addEventListener("change",()=>this.choose(this.choice.value)),this.inputs.forEach(s=>{s.addEventListener("change",()=>{let r=this.inputs.map(a=>Number(a.value));this.inputs.some(a=>a.value==="")||!r.every(Number.isFinite)||this.put(this.choice.value,r,!0)})}),this.element.append(He(re("Hardpoint"),this.choice),...this.inputs.map((s,r)=>He(`${"xyz"[r]} [mm]`,s)),He(re("Dragged"),n),He(re("Snaps to"),this.snap))}view;moved;element=p("div",{class:"points form"});choice=p("select",{"aria-label":re("Hardpoint")});inputs=["x","y","z"].map(e=>p("input",{type:"number",step:"any","aria-label":`${e} [mm]`}));snap=p("select",{},...["0.1","0.5","1","5","10"].map(e=>p("option",{value:e,...e==="1"?{selected:!0}:{}},`${e} mm`)));places=new Map;from=null;set(e){let t=new Map;for(let{path:n,value:s}of e){let r=/^hardpoints\.(\w+)\[([012])\]$/.exec(n);if(!r)continue;let a=t.get(r[1])??[0,0,0];a[Number(r[2])]=s/U0,t.set(r[1],a)}[...t.keys()].join()!==[...this.places.keys()].join()&&this.choice.replaceChildren(...[...t.keys()].map(n=>p("option",{value:n},n.replaceAll("_"," ")))),this.places=t,this.write()}choose(e){this.choice.value=e,this.view.choose(e),this.write()}drag(e,t,n){let s=this.places.get(e);if(!s)return;(this.from===null||this.choice.value!==e)&&(this.from=[...s],this.choose(e));let r=Math.hypot(...t),a=Number(this.snap.value),l=this.from.map((c,h)=>Math.abs(t[h])>.02*r?Math.round((c+t[h])/a)*a:c);n&&(this.from=null),(r>0||n)&&this.put(e,l,n)}put(e,t,n){let s=this.places.get(e),r={};t.forEach((a,o)=>{(n||Math.abs(a-s[o])>1e-9)&&(r[`hardpoints.${e}[${o}]`]=Number((a*U0).toPrecision(12)))}),this.places.set(e,t),this.write(),Object.keys(r).length&&this.moved(r,n)}write(){let e=this.places.get(this.choice.value);this.inputs.forEach((t,n)=>{document.activeElement!==t&&(t.value=e?String(Number(e[n].toFixed(4))):"")})}};var O0={label:"Kinematics",show:KE},ol=class{constructor(e,t,n,s,r,a){this.name=e;this.words=t;this.unit=n;this.range.value=`${-s} ${n}:${s} ${n}:${r} ${n}`,this.slider.min=String(-s),this.slider.max=String(s),this.slider.value="0",this.slider.setAttribute("aria-label",`${t} [${n}]`),this.number.setAttribute("aria-label",`${t} [${n}], ${re("typed")}`),this.range.setAttribute("aria-label",`${t}: ${re("first:last:step")}`),this.slider.addEventListener("input",()=>{this.number.value=String(Number(Number(this.slider.value).toPrecision(4))),a(!1)}),this.number.addEventListener("input",()=>{this.number.value!==""&&(this.slider.value=this.number.value,a(!1))}),this.range.addEventListener("change",()=>{let[o,l]=this.range.value.split(":").map(c=>parseFloat(c));Number.isFinite(o)&&Number.isFinite(l)&&(this.slider.min=String(o),this.slider.max=String(l)),a(!0)}),this.element=p("div",{class:"slider drive"},p("span",{class:"name"},t),this.slider,this.number,p("span",{class:"unit"},n),this.range)}name;words;unit;slider=p("input",{type:"range",step:"any"});number=p("input",{type:"number",step:"any",value:"0"});range=p("input",{type:"text",spellcheck:"false"});element;get value(){return Number(this.number.value)||0}set value(e){this.slider.value=String(e),this.number.value=String(Number(e.toPrecision(4)))}swept(e,t){this.range.hidden=!e,this.slider.disabled=this.number.disabled=!t,this.element.classList.toggle("unused",!t)}};async function KE(i,e){let t=e.get("rig");if(!t){await za(i,"kinematics",re("Kinematics"),"rig",!0);return}let[n,{entries:s},r]=await Promise.all([Fs(t),xi(),Os()]);if(!n.spatial){i.replaceChildren(p("h1",{},t),p("p",{class:"empty"},re("This rig has no hardpoints, and so no kinematics: "),p("a",{href:It("kinematics")},re("choose another one")),"."));return}let a=t.endsWith(".toml"),o=n.numbers.some(ae=>ae.path==="wheel.radius"&&ae.value<.18),l=n.numbers.some(ae=>/^hardpoints\.(tie_rod|link_5)_inner\[0\]$/.test(ae.path)),c=o?20:50,h=new Lr,d=[];Ba({times:d});let u=p("p",{class:"state",role:"status"}),f=p("div",{}),m=p("div",{class:"ways"}),v=p("select",{},...[["travel",re("wheel travel")],...l?[["rack",re("rack travel")]]:[],["roll",re("roll of the body")]].map(([ae,Xe])=>p("option",{value:ae},Xe))),_=(ae,Xe)=>{Xe===v.value&&!ae?P():j()},g={travel:new ol("travel",re("Wheel travel, bump positive"),"mm",c,c/10,ae=>_(ae,"travel")),rack:new ol("rack",re("Rack travel, to the left positive"),"mm",o?10:20,o?1:2,ae=>_(ae,"rack")),roll:new ol("roll",re("Roll, left side up positive"),"deg",4,.5,ae=>_(ae,"roll"))},x=()=>{let ae=v.value;g.travel.swept(ae==="travel",ae!=="roll"),g.rack.swept(ae==="rack",l),g.roll.swept(ae==="roll",ae==="roll")};v.addEventListener("change",()=>{x(),j()});let T=s.filter(ae=>Ir.includes(ae.kind)&&ae.path!==t).map(ae=>ae.path),S=a?await Hf(t):[],R=p("select",{},p("option",{value:""},re("nothing else")),...S.length?[p("optgroup",{label:re("earlier versions")},...S.map(ae=>p("option",{value:ae.name},`${re("replaced")} ${new Date(ae.replaced*1e3).toISOString().slice(0,16).replace("T"," ")} UTC`)))]:[],...T.length?[p("optgroup",{label:re("this project")},...T.map(ae=>p("option",{value:ae},ae)))]:[],p("optgroup",{label:re("shipped")},...r.map(ae=>p("option",{value:ae.name},ae.name))));R.addEventListener("change",()=>{j()});let w=new Qs(!0),y=p("div",{class:"player bare"},w.element),C=null,z=!0,U=1,D={low:0,high:0},L=Ci(re("centres"),!0,ae=>{z=ae,w.showCentres(ae?C:null)},re("instant centres in front and side view, and the roll centre"));w.element.querySelector(".bar").append(p("div",{class:"group"},L));let F=new Vh(ae=>{g[v.value].value=ae,P()}),P=()=>{let ae=g[v.value],Xe=Math.min(Math.max(ae.value,D.low),D.high);w.set({body:0,travel:Xe*U,ground:G(Xe*U),load:1,time:0}),F.mark(Xe)},G=ae=>0,q=n.numbers.map(ae=>ae.path).filter(ae=>/ball_joint\[2\]|tie_rod_(inner|outer)\[2\]/.test(ae)).slice(0,4),W=new Oa(n,q,()=>{Z.set(he()),j()}),he=()=>n.numbers.map(({path:ae,value:Xe})=>({path:ae,value:W.changes[ae]??Xe})),Z=new Va(w,ae=>{for(let[Xe,tt]of Object.entries(ae))W.set(Xe,tt);j()});Z.set(n.numbers);let Q=[],te=p("select",{},p("option",{value:""},re("none")),...s.filter(ae=>ae.kind==="design").map(ae=>p("option",{value:ae.path},ae.path)));te.addEventListener("change",()=>{j()});let ue=[],de=new gf(Q,()=>ue,()=>{j()}),j=()=>h.ask(async()=>{let ae=performance.now(),Xe=v.value,tt=ft=>ft.name===Xe?ft.range.value:ft.value?`${ft.value} ${ft.unit}`:"",rt=setTimeout(()=>{u.textContent=re("computing; the first time a model is compiled once, which takes some seconds")},500);try{let ft=Ji.of(await qr("kinematics",{rig:t,changes:W.changes,over:Xe,against:R.value,targets:Q,study:te.value,travel:Xe==="roll"?"":tt(g.travel),rack:l?tt(g.rack):"",roll:Xe==="roll"?tt(g.roll):""}));if(!i.isConnected)return;let Ct=ft.content,qt=ft.content.viewers[0],wt=qt.scenes[0],sn=ft.get(wt.x);if(C=Ct.centres,D={low:sn[0],high:sn[sn.length-1]},wt.motion){let lt=ft.content.mechanisms[wt.motion.mechanism],Bt=lt.travel;U=Math.abs(D.high)>0?Bt[Bt.length-1]/D.high:D.low!==0?Bt[0]/D.low:1,G=Wt=>lt.contact[jE(Bt,Wt)]?.[2]??0,w.show(lt,wt.motion),w.showCentres(z?C:null)}ue=wt.panes.filter(lt=>!lt.name.startsWith("Δ")).map(({name:lt,unit:Bt})=>({name:lt,unit:Bt})),de.offer(),F.show(qt,ft,Ct.targets),P(),f.replaceChildren(...Ct.notes.map(lt=>p("p",{class:"muted"},lt))),me.replaceChildren(...(qt.roles.length>1?qt.roles:[]).map(({role:lt,label:Bt},Wt)=>p("li",{},p("i",{class:`swatch ${lt}`}),Bt,Wt?` (${re("dashed")})`:""))),m.replaceChildren(...uf(Ct)),w.draw(),d.push(performance.now()-ae),u.textContent=re("# curves computed and drawn",String(ue.length))+` ${re("in")} ${De(d[d.length-1],2)} ms`,u.classList.remove("problem")}catch(ft){u.textContent=ft instanceof Error?ft.message:String(ft),u.classList.add("problem")}finally{clearTimeout(rt)}}),me=p("ul",{class:"legend"}),ve=p("input",{type:"search",placeholder:re("camber, roll centre …")});ve.addEventListener("input",()=>F.filter(ve.value));let Ee=p("button",{type:"button"},re("Write these changes into the file")),xe=p("span",{"aria-live":"polite"});Ee.addEventListener("click",()=>{if(!Object.keys(W.changes).length){xe.textContent=re("Nothing is changed.");return}(async()=>{try{let ae=await $r(t),Xe=await Zi(t,ae.text,[],W.changes);if(Xe.problems.length)throw new Error(Xe.problems[0].text);await or(t,Xe.text,ae.digest),sessionStorage.setItem("written",re("The changes stand in the file; what it was before is an earlier version.")),dispatchEvent(new HashChangeEvent("hashchange"))}catch(ae){xe.replaceChildren(Ut(ae))}})()});let qe=a?L0(t,n,Q,W,ae=>{for(let[Xe,tt]of Object.entries(ae))W.set(Xe,tt);Z.set(he()),j()}):p("p",{class:"muted"},re("Start a rig of your own from this one to design it.")),st=()=>{i.isConnected&&(w.draw(),requestAnimationFrame(st))};Ri(()=>w.repaint()),x(),i.replaceChildren(p("h1",{},re("Kinematics of #",t)),...a?[p("p",{class:"bar"},p("a",{href:It("rig",{name:t})},re("To its file")))]:[],p("div",{class:"form"},He(re("Curves over"),v),He(re("Compare with"),R),He(re("Targets of a study"),te),He(re("Show curves with"),ve)),p("div",{class:"sliders drives"},...["travel",...l?["rack"]:[],"roll"].map(ae=>g[ae].element)),u,f,p("div",{class:"beside"},p("div",{class:"stuck"},y,Z.element),p("div",{},me,p("div",{class:"scrolled",tabindex:"0",role:"region","aria-label":re("curves")},F.element))),p("h2",{},re("Numbers")),W.element,...a?[p("p",{class:"bar"},Ee,xe)]:[],p("h2",{},re("Targets")),de.element,p("h2",{},re("Design from targets")),qe,m),xe.textContent=sessionStorage.getItem("written")??"",sessionStorage.removeItem("written"),requestAnimationFrame(st),await j()}function jE(i,e){let t=0;return i.forEach((n,s)=>{Math.abs(n-e)<Math.abs(i[t]-e)&&(t=s)}),t}var gf=class{constructor(e,t,n){this.targets=e;this.quantities=t;this.changed=n;let s=p("select",{},...[["value","="],["at_least","≥"],["at_most","≤"]].map(([h,d])=>p("option",{value:h,title:h},d))),r=p("input",{type:"text",value:"0 deg"}),a=p("input",{type:"text",value:"0.1 deg"}),o=p("input",{type:"text",value:"-20 mm:20 mm:10 mm"}),l=()=>{let h=this.quantities().find(d=>d.name===this.quantity.value);if(h){let d=h.unit.replace("°","deg");r.value=`0 ${d}`.trim(),a.value=`0.1 ${d}`.trim()}};this.quantity.addEventListener("change",l);let c=p("form",{class:"form"},He(re("Quantity"),this.quantity),He(re("is wanted"),s),He(re("Value"),r),He(re("Tolerance"),a),He(re("At, or over first:last:step"),o),p("button",{type:"submit"},re("Add the target")));c.addEventListener("submit",h=>{h.preventDefault(),e.push({quantity:this.quantity.value,[s.value]:r.value,tolerance:a.value,...o.value.includes(":")?{over:o.value}:o.value?{at:o.value}:{}}),this.list(),n()}),this.element.append(p("div",{class:"table"},p("table",{},this.rows)),c),this.list()}targets;quantities;changed;element=p("div",{});quantity=p("select",{});rows=p("tbody",{});known="";offer(){let e=this.quantities().map(n=>n.name);if(e.join()===this.known)return;this.known=e.join();let t=this.quantity.value;this.quantity.replaceChildren(...e.map(n=>p("option",{value:n},n.replaceAll("_"," ")))),e.includes(t)&&(this.quantity.value=t)}list(){this.rows.replaceChildren(...this.targets.length?this.targets.map((e,t)=>p("tr",{},p("th",{scope:"row"},e.quantity.replaceAll("_"," ")),p("td",{},e.value!==void 0?`= ${e.value} ± ${e.tolerance}`:e.at_least!==void 0?`≥ ${e.at_least} − ${e.tolerance}`:`≤ ${e.at_most} + ${e.tolerance}`),p("td",{},e.over??e.at??re("at design")),p("td",{},p("button",{type:"button","aria-label":re("Take # away",e.quantity),click:()=>{this.targets.splice(t,1),this.list(),this.changed()}},"×")))):[p("tr",{},p("td",{class:"muted"},re("None yet: add one below, and its band stands in its curve.")))])}};var F0={label:"Project",show:QE};async function QE(i){let[{name:e,folder:t,entries:n},s]=await Promise.all([xi(),Os()]);document.getElementById("project").textContent=e;let r=n.map(d=>p("tr",{},p("th",{scope:"row"},d.kind==="rig"?p("a",{href:It("rig",{name:d.path})},d.path):d.path),p("td",{},d.kind),p("td",{class:"right"},`${De(d.size/1e3,3)} kB`),p("td",{},new Date(d.modified*1e3).toISOString().slice(0,16).replace("T"," ")),p("td",{},...Ir.includes(d.kind)?[p("a",{href:It("trial",{rig:d.path})},"drive it")]:[]))),a=p("select",{},...s.map(d=>p("option",{value:d.name},d.name))),o=p("input",{type:"text",value:`${s[0]?.name??"rig"}.toml`,spellcheck:"false"});a.addEventListener("change",()=>{o.value=`${a.value}.toml`});let l=p("div",{"aria-live":"polite"}),c=p("button",{type:"submit",class:"main"},"Copy it here"),h=p("form",{class:"form"},He("Shipped rig",a),He("Name of your file",o),c);h.addEventListener("submit",d=>{d.preventDefault(),Xf(a.value,o.value).then(u=>{location.hash=It("rig",{name:u.path})},u=>l.replaceChildren(Ut(u)))}),i.replaceChildren(p("h1",{},e),p("p",{class:"muted"},t),n.length?p("div",{class:"table",tabindex:"0",role:"region","aria-label":"files"},p("table",{},p("thead",{},p("tr",{},...["file","what it is","size","written (UTC)",""].map(d=>p("th",{scope:"col"},d)))),p("tbody",{},...r))):p("p",{class:"empty"},"No rigs, roads or records lie here yet. Start from a rig that comes with jounce, or put your files into the folder."),p("h2",{},"Start from an example"),h,l)}var k0=["schema","model"],_f=i=>typeof i=="object"&&i!==null&&!Array.isArray(i),vf=i=>i.map((e,t)=>typeof e=="number"?`[${e}]`:t?`.${e}`:e).join(""),Gh=class{constructor(e){this.changed=e}changed;element=p("div",{class:"described"});open=new Set(["hardpoints","strut","sprung","unsprung","tyre"]);definitions={};problems=[];show(e,t,n){let s=document.activeElement?.closest("[data-path]")?.dataset.path,r=this.element.contains(document.activeElement);this.definitions=e.$defs??{},this.problems=n,this.element.replaceChildren(...this.rows(e,t,[]));let a=new Set([...this.element.querySelectorAll("[data-path]")].map(l=>l.dataset.path)),o=n.filter(l=>!a.has(l.path));o.length&&this.element.prepend(...o.map(l=>p("p",{class:"problem",role:"alert"},`${l.line?`${re("line #",String(l.line))}: `:""}${l.path?`${l.path}: `:""}${l.text}`))),r&&s&&this.element.querySelector(`[data-path="${CSS.escape(s)}"]`)?.querySelector("input, select")?.focus()}resolved(e){return e.$ref?this.definitions[e.$ref.split("/").pop()]:e}choices(e){let t=this.resolved(e),n=t.anyOf??t.oneOf;return n?n.flatMap(s=>this.choices(s)).filter(s=>s.type!=="null"):[t]}rows(e,t,n){let s=this.resolved(e),r=s.properties??{},a=[...Object.keys(t),...(s.required??[]).filter(h=>!(h in t))].filter(h=>n.length||!k0.includes(h)),o=[],l=[];for(let h of a){let d=this.field(h,r[h]??{},t[h],[...n,h],(s.required??[]).includes(h)||!r[h]?.$ref&&r[h]?.default===void 0);(d.tagName==="DETAILS"?l:o).push(d)}let c=Object.keys(r).filter(h=>!(h in t)&&!a.includes(h)&&!(k0.includes(h)&&!n.length));return[...o,...l,...c.length?[this.more(c,r,n)]:[]]}more(e,t,n){let s=p("select",{"aria-label":re("Add to #",vf(n)||re("the rig"))},p("option",{value:""},re("add …")),...e.map(r=>p("option",{value:r},r.replaceAll("_"," "))));return s.addEventListener("change",()=>{s.value&&(this.open.add(vf([...n,s.value])),this.changed([...n,s.value],this.first(t[s.value])))}),p("p",{class:"add"},s)}first(e){if(e.default!==void 0&&e.default!==null&&!_f(e.default))return e.default;let t=this.choices(e)[0];return t.const!==void 0?t.const:t.enum?t.enum[0]:t.properties?Object.fromEntries(Object.entries(t.properties).filter(([n,s])=>t.required?.includes(n)||s.const!==void 0).map(([n,s])=>[n,this.first(s)])):t.prefixItems?t.prefixItems.map(n=>this.first(n)):t.type==="array"?[]:t.type==="boolean"?!1:"?"}field(e,t,n,s,r){let a=vf(s),o=this.problems.filter(g=>g.path===a),l=`f-${a}`,c=typeof s[s.length-1]=="number"?String(s[s.length-1]):e.replaceAll("_"," "),h=o.length?[p("span",{class:"wrong",role:"alert",id:`${l}-wrong`},o.map(g=>g.text).join(" "))]:[],d=r?[]:[p("button",{type:"button",class:"away",title:re("Take # away",a),"aria-label":re("Take # away",a),click:()=>this.changed(s,null)},"×")],u=this.choices(t);if(_f(n)||n===void 0&&u.some(g=>g.properties)){let g=p("details",{"data-path":a,open:this.open.has(a)||this.problems.some(w=>w.path.startsWith(a))});g.addEventListener("toggle",()=>{g.open?this.open.add(a):this.open.delete(a)});let x=_f(n)?n:{},T=u.filter(w=>w.properties),S=this.kindOf(T,x),R=p("select",{"aria-label":re("kind of #",a)},...T.map((w,y)=>p("option",{value:String(y),...w===S?{selected:!0}:{}},e1(w.title??""))));return R.addEventListener("change",()=>this.changed(s,this.become(T[Number(R.value)],x))),g.append(p("summary",{},c),...T.length>1?[p("p",{class:"kind"},R)]:[],...h,...this.rows(S??{},x,s),...d),g}let f={id:l,...o.length?{"aria-invalid":"true","aria-describedby":`${l}-wrong`}:{}};if(Array.isArray(n)&&n.every(g=>typeof g!="object")){let g=u.find(x=>x.prefixItems)?.prefixItems;if(g&&g.length===n.length){let x=this.problems.filter(S=>S.path.startsWith(`${a}[`)),T=n.map((S,R)=>this.typed(String(S),g[R],[...s,R],{"aria-label":`${a}[${R}]`,...x.some(w=>w.path===`${a}[${R}]`)?{"aria-invalid":"true"}:{}}));return p("div",{class:"row","data-path":a},p("span",{class:"name"},c),p("span",{class:"three"},...T.map((S,R)=>p("span",{"data-path":`${a}[${R}]`},S))),...d,...h,...x.map(S=>p("span",{class:"wrong",role:"alert"},`${S.path}: ${S.text}`)))}}let m,v=u.find(g=>g.enum);if(v?.enum&&typeof n=="string"){let g=p("select",f,...[...new Set([n,...v.enum])].map(x=>p("option",{value:x,...x===n?{selected:!0}:{}},x)));g.addEventListener("change",()=>this.changed(s,g.value)),m=g}else if(typeof n=="boolean"){let g=p("input",{type:"checkbox",...f,checked:n});g.addEventListener("change",()=>this.changed(s,g.checked)),m=g}else u.length===1&&u[0].const!==void 0?m=p("output",f,String(n)):m=this.typed(n===void 0?"":typeof n=="object"?JSON.stringify(n):String(n),t,s,f,typeof n=="object");let _=t.description??u.find(g=>g.description)?.description??"";return p("div",{class:"row","data-path":a},p("label",{class:"name",for:l,title:_},c),m,...d,...h)}typed(e,t,n,s,r=!1){let a=p("input",{type:"text",spellcheck:"false",value:e,...s}),o=this.choices(t).map(l=>l.type);return a.addEventListener("change",()=>{let l=a.value.trim();if(r)try{this.changed(n,JSON.parse(l))}catch{this.changed(n,l)}else this.changed(n,l!==""&&!Number.isNaN(Number(l))&&o.some(c=>c==="number"||c==="integer")?Number(l):l)}),a}kindOf(e,t){let n=e.find(r=>r.properties?.kind?.const!==void 0&&r.properties.kind.const===t.kind),s=r=>Object.keys(t).filter(a=>a in r.properties).length-Object.keys(t).filter(a=>!(a in r.properties)).length-(r.required??[]).filter(a=>!(a in t)).length;return n??[...e].sort((r,a)=>s(a)-s(r))[0]}become(e,t){let n=this.first(e);for(let[s,r]of Object.entries(t))s!=="kind"&&s in e.properties&&(n[s]=r);return n}};function e1(i){return i.replace(/([a-z])([A-Z])/g,"$1 $2").toLowerCase()}var B0={label:"Rig",show:t1};async function t1(i,e){let t=e.get("name");if(!t){await za(i,"rig",re("Rig"),"name");return}let n=await $r(t),s=null,r=[],a=[],o=p("textarea",{spellcheck:"false","aria-label":re("text of #",t),rows:"28"});o.value=n.text;let l=n.text,c=p("div",{class:"told","aria-live":"polite"}),h=p("div",{}),d=p("button",{type:"button",class:"main",disabled:!0},re("Save")),u=p("button",{type:"button",disabled:!0},re("Undo")),f=p("button",{type:"button",disabled:!0},re("Redo")),m=new Lr,v=new Lr,_=new Gh((L,F)=>{C({sets:[[L,F]]})}),g=new Qs(!0),x=p("div",{class:"player bare",hidden:!0},g.element),T=new Va(g,(L,F)=>{F?C({changes:L}):w(L)}),S=p("section",{hidden:!0,"aria-label":re("The mechanism")},p("h2",{},re("The mechanism")),p("p",{class:"muted"},re("Drag a hardpoint, or choose it and type its place; drag beside them to turn the picture.")),T.element,x),R=()=>{d.disabled=o.value===n.text,u.disabled=!r.length,f.disabled=!a.length},w=(L={})=>v.ask(async()=>{if(s?.rig?.spatial)try{let F=Ji.of(await qr("kinematics",{rig:t,text:o.value,changes:L,travel:"-20 mm:20 mm:10 mm",channels:["camber"]})),P=F.content.viewers[0].scenes[0].motion;if(!P)return;S.hidden=x.hidden=!1,g.show(F.content.mechanisms[P.mechanism],P),g.set({body:0,travel:0,ground:F.content.mechanisms[P.mechanism].contact[2][2],load:1,time:0})}catch(F){c.replaceChildren(Ut(F))}}),y=async(L,F)=>{if(F&&L.text!==l&&(r.push(l),a.length=0),l=L.text,o.value!==L.text&&(o.value=L.text),s=L,R(),L.model)try{_.show(await $f(L.model),L.values,L.problems)}catch{_.element.replaceChildren()}let P=L.problems.map(G=>Ut(new Error(`${G.line?`${re("line #",String(G.line))}: `:""}${G.path?`${G.path}: `:""}${G.text}`)));c.replaceChildren(...P.length?P:[p("p",{class:"good"},re("#: nothing is wrong with it.",`${L.model}, ${re("# numbers",String(L.rig?.numbers.length??0))}`))],...(L.rig?.findings??[]).map(G=>p("p",{},G))),h.replaceChildren(),L.rig&&(T.set(L.rig.numbers),await w()),L.rig&&!L.rig.spatial&&(S.hidden=!0)},C=L=>m.ask(async()=>{try{await y(await Zi(t,o.value,L.sets??[],L.changes??{}),!0)}catch(F){c.replaceChildren(Ut(F))}}),z=0;o.addEventListener("input",()=>{d.disabled=o.value===n.text,clearTimeout(z),z=setTimeout(()=>{C({})},400)});let U=(L,F)=>{let P=L.pop();P!==void 0&&(F.push(l),l=P,o.value=P,m.ask(async()=>{await y(await Zi(t,P,[],{}),!1)}))};u.addEventListener("click",()=>U(r,a)),f.addEventListener("click",()=>U(a,r)),i.addEventListener("keydown",L=>{!(L.ctrlKey||L.metaKey)||L.target===o||(L.key==="z"&&!L.shiftKey&&(L.preventDefault(),U(r,a)),(L.key==="y"||L.key==="Z"&&L.shiftKey)&&(L.preventDefault(),U(a,r)))}),d.addEventListener("click",()=>{let L=p("button",{type:"button",class:"main"},re("Write it")),F=p("button",{type:"button"},re("Back"));F.addEventListener("click",()=>h.replaceChildren()),L.addEventListener("click",()=>{or(t,o.value,n.digest).then(async P=>{n=P,R(),await y(await Zi(t,P.text,[],{}),!1),c.prepend(p("p",{class:"good"},re("Saved.")))},P=>h.replaceChildren(Ut(P)))}),m.ask(async()=>{let P=await Zi(t,o.value,[],{});h.replaceChildren(p("section",{class:"difference","aria-label":re("What is changed")},p("h2",{},re("What is changed")),...P.problems.length?[p("p",{class:"problem"},re("Something is still wrong with it; it can be saved all the same."))]:[],p("pre",{tabindex:"0","aria-label":re("What is changed")},...P.changed.map(G=>p("span",{class:G.startsWith("+")?"added":G.startsWith("-")?"removed":G.startsWith("@@")?"muted":""},`${G}
`))),p("div",{class:"bar"},L,F))),L.focus()})});let D=()=>{i.isConnected&&(g.draw(),requestAnimationFrame(D))};Ri(()=>{g.repaint()}),i.replaceChildren(p("h1",{},t),p("p",{class:"bar"},p("a",{href:It("trial",{rig:t})},re("Drive it over an obstacle")),p("a",{href:It("kinematics",{rig:t})},re("Look at its kinematics"))),c,p("div",{class:"bar"},d,u,f),h,S,p("div",{class:"two"},p("section",{"aria-label":re("Form")},p("h2",{},re("Form")),_.element),p("section",{"aria-label":re("File")},p("h2",{},re("File")),o))),await y(await Zi(t,n.text,[],{}),!1),requestAnimationFrame(D)}var Dr={"half-sine":["height","length"],versine:["height","length"],rectangle:["height","length"],triangle:["height","length"],step:["height"],pothole:["depth","length"]},Hh={height:"10 mm",depth:"10 mm",length:"60 mm"};var Ga=i=>`${i.name} [${i.unit||"–"}]`,qh=i=>{let e=1/0,t=-1/0;for(let n of i)n!==null&&(n<e&&(e=n),n>t&&(t=n));return e<t?[e,t]:e===t?[e-(Math.abs(e)||1)*.5,e+(Math.abs(e)||1)*.5]:[0,1]},Yh=class{constructor(e){this.columns=e;this.count()}columns;ranges=new Map;chosen=[];picked=-1;listeners=[];listen(e){this.listeners.push(e)}set(e,t){t?this.ranges.set(e,t):this.ranges.delete(e),this.count()}clear(){this.ranges.clear(),this.count()}pick(e){this.picked=e;for(let t of this.listeners)t()}count(){let e=this.columns[0]?.values.length??0;this.chosen=Array.from({length:e},(t,n)=>[...this.ranges].every(([s,[r,a]])=>{let o=this.columns[s].values[n];return o!=null&&o>=r&&o<=a}));for(let t of this.listeners)t()}};function z0(i,e){let t=Math.min(window.devicePixelRatio||1,2),n=p("canvas",{width:String(Math.round(i*t)),height:String(Math.round(e*t))}),s=n.getContext("2d");return s.scale(t,t),n.style.width=`${i}px`,n.style.height=`${e}px`,[n,s]}var Wh=130,Nr=26,ll=250,n1=22;function V0(i){let{columns:e}=i,t=e.map(f=>qh(f.values)),n=Wh*e.length,s=Nr+ll+n1,[r,a]=z0(n,s);r.setAttribute("role","img"),r.setAttribute("aria-label",`every variant as a line through ${e.map(Ga).join(", ")}`);let o=f=>Wh*(f+.5),l=(f,m)=>{let[v,_]=t[f];return Nr+ll*(1-(m-v)/(_-v))},c=()=>{a.clearRect(0,0,n,s);let f=v=>{a.beginPath();let _=!1;e.forEach((g,x)=>{let T=g.values[v];if(T==null){_=!1;return}_?a.lineTo(o(x),l(x,T)):a.moveTo(o(x),l(x,T)),_=!0}),a.stroke()},m=i.chosen.length;if(a.lineWidth=1,a.strokeStyle=Tt("line"),i.ranges.size)for(let v=0;v<m;v++)i.chosen[v]||f(v);a.strokeStyle=Tt("accent"),a.globalAlpha=Math.max(.08,Math.min(.7,60/Math.max(m,1)));for(let v=0;v<m;v++)i.chosen[v]&&f(v);a.globalAlpha=1,i.picked>=0&&(a.strokeStyle=Tt("other-5"),a.lineWidth=2.5,f(i.picked)),a.font="12px system-ui, sans-serif",a.textAlign="center",e.forEach((v,_)=>{let[g,x]=t[_];a.strokeStyle=Tt("edge"),a.lineWidth=1,a.beginPath(),a.moveTo(o(_),Nr),a.lineTo(o(_),Nr+ll),a.stroke();let T=i.ranges.get(_);T&&(a.fillStyle=Tt("other-5"),a.globalAlpha=.3,a.fillRect(o(_)-7,l(_,T[1]),14,Math.max(2,l(_,T[0])-l(_,T[1]))),a.globalAlpha=1),a.fillStyle=Tt("ink"),a.fillText(De(x,3),o(_),Nr-8),a.fillText(De(g,3),o(_),Nr+ll+15)})},h=null,d=f=>{let m=r.getBoundingClientRect(),v=Math.min(e.length-1,Math.max(0,Math.floor((f.clientX-m.left)/Wh))),_=Math.min(1,Math.max(0,1-(f.clientY-m.top-Nr)/ll)),[g,x]=t[h?.k??v];return{k:v,value:g+_*(x-g)}};r.addEventListener("pointerdown",f=>{h=d(f),r.setPointerCapture(f.pointerId)}),r.addEventListener("pointermove",f=>{if(!h)return;let{value:m}=d(f),[v,_]=t[h.k];Math.abs(m-h.value)>.01*(_-v)&&i.set(h.k,[Math.min(m,h.value),Math.max(m,h.value)])}),r.addEventListener("pointerup",f=>{h&&Math.abs(d(f).value-h.value)<.01*(t[h.k][1]-t[h.k][0])&&i.set(h.k,null),h=null}),i.listen(c),Ri(c),c();let u=p("div",{class:"axes"},...e.map(f=>p("span",{title:Ga(f)},f.name,p("small",{},f.unit||"–"))));return u.style.width=`${n}px`,u.style.gridTemplateColumns=`repeat(${e.length}, ${Wh}px)`,p("div",{class:"wide",tabindex:"0",role:"region","aria-label":"parallel coordinates"},u,r)}function G0(i){let e=i.columns.map((t,n)=>{let[s,r]=qh(t.values),a=["from","to"].map(l=>p("input",{type:"number",step:"any","aria-label":`${t.name}, ${l} [${t.unit||"–"}]`,placeholder:De(l==="from"?s:r,4)})),o=()=>{let[l,c]=a.map(h=>h.value);i.set(n,l||c?[l?Number(l):-1/0,c?Number(c):1/0]:null)};for(let l of a)l.addEventListener("change",o);return i.listen(()=>{let l=i.ranges.get(n);a.forEach((c,h)=>{document.activeElement!==c&&(c.value=l&&Number.isFinite(l[h])?String(Number(l[h].toPrecision(4))):"")})}),p("tr",{},p("th",{scope:"row"},t.name),p("td",{},a[0]),p("td",{},a[1]),p("td",{},t.unit||"–"))});return p("details",{},p("summary",{},"Ranges as numbers"),p("div",{class:"table",tabindex:"0",role:"region","aria-label":"ranges"},p("table",{},p("thead",{},p("tr",{},...["","from","to","unit"].map(t=>p("th",{scope:"col"},t)))),p("tbody",{},...e))))}var Xh=170,cl=130,$h=8;function i1(i,e,t){let[n,s]=z0(Xh,cl),[r,a]=qh(e.values),[o,l]=qh(t.values),c=u=>$h+(Xh-2*$h)*(u-r)/(a-r),h=u=>cl-$h-(cl-2*$h)*(u-o)/(l-o);n.setAttribute("role","img"),n.setAttribute("aria-label",`${Ga(t)} over ${Ga(e)}: ${De(o,3)} to ${De(l,3)} over ${De(r,3)} to ${De(a,3)}`);let d=()=>{s.clearRect(0,0,Xh,cl),s.strokeStyle=Tt("edge"),s.strokeRect(.5,.5,Xh-1,cl-1);let u=i.chosen.length,f=(m,v)=>{let _=e.values[m],g=t.values[m];_!=null&&g!==null&&g!==void 0&&s.fillRect(c(_)-v/2,h(g)-v/2,v,v)};s.fillStyle=Tt("line");for(let m=0;m<u;m++)i.chosen[m]||f(m,2);s.fillStyle=Tt("accent"),s.globalAlpha=u>400?.5:.9;for(let m=0;m<u;m++)i.chosen[m]&&f(m,2.5);s.globalAlpha=1,i.picked>=0&&(s.fillStyle=Tt("other-5"),f(i.picked,7))};return n.addEventListener("click",u=>{let f=n.getBoundingClientRect(),m=[u.clientX-f.left,u.clientY-f.top],v=-1,_=15**2;e.values.forEach((g,x)=>{let T=t.values[x];if(g===null||T===null||T===void 0||!i.chosen[x])return;let S=(c(g)-m[0])**2+(h(T)-m[1])**2;S<_&&(_=S,v=x)}),v>=0&&i.pick(v)}),i.listen(d),Ri(d),d(),n}function H0(i){let e=i.columns.filter(n=>n.is_number).slice(0,8),t=i.columns.filter(n=>!n.is_number).slice(0,6);return p("div",{class:"wide table",tabindex:"0",role:"region","aria-label":"matrix of dots"},p("table",{class:"matrix"},p("thead",{},p("tr",{},p("td",{}),...e.map(n=>p("th",{scope:"col"},Ga(n))))),p("tbody",{},...t.map(n=>p("tr",{},p("th",{scope:"row"},Ga(n)),...e.map(s=>p("td",{},i1(i,s,n))))))))}var s1=[["total","share of the variance, with others"],["mean_absolute_effect","mean size of effects"],["regression","regression coefficient"]];function W0(i,e,t){let n=(d,u)=>{let f=d.measures[u];return typeof f=="number"?f:f?.value??NaN},s=i.filter(d=>d.metric===e.name),[r,a]=s1.find(([d])=>s.some(u=>Number.isFinite(n(u,d))))??["regression","regression coefficient"];s.sort((d,u)=>Math.abs(n(u,r))-Math.abs(n(d,r)));let o=s.map(d=>[n(d,"at_low"),n(d,"at_high")].map(u=>(u-t)*e.factor)),l=Math.max(1e-300,...o.flat().filter(Number.isFinite).map(Math.abs)),c=(d,u)=>{let f=document.createElementNS("http://www.w3.org/2000/svg",d);for(let[m,v]of Object.entries(u))f.setAttribute(m,String(v));return f},h=s.map((d,u)=>{let f=c("svg",{viewBox:"-100 0 200 16",class:"swing","aria-hidden":"true"});f.append(c("line",{x1:0,x2:0,y1:0,y2:16,class:"zero"})),o[u].forEach((v,_)=>{if(!Number.isFinite(v))return;let g=96*v/l;f.append(c("rect",{x:Math.min(0,g),width:Math.abs(g),y:_?8.5:1.5,height:6,class:_?"high":"low"}))});let m=o[u].map(v=>Number.isFinite(v)?`${v>0?"+":""}${De(v,3)}`:"–");return p("tr",{},p("th",{scope:"row"},d.number),p("td",{class:"right"},m[0]),p("td",{},f),p("td",{class:"right"},m[1]),p("td",{class:"right"},De(n(d,r),3)))});return p("div",{class:"table",tabindex:"0",role:"region","aria-label":`what ${e.name} depends on`},p("table",{},p("caption",{},`${e.name}: from its mean of ${De(t*e.factor,4)} ${e.unit}, where a number is low and where it is high`),p("thead",{},p("tr",{},p("th",{scope:"col"},"number"),p("th",{scope:"col",class:"right"},p("span",{class:"key low"}),` low [${e.unit||"–"}]`),p("th",{scope:"col"},""),p("th",{scope:"col",class:"right"},p("span",{class:"key high"}),` high [${e.unit||"–"}]`),p("th",{scope:"col",class:"right"},a))),p("tbody",{},...h)))}var $0={label:"Studies",show:r1};async function r1(i,e){let t=e.get("job"),n=e.get("folder");if(t||n){await l1(i,t,n);return}let{entries:s}=await xi(),r=[...s.filter(o=>Ir.includes(o.kind)).map(o=>o.path),...(await Os()).map(o=>o.name)],a=s.filter(o=>o.kind==="sweep");i.replaceChildren(p("h1",{},"Studies"),p("p",{class:"muted"},"Numbers of a rig are spread over ranges or distributions; every variant is simulated, and what its metrics depend on is told."),p("h2",{},"Sweeps"),ka(["sweep"],o=>{location.hash=It("studies",{job:o.id})},"No sweep was begun here yet. Write a study below, or begin one that lies in the folder."),...a.length?[p("h2",{},"Studies that lie here"),p("ul",{},...a.map(o=>p("li",{},o.path," ",a1(o.path))))]:[],p("h2",{},"A new study"),await o1(r,e.get("rig")??""))}function a1(i){let e=i.replace(/\.toml$/,"-swept"),t=p("span",{}),n=p("button",{type:"button","aria-label":`Begin ${i}`},"Begin");return n.addEventListener("click",()=>{nl({kind:"sweep",study:i,out:e,resume:!0}).then(()=>t.replaceChildren(),s=>t.replaceChildren(Ut(s)))}),p("span",{},n," ",p("small",{class:"muted"},`into ${e}`),t)}var xf={sobol:["Sobol: even over all numbers",!0],"latin-hypercube":["Latin hypercube",!0],"monte-carlo":["Monte Carlo: random",!0],grid:["Grid: every combination",!1],list:["List: one value of each a variant",!1],morris:["Morris: screening by trajectories",!0],saltelli:["Saltelli: indices of the variance",!0]},X0={share:["± share",["20 %"]],range:["range",["from","to"]],normal:["normal",["mean","sd"]],triangular:["triangular",["low","mode","high"]],values:["values",["one, another, ..."]]};async function o1(i,e){if(!i.length)return p("p",{class:"empty"},"No rig lies here yet.");let t=p("select",{},...i.map(L=>p("option",L===e?{value:L,selected:!0}:{value:L},L))),n=p("tbody",{}),s=p("datalist",{id:"paths-of-the-rig"}),r=p("select",{},...Object.entries(xf).map(([L,[F]])=>p("option",{value:L},F))),a=p("input",{type:"number",min:"1",value:"256"}),o=p("input",{type:"number",min:"0",value:"0"}),l=p("input",{type:"text",value:"rms sprung.az, max strut.deflection"}),c=p("select",{},...Object.keys(Dr).map(L=>p("option",{value:L},L.replace("-"," "))),p("option",{value:"iso"},"random road (ISO 8608)")),h=p("span",{class:"sizes"}),d=p("input",{type:"text",value:"2 m/s"}),u=p("input",{type:"text",value:"1.5 s"}),f=p("input",{type:"text",value:"study.toml",spellcheck:"false"}),m=p("input",{type:"text",value:"swept",spellcheck:"false"}),v=p("div",{"aria-live":"polite"});f.addEventListener("change",()=>{m.value=`${f.value.replace(/\.toml$/,"")}-swept`});let _=[],g=(L="",F="share")=>{let P=p("input",{type:"text",value:L,list:"paths-of-the-rig","aria-label":"number that varies",size:"30",spellcheck:"false"}),G=p("select",{"aria-label":"how it is spread"},...Object.entries(X0).map(([te,[ue]])=>p("option",te===F?{value:te,selected:!0}:{value:te},ue))),q=p("span",{class:"sizes"}),W=p("td",{class:"muted"}),he=()=>{let te=_.find(me=>me.path===P.value);W.textContent=te?`is ${De(te.value*te.factor)} ${te.unit}`:P.value?"no number of this rig":"";let ue=te?.unit??"",de=te?te.value*te.factor:1,j={from:.8,to:1.2,low:.8,mode:1,high:1.2,mean:1,sd:.05};q.replaceChildren(...X0[G.value][1].map(me=>{let ve=G.value==="share"?"20 %":me in j?`${Number((j[me]*de).toPrecision(4))} ${ue}`.trim():`${Number((.9*de).toPrecision(4))} ${ue}, ${Number((1.1*de).toPrecision(4))} ${ue}`;return p("input",{type:"text",value:ve,"aria-label":`${P.value||"number"}, ${me in j?me:G.value}`,"data-word":me,size:G.value==="values"?"26":"11"})}))};P.addEventListener("change",he),G.addEventListener("change",he);let Z=p("button",{type:"button","aria-label":`leave out ${L||"this number"}`},"×"),Q=p("tr",{},p("td",{},P),p("td",{},G),p("td",{},q),W,p("td",{},Z));Z.addEventListener("click",()=>Q.remove()),he(),n.append(Q)},x=()=>h.replaceChildren(...c.value==="iso"?[He("Class",p("select",{name:"class"},..."ABCDEFGH".split("").map(L=>p("option",L==="C"?{value:L,selected:!0}:{value:L},L))))]:Dr[c.value].map(L=>He(L[0].toUpperCase()+L.slice(1),p("input",{type:"text",value:Hh[L],name:L}))));c.addEventListener("change",x);let T=async()=>{v.replaceChildren();try{_=(await Fs(t.value)).numbers,s.replaceChildren(..._.map(F=>p("option",{value:F.path}))),n.replaceChildren();let L=["strut.spring.rate","strut.damper.coefficient","tyre.stiffness"].filter(F=>_.some(P=>P.path===F));for(let F of L.length?L:_.slice(0,2).map(P=>P.path))g(F)}catch(L){v.replaceChildren(Ut(L))}};t.addEventListener("change",()=>{T()}),r.addEventListener("change",()=>{a.disabled=!xf[r.value][1]});let S=L=>{let F=L.querySelector("select").value,P=Object.fromEntries([...L.querySelectorAll("input[data-word]")].map(q=>[q.dataset.word,q.value.trim()])),G=Object.values(P);return F==="share"?G[0]:F==="range"?G:F==="values"?G[0].split(",").map(q=>q.trim()).filter(Boolean):P},R="",w="",y=async()=>{let L=Object.fromEntries([...h.querySelectorAll("[name]")].map(P=>[P.name,P.value])),F=await(await Kn("POST","/api/study",{path:f.value,was:w===f.value?R:"",rig:t.value,trial:{speed:d.value,duration:u.value,road:c.value==="iso"?`iso:${L.class}`:{kind:c.value,start:"0.2 m",...L}},design:{kind:r.value,...xf[r.value][1]?{count:Number(a.value),seed:Number(o.value)}:{}},vary:Object.fromEntries([...n.rows].map(P=>[P.querySelector("input").value.trim(),S(P)])),metrics:l.value.split(",").map(P=>P.trim()).filter(Boolean)})).json();return R=F.digest,w=f.value,F},C=p("form",{}),z=p("button",{type:"button"},"Write the study"),U=p("button",{type:"submit",class:"main"},"Write it and begin");z.addEventListener("click",()=>{y().then(L=>v.replaceChildren(p("p",{class:"good"},`${L.path}: ${L.count} variants.`)),L=>v.replaceChildren(Ut(L)))}),C.addEventListener("submit",L=>{L.preventDefault(),U.disabled=!0,y().then(F=>nl({kind:"sweep",study:f.value,out:m.value}).then(P=>v.replaceChildren(p("p",{class:"good"},`${F.count} variants begun.`),nr(P)))).catch(F=>v.replaceChildren(Ut(F))).finally(()=>{U.disabled=!1})});let D=p("button",{type:"button"},"Another number");return D.addEventListener("click",()=>g()),C.append(p("div",{class:"form"},He("Rig",t),He("Road",c),h,He("Speed",d),He("Duration",u)),p("div",{class:"table",tabindex:"0",role:"region","aria-label":"what varies"},p("table",{},p("thead",{},p("tr",{},...["number","spread","","",""].map(L=>p("th",{scope:"col"},L)))),n)),s,D,p("div",{class:"form"},He("Design",r),He("Count",a),He("Seed",o),He("Metrics, with commas between",l)),p("div",{class:"form"},He("File of the study",f),He("Folder of the results",m),z,U),v),x(),await T(),C}async function l1(i,e,t){let n=e?await il(e):null,s=t??String(n?.asked.out??""),r=await Un(`/api/sweep?${Yi({folder:s})}`),a=n?.title??`Sweep in ${s}`,o=p("p",{},p("a",{href:It("studies")},"All studies"));if(!r.columns.length){i.replaceChildren(p("h1",{},a),o,p("p",{class:"empty"},"No variant is finished yet."));return}let l=new Yh(r.columns),c=r.variants.length,{summary:h}=r,d=p("p",{class:"state",role:"status"}),u=p("tbody",{}),f=p("button",{type:"button"},"All variants");f.addEventListener("click",()=>l.clear());let m=()=>{let _=l.chosen.flatMap((x,T)=>x?[T]:[]);d.textContent=`${_.length} of ${c} variants`+(c<r.finished?` shown, of ${r.finished}`:"")+(l.picked>=0?`; variant ${r.variants[l.picked]} is marked`:"");let g=[...l.picked>=0?[l.picked]:[],..._.filter(x=>x!==l.picked)].slice(0,20);u.replaceChildren(...g.map(x=>{let T=p("button",{type:"button","aria-label":`mark variant ${r.variants[x]}`,"aria-pressed":String(x===l.picked)},String(r.variants[x]));return T.addEventListener("click",()=>l.pick(x===l.picked?-1:x)),p("tr",{},p("th",{scope:"row"},T),...r.columns.map(S=>p("td",{class:"right"},De(S.values[x]))),p("td",{},...r.run?[p("a",{href:h1(r,x),"aria-label":`open variant ${r.variants[x]} as a trial`},"open as a trial")]:[]))}))};l.listen(m),m();let v=r.columns.filter(_=>!_.is_number);i.replaceChildren(p("h1",{},a),o,p("p",{class:"muted"},`${r.finished} of ${r.count} variants are finished`,h&&h.ran<r.finished?`; ${r.finished-h.ran} have no run`:"","."),...Object.entries(h?.failed??{}).map(([_,g])=>p("p",{class:"problem"},`${g.variants} without a run (variant ${g.first} first): ${_}`)),...(h?.findings??[]).map(_=>p("p",{class:"muted"},`${_.severity}: ${_.message}`)),...h?.metrics.length?[p("h2",{},"Metrics"),c1(h,v)]:[],...h?.influences.length?[p("h2",{},"What they depend on"),...v.flatMap(_=>{let g=h.metrics.find(x=>x.name===_.name);return g?[W0(h.influences,_,g.mean)]:[]})]:[],p("h2",{},"Variants"),p("p",{class:"muted"},"Drag along an axis to keep the variants that pass there; a click on it lets all pass again."),V0(l),p("div",{class:"bar"},d,f),G0(l),...v.length?[H0(l)]:[],p("div",{class:"table",tabindex:"0",role:"region","aria-label":"chosen variants"},p("table",{},p("caption",{},"The first of the chosen variants"),p("thead",{},p("tr",{},p("th",{scope:"col"},"variant"),...r.columns.map(_=>p("th",{scope:"col",class:"right"},`${_.name} [${_.unit||"–"}]`)),p("th",{scope:"col"},""))),u)),...n?[nr(n)]:[],...n?.has_page?[sl(`/api/jobs/${n.id}/report`,"Report")]:[])}function c1(i,e){let t=s=>e.find(r=>r.name===s)?.factor??1,n=s=>e.find(r=>r.name===s)?.unit||"–";return p("div",{class:"table",tabindex:"0",role:"region","aria-label":"metrics"},p("table",{},p("thead",{},p("tr",{},p("th",{scope:"col"},"metric"),p("th",{scope:"col"},"unit"),...["mean","standard deviation","least",...Object.keys(i.metrics[0].percentiles).map(s=>`${s} %`),"greatest"].map(s=>p("th",{scope:"col",class:"right"},s)))),p("tbody",{},...i.metrics.map(s=>p("tr",{},p("th",{scope:"row"},s.name),p("td",{},n(s.name)),...[s.mean,s.standard_deviation,s.least,...Object.values(s.percentiles).map(r=>r.value),s.greatest].map(r=>p("td",{class:"right"},De(r*t(s.name)))))))))}function h1(i,e){let t=i.run,n={},{speed:s,duration:r}=t;for(let a of i.columns){let o=a.values[e];!a.is_number||o===null||o===void 0||(a.name==="trial.speed"?s=`${o/a.factor} m/s`:a.name==="trial.duration"?r=`${o/a.factor} s`:!a.name.startsWith("trial.")&&!a.name.startsWith("control.")&&(n[a.name]=o/a.factor))}return typeof t.road=="string"?It("ride",{vehicle:t.rig,road:t.road,speed:s,duration:r,set:JSON.stringify(n)}):It("trial",{rig:t.rig,road:JSON.stringify(t.road),speed:s,duration:r,set:JSON.stringify(n)})}var Y0={label:"Trial",show:d1},u1=["strut.spring.rate","strut.damper.coefficient","strut.damper.bump_coefficient","strut.damper.rebound_coefficient","tyre.stiffness","sprung.mass","unsprung.mass"];async function d1(i,e){let t=e.get("rig");if(!t){await za(i,"trial","Trial","rig",!0);return}let n=await Fs(t),s=p("select",{},...Object.keys(Dr).map(u=>p("option",{value:u},u.replace("-"," ")))),r=p("span",{class:"sizes"}),a=q0(e.get("road"));a.kind&&a.kind in Dr&&(s.value=a.kind);let o=p("input",{type:"text",value:e.get("speed")??(n.name.includes("kart")?"1.95 m/s":"30 km/h")}),l=p("input",{type:"text",value:e.get("duration")??"1.5 s"}),c=()=>r.replaceChildren(...Dr[s.value].map(u=>{let f=p("input",{type:"text",value:a[u]??Hh[u],name:u});return f.addEventListener("change",()=>{d.ask()}),He(u[0].toUpperCase()+u.slice(1),f)})),h=new Oa(n,u1,()=>{d.ask()},q0(e.get("set"))),d=new Fh(()=>qr("simulate",{rig:t,changes:h.changes,speed:o.value,duration:l.value,road:{kind:s.value,start:a.start??"0.2 m",...Object.fromEntries([...r.querySelectorAll("input")].map(u=>[u.name,u.value]))}}));s.addEventListener("change",()=>{c(),d.ask()});for(let u of[o,l])u.addEventListener("change",()=>{d.ask()});c(),Ba(d),i.replaceChildren(p("h1",{},`${t} over an obstacle`),p("div",{class:"form"},He("Obstacle",s),r,He("Speed",o),He("Duration",l)),h.element,d.element),await d.ask()}function q0(i){try{return JSON.parse(i??"{}")??{}}catch{return{}}}var hl={project:F0,rig:B0,trial:Y0,kinematics:O0,campaign:R0,studies:$0,jobs:P0};async function Z0(){let[i="",e=""]=location.hash.replace(/^#\//,"").split("?"),t=i in hl?i:"project";Ba(null);let n=p("div",{},p("p",{class:"muted"},"loading …"));document.querySelectorAll("#pages a").forEach(s=>{s.dataset.page===t?s.setAttribute("aria-current","page"):s.removeAttribute("aria-current")}),document.title=`${hl[t].label} – jounce workbench`,document.getElementById("main").replaceChildren(n);try{await hl[t].show(n,new URLSearchParams(e))}catch(s){n.replaceChildren(p("h1",{},hl[t].label),Ut(s),p("p",{},p("a",{href:It("project")},"Back to the project")))}n.isConnected&&(document.documentElement.dataset.ready=t)}document.documentElement.classList.add("live");document.getElementById("pages").append(...Object.entries(hl).map(([i,{label:e}])=>p("a",{href:It(i),"data-page":i},e)));document.querySelector("header").append(Gf());addEventListener("hashchange",()=>{delete document.documentElement.dataset.ready,Z0()});xi().then(({name:i})=>{document.getElementById("project").textContent=i},()=>{});Z0();return f_(f1);})();
