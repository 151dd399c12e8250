/*! This page holds these libraries:

three 0.187.0

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

---

uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

---

fflate 0.8.2

MIT License

Copyright (c) 2023 Arjun Barrett

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.

---

webm-muxer 5.1.4

MIT License

Copyright (c) 2022 Vanilagy

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
"use strict";(()=>{function re(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))r===!0?n.setAttribute(s,""):r!==!1&&n.setAttribute(s,String(r));return n.append(...t),n}function In(i,e,t={}){let n=re("button",{type:"button",...t},i);return n.addEventListener("click",e),n}var cx=0;function em(i,e,...t){return e.id||=`field-${++cx}`,re("div",{class:"field"},re("label",{for:e.id},i),...t,e)}function Ti(i,e,t){let n=re("select",{},...e.map(([s,r])=>re("option",{value:s},r)));return n.addEventListener("change",()=>t(n.value)),{element:em(i,n),select:n}}function ea(i,e,t,n){let s=re("input",{type:"range",...e}),r=re("output",{},t(e.value)),a=()=>{r.textContent=t(s.valueAsNumber),s.setAttribute("aria-valuetext",t(s.valueAsNumber)),n(s.valueAsNumber)};s.addEventListener("input",a);let o=em(i,s,r);return r.htmlFor.add(s.id),{element:o,input:s,set:c=>{s.value=String(c),a()}}}function li(i,e,t){let n=re("input",{type:"checkbox",checked:e});return n.addEventListener("change",()=>t(n.checked)),{element:re("label",{class:"tick"},n,i),input:n}}function ji(i,...e){return re("fieldset",{},re("legend",{},i),...e)}function ta(i,e){let t=re("a",{href:URL.createObjectURL(i),download:e});t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),1e4)}var js={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Qs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Rm=0,vf=1,Pm=2;var Ho=1,Im=2,Aa=3,er=0,Qn=1,ni=2,br=0,Ca=1,xf=2,yf=3,bf=4,Lm=5;var Sr=100,Dm=101,Nm=102,Um=103,Fm=104,Om=200,Bm=201,km=202,zm=203,Sf=204,Mf=205,Vm=206,Hm=207,Gm=208,Wm=209,Xm=210,qm=211,Ym=212,$m=213,Zm=214,oc=0,lc=1,cc=2,_a=3,hc=4,uc=5,fc=6,dc=7,wf=0,Km=1,Jm=2,ts=0,Ef=1,Tf=2,Af=3,Cf=4,Rf=5,Pf=6,If=7;var Lf=300,Mr=301,Ra=302,Vc=303,Hc=304,pc=1e3,es=1001,mc=1002,gn=1003,jm=1004;var Go=1005;var jn=1006,Gc=1007;var ws=1008;var _i=1009,Df=1010,Nf=1011,Pa=1012,Wc=1013,ki=1014,zi=1015,Vi=1016,Xc=1017,qc=1018,wr=1020,Uf=35902,Ff=35899,Of=1021,Bf=1022,vi=1023,Ss=1026,Es=1027,kf=1028,Yc=1029,tr=1030,$c=1031;var Zc=1033,Wo=33776,Xo=33777,qo=33778,Yo=33779,Kc=35840,Jc=35841,jc=35842,Qc=35843,eh=36196,th=37492,nh=37496,ih=37488,sh=37489,$o=37490,rh=37491,ah=37808,oh=37809,lh=37810,ch=37811,hh=37812,uh=37813,fh=37814,dh=37815,ph=37816,mh=37817,gh=37818,_h=37819,vh=37820,xh=37821,yh=36492,bh=36494,Sh=36495,Mh=36283,wh=36284,Zo=36285,Eh=36286;var wo=2300,gc=2301,rc=2302,uf=2303,ff=2400,df=2401,pf=2402;var Qm=3200;var zf=0,eg=1,Ts="",ui="srgb",Xs="srgb-linear",Eo="linear",Lt="srgb";var ac=7680;var tg=519,ng=512,ig=513,sg=514,Vf=515,rg=516,ag=517,Hf=518,Gf=519,og=35044,Wf=35048;var As="300 es",Ci=2e3,To=2001;function hx(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function ux(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ao(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function lg(){let i=Ao("canvas");return i.style.display="block",i}var tm={},va=null;function Xf(...i){let e="THREE."+i.shift();va?va("log",e,...i):console.log(e,...i)}function cg(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ke(...i){i=cg(i);let e="THREE."+i.shift();if(va)va("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function nt(...i){i=cg(i);let e="THREE."+i.shift();if(va)va("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function So(...i){let e=i.join(" ");e in tm||(tm[e]=!0,Ke(...i))}function hg(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var ug={[oc]:oc,[cc]:fc,[hc]:hc,[_a]:uc,[lc]:lc,[fc]:cc,[dc]:dc,[uc]:_a},Bi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],nm=1234567,ma=Math.PI/180,xa=180/Math.PI;function Ia(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(zn[i&255]+zn[i>>8&255]+zn[i>>16&255]+zn[i>>24&255]+"-"+zn[e&255]+zn[e>>8&255]+"-"+zn[e>>16&15|64]+zn[e>>24&255]+"-"+zn[t&63|128]+zn[t>>8&255]+"-"+zn[t>>16&255]+zn[t>>24&255]+zn[n&255]+zn[n>>8&255]+zn[n>>16&255]+zn[n>>24&255]).toLowerCase()}function vt(i,e,t){return Math.max(e,Math.min(t,i))}function qf(i,e){return(i%e+e)%e}function fx(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function dx(i,e,t){return i!==e?(t-i)/(e-i):0}function Mo(i,e,t){return(1-t)*i+t*e}function px(i,e,t,n){return Mo(i,e,1-Math.exp(-t*n))}function mx(i,e=1){return e-Math.abs(qf(i,e*2)-e)}function gx(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function _x(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function vx(i,e){return i+Math.floor(Math.random()*(e-i+1))}function xx(i,e){return i+Math.random()*(e-i)}function yx(i){return i*(.5-Math.random())}function bx(i){i!==void 0&&(nm=i);let e=nm+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Sx(i){return i*ma}function Mx(i){return i*xa}function wx(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Ex(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Yf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Tx(i,e,t,n,s){let r=Math.cos,a=Math.sin,o=r(t/2),l=a(t/2),c=r((e+n)/2),h=a((e+n)/2),u=r((e-n)/2),f=a((e-n)/2),d=r((n-e)/2),g=a((n-e)/2);switch(s){case"XYX":i.set(o*h,l*u,l*f,o*c);break;case"YZY":i.set(l*f,o*h,l*u,o*c);break;case"ZXZ":i.set(l*u,l*f,o*h,o*c);break;case"XZX":i.set(o*h,l*g,l*d,o*c);break;case"YXY":i.set(l*d,o*h,l*g,o*c);break;case"ZYZ":i.set(l*g,l*d,o*h,o*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function $f(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function fg(i,e){if(e.constructor===Float32Array)return i;let t=$f(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function dg(i,e){if(e.constructor===Float32Array)return i;let t=$f(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Zf={DEG2RAD:ma,RAD2DEG:xa,generateUUID:Ia,clamp:vt,euclideanModulo:qf,mapLinear:fx,inverseLerp:dx,lerp:Mo,damp:px,pingpong:mx,smoothstep:gx,smootherstep:_x,randInt:vx,randFloat:xx,randFloatSpread:yx,seededRandom:bx,degToRad:Sx,radToDeg:Mx,isPowerOfTwo:wx,ceilPowerOfTwo:Ex,floorPowerOfTwo:Yf,setQuaternionFromProperEuler:Tx,normalize:dg,denormalize:fg},it=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=vt(this.x,e.x,t.x),this.y=vt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=vt(this.x,e,t),this.y=vt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(vt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(vt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*n-a*s+e.x,this.y=r*s+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},fi=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,a,o){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],f=r[a+0],d=r[a+1],g=r[a+2],b=r[a+3];if(u!==b||l!==f||c!==d||h!==g){let p=l*f+c*d+h*g+u*b;p<0&&(f=-f,d=-d,g=-g,b=-b,p=-p);let m=1-o;if(p<.9995){let y=Math.acos(p),C=Math.sin(y);m=Math.sin(m*y)/C,o=Math.sin(o*y)/C,l=l*m+f*o,c=c*m+d*o,h=h*m+g*o,u=u*m+b*o}else{l=l*m+f*o,c=c*m+d*o,h=h*m+g*o,u=u*m+b*o;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,a){let o=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[a],f=r[a+1],d=r[a+2],g=r[a+3];return e[t]=o*g+h*u+l*d-c*f,e[t+1]=l*g+h*f+c*u-o*d,e[t+2]=c*g+h*d+o*f-l*u,e[t+3]=h*g-o*u-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(s/2),u=o(r/2),f=l(n/2),d=l(s/2),g=l(r/2);switch(a){case"XYZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"YXZ":this._x=f*h*u+c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"ZXY":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u-f*d*g;break;case"ZYX":this._x=f*h*u-c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u+f*d*g;break;case"YZX":this._x=f*h*u+c*d*g,this._y=c*d*u+f*h*g,this._z=c*h*g-f*d*u,this._w=c*h*u-f*d*g;break;case"XZY":this._x=f*h*u-c*d*g,this._y=c*d*u-f*h*g,this._z=c*h*g+f*d*u,this._w=c*h*u+f*d*g;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],u=t[10],f=n+o+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(a-s)*d}else if(n>o&&n>u){let d=2*Math.sqrt(1+n-o-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+a)/d,this._z=(r+c)/d}else if(o>u){let d=2*Math.sqrt(1+o-n-u);this._w=(r-c)/d,this._x=(s+a)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-n-o);this._w=(a-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(vt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-n*c,this._z=r*h+a*c+n*l-s*o,this._w=a*h-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(im.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(im.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*n),h=2*(o*t-r*s),u=2*(r*n-a*t);return this.x=t+l*c+a*u-o*h,this.y=n+l*h+o*c-r*u,this.z=s+l*u+r*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=vt(this.x,e.x,t.x),this.y=vt(this.y,e.y,t.y),this.z=vt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=vt(this.x,e,t),this.y=vt(this.y,e,t),this.z=vt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(vt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Gu.copy(this).projectOnVector(e),this.sub(Gu)}reflect(e){return this.sub(Gu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(vt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Gu=new X,im=new fi,rt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c)}set(e,t,n,s,r,a,o,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=o,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],u=n[7],f=n[2],d=n[5],g=n[8],b=s[0],p=s[3],m=s[6],y=s[1],C=s[4],w=s[7],I=s[2],T=s[5],v=s[8];return r[0]=a*b+o*y+l*I,r[3]=a*p+o*C+l*T,r[6]=a*m+o*w+l*v,r[1]=c*b+h*y+u*I,r[4]=c*p+h*C+u*T,r[7]=c*m+h*w+u*v,r[2]=f*b+d*y+g*I,r[5]=f*p+d*C+g*T,r[8]=f*m+d*w+g*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-n*r*h+n*o*l+s*r*c-s*a*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],u=h*a-o*c,f=o*l-h*r,d=c*r-a*l,g=t*u+n*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/g;return e[0]=u*b,e[1]=(s*c-h*n)*b,e[2]=(o*n-s*a)*b,e[3]=f*b,e[4]=(h*t-s*l)*b,e[5]=(s*r-o*t)*b,e[6]=d*b,e[7]=(n*l-c*t)*b,e[8]=(a*t-n*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return So("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Wu.makeScale(e,t)),this}rotate(e){return So("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Wu.makeRotation(-e)),this}translate(e,t){return So("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Wu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Wu=new rt,sm=new rt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),rm=new rt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ax(){let i={enabled:!0,workingColorSpace:Xs,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Lt&&(s.r=bs(s.r),s.g=bs(s.g),s.b=bs(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Lt&&(s.r=ga(s.r),s.g=ga(s.g),s.b=ga(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ts?Eo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Xs]:{primaries:e,whitePoint:n,transfer:Eo,toXYZ:sm,fromXYZ:rm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ui},outputColorSpaceConfig:{drawingBufferColorSpace:ui}},[ui]:{primaries:e,whitePoint:n,transfer:Lt,toXYZ:sm,fromXYZ:rm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ui}}}),i}var bt=Ax();function bs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ga(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var na,_c=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{na===void 0&&(na=Ao("canvas")),na.width=e.width,na.height=e.height;let s=na.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=na}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ao("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=bs(r[a]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(bs(t[n]/255)*255):t[n]=bs(t[n]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Cx=0,ya=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Cx++}),this.uuid=Ia(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(Xu(s[a].image)):r.push(Xu(s[a]))}else r=Xu(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Xu(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?_c.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var Rx=0,qu=new X,ti=class i extends Bi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=es,s=es,r=jn,a=ws,o=vi,l=_i,c=i.DEFAULT_ANISOTROPY,h=Ts){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Rx++}),this.uuid=Ia(),this.name="",this.source=new ya(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new it(0,0),this.repeat=new it(1,1),this.center=new it(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new rt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(qu).x}get height(){return this.source.getSize(qu).y}get depth(){return this.source.getSize(qu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Lf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case pc:e.x=e.x-Math.floor(e.x);break;case es:e.x=e.x<0?0:1;break;case mc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case pc:e.y=e.y-Math.floor(e.y);break;case es:e.y=e.y<0?0:1;break;case mc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ti.DEFAULT_IMAGE=null;ti.DEFAULT_MAPPING=Lf;ti.DEFAULT_ANISOTROPY=1;var Zt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*n+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],g=l[9],b=l[2],p=l[6],m=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-b)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+b)<.1&&Math.abs(g+p)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,w=(d+1)/2,I=(m+1)/2,T=(h+f)/4,v=(u+b)/4,E=(g+p)/4;return C>w&&C>I?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=T/n,r=v/n):w>I?w<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),n=T/s,r=E/s):I<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),n=v/r,s=E/r),this.set(n,s,r,t),this}let y=Math.sqrt((p-g)*(p-g)+(u-b)*(u-b)+(f-h)*(f-h));return Math.abs(y)<.001&&(y=1),this.x=(p-g)/y,this.y=(u-b)/y,this.z=(f-h)/y,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=vt(this.x,e.x,t.x),this.y=vt(this.y,e.y,t.y),this.z=vt(this.z,e.z,t.z),this.w=vt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=vt(this.x,e,t),this.y=vt(this.y,e,t),this.z=vt(this.z,e,t),this.w=vt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(vt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},vc=class extends Bi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Zt(0,0,e,t),this.scissorTest=!1,this.viewport=new Zt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ti({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:jn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ya(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},di=class extends vc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Co=class extends ti{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=gn,this.minFilter=gn,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var xc=class extends ti{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=gn,this.minFilter=gn,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Gt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,a,o,l,c,h,u,f,d,g,b,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c,h,u,f,d,g,b,p)}set(e,t,n,s,r,a,o,l,c,h,u,f,d,g,b,p){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=a,m[9]=o,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=f,m[3]=d,m[7]=g,m[11]=b,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/ia.setFromMatrixColumn(e,0).length(),r=1/ia.setFromMatrixColumn(e,1).length(),a=1/ia.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let f=a*h,d=a*u,g=o*h,b=o*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=d+g*c,t[5]=f-b*c,t[9]=-o*l,t[2]=b-f*c,t[6]=g+d*c,t[10]=a*l}else if(e.order==="YXZ"){let f=l*h,d=l*u,g=c*h,b=c*u;t[0]=f+b*o,t[4]=g*o-d,t[8]=a*c,t[1]=a*u,t[5]=a*h,t[9]=-o,t[2]=d*o-g,t[6]=b+f*o,t[10]=a*l}else if(e.order==="ZXY"){let f=l*h,d=l*u,g=c*h,b=c*u;t[0]=f-b*o,t[4]=-a*u,t[8]=g+d*o,t[1]=d+g*o,t[5]=a*h,t[9]=b-f*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let f=a*h,d=a*u,g=o*h,b=o*u;t[0]=l*h,t[4]=g*c-d,t[8]=f*c+b,t[1]=l*u,t[5]=b*c+f,t[9]=d*c-g,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let f=a*l,d=a*c,g=o*l,b=o*c;t[0]=l*h,t[4]=b-f*u,t[8]=g*u+d,t[1]=u,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=d*u+g,t[10]=f-b*u}else if(e.order==="XZY"){let f=a*l,d=a*c,g=o*l,b=o*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=f*u+b,t[5]=a*h,t[9]=d*u-g,t[2]=g*u-d,t[6]=o*h,t[10]=b*u+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Px,e,Ix)}lookAt(e,t,n){let s=this.elements;return ci.subVectors(e,t),ci.lengthSq()===0&&(ci.z=1),ci.normalize(),zs.crossVectors(n,ci),zs.lengthSq()===0&&(Math.abs(n.z)===1?ci.x+=1e-4:ci.z+=1e-4,ci.normalize(),zs.crossVectors(n,ci)),zs.normalize(),Nl.crossVectors(ci,zs),s[0]=zs.x,s[4]=Nl.x,s[8]=ci.x,s[1]=zs.y,s[5]=Nl.y,s[9]=ci.y,s[2]=zs.z,s[6]=Nl.z,s[10]=ci.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],u=n[5],f=n[9],d=n[13],g=n[2],b=n[6],p=n[10],m=n[14],y=n[3],C=n[7],w=n[11],I=n[15],T=s[0],v=s[4],E=s[8],V=s[12],U=s[1],D=s[5],G=s[9],W=s[13],N=s[2],H=s[6],K=s[10],z=s[14],he=s[3],J=s[7],Q=s[11],se=s[15];return r[0]=a*T+o*U+l*N+c*he,r[4]=a*v+o*D+l*H+c*J,r[8]=a*E+o*G+l*K+c*Q,r[12]=a*V+o*W+l*z+c*se,r[1]=h*T+u*U+f*N+d*he,r[5]=h*v+u*D+f*H+d*J,r[9]=h*E+u*G+f*K+d*Q,r[13]=h*V+u*W+f*z+d*se,r[2]=g*T+b*U+p*N+m*he,r[6]=g*v+b*D+p*H+m*J,r[10]=g*E+b*G+p*K+m*Q,r[14]=g*V+b*W+p*z+m*se,r[3]=y*T+C*U+w*N+I*he,r[7]=y*v+C*D+w*H+I*J,r[11]=y*E+C*G+w*K+I*Q,r[15]=y*V+C*W+w*z+I*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],u=e[6],f=e[10],d=e[14],g=e[3],b=e[7],p=e[11],m=e[15],y=l*d-c*f,C=o*d-c*u,w=o*f-l*u,I=a*d-c*h,T=a*f-l*h,v=a*u-o*h;return t*(b*y-p*C+m*w)-n*(g*y-p*I+m*T)+s*(g*C-b*I+m*v)-r*(g*w-b*T+p*v)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],h=e[10];return t*(a*h-o*c)-n*(r*h-o*l)+s*(r*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],u=e[9],f=e[10],d=e[11],g=e[12],b=e[13],p=e[14],m=e[15],y=t*o-n*a,C=t*l-s*a,w=t*c-r*a,I=n*l-s*o,T=n*c-r*o,v=s*c-r*l,E=h*b-u*g,V=h*p-f*g,U=h*m-d*g,D=u*p-f*b,G=u*m-d*b,W=f*m-d*p,N=y*W-C*G+w*D+I*U-T*V+v*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/N;return e[0]=(o*W-l*G+c*D)*H,e[1]=(s*G-n*W-r*D)*H,e[2]=(b*v-p*T+m*I)*H,e[3]=(f*T-u*v-d*I)*H,e[4]=(l*U-a*W-c*V)*H,e[5]=(t*W-s*U+r*V)*H,e[6]=(p*w-g*v-m*C)*H,e[7]=(h*v-f*w+d*C)*H,e[8]=(a*G-o*U+c*E)*H,e[9]=(n*U-t*G-r*E)*H,e[10]=(g*T-b*w+m*y)*H,e[11]=(u*w-h*T-d*y)*H,e[12]=(o*V-a*D-l*E)*H,e[13]=(t*D-n*V+s*E)*H,e[14]=(b*C-g*I-p*y)*H,e[15]=(h*I-u*C+f*y)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,a=e.x,o=e.y,l=e.z,c=r*a,h=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+n,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,a){return this.set(1,n,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,h=a+a,u=o+o,f=r*c,d=r*h,g=r*u,b=a*h,p=a*u,m=o*u,y=l*c,C=l*h,w=l*u,I=n.x,T=n.y,v=n.z;return s[0]=(1-(b+m))*I,s[1]=(d+w)*I,s[2]=(g-C)*I,s[3]=0,s[4]=(d-w)*T,s[5]=(1-(f+m))*T,s[6]=(p+y)*T,s[7]=0,s[8]=(g+C)*v,s[9]=(p-y)*v,s[10]=(1-(f+b))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let a=ia.set(s[0],s[1],s[2]).length(),o=ia.set(s[4],s[5],s[6]).length(),l=ia.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Ui.copy(this);let c=1/a,h=1/o,u=1/l;return Ui.elements[0]*=c,Ui.elements[1]*=c,Ui.elements[2]*=c,Ui.elements[4]*=h,Ui.elements[5]*=h,Ui.elements[6]*=h,Ui.elements[8]*=u,Ui.elements[9]*=u,Ui.elements[10]*=u,t.setFromRotationMatrix(Ui),n.x=a,n.y=o,n.z=l,this}makePerspective(e,t,n,s,r,a,o=Ci,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),f=(t+e)/(t-e),d=(n+s)/(n-s),g,b;if(l)g=r/(a-r),b=a*r/(a-r);else if(o===Ci)g=-(a+r)/(a-r),b=-2*a*r/(a-r);else if(o===To)g=-a/(a-r),b=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,a,o=Ci,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),f=-(t+e)/(t-e),d=-(n+s)/(n-s),g,b;if(l)g=1/(a-r),b=a/(a-r);else if(o===Ci)g=-2/(a-r),b=-(a+r)/(a-r);else if(o===To)g=-1/(a-r),b=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},ia=new X,Ui=new Gt,Px=new X(0,0,0),Ix=new X(1,1,1),zs=new X,Nl=new X,ci=new X,am=new Gt,om=new fi,qs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(vt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-vt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(vt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-vt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(vt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(o,d));break;case"XZY":this._z=Math.asin(-vt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return am.makeRotationFromQuaternion(e),this.setFromRotationMatrix(am,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return om.setFromEuler(this),this.setFromQuaternion(om,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};qs.DEFAULT_ORDER="XYZ";var ba=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Lx=0,lm=new X,sa=new fi,ps=new Gt,Ul=new X,_o=new X,Dx=new X,Nx=new fi,cm=new X(1,0,0),hm=new X(0,1,0),um=new X(0,0,1),fm={type:"added"},Ux={type:"removed"},ra={type:"childadded",child:null},Yu={type:"childremoved",child:null},pi=class i extends Bi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Lx++}),this.uuid=Ia(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new X,t=new qs,n=new fi,s=new X(1,1,1);function r(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Gt},normalMatrix:{value:new rt}}),this.matrix=new Gt,this.matrixWorld=new Gt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ba,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return sa.setFromAxisAngle(e,t),this.quaternion.multiply(sa),this}rotateOnWorldAxis(e,t){return sa.setFromAxisAngle(e,t),this.quaternion.premultiply(sa),this}rotateX(e){return this.rotateOnAxis(cm,e)}rotateY(e){return this.rotateOnAxis(hm,e)}rotateZ(e){return this.rotateOnAxis(um,e)}translateOnAxis(e,t){return lm.copy(e).applyQuaternion(this.quaternion),this.position.add(lm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(cm,e)}translateY(e){return this.translateOnAxis(hm,e)}translateZ(e){return this.translateOnAxis(um,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ps.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ul.copy(e):Ul.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),_o.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ps.lookAt(_o,Ul,this.up):ps.lookAt(Ul,_o,this.up),this.quaternion.setFromRotationMatrix(ps),s&&(ps.extractRotation(s.matrixWorld),sa.setFromRotationMatrix(ps),this.quaternion.premultiply(sa.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(fm),ra.child=e,this.dispatchEvent(ra),ra.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Ux),Yu.child=e,this.dispatchEvent(Yu),Yu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ps.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ps.multiply(e.parent.matrixWorld)),e.applyMatrix4(ps),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(fm),ra.child=e,this.dispatchEvent(ra),ra.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_o,e,Dx),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_o,Nx,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),u=a(e.shapes),f=a(e.skeletons),d=a(e.animations),g=a(e.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};pi.DEFAULT_UP=new X(0,1,0);pi.DEFAULT_MATRIX_AUTO_UPDATE=!0;pi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ys=class extends pi{constructor(){super(),this.isGroup=!0,this.type="Group"}},Fx={type:"move"},Sa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ys,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ys,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ys,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let b of e.hand.values()){let p=t.getJointPose(b,n),m=this._getHandJoint(c,b);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(Fx)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new ys;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},pg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vs={h:0,s:0,l:0},Fl={h:0,s:0,l:0};function $u(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var St=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ui){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,bt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=bt.workingColorSpace){return this.r=e,this.g=t,this.b=n,bt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=bt.workingColorSpace){if(e=qf(e,1),t=vt(t,0,1),n=vt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,a=2*n-r;this.r=$u(a,r,e+1/3),this.g=$u(a,r,e),this.b=$u(a,r,e-1/3)}return bt.colorSpaceToWorking(this,s),this}setStyle(e,t=ui){function n(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ui){let n=pg[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=bs(e.r),this.g=bs(e.g),this.b=bs(e.b),this}copyLinearToSRGB(e){return this.r=ga(e.r),this.g=ga(e.g),this.b=ga(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ui){return bt.workingToColorSpace(Vn.copy(this),e),Math.round(vt(Vn.r*255,0,255))*65536+Math.round(vt(Vn.g*255,0,255))*256+Math.round(vt(Vn.b*255,0,255))}getHexString(e=ui){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=bt.workingColorSpace){bt.workingToColorSpace(Vn.copy(this),t);let n=Vn.r,s=Vn.g,r=Vn.b,a=Math.max(n,s,r),o=Math.min(n,s,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let u=a-o;switch(c=h<=.5?u/(a+o):u/(2-a-o),a){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=bt.workingColorSpace){return bt.workingToColorSpace(Vn.copy(this),t),e.r=Vn.r,e.g=Vn.g,e.b=Vn.b,e}getStyle(e=ui){bt.workingToColorSpace(Vn.copy(this),e);let t=Vn.r,n=Vn.g,s=Vn.b;return e!==ui?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Vs),this.setHSL(Vs.h+e,Vs.s+t,Vs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Vs),e.getHSL(Fl);let n=Mo(Vs.h,Fl.h,t),s=Mo(Vs.s,Fl.s,t),r=Mo(Vs.l,Fl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Vn=new St;St.NAMES=pg;var Ro=class extends pi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new qs,this.environmentIntensity=1,this.environmentRotation=new qs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Fi=new X,ms=new X,Zu=new X,gs=new X,aa=new X,oa=new X,dm=new X,Ku=new X,Ju=new X,ju=new X,Qu=new Zt,ef=new Zt,tf=new Zt,xs=class i{constructor(e=new X,t=new X,n=new X){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Fi.subVectors(e,t),s.cross(Fi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Fi.subVectors(s,t),ms.subVectors(n,t),Zu.subVectors(e,t);let a=Fi.dot(Fi),o=Fi.dot(ms),l=Fi.dot(Zu),c=ms.dot(ms),h=ms.dot(Zu),u=a*c-o*o;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-o*h)*f,g=(a*h-o*l)*f;return r.set(1-d-g,g,d)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,gs)===null?!1:gs.x>=0&&gs.y>=0&&gs.x+gs.y<=1}static getInterpolation(e,t,n,s,r,a,o,l){return this.getBarycoord(e,t,n,s,gs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,gs.x),l.addScaledVector(a,gs.y),l.addScaledVector(o,gs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,a){return Qu.setScalar(0),ef.setScalar(0),tf.setScalar(0),Qu.fromBufferAttribute(e,t),ef.fromBufferAttribute(e,n),tf.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Qu,r.x),a.addScaledVector(ef,r.y),a.addScaledVector(tf,r.z),a}static isFrontFacing(e,t,n,s){return Fi.subVectors(n,t),ms.subVectors(e,t),Fi.cross(ms).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Fi.subVectors(this.c,this.b),ms.subVectors(this.a,this.b),Fi.cross(ms).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,a,o;aa.subVectors(s,n),oa.subVectors(r,n),Ku.subVectors(e,n);let l=aa.dot(Ku),c=oa.dot(Ku);if(l<=0&&c<=0)return t.copy(n);Ju.subVectors(e,s);let h=aa.dot(Ju),u=oa.dot(Ju);if(h>=0&&u<=h)return t.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),t.copy(n).addScaledVector(aa,a);ju.subVectors(e,r);let d=aa.dot(ju),g=oa.dot(ju);if(g>=0&&d<=g)return t.copy(r);let b=d*c-l*g;if(b<=0&&c>=0&&g<=0)return o=c/(c-g),t.copy(n).addScaledVector(oa,o);let p=h*g-d*u;if(p<=0&&u-h>=0&&d-g>=0)return dm.subVectors(r,s),o=(u-h)/(u-h+(d-g)),t.copy(s).addScaledVector(dm,o);let m=1/(p+b+f);return a=b*m,o=f*m,t.copy(n).addScaledVector(aa,a).addScaledVector(oa,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ri=class{constructor(e=new X(1/0,1/0,1/0),t=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Oi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Oi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Oi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,Oi):Oi.fromBufferAttribute(r,a),Oi.applyMatrix4(e.matrixWorld),this.expandByPoint(Oi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ol.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ol.copy(n.boundingBox)),Ol.applyMatrix4(e.matrixWorld),this.union(Ol)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Oi),Oi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(vo),Bl.subVectors(this.max,vo),la.subVectors(e.a,vo),ca.subVectors(e.b,vo),ha.subVectors(e.c,vo),Hs.subVectors(ca,la),Gs.subVectors(ha,ca),dr.subVectors(la,ha);let t=[0,-Hs.z,Hs.y,0,-Gs.z,Gs.y,0,-dr.z,dr.y,Hs.z,0,-Hs.x,Gs.z,0,-Gs.x,dr.z,0,-dr.x,-Hs.y,Hs.x,0,-Gs.y,Gs.x,0,-dr.y,dr.x,0];return!nf(t,la,ca,ha,Bl)||(t=[1,0,0,0,1,0,0,0,1],!nf(t,la,ca,ha,Bl))?!1:(kl.crossVectors(Hs,Gs),t=[kl.x,kl.y,kl.z],nf(t,la,ca,ha,Bl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Oi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Oi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(_s[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),_s[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),_s[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),_s[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),_s[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),_s[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),_s[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),_s[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(_s),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},_s=[new X,new X,new X,new X,new X,new X,new X,new X],Oi=new X,Ol=new Ri,la=new X,ca=new X,ha=new X,Hs=new X,Gs=new X,dr=new X,vo=new X,Bl=new X,kl=new X,pr=new X;function nf(i,e,t,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){pr.fromArray(i,r);let o=s.x*Math.abs(pr.x)+s.y*Math.abs(pr.y)+s.z*Math.abs(pr.z),l=e.dot(pr),c=t.dot(pr),h=n.dot(pr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var mn=new X,zl=new it,Ox=0,Fn=class extends Bi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ox++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=og,this.updateRanges=[],this.gpuType=zi,this.version=0,this._normalizationScale=e!==void 0?$f(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)zl.fromBufferAttribute(this,t),zl.applyMatrix3(e),this.setXY(t,zl.x,zl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix3(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix4(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyNormalMatrix(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.transformDirection(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):fg(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):dg(e,this.array)}};var Po=class extends Fn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Io=class extends Fn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Jn=class extends Fn{constructor(e,t,n){super(new Float32Array(e),t,n)}},Bx=new Ri,xo=new X,sf=new X,_r=class{constructor(e=new X,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Bx.setFromPoints(e).getCenter(n);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;xo.subVectors(e,this.center);let t=xo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(xo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(sf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(xo.copy(e.center).add(sf)),this.expandByPoint(xo.copy(e.center).sub(sf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},kx=0,Ai=new Gt,rf=new pi,ua=new X,hi=new Ri,yo=new Ri,Ln=new X,mi=class i extends Bi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:kx++}),this.uuid=Ia(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(hx(e)?Io:Po)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new rt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ai.makeRotationFromQuaternion(e),this.applyMatrix4(Ai),this}rotateX(e){return Ai.makeRotationX(e),this.applyMatrix4(Ai),this}rotateY(e){return Ai.makeRotationY(e),this.applyMatrix4(Ai),this}rotateZ(e){return Ai.makeRotationZ(e),this.applyMatrix4(Ai),this}translate(e,t,n){return Ai.makeTranslation(e,t,n),this.applyMatrix4(Ai),this}scale(e,t,n){return Ai.makeScale(e,t,n),this.applyMatrix4(Ai),this}lookAt(e){return rf.lookAt(e),rf.updateMatrix(),this.applyMatrix4(rf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ua).negate(),this.translate(ua.x,ua.y,ua.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new Jn(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ri);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];hi.setFromBufferAttribute(r),this.morphTargetsRelative?(Ln.addVectors(this.boundingBox.min,hi.min),this.boundingBox.expandByPoint(Ln),Ln.addVectors(this.boundingBox.max,hi.max),this.boundingBox.expandByPoint(Ln)):(this.boundingBox.expandByPoint(hi.min),this.boundingBox.expandByPoint(hi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new _r);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(e){let n=this.boundingSphere.center;if(hi.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];yo.setFromBufferAttribute(o),this.morphTargetsRelative?(Ln.addVectors(hi.min,yo.min),hi.expandByPoint(Ln),Ln.addVectors(hi.max,yo.max),hi.expandByPoint(Ln)):(hi.expandByPoint(yo.min),hi.expandByPoint(yo.max))}hi.getCenter(n);let s=0;for(let r=0,a=e.count;r<a;r++)Ln.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Ln));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)Ln.fromBufferAttribute(o,c),l&&(ua.fromBufferAttribute(e,c),Ln.add(ua)),s=Math.max(s,n.distanceToSquared(Ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new Fn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(n.count);for(let V=0;V<n.count;V++)o[V]=new X,l[V]=new X;let h=new X,u=new X,f=new X,d=new it,g=new it,b=new it,p=new X,m=new X;function y(V,U,D){c[V]=c[U]=c[D]=1,h.fromBufferAttribute(n,V),u.fromBufferAttribute(n,U),f.fromBufferAttribute(n,D),d.fromBufferAttribute(r,V),g.fromBufferAttribute(r,U),b.fromBufferAttribute(r,D),u.sub(h),f.sub(h),g.sub(d),b.sub(d);let G=1/(g.x*b.y-b.x*g.y);isFinite(G)&&(p.copy(u).multiplyScalar(b.y).addScaledVector(f,-g.y).multiplyScalar(G),m.copy(f).multiplyScalar(g.x).addScaledVector(u,-b.x).multiplyScalar(G),o[V].add(p),o[U].add(p),o[D].add(p),l[V].add(m),l[U].add(m),l[D].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let V=0,U=C.length;V<U;++V){let D=C[V],G=D.start,W=D.count;for(let N=G,H=G+W;N<H;N+=3)y(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let w=new X,I=new X,T=new X,v=new X;function E(V){T.fromBufferAttribute(s,V),v.copy(T);let U=o[V];w.copy(U),w.sub(T.multiplyScalar(T.dot(U))).normalize(),I.crossVectors(v,U);let G=I.dot(l[V])<0?-1:1;a.setXYZW(V,w.x,w.y,w.z,G)}for(let V=0,U=n.count;V<U;++V)c[V]&&E(V);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Fn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let s=new X,r=new X,a=new X,o=new X,l=new X,c=new X,h=new X,u=new X;if(e)for(let f=0,d=e.count;f<d;f+=3){let g=e.getX(f+0),b=e.getX(f+1),p=e.getX(f+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,b),a.fromBufferAttribute(t,p),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),o.fromBufferAttribute(n,g),l.fromBufferAttribute(n,b),c.fromBufferAttribute(n,p),o.add(h),l.add(h),c.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(b,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),a.fromBufferAttribute(t,f+2),h.subVectors(a,r),u.subVectors(s,r),h.cross(u),n.setXYZ(f+0,h.x,h.y,h.z),n.setXYZ(f+1,h.x,h.y,h.z),n.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Ln.fromBufferAttribute(e,t),Ln.normalize(),e.setXYZ(t,Ln.x,Ln.y,Ln.z)}toNonIndexed(){function e(o,l){let c=o.array,h=o.itemSize,u=o.normalized,f=new c.constructor(l.length*h),d=0,g=0;for(let b=0,p=l.length;b<p;b++){o.isInterleavedBufferAttribute?d=l[b]*o.data.stride+o.offset:d=l[b]*h;for(let m=0;m<h;m++)f[g++]=c[d++]}return new Fn(f,h,u)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=e(l,n);t.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=e(f,n);l.push(d)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,h=a.length;c<h;c++){let u=a[c];this.addGroup(u.start,u.count,u.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var af=new X,zx=new X,Vx=new rt,Zn=class{constructor(e=new X(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=af.subVectors(n,t).cross(zx.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(af),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Vx.getNormalMatrix(e),s=this.coplanarPoint(af).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Hx=0,Ys=class extends Bi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Hx++}),this.uuid=Ia(),this.name="",this.type="Material",this.blending=Ca,this.side=er,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Sf,this.blendDst=Mf,this.blendEquation=Sr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new St(0,0,0),this.blendAlpha=0,this.depthFunc=_a,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=tg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ac,this.stencilZFail=ac,this.stencilZPass=ac,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new St().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Zn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new it().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new it().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var vs=new X,of=new X,Vl=new X,Hl=new X,$s=class{constructor(e=new X,t=new X(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,vs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=vs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(vs.copy(this.origin).addScaledVector(this.direction,t),vs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){of.copy(e).add(t).multiplyScalar(.5),Vl.copy(t).sub(e).normalize(),Hl.copy(this.origin).sub(of);let r=e.distanceTo(t)*.5,a=-this.direction.dot(Vl),o=Hl.dot(this.direction),l=-Hl.dot(Vl),c=Hl.lengthSq(),h=Math.abs(1-a*a),u,f,d,g;if(h>0)if(u=a*l-o,f=a*o-l,g=r*h,u>=0)if(f>=-g)if(f<=g){let b=1/h;u*=b,f*=b,d=u*(u+a*f+2*o)+f*(a*u+f+2*l)+c}else f=r,u=Math.max(0,-(a*f+o)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(a*f+o)),d=-u*u+f*(f+2*l)+c;else f<=-g?(u=Math.max(0,-(-a*r+o)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=g?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(a*r+o)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=a>0?-r:r,u=Math.max(0,-(a*f+o)),d=-u*u+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(of).addScaledVector(Vl,f),d}intersectSphere(e,t){if(e.radius<0)return null;vs.subVectors(e.center,this.origin);let n=vs.dot(this.direction),s=vs.dot(vs)-n*n,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),h>=0?(r=(e.min.y-f.y)*h,a=(e.max.y-f.y)*h):(r=(e.max.y-f.y)*h,a=(e.min.y-f.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),u>=0?(o=(e.min.z-f.z)*u,l=(e.max.z-f.z)*u):(o=(e.max.z-f.z)*u,l=(e.min.z-f.z)*u),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,vs)!==null}intersectTriangle(e,t,n,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,u=e.x-a.x,f=e.y-a.y,d=e.z-a.z,g=t.x-a.x,b=t.y-a.y,p=t.z-a.z,m=n.x-a.x,y=n.y-a.y,C=n.z-a.z,w=Math.abs(l),I=Math.abs(c),T=Math.abs(h),v,E,V,U,D,G,W,N,H,K,z,he;if(w>=I&&w>=T?(V=l,G=u,H=g,he=m,l>=0?(v=c,E=h,U=f,D=d,W=b,N=p,K=y,z=C):(v=h,E=c,U=d,D=f,W=p,N=b,K=C,z=y)):I>=T?(V=c,G=f,H=b,he=y,c>=0?(v=h,E=l,U=d,D=u,W=p,N=g,K=C,z=m):(v=l,E=h,U=u,D=d,W=g,N=p,K=m,z=C)):(V=h,G=d,H=p,he=C,h>=0?(v=l,E=c,U=u,D=f,W=g,N=b,K=m,z=y):(v=c,E=l,U=f,D=u,W=b,N=g,K=y,z=m)),V===0)return null;let J=v/V,Q=E/V,se=1/V,de=U-J*G,fe=D-Q*G,ee=W-J*H,ge=N-Q*H,xe=K-J*he,Ce=z-Q*he,Me=xe*ge-Ce*ee,Ye=de*Ce-fe*xe,lt=ee*fe-ge*de;if(s){if(Me<0||Ye<0||lt<0)return null}else if((Me<0||Ye<0||lt<0)&&(Me>0||Ye>0||lt>0))return null;let Xe=Me+Ye+lt;if(Xe===0)return null;let mt=se*(Me*G+Ye*H+lt*he);return(Xe>0?mt<0:mt>0)?null:this.at(mt/Xe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},yc=class extends Ys{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new St(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new qs,this.combine=wf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},pm=new Gt,mr=new $s,Gl=new _r,mm=new X,Wl=new X,Xl=new X,ql=new X,lf=new X,Yl=new X,gm=new X,$l=new X,Hn=class extends pi{constructor(e=new mi,t=new yc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){Yl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],u=r[l];h!==0&&(lf.fromBufferAttribute(u,e),a?Yl.addScaledVector(lf,h):Yl.addScaledVector(lf.sub(t),h))}t.add(Yl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Gl.copy(n.boundingSphere),Gl.applyMatrix4(r),mr.copy(e.ray).recast(e.near),!(Gl.containsPoint(mr.origin)===!1&&(mr.intersectSphere(Gl,mm)===null||mr.origin.distanceToSquared(mm)>(e.far-e.near)**2))&&(pm.copy(r).invert(),mr.copy(e.ray).applyMatrix4(pm),!(n.boundingBox!==null&&mr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,mr)))}_computeIntersections(e,t,n){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,b=f.length;g<b;g++){let p=f[g],m=a[p.materialIndex],y=Math.max(p.start,d.start),C=Math.min(o.count,Math.min(p.start+p.count,d.start+d.count));for(let w=y,I=C;w<I;w+=3){let T=o.getX(w),v=o.getX(w+1),E=o.getX(w+2);s=Zl(this,m,e,n,c,h,u,T,v,E),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,d.start),b=Math.min(o.count,d.start+d.count);for(let p=g,m=b;p<m;p+=3){let y=o.getX(p),C=o.getX(p+1),w=o.getX(p+2);s=Zl(this,a,e,n,c,h,u,y,C,w),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let g=0,b=f.length;g<b;g++){let p=f[g],m=a[p.materialIndex],y=Math.max(p.start,d.start),C=Math.min(l.count,Math.min(p.start+p.count,d.start+d.count));for(let w=y,I=C;w<I;w+=3){let T=w,v=w+1,E=w+2;s=Zl(this,m,e,n,c,h,u,T,v,E),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,d.start),b=Math.min(l.count,d.start+d.count);for(let p=g,m=b;p<m;p+=3){let y=p,C=p+1,w=p+2;s=Zl(this,a,e,n,c,h,u,y,C,w),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function Gx(i,e,t,n,s,r,a,o){let l;if(e.side===Qn?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,e.side===er,o),l===null)return null;$l.copy(o),$l.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo($l);return c<t.near||c>t.far?null:{distance:c,point:$l.clone(),object:i}}function Zl(i,e,t,n,s,r,a,o,l,c){i.getVertexPosition(o,Wl),i.getVertexPosition(l,Xl),i.getVertexPosition(c,ql);let h=Gx(i,e,t,n,Wl,Xl,ql,gm);if(h){let u=new X;xs.getBarycoord(gm,Wl,Xl,ql,u),s&&(h.uv=xs.getInterpolatedAttribute(s,o,l,c,u,new it)),r&&(h.uv1=xs.getInterpolatedAttribute(r,o,l,c,u,new it)),a&&(h.normal=xs.getInterpolatedAttribute(a,o,l,c,u,new X),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let f={a:o,b:l,c,normal:new X,materialIndex:0};xs.getNormal(Wl,Xl,ql,f.normal),h.face=f,h.barycoord=u}return h}var Ma=class extends ti{constructor(e=null,t=1,n=1,s,r,a,o,l,c=gn,h=gn,u,f){super(null,a,o,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var vr=class extends Fn{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var gr=new _r,Wx=new it(.5,.5),Kl=new X,xr=class{constructor(e=new Zn,t=new Zn,n=new Zn,s=new Zn,r=new Zn,a=new Zn){this.planes=[e,t,n,s,r,a]}set(e,t,n,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ci,n=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],g=r[8],b=r[9],p=r[10],m=r[11],y=r[12],C=r[13],w=r[14],I=r[15];if(s[0].setComponents(c-a,d-h,m-g,I-y).normalize(),s[1].setComponents(c+a,d+h,m+g,I+y).normalize(),s[2].setComponents(c+o,d+u,m+b,I+C).normalize(),s[3].setComponents(c-o,d-u,m-b,I-C).normalize(),n)s[4].setComponents(l,f,p,w).normalize(),s[5].setComponents(c-l,d-f,m-p,I-w).normalize();else if(s[4].setComponents(c-l,d-f,m-p,I-w).normalize(),t===Ci)s[5].setComponents(c+l,d+f,m+p,I+w).normalize();else if(t===To)s[5].setComponents(l,f,p,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),gr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),gr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(gr)}intersectsSprite(e){gr.center.set(0,0,0);let t=Wx.distanceTo(e.center);return gr.radius=.7071067811865476+t,gr.applyMatrix4(e.matrixWorld),this.intersectsSphere(gr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Kl.x=s.normal.x>0?e.max.x:e.min.x,Kl.y=s.normal.y>0?e.max.y:e.min.y,Kl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Kl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},_m=new Gt,bc=class i{constructor(){this.coordinateSystem=Ci,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];_m.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new xr),n[s].setFromProjectionMatrix(_m,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new xr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Sc=class extends Ys{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new St(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Mc=new X,wc=new X,vm=new Gt,bo=new $s,Jl=new _r,cf=new X,xm=new X,Ec=class extends pi{constructor(e=new mi,t=new Sc){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Mc.fromBufferAttribute(t,s-1),wc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Mc.distanceTo(wc);e.setAttribute("lineDistance",new Jn(n,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Jl.copy(n.boundingSphere),Jl.applyMatrix4(s),Jl.radius+=r,e.ray.intersectsSphere(Jl)===!1)return;vm.copy(s).invert(),bo.copy(e.ray).applyMatrix4(vm);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=n.index,f=n.attributes.position;if(h!==null){let d=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let b=d,p=g-1;b<p;b+=c){let m=h.getX(b),y=h.getX(b+1),C=jl(this,e,bo,l,m,y,b);C&&t.push(C)}if(this.isLineLoop){let b=h.getX(g-1),p=h.getX(d),m=jl(this,e,bo,l,b,p,g-1);m&&t.push(m)}}else{let d=Math.max(0,a.start),g=Math.min(f.count,a.start+a.count);for(let b=d,p=g-1;b<p;b+=c){let m=jl(this,e,bo,l,b,b+1,b);m&&t.push(m)}if(this.isLineLoop){let b=jl(this,e,bo,l,g-1,d,g-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function jl(i,e,t,n,s,r,a){let o=i.geometry.attributes.position;if(Mc.fromBufferAttribute(o,s),wc.fromBufferAttribute(o,r),t.distanceSqToSegment(Mc,wc,cf,xm)>n)return;cf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(cf);if(!(c<e.near||c>e.far))return{distance:c,point:xm.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var ym=new X,bm=new X,Lo=class extends Ec{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)ym.fromBufferAttribute(t,s),bm.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+ym.distanceTo(bm);e.setAttribute("lineDistance",new Jn(n,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Do=class extends ti{constructor(e=[],t=Mr,n,s,r,a,o,l,c,h){super(e,t,n,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ms=class extends ti{constructor(e,t,n=ki,s,r,a,o=gn,l=gn,c,h=Ss,u=1){if(h!==Ss&&h!==Es)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:u};super(f,s,r,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ya(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},No=class extends Ms{constructor(e,t=ki,n=Mr,s,r,a=gn,o=gn,l,c=Ss){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,a,o,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Uo=class extends ti{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},wa=class i extends mi{constructor(e=1,t=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],u=[],f=0,d=0;g("z","y","x",-1,-1,n,t,e,a,r,0),g("z","y","x",1,-1,n,t,-e,a,r,1),g("x","z","y",1,1,e,n,t,s,a,2),g("x","z","y",1,-1,e,n,-t,s,a,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Jn(c,3)),this.setAttribute("normal",new Jn(h,3)),this.setAttribute("uv",new Jn(u,2));function g(b,p,m,y,C,w,I,T,v,E,V){let U=w/v,D=I/E,G=w/2,W=I/2,N=T/2,H=v+1,K=E+1,z=0,he=0,J=new X;for(let Q=0;Q<K;Q++){let se=Q*D-W;for(let de=0;de<H;de++){let fe=de*U-G;J[b]=fe*y,J[p]=se*C,J[m]=N,c.push(J.x,J.y,J.z),J[b]=0,J[p]=0,J[m]=T>0?1:-1,h.push(J.x,J.y,J.z),u.push(de/v),u.push(1-Q/E),z+=1}}for(let Q=0;Q<E;Q++)for(let se=0;se<v;se++){let de=f+se+H*Q,fe=f+se+H*(Q+1),ee=f+(se+1)+H*(Q+1),ge=f+(se+1)+H*Q;l.push(de,fe,ge),l.push(fe,ee,ge),he+=6}o.addGroup(d,he,V),d+=he,f+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ql=new X,ec=new X,hf=new X,tc=new xs,Fo=class extends mi{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(ma*t),a=e.getIndex(),o=e.getAttribute("position"),l=a?a.count:o.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),f=new Map,d=[];for(let g=0;g<l;g+=3){a?(c[0]=a.getX(g),c[1]=a.getX(g+1),c[2]=a.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:b,b:p,c:m}=tc;if(b.fromBufferAttribute(o,c[0]),p.fromBufferAttribute(o,c[1]),m.fromBufferAttribute(o,c[2]),tc.getNormal(hf),u[0]=`${Math.round(b.x*s)},${Math.round(b.y*s)},${Math.round(b.z*s)}`,u[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,u[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let y=0;y<3;y++){let C=(y+1)%3,w=u[y],I=u[C],T=tc[h[y]],v=tc[h[C]],E=`${w}_${I}`,V=`${I}_${w}`,U=f.get(V);U?(hf.dot(U.normal)<=r&&(d.push(T.x,T.y,T.z),d.push(v.x,v.y,v.z)),f.set(V,null)):f.has(E)||f.set(E,{index0:c[y],index1:c[C],normal:hf.clone()})}}for(let g of f.values())if(g){let{index0:b,index1:p}=g;Ql.fromBufferAttribute(o,b),ec.fromBufferAttribute(o,p),d.push(Ql.x,Ql.y,Ql.z),d.push(ec.x,ec.y,ec.z)}this.setAttribute("position",new Jn(d,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var Oo=class i extends mi{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(n),l=Math.floor(s),c=o+1,h=l+1,u=e/o,f=t/l,d=[],g=[],b=[],p=[];for(let m=0;m<h;m++){let y=m*f-a;for(let C=0;C<c;C++){let w=C*u-r;g.push(w,-y,0),b.push(0,0,1),p.push(C/o),p.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<o;y++){let C=y+c*m,w=y+c*(m+1),I=y+1+c*(m+1),T=y+1+c*m;d.push(C,w,T),d.push(w,I,T)}this.setIndex(d),this.setAttribute("position",new Jn(g,3)),this.setAttribute("normal",new Jn(b,3)),this.setAttribute("uv",new Jn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function Er(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Sm(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Sm(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Gn(i){let e={};for(let t=0;t<i.length;t++){let n=Er(i[t]);for(let s in n)e[s]=n[s]}return e}function Sm(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Xx(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Kf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:bt.workingColorSpace}var mg={clone:Er,merge:Gn},qx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Yx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,On=class extends Ys{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=qx,this.fragmentShader=Yx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Er(e.uniforms),this.uniformsGroups=Xx(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new St().setHex(s.value);break;case"v2":this.uniforms[n].value=new it().fromArray(s.value);break;case"v3":this.uniforms[n].value=new X().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Zt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new rt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Gt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Tc=class extends On{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ac=class extends Ys{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Qm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Cc=class extends Ys{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function fa(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function nc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Zs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let a;t:{i:if(!(e<s)){for(let o=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=t[++n],e<s)break e}a=t.length;break t}if(!(e>=r)){let o=t[1];e<o&&(n=2,r=o);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}a=n,n=0;break t}break n}for(;n<a;){let o=n+a>>>1;e<t[o]?a=o:n=o+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=n[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Rc=class extends Zs{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ff,endingEnd:ff}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case df:r=e,o=2*t-n;break;case pf:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=n}if(l===void 0)switch(this.getSettings_().endingEnd){case df:a=e,l=2*n-t;break;case pf:a=1,l=n+s[1]-s[0];break;default:a=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,g=(n-t)/(s-t),b=g*g,p=b*g,m=-f*p+2*f*b-f*g,y=(1+f)*p+(-1.5-2*f)*b+(-.5+f)*g+1,C=(-1-d)*p+(1.5+d)*b+.5*g,w=d*p-d*b;for(let I=0;I!==o;++I)r[I]=m*a[h+I]+y*a[c+I]+C*a[l+I]+w*a[u+I];return r}},Pc=class extends Zs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=(n-t)/(s-t),u=1-h;for(let f=0;f!==o;++f)r[f]=a[c+f]*u+a[l+f]*h;return r}},Ic=class extends Zs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Lc=class extends Zs{interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),b=1-g;for(let p=0;p!==o;++p)r[p]=a[c+p]*b+a[l+p]*g;return r}let f=o*2,d=e-1;for(let g=0;g!==o;++g){let b=a[c+g],p=a[l+g],m=d*f+g*2,y=u[m],C=u[m+1],w=e*f+g*2,I=h[w],T=h[w+1],v=Zx(n,t,y,I,s);r[g]=gg(v,b,C,T,p)}return r}};function gg(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function $x(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function Zx(i,e,t,n,s){let r=(i-e)/(s-e);for(let a=0;a<8;a++){let o=gg(r,e,t,n,s)-i;if(Math.abs(o)<1e-10)break;let l=$x(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var gi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=fa(t,this.TimeBufferType),this.values=fa(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:fa(e.times,Array),values:fa(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),nc(e.settings)&&(n.settings={inTangents:fa(e.settings.inTangents,Array),outTangents:fa(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ic(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Pc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Rc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Lc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case wo:t=this.InterpolantFactoryMethodDiscrete;break;case gc:t=this.InterpolantFactoryMethodLinear;break;case rc:t=this.InterpolantFactoryMethodSmooth;break;case uf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ke("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return wo;case this.InterpolantFactoryMethodLinear:return gc;case this.InterpolantFactoryMethodSmooth:return rc;case this.InterpolantFactoryMethodBezier:return uf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;nc(this.settings)&&(Mm(this.settings.inTangents,e),Mm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;nc(this.settings)&&(wm(this.settings.inTangents,e),wm(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<e;)++r;for(;a!==-1&&n[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let l=n[o];if(typeof l=="number"&&isNaN(l)){nt("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){nt("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(s!==void 0&&ux(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){nt("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===rc,r=e.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=e[o],h=e[o+1];if(c!==h&&(o!==1||c!==e[0]))if(s)l=!0;else{let u=o*n,f=u-n,d=u+n;for(let g=0;g!==n;++g){let b=t[u+g];if(b!==t[f+g]||b!==t[d+g]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let u=o*n,f=a*n;for(let d=0;d!==n;++d)t[f+d]=t[u+d]}++a}}if(r>0){e[a]=e[r];for(let o=r*n,l=a*n,c=0;c!==n;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,nc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Mm(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function wm(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}gi.prototype.ValueTypeName="";gi.prototype.TimeBufferType=Float32Array;gi.prototype.ValueBufferType=Float32Array;gi.prototype.DefaultInterpolation=gc;var Ks=class extends gi{constructor(e,t,n){super(e,t,n)}};Ks.prototype.ValueTypeName="bool";Ks.prototype.ValueBufferType=Array;Ks.prototype.DefaultInterpolation=wo;Ks.prototype.InterpolantFactoryMethodLinear=void 0;Ks.prototype.InterpolantFactoryMethodSmooth=void 0;var Dc=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}};Dc.prototype.ValueTypeName="color";var Nc=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}};Nc.prototype.ValueTypeName="number";var Uc=class extends Zs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(n-t)/(s-t),c=e*o;for(let h=c+o;c!==h;c+=4)fi.slerpFlat(r,0,a,c-o,a,c,l);return r}},Bo=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Uc(this.times,this.values,this.getValueSize(),e)}};Bo.prototype.ValueTypeName="quaternion";Bo.prototype.InterpolantFactoryMethodSmooth=void 0;var Js=class extends gi{constructor(e,t,n){super(e,t,n)}};Js.prototype.ValueTypeName="string";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=wo;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var Fc=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}};Fc.prototype.ValueTypeName="vector";var Oc=class{constructor(e,t,n){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],g=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},_g=new Oc,Bc=class{constructor(e){this.manager=e!==void 0?e:_g,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Bc.DEFAULT_MATERIAL_NAME="__DEFAULT";var ic=new X,sc=new fi,Qi=new X,ko=class extends pi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Gt,this.projectionMatrix=new Gt,this.projectionMatrixInverse=new Gt,this.coordinateSystem=Ci,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ic,sc,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ic,sc,Qi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(ic,sc,Qi),Qi.x===1&&Qi.y===1&&Qi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ic,sc,Qi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ws=new X,Em=new it,Tm=new it,Kn=class extends ko{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=xa*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ma*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return xa*2*Math.atan(Math.tan(ma*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ws.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ws.x,Ws.y).multiplyScalar(-e/Ws.z),Ws.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ws.x,Ws.y).multiplyScalar(-e/Ws.z)}getViewSize(e,t){return this.getViewBounds(e,Em,Tm),t.subVectors(Tm,Em)}setViewOffset(e,t,n,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ma*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var kc=class extends ko{constructor(e=-1,t=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,a=n+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var yr=class extends mi{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var da=-90,pa=1,Ea=class extends pi{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Kn(da,pa,e,t);s.layers=this.layers,this.add(s);let r=new Kn(da,pa,e,t);r.layers=this.layers,this.add(r);let a=new Kn(da,pa,e,t);a.layers=this.layers,this.add(a);let o=new Kn(da,pa,e,t);o.layers=this.layers,this.add(o);let l=new Kn(da,pa,e,t);l.layers=this.layers,this.add(l);let c=new Kn(da,pa,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,a,o,l]=t;for(let c of t)this.remove(c);if(e===Ci)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===To)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,u=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let b=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=b,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,f,d),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},zc=class extends Kn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Jf="\\[\\]\\.:\\/",Kx=new RegExp("["+Jf+"]","g"),jf="[^"+Jf+"]",Jx="[^"+Jf.replace("\\.","")+"]",jx=/((?:WC+[\/:])*)/.source.replace("WC",jf),Qx=/(WCOD+)?/.source.replace("WCOD",Jx),ey=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",jf),ty=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",jf),ny=new RegExp("^"+jx+Qx+ey+ty+"$"),iy=["material","materials","bones","map"],mf=class{constructor(e,t,n){let s=n||$t.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},$t=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Kx,"")}static parseTrackName(e){let t=ny.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);iy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let l=n(o.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[s];if(a===void 0){let c=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$t.Composite=mf;$t.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$t.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$t.prototype.GetterByBindingType=[$t.prototype._getValue_direct,$t.prototype._getValue_array,$t.prototype._getValue_arrayElement,$t.prototype._getValue_toArray];$t.prototype.SetterByBindingTypeAndVersioning=[[$t.prototype._setValue_direct,$t.prototype._setValue_direct_setNeedsUpdate,$t.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_array,$t.prototype._setValue_array_setNeedsUpdate,$t.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_arrayElement,$t.prototype._setValue_arrayElement_setNeedsUpdate,$t.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_fromArray,$t.prototype._setValue_fromArray_setNeedsUpdate,$t.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var IA=new Float32Array(1);var Am=new Gt,zo=class{constructor(e,t,n=0,s=1/0){this.ray=new $s(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new ba,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):nt("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Am.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Am),this}intersectObject(e,t=!0,n=[]){return gf(e,this,n,t),n.sort(Cm),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)gf(e[s],this,n,t);return n.sort(Cm),n}};function Cm(i,e){return i.distance-e.distance}function gf(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let a=0,o=r.length;a<o;a++)gf(r[a],e,t,!0)}}var Ta=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=vt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(vt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var _f=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var Vo=class extends Bi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Qf(i,e,t,n){let s=sy(n);switch(t){case Of:return i*e;case kf:return i*e/s.components*s.byteLength;case Yc:return i*e/s.components*s.byteLength;case tr:return i*e*2/s.components*s.byteLength;case $c:return i*e*2/s.components*s.byteLength;case Bf:return i*e*3/s.components*s.byteLength;case vi:return i*e*4/s.components*s.byteLength;case Zc:return i*e*4/s.components*s.byteLength;case Wo:case Xo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case qo:case Yo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Jc:case Qc:return Math.max(i,16)*Math.max(e,8)/4;case Kc:case jc:return Math.max(i,8)*Math.max(e,8)/2;case eh:case th:case ih:case sh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case nh:case $o:case rh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ah:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case oh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case lh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case ch:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case hh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case uh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case fh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case dh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ph:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case mh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case gh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case _h:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case vh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case xh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case yh:case bh:case Sh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Mh:case wh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Zo:case Eh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function sy(i){switch(i){case _i:case Df:return{byteLength:1,components:1};case Pa:case Nf:case Vi:return{byteLength:2,components:1};case Xc:case qc:return{byteLength:2,components:4};case ki:case Wc:case zi:return{byteLength:4,components:1};case Uf:case Ff:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function kg(){let i=null,e=!1,t=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function ay(i){let e=new WeakMap;function t(o,l){let c=o.array,h=o.usage,u=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,h),o.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:u}}function n(o,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,o),u.length===0)i.bufferSubData(c,0,h);else{u.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<u.length;d++){let g=u[f],b=u[d];b.start<=g.start+g.count+1?g.count=Math.max(g.count,b.start+b.count-g.start):(++f,u[f]=b)}u.length=f+1;for(let d=0,g=u.length;d<g;d++){let b=u[d];i.bufferSubData(c,b.start*h.BYTES_PER_ELEMENT,h,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(i.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var oy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ly=`#ifdef USE_ALPHAHASH
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
#endif`,cy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,hy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,uy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,fy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,dy=`#ifdef USE_AOMAP
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
#endif`,py=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,my=`#ifdef USE_BATCHING
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
#endif`,gy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,_y=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,vy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,xy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,yy=`#ifdef USE_IRIDESCENCE
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
#endif`,by=`#ifdef USE_BUMPMAP
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
#endif`,Sy=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,My=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,wy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Ey=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ty=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Ay=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Cy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Ry=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Py=`#define PI 3.141592653589793
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
} // validated`,Iy=`vec3 transformedNormal = objectNormal;
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
#endif`,Ly=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Dy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Ny=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Uy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Fy="gl_FragColor = linearToOutputTexel( gl_FragColor );",Oy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,By=`#ifdef USE_ENVMAP
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
#endif`,ky=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,zy=`#ifdef USE_ENVMAP
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
#endif`,Vy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Hy=`#ifdef USE_ENVMAP
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
#endif`,Gy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Wy=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Xy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,qy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Yy=`#ifdef USE_GRADIENTMAP
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
}`,$y=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Zy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ky=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Jy=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,jy=`#ifdef USE_ENVMAP
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
#endif`,Qy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,eb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,tb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,nb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,ib=`PhysicalMaterial material;
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
#endif`,sb=`uniform sampler2D dfgLUT;
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
}`,rb=`
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
#endif`,ab=`#if defined( RE_IndirectDiffuse )
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
#endif`,ob=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,lb=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,cb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,hb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ub=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,fb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,db=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,pb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,mb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,gb=`#if defined( USE_POINTS_UV )
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
#endif`,_b=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,vb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,xb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,yb=`#if defined( USE_MORPHCOLORS )
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
#endif`,bb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Sb=`#ifdef USE_MORPHTARGETS
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
#endif`,Mb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,wb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Eb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Tb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ab=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Cb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Rb=`#ifdef USE_NORMALMAP
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
#endif`,Pb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Ib=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Lb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Db=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Nb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Ub=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Fb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Ob=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Bb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,kb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,zb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Vb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Hb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Gb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Wb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Xb=`float getShadowMask() {
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
}`,qb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Yb=`#ifdef USE_SKINNING
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
#endif`,$b=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Zb=`#ifdef USE_SKINNING
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
#endif`,Kb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Jb=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,jb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Qb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,eS=`#ifdef USE_TRANSMISSION
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
#endif`,tS=`#ifdef USE_TRANSMISSION
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
#endif`,nS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,iS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,rS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,aS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,oS=`uniform sampler2D t2D;
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
}`,lS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cS=`uniform float backgroundBlurriness;
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
}`,hS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,uS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fS=`#include <common>
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
}`,dS=`#if DEPTH_PACKING == 3200
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
}`,pS=`#define DISTANCE
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
}`,mS=`#define DISTANCE
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
}`,gS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,_S=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,vS=`uniform float scale;
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
}`,xS=`uniform vec3 diffuse;
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
}`,yS=`#include <common>
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
}`,bS=`uniform vec3 diffuse;
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
}`,SS=`#define LAMBERT
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
}`,MS=`#define LAMBERT
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
}`,wS=`#define MATCAP
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
}`,ES=`#define MATCAP
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
}`,TS=`#define NORMAL
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
}`,AS=`#define NORMAL
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
}`,CS=`#define PHONG
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
}`,RS=`#define PHONG
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
}`,PS=`#define STANDARD
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
}`,IS=`#define STANDARD
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
}`,LS=`#define TOON
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
}`,DS=`#define TOON
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
}`,NS=`uniform float size;
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
}`,US=`uniform vec3 diffuse;
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
}`,FS=`#include <common>
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
}`,OS=`uniform vec3 color;
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
}`,BS=`uniform float rotation;
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
}`,kS=`uniform vec3 diffuse;
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
}`,pt={alphahash_fragment:oy,alphahash_pars_fragment:ly,alphamap_fragment:cy,alphamap_pars_fragment:hy,alphatest_fragment:uy,alphatest_pars_fragment:fy,aomap_fragment:dy,aomap_pars_fragment:py,batching_pars_vertex:my,batching_vertex:gy,begin_vertex:_y,beginnormal_vertex:vy,bsdfs:xy,iridescence_fragment:yy,bumpmap_pars_fragment:by,clipping_planes_fragment:Sy,clipping_planes_pars_fragment:My,clipping_planes_pars_vertex:wy,clipping_planes_vertex:Ey,color_fragment:Ty,color_pars_fragment:Ay,color_pars_vertex:Cy,color_vertex:Ry,common:Py,defaultnormal_vertex:Iy,displacementmap_pars_vertex:Ly,displacementmap_vertex:Dy,emissivemap_fragment:Ny,emissivemap_pars_fragment:Uy,colorspace_fragment:Fy,colorspace_pars_fragment:Oy,envmap_fragment:By,envmap_common_pars_fragment:ky,envmap_pars_fragment:zy,envmap_pars_vertex:Vy,envmap_physical_pars_fragment:jy,envmap_vertex:Hy,fog_vertex:Gy,fog_pars_vertex:Wy,fog_fragment:Xy,fog_pars_fragment:qy,gradientmap_pars_fragment:Yy,lightmap_pars_fragment:$y,lights_lambert_fragment:Zy,lights_lambert_pars_fragment:Ky,lights_pars_begin:Jy,lights_toon_fragment:Qy,lights_toon_pars_fragment:eb,lights_phong_fragment:tb,lights_phong_pars_fragment:nb,lights_physical_fragment:ib,lights_physical_pars_fragment:sb,lights_fragment_begin:rb,lights_fragment_maps:ab,lights_fragment_end:ob,lightprobes_pars_fragment:lb,logdepthbuf_fragment:cb,logdepthbuf_pars_fragment:hb,logdepthbuf_pars_vertex:ub,logdepthbuf_vertex:fb,map_fragment:db,map_pars_fragment:pb,map_particle_fragment:mb,map_particle_pars_fragment:gb,metalnessmap_fragment:_b,metalnessmap_pars_fragment:vb,morphinstance_vertex:xb,morphcolor_vertex:yb,morphnormal_vertex:bb,morphtarget_pars_vertex:Sb,morphtarget_vertex:Mb,normal_fragment_begin:wb,normal_fragment_maps:Eb,normal_pars_fragment:Tb,normal_pars_vertex:Ab,normal_vertex:Cb,normalmap_pars_fragment:Rb,clearcoat_normal_fragment_begin:Pb,clearcoat_normal_fragment_maps:Ib,clearcoat_pars_fragment:Lb,iridescence_pars_fragment:Db,opaque_fragment:Nb,packing:Ub,premultiplied_alpha_fragment:Fb,project_vertex:Ob,dithering_fragment:Bb,dithering_pars_fragment:kb,roughnessmap_fragment:zb,roughnessmap_pars_fragment:Vb,shadowmap_pars_fragment:Hb,shadowmap_pars_vertex:Gb,shadowmap_vertex:Wb,shadowmask_pars_fragment:Xb,skinbase_vertex:qb,skinning_pars_vertex:Yb,skinning_vertex:$b,skinnormal_vertex:Zb,specularmap_fragment:Kb,specularmap_pars_fragment:Jb,tonemapping_fragment:jb,tonemapping_pars_fragment:Qb,transmission_fragment:eS,transmission_pars_fragment:tS,uv_pars_fragment:nS,uv_pars_vertex:iS,uv_vertex:sS,worldpos_vertex:rS,background_vert:aS,background_frag:oS,backgroundCube_vert:lS,backgroundCube_frag:cS,cube_vert:hS,cube_frag:uS,depth_vert:fS,depth_frag:dS,distance_vert:pS,distance_frag:mS,equirect_vert:gS,equirect_frag:_S,linedashed_vert:vS,linedashed_frag:xS,meshbasic_vert:yS,meshbasic_frag:bS,meshlambert_vert:SS,meshlambert_frag:MS,meshmatcap_vert:wS,meshmatcap_frag:ES,meshnormal_vert:TS,meshnormal_frag:AS,meshphong_vert:CS,meshphong_frag:RS,meshphysical_vert:PS,meshphysical_frag:IS,meshtoon_vert:LS,meshtoon_frag:DS,points_vert:NS,points_frag:US,shadow_vert:FS,shadow_frag:OS,sprite_vert:BS,sprite_frag:kS},De={common:{diffuse:{value:new St(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new rt}},envmap:{envMap:{value:null},envMapRotation:{value:new rt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new rt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new rt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new rt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new rt},normalScale:{value:new it(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new rt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new rt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new rt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new rt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new St(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new St(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0},uvTransform:{value:new rt}},sprite:{diffuse:{value:new St(16777215)},opacity:{value:1},center:{value:new it(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}}},is={basic:{uniforms:Gn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:Gn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new St(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:Gn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new St(0)},specular:{value:new St(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:Gn([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new St(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:Gn([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new St(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:Gn([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:Gn([De.points,De.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:Gn([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:Gn([De.common,De.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:Gn([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:Gn([De.sprite,De.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new rt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new rt}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:Gn([De.common,De.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:Gn([De.lights,De.fog,{color:{value:new St(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};is.physical={uniforms:Gn([is.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new rt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new rt},clearcoatNormalScale:{value:new it(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new rt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new rt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new rt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new rt},sheen:{value:0},sheenColor:{value:new St(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new rt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new rt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new rt},transmissionSamplerSize:{value:new it},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new rt},attenuationDistance:{value:0},attenuationColor:{value:new St(0)},specularColor:{value:new St(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new rt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new rt},anisotropyVector:{value:new it},anisotropyMap:{value:null},anisotropyMapTransform:{value:new rt}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var Th={r:0,b:0,g:0},zS=new Gt,zg=new rt;zg.set(-1,0,0,0,1,0,0,0,1);function VS(i,e,t,n,s,r){let a=new St(0),o=s===!0?0:1,l,c,h=null,u=0,f=null;function d(y){let C=y.isScene===!0?y.background:null;if(C&&C.isTexture){let w=y.backgroundBlurriness>0;C=e.get(C,w)}return C}function g(y){let C=!1,w=d(y);w===null?p(a,o):w&&w.isColor&&(p(w,1),C=!0);let I=i.xr.getEnvironmentBlendMode();I==="additive"?t.buffers.color.setClear(0,0,0,1,r):I==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function b(y,C){let w=d(C);w&&w.isCubeTexture?(c===void 0&&(c=new Hn(new wa(1,1,1),new On({name:"BackgroundCubeMaterial",uniforms:Er(is.backgroundCube.uniforms),vertexShader:is.backgroundCube.vertexShader,fragmentShader:is.backgroundCube.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(I,T,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=w,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(zS.makeRotationFromEuler(C.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(zg),c.material.toneMapped=bt.getTransfer(w.colorSpace)!==Lt,(h!==w||u!==w.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,u=w.version,f=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):w&&w.isTexture&&(l===void 0&&(l=new Hn(new Oo(2,2),new On({name:"BackgroundMaterial",uniforms:Er(is.background.uniforms),vertexShader:is.background.vertexShader,fragmentShader:is.background.fragmentShader,side:er,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=w,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=bt.getTransfer(w.colorSpace)!==Lt,w.matrixAutoUpdate===!0&&w.updateMatrix(),l.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||u!==w.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,u=w.version,f=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function p(y,C){y.getRGB(Th,Kf(i)),t.buffers.color.setClear(Th.r,Th.g,Th.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(y,C=1){a.set(y),o=C,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(y){o=y,p(a,o)},render:g,addToRenderList:b,dispose:m}}function HS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null),r=s,a=!1;function o(D,G,W,N,H){let K=!1,z=u(D,N,W,G);r!==z&&(r=z,c(r.object)),K=d(D,N,W,H),K&&g(D,N,W,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(K||a)&&(a=!1,w(D,G,W,N),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,G,W,N){let H=N.wireframe===!0,K=n[G.id];K===void 0&&(K={},n[G.id]=K);let z=D.isInstancedMesh===!0?D.id:0,he=K[z];he===void 0&&(he={},K[z]=he);let J=he[W.id];J===void 0&&(J={},he[W.id]=J);let Q=J[H];return Q===void 0&&(Q=f(l()),J[H]=Q),Q}function f(D){let G=[],W=[],N=[];for(let H=0;H<t;H++)G[H]=0,W[H]=0,N[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:W,attributeDivisors:N,object:D,attributes:{},index:null}}function d(D,G,W,N){let H=r.attributes,K=G.attributes,z=0,he=W.getAttributes();for(let J in he)if(he[J].location>=0){let se=H[J],de=K[J];if(de===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(de=D.instanceColor)),se===void 0||se.attribute!==de||de&&se.data!==de.data)return!0;z++}return r.attributesNum!==z||r.index!==N}function g(D,G,W,N){let H={},K=G.attributes,z=0,he=W.getAttributes();for(let J in he)if(he[J].location>=0){let se=K[J];se===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(se=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(se=D.instanceColor));let de={};de.attribute=se,se&&se.data&&(de.data=se.data),H[J]=de,z++}r.attributes=H,r.attributesNum=z,r.index=N}function b(){let D=r.newAttributes;for(let G=0,W=D.length;G<W;G++)D[G]=0}function p(D){m(D,0)}function m(D,G){let W=r.newAttributes,N=r.enabledAttributes,H=r.attributeDivisors;W[D]=1,N[D]===0&&(i.enableVertexAttribArray(D),N[D]=1),H[D]!==G&&(i.vertexAttribDivisor(D,G),H[D]=G)}function y(){let D=r.newAttributes,G=r.enabledAttributes;for(let W=0,N=G.length;W<N;W++)G[W]!==D[W]&&(i.disableVertexAttribArray(W),G[W]=0)}function C(D,G,W,N,H,K,z){z===!0?i.vertexAttribIPointer(D,G,W,H,K):i.vertexAttribPointer(D,G,W,N,H,K)}function w(D,G,W,N){b();let H=N.attributes,K=W.getAttributes(),z=G.defaultAttributeValues;for(let he in K){let J=K[he];if(J.location>=0){let Q=H[he];if(Q===void 0&&(he==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),he==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let se=Q.normalized,de=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let ee=fe.buffer,ge=fe.type,xe=fe.bytesPerElement,Ce=ge===i.INT||ge===i.UNSIGNED_INT||Q.gpuType===Wc;if(Q.isInterleavedBufferAttribute){let Me=Q.data,Ye=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,lt=Q.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let Xe=0;Xe<J.locationSize;Xe++)m(J.location+Xe,Me.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let Xe=0;Xe<J.locationSize;Xe++)p(J.location+Xe);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Xe=0;Xe<J.locationSize;Xe++)C(J.location+Xe,de/J.locationSize,ge,se,Ye*xe,(lt+de/J.locationSize*Xe)*xe,Ce)}else{if(Q.isInstancedBufferAttribute){for(let Me=0;Me<J.locationSize;Me++)m(J.location+Me,Q.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Me=0;Me<J.locationSize;Me++)p(J.location+Me);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Me=0;Me<J.locationSize;Me++)C(J.location+Me,de/J.locationSize,ge,se,de*xe,de/J.locationSize*Me*xe,Ce)}}else if(z!==void 0){let se=z[he];if(se!==void 0)switch(se.length){case 2:i.vertexAttrib2fv(J.location,se);break;case 3:i.vertexAttrib3fv(J.location,se);break;case 4:i.vertexAttrib4fv(J.location,se);break;default:i.vertexAttrib1fv(J.location,se)}}}}y()}function I(){V();for(let D in n){let G=n[D];for(let W in G){let N=G[W];for(let H in N){let K=N[H];for(let z in K)h(K[z].object),delete K[z];delete N[H]}}delete n[D]}}function T(D){if(n[D.id]===void 0)return;let G=n[D.id];for(let W in G){let N=G[W];for(let H in N){let K=N[H];for(let z in K)h(K[z].object),delete K[z];delete N[H]}}delete n[D.id]}function v(D){for(let G in n){let W=n[G];for(let N in W){let H=W[N];if(H[D.id]===void 0)continue;let K=H[D.id];for(let z in K)h(K[z].object),delete K[z];delete H[D.id]}}}function E(D){for(let G in n){let W=n[G],N=D.isInstancedMesh===!0?D.id:0,H=W[N];if(H!==void 0){for(let K in H){let z=H[K];for(let he in z)h(z[he].object),delete z[he];delete H[K]}delete W[N],Object.keys(W).length===0&&delete n[G]}}}function V(){U(),a=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:V,resetDefaultState:U,dispose:I,releaseStatesOfGeometry:T,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:b,enableAttribute:p,disableUnusedAttributes:y}}function GS(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function o(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];t.update(f,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function WS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(v){return!(v!==vi&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(v){let E=v===Vi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==_i&&v!==zi&&!E&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ke("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),I=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:g,maxTextureSize:b,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:y,maxVaryings:C,maxFragmentUniforms:w,maxSamples:I,samples:T}}function XS(i){let e=this,t=null,n=0,s=!1,r=!1,a=new Zn,o=new rt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||n!==0||s;return s=f,n=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){t=h(u,f,0)},this.setState=function(u,f,d){let g=u.clippingPlanes,b=u.clipIntersection,p=u.clipShadows,m=i.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let y=r?0:n,C=y*4,w=m.clippingState||null;l.value=w,w=h(g,f,C,d);for(let I=0;I!==C;++I)w[I]=t[I];m.clippingState=w,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,f,d,g){let b=u!==null?u.length:0,p=null;if(b!==0){if(p=l.value,g!==!0||p===null){let m=d+b*4,y=f.matrixWorldInverse;o.getNormalMatrix(y),(p===null||p.length<m)&&(p=new Float32Array(m));for(let C=0,w=d;C!==b;++C,w+=4)a.copy(u[C]).applyMatrix4(y,o),a.normal.toArray(p,w),p[w+3]=a.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,p}}var jo=class extends di{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Do(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new wa(5,5,5),r=new On({name:"CubemapFromEquirect",uniforms:Er(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Qn,blending:br});r.uniforms.tEquirect.value=t;let a=new Hn(s,r),o=t.minFilter;return t.minFilter===ws&&(t.minFilter=jn),new Ea(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,s);e.setRenderTarget(r)}},vg=256,qS=3,YS=20,Vg=256,Hg=16,$S=3,ZS=new X,KS=new St,Ch=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ea(1,10,null),this._boxMesh=new Hn(new wa(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:a=256,position:o=ZS}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(KS));let p=new Ea(n,s,h);return p.position.copy(o),p.update(l,e),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=g,e.background=b,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=bg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=yg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(vg,Yf(e))}_fromTexture(e,t){e.mapping===Mr||e.mapping===Ra?this._setSize(e.image.length===0?vg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=xg(e,!1,!1),n=Math.log2(e)-qS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=xg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Mr||e.mapping===Ra?(this._cubemapMaterial===null&&(this._cubemapMaterial=bg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=yg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=JS(),this._integrationMaterial=jS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Hg);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-$S)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(Vg*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=QS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function xg(i,e,t){return new jo(i,{minFilter:ws,generateMipmaps:e,type:Vi,colorSpace:Xs,depthBuffer:t})}function Qo(i,e,t){return new On({name:i,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:Qn,blending:br,depthTest:!1,depthWrite:!1})}function JS(){return Qo("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Vg}u

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
	`)}function jS(){return Qo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Hg}},`

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
	`)}function QS(){return Qo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${YS}
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
	`)}function yg(){return Qo("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function bg(){return Qo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function eM(i){let e=new WeakMap,t=new WeakMap,n=null;function s(f,d=!1){return f==null?null:d?a(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Vc||d===Hc)if(e.has(f)){let g=e.get(f).texture;return o(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let b=new jo(g.height);return b.fromEquirectangularTexture(i,f),e.set(f,b),f.addEventListener("dispose",c),o(b.texture,f.mapping)}else return null}}return f}function a(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,g=d===Vc||d===Hc,b=d===Mr||d===Ra;if(g||b){let p=t.get(f),m=p!==void 0?p.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return n===null&&(n=new Ch(i)),p=g?n.fromEquirectangular(f,p):n.fromCubemap(f,p),p.texture.pmremVersion=f.pmremVersion,t.set(f,p),p.texture;if(p!==void 0)return p.texture;{let y=f.image;return g&&y&&y.height>0||b&&y&&l(y)?(n===null&&(n=new Ch(i)),p=g?n.fromEquirectangular(f):n.fromCubemap(f),p.texture.pmremVersion=f.pmremVersion,t.set(f,p),f.addEventListener("dispose",h),p.texture):null}}}return f}function o(f,d){return d===Vc?f.mapping=Mr:d===Hc&&(f.mapping=Ra),f}function l(f){let d=0,g=6;for(let b=0;b<g;b++)f[b]!==void 0&&d++;return d===g}function c(f){let d=f.target;d.removeEventListener("dispose",c);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function tM(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&So("WebGLRenderer: "+n+" extension not supported."),s}}}function nM(i,e,t,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let b=r.get(g);b&&(e.remove(b),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,b){return s[b.id]!==void 0||(b.addEventListener("dispose",o),s[b.id]=new WeakRef(b),a.register(b,b.id,b),t.memory.geometries++),b}function h(g){let b=g.attributes;for(let p in b)e.update(b[p],i.ARRAY_BUFFER)}function u(g){let b=g.index,p=g.attributes.position,m=0;if(p===void 0)return;let y=b!==null?b.array.length:p.array.length/3-1,C=p.count>=65535?Io:Po,w=new C(Math.ceil(y/3)*6,1),I=w.array;if(b!==null){let v=b.array;m=b.version;for(let E=0,V=0;E<y;E+=3){let U=v[E+0],D=v[E+1],G=v[E+2];I[V++]=U,I[V++]=D,I[V++]=D,I[V++]=G,I[V++]=G,I[V++]=U}}else{m=p.version;for(let v=0,E=0;v<y;v+=3){let V=v+0,U=v+1,D=v+2;I[E++]=V,I[E++]=U,I[E++]=U,I[E++]=D,I[E++]=D,I[E++]=V}}w.version=m;let T=r.get(g);T&&e.remove(T),r.set(g,w)}function f(g){let b=r.get(g);if(b){let p=g.index;p!==null&&b.version<p.version&&u(g)}else u(g);return r.get(g)}function d(){for(let g in s){let b=s[g].deref();b!==void 0&&l(b)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function iM(i,e,t){let n;function s(u){n=u}let r,a;function o(u){r=u.type,a=u.bytesPerElement}function l(u,f){i.drawElements(n,f,r,u*a),t.update(f,n,1)}function c(u,f,d){d!==0&&(i.drawElementsInstanced(n,f,r,u*a,d),t.update(f,n,d))}function h(u,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,r,u,0,d);let b=0;for(let p=0;p<d;p++)b+=f[p];t.update(b,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function sM(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(r/3);break;case i.LINES:t.lines+=o*(r/2);break;case i.LINE_STRIP:t.lines+=o*(r-1);break;case i.LINE_LOOP:t.lines+=o*r;break;case i.POINTS:t.points+=o*r;break;default:nt("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function rM(i,e,t){let n=new WeakMap,s=new Zt;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,u=h!==void 0?h.length:0,f=n.get(o);if(f===void 0||f.count!==u){let V=function(){v.dispose(),n.delete(o),o.removeEventListener("dispose",V)};f!==void 0&&f.texture.dispose();let d=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,b=o.morphAttributes.color!==void 0,p=o.morphAttributes.position||[],m=o.morphAttributes.normal||[],y=o.morphAttributes.color||[],C=0;d===!0&&(C=1),g===!0&&(C=2),b===!0&&(C=3);let w=o.attributes.position.count*C,I=1;w>e.maxTextureSize&&(I=Math.ceil(w/e.maxTextureSize),w=e.maxTextureSize);let T=new Float32Array(w*I*4*u),v=new Co(T,w,I,u);v.type=zi,v.needsUpdate=!0;let E=C*4;for(let U=0;U<u;U++){let D=p[U],G=m[U],W=y[U],N=w*I*4*U;for(let H=0;H<D.count;H++){let K=H*E;d===!0&&(s.fromBufferAttribute(D,H),T[N+K+0]=s.x,T[N+K+1]=s.y,T[N+K+2]=s.z,T[N+K+3]=0),g===!0&&(s.fromBufferAttribute(G,H),T[N+K+4]=s.x,T[N+K+5]=s.y,T[N+K+6]=s.z,T[N+K+7]=0),b===!0&&(s.fromBufferAttribute(W,H),T[N+K+8]=s.x,T[N+K+9]=s.y,T[N+K+10]=s.z,T[N+K+11]=W.itemSize===4?s.w:1)}}f={count:u,texture:v,size:new it(w,I)},n.set(o,f),o.addEventListener("dispose",V)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let d=0;for(let b=0;b<c.length;b++)d+=c[b];let g=o.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function aM(i,e,t,n,s){let r=new WeakMap;function a(c){let h=s.render.frame,u=c.geometry,f=e.get(c,u);if(r.get(f)!==h&&(e.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}var oM={[Ef]:"LINEAR_TONE_MAPPING",[Tf]:"REINHARD_TONE_MAPPING",[Af]:"CINEON_TONE_MAPPING",[Cf]:"ACES_FILMIC_TONE_MAPPING",[Pf]:"AGX_TONE_MAPPING",[If]:"NEUTRAL_TONE_MAPPING",[Rf]:"CUSTOM_TONE_MAPPING"};function lM(i,e,t,n,s,r){let a=new di(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new mi;h.setAttribute("position",new Jn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Jn([0,2,0,0,2,0],2));let u=new Tc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Hn(h,u),d=new kc(-1,1,1,-1,0,1),g=null,b=null,p=!1,m,y=null,C=[],w=!1;this.setSize=function(I,T){a.setSize(I,T),o!==null&&o.setSize(I,T),l!==null&&l.setSize(I,T);for(let v=0;v<C.length;v++){let E=C[v];E.setSize&&E.setSize(I,T)}},this.setEffects=function(I){C=I,w=C.length>0&&C[0].isRenderPass===!0;let T=a.width,v=a.height;C.length>0&&o===null&&(o=new di(T,v,{type:Vi,depthBuffer:!1,stencilBuffer:!1}),l=new di(T,v,{type:Vi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&C.some(V=>V.needsDepthTexture===!0);E!==(a.depthTexture!==null)&&(E===!0&&c===null&&(c=new Ms(T,v),r===!0&&(c.format=Es,c.type=wr)),a.dispose(),a.depthTexture=E?c:null,a.resolveDepthBuffer=E,a.storeMultisampledDepthBuffer=E);for(let V=0;V<C.length;V++){let U=C[V];U.setSize&&U.setSize(T,v),E&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(I,T){if(p||I.toneMapping===ts&&C.length===0)return!1;if(y=T,T!==null){let v=T.width,E=T.height;(a.width!==v||a.height!==E)&&this.setSize(v,E)}return w===!1&&I.setRenderTarget(a),m=I.toneMapping,I.toneMapping=ts,!0},this.hasRenderPass=function(){return w},this.end=function(I,T){I.toneMapping=m,p=!0;let v=a,E=o;for(let V=0;V<C.length;V++){let U=C[V];U.enabled!==!1&&(U.render(I,E,v,T),U.needsSwap!==!1&&(v=E,E=E===o?l:o))}if(g!==I.outputColorSpace||b!==I.toneMapping){g=I.outputColorSpace,b=I.toneMapping,u.defines={},bt.getTransfer(g)===Lt&&(u.defines.SRGB_TRANSFER="");let V=oM[b];V&&(u.defines[V]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=v.texture,I.setRenderTarget(y),I.render(f,d),y=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Gg=new ti,Wg=new Ms(1,1),Xg=new No(1),qg=new Co,Yg=new xc,$g=new Do,Sg=[],Mg=[],wg=new Float32Array(16),Eg=new Float32Array(9),Tg=new Float32Array(4);function Da(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Sg[s];if(r===void 0&&(r=new Float32Array(s),Sg[s]=r),e!==0){n.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(r,o)}return r}function bn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Sn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ph(i,e){let t=Mg[e];t===void 0&&(t=new Int32Array(e),Mg[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function cM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function hM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2fv(this.addr,e),Sn(t,e)}}function uM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(bn(t,e))return;i.uniform3fv(this.addr,e),Sn(t,e)}}function fM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4fv(this.addr,e),Sn(t,e)}}function dM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Sn(t,e)}else{if(bn(t,n))return;Tg.set(n),i.uniformMatrix2fv(this.addr,!1,Tg),Sn(t,n)}}function pM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Sn(t,e)}else{if(bn(t,n))return;Eg.set(n),i.uniformMatrix3fv(this.addr,!1,Eg),Sn(t,n)}}function mM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(bn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Sn(t,e)}else{if(bn(t,n))return;wg.set(n),i.uniformMatrix4fv(this.addr,!1,wg),Sn(t,n)}}function gM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function _M(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2iv(this.addr,e),Sn(t,e)}}function vM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bn(t,e))return;i.uniform3iv(this.addr,e),Sn(t,e)}}function xM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4iv(this.addr,e),Sn(t,e)}}function yM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function bM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(bn(t,e))return;i.uniform2uiv(this.addr,e),Sn(t,e)}}function SM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(bn(t,e))return;i.uniform3uiv(this.addr,e),Sn(t,e)}}function MM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(bn(t,e))return;i.uniform4uiv(this.addr,e),Sn(t,e)}}function Ih(i){return i.version===0&&(i.compareFunction=Gf,i.needsUpdate=!0),i}function wM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Ih(Wg):r=Gg,t.setTexture2D(e||r,s)}function EM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Yg,s)}function TM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Ih(Xg):r=$g,t.setTextureCube(e||r,s)}function AM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||qg,s)}function CM(i){switch(i){case 5126:return cM;case 35664:return hM;case 35665:return uM;case 35666:return fM;case 35674:return dM;case 35675:return pM;case 35676:return mM;case 5124:case 35670:return gM;case 35667:case 35671:return _M;case 35668:case 35672:return vM;case 35669:case 35673:return xM;case 5125:return yM;case 36294:return bM;case 36295:return SM;case 36296:return MM;case 35678:case 36198:case 36298:case 36306:case 35682:return wM;case 35679:case 36299:case 36307:return EM;case 35680:case 36300:case 36308:case 36293:return TM;case 36289:case 36303:case 36311:case 36292:return AM}}function RM(i,e){i.uniform1fv(this.addr,e)}function PM(i,e){let t=Da(e,this.size,2);i.uniform2fv(this.addr,t)}function IM(i,e){let t=Da(e,this.size,3);i.uniform3fv(this.addr,t)}function LM(i,e){let t=Da(e,this.size,4);i.uniform4fv(this.addr,t)}function DM(i,e){let t=Da(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function NM(i,e){let t=Da(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function UM(i,e){let t=Da(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function FM(i,e){i.uniform1iv(this.addr,e)}function OM(i,e){i.uniform2iv(this.addr,e)}function BM(i,e){i.uniform3iv(this.addr,e)}function kM(i,e){i.uniform4iv(this.addr,e)}function zM(i,e){i.uniform1uiv(this.addr,e)}function VM(i,e){i.uniform2uiv(this.addr,e)}function HM(i,e){i.uniform3uiv(this.addr,e)}function GM(i,e){i.uniform4uiv(this.addr,e)}function WM(i,e,t){let n=this.cache,s=e.length,r=Ph(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Ih(Wg):a=Gg;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function XM(i,e,t){let n=this.cache,s=e.length,r=Ph(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||Yg,r[a])}function qM(i,e,t){let n=this.cache,s=e.length,r=Ph(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Ih(Xg):a=$g;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function YM(i,e,t){let n=this.cache,s=e.length,r=Ph(t,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||qg,r[a])}function $M(i){switch(i){case 5126:return RM;case 35664:return PM;case 35665:return IM;case 35666:return LM;case 35674:return DM;case 35675:return NM;case 35676:return UM;case 5124:case 35670:return FM;case 35667:case 35671:return OM;case 35668:case 35672:return BM;case 35669:case 35673:return kM;case 5125:return zM;case 36294:return VM;case 36295:return HM;case 36296:return GM;case 35678:case 36198:case 36298:case 36306:case 35682:return WM;case 35679:case 36299:case 36307:return XM;case 35680:case 36300:case 36308:case 36293:return qM;case 36289:case 36303:case 36311:case 36292:return YM}}var nd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=CM(t.type)}},id=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=$M(t.type)}},sd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],n)}}},ed=/(\w+)(\])?(\[|\.)?/g;function Ag(i,e){i.seq.push(e),i.map[e.id]=e}function ZM(i,e,t){let n=i.name,s=n.length;for(ed.lastIndex=0;;){let r=ed.exec(n),a=ed.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Ag(t,c===void 0?new nd(o,i,e):new id(o,i,e));break}else{let u=t.map[o];u===void 0&&(u=new sd(o),Ag(t,u)),t=u}}}var La=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);ZM(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&n.push(a)}return n}};function Cg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var KM=37297,JM=0;function jM(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}var Rg=new rt;function QM(i){bt._getMatrix(Rg,bt.workingColorSpace,i);let e=`mat3( ${Rg.elements.map(t=>t.toFixed(4))} )`;switch(bt.getTransfer(i)){case Eo:return[e,"LinearTransferOETF"];case Lt:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Pg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+jM(i.getShaderSource(e),o)}else return r}function ew(i,e){let t=QM(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var tw={[Ef]:"Linear",[Tf]:"Reinhard",[Af]:"Cineon",[Cf]:"ACESFilmic",[Pf]:"AgX",[If]:"Neutral",[Rf]:"Custom"};function nw(i,e){let t=tw[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ah=new X;function iw(){bt.getLuminanceCoefficients(Ah);let i=Ah.x.toFixed(4),e=Ah.y.toFixed(4),t=Ah.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function sw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Jo).join(`
`)}function rw(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function aw(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function Jo(i){return i!==""}function Ig(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Lg(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var ow=/^[ \t]*#include +<([\w\d./]+)>/gm;function rd(i){return i.replace(ow,lw)}function lw(i,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return rd(t)}var cw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Dg(i){return i.replace(cw,hw)}function hw(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Ng(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var uw={[Ho]:"SHADOWMAP_TYPE_PCF",[Aa]:"SHADOWMAP_TYPE_VSM"};function fw(i){return uw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var dw={[Ra]:"ENVMAP_MODE_REFRACTION"};function pw(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":dw[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var mw={[wf]:"ENVMAP_BLENDING_MULTIPLY",[Km]:"ENVMAP_BLENDING_MIX",[Jm]:"ENVMAP_BLENDING_ADD"};function gw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":mw[i.combine]||"ENVMAP_BLENDING_NONE"}function _w(i,e,t,n){let s=i.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,l=fw(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=pw(t),u=gw(t),f=sw(t),d=rw(r),g=s.createProgram(),b,p,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Jo).join(`
`),b.length>0&&(b+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Jo).join(`
`),p.length>0&&(p+=`
`)):(b=[Ng(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Jo).join(`
`),p=[Ng(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ts?"#define TONE_MAPPING":"",t.toneMapping!==ts?pt.tonemapping_pars_fragment:"",t.toneMapping!==ts?nw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,ew("linearToOutputTexel",t.outputColorSpace),iw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Jo).join(`
`)),a=rd(a),a=Ig(a,t),a=Lg(a,t),o=rd(o),o=Ig(o,t),o=Lg(o,t),a=Dg(a),o=Dg(o),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,b=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,p=["#define varying in",t.glslVersion===As?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===As?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let y=m+b+a,C=m+p+o,w=Cg(s,s.VERTEX_SHADER,y),I=Cg(s,s.FRAGMENT_SHADER,C);s.attachShader(g,w),s.attachShader(g,I),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function T(U){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",G=s.getShaderInfoLog(w)||"",W=s.getShaderInfoLog(I)||"",N=D.trim(),H=G.trim(),K=W.trim(),z=!0,he=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,w,I);else{let J=Pg(s,w,"vertex"),Q=Pg(s,I,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+N+`
`+J+`
`+Q)}else N!==""?Ke("WebGLProgram: Program Info Log:",N):(H===""||K==="")&&(he=!1);he&&(U.diagnostics={runnable:z,programLog:N,vertexShader:{log:H,prefix:b},fragmentShader:{log:K,prefix:p}})}s.deleteShader(w),s.deleteShader(I),v=new La(s,g),E=aw(s,g)}let v;this.getUniforms=function(){return v===void 0&&T(this),v};let E;this.getAttributes=function(){return E===void 0&&T(this),E};let V=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return V===!1&&(V=s.getProgramParameter(g,KM)),V},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=JM++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=w,this.fragmentShader=I,this}var vw=0,ad=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new od(e),t.set(e,n)),n}},od=class{constructor(e){this.id=vw++,this.code=e,this.usedTimes=0}};function xw(i){return i===tr||i===$o||i===Zo}function yw(i,e,t,n,s,r){let a=new ba,o=new ad,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return l.add(v),v===0?"uv":`uv${v}`}function g(v,E,V,U,D,G){let W=U.fog,N=D.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?U.environment:null,K=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,z=e.get(v.envMap||H,K),he=f[v.type],J=n.precision;v.precision!==null&&(J=n.getMaxPrecision(v.precision),J!==v.precision&&Ke("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let Q=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,se=Q!==void 0?Q.length:0,de=0;N.morphAttributes.position!==void 0&&(de=1),N.morphAttributes.normal!==void 0&&(de=2),N.morphAttributes.color!==void 0&&(de=3);let fe,ee,ge,xe;if(he){let Re=is[he];fe=Re.vertexShader,ee=Re.fragmentShader}else{fe=v.vertexShader,ee=v.fragmentShader;let Re=o.getVertexShaderStage(v),ut=o.getFragmentShaderStage(v);o.update(v,Re,ut),ge=Re.id,xe=ut.id}let Ce=i.getRenderTarget(),Me=i.state.buffers.depth.getReversed(),Ye=D.isInstancedMesh===!0,lt=D.isBatchedMesh===!0,Xe=!!v.map,mt=!!v.matcap,ft=!!z,at=ft&&z.isPMREMTexture===!0,Jt=!!v.aoMap,Ht=!!v.lightMap,cn=!!v.bumpMap&&v.wireframe===!1,Ot=!!v.normalMap,Tn=!!v.displacementMap,wt=!!v.emissiveMap,xn=!!v.metalnessMap,en=!!v.roughnessMap,hn=v.anisotropy>0,O=v.clearcoat>0,Pe=v.diffuseRoughness>0,Je=v.dispersion>0,ct=v.retroreflectivity>0,we=v.iridescence>0,kt=v.sheen>0,He=v.transmission>0,Ze=hn&&!!v.anisotropyMap,A=O&&!!v.clearcoatMap,x=O&&!!v.clearcoatNormalMap,q=O&&!!v.clearcoatRoughnessMap,ue=Pe&&!!v.diffuseRoughnessMap,oe=we&&!!v.iridescenceMap,ve=we&&!!v.iridescenceThicknessMap,ye=kt&&!!v.sheenColorMap,te=kt&&!!v.sheenRoughnessMap,ie=!!v.specularMap,me=!!v.specularColorMap,F=!!v.specularIntensityMap,ae=He&&!!v.transmissionMap,ne=He&&!!v.thicknessMap,Ee=!!v.gradientMap,_e=!!v.alphaMap,Se=v.alphaTest>0,qe=!!v.alphaHash,et=!!v.extensions,ce=ts;v.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(ce=i.toneMapping);let ke=at?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,tt={shaderID:he,shaderType:v.type,shaderName:v.name,vertexShader:fe,fragmentShader:ee,defines:v.defines,customVertexShaderID:ge,customFragmentShaderID:xe,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:lt,batchingColor:lt&&D._colorsTexture!==null,instancing:Ye,instancingColor:Ye&&D.instanceColor!==null,instancingMorph:Ye&&D.morphTexture!==null,outputColorSpace:Ce===null?i.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:bt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Xe,matcap:mt,envMap:ft,envMapMode:ft&&z.mapping,envMapPMREM:at,envMapMaxLod:at?ke.length-1:null,envMapSize:at?ke[0].width:null,aoMap:Jt,lightMap:Ht,bumpMap:cn,normalMap:Ot,displacementMap:Tn,emissiveMap:wt,normalMapObjectSpace:Ot&&v.normalMapType===eg,normalMapTangentSpace:Ot&&v.normalMapType===zf,packedNormalMap:Ot&&v.normalMapType===zf&&xw(v.normalMap.format),metalnessMap:xn,roughnessMap:en,anisotropy:hn,anisotropyMap:Ze,clearcoat:O,clearcoatMap:A,clearcoatNormalMap:x,clearcoatRoughnessMap:q,diffuseRoughness:Pe,diffuseRoughnessMap:ue,dispersion:Je,retroreflection:ct,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:ve,sheen:kt,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:ie,specularColorMap:me,specularIntensityMap:F,transmission:He,transmissionMap:ae,thicknessMap:ne,gradientMap:Ee,opaque:v.transparent===!1&&v.blending===Ca&&v.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:qe,combine:v.combine,mapUv:Xe&&d(v.map.channel),aoMapUv:Jt&&d(v.aoMap.channel),lightMapUv:Ht&&d(v.lightMap.channel),bumpMapUv:cn&&d(v.bumpMap.channel),normalMapUv:Ot&&d(v.normalMap.channel),displacementMapUv:Tn&&d(v.displacementMap.channel),emissiveMapUv:wt&&d(v.emissiveMap.channel),metalnessMapUv:xn&&d(v.metalnessMap.channel),roughnessMapUv:en&&d(v.roughnessMap.channel),anisotropyMapUv:Ze&&d(v.anisotropyMap.channel),clearcoatMapUv:A&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:x&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(v.sheenRoughnessMap.channel),specularMapUv:ie&&d(v.specularMap.channel),specularColorMapUv:me&&d(v.specularColorMap.channel),specularIntensityMapUv:F&&d(v.specularIntensityMap.channel),transmissionMapUv:ae&&d(v.transmissionMap.channel),thicknessMapUv:ne&&d(v.thicknessMap.channel),alphaMapUv:_e&&d(v.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Ot||hn),vertexNormals:!!N.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(Xe||_e),fog:!!W,useFog:v.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||N.attributes.normal===void 0&&Ot===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Me,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:de,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:G.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&V.length>0,shadowMapType:i.shadowMap.type,toneMapping:ce,decodeVideoTexture:Xe&&v.map.isVideoTexture===!0&&bt.getTransfer(v.map.colorSpace)===Lt,decodeVideoTextureEmissive:wt&&v.emissiveMap.isVideoTexture===!0&&bt.getTransfer(v.emissiveMap.colorSpace)===Lt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===ni,flipSided:v.side===Qn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:et&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&v.extensions.multiDraw===!0||lt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function b(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let V in v.defines)E.push(V),E.push(v.defines[V]);return v.isRawShaderMaterial===!1&&(p(E,v),m(E,v),E.push(i.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function p(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function m(v,E){a.disableAll(),E.instancing&&a.enable(0),E.instancingColor&&a.enable(1),E.instancingMorph&&a.enable(2),E.matcap&&a.enable(3),E.envMap&&a.enable(4),E.normalMapObjectSpace&&a.enable(5),E.normalMapTangentSpace&&a.enable(6),E.clearcoat&&a.enable(7),E.iridescence&&a.enable(8),E.alphaTest&&a.enable(9),E.vertexColors&&a.enable(10),E.vertexAlphas&&a.enable(11),E.vertexUv1s&&a.enable(12),E.vertexUv2s&&a.enable(13),E.vertexUv3s&&a.enable(14),E.vertexTangents&&a.enable(15),E.anisotropy&&a.enable(16),E.alphaHash&&a.enable(17),E.batching&&a.enable(18),E.dispersion&&a.enable(19),E.retroreflection&&a.enable(24),E.diffuseRoughness&&a.enable(25),E.batchingColor&&a.enable(20),E.gradientMap&&a.enable(21),E.packedNormalMap&&a.enable(22),E.vertexNormals&&a.enable(23),v.push(a.mask),a.disableAll(),E.fog&&a.enable(0),E.useFog&&a.enable(1),E.flatShading&&a.enable(2),E.logarithmicDepthBuffer&&a.enable(3),E.reversedDepthBuffer&&a.enable(4),E.skinning&&a.enable(5),E.morphTargets&&a.enable(6),E.morphNormals&&a.enable(7),E.morphColors&&a.enable(8),E.premultipliedAlpha&&a.enable(9),E.shadowMapEnabled&&a.enable(10),E.doubleSided&&a.enable(11),E.flipSided&&a.enable(12),E.useDepthPacking&&a.enable(13),E.dithering&&a.enable(14),E.transmission&&a.enable(15),E.sheen&&a.enable(16),E.opaque&&a.enable(17),E.pointsUvs&&a.enable(18),E.decodeVideoTexture&&a.enable(19),E.decodeVideoTextureEmissive&&a.enable(20),E.alphaToCoverage&&a.enable(21),E.numLightProbeGrids>0&&a.enable(22),E.hasPositionAttribute&&a.enable(23),v.push(a.mask)}function y(v){let E=f[v.type],V;if(E){let U=is[E];V=mg.clone(U.uniforms)}else V=v.uniforms;return V}function C(v,E){let V=h.get(E);return V!==void 0?++V.usedTimes:(V=new _w(i,E,v,s),c.push(V),h.set(E,V)),V}function w(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function I(v){o.remove(v)}function T(){o.dispose()}return{getParameters:g,getProgramCacheKey:b,getUniforms:y,acquireProgram:C,releaseProgram:w,releaseShaderCache:I,programs:c,dispose:T}}function bw(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function Sw(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Ug(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Fg(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function a(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function o(f,d,g,b,p,m){let y=i[e];return y===void 0?(y={id:f.id,object:f,geometry:d,material:g,materialVariant:a(f),groupOrder:b,renderOrder:f.renderOrder,z:p,group:m},i[e]=y):(y.id=f.id,y.object=f,y.geometry=d,y.material=g,y.materialVariant=a(f),y.groupOrder=b,y.renderOrder=f.renderOrder,y.z=p,y.group=m),e++,y}function l(f,d,g,b,p,m,y){y.reversedDepth===!0&&(p=-p);let C=o(f,d,g,b,p,m);g.transmission>0?n.push(C):g.transparent===!0?s.push(C):t.push(C)}function c(f,d,g,b,p,m){let y=o(f,d,g,b,p,m);g.transmission>0?n.unshift(y):g.transparent===!0?s.unshift(y):t.unshift(y)}function h(f,d){t.length>1&&t.sort(f||Sw),n.length>1&&n.sort(d||Ug),s.length>1&&s.sort(d||Ug)}function u(){for(let f=e,d=i.length;f<d;f++){let g=i[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function Mw(){let i=new WeakMap;function e(n,s){let r=i.get(n),a;return r===void 0?(a=new Fg,i.set(n,[a])):s>=r.length?(a=new Fg,r.push(a)):a=r[s],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function ww(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new X,color:new St};break;case"SpotLight":t={position:new X,direction:new X,color:new St,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new X,color:new St,distance:0,decay:0};break;case"HemisphereLight":t={direction:new X,skyColor:new St,groundColor:new St};break;case"RectAreaLight":t={color:new St,position:new X,halfWidth:new X,halfHeight:new X};break}return i[e.id]=t,t}}}function Ew(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var Tw=0;function Aw(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function Cw(i){let e=new ww,t=Ew(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new X);let s=new X,r=new Gt,a=new Gt;function o(c){let h=0,u=0,f=0;for(let G=0;G<9;G++)n.probe[G].set(0,0,0);let d=0,g=0,b=0,p=0,m=0,y=0,C=0,w=0,I=0,T=0,v=0,E=0,V=0,U=0;c.sort(Aw);for(let G=0,W=c.length;G<W;G++){let N=c[G],H=N.color,K=N.intensity,z=N.distance,he=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===tr?he=N.shadow.map.texture:he=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)h+=H.r*K,u+=H.g*K,f+=H.b*K;else if(N.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(N.sh.coefficients[J],K);U++}else if(N.isSunLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=se,n.sunShadowMap[g]=he;let de=Q.getViewportCount();for(let fe=0;fe<de;fe++)n.sunShadowMatrix[b+fe]=Q.getMatrix(fe),n.sunShadowCascade[b+fe]=Q._cascadeData[fe];b+=de,g++}n.sun[d]=J,d++}else if(N.isDirectionalLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let Q=N.shadow,se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,n.directionalShadow[p]=se,n.directionalShadowMap[p]=he,n.directionalShadowMatrix[p]=N.shadow.matrix,I++}n.directional[p]=J,p++}else if(N.isSpotLight){let J=e.get(N);J.position.setFromMatrixPosition(N.matrixWorld),J.color.copy(H).multiplyScalar(K),J.distance=z,J.coneCos=Math.cos(N.angle),J.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),J.decay=N.decay,n.spot[y]=J;let Q=N.shadow;if(N.map&&(n.spotLightMap[E]=N.map,E++,Q.updateMatrices(N),N.castShadow&&V++),n.spotLightMatrix[y]=Q.matrix,N.castShadow){let se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,n.spotShadow[y]=se,n.spotShadowMap[y]=he,v++}y++}else if(N.isRectAreaLight){let J=e.get(N);J.color.copy(H).multiplyScalar(K),J.halfWidth.set(N.width*.5,0,0),J.halfHeight.set(0,N.height*.5,0),n.rectArea[C]=J,C++}else if(N.isPointLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),J.distance=N.distance,J.decay=N.decay,N.castShadow){let Q=N.shadow,se=t.get(N);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,n.pointShadow[m]=se,n.pointShadowMap[m]=he,n.pointShadowMatrix[m]=N.shadow.matrix,T++}n.point[m]=J,m++}else if(N.isHemisphereLight){let J=e.get(N);J.skyColor.copy(N.color).multiplyScalar(K),J.groundColor.copy(N.groundColor).multiplyScalar(K),n.hemi[w]=J,w++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=De.LTC_FLOAT_1,n.rectAreaLTC2=De.LTC_FLOAT_2):(n.rectAreaLTC1=De.LTC_HALF_1,n.rectAreaLTC2=De.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=f;let D=n.hash;(D.sunLength!==d||D.directionalLength!==p||D.pointLength!==m||D.spotLength!==y||D.rectAreaLength!==C||D.hemiLength!==w||D.numSunShadows!==g||D.numDirectionalShadows!==I||D.numPointShadows!==T||D.numSpotShadows!==v||D.numSpotMaps!==E||D.numLightProbes!==U)&&(n.sun.length=d,n.directional.length=p,n.spot.length=y,n.rectArea.length=C,n.point.length=m,n.hemi.length=w,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=b,n.sunShadowCascade.length=b,n.directionalShadow.length=I,n.directionalShadowMap.length=I,n.directionalShadowMatrix.length=I,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+E-V,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=V,n.numLightProbes=U,D.sunLength=d,D.directionalLength=p,D.pointLength=m,D.spotLength=y,D.rectAreaLength=C,D.hemiLength=w,D.numSunShadows=g,D.numDirectionalShadows=I,D.numPointShadows=T,D.numSpotShadows=v,D.numSpotMaps=E,D.numLightProbes=U,n.version=Tw++)}function l(c,h){let u=0,f=0,d=0,g=0,b=0,p=0,m=h.matrixWorldInverse;for(let y=0,C=c.length;y<C;y++){let w=c[y];if(w.isSunLight){let I=n.sun[u];I.direction.setFromMatrixPosition(w.matrixWorld),I.direction.transformDirection(m),u++}else if(w.isDirectionalLight){let I=n.directional[f];I.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(m),f++}else if(w.isSpotLight){let I=n.spot[g];I.position.setFromMatrixPosition(w.matrixWorld),I.position.applyMatrix4(m),I.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(m),g++}else if(w.isRectAreaLight){let I=n.rectArea[b];I.position.setFromMatrixPosition(w.matrixWorld),I.position.applyMatrix4(m),a.identity(),r.copy(w.matrixWorld),r.premultiply(m),a.extractRotation(r),I.halfWidth.set(w.width*.5,0,0),I.halfHeight.set(0,w.height*.5,0),I.halfWidth.applyMatrix4(a),I.halfHeight.applyMatrix4(a),b++}else if(w.isPointLight){let I=n.point[d];I.position.setFromMatrixPosition(w.matrixWorld),I.position.applyMatrix4(m),d++}else if(w.isHemisphereLight){let I=n.hemi[p];I.direction.setFromMatrixPosition(w.matrixWorld),I.direction.transformDirection(m),p++}}}return{setup:o,setupView:l,state:n}}function Og(i){let e=new Cw(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function a(u){u.isLightProbeGrid?s.push(u):t.push(u)}function o(u){n.push(u)}function l(){e.setup(t),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function Rw(i){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new Og(i),e.set(s,[o])):r>=a.length?(o=new Og(i),a.push(o)):o=a[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}var Pw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Iw=`uniform sampler2D shadow_pass;
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
}`,Lw=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],Dw=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],Bg=new Gt,Ko=new X,td=new X;function Nw(i,e,t){let n=new xr,s=new it,r=new it,a=new Zt,o=new Ac,l=new Cc,c={},h=t.maxTextureSize,u={[er]:Qn,[Qn]:er,[ni]:ni},f=new On({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new it},radius:{value:4}},vertexShader:Pw,fragmentShader:Iw}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let g=new mi;g.setAttribute("position",new Fn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Hn(g,f),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ho;let m=this.type;this.render=function(T,v,E){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||T.length===0)return;this.type===Im&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ho);let V=i.getRenderTarget(),U=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),G=i.state;G.setBlending(br),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let W=m!==this.type;W&&v.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(H=>H.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,H=T.length;N<H;N++){let K=T[N],z=K.shadow;if(z===void 0){Ke("WebGLShadowMap:",K,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let he=z.getFrameExtents();s.multiply(he),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/he.x),s.x=r.x*he.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/he.y),s.y=r.y*he.y,z.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=J,z.map===null||W===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===Aa){if(K.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new di(s.x,s.y,{format:tr,type:Vi,minFilter:jn,magFilter:jn,generateMipmaps:!1}),z.map.texture.name=K.name+".shadowMap",z.map.depthTexture=new Ms(s.x,s.y,zi),z.map.depthTexture.name=K.name+".shadowMapDepth",z.map.depthTexture.format=Ss,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=gn,z.map.depthTexture.magFilter=gn}else K.isPointLight?(z.map=new jo(s.x),z.map.depthTexture=new No(s.x,ki)):(z.map=new di(s.x,s.y),z.map.depthTexture=new Ms(s.x,s.y,ki)),z.map.depthTexture.name=K.name+".shadowMap",z.map.depthTexture.format=Ss,this.type===Ho?(z.map.depthTexture.compareFunction=J?Hf:Vf,z.map.depthTexture.minFilter=jn,z.map.depthTexture.magFilter=jn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=gn,z.map.depthTexture.magFilter=gn);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();K.isPointLight!==!0&&z.updateMatrices(K,E);let se=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:E.layers;for(let de=0;de<Q;de++){let fe=z.getCamera(de);if(K.isPointLight){let ee=z.camera,ge=z.matrix,xe=K.distance||ee.far;xe!==ee.far&&(ee.far=xe,ee.updateProjectionMatrix()),Ko.setFromMatrixPosition(K.matrixWorld),ee.position.copy(Ko),td.copy(ee.position),td.add(Lw[de]),ee.up.copy(Dw[de]),ee.lookAt(td),ee.updateMatrixWorld(),ge.makeTranslation(-Ko.x,-Ko.y,-Ko.z),Bg.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),z._frustum.setFromProjectionMatrix(Bg,ee.coordinateSystem,ee.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,de),i.clear();else{de===0&&(i.setRenderTarget(z.map),i.clear());let ee=z.getViewport(de);a.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),G.viewport(a)}n=z.getFrustum(de),w(v,E,fe,K,se,this.type)}z.isPointLightShadow!==!0&&this.type===Aa&&y(z,E),z.needsUpdate=!1}m=this.type,p.needsUpdate=!1,i.setRenderTarget(V,U,D)};function y(T,v){let E=e.update(b);f.defines.VSM_SAMPLES!==T.blurSamples&&(f.defines.VSM_SAMPLES=T.blurSamples,d.defines.VSM_SAMPLES=T.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),T.mapPass===null?T.mapPass=new di(s.x,s.y,{format:tr,type:Vi}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),f.uniforms.shadow_pass.value=T.map.depthTexture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(v,null,E,f,b,null),d.uniforms.shadow_pass.value=T.mapPass.texture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(v,null,E,d,b,null)}function C(T,v,E,V){let U=null,D=E.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(D!==void 0)U=D;else if(U=E.isPointLight===!0?l:o,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let G=U.uuid,W=v.uuid,N=c[G];N===void 0&&(N={},c[G]=N);let H=N[W];H===void 0&&(H=U.clone(),N[W]=H,v.addEventListener("dispose",I)),U=H}if(U.visible=v.visible,U.wireframe=v.wireframe,V===Aa?U.side=v.shadowSide!==null?v.shadowSide:v.side:U.side=v.shadowSide!==null?v.shadowSide:u[v.side],U.alphaMap=v.alphaMap,U.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,U.map=v.map,U.clipShadows=v.clipShadows,U.clippingPlanes=v.clippingPlanes,U.clipIntersection=v.clipIntersection,U.displacementMap=v.displacementMap,U.displacementScale=v.displacementScale,U.displacementBias=v.displacementBias,U.wireframeLinewidth=v.wireframeLinewidth,U.linewidth=v.linewidth,E.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let G=i.properties.get(U);G.light=E}return U}function w(T,v,E,V,U,D){if(T.visible===!1)return;if(T.layers.test(U)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&D===Aa)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,T.matrixWorld);let N=e.update(T),H=T.material;if(Array.isArray(H)){let K=N.groups;for(let z=0,he=K.length;z<he;z++){let J=K[z],Q=H[J.materialIndex];if(Q&&Q.visible){let se=C(T,Q,V,D);T.onBeforeShadow(i,T,v,E,N,se,J),i.renderBufferDirect(E,null,N,se,T,J),T.onAfterShadow(i,T,v,E,N,se,J)}}}else if(H.visible){let K=C(T,H,V,D);T.onBeforeShadow(i,T,v,E,N,K,null),i.renderBufferDirect(E,null,N,K,T,null),T.onAfterShadow(i,T,v,E,N,K,null)}}let W=T.children;for(let N=0,H=W.length;N<H;N++)w(W[N],v,E,V,U,D)}function I(T){T.target.removeEventListener("dispose",I);for(let E in c){let V=c[E],U=T.target.uuid;U in V&&(V[U].dispose(),delete V[U])}}}function Uw(i,e){function t(){let F=!1,ae=new Zt,ne=null,Ee=new Zt(0,0,0,0);return{setMask:function(_e){ne!==_e&&!F&&(i.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){F=_e},setClear:function(_e,Se,qe,et,ce){ce===!0&&(_e*=et,Se*=et,qe*=et),ae.set(_e,Se,qe,et),Ee.equals(ae)===!1&&(i.clearColor(_e,Se,qe,et),Ee.copy(ae))},reset:function(){F=!1,ne=null,Ee.set(-1,0,0,0)}}}function n(){let F=!1,ae=!1,ne=null,Ee=null,_e=null;return{setReversed:function(Se){if(ae!==Se){let qe=e.get("EXT_clip_control");Se?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),ae=Se;let et=_e;_e=null,this.setClear(et)}},getReversed:function(){return ae},setTest:function(Se){Se?Me(i.DEPTH_TEST):Ye(i.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!F&&(i.depthMask(Se),ne=Se)},setFunc:function(Se){if(ae&&(Se=ug[Se]),Ee!==Se){switch(Se){case oc:i.depthFunc(i.NEVER);break;case lc:i.depthFunc(i.ALWAYS);break;case cc:i.depthFunc(i.LESS);break;case _a:i.depthFunc(i.LEQUAL);break;case hc:i.depthFunc(i.EQUAL);break;case uc:i.depthFunc(i.GEQUAL);break;case fc:i.depthFunc(i.GREATER);break;case dc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ee=Se}},setLocked:function(Se){F=Se},setClear:function(Se){_e!==Se&&(_e=Se,ae&&(Se=1-Se),i.clearDepth(Se))},reset:function(){F=!1,ne=null,Ee=null,_e=null,ae=!1}}}function s(){let F=!1,ae=null,ne=null,Ee=null,_e=null,Se=null,qe=null,et=null,ce=null;return{setTest:function(ke){F||(ke?Me(i.STENCIL_TEST):Ye(i.STENCIL_TEST))},setMask:function(ke){ae!==ke&&!F&&(i.stencilMask(ke),ae=ke)},setFunc:function(ke,tt,Re){(ne!==ke||Ee!==tt||_e!==Re)&&(i.stencilFunc(ke,tt,Re),ne=ke,Ee=tt,_e=Re)},setOp:function(ke,tt,Re){(Se!==ke||qe!==tt||et!==Re)&&(i.stencilOp(ke,tt,Re),Se=ke,qe=tt,et=Re)},setLocked:function(ke){F=ke},setClear:function(ke){ce!==ke&&(i.clearStencil(ke),ce=ke)},reset:function(){F=!1,ae=null,ne=null,Ee=null,_e=null,Se=null,qe=null,et=null,ce=null}}}let r=new t,a=new n,o=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,g=[],b=null,p=!1,m=null,y=null,C=null,w=null,I=null,T=null,v=null,E=new St(0,0,0),V=0,U=!1,D=null,G=null,W=null,N=null,H=null,K=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,he=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(he=parseFloat(/^WebGL (\d)/.exec(J)[1]),z=he>=1):J.indexOf("OpenGL ES")!==-1&&(he=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),z=he>=2);let Q=null,se={},de=i.getParameter(i.SCISSOR_BOX),fe=i.getParameter(i.VIEWPORT),ee=new Zt().fromArray(de),ge=new Zt().fromArray(fe);function xe(F,ae,ne,Ee){let _e=new Uint8Array(4),Se=i.createTexture();i.bindTexture(F,Se),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let qe=0;qe<ne;qe++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(ae,0,i.RGBA,1,1,Ee,0,i.RGBA,i.UNSIGNED_BYTE,_e):i.texImage2D(ae+qe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_e);return Se}let Ce={};Ce[i.TEXTURE_2D]=xe(i.TEXTURE_2D,i.TEXTURE_2D,1),Ce[i.TEXTURE_CUBE_MAP]=xe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[i.TEXTURE_2D_ARRAY]=xe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ce[i.TEXTURE_3D]=xe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),Me(i.DEPTH_TEST),a.setFunc(_a),cn(!1),Ot(vf),Me(i.CULL_FACE),Jt(br);function Me(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function Ye(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function lt(F,ae){return f[F]!==ae?(i.bindFramebuffer(F,ae),f[F]=ae,F===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ae),F===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ae),!0):!1}function Xe(F,ae){let ne=g,Ee=!1;if(F){ne=d.get(ae),ne===void 0&&(ne=[],d.set(ae,ne));let _e=F.textures;if(ne.length!==_e.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Se=0,qe=_e.length;Se<qe;Se++)ne[Se]=i.COLOR_ATTACHMENT0+Se;ne.length=_e.length,Ee=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Ee=!0);Ee&&i.drawBuffers(ne)}function mt(F){return b!==F?(i.useProgram(F),b=F,!0):!1}let ft={[Sr]:i.FUNC_ADD,[Dm]:i.FUNC_SUBTRACT,[Nm]:i.FUNC_REVERSE_SUBTRACT};ft[Um]=i.MIN,ft[Fm]=i.MAX;let at={[Om]:i.ZERO,[Bm]:i.ONE,[km]:i.SRC_COLOR,[Sf]:i.SRC_ALPHA,[Xm]:i.SRC_ALPHA_SATURATE,[Gm]:i.DST_COLOR,[Vm]:i.DST_ALPHA,[zm]:i.ONE_MINUS_SRC_COLOR,[Mf]:i.ONE_MINUS_SRC_ALPHA,[Wm]:i.ONE_MINUS_DST_COLOR,[Hm]:i.ONE_MINUS_DST_ALPHA,[qm]:i.CONSTANT_COLOR,[Ym]:i.ONE_MINUS_CONSTANT_COLOR,[$m]:i.CONSTANT_ALPHA,[Zm]:i.ONE_MINUS_CONSTANT_ALPHA};function Jt(F,ae,ne,Ee,_e,Se,qe,et,ce,ke){if(F===br){p===!0&&(Ye(i.BLEND),p=!1);return}if(p===!1&&(Me(i.BLEND),p=!0),F!==Lm){if(F!==m||ke!==U){if((y!==Sr||I!==Sr)&&(i.blendEquation(i.FUNC_ADD),y=Sr,I=Sr),ke)switch(F){case Ca:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case xf:i.blendFunc(i.ONE,i.ONE);break;case yf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case bf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:nt("WebGLState: Invalid blending: ",F);break}else switch(F){case Ca:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case xf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case yf:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case bf:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",F);break}C=null,w=null,T=null,v=null,E.set(0,0,0),V=0,m=F,U=ke}return}_e=_e||ae,Se=Se||ne,qe=qe||Ee,(ae!==y||_e!==I)&&(i.blendEquationSeparate(ft[ae],ft[_e]),y=ae,I=_e),(ne!==C||Ee!==w||Se!==T||qe!==v)&&(i.blendFuncSeparate(at[ne],at[Ee],at[Se],at[qe]),C=ne,w=Ee,T=Se,v=qe),(et.equals(E)===!1||ce!==V)&&(i.blendColor(et.r,et.g,et.b,ce),E.copy(et),V=ce),m=F,U=!1}function Ht(F,ae){F.side===ni?Ye(i.CULL_FACE):Me(i.CULL_FACE);let ne=F.side===Qn;ae&&(ne=!ne),cn(ne),F.blending===Ca&&F.transparent===!1?Jt(br):Jt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),a.setFunc(F.depthFunc),a.setTest(F.depthTest),a.setMask(F.depthWrite),r.setMask(F.colorWrite);let Ee=F.stencilWrite;o.setTest(Ee),Ee&&(o.setMask(F.stencilWriteMask),o.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),o.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),wt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Me(i.SAMPLE_ALPHA_TO_COVERAGE):Ye(i.SAMPLE_ALPHA_TO_COVERAGE)}function cn(F){D!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),D=F)}function Ot(F){F!==Rm?(Me(i.CULL_FACE),F!==G&&(F===vf?i.cullFace(i.BACK):F===Pm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ye(i.CULL_FACE),G=F}function Tn(F){F!==W&&(z&&i.lineWidth(F),W=F)}function wt(F,ae,ne){F?(Me(i.POLYGON_OFFSET_FILL),(N!==ae||H!==ne)&&(N=ae,H=ne,a.getReversed()&&(ae=-ae,ne=-ne),i.polygonOffset(ae,ne))):Ye(i.POLYGON_OFFSET_FILL)}function xn(F){F?Me(i.SCISSOR_TEST):Ye(i.SCISSOR_TEST)}function en(F){F===void 0&&(F=i.TEXTURE0+K-1),Q!==F&&(i.activeTexture(F),Q=F)}function hn(F,ae,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+K-1:ne=Q);let Ee=se[ne];Ee===void 0&&(Ee={type:void 0,texture:void 0},se[ne]=Ee),(Ee.type!==F||Ee.texture!==ae)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(F,ae||Ce[F]),Ee.type=F,Ee.texture=ae)}function O(){let F=se[Q];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Pe(){try{i.compressedTexImage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function Je(){try{i.compressedTexImage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function ct(){try{i.texSubImage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function we(){try{i.texSubImage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function kt(){try{i.compressedTexSubImage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function He(){try{i.compressedTexSubImage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function Ze(){try{i.texStorage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function A(){try{i.texStorage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function x(){try{i.texImage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function q(){try{i.texImage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function ue(F){return u[F]!==void 0?u[F]:i.getParameter(F)}function oe(F,ae){u[F]!==ae&&(i.pixelStorei(F,ae),u[F]=ae)}function ve(F){ee.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),ee.copy(F))}function ye(F){ge.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),ge.copy(F))}function te(F,ae){let ne=c.get(ae);ne===void 0&&(ne=new WeakMap,c.set(ae,ne));let Ee=ne.get(F);Ee===void 0&&(Ee=i.getUniformBlockIndex(ae,F.name),i.uniformBlockBinding(ae,Ee,Ee),ne.set(F,Ee))}function ie(F,ae,ne){let _e=c.get(ae).get(F);l[_e]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,_e,ne),l[_e]=ne)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,se={},f={},l={},d=new WeakMap,g=[],b=null,p=!1,m=null,y=null,C=null,w=null,I=null,T=null,v=null,E=new St(0,0,0),V=0,U=!1,D=null,G=null,W=null,N=null,H=null,ee.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:Me,disable:Ye,bindFramebuffer:lt,drawBuffers:Xe,useProgram:mt,setBlending:Jt,setMaterial:Ht,setFlipSided:cn,setCullFace:Ot,setLineWidth:Tn,setPolygonOffset:wt,setScissorTest:xn,activeTexture:en,bindTexture:hn,unbindTexture:O,compressedTexImage2D:Pe,compressedTexImage3D:Je,texImage2D:x,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:Ze,texStorage3D:A,texSubImage2D:ct,texSubImage3D:we,compressedTexSubImage2D:kt,compressedTexSubImage3D:He,scissor:ve,viewport:ye,reset:me}}function Fw(i,e,t,n,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new it,h=new WeakMap,u=new Set,f,d=new WeakMap,g=new Set,b=new FinalizationRegistry(A=>g.delete(A)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(A,x){return p?new OffscreenCanvas(A,x):Ao("canvas")}function y(A,x,q){let ue=1,oe=Ze(A);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let ve=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);f===void 0&&(f=m(ve,ye));let te=x?m(ve,ye):f;return te.width=ve,te.height=ye,te.getContext("2d").drawImage(A,0,0,ve,ye),Ke("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ve+"x"+ye+")."),te}else return"data"in A&&Ke("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),A;return A}function C(A){return A.generateMipmaps}function w(A){i.generateMipmap(A)}function I(A){return A.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?i.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(A,x,q,ue,oe,ve=!1){if(A!==null){if(i[A]!==void 0)return i[A];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=x;if(x===i.RED&&(q===i.FLOAT&&(te=i.R32F),q===i.HALF_FLOAT&&(te=i.R16F),q===i.UNSIGNED_BYTE&&(te=i.R8),q===i.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===i.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),x===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.R8UI),q===i.UNSIGNED_SHORT&&(te=i.R16UI),q===i.UNSIGNED_INT&&(te=i.R32UI),q===i.BYTE&&(te=i.R8I),q===i.SHORT&&(te=i.R16I),q===i.INT&&(te=i.R32I)),x===i.RG&&(q===i.FLOAT&&(te=i.RG32F),q===i.HALF_FLOAT&&(te=i.RG16F),q===i.UNSIGNED_BYTE&&(te=i.RG8),q===i.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===i.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),x===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RG8UI),q===i.UNSIGNED_SHORT&&(te=i.RG16UI),q===i.UNSIGNED_INT&&(te=i.RG32UI),q===i.BYTE&&(te=i.RG8I),q===i.SHORT&&(te=i.RG16I),q===i.INT&&(te=i.RG32I)),x===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGB8UI),q===i.UNSIGNED_SHORT&&(te=i.RGB16UI),q===i.UNSIGNED_INT&&(te=i.RGB32UI),q===i.BYTE&&(te=i.RGB8I),q===i.SHORT&&(te=i.RGB16I),q===i.INT&&(te=i.RGB32I)),x===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),q===i.UNSIGNED_INT&&(te=i.RGBA32UI),q===i.BYTE&&(te=i.RGBA8I),q===i.SHORT&&(te=i.RGBA16I),q===i.INT&&(te=i.RGBA32I)),x===i.RGB&&(q===i.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===i.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),x===i.RGBA){let ie=ve?Eo:bt.getTransfer(oe);q===i.FLOAT&&(te=i.RGBA32F),q===i.HALF_FLOAT&&(te=i.RGBA16F),q===i.UNSIGNED_BYTE&&(te=ie===Lt?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===i.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(A,x){let q;return A?x===null||x===ki||x===wr?q=i.DEPTH24_STENCIL8:x===zi?q=i.DEPTH32F_STENCIL8:x===Pa&&(q=i.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===ki||x===wr?q=i.DEPTH_COMPONENT24:x===zi?q=i.DEPTH_COMPONENT32F:x===Pa&&(q=i.DEPTH_COMPONENT16),q}function E(A,x){return C(A)===!0||A.isFramebufferTexture&&A.minFilter!==gn&&A.minFilter!==jn?Math.log2(Math.max(x.width,x.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?x.mipmaps.length:1}function V(A){let x=new WeakRef(A);n.get(A).__ref=x,g.add(x),b.register(A,x,x)}function U(A){let x=n.get(A).__ref;x!==void 0&&(g.delete(x),b.unregister(x))}function D(A){W(A.target)}function G(A){N(A.target)}function W(A){A.removeEventListener("dispose",D),U(A),K(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&u.delete(A)}function N(A){A.removeEventListener("dispose",G),U(A),he(A)}function H(){for(let A of g){let x=A.deref();x!==void 0&&(x.isRenderTarget===!0?N(x):W(x))}g.clear(),u.clear()}function K(A){let x=n.get(A);if(x.__webglInit===void 0)return;let q=A.source,ue=d.get(q);if(ue){let oe=ue[x.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&z(A),Object.keys(ue).length===0&&d.delete(q)}n.remove(A)}function z(A){let x=n.get(A);i.deleteTexture(x.__webglTexture);let q=A.source,ue=d.get(q);delete ue[x.__cacheKey],a.memory.textures--}function he(A){let x=n.get(A);x.__depthDisposeCallback&&x.__depthDisposeCallback();let q=A.depthTexture;if(q&&q.renderTarget===A&&W(q),A.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(x.__webglFramebuffer[oe]))for(let ve=0;ve<x.__webglFramebuffer[oe].length;ve++)i.deleteFramebuffer(x.__webglFramebuffer[oe][ve]);else i.deleteFramebuffer(x.__webglFramebuffer[oe]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[oe])}else{if(Array.isArray(x.__webglFramebuffer))for(let oe=0;oe<x.__webglFramebuffer.length;oe++)i.deleteFramebuffer(x.__webglFramebuffer[oe]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let oe=0;oe<x.__webglColorRenderbuffer.length;oe++)x.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[oe]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let ue=A.textures;for(let oe=0,ve=ue.length;oe<ve;oe++){let ye=n.get(ue[oe]);ye.__webglTexture&&(i.deleteTexture(ye.__webglTexture),a.memory.textures--),n.remove(ue[oe])}n.remove(A)}let J=0;function Q(){J=0}function se(){return J}function de(A){J=A}function fe(){let A=J;return A>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,A}function ee(A){let x=[];return x.push(A.wrapS),x.push(A.wrapT),x.push(A.wrapR||0),x.push(A.magFilter),x.push(A.minFilter),x.push(A.anisotropy),x.push(A.internalFormat),x.push(A.format),x.push(A.type),x.push(A.generateMipmaps),x.push(A.mipmapsAutoUpdate),x.push(A.premultiplyAlpha),x.push(A.flipY),x.push(A.unpackAlignment),x.push(A.colorSpace),x.join()}function ge(A,x){let q=n.get(A);if(A.isVideoTexture&&kt(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&q.__version!==A.version){let ue=A.image;if(ue===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Ht(q,A,x);return}}else A.isExternalTexture&&(q.__webglTexture=A.sourceTexture?A.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+x)}function xe(A,x){let q=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&q.__version!==A.version){Ht(q,A,x);return}else A.isExternalTexture&&(q.__webglTexture=A.sourceTexture?A.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+x)}function Ce(A,x){let q=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&q.__version!==A.version){Ht(q,A,x);return}t.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+x)}function Me(A,x){let q=n.get(A);if(A.version>0&&q.__version!==A.version){cn(q,A,x);return}t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+x)}let Ye={[pc]:i.REPEAT,[es]:i.CLAMP_TO_EDGE,[mc]:i.MIRRORED_REPEAT},lt={[gn]:i.NEAREST,[jm]:i.NEAREST_MIPMAP_NEAREST,[Go]:i.NEAREST_MIPMAP_LINEAR,[jn]:i.LINEAR,[Gc]:i.LINEAR_MIPMAP_NEAREST,[ws]:i.LINEAR_MIPMAP_LINEAR},Xe={[ng]:i.NEVER,[Gf]:i.ALWAYS,[ig]:i.LESS,[Vf]:i.LEQUAL,[sg]:i.EQUAL,[Hf]:i.GEQUAL,[rg]:i.GREATER,[ag]:i.NOTEQUAL};function mt(A,x){if(x.type===zi&&e.has("OES_texture_float_linear")===!1&&(x.magFilter===jn||x.magFilter===Gc||x.magFilter===Go||x.magFilter===ws||x.minFilter===jn||x.minFilter===Gc||x.minFilter===Go||x.minFilter===ws)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(A,i.TEXTURE_WRAP_S,Ye[x.wrapS]),i.texParameteri(A,i.TEXTURE_WRAP_T,Ye[x.wrapT]),(A===i.TEXTURE_3D||A===i.TEXTURE_2D_ARRAY)&&i.texParameteri(A,i.TEXTURE_WRAP_R,Ye[x.wrapR]),i.texParameteri(A,i.TEXTURE_MAG_FILTER,lt[x.magFilter]),i.texParameteri(A,i.TEXTURE_MIN_FILTER,lt[x.minFilter]),x.compareFunction&&(i.texParameteri(A,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(A,i.TEXTURE_COMPARE_FUNC,Xe[x.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===gn||x.minFilter!==Go&&x.minFilter!==ws||x.type===zi&&e.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(A,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function ft(A,x){let q=!1;A.__webglInit===void 0&&(A.__webglInit=!0,x.addEventListener("dispose",D),V(x));let ue=x.source,oe=d.get(ue);oe===void 0&&(oe={},d.set(ue,oe));let ve=ee(x);if(ve!==A.__cacheKey){oe[ve]===void 0&&(oe[ve]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,q=!0),oe[ve].usedTimes++;let ye=oe[A.__cacheKey];ye!==void 0&&(oe[A.__cacheKey].usedTimes--,ye.usedTimes===0&&z(x)),A.__cacheKey=ve,A.__webglTexture=oe[ve].texture}return q}function at(A,x,q){return Math.floor(Math.floor(A/q)/x)}function Jt(A,x,q,ue){let ve=A.updateRanges;if(ve.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,q,ue,x.data);else{ve.sort((F,ae)=>F.start-ae.start);let ye=0;for(let F=1;F<ve.length;F++){let ae=ve[ye],ne=ve[F],Ee=ae.start+ae.count,_e=at(ne.start,x.width,4),Se=at(ae.start,x.width,4);ne.start<=Ee+1&&_e===Se&&at(ne.start+ne.count-1,x.width,4)===_e?ae.count=Math.max(ae.count,ne.start+ne.count-ae.start):(++ye,ve[ye]=ne)}ve.length=ye+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),ie=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let F=0,ae=ve.length;F<ae;F++){let ne=ve[F],Ee=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Se=Ee%x.width,qe=Math.floor(Ee/x.width),et=_e,ce=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(i.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(i.TEXTURE_2D,0,Se,qe,et,ce,q,ue,x.data)}A.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Ht(A,x,q){let ue=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(ue=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(ue=i.TEXTURE_3D);let oe=ft(A,x),ve=x.source;t.bindTexture(ue,A.__webglTexture,i.TEXTURE0+q);let ye=n.get(ve);if(ve.version!==ye.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&x.image instanceof ImageBitmap)===!1){let ce=bt.getPrimaries(bt.workingColorSpace),ke=x.colorSpace===Ts?null:bt.getPrimaries(x.colorSpace),tt=x.colorSpace===Ts||ce===ke?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment);let ie=y(x.image,!1,s.maxTextureSize);ie=He(x,ie);let me=r.convert(x.format,x.colorSpace),F=r.convert(x.type),ae=T(x.internalFormat,me,F,x.normalized,x.colorSpace,x.isVideoTexture);mt(ue,x);let ne,Ee=x.mipmaps,_e=x.isVideoTexture!==!0,Se=ye.__version===void 0||oe===!0,qe=ve.dataReady,et=E(x,ie);if(x.isDepthTexture)ae=v(x.format===Es,x.type),Se&&(_e?t.texStorage2D(i.TEXTURE_2D,1,ae,ie.width,ie.height):t.texImage2D(i.TEXTURE_2D,0,ae,ie.width,ie.height,0,me,F,null));else if(x.isDataTexture)if(Ee.length>0){_e&&Se&&t.texStorage2D(i.TEXTURE_2D,et,ae,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],_e?qe&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,F,ne.data):t.texImage2D(i.TEXTURE_2D,ce,ae,ne.width,ne.height,0,me,F,ne.data);x.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(i.TEXTURE_2D,et,ae,ie.width,ie.height),qe&&Jt(x,ie,me,F)):t.texImage2D(i.TEXTURE_2D,0,ae,ie.width,ie.height,0,me,F,ie.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,ae,Ee[0].width,Ee[0].height,ie.depth);for(let ce=0,ke=Ee.length;ce<ke;ce++)if(ne=Ee[ce],x.format!==vi)if(me!==null)if(_e){if(qe)if(x.layerUpdates.size>0){let tt=Qf(ne.width,ne.height,x.format,x.type);for(let Re of x.layerUpdates){let ut=ne.data.subarray(Re*tt/ne.data.BYTES_PER_ELEMENT,(Re+1)*tt/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,Re,ne.width,ne.height,1,me,ut)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,me,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ce,ae,ne.width,ne.height,ie.depth,0,ne.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?qe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,me,F,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ce,ae,ne.width,ne.height,ie.depth,0,me,F,ne.data);x.layerUpdates.size>0&&x.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(i.TEXTURE_2D,et,ae,Ee[0].width,Ee[0].height);for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],x.format!==vi?me!==null?_e?qe&&t.compressedTexSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,ce,ae,ne.width,ne.height,0,ne.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?qe&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,F,ne.data):t.texImage2D(i.TEXTURE_2D,ce,ae,ne.width,ne.height,0,me,F,ne.data)}else if(x.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(i.TEXTURE_2D_ARRAY,et,ae,ie.width,ie.height,ie.depth),qe)if(x.layerUpdates.size>0){let ce=Qf(ie.width,ie.height,x.format,x.type);for(let ke of x.layerUpdates){let tt=ie.data.subarray(ke*ce/ie.data.BYTES_PER_ELEMENT,(ke+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ke,ie.width,ie.height,1,me,F,tt)}x.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ae,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(x.isData3DTexture)_e?(Se&&t.texStorage3D(i.TEXTURE_3D,et,ae,ie.width,ie.height,ie.depth),qe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)):t.texImage3D(i.TEXTURE_3D,0,ae,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(x.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(i.TEXTURE_2D,et,ae,ie.width,ie.height);else{let ce=ie.width,ke=ie.height;for(let tt=0;tt<et;tt++)t.texImage2D(i.TEXTURE_2D,tt,ae,ce,ke,0,me,F,null),ce>>=1,ke>>=1}}else if(x.isHTMLTexture){if("texElementImage2D"in i){let ce=i.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),u.add(x),ce.onpaint=ke=>{let tt=ke.changedElements;for(let Re of u)tt.includes(Re.image)&&(Re.needsUpdate=!0)},ce.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ie);else{let tt=i.RGBA,Re=i.RGBA,ut=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Re,ut,ie)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ee.length>0){if(_e&&Se){let ce=Ze(Ee[0]);t.texStorage2D(i.TEXTURE_2D,et,ae,ce.width,ce.height)}for(let ce=0,ke=Ee.length;ce<ke;ce++)ne=Ee[ce],_e?qe&&t.texSubImage2D(i.TEXTURE_2D,ce,0,0,me,F,ne):t.texImage2D(i.TEXTURE_2D,ce,ae,me,F,ne);x.generateMipmaps=!1}else if(_e){if(Se){let ce=Ze(ie);t.texStorage2D(i.TEXTURE_2D,et,ae,ce.width,ce.height)}qe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,F,ie)}else t.texImage2D(i.TEXTURE_2D,0,ae,me,F,ie);C(x)&&x.mipmapsAutoUpdate===!0&&w(ue),ye.__version=ve.version,x.onUpdate&&x.onUpdate(x)}A.__version=x.version}function cn(A,x,q){if(x.image.length!==6)return;let ue=ft(A,x),oe=x.source;t.bindTexture(i.TEXTURE_CUBE_MAP,A.__webglTexture,i.TEXTURE0+q);let ve=n.get(oe);if(oe.version!==ve.__version||ue===!0){t.activeTexture(i.TEXTURE0+q);let ye=bt.getPrimaries(bt.workingColorSpace),te=x.colorSpace===Ts?null:bt.getPrimaries(x.colorSpace),ie=x.colorSpace===Ts||ye===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let me=x.isCompressedTexture||x.image[0].isCompressedTexture,F=x.image[0]&&x.image[0].isDataTexture,ae=[];for(let Re=0;Re<6;Re++)!me&&!F?ae[Re]=y(x.image[Re],!0,s.maxCubemapSize):ae[Re]=F?x.image[Re].image:x.image[Re],ae[Re]=He(x,ae[Re]);let ne=ae[0],Ee=r.convert(x.format,x.colorSpace),_e=r.convert(x.type),Se=T(x.internalFormat,Ee,_e,x.normalized,x.colorSpace),qe=x.isVideoTexture!==!0,et=ve.__version===void 0||ue===!0,ce=oe.dataReady,ke=E(x,ne);mt(i.TEXTURE_CUBE_MAP,x);let tt;if(x.isDepthTexture){if(Se=v(x.format===Es,x.type),et)if(qe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Re=0;Re<6;Re++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,ne.width,ne.height,0,Ee,_e,null)}else if(me){qe&&et&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,Se,ne.width,ne.height);for(let Re=0;Re<6;Re++){tt=ae[Re].mipmaps;for(let ut=0;ut<tt.length;ut++){let Wt=tt[ut];x.format!==vi?Ee!==null?qe?ce&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,0,0,Wt.width,Wt.height,Ee,Wt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,Se,Wt.width,Wt.height,0,Wt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,0,0,Wt.width,Wt.height,Ee,_e,Wt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut,Se,Wt.width,Wt.height,0,Ee,_e,Wt.data)}}}else{if(tt=x.mipmaps,qe&&et){tt.length>0&&ke++;let Re=Ze(ae[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(F){qe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,ae[Re].width,ae[Re].height,Ee,_e,ae[Re].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,ae[Re].width,ae[Re].height,0,Ee,_e,ae[Re].data);for(let ut=0;ut<tt.length;ut++){let Wn=tt[ut].image[Re].image;qe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,0,0,Wn.width,Wn.height,Ee,_e,Wn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,Se,Wn.width,Wn.height,0,Ee,_e,Wn.data)}}else{qe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Ee,_e,ae[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,Ee,_e,ae[Re]);for(let ut=0;ut<tt.length;ut++){let Wt=tt[ut];qe?ce&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,0,0,Ee,_e,Wt.image[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ut+1,Se,Ee,_e,Wt.image[Re])}}}C(x)&&x.mipmapsAutoUpdate===!0&&w(i.TEXTURE_CUBE_MAP),ve.__version=oe.version,x.onUpdate&&x.onUpdate(x)}A.__version=x.version}function Ot(A,x,q,ue,oe,ve){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),ie=T(q.internalFormat,ye,te,q.normalized,q.colorSpace),me=n.get(x),F=n.get(q);if(F.__renderTarget=x,!me.__hasExternalTextures){let ae=Math.max(1,x.width>>ve),ne=Math.max(1,x.height>>ve);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,ve,ie,ae,ne,x.depth,0,ye,te,null):t.texImage2D(oe,ve,ie,ae,ne,0,ye,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,A),we(x)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,oe,F.__webglTexture,0,ct(x)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ue,oe,F.__webglTexture,ve),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Tn(A,x,q){if(i.bindRenderbuffer(i.RENDERBUFFER,A),x.depthBuffer){let ue=x.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,ve=v(x.stencilBuffer,oe),ye=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(x)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ct(x),ve,x.width,x.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ct(x),ve,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,ve,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ye,i.RENDERBUFFER,A)}else{let ue=x.textures;for(let oe=0;oe<ue.length;oe++){let ve=ue[oe],ye=r.convert(ve.format,ve.colorSpace),te=r.convert(ve.type),ie=T(ve.internalFormat,ye,te,ve.normalized,ve.colorSpace);we(x)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ct(x),ie,x.width,x.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ct(x),ie,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,ie,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function wt(A,x,q){let ue=x.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,A),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(x.depthTexture);oe.__renderTarget=x;let ve=ue?x.depthTexture.image[0]:x.depthTexture.image;(!oe.__webglTexture||ve.width!==x.width||ve.height!==x.height)&&(ve.width=x.width,ve.height=x.height,x.depthTexture.needsUpdate=!0),ue?Me(x.depthTexture,0):ge(x.depthTexture,0);let ye=oe.__webglTexture,te=ct(x),ie=ue?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,me=x.depthTexture.format===Es?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(x.depthTexture.format===Ss)we(x)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,ie,ye,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,ie,ye,0);else if(x.depthTexture.format===Es)we(x)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,ie,ye,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,ie,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function xn(A){let x=n.get(A),q=A.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==A.depthTexture){let ue=A.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),ue){let oe=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),x.__depthDisposeCallback=oe}x.__boundDepthTexture=ue}if(A.depthTexture&&!x.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)wt(x.__webglFramebuffer[ue],A,ue);else A.texture.mipmaps.length>0?wt(x.__webglFramebuffer[0],A,0):wt(x.__webglFramebuffer,A,0);else if(q){x.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[ue]),x.__webglDepthbuffer[ue]===void 0)x.__webglDepthbuffer[ue]=i.createRenderbuffer(),Tn(x.__webglDepthbuffer[ue],A,!1);else{let oe=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=x.__webglDepthbuffer[ue];i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}}else if(A.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),Tn(x.__webglDepthbuffer,A,!1);else{let oe=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function en(A,x,q){let ue=n.get(A);x!==void 0&&Ot(ue.__webglFramebuffer,A,A.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&xn(A)}function hn(A){let x=A.texture,q=n.get(A),ue=n.get(x);A.addEventListener("dispose",G),V(A);let oe=A.textures,ve=A.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=i.createTexture()),ue.__version=x.version,a.memory.textures++),ve){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(x.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ie=0;ie<x.mipmaps.length;ie++)q.__webglFramebuffer[te][ie]=i.createFramebuffer()}else q.__webglFramebuffer[te]=i.createFramebuffer()}else{if(x.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<x.mipmaps.length;te++)q.__webglFramebuffer[te]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(ye)for(let te=0,ie=oe.length;te<ie;te++){let me=n.get(oe[te]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),a.memory.textures++)}if(A.samples>0&&we(A)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];q.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let me=r.convert(ie.format,ie.colorSpace),F=r.convert(ie.type),ae=T(ie.internalFormat,me,F,ie.normalized,ie.colorSpace,A.isXRRenderTarget===!0),ne=ct(A);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,ae,A.width,A.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,q.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),A.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Tn(q.__webglDepthRenderbuffer,A,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ve){t.bindTexture(i.TEXTURE_CUBE_MAP,ue.__webglTexture),mt(i.TEXTURE_CUBE_MAP,x);for(let te=0;te<6;te++)if(x.mipmaps.length>0)for(let ie=0;ie<x.mipmaps.length;ie++)Ot(q.__webglFramebuffer[te][ie],A,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Ot(q.__webglFramebuffer[te],A,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);C(x)?w(i.TEXTURE_CUBE_MAP):x.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,x.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,ie=oe.length;te<ie;te++){let me=oe[te],F=n.get(me),ae=i.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(ae=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,F.__webglTexture),mt(ae,me),Ot(q.__webglFramebuffer,A,me,i.COLOR_ATTACHMENT0+te,ae,0),C(me)&&w(ae)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(te=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),mt(te,x),x.mipmaps.length>0)for(let ie=0;ie<x.mipmaps.length;ie++)Ot(q.__webglFramebuffer[ie],A,x,i.COLOR_ATTACHMENT0,te,ie);else Ot(q.__webglFramebuffer,A,x,i.COLOR_ATTACHMENT0,te,0);C(x)?w(te):x.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,x.mipmaps.length-1),t.unbindTexture()}A.depthBuffer&&xn(A)}function O(A){let x=A.textures;for(let q=0,ue=x.length;q<ue;q++){let oe=x[q];if(C(oe)&&oe.mipmapsAutoUpdate===!0){let ve=I(A),ye=n.get(oe).__webglTexture;t.bindTexture(ve,ye),w(ve),t.unbindTexture()}}}let Pe=[];function Je(A){if(A.samples>0){if(we(A)===!1){let x=A.textures,q=A.width,ue=A.height,oe=i.COLOR_BUFFER_BIT,ve=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=n.get(A),te=x.length>1;if(te)for(let me=0;me<x.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let me=0;me<x.length;me++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let F=n.get(x[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,i.NEAREST),l===!0&&(Pe.length=0,Pe.push(i.COLOR_ATTACHMENT0+me),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&Pe.push(ve),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<x.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let F=n.get(x[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,F,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){let x=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function ct(A){return Math.min(s.maxSamples,A.samples)}function we(A){let x=n.get(A);return A.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function kt(A){let x=a.render.frame;h.get(A)!==x&&(h.set(A,x),A.update())}function He(A,x){let q=A.colorSpace,ue=A.format,oe=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||q!==Xs&&q!==Ts&&(bt.getTransfer(q)===Lt?(ue!==vi||oe!==_i)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",q)),x}function Ze(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(c.width=A.naturalWidth||A.width,c.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(c.width=A.displayWidth,c.height=A.displayHeight):(c.width=A.width,c.height=A.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=de,this.setTexture2D=ge,this.setTexture2DArray=xe,this.setTexture3D=Ce,this.setTextureCube=Me,this.rebindTextures=en,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=xn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=we,this.dispose=H}function Ow(i,e){function t(n,s=Ts){let r,a=bt.getTransfer(s);if(n===_i)return i.UNSIGNED_BYTE;if(n===Xc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===qc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Uf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Ff)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Df)return i.BYTE;if(n===Nf)return i.SHORT;if(n===Pa)return i.UNSIGNED_SHORT;if(n===Wc)return i.INT;if(n===ki)return i.UNSIGNED_INT;if(n===zi)return i.FLOAT;if(n===Vi)return i.HALF_FLOAT;if(n===Of)return i.ALPHA;if(n===Bf)return i.RGB;if(n===vi)return i.RGBA;if(n===Ss)return i.DEPTH_COMPONENT;if(n===Es)return i.DEPTH_STENCIL;if(n===kf)return i.RED;if(n===Yc)return i.RED_INTEGER;if(n===tr)return i.RG;if(n===$c)return i.RG_INTEGER;if(n===Zc)return i.RGBA_INTEGER;if(n===Wo||n===Xo||n===qo||n===Yo)if(a===Lt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Wo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Xo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===qo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Yo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Wo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Xo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===qo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Yo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Kc||n===Jc||n===jc||n===Qc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Kc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Jc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===jc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Qc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===eh||n===th||n===nh||n===ih||n===sh||n===$o||n===rh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===eh||n===th)return a===Lt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===nh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ih)return r.COMPRESSED_R11_EAC;if(n===sh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===$o)return r.COMPRESSED_RG11_EAC;if(n===rh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===ah||n===oh||n===lh||n===ch||n===hh||n===uh||n===fh||n===dh||n===ph||n===mh||n===gh||n===_h||n===vh||n===xh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===ah)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===oh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===lh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ch)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===hh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===uh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===fh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===dh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ph)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===mh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===gh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===_h)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===vh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===xh)return a===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===yh||n===bh||n===Sh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===yh)return a===Lt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===bh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Sh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Mh||n===wh||n===Zo||n===Eh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Mh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===wh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Zo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Eh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===wr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var Bw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,kw=`
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

}`,ld=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Uo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new On({vertexShader:Bw,fragmentShader:kw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Hn(new Oo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},cd=class extends Bi{constructor(e,t){super();let n=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,g=null,b=typeof XRWebGLBinding<"u",p=new ld,m={},y=t.getContextAttributes(),C=null,w=null,I=[],T=[],v=new it,E=null,V=null,U=new Kn;U.viewport=new Zt;let D=new Kn;D.viewport=new Zt;let G=[U,D],W=new zc,N=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=I[ee];return ge===void 0&&(ge=new Sa,I[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=I[ee];return ge===void 0&&(ge=new Sa,I[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=I[ee];return ge===void 0&&(ge=new Sa,I[ee]=ge),ge.getHandSpace()};function K(ee){let ge=T.indexOf(ee.inputSource);if(ge===-1)return;let xe=I[ge];xe!==void 0&&(xe.update(ee.inputSource,ee.frame,c||a),xe.dispatchEvent({type:ee.type,data:ee.inputSource}))}function z(){s.removeEventListener("select",K),s.removeEventListener("selectstart",K),s.removeEventListener("selectend",K),s.removeEventListener("squeeze",K),s.removeEventListener("squeezestart",K),s.removeEventListener("squeezeend",K),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",he);for(let ee=0;ee<I.length;ee++){let ge=T[ee];ge!==null&&(T[ee]=null,I[ee].disconnect(ge))}N=null,H=null,p.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(C),d=null,f=null,u=null,s=null,w=null,fe.stop(),n.isPresenting=!1,e.setPixelRatio(E),e.setSize(v.width,v.height,!1),V!==null){let ee=V.camera;ee.fov=V.fov,ee.zoom=V.zoom,ee.updateProjectionMatrix(),V=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){o=ee,n.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&b&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",K),s.addEventListener("selectstart",K),s.addEventListener("selectend",K),s.addEventListener("squeeze",K),s.addEventListener("squeezestart",K),s.addEventListener("squeezeend",K),s.addEventListener("end",z),s.addEventListener("inputsourceschange",he),y.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(v),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Ce=null,Me=null;y.depth&&(Me=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=y.stencil?Es:Ss,Ce=y.stencil?wr:ki);let Ye={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(Ye),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),w=new di(f.textureWidth,f.textureHeight,{format:vi,type:_i,depthTexture:new Ms(f.textureWidth,f.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let xe={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),w=new di(d.framebufferWidth,d.framebufferHeight,{format:vi,type:_i,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),fe.setContext(s),fe.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function he(ee){for(let ge=0;ge<ee.removed.length;ge++){let xe=ee.removed[ge],Ce=T.indexOf(xe);Ce>=0&&(T[Ce]=null,I[Ce].disconnect(xe))}for(let ge=0;ge<ee.added.length;ge++){let xe=ee.added[ge],Ce=T.indexOf(xe);if(Ce===-1){for(let Ye=0;Ye<I.length;Ye++)if(Ye>=T.length){T.push(xe),Ce=Ye;break}else if(T[Ye]===null){T[Ye]=xe,Ce=Ye;break}if(Ce===-1)break}let Me=I[Ce];Me&&Me.connect(xe)}}function J(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ge=ee.near,xe=ee.far;p.texture!==null&&(p.depthNear>0&&(ge=p.depthNear),p.depthFar>0&&(xe=p.depthFar)),W.near=D.near=U.near=ge,W.far=D.far=U.far=xe,(N!==W.near||H!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),N=W.near,H=W.far),W.layers.mask=ee.layers.mask|6,U.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;let Ce=ee.parent,Me=W.cameras;J(W,Ce);for(let Ye=0;Ye<Me.length;Ye++)J(Me[Ye],Ce);W.projectionMatrix.copy(U.projectionMatrix),W.projectionMatrixInverse.copy(U.projectionMatrixInverse),V===null&&ee.isPerspectiveCamera&&(V={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,W,Ce)};function Q(ee,ge,xe){xe===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(xe.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=xa*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(ee){l=ee,f!==null&&(f.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(W)},this.getCameraTexture=function(ee){return m[ee]};let se=null;function de(ee,ge){if(h=ge.getViewerPose(c||a),g=ge,h!==null){let xe=h.views;d!==null&&(e.setRenderTargetFramebuffer(w,d.framebuffer),e.setRenderTarget(w));let Ce=!1;xe.length!==W.cameras.length&&(W.cameras.length=0,Ce=!0);for(let Xe=0;Xe<xe.length;Xe++){let mt=xe[Xe],ft=null;if(d!==null)ft=d.getViewport(mt);else{let Jt=u.getViewSubImage(f,mt);ft=Jt.viewport,Xe===0&&(e.setRenderTargetTextures(w,Jt.colorTexture,Jt.depthStencilTexture),e.setRenderTarget(w))}let at=G[Xe];at===void 0&&(at=new Kn,at.layers.enable(Xe),at.viewport=new Zt,G[Xe]=at),at.matrix.fromArray(mt.transform.matrix),at.matrix.decompose(at.position,at.quaternion,at.scale),at.projectionMatrix.fromArray(mt.projectionMatrix),at.projectionMatrixInverse.copy(at.projectionMatrix).invert(),at.viewport.set(ft.x,ft.y,ft.width,ft.height),Xe===0&&(W.matrix.copy(at.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Ce===!0&&W.cameras.push(at)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){u=n.getBinding();let Xe=u.getDepthInformation(xe[0]);Xe&&Xe.isValid&&Xe.texture&&p.init(Xe,s.renderState)}if(Me&&Me.includes("camera-access")&&b){e.state.unbindTexture(),u=n.getBinding();for(let Xe=0;Xe<xe.length;Xe++){let mt=xe[Xe].camera;if(mt){let ft=m[mt];ft||(ft=new Uo,m[mt]=ft);let at=u.getCameraImage(mt);ft.sourceTexture=at}}}}for(let xe=0;xe<I.length;xe++){let Ce=T[xe],Me=I[xe];Ce!==null&&Me!==void 0&&Me.update(Ce,ge,c||a)}se&&se(ee,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),g=null}let fe=new kg;fe.setAnimationLoop(de),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},zw=new Gt,Zg=new rt;Zg.set(-1,0,0,0,1,0,0,0,1);function Vw(i,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function n(p,m){m.color.getRGB(p.fogColor.value,Kf(i)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,y,C,w){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),u(p,m)):m.isMeshPhongMaterial?(r(p,m),h(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),f(p,m),m.isMeshPhysicalMaterial&&d(p,m,w)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),b(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(a(p,m),m.isLineDashedMaterial&&o(p,m)):m.isPointsMaterial?l(p,m,y,C):m.isSpriteMaterial?c(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===Qn&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===Qn&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);let y=e.get(m),C=y.envMap,w=y.envMapRotation;C&&(p.envMap.value=C,p.envMapRotation.value.setFromMatrix4(zw.makeRotationFromEuler(w)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Zg),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function a(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function o(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function l(p,m,y,C){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*y,p.scale.value=C*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function c(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function h(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function u(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function f(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,y){p.ior.value=m.ior,m.diffuseRoughness>0&&(p.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Qn&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.retroreflectivity>0&&(p.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=y.texture,p.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function b(p,m){let y=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(y.matrixWorld),p.nearDistance.value=y.shadow.camera.near,p.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function Hw(i,e,t,n){let s={},r={};function a(y,C){let w=C.program;n.uniformBlockBinding(y,w,s[y.id])}function o(y,C){let w=s[y.id];w===void 0&&(g(y),w=l(y),s[y.id]=w,y.addEventListener("dispose",p));let I=C.program;n.updateUBOMapping(y,I);let T=e.render.frame;r[y.id]!==T&&(c(y),r[y.id]=T)}function l(y){let C=i.createBuffer(),w=y.__size,I=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,w,I),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(y){let C=s[y.id],w=y.uniforms,I=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let T=0,v=w.length;T<v;T++){let E=w[T];if(Array.isArray(E))for(let V=0,U=E.length;V<U;V++)h(E[V],T,V,I);else h(E,T,0,I)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,C,w,I){if(f(y,C,w,I)===!0){let T=y.__offset,v=y.value;if(Array.isArray(v)){let E=0;for(let V=0;V<v.length;V++){let U=v[V],D=b(U,!0);u(U,y.__data,E),E+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(v,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,y.__data)}}function u(y,C,w){typeof y=="number"||typeof y=="boolean"?C[w]=y:y.isMatrix3?(C[w]=y.elements[0],C[w+1]=y.elements[1],C[w+2]=y.elements[2],C[w+3]=0,C[w+4]=y.elements[3],C[w+5]=y.elements[4],C[w+6]=y.elements[5],C[w+7]=0,C[w+8]=y.elements[6],C[w+9]=y.elements[7],C[w+10]=y.elements[8],C[w+11]=0):ArrayBuffer.isView(y)?C.set(y.subarray(0,C.length-w),w):y.toArray(C,w)}function f(y,C,w,I){let T=y.value,v=C+"_"+w;if(Array.isArray(T)){I[v]===void 0&&(I[v]=[]);let E=I[v],V=!1;for(let U=0;U<T.length;U++)d(T[U],E,U)===!0&&(V=!0);return V}return d(T,I,v)}function d(y,C,w){if(C[w]===void 0)return typeof y=="number"||typeof y=="boolean"?C[w]=y:ArrayBuffer.isView(y)?C[w]=y.slice():C[w]=y.clone(),!0;{let I=C[w];if(typeof y=="number"||typeof y=="boolean"){if(I!==y)return C[w]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(I.equals(y)===!1)return I.copy(y),!0}}return!1}function g(y){let C=y.uniforms,w=0,I=16;for(let v=0,E=C.length;v<E;v++){let V=Array.isArray(C[v])?C[v]:[C[v]];for(let U=0,D=V.length;U<D;U++){let G=V[U],W=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(C[v])||Array.isArray(G.value),H=w;for(let z=0,he=W.length;z<he;z++){let J=W[z],Q=b(J,N),se=w%I,de=se%Q.boundary,fe=se+de;w+=de,fe!==0&&I-fe<Q.storage&&(w+=I-fe),z===0&&(H=w),w+=Q.storage}let K=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new K((w-H)/Float32Array.BYTES_PER_ELEMENT),G.__offset=H}}let T=w%I;return T>0&&(w+=I-T),y.__size=w,y.__cache={},this}function b(y,C){let w={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(w.boundary=4,w.storage=4):y.isVector2?(w.boundary=8,w.storage=8):y.isVector3||y.isColor?(w.boundary=16,w.storage=12):y.isVector4?(w.boundary=16,w.storage=16):y.isMatrix3?(w.boundary=16,w.storage=48):y.isMatrix4?(w.boundary=16,w.storage=64):y.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(w.boundary=16,w.storage=y.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",y),C===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function p(y){let C=y.target;C.removeEventListener("dispose",p),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:a,update:o,dispose:m}}var Gw=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ns=null;function Ww(){return ns===null&&(ns=new Ma(Gw,16,16,tr,Vi),ns.name="DFG_LUT",ns.minFilter=jn,ns.magFilter=jn,ns.wrapS=es,ns.wrapT=es,ns.generateMipmaps=!1,ns.needsUpdate=!0),ns}var Rh=class{constructor(e={}){let{canvas:t=lg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=_i}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let b=d,p=new Set([Zc,$c,Yc]),m=new Set([_i,ki,Pa,wr,Xc,qc]),y=new Uint32Array(4),C=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},I=null,T=null,v=[],E=[],V=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ts,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,D=!1,G=null,W=null,N=null,H=null;this._outputColorSpace=ui;let K=0,z=0,he=null,J=-1,Q=null,se=new Zt,de=new Zt,fe=null,ee=new St(0),ge=0,xe=t.width,Ce=t.height,Me=1,Ye=null,lt=null,Xe=new Zt(0,0,xe,Ce),mt=new Zt(0,0,xe,Ce),ft=!1,at=new xr,Jt=new bc,Ht=!1,cn=!1,Ot=new Gt,Tn=new X,wt=new Zt,xn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function hn(){return he===null?Me:1}let O=n;function Pe(M,B){return t.getContext(M,B)}let Je,ct,we,kt,He,Ze,A,x,q,ue,oe,ve,ye,te,ie,me,F,ae,ne,Ee,_e,Se,qe;try{let M={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Re,!1),O===null){let B="webgl2";if(O=Pe(B,M),O===null)throw Pe(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(M){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),nt("WebGLRenderer: "+M.message),M}function et(){Je=new tM(O),Je.init(),_e=new Ow(O,Je),ct=new WS(O,Je,e,_e),we=new Uw(O,Je),ct.reversedDepthBuffer&&f&&we.buffers.depth.setReversed(!0),W=O.createFramebuffer(),N=O.createFramebuffer(),H=O.createFramebuffer(),kt=new sM(O),He=new bw,Ze=new Fw(O,Je,we,He,ct,_e,kt),A=new eM(U),x=new ay(O),Se=new HS(O,x),q=new nM(O,x,kt,Se),ue=new aM(O,q,x,Se,kt),ae=new rM(O,ct,Ze),ie=new XS(He),oe=new yw(U,A,Je,ct,Se,ie),ve=new Vw(U,He),ye=new Mw,te=new Rw(Je),F=new VS(U,A,we,ue,g,l),me=new Nw(U,ue,ct),qe=new Hw(O,kt,ct,we),ne=new GS(O,Je,kt),Ee=new iM(O,Je,kt),kt.programs=oe.programs,U.capabilities=ct,U.extensions=Je,U.properties=He,U.renderLists=ye,U.shadowMap=me,U.state=we,U.info=kt}b!==_i&&(V=new lM(b,t.width,t.height,o,s,r));let ce=new cd(U,O);this.xr=ce,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let M=Je.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=Je.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(M){M!==void 0&&(Me=M,this.setSize(xe,Ce,!1))},this.getSize=function(M){return M.set(xe,Ce)},this.setSize=function(M,B,j=!0){if(ce.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=M,Ce=B,t.width=Math.floor(M*Me),t.height=Math.floor(B*Me),j===!0&&(t.style.width=M+"px",t.style.height=B+"px"),V!==null&&V.setSize(t.width,t.height),this.setViewport(0,0,M,B)},this.getDrawingBufferSize=function(M){return M.set(xe*Me,Ce*Me).floor()},this.setDrawingBufferSize=function(M,B,j){xe=M,Ce=B,Me=j,t.width=Math.floor(M*j),t.height=Math.floor(B*j),this.setViewport(0,0,M,B)},this.setEffects=function(M){if(b===_i){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let B=0;B<M.length;B++)if(M[B].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}V.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(se)},this.getViewport=function(M){return M.copy(Xe)},this.setViewport=function(M,B,j,Y){M.isVector4?Xe.set(M.x,M.y,M.z,M.w):Xe.set(M,B,j,Y),we.viewport(se.copy(Xe).multiplyScalar(hn()).round())},this.getScissor=function(M){return M.copy(mt)},this.setScissor=function(M,B,j,Y){M.isVector4?mt.set(M.x,M.y,M.z,M.w):mt.set(M,B,j,Y),we.scissor(de.copy(mt).multiplyScalar(hn()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(M){we.setScissorTest(ft=M)},this.setOpaqueSort=function(M){Ye=M},this.setTransparentSort=function(M){lt=M},this.getClearColor=function(M){return M.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(M=!0,B=!0,j=!0){let Y=0;if(M){let $=!1;if(he!==null){let Te=he.texture.format;$=p.has(Te)}if($){let Te=he.texture.type,Ie=m.has(Te),Ae=F.getClearColor(),Le=F.getClearAlpha(),Ve=Ae.r,st=Ae.g,gt=Ae.b;Ie?(y[0]=Ve,y[1]=st,y[2]=gt,y[3]=Le,O.clearBufferuiv(O.COLOR,0,y)):(C[0]=Ve,C[1]=st,C[2]=gt,C[3]=Le,O.clearBufferiv(O.COLOR,0,C))}else Y|=O.COLOR_BUFFER_BIT}B&&(Y|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&O.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),G=M},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),F.dispose(),ye.dispose(),te.dispose(),Ze.dispose(),He.dispose(),A.dispose(),ue.dispose(),q.dispose(),Se.dispose(),qe.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Pl),ce.removeEventListener("sessionend",Xi),cs.stop()};function ke(M){M.preventDefault(),Xf("WebGLRenderer: Context Lost."),D=!0}function tt(){Xf("WebGLRenderer: Context Restored."),D=!1;let M=kt.autoReset,B=me.enabled,j=me.autoUpdate,Y=me.needsUpdate,$=me.type;et(),kt.autoReset=M,me.enabled=B,me.autoUpdate=j,me.needsUpdate=Y,me.type=$}function Re(M){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function ut(M){let B=M.target;B.removeEventListener("dispose",ut),Wt(B)}function Wt(M){Wn(M),He.remove(M)}function Wn(M){let B=He.get(M).programs;B!==void 0&&(B.forEach(function(j){oe.releaseProgram(j)}),M.isShaderMaterial&&oe.releaseShaderCache(M))}this.renderBufferDirect=function(M,B,j,Y,$,Te){B===null&&(B=xn);let Ie=$.isMesh&&$.matrixWorld.determinantAffine()<0,Ae=uo(M,B,j,Y,$);we.setMaterial(Y,Ie);let Le=j.index,Ve=1;if(Y.wireframe===!0){if(Le=q.getWireframeAttribute(j),Le===void 0)return;Ve=2}let st=j.drawRange,gt=j.attributes.position,ze=st.start*Ve,_t=(st.start+st.count)*Ve;Te!==null&&(ze=Math.max(ze,Te.start*Ve),_t=Math.min(_t,(Te.start+Te.count)*Ve)),Le!==null?(ze=Math.max(ze,0),_t=Math.min(_t,Le.count)):gt!=null&&(ze=Math.max(ze,0),_t=Math.min(_t,gt.count));let Qt=_t-ze;if(Qt<0||Qt===1/0)return;Se.setup($,Y,Ae,j,Le);let Nt,Ut=ne;if(Le!==null&&(Nt=x.get(Le),Ut=Ee,Ut.setIndex(Nt)),$.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*hn()),Ut.setMode(O.LINES)):Ut.setMode(O.TRIANGLES);else if($.isLine){let yn=Y.linewidth;yn===void 0&&(yn=1),we.setLineWidth(yn*hn()),$.isLineSegments?Ut.setMode(O.LINES):$.isLineLoop?Ut.setMode(O.LINE_LOOP):Ut.setMode(O.LINE_STRIP)}else $.isPoints?Ut.setMode(O.POINTS):$.isSprite&&Ut.setMode(O.TRIANGLES);if($.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Ut.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let yn=$._multiDrawStarts,Oe=$._multiDrawCounts,un=$._multiDrawCount,yt=Le?x.get(Le).bytesPerElement:1,us=He.get(Y).currentProgram.getUniforms();for(let fn=0;fn<un;fn++)us.setValue(O,"_gl_DrawID",fn),Ut.render(yn[fn]/yt,Oe[fn])}else if($.isInstancedMesh)Ut.renderInstances(ze,Qt,$.count);else if(j.isInstancedBufferGeometry){let yn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Oe=Math.min(j.instanceCount,yn);Ut.renderInstances(ze,Qt,Oe)}else Ut.render(ze,Qt)};function lo(M,B,j,Y){G!==null&&M.isNodeMaterial&&G.setObject(Y,M),Ht===!0&&ie.setState(M,j,!1),M.transparent===!0&&M.side===ni&&M.forceSinglePass===!1?(M.side=Qn,M.needsUpdate=!0,qi(M,B,Y),M.side=er,M.needsUpdate=!0,qi(M,B,Y),M.side=ni):qi(M,B,Y)}this.compile=function(M,B,j=null){j===null&&(j=M),G!==null&&G.renderStart(M,B,j),T=te.get(j),T.init(B),E.push(T),j.traverseVisible(function($){$.isLight&&$.layers.test(B.layers)&&(T.pushLight($),$.castShadow&&T.pushShadow($))}),M!==j&&M.traverseVisible(function($){$.isLight&&$.layers.test(B.layers)&&(T.pushLight($),$.castShadow&&T.pushShadow($))}),T.setupLights(),G!==null&&G.updateLights(T.state.lightsArray),cn=this.localClippingEnabled,Ht=ie.init(this.clippingPlanes,cn),Ht===!0&&ie.setGlobalState(this.clippingPlanes,B),G!==null&&me.render(T.state.shadowsArray,j,B);let Y=new Set;return M.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Te=$.material;if(Te)if(Array.isArray(Te))for(let Ie=0;Ie<Te.length;Ie++){let Ae=Te[Ie];lo(Ae,j,B,$),Y.add(Ae)}else lo(Te,j,B,$),Y.add(Te)}),T=E.pop(),G!==null&&G.renderEnd(),Y},this.compileAsync=function(M,B,j=null){let Y=this.compile(M,B,j);return new Promise($=>{function Te(){if(Y.forEach(function(Ie){let Le=He.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&Y.delete(Ie)}),Y.size===0){$(M);return}setTimeout(Te,10)}Je.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let Gr=null;function Du(M){Gr&&Gr(M)}function Pl(){cs.stop()}function Xi(){cs.start()}let cs=new kg;cs.setAnimationLoop(Du),typeof self<"u"&&cs.setContext(self),this.setAnimationLoop=function(M){Gr=M,ce.setAnimationLoop(M),M===null?cs.stop():cs.start()},ce.addEventListener("sessionstart",Pl),ce.addEventListener("sessionend",Xi),this.render=function(M,B){if(B!==void 0&&B.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;G!==null&&G.renderStart(M,B);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=V!==null&&(he===null||j)&&V.begin(U,he);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(V===null||V.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(B),B=ce.getCamera()),M.isScene===!0&&M.onBeforeRender(U,M,B,he),T=te.get(M,E.length),T.init(B),T.state.textureUnits=Ze.getTextureUnits(),E.push(T),Ot.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Jt.setFromArrayCamera(B):at.setFromProjectionMatrix(Ot,Ci,B.reversedDepth),cn=this.localClippingEnabled,Ht=ie.init(this.clippingPlanes,cn),I=ye.get(M,v.length),I.init(),v.push(I),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Ie=U.xr.getDepthSensingMesh();Ie!==null&&hs(Ie,B,-1/0,U.sortObjects)}hs(M,B,0,U.sortObjects),I.finish(),G!==null&&G.updateLights(T.state.lightsArray),U.sortObjects===!0&&I.sort(Ye,lt),en=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,en&&F.addToRenderList(I,M),this.info.autoReset===!0&&this.info.reset(),Ht===!0&&ie.beginShadows();let $=T.state.shadowsArray;if(me.render($,M,B),Ht===!0&&ie.endShadows(),(Y&&V.hasRenderPass())===!1){let Ie=I.opaque,Ae=I.transmissive;if(T.setupLights(),B.isArrayCamera){let Le=B.cameras;if(Ae.length>0)for(let Ve=0,st=Le.length;Ve<st;Ve++){let gt=Le[Ve];Li(Ie,Ae,M,gt)}en&&F.render(M);for(let Ve=0,st=Le.length;Ve<st;Ve++){let gt=Le[Ve];co(I,M,gt,gt.viewport)}}else Ae.length>0&&Li(Ie,Ae,M,B),en&&F.render(M),co(I,M,B)}he!==null&&z===0&&(Ze.updateMultisampleRenderTarget(he),Ze.updateRenderTargetMipmap(he)),Y&&V.end(U),M.isScene===!0&&M.onAfterRender(U,M,B),Se.resetDefaultState(),J=-1,Q=null,E.pop(),E.length>0?(T=E[E.length-1],Ze.setTextureUnits(T.state.textureUnits),Ht===!0&&ie.setGlobalState(U.clippingPlanes,T.state.camera)):T=null,v.pop(),v.length>0?I=v[v.length-1]:I=null,G!==null&&G.renderEnd()};function hs(M,B,j,Y){if(M.visible===!1)return;if(M.layers.test(B.layers)){if(M.isGroup)j=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(B);else if(M.isLight)T.pushLight(M),M.castShadow&&T.pushShadow(M);else if(M.isSprite){let Ie=B.isArrayCamera?Jt:at;if(!M.frustumCulled||M.intersectsFrustum(Ie)){Y&&wt.setFromMatrixPosition(M.matrixWorld).applyMatrix4(Ot);let Ae=ue.update(M),Le=M.material;Le.visible&&I.push(M,Ae,Le,j,wt.z,null,B)}}else if(M.isMesh||M.isLine||M.isPoints){let Ie=B.isArrayCamera?Jt:at;if(!M.frustumCulled||M.intersectsFrustum(Ie)){let Ae=ue.update(M),Le=M.material;if(Y&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),wt.copy(M.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),wt.copy(Ae.boundingSphere.center)),wt.applyMatrix4(M.matrixWorld).applyMatrix4(Ot)),Array.isArray(Le)){let Ve=Ae.groups;for(let st=0,gt=Ve.length;st<gt;st++){let ze=Ve[st],_t=Le[ze.materialIndex];_t&&_t.visible&&I.push(M,Ae,_t,j,wt.z,ze,B)}}else Le.visible&&I.push(M,Ae,Le,j,wt.z,null,B)}}}let Te=M.children;for(let Ie=0,Ae=Te.length;Ie<Ae;Ie++)hs(Te[Ie],B,j,Y)}function co(M,B,j,Y){let{opaque:$,transmissive:Te,transparent:Ie}=M;T.setupLightsView(j),Ht===!0&&ie.setGlobalState(U.clippingPlanes,j),Y&&we.viewport(se.copy(Y)),$.length>0&&tn($,B,j),Te.length>0&&tn(Te,B,j),Ie.length>0&&tn(Ie,B,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Li(M,B,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let ze=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new di(1,1,{generateMipmaps:!0,type:ze?Vi:_i,minFilter:ws,samples:Math.max(4,ct.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:bt.workingColorSpace})}let Te=T.state.transmissionRenderTarget[Y.id],Ie=Y.viewport||se;Te.setSize(Ie.z*U.transmissionResolutionScale,Ie.w*U.transmissionResolutionScale);let Ae=U.getRenderTarget(),Le=U.getActiveCubeFace(),Ve=U.getActiveMipmapLevel();U.setRenderTarget(Te),U.getClearColor(ee),ge=U.getClearAlpha(),ge<1&&U.setClearColor(16777215,.5),U.clear(),en&&F.render(j);let st=U.toneMapping;U.toneMapping=ts;let gt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),Ht===!0&&ie.setGlobalState(U.clippingPlanes,Y),tn(M,j,Y),Ze.updateMultisampleRenderTarget(Te),Ze.updateRenderTargetMipmap(Te),Je.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let _t=0,Qt=B.length;_t<Qt;_t++){let Nt=B[_t],{object:Ut,geometry:yn,material:Oe,group:un}=Nt;if(Oe.side===ni&&Ut.layers.test(Y.layers)){let yt=Oe.side;Oe.side=Qn,Oe.needsUpdate=!0,an(Ut,j,Y,yn,Oe,un),Oe.side=yt,Oe.needsUpdate=!0,ze=!0}}ze===!0&&(Ze.updateMultisampleRenderTarget(Te),Ze.updateRenderTargetMipmap(Te))}U.setRenderTarget(Ae,Le,Ve),U.setClearColor(ee,ge),gt!==void 0&&(Y.viewport=gt),U.toneMapping=st}function tn(M,B,j){let Y=B.isScene===!0?B.overrideMaterial:null;for(let $=0,Te=M.length;$<Te;$++){let Ie=M[$],{object:Ae,geometry:Le,group:Ve}=Ie,st=Ie.material;st.allowOverride===!0&&Y!==null&&(st=Y),Ae.layers.test(j.layers)&&an(Ae,B,j,Le,st,Ve)}}function an(M,B,j,Y,$,Te){G!==null&&$.isNodeMaterial&&G.setObject(M,$),M.onBeforeRender(U,B,j,Y,$,Te),M.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),$.onBeforeRender(U,B,j,Y,M,Te),$.transparent===!0&&$.side===ni&&$.forceSinglePass===!1?($.side=Qn,$.needsUpdate=!0,U.renderBufferDirect(j,B,Y,$,M,Te),$.side=er,$.needsUpdate=!0,U.renderBufferDirect(j,B,Y,$,M,Te),$.side=ni):U.renderBufferDirect(j,B,Y,$,M,Te),M.onAfterRender(U,B,j,Y,$,Te)}function on(M){let B=0;for(let j of M)j.texture!==null&&B++;return B}function qi(M,B,j){B.isScene!==!0&&(B=xn);let Y=He.get(M),$=T.state.lights,Te=T.state.shadowsArray,Ie=$.state.version,Ae=oe.getParameters(M,$.state,Te,B,j,T.state.lightProbeGridArray),Le=oe.getProgramCacheKey(Ae),Ve=Y.programs;Y.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?B.environment:null,Y.fog=B.fog;let st=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;Y.envMap=A.get(M.envMap||Y.environment,st),Y.envMapRotation=Y.environment!==null&&M.envMap===null?B.environmentRotation:M.envMapRotation,Ve===void 0&&(M.addEventListener("dispose",ut),Ve=new Map,Y.programs=Ve,Y.programVariants=new Map);let gt=Ve.get(Le);if(gt!==void 0){if(Y.currentProgram===gt&&Y.lightsStateVersion===Ie)return ho(M,Ae),gt}else Ae.uniforms=oe.getUniforms(M),G!==null&&M.isNodeMaterial&&G.build(M,j,Ae),M.onBeforeCompile(Ae,U),gt=oe.acquireProgram(Ae,Le),Ve.set(Le,gt),Y.uniforms=Ae.uniforms;let ze=Y.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(ze.clippingPlanes=ie.uniform),ho(M,Ae),Y.needsLights=Us(M),Y.lightsStateVersion=Ie,Y.needsLights&&(ze.ambientLightColor.value=$.state.ambient,ze.lightProbe.value=$.state.probe,ze.sunLights.value=$.state.sun,ze.sunLightShadows.value=$.state.sunShadow,ze.directionalLights.value=$.state.directional,ze.directionalLightShadows.value=$.state.directionalShadow,ze.spotLights.value=$.state.spot,ze.spotLightShadows.value=$.state.spotShadow,ze.rectAreaLights.value=$.state.rectArea,ze.ltc_1.value=$.state.rectAreaLTC1,ze.ltc_2.value=$.state.rectAreaLTC2,ze.pointLights.value=$.state.point,ze.pointLightShadows.value=$.state.pointShadow,ze.hemisphereLights.value=$.state.hemi,ze.sunShadowMatrix.value=$.state.sunShadowMatrix,ze.sunShadowCascade.value=$.state.sunShadowCascade,ze.directionalShadowMatrix.value=$.state.directionalShadowMatrix,ze.spotLightMatrix.value=$.state.spotLightMatrix,ze.spotLightMap.value=$.state.spotLightMap,ze.pointShadowMatrix.value=$.state.pointShadowMatrix),Y.numLightProbeGrids=on(T.state.lightProbeGridArray),Y.currentProgram=gt,Y.uniformsList=null,gt}function si(M,B,j,Y,$){let Te=He.get(M),Ie=Te.currentProgram.id+","+Y+","+$,Ae=Te.programVariants.get(Ie);return Ae===void 0?(Ae=qi(M,B,j),Te.programVariants.set(Ie,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=Y,Te.toneMapping=$),Ae}function Ns(M){if(M.uniformsList===null){let B=M.currentProgram.getUniforms();M.uniformsList=La.seqWithValue(B.seq,M.uniforms)}return M.uniformsList}function ho(M,B){let j=He.get(M);j.outputColorSpace=B.outputColorSpace,j.batching=B.batching,j.batchingColor=B.batchingColor,j.instancing=B.instancing,j.instancingColor=B.instancingColor,j.instancingMorph=B.instancingMorph,j.skinning=B.skinning,j.morphTargets=B.morphTargets,j.morphNormals=B.morphNormals,j.morphColors=B.morphColors,j.morphTargetsCount=B.morphTargetsCount,j.numClippingPlanes=B.numClippingPlanes,j.numIntersection=B.numClipIntersection,j.vertexAlphas=B.vertexAlphas,j.vertexTangents=B.vertexTangents,j.toneMapping=B.toneMapping}function uo(M,B,j,Y,$){B.isScene!==!0&&(B=xn),Ze.resetTextureUnits();let Te=B.fog,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?B.environment:null,Ae=he===null?U.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:bt.workingColorSpace,Le=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ve=A.get(Y.envMap||Ie,Le),st=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,gt=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ze=!!j.morphAttributes.position,_t=!!j.morphAttributes.normal,Qt=!!j.morphAttributes.color,Nt=ts;Y.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(Nt=U.toneMapping);let Ut=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,yn=Ut!==void 0?Ut.length:0,Oe=He.get(Y),un=T.state.lights;if(Ht===!0&&(cn===!0||M!==Q)){let Ft=M===Q&&Y.id===J;ie.setState(Y,M,Ft)}let yt=!1,us=!1;Y.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==un.state.version||$.isBatchedMesh&&Oe.batching===!1||!$.isBatchedMesh&&Oe.batching===!0||$.isBatchedMesh&&Oe.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Oe.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Oe.instancing===!1||!$.isInstancedMesh&&Oe.instancing===!0||$.isSkinnedMesh&&Oe.skinning===!1||!$.isSkinnedMesh&&Oe.skinning===!0||$.isInstancedMesh&&Oe.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Oe.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Oe.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Oe.instancingMorph===!1&&$.morphTexture!==null||Oe.envMap!==Ve||Y.fog===!0&&Oe.fog!==Te||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==ie.numPlanes||Oe.numIntersection!==ie.numIntersection)||Oe.vertexAlphas!==st||Oe.vertexTangents!==gt||Oe.morphTargets!==ze||Oe.morphNormals!==_t||Oe.morphColors!==Qt||Oe.morphTargetsCount!==yn||Oe.numLightProbeGrids!==on(T.state.lightProbeGridArray)?yt=!0:(Oe.outputColorSpace!==Ae||Oe.toneMapping!==Nt)&&(us=!0):(yt=!0,Oe.__version=Y.version);let fn=Oe.currentProgram;(yt===!0||us===!0)&&(fn=us===!0?si(Y,B,$,Ae,Nt):qi(Y,B,$),G&&Y.isNodeMaterial&&G.onUpdateProgram(Y,fn,Oe));let qr=!1,Yi=!1,fs=!1,dt=fn.getUniforms(),nn=Oe.uniforms;if(we.useProgram(fn.program)&&(qr=!0,Yi=!0,fs=!0),Y.id!==J&&(J=Y.id,Yi=!0),qr||Q!==M){we.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),dt.setValue(O,"projectionMatrix",M.projectionMatrix),dt.setValue(O,"viewMatrix",M.matrixWorldInverse);let dn=dt.map.cameraPosition;dn!==void 0&&dn.setValue(O,Tn.setFromMatrixPosition(M.matrixWorld)),ct.logarithmicDepthBuffer&&dt.setValue(O,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&dt.setValue(O,"isOrthographic",M.isOrthographicCamera===!0),Q!==M&&(Q=M,Yi=!0,fs=!0)}if(Oe.needsLights&&(un.state.sunShadowMap.length>0&&dt.setValue(O,"sunShadowMap",un.state.sunShadowMap,Ze),un.state.directionalShadowMap.length>0&&dt.setValue(O,"directionalShadowMap",un.state.directionalShadowMap,Ze),un.state.spotShadowMap.length>0&&dt.setValue(O,"spotShadowMap",un.state.spotShadowMap,Ze),un.state.pointShadowMap.length>0&&dt.setValue(O,"pointShadowMap",un.state.pointShadowMap,Ze)),$.isSkinnedMesh){dt.setOptional(O,$,"bindMatrix"),dt.setOptional(O,$,"bindMatrixInverse");let Ft=$.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),dt.setValue(O,"boneTexture",Ft.boneTexture,Ze))}$.isBatchedMesh&&(dt.setOptional(O,$,"batchingTexture"),dt.setValue(O,"batchingTexture",$._matricesTexture,Ze),dt.setOptional(O,$,"batchingIdTexture"),dt.setValue(O,"batchingIdTexture",$._indirectTexture,Ze),dt.setOptional(O,$,"batchingColorTexture"),$._colorsTexture!==null&&dt.setValue(O,"batchingColorTexture",$._colorsTexture,Ze));let Xn=j.morphAttributes;if((Xn.position!==void 0||Xn.normal!==void 0||Xn.color!==void 0)&&ae.update($,j,fn),(Yi||Oe.receiveShadow!==$.receiveShadow)&&(Oe.receiveShadow=$.receiveShadow,dt.setValue(O,"receiveShadow",$.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&B.environment!==null&&(nn.envMapIntensity.value=B.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=Ww()),Yi){if(dt.setValue(O,"toneMappingExposure",U.toneMappingExposure),Oe.needsLights&&Wr(nn,fs),Te&&Y.fog===!0&&ve.refreshFogUniforms(nn,Te),ve.refreshMaterialUniforms(nn,Y,Me,Ce,T.state.transmissionRenderTarget[M.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Ft=w,dn=0;for(let kn of T.state.lightProbeGridArray)kn.texture!==null&&(Ft.textures[dn]=kn.texture,Ft.min[dn]=kn.boundingBox.min,Ft.max[dn]=kn.boundingBox.max,Ft.resolution[dn]=kn.resolution,dn++);for(let kn in Ft)Ft[kn].length=dn;nn.probesSH.value=Ft.textures,nn.probesMin.value=Ft.min,nn.probesMax.value=Ft.max,nn.probesResolution.value=Ft.resolution}La.upload(O,Ns(Oe),nn,Ze)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(La.upload(O,Ns(Oe),nn,Ze),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&dt.setValue(O,"center",$.center),dt.setValue(O,"modelViewMatrix",$.modelViewMatrix),dt.setValue(O,"normalMatrix",$.normalMatrix),dt.setValue(O,"modelMatrix",$.matrixWorld),Y.uniformsGroups!==void 0){let Ft=Y.uniformsGroups;for(let dn=0,kn=Ft.length;dn<kn;dn++){let Il=Ft[dn];qe.update(Il,fn),qe.bind(Il,fn)}}return fn}function Wr(M,B){M.ambientLightColor.needsUpdate=B,M.lightProbe.needsUpdate=B,M.sunLights.needsUpdate=B,M.sunLightShadows.needsUpdate=B,M.directionalLights.needsUpdate=B,M.directionalLightShadows.needsUpdate=B,M.pointLights.needsUpdate=B,M.pointLightShadows.needsUpdate=B,M.spotLights.needsUpdate=B,M.spotLightShadows.needsUpdate=B,M.rectAreaLights.needsUpdate=B,M.hemisphereLights.needsUpdate=B}function Us(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return K},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return he},this.setRenderTargetTextures=function(M,B,j){let Y=He.get(M);Y.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),He.get(M.texture).__webglTexture=B,He.get(M.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,B){let j=He.get(M);j.__webglFramebuffer=B,j.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(M,B=0,j=0){he=M,K=B,z=j;let Y=null,$=!1,Te=!1;if(M){let Ae=He.get(M);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(O.FRAMEBUFFER,Ae.__webglFramebuffer),se.copy(M.viewport),de.copy(M.scissor),fe=M.scissorTest,we.viewport(se),we.scissor(de),we.setScissorTest(fe),J=-1;return}else if(Ae.__webglFramebuffer===void 0)Ze.setupRenderTarget(M);else if(Ae.__hasExternalTextures)Ze.rebindTextures(M,He.get(M.texture).__webglTexture,He.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let st=M.depthTexture;if(Ae.__boundDepthTexture!==st){if(st!==null&&He.has(st)&&(M.width!==st.image.width||M.height!==st.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(M)}}let Le=M.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Te=!0);let Ve=He.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(Ve[B])?Y=Ve[B][j]:Y=Ve[B],$=!0):M.samples>0&&Ze.useMultisampledRTT(M)===!1?Y=He.get(M).__webglMultisampledFramebuffer:Array.isArray(Ve)?Y=Ve[j]:Y=Ve,se.copy(M.viewport),de.copy(M.scissor),fe=M.scissorTest}else se.copy(Xe).multiplyScalar(Me).floor(),de.copy(mt).multiplyScalar(Me).floor(),fe=ft;if(j!==0&&(Y=W),we.bindFramebuffer(O.FRAMEBUFFER,Y)&&we.drawBuffers(M,Y),we.viewport(se),we.scissor(de),we.setScissorTest(fe),$){let Ae=He.get(M.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+B,Ae.__webglTexture,j)}else if(Te){let Ae=B;for(let Le=0;Le<M.textures.length;Le++){let Ve=He.get(M.textures[Le]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Le,Ve.__webglTexture,j,Ae)}}else if(M!==null&&j!==0){let Ae=He.get(M.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ae.__webglTexture,j)}J=-1};function Xr(M){let B=He.get(M);return(B.__readFormat!==M.format||B.__readType!==M.type)&&(B.__readFormat=M.format,B.__readType=M.type,B.__formatReadable=ct.textureFormatReadable(M.format),B.__typeReadable=ct.textureTypeReadable(M.type)),B}this.readRenderTargetPixels=function(M,B,j,Y,$,Te,Ie,Ae=0){if(!(M&&M.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=He.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){we.bindFramebuffer(O.FRAMEBUFFER,Le);try{let Ve=M.textures[Ae],st=Ve.format,gt=Ve.type;M.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ae);let ze=Xr(Ve);if(ze.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=M.width-Y&&j>=0&&j<=M.height-$&&O.readPixels(B,j,Y,$,_e.convert(st),_e.convert(gt),Te)}finally{let Ve=he!==null?He.get(he).__webglFramebuffer:null;we.bindFramebuffer(O.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(M,B,j,Y,$,Te,Ie,Ae=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=He.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(B>=0&&B<=M.width-Y&&j>=0&&j<=M.height-$){we.bindFramebuffer(O.FRAMEBUFFER,Le);let Ve=M.textures[Ae],st=Ve.format,gt=Ve.type;M.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ae);let ze=Xr(Ve);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,_t),O.bufferData(O.PIXEL_PACK_BUFFER,Te.byteLength,O.STREAM_READ),O.readPixels(B,j,Y,$,_e.convert(st),_e.convert(gt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Qt=he!==null?He.get(he).__webglFramebuffer:null;we.bindFramebuffer(O.FRAMEBUFFER,Qt);let Nt=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await hg(O,Nt,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,_t),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Te),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(_t),O.deleteSync(Nt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,B=null,j=0){let Y=Math.pow(2,-j),$=Math.floor(M.image.width*Y),Te=Math.floor(M.image.height*Y),Ie=B!==null?B.x:0,Ae=B!==null?B.y:0;Ze.setTexture2D(M,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,Ie,Ae,$,Te),we.unbindTexture()},this.copyTextureToTexture=function(M,B,j=null,Y=null,$=0,Te=0){let Ie,Ae,Le,Ve,st,gt,ze,_t,Qt,Nt=M.isCompressedTexture?M.mipmaps[Te]:M.image;if(j!==null)Ie=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Le=j.isBox3?j.max.z-j.min.z:1,Ve=j.min.x,st=j.min.y,gt=j.isBox3?j.min.z:0;else{let dt=Math.pow(2,-$);Ie=Math.floor(Nt.width*dt),Ae=Math.floor(Nt.height*dt),M.isDataArrayTexture?Le=Nt.depth:M.isData3DTexture?Le=Math.floor(Nt.depth*dt):Le=1,Ve=0,st=0,gt=0}Y!==null?(ze=Y.x,_t=Y.y,Qt=Y.z):(ze=0,_t=0,Qt=0);let Ut=_e.convert(B.format),yn=_e.convert(B.type),Oe;B.isData3DTexture?(Ze.setTexture3D(B,0),Oe=O.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Ze.setTexture2DArray(B,0),Oe=O.TEXTURE_2D_ARRAY):(Ze.setTexture2D(B,0),Oe=O.TEXTURE_2D),we.activeTexture(O.TEXTURE0),we.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,B.flipY),we.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),we.pixelStorei(O.UNPACK_ALIGNMENT,B.unpackAlignment);let un=we.getParameter(O.UNPACK_ROW_LENGTH),yt=we.getParameter(O.UNPACK_IMAGE_HEIGHT),us=we.getParameter(O.UNPACK_SKIP_PIXELS),fn=we.getParameter(O.UNPACK_SKIP_ROWS),qr=we.getParameter(O.UNPACK_SKIP_IMAGES);we.pixelStorei(O.UNPACK_ROW_LENGTH,Nt.width),we.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Nt.height),we.pixelStorei(O.UNPACK_SKIP_PIXELS,Ve),we.pixelStorei(O.UNPACK_SKIP_ROWS,st),we.pixelStorei(O.UNPACK_SKIP_IMAGES,gt);let Yi=M.isDataArrayTexture||M.isData3DTexture,fs=B.isDataArrayTexture||B.isData3DTexture;if(M.isDepthTexture){let dt=He.get(M),nn=He.get(B),Xn=He.get(dt.__renderTarget),Ft=He.get(nn.__renderTarget);we.bindFramebuffer(O.READ_FRAMEBUFFER,Xn.__webglFramebuffer),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let dn=0;dn<Le;dn++)Yi&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,He.get(M).__webglTexture,$,gt+dn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,He.get(B).__webglTexture,Te,Qt+dn)),O.blitFramebuffer(Ve,st,Ve+Ie,st+Ae,ze,_t,ze+Ie,_t+Ae,O.DEPTH_BUFFER_BIT,O.NEAREST);we.bindFramebuffer(O.READ_FRAMEBUFFER,null),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if($!==0||M.isRenderTargetTexture||He.has(M)){let dt=He.get(M),nn=He.get(B);we.bindFramebuffer(O.READ_FRAMEBUFFER,N),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let Xn=0;Xn<Le;Xn++)Yi?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,dt.__webglTexture,$,gt+Xn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,dt.__webglTexture,$),fs?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,nn.__webglTexture,Te,Qt+Xn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,nn.__webglTexture,Te),$!==0?O.blitFramebuffer(Ve,st,Ve+Ie,st+Ae,ze,_t,ze+Ie,_t+Ae,O.COLOR_BUFFER_BIT,O.NEAREST):fs?O.copyTexSubImage3D(Oe,Te,ze,_t,Qt+Xn,Ve,st,Ie,Ae):O.copyTexSubImage2D(Oe,Te,ze,_t,Ve,st,Ie,Ae);we.bindFramebuffer(O.READ_FRAMEBUFFER,null),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else fs?M.isDataTexture||M.isData3DTexture?O.texSubImage3D(Oe,Te,ze,_t,Qt,Ie,Ae,Le,Ut,yn,Nt.data):B.isCompressedArrayTexture?O.compressedTexSubImage3D(Oe,Te,ze,_t,Qt,Ie,Ae,Le,Ut,Nt.data):O.texSubImage3D(Oe,Te,ze,_t,Qt,Ie,Ae,Le,Ut,yn,Nt):M.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Te,ze,_t,Ie,Ae,Ut,yn,Nt.data):M.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Te,ze,_t,Nt.width,Nt.height,Ut,Nt.data):O.texSubImage2D(O.TEXTURE_2D,Te,ze,_t,Ie,Ae,Ut,yn,Nt);we.pixelStorei(O.UNPACK_ROW_LENGTH,un),we.pixelStorei(O.UNPACK_IMAGE_HEIGHT,yt),we.pixelStorei(O.UNPACK_SKIP_PIXELS,us),we.pixelStorei(O.UNPACK_SKIP_ROWS,fn),we.pixelStorei(O.UNPACK_SKIP_IMAGES,qr),Te===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&O.generateMipmap(Oe),we.unbindTexture()},this.initRenderTarget=function(M){He.get(M).__webglFramebuffer===void 0&&Ze.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?Ze.setTextureCube(M,0):M.isData3DTexture?Ze.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?Ze.setTexture2DArray(M,0):Ze.setTexture2D(M,0),we.unbindTexture()},this.resetState=function(){K=0,z=0,he=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ci}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=bt._getDrawingBufferColorSpace(e),t.unpackColorSpace=bt._getUnpackColorSpace()}};var Lh=64,Kg=[["x","#d03a2b",new X(1,0,0)],["y","#2c8a3d",new X(0,1,0)],["z","#2f6fd0",new X(0,0,1)]],hd="http://www.w3.org/2000/svg",Dh=class{element=document.createElementNS(hd,"svg");#e=[];constructor(){this.element.setAttribute("viewBox",`${-Lh/2} ${-Lh/2} ${Lh} ${Lh}`),this.element.setAttribute("class","axes"),this.element.setAttribute("aria-hidden","true");for(let[e,t]of Kg){let n=document.createElementNS(hd,"line");n.setAttribute("stroke",t),n.setAttribute("stroke-width","2");let s=document.createElementNS(hd,"text");s.setAttribute("fill",t),s.textContent=e,this.#e.push([n,s]),this.element.append(n,s)}}follow(e){let t=e.quaternion.clone().invert();Kg.forEach(([,,n],s)=>{let{x:r,y:a}=n.clone().applyQuaternion(t),[o,l]=this.#e[s];o.setAttribute("x2",(20*r).toFixed(2)),o.setAttribute("y2",(-20*a).toFixed(2)),l.setAttribute("x",(26*r).toFixed(2)),l.setAttribute("y",(-26*a).toFixed(2))})}};var Jg={type:"change"},fd={type:"start"},Qg={type:"end"},Nh=new $s,jg=new Zn,Xw=Math.cos(70*Zf.DEG2RAD),Mn=new X,ii=2*Math.PI,Rt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},ud=1e-6,Uh=class extends Vo{constructor(e,t=null){super(e,t),this.state=Rt.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:js.ROTATE,MIDDLE:js.DOLLY,RIGHT:js.PAN},this.touches={ONE:Qs.ROTATE,TWO:Qs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new fi,this._lastTargetPosition=new X,this._quat=new fi().setFromUnitVectors(e.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ta,this._sphericalDelta=new Ta,this._scale=1,this._panOffset=new X,this._rotateStart=new it,this._rotateEnd=new it,this._rotateDelta=new it,this._panStart=new it,this._panEnd=new it,this._panDelta=new it,this._dollyStart=new it,this._dollyEnd=new it,this._dollyDelta=new it,this._dollyDirection=new X,this._mouse=new it,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Yw.bind(this),this._onPointerDown=qw.bind(this),this._onPointerUp=$w.bind(this),this._onContextMenu=t1.bind(this),this._onMouseWheel=Jw.bind(this),this._onKeyDown=jw.bind(this),this._onTouchStart=Qw.bind(this),this._onTouchMove=e1.bind(this),this._onMouseDown=Zw.bind(this),this._onMouseMove=Kw.bind(this),this._interceptControlDown=n1.bind(this),this._interceptControlUp=i1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Rt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Jg),this.update(),this.state=Rt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Mn.copy(t).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Rt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ii:n>Math.PI&&(n-=ii),s<-Math.PI?s+=ii:s>Math.PI&&(s-=ii),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){let o=Mn.length();a=this._clampDistance(o*this._scale);let l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let o=new X(this._mouse.x,this._mouse.y,0);o.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new X(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(Nh.origin.copy(this.object.position),Nh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Nh.direction))<Xw?this.object.lookAt(this.target):(jg.setFromNormalAndCoplanarPoint(this.object.up,this.target),Nh.intersectPlane(jg,this.target))))}else if(this.object.isOrthographicCamera){let a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>ud||8*(1-this._lastQuaternion.dot(this.object.quaternion))>ud||this._lastTargetPosition.distanceToSquared(this.target)>ud?(this.dispatchEvent(Jg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ii/60*this.autoRotateSpeed*e:ii/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Mn.setFromMatrixColumn(t,0),Mn.multiplyScalar(-e),this._panOffset.add(Mn)}_panUp(e,t){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(t,1):(Mn.setFromMatrixColumn(t,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(e),this._panOffset.add(Mn)}_pan(e,t){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/n.clientHeight,this.object.matrix),this._panUp(2*t*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=e-n.left,r=t-n.top,a=n.width,o=n.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/t.clientHeight),this._rotateUp(ii*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ii*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(n,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let n=this._getSecondPointerPosition(e),s=.5*(e.pageX+n.x),r=.5*(e.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ii*this._rotateDelta.x/t.clientHeight),this._rotateUp(ii*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),n=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),n=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new it,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,n={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function qw(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Yw(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function $w(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Qg),this.state=Rt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function Zw(i){let e;switch(i.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case js.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Rt.DOLLY;break;case js.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Rt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Rt.ROTATE}break;case js.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Rt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Rt.PAN}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(fd)}function Kw(i){switch(this.state){case Rt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Rt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Rt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function Jw(i){this.enabled===!1||this.enableZoom===!1||this.state!==Rt.NONE||(i.preventDefault(),this.dispatchEvent(fd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Qg))}function jw(i){this.enabled!==!1&&this._handleKeyDown(i)}function Qw(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Qs.ROTATE:if(this.enableRotate===!1){this.state=Rt.NONE;break}this._handleTouchStartRotate(i),this.state=Rt.TOUCH_ROTATE;break;case Qs.PAN:if(this.enablePan===!1){this.state=Rt.NONE;break}this._handleTouchStartPan(i),this.state=Rt.TOUCH_PAN;break;default:this.state=Rt.NONE}break;case 2:switch(this.touches.TWO){case Qs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Rt.TOUCH_DOLLY_PAN;break;case Qs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Rt.TOUCH_DOLLY_ROTATE;break;default:this.state=Rt.NONE}break;default:this.state=Rt.NONE}this.state!==Rt.NONE&&this.dispatchEvent(fd)}function e1(i){switch(this._trackPointer(i),this.state){case Rt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Rt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Rt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Rt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Rt.NONE}}function t1(i){this.enabled!==!1&&i.preventDefault()}function n1(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function i1(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var s1={oblique:[.55,-1,.42],front:[0,-1,0],side:[1,0,0],top:[0,-.001,1]},e0=Math.PI/24,t0=32,Oh=[["Arrow keys","turn"],["Shift + arrow keys","move"],["+ and -","zoom"],["0","whole packing"],["1, 2, 3, 4","oblique, front, side, top view"]],Fh=class{camera=new Kn(t0,1,.01,100);controls;#e=new X(1,1,1);#t=new AbortController;#r;#o=!1;constructor(e,t){this.#r=t,this.camera.up.set(0,0,1),this.controls=new Uh(this.camera,e),this.controls.zoomToCursor=!0,this.controls.addEventListener("change",t),this.controls.addEventListener("start",()=>this.#o=!0),this.controls.enableZoom=!1;let n={signal:this.#t.signal};e.addEventListener("focus",()=>this.controls.enableZoom=!0,n),e.addEventListener("blur",()=>this.controls.enableZoom=!1,n),e.addEventListener("pointerdown",()=>e.focus({preventScroll:!0}),n),e.addEventListener("keydown",s=>this.#c(s),n),this.view("oblique")}setExtent(e){this.#e.copy(e)}view(e){this.#i(new X(...s1[e]).normalize()),this.#o=!1}whole(){this.#i(this.camera.position.clone().sub(this.controls.target).normalize())}resize(e){this.camera.aspect=e,this.camera.updateProjectionMatrix(),this.#o||this.whole()}#i(e){this.controls.target.set(0,0,0),this.camera.position.copy(e),this.camera.lookAt(0,0,0),this.camera.updateMatrixWorld(),this.camera.position.multiplyScalar(this.#n()),this.controls.update(),this.#r()}#n(){let e=Math.tan(t0*Math.PI/360),t=e*this.camera.aspect,n=this.camera.quaternion.clone().invert(),s=.1;for(let[r,a,o]of r1()){let l=new X(r,a,o).multiply(this.#e).applyQuaternion(n);s=Math.max(s,l.z+Math.max(Math.abs(l.x)/t,Math.abs(l.y)/e))}return 1.04*s}#c(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let t={1:"oblique",2:"front",3:"side",4:"top"},s={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[e.key];if(s&&e.shiftKey)this.#h(...s);else if(s)this.#s(...s);else if(e.key==="+"||e.key==="=")this.#l(1/1.15);else if(e.key==="-"||e.key==="_")this.#l(1.15);else if(e.key==="0"||e.key==="Home")this.whole();else if(t[e.key])this.view(t[e.key]);else return;e.preventDefault(),e.stopPropagation()}#s(e,t){let n=this.camera.position.clone().sub(this.controls.target);n.applyAxisAngle(this.camera.up,e*e0);let s=new X().crossVectors(this.camera.up,n).normalize(),r=n.angleTo(this.camera.up),a=Math.min(Math.max(r-t*e0,.01),Math.PI-.01);n.applyAxisAngle(s,a-r),this.camera.position.copy(this.controls.target).add(n),this.#a()}#h(e,t){let n=.05*this.camera.position.distanceTo(this.controls.target),s=new X(e*n,t*n,0).applyQuaternion(this.camera.quaternion);this.camera.position.add(s),this.controls.target.add(s),this.#a()}#l(e){let t=this.camera.position.clone().sub(this.controls.target).multiplyScalar(e);this.camera.position.copy(this.controls.target).add(t),this.#a()}#a(){this.#o=!0,this.controls.update(),this.#r()}dispose(){this.controls.dispose(),this.#t.abort()}};function*r1(){for(let i of[-1,1])for(let e of[-1,1])for(let t of[-1,1])yield[i,e,t]}var Na=`
uniform vec3 origin;
uniform float scale;
vec3 place(vec3 x) { return (x - origin) * scale; }
`;var Bh=`
uniform sampler2D colours;
uniform vec2 range;
uniform float categories;
uniform vec3 noValue;
vec3 colourOf(float value) {
    if (value < -1e29) return noValue;
    float t = categories > 0.5
        ? (mod(value, 10.0) + 0.5) / 256.0
        : clamp((value - range.x) / (range.y - range.x), 0.0, 1.0) * 255.0 / 256.0 + 0.5 / 256.0;
    return texture(colours, vec2(t, 0.5)).rgb;
}
`,kh=`
vec3 lit(vec3 colour, vec3 normal, vec3 toEye) {
    float facing = max(dot(normal, toEye), 0.0);
    float side = max(dot(normal, normalize(vec3(-0.5, 0.7, 0.5))), 0.0);
    return colour * (0.34 + 0.42 * facing + 0.26 * side) + vec3(0.10 * pow(side, 24.0));
}
`,Ar=`
uniform vec4 clip;
uniform float clipped;
bool cut(vec3 x) { return clipped > 0.5 && dot(clip.xyz, x) > clip.w; }
`,n0=`
bool sifted(float opacity) {
    if (opacity >= 1.0) return false;
    // interleaved gradient noise, J. Jimenez (2014)
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) >= opacity;
}
`,i0=`
uniform mat4 projection;
float depthOf(vec3 x) {
    vec4 p = projection * vec4(x, 1.0);
    return 0.5 * p.z / p.w + 0.5;
}
`;var a1=`
in vec3 from;
in vec3 to;
in float thickness;
in float value;
uniform float thick;
out vec3 viewPlace;
out vec3 viewNormal;
out float chainValue;
${Na}
void main() {
    vec3 a = place(from);
    vec3 b = place(to);
    vec3 axis = normalize(b - a);
    vec3 right = normalize(cross(axis, abs(axis.z) > 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0)));
    vec3 up = cross(axis, right);
    vec3 out_ = position.x * right + position.y * up;
    vec4 view = modelViewMatrix * vec4(mix(a, b, position.z) + thick * thickness * scale * out_, 1.0);
    viewPlace = view.xyz;
    viewNormal = (modelViewMatrix * vec4(out_, 0.0)).xyz;
    chainValue = value;
    gl_Position = projectionMatrix * view;
}
`,o1=`
precision highp float;
in vec3 viewPlace;
in vec3 viewNormal;
in float chainValue;
out vec4 shown;
${Bh}${kh}${Ar}
void main() {
    if (cut(viewPlace)) discard;
    vec3 toEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -normalize(viewPlace);
    shown = vec4(lit(colourOf(chainValue), normalize(viewNormal), toEye), 1.0);
}
`,dd=10,zh=class{mesh;constructor(e){let t=new On({glslVersion:As,vertexShader:a1,fragmentShader:o1,uniforms:e,side:ni});this.mesh=new Hn(s0(),t),this.mesh.frustumCulled=!1,this.mesh.visible=!1}set(e,t,n,s,r){let a=[];t.forEach((u,f)=>{u>=n&&u>0&&a.push(f)});let o=u=>Float32Array.from({length:3*a.length},(f,d)=>e[6*a[Math.floor(d/3)]+u+d%3]),l=u=>r*Math.sqrt(Math.min(u/s,2)),c=s0(),h=(u,f,d)=>{c.setAttribute(u,new vr(f,d))};return h("from",o(0),3),h("to",o(3),3),h("thickness",Float32Array.from(a,u=>l(t[u])),1),h("value",Float32Array.from(a,u=>Number.isFinite(t[u])?t[u]:-1e30),1),c.instanceCount=a.length,this.mesh.geometry.dispose(),this.mesh.geometry=c,a.length}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}};function s0(){let i=new yr,e=[],t=[];for(let n=0;n<dd;n++){let s=2*Math.PI*n/dd;e.push(Math.cos(s),Math.sin(s),0,Math.cos(s),Math.sin(s),1);let[r,a]=[2*n,2*((n+1)%dd)];t.push(r,a,r+1,a,a+1,r+1)}return i.setAttribute("position",new Fn(new Float32Array(e),3)),i.setIndex(t),i.instanceCount=0,i}var r0={viridis:["#440154","#482878","#3e4989","#31688e","#26828e","#1f9e89","#35b779","#6ece58","#b5de2b","#fde725"],cividis:["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"],coolwarm:["#3b4cc0","#6788ee","#9abbff","#c9d7f0","#edd1c2","#f7a889","#e26952","#b40426"],grey:["#303030","#f0f0f0"]},Hh=["#4477aa","#ee6677","#228833","#ccbb44","#66ccee","#aa3377","#bbbbbb","#ee8866","#44bb99","#99ddff"],Gh="#909090",Vh=256;function md(i){let e=parseInt(i.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function gd(i,e){let t=r0[i],n=Math.min(Math.max(e,0),1)*(t.length-1),s=Math.min(Math.floor(n),t.length-2),r=md(t[s]),a=md(t[s+1]),o=l=>Math.round(r[l]+(a[l]-r[l])*(n-s));return[o(0),o(1),o(2)]}function a0(i){return`linear-gradient(to right, ${r0[i].join(", ")})`}function o0(i){let e=new Uint8Array(4*Vh);for(let n=0;n<Vh;n++)e.set([...i(n),255],4*n);let t=new Ma(e,Vh,1,vi);return t.minFilter=t.magFilter=gn,t.needsUpdate=!0,t}function l0(i){return o0(e=>gd(i,e/(Vh-1)))}function c0(){return o0(i=>md(Hh[i%Hh.length]))}function h0(i){let e=Hh.length;return Hh[(i%e+e)%e]}function _d(i){let e=i.filter(Number.isFinite).sort();if(e.length===0)return[0,1];let t=o=>e[Math.round(o*(e.length-1))],[n,s]=[t(0),t(1)],[r,a]=[t(.01),t(.99)];return s-n>3*(a-r)&&a>r&&([n,s]=[Math.max(n,r-(a-r)),Math.min(s,a+(a-r))]),s>n?[n,s]:[n-.5*Math.abs(n||1),n+.5*Math.abs(n||1)]}var vd=[1,.5,.3333333333333333,.25,.16666666666666666],Wh=class{#e;#t;#r=0;#o=0;#i=!1;constructor(e,t){this.#e=e,this.#t=t}get share(){let e=Math.sqrt(60/Math.max(this.#r,1));return vd.find(t=>t<=e)??vd[vd.length-1]}drawn(e){clearTimeout(this.#o),e<1&&(this.#o=window.setTimeout(this.#t,250));let t=this.#i?null:this.#e.fenceSync(this.#e.SYNC_GPU_COMMANDS_COMPLETE,0);t&&(this.#i=!0,this.#e.flush(),this.#n(t,performance.now(),e))}stop(){clearTimeout(this.#o)}#n(e,t,n){setTimeout(()=>{let s=this.#e.getSyncParameter(e,this.#e.SYNC_STATUS);if(s!==null&&s!==this.#e.SIGNALED){this.#n(e,t,n);return}this.#e.deleteSync(e),this.#i=!1;let r=(performance.now()-t)/n**2;this.#r=this.#r===0?r:.5*this.#r+.5*r},4)}};function u0(i,e,t,n){let[s,r,a]=i.from,[o,l,c]=i.direction,[h,u]=[0,1/0];if(n){let[g,b,p]=n.normal,m=g*o+b*l+p*c,y=n.offset-(g*s+b*r+p*a);if(m<0)h=Math.max(h,y/m);else if(m>0)u=y/m;else if(y<0)return-1}let f=-1,d=u;for(let g=0;g<t.length;g++){let b=e[3*g]-s,p=e[3*g+1]-r,m=e[3*g+2]-a,y=b*o+p*l+m*c,C=(b-y*o)**2+(p-y*l)**2+(m-y*c)**2,w=t[g]**2-C;if(w<0)continue;let I=Math.sqrt(w),T=Math.max(y-I,h);T<=y+I&&T<d&&(d=T,f=g)}return f}var l1=`
in vec3 centre;
in float radius;
in float value;
in float marked;
uniform float size;
out vec3 viewCentre;
out vec3 viewPlace;
out float sphereRadius;
out float sphereValue;
out float sphereMarked;
${Na}
void main() {
    viewCentre = (modelViewMatrix * vec4(place(centre), 1.0)).xyz;
    sphereRadius = radius * scale * size;
    sphereValue = value;
    sphereMarked = marked;
    vec3 toEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -normalize(viewCentre);
    float distance = length(viewCentre);
    // in perspective the outline of a sphere is wider than its radius
    float wide = isOrthographic ? 1.0 : distance / sqrt(max(distance * distance - sphereRadius * sphereRadius, 1e-12));
    vec3 right = normalize(cross(abs(toEye.y) > 0.99 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), toEye));
    vec3 up = cross(toEye, right);
    viewPlace = viewCentre + 1.05 * wide * sphereRadius * (position.x * right + position.y * up);
    gl_Position = projectionMatrix * vec4(viewPlace, 1.0);
}
`,c1=`
precision highp float;
in vec3 viewCentre;
in vec3 viewPlace;
in float sphereRadius;
in float sphereValue;
in float sphereMarked;
uniform float opacity;
uniform vec3 mark;
out vec4 shown;
${Bh}${kh}${Ar}${n0}${i0}
void main() {
    vec3 from = isOrthographic ? vec3(viewPlace.xy, 0.0) : vec3(0.0);
    vec3 ray = isOrthographic ? vec3(0.0, 0.0, -1.0) : normalize(viewPlace);
    // from the point of the ray that is nearest to the centre: exact also far away
    float along = dot(viewCentre - from, ray);
    vec3 nearest = from + along * ray - viewCentre;
    float inside = sphereRadius * sphereRadius - dot(nearest, nearest);
    if (inside < 0.0) discard;
    float reach = sqrt(inside);
    vec3 x = from + (along - reach) * ray;
    vec3 normal = (x - viewCentre) / sphereRadius;
    vec3 colour = colourOf(sphereValue);
    if (sphereMarked > 0.5) colour = mix(colour, mark, 0.85);
    if (cut(x)) {
        // where the plane cuts the sphere its section is shown
        float steep = dot(clip.xyz, ray);
        float t = (clip.w - dot(clip.xyz, from)) / (abs(steep) < 1e-9 ? 1e-9 : steep);
        if (steep >= 0.0 || t > along + reach || t < along - reach) discard;
        x = from + t * ray;
        normal = clip.xyz;
        colour *= 0.82;
    }
    if (sphereMarked < 0.5 && sifted(opacity)) discard;
    shown = vec4(lit(colour, normal, -ray), 1.0);
    gl_FragDepth = depthOf(x);
}
`,Xh=class{mesh;#e=new yr;constructor(e){this.#e.setAttribute("position",new Fn(new Float32Array([-1,-1,0,1,-1,0,1,1,0,-1,1,0]),3)),this.#e.setIndex([0,1,2,0,2,3]),this.#e.instanceCount=0;let t=new On({glslVersion:As,vertexShader:l1,fragmentShader:c1,uniforms:e});this.mesh=new Hn(this.#e,t),this.mesh.frustumCulled=!1}set(e,t){this.#t("centre",e,3),this.#t("radius",t,1),this.#t("value",new Float32Array(t.length),1),this.#t("marked",new Float32Array(t.length),1),this.#e.instanceCount=t.length}setValues(e){this.#t("value",e.map(t=>Number.isFinite(t)?t:-1e30),1)}setMarked(e){this.#t("marked",e,1)}#t(e,t,n){let s=this.#e.getAttribute(e);if(s&&s.array.length===t.length){s.array.set(t),s.needsUpdate=!0;return}let r=new vr(Float32Array.from(t),n);r.setUsage(Wf),s&&this.#e.dispose(),this.#e.setAttribute(e,r)}dispose(){this.#e.dispose(),this.mesh.material.dispose()}};var h1=`
out vec3 viewPlace;
${Na}
void main() {
    viewPlace = (modelViewMatrix * vec4(place(position), 1.0)).xyz;
    gl_Position = projectionMatrix * vec4(viewPlace, 1.0);
}
`,u1=`
precision highp float;
in vec3 viewPlace;
uniform vec3 colour;
uniform float opacity;
out vec4 shown;
${Ar}
void main() {
    if (cut(viewPlace)) discard;
    vec3 normal = normalize(cross(dFdx(viewPlace), dFdy(viewPlace)));
    vec3 toEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -normalize(viewPlace);
    shown = vec4(colour * (0.72 + 0.28 * abs(dot(normal, toEye))), opacity);
}
`,f1=`
precision highp float;
in vec3 viewPlace;
uniform vec3 edgeColour;
uniform float edgeOpacity;
out vec4 shown;
${Ar}
void main() {
    if (cut(viewPlace)) discard;
    shown = vec4(edgeColour, edgeOpacity);
}
`,d1=25,qh=class{group=new ys;#e;#t;#r={value:.18};#o={value:.8};constructor(e){let t={...e,opacity:this.#r,edgeOpacity:this.#o},n={glslVersion:As,vertexShader:h1,uniforms:t,transparent:!0,depthWrite:!1};this.#e=new On({...n,fragmentShader:u1,side:ni}),this.#t=new On({...n,fragmentShader:f1})}set(e){this.#i();for(let t of e){let n=new mi;n.setAttribute("position",new Fn(t,3));let s=new Hn(n,this.#e),r=new Lo(p1(n),this.#t);for(let a of[s,r])a.frustumCulled=!1,this.group.add(a);s.renderOrder=1,r.renderOrder=2}}setOpacity(e){this.#r.value=e,this.#o.value=Math.min(1,4*e),this.#e.depthWrite=e>=1,this.group.visible=e>0}#i(){for(let e of this.group.children)e.geometry.dispose();this.group.clear()}dispose(){this.#i(),this.#e.dispose(),this.#t.dispose()}};function p1(i){i.computeBoundingSphere();let{center:e,radius:t}=i.boundingSphere,n=t>0?t:1,s=i.clone().translate(-e.x,-e.y,-e.z).scale(1/n,1/n,1/n),r=new Fo(s,d1);return s.dispose(),r.scale(n,n,n).translate(e.x,e.y,e.z)}function d0(i,e){try{return new xd(i,e)}catch(t){let n=document.createElement("p");return n.className="no-webgl",n.setAttribute("role","alert"),n.textContent="The 3D view needs WebGL 2, which this browser does not offer or has switched off. Try a current Firefox, Chrome, Edge or Safari with hardware acceleration on; everything else on this page works without it.",i.replaceChildren(n),console.info(`no WebGL: ${t}`),null}}var xd=class{canvas;#e;#t;#r=new Ro;#o;#i;#n;#c;#s=new Dh;#h;#l={position:new Float32Array,radius:new Float32Array,id:new Uint32Array,scalars:new Map};#a=null;#u=[];#f={scalar:"",map:"viridis",range:[0,1],beyond:[!1,!1],names:null};#d={scalar:"",range:null,map:"viridis"};#m={shown:!1,threshold:0};#p=null;#g=new Set;#_=!1;#x=0;#v;#y=1;#w=new Map;#b={origin:{value:new X},scale:{value:1},projection:{value:new Gt}};#E={clip:{value:new Zt},clipped:{value:0}};#M={colours:{value:null},range:{value:new it(0,1)},categories:{value:0}};#S={colours:{value:null},range:{value:new it(0,1)},categories:{value:0}};#T={value:1};#A={value:1};#R={colour:{value:el("#7f8fa6")},edgeColour:{value:el("#66748a")}};#U={value:1};constructor(e,t){this.#e=e,this.#t=new Rh({antialias:!0,alpha:!0,powerPreference:"high-performance"}),this.#t.outputColorSpace=Xs,t.background&&(this.#r.background=el(t.background)),this.canvas=this.#t.domElement,this.canvas.tabIndex=0,this.canvas.setAttribute("role","application"),this.canvas.setAttribute("aria-label",t.label),e.replaceChildren(this.canvas,this.#s.element),this.#o=new Fh(this.canvas,()=>this.render());let n={value:el(Gh)},s={...this.#b,...this.#E,noValue:n},r={value:el("#ff2d87")};this.#i=new Xh({...s,...this.#M,size:this.#T,opacity:this.#A,mark:r}),this.#n=new zh({...s,...this.#S,thick:this.#U}),this.#c=new qh({...this.#b,...this.#E,...this.#R}),this.#r.add(this.#i.mesh,this.#n.mesh,this.#c.group),this.#M.colours.value=this.#P("viridis"),this.#S.colours.value=this.#P("viridis"),t.onPick&&this.#O(t.onPick),this.#v=new Wh(this.#t.getContext(),()=>this.#C()),this.#h=new ResizeObserver(()=>this.#I()),this.#h.observe(e),this.#I()}setGrains(e){this.#l=e,this.#i.set(e.position,e.radius),this.#g.size>0&&this.highlight([...this.#g]),this.#L(),this.#D()}setContacts(e){this.#a=e,this.#N()}setWalls(e){this.#u=e.map(t=>t.triangles),this.#c.set(this.#u),this.#L(),this.render()}colourBy(e,t=null,n="viridis"){return this.#d={scalar:e,range:t,map:n},this.#D(),this.#f}get colourScale(){return this.#f}showChains(e,t=0){return this.#m={shown:e,threshold:t},this.#N()}setWallOpacity(e){this.#c.setOpacity(e),this.render()}setGrainOpacity(e){this.#A.value=e,this.#i.mesh.visible=e>0,this.render()}setGrainSize(e){this.#T.value=e,this.render()}setClipPlane(e){this.#p=e,this.render()}highlight(e){this.#g=new Set(e),this.#i.setMarked(Float32Array.from(this.#l.id,t=>this.#g.has(t)?1:0)),this.render()}pick(e,t){let{clientWidth:n,clientHeight:s}=this.canvas,r=new zo;this.#o.camera.updateMatrixWorld(),r.setFromCamera(new it(2*e/n-1,1-2*t/s),this.#o.camera);let a=r.ray.origin.clone().divideScalar(this.#b.scale.value).add(this.#b.origin.value),{position:o,radius:l,id:c}=this.#l,h=this.#T.value===1?l:l.map(f=>f*this.#T.value),u=u0({from:a.toArray(),direction:r.ray.direction.toArray()},o,h,this.#p);return u<0||this.#A.value===0?null:c[u]}view(e){this.#o.view(e)}fit(){let e=this.bounds();if(e.isEmpty())return;let t=e.getSize(new X).multiplyScalar(.5),n=1/Math.max(t.length(),1e-30);this.#b.origin.value.copy(e.getCenter(new X)),this.#b.scale.value=n,this.#o.setExtent(t.multiplyScalar(n)),this.#_=!0,this.#o.whole()}bounds(){let e=new Ri,{position:t,radius:n}=this.#l,[s,r]=[new X,new X];for(let o=0;o<n.length;o++)s.fromArray(t,3*o).subScalar(n[o]),r.fromArray(t,3*o).addScalar(n[o]),e.expandByPoint(s).expandByPoint(r);let a=new Ri;for(let o of this.#u)a.union(new Ri().setFromArray(o));if(!e.isEmpty()&&!a.isEmpty()){let o=e.clone().expandByScalar(1.5*e.getSize(new X).length());a.intersect(o)}return e.union(a)}async screenshot(e){e&&(this.#y=1,this.#t.setPixelRatio(1),this.#t.setSize(e.width,e.height,!1),this.#o.camera.aspect=e.width/e.height,this.#o.camera.updateProjectionMatrix()),this.#C();let t=new Promise((n,s)=>{this.canvas.toBlob(r=>r?n(r):s(new Error("the browser made no picture")),"image/png")});return e&&this.#I(),t}picture(){return this.#C(),this.canvas.toDataURL("image/png")}render(){this.#x||=requestAnimationFrame(()=>this.#C(this.#v.share))}dispose(){cancelAnimationFrame(this.#x),this.#v.stop(),this.#h.disconnect(),this.#o.dispose();for(let e of[this.#i,this.#n,this.#c])e.dispose();for(let e of this.#w.values())e.dispose();this.#t.dispose(),this.#e.replaceChildren()}#L(){this.#_||(this.fit(),this.#_=this.#l.radius.length>0)}#D(){let{scalar:e,range:t,map:n}=this.#d,s=this.#l.scalars.get(e),r=this.#l.categories?.get(e)??null,[a,o]=t??_d(s??new Float32Array),l=[s?.some(c=>c<a)??!1,s?.some(c=>c>o)??!1];this.#f={scalar:e,map:n,range:[a,o],beyond:l,names:r},this.#i.setValues(s??new Float32Array(this.#l.radius.length).fill(NaN)),this.#M.colours.value=this.#P(r?"categories":n),this.#M.range.value.set(a,o),this.#M.categories.value=r?1:0,this.render()}#N(){let{shown:e,threshold:t}=this.#m;this.#n.mesh.visible=e&&this.#a!==null;let n=0;if(this.#n.mesh.visible){let{ends:s,normalForce:r}=this.#a,a=_d(r)[1],o=Float32Array.from(this.#l.radius).sort(),l=o[o.length>>1]??0;n=this.#n.set(s,r,t,a,.45*l),this.#S.range.value.set(0,a)}return this.render(),n}#P(e){let t=this.#w.get(e);return t||(t=e==="categories"?c0():l0(e),this.#w.set(e,t)),t}#I(){let{clientWidth:e,clientHeight:t}=this.#e;e>0&&t>0&&(this.#y=1,this.#t.setPixelRatio(f0()),this.#t.setSize(e,t),this.#o.resize(e/t),this.#C())}#C(e=1){cancelAnimationFrame(this.#x),this.#x=0,e!==this.#y&&(this.#y=e,this.#t.setPixelRatio(e*f0())),this.canvas.dataset.share=String(e);let t=this.#o.camera,n=t.position.length();t.near=Math.max(n-4,.002*Math.max(n,.5)),t.far=n+8,t.updateProjectionMatrix(),t.updateMatrixWorld(),this.#b.projection.value.copy(t.projectionMatrix),this.#F(t.matrixWorldInverse),this.#s.follow(t),this.#t.render(this.#r,t),this.#v.drawn(e)}#F(e){if(this.#E.clipped.value=this.#p?1:0,this.#p){let t=new X(...this.#p.normal),n=t.length()||1,s=(this.#p.offset-t.dot(this.#b.origin.value))/n*this.#b.scale.value,r=new Zn(t.divideScalar(n),-s).applyMatrix4(e);this.#E.clip.value.set(r.normal.x,r.normal.y,r.normal.z,-r.constant)}}#O(e){let t=null;this.canvas.addEventListener("pointerdown",n=>t=[n.offsetX,n.offsetY]),this.canvas.addEventListener("pointerup",n=>{t&&Math.hypot(n.offsetX-t[0],n.offsetY-t[1])<4&&e(this.pick(n.offsetX,n.offsetY)),t=null})}};function f0(){return Math.min(window.devicePixelRatio,2)}function el(i){return new St().setStyle(i,Xs)}var yd=[["G",1e9],["M",1e6],["k",1e3],["",1],["m",.001],["\xB5",1e-6],["n",1e-9],["p",1e-12]],m1=new Set(["m","s","N","J","Pa","W","m/s","N m","Hz"]);function Dn(i,e=5){if(!Number.isFinite(i))return Number.isNaN(i)?"\u2013":i>0?"\u221E":"\u2212\u221E";let t=Math.abs(i);return(t===0||t>=.001&&t<1e5?String(Number(i.toPrecision(e))):i.toExponential(e-1).replace(/\.?0+e/,"e")).replaceAll("-","\u2212").replace("e+","e")}function Cr(i,e){if(!m1.has(e)||!(i>0)||!Number.isFinite(i))return{unit:e,factor:1};let[t,n]=yd.find(([,s])=>i*1.00005>=s)??yd[yd.length-1];return{unit:t+e,factor:n}}function Bn(i,e){let{unit:t,factor:n}=Cr(Math.abs(i),e);return t===""?Dn(i,4):`${Dn(i/n,4)} ${t}`}function Nn(i,e){return e===""?i:`${i} [${e}]`}var bd=20;function p0(i,e,t){let n=re("div",{class:"colour-key"});if(i.names){let u=new Set(t??[]),f=i.names.map((d,g)=>[d,g]).filter(([,d])=>u.has(d));n.append(re("span",{class:"key-title"},i.scalar));for(let[d,g]of f.slice(0,bd)){let b=re("span",{class:"key-swatch"});b.style.background=h0(g),n.append(re("span",{class:"key-name"},b,d))}return f.length>bd&&n.append(`and ${f.length-bd} more`),n}let[s,r]=i.range,{unit:a,factor:o}=Cr(Math.max(Math.abs(s),Math.abs(r)),e),l=re("span",{class:"key-bar"});l.style.background=a0(i.map);let[c,h]=i.beyond;if(n.append(re("span",{class:"key-title"},Nn(i.scalar,a)),re("span",{class:"key-end"},`${c?"\u2264 ":""}${Dn(s/o,3)}`),l,re("span",{class:"key-end"},`${h?"\u2265 ":""}${Dn(r/o,3)}`)),t?.some(u=>!Number.isFinite(u))){let u=re("span",{class:"key-swatch"});u.style.background=Gh,n.append(re("span",{class:"key-name"},u,"no value"))}return n}var g1={x:[1,0,0],y:[0,1,0],z:[0,0,1]},_1=[["viridis","Viridis"],["cividis","Cividis"],["coolwarm","Cool to warm"],["grey","Grey"]],v1=[["oblique","Oblique"],["front","Front"],["side","Side"],["top","Top"]],m0=.12,g0="Click a grain to see its values.",Sd=30,Md=i=>`${Math.round(100*i)} %`,Yh=class{scene;element=re("div",{class:"scene-panel"});view=re("div",{class:"scene-view"});controls=re("div",{class:"scene-controls"});#e;#t=re("div",{class:"key-holder"});#r=re("div",{class:"picked",role:"status"});#o=re("p",{class:"hint"});#i={grains:{position:new Float32Array,radius:new Float32Array,id:new Uint32Array,scalars:new Map},contacts:null,walls:[],scalars:[]};#n={scalar:"",map:"viridis",range:null};#c=!1;#s={shown:!1,threshold:1};#h={axis:"",normal:[1,-1,1],share:.5,flipped:!1};#l;#a;#u;constructor(e,t){this.#e=t;let n=re("div",{class:"scene-frame"});this.view.append(n,this.#t),this.element.append(this.view),e.replaceChildren(this.element),this.scene=d0(n,{label:this.#f(),onPick:s=>this.pick(s)}),this.scene&&(this.element.append(this.controls),this.controls.append(this.#m(),this.#x(),this.#v(),this.#w(),this.#T(this.scene)),(t.describes??!0)&&(this.view.append(this.#r),this.#r.textContent=g0),y1(n,this.scene))}#f(){let e=Oh.map(([t,n])=>`${t}: ${n}`).join("; ");return`${this.#e.label}, a 3D view. ${e}.`}show(e){if(!this.scene)return;this.#i=e;let t=e.scalars.map(n=>n.name);t.join()!==Array.from(this.#l.options,n=>n.value).join()&&this.#l.replaceChildren(...t.map(n=>re("option",{value:n},n))),this.#d(t),this.#l.value=this.#n.scalar,this.scene.setWalls(e.walls),this.scene.setGrains(e.grains),this.scene.setContacts(e.contacts),this.#_(),this.#y(),this.#S()}#d(e){let t=e.indexOf(this.#n.scalar);if(t<0||!this.#c){let n=x1(this.#i);this.#n.scalar=t>=0&&t<e.indexOf(n)?this.#n.scalar:n}}colourBy(e){this.#c=!0,this.#n={...this.#n,scalar:e,range:null},this.#l.value=e,this.#_()}pick(e){this.scene?.highlight(e===null?[]:[e]),this.#r.replaceChildren(...e===null?[g0]:this.#A(e)),this.#e.onPick?.(e)}#m(){let e=Ti("Colour grains by",[],o=>this.colourBy(o));this.#l=e.select;let t=Ti("Colours",_1,o=>{this.#n.map=o,this.#_()}),n=o=>{let l=re("input",{type:"number",step:"any","aria-label":o});return l.addEventListener("change",()=>this.#p()),l};this.#a=[n("From"),n("To")];let s=In("Automatic",()=>{this.#n.range=null,this.#_()}),r=In("Hold",()=>{this.#n.range=[...this.scene.colourScale.range],this.#_()},{title:"Keep this range in other frames"}),a=re("div",{class:"range-row"},this.#a[0],re("span",{},"to"),this.#a[1],s,r);return ji("Colours",e.element,t.element,a)}#p(){let[e,t]=this.#a.map(r=>r.valueAsNumber),{factor:n}=this.#g(),s=Number.isFinite(e)&&Number.isFinite(t)&&e<t;this.#a.forEach(r=>r.setAttribute("aria-invalid",String(!s))),s&&(this.#n.range=[e*n,t*n],this.#_())}#g(){let[e,t]=this.scene?.colourScale.range??[0,1],n=this.#i.scalars.find(s=>s.name===this.#n.scalar)?.unit??"";return Cr(Math.max(Math.abs(e),Math.abs(t)),n)}#_(){let{scalar:e,range:t,map:n}=this.#n,s=this.scene.colourBy(e,t,n),r=this.#i.scalars.find(o=>o.name===e);this.#t.replaceChildren(p0(s,r?.unit??"",this.#i.grains.scalars.get(e))),r?.meaning&&this.#t.append(re("span",{class:"key-meaning"},r.meaning));let{factor:a}=this.#g();s.range.forEach((o,l)=>{let c=this.#a[l];c.value=String(Number((o/a).toPrecision(4))),c.disabled=s.names!==null,c.setAttribute("aria-invalid","false")})}#x(){let e=this.scene;this.#u=ea("Opacity of grains",{min:0,max:1,step:.02,value:1},Md,s=>e.setGrainOpacity(s));let t=ea("Size of grains",{min:.1,max:1,step:.05,value:1},Md,s=>e.setGrainSize(s)),n=ea("Opacity of walls",{min:0,max:1,step:.02,value:.18},Md,s=>e.setWallOpacity(s));return ji("Grains and walls",this.#u.element,t.element,n.element)}#v(){let e=li("Show force chains",!1,s=>{this.#s.shown=s,s&&this.#u.input.valueAsNumber===1?this.#u.set(m0):!s&&this.#u.input.valueAsNumber===m0&&this.#u.set(1),this.#y()}),n=ea("Normal force",{min:0,max:5,step:.1,value:1},s=>s===0?"all contacts":`from ${Dn(s,2)} \xD7 mean`,s=>{this.#s.threshold=s,this.#y()});return ji("Force chains",e.element,n.element,this.#o)}#y(){let e=this.#i.contacts,t=e?.meanForce??0,n=this.scene.showChains(this.#s.shown,this.#s.threshold*t),s=e?.idI.length??0,r=s===0?"No contact carries a force in this state.":`Mean normal force ${Bn(t,"N")}.`;this.#o.textContent=this.#s.shown&&s>0?`${n} of ${s} contacts; thicker is stronger. ${r}`:r}#w(){let e=ea("Position",{min:0,max:1,step:.01,value:.5},a=>this.#M(a),a=>{this.#h.share=a,this.#S()}),t=[["","off"],["x","across x"],["y","across y"],["z","across z"],["any","across any direction"]],n=this.#b(()=>e.set(e.input.valueAsNumber)),s=Ti("Cut",t,a=>{this.#h.axis=a,e.input.disabled=a==="",n.hidden=a!=="any",e.set(e.input.valueAsNumber)}),r=li("Show the other side",!1,a=>{this.#h.flipped=a,this.#S()});return e.input.disabled=!0,ji("Clip plane",s.element,n,e.element,r.element)}#b(e){let t=["x","y","z"].map((s,r)=>{let a=re("input",{type:"number",step:"any",value:this.#h.normal[r],"aria-label":`${s} of the normal`});return a.addEventListener("input",()=>{let o=t.map(c=>c.valueAsNumber),l=o.every(Number.isFinite)&&o.some(c=>c!==0);t.forEach(c=>c.setAttribute("aria-invalid",String(!l))),l&&(this.#h.normal=o,e())}),a}),n=re("div",{class:"range-row direction"},"normal ",...t);return n.hidden=!0,n}#E(e){let{axis:t,normal:n}=this.#h,s=t==="any"||t===""?n:g1[t],r=Math.hypot(...s),a=s.map(u=>u/r),o=this.scene.bounds();if(o.isEmpty())return{normal:a,place:0};let[l,c]=[o.min.toArray(),o.max.toArray()],h=u=>a.reduce((f,d,g)=>f+d*(d>0===u?c:l)[g],0);return{normal:a,place:h(!1)+e*(h(!0)-h(!1))}}#M(e){let{axis:t}=this.#h??{axis:""};return t===""?"":`${t==="any"?"distance from the origin":t} = ${Bn(this.#E(e).place,"m")}`}#S(){let{axis:e,share:t,flipped:n}=this.#h;if(e===""){this.scene.setClipPlane(null);return}let s=(e==="y"?-1:1)*(n?-1:1),{normal:r,place:a}=this.#E(t);this.scene.setClipPlane({normal:r.map(o=>s*o),offset:s*a})}#T(e){let t=v1.map(([o,l])=>In(l,()=>e.view(o))),n=In("Save picture",()=>{e.screenshot().then(o=>ta(o,`${this.#e.fileName}.png`))}),s=In("Full screen",()=>{document.fullscreenElement?document.exitFullscreen():this.element.requestFullscreen()});s.hidden=!document.fullscreenEnabled;let r=re("dl",{class:"keys"},...Oh.flatMap(([o,l])=>[re("dt",{},o),re("dd",{},l)])),a=re("details",{},re("summary",{},"Mouse and keys"),re("p",{},"Drag to turn, drag with the right button to move; the wheel zooms once the view has the focus. With the focus on the view:"),r);return ji("View",re("div",{class:"button-row"},...t),re("div",{class:"button-row"},n,s),a)}#A(e){let{grains:t,contacts:n,scalars:s}=this.#i,r=t.id.indexOf(e);if(r<0)return[re("p",{},`Grain ${e} is not there.`)];let a=re("dl",{class:"values"}),o=(u,f)=>a.append(re("div",{},re("dt",{},u),re("dd",{},f))),l=Array.from(t.position.subarray(3*r,3*r+3),u=>Bn(u,"m"));o("centre",`(${l.join(", ")})`);for(let{name:u,unit:f}of s){let d=t.scalars.get(u)?.[r]??NaN,g=t.categories?.get(u);o(u,g?g[d]??String(d):Bn(d,f))}let c=[re("h3",{},`Grain ${e}`),a],h=n?this.#R(e):[];if(h.length>0){let u=h.length>Sd?[re("li",{},`and ${h.length-Sd} more`)]:[];c.push(re("details",{},re("summary",{},`${h.length} contacts`),re("ul",{},...h.slice(0,Sd).map(f=>re("li",{},f)),...u)))}return c}#R(e){let{contacts:t,walls:n}=this.#i,{idI:s,idJ:r,wall:a,normalForce:o,totalForce:l}=t,c=[];for(let h=0;h<s.length;h++)if(s[h]===e||a[h]<0&&r[h]===e){let u=n.find(d=>d.index===a[h])?.name,f=a[h]>=0?`wall ${u??a[h]}`:`grain ${s[h]===e?r[h]:s[h]}`;c.push([l[h],`${f}: normal force ${Bn(o[h],"N")}, force ${Bn(l[h],"N")}`])}return c.sort((h,u)=>u[0]-h[0]).map(([,h])=>h)}};function x1(i){let e=t=>{let n=i.grains.scalars.get(t);return n!==void 0&&n.some(s=>s!==n[0])};return(i.scalars.find(t=>e(t.name))??i.scalars[0])?.name??""}function y1(i,e){let t=re("img",{class:"print-only",alt:"The 3D view as it was on the screen"});i.append(t),window.addEventListener("beforeprint",()=>t.src=e.picture())}var nr=class extends Error{};async function _0(i,e){let t;try{t=await fetch(i,e?{signal:e}:{})}catch(n){throw e?.aborted?n:new nr("The server does not answer. Is `demeter view` still running?")}if(!t.ok){let n=await t.json().catch(()=>({}));throw new nr(n.error??`The server answers ${t.status}.`)}return t}async function Ed(i){return await(await _0(i)).json()}var Td=i=>Ed(`/api/state?moments=${i}`),v0=(i,e)=>Ed(`/api/grain/${i}/${e}`),x0=(i,e,t)=>Ed(`/api/history/${i}?from=${e}&count=${t}`),y0=(i,e)=>$h(`/api/series?columns=${i.join(",")}&from=${e}`),b1={f32:Float32Array,f64:Float64Array,u32:Uint32Array,i32:Int32Array},wd=class{head;bytes;#e=new Map;constructor(e){let t=new DataView(e).getUint32(0,!0);this.head=JSON.parse(new TextDecoder().decode(new Uint8Array(e,4,t))),this.bytes=e.byteLength;let n=Math.ceil((4+t)/8)*8;for(let{name:s,type:r,place:a,length:o}of this.head.arrays)this.#e.set(s,new b1[r](e,n+a,o))}floats(e){return this.#t(e)}doubles(e){return this.#t(e)}counts(e){return this.#t(e)}integers(e){return this.#t(e)}#t(e){let t=this.#e.get(e);if(!t)throw new nr(`The server does not tell ${e}.`);return t}};async function $h(i,e){return new wd(await(await _0(i,e)).arrayBuffer())}var xi=Uint8Array,w0=Uint16Array,S1=Int32Array,M1=new xi([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),w1=new xi([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),W2=new xi([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),E0=function(i,e){for(var t=new w0(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var s=new S1(t[30]),n=1;n<30;++n)for(var r=t[n];r<t[n+1];++r)s[r]=r-t[n]<<5|n;return{b:t,r:s}},T0=E0(M1,2),E1=T0.b,T1=T0.r;E1[28]=258,T1[258]=28;var A0=E0(w1,0),X2=A0.b,q2=A0.r,A1=new w0(32768);for(Pt=0;Pt<32768;++Pt)Cs=(Pt&43690)>>1|(Pt&21845)<<1,Cs=(Cs&52428)>>2|(Cs&13107)<<2,Cs=(Cs&61680)>>4|(Cs&3855)<<4,A1[Pt]=((Cs&65280)>>8|(Cs&255)<<8)>>1;var Cs,Pt;var Kh=new xi(288);for(Pt=0;Pt<144;++Pt)Kh[Pt]=8;var Pt;for(Pt=144;Pt<256;++Pt)Kh[Pt]=9;var Pt;for(Pt=256;Pt<280;++Pt)Kh[Pt]=7;var Pt;for(Pt=280;Pt<288;++Pt)Kh[Pt]=8;var Pt,C1=new xi(32);for(Pt=0;Pt<32;++Pt)C1[Pt]=5;var Pt;var R1=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new xi(i.subarray(e,t))};var P1=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],ir=function(i,e,t){var n=new Error(e||P1[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,ir),!t)throw n;return n};var I1=new xi(0);var L1=(function(){for(var i=new Int32Array(256),e=0;e<256;++e){for(var t=e,n=9;--n;)t=(t&1&&-306674912)^t>>>1;i[e]=t}return i})(),D1=function(){var i=-1;return{p:function(e){for(var t=i,n=0;n<e.length;++n)t=L1[t&255^e[n]]^t>>>8;i=t},d:function(){return~i}}};var N1=function(i,e){var t={};for(var n in i)t[n]=i[n];for(var n in e)t[n]=e[n];return t};var ln=function(i,e,t){for(;t;++e)i[e]=t,t>>>=8};var b0=typeof TextEncoder<"u"&&new TextEncoder,U1=typeof TextDecoder<"u"&&new TextDecoder,F1=0;try{U1.decode(I1,{stream:!0}),F1=1}catch{}function S0(i,e){if(e){for(var t=new xi(i.length),n=0;n<i.length;++n)t[n]=i.charCodeAt(n);return t}if(b0)return b0.encode(i);for(var s=i.length,r=new xi(i.length+(i.length>>1)),a=0,o=function(h){r[a++]=h},n=0;n<s;++n){if(a+5>r.length){var l=new xi(a+8+(s-n<<1));l.set(r),r=l}var c=i.charCodeAt(n);c<128||e?o(c):c<2048?(o(192|c>>6),o(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|i.charCodeAt(++n)&1023,o(240|c>>18),o(128|c>>12&63),o(128|c>>6&63),o(128|c&63)):(o(224|c>>12),o(128|c>>6&63),o(128|c&63))}return R1(r,0,a)}var Zh=function(i){var e=0;if(i)for(var t in i){var n=i[t].length;n>65535&&ir(9),e+=n+4}return e},M0=function(i,e,t,n,s,r,a,o){var l=n.length,c=t.extra,h=o&&o.length,u=Zh(c);ln(i,e,a!=null?33639248:67324752),e+=4,a!=null&&(i[e++]=20,i[e++]=t.os),i[e]=20,e+=2,i[e++]=t.flag<<1|(r<0&&8),i[e++]=s&&8,i[e++]=t.compression&255,i[e++]=t.compression>>8;var f=new Date(t.mtime==null?Date.now():t.mtime),d=f.getFullYear()-1980;if((d<0||d>119)&&ir(10),ln(i,e,d<<25|f.getMonth()+1<<21|f.getDate()<<16|f.getHours()<<11|f.getMinutes()<<5|f.getSeconds()>>1),e+=4,r!=-1&&(ln(i,e,t.crc),ln(i,e+4,r<0?-r-2:r),ln(i,e+8,t.size)),ln(i,e+12,l),ln(i,e+14,u),e+=16,a!=null&&(ln(i,e,h),ln(i,e+6,t.attrs),ln(i,e+10,a),e+=14),i.set(n,e),e+=l,u)for(var g in c){var b=c[g],p=b.length;ln(i,e,+g),ln(i,e+2,p),i.set(b,e+4),e+=4+p}return h&&(i.set(o,e),e+=h),e},O1=function(i,e,t,n,s){ln(i,e,101010256),ln(i,e+8,t),ln(i,e+10,t),ln(i,e+12,n),ln(i,e+16,s)},C0=(function(){function i(e){this.filename=e,this.c=D1(),this.size=0,this.compression=0}return i.prototype.process=function(e,t){this.ondata(null,e,t)},i.prototype.push=function(e,t){this.ondata||ir(5),this.c.p(e),this.size+=e.length,t&&(this.crc=this.c.d()),this.process(e,t||!1)},i})();var R0=(function(){function i(e){this.ondata=e,this.u=[],this.d=1}return i.prototype.add=function(e){var t=this;if(this.ondata||ir(5),this.d&2)this.ondata(ir(4+(this.d&1)*8,0,1),null,!1);else{var n=S0(e.filename),s=n.length,r=e.comment,a=r&&S0(r),o=s!=e.filename.length||a&&r.length!=a.length,l=s+Zh(e.extra)+30;s>65535&&this.ondata(ir(11,0,1),null,!1);var c=new xi(l);M0(c,0,e,n,o,-1);var h=[c],u=function(){for(var p=0,m=h;p<m.length;p++){var y=m[p];t.ondata(null,y,!1)}h=[]},f=this.d;this.d=0;var d=this.u.length,g=N1(e,{f:n,u:o,o:a,t:function(){e.terminate&&e.terminate()},r:function(){if(u(),f){var p=t.u[d+1];p?p.r():t.d=1}f=1}}),b=0;e.ondata=function(p,m,y){if(p)t.ondata(p,m,y),t.terminate();else if(b+=m.length,h.push(m),y){var C=new xi(16);ln(C,0,134695760),ln(C,4,e.crc),ln(C,8,b),ln(C,12,e.size),h.push(C),g.c=b,g.b=l+b+16,g.crc=e.crc,g.size=e.size,f&&g.r(),f=1}else f&&u()},this.u.push(g)}},i.prototype.end=function(){var e=this;if(this.d&2){this.ondata(ir(4+(this.d&1)*8,0,1),null,!0);return}this.d?this.e():this.u.push({r:function(){e.d&1&&(e.u.splice(-1,1),e.e())},t:function(){}}),this.d=3},i.prototype.e=function(){for(var e=0,t=0,n=0,s=0,r=this.u;s<r.length;s++){var a=r[s];n+=46+a.f.length+Zh(a.extra)+(a.o?a.o.length:0)}for(var o=new xi(n+22),l=0,c=this.u;l<c.length;l++){var a=c[l];M0(o,e,a,a.f,a.u,-a.c-2,t,a.o),e+=46+a.f.length+Zh(a.extra)+(a.o?a.o.length:0),t+=a.b}O1(o,e,this.u.length,n,t),this.ondata(null,o,!0),this.d=2},i.prototype.terminate=function(){for(var e=0,t=this.u;e<t.length;e++){var n=t[e];n.t()}this.d=2},i})();var Bd=(i,e,t)=>{if(!e.has(i))throw TypeError("Cannot "+t)},P=(i,e,t)=>(Bd(i,e,"read from private field"),t?t.call(i):e.get(i)),Ne=(i,e,t)=>{if(e.has(i))throw TypeError("Cannot add the same private member more than once");e instanceof WeakSet?e.add(i):e.set(i,t)},ht=(i,e,t,n)=>(Bd(i,e,"write to private field"),n?n.call(i,t):e.set(i,t),t),Ge=(i,e,t)=>(Bd(i,e,"access private method"),t),I0=class{constructor(i){this.value=i}},kd=class{constructor(i){this.value=i}},L0=i=>i<256?1:i<65536?2:i<1<<24?3:i<2**32?4:i<2**40?5:6,B1=i=>{if(i<127)return 1;if(i<16383)return 2;if(i<(1<<21)-1)return 3;if(i<(1<<28)-1)return 4;if(i<2**35-1)return 5;if(i<2**42-1)return 6;throw new Error("EBML VINT size not supported "+i)},Ua=(i,e,t)=>{let n=0;for(let s=e;s<t;s++){let r=Math.floor(s/8),a=i[r],o=7-(s&7),l=(a&1<<o)>>o;n<<=1,n|=l}return n},k1=(i,e,t,n)=>{for(let s=e;s<t;s++){let r=Math.floor(s/8),a=i[r],o=7-(s&7);a&=~(1<<o),a|=(n&1<<t-s-1)>>t-s-1<<o,i[r]=a}};var cu=class{},zd=class extends cu{constructor(){super(...arguments),this.buffer=null}},D0=class extends cu{constructor(i){if(super(),this.options=i,typeof i!="object")throw new TypeError("StreamTarget requires an options object to be passed to its constructor.");if(i.onData){if(typeof i.onData!="function")throw new TypeError("options.onData, when provided, must be a function.");if(i.onData.length<2)throw new TypeError("options.onData, when provided, must be a function that takes in at least two arguments (data and position). Ignoring the position argument, which specifies the byte offset at which the data is to be written, can lead to broken outputs.")}if(i.onHeader&&typeof i.onHeader!="function")throw new TypeError("options.onHeader, when provided, must be a function.");if(i.onCluster&&typeof i.onCluster!="function")throw new TypeError("options.onCluster, when provided, must be a function.");if(i.chunked!==void 0&&typeof i.chunked!="boolean")throw new TypeError("options.chunked, when provided, must be a boolean.");if(i.chunkSize!==void 0&&(!Number.isInteger(i.chunkSize)||i.chunkSize<1024))throw new TypeError("options.chunkSize, when provided, must be an integer and not smaller than 1024.")}},z1=class extends cu{constructor(i,e){if(super(),this.stream=i,this.options=e,!(i instanceof FileSystemWritableFileStream))throw new TypeError("FileSystemWritableFileStreamTarget requires a FileSystemWritableFileStream instance.");if(e!==void 0&&typeof e!="object")throw new TypeError("FileSystemWritableFileStreamTarget's options, when provided, must be an object.");if(e&&e.chunkSize!==void 0&&(!Number.isInteger(e.chunkSize)||e.chunkSize<=0))throw new TypeError("options.chunkSize, when provided, must be a positive integer")}},ar,Tt,Ad,N0,Cd,U0,Rd,F0,Jh,Pd,Id,O0,B0=class{constructor(){Ne(this,Ad),Ne(this,Cd),Ne(this,Rd),Ne(this,Jh),Ne(this,Id),this.pos=0,Ne(this,ar,new Uint8Array(8)),Ne(this,Tt,new DataView(P(this,ar).buffer)),this.offsets=new WeakMap,this.dataOffsets=new WeakMap}seek(i){this.pos=i}writeEBMLVarInt(i,e=B1(i)){let t=0;switch(e){case 1:P(this,Tt).setUint8(t++,128|i);break;case 2:P(this,Tt).setUint8(t++,64|i>>8),P(this,Tt).setUint8(t++,i);break;case 3:P(this,Tt).setUint8(t++,32|i>>16),P(this,Tt).setUint8(t++,i>>8),P(this,Tt).setUint8(t++,i);break;case 4:P(this,Tt).setUint8(t++,16|i>>24),P(this,Tt).setUint8(t++,i>>16),P(this,Tt).setUint8(t++,i>>8),P(this,Tt).setUint8(t++,i);break;case 5:P(this,Tt).setUint8(t++,8|i/2**32&7),P(this,Tt).setUint8(t++,i>>24),P(this,Tt).setUint8(t++,i>>16),P(this,Tt).setUint8(t++,i>>8),P(this,Tt).setUint8(t++,i);break;case 6:P(this,Tt).setUint8(t++,4|i/2**40&3),P(this,Tt).setUint8(t++,i/2**32|0),P(this,Tt).setUint8(t++,i>>24),P(this,Tt).setUint8(t++,i>>16),P(this,Tt).setUint8(t++,i>>8),P(this,Tt).setUint8(t++,i);break;default:throw new Error("Bad EBML VINT size "+e)}this.write(P(this,ar).subarray(0,t))}writeEBML(i){if(i!==null)if(i instanceof Uint8Array)this.write(i);else if(Array.isArray(i))for(let e of i)this.writeEBML(e);else if(this.offsets.set(i,this.pos),Ge(this,Jh,Pd).call(this,i.id),Array.isArray(i.data)){let e=this.pos,t=i.size===-1?1:i.size??4;i.size===-1?Ge(this,Ad,N0).call(this,255):this.seek(this.pos+t);let n=this.pos;if(this.dataOffsets.set(i,n),this.writeEBML(i.data),i.size!==-1){let s=this.pos-n,r=this.pos;this.seek(e),this.writeEBMLVarInt(s,t),this.seek(r)}}else if(typeof i.data=="number"){let e=i.size??L0(i.data);this.writeEBMLVarInt(e),Ge(this,Jh,Pd).call(this,i.data,e)}else typeof i.data=="string"?(this.writeEBMLVarInt(i.data.length),Ge(this,Id,O0).call(this,i.data)):i.data instanceof Uint8Array?(this.writeEBMLVarInt(i.data.byteLength,i.size),this.write(i.data)):i.data instanceof I0?(this.writeEBMLVarInt(4),Ge(this,Cd,U0).call(this,i.data.value)):i.data instanceof kd&&(this.writeEBMLVarInt(8),Ge(this,Rd,F0).call(this,i.data.value))}};ar=new WeakMap;Tt=new WeakMap;Ad=new WeakSet;N0=function(i){P(this,Tt).setUint8(0,i),this.write(P(this,ar).subarray(0,1))};Cd=new WeakSet;U0=function(i){P(this,Tt).setFloat32(0,i,!1),this.write(P(this,ar).subarray(0,4))};Rd=new WeakSet;F0=function(i){P(this,Tt).setFloat64(0,i,!1),this.write(P(this,ar))};Jh=new WeakSet;Pd=function(i,e=L0(i)){let t=0;switch(e){case 6:P(this,Tt).setUint8(t++,i/2**40|0);case 5:P(this,Tt).setUint8(t++,i/2**32|0);case 4:P(this,Tt).setUint8(t++,i>>24);case 3:P(this,Tt).setUint8(t++,i>>16);case 2:P(this,Tt).setUint8(t++,i>>8);case 1:P(this,Tt).setUint8(t++,i);break;default:throw new Error("Bad UINT size "+e)}this.write(P(this,ar).subarray(0,t))};Id=new WeakSet;O0=function(i){this.write(new Uint8Array(i.split("").map(e=>e.charCodeAt(0))))};var jh,Nr,fl,Qh,Ld,V1=class extends B0{constructor(i){super(),Ne(this,Qh),Ne(this,jh,void 0),Ne(this,Nr,new ArrayBuffer(2**16)),Ne(this,fl,new Uint8Array(P(this,Nr))),ht(this,jh,i)}write(i){Ge(this,Qh,Ld).call(this,this.pos+i.byteLength),P(this,fl).set(i,this.pos),this.pos+=i.byteLength}finalize(){Ge(this,Qh,Ld).call(this,this.pos),P(this,jh).buffer=P(this,Nr).slice(0,this.pos)}};jh=new WeakMap;Nr=new WeakMap;fl=new WeakMap;Qh=new WeakSet;Ld=function(i){let e=P(this,Nr).byteLength;for(;e<i;)e*=2;if(e===P(this,Nr).byteLength)return;let t=new ArrayBuffer(e),n=new Uint8Array(t);n.set(P(this,fl),0),ht(this,Nr,t),ht(this,fl,n)};var Fa,ss,rs,Rr,vl=class extends B0{constructor(i){super(),this.target=i,Ne(this,Fa,!1),Ne(this,ss,void 0),Ne(this,rs,void 0),Ne(this,Rr,void 0)}write(i){if(!P(this,Fa))return;let e=this.pos;if(e<P(this,rs)){if(e+i.byteLength<=P(this,rs))return;i=i.subarray(P(this,rs)-e),e=0}let t=e+i.byteLength-P(this,rs),n=P(this,ss).byteLength;for(;n<t;)n*=2;if(n!==P(this,ss).byteLength){let s=new Uint8Array(n);s.set(P(this,ss),0),ht(this,ss,s)}P(this,ss).set(i,e-P(this,rs)),ht(this,Rr,Math.max(P(this,Rr),e+i.byteLength))}startTrackingWrites(){ht(this,Fa,!0),ht(this,ss,new Uint8Array(2**10)),ht(this,rs,this.pos),ht(this,Rr,this.pos)}getTrackedWrites(){if(!P(this,Fa))throw new Error("Can't get tracked writes since nothing was tracked.");let e={data:P(this,ss).subarray(0,P(this,Rr)-P(this,rs)),start:P(this,rs),end:P(this,Rr)};return ht(this,ss,void 0),ht(this,Fa,!1),e}};Fa=new WeakMap;ss=new WeakMap;rs=new WeakMap;Rr=new WeakMap;var H1=2**24,G1=2,Pr,za,rl,tl,Is,yi,iu,Dd,Vd,k0,Hd,z0,al,su,Gd=class extends vl{constructor(i,e){super(i),Ne(this,iu),Ne(this,Vd),Ne(this,Hd),Ne(this,al),Ne(this,Pr,[]),Ne(this,za,0),Ne(this,rl,void 0),Ne(this,tl,void 0),Ne(this,Is,void 0),Ne(this,yi,[]),ht(this,rl,e),ht(this,tl,i.options?.chunked??!1),ht(this,Is,i.options?.chunkSize??H1)}write(i){super.write(i),P(this,Pr).push({data:i.slice(),start:this.pos}),this.pos+=i.byteLength}flush(){if(P(this,Pr).length===0)return;let i=[],e=[...P(this,Pr)].sort((t,n)=>t.start-n.start);i.push({start:e[0].start,size:e[0].data.byteLength});for(let t=1;t<e.length;t++){let n=i[i.length-1],s=e[t];s.start<=n.start+n.size?n.size=Math.max(n.size,s.start+s.data.byteLength-n.start):i.push({start:s.start,size:s.data.byteLength})}for(let t of i){t.data=new Uint8Array(t.size);for(let n of P(this,Pr))t.start<=n.start&&n.start<t.start+t.size&&t.data.set(n.data,n.start-t.start);if(P(this,tl))Ge(this,iu,Dd).call(this,t.data,t.start),Ge(this,al,su).call(this);else{if(P(this,rl)&&t.start<P(this,za))throw new Error("Internal error: Monotonicity violation.");this.target.options.onData?.(t.data,t.start),ht(this,za,t.start+t.data.byteLength)}}P(this,Pr).length=0}finalize(){P(this,tl)&&Ge(this,al,su).call(this,!0)}};Pr=new WeakMap;za=new WeakMap;rl=new WeakMap;tl=new WeakMap;Is=new WeakMap;yi=new WeakMap;iu=new WeakSet;Dd=function(i,e){let t=P(this,yi).findIndex(o=>o.start<=e&&e<o.start+P(this,Is));t===-1&&(t=Ge(this,Hd,z0).call(this,e));let n=P(this,yi)[t],s=e-n.start,r=i.subarray(0,Math.min(P(this,Is)-s,i.byteLength));n.data.set(r,s);let a={start:s,end:s+r.byteLength};if(Ge(this,Vd,k0).call(this,n,a),n.written[0].start===0&&n.written[0].end===P(this,Is)&&(n.shouldFlush=!0),P(this,yi).length>G1){for(let o=0;o<P(this,yi).length-1;o++)P(this,yi)[o].shouldFlush=!0;Ge(this,al,su).call(this)}r.byteLength<i.byteLength&&Ge(this,iu,Dd).call(this,i.subarray(r.byteLength),e+r.byteLength)};Vd=new WeakSet;k0=function(i,e){let t=0,n=i.written.length-1,s=-1;for(;t<=n;){let r=Math.floor(t+(n-t+1)/2);i.written[r].start<=e.start?(t=r+1,s=r):n=r-1}for(i.written.splice(s+1,0,e),(s===-1||i.written[s].end<e.start)&&s++;s<i.written.length-1&&i.written[s].end>=i.written[s+1].start;)i.written[s].end=Math.max(i.written[s].end,i.written[s+1].end),i.written.splice(s+1,1)};Hd=new WeakSet;z0=function(i){let t={start:Math.floor(i/P(this,Is))*P(this,Is),data:new Uint8Array(P(this,Is)),written:[],shouldFlush:!1};return P(this,yi).push(t),P(this,yi).sort((n,s)=>n.start-s.start),P(this,yi).indexOf(t)};al=new WeakSet;su=function(i=!1){for(let e=0;e<P(this,yi).length;e++){let t=P(this,yi)[e];if(!(!t.shouldFlush&&!i)){for(let n of t.written){if(P(this,rl)&&t.start+n.start<P(this,za))throw new Error("Internal error: Monotonicity violation.");this.target.options.onData?.(t.data.subarray(n.start,n.end),t.start+n.start),ht(this,za,t.start+n.end)}P(this,yi).splice(e--,1)}}};var W1=class extends Gd{constructor(i,e){super(new D0({onData:(t,n)=>i.stream.write({type:"write",data:t,position:n}),chunked:!0,chunkSize:i.options?.chunkSize}),e)}},Ya=1,dl=2,ru=3,X1=1,q1=2,Y1=17,$1=2**15,ol=2**13,P0="https://github.com/Vanilagy/webm-muxer",V0=6,H0=5,Z1=["strict","offset","permissive"],Qe,We,pl,ml,Ps,$a,Oa,Ur,Za,or,Va,Ha,os,xl,Ga,sr,rr,Ir,ll,cl,Wa,Xa,au,gl,hl,Nd,G0,Ud,W0,Wd,X0,Xd,q0,qd,Y0,Yd,$0,$d,Z0,hu,Zd,uu,Kd,Jd,K0,Lr,Ba,Dr,ka,Fd,J0,Od,j0,nl,eu,il,tu,jd,Q0,as,Rs,qa,_l,ul,ou,Qd,e_,lu,ep,sl,nu,t_=class{constructor(i){Ne(this,Nd),Ne(this,Ud),Ne(this,Wd),Ne(this,Xd),Ne(this,qd),Ne(this,Yd),Ne(this,$d),Ne(this,hu),Ne(this,uu),Ne(this,Jd),Ne(this,Lr),Ne(this,Dr),Ne(this,Fd),Ne(this,Od),Ne(this,nl),Ne(this,il),Ne(this,jd),Ne(this,as),Ne(this,qa),Ne(this,ul),Ne(this,Qd),Ne(this,lu),Ne(this,sl),Ne(this,Qe,void 0),Ne(this,We,void 0),Ne(this,pl,void 0),Ne(this,ml,void 0),Ne(this,Ps,void 0),Ne(this,$a,void 0),Ne(this,Oa,void 0),Ne(this,Ur,void 0),Ne(this,Za,void 0),Ne(this,or,void 0),Ne(this,Va,void 0),Ne(this,Ha,void 0),Ne(this,os,void 0),Ne(this,xl,void 0),Ne(this,Ga,0),Ne(this,sr,[]),Ne(this,rr,[]),Ne(this,Ir,[]),Ne(this,ll,void 0),Ne(this,cl,void 0),Ne(this,Wa,-1),Ne(this,Xa,-1),Ne(this,au,-1),Ne(this,gl,void 0),Ne(this,hl,!1),Ge(this,Nd,G0).call(this,i),ht(this,Qe,{type:"webm",firstTimestampBehavior:"strict",...i}),this.target=i.target;let e=!!P(this,Qe).streaming;if(i.target instanceof zd)ht(this,We,new V1(i.target));else if(i.target instanceof D0)ht(this,We,new Gd(i.target,e));else if(i.target instanceof z1)ht(this,We,new W1(i.target,e));else throw new Error(`Invalid target: ${i.target}`);Ge(this,Ud,W0).call(this)}addVideoChunk(i,e,t){if(!(i instanceof EncodedVideoChunk))throw new TypeError("addVideoChunk's first argument (chunk) must be of type EncodedVideoChunk.");if(e&&typeof e!="object")throw new TypeError("addVideoChunk's second argument (meta), when provided, must be an object.");if(t!==void 0&&(!Number.isFinite(t)||t<0))throw new TypeError("addVideoChunk's third argument (timestamp), when provided, must be a non-negative real number.");let n=new Uint8Array(i.byteLength);i.copyTo(n),this.addVideoChunkRaw(n,i.type,t??i.timestamp,e)}addVideoChunkRaw(i,e,t,n){if(!(i instanceof Uint8Array))throw new TypeError("addVideoChunkRaw's first argument (data) must be an instance of Uint8Array.");if(e!=="key"&&e!=="delta")throw new TypeError("addVideoChunkRaw's second argument (type) must be either 'key' or 'delta'.");if(!Number.isFinite(t)||t<0)throw new TypeError("addVideoChunkRaw's third argument (timestamp) must be a non-negative real number.");if(n&&typeof n!="object")throw new TypeError("addVideoChunkRaw's fourth argument (meta), when provided, must be an object.");if(Ge(this,sl,nu).call(this),!P(this,Qe).video)throw new Error("No video track declared.");P(this,ll)===void 0&&ht(this,ll,t),n&&Ge(this,Fd,J0).call(this,n);let s=Ge(this,il,tu).call(this,i,e,t,Ya);for(P(this,Qe).video.codec==="V_VP9"&&Ge(this,Od,j0).call(this,s),ht(this,Wa,s.timestamp);P(this,rr).length>0&&P(this,rr)[0].timestamp<=s.timestamp;){let r=P(this,rr).shift();Ge(this,as,Rs).call(this,r,!1)}!P(this,Qe).audio||s.timestamp<=P(this,Xa)?Ge(this,as,Rs).call(this,s,!0):P(this,sr).push(s),Ge(this,nl,eu).call(this),Ge(this,Lr,Ba).call(this)}addAudioChunk(i,e,t){if(!(i instanceof EncodedAudioChunk))throw new TypeError("addAudioChunk's first argument (chunk) must be of type EncodedAudioChunk.");if(e&&typeof e!="object")throw new TypeError("addAudioChunk's second argument (meta), when provided, must be an object.");if(t!==void 0&&(!Number.isFinite(t)||t<0))throw new TypeError("addAudioChunk's third argument (timestamp), when provided, must be a non-negative real number.");let n=new Uint8Array(i.byteLength);i.copyTo(n),this.addAudioChunkRaw(n,i.type,t??i.timestamp,e)}addAudioChunkRaw(i,e,t,n){if(!(i instanceof Uint8Array))throw new TypeError("addAudioChunkRaw's first argument (data) must be an instance of Uint8Array.");if(e!=="key"&&e!=="delta")throw new TypeError("addAudioChunkRaw's second argument (type) must be either 'key' or 'delta'.");if(!Number.isFinite(t)||t<0)throw new TypeError("addAudioChunkRaw's third argument (timestamp) must be a non-negative real number.");if(n&&typeof n!="object")throw new TypeError("addAudioChunkRaw's fourth argument (meta), when provided, must be an object.");if(Ge(this,sl,nu).call(this),!P(this,Qe).audio)throw new Error("No audio track declared.");P(this,cl)===void 0&&ht(this,cl,t),n?.decoderConfig&&(P(this,Qe).streaming?ht(this,or,Ge(this,qa,_l).call(this,n.decoderConfig.description)):Ge(this,ul,ou).call(this,P(this,or),n.decoderConfig.description));let s=Ge(this,il,tu).call(this,i,e,t,dl);for(ht(this,Xa,s.timestamp);P(this,sr).length>0&&P(this,sr)[0].timestamp<=s.timestamp;){let r=P(this,sr).shift();Ge(this,as,Rs).call(this,r,!0)}!P(this,Qe).video||s.timestamp<=P(this,Wa)?Ge(this,as,Rs).call(this,s,!P(this,Qe).video):P(this,rr).push(s),Ge(this,nl,eu).call(this),Ge(this,Lr,Ba).call(this)}addSubtitleChunk(i,e,t){if(typeof i!="object"||!i)throw new TypeError("addSubtitleChunk's first argument (chunk) must be an object.");if(!(i.body instanceof Uint8Array))throw new TypeError("body must be an instance of Uint8Array.");if(!Number.isFinite(i.timestamp)||i.timestamp<0)throw new TypeError("timestamp must be a non-negative real number.");if(!Number.isFinite(i.duration)||i.duration<0)throw new TypeError("duration must be a non-negative real number.");if(i.additions&&!(i.additions instanceof Uint8Array))throw new TypeError("additions, when present, must be an instance of Uint8Array.");if(typeof e!="object")throw new TypeError("addSubtitleChunk's second argument (meta) must be an object.");if(Ge(this,sl,nu).call(this),!P(this,Qe).subtitles)throw new Error("No subtitle track declared.");e?.decoderConfig&&(P(this,Qe).streaming?ht(this,Va,Ge(this,qa,_l).call(this,e.decoderConfig.description)):Ge(this,ul,ou).call(this,P(this,Va),e.decoderConfig.description));let n=Ge(this,il,tu).call(this,i.body,"key",t??i.timestamp,ru,i.duration,i.additions);ht(this,au,n.timestamp),P(this,Ir).push(n),Ge(this,nl,eu).call(this),Ge(this,Lr,Ba).call(this)}finalize(){if(P(this,hl))throw new Error("Cannot finalize a muxer more than once.");for(;P(this,sr).length>0;)Ge(this,as,Rs).call(this,P(this,sr).shift(),!0);for(;P(this,rr).length>0;)Ge(this,as,Rs).call(this,P(this,rr).shift(),!0);for(;P(this,Ir).length>0&&P(this,Ir)[0].timestamp<=P(this,Ga);)Ge(this,as,Rs).call(this,P(this,Ir).shift(),!1);if(P(this,os)&&Ge(this,lu,ep).call(this),P(this,We).writeEBML(P(this,Ha)),!P(this,Qe).streaming){let i=P(this,We).pos,e=P(this,We).pos-P(this,Dr,ka);P(this,We).seek(P(this,We).offsets.get(P(this,pl))+4),P(this,We).writeEBMLVarInt(e,V0),P(this,Oa).data=new kd(P(this,Ga)),P(this,We).seek(P(this,We).offsets.get(P(this,Oa))),P(this,We).writeEBML(P(this,Oa)),P(this,Ps).data[0].data[1].data=P(this,We).offsets.get(P(this,Ha))-P(this,Dr,ka),P(this,Ps).data[1].data[1].data=P(this,We).offsets.get(P(this,ml))-P(this,Dr,ka),P(this,Ps).data[2].data[1].data=P(this,We).offsets.get(P(this,$a))-P(this,Dr,ka),P(this,We).seek(P(this,We).offsets.get(P(this,Ps))),P(this,We).writeEBML(P(this,Ps)),P(this,We).seek(i)}Ge(this,Lr,Ba).call(this),P(this,We).finalize(),ht(this,hl,!0)}};Qe=new WeakMap;We=new WeakMap;pl=new WeakMap;ml=new WeakMap;Ps=new WeakMap;$a=new WeakMap;Oa=new WeakMap;Ur=new WeakMap;Za=new WeakMap;or=new WeakMap;Va=new WeakMap;Ha=new WeakMap;os=new WeakMap;xl=new WeakMap;Ga=new WeakMap;sr=new WeakMap;rr=new WeakMap;Ir=new WeakMap;ll=new WeakMap;cl=new WeakMap;Wa=new WeakMap;Xa=new WeakMap;au=new WeakMap;gl=new WeakMap;hl=new WeakMap;Nd=new WeakSet;G0=function(i){if(typeof i!="object")throw new TypeError("The muxer requires an options object to be passed to its constructor.");if(!(i.target instanceof cu))throw new TypeError("The target must be provided and an instance of Target.");if(i.video){if(typeof i.video.codec!="string")throw new TypeError(`Invalid video codec: ${i.video.codec}. Must be a string.`);if(!Number.isInteger(i.video.width)||i.video.width<=0)throw new TypeError(`Invalid video width: ${i.video.width}. Must be a positive integer.`);if(!Number.isInteger(i.video.height)||i.video.height<=0)throw new TypeError(`Invalid video height: ${i.video.height}. Must be a positive integer.`);if(i.video.frameRate!==void 0&&(!Number.isFinite(i.video.frameRate)||i.video.frameRate<=0))throw new TypeError(`Invalid video frame rate: ${i.video.frameRate}. Must be a positive number.`);if(i.video.alpha!==void 0&&typeof i.video.alpha!="boolean")throw new TypeError(`Invalid video alpha: ${i.video.alpha}. Must be a boolean.`)}if(i.audio){if(typeof i.audio.codec!="string")throw new TypeError(`Invalid audio codec: ${i.audio.codec}. Must be a string.`);if(!Number.isInteger(i.audio.numberOfChannels)||i.audio.numberOfChannels<=0)throw new TypeError(`Invalid number of audio channels: ${i.audio.numberOfChannels}. Must be a positive integer.`);if(!Number.isInteger(i.audio.sampleRate)||i.audio.sampleRate<=0)throw new TypeError(`Invalid audio sample rate: ${i.audio.sampleRate}. Must be a positive integer.`);if(i.audio.bitDepth!==void 0&&(!Number.isInteger(i.audio.bitDepth)||i.audio.bitDepth<=0))throw new TypeError(`Invalid audio bit depth: ${i.audio.bitDepth}. Must be a positive integer.`)}if(i.subtitles&&typeof i.subtitles.codec!="string")throw new TypeError(`Invalid subtitles codec: ${i.subtitles.codec}. Must be a string.`);if(i.type!==void 0&&!["webm","matroska"].includes(i.type))throw new TypeError(`Invalid type: ${i.type}. Must be 'webm' or 'matroska'.`);if(i.firstTimestampBehavior&&!Z1.includes(i.firstTimestampBehavior))throw new TypeError(`Invalid first timestamp behavior: ${i.firstTimestampBehavior}`);if(i.streaming!==void 0&&typeof i.streaming!="boolean")throw new TypeError(`Invalid streaming option: ${i.streaming}. Must be a boolean.`)};Ud=new WeakSet;W0=function(){P(this,We)instanceof vl&&P(this,We).target.options.onHeader&&P(this,We).startTrackingWrites(),Ge(this,Wd,X0).call(this),P(this,Qe).streaming||Ge(this,Yd,$0).call(this),Ge(this,$d,Z0).call(this),Ge(this,Xd,q0).call(this),Ge(this,qd,Y0).call(this),P(this,Qe).streaming||(Ge(this,hu,Zd).call(this),Ge(this,uu,Kd).call(this)),Ge(this,Jd,K0).call(this),Ge(this,Lr,Ba).call(this)};Wd=new WeakSet;X0=function(){let i={id:440786851,data:[{id:17030,data:1},{id:17143,data:1},{id:17138,data:4},{id:17139,data:8},{id:17026,data:P(this,Qe).type??"webm"},{id:17031,data:2},{id:17029,data:2}]};P(this,We).writeEBML(i)};Xd=new WeakSet;q0=function(){ht(this,Za,{id:236,size:4,data:new Uint8Array(ol)}),ht(this,or,{id:236,size:4,data:new Uint8Array(ol)}),ht(this,Va,{id:236,size:4,data:new Uint8Array(ol)})};qd=new WeakSet;Y0=function(){ht(this,Ur,{id:21936,data:[{id:21937,data:2},{id:21946,data:2},{id:21947,data:2},{id:21945,data:0}]})};Yd=new WeakSet;$0=function(){let i=new Uint8Array([28,83,187,107]),e=new Uint8Array([21,73,169,102]),t=new Uint8Array([22,84,174,107]);ht(this,Ps,{id:290298740,data:[{id:19899,data:[{id:21419,data:i},{id:21420,size:5,data:0}]},{id:19899,data:[{id:21419,data:e},{id:21420,size:5,data:0}]},{id:19899,data:[{id:21419,data:t},{id:21420,size:5,data:0}]}]})};$d=new WeakSet;Z0=function(){let i={id:17545,data:new kd(0)};ht(this,Oa,i);let e={id:357149030,data:[{id:2807729,data:1e6},{id:19840,data:P0},{id:22337,data:P0},P(this,Qe).streaming?null:i]};ht(this,ml,e)};hu=new WeakSet;Zd=function(){let i={id:374648427,data:[]};ht(this,$a,i),P(this,Qe).video&&i.data.push({id:174,data:[{id:215,data:Ya},{id:29637,data:Ya},{id:131,data:X1},{id:134,data:P(this,Qe).video.codec},P(this,Za),P(this,Qe).video.frameRate?{id:2352003,data:1e9/P(this,Qe).video.frameRate}:null,{id:224,data:[{id:176,data:P(this,Qe).video.width},{id:186,data:P(this,Qe).video.height},P(this,Qe).video.alpha?{id:21440,data:1}:null,P(this,Ur)]}]}),P(this,Qe).audio&&(ht(this,or,P(this,Qe).streaming?P(this,or)||null:{id:236,size:4,data:new Uint8Array(ol)}),i.data.push({id:174,data:[{id:215,data:dl},{id:29637,data:dl},{id:131,data:q1},{id:134,data:P(this,Qe).audio.codec},P(this,or),{id:225,data:[{id:181,data:new I0(P(this,Qe).audio.sampleRate)},{id:159,data:P(this,Qe).audio.numberOfChannels},P(this,Qe).audio.bitDepth?{id:25188,data:P(this,Qe).audio.bitDepth}:null]}]})),P(this,Qe).subtitles&&i.data.push({id:174,data:[{id:215,data:ru},{id:29637,data:ru},{id:131,data:Y1},{id:134,data:P(this,Qe).subtitles.codec},P(this,Va)]})};uu=new WeakSet;Kd=function(){let i={id:408125543,size:P(this,Qe).streaming?-1:V0,data:[P(this,Qe).streaming?null:P(this,Ps),P(this,ml),P(this,$a)]};if(ht(this,pl,i),P(this,We).writeEBML(i),P(this,We)instanceof vl&&P(this,We).target.options.onHeader){let{data:e,start:t}=P(this,We).getTrackedWrites();P(this,We).target.options.onHeader(e,t)}};Jd=new WeakSet;K0=function(){ht(this,Ha,{id:475249515,data:[]})};Lr=new WeakSet;Ba=function(){P(this,We)instanceof Gd&&P(this,We).flush()};Dr=new WeakSet;ka=function(){return P(this,We).dataOffsets.get(P(this,pl))};Fd=new WeakSet;J0=function(i){if(i.decoderConfig){if(i.decoderConfig.colorSpace){let e=i.decoderConfig.colorSpace;if(ht(this,gl,e),P(this,Ur).data=[{id:21937,data:{rgb:1,bt709:1,bt470bg:5,smpte170m:6}[e.matrix]},{id:21946,data:{bt709:1,smpte170m:6,"iec61966-2-1":13}[e.transfer]},{id:21947,data:{bt709:1,bt470bg:5,smpte170m:6}[e.primaries]},{id:21945,data:[1,2][Number(e.fullRange)]}],!P(this,Qe).streaming){let t=P(this,We).pos;P(this,We).seek(P(this,We).offsets.get(P(this,Ur))),P(this,We).writeEBML(P(this,Ur)),P(this,We).seek(t)}}i.decoderConfig.description&&(P(this,Qe).streaming?ht(this,Za,Ge(this,qa,_l).call(this,i.decoderConfig.description)):Ge(this,ul,ou).call(this,P(this,Za),i.decoderConfig.description))}};Od=new WeakSet;j0=function(i){if(i.type!=="key"||!P(this,gl))return;let e=0;if(Ua(i.data,0,2)!==2)return;e+=2;let t=(Ua(i.data,e+1,e+2)<<1)+Ua(i.data,e+0,e+1);e+=2,t===3&&e++;let n=Ua(i.data,e+0,e+1);if(e++,n)return;let s=Ua(i.data,e+0,e+1);if(e++,s!==0)return;e+=2;let r=Ua(i.data,e+0,e+24);if(e+=24,r!==4817730)return;t>=2&&e++;let a={rgb:7,bt709:2,bt470bg:1,smpte170m:3}[P(this,gl).matrix];k1(i.data,e+0,e+3,a)};nl=new WeakSet;eu=function(){let i=Math.min(P(this,Qe).video?P(this,Wa):1/0,P(this,Qe).audio?P(this,Xa):1/0),e=P(this,Ir);for(;e.length>0&&e[0].timestamp<=i;)Ge(this,as,Rs).call(this,e.shift(),!P(this,Qe).video&&!P(this,Qe).audio)};il=new WeakSet;tu=function(i,e,t,n,s,r){let a=Ge(this,jd,Q0).call(this,t,n);return{data:i,additions:r,type:e,timestamp:a,duration:s,trackNumber:n}};jd=new WeakSet;Q0=function(i,e){let t=e===Ya?P(this,Wa):e===dl?P(this,Xa):P(this,au);if(e!==ru){let n=e===Ya?P(this,ll):P(this,cl);if(P(this,Qe).firstTimestampBehavior==="strict"&&t===-1&&i!==0)throw new Error(`The first chunk for your media track must have a timestamp of 0 (received ${i}). Non-zero first timestamps are often caused by directly piping frames or audio data from a MediaStreamTrack into the encoder. Their timestamps are typically relative to the age of the document, which is probably what you want.

If you want to offset all timestamps of a track such that the first one is zero, set firstTimestampBehavior: 'offset' in the options.
If you want to allow non-zero first timestamps, set firstTimestampBehavior: 'permissive'.
`);P(this,Qe).firstTimestampBehavior==="offset"&&(i-=n)}if(i<t)throw new Error(`Timestamps must be monotonically increasing (went from ${t} to ${i}).`);if(i<0)throw new Error(`Timestamps must be non-negative (received ${i}).`);return i};as=new WeakSet;Rs=function(i,e){P(this,Qe).streaming&&!P(this,$a)&&(Ge(this,hu,Zd).call(this),Ge(this,uu,Kd).call(this));let t=Math.floor(i.timestamp/1e3),n=t-P(this,xl),s=e&&i.type==="key"&&n>=1e3,r=n>=$1;if((!P(this,os)||s||r)&&(Ge(this,Qd,e_).call(this,t),n=0),n<0)return;let a=new Uint8Array(4),o=new DataView(a.buffer);if(o.setUint8(0,128|i.trackNumber),o.setInt16(1,n,!1),i.duration===void 0&&!i.additions){o.setUint8(3,+(i.type==="key")<<7);let l={id:163,data:[a,i.data]};P(this,We).writeEBML(l)}else{let l=Math.floor(i.duration/1e3),c={id:160,data:[{id:161,data:[a,i.data]},i.duration!==void 0?{id:155,data:l}:null,i.additions?{id:30113,data:i.additions}:null]};P(this,We).writeEBML(c)}ht(this,Ga,Math.max(P(this,Ga),t))};qa=new WeakSet;_l=function(i){return{id:25506,size:4,data:new Uint8Array(i)}};ul=new WeakSet;ou=function(i,e){let t=P(this,We).pos;P(this,We).seek(P(this,We).offsets.get(i));let n=6+e.byteLength,s=ol-n;if(s<0){let r=e.byteLength+s;e instanceof ArrayBuffer?e=e.slice(0,r):e=e.buffer.slice(0,r),s=0}i=[Ge(this,qa,_l).call(this,e),{id:236,size:4,data:new Uint8Array(s)}],P(this,We).writeEBML(i),P(this,We).seek(t)};Qd=new WeakSet;e_=function(i){P(this,os)&&Ge(this,lu,ep).call(this),P(this,We)instanceof vl&&P(this,We).target.options.onCluster&&P(this,We).startTrackingWrites(),ht(this,os,{id:524531317,size:P(this,Qe).streaming?-1:H0,data:[{id:231,data:i}]}),P(this,We).writeEBML(P(this,os)),ht(this,xl,i);let e=P(this,We).offsets.get(P(this,os))-P(this,Dr,ka);P(this,Ha).data.push({id:187,data:[{id:179,data:i},P(this,Qe).video?{id:183,data:[{id:247,data:Ya},{id:241,data:e}]}:null,P(this,Qe).audio?{id:183,data:[{id:247,data:dl},{id:241,data:e}]}:null]})};lu=new WeakSet;ep=function(){if(!P(this,Qe).streaming){let i=P(this,We).pos-P(this,We).dataOffsets.get(P(this,os)),e=P(this,We).pos;P(this,We).seek(P(this,We).offsets.get(P(this,os))+4),P(this,We).writeEBMLVarInt(i,H0),P(this,We).seek(e)}if(P(this,We)instanceof vl&&P(this,We).target.options.onCluster){let{data:i,start:e}=P(this,We).getTrackedWrites();P(this,We).target.options.onCluster(i,e,P(this,xl))}};sl=new WeakSet;nu=function(){if(P(this,hl))throw new Error("Cannot add new video or audio chunks after the file has been finalized.")};var K1=/(?:(\d{2}):)?(\d{2}):(\d{2}).(\d{3})/;var $2=new TextEncoder,J1,j1,Q1,eE,tE,nE,iE,sE,rE;J1=new WeakMap;j1=new WeakMap;Q1=new WeakMap;eE=new WeakMap;tE=new WeakMap;nE=new WeakSet;iE=function(i){let e=K1.exec(i);if(!e)throw new Error("Expected match.");return 3600*1e3*Number(e[1]||"0")+60*1e3*Number(e[2])+1e3*Number(e[3])+Number(e[4])};sE=new WeakSet;rE=function(i){let e=Math.floor(i/36e5),t=Math.floor(i%(3600*1e3)/(60*1e3)),n=Math.floor(i%(60*1e3)/1e3),s=i%1e3;return e.toString().padStart(2,"0")+":"+t.toString().padStart(2,"0")+":"+n.toString().padStart(2,"0")+"."+s.toString().padStart(3,"0")};var aE=[["1280x720","1280 \xD7 720"],["1920x1080","1920 \xD7 1080"],["3840x2160","3840 \xD7 2160"],["1080x1080","1080 \xD7 1080"]],tp=16,Ka=25,fu=class{element;#e;#t=re("input",{type:"number",min:1,step:1,value:1,"aria-label":"First frame"});#r=re("input",{type:"number",min:1,step:1,value:1,"aria-label":"Last frame"});#o;#i;#n=re("p",{class:"hint export-status",role:"status"});#c=In("Stop",()=>this.#h=!0);#s;#h=!1;constructor(e){this.#e=e;let t=Ti("Size",aE,()=>{});this.#o=t.select;let n=li("Write time and colours into pictures",!0,()=>{});this.#i=n.input;let s=re("div",{class:"range-row"},"Frames ",this.#t,"to",this.#r);this.#s=[In("PNG",()=>{this.#l(()=>this.#u())}),In("PNGs (ZIP)",()=>{this.#l(()=>this.#f())})];let r=re("div",{class:"button-row"},...this.#s,this.#c);oE(...this.#m()).then(o=>{if(o){let l=In("Film (WebM)",()=>{this.#l(()=>this.#d())});this.#s.push(l),this.#c.before(l)}}),this.#c.hidden=!0;let a=re("p",{class:"hint"},"An MP4 of the pictures: ",re("code",{},n_));this.element=ji("Export",t.element,n.element,s,r,this.#n,a)}setCount(e){(this.#r.value===this.#r.max||this.#r.max==="")&&(this.#r.value=String(e)),this.#t.max=this.#r.max=String(e)}async#l(e){this.#h=!1,this.#s.forEach(n=>n.disabled=!0),this.#c.hidden=!1;let t=this.#e.index();try{this.#n.textContent=await e()}catch(n){this.#n.textContent=`Not exported: ${n.message}`}finally{this.#c.hidden=!0,this.#s.forEach(n=>n.disabled=!1),await this.#e.show(t).catch(()=>{})}}#a(){let e=this.#e.count(),t=(r,a)=>Number.isInteger(r.valueAsNumber)?Math.min(Math.max(r.valueAsNumber,1),e):a,[n,s]=[t(this.#t,1),t(this.#r,e)];if(e===0||n>s)throw new Error("choose a first frame that is not behind the last one.");return[n-1,s-1]}async#u(){let e=await this.#p(this.#e.index());return ta(await i_(e),`${this.#e.name()}_${String(this.#e.index()+1).padStart(5,"0")}.png`),"Saved."}async#f(){let[e,t]=this.#a(),n=[],s=new R0((a,o)=>{if(a)throw a;n.push(o)}),r=0;for(let a=e;a<=t&&!this.#h;a++){this.#n.textContent=`Frame ${a-e+1} of ${t-e+1} \u2026`,await this.#e.show(a);let o=new Uint8Array(await(await i_(await this.#p(a))).arrayBuffer()),l=new C0(`frame_${String(r).padStart(5,"0")}.png`);s.add(l),l.push(o,!0),r+=1}return s.end(),ta(new Blob(n,{type:"application/zip"}),`${this.#e.name()}_frames.zip`),`Saved ${r} pictures. Unpack them and run: ${n_}`}async#d(){let[e,t]=this.#a(),[n,s]=this.#m(),r=new zd,a=new t_({target:r,video:{codec:"V_VP8",width:n,height:s,frameRate:Ka}}),o=null,l=new VideoEncoder({output:(h,u)=>a.addVideoChunk(h,u),error:h=>o=h});l.configure(s_(n,s));let c=0;for(let h=e;h<=t&&!this.#h&&!o;h++){this.#n.textContent=`Frame ${h-e+1} of ${t-e+1} \u2026`,await this.#e.show(h);let u=new VideoFrame(await this.#p(h),{timestamp:c*1e6/Ka,duration:1e6/Ka});l.encode(u,{keyFrame:c%Ka===0}),u.close(),c+=1}if(await l.flush(),l.close(),o)throw o;return a.finalize(),ta(new Blob([r.buffer],{type:"video/webm"}),`${this.#e.name()}.webm`),`Saved a film of ${c} pictures.`}#m(){let[e,t]=this.#o.value.split("x").map(Number);return[e,t]}async#p(e){let[t,n]=this.#m(),s=await createImageBitmap(await this.#e.scene.screenshot({width:t,height:n})),r=document.createElement("canvas");[r.width,r.height]=[t,n];let a=r.getContext("2d");return a.fillStyle="#ffffff",a.fillRect(0,0,t,n),a.drawImage(s,0,0),s.close(),this.#i.checked&&this.#g(a,e,t,n),r}#g(e,t,n,s){let r=Math.round(s/36);e.font=`600 ${r}px system-ui, sans-serif`,e.textBaseline="middle",e.fillStyle="#1a2129";let a=s-1.2*r;e.fillText(Bn(this.#e.time(t),"s"),r,a);let o=this.#e.scene.colourScale;if(o.scalar===""||o.names)return;let[l,c]=o.range,{unit:h,factor:u}=Cr(Math.max(Math.abs(l),Math.abs(c)),this.#e.unit(o.scalar)),[f,d]=[.55*n,.25*n],g=e.createLinearGradient(f,0,f+d,0);for(let b=0;b<=tp;b++)g.addColorStop(b/tp,`rgb(${gd(o.map,b/tp).join(", ")})`);e.textAlign="right",e.fillText(`${Nn(o.scalar,h)}   ${Dn(l/u,3)}`,f-.5*r,a),e.textAlign="left",e.fillText(Dn(c/u,3),f+d+.5*r,a),e.fillStyle=g,e.fillRect(f,a-.45*r,d,.9*r)}},n_=`ffmpeg -framerate ${Ka} -i frame_%05d.png -c:v libx264 -pix_fmt yuv420p run.mp4`;function s_(i,e){return{codec:"vp8",width:i,height:e,bitrate:12e6,framerate:Ka}}async function oE(i,e){return typeof VideoEncoder<"u"&&((await VideoEncoder.isConfigSupported(s_(i,e))).supported??!1)}function i_(i){return new Promise((e,t)=>i.toBlob(n=>n?e(n):t(new Error("the browser made no picture")),"image/png"))}var lE=6e8,du=class{#e=new Map;#t=new Map;#r=new Map;#o=0;clear(){for(let{stop:e}of this.#t.values())e.abort();this.#e.clear(),this.#t.clear(),this.#r.clear(),this.#o=0}peek(e){let t=this.#e.get(e);return t&&(this.#e.delete(e),this.#e.set(e,t)),t}get(e){let t=this.peek(e);return t?Promise.resolve(t):this.#i(e)}prefetch(e){for(let t of e)this.#e.has(t)||this.#i(t).catch(()=>{})}only(e){for(let[t,{stop:n}]of this.#t)e.includes(t)||(n.abort(),this.#t.delete(t))}#i(e){let t=this.#t.get(e);if(t)return t.answer;let n=new AbortController,s=this.#n(e,n.signal).finally(()=>{this.#t.get(e)?.stop===n&&this.#t.delete(e)});return this.#t.set(e,{answer:s,stop:n}),s}async#n(e,t){let n=await $h(`/api/frame/${e}`,t),s=cE(n,await this.#c(e,String(n.head.walls)));return t.aborted||this.#s(s),s}#c(e,t){let n=this.#r.get(t);return n||(n=$h(`/api/walls/${e}`).then(hE),n.catch(()=>this.#r.delete(t)),this.#r.set(t,n)),n}#s(e){this.#e.set(e.step,e),this.#o+=e.bytes;for(let[t,n]of this.#e){if(this.#o<=lE||t===e.step)break;this.#e.delete(t),this.#o-=n.bytes}}};function cE(i,e){let t=i.head.scalars,n=i.floats("normal_force"),s=n.reduce((r,a)=>r+Math.abs(a),0);return{step:i.head.step,time:i.head.time,bytes:i.bytes,grains:{position:i.floats("position"),radius:i.floats("radius"),id:i.counts("id"),scalars:new Map(t.map(({name:r})=>[r,i.floats(r)])),categories:new Map(t.flatMap(({name:r,names:a})=>a?[[r,a]]:[]))},contacts:{idI:i.counts("id_i"),idJ:i.counts("id_j"),ends:i.floats("ends"),normalForce:n,totalForce:i.floats("total_force"),meanForce:n.length>0?s/n.length:0,wall:i.floats("wall")},walls:e,scalars:t.map(({name:r,unit:a,meaning:o})=>({name:r,unit:a,meaning:o}))}}function hE(i){let e=i.floats("triangles");return i.head.list.map(({name:n,index:s,start:r,end:a})=>({name:n,index:s,triangles:e.slice(9*r,9*a)}))}var uE="uplot",fE="u-hz",dE="u-vt",pE="u-title",mE="u-wrap",gE="u-under",_E="u-over",vE="u-axis",Br="u-off",xE="u-select",yE="u-cursor-x",bE="u-cursor-y",SE="u-cursor-pt",ME="u-legend",wE="u-live",EE="u-inline",TE="u-series",AE="u-marker",r_="u-label",CE="u-value",bl="width",Sl="height";var a_="bottom",Ja="left",np="right",xp="#000",o_=xp+"0",ip="mousemove",l_="mousedown",sp="mouseup",c_="mouseenter",h_="mouseleave",u_="dblclick",RE="resize",PE="scroll",f_="change",vu="dppxchange",yp="--",so=typeof window<"u",cp=so?document:null,Qa=so?window:null,IE=so?navigator:null,It,pu;function hp(){let i=devicePixelRatio;It!=i&&(It=i,pu&&fp(f_,pu,hp),pu=matchMedia(`(min-resolution: ${It-.001}dppx) and (max-resolution: ${It+.001}dppx)`),kr(f_,pu,hp),Qa.dispatchEvent(new CustomEvent(vu)))}function bi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function up(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Kt(i,e,t){i.style[e]=t+"px"}function Hi(i,e,t,n){let s=cp.createElement(i);return e!=null&&bi(s,e),t?.insertBefore(s,n),s}function Pi(i,e){return Hi("div",i,e)}var d_=new WeakMap;function ls(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",a=d_.get(i);r!=a&&(i.style.transform=r,d_.set(i,r),e<0||t<0||e>n||t>s?bi(i,Br):up(i,Br))}var p_=new WeakMap;function m_(i,e,t){let n=e+t,s=p_.get(i);n!=s&&(p_.set(i,n),i.style.background=e,i.style.borderColor=t)}var g_=new WeakMap;function __(i,e,t,n){let s=e+""+t,r=g_.get(i);s!=r&&(g_.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var bp={passive:!0},LE={...bp,capture:!0};function kr(i,e,t,n){e.addEventListener(i,t,n?LE:bp)}function fp(i,e,t,n){e.removeEventListener(i,t,bp)}so&&hp();function Gi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:Si((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function X_(i){return(t,n,s)=>{let r=-1,a=-1;for(let o=n;o<=s;o++)if(i(t[o])){r=o;break}for(let o=s;o>=n;o--)if(i(t[o])){a=o;break}return[r,a]}}var q_=i=>i!=null,Y_=i=>i!=null&&i>0,bu=X_(q_),DE=X_(Y_);function NE(i,e,t,n=0,s=!1){let r=s?DE:bu,a=s?Y_:q_;[e,t]=r(i,e,t);let o=i[e],l=i[e];if(e>-1)if(n==1)o=i[e],l=i[t];else if(n==-1)o=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];a(h)&&(h<o?o=h:h>l&&(l=h))}return[o??zt,l??-zt]}function Su(i,e,t,n){let s=y_(i),r=y_(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let a=t==10?Ls:$_,o=s==1?Si:Ii,l=r==1?Ii:Si,c=o(a(En(i))),h=l(a(En(e))),u=eo(t,c),f=eo(t,h);return t==10&&(c<0&&(u=Vt(u,-c)),h<0&&(f=Vt(f,-h))),n||t==2?(i=u*s,e=f*r):(i=j_(i,u),e=Mu(e,f)),[i,e]}function Sp(i,e,t,n){let s=Su(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Mp=.1,v_={mode:3,pad:Mp},wl={pad:0,soft:null,mode:0},UE={min:wl,max:wl};function xu(i,e,t,n){return wu(t)?x_(i,e,t):(wl.pad=t,wl.soft=n?0:null,wl.mode=n?3:0,x_(i,e,UE))}function At(i,e){return i??e}function FE(i,e,t){for(e=At(e,0),t=At(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function x_(i,e,t){let n=t.min,s=t.max,r=At(n.pad,0),a=At(s.pad,0),o=At(n.hard,-zt),l=At(s.hard,zt),c=At(n.soft,zt),h=At(s.soft,-zt),u=At(n.mode,0),f=At(s.mode,0),d=e-i,g=Ls(d),b=ei(En(i),En(e)),p=Ls(b),m=En(p-g);(d<1e-24||m>10)&&(d=0,(i==0||e==0)&&(d=1e-24,u==2&&c!=zt&&(r=0),f==2&&h!=-zt&&(a=0)));let y=d||b||1e3,C=Ls(y),w=eo(10,Si(C)),I=y*(d==0?i==0?.1:1:r),T=Vt(j_(i-I,w/10),24),v=i>=c&&(u==1||u==3&&T<=c||u==2&&T>=c)?c:zt,E=ei(o,T<v&&i>=v?v:Wi(v,T)),V=y*(d==0?e==0?.1:1:a),U=Vt(Mu(e+V,w/10),24),D=e<=h&&(f==1||f==3&&U>=h||f==2&&U<=h)?h:-zt,G=Wi(l,U>D&&e<=D?D:ei(D,U));return E==G&&E==0&&(G=100),[E,G]}var OE=new Intl.NumberFormat(so?IE.language:"en-US"),wp=i=>OE.format(i),Mi=Math,_u=Mi.PI,En=Mi.abs,Si=Mi.floor,wn=Mi.round,Ii=Mi.ceil,Wi=Mi.min,ei=Mi.max,eo=Mi.pow,y_=Mi.sign,Ls=Mi.log10,$_=Mi.log2,BE=(i,e=1)=>Mi.sinh(i)*e,rp=(i,e=1)=>Mi.asinh(i/e),zt=1/0;function b_(i){return(Ls((i^i>>31)-(i>>31))|0)+1}function dp(i,e,t){return Wi(ei(i,e),t)}function Z_(i){return typeof i=="function"}function Mt(i){return Z_(i)?i:()=>i}var kE=()=>{},K_=i=>i,J_=(i,e)=>e,zE=i=>null,S_=i=>!0,M_=(i,e)=>i==e,VE=/\.\d*?(?=9{6,}|0{6,})/gm,zr=i=>{if(ev(i)||cr.has(i))return i;let e=`${i}`,t=e.match(VE);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${zr(s)}e${r}`}return Vt(i,n)};function Fr(i,e){return zr(Vt(zr(i/e))*e)}function Mu(i,e){return zr(Ii(zr(i/e))*e)}function j_(i,e){return zr(Si(zr(i/e))*e)}function Vt(i,e=0){if(ev(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return wn(n)/t}var cr=new Map;function Q_(i){return((""+i).split(".")[1]||"").length}function Tl(i,e,t,n){let s=[],r=n.map(Q_);for(let a=e;a<t;a++){let o=En(a),l=Vt(eo(i,a),o);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${a}`:n[c]*l,u=(a>=0?0:o)+(a>=r[c]?0:r[c]),f=i==10?h:Vt(h,u);s.push(f),cr.set(f,u)}}return s}var El={},Ep=[],to=[null,null],lr=Array.isArray,ev=Number.isInteger,HE=i=>i===void 0;function w_(i){return typeof i=="string"}function wu(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function GE(i){return i!=null&&typeof i=="object"}var WE=Object.getPrototypeOf(Uint8Array),tv="__proto__";function no(i,e=wu){let t;if(lr(i)){let n=i.find(s=>s!=null);if(lr(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=no(i[s],e)}else t=i.slice()}else if(i instanceof WE)t=i.slice();else if(e(i)){t={};for(let n in i)n!=tv&&(t[n]=no(i[n],e))}else t=i;return t}function _n(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=tv&&(wu(i[s])?_n(i[s],no(n[s])):i[s]=no(n[s]))}return i}var XE=0,qE=1,YE=2;function $E(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let a=e[n];if(a>r){for(s=a-1;s>=0&&i[s]==null;)i[s--]=null;for(s=a+1;s<t&&i[s]==null;)i[r=s++]=null}}}function ZE(i,e){if(jE(i)){let a=i[0].slice();for(let o=1;o<i.length;o++)a.push(...i[o].slice(1));return QE(a[0])||(a=JE(a)),a}let t=new Set;for(let a=0;a<i.length;a++){let l=i[a][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((a,o)=>a-o)],s=n[0].length,r=new Map;for(let a=0;a<s;a++)r.set(n[0][a],a);for(let a=0;a<i.length;a++){let o=i[a],l=o[0];for(let c=1;c<o.length;c++){let h=o[c],u=Array(s).fill(void 0),f=e?e[a][c]:qE,d=[];for(let g=0;g<h.length;g++){let b=h[g],p=r.get(l[g]);b===null?f!=XE&&(u[p]=b,f==YE&&d.push(p)):u[p]=b}$E(u,d,s),n.push(u)}}return n}var KE=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function JE(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,a)=>e[r]-e[a]);let s=[];for(let r=0;r<i.length;r++){let a=i[r],o=Array(t);for(let l=0;l<t;l++)o[l]=a[n[l]];s.push(o)}return s}function jE(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function QE(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ei(1,Si((s-n+1)/e));for(let a=i[n],o=n+r;o<=s;o+=r){let l=i[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}var nv=["January","February","March","April","May","June","July","August","September","October","November","December"],iv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function sv(i){return i.slice(0,3)}var eT=iv.map(sv),tT=nv.map(sv),nT={MMMM:nv,MMM:tT,WWWW:iv,WWW:eT};function yl(i){return(i<10?"0":"")+i}function iT(i){return(i<10?"00":i<100?"0":"")+i}var sT={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>yl(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>yl(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>yl(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>yl(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>yl(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>iT(i.getMilliseconds())};function Tp(i,e){e=e||nT;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?sT[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<t.length;o++)a+=typeof t[o]=="string"?t[o]:t[o](r,e);return a}}var rT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function aT(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==rT?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var rv=i=>i%1==0,yu=[1,2,2.5,5],oT=Tl(10,-32,0,yu),av=Tl(10,0,32,yu),lT=av.filter(rv),Or=oT.concat(av),Ap=`
`,ov="{YYYY}",E_=Ap+ov,lv="{M}/{D}",Ml=Ap+lv,mu=Ml+"/{YY}",cv="{aa}",cT="{h}:{mm}",ja=cT+cv,T_=Ap+ja,A_=":{ss}",Dt=null;function hv(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,a=s*365,l=(i==1?Tl(10,0,3,yu).filter(rv):Tl(10,-3,0,yu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]),c=[[a,ov,Dt,Dt,Dt,Dt,Dt,Dt,1],[s*28,"{MMM}",E_,Dt,Dt,Dt,Dt,Dt,1],[s,lv,E_,Dt,Dt,Dt,Dt,Dt,1],[n,"{h}"+cv,mu,Dt,Ml,Dt,Dt,Dt,1],[t,ja,mu,Dt,Ml,Dt,Dt,Dt,1],[e,A_,mu+" "+ja,Dt,Ml+" "+ja,Dt,T_,Dt,1],[i,A_+".{fff}",mu+" "+ja,Dt,Ml+" "+ja,Dt,T_,Dt,1]];function h(u){return(f,d,g,b,p,m)=>{let y=[],C=p>=a,w=p>=r&&p<a,I=u(g),T=Vt(I*i,3),v=ap(I.getFullYear(),C?0:I.getMonth(),w||C?1:I.getDate()),E=Vt(v*i,3);if(w||C){let V=w?p/r:0,U=C?p/a:0,D=T==E?T:Vt(ap(v.getFullYear()+U,v.getMonth()+V,1)*i,3),G=new Date(wn(D/i)),W=G.getFullYear(),N=G.getMonth();for(let H=0;D<=b;H++){let K=ap(W+U*H,N+V*H,1),z=K-u(Vt(K*i,3));D=Vt((+K+z)*i,3),D<=b&&y.push(D)}}else{let V=p>=s?s:p,U=Si(g)-Si(T),D=E+U+Mu(T-E,V);y.push(D);let G=u(D),W=G.getHours()+G.getMinutes()/t+G.getSeconds()/n,N=p/n,H=f.axes[d]._space,K=m/H;for(;D=Vt(D+p,i==1?0:3),!(D>b);)if(N>1){let z=Si(Vt(W+N,6))%24,Q=u(D).getHours()-z;Q>1&&(Q=-1),D-=Q*n,W=(W+N)%24;let se=y[y.length-1];Vt((D-se)/p,3)*K>=.7&&y.push(D)}else y.push(D)}return y}}return[l,c,h]}var[hT,uT,fT]=hv(1),[dT,pT,mT]=hv(.001);Tl(2,-53,53,[1]);function C_(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function R_(i,e){return(t,n,s,r,a)=>{let o=e.find(g=>a>=g[0])||e[e.length-1],l,c,h,u,f,d;return n.map(g=>{let b=i(g),p=b.getFullYear(),m=b.getMonth(),y=b.getDate(),C=b.getHours(),w=b.getMinutes(),I=b.getSeconds(),T=p!=l&&o[2]||m!=c&&o[3]||y!=h&&o[4]||C!=u&&o[5]||w!=f&&o[6]||I!=d&&o[7]||o[1];return l=p,c=m,h=y,u=C,f=w,d=I,T(b)})}}function gT(i,e){let t=Tp(e);return(n,s,r,a,o)=>s.map(l=>t(i(l)))}function ap(i,e,t){return new Date(i,e,t)}function P_(i,e){return e(i)}var _T="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function I_(i,e){return(t,n,s,r)=>r==null?yp:e(i(n))}function vT(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function xT(i,e){return i.series[e].fill(i,e)}var yT={show:!0,live:!0,isolate:!1,mount:kE,markers:{show:!0,width:2,stroke:vT,fill:xT,dash:"solid"},idx:null,idxs:null,values:[]};function bT(i,e){let t=i.cursor.points,n=Pi(),s=t.size(i,e);Kt(n,bl,s),Kt(n,Sl,s);let r=s/-2;Kt(n,"marginLeft",r),Kt(n,"marginTop",r);let a=t.width(i,e,s);return a&&Kt(n,"borderWidth",a),n}function ST(i,e){let t=i.series[e].points;return t._fill||t._stroke}function MT(i,e){let t=i.series[e].points;return t._stroke||t._fill}function wT(i,e){return i.series[e].points.size}var op=[0,0];function ET(i,e,t){return op[0]=e,op[1]=t,op}function gu(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function lp(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var TT={show:!0,x:!0,y:!0,lock:!1,move:ET,points:{one:!1,show:bT,size:wT,width:0,stroke:MT,fill:ST},bind:{mousedown:gu,mouseup:gu,click:gu,dblclick:gu,mousemove:lp,mouseleave:lp,mouseenter:lp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},uv={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Cp=_n({},uv,{filter:J_}),fv=_n({},Cp,{size:10}),dv=_n({},uv,{show:!1}),Rp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',pv="bold "+Rp,mv=1.5,L_={show:!0,scale:"x",stroke:xp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:pv,side:2,grid:Cp,ticks:fv,border:dv,font:Rp,lineGap:mv,rotate:0},AT="Value",CT="Time",D_={show:!0,scale:"x",auto:!1,sorted:1,min:zt,max:-zt,idxs:[]};function RT(i,e,t,n,s){return e.map(r=>r==null?"":wp(r))}function PT(i,e,t,n,s,r,a){let o=[],l=cr.get(s)||0;t=a?t:Vt(Mu(t,s),l);for(let c=t;c<=n;c=Vt(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function pp(i,e,t,n,s,r,a){let o=[],l=i.scales[i.axes[e].scale].log,c=l==10?Ls:$_,h=Si(c(t));s=eo(l,h),l==10&&(s=Or[Gi(s,Or)]);let u=t,f=s*l;l==10&&(f=Or[Gi(f,Or)]);do o.push(u),u=u+s,l==10&&!cr.has(u)&&(u=Vt(u,cr.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=Or[Gi(f,Or)]));while(u<=n);return o}function IT(i,e,t,n,s,r,a){let l=i.scales[i.axes[e].scale].asinh,c=n>l?pp(i,e,ei(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?pp(i,e,ei(l,-n),-t,s):[l]).reverse().map(f=>-f).concat(h,c)}var gv=/./,LT=/[12357]/,DT=/[125]/,N_=/1/,mp=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function NT(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=i.scales[a],l=i.valToPos,c=r._space,h=l(10,a),u=l(9,a)-h>=c?gv:l(7,a)-h>=c?LT:l(5,a)-h>=c?DT:N_;if(u==N_){let f=En(l(1,a)-h);if(f<c)return mp(e.slice().reverse(),o.distr,u,Ii(c/f)).reverse()}return mp(e,o.distr,u,1)}function UT(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=r._space,l=i.valToPos,c=En(l(1,a)-l(2,a));return c<o?mp(e.slice().reverse(),3,gv,Ii(o/c)).reverse():e}function FT(i,e,t,n){return n==null?yp:e==null?"":wp(e)}var U_={show:!0,scale:"y",stroke:xp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:pv,side:3,grid:Cp,ticks:fv,border:dv,font:Rp,lineGap:mv,rotate:0};function OT(i,e){let t=3+(i||1)*2;return Vt(t*e,3)}function BT(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),a=i.valToPos(s[n[1]],t,!0),o=En(a-r),l=i.series[e],c=o/(l.points.space*It);return n[1]-n[0]<=c}var F_={scale:null,auto:!0,sorted:0,min:zt,max:-zt},_v=(i,e,t,n,s)=>s,O_={show:!0,auto:!0,sorted:0,gaps:_v,alpha:1,facets:[_n({},F_,{scale:"x"}),_n({},F_,{scale:"y"})]},B_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:_v,alpha:1,points:{show:BT,filter:null},values:null,min:zt,max:-zt,idxs:[],path:null,clip:null};function kT(i,e,t,n,s){return t/10}var vv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},zT=_n({},vv,{time:!1,ori:1}),k_={};function xv(i,e){let t=k_[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,a,o,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,a,o,l,c)}},i!=null&&(k_[i]=t)),t}var io=1,gp=2;function Vr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,a=i.scales,o=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?a[s.facets[0].scale]:a[i.series[0].scale],u=n==2?a[s.facets[1].scale]:a[s.scale],f=o.left,d=o.top,g=o.width,b=o.height,p=i.valToPosH,m=i.valToPosV;return h.ori==0?t(s,l,c,h,u,p,m,f,d,g,b,Tu,ro,Cu,bv,Mv):t(s,l,c,h,u,m,p,d,f,b,g,Au,ao,Lp,Sv,wv)}function Pp(i,e){let t=0,n=0,s=At(i.bands,Ep);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==e?t=a.dir:a.series[1]==e&&(a.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function VT(i,e,t,n,s){let r=i.mode,a=i.series[e],o=r==2?a.facets[1].scale:a.scale,l=i.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ds(i,e,t,n,s,r){return Vr(i,e,(a,o,l,c,h,u,f,d,g,b,p)=>{let m=a.pxRound,y=c.dir*(c.ori==0?1:-1),C=c.ori==0?ro:ao,w,I;y==1?(w=t,I=n):(w=n,I=t);let T=m(u(o[w],c,b,d)),v=m(f(l[w],h,p,g)),E=m(u(o[I],c,b,d)),V=m(f(r==1?h.max:h.min,h,p,g)),U=new Path2D(s);return C(U,E,V),C(U,T,V),C(U,T,v),U})}function Eu(i,e,t,n,s,r){let a=null;if(i.length>0){a=new Path2D;let o=e==0?Cu:Lp,l=t;for(let u=0;u<i.length;u++){let f=i[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&o(a,l,n,d,n+r),l=f[1]}}let c=t+s-l,h=10;c>0&&o(a,l,n-h/2,c,n+r+h)}return a}function HT(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Ip(i,e,t,n,s,r,a){let o=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,f=c;if(s==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(i[u]),g=f==u?d:r(i[f]),b=u-s;d=a<=0&&b>=0&&b<l?r(i[b]):d;let m=f+s;g=a>=0&&m>=0&&m<l?r(i[m]):g,g>=d&&o.push([d,g])}return o}function z_(i){return i==0?K_:i==1?wn:e=>Fr(e,i)}function yv(i){let e=i==0?Tu:Au,t=i==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},n=i==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,h=0)=>{c==0&&h==0?n(s,r,a,o,l):(c=Wi(c,o/2,l/2),h=Wi(h,o/2,l/2),e(s,r+c,a),t(s,r+o,a,r+o,a+l,c),t(s,r+o,a+l,r,a+l,h),t(s,r,a+l,r,a,h),t(s,r,a,r+o,a,c),s.closePath())}}var Tu=(i,e,t)=>{i.moveTo(e,t)},Au=(i,e,t)=>{i.moveTo(t,e)},ro=(i,e,t)=>{i.lineTo(e,t)},ao=(i,e,t)=>{i.lineTo(t,e)},Cu=yv(0),Lp=yv(1),bv=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Sv=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Mv=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(e,t,n,s,r,a)},wv=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(t,e,s,n,a,r)};function Ev(i){return(e,t,n,s,r)=>Vr(e,t,(a,o,l,c,h,u,f,d,g,b,p)=>{let{pxRound:m,points:y}=a,C,w;c.ori==0?(C=Tu,w=bv):(C=Au,w=Sv);let I=Vt(y.width*It,3),T=(y.size-y.width)/2*It,v=Vt(T*2,3),E=new Path2D,V=new Path2D,{left:U,top:D,width:G,height:W}=e.bbox;Cu(V,U-v,D-v,G+v*2,W+v*2);let N=H=>{if(l[H]!=null){let K=m(u(o[H],c,b,d)),z=m(f(l[H],h,p,g));C(E,K+T,z),w(E,K,z,T,0,_u*2)}};if(r)r.forEach(N);else for(let H=n;H<=s;H++)N(H);return{stroke:I>0?E:null,fill:E,clip:V,flags:io|gp}})}function Tv(i){return(e,t,n,s,r,a)=>{n!=s&&(r!=n&&a!=n&&i(e,t,n),r!=s&&a!=s&&i(e,t,s),i(e,t,a))}}var GT=Tv(ro),WT=Tv(ao);function Av(i){let e=At(i?.alignGaps,0);return(t,n,s,r)=>Vr(t,n,(a,o,l,c,h,u,f,d,g,b,p)=>{[s,r]=bu(l,s,r);let m=a.pxRound,y=W=>m(u(W,c,b,d)),C=W=>m(f(W,h,p,g)),w,I;c.ori==0?(w=ro,I=GT):(w=ao,I=WT);let T=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:io},E=v.stroke,V=!1;if(r-s>=b*4){let W=fe=>t.posToVal(fe,c.key,!0),N=null,H=null,K,z,he,J=y(o[T==1?s:r]),Q=y(o[s]),se=y(o[r]),de=W(T==1?Q+1:se-1);for(let fe=T==1?s:r;fe>=s&&fe<=r;fe+=T){let ee=o[fe],xe=(T==1?ee<de:ee>de)?J:y(ee),Ce=l[fe];xe==J?Ce!=null?(z=Ce,N==null?(w(E,xe,C(z)),K=N=H=z):z<N?N=z:z>H&&(H=z)):Ce===null&&(V=!0):(N!=null&&I(E,J,C(N),C(H),C(K),C(z)),Ce!=null?(z=Ce,w(E,xe,C(z)),N=H=K=z):(N=H=null,Ce===null&&(V=!0)),J=xe,de=W(J+T))}N!=null&&N!=H&&he!=J&&I(E,J,C(N),C(H),C(K),C(z))}else for(let W=T==1?s:r;W>=s&&W<=r;W+=T){let N=l[W];N===null?V=!0:N!=null&&w(E,y(o[W]),C(N))}let[D,G]=Pp(t,n);if(a.fill!=null||D!=0){let W=v.fill=new Path2D(E),N=a.fillTo(t,n,a.min,a.max,D),H=C(N),K=y(o[s]),z=y(o[r]);T==-1&&([z,K]=[K,z]),w(W,z,H),w(W,K,H)}if(!a.spanGaps){let W=[];V&&W.push(...Ip(o,l,s,r,T,y,e)),v.gaps=W=a.gaps(t,n,s,r,W),v.clip=Eu(W,c.ori,d,g,b,p)}return G!=0&&(v.band=G==2?[Ds(t,n,s,r,E,-1),Ds(t,n,s,r,E,1)]:Ds(t,n,s,r,E,G)),v})}function XT(i){let e=At(i.align,1),t=At(i.ascDesc,!1),n=At(i.alignGaps,0),s=At(i.extend,!1);return(r,a,o,l)=>Vr(r,a,(c,h,u,f,d,g,b,p,m,y,C)=>{[o,l]=bu(u,o,l);let w=c.pxRound,{left:I,width:T}=r.bbox,v=Q=>w(g(Q,f,y,p)),E=Q=>w(b(Q,d,C,m)),V=f.ori==0?ro:ao,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:io},D=U.stroke,G=f.dir*(f.ori==0?1:-1),W=E(u[G==1?o:l]),N=v(h[G==1?o:l]),H=N,K=N;s&&e==-1&&(K=I,V(D,K,W)),V(D,N,W);for(let Q=G==1?o:l;Q>=o&&Q<=l;Q+=G){let se=u[Q];if(se==null)continue;let de=v(h[Q]),fe=E(se);e==1?V(D,de,W):V(D,H,fe),V(D,de,fe),W=fe,H=de}let z=H;s&&e==1&&(z=I+T,V(D,z,W));let[he,J]=Pp(r,a);if(c.fill!=null||he!=0){let Q=U.fill=new Path2D(D),se=c.fillTo(r,a,c.min,c.max,he),de=E(se);V(Q,z,de),V(Q,K,de)}if(!c.spanGaps){let Q=[];Q.push(...Ip(h,u,o,l,G,v,n));let se=c.width*It/2,de=t||e==1?se:-se,fe=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=de,ee[1]+=fe}),U.gaps=Q=c.gaps(r,a,o,l,Q),U.clip=Eu(Q,f.ori,p,m,y,C)}return J!=0&&(U.band=J==2?[Ds(r,a,o,l,D,-1),Ds(r,a,o,l,D,1)]:Ds(r,a,o,l,D,J)),U})}function V_(i,e,t,n,s,r,a=zt){if(i.length>1){let o=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(o!=null){let h=En(i[l]-i[o]);h<c&&(c=h,a=En(t(i[l],n,s,r)-t(i[o],n,s,r)))}o=l}}return a}function qT(i){i=i||El;let e=At(i.size,[.6,zt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Mt(s),a=1-e[0],o=At(e[1],zt),l=At(e[2],1),c=At(i.disp,El),h=At(i.each,d=>{}),{fill:u,stroke:f}=c;return(d,g,b,p)=>Vr(d,g,(m,y,C,w,I,T,v,E,V,U,D)=>{let G=m.pxRound,W=t,N=n*It,H=o*It,K=l*It,z,he;w.ori==0?[z,he]=r(d,g):[he,z]=r(d,g);let J=w.dir*(w.ori==0?1:-1),Q=w.ori==0?Cu:Lp,se=w.ori==0?h:(Pe,Je,ct,we,kt,He,Ze)=>{h(Pe,Je,ct,kt,we,Ze,He)},de=At(d.bands,Ep).find(Pe=>Pe.series[0]==g),fe=de!=null?de.dir:0,ee=m.fillTo(d,g,m.min,m.max,fe),ge=G(v(ee,I,D,V)),xe,Ce,Me,Ye=U,lt=G(m.width*It),Xe=!1,mt=null,ft=null,at=null,Jt=null;u!=null&&(lt==0||f!=null)&&(Xe=!0,mt=u.values(d,g,b,p),ft=new Map,new Set(mt).forEach(Pe=>{Pe!=null&&ft.set(Pe,new Path2D)}),lt>0&&(at=f.values(d,g,b,p),Jt=new Map,new Set(at).forEach(Pe=>{Pe!=null&&Jt.set(Pe,new Path2D)})));let{x0:Ht,size:cn}=c;if(Ht!=null&&cn!=null){W=1,y=Ht.values(d,g,b,p),Ht.unit==2&&(y=y.map(ct=>d.posToVal(E+ct*U,w.key,!0)));let Pe=cn.values(d,g,b,p);cn.unit==2?Ce=Pe[0]*U:Ce=T(Pe[0],w,U,E)-T(0,w,U,E),Ye=V_(y,C,T,w,U,E,Ye),Me=Ye-Ce+N}else Ye=V_(y,C,T,w,U,E,Ye),Me=Ye*a+N,Ce=Ye-Me;Me<1&&(Me=0),lt>=Ce/2&&(lt=0),Me<5&&(G=K_);let Ot=Me>0,Tn=Ye-Me-(Ot?lt:0);Ce=G(dp(Tn,K,H)),xe=(W==0?Ce/2:W==J?0:Ce)-W*J*((W==0?N/2:0)+(Ot?lt/2:0));let wt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},xn=Xe?null:new Path2D,en=null;if(de!=null)en=d.data[de.series[1]];else{let{y0:Pe,y1:Je}=c;Pe!=null&&Je!=null&&(C=Je.values(d,g,b,p),en=Pe.values(d,g,b,p))}let hn=z*Ce,O=he*Ce;for(let Pe=J==1?b:p;Pe>=b&&Pe<=p;Pe+=J){let Je=C[Pe];if(Je==null)continue;if(en!=null){let q=en[Pe]??0;if(Je-q==0)continue;ge=v(q,I,D,V)}let ct=w.distr!=2||c!=null?y[Pe]:Pe,we=T(ct,w,U,E),kt=v(At(Je,ee),I,D,V),He=G(we-xe),Ze=G(ei(kt,ge)),A=G(Wi(kt,ge)),x=Ze-A;if(Je!=null){let q=Je<0?O:hn,ue=Je<0?hn:O;Xe?(lt>0&&at[Pe]!=null&&Q(Jt.get(at[Pe]),He,A+Si(lt/2),Ce,ei(0,x-lt),q,ue),mt[Pe]!=null&&Q(ft.get(mt[Pe]),He,A+Si(lt/2),Ce,ei(0,x-lt),q,ue)):Q(xn,He,A+Si(lt/2),Ce,ei(0,x-lt),q,ue),se(d,g,Pe,He-lt/2,A,Ce+lt,x)}}return lt>0?wt.stroke=Xe?Jt:xn:Xe||(wt._fill=m.width==0?m._fill:m._stroke??m._fill,wt.width=0),wt.fill=Xe?ft:xn,wt})}function YT(i,e){let t=At(e?.alignGaps,0);return(n,s,r,a)=>Vr(n,s,(o,l,c,h,u,f,d,g,b,p,m)=>{[r,a]=bu(c,r,a);let y=o.pxRound,C=z=>y(f(z,h,p,g)),w=z=>y(d(z,u,m,b)),I,T,v;h.ori==0?(I=Tu,v=ro,T=Mv):(I=Au,v=ao,T=wv);let E=h.dir*(h.ori==0?1:-1),V=C(l[E==1?r:a]),U=V,D=[],G=[];for(let z=E==1?r:a;z>=r&&z<=a;z+=E)if(c[z]!=null){let J=l[z],Q=C(J);D.push(U=Q),G.push(w(c[z]))}let W={stroke:i(D,G,I,v,T,y),fill:null,clip:null,band:null,gaps:null,flags:io},N=W.stroke,[H,K]=Pp(n,s);if(o.fill!=null||H!=0){let z=W.fill=new Path2D(N),he=o.fillTo(n,s,o.min,o.max,H),J=w(he);v(z,U,J),v(z,V,J)}if(!o.spanGaps){let z=[];z.push(...Ip(l,c,r,a,E,C,t)),W.gaps=z=o.gaps(n,s,r,a,z),W.clip=Eu(z,h.ori,g,b,p,m)}return K!=0&&(W.band=K==2?[Ds(n,s,r,a,N,-1),Ds(n,s,r,a,N,1)]:Ds(n,s,r,a,N,K)),W})}function $T(i){return YT(ZT,i)}function ZT(i,e,t,n,s,r){let a=i.length;if(a<2)return null;let o=new Path2D;if(t(o,i[0],e[0]),a==2)n(o,i[1],e[1]);else{let l=Array(a),c=Array(a-1),h=Array(a-1),u=Array(a-1);for(let f=0;f<a-1;f++)h[f]=e[f+1]-e[f],u[f]=i[f+1]-i[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<a-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[a-1]=c[a-2];for(let f=0;f<a-1;f++)s(o,i[f]+u[f]/3,e[f]+l[f]*u[f]/3,i[f+1]-u[f]/3,e[f+1]-l[f+1]*u[f]/3,i[f+1],e[f+1])}return o}var _p=new Set;function H_(){for(let i of _p)i.syncRect(!0)}so&&(kr(RE,Qa,H_),kr(PE,Qa,H_,!0),kr(vu,Qa,()=>{vn.pxRatio=It}));var KT=Av(),JT=Ev();function G_(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,a)=>vp(r,a,e,t))}function jT(i,e){return i.map((t,n)=>n==0?{}:_n({},e,t))}function vp(i,e,t,n){return _n({},e==0?t:n,i)}function Cv(i,e,t){return e==null?to:[e,t]}var QT=Cv;function eA(i,e,t){return e==null?to:xu(e,t,Mp,!0)}function Rv(i,e,t,n){return e==null?to:Su(e,t,i.scales[n].log,!1)}var tA=Rv;function Pv(i,e,t,n){return e==null?to:Sp(e,t,i.scales[n].log,!1)}var nA=Pv;function iA(i,e,t,n,s){let r=ei(b_(i),b_(e)),a=e-i,o=Gi(s/n*a,t);do{let l=t[o],c=n*l/a;if(c>=s&&r+(l<5?cr.get(l):0)<=17)return[l,c]}while(++o<t.length);return[0,0]}function W_(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=wn((t=+s)*It))+"px"),[i,e,t]}function sA(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Vt(e[2]*It,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function vn(i,e,t){let n={mode:At(i.mode,1)},s=n.mode;function r(_,S,R,L){let k=S.valToPct(_);return L+R*(S.dir==-1?1-k:k)}function a(_,S,R,L){let k=S.valToPct(_);return L+R*(S.dir==-1?k:1-k)}function o(_,S,R,L){return S.ori==0?r(_,S,R,L):a(_,S,R,L)}n.valToPosH=r,n.valToPosV=a;let l=!1;n.status=0;let c=n.root=Pi(uE);if(i.id!=null&&(c.id=i.id),bi(c,i.class),i.title){let _=Pi(pE,c);_.textContent=i.title}let h=Hi("canvas"),u=n.ctx=h.getContext("2d"),f=Pi(mE,c);kr("click",f,_=>{_.target===g&&(Xt!=Zr||jt!=Kr)&&Un.click(n,_)},!0);let d=n.under=Pi(gE,f);f.appendChild(h);let g=n.over=Pi(_E,f);i=no(i);let b=+At(i.pxAlign,1),p=z_(b);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,y=n.series=s==1?G_(i.series||[],D_,B_,!1):jT(i.series||[null],O_),C=n.axes=G_(i.axes||[],L_,U_,!0),w=n.scales={},I=n.bands=i.bands||[];I.forEach(_=>{_.fill=Mt(_.fill||null),_.dir=At(_.dir,-1)});let T=s==2?y[1].facets[0].scale:y[0].scale,v={axes:fs,series:_t},E=(i.drawOrder||["axes","series"]).map(_=>v[_]);function V(_){let S=_.distr==3?R=>Ls(R>0?R:_.clamp(n,R,_.min,_.max,_.key)):_.distr==4?R=>rp(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=S(R),{_min:k,_max:Z}=_,le=Z-k;return(L-k)/le}}function U(_){let S=w[_];if(S==null){let R=(i.scales||El)[_]||El;if(R.from!=null){U(R.from);let L=_n({},w[R.from],R,{key:_});L.valToPct=V(L),w[_]=L}else{S=w[_]=_n({},_==T?vv:zT,R),S.key=_;let L=S.time,k=S.range,Z=lr(k);if((_!=T||s==2&&!L)&&(Z&&(k[0]==null||k[1]==null)&&(k={min:k[0]==null?v_:{mode:1,hard:k[0],soft:k[0]},max:k[1]==null?v_:{mode:1,hard:k[1],soft:k[1]}},Z=!1),!Z&&wu(k))){let le=k;k=(pe,be,Ue)=>be==null?to:xu(be,Ue,le)}S.range=Mt(k||(L?QT:_==T?S.distr==3?tA:S.distr==4?nA:Cv:S.distr==3?Rv:S.distr==4?Pv:eA)),S.auto=Mt(Z?!1:S.auto),S.clamp=Mt(S.clamp||kT),S._min=S._max=null,S.valToPct=V(S)}}}U("x"),U("y"),s==1&&y.forEach(_=>{U(_.scale)}),C.forEach(_=>{U(_.scale)});for(let _ in i.scales)U(_);let D=w[T],G=D.distr,W,N;D.ori==0?(bi(c,fE),W=r,N=a):(bi(c,dE),W=a,N=r);let H={};for(let _ in w){let S=w[_];(S.min!=null||S.max!=null)&&(H[_]={min:S.min,max:S.max},S.min=S.max=null)}let K=i.tzDate||(_=>new Date(wn(_/m))),z=i.fmtDate||Tp,he=m==1?fT(K):mT(K),J=R_(K,C_(m==1?uT:pT,z)),Q=I_(K,P_(_T,z)),se=[],de=n.legend=_n({},yT,i.legend),fe=n.cursor=_n({},TT,{drag:{y:s==2}},i.cursor),ee=de.show,ge=fe.show,xe=de.markers;de.idxs=se,xe.width=Mt(xe.width),xe.dash=Mt(xe.dash),xe.stroke=Mt(xe.stroke),xe.fill=Mt(xe.fill);let Ce,Me,Ye,lt=[],Xe=[],mt,ft=!1,at={};if(de.live){let _=y[1]?y[1].values:null;ft=_!=null,mt=ft?_(n,1,0):{_:0};for(let S in mt)at[S]=yp}if(ee)if(Ce=Hi("table",ME,c),Ye=Hi("tbody",null,Ce),de.mount(n,Ce),ft){Me=Hi("thead",null,Ce,Ye);let _=Hi("tr",null,Me);Hi("th",null,_);for(var Jt in mt)Hi("th",r_,_).textContent=Jt}else bi(Ce,EE),de.live&&bi(Ce,wE);let Ht={show:!0},cn={show:!1};function Ot(_,S){if(S==0&&(ft||!de.live||s==2))return to;let R=[],L=Hi("tr",TE,Ye,Ye.childNodes[S]);bi(L,_.class),_.show||bi(L,Br);let k=Hi("th",null,L);if(xe.show){let pe=Pi(AE,k);if(S>0){let be=xe.width(n,S);be&&(pe.style.border=be+"px "+xe.dash(n,S)+" "+xe.stroke(n,S)),pe.style.background=xe.fill(n,S)}}let Z=Pi(r_,k);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,S>0&&(xe.show||(Z.style.color=_.width>0?xe.stroke(n,S):xe.fill(n,S)),wt("click",k,pe=>{if(fe._lock)return;et(pe);let be=y.indexOf(_);if((pe.ctrlKey||pe.metaKey)!=de.isolate){let Ue=y.some((Fe,Be)=>Be>0&&Be!=be&&Fe.show);y.forEach((Fe,Be)=>{Be>0&&$i(Be,Ue?Be==be?Ht:cn:Ht,!0,pn.setSeries)})}else $i(be,{show:!_.show},!0,pn.setSeries)},!1),tt&&wt(c_,k,pe=>{fe._lock||(et(pe),$i(y.indexOf(_),jr,!0,pn.setSeries))},!1));for(var le in mt){let pe=Hi("td",CE,L);pe.textContent="--",R.push(pe)}return[L,R]}let Tn=new Map;function wt(_,S,R,L=!0){let k=Tn.get(S)||{},Z=fe.bind[_](n,S,R,L);Z&&(kr(_,S,k[_]=Z),Tn.set(S,k))}function xn(_,S,R){let L=Tn.get(S)||{};for(let k in L)(_==null||k==_)&&(fp(k,S,L[k]),delete L[k]);_==null&&Tn.delete(S)}let en=0,hn=0,O=0,Pe=0,Je=0,ct=0,we=Je,kt=ct,He=O,Ze=Pe,A=0,x=0,q=0,ue=0;n.bbox={};let oe=!1,ve=!1,ye=!1,te=!1,ie=!1,me=!1;function F(_,S,R){(R||_!=n.width||S!=n.height)&&ae(_,S),dt(!1),ye=!0,ve=!0,kn()}function ae(_,S){n.width=en=O=_,n.height=hn=Pe=S,Je=ct=0,Se(),qe();let R=n.bbox;A=R.left=Fr(Je*It,.5),x=R.top=Fr(ct*It,.5),q=R.width=Fr(O*It,.5),ue=R.height=Fr(Pe*It,.5)}let ne=3;function Ee(){let _=!1,S=0;for(;!_;){S++;let R=qr(S),L=Yi(S);_=S==ne||R&&L,_||(ae(n.width,n.height),ve=!0)}}function _e({width:_,height:S}){F(_,S)}n.setSize=_e;function Se(){let _=!1,S=!1,R=!1,L=!1;C.forEach((k,Z)=>{if(k.show&&k._show){let{side:le,_size:pe}=k,be=le%2,Ue=k.label!=null?k.labelSize:0,Fe=pe+Ue;Fe>0&&(be?(O-=Fe,le==3?(Je+=Fe,L=!0):R=!0):(Pe-=Fe,le==0?(ct+=Fe,_=!0):S=!0))}}),Xi[0]=_,Xi[1]=R,Xi[2]=S,Xi[3]=L,O-=Li[1]+Li[3],Je+=Li[3],Pe-=Li[2]+Li[0],ct+=Li[0]}function qe(){let _=Je+O,S=ct+Pe,R=Je,L=ct;function k(Z,le){switch(Z){case 1:return _+=le,_-le;case 2:return S+=le,S-le;case 3:return R-=le,R+le;case 0:return L-=le,L+le}}C.forEach((Z,le)=>{if(Z.show&&Z._show){let pe=Z.side;Z._pos=k(pe,Z._size),Z.label!=null&&(Z._lpos=k(pe,Z.labelSize))}})}if(fe.dataIdx==null){let _=fe.hover,S=_.skip=new Set(_.skip??[]);S.add(void 0);let R=_.prox=Mt(_.prox),L=_.bias??=0;fe.dataIdx=(k,Z,le,pe)=>{if(Z==0)return le;let be=le,Ue=R(k,Z,le,pe)??zt,Fe=Ue>=0&&Ue<zt,Be=D.ori==0?O:Pe,ot=fe.left,Ct=e[0],Et=e[Z];if(S.has(Et[le])){be=null;let xt=null,je=null,$e;if(L==0||L==-1)for($e=le;xt==null&&$e-- >0;)S.has(Et[$e])||(xt=$e);if(L==0||L==1)for($e=le;je==null&&$e++<Et.length;)S.has(Et[$e])||(je=$e);if(xt!=null||je!=null)if(Fe){let Yt=xt==null?-1/0:W(Ct[xt],D,Be,0),sn=je==null?1/0:W(Ct[je],D,Be,0),Pn=ot-Yt,Bt=sn-ot;Pn<=Bt?Pn<=Ue&&(be=xt):Bt<=Ue&&(be=je)}else be=je==null?xt:xt==null?je:le-xt<=je-le?xt:je}else Fe&&En(ot-W(Ct[le],D,Be,0))>Ue&&(be=null);return be}}let et=_=>{fe.event=_};fe.idxs=se,fe._lock=!1;let ce=fe.points;ce.show=Mt(ce.show),ce.size=Mt(ce.size),ce.stroke=Mt(ce.stroke),ce.width=Mt(ce.width),ce.fill=Mt(ce.fill);let ke=n.focus=_n({},i.focus||{alpha:.3},fe.focus),tt=ke.prox>=0,Re=tt&&ce.one,ut=[],Wt=[],Wn=[];function lo(_,S){let R=ce.show(n,S);if(R instanceof HTMLElement)return bi(R,SE),bi(R,_.class),ls(R,-10,-10,O,Pe),g.insertBefore(R,ut[S]),R}function Gr(_,S){if(s==1||S>0){let R=s==1&&w[_.scale].time,L=_.value;_.value=R?w_(L)?I_(K,P_(L,z)):L||Q:L||FT,_.label=_.label||(R?CT:AT)}if(Re||S>0){_.width=_.width==null?1:_.width,_.paths=_.paths||KT||zE,_.fillTo=Mt(_.fillTo||VT),_.pxAlign=+At(_.pxAlign,b),_.pxRound=z_(_.pxAlign),_.stroke=Mt(_.stroke||null),_.fill=Mt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=OT(ei(1,_.width),1),L=_.points=_n({},{size:R,width:ei(1,R*.2),stroke:_.stroke,space:R*2,paths:JT,_stroke:null,_fill:null},_.points);L.show=Mt(L.show),L.filter=Mt(L.filter),L.fill=Mt(L.fill),L.stroke=Mt(L.stroke),L.paths=Mt(L.paths),L.pxAlign=_.pxAlign}if(ee){let R=Ot(_,S);lt.splice(S,0,R[0]),Xe.splice(S,0,R[1]),de.values.push(null)}if(ge){se.splice(S,0,null);let R=null;Re?S==0&&(R=lo(_,S)):S>0&&(R=lo(_,S)),ut.splice(S,0,R),Wt.splice(S,0,0),Wn.splice(S,0,0)}Rn("addSeries",S)}function Du(_,S){S=S??y.length,_=s==1?vp(_,S,D_,B_):vp(_,S,{},O_),y.splice(S,0,_),Gr(y[S],S)}n.addSeries=Du;function Pl(_){if(y.splice(_,1),ee){de.values.splice(_,1),Xe.splice(_,1);let S=lt.splice(_,1)[0];xn(null,S.firstChild),S.remove()}ge&&(se.splice(_,1),ut.splice(_,1)[0].remove(),Wt.splice(_,1),Wn.splice(_,1)),Rn("delSeries",_)}n.delSeries=Pl;let Xi=[!1,!1,!1,!1];function cs(_,S){if(_._show=_.show,_.show){let R=_.side%2,L=w[_.scale];L==null&&(_.scale=R?y[1].scale:T,L=w[_.scale]);let k=L.time;_.size=Mt(_.size),_.space=Mt(_.space),_.rotate=Mt(_.rotate),lr(_.incrs)&&_.incrs.forEach(le=>{!cr.has(le)&&cr.set(le,Q_(le))}),_.incrs=Mt(_.incrs||(L.distr==2?lT:k?m==1?hT:dT:Or)),_.splits=Mt(_.splits||(k&&L.distr==1?he:L.distr==3?pp:L.distr==4?IT:PT)),_.stroke=Mt(_.stroke),_.grid.stroke=Mt(_.grid.stroke),_.ticks.stroke=Mt(_.ticks.stroke),_.border.stroke=Mt(_.border.stroke);let Z=_.values;_.values=lr(Z)&&!lr(Z[0])?Mt(Z):k?lr(Z)?R_(K,C_(Z,z)):w_(Z)?gT(K,Z):Z||J:Z||RT,_.filter=Mt(_.filter||(L.distr>=3&&L.log==10?NT:L.distr==3&&L.log==2?UT:J_)),_.font=W_(_.font),_.labelFont=W_(_.labelFont),_._size=_.size(n,null,S,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Xi[S]=!0,_._el=Pi(vE,f))}}function hs(_,S,R,L){let[k,Z,le,pe]=R,be=S%2,Ue=0;return be==0&&(pe||Z)&&(Ue=S==0&&!k||S==2&&!le?wn(L_.size/3):0),be==1&&(k||le)&&(Ue=S==1&&!Z||S==3&&!pe?wn(U_.size/2):0),Ue}let co=n.padding=(i.padding||[hs,hs,hs,hs]).map(_=>Mt(At(_,hs))),Li=n._padding=co.map((_,S)=>_(n,S,Xi,0)),tn,an=null,on=null,qi=s==1?y[0].idxs:null,si=null,Ns=!1;function ho(_,S){if(e=_??[],n.data=n._data=e,s==2){tn=0;for(let R=1;R<y.length;R++)tn+=e[R][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),si=e[0],tn=si.length;let R=e;if(G==2){R=e.slice();let L=R[0]=Array(tn);for(let k=0;k<tn;k++)L[k]=k}n._data=e=R}if(dt(!0),Rn("setData"),G==2&&(ye=!0),S!==!1){let R=D;R.auto(n,Ns)?uo():Os(T,R.min,R.max),te=te||fe.left>=0,me=!0,kn()}}n.setData=ho;function uo(){Ns=!0;let _,S;s==1&&(tn>0?(an=qi[0]=0,on=qi[1]=tn-1,_=e[0][an],S=e[0][on],G==2?(_=an,S=on):_==S&&(G==3?[_,S]=Su(_,_,D.log,!1):G==4?[_,S]=Sp(_,_,D.log,!1):D.time?S=_+wn(86400/m):[_,S]=xu(_,S,Mp,!0))):(an=qi[0]=_=null,on=qi[1]=S=null)),Os(T,_,S)}let Wr,Us,Xr,M,B,j,Y,$,Te,Ie;function Ae(_,S,R,L,k,Z){_??=o_,R??=Ep,L??="butt",k??=o_,Z??="round",_!=Wr&&(u.strokeStyle=Wr=_),k!=Us&&(u.fillStyle=Us=k),S!=Xr&&(u.lineWidth=Xr=S),Z!=B&&(u.lineJoin=B=Z),L!=j&&(u.lineCap=j=L),R!=M&&u.setLineDash(M=R)}function Le(_,S,R,L){S!=Us&&(u.fillStyle=Us=S),_!=Y&&(u.font=Y=_),R!=$&&(u.textAlign=$=R),L!=Te&&(u.textBaseline=Te=L)}function Ve(_,S,R,L,k=0){if(L.length>0&&_.auto(n,Ns)&&(S==null||S.min==null)){let Z=At(an,0),le=At(on,L.length-1),pe=R.min==null?NE(L,Z,le,k,_.distr==3):[R.min,R.max];_.min=Wi(_.min,R.min=pe[0]),_.max=ei(_.max,R.max=pe[1])}}let st={min:null,max:null};function gt(){for(let L in w){let k=w[L];H[L]==null&&(k.min==null||H[T]!=null&&k.auto(n,Ns))&&(H[L]=st)}for(let L in w){let k=w[L];H[L]==null&&k.from!=null&&H[k.from]!=null&&(H[L]=st)}H[T]!=null&&dt(!0);let _={};for(let L in H){let k=H[L];if(k!=null){let Z=_[L]=no(w[L],GE);if(k.min!=null)_n(Z,k);else if(L!=T||s==2)if(tn==0&&Z.from==null){let le=Z.range(n,null,null,L);Z.min=le[0],Z.max=le[1]}else Z.min=zt,Z.max=-zt}}if(tn>0){y.forEach((L,k)=>{if(s==1){let Z=L.scale,le=H[Z];if(le==null)return;let pe=_[Z];if(k==0){let be=pe.range(n,pe.min,pe.max,Z);pe.min=be[0],pe.max=be[1],an=Gi(pe.min,e[0]),on=Gi(pe.max,e[0]),on-an>1&&(e[0][an]<pe.min&&an++,e[0][on]>pe.max&&on--),L.min=si[an],L.max=si[on]}else L.show&&L.auto&&Ve(pe,le,L,e[k],L.sorted);L.idxs[0]=an,L.idxs[1]=on}else if(k>0&&L.show&&L.auto){let[Z,le]=L.facets,pe=Z.scale,be=le.scale,[Ue,Fe]=e[k],Be=_[pe],ot=_[be];Be!=null&&Ve(Be,H[pe],Z,Ue,Z.sorted),ot!=null&&Ve(ot,H[be],le,Fe,le.sorted),L.min=le.min,L.max=le.max}});for(let L in _){let k=_[L],Z=H[L];if(k.from==null&&(Z==null||Z.min==null)){let le=k.range(n,k.min==zt?null:k.min,k.max==-zt?null:k.max,L);k.min=le[0],k.max=le[1]}}}for(let L in _){let k=_[L];if(k.from!=null){let Z=_[k.from];if(Z.min==null)k.min=k.max=null;else{let le=k.range(n,Z.min,Z.max,L);k.min=le[0],k.max=le[1]}}}let S={},R=!1;for(let L in _){let k=_[L],Z=w[L];if(Z.min!=k.min||Z.max!=k.max){Z.min=k.min,Z.max=k.max;let le=Z.distr;Z._min=le==3?Ls(Z.min):le==4?rp(Z.min,Z.asinh):le==100?Z.fwd(Z.min):Z.min,Z._max=le==3?Ls(Z.max):le==4?rp(Z.max,Z.asinh):le==100?Z.fwd(Z.max):Z.max,S[L]=R=!0}}if(R){y.forEach((L,k)=>{s==2?k>0&&S.y&&(L._paths=null):S[L.scale]&&(L._paths=null)});for(let L in S)ye=!0,Rn("setScale",L);ge&&fe.left>=0&&(te=me=!0)}for(let L in H)H[L]=null}function ze(_){let S=dp(an-1,0,tn-1),R=dp(on+1,0,tn-1);for(;_[S]==null&&S>0;)S--;for(;_[R]==null&&R<tn-1;)R++;return[S,R]}function _t(){if(tn>0){let _=y.some(S=>S._focus)&&Ie!=ke.alpha;_&&(u.globalAlpha=Ie=ke.alpha),y.forEach((S,R)=>{if(R>0&&S.show&&(Qt(R,!1),Qt(R,!0),S._paths==null)){let L=Ie;Ie!=S.alpha&&(u.globalAlpha=Ie=S.alpha);let k=s==2?[0,e[R][0].length-1]:ze(e[R]);S._paths=S.paths(n,R,k[0],k[1]),Ie!=L&&(u.globalAlpha=Ie=L)}}),y.forEach((S,R)=>{if(R>0&&S.show){let L=Ie;Ie!=S.alpha&&(u.globalAlpha=Ie=S.alpha),S._paths!=null&&Nt(R,!1);{let k=S._paths!=null?S._paths.gaps:null,Z=S.points.show(n,R,an,on,k),le=S.points.filter(n,R,Z,k);(Z||le)&&(S.points._paths=S.points.paths(n,R,an,on,le),Nt(R,!0))}Ie!=L&&(u.globalAlpha=Ie=L),Rn("drawSeries",R)}}),_&&(u.globalAlpha=Ie=1)}}function Qt(_,S){let R=S?y[_].points:y[_];R._stroke=R.stroke(n,_),R._fill=R.fill(n,_)}function Nt(_,S){let R=S?y[_].points:y[_],{stroke:L,fill:k,clip:Z,flags:le,_stroke:pe=R._stroke,_fill:be=R._fill,_width:Ue=R.width}=R._paths;Ue=Vt(Ue*It,3);let Fe=null,Be=Ue%2/2;S&&be==null&&(be=Ue>0?"#fff":pe);let ot=R.pxAlign==1&&Be>0;if(ot&&u.translate(Be,Be),!S){let Ct=A-Ue/2,Et=x-Ue/2,xt=q+Ue,je=ue+Ue;Fe=new Path2D,Fe.rect(Ct,Et,xt,je)}S?Oe(pe,Ue,R.dash,R.cap,be,L,k,le,Z):Ut(_,pe,Ue,R.dash,R.cap,be,L,k,le,Fe,Z),ot&&u.translate(-Be,-Be)}function Ut(_,S,R,L,k,Z,le,pe,be,Ue,Fe){let Be=!1;be!=0&&I.forEach((ot,Ct)=>{if(ot.series[0]==_){let Et=y[ot.series[1]],xt=e[ot.series[1]],je=(Et._paths||El).band;lr(je)&&(je=ot.dir==1?je[0]:je[1]);let $e,Yt=null;Et.show&&je&&FE(xt,an,on)?(Yt=ot.fill(n,Ct)||Z,$e=Et._paths.clip):je=null,Oe(S,R,L,k,Yt,le,pe,be,Ue,Fe,$e,je),Be=!0}}),Be||Oe(S,R,L,k,Z,le,pe,be,Ue,Fe)}let yn=io|gp;function Oe(_,S,R,L,k,Z,le,pe,be,Ue,Fe,Be){Ae(_,S,R,L,k),(be||Ue||Be)&&(u.save(),be&&u.clip(be),Ue&&u.clip(Ue)),Be?(pe&yn)==yn?(u.clip(Be),Fe&&u.clip(Fe),yt(k,le),un(_,Z,S)):pe&gp?(yt(k,le),u.clip(Be),un(_,Z,S)):pe&io&&(u.save(),u.clip(Be),Fe&&u.clip(Fe),yt(k,le),u.restore(),un(_,Z,S)):(yt(k,le),un(_,Z,S)),(be||Ue||Be)&&u.restore()}function un(_,S,R){R>0&&(S instanceof Map?S.forEach((L,k)=>{u.strokeStyle=Wr=k,u.stroke(L)}):S!=null&&_&&u.stroke(S))}function yt(_,S){S instanceof Map?S.forEach((R,L)=>{u.fillStyle=Us=L,u.fill(R)}):S!=null&&_&&u.fill(S)}function us(_,S,R,L){let k=C[_],Z;if(L<=0)Z=[0,0];else{let le=k._space=k.space(n,_,S,R,L),pe=k._incrs=k.incrs(n,_,S,R,L,le);Z=iA(S,R,pe,L,le)}return k._found=Z}function fn(_,S,R,L,k,Z,le,pe,be,Ue){let Fe=le%2/2;b==1&&u.translate(Fe,Fe),Ae(pe,le,be,Ue,pe),u.beginPath();let Be,ot,Ct,Et,xt=k+(L==0||L==3?-Z:Z);R==0?(ot=k,Et=xt):(Be=k,Ct=xt);for(let je=0;je<_.length;je++)S[je]!=null&&(R==0?Be=Ct=_[je]:ot=Et=_[je],u.moveTo(Be,ot),u.lineTo(Ct,Et));u.stroke(),b==1&&u.translate(-Fe,-Fe)}function qr(_){let S=!0;return C.forEach((R,L)=>{if(!R.show)return;let k=w[R.scale];if(k.min==null){R._show&&(S=!1,R._show=!1,dt(!1));return}else R._show||(S=!1,R._show=!0,dt(!1));let Z=R.side,le=Z%2,{min:pe,max:be}=k,[Ue,Fe]=us(L,pe,be,le==0?O:Pe);if(Fe==0)return;let Be=k.distr==2,ot=R._splits=R.splits(n,L,pe,be,Ue,Fe,Be),Ct=k.distr==2?ot.map($e=>si[$e]):ot,Et=k.distr==2?si[ot[1]]-si[ot[0]]:Ue,xt=R._values=R.values(n,R.filter(n,Ct,L,Fe,Et),L,Fe,Et);R._rotate=Z==2?R.rotate(n,xt,L,Fe):0;let je=R._size;R._size=Ii(R.size(n,xt,L,_)),je!=null&&R._size!=je&&(S=!1)}),S}function Yi(_){let S=!0;return co.forEach((R,L)=>{let k=R(n,L,Xi,_);k!=Li[L]&&(S=!1),Li[L]=k}),S}function fs(){for(let _=0;_<C.length;_++){let S=C[_];if(!S.show||!S._show)continue;let R=S.side,L=R%2,k,Z,le=S.stroke(n,_),pe=R==0||R==3?-1:1,[be,Ue]=S._found;if(S.label!=null){let Yn=S.labelGap*pe,oi=wn((S._lpos+Yn)*It);Le(S.labelFont[0],le,"center",R==2?"top":a_),u.save(),L==1?(k=Z=0,u.translate(oi,wn(x+ue/2)),u.rotate((R==3?-_u:_u)/2)):(k=wn(A+q/2),Z=oi);let fr=Z_(S.label)?S.label(n,_,be,Ue):S.label;u.fillText(fr,k,Z),u.restore()}if(Ue==0)continue;let Fe=w[S.scale],Be=L==0?q:ue,ot=L==0?A:x,Ct=S._splits,Et=Fe.distr==2?Ct.map(Yn=>si[Yn]):Ct,xt=Fe.distr==2?si[Ct[1]]-si[Ct[0]]:be,je=S.ticks,$e=S.border,Yt=je.show?je.size:0,sn=wn(Yt*It),Pn=wn((S.alignTo==2?S._size-Yt-S.gap:S.gap)*It),Bt=S._rotate*-_u/180,rn=p(S._pos*It),ri=(sn+Pn)*pe,qn=rn+ri;Z=L==0?qn:0,k=L==1?qn:0;let wi=S.font[0],Di=S.align==1?Ja:S.align==2?np:Bt>0?Ja:Bt<0?np:L==0?"center":R==3?np:Ja,Ki=Bt||L==1?"middle":R==2?"top":a_;Le(wi,le,Di,Ki);let ai=S.font[1]*S.lineGap,Ei=Ct.map(Yn=>p(o(Yn,Fe,Be,ot))),Ni=S._values;for(let Yn=0;Yn<Ni.length;Yn++){let oi=Ni[Yn];if(oi!=null){L==0?k=Ei[Yn]:Z=Ei[Yn],oi=""+oi;let fr=oi.indexOf(`
`)==-1?[oi]:oi.split(/\n/gm);for(let $n=0;$n<fr.length;$n++){let Qp=fr[$n];Bt?(u.save(),u.translate(k,Z+$n*ai),u.rotate(Bt),u.fillText(Qp,0,0),u.restore()):u.fillText(Qp,k,Z+$n*ai)}}}je.show&&fn(Ei,je.filter(n,Et,_,Ue,xt),L,R,rn,sn,Vt(je.width*It,3),je.stroke(n,_),je.dash,je.cap);let Ji=S.grid;Ji.show&&fn(Ei,Ji.filter(n,Et,_,Ue,xt),L,L==0?2:1,L==0?x:A,L==0?ue:q,Vt(Ji.width*It,3),Ji.stroke(n,_),Ji.dash,Ji.cap),$e.show&&fn([rn],[1],L==0?1:0,L==0?1:2,L==1?x:A,L==1?ue:q,Vt($e.width*It,3),$e.stroke(n,_),$e.dash,$e.cap)}Rn("drawAxes")}function dt(_){y.forEach((S,R)=>{R>0&&(S._paths=null,_&&(s==1?(S.min=null,S.max=null):S.facets.forEach(L=>{L.min=null,L.max=null})))})}let nn=!1,Xn=!1,Ft=[];function dn(){Xn=!1;for(let _=0;_<Ft.length;_++)Rn(...Ft[_]);Ft.length=0}function kn(){nn||(KE(Up),nn=!0)}function Il(_,S=!1){nn=!0,Xn=S,_(n),Up(),S&&Ft.length>0&&queueMicrotask(dn)}n.batch=Il;function Up(){if(oe&&(gt(),oe=!1),ye&&(Ee(),ye=!1),ve){if(Kt(d,Ja,Je),Kt(d,"top",ct),Kt(d,bl,O),Kt(d,Sl,Pe),Kt(g,Ja,Je),Kt(g,"top",ct),Kt(g,bl,O),Kt(g,Sl,Pe),Kt(f,bl,en),Kt(f,Sl,hn),h.width=wn(en*It),h.height=wn(hn*It),C.forEach(({_el:_,_show:S,_size:R,_pos:L,side:k})=>{if(_!=null)if(S){let Z=k===3||k===0?R:0,le=k%2==1;Kt(_,le?"left":"top",L-Z),Kt(_,le?"width":"height",R),Kt(_,le?"top":"left",le?ct:Je),Kt(_,le?"height":"width",le?Pe:O),up(_,Br)}else bi(_,Br)}),Wr=Us=Xr=B=j=Y=$=Te=M=null,Ie=1,mo(!0),Je!=we||ct!=kt||O!=He||Pe!=Ze){dt(!1);let _=O/He,S=Pe/Ze;if(ge&&!te&&fe.left>=0){fe.left*=_,fe.top*=S,Yr&&ls(Yr,wn(fe.left),0,O,Pe),$r&&ls($r,0,wn(fe.top),O,Pe);for(let R=0;R<ut.length;R++){let L=ut[R];L!=null&&(Wt[R]*=_,Wn[R]*=S,ls(L,Ii(Wt[R]),Ii(Wn[R]),O,Pe))}}if(qt.show&&!ie&&qt.left>=0&&qt.width>0){qt.left*=_,qt.width*=_,qt.top*=S,qt.height*=S;for(let R in ku)Kt(Jr,R,qt[R])}we=Je,kt=ct,He=O,Ze=Pe}Rn("setSize"),ve=!1}en>0&&hn>0&&(u.clearRect(0,0,h.width,h.height),Rn("drawClear"),E.forEach(_=>_()),Rn("draw")),qt.show&&ie&&(Ll(qt),ie=!1),ge&&te&&(ur(null,!0,!1),te=!1),de.show&&de.live&&me&&(Ou(),me=!1),l||(l=!0,n.status=1,Rn("ready")),Ns=!1,nn=!1}n.redraw=(_,S)=>{ye=S||!1,_!==!1?Os(T,D.min,D.max):kn()};function Nu(_,S){let R=w[_];if(R.from==null){if(tn==0){let L=R.range(n,S.min,S.max,_);S.min=L[0],S.max=L[1]}if(S.min>S.max){let L=S.min;S.min=S.max,S.max=L}if(tn>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;_==T&&R.distr==2&&tn>0&&(S.min=Gi(S.min,e[0]),S.max=Gi(S.max,e[0]),S.min==S.max&&S.max++),H[_]=S,oe=!0,kn()}}n.setScale=Nu;let Uu,Fu,Yr,$r,Fp,Op,Zr,Kr,Bp,kp,Xt,jt,Fs=!1,Un=fe.drag,An=Un.x,Cn=Un.y;ge&&(fe.x&&(Uu=Pi(yE,g)),fe.y&&(Fu=Pi(bE,g)),D.ori==0?(Yr=Uu,$r=Fu):(Yr=Fu,$r=Uu),Xt=fe.left,jt=fe.top);let qt=n.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Jr=qt.show?Pi(xE,qt.over?g:d):null;function Ll(_,S){if(qt.show){for(let R in _)qt[R]=_[R],R in ku&&Kt(Jr,R,_[R]);S!==!1&&Rn("setSelect")}}n.setSelect=Ll;function Jv(_){if(y[_].show)ee&&up(lt[_],Br);else if(ee&&bi(lt[_],Br),ge){let R=Re?ut[0]:ut[_];R!=null&&ls(R,-10,-10,O,Pe)}}function Os(_,S,R){Nu(_,{min:S,max:R})}function $i(_,S,R,L){S.focus!=null&&nx(_),S.show!=null&&y.forEach((k,Z)=>{Z>0&&(_==Z||_==null)&&(k.show=S.show,Jv(Z),s==2?(Os(k.facets[0].scale,null,null),Os(k.facets[1].scale,null,null)):Os(k.scale,null,null),kn())}),R!==!1&&Rn("setSeries",_,S),L&&go("setSeries",n,_,S)}n.setSeries=$i;function jv(_,S){_n(I[_],S)}function Qv(_,S){_.fill=Mt(_.fill||null),_.dir=At(_.dir,-1),S=S??I.length,I.splice(S,0,_)}function ex(_){_==null?I.length=0:I.splice(_,1)}n.addBand=Qv,n.setBand=jv,n.delBand=ex;function tx(_,S){y[_].alpha=S,ge&&ut[_]!=null&&(ut[_].style.opacity=S),ee&&lt[_]&&(lt[_].style.opacity=S)}let ds,Bs,hr,jr={focus:!0};function nx(_){if(_!=hr){let S=_==null,R=ke.alpha!=1;y.forEach((L,k)=>{if(s==1||k>0){let Z=S||k==0||k==_;L._focus=S?null:Z,R&&tx(k,Z?1:ke.alpha)}}),hr=_,R&&kn()}}ee&&tt&&wt(h_,Ce,_=>{fe._lock||(et(_),hr!=null&&$i(null,jr,!0,pn.setSeries))});function Zi(_,S,R){let L=w[S];R&&(_=_/It-(L.ori==1?ct:Je));let k=O;L.ori==1&&(k=Pe,_=k-_),L.dir==-1&&(_=k-_);let Z=L._min,le=L._max,pe=_/k,be=Z+(le-Z)*pe,Ue=L.distr;return Ue==3?eo(10,be):Ue==4?BE(be,L.asinh):Ue==100?L.bwd(be):be}function ix(_,S){let R=Zi(_,T,S);return Gi(R,e[0],an,on)}n.valToIdx=_=>Gi(_,e[0]),n.posToIdx=ix,n.posToVal=Zi,n.valToPos=(_,S,R)=>w[S].ori==0?r(_,w[S],R?q:O,R?A:0):a(_,w[S],R?ue:Pe,R?x:0),n.setCursor=(_,S,R)=>{Xt=_.left,jt=_.top,ur(null,S,R)};function zp(_,S){Kt(Jr,Ja,qt.left=_),Kt(Jr,bl,qt.width=S)}function Vp(_,S){Kt(Jr,"top",qt.top=_),Kt(Jr,Sl,qt.height=S)}let fo=D.ori==0?zp:Vp,po=D.ori==1?zp:Vp;function sx(){if(ee&&de.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&ft)continue;let S=de.values[_],R=0;for(let L in S)Xe[_][R++].firstChild.nodeValue=S[L]}}function Ou(_,S){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{se[L]=R}):HE(_.idx)||se.fill(_.idx),de.idx=se[0]),ee&&de.live){for(let R=0;R<y.length;R++)(R>0||s==1&&!ft)&&rx(R,se[R]);sx()}me=!1,S!==!1&&Rn("setLegend")}n.setLegend=Ou;function rx(_,S){let R=y[_],L=_==0&&G==2?si:e[_],k;ft?k=R.values(n,_,S)??at:(k=R.value(n,S==null?null:L[S],_,S),k=k==null?at:{_:k}),de.values[_]=k}function ur(_,S,R){Bp=Xt,kp=jt,[Xt,jt]=fe.move(n,Xt,jt),fe.left=Xt,fe.top=jt,ge&&(Yr&&ls(Yr,wn(Xt),0,O,Pe),$r&&ls($r,0,wn(jt),O,Pe));let L,k=an>on;ds=zt,Bs=null;let Z=D.ori==0?O:Pe,le=D.ori==1?O:Pe;if(Xt<0||tn==0||k){L=fe.idx=null;for(let pe=0;pe<y.length;pe++){let be=ut[pe];be!=null&&ls(be,-10,-10,O,Pe)}tt&&$i(null,jr,!0,_==null&&pn.setSeries),de.live&&(se.fill(L),me=!0)}else{let pe,be,Ue;s==1&&(pe=D.ori==0?Xt:jt,be=Zi(pe,T),L=fe.idx=Gi(be,e[0],an,on),Ue=W(e[0][L],D,Z,0));let Fe=-10,Be=-10,ot=0,Ct=0,Et=!0,xt="",je="";for(let $e=s==2?1:0;$e<y.length;$e++){let Yt=y[$e],sn=se[$e],Pn=sn==null?null:s==1?e[$e][sn]:e[$e][1][sn],Bt=fe.dataIdx(n,$e,L,be),rn=Bt==null?null:s==1?e[$e][Bt]:e[$e][1][Bt];if(me=me||rn!=Pn||Bt!=sn,se[$e]=Bt,$e>0&&Yt.show){let ri=Bt==null?-10:Bt==L?Ue:W(s==1?e[0][Bt]:e[$e][0][Bt],D,Z,0),qn=rn==null?-10:N(rn,s==1?w[Yt.scale]:w[Yt.facets[1].scale],le,0);if(tt&&rn!=null){let wi=D.ori==1?Xt:jt,Di=En(ke.dist(n,$e,Bt,qn,wi));if(Di<ds){let Ki=ke.bias;if(Ki!=0){let ai=Zi(wi,Yt.scale),Ei=rn>=0?1:-1,Ni=ai>=0?1:-1;Ni==Ei&&(Ni==1?Ki==1?rn>=ai:rn<=ai:Ki==1?rn<=ai:rn>=ai)&&(ds=Di,Bs=$e)}else ds=Di,Bs=$e}}if(me||Re){let wi,Di;D.ori==0?(wi=ri,Di=qn):(wi=qn,Di=ri);let Ki,ai,Ei,Ni,Ji,Yn,oi=!0,fr=ce.bbox;if(fr!=null){oi=!1;let $n=fr(n,$e);Ei=$n.left,Ni=$n.top,Ki=$n.width,ai=$n.height}else Ei=wi,Ni=Di,Ki=ai=ce.size(n,$e);if(Yn=ce.fill(n,$e),Ji=ce.stroke(n,$e),Re)$e==Bs&&ds<=ke.prox&&(Fe=Ei,Be=Ni,ot=Ki,Ct=ai,Et=oi,xt=Yn,je=Ji);else{let $n=ut[$e];$n!=null&&(Wt[$e]=Ei,Wn[$e]=Ni,__($n,Ki,ai,oi),m_($n,Yn,Ji),ls($n,Ii(Ei),Ii(Ni),O,Pe))}}}}if(Re){let $e=ke.prox,Yt=hr==null?ds<=$e:ds>$e||Bs!=hr;if(me||Yt){let sn=ut[0];sn!=null&&(Wt[0]=Fe,Wn[0]=Be,__(sn,ot,Ct,Et),m_(sn,xt,je),ls(sn,Ii(Fe),Ii(Be),O,Pe))}}}if(qt.show&&Fs)if(_!=null){let[pe,be]=pn.scales,[Ue,Fe]=pn.match,[Be,ot]=_.cursor.sync.scales,Ct=_.cursor.drag;if(An=Ct._x,Cn=Ct._y,An||Cn){let{left:Et,top:xt,width:je,height:$e}=_.select,Yt=_.scales[Be].ori,sn=_.posToVal,Pn,Bt,rn,ri,qn,wi=pe!=null&&Ue(pe,Be),Di=be!=null&&Fe(be,ot);wi&&An?(Yt==0?(Pn=Et,Bt=je):(Pn=xt,Bt=$e),rn=w[pe],ri=W(sn(Pn,Be),rn,Z,0),qn=W(sn(Pn+Bt,Be),rn,Z,0),fo(Wi(ri,qn),En(qn-ri))):fo(0,Z),Di&&Cn?(Yt==1?(Pn=Et,Bt=je):(Pn=xt,Bt=$e),rn=w[be],ri=N(sn(Pn,ot),rn,le,0),qn=N(sn(Pn+Bt,ot),rn,le,0),po(Wi(ri,qn),En(qn-ri))):po(0,le)}else zu()}else{let pe=En(Bp-Fp),be=En(kp-Op);if(D.ori==1){let ot=pe;pe=be,be=ot}An=Un.x&&pe>=Un.dist,Cn=Un.y&&be>=Un.dist;let Ue=Un.uni;Ue!=null?An&&Cn&&(An=pe>=Ue,Cn=be>=Ue,!An&&!Cn&&(be>pe?Cn=!0:An=!0)):Un.x&&Un.y&&(An||Cn)&&(An=Cn=!0);let Fe,Be;An&&(D.ori==0?(Fe=Zr,Be=Xt):(Fe=Kr,Be=jt),fo(Wi(Fe,Be),En(Be-Fe)),Cn||po(0,le)),Cn&&(D.ori==1?(Fe=Zr,Be=Xt):(Fe=Kr,Be=jt),po(Wi(Fe,Be),En(Be-Fe)),An||fo(0,Z)),!An&&!Cn&&(fo(0,0),po(0,0))}if(Un._x=An,Un._y=Cn,_==null){if(R){if(jp!=null){let[pe,be]=pn.scales;pn.values[0]=pe!=null?Zi(D.ori==0?Xt:jt,pe):null,pn.values[1]=be!=null?Zi(D.ori==1?Xt:jt,be):null}go(ip,n,Xt,jt,O,Pe,L)}if(tt){let pe=R&&pn.setSeries,be=ke.prox;hr==null?ds<=be&&$i(Bs,jr,!0,pe):ds>be?$i(null,jr,!0,pe):Bs!=hr&&$i(Bs,jr,!0,pe)}}me&&(de.idx=L,Ou()),S!==!1&&Rn("setCursor")}let ks=null;Object.defineProperty(n,"rect",{get(){return ks==null&&mo(!1),ks}});function mo(_=!1){_?ks=null:(ks=g.getBoundingClientRect(),Rn("syncRect",ks))}function Hp(_,S,R,L,k,Z,le){fe._lock||Fs&&_!=null&&_.movementX==0&&_.movementY==0||(Bu(_,S,R,L,k,Z,le,!1,_!=null),_!=null?ur(null,!0,!0):ur(S,!0,!1))}function Bu(_,S,R,L,k,Z,le,pe,be){if(ks==null&&mo(!1),et(_),_!=null)R=_.clientX-ks.left,L=_.clientY-ks.top;else{if(R<0||L<0){Xt=-10,jt=-10;return}let[Ue,Fe]=pn.scales,Be=S.cursor.sync,[ot,Ct]=Be.values,[Et,xt]=Be.scales,[je,$e]=pn.match,Yt=S.axes[0].side%2==1,sn=D.ori==0?O:Pe,Pn=D.ori==1?O:Pe,Bt=Yt?Z:k,rn=Yt?k:Z,ri=Yt?L:R,qn=Yt?R:L;if(Et!=null?R=je(Ue,Et)?o(ot,w[Ue],sn,0):-10:R=sn*(ri/Bt),xt!=null?L=$e(Fe,xt)?o(Ct,w[Fe],Pn,0):-10:L=Pn*(qn/rn),D.ori==1){let wi=R;R=L,L=wi}}be&&(S==null||S.cursor.event.type==ip)&&((R<=1||R>=O-1)&&(R=Fr(R,O)),(L<=1||L>=Pe-1)&&(L=Fr(L,Pe))),pe?(Fp=R,Op=L,[Zr,Kr]=fe.move(n,R,L)):(Xt=R,jt=L)}let ku={width:0,height:0,left:0,top:0};function zu(){Ll(ku,!1)}let Gp,Wp,Xp,qp;function Yp(_,S,R,L,k,Z,le){Fs=!0,An=Cn=Un._x=Un._y=!1,Bu(_,S,R,L,k,Z,le,!0,!1),_!=null&&(wt(sp,cp,$p,!1),go(l_,n,Zr,Kr,O,Pe,null));let{left:pe,top:be,width:Ue,height:Fe}=qt;Gp=pe,Wp=be,Xp=Ue,qp=Fe}function $p(_,S,R,L,k,Z,le){Fs=Un._x=Un._y=!1,Bu(_,S,R,L,k,Z,le,!1,!0);let{left:pe,top:be,width:Ue,height:Fe}=qt,Be=Ue>0||Fe>0,ot=Gp!=pe||Wp!=be||Xp!=Ue||qp!=Fe;if(Be&&ot&&Ll(qt),Un.setScale&&Be&&ot){let Ct=pe,Et=Ue,xt=be,je=Fe;if(D.ori==1&&(Ct=be,Et=Fe,xt=pe,je=Ue),An&&Os(T,Zi(Ct,T),Zi(Ct+Et,T)),Cn)for(let $e in w){let Yt=w[$e];$e!=T&&Yt.from==null&&Yt.min!=zt&&Os($e,Zi(xt+je,$e),Zi(xt,$e))}zu()}else fe.lock&&(fe._lock=!fe._lock,ur(S,!0,_!=null));_!=null&&(xn(sp,cp),go(sp,n,Xt,jt,O,Pe,null))}function ax(_,S,R,L,k,Z,le){if(fe._lock)return;et(_);let pe=Fs;if(Fs){let be=!0,Ue=!0,Fe=10,Be,ot;D.ori==0?(Be=An,ot=Cn):(Be=Cn,ot=An),Be&&ot&&(be=Xt<=Fe||Xt>=O-Fe,Ue=jt<=Fe||jt>=Pe-Fe),Be&&be&&(Xt=Xt<Zr?0:O),ot&&Ue&&(jt=jt<Kr?0:Pe),ur(null,!0,!0),Fs=!1}Xt=-10,jt=-10,se.fill(null),ur(null,!0,!0),pe&&(Fs=pe)}function Zp(_,S,R,L,k,Z,le){fe._lock||(et(_),uo(),zu(),_!=null&&go(u_,n,Xt,jt,O,Pe,null))}function Kp(){C.forEach(sA),F(n.width,n.height,!0)}kr(vu,Qa,Kp);let Qr={};Qr.mousedown=Yp,Qr.mousemove=Hp,Qr.mouseup=$p,Qr.dblclick=Zp,Qr.setSeries=(_,S,R,L)=>{let k=pn.match[2];R=k(n,S,R),R!=-1&&$i(R,L,!0,!1)},ge&&(wt(l_,g,Yp),wt(ip,g,Hp),wt(c_,g,_=>{et(_),mo(!1)}),wt(h_,g,ax),wt(u_,g,Zp),_p.add(n),n.syncRect=mo);let Dl=n.hooks=i.hooks||{};function Rn(_,S,R){Xn?Ft.push([_,S,R]):_ in Dl&&Dl[_].forEach(L=>{L.call(null,n,S,R)})}(i.plugins||[]).forEach(_=>{for(let S in _.hooks)Dl[S]=(Dl[S]||[]).concat(_.hooks[S])});let Jp=(_,S,R)=>R,pn=_n({key:null,setSeries:!1,filters:{pub:S_,sub:S_},scales:[T,y[1]?y[1].scale:null],match:[M_,M_,Jp],values:[null,null]},fe.sync);pn.match.length==2&&pn.match.push(Jp),fe.sync=pn;let jp=pn.key,Vu=xv(jp);function go(_,S,R,L,k,Z,le){pn.filters.pub(_,S,R,L,k,Z,le)&&Vu.pub(_,S,R,L,k,Z,le)}Vu.sub(n);function ox(_,S,R,L,k,Z,le){pn.filters.sub(_,S,R,L,k,Z,le)&&Qr[_](null,S,R,L,k,Z,le)}n.pub=ox;function lx(){Vu.unsub(n),_p.delete(n),Tn.clear(),fp(vu,Qa,Kp),c.remove(),Ce?.remove(),Rn("destroy")}n.destroy=lx;function Hu(){Rn("init",i,e),ho(e||i.data,!1),H[T]?Nu(T,H[T]):uo(),ie=qt.show&&(qt.width>0||qt.height>0),te=me=!0,F(i.width,i.height)}return y.forEach(Gr),C.forEach(cs),t?t instanceof HTMLElement?(t.appendChild(c),Hu()):t(n,Hu):Hu(),n}vn.assign=_n;vn.fmtNum=wp;vn.rangeNum=xu;vn.rangeLog=Su;vn.rangeAsinh=Sp;vn.orient=Vr;vn.pxRatio=It;vn.join=ZE;vn.fmtDate=Tp,vn.tzDate=aT;vn.sync=xv;{vn.addGap=HT,vn.clipGaps=Eu;let i=vn.paths={points:Ev};i.linear=Av,i.stepped=XT,i.bars=qT,i.spline=$T}function Lv(i){return`Plot of ${i.lines.map(t=>Nn(t.label,t.unit)).join(", ")} over ${Nn(i.x.label,i.x.unit)}. Plus and minus zoom, arrows move, 0 shows everything. The numbers follow as a table.`}function Dv(i,e){return{label:i.label,unit:i.unit,colour:Hr(`--line-${e%8+1}`),dash:e>=8}}function Hr(i){return getComputedStyle(document.documentElement).getPropertyValue(i).trim()||"#888888"}function Nv(i){for(let e=1;e<i.length;e++)if(!(i[e]>=i[e-1]))return!1;return i.length===0||Number.isFinite(i[0])}function Al(i){let[e,t]=[1/0,-1/0];for(let s of i)for(let r=0;r<s.length;r++){let a=s[r];Number.isFinite(a)&&(e=Math.min(e,a),t=Math.max(t,a))}if(e>t)return[0,1];let n=.5*Math.abs(e)||.5;return t>e?[e,t]:[e-n,t+n]}function Uv(i,e){return Array.from(i,t=>Number.isFinite(t)&&(!e||t>0)?t:null)}function rA(i){let e={stroke:Hr("--ink-soft"),grid:{stroke:Hr("--grid"),width:1},ticks:{stroke:Hr("--grid"),width:1}},t=[...new Set(i.lines.map(a=>a.unit))],n=i.lines.length===1?i.lines[0].label:"",s=i.yLabel??(t.length===1?Nn(n,t[0]):""),r=(a,o)=>o.map(l=>aA(l));return[{...e,label:Nn(i.x.label,i.x.unit),labelSize:20,size:36,values:r},{...e,label:s,labelSize:s?20:4,size:62,values:i.log?(a,o)=>o.map(oA):r}]}function aA(i){if(i==null)return"";let e=Math.abs(i);return(e!==0&&(e>=1e5||e<.001)?i.toExponential(2).replace(/\.?0+e/,"e").replace("e+","e"):String(Number(i.toPrecision(6)))).replaceAll("-","\u2212")}function oA(i){return i!=null&&Math.abs(Math.log10(i)-Math.round(Math.log10(i)))<1e-6?`1e${Math.round(Math.log10(i))}`.replace("-","\u2212"):""}function Fv(i,e){let t=i.bars?vn.paths.bars({size:[1,1/0],align:0}):null,n=e.map(r=>({label:r.label,stroke:r.colour,width:1.6,points:{show:i.bars?!1:i.x.values.length<40,size:5},...r.dash?{dash:[6,4]}:{},...t?{paths:t,fill:`${r.colour}59`,width:1}:{}})),s=i.marks?.length?18:8;return{legend:{show:!1},axes:rA(i),series:n,padding:[s,12,0,0]}}function Ov(i,e){let t=Fv(i,e),n=Al([i.x.values]);if(i.bars&&i.x.values.length>1){let l=(i.x.values[1]-i.x.values[0])/2;n[0]-=l,n[1]+=l}let s=i.log??!1,[r,a]=Al([i.x.values]),o=(l,c)=>l==null||c==null||!(c>l)||l<=r&&c>=a?n:cA([l,c],n);return{options:{...t,series:[{},...t.series],scales:{x:{time:!1,range:(l,c,h)=>o(c,h)},y:s?{distr:3}:i.bars?{range:(l,c,h)=>[0,1.05*h||1]}:{range:(l,c,h)=>lA(c,h)}},cursor:{drag:{x:!0,y:!1},y:!1,points:{show:!i.bars}}},data:[Array.from(i.x.values),...i.lines.map(l=>Uv(l.values,s))],whole:{x:n}}}function lA(i,e){if(i==null||e==null)return[0,1];let t=Math.abs(i)||1;return i===e?[i-t,e+t]:vn.rangeNum(i,e,.1,!0)}function cA([i,e],[t,n]){let s=Math.min(e-i,n-t),r=Math.min(Math.max(i,t),n-s);return[r,r+s]}function Bv(i,e){let t=i.log??!1,n=Fv(i,e),s=Iv(Al([i.x.values])),r=i.lines.map(h=>Uv(h.values,t)),a=Al(r.map(h=>h.filter(u=>u!==null))),o=t?a:Iv(a),l=["x","y"].map(h=>({scale:h,auto:!0})),c=Array.from(i.x.values);return{options:{...n,mode:2,series:[null,...n.series.map(h=>({...h,facets:l,paths:hA,points:{show:!1}}))],scales:{x:{time:!1,auto:!1,range:(h,u,f)=>u==null||f==null||!(f>u)?s:[u,f]},y:{auto:!1,...t?{distr:3}:{},range:(h,u,f)=>u==null||f==null||!(f>u)?o:[u,f]}},cursor:{drag:{x:!0,y:!0,uni:30},points:{show:!1}}},data:[null,...r.map(h=>[c,h])],whole:{x:s,y:o}}}function Iv([i,e]){let t=.04*(e-i);return[i-t,e+t]}var hA=(i,e)=>{let[t,n]=i.data[e],s=new Path2D,r=!1;for(let a=0;a<t.length;a++){let[o,l]=[t[a],n[a]??null];if(l===null||!Number.isFinite(o)){r=!1;continue}let c=[i.valToPos(o,"x",!0),i.valToPos(l,"y",!0)];r?s.lineTo(...c):s.moveTo(...c),r=!0}return{stroke:s,fill:null,clip:null,flags:0}};function kv(i){let{left:e,top:t}=i.cursor,n=i.data.slice(1);if(e==null||t==null||e<0||n.length===0)return[null,[]];let[s,r]=[-1,60**2];for(let[a,o]of n)for(let l=0;l<a.length;l++){let c=o[l],h=c==null?1/0:(i.valToPos(a[l],"x")-e)**2+(i.valToPos(c,"y")-t)**2;h<r&&([s,r]=[l,h])}return s<0?[null,[]]:[n[0][0][s],n.map(([,a])=>a[s]??null)]}var Ru=class{element=document.createElement("div");#e=[];#t=document.createElement("span");constructor(e,t,n){this.element.className="plot-legend",t.forEach((s,r)=>this.#r(s,r,n)),this.#t.className="plot-at",this.#t.dataset.title=Nn(e.label,e.unit),this.element.append(this.#t)}#r(e,t,n){let s=document.createElement("button");s.type="button",s.setAttribute("aria-pressed","true"),s.title="Show or hide";let r=document.createElement("span");r.className=e.dash?"swatch dash":"swatch",r.style.color=e.colour;let a=document.createElement("output");this.#e.push(a),s.append(r,Nn(e.label,e.unit),a),s.addEventListener("click",()=>{let o=s.getAttribute("aria-pressed")!=="true";s.setAttribute("aria-pressed",String(o)),n(t+1,o)}),this.element.append(s)}show(e,t){this.#t.textContent=e===null?"":`${this.#t.dataset.title}: ${Dn(e)}`,this.#e.forEach((n,s)=>n.textContent=e===null?"":Dn(t[s]??NaN))}};function zv(i){let e=i.cursor.idx;return e==null?[null,[]]:[i.data[0][e]??null,i.data.slice(1).map(t=>t[e]??null)]}function Vv(i,e){let{ctx:t,bbox:n}=i;t.save(),t.strokeStyle=t.fillStyle=Hr("--ink-soft"),t.lineWidth=window.devicePixelRatio,t.setLineDash([2*window.devicePixelRatio,3*window.devicePixelRatio]),t.font=`${11*window.devicePixelRatio}px system-ui, sans-serif`,t.textAlign="left",t.textBaseline="alphabetic";let s=-1/0;for(let{at:r,label:a}of e){let o=i.valToPos(r,"x",!0);if(o<n.left||o>n.left+n.width)continue;t.beginPath(),t.moveTo(o,n.top),t.lineTo(o,n.top+n.height),t.stroke();let l=t.measureText(a).width;o>s&&o+l<n.left+n.width&&(t.fillText(a,o+4*window.devicePixelRatio,n.top-5*window.devicePixelRatio),s=o+l+12*window.devicePixelRatio)}t.restore()}function Hv(i,e){let{ctx:t,bbox:n}=i,s=e===null?NaN:i.valToPos(e,"x",!0);s>=n.left&&s<=n.left+n.width&&(t.save(),t.strokeStyle=Hr("--accent"),t.lineWidth=2*window.devicePixelRatio,t.beginPath(),t.moveTo(s,n.top),t.lineTo(s,n.top+n.height),t.stroke(),t.restore())}var uA=200;function Gv(i,e){let t=e[0]?.values.length??0,n=Math.max(1,Math.ceil(t/uA)),s=document.createElement("table");s.createCaption().textContent=n>1?`${i}: one row in ${n} of ${t}`:i;let r=s.createTHead().insertRow();for(let{label:l,unit:c}of e){let h=document.createElement("th");h.scope="col",h.textContent=Nn(l,c),r.append(h)}let a=s.createTBody();for(let l=0;l<t;l+=n){let c=a.insertRow();for(let{values:h}of e)c.insertCell().textContent=Dn(h[l]??NaN)}let o=document.createElement("div");return o.className="table-scroller",o.tabIndex=0,o.setAttribute("role","region"),o.setAttribute("aria-label",`Numbers of ${i}`),o.append(s),o}function Dp(i,e){let t=document.createElement("details");t.className="data-table";let n=document.createElement("summary");return n.textContent="Numbers",t.append(n),t.addEventListener("toggle",()=>{t.open&&t.childElementCount===1&&t.append(Gv(i,e()))}),t}var fA={"+":i=>Cl(i,.7142857142857143),"=":i=>Cl(i,.7142857142857143),"-":i=>Cl(i,1.4),ArrowLeft:i=>Wv(i,-.15),ArrowRight:i=>Wv(i,.15),0:Rl,Home:Rl};function Rl(i,e){i.batch(()=>{for(let[t,[n,s]]of Object.entries(e))i.setScale(t,{min:n,max:s})})}function Cl(i,e){let{min:t,max:n}=i.scales.x;if(t!=null&&n!=null){let[s,r]=[(t+n)/2,e*(n-t)/2];i.setScale("x",{min:s-r,max:s+r})}}function Wv(i,e){let{min:t,max:n}=i.scales.x;if(t!=null&&n!=null){let s=e*(n-t);i.setScale("x",{min:t+s,max:n+s})}}function Xv(i,e,t){i.addEventListener("keydown",n=>{let s=fA[n.key];s&&n.target===i&&!n.ctrlKey&&!n.metaKey&&!n.altKey&&(s(e(),t()),n.preventDefault())})}function qv(i,e){let t=document.createElement("span");t.className="zoom-buttons";let n=(s,r,a)=>{let o=document.createElement("button");o.type="button",o.textContent=s,o.setAttribute("aria-label",r),o.title=r,o.addEventListener("click",a),t.append(o)};return n("\u2212","Zoom out",()=>Cl(i(),1.4)),n("+","Zoom in",()=>Cl(i(),1/1.4)),n("Reset","Reset: see everything",()=>Rl(i(),e())),t}var dA=300,oo=class{element=document.createElement("figure");#e=document.createElement("div");#t;#r=window.matchMedia("(prefers-color-scheme: dark)");#o=()=>this.#d();#i;#n;#c;#s={};#h=null;constructor(e,t){this.#i=t,this.element.className="plot",this.#e.className="plot-surface",this.#e.tabIndex=0,this.#e.setAttribute("role","application"),Xv(this.#e,()=>this.#n,()=>this.#s),e.append(this.element),this.#d(),t.link?.join(this),this.#t=new ResizeObserver(()=>this.#n.setSize(this.#f())),this.#t.observe(this.#e),this.#r.addEventListener("change",this.#o),window.addEventListener("demeter:colours",this.#o)}update(e){let n=e.lines.map(s=>s.label).join()===this.#i.lines.map(s=>s.label).join()&&this.zoomed()?{...this.#n.scales.x}:null;this.#i=e,this.#d(),n&&n.min!=null&&n.max!=null&&this.#n.setScale("x",{min:n.min,max:n.max})}zoomed(){let{min:e,max:t}=this.#n.scales.x,n=this.#s.x;return n!==void 0&&e!=null&&t!=null&&(e>n[0]||t<n[1])}range(){let{min:e,max:t}=this.#n.scales.x;return[e??NaN,t??NaN]}see([e,t]){this.#n.setScale("x",{min:e,max:t})}setNow(e){e!==this.#h&&(this.#h=e,this.#n.redraw(!1,!1))}reset(){Rl(this.#n,this.#s)}dispose(){this.#i.link?.leave(this),this.#t.disconnect(),this.#r.removeEventListener("change",this.#o),window.removeEventListener("demeter:colours",this.#o),this.#n.destroy(),this.element.remove()}#l(){let e=this.#i.log??!1,t=In("log",()=>{this.update({...this.#i,log:!e}),this.element.querySelector("[aria-pressed].log")?.focus()},{class:"log","aria-pressed":e,title:"Logarithmic vertical axis"});return t.setAttribute("aria-pressed",String(e)),t}#a(e,t){let{min:n,max:s}=e.scales.x;t==="x"&&n!=null&&s!=null&&(this.element.dataset.range=`${n} ${s}`,this.#i.link?.spread(this,[n,s]))}#u(e){let{onPlace:t}=this.#i;if(t){let n=NaN;e.over.addEventListener("mousedown",s=>n=s.clientX),e.over.addEventListener("click",s=>{Math.abs(s.clientX-n)<4&&t(e.posToVal(s.offsetX,"x"))})}}#f(){return{width:Math.max(this.#e.clientWidth,200),height:this.#i.height??dA}}#d(){let e=this.#i;this.#n?.destroy();let t=e.lines.map((l,c)=>Dv(l,c)),n=document.createElement("figcaption");n.textContent=e.title;let s=qv(()=>this.#n,()=>this.#s);e.canBeLog&&s.prepend(this.#l()),n.append(s),this.#e.setAttribute("aria-label",Lv(e)),this.#c=new Ru(e.x,t,(l,c)=>this.#n.setSeries(l,{show:c}));let r=Dp(e.title,()=>[e.x,...e.lines]);this.element.replaceChildren(n,this.#e,this.#c.element,r);let a=!Nv(e.x.values),o=a?Bv(e,t):Ov(e,t);if(o.options.hooks={setCursor:[l=>this.#c.show(...a?kv(l):zv(l))],draw:[l=>Vv(l,e.marks??[]),l=>Hv(l,this.#h)],ready:[l=>this.#u(l)],setScale:[(l,c)=>this.#a(l,c)]},e.link&&!a){let l=c=>c==="mousemove"||c==="mouseleave";o.options.cursor={...o.options.cursor,sync:{key:e.link.key,setSeries:!1,scales:["x",null],filters:{pub:l,sub:l}}}}this.#n=new vn({...o.options,...this.#f()},o.data,this.#e),this.#s=o.whole}};var pA=24,mA=300,gA={position:"m",radius:"m",mass:"kg",velocity:"m/s",angular_velocity:"1/s",force:"N",torque:"N m"},_A=["id","diameter","orientation"],Yv=[["speed","speed","m/s",i=>i.speed],["contact_force","contact force","N",i=>i.contact_force],["force","total force","N",i=>i.force],["coordination","coordination","",i=>i.coordination],["x","x","m",i=>i.position[0]],["y","y","m",i=>i.position[1]],["z","z","m",i=>i.position[2]]],Pu=class{element=re("section",{class:"grain-panel","aria-label":"Picked grain"});#e;#t=re("input",{type:"number",min:1,step:1,"aria-label":"Id of a grain"});#r=re("div",{class:"grain-values"});#o=re("div",{class:"grain-plots"});#i=re("p",{class:"hint",role:"status"});#n;#c=null;#s=-1;#h=[];#l=[];#a=0;#u=null;#f=null;#d=0;#m=0;constructor(e){this.#e=e;let t=Ti("History of",Yv.map(([s,r,a])=>[s,a?`${r} [${a}]`:r]),()=>this.#v());this.#n=t.select;let n=re("form",{class:"grain-form"},re("label",{},"Grain ",this.#t),re("button",{type:"submit"},"Show"),In("None",()=>this.#e.pick(null)));n.addEventListener("submit",s=>{s.preventDefault(),Number.isInteger(this.#t.valueAsNumber)&&this.#t.valueAsNumber>=0&&this.#e.pick(this.#t.valueAsNumber)}),this.#o.append(t.element),this.#o.hidden=!0,this.element.append(re("h2",{},"Grain"),n,this.#i,this.#r,this.#o),this.#i.textContent="Click a grain in the picture, or type its id."}get grain(){return this.#c}show(e){this.#a+=1,this.#c=e,this.#l=[],this.#u?.dispose(),this.#u=null,this.#o.hidden=e===null,this.#r.replaceChildren(),this.#i.textContent=e===null?"Click a grain in the picture, or type its id.":"",this.#t.value=e===null?"":String(e),e!==null&&(this.#p(),this.#x())}setTimes(e,t){this.#h=e,this.#c!==null&&(t?this.show(this.#c):e.length>this.#l.length&&this.#x())}setFrame(e,t){if(this.#s=e,this.#f=t,this.#u?.setNow(t),this.#c===null)return;clearTimeout(this.#m);let n=Math.max(mA-(performance.now()-this.#d),0);this.#m=window.setTimeout(()=>{this.#p()},n)}async#p(){let[e,t,n]=[this.#a,this.#s,this.#c];if(!(n===null||t<0)){this.#d=performance.now();try{let s=await v0(t,n);e===this.#a&&t===this.#s&&(this.#i.textContent="",this.#r.replaceChildren(...this.#g(s)))}catch(s){e===this.#a&&(this.#r.replaceChildren(),this.#i.textContent=s.message)}}}#g(e){let t=re("dl",{class:"values"});for(let[n,s]of Object.entries(e.values))!_A.includes(n)&&s!==null&&t.append(re("div",{},re("dt",{},n.replaceAll("_"," ")),re("dd",{},vA(s,gA[n]??""))));return[t,this.#_(e.contacts)]}#_(e){if(e.length===0)return re("p",{class:"hint"},"No contact acts on it at this moment.");let t=re("table");t.createCaption().textContent=`${e.length} ${e.length===1?"contact":"contacts"} at this moment; repulsion is positive`;let n=t.createTHead().insertRow();for(let a of["Partner","Normal force","Tangential force","Overlap"])n.append(re("th",{scope:"col"},a));let s=t.createTBody(),r=a=>Math.abs(a.normal_force??0);for(let a of[...e].sort((o,l)=>r(l)-r(o))){let o=s.insertRow(),l=re("th",{scope:"row"});l.append(a.wall>=0?`wall ${this.#e.wallName(a.wall)}`:In(`grain ${a.partner}`,()=>this.#e.pick(a.partner),{class:"link"})),o.append(l);for(let[c,h]of[[a.normal_force,"N"],[a.tangential_force,"N"],[a.overlap,"m"]])o.insertCell().textContent=Bn(c??NaN,h)}return re("div",{class:"table-scroller",tabindex:0,role:"region","aria-label":"Contacts of the grain"},t)}async#x(){let[e,t]=[this.#a,this.#c];for(;t!==null&&e===this.#a&&this.#l.length<this.#h.length;){let n=this.#l.length;try{let{moments:s}=await x0(t,n,pA);if(e!==this.#a||this.#l.length!==n||s.length===0)return;this.#l.push(...s),this.#v()}catch(s){this.#i.textContent=s.message;return}}}#v(){let[,e,t,n]=Yv.find(([o])=>o===this.#n.value),s=this.#h.slice(0,this.#l.length);if(this.#c===null||s.length===0)return;let r=this.#l.slice(0,s.length).map(o=>o?n(o)??NaN:NaN),a={title:`${e} of grain ${this.#c} over time`,x:{label:"time",unit:"s",values:s},lines:[{label:e,unit:t,values:r}],height:220,onPlace:this.#e.seek};this.#u?this.#u.update(a):this.#u=new oo(this.#o,a),this.#u.setNow(this.#f)}};function vA(i,e){return typeof i=="string"?i:Array.isArray(i)?`(${i.map(t=>Bn(t??NaN,e)).join(", ")})`:e===""?Dn(i):Bn(i,e)}var xA=["kinetic energy","elastic energy"],$v=12,Iu=class{element=re("section",{class:"series-panel","aria-label":"Series"});#e;#t=re("div",{class:"series-plot"});#r=re("div",{class:"column-list"});#o=re("input",{type:"search",placeholder:"energy, wall top, \u2026"});#i;#n=null;#c=null;#s=0;#h=!1;#l=new Set;#a=new Map;#u=null;#f=!1;constructor(e){this.#e=e;let t=Ti("Horizontal axis",[],o=>{this.#s=Number(o),this.#g()});this.#i=t.select;let n=li("Logarithmic vertical axis",!1,o=>{this.#h=o,this.#v()});this.#o.addEventListener("input",()=>this.#p());let s=re("label",{class:"field"},re("span",{},"Find columns"),this.#o),r=re("fieldset",{},re("legend",{},"Vertical axis"),s,this.#r),a=re("div",{class:"own-choices"},t.element,n.element,r);this.element.append(re("h2",{},"Series"),re("div",{class:"own-plot"},a,this.#t))}update(e,t){t&&this.#a.clear();let n=a=>a?.columns.map(o=>o.name).join(`
`)??"",s=n(e)===n(this.#n),r=e?.rows!==this.#n?.rows;this.#n=e,s||this.#d(),(!s||r||t)&&this.#g()}setTime(e){this.#c=e,this.#u?.setNow(this.#y())}#d(){let e=this.#n?.columns??[],t=e.map((n,s)=>[n,s]).filter(([n])=>n.numbers);this.#a.clear(),this.#l=new Set(t.filter(([n])=>xA.includes(n.name)).map(([,n])=>n)),this.#s=Math.max(e.findIndex(n=>n.name==="time"),0),this.#i.replaceChildren(...t.map(([n,s])=>re("option",{value:s},Nn(n.name,n.unit)))),this.#i.value=String(this.#s),this.#r.replaceChildren(...t.map(([n,s])=>this.#m(n,s))),this.#p()}#m(e,t){let n=li(Nn(e.name,e.unit),this.#l.has(t),s=>{s?this.#l.add(t):this.#l.delete(t),this.#g()});return n.element.dataset.name=e.name.toLowerCase(),n.element}#p(){let e=this.#o.value.toLowerCase().split(/\s+/);for(let t of this.#r.children)t.hidden=!e.every(n=>t.dataset.name.includes(n))}async#g(){if(!this.#f){this.#f=!0;try{for(let e=0;e<100;e++){let t=this.#n?.rows??0,n=this.#_().filter(a=>(this.#a.get(a)?.length??0)<t);if(n.length===0)break;let s=Math.min(...n.map(a=>this.#a.get(a)?.length??0)),r=await y0(n,s);for(let a of n)this.#a.set(a,yA(this.#a.get(a),r.doubles(String(a)),r.head.from))}}catch(e){this.#t.dataset.fault=String(e)}finally{this.#f=!1}this.#v()}}#_(){let e=this.#n?.columns.findIndex(n=>n.name==="time")??-1,t=[...this.#l].sort((n,s)=>n-s).slice(0,$v);return[...new Set([this.#s,e,...t])].filter(n=>n>=0)}#x(e,t){let{name:n,unit:s}=this.#n.columns[e];return{label:n,unit:s,values:this.#a.get(e).subarray(0,t)}}#v(){let e=[...this.#l].sort((c,h)=>c-h).slice(0,$v),t=[this.#s,...e].map(c=>this.#a.get(c)?.length??0),n=Math.min(...t);if(!this.#n||e.length===0||n===0){this.#u?.dispose(),this.#u=null;let c=this.#n&&this.#n.rows>0?"Tick the columns to plot; any column may be the horizontal axis.":"The run has no row yet.";this.#t.replaceChildren(re("p",{class:"hint"},c));return}let s=this.#x(this.#s,n),r=e.map(c=>this.#x(c,n)),a=s.label==="time",o=a?this.#n.stages.filter(c=>c.from<n).map(c=>({at:s.values[c.from],label:c.name})):[],l={title:`${r.map(c=>c.label).join(", ")} over ${s.label}`,x:s,lines:r,log:this.#h,marks:o,height:320,...a?{onPlace:this.#e}:{}};this.#u?this.#u.update(l):(this.#t.replaceChildren(),this.#u=new oo(this.#t,l)),this.#u.setNow(this.#y())}#y(){let e=this.#n?.columns.findIndex(s=>s.name==="time")??-1,[t,n]=[this.#a.get(e),this.#a.get(this.#s)];return this.#c===null||!t||!n?null:e===this.#s?this.#c:n[bA(t,this.#c)]??null}};function yA(i,e,t){let n=i?.subarray(0,t)??new Float64Array,s=new Float64Array(n.length+e.length);return s.set(n),s.set(e,n.length),s}function bA(i,e){let[t,n]=[0,i.length-1];for(;t<n;){let s=t+n>>1;i[s]<e?t=s+1:n=s}return t>0&&e-i[t-1]<i[t]-e?t-1:t}var SA=[1,2,5,10,15,25,30,60],MA=4,Zv=[["Space","play or pause"],["Left and right arrow, or , and .","one frame back or on"],["Home and End","first and last frame"]],Lu=class{element=re("section",{class:"timeline","aria-label":"Timeline"});#e;#t=re("input",{type:"range",min:0,max:0,step:1,value:0,"aria-label":"Frame"});#r=re("output",{class:"time-told"});#o=re("p",{class:"unseen",role:"status","aria-live":"polite"});#i;#n;#c;#s=[];#h=[];#l=-1;#a=-1;#u=10;#f=!1;#d=-1;#m=!1;#p=Promise.resolve();#g=0;constructor(e){this.#e=e;let t=(l,c,h)=>In(l,h,{"aria-label":c,title:c});this.#i=t("Play","Play",()=>this.toggle()),this.#i.classList.add("play");let n=Ti("Frames per second",SA.map(l=>[String(l),String(l)]),l=>this.#u=Number(l));n.select.value=String(this.#u);let s=li("Loop",!1,()=>{}),r=li("Live",!1,l=>l&&this.#_());r.element.title="Follow the run: show the newest frame as soon as it is there",[this.#n,this.#c]=[r.input,s.input],this.#t.addEventListener("input",()=>this.seek(this.#t.valueAsNumber));let a=re("div",{class:"time-buttons"},t("|\u25C0","First frame",()=>this.seek(0)),t("\u25C0","One frame back",()=>this.seek(this.#a-1)),this.#i,t("\u25B6","One frame on",()=>this.seek(this.#a+1)),t("\u25B6|","Last frame",()=>this.seek(this.#s.length-1))),o=re("div",{class:"time-choices"},n.element,s.element,r.element);this.element.append(re("div",{class:"time-row"},a,this.#t,this.#r),o,this.#o),document.addEventListener("keydown",l=>this.#A(l)),this.#M()}get index(){return this.#l}get playing(){return this.#f}get live(){return this.#n.checked}set live(e){this.#n.checked=e,e&&this.#_()}setMoments(e,t){[this.#h,this.#s]=[e,t],this.#t.max=String(Math.max(t.length-1,0)),this.#t.disabled=t.length<2,this.#l>=t.length&&(this.#l=this.#a=-1),t.length>0&&(this.#l<0||this.live)&&this.#v(this.live?t.length-1:0),this.#M()}seek(e){let t=Math.min(Math.max(e,0),this.#s.length-1);t<this.#s.length-1&&(this.#n.checked=!1),this.pause(),this.#v(t)}seekTime(e){let t=0;this.#s.forEach((n,s)=>{Math.abs(n-e)<Math.abs(this.#s[t]-e)&&(t=s)}),this.seek(t)}toggle(){this.#f?this.pause():this.#s.length>1&&(this.#n.checked=!1,this.#f=!0,this.#x(),this.#b())}pause(){this.#f&&(this.#f=!1,this.#x(),this.#T())}#_(){this.pause(),this.#s.length>0&&this.#v(this.#s.length-1)}#x(){this.#i.textContent=this.#f?"Pause":"Play";let e=this.#f?"Pause":"Play";this.#i.setAttribute("aria-label",e),this.#i.title=e}#v(e){this.#d=this.#a=e,this.#t.value=String(e),this.#S(e),this.#m||(this.#p=this.#y())}async#y(){for(this.#m=!0;this.#d>=0;){let e=this.#d;this.#d=-1,await this.#w(e)}this.#m=!1,this.#T()}async#w(e){try{await this.#e.show(e)}finally{this.#l=e,this.#M()}}async#b(){let e=++this.#g;for(await this.#p,this.#l>=this.#s.length-1&&(this.#l=-1);this.#f&&e===this.#g;){let t=this.#l+1,n=performance.now();if(t>=this.#s.length&&!this.#c.checked){this.pause();break}let s=t%this.#s.length;this.#a=s,this.#e.ahead(this.#E(s)),this.#m=!0,await this.#w(s),this.#m=!1;let r=Math.max(1e3/this.#u-(performance.now()-n),0);await new Promise(a=>setTimeout(a,r))}this.#d>=0&&!this.#m&&(this.#p=this.#y())}#E(e){let t=this.#s.length,n=Array.from({length:MA+1},(s,r)=>e+r);return this.#c.checked?n.map(s=>s%t):n.filter(s=>s<t)}#M(){this.#S(this.#a)}#S(e){let t=this.#s[e],n=t===void 0?"no frame yet":`${Bn(t,"s")} \xB7 frame ${e+1} of ${this.#s.length}`;this.#r.textContent=n,this.#r.title=t===void 0?"":`step ${this.#h[e]}`,this.#t.setAttribute("aria-valuetext",n),(document.activeElement!==this.#t||this.#f)&&(this.#t.value=String(Math.max(e,0)))}#T(){this.#f||(this.#o.textContent=`Time ${this.#r.textContent}`)}#A(e){if(e.ctrlKey||e.metaKey||e.altKey||e.shiftKey||e.defaultPrevented)return;let t=e.target,n=t instanceof HTMLInputElement?t.type:"";if(t instanceof HTMLTextAreaElement||["text","number","search"].includes(n)||t instanceof HTMLSelectElement)return;let r=t instanceof HTMLButtonElement||t.tagName==="SUMMARY"||n==="checkbox",a=n==="range"||t.getAttribute("role")==="application",l={...r?{}:{" ":()=>this.toggle()},...a?{}:{ArrowLeft:()=>this.seek(this.#a-1),ArrowRight:()=>this.seek(this.#a+1),Home:()=>this.seek(0),End:()=>this.seek(this.#s.length-1)},",":()=>this.seek(this.#a-1),".":()=>this.seek(this.#a+1)}[e.key];l&&(e.preventDefault(),l())}};var Kv={live:700,idle:4e3},Np=class{#e=new du;#t=re("h1",{},"\u2026");#r=re("p",{class:"badge",role:"status"});#o=re("p",{class:"about"});#i=re("p",{class:"notice bad",role:"alert",hidden:!0});#n=re("div");#c=new Set;#s;#h;#l;#a;#u;#f=[];#d=[];#m=-1;#p=null;#g=new Map;#_="run";constructor(){let e=re("div"),t=re("main",{id:"main"},this.#i,e);document.body.append(re("a",{class:"skip",href:"#main"},"Skip to the picture"),re("header",{},re("div",{class:"title"},this.#t,this.#r),this.#o),t),this.#h=new Lu({show:r=>this.#w(r),ahead:r=>this.#e.prefetch(r.map(a=>this.#f[a]))}),this.#s=new Yh(e,{label:"The run",fileName:"packing",describes:!1,onPick:r=>this.#M(r)}),this.#s.view.append(this.#h.element);let n=r=>this.#h.seekTime(r);this.#l=new Iu(n),this.#a=new Pu({pick:r=>this.#s.pick(r),seek:n,wallName:r=>this.#g.get(r)??String(r)}),t.append(re("div",{class:"below"},this.#a.element,this.#l.element),EA());let s=this.#s.scene;this.#u=s&&new fu({scene:s,name:()=>this.#_,count:()=>this.#d.length,index:()=>this.#h.index,time:r=>this.#d[r]??NaN,unit:r=>this.#p?.scalars.find(a=>a.name===r)?.unit??"",show:r=>this.#w(r)}),this.#u&&this.#s.controls.append(ji("Walls",this.#n),this.#u.element),this.#x()}async#x(){for(;;){let e=!0;try{let t=this.#m<0?0:this.#d.length;e=await this.#v(await Td(t)),this.#S(null)}catch(t){this.#S(t)}await new Promise(t=>setTimeout(t,e?Kv.live:Kv.idle))}}async#v(e){let t=e,n=this.#m<0,s=t.epoch!==this.#m;s&&(n||(t=await Td(0)),this.#e.clear(),[this.#f,this.#d]=[[],[]],this.#m=t.epoch),this.#_=t.folder;let{moments:r}=t,a=r.times.length>0&&r.from===this.#d.length;return a&&(this.#f=[...this.#f,...r.steps],this.#d=[...this.#d,...r.times]),this.#y(t),this.#l.update(t.series,s&&!n),(a||s)&&(this.#h.setMoments(this.#f,this.#d),this.#a.setTimes(this.#d,s&&!n),this.#u?.setCount(this.#d.length)),n&&t.going_on&&(this.#h.live=!0),t.going_on}#y(e){this.#t.textContent=e.title||e.folder,document.title=`${e.title||e.folder} \u2013 Demeter`;let[t,n]=e.going_on?["running","good"]:e.summary?[e.summary.finished?"finished":"stopped",e.summary.finished?"good":"warn"]:["not ended","warn"];this.#r.textContent!==t&&(this.#r.textContent=t,this.#r.className=`badge ${n}`);let s=this.#d.at(-1),r=[`folder ${e.folder}`,`${this.#d.length} frames`,...s===void 0?[]:[`to ${Bn(s,"s")}`],`${e.series?.rows??0} rows`,`Demeter ${e.version}`],a=e.summary&&!e.summary.finished?`; it ended because ${e.summary.stopped_by}`:"";this.#o.textContent=`${r.join(" \xB7 ")}${a}`,e.fault&&this.#S(new nr(e.fault))}async#w(e){let t=this.#f[e];if(t!==void 0){this.#h.playing||this.#e.only([t]);try{let n=await this.#e.get(t);this.#p=n,this.#b(),await wA(),this.#S(null)}catch(n){n.name!=="AbortError"&&(this.#S(n),this.#h.pause())}}}#b(){let e=this.#p;e.walls.some(t=>!this.#g.has(t.index))&&this.#E(e),this.#s.show({...e,walls:e.walls.filter(t=>!this.#c.has(t.index))}),this.#l.setTime(e.time),this.#a.setFrame(e.step,e.time)}#E(e){e.walls.forEach(({index:n,name:s})=>this.#g.set(n,s));let t=[...this.#g].map(([n,s])=>li(s,!this.#c.has(n),a=>{a?this.#c.delete(n):this.#c.add(n),this.#b()}).element);this.#n.replaceChildren(...t)}#M(e){this.#a.show(e),this.#p&&this.#a.setFrame(this.#p.step,this.#p.time)}#S(e){this.#i.hidden=e===null,e&&this.#i.textContent!==e.message&&(this.#i.textContent=e.message,e instanceof nr||console.error(e))}};function wA(){return new Promise(i=>requestAnimationFrame(()=>setTimeout(i,0)))}function EA(){let i=re("dl",{class:"keys"},...Zv.flatMap(([t,n])=>[re("dt",{},t),re("dd",{},n)])),e=re("a",{href:"/licences.txt"},"Licences of the libraries in this page");return re("footer",{},re("details",{},re("summary",{},"Keys of the timeline"),i),e)}new Np;})();
