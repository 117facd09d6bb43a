"use strict";var jounce=(()=>{var pu=Object.defineProperty;var _v=Object.getOwnPropertyDescriptor;var xv=Object.getOwnPropertyNames;var yv=Object.prototype.hasOwnProperty;var bv=(i,e)=>{for(var t in e)pu(i,t,{get:e[t],enumerable:!0})},Sv=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of xv(e))!yv.call(i,s)&&s!==t&&pu(i,s,{get:()=>e[s],enumerable:!(n=_v(e,s))||n.enumerable});return i};var Mv=i=>Sv(pu({},"__esModule",{value:!0}),i);var CE={};bv(CE,{live:()=>Mf});var wv={light:"Light",dark:"Dark",showLight:"Show this page light",showDark:"Show this page dark",failed:"The interactive plots could not be made (#); the figures of this page show the same.",choice:"what is shown",previous:"previous ([)",next:"next (])",curves:"curves",channels:"channels",more:"# more",otherChannels:"all other channels",zoomIn:"zoom in (+)",zoomOut:"zoom out (−)",all:"All",everything:"everything (0, or double click)",event:"Event",zoomToEvent:"zoom to the event (9)",wide:"Full window",fillWindow:"fill the window (f)",play:"Play",pause:"Pause",speed:"speed",realTime:"real time",fast:"fast",hint:"Drag to zoom, double click for everything; Ctrl + wheel zooms, Shift + wheel pans. Keys: space plays, ← → step, + − 0 zoom, [ ] change what is shown, f fills the window.",view:"view",space:"3-D",front:"front",side:"side",top:"top",wheel:"wheel",names:"names",paths:"paths",mechanism:"The mechanism; drag to turn it, click on it to zoom with the wheel",noContact:"no contact",noWebGL:"The mechanism is drawn with WebGL, which this browser does not offer.",strut:"spring and damper",contactPoint:"contact point"},Ev={light:"Hell",dark:"Dunkel",showLight:"Seite hell darstellen",showDark:"Seite dunkel darstellen",failed:"Die interaktiven Diagramme konnten nicht erstellt werden (#); die Abbildungen der Seite zeigen dasselbe.",choice:"Auswahl",previous:"zurück ([)",next:"weiter (])",curves:"Kurven",channels:"Kanäle",more:"# weitere",otherChannels:"alle weiteren Kanäle",zoomIn:"vergrößern (+)",zoomOut:"verkleinern (−)",all:"Alles",everything:"gesamter Bereich (0 oder Doppelklick)",event:"Ereignis",zoomToEvent:"auf das Ereignis zoomen (9)",wide:"Großansicht",fillWindow:"ganzes Fenster nutzen (f)",play:"Abspielen",pause:"Pause",speed:"Tempo",realTime:"Echtzeit",fast:"schnell",hint:"Bereich aufziehen zum Zoomen, Doppelklick zeigt alles; Strg + Mausrad zoomt, Umschalt + Mausrad verschiebt. Tasten: Leertaste spielt ab, ← → Einzelschritt, + − 0 Zoom, [ ] wechselt die Auswahl, f Großansicht.",view:"Ansicht",space:"3-D",front:"vorn",side:"Seite",top:"oben",wheel:"Rad",names:"Namen",paths:"Bahnkurven",mechanism:"Die Radaufhängung; ziehen dreht sie, nach einem Klick zoomt das Mausrad",noContact:"kein Bodenkontakt",noWebGL:"Die Radaufhängung wird mit WebGL gezeichnet, das dieser Browser nicht anbietet.",strut:"Feder und Dämpfer",contactPoint:"Radaufstandspunkt"},mu=document.documentElement.lang.startsWith("de"),Tv=mu?Ev:wv;function Mt(i,e=""){return Tv[i].replace("#",()=>e)}function us(i){let e=i.replaceAll("-","−");return mu?e.replace(".",","):e}var Av={};function H(i,e=""){return(mu&&Av[i]||i).replace("#",()=>e)}function f(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))typeof r=="function"?n.addEventListener(s,r):typeof r=="boolean"?n.toggleAttribute(s,r):n.setAttribute(s,r);return n.append(...t),n}function ui(i,e,t,n=""){let s=f("button",{type:"button","aria-pressed":String(e),title:n},i);return s.addEventListener("click",()=>{let r=s.getAttribute("aria-pressed")!=="true";s.setAttribute("aria-pressed",String(r)),t(r)}),s}function Ee(i,e=4){if(i==null||Number.isNaN(i))return"–";if(!Number.isFinite(i))return i>0?"∞":"−∞";if(i===0)return"0";let[t,n]=i.toExponential(e-1).split("e"),s=Number(n),r=s<-4||s>5?`${t}e${s}`:i.toFixed(Math.max(0,e-1-s));return us(r)}function Yf(i,e){if(!Number.isFinite(i)||!(e>0))return Ee(i);let t=Math.min(Math.max(0,Math.ceil(-Math.log10(e))),100),n=Number(i.toFixed(t));return n===0?"0":Ee(n)}function yt(i){return getComputedStyle(document.documentElement).getPropertyValue(`--${i}`).trim()||"#888"}var gu=null;function Qa(){if(gu===null){let i=document.createElement("canvas").getContext("webgl2",{failIfMajorPerformanceCaveat:!0}),e=i?.getExtension("WEBGL_debug_renderer_info"),t=e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";gu=i!==null&&!/swiftshader|llvmpipe|softpipe|software|basic render/i.test(t),i?.getExtension("WEBGL_lose_context")?.loseContext()}return gu}var Zf=new Set;function $n(i){Zf.add(i)}function qf(){for(let i of Zf)i()}function Jf(){let i=matchMedia("(prefers-color-scheme: dark)"),e=document.documentElement,t=()=>e.dataset.theme?e.dataset.theme==="dark":i.matches,n=f("button",{type:"button",class:"theme"}),s=()=>{n.textContent=Mt(t()?"light":"dark"),n.title=Mt(t()?"showLight":"showDark")};return n.addEventListener("click",()=>{e.dataset.theme=t()?"light":"dark",s(),qf()}),i.addEventListener("change",()=>{s(),qf()}),s(),n}async function On(i,e,t,n="application/json"){let s=t===void 0?{}:{body:JSON.stringify(t),headers:{"Content-Type":"application/json",Accept:n}},r;try{r=await fetch(e,{method:i,...s})}catch{throw new Error("The server does not answer: start it again with jounce serve.")}if(r.ok)return r;if(r.status===401)throw new Error("This page is not known here any more: open the address that jounce serve printed.");let a=await r.json().catch(()=>null);throw new Error(a?.error?.text??a?.detail?.map(o=>`${o.loc.slice(1).join(".")}: ${o.msg}`).join("; ")??r.statusText)}var Qn=i=>new URLSearchParams(i).toString(),_n=async i=>(await On("GET",i)).json(),ei=()=>_n("/api/project"),ks=()=>_n("/api/library"),Zr=i=>_n(`/api/file?${Qn({path:i})}`),Kf=i=>_n(`/api/versions?${Qn({path:i})}`),jf=i=>_n(`/api/check?${Qn({path:i})}`),Bs=i=>_n(`/api/rig?${Qn({name:i})}`),Qf=async(i,e)=>(await On("POST","/api/library",{name:i,path:e})).json(),fr=async(i,e,t)=>(await On("PUT","/api/file",{path:i,text:e,was:t})).json(),vu=new Map;function ep(i){let e=vu.get(i);return e||(e=_n(`/api/schema?${Qn({model:i})}`),vu.set(i,e),e.catch(()=>vu.delete(i))),e}var Ki=async(i,e,t,n)=>(await On("POST","/api/form",{path:i,text:e,sets:t,changes:n})).json(),eo=async(i,e)=>(await On("POST",i,e,"application/octet-stream")).arrayBuffer(),Jr=(i,e)=>eo(`/api/${i}`,e);var ti=class i{constructor(e,t){this.content=e;this.bytes=t}content;bytes;made=[];static async open(e){let t=JSON.parse(e),n=atob(t.packed);t.packed="";let s=new Uint8Array(n.length);for(let a=0;a<n.length;a++)s[a]=n.charCodeAt(a);let r=new Blob([s]).stream().pipeThrough(new DecompressionStream("deflate"));return new i(t,new Uint8Array(await new Response(r).arrayBuffer()))}static of(e){let t=new DataView(e).getUint32(0,!0),n=4+t,s=JSON.parse(new TextDecoder().decode(new Uint8Array(e,4,t))),r=new i(s,new Uint8Array(0));s.arrays.forEach(({n:o,at:l},c)=>{let h=new Float64Array(e,n+l,o);r.made[c]=h.some(Number.isNaN)?Array.from(h,d=>Number.isNaN(d)?null:d):h});let a=o=>{let l=new Float64Array(e,n+s.arrays[o].at,s.arrays[o].n);return Array.from({length:l.length/3},(c,h)=>l.subarray(3*h,3*h+3))};for(let o of s.mechanisms){let{points:l,spin:c,contact:h}=o;Object.assign(o,{points:l.map(a),spin:a(c),contact:a(h)})}return r}step(e){let{even:t,step:n}=this.content.arrays[e];return t?0:n||this.finest(e)}finest(e){let t=this.get(e),n=1/0,s=-1/0;for(let r=0;r<t.length;r++){let a=t[r];a!=null&&(a<n&&(n=a),a>s&&(s=a))}return s>n?(s-n)*1e-7:0}get(e){return this.made[e]??=Cv(this.content.arrays[e],this.bytes)}},tp=65535;function Cv(i,e){let{n:t,at:n,order:s,low:r,step:a,even:o}=i;if(o)return Float64Array.from({length:t},(u,p)=>o[0]+p*o[1]);let l=new Float64Array(t),c=0,h=0,d=!1;for(let u=0;u<t;u++){let p=e[n+u]|e[n+t+u]<<8;if(s===0)c=p;else{let g=p>>>1^-(p&1);s===1?c=c+g&65535:(h=h+g&65535,c=c+h&65535)}c===tp&&(d=!0),l[u]=c===tp?NaN:r+a*c}return d?Array.from(l,u=>Number.isNaN(u)?null:u):l}function wi(i,e,t){let n=i.length;if(n===0)return NaN;let s=Sl(i,t),r=Math.min(s+1,n-1),a=i[s],o=i[r],l=e[s],c=e[r];if(l===null||c===null||l===void 0||c===void 0)return NaN;let h=o>a?Math.min(1,Math.max(0,(t-a)/(o-a))):0;return l+h*(c-l)}function Sl(i,e){let t=0,n=i.length-1;for(;n>t;){let s=t+n+1>>1;i[s]<=e?t=s:n=s-1}return t}var Ks={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},js={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Dp=0,Zu=1,Np=2;var Fo=1,Up=2,ba=3,Qs=0,Kn=1,si=2,Sr=0,Sa=1,Ju=2,Ku=3,ju=4,Op=5;var Mr=100,Fp=101,kp=102,Bp=103,zp=104,Vp=200,Gp=201,Hp=202,Wp=203,Qu=204,ed=205,Xp=206,$p=207,qp=208,Yp=209,Zp=210,Jp=211,Kp=212,jp=213,Qp=214,ql=0,Yl=1,Zl=2,ua=3,Jl=4,Kl=5,jl=6,Ql=7,Dc=0,em=1,tm=2,ns=0,td=1,nd=2,id=3,sd=4,rd=5,ad=6,od=7;var ld=300,wr=301,Ma=302,Nc=303,Uc=304,ec=1e3,es=1001,tc=1002,In=1003,nm=1004;var ko=1005;var Yn=1006,Oc=1007;var Es=1008;var ri=1009,cd=1010,hd=1011,wa=1012,Fc=1013,Fi=1014,ki=1015,Bi=1016,kc=1017,Bc=1018,Er=1020,ud=35902,dd=35899,fd=1021,pd=1022,zi=1023,_s=1026,Ts=1027,md=1028,zc=1029,er=1030,Vc=1031;var Gc=1033,Bo=33776,zo=33777,Vo=33778,Go=33779,Hc=35840,Wc=35841,Xc=35842,$c=35843,qc=36196,Yc=37492,Zc=37496,Jc=37488,Kc=37489,Ho=37490,jc=37491,Qc=37808,eh=37809,th=37810,nh=37811,ih=37812,sh=37813,rh=37814,ah=37815,oh=37816,lh=37817,ch=37818,hh=37819,uh=37820,dh=37821,fh=36492,ph=36494,mh=36495,gh=36283,vh=36284,Wo=36285,_h=36286;var uo=2300,nc=2301,Xl=2302,Gu=2303,Hu=2400,Wu=2401,Xu=2402;var im=3200;var xh=0,sm=1,As="",pi="srgb",fo="srgb-linear",po="linear",Nt="srgb";var $l=7680;var rm=519,am=512,om=513,lm=514,gd=515,cm=516,hm=517,vd=518,_d=519,um=35044;var xd="300 es",Ti=2e3,da=2001;function Rv(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Pv(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function mo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function dm(){let i=mo("canvas");return i.style.display="block",i}var np={},fa=null;function yd(...i){let e="THREE."+i.shift();fa?fa("log",e,...i):console.log(e,...i)}function fm(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ke(...i){i=fm(i);let e="THREE."+i.shift();if(fa)fa("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function ot(...i){i=fm(i);let e="THREE."+i.shift();if(fa)fa("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function ao(...i){let e=i.join(" ");e in np||(np[e]=!0,Ke(...i))}function pm(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var mm={[ql]:ql,[Zl]:jl,[Jl]:Jl,[ua]:Kl,[Yl]:Yl,[jl]:Zl,[Ql]:Ql,[Kl]:ua},Oi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},Fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ip=1234567,oo=Math.PI/180,pa=180/Math.PI;function Ea(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Fn[i&255]+Fn[i>>8&255]+Fn[i>>16&255]+Fn[i>>24&255]+"-"+Fn[e&255]+Fn[e>>8&255]+"-"+Fn[e>>16&15|64]+Fn[e>>24&255]+"-"+Fn[t&63|128]+Fn[t>>8&255]+"-"+Fn[t>>16&255]+Fn[t>>24&255]+Fn[n&255]+Fn[n>>8&255]+Fn[n>>16&255]+Fn[n>>24&255]).toLowerCase()}function gt(i,e,t){return Math.max(e,Math.min(t,i))}function bd(i,e){return(i%e+e)%e}function Lv(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function Iv(i,e,t){return i!==e?(t-i)/(e-i):0}function lo(i,e,t){return(1-t)*i+t*e}function Dv(i,e,t,n){return lo(i,e,1-Math.exp(-t*n))}function Nv(i,e=1){return e-Math.abs(bd(i,e*2)-e)}function Uv(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Ov(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Fv(i,e){return i+Math.floor(Math.random()*(e-i+1))}function kv(i,e){return i+Math.random()*(e-i)}function Bv(i){return i*(.5-Math.random())}function zv(i){i!==void 0&&(ip=i);let e=ip+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Vv(i){return i*oo}function Gv(i){return i*pa}function Hv(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Wv(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Sd(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Xv(i,e,t,n,s){let r=Math.cos,a=Math.sin,o=r(t/2),l=a(t/2),c=r((e+n)/2),h=a((e+n)/2),d=r((e-n)/2),u=a((e-n)/2),p=r((n-e)/2),g=a((n-e)/2);switch(s){case"XYX":i.set(o*h,l*d,l*u,o*c);break;case"YZY":i.set(l*u,o*h,l*d,o*c);break;case"ZXZ":i.set(l*d,l*u,o*h,o*c);break;case"XZX":i.set(o*h,l*g,l*p,o*c);break;case"YXY":i.set(l*p,o*h,l*g,o*c);break;case"ZYZ":i.set(l*g,l*p,o*h,o*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Md(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function gm(i,e){if(e.constructor===Float32Array)return i;let t=Md(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function vm(i,e){if(e.constructor===Float32Array)return i;let t=Md(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var wd={DEG2RAD:oo,RAD2DEG:pa,generateUUID:Ea,clamp:gt,euclideanModulo:bd,mapLinear:Lv,inverseLerp:Iv,lerp:lo,damp:Dv,pingpong:Nv,smoothstep:Uv,smootherstep:Ov,randInt:Fv,randFloat:kv,randFloatSpread:Bv,seededRandom:zv,degToRad:Vv,radToDeg:Gv,isPowerOfTwo:Hv,ceilPowerOfTwo:Wv,floorPowerOfTwo:Sd,setQuaternionFromProperEuler:Xv,normalize:vm,denormalize:gm},Ve=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(gt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*n-a*s+e.x,this.y=r*s+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Zn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,a,o){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[a+0],p=r[a+1],g=r[a+2],_=r[a+3];if(d!==_||l!==u||c!==p||h!==g){let m=l*u+c*p+h*g+d*_;m<0&&(u=-u,p=-p,g=-g,_=-_,m=-m);let v=1-o;if(m<.9995){let x=Math.acos(m),E=Math.sin(x);v=Math.sin(v*x)/E,o=Math.sin(o*x)/E,l=l*v+u*o,c=c*v+p*o,h=h*v+g*o,d=d*v+_*o}else{l=l*v+u*o,c=c*v+p*o,h=h*v+g*o,d=d*v+_*o;let x=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=x,c*=x,h*=x,d*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,a){let o=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[a],u=r[a+1],p=r[a+2],g=r[a+3];return e[t]=o*g+h*d+l*p-c*u,e[t+1]=l*g+h*u+c*d-o*p,e[t+2]=c*g+h*p+o*u-l*d,e[t+3]=h*g-o*d-l*u-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(s/2),d=o(r/2),u=l(n/2),p=l(s/2),g=l(r/2);switch(a){case"XYZ":this._x=u*h*d+c*p*g,this._y=c*p*d-u*h*g,this._z=c*h*g+u*p*d,this._w=c*h*d-u*p*g;break;case"YXZ":this._x=u*h*d+c*p*g,this._y=c*p*d-u*h*g,this._z=c*h*g-u*p*d,this._w=c*h*d+u*p*g;break;case"ZXY":this._x=u*h*d-c*p*g,this._y=c*p*d+u*h*g,this._z=c*h*g+u*p*d,this._w=c*h*d-u*p*g;break;case"ZYX":this._x=u*h*d-c*p*g,this._y=c*p*d+u*h*g,this._z=c*h*g-u*p*d,this._w=c*h*d+u*p*g;break;case"YZX":this._x=u*h*d+c*p*g,this._y=c*p*d+u*h*g,this._z=c*h*g-u*p*d,this._w=c*h*d-u*p*g;break;case"XZY":this._x=u*h*d-c*p*g,this._y=c*p*d-u*h*g,this._z=c*h*g+u*p*d,this._w=c*h*d+u*p*g;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=n+o+d;if(u>0){let p=.5/Math.sqrt(u+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(a-s)*p}else if(n>o&&n>d){let p=2*Math.sqrt(1+n-o-d);this._w=(h-l)/p,this._x=.25*p,this._y=(s+a)/p,this._z=(r+c)/p}else if(o>d){let p=2*Math.sqrt(1+o-n-d);this._w=(r-c)/p,this._x=(s+a)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+d-n-o);this._w=(a-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(gt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-n*c,this._z=r*h+a*c+n*l-s*o,this._w=a*h-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(sp.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(sp.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*n),h=2*(o*t-r*s),d=2*(r*n-a*t);return this.x=t+l*c+a*d-o*h,this.y=n+l*h+o*c-r*d,this.z=s+l*d+r*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return _u.copy(this).projectOnVector(e),this.sub(_u)}reflect(e){return this.sub(_u.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(gt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},_u=new V,sp=new Zn,ct=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c)}set(e,t,n,s,r,a,o,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=o,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],p=n[5],g=n[8],_=s[0],m=s[3],v=s[6],x=s[1],E=s[4],S=s[7],R=s[2],w=s[5],y=s[8];return r[0]=a*_+o*x+l*R,r[3]=a*m+o*E+l*w,r[6]=a*v+o*S+l*y,r[1]=c*_+h*x+d*R,r[4]=c*m+h*E+d*w,r[7]=c*v+h*S+d*y,r[2]=u*_+p*x+g*R,r[5]=u*m+p*E+g*w,r[8]=u*v+p*S+g*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-n*r*h+n*o*l+s*r*c-s*a*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=h*a-o*c,u=o*l-h*r,p=c*r-a*l,g=t*d+n*u+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return e[0]=d*_,e[1]=(s*c-h*n)*_,e[2]=(o*n-s*a)*_,e[3]=u*_,e[4]=(h*t-s*l)*_,e[5]=(s*r-o*t)*_,e[6]=p*_,e[7]=(n*l-c*t)*_,e[8]=(a*t-n*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return ao("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(xu.makeScale(e,t)),this}rotate(e){return ao("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(xu.makeRotation(-e)),this}translate(e,t){return ao("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(xu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},xu=new ct,rp=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ap=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function $v(){let i={enabled:!0,workingColorSpace:fo,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Nt&&(s.r=vs(s.r),s.g=vs(s.g),s.b=vs(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Nt&&(s.r=ha(s.r),s.g=ha(s.g),s.b=ha(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===As?po:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[fo]:{primaries:e,whitePoint:n,transfer:po,toXYZ:rp,fromXYZ:ap,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:pi},outputColorSpaceConfig:{drawingBufferColorSpace:pi}},[pi]:{primaries:e,whitePoint:n,transfer:Nt,toXYZ:rp,fromXYZ:ap,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:pi}}}),i}var wt=$v();function vs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ha(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Kr,ic=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Kr===void 0&&(Kr=mo("canvas")),Kr.width=e.width,Kr.height=e.height;let s=Kr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Kr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=mo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=vs(r[a]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(vs(t[n]/255)*255):t[n]=vs(t[n]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},qv=0,ma=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:qv++}),this.uuid=Ea(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(yu(s[a].image)):r.push(yu(s[a]))}else r=yu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function yu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ic.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var Yv=0,bu=new V,ii=class i extends Oi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=es,s=es,r=Yn,a=Es,o=zi,l=ri,c=i.DEFAULT_ANISOTROPY,h=As){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Yv++}),this.uuid=Ea(),this.name="",this.source=new ma(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new Ve(0,0),this.repeat=new Ve(1,1),this.center=new Ve(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(bu).x}get height(){return this.source.getSize(bu).y}get depth(){return this.source.getSize(bu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ld)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ec:e.x=e.x-Math.floor(e.x);break;case es:e.x=e.x<0?0:1;break;case tc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ec:e.y=e.y-Math.floor(e.y);break;case es:e.y=e.y<0?0:1;break;case tc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ii.DEFAULT_IMAGE=null;ii.DEFAULT_MAPPING=ld;ii.DEFAULT_ANISOTROPY=1;var tn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*n+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],p=l[5],g=l[9],_=l[2],m=l[6],v=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-_)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+_)<.1&&Math.abs(g+m)<.1&&Math.abs(c+p+v-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,S=(p+1)/2,R=(v+1)/2,w=(h+u)/4,y=(d+_)/4,A=(g+m)/4;return E>S&&E>R?E<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(E),s=w/n,r=y/n):S>R?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=w/s,r=A/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=y/r,s=A/r),this.set(n,s,r,t),this}let x=Math.sqrt((m-g)*(m-g)+(d-_)*(d-_)+(u-h)*(u-h));return Math.abs(x)<.001&&(x=1),this.x=(m-g)/x,this.y=(d-_)/x,this.z=(u-h)/x,this.w=Math.acos((c+p+v-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this.w=gt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this.w=gt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(gt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},sc=class extends Oi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Yn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new tn(0,0,e,t),this.scissorTest=!1,this.viewport=new tn(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ii({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Yn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ma(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},vi=class extends sc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},go=class extends ii{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var rc=class extends ii{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Xt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,a,o,l,c,h,d,u,p,g,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c,h,d,u,p,g,_,m)}set(e,t,n,s,r,a,o,l,c,h,d,u,p,g,_,m){let v=this.elements;return v[0]=e,v[4]=t,v[8]=n,v[12]=s,v[1]=r,v[5]=a,v[9]=o,v[13]=l,v[2]=c,v[6]=h,v[10]=d,v[14]=u,v[3]=p,v[7]=g,v[11]=_,v[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/jr.setFromMatrixColumn(e,0).length(),r=1/jr.setFromMatrixColumn(e,1).length(),a=1/jr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let u=a*h,p=a*d,g=o*h,_=o*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=p+g*c,t[5]=u-_*c,t[9]=-o*l,t[2]=_-u*c,t[6]=g+p*c,t[10]=a*l}else if(e.order==="YXZ"){let u=l*h,p=l*d,g=c*h,_=c*d;t[0]=u+_*o,t[4]=g*o-p,t[8]=a*c,t[1]=a*d,t[5]=a*h,t[9]=-o,t[2]=p*o-g,t[6]=_+u*o,t[10]=a*l}else if(e.order==="ZXY"){let u=l*h,p=l*d,g=c*h,_=c*d;t[0]=u-_*o,t[4]=-a*d,t[8]=g+p*o,t[1]=p+g*o,t[5]=a*h,t[9]=_-u*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let u=a*h,p=a*d,g=o*h,_=o*d;t[0]=l*h,t[4]=g*c-p,t[8]=u*c+_,t[1]=l*d,t[5]=_*c+u,t[9]=p*c-g,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let u=a*l,p=a*c,g=o*l,_=o*c;t[0]=l*h,t[4]=_-u*d,t[8]=g*d+p,t[1]=d,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=p*d+g,t[10]=u-_*d}else if(e.order==="XZY"){let u=a*l,p=a*c,g=o*l,_=o*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+_,t[5]=a*h,t[9]=p*d-g,t[2]=g*d-p,t[6]=o*h,t[10]=_*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Zv,e,Jv)}lookAt(e,t,n){let s=this.elements;return di.subVectors(e,t),di.lengthSq()===0&&(di.z=1),di.normalize(),zs.crossVectors(n,di),zs.lengthSq()===0&&(Math.abs(n.z)===1?di.x+=1e-4:di.z+=1e-4,di.normalize(),zs.crossVectors(n,di)),zs.normalize(),Ml.crossVectors(di,zs),s[0]=zs.x,s[4]=Ml.x,s[8]=di.x,s[1]=zs.y,s[5]=Ml.y,s[9]=di.y,s[2]=zs.z,s[6]=Ml.z,s[10]=di.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],p=n[13],g=n[2],_=n[6],m=n[10],v=n[14],x=n[3],E=n[7],S=n[11],R=n[15],w=s[0],y=s[4],A=s[8],k=s[12],U=s[1],D=s[5],L=s[9],F=s[13],P=s[2],G=s[6],Y=s[10],X=s[14],he=s[3],J=s[7],ee=s[11],ne=s[15];return r[0]=a*w+o*U+l*P+c*he,r[4]=a*y+o*D+l*G+c*J,r[8]=a*A+o*L+l*Y+c*ee,r[12]=a*k+o*F+l*X+c*ne,r[1]=h*w+d*U+u*P+p*he,r[5]=h*y+d*D+u*G+p*J,r[9]=h*A+d*L+u*Y+p*ee,r[13]=h*k+d*F+u*X+p*ne,r[2]=g*w+_*U+m*P+v*he,r[6]=g*y+_*D+m*G+v*J,r[10]=g*A+_*L+m*Y+v*ee,r[14]=g*k+_*F+m*X+v*ne,r[3]=x*w+E*U+S*P+R*he,r[7]=x*y+E*D+S*G+R*J,r[11]=x*A+E*L+S*Y+R*ee,r[15]=x*k+E*F+S*X+R*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],p=e[14],g=e[3],_=e[7],m=e[11],v=e[15],x=l*p-c*u,E=o*p-c*d,S=o*u-l*d,R=a*p-c*h,w=a*u-l*h,y=a*d-o*h;return t*(_*x-m*E+v*S)-n*(g*x-m*R+v*w)+s*(g*E-_*R+v*y)-r*(g*S-_*w+m*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],h=e[10];return t*(a*h-o*c)-n*(r*h-o*l)+s*(r*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],p=e[11],g=e[12],_=e[13],m=e[14],v=e[15],x=t*o-n*a,E=t*l-s*a,S=t*c-r*a,R=n*l-s*o,w=n*c-r*o,y=s*c-r*l,A=h*_-d*g,k=h*m-u*g,U=h*v-p*g,D=d*m-u*_,L=d*v-p*_,F=u*v-p*m,P=x*F-E*L+S*D+R*U-w*k+y*A;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/P;return e[0]=(o*F-l*L+c*D)*G,e[1]=(s*L-n*F-r*D)*G,e[2]=(_*y-m*w+v*R)*G,e[3]=(u*w-d*y-p*R)*G,e[4]=(l*U-a*F-c*k)*G,e[5]=(t*F-s*U+r*k)*G,e[6]=(m*S-g*y-v*E)*G,e[7]=(h*y-u*S+p*E)*G,e[8]=(a*L-o*U+c*A)*G,e[9]=(n*U-t*L-r*A)*G,e[10]=(g*w-_*S+v*x)*G,e[11]=(d*S-h*w-p*x)*G,e[12]=(o*k-a*D-l*A)*G,e[13]=(t*D-n*k+s*A)*G,e[14]=(_*E-g*R-m*x)*G,e[15]=(h*R-d*E+u*x)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,a=e.x,o=e.y,l=e.z,c=r*a,h=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+n,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,a){return this.set(1,n,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,h=a+a,d=o+o,u=r*c,p=r*h,g=r*d,_=a*h,m=a*d,v=o*d,x=l*c,E=l*h,S=l*d,R=n.x,w=n.y,y=n.z;return s[0]=(1-(_+v))*R,s[1]=(p+S)*R,s[2]=(g-E)*R,s[3]=0,s[4]=(p-S)*w,s[5]=(1-(u+v))*w,s[6]=(m+x)*w,s[7]=0,s[8]=(g+E)*y,s[9]=(m-x)*y,s[10]=(1-(u+_))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let a=jr.set(s[0],s[1],s[2]).length(),o=jr.set(s[4],s[5],s[6]).length(),l=jr.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Di.copy(this);let c=1/a,h=1/o,d=1/l;return Di.elements[0]*=c,Di.elements[1]*=c,Di.elements[2]*=c,Di.elements[4]*=h,Di.elements[5]*=h,Di.elements[6]*=h,Di.elements[8]*=d,Di.elements[9]*=d,Di.elements[10]*=d,t.setFromRotationMatrix(Di),n.x=a,n.y=o,n.z=l,this}makePerspective(e,t,n,s,r,a,o=Ti,l=!1){let c=this.elements,h=2*r/(t-e),d=2*r/(n-s),u=(t+e)/(t-e),p=(n+s)/(n-s),g,_;if(l)g=r/(a-r),_=a*r/(a-r);else if(o===Ti)g=-(a+r)/(a-r),_=-2*a*r/(a-r);else if(o===da)g=-a/(a-r),_=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,a,o=Ti,l=!1){let c=this.elements,h=2/(t-e),d=2/(n-s),u=-(t+e)/(t-e),p=-(n+s)/(n-s),g,_;if(l)g=1/(a-r),_=a/(a-r);else if(o===Ti)g=-2/(a-r),_=-(a+r)/(a-r);else if(o===da)g=-1/(a-r),_=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},jr=new V,Di=new Xt,Zv=new V(0,0,0),Jv=new V(1,1,1),zs=new V,Ml=new V,di=new V,op=new Xt,lp=new Zn,xs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(gt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-gt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(gt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-gt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(gt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(o,p));break;case"XZY":this._z=Math.asin(-gt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return op.makeRotationFromQuaternion(e),this.setFromRotationMatrix(op,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return lp.setFromEuler(this),this.setFromQuaternion(lp,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};xs.DEFAULT_ORDER="XYZ";var vo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Kv=0,cp=new V,Qr=new Zn,ds=new Xt,wl=new V,to=new V,jv=new V,Qv=new Zn,hp=new V(1,0,0),up=new V(0,1,0),dp=new V(0,0,1),fp={type:"added"},e_={type:"removed"},ea={type:"childadded",child:null},Su={type:"childremoved",child:null},Bn=class i extends Oi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Kv++}),this.uuid=Ea(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new V,t=new xs,n=new Zn,s=new V(1,1,1);function r(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Xt},normalMatrix:{value:new ct}}),this.matrix=new Xt,this.matrixWorld=new Xt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new vo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Qr.setFromAxisAngle(e,t),this.quaternion.multiply(Qr),this}rotateOnWorldAxis(e,t){return Qr.setFromAxisAngle(e,t),this.quaternion.premultiply(Qr),this}rotateX(e){return this.rotateOnAxis(hp,e)}rotateY(e){return this.rotateOnAxis(up,e)}rotateZ(e){return this.rotateOnAxis(dp,e)}translateOnAxis(e,t){return cp.copy(e).applyQuaternion(this.quaternion),this.position.add(cp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(hp,e)}translateY(e){return this.translateOnAxis(up,e)}translateZ(e){return this.translateOnAxis(dp,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ds.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?wl.copy(e):wl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),to.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ds.lookAt(to,wl,this.up):ds.lookAt(wl,to,this.up),this.quaternion.setFromRotationMatrix(ds),s&&(ds.extractRotation(s.matrixWorld),Qr.setFromRotationMatrix(ds),this.quaternion.premultiply(Qr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ot("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(fp),ea.child=e,this.dispatchEvent(ea),ea.child=null):ot("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(e_),Su.child=e,this.dispatchEvent(Su),Su.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ds.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ds.multiply(e.parent.matrixWorld)),e.applyMatrix4(ds),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(fp),ea.child=e,this.dispatchEvent(ea),ea.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(to,e,jv),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(to,Qv,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),d=a(e.shapes),u=a(e.skeletons),p=a(e.animations),g=a(e.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),p.length>0&&(n.animations=p),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Bn.DEFAULT_UP=new V(0,1,0);Bn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Bn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var qn=class extends Bn{constructor(){super(),this.isGroup=!0,this.type="Group"}},t_={type:"move"},ga=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new qn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new qn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new qn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let _ of e.hand.values()){let m=t.getJointPose(_,n),v=this._getHandJoint(c,_);m!==null&&(v.matrix.fromArray(m.transform.matrix),v.matrix.decompose(v.position,v.quaternion,v.scale),v.matrixWorldNeedsUpdate=!0,v.jointRadius=m.radius),v.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),p=.02,g=.005;c.inputState.pinching&&u>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(t_)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new qn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},_m={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vs={h:0,s:0,l:0},El={h:0,s:0,l:0};function Mu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var je=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=pi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,wt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=wt.workingColorSpace){return this.r=e,this.g=t,this.b=n,wt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=wt.workingColorSpace){if(e=bd(e,1),t=gt(t,0,1),n=gt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,a=2*n-r;this.r=Mu(a,r,e+1/3),this.g=Mu(a,r,e),this.b=Mu(a,r,e-1/3)}return wt.colorSpaceToWorking(this,s),this}setStyle(e,t=pi){function n(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=pi){let n=_m[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=vs(e.r),this.g=vs(e.g),this.b=vs(e.b),this}copyLinearToSRGB(e){return this.r=ha(e.r),this.g=ha(e.g),this.b=ha(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=pi){return wt.workingToColorSpace(kn.copy(this),e),Math.round(gt(kn.r*255,0,255))*65536+Math.round(gt(kn.g*255,0,255))*256+Math.round(gt(kn.b*255,0,255))}getHexString(e=pi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=wt.workingColorSpace){wt.workingToColorSpace(kn.copy(this),t);let n=kn.r,s=kn.g,r=kn.b,a=Math.max(n,s,r),o=Math.min(n,s,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let d=a-o;switch(c=h<=.5?d/(a+o):d/(2-a-o),a){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=wt.workingColorSpace){return wt.workingToColorSpace(kn.copy(this),t),e.r=kn.r,e.g=kn.g,e.b=kn.b,e}getStyle(e=pi){wt.workingToColorSpace(kn.copy(this),e);let t=kn.r,n=kn.g,s=kn.b;return e!==pi?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Vs),this.setHSL(Vs.h+e,Vs.s+t,Vs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Vs),e.getHSL(El);let n=lo(Vs.h,El.h,t),s=lo(Vs.s,El.s,t),r=lo(Vs.l,El.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new je;je.NAMES=_m;var _o=class extends Bn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new xs,this.environmentIntensity=1,this.environmentRotation=new xs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ni=new V,fs=new V,wu=new V,ps=new V,ta=new V,na=new V,pp=new V,Eu=new V,Tu=new V,Au=new V,Cu=new tn,Ru=new tn,Pu=new tn,Xs=class i{constructor(e=new V,t=new V,n=new V){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ni.subVectors(e,t),s.cross(Ni);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ni.subVectors(s,t),fs.subVectors(n,t),wu.subVectors(e,t);let a=Ni.dot(Ni),o=Ni.dot(fs),l=Ni.dot(wu),c=fs.dot(fs),h=fs.dot(wu),d=a*c-o*o;if(d===0)return r.set(0,0,0),null;let u=1/d,p=(c*l-o*h)*u,g=(a*h-o*l)*u;return r.set(1-p-g,g,p)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ps)===null?!1:ps.x>=0&&ps.y>=0&&ps.x+ps.y<=1}static getInterpolation(e,t,n,s,r,a,o,l){return this.getBarycoord(e,t,n,s,ps)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ps.x),l.addScaledVector(a,ps.y),l.addScaledVector(o,ps.z),l)}static getInterpolatedAttribute(e,t,n,s,r,a){return Cu.setScalar(0),Ru.setScalar(0),Pu.setScalar(0),Cu.fromBufferAttribute(e,t),Ru.fromBufferAttribute(e,n),Pu.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Cu,r.x),a.addScaledVector(Ru,r.y),a.addScaledVector(Pu,r.z),a}static isFrontFacing(e,t,n,s){return Ni.subVectors(n,t),fs.subVectors(e,t),Ni.cross(fs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ni.subVectors(this.c,this.b),fs.subVectors(this.a,this.b),Ni.cross(fs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,a,o;ta.subVectors(s,n),na.subVectors(r,n),Eu.subVectors(e,n);let l=ta.dot(Eu),c=na.dot(Eu);if(l<=0&&c<=0)return t.copy(n);Tu.subVectors(e,s);let h=ta.dot(Tu),d=na.dot(Tu);if(h>=0&&d<=h)return t.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),t.copy(n).addScaledVector(ta,a);Au.subVectors(e,r);let p=ta.dot(Au),g=na.dot(Au);if(g>=0&&p<=g)return t.copy(r);let _=p*c-l*g;if(_<=0&&c>=0&&g<=0)return o=c/(c-g),t.copy(n).addScaledVector(na,o);let m=h*g-p*d;if(m<=0&&d-h>=0&&p-g>=0)return pp.subVectors(r,s),o=(d-h)/(d-h+(p-g)),t.copy(s).addScaledVector(pp,o);let v=1/(m+_+u);return a=_*v,o=u*v,t.copy(n).addScaledVector(ta,a).addScaledVector(na,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},$s=class{constructor(e=new V(1/0,1/0,1/0),t=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ui.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ui.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ui.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,Ui):Ui.fromBufferAttribute(r,a),Ui.applyMatrix4(e.matrixWorld),this.expandByPoint(Ui);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Tl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Tl.copy(n.boundingBox)),Tl.applyMatrix4(e.matrixWorld),this.union(Tl)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ui),Ui.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(no),Al.subVectors(this.max,no),ia.subVectors(e.a,no),sa.subVectors(e.b,no),ra.subVectors(e.c,no),Gs.subVectors(sa,ia),Hs.subVectors(ra,sa),pr.subVectors(ia,ra);let t=[0,-Gs.z,Gs.y,0,-Hs.z,Hs.y,0,-pr.z,pr.y,Gs.z,0,-Gs.x,Hs.z,0,-Hs.x,pr.z,0,-pr.x,-Gs.y,Gs.x,0,-Hs.y,Hs.x,0,-pr.y,pr.x,0];return!Lu(t,ia,sa,ra,Al)||(t=[1,0,0,0,1,0,0,0,1],!Lu(t,ia,sa,ra,Al))?!1:(Cl.crossVectors(Gs,Hs),t=[Cl.x,Cl.y,Cl.z],Lu(t,ia,sa,ra,Al))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ui).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ui).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ms[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ms[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ms[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ms[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ms[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ms[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ms[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ms[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ms),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ms=[new V,new V,new V,new V,new V,new V,new V,new V],Ui=new V,Tl=new $s,ia=new V,sa=new V,ra=new V,Gs=new V,Hs=new V,pr=new V,no=new V,Al=new V,Cl=new V,mr=new V;function Lu(i,e,t,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){mr.fromArray(i,r);let o=s.x*Math.abs(mr.x)+s.y*Math.abs(mr.y)+s.z*Math.abs(mr.z),l=e.dot(mr),c=t.dot(mr),h=n.dot(mr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var xn=new V,Rl=new Ve,n_=0,ni=class extends Oi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:n_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=um,this.updateRanges=[],this.gpuType=ki,this.version=0,this._normalizationScale=e!==void 0?Md(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Rl.fromBufferAttribute(this,t),Rl.applyMatrix3(e),this.setXY(t,Rl.x,Rl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):gm(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):vm(e,this.array)}};var xo=class extends ni{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var yo=class extends ni{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var $t=class extends ni{constructor(e,t,n){super(new Float32Array(e),t,n)}},i_=new $s,io=new V,Iu=new V,_r=class{constructor(e=new V,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):i_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;io.subVectors(e,this.center);let t=io.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(io,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Iu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(io.copy(e.center).add(Iu)),this.expandByPoint(io.copy(e.center).sub(Iu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},s_=0,Ei=new Xt,Du=new Bn,aa=new V,fi=new $s,so=new $s,Ln=new V,un=class i extends Oi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:s_++}),this.uuid=Ea(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Rv(e)?yo:xo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ct().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ei.makeRotationFromQuaternion(e),this.applyMatrix4(Ei),this}rotateX(e){return Ei.makeRotationX(e),this.applyMatrix4(Ei),this}rotateY(e){return Ei.makeRotationY(e),this.applyMatrix4(Ei),this}rotateZ(e){return Ei.makeRotationZ(e),this.applyMatrix4(Ei),this}translate(e,t,n){return Ei.makeTranslation(e,t,n),this.applyMatrix4(Ei),this}scale(e,t,n){return Ei.makeScale(e,t,n),this.applyMatrix4(Ei),this}lookAt(e){return Du.lookAt(e),Du.updateMatrix(),this.applyMatrix4(Du.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(aa).negate(),this.translate(aa.x,aa.y,aa.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new $t(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new $s);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ot("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Ln.addVectors(this.boundingBox.min,fi.min),this.boundingBox.expandByPoint(Ln),Ln.addVectors(this.boundingBox.max,fi.max),this.boundingBox.expandByPoint(Ln)):(this.boundingBox.expandByPoint(fi.min),this.boundingBox.expandByPoint(fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ot('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new _r);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ot("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(e){let n=this.boundingSphere.center;if(fi.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];so.setFromBufferAttribute(o),this.morphTargetsRelative?(Ln.addVectors(fi.min,so.min),fi.expandByPoint(Ln),Ln.addVectors(fi.max,so.max),fi.expandByPoint(Ln)):(fi.expandByPoint(so.min),fi.expandByPoint(so.max))}fi.getCenter(n);let s=0;for(let r=0,a=e.count;r<a;r++)Ln.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Ln));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)Ln.fromBufferAttribute(o,c),l&&(aa.fromBufferAttribute(e,c),Ln.add(aa)),s=Math.max(s,n.distanceToSquared(Ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ot('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ot("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new ni(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)o[k]=new V,l[k]=new V;let h=new V,d=new V,u=new V,p=new Ve,g=new Ve,_=new Ve,m=new V,v=new V;function x(k,U,D){c[k]=c[U]=c[D]=1,h.fromBufferAttribute(n,k),d.fromBufferAttribute(n,U),u.fromBufferAttribute(n,D),p.fromBufferAttribute(r,k),g.fromBufferAttribute(r,U),_.fromBufferAttribute(r,D),d.sub(h),u.sub(h),g.sub(p),_.sub(p);let L=1/(g.x*_.y-_.x*g.y);isFinite(L)&&(m.copy(d).multiplyScalar(_.y).addScaledVector(u,-g.y).multiplyScalar(L),v.copy(u).multiplyScalar(g.x).addScaledVector(d,-_.x).multiplyScalar(L),o[k].add(m),o[U].add(m),o[D].add(m),l[k].add(v),l[U].add(v),l[D].add(v))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let k=0,U=E.length;k<U;++k){let D=E[k],L=D.start,F=D.count;for(let P=L,G=L+F;P<G;P+=3)x(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let S=new V,R=new V,w=new V,y=new V;function A(k){w.fromBufferAttribute(s,k),y.copy(w);let U=o[k];S.copy(U),S.sub(w.multiplyScalar(w.dot(U))).normalize(),R.crossVectors(y,U);let L=R.dot(l[k])<0?-1:1;a.setXYZW(k,S.x,S.y,S.z,L)}for(let k=0,U=n.count;k<U;++k)c[k]&&A(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new ni(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,p=n.count;u<p;u++)n.setXYZ(u,0,0,0);let s=new V,r=new V,a=new V,o=new V,l=new V,c=new V,h=new V,d=new V;if(e)for(let u=0,p=e.count;u<p;u+=3){let g=e.getX(u+0),_=e.getX(u+1),m=e.getX(u+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,_),a.fromBufferAttribute(t,m),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),o.fromBufferAttribute(n,g),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,m),o.add(h),l.add(h),c.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,p=t.count;u<p;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),a.fromBufferAttribute(t,u+2),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Ln.fromBufferAttribute(e,t),Ln.normalize(),e.setXYZ(t,Ln.x,Ln.y,Ln.z)}toNonIndexed(){function e(o,l){let c=o.array,h=o.itemSize,d=o.normalized,u=new c.constructor(l.length*h),p=0,g=0;for(let _=0,m=l.length;_<m;_++){o.isInterleavedBufferAttribute?p=l[_]*o.data.stride+o.offset:p=l[_]*h;for(let v=0;v<h;v++)u[g++]=c[p++]}return new ni(u,h,d)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=e(l,n);t.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,d=c.length;h<d;h++){let u=c[h],p=e(u,n);l.push(p)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let p=c[d];h.push(p.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,p=d.length;u<p;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,h=a.length;c<h;c++){let d=a[c];this.addGroup(d.start,d.count,d.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Nu=new V,r_=new V,a_=new ct,mi=class{constructor(e=new V(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Nu.subVectors(n,t).cross(r_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Nu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||a_.getNormalMatrix(e),s=this.coplanarPoint(Nu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},o_=0,ys=class extends Oi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:o_++}),this.uuid=Ea(),this.name="",this.type="Material",this.blending=Sa,this.side=Qs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Qu,this.blendDst=ed,this.blendEquation=Mr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new je(0,0,0),this.blendAlpha=0,this.depthFunc=ua,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=rm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=$l,this.stencilZFail=$l,this.stencilZPass=$l,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new je().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new mi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ve().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ve().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var gs=new V,Uu=new V,Pl=new V,Ll=new V,xr=class{constructor(e=new V,t=new V(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,gs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=gs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(gs.copy(this.origin).addScaledVector(this.direction,t),gs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Uu.copy(e).add(t).multiplyScalar(.5),Pl.copy(t).sub(e).normalize(),Ll.copy(this.origin).sub(Uu);let r=e.distanceTo(t)*.5,a=-this.direction.dot(Pl),o=Ll.dot(this.direction),l=-Ll.dot(Pl),c=Ll.lengthSq(),h=Math.abs(1-a*a),d,u,p,g;if(h>0)if(d=a*l-o,u=a*o-l,g=r*h,d>=0)if(u>=-g)if(u<=g){let _=1/h;d*=_,u*=_,p=d*(d+a*u+2*o)+u*(a*d+u+2*l)+c}else u=r,d=Math.max(0,-(a*u+o)),p=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(a*u+o)),p=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-a*r+o)),u=d>0?-r:Math.min(Math.max(-r,-l),r),p=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),p=u*(u+2*l)+c):(d=Math.max(0,-(a*r+o)),u=d>0?r:Math.min(Math.max(-r,-l),r),p=-d*d+u*(u+2*l)+c);else u=a>0?-r:r,d=Math.max(0,-(a*u+o)),p=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Uu).addScaledVector(Pl,u),p}intersectSphere(e,t){if(e.radius<0)return null;gs.subVectors(e.center,this.origin);let n=gs.dot(this.direction),s=gs.dot(gs)-n*n,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,a=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,a=(e.min.y-u.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),d>=0?(o=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(o=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,gs)!==null}intersectTriangle(e,t,n,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,d=e.x-a.x,u=e.y-a.y,p=e.z-a.z,g=t.x-a.x,_=t.y-a.y,m=t.z-a.z,v=n.x-a.x,x=n.y-a.y,E=n.z-a.z,S=Math.abs(l),R=Math.abs(c),w=Math.abs(h),y,A,k,U,D,L,F,P,G,Y,X,he;if(S>=R&&S>=w?(k=l,L=d,G=g,he=v,l>=0?(y=c,A=h,U=u,D=p,F=_,P=m,Y=x,X=E):(y=h,A=c,U=p,D=u,F=m,P=_,Y=E,X=x)):R>=w?(k=c,L=u,G=_,he=x,c>=0?(y=h,A=l,U=p,D=d,F=m,P=g,Y=E,X=v):(y=l,A=h,U=d,D=p,F=g,P=m,Y=v,X=E)):(k=h,L=p,G=m,he=E,h>=0?(y=l,A=c,U=d,D=u,F=g,P=_,Y=v,X=x):(y=c,A=l,U=u,D=d,F=_,P=g,Y=x,X=v)),k===0)return null;let J=y/k,ee=A/k,ne=1/k,ue=U-J*L,de=D-ee*L,Q=F-J*G,me=P-ee*G,_e=Y-J*he,Te=X-ee*he,xe=_e*me-Te*Q,qe=ue*Te-de*_e,st=Q*de-me*ue;if(s){if(xe<0||qe<0||st<0)return null}else if((xe<0||qe<0||st<0)&&(xe>0||qe>0||st>0))return null;let ae=xe+qe+st;if(ae===0)return null;let Xe=ne*(xe*L+qe*G+st*he);return(ae>0?Xe<0:Xe>0)?null:this.at(Xe/ae,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ac=class extends ys{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new xs,this.combine=Dc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},mp=new Xt,gr=new xr,Il=new _r,gp=new V,Dl=new V,Nl=new V,Ul=new V,Ou=new V,Ol=new V,vp=new V,Fl=new V,dn=class extends Bn{constructor(e=new un,t=new ac){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){Ol.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],d=r[l];h!==0&&(Ou.fromBufferAttribute(d,e),a?Ol.addScaledVector(Ou,h):Ol.addScaledVector(Ou.sub(t),h))}t.add(Ol)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Il.copy(n.boundingSphere),Il.applyMatrix4(r),gr.copy(e.ray).recast(e.near),!(Il.containsPoint(gr.origin)===!1&&(gr.intersectSphere(Il,gp)===null||gr.origin.distanceToSquared(gp)>(e.far-e.near)**2))&&(mp.copy(r).invert(),gr.copy(e.ray).applyMatrix4(mp),!(n.boundingBox!==null&&gr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,gr)))}_computeIntersections(e,t,n){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,p=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,_=u.length;g<_;g++){let m=u[g],v=a[m.materialIndex],x=Math.max(m.start,p.start),E=Math.min(o.count,Math.min(m.start+m.count,p.start+p.count));for(let S=x,R=E;S<R;S+=3){let w=o.getX(S),y=o.getX(S+1),A=o.getX(S+2);s=kl(this,v,e,n,c,h,d,w,y,A),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),_=Math.min(o.count,p.start+p.count);for(let m=g,v=_;m<v;m+=3){let x=o.getX(m),E=o.getX(m+1),S=o.getX(m+2);s=kl(this,a,e,n,c,h,d,x,E,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let g=0,_=u.length;g<_;g++){let m=u[g],v=a[m.materialIndex],x=Math.max(m.start,p.start),E=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let S=x,R=E;S<R;S+=3){let w=S,y=S+1,A=S+2;s=kl(this,v,e,n,c,h,d,w,y,A),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,p.start),_=Math.min(l.count,p.start+p.count);for(let m=g,v=_;m<v;m+=3){let x=m,E=m+1,S=m+2;s=kl(this,a,e,n,c,h,d,x,E,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function l_(i,e,t,n,s,r,a,o){let l;if(e.side===Kn?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,e.side===Qs,o),l===null)return null;Fl.copy(o),Fl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Fl);return c<t.near||c>t.far?null:{distance:c,point:Fl.clone(),object:i}}function kl(i,e,t,n,s,r,a,o,l,c){i.getVertexPosition(o,Dl),i.getVertexPosition(l,Nl),i.getVertexPosition(c,Ul);let h=l_(i,e,t,n,Dl,Nl,Ul,vp);if(h){let d=new V;Xs.getBarycoord(vp,Dl,Nl,Ul,d),s&&(h.uv=Xs.getInterpolatedAttribute(s,o,l,c,d,new Ve)),r&&(h.uv1=Xs.getInterpolatedAttribute(r,o,l,c,d,new Ve)),a&&(h.normal=Xs.getInterpolatedAttribute(a,o,l,c,d,new V),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a:o,b:l,c,normal:new V,materialIndex:0};Xs.getNormal(Dl,Nl,Ul,u.normal),h.face=u,h.barycoord=d}return h}var oc=class extends ii{constructor(e=null,t=1,n=1,s,r,a,o,l,c=In,h=In,d,u){super(null,a,o,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var vr=new _r,c_=new Ve(.5,.5),Bl=new V,qs=class{constructor(e=new mi,t=new mi,n=new mi,s=new mi,r=new mi,a=new mi){this.planes=[e,t,n,s,r,a]}set(e,t,n,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ti,n=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],p=r[7],g=r[8],_=r[9],m=r[10],v=r[11],x=r[12],E=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-a,p-h,v-g,R-x).normalize(),s[1].setComponents(c+a,p+h,v+g,R+x).normalize(),s[2].setComponents(c+o,p+d,v+_,R+E).normalize(),s[3].setComponents(c-o,p-d,v-_,R-E).normalize(),n)s[4].setComponents(l,u,m,S).normalize(),s[5].setComponents(c-l,p-u,v-m,R-S).normalize();else if(s[4].setComponents(c-l,p-u,v-m,R-S).normalize(),t===Ti)s[5].setComponents(c+l,p+u,v+m,R+S).normalize();else if(t===da)s[5].setComponents(l,u,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),vr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),vr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(vr)}intersectsSprite(e){vr.center.set(0,0,0);let t=c_.distanceTo(e.center);return vr.radius=.7071067811865476+t,vr.applyMatrix4(e.matrixWorld),this.intersectsSphere(vr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Bl.x=s.normal.x>0?e.max.x:e.min.x,Bl.y=s.normal.y>0?e.max.y:e.min.y,Bl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Bl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},_p=new Xt,lc=class i{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];_p.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new qs),n[s].setFromProjectionMatrix(_p,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new qs),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var bs=class extends ys{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new je(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},cc=new V,hc=new V,xp=new Xt,ro=new xr,zl=new _r,Fu=new V,yp=new V,Ss=class extends Bn{constructor(e=new un,t=new bs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)cc.fromBufferAttribute(t,s-1),hc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=cc.distanceTo(hc);e.setAttribute("lineDistance",new $t(n,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),zl.copy(n.boundingSphere),zl.applyMatrix4(s),zl.radius+=r,e.ray.intersectsSphere(zl)===!1)return;xp.copy(s).invert(),ro.copy(e.ray).applyMatrix4(xp);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let p=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let _=p,m=g-1;_<m;_+=c){let v=h.getX(_),x=h.getX(_+1),E=Vl(this,e,ro,l,v,x,_);E&&t.push(E)}if(this.isLineLoop){let _=h.getX(g-1),m=h.getX(p),v=Vl(this,e,ro,l,_,m,g-1);v&&t.push(v)}}else{let p=Math.max(0,a.start),g=Math.min(u.count,a.start+a.count);for(let _=p,m=g-1;_<m;_+=c){let v=Vl(this,e,ro,l,_,_+1,_);v&&t.push(v)}if(this.isLineLoop){let _=Vl(this,e,ro,l,g-1,p,g-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function Vl(i,e,t,n,s,r,a){let o=i.geometry.attributes.position;if(cc.fromBufferAttribute(o,s),hc.fromBufferAttribute(o,r),t.distanceSqToSegment(cc,hc,Fu,yp)>n)return;Fu.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Fu);if(!(c<e.near||c>e.far))return{distance:c,point:yp.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var bp=new V,Sp=new V,bo=class extends Ss{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)bp.fromBufferAttribute(t,s),Sp.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+bp.distanceTo(Sp);e.setAttribute("lineDistance",new $t(n,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var So=class extends ii{constructor(e=[],t=wr,n,s,r,a,o,l,c,h){super(e,t,n,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ms=class extends ii{constructor(e,t,n=Fi,s,r,a,o=In,l=In,c,h=_s,d=1){if(h!==_s&&h!==Ts)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,s,r,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ma(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Mo=class extends Ms{constructor(e,t=Fi,n=wr,s,r,a=In,o=In,l,c=_s){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,n,s,r,a,o,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},wo=class extends ii{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ws=class i extends un{constructor(e=1,t=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],d=[],u=0,p=0;g("z","y","x",-1,-1,n,t,e,a,r,0),g("z","y","x",1,-1,n,t,-e,a,r,1),g("x","z","y",1,1,e,n,t,s,a,2),g("x","z","y",1,-1,e,n,-t,s,a,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new $t(c,3)),this.setAttribute("normal",new $t(h,3)),this.setAttribute("uv",new $t(d,2));function g(_,m,v,x,E,S,R,w,y,A,k){let U=S/y,D=R/A,L=S/2,F=R/2,P=w/2,G=y+1,Y=A+1,X=0,he=0,J=new V;for(let ee=0;ee<Y;ee++){let ne=ee*D-F;for(let ue=0;ue<G;ue++){let de=ue*U-L;J[_]=de*x,J[m]=ne*E,J[v]=P,c.push(J.x,J.y,J.z),J[_]=0,J[m]=0,J[v]=w>0?1:-1,h.push(J.x,J.y,J.z),d.push(ue/y),d.push(1-ee/A),X+=1}}for(let ee=0;ee<A;ee++)for(let ne=0;ne<y;ne++){let ue=u+ne+G*ee,de=u+ne+G*(ee+1),Q=u+(ne+1)+G*(ee+1),me=u+(ne+1)+G*ee;l.push(ue,de,me),l.push(de,Q,me),he+=6}o.addGroup(p,he,k),p+=he,u+=X}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var va=class i extends un{constructor(e=1,t=1,n=1,s=32,r=1,a=!1,o=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:a,thetaStart:o,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],p=[],g=0,_=[],m=n/2,v=0;x(),a===!1&&(e>0&&E(!0),t>0&&E(!1)),this.setIndex(h),this.setAttribute("position",new $t(d,3)),this.setAttribute("normal",new $t(u,3)),this.setAttribute("uv",new $t(p,2));function x(){let S=new V,R=new V,w=0,y=(t-e)/n;for(let A=0;A<=r;A++){let k=[],U=A/r,D=U*(t-e)+e;for(let L=0;L<=s;L++){let F=L/s,P=F*l+o,G=Math.sin(P),Y=Math.cos(P);R.x=D*G,R.y=-U*n+m,R.z=D*Y,d.push(R.x,R.y,R.z),S.set(G,y,Y).normalize(),u.push(S.x,S.y,S.z),p.push(F,1-U),k.push(g++)}_.push(k)}for(let A=0;A<s;A++)for(let k=0;k<r;k++){let U=_[k][A],D=_[k+1][A],L=_[k+1][A+1],F=_[k][A+1];(e>0||k!==0)&&(h.push(U,D,F),w+=3),(t>0||k!==r-1)&&(h.push(D,L,F),w+=3)}c.addGroup(v,w,0),v+=w}function E(S){let R=g,w=new Ve,y=new V,A=0,k=S===!0?e:t,U=S===!0?1:-1;for(let L=1;L<=s;L++)d.push(0,m*U,0),u.push(0,U,0),p.push(.5,.5),g++;let D=g;for(let L=0;L<=s;L++){let P=L/s*l+o,G=Math.cos(P),Y=Math.sin(P);y.x=k*Y,y.y=m*U,y.z=k*G,d.push(y.x,y.y,y.z),u.push(0,U,0),w.x=G*.5+.5,w.y=Y*.5*U+.5,p.push(w.x,w.y),g++}for(let L=0;L<s;L++){let F=R+L,P=D+L;S===!0?h.push(P,P+1,F):h.push(P+1,P,F),A+=3}c.addGroup(v,A,S===!0?1:2),v+=A}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Ai=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Ke("Curve: .getPoint() not implemented.")}getPointAt(e,t){let n=this.getUtoTmapping(e);return this.getPoint(n,t)}getPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPoint(n/e));return t}getSpacedPoints(e=5){let t=[];for(let n=0;n<=e;n++)t.push(this.getPointAt(n/e));return t}getLength(){let e=this.getLengths();return e[e.length-1]}getLengths(e=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===e+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let t=[],n,s=this.getPoint(0),r=0;t.push(0);for(let a=1;a<=e;a++)n=this.getPoint(a/e),r+=n.distanceTo(s),t.push(r),s=n;return this.cacheArcLengths=t,t}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(e,t=null){let n=this.getLengths(),s=0,r=n.length,a;t?a=t:a=e*n[r-1];let o=0,l=r-1,c;for(;o<=l;)if(s=Math.floor(o+(l-o)/2),c=n[s]-a,c<0)o=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===a)return s/(r-1);let h=n[s],u=n[s+1]-h,p=(a-h)/u;return(s+p)/(r-1)}getTangent(e,t){let s=e-1e-4,r=e+1e-4;s<0&&(s=0),r>1&&(r=1);let a=this.getPoint(s),o=this.getPoint(r),l=t||(a.isVector2?new Ve:new V);return l.copy(o).sub(a).normalize(),l}getTangentAt(e,t){let n=this.getUtoTmapping(e);return this.getTangent(n,t)}computeFrenetFrames(e,t=!1){let n=new V,s=[],r=[],a=[],o=new V,l=new Xt;for(let p=0;p<=e;p++){let g=p/e;s[p]=this.getTangentAt(g,new V)}r[0]=new V,a[0]=new V;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),d=Math.abs(s[0].y),u=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),d<=c&&(c=d,n.set(0,1,0)),u<=c&&n.set(0,0,1),o.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],o),a[0].crossVectors(s[0],r[0]);for(let p=1;p<=e;p++){if(r[p]=r[p-1].clone(),a[p]=a[p-1].clone(),o.crossVectors(s[p-1],s[p]),o.length()>Number.EPSILON){o.normalize();let g=Math.acos(gt(s[p-1].dot(s[p]),-1,1));r[p].applyMatrix4(l.makeRotationAxis(o,g))}a[p].crossVectors(s[p],r[p])}if(t===!0){let p=Math.acos(gt(r[0].dot(r[e]),-1,1));p/=e,s[0].dot(o.crossVectors(r[0],r[e]))>0&&(p=-p);for(let g=1;g<=e;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],p*g)),a[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:a}}clone(){return new this.constructor().copy(this)}copy(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let e={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return e.arcLengthDivisions=this.arcLengthDivisions,e.type=this.type,e}fromJSON(e){return this.arcLengthDivisions=e.arcLengthDivisions,this.cacheArcLengths=null,this}},Eo=class extends Ai{constructor(e=0,t=0,n=1,s=1,r=0,a=Math.PI*2,o=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=e,this.aY=t,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=a,this.aClockwise=o,this.aRotation=l}getPoint(e,t=new Ve){let n=t,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,a=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(a?r=0:r=s),this.aClockwise===!0&&!a&&(r===s?r=-s:r=r-s);let o=this.aStartAngle+e*r,l=this.aX+this.xRadius*Math.cos(o),c=this.aY+this.yRadius*Math.sin(o);if(this.aRotation!==0){let h=Math.cos(this.aRotation),d=Math.sin(this.aRotation),u=l-this.aX,p=c-this.aY;l=u*h-p*d+this.aX,c=u*d+p*h+this.aY}return n.set(l,c)}copy(e){return super.copy(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}toJSON(){let e=super.toJSON();return e.aX=this.aX,e.aY=this.aY,e.xRadius=this.xRadius,e.yRadius=this.yRadius,e.aStartAngle=this.aStartAngle,e.aEndAngle=this.aEndAngle,e.aClockwise=this.aClockwise,e.aRotation=this.aRotation,e}fromJSON(e){return super.fromJSON(e),this.aX=e.aX,this.aY=e.aY,this.xRadius=e.xRadius,this.yRadius=e.yRadius,this.aStartAngle=e.aStartAngle,this.aEndAngle=e.aEndAngle,this.aClockwise=e.aClockwise,this.aRotation=e.aRotation,this}},uc=class extends Eo{constructor(e,t,n,s,r,a){super(e,t,n,n,s,r,a),this.isArcCurve=!0,this.type="ArcCurve"}};function Ed(){let i=0,e=0,t=0,n=0;function s(r,a,o,l){i=r,e=o,t=-3*r+3*a-2*o-l,n=2*r-2*a+o+l}return{initCatmullRom:function(r,a,o,l,c){s(a,o,c*(o-r),c*(l-a))},initNonuniformCatmullRom:function(r,a,o,l,c,h,d){let u=(a-r)/c-(o-r)/(c+h)+(o-a)/h,p=(o-a)/h-(l-a)/(h+d)+(l-o)/d;u*=h,p*=h,s(a,o,u,p)},calc:function(r){let a=r*r,o=a*r;return i+e*r+t*a+n*o}}}var Mp=new V,wp=new V,ku=new Ed,Bu=new Ed,zu=new Ed,_a=class extends Ai{constructor(e=[],t=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=e,this.closed=t,this.curveType=n,this.tension=s}getPoint(e,t=new V){let n=t,s=this.points,r=s.length,a=(r-(this.closed?0:1))*e,o=Math.floor(a),l=a-o;this.closed?o+=o>0?0:(Math.floor(Math.abs(o)/r)+1)*r:l===0&&o===r-1&&(o=r-2,l=1);let c,h;this.closed||o>0?c=s[(o-1)%r]:(wp.subVectors(s[0],s[1]).add(s[0]),c=wp);let d=s[o%r],u=s[(o+1)%r];if(this.closed||o+2<r?h=s[(o+2)%r]:(Mp.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Mp),this.curveType==="centripetal"||this.curveType==="chordal"){let p=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(d),p),_=Math.pow(d.distanceToSquared(u),p),m=Math.pow(u.distanceToSquared(h),p);_<1e-4&&(_=1),g<1e-4&&(g=_),m<1e-4&&(m=_),ku.initNonuniformCatmullRom(c.x,d.x,u.x,h.x,g,_,m),Bu.initNonuniformCatmullRom(c.y,d.y,u.y,h.y,g,_,m),zu.initNonuniformCatmullRom(c.z,d.z,u.z,h.z,g,_,m)}else this.curveType==="catmullrom"&&(ku.initCatmullRom(c.x,d.x,u.x,h.x,this.tension),Bu.initCatmullRom(c.y,d.y,u.y,h.y,this.tension),zu.initCatmullRom(c.z,d.z,u.z,h.z,this.tension));return n.set(ku.calc(l),Bu.calc(l),zu.calc(l)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e.closed=this.closed,e.curveType=this.curveType,e.tension=this.tension,e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new V().fromArray(s))}return this.closed=e.closed,this.curveType=e.curveType,this.tension=e.tension,this}};function Ep(i,e,t,n,s){let r=(n-e)*.5,a=(s-t)*.5,o=i*i,l=i*o;return(2*t-2*n+r+a)*l+(-3*t+3*n-2*r-a)*o+r*i+t}function h_(i,e){let t=1-i;return t*t*e}function u_(i,e){return 2*(1-i)*i*e}function d_(i,e){return i*i*e}function co(i,e,t,n){return h_(i,e)+u_(i,t)+d_(i,n)}function f_(i,e){let t=1-i;return t*t*t*e}function p_(i,e){let t=1-i;return 3*t*t*i*e}function m_(i,e){return 3*(1-i)*i*i*e}function g_(i,e){return i*i*i*e}function ho(i,e,t,n,s){return f_(i,e)+p_(i,t)+m_(i,n)+g_(i,s)}var dc=class extends Ai{constructor(e=new Ve,t=new Ve,n=new Ve,s=new Ve){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new Ve){let n=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return n.set(ho(e,s.x,r.x,a.x,o.x),ho(e,s.y,r.y,a.y,o.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},fc=class extends Ai{constructor(e=new V,t=new V,n=new V,s=new V){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=e,this.v1=t,this.v2=n,this.v3=s}getPoint(e,t=new V){let n=t,s=this.v0,r=this.v1,a=this.v2,o=this.v3;return n.set(ho(e,s.x,r.x,a.x,o.x),ho(e,s.y,r.y,a.y,o.y),ho(e,s.z,r.z,a.z,o.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this.v3.copy(e.v3),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e.v3=this.v3.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this.v3.fromArray(e.v3),this}},pc=class extends Ai{constructor(e=new Ve,t=new Ve){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=e,this.v2=t}getPoint(e,t=new Ve){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new Ve){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},mc=class extends Ai{constructor(e=new V,t=new V){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=e,this.v2=t}getPoint(e,t=new V){let n=t;return e===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(e).add(this.v1)),n}getPointAt(e,t){return this.getPoint(e,t)}getTangent(e,t=new V){return t.subVectors(this.v2,this.v1).normalize()}getTangentAt(e,t){return this.getTangent(e,t)}copy(e){return super.copy(e),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},gc=class extends Ai{constructor(e=new Ve,t=new Ve,n=new Ve){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new Ve){let n=t,s=this.v0,r=this.v1,a=this.v2;return n.set(co(e,s.x,r.x,a.x),co(e,s.y,r.y,a.y)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},To=class extends Ai{constructor(e=new V,t=new V,n=new V){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=e,this.v1=t,this.v2=n}getPoint(e,t=new V){let n=t,s=this.v0,r=this.v1,a=this.v2;return n.set(co(e,s.x,r.x,a.x),co(e,s.y,r.y,a.y),co(e,s.z,r.z,a.z)),n}copy(e){return super.copy(e),this.v0.copy(e.v0),this.v1.copy(e.v1),this.v2.copy(e.v2),this}toJSON(){let e=super.toJSON();return e.v0=this.v0.toArray(),e.v1=this.v1.toArray(),e.v2=this.v2.toArray(),e}fromJSON(e){return super.fromJSON(e),this.v0.fromArray(e.v0),this.v1.fromArray(e.v1),this.v2.fromArray(e.v2),this}},vc=class extends Ai{constructor(e=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=e}getPoint(e,t=new Ve){let n=t,s=this.points,r=(s.length-1)*e,a=Math.floor(r),o=r-a,l=s[a===0?a:a-1],c=s[a],h=s[a>s.length-2?s.length-1:a+1],d=s[a>s.length-3?s.length-1:a+2];return n.set(Ep(o,l.x,c.x,h.x,d.x),Ep(o,l.y,c.y,h.y,d.y)),n}copy(e){super.copy(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(s.clone())}return this}toJSON(){let e=super.toJSON();e.points=[];for(let t=0,n=this.points.length;t<n;t++){let s=this.points[t];e.points.push(s.toArray())}return e}fromJSON(e){super.fromJSON(e),this.points=[];for(let t=0,n=e.points.length;t<n;t++){let s=e.points[t];this.points.push(new Ve().fromArray(s))}return this}},v_=Object.freeze({__proto__:null,ArcCurve:uc,CatmullRomCurve3:_a,CubicBezierCurve:dc,CubicBezierCurve3:fc,EllipseCurve:Eo,LineCurve:pc,LineCurve3:mc,QuadraticBezierCurve:gc,QuadraticBezierCurve3:To,SplineCurve:vc});var Ao=class i extends un{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(n),l=Math.floor(s),c=o+1,h=l+1,d=e/o,u=t/l,p=[],g=[],_=[],m=[];for(let v=0;v<h;v++){let x=v*u-a;for(let E=0;E<c;E++){let S=E*d-r;g.push(S,-x,0),_.push(0,0,1),m.push(E/o),m.push(1-v/l)}}for(let v=0;v<l;v++)for(let x=0;x<o;x++){let E=x+c*v,S=x+c*(v+1),R=x+1+c*(v+1),w=x+1+c*v;p.push(E,S,w),p.push(S,R,w)}this.setIndex(p),this.setAttribute("position",new $t(g,3)),this.setAttribute("normal",new $t(_,3)),this.setAttribute("uv",new $t(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var yr=class i extends un{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,a=0,o=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:a,thetaLength:o},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(a+o,Math.PI),c=0,h=[],d=new V,u=new V,p=[],g=[],_=[],m=[];for(let v=0;v<=n;v++){let x=[],E=v/n,S=a+E*o,R=e*Math.cos(S),w=Math.sqrt(e*e-R*R),y=0;v===0&&a===0?y=.5/t:v===n&&l===Math.PI&&(y=-.5/t);for(let A=0;A<=t;A++){let k=A/t,U=s+k*r;d.x=-w*Math.cos(U),d.y=R,d.z=w*Math.sin(U),g.push(d.x,d.y,d.z),u.copy(d).normalize(),_.push(u.x,u.y,u.z),m.push(k+y,1-E),x.push(c++)}h.push(x)}for(let v=0;v<n;v++)for(let x=0;x<t;x++){let E=h[v][x+1],S=h[v][x],R=h[v+1][x],w=h[v+1][x+1];(v!==0||a>0)&&p.push(E,S,w),(v!==n-1||l<Math.PI)&&p.push(S,R,w)}this.setIndex(p),this.setAttribute("position",new $t(g,3)),this.setAttribute("normal",new $t(_,3)),this.setAttribute("uv",new $t(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Co=class i extends un{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,a=0,o=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:a,thetaLength:o},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],d=[],u=new V,p=new V,g=new V;for(let _=0;_<=n;_++){let m=a+_/n*o;for(let v=0;v<=s;v++){let x=v/s*r;p.x=(e+t*Math.cos(m))*Math.cos(x),p.y=(e+t*Math.cos(m))*Math.sin(x),p.z=t*Math.sin(m),c.push(p.x,p.y,p.z),u.x=e*Math.cos(x),u.y=e*Math.sin(x),g.subVectors(p,u).normalize(),h.push(g.x,g.y,g.z),d.push(v/s),d.push(_/n)}}for(let _=1;_<=n;_++)for(let m=1;m<=s;m++){let v=(s+1)*_+m-1,x=(s+1)*(_-1)+m-1,E=(s+1)*(_-1)+m,S=(s+1)*_+m;l.push(v,x,S),l.push(x,E,S)}this.setIndex(l),this.setAttribute("position",new $t(c,3)),this.setAttribute("normal",new $t(h,3)),this.setAttribute("uv",new $t(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};var Ro=class i extends un{constructor(e=new To(new V(-1,-1,0),new V(-1,1,0),new V(1,1,0)),t=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:e,tubularSegments:t,radius:n,radialSegments:s,closed:r};let a=e.computeFrenetFrames(t,r);this.tangents=a.tangents,this.normals=a.normals,this.binormals=a.binormals;let o=new V,l=new V,c=new Ve,h=new V,d=[],u=[],p=[],g=[];_(),this.setIndex(g),this.setAttribute("position",new $t(d,3)),this.setAttribute("normal",new $t(u,3)),this.setAttribute("uv",new $t(p,2));function _(){for(let E=0;E<t;E++)m(E);m(r===!1?t:0),x(),v()}function m(E){h=e.getPointAt(E/t,h);let S=a.normals[E],R=a.binormals[E];for(let w=0;w<=s;w++){let y=w/s*Math.PI*2,A=Math.sin(y),k=-Math.cos(y);l.x=k*S.x+A*R.x,l.y=k*S.y+A*R.y,l.z=k*S.z+A*R.z,l.normalize(),u.push(l.x,l.y,l.z),o.x=h.x+n*l.x,o.y=h.y+n*l.y,o.z=h.z+n*l.z,d.push(o.x,o.y,o.z)}}function v(){for(let E=1;E<=t;E++)for(let S=1;S<=s;S++){let R=(s+1)*(E-1)+(S-1),w=(s+1)*E+(S-1),y=(s+1)*E+S,A=(s+1)*(E-1)+S;g.push(R,w,A),g.push(w,y,A)}}function x(){for(let E=0;E<=t;E++)for(let S=0;S<=s;S++)c.x=E/t,c.y=S/s,p.push(c.x,c.y)}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}toJSON(){let e=super.toJSON();return e.path=this.parameters.path.toJSON(),e}static fromJSON(e){return new i(new v_[e.path.type]().fromJSON(e.path),e.tubularSegments,e.radius,e.radialSegments,e.closed)}};function Tr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Tp(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Tp(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function zn(i){let e={};for(let t=0;t<i.length;t++){let n=Tr(i[t]);for(let s in n)e[s]=n[s]}return e}function Tp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function __(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Td(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:wt.workingColorSpace}var xm={clone:Tr,merge:zn},x_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,y_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ts=class extends ys{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=x_,this.fragmentShader=y_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Tr(e.uniforms),this.uniformsGroups=__(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new je().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ve().fromArray(s.value);break;case"v3":this.uniforms[n].value=new V().fromArray(s.value);break;case"v4":this.uniforms[n].value=new tn().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ct().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Xt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},_c=class extends ts{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Jn=class extends ys{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=xh,this.normalScale=new Ve(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new xs,this.combine=Dc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},xc=class extends ys{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=im,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},yc=class extends ys{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};var Po=class extends bs{constructor(e){super(),this.isLineDashedMaterial=!0,this.type="LineDashedMaterial",this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(e)}copy(e){return super.copy(e),this.scale=e.scale,this.dashSize=e.dashSize,this.gapSize=e.gapSize,this}};function oa(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Gl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Ys=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let a;t:{i:if(!(e<s)){for(let o=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=t[++n],e<s)break e}a=t.length;break t}if(!(e>=r)){let o=t[1];e<o&&(n=2,r=o);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}a=n,n=0;break t}break n}for(;n<a;){let o=n+a>>>1;e<t[o]?a=o:n=o+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=n[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},bc=class extends Ys{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Hu,endingEnd:Hu}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Wu:r=e,o=2*t-n;break;case Xu:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Wu:a=e,l=2*n-t;break;case Xu:a=1,l=n+s[1]-s[0];break;default:a=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,p=this._weightNext,g=(n-t)/(s-t),_=g*g,m=_*g,v=-u*m+2*u*_-u*g,x=(1+u)*m+(-1.5-2*u)*_+(-.5+u)*g+1,E=(-1-p)*m+(1.5+p)*_+.5*g,S=p*m-p*_;for(let R=0;R!==o;++R)r[R]=v*a[h+R]+x*a[c+R]+E*a[l+R]+S*a[d+R];return r}},Sc=class extends Ys{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=(n-t)/(s-t),d=1-h;for(let u=0;u!==o;++u)r[u]=a[c+u]*d+a[l+u]*h;return r}},Mc=class extends Ys{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},wc=class extends Ys{interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this.inTangents,d=this.outTangents;if(!h||!d){let g=(n-t)/(s-t),_=1-g;for(let m=0;m!==o;++m)r[m]=a[c+m]*_+a[l+m]*g;return r}let u=o*2,p=e-1;for(let g=0;g!==o;++g){let _=a[c+g],m=a[l+g],v=p*u+g*2,x=d[v],E=d[v+1],S=e*u+g*2,R=h[S],w=h[S+1],y=S_(n,t,x,R,s);r[g]=ym(y,_,E,w,m)}return r}};function ym(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function b_(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function S_(i,e,t,n,s){let r=(i-e)/(s-e);for(let a=0;a<8;a++){let o=ym(r,e,t,n,s)-i;if(Math.abs(o)<1e-10)break;let l=b_(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var _i=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=oa(t,this.TimeBufferType),this.values=oa(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:oa(e.times,Array),values:oa(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Gl(e.settings)&&(n.settings={inTangents:oa(e.settings.inTangents,Array),outTangents:oa(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Mc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Sc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new bc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new wc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case uo:t=this.InterpolantFactoryMethodDiscrete;break;case nc:t=this.InterpolantFactoryMethodLinear;break;case Xl:t=this.InterpolantFactoryMethodSmooth;break;case Gu:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ke("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return uo;case this.InterpolantFactoryMethodLinear:return nc;case this.InterpolantFactoryMethodSmooth:return Xl;case this.InterpolantFactoryMethodBezier:return Gu}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Gl(this.settings)&&(Ap(this.settings.inTangents,e),Ap(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Gl(this.settings)&&(Cp(this.settings.inTangents,e),Cp(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<e;)++r;for(;a!==-1&&n[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ot("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ot("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let l=n[o];if(typeof l=="number"&&isNaN(l)){ot("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){ot("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(s!==void 0&&Pv(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){ot("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Xl,r=e.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=e[o],h=e[o+1];if(c!==h&&(o!==1||c!==e[0]))if(s)l=!0;else{let d=o*n,u=d-n,p=d+n;for(let g=0;g!==n;++g){let _=t[d+g];if(_!==t[u+g]||_!==t[p+g]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let d=o*n,u=a*n;for(let p=0;p!==n;++p)t[u+p]=t[d+p]}++a}}if(r>0){e[a]=e[r];for(let o=r*n,l=a*n,c=0;c!==n;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Gl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Ap(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Cp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}_i.prototype.ValueTypeName="";_i.prototype.TimeBufferType=Float32Array;_i.prototype.ValueBufferType=Float32Array;_i.prototype.DefaultInterpolation=nc;var Zs=class extends _i{constructor(e,t,n){super(e,t,n)}};Zs.prototype.ValueTypeName="bool";Zs.prototype.ValueBufferType=Array;Zs.prototype.DefaultInterpolation=uo;Zs.prototype.InterpolantFactoryMethodLinear=void 0;Zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ec=class extends _i{constructor(e,t,n,s){super(e,t,n,s)}};Ec.prototype.ValueTypeName="color";var Tc=class extends _i{constructor(e,t,n,s){super(e,t,n,s)}};Tc.prototype.ValueTypeName="number";var Ac=class extends Ys{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(n-t)/(s-t),c=e*o;for(let h=c+o;c!==h;c+=4)Zn.slerpFlat(r,0,a,c-o,a,c,l);return r}},Lo=class extends _i{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Ac(this.times,this.values,this.getValueSize(),e)}};Lo.prototype.ValueTypeName="quaternion";Lo.prototype.InterpolantFactoryMethodSmooth=void 0;var Js=class extends _i{constructor(e,t,n){super(e,t,n)}};Js.prototype.ValueTypeName="string";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=uo;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var Cc=class extends _i{constructor(e,t,n,s){super(e,t,n,s)}};Cc.prototype.ValueTypeName="vector";var Rc=class{constructor(e,t,n){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let p=c[d],g=c[d+1];if(p.global&&(p.lastIndex=0),p.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},bm=new Rc,Pc=class{constructor(e){this.manager=e!==void 0?e:bm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Pc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Io=class extends Bn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new je(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Vu=new Xt,Rp=new V,Pp=new V,Lc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ve(512,512),this.mapType=ri,this.map=null,this.mapPass=null,this.matrix=new Xt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new qs,this._frameExtents=new Ve(1,1),this._viewportCount=1,this._viewports=[new tn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Rp.setFromMatrixPosition(e.matrixWorld),t.position.copy(Rp),Pp.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Pp),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Vu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Vu,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,a=s?s.z/r.x:1,o=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===da||e.reversedDepth?t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,1,0,0,0,0,1):t.set(.5*a,0,0,.5*a+l,0,.5*o,0,.5*o+c,0,0,.5,.5,0,0,0,1),t.multiply(Vu)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Hl=new V,Wl=new Zn,Qi=new V,Do=class extends Bn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Xt,this.projectionMatrix=new Xt,this.projectionMatrixInverse=new Xt,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Hl,Wl,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Hl,Wl,Qi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Hl,Wl,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Hl,Wl,Qi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ws=new V,Lp=new Ve,Ip=new Ve,gi=class extends Do{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=pa*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(oo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return pa*2*Math.atan(Math.tan(oo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ws.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ws.x,Ws.y).multiplyScalar(-e/Ws.z),Ws.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ws.x,Ws.y).multiplyScalar(-e/Ws.z)}getViewSize(e,t){return this.getViewBounds(e,Lp,Ip),t.subVectors(Ip,Lp)}setViewOffset(e,t,n,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(oo*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var br=class extends Do{constructor(e=-1,t=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,a=n+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},$u=class extends Lc{constructor(){super(new br(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},No=class extends Io{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Bn.DEFAULT_UP),this.updateMatrix(),this.target=new Bn,this.shadow=new $u}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}},Uo=class extends Io{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}};var la=-90,ca=1,xa=class extends Bn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new gi(la,ca,e,t);s.layers=this.layers,this.add(s);let r=new gi(la,ca,e,t);r.layers=this.layers,this.add(r);let a=new gi(la,ca,e,t);a.layers=this.layers,this.add(a);let o=new gi(la,ca,e,t);o.layers=this.layers,this.add(o);let l=new gi(la,ca,e,t);l.layers=this.layers,this.add(l);let c=new gi(la,ca,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,a,o,l]=t;for(let c of t)this.remove(c);if(e===Ti)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===da)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=_,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,p),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Ic=class extends gi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Ad="\\[\\]\\.:\\/",M_=new RegExp("["+Ad+"]","g"),Cd="[^"+Ad+"]",w_="[^"+Ad.replace("\\.","")+"]",E_=/((?:WC+[\/:])*)/.source.replace("WC",Cd),T_=/(WCOD+)?/.source.replace("WCOD",w_),A_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Cd),C_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Cd),R_=new RegExp("^"+E_+T_+A_+C_+"$"),P_=["material","materials","bones","map"],qu=class{constructor(e,t,n){let s=n||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},jt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(M_,"")}static parseTrackName(e){let t=R_.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);P_.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let l=n(o.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ot("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ot("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ot("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ot("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ot("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[s];if(a===void 0){let c=t.nodeName;ot("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=qu;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var WE=new Float32Array(1);var ya=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=gt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(gt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Yu=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var Oo=class extends Oi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Rd(i,e,t,n){let s=L_(n);switch(t){case fd:return i*e;case md:return i*e/s.components*s.byteLength;case zc:return i*e/s.components*s.byteLength;case er:return i*e*2/s.components*s.byteLength;case Vc:return i*e*2/s.components*s.byteLength;case pd:return i*e*3/s.components*s.byteLength;case zi:return i*e*4/s.components*s.byteLength;case Gc:return i*e*4/s.components*s.byteLength;case Bo:case zo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Vo:case Go:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Wc:case $c:return Math.max(i,16)*Math.max(e,8)/4;case Hc:case Xc:return Math.max(i,8)*Math.max(e,8)/2;case qc:case Yc:case Jc:case Kc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Zc:case Ho:case jc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Qc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case eh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case th:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case nh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ih:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case sh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case rh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case ah:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case oh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case lh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case ch:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case hh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case uh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case dh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case fh:case ph:case mh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case gh:case vh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Wo:case _h:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function L_(i){switch(i){case ri:case cd:return{byteLength:1,components:1};case wa:case hd:case Bi:return{byteLength:2,components:1};case kc:case Bc:return{byteLength:2,components:4};case Fi:case Fc:case ki:return{byteLength:4,components:1};case ud:case dd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Hm(){let i=null,e=!1,t=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function D_(i){let e=new WeakMap;function t(o,l){let c=o.array,h=o.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),o.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:d}}function n(o,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,o),d.length===0)i.bufferSubData(c,0,h);else{d.sort((p,g)=>p.start-g.start);let u=0;for(let p=1;p<d.length;p++){let g=d[u],_=d[p];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++u,d[u]=_)}d.length=u+1;for(let p=0,g=d.length;p<g;p++){let _=d[p];i.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(i.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var N_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,U_=`#ifdef USE_ALPHAHASH
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
#endif`,O_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,F_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,k_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,B_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,z_=`#ifdef USE_AOMAP
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
#endif`,V_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,G_=`#ifdef USE_BATCHING
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
#endif`,H_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,W_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,X_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,$_=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,q_=`#ifdef USE_IRIDESCENCE
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
#endif`,Y_=`#ifdef USE_BUMPMAP
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
#endif`,Z_=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,J_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,K_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,j_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Q_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ex=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,tx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,nx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,ix=`#define PI 3.141592653589793
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
} // validated`,sx=`vec3 transformedNormal = objectNormal;
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
#endif`,rx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ax=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ox=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,lx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,cx="gl_FragColor = linearToOutputTexel( gl_FragColor );",hx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,ux=`#ifdef USE_ENVMAP
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
#endif`,dx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,fx=`#ifdef USE_ENVMAP
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
#endif`,px=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,mx=`#ifdef USE_ENVMAP
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
#endif`,gx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,vx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,_x=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,xx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,yx=`#ifdef USE_GRADIENTMAP
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
}`,bx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Sx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Mx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,wx=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Ex=`#ifdef USE_ENVMAP
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
#endif`,Tx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Ax=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Cx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Rx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Px=`PhysicalMaterial material;
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
#endif`,Lx=`uniform sampler2D dfgLUT;
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
}`,Ix=`
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
#endif`,Dx=`#if defined( RE_IndirectDiffuse )
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
#endif`,Nx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ux=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Ox=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Fx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Bx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,zx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Vx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Gx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Hx=`#if defined( USE_POINTS_UV )
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
#endif`,Wx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Xx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,$x=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,qx=`#if defined( USE_MORPHCOLORS )
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
#endif`,Yx=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Zx=`#ifdef USE_MORPHTARGETS
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
#endif`,Jx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Kx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,jx=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Qx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ey=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ty=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,ny=`#ifdef USE_NORMALMAP
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
#endif`,iy=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,sy=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,ry=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,ay=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,oy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ly=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,cy=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,hy=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,uy=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,dy=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,fy=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,py=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,my=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,gy=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,vy=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,_y=`float getShadowMask() {
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
}`,xy=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,yy=`#ifdef USE_SKINNING
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
#endif`,by=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Sy=`#ifdef USE_SKINNING
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
#endif`,My=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,wy=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Ey=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Ty=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Ay=`#ifdef USE_TRANSMISSION
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
#endif`,Cy=`#ifdef USE_TRANSMISSION
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
#endif`,Ry=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Py=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ly=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Iy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Dy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Ny=`uniform sampler2D t2D;
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
}`,Uy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Oy=`uniform float backgroundBlurriness;
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
}`,Fy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ky=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,By=`#include <common>
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
}`,zy=`#if DEPTH_PACKING == 3200
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
}`,Vy=`#define DISTANCE
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
}`,Gy=`#define DISTANCE
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
}`,Hy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Wy=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Xy=`uniform float scale;
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
}`,$y=`uniform vec3 diffuse;
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
}`,qy=`#include <common>
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
}`,Yy=`uniform vec3 diffuse;
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
}`,Zy=`#define LAMBERT
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
}`,Jy=`#define LAMBERT
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
}`,Ky=`#define MATCAP
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
}`,jy=`#define MATCAP
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
}`,Qy=`#define NORMAL
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
}`,eb=`#define NORMAL
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
}`,tb=`#define PHONG
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
}`,nb=`#define PHONG
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
}`,ib=`#define STANDARD
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
}`,sb=`#define STANDARD
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
}`,rb=`#define TOON
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
}`,ab=`#define TOON
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
}`,ob=`uniform float size;
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
}`,lb=`uniform vec3 diffuse;
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
}`,cb=`#include <common>
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
}`,hb=`uniform vec3 color;
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
}`,ub=`uniform float rotation;
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
}`,db=`uniform vec3 diffuse;
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
}`,vt={alphahash_fragment:N_,alphahash_pars_fragment:U_,alphamap_fragment:O_,alphamap_pars_fragment:F_,alphatest_fragment:k_,alphatest_pars_fragment:B_,aomap_fragment:z_,aomap_pars_fragment:V_,batching_pars_vertex:G_,batching_vertex:H_,begin_vertex:W_,beginnormal_vertex:X_,bsdfs:$_,iridescence_fragment:q_,bumpmap_pars_fragment:Y_,clipping_planes_fragment:Z_,clipping_planes_pars_fragment:J_,clipping_planes_pars_vertex:K_,clipping_planes_vertex:j_,color_fragment:Q_,color_pars_fragment:ex,color_pars_vertex:tx,color_vertex:nx,common:ix,defaultnormal_vertex:sx,displacementmap_pars_vertex:rx,displacementmap_vertex:ax,emissivemap_fragment:ox,emissivemap_pars_fragment:lx,colorspace_fragment:cx,colorspace_pars_fragment:hx,envmap_fragment:ux,envmap_common_pars_fragment:dx,envmap_pars_fragment:fx,envmap_pars_vertex:px,envmap_physical_pars_fragment:Ex,envmap_vertex:mx,fog_vertex:gx,fog_pars_vertex:vx,fog_fragment:_x,fog_pars_fragment:xx,gradientmap_pars_fragment:yx,lightmap_pars_fragment:bx,lights_lambert_fragment:Sx,lights_lambert_pars_fragment:Mx,lights_pars_begin:wx,lights_toon_fragment:Tx,lights_toon_pars_fragment:Ax,lights_phong_fragment:Cx,lights_phong_pars_fragment:Rx,lights_physical_fragment:Px,lights_physical_pars_fragment:Lx,lights_fragment_begin:Ix,lights_fragment_maps:Dx,lights_fragment_end:Nx,lightprobes_pars_fragment:Ux,logdepthbuf_fragment:Ox,logdepthbuf_pars_fragment:Fx,logdepthbuf_pars_vertex:kx,logdepthbuf_vertex:Bx,map_fragment:zx,map_pars_fragment:Vx,map_particle_fragment:Gx,map_particle_pars_fragment:Hx,metalnessmap_fragment:Wx,metalnessmap_pars_fragment:Xx,morphinstance_vertex:$x,morphcolor_vertex:qx,morphnormal_vertex:Yx,morphtarget_pars_vertex:Zx,morphtarget_vertex:Jx,normal_fragment_begin:Kx,normal_fragment_maps:jx,normal_pars_fragment:Qx,normal_pars_vertex:ey,normal_vertex:ty,normalmap_pars_fragment:ny,clearcoat_normal_fragment_begin:iy,clearcoat_normal_fragment_maps:sy,clearcoat_pars_fragment:ry,iridescence_pars_fragment:ay,opaque_fragment:oy,packing:ly,premultiplied_alpha_fragment:cy,project_vertex:hy,dithering_fragment:uy,dithering_pars_fragment:dy,roughnessmap_fragment:fy,roughnessmap_pars_fragment:py,shadowmap_pars_fragment:my,shadowmap_pars_vertex:gy,shadowmap_vertex:vy,shadowmask_pars_fragment:_y,skinbase_vertex:xy,skinning_pars_vertex:yy,skinning_vertex:by,skinnormal_vertex:Sy,specularmap_fragment:My,specularmap_pars_fragment:wy,tonemapping_fragment:Ey,tonemapping_pars_fragment:Ty,transmission_fragment:Ay,transmission_pars_fragment:Cy,uv_pars_fragment:Ry,uv_pars_vertex:Py,uv_vertex:Ly,worldpos_vertex:Iy,background_vert:Dy,background_frag:Ny,backgroundCube_vert:Uy,backgroundCube_frag:Oy,cube_vert:Fy,cube_frag:ky,depth_vert:By,depth_frag:zy,distance_vert:Vy,distance_frag:Gy,equirect_vert:Hy,equirect_frag:Wy,linedashed_vert:Xy,linedashed_frag:$y,meshbasic_vert:qy,meshbasic_frag:Yy,meshlambert_vert:Zy,meshlambert_frag:Jy,meshmatcap_vert:Ky,meshmatcap_frag:jy,meshnormal_vert:Qy,meshnormal_frag:eb,meshphong_vert:tb,meshphong_frag:nb,meshphysical_vert:ib,meshphysical_frag:sb,meshtoon_vert:rb,meshtoon_frag:ab,points_vert:ob,points_frag:lb,shadow_vert:cb,shadow_frag:hb,sprite_vert:ub,sprite_frag:db},Ue={common:{diffuse:{value:new je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new Ve(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new je(16777215)},opacity:{value:1},center:{value:new Ve(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},ss={basic:{uniforms:zn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:vt.meshbasic_vert,fragmentShader:vt.meshbasic_frag},lambert:{uniforms:zn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new je(0)},envMapIntensity:{value:1}}]),vertexShader:vt.meshlambert_vert,fragmentShader:vt.meshlambert_frag},phong:{uniforms:zn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new je(0)},specular:{value:new je(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:vt.meshphong_vert,fragmentShader:vt.meshphong_frag},standard:{uniforms:zn([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag},toon:{uniforms:zn([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new je(0)}}]),vertexShader:vt.meshtoon_vert,fragmentShader:vt.meshtoon_frag},matcap:{uniforms:zn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:vt.meshmatcap_vert,fragmentShader:vt.meshmatcap_frag},points:{uniforms:zn([Ue.points,Ue.fog]),vertexShader:vt.points_vert,fragmentShader:vt.points_frag},dashed:{uniforms:zn([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:vt.linedashed_vert,fragmentShader:vt.linedashed_frag},depth:{uniforms:zn([Ue.common,Ue.displacementmap]),vertexShader:vt.depth_vert,fragmentShader:vt.depth_frag},normal:{uniforms:zn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:vt.meshnormal_vert,fragmentShader:vt.meshnormal_frag},sprite:{uniforms:zn([Ue.sprite,Ue.fog]),vertexShader:vt.sprite_vert,fragmentShader:vt.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:vt.background_vert,fragmentShader:vt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:vt.backgroundCube_vert,fragmentShader:vt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:vt.cube_vert,fragmentShader:vt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:vt.equirect_vert,fragmentShader:vt.equirect_frag},distance:{uniforms:zn([Ue.common,Ue.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:vt.distance_vert,fragmentShader:vt.distance_frag},shadow:{uniforms:zn([Ue.lights,Ue.fog,{color:{value:new je(0)},opacity:{value:1}}]),vertexShader:vt.shadow_vert,fragmentShader:vt.shadow_frag}};ss.physical={uniforms:zn([ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new Ve(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ct},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new Ve},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new je(0)},specularColor:{value:new je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new Ve},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag};var yh={r:0,b:0,g:0},fb=new Xt,Wm=new ct;Wm.set(-1,0,0,0,1,0,0,0,1);function pb(i,e,t,n,s,r){let a=new je(0),o=s===!0?0:1,l,c,h=null,d=0,u=null;function p(x){let E=x.isScene===!0?x.background:null;if(E&&E.isTexture){let S=x.backgroundBlurriness>0;E=e.get(E,S)}return E}function g(x){let E=!1,S=p(x);S===null?m(a,o):S&&S.isColor&&(m(S,1),E=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(x,E){let S=p(E);S&&S.isCubeTexture?(c===void 0&&(c=new dn(new ws(1,1,1),new ts({name:"BackgroundCubeMaterial",uniforms:Tr(ss.backgroundCube.uniforms),vertexShader:ss.backgroundCube.vertexShader,fragmentShader:ss.backgroundCube.fragmentShader,side:Kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,w,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(fb.makeRotationFromEuler(E.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Wm),c.material.toneMapped=wt.getTransfer(S.colorSpace)!==Nt,(h!==S||d!==S.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new dn(new Ao(2,2),new ts({name:"BackgroundMaterial",uniforms:Tr(ss.background.uniforms),vertexShader:ss.background.vertexShader,fragmentShader:ss.background.fragmentShader,side:Qs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=wt.getTransfer(S.colorSpace)!==Nt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||d!==S.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=S,d=S.version,u=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,E){x.getRGB(yh,Td(i)),t.buffers.color.setClear(yh.r,yh.g,yh.b,E,r)}function v(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(x,E=1){a.set(x),o=E,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(x){o=x,m(a,o)},render:g,addToRenderList:_,dispose:v}}function mb(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,a=!1;function o(D,L,F,P,G){let Y=!1,X=d(D,P,F,L);r!==X&&(r=X,c(r.object)),Y=p(D,P,F,G),Y&&g(D,P,F,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(Y||a)&&(a=!1,S(D,L,F,P),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function d(D,L,F,P){let G=P.wireframe===!0,Y=n[L.id];Y===void 0&&(Y={},n[L.id]=Y);let X=D.isInstancedMesh===!0?D.id:0,he=Y[X];he===void 0&&(he={},Y[X]=he);let J=he[F.id];J===void 0&&(J={},he[F.id]=J);let ee=J[G];return ee===void 0&&(ee=u(l()),J[G]=ee),ee}function u(D){let L=[],F=[],P=[];for(let G=0;G<t;G++)L[G]=0,F[G]=0,P[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:L,enabledAttributes:F,attributeDivisors:P,object:D,attributes:{},index:null}}function p(D,L,F,P){let G=r.attributes,Y=L.attributes,X=0,he=F.getAttributes();for(let J in he)if(he[J].location>=0){let ne=G[J],ue=Y[J];if(ue===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(ue=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(ue=D.instanceColor)),ne===void 0||ne.attribute!==ue||ue&&ne.data!==ue.data)return!0;X++}return r.attributesNum!==X||r.index!==P}function g(D,L,F,P){let G={},Y=L.attributes,X=0,he=F.getAttributes();for(let J in he)if(he[J].location>=0){let ne=Y[J];ne===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(ne=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(ne=D.instanceColor));let ue={};ue.attribute=ne,ne&&ne.data&&(ue.data=ne.data),G[J]=ue,X++}r.attributes=G,r.attributesNum=X,r.index=P}function _(){let D=r.newAttributes;for(let L=0,F=D.length;L<F;L++)D[L]=0}function m(D){v(D,0)}function v(D,L){let F=r.newAttributes,P=r.enabledAttributes,G=r.attributeDivisors;F[D]=1,P[D]===0&&(i.enableVertexAttribArray(D),P[D]=1),G[D]!==L&&(i.vertexAttribDivisor(D,L),G[D]=L)}function x(){let D=r.newAttributes,L=r.enabledAttributes;for(let F=0,P=L.length;F<P;F++)L[F]!==D[F]&&(i.disableVertexAttribArray(F),L[F]=0)}function E(D,L,F,P,G,Y,X){X===!0?i.vertexAttribIPointer(D,L,F,G,Y):i.vertexAttribPointer(D,L,F,P,G,Y)}function S(D,L,F,P){_();let G=P.attributes,Y=F.getAttributes(),X=L.defaultAttributeValues;for(let he in Y){let J=Y[he];if(J.location>=0){let ee=G[he];if(ee===void 0&&(he==="instanceMatrix"&&D.instanceMatrix&&(ee=D.instanceMatrix),he==="instanceColor"&&D.instanceColor&&(ee=D.instanceColor)),ee!==void 0){let ne=ee.normalized,ue=ee.itemSize,de=e.get(ee);if(de===void 0)continue;let Q=de.buffer,me=de.type,_e=de.bytesPerElement,Te=me===i.INT||me===i.UNSIGNED_INT||ee.gpuType===Fc;if(ee.isInterleavedBufferAttribute){let xe=ee.data,qe=xe.isInterleavedBuffer===!0?xe.stride:xe.itemSize,st=ee.offset;if(xe.isInstancedInterleavedBuffer||xe.isInstancedBufferAttribute){for(let ae=0;ae<J.locationSize;ae++)v(J.location+ae,xe.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=xe.meshPerAttribute*xe.count)}else for(let ae=0;ae<J.locationSize;ae++)m(J.location+ae);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let ae=0;ae<J.locationSize;ae++)E(J.location+ae,ue/J.locationSize,me,ne,qe*_e,(st+ue/J.locationSize*ae)*_e,Te)}else{if(ee.isInstancedBufferAttribute){for(let xe=0;xe<J.locationSize;xe++)v(J.location+xe,ee.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let xe=0;xe<J.locationSize;xe++)m(J.location+xe);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let xe=0;xe<J.locationSize;xe++)E(J.location+xe,ue/J.locationSize,me,ne,ue*_e,ue/J.locationSize*xe*_e,Te)}}else if(X!==void 0){let ne=X[he];if(ne!==void 0)switch(ne.length){case 2:i.vertexAttrib2fv(J.location,ne);break;case 3:i.vertexAttrib3fv(J.location,ne);break;case 4:i.vertexAttrib4fv(J.location,ne);break;default:i.vertexAttrib1fv(J.location,ne)}}}}x()}function R(){k();for(let D in n){let L=n[D];for(let F in L){let P=L[F];for(let G in P){let Y=P[G];for(let X in Y)h(Y[X].object),delete Y[X];delete P[G]}}delete n[D]}}function w(D){if(n[D.id]===void 0)return;let L=n[D.id];for(let F in L){let P=L[F];for(let G in P){let Y=P[G];for(let X in Y)h(Y[X].object),delete Y[X];delete P[G]}}delete n[D.id]}function y(D){for(let L in n){let F=n[L];for(let P in F){let G=F[P];if(G[D.id]===void 0)continue;let Y=G[D.id];for(let X in Y)h(Y[X].object),delete Y[X];delete G[D.id]}}}function A(D){for(let L in n){let F=n[L],P=D.isInstancedMesh===!0?D.id:0,G=F[P];if(G!==void 0){for(let Y in G){let X=G[Y];for(let he in X)h(X[he].object),delete X[he];delete G[Y]}delete F[P],Object.keys(F).length===0&&delete n[L]}}}function k(){U(),a=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:k,resetDefaultState:U,dispose:R,releaseStatesOfGeometry:w,releaseStatesOfObject:A,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:m,disableUnusedAttributes:x}}function gb(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function o(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let p=0;p<h;p++)u+=c[p];t.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function vb(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(y){return!(y!==zi&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(y){let A=y===Bi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==ri&&y!==ki&&!A&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),v=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),E=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:m,maxAttributes:v,maxVertexUniforms:x,maxVaryings:E,maxFragmentUniforms:S,maxSamples:R,samples:w}}function _b(i){let e=this,t=null,n=0,s=!1,r=!1,a=new mi,o=new ct,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let p=d.length!==0||u||n!==0||s;return s=u,n=d.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,p){let g=d.clippingPlanes,_=d.clipIntersection,m=d.clipShadows,v=i.get(d);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let x=r?0:n,E=x*4,S=v.clippingState||null;l.value=S,S=h(g,u,E,p);for(let R=0;R!==E;++R)S[R]=t[R];v.clippingState=S,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(d,u,p,g){let _=d!==null?d.length:0,m=null;if(_!==0){if(m=l.value,g!==!0||m===null){let v=p+_*4,x=u.matrixWorldInverse;o.getNormalMatrix(x),(m===null||m.length<v)&&(m=new Float32Array(v));for(let E=0,S=p;E!==_;++E,S+=4)a.copy(d[E]).applyMatrix4(x,o),a.normal.toArray(m,S),m[S+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,m}}var qo=class extends vi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new So(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ws(5,5,5),r=new ts({name:"CubemapFromEquirect",uniforms:Tr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Kn,blending:Sr});r.uniforms.tEquirect.value=t;let a=new dn(s,r),o=t.minFilter;return t.minFilter===Es&&(t.minFilter=Yn),new xa(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,s);e.setRenderTarget(r)}},Sm=256,xb=3,yb=20,Xm=256,$m=16,bb=3,Sb=new V,Mb=new je,Sh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new xa(1,10,null),this._boxMesh=new dn(new ws(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:a=256,position:o=Sb}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(Mb));let m=new xa(n,s,h);return m.position.copy(o),m.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=p,l.autoClearStencil=g,e.background=_,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Em(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=wm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Sm,Sd(e))}_fromTexture(e,t){e.mapping===wr||e.mapping===Ma?this._setSize(e.image.length===0?Sm:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Mm(e,!1,!1),n=Math.log2(e)-xb;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Mm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===wr||e.mapping===Ma?(this._cubemapMaterial===null&&(this._cubemapMaterial=Em()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=wm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=wb(),this._integrationMaterial=Eb());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/$m);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-bb)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(Xm*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Tb());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Mm(i,e,t){return new qo(i,{minFilter:Es,generateMipmaps:e,type:Bi,colorSpace:fo,depthBuffer:t})}function Yo(i,e,t){return new ts({name:i,uniforms:e,vertexShader:vt.cube_vert,fragmentShader:t,side:Kn,blending:Sr,depthTest:!1,depthWrite:!1})}function wb(){return Yo("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Xm}u

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
	`)}function Eb(){return Yo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:$m}},`

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
	`)}function Tb(){return Yo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${yb}
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
	`)}function wm(){return Yo("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Em(){return Yo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Ab(i){let e=new WeakMap,t=new WeakMap,n=null;function s(u,p=!1){return u==null?null:p?a(u):r(u)}function r(u){if(u&&u.isTexture){let p=u.mapping;if(p===Nc||p===Uc)if(e.has(u)){let g=e.get(u).texture;return o(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let _=new qo(g.height);return _.fromEquirectangularTexture(i,u),e.set(u,_),u.addEventListener("dispose",c),o(_.texture,u.mapping)}else return null}}return u}function a(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let p=u.mapping,g=p===Nc||p===Uc,_=p===wr||p===Ma;if(g||_){let m=t.get(u),v=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==v)return n===null&&(n=new Sh(i)),m=g?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),m.texture;if(m!==void 0)return m.texture;{let x=u.image;return g&&x&&x.height>0||_&&x&&l(x)?(n===null&&(n=new Sh(i)),m=g?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function o(u,p){return p===Nc?u.mapping=wr:p===Uc&&(u.mapping=Ma),u}function l(u){let p=0,g=6;for(let _=0;_<g;_++)u[_]!==void 0&&p++;return p===g}function c(u){let p=u.target;p.removeEventListener("dispose",c);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function h(u){let p=u.target;p.removeEventListener("dispose",h);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function Cb(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&ao("WebGLRenderer: "+n+" extension not supported."),s}}}function Rb(i,e,t,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let _=r.get(g);_&&(e.remove(_),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,_){return s[_.id]!==void 0||(_.addEventListener("dispose",o),s[_.id]=new WeakRef(_),a.register(_,_.id,_),t.memory.geometries++),_}function h(g){let _=g.attributes;for(let m in _)e.update(_[m],i.ARRAY_BUFFER)}function d(g){let _=g.index,m=g.attributes.position,v=0;if(m===void 0)return;let x=_!==null?_.array.length:m.array.length/3-1,E=m.count>=65535?yo:xo,S=new E(Math.ceil(x/3)*6,1),R=S.array;if(_!==null){let y=_.array;v=_.version;for(let A=0,k=0;A<x;A+=3){let U=y[A+0],D=y[A+1],L=y[A+2];R[k++]=U,R[k++]=D,R[k++]=D,R[k++]=L,R[k++]=L,R[k++]=U}}else{v=m.version;for(let y=0,A=0;y<x;y+=3){let k=y+0,U=y+1,D=y+2;R[A++]=k,R[A++]=U,R[A++]=U,R[A++]=D,R[A++]=D,R[A++]=k}}S.version=v;let w=r.get(g);w&&e.remove(w),r.set(g,S)}function u(g){let _=r.get(g);if(_){let m=g.index;m!==null&&_.version<m.version&&d(g)}else d(g);return r.get(g)}function p(){for(let g in s){let _=s[g].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:u,dispose:p}}function Pb(i,e,t){let n;function s(d){n=d}let r,a;function o(d){r=d.type,a=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*a),t.update(u,n,1)}function c(d,u,p){p!==0&&(i.drawElementsInstanced(n,u,r,d*a,p),t.update(u,n,p))}function h(d,u,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,p);let _=0;for(let m=0;m<p;m++)_+=u[m];t.update(_,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function Lb(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(r/3);break;case i.LINES:t.lines+=o*(r/2);break;case i.LINE_STRIP:t.lines+=o*(r-1);break;case i.LINE_LOOP:t.lines+=o*r;break;case i.POINTS:t.points+=o*r;break;default:ot("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function Ib(i,e,t){let n=new WeakMap,s=new tn;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(o);if(u===void 0||u.count!==d){let k=function(){y.dispose(),n.delete(o),o.removeEventListener("dispose",k)};u!==void 0&&u.texture.dispose();let p=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,_=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],v=o.morphAttributes.normal||[],x=o.morphAttributes.color||[],E=0;p===!0&&(E=1),g===!0&&(E=2),_===!0&&(E=3);let S=o.attributes.position.count*E,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let w=new Float32Array(S*R*4*d),y=new go(w,S,R,d);y.type=ki,y.needsUpdate=!0;let A=E*4;for(let U=0;U<d;U++){let D=m[U],L=v[U],F=x[U],P=S*R*4*U;for(let G=0;G<D.count;G++){let Y=G*A;p===!0&&(s.fromBufferAttribute(D,G),w[P+Y+0]=s.x,w[P+Y+1]=s.y,w[P+Y+2]=s.z,w[P+Y+3]=0),g===!0&&(s.fromBufferAttribute(L,G),w[P+Y+4]=s.x,w[P+Y+5]=s.y,w[P+Y+6]=s.z,w[P+Y+7]=0),_===!0&&(s.fromBufferAttribute(F,G),w[P+Y+8]=s.x,w[P+Y+9]=s.y,w[P+Y+10]=s.z,w[P+Y+11]=F.itemSize===4?s.w:1)}}u={count:d,texture:y,size:new Ve(S,R)},n.set(o,u),o.addEventListener("dispose",k)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let p=0;for(let _=0;_<c.length;_++)p+=c[_];let g=o.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function Db(i,e,t,n,s){let r=new WeakMap;function a(c){let h=s.render.frame,d=c.geometry,u=e.get(c,d);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==h&&(p.update(),r.set(p,h))}return u}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}var Nb={[td]:"LINEAR_TONE_MAPPING",[nd]:"REINHARD_TONE_MAPPING",[id]:"CINEON_TONE_MAPPING",[sd]:"ACES_FILMIC_TONE_MAPPING",[ad]:"AGX_TONE_MAPPING",[od]:"NEUTRAL_TONE_MAPPING",[rd]:"CUSTOM_TONE_MAPPING"};function Ub(i,e,t,n,s,r){let a=new vi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new un;h.setAttribute("position",new $t([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new $t([0,2,0,0,2,0],2));let d=new _c({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new dn(h,d),p=new br(-1,1,1,-1,0,1),g=null,_=null,m=!1,v,x=null,E=[],S=!1;this.setSize=function(R,w){a.setSize(R,w),o!==null&&o.setSize(R,w),l!==null&&l.setSize(R,w);for(let y=0;y<E.length;y++){let A=E[y];A.setSize&&A.setSize(R,w)}},this.setEffects=function(R){E=R,S=E.length>0&&E[0].isRenderPass===!0;let w=a.width,y=a.height;E.length>0&&o===null&&(o=new vi(w,y,{type:Bi,depthBuffer:!1,stencilBuffer:!1}),l=new vi(w,y,{type:Bi,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&E.some(k=>k.needsDepthTexture===!0);A!==(a.depthTexture!==null)&&(A===!0&&c===null&&(c=new Ms(w,y),r===!0&&(c.format=Ts,c.type=Er)),a.dispose(),a.depthTexture=A?c:null,a.resolveDepthBuffer=A,a.storeMultisampledDepthBuffer=A);for(let k=0;k<E.length;k++){let U=E[k];U.setSize&&U.setSize(w,y),A&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(R,w){if(m||R.toneMapping===ns&&E.length===0)return!1;if(x=w,w!==null){let y=w.width,A=w.height;(a.width!==y||a.height!==A)&&this.setSize(y,A)}return S===!1&&R.setRenderTarget(a),v=R.toneMapping,R.toneMapping=ns,!0},this.hasRenderPass=function(){return S},this.end=function(R,w){R.toneMapping=v,m=!0;let y=a,A=o;for(let k=0;k<E.length;k++){let U=E[k];U.enabled!==!1&&(U.render(R,A,y,w),U.needsSwap!==!1&&(y=A,A=A===o?l:o))}if(g!==R.outputColorSpace||_!==R.toneMapping){g=R.outputColorSpace,_=R.toneMapping,d.defines={},wt.getTransfer(g)===Nt&&(d.defines.SRGB_TRANSFER="");let k=Nb[_];k&&(d.defines[k]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=y.texture,R.setRenderTarget(x),R.render(u,p),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var qm=new ii,Ym=new Ms(1,1),Zm=new Mo(1),Jm=new go,Km=new rc,jm=new So,Tm=[],Am=[],Cm=new Float32Array(16),Rm=new Float32Array(9),Pm=new Float32Array(4);function Aa(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Tm[s];if(r===void 0&&(r=new Float32Array(s),Tm[s]=r),e!==0){n.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(r,o)}return r}function Sn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Mn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function wh(i,e){let t=Am[e];t===void 0&&(t=new Int32Array(e),Am[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Ob(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function Fb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2fv(this.addr,e),Mn(t,e)}}function kb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;i.uniform3fv(this.addr,e),Mn(t,e)}}function Bb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4fv(this.addr,e),Mn(t,e)}}function zb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;Pm.set(n),i.uniformMatrix2fv(this.addr,!1,Pm),Mn(t,n)}}function Vb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;Rm.set(n),i.uniformMatrix3fv(this.addr,!1,Rm),Mn(t,n)}}function Gb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;Cm.set(n),i.uniformMatrix4fv(this.addr,!1,Cm),Mn(t,n)}}function Hb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Wb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2iv(this.addr,e),Mn(t,e)}}function Xb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;i.uniform3iv(this.addr,e),Mn(t,e)}}function $b(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4iv(this.addr,e),Mn(t,e)}}function qb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function Yb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2uiv(this.addr,e),Mn(t,e)}}function Zb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;i.uniform3uiv(this.addr,e),Mn(t,e)}}function Jb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4uiv(this.addr,e),Mn(t,e)}}function Eh(i){return i.version===0&&(i.compareFunction=_d,i.needsUpdate=!0),i}function Kb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Eh(Ym):r=qm,t.setTexture2D(e||r,s)}function jb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Km,s)}function Qb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Eh(Zm):r=jm,t.setTextureCube(e||r,s)}function eS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Jm,s)}function tS(i){switch(i){case 5126:return Ob;case 35664:return Fb;case 35665:return kb;case 35666:return Bb;case 35674:return zb;case 35675:return Vb;case 35676:return Gb;case 5124:case 35670:return Hb;case 35667:case 35671:return Wb;case 35668:case 35672:return Xb;case 35669:case 35673:return $b;case 5125:return qb;case 36294:return Yb;case 36295:return Zb;case 36296:return Jb;case 35678:case 36198:case 36298:case 36306:case 35682:return Kb;case 35679:case 36299:case 36307:return jb;case 35680:case 36300:case 36308:case 36293:return Qb;case 36289:case 36303:case 36311:case 36292:return eS}}function nS(i,e){i.uniform1fv(this.addr,e)}function iS(i,e){let t=Aa(e,this.size,2);i.uniform2fv(this.addr,t)}function sS(i,e){let t=Aa(e,this.size,3);i.uniform3fv(this.addr,t)}function rS(i,e){let t=Aa(e,this.size,4);i.uniform4fv(this.addr,t)}function aS(i,e){let t=Aa(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function oS(i,e){let t=Aa(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function lS(i,e){let t=Aa(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function cS(i,e){i.uniform1iv(this.addr,e)}function hS(i,e){i.uniform2iv(this.addr,e)}function uS(i,e){i.uniform3iv(this.addr,e)}function dS(i,e){i.uniform4iv(this.addr,e)}function fS(i,e){i.uniform1uiv(this.addr,e)}function pS(i,e){i.uniform2uiv(this.addr,e)}function mS(i,e){i.uniform3uiv(this.addr,e)}function gS(i,e){i.uniform4uiv(this.addr,e)}function vS(i,e,t){let n=this.cache,s=e.length,r=wh(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Eh(Ym):a=qm;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function _S(i,e,t){let n=this.cache,s=e.length,r=wh(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||Km,r[a])}function xS(i,e,t){let n=this.cache,s=e.length,r=wh(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Eh(Zm):a=jm;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function yS(i,e,t){let n=this.cache,s=e.length,r=wh(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||Jm,r[a])}function bS(i){switch(i){case 5126:return nS;case 35664:return iS;case 35665:return sS;case 35666:return rS;case 35674:return aS;case 35675:return oS;case 35676:return lS;case 5124:case 35670:return cS;case 35667:case 35671:return hS;case 35668:case 35672:return uS;case 35669:case 35673:return dS;case 5125:return fS;case 36294:return pS;case 36295:return mS;case 36296:return gS;case 35678:case 36198:case 36298:case 36306:case 35682:return vS;case 35679:case 36299:case 36307:return _S;case 35680:case 36300:case 36308:case 36293:return xS;case 36289:case 36303:case 36311:case 36292:return yS}}var Id=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=tS(t.type)}},Dd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=bS(t.type)}},Nd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],n)}}},Pd=/(\w+)(\])?(\[|\.)?/g;function Lm(i,e){i.seq.push(e),i.map[e.id]=e}function SS(i,e,t){let n=i.name,s=n.length;for(Pd.lastIndex=0;;){let r=Pd.exec(n),a=Pd.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Lm(t,c===void 0?new Id(o,i,e):new Dd(o,i,e));break}else{let d=t.map[o];d===void 0&&(d=new Nd(o),Lm(t,d)),t=d}}}var Ta=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);SS(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&n.push(a)}return n}};function Im(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var MS=37297,wS=0;function ES(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}var Dm=new ct;function TS(i){wt._getMatrix(Dm,wt.workingColorSpace,i);let e=`mat3( ${Dm.elements.map(t=>t.toFixed(4))} )`;switch(wt.getTransfer(i)){case po:return[e,"LinearTransferOETF"];case Nt:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Nm(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+ES(i.getShaderSource(e),o)}else return r}function AS(i,e){let t=TS(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var CS={[td]:"Linear",[nd]:"Reinhard",[id]:"Cineon",[sd]:"ACESFilmic",[ad]:"AgX",[od]:"Neutral",[rd]:"Custom"};function RS(i,e){let t=CS[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var bh=new V;function PS(){wt.getLuminanceCoefficients(bh);let i=bh.x.toFixed(4),e=bh.y.toFixed(4),t=bh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function LS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter($o).join(`
`)}function IS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function DS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function $o(i){return i!==""}function Um(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Om(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var NS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ud(i){return i.replace(NS,US)}function US(i,e){let t=vt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Ud(t)}var OS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Fm(i){return i.replace(OS,FS)}function FS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function km(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var kS={[Fo]:"SHADOWMAP_TYPE_PCF",[ba]:"SHADOWMAP_TYPE_VSM"};function BS(i){return kS[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var zS={[Ma]:"ENVMAP_MODE_REFRACTION"};function VS(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":zS[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var GS={[Dc]:"ENVMAP_BLENDING_MULTIPLY",[em]:"ENVMAP_BLENDING_MIX",[tm]:"ENVMAP_BLENDING_ADD"};function HS(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":GS[i.combine]||"ENVMAP_BLENDING_NONE"}function WS(i,e,t,n){let s=i.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,l=BS(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=VS(t),d=HS(t),u=LS(t),p=IS(r),g=s.createProgram(),_,m,v=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter($o).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter($o).join(`
`),m.length>0&&(m+=`
`)):(_=[km(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter($o).join(`
`),m=[km(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ns?"#define TONE_MAPPING":"",t.toneMapping!==ns?vt.tonemapping_pars_fragment:"",t.toneMapping!==ns?RS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",vt.colorspace_pars_fragment,AS("linearToOutputTexel",t.outputColorSpace),PS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter($o).join(`
`)),a=Ud(a),a=Um(a,t),a=Om(a,t),o=Ud(o),o=Um(o,t),o=Om(o,t),a=Fm(a),o=Fm(o),t.isRawShaderMaterial!==!0&&(v=`#version 300 es
`,_=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",t.glslVersion===xd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===xd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=v+_+a,E=v+m+o,S=Im(s,s.VERTEX_SHADER,x),R=Im(s,s.FRAGMENT_SHADER,E);s.attachShader(g,S),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function w(U){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",L=s.getShaderInfoLog(S)||"",F=s.getShaderInfoLog(R)||"",P=D.trim(),G=L.trim(),Y=F.trim(),X=!0,he=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(X=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,S,R);else{let J=Nm(s,S,"vertex"),ee=Nm(s,R,"fragment");ot("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+P+`
`+J+`
`+ee)}else P!==""?Ke("WebGLProgram: Program Info Log:",P):(G===""||Y==="")&&(he=!1);he&&(U.diagnostics={runnable:X,programLog:P,vertexShader:{log:G,prefix:_},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(S),s.deleteShader(R),y=new Ta(s,g),A=DS(s,g)}let y;this.getUniforms=function(){return y===void 0&&w(this),y};let A;this.getAttributes=function(){return A===void 0&&w(this),A};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(g,MS)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=wS++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=R,this}var XS=0,Od=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Fd(e),t.set(e,n)),n}},Fd=class{constructor(e){this.id=XS++,this.code=e,this.usedTimes=0}};function $S(i){return i===er||i===Ho||i===Wo}function qS(i,e,t,n,s,r){let a=new vo,o=new Od,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(y){return l.add(y),y===0?"uv":`uv${y}`}function g(y,A,k,U,D,L){let F=U.fog,P=D.geometry,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?U.environment:null,Y=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,X=e.get(y.envMap||G,Y),he=u[y.type],J=n.precision;y.precision!==null&&(J=n.getMaxPrecision(y.precision),J!==y.precision&&Ke("WebGLProgram.getParameters:",y.precision,"not supported, using",J,"instead."));let ee=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,ne=ee!==void 0?ee.length:0,ue=0;P.morphAttributes.position!==void 0&&(ue=1),P.morphAttributes.normal!==void 0&&(ue=2),P.morphAttributes.color!==void 0&&(ue=3);let de,Q,me,_e;if(he){let Le=ss[he];de=Le.vertexShader,Q=Le.fragmentShader}else{de=y.vertexShader,Q=y.fragmentShader;let Le=o.getVertexShaderStage(y),dt=o.getFragmentShaderStage(y);o.update(y,Le,dt),me=Le.id,_e=dt.id}let Te=i.getRenderTarget(),xe=i.state.buffers.depth.getReversed(),qe=D.isInstancedMesh===!0,st=D.isBatchedMesh===!0,ae=!!y.map,Xe=!!y.matcap,tt=!!X,rt=tt&&X.isPMREMTexture===!0,pt=!!y.aoMap,Pt=!!y.lightMap,qt=!!y.bumpMap&&y.wireframe===!1,Tt=!!y.normalMap,sn=!!y.displacementMap,lt=!!y.emissiveMap,Bt=!!y.metalnessMap,Wt=!!y.roughnessMap,fn=y.anisotropy>0,z=y.clearcoat>0,Ie=y.diffuseRoughness>0,Qe=y.dispersion>0,ut=y.retroreflectivity>0,Ae=y.iridescence>0,Vt=y.sheen>0,$e=y.transmission>0,Je=fn&&!!y.anisotropyMap,I=z&&!!y.clearcoatMap,M=z&&!!y.clearcoatNormalMap,q=z&&!!y.clearcoatRoughnessMap,pe=Ie&&!!y.diffuseRoughnessMap,le=Ae&&!!y.iridescenceMap,be=Ae&&!!y.iridescenceThicknessMap,Se=Vt&&!!y.sheenColorMap,ie=Vt&&!!y.sheenRoughnessMap,re=!!y.specularMap,ve=!!y.specularColorMap,B=!!y.specularIntensityMap,oe=$e&&!!y.transmissionMap,se=$e&&!!y.thicknessMap,Ce=!!y.gradientMap,ye=!!y.alphaMap,we=y.alphaTest>0,Ye=!!y.alphaHash,nt=!!y.extensions,fe=ns;y.toneMapped&&(Te===null||Te.isXRRenderTarget===!0)&&(fe=i.toneMapping);let Ge=rt?X.isCompressedCubeTexture?X.image[0].mipmaps:X.mipmaps:null,it={shaderID:he,shaderType:y.type,shaderName:y.name,vertexShader:de,fragmentShader:Q,defines:y.defines,customVertexShaderID:me,customFragmentShaderID:_e,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:J,batching:st,batchingColor:st&&D._colorsTexture!==null,instancing:qe,instancingColor:qe&&D.instanceColor!==null,instancingMorph:qe&&D.morphTexture!==null,outputColorSpace:Te===null?i.outputColorSpace:Te.isXRRenderTarget===!0?Te.texture.colorSpace:wt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:ae,matcap:Xe,envMap:tt,envMapMode:tt&&X.mapping,envMapPMREM:rt,envMapMaxLod:rt?Ge.length-1:null,envMapSize:rt?Ge[0].width:null,aoMap:pt,lightMap:Pt,bumpMap:qt,normalMap:Tt,displacementMap:sn,emissiveMap:lt,normalMapObjectSpace:Tt&&y.normalMapType===sm,normalMapTangentSpace:Tt&&y.normalMapType===xh,packedNormalMap:Tt&&y.normalMapType===xh&&$S(y.normalMap.format),metalnessMap:Bt,roughnessMap:Wt,anisotropy:fn,anisotropyMap:Je,clearcoat:z,clearcoatMap:I,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Ie,diffuseRoughnessMap:pe,dispersion:Qe,retroreflection:ut,iridescence:Ae,iridescenceMap:le,iridescenceThicknessMap:be,sheen:Vt,sheenColorMap:Se,sheenRoughnessMap:ie,specularMap:re,specularColorMap:ve,specularIntensityMap:B,transmission:$e,transmissionMap:oe,thicknessMap:se,gradientMap:Ce,opaque:y.transparent===!1&&y.blending===Sa&&y.alphaToCoverage===!1,alphaMap:ye,alphaTest:we,alphaHash:Ye,combine:y.combine,mapUv:ae&&p(y.map.channel),aoMapUv:pt&&p(y.aoMap.channel),lightMapUv:Pt&&p(y.lightMap.channel),bumpMapUv:qt&&p(y.bumpMap.channel),normalMapUv:Tt&&p(y.normalMap.channel),displacementMapUv:sn&&p(y.displacementMap.channel),emissiveMapUv:lt&&p(y.emissiveMap.channel),metalnessMapUv:Bt&&p(y.metalnessMap.channel),roughnessMapUv:Wt&&p(y.roughnessMap.channel),anisotropyMapUv:Je&&p(y.anisotropyMap.channel),clearcoatMapUv:I&&p(y.clearcoatMap.channel),clearcoatNormalMapUv:M&&p(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&p(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pe&&p(y.diffuseRoughnessMap.channel),iridescenceMapUv:le&&p(y.iridescenceMap.channel),iridescenceThicknessMapUv:be&&p(y.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&p(y.sheenColorMap.channel),sheenRoughnessMapUv:ie&&p(y.sheenRoughnessMap.channel),specularMapUv:re&&p(y.specularMap.channel),specularColorMapUv:ve&&p(y.specularColorMap.channel),specularIntensityMapUv:B&&p(y.specularIntensityMap.channel),transmissionMapUv:oe&&p(y.transmissionMap.channel),thicknessMapUv:se&&p(y.thicknessMap.channel),alphaMapUv:ye&&p(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(Tt||fn),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!P.attributes.uv&&(ae||ye),fog:!!F,useFog:y.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&Tt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:xe,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:ue,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:L.filter(Le=>Le.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:fe,decodeVideoTexture:ae&&y.map.isVideoTexture===!0&&wt.getTransfer(y.map.colorSpace)===Nt,decodeVideoTextureEmissive:lt&&y.emissiveMap.isVideoTexture===!0&&wt.getTransfer(y.emissiveMap.colorSpace)===Nt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===si,flipSided:y.side===Kn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:nt&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(nt&&y.extensions.multiDraw===!0||st)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return it.vertexUv1s=l.has(1),it.vertexUv2s=l.has(2),it.vertexUv3s=l.has(3),l.clear(),it}function _(y){let A=[];if(y.shaderID?A.push(y.shaderID):(A.push(y.customVertexShaderID),A.push(y.customFragmentShaderID)),y.defines!==void 0)for(let k in y.defines)A.push(k),A.push(y.defines[k]);return y.isRawShaderMaterial===!1&&(m(A,y),v(A,y),A.push(i.outputColorSpace)),A.push(y.customProgramCacheKey),A.join()}function m(y,A){y.push(A.precision),y.push(A.outputColorSpace),y.push(A.envMapMode),y.push(A.envMapPMREM),y.push(A.envMapMaxLod),y.push(A.envMapSize),y.push(A.mapUv),y.push(A.alphaMapUv),y.push(A.lightMapUv),y.push(A.aoMapUv),y.push(A.bumpMapUv),y.push(A.normalMapUv),y.push(A.displacementMapUv),y.push(A.emissiveMapUv),y.push(A.metalnessMapUv),y.push(A.roughnessMapUv),y.push(A.anisotropyMapUv),y.push(A.clearcoatMapUv),y.push(A.clearcoatNormalMapUv),y.push(A.clearcoatRoughnessMapUv),y.push(A.diffuseRoughnessMapUv),y.push(A.iridescenceMapUv),y.push(A.iridescenceThicknessMapUv),y.push(A.sheenColorMapUv),y.push(A.sheenRoughnessMapUv),y.push(A.specularMapUv),y.push(A.specularColorMapUv),y.push(A.specularIntensityMapUv),y.push(A.transmissionMapUv),y.push(A.thicknessMapUv),y.push(A.combine),y.push(A.fogExp2),y.push(A.sizeAttenuation),y.push(A.morphTargetsCount),y.push(A.numSunLights),y.push(A.numDirLights),y.push(A.numPointLights),y.push(A.numSpotLights),y.push(A.numSpotLightMaps),y.push(A.numHemiLights),y.push(A.numRectAreaLights),y.push(A.numSunLightShadows),y.push(A.numDirLightShadows),y.push(A.numPointLightShadows),y.push(A.numSpotLightShadows),y.push(A.numSpotLightShadowsWithMaps),y.push(A.numLightProbes),y.push(A.numLightProbeGrids),y.push(A.shadowMapType),y.push(A.toneMapping),y.push(A.numClippingPlanes),y.push(A.numClipIntersection),y.push(A.depthPacking)}function v(y,A){a.disableAll(),A.instancing&&a.enable(0),A.instancingColor&&a.enable(1),A.instancingMorph&&a.enable(2),A.matcap&&a.enable(3),A.envMap&&a.enable(4),A.normalMapObjectSpace&&a.enable(5),A.normalMapTangentSpace&&a.enable(6),A.clearcoat&&a.enable(7),A.iridescence&&a.enable(8),A.alphaTest&&a.enable(9),A.vertexColors&&a.enable(10),A.vertexAlphas&&a.enable(11),A.vertexUv1s&&a.enable(12),A.vertexUv2s&&a.enable(13),A.vertexUv3s&&a.enable(14),A.vertexTangents&&a.enable(15),A.anisotropy&&a.enable(16),A.alphaHash&&a.enable(17),A.batching&&a.enable(18),A.dispersion&&a.enable(19),A.retroreflection&&a.enable(24),A.diffuseRoughness&&a.enable(25),A.batchingColor&&a.enable(20),A.gradientMap&&a.enable(21),A.packedNormalMap&&a.enable(22),A.vertexNormals&&a.enable(23),y.push(a.mask),a.disableAll(),A.fog&&a.enable(0),A.useFog&&a.enable(1),A.flatShading&&a.enable(2),A.logarithmicDepthBuffer&&a.enable(3),A.reversedDepthBuffer&&a.enable(4),A.skinning&&a.enable(5),A.morphTargets&&a.enable(6),A.morphNormals&&a.enable(7),A.morphColors&&a.enable(8),A.premultipliedAlpha&&a.enable(9),A.shadowMapEnabled&&a.enable(10),A.doubleSided&&a.enable(11),A.flipSided&&a.enable(12),A.useDepthPacking&&a.enable(13),A.dithering&&a.enable(14),A.transmission&&a.enable(15),A.sheen&&a.enable(16),A.opaque&&a.enable(17),A.pointsUvs&&a.enable(18),A.decodeVideoTexture&&a.enable(19),A.decodeVideoTextureEmissive&&a.enable(20),A.alphaToCoverage&&a.enable(21),A.numLightProbeGrids>0&&a.enable(22),A.hasPositionAttribute&&a.enable(23),y.push(a.mask)}function x(y){let A=u[y.type],k;if(A){let U=ss[A];k=xm.clone(U.uniforms)}else k=y.uniforms;return k}function E(y,A){let k=h.get(A);return k!==void 0?++k.usedTimes:(k=new WS(i,A,y,s),c.push(k),h.set(A,k)),k}function S(y){if(--y.usedTimes===0){let A=c.indexOf(y);c[A]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function R(y){o.remove(y)}function w(){o.dispose()}return{getParameters:g,getProgramCacheKey:_,getUniforms:x,acquireProgram:E,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:w}}function YS(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function ZS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Bm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function zm(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function a(u){let p=0;return u.isInstancedMesh&&(p+=2),u.isSkinnedMesh&&(p+=1),p}function o(u,p,g,_,m,v){let x=i[e];return x===void 0?(x={id:u.id,object:u,geometry:p,material:g,materialVariant:a(u),groupOrder:_,renderOrder:u.renderOrder,z:m,group:v},i[e]=x):(x.id=u.id,x.object=u,x.geometry=p,x.material=g,x.materialVariant=a(u),x.groupOrder=_,x.renderOrder=u.renderOrder,x.z=m,x.group=v),e++,x}function l(u,p,g,_,m,v,x){x.reversedDepth===!0&&(m=-m);let E=o(u,p,g,_,m,v);g.transmission>0?n.push(E):g.transparent===!0?s.push(E):t.push(E)}function c(u,p,g,_,m,v){let x=o(u,p,g,_,m,v);g.transmission>0?n.unshift(x):g.transparent===!0?s.unshift(x):t.unshift(x)}function h(u,p){t.length>1&&t.sort(u||ZS),n.length>1&&n.sort(p||Bm),s.length>1&&s.sort(p||Bm)}function d(){for(let u=e,p=i.length;u<p;u++){let g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function JS(){let i=new WeakMap;function e(n,s){let r=i.get(n),a;return r===void 0?(a=new zm,i.set(n,[a])):s>=r.length?(a=new zm,r.push(a)):a=r[s],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function KS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new V,color:new je};break;case"SpotLight":t={position:new V,direction:new V,color:new je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new V,color:new je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new V,skyColor:new je,groundColor:new je};break;case"RectAreaLight":t={color:new je,position:new V,halfWidth:new V,halfHeight:new V};break}return i[e.id]=t,t}}}function jS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ve};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ve};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ve,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var QS=0;function eM(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function tM(i){let e=new KS,t=jS(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new V);let s=new V,r=new Xt,a=new Xt;function o(c){let h=0,d=0,u=0;for(let L=0;L<9;L++)n.probe[L].set(0,0,0);let p=0,g=0,_=0,m=0,v=0,x=0,E=0,S=0,R=0,w=0,y=0,A=0,k=0,U=0;c.sort(eM);for(let L=0,F=c.length;L<F;L++){let P=c[L],G=P.color,Y=P.intensity,X=P.distance,he=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===er?he=P.shadow.map.texture:he=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=G.r*Y,d+=G.g*Y,u+=G.b*Y;else if(P.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(P.sh.coefficients[J],Y);U++}else if(P.isSunLight){let J=e.get(P);if(J.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let ee=P.shadow,ne=t.get(P);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),n.sunShadow[g]=ne,n.sunShadowMap[g]=he;let ue=ee.getViewportCount();for(let de=0;de<ue;de++)n.sunShadowMatrix[_+de]=ee.getMatrix(de),n.sunShadowCascade[_+de]=ee._cascadeData[de];_+=ue,g++}n.sun[p]=J,p++}else if(P.isDirectionalLight){let J=e.get(P);if(J.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let ee=P.shadow,ne=t.get(P);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize=ee.mapSize,n.directionalShadow[m]=ne,n.directionalShadowMap[m]=he,n.directionalShadowMatrix[m]=P.shadow.matrix,R++}n.directional[m]=J,m++}else if(P.isSpotLight){let J=e.get(P);J.position.setFromMatrixPosition(P.matrixWorld),J.color.copy(G).multiplyScalar(Y),J.distance=X,J.coneCos=Math.cos(P.angle),J.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),J.decay=P.decay,n.spot[x]=J;let ee=P.shadow;if(P.map&&(n.spotLightMap[A]=P.map,A++,ee.updateMatrices(P),P.castShadow&&k++),n.spotLightMatrix[x]=ee.matrix,P.castShadow){let ne=t.get(P);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize=ee.mapSize,n.spotShadow[x]=ne,n.spotShadowMap[x]=he,y++}x++}else if(P.isRectAreaLight){let J=e.get(P);J.color.copy(G).multiplyScalar(Y),J.halfWidth.set(P.width*.5,0,0),J.halfHeight.set(0,P.height*.5,0),n.rectArea[E]=J,E++}else if(P.isPointLight){let J=e.get(P);if(J.color.copy(P.color).multiplyScalar(P.intensity),J.distance=P.distance,J.decay=P.decay,P.castShadow){let ee=P.shadow,ne=t.get(P);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize=ee.mapSize,ne.shadowCameraNear=ee.camera.near,ne.shadowCameraFar=ee.camera.far,n.pointShadow[v]=ne,n.pointShadowMap[v]=he,n.pointShadowMatrix[v]=P.shadow.matrix,w++}n.point[v]=J,v++}else if(P.isHemisphereLight){let J=e.get(P);J.skyColor.copy(P.color).multiplyScalar(Y),J.groundColor.copy(P.groundColor).multiplyScalar(Y),n.hemi[S]=J,S++}}E>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ue.LTC_FLOAT_1,n.rectAreaLTC2=Ue.LTC_FLOAT_2):(n.rectAreaLTC1=Ue.LTC_HALF_1,n.rectAreaLTC2=Ue.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let D=n.hash;(D.sunLength!==p||D.directionalLength!==m||D.pointLength!==v||D.spotLength!==x||D.rectAreaLength!==E||D.hemiLength!==S||D.numSunShadows!==g||D.numDirectionalShadows!==R||D.numPointShadows!==w||D.numSpotShadows!==y||D.numSpotMaps!==A||D.numLightProbes!==U)&&(n.sun.length=p,n.directional.length=m,n.spot.length=x,n.rectArea.length=E,n.point.length=v,n.hemi.length=S,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+A-k,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=U,D.sunLength=p,D.directionalLength=m,D.pointLength=v,D.spotLength=x,D.rectAreaLength=E,D.hemiLength=S,D.numSunShadows=g,D.numDirectionalShadows=R,D.numPointShadows=w,D.numSpotShadows=y,D.numSpotMaps=A,D.numLightProbes=U,n.version=QS++)}function l(c,h){let d=0,u=0,p=0,g=0,_=0,m=0,v=h.matrixWorldInverse;for(let x=0,E=c.length;x<E;x++){let S=c[x];if(S.isSunLight){let R=n.sun[d];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(v),d++}else if(S.isDirectionalLight){let R=n.directional[u];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(v),u++}else if(S.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(v),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(v),g++}else if(S.isRectAreaLight){let R=n.rectArea[_];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(v),a.identity(),r.copy(S.matrixWorld),r.premultiply(v),a.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(a),R.halfHeight.applyMatrix4(a),_++}else if(S.isPointLight){let R=n.point[p];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(v),p++}else if(S.isHemisphereLight){let R=n.hemi[m];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(v),m++}}}return{setup:o,setupView:l,state:n}}function Vm(i){let e=new tM(i),t=[],n=[],s=[];function r(d){h.camera=d,t.length=0,n.length=0,s.length=0}function a(d){d.isLightProbeGrid?s.push(d):t.push(d)}function o(d){n.push(d)}function l(){e.setup(t),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function nM(i){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new Vm(i),e.set(s,[o])):r>=a.length?(o=new Vm(i),a.push(o)):o=a[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}var iM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,sM=`uniform sampler2D shadow_pass;
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
}`,rM=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],aM=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],Gm=new Xt,Xo=new V,Ld=new V;function oM(i,e,t){let n=new qs,s=new Ve,r=new Ve,a=new tn,o=new xc,l=new yc,c={},h=t.maxTextureSize,d={[Qs]:Kn,[Kn]:Qs,[si]:si},u=new ts({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ve},radius:{value:4}},vertexShader:iM,fragmentShader:sM}),p=u.clone();p.defines.HORIZONTAL_PASS=1;let g=new un;g.setAttribute("position",new ni(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new dn(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Fo;let v=this.type;this.render=function(w,y,A){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===Up&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Fo);let k=i.getRenderTarget(),U=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),L=i.state;L.setBlending(Sr),L.buffers.depth.getReversed()===!0?L.buffers.color.setClear(0,0,0,0):L.buffers.color.setClear(1,1,1,1),L.buffers.depth.setTest(!0),L.setScissorTest(!1);let F=v!==this.type;F&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(G=>G.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,G=w.length;P<G;P++){let Y=w[P],X=Y.shadow;if(X===void 0){Ke("WebGLShadowMap:",Y,"has no shadow.");continue}if(X.autoUpdate===!1&&X.needsUpdate===!1)continue;s.copy(X.mapSize);let he=X.getFrameExtents();s.multiply(he),r.copy(X.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/he.x),s.x=r.x*he.x,X.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/he.y),s.y=r.y*he.y,X.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(X.camera._reversedDepth=J,X.map===null||F===!0){if(X.map!==null&&(X.map.depthTexture!==null&&(X.map.depthTexture.dispose(),X.map.depthTexture=null),X.map.dispose()),this.type===ba){if(Y.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}X.map=new vi(s.x,s.y,{format:er,type:Bi,minFilter:Yn,magFilter:Yn,generateMipmaps:!1}),X.map.texture.name=Y.name+".shadowMap",X.map.depthTexture=new Ms(s.x,s.y,ki),X.map.depthTexture.name=Y.name+".shadowMapDepth",X.map.depthTexture.format=_s,X.map.depthTexture.compareFunction=null,X.map.depthTexture.minFilter=In,X.map.depthTexture.magFilter=In}else Y.isPointLight?(X.map=new qo(s.x),X.map.depthTexture=new Mo(s.x,Fi)):(X.map=new vi(s.x,s.y),X.map.depthTexture=new Ms(s.x,s.y,Fi)),X.map.depthTexture.name=Y.name+".shadowMap",X.map.depthTexture.format=_s,this.type===Fo?(X.map.depthTexture.compareFunction=J?vd:gd,X.map.depthTexture.minFilter=Yn,X.map.depthTexture.magFilter=Yn):(X.map.depthTexture.compareFunction=null,X.map.depthTexture.minFilter=In,X.map.depthTexture.magFilter=In);X.camera.updateProjectionMatrix()}X.map.isWebGLCubeRenderTarget!==!0&&(X.map.width!==s.x||X.map.height!==s.y)&&X.map.setSize(s.x,s.y);let ee=X.map.isWebGLCubeRenderTarget?6:X.getViewportCount();Y.isPointLight!==!0&&X.updateMatrices(Y,A);let ne=(X.camera.layers.mask&4294967294)!==0?X.camera.layers:A.layers;for(let ue=0;ue<ee;ue++){let de=X.getCamera(ue);if(Y.isPointLight){let Q=X.camera,me=X.matrix,_e=Y.distance||Q.far;_e!==Q.far&&(Q.far=_e,Q.updateProjectionMatrix()),Xo.setFromMatrixPosition(Y.matrixWorld),Q.position.copy(Xo),Ld.copy(Q.position),Ld.add(rM[ue]),Q.up.copy(aM[ue]),Q.lookAt(Ld),Q.updateMatrixWorld(),me.makeTranslation(-Xo.x,-Xo.y,-Xo.z),Gm.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),X._frustum.setFromProjectionMatrix(Gm,Q.coordinateSystem,Q.reversedDepth)}if(X.map.isWebGLCubeRenderTarget)i.setRenderTarget(X.map,ue),i.clear();else{ue===0&&(i.setRenderTarget(X.map),i.clear());let Q=X.getViewport(ue);a.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),L.viewport(a)}n=X.getFrustum(ue),S(y,A,de,Y,ne,this.type)}X.isPointLightShadow!==!0&&this.type===ba&&x(X,A),X.needsUpdate=!1}v=this.type,m.needsUpdate=!1,i.setRenderTarget(k,U,D)};function x(w,y){let A=e.update(_);u.defines.VSM_SAMPLES!==w.blurSamples&&(u.defines.VSM_SAMPLES=w.blurSamples,p.defines.VSM_SAMPLES=w.blurSamples,u.needsUpdate=!0,p.needsUpdate=!0),w.mapPass===null?w.mapPass=new vi(s.x,s.y,{format:er,type:Bi}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),u.uniforms.shadow_pass.value=w.map.depthTexture,u.uniforms.resolution.value.set(w.map.width,w.map.height),u.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(y,null,A,u,_,null),p.uniforms.shadow_pass.value=w.mapPass.texture,p.uniforms.resolution.value.set(w.map.width,w.map.height),p.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(y,null,A,p,_,null)}function E(w,y,A,k){let U=null,D=A.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(D!==void 0)U=D;else if(U=A.isPointLight===!0?l:o,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let L=U.uuid,F=y.uuid,P=c[L];P===void 0&&(P={},c[L]=P);let G=P[F];G===void 0&&(G=U.clone(),P[F]=G,y.addEventListener("dispose",R)),U=G}if(U.visible=y.visible,U.wireframe=y.wireframe,k===ba?U.side=y.shadowSide!==null?y.shadowSide:y.side:U.side=y.shadowSide!==null?y.shadowSide:d[y.side],U.alphaMap=y.alphaMap,U.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,U.map=y.map,U.clipShadows=y.clipShadows,U.clippingPlanes=y.clippingPlanes,U.clipIntersection=y.clipIntersection,U.displacementMap=y.displacementMap,U.displacementScale=y.displacementScale,U.displacementBias=y.displacementBias,U.wireframeLinewidth=y.wireframeLinewidth,U.linewidth=y.linewidth,A.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let L=i.properties.get(U);L.light=A}return U}function S(w,y,A,k,U,D){if(w.visible===!1)return;if(w.layers.test(U)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&D===ba)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,w.matrixWorld);let P=e.update(w),G=w.material;if(Array.isArray(G)){let Y=P.groups;for(let X=0,he=Y.length;X<he;X++){let J=Y[X],ee=G[J.materialIndex];if(ee&&ee.visible){let ne=E(w,ee,k,D);w.onBeforeShadow(i,w,y,A,P,ne,J),i.renderBufferDirect(A,null,P,ne,w,J),w.onAfterShadow(i,w,y,A,P,ne,J)}}}else if(G.visible){let Y=E(w,G,k,D);w.onBeforeShadow(i,w,y,A,P,Y,null),i.renderBufferDirect(A,null,P,Y,w,null),w.onAfterShadow(i,w,y,A,P,Y,null)}}let F=w.children;for(let P=0,G=F.length;P<G;P++)S(F[P],y,A,k,U,D)}function R(w){w.target.removeEventListener("dispose",R);for(let A in c){let k=c[A],U=w.target.uuid;U in k&&(k[U].dispose(),delete k[U])}}}function lM(i,e){function t(){let B=!1,oe=new tn,se=null,Ce=new tn(0,0,0,0);return{setMask:function(ye){se!==ye&&!B&&(i.colorMask(ye,ye,ye,ye),se=ye)},setLocked:function(ye){B=ye},setClear:function(ye,we,Ye,nt,fe){fe===!0&&(ye*=nt,we*=nt,Ye*=nt),oe.set(ye,we,Ye,nt),Ce.equals(oe)===!1&&(i.clearColor(ye,we,Ye,nt),Ce.copy(oe))},reset:function(){B=!1,se=null,Ce.set(-1,0,0,0)}}}function n(){let B=!1,oe=!1,se=null,Ce=null,ye=null;return{setReversed:function(we){if(oe!==we){let Ye=e.get("EXT_clip_control");we?Ye.clipControlEXT(Ye.LOWER_LEFT_EXT,Ye.ZERO_TO_ONE_EXT):Ye.clipControlEXT(Ye.LOWER_LEFT_EXT,Ye.NEGATIVE_ONE_TO_ONE_EXT),oe=we;let nt=ye;ye=null,this.setClear(nt)}},getReversed:function(){return oe},setTest:function(we){we?xe(i.DEPTH_TEST):qe(i.DEPTH_TEST)},setMask:function(we){se!==we&&!B&&(i.depthMask(we),se=we)},setFunc:function(we){if(oe&&(we=mm[we]),Ce!==we){switch(we){case ql:i.depthFunc(i.NEVER);break;case Yl:i.depthFunc(i.ALWAYS);break;case Zl:i.depthFunc(i.LESS);break;case ua:i.depthFunc(i.LEQUAL);break;case Jl:i.depthFunc(i.EQUAL);break;case Kl:i.depthFunc(i.GEQUAL);break;case jl:i.depthFunc(i.GREATER);break;case Ql:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ce=we}},setLocked:function(we){B=we},setClear:function(we){ye!==we&&(ye=we,oe&&(we=1-we),i.clearDepth(we))},reset:function(){B=!1,se=null,Ce=null,ye=null,oe=!1}}}function s(){let B=!1,oe=null,se=null,Ce=null,ye=null,we=null,Ye=null,nt=null,fe=null;return{setTest:function(Ge){B||(Ge?xe(i.STENCIL_TEST):qe(i.STENCIL_TEST))},setMask:function(Ge){oe!==Ge&&!B&&(i.stencilMask(Ge),oe=Ge)},setFunc:function(Ge,it,Le){(se!==Ge||Ce!==it||ye!==Le)&&(i.stencilFunc(Ge,it,Le),se=Ge,Ce=it,ye=Le)},setOp:function(Ge,it,Le){(we!==Ge||Ye!==it||nt!==Le)&&(i.stencilOp(Ge,it,Le),we=Ge,Ye=it,nt=Le)},setLocked:function(Ge){B=Ge},setClear:function(Ge){fe!==Ge&&(i.clearStencil(Ge),fe=Ge)},reset:function(){B=!1,oe=null,se=null,Ce=null,ye=null,we=null,Ye=null,nt=null,fe=null}}}let r=new t,a=new n,o=new s,l={},c=new WeakMap,h={},d={},u={},p=new WeakMap,g=[],_=null,m=!1,v=null,x=null,E=null,S=null,R=null,w=null,y=null,A=new je(0,0,0),k=0,U=!1,D=null,L=null,F=null,P=null,G=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),X=!1,he=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(he=parseFloat(/^WebGL (\d)/.exec(J)[1]),X=he>=1):J.indexOf("OpenGL ES")!==-1&&(he=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),X=he>=2);let ee=null,ne={},ue=i.getParameter(i.SCISSOR_BOX),de=i.getParameter(i.VIEWPORT),Q=new tn().fromArray(ue),me=new tn().fromArray(de);function _e(B,oe,se,Ce){let ye=new Uint8Array(4),we=i.createTexture();i.bindTexture(B,we),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ye=0;Ye<se;Ye++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(oe,0,i.RGBA,1,1,Ce,0,i.RGBA,i.UNSIGNED_BYTE,ye):i.texImage2D(oe+Ye,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ye);return we}let Te={};Te[i.TEXTURE_2D]=_e(i.TEXTURE_2D,i.TEXTURE_2D,1),Te[i.TEXTURE_CUBE_MAP]=_e(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Te[i.TEXTURE_2D_ARRAY]=_e(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Te[i.TEXTURE_3D]=_e(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),xe(i.DEPTH_TEST),a.setFunc(ua),qt(!1),Tt(Zu),xe(i.CULL_FACE),pt(Sr);function xe(B){h[B]!==!0&&(i.enable(B),h[B]=!0)}function qe(B){h[B]!==!1&&(i.disable(B),h[B]=!1)}function st(B,oe){return u[B]!==oe?(i.bindFramebuffer(B,oe),u[B]=oe,B===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=oe),B===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=oe),!0):!1}function ae(B,oe){let se=g,Ce=!1;if(B){se=p.get(oe),se===void 0&&(se=[],p.set(oe,se));let ye=B.textures;if(se.length!==ye.length||se[0]!==i.COLOR_ATTACHMENT0){for(let we=0,Ye=ye.length;we<Ye;we++)se[we]=i.COLOR_ATTACHMENT0+we;se.length=ye.length,Ce=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,Ce=!0);Ce&&i.drawBuffers(se)}function Xe(B){return _!==B?(i.useProgram(B),_=B,!0):!1}let tt={[Mr]:i.FUNC_ADD,[Fp]:i.FUNC_SUBTRACT,[kp]:i.FUNC_REVERSE_SUBTRACT};tt[Bp]=i.MIN,tt[zp]=i.MAX;let rt={[Vp]:i.ZERO,[Gp]:i.ONE,[Hp]:i.SRC_COLOR,[Qu]:i.SRC_ALPHA,[Zp]:i.SRC_ALPHA_SATURATE,[qp]:i.DST_COLOR,[Xp]:i.DST_ALPHA,[Wp]:i.ONE_MINUS_SRC_COLOR,[ed]:i.ONE_MINUS_SRC_ALPHA,[Yp]:i.ONE_MINUS_DST_COLOR,[$p]:i.ONE_MINUS_DST_ALPHA,[Jp]:i.CONSTANT_COLOR,[Kp]:i.ONE_MINUS_CONSTANT_COLOR,[jp]:i.CONSTANT_ALPHA,[Qp]:i.ONE_MINUS_CONSTANT_ALPHA};function pt(B,oe,se,Ce,ye,we,Ye,nt,fe,Ge){if(B===Sr){m===!0&&(qe(i.BLEND),m=!1);return}if(m===!1&&(xe(i.BLEND),m=!0),B!==Op){if(B!==v||Ge!==U){if((x!==Mr||R!==Mr)&&(i.blendEquation(i.FUNC_ADD),x=Mr,R=Mr),Ge)switch(B){case Sa:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ju:i.blendFunc(i.ONE,i.ONE);break;case Ku:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ju:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ot("WebGLState: Invalid blending: ",B);break}else switch(B){case Sa:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ju:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Ku:ot("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ju:ot("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ot("WebGLState: Invalid blending: ",B);break}E=null,S=null,w=null,y=null,A.set(0,0,0),k=0,v=B,U=Ge}return}ye=ye||oe,we=we||se,Ye=Ye||Ce,(oe!==x||ye!==R)&&(i.blendEquationSeparate(tt[oe],tt[ye]),x=oe,R=ye),(se!==E||Ce!==S||we!==w||Ye!==y)&&(i.blendFuncSeparate(rt[se],rt[Ce],rt[we],rt[Ye]),E=se,S=Ce,w=we,y=Ye),(nt.equals(A)===!1||fe!==k)&&(i.blendColor(nt.r,nt.g,nt.b,fe),A.copy(nt),k=fe),v=B,U=!1}function Pt(B,oe){B.side===si?qe(i.CULL_FACE):xe(i.CULL_FACE);let se=B.side===Kn;oe&&(se=!se),qt(se),B.blending===Sa&&B.transparent===!1?pt(Sr):pt(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),a.setFunc(B.depthFunc),a.setTest(B.depthTest),a.setMask(B.depthWrite),r.setMask(B.colorWrite);let Ce=B.stencilWrite;o.setTest(Ce),Ce&&(o.setMask(B.stencilWriteMask),o.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),o.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),lt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?xe(i.SAMPLE_ALPHA_TO_COVERAGE):qe(i.SAMPLE_ALPHA_TO_COVERAGE)}function qt(B){D!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),D=B)}function Tt(B){B!==Dp?(xe(i.CULL_FACE),B!==L&&(B===Zu?i.cullFace(i.BACK):B===Np?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):qe(i.CULL_FACE),L=B}function sn(B){B!==F&&(X&&i.lineWidth(B),F=B)}function lt(B,oe,se){B?(xe(i.POLYGON_OFFSET_FILL),(P!==oe||G!==se)&&(P=oe,G=se,a.getReversed()&&(oe=-oe,se=-se),i.polygonOffset(oe,se))):qe(i.POLYGON_OFFSET_FILL)}function Bt(B){B?xe(i.SCISSOR_TEST):qe(i.SCISSOR_TEST)}function Wt(B){B===void 0&&(B=i.TEXTURE0+Y-1),ee!==B&&(i.activeTexture(B),ee=B)}function fn(B,oe,se){se===void 0&&(ee===null?se=i.TEXTURE0+Y-1:se=ee);let Ce=ne[se];Ce===void 0&&(Ce={type:void 0,texture:void 0},ne[se]=Ce),(Ce.type!==B||Ce.texture!==oe)&&(ee!==se&&(i.activeTexture(se),ee=se),i.bindTexture(B,oe||Te[B]),Ce.type=B,Ce.texture=oe)}function z(){let B=ne[ee];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Ie(){try{i.compressedTexImage2D(...arguments)}catch(B){ot("WebGLState:",B)}}function Qe(){try{i.compressedTexImage3D(...arguments)}catch(B){ot("WebGLState:",B)}}function ut(){try{i.texSubImage2D(...arguments)}catch(B){ot("WebGLState:",B)}}function Ae(){try{i.texSubImage3D(...arguments)}catch(B){ot("WebGLState:",B)}}function Vt(){try{i.compressedTexSubImage2D(...arguments)}catch(B){ot("WebGLState:",B)}}function $e(){try{i.compressedTexSubImage3D(...arguments)}catch(B){ot("WebGLState:",B)}}function Je(){try{i.texStorage2D(...arguments)}catch(B){ot("WebGLState:",B)}}function I(){try{i.texStorage3D(...arguments)}catch(B){ot("WebGLState:",B)}}function M(){try{i.texImage2D(...arguments)}catch(B){ot("WebGLState:",B)}}function q(){try{i.texImage3D(...arguments)}catch(B){ot("WebGLState:",B)}}function pe(B){return d[B]!==void 0?d[B]:i.getParameter(B)}function le(B,oe){d[B]!==oe&&(i.pixelStorei(B,oe),d[B]=oe)}function be(B){Q.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),Q.copy(B))}function Se(B){me.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),me.copy(B))}function ie(B,oe){let se=c.get(oe);se===void 0&&(se=new WeakMap,c.set(oe,se));let Ce=se.get(B);Ce===void 0&&(Ce=i.getUniformBlockIndex(oe,B.name),i.uniformBlockBinding(oe,Ce,Ce),se.set(B,Ce))}function re(B,oe,se){let ye=c.get(oe).get(B);l[ye]!==se&&(i.bindBufferBase(i.UNIFORM_BUFFER,ye,se),l[ye]=se)}function ve(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},ee=null,ne={},u={},l={},p=new WeakMap,g=[],_=null,m=!1,v=null,x=null,E=null,S=null,R=null,w=null,y=null,A=new je(0,0,0),k=0,U=!1,D=null,L=null,F=null,P=null,G=null,Q.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:xe,disable:qe,bindFramebuffer:st,drawBuffers:ae,useProgram:Xe,setBlending:pt,setMaterial:Pt,setFlipSided:qt,setCullFace:Tt,setLineWidth:sn,setPolygonOffset:lt,setScissorTest:Bt,activeTexture:Wt,bindTexture:fn,unbindTexture:z,compressedTexImage2D:Ie,compressedTexImage3D:Qe,texImage2D:M,texImage3D:q,pixelStorei:le,getParameter:pe,updateUBOMapping:ie,uniformBlockBinding:re,texStorage2D:Je,texStorage3D:I,texSubImage2D:ut,texSubImage3D:Ae,compressedTexSubImage2D:Vt,compressedTexSubImage3D:$e,scissor:be,viewport:Se,reset:ve}}function cM(i,e,t,n,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ve,h=new WeakMap,d=new Set,u,p=new WeakMap,g=new Set,_=new FinalizationRegistry(I=>g.delete(I)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function v(I,M){return m?new OffscreenCanvas(I,M):mo("canvas")}function x(I,M,q){let pe=1,le=Je(I);if((le.width>q||le.height>q)&&(pe=q/Math.max(le.width,le.height)),pe<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let be=Math.floor(pe*le.width),Se=Math.floor(pe*le.height);u===void 0&&(u=v(be,Se));let ie=M?v(be,Se):u;return ie.width=be,ie.height=Se,ie.getContext("2d").drawImage(I,0,0,be,Se),Ke("WebGLRenderer: Texture has been resized from ("+le.width+"x"+le.height+") to ("+be+"x"+Se+")."),ie}else return"data"in I&&Ke("WebGLRenderer: Image in DataTexture is too big ("+le.width+"x"+le.height+")."),I;return I}function E(I){return I.generateMipmaps}function S(I){i.generateMipmap(I)}function R(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(I,M,q,pe,le,be=!1){if(I!==null){if(i[I]!==void 0)return i[I];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let Se;pe&&(Se=e.get("EXT_texture_norm16"),Se||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ie=M;if(M===i.RED&&(q===i.FLOAT&&(ie=i.R32F),q===i.HALF_FLOAT&&(ie=i.R16F),q===i.UNSIGNED_BYTE&&(ie=i.R8),q===i.UNSIGNED_SHORT&&Se&&(ie=Se.R16_EXT),q===i.SHORT&&Se&&(ie=Se.R16_SNORM_EXT)),M===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(ie=i.R8UI),q===i.UNSIGNED_SHORT&&(ie=i.R16UI),q===i.UNSIGNED_INT&&(ie=i.R32UI),q===i.BYTE&&(ie=i.R8I),q===i.SHORT&&(ie=i.R16I),q===i.INT&&(ie=i.R32I)),M===i.RG&&(q===i.FLOAT&&(ie=i.RG32F),q===i.HALF_FLOAT&&(ie=i.RG16F),q===i.UNSIGNED_BYTE&&(ie=i.RG8),q===i.UNSIGNED_SHORT&&Se&&(ie=Se.RG16_EXT),q===i.SHORT&&Se&&(ie=Se.RG16_SNORM_EXT)),M===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(ie=i.RG8UI),q===i.UNSIGNED_SHORT&&(ie=i.RG16UI),q===i.UNSIGNED_INT&&(ie=i.RG32UI),q===i.BYTE&&(ie=i.RG8I),q===i.SHORT&&(ie=i.RG16I),q===i.INT&&(ie=i.RG32I)),M===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(ie=i.RGB8UI),q===i.UNSIGNED_SHORT&&(ie=i.RGB16UI),q===i.UNSIGNED_INT&&(ie=i.RGB32UI),q===i.BYTE&&(ie=i.RGB8I),q===i.SHORT&&(ie=i.RGB16I),q===i.INT&&(ie=i.RGB32I)),M===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(ie=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(ie=i.RGBA16UI),q===i.UNSIGNED_INT&&(ie=i.RGBA32UI),q===i.BYTE&&(ie=i.RGBA8I),q===i.SHORT&&(ie=i.RGBA16I),q===i.INT&&(ie=i.RGBA32I)),M===i.RGB&&(q===i.UNSIGNED_SHORT&&Se&&(ie=Se.RGB16_EXT),q===i.SHORT&&Se&&(ie=Se.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(ie=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(ie=i.R11F_G11F_B10F)),M===i.RGBA){let re=be?po:wt.getTransfer(le);q===i.FLOAT&&(ie=i.RGBA32F),q===i.HALF_FLOAT&&(ie=i.RGBA16F),q===i.UNSIGNED_BYTE&&(ie=re===Nt?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&Se&&(ie=Se.RGBA16_EXT),q===i.SHORT&&Se&&(ie=Se.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(ie=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(ie=i.RGB5_A1)}return(ie===i.R16F||ie===i.R32F||ie===i.RG16F||ie===i.RG32F||ie===i.RGBA16F||ie===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function y(I,M){let q;return I?M===null||M===Fi||M===Er?q=i.DEPTH24_STENCIL8:M===ki?q=i.DEPTH32F_STENCIL8:M===wa&&(q=i.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Fi||M===Er?q=i.DEPTH_COMPONENT24:M===ki?q=i.DEPTH_COMPONENT32F:M===wa&&(q=i.DEPTH_COMPONENT16),q}function A(I,M){return E(I)===!0||I.isFramebufferTexture&&I.minFilter!==In&&I.minFilter!==Yn?Math.log2(Math.max(M.width,M.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?M.mipmaps.length:1}function k(I){let M=new WeakRef(I);n.get(I).__ref=M,g.add(M),_.register(I,M,M)}function U(I){let M=n.get(I).__ref;M!==void 0&&(g.delete(M),_.unregister(M))}function D(I){F(I.target)}function L(I){P(I.target)}function F(I){I.removeEventListener("dispose",D),U(I),Y(I),I.isVideoTexture&&h.delete(I),I.isHTMLTexture&&d.delete(I)}function P(I){I.removeEventListener("dispose",L),U(I),he(I)}function G(){for(let I of g){let M=I.deref();M!==void 0&&(M.isRenderTarget===!0?P(M):F(M))}g.clear(),d.clear()}function Y(I){let M=n.get(I);if(M.__webglInit===void 0)return;let q=I.source,pe=p.get(q);if(pe){let le=pe[M.__cacheKey];le.usedTimes--,le.usedTimes===0&&X(I),Object.keys(pe).length===0&&p.delete(q)}n.remove(I)}function X(I){let M=n.get(I);i.deleteTexture(M.__webglTexture);let q=I.source,pe=p.get(q);delete pe[M.__cacheKey],a.memory.textures--}function he(I){let M=n.get(I);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=I.depthTexture;if(q&&q.renderTarget===I&&F(q),I.isWebGLCubeRenderTarget)for(let le=0;le<6;le++){if(Array.isArray(M.__webglFramebuffer[le]))for(let be=0;be<M.__webglFramebuffer[le].length;be++)i.deleteFramebuffer(M.__webglFramebuffer[le][be]);else i.deleteFramebuffer(M.__webglFramebuffer[le]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[le])}else{if(Array.isArray(M.__webglFramebuffer))for(let le=0;le<M.__webglFramebuffer.length;le++)i.deleteFramebuffer(M.__webglFramebuffer[le]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let le=0;le<M.__webglColorRenderbuffer.length;le++)M.__webglColorRenderbuffer[le]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[le]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let pe=I.textures;for(let le=0,be=pe.length;le<be;le++){let Se=n.get(pe[le]);Se.__webglTexture&&(i.deleteTexture(Se.__webglTexture),a.memory.textures--),n.remove(pe[le])}n.remove(I)}let J=0;function ee(){J=0}function ne(){return J}function ue(I){J=I}function de(){let I=J;return I>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,I}function Q(I){let M=[];return M.push(I.wrapS),M.push(I.wrapT),M.push(I.wrapR||0),M.push(I.magFilter),M.push(I.minFilter),M.push(I.anisotropy),M.push(I.internalFormat),M.push(I.format),M.push(I.type),M.push(I.generateMipmaps),M.push(I.mipmapsAutoUpdate),M.push(I.premultiplyAlpha),M.push(I.flipY),M.push(I.unpackAlignment),M.push(I.colorSpace),M.join()}function me(I,M){let q=n.get(I);if(I.isVideoTexture&&Vt(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&q.__version!==I.version){let pe=I.image;if(pe===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(pe.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Pt(q,I,M);return}}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+M)}function _e(I,M){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Pt(q,I,M);return}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+M)}function Te(I,M){let q=n.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Pt(q,I,M);return}t.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+M)}function xe(I,M){let q=n.get(I);if(I.version>0&&q.__version!==I.version){qt(q,I,M);return}t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+M)}let qe={[ec]:i.REPEAT,[es]:i.CLAMP_TO_EDGE,[tc]:i.MIRRORED_REPEAT},st={[In]:i.NEAREST,[nm]:i.NEAREST_MIPMAP_NEAREST,[ko]:i.NEAREST_MIPMAP_LINEAR,[Yn]:i.LINEAR,[Oc]:i.LINEAR_MIPMAP_NEAREST,[Es]:i.LINEAR_MIPMAP_LINEAR},ae={[am]:i.NEVER,[_d]:i.ALWAYS,[om]:i.LESS,[gd]:i.LEQUAL,[lm]:i.EQUAL,[vd]:i.GEQUAL,[cm]:i.GREATER,[hm]:i.NOTEQUAL};function Xe(I,M){if(M.type===ki&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===Yn||M.magFilter===Oc||M.magFilter===ko||M.magFilter===Es||M.minFilter===Yn||M.minFilter===Oc||M.minFilter===ko||M.minFilter===Es)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,qe[M.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,qe[M.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,qe[M.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,st[M.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,st[M.minFilter]),M.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,ae[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===In||M.minFilter!==ko&&M.minFilter!==Es||M.type===ki&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function tt(I,M){let q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,M.addEventListener("dispose",D),k(M));let pe=M.source,le=p.get(pe);le===void 0&&(le={},p.set(pe,le));let be=Q(M);if(be!==I.__cacheKey){le[be]===void 0&&(le[be]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,q=!0),le[be].usedTimes++;let Se=le[I.__cacheKey];Se!==void 0&&(le[I.__cacheKey].usedTimes--,Se.usedTimes===0&&X(M)),I.__cacheKey=be,I.__webglTexture=le[be].texture}return q}function rt(I,M,q){return Math.floor(Math.floor(I/q)/M)}function pt(I,M,q,pe){let be=I.updateRanges;if(be.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,M.width,M.height,q,pe,M.data);else{be.sort((B,oe)=>B.start-oe.start);let Se=0;for(let B=1;B<be.length;B++){let oe=be[Se],se=be[B],Ce=oe.start+oe.count,ye=rt(se.start,M.width,4),we=rt(oe.start,M.width,4);se.start<=Ce+1&&ye===we&&rt(se.start+se.count-1,M.width,4)===ye?oe.count=Math.max(oe.count,se.start+se.count-oe.start):(++Se,be[Se]=se)}be.length=Se+1;let ie=t.getParameter(i.UNPACK_ROW_LENGTH),re=t.getParameter(i.UNPACK_SKIP_PIXELS),ve=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,M.width);for(let B=0,oe=be.length;B<oe;B++){let se=be[B],Ce=Math.floor(se.start/4),ye=Math.ceil(se.count/4),we=Ce%M.width,Ye=Math.floor(Ce/M.width),nt=ye,fe=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,we),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ye),t.texSubImage2D(i.TEXTURE_2D,0,we,Ye,nt,fe,q,pe,M.data)}I.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ie),t.pixelStorei(i.UNPACK_SKIP_PIXELS,re),t.pixelStorei(i.UNPACK_SKIP_ROWS,ve)}}function Pt(I,M,q){let pe=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(pe=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(pe=i.TEXTURE_3D);let le=tt(I,M),be=M.source;t.bindTexture(pe,I.__webglTexture,i.TEXTURE0+q);let Se=n.get(be);if(be.version!==Se.__version||le===!0){if(t.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let fe=wt.getPrimaries(wt.workingColorSpace),Ge=M.colorSpace===As?null:wt.getPrimaries(M.colorSpace),it=M.colorSpace===As||fe===Ge?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,it)}t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment);let re=x(M.image,!1,s.maxTextureSize);re=$e(M,re);let ve=r.convert(M.format,M.colorSpace),B=r.convert(M.type),oe=w(M.internalFormat,ve,B,M.normalized,M.colorSpace,M.isVideoTexture);Xe(pe,M);let se,Ce=M.mipmaps,ye=M.isVideoTexture!==!0,we=Se.__version===void 0||le===!0,Ye=be.dataReady,nt=A(M,re);if(M.isDepthTexture)oe=y(M.format===Ts,M.type),we&&(ye?t.texStorage2D(i.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(i.TEXTURE_2D,0,oe,re.width,re.height,0,ve,B,null));else if(M.isDataTexture)if(Ce.length>0){ye&&we&&t.texStorage2D(i.TEXTURE_2D,nt,oe,Ce[0].width,Ce[0].height);for(let fe=0,Ge=Ce.length;fe<Ge;fe++)se=Ce[fe],ye?Ye&&t.texSubImage2D(i.TEXTURE_2D,fe,0,0,se.width,se.height,ve,B,se.data):t.texImage2D(i.TEXTURE_2D,fe,oe,se.width,se.height,0,ve,B,se.data);M.generateMipmaps=!1}else ye?(we&&t.texStorage2D(i.TEXTURE_2D,nt,oe,re.width,re.height),Ye&&pt(M,re,ve,B)):t.texImage2D(i.TEXTURE_2D,0,oe,re.width,re.height,0,ve,B,re.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ye&&we&&t.texStorage3D(i.TEXTURE_2D_ARRAY,nt,oe,Ce[0].width,Ce[0].height,re.depth);for(let fe=0,Ge=Ce.length;fe<Ge;fe++)if(se=Ce[fe],M.format!==zi)if(ve!==null)if(ye){if(Ye)if(M.layerUpdates.size>0){let it=Rd(se.width,se.height,M.format,M.type);for(let Le of M.layerUpdates){let dt=se.data.subarray(Le*it/se.data.BYTES_PER_ELEMENT,(Le+1)*it/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,fe,0,0,Le,se.width,se.height,1,ve,dt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,ve,se.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,fe,oe,se.width,se.height,re.depth,0,se.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?Ye&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,ve,B,se.data):t.texImage3D(i.TEXTURE_2D_ARRAY,fe,oe,se.width,se.height,re.depth,0,ve,B,se.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ye&&we&&t.texStorage2D(i.TEXTURE_2D,nt,oe,Ce[0].width,Ce[0].height);for(let fe=0,Ge=Ce.length;fe<Ge;fe++)se=Ce[fe],M.format!==zi?ve!==null?ye?Ye&&t.compressedTexSubImage2D(i.TEXTURE_2D,fe,0,0,se.width,se.height,ve,se.data):t.compressedTexImage2D(i.TEXTURE_2D,fe,oe,se.width,se.height,0,se.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?Ye&&t.texSubImage2D(i.TEXTURE_2D,fe,0,0,se.width,se.height,ve,B,se.data):t.texImage2D(i.TEXTURE_2D,fe,oe,se.width,se.height,0,ve,B,se.data)}else if(M.isDataArrayTexture)if(ye){if(we&&t.texStorage3D(i.TEXTURE_2D_ARRAY,nt,oe,re.width,re.height,re.depth),Ye)if(M.layerUpdates.size>0){let fe=Rd(re.width,re.height,M.format,M.type);for(let Ge of M.layerUpdates){let it=re.data.subarray(Ge*fe/re.data.BYTES_PER_ELEMENT,(Ge+1)*fe/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ge,re.width,re.height,1,ve,B,it)}M.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,ve,B,re.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,ve,B,re.data);else if(M.isData3DTexture)ye?(we&&t.texStorage3D(i.TEXTURE_3D,nt,oe,re.width,re.height,re.depth),Ye&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,ve,B,re.data)):t.texImage3D(i.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,ve,B,re.data);else if(M.isFramebufferTexture){if(we)if(ye)t.texStorage2D(i.TEXTURE_2D,nt,oe,re.width,re.height);else{let fe=re.width,Ge=re.height;for(let it=0;it<nt;it++)t.texImage2D(i.TEXTURE_2D,it,oe,fe,Ge,0,ve,B,null),fe>>=1,Ge>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in i){let fe=i.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),re.parentNode!==fe){fe.appendChild(re),d.add(M),fe.onpaint=Ge=>{let it=Ge.changedElements;for(let Le of d)it.includes(Le.image)&&(Le.needsUpdate=!0)},fe.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,re);else{let it=i.RGBA,Le=i.RGBA,dt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,it,Le,dt,re)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ce.length>0){if(ye&&we){let fe=Je(Ce[0]);t.texStorage2D(i.TEXTURE_2D,nt,oe,fe.width,fe.height)}for(let fe=0,Ge=Ce.length;fe<Ge;fe++)se=Ce[fe],ye?Ye&&t.texSubImage2D(i.TEXTURE_2D,fe,0,0,ve,B,se):t.texImage2D(i.TEXTURE_2D,fe,oe,ve,B,se);M.generateMipmaps=!1}else if(ye){if(we){let fe=Je(re);t.texStorage2D(i.TEXTURE_2D,nt,oe,fe.width,fe.height)}Ye&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ve,B,re)}else t.texImage2D(i.TEXTURE_2D,0,oe,ve,B,re);E(M)&&M.mipmapsAutoUpdate===!0&&S(pe),Se.__version=be.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function qt(I,M,q){if(M.image.length!==6)return;let pe=tt(I,M),le=M.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+q);let be=n.get(le);if(le.version!==be.__version||pe===!0){t.activeTexture(i.TEXTURE0+q);let Se=wt.getPrimaries(wt.workingColorSpace),ie=M.colorSpace===As?null:wt.getPrimaries(M.colorSpace),re=M.colorSpace===As||Se===ie?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let ve=M.isCompressedTexture||M.image[0].isCompressedTexture,B=M.image[0]&&M.image[0].isDataTexture,oe=[];for(let Le=0;Le<6;Le++)!ve&&!B?oe[Le]=x(M.image[Le],!0,s.maxCubemapSize):oe[Le]=B?M.image[Le].image:M.image[Le],oe[Le]=$e(M,oe[Le]);let se=oe[0],Ce=r.convert(M.format,M.colorSpace),ye=r.convert(M.type),we=w(M.internalFormat,Ce,ye,M.normalized,M.colorSpace),Ye=M.isVideoTexture!==!0,nt=be.__version===void 0||pe===!0,fe=le.dataReady,Ge=A(M,se);Xe(i.TEXTURE_CUBE_MAP,M);let it;if(M.isDepthTexture){if(we=y(M.format===Ts,M.type),nt)if(Ye)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,we,se.width,se.height);else for(let Le=0;Le<6;Le++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,we,se.width,se.height,0,Ce,ye,null)}else if(ve){Ye&&nt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,we,se.width,se.height);for(let Le=0;Le<6;Le++){it=oe[Le].mipmaps;for(let dt=0;dt<it.length;dt++){let Yt=it[dt];M.format!==zi?Ce!==null?Ye?fe&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,dt,0,0,Yt.width,Yt.height,Ce,Yt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,dt,we,Yt.width,Yt.height,0,Yt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,dt,0,0,Yt.width,Yt.height,Ce,ye,Yt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,dt,we,Yt.width,Yt.height,0,Ce,ye,Yt.data)}}}else{if(it=M.mipmaps,Ye&&nt){it.length>0&&Ge++;let Le=Je(oe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,we,Le.width,Le.height)}for(let Le=0;Le<6;Le++)if(B){Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,0,0,oe[Le].width,oe[Le].height,Ce,ye,oe[Le].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,we,oe[Le].width,oe[Le].height,0,Ce,ye,oe[Le].data);for(let dt=0;dt<it.length;dt++){let Vn=it[dt].image[Le].image;Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,dt+1,0,0,Vn.width,Vn.height,Ce,ye,Vn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,dt+1,we,Vn.width,Vn.height,0,Ce,ye,Vn.data)}}else{Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,0,0,Ce,ye,oe[Le]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,0,we,Ce,ye,oe[Le]);for(let dt=0;dt<it.length;dt++){let Yt=it[dt];Ye?fe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,dt+1,0,0,Ce,ye,Yt.image[Le]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Le,dt+1,we,Ce,ye,Yt.image[Le])}}}E(M)&&M.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),be.__version=le.version,M.onUpdate&&M.onUpdate(M)}I.__version=M.version}function Tt(I,M,q,pe,le,be){let Se=r.convert(q.format,q.colorSpace),ie=r.convert(q.type),re=w(q.internalFormat,Se,ie,q.normalized,q.colorSpace),ve=n.get(M),B=n.get(q);if(B.__renderTarget=M,!ve.__hasExternalTextures){let oe=Math.max(1,M.width>>be),se=Math.max(1,M.height>>be);le===i.TEXTURE_3D||le===i.TEXTURE_2D_ARRAY?t.texImage3D(le,be,re,oe,se,M.depth,0,Se,ie,null):t.texImage2D(le,be,re,oe,se,0,Se,ie,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),Ae(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,le,B.__webglTexture,0,ut(M)):(le===i.TEXTURE_2D||le>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&le<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,pe,le,B.__webglTexture,be),t.bindFramebuffer(i.FRAMEBUFFER,null)}function sn(I,M,q){if(i.bindRenderbuffer(i.RENDERBUFFER,I),M.depthBuffer){let pe=M.depthTexture,le=pe&&pe.isDepthTexture?pe.type:null,be=y(M.stencilBuffer,le),Se=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ae(M)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ut(M),be,M.width,M.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ut(M),be,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,be,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Se,i.RENDERBUFFER,I)}else{let pe=M.textures;for(let le=0;le<pe.length;le++){let be=pe[le],Se=r.convert(be.format,be.colorSpace),ie=r.convert(be.type),re=w(be.internalFormat,Se,ie,be.normalized,be.colorSpace);Ae(M)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ut(M),re,M.width,M.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ut(M),re,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,re,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function lt(I,M,q){let pe=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let le=n.get(M.depthTexture);le.__renderTarget=M;let be=pe?M.depthTexture.image[0]:M.depthTexture.image;(!le.__webglTexture||be.width!==M.width||be.height!==M.height)&&(be.width=M.width,be.height=M.height,M.depthTexture.needsUpdate=!0),pe?xe(M.depthTexture,0):me(M.depthTexture,0);let Se=le.__webglTexture,ie=ut(M),re=pe?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,ve=M.depthTexture.format===Ts?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(M.depthTexture.format===_s)Ae(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ve,re,Se,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,ve,re,Se,0);else if(M.depthTexture.format===Ts)Ae(M)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ve,re,Se,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,ve,re,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Bt(I){let M=n.get(I),q=I.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==I.depthTexture){let pe=I.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),pe){let le=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,pe.removeEventListener("dispose",le)};pe.addEventListener("dispose",le),M.__depthDisposeCallback=le}M.__boundDepthTexture=pe}if(I.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let pe=0;pe<6;pe++)lt(M.__webglFramebuffer[pe],I,pe);else I.texture.mipmaps.length>0?lt(M.__webglFramebuffer[0],I,0):lt(M.__webglFramebuffer,I,0);else if(q){M.__webglDepthbuffer=[];for(let pe=0;pe<6;pe++)if(t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[pe]),M.__webglDepthbuffer[pe]===void 0)M.__webglDepthbuffer[pe]=i.createRenderbuffer(),sn(M.__webglDepthbuffer[pe],I,!1);else{let le=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=M.__webglDepthbuffer[pe];i.bindRenderbuffer(i.RENDERBUFFER,be),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,be)}}else if(I.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),sn(M.__webglDepthbuffer,I,!1);else{let le=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,be=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,be),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,be)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Wt(I,M,q){let pe=n.get(I);M!==void 0&&Tt(pe.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&Bt(I)}function fn(I){let M=I.texture,q=n.get(I),pe=n.get(M);I.addEventListener("dispose",L),k(I);let le=I.textures,be=I.isWebGLCubeRenderTarget===!0,Se=le.length>1;if(Se||(pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture()),pe.__version=M.version,a.memory.textures++),be){q.__webglFramebuffer=[];for(let ie=0;ie<6;ie++)if(M.mipmaps.length>0){q.__webglFramebuffer[ie]=[];for(let re=0;re<M.mipmaps.length;re++)q.__webglFramebuffer[ie][re]=i.createFramebuffer()}else q.__webglFramebuffer[ie]=i.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let ie=0;ie<M.mipmaps.length;ie++)q.__webglFramebuffer[ie]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(Se)for(let ie=0,re=le.length;ie<re;ie++){let ve=n.get(le[ie]);ve.__webglTexture===void 0&&(ve.__webglTexture=i.createTexture(),a.memory.textures++)}if(I.samples>0&&Ae(I)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ie=0;ie<le.length;ie++){let re=le[ie];q.__webglColorRenderbuffer[ie]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[ie]);let ve=r.convert(re.format,re.colorSpace),B=r.convert(re.type),oe=w(re.internalFormat,ve,B,re.normalized,re.colorSpace,I.isXRRenderTarget===!0),se=ut(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,se,oe,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ie,i.RENDERBUFFER,q.__webglColorRenderbuffer[ie])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),sn(q.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(be){t.bindTexture(i.TEXTURE_CUBE_MAP,pe.__webglTexture),Xe(i.TEXTURE_CUBE_MAP,M);for(let ie=0;ie<6;ie++)if(M.mipmaps.length>0)for(let re=0;re<M.mipmaps.length;re++)Tt(q.__webglFramebuffer[ie][re],I,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ie,re);else Tt(q.__webglFramebuffer[ie],I,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ie,0);E(M)?S(i.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let ie=0,re=le.length;ie<re;ie++){let ve=le[ie],B=n.get(ve),oe=i.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(oe=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(oe,B.__webglTexture),Xe(oe,ve),Tt(q.__webglFramebuffer,I,ve,i.COLOR_ATTACHMENT0+ie,oe,0),E(ve)&&S(oe)}t.unbindTexture()}else{let ie=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ie=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ie,pe.__webglTexture),Xe(ie,M),M.mipmaps.length>0)for(let re=0;re<M.mipmaps.length;re++)Tt(q.__webglFramebuffer[re],I,M,i.COLOR_ATTACHMENT0,ie,re);else Tt(q.__webglFramebuffer,I,M,i.COLOR_ATTACHMENT0,ie,0);E(M)?S(ie):M.mipmaps.length>0&&i.texParameteri(ie,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}I.depthBuffer&&Bt(I)}function z(I){let M=I.textures;for(let q=0,pe=M.length;q<pe;q++){let le=M[q];if(E(le)&&le.mipmapsAutoUpdate===!0){let be=R(I),Se=n.get(le).__webglTexture;t.bindTexture(be,Se),S(be),t.unbindTexture()}}}let Ie=[];function Qe(I){if(I.samples>0){if(Ae(I)===!1){let M=I.textures,q=I.width,pe=I.height,le=i.COLOR_BUFFER_BIT,be=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Se=n.get(I),ie=M.length>1;if(ie)for(let ve=0;ve<M.length;ve++)t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ve,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ve,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let ve=0;ve<M.length;ve++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(le|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(le|=i.STENCIL_BUFFER_BIT)),ie){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Se.__webglColorRenderbuffer[ve]);let B=n.get(M[ve]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,q,pe,0,0,q,pe,le,i.NEAREST),l===!0&&(Ie.length=0,Ie.push(i.COLOR_ATTACHMENT0+ve),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Ie.push(be),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ie)for(let ve=0;ve<M.length;ve++){t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ve,i.RENDERBUFFER,Se.__webglColorRenderbuffer[ve]);let B=n.get(M[ve]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ve,i.TEXTURE_2D,B,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let M=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function ut(I){return Math.min(s.maxSamples,I.samples)}function Ae(I){let M=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Vt(I){let M=a.render.frame;h.get(I)!==M&&(h.set(I,M),I.update())}function $e(I,M){let q=I.colorSpace,pe=I.format,le=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||q!==fo&&q!==As&&(wt.getTransfer(q)===Nt?(pe!==zi||le!==ri)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ot("WebGLTextures: Unsupported texture color space:",q)),M}function Je(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=ee,this.getTextureUnits=ne,this.setTextureUnits=ue,this.setTexture2D=me,this.setTexture2DArray=_e,this.setTexture3D=Te,this.setTextureCube=xe,this.rebindTextures=Wt,this.setupRenderTarget=fn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Qe,this.setupDepthRenderbuffer=Bt,this.setupFrameBufferTexture=Tt,this.useMultisampledRTT=Ae,this.dispose=G}function hM(i,e){function t(n,s=As){let r,a=wt.getTransfer(s);if(n===ri)return i.UNSIGNED_BYTE;if(n===kc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Bc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===ud)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===dd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===cd)return i.BYTE;if(n===hd)return i.SHORT;if(n===wa)return i.UNSIGNED_SHORT;if(n===Fc)return i.INT;if(n===Fi)return i.UNSIGNED_INT;if(n===ki)return i.FLOAT;if(n===Bi)return i.HALF_FLOAT;if(n===fd)return i.ALPHA;if(n===pd)return i.RGB;if(n===zi)return i.RGBA;if(n===_s)return i.DEPTH_COMPONENT;if(n===Ts)return i.DEPTH_STENCIL;if(n===md)return i.RED;if(n===zc)return i.RED_INTEGER;if(n===er)return i.RG;if(n===Vc)return i.RG_INTEGER;if(n===Gc)return i.RGBA_INTEGER;if(n===Bo||n===zo||n===Vo||n===Go)if(a===Nt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Bo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===zo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Vo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Go)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Bo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===zo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Vo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Go)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Hc||n===Wc||n===Xc||n===$c)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Hc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Wc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Xc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===$c)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===qc||n===Yc||n===Zc||n===Jc||n===Kc||n===Ho||n===jc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===qc||n===Yc)return a===Nt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Zc)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Jc)return r.COMPRESSED_R11_EAC;if(n===Kc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ho)return r.COMPRESSED_RG11_EAC;if(n===jc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Qc||n===eh||n===th||n===nh||n===ih||n===sh||n===rh||n===ah||n===oh||n===lh||n===ch||n===hh||n===uh||n===dh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Qc)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===eh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===th)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===nh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ih)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===sh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===rh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ah)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===oh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===lh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===ch)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===hh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===uh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===dh)return a===Nt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===fh||n===ph||n===mh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===fh)return a===Nt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===ph)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===mh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===gh||n===vh||n===Wo||n===_h)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===gh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===vh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Wo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===_h)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Er?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var uM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,dM=`
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

}`,kd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new wo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ts({vertexShader:uM,fragmentShader:dM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new dn(new Ao(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Bd=class extends Oi{constructor(e,t){super();let n=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,d=null,u=null,p=null,g=null,_=typeof XRWebGLBinding<"u",m=new kd,v={},x=t.getContextAttributes(),E=null,S=null,R=[],w=[],y=new Ve,A=null,k=null,U=new gi;U.viewport=new tn;let D=new gi;D.viewport=new tn;let L=[U,D],F=new Ic,P=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let me=R[Q];return me===void 0&&(me=new ga,R[Q]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Q){let me=R[Q];return me===void 0&&(me=new ga,R[Q]=me),me.getGripSpace()},this.getHand=function(Q){let me=R[Q];return me===void 0&&(me=new ga,R[Q]=me),me.getHandSpace()};function Y(Q){let me=w.indexOf(Q.inputSource);if(me===-1)return;let _e=R[me];_e!==void 0&&(_e.update(Q.inputSource,Q.frame,c||a),_e.dispatchEvent({type:Q.type,data:Q.inputSource}))}function X(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",X),s.removeEventListener("inputsourceschange",he);for(let Q=0;Q<R.length;Q++){let me=w[Q];me!==null&&(w[Q]=null,R[Q].disconnect(me))}P=null,G=null,m.reset();for(let Q in v)delete v[Q];if(e.setRenderTarget(E),p=null,u=null,d=null,s=null,S=null,de.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(y.width,y.height,!1),k!==null){let Q=k.camera;Q.fov=k.fov,Q.zoom=k.zoom,Q.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){o=Q,n.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return u!==null?u:p},this.getBinding=function(){return d===null&&_&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",X),s.addEventListener("inputsourceschange",he),x.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Te=null,xe=null;x.depth&&(xe=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=x.stencil?Ts:_s,Te=x.stencil?Er:Fi);let qe={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(qe),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),S=new vi(u.textureWidth,u.textureHeight,{format:zi,type:ri,depthTexture:new Ms(u.textureWidth,u.textureHeight,Te,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let _e={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new vi(p.framebufferWidth,p.framebufferHeight,{format:zi,type:ri,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),de.setContext(s),de.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function he(Q){for(let me=0;me<Q.removed.length;me++){let _e=Q.removed[me],Te=w.indexOf(_e);Te>=0&&(w[Te]=null,R[Te].disconnect(_e))}for(let me=0;me<Q.added.length;me++){let _e=Q.added[me],Te=w.indexOf(_e);if(Te===-1){for(let qe=0;qe<R.length;qe++)if(qe>=w.length){w.push(_e),Te=qe;break}else if(w[qe]===null){w[qe]=_e,Te=qe;break}if(Te===-1)break}let xe=R[Te];xe&&xe.connect(_e)}}function J(Q,me){me===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(me.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let me=Q.near,_e=Q.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(_e=m.depthFar)),F.near=D.near=U.near=me,F.far=D.far=U.far=_e,(P!==F.near||G!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),P=F.near,G=F.far),F.layers.mask=Q.layers.mask|6,U.layers.mask=F.layers.mask&-5,D.layers.mask=F.layers.mask&-3;let Te=Q.parent,xe=F.cameras;J(F,Te);for(let qe=0;qe<xe.length;qe++)J(xe[qe],Te);F.projectionMatrix.copy(U.projectionMatrix),F.projectionMatrixInverse.copy(U.projectionMatrixInverse),k===null&&Q.isPerspectiveCamera&&(k={camera:Q,fov:Q.fov,zoom:Q.zoom}),ee(Q,F,Te)};function ee(Q,me,_e){_e===null?Q.matrix.copy(me.matrixWorld):(Q.matrix.copy(_e.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(me.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(me.projectionMatrix),Q.projectionMatrixInverse.copy(me.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=pa*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(u===null&&p===null))return l},this.setFoveation=function(Q){l=Q,u!==null&&(u.fixedFoveation=Q),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(F)},this.getCameraTexture=function(Q){return v[Q]};let ne=null;function ue(Q,me){if(h=me.getViewerPose(c||a),g=me,h!==null){let _e=h.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let Te=!1;_e.length!==F.cameras.length&&(F.cameras.length=0,Te=!0);for(let ae=0;ae<_e.length;ae++){let Xe=_e[ae],tt=null;if(p!==null)tt=p.getViewport(Xe);else{let pt=d.getViewSubImage(u,Xe);tt=pt.viewport,ae===0&&(e.setRenderTargetTextures(S,pt.colorTexture,pt.depthStencilTexture),e.setRenderTarget(S))}let rt=L[ae];rt===void 0&&(rt=new gi,rt.layers.enable(ae),rt.viewport=new tn,L[ae]=rt),rt.matrix.fromArray(Xe.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(Xe.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(tt.x,tt.y,tt.width,tt.height),ae===0&&(F.matrix.copy(rt.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),Te===!0&&F.cameras.push(rt)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){d=n.getBinding();let ae=d.getDepthInformation(_e[0]);ae&&ae.isValid&&ae.texture&&m.init(ae,s.renderState)}if(xe&&xe.includes("camera-access")&&_){e.state.unbindTexture(),d=n.getBinding();for(let ae=0;ae<_e.length;ae++){let Xe=_e[ae].camera;if(Xe){let tt=v[Xe];tt||(tt=new wo,v[Xe]=tt);let rt=d.getCameraImage(Xe);tt.sourceTexture=rt}}}}for(let _e=0;_e<R.length;_e++){let Te=w[_e],xe=R[_e];Te!==null&&xe!==void 0&&xe.update(Te,me,c||a)}ne&&ne(Q,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),g=null}let de=new Hm;de.setAnimationLoop(ue),this.setAnimationLoop=function(Q){ne=Q},this.dispose=function(){}}},fM=new Xt,Qm=new ct;Qm.set(-1,0,0,0,1,0,0,0,1);function pM(i,e){function t(m,v){m.matrixAutoUpdate===!0&&m.updateMatrix(),v.value.copy(m.matrix)}function n(m,v){v.color.getRGB(m.fogColor.value,Td(i)),v.isFog?(m.fogNear.value=v.near,m.fogFar.value=v.far):v.isFogExp2&&(m.fogDensity.value=v.density)}function s(m,v,x,E,S){v.isNodeMaterial?v.uniformsNeedUpdate=!1:v.isMeshBasicMaterial?r(m,v):v.isMeshLambertMaterial?(r(m,v),v.envMap&&(m.envMapIntensity.value=v.envMapIntensity)):v.isMeshToonMaterial?(r(m,v),d(m,v)):v.isMeshPhongMaterial?(r(m,v),h(m,v),v.envMap&&(m.envMapIntensity.value=v.envMapIntensity)):v.isMeshStandardMaterial?(r(m,v),u(m,v),v.isMeshPhysicalMaterial&&p(m,v,S)):v.isMeshMatcapMaterial?(r(m,v),g(m,v)):v.isMeshDepthMaterial?r(m,v):v.isMeshDistanceMaterial?(r(m,v),_(m,v)):v.isMeshNormalMaterial?r(m,v):v.isLineBasicMaterial?(a(m,v),v.isLineDashedMaterial&&o(m,v)):v.isPointsMaterial?l(m,v,x,E):v.isSpriteMaterial?c(m,v):v.isShadowMaterial?(m.color.value.copy(v.color),m.opacity.value=v.opacity):v.isShaderMaterial&&(v.uniformsNeedUpdate=!1)}function r(m,v){m.opacity.value=v.opacity,v.color&&m.diffuse.value.copy(v.color),v.emissive&&m.emissive.value.copy(v.emissive).multiplyScalar(v.emissiveIntensity),v.map&&(m.map.value=v.map,t(v.map,m.mapTransform)),v.alphaMap&&(m.alphaMap.value=v.alphaMap,t(v.alphaMap,m.alphaMapTransform)),v.bumpMap&&(m.bumpMap.value=v.bumpMap,t(v.bumpMap,m.bumpMapTransform),m.bumpScale.value=v.bumpScale,v.side===Kn&&(m.bumpScale.value*=-1)),v.normalMap&&(m.normalMap.value=v.normalMap,t(v.normalMap,m.normalMapTransform),m.normalScale.value.copy(v.normalScale),v.side===Kn&&m.normalScale.value.negate()),v.displacementMap&&(m.displacementMap.value=v.displacementMap,t(v.displacementMap,m.displacementMapTransform),m.displacementScale.value=v.displacementScale,m.displacementBias.value=v.displacementBias),v.emissiveMap&&(m.emissiveMap.value=v.emissiveMap,t(v.emissiveMap,m.emissiveMapTransform)),v.specularMap&&(m.specularMap.value=v.specularMap,t(v.specularMap,m.specularMapTransform)),v.alphaTest>0&&(m.alphaTest.value=v.alphaTest);let x=e.get(v),E=x.envMap,S=x.envMapRotation;E&&(m.envMap.value=E,m.envMapRotation.value.setFromMatrix4(fM.makeRotationFromEuler(S)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Qm),m.reflectivity.value=v.reflectivity,m.ior.value=v.ior,m.refractionRatio.value=v.refractionRatio),v.lightMap&&(m.lightMap.value=v.lightMap,m.lightMapIntensity.value=v.lightMapIntensity,t(v.lightMap,m.lightMapTransform)),v.aoMap&&(m.aoMap.value=v.aoMap,m.aoMapIntensity.value=v.aoMapIntensity,t(v.aoMap,m.aoMapTransform))}function a(m,v){m.diffuse.value.copy(v.color),m.opacity.value=v.opacity,v.map&&(m.map.value=v.map,t(v.map,m.mapTransform))}function o(m,v){m.dashSize.value=v.dashSize,m.totalSize.value=v.dashSize+v.gapSize,m.scale.value=v.scale}function l(m,v,x,E){m.diffuse.value.copy(v.color),m.opacity.value=v.opacity,m.size.value=v.size*x,m.scale.value=E*.5,v.map&&(m.map.value=v.map,t(v.map,m.uvTransform)),v.alphaMap&&(m.alphaMap.value=v.alphaMap,t(v.alphaMap,m.alphaMapTransform)),v.alphaTest>0&&(m.alphaTest.value=v.alphaTest)}function c(m,v){m.diffuse.value.copy(v.color),m.opacity.value=v.opacity,m.rotation.value=v.rotation,v.map&&(m.map.value=v.map,t(v.map,m.mapTransform)),v.alphaMap&&(m.alphaMap.value=v.alphaMap,t(v.alphaMap,m.alphaMapTransform)),v.alphaTest>0&&(m.alphaTest.value=v.alphaTest)}function h(m,v){m.specular.value.copy(v.specular),m.shininess.value=Math.max(v.shininess,1e-4)}function d(m,v){v.gradientMap&&(m.gradientMap.value=v.gradientMap)}function u(m,v){m.metalness.value=v.metalness,v.metalnessMap&&(m.metalnessMap.value=v.metalnessMap,t(v.metalnessMap,m.metalnessMapTransform)),m.roughness.value=v.roughness,v.roughnessMap&&(m.roughnessMap.value=v.roughnessMap,t(v.roughnessMap,m.roughnessMapTransform)),v.envMap&&(m.envMapIntensity.value=v.envMapIntensity)}function p(m,v,x){m.ior.value=v.ior,v.diffuseRoughness>0&&(m.diffuseRoughness.value=v.diffuseRoughness,v.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=v.diffuseRoughnessMap,t(v.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),v.sheen>0&&(m.sheenColor.value.copy(v.sheenColor).multiplyScalar(v.sheen),m.sheenRoughness.value=v.sheenRoughness,v.sheenColorMap&&(m.sheenColorMap.value=v.sheenColorMap,t(v.sheenColorMap,m.sheenColorMapTransform)),v.sheenRoughnessMap&&(m.sheenRoughnessMap.value=v.sheenRoughnessMap,t(v.sheenRoughnessMap,m.sheenRoughnessMapTransform))),v.clearcoat>0&&(m.clearcoat.value=v.clearcoat,m.clearcoatRoughness.value=v.clearcoatRoughness,v.clearcoatMap&&(m.clearcoatMap.value=v.clearcoatMap,t(v.clearcoatMap,m.clearcoatMapTransform)),v.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=v.clearcoatRoughnessMap,t(v.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),v.clearcoatNormalMap&&(m.clearcoatNormalMap.value=v.clearcoatNormalMap,t(v.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(v.clearcoatNormalScale),v.side===Kn&&m.clearcoatNormalScale.value.negate())),v.dispersion>0&&(m.dispersion.value=v.dispersion),v.retroreflectivity>0&&(m.retroreflectivity.value=v.retroreflectivity),v.iridescence>0&&(m.iridescence.value=v.iridescence,m.iridescenceIOR.value=v.iridescenceIOR,m.iridescenceThicknessMinimum.value=v.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=v.iridescenceThicknessMaximum,v.iridescenceMap&&(m.iridescenceMap.value=v.iridescenceMap,t(v.iridescenceMap,m.iridescenceMapTransform)),v.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=v.iridescenceThicknessMap,t(v.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),v.transmission>0&&(m.transmission.value=v.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),v.transmissionMap&&(m.transmissionMap.value=v.transmissionMap,t(v.transmissionMap,m.transmissionMapTransform)),m.thickness.value=v.thickness,v.thicknessMap&&(m.thicknessMap.value=v.thicknessMap,t(v.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=v.attenuationDistance,m.attenuationColor.value.copy(v.attenuationColor)),v.anisotropy>0&&(m.anisotropyVector.value.set(v.anisotropy*Math.cos(v.anisotropyRotation),v.anisotropy*Math.sin(v.anisotropyRotation)),v.anisotropyMap&&(m.anisotropyMap.value=v.anisotropyMap,t(v.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=v.specularIntensity,m.specularColor.value.copy(v.specularColor),v.specularColorMap&&(m.specularColorMap.value=v.specularColorMap,t(v.specularColorMap,m.specularColorMapTransform)),v.specularIntensityMap&&(m.specularIntensityMap.value=v.specularIntensityMap,t(v.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,v){v.matcap&&(m.matcap.value=v.matcap)}function _(m,v){let x=e.get(v).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function mM(i,e,t,n){let s={},r={};function a(x,E){let S=E.program;n.uniformBlockBinding(x,S,s[x.id])}function o(x,E){let S=s[x.id];S===void 0&&(g(x),S=l(x),s[x.id]=S,x.addEventListener("dispose",m));let R=E.program;n.updateUBOMapping(x,R);let w=e.render.frame;r[x.id]!==w&&(c(x),r[x.id]=w)}function l(x){let E=i.createBuffer(),S=x.__size,R=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,E),i.bufferData(i.UNIFORM_BUFFER,S,R),i.bindBuffer(i.UNIFORM_BUFFER,null),E}function c(x){let E=s[x.id],S=x.uniforms,R=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,E);for(let w=0,y=S.length;w<y;w++){let A=S[w];if(Array.isArray(A))for(let k=0,U=A.length;k<U;k++)h(A[k],w,k,R);else h(A,w,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,E,S,R){if(u(x,E,S,R)===!0){let w=x.__offset,y=x.value;if(Array.isArray(y)){let A=0;for(let k=0;k<y.length;k++){let U=y[k],D=_(U,!0);d(U,x.__data,A),A+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(y,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,x.__data)}}function d(x,E,S){typeof x=="number"||typeof x=="boolean"?E[S]=x:x.isMatrix3?(E[S]=x.elements[0],E[S+1]=x.elements[1],E[S+2]=x.elements[2],E[S+3]=0,E[S+4]=x.elements[3],E[S+5]=x.elements[4],E[S+6]=x.elements[5],E[S+7]=0,E[S+8]=x.elements[6],E[S+9]=x.elements[7],E[S+10]=x.elements[8],E[S+11]=0):ArrayBuffer.isView(x)?E.set(x.subarray(0,E.length-S),S):x.toArray(E,S)}function u(x,E,S,R){let w=x.value,y=E+"_"+S;if(Array.isArray(w)){R[y]===void 0&&(R[y]=[]);let A=R[y],k=!1;for(let U=0;U<w.length;U++)p(w[U],A,U)===!0&&(k=!0);return k}return p(w,R,y)}function p(x,E,S){if(E[S]===void 0)return typeof x=="number"||typeof x=="boolean"?E[S]=x:ArrayBuffer.isView(x)?E[S]=x.slice():E[S]=x.clone(),!0;{let R=E[S];if(typeof x=="number"||typeof x=="boolean"){if(R!==x)return E[S]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(R.equals(x)===!1)return R.copy(x),!0}}return!1}function g(x){let E=x.uniforms,S=0,R=16;for(let y=0,A=E.length;y<A;y++){let k=Array.isArray(E[y])?E[y]:[E[y]];for(let U=0,D=k.length;U<D;U++){let L=k[U],F=Array.isArray(L.value)?L.value:[L.value],P=Array.isArray(E[y])||Array.isArray(L.value),G=S;for(let X=0,he=F.length;X<he;X++){let J=F[X],ee=_(J,P),ne=S%R,ue=ne%ee.boundary,de=ne+ue;S+=ue,de!==0&&R-de<ee.storage&&(S+=R-de),X===0&&(G=S),S+=ee.storage}let Y=L.type==="int"?Int32Array:L.type==="uint"?Uint32Array:Float32Array;L.__data=new Y((S-G)/Float32Array.BYTES_PER_ELEMENT),L.__offset=G}}let w=S%R;return w>0&&(S+=R-w),x.__size=S,x.__cache={},this}function _(x,E){let S={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(S.boundary=4,S.storage=4):x.isVector2?(S.boundary=8,S.storage=8):x.isVector3||x.isColor?(S.boundary=16,S.storage=12):x.isVector4?(S.boundary=16,S.storage=16):x.isMatrix3?(S.boundary=16,S.storage=48):x.isMatrix4?(S.boundary=16,S.storage=64):x.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(S.boundary=16,S.storage=x.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",x),E===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(x){let E=x.target;E.removeEventListener("dispose",m),i.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function v(){for(let x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:a,update:o,dispose:v}}var gM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),is=null;function vM(){return is===null&&(is=new oc(gM,16,16,er,Bi),is.name="DFG_LUT",is.minFilter=Yn,is.magFilter=Yn,is.wrapS=es,is.wrapT=es,is.generateMipmaps=!1,is.needsUpdate=!0),is}var Mh=class{constructor(e={}){let{canvas:t=dm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:p=ri}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let _=p,m=new Set([Gc,Vc,zc]),v=new Set([ri,Fi,wa,Er,kc,Bc]),x=new Uint32Array(4),E=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,w=null,y=[],A=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,D=!1,L=null,F=null,P=null,G=null;this._outputColorSpace=pi;let Y=0,X=0,he=null,J=-1,ee=null,ne=new tn,ue=new tn,de=null,Q=new je(0),me=0,_e=t.width,Te=t.height,xe=1,qe=null,st=null,ae=new tn(0,0,_e,Te),Xe=new tn(0,0,_e,Te),tt=!1,rt=new qs,pt=new lc,Pt=!1,qt=!1,Tt=new Xt,sn=new V,lt=new tn,Bt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Wt=!1;function fn(){return he===null?xe:1}let z=n;function Ie(C,W){return t.getContext(C,W)}let Qe,ut,Ae,Vt,$e,Je,I,M,q,pe,le,be,Se,ie,re,ve,B,oe,se,Ce,ye,we,Ye;try{let C={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ge,!1),t.addEventListener("webglcontextrestored",it,!1),t.addEventListener("webglcontextcreationerror",Le,!1),z===null){let W="webgl2";if(z=Ie(W,C),z===null)throw Ie(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}nt()}catch(C){throw t.removeEventListener("webglcontextlost",Ge,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Le,!1),ot("WebGLRenderer: "+C.message),C}function nt(){Qe=new Cb(z),Qe.init(),ye=new hM(z,Qe),ut=new vb(z,Qe,e,ye),Ae=new lM(z,Qe),ut.reversedDepthBuffer&&u&&Ae.buffers.depth.setReversed(!0),F=z.createFramebuffer(),P=z.createFramebuffer(),G=z.createFramebuffer(),Vt=new Lb(z),$e=new YS,Je=new cM(z,Qe,Ae,$e,ut,ye,Vt),I=new Ab(U),M=new D_(z),we=new mb(z,M),q=new Rb(z,M,Vt,we),pe=new Db(z,q,M,we,Vt),oe=new Ib(z,ut,Je),re=new _b($e),le=new qS(U,I,Qe,ut,we,re),be=new pM(U,$e),Se=new JS,ie=new nM(Qe),B=new pb(U,I,Ae,pe,g,l),ve=new oM(U,pe,ut),Ye=new mM(z,Vt,ut,Ae),se=new gb(z,Qe,Vt),Ce=new Pb(z,Qe,Vt),Vt.programs=le.programs,U.capabilities=ut,U.extensions=Qe,U.properties=$e,U.renderLists=Se,U.shadowMap=ve,U.state=Ae,U.info=Vt}_!==ri&&(k=new Ub(_,t.width,t.height,o,s,r));let fe=new Bd(U,z);this.xr=fe,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let C=Qe.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=Qe.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return xe},this.setPixelRatio=function(C){C!==void 0&&(xe=C,this.setSize(_e,Te,!1))},this.getSize=function(C){return C.set(_e,Te)},this.setSize=function(C,W,te=!0){if(fe.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=C,Te=W,t.width=Math.floor(C*xe),t.height=Math.floor(W*xe),te===!0&&(t.style.width=C+"px",t.style.height=W+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,C,W)},this.getDrawingBufferSize=function(C){return C.set(_e*xe,Te*xe).floor()},this.setDrawingBufferSize=function(C,W,te){_e=C,Te=W,xe=te,t.width=Math.floor(C*te),t.height=Math.floor(W*te),this.setViewport(0,0,C,W)},this.setEffects=function(C){if(_===ri){ot("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let W=0;W<C.length;W++)if(C[W].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(ne)},this.getViewport=function(C){return C.copy(ae)},this.setViewport=function(C,W,te,Z){C.isVector4?ae.set(C.x,C.y,C.z,C.w):ae.set(C,W,te,Z),Ae.viewport(ne.copy(ae).multiplyScalar(fn()).round())},this.getScissor=function(C){return C.copy(Xe)},this.setScissor=function(C,W,te,Z){C.isVector4?Xe.set(C.x,C.y,C.z,C.w):Xe.set(C,W,te,Z),Ae.scissor(ue.copy(Xe).multiplyScalar(fn()).round())},this.getScissorTest=function(){return tt},this.setScissorTest=function(C){Ae.setScissorTest(tt=C)},this.setOpaqueSort=function(C){qe=C},this.setTransparentSort=function(C){st=C},this.getClearColor=function(C){return C.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(C=!0,W=!0,te=!0){let Z=0;if(C){let K=!1;if(he!==null){let Re=he.texture.format;K=m.has(Re)}if(K){let Re=he.texture.type,De=v.has(Re),Pe=B.getClearColor(),Ne=B.getClearAlpha(),We=Pe.r,at=Pe.g,_t=Pe.b;De?(x[0]=We,x[1]=at,x[2]=_t,x[3]=Ne,z.clearBufferuiv(z.COLOR,0,x)):(E[0]=We,E[1]=at,E[2]=_t,E[3]=Ne,z.clearBufferiv(z.COLOR,0,E))}else Z|=z.COLOR_BUFFER_BIT}W&&(Z|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),te&&(Z|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&z.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),L=C},this.dispose=function(){t.removeEventListener("webglcontextlost",Ge,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Le,!1),B.dispose(),Se.dispose(),ie.dispose(),Je.dispose(),$e.dispose(),I.dispose(),pe.dispose(),q.dispose(),we.dispose(),Ye.dispose(),le.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",_l),fe.removeEventListener("sessionend",Wi),as.stop()};function Ge(C){C.preventDefault(),yd("WebGLRenderer: Context Lost."),D=!0}function it(){yd("WebGLRenderer: Context Restored."),D=!1;let C=Vt.autoReset,W=ve.enabled,te=ve.autoUpdate,Z=ve.needsUpdate,K=ve.type;nt(),Vt.autoReset=C,ve.enabled=W,ve.autoUpdate=te,ve.needsUpdate=Z,ve.type=K}function Le(C){ot("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function dt(C){let W=C.target;W.removeEventListener("dispose",dt),Yt(W)}function Yt(C){Vn(C),$e.remove(C)}function Vn(C){let W=$e.get(C).programs;W!==void 0&&(W.forEach(function(te){le.releaseProgram(te)}),C.isShaderMaterial&&le.releaseShaderCache(C))}this.renderBufferDirect=function(C,W,te,Z,K,Re){W===null&&(W=Bt);let De=K.isMesh&&K.matrixWorld.determinantAffine()<0,Pe=Ya(C,W,te,Z,K);Ae.setMaterial(Z,De);let Ne=te.index,We=1;if(Z.wireframe===!0){if(Ne=q.getWireframeAttribute(te),Ne===void 0)return;We=2}let at=te.drawRange,_t=te.attributes.position,He=at.start*We,xt=(at.start+at.count)*We;Re!==null&&(He=Math.max(He,Re.start*We),xt=Math.min(xt,(Re.start+Re.count)*We)),Ne!==null?(He=Math.max(He,0),xt=Math.min(xt,Ne.count)):_t!=null&&(He=Math.max(He,0),xt=Math.min(xt,_t.count));let nn=xt-He;if(nn<0||nn===1/0)return;we.setup(K,Z,Pe,te,Ne);let Ot,Ft=se;if(Ne!==null&&(Ot=M.get(Ne),Ft=Ce,Ft.setIndex(Ot)),K.isMesh)Z.wireframe===!0?(Ae.setLineWidth(Z.wireframeLinewidth*fn()),Ft.setMode(z.LINES)):Ft.setMode(z.TRIANGLES);else if(K.isLine){let bn=Z.linewidth;bn===void 0&&(bn=1),Ae.setLineWidth(bn*fn()),K.isLineSegments?Ft.setMode(z.LINES):K.isLineLoop?Ft.setMode(z.LINE_LOOP):Ft.setMode(z.LINE_STRIP)}else K.isPoints?Ft.setMode(z.POINTS):K.isSprite&&Ft.setMode(z.TRIANGLES);if(K.isBatchedMesh)if(Qe.get("WEBGL_multi_draw"))Ft.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let bn=K._multiDrawStarts,Be=K._multiDrawCounts,pn=K._multiDrawCount,St=Ne?M.get(Ne).bytesPerElement:1,ls=$e.get(Z).currentProgram.getUniforms();for(let mn=0;mn<pn;mn++)ls.setValue(z,"_gl_DrawID",mn),Ft.render(bn[mn]/St,Be[mn])}else if(K.isInstancedMesh)Ft.renderInstances(He,nn,K.count);else if(te.isInstancedBufferGeometry){let bn=te._maxInstanceCount!==void 0?te._maxInstanceCount:1/0,Be=Math.min(te.instanceCount,bn);Ft.renderInstances(He,nn,Be)}else Ft.render(He,nn)};function Xa(C,W,te,Z){L!==null&&C.isNodeMaterial&&L.setObject(Z,C),Pt===!0&&re.setState(C,te,!1),C.transparent===!0&&C.side===si&&C.forceSinglePass===!1?(C.side=Kn,C.needsUpdate=!0,Xi(C,W,Z),C.side=Qs,C.needsUpdate=!0,Xi(C,W,Z),C.side=si):Xi(C,W,Z)}this.compile=function(C,W,te=null){te===null&&(te=C),L!==null&&L.renderStart(C,W,te),w=ie.get(te),w.init(W),A.push(w),te.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(w.pushLight(K),K.castShadow&&w.pushShadow(K))}),C!==te&&C.traverseVisible(function(K){K.isLight&&K.layers.test(W.layers)&&(w.pushLight(K),K.castShadow&&w.pushShadow(K))}),w.setupLights(),L!==null&&L.updateLights(w.state.lightsArray),qt=this.localClippingEnabled,Pt=re.init(this.clippingPlanes,qt),Pt===!0&&re.setGlobalState(this.clippingPlanes,W),L!==null&&ve.render(w.state.shadowsArray,te,W);let Z=new Set;return C.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Re=K.material;if(Re)if(Array.isArray(Re))for(let De=0;De<Re.length;De++){let Pe=Re[De];Xa(Pe,te,W,K),Z.add(Pe)}else Xa(Re,te,W,K),Z.add(Re)}),w=A.pop(),L!==null&&L.renderEnd(),Z},this.compileAsync=function(C,W,te=null){let Z=this.compile(C,W,te);return new Promise(K=>{function Re(){if(Z.forEach(function(De){let Ne=$e.get(De).currentProgram;(Ne===void 0||Ne.isReady())&&Z.delete(De)}),Z.size===0){K(C);return}setTimeout(Re,10)}Qe.get("KHR_parallel_shader_compile")!==null?Re():setTimeout(Re,10)})};let kr=null;function su(C){kr&&kr(C)}function _l(){as.stop()}function Wi(){as.start()}let as=new Hm;as.setAnimationLoop(su),typeof self<"u"&&as.setContext(self),this.setAnimationLoop=function(C){kr=C,fe.setAnimationLoop(C),C===null?as.stop():as.start()},fe.addEventListener("sessionstart",_l),fe.addEventListener("sessionend",Wi),this.render=function(C,W){if(W!==void 0&&W.isCamera!==!0){ot("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;L!==null&&L.renderStart(C,W);let te=fe.enabled===!0&&fe.isPresenting===!0,Z=k!==null&&(he===null||te)&&k.begin(U,he);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(W),W=fe.getCamera()),C.isScene===!0&&C.onBeforeRender(U,C,W,he),w=ie.get(C,A.length),w.init(W),w.state.textureUnits=Je.getTextureUnits(),A.push(w),Tt.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?pt.setFromArrayCamera(W):rt.setFromProjectionMatrix(Tt,Ti,W.reversedDepth),qt=this.localClippingEnabled,Pt=re.init(this.clippingPlanes,qt),R=Se.get(C,y.length),R.init(),y.push(R),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let De=U.xr.getDepthSensingMesh();De!==null&&os(De,W,-1/0,U.sortObjects)}os(C,W,0,U.sortObjects),R.finish(),L!==null&&L.updateLights(w.state.lightsArray),U.sortObjects===!0&&R.sort(qe,st),Wt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,Wt&&B.addToRenderList(R,C),this.info.autoReset===!0&&this.info.reset(),Pt===!0&&re.beginShadows();let K=w.state.shadowsArray;if(ve.render(K,C,W),Pt===!0&&re.endShadows(),(Z&&k.hasRenderPass())===!1){let De=R.opaque,Pe=R.transmissive;if(w.setupLights(),W.isArrayCamera){let Ne=W.cameras;if(Pe.length>0)for(let We=0,at=Ne.length;We<at;We++){let _t=Ne[We];Pi(De,Pe,C,_t)}Wt&&B.render(C);for(let We=0,at=Ne.length;We<at;We++){let _t=Ne[We];$a(R,C,_t,_t.viewport)}}else Pe.length>0&&Pi(De,Pe,C,W),Wt&&B.render(C),$a(R,C,W)}he!==null&&X===0&&(Je.updateMultisampleRenderTarget(he),Je.updateRenderTargetMipmap(he)),Z&&k.end(U),C.isScene===!0&&C.onAfterRender(U,C,W),we.resetDefaultState(),J=-1,ee=null,A.pop(),A.length>0?(w=A[A.length-1],Je.setTextureUnits(w.state.textureUnits),Pt===!0&&re.setGlobalState(U.clippingPlanes,w.state.camera)):w=null,y.pop(),y.length>0?R=y[y.length-1]:R=null,L!==null&&L.renderEnd()};function os(C,W,te,Z){if(C.visible===!1)return;if(C.layers.test(W.layers)){if(C.isGroup)te=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(W);else if(C.isLight)w.pushLight(C),C.castShadow&&w.pushShadow(C);else if(C.isSprite){let De=W.isArrayCamera?pt:rt;if(!C.frustumCulled||C.intersectsFrustum(De)){Z&&lt.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Tt);let Pe=pe.update(C),Ne=C.material;Ne.visible&&R.push(C,Pe,Ne,te,lt.z,null,W)}}else if(C.isMesh||C.isLine||C.isPoints){let De=W.isArrayCamera?pt:rt;if(!C.frustumCulled||C.intersectsFrustum(De)){let Pe=pe.update(C),Ne=C.material;if(Z&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),lt.copy(C.boundingSphere.center)):(Pe.boundingSphere===null&&Pe.computeBoundingSphere(),lt.copy(Pe.boundingSphere.center)),lt.applyMatrix4(C.matrixWorld).applyMatrix4(Tt)),Array.isArray(Ne)){let We=Pe.groups;for(let at=0,_t=We.length;at<_t;at++){let He=We[at],xt=Ne[He.materialIndex];xt&&xt.visible&&R.push(C,Pe,xt,te,lt.z,He,W)}}else Ne.visible&&R.push(C,Pe,Ne,te,lt.z,null,W)}}}let Re=C.children;for(let De=0,Pe=Re.length;De<Pe;De++)os(Re[De],W,te,Z)}function $a(C,W,te,Z){let{opaque:K,transmissive:Re,transparent:De}=C;w.setupLightsView(te),Pt===!0&&re.setGlobalState(U.clippingPlanes,te),Z&&Ae.viewport(ne.copy(Z)),K.length>0&&rn(K,W,te),Re.length>0&&rn(Re,W,te),De.length>0&&rn(De,W,te),Ae.buffers.depth.setTest(!0),Ae.buffers.depth.setMask(!0),Ae.buffers.color.setMask(!0),Ae.setPolygonOffset(!1)}function Pi(C,W,te,Z){if((te.isScene===!0?te.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[Z.id]===void 0){let He=Qe.has("EXT_color_buffer_half_float")||Qe.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[Z.id]=new vi(1,1,{generateMipmaps:!0,type:He?Bi:ri,minFilter:Es,samples:Math.max(4,ut.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:wt.workingColorSpace})}let Re=w.state.transmissionRenderTarget[Z.id],De=Z.viewport||ne;Re.setSize(De.z*U.transmissionResolutionScale,De.w*U.transmissionResolutionScale);let Pe=U.getRenderTarget(),Ne=U.getActiveCubeFace(),We=U.getActiveMipmapLevel();U.setRenderTarget(Re),U.getClearColor(Q),me=U.getClearAlpha(),me<1&&U.setClearColor(16777215,.5),U.clear(),Wt&&B.render(te);let at=U.toneMapping;U.toneMapping=ns;let _t=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),w.setupLightsView(Z),Pt===!0&&re.setGlobalState(U.clippingPlanes,Z),rn(C,te,Z),Je.updateMultisampleRenderTarget(Re),Je.updateRenderTargetMipmap(Re),Qe.has("WEBGL_multisampled_render_to_texture")===!1){let He=!1;for(let xt=0,nn=W.length;xt<nn;xt++){let Ot=W[xt],{object:Ft,geometry:bn,material:Be,group:pn}=Ot;if(Be.side===si&&Ft.layers.test(Z.layers)){let St=Be.side;Be.side=Kn,Be.needsUpdate=!0,cn(Ft,te,Z,bn,Be,pn),Be.side=St,Be.needsUpdate=!0,He=!0}}He===!0&&(Je.updateMultisampleRenderTarget(Re),Je.updateRenderTargetMipmap(Re))}U.setRenderTarget(Pe,Ne,We),U.setClearColor(Q,me),_t!==void 0&&(Z.viewport=_t),U.toneMapping=at}function rn(C,W,te){let Z=W.isScene===!0?W.overrideMaterial:null;for(let K=0,Re=C.length;K<Re;K++){let De=C[K],{object:Pe,geometry:Ne,group:We}=De,at=De.material;at.allowOverride===!0&&Z!==null&&(at=Z),Pe.layers.test(te.layers)&&cn(Pe,W,te,Ne,at,We)}}function cn(C,W,te,Z,K,Re){L!==null&&K.isNodeMaterial&&L.setObject(C,K),C.onBeforeRender(U,W,te,Z,K,Re),C.modelViewMatrix.multiplyMatrices(te.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),K.onBeforeRender(U,W,te,Z,C,Re),K.transparent===!0&&K.side===si&&K.forceSinglePass===!1?(K.side=Kn,K.needsUpdate=!0,U.renderBufferDirect(te,W,Z,K,C,Re),K.side=Qs,K.needsUpdate=!0,U.renderBufferDirect(te,W,Z,K,C,Re),K.side=si):U.renderBufferDirect(te,W,Z,K,C,Re),C.onAfterRender(U,W,te,Z,K,Re)}function hn(C){let W=0;for(let te of C)te.texture!==null&&W++;return W}function Xi(C,W,te){W.isScene!==!0&&(W=Bt);let Z=$e.get(C),K=w.state.lights,Re=w.state.shadowsArray,De=K.state.version,Pe=le.getParameters(C,K.state,Re,W,te,w.state.lightProbeGridArray),Ne=le.getProgramCacheKey(Pe),We=Z.programs;Z.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?W.environment:null,Z.fog=W.fog;let at=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;Z.envMap=I.get(C.envMap||Z.environment,at),Z.envMapRotation=Z.environment!==null&&C.envMap===null?W.environmentRotation:C.envMapRotation,We===void 0&&(C.addEventListener("dispose",dt),We=new Map,Z.programs=We,Z.programVariants=new Map);let _t=We.get(Ne);if(_t!==void 0){if(Z.currentProgram===_t&&Z.lightsStateVersion===De)return qa(C,Pe),_t}else Pe.uniforms=le.getUniforms(C),L!==null&&C.isNodeMaterial&&L.build(C,te,Pe),C.onBeforeCompile(Pe,U),_t=le.acquireProgram(Pe,Ne),We.set(Ne,_t),Z.uniforms=Pe.uniforms;let He=Z.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(He.clippingPlanes=re.uniform),qa(C,Pe),Z.needsLights=Ds(C),Z.lightsStateVersion=De,Z.needsLights&&(He.ambientLightColor.value=K.state.ambient,He.lightProbe.value=K.state.probe,He.sunLights.value=K.state.sun,He.sunLightShadows.value=K.state.sunShadow,He.directionalLights.value=K.state.directional,He.directionalLightShadows.value=K.state.directionalShadow,He.spotLights.value=K.state.spot,He.spotLightShadows.value=K.state.spotShadow,He.rectAreaLights.value=K.state.rectArea,He.ltc_1.value=K.state.rectAreaLTC1,He.ltc_2.value=K.state.rectAreaLTC2,He.pointLights.value=K.state.point,He.pointLightShadows.value=K.state.pointShadow,He.hemisphereLights.value=K.state.hemi,He.sunShadowMatrix.value=K.state.sunShadowMatrix,He.sunShadowCascade.value=K.state.sunShadowCascade,He.directionalShadowMatrix.value=K.state.directionalShadowMatrix,He.spotLightMatrix.value=K.state.spotLightMatrix,He.spotLightMap.value=K.state.spotLightMap,He.pointShadowMatrix.value=K.state.pointShadowMatrix),Z.numLightProbeGrids=hn(w.state.lightProbeGridArray),Z.currentProgram=_t,Z.uniformsList=null,_t}function oi(C,W,te,Z,K){let Re=$e.get(C),De=Re.currentProgram.id+","+Z+","+K,Pe=Re.programVariants.get(De);return Pe===void 0?(Pe=Xi(C,W,te),Re.programVariants.set(De,Pe)):(Re.currentProgram=Pe,Re.uniformsList=null,Re.outputColorSpace=Z,Re.toneMapping=K),Pe}function Is(C){if(C.uniformsList===null){let W=C.currentProgram.getUniforms();C.uniformsList=Ta.seqWithValue(W.seq,C.uniforms)}return C.uniformsList}function qa(C,W){let te=$e.get(C);te.outputColorSpace=W.outputColorSpace,te.batching=W.batching,te.batchingColor=W.batchingColor,te.instancing=W.instancing,te.instancingColor=W.instancingColor,te.instancingMorph=W.instancingMorph,te.skinning=W.skinning,te.morphTargets=W.morphTargets,te.morphNormals=W.morphNormals,te.morphColors=W.morphColors,te.morphTargetsCount=W.morphTargetsCount,te.numClippingPlanes=W.numClippingPlanes,te.numIntersection=W.numClipIntersection,te.vertexAlphas=W.vertexAlphas,te.vertexTangents=W.vertexTangents,te.toneMapping=W.toneMapping}function Ya(C,W,te,Z,K){W.isScene!==!0&&(W=Bt),Je.resetTextureUnits();let Re=W.fog,De=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?W.environment:null,Pe=he===null?U.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:wt.workingColorSpace,Ne=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,We=I.get(Z.envMap||De,Ne),at=Z.vertexColors===!0&&!!te.attributes.color&&te.attributes.color.itemSize===4,_t=!!te.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),He=!!te.morphAttributes.position,xt=!!te.morphAttributes.normal,nn=!!te.morphAttributes.color,Ot=ns;Z.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(Ot=U.toneMapping);let Ft=te.morphAttributes.position||te.morphAttributes.normal||te.morphAttributes.color,bn=Ft!==void 0?Ft.length:0,Be=$e.get(Z),pn=w.state.lights;if(Pt===!0&&(qt===!0||C!==ee)){let kt=C===ee&&Z.id===J;re.setState(Z,C,kt)}let St=!1,ls=!1;Z.version===Be.__version?Be.needsLights&&Be.lightsStateVersion!==pn.state.version||K.isBatchedMesh&&Be.batching===!1||!K.isBatchedMesh&&Be.batching===!0||K.isBatchedMesh&&Be.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Be.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Be.instancing===!1||!K.isInstancedMesh&&Be.instancing===!0||K.isSkinnedMesh&&Be.skinning===!1||!K.isSkinnedMesh&&Be.skinning===!0||K.isInstancedMesh&&Be.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Be.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Be.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Be.instancingMorph===!1&&K.morphTexture!==null||Be.envMap!==We||Z.fog===!0&&Be.fog!==Re||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==re.numPlanes||Be.numIntersection!==re.numIntersection)||Be.vertexAlphas!==at||Be.vertexTangents!==_t||Be.morphTargets!==He||Be.morphNormals!==xt||Be.morphColors!==nn||Be.morphTargetsCount!==bn||Be.numLightProbeGrids!==hn(w.state.lightProbeGridArray)?St=!0:(Be.outputColorSpace!==Pe||Be.toneMapping!==Ot)&&(ls=!0):(St=!0,Be.__version=Z.version);let mn=Be.currentProgram;(St===!0||ls===!0)&&(mn=ls===!0?oi(Z,W,K,Pe,Ot):Xi(Z,W,K),L&&Z.isNodeMaterial&&L.onUpdateProgram(Z,mn,Be));let Vr=!1,$i=!1,cs=!1,mt=mn.getUniforms(),an=Be.uniforms;if(Ae.useProgram(mn.program)&&(Vr=!0,$i=!0,cs=!0),Z.id!==J&&(J=Z.id,$i=!0),Vr||ee!==C){Ae.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),mt.setValue(z,"projectionMatrix",C.projectionMatrix),mt.setValue(z,"viewMatrix",C.matrixWorldInverse);let gn=mt.map.cameraPosition;gn!==void 0&&gn.setValue(z,sn.setFromMatrixPosition(C.matrixWorld)),ut.logarithmicDepthBuffer&&mt.setValue(z,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&mt.setValue(z,"isOrthographic",C.isOrthographicCamera===!0),ee!==C&&(ee=C,$i=!0,cs=!0)}if(Be.needsLights&&(pn.state.sunShadowMap.length>0&&mt.setValue(z,"sunShadowMap",pn.state.sunShadowMap,Je),pn.state.directionalShadowMap.length>0&&mt.setValue(z,"directionalShadowMap",pn.state.directionalShadowMap,Je),pn.state.spotShadowMap.length>0&&mt.setValue(z,"spotShadowMap",pn.state.spotShadowMap,Je),pn.state.pointShadowMap.length>0&&mt.setValue(z,"pointShadowMap",pn.state.pointShadowMap,Je)),K.isSkinnedMesh){mt.setOptional(z,K,"bindMatrix"),mt.setOptional(z,K,"bindMatrixInverse");let kt=K.skeleton;kt&&(kt.boneTexture===null&&kt.computeBoneTexture(),mt.setValue(z,"boneTexture",kt.boneTexture,Je))}K.isBatchedMesh&&(mt.setOptional(z,K,"batchingTexture"),mt.setValue(z,"batchingTexture",K._matricesTexture,Je),mt.setOptional(z,K,"batchingIdTexture"),mt.setValue(z,"batchingIdTexture",K._indirectTexture,Je),mt.setOptional(z,K,"batchingColorTexture"),K._colorsTexture!==null&&mt.setValue(z,"batchingColorTexture",K._colorsTexture,Je));let Gn=te.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&oe.update(K,te,mn),($i||Be.receiveShadow!==K.receiveShadow)&&(Be.receiveShadow=K.receiveShadow,mt.setValue(z,"receiveShadow",K.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&W.environment!==null&&(an.envMapIntensity.value=W.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=vM()),$i){if(mt.setValue(z,"toneMappingExposure",U.toneMappingExposure),Be.needsLights&&Br(an,cs),Re&&Z.fog===!0&&be.refreshFogUniforms(an,Re),be.refreshMaterialUniforms(an,Z,xe,Te,w.state.transmissionRenderTarget[C.id]),Be.needsLights&&Be.numLightProbeGrids>0){let kt=S,gn=0;for(let Un of w.state.lightProbeGridArray)Un.texture!==null&&(kt.textures[gn]=Un.texture,kt.min[gn]=Un.boundingBox.min,kt.max[gn]=Un.boundingBox.max,kt.resolution[gn]=Un.resolution,gn++);for(let Un in kt)kt[Un].length=gn;an.probesSH.value=kt.textures,an.probesMin.value=kt.min,an.probesMax.value=kt.max,an.probesResolution.value=kt.resolution}Ta.upload(z,Is(Be),an,Je)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Ta.upload(z,Is(Be),an,Je),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&mt.setValue(z,"center",K.center),mt.setValue(z,"modelViewMatrix",K.modelViewMatrix),mt.setValue(z,"normalMatrix",K.normalMatrix),mt.setValue(z,"modelMatrix",K.matrixWorld),Z.uniformsGroups!==void 0){let kt=Z.uniformsGroups;for(let gn=0,Un=kt.length;gn<Un;gn++){let xl=kt[gn];Ye.update(xl,mn),Ye.bind(xl,mn)}}return mn}function Br(C,W){C.ambientLightColor.needsUpdate=W,C.lightProbe.needsUpdate=W,C.sunLights.needsUpdate=W,C.sunLightShadows.needsUpdate=W,C.directionalLights.needsUpdate=W,C.directionalLightShadows.needsUpdate=W,C.pointLights.needsUpdate=W,C.pointLightShadows.needsUpdate=W,C.spotLights.needsUpdate=W,C.spotLightShadows.needsUpdate=W,C.rectAreaLights.needsUpdate=W,C.hemisphereLights.needsUpdate=W}function Ds(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return X},this.getRenderTarget=function(){return he},this.setRenderTargetTextures=function(C,W,te){let Z=$e.get(C);Z.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),$e.get(C.texture).__webglTexture=W,$e.get(C.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:te,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,W){let te=$e.get(C);te.__webglFramebuffer=W,te.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(C,W=0,te=0){he=C,Y=W,X=te;let Z=null,K=!1,Re=!1;if(C){let Pe=$e.get(C);if(Pe.__useDefaultFramebuffer!==void 0){Ae.bindFramebuffer(z.FRAMEBUFFER,Pe.__webglFramebuffer),ne.copy(C.viewport),ue.copy(C.scissor),de=C.scissorTest,Ae.viewport(ne),Ae.scissor(ue),Ae.setScissorTest(de),J=-1;return}else if(Pe.__webglFramebuffer===void 0)Je.setupRenderTarget(C);else if(Pe.__hasExternalTextures)Je.rebindTextures(C,$e.get(C.texture).__webglTexture,$e.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let at=C.depthTexture;if(Pe.__boundDepthTexture!==at){if(at!==null&&$e.has(at)&&(C.width!==at.image.width||C.height!==at.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Je.setupDepthRenderbuffer(C)}}let Ne=C.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Re=!0);let We=$e.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(We[W])?Z=We[W][te]:Z=We[W],K=!0):C.samples>0&&Je.useMultisampledRTT(C)===!1?Z=$e.get(C).__webglMultisampledFramebuffer:Array.isArray(We)?Z=We[te]:Z=We,ne.copy(C.viewport),ue.copy(C.scissor),de=C.scissorTest}else ne.copy(ae).multiplyScalar(xe).floor(),ue.copy(Xe).multiplyScalar(xe).floor(),de=tt;if(te!==0&&(Z=F),Ae.bindFramebuffer(z.FRAMEBUFFER,Z)&&Ae.drawBuffers(C,Z),Ae.viewport(ne),Ae.scissor(ue),Ae.setScissorTest(de),K){let Pe=$e.get(C.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+W,Pe.__webglTexture,te)}else if(Re){let Pe=W;for(let Ne=0;Ne<C.textures.length;Ne++){let We=$e.get(C.textures[Ne]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Ne,We.__webglTexture,te,Pe)}}else if(C!==null&&te!==0){let Pe=$e.get(C.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Pe.__webglTexture,te)}J=-1};function zr(C){let W=$e.get(C);return(W.__readFormat!==C.format||W.__readType!==C.type)&&(W.__readFormat=C.format,W.__readType=C.type,W.__formatReadable=ut.textureFormatReadable(C.format),W.__typeReadable=ut.textureTypeReadable(C.type)),W}this.readRenderTargetPixels=function(C,W,te,Z,K,Re,De,Pe=0){if(!(C&&C.isWebGLRenderTarget)){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=$e.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Ae.bindFramebuffer(z.FRAMEBUFFER,Ne);try{let We=C.textures[Pe],at=We.format,_t=We.type;C.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Pe);let He=zr(We);if(He.__formatReadable===!1){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(He.__typeReadable===!1){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=C.width-Z&&te>=0&&te<=C.height-K&&z.readPixels(W,te,Z,K,ye.convert(at),ye.convert(_t),Re)}finally{let We=he!==null?$e.get(he).__webglFramebuffer:null;Ae.bindFramebuffer(z.FRAMEBUFFER,We)}}},this.readRenderTargetPixelsAsync=async function(C,W,te,Z,K,Re,De,Pe=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=$e.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(W>=0&&W<=C.width-Z&&te>=0&&te<=C.height-K){Ae.bindFramebuffer(z.FRAMEBUFFER,Ne);let We=C.textures[Pe],at=We.format,_t=We.type;C.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Pe);let He=zr(We);if(He.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(He.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xt=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,xt),z.bufferData(z.PIXEL_PACK_BUFFER,Re.byteLength,z.STREAM_READ),z.readPixels(W,te,Z,K,ye.convert(at),ye.convert(_t),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let nn=he!==null?$e.get(he).__webglFramebuffer:null;Ae.bindFramebuffer(z.FRAMEBUFFER,nn);let Ot=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await pm(z,Ot,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,xt),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Re),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(xt),z.deleteSync(Ot),Re}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,W=null,te=0){let Z=Math.pow(2,-te),K=Math.floor(C.image.width*Z),Re=Math.floor(C.image.height*Z),De=W!==null?W.x:0,Pe=W!==null?W.y:0;Je.setTexture2D(C,0),z.copyTexSubImage2D(z.TEXTURE_2D,te,0,0,De,Pe,K,Re),Ae.unbindTexture()},this.copyTextureToTexture=function(C,W,te=null,Z=null,K=0,Re=0){let De,Pe,Ne,We,at,_t,He,xt,nn,Ot=C.isCompressedTexture?C.mipmaps[Re]:C.image;if(te!==null)De=te.max.x-te.min.x,Pe=te.max.y-te.min.y,Ne=te.isBox3?te.max.z-te.min.z:1,We=te.min.x,at=te.min.y,_t=te.isBox3?te.min.z:0;else{let mt=Math.pow(2,-K);De=Math.floor(Ot.width*mt),Pe=Math.floor(Ot.height*mt),C.isDataArrayTexture?Ne=Ot.depth:C.isData3DTexture?Ne=Math.floor(Ot.depth*mt):Ne=1,We=0,at=0,_t=0}Z!==null?(He=Z.x,xt=Z.y,nn=Z.z):(He=0,xt=0,nn=0);let Ft=ye.convert(W.format),bn=ye.convert(W.type),Be;W.isData3DTexture?(Je.setTexture3D(W,0),Be=z.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Je.setTexture2DArray(W,0),Be=z.TEXTURE_2D_ARRAY):(Je.setTexture2D(W,0),Be=z.TEXTURE_2D),Ae.activeTexture(z.TEXTURE0),Ae.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,W.flipY),Ae.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),Ae.pixelStorei(z.UNPACK_ALIGNMENT,W.unpackAlignment);let pn=Ae.getParameter(z.UNPACK_ROW_LENGTH),St=Ae.getParameter(z.UNPACK_IMAGE_HEIGHT),ls=Ae.getParameter(z.UNPACK_SKIP_PIXELS),mn=Ae.getParameter(z.UNPACK_SKIP_ROWS),Vr=Ae.getParameter(z.UNPACK_SKIP_IMAGES);Ae.pixelStorei(z.UNPACK_ROW_LENGTH,Ot.width),Ae.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Ot.height),Ae.pixelStorei(z.UNPACK_SKIP_PIXELS,We),Ae.pixelStorei(z.UNPACK_SKIP_ROWS,at),Ae.pixelStorei(z.UNPACK_SKIP_IMAGES,_t);let $i=C.isDataArrayTexture||C.isData3DTexture,cs=W.isDataArrayTexture||W.isData3DTexture;if(C.isDepthTexture){let mt=$e.get(C),an=$e.get(W),Gn=$e.get(mt.__renderTarget),kt=$e.get(an.__renderTarget);Ae.bindFramebuffer(z.READ_FRAMEBUFFER,Gn.__webglFramebuffer),Ae.bindFramebuffer(z.DRAW_FRAMEBUFFER,kt.__webglFramebuffer);for(let gn=0;gn<Ne;gn++)$i&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,$e.get(C).__webglTexture,K,_t+gn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,$e.get(W).__webglTexture,Re,nn+gn)),z.blitFramebuffer(We,at,We+De,at+Pe,He,xt,He+De,xt+Pe,z.DEPTH_BUFFER_BIT,z.NEAREST);Ae.bindFramebuffer(z.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(K!==0||C.isRenderTargetTexture||$e.has(C)){let mt=$e.get(C),an=$e.get(W);Ae.bindFramebuffer(z.READ_FRAMEBUFFER,P),Ae.bindFramebuffer(z.DRAW_FRAMEBUFFER,G);for(let Gn=0;Gn<Ne;Gn++)$i?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,mt.__webglTexture,K,_t+Gn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,mt.__webglTexture,K),cs?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,an.__webglTexture,Re,nn+Gn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,an.__webglTexture,Re),K!==0?z.blitFramebuffer(We,at,We+De,at+Pe,He,xt,He+De,xt+Pe,z.COLOR_BUFFER_BIT,z.NEAREST):cs?z.copyTexSubImage3D(Be,Re,He,xt,nn+Gn,We,at,De,Pe):z.copyTexSubImage2D(Be,Re,He,xt,We,at,De,Pe);Ae.bindFramebuffer(z.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else cs?C.isDataTexture||C.isData3DTexture?z.texSubImage3D(Be,Re,He,xt,nn,De,Pe,Ne,Ft,bn,Ot.data):W.isCompressedArrayTexture?z.compressedTexSubImage3D(Be,Re,He,xt,nn,De,Pe,Ne,Ft,Ot.data):z.texSubImage3D(Be,Re,He,xt,nn,De,Pe,Ne,Ft,bn,Ot):C.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Re,He,xt,De,Pe,Ft,bn,Ot.data):C.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Re,He,xt,Ot.width,Ot.height,Ft,Ot.data):z.texSubImage2D(z.TEXTURE_2D,Re,He,xt,De,Pe,Ft,bn,Ot);Ae.pixelStorei(z.UNPACK_ROW_LENGTH,pn),Ae.pixelStorei(z.UNPACK_IMAGE_HEIGHT,St),Ae.pixelStorei(z.UNPACK_SKIP_PIXELS,ls),Ae.pixelStorei(z.UNPACK_SKIP_ROWS,mn),Ae.pixelStorei(z.UNPACK_SKIP_IMAGES,Vr),Re===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&z.generateMipmap(Be),Ae.unbindTexture()},this.initRenderTarget=function(C){$e.get(C).__webglFramebuffer===void 0&&Je.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Je.setTextureCube(C,0):C.isData3DTexture?Je.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Je.setTexture2DArray(C,0):Je.setTexture2D(C,0),Ae.unbindTexture()},this.resetState=function(){Y=0,X=0,he=null,Ae.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=wt._getDrawingBufferColorSpace(e),t.unpackColorSpace=wt._getUnpackColorSpace()}};var eg={type:"change"},Vd={type:"start"},ng={type:"end"},Th=new xr,tg=new mi,_M=Math.cos(70*wd.DEG2RAD),wn=new V,ai=2*Math.PI,It={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},zd=1e-6,Ah=class extends Oo{constructor(e,t=null){super(e,t),this.state=It.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ks.ROTATE,MIDDLE:Ks.DOLLY,RIGHT:Ks.PAN},this.touches={ONE:js.ROTATE,TWO:js.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new Zn,this._lastTargetPosition=new V,this._quat=new Zn().setFromUnitVectors(e.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ya,this._sphericalDelta=new ya,this._scale=1,this._panOffset=new V,this._rotateStart=new Ve,this._rotateEnd=new Ve,this._rotateDelta=new Ve,this._panStart=new Ve,this._panEnd=new Ve,this._panDelta=new Ve,this._dollyStart=new Ve,this._dollyEnd=new Ve,this._dollyDelta=new Ve,this._dollyDirection=new V,this._mouse=new Ve,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=yM.bind(this),this._onPointerDown=xM.bind(this),this._onPointerUp=bM.bind(this),this._onContextMenu=CM.bind(this),this._onMouseWheel=wM.bind(this),this._onKeyDown=EM.bind(this),this._onTouchStart=TM.bind(this),this._onTouchMove=AM.bind(this),this._onMouseDown=SM.bind(this),this._onMouseMove=MM.bind(this),this._interceptControlDown=RM.bind(this),this._interceptControlUp=PM.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=It.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(eg),this.update(),this.state=It.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;wn.copy(t).sub(this.target),wn.applyQuaternion(this._quat),this._spherical.setFromVector3(wn),this.autoRotate&&this.state===It.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ai:n>Math.PI&&(n-=ai),s<-Math.PI?s+=ai:s>Math.PI&&(s-=ai),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(wn.setFromSpherical(this._spherical),wn.applyQuaternion(this._quatInverse),t.copy(this.target).add(wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){let o=wn.length();a=this._clampDistance(o*this._scale);let l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let o=new V(this._mouse.x,this._mouse.y,0);o.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new V(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(Th.origin.copy(this.object.position),Th.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Th.direction))<_M?this.object.lookAt(this.target):(tg.setFromNormalAndCoplanarPoint(this.object.up,this.target),Th.intersectPlane(tg,this.target))))}else if(this.object.isOrthographicCamera){let a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>zd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>zd||this._lastTargetPosition.distanceToSquared(this.target)>zd?(this.dispatchEvent(eg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ai/60*this.autoRotateSpeed*e:ai/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){wn.setFromMatrixColumn(t,0),wn.multiplyScalar(-e),this._panOffset.add(wn)}_panUp(e,t){this.screenSpacePanning===!0?wn.setFromMatrixColumn(t,1):(wn.setFromMatrixColumn(t,0),wn.crossVectors(this.object.up,wn)),wn.multiplyScalar(e),this._panOffset.add(wn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;wn.copy(s).sub(this.target);let r=wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,a=n.width,o=n.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/t.clientHeight),this._rotateUp(ai*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/t.clientHeight),this._rotateUp(ai*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ve,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function xM(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function yM(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function bM(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(ng),this.state=It.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function SM(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Ks.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=It.DOLLY;break;case Ks.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}break;case Ks.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=It.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=It.PAN}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(Vd)}function MM(i){switch(this.state){case It.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case It.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case It.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function wM(i){this.enabled===!1||this.enableZoom===!1||this.state!==It.NONE||(i.preventDefault(),this.dispatchEvent(Vd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(ng))}function EM(i){this.enabled!==!1&&this._handleKeyDown(i)}function TM(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case js.ROTATE:if(this.enableRotate===!1){this.state=It.NONE;break}this._handleTouchStartRotate(i),this.state=It.TOUCH_ROTATE;break;case js.PAN:if(this.enablePan===!1){this.state=It.NONE;break}this._handleTouchStartPan(i),this.state=It.TOUCH_PAN;break;default:this.state=It.NONE}break;case 2:switch(this.touches.TWO){case js.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=It.TOUCH_DOLLY_PAN;break;case js.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=It.TOUCH_DOLLY_ROTATE;break;default:this.state=It.NONE}break;default:this.state=It.NONE}this.state!==It.NONE&&this.dispatchEvent(Vd)}function AM(i){switch(this._trackPointer(i),this.state){case It.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case It.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case It.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case It.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=It.NONE}}function CM(i){this.enabled!==!1&&i.preventDefault()}function RM(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function PM(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Ar=new V(0,1,0),LM=16,IM=matchMedia("(max-width: 40rem)"),DM=13,ig={space:[1,.75,.5],front:[1,0,0],side:[0,1,0],top:[0,0,1]},Cr=class{mesh;constructor(e,t,n){this.mesh=new dn(new va(n,n,1,10),t),e.add(this.mesh)}between(e,t){let n=t.clone().sub(e),s=n.length()||1e-6;this.mesh.position.copy(e).addScaledVector(n,.5),this.mesh.quaternion.setFromUnitVectors(Ar,n.divideScalar(s)),this.mesh.scale.set(1,s,1)}};function NM(i,e){let t=[];for(let n=0;n<=16*e;n++){let s=n/(16*e),r=2*Math.PI*e*s;t.push(new V(i*Math.cos(r),s,i*Math.sin(r)))}return new un().setFromPoints(t)}var tr=class{element=f("div",{class:"mechanism"});canvas=f("canvas",{tabindex:"0","aria-label":Mt("mechanism")});state=f("div",{class:"state"});names=f("div",{class:"names"});legend=f("ul",{class:"legend"});space=new _o;camera=new br;renderer=null;controls=null;group=new qn;shown=null;motion=null;points=[];update=[];spin=new V(0,1,0);now={body:0,travel:0,ground:0,load:1,time:0};wheelGroup=new qn;pathGroup=new qn;labels=[];named=[];isDirty=!0;isLost=!1;isSeen=!1;size=300;reach=[300,300];centres=null;turned=[];chosen=null;halo=null;grabbed=null;way="view";constructor(e=!1){let t=f("div",{class:"group",role:"group","aria-label":Mt("view")});for(let l of Object.keys(ig))t.append(f("button",{type:"button",click:()=>this.look(l)},Mt(l)));let n=ui(Mt("wheel"),!0,l=>{this.wheelGroup.visible=l,this.isDirty=!0}),s=ui(Mt("paths"),e,l=>{this.pathGroup.visible=l,this.isDirty=!0}),r=e&&!IM.matches,a=ui(Mt("names"),r,l=>{this.names.hidden=!l,this.isDirty=!0});this.names.hidden=!r,this.pathGroup.visible=e,this.element.append(f("div",{class:"bar"},t,f("div",{class:"group"},n,s,a)),f("div",{class:"stage"},this.canvas,this.names,this.state)),e&&this.element.append(this.legend),this.space.add(new Uo(16777215,1.9),this.group);let o=new No(16777215,1.9);o.position.set(.6,.3,1),this.space.add(o),this.camera.up.set(0,0,1),this.controls=new Ah(this.camera,this.canvas),this.controls.enableZoom=!1,this.canvas.addEventListener("focus",()=>{this.controls.enableZoom=!0}),this.canvas.addEventListener("blur",()=>{this.controls.enableZoom=!1}),this.canvas.addEventListener("pointerdown",()=>this.canvas.focus()),this.canvas.addEventListener("dblclick",()=>this.look("space")),this.controls.addEventListener("change",()=>{this.isDirty=!0}),this.canvas.parentElement.addEventListener("pointerdown",l=>this.take(l),{capture:!0}),new ResizeObserver(()=>this.resize()).observe(this.canvas.parentElement),new IntersectionObserver(l=>{this.isSeen=l.some(c=>c.isIntersecting)},{rootMargin:"300px"}).observe(this.element)}begin(){if(this.renderer||this.isLost)return!this.isLost;try{this.renderer=new Mh({canvas:this.canvas,antialias:Qa(),alpha:!0}),this.renderer.setPixelRatio(Qa()?Math.min(devicePixelRatio,2):1)}catch{return this.isLost=!0,this.state.textContent=Mt("noWebGL"),!1}return this.resize(),!0}show(e,t){let n=this.shown;this.motion=t,this.shown=e,n===null||rg(n)!==rg(e)?(this.build(e),this.look("space")):n!==e&&this.redraw(e),this.set(this.now)}set(e){let t=this.shown;if(this.now=e,!t)return;let{travel:n}=e,s=t.travel,r=s.length,a=Math.min(Sl(s,n),Math.max(r-2,0)),o=Math.min(a+1,r-1),l=o>a?(n-s[a])/(s[o]-s[a]):0;t.points.forEach((d,u)=>{let p=d[a],g=d[o];this.points[u].set(p[0]+l*(g[0]-p[0]),p[1]+l*(g[1]-p[1]),p[2]+l*(g[2]-p[2])+e.body)});let c=t.spin[a],h=t.spin[o];this.spin.set(c[0]+l*(h[0]-c[0]),c[1]+l*(h[1]-c[1]),c[2]+l*(h[2]-c[2])).normalize();for(let d of this.update)d();this.turnAbout(l<.5?a:o),this.isLost||(this.state.textContent=e.load>0?"":Mt("noContact")),this.isDirty=!0}draw(){!this.isDirty||!this.isSeen||!this.shown||!this.begin()||(this.isDirty=!1,this.renderer.render(this.space,this.camera),this.names.hidden||this.place())}showCentres(e){this.centres=e,this.set(this.now)}choose(e){this.chosen=e,this.set(this.now)}turnAbout(e){let t=this.shown,n=t.contact[e];for(let{line:r,mark:a,of:o}of this.turned){let l=this.centres?.[o][e];if(r.visible=a.visible=!!l&&!!n,!l||!n)continue;let c=new V(n[0],n[1],n[2]+this.now.body),h=o==="side"?new V(l[0],c.y,l[1]):new V(c.x,l[0],l[1]);h.z+=this.now.body,r.geometry.setFromPoints([c,h]),a.position.copy(h)}if(!this.halo)return;let s=this.chosen===null?-1:t.names.indexOf(this.chosen);this.halo.visible=s>=0,s>=0&&this.halo.position.copy(this.points[s])}take(e){let t=this.shown;if(!this.grabbed||!t||e.button!==0||e.target!==this.canvas)return;let n=this.canvas.getBoundingClientRect(),s=new V,r=LM,a=-1;if(t.names.forEach((g,_)=>{if(t.feet.includes(_))return;s.copy(this.points[_]).project(this.camera);let m=Math.hypot(n.left+(.5+.5*s.x)*n.width-e.clientX,n.top+(.5-.5*s.y)*n.height-e.clientY);m<r&&(r=m,a=_)}),a<0)return;e.stopPropagation(),e.preventDefault(),this.canvas.focus({preventScroll:!0});let o=t.names[a],l=(this.camera.right-this.camera.left)/this.camera.zoom/n.width,c=new V().setFromMatrixColumn(this.camera.matrixWorld,0),h=new V().setFromMatrixColumn(this.camera.matrixWorld,1),d=g=>{let _=l*(g.clientX-e.clientX),m=-l*(g.clientY-e.clientY);if(this.way==="view")return c.clone().multiplyScalar(_).addScaledVector(h,m).toArray();let v="xyz".indexOf(this.way),x=c.getComponent(v),E=h.getComponent(v),S=x*x+E*E,R=[0,0,0];return S>.02&&(R[v]=(_*x+m*E)/S),R},u=g=>this.grabbed?.(o,d(g),!1),p=g=>{removeEventListener("pointermove",u),removeEventListener("pointerup",p),removeEventListener("pointercancel",p),this.grabbed?.(o,g.type==="pointerup"?d(g):[0,0,0],!0)};addEventListener("pointermove",u),addEventListener("pointerup",p),addEventListener("pointercancel",p),this.grabbed(o,[0,0,0],!1)}look(e){if(!this.controls||!this.shown)return;let[t,n,s]=ig[e],r=this.shown.side,a=new V(1/0,1/0,1/0),o=a.clone().negate();for(let _ of this.points)a.min(_),o.max(_);let{centre:l,radius:c,width:h}=this.shown.wheel,d=this.points[l];a.min(new V(d.x-c,d.y-h/2,d.z-c)),o.max(new V(d.x+c,d.y+h/2,d.z+c));let u=a.clone().add(o).multiplyScalar(.5);this.size=.5*a.distanceTo(o),this.controls.target.copy(u),this.camera.position.copy(u).add(new V(t,r*n,s+(e==="top"?0:.001)).normalize().multiplyScalar(6*this.size)),e==="top"&&(this.camera.position.x-=.01*this.size),this.camera.zoom=1,this.camera.near=.1,this.camera.far=20*this.size,this.controls.update(),this.camera.updateMatrixWorld();let p=o.clone().sub(a).multiplyScalar(.5),g=new V;this.reach=[0,1].map(_=>(g.setFromMatrixColumn(this.camera.matrixWorld,_),Math.abs(g.x)*p.x+Math.abs(g.y)*p.y+Math.abs(g.z)*p.z)),this.frame(),this.isDirty=!0}repaint(){this.shown&&(this.build(this.shown),this.set(this.now))}frame(){let{clientWidth:e,clientHeight:t}=this.canvas.parentElement,[n,s]=this.reach,r=Math.max(e,1)/Math.max(t,1),a=1.15*Math.max(s,n/r),o=a*r;Object.assign(this.camera,{left:-o,right:o,top:a,bottom:-a}),this.camera.updateProjectionMatrix()}resize(){let{clientWidth:e,clientHeight:t}=this.canvas.parentElement;!this.renderer||e<10||t<10||(this.renderer.setSize(e,t,!1),this.frame(),this.isDirty=!0)}redraw(e){for(let[t,n]of this.pathGroup.children.entries())n.geometry.setFromPoints(sg(t?e.contact:e.points[e.wheel.centre]))}build(e){this.space.remove(this.group),this.group.traverse(r=>{(r instanceof dn||r instanceof Ss)&&r.geometry.dispose()}),this.group=new qn,this.space.add(this.group),this.update=[],this.points=e.points.map(r=>new V(r[0][0],r[0][1],r[0][2]));let t=e.wheel.radius/22,n=yt("ink"),s=r=>r==="#22262b"?n:r;for(let r of e.parts){let a=new Jn({color:new je(s(r.colour))});if(r.coil){this.coil(a,r.points[0],r.points[1],e,t);continue}let o=r.points.map((l,c)=>[c,c+1]).slice(0,-1);r.plate&&o.push([r.points.length-1,0]);for(let[l,c]of o){let h=new Cr(this.group,a,t);this.update.push(()=>h.between(this.points[r.points[l]],this.points[r.points[c]]))}r.plate&&r.points.length>=3&&this.plate(r.points,s(r.colour))}for(let[r,[a,o,l,,c]]of e.brackets.entries()){let h=new Cr(this.group,new Jn({color:new je(s(c))}),.5*t);this.update.push(()=>h.between(this.points[a],this.points[o].clone().lerp(this.points[l],this.shown.brackets[r][3])))}this.strut(e,t),this.joints(e,t),this.wheel(e),this.road(e),this.axis(e),this.paths(e),this.marks(t),this.named=e.names.map((r,a)=>a).filter(r=>!e.feet.includes(r)),this.names.replaceChildren(...this.labels=this.named.map(r=>f("span",{},e.names[r].replaceAll("_"," ")))),this.legend.replaceChildren(...[...e.parts,{words:Mt("strut"),colour:e.strut.colour}].map(r=>{let a=f("i",{class:"swatch"});return a.style.background=s(r.colour),f("li",{},a,r.words)}))}marks(e){let t={front:yt("other-1"),side:yt("other-3"),roll:yt("accent")};this.turned=Object.keys(t).map(n=>{let s=new Ss(new un().setFromPoints([Ar,Ar]),new bs({color:new je(t[n])})),r=new dn(n==="roll"?new ws(3*e,3*e,3*e):new yr(2*e,12,8),new Jn({color:new je(t[n])}));return s.frustumCulled=!1,s.visible=r.visible=!1,this.group.add(s,r),{line:s,mark:r,of:n}}),this.halo=new dn(new yr(2.6*e,16,12),new Jn({color:new je(yt("accent")),transparent:!0,opacity:.7})),this.halo.visible=!1,this.group.add(this.halo)}axis(e){if(!e.axis)return;let[t,n]=e.axis,s=new un().setFromPoints([Ar,Ar]),r=new Ss(s,new Po({color:new je(yt("muted")),dashSize:12,gapSize:7}));r.frustumCulled=!1,this.group.add(r),this.update.push(()=>{let a=this.points[t],o=this.points[n].clone().sub(a);s.setFromPoints([a.clone().addScaledVector(o,-.3),a.clone().addScaledVector(o,1.3)]),r.computeLineDistances()})}paths(e){let t=this.pathGroup.visible,n=new bs({color:new je(yt("accent"))});this.pathGroup=new qn,this.pathGroup.visible=t;for(let s of[e.points[e.wheel.centre],e.contact])this.pathGroup.add(new Ss(new un().setFromPoints(sg(s)),n));this.group.add(this.pathGroup),this.update.push(()=>this.pathGroup.position.setZ(this.now.body))}plate(e,t){let n=new un,s=e.length-2,r=new Float32Array(9*s);n.setAttribute("position",new ni(r,3));let a=new Jn({color:new je(t),transparent:!0,opacity:.25,side:si,depthWrite:!1}),o=new dn(n,a);o.frustumCulled=!1,this.group.add(o),this.update.push(()=>{for(let l=0;l<s;l++)[e[0],e[l+1],e[l+2]].forEach((c,h)=>this.points[c].toArray(r,9*l+3*h));n.attributes.position.needsUpdate=!0,n.computeVertexNormals()})}strut(e,t){let n=new Jn({color:new je(e.strut.colour)}),s=new Cr(this.group,n,.6*t),r=new Cr(this.group,n,1.7*t),[a,o]=e.strut.damper;this.update.push(()=>{let h=this.points[a],d=this.points[o];s.between(h,d),r.between(h,h.clone().addScaledVector(d.clone().sub(h).normalize(),e.strut.tube))});let[l,c]=e.strut.spring;this.coil(n,l,c,e,t)}coil(e,t,n,s,r){let a=NM(s.strut.radius,s.strut.coils),o=new _a(UM(a)),l=new Ro(o,14*s.strut.coils,1,5),c=l.attributes.position.array.slice(),h=o.getSpacedPoints(14*s.strut.coils),d=new dn(l,e);this.group.add(d);let u=.55*r,p=new Zn;this.update.push(()=>{let g=this.points[t],_=this.points[n].clone().sub(g),m=_.length();p.setFromUnitVectors(Ar,_.normalize());let v=l.attributes.position,x=new V,E=6;for(let S=0;S<v.count;S++){let R=h[Math.floor(S/E)];x.set(c[3*S]-R.x,0,c[3*S+2]-R.z);let w=c[3*S+1]-R.y;x.multiplyScalar(u).add(new V(R.x,(.08+.84*R.y)*m+u*w,R.z)),x.applyQuaternion(p).add(g),v.setXYZ(S,x.x,x.y,x.z)}v.needsUpdate=!0,l.computeVertexNormals()}),d.frustumCulled=!1}joints(e,t){let n=new yr(1.5*t,12,8),s=new ws(2.6*t,2.6*t,2.6*t),r=new Jn({color:new je(yt("muted"))}),a=new Jn({color:new je(yt("ink"))});e.names.forEach((o,l)=>{if(l===e.wheel.centre||e.feet.includes(l))return;let c=new dn(e.onBody[l]?s:n,e.onBody[l]?r:a);this.group.add(c),this.update.push(()=>c.position.copy(this.points[l]))})}wheel(e){let{radius:t,width:n,centre:s}=e.wheel,r=this.wheelGroup.visible;this.wheelGroup=new qn,this.wheelGroup.visible=r,this.group.add(this.wheelGroup);let a=new Jn({color:new je(yt("rubber")),transparent:!0,opacity:.3,depthWrite:!1,side:si}),o=new dn(new va(t,t,.8*n,48,1,!0),a),l=[-.4,.4].map(d=>{let u=new dn(new Co(.93*t,.07*t,8,48),a);return u.rotateX(Math.PI/2),u.position.y=d*n,u}),c=new qn,h=new Jn({color:new je(yt("rubber"))});for(let d=0;d<5;d++){let u=new Cr(c,h,t/60),p=2*Math.PI*d/5,g=.4*n*e.side;u.between(new V(.12*t*Math.cos(p),g,.12*t*Math.sin(p)),new V(.8*t*Math.cos(p),g,.8*t*Math.sin(p)))}this.wheelGroup.add(o,...l,c),this.update.push(()=>{this.wheelGroup.position.copy(this.points[s]);let d=this.spin.clone().multiplyScalar(e.side);this.wheelGroup.quaternion.setFromUnitVectors(Ar,d);let u=this.motion?.road?this.motion.road.speed*this.now.time:0;c.rotation.y=u/t})}road(e){let t=2.4*e.wheel.radius,n=.8*e.wheel.width,s=121,r=new un,a=new Float32Array(6*s),o=[];for(let u=0;u<s-1;u++)o.push(2*u,2*u+1,2*u+2,2*u+1,2*u+3,2*u+2);r.setAttribute("position",new ni(a,3)),r.setIndex(o);let l=new dn(r,new Jn({color:new je(yt("road")),side:si}));l.frustumCulled=!1;let c=new un,h=new Float32Array(12*(s-1));c.setAttribute("position",new ni(h,3));let d=new bo(c,new bs({color:new je(yt("muted"))}));d.frustumCulled=!1,this.group.add(l,d),this.update.push(()=>{let u=this.points[e.wheel.centre],p=this.motion?.road,g=p?p.speed*this.now.time:0;for(let _=0;_<s;_++){let m=-t+2*t*_/(s-1),v=p?OM(p,g+m):this.now.ground;a.set([u.x+m,u.y-n,v,u.x+m,u.y+n,v],6*_)}for(let _=0;_<s-1;_++)for(let m of[0,3])h.set([...a.subarray(6*_+m,6*_+m+3),...a.subarray(6*_+6+m,6*_+9+m)],12*_+2*m);r.attributes.position.needsUpdate=c.attributes.position.needsUpdate=!0,r.computeVertexNormals()})}place(){let{clientWidth:e,clientHeight:t}=this.canvas.parentElement,n=new V,s=this.labels.map(a=>a.offsetWidth),r=this.labels.map((a,o)=>{n.copy(this.points[this.named[o]]).project(this.camera);let l=(.5+.5*n.x)*e,c=s[o];return{label:a,width:c,x:l+c+8<e?l+7:l-c-7,y:(.5-.5*n.y)*t-8}}).sort((a,o)=>a.y-o.y);r.forEach((a,o)=>{let l=r.slice(0,o).filter(c=>c.x<a.x+a.width&&a.x<c.x+c.width);a.y=Math.max(a.y,...l.map(c=>c.y+DM)),a.label.style.transform=`translate(${a.x}px, ${a.y}px)`})}};function sg(i){return i.map(e=>new V(e[0],e[1],e[2]))}function rg({points:i,spin:e,contact:t,travel:n,brackets:s,...r}){return JSON.stringify([r,s.map(([a,o,l])=>[a,o,l])])}function UM(i){let e=i.attributes.position;return Array.from({length:e.count},(t,n)=>new V(e.getX(n),e.getY(n),e.getZ(n)))}function OM(i,e){let{x:t,z:n}=i,s=t.length;if(e<=t[0])return n[0];if(e>=t[s-1])return n[s-1];let r=Sl(t,e),a=t[r],o=t[r+1];return o>a?n[r]+(n[r+1]-n[r])*(e-a)/(o-a):n[r+1]}var FM="uplot",kM="u-hz",BM="u-vt",zM="u-title",VM="u-wrap",GM="u-under",HM="u-over",WM="u-axis",Lr="u-off",XM="u-select",$M="u-cursor-x",qM="u-cursor-y",YM="u-cursor-pt",ZM="u-legend",JM="u-live",KM="u-inline",jM="u-series",QM="u-marker",ag="u-label",ew="u-value",Jo="width",Ko="height";var og="bottom",Ca="left",Gd="right",af="#000",lg=af+"0",Hd="mousemove",cg="mousedown",Wd="mouseup",hg="mouseenter",ug="mouseleave",dg="dblclick",tw="resize",nw="scroll",fg="change",Ih="dppxchange",of="--",Ua=typeof window<"u",Zd=Ua?document:null,Pa=Ua?window:null,iw=Ua?navigator:null,Dt,Ch;function Jd(){let i=devicePixelRatio;Dt!=i&&(Dt=i,Ch&&jd(fg,Ch,Jd),Ch=matchMedia(`(min-resolution: ${Dt-.001}dppx) and (max-resolution: ${Dt+.001}dppx)`),Ir(fg,Ch,Jd),Pa.dispatchEvent(new CustomEvent(Ih)))}function xi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Kd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Qt(i,e,t){i.style[e]=t+"px"}function Vi(i,e,t,n){let s=Zd.createElement(i);return e!=null&&xi(s,e),t?.insertBefore(s,n),s}function Ci(i,e){return Vi("div",i,e)}var pg=new WeakMap;function rs(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",a=pg.get(i);r!=a&&(i.style.transform=r,pg.set(i,r),e<0||t<0||e>n||t>s?xi(i,Lr):Kd(i,Lr))}var mg=new WeakMap;function gg(i,e,t){let n=e+t,s=mg.get(i);n!=s&&(mg.set(i,n),i.style.background=e,i.style.borderColor=t)}var vg=new WeakMap;function _g(i,e,t,n){let s=e+""+t,r=vg.get(i);s!=r&&(vg.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var lf={passive:!0},sw={...lf,capture:!0};function Ir(i,e,t,n){e.addEventListener(i,t,n?sw:lf)}function jd(i,e,t,n){e.removeEventListener(i,t,lf)}Ua&&Jd();function Gi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:yi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function $g(i){return(t,n,s)=>{let r=-1,a=-1;for(let o=n;o<=s;o++)if(i(t[o])){r=o;break}for(let o=s;o>=n;o--)if(i(t[o])){a=o;break}return[r,a]}}var qg=i=>i!=null,Yg=i=>i!=null&&i>0,Uh=$g(qg),rw=$g(Yg);function aw(i,e,t,n=0,s=!1){let r=s?rw:Uh,a=s?Yg:qg;[e,t]=r(i,e,t);let o=i[e],l=i[e];if(e>-1)if(n==1)o=i[e],l=i[t];else if(n==-1)o=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];a(h)&&(h<o?o=h:h>l&&(l=h))}return[o??Gt,l??-Gt]}function Oh(i,e,t,n){let s=bg(i),r=bg(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let a=t==10?Cs:Zg,o=s==1?yi:Ri,l=r==1?Ri:yi,c=o(a(Tn(i))),h=l(a(Tn(e))),d=La(t,c),u=La(t,h);return t==10&&(c<0&&(d=Ht(d,-c)),h<0&&(u=Ht(u,-h))),n||t==2?(i=d*s,e=u*r):(i=Qg(i,d),e=Fh(e,u)),[i,e]}function cf(i,e,t,n){let s=Oh(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var hf=.1,xg={mode:3,pad:hf},Qo={pad:0,soft:null,mode:0},ow={min:Qo,max:Qo};function Dh(i,e,t,n){return kh(t)?yg(i,e,t):(Qo.pad=t,Qo.soft=n?0:null,Qo.mode=n?3:0,yg(i,e,ow))}function Rt(i,e){return i??e}function lw(i,e,t){for(e=Rt(e,0),t=Rt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function yg(i,e,t){let n=t.min,s=t.max,r=Rt(n.pad,0),a=Rt(s.pad,0),o=Rt(n.hard,-Gt),l=Rt(s.hard,Gt),c=Rt(n.soft,Gt),h=Rt(s.soft,-Gt),d=Rt(n.mode,0),u=Rt(s.mode,0),p=e-i,g=Cs(p),_=jn(Tn(i),Tn(e)),m=Cs(_),v=Tn(m-g);(p<1e-24||v>10)&&(p=0,(i==0||e==0)&&(p=1e-24,d==2&&c!=Gt&&(r=0),u==2&&h!=-Gt&&(a=0)));let x=p||_||1e3,E=Cs(x),S=La(10,yi(E)),R=x*(p==0?i==0?.1:1:r),w=Ht(Qg(i-R,S/10),24),y=i>=c&&(d==1||d==3&&w<=c||d==2&&w>=c)?c:Gt,A=jn(o,w<y&&i>=y?y:Hi(y,w)),k=x*(p==0?e==0?.1:1:a),U=Ht(Fh(e+k,S/10),24),D=e<=h&&(u==1||u==3&&U>=h||u==2&&U<=h)?h:-Gt,L=Hi(l,U>D&&e<=D?D:jn(D,U));return A==L&&A==0&&(L=100),[A,L]}var cw=new Intl.NumberFormat(Ua?iw.language:"en-US"),uf=i=>cw.format(i),bi=Math,Lh=bi.PI,Tn=bi.abs,yi=bi.floor,En=bi.round,Ri=bi.ceil,Hi=bi.min,jn=bi.max,La=bi.pow,bg=bi.sign,Cs=bi.log10,Zg=bi.log2,hw=(i,e=1)=>bi.sinh(i)*e,Xd=(i,e=1)=>bi.asinh(i/e),Gt=1/0;function Sg(i){return(Cs((i^i>>31)-(i>>31))|0)+1}function Qd(i,e,t){return Hi(jn(i,e),t)}function Jg(i){return typeof i=="function"}function Et(i){return Jg(i)?i:()=>i}var uw=()=>{},Kg=i=>i,jg=(i,e)=>e,dw=i=>null,Mg=i=>!0,wg=(i,e)=>i==e,fw=/\.\d*?(?=9{6,}|0{6,})/gm,Dr=i=>{if(t0(i)||ir.has(i))return i;let e=`${i}`,t=e.match(fw);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Dr(s)}e${r}`}return Ht(i,n)};function Rr(i,e){return Dr(Ht(Dr(i/e))*e)}function Fh(i,e){return Dr(Ri(Dr(i/e))*e)}function Qg(i,e){return Dr(yi(Dr(i/e))*e)}function Ht(i,e=0){if(t0(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return En(n)/t}var ir=new Map;function e0(i){return((""+i).split(".")[1]||"").length}function tl(i,e,t,n){let s=[],r=n.map(e0);for(let a=e;a<t;a++){let o=Tn(a),l=Ht(La(i,a),o);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${a}`:n[c]*l,d=(a>=0?0:o)+(a>=r[c]?0:r[c]),u=i==10?h:Ht(h,d);s.push(u),ir.set(u,d)}}return s}var el={},df=[],Ia=[null,null],nr=Array.isArray,t0=Number.isInteger,pw=i=>i===void 0;function Eg(i){return typeof i=="string"}function kh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function mw(i){return i!=null&&typeof i=="object"}var gw=Object.getPrototypeOf(Uint8Array),n0="__proto__";function Da(i,e=kh){let t;if(nr(i)){let n=i.find(s=>s!=null);if(nr(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Da(i[s],e)}else t=i.slice()}else if(i instanceof gw)t=i.slice();else if(e(i)){t={};for(let n in i)n!=n0&&(t[n]=Da(i[n],e))}else t=i;return t}function yn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=n0&&(kh(i[s])?yn(i[s],Da(n[s])):i[s]=Da(n[s]))}return i}var vw=0,_w=1,xw=2;function yw(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let a=e[n];if(a>r){for(s=a-1;s>=0&&i[s]==null;)i[s--]=null;for(s=a+1;s<t&&i[s]==null;)i[r=s++]=null}}}function bw(i,e){if(ww(i)){let a=i[0].slice();for(let o=1;o<i.length;o++)a.push(...i[o].slice(1));return Ew(a[0])||(a=Mw(a)),a}let t=new Set;for(let a=0;a<i.length;a++){let l=i[a][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((a,o)=>a-o)],s=n[0].length,r=new Map;for(let a=0;a<s;a++)r.set(n[0][a],a);for(let a=0;a<i.length;a++){let o=i[a],l=o[0];for(let c=1;c<o.length;c++){let h=o[c],d=Array(s).fill(void 0),u=e?e[a][c]:_w,p=[];for(let g=0;g<h.length;g++){let _=h[g],m=r.get(l[g]);_===null?u!=vw&&(d[m]=_,u==xw&&p.push(m)):d[m]=_}yw(d,p,s),n.push(d)}}return n}var Sw=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Mw(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,a)=>e[r]-e[a]);let s=[];for(let r=0;r<i.length;r++){let a=i[r],o=Array(t);for(let l=0;l<t;l++)o[l]=a[n[l]];s.push(o)}return s}function ww(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Ew(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=jn(1,yi((s-n+1)/e));for(let a=i[n],o=n+r;o<=s;o+=r){let l=i[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}var i0=["January","February","March","April","May","June","July","August","September","October","November","December"],s0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function r0(i){return i.slice(0,3)}var Tw=s0.map(r0),Aw=i0.map(r0),Cw={MMMM:i0,MMM:Aw,WWWW:s0,WWW:Tw};function Zo(i){return(i<10?"0":"")+i}function Rw(i){return(i<10?"00":i<100?"0":"")+i}var Pw={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Zo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Zo(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Zo(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Zo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Zo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Rw(i.getMilliseconds())};function ff(i,e){e=e||Cw;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?Pw[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<t.length;o++)a+=typeof t[o]=="string"?t[o]:t[o](r,e);return a}}var Lw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Iw(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==Lw?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var a0=i=>i%1==0,Nh=[1,2,2.5,5],Dw=tl(10,-32,0,Nh),o0=tl(10,0,32,Nh),Nw=o0.filter(a0),Pr=Dw.concat(o0),pf=`
`,l0="{YYYY}",Tg=pf+l0,c0="{M}/{D}",jo=pf+c0,Rh=jo+"/{YY}",h0="{aa}",Uw="{h}:{mm}",Ra=Uw+h0,Ag=pf+Ra,Cg=":{ss}",Ut=null;function u0(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,a=s*365,l=(i==1?tl(10,0,3,Nh).filter(a0):tl(10,-3,0,Nh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]),c=[[a,l0,Ut,Ut,Ut,Ut,Ut,Ut,1],[s*28,"{MMM}",Tg,Ut,Ut,Ut,Ut,Ut,1],[s,c0,Tg,Ut,Ut,Ut,Ut,Ut,1],[n,"{h}"+h0,Rh,Ut,jo,Ut,Ut,Ut,1],[t,Ra,Rh,Ut,jo,Ut,Ut,Ut,1],[e,Cg,Rh+" "+Ra,Ut,jo+" "+Ra,Ut,Ag,Ut,1],[i,Cg+".{fff}",Rh+" "+Ra,Ut,jo+" "+Ra,Ut,Ag,Ut,1]];function h(d){return(u,p,g,_,m,v)=>{let x=[],E=m>=a,S=m>=r&&m<a,R=d(g),w=Ht(R*i,3),y=$d(R.getFullYear(),E?0:R.getMonth(),S||E?1:R.getDate()),A=Ht(y*i,3);if(S||E){let k=S?m/r:0,U=E?m/a:0,D=w==A?w:Ht($d(y.getFullYear()+U,y.getMonth()+k,1)*i,3),L=new Date(En(D/i)),F=L.getFullYear(),P=L.getMonth();for(let G=0;D<=_;G++){let Y=$d(F+U*G,P+k*G,1),X=Y-d(Ht(Y*i,3));D=Ht((+Y+X)*i,3),D<=_&&x.push(D)}}else{let k=m>=s?s:m,U=yi(g)-yi(w),D=A+U+Fh(w-A,k);x.push(D);let L=d(D),F=L.getHours()+L.getMinutes()/t+L.getSeconds()/n,P=m/n,G=u.axes[p]._space,Y=v/G;for(;D=Ht(D+m,i==1?0:3),!(D>_);)if(P>1){let X=yi(Ht(F+P,6))%24,ee=d(D).getHours()-X;ee>1&&(ee=-1),D-=ee*n,F=(F+P)%24;let ne=x[x.length-1];Ht((D-ne)/m,3)*Y>=.7&&x.push(D)}else x.push(D)}return x}}return[l,c,h]}var[Ow,Fw,kw]=u0(1),[Bw,zw,Vw]=u0(.001);tl(2,-53,53,[1]);function Rg(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Pg(i,e){return(t,n,s,r,a)=>{let o=e.find(g=>a>=g[0])||e[e.length-1],l,c,h,d,u,p;return n.map(g=>{let _=i(g),m=_.getFullYear(),v=_.getMonth(),x=_.getDate(),E=_.getHours(),S=_.getMinutes(),R=_.getSeconds(),w=m!=l&&o[2]||v!=c&&o[3]||x!=h&&o[4]||E!=d&&o[5]||S!=u&&o[6]||R!=p&&o[7]||o[1];return l=m,c=v,h=x,d=E,u=S,p=R,w(_)})}}function Gw(i,e){let t=ff(e);return(n,s,r,a,o)=>s.map(l=>t(i(l)))}function $d(i,e,t){return new Date(i,e,t)}function Lg(i,e){return e(i)}var Hw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Ig(i,e){return(t,n,s,r)=>r==null?of:e(i(n))}function Ww(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function Xw(i,e){return i.series[e].fill(i,e)}var $w={show:!0,live:!0,isolate:!1,mount:uw,markers:{show:!0,width:2,stroke:Ww,fill:Xw,dash:"solid"},idx:null,idxs:null,values:[]};function qw(i,e){let t=i.cursor.points,n=Ci(),s=t.size(i,e);Qt(n,Jo,s),Qt(n,Ko,s);let r=s/-2;Qt(n,"marginLeft",r),Qt(n,"marginTop",r);let a=t.width(i,e,s);return a&&Qt(n,"borderWidth",a),n}function Yw(i,e){let t=i.series[e].points;return t._fill||t._stroke}function Zw(i,e){let t=i.series[e].points;return t._stroke||t._fill}function Jw(i,e){return i.series[e].points.size}var qd=[0,0];function Kw(i,e,t){return qd[0]=e,qd[1]=t,qd}function Ph(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Yd(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var jw={show:!0,x:!0,y:!0,lock:!1,move:Kw,points:{one:!1,show:qw,size:Jw,width:0,stroke:Zw,fill:Yw},bind:{mousedown:Ph,mouseup:Ph,click:Ph,dblclick:Ph,mousemove:Yd,mouseleave:Yd,mouseenter:Yd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},d0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},mf=yn({},d0,{filter:jg}),f0=yn({},mf,{size:10}),p0=yn({},d0,{show:!1}),gf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',m0="bold "+gf,g0=1.5,Dg={show:!0,scale:"x",stroke:af,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:m0,side:2,grid:mf,ticks:f0,border:p0,font:gf,lineGap:g0,rotate:0},Qw="Value",e1="Time",Ng={show:!0,scale:"x",auto:!1,sorted:1,min:Gt,max:-Gt,idxs:[]};function t1(i,e,t,n,s){return e.map(r=>r==null?"":uf(r))}function n1(i,e,t,n,s,r,a){let o=[],l=ir.get(s)||0;t=a?t:Ht(Fh(t,s),l);for(let c=t;c<=n;c=Ht(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function ef(i,e,t,n,s,r,a){let o=[],l=i.scales[i.axes[e].scale].log,c=l==10?Cs:Zg,h=yi(c(t));s=La(l,h),l==10&&(s=Pr[Gi(s,Pr)]);let d=t,u=s*l;l==10&&(u=Pr[Gi(u,Pr)]);do o.push(d),d=d+s,l==10&&!ir.has(d)&&(d=Ht(d,ir.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=Pr[Gi(u,Pr)]));while(d<=n);return o}function i1(i,e,t,n,s,r,a){let l=i.scales[i.axes[e].scale].asinh,c=n>l?ef(i,e,jn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?ef(i,e,jn(l,-n),-t,s):[l]).reverse().map(u=>-u).concat(h,c)}var v0=/./,s1=/[12357]/,r1=/[125]/,Ug=/1/,tf=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function a1(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=i.scales[a],l=i.valToPos,c=r._space,h=l(10,a),d=l(9,a)-h>=c?v0:l(7,a)-h>=c?s1:l(5,a)-h>=c?r1:Ug;if(d==Ug){let u=Tn(l(1,a)-h);if(u<c)return tf(e.slice().reverse(),o.distr,d,Ri(c/u)).reverse()}return tf(e,o.distr,d,1)}function o1(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=r._space,l=i.valToPos,c=Tn(l(1,a)-l(2,a));return c<o?tf(e.slice().reverse(),3,v0,Ri(o/c)).reverse():e}function l1(i,e,t,n){return n==null?of:e==null?"":uf(e)}var Og={show:!0,scale:"y",stroke:af,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:m0,side:3,grid:mf,ticks:f0,border:p0,font:gf,lineGap:g0,rotate:0};function c1(i,e){let t=3+(i||1)*2;return Ht(t*e,3)}function h1(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),a=i.valToPos(s[n[1]],t,!0),o=Tn(a-r),l=i.series[e],c=o/(l.points.space*Dt);return n[1]-n[0]<=c}var Fg={scale:null,auto:!0,sorted:0,min:Gt,max:-Gt},_0=(i,e,t,n,s)=>s,kg={show:!0,auto:!0,sorted:0,gaps:_0,alpha:1,facets:[yn({},Fg,{scale:"x"}),yn({},Fg,{scale:"y"})]},Bg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:_0,alpha:1,points:{show:h1,filter:null},values:null,min:Gt,max:-Gt,idxs:[],path:null,clip:null};function u1(i,e,t,n,s){return t/10}var x0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},d1=yn({},x0,{time:!1,ori:1}),zg={};function y0(i,e){let t=zg[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,a,o,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,a,o,l,c)}},i!=null&&(zg[i]=t)),t}var Na=1,nf=2;function Nr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,a=i.scales,o=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?a[s.facets[0].scale]:a[i.series[0].scale],d=n==2?a[s.facets[1].scale]:a[s.scale],u=o.left,p=o.top,g=o.width,_=o.height,m=i.valToPosH,v=i.valToPosV;return h.ori==0?t(s,l,c,h,d,m,v,u,p,g,_,zh,Oa,Gh,S0,w0):t(s,l,c,h,d,v,m,p,u,_,g,Vh,Fa,xf,M0,E0)}function vf(i,e){let t=0,n=0,s=Rt(i.bands,df);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==e?t=a.dir:a.series[1]==e&&(a.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function f1(i,e,t,n,s){let r=i.mode,a=i.series[e],o=r==2?a.facets[1].scale:a.scale,l=i.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Rs(i,e,t,n,s,r){return Nr(i,e,(a,o,l,c,h,d,u,p,g,_,m)=>{let v=a.pxRound,x=c.dir*(c.ori==0?1:-1),E=c.ori==0?Oa:Fa,S,R;x==1?(S=t,R=n):(S=n,R=t);let w=v(d(o[S],c,_,p)),y=v(u(l[S],h,m,g)),A=v(d(o[R],c,_,p)),k=v(u(r==1?h.max:h.min,h,m,g)),U=new Path2D(s);return E(U,A,k),E(U,w,k),E(U,w,y),U})}function Bh(i,e,t,n,s,r){let a=null;if(i.length>0){a=new Path2D;let o=e==0?Gh:xf,l=t;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let p=u[0]-l;p>0&&o(a,l,n,p,n+r),l=u[1]}}let c=t+s-l,h=10;c>0&&o(a,l,n-h/2,c,n+r+h)}return a}function p1(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function _f(i,e,t,n,s,r,a){let o=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let d=c,u=c;if(s==1)for(;++c<=n&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let p=r(i[d]),g=u==d?p:r(i[u]),_=d-s;p=a<=0&&_>=0&&_<l?r(i[_]):p;let v=u+s;g=a>=0&&v>=0&&v<l?r(i[v]):g,g>=p&&o.push([p,g])}return o}function Vg(i){return i==0?Kg:i==1?En:e=>Rr(e,i)}function b0(i){let e=i==0?zh:Vh,t=i==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},n=i==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,h=0)=>{c==0&&h==0?n(s,r,a,o,l):(c=Hi(c,o/2,l/2),h=Hi(h,o/2,l/2),e(s,r+c,a),t(s,r+o,a,r+o,a+l,c),t(s,r+o,a+l,r,a+l,h),t(s,r,a+l,r,a,h),t(s,r,a,r+o,a,c),s.closePath())}}var zh=(i,e,t)=>{i.moveTo(e,t)},Vh=(i,e,t)=>{i.moveTo(t,e)},Oa=(i,e,t)=>{i.lineTo(e,t)},Fa=(i,e,t)=>{i.lineTo(t,e)},Gh=b0(0),xf=b0(1),S0=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},M0=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},w0=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(e,t,n,s,r,a)},E0=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(t,e,s,n,a,r)};function T0(i){return(e,t,n,s,r)=>Nr(e,t,(a,o,l,c,h,d,u,p,g,_,m)=>{let{pxRound:v,points:x}=a,E,S;c.ori==0?(E=zh,S=S0):(E=Vh,S=M0);let R=Ht(x.width*Dt,3),w=(x.size-x.width)/2*Dt,y=Ht(w*2,3),A=new Path2D,k=new Path2D,{left:U,top:D,width:L,height:F}=e.bbox;Gh(k,U-y,D-y,L+y*2,F+y*2);let P=G=>{if(l[G]!=null){let Y=v(d(o[G],c,_,p)),X=v(u(l[G],h,m,g));E(A,Y+w,X),S(A,Y,X,w,0,Lh*2)}};if(r)r.forEach(P);else for(let G=n;G<=s;G++)P(G);return{stroke:R>0?A:null,fill:A,clip:k,flags:Na|nf}})}function A0(i){return(e,t,n,s,r,a)=>{n!=s&&(r!=n&&a!=n&&i(e,t,n),r!=s&&a!=s&&i(e,t,s),i(e,t,a))}}var m1=A0(Oa),g1=A0(Fa);function C0(i){let e=Rt(i?.alignGaps,0);return(t,n,s,r)=>Nr(t,n,(a,o,l,c,h,d,u,p,g,_,m)=>{[s,r]=Uh(l,s,r);let v=a.pxRound,x=F=>v(d(F,c,_,p)),E=F=>v(u(F,h,m,g)),S,R;c.ori==0?(S=Oa,R=m1):(S=Fa,R=g1);let w=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Na},A=y.stroke,k=!1;if(r-s>=_*4){let F=de=>t.posToVal(de,c.key,!0),P=null,G=null,Y,X,he,J=x(o[w==1?s:r]),ee=x(o[s]),ne=x(o[r]),ue=F(w==1?ee+1:ne-1);for(let de=w==1?s:r;de>=s&&de<=r;de+=w){let Q=o[de],_e=(w==1?Q<ue:Q>ue)?J:x(Q),Te=l[de];_e==J?Te!=null?(X=Te,P==null?(S(A,_e,E(X)),Y=P=G=X):X<P?P=X:X>G&&(G=X)):Te===null&&(k=!0):(P!=null&&R(A,J,E(P),E(G),E(Y),E(X)),Te!=null?(X=Te,S(A,_e,E(X)),P=G=Y=X):(P=G=null,Te===null&&(k=!0)),J=_e,ue=F(J+w))}P!=null&&P!=G&&he!=J&&R(A,J,E(P),E(G),E(Y),E(X))}else for(let F=w==1?s:r;F>=s&&F<=r;F+=w){let P=l[F];P===null?k=!0:P!=null&&S(A,x(o[F]),E(P))}let[D,L]=vf(t,n);if(a.fill!=null||D!=0){let F=y.fill=new Path2D(A),P=a.fillTo(t,n,a.min,a.max,D),G=E(P),Y=x(o[s]),X=x(o[r]);w==-1&&([X,Y]=[Y,X]),S(F,X,G),S(F,Y,G)}if(!a.spanGaps){let F=[];k&&F.push(..._f(o,l,s,r,w,x,e)),y.gaps=F=a.gaps(t,n,s,r,F),y.clip=Bh(F,c.ori,p,g,_,m)}return L!=0&&(y.band=L==2?[Rs(t,n,s,r,A,-1),Rs(t,n,s,r,A,1)]:Rs(t,n,s,r,A,L)),y})}function v1(i){let e=Rt(i.align,1),t=Rt(i.ascDesc,!1),n=Rt(i.alignGaps,0),s=Rt(i.extend,!1);return(r,a,o,l)=>Nr(r,a,(c,h,d,u,p,g,_,m,v,x,E)=>{[o,l]=Uh(d,o,l);let S=c.pxRound,{left:R,width:w}=r.bbox,y=ee=>S(g(ee,u,x,m)),A=ee=>S(_(ee,p,E,v)),k=u.ori==0?Oa:Fa,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Na},D=U.stroke,L=u.dir*(u.ori==0?1:-1),F=A(d[L==1?o:l]),P=y(h[L==1?o:l]),G=P,Y=P;s&&e==-1&&(Y=R,k(D,Y,F)),k(D,P,F);for(let ee=L==1?o:l;ee>=o&&ee<=l;ee+=L){let ne=d[ee];if(ne==null)continue;let ue=y(h[ee]),de=A(ne);e==1?k(D,ue,F):k(D,G,de),k(D,ue,de),F=de,G=ue}let X=G;s&&e==1&&(X=R+w,k(D,X,F));let[he,J]=vf(r,a);if(c.fill!=null||he!=0){let ee=U.fill=new Path2D(D),ne=c.fillTo(r,a,c.min,c.max,he),ue=A(ne);k(ee,X,ue),k(ee,Y,ue)}if(!c.spanGaps){let ee=[];ee.push(..._f(h,d,o,l,L,y,n));let ne=c.width*Dt/2,ue=t||e==1?ne:-ne,de=t||e==-1?-ne:ne;ee.forEach(Q=>{Q[0]+=ue,Q[1]+=de}),U.gaps=ee=c.gaps(r,a,o,l,ee),U.clip=Bh(ee,u.ori,m,v,x,E)}return J!=0&&(U.band=J==2?[Rs(r,a,o,l,D,-1),Rs(r,a,o,l,D,1)]:Rs(r,a,o,l,D,J)),U})}function Gg(i,e,t,n,s,r,a=Gt){if(i.length>1){let o=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(o!=null){let h=Tn(i[l]-i[o]);h<c&&(c=h,a=Tn(t(i[l],n,s,r)-t(i[o],n,s,r)))}o=l}}return a}function _1(i){i=i||el;let e=Rt(i.size,[.6,Gt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Et(s),a=1-e[0],o=Rt(e[1],Gt),l=Rt(e[2],1),c=Rt(i.disp,el),h=Rt(i.each,p=>{}),{fill:d,stroke:u}=c;return(p,g,_,m)=>Nr(p,g,(v,x,E,S,R,w,y,A,k,U,D)=>{let L=v.pxRound,F=t,P=n*Dt,G=o*Dt,Y=l*Dt,X,he;S.ori==0?[X,he]=r(p,g):[he,X]=r(p,g);let J=S.dir*(S.ori==0?1:-1),ee=S.ori==0?Gh:xf,ne=S.ori==0?h:(Ie,Qe,ut,Ae,Vt,$e,Je)=>{h(Ie,Qe,ut,Vt,Ae,Je,$e)},ue=Rt(p.bands,df).find(Ie=>Ie.series[0]==g),de=ue!=null?ue.dir:0,Q=v.fillTo(p,g,v.min,v.max,de),me=L(y(Q,R,D,k)),_e,Te,xe,qe=U,st=L(v.width*Dt),ae=!1,Xe=null,tt=null,rt=null,pt=null;d!=null&&(st==0||u!=null)&&(ae=!0,Xe=d.values(p,g,_,m),tt=new Map,new Set(Xe).forEach(Ie=>{Ie!=null&&tt.set(Ie,new Path2D)}),st>0&&(rt=u.values(p,g,_,m),pt=new Map,new Set(rt).forEach(Ie=>{Ie!=null&&pt.set(Ie,new Path2D)})));let{x0:Pt,size:qt}=c;if(Pt!=null&&qt!=null){F=1,x=Pt.values(p,g,_,m),Pt.unit==2&&(x=x.map(ut=>p.posToVal(A+ut*U,S.key,!0)));let Ie=qt.values(p,g,_,m);qt.unit==2?Te=Ie[0]*U:Te=w(Ie[0],S,U,A)-w(0,S,U,A),qe=Gg(x,E,w,S,U,A,qe),xe=qe-Te+P}else qe=Gg(x,E,w,S,U,A,qe),xe=qe*a+P,Te=qe-xe;xe<1&&(xe=0),st>=Te/2&&(st=0),xe<5&&(L=Kg);let Tt=xe>0,sn=qe-xe-(Tt?st:0);Te=L(Qd(sn,Y,G)),_e=(F==0?Te/2:F==J?0:Te)-F*J*((F==0?P/2:0)+(Tt?st/2:0));let lt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Bt=ae?null:new Path2D,Wt=null;if(ue!=null)Wt=p.data[ue.series[1]];else{let{y0:Ie,y1:Qe}=c;Ie!=null&&Qe!=null&&(E=Qe.values(p,g,_,m),Wt=Ie.values(p,g,_,m))}let fn=X*Te,z=he*Te;for(let Ie=J==1?_:m;Ie>=_&&Ie<=m;Ie+=J){let Qe=E[Ie];if(Qe==null)continue;if(Wt!=null){let q=Wt[Ie]??0;if(Qe-q==0)continue;me=y(q,R,D,k)}let ut=S.distr!=2||c!=null?x[Ie]:Ie,Ae=w(ut,S,U,A),Vt=y(Rt(Qe,Q),R,D,k),$e=L(Ae-_e),Je=L(jn(Vt,me)),I=L(Hi(Vt,me)),M=Je-I;if(Qe!=null){let q=Qe<0?z:fn,pe=Qe<0?fn:z;ae?(st>0&&rt[Ie]!=null&&ee(pt.get(rt[Ie]),$e,I+yi(st/2),Te,jn(0,M-st),q,pe),Xe[Ie]!=null&&ee(tt.get(Xe[Ie]),$e,I+yi(st/2),Te,jn(0,M-st),q,pe)):ee(Bt,$e,I+yi(st/2),Te,jn(0,M-st),q,pe),ne(p,g,Ie,$e-st/2,I,Te+st,M)}}return st>0?lt.stroke=ae?pt:Bt:ae||(lt._fill=v.width==0?v._fill:v._stroke??v._fill,lt.width=0),lt.fill=ae?tt:Bt,lt})}function x1(i,e){let t=Rt(e?.alignGaps,0);return(n,s,r,a)=>Nr(n,s,(o,l,c,h,d,u,p,g,_,m,v)=>{[r,a]=Uh(c,r,a);let x=o.pxRound,E=X=>x(u(X,h,m,g)),S=X=>x(p(X,d,v,_)),R,w,y;h.ori==0?(R=zh,y=Oa,w=w0):(R=Vh,y=Fa,w=E0);let A=h.dir*(h.ori==0?1:-1),k=E(l[A==1?r:a]),U=k,D=[],L=[];for(let X=A==1?r:a;X>=r&&X<=a;X+=A)if(c[X]!=null){let J=l[X],ee=E(J);D.push(U=ee),L.push(S(c[X]))}let F={stroke:i(D,L,R,y,w,x),fill:null,clip:null,band:null,gaps:null,flags:Na},P=F.stroke,[G,Y]=vf(n,s);if(o.fill!=null||G!=0){let X=F.fill=new Path2D(P),he=o.fillTo(n,s,o.min,o.max,G),J=S(he);y(X,U,J),y(X,k,J)}if(!o.spanGaps){let X=[];X.push(..._f(l,c,r,a,A,E,t)),F.gaps=X=o.gaps(n,s,r,a,X),F.clip=Bh(X,h.ori,g,_,m,v)}return Y!=0&&(F.band=Y==2?[Rs(n,s,r,a,P,-1),Rs(n,s,r,a,P,1)]:Rs(n,s,r,a,P,Y)),F})}function y1(i){return x1(b1,i)}function b1(i,e,t,n,s,r){let a=i.length;if(a<2)return null;let o=new Path2D;if(t(o,i[0],e[0]),a==2)n(o,i[1],e[1]);else{let l=Array(a),c=Array(a-1),h=Array(a-1),d=Array(a-1);for(let u=0;u<a-1;u++)h[u]=e[u+1]-e[u],d[u]=i[u+1]-i[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<a-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[a-1]=c[a-2];for(let u=0;u<a-1;u++)s(o,i[u]+d[u]/3,e[u]+l[u]*d[u]/3,i[u+1]-d[u]/3,e[u+1]-l[u+1]*d[u]/3,i[u+1],e[u+1])}return o}var sf=new Set;function Hg(){for(let i of sf)i.syncRect(!0)}Ua&&(Ir(tw,Pa,Hg),Ir(nw,Pa,Hg,!0),Ir(Ih,Pa,()=>{Dn.pxRatio=Dt}));var S1=C0(),M1=T0();function Wg(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,a)=>rf(r,a,e,t))}function w1(i,e){return i.map((t,n)=>n==0?{}:yn({},e,t))}function rf(i,e,t,n){return yn({},e==0?t:n,i)}function R0(i,e,t){return e==null?Ia:[e,t]}var E1=R0;function T1(i,e,t){return e==null?Ia:Dh(e,t,hf,!0)}function P0(i,e,t,n){return e==null?Ia:Oh(e,t,i.scales[n].log,!1)}var A1=P0;function L0(i,e,t,n){return e==null?Ia:cf(e,t,i.scales[n].log,!1)}var C1=L0;function R1(i,e,t,n,s){let r=jn(Sg(i),Sg(e)),a=e-i,o=Gi(s/n*a,t);do{let l=t[o],c=n*l/a;if(c>=s&&r+(l<5?ir.get(l):0)<=17)return[l,c]}while(++o<t.length);return[0,0]}function Xg(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=En((t=+s)*Dt))+"px"),[i,e,t]}function P1(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ht(e[2]*Dt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Dn(i,e,t){let n={mode:Rt(i.mode,1)},s=n.mode;function r(b,T,N,O){let $=T.valToPct(b);return O+N*(T.dir==-1?1-$:$)}function a(b,T,N,O){let $=T.valToPct(b);return O+N*(T.dir==-1?$:1-$)}function o(b,T,N,O){return T.ori==0?r(b,T,N,O):a(b,T,N,O)}n.valToPosH=r,n.valToPosV=a;let l=!1;n.status=0;let c=n.root=Ci(FM);if(i.id!=null&&(c.id=i.id),xi(c,i.class),i.title){let b=Ci(zM,c);b.textContent=i.title}let h=Vi("canvas"),d=n.ctx=h.getContext("2d"),u=Ci(VM,c);Ir("click",u,b=>{b.target===g&&(Zt!=Wr||en!=Xr)&&Nn.click(n,b)},!0);let p=n.under=Ci(GM,u);u.appendChild(h);let g=n.over=Ci(HM,u);i=Da(i);let _=+Rt(i.pxAlign,1),m=Vg(_);(i.plugins||[]).forEach(b=>{b.opts&&(i=b.opts(n,i)||i)});let v=i.ms||.001,x=n.series=s==1?Wg(i.series||[],Ng,Bg,!1):w1(i.series||[null],kg),E=n.axes=Wg(i.axes||[],Dg,Og,!0),S=n.scales={},R=n.bands=i.bands||[];R.forEach(b=>{b.fill=Et(b.fill||null),b.dir=Rt(b.dir,-1)});let w=s==2?x[1].facets[0].scale:x[0].scale,y={axes:cs,series:xt},A=(i.drawOrder||["axes","series"]).map(b=>y[b]);function k(b){let T=b.distr==3?N=>Cs(N>0?N:b.clamp(n,N,b.min,b.max,b.key)):b.distr==4?N=>Xd(N,b.asinh):b.distr==100?N=>b.fwd(N):N=>N;return N=>{let O=T(N),{_min:$,_max:j}=b,ce=j-$;return(O-$)/ce}}function U(b){let T=S[b];if(T==null){let N=(i.scales||el)[b]||el;if(N.from!=null){U(N.from);let O=yn({},S[N.from],N,{key:b});O.valToPct=k(O),S[b]=O}else{T=S[b]=yn({},b==w?x0:d1,N),T.key=b;let O=T.time,$=T.range,j=nr($);if((b!=w||s==2&&!O)&&(j&&($[0]==null||$[1]==null)&&($={min:$[0]==null?xg:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?xg:{mode:1,hard:$[1],soft:$[1]}},j=!1),!j&&kh($))){let ce=$;$=(ge,Me,Oe)=>Me==null?Ia:Dh(Me,Oe,ce)}T.range=Et($||(O?E1:b==w?T.distr==3?A1:T.distr==4?C1:R0:T.distr==3?P0:T.distr==4?L0:T1)),T.auto=Et(j?!1:T.auto),T.clamp=Et(T.clamp||u1),T._min=T._max=null,T.valToPct=k(T)}}}U("x"),U("y"),s==1&&x.forEach(b=>{U(b.scale)}),E.forEach(b=>{U(b.scale)});for(let b in i.scales)U(b);let D=S[w],L=D.distr,F,P;D.ori==0?(xi(c,kM),F=r,P=a):(xi(c,BM),F=a,P=r);let G={};for(let b in S){let T=S[b];(T.min!=null||T.max!=null)&&(G[b]={min:T.min,max:T.max},T.min=T.max=null)}let Y=i.tzDate||(b=>new Date(En(b/v))),X=i.fmtDate||ff,he=v==1?kw(Y):Vw(Y),J=Pg(Y,Rg(v==1?Fw:zw,X)),ee=Ig(Y,Lg(Hw,X)),ne=[],ue=n.legend=yn({},$w,i.legend),de=n.cursor=yn({},jw,{drag:{y:s==2}},i.cursor),Q=ue.show,me=de.show,_e=ue.markers;ue.idxs=ne,_e.width=Et(_e.width),_e.dash=Et(_e.dash),_e.stroke=Et(_e.stroke),_e.fill=Et(_e.fill);let Te,xe,qe,st=[],ae=[],Xe,tt=!1,rt={};if(ue.live){let b=x[1]?x[1].values:null;tt=b!=null,Xe=tt?b(n,1,0):{_:0};for(let T in Xe)rt[T]=of}if(Q)if(Te=Vi("table",ZM,c),qe=Vi("tbody",null,Te),ue.mount(n,Te),tt){xe=Vi("thead",null,Te,qe);let b=Vi("tr",null,xe);Vi("th",null,b);for(var pt in Xe)Vi("th",ag,b).textContent=pt}else xi(Te,KM),ue.live&&xi(Te,JM);let Pt={show:!0},qt={show:!1};function Tt(b,T){if(T==0&&(tt||!ue.live||s==2))return Ia;let N=[],O=Vi("tr",jM,qe,qe.childNodes[T]);xi(O,b.class),b.show||xi(O,Lr);let $=Vi("th",null,O);if(_e.show){let ge=Ci(QM,$);if(T>0){let Me=_e.width(n,T);Me&&(ge.style.border=Me+"px "+_e.dash(n,T)+" "+_e.stroke(n,T)),ge.style.background=_e.fill(n,T)}}let j=Ci(ag,$);b.label instanceof HTMLElement?j.appendChild(b.label):j.textContent=b.label,T>0&&(_e.show||(j.style.color=b.width>0?_e.stroke(n,T):_e.fill(n,T)),lt("click",$,ge=>{if(de._lock)return;nt(ge);let Me=x.indexOf(b);if((ge.ctrlKey||ge.metaKey)!=ue.isolate){let Oe=x.some((ke,ze)=>ze>0&&ze!=Me&&ke.show);x.forEach((ke,ze)=>{ze>0&&qi(ze,Oe?ze==Me?Pt:qt:Pt,!0,vn.setSeries)})}else qi(Me,{show:!b.show},!0,vn.setSeries)},!1),it&&lt(hg,$,ge=>{de._lock||(nt(ge),qi(x.indexOf(b),qr,!0,vn.setSeries))},!1));for(var ce in Xe){let ge=Vi("td",ew,O);ge.textContent="--",N.push(ge)}return[O,N]}let sn=new Map;function lt(b,T,N,O=!0){let $=sn.get(T)||{},j=de.bind[b](n,T,N,O);j&&(Ir(b,T,$[b]=j),sn.set(T,$))}function Bt(b,T,N){let O=sn.get(T)||{};for(let $ in O)(b==null||$==b)&&(jd($,T,O[$]),delete O[$]);b==null&&sn.delete(T)}let Wt=0,fn=0,z=0,Ie=0,Qe=0,ut=0,Ae=Qe,Vt=ut,$e=z,Je=Ie,I=0,M=0,q=0,pe=0;n.bbox={};let le=!1,be=!1,Se=!1,ie=!1,re=!1,ve=!1;function B(b,T,N){(N||b!=n.width||T!=n.height)&&oe(b,T),mt(!1),Se=!0,be=!0,Un()}function oe(b,T){n.width=Wt=z=b,n.height=fn=Ie=T,Qe=ut=0,we(),Ye();let N=n.bbox;I=N.left=Rr(Qe*Dt,.5),M=N.top=Rr(ut*Dt,.5),q=N.width=Rr(z*Dt,.5),pe=N.height=Rr(Ie*Dt,.5)}let se=3;function Ce(){let b=!1,T=0;for(;!b;){T++;let N=Vr(T),O=$i(T);b=T==se||N&&O,b||(oe(n.width,n.height),be=!0)}}function ye({width:b,height:T}){B(b,T)}n.setSize=ye;function we(){let b=!1,T=!1,N=!1,O=!1;E.forEach(($,j)=>{if($.show&&$._show){let{side:ce,_size:ge}=$,Me=ce%2,Oe=$.label!=null?$.labelSize:0,ke=ge+Oe;ke>0&&(Me?(z-=ke,ce==3?(Qe+=ke,O=!0):N=!0):(Ie-=ke,ce==0?(ut+=ke,b=!0):T=!0))}}),Wi[0]=b,Wi[1]=N,Wi[2]=T,Wi[3]=O,z-=Pi[1]+Pi[3],Qe+=Pi[3],Ie-=Pi[2]+Pi[0],ut+=Pi[0]}function Ye(){let b=Qe+z,T=ut+Ie,N=Qe,O=ut;function $(j,ce){switch(j){case 1:return b+=ce,b-ce;case 2:return T+=ce,T-ce;case 3:return N-=ce,N+ce;case 0:return O-=ce,O+ce}}E.forEach((j,ce)=>{if(j.show&&j._show){let ge=j.side;j._pos=$(ge,j._size),j.label!=null&&(j._lpos=$(ge,j.labelSize))}})}if(de.dataIdx==null){let b=de.hover,T=b.skip=new Set(b.skip??[]);T.add(void 0);let N=b.prox=Et(b.prox),O=b.bias??=0;de.dataIdx=($,j,ce,ge)=>{if(j==0)return ce;let Me=ce,Oe=N($,j,ce,ge)??Gt,ke=Oe>=0&&Oe<Gt,ze=D.ori==0?z:Ie,ht=de.left,Lt=e[0],Ct=e[j];if(T.has(Ct[ce])){Me=null;let bt=null,et=null,Ze;if(O==0||O==-1)for(Ze=ce;bt==null&&Ze-- >0;)T.has(Ct[Ze])||(bt=Ze);if(O==0||O==1)for(Ze=ce;et==null&&Ze++<Ct.length;)T.has(Ct[Ze])||(et=Ze);if(bt!=null||et!=null)if(ke){let Kt=bt==null?-1/0:F(Lt[bt],D,ze,0),on=et==null?1/0:F(Lt[et],D,ze,0),Pn=ht-Kt,zt=on-ht;Pn<=zt?Pn<=Oe&&(Me=bt):zt<=Oe&&(Me=et)}else Me=et==null?bt:bt==null?et:ce-bt<=et-ce?bt:et}else ke&&Tn(ht-F(Lt[ce],D,ze,0))>Oe&&(Me=null);return Me}}let nt=b=>{de.event=b};de.idxs=ne,de._lock=!1;let fe=de.points;fe.show=Et(fe.show),fe.size=Et(fe.size),fe.stroke=Et(fe.stroke),fe.width=Et(fe.width),fe.fill=Et(fe.fill);let Ge=n.focus=yn({},i.focus||{alpha:.3},de.focus),it=Ge.prox>=0,Le=it&&fe.one,dt=[],Yt=[],Vn=[];function Xa(b,T){let N=fe.show(n,T);if(N instanceof HTMLElement)return xi(N,YM),xi(N,b.class),rs(N,-10,-10,z,Ie),g.insertBefore(N,dt[T]),N}function kr(b,T){if(s==1||T>0){let N=s==1&&S[b.scale].time,O=b.value;b.value=N?Eg(O)?Ig(Y,Lg(O,X)):O||ee:O||l1,b.label=b.label||(N?e1:Qw)}if(Le||T>0){b.width=b.width==null?1:b.width,b.paths=b.paths||S1||dw,b.fillTo=Et(b.fillTo||f1),b.pxAlign=+Rt(b.pxAlign,_),b.pxRound=Vg(b.pxAlign),b.stroke=Et(b.stroke||null),b.fill=Et(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let N=c1(jn(1,b.width),1),O=b.points=yn({},{size:N,width:jn(1,N*.2),stroke:b.stroke,space:N*2,paths:M1,_stroke:null,_fill:null},b.points);O.show=Et(O.show),O.filter=Et(O.filter),O.fill=Et(O.fill),O.stroke=Et(O.stroke),O.paths=Et(O.paths),O.pxAlign=b.pxAlign}if(Q){let N=Tt(b,T);st.splice(T,0,N[0]),ae.splice(T,0,N[1]),ue.values.push(null)}if(me){ne.splice(T,0,null);let N=null;Le?T==0&&(N=Xa(b,T)):T>0&&(N=Xa(b,T)),dt.splice(T,0,N),Yt.splice(T,0,0),Vn.splice(T,0,0)}Rn("addSeries",T)}function su(b,T){T=T??x.length,b=s==1?rf(b,T,Ng,Bg):rf(b,T,{},kg),x.splice(T,0,b),kr(x[T],T)}n.addSeries=su;function _l(b){if(x.splice(b,1),Q){ue.values.splice(b,1),ae.splice(b,1);let T=st.splice(b,1)[0];Bt(null,T.firstChild),T.remove()}me&&(ne.splice(b,1),dt.splice(b,1)[0].remove(),Yt.splice(b,1),Vn.splice(b,1)),Rn("delSeries",b)}n.delSeries=_l;let Wi=[!1,!1,!1,!1];function as(b,T){if(b._show=b.show,b.show){let N=b.side%2,O=S[b.scale];O==null&&(b.scale=N?x[1].scale:w,O=S[b.scale]);let $=O.time;b.size=Et(b.size),b.space=Et(b.space),b.rotate=Et(b.rotate),nr(b.incrs)&&b.incrs.forEach(ce=>{!ir.has(ce)&&ir.set(ce,e0(ce))}),b.incrs=Et(b.incrs||(O.distr==2?Nw:$?v==1?Ow:Bw:Pr)),b.splits=Et(b.splits||($&&O.distr==1?he:O.distr==3?ef:O.distr==4?i1:n1)),b.stroke=Et(b.stroke),b.grid.stroke=Et(b.grid.stroke),b.ticks.stroke=Et(b.ticks.stroke),b.border.stroke=Et(b.border.stroke);let j=b.values;b.values=nr(j)&&!nr(j[0])?Et(j):$?nr(j)?Pg(Y,Rg(j,X)):Eg(j)?Gw(Y,j):j||J:j||t1,b.filter=Et(b.filter||(O.distr>=3&&O.log==10?a1:O.distr==3&&O.log==2?o1:jg)),b.font=Xg(b.font),b.labelFont=Xg(b.labelFont),b._size=b.size(n,null,T,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(Wi[T]=!0,b._el=Ci(WM,u))}}function os(b,T,N,O){let[$,j,ce,ge]=N,Me=T%2,Oe=0;return Me==0&&(ge||j)&&(Oe=T==0&&!$||T==2&&!ce?En(Dg.size/3):0),Me==1&&($||ce)&&(Oe=T==1&&!j||T==3&&!ge?En(Og.size/2):0),Oe}let $a=n.padding=(i.padding||[os,os,os,os]).map(b=>Et(Rt(b,os))),Pi=n._padding=$a.map((b,T)=>b(n,T,Wi,0)),rn,cn=null,hn=null,Xi=s==1?x[0].idxs:null,oi=null,Is=!1;function qa(b,T){if(e=b??[],n.data=n._data=e,s==2){rn=0;for(let N=1;N<x.length;N++)rn+=e[N][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),oi=e[0],rn=oi.length;let N=e;if(L==2){N=e.slice();let O=N[0]=Array(rn);for(let $=0;$<rn;$++)O[$]=$}n._data=e=N}if(mt(!0),Rn("setData"),L==2&&(Se=!0),T!==!1){let N=D;N.auto(n,Is)?Ya():Us(w,N.min,N.max),ie=ie||de.left>=0,ve=!0,Un()}}n.setData=qa;function Ya(){Is=!0;let b,T;s==1&&(rn>0?(cn=Xi[0]=0,hn=Xi[1]=rn-1,b=e[0][cn],T=e[0][hn],L==2?(b=cn,T=hn):b==T&&(L==3?[b,T]=Oh(b,b,D.log,!1):L==4?[b,T]=cf(b,b,D.log,!1):D.time?T=b+En(86400/v):[b,T]=Dh(b,T,hf,!0))):(cn=Xi[0]=b=null,hn=Xi[1]=T=null)),Us(w,b,T)}let Br,Ds,zr,C,W,te,Z,K,Re,De;function Pe(b,T,N,O,$,j){b??=lg,N??=df,O??="butt",$??=lg,j??="round",b!=Br&&(d.strokeStyle=Br=b),$!=Ds&&(d.fillStyle=Ds=$),T!=zr&&(d.lineWidth=zr=T),j!=W&&(d.lineJoin=W=j),O!=te&&(d.lineCap=te=O),N!=C&&d.setLineDash(C=N)}function Ne(b,T,N,O){T!=Ds&&(d.fillStyle=Ds=T),b!=Z&&(d.font=Z=b),N!=K&&(d.textAlign=K=N),O!=Re&&(d.textBaseline=Re=O)}function We(b,T,N,O,$=0){if(O.length>0&&b.auto(n,Is)&&(T==null||T.min==null)){let j=Rt(cn,0),ce=Rt(hn,O.length-1),ge=N.min==null?aw(O,j,ce,$,b.distr==3):[N.min,N.max];b.min=Hi(b.min,N.min=ge[0]),b.max=jn(b.max,N.max=ge[1])}}let at={min:null,max:null};function _t(){for(let O in S){let $=S[O];G[O]==null&&($.min==null||G[w]!=null&&$.auto(n,Is))&&(G[O]=at)}for(let O in S){let $=S[O];G[O]==null&&$.from!=null&&G[$.from]!=null&&(G[O]=at)}G[w]!=null&&mt(!0);let b={};for(let O in G){let $=G[O];if($!=null){let j=b[O]=Da(S[O],mw);if($.min!=null)yn(j,$);else if(O!=w||s==2)if(rn==0&&j.from==null){let ce=j.range(n,null,null,O);j.min=ce[0],j.max=ce[1]}else j.min=Gt,j.max=-Gt}}if(rn>0){x.forEach((O,$)=>{if(s==1){let j=O.scale,ce=G[j];if(ce==null)return;let ge=b[j];if($==0){let Me=ge.range(n,ge.min,ge.max,j);ge.min=Me[0],ge.max=Me[1],cn=Gi(ge.min,e[0]),hn=Gi(ge.max,e[0]),hn-cn>1&&(e[0][cn]<ge.min&&cn++,e[0][hn]>ge.max&&hn--),O.min=oi[cn],O.max=oi[hn]}else O.show&&O.auto&&We(ge,ce,O,e[$],O.sorted);O.idxs[0]=cn,O.idxs[1]=hn}else if($>0&&O.show&&O.auto){let[j,ce]=O.facets,ge=j.scale,Me=ce.scale,[Oe,ke]=e[$],ze=b[ge],ht=b[Me];ze!=null&&We(ze,G[ge],j,Oe,j.sorted),ht!=null&&We(ht,G[Me],ce,ke,ce.sorted),O.min=ce.min,O.max=ce.max}});for(let O in b){let $=b[O],j=G[O];if($.from==null&&(j==null||j.min==null)){let ce=$.range(n,$.min==Gt?null:$.min,$.max==-Gt?null:$.max,O);$.min=ce[0],$.max=ce[1]}}}for(let O in b){let $=b[O];if($.from!=null){let j=b[$.from];if(j.min==null)$.min=$.max=null;else{let ce=$.range(n,j.min,j.max,O);$.min=ce[0],$.max=ce[1]}}}let T={},N=!1;for(let O in b){let $=b[O],j=S[O];if(j.min!=$.min||j.max!=$.max){j.min=$.min,j.max=$.max;let ce=j.distr;j._min=ce==3?Cs(j.min):ce==4?Xd(j.min,j.asinh):ce==100?j.fwd(j.min):j.min,j._max=ce==3?Cs(j.max):ce==4?Xd(j.max,j.asinh):ce==100?j.fwd(j.max):j.max,T[O]=N=!0}}if(N){x.forEach((O,$)=>{s==2?$>0&&T.y&&(O._paths=null):T[O.scale]&&(O._paths=null)});for(let O in T)Se=!0,Rn("setScale",O);me&&de.left>=0&&(ie=ve=!0)}for(let O in G)G[O]=null}function He(b){let T=Qd(cn-1,0,rn-1),N=Qd(hn+1,0,rn-1);for(;b[T]==null&&T>0;)T--;for(;b[N]==null&&N<rn-1;)N++;return[T,N]}function xt(){if(rn>0){let b=x.some(T=>T._focus)&&De!=Ge.alpha;b&&(d.globalAlpha=De=Ge.alpha),x.forEach((T,N)=>{if(N>0&&T.show&&(nn(N,!1),nn(N,!0),T._paths==null)){let O=De;De!=T.alpha&&(d.globalAlpha=De=T.alpha);let $=s==2?[0,e[N][0].length-1]:He(e[N]);T._paths=T.paths(n,N,$[0],$[1]),De!=O&&(d.globalAlpha=De=O)}}),x.forEach((T,N)=>{if(N>0&&T.show){let O=De;De!=T.alpha&&(d.globalAlpha=De=T.alpha),T._paths!=null&&Ot(N,!1);{let $=T._paths!=null?T._paths.gaps:null,j=T.points.show(n,N,cn,hn,$),ce=T.points.filter(n,N,j,$);(j||ce)&&(T.points._paths=T.points.paths(n,N,cn,hn,ce),Ot(N,!0))}De!=O&&(d.globalAlpha=De=O),Rn("drawSeries",N)}}),b&&(d.globalAlpha=De=1)}}function nn(b,T){let N=T?x[b].points:x[b];N._stroke=N.stroke(n,b),N._fill=N.fill(n,b)}function Ot(b,T){let N=T?x[b].points:x[b],{stroke:O,fill:$,clip:j,flags:ce,_stroke:ge=N._stroke,_fill:Me=N._fill,_width:Oe=N.width}=N._paths;Oe=Ht(Oe*Dt,3);let ke=null,ze=Oe%2/2;T&&Me==null&&(Me=Oe>0?"#fff":ge);let ht=N.pxAlign==1&&ze>0;if(ht&&d.translate(ze,ze),!T){let Lt=I-Oe/2,Ct=M-Oe/2,bt=q+Oe,et=pe+Oe;ke=new Path2D,ke.rect(Lt,Ct,bt,et)}T?Be(ge,Oe,N.dash,N.cap,Me,O,$,ce,j):Ft(b,ge,Oe,N.dash,N.cap,Me,O,$,ce,ke,j),ht&&d.translate(-ze,-ze)}function Ft(b,T,N,O,$,j,ce,ge,Me,Oe,ke){let ze=!1;Me!=0&&R.forEach((ht,Lt)=>{if(ht.series[0]==b){let Ct=x[ht.series[1]],bt=e[ht.series[1]],et=(Ct._paths||el).band;nr(et)&&(et=ht.dir==1?et[0]:et[1]);let Ze,Kt=null;Ct.show&&et&&lw(bt,cn,hn)?(Kt=ht.fill(n,Lt)||j,Ze=Ct._paths.clip):et=null,Be(T,N,O,$,Kt,ce,ge,Me,Oe,ke,Ze,et),ze=!0}}),ze||Be(T,N,O,$,j,ce,ge,Me,Oe,ke)}let bn=Na|nf;function Be(b,T,N,O,$,j,ce,ge,Me,Oe,ke,ze){Pe(b,T,N,O,$),(Me||Oe||ze)&&(d.save(),Me&&d.clip(Me),Oe&&d.clip(Oe)),ze?(ge&bn)==bn?(d.clip(ze),ke&&d.clip(ke),St($,ce),pn(b,j,T)):ge&nf?(St($,ce),d.clip(ze),pn(b,j,T)):ge&Na&&(d.save(),d.clip(ze),ke&&d.clip(ke),St($,ce),d.restore(),pn(b,j,T)):(St($,ce),pn(b,j,T)),(Me||Oe||ze)&&d.restore()}function pn(b,T,N){N>0&&(T instanceof Map?T.forEach((O,$)=>{d.strokeStyle=Br=$,d.stroke(O)}):T!=null&&b&&d.stroke(T))}function St(b,T){T instanceof Map?T.forEach((N,O)=>{d.fillStyle=Ds=O,d.fill(N)}):T!=null&&b&&d.fill(T)}function ls(b,T,N,O){let $=E[b],j;if(O<=0)j=[0,0];else{let ce=$._space=$.space(n,b,T,N,O),ge=$._incrs=$.incrs(n,b,T,N,O,ce);j=R1(T,N,ge,O,ce)}return $._found=j}function mn(b,T,N,O,$,j,ce,ge,Me,Oe){let ke=ce%2/2;_==1&&d.translate(ke,ke),Pe(ge,ce,Me,Oe,ge),d.beginPath();let ze,ht,Lt,Ct,bt=$+(O==0||O==3?-j:j);N==0?(ht=$,Ct=bt):(ze=$,Lt=bt);for(let et=0;et<b.length;et++)T[et]!=null&&(N==0?ze=Lt=b[et]:ht=Ct=b[et],d.moveTo(ze,ht),d.lineTo(Lt,Ct));d.stroke(),_==1&&d.translate(-ke,-ke)}function Vr(b){let T=!0;return E.forEach((N,O)=>{if(!N.show)return;let $=S[N.scale];if($.min==null){N._show&&(T=!1,N._show=!1,mt(!1));return}else N._show||(T=!1,N._show=!0,mt(!1));let j=N.side,ce=j%2,{min:ge,max:Me}=$,[Oe,ke]=ls(O,ge,Me,ce==0?z:Ie);if(ke==0)return;let ze=$.distr==2,ht=N._splits=N.splits(n,O,ge,Me,Oe,ke,ze),Lt=$.distr==2?ht.map(Ze=>oi[Ze]):ht,Ct=$.distr==2?oi[ht[1]]-oi[ht[0]]:Oe,bt=N._values=N.values(n,N.filter(n,Lt,O,ke,Ct),O,ke,Ct);N._rotate=j==2?N.rotate(n,bt,O,ke):0;let et=N._size;N._size=Ri(N.size(n,bt,O,b)),et!=null&&N._size!=et&&(T=!1)}),T}function $i(b){let T=!0;return $a.forEach((N,O)=>{let $=N(n,O,Wi,b);$!=Pi[O]&&(T=!1),Pi[O]=$}),T}function cs(){for(let b=0;b<E.length;b++){let T=E[b];if(!T.show||!T._show)continue;let N=T.side,O=N%2,$,j,ce=T.stroke(n,b),ge=N==0||N==3?-1:1,[Me,Oe]=T._found;if(T.label!=null){let Wn=T.labelGap*ge,hi=En((T._lpos+Wn)*Dt);Ne(T.labelFont[0],ce,"center",N==2?"top":og),d.save(),O==1?($=j=0,d.translate(hi,En(M+pe/2)),d.rotate((N==3?-Lh:Lh)/2)):($=En(I+q/2),j=hi);let dr=Jg(T.label)?T.label(n,b,Me,Oe):T.label;d.fillText(dr,$,j),d.restore()}if(Oe==0)continue;let ke=S[T.scale],ze=O==0?q:pe,ht=O==0?I:M,Lt=T._splits,Ct=ke.distr==2?Lt.map(Wn=>oi[Wn]):Lt,bt=ke.distr==2?oi[Lt[1]]-oi[Lt[0]]:Me,et=T.ticks,Ze=T.border,Kt=et.show?et.size:0,on=En(Kt*Dt),Pn=En((T.alignTo==2?T._size-Kt-T.gap:T.gap)*Dt),zt=T._rotate*-Lh/180,ln=m(T._pos*Dt),li=(on+Pn)*ge,Hn=ln+li;j=O==0?Hn:0,$=O==1?Hn:0;let Si=T.font[0],Li=T.align==1?Ca:T.align==2?Gd:zt>0?Ca:zt<0?Gd:O==0?"center":N==3?Gd:Ca,Zi=zt||O==1?"middle":N==2?"top":og;Ne(Si,ce,Li,Zi);let ci=T.font[1]*T.lineGap,Mi=Lt.map(Wn=>m(o(Wn,ke,ze,ht))),Ii=T._values;for(let Wn=0;Wn<Ii.length;Wn++){let hi=Ii[Wn];if(hi!=null){O==0?$=Mi[Wn]:j=Mi[Wn],hi=""+hi;let dr=hi.indexOf(`
`)==-1?[hi]:hi.split(/\n/gm);for(let Xn=0;Xn<dr.length;Xn++){let $f=dr[Xn];zt?(d.save(),d.translate($,j+Xn*ci),d.rotate(zt),d.fillText($f,0,0),d.restore()):d.fillText($f,$,j+Xn*ci)}}}et.show&&mn(Mi,et.filter(n,Ct,b,Oe,bt),O,N,ln,on,Ht(et.width*Dt,3),et.stroke(n,b),et.dash,et.cap);let Ji=T.grid;Ji.show&&mn(Mi,Ji.filter(n,Ct,b,Oe,bt),O,O==0?2:1,O==0?M:I,O==0?pe:q,Ht(Ji.width*Dt,3),Ji.stroke(n,b),Ji.dash,Ji.cap),Ze.show&&mn([ln],[1],O==0?1:0,O==0?1:2,O==1?M:I,O==1?pe:q,Ht(Ze.width*Dt,3),Ze.stroke(n,b),Ze.dash,Ze.cap)}Rn("drawAxes")}function mt(b){x.forEach((T,N)=>{N>0&&(T._paths=null,b&&(s==1?(T.min=null,T.max=null):T.facets.forEach(O=>{O.min=null,O.max=null})))})}let an=!1,Gn=!1,kt=[];function gn(){Gn=!1;for(let b=0;b<kt.length;b++)Rn(...kt[b]);kt.length=0}function Un(){an||(Sw(Cf),an=!0)}function xl(b,T=!1){an=!0,Gn=T,b(n),Cf(),T&&kt.length>0&&queueMicrotask(gn)}n.batch=xl;function Cf(){if(le&&(_t(),le=!1),Se&&(Ce(),Se=!1),be){if(Qt(p,Ca,Qe),Qt(p,"top",ut),Qt(p,Jo,z),Qt(p,Ko,Ie),Qt(g,Ca,Qe),Qt(g,"top",ut),Qt(g,Jo,z),Qt(g,Ko,Ie),Qt(u,Jo,Wt),Qt(u,Ko,fn),h.width=En(Wt*Dt),h.height=En(fn*Dt),E.forEach(({_el:b,_show:T,_size:N,_pos:O,side:$})=>{if(b!=null)if(T){let j=$===3||$===0?N:0,ce=$%2==1;Qt(b,ce?"left":"top",O-j),Qt(b,ce?"width":"height",N),Qt(b,ce?"top":"left",ce?ut:Qe),Qt(b,ce?"height":"width",ce?Ie:z),Kd(b,Lr)}else xi(b,Lr)}),Br=Ds=zr=W=te=Z=K=Re=C=null,De=1,Ka(!0),Qe!=Ae||ut!=Vt||z!=$e||Ie!=Je){mt(!1);let b=z/$e,T=Ie/Je;if(me&&!ie&&de.left>=0){de.left*=b,de.top*=T,Gr&&rs(Gr,En(de.left),0,z,Ie),Hr&&rs(Hr,0,En(de.top),z,Ie);for(let N=0;N<dt.length;N++){let O=dt[N];O!=null&&(Yt[N]*=b,Vn[N]*=T,rs(O,Ri(Yt[N]),Ri(Vn[N]),z,Ie))}}if(Jt.show&&!re&&Jt.left>=0&&Jt.width>0){Jt.left*=b,Jt.width*=b,Jt.top*=T,Jt.height*=T;for(let N in hu)Qt($r,N,Jt[N])}Ae=Qe,Vt=ut,$e=z,Je=Ie}Rn("setSize"),be=!1}Wt>0&&fn>0&&(d.clearRect(0,0,h.width,h.height),Rn("drawClear"),A.forEach(b=>b()),Rn("draw")),Jt.show&&re&&(yl(Jt),re=!1),me&&ie&&(ur(null,!0,!1),ie=!1),ue.show&&ue.live&&ve&&(lu(),ve=!1),l||(l=!0,n.status=1,Rn("ready")),Is=!1,an=!1}n.redraw=(b,T)=>{Se=T||!1,b!==!1?Us(w,D.min,D.max):Un()};function ru(b,T){let N=S[b];if(N.from==null){if(rn==0){let O=N.range(n,T.min,T.max,b);T.min=O[0],T.max=O[1]}if(T.min>T.max){let O=T.min;T.min=T.max,T.max=O}if(rn>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;b==w&&N.distr==2&&rn>0&&(T.min=Gi(T.min,e[0]),T.max=Gi(T.max,e[0]),T.min==T.max&&T.max++),G[b]=T,le=!0,Un()}}n.setScale=ru;let au,ou,Gr,Hr,Rf,Pf,Wr,Xr,Lf,If,Zt,en,Ns=!1,Nn=de.drag,An=Nn.x,Cn=Nn.y;me&&(de.x&&(au=Ci($M,g)),de.y&&(ou=Ci(qM,g)),D.ori==0?(Gr=au,Hr=ou):(Gr=ou,Hr=au),Zt=de.left,en=de.top);let Jt=n.select=yn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),$r=Jt.show?Ci(XM,Jt.over?g:p):null;function yl(b,T){if(Jt.show){for(let N in b)Jt[N]=b[N],N in hu&&Qt($r,N,b[N]);T!==!1&&Rn("setSelect")}}n.setSelect=yl;function av(b){if(x[b].show)Q&&Kd(st[b],Lr);else if(Q&&xi(st[b],Lr),me){let N=Le?dt[0]:dt[b];N!=null&&rs(N,-10,-10,z,Ie)}}function Us(b,T,N){ru(b,{min:T,max:N})}function qi(b,T,N,O){T.focus!=null&&uv(b),T.show!=null&&x.forEach(($,j)=>{j>0&&(b==j||b==null)&&($.show=T.show,av(j),s==2?(Us($.facets[0].scale,null,null),Us($.facets[1].scale,null,null)):Us($.scale,null,null),Un())}),N!==!1&&Rn("setSeries",b,T),O&&ja("setSeries",n,b,T)}n.setSeries=qi;function ov(b,T){yn(R[b],T)}function lv(b,T){b.fill=Et(b.fill||null),b.dir=Rt(b.dir,-1),T=T??R.length,R.splice(T,0,b)}function cv(b){b==null?R.length=0:R.splice(b,1)}n.addBand=lv,n.setBand=ov,n.delBand=cv;function hv(b,T){x[b].alpha=T,me&&dt[b]!=null&&(dt[b].style.opacity=T),Q&&st[b]&&(st[b].style.opacity=T)}let hs,Os,hr,qr={focus:!0};function uv(b){if(b!=hr){let T=b==null,N=Ge.alpha!=1;x.forEach((O,$)=>{if(s==1||$>0){let j=T||$==0||$==b;O._focus=T?null:j,N&&hv($,j?1:Ge.alpha)}}),hr=b,N&&Un()}}Q&&it&&lt(ug,Te,b=>{de._lock||(nt(b),hr!=null&&qi(null,qr,!0,vn.setSeries))});function Yi(b,T,N){let O=S[T];N&&(b=b/Dt-(O.ori==1?ut:Qe));let $=z;O.ori==1&&($=Ie,b=$-b),O.dir==-1&&(b=$-b);let j=O._min,ce=O._max,ge=b/$,Me=j+(ce-j)*ge,Oe=O.distr;return Oe==3?La(10,Me):Oe==4?hw(Me,O.asinh):Oe==100?O.bwd(Me):Me}function dv(b,T){let N=Yi(b,w,T);return Gi(N,e[0],cn,hn)}n.valToIdx=b=>Gi(b,e[0]),n.posToIdx=dv,n.posToVal=Yi,n.valToPos=(b,T,N)=>S[T].ori==0?r(b,S[T],N?q:z,N?I:0):a(b,S[T],N?pe:Ie,N?M:0),n.setCursor=(b,T,N)=>{Zt=b.left,en=b.top,ur(null,T,N)};function Df(b,T){Qt($r,Ca,Jt.left=b),Qt($r,Jo,Jt.width=T)}function Nf(b,T){Qt($r,"top",Jt.top=b),Qt($r,Ko,Jt.height=T)}let Za=D.ori==0?Df:Nf,Ja=D.ori==1?Df:Nf;function fv(){if(Q&&ue.live)for(let b=s==2?1:0;b<x.length;b++){if(b==0&&tt)continue;let T=ue.values[b],N=0;for(let O in T)ae[b][N++].firstChild.nodeValue=T[O]}}function lu(b,T){if(b!=null&&(b.idxs?b.idxs.forEach((N,O)=>{ne[O]=N}):pw(b.idx)||ne.fill(b.idx),ue.idx=ne[0]),Q&&ue.live){for(let N=0;N<x.length;N++)(N>0||s==1&&!tt)&&pv(N,ne[N]);fv()}ve=!1,T!==!1&&Rn("setLegend")}n.setLegend=lu;function pv(b,T){let N=x[b],O=b==0&&L==2?oi:e[b],$;tt?$=N.values(n,b,T)??rt:($=N.value(n,T==null?null:O[T],b,T),$=$==null?rt:{_:$}),ue.values[b]=$}function ur(b,T,N){Lf=Zt,If=en,[Zt,en]=de.move(n,Zt,en),de.left=Zt,de.top=en,me&&(Gr&&rs(Gr,En(Zt),0,z,Ie),Hr&&rs(Hr,0,En(en),z,Ie));let O,$=cn>hn;hs=Gt,Os=null;let j=D.ori==0?z:Ie,ce=D.ori==1?z:Ie;if(Zt<0||rn==0||$){O=de.idx=null;for(let ge=0;ge<x.length;ge++){let Me=dt[ge];Me!=null&&rs(Me,-10,-10,z,Ie)}it&&qi(null,qr,!0,b==null&&vn.setSeries),ue.live&&(ne.fill(O),ve=!0)}else{let ge,Me,Oe;s==1&&(ge=D.ori==0?Zt:en,Me=Yi(ge,w),O=de.idx=Gi(Me,e[0],cn,hn),Oe=F(e[0][O],D,j,0));let ke=-10,ze=-10,ht=0,Lt=0,Ct=!0,bt="",et="";for(let Ze=s==2?1:0;Ze<x.length;Ze++){let Kt=x[Ze],on=ne[Ze],Pn=on==null?null:s==1?e[Ze][on]:e[Ze][1][on],zt=de.dataIdx(n,Ze,O,Me),ln=zt==null?null:s==1?e[Ze][zt]:e[Ze][1][zt];if(ve=ve||ln!=Pn||zt!=on,ne[Ze]=zt,Ze>0&&Kt.show){let li=zt==null?-10:zt==O?Oe:F(s==1?e[0][zt]:e[Ze][0][zt],D,j,0),Hn=ln==null?-10:P(ln,s==1?S[Kt.scale]:S[Kt.facets[1].scale],ce,0);if(it&&ln!=null){let Si=D.ori==1?Zt:en,Li=Tn(Ge.dist(n,Ze,zt,Hn,Si));if(Li<hs){let Zi=Ge.bias;if(Zi!=0){let ci=Yi(Si,Kt.scale),Mi=ln>=0?1:-1,Ii=ci>=0?1:-1;Ii==Mi&&(Ii==1?Zi==1?ln>=ci:ln<=ci:Zi==1?ln<=ci:ln>=ci)&&(hs=Li,Os=Ze)}else hs=Li,Os=Ze}}if(ve||Le){let Si,Li;D.ori==0?(Si=li,Li=Hn):(Si=Hn,Li=li);let Zi,ci,Mi,Ii,Ji,Wn,hi=!0,dr=fe.bbox;if(dr!=null){hi=!1;let Xn=dr(n,Ze);Mi=Xn.left,Ii=Xn.top,Zi=Xn.width,ci=Xn.height}else Mi=Si,Ii=Li,Zi=ci=fe.size(n,Ze);if(Wn=fe.fill(n,Ze),Ji=fe.stroke(n,Ze),Le)Ze==Os&&hs<=Ge.prox&&(ke=Mi,ze=Ii,ht=Zi,Lt=ci,Ct=hi,bt=Wn,et=Ji);else{let Xn=dt[Ze];Xn!=null&&(Yt[Ze]=Mi,Vn[Ze]=Ii,_g(Xn,Zi,ci,hi),gg(Xn,Wn,Ji),rs(Xn,Ri(Mi),Ri(Ii),z,Ie))}}}}if(Le){let Ze=Ge.prox,Kt=hr==null?hs<=Ze:hs>Ze||Os!=hr;if(ve||Kt){let on=dt[0];on!=null&&(Yt[0]=ke,Vn[0]=ze,_g(on,ht,Lt,Ct),gg(on,bt,et),rs(on,Ri(ke),Ri(ze),z,Ie))}}}if(Jt.show&&Ns)if(b!=null){let[ge,Me]=vn.scales,[Oe,ke]=vn.match,[ze,ht]=b.cursor.sync.scales,Lt=b.cursor.drag;if(An=Lt._x,Cn=Lt._y,An||Cn){let{left:Ct,top:bt,width:et,height:Ze}=b.select,Kt=b.scales[ze].ori,on=b.posToVal,Pn,zt,ln,li,Hn,Si=ge!=null&&Oe(ge,ze),Li=Me!=null&&ke(Me,ht);Si&&An?(Kt==0?(Pn=Ct,zt=et):(Pn=bt,zt=Ze),ln=S[ge],li=F(on(Pn,ze),ln,j,0),Hn=F(on(Pn+zt,ze),ln,j,0),Za(Hi(li,Hn),Tn(Hn-li))):Za(0,j),Li&&Cn?(Kt==1?(Pn=Ct,zt=et):(Pn=bt,zt=Ze),ln=S[Me],li=P(on(Pn,ht),ln,ce,0),Hn=P(on(Pn+zt,ht),ln,ce,0),Ja(Hi(li,Hn),Tn(Hn-li))):Ja(0,ce)}else uu()}else{let ge=Tn(Lf-Rf),Me=Tn(If-Pf);if(D.ori==1){let ht=ge;ge=Me,Me=ht}An=Nn.x&&ge>=Nn.dist,Cn=Nn.y&&Me>=Nn.dist;let Oe=Nn.uni;Oe!=null?An&&Cn&&(An=ge>=Oe,Cn=Me>=Oe,!An&&!Cn&&(Me>ge?Cn=!0:An=!0)):Nn.x&&Nn.y&&(An||Cn)&&(An=Cn=!0);let ke,ze;An&&(D.ori==0?(ke=Wr,ze=Zt):(ke=Xr,ze=en),Za(Hi(ke,ze),Tn(ze-ke)),Cn||Ja(0,ce)),Cn&&(D.ori==1?(ke=Wr,ze=Zt):(ke=Xr,ze=en),Ja(Hi(ke,ze),Tn(ze-ke)),An||Za(0,j)),!An&&!Cn&&(Za(0,0),Ja(0,0))}if(Nn._x=An,Nn._y=Cn,b==null){if(N){if(Xf!=null){let[ge,Me]=vn.scales;vn.values[0]=ge!=null?Yi(D.ori==0?Zt:en,ge):null,vn.values[1]=Me!=null?Yi(D.ori==1?Zt:en,Me):null}ja(Hd,n,Zt,en,z,Ie,O)}if(it){let ge=N&&vn.setSeries,Me=Ge.prox;hr==null?hs<=Me&&qi(Os,qr,!0,ge):hs>Me?qi(null,qr,!0,ge):Os!=hr&&qi(Os,qr,!0,ge)}}ve&&(ue.idx=O,lu()),T!==!1&&Rn("setCursor")}let Fs=null;Object.defineProperty(n,"rect",{get(){return Fs==null&&Ka(!1),Fs}});function Ka(b=!1){b?Fs=null:(Fs=g.getBoundingClientRect(),Rn("syncRect",Fs))}function Uf(b,T,N,O,$,j,ce){de._lock||Ns&&b!=null&&b.movementX==0&&b.movementY==0||(cu(b,T,N,O,$,j,ce,!1,b!=null),b!=null?ur(null,!0,!0):ur(T,!0,!1))}function cu(b,T,N,O,$,j,ce,ge,Me){if(Fs==null&&Ka(!1),nt(b),b!=null)N=b.clientX-Fs.left,O=b.clientY-Fs.top;else{if(N<0||O<0){Zt=-10,en=-10;return}let[Oe,ke]=vn.scales,ze=T.cursor.sync,[ht,Lt]=ze.values,[Ct,bt]=ze.scales,[et,Ze]=vn.match,Kt=T.axes[0].side%2==1,on=D.ori==0?z:Ie,Pn=D.ori==1?z:Ie,zt=Kt?j:$,ln=Kt?$:j,li=Kt?O:N,Hn=Kt?N:O;if(Ct!=null?N=et(Oe,Ct)?o(ht,S[Oe],on,0):-10:N=on*(li/zt),bt!=null?O=Ze(ke,bt)?o(Lt,S[ke],Pn,0):-10:O=Pn*(Hn/ln),D.ori==1){let Si=N;N=O,O=Si}}Me&&(T==null||T.cursor.event.type==Hd)&&((N<=1||N>=z-1)&&(N=Rr(N,z)),(O<=1||O>=Ie-1)&&(O=Rr(O,Ie))),ge?(Rf=N,Pf=O,[Wr,Xr]=de.move(n,N,O)):(Zt=N,en=O)}let hu={width:0,height:0,left:0,top:0};function uu(){yl(hu,!1)}let Of,Ff,kf,Bf;function zf(b,T,N,O,$,j,ce){Ns=!0,An=Cn=Nn._x=Nn._y=!1,cu(b,T,N,O,$,j,ce,!0,!1),b!=null&&(lt(Wd,Zd,Vf,!1),ja(cg,n,Wr,Xr,z,Ie,null));let{left:ge,top:Me,width:Oe,height:ke}=Jt;Of=ge,Ff=Me,kf=Oe,Bf=ke}function Vf(b,T,N,O,$,j,ce){Ns=Nn._x=Nn._y=!1,cu(b,T,N,O,$,j,ce,!1,!0);let{left:ge,top:Me,width:Oe,height:ke}=Jt,ze=Oe>0||ke>0,ht=Of!=ge||Ff!=Me||kf!=Oe||Bf!=ke;if(ze&&ht&&yl(Jt),Nn.setScale&&ze&&ht){let Lt=ge,Ct=Oe,bt=Me,et=ke;if(D.ori==1&&(Lt=Me,Ct=ke,bt=ge,et=Oe),An&&Us(w,Yi(Lt,w),Yi(Lt+Ct,w)),Cn)for(let Ze in S){let Kt=S[Ze];Ze!=w&&Kt.from==null&&Kt.min!=Gt&&Us(Ze,Yi(bt+et,Ze),Yi(bt,Ze))}uu()}else de.lock&&(de._lock=!de._lock,ur(T,!0,b!=null));b!=null&&(Bt(Wd,Zd),ja(Wd,n,Zt,en,z,Ie,null))}function mv(b,T,N,O,$,j,ce){if(de._lock)return;nt(b);let ge=Ns;if(Ns){let Me=!0,Oe=!0,ke=10,ze,ht;D.ori==0?(ze=An,ht=Cn):(ze=Cn,ht=An),ze&&ht&&(Me=Zt<=ke||Zt>=z-ke,Oe=en<=ke||en>=Ie-ke),ze&&Me&&(Zt=Zt<Wr?0:z),ht&&Oe&&(en=en<Xr?0:Ie),ur(null,!0,!0),Ns=!1}Zt=-10,en=-10,ne.fill(null),ur(null,!0,!0),ge&&(Ns=ge)}function Gf(b,T,N,O,$,j,ce){de._lock||(nt(b),Ya(),uu(),b!=null&&ja(dg,n,Zt,en,z,Ie,null))}function Hf(){E.forEach(P1),B(n.width,n.height,!0)}Ir(Ih,Pa,Hf);let Yr={};Yr.mousedown=zf,Yr.mousemove=Uf,Yr.mouseup=Vf,Yr.dblclick=Gf,Yr.setSeries=(b,T,N,O)=>{let $=vn.match[2];N=$(n,T,N),N!=-1&&qi(N,O,!0,!1)},me&&(lt(cg,g,zf),lt(Hd,g,Uf),lt(hg,g,b=>{nt(b),Ka(!1)}),lt(ug,g,mv),lt(dg,g,Gf),sf.add(n),n.syncRect=Ka);let bl=n.hooks=i.hooks||{};function Rn(b,T,N){Gn?kt.push([b,T,N]):b in bl&&bl[b].forEach(O=>{O.call(null,n,T,N)})}(i.plugins||[]).forEach(b=>{for(let T in b.hooks)bl[T]=(bl[T]||[]).concat(b.hooks[T])});let Wf=(b,T,N)=>N,vn=yn({key:null,setSeries:!1,filters:{pub:Mg,sub:Mg},scales:[w,x[1]?x[1].scale:null],match:[wg,wg,Wf],values:[null,null]},de.sync);vn.match.length==2&&vn.match.push(Wf),de.sync=vn;let Xf=vn.key,du=y0(Xf);function ja(b,T,N,O,$,j,ce){vn.filters.pub(b,T,N,O,$,j,ce)&&du.pub(b,T,N,O,$,j,ce)}du.sub(n);function gv(b,T,N,O,$,j,ce){vn.filters.sub(b,T,N,O,$,j,ce)&&Yr[b](null,T,N,O,$,j,ce)}n.pub=gv;function vv(){du.unsub(n),sf.delete(n),sn.clear(),jd(Ih,Pa,Hf),c.remove(),Te?.remove(),Rn("destroy")}n.destroy=vv;function fu(){Rn("init",i,e),qa(e||i.data,!1),G[w]?ru(w,G[w]):Ya(),re=Jt.show&&(Jt.width>0||Jt.height>0),ie=ve=!0,B(i.width,i.height)}return x.forEach(kr),E.forEach(as),t?t instanceof HTMLElement?(t.appendChild(c),fu()):t(n,fu):fu(),n}Dn.assign=yn;Dn.fmtNum=uf;Dn.rangeNum=Dh;Dn.rangeLog=Oh;Dn.rangeAsinh=cf;Dn.orient=Nr;Dn.pxRatio=Dt;Dn.join=bw;Dn.fmtDate=ff,Dn.tzDate=Iw;Dn.sync=y0;{Dn.addGap=p1,Dn.clipGaps=Bh;let i=Dn.paths={points:T0};i.linear=C0,i.stepped=v1,i.bars=_1,i.spline=y1}var L1=62,I1={measured:{width:2},before:{width:1.25,dash:[5,3]},after:{width:1.25}},D1=0,ka=class{constructor(e,t=()=>{}){this.moved=e;this.zoomed=t;new ResizeObserver(()=>this.resize()).observe(this.element),this.element.addEventListener("wheel",n=>this.wheel(n),{passive:!1}),this.element.addEventListener("dblclick",()=>this.reset())}moved;zoomed;key=`plots-${D1++}`;element=f("div",{class:"plots"});plots=[];heads=[];marks=[];shown=null;range=[0,1];busy=!1;place=0;show(e,t=null){if(this.refresh(e,t))return;this.clear(),this.shown=e;let{x:n}=e,s=n[0],r=n[n.length-1];this.range=t??e.window??[s,r],e.panes.forEach((a,o)=>this.add(a,o===e.panes.length-1)),this.mark(this.place),this.zoomed(this.range)}refresh(e,t){let n=r=>JSON.stringify([r.xLabel,r.panes.map(a=>[a.title,a.unit,a.lines.map(o=>[o.label,o.role])])]);if(!this.shown||n(this.shown)!==n(e))return!1;this.shown=e;let{x:s}=e;return this.range=t??e.window??[s[0],s[s.length-1]],e.panes.forEach((r,a)=>{let o=this.plots[a];r.lines.forEach((l,c)=>{o.series[c+1].show!==l.shown&&o.setSeries(c+1,{show:l.shown})}),o.setData([s,...r.lines.map(l=>l.y)])}),this.mark(this.place),this.zoomed(this.range),!0}clear(){this.shown=null;for(let e of this.plots)e.destroy();this.plots=[],this.heads=[],this.marks=[],this.element.replaceChildren()}get window(){return this.range}get whole(){let e=this.shown?.x;return this.shown?.whole?this.shown.whole:e&&e.length?[e[0],e[e.length-1]]:[0,1]}reset(){this.zoom(...this.whole)}zoom(e,t){let[n,s]=this.whole,r=(s-n)*(this.shown?.whole?1e-7:1e-4)||1,a=Math.min(Math.max(t-e,r),s-n),o=Math.min(Math.max(e,n),s-a);this.range=[o,o+a],this.busy=!0;for(let l of this.plots)l.setScale("x",{min:this.range[0],max:this.range[1]});this.busy=!1,this.mark(this.place),this.zoomed(this.range)}zoomBy(e,t=(this.range[0]+this.range[1])/2){this.zoom(t-(t-this.range[0])*e,t+(this.range[1]-t)*e)}pan(e){let t=this.range[1]-this.range[0];this.zoom(this.range[0]+e*t,this.range[1]+e*t)}setShown(e,t){this.shown?.panes.forEach((n,s)=>n.lines.forEach((r,a)=>{r.role===e&&(r.shown=t,this.plots[s].setSeries(a+1,{show:t}))})),this.mark(this.place)}mark(e){this.place=e;let t=this.shown;t&&t.panes.forEach((n,s)=>{let r=this.plots[s],a=r.valToPos(e,"x"),o=e>=this.range[0]&&e<=this.range[1];this.marks[s].style.transform=`translateX(${a}px)`,this.marks[s].hidden=!o;let l=this.heads[s].querySelectorAll("output");n.lines.forEach((c,h)=>{let d=l[h];d.parentElement.hidden=!c.shown,c.shown&&(d.textContent=Yf(wi(t.x,c.y,e),c.step))})})}repaint(){let{shown:e,range:t}=this;e&&(this.clear(),this.show(e,t))}add(e,t){let n=this.shown,s=f("div",{class:"pane-head"},f("span",{},f("b",{},e.title),f("span",{class:"unit"},` [${e.unit||"–"}]`)));for(let p of e.lines)s.append(f("span",{class:"value"},...p.label?[f("i",{class:`swatch ${p.role}`}),`${p.label} `]:[],f("output",{},"–")));let r=f("div",{class:"pane"});this.element.append(s,r);let a=yt("ink"),o={stroke:yt("line"),width:1},l=yt("span"),c="12px system-ui, sans-serif",h=(p,g)=>U1(g),d=N1(()=>new Dn({width:Math.max(this.element.clientWidth,200),height:this.height(t),padding:[6,12,0,0],legend:{show:!1},cursor:{sync:{key:this.key,setSeries:!1},drag:{x:!0,y:!1,setScale:!1},points:{show:!1},y:!1,bind:{dblclick:()=>null}},scales:{x:{time:!1,auto:!1,range:()=>this.range},y:{range:(p,g,_)=>O1(g,_)}},axes:[{stroke:a,grid:o,ticks:{show:!1},size:t?24:6,font:c,values:t?h:()=>[],label:t?n.xLabel:void 0,labelSize:16,labelFont:c,labelGap:0,gap:3},{stroke:a,grid:o,ticks:{show:!1},size:L1,font:c,values:h}],series:[{},...e.lines.map(p=>{let g=I1[p.role]??{width:1.25};return{label:p.label,stroke:yt(p.role),points:{show:!1},show:p.shown,...g}})],hooks:{drawClear:[p=>{p.ctx.fillStyle=l;for(let[g,_]of n.spans){let m=Math.max(g,this.range[0]),v=Math.min(_,this.range[1]);v>m&&p.ctx.fillRect(p.valToPos(m,"x",!0),p.bbox.top,p.valToPos(v,"x",!0)-p.valToPos(m,"x",!0),p.bbox.height)}}],setSelect:[p=>{p.select.width>4&&this.zoom(p.posToVal(p.select.left,"x"),p.posToVal(p.select.left+p.select.width,"x")),p.setSelect({left:0,top:0,width:0,height:0},!1)}],setCursor:[p=>{this.busy||p.cursor.left===void 0||p.cursor.left===null||p.cursor.left<0||!p.cursor.event||this.moved(p.posToVal(p.cursor.left,"x"))}]}},[n.x,...e.lines.map(p=>p.y)],r)),u=f("div",{class:"mark-line"});d.over.append(u),d.over.style.touchAction="pan-y",this.plots.push(d),this.heads.push(s),this.marks.push(u)}height(e){let t=this.shown?.panes.length??1;return(t>3?96:t===3?120:t===2?165:250)+(e?40:6)+6}resize(){let e=this.element.clientWidth;e<50||(this.plots.forEach((t,n)=>t.setSize({width:e,height:this.height(n===this.plots.length-1)})),this.mark(this.place))}wheel(e){if(!e.ctrlKey&&!e.shiftKey)return;e.preventDefault();let t=this.plots[0];t&&(e.shiftKey?this.pan(Math.sign(e.deltaY||e.deltaX)*.1):this.zoomBy(e.deltaY>0?1.25:.8,t.posToVal(e.clientX-t.over.getBoundingClientRect().left,"x")))}};function N1(i){if(Qa())return i();let e=HTMLCanvasElement.prototype,t=e.getContext;e.getContext=function(n,s){return t.call(this,n,n==="2d"?{...s,willReadFrequently:!0}:s)};try{return i()}finally{e.getContext=t}}function U1(i){let e=i.map(n=>String(Number(n.toPrecision(10))));if(e.some(n=>n.includes("e")))return e.map(us);let t=Math.max(0,...e.map(n=>n.split(".")[1]?.length??0));return i.map(n=>us(n===0?"0":n.toFixed(t)))}function O1(i,e){if(i===null||e===null)return[0,1];if(e>i)return Dn.rangeNum(i,e,.1,!0);let t=.1*Math.abs(i)||1;return[i-t,i+t]}var F1=[1,2,5,10,20,50,100],k1=matchMedia("(max-width: 40rem)").matches?6:16,I0=matchMedia("(prefers-reduced-motion: reduce)"),sr=class{constructor(e,t){this.model=e;this.store=t;this.scene=e.scenes[0],this.view=e.scenes.some(n=>n.motion)?new tr(e.stage):null,e.scenes.forEach((n,s)=>this.choice.append(f("option",{value:String(s)},n.label))),this.build(),this.show(this.scene),$n(()=>{this.plots.repaint(),this.view?.repaint(),this.draw()}),requestAnimationFrame(n=>this.step(n))}model;store;element=f("div",{class:"player",tabindex:"-1"});plots=new ka(e=>{this.playing||this.goTo(e)},e=>this.seen(e));view;choice=f("select",{"aria-label":Mt("choice")});note=f("span",{class:"mark"});overlays=f("div",{class:"group overlays",role:"group","aria-label":Mt("curves")});channels=f("div",{class:"group channels",role:"group","aria-label":Mt("channels")});play=f("button",{type:"button",class:"play"},Mt("play"));slider=f("input",{type:"range",min:"0",max:"1",step:"any",value:"0","aria-label":""});clock=f("output",{class:"clock"});speed=f("select",{"aria-label":Mt("speed")});roles=new Map;panes=new Map;livelyPart=f("button",{type:"button",title:Mt("zoomToEvent"),click:()=>this.lively()},Mt("event"));scene;now=0;playing=!1;way=1;last=0;moved=null;frames=[];choose(e){let t=this.model.scenes.findIndex(n=>n.name===e);return t<0?!1:(this.choice.value=String(t),this.show(this.model.scenes[t]),!0)}replace(e,t){let n=e.x.words!==this.model.x.words,s=Math.max(this.model.scenes.indexOf(this.scene),0),r=this.plots.window,[a,o]=this.plots.whole,l=e.scenes[Math.min(s,e.scenes.length-1)],c=n||r[0]<=a&&r[1]>=o;(e.roles.map(d=>d.label).join()!==this.model.roles.map(d=>d.label).join()||e.roles.length!==this.model.roles.length)&&this.offerRoles(e),this.model=e,this.store=t,this.scene=l;let h=t.get(l.x);n&&this.offer(l),this.view&&(this.view.element.hidden=!l.motion),this.slider.min=String(h[0]),this.slider.max=String(h[h.length-1]),this.plot(c?null:r),l.motion&&this.view&&this.view.show(t.content.mechanisms[l.motion.mechanism],l.motion),this.goTo(this.now)}zoom(e,t){this.plots.zoom(e,t)}goTo(e){let[t,n]=this.plots.whole;this.now=Math.min(Math.max(e,t),n),this.slider.value=String(this.now),this.clock.textContent=`${us(this.now.toFixed(3))} ${this.model.x.unit}`,this.plots.mark(this.now),this.moved?.(this.now);let s=this.scene.motion;if(s&&this.view){let r=this.store.get(this.scene.x),a=o=>wi(r,this.store.get(o),this.now);this.view.set({body:a(s.body),travel:a(s.travel),ground:a(s.ground),load:a(s.load),time:this.now})}}build(){let{model:e}=this;this.offerRoles(e);let t=h=>()=>this.stepScene(h),n=f("div",{class:"group"},f("button",{type:"button",title:Mt("previous"),click:t(-1)},"‹"),this.choice,f("button",{type:"button",title:Mt("next"),click:t(1)},"›"),this.note);this.choice.addEventListener("change",()=>this.show(e.scenes[Number(this.choice.value)])),e.scenes.length<2&&(n.hidden=!0);let s=f("div",{class:"group"},f("button",{type:"button",title:Mt("zoomIn"),click:()=>this.plots.zoomBy(.5,this.now)},"+"),f("button",{type:"button",title:Mt("zoomOut"),click:()=>this.plots.zoomBy(2,this.now)},"−"),f("button",{type:"button",title:Mt("everything"),click:()=>this.plots.reset()},Mt("all")),this.livelyPart),r=ui(Mt("wide"),!1,h=>{this.element.classList.toggle("wide",h),document.body.classList.toggle("behind",h)},Mt("fillWindow"));r.classList.add("widen");let a=e.x.unit==="s",o=e.slower??(a?10:2),l=[...new Set([...F1,o])].sort((h,d)=>h-d);for(let h of l)this.speed.append(f("option",{value:String(h)},h>1?`1/${h}`:Mt(a?"realTime":"fast")));this.speed.value=String(o),this.play.addEventListener("click",()=>this.toggle()),this.slider.addEventListener("input",()=>{this.pause(),this.goTo(Number(this.slider.value))});let c=f("div",{class:this.view?e.stage?"stage-and-plots stage-first":"stage-and-plots":"plots-only"},this.plots.element);this.view&&c.append(this.view.element),this.element.append(f("div",{class:"bar"},n,this.overlays,f("span",{class:"grow"}),s,r),f("div",{class:"bar"},this.channels),c,f("div",{class:"bar transport"},this.play,this.slider,this.clock,f("label",{},`${Mt("speed")} `,this.speed)),f("p",{class:"hint"},Mt("hint"))),this.element.addEventListener("keydown",h=>this.key(h))}offerRoles(e){let t=e.roles.map(({role:n,label:s,shown:r})=>{this.roles.has(n)||this.roles.set(n,r);let a=ui(s,this.roles.get(n),o=>{this.roles.set(n,o),this.plots.setShown(n,o)});return a.prepend(f("i",{class:`swatch ${n}`})),a});this.overlays.replaceChildren(...t),this.overlays.hidden=t.length<2}show(e){let t=this.scene===e?null:this.keptWindow(e);this.scene=e,this.note.textContent=e.note,this.note.parentElement.className=`group ${e.tone}`,this.note.hidden=!e.note,this.livelyPart.hidden=!e.window;let n=this.store.get(e.x);this.offer(e),this.slider.min=String(n[0]),this.slider.max=String(n[n.length-1]),this.plot(t),e.motion&&this.view&&this.view.show(this.store.content.mechanisms[e.motion.mechanism],e.motion),this.goTo(this.now),this.draw()}offer(e){let t=e.panes.length>k1,n=0,s=e.panes.length<2?[]:e.panes.map(r=>{let a=this.isShown(r.name,r.shown),o=ui(r.name,a,l=>{this.panes.set(r.name,l),this.plot(this.plots.window)},r.words);return t&&!a&&(o.classList.add("other"),n++),o});if(n){let r=this.channels.classList.contains("every");s.push(ui(Mt("more",String(n)),r,a=>{this.channels.classList.toggle("every",a)},Mt("otherChannels")))}this.channels.replaceChildren(...s)}plot(e){let{scene:t}=this,n=t.panes.filter(s=>this.isShown(s.name,s.shown));n.length||(n=t.panes.slice(0,1)),this.slider.setAttribute("aria-label",this.model.x.words),this.plots.show({x:this.store.get(t.x),xLabel:`${this.model.x.words} [${this.model.x.unit}]`,spans:t.spans,window:t.window,panes:n.map(s=>({title:s.words,unit:s.unit,lines:s.curves.map(r=>({label:this.model.roles.length>1?r.label:"",role:r.role,y:this.store.get(r.y),step:this.store.step(r.y),shown:this.roles.get(r.role)??!0}))}))},e),this.plots.mark(this.now)}isShown(e,t){return this.panes.get(e)??t}keptWindow(e){let[t,n]=this.plots.window,[s,r]=this.plots.whole,a=this.store.get(e.x);if(t<=s&&n>=r)return[a[0],a[a.length-1]];let o=this.scene.window;return o&&Math.abs(t-o[0])<1e-9&&Math.abs(n-o[1])<1e-9?null:t>=a[0]&&n<=a[a.length-1]?[t,n]:null}lively(){this.scene.window?this.plots.zoom(...this.scene.window):this.plots.reset()}stepScene(e){let{scenes:t}=this.model,n=(t.indexOf(this.scene)+e+t.length)%t.length;this.choose(t[n].name)}seen([e,t]){(this.now<e||this.now>t)&&this.goTo(e)}toggle(){this.playing?this.pause():this.start()}start(){let[e,t]=this.plots.window;(this.now>=t-1e-9*(t-e)||this.now<e)&&this.goTo(e),this.playing=!0,this.way=1,this.last=0,this.frames.length=0,this.play.textContent=Mt("pause")}get rate(){let[e,t]=this.plots.whole;return this.model.x.unit==="s"?1:(t-e)/2}pause(){this.playing=!1,this.play.textContent=Mt("play")}step(e){if(this.playing){let t=this.last?e-this.last:0;this.last&&(this.frames.push(t),this.frames.length>600&&this.frames.shift()),this.last=e;let[n,s]=this.plots.window,r=this.now+this.way*this.rate*Math.min(t,250)/1e3/Number(this.speed.value);(r>s||r<n)&&(I0.matches&&this.pause(),this.model.x.unit!=="s"&&(this.way=-this.way),r=I0.matches||this.model.x.unit!=="s"?Math.min(Math.max(r,n),s):n),this.goTo(r)}this.draw(),requestAnimationFrame(t=>this.step(t))}draw(){this.view?.draw()}key(e){if(e.ctrlKey||e.metaKey||e.altKey||e.target instanceof HTMLSelectElement)return;let t=e.target instanceof HTMLButtonElement,n=e.target===this.slider,s=this.store.get(this.scene.x),r=(s[s.length-1]-s[0])/Math.max(s.length-1,1),a={"+":()=>this.plots.zoomBy(.5,this.now),"=":()=>this.plots.zoomBy(.5,this.now),"-":()=>this.plots.zoomBy(2,this.now),0:()=>this.plots.reset(),9:()=>this.lively(),"[":()=>this.stepScene(-1),"]":()=>this.stepScene(1),f:()=>this.element.querySelector(".widen").click(),...t?{}:{" ":()=>this.toggle()},...n?{}:{ArrowLeft:()=>{this.pause(),this.goTo(this.now-r*(e.shiftKey?20:1))},ArrowRight:()=>{this.pause(),this.goTo(this.now+r*(e.shiftKey?20:1))}}};e.key==="Escape"&&this.element.classList.contains("wide")&&(a.Escape=a.f);let o=a[e.key];o&&(e.preventDefault(),o())}};function Fe(i,e,t=""){return f("label",{class:"field"},f("span",{},i),e,...t?[f("small",{},t)]:[])}function At(i){return f("p",{class:"problem",role:"alert"},i instanceof Error?i.message:String(i))}function Ur(i,e){let t=f("button",{type:"button"},H("Copy"));return t.addEventListener("click",()=>{navigator.clipboard.writeText(e).then(()=>{t.textContent=H("Copied")},()=>{t.textContent=H("Select and copy")})}),f("section",{class:"code"},f("div",{class:"bar"},f("h3",{},i),t),f("pre",{tabindex:"0","aria-label":i},e))}function nl({python:i,command:e,files:t}){return[Ur(H("The same in Python"),i),Ur(H("The same on the command line"),e),...Object.entries(t).map(([n,s])=>Ur(n,s))]}var Ps=class{busy=!1;next=null;async ask(e){if(this.next=e,!this.busy){for(this.busy=!0;this.next;){let t=this.next;this.next=null,await t()}this.busy=!1}}},Ba=class{constructor(e,t,n,s={}){this.moved=n;let r=this.known;for(let l of e.numbers)r.set(l.path,l);let a=f("select",{"aria-label":H("another number")},f("option",{value:""},H("another number …")));for(let{path:l}of e.numbers)a.append(f("option",{value:l},l));a.addEventListener("change",()=>{let l=r.get(a.value);l&&this.add(l),a.value=""});for(let l of t){let c=r.get(l);c&&this.add(c)}for(let[l,c]of Object.entries(s)){let h=r.get(l);h&&Number.isFinite(c)&&(this.add(h),this.set(l,c))}let o=f("button",{type:"button"},H("All as they were"));o.addEventListener("click",()=>{for(let l of Object.keys(this.changes))delete this.changes[l];this.rows.querySelectorAll("input").forEach(l=>{l.value=l.defaultValue}),this.moved()}),this.element.append(this.rows,f("div",{class:"bar"},a,o))}moved;element=f("div",{class:"sliders"});changes={};rows=f("div",{});known=new Map;set(e,t){let n=this.known.get(e);if(!n)return;let s=Number((t*n.factor).toPrecision(7)),r=this.rows.querySelector(`[data-path="${CSS.escape(e)}"]`);Math.abs(t-n.value)<=1e-12*Math.max(Math.abs(t),1)?delete this.changes[e]:this.changes[e]=t,r?.querySelectorAll("input").forEach(a=>{a.value=String(s)})}add(e){if(this.rows.querySelector(`[data-path="${CSS.escape(e.path)}"]`))return;let t=e.value*e.factor,n=.5*Math.abs(t)||1,s=String(Number(t.toPrecision(6))),r=`${e.path} [${e.unit||"–"}]`,a=f("input",{type:"range",min:String(t-n),max:String(t+n),step:String(n/100),value:s,"aria-label":r}),o=f("input",{type:"number",step:"any",value:s,"aria-label":`${r}, ${H("typed")}`}),l=c=>{let h=Number(c);c===""||!Number.isFinite(h)||(c===s?delete this.changes[e.path]:this.changes[e.path]=h/e.factor,this.moved())};a.addEventListener("input",()=>{o.value=String(Number(Number(a.value).toPrecision(5))),l(o.value)}),o.addEventListener("input",()=>{a.value=o.value,l(o.value)}),this.rows.append(f("div",{class:"slider","data-path":e.path},f("span",{class:"name"},e.path),a,o,f("span",{class:"unit"},e.unit||"–")))}},Hh=class{constructor(e){this.question=e;this.element.append(this.state,this.place,this.ways)}question;element=f("div",{class:"live"});state=f("p",{class:"state",role:"status"});place=f("div",{});ways=f("div",{class:"ways"});player=null;busy=!1;again=!1;shown=null;moved=null;times=[];async ask(){if(this.again=this.busy,this.busy)return;this.busy=!0;let e=performance.now(),t=setTimeout(()=>{this.state.textContent=H("computing; the first time a model is compiled once, which takes some seconds")},500);try{let n=ti.of(await this.question()),s=n.content.viewers[0];this.player?this.player.replace(s,n):(this.player=new sr(s,n),this.place.replaceChildren(this.player.element),this.player.moved=r=>this.moved?.(r)),this.shown?.(s,n),this.ways.replaceChildren(...nl(n.content)),this.times.push(performance.now()-e),this.state.textContent=`${H("computed and drawn in")} ${Ee(this.times[this.times.length-1],2)} ms`,this.state.classList.remove("problem")}catch(n){this.state.textContent=n instanceof Error?n.message:String(n),this.state.classList.add("problem")}finally{clearTimeout(t),this.busy=!1,this.again&&this.ask()}}};var sl=async(i,e,t)=>(await On(i,e,t)).json(),al=i=>sl("POST","/api/jobs",i),bf=i=>sl("POST","/api/ask",i),ol=i=>_n(`/api/jobs/${encodeURIComponent(i)}`),Wh=new Map,Xh=null,il=null;function N0(){il=new WebSocket(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/api/live`),il.addEventListener("message",i=>{Xh=JSON.parse(i.data),B1()}),il.addEventListener("close",()=>{il=null,setTimeout(()=>{Wh.size&&N0()},1e3)})}function B1(){for(let[i,e]of Wh)e.node.isConnected&&(e.shown=!0),e.node.isConnected||!e.shown?i(Xh):Wh.delete(i)}function Sf(i,e){Wh.set(e,{node:i,shown:!1}),Xh&&e(Xh),il||N0()}var z1={running:"running",cancelling:"stopping",done:"done",failed:"failed",cancelled:"cancelled",stopped:"stopped"},V1={running:"plain",cancelling:"fair",done:"good",failed:"bad",cancelled:"fair",stopped:"bad"};function yf(i){let e=Math.max(0,Math.round(i));return e<60?`${e} s`:e<3600?`${Math.floor(e/60)} min ${e%60} s`:`${Math.floor(e/3600)} h ${Math.floor(e%3600/60)} min`}var rl=class{constructor(e,t){this.job=e;this.open=t;this.bar.setAttribute("aria-label",`share of ${e.title} that is done`),this.element.append(f("div",{class:"bar"},f("h3",{},e.title),this.state,this.times),this.bar,this.said,this.told,this.actions),this.show(e)}job;open;element=f("article",{class:"job"});state=f("span",{class:"mark"});times=f("span",{class:"muted"});said=f("p",{class:"state",role:"status"});bar=f("progress",{max:"1"});actions=f("div",{class:"bar"});told=f("div",{});shown="";timer=0;show(e){this.job=e;let t=e.state==="running"||e.state==="cancelling";if(this.state.textContent=z1[e.state],this.state.className=`mark ${V1[e.state]}`,this.bar.hidden=!t,e.share===null?this.bar.removeAttribute("value"):this.bar.value=e.share,this.said.hidden=!t,this.said.textContent=e.state==="cancelling"?"stopping; what is finished is kept":e.said||"starting",this.tick(),clearInterval(this.timer),t&&(this.timer=window.setInterval(()=>{this.element.isConnected?this.tick():clearInterval(this.timer)},1e3)),this.shown===e.state)return;this.shown=e.state,this.told.replaceChildren(...e.error?[At(e.error)]:[]);let n=(r,a,o=!1)=>{let l=f("button",{type:"button",...o?{class:"main"}:{},"aria-label":`${r}: ${e.title}`},r);return l.addEventListener("click",()=>{l.disabled=!0,a().catch(c=>{this.told.replaceChildren(At(c)),l.disabled=!1})}),l},s=`/api/jobs/${encodeURIComponent(e.id)}`;this.actions.replaceChildren(...e.state==="running"?[n("Cancel",()=>sl("POST",`${s}/cancel`,{}))]:[],...this.open&&(e.state==="done"||e.kind==="sweep")?[n("Show the results",async()=>this.open(this.job),!0)]:[],...!t&&e.state!=="done"?[n(e.kind==="sweep"?"Resume":"Begin again",()=>sl("POST",`${s}/again`,{}),!0)]:[],...t?[]:[n("Take off the list",()=>sl("DELETE",s))]),this.actions.append(f("details",{},f("summary",{},"In Python, and on the command line"),rr(e)))}tick(){let{begun:e,ended:t,share:n,left:s,state:r}=this.job,a=(t??Date.now()/1e3)-e,o=[t?`took ${yf(a)}`:`for ${yf(a)}`];r==="running"&&n!==null&&o.push(`${Ee(100*n,3)} %`),r==="running"&&s!==null&&s>=1&&o.push(`about ${yf(s)} left`),this.times.textContent=o.join(" · ")}};function Va(i,e,t){let n=f("div",{class:"jobs"},f("p",{class:"muted"},"asking …")),s=new Map;return Sf(n,r=>{let a=r.filter(l=>!i||i.includes(l.kind));for(let l of a){let c=s.get(l.id);c?c.show(l):s.set(l.id,new rl(l,e))}for(let l of[...s.keys()])a.some(c=>c.id===l)||s.delete(l);let o=a.map(l=>s.get(l.id).element);o.length?(o.some((l,c)=>n.children[c]!==l)||n.children.length!==o.length)&&n.replaceChildren(...o):n.replaceChildren(f("p",{class:"empty"},t))}),n}function rr(i){return f("div",{class:"ways"},...i.python?[Ur("The same in Python",i.python)]:[],...i.command?[Ur("The same on the command line",i.command)]:[],...Object.entries(i.files??{}).map(([e,t])=>Ur(e,t)))}function ll(i,e){return f("section",{class:"whole"},f("div",{class:"bar"},f("h2",{},e),f("a",{href:i,target:"_blank",rel:"noopener"},"open it in a tab of its own")),f("iframe",{src:i,title:e,sandbox:"allow-scripts",class:"report"}))}function U0(i,e,t){let n=f("input",{type:"file",multiple:!0,"aria-label":e}),s=f("div",{"aria-live":"polite"}),r=f("div",{class:"drop"},f("p",{},e),n,s),a=async o=>{let l=[],c=[];for(let h of o??[]){let d=[i().replace(/\/+$/,""),h.name].filter(Boolean).join("/");s.replaceChildren(f("p",{class:"state"},`${h.name}: ${Ee(h.size/1e6,3)} MB on the way …`));try{await G1(d,h),l.push(d)}catch(u){c.push(At(u))}}s.replaceChildren(...c,...l.length?[f("p",{class:"good"},`${l.join(", ")}: here now.`)]:[]),n.value="",l.length&&t(l)};return n.addEventListener("change",()=>{a(n.files)}),r.addEventListener("dragover",o=>{o.preventDefault(),r.classList.add("over")}),r.addEventListener("dragleave",()=>r.classList.remove("over")),r.addEventListener("drop",o=>{o.preventDefault(),r.classList.remove("over"),a(o.dataTransfer?.files??null)}),r}var D0=25e7;async function G1(i,e){if(e.size>D0)throw new Error(`${e.name}: ${Ee(e.size/1e6,3)} MB; at most ${D0/1e6} MB are taken here. Copy it into the folder instead.`);let t=await fetch(`/api/upload?${new URLSearchParams({path:i})}`,{method:"PUT",body:e});if(t.ok)return;let n=await t.json().catch(()=>null);throw new Error(n?.error?.text??`${e.name}: ${t.statusText}`)}var za=class{constructor(e,t,n){this.task=t;this.show=n;this.button=f("button",{type:"button",class:"main"},e),this.button.addEventListener("click",()=>{this.ask()})}task;show;button;place=f("div",{"aria-live":"polite"});async ask(){this.button.disabled=!0;let e=f("p",{class:"state"},"working …");this.place.prepend(e);try{this.place.replaceChildren(...this.show(await bf(this.task())))}catch(t){this.place.replaceChildren(At(t))}finally{e.remove(),this.button.disabled=!1}}};var H1=["time","sprung.z","sprung.az","unsprung.z","unsprung.az","strut.deflection","strut.force","tyre.force","road.z"];function W1(i){let e=(m,v,x="")=>{let E=document.createElementNS("http://www.w3.org/2000/svg",m);for(let[S,R]of Object.entries(v))E.setAttribute(S,String(R));return E.textContent=x,E},[t,n,s,r]=[520,300,62,34],a=m=>{let v=Math.min(0,...m.slice(0,1)),x=v;for(let E of m)v=Math.min(v,E),x=Math.max(x,E);return x>v?[v,x]:[v-1,x+1]},[o,l]=a(i.x),[c,h]=a(i.y),d=m=>s+(t-s-12)*(m-o)/(l-o),u=m=>n-r-(n-r-10)*(m-c)/(h-c),p=e("svg",{viewBox:`0 0 ${t} ${n}`,class:"xy",role:"img","aria-label":`force from ${Ee(c,3)} to ${Ee(h,3)} N over deflections from ${Ee(o,3)} to ${Ee(l,3)} mm`});p.append(e("path",{class:"axis",d:`M${s} 6V${n-r}H${t-8}`}),e("path",{class:"zero",d:`M${d(0)} 6V${n-r}M${s} ${u(0)}H${t-8}`}));for(let m of[o,l])p.append(e("text",{x:d(m),y:n-r+15,"text-anchor":m===o?"start":"end"},Ee(m,3)));for(let m of[c,h])p.append(e("text",{x:s-5,y:u(m)+5,"text-anchor":"end"},Ee(m,3)));p.append(e("text",{x:(s+t)/2,y:n-6,"text-anchor":"middle"},"deflection, compression positive [mm]"),e("text",{x:13,y:n/2,transform:`rotate(-90 13 ${n/2})`,"text-anchor":"middle"},"force, compression positive [N]"));let g="";i.x.forEach((m,v)=>{g+=`M${d(m).toFixed(1)} ${u(i.y[v]).toFixed(1)}h.01`}),p.append(e("path",{class:"dots",d:g}));let _=f("figure",{});return _.append(p,f("figcaption",{class:"muted"},`${i.count} samples as they would be read`)),_}var cl=class{constructor(e,t,n={}){this.file=e;this.form=t;Object.assign(this.fields,n,{columns:{...n.columns}});let s=(a,o)=>{let l=f("select",{},f("option",{value:""},"not stated"),...o.map(c=>f("option",c===this.fields[a]?{value:c,selected:!0}:{value:c},`positive in ${c}`)));return l.addEventListener("change",()=>{this.fields[a]=l.value,this.ask()}),l},r=(a,o)=>{let l=f("input",{type:"text",value:this.fields[a],placeholder:o});return l.addEventListener("change",()=>{this.fields[a]=l.value.trim(),this.ask()}),l};this.question=new za("Preview",()=>({kind:"preview",files:[this.file],form:this.form,...this.asked()}),a=>this.shown(a.result,a)),this.names.append(...H1.map(a=>f("option",{value:a}))),this.element.append(f("div",{class:"form"},Fe("Stroke",s("stroke_positive",["compression","extension"])),Fe("Force",s("force_positive",["compression","tension"])),...t==="recording"?[Fe("Sample time, where the file has none",r("sample_time","1 ms"))]:[],Fe("Variable or group (.mat, .tdms)",r("variable","")),this.question.button),f("details",{open:!0},f("summary",{},"Columns"),this.names,f("div",{class:"table",tabindex:"0",role:"region","aria-label":"columns"},f("table",{},f("thead",{},f("tr",{},...["column of the file","unit","from","to","read as","unit, where the file has none"].map(a=>f("th",{scope:"col"},a)))),this.mapping))),this.question.place)}file;form;element=f("div",{class:"reading"});fields={columns:{},variable:"",sample_time:"",stroke_positive:"",force_positive:""};mapping=f("tbody",{});names=f("datalist",{id:"channels-to-read"});question;known=[];asked(){let{columns:e,variable:t,sample_time:n,stroke_positive:s,force_positive:r}=this.fields;return{columns:e,variable:t,stroke_positive:s,force_positive:r,...this.form==="recording"?{sample_time:n}:{}}}ask(){return this.question.ask()}shown(e,t){JSON.stringify(e.columns)!==JSON.stringify(this.known)&&(this.known=e.columns,this.offer());let n=[];if(e.problem&&n.push(f("p",{class:"problem",role:"alert"},e.problem)),n.push(...e.findings.map(s=>f("p",{class:s.severity==="problem"?"problem":"muted"},`${s.severity}: ${s.message}`))),e.more&&n.push(f("p",{class:"muted"},`and ${e.more} more columns`)),e.points&&n.push(W1(e.points)),e.content){let s=f("div",{});n.push(s),ti.open(JSON.stringify(e.content)).then(r=>{let a=r.content.viewers[0];a&&s.replaceChildren(new sr(a,r).element)})}return[...n,rr(t)]}offer(){let e=Object.fromEntries(Object.entries(this.fields.columns).map(([t,n])=>[n.replace(/ \[[^\]]*\]$/,""),{name:t,unit:/\[([^\]]*)\]$/.exec(n)?.[1]??""}]));this.mapping.replaceChildren(...this.known.map(t=>{let n=e[t.name],s=this.form==="recording"?f("input",{type:"text",list:"channels-to-read",value:n?.name??"",placeholder:"as it is","aria-label":`what ${t.name} is read as`,size:"16"}):f("select",{"aria-label":`what ${t.name} is read as`},...["","displacement","force"].map(o=>f("option",o===(n?.name??"")?{value:o,selected:!0}:{value:o},o||"as it is"))),r=f("input",{type:"text",value:n?.unit??"",placeholder:t.unit||"e.g. mm","aria-label":`unit of ${t.name}`,size:"8"}),a=()=>{for(let[o,l]of Object.entries(this.fields.columns))l.replace(/ \[[^\]]*\]$/,"")===t.name&&delete this.fields.columns[o];s.value&&(this.fields.columns[s.value]=r.value.trim()?`${t.name} [${r.value.trim()}]`:t.name),this.ask()};return s.addEventListener("change",a),r.addEventListener("change",a),f("tr",{},f("th",{scope:"row"},t.name),f("td",{},t.unit||"–"),f("td",{class:"right"},Ee(t.least)),f("td",{class:"right"},Ee(t.greatest)),f("td",{},s),f("td",{},r))}))}};var ar=["rig"],ft=(i,e={})=>`#/${i}?${new URLSearchParams(e)}`,Mf=null;function or(i){Mf=i}async function lr(i,e,t,n,s=!1,r=ar,a={}){let{entries:o}=await ei(),l=[...o.filter(c=>r.includes(c.kind)).map(c=>c.path),...s?(await ks()).map(c=>c.name):[]];i.replaceChildren(f("h1",{},t),l.length?f("ul",{},...l.map(c=>f("li",{},f("a",{href:ft(e,{[n]:c,...a})},c)))):f("p",{class:"empty"},r===ar?H("No rig lies here yet: "):H("Nothing of that kind lies here yet: "),f("a",{href:ft("project")},H("to the project")),"."))}var F0={label:"Campaign",show:X1};async function X1(i,e){let t=e.get("job"),n=e.get("file");if(t){await j1(i,t);return}if(n){await $1(i,n,e.get("read")??"");return}let{entries:s}=await ei(),r=s.filter(h=>h.kind==="campaign"),a=f("input",{type:"text",value:"campaign",spellcheck:"false"}),o=f("div",{"aria-live":"polite"}),l=f("button",{type:"submit",class:"main"},"Start from it"),c=f("form",{class:"form"},Fe("Folder",a),l);c.addEventListener("submit",h=>{h.preventDefault(),l.disabled=!0,bf({kind:"new-campaign",out:a.value}).then(()=>{location.hash=ft("campaign",{file:`${a.value}/campaign.toml`})},d=>{o.replaceChildren(At(d)),l.disabled=!1})}),i.replaceChildren(f("h1",{},"Campaigns"),f("p",{class:"muted"},"From measurements of springs, tyres, decays and trials to a model that holds: characterised, updated, compared with every trial."),r.length?f("ul",{class:"files"},...r.map(h=>f("li",{},f("a",{href:ft("campaign",{file:h.path})},h.path)))):f("p",{class:"empty"},"No campaign lies here yet. Start from the one below, and put your own measurements in."),f("h2",{},"Runs"),Va(["campaign"],h=>{location.hash=ft("campaign",{job:h.id})},"No campaign was run here yet."),f("h2",{},"A campaign to start from"),f("p",{class:"muted"},"It runs as it is, with synthetic recordings."),c,o)}async function $1(i,e,t){let n=await _n(`/api/campaign?${Qn({path:e})}`),s=e.includes("/")?e.slice(0,e.lastIndexOf("/")):"",r=_=>s?`${s}/${_}`:_,a=f("input",{type:"text",value:r("results"),spellcheck:"false"}),o=f("input",{type:"checkbox"}),l=f("div",{"aria-live":"polite"}),c=f("button",{type:"button",class:"main"},"Run the campaign");c.addEventListener("click",()=>{al({kind:"campaign",campaign:e,out:a.value,force:o.checked}).then(_=>{location.hash=ft("campaign",{job:_.id})},_=>l.replaceChildren(At(_)))});let h=f("button",{type:"button"},"Check it");h.addEventListener("click",()=>{jf(e).then(({problems:_,notes:m})=>l.replaceChildren(..._.length?_.map(At):[f("p",{class:"good"},"Nothing is wrong with it.")],...m.map(v=>f("p",{class:"muted"},v))),_=>l.replaceChildren(At(_)))});let d=f("div",{}),u=(_,m,v={})=>{d.replaceChildren(Z1(e,_,m,v,n)),d.scrollIntoView({block:"start"})},p=(_,m,v={})=>{let x=f("button",{type:"button","aria-label":`look at ${_}`},_.split("/").pop());return x.addEventListener("click",()=>u(_,m,v)),x},g=f("input",{type:"text",value:r("measured"),spellcheck:"false"});i.replaceChildren(f("h1",{},n.title),f("p",{class:"muted"},f("a",{href:ft("campaign")},"All campaigns"),` · ${e} · rig ${n.rig}`),...n.synthetic?[f("p",{class:"mark fair"},n.synthetic)]:[],f("div",{class:"form"},Fe("Folder of the results",a),f("label",{class:"field"},f("span",{},"Replace what is there"),o),h,c),l,f("h2",{},"Parts"),...n.bench.length?n.bench.map(_=>q1(_,n,p)):[f("p",{class:"empty"},"Nothing was measured of the parts: the rig is taken as its file says.")],f("h2",{},"Trials"),cr("trials",["number","use","road","speed","tyre pressure","recording"],n.trials.map(_=>[String(_.number),String(_.use??"hold-out"),String(_.road??"measured support"),String(_.speed??"–"),String(_.tyre_pressure??"–"),_.file?p(String(_.file),"recording",_):f("span",{class:"mark bad"},`${String(_.recording)} is missing`)])),f("h2",{},"Updates"),n.updates.length?cr("updates",["name","free","trials","method"],n.updates.map(_=>[String(_.name),Object.entries(_.free).map(([m,v])=>`${m}: ${typeof v=="string"?v:JSON.stringify(v)}`).join(", "),JSON.stringify(_.trials??"fit").replaceAll('"',""),String(_.method??"least-squares")])):f("p",{class:"empty"},"Nothing is updated: the campaign compares the characterised model with the trials."),f("h2",{},"Measurements"),f("div",{class:"form"},Fe("Folder they go to",g)),U0(()=>g.value,"Drop measured files here, or choose them (up to 250 MB each).",_=>u(_[0],"recording")),d),t&&u(t,"recording")}function cr(i,e,t,n=[]){let s=r=>n.includes(r)?{class:"right"}:{};return f("div",{class:"table",tabindex:"0",role:"region","aria-label":i},f("table",{},f("thead",{},f("tr",{},...e.map((r,a)=>f("th",{scope:"col",...s(a)},r)))),f("tbody",{},...t.map(r=>f("tr",{},...r.map((a,o)=>o?f("td",s(o),a):f("th",{scope:"row"},a)))))))}function q1(i,e,t){let n=i.name==="decay",s=n?"recording":"force-deflection",r=g=>f("input",{type:"text",value:g}),a=r(i.discard_below??""),o=f("select",{},...["linear","polynomial","power","monotone-spline"].map(g=>f("option",g===i.law?{value:g,selected:!0}:{value:g},g))),l=f("select",{},...["drop","shift","keep"].map(g=>f("option",g===i.intercept?{value:g,selected:!0}:{value:g},g))),c=r(e.mass),h=r(i.from??""),d=r(i.to??""),u={files:i.found,columns:i.columns??{},variable:i.variable??"",stroke_positive:i.stroke_positive??""},p=new za(n?"Separate damping and friction":"Fit the stiffness",()=>n?{kind:"decay",...u,channel:i.channel??"sprung.z",mass:c.value,begin:h.value,end:d.value,sample_time:i.sample_time??""}:{kind:"stiffness",...u,force_positive:i.force_positive??"",law:o.value,discard_below:a.value,intercept:l.value,branch:i.branch??"loading"},g=>[Y1(g.result),ll(g.report,n?"Decay and its bend by friction":"Fit, with the discarded zone"),rr(g)]);return f("section",{class:"job"},f("h3",{},i.name),i.found.length?f("p",{class:"bar"},"measured: ",...i.found.map(g=>t(g,s,i))):f("p",{class:"problem"},`no file is found for ${i.files.join(", ")}`),f("div",{class:"form"},...n?[Fe("Oscillating mass",c),Fe("From",h),Fe("To",d)]:[Fe("Law",o),Fe("Ignore smaller deflections",a),Fe("Force at zero",l)],p.button),p.place)}var O0={stiffness:"N/m",intercept:"N",damping_ratio:"1",damping_coefficient:"N·s/m",coulomb_force:"N",quadratic_drag:"N·s²/m²",natural_frequency_hz:"Hz",equilibrium:"m"};function Y1(i){let e=Object.entries(i).flatMap(([n,s])=>{let r=s;return r&&typeof r=="object"&&typeof r.value=="number"&&n in O0?[[n.replaceAll("_"," ").replace(" hz",""),Ee(r.value),r.interval?`${Ee(r.interval[0])} … ${Ee(r.interval[1])}`:"–",O0[n]]]:[]}),t=i.findings??[];return f("div",{},cr("estimates",["quantity","value","95 % interval","unit"],e,[1,2]),...t.map(n=>f("p",{class:"muted"},`${n.severity}: ${n.message}`)))}function Z1(i,e,t,n,s){let r=f("div",{}),a=f("div",{"aria-live":"polite"}),o=new cl(e,t,n),c=f("select",{},...[["trial","a trial"],["decay","a free decay"],["spring","the spring"],["tyre","a tyre at a pressure"]].map(([w,y])=>f("option",t==="force-deflection"==(w==="spring")&&(w==="trial"||w==="spring")?{value:w,selected:!0}:{value:w},y))),h=(w,y="")=>f("input",{type:"text",value:w,placeholder:y}),d=h("2 m/s"),u=h("","0.31 MPa"),p=f("select",{},...s.roads.map(w=>f("option",{value:w},w)),f("option",{value:""},"none: the support is measured")),g=h("","its file, with road.z"),_=f("select",{},f("option",{value:"undeformed"},"undeformed springs and tyre"),f("option",{value:"rest"},"the wheel at rest on it")),m=f("select",{},f("option",{value:"hold-out"},"judges only (hold-out)"),f("option",{value:"fit"},"is fitted")),v=f("input",{type:"checkbox"}),x=h("","2 mm"),E=f("span",{class:"sizes"}),S=()=>{let w=c.value==="spring"||c.value==="tyre"?"force-deflection":"recording";w!==o.form&&(o=new cl(e,w,o.fields),r.replaceChildren(o.element),o.ask()),E.replaceChildren(...c.value==="trial"?[Fe("Road",p),...p.value?[Fe("Speed",d)]:[Fe("File of the support",g),Fe("Its height counts from",_)],Fe("Tyre pressure",u),Fe("Use",m)]:c.value==="decay"?[Fe("In place of the files there",v)]:[Fe("In place of the files there",v),...c.value==="tyre"?[Fe("Pressure",u)]:[],Fe("Ignore smaller deflections",x)])};c.addEventListener("change",S),p.addEventListener("change",S);let R=f("button",{type:"button",class:"main"},"Enter it into the campaign");return R.addEventListener("click",()=>{let{columns:w,variable:y,sample_time:A,stroke_positive:k,force_positive:U}=o.fields,D={columns:w,variable:y,stroke_positive:k,...c.value==="decay"?{}:{force_positive:U},...o.form==="recording"?{sample_time:A}:{}},L=c.value==="trial"?{recording:e,...p.value?{road:p.value,speed:d.value}:{excitation:{file:g.value,datum:_.value}},tyre_pressure:u.value,use:m.value,...D}:{files:[e],replace:v.checked,...c.value==="tyre"?{pressure:u.value}:{},...c.value==="decay"?{}:{discard_below:x.value},...D};R.disabled=!0,On("POST","/api/campaign",{campaign:i,use:c.value,fields:L}).then(()=>{location.hash=ft("campaign",{file:i,entered:String(Date.now())})},F=>{a.replaceChildren(At(F)),R.disabled=!1})}),r.append(o.element),S(),o.ask(),f("section",{class:"job"},f("h3",{},e),r,f("div",{class:"form"},Fe("It is a measurement of",c),E,R),a)}var J1={holds:"good","holds partly":"fair"},K1=i=>J1[i]??(/not|fail/.test(i)?"bad":"fair");async function j1(i,e){let t=await ol(e),n=await tE(String(t.asked.campaign)),s=f("div",{}),r=f("div",{}),a=new rl(t),o=!1;i.replaceChildren(f("h1",{},t.title),f("p",{class:"muted"},f("a",{href:ft("campaign")},"All campaigns")," · ",f("a",{href:ft("campaign",{file:String(t.asked.campaign)})},String(t.asked.campaign))),a.element,r,s);let l=async c=>{if(a.show(c),c.steps?.length&&r.replaceChildren(Q1(c.steps,c.state==="running",n)),c.state!=="done"||o)return;o=!0;let h=await ol(e);h.result&&s.replaceChildren(...eE(h.result,n),...h.has_page?[ll(`/api/jobs/${e}/report`,"Report")]:[])};await l(t),Sf(i,c=>{let h=c.find(d=>d.id===e);h&&l(h)})}function Q1(i,e,t){let n=i[i.length-1],s=i.map(p=>Math.log10(Math.max(p.objective,1e-300))),r=Math.min(...s),a=Math.max(...s,r+1e-9),o=460,l=150,c=document.createElementNS("http://www.w3.org/2000/svg","svg"),h=document.createElementNS("http://www.w3.org/2000/svg","path");c.setAttribute("viewBox",`0 0 ${o} ${l}`),c.setAttribute("class","xy"),c.setAttribute("role","img"),c.setAttribute("aria-label",`objective from ${Ee(i[0].objective,4)} to ${Ee(n.objective,4)} in ${i.length} evaluations`),h.setAttribute("d",s.map((p,g)=>`${g?"L":"M"}${(8+(o-16)*g/Math.max(1,s.length-1)).toFixed(1)} ${(8+(l-16)*(a-p)/(a-r)).toFixed(1)}`).join("")),h.setAttribute("class","search"),c.append(h);let d=f("figure",{});d.append(c,f("figcaption",{class:"muted"},`objective, logarithmic: ${Ee(i[0].objective,4)} at first, ${Ee(n.objective,4)} after ${n.evaluation} evaluations`));let u=Object.entries(n.parameters).map(([p,g])=>{let _=(g.value-g.lower)/(g.upper-g.lower||1),{unit:m,factor:v}=t(p);return f("tr",{},f("th",{scope:"row"},p),f("td",{},m),f("td",{class:"right"},Ee(g.lower*v)),f("td",{},f("meter",{min:"0",max:"1",value:String(Math.min(1,Math.max(0,_))),"aria-label":`${p} between its bounds`})),f("td",{class:"right"},Ee(g.upper*v)),f("td",{class:"right"},Ee(g.initial*v)),f("td",{class:"right"},Ee(g.value*v,5)),f("td",{},_<.001||_>.999?f("span",{class:"mark fair"},"at its bound"):""))});return f("section",{class:"job"},f("h3",{},e?"The search goes on":"The last search"),d,f("div",{class:"table",tabindex:"0",role:"region","aria-label":"parameters"},f("table",{},f("thead",{},f("tr",{},...["parameter","unit","lower bound","","upper bound","at first","now",""].map((p,g)=>f("th",{scope:"col",...[2,4,5,6].includes(g)?{class:"right"}:{}},p)))),f("tbody",{},...u))))}function eE(i,e){let t=r=>{let a=Object.values(r?.channels??{}).map(o=>o.nrmse).filter(o=>o!==null);return a.length?a.reduce((o,l)=>o+l)/a.length:null},n=[];i.synthetic&&n.push(f("p",{class:"mark fair"},i.synthetic)),n.push(f("h2",{},"Verdicts"),cr("verdicts",["trial","use","speed [m/s]","error of the channels (NRMSE)","verdict"],i.trials.map(r=>[String(r.number),r.use,Ee(r.speed),Object.entries(r.channels).map(([a,o])=>`${a} ${Ee(o.nrmse,3)}`).join(", "),f("span",{class:`mark ${K1(r.verdict)}`},r.verdict)]))),i.characterisation.replaced.length&&n.push(f("h2",{},"Characterised"),cr("characterised",["number","unit","in the rig's file","measured","95 % ±","from"],i.characterisation.replaced.map(r=>{let{unit:a,factor:o}=e(r.path);return[r.path,a,Ee(r.described*o),Ee(r.measured*o),r.standard_error===null?"–":Ee(1.96*r.standard_error*o,2),r.source]}),[2,3,4]));for(let r of i.updates)n.push(f("h2",{},`Update: ${r.name}`),f("p",{},`The objective fell by ${Ee(r.reduction_percent,3)} %, from ${Ee(r.objective_before)} to ${Ee(r.objective_after)}, in ${r.evaluations} evaluations on trial ${r.trials.join(", ")}.`),cr("parameters",["parameter","unit","at first","value","95 % interval, noise only","bounds","known"],Object.entries(r.parameters).map(([a,o])=>{let l=r.discrepancy?.parameters[a],{unit:c,factor:h}=e(a);return[a,c,Ee(o.initial*h),Ee(o.value*h,5),o.interval?`${Ee(o.interval[0]*h)} … ${Ee(o.interval[1]*h)}`:"–",`${Ee(o.lower*h)} … ${Ee(o.upper*h)}`,o.at_bound?f("span",{class:"mark fair"},"at its bound"):l?.why?f("span",{class:"mark bad"},`not identified: ${l.why}`):l?f("span",{class:"mark good"},"identified"):"–"]}),[2,3,4,5]),f("h3",{},"What the data can tell"),f("p",{class:"muted"},`${r.identifiability.rank} of ${r.identifiability.parameters.length} directions are told apart; the condition is ${Ee(r.identifiability.condition,3)}.`),cr("identifiability",["unknown","sensitivity","most alike"],r.identifiability.parameters.map((a,o)=>{let l=r.identifiability.correlation[o]??[],c=l.reduce((h,d,u)=>u!==o&&Math.abs(d)>Math.abs(h<0?0:l[h])?u:h,-1);return[a,Ee(r.identifiability.sensitivity[o],3),c>=0?`${r.identifiability.parameters[c]} (${Ee(l[c],2)})`:"–"]}),[1]),...r.identifiability.findings.map(a=>f("p",{class:"muted"},`${a.place}: ${a.message}`)));let s=[...new Set(i.updates.flatMap(r=>r.comparisons.map(a=>a.number)))];return s.length&&n.push(f("h2",{},"Every update on every trial"),f("p",{class:"muted"},"Mean error of the channels (NRMSE) before and after each update; trials it was fitted on are marked."),cr("every update on every trial",["update",...s.map(r=>`trial ${r}`)],i.updates.map(r=>[r.name,...s.map(a=>{let o=r.comparisons.find(l=>l.number===a);return o?`${Ee(t(o.before),3)} → ${Ee(t(o.after),3)}${o.is_fitted?", fitted":""}${o.after?.verdict?`: ${o.after.verdict}`:""}`:"–"})]))),i.findings.length&&n.push(f("h2",{},"What to be careful about"),f("ul",{},...i.findings.map(r=>f("li",{class:r.severity==="problem"?"problem":""},`${r.place}: ${r.message}`)))),n}async function tE(i){let e=new Map;try{let{rig:t}=await _n(`/api/campaign?${Qn({path:i})}`),n=i.includes("/")?`${i.slice(0,i.lastIndexOf("/"))}/`:"";for(let s of(await Bs(t.endsWith(".toml")?n+t:t)).numbers)e.set(s.path,{unit:s.unit||"–",factor:s.factor})}catch{}return t=>e.get(t)??{unit:"SI",factor:1}}var k0={label:"Jobs",show:sE},nE={sweep:"studies",campaign:"campaign",compare:"ride",pareto:"ride",design:"kinematics",evaluate:"inspection"};function iE(i){let e=nE[i.kind];e&&e!=="kinematics"?location.hash=ft(e,{job:i.id}):window.open(`/api/jobs/${encodeURIComponent(i.id)}/report`,"_blank","noopener")}async function sE(i){i.replaceChildren(f("h1",{},"Jobs"),f("p",{class:"muted"},"Long work goes on when this page is closed, and when the server is ended: it is found again here."),Va(null,iE,"No long work was begun here yet. Studies, campaigns, rides and designs begin it."))}var rE=i=>_n(`/api/jobs/${encodeURIComponent(i)}`);function B0(i,e,t,n,s){let r=[...new Set(e.numbers.map(({path:g})=>/^(hardpoints\.\w+)\[/.exec(g)?.[1]).filter(g=>!!g&&!g.endsWith("wheel_centre")))],a=r.map(g=>f("input",{type:"checkbox",value:g,checked:/tie_rod|link_5/.test(g)})),o=f("input",{type:"text",value:"15 mm"}),l=f("input",{type:"number",min:"1",max:"100",value:"4"}),c=f("div",{"aria-live":"polite"}),h=f("button",{type:"submit",class:"main"},H("Search")),d=f("form",{},f("fieldset",{class:"free"},f("legend",{},H("Hardpoints that may move")),...a.map((g,_)=>f("label",{},g,` ${r[_].replace("hardpoints.","").replaceAll("_"," ")}`))),f("div",{class:"form"},Fe(H("Each coordinate by up to"),o),Fe(H("Searches"),l),h));d.addEventListener("submit",g=>{g.preventDefault();let _=a.filter(m=>m.checked).map(m=>m.value);if(!t.length||!_.length){c.replaceChildren(f("p",{class:"muted"},H("Add a target above, and choose a hardpoint that may move.")));return}h.disabled=!0,u(_).catch(m=>c.replaceChildren(At(m))).finally(()=>{h.disabled=!1})});async function u(g){let _=i.replace(/\.toml$/,"").replaceAll("/","-"),m=new Date().toISOString().replace(/\D/g,"").slice(2,14),v=`designs/${_}-${m}.toml`,x=D=>JSON.stringify(D),E=await Zr(i),S=await Ki(i,E.text,[],n.changes),R=`designs/${_}-${m}-start.toml`;await fr(R,S.text,"");let w=['schema = "jounce.design/1"',`rig = ${x(`${_}-${m}-start.toml`)}`,`starts = ${Number(l.value)||4}`,"",...g.flatMap(D=>["[[free]]",`point = ${x(D)}`,`within = ${x(o.value)}`,""]),...t.flatMap(D=>["[[target]]",...Object.entries(D).map(([L,F])=>`${L} = ${x(String(F))}`),""])].join(`
`);await fr(v,w,"");let y=await(await On("POST","/api/jobs",{kind:"design",study:v,out:`designs/${_}-${m}`})).json(),A=f("progress",{max:"1","aria-label":H("share done")}),k=f("span",{}),U=f("button",{type:"button"},H("Cancel"));for(U.addEventListener("click",()=>{On("POST",`/api/jobs/${encodeURIComponent(y.id)}/cancel`,{})}),c.replaceChildren(f("p",{class:"bar"},A,k,U));;){let D=await rE(y.id);if(!c.isConnected)return;if(D.share===null?A.removeAttribute("value"):A.value=D.share,k.textContent=[D.said,`${Ee(Date.now()/1e3-D.begun,2)} s`,D.left?H("# s left",Ee(D.left,2)):""].filter(Boolean).join(", "),D.state==="done"){p(D);return}if(!["running","cancelling"].includes(D.state)){c.replaceChildren(At(new Error(D.error??H("The search was ended."))));return}await new Promise(L=>setTimeout(L,400))}}function p(g){let _=g.result,m=f("button",{type:"button",class:"main"},H("Take this design"));m.addEventListener("click",()=>s(Object.fromEntries(Object.entries(_.moved).map(([x,E])=>[x,E.after]))));let v=new Map(e.numbers.map(x=>[x.path,x]));c.replaceChildren(f("p",{class:_.met?"good":"problem"},_.met?H("Every target is met."):H("# of the targets are missed.",String(_.targets.filter(x=>!x.met).length))),f("div",{class:"table",tabindex:"0",role:"region","aria-label":H("searches")},f("table",{},f("thead",{},f("tr",{},...[H("search"),H("targets"),H("cost, tolerances²"),H("moved, share of the boxes"),H("ended")].map(x=>f("th",{scope:"col"},x)))),f("tbody",{},..._.starts.map(x=>f("tr",{},f("th",{scope:"row"},String(x.start)),f("td",{},x.met?H("met"):H("missed")),f("td",{class:"right"},Ee(x.cost,3)),f("td",{class:"right"},Ee(x.travelled,2)),f("td",{},x.ended)))))),f("div",{class:"table",tabindex:"0",role:"region","aria-label":H("what was moved")},f("table",{},f("thead",{},f("tr",{},...[H("number"),H("before"),H("after"),H("unit")].map(x=>f("th",{scope:"col"},x)))),f("tbody",{},...Object.entries(_.moved).map(([x,E])=>{let S=v.get(x),R=S?.factor??1;return f("tr",{},f("th",{scope:"row"},x),f("td",{class:"right"},Ee(E.before*R,5)),f("td",{class:"right"},Ee(E.after*R,5)),f("td",{},S?.unit??""))})))),f("p",{class:"bar"},m,f("a",{href:`/api/jobs/${g.id}/report`,target:"_blank"},H("Its report"))))}return f("div",{},d,c)}var Ls=46,hl=8,z0=6,aE=16,$h=104,qh=class{constructor(e){this.moved=e;new ResizeObserver(()=>this.sized()).observe(this.element),$n(()=>{this.colours={},this.draw()})}moved;element=f("div",{class:"multiples"});plots=[];x=[];kind="";wanted="";width=0;place=0;colours={};show(e,t,n){let s=e.scenes[0],r=s.panes.filter(o=>!o.name.startsWith("Δ"));this.x=t.get(s.x);let a=JSON.stringify([r.map(o=>[o.name,o.unit])]);a!==this.kind&&(this.kind=a,this.plots=r.map(o=>this.made(o.name,o.words,o.unit)),this.element.replaceChildren(...this.plots.map(o=>o.box)),this.filter(this.wanted)),r.forEach((o,l)=>{let c=this.plots[l];c.lines=o.curves.map(({role:h,y:d})=>({role:h,y:t.get(d)})),c.band=n.find(h=>h.quantity===o.name)??null,c.box.classList.toggle("wanted",c.band!==null)}),this.width?this.draw():this.sized(),this.mark(this.place)}filter(e){this.wanted=e;let t=e.toLowerCase().split(/\s+/).filter(Boolean);for(let n of this.plots)n.box.hidden=!t.every(s=>n.box.dataset.words.includes(s));this.draw()}mark(e){this.place=e;let[t,n]=this.ends(),s=n>t?(e-t)/(n-t):0,r=Ls+Math.min(Math.max(s,0),1)*(this.width-Ls-hl);for(let a of this.plots){if(a.box.hidden)continue;a.mark.style.transform=`translateX(${r}px)`;let o=a.lines[0];a.value.textContent=o?Ee(wi(this.x,o.y,e),4):"–"}}ends(){return this.x.length?[this.x[0],this.x[this.x.length-1]]:[0,1]}made(e,t,n){let s=f("canvas",{"aria-hidden":"true"}),r=f("output",{},"–"),a=f("i",{class:"at"}),o=f("span",{class:"verdict"}),l=f("div",{class:"holder"},s,a);l.addEventListener("pointermove",h=>{let[d,u]=this.ends(),p=l.getBoundingClientRect();this.moved(d+Math.min(Math.max((h.clientX-p.left-Ls)/(p.width-Ls-hl),0),1)*(u-d))});let c=f("figure",{"data-words":`${e} ${t}`.toLowerCase().replaceAll("_"," ")},f("figcaption",{title:t},f("b",{},e.replaceAll("_"," "))," ",r,f("span",{class:"unit"},` ${n||"–"}`),o),l);return{name:e,lines:[],band:null,canvas:s,value:r,mark:a,box:c,verdict:o}}sized(){let e=this.plots.find(n=>!n.box.hidden),t=e?Math.floor(e.box.clientWidth):0;if(!(t<60)){this.width=t;for(let{canvas:n}of this.plots)n.width=t,n.height=$h;this.draw(),this.mark(this.place)}}ink(e){return this.colours[e]??=yt(e)}draw(){if(this.width)for(let e of this.plots)e.box.hidden||this.drawn(e)}drawn(e){let t=e.canvas.getContext("2d",{willReadFrequently:!0}),{x:n,width:s}=this,[r,a]=this.ends(),o=1/0,l=-1/0,c=g=>{g!==null&&Number.isFinite(g)&&(g<o&&(o=g),g>l&&(l=g))};for(let{y:g}of e.lines)for(let _=0;_<g.length;_++)c(g[_]);e.band?.low.forEach(c),e.band?.high.forEach(c),l>=o||([o,l]=[-1,1]);let h=1e-6*Math.max(Math.abs(o),Math.abs(l))||1e-9,d=l-o>h?.08*(l-o):.1*Math.abs(l)||1;o-=d,l+=d;let u=g=>Ls+(g-r)/(a-r||1)*(s-Ls-hl),p=g=>z0+(l-g)/(l-o)*($h-z0-aE);t.clearRect(0,0,s,$h),t.font="11px system-ui, sans-serif",t.lineWidth=1,t.strokeStyle=this.ink("line"),t.fillStyle=this.ink("muted"),t.textAlign="right",t.textBaseline="middle";for(let g of ul(o,l,3)){let _=Math.round(p(g))+.5;t.beginPath(),t.moveTo(Ls,_),t.lineTo(s-hl,_),t.stroke(),t.fillText(dl(g),Ls-5,_)}t.textBaseline="alphabetic",t.textAlign="center";for(let g of ul(r,a,3))t.fillText(dl(g),Math.min(Math.max(u(g),Ls+8),s-hl-8),$h-4);e.band?this.band(t,e,u,p,o,l):e.verdict.textContent="";for(let g=e.lines.length-1;g>=0;g--){let{role:_,y:m}=e.lines[g];t.strokeStyle=this.ink(_),t.lineWidth=g?1.25:2,t.setLineDash(g?[5,3]:[]),t.beginPath();let v=!1;for(let x=0;x<n.length;x++){let E=m[x];if(E==null||!Number.isFinite(E)){v=!1;continue}v?t.lineTo(u(n[x]),p(E)):t.moveTo(u(n[x]),p(E)),v=!0}t.stroke()}t.setLineDash([])}band(e,t,n,s,r,a){let o=t.band,l=o.at.length>1?0:4;e.fillStyle=this.ink("span"),e.strokeStyle=this.ink("other-1"),e.beginPath();let c=[...o.at.map((u,p)=>[n(u),s(o.high[p]??a)]),...o.at.map((u,p)=>[n(u),s(o.low[p]??r)]).reverse()];l?e.rect(c[0][0]-l,c[0][1],2*l,c[1][1]-c[0][1]):(c.forEach(([u,p],g)=>{g?e.lineTo(u,p):e.moveTo(u,p)}),e.closePath()),e.fill(),e.stroke();let h=t.lines[0]?.y,d=!!h&&o.at.every((u,p)=>{let g=wi(this.x,h,u);return g>=(o.low[p]??-1/0)-1e-9&&g<=(o.high[p]??1/0)+1e-9});t.verdict.textContent=d?" ✓":" ✗",t.verdict.className=`verdict ${d?"good":"missed"}`,t.verdict.title=d?"within the tolerance":"outside of the tolerance"}};function ul(i,e,t){let n=(e-i)/t,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(o=>o*s).find(o=>o>=n),a=[];for(let o=Math.ceil(i/r);o*r<=e+1e-9*r;o++)a.push(o*r);return a}function dl(i){let e=Number(i.toPrecision(4));return us(Math.abs(e)>=1e5||e!==0&&Math.abs(e)<.001?e.toExponential(0):String(e))}var V0=.001,Ga=class{constructor(e,t){this.view=e;this.moved=t;let n=f("select",{},...[["view",H("in the plane of the picture")],["x",H("along x")],["y",H("along y")],["z",H("along z")]].map(([s,r])=>f("option",{value:s},r)));n.addEventListener("change",()=>{e.way=n.value}),e.grabbed=(s,r,a)=>this.drag(s,r,a),this.choice.addEventListener("change",()=>this.choose(this.choice.value)),this.inputs.forEach(s=>{s.addEventListener("change",()=>{let r=this.inputs.map(a=>Number(a.value));this.inputs.some(a=>a.value==="")||!r.every(Number.isFinite)||this.put(this.choice.value,r,!0)})}),this.element.append(Fe(H("Hardpoint"),this.choice),...this.inputs.map((s,r)=>Fe(`${"xyz"[r]} [mm]`,s)),Fe(H("Dragged"),n),Fe(H("Snaps to"),this.snap))}view;moved;element=f("div",{class:"points form"});choice=f("select",{"aria-label":H("Hardpoint")});inputs=["x","y","z"].map(e=>f("input",{type:"number",step:"any","aria-label":`${e} [mm]`}));snap=f("select",{},...["0.1","0.5","1","5","10"].map(e=>f("option",{value:e,...e==="1"?{selected:!0}:{}},`${e} mm`)));places=new Map;from=null;set(e){let t=new Map;for(let{path:n,value:s}of e){let r=/^hardpoints\.(\w+)\[([012])\]$/.exec(n);if(!r)continue;let a=t.get(r[1])??[0,0,0];a[Number(r[2])]=s/V0,t.set(r[1],a)}[...t.keys()].join()!==[...this.places.keys()].join()&&this.choice.replaceChildren(...[...t.keys()].map(n=>f("option",{value:n},n.replaceAll("_"," ")))),this.places=t,this.write()}choose(e){this.choice.value=e,this.view.choose(e),this.write()}drag(e,t,n){let s=this.places.get(e);if(!s)return;(this.from===null||this.choice.value!==e)&&(this.from=[...s],this.choose(e));let r=Math.hypot(...t),a=Number(this.snap.value),l=this.from.map((c,h)=>Math.abs(t[h])>.02*r?Math.round((c+t[h])/a)*a:c);n&&(this.from=null),(r>0||n)&&this.put(e,l,n)}put(e,t,n){let s=this.places.get(e),r={};t.forEach((a,o)=>{(n||Math.abs(a-s[o])>1e-9)&&(r[`hardpoints.${e}[${o}]`]=Number((a*V0).toPrecision(12)))}),this.places.set(e,t),this.write(),Object.keys(r).length&&this.moved(r,n)}write(){let e=this.places.get(this.choice.value);this.inputs.forEach((t,n)=>{document.activeElement!==t&&(t.value=e?String(Number(e[n].toFixed(4))):"")})}};var G0={label:"Kinematics",show:oE},fl=class{constructor(e,t,n,s,r,a){this.name=e;this.words=t;this.unit=n;this.range.value=`${-s} ${n}:${s} ${n}:${r} ${n}`,this.slider.min=String(-s),this.slider.max=String(s),this.slider.value="0",this.slider.setAttribute("aria-label",`${t} [${n}]`),this.number.setAttribute("aria-label",`${t} [${n}], ${H("typed")}`),this.range.setAttribute("aria-label",`${t}: ${H("first:last:step")}`),this.slider.addEventListener("input",()=>{this.number.value=String(Number(Number(this.slider.value).toPrecision(4))),a(!1)}),this.number.addEventListener("input",()=>{this.number.value!==""&&(this.slider.value=this.number.value,a(!1))}),this.range.addEventListener("change",()=>{let[o,l]=this.range.value.split(":").map(c=>parseFloat(c));Number.isFinite(o)&&Number.isFinite(l)&&(this.slider.min=String(o),this.slider.max=String(l)),a(!0)}),this.element=f("div",{class:"slider drive"},f("span",{class:"name"},t),this.slider,this.number,f("span",{class:"unit"},n),this.range)}name;words;unit;slider=f("input",{type:"range",step:"any"});number=f("input",{type:"number",step:"any",value:"0"});range=f("input",{type:"text",spellcheck:"false"});element;get value(){return Number(this.number.value)||0}set value(e){this.slider.value=String(e),this.number.value=String(Number(e.toPrecision(4)))}swept(e,t){this.range.hidden=!e,this.slider.disabled=this.number.disabled=!t,this.element.classList.toggle("unused",!t)}};async function oE(i,e){let t=e.get("rig");if(!t){await lr(i,"kinematics",H("Kinematics"),"rig",!0);return}let[n,{entries:s},r]=await Promise.all([Bs(t),ei(),ks()]);if(!n.spatial){i.replaceChildren(f("h1",{},t),f("p",{class:"empty"},H("This rig has no hardpoints, and so no kinematics: "),f("a",{href:ft("kinematics")},H("choose another one")),"."));return}let a=t.endsWith(".toml"),o=n.numbers.some(ae=>ae.path==="wheel.radius"&&ae.value<.18),l=n.numbers.some(ae=>/^hardpoints\.(tie_rod|link_5)_inner\[0\]$/.test(ae.path)),c=o?20:50,h=new Ps,d=[];or({times:d});let u=f("p",{class:"state",role:"status"}),p=f("div",{}),g=f("div",{class:"ways"}),_=f("select",{},...[["travel",H("wheel travel")],...l?[["rack",H("rack travel")]]:[],["roll",H("roll of the body")]].map(([ae,Xe])=>f("option",{value:ae},Xe))),m=(ae,Xe)=>{Xe===_.value&&!ae?P():Q()},v={travel:new fl("travel",H("Wheel travel, bump positive"),"mm",c,c/10,ae=>m(ae,"travel")),rack:new fl("rack",H("Rack travel, to the left positive"),"mm",o?10:20,o?1:2,ae=>m(ae,"rack")),roll:new fl("roll",H("Roll, left side up positive"),"deg",4,.5,ae=>m(ae,"roll"))},x=()=>{let ae=_.value;v.travel.swept(ae==="travel",ae!=="roll"),v.rack.swept(ae==="rack",l),v.roll.swept(ae==="roll",ae==="roll")};_.addEventListener("change",()=>{x(),Q()});let E=s.filter(ae=>ar.includes(ae.kind)&&ae.path!==t).map(ae=>ae.path),S=a?await Kf(t):[],R=f("select",{},f("option",{value:""},H("nothing else")),...S.length?[f("optgroup",{label:H("earlier versions")},...S.map(ae=>f("option",{value:ae.name},`${H("replaced")} ${new Date(ae.replaced*1e3).toISOString().slice(0,16).replace("T"," ")} UTC`)))]:[],...E.length?[f("optgroup",{label:H("this project")},...E.map(ae=>f("option",{value:ae},ae)))]:[],f("optgroup",{label:H("shipped")},...r.map(ae=>f("option",{value:ae.name},ae.name))));R.addEventListener("change",()=>{Q()});let w=new tr(!0),y=f("div",{class:"player bare"},w.element),A=null,k=!0,U=1,D={low:0,high:0},L=ui(H("centres"),!0,ae=>{k=ae,w.showCentres(ae?A:null)},H("instant centres in front and side view, and the roll centre"));w.element.querySelector(".bar").append(f("div",{class:"group"},L));let F=new qh(ae=>{v[_.value].value=ae,P()}),P=()=>{let ae=v[_.value],Xe=Math.min(Math.max(ae.value,D.low),D.high);w.set({body:0,travel:Xe*U,ground:G(Xe*U),load:1,time:0}),F.mark(Xe)},G=ae=>0,Y=n.numbers.map(ae=>ae.path).filter(ae=>/ball_joint\[2\]|tie_rod_(inner|outer)\[2\]/.test(ae)).slice(0,4),X=new Ba(n,Y,()=>{J.set(he()),Q()}),he=()=>n.numbers.map(({path:ae,value:Xe})=>({path:ae,value:X.changes[ae]??Xe})),J=new Ga(w,ae=>{for(let[Xe,tt]of Object.entries(ae))X.set(Xe,tt);Q()});J.set(n.numbers);let ee=[],ne=f("select",{},f("option",{value:""},H("none")),...s.filter(ae=>ae.kind==="design").map(ae=>f("option",{value:ae.path},ae.path)));ne.addEventListener("change",()=>{Q()});let ue=[],de=new wf(ee,()=>ue,()=>{Q()}),Q=()=>h.ask(async()=>{let ae=performance.now(),Xe=_.value,tt=pt=>pt.name===Xe?pt.range.value:pt.value?`${pt.value} ${pt.unit}`:"",rt=setTimeout(()=>{u.textContent=H("computing; the first time a model is compiled once, which takes some seconds")},500);try{let pt=ti.of(await Jr("kinematics",{rig:t,changes:X.changes,over:Xe,against:R.value,targets:ee,study:ne.value,travel:Xe==="roll"?"":tt(v.travel),rack:l?tt(v.rack):"",roll:Xe==="roll"?tt(v.roll):""}));if(!i.isConnected)return;let Pt=pt.content,qt=pt.content.viewers[0],Tt=qt.scenes[0],sn=pt.get(Tt.x);if(A=Pt.centres,D={low:sn[0],high:sn[sn.length-1]},Tt.motion){let lt=pt.content.mechanisms[Tt.motion.mechanism],Bt=lt.travel;U=Math.abs(D.high)>0?Bt[Bt.length-1]/D.high:D.low!==0?Bt[0]/D.low:1,G=Wt=>lt.contact[lE(Bt,Wt)]?.[2]??0,w.show(lt,Tt.motion),w.showCentres(k?A:null)}ue=Tt.panes.filter(lt=>!lt.name.startsWith("Δ")).map(({name:lt,unit:Bt})=>({name:lt,unit:Bt})),de.offer(),F.show(qt,pt,Pt.targets),P(),p.replaceChildren(...Pt.notes.map(lt=>f("p",{class:"muted"},lt))),me.replaceChildren(...(qt.roles.length>1?qt.roles:[]).map(({role:lt,label:Bt},Wt)=>f("li",{},f("i",{class:`swatch ${lt}`}),Bt,Wt?` (${H("dashed")})`:""))),g.replaceChildren(...nl(Pt)),w.draw(),d.push(performance.now()-ae),u.textContent=H("# curves computed and drawn",String(ue.length))+` ${H("in")} ${Ee(d[d.length-1],2)} ms`,u.classList.remove("problem")}catch(pt){u.textContent=pt instanceof Error?pt.message:String(pt),u.classList.add("problem")}finally{clearTimeout(rt)}}),me=f("ul",{class:"legend"}),_e=f("input",{type:"search",placeholder:H("camber, roll centre …")});_e.addEventListener("input",()=>F.filter(_e.value));let Te=f("button",{type:"button"},H("Write these changes into the file")),xe=f("span",{"aria-live":"polite"});Te.addEventListener("click",()=>{if(!Object.keys(X.changes).length){xe.textContent=H("Nothing is changed.");return}(async()=>{try{let ae=await Zr(t),Xe=await Ki(t,ae.text,[],X.changes);if(Xe.problems.length)throw new Error(Xe.problems[0].text);await fr(t,Xe.text,ae.digest),sessionStorage.setItem("written",H("The changes stand in the file; what it was before is an earlier version.")),dispatchEvent(new HashChangeEvent("hashchange"))}catch(ae){xe.replaceChildren(At(ae))}})()});let qe=a?B0(t,n,ee,X,ae=>{for(let[Xe,tt]of Object.entries(ae))X.set(Xe,tt);J.set(he()),Q()}):f("p",{class:"muted"},H("Start a rig of your own from this one to design it.")),st=()=>{i.isConnected&&(w.draw(),requestAnimationFrame(st))};$n(()=>w.repaint()),x(),i.replaceChildren(f("h1",{},H("Kinematics of #",t)),...a?[f("p",{class:"bar"},f("a",{href:ft("rig",{name:t})},H("To its file")))]:[],f("div",{class:"form"},Fe(H("Curves over"),_),Fe(H("Compare with"),R),Fe(H("Targets of a study"),ne),Fe(H("Show curves with"),_e)),f("div",{class:"sliders drives"},...["travel",...l?["rack"]:[],"roll"].map(ae=>v[ae].element)),u,p,f("div",{class:"beside"},f("div",{class:"stuck"},y,J.element),f("div",{},me,f("div",{class:"scrolled",tabindex:"0",role:"region","aria-label":H("curves")},F.element))),f("h2",{},H("Numbers")),X.element,...a?[f("p",{class:"bar"},Te,xe)]:[],f("h2",{},H("Targets")),de.element,f("h2",{},H("Design from targets")),qe,g),xe.textContent=sessionStorage.getItem("written")??"",sessionStorage.removeItem("written"),requestAnimationFrame(st),await Q()}function lE(i,e){let t=0;return i.forEach((n,s)=>{Math.abs(n-e)<Math.abs(i[t]-e)&&(t=s)}),t}var wf=class{constructor(e,t,n){this.targets=e;this.quantities=t;this.changed=n;let s=f("select",{},...[["value","="],["at_least","≥"],["at_most","≤"]].map(([h,d])=>f("option",{value:h,title:h},d))),r=f("input",{type:"text",value:"0 deg"}),a=f("input",{type:"text",value:"0.1 deg"}),o=f("input",{type:"text",value:"-20 mm:20 mm:10 mm"}),l=()=>{let h=this.quantities().find(d=>d.name===this.quantity.value);if(h){let d=h.unit.replace("°","deg");r.value=`0 ${d}`.trim(),a.value=`0.1 ${d}`.trim()}};this.quantity.addEventListener("change",l);let c=f("form",{class:"form"},Fe(H("Quantity"),this.quantity),Fe(H("is wanted"),s),Fe(H("Value"),r),Fe(H("Tolerance"),a),Fe(H("At, or over first:last:step"),o),f("button",{type:"submit"},H("Add the target")));c.addEventListener("submit",h=>{h.preventDefault(),e.push({quantity:this.quantity.value,[s.value]:r.value,tolerance:a.value,...o.value.includes(":")?{over:o.value}:o.value?{at:o.value}:{}}),this.list(),n()}),this.element.append(f("div",{class:"table"},f("table",{},this.rows)),c),this.list()}targets;quantities;changed;element=f("div",{});quantity=f("select",{});rows=f("tbody",{});known="";offer(){let e=this.quantities().map(n=>n.name);if(e.join()===this.known)return;this.known=e.join();let t=this.quantity.value;this.quantity.replaceChildren(...e.map(n=>f("option",{value:n},n.replaceAll("_"," ")))),e.includes(t)&&(this.quantity.value=t)}list(){this.rows.replaceChildren(...this.targets.length?this.targets.map((e,t)=>f("tr",{},f("th",{scope:"row"},e.quantity.replaceAll("_"," ")),f("td",{},e.value!==void 0?`= ${e.value} ± ${e.tolerance}`:e.at_least!==void 0?`≥ ${e.at_least} − ${e.tolerance}`:`≤ ${e.at_most} + ${e.tolerance}`),f("td",{},e.over??e.at??H("at design")),f("td",{},f("button",{type:"button","aria-label":H("Take # away",e.quantity),click:()=>{this.targets.splice(t,1),this.list(),this.changed()}},"×")))):[f("tr",{},f("td",{class:"muted"},H("None yet: add one below, and its band stands in its curve.")))])}};var H0={label:"Project",show:hE},cE={rig:[["rig","name","edit"],["trial","rig","drive it"],["kinematics","rig","kinematics"]],record:[["record","path","look at it"],["trial","record","beside a run"]]},W0=i=>new Date(i*1e3).toISOString().slice(0,16).replace("T"," ");async function hE(i){let[{name:e,folder:t,entries:n},s,r]=await Promise.all([ei(),ks(),_n("/api/history")]);document.getElementById("project").textContent=e;let a=n.map(u=>{let p=cE[u.kind]??[],[g]=p,_=u.kind==="page"&&u.path.endsWith(".html")?`/api/document?${Qn({path:u.path})}`:null;return f("tr",{},f("th",{scope:"row"},g?f("a",{href:ft(g[0],{[g[1]]:u.path})},u.path):_?f("a",{href:_,target:"_blank"},u.path):u.path),f("td",{},H(u.kind)),f("td",{class:"right"},`${Ee(u.size/1e3,3)} kB`),f("td",{},W0(u.modified)),f("td",{},...p.slice(1).flatMap(([m,v,x])=>[f("a",{href:ft(m,{[v]:u.path})},H(x))," "])))}),o=f("select",{},...s.map(u=>f("option",{value:u.name},u.name))),l=f("input",{type:"text",value:`${s[0]?.name??"rig"}.toml`,spellcheck:"false"});o.addEventListener("change",()=>{l.value=`${o.value}.toml`});let c=f("div",{"aria-live":"polite"}),h=f("button",{type:"submit",class:"main"},H("Copy it here")),d=f("form",{class:"form"},Fe(H("Shipped rig"),o),Fe(H("Name of your file"),l),h);d.addEventListener("submit",u=>{u.preventDefault(),Qf(o.value,l.value).then(p=>{location.hash=ft("rig",{name:p.path})},p=>c.replaceChildren(At(p)))}),i.replaceChildren(f("h1",{},e),f("p",{class:"muted"},t),uE(n,r),n.length?f("div",{class:"table",tabindex:"0",role:"region","aria-label":H("files")},f("table",{},f("thead",{},f("tr",{},...[H("file"),H("what it is"),H("size"),H("written (UTC)"),H("to do")].map(u=>f("th",{scope:"col"},u)))),f("tbody",{},...a))):f("p",{class:"empty"},H("No rigs, roads or records lie here yet. Start from a rig that comes with jounce, or put your files into the folder.")),f("h2",{},H("Start from an example")),d,c,...r.length?[f("h2",{},H("Runs that were kept")),dE(r)]:[])}function uE(i,e){let t=a=>i.filter(o=>o.kind===a),[n]=t("rig"),[s]=t("record"),r=[];return n?(e.length||r.push(f("li",{},f("a",{href:ft("trial",{rig:n.path})},H("Drive # over an obstacle",n.path)),H(", and keep the run."))),e.length===1&&r.push(f("li",{},f("a",{href:ft("trial",{rig:n.path})},H("Change # and keep another run",n.path)),H(", to compare the two."))),s&&!t("campaign").length&&r.push(f("li",{},f("a",{href:ft("trial",{rig:n.path,record:s.path})},H("Look at # beside a run",s.path)),".")),t("sweep").length||r.push(f("li",{},f("a",{href:ft("studies")},H("Vary its numbers in a study")),"."))):r.push(f("li",{},H("Start from a shipped rig, below."))),r.length?f("section",{class:"next","aria-label":H("What to do next")},f("h2",{},H("What to do next")),f("ul",{},...r)):f("section",{hidden:!0})}function dE(i){let e=i.map((a,o)=>f("input",{type:"checkbox","aria-label":H("compare #",a.path),checked:o<2})),t=f("div",{}),n=f("button",{type:"button"},H("Compare those that are chosen")),s=a=>f("code",{title:a},a.slice(0,8));n.addEventListener("click",()=>{let a=i.filter((o,l)=>e[l].checked).map(o=>o.path).slice(0,6);if(!a.length){t.replaceChildren(f("p",{class:"muted"},H("Choose one or more of them.")));return}eo("/api/compare",{paths:a}).then(o=>{let l=ti.of(o);t.replaceChildren(new sr(l.content.viewers[0],l).element,f("div",{class:"ways"},...nl(l.content)))},o=>t.replaceChildren(At(o)))});let r=({trial:a})=>`${H(String(a.road.kind??"").replace("-"," "))} ${Object.entries(a.road).filter(([o])=>!["kind","start"].includes(o)).map(([,o])=>o).join(" × ")}, ${a.speed}`;return f("section",{},f("div",{class:"table",tabindex:"0",role:"region","aria-label":H("Runs that were kept")},f("table",{},f("thead",{},f("tr",{},...["",H("run"),H("rig"),H("changes"),H("trial"),H("inputs"),H("seed"),H("version"),H("kept (UTC)")].map(a=>f("th",{scope:"col"},a||f("span",{class:"hidden"},H("compare")))))),f("tbody",{},...i.map((a,o)=>f("tr",{},f("td",{},e[o]),f("th",{scope:"row"},f("a",{href:ft("record",{path:a.path})},a.path.replace(/^runs\//,""))),f("td",{},a.rig),f("td",{},Object.entries(a.changes).map(([l,c])=>`${l} = ${typeof c=="number"?Ee(c,5):c}`).join(", ")||"–"),f("td",{},r(a)),f("td",{},s(a.rig_digest)," ",s(a.trial_digest)),f("td",{},a.seed===null?"–":String(a.seed)),f("td",{},a.version),f("td",{},W0(a.when))))))),f("p",{class:"bar"},n),t)}var X0={label:"Records",show:pE},fE=3;async function pE(i,e){let t=e.get("path");if(!t){await lr(i,"record",H("Records"),"path",!1,["record"]);return}let n=performance.now(),s=await _n(`/api/record?${Qn({path:t})}`),r=new Set(s.channels.slice(0,fE).map(m=>m.name)),a=new Ps,o=[];or({times:o});let l=f("p",{class:"state",role:"status"}),c=!1,h=[s.first,s.last],d=new ka(m=>d.mark(m),m=>{c||(h=m,u())}),u=()=>a.ask(async()=>{if(!r.size||!i.isConnected)return;let m=performance.now(),[v,x]=h,E=x-v;try{let S=ti.of(await eo("/api/record",{path:t,channels:[...r],low:Math.max(s.first,v-E),high:Math.min(s.last,x+E),columns:Math.max(600,3*Math.round(d.element.clientWidth))})),R=S.content.viewers[0].scenes[0];c=!0,d.show({x:S.get(R.x),xLabel:`${H("time")} [${s.unit}]`,spans:[],window:null,whole:[s.first,s.last],panes:R.panes.map(w=>({title:w.name,unit:w.unit,lines:w.curves.map(y=>({label:"",role:y.role,y:S.get(y.y),step:0,shown:!0}))}))},h),c=!1,o.push(performance.now()-m),l.textContent="",l.classList.remove("problem")}catch(S){c=!1,l.textContent=S instanceof Error?S.message:String(S),l.classList.add("problem")}}),p=f("div",{class:"group",role:"group","aria-label":H("channels")},...s.channels.map(({name:m,unit:v})=>ui(m,r.has(m),x=>{x?r.add(m):r.delete(m),u()},v))),g=f("div",{class:"group"},...[["+",H("zoom in"),()=>d.zoomBy(.5)],["−",H("zoom out"),()=>d.zoomBy(2)],["‹",H("to the left"),()=>d.pan(-.5)],["›",H("to the right"),()=>d.pan(.5)],[H("All"),H("everything"),()=>d.reset()]].map(([m,v,x])=>f("button",{type:"button",title:v,"aria-label":v,click:x},m))),_=f("div",{class:"player",tabindex:"0",role:"region","aria-label":H("curves")},f("div",{class:"bar"},p,f("span",{class:"grow"}),g),f("div",{class:"plots-only"},d.element));_.addEventListener("keydown",m=>{if(m.ctrlKey||m.altKey||m.metaKey)return;let x={ArrowLeft:()=>d.pan(-.2),ArrowRight:()=>d.pan(.2),"+":()=>d.zoomBy(.5),"-":()=>d.zoomBy(2),0:()=>d.reset()}[m.key];x&&(m.preventDefault(),x())}),$n(()=>d.repaint()),i.replaceChildren(f("h1",{},t),f("p",{class:"muted"},`${H("# samples",Ee(s.count,8))}, ${s.even?`${H("every")} ${Ee(s.step,4)} ${s.unit}`:H("not evenly spaced")}, ${Ee(s.first,6)} – ${Ee(s.last,6)} ${s.unit}; ${H("units as they are in the file")}`),f("p",{class:"bar"},f("a",{href:ft("trial",{record:t})},H("Beside a run"))),s.channels.length?_:f("p",{class:"empty"},H("There is nothing in it but time.")),l,f("p",{class:"muted"},H("Drag to zoom, Shift + wheel or ← → pans, Ctrl + wheel zooms, double click for everything."))),await u(),o.unshift(performance.now()-n)}var $0=["schema","model"],Ef=i=>typeof i=="object"&&i!==null&&!Array.isArray(i),Tf=i=>i.map((e,t)=>typeof e=="number"?`[${e}]`:t?`.${e}`:e).join(""),Yh=class{constructor(e){this.changed=e}changed;element=f("div",{class:"described"});open=new Set(["hardpoints","strut","sprung","unsprung","tyre"]);definitions={};problems=[];show(e,t,n){let s=document.activeElement?.closest("[data-path]")?.dataset.path,r=this.element.contains(document.activeElement);this.definitions=e.$defs??{},this.problems=n,this.element.replaceChildren(...this.rows(e,t,[]));let a=new Set([...this.element.querySelectorAll("[data-path]")].map(l=>l.dataset.path)),o=n.filter(l=>!a.has(l.path));o.length&&this.element.prepend(...o.map(l=>f("p",{class:"problem",role:"alert"},`${l.line?`${H("line #",String(l.line))}: `:""}${l.path?`${l.path}: `:""}${l.text}`))),r&&s&&this.element.querySelector(`[data-path="${CSS.escape(s)}"]`)?.querySelector("input, select")?.focus()}resolved(e){return e.$ref?this.definitions[e.$ref.split("/").pop()]:e}choices(e){let t=this.resolved(e),n=t.anyOf??t.oneOf;return n?n.flatMap(s=>this.choices(s)).filter(s=>s.type!=="null"):[t]}rows(e,t,n){let s=this.resolved(e),r=s.properties??{},a=[...Object.keys(t),...(s.required??[]).filter(h=>!(h in t))].filter(h=>n.length||!$0.includes(h)),o=[],l=[];for(let h of a){let d=this.field(h,r[h]??{},t[h],[...n,h],(s.required??[]).includes(h)||!r[h]?.$ref&&r[h]?.default===void 0);(d.tagName==="DETAILS"?l:o).push(d)}let c=Object.keys(r).filter(h=>!(h in t)&&!a.includes(h)&&!($0.includes(h)&&!n.length));return[...o,...l,...c.length?[this.more(c,r,n)]:[]]}more(e,t,n){let s=f("select",{"aria-label":H("Add to #",Tf(n)||H("the rig"))},f("option",{value:""},H("add …")),...e.map(r=>f("option",{value:r},r.replaceAll("_"," "))));return s.addEventListener("change",()=>{s.value&&(this.open.add(Tf([...n,s.value])),this.changed([...n,s.value],this.first(t[s.value])))}),f("p",{class:"add"},s)}first(e){if(e.default!==void 0&&e.default!==null&&!Ef(e.default))return e.default;let t=this.choices(e)[0];return t.const!==void 0?t.const:t.enum?t.enum[0]:t.properties?Object.fromEntries(Object.entries(t.properties).filter(([n,s])=>t.required?.includes(n)||s.const!==void 0).map(([n,s])=>[n,this.first(s)])):t.prefixItems?t.prefixItems.map(n=>this.first(n)):t.type==="array"?[]:t.type==="boolean"?!1:"?"}field(e,t,n,s,r){let a=Tf(s),o=this.problems.filter(v=>v.path===a),l=`f-${a}`,c=typeof s[s.length-1]=="number"?String(s[s.length-1]):e.replaceAll("_"," "),h=o.length?[f("span",{class:"wrong",role:"alert",id:`${l}-wrong`},o.map(v=>v.text).join(" "))]:[],d=r?[]:[f("button",{type:"button",class:"away",title:H("Take # away",a),"aria-label":H("Take # away",a),click:()=>this.changed(s,null)},"×")],u=this.choices(t);if(Ef(n)||n===void 0&&u.some(v=>v.properties)){let v=f("details",{"data-path":a,open:this.open.has(a)||this.problems.some(w=>w.path.startsWith(a))});v.addEventListener("toggle",()=>{v.open?this.open.add(a):this.open.delete(a)});let x=Ef(n)?n:{},E=u.filter(w=>w.properties),S=this.kindOf(E,x),R=f("select",{"aria-label":H("kind of #",a)},...E.map((w,y)=>f("option",{value:String(y),...w===S?{selected:!0}:{}},mE(w.title??""))));return R.addEventListener("change",()=>this.changed(s,this.become(E[Number(R.value)],x))),v.append(f("summary",{},c),...E.length>1?[f("p",{class:"kind"},R)]:[],...h,...this.rows(S??{},x,s),...d),v}let p={id:l,...o.length?{"aria-invalid":"true","aria-describedby":`${l}-wrong`}:{}};if(Array.isArray(n)&&n.every(v=>typeof v!="object")){let v=u.find(x=>x.prefixItems)?.prefixItems;if(v&&v.length===n.length){let x=this.problems.filter(S=>S.path.startsWith(`${a}[`)),E=n.map((S,R)=>this.typed(String(S),v[R],[...s,R],{"aria-label":`${a}[${R}]`,...x.some(w=>w.path===`${a}[${R}]`)?{"aria-invalid":"true"}:{}}));return f("div",{class:"row","data-path":a},f("span",{class:"name"},c),f("span",{class:"three"},...E.map((S,R)=>f("span",{"data-path":`${a}[${R}]`},S))),...d,...h,...x.map(S=>f("span",{class:"wrong",role:"alert"},`${S.path}: ${S.text}`)))}}let g,_=u.find(v=>v.enum);if(_?.enum&&typeof n=="string"){let v=f("select",p,...[...new Set([n,..._.enum])].map(x=>f("option",{value:x,...x===n?{selected:!0}:{}},x)));v.addEventListener("change",()=>this.changed(s,v.value)),g=v}else if(typeof n=="boolean"){let v=f("input",{type:"checkbox",...p,checked:n});v.addEventListener("change",()=>this.changed(s,v.checked)),g=v}else u.length===1&&u[0].const!==void 0?g=f("output",p,String(n)):g=this.typed(n===void 0?"":typeof n=="object"?JSON.stringify(n):String(n),t,s,p,typeof n=="object");let m=t.description??u.find(v=>v.description)?.description??"";return f("div",{class:"row","data-path":a},f("label",{class:"name",for:l,title:m},c),g,...d,...h)}typed(e,t,n,s,r=!1){let a=f("input",{type:"text",spellcheck:"false",value:e,...s}),o=this.choices(t).map(l=>l.type);return a.addEventListener("change",()=>{let l=a.value.trim();if(r)try{this.changed(n,JSON.parse(l))}catch{this.changed(n,l)}else this.changed(n,l!==""&&!Number.isNaN(Number(l))&&o.some(c=>c==="number"||c==="integer")?Number(l):l)}),a}kindOf(e,t){let n=e.find(r=>r.properties?.kind?.const!==void 0&&r.properties.kind.const===t.kind),s=r=>Object.keys(t).filter(a=>a in r.properties).length-Object.keys(t).filter(a=>!(a in r.properties)).length-(r.required??[]).filter(a=>!(a in t)).length;return n??[...e].sort((r,a)=>s(a)-s(r))[0]}become(e,t){let n=this.first(e);for(let[s,r]of Object.entries(t))s!=="kind"&&s in e.properties&&(n[s]=r);return n}};function mE(i){return i.replace(/([a-z])([A-Z])/g,"$1 $2").toLowerCase()}var q0={label:"Rig",show:gE};async function gE(i,e){let t=e.get("name");if(!t){await lr(i,"rig",H("Rig"),"name");return}let n=await Zr(t),s=null,r=[],a=[],o=f("textarea",{spellcheck:"false","aria-label":H("text of #",t),rows:"28"});o.value=n.text;let l=n.text,c=f("div",{class:"told","aria-live":"polite"}),h=f("div",{}),d=f("button",{type:"button",class:"main",disabled:!0},H("Save")),u=f("button",{type:"button",disabled:!0},H("Undo")),p=f("button",{type:"button",disabled:!0},H("Redo")),g=new Ps,_=new Ps,m=new Yh((L,F)=>{A({sets:[[L,F]]})}),v=new tr(!0),x=f("div",{class:"player bare",hidden:!0},v.element),E=new Ga(v,(L,F)=>{F?A({changes:L}):w(L)}),S=f("section",{hidden:!0,"aria-label":H("The mechanism")},f("h2",{},H("The mechanism")),f("p",{class:"muted"},H("Drag a hardpoint, or choose it and type its place; drag beside them to turn the picture.")),E.element,x),R=()=>{d.disabled=o.value===n.text,u.disabled=!r.length,p.disabled=!a.length},w=(L={})=>_.ask(async()=>{if(s?.rig?.spatial)try{let F=ti.of(await Jr("kinematics",{rig:t,text:o.value,changes:L,travel:"-20 mm:20 mm:10 mm",channels:["camber"]})),P=F.content.viewers[0].scenes[0].motion;if(!P)return;S.hidden=x.hidden=!1,v.show(F.content.mechanisms[P.mechanism],P),v.set({body:0,travel:0,ground:F.content.mechanisms[P.mechanism].contact[2][2],load:1,time:0})}catch(F){c.replaceChildren(At(F))}}),y=async(L,F)=>{if(F&&L.text!==l&&(r.push(l),a.length=0),l=L.text,o.value!==L.text&&(o.value=L.text),s=L,R(),L.model)try{m.show(await ep(L.model),L.values,L.problems)}catch{m.element.replaceChildren()}let P=L.problems.map(G=>At(new Error(`${G.line?`${H("line #",String(G.line))}: `:""}${G.path?`${G.path}: `:""}${G.text}`)));c.replaceChildren(...P.length?P:[f("p",{class:"good"},H("#: nothing is wrong with it.",`${L.model}, ${H("# numbers",String(L.rig?.numbers.length??0))}`))],...(L.rig?.findings??[]).map(G=>f("p",{},G))),h.replaceChildren(),L.rig&&(E.set(L.rig.numbers),await w()),L.rig&&!L.rig.spatial&&(S.hidden=!0)},A=L=>g.ask(async()=>{try{await y(await Ki(t,o.value,L.sets??[],L.changes??{}),!0)}catch(F){c.replaceChildren(At(F))}}),k=0;o.addEventListener("input",()=>{d.disabled=o.value===n.text,clearTimeout(k),k=setTimeout(()=>{A({})},400)});let U=(L,F)=>{let P=L.pop();P!==void 0&&(F.push(l),l=P,o.value=P,g.ask(async()=>{await y(await Ki(t,P,[],{}),!1)}))};u.addEventListener("click",()=>U(r,a)),p.addEventListener("click",()=>U(a,r)),i.addEventListener("keydown",L=>{!(L.ctrlKey||L.metaKey)||L.target===o||(L.key==="z"&&!L.shiftKey&&(L.preventDefault(),U(r,a)),(L.key==="y"||L.key==="Z"&&L.shiftKey)&&(L.preventDefault(),U(a,r)))}),d.addEventListener("click",()=>{let L=f("button",{type:"button",class:"main"},H("Write it")),F=f("button",{type:"button"},H("Back"));F.addEventListener("click",()=>h.replaceChildren()),L.addEventListener("click",()=>{fr(t,o.value,n.digest).then(async P=>{n=P,R(),await y(await Ki(t,P.text,[],{}),!1),c.prepend(f("p",{class:"good"},H("Saved.")))},P=>h.replaceChildren(At(P)))}),g.ask(async()=>{let P=await Ki(t,o.value,[],{});h.replaceChildren(f("section",{class:"difference","aria-label":H("What is changed")},f("h2",{},H("What is changed")),...P.problems.length?[f("p",{class:"problem"},H("Something is still wrong with it; it can be saved all the same."))]:[],f("pre",{tabindex:"0","aria-label":H("What is changed")},...P.changed.map(G=>f("span",{class:G.startsWith("+")?"added":G.startsWith("-")?"removed":G.startsWith("@@")?"muted":""},`${G}
`))),f("div",{class:"bar"},L,F))),L.focus()})});let D=()=>{i.isConnected&&(v.draw(),requestAnimationFrame(D))};$n(()=>{v.repaint()}),i.replaceChildren(f("h1",{},t),f("p",{class:"bar"},f("a",{href:ft("trial",{rig:t})},H("Drive it over an obstacle")),f("a",{href:ft("kinematics",{rig:t})},H("Look at its kinematics"))),c,f("div",{class:"bar"},d,u,p),h,S,f("div",{class:"two"},f("section",{"aria-label":H("Form")},f("h2",{},H("Form")),m.element),f("section",{"aria-label":H("File")},f("h2",{},H("File")),o))),await y(await Ki(t,n.text,[],{}),!1),requestAnimationFrame(D)}var Or={"half-sine":["height","length"],versine:["height","length"],rectangle:["height","length"],triangle:["height","length"],step:["height"],pothole:["depth","length"]},Zh={height:"10 mm",depth:"10 mm",length:"60 mm"};var Ha=i=>`${i.name} [${i.unit||"–"}]`,Qh=i=>{let e=1/0,t=-1/0;for(let n of i)n!==null&&(n<e&&(e=n),n>t&&(t=n));return e<t?[e,t]:e===t?[e-(Math.abs(e)||1)*.5,e+(Math.abs(e)||1)*.5]:[0,1]},eu=class{constructor(e){this.columns=e;this.count()}columns;ranges=new Map;chosen=[];picked=-1;listeners=[];listen(e){this.listeners.push(e)}set(e,t){t?this.ranges.set(e,t):this.ranges.delete(e),this.count()}clear(){this.ranges.clear(),this.count()}pick(e){this.picked=e;for(let t of this.listeners)t()}count(){let e=this.columns[0]?.values.length??0;this.chosen=Array.from({length:e},(t,n)=>[...this.ranges].every(([s,[r,a]])=>{let o=this.columns[s].values[n];return o!=null&&o>=r&&o<=a}));for(let t of this.listeners)t()}};function Y0(i,e){let t=Math.min(window.devicePixelRatio||1,2),n=f("canvas",{width:String(Math.round(i*t)),height:String(Math.round(e*t))}),s=n.getContext("2d");return s.scale(t,t),n.style.width=`${i}px`,n.style.height=`${e}px`,[n,s]}var Jh=130,Fr=26,pl=250,vE=22;function Z0(i){let{columns:e}=i,t=e.map(p=>Qh(p.values)),n=Jh*e.length,s=Fr+pl+vE,[r,a]=Y0(n,s);r.setAttribute("role","img"),r.setAttribute("aria-label",`every variant as a line through ${e.map(Ha).join(", ")}`);let o=p=>Jh*(p+.5),l=(p,g)=>{let[_,m]=t[p];return Fr+pl*(1-(g-_)/(m-_))},c=()=>{a.clearRect(0,0,n,s);let p=_=>{a.beginPath();let m=!1;e.forEach((v,x)=>{let E=v.values[_];if(E==null){m=!1;return}m?a.lineTo(o(x),l(x,E)):a.moveTo(o(x),l(x,E)),m=!0}),a.stroke()},g=i.chosen.length;if(a.lineWidth=1,a.strokeStyle=yt("line"),i.ranges.size)for(let _=0;_<g;_++)i.chosen[_]||p(_);a.strokeStyle=yt("accent"),a.globalAlpha=Math.max(.08,Math.min(.7,60/Math.max(g,1)));for(let _=0;_<g;_++)i.chosen[_]&&p(_);a.globalAlpha=1,i.picked>=0&&(a.strokeStyle=yt("other-5"),a.lineWidth=2.5,p(i.picked)),a.font="12px system-ui, sans-serif",a.textAlign="center",e.forEach((_,m)=>{let[v,x]=t[m];a.strokeStyle=yt("edge"),a.lineWidth=1,a.beginPath(),a.moveTo(o(m),Fr),a.lineTo(o(m),Fr+pl),a.stroke();let E=i.ranges.get(m);E&&(a.fillStyle=yt("other-5"),a.globalAlpha=.3,a.fillRect(o(m)-7,l(m,E[1]),14,Math.max(2,l(m,E[0])-l(m,E[1]))),a.globalAlpha=1),a.fillStyle=yt("ink"),a.fillText(Ee(x,3),o(m),Fr-8),a.fillText(Ee(v,3),o(m),Fr+pl+15)})},h=null,d=p=>{let g=r.getBoundingClientRect(),_=Math.min(e.length-1,Math.max(0,Math.floor((p.clientX-g.left)/Jh))),m=Math.min(1,Math.max(0,1-(p.clientY-g.top-Fr)/pl)),[v,x]=t[h?.k??_];return{k:_,value:v+m*(x-v)}};r.addEventListener("pointerdown",p=>{h=d(p),r.setPointerCapture(p.pointerId)}),r.addEventListener("pointermove",p=>{if(!h)return;let{value:g}=d(p),[_,m]=t[h.k];Math.abs(g-h.value)>.01*(m-_)&&i.set(h.k,[Math.min(g,h.value),Math.max(g,h.value)])}),r.addEventListener("pointerup",p=>{h&&Math.abs(d(p).value-h.value)<.01*(t[h.k][1]-t[h.k][0])&&i.set(h.k,null),h=null}),i.listen(c),$n(c),c();let u=f("div",{class:"axes"},...e.map(p=>f("span",{title:Ha(p)},p.name,f("small",{},p.unit||"–"))));return u.style.width=`${n}px`,u.style.gridTemplateColumns=`repeat(${e.length}, ${Jh}px)`,f("div",{class:"wide",tabindex:"0",role:"region","aria-label":"parallel coordinates"},u,r)}function J0(i){let e=i.columns.map((t,n)=>{let[s,r]=Qh(t.values),a=["from","to"].map(l=>f("input",{type:"number",step:"any","aria-label":`${t.name}, ${l} [${t.unit||"–"}]`,placeholder:Ee(l==="from"?s:r,4)})),o=()=>{let[l,c]=a.map(h=>h.value);i.set(n,l||c?[l?Number(l):-1/0,c?Number(c):1/0]:null)};for(let l of a)l.addEventListener("change",o);return i.listen(()=>{let l=i.ranges.get(n);a.forEach((c,h)=>{document.activeElement!==c&&(c.value=l&&Number.isFinite(l[h])?String(Number(l[h].toPrecision(4))):"")})}),f("tr",{},f("th",{scope:"row"},t.name),f("td",{},a[0]),f("td",{},a[1]),f("td",{},t.unit||"–"))});return f("details",{},f("summary",{},"Ranges as numbers"),f("div",{class:"table",tabindex:"0",role:"region","aria-label":"ranges"},f("table",{},f("thead",{},f("tr",{},...["","from","to","unit"].map(t=>f("th",{scope:"col"},t)))),f("tbody",{},...e))))}var Kh=170,ml=130,jh=8;function _E(i,e,t){let[n,s]=Y0(Kh,ml),[r,a]=Qh(e.values),[o,l]=Qh(t.values),c=u=>jh+(Kh-2*jh)*(u-r)/(a-r),h=u=>ml-jh-(ml-2*jh)*(u-o)/(l-o);n.setAttribute("role","img"),n.setAttribute("aria-label",`${Ha(t)} over ${Ha(e)}: ${Ee(o,3)} to ${Ee(l,3)} over ${Ee(r,3)} to ${Ee(a,3)}`);let d=()=>{s.clearRect(0,0,Kh,ml),s.strokeStyle=yt("edge"),s.strokeRect(.5,.5,Kh-1,ml-1);let u=i.chosen.length,p=(g,_)=>{let m=e.values[g],v=t.values[g];m!=null&&v!==null&&v!==void 0&&s.fillRect(c(m)-_/2,h(v)-_/2,_,_)};s.fillStyle=yt("line");for(let g=0;g<u;g++)i.chosen[g]||p(g,2);s.fillStyle=yt("accent"),s.globalAlpha=u>400?.5:.9;for(let g=0;g<u;g++)i.chosen[g]&&p(g,2.5);s.globalAlpha=1,i.picked>=0&&(s.fillStyle=yt("other-5"),p(i.picked,7))};return n.addEventListener("click",u=>{let p=n.getBoundingClientRect(),g=[u.clientX-p.left,u.clientY-p.top],_=-1,m=15**2;e.values.forEach((v,x)=>{let E=t.values[x];if(v===null||E===null||E===void 0||!i.chosen[x])return;let S=(c(v)-g[0])**2+(h(E)-g[1])**2;S<m&&(m=S,_=x)}),_>=0&&i.pick(_)}),i.listen(d),$n(d),d(),n}function K0(i){let e=i.columns.filter(n=>n.is_number).slice(0,8),t=i.columns.filter(n=>!n.is_number).slice(0,6);return f("div",{class:"wide table",tabindex:"0",role:"region","aria-label":"matrix of dots"},f("table",{class:"matrix"},f("thead",{},f("tr",{},f("td",{}),...e.map(n=>f("th",{scope:"col"},Ha(n))))),f("tbody",{},...t.map(n=>f("tr",{},f("th",{scope:"row"},Ha(n)),...e.map(s=>f("td",{},_E(i,s,n))))))))}var xE=[["total","share of the variance, with others"],["mean_absolute_effect","mean size of effects"],["regression","regression coefficient"]];function j0(i,e,t){let n=(d,u)=>{let p=d.measures[u];return typeof p=="number"?p:p?.value??NaN},s=i.filter(d=>d.metric===e.name),[r,a]=xE.find(([d])=>s.some(u=>Number.isFinite(n(u,d))))??["regression","regression coefficient"];s.sort((d,u)=>Math.abs(n(u,r))-Math.abs(n(d,r)));let o=s.map(d=>[n(d,"at_low"),n(d,"at_high")].map(u=>(u-t)*e.factor)),l=Math.max(1e-300,...o.flat().filter(Number.isFinite).map(Math.abs)),c=(d,u)=>{let p=document.createElementNS("http://www.w3.org/2000/svg",d);for(let[g,_]of Object.entries(u))p.setAttribute(g,String(_));return p},h=s.map((d,u)=>{let p=c("svg",{viewBox:"-100 0 200 16",class:"swing","aria-hidden":"true"});p.append(c("line",{x1:0,x2:0,y1:0,y2:16,class:"zero"})),o[u].forEach((_,m)=>{if(!Number.isFinite(_))return;let v=96*_/l;p.append(c("rect",{x:Math.min(0,v),width:Math.abs(v),y:m?8.5:1.5,height:6,class:m?"high":"low"}))});let g=o[u].map(_=>Number.isFinite(_)?`${_>0?"+":""}${Ee(_,3)}`:"–");return f("tr",{},f("th",{scope:"row"},d.number),f("td",{class:"right"},g[0]),f("td",{},p),f("td",{class:"right"},g[1]),f("td",{class:"right"},Ee(n(d,r),3)))});return f("div",{class:"table",tabindex:"0",role:"region","aria-label":`what ${e.name} depends on`},f("table",{},f("caption",{},`${e.name}: from its mean of ${Ee(t*e.factor,4)} ${e.unit}, where a number is low and where it is high`),f("thead",{},f("tr",{},f("th",{scope:"col"},"number"),f("th",{scope:"col",class:"right"},f("span",{class:"key low"}),` low [${e.unit||"–"}]`),f("th",{scope:"col"},""),f("th",{scope:"col",class:"right"},f("span",{class:"key high"}),` high [${e.unit||"–"}]`),f("th",{scope:"col",class:"right"},a))),f("tbody",{},...h)))}var ev={label:"Studies",show:yE};async function yE(i,e){let t=e.get("job"),n=e.get("folder");if(t||n){await ME(i,t,n);return}let{entries:s}=await ei(),r=[...s.filter(o=>ar.includes(o.kind)).map(o=>o.path),...(await ks()).map(o=>o.name)],a=s.filter(o=>o.kind==="sweep");i.replaceChildren(f("h1",{},"Studies"),f("p",{class:"muted"},"Numbers of a rig are spread over ranges or distributions; every variant is simulated, and what its metrics depend on is told."),f("h2",{},"Sweeps"),Va(["sweep"],o=>{location.hash=ft("studies",{job:o.id})},"No sweep was begun here yet. Write a study below, or begin one that lies in the folder."),...a.length?[f("h2",{},"Studies that lie here"),f("ul",{},...a.map(o=>f("li",{},o.path," ",bE(o.path))))]:[],f("h2",{},"A new study"),await SE(r,e.get("rig")??""))}function bE(i){let e=i.replace(/\.toml$/,"-swept"),t=f("span",{}),n=f("button",{type:"button","aria-label":`Begin ${i}`},"Begin");return n.addEventListener("click",()=>{al({kind:"sweep",study:i,out:e,resume:!0}).then(()=>t.replaceChildren(),s=>t.replaceChildren(At(s)))}),f("span",{},n," ",f("small",{class:"muted"},`into ${e}`),t)}var Af={sobol:["Sobol: even over all numbers",!0],"latin-hypercube":["Latin hypercube",!0],"monte-carlo":["Monte Carlo: random",!0],grid:["Grid: every combination",!1],list:["List: one value of each a variant",!1],morris:["Morris: screening by trajectories",!0],saltelli:["Saltelli: indices of the variance",!0]},Q0={share:["± share",["20 %"]],range:["range",["from","to"]],normal:["normal",["mean","sd"]],triangular:["triangular",["low","mode","high"]],values:["values",["one, another, ..."]]};async function SE(i,e){if(!i.length)return f("p",{class:"empty"},"No rig lies here yet.");let t=f("select",{},...i.map(L=>f("option",L===e?{value:L,selected:!0}:{value:L},L))),n=f("tbody",{}),s=f("datalist",{id:"paths-of-the-rig"}),r=f("select",{},...Object.entries(Af).map(([L,[F]])=>f("option",{value:L},F))),a=f("input",{type:"number",min:"1",value:"256"}),o=f("input",{type:"number",min:"0",value:"0"}),l=f("input",{type:"text",value:"rms sprung.az, max strut.deflection"}),c=f("select",{},...Object.keys(Or).map(L=>f("option",{value:L},L.replace("-"," "))),f("option",{value:"iso"},"random road (ISO 8608)")),h=f("span",{class:"sizes"}),d=f("input",{type:"text",value:"2 m/s"}),u=f("input",{type:"text",value:"1.5 s"}),p=f("input",{type:"text",value:"study.toml",spellcheck:"false"}),g=f("input",{type:"text",value:"swept",spellcheck:"false"}),_=f("div",{"aria-live":"polite"});p.addEventListener("change",()=>{g.value=`${p.value.replace(/\.toml$/,"")}-swept`});let m=[],v=(L="",F="share")=>{let P=f("input",{type:"text",value:L,list:"paths-of-the-rig","aria-label":"number that varies",size:"30",spellcheck:"false"}),G=f("select",{"aria-label":"how it is spread"},...Object.entries(Q0).map(([ne,[ue]])=>f("option",ne===F?{value:ne,selected:!0}:{value:ne},ue))),Y=f("span",{class:"sizes"}),X=f("td",{class:"muted"}),he=()=>{let ne=m.find(me=>me.path===P.value);X.textContent=ne?`is ${Ee(ne.value*ne.factor)} ${ne.unit}`:P.value?"no number of this rig":"";let ue=ne?.unit??"",de=ne?ne.value*ne.factor:1,Q={from:.8,to:1.2,low:.8,mode:1,high:1.2,mean:1,sd:.05};Y.replaceChildren(...Q0[G.value][1].map(me=>{let _e=G.value==="share"?"20 %":me in Q?`${Number((Q[me]*de).toPrecision(4))} ${ue}`.trim():`${Number((.9*de).toPrecision(4))} ${ue}, ${Number((1.1*de).toPrecision(4))} ${ue}`;return f("input",{type:"text",value:_e,"aria-label":`${P.value||"number"}, ${me in Q?me:G.value}`,"data-word":me,size:G.value==="values"?"26":"11"})}))};P.addEventListener("change",he),G.addEventListener("change",he);let J=f("button",{type:"button","aria-label":`leave out ${L||"this number"}`},"×"),ee=f("tr",{},f("td",{},P),f("td",{},G),f("td",{},Y),X,f("td",{},J));J.addEventListener("click",()=>ee.remove()),he(),n.append(ee)},x=()=>h.replaceChildren(...c.value==="iso"?[Fe("Class",f("select",{name:"class"},..."ABCDEFGH".split("").map(L=>f("option",L==="C"?{value:L,selected:!0}:{value:L},L))))]:Or[c.value].map(L=>Fe(L[0].toUpperCase()+L.slice(1),f("input",{type:"text",value:Zh[L],name:L}))));c.addEventListener("change",x);let E=async()=>{_.replaceChildren();try{m=(await Bs(t.value)).numbers,s.replaceChildren(...m.map(F=>f("option",{value:F.path}))),n.replaceChildren();let L=["strut.spring.rate","strut.damper.coefficient","tyre.stiffness"].filter(F=>m.some(P=>P.path===F));for(let F of L.length?L:m.slice(0,2).map(P=>P.path))v(F)}catch(L){_.replaceChildren(At(L))}};t.addEventListener("change",()=>{E()}),r.addEventListener("change",()=>{a.disabled=!Af[r.value][1]});let S=L=>{let F=L.querySelector("select").value,P=Object.fromEntries([...L.querySelectorAll("input[data-word]")].map(Y=>[Y.dataset.word,Y.value.trim()])),G=Object.values(P);return F==="share"?G[0]:F==="range"?G:F==="values"?G[0].split(",").map(Y=>Y.trim()).filter(Boolean):P},R="",w="",y=async()=>{let L=Object.fromEntries([...h.querySelectorAll("[name]")].map(P=>[P.name,P.value])),F=await(await On("POST","/api/study",{path:p.value,was:w===p.value?R:"",rig:t.value,trial:{speed:d.value,duration:u.value,road:c.value==="iso"?`iso:${L.class}`:{kind:c.value,start:"0.2 m",...L}},design:{kind:r.value,...Af[r.value][1]?{count:Number(a.value),seed:Number(o.value)}:{}},vary:Object.fromEntries([...n.rows].map(P=>[P.querySelector("input").value.trim(),S(P)])),metrics:l.value.split(",").map(P=>P.trim()).filter(Boolean)})).json();return R=F.digest,w=p.value,F},A=f("form",{}),k=f("button",{type:"button"},"Write the study"),U=f("button",{type:"submit",class:"main"},"Write it and begin");k.addEventListener("click",()=>{y().then(L=>_.replaceChildren(f("p",{class:"good"},`${L.path}: ${L.count} variants.`)),L=>_.replaceChildren(At(L)))}),A.addEventListener("submit",L=>{L.preventDefault(),U.disabled=!0,y().then(F=>al({kind:"sweep",study:p.value,out:g.value}).then(P=>_.replaceChildren(f("p",{class:"good"},`${F.count} variants begun.`),rr(P)))).catch(F=>_.replaceChildren(At(F))).finally(()=>{U.disabled=!1})});let D=f("button",{type:"button"},"Another number");return D.addEventListener("click",()=>v()),A.append(f("div",{class:"form"},Fe("Rig",t),Fe("Road",c),h,Fe("Speed",d),Fe("Duration",u)),f("div",{class:"table",tabindex:"0",role:"region","aria-label":"what varies"},f("table",{},f("thead",{},f("tr",{},...["number","spread","","",""].map(L=>f("th",{scope:"col"},L)))),n)),s,D,f("div",{class:"form"},Fe("Design",r),Fe("Count",a),Fe("Seed",o),Fe("Metrics, with commas between",l)),f("div",{class:"form"},Fe("File of the study",p),Fe("Folder of the results",g),k,U),_),x(),await E(),A}async function ME(i,e,t){let n=e?await ol(e):null,s=t??String(n?.asked.out??""),r=await _n(`/api/sweep?${Qn({folder:s})}`),a=n?.title??`Sweep in ${s}`,o=f("p",{},f("a",{href:ft("studies")},"All studies"));if(!r.columns.length){i.replaceChildren(f("h1",{},a),o,f("p",{class:"empty"},"No variant is finished yet."));return}let l=new eu(r.columns),c=r.variants.length,{summary:h}=r,d=f("p",{class:"state",role:"status"}),u=f("tbody",{}),p=f("button",{type:"button"},"All variants");p.addEventListener("click",()=>l.clear());let g=()=>{let m=l.chosen.flatMap((x,E)=>x?[E]:[]);d.textContent=`${m.length} of ${c} variants`+(c<r.finished?` shown, of ${r.finished}`:"")+(l.picked>=0?`; variant ${r.variants[l.picked]} is marked`:"");let v=[...l.picked>=0?[l.picked]:[],...m.filter(x=>x!==l.picked)].slice(0,20);u.replaceChildren(...v.map(x=>{let E=f("button",{type:"button","aria-label":`mark variant ${r.variants[x]}`,"aria-pressed":String(x===l.picked)},String(r.variants[x]));return E.addEventListener("click",()=>l.pick(x===l.picked?-1:x)),f("tr",{},f("th",{scope:"row"},E),...r.columns.map(S=>f("td",{class:"right"},Ee(S.values[x]))),f("td",{},...r.run?[f("a",{href:EE(r,x),"aria-label":`open variant ${r.variants[x]} as a trial`},"open as a trial")]:[]))}))};l.listen(g),g();let _=r.columns.filter(m=>!m.is_number);i.replaceChildren(f("h1",{},a),o,f("p",{class:"muted"},`${r.finished} of ${r.count} variants are finished`,h&&h.ran<r.finished?`; ${r.finished-h.ran} have no run`:"","."),...Object.entries(h?.failed??{}).map(([m,v])=>f("p",{class:"problem"},`${v.variants} without a run (variant ${v.first} first): ${m}`)),...(h?.findings??[]).map(m=>f("p",{class:"muted"},`${m.severity}: ${m.message}`)),...h?.metrics.length?[f("h2",{},"Metrics"),wE(h,_)]:[],...h?.influences.length?[f("h2",{},"What they depend on"),..._.flatMap(m=>{let v=h.metrics.find(x=>x.name===m.name);return v?[j0(h.influences,m,v.mean)]:[]})]:[],f("h2",{},"Variants"),f("p",{class:"muted"},"Drag along an axis to keep the variants that pass there; a click on it lets all pass again."),Z0(l),f("div",{class:"bar"},d,p),J0(l),..._.length?[K0(l)]:[],f("div",{class:"table",tabindex:"0",role:"region","aria-label":"chosen variants"},f("table",{},f("caption",{},"The first of the chosen variants"),f("thead",{},f("tr",{},f("th",{scope:"col"},"variant"),...r.columns.map(m=>f("th",{scope:"col",class:"right"},`${m.name} [${m.unit||"–"}]`)),f("th",{scope:"col"},""))),u)),...n?[rr(n)]:[],...n?.has_page?[ll(`/api/jobs/${n.id}/report`,"Report")]:[])}function wE(i,e){let t=s=>e.find(r=>r.name===s)?.factor??1,n=s=>e.find(r=>r.name===s)?.unit||"–";return f("div",{class:"table",tabindex:"0",role:"region","aria-label":"metrics"},f("table",{},f("thead",{},f("tr",{},f("th",{scope:"col"},"metric"),f("th",{scope:"col"},"unit"),...["mean","standard deviation","least",...Object.keys(i.metrics[0].percentiles).map(s=>`${s} %`),"greatest"].map(s=>f("th",{scope:"col",class:"right"},s)))),f("tbody",{},...i.metrics.map(s=>f("tr",{},f("th",{scope:"row"},s.name),f("td",{},n(s.name)),...[s.mean,s.standard_deviation,s.least,...Object.values(s.percentiles).map(r=>r.value),s.greatest].map(r=>f("td",{class:"right"},Ee(r*t(s.name)))))))))}function EE(i,e){let t=i.run,n={},{speed:s,duration:r}=t;for(let a of i.columns){let o=a.values[e];!a.is_number||o===null||o===void 0||(a.name==="trial.speed"?s=`${o/a.factor} m/s`:a.name==="trial.duration"?r=`${o/a.factor} s`:!a.name.startsWith("trial.")&&!a.name.startsWith("control.")&&(n[a.name]=o/a.factor))}return typeof t.road=="string"?ft("ride",{vehicle:t.rig,road:t.road,speed:s,duration:r,set:JSON.stringify(n)}):ft("trial",{rig:t.rig,road:JSON.stringify(t.road),speed:s,duration:r,set:JSON.stringify(n)})}var Wa=320,gl=62,tu=40,nu=10,tv=14,iu=class{canvas=f("canvas",{role:"img"});across=f("select",{});upward=f("select",{});values=f("output",{});element=f("section",{class:"phase","aria-label":H("Phase plot")},f("h2",{},H("Phase plot")),f("div",{class:"form"},Fe(H("Across"),this.across),Fe(H("Upward"),this.upward),this.values),this.canvas);model=null;store=null;time=0;known="";constructor(){for(let e of[this.across,this.upward])e.addEventListener("change",()=>this.draw());new ResizeObserver(()=>this.draw()).observe(this.element),$n(()=>this.draw())}show(e,t){this.model=e,this.store=t;let n=e.scenes[0].panes.filter(s=>!s.name.startsWith("Δ")).map(s=>s.name);if(n.join()!==this.known){this.known=n.join();let s=[this.across.value,this.upward.value],r=["strut.deflection","strut.velocity"];[this.across,this.upward].forEach((a,o)=>{a.replaceChildren(...n.map(l=>f("option",{value:l},l))),a.value=[s[o],r[o],n[Math.min(o,n.length-1)]].find(l=>n.includes(l))??""})}this.draw()}mark(e){this.time=e,this.draw()}draw(){let e=Math.floor(this.element.clientWidth),t=this.model?.scenes[0],n=this.store;if(!t||!n||e<100)return;let[s,r]=[this.across,this.upward].map(x=>t.panes.find(E=>E.name===x.value));if(!s||!r)return;let a=Math.min(e,720),o=this.canvas.getContext("2d",{willReadFrequently:!0});this.canvas.width=a,this.canvas.height=Wa;let l=s.curves.flatMap(x=>{let E=r.curves.find(S=>S.role===x.role);return E?[{role:x.role,label:x.label,x:n.get(x.y),y:n.get(E.y)}]:[]}),[c,h]=nv(l.map(x=>x.x)),[d,u]=nv(l.map(x=>x.y)),p=n.get(t.x),g=x=>gl+(x-c)/(h-c)*(a-gl-tv),_=x=>nu+(u-x)/(u-d)*(Wa-nu-tu);o.font="12px system-ui, sans-serif",o.fillStyle=yt("muted"),o.strokeStyle=yt("line"),o.lineWidth=1,o.textAlign="center";for(let x of ul(c,h,6))o.beginPath(),o.moveTo(g(x),nu),o.lineTo(g(x),Wa-tu),o.stroke(),o.fillText(dl(x),g(x),Wa-tu+15);o.textAlign="right";for(let x of ul(d,u,5))o.beginPath(),o.moveTo(gl,_(x)),o.lineTo(a-tv,_(x)),o.stroke(),o.fillText(dl(x),gl-5,_(x)+4);o.fillStyle=yt("ink"),o.textAlign="center",o.fillText(`${s.name} [${s.unit||"–"}]`,.5*(gl+a),Wa-8),o.save(),o.translate(12,.5*(nu+Wa-tu)),o.rotate(-Math.PI/2),o.fillText(`${r.name} [${r.unit||"–"}]`,0,0),o.restore();for(let{role:x,x:E,y:S}of[...l].reverse()){o.strokeStyle=yt(x),o.lineWidth=1.4,o.beginPath();let R=!1;for(let A=0;A<E.length;A++){let k=E[A],U=S[A];if(k===null||U===null||k===void 0||U===void 0){R=!1;continue}R?o.lineTo(g(k),_(U)):o.moveTo(g(k),_(U)),R=!0}o.stroke();let w=wi(p,E,this.time),y=wi(p,S,this.time);Number.isFinite(w)&&Number.isFinite(y)&&(o.fillStyle=yt(x),o.beginPath(),o.arc(g(w),_(y),5,0,2*Math.PI),o.fill())}let m=l[0]?wi(p,l[0].x,this.time):NaN,v=l[0]?wi(p,l[0].y,this.time):NaN;this.values.textContent=`${Ee(m)} ${s.unit}, ${Ee(v)} ${r.unit}`,this.canvas.setAttribute("aria-label",`${r.name} ${H("over")} ${s.name}`)}};function nv(i){let e=1/0,t=-1/0;for(let s of i)for(let r=0;r<s.length;r++){let a=s[r];a!=null&&Number.isFinite(a)&&(a<e&&(e=a),a>t&&(t=a))}if(!(t>e))return[(Number.isFinite(e)?e:0)-1,(Number.isFinite(e)?e:0)+1];let n=.05*(t-e);return[e-n,t+n]}var sv={label:"Trial",show:AE},TE=["strut.spring.rate","strut.damper.coefficient","strut.damper.bump_coefficient","strut.damper.rebound_coefficient","tyre.stiffness","sprung.mass","unsprung.mass"];async function AE(i,e){let t=e.get("rig");if(!t){await lr(i,"trial",H("Trial"),"rig",!0,ar,e.get("record")?{record:e.get("record")}:{});return}let n=await Bs(t),s=f("select",{},...Object.keys(Or).map(R=>f("option",{value:R},H(R.replace("-"," "))))),r=f("span",{class:"sizes"}),a=iv(e.get("road"));a.kind&&a.kind in Or&&(s.value=a.kind);let o=f("input",{type:"text",value:e.get("speed")??(n.name.includes("kart")?"1.95 m/s":"30 km/h")}),l=f("input",{type:"text",value:e.get("duration")??"1.5 s"}),c=()=>r.replaceChildren(...Or[s.value].map(R=>{let w=f("input",{type:"text",value:a[R]??Zh[R],name:R});return w.addEventListener("change",()=>{m.ask()}),Fe(H(R[0].toUpperCase()+R.slice(1)),w)})),h=new Ba(n,TE,()=>{m.ask()},iv(e.get("set"))),d=()=>({rig:t,changes:h.changes,speed:o.value,duration:l.value,road:{kind:s.value,start:a.start??"0.2 m",...Object.fromEntries([...r.querySelectorAll("input")].map(R=>[R.name,R.value]))}}),{entries:u}=await ei(),p=f("select",{},...[["time",H("time")],["spectra",H("frequency (spectra)")]].map(([R,w])=>f("option",{value:R},w))),g=f("select",{},f("option",{value:""},H("none")),...u.filter(R=>R.kind==="record").map(({path:R})=>f("option",{value:R,...R===e.get("record")?{selected:!0}:{}},R))),_=f("input",{type:"text",value:"0 s"}),m=new Hh(()=>Jr("simulate",{...d(),spectra:p.value==="spectra",measured:g.value,begins:_.value})),v=new iu;m.shown=(R,w)=>{v.element.hidden=p.value!=="time",p.value==="time"&&v.show(R,w)},m.moved=R=>{p.value==="time"&&v.mark(R)};for(let R of[p,g,_])R.addEventListener("change",()=>{m.ask()});let x=f("input",{type:"text",value:`${t.replace(/\.toml$/,"").split("/").pop()} ${new Date().toISOString().slice(0,16).replace("T"," ").replace(":",".")}`}),E=f("span",{"aria-live":"polite"}),S=f("form",{class:"form"},Fe(H("Keep this run as"),x),f("button",{type:"submit"},H("Keep it")),E);S.addEventListener("submit",R=>{R.preventDefault(),On("POST","/api/keep",{...d(),title:x.value}).then(async w=>{let{path:y}=await w.json();E.replaceChildren(H("Kept as "),f("a",{href:ft("record",{path:y})},y),". ",f("a",{href:ft("project")},H("Compare it in the project")))},w=>E.replaceChildren(At(w)))}),s.addEventListener("change",()=>{c(),m.ask()});for(let R of[o,l])R.addEventListener("change",()=>{m.ask()});c(),or(m),i.replaceChildren(f("h1",{},H("# over an obstacle",t)),f("div",{class:"form"},Fe(H("Obstacle"),s),r,Fe(H("Speed"),o),Fe(H("Duration"),l),Fe(H("Curves over"),p),Fe(H("Beside a recording"),g),Fe(H("where it begins"),_)),h.element,m.element,v.element,f("h2",{},H("Keep this run")),S),await m.ask()}function iv(i){try{return JSON.parse(i??"{}")??{}}catch{return{}}}var vl={project:H0,rig:q0,trial:sv,kinematics:G0,record:X0,campaign:F0,studies:ev,jobs:k0};async function rv(){let[i="",e=""]=location.hash.replace(/^#\//,"").split("?"),t=i in vl?i:"project";or(null);let n=f("div",{},f("p",{class:"muted"},"loading …"));document.querySelectorAll("#pages a").forEach(s=>{s.dataset.page===t?s.setAttribute("aria-current","page"):s.removeAttribute("aria-current")}),document.title=`${vl[t].label} – jounce workbench`,document.getElementById("main").replaceChildren(n);try{await vl[t].show(n,new URLSearchParams(e))}catch(s){n.replaceChildren(f("h1",{},vl[t].label),At(s),f("p",{},f("a",{href:ft("project")},"Back to the project")))}n.isConnected&&(document.documentElement.dataset.ready=t)}document.documentElement.classList.add("live");document.getElementById("pages").append(...Object.entries(vl).map(([i,{label:e}])=>f("a",{href:ft(i),"data-page":i},e)));document.querySelector("header").append(Jf());addEventListener("hashchange",()=>{delete document.documentElement.dataset.ready,rv()});ei().then(({name:i})=>{document.getElementById("project").textContent=i},()=>{});rv();return Mv(CE);})();
