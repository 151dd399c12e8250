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
"use strict";(()=>{function et(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))r===!0?n.setAttribute(s,""):r!==!1&&n.setAttribute(s,String(r));return n.append(...e),n}function Sn(i,t,e={}){let n=et("button",{type:"button",...e},i);return n.addEventListener("click",t),n}var bx=0;function hm(i,t,...e){return t.id||=`field-${++bx}`,et("div",{class:"field"},et("label",{for:t.id},i),...e,t)}function Ai(i,t,e){let n=et("select",{},...t.map(([s,r])=>et("option",{value:s},r)));return n.addEventListener("change",()=>e(n.value)),{element:hm(i,n),select:n}}function ta(i,t,e,n){let s=et("input",{type:"range",...t}),r=et("output",{"aria-live":"off"},e(t.value)),a=()=>{r.textContent=e(s.valueAsNumber),s.setAttribute("aria-valuetext",e(s.valueAsNumber)),n(s.valueAsNumber)};s.addEventListener("input",a);let o=hm(i,s,r);return r.htmlFor.add(s.id),{element:o,input:s,set:c=>{s.value=String(c),a()}}}function si(i,t,e){let n=et("input",{type:"checkbox",checked:t});return n.addEventListener("change",()=>e(n.checked)),{element:et("label",{class:"tick"},n,i),input:n}}function Qi(i,...t){return et("fieldset",{},et("legend",{},i),...t)}function ea(i,t){let e=et("a",{href:URL.createObjectURL(i),download:t});e.click(),setTimeout(()=>URL.revokeObjectURL(e.href),1e4)}var nr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ir={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},km=0,Ef=1,zm=2;var Go=1,Hm=2,Ta=3,sr=0,Qn=1,Ii=2,Sr=0,Aa=1,Tf=2,Af=3,Cf=4,Vm=5;var Mr=100,Gm=101,Wm=102,Xm=103,qm=104,Ym=200,$m=201,Zm=202,Km=203,Rf=204,Pf=205,Jm=206,jm=207,Qm=208,tg=209,eg=210,ng=211,ig=212,sg=213,rg=214,uc=0,fc=1,dc=2,_a=3,pc=4,mc=5,gc=6,_c=7,If=0,ag=1,og=2,ns=0,Lf=1,Df=2,Nf=3,Uf=4,Ff=5,Of=6,Bf=7;var kf=300,wr=301,Ca=302,Xc=303,qc=304,vc=1e3,es=1001,xc=1002,gn=1003,lg=1004;var Wo=1005;var jn=1006,Yc=1007;var Ts=1008;var vi=1009,zf=1010,Hf=1011,Ra=1012,$c=1013,Hi=1014,xi=1015,Vi=1016,Zc=1017,Kc=1018,Er=1020,Vf=35902,Gf=35899,Wf=1021,Xf=1022,ti=1023,ws=1026,As=1027,qf=1028,Jc=1029,is=1030,jc=1031;var Qc=1033,Xo=33776,qo=33777,Yo=33778,$o=33779,th=35840,eh=35841,nh=35842,ih=35843,sh=36196,rh=37492,ah=37496,oh=37488,lh=37489,Zo=37490,ch=37491,hh=37808,uh=37809,fh=37810,dh=37811,ph=37812,mh=37813,gh=37814,_h=37815,vh=37816,xh=37817,yh=37818,bh=37819,Sh=37820,Mh=37821,wh=36492,Eh=36494,Th=36495,Ah=36283,Ch=36284,Ko=36285,Rh=36286;var Eo=2300,yc=2301,cc=2302,vf=2303,xf=2400,yf=2401,bf=2402;var cg=3200;var Yf=0,hg=1,Cs="",di="srgb",$s="srgb-linear",To="linear",Le="srgb";var hc=7680;var ug=519,fg=512,dg=513,pg=514,$f=515,mg=516,gg=517,Zf=518,Kf=519,_g=35044,Jf=35048;var Rs="300 es",Ri=2e3,Ao=2001;function Sx(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Mx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Co(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function vg(){let i=Co("canvas");return i.style.display="block",i}var um={},va=null;function jf(...i){let t="THREE."+i.shift();va?va("log",t,...i):console.log(t,...i)}function xg(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Kt(...i){i=xg(i);let t="THREE."+i.shift();if(va)va("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function ne(...i){i=xg(i);let t="THREE."+i.shift();if(va)va("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Mo(...i){let t=i.join(" ");t in um||(um[t]=!0,Kt(...i))}function yg(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var bg={[uc]:uc,[dc]:gc,[pc]:pc,[_a]:mc,[fc]:fc,[gc]:dc,[_c]:_c,[mc]:_a},zi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,t);t.target=null}}},kn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],fm=1234567,ma=Math.PI/180,xa=180/Math.PI;function Pa(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(kn[i&255]+kn[i>>8&255]+kn[i>>16&255]+kn[i>>24&255]+"-"+kn[t&255]+kn[t>>8&255]+"-"+kn[t>>16&15|64]+kn[t>>24&255]+"-"+kn[e&63|128]+kn[e>>8&255]+"-"+kn[e>>16&255]+kn[e>>24&255]+kn[n&255]+kn[n>>8&255]+kn[n>>16&255]+kn[n>>24&255]).toLowerCase()}function ve(i,t,e){return Math.max(t,Math.min(e,i))}function Qf(i,t){return(i%t+t)%t}function wx(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Ex(i,t,e){return i!==t?(e-i)/(t-i):0}function wo(i,t,e){return(1-e)*i+e*t}function Tx(i,t,e,n){return wo(i,t,1-Math.exp(-e*n))}function Ax(i,t=1){return t-Math.abs(Qf(i,t*2)-t)}function Cx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function Rx(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function Px(i,t){return i+Math.floor(Math.random()*(t-i+1))}function Ix(i,t){return i+Math.random()*(t-i)}function Lx(i){return i*(.5-Math.random())}function Dx(i){i!==void 0&&(fm=i);let t=fm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Nx(i){return i*ma}function Ux(i){return i*xa}function Fx(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Ox(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function td(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Bx(i,t,e,n,s){let r=Math.cos,a=Math.sin,o=r(e/2),l=a(e/2),c=r((t+n)/2),h=a((t+n)/2),f=r((t-n)/2),u=a((t-n)/2),p=r((n-t)/2),g=a((n-t)/2);switch(s){case"XYX":i.set(o*h,l*f,l*u,o*c);break;case"YZY":i.set(l*u,o*h,l*f,o*c);break;case"ZXZ":i.set(l*f,l*u,o*h,o*c);break;case"XZX":i.set(o*h,l*g,l*p,o*c);break;case"YXY":i.set(l*p,o*h,l*g,o*c);break;case"ZYZ":i.set(l*g,l*p,o*h,o*c);break;default:Kt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ed(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Sg(i,t){if(t.constructor===Float32Array)return i;let e=ed(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Mg(i,t){if(t.constructor===Float32Array)return i;let e=ed(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var nd={DEG2RAD:ma,RAD2DEG:xa,generateUUID:Pa,clamp:ve,euclideanModulo:Qf,mapLinear:wx,inverseLerp:Ex,lerp:wo,damp:Tx,pingpong:Ax,smoothstep:Cx,smootherstep:Rx,randInt:Px,randFloat:Ix,randFloatSpread:Lx,seededRandom:Dx,degToRad:Nx,radToDeg:Ux,isPowerOfTwo:Fx,ceilPowerOfTwo:Ox,floorPowerOfTwo:td,setQuaternionFromProperEuler:Bx,normalize:Mg,denormalize:Sg},ie=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,a=this.y-t.y;return this.x=r*n-a*s+t.x,this.y=r*s+a*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},pi=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,a,o){let l=n[s+0],c=n[s+1],h=n[s+2],f=n[s+3],u=r[a+0],p=r[a+1],g=r[a+2],b=r[a+3];if(f!==b||l!==u||c!==p||h!==g){let d=l*u+c*p+h*g+f*b;d<0&&(u=-u,p=-p,g=-g,b=-b,d=-d);let m=1-o;if(d<.9995){let y=Math.acos(d),C=Math.sin(y);m=Math.sin(m*y)/C,o=Math.sin(o*y)/C,l=l*m+u*o,c=c*m+p*o,h=h*m+g*o,f=f*m+b*o}else{l=l*m+u*o,c=c*m+p*o,h=h*m+g*o,f=f*m+b*o;let y=1/Math.sqrt(l*l+c*c+h*h+f*f);l*=y,c*=y,h*=y,f*=y}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=f}static multiplyQuaternionsFlat(t,e,n,s,r,a){let o=n[s],l=n[s+1],c=n[s+2],h=n[s+3],f=r[a],u=r[a+1],p=r[a+2],g=r[a+3];return t[e]=o*g+h*f+l*p-c*u,t[e+1]=l*g+h*u+c*f-o*p,t[e+2]=c*g+h*p+o*u-l*f,t[e+3]=h*g-o*f-l*u-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,a=t._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(s/2),f=o(r/2),u=l(n/2),p=l(s/2),g=l(r/2);switch(a){case"XYZ":this._x=u*h*f+c*p*g,this._y=c*p*f-u*h*g,this._z=c*h*g+u*p*f,this._w=c*h*f-u*p*g;break;case"YXZ":this._x=u*h*f+c*p*g,this._y=c*p*f-u*h*g,this._z=c*h*g-u*p*f,this._w=c*h*f+u*p*g;break;case"ZXY":this._x=u*h*f-c*p*g,this._y=c*p*f+u*h*g,this._z=c*h*g+u*p*f,this._w=c*h*f-u*p*g;break;case"ZYX":this._x=u*h*f-c*p*g,this._y=c*p*f+u*h*g,this._z=c*h*g-u*p*f,this._w=c*h*f+u*p*g;break;case"YZX":this._x=u*h*f+c*p*g,this._y=c*p*f+u*h*g,this._z=c*h*g-u*p*f,this._w=c*h*f-u*p*g;break;case"XZY":this._x=u*h*f-c*p*g,this._y=c*p*f-u*h*g,this._z=c*h*g+u*p*f,this._w=c*h*f+u*p*g;break;default:Kt("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],a=e[1],o=e[5],l=e[9],c=e[2],h=e[6],f=e[10],u=n+o+f;if(u>0){let p=.5/Math.sqrt(u+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(a-s)*p}else if(n>o&&n>f){let p=2*Math.sqrt(1+n-o-f);this._w=(h-l)/p,this._x=.25*p,this._y=(s+a)/p,this._z=(r+c)/p}else if(o>f){let p=2*Math.sqrt(1+o-n-f);this._w=(r-c)/p,this._x=(s+a)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+f-n-o);this._w=(a-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ve(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-n*c,this._z=r*h+a*c+n*l-s*o,this._w=a*h-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,a=t._w,o=this.dot(t);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-e;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+a*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},X=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(dm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(dm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,a=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,a=t.y,o=t.z,l=t.w,c=2*(a*s-o*n),h=2*(o*e-r*s),f=2*(r*n-a*e);return this.x=e+l*c+a*f-o*h,this.y=n+l*h+o*c-r*f,this.z=s+l*f+r*h-a*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,a=e.x,o=e.y,l=e.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Ku.copy(this).projectOnVector(t),this.sub(Ku)}reflect(t){return this.sub(Ku.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ve(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ku=new X,dm=new pi,re=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,l,c)}set(t,e,n,s,r,a,o,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=o,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],f=n[7],u=n[2],p=n[5],g=n[8],b=s[0],d=s[3],m=s[6],y=s[1],C=s[4],w=s[7],P=s[2],T=s[5],v=s[8];return r[0]=a*b+o*y+l*P,r[3]=a*d+o*C+l*T,r[6]=a*m+o*w+l*v,r[1]=c*b+h*y+f*P,r[4]=c*d+h*C+f*T,r[7]=c*m+h*w+f*v,r[2]=u*b+p*y+g*P,r[5]=u*d+p*C+g*T,r[8]=u*m+p*w+g*v,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8];return e*a*h-e*o*c-n*r*h+n*o*l+s*r*c-s*a*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],f=h*a-o*c,u=o*l-h*r,p=c*r-a*l,g=e*f+n*u+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/g;return t[0]=f*b,t[1]=(s*c-h*n)*b,t[2]=(o*n-s*a)*b,t[3]=u*b,t[4]=(h*e-s*l)*b,t[5]=(s*r-o*e)*b,t[6]=p*b,t[7]=(n*l-c*e)*b,t[8]=(a*e-n*r)*b,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+t,-s*c,s*l,-s*(-c*a+l*o)+o+e,0,0,1),this}scale(t,e){return Mo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ju.makeScale(t,e)),this}rotate(t){return Mo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ju.makeRotation(-t)),this}translate(t,e){return Mo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ju.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Ju=new re,pm=new re().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),mm=new re().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function kx(){let i={enabled:!0,workingColorSpace:$s,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Le&&(s.r=Ms(s.r),s.g=Ms(s.g),s.b=Ms(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Le&&(s.r=ga(s.r),s.g=ga(s.g),s.b=ga(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Cs?To:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[$s]:{primaries:t,whitePoint:n,transfer:To,toXYZ:pm,fromXYZ:mm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:di},outputColorSpaceConfig:{drawingBufferColorSpace:di}},[di]:{primaries:t,whitePoint:n,transfer:Le,toXYZ:pm,fromXYZ:mm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:di}}}),i}var be=kx();function Ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function ga(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var na,bc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{na===void 0&&(na=Co("canvas")),na.width=t.width,na.height=t.height;let s=na.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=na}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Co("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=Ms(r[a]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Ms(e[n]/255)*255):e[n]=Ms(e[n]);return{data:e,width:t.width,height:t.height}}else return Kt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},zx=0,ya=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:zx++}),this.uuid=Pa(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(ju(s[a].image)):r.push(ju(s[a]))}else r=ju(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function ju(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?bc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Kt("Texture: Unable to serialize Texture."),{})}var Hx=0,Qu=new X,ri=class i extends zi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=es,s=es,r=jn,a=Ts,o=ti,l=vi,c=i.DEFAULT_ANISOTROPY,h=Cs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Hx++}),this.uuid=Pa(),this.name="",this.source=new ya(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new ie(0,0),this.repeat=new ie(1,1),this.center=new ie(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new re,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Qu).x}get height(){return this.source.getSize(Qu).y}get depth(){return this.source.getSize(Qu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Kt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==kf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case vc:t.x=t.x-Math.floor(t.x);break;case es:t.x=t.x<0?0:1;break;case xc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case vc:t.y=t.y-Math.floor(t.y);break;case es:t.y=t.y<0?0:1;break;case xc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ri.DEFAULT_IMAGE=null;ri.DEFAULT_MAPPING=kf;ri.DEFAULT_ANISOTROPY=1;var Ze=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,a=t.elements;return this.x=a[0]*e+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*e+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*e+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*e+a[7]*n+a[11]*s+a[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],f=l[8],u=l[1],p=l[5],g=l[9],b=l[2],d=l[6],m=l[10];if(Math.abs(h-u)<.01&&Math.abs(f-b)<.01&&Math.abs(g-d)<.01){if(Math.abs(h+u)<.1&&Math.abs(f+b)<.1&&Math.abs(g+d)<.1&&Math.abs(c+p+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let C=(c+1)/2,w=(p+1)/2,P=(m+1)/2,T=(h+u)/4,v=(f+b)/4,E=(g+d)/4;return C>w&&C>P?C<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(C),s=T/n,r=v/n):w>P?w<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),n=T/s,r=E/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=v/r,s=E/r),this.set(n,s,r,e),this}let y=Math.sqrt((d-g)*(d-g)+(f-b)*(f-b)+(u-h)*(u-h));return Math.abs(y)<.001&&(y=1),this.x=(d-g)/y,this.y=(f-b)/y,this.z=(u-h)/y,this.w=Math.acos((c+p+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ve(this.x,t.x,e.x),this.y=ve(this.y,t.y,e.y),this.z=ve(this.z,t.z,e.z),this.w=ve(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ve(this.x,t,e),this.y=ve(this.y,t,e),this.z=ve(this.z,t,e),this.w=ve(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ve(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Sc=class extends zi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ze(0,0,t,e),this.scissorTest=!1,this.viewport=new Ze(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ri({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:jn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ya(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},mi=class extends Sc{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},Ro=class extends ri{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=gn,this.minFilter=gn,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Mc=class extends ri{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=gn,this.minFilter=gn,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ke=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,a,o,l,c,h,f,u,p,g,b,d){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,a,o,l,c,h,f,u,p,g,b,d)}set(t,e,n,s,r,a,o,l,c,h,f,u,p,g,b,d){let m=this.elements;return m[0]=t,m[4]=e,m[8]=n,m[12]=s,m[1]=r,m[5]=a,m[9]=o,m[13]=l,m[2]=c,m[6]=h,m[10]=f,m[14]=u,m[3]=p,m[7]=g,m[11]=b,m[15]=d,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/ia.setFromMatrixColumn(t,0).length(),r=1/ia.setFromMatrixColumn(t,1).length(),a=1/ia.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*a,e[9]=n[9]*a,e[10]=n[10]*a,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),f=Math.sin(r);if(t.order==="XYZ"){let u=a*h,p=a*f,g=o*h,b=o*f;e[0]=l*h,e[4]=-l*f,e[8]=c,e[1]=p+g*c,e[5]=u-b*c,e[9]=-o*l,e[2]=b-u*c,e[6]=g+p*c,e[10]=a*l}else if(t.order==="YXZ"){let u=l*h,p=l*f,g=c*h,b=c*f;e[0]=u+b*o,e[4]=g*o-p,e[8]=a*c,e[1]=a*f,e[5]=a*h,e[9]=-o,e[2]=p*o-g,e[6]=b+u*o,e[10]=a*l}else if(t.order==="ZXY"){let u=l*h,p=l*f,g=c*h,b=c*f;e[0]=u-b*o,e[4]=-a*f,e[8]=g+p*o,e[1]=p+g*o,e[5]=a*h,e[9]=b-u*o,e[2]=-a*c,e[6]=o,e[10]=a*l}else if(t.order==="ZYX"){let u=a*h,p=a*f,g=o*h,b=o*f;e[0]=l*h,e[4]=g*c-p,e[8]=u*c+b,e[1]=l*f,e[5]=b*c+u,e[9]=p*c-g,e[2]=-c,e[6]=o*l,e[10]=a*l}else if(t.order==="YZX"){let u=a*l,p=a*c,g=o*l,b=o*c;e[0]=l*h,e[4]=b-u*f,e[8]=g*f+p,e[1]=f,e[5]=a*h,e[9]=-o*h,e[2]=-c*h,e[6]=p*f+g,e[10]=u-b*f}else if(t.order==="XZY"){let u=a*l,p=a*c,g=o*l,b=o*c;e[0]=l*h,e[4]=-f,e[8]=c*h,e[1]=u*f+b,e[5]=a*h,e[9]=p*f-g,e[2]=g*f-p,e[6]=o*h,e[10]=b*f+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Vx,t,Gx)}lookAt(t,e,n){let s=this.elements;return ui.subVectors(t,e),ui.lengthSq()===0&&(ui.z=1),ui.normalize(),Gs.crossVectors(n,ui),Gs.lengthSq()===0&&(Math.abs(n.z)===1?ui.x+=1e-4:ui.z+=1e-4,ui.normalize(),Gs.crossVectors(n,ui)),Gs.normalize(),Bl.crossVectors(ui,Gs),s[0]=Gs.x,s[4]=Bl.x,s[8]=ui.x,s[1]=Gs.y,s[5]=Bl.y,s[9]=ui.y,s[2]=Gs.z,s[6]=Bl.z,s[10]=ui.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],f=n[5],u=n[9],p=n[13],g=n[2],b=n[6],d=n[10],m=n[14],y=n[3],C=n[7],w=n[11],P=n[15],T=s[0],v=s[4],E=s[8],z=s[12],U=s[1],N=s[5],W=s[9],G=s[13],D=s[2],V=s[6],K=s[10],H=s[14],ht=s[3],J=s[7],Q=s[11],rt=s[15];return r[0]=a*T+o*U+l*D+c*ht,r[4]=a*v+o*N+l*V+c*J,r[8]=a*E+o*W+l*K+c*Q,r[12]=a*z+o*G+l*H+c*rt,r[1]=h*T+f*U+u*D+p*ht,r[5]=h*v+f*N+u*V+p*J,r[9]=h*E+f*W+u*K+p*Q,r[13]=h*z+f*G+u*H+p*rt,r[2]=g*T+b*U+d*D+m*ht,r[6]=g*v+b*N+d*V+m*J,r[10]=g*E+b*W+d*K+m*Q,r[14]=g*z+b*G+d*H+m*rt,r[3]=y*T+C*U+w*D+P*ht,r[7]=y*v+C*N+w*V+P*J,r[11]=y*E+C*W+w*K+P*Q,r[15]=y*z+C*G+w*H+P*rt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],a=t[1],o=t[5],l=t[9],c=t[13],h=t[2],f=t[6],u=t[10],p=t[14],g=t[3],b=t[7],d=t[11],m=t[15],y=l*p-c*u,C=o*p-c*f,w=o*u-l*f,P=a*p-c*h,T=a*u-l*h,v=a*f-o*h;return e*(b*y-d*C+m*w)-n*(g*y-d*P+m*T)+s*(g*C-b*P+m*v)-r*(g*w-b*T+d*v)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],a=t[5],o=t[9],l=t[2],c=t[6],h=t[10];return e*(a*h-o*c)-n*(r*h-o*l)+s*(r*c-a*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],a=t[4],o=t[5],l=t[6],c=t[7],h=t[8],f=t[9],u=t[10],p=t[11],g=t[12],b=t[13],d=t[14],m=t[15],y=e*o-n*a,C=e*l-s*a,w=e*c-r*a,P=n*l-s*o,T=n*c-r*o,v=s*c-r*l,E=h*b-f*g,z=h*d-u*g,U=h*m-p*g,N=f*d-u*b,W=f*m-p*b,G=u*m-p*d,D=y*G-C*W+w*N+P*U-T*z+v*E;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return t[0]=(o*G-l*W+c*N)*V,t[1]=(s*W-n*G-r*N)*V,t[2]=(b*v-d*T+m*P)*V,t[3]=(u*T-f*v-p*P)*V,t[4]=(l*U-a*G-c*z)*V,t[5]=(e*G-s*U+r*z)*V,t[6]=(d*w-g*v-m*C)*V,t[7]=(h*v-u*w+p*C)*V,t[8]=(a*W-o*U+c*E)*V,t[9]=(n*U-e*W-r*E)*V,t[10]=(g*T-b*w+m*y)*V,t[11]=(f*w-h*T-p*y)*V,t[12]=(o*z-a*N-l*E)*V,t[13]=(e*N-n*z+s*E)*V,t[14]=(b*C-g*P-d*y)*V,t[15]=(h*P-f*C+u*y)*V,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,a=t.x,o=t.y,l=t.z,c=r*a,h=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+n,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,a){return this.set(1,n,r,0,t,1,a,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,a=e._y,o=e._z,l=e._w,c=r+r,h=a+a,f=o+o,u=r*c,p=r*h,g=r*f,b=a*h,d=a*f,m=o*f,y=l*c,C=l*h,w=l*f,P=n.x,T=n.y,v=n.z;return s[0]=(1-(b+m))*P,s[1]=(p+w)*P,s[2]=(g-C)*P,s[3]=0,s[4]=(p-w)*T,s[5]=(1-(u+m))*T,s[6]=(d+y)*T,s[7]=0,s[8]=(g+C)*v,s[9]=(d-y)*v,s[10]=(1-(u+b))*v,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let a=ia.set(s[0],s[1],s[2]).length(),o=ia.set(s[4],s[5],s[6]).length(),l=ia.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Oi.copy(this);let c=1/a,h=1/o,f=1/l;return Oi.elements[0]*=c,Oi.elements[1]*=c,Oi.elements[2]*=c,Oi.elements[4]*=h,Oi.elements[5]*=h,Oi.elements[6]*=h,Oi.elements[8]*=f,Oi.elements[9]*=f,Oi.elements[10]*=f,e.setFromRotationMatrix(Oi),n.x=a,n.y=o,n.z=l,this}makePerspective(t,e,n,s,r,a,o=Ri,l=!1){let c=this.elements,h=2*r/(e-t),f=2*r/(n-s),u=(e+t)/(e-t),p=(n+s)/(n-s),g,b;if(l)g=r/(a-r),b=a*r/(a-r);else if(o===Ri)g=-(a+r)/(a-r),b=-2*a*r/(a-r);else if(o===Ao)g=-a/(a-r),b=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=f,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,a,o=Ri,l=!1){let c=this.elements,h=2/(e-t),f=2/(n-s),u=-(e+t)/(e-t),p=-(n+s)/(n-s),g,b;if(l)g=1/(a-r),b=a/(a-r);else if(o===Ri)g=-2/(a-r),b=-(a+r)/(a-r);else if(o===Ao)g=-1/(a-r),b=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=f,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},ia=new X,Oi=new ke,Vx=new X(0,0,0),Gx=new X(1,1,1),Gs=new X,Bl=new X,ui=new X,gm=new ke,_m=new pi,Zs=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],f=s[2],u=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(ve(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ve(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(ve(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-f,p),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ve(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(u,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(ve(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,p));break;case"XZY":this._z=Math.asin(-ve(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:Kt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return gm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(gm,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return _m.setFromEuler(this),this.setFromQuaternion(_m,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Zs.DEFAULT_ORDER="XYZ";var ba=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Wx=0,vm=new X,sa=new pi,gs=new ke,kl=new X,vo=new X,Xx=new X,qx=new pi,xm=new X(1,0,0),ym=new X(0,1,0),bm=new X(0,0,1),Sm={type:"added"},Yx={type:"removed"},ra={type:"childadded",child:null},tf={type:"childremoved",child:null},gi=class i extends zi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Wx++}),this.uuid=Pa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new X,e=new Zs,n=new pi,s=new X(1,1,1);function r(){n.setFromEuler(e,!1)}function a(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ke},normalMatrix:{value:new re}}),this.matrix=new ke,this.matrixWorld=new ke,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ba,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return sa.setFromAxisAngle(t,e),this.quaternion.multiply(sa),this}rotateOnWorldAxis(t,e){return sa.setFromAxisAngle(t,e),this.quaternion.premultiply(sa),this}rotateX(t){return this.rotateOnAxis(xm,t)}rotateY(t){return this.rotateOnAxis(ym,t)}rotateZ(t){return this.rotateOnAxis(bm,t)}translateOnAxis(t,e){return vm.copy(t).applyQuaternion(this.quaternion),this.position.add(vm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(xm,t)}translateY(t){return this.translateOnAxis(ym,t)}translateZ(t){return this.translateOnAxis(bm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(gs.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?kl.copy(t):kl.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),vo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?gs.lookAt(vo,kl,this.up):gs.lookAt(kl,vo,this.up),this.quaternion.setFromRotationMatrix(gs),s&&(gs.extractRotation(s.matrixWorld),sa.setFromRotationMatrix(gs),this.quaternion.premultiply(sa.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ne("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Sm),ra.child=t,this.dispatchEvent(ra),ra.child=null):ne("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Yx),tf.child=t,this.dispatchEvent(tf),tf.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),gs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),gs.multiply(t.parent.matrixWorld)),t.applyMatrix4(gs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Sm),ra.child=t,this.dispatchEvent(ra),ra.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(t,e);if(a!==void 0)return a}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(vo,t,Xx),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(vo,qx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let f=l[c];r(t.shapes,f)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(t.materials,this.material[l]));s.material=o}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(t.animations,l))}}if(e){let o=a(t.geometries),l=a(t.materials),c=a(t.textures),h=a(t.images),f=a(t.shapes),u=a(t.skeletons),p=a(t.animations),g=a(t.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),f.length>0&&(n.shapes=f),u.length>0&&(n.skeletons=u),p.length>0&&(n.animations=p),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};gi.DEFAULT_UP=new X(0,1,0);gi.DEFAULT_MATRIX_AUTO_UPDATE=!0;gi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ss=class extends gi{constructor(){super(),this.isGroup=!0,this.type="Group"}},$x={type:"move"},Sa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ss,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ss,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new X,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new X),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ss,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new X,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new X,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){a=!0;for(let b of t.hand.values()){let d=e.getJointPose(b,n),m=this._getHandJoint(c,b);d!==null&&(m.matrix.fromArray(d.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=d.radius),m.visible=d!==null}let h=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],u=h.position.distanceTo(f.position),p=.02,g=.005;c.inputState.pinching&&u>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent($x)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ss;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},wg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ws={h:0,s:0,l:0},zl={h:0,s:0,l:0};function ef(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Se=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=di){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,be.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=be.workingColorSpace){return this.r=t,this.g=e,this.b=n,be.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=be.workingColorSpace){if(t=Qf(t,1),e=ve(e,0,1),n=ve(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,a=2*n-r;this.r=ef(a,r,t+1/3),this.g=ef(a,r,t),this.b=ef(a,r,t-1/3)}return be.colorSpaceToWorking(this,s),this}setStyle(t,e=di){function n(r){r!==void 0&&parseFloat(r)<1&&Kt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Kt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(a===6)return this.setHex(parseInt(r,16),e);Kt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=di){let n=wg[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Kt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ms(t.r),this.g=Ms(t.g),this.b=Ms(t.b),this}copyLinearToSRGB(t){return this.r=ga(t.r),this.g=ga(t.g),this.b=ga(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=di){return be.workingToColorSpace(zn.copy(this),t),Math.round(ve(zn.r*255,0,255))*65536+Math.round(ve(zn.g*255,0,255))*256+Math.round(ve(zn.b*255,0,255))}getHexString(t=di){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=be.workingColorSpace){be.workingToColorSpace(zn.copy(this),e);let n=zn.r,s=zn.g,r=zn.b,a=Math.max(n,s,r),o=Math.min(n,s,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let f=a-o;switch(c=h<=.5?f/(a+o):f/(2-a-o),a){case n:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-n)/f+2;break;case r:l=(n-s)/f+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=be.workingColorSpace){return be.workingToColorSpace(zn.copy(this),e),t.r=zn.r,t.g=zn.g,t.b=zn.b,t}getStyle(t=di){be.workingToColorSpace(zn.copy(this),t);let e=zn.r,n=zn.g,s=zn.b;return t!==di?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ws),this.setHSL(Ws.h+t,Ws.s+e,Ws.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ws),t.getHSL(zl);let n=wo(Ws.h,zl.h,e),s=wo(Ws.s,zl.s,e),r=wo(Ws.l,zl.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new Se;Se.NAMES=wg;var Po=class extends gi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Zs,this.environmentIntensity=1,this.environmentRotation=new Zs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Bi=new X,_s=new X,nf=new X,vs=new X,aa=new X,oa=new X,Mm=new X,sf=new X,rf=new X,af=new X,of=new Ze,lf=new Ze,cf=new Ze,bs=class i{constructor(t=new X,e=new X,n=new X){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Bi.subVectors(t,e),s.cross(Bi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Bi.subVectors(s,e),_s.subVectors(n,e),nf.subVectors(t,e);let a=Bi.dot(Bi),o=Bi.dot(_s),l=Bi.dot(nf),c=_s.dot(_s),h=_s.dot(nf),f=a*c-o*o;if(f===0)return r.set(0,0,0),null;let u=1/f,p=(c*l-o*h)*u,g=(a*h-o*l)*u;return r.set(1-p-g,g,p)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,vs)===null?!1:vs.x>=0&&vs.y>=0&&vs.x+vs.y<=1}static getInterpolation(t,e,n,s,r,a,o,l){return this.getBarycoord(t,e,n,s,vs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,vs.x),l.addScaledVector(a,vs.y),l.addScaledVector(o,vs.z),l)}static getInterpolatedAttribute(t,e,n,s,r,a){return of.setScalar(0),lf.setScalar(0),cf.setScalar(0),of.fromBufferAttribute(t,e),lf.fromBufferAttribute(t,n),cf.fromBufferAttribute(t,s),a.setScalar(0),a.addScaledVector(of,r.x),a.addScaledVector(lf,r.y),a.addScaledVector(cf,r.z),a}static isFrontFacing(t,e,n,s){return Bi.subVectors(n,e),_s.subVectors(t,e),Bi.cross(_s).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Bi.subVectors(this.c,this.b),_s.subVectors(this.a,this.b),Bi.cross(_s).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,a,o;aa.subVectors(s,n),oa.subVectors(r,n),sf.subVectors(t,n);let l=aa.dot(sf),c=oa.dot(sf);if(l<=0&&c<=0)return e.copy(n);rf.subVectors(t,s);let h=aa.dot(rf),f=oa.dot(rf);if(h>=0&&f<=h)return e.copy(s);let u=l*f-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),e.copy(n).addScaledVector(aa,a);af.subVectors(t,r);let p=aa.dot(af),g=oa.dot(af);if(g>=0&&p<=g)return e.copy(r);let b=p*c-l*g;if(b<=0&&c>=0&&g<=0)return o=c/(c-g),e.copy(n).addScaledVector(oa,o);let d=h*g-p*f;if(d<=0&&f-h>=0&&p-g>=0)return Mm.subVectors(r,s),o=(f-h)/(f-h+(p-g)),e.copy(s).addScaledVector(Mm,o);let m=1/(d+b+u);return a=b*m,o=u*m,e.copy(n).addScaledVector(aa,a).addScaledVector(oa,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Pi=class{constructor(t=new X(1/0,1/0,1/0),e=new X(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(ki.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(ki.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=ki.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)t.isMesh===!0?t.getVertexPosition(a,ki):ki.fromBufferAttribute(r,a),ki.applyMatrix4(t.matrixWorld),this.expandByPoint(ki);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Hl.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Hl.copy(n.boundingBox)),Hl.applyMatrix4(t.matrixWorld),this.union(Hl)}let s=t.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ki),ki.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(xo),Vl.subVectors(this.max,xo),la.subVectors(t.a,xo),ca.subVectors(t.b,xo),ha.subVectors(t.c,xo),Xs.subVectors(ca,la),qs.subVectors(ha,ca),gr.subVectors(la,ha);let e=[0,-Xs.z,Xs.y,0,-qs.z,qs.y,0,-gr.z,gr.y,Xs.z,0,-Xs.x,qs.z,0,-qs.x,gr.z,0,-gr.x,-Xs.y,Xs.x,0,-qs.y,qs.x,0,-gr.y,gr.x,0];return!hf(e,la,ca,ha,Vl)||(e=[1,0,0,0,1,0,0,0,1],!hf(e,la,ca,ha,Vl))?!1:(Gl.crossVectors(Xs,qs),e=[Gl.x,Gl.y,Gl.z],hf(e,la,ca,ha,Vl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ki).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ki).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(xs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),xs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),xs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),xs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),xs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),xs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),xs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),xs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(xs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},xs=[new X,new X,new X,new X,new X,new X,new X,new X],ki=new X,Hl=new Pi,la=new X,ca=new X,ha=new X,Xs=new X,qs=new X,gr=new X,xo=new X,Vl=new X,Gl=new X,_r=new X;function hf(i,t,e,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){_r.fromArray(i,r);let o=s.x*Math.abs(_r.x)+s.y*Math.abs(_r.y)+s.z*Math.abs(_r.z),l=t.dot(_r),c=e.dot(_r),h=n.dot(_r);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var mn=new X,Wl=new ie,Zx=0,Un=class extends zi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Zx++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=_g,this.updateRanges=[],this.gpuType=xi,this.version=0,this._normalizationScale=t!==void 0?ed(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Wl.fromBufferAttribute(this,e),Wl.applyMatrix3(t),this.setXY(e,Wl.x,Wl.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Sg(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Mg(t,this.array)}};var Io=class extends Un{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Lo=class extends Un{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Jn=class extends Un{constructor(t,e,n){super(new Float32Array(t),e,n)}},Kx=new Pi,yo=new X,uf=new X,yr=class{constructor(t=new X,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Kx.setFromPoints(t).getCenter(n);let s=0;for(let r=0,a=t.length;r<a;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;yo.subVectors(t,this.center);let e=yo.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(yo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(uf.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(yo.copy(t.center).add(uf)),this.expandByPoint(yo.copy(t.center).sub(uf))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Jx=0,Ci=new ke,ff=new gi,ua=new X,fi=new Pi,bo=new Pi,Dn=new X,Fn=class i extends zi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Jx++}),this.uuid=Pa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Sx(t)?Lo:Io)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new re().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ci.makeRotationFromQuaternion(t),this.applyMatrix4(Ci),this}rotateX(t){return Ci.makeRotationX(t),this.applyMatrix4(Ci),this}rotateY(t){return Ci.makeRotationY(t),this.applyMatrix4(Ci),this}rotateZ(t){return Ci.makeRotationZ(t),this.applyMatrix4(Ci),this}translate(t,e,n){return Ci.makeTranslation(t,e,n),this.applyMatrix4(Ci),this}scale(t,e,n){return Ci.makeScale(t,e,n),this.applyMatrix4(Ci),this}lookAt(t){return ff.lookAt(t),ff.updateMatrix(),this.applyMatrix4(ff.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ua).negate(),this.translate(ua.x,ua.y,ua.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let a=t[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new Jn(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Kt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Pi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ne("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new X(-1/0,-1/0,-1/0),new X(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,fi.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,fi.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(fi.min),this.boundingBox.expandByPoint(fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ne('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new yr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ne("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new X,1/0);return}if(t){let n=this.boundingSphere.center;if(fi.setFromBufferAttribute(t),e)for(let r=0,a=e.length;r<a;r++){let o=e[r];bo.setFromBufferAttribute(o),this.morphTargetsRelative?(Dn.addVectors(fi.min,bo.min),fi.expandByPoint(Dn),Dn.addVectors(fi.max,bo.max),fi.expandByPoint(Dn)):(fi.expandByPoint(bo.min),fi.expandByPoint(bo.max))}fi.getCenter(n);let s=0;for(let r=0,a=t.count;r<a;r++)Dn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Dn));if(e)for(let r=0,a=e.length;r<a;r++){let o=e[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)Dn.fromBufferAttribute(o,c),l&&(ua.fromBufferAttribute(t,c),Dn.add(ua)),s=Math.max(s,n.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ne('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ne("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new Un(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(n.count);for(let z=0;z<n.count;z++)o[z]=new X,l[z]=new X;let h=new X,f=new X,u=new X,p=new ie,g=new ie,b=new ie,d=new X,m=new X;function y(z,U,N){c[z]=c[U]=c[N]=1,h.fromBufferAttribute(n,z),f.fromBufferAttribute(n,U),u.fromBufferAttribute(n,N),p.fromBufferAttribute(r,z),g.fromBufferAttribute(r,U),b.fromBufferAttribute(r,N),f.sub(h),u.sub(h),g.sub(p),b.sub(p);let W=1/(g.x*b.y-b.x*g.y);isFinite(W)&&(d.copy(f).multiplyScalar(b.y).addScaledVector(u,-g.y).multiplyScalar(W),m.copy(u).multiplyScalar(g.x).addScaledVector(f,-b.x).multiplyScalar(W),o[z].add(d),o[U].add(d),o[N].add(d),l[z].add(m),l[U].add(m),l[N].add(m))}let C=this.groups;C.length===0&&(C=[{start:0,count:t.count}]);for(let z=0,U=C.length;z<U;++z){let N=C[z],W=N.start,G=N.count;for(let D=W,V=W+G;D<V;D+=3)y(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let w=new X,P=new X,T=new X,v=new X;function E(z){T.fromBufferAttribute(s,z),v.copy(T);let U=o[z];w.copy(U),w.sub(T.multiplyScalar(T.dot(U))).normalize(),P.crossVectors(v,U);let W=P.dot(l[z])<0?-1:1;a.setXYZW(z,w.x,w.y,w.z,W)}for(let z=0,U=n.count;z<U;++z)c[z]&&E(z);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Un(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,p=n.count;u<p;u++)n.setXYZ(u,0,0,0);let s=new X,r=new X,a=new X,o=new X,l=new X,c=new X,h=new X,f=new X;if(t)for(let u=0,p=t.count;u<p;u+=3){let g=t.getX(u+0),b=t.getX(u+1),d=t.getX(u+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,b),a.fromBufferAttribute(e,d),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),o.fromBufferAttribute(n,g),l.fromBufferAttribute(n,b),c.fromBufferAttribute(n,d),o.add(h),l.add(h),c.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(b,l.x,l.y,l.z),n.setXYZ(d,c.x,c.y,c.z)}else for(let u=0,p=e.count;u<p;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),a.fromBufferAttribute(e,u+2),h.subVectors(a,r),f.subVectors(s,r),h.cross(f),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Dn.fromBufferAttribute(t,e),Dn.normalize(),t.setXYZ(e,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function t(o,l){let c=o.array,h=o.itemSize,f=o.normalized,u=new c.constructor(l.length*h),p=0,g=0;for(let b=0,d=l.length;b<d;b++){o.isInterleavedBufferAttribute?p=l[b]*o.data.stride+o.offset:p=l[b]*h;for(let m=0;m<h;m++)u[g++]=c[p++]}return new Un(u,h,f)}if(this.index===null)return Kt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=t(l,n);e.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,f=c.length;h<f;h++){let u=c[h],p=t(u,n);l.push(p)}e.morphAttributes[o]=l}e.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let f=0,u=c.length;f<u;f++){let p=c[f];h.push(p.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(t.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],f=r[c];for(let u=0,p=f.length;u<p;u++)h.push(f[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let a=t.groups;for(let c=0,h=a.length;c<h;c++){let f=a[c];this.addGroup(f.start,f.count,f.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var df=new X,jx=new X,Qx=new re,Zn=class{constructor(t=new X(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=df.subVectors(n,e).cross(jx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(df),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let a=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:e.copy(t.start).addScaledVector(s,a)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Qx.getNormalMatrix(t),s=this.coplanarPoint(df).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},ty=0,Ks=class extends zi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:ty++}),this.uuid=Pa(),this.name="",this.type="Material",this.blending=Aa,this.side=sr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Rf,this.blendDst=Pf,this.blendEquation=Mr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Se(0,0,0),this.blendAlpha=0,this.depthFunc=_a,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ug,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=hc,this.stencilZFail=hc,this.stencilZPass=hc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Kt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Kt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(e){let r=s(t.textures),a=s(t.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Se().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Zn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new ie().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ie().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ys=new X,pf=new X,Xl=new X,ql=new X,Js=class{constructor(t=new X,e=new X(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ys)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ys.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ys.copy(this.origin).addScaledVector(this.direction,e),ys.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){pf.copy(t).add(e).multiplyScalar(.5),Xl.copy(e).sub(t).normalize(),ql.copy(this.origin).sub(pf);let r=t.distanceTo(e)*.5,a=-this.direction.dot(Xl),o=ql.dot(this.direction),l=-ql.dot(Xl),c=ql.lengthSq(),h=Math.abs(1-a*a),f,u,p,g;if(h>0)if(f=a*l-o,u=a*o-l,g=r*h,f>=0)if(u>=-g)if(u<=g){let b=1/h;f*=b,u*=b,p=f*(f+a*u+2*o)+u*(a*f+u+2*l)+c}else u=r,f=Math.max(0,-(a*u+o)),p=-f*f+u*(u+2*l)+c;else u=-r,f=Math.max(0,-(a*u+o)),p=-f*f+u*(u+2*l)+c;else u<=-g?(f=Math.max(0,-(-a*r+o)),u=f>0?-r:Math.min(Math.max(-r,-l),r),p=-f*f+u*(u+2*l)+c):u<=g?(f=0,u=Math.min(Math.max(-r,-l),r),p=u*(u+2*l)+c):(f=Math.max(0,-(a*r+o)),u=f>0?r:Math.min(Math.max(-r,-l),r),p=-f*f+u*(u+2*l)+c);else u=a>0?-r:r,f=Math.max(0,-(a*u+o)),p=-f*f+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(pf).addScaledVector(Xl,u),p}intersectSphere(t,e){if(t.radius<0)return null;ys.subVectors(t.center,this.origin);let n=ys.dot(this.direction),s=ys.dot(ys)-n*n,r=t.radius*t.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,f=1/this.direction.z,u=this.origin;return c>=0?(n=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(n=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,a=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,a=(t.min.y-u.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(t.min.z-u.z)*f,l=(t.max.z-u.z)*f):(o=(t.max.z-u.z)*f,l=(t.min.z-u.z)*f),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,ys)!==null}intersectTriangle(t,e,n,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,f=t.x-a.x,u=t.y-a.y,p=t.z-a.z,g=e.x-a.x,b=e.y-a.y,d=e.z-a.z,m=n.x-a.x,y=n.y-a.y,C=n.z-a.z,w=Math.abs(l),P=Math.abs(c),T=Math.abs(h),v,E,z,U,N,W,G,D,V,K,H,ht;if(w>=P&&w>=T?(z=l,W=f,V=g,ht=m,l>=0?(v=c,E=h,U=u,N=p,G=b,D=d,K=y,H=C):(v=h,E=c,U=p,N=u,G=d,D=b,K=C,H=y)):P>=T?(z=c,W=u,V=b,ht=y,c>=0?(v=h,E=l,U=p,N=f,G=d,D=g,K=C,H=m):(v=l,E=h,U=f,N=p,G=g,D=d,K=m,H=C)):(z=h,W=p,V=d,ht=C,h>=0?(v=l,E=c,U=f,N=u,G=g,D=b,K=m,H=y):(v=c,E=l,U=u,N=f,G=b,D=g,K=y,H=m)),z===0)return null;let J=v/z,Q=E/z,rt=1/z,dt=U-J*W,ft=N-Q*W,tt=G-J*V,gt=D-Q*V,xt=K-J*ht,Ct=H-Q*ht,Mt=xt*gt-Ct*tt,Yt=dt*Ct-ft*xt,le=tt*ft-gt*dt;if(s){if(Mt<0||Yt<0||le<0)return null}else if((Mt<0||Yt<0||le<0)&&(Mt>0||Yt>0||le>0))return null;let Xt=Mt+Yt+le;if(Xt===0)return null;let me=rt*(Mt*W+Yt*V+le*ht);return(Xt>0?me<0:me>0)?null:this.at(me/Xt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},wc=class extends Ks{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Se(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Zs,this.combine=If,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},wm=new ke,vr=new Js,Yl=new yr,Em=new X,$l=new X,Zl=new X,Kl=new X,mf=new X,Jl=new X,Tm=new X,jl=new X,Hn=class extends gi{constructor(t=new Fn,e=new wc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let o=this.morphTargetInfluences;if(r&&o){Jl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],f=r[l];h!==0&&(mf.fromBufferAttribute(f,t),a?Jl.addScaledVector(mf,h):Jl.addScaledVector(mf.sub(e),h))}e.add(Jl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Yl.copy(n.boundingSphere),Yl.applyMatrix4(r),vr.copy(t.ray).recast(t.near),!(Yl.containsPoint(vr.origin)===!1&&(vr.intersectSphere(Yl,Em)===null||vr.origin.distanceToSquared(Em)>(t.far-t.near)**2))&&(wm.copy(r).invert(),vr.copy(t.ray).applyMatrix4(wm),!(n.boundingBox!==null&&vr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,vr)))}_computeIntersections(t,e,n){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,f=r.attributes.normal,u=r.groups,p=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,b=u.length;g<b;g++){let d=u[g],m=a[d.materialIndex],y=Math.max(d.start,p.start),C=Math.min(o.count,Math.min(d.start+d.count,p.start+p.count));for(let w=y,P=C;w<P;w+=3){let T=o.getX(w),v=o.getX(w+1),E=o.getX(w+2);s=Ql(this,m,t,n,c,h,f,T,v,E),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=d.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),b=Math.min(o.count,p.start+p.count);for(let d=g,m=b;d<m;d+=3){let y=o.getX(d),C=o.getX(d+1),w=o.getX(d+2);s=Ql(this,a,t,n,c,h,f,y,C,w),s&&(s.faceIndex=Math.floor(d/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let g=0,b=u.length;g<b;g++){let d=u[g],m=a[d.materialIndex],y=Math.max(d.start,p.start),C=Math.min(l.count,Math.min(d.start+d.count,p.start+p.count));for(let w=y,P=C;w<P;w+=3){let T=w,v=w+1,E=w+2;s=Ql(this,m,t,n,c,h,f,T,v,E),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=d.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),b=Math.min(l.count,p.start+p.count);for(let d=g,m=b;d<m;d+=3){let y=d,C=d+1,w=d+2;s=Ql(this,a,t,n,c,h,f,y,C,w),s&&(s.faceIndex=Math.floor(d/3),e.push(s))}}}};function ey(i,t,e,n,s,r,a,o){let l;if(t.side===Qn?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,t.side===sr,o),l===null)return null;jl.copy(o),jl.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(jl);return c<e.near||c>e.far?null:{distance:c,point:jl.clone(),object:i}}function Ql(i,t,e,n,s,r,a,o,l,c){i.getVertexPosition(o,$l),i.getVertexPosition(l,Zl),i.getVertexPosition(c,Kl);let h=ey(i,t,e,n,$l,Zl,Kl,Tm);if(h){let f=new X;bs.getBarycoord(Tm,$l,Zl,Kl,f),s&&(h.uv=bs.getInterpolatedAttribute(s,o,l,c,f,new ie)),r&&(h.uv1=bs.getInterpolatedAttribute(r,o,l,c,f,new ie)),a&&(h.normal=bs.getInterpolatedAttribute(a,o,l,c,f,new X),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a:o,b:l,c,normal:new X,materialIndex:0};bs.getNormal($l,Zl,Kl,u.normal),h.face=u,h.barycoord=f}return h}var js=class extends ri{constructor(t=null,e=1,n=1,s,r,a,o,l,c=gn,h=gn,f,u){super(null,a,o,l,c,h,s,r,f,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var xr=new yr,ny=new ie(.5,.5),tc=new X,br=class{constructor(t=new Zn,e=new Zn,n=new Zn,s=new Zn,r=new Zn,a=new Zn){this.planes=[t,e,n,s,r,a]}set(t,e,n,s,r,a){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ri,n=!1){let s=this.planes,r=t.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],f=r[5],u=r[6],p=r[7],g=r[8],b=r[9],d=r[10],m=r[11],y=r[12],C=r[13],w=r[14],P=r[15];if(s[0].setComponents(c-a,p-h,m-g,P-y).normalize(),s[1].setComponents(c+a,p+h,m+g,P+y).normalize(),s[2].setComponents(c+o,p+f,m+b,P+C).normalize(),s[3].setComponents(c-o,p-f,m-b,P-C).normalize(),n)s[4].setComponents(l,u,d,w).normalize(),s[5].setComponents(c-l,p-u,m-d,P-w).normalize();else if(s[4].setComponents(c-l,p-u,m-d,P-w).normalize(),e===Ri)s[5].setComponents(c+l,p+u,m+d,P+w).normalize();else if(e===Ao)s[5].setComponents(l,u,d,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),xr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),xr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(xr)}intersectsSprite(t){xr.center.set(0,0,0);let e=ny.distanceTo(t.center);return xr.radius=.7071067811865476+e,xr.applyMatrix4(t.matrixWorld),this.intersectsSphere(xr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(tc.x=s.normal.x>0?t.max.x:t.min.x,tc.y=s.normal.y>0?t.max.y:t.min.y,tc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(tc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Am=new ke,Ec=class i{constructor(){this.coordinateSystem=Ri,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Am.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new br),n[s].setFromProjectionMatrix(Am,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new br),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Tc=class extends Ks{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Se(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ac=new X,Cc=new X,Cm=new ke,So=new Js,ec=new yr,gf=new X,Rm=new X,Rc=class extends gi{constructor(t=new Fn,e=new Tc){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Ac.fromBufferAttribute(e,s-1),Cc.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Ac.distanceTo(Cc);t.setAttribute("lineDistance",new Jn(n,1))}else Kt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ec.copy(n.boundingSphere),ec.applyMatrix4(s),ec.radius+=r,t.ray.intersectsSphere(ec)===!1)return;Cm.copy(s).invert(),So.copy(t.ray).applyMatrix4(Cm);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let p=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let b=p,d=g-1;b<d;b+=c){let m=h.getX(b),y=h.getX(b+1),C=nc(this,t,So,l,m,y,b);C&&e.push(C)}if(this.isLineLoop){let b=h.getX(g-1),d=h.getX(p),m=nc(this,t,So,l,b,d,g-1);m&&e.push(m)}}else{let p=Math.max(0,a.start),g=Math.min(u.count,a.start+a.count);for(let b=p,d=g-1;b<d;b+=c){let m=nc(this,t,So,l,b,b+1,b);m&&e.push(m)}if(this.isLineLoop){let b=nc(this,t,So,l,g-1,p,g-1);b&&e.push(b)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function nc(i,t,e,n,s,r,a){let o=i.geometry.attributes.position;if(Ac.fromBufferAttribute(o,s),Cc.fromBufferAttribute(o,r),e.distanceSqToSegment(Ac,Cc,gf,Rm)>n)return;gf.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(gf);if(!(c<t.near||c>t.far))return{distance:c,point:Rm.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var Pm=new X,Im=new X,Do=class extends Rc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Pm.fromBufferAttribute(e,s),Im.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Pm.distanceTo(Im);t.setAttribute("lineDistance",new Jn(n,1))}else Kt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var No=class extends ri{constructor(t=[],e=wr,n,s,r,a,o,l,c,h){super(t,e,n,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Es=class extends ri{constructor(t,e,n=Hi,s,r,a,o=gn,l=gn,c,h=ws,f=1){if(h!==ws&&h!==As)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:f};super(u,s,r,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ya(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Uo=class extends Es{constructor(t,e=Hi,n=wr,s,r,a=gn,o=gn,l,c=ws){let h={width:t,height:t,depth:1},f=[h,h,h,h,h,h];super(t,t,e,n,s,r,a,o,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Fo=class extends ri{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ma=class i extends Fn{constructor(t=1,e=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],f=[],u=0,p=0;g("z","y","x",-1,-1,n,e,t,a,r,0),g("z","y","x",1,-1,n,e,-t,a,r,1),g("x","z","y",1,1,t,n,e,s,a,2),g("x","z","y",1,-1,t,n,-e,s,a,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Jn(c,3)),this.setAttribute("normal",new Jn(h,3)),this.setAttribute("uv",new Jn(f,2));function g(b,d,m,y,C,w,P,T,v,E,z){let U=w/v,N=P/E,W=w/2,G=P/2,D=T/2,V=v+1,K=E+1,H=0,ht=0,J=new X;for(let Q=0;Q<K;Q++){let rt=Q*N-G;for(let dt=0;dt<V;dt++){let ft=dt*U-W;J[b]=ft*y,J[d]=rt*C,J[m]=D,c.push(J.x,J.y,J.z),J[b]=0,J[d]=0,J[m]=T>0?1:-1,h.push(J.x,J.y,J.z),f.push(dt/v),f.push(1-Q/E),H+=1}}for(let Q=0;Q<E;Q++)for(let rt=0;rt<v;rt++){let dt=u+rt+V*Q,ft=u+rt+V*(Q+1),tt=u+(rt+1)+V*(Q+1),gt=u+(rt+1)+V*Q;l.push(dt,ft,gt),l.push(ft,tt,gt),ht+=6}o.addGroup(p,ht,z),p+=ht,u+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var ic=new X,sc=new X,_f=new X,rc=new bs,Oo=class extends Fn{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(ma*e),a=t.getIndex(),o=t.getAttribute("position"),l=a?a.count:o.count,c=[0,0,0],h=["a","b","c"],f=new Array(3),u=new Map,p=[];for(let g=0;g<l;g+=3){a?(c[0]=a.getX(g),c[1]=a.getX(g+1),c[2]=a.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:b,b:d,c:m}=rc;if(b.fromBufferAttribute(o,c[0]),d.fromBufferAttribute(o,c[1]),m.fromBufferAttribute(o,c[2]),rc.getNormal(_f),f[0]=`${Math.round(b.x*s)},${Math.round(b.y*s)},${Math.round(b.z*s)}`,f[1]=`${Math.round(d.x*s)},${Math.round(d.y*s)},${Math.round(d.z*s)}`,f[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(f[0]===f[1]||f[1]===f[2]||f[2]===f[0]))for(let y=0;y<3;y++){let C=(y+1)%3,w=f[y],P=f[C],T=rc[h[y]],v=rc[h[C]],E=`${w}_${P}`,z=`${P}_${w}`,U=u.get(z);U?(_f.dot(U.normal)<=r&&(p.push(T.x,T.y,T.z),p.push(v.x,v.y,v.z)),u.set(z,null)):u.has(E)||u.set(E,{index0:c[y],index1:c[C],normal:_f.clone()})}}for(let g of u.values())if(g){let{index0:b,index1:d}=g;ic.fromBufferAttribute(o,b),sc.fromBufferAttribute(o,d),p.push(ic.x,ic.y,ic.z),p.push(sc.x,sc.y,sc.z)}this.setAttribute("position",new Jn(p,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var Bo=class i extends Fn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,a=e/2,o=Math.floor(n),l=Math.floor(s),c=o+1,h=l+1,f=t/o,u=e/l,p=[],g=[],b=[],d=[];for(let m=0;m<h;m++){let y=m*u-a;for(let C=0;C<c;C++){let w=C*f-r;g.push(w,-y,0),b.push(0,0,1),d.push(C/o),d.push(1-m/l)}}for(let m=0;m<l;m++)for(let y=0;y<o;y++){let C=y+c*m,w=y+c*(m+1),P=y+1+c*(m+1),T=y+1+c*m;p.push(C,w,T),p.push(w,P,T)}this.setIndex(p),this.setAttribute("position",new Jn(g,3)),this.setAttribute("normal",new Jn(b,3)),this.setAttribute("uv",new Jn(d,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};function Tr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Lm(s))s.isRenderTargetTexture?(Kt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Lm(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Vn(i){let t={};for(let e=0;e<i.length;e++){let n=Tr(i[e]);for(let s in n)t[s]=n[s]}return t}function Lm(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function iy(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function id(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:be.workingColorSpace}var Eg={clone:Tr,merge:Vn},sy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,ry=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,On=class extends Ks{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=sy,this.fragmentShader=ry,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Tr(t.uniforms),this.uniformsGroups=iy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?e.uniforms[s]={type:"t",value:a.toJSON(t).uuid}:a&&a.isColor?e.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?e.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?e.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?e.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?e.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?e.uniforms[s]={type:"m4",value:a.toArray()}:e.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Se().setHex(s.value);break;case"v2":this.uniforms[n].value=new ie().fromArray(s.value);break;case"v3":this.uniforms[n].value=new X().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Ze().fromArray(s.value);break;case"m3":this.uniforms[n].value=new re().fromArray(s.value);break;case"m4":this.uniforms[n].value=new ke().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Pc=class extends On{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ic=class extends Ks{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=cg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Lc=class extends Ks{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function fa(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function ac(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Qs=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let a;e:{i:if(!(t<s)){for(let o=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=e[++n],t<s)break t}a=e.length;break e}if(!(t>=r)){let o=e[1];t<o&&(n=2,r=o);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}a=n,n=0;break e}break n}for(;n<a;){let o=n+a>>>1;t<e[o]?a=o:n=o+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let a=0;a!==s;++a)e[a]=n[r+a];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Dc=class extends Qs{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:xf,endingEnd:xf}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,a=t+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case yf:r=t,o=2*e-n;break;case bf:r=s.length-2,o=e+s[r]-s[r+1];break;default:r=t,o=n}if(l===void 0)switch(this.getSettings_().endingEnd){case yf:a=t,l=2*n-e;break;case bf:a=1,l=n+s[1]-s[0];break;default:a=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-o),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=this._offsetPrev,f=this._offsetNext,u=this._weightPrev,p=this._weightNext,g=(n-e)/(s-e),b=g*g,d=b*g,m=-u*d+2*u*b-u*g,y=(1+u)*d+(-1.5-2*u)*b+(-.5+u)*g+1,C=(-1-p)*d+(1.5+p)*b+.5*g,w=p*d-p*b;for(let P=0;P!==o;++P)r[P]=m*a[h+P]+y*a[c+P]+C*a[l+P]+w*a[f+P];return r}},Nc=class extends Qs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=(n-e)/(s-e),f=1-h;for(let u=0;u!==o;++u)r[u]=a[c+u]*f+a[l+u]*h;return r}},Uc=class extends Qs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Fc=class extends Qs{interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=t*o,c=l-o,h=this.inTangents,f=this.outTangents;if(!h||!f){let g=(n-e)/(s-e),b=1-g;for(let d=0;d!==o;++d)r[d]=a[c+d]*b+a[l+d]*g;return r}let u=o*2,p=t-1;for(let g=0;g!==o;++g){let b=a[c+g],d=a[l+g],m=p*u+g*2,y=f[m],C=f[m+1],w=t*u+g*2,P=h[w],T=h[w+1],v=oy(n,e,y,P,s);r[g]=Tg(v,b,C,T,d)}return r}};function Tg(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function ay(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function oy(i,t,e,n,s){let r=(i-t)/(s-t);for(let a=0;a<8;a++){let o=Tg(r,t,e,n,s)-i;if(Math.abs(o)<1e-10)break;let l=ay(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var _i=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=fa(e,this.TimeBufferType),this.values=fa(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:fa(t.times,Array),values:fa(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),ac(t.settings)&&(n.settings={inTangents:fa(t.settings.inTangents,Array),outTangents:fa(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Uc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Nc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Dc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Fc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Eo:e=this.InterpolantFactoryMethodDiscrete;break;case yc:e=this.InterpolantFactoryMethodLinear;break;case cc:e=this.InterpolantFactoryMethodSmooth;break;case vf:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Kt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Eo;case this.InterpolantFactoryMethodLinear:return yc;case this.InterpolantFactoryMethodSmooth:return cc;case this.InterpolantFactoryMethodBezier:return vf}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;ac(this.settings)&&(Dm(this.settings.inTangents,t),Dm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;ac(this.settings)&&(Nm(this.settings.inTangents,t),Nm(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<t;)++r;for(;a!==-1&&n[a]>e;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ne("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ne("KeyframeTrack: Track is empty.",this),t=!1);let a=null;for(let o=0;o!==r;o++){let l=n[o];if(typeof l=="number"&&isNaN(l)){ne("KeyframeTrack: Time is not a valid number.",this,o,l),t=!1;break}if(a!==null&&a>l){ne("KeyframeTrack: Out of order keys.",this,o,l,a),t=!1;break}a=l}if(s!==void 0&&Mx(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){ne("KeyframeTrack: Value is not a valid number.",this,o,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===cc,r=t.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=t[o],h=t[o+1];if(c!==h&&(o!==1||c!==t[0]))if(s)l=!0;else{let f=o*n,u=f-n,p=f+n;for(let g=0;g!==n;++g){let b=e[f+g];if(b!==e[u+g]||b!==e[p+g]){l=!0;break}}}if(l){if(o!==a){t[a]=t[o];let f=o*n,u=a*n;for(let p=0;p!==n;++p)e[u+p]=e[f+p]}++a}}if(r>0){t[a]=t[r];for(let o=r*n,l=a*n,c=0;c!==n;++c)e[l+c]=e[o+c];++a}return a!==t.length?(this.times=t.slice(0,a),this.values=e.slice(0,a*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,ac(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Dm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Nm(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}_i.prototype.ValueTypeName="";_i.prototype.TimeBufferType=Float32Array;_i.prototype.ValueBufferType=Float32Array;_i.prototype.DefaultInterpolation=yc;var tr=class extends _i{constructor(t,e,n){super(t,e,n)}};tr.prototype.ValueTypeName="bool";tr.prototype.ValueBufferType=Array;tr.prototype.DefaultInterpolation=Eo;tr.prototype.InterpolantFactoryMethodLinear=void 0;tr.prototype.InterpolantFactoryMethodSmooth=void 0;var Oc=class extends _i{constructor(t,e,n,s){super(t,e,n,s)}};Oc.prototype.ValueTypeName="color";var Bc=class extends _i{constructor(t,e,n,s){super(t,e,n,s)}};Bc.prototype.ValueTypeName="number";var kc=class extends Qs{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(n-e)/(s-e),c=t*o;for(let h=c+o;c!==h;c+=4)pi.slerpFlat(r,0,a,c-o,a,c,l);return r}},ko=class extends _i{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new kc(this.times,this.values,this.getValueSize(),t)}};ko.prototype.ValueTypeName="quaternion";ko.prototype.InterpolantFactoryMethodSmooth=void 0;var er=class extends _i{constructor(t,e,n){super(t,e,n)}};er.prototype.ValueTypeName="string";er.prototype.ValueBufferType=Array;er.prototype.DefaultInterpolation=Eo;er.prototype.InterpolantFactoryMethodLinear=void 0;er.prototype.InterpolantFactoryMethodSmooth=void 0;var zc=class extends _i{constructor(t,e,n,s){super(t,e,n,s)}};zc.prototype.ValueTypeName="vector";var Hc=class{constructor(t,e,n){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,f){return c.push(h,f),this},this.removeHandler=function(h){let f=c.indexOf(h);return f!==-1&&c.splice(f,2),this},this.getHandler=function(h){for(let f=0,u=c.length;f<u;f+=2){let p=c[f],g=c[f+1];if(p.global&&(p.lastIndex=0),p.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ag=new Hc,Vc=class{constructor(t){this.manager=t!==void 0?t:Ag,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Vc.DEFAULT_MATERIAL_NAME="__DEFAULT";var oc=new X,lc=new pi,ts=new X,zo=class extends gi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ke,this.projectionMatrix=new ke,this.projectionMatrixInverse=new ke,this.coordinateSystem=Ri,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(oc,lc,ts),ts.x===1&&ts.y===1&&ts.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,lc,ts.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(oc,lc,ts),ts.x===1&&ts.y===1&&ts.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,lc,ts.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ys=new X,Um=new ie,Fm=new ie,Kn=class extends zo{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=xa*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(ma*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return xa*2*Math.atan(Math.tan(ma*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Ys.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ys.x,Ys.y).multiplyScalar(-t/Ys.z),Ys.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ys.x,Ys.y).multiplyScalar(-t/Ys.z)}getViewSize(t,e){return this.getViewBounds(t,Um,Fm),e.subVectors(Fm,Um)}setViewOffset(t,e,n,s,r,a){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(ma*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,e-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}let o=this.filmOffset;o!==0&&(r+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Gc=class extends zo{constructor(t=-1,e=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,a=n+t,o=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}};var da=-90,pa=1,wa=class extends gi{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Kn(da,pa,t,e);s.layers=this.layers,this.add(s);let r=new Kn(da,pa,t,e);r.layers=this.layers,this.add(r);let a=new Kn(da,pa,t,e);a.layers=this.layers,this.add(a);let o=new Kn(da,pa,t,e);o.layers=this.layers,this.add(o);let l=new Kn(da,pa,t,e);l.layers=this.layers,this.add(l);let c=new Kn(da,pa,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,a,o,l]=e;for(let c of e)this.remove(c);if(t===Ri)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Ao)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,f=t.getRenderTarget(),u=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let b=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let d=!1;t.isWebGLRenderer===!0?d=t.state.buffers.depth.getReversed():d=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),d&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),d&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,2,s),d&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,3,s),d&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),d&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=b,t.setRenderTarget(n,5,s),d&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(f,u,p),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Wc=class extends Kn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var sd="\\[\\]\\.:\\/",ly=new RegExp("["+sd+"]","g"),rd="[^"+sd+"]",cy="[^"+sd.replace("\\.","")+"]",hy=/((?:WC+[\/:])*)/.source.replace("WC",rd),uy=/(WCOD+)?/.source.replace("WCOD",cy),fy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",rd),dy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",rd),py=new RegExp("^"+hy+uy+fy+dy+"$"),my=["material","materials","bones","map"],Sf=class{constructor(t,e,n){let s=n||$e.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},$e=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(ly,"")}static parseTrackName(t){let e=py.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);my.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===e||o.uuid===e)return o;let l=n(o.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Kt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ne("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ne("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ne("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){ne("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){ne("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let a=t[s];if(a===void 0){let c=e.nodeName;ne("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$e.Composite=Sf;$e.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$e.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$e.prototype.GetterByBindingType=[$e.prototype._getValue_direct,$e.prototype._getValue_array,$e.prototype._getValue_arrayElement,$e.prototype._getValue_toArray];$e.prototype.SetterByBindingTypeAndVersioning=[[$e.prototype._setValue_direct,$e.prototype._setValue_direct_setNeedsUpdate,$e.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_array,$e.prototype._setValue_array_setNeedsUpdate,$e.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_arrayElement,$e.prototype._setValue_arrayElement_setNeedsUpdate,$e.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$e.prototype._setValue_fromArray,$e.prototype._setValue_fromArray_setNeedsUpdate,$e.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var rC=new Float32Array(1);var Om=new ke,Ho=class{constructor(t,e,n=0,s=1/0){this.ray=new Js(t,e),this.near=n,this.far=s,this.camera=null,this.layers=new ba,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ne("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Om.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Om),this}intersectObject(t,e=!0,n=[]){return Mf(t,this,n,e),n.sort(Bm),n}intersectObjects(t,e=!0,n=[]){for(let s=0,r=t.length;s<r;s++)Mf(t[s],this,n,e);return n.sort(Bm),n}};function Bm(i,t){return i.distance-t.distance}function Mf(i,t,e,n){let s=!0;if(i.layers.test(t.layers)&&i.raycast(t,e)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let a=0,o=r.length;a<o;a++)Mf(r[a],t,e,!0)}}var Ea=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ve(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ve(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var wf=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var Vo=class extends zi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function ad(i,t,e,n){let s=gy(n);switch(e){case Wf:return i*t;case qf:return i*t/s.components*s.byteLength;case Jc:return i*t/s.components*s.byteLength;case is:return i*t*2/s.components*s.byteLength;case jc:return i*t*2/s.components*s.byteLength;case Xf:return i*t*3/s.components*s.byteLength;case ti:return i*t*4/s.components*s.byteLength;case Qc:return i*t*4/s.components*s.byteLength;case Xo:case qo:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Yo:case $o:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case eh:case ih:return Math.max(i,16)*Math.max(t,8)/4;case th:case nh:return Math.max(i,8)*Math.max(t,8)/2;case sh:case rh:case oh:case lh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case ah:case Zo:case ch:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case hh:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case uh:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case fh:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case dh:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case ph:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case mh:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case gh:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case _h:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case vh:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case xh:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case yh:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case bh:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Sh:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Mh:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case wh:case Eh:case Th:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Ah:case Ch:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Ko:case Rh:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function gy(i){switch(i){case vi:case zf:return{byteLength:1,components:1};case Ra:case Hf:case Vi:return{byteLength:2,components:1};case Zc:case Kc:return{byteLength:2,components:4};case Hi:case $c:case xi:return{byteLength:4,components:1};case Vf:case Gf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Kt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Zg(){let i=null,t=!1,e=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),e(r,a)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function vy(i){let t=new WeakMap;function e(o,l){let c=o.array,h=o.usage,f=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),o.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:f}}function n(o,l,c){let h=l.array,f=l.updateRanges;if(i.bindBuffer(c,o),f.length===0)i.bufferSubData(c,0,h);else{f.sort((p,g)=>p.start-g.start);let u=0;for(let p=1;p<f.length;p++){let g=f[u],b=f[p];b.start<=g.start+g.count+1?g.count=Math.max(g.count,b.start+b.count-g.start):(++u,f[u]=b)}f.length=u+1;for(let p=0,g=f.length;p<g;p++){let b=f[p];i.bufferSubData(c,b.start*h.BYTES_PER_ELEMENT,h,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=t.get(o);l&&(i.deleteBuffer(l.buffer),t.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=t.get(o);(!h||h.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=t.get(o);if(c===void 0)t.set(o,e(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var xy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,yy=`#ifdef USE_ALPHAHASH
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
#endif`,by=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Sy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,My=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,wy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ey=`#ifdef USE_AOMAP
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
#endif`,Ty=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Ay=`#ifdef USE_BATCHING
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
#endif`,Cy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Ry=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Py=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Iy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Ly=`#ifdef USE_IRIDESCENCE
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
#endif`,Dy=`#ifdef USE_BUMPMAP
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
#endif`,Ny=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Uy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Fy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Oy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,By=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ky=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,zy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Hy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Vy=`#define PI 3.141592653589793
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
} // validated`,Gy=`vec3 transformedNormal = objectNormal;
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
#endif`,Wy=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Xy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,qy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Yy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,$y="gl_FragColor = linearToOutputTexel( gl_FragColor );",Zy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Ky=`#ifdef USE_ENVMAP
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
#endif`,Jy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,jy=`#ifdef USE_ENVMAP
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
#endif`,Qy=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,tb=`#ifdef USE_ENVMAP
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
#endif`,eb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,nb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ib=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,sb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,rb=`#ifdef USE_GRADIENTMAP
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
}`,ab=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,ob=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,lb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,cb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,hb=`#ifdef USE_ENVMAP
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
#endif`,ub=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,fb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,db=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,pb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,mb=`PhysicalMaterial material;
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
#endif`,gb=`uniform sampler2D dfgLUT;
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
}`,_b=`
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
#endif`,vb=`#if defined( RE_IndirectDiffuse )
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
#endif`,xb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,yb=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,bb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Sb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Mb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,wb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Eb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Tb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Ab=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Cb=`#if defined( USE_POINTS_UV )
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
#endif`,Rb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Pb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Ib=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Lb=`#if defined( USE_MORPHCOLORS )
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
#endif`,Db=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Nb=`#ifdef USE_MORPHTARGETS
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
#endif`,Ub=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Fb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Ob=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Bb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,kb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,zb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Hb=`#ifdef USE_NORMALMAP
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
#endif`,Vb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Gb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Wb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Xb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,qb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Yb=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,$b=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Zb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Kb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Jb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,jb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Qb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,tS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,eS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,nS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,iS=`float getShadowMask() {
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
}`,sS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,rS=`#ifdef USE_SKINNING
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
#endif`,aS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,oS=`#ifdef USE_SKINNING
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
#endif`,lS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,cS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,hS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,uS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,fS=`#ifdef USE_TRANSMISSION
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
#endif`,dS=`#ifdef USE_TRANSMISSION
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
#endif`,pS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,gS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,_S=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,vS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,xS=`uniform sampler2D t2D;
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
}`,yS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,bS=`uniform float backgroundBlurriness;
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
}`,SS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,MS=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wS=`#include <common>
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
}`,ES=`#if DEPTH_PACKING == 3200
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
}`,TS=`#define DISTANCE
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
}`,AS=`#define DISTANCE
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
}`,CS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,RS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,PS=`uniform float scale;
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
}`,IS=`uniform vec3 diffuse;
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
}`,LS=`#include <common>
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
}`,DS=`uniform vec3 diffuse;
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
}`,NS=`#define LAMBERT
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
}`,US=`#define LAMBERT
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
}`,FS=`#define MATCAP
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
}`,OS=`#define MATCAP
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
}`,BS=`#define NORMAL
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
}`,kS=`#define NORMAL
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
}`,zS=`#define PHONG
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
}`,HS=`#define PHONG
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
}`,VS=`#define STANDARD
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
}`,GS=`#define STANDARD
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
}`,WS=`#define TOON
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
}`,XS=`#define TOON
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
}`,qS=`uniform float size;
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
}`,YS=`uniform vec3 diffuse;
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
}`,$S=`#include <common>
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
}`,ZS=`uniform vec3 color;
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
}`,KS=`uniform float rotation;
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
}`,JS=`uniform vec3 diffuse;
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
}`,pe={alphahash_fragment:xy,alphahash_pars_fragment:yy,alphamap_fragment:by,alphamap_pars_fragment:Sy,alphatest_fragment:My,alphatest_pars_fragment:wy,aomap_fragment:Ey,aomap_pars_fragment:Ty,batching_pars_vertex:Ay,batching_vertex:Cy,begin_vertex:Ry,beginnormal_vertex:Py,bsdfs:Iy,iridescence_fragment:Ly,bumpmap_pars_fragment:Dy,clipping_planes_fragment:Ny,clipping_planes_pars_fragment:Uy,clipping_planes_pars_vertex:Fy,clipping_planes_vertex:Oy,color_fragment:By,color_pars_fragment:ky,color_pars_vertex:zy,color_vertex:Hy,common:Vy,defaultnormal_vertex:Gy,displacementmap_pars_vertex:Wy,displacementmap_vertex:Xy,emissivemap_fragment:qy,emissivemap_pars_fragment:Yy,colorspace_fragment:$y,colorspace_pars_fragment:Zy,envmap_fragment:Ky,envmap_common_pars_fragment:Jy,envmap_pars_fragment:jy,envmap_pars_vertex:Qy,envmap_physical_pars_fragment:hb,envmap_vertex:tb,fog_vertex:eb,fog_pars_vertex:nb,fog_fragment:ib,fog_pars_fragment:sb,gradientmap_pars_fragment:rb,lightmap_pars_fragment:ab,lights_lambert_fragment:ob,lights_lambert_pars_fragment:lb,lights_pars_begin:cb,lights_toon_fragment:ub,lights_toon_pars_fragment:fb,lights_phong_fragment:db,lights_phong_pars_fragment:pb,lights_physical_fragment:mb,lights_physical_pars_fragment:gb,lights_fragment_begin:_b,lights_fragment_maps:vb,lights_fragment_end:xb,lightprobes_pars_fragment:yb,logdepthbuf_fragment:bb,logdepthbuf_pars_fragment:Sb,logdepthbuf_pars_vertex:Mb,logdepthbuf_vertex:wb,map_fragment:Eb,map_pars_fragment:Tb,map_particle_fragment:Ab,map_particle_pars_fragment:Cb,metalnessmap_fragment:Rb,metalnessmap_pars_fragment:Pb,morphinstance_vertex:Ib,morphcolor_vertex:Lb,morphnormal_vertex:Db,morphtarget_pars_vertex:Nb,morphtarget_vertex:Ub,normal_fragment_begin:Fb,normal_fragment_maps:Ob,normal_pars_fragment:Bb,normal_pars_vertex:kb,normal_vertex:zb,normalmap_pars_fragment:Hb,clearcoat_normal_fragment_begin:Vb,clearcoat_normal_fragment_maps:Gb,clearcoat_pars_fragment:Wb,iridescence_pars_fragment:Xb,opaque_fragment:qb,packing:Yb,premultiplied_alpha_fragment:$b,project_vertex:Zb,dithering_fragment:Kb,dithering_pars_fragment:Jb,roughnessmap_fragment:jb,roughnessmap_pars_fragment:Qb,shadowmap_pars_fragment:tS,shadowmap_pars_vertex:eS,shadowmap_vertex:nS,shadowmask_pars_fragment:iS,skinbase_vertex:sS,skinning_pars_vertex:rS,skinning_vertex:aS,skinnormal_vertex:oS,specularmap_fragment:lS,specularmap_pars_fragment:cS,tonemapping_fragment:hS,tonemapping_pars_fragment:uS,transmission_fragment:fS,transmission_pars_fragment:dS,uv_pars_fragment:pS,uv_pars_vertex:mS,uv_vertex:gS,worldpos_vertex:_S,background_vert:vS,background_frag:xS,backgroundCube_vert:yS,backgroundCube_frag:bS,cube_vert:SS,cube_frag:MS,depth_vert:wS,depth_frag:ES,distance_vert:TS,distance_frag:AS,equirect_vert:CS,equirect_frag:RS,linedashed_vert:PS,linedashed_frag:IS,meshbasic_vert:LS,meshbasic_frag:DS,meshlambert_vert:NS,meshlambert_frag:US,meshmatcap_vert:FS,meshmatcap_frag:OS,meshnormal_vert:BS,meshnormal_frag:kS,meshphong_vert:zS,meshphong_frag:HS,meshphysical_vert:VS,meshphysical_frag:GS,meshtoon_vert:WS,meshtoon_frag:XS,points_vert:qS,points_frag:YS,shadow_vert:$S,shadow_frag:ZS,sprite_vert:KS,sprite_frag:JS},Dt={common:{diffuse:{value:new Se(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new re}},envmap:{envMap:{value:null},envMapRotation:{value:new re},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new re}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new re}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new re},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new re},normalScale:{value:new ie(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new re},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new re}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new re}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new re}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Se(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Se(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0},uvTransform:{value:new re}},sprite:{diffuse:{value:new Se(16777215)},opacity:{value:1},center:{value:new ie(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new re},alphaMap:{value:null},alphaMapTransform:{value:new re},alphaTest:{value:0}}},rs={basic:{uniforms:Vn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.fog]),vertexShader:pe.meshbasic_vert,fragmentShader:pe.meshbasic_frag},lambert:{uniforms:Vn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new Se(0)},envMapIntensity:{value:1}}]),vertexShader:pe.meshlambert_vert,fragmentShader:pe.meshlambert_frag},phong:{uniforms:Vn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new Se(0)},specular:{value:new Se(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pe.meshphong_vert,fragmentShader:pe.meshphong_frag},standard:{uniforms:Vn([Dt.common,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.roughnessmap,Dt.metalnessmap,Dt.fog,Dt.lights,{emissive:{value:new Se(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag},toon:{uniforms:Vn([Dt.common,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.gradientmap,Dt.fog,Dt.lights,{emissive:{value:new Se(0)}}]),vertexShader:pe.meshtoon_vert,fragmentShader:pe.meshtoon_frag},matcap:{uniforms:Vn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,{matcap:{value:null}}]),vertexShader:pe.meshmatcap_vert,fragmentShader:pe.meshmatcap_frag},points:{uniforms:Vn([Dt.points,Dt.fog]),vertexShader:pe.points_vert,fragmentShader:pe.points_frag},dashed:{uniforms:Vn([Dt.common,Dt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pe.linedashed_vert,fragmentShader:pe.linedashed_frag},depth:{uniforms:Vn([Dt.common,Dt.displacementmap]),vertexShader:pe.depth_vert,fragmentShader:pe.depth_frag},normal:{uniforms:Vn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,{opacity:{value:1}}]),vertexShader:pe.meshnormal_vert,fragmentShader:pe.meshnormal_frag},sprite:{uniforms:Vn([Dt.sprite,Dt.fog]),vertexShader:pe.sprite_vert,fragmentShader:pe.sprite_frag},background:{uniforms:{uvTransform:{value:new re},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pe.background_vert,fragmentShader:pe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new re}},vertexShader:pe.backgroundCube_vert,fragmentShader:pe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pe.cube_vert,fragmentShader:pe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pe.equirect_vert,fragmentShader:pe.equirect_frag},distance:{uniforms:Vn([Dt.common,Dt.displacementmap,{referencePosition:{value:new X},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pe.distance_vert,fragmentShader:pe.distance_frag},shadow:{uniforms:Vn([Dt.lights,Dt.fog,{color:{value:new Se(0)},opacity:{value:1}}]),vertexShader:pe.shadow_vert,fragmentShader:pe.shadow_frag}};rs.physical={uniforms:Vn([rs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new re},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new re},clearcoatNormalScale:{value:new ie(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new re},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new re},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new re},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new re},sheen:{value:0},sheenColor:{value:new Se(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new re},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new re},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new re},transmissionSamplerSize:{value:new ie},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new re},attenuationDistance:{value:0},attenuationColor:{value:new Se(0)},specularColor:{value:new Se(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new re},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new re},anisotropyVector:{value:new ie},anisotropyMap:{value:null},anisotropyMapTransform:{value:new re}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag};var Ph={r:0,b:0,g:0},jS=new ke,Kg=new re;Kg.set(-1,0,0,0,1,0,0,0,1);function QS(i,t,e,n,s,r){let a=new Se(0),o=s===!0?0:1,l,c,h=null,f=0,u=null;function p(y){let C=y.isScene===!0?y.background:null;if(C&&C.isTexture){let w=y.backgroundBlurriness>0;C=t.get(C,w)}return C}function g(y){let C=!1,w=p(y);w===null?d(a,o):w&&w.isColor&&(d(w,1),C=!0);let P=i.xr.getEnvironmentBlendMode();P==="additive"?e.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||C)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function b(y,C){let w=p(C);w&&w.isCubeTexture?(c===void 0&&(c=new Hn(new Ma(1,1,1),new On({name:"BackgroundCubeMaterial",uniforms:Tr(rs.backgroundCube.uniforms),vertexShader:rs.backgroundCube.vertexShader,fragmentShader:rs.backgroundCube.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,T,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=w,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(jS.makeRotationFromEuler(C.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Kg),c.material.toneMapped=be.getTransfer(w.colorSpace)!==Le,(h!==w||f!==w.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=w,f=w.version,u=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):w&&w.isTexture&&(l===void 0&&(l=new Hn(new Bo(2,2),new On({name:"BackgroundMaterial",uniforms:Tr(rs.background.uniforms),vertexShader:rs.background.vertexShader,fragmentShader:rs.background.fragmentShader,side:sr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=w,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=be.getTransfer(w.colorSpace)!==Le,w.matrixAutoUpdate===!0&&w.updateMatrix(),l.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||f!==w.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=w,f=w.version,u=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function d(y,C){y.getRGB(Ph,id(i)),e.buffers.color.setClear(Ph.r,Ph.g,Ph.b,C,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(y,C=1){a.set(y),o=C,d(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(y){o=y,d(a,o)},render:g,addToRenderList:b,dispose:m}}function tM(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,a=!1;function o(N,W,G,D,V){let K=!1,H=f(N,D,G,W);r!==H&&(r=H,c(r.object)),K=p(N,D,G,V),K&&g(N,D,G,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(K||a)&&(a=!1,w(N,W,G,D),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(N){return i.bindVertexArray(N)}function h(N){return i.deleteVertexArray(N)}function f(N,W,G,D){let V=D.wireframe===!0,K=n[W.id];K===void 0&&(K={},n[W.id]=K);let H=N.isInstancedMesh===!0?N.id:0,ht=K[H];ht===void 0&&(ht={},K[H]=ht);let J=ht[G.id];J===void 0&&(J={},ht[G.id]=J);let Q=J[V];return Q===void 0&&(Q=u(l()),J[V]=Q),Q}function u(N){let W=[],G=[],D=[];for(let V=0;V<e;V++)W[V]=0,G[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:W,enabledAttributes:G,attributeDivisors:D,object:N,attributes:{},index:null}}function p(N,W,G,D){let V=r.attributes,K=W.attributes,H=0,ht=G.getAttributes();for(let J in ht)if(ht[J].location>=0){let rt=V[J],dt=K[J];if(dt===void 0&&(J==="instanceMatrix"&&N.instanceMatrix&&(dt=N.instanceMatrix),J==="instanceColor"&&N.instanceColor&&(dt=N.instanceColor)),rt===void 0||rt.attribute!==dt||dt&&rt.data!==dt.data)return!0;H++}return r.attributesNum!==H||r.index!==D}function g(N,W,G,D){let V={},K=W.attributes,H=0,ht=G.getAttributes();for(let J in ht)if(ht[J].location>=0){let rt=K[J];rt===void 0&&(J==="instanceMatrix"&&N.instanceMatrix&&(rt=N.instanceMatrix),J==="instanceColor"&&N.instanceColor&&(rt=N.instanceColor));let dt={};dt.attribute=rt,rt&&rt.data&&(dt.data=rt.data),V[J]=dt,H++}r.attributes=V,r.attributesNum=H,r.index=D}function b(){let N=r.newAttributes;for(let W=0,G=N.length;W<G;W++)N[W]=0}function d(N){m(N,0)}function m(N,W){let G=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;G[N]=1,D[N]===0&&(i.enableVertexAttribArray(N),D[N]=1),V[N]!==W&&(i.vertexAttribDivisor(N,W),V[N]=W)}function y(){let N=r.newAttributes,W=r.enabledAttributes;for(let G=0,D=W.length;G<D;G++)W[G]!==N[G]&&(i.disableVertexAttribArray(G),W[G]=0)}function C(N,W,G,D,V,K,H){H===!0?i.vertexAttribIPointer(N,W,G,V,K):i.vertexAttribPointer(N,W,G,D,V,K)}function w(N,W,G,D){b();let V=D.attributes,K=G.getAttributes(),H=W.defaultAttributeValues;for(let ht in K){let J=K[ht];if(J.location>=0){let Q=V[ht];if(Q===void 0&&(ht==="instanceMatrix"&&N.instanceMatrix&&(Q=N.instanceMatrix),ht==="instanceColor"&&N.instanceColor&&(Q=N.instanceColor)),Q!==void 0){let rt=Q.normalized,dt=Q.itemSize,ft=t.get(Q);if(ft===void 0)continue;let tt=ft.buffer,gt=ft.type,xt=ft.bytesPerElement,Ct=gt===i.INT||gt===i.UNSIGNED_INT||Q.gpuType===$c;if(Q.isInterleavedBufferAttribute){let Mt=Q.data,Yt=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,le=Q.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Xt=0;Xt<J.locationSize;Xt++)m(J.location+Xt,Mt.meshPerAttribute);N.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Xt=0;Xt<J.locationSize;Xt++)d(J.location+Xt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Xt=0;Xt<J.locationSize;Xt++)C(J.location+Xt,dt/J.locationSize,gt,rt,Yt*xt,(le+dt/J.locationSize*Xt)*xt,Ct)}else{if(Q.isInstancedBufferAttribute){for(let Mt=0;Mt<J.locationSize;Mt++)m(J.location+Mt,Q.meshPerAttribute);N.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Mt=0;Mt<J.locationSize;Mt++)d(J.location+Mt);i.bindBuffer(i.ARRAY_BUFFER,tt);for(let Mt=0;Mt<J.locationSize;Mt++)C(J.location+Mt,dt/J.locationSize,gt,rt,dt*xt,dt/J.locationSize*Mt*xt,Ct)}}else if(H!==void 0){let rt=H[ht];if(rt!==void 0)switch(rt.length){case 2:i.vertexAttrib2fv(J.location,rt);break;case 3:i.vertexAttrib3fv(J.location,rt);break;case 4:i.vertexAttrib4fv(J.location,rt);break;default:i.vertexAttrib1fv(J.location,rt)}}}}y()}function P(){z();for(let N in n){let W=n[N];for(let G in W){let D=W[G];for(let V in D){let K=D[V];for(let H in K)h(K[H].object),delete K[H];delete D[V]}}delete n[N]}}function T(N){if(n[N.id]===void 0)return;let W=n[N.id];for(let G in W){let D=W[G];for(let V in D){let K=D[V];for(let H in K)h(K[H].object),delete K[H];delete D[V]}}delete n[N.id]}function v(N){for(let W in n){let G=n[W];for(let D in G){let V=G[D];if(V[N.id]===void 0)continue;let K=V[N.id];for(let H in K)h(K[H].object),delete K[H];delete V[N.id]}}}function E(N){for(let W in n){let G=n[W],D=N.isInstancedMesh===!0?N.id:0,V=G[D];if(V!==void 0){for(let K in V){let H=V[K];for(let ht in H)h(H[ht].object),delete H[ht];delete V[K]}delete G[D],Object.keys(G).length===0&&delete n[W]}}}function z(){U(),a=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:z,resetDefaultState:U,dispose:P,releaseStatesOfGeometry:T,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:b,enableAttribute:d,disableUnusedAttributes:y}}function eM(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function o(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let p=0;p<h;p++)u+=c[p];e.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function nM(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(v){return!(v!==ti&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(v){let E=v===Vi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==vi&&v!==xi&&!E&&n.convert(v)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Kt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&f===!1;e.reversedDepthBuffer===!0&&f===!1&&Kt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&f===!0&&Kt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=i.getParameter(i.MAX_TEXTURE_SIZE),d=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),C=i.getParameter(i.MAX_VARYING_VECTORS),w=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:g,maxTextureSize:b,maxCubemapSize:d,maxAttributes:m,maxVertexUniforms:y,maxVaryings:C,maxFragmentUniforms:w,maxSamples:P,samples:T}}function iM(i){let t=this,e=null,n=0,s=!1,r=!1,a=new Zn,o=new re,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,u){let p=f.length!==0||u||n!==0||s;return s=u,n=f.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,u){e=h(f,u,0)},this.setState=function(f,u,p){let g=f.clippingPlanes,b=f.clipIntersection,d=f.clipShadows,m=i.get(f);if(!s||g===null||g.length===0||r&&!d)r?h(null):c();else{let y=r?0:n,C=y*4,w=m.clippingState||null;l.value=w,w=h(g,u,C,p);for(let P=0;P!==C;++P)w[P]=e[P];m.clippingState=w,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(f,u,p,g){let b=f!==null?f.length:0,d=null;if(b!==0){if(d=l.value,g!==!0||d===null){let m=p+b*4,y=u.matrixWorldInverse;o.getNormalMatrix(y),(d===null||d.length<m)&&(d=new Float32Array(m));for(let C=0,w=p;C!==b;++C,w+=4)a.copy(f[C]).applyMatrix4(y,o),a.normal.toArray(d,w),d[w+3]=a.constant}l.value=d,l.needsUpdate=!0}return t.numPlanes=b,t.numIntersection=0,d}}var Qo=class extends mi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new No(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ma(5,5,5),r=new On({name:"CubemapFromEquirect",uniforms:Tr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Qn,blending:Sr});r.uniforms.tEquirect.value=e;let a=new Hn(s,r),o=e.minFilter;return e.minFilter===Ts&&(e.minFilter=jn),new wa(1,10,this).update(t,a),e.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let a=0;a<6;a++)t.setRenderTarget(this,a),t.clear(e,n,s);t.setRenderTarget(r)}},Cg=256,sM=3,rM=20,Jg=256,jg=16,aM=3,oM=new X,lM=new Se,Lh=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new wa(1,10,null),this._boxMesh=new Hn(new Ma(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:a=256,position:o=oM}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,u=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,b=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(t.background=l.getClearColor(lM));let d=new wa(n,s,h);return d.position.copy(o),d.update(l,t),l.autoClear=f,l.autoClearColor=u,l.autoClearDepth=p,l.autoClearStencil=g,t.background=b,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ig(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Pg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Cg,td(t))}_fromTexture(t,e){t.mapping===wr||t.mapping===Ca?this._setSize(t.image.length===0?Cg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Rg(t,!1,!1),n=Math.log2(t)-sM;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Rg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let a=t.width>>e;t.viewport.set(0,0,a,a),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===wr||t.mapping===Ca?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ig()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Pg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=cM(),this._integrationMaterial=hM());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/jg);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-aM)r.roughness.value=o,this._renderCube(t,a,this._integrationMaterial);else{let l=o>0?Math.log2(e)+.5*Math.log2(6/(Jg*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(t,a,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=uM());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Rg(i,t,e){return new Qo(i,{minFilter:Ts,generateMipmaps:t,type:Vi,colorSpace:$s,depthBuffer:e})}function tl(i,t,e){return new On({name:i,uniforms:t,vertexShader:pe.cube_vert,fragmentShader:e,side:Qn,blending:Sr,depthTest:!1,depthWrite:!1})}function cM(){return tl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Jg}u

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
	`)}function hM(){return tl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:jg}},`

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
	`)}function uM(){return tl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${rM}
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
	`)}function Pg(){return tl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Ig(){return tl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function fM(i){let t=new WeakMap,e=new WeakMap,n=null;function s(u,p=!1){return u==null?null:p?a(u):r(u)}function r(u){if(u&&u.isTexture){let p=u.mapping;if(p===Xc||p===qc)if(t.has(u)){let g=t.get(u).texture;return o(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let b=new Qo(g.height);return b.fromEquirectangularTexture(i,u),t.set(u,b),u.addEventListener("dispose",c),o(b.texture,u.mapping)}else return null}}return u}function a(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let p=u.mapping,g=p===Xc||p===qc,b=p===wr||p===Ca;if(g||b){let d=e.get(u),m=d!==void 0?d.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==m)return n===null&&(n=new Lh(i)),d=g?n.fromEquirectangular(u,d):n.fromCubemap(u,d),d.texture.pmremVersion=u.pmremVersion,e.set(u,d),d.texture;if(d!==void 0)return d.texture;{let y=u.image;return g&&y&&y.height>0||b&&y&&l(y)?(n===null&&(n=new Lh(i)),d=g?n.fromEquirectangular(u):n.fromCubemap(u),d.texture.pmremVersion=u.pmremVersion,e.set(u,d),u.addEventListener("dispose",h),d.texture):null}}}return u}function o(u,p){return p===Xc?u.mapping=wr:p===qc&&(u.mapping=Ca),u}function l(u){let p=0,g=6;for(let b=0;b<g;b++)u[b]!==void 0&&p++;return p===g}function c(u){let p=u.target;p.removeEventListener("dispose",c);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function h(u){let p=u.target;p.removeEventListener("dispose",h);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function f(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function dM(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Mo("WebGLRenderer: "+n+" extension not supported."),s}}}function pM(i,t,e,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let d in g.attributes)t.remove(g.attributes[d]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let b=r.get(g);b&&(t.remove(b),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,b){return s[b.id]!==void 0||(b.addEventListener("dispose",o),s[b.id]=new WeakRef(b),a.register(b,b.id,b),e.memory.geometries++),b}function h(g){let b=g.attributes;for(let d in b)t.update(b[d],i.ARRAY_BUFFER)}function f(g){let b=g.index,d=g.attributes.position,m=0;if(d===void 0)return;let y=b!==null?b.array.length:d.array.length/3-1,C=d.count>=65535?Lo:Io,w=new C(Math.ceil(y/3)*6,1),P=w.array;if(b!==null){let v=b.array;m=b.version;for(let E=0,z=0;E<y;E+=3){let U=v[E+0],N=v[E+1],W=v[E+2];P[z++]=U,P[z++]=N,P[z++]=N,P[z++]=W,P[z++]=W,P[z++]=U}}else{m=d.version;for(let v=0,E=0;v<y;v+=3){let z=v+0,U=v+1,N=v+2;P[E++]=z,P[E++]=U,P[E++]=U,P[E++]=N,P[E++]=N,P[E++]=z}}w.version=m;let T=r.get(g);T&&t.remove(T),r.set(g,w)}function u(g){let b=r.get(g);if(b){let d=g.index;d!==null&&b.version<d.version&&f(g)}else f(g);return r.get(g)}function p(){for(let g in s){let b=s[g].deref();b!==void 0&&l(b)}}return{get:c,update:h,getWireframeAttribute:u,dispose:p}}function mM(i,t,e){let n;function s(f){n=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function l(f,u){i.drawElements(n,u,r,f*a),e.update(u,n,1)}function c(f,u,p){p!==0&&(i.drawElementsInstanced(n,u,r,f*a,p),e.update(u,n,p))}function h(f,u,p){if(p===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,f,0,p);let b=0;for(let d=0;d<p;d++)b+=u[d];e.update(b,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function gM(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(e.calls++,a){case i.TRIANGLES:e.triangles+=o*(r/3);break;case i.LINES:e.lines+=o*(r/2);break;case i.LINE_STRIP:e.lines+=o*(r-1);break;case i.LINE_LOOP:e.lines+=o*r;break;case i.POINTS:e.points+=o*r;break;default:ne("WebGLInfo: Unknown draw mode:",a);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function _M(i,t,e){let n=new WeakMap,s=new Ze;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=h!==void 0?h.length:0,u=n.get(o);if(u===void 0||u.count!==f){let z=function(){v.dispose(),n.delete(o),o.removeEventListener("dispose",z)};u!==void 0&&u.texture.dispose();let p=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,b=o.morphAttributes.color!==void 0,d=o.morphAttributes.position||[],m=o.morphAttributes.normal||[],y=o.morphAttributes.color||[],C=0;p===!0&&(C=1),g===!0&&(C=2),b===!0&&(C=3);let w=o.attributes.position.count*C,P=1;w>t.maxTextureSize&&(P=Math.ceil(w/t.maxTextureSize),w=t.maxTextureSize);let T=new Float32Array(w*P*4*f),v=new Ro(T,w,P,f);v.type=xi,v.needsUpdate=!0;let E=C*4;for(let U=0;U<f;U++){let N=d[U],W=m[U],G=y[U],D=w*P*4*U;for(let V=0;V<N.count;V++){let K=V*E;p===!0&&(s.fromBufferAttribute(N,V),T[D+K+0]=s.x,T[D+K+1]=s.y,T[D+K+2]=s.z,T[D+K+3]=0),g===!0&&(s.fromBufferAttribute(W,V),T[D+K+4]=s.x,T[D+K+5]=s.y,T[D+K+6]=s.z,T[D+K+7]=0),b===!0&&(s.fromBufferAttribute(G,V),T[D+K+8]=s.x,T[D+K+9]=s.y,T[D+K+10]=s.z,T[D+K+11]=G.itemSize===4?s.w:1)}}u={count:f,texture:v,size:new ie(w,P)},n.set(o,u),o.addEventListener("dispose",z)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,e);else{let p=0;for(let b=0;b<c.length;b++)p+=c[b];let g=o.morphTargetsRelative?1:1-p;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function vM(i,t,e,n,s){let r=new WeakMap;function a(c){let h=s.render.frame,f=c.geometry,u=t.get(c,f);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==h&&(p.update(),r.set(p,h))}return u}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:a,dispose:o}}var xM={[Lf]:"LINEAR_TONE_MAPPING",[Df]:"REINHARD_TONE_MAPPING",[Nf]:"CINEON_TONE_MAPPING",[Uf]:"ACES_FILMIC_TONE_MAPPING",[Of]:"AGX_TONE_MAPPING",[Bf]:"NEUTRAL_TONE_MAPPING",[Ff]:"CUSTOM_TONE_MAPPING"};function yM(i,t,e,n,s,r){let a=new mi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new Fn;h.setAttribute("position",new Jn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Jn([0,2,0,0,2,0],2));let f=new Pc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Hn(h,f),p=new Gc(-1,1,1,-1,0,1),g=null,b=null,d=!1,m,y=null,C=[],w=!1;this.setSize=function(P,T){a.setSize(P,T),o!==null&&o.setSize(P,T),l!==null&&l.setSize(P,T);for(let v=0;v<C.length;v++){let E=C[v];E.setSize&&E.setSize(P,T)}},this.setEffects=function(P){C=P,w=C.length>0&&C[0].isRenderPass===!0;let T=a.width,v=a.height;C.length>0&&o===null&&(o=new mi(T,v,{type:Vi,depthBuffer:!1,stencilBuffer:!1}),l=new mi(T,v,{type:Vi,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&C.some(z=>z.needsDepthTexture===!0);E!==(a.depthTexture!==null)&&(E===!0&&c===null&&(c=new Es(T,v),r===!0&&(c.format=As,c.type=Er)),a.dispose(),a.depthTexture=E?c:null,a.resolveDepthBuffer=E,a.storeMultisampledDepthBuffer=E);for(let z=0;z<C.length;z++){let U=C[z];U.setSize&&U.setSize(T,v),E&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(P,T){if(d||P.toneMapping===ns&&C.length===0)return!1;if(y=T,T!==null){let v=T.width,E=T.height;(a.width!==v||a.height!==E)&&this.setSize(v,E)}return w===!1&&P.setRenderTarget(a),m=P.toneMapping,P.toneMapping=ns,!0},this.hasRenderPass=function(){return w},this.end=function(P,T){P.toneMapping=m,d=!0;let v=a,E=o;for(let z=0;z<C.length;z++){let U=C[z];U.enabled!==!1&&(U.render(P,E,v,T),U.needsSwap!==!1&&(v=E,E=E===o?l:o))}if(g!==P.outputColorSpace||b!==P.toneMapping){g=P.outputColorSpace,b=P.toneMapping,f.defines={},be.getTransfer(g)===Le&&(f.defines.SRGB_TRANSFER="");let z=xM[b];z&&(f.defines[z]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=v.texture,P.setRenderTarget(y),P.render(u,p),y=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),f.dispose()}}var Qg=new ri,t0=new Es(1,1),e0=new Uo(1),n0=new Ro,i0=new Mc,s0=new No,Lg=[],Dg=[],Ng=new Float32Array(16),Ug=new Float32Array(9),Fg=new Float32Array(4);function La(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=Lg[s];if(r===void 0&&(r=new Float32Array(s),Lg[s]=r),t!==0){n.toArray(r,0);for(let a=1,o=0;a!==t;++a)o+=e,i[a].toArray(r,o)}return r}function Mn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function wn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Nh(i,t){let e=Dg[t];e===void 0&&(e=new Int32Array(t),Dg[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function bM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function SM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2fv(this.addr,t),wn(e,t)}}function MM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Mn(e,t))return;i.uniform3fv(this.addr,t),wn(e,t)}}function wM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4fv(this.addr,t),wn(e,t)}}function EM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),wn(e,t)}else{if(Mn(e,n))return;Fg.set(n),i.uniformMatrix2fv(this.addr,!1,Fg),wn(e,n)}}function TM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),wn(e,t)}else{if(Mn(e,n))return;Ug.set(n),i.uniformMatrix3fv(this.addr,!1,Ug),wn(e,n)}}function AM(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Mn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),wn(e,t)}else{if(Mn(e,n))return;Ng.set(n),i.uniformMatrix4fv(this.addr,!1,Ng),wn(e,n)}}function CM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function RM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2iv(this.addr,t),wn(e,t)}}function PM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3iv(this.addr,t),wn(e,t)}}function IM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4iv(this.addr,t),wn(e,t)}}function LM(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function DM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;i.uniform2uiv(this.addr,t),wn(e,t)}}function NM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;i.uniform3uiv(this.addr,t),wn(e,t)}}function UM(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;i.uniform4uiv(this.addr,t),wn(e,t)}}function Uh(i){return i.version===0&&(i.compareFunction=Kf,i.needsUpdate=!0),i}function FM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Uh(t0):r=Qg,e.setTexture2D(t||r,s)}function OM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||i0,s)}function BM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Uh(e0):r=s0,e.setTextureCube(t||r,s)}function kM(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||n0,s)}function zM(i){switch(i){case 5126:return bM;case 35664:return SM;case 35665:return MM;case 35666:return wM;case 35674:return EM;case 35675:return TM;case 35676:return AM;case 5124:case 35670:return CM;case 35667:case 35671:return RM;case 35668:case 35672:return PM;case 35669:case 35673:return IM;case 5125:return LM;case 36294:return DM;case 36295:return NM;case 36296:return UM;case 35678:case 36198:case 36298:case 36306:case 35682:return FM;case 35679:case 36299:case 36307:return OM;case 35680:case 36300:case 36308:case 36293:return BM;case 36289:case 36303:case 36311:case 36292:return kM}}function HM(i,t){i.uniform1fv(this.addr,t)}function VM(i,t){let e=La(t,this.size,2);i.uniform2fv(this.addr,e)}function GM(i,t){let e=La(t,this.size,3);i.uniform3fv(this.addr,e)}function WM(i,t){let e=La(t,this.size,4);i.uniform4fv(this.addr,e)}function XM(i,t){let e=La(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function qM(i,t){let e=La(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function YM(i,t){let e=La(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function $M(i,t){i.uniform1iv(this.addr,t)}function ZM(i,t){i.uniform2iv(this.addr,t)}function KM(i,t){i.uniform3iv(this.addr,t)}function JM(i,t){i.uniform4iv(this.addr,t)}function jM(i,t){i.uniform1uiv(this.addr,t)}function QM(i,t){i.uniform2uiv(this.addr,t)}function tw(i,t){i.uniform3uiv(this.addr,t)}function ew(i,t){i.uniform4uiv(this.addr,t)}function nw(i,t,e){let n=this.cache,s=t.length,r=Nh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Uh(t0):a=Qg;for(let o=0;o!==s;++o)e.setTexture2D(t[o]||a,r[o])}function iw(i,t,e){let n=this.cache,s=t.length,r=Nh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));for(let a=0;a!==s;++a)e.setTexture3D(t[a]||i0,r[a])}function sw(i,t,e){let n=this.cache,s=t.length,r=Nh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Uh(e0):a=s0;for(let o=0;o!==s;++o)e.setTextureCube(t[o]||a,r[o])}function rw(i,t,e){let n=this.cache,s=t.length,r=Nh(e,s);Mn(n,r)||(i.uniform1iv(this.addr,r),wn(n,r));for(let a=0;a!==s;++a)e.setTexture2DArray(t[a]||n0,r[a])}function aw(i){switch(i){case 5126:return HM;case 35664:return VM;case 35665:return GM;case 35666:return WM;case 35674:return XM;case 35675:return qM;case 35676:return YM;case 5124:case 35670:return $M;case 35667:case 35671:return ZM;case 35668:case 35672:return KM;case 35669:case 35673:return JM;case 5125:return jM;case 36294:return QM;case 36295:return tw;case 36296:return ew;case 35678:case 36198:case 36298:case 36306:case 35682:return nw;case 35679:case 36299:case 36307:return iw;case 35680:case 36300:case 36308:case 36293:return sw;case 36289:case 36303:case 36311:case 36292:return rw}}var cd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=zM(e.type)}},hd=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=aw(e.type)}},ud=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(t,e[o.id],n)}}},od=/(\w+)(\])?(\[|\.)?/g;function Og(i,t){i.seq.push(t),i.map[t.id]=t}function ow(i,t,e){let n=i.name,s=n.length;for(od.lastIndex=0;;){let r=od.exec(n),a=od.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){Og(e,c===void 0?new cd(o,i,t):new hd(o,i,t));break}else{let f=e.map[o];f===void 0&&(f=new ud(o),Og(e,f)),e=f}}}var Ia=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=t.getActiveUniform(e,a),l=t.getUniformLocation(e,o.name);ow(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===t.SAMPLER_2D_SHADOW||a.type===t.SAMPLER_CUBE_SHADOW||a.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,a=e.length;r!==a;++r){let o=e[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let a=t[s];a.id in e&&n.push(a)}return n}};function Bg(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var lw=37297,cw=0;function hw(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===t?">":" "} ${o}: ${e[a]}`)}return n.join(`
`)}var kg=new re;function uw(i){be._getMatrix(kg,be.workingColorSpace,i);let t=`mat3( ${kg.elements.map(e=>e.toFixed(4))} )`;switch(be.getTransfer(i)){case To:return[t,"LinearTransferOETF"];case Le:return[t,"sRGBTransferOETF"];default:return Kt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function zg(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return e.toUpperCase()+`

`+r+`

`+hw(i.getShaderSource(t),o)}else return r}function fw(i,t){let e=uw(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var dw={[Lf]:"Linear",[Df]:"Reinhard",[Nf]:"Cineon",[Uf]:"ACESFilmic",[Of]:"AgX",[Bf]:"Neutral",[Ff]:"Custom"};function pw(i,t){let e=dw[t];return e===void 0?(Kt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Ih=new X;function mw(){be.getLuminanceCoefficients(Ih);let i=Ih.x.toFixed(4),t=Ih.y.toFixed(4),e=Ih.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function gw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(jo).join(`
`)}function _w(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function vw(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),e[a]={type:r.type,location:i.getAttribLocation(t,a),locationSize:o}}return e}function jo(i){return i!==""}function Hg(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Vg(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var xw=/^[ \t]*#include +<([\w\d./]+)>/gm;function fd(i){return i.replace(xw,yw)}function yw(i,t){let e=pe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return fd(e)}var bw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Gg(i){return i.replace(bw,Sw)}function Sw(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Wg(i){let t=`precision ${i.precision} float;
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
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var Mw={[Go]:"SHADOWMAP_TYPE_PCF",[Ta]:"SHADOWMAP_TYPE_VSM"};function ww(i){return Mw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Ew={[Ca]:"ENVMAP_MODE_REFRACTION"};function Tw(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Ew[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Aw={[If]:"ENVMAP_BLENDING_MULTIPLY",[ag]:"ENVMAP_BLENDING_MIX",[og]:"ENVMAP_BLENDING_ADD"};function Cw(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Aw[i.combine]||"ENVMAP_BLENDING_NONE"}function Rw(i,t,e,n){let s=i.getContext(),r=e.defines,a=e.vertexShader,o=e.fragmentShader,l=ww(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Tw(e),f=Cw(e),u=gw(e),p=_w(r),g=s.createProgram(),b,d,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(b=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(jo).join(`
`),b.length>0&&(b+=`
`),d=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(jo).join(`
`),d.length>0&&(d+=`
`)):(b=[Wg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(jo).join(`
`),d=[Wg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+f:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ns?"#define TONE_MAPPING":"",e.toneMapping!==ns?pe.tonemapping_pars_fragment:"",e.toneMapping!==ns?pw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",pe.colorspace_pars_fragment,fw("linearToOutputTexel",e.outputColorSpace),mw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(jo).join(`
`)),a=fd(a),a=Hg(a,e),a=Vg(a,e),o=fd(o),o=Hg(o,e),o=Vg(o,e),a=Gg(a),o=Gg(o),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,b=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,d=["#define varying in",e.glslVersion===Rs?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Rs?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let y=m+b+a,C=m+d+o,w=Bg(s,s.VERTEX_SHADER,y),P=Bg(s,s.FRAGMENT_SHADER,C);s.attachShader(g,w),s.attachShader(g,P),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function T(U){if(i.debug.checkShaderErrors){let N=s.getProgramInfoLog(g)||"",W=s.getShaderInfoLog(w)||"",G=s.getShaderInfoLog(P)||"",D=N.trim(),V=W.trim(),K=G.trim(),H=!0,ht=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,w,P);else{let J=zg(s,w,"vertex"),Q=zg(s,P,"fragment");ne("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+D+`
`+J+`
`+Q)}else D!==""?Kt("WebGLProgram: Program Info Log:",D):(V===""||K==="")&&(ht=!1);ht&&(U.diagnostics={runnable:H,programLog:D,vertexShader:{log:V,prefix:b},fragmentShader:{log:K,prefix:d}})}s.deleteShader(w),s.deleteShader(P),v=new Ia(s,g),E=vw(s,g)}let v;this.getUniforms=function(){return v===void 0&&T(this),v};let E;this.getAttributes=function(){return E===void 0&&T(this),E};let z=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return z===!1&&(z=s.getProgramParameter(g,lw)),z},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=cw++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=w,this.fragmentShader=P,this}var Pw=0,dd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new pd(t),e.set(t,n)),n}},pd=class{constructor(t){this.id=Pw++,this.code=t,this.usedTimes=0}};function Iw(i){return i===is||i===Zo||i===Ko}function Lw(i,t,e,n,s,r){let a=new ba,o=new dd,l=new Set,c=[],h=new Map,f=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(v){return l.add(v),v===0?"uv":`uv${v}`}function g(v,E,z,U,N,W){let G=U.fog,D=N.geometry,V=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?U.environment:null,K=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,H=t.get(v.envMap||V,K),ht=u[v.type],J=n.precision;v.precision!==null&&(J=n.getMaxPrecision(v.precision),J!==v.precision&&Kt("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,rt=Q!==void 0?Q.length:0,dt=0;D.morphAttributes.position!==void 0&&(dt=1),D.morphAttributes.normal!==void 0&&(dt=2),D.morphAttributes.color!==void 0&&(dt=3);let ft,tt,gt,xt;if(ht){let Rt=rs[ht];ft=Rt.vertexShader,tt=Rt.fragmentShader}else{ft=v.vertexShader,tt=v.fragmentShader;let Rt=o.getVertexShaderStage(v),ue=o.getFragmentShaderStage(v);o.update(v,Rt,ue),gt=Rt.id,xt=ue.id}let Ct=i.getRenderTarget(),Mt=i.state.buffers.depth.getReversed(),Yt=N.isInstancedMesh===!0,le=N.isBatchedMesh===!0,Xt=!!v.map,me=!!v.matcap,fe=!!H,ae=fe&&H.isPMREMTexture===!0,Je=!!v.aoMap,Ge=!!v.lightMap,cn=!!v.bumpMap&&v.wireframe===!1,Oe=!!v.normalMap,Cn=!!v.displacementMap,we=!!v.emissiveMap,yn=!!v.metalnessMap,tn=!!v.roughnessMap,hn=v.anisotropy>0,O=v.clearcoat>0,Pt=v.diffuseRoughness>0,Jt=v.dispersion>0,ce=v.retroreflectivity>0,wt=v.iridescence>0,ze=v.sheen>0,Vt=v.transmission>0,Zt=hn&&!!v.anisotropyMap,A=O&&!!v.clearcoatMap,x=O&&!!v.clearcoatNormalMap,q=O&&!!v.clearcoatRoughnessMap,ut=Pt&&!!v.diffuseRoughnessMap,ot=wt&&!!v.iridescenceMap,vt=wt&&!!v.iridescenceThicknessMap,yt=ze&&!!v.sheenColorMap,nt=ze&&!!v.sheenRoughnessMap,st=!!v.specularMap,mt=!!v.specularColorMap,F=!!v.specularIntensityMap,at=Vt&&!!v.transmissionMap,it=Vt&&!!v.thicknessMap,Et=!!v.gradientMap,_t=!!v.alphaMap,St=v.alphaTest>0,qt=!!v.alphaHash,te=!!v.extensions,ct=ns;v.toneMapped&&(Ct===null||Ct.isXRRenderTarget===!0)&&(ct=i.toneMapping);let kt=ae?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,ee={shaderID:ht,shaderType:v.type,shaderName:v.name,vertexShader:ft,fragmentShader:tt,defines:v.defines,customVertexShaderID:gt,customFragmentShaderID:xt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:le,batchingColor:le&&N._colorsTexture!==null,instancing:Yt,instancingColor:Yt&&N.instanceColor!==null,instancingMorph:Yt&&N.morphTexture!==null,outputColorSpace:Ct===null?i.outputColorSpace:Ct.isXRRenderTarget===!0?Ct.texture.colorSpace:be.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Xt,matcap:me,envMap:fe,envMapMode:fe&&H.mapping,envMapPMREM:ae,envMapMaxLod:ae?kt.length-1:null,envMapSize:ae?kt[0].width:null,aoMap:Je,lightMap:Ge,bumpMap:cn,normalMap:Oe,displacementMap:Cn,emissiveMap:we,normalMapObjectSpace:Oe&&v.normalMapType===hg,normalMapTangentSpace:Oe&&v.normalMapType===Yf,packedNormalMap:Oe&&v.normalMapType===Yf&&Iw(v.normalMap.format),metalnessMap:yn,roughnessMap:tn,anisotropy:hn,anisotropyMap:Zt,clearcoat:O,clearcoatMap:A,clearcoatNormalMap:x,clearcoatRoughnessMap:q,diffuseRoughness:Pt,diffuseRoughnessMap:ut,dispersion:Jt,retroreflection:ce,iridescence:wt,iridescenceMap:ot,iridescenceThicknessMap:vt,sheen:ze,sheenColorMap:yt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:mt,specularIntensityMap:F,transmission:Vt,transmissionMap:at,thicknessMap:it,gradientMap:Et,opaque:v.transparent===!1&&v.blending===Aa&&v.alphaToCoverage===!1,alphaMap:_t,alphaTest:St,alphaHash:qt,combine:v.combine,mapUv:Xt&&p(v.map.channel),aoMapUv:Je&&p(v.aoMap.channel),lightMapUv:Ge&&p(v.lightMap.channel),bumpMapUv:cn&&p(v.bumpMap.channel),normalMapUv:Oe&&p(v.normalMap.channel),displacementMapUv:Cn&&p(v.displacementMap.channel),emissiveMapUv:we&&p(v.emissiveMap.channel),metalnessMapUv:yn&&p(v.metalnessMap.channel),roughnessMapUv:tn&&p(v.roughnessMap.channel),anisotropyMapUv:Zt&&p(v.anisotropyMap.channel),clearcoatMapUv:A&&p(v.clearcoatMap.channel),clearcoatNormalMapUv:x&&p(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&p(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&p(v.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&p(v.iridescenceMap.channel),iridescenceThicknessMapUv:vt&&p(v.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&p(v.sheenColorMap.channel),sheenRoughnessMapUv:nt&&p(v.sheenRoughnessMap.channel),specularMapUv:st&&p(v.specularMap.channel),specularColorMapUv:mt&&p(v.specularColorMap.channel),specularIntensityMapUv:F&&p(v.specularIntensityMap.channel),transmissionMapUv:at&&p(v.transmissionMap.channel),thicknessMapUv:it&&p(v.thicknessMap.channel),alphaMapUv:_t&&p(v.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Oe||hn),vertexNormals:!!D.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!D.attributes.uv&&(Xt||_t),fog:!!G,useFog:v.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||D.attributes.normal===void 0&&Oe===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:Mt,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:rt,morphTextureStride:dt,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:W.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:i.shadowMap.enabled&&z.length>0,shadowMapType:i.shadowMap.type,toneMapping:ct,decodeVideoTexture:Xt&&v.map.isVideoTexture===!0&&be.getTransfer(v.map.colorSpace)===Le,decodeVideoTextureEmissive:we&&v.emissiveMap.isVideoTexture===!0&&be.getTransfer(v.emissiveMap.colorSpace)===Le,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Ii,flipSided:v.side===Qn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:te&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(te&&v.extensions.multiDraw===!0||le)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return ee.vertexUv1s=l.has(1),ee.vertexUv2s=l.has(2),ee.vertexUv3s=l.has(3),l.clear(),ee}function b(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let z in v.defines)E.push(z),E.push(v.defines[z]);return v.isRawShaderMaterial===!1&&(d(E,v),m(E,v),E.push(i.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function d(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function m(v,E){a.disableAll(),E.instancing&&a.enable(0),E.instancingColor&&a.enable(1),E.instancingMorph&&a.enable(2),E.matcap&&a.enable(3),E.envMap&&a.enable(4),E.normalMapObjectSpace&&a.enable(5),E.normalMapTangentSpace&&a.enable(6),E.clearcoat&&a.enable(7),E.iridescence&&a.enable(8),E.alphaTest&&a.enable(9),E.vertexColors&&a.enable(10),E.vertexAlphas&&a.enable(11),E.vertexUv1s&&a.enable(12),E.vertexUv2s&&a.enable(13),E.vertexUv3s&&a.enable(14),E.vertexTangents&&a.enable(15),E.anisotropy&&a.enable(16),E.alphaHash&&a.enable(17),E.batching&&a.enable(18),E.dispersion&&a.enable(19),E.retroreflection&&a.enable(24),E.diffuseRoughness&&a.enable(25),E.batchingColor&&a.enable(20),E.gradientMap&&a.enable(21),E.packedNormalMap&&a.enable(22),E.vertexNormals&&a.enable(23),v.push(a.mask),a.disableAll(),E.fog&&a.enable(0),E.useFog&&a.enable(1),E.flatShading&&a.enable(2),E.logarithmicDepthBuffer&&a.enable(3),E.reversedDepthBuffer&&a.enable(4),E.skinning&&a.enable(5),E.morphTargets&&a.enable(6),E.morphNormals&&a.enable(7),E.morphColors&&a.enable(8),E.premultipliedAlpha&&a.enable(9),E.shadowMapEnabled&&a.enable(10),E.doubleSided&&a.enable(11),E.flipSided&&a.enable(12),E.useDepthPacking&&a.enable(13),E.dithering&&a.enable(14),E.transmission&&a.enable(15),E.sheen&&a.enable(16),E.opaque&&a.enable(17),E.pointsUvs&&a.enable(18),E.decodeVideoTexture&&a.enable(19),E.decodeVideoTextureEmissive&&a.enable(20),E.alphaToCoverage&&a.enable(21),E.numLightProbeGrids>0&&a.enable(22),E.hasPositionAttribute&&a.enable(23),v.push(a.mask)}function y(v){let E=u[v.type],z;if(E){let U=rs[E];z=Eg.clone(U.uniforms)}else z=v.uniforms;return z}function C(v,E){let z=h.get(E);return z!==void 0?++z.usedTimes:(z=new Rw(i,E,v,s),c.push(z),h.set(E,z)),z}function w(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),h.delete(v.cacheKey),v.destroy()}}function P(v){o.remove(v)}function T(){o.dispose()}return{getParameters:g,getProgramCacheKey:b,getUniforms:y,acquireProgram:C,releaseProgram:w,releaseShaderCache:P,programs:c,dispose:T}}function Dw(){let i=new WeakMap;function t(a){return i.has(a)}function e(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function Nw(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Xg(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function qg(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function a(u){let p=0;return u.isInstancedMesh&&(p+=2),u.isSkinnedMesh&&(p+=1),p}function o(u,p,g,b,d,m){let y=i[t];return y===void 0?(y={id:u.id,object:u,geometry:p,material:g,materialVariant:a(u),groupOrder:b,renderOrder:u.renderOrder,z:d,group:m},i[t]=y):(y.id=u.id,y.object=u,y.geometry=p,y.material=g,y.materialVariant=a(u),y.groupOrder=b,y.renderOrder=u.renderOrder,y.z=d,y.group=m),t++,y}function l(u,p,g,b,d,m,y){y.reversedDepth===!0&&(d=-d);let C=o(u,p,g,b,d,m);g.transmission>0?n.push(C):g.transparent===!0?s.push(C):e.push(C)}function c(u,p,g,b,d,m){let y=o(u,p,g,b,d,m);g.transmission>0?n.unshift(y):g.transparent===!0?s.unshift(y):e.unshift(y)}function h(u,p){e.length>1&&e.sort(u||Nw),n.length>1&&n.sort(p||Xg),s.length>1&&s.sort(p||Xg)}function f(){for(let u=t,p=i.length;u<p;u++){let g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:f,sort:h}}function Uw(){let i=new WeakMap;function t(n,s){let r=i.get(n),a;return r===void 0?(a=new qg,i.set(n,[a])):s>=r.length?(a=new qg,r.push(a)):a=r[s],a}function e(){i=new WeakMap}return{get:t,dispose:e}}function Fw(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new X,color:new Se};break;case"SpotLight":e={position:new X,direction:new X,color:new Se,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new X,color:new Se,distance:0,decay:0};break;case"HemisphereLight":e={direction:new X,skyColor:new Se,groundColor:new Se};break;case"RectAreaLight":e={color:new Se,position:new X,halfWidth:new X,halfHeight:new X};break}return i[t.id]=e,e}}}function Ow(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ie};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ie};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ie,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Bw=0;function kw(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function zw(i){let t=new Fw,e=Ow(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new X);let s=new X,r=new ke,a=new ke;function o(c){let h=0,f=0,u=0;for(let W=0;W<9;W++)n.probe[W].set(0,0,0);let p=0,g=0,b=0,d=0,m=0,y=0,C=0,w=0,P=0,T=0,v=0,E=0,z=0,U=0;c.sort(kw);for(let W=0,G=c.length;W<G;W++){let D=c[W],V=D.color,K=D.intensity,H=D.distance,ht=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===is?ht=D.shadow.map.texture:ht=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=V.r*K,f+=V.g*K,u+=V.b*K;else if(D.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(D.sh.coefficients[J],K);U++}else if(D.isSunLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,rt=e.get(D);rt.shadowIntensity=Q.intensity,rt.shadowBias=Q.bias,rt.shadowNormalBias=Q.normalBias,rt.shadowRadius=Q.radius,rt.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=rt,n.sunShadowMap[g]=ht;let dt=Q.getViewportCount();for(let ft=0;ft<dt;ft++)n.sunShadowMatrix[b+ft]=Q.getMatrix(ft),n.sunShadowCascade[b+ft]=Q._cascadeData[ft];b+=dt,g++}n.sun[p]=J,p++}else if(D.isDirectionalLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,rt=e.get(D);rt.shadowIntensity=Q.intensity,rt.shadowBias=Q.bias,rt.shadowNormalBias=Q.normalBias,rt.shadowRadius=Q.radius,rt.shadowMapSize=Q.mapSize,n.directionalShadow[d]=rt,n.directionalShadowMap[d]=ht,n.directionalShadowMatrix[d]=D.shadow.matrix,P++}n.directional[d]=J,d++}else if(D.isSpotLight){let J=t.get(D);J.position.setFromMatrixPosition(D.matrixWorld),J.color.copy(V).multiplyScalar(K),J.distance=H,J.coneCos=Math.cos(D.angle),J.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),J.decay=D.decay,n.spot[y]=J;let Q=D.shadow;if(D.map&&(n.spotLightMap[E]=D.map,E++,Q.updateMatrices(D),D.castShadow&&z++),n.spotLightMatrix[y]=Q.matrix,D.castShadow){let rt=e.get(D);rt.shadowIntensity=Q.intensity,rt.shadowBias=Q.bias,rt.shadowNormalBias=Q.normalBias,rt.shadowRadius=Q.radius,rt.shadowMapSize=Q.mapSize,n.spotShadow[y]=rt,n.spotShadowMap[y]=ht,v++}y++}else if(D.isRectAreaLight){let J=t.get(D);J.color.copy(V).multiplyScalar(K),J.halfWidth.set(D.width*.5,0,0),J.halfHeight.set(0,D.height*.5,0),n.rectArea[C]=J,C++}else if(D.isPointLight){let J=t.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),J.distance=D.distance,J.decay=D.decay,D.castShadow){let Q=D.shadow,rt=e.get(D);rt.shadowIntensity=Q.intensity,rt.shadowBias=Q.bias,rt.shadowNormalBias=Q.normalBias,rt.shadowRadius=Q.radius,rt.shadowMapSize=Q.mapSize,rt.shadowCameraNear=Q.camera.near,rt.shadowCameraFar=Q.camera.far,n.pointShadow[m]=rt,n.pointShadowMap[m]=ht,n.pointShadowMatrix[m]=D.shadow.matrix,T++}n.point[m]=J,m++}else if(D.isHemisphereLight){let J=t.get(D);J.skyColor.copy(D.color).multiplyScalar(K),J.groundColor.copy(D.groundColor).multiplyScalar(K),n.hemi[w]=J,w++}}C>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Dt.LTC_FLOAT_1,n.rectAreaLTC2=Dt.LTC_FLOAT_2):(n.rectAreaLTC1=Dt.LTC_HALF_1,n.rectAreaLTC2=Dt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=f,n.ambient[2]=u;let N=n.hash;(N.sunLength!==p||N.directionalLength!==d||N.pointLength!==m||N.spotLength!==y||N.rectAreaLength!==C||N.hemiLength!==w||N.numSunShadows!==g||N.numDirectionalShadows!==P||N.numPointShadows!==T||N.numSpotShadows!==v||N.numSpotMaps!==E||N.numLightProbes!==U)&&(n.sun.length=p,n.directional.length=d,n.spot.length=y,n.rectArea.length=C,n.point.length=m,n.hemi.length=w,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=b,n.sunShadowCascade.length=b,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=v,n.spotShadowMap.length=v,n.spotLightMatrix.length=v+E-z,n.spotLightMap.length=E,n.numSpotLightShadowsWithMaps=z,n.numLightProbes=U,N.sunLength=p,N.directionalLength=d,N.pointLength=m,N.spotLength=y,N.rectAreaLength=C,N.hemiLength=w,N.numSunShadows=g,N.numDirectionalShadows=P,N.numPointShadows=T,N.numSpotShadows=v,N.numSpotMaps=E,N.numLightProbes=U,n.version=Bw++)}function l(c,h){let f=0,u=0,p=0,g=0,b=0,d=0,m=h.matrixWorldInverse;for(let y=0,C=c.length;y<C;y++){let w=c[y];if(w.isSunLight){let P=n.sun[f];P.direction.setFromMatrixPosition(w.matrixWorld),P.direction.transformDirection(m),f++}else if(w.isDirectionalLight){let P=n.directional[u];P.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),u++}else if(w.isSpotLight){let P=n.spot[g];P.position.setFromMatrixPosition(w.matrixWorld),P.position.applyMatrix4(m),P.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),g++}else if(w.isRectAreaLight){let P=n.rectArea[b];P.position.setFromMatrixPosition(w.matrixWorld),P.position.applyMatrix4(m),a.identity(),r.copy(w.matrixWorld),r.premultiply(m),a.extractRotation(r),P.halfWidth.set(w.width*.5,0,0),P.halfHeight.set(0,w.height*.5,0),P.halfWidth.applyMatrix4(a),P.halfHeight.applyMatrix4(a),b++}else if(w.isPointLight){let P=n.point[p];P.position.setFromMatrixPosition(w.matrixWorld),P.position.applyMatrix4(m),p++}else if(w.isHemisphereLight){let P=n.hemi[d];P.direction.setFromMatrixPosition(w.matrixWorld),P.direction.transformDirection(m),d++}}}return{setup:o,setupView:l,state:n}}function Yg(i){let t=new zw(i),e=[],n=[],s=[];function r(f){h.camera=f,e.length=0,n.length=0,s.length=0}function a(f){f.isLightProbeGrid?s.push(f):e.push(f)}function o(f){n.push(f)}function l(){t.setup(e),s.sort((f,u)=>f.priority-u.priority||f.id-u.id)}function c(f){t.setupView(e,f)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function Hw(i){let t=new WeakMap;function e(s,r=0){let a=t.get(s),o;return a===void 0?(o=new Yg(i),t.set(s,[o])):r>=a.length?(o=new Yg(i),a.push(o)):o=a[r],o}function n(){t=new WeakMap}return{get:e,dispose:n}}var Vw=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Gw=`uniform sampler2D shadow_pass;
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
}`,Ww=[new X(1,0,0),new X(-1,0,0),new X(0,1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1)],Xw=[new X(0,-1,0),new X(0,-1,0),new X(0,0,1),new X(0,0,-1),new X(0,-1,0),new X(0,-1,0)],$g=new ke,Jo=new X,ld=new X;function qw(i,t,e){let n=new br,s=new ie,r=new ie,a=new Ze,o=new Ic,l=new Lc,c={},h=e.maxTextureSize,f={[sr]:Qn,[Qn]:sr,[Ii]:Ii},u=new On({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ie},radius:{value:4}},vertexShader:Vw,fragmentShader:Gw}),p=u.clone();p.defines.HORIZONTAL_PASS=1;let g=new Fn;g.setAttribute("position",new Un(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Hn(g,u),d=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Go;let m=this.type;this.render=function(T,v,E){if(d.enabled===!1||d.autoUpdate===!1&&d.needsUpdate===!1||T.length===0)return;this.type===Hm&&(Kt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Go);let z=i.getRenderTarget(),U=i.getActiveCubeFace(),N=i.getActiveMipmapLevel(),W=i.state;W.setBlending(Sr),W.buffers.depth.getReversed()===!0?W.buffers.color.setClear(0,0,0,0):W.buffers.color.setClear(1,1,1,1),W.buffers.depth.setTest(!0),W.setScissorTest(!1);let G=m!==this.type;G&&v.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=T.length;D<V;D++){let K=T[D],H=K.shadow;if(H===void 0){Kt("WebGLShadowMap:",K,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ht=H.getFrameExtents();s.multiply(ht),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ht.x),s.x=r.x*ht.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ht.y),s.y=r.y*ht.y,H.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=J,H.map===null||G===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Ta){if(K.isPointLight){Kt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new mi(s.x,s.y,{format:is,type:Vi,minFilter:jn,magFilter:jn,generateMipmaps:!1}),H.map.texture.name=K.name+".shadowMap",H.map.depthTexture=new Es(s.x,s.y,xi),H.map.depthTexture.name=K.name+".shadowMapDepth",H.map.depthTexture.format=ws,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=gn,H.map.depthTexture.magFilter=gn}else K.isPointLight?(H.map=new Qo(s.x),H.map.depthTexture=new Uo(s.x,Hi)):(H.map=new mi(s.x,s.y),H.map.depthTexture=new Es(s.x,s.y,Hi)),H.map.depthTexture.name=K.name+".shadowMap",H.map.depthTexture.format=ws,this.type===Go?(H.map.depthTexture.compareFunction=J?Zf:$f,H.map.depthTexture.minFilter=jn,H.map.depthTexture.magFilter=jn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=gn,H.map.depthTexture.magFilter=gn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();K.isPointLight!==!0&&H.updateMatrices(K,E);let rt=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:E.layers;for(let dt=0;dt<Q;dt++){let ft=H.getCamera(dt);if(K.isPointLight){let tt=H.camera,gt=H.matrix,xt=K.distance||tt.far;xt!==tt.far&&(tt.far=xt,tt.updateProjectionMatrix()),Jo.setFromMatrixPosition(K.matrixWorld),tt.position.copy(Jo),ld.copy(tt.position),ld.add(Ww[dt]),tt.up.copy(Xw[dt]),tt.lookAt(ld),tt.updateMatrixWorld(),gt.makeTranslation(-Jo.x,-Jo.y,-Jo.z),$g.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),H._frustum.setFromProjectionMatrix($g,tt.coordinateSystem,tt.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,dt),i.clear();else{dt===0&&(i.setRenderTarget(H.map),i.clear());let tt=H.getViewport(dt);a.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),W.viewport(a)}n=H.getFrustum(dt),w(v,E,ft,K,rt,this.type)}H.isPointLightShadow!==!0&&this.type===Ta&&y(H,E),H.needsUpdate=!1}m=this.type,d.needsUpdate=!1,i.setRenderTarget(z,U,N)};function y(T,v){let E=t.update(b);u.defines.VSM_SAMPLES!==T.blurSamples&&(u.defines.VSM_SAMPLES=T.blurSamples,p.defines.VSM_SAMPLES=T.blurSamples,u.needsUpdate=!0,p.needsUpdate=!0),T.mapPass===null?T.mapPass=new mi(s.x,s.y,{format:is,type:Vi}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),u.uniforms.shadow_pass.value=T.map.depthTexture,u.uniforms.resolution.value.set(T.map.width,T.map.height),u.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(v,null,E,u,b,null),p.uniforms.shadow_pass.value=T.mapPass.texture,p.uniforms.resolution.value.set(T.map.width,T.map.height),p.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(v,null,E,p,b,null)}function C(T,v,E,z){let U=null,N=E.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(N!==void 0)U=N;else if(U=E.isPointLight===!0?l:o,i.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let W=U.uuid,G=v.uuid,D=c[W];D===void 0&&(D={},c[W]=D);let V=D[G];V===void 0&&(V=U.clone(),D[G]=V,v.addEventListener("dispose",P)),U=V}if(U.visible=v.visible,U.wireframe=v.wireframe,z===Ta?U.side=v.shadowSide!==null?v.shadowSide:v.side:U.side=v.shadowSide!==null?v.shadowSide:f[v.side],U.alphaMap=v.alphaMap,U.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,U.map=v.map,U.clipShadows=v.clipShadows,U.clippingPlanes=v.clippingPlanes,U.clipIntersection=v.clipIntersection,U.displacementMap=v.displacementMap,U.displacementScale=v.displacementScale,U.displacementBias=v.displacementBias,U.wireframeLinewidth=v.wireframeLinewidth,U.linewidth=v.linewidth,E.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let W=i.properties.get(U);W.light=E}return U}function w(T,v,E,z,U,N){if(T.visible===!1)return;if(T.layers.test(U)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&N===Ta)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,T.matrixWorld);let D=t.update(T),V=T.material;if(Array.isArray(V)){let K=D.groups;for(let H=0,ht=K.length;H<ht;H++){let J=K[H],Q=V[J.materialIndex];if(Q&&Q.visible){let rt=C(T,Q,z,N);T.onBeforeShadow(i,T,v,E,D,rt,J),i.renderBufferDirect(E,null,D,rt,T,J),T.onAfterShadow(i,T,v,E,D,rt,J)}}}else if(V.visible){let K=C(T,V,z,N);T.onBeforeShadow(i,T,v,E,D,K,null),i.renderBufferDirect(E,null,D,K,T,null),T.onAfterShadow(i,T,v,E,D,K,null)}}let G=T.children;for(let D=0,V=G.length;D<V;D++)w(G[D],v,E,z,U,N)}function P(T){T.target.removeEventListener("dispose",P);for(let E in c){let z=c[E],U=T.target.uuid;U in z&&(z[U].dispose(),delete z[U])}}}function Yw(i,t){function e(){let F=!1,at=new Ze,it=null,Et=new Ze(0,0,0,0);return{setMask:function(_t){it!==_t&&!F&&(i.colorMask(_t,_t,_t,_t),it=_t)},setLocked:function(_t){F=_t},setClear:function(_t,St,qt,te,ct){ct===!0&&(_t*=te,St*=te,qt*=te),at.set(_t,St,qt,te),Et.equals(at)===!1&&(i.clearColor(_t,St,qt,te),Et.copy(at))},reset:function(){F=!1,it=null,Et.set(-1,0,0,0)}}}function n(){let F=!1,at=!1,it=null,Et=null,_t=null;return{setReversed:function(St){if(at!==St){let qt=t.get("EXT_clip_control");St?qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.ZERO_TO_ONE_EXT):qt.clipControlEXT(qt.LOWER_LEFT_EXT,qt.NEGATIVE_ONE_TO_ONE_EXT),at=St;let te=_t;_t=null,this.setClear(te)}},getReversed:function(){return at},setTest:function(St){St?Mt(i.DEPTH_TEST):Yt(i.DEPTH_TEST)},setMask:function(St){it!==St&&!F&&(i.depthMask(St),it=St)},setFunc:function(St){if(at&&(St=bg[St]),Et!==St){switch(St){case uc:i.depthFunc(i.NEVER);break;case fc:i.depthFunc(i.ALWAYS);break;case dc:i.depthFunc(i.LESS);break;case _a:i.depthFunc(i.LEQUAL);break;case pc:i.depthFunc(i.EQUAL);break;case mc:i.depthFunc(i.GEQUAL);break;case gc:i.depthFunc(i.GREATER);break;case _c:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Et=St}},setLocked:function(St){F=St},setClear:function(St){_t!==St&&(_t=St,at&&(St=1-St),i.clearDepth(St))},reset:function(){F=!1,it=null,Et=null,_t=null,at=!1}}}function s(){let F=!1,at=null,it=null,Et=null,_t=null,St=null,qt=null,te=null,ct=null;return{setTest:function(kt){F||(kt?Mt(i.STENCIL_TEST):Yt(i.STENCIL_TEST))},setMask:function(kt){at!==kt&&!F&&(i.stencilMask(kt),at=kt)},setFunc:function(kt,ee,Rt){(it!==kt||Et!==ee||_t!==Rt)&&(i.stencilFunc(kt,ee,Rt),it=kt,Et=ee,_t=Rt)},setOp:function(kt,ee,Rt){(St!==kt||qt!==ee||te!==Rt)&&(i.stencilOp(kt,ee,Rt),St=kt,qt=ee,te=Rt)},setLocked:function(kt){F=kt},setClear:function(kt){ct!==kt&&(i.clearStencil(kt),ct=kt)},reset:function(){F=!1,at=null,it=null,Et=null,_t=null,St=null,qt=null,te=null,ct=null}}}let r=new e,a=new n,o=new s,l={},c=new WeakMap,h={},f={},u={},p=new WeakMap,g=[],b=null,d=!1,m=null,y=null,C=null,w=null,P=null,T=null,v=null,E=new Se(0,0,0),z=0,U=!1,N=null,W=null,G=null,D=null,V=null,K=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ht=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(ht=parseFloat(/^WebGL (\d)/.exec(J)[1]),H=ht>=1):J.indexOf("OpenGL ES")!==-1&&(ht=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),H=ht>=2);let Q=null,rt={},dt=i.getParameter(i.SCISSOR_BOX),ft=i.getParameter(i.VIEWPORT),tt=new Ze().fromArray(dt),gt=new Ze().fromArray(ft);function xt(F,at,it,Et){let _t=new Uint8Array(4),St=i.createTexture();i.bindTexture(F,St),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let qt=0;qt<it;qt++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(at,0,i.RGBA,1,1,Et,0,i.RGBA,i.UNSIGNED_BYTE,_t):i.texImage2D(at+qt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_t);return St}let Ct={};Ct[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),Ct[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ct[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ct[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),Mt(i.DEPTH_TEST),a.setFunc(_a),cn(!1),Oe(Ef),Mt(i.CULL_FACE),Je(Sr);function Mt(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function Yt(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function le(F,at){return u[F]!==at?(i.bindFramebuffer(F,at),u[F]=at,F===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=at),F===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=at),!0):!1}function Xt(F,at){let it=g,Et=!1;if(F){it=p.get(at),it===void 0&&(it=[],p.set(at,it));let _t=F.textures;if(it.length!==_t.length||it[0]!==i.COLOR_ATTACHMENT0){for(let St=0,qt=_t.length;St<qt;St++)it[St]=i.COLOR_ATTACHMENT0+St;it.length=_t.length,Et=!0}}else it[0]!==i.BACK&&(it[0]=i.BACK,Et=!0);Et&&i.drawBuffers(it)}function me(F){return b!==F?(i.useProgram(F),b=F,!0):!1}let fe={[Mr]:i.FUNC_ADD,[Gm]:i.FUNC_SUBTRACT,[Wm]:i.FUNC_REVERSE_SUBTRACT};fe[Xm]=i.MIN,fe[qm]=i.MAX;let ae={[Ym]:i.ZERO,[$m]:i.ONE,[Zm]:i.SRC_COLOR,[Rf]:i.SRC_ALPHA,[eg]:i.SRC_ALPHA_SATURATE,[Qm]:i.DST_COLOR,[Jm]:i.DST_ALPHA,[Km]:i.ONE_MINUS_SRC_COLOR,[Pf]:i.ONE_MINUS_SRC_ALPHA,[tg]:i.ONE_MINUS_DST_COLOR,[jm]:i.ONE_MINUS_DST_ALPHA,[ng]:i.CONSTANT_COLOR,[ig]:i.ONE_MINUS_CONSTANT_COLOR,[sg]:i.CONSTANT_ALPHA,[rg]:i.ONE_MINUS_CONSTANT_ALPHA};function Je(F,at,it,Et,_t,St,qt,te,ct,kt){if(F===Sr){d===!0&&(Yt(i.BLEND),d=!1);return}if(d===!1&&(Mt(i.BLEND),d=!0),F!==Vm){if(F!==m||kt!==U){if((y!==Mr||P!==Mr)&&(i.blendEquation(i.FUNC_ADD),y=Mr,P=Mr),kt)switch(F){case Aa:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Tf:i.blendFunc(i.ONE,i.ONE);break;case Af:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Cf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ne("WebGLState: Invalid blending: ",F);break}else switch(F){case Aa:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Tf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Af:ne("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Cf:ne("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ne("WebGLState: Invalid blending: ",F);break}C=null,w=null,T=null,v=null,E.set(0,0,0),z=0,m=F,U=kt}return}_t=_t||at,St=St||it,qt=qt||Et,(at!==y||_t!==P)&&(i.blendEquationSeparate(fe[at],fe[_t]),y=at,P=_t),(it!==C||Et!==w||St!==T||qt!==v)&&(i.blendFuncSeparate(ae[it],ae[Et],ae[St],ae[qt]),C=it,w=Et,T=St,v=qt),(te.equals(E)===!1||ct!==z)&&(i.blendColor(te.r,te.g,te.b,ct),E.copy(te),z=ct),m=F,U=!1}function Ge(F,at){F.side===Ii?Yt(i.CULL_FACE):Mt(i.CULL_FACE);let it=F.side===Qn;at&&(it=!it),cn(it),F.blending===Aa&&F.transparent===!1?Je(Sr):Je(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),a.setFunc(F.depthFunc),a.setTest(F.depthTest),a.setMask(F.depthWrite),r.setMask(F.colorWrite);let Et=F.stencilWrite;o.setTest(Et),Et&&(o.setMask(F.stencilWriteMask),o.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),o.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),we(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Mt(i.SAMPLE_ALPHA_TO_COVERAGE):Yt(i.SAMPLE_ALPHA_TO_COVERAGE)}function cn(F){N!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),N=F)}function Oe(F){F!==km?(Mt(i.CULL_FACE),F!==W&&(F===Ef?i.cullFace(i.BACK):F===zm?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Yt(i.CULL_FACE),W=F}function Cn(F){F!==G&&(H&&i.lineWidth(F),G=F)}function we(F,at,it){F?(Mt(i.POLYGON_OFFSET_FILL),(D!==at||V!==it)&&(D=at,V=it,a.getReversed()&&(at=-at,it=-it),i.polygonOffset(at,it))):Yt(i.POLYGON_OFFSET_FILL)}function yn(F){F?Mt(i.SCISSOR_TEST):Yt(i.SCISSOR_TEST)}function tn(F){F===void 0&&(F=i.TEXTURE0+K-1),Q!==F&&(i.activeTexture(F),Q=F)}function hn(F,at,it){it===void 0&&(Q===null?it=i.TEXTURE0+K-1:it=Q);let Et=rt[it];Et===void 0&&(Et={type:void 0,texture:void 0},rt[it]=Et),(Et.type!==F||Et.texture!==at)&&(Q!==it&&(i.activeTexture(it),Q=it),i.bindTexture(F,at||Ct[F]),Et.type=F,Et.texture=at)}function O(){let F=rt[Q];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Pt(){try{i.compressedTexImage2D(...arguments)}catch(F){ne("WebGLState:",F)}}function Jt(){try{i.compressedTexImage3D(...arguments)}catch(F){ne("WebGLState:",F)}}function ce(){try{i.texSubImage2D(...arguments)}catch(F){ne("WebGLState:",F)}}function wt(){try{i.texSubImage3D(...arguments)}catch(F){ne("WebGLState:",F)}}function ze(){try{i.compressedTexSubImage2D(...arguments)}catch(F){ne("WebGLState:",F)}}function Vt(){try{i.compressedTexSubImage3D(...arguments)}catch(F){ne("WebGLState:",F)}}function Zt(){try{i.texStorage2D(...arguments)}catch(F){ne("WebGLState:",F)}}function A(){try{i.texStorage3D(...arguments)}catch(F){ne("WebGLState:",F)}}function x(){try{i.texImage2D(...arguments)}catch(F){ne("WebGLState:",F)}}function q(){try{i.texImage3D(...arguments)}catch(F){ne("WebGLState:",F)}}function ut(F){return f[F]!==void 0?f[F]:i.getParameter(F)}function ot(F,at){f[F]!==at&&(i.pixelStorei(F,at),f[F]=at)}function vt(F){tt.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),tt.copy(F))}function yt(F){gt.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),gt.copy(F))}function nt(F,at){let it=c.get(at);it===void 0&&(it=new WeakMap,c.set(at,it));let Et=it.get(F);Et===void 0&&(Et=i.getUniformBlockIndex(at,F.name),i.uniformBlockBinding(at,Et,Et),it.set(F,Et))}function st(F,at,it){let _t=c.get(at).get(F);l[_t]!==it&&(i.bindBufferBase(i.UNIFORM_BUFFER,_t,it),l[_t]=it)}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},f={},Q=null,rt={},u={},l={},p=new WeakMap,g=[],b=null,d=!1,m=null,y=null,C=null,w=null,P=null,T=null,v=null,E=new Se(0,0,0),z=0,U=!1,N=null,W=null,G=null,D=null,V=null,tt.set(0,0,i.canvas.width,i.canvas.height),gt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:Mt,disable:Yt,bindFramebuffer:le,drawBuffers:Xt,useProgram:me,setBlending:Je,setMaterial:Ge,setFlipSided:cn,setCullFace:Oe,setLineWidth:Cn,setPolygonOffset:we,setScissorTest:yn,activeTexture:tn,bindTexture:hn,unbindTexture:O,compressedTexImage2D:Pt,compressedTexImage3D:Jt,texImage2D:x,texImage3D:q,pixelStorei:ot,getParameter:ut,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Zt,texStorage3D:A,texSubImage2D:ce,texSubImage3D:wt,compressedTexSubImage2D:ze,compressedTexSubImage3D:Vt,scissor:vt,viewport:yt,reset:mt}}function $w(i,t,e,n,s,r,a){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ie,h=new WeakMap,f=new Set,u,p=new WeakMap,g=new Set,b=new FinalizationRegistry(A=>g.delete(A)),d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(A,x){return d?new OffscreenCanvas(A,x):Co("canvas")}function y(A,x,q){let ut=1,ot=Zt(A);if((ot.width>q||ot.height>q)&&(ut=q/Math.max(ot.width,ot.height)),ut<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let vt=Math.floor(ut*ot.width),yt=Math.floor(ut*ot.height);u===void 0&&(u=m(vt,yt));let nt=x?m(vt,yt):u;return nt.width=vt,nt.height=yt,nt.getContext("2d").drawImage(A,0,0,vt,yt),Kt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+vt+"x"+yt+")."),nt}else return"data"in A&&Kt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),A;return A}function C(A){return A.generateMipmaps}function w(A){i.generateMipmap(A)}function P(A){return A.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?i.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(A,x,q,ut,ot,vt=!1){if(A!==null){if(i[A]!==void 0)return i[A];Kt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let yt;ut&&(yt=t.get("EXT_texture_norm16"),yt||Kt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=x;if(x===i.RED&&(q===i.FLOAT&&(nt=i.R32F),q===i.HALF_FLOAT&&(nt=i.R16F),q===i.UNSIGNED_BYTE&&(nt=i.R8),q===i.UNSIGNED_SHORT&&yt&&(nt=yt.R16_EXT),q===i.SHORT&&yt&&(nt=yt.R16_SNORM_EXT)),x===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.R8UI),q===i.UNSIGNED_SHORT&&(nt=i.R16UI),q===i.UNSIGNED_INT&&(nt=i.R32UI),q===i.BYTE&&(nt=i.R8I),q===i.SHORT&&(nt=i.R16I),q===i.INT&&(nt=i.R32I)),x===i.RG&&(q===i.FLOAT&&(nt=i.RG32F),q===i.HALF_FLOAT&&(nt=i.RG16F),q===i.UNSIGNED_BYTE&&(nt=i.RG8),q===i.UNSIGNED_SHORT&&yt&&(nt=yt.RG16_EXT),q===i.SHORT&&yt&&(nt=yt.RG16_SNORM_EXT)),x===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RG8UI),q===i.UNSIGNED_SHORT&&(nt=i.RG16UI),q===i.UNSIGNED_INT&&(nt=i.RG32UI),q===i.BYTE&&(nt=i.RG8I),q===i.SHORT&&(nt=i.RG16I),q===i.INT&&(nt=i.RG32I)),x===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RGB8UI),q===i.UNSIGNED_SHORT&&(nt=i.RGB16UI),q===i.UNSIGNED_INT&&(nt=i.RGB32UI),q===i.BYTE&&(nt=i.RGB8I),q===i.SHORT&&(nt=i.RGB16I),q===i.INT&&(nt=i.RGB32I)),x===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(nt=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(nt=i.RGBA16UI),q===i.UNSIGNED_INT&&(nt=i.RGBA32UI),q===i.BYTE&&(nt=i.RGBA8I),q===i.SHORT&&(nt=i.RGBA16I),q===i.INT&&(nt=i.RGBA32I)),x===i.RGB&&(q===i.UNSIGNED_SHORT&&yt&&(nt=yt.RGB16_EXT),q===i.SHORT&&yt&&(nt=yt.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(nt=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(nt=i.R11F_G11F_B10F)),x===i.RGBA){let st=vt?To:be.getTransfer(ot);q===i.FLOAT&&(nt=i.RGBA32F),q===i.HALF_FLOAT&&(nt=i.RGBA16F),q===i.UNSIGNED_BYTE&&(nt=st===Le?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&yt&&(nt=yt.RGBA16_EXT),q===i.SHORT&&yt&&(nt=yt.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(nt=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(nt=i.RGB5_A1)}return(nt===i.R16F||nt===i.R32F||nt===i.RG16F||nt===i.RG32F||nt===i.RGBA16F||nt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function v(A,x){let q;return A?x===null||x===Hi||x===Er?q=i.DEPTH24_STENCIL8:x===xi?q=i.DEPTH32F_STENCIL8:x===Ra&&(q=i.DEPTH24_STENCIL8,Kt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===Hi||x===Er?q=i.DEPTH_COMPONENT24:x===xi?q=i.DEPTH_COMPONENT32F:x===Ra&&(q=i.DEPTH_COMPONENT16),q}function E(A,x){return C(A)===!0||A.isFramebufferTexture&&A.minFilter!==gn&&A.minFilter!==jn?Math.log2(Math.max(x.width,x.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?x.mipmaps.length:1}function z(A){let x=new WeakRef(A);n.get(A).__ref=x,g.add(x),b.register(A,x,x)}function U(A){let x=n.get(A).__ref;x!==void 0&&(g.delete(x),b.unregister(x))}function N(A){G(A.target)}function W(A){D(A.target)}function G(A){A.removeEventListener("dispose",N),U(A),K(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&f.delete(A)}function D(A){A.removeEventListener("dispose",W),U(A),ht(A)}function V(){for(let A of g){let x=A.deref();x!==void 0&&(x.isRenderTarget===!0?D(x):G(x))}g.clear(),f.clear()}function K(A){let x=n.get(A);if(x.__webglInit===void 0)return;let q=A.source,ut=p.get(q);if(ut){let ot=ut[x.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&H(A),Object.keys(ut).length===0&&p.delete(q)}n.remove(A)}function H(A){let x=n.get(A);i.deleteTexture(x.__webglTexture);let q=A.source,ut=p.get(q);delete ut[x.__cacheKey],a.memory.textures--}function ht(A){let x=n.get(A);x.__depthDisposeCallback&&x.__depthDisposeCallback();let q=A.depthTexture;if(q&&q.renderTarget===A&&G(q),A.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(x.__webglFramebuffer[ot]))for(let vt=0;vt<x.__webglFramebuffer[ot].length;vt++)i.deleteFramebuffer(x.__webglFramebuffer[ot][vt]);else i.deleteFramebuffer(x.__webglFramebuffer[ot]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[ot])}else{if(Array.isArray(x.__webglFramebuffer))for(let ot=0;ot<x.__webglFramebuffer.length;ot++)i.deleteFramebuffer(x.__webglFramebuffer[ot]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let ot=0;ot<x.__webglColorRenderbuffer.length;ot++)x.__webglColorRenderbuffer[ot]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[ot]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let ut=A.textures;for(let ot=0,vt=ut.length;ot<vt;ot++){let yt=n.get(ut[ot]);yt.__webglTexture&&(i.deleteTexture(yt.__webglTexture),a.memory.textures--),n.remove(ut[ot])}n.remove(A)}let J=0;function Q(){J=0}function rt(){return J}function dt(A){J=A}function ft(){let A=J;return A>=s.maxTextures&&Kt("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,A}function tt(A){let x=[];return x.push(A.wrapS),x.push(A.wrapT),x.push(A.wrapR||0),x.push(A.magFilter),x.push(A.minFilter),x.push(A.anisotropy),x.push(A.internalFormat),x.push(A.format),x.push(A.type),x.push(A.generateMipmaps),x.push(A.mipmapsAutoUpdate),x.push(A.premultiplyAlpha),x.push(A.flipY),x.push(A.unpackAlignment),x.push(A.colorSpace),x.join()}function gt(A,x){let q=n.get(A);if(A.isVideoTexture&&ze(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&q.__version!==A.version){let ut=A.image;if(ut===null)Kt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)Kt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ge(q,A,x);return}}else A.isExternalTexture&&(q.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+x)}function xt(A,x){let q=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&q.__version!==A.version){Ge(q,A,x);return}else A.isExternalTexture&&(q.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+x)}function Ct(A,x){let q=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&q.__version!==A.version){Ge(q,A,x);return}e.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+x)}function Mt(A,x){let q=n.get(A);if(A.version>0&&q.__version!==A.version){cn(q,A,x);return}e.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+x)}let Yt={[vc]:i.REPEAT,[es]:i.CLAMP_TO_EDGE,[xc]:i.MIRRORED_REPEAT},le={[gn]:i.NEAREST,[lg]:i.NEAREST_MIPMAP_NEAREST,[Wo]:i.NEAREST_MIPMAP_LINEAR,[jn]:i.LINEAR,[Yc]:i.LINEAR_MIPMAP_NEAREST,[Ts]:i.LINEAR_MIPMAP_LINEAR},Xt={[fg]:i.NEVER,[Kf]:i.ALWAYS,[dg]:i.LESS,[$f]:i.LEQUAL,[pg]:i.EQUAL,[Zf]:i.GEQUAL,[mg]:i.GREATER,[gg]:i.NOTEQUAL};function me(A,x){if(x.type===xi&&t.has("OES_texture_float_linear")===!1&&(x.magFilter===jn||x.magFilter===Yc||x.magFilter===Wo||x.magFilter===Ts||x.minFilter===jn||x.minFilter===Yc||x.minFilter===Wo||x.minFilter===Ts)&&Kt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(A,i.TEXTURE_WRAP_S,Yt[x.wrapS]),i.texParameteri(A,i.TEXTURE_WRAP_T,Yt[x.wrapT]),(A===i.TEXTURE_3D||A===i.TEXTURE_2D_ARRAY)&&i.texParameteri(A,i.TEXTURE_WRAP_R,Yt[x.wrapR]),i.texParameteri(A,i.TEXTURE_MAG_FILTER,le[x.magFilter]),i.texParameteri(A,i.TEXTURE_MIN_FILTER,le[x.minFilter]),x.compareFunction&&(i.texParameteri(A,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(A,i.TEXTURE_COMPARE_FUNC,Xt[x.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===gn||x.minFilter!==Wo&&x.minFilter!==Ts||x.type===xi&&t.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");i.texParameterf(A,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function fe(A,x){let q=!1;A.__webglInit===void 0&&(A.__webglInit=!0,x.addEventListener("dispose",N),z(x));let ut=x.source,ot=p.get(ut);ot===void 0&&(ot={},p.set(ut,ot));let vt=tt(x);if(vt!==A.__cacheKey){ot[vt]===void 0&&(ot[vt]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,q=!0),ot[vt].usedTimes++;let yt=ot[A.__cacheKey];yt!==void 0&&(ot[A.__cacheKey].usedTimes--,yt.usedTimes===0&&H(x)),A.__cacheKey=vt,A.__webglTexture=ot[vt].texture}return q}function ae(A,x,q){return Math.floor(Math.floor(A/q)/x)}function Je(A,x,q,ut){let vt=A.updateRanges;if(vt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,q,ut,x.data);else{vt.sort((F,at)=>F.start-at.start);let yt=0;for(let F=1;F<vt.length;F++){let at=vt[yt],it=vt[F],Et=at.start+at.count,_t=ae(it.start,x.width,4),St=ae(at.start,x.width,4);it.start<=Et+1&&_t===St&&ae(it.start+it.count-1,x.width,4)===_t?at.count=Math.max(at.count,it.start+it.count-at.start):(++yt,vt[yt]=it)}vt.length=yt+1;let nt=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),mt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let F=0,at=vt.length;F<at;F++){let it=vt[F],Et=Math.floor(it.start/4),_t=Math.ceil(it.count/4),St=Et%x.width,qt=Math.floor(Et/x.width),te=_t,ct=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,St),e.pixelStorei(i.UNPACK_SKIP_ROWS,qt),e.texSubImage2D(i.TEXTURE_2D,0,St,qt,te,ct,q,ut,x.data)}A.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,nt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,mt)}}function Ge(A,x,q){let ut=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(ut=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(ut=i.TEXTURE_3D);let ot=fe(A,x),vt=x.source;e.bindTexture(ut,A.__webglTexture,i.TEXTURE0+q);let yt=n.get(vt);if(vt.version!==yt.__version||ot===!0){if(e.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&x.image instanceof ImageBitmap)===!1){let ct=be.getPrimaries(be.workingColorSpace),kt=x.colorSpace===Cs?null:be.getPrimaries(x.colorSpace),ee=x.colorSpace===Cs||ct===kt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ee)}e.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment);let st=y(x.image,!1,s.maxTextureSize);st=Vt(x,st);let mt=r.convert(x.format,x.colorSpace),F=r.convert(x.type),at=T(x.internalFormat,mt,F,x.normalized,x.colorSpace,x.isVideoTexture);me(ut,x);let it,Et=x.mipmaps,_t=x.isVideoTexture!==!0,St=yt.__version===void 0||ot===!0,qt=vt.dataReady,te=E(x,st);if(x.isDepthTexture)at=v(x.format===As,x.type),St&&(_t?e.texStorage2D(i.TEXTURE_2D,1,at,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,at,st.width,st.height,0,mt,F,null));else if(x.isDataTexture)if(Et.length>0){_t&&St&&e.texStorage2D(i.TEXTURE_2D,te,at,Et[0].width,Et[0].height);for(let ct=0,kt=Et.length;ct<kt;ct++)it=Et[ct],_t?qt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,it.width,it.height,mt,F,it.data):e.texImage2D(i.TEXTURE_2D,ct,at,it.width,it.height,0,mt,F,it.data);x.generateMipmaps=!1}else _t?(St&&e.texStorage2D(i.TEXTURE_2D,te,at,st.width,st.height),qt&&Je(x,st,mt,F)):e.texImage2D(i.TEXTURE_2D,0,at,st.width,st.height,0,mt,F,st.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){_t&&St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,te,at,Et[0].width,Et[0].height,st.depth);for(let ct=0,kt=Et.length;ct<kt;ct++)if(it=Et[ct],x.format!==ti)if(mt!==null)if(_t){if(qt)if(x.layerUpdates.size>0){let ee=ad(it.width,it.height,x.format,x.type);for(let Rt of x.layerUpdates){let ue=it.data.subarray(Rt*ee/it.data.BYTES_PER_ELEMENT,(Rt+1)*ee/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,Rt,it.width,it.height,1,mt,ue)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,mt,it.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ct,at,it.width,it.height,st.depth,0,it.data,0,0);else Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?qt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,mt,F,it.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ct,at,it.width,it.height,st.depth,0,mt,F,it.data);x.layerUpdates.size>0&&x.clearLayerUpdates()}else{_t&&St&&e.texStorage2D(i.TEXTURE_2D,te,at,Et[0].width,Et[0].height);for(let ct=0,kt=Et.length;ct<kt;ct++)it=Et[ct],x.format!==ti?mt!==null?_t?qt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ct,0,0,it.width,it.height,mt,it.data):e.compressedTexImage2D(i.TEXTURE_2D,ct,at,it.width,it.height,0,it.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?qt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,it.width,it.height,mt,F,it.data):e.texImage2D(i.TEXTURE_2D,ct,at,it.width,it.height,0,mt,F,it.data)}else if(x.isDataArrayTexture)if(_t){if(St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,te,at,st.width,st.height,st.depth),qt)if(x.layerUpdates.size>0){let ct=ad(st.width,st.height,x.format,x.type);for(let kt of x.layerUpdates){let ee=st.data.subarray(kt*ct/st.data.BYTES_PER_ELEMENT,(kt+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,kt,st.width,st.height,1,mt,F,ee)}x.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,F,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,at,st.width,st.height,st.depth,0,mt,F,st.data);else if(x.isData3DTexture)_t?(St&&e.texStorage3D(i.TEXTURE_3D,te,at,st.width,st.height,st.depth),qt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,F,st.data)):e.texImage3D(i.TEXTURE_3D,0,at,st.width,st.height,st.depth,0,mt,F,st.data);else if(x.isFramebufferTexture){if(St)if(_t)e.texStorage2D(i.TEXTURE_2D,te,at,st.width,st.height);else{let ct=st.width,kt=st.height;for(let ee=0;ee<te;ee++)e.texImage2D(i.TEXTURE_2D,ee,at,ct,kt,0,mt,F,null),ct>>=1,kt>>=1}}else if(x.isHTMLTexture){if("texElementImage2D"in i){let ct=i.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),f.add(x),ct.onpaint=kt=>{let ee=kt.changedElements;for(let Rt of f)ee.includes(Rt.image)&&(Rt.needsUpdate=!0)},ct.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let ee=i.RGBA,Rt=i.RGBA,ue=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,ee,Rt,ue,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Et.length>0){if(_t&&St){let ct=Zt(Et[0]);e.texStorage2D(i.TEXTURE_2D,te,at,ct.width,ct.height)}for(let ct=0,kt=Et.length;ct<kt;ct++)it=Et[ct],_t?qt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,mt,F,it):e.texImage2D(i.TEXTURE_2D,ct,at,mt,F,it);x.generateMipmaps=!1}else if(_t){if(St){let ct=Zt(st);e.texStorage2D(i.TEXTURE_2D,te,at,ct.width,ct.height)}qt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,F,st)}else e.texImage2D(i.TEXTURE_2D,0,at,mt,F,st);C(x)&&x.mipmapsAutoUpdate===!0&&w(ut),yt.__version=vt.version,x.onUpdate&&x.onUpdate(x)}A.__version=x.version}function cn(A,x,q){if(x.image.length!==6)return;let ut=fe(A,x),ot=x.source;e.bindTexture(i.TEXTURE_CUBE_MAP,A.__webglTexture,i.TEXTURE0+q);let vt=n.get(ot);if(ot.version!==vt.__version||ut===!0){e.activeTexture(i.TEXTURE0+q);let yt=be.getPrimaries(be.workingColorSpace),nt=x.colorSpace===Cs?null:be.getPrimaries(x.colorSpace),st=x.colorSpace===Cs||yt===nt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=x.isCompressedTexture||x.image[0].isCompressedTexture,F=x.image[0]&&x.image[0].isDataTexture,at=[];for(let Rt=0;Rt<6;Rt++)!mt&&!F?at[Rt]=y(x.image[Rt],!0,s.maxCubemapSize):at[Rt]=F?x.image[Rt].image:x.image[Rt],at[Rt]=Vt(x,at[Rt]);let it=at[0],Et=r.convert(x.format,x.colorSpace),_t=r.convert(x.type),St=T(x.internalFormat,Et,_t,x.normalized,x.colorSpace),qt=x.isVideoTexture!==!0,te=vt.__version===void 0||ut===!0,ct=ot.dataReady,kt=E(x,it);me(i.TEXTURE_CUBE_MAP,x);let ee;if(x.isDepthTexture){if(St=v(x.format===As,x.type),te)if(qt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,St,it.width,it.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,it.width,it.height,0,Et,_t,null)}else if(mt){qt&&te&&e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,St,it.width,it.height);for(let Rt=0;Rt<6;Rt++){ee=at[Rt].mipmaps;for(let ue=0;ue<ee.length;ue++){let We=ee[ue];x.format!==ti?Et!==null?qt?ct&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,0,0,We.width,We.height,Et,We.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,St,We.width,We.height,0,We.data):Kt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,0,0,We.width,We.height,Et,_t,We.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,St,We.width,We.height,0,Et,_t,We.data)}}}else{if(ee=x.mipmaps,qt&&te){ee.length>0&&kt++;let Rt=Zt(at[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,kt,St,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(F){qt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,at[Rt].width,at[Rt].height,Et,_t,at[Rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,at[Rt].width,at[Rt].height,0,Et,_t,at[Rt].data);for(let ue=0;ue<ee.length;ue++){let Wn=ee[ue].image[Rt].image;qt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,0,0,Wn.width,Wn.height,Et,_t,Wn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,St,Wn.width,Wn.height,0,Et,_t,Wn.data)}}else{qt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,Et,_t,at[Rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,Et,_t,at[Rt]);for(let ue=0;ue<ee.length;ue++){let We=ee[ue];qt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,0,0,Et,_t,We.image[Rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,St,Et,_t,We.image[Rt])}}}C(x)&&x.mipmapsAutoUpdate===!0&&w(i.TEXTURE_CUBE_MAP),vt.__version=ot.version,x.onUpdate&&x.onUpdate(x)}A.__version=x.version}function Oe(A,x,q,ut,ot,vt){let yt=r.convert(q.format,q.colorSpace),nt=r.convert(q.type),st=T(q.internalFormat,yt,nt,q.normalized,q.colorSpace),mt=n.get(x),F=n.get(q);if(F.__renderTarget=x,!mt.__hasExternalTextures){let at=Math.max(1,x.width>>vt),it=Math.max(1,x.height>>vt);ot===i.TEXTURE_3D||ot===i.TEXTURE_2D_ARRAY?e.texImage3D(ot,vt,st,at,it,x.depth,0,yt,nt,null):e.texImage2D(ot,vt,st,at,it,0,yt,nt,null)}e.bindFramebuffer(i.FRAMEBUFFER,A),wt(x)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ut,ot,F.__webglTexture,0,ce(x)):(ot===i.TEXTURE_2D||ot>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ut,ot,F.__webglTexture,vt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Cn(A,x,q){if(i.bindRenderbuffer(i.RENDERBUFFER,A),x.depthBuffer){let ut=x.depthTexture,ot=ut&&ut.isDepthTexture?ut.type:null,vt=v(x.stencilBuffer,ot),yt=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;wt(x)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(x),vt,x.width,x.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(x),vt,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,vt,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,yt,i.RENDERBUFFER,A)}else{let ut=x.textures;for(let ot=0;ot<ut.length;ot++){let vt=ut[ot],yt=r.convert(vt.format,vt.colorSpace),nt=r.convert(vt.type),st=T(vt.internalFormat,yt,nt,vt.normalized,vt.colorSpace);wt(x)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ce(x),st,x.width,x.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ce(x),st,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,st,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function we(A,x,q){let ut=x.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,A),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=n.get(x.depthTexture);ot.__renderTarget=x;let vt=ut?x.depthTexture.image[0]:x.depthTexture.image;(!ot.__webglTexture||vt.width!==x.width||vt.height!==x.height)&&(vt.width=x.width,vt.height=x.height,x.depthTexture.needsUpdate=!0),ut?Mt(x.depthTexture,0):gt(x.depthTexture,0);let yt=ot.__webglTexture,nt=ce(x),st=ut?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,mt=x.depthTexture.format===As?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(x.depthTexture.format===ws)wt(x)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,yt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,yt,0);else if(x.depthTexture.format===As)wt(x)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,st,yt,0,nt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,st,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yn(A){let x=n.get(A),q=A.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==A.depthTexture){let ut=A.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),ut){let ot=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,ut.removeEventListener("dispose",ot)};ut.addEventListener("dispose",ot),x.__depthDisposeCallback=ot}x.__boundDepthTexture=ut}if(A.depthTexture&&!x.__autoAllocateDepthBuffer)if(q)for(let ut=0;ut<6;ut++)we(x.__webglFramebuffer[ut],A,ut);else A.texture.mipmaps.length>0?we(x.__webglFramebuffer[0],A,0):we(x.__webglFramebuffer,A,0);else if(q){x.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[ut]),x.__webglDepthbuffer[ut]===void 0)x.__webglDepthbuffer[ut]=i.createRenderbuffer(),Cn(x.__webglDepthbuffer[ut],A,!1);else{let ot=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=x.__webglDepthbuffer[ut];i.bindRenderbuffer(i.RENDERBUFFER,vt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,vt)}}else if(A.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),Cn(x.__webglDepthbuffer,A,!1);else{let ot=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,vt),i.framebufferRenderbuffer(i.FRAMEBUFFER,ot,i.RENDERBUFFER,vt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function tn(A,x,q){let ut=n.get(A);x!==void 0&&Oe(ut.__webglFramebuffer,A,A.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&yn(A)}function hn(A){let x=A.texture,q=n.get(A),ut=n.get(x);A.addEventListener("dispose",W),z(A);let ot=A.textures,vt=A.isWebGLCubeRenderTarget===!0,yt=ot.length>1;if(yt||(ut.__webglTexture===void 0&&(ut.__webglTexture=i.createTexture()),ut.__version=x.version,a.memory.textures++),vt){q.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(x.mipmaps.length>0){q.__webglFramebuffer[nt]=[];for(let st=0;st<x.mipmaps.length;st++)q.__webglFramebuffer[nt][st]=i.createFramebuffer()}else q.__webglFramebuffer[nt]=i.createFramebuffer()}else{if(x.mipmaps.length>0){q.__webglFramebuffer=[];for(let nt=0;nt<x.mipmaps.length;nt++)q.__webglFramebuffer[nt]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(yt)for(let nt=0,st=ot.length;nt<st;nt++){let mt=n.get(ot[nt]);mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture(),a.memory.textures++)}if(A.samples>0&&wt(A)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let nt=0;nt<ot.length;nt++){let st=ot[nt];q.__webglColorRenderbuffer[nt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[nt]);let mt=r.convert(st.format,st.colorSpace),F=r.convert(st.type),at=T(st.internalFormat,mt,F,st.normalized,st.colorSpace,A.isXRRenderTarget===!0),it=ce(A);i.renderbufferStorageMultisample(i.RENDERBUFFER,it,at,A.width,A.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+nt,i.RENDERBUFFER,q.__webglColorRenderbuffer[nt])}i.bindRenderbuffer(i.RENDERBUFFER,null),A.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),Cn(q.__webglDepthRenderbuffer,A,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(vt){e.bindTexture(i.TEXTURE_CUBE_MAP,ut.__webglTexture),me(i.TEXTURE_CUBE_MAP,x);for(let nt=0;nt<6;nt++)if(x.mipmaps.length>0)for(let st=0;st<x.mipmaps.length;st++)Oe(q.__webglFramebuffer[nt][st],A,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Oe(q.__webglFramebuffer[nt],A,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);C(x)?w(i.TEXTURE_CUBE_MAP):x.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,x.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let nt=0,st=ot.length;nt<st;nt++){let mt=ot[nt],F=n.get(mt),at=i.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(at=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(at,F.__webglTexture),me(at,mt),Oe(q.__webglFramebuffer,A,mt,i.COLOR_ATTACHMENT0+nt,at,0),C(mt)&&w(at)}e.unbindTexture()}else{let nt=i.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(nt=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(nt,ut.__webglTexture),me(nt,x),x.mipmaps.length>0)for(let st=0;st<x.mipmaps.length;st++)Oe(q.__webglFramebuffer[st],A,x,i.COLOR_ATTACHMENT0,nt,st);else Oe(q.__webglFramebuffer,A,x,i.COLOR_ATTACHMENT0,nt,0);C(x)?w(nt):x.mipmaps.length>0&&i.texParameteri(nt,i.TEXTURE_MAX_LEVEL,x.mipmaps.length-1),e.unbindTexture()}A.depthBuffer&&yn(A)}function O(A){let x=A.textures;for(let q=0,ut=x.length;q<ut;q++){let ot=x[q];if(C(ot)&&ot.mipmapsAutoUpdate===!0){let vt=P(A),yt=n.get(ot).__webglTexture;e.bindTexture(vt,yt),w(vt),e.unbindTexture()}}}let Pt=[];function Jt(A){if(A.samples>0){if(wt(A)===!1){let x=A.textures,q=A.width,ut=A.height,ot=i.COLOR_BUFFER_BIT,vt=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=n.get(A),nt=x.length>1;if(nt)for(let mt=0;mt<x.length;mt++)e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let mt=0;mt<x.length;mt++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(ot|=i.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(ot|=i.STENCIL_BUFFER_BIT)),nt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let F=n.get(x[mt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,q,ut,0,0,q,ut,ot,i.NEAREST),l===!0&&(Pt.length=0,Pt.push(i.COLOR_ATTACHMENT0+mt),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&Pt.push(vt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),nt)for(let mt=0;mt<x.length;mt++){e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let F=n.get(x[mt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,yt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,F,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){let x=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function ce(A){return Math.min(s.maxSamples,A.samples)}function wt(A){let x=n.get(A);return A.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function ze(A){let x=a.render.frame;h.get(A)!==x&&(h.set(A,x),A.update())}function Vt(A,x){let q=A.colorSpace,ut=A.format,ot=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||q!==$s&&q!==Cs&&(be.getTransfer(q)===Le?(ut!==ti||ot!==vi)&&Kt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ne("WebGLTextures: Unsupported texture color space:",q)),x}function Zt(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(c.width=A.naturalWidth||A.width,c.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(c.width=A.displayWidth,c.height=A.displayHeight):(c.width=A.width,c.height=A.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=Q,this.getTextureUnits=rt,this.setTextureUnits=dt,this.setTexture2D=gt,this.setTexture2DArray=xt,this.setTexture3D=Ct,this.setTextureCube=Mt,this.rebindTextures=tn,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Jt,this.setupDepthRenderbuffer=yn,this.setupFrameBufferTexture=Oe,this.useMultisampledRTT=wt,this.dispose=V}function Zw(i,t){function e(n,s=Cs){let r,a=be.getTransfer(s);if(n===vi)return i.UNSIGNED_BYTE;if(n===Zc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Kc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Vf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Gf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===zf)return i.BYTE;if(n===Hf)return i.SHORT;if(n===Ra)return i.UNSIGNED_SHORT;if(n===$c)return i.INT;if(n===Hi)return i.UNSIGNED_INT;if(n===xi)return i.FLOAT;if(n===Vi)return i.HALF_FLOAT;if(n===Wf)return i.ALPHA;if(n===Xf)return i.RGB;if(n===ti)return i.RGBA;if(n===ws)return i.DEPTH_COMPONENT;if(n===As)return i.DEPTH_STENCIL;if(n===qf)return i.RED;if(n===Jc)return i.RED_INTEGER;if(n===is)return i.RG;if(n===jc)return i.RG_INTEGER;if(n===Qc)return i.RGBA_INTEGER;if(n===Xo||n===qo||n===Yo||n===$o)if(a===Le)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Xo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===qo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Yo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===$o)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Xo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===qo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Yo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===$o)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===th||n===eh||n===nh||n===ih)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===th)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===eh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===nh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ih)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===sh||n===rh||n===ah||n===oh||n===lh||n===Zo||n===ch)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===sh||n===rh)return a===Le?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===ah)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===oh)return r.COMPRESSED_R11_EAC;if(n===lh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Zo)return r.COMPRESSED_RG11_EAC;if(n===ch)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===hh||n===uh||n===fh||n===dh||n===ph||n===mh||n===gh||n===_h||n===vh||n===xh||n===yh||n===bh||n===Sh||n===Mh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===hh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===uh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===fh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===dh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ph)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===mh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===gh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===_h)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===vh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===xh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===yh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===bh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Sh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Mh)return a===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===wh||n===Eh||n===Th)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===wh)return a===Le?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Eh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Th)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ah||n===Ch||n===Ko||n===Rh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ah)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ch)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ko)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Rh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Er?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var Kw=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Jw=`
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

}`,md=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Fo(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new On({vertexShader:Kw,fragmentShader:Jw,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Hn(new Bo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},gd=class extends zi{constructor(t,e){super();let n=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,f=null,u=null,p=null,g=null,b=typeof XRWebGLBinding<"u",d=new md,m={},y=e.getContextAttributes(),C=null,w=null,P=[],T=[],v=new ie,E=null,z=null,U=new Kn;U.viewport=new Ze;let N=new Kn;N.viewport=new Ze;let W=[U,N],G=new Wc,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let gt=P[tt];return gt===void 0&&(gt=new Sa,P[tt]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(tt){let gt=P[tt];return gt===void 0&&(gt=new Sa,P[tt]=gt),gt.getGripSpace()},this.getHand=function(tt){let gt=P[tt];return gt===void 0&&(gt=new Sa,P[tt]=gt),gt.getHandSpace()};function K(tt){let gt=T.indexOf(tt.inputSource);if(gt===-1)return;let xt=P[gt];xt!==void 0&&(xt.update(tt.inputSource,tt.frame,c||a),xt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function H(){s.removeEventListener("select",K),s.removeEventListener("selectstart",K),s.removeEventListener("selectend",K),s.removeEventListener("squeeze",K),s.removeEventListener("squeezestart",K),s.removeEventListener("squeezeend",K),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ht);for(let tt=0;tt<P.length;tt++){let gt=T[tt];gt!==null&&(T[tt]=null,P[tt].disconnect(gt))}D=null,V=null,d.reset();for(let tt in m)delete m[tt];if(t.setRenderTarget(C),p=null,u=null,f=null,s=null,w=null,ft.stop(),n.isPresenting=!1,t.setPixelRatio(E),t.setSize(v.width,v.height,!1),z!==null){let tt=z.camera;tt.fov=z.fov,tt.zoom=z.zoom,tt.updateProjectionMatrix(),z=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,n.isPresenting===!0&&Kt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){o=tt,n.isPresenting===!0&&Kt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return u!==null?u:p},this.getBinding=function(){return f===null&&b&&(f=new XRWebGLBinding(s,e)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(C=t.getRenderTarget(),s.addEventListener("select",K),s.addEventListener("selectstart",K),s.addEventListener("selectend",K),s.addEventListener("squeeze",K),s.addEventListener("squeezestart",K),s.addEventListener("squeezeend",K),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ht),y.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(v),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Ct=null,Mt=null;y.depth&&(Mt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=y.stencil?As:ws,Ct=y.stencil?Er:Hi);let Yt={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};f=this.getBinding(),u=f.createProjectionLayer(Yt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),w=new mi(u.textureWidth,u.textureHeight,{format:ti,type:vi,depthTexture:new Es(u.textureWidth,u.textureHeight,Ct,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let xt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),w=new mi(p.framebufferWidth,p.framebufferHeight,{format:ti,type:vi,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),ft.setContext(s),ft.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return d.getDepthTexture()};function ht(tt){for(let gt=0;gt<tt.removed.length;gt++){let xt=tt.removed[gt],Ct=T.indexOf(xt);Ct>=0&&(T[Ct]=null,P[Ct].disconnect(xt))}for(let gt=0;gt<tt.added.length;gt++){let xt=tt.added[gt],Ct=T.indexOf(xt);if(Ct===-1){for(let Yt=0;Yt<P.length;Yt++)if(Yt>=T.length){T.push(xt),Ct=Yt;break}else if(T[Yt]===null){T[Yt]=xt,Ct=Yt;break}if(Ct===-1)break}let Mt=P[Ct];Mt&&Mt.connect(xt)}}function J(tt,gt){gt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(gt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let gt=tt.near,xt=tt.far;d.texture!==null&&(d.depthNear>0&&(gt=d.depthNear),d.depthFar>0&&(xt=d.depthFar)),G.near=N.near=U.near=gt,G.far=N.far=U.far=xt,(D!==G.near||V!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),D=G.near,V=G.far),G.layers.mask=tt.layers.mask|6,U.layers.mask=G.layers.mask&-5,N.layers.mask=G.layers.mask&-3;let Ct=tt.parent,Mt=G.cameras;J(G,Ct);for(let Yt=0;Yt<Mt.length;Yt++)J(Mt[Yt],Ct);G.projectionMatrix.copy(U.projectionMatrix),G.projectionMatrixInverse.copy(U.projectionMatrixInverse),z===null&&tt.isPerspectiveCamera&&(z={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,G,Ct)};function Q(tt,gt,xt){xt===null?tt.matrix.copy(gt.matrixWorld):(tt.matrix.copy(xt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(gt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(gt.projectionMatrix),tt.projectionMatrixInverse.copy(gt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=xa*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(u===null&&p===null))return l},this.setFoveation=function(tt){l=tt,u!==null&&(u.fixedFoveation=tt),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=tt)},this.hasDepthSensing=function(){return d.texture!==null},this.getDepthSensingMesh=function(){return d.getMesh(G)},this.getCameraTexture=function(tt){return m[tt]};let rt=null;function dt(tt,gt){if(h=gt.getViewerPose(c||a),g=gt,h!==null){let xt=h.views;p!==null&&(t.setRenderTargetFramebuffer(w,p.framebuffer),t.setRenderTarget(w));let Ct=!1;xt.length!==G.cameras.length&&(G.cameras.length=0,Ct=!0);for(let Xt=0;Xt<xt.length;Xt++){let me=xt[Xt],fe=null;if(p!==null)fe=p.getViewport(me);else{let Je=f.getViewSubImage(u,me);fe=Je.viewport,Xt===0&&(t.setRenderTargetTextures(w,Je.colorTexture,Je.depthStencilTexture),t.setRenderTarget(w))}let ae=W[Xt];ae===void 0&&(ae=new Kn,ae.layers.enable(Xt),ae.viewport=new Ze,W[Xt]=ae),ae.matrix.fromArray(me.transform.matrix),ae.matrix.decompose(ae.position,ae.quaternion,ae.scale),ae.projectionMatrix.fromArray(me.projectionMatrix),ae.projectionMatrixInverse.copy(ae.projectionMatrix).invert(),ae.viewport.set(fe.x,fe.y,fe.width,fe.height),Xt===0&&(G.matrix.copy(ae.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ct===!0&&G.cameras.push(ae)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){f=n.getBinding();let Xt=f.getDepthInformation(xt[0]);Xt&&Xt.isValid&&Xt.texture&&d.init(Xt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&b){t.state.unbindTexture(),f=n.getBinding();for(let Xt=0;Xt<xt.length;Xt++){let me=xt[Xt].camera;if(me){let fe=m[me];fe||(fe=new Fo,m[me]=fe);let ae=f.getCameraImage(me);fe.sourceTexture=ae}}}}for(let xt=0;xt<P.length;xt++){let Ct=T[xt],Mt=P[xt];Ct!==null&&Mt!==void 0&&Mt.update(Ct,gt,c||a)}rt&&rt(tt,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),g=null}let ft=new Zg;ft.setAnimationLoop(dt),this.setAnimationLoop=function(tt){rt=tt},this.dispose=function(){}}},jw=new ke,r0=new re;r0.set(-1,0,0,0,1,0,0,0,1);function Qw(i,t){function e(d,m){d.matrixAutoUpdate===!0&&d.updateMatrix(),m.value.copy(d.matrix)}function n(d,m){m.color.getRGB(d.fogColor.value,id(i)),m.isFog?(d.fogNear.value=m.near,d.fogFar.value=m.far):m.isFogExp2&&(d.fogDensity.value=m.density)}function s(d,m,y,C,w){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(d,m):m.isMeshLambertMaterial?(r(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(d,m),f(d,m)):m.isMeshPhongMaterial?(r(d,m),h(d,m),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(d,m),u(d,m),m.isMeshPhysicalMaterial&&p(d,m,w)):m.isMeshMatcapMaterial?(r(d,m),g(d,m)):m.isMeshDepthMaterial?r(d,m):m.isMeshDistanceMaterial?(r(d,m),b(d,m)):m.isMeshNormalMaterial?r(d,m):m.isLineBasicMaterial?(a(d,m),m.isLineDashedMaterial&&o(d,m)):m.isPointsMaterial?l(d,m,y,C):m.isSpriteMaterial?c(d,m):m.isShadowMaterial?(d.color.value.copy(m.color),d.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(d,m){d.opacity.value=m.opacity,m.color&&d.diffuse.value.copy(m.color),m.emissive&&d.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(d.map.value=m.map,e(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,e(m.alphaMap,d.alphaMapTransform)),m.bumpMap&&(d.bumpMap.value=m.bumpMap,e(m.bumpMap,d.bumpMapTransform),d.bumpScale.value=m.bumpScale,m.side===Qn&&(d.bumpScale.value*=-1)),m.normalMap&&(d.normalMap.value=m.normalMap,e(m.normalMap,d.normalMapTransform),d.normalScale.value.copy(m.normalScale),m.side===Qn&&d.normalScale.value.negate()),m.displacementMap&&(d.displacementMap.value=m.displacementMap,e(m.displacementMap,d.displacementMapTransform),d.displacementScale.value=m.displacementScale,d.displacementBias.value=m.displacementBias),m.emissiveMap&&(d.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,d.emissiveMapTransform)),m.specularMap&&(d.specularMap.value=m.specularMap,e(m.specularMap,d.specularMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest);let y=t.get(m),C=y.envMap,w=y.envMapRotation;C&&(d.envMap.value=C,d.envMapRotation.value.setFromMatrix4(jw.makeRotationFromEuler(w)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&d.envMapRotation.value.premultiply(r0),d.reflectivity.value=m.reflectivity,d.ior.value=m.ior,d.refractionRatio.value=m.refractionRatio),m.lightMap&&(d.lightMap.value=m.lightMap,d.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,d.lightMapTransform)),m.aoMap&&(d.aoMap.value=m.aoMap,d.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,d.aoMapTransform))}function a(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,m.map&&(d.map.value=m.map,e(m.map,d.mapTransform))}function o(d,m){d.dashSize.value=m.dashSize,d.totalSize.value=m.dashSize+m.gapSize,d.scale.value=m.scale}function l(d,m,y,C){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.size.value=m.size*y,d.scale.value=C*.5,m.map&&(d.map.value=m.map,e(m.map,d.uvTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,e(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function c(d,m){d.diffuse.value.copy(m.color),d.opacity.value=m.opacity,d.rotation.value=m.rotation,m.map&&(d.map.value=m.map,e(m.map,d.mapTransform)),m.alphaMap&&(d.alphaMap.value=m.alphaMap,e(m.alphaMap,d.alphaMapTransform)),m.alphaTest>0&&(d.alphaTest.value=m.alphaTest)}function h(d,m){d.specular.value.copy(m.specular),d.shininess.value=Math.max(m.shininess,1e-4)}function f(d,m){m.gradientMap&&(d.gradientMap.value=m.gradientMap)}function u(d,m){d.metalness.value=m.metalness,m.metalnessMap&&(d.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,d.metalnessMapTransform)),d.roughness.value=m.roughness,m.roughnessMap&&(d.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,d.roughnessMapTransform)),m.envMap&&(d.envMapIntensity.value=m.envMapIntensity)}function p(d,m,y){d.ior.value=m.ior,m.diffuseRoughness>0&&(d.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(d.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,d.diffuseRoughnessMapTransform))),m.sheen>0&&(d.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),d.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(d.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,d.sheenColorMapTransform)),m.sheenRoughnessMap&&(d.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,d.sheenRoughnessMapTransform))),m.clearcoat>0&&(d.clearcoat.value=m.clearcoat,d.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(d.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,d.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(d.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,d.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(d.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,d.clearcoatNormalMapTransform),d.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Qn&&d.clearcoatNormalScale.value.negate())),m.dispersion>0&&(d.dispersion.value=m.dispersion),m.retroreflectivity>0&&(d.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(d.iridescence.value=m.iridescence,d.iridescenceIOR.value=m.iridescenceIOR,d.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,d.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(d.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,d.iridescenceMapTransform)),m.iridescenceThicknessMap&&(d.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,d.iridescenceThicknessMapTransform))),m.transmission>0&&(d.transmission.value=m.transmission,d.transmissionSamplerMap.value=y.texture,d.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(d.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,d.transmissionMapTransform)),d.thickness.value=m.thickness,m.thicknessMap&&(d.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,d.thicknessMapTransform)),d.attenuationDistance.value=m.attenuationDistance,d.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(d.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(d.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,d.anisotropyMapTransform))),d.specularIntensity.value=m.specularIntensity,d.specularColor.value.copy(m.specularColor),m.specularColorMap&&(d.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,d.specularColorMapTransform)),m.specularIntensityMap&&(d.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,d.specularIntensityMapTransform))}function g(d,m){m.matcap&&(d.matcap.value=m.matcap)}function b(d,m){let y=t.get(m).light;d.referencePosition.value.setFromMatrixPosition(y.matrixWorld),d.nearDistance.value=y.shadow.camera.near,d.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function t1(i,t,e,n){let s={},r={};function a(y,C){let w=C.program;n.uniformBlockBinding(y,w,s[y.id])}function o(y,C){let w=s[y.id];w===void 0&&(g(y),w=l(y),s[y.id]=w,y.addEventListener("dispose",d));let P=C.program;n.updateUBOMapping(y,P);let T=t.render.frame;r[y.id]!==T&&(c(y),r[y.id]=T)}function l(y){let C=i.createBuffer(),w=y.__size,P=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,C),i.bufferData(i.UNIFORM_BUFFER,w,P),i.bindBuffer(i.UNIFORM_BUFFER,null),C}function c(y){let C=s[y.id],w=y.uniforms,P=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,C);for(let T=0,v=w.length;T<v;T++){let E=w[T];if(Array.isArray(E))for(let z=0,U=E.length;z<U;z++)h(E[z],T,z,P);else h(E,T,0,P)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,C,w,P){if(u(y,C,w,P)===!0){let T=y.__offset,v=y.value;if(Array.isArray(v)){let E=0;for(let z=0;z<v.length;z++){let U=v[z],N=b(U,!0);f(U,y.__data,E),E+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else f(v,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,y.__data)}}function f(y,C,w){typeof y=="number"||typeof y=="boolean"?C[w]=y:y.isMatrix3?(C[w]=y.elements[0],C[w+1]=y.elements[1],C[w+2]=y.elements[2],C[w+3]=0,C[w+4]=y.elements[3],C[w+5]=y.elements[4],C[w+6]=y.elements[5],C[w+7]=0,C[w+8]=y.elements[6],C[w+9]=y.elements[7],C[w+10]=y.elements[8],C[w+11]=0):ArrayBuffer.isView(y)?C.set(y.subarray(0,C.length-w),w):y.toArray(C,w)}function u(y,C,w,P){let T=y.value,v=C+"_"+w;if(Array.isArray(T)){P[v]===void 0&&(P[v]=[]);let E=P[v],z=!1;for(let U=0;U<T.length;U++)p(T[U],E,U)===!0&&(z=!0);return z}return p(T,P,v)}function p(y,C,w){if(C[w]===void 0)return typeof y=="number"||typeof y=="boolean"?C[w]=y:ArrayBuffer.isView(y)?C[w]=y.slice():C[w]=y.clone(),!0;{let P=C[w];if(typeof y=="number"||typeof y=="boolean"){if(P!==y)return C[w]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(P.equals(y)===!1)return P.copy(y),!0}}return!1}function g(y){let C=y.uniforms,w=0,P=16;for(let v=0,E=C.length;v<E;v++){let z=Array.isArray(C[v])?C[v]:[C[v]];for(let U=0,N=z.length;U<N;U++){let W=z[U],G=Array.isArray(W.value)?W.value:[W.value],D=Array.isArray(C[v])||Array.isArray(W.value),V=w;for(let H=0,ht=G.length;H<ht;H++){let J=G[H],Q=b(J,D),rt=w%P,dt=rt%Q.boundary,ft=rt+dt;w+=dt,ft!==0&&P-ft<Q.storage&&(w+=P-ft),H===0&&(V=w),w+=Q.storage}let K=W.type==="int"?Int32Array:W.type==="uint"?Uint32Array:Float32Array;W.__data=new K((w-V)/Float32Array.BYTES_PER_ELEMENT),W.__offset=V}}let T=w%P;return T>0&&(w+=P-T),y.__size=w,y.__cache={},this}function b(y,C){let w={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(w.boundary=4,w.storage=4):y.isVector2?(w.boundary=8,w.storage=8):y.isVector3||y.isColor?(w.boundary=16,w.storage=12):y.isVector4?(w.boundary=16,w.storage=16):y.isMatrix3?(w.boundary=16,w.storage=48):y.isMatrix4?(w.boundary=16,w.storage=64):y.isTexture?Kt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(w.boundary=16,w.storage=y.byteLength):Kt("WebGLRenderer: Unsupported uniform value type.",y),C===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function d(y){let C=y.target;C.removeEventListener("dispose",d),i.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function m(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:a,update:o,dispose:m}}var e1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ss=null;function n1(){return ss===null&&(ss=new js(e1,16,16,is,Vi),ss.name="DFG_LUT",ss.minFilter=jn,ss.magFilter=jn,ss.wrapS=es,ss.wrapT=es,ss.generateMipmaps=!1,ss.needsUpdate=!0),ss}var Dh=class{constructor(t={}){let{canvas:e=vg(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:u=!1,outputBufferType:p=vi}=t;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let b=p,d=new Set([Qc,jc,Jc]),m=new Set([vi,Hi,Ra,Er,Zc,Kc]),y=new Uint32Array(4),C=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},P=null,T=null,v=[],E=[],z=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ns,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,N=!1,W=null,G=null,D=null,V=null;this._outputColorSpace=di;let K=0,H=0,ht=null,J=-1,Q=null,rt=new Ze,dt=new Ze,ft=null,tt=new Se(0),gt=0,xt=e.width,Ct=e.height,Mt=1,Yt=null,le=null,Xt=new Ze(0,0,xt,Ct),me=new Ze(0,0,xt,Ct),fe=!1,ae=new br,Je=new Ec,Ge=!1,cn=!1,Oe=new ke,Cn=new X,we=new Ze,yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},tn=!1;function hn(){return ht===null?Mt:1}let O=n;function Pt(M,B){return e.getContext(M,B)}let Jt,ce,wt,ze,Vt,Zt,A,x,q,ut,ot,vt,yt,nt,st,mt,F,at,it,Et,_t,St,qt;try{let M={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:f};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",kt,!1),e.addEventListener("webglcontextrestored",ee,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),O===null){let B="webgl2";if(O=Pt(B,M),O===null)throw Pt(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}te()}catch(M){throw e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),ne("WebGLRenderer: "+M.message),M}function te(){Jt=new dM(O),Jt.init(),_t=new Zw(O,Jt),ce=new nM(O,Jt,t,_t),wt=new Yw(O,Jt),ce.reversedDepthBuffer&&u&&wt.buffers.depth.setReversed(!0),G=O.createFramebuffer(),D=O.createFramebuffer(),V=O.createFramebuffer(),ze=new gM(O),Vt=new Dw,Zt=new $w(O,Jt,wt,Vt,ce,_t,ze),A=new fM(U),x=new vy(O),St=new tM(O,x),q=new pM(O,x,ze,St),ut=new vM(O,q,x,St,ze),at=new _M(O,ce,Zt),st=new iM(Vt),ot=new Lw(U,A,Jt,ce,St,st),vt=new Qw(U,Vt),yt=new Uw,nt=new Hw(Jt),F=new QS(U,A,wt,ut,g,l),mt=new qw(U,ut,ce),qt=new t1(O,ze,ce,wt),it=new eM(O,Jt,ze),Et=new mM(O,Jt,ze),ze.programs=ot.programs,U.capabilities=ce,U.extensions=Jt,U.properties=Vt,U.renderLists=yt,U.shadowMap=mt,U.state=wt,U.info=ze}b!==vi&&(z=new yM(b,e.width,e.height,o,s,r));let ct=new gd(U,O);this.xr=ct,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let M=Jt.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=Jt.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(M){M!==void 0&&(Mt=M,this.setSize(xt,Ct,!1))},this.getSize=function(M){return M.set(xt,Ct)},this.setSize=function(M,B,j=!0){if(ct.isPresenting){Kt("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=M,Ct=B,e.width=Math.floor(M*Mt),e.height=Math.floor(B*Mt),j===!0&&(e.style.width=M+"px",e.style.height=B+"px"),z!==null&&z.setSize(e.width,e.height),this.setViewport(0,0,M,B)},this.getDrawingBufferSize=function(M){return M.set(xt*Mt,Ct*Mt).floor()},this.setDrawingBufferSize=function(M,B,j){xt=M,Ct=B,Mt=j,e.width=Math.floor(M*j),e.height=Math.floor(B*j),this.setViewport(0,0,M,B)},this.setEffects=function(M){if(b===vi){ne("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let B=0;B<M.length;B++)if(M[B].isOutputPass===!0){Kt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}z.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(rt)},this.getViewport=function(M){return M.copy(Xt)},this.setViewport=function(M,B,j,Y){M.isVector4?Xt.set(M.x,M.y,M.z,M.w):Xt.set(M,B,j,Y),wt.viewport(rt.copy(Xt).multiplyScalar(hn()).round())},this.getScissor=function(M){return M.copy(me)},this.setScissor=function(M,B,j,Y){M.isVector4?me.set(M.x,M.y,M.z,M.w):me.set(M,B,j,Y),wt.scissor(dt.copy(me).multiplyScalar(hn()).round())},this.getScissorTest=function(){return fe},this.setScissorTest=function(M){wt.setScissorTest(fe=M)},this.setOpaqueSort=function(M){Yt=M},this.setTransparentSort=function(M){le=M},this.getClearColor=function(M){return M.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(M=!0,B=!0,j=!0){let Y=0;if(M){let $=!1;if(ht!==null){let Tt=ht.texture.format;$=d.has(Tt)}if($){let Tt=ht.texture.type,It=m.has(Tt),At=F.getClearColor(),Lt=F.getClearAlpha(),Ht=At.r,se=At.g,ge=At.b;It?(y[0]=Ht,y[1]=se,y[2]=ge,y[3]=Lt,O.clearBufferuiv(O.COLOR,0,y)):(C[0]=Ht,C[1]=se,C[2]=ge,C[3]=Lt,O.clearBufferiv(O.COLOR,0,C))}else Y|=O.COLOR_BUFFER_BIT}B&&(Y|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&O.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),W=M},this.dispose=function(){e.removeEventListener("webglcontextlost",kt,!1),e.removeEventListener("webglcontextrestored",ee,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),F.dispose(),yt.dispose(),nt.dispose(),Zt.dispose(),Vt.dispose(),A.dispose(),ut.dispose(),q.dispose(),St.dispose(),qt.dispose(),ot.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",Nl),ct.removeEventListener("sessionend",qi),us.stop()};function kt(M){M.preventDefault(),jf("WebGLRenderer: Context Lost."),N=!0}function ee(){jf("WebGLRenderer: Context Restored."),N=!1;let M=ze.autoReset,B=mt.enabled,j=mt.autoUpdate,Y=mt.needsUpdate,$=mt.type;te(),ze.autoReset=M,mt.enabled=B,mt.autoUpdate=j,mt.needsUpdate=Y,mt.type=$}function Rt(M){ne("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function ue(M){let B=M.target;B.removeEventListener("dispose",ue),We(B)}function We(M){Wn(M),Vt.remove(M)}function Wn(M){let B=Vt.get(M).programs;B!==void 0&&(B.forEach(function(j){ot.releaseProgram(j)}),M.isShaderMaterial&&ot.releaseShaderCache(M))}this.renderBufferDirect=function(M,B,j,Y,$,Tt){B===null&&(B=yn);let It=$.isMesh&&$.matrixWorld.determinantAffine()<0,At=fo(M,B,j,Y,$);wt.setMaterial(Y,It);let Lt=j.index,Ht=1;if(Y.wireframe===!0){if(Lt=q.getWireframeAttribute(j),Lt===void 0)return;Ht=2}let se=j.drawRange,ge=j.attributes.position,zt=se.start*Ht,_e=(se.start+se.count)*Ht;Tt!==null&&(zt=Math.max(zt,Tt.start*Ht),_e=Math.min(_e,(Tt.start+Tt.count)*Ht)),Lt!==null?(zt=Math.max(zt,0),_e=Math.min(_e,Lt.count)):ge!=null&&(zt=Math.max(zt,0),_e=Math.min(_e,ge.count));let Qe=_e-zt;if(Qe<0||Qe===1/0)return;St.setup($,Y,At,j,Lt);let Ne,Ue=it;if(Lt!==null&&(Ne=x.get(Lt),Ue=Et,Ue.setIndex(Ne)),$.isMesh)Y.wireframe===!0?(wt.setLineWidth(Y.wireframeLinewidth*hn()),Ue.setMode(O.LINES)):Ue.setMode(O.TRIANGLES);else if($.isLine){let bn=Y.linewidth;bn===void 0&&(bn=1),wt.setLineWidth(bn*hn()),$.isLineSegments?Ue.setMode(O.LINES):$.isLineLoop?Ue.setMode(O.LINE_LOOP):Ue.setMode(O.LINE_STRIP)}else $.isPoints?Ue.setMode(O.POINTS):$.isSprite&&Ue.setMode(O.TRIANGLES);if($.isBatchedMesh)if(Jt.get("WEBGL_multi_draw"))Ue.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let bn=$._multiDrawStarts,Ot=$._multiDrawCounts,un=$._multiDrawCount,ye=Lt?x.get(Lt).bytesPerElement:1,ds=Vt.get(Y).currentProgram.getUniforms();for(let fn=0;fn<un;fn++)ds.setValue(O,"_gl_DrawID",fn),Ue.render(bn[fn]/ye,Ot[fn])}else if($.isInstancedMesh)Ue.renderInstances(zt,Qe,$.count);else if(j.isInstancedBufferGeometry){let bn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ot=Math.min(j.instanceCount,bn);Ue.renderInstances(zt,Qe,Ot)}else Ue.render(zt,Qe)};function co(M,B,j,Y){W!==null&&M.isNodeMaterial&&W.setObject(Y,M),Ge===!0&&st.setState(M,j,!1),M.transparent===!0&&M.side===Ii&&M.forceSinglePass===!1?(M.side=Qn,M.needsUpdate=!0,Yi(M,B,Y),M.side=sr,M.needsUpdate=!0,Yi(M,B,Y),M.side=Ii):Yi(M,B,Y)}this.compile=function(M,B,j=null){j===null&&(j=M),W!==null&&W.renderStart(M,B,j),T=nt.get(j),T.init(B),E.push(T),j.traverseVisible(function($){$.isLight&&$.layers.test(B.layers)&&(T.pushLight($),$.castShadow&&T.pushShadow($))}),M!==j&&M.traverseVisible(function($){$.isLight&&$.layers.test(B.layers)&&(T.pushLight($),$.castShadow&&T.pushShadow($))}),T.setupLights(),W!==null&&W.updateLights(T.state.lightsArray),cn=this.localClippingEnabled,Ge=st.init(this.clippingPlanes,cn),Ge===!0&&st.setGlobalState(this.clippingPlanes,B),W!==null&&mt.render(T.state.shadowsArray,j,B);let Y=new Set;return M.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Tt=$.material;if(Tt)if(Array.isArray(Tt))for(let It=0;It<Tt.length;It++){let At=Tt[It];co(At,j,B,$),Y.add(At)}else co(Tt,j,B,$),Y.add(Tt)}),T=E.pop(),W!==null&&W.renderEnd(),Y},this.compileAsync=function(M,B,j=null){let Y=this.compile(M,B,j);return new Promise($=>{function Tt(){if(Y.forEach(function(It){let Lt=Vt.get(It).currentProgram;(Lt===void 0||Lt.isReady())&&Y.delete(It)}),Y.size===0){$(M);return}setTimeout(Tt,10)}Jt.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Gr=null;function zu(M){Gr&&Gr(M)}function Nl(){us.stop()}function qi(){us.start()}let us=new Zg;us.setAnimationLoop(zu),typeof self<"u"&&us.setContext(self),this.setAnimationLoop=function(M){Gr=M,ct.setAnimationLoop(M),M===null?us.stop():us.start()},ct.addEventListener("sessionstart",Nl),ct.addEventListener("sessionend",qi),this.render=function(M,B){if(B!==void 0&&B.isCamera!==!0){ne("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;W!==null&&W.renderStart(M,B);let j=ct.enabled===!0&&ct.isPresenting===!0,Y=z!==null&&(ht===null||j)&&z.begin(U,ht);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(z===null||z.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(B),B=ct.getCamera()),M.isScene===!0&&M.onBeforeRender(U,M,B,ht),T=nt.get(M,E.length),T.init(B),T.state.textureUnits=Zt.getTextureUnits(),E.push(T),Oe.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Je.setFromArrayCamera(B):ae.setFromProjectionMatrix(Oe,Ri,B.reversedDepth),cn=this.localClippingEnabled,Ge=st.init(this.clippingPlanes,cn),P=yt.get(M,v.length),P.init(),v.push(P),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let It=U.xr.getDepthSensingMesh();It!==null&&fs(It,B,-1/0,U.sortObjects)}fs(M,B,0,U.sortObjects),P.finish(),W!==null&&W.updateLights(T.state.lightsArray),U.sortObjects===!0&&P.sort(Yt,le),tn=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,tn&&F.addToRenderList(P,M),this.info.autoReset===!0&&this.info.reset(),Ge===!0&&st.beginShadows();let $=T.state.shadowsArray;if(mt.render($,M,B),Ge===!0&&st.endShadows(),(Y&&z.hasRenderPass())===!1){let It=P.opaque,At=P.transmissive;if(T.setupLights(),B.isArrayCamera){let Lt=B.cameras;if(At.length>0)for(let Ht=0,se=Lt.length;Ht<se;Ht++){let ge=Lt[Ht];Ni(It,At,M,ge)}tn&&F.render(M);for(let Ht=0,se=Lt.length;Ht<se;Ht++){let ge=Lt[Ht];ho(P,M,ge,ge.viewport)}}else At.length>0&&Ni(It,At,M,B),tn&&F.render(M),ho(P,M,B)}ht!==null&&H===0&&(Zt.updateMultisampleRenderTarget(ht),Zt.updateRenderTargetMipmap(ht)),Y&&z.end(U),M.isScene===!0&&M.onAfterRender(U,M,B),St.resetDefaultState(),J=-1,Q=null,E.pop(),E.length>0?(T=E[E.length-1],Zt.setTextureUnits(T.state.textureUnits),Ge===!0&&st.setGlobalState(U.clippingPlanes,T.state.camera)):T=null,v.pop(),v.length>0?P=v[v.length-1]:P=null,W!==null&&W.renderEnd()};function fs(M,B,j,Y){if(M.visible===!1)return;if(M.layers.test(B.layers)){if(M.isGroup)j=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(B);else if(M.isLight)T.pushLight(M),M.castShadow&&T.pushShadow(M);else if(M.isSprite){let It=B.isArrayCamera?Je:ae;if(!M.frustumCulled||M.intersectsFrustum(It)){Y&&we.setFromMatrixPosition(M.matrixWorld).applyMatrix4(Oe);let At=ut.update(M),Lt=M.material;Lt.visible&&P.push(M,At,Lt,j,we.z,null,B)}}else if(M.isMesh||M.isLine||M.isPoints){let It=B.isArrayCamera?Je:ae;if(!M.frustumCulled||M.intersectsFrustum(It)){let At=ut.update(M),Lt=M.material;if(Y&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),we.copy(M.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),we.copy(At.boundingSphere.center)),we.applyMatrix4(M.matrixWorld).applyMatrix4(Oe)),Array.isArray(Lt)){let Ht=At.groups;for(let se=0,ge=Ht.length;se<ge;se++){let zt=Ht[se],_e=Lt[zt.materialIndex];_e&&_e.visible&&P.push(M,At,_e,j,we.z,zt,B)}}else Lt.visible&&P.push(M,At,Lt,j,we.z,null,B)}}}let Tt=M.children;for(let It=0,At=Tt.length;It<At;It++)fs(Tt[It],B,j,Y)}function ho(M,B,j,Y){let{opaque:$,transmissive:Tt,transparent:It}=M;T.setupLightsView(j),Ge===!0&&st.setGlobalState(U.clippingPlanes,j),Y&&wt.viewport(rt.copy(Y)),$.length>0&&en($,B,j),Tt.length>0&&en(Tt,B,j),It.length>0&&en(It,B,j),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Ni(M,B,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let zt=Jt.has("EXT_color_buffer_half_float")||Jt.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new mi(1,1,{generateMipmaps:!0,type:zt?Vi:vi,minFilter:Ts,samples:Math.max(4,ce.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:be.workingColorSpace})}let Tt=T.state.transmissionRenderTarget[Y.id],It=Y.viewport||rt;Tt.setSize(It.z*U.transmissionResolutionScale,It.w*U.transmissionResolutionScale);let At=U.getRenderTarget(),Lt=U.getActiveCubeFace(),Ht=U.getActiveMipmapLevel();U.setRenderTarget(Tt),U.getClearColor(tt),gt=U.getClearAlpha(),gt<1&&U.setClearColor(16777215,.5),U.clear(),tn&&F.render(j);let se=U.toneMapping;U.toneMapping=ns;let ge=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),Ge===!0&&st.setGlobalState(U.clippingPlanes,Y),en(M,j,Y),Zt.updateMultisampleRenderTarget(Tt),Zt.updateRenderTargetMipmap(Tt),Jt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let _e=0,Qe=B.length;_e<Qe;_e++){let Ne=B[_e],{object:Ue,geometry:bn,material:Ot,group:un}=Ne;if(Ot.side===Ii&&Ue.layers.test(Y.layers)){let ye=Ot.side;Ot.side=Qn,Ot.needsUpdate=!0,an(Ue,j,Y,bn,Ot,un),Ot.side=ye,Ot.needsUpdate=!0,zt=!0}}zt===!0&&(Zt.updateMultisampleRenderTarget(Tt),Zt.updateRenderTargetMipmap(Tt))}U.setRenderTarget(At,Lt,Ht),U.setClearColor(tt,gt),ge!==void 0&&(Y.viewport=ge),U.toneMapping=se}function en(M,B,j){let Y=B.isScene===!0?B.overrideMaterial:null;for(let $=0,Tt=M.length;$<Tt;$++){let It=M[$],{object:At,geometry:Lt,group:Ht}=It,se=It.material;se.allowOverride===!0&&Y!==null&&(se=Y),At.layers.test(j.layers)&&an(At,B,j,Lt,se,Ht)}}function an(M,B,j,Y,$,Tt){W!==null&&$.isNodeMaterial&&W.setObject(M,$),M.onBeforeRender(U,B,j,Y,$,Tt),M.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),$.onBeforeRender(U,B,j,Y,M,Tt),$.transparent===!0&&$.side===Ii&&$.forceSinglePass===!1?($.side=Qn,$.needsUpdate=!0,U.renderBufferDirect(j,B,Y,$,M,Tt),$.side=sr,$.needsUpdate=!0,U.renderBufferDirect(j,B,Y,$,M,Tt),$.side=Ii):U.renderBufferDirect(j,B,Y,$,M,Tt),M.onAfterRender(U,B,j,Y,$,Tt)}function on(M){let B=0;for(let j of M)j.texture!==null&&B++;return B}function Yi(M,B,j){B.isScene!==!0&&(B=yn);let Y=Vt.get(M),$=T.state.lights,Tt=T.state.shadowsArray,It=$.state.version,At=ot.getParameters(M,$.state,Tt,B,j,T.state.lightProbeGridArray),Lt=ot.getProgramCacheKey(At),Ht=Y.programs;Y.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?B.environment:null,Y.fog=B.fog;let se=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;Y.envMap=A.get(M.envMap||Y.environment,se),Y.envMapRotation=Y.environment!==null&&M.envMap===null?B.environmentRotation:M.envMapRotation,Ht===void 0&&(M.addEventListener("dispose",ue),Ht=new Map,Y.programs=Ht,Y.programVariants=new Map);let ge=Ht.get(Lt);if(ge!==void 0){if(Y.currentProgram===ge&&Y.lightsStateVersion===It)return uo(M,At),ge}else At.uniforms=ot.getUniforms(M),W!==null&&M.isNodeMaterial&&W.build(M,j,At),M.onBeforeCompile(At,U),ge=ot.acquireProgram(At,Lt),Ht.set(Lt,ge),Y.uniforms=At.uniforms;let zt=Y.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(zt.clippingPlanes=st.uniform),uo(M,At),Y.needsLights=Bs(M),Y.lightsStateVersion=It,Y.needsLights&&(zt.ambientLightColor.value=$.state.ambient,zt.lightProbe.value=$.state.probe,zt.sunLights.value=$.state.sun,zt.sunLightShadows.value=$.state.sunShadow,zt.directionalLights.value=$.state.directional,zt.directionalLightShadows.value=$.state.directionalShadow,zt.spotLights.value=$.state.spot,zt.spotLightShadows.value=$.state.spotShadow,zt.rectAreaLights.value=$.state.rectArea,zt.ltc_1.value=$.state.rectAreaLTC1,zt.ltc_2.value=$.state.rectAreaLTC2,zt.pointLights.value=$.state.point,zt.pointLightShadows.value=$.state.pointShadow,zt.hemisphereLights.value=$.state.hemi,zt.sunShadowMatrix.value=$.state.sunShadowMatrix,zt.sunShadowCascade.value=$.state.sunShadowCascade,zt.directionalShadowMatrix.value=$.state.directionalShadowMatrix,zt.spotLightMatrix.value=$.state.spotLightMatrix,zt.spotLightMap.value=$.state.spotLightMap,zt.pointShadowMatrix.value=$.state.pointShadowMatrix),Y.numLightProbeGrids=on(T.state.lightProbeGridArray),Y.currentProgram=ge,Y.uniformsList=null,ge}function oi(M,B,j,Y,$){let Tt=Vt.get(M),It=Tt.currentProgram.id+","+Y+","+$,At=Tt.programVariants.get(It);return At===void 0?(At=Yi(M,B,j),Tt.programVariants.set(It,At)):(Tt.currentProgram=At,Tt.uniformsList=null,Tt.outputColorSpace=Y,Tt.toneMapping=$),At}function Os(M){if(M.uniformsList===null){let B=M.currentProgram.getUniforms();M.uniformsList=Ia.seqWithValue(B.seq,M.uniforms)}return M.uniformsList}function uo(M,B){let j=Vt.get(M);j.outputColorSpace=B.outputColorSpace,j.batching=B.batching,j.batchingColor=B.batchingColor,j.instancing=B.instancing,j.instancingColor=B.instancingColor,j.instancingMorph=B.instancingMorph,j.skinning=B.skinning,j.morphTargets=B.morphTargets,j.morphNormals=B.morphNormals,j.morphColors=B.morphColors,j.morphTargetsCount=B.morphTargetsCount,j.numClippingPlanes=B.numClippingPlanes,j.numIntersection=B.numClipIntersection,j.vertexAlphas=B.vertexAlphas,j.vertexTangents=B.vertexTangents,j.toneMapping=B.toneMapping}function fo(M,B,j,Y,$){B.isScene!==!0&&(B=yn),Zt.resetTextureUnits();let Tt=B.fog,It=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?B.environment:null,At=ht===null?U.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:be.workingColorSpace,Lt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ht=A.get(Y.envMap||It,Lt),se=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ge=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),zt=!!j.morphAttributes.position,_e=!!j.morphAttributes.normal,Qe=!!j.morphAttributes.color,Ne=ns;Y.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(Ne=U.toneMapping);let Ue=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,bn=Ue!==void 0?Ue.length:0,Ot=Vt.get(Y),un=T.state.lights;if(Ge===!0&&(cn===!0||M!==Q)){let Fe=M===Q&&Y.id===J;st.setState(Y,M,Fe)}let ye=!1,ds=!1;Y.version===Ot.__version?Ot.needsLights&&Ot.lightsStateVersion!==un.state.version||$.isBatchedMesh&&Ot.batching===!1||!$.isBatchedMesh&&Ot.batching===!0||$.isBatchedMesh&&Ot.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Ot.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Ot.instancing===!1||!$.isInstancedMesh&&Ot.instancing===!0||$.isSkinnedMesh&&Ot.skinning===!1||!$.isSkinnedMesh&&Ot.skinning===!0||$.isInstancedMesh&&Ot.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Ot.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Ot.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Ot.instancingMorph===!1&&$.morphTexture!==null||Ot.envMap!==Ht||Y.fog===!0&&Ot.fog!==Tt||Ot.numClippingPlanes!==void 0&&(Ot.numClippingPlanes!==st.numPlanes||Ot.numIntersection!==st.numIntersection)||Ot.vertexAlphas!==se||Ot.vertexTangents!==ge||Ot.morphTargets!==zt||Ot.morphNormals!==_e||Ot.morphColors!==Qe||Ot.morphTargetsCount!==bn||Ot.numLightProbeGrids!==on(T.state.lightProbeGridArray)?ye=!0:(Ot.outputColorSpace!==At||Ot.toneMapping!==Ne)&&(ds=!0):(ye=!0,Ot.__version=Y.version);let fn=Ot.currentProgram;(ye===!0||ds===!0)&&(fn=ds===!0?oi(Y,B,$,At,Ne):Yi(Y,B,$),W&&Y.isNodeMaterial&&W.onUpdateProgram(Y,fn,Ot));let qr=!1,$i=!1,ps=!1,de=fn.getUniforms(),nn=Ot.uniforms;if(wt.useProgram(fn.program)&&(qr=!0,$i=!0,ps=!0),Y.id!==J&&(J=Y.id,$i=!0),qr||Q!==M){wt.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),de.setValue(O,"projectionMatrix",M.projectionMatrix),de.setValue(O,"viewMatrix",M.matrixWorldInverse);let dn=de.map.cameraPosition;dn!==void 0&&dn.setValue(O,Cn.setFromMatrixPosition(M.matrixWorld)),ce.logarithmicDepthBuffer&&de.setValue(O,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&de.setValue(O,"isOrthographic",M.isOrthographicCamera===!0),Q!==M&&(Q=M,$i=!0,ps=!0)}if(Ot.needsLights&&(un.state.sunShadowMap.length>0&&de.setValue(O,"sunShadowMap",un.state.sunShadowMap,Zt),un.state.directionalShadowMap.length>0&&de.setValue(O,"directionalShadowMap",un.state.directionalShadowMap,Zt),un.state.spotShadowMap.length>0&&de.setValue(O,"spotShadowMap",un.state.spotShadowMap,Zt),un.state.pointShadowMap.length>0&&de.setValue(O,"pointShadowMap",un.state.pointShadowMap,Zt)),$.isSkinnedMesh){de.setOptional(O,$,"bindMatrix"),de.setOptional(O,$,"bindMatrixInverse");let Fe=$.skeleton;Fe&&(Fe.boneTexture===null&&Fe.computeBoneTexture(),de.setValue(O,"boneTexture",Fe.boneTexture,Zt))}$.isBatchedMesh&&(de.setOptional(O,$,"batchingTexture"),de.setValue(O,"batchingTexture",$._matricesTexture,Zt),de.setOptional(O,$,"batchingIdTexture"),de.setValue(O,"batchingIdTexture",$._indirectTexture,Zt),de.setOptional(O,$,"batchingColorTexture"),$._colorsTexture!==null&&de.setValue(O,"batchingColorTexture",$._colorsTexture,Zt));let Xn=j.morphAttributes;if((Xn.position!==void 0||Xn.normal!==void 0||Xn.color!==void 0)&&at.update($,j,fn),($i||Ot.receiveShadow!==$.receiveShadow)&&(Ot.receiveShadow=$.receiveShadow,de.setValue(O,"receiveShadow",$.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&B.environment!==null&&(nn.envMapIntensity.value=B.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=n1()),$i){if(de.setValue(O,"toneMappingExposure",U.toneMappingExposure),Ot.needsLights&&Wr(nn,ps),Tt&&Y.fog===!0&&vt.refreshFogUniforms(nn,Tt),vt.refreshMaterialUniforms(nn,Y,Mt,Ct,T.state.transmissionRenderTarget[M.id]),Ot.needsLights&&Ot.numLightProbeGrids>0){let Fe=w,dn=0;for(let Bn of T.state.lightProbeGridArray)Bn.texture!==null&&(Fe.textures[dn]=Bn.texture,Fe.min[dn]=Bn.boundingBox.min,Fe.max[dn]=Bn.boundingBox.max,Fe.resolution[dn]=Bn.resolution,dn++);for(let Bn in Fe)Fe[Bn].length=dn;nn.probesSH.value=Fe.textures,nn.probesMin.value=Fe.min,nn.probesMax.value=Fe.max,nn.probesResolution.value=Fe.resolution}Ia.upload(O,Os(Ot),nn,Zt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(Ia.upload(O,Os(Ot),nn,Zt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&de.setValue(O,"center",$.center),de.setValue(O,"modelViewMatrix",$.modelViewMatrix),de.setValue(O,"normalMatrix",$.normalMatrix),de.setValue(O,"modelMatrix",$.matrixWorld),Y.uniformsGroups!==void 0){let Fe=Y.uniformsGroups;for(let dn=0,Bn=Fe.length;dn<Bn;dn++){let Ul=Fe[dn];qt.update(Ul,fn),qt.bind(Ul,fn)}}return fn}function Wr(M,B){M.ambientLightColor.needsUpdate=B,M.lightProbe.needsUpdate=B,M.sunLights.needsUpdate=B,M.sunLightShadows.needsUpdate=B,M.directionalLights.needsUpdate=B,M.directionalLightShadows.needsUpdate=B,M.pointLights.needsUpdate=B,M.pointLightShadows.needsUpdate=B,M.spotLights.needsUpdate=B,M.spotLightShadows.needsUpdate=B,M.rectAreaLights.needsUpdate=B,M.hemisphereLights.needsUpdate=B}function Bs(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return K},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ht},this.setRenderTargetTextures=function(M,B,j){let Y=Vt.get(M);Y.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Vt.get(M.texture).__webglTexture=B,Vt.get(M.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,B){let j=Vt.get(M);j.__webglFramebuffer=B,j.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(M,B=0,j=0){ht=M,K=B,H=j;let Y=null,$=!1,Tt=!1;if(M){let At=Vt.get(M);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(O.FRAMEBUFFER,At.__webglFramebuffer),rt.copy(M.viewport),dt.copy(M.scissor),ft=M.scissorTest,wt.viewport(rt),wt.scissor(dt),wt.setScissorTest(ft),J=-1;return}else if(At.__webglFramebuffer===void 0)Zt.setupRenderTarget(M);else if(At.__hasExternalTextures)Zt.rebindTextures(M,Vt.get(M.texture).__webglTexture,Vt.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let se=M.depthTexture;if(At.__boundDepthTexture!==se){if(se!==null&&Vt.has(se)&&(M.width!==se.image.width||M.height!==se.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Zt.setupDepthRenderbuffer(M)}}let Lt=M.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(Tt=!0);let Ht=Vt.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(Ht[B])?Y=Ht[B][j]:Y=Ht[B],$=!0):M.samples>0&&Zt.useMultisampledRTT(M)===!1?Y=Vt.get(M).__webglMultisampledFramebuffer:Array.isArray(Ht)?Y=Ht[j]:Y=Ht,rt.copy(M.viewport),dt.copy(M.scissor),ft=M.scissorTest}else rt.copy(Xt).multiplyScalar(Mt).floor(),dt.copy(me).multiplyScalar(Mt).floor(),ft=fe;if(j!==0&&(Y=G),wt.bindFramebuffer(O.FRAMEBUFFER,Y)&&wt.drawBuffers(M,Y),wt.viewport(rt),wt.scissor(dt),wt.setScissorTest(ft),$){let At=Vt.get(M.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+B,At.__webglTexture,j)}else if(Tt){let At=B;for(let Lt=0;Lt<M.textures.length;Lt++){let Ht=Vt.get(M.textures[Lt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Lt,Ht.__webglTexture,j,At)}}else if(M!==null&&j!==0){let At=Vt.get(M.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,At.__webglTexture,j)}J=-1};function Xr(M){let B=Vt.get(M);return(B.__readFormat!==M.format||B.__readType!==M.type)&&(B.__readFormat=M.format,B.__readType=M.type,B.__formatReadable=ce.textureFormatReadable(M.format),B.__typeReadable=ce.textureTypeReadable(M.type)),B}this.readRenderTargetPixels=function(M,B,j,Y,$,Tt,It,At=0){if(!(M&&M.isWebGLRenderTarget)){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Lt=Vt.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt){wt.bindFramebuffer(O.FRAMEBUFFER,Lt);try{let Ht=M.textures[At],se=Ht.format,ge=Ht.type;M.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+At);let zt=Xr(Ht);if(zt.__formatReadable===!1){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=M.width-Y&&j>=0&&j<=M.height-$&&O.readPixels(B,j,Y,$,_t.convert(se),_t.convert(ge),Tt)}finally{let Ht=ht!==null?Vt.get(ht).__webglFramebuffer:null;wt.bindFramebuffer(O.FRAMEBUFFER,Ht)}}},this.readRenderTargetPixelsAsync=async function(M,B,j,Y,$,Tt,It,At=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Lt=Vt.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt)if(B>=0&&B<=M.width-Y&&j>=0&&j<=M.height-$){wt.bindFramebuffer(O.FRAMEBUFFER,Lt);let Ht=M.textures[At],se=Ht.format,ge=Ht.type;M.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+At);let zt=Xr(Ht);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _e=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,_e),O.bufferData(O.PIXEL_PACK_BUFFER,Tt.byteLength,O.STREAM_READ),O.readPixels(B,j,Y,$,_t.convert(se),_t.convert(ge),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Qe=ht!==null?Vt.get(ht).__webglFramebuffer:null;wt.bindFramebuffer(O.FRAMEBUFFER,Qe);let Ne=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await yg(O,Ne,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,_e),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Tt),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(_e),O.deleteSync(Ne),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,B=null,j=0){let Y=Math.pow(2,-j),$=Math.floor(M.image.width*Y),Tt=Math.floor(M.image.height*Y),It=B!==null?B.x:0,At=B!==null?B.y:0;Zt.setTexture2D(M,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,It,At,$,Tt),wt.unbindTexture()},this.copyTextureToTexture=function(M,B,j=null,Y=null,$=0,Tt=0){let It,At,Lt,Ht,se,ge,zt,_e,Qe,Ne=M.isCompressedTexture?M.mipmaps[Tt]:M.image;if(j!==null)It=j.max.x-j.min.x,At=j.max.y-j.min.y,Lt=j.isBox3?j.max.z-j.min.z:1,Ht=j.min.x,se=j.min.y,ge=j.isBox3?j.min.z:0;else{let de=Math.pow(2,-$);It=Math.floor(Ne.width*de),At=Math.floor(Ne.height*de),M.isDataArrayTexture?Lt=Ne.depth:M.isData3DTexture?Lt=Math.floor(Ne.depth*de):Lt=1,Ht=0,se=0,ge=0}Y!==null?(zt=Y.x,_e=Y.y,Qe=Y.z):(zt=0,_e=0,Qe=0);let Ue=_t.convert(B.format),bn=_t.convert(B.type),Ot;B.isData3DTexture?(Zt.setTexture3D(B,0),Ot=O.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Zt.setTexture2DArray(B,0),Ot=O.TEXTURE_2D_ARRAY):(Zt.setTexture2D(B,0),Ot=O.TEXTURE_2D),wt.activeTexture(O.TEXTURE0),wt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,B.flipY),wt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),wt.pixelStorei(O.UNPACK_ALIGNMENT,B.unpackAlignment);let un=wt.getParameter(O.UNPACK_ROW_LENGTH),ye=wt.getParameter(O.UNPACK_IMAGE_HEIGHT),ds=wt.getParameter(O.UNPACK_SKIP_PIXELS),fn=wt.getParameter(O.UNPACK_SKIP_ROWS),qr=wt.getParameter(O.UNPACK_SKIP_IMAGES);wt.pixelStorei(O.UNPACK_ROW_LENGTH,Ne.width),wt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Ne.height),wt.pixelStorei(O.UNPACK_SKIP_PIXELS,Ht),wt.pixelStorei(O.UNPACK_SKIP_ROWS,se),wt.pixelStorei(O.UNPACK_SKIP_IMAGES,ge);let $i=M.isDataArrayTexture||M.isData3DTexture,ps=B.isDataArrayTexture||B.isData3DTexture;if(M.isDepthTexture){let de=Vt.get(M),nn=Vt.get(B),Xn=Vt.get(de.__renderTarget),Fe=Vt.get(nn.__renderTarget);wt.bindFramebuffer(O.READ_FRAMEBUFFER,Xn.__webglFramebuffer),wt.bindFramebuffer(O.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let dn=0;dn<Lt;dn++)$i&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Vt.get(M).__webglTexture,$,ge+dn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Vt.get(B).__webglTexture,Tt,Qe+dn)),O.blitFramebuffer(Ht,se,Ht+It,se+At,zt,_e,zt+It,_e+At,O.DEPTH_BUFFER_BIT,O.NEAREST);wt.bindFramebuffer(O.READ_FRAMEBUFFER,null),wt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if($!==0||M.isRenderTargetTexture||Vt.has(M)){let de=Vt.get(M),nn=Vt.get(B);wt.bindFramebuffer(O.READ_FRAMEBUFFER,D),wt.bindFramebuffer(O.DRAW_FRAMEBUFFER,V);for(let Xn=0;Xn<Lt;Xn++)$i?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,de.__webglTexture,$,ge+Xn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,de.__webglTexture,$),ps?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,nn.__webglTexture,Tt,Qe+Xn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,nn.__webglTexture,Tt),$!==0?O.blitFramebuffer(Ht,se,Ht+It,se+At,zt,_e,zt+It,_e+At,O.COLOR_BUFFER_BIT,O.NEAREST):ps?O.copyTexSubImage3D(Ot,Tt,zt,_e,Qe+Xn,Ht,se,It,At):O.copyTexSubImage2D(Ot,Tt,zt,_e,Ht,se,It,At);wt.bindFramebuffer(O.READ_FRAMEBUFFER,null),wt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else ps?M.isDataTexture||M.isData3DTexture?O.texSubImage3D(Ot,Tt,zt,_e,Qe,It,At,Lt,Ue,bn,Ne.data):B.isCompressedArrayTexture?O.compressedTexSubImage3D(Ot,Tt,zt,_e,Qe,It,At,Lt,Ue,Ne.data):O.texSubImage3D(Ot,Tt,zt,_e,Qe,It,At,Lt,Ue,bn,Ne):M.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Tt,zt,_e,It,At,Ue,bn,Ne.data):M.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Tt,zt,_e,Ne.width,Ne.height,Ue,Ne.data):O.texSubImage2D(O.TEXTURE_2D,Tt,zt,_e,It,At,Ue,bn,Ne);wt.pixelStorei(O.UNPACK_ROW_LENGTH,un),wt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,ye),wt.pixelStorei(O.UNPACK_SKIP_PIXELS,ds),wt.pixelStorei(O.UNPACK_SKIP_ROWS,fn),wt.pixelStorei(O.UNPACK_SKIP_IMAGES,qr),Tt===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&O.generateMipmap(Ot),wt.unbindTexture()},this.initRenderTarget=function(M){Vt.get(M).__webglFramebuffer===void 0&&Zt.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?Zt.setTextureCube(M,0):M.isData3DTexture?Zt.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?Zt.setTexture2DArray(M,0):Zt.setTexture2D(M,0),wt.unbindTexture()},this.resetState=function(){K=0,H=0,ht=null,wt.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ri}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=be._getDrawingBufferColorSpace(t),e.unpackColorSpace=be._getUnpackColorSpace()}};var Fh=64,a0=[["x","#d03a2b",new X(1,0,0)],["y","#2c8a3d",new X(0,1,0)],["z","#2f6fd0",new X(0,0,1)]],_d="http://www.w3.org/2000/svg",Oh=class{element=document.createElementNS(_d,"svg");#t=[];constructor(){this.element.setAttribute("viewBox",`${-Fh/2} ${-Fh/2} ${Fh} ${Fh}`),this.element.setAttribute("class","axes"),this.element.setAttribute("aria-hidden","true");for(let[t,e]of a0){let n=document.createElementNS(_d,"line");n.setAttribute("stroke",e),n.setAttribute("stroke-width","2");let s=document.createElementNS(_d,"text");s.setAttribute("fill",e),s.textContent=t,this.#t.push([n,s]),this.element.append(n,s)}}follow(t){let e=t.quaternion.clone().invert();a0.forEach(([,,n],s)=>{let{x:r,y:a}=n.clone().applyQuaternion(e),[o,l]=this.#t[s];o.setAttribute("x2",(20*r).toFixed(2)),o.setAttribute("y2",(-20*a).toFixed(2)),l.setAttribute("x",(26*r).toFixed(2)),l.setAttribute("y",(-26*a).toFixed(2))})}};var o0={type:"change"},xd={type:"start"},c0={type:"end"},Bh=new Js,l0=new Zn,i1=Math.cos(70*nd.DEG2RAD),En=new X,ai=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},vd=1e-6,kh=class extends Vo{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new X,this.cursor=new X,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:nr.ROTATE,MIDDLE:nr.DOLLY,RIGHT:nr.PAN},this.touches={ONE:ir.ROTATE,TWO:ir.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new X,this._lastQuaternion=new pi,this._lastTargetPosition=new X,this._quat=new pi().setFromUnitVectors(t.up,new X(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ea,this._sphericalDelta=new Ea,this._scale=1,this._panOffset=new X,this._rotateStart=new ie,this._rotateEnd=new ie,this._rotateDelta=new ie,this._panStart=new ie,this._panEnd=new ie,this._panDelta=new ie,this._dollyStart=new ie,this._dollyEnd=new ie,this._dollyDelta=new ie,this._dollyDirection=new X,this._mouse=new ie,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=r1.bind(this),this._onPointerDown=s1.bind(this),this._onPointerUp=a1.bind(this),this._onContextMenu=d1.bind(this),this._onMouseWheel=c1.bind(this),this._onKeyDown=h1.bind(this),this._onTouchStart=u1.bind(this),this._onTouchMove=f1.bind(this),this._onMouseDown=o1.bind(this),this._onMouseMove=l1.bind(this),this._interceptControlDown=p1.bind(this),this._interceptControlUp=m1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(o0),this.update(),this.state=Re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;En.copy(e).sub(this.target),En.applyQuaternion(this._quat),this._spherical.setFromVector3(En),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=ai:n>Math.PI&&(n-=ai),s<-Math.PI?s+=ai:s>Math.PI&&(s-=ai),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(En.setFromSpherical(this._spherical),En.applyQuaternion(this._quatInverse),e.copy(this.target).add(En),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){let o=En.length();a=this._clampDistance(o*this._scale);let l=o-a;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let o=new X(this._mouse.x,this._mouse.y,0);o.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new X(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(o),this.object.updateMatrixWorld(),a=En.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(Bh.origin.copy(this.object.position),Bh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Bh.direction))<i1?this.object.lookAt(this.target):(l0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Bh.intersectPlane(l0,this.target))))}else if(this.object.isOrthographicCamera){let a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>vd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>vd||this._lastTargetPosition.distanceToSquared(this.target)>vd?(this.dispatchEvent(o0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ai/60*this.autoRotateSpeed*t:ai/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){En.setFromMatrixColumn(e,0),En.multiplyScalar(-t),this._panOffset.add(En)}_panUp(t,e){this.screenSpacePanning===!0?En.setFromMatrixColumn(e,1):(En.setFromMatrixColumn(e,0),En.crossVectors(this.object.up,En)),En.multiplyScalar(t),this._panOffset.add(En)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;En.copy(s).sub(this.target);let r=En.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,a=n.width,o=n.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/e.clientHeight),this._rotateUp(ai*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/e.clientHeight),this._rotateUp(ai*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let a=(t.pageX+e.x)*.5,o=(t.pageY+e.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new ie,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function s1(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function r1(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function a1(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(c0),this.state=Re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function o1(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case nr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Re.DOLLY;break;case nr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}break;case nr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(xd)}function l1(i){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function c1(i){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(i.preventDefault(),this.dispatchEvent(xd),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(c0))}function h1(i){this.enabled!==!1&&this._handleKeyDown(i)}function u1(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case ir.ROTATE:if(this.enableRotate===!1){this.state=Re.NONE;break}this._handleTouchStartRotate(i),this.state=Re.TOUCH_ROTATE;break;case ir.PAN:if(this.enablePan===!1){this.state=Re.NONE;break}this._handleTouchStartPan(i),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case ir.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Re.TOUCH_DOLLY_PAN;break;case ir.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(xd)}function f1(i){switch(this._trackPointer(i),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Re.NONE}}function d1(i){this.enabled!==!1&&i.preventDefault()}function p1(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function m1(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var g1={oblique:[.55,-1,.42],front:[0,-1,0],side:[1,0,0],top:[0,-.001,1]},h0=Math.PI/24,u0=32,Hh=[["Arrow keys","turn"],["Shift + arrow keys","move"],["+ and -","zoom"],["0","whole packing"],["1, 2, 3, 4","oblique, front, side, top view"]],zh=class{camera=new Kn(u0,1,.01,100);controls;#t=new X(1,1,1);#e=new AbortController;#r;#n=!1;constructor(t,e){this.#r=e,this.camera.up.set(0,0,1),this.controls=new kh(this.camera,t),this.controls.zoomToCursor=!0,this.controls.addEventListener("change",e),this.controls.addEventListener("start",()=>this.#n=!0),this.controls.enableZoom=!1;let n={signal:this.#e.signal};t.addEventListener("focus",()=>this.controls.enableZoom=!0,n),t.addEventListener("blur",()=>this.controls.enableZoom=!1,n),t.addEventListener("pointerdown",()=>t.focus({preventScroll:!0}),n),t.addEventListener("keydown",s=>this.#a(s),n),this.view("oblique")}setExtent(t){this.#t.copy(t)}view(t){this.#s(new X(...g1[t]).normalize()),this.#n=!1}whole(){this.#s(this.camera.position.clone().sub(this.controls.target).normalize())}resize(t){this.camera.aspect=t,this.camera.updateProjectionMatrix(),this.#n||this.whole()}#s(t){this.controls.target.set(0,0,0),this.camera.position.copy(t),this.camera.lookAt(0,0,0),this.camera.updateMatrixWorld(),this.camera.position.multiplyScalar(this.#o()),this.controls.update(),this.#r()}#o(){let t=Math.tan(u0*Math.PI/360),e=t*this.camera.aspect,n=this.camera.quaternion.clone().invert(),s=.1;for(let[r,a,o]of _1()){let l=new X(r,a,o).multiply(this.#t).applyQuaternion(n);s=Math.max(s,l.z+Math.max(Math.abs(l.x)/e,Math.abs(l.y)/t))}return 1.04*s}#a(t){if(t.ctrlKey||t.metaKey||t.altKey)return;let e={1:"oblique",2:"front",3:"side",4:"top"},s={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[t.key];if(s&&t.shiftKey)this.#h(...s);else if(s)this.#i(...s);else if(t.key==="+"||t.key==="=")this.#l(1/1.15);else if(t.key==="-"||t.key==="_")this.#l(1.15);else if(t.key==="0"||t.key==="Home")this.whole();else if(e[t.key])this.view(e[t.key]);else return;t.preventDefault(),t.stopPropagation()}#i(t,e){let n=this.camera.position.clone().sub(this.controls.target);n.applyAxisAngle(this.camera.up,t*h0);let s=new X().crossVectors(this.camera.up,n).normalize(),r=n.angleTo(this.camera.up),a=Math.min(Math.max(r-e*h0,.01),Math.PI-.01);n.applyAxisAngle(s,a-r),this.camera.position.copy(this.controls.target).add(n),this.#c()}#h(t,e){let n=.05*this.camera.position.distanceTo(this.controls.target),s=new X(t*n,e*n,0).applyQuaternion(this.camera.quaternion);this.camera.position.add(s),this.controls.target.add(s),this.#c()}#l(t){let e=this.camera.position.clone().sub(this.controls.target).multiplyScalar(t);this.camera.position.copy(this.controls.target).add(e),this.#c()}#c(){this.#n=!0,this.controls.update(),this.#r()}dispose(){this.controls.dispose(),this.#e.abort()}};function*_1(){for(let i of[-1,1])for(let t of[-1,1])for(let e of[-1,1])yield[i,t,e]}var Da=`
uniform vec3 origin;
uniform float scale;
vec3 place(vec3 x) { return (x - origin) * scale; }
`;var Vh=`
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
`,Gh=`
ivec2 cell(int row, sampler2D table) {
    int width = textureSize(table, 0).x;
    return ivec2(row % width, row / width);
}
`,Wh=`
vec3 lit(vec3 colour, vec3 normal, vec3 toEye) {
    float facing = max(dot(normal, toEye), 0.0);
    float side = max(dot(normal, normalize(vec3(-0.5, 0.7, 0.5))), 0.0);
    float side2 = side * side;
    float side8 = side2 * side2 * side2 * side2;
    return colour * (0.34 + 0.42 * facing + 0.26 * side) + vec3(0.10 * side8 * side8 * side8);
}
`,Ar=`
uniform vec4 clip;
uniform float clipped;
bool cut(vec3 x) { return clipped > 0.5 && dot(clip.xyz, x) > clip.w; }
`,f0=`
bool sifted(float opacity) {
    if (opacity >= 1.0) return false;
    // interleaved gradient noise, J. Jimenez (2014)
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) >= opacity;
}
`,Xh=`
uniform mat4 projection;
float depthOf(vec3 x) {
    return 0.5 - 0.5 * (projection[2][2] * x.z + projection[3][2]) / x.z;
}
`;var yd=2048,Cr=class{uniform={value:null};#t;#e=new Float32Array;constructor(t){this.#t=t}begin(t){let e=Math.max(Math.ceil(t/yd),1),n=this.#t*yd*e;if(n!==this.#e.length){this.#e=new Float32Array(n),this.uniform.value?.dispose();let s=this.#t===4?ti:is;this.uniform.value=new js(this.#e,yd,e,s,xi)}return this.change()}change(){return this.uniform.value&&(this.uniform.value.needsUpdate=!0),this.#e}dispose(){this.uniform.value?.dispose()}};var v1=`
uniform sampler2D cylinders;
uniform float thick;
flat out vec4 from;
flat out vec3 to;
flat out vec3 colour;
out vec3 viewPlace;
${Da}${Gh}${Vh}
void main() {
    int row = 2 * (gl_VertexID / 4);
    vec4 first = texelFetch(cylinders, cell(row, cylinders), 0);
    vec4 second = texelFetch(cylinders, cell(row + 1, cylinders), 0);
    vec3 a = (modelViewMatrix * vec4(place(first.xyz), 1.0)).xyz;
    vec3 b = (modelViewMatrix * vec4(place(second.xyz), 1.0)).xyz;
    float radius = thick * first.w * scale;
    from = vec4(a, radius);
    to = b;
    colour = colourOf(second.w);
    vec3 middle = 0.5 * (a + b);
    float distance = length(middle);
    vec3 toEye = -middle / distance;
    float deep = 0.5 * dot(b - a, toEye);
    vec3 along = 0.5 * (b - a) - deep * toEye;
    float half_ = length(along);
    vec3 u = half_ > 1e-6 ? along / half_ : normalize(cross(toEye, abs(toEye.y) > 0.99 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 v = cross(toEye, u);
    // the end that is nearer to the eye is larger in the picture
    float wide = distance / max(distance - abs(deep) - radius, 0.1 * distance);
    int corner = gl_VertexID % 4;
    float side = corner == 0 || corner == 3 ? -1.0 : 1.0;
    float up = corner < 2 ? -1.0 : 1.0;
    viewPlace = middle + wide * (side * (half_ + 1.05 * radius) * u + up * 1.05 * radius * v);
    gl_Position = projectionMatrix * vec4(viewPlace, 1.0);
}
`,x1=`
precision highp float;
flat in vec4 from;
flat in vec3 to;
flat in vec3 colour;
in vec3 viewPlace;
out vec4 shown;
${Wh}${Ar}${Xh}
vec3 nearestOnAxis(vec3 x) {
    vec3 axis = to - from.xyz;
    return from.xyz + clamp(dot(x - from.xyz, axis) / max(dot(axis, axis), 1e-12), 0.0, 1.0) * axis;
}
/** How far along the ray from a place the cylinder begins; negative where it is missed. After I. Quilez. */
float meets(vec3 start, vec3 ray, out bool hit) {
    float radius2 = from.w * from.w;
    vec3 axis = to - from.xyz;
    vec3 away = start - from.xyz;
    float length2 = dot(axis, axis);
    float axisRay = dot(axis, ray);
    float axisAway = dot(axis, away);
    float a = length2 - axisRay * axisRay;
    float b = length2 * dot(ray, away) - axisAway * axisRay;
    float c = length2 * dot(away, away) - axisAway * axisAway - radius2 * length2;
    float h = b * b - a * c;
    float t = a > 1e-4 * length2 ? (-b - sqrt(max(h, 0.0))) / a : 0.0;
    float at = axisAway + t * axisRay;
    hit = h >= 0.0 && a > 1e-4 * length2 && at > 0.0 && at < length2;
    if (hit) return t;
    // the round end that is nearer
    vec3 end = (a > 1e-4 * length2 ? at <= 0.0 : axisRay > 0.0) ? away : start - to;
    b = dot(ray, end);
    h = b * b - dot(end, end) + radius2;
    hit = h >= 0.0;
    return -b - sqrt(max(h, 0.0));
}
void main() {
    vec3 ray = normalize(viewPlace);
    // from near the cylinder on: exact also far away
    vec3 start = dot(0.5 * (from.xyz + to), ray) * ray;
    bool hit;
    float t = meets(start, ray, hit);
    if (!hit) discard;
    vec3 x = start + t * ray;
    vec3 normal = (x - nearestOnAxis(x)) / from.w;
    vec3 seen = colour;
    if (cut(x)) {
        float steep = dot(clip.xyz, ray);
        x = (clip.w / (abs(steep) < 1e-9 ? 1e-9 : steep)) * ray;
        if (steep >= 0.0 || distance(x, nearestOnAxis(x)) > from.w) discard;
        normal = clip.xyz;
        seen *= 0.82;
    }
    shown = vec4(lit(seen, normal, -ray), 1.0);
    gl_FragDepth = depthOf(x);
}
`,qh=class{mesh;#t=new Cr(4);constructor(t){let e=new On({glslVersion:Rs,vertexShader:v1,fragmentShader:x1,uniforms:{...t,cylinders:this.#t.uniform}});this.mesh=new Hn(d0(0),e),this.mesh.frustumCulled=!1,this.mesh.visible=!1}set(t,e,n,s,r){let a=h=>h>=n&&h>0,o=e.reduce((h,f)=>h+(a(f)?1:0),0),l=this.#t.begin(2*o),c=0;for(let h=0;h<e.length;h++){let f=e[h];a(f)&&(l.set(t.subarray(6*h,6*h+3),c),l[c+3]=r*Math.sqrt(Math.min(f/s,2)),l.set(t.subarray(6*h+3,6*h+6),c+4),l[c+7]=Number.isFinite(f)?f:-1e30,c+=8)}return this.mesh.geometry.index.count<6*o&&(this.mesh.geometry.dispose(),this.mesh.geometry=d0(Math.ceil(1.2*o))),this.mesh.geometry.setDrawRange(0,6*o),o}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose(),this.#t.dispose()}};function d0(i){let t=new Uint32Array(6*i);for(let n=0;n<i;n++)t.set([4*n,4*n+1,4*n+2,4*n,4*n+2,4*n+3],6*n);let e=new Fn;return e.setIndex(new Un(t,1)),e}var p0={viridis:["#440154","#482878","#3e4989","#31688e","#26828e","#1f9e89","#35b779","#6ece58","#b5de2b","#fde725"],cividis:["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"],coolwarm:["#3b4cc0","#6788ee","#9abbff","#c9d7f0","#edd1c2","#f7a889","#e26952","#b40426"],grey:["#303030","#f0f0f0"]},$h=["#4477aa","#ee6677","#228833","#ccbb44","#66ccee","#aa3377","#bbbbbb","#ee8866","#44bb99","#99ddff"],Zh="#909090",Yh=256;function Sd(i){let t=parseInt(i.slice(1),16);return[t>>16&255,t>>8&255,t&255]}function Md(i,t){let e=p0[i],n=Math.min(Math.max(t,0),1)*(e.length-1),s=Math.min(Math.floor(n),e.length-2),r=Sd(e[s]),a=Sd(e[s+1]),o=l=>Math.round(r[l]+(a[l]-r[l])*(n-s));return[o(0),o(1),o(2)]}function m0(i){return`linear-gradient(to right, ${p0[i].join(", ")})`}function g0(i){let t=new Uint8Array(4*Yh);for(let n=0;n<Yh;n++)t.set([...i(n),255],4*n);let e=new js(t,Yh,1,ti);return e.minFilter=e.magFilter=gn,e.needsUpdate=!0,e}function _0(i){return g0(t=>Md(i,t/(Yh-1)))}function v0(){return g0(i=>Sd($h[i%$h.length]))}function x0(i){let t=$h.length;return $h[(i%t+t)%t]}var y1=2e4;function wd(i){let[t,e,n]=[1/0,-1/0,0];for(let l=0;l<i.length;l++){let c=i[l];c-c===0&&(n+=1,t=c<t?c:t,e=c>e?c:e)}let s=n<i.length;if(n===0)return{low:NaN,high:NaN,gaps:s,range:[0,1]};let[r,a]=b1(i),o=[t,e];return e-t>3*(a-r)&&a>r&&(o=[Math.max(t,r-(a-r)),Math.min(e,a+(a-r))]),o[1]>o[0]||(o=t===0?[0,1]:[t-.5*Math.abs(t),t+.5*Math.abs(t)]),{low:t,high:e,gaps:s,range:o}}function b1(i){let t=Math.ceil(i.length/y1),n=(t>1?Float32Array.from({length:Math.floor(i.length/t)},(r,a)=>i[a*t]):i).filter(Number.isFinite).sort(),s=r=>n[Math.round(r*(n.length-1))]??0;return[s(.01),s(.99)]}function y0(i,t){let e=S1(i),n=new Pi;for(let s of t)n.union(new Pi().setFromArray(s));return!e.isEmpty()&&!n.isEmpty()&&n.intersect(e.clone().expandByScalar(1.5*e.getSize(new X).length())),e.union(n)}function S1({position:i,radius:t}){let e=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0];for(let s=0;s<t.length;s++){let r=t[s];for(let a=0;a<3;a++){let o=i[3*s+a];e[a]=o-r<e[a]?o-r:e[a],n[a]=o+r>n[a]?o+r:n[a]}}return new Pi(new X(...e),new X(...n))}function b0(i){let t=Math.ceil(i.length/1e3),e=Float32Array.from({length:t>0?Math.floor(i.length/t):0},(n,s)=>i[s*t]).sort();return e[e.length>>1]??0}var Na=[1,.5,.3333333333333333,.25,.16666666666666666],Kh=class{plays=!1;isSlow;#t;#e;#r;#n=-1;#s=0;#o=0;#a=!1;#i=-1/0;#h=0;constructor(t,e,n){this.#t=t,this.#e=n,this.isSlow=e,this.#r=e&&window.devicePixelRatio<=1?2:1}get share(){return Na[Math.max(this.#n,0)]}drawn(t){clearTimeout(this.#o);let e=performance.now();t<1&&e-this.#i<2e3&&(this.#h=.5*this.#h+.5*(e-this.#i)),this.#i=e;let n=t<1?Math.max(250,3*this.#h):800;this.#o=t<this.#r?window.setTimeout(()=>this.#l(t),n):0;let s=this.#a?null:this.#t.fenceSync(this.#t.SYNC_GPU_COMMANDS_COMPLETE,0);s&&(this.#a=!0,this.#t.flush(),this.#c(s,performance.now(),t))}get rests(){return this.#o===0}stop(){clearTimeout(this.#o)}#l(t){if(this.plays||this.#a){this.#o=window.setTimeout(()=>this.#l(t),250);return}this.#o=0;let e=this.#s*this.#r**2<800;this.#e(t<1?1:e?this.#r:null)}#c(t,e,n){setTimeout(()=>{let s=this.#t.getSyncParameter(t,this.#t.SYNC_STATUS);if(s!==null&&s!==this.#t.SIGNALED){this.#c(t,e,n);return}this.#t.deleteSync(t),this.#a=!1,this.#f(n,performance.now()-e)},4)}#f(t,e){if(this.isSlow||=e>40,t===1&&(this.#s=e),this.#n<0){let a=Na.findIndex(o=>e*(o/t)**2<=60);this.#n=a<0?Na.length-1:a;return}if(t>1)return;let n=Na[this.#n],[s,r]=[Na[this.#n-1],Na[this.#n+1]];t<=n&&s&&e*(s/t)**2<60?this.#n-=1:t>=n&&t<1&&r&&e>1.3*60?this.#n+=1:n===1&&e>1.3*60&&(this.#n+=1)}};function S0(){let i=document.createElement("canvas").getContext("webgl2");if(!i)return!1;let t=i.getExtension("WEBGL_debug_renderer_info"),e=String(i.getParameter(t?t.UNMASKED_RENDERER_WEBGL:i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}function M0(i,t,e,n){let[s,r,a]=i.from,[o,l,c]=i.direction,[h,f]=[0,1/0];if(n){let[g,b,d]=n.normal,m=g*o+b*l+d*c,y=n.offset-(g*s+b*r+d*a);if(m<0)h=Math.max(h,y/m);else if(m>0)f=y/m;else if(y<0)return-1}let u=-1,p=f;for(let g=0;g<e.length;g++){let b=t[3*g]-s,d=t[3*g+1]-r,m=t[3*g+2]-a,y=b*o+d*l+m*c,C=(b-y*o)**2+(d-y*l)**2+(m-y*c)**2,w=e[g]**2-C;if(w<0)continue;let P=Math.sqrt(w),T=Math.max(y-P,h);T<=y+P&&T<p&&(p=T,u=g)}return u}var M1=`
uniform sampler2D places;
uniform sampler2D looks;
uniform float size;
uniform vec3 mark;
flat out vec4 sphere;
flat out vec4 look;
out vec3 viewPlace;
${Da}${Gh}${Vh}
void main() {
    vec4 grain = texelFetch(places, cell(gl_VertexID / 3, places), 0);
    vec2 told = texelFetch(looks, cell(gl_VertexID / 3, looks), 0).rg;
    vec3 centre = (modelViewMatrix * vec4(place(grain.xyz), 1.0)).xyz;
    float radius = grain.w * scale * size;
    sphere = vec4(centre, radius);
    look = vec4(told.g > 0.5 ? mix(colourOf(told.r), mark, 0.85) : colourOf(told.r), told.g);
    vec3 toEye = -normalize(centre);
    float distance = length(centre);
    // in perspective the outline of a sphere is wider than its radius
    float wide = distance / sqrt(max(distance * distance - radius * radius, 1e-12));
    vec3 right = normalize(cross(abs(toEye.y) > 0.99 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), toEye));
    vec3 up = cross(toEye, right);
    // the corners of a triangle around a circle
    int corner = gl_VertexID % 3;
    vec2 at = corner == 0 ? vec2(-1.7321, -1.0) : corner == 1 ? vec2(1.7321, -1.0) : vec2(0.0, 2.0);
    viewPlace = centre + 1.01 * wide * radius * (at.x * right + at.y * up);
    gl_Position = projectionMatrix * vec4(viewPlace, 1.0);
}
`,w1=`
precision highp float;
flat in vec4 sphere;
flat in vec4 look;
in vec3 viewPlace;
uniform float opacity;
out vec4 shown;
${Wh}${Ar}${f0}${Xh}
void main() {
    vec3 ray = normalize(viewPlace);
    // from the point of the ray that is nearest to the centre: exact also far away
    float along = dot(sphere.xyz, ray);
    vec3 nearest = along * ray - sphere.xyz;
    float inside = sphere.w * sphere.w - dot(nearest, nearest);
    if (inside < 0.0 || (look.a < 0.5 && sifted(opacity))) discard;
    float reach = sqrt(inside);
    vec3 x = (along - reach) * ray;
    vec3 normal = (x - sphere.xyz) / sphere.w;
    vec3 colour = look.rgb;
    if (cut(x)) {
        // where the plane cuts the sphere its section is shown
        float steep = dot(clip.xyz, ray);
        float t = clip.w / (abs(steep) < 1e-9 ? 1e-9 : steep);
        if (steep >= 0.0 || t > along + reach || t < along - reach) discard;
        x = t * ray;
        normal = clip.xyz;
        colour *= 0.82;
    }
    shown = vec4(lit(colour, normal, -ray), 1.0);
    gl_FragDepth = depthOf(x);
}
`,Jh=class{mesh;#t=new Cr(4);#e=new Cr(2);#r=0;#n=new Un(new Uint32Array,1);#s=!1;constructor(t){let e=new On({glslVersion:Rs,vertexShader:M1,fragmentShader:w1,uniforms:{...t,places:this.#t.uniform,looks:this.#e.uniform}});this.mesh=new Hn(new Fn,e),this.mesh.frustumCulled=!1,this.set(new Float32Array,new Float32Array)}set(t,e){let n=e.length,s=this.#t.begin(n);for(let r=0;r<n;r++)s[4*r]=t[3*r],s[4*r+1]=t[3*r+1],s[4*r+2]=t[3*r+2],s[4*r+3]=e[r];this.#e.begin(n),(n!==this.#r||!this.mesh.geometry.index)&&(this.#r=n,this.mesh.geometry.dispose(),this.mesh.geometry=new Fn,this.#n=new Un(new Uint32Array(3*n),1),this.#n.setUsage(Jf),this.mesh.geometry.setIndex(this.#n),this.#s=!1)}choose(t){if(t===null&&this.#s)return;let e=this.#n.array,n=t?.length??this.#r;for(let s=0;s<n;s++){let r=3*(t?t[s]:s);e[3*s]=r,e[3*s+1]=r+1,e[3*s+2]=r+2}this.#n.clearUpdateRanges(),this.#n.addUpdateRange(0,3*n),this.#n.needsUpdate=!0,this.mesh.geometry.setDrawRange(0,3*n),this.#s=t===null}setValues(t){let e=this.#e.change();for(let n=0;n<t.length;n++){let s=t[n];e[2*n]=s-s===0?s:-1e30}}setMarked(t){let e=this.#e.change();for(let n=0;n<this.#r;n++)e[2*n+1]=t(n)?1:0}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose(),this.#t.dispose(),this.#e.dispose()}};var w0={least:64,most:640},ei=4,Ua=2,Ed=16384,el=class{found;count=0;#t;#e;#r=new Float32Array;#n=0;#s=0;#o=new Uint8Array;#a=new Float32Array;#i=0;constructor(t){this.found=new Uint32Array(t),this.#e=new Uint32Array(t),this.#t=new Td(t)}find(t){let e=this.#t;if(e.collect(t),this.count=0,!t.solid){for(let o=0;o<e.count;o++)this.found[this.count++]=e.index[o];return}let n=Math.min(Math.max(Math.ceil(2*3.5/e.usual()),w0.least),w0.most);this.#h(Math.ceil(n*t.aspect),n);let[s,r]=[.5*n,.5*this.#n],a=this.#l();for(let o=0;o<a.length;o++){let l=a[o],c=r+s*e.x[l],h=s+s*e.y[l],f=e.distance[l]-e.radius[l];this.#c(c,h,s*e.outer[l],f)||(this.found[this.count++]=e.index[l],e.inner[l]>0&&this.#d(c,h,s*e.inner[l],Math.sqrt(f*(e.distance[l]+e.radius[l]))))}}#h(t,e){if(t!==this.#n||e!==this.#s){this.#r=new Float32Array(t*e),[this.#n,this.#s]=[t,e],this.#i=Math.ceil(t/ei);let n=this.#i*Math.ceil(e/ei);this.#o=new Uint8Array(n),this.#a=new Float32Array(n)}this.#r.fill(1/0),this.#o.fill(ei*ei),this.#a.fill(0);for(let n=0;n<e&&t%ei>0;n+=ei)this.#o[n/ei*this.#i+this.#i-1]=ei*(t%ei);for(let n=0;n<t&&e%ei>0;n+=ei){let s=Math.min(t-n,ei);this.#o[(Math.ceil(e/ei)-1)*this.#i+n/ei]=s*(e%ei)}}#l(){let{distance:t,count:e}=this.#t,[n,s]=[1/0,0];for(let o=0;o<e;o++)n=Math.min(n,t[o]),s=Math.max(s,t[o]);let r=(Ed-1)/Math.max(s-n,1e-30),a=new Uint32Array(Ed+1);for(let o=0;o<e;o++)a[Math.floor((t[o]-n)*r)+1]+=1;for(let o=0;o<Ed;o++)a[o+1]+=a[o];for(let o=0;o<e;o++)this.#e[a[Math.floor((t[o]-n)*r)]++]=o;return this.#e.subarray(0,e)}#c(t,e,n,s){return this.#f(t,e,n,s)||this.#u(t,e,n,s)}#f(t,e,n,s){let r=Math.min(Math.floor(t+n),this.#n-1)>>Ua,a=Math.min(Math.floor(e+n),this.#s-1)>>Ua,o=Math.max(Math.floor(t-n),0)>>Ua;for(let l=Math.max(Math.floor(e-n),0)>>Ua;l<=a;l++)for(let c=l*this.#i+o;c<=l*this.#i+r;c++)if(this.#o[c]>0||this.#a[c]>s)return!1;return!0}#u(t,e,n,s){let r=this.#n,a=this.#r,o=Math.min(Math.floor(e+n),this.#s-1);for(let l=Math.max(Math.floor(e-n),0);l<=o;l++){let c=Math.max(Math.abs(l+.5-e)-.5,0),h=Math.sqrt(Math.max(n*n-c*c,0)),f=l*r+Math.min(Math.floor(t+h),r-1);for(let u=l*r+Math.max(Math.floor(t-h),0);u<=f;u++)if(a[u]>s)return!1}return!0}#d(t,e,n,s){let r=this.#n,a=this.#r,o=Math.min(Math.ceil(e+n),this.#s-1);for(let l=Math.max(Math.floor(e-n),0);l<=o;l++){let c=Math.abs(l+.5-e)+.5,h=n*n-c*c;if(h<=0)continue;let f=Math.sqrt(h),u=l*r,p=(l>>Ua)*this.#i,g=u+Math.min(Math.floor(t+f)-1,r-1);for(let b=u+Math.max(Math.ceil(t-f),0);b<=g;b++){let d=a[b];if(d>s&&(a[b]=s,d===1/0)){let m=p+(b-u>>Ua);this.#o[m]-=1,s>this.#a[m]&&(this.#a[m]=s)}}}}},Td=class{count=0;index;x;y;inner;outer;distance;radius;constructor(t){this.index=new Uint32Array(t);let e=()=>new Float32Array(t);[this.x,this.y,this.inner,this.outer,this.distance,this.radius]=[e(),e(),e(),e(),e(),e()]}collect({position:t,radius:e,toView:n,scale:s,tangent:r,aspect:a,near:o,clip:l}){this.count=0;let[c,h,f,u]=l??[0,0,0,1/0],p=e.length;for(let g=0;g<p;g++){let b=t[3*g],d=t[3*g+1],m=t[3*g+2],y=n[0]*b+n[4]*d+n[8]*m+n[12],C=n[1]*b+n[5]*d+n[9]*m+n[13],w=-(n[2]*b+n[6]*d+n[10]*m+n[14]),P=e[g]*s,T=l?c*y+h*C-f*w-u:-1/0;if(!(T<=P&&w+P>o&&P>0))continue;let v=Math.sqrt(y*y+C*C+w*w);if(!(v<A1))continue;let E=P/v,z=w/v,U=z*Math.sqrt(1-E*E)-Math.sqrt(Math.max(1-z*z,0))*E,N=y/(w*r),W=C/(w*r),G=E/(z*U*r),D=!(U>.01);if(!D&&(Math.abs(N)-G>a||Math.abs(W)-G>1))continue;let V=this.count++;this.index[V]=g,this.x[V]=D?0:N,this.y[V]=D?0:W,this.outer[V]=D?4*a:G*E1,this.inner[V]=D||T>-P||w-P<o?0:E/r*T1,this.distance[V]=v,this.radius[V]=D?v:P}}usual(){let[t,e]=[0,0],n=Math.max(Math.floor(this.count/1e3),1);for(let s=0;s<this.count;s+=n)t+=Math.min(this.outer[s],1),e+=1;return e>0?Math.max(t/e,1e-6):1}},E1=1+1e-5,T1=1-1e-5,A1=1e6;var C1=`
out vec3 viewPlace;
${Da}
void main() {
    viewPlace = (modelViewMatrix * vec4(place(position), 1.0)).xyz;
    gl_Position = projectionMatrix * vec4(viewPlace, 1.0);
}
`,R1=`
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
`,P1=`
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
`,I1=25,jh=class{group=new Ss;#t;#e;#r={value:.18};#n={value:.8};constructor(t){let e={...t,opacity:this.#r,edgeOpacity:this.#n},n={glslVersion:Rs,vertexShader:C1,uniforms:e,transparent:!0,depthWrite:!1};this.#t=new On({...n,fragmentShader:R1,side:Ii}),this.#e=new On({...n,fragmentShader:P1})}set(t){this.#s();for(let e of t){let n=new Fn;n.setAttribute("position",new Un(e,3));let s=new Hn(n,this.#t),r=new Do(L1(n),this.#e);for(let a of[s,r])a.frustumCulled=!1,this.group.add(a);s.renderOrder=1,r.renderOrder=2}}setOpacity(t){this.#r.value=t,this.#n.value=Math.min(1,4*t),this.#t.depthWrite=t>=1,this.group.visible=t>0}#s(){for(let t of this.group.children)t.geometry.dispose();this.group.clear()}dispose(){this.#s(),this.#t.dispose(),this.#e.dispose()}};function L1(i){i.computeBoundingSphere();let{center:t,radius:e}=i.boundingSphere,n=e>0?e:1,s=i.clone().translate(-t.x,-t.y,-t.z).scale(1/n,1/n,1/n),r=new Oo(s,I1);return s.dispose(),r.scale(n,n,n).translate(t.x,t.y,t.z)}function E0(i,t){try{return new Ad(i,t)}catch(e){let n=document.createElement("p");return n.className="no-webgl",n.setAttribute("role","alert"),n.textContent="The 3D view needs WebGL 2, which this browser does not offer or has switched off. Try a current Firefox, Chrome, Edge or Safari with hardware acceleration on; everything else on this page works without it.",i.replaceChildren(n),console.info(`no WebGL: ${e}`),null}}var Ad=class{canvas;#t;#e;#r=new Po;#n;#s;#o;#a;#i=new Oh;#h;#l={position:new Float32Array,radius:new Float32Array,id:new Uint32Array,scalars:new Map};#c=null;#f=[];#u=new el(0);#d=null;#p={scalar:"",map:"viridis",range:[0,1],beyond:[!1,!1],names:null,gaps:!1};#b={scalar:"",range:null,map:"viridis"};#g={shown:!1,threshold:0};#v=null;#m=null;#x=new Set;#_=!1;#S=0;#y;#A=1;#w;#T=new Map;#M={origin:{value:new X},scale:{value:1},projection:{value:new ke}};#E={clip:{value:new Ze},clipped:{value:0}};#C={colours:{value:null},range:{value:new ie(0,1)},categories:{value:0}};#I={colours:{value:null},range:{value:new ie(0,1)},categories:{value:0}};#R={value:1};#P={value:1};#D={colour:{value:nl("#7f8fa6")},edgeColour:{value:nl("#66748a")}};#N={value:1};constructor(t,e){this.#t=t;let n=S0();this.#w=n?2:1,this.#e=new Dh({antialias:!n,alpha:!0,powerPreference:"high-performance"}),this.#e.outputColorSpace=$s,e.background&&(this.#r.background=nl(e.background)),this.canvas=this.#e.domElement,this.canvas.tabIndex=0,this.canvas.setAttribute("role","application"),this.canvas.setAttribute("aria-label",e.label),t.replaceChildren(this.canvas,this.#i.element),this.#n=new zh(this.canvas,()=>this.render());let s={value:nl(Zh)},r={...this.#M,...this.#E,noValue:s},a={value:nl("#ff2d87")};this.#s=new Jh({...r,...this.#C,size:this.#R,opacity:this.#P,mark:a}),this.#o=new qh({...r,...this.#I,thick:this.#N}),this.#a=new jh({...this.#M,...this.#E,...this.#D}),this.#r.add(this.#s.mesh,this.#o.mesh,this.#a.group),this.#C.colours.value=this.#U("viridis"),this.#I.colours.value=this.#U("viridis"),e.onPick&&this.#X(e.onPick),this.#y=new Kh(this.#e.getContext(),n,o=>this.#V(o)),this.#h=new ResizeObserver(()=>this.#F()),this.#h.observe(t),this.#F()}setGrains(t){this.#l=t,this.#d=null,this.#s.set(t.position,t.radius),this.#x.size>0&&this.highlight([...this.#x]),this.#B(),this.render()}setContacts(t){this.#c=t,this.#k()}setWalls(t){t.length===this.#f.length&&t.every((n,s)=>n.triangles===this.#f[s])||(this.#f=t.map(n=>n.triangles),this.#d=null,this.#a.set(this.#f),this.#B(),this.render())}colourBy(t,e=null,n="viridis"){return this.#b={scalar:t,range:e,map:n},this.#H(),this.#p}get colourScale(){return this.#p}get chainScale(){return this.#v}showChains(t,e=0){return this.#g={shown:t,threshold:e},this.#k()}setWallOpacity(t){this.#a.setOpacity(t),this.render()}setGrainOpacity(t){this.#P.value=t,this.#s.mesh.visible=t>0,this.render()}setGrainSize(t){this.#R.value=t,this.render()}setClipPlane(t){this.#m=t,this.render()}highlight(t){this.#x=new Set(t);let{id:e}=this.#l;this.#s.setMarked(n=>this.#x.has(e[n])),this.render()}pick(t,e){let{clientWidth:n,clientHeight:s}=this.canvas,r=new Ho;this.#n.camera.updateMatrixWorld(),r.setFromCamera(new ie(2*t/n-1,1-2*e/s),this.#n.camera);let a=r.ray.origin.clone().divideScalar(this.#M.scale.value).add(this.#M.origin.value),{position:o,radius:l,id:c}=this.#l,h=this.#R.value===1?l:l.map(u=>u*this.#R.value),f=M0({from:a.toArray(),direction:r.ray.direction.toArray()},o,h,this.#m);return f<0||this.#P.value===0?null:c[f]}view(t){this.#n.view(t)}fit(){let t=this.bounds();if(t.isEmpty())return;let e=t.getSize(new X).multiplyScalar(.5),n=1/Math.max(e.length(),1e-30);this.#M.origin.value.copy(t.getCenter(new X)),this.#M.scale.value=n,this.#n.setExtent(e.multiplyScalar(n)),this.#_=!0,this.#n.whole()}set plays(t){this.#y.plays=t}bounds(){return this.#d??=y0(this.#l,this.#f),this.#d.clone()}async screenshot(t){let{clientWidth:e,clientHeight:n}=this.canvas,{width:s,height:r}=t??{width:e*Qh(),height:n*Qh()},a=this.#L(Math.round(s),Math.round(r));return new Promise((o,l)=>{a.toBlob(c=>c?o(c):l(new Error("the browser made no picture")),"image/png")})}picture(){let{clientWidth:t,clientHeight:e}=this.canvas;return this.#L(2*t,2*e).toDataURL("image/png")}#L(t,e){let n=Math.min(this.#w,D1/Math.max(t,e));this.#e.setPixelRatio(Math.max(n,1)),this.#e.setSize(Math.max(t,1),Math.max(e,1),!1),this.#n.camera.aspect=t/e,this.#n.camera.updateProjectionMatrix(),this.#z();let s=document.createElement("canvas");[s.width,s.height]=[t,e];let r=s.getContext("2d");return r.imageSmoothingQuality="high",r.drawImage(this.canvas,0,0,t,e),this.#F(),s}render(){this.#S||=requestAnimationFrame(()=>this.#O(this.#y.share))}dispose(){cancelAnimationFrame(this.#S),this.#y.stop(),this.#h.disconnect(),this.#n.dispose();for(let t of[this.#s,this.#o,this.#a])t.dispose();for(let t of this.#T.values())t.dispose();this.#e.dispose(),this.#t.replaceChildren()}#B(){this.#_||(this.fit(),this.#_=this.#l.radius.length>0)}#H(){let{scalar:t,range:e,map:n}=this.#b,s=this.#l.scalars.get(t),r=this.#l.categories?.get(t)??null,a=wd(s??new Float32Array),[o,l]=e??a.range;this.#p={scalar:t,map:n,range:[o,l],beyond:[a.low<o,a.high>l],names:r,gaps:a.gaps},this.#s.setValues(s??new Float32Array(this.#l.radius.length).fill(NaN)),this.#C.colours.value=this.#U(r?"categories":n),this.#C.range.value.set(o,l),this.#C.categories.value=r?1:0,this.render()}#k(){let{shown:t,threshold:e}=this.#g;this.#o.mesh.visible=t&&this.#c!==null,this.#v=null;let n=0;if(this.#o.mesh.visible){let{ends:s,normalForce:r}=this.#c,a=wd(r),o=a.range[1],l=b0(this.#l.radius);n=this.#o.set(s,r,e,o,.45*l),this.#I.range.value.set(0,o),n>0&&(this.#v={scalar:"force chains: normal force",map:"viridis",range:[0,o],beyond:[!1,a.high>o],names:null,gaps:!1})}return this.render(),n}#U(t){let e=this.#T.get(t);return e||(e=t==="categories"?v0():_0(t),this.#T.set(t,e)),e}#F(){let{clientWidth:t,clientHeight:e}=this.#t;t>0&&e>0&&(this.#A=1,this.#e.setPixelRatio(Qh()),this.#e.setSize(t,e),this.#n.resize(t/e),this.#O())}#O(t=1){cancelAnimationFrame(this.#S),this.#S=0,t!==this.#A&&(this.#A=t,this.#e.setPixelRatio(t*Qh())),this.canvas.dataset.share=String(t),this.#z(),this.#y.drawn(t),this.canvas.dataset.rests=String(this.#y.rests)}#V(t){t!==null&&this.#O(t),this.canvas.dataset.rests=String(this.#y.rests)}#z(){let t=this.#n.camera,e=t.position.length();t.near=Math.max(e-4,.002*Math.max(e,.5)),t.far=e+8,t.updateProjectionMatrix(),t.updateMatrixWorld(),this.#M.projection.value.copy(t.projectionMatrix),this.#W(t.matrixWorldInverse),this.#G(t),this.#i.follow(t),this.#e.render(this.#r,t)}#G(t){let{position:e,radius:n}=this.#l;if(!this.#y.isSlow||!this.#s.mesh.visible){this.#s.choose(null);return}n.length>this.#u.found.length&&(this.#u=new el(n.length));let{origin:s,scale:r}=this.#M,a=r.value,o=t.matrixWorldInverse.clone().multiply(new ke().makeScale(a,a,a));o.multiply(new ke().makeTranslation(s.value.clone().negate()));let{clip:l,clipped:c}=this.#E;this.#u.find({position:e,radius:n,toView:o.elements,scale:a*this.#R.value,tangent:Math.tan(t.fov*Math.PI/360),aspect:t.aspect,near:t.near,clip:c.value>0?l.value.toArray():null,solid:this.#P.value>=1}),this.#s.choose(this.#u.found.subarray(0,this.#u.count))}#W(t){if(this.#E.clipped.value=this.#m?1:0,this.#m){let e=new X(...this.#m.normal),n=e.length()||1,s=(this.#m.offset-e.dot(this.#M.origin.value))/n*this.#M.scale.value,r=new Zn(e.divideScalar(n),-s).applyMatrix4(t);this.#E.clip.value.set(r.normal.x,r.normal.y,r.normal.z,-r.constant)}}#X(t){let e=null;this.canvas.addEventListener("pointerdown",n=>e=[n.offsetX,n.offsetY]),this.canvas.addEventListener("pointerup",n=>{e&&Math.hypot(n.offsetX-e[0],n.offsetY-e[1])<4&&t(this.pick(n.offsetX,n.offsetY)),e=null})}},D1=4096;function Qh(){return Math.min(window.devicePixelRatio,2)}function nl(i){return new Se().setStyle(i,$s)}var Cd=[["G",1e9],["M",1e6],["k",1e3],["",1],["m",.001],["\xB5",1e-6],["n",1e-9],["p",1e-12]],N1=new Set(["m","s","N","J","Pa","W","m/s","N m","Hz"]);function ni(i,t=5){if(!Number.isFinite(i))return Number.isNaN(i)?"\u2013":i>0?"\u221E":"\u2212\u221E";let e=Math.abs(i);return(e===0||e>=.001&&e<1e5?String(Number(i.toPrecision(t))):i.toExponential(t-1).replace(/\.?0+e/,"e")).replaceAll("-","\u2212").replace("e+","e")}function il(i,t){if(!N1.has(t)||!(i>0)||!Number.isFinite(i))return{unit:t,factor:1};let[e,n]=Cd.find(([,s])=>i*1.00005>=s)??Cd[Cd.length-1];return{unit:e+t,factor:n}}function _n(i,t){let{unit:e,factor:n}=il(Math.abs(i),t);return e===""?ni(i,4):`${ni(i/n,4)} ${e}`}function Gn(i,t){return t===""?i:`${i} [${t}]`}var Rd=20;function Pd({scale:i,unit:t}){let[e,n]=i.range,[s,r]=i.beyond,{unit:a,factor:o}=il(Math.max(Math.abs(e),Math.abs(n)),t);return{title:Gn(i.scalar,a),low:`${s?"\u2264 ":""}${ni(e/o,3)}`,high:`${r?"\u2265 ":""}${ni(n/o,3)}`}}function Id({scale:i,unit:t},e){let n=et("div",{class:"colour-key"});if(i.names){let l=new Set(e??[]),c=i.names.map((h,f)=>[h,f]).filter(([,h])=>l.has(h));n.append(et("span",{class:"key-title"},i.scalar));for(let[h,f]of c.slice(0,Rd)){let u=et("span",{class:"key-swatch"});u.style.background=x0(f),n.append(et("span",{class:"key-name"},u,h))}return c.length>Rd&&n.append(`and ${c.length-Rd} more`),n}let{title:s,low:r,high:a}=Pd({scale:i,unit:t}),o=et("span",{class:"key-bar"});if(o.style.background=m0(i.map),n.append(et("span",{class:"key-title"},s),et("span",{class:"key-end"},r),o,et("span",{class:"key-end"},a)),i.gaps){let l=et("span",{class:"key-swatch"});l.style.background=Zh,n.append(et("span",{class:"key-name"},l,"no value"))}return n}var U1={x:[1,0,0],y:[0,1,0],z:[0,0,1]},F1=[["viridis","Viridis"],["cividis","Cividis"],["coolwarm","Cool to warm"],["grey","Grey"]],O1=[["oblique","Oblique"],["front","Front"],["side","Side"],["top","Top"]],T0=.12,B1="periodic box",A0="Click a grain, or type its id, to see its values.",Ld=30,k1=0,Dd=i=>`${Math.round(100*i)} %`,tu=class{scene;element=et("div",{class:"scene-panel"});view=et("div",{class:"scene-view"});controls=et("div",{class:"scene-controls"});#t;#e=et("div",{class:"key-holder"});#r=et("div",{class:"key-holder",hidden:!0});#n=et("div",{class:"picked",role:"status"});#s=et("p",{class:"hint"});#o=et("p",{class:"unseen",id:`scene-in-words-${++k1}`});#a={grains:{position:new Float32Array,radius:new Float32Array,id:new Uint32Array,scalars:new Map},contacts:null,walls:[],scalars:[]};#i={scalar:"",map:"viridis",range:null};#h=!1;#l={shown:!1,threshold:1};#c={axis:"",normal:[1,-1,1],share:.5,flipped:!1};#f;#u;#d;#p;constructor(t,e){this.#t=e;let n=et("div",{class:"scene-frame"});this.view.append(n,this.#o,this.#e,this.#r),this.element.append(this.view),t.replaceChildren(this.element),this.scene=E0(n,{label:this.#b(),onPick:s=>this.pick(s)}),this.scene&&(this.element.append(this.controls),this.controls.append(this.#v(),this.#A(),this.#w(),this.#M(),this.#D(this.scene)),this.scene.canvas.setAttribute("aria-describedby",this.#o.id),(e.describes??!0)&&(this.view.append(this.#y(),this.#n),this.#n.textContent=A0),H1(n,this.scene))}#b(){let t=Hh.map(([e,n])=>`${e}: ${n}`).join("; ");return`${this.#t.label}, a 3D view. ${t}.`}show(t){if(!this.scene)return;this.#a=t;let e=t.scalars.map(n=>n.name);e.join()!==Array.from(this.#f.options,n=>n.value).join()&&this.#f.replaceChildren(...e.map(n=>et("option",{value:n},n))),this.#g(e),this.#f.value=this.#i.scalar,this.scene.setWalls(t.walls),this.scene.setGrains(t.grains),this.scene.setContacts(t.contacts?.chains??null),this.#_(),this.#T(),this.#E()}get scales(){let{colourScale:t,chainScale:e}=this.scene,n=this.#a.scalars.find(s=>s.name===t.scalar)?.unit??"";return[{scale:t,unit:n},...e?[{scale:e,unit:"N"}]:[]]}get showsChains(){return this.#l.shown}#g(t){let e=t.indexOf(this.#i.scalar);if(e<0||!this.#h){let n=z1(this.#a);this.#i.scalar=e>=0&&e<t.indexOf(n)?this.#i.scalar:n}}colourBy(t){this.#h=!0,this.#i={...this.#i,scalar:t,range:null},this.#f.value=t,this.#_()}pick(t){this.scene?.highlight(t===null?[]:[t]),this.#n.replaceChildren(...t===null?[A0]:this.#N(t)),this.#t.onPick?.(t)}#v(){let t=Ai("Colour grains by",[],o=>this.colourBy(o));this.#f=t.select;let e=Ai("Colours",F1,o=>{this.#i.map=o,this.#_()}),n=o=>{let l=et("input",{type:"number",step:"any","aria-label":o});return l.addEventListener("change",()=>this.#m()),l};this.#u=[n("From"),n("To")];let s=Sn("Automatic",()=>{this.#i.range=null,this.#_()}),r=Sn("Hold",()=>{this.#i.range=[...this.scene.colourScale.range],this.#_()},{title:"Keep this range in other frames"}),a=et("div",{class:"range-row"},this.#u[0],et("span",{},"to"),this.#u[1],s,r);return Qi("Colours",t.element,e.element,a)}#m(){let[t,e]=this.#u.map(r=>r.valueAsNumber),{factor:n}=this.#x(),s=Number.isFinite(t)&&Number.isFinite(e)&&t<e;this.#u.forEach(r=>r.setAttribute("aria-invalid",String(!s))),s&&(this.#i.range=[t*n,e*n],this.#_())}#x(){let{scale:t,unit:e}=this.scales[0];return il(Math.max(...t.range.map(Math.abs)),e)}#_(){let{scalar:t,range:e,map:n}=this.#i,s=this.scene.colourBy(t,e,n);this.#e.replaceChildren(Id(this.scales[0],this.#a.grains.scalars.get(t)));let r=this.#a.scalars.find(o=>o.name===t)?.meaning;r&&this.#e.append(et("span",{class:"key-meaning"},r)),this.#S();let{factor:a}=this.#x();s.range.forEach((o,l)=>{let c=this.#u[l];c.value=String(Number((o/a).toPrecision(4))),c.disabled=s.names!==null,c.setAttribute("aria-invalid","false")})}#S(){let{grains:t,contacts:e,walls:n}=this.#a,s=(b,d)=>`${b} ${d}${b===1?"":"s"}`,r=({scale:b,unit:d})=>`${b.scalar}${b.names?"":` from ${_n(b.range[0],d)} to ${_n(b.range[1],d)}`}`,[a,o]=this.scales.map(r),l=this.scene.bounds(),[c,h]=[l.min.toArray(),l.max.toArray()],f=l.isEmpty()?"":`, in ${c.map((b,d)=>_n(h[d]-b,"m")).join(" by ")}`,u=n.length===1&&n[0].name===B1,p=n.length===0?"":u?", with the sides of the periodic box":`, with ${s(n.length,"wall")}`,g=o?`, ${o}`:"";this.#o.textContent=`${s(t.id.length,"grain")}${p}${f}, coloured by ${a}; ${s(e?.count??0,"contact")}${g}.`}#y(){let t=et("input",{type:"number",min:1,step:1,"aria-label":"Id of a grain"}),e=et("form",{class:"grain-form"},et("label",{},"Grain ",t),et("button",{type:"submit"},"Show"),Sn("None",()=>this.pick(null)));return e.addEventListener("submit",n=>{n.preventDefault(),Number.isInteger(t.valueAsNumber)&&this.pick(t.valueAsNumber)}),e}#A(){let t=this.scene;this.#d=ta("Opacity of grains",{min:0,max:1,step:.02,value:1},Dd,s=>t.setGrainOpacity(s));let e=ta("Size of grains",{min:.1,max:1,step:.05,value:1},Dd,s=>t.setGrainSize(s)),n=ta("Opacity of walls",{min:0,max:1,step:.02,value:.18},Dd,s=>t.setWallOpacity(s));return Qi("Grains and walls",this.#d.element,e.element,n.element)}#w(){let t=si("Show force chains",!1,s=>{this.#l.shown=s,s&&this.#d.input.valueAsNumber===1?this.#d.set(T0):!s&&this.#d.input.valueAsNumber===T0&&this.#d.set(1),this.#T(),s&&this.#a.contacts&&!this.#a.contacts.chains&&this.#t.needsChains?.()}),n=ta("Normal force",{min:0,max:5,step:.1,value:1},s=>s===0?"all contacts":`from ${ni(s,2)} \xD7 mean`,s=>{this.#l.threshold=s,this.#T()});return Qi("Force chains",t.element,n.element,this.#s)}#T(){let t=this.#a.contacts,e=t?.meanForce??0,n=this.scene.showChains(this.#l.shown,this.#l.threshold*e),s=t?.count??0,r=this.scales[1];this.#r.hidden=!r,this.#r.replaceChildren(...r?[Id(r)]:[]),this.#S();let a=s===0?"No contact carries a force in this state.":`Mean normal force ${_n(e,"N")}.`;this.#s.textContent=this.#l.shown&&s>0&&t?.chains?`${n} of ${s} contacts; thicker is stronger. ${a}`:a}#M(){this.#p=ta("Position",{min:0,max:1,step:.01,value:.5},r=>this.#R(r),r=>{this.#c.share=r,this.#P()});let t=[["","off"],["x","across x"],["y","across y"],["z","across z"],["any","across any direction"]],e=this.#C(()=>this.#E()),n=Ai("Cut",t,r=>{this.#c.axis=r,this.#p.input.disabled=r==="",e.hidden=r!=="any",this.#E()}),s=si("Show the other side",!1,r=>{this.#c.flipped=r,this.#P()});return this.#p.input.disabled=!0,Qi("Clip plane",n.element,e,this.#p.element,s.element)}#E(){this.#p.set(this.#c.share)}#C(t){let e=["x","y","z"].map((s,r)=>{let a=et("input",{type:"number",step:"any",value:this.#c.normal[r],"aria-label":`${s} of the normal`});return a.addEventListener("input",()=>{let o=e.map(c=>c.valueAsNumber),l=o.every(Number.isFinite)&&o.some(c=>c!==0);e.forEach(c=>c.setAttribute("aria-invalid",String(!l))),l&&(this.#c.normal=o,t())}),a}),n=et("div",{class:"range-row direction"},"normal ",...e);return n.hidden=!0,n}#I(t){let{axis:e,normal:n}=this.#c,s=e==="any"||e===""?n:U1[e],r=Math.hypot(...s),a=s.map(f=>f/r),o=this.scene.bounds();if(o.isEmpty())return{normal:a,place:0};let[l,c]=[o.min.toArray(),o.max.toArray()],h=f=>a.reduce((u,p,g)=>u+p*(p>0===f?c:l)[g],0);return{normal:a,place:h(!1)+t*(h(!0)-h(!1))}}#R(t){let{axis:e}=this.#c??{axis:""};return e===""?"":`${e==="any"?"distance from the origin":e} = ${_n(this.#I(t).place,"m")}`}#P(){let{axis:t,share:e,flipped:n}=this.#c;if(t===""){this.scene.setClipPlane(null);return}let s=(t==="y"?-1:1)*(n?-1:1),{normal:r,place:a}=this.#I(e);this.scene.setClipPlane({normal:r.map(o=>s*o),offset:s*a})}#D(t){let e=O1.map(([o,l])=>Sn(l,()=>t.view(o))),n=Sn("Save picture",()=>{t.screenshot().then(o=>ea(o,`${this.#t.fileName}.png`))}),s=Sn("Full screen",()=>{document.fullscreenElement?document.exitFullscreen():this.element.requestFullscreen()});s.hidden=!document.fullscreenEnabled;let r=et("dl",{class:"keys"},...Hh.flatMap(([o,l])=>[et("dt",{},o),et("dd",{},l)])),a=et("details",{},et("summary",{},"Mouse and keys"),et("p",{},"Drag to turn, drag with the right button to move; the wheel zooms once the view has the focus. With the focus on the view:"),r);return Qi("View",et("div",{class:"button-row"},...e),et("div",{class:"button-row"},n,s),a)}#N(t){let{grains:e,contacts:n,scalars:s}=this.#a,r=e.id.indexOf(t);if(r<0)return[et("p",{},`Grain ${t} is not there.`)];let a=et("dl",{class:"values"}),o=(f,u)=>a.append(et("div",{},et("dt",{},f),et("dd",{},u))),l=Array.from(e.position.subarray(3*r,3*r+3),f=>_n(f,"m"));o("centre",`(${l.join(", ")})`);for(let{name:f,unit:u}of s){let p=e.scalars.get(f)?.[r]??NaN,g=e.categories?.get(f);o(f,g?g[p]??String(p):_n(p,u))}let c=[et("h3",{},`Grain ${t}`),a],h=n?.partners?this.#L(t):[];if(h.length>0){let f=h.length>Ld?[et("li",{},`and ${h.length-Ld} more`)]:[];c.push(et("details",{},et("summary",{},`${h.length} contacts`),et("ul",{},...h.slice(0,Ld).map(u=>et("li",{},u)),...f)))}return c}#L(t){let{contacts:e,walls:n}=this.#a,{idI:s,idJ:r,wall:a,totalForce:o}=e.partners,{normalForce:l}=e.chains,c=[];for(let h=0;h<s.length;h++)if(s[h]===t||a[h]<0&&r[h]===t){let f=n.find(p=>p.index===a[h])?.name,u=a[h]>=0?`wall ${f??a[h]}`:`grain ${s[h]===t?r[h]:s[h]}`;c.push([o[h],`${u}: normal force ${_n(l[h],"N")}, force ${_n(o[h],"N")}`])}return c.sort((h,f)=>f[0]-h[0]).map(([,h])=>h)}};function z1(i){let t=e=>{let n=i.grains.scalars.get(e);return n!==void 0&&n.some(s=>s!==n[0])};return(i.scalars.find(e=>t(e.name))??i.scalars[0])?.name??""}function H1(i,t){let e=et("img",{class:"print-only",alt:"The 3D view as it was on the screen"});i.append(e),window.addEventListener("beforeprint",()=>e.src=t.picture())}var rr=class extends Error{};async function C0(i,t){let e;try{e=await fetch(i,t?{signal:t}:{})}catch(n){throw t?.aborted?n:new rr("The server does not answer. Is `demeter view` still running?")}if(!e.ok){let n=await e.json().catch(()=>({}));throw new rr(n.error??`The server answers ${e.status}.`)}return e}async function Ud(i){return await(await C0(i)).json()}var Fd=i=>Ud(`api/state?moments=${i}`),R0=(i,t)=>Ud(`api/grain/${i}/${t}`),P0=(i,t)=>Ud(`api/history/${i}?moments=${t.join(",")}`),I0=(i,t)=>sl(`api/series?columns=${i.join(",")}&from=${t}`),V1={f32:Float32Array,f64:Float64Array,u32:Uint32Array,i32:Int32Array},Nd=class{head;bytes;#t=new Map;constructor(t){let e=new DataView(t).getUint32(0,!0);this.head=JSON.parse(new TextDecoder().decode(new Uint8Array(t,4,e))),this.bytes=t.byteLength;let n=Math.ceil((4+e)/8)*8;for(let{name:s,type:r,place:a,length:o}of this.head.arrays)this.#t.set(s,new V1[r](t,n+a,o))}floats(t){return this.#e(t)}doubles(t){return this.#e(t)}counts(t){return this.#e(t)}integers(t){return this.#e(t)}#e(t){let e=this.#t.get(t);if(!e)throw new rr(`The server does not tell ${t}.`);return e}};async function sl(i,t){return new Nd(await(await C0(i,t)).arrayBuffer())}var yi=Uint8Array,U0=Uint16Array,G1=Int32Array,W1=new yi([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),X1=new yi([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),A3=new yi([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),F0=function(i,t){for(var e=new U0(31),n=0;n<31;++n)e[n]=t+=1<<i[n-1];for(var s=new G1(e[30]),n=1;n<30;++n)for(var r=e[n];r<e[n+1];++r)s[r]=r-e[n]<<5|n;return{b:e,r:s}},O0=F0(W1,2),q1=O0.b,Y1=O0.r;q1[28]=258,Y1[258]=28;var B0=F0(X1,0),C3=B0.b,R3=B0.r,$1=new U0(32768);for(Pe=0;Pe<32768;++Pe)Is=(Pe&43690)>>1|(Pe&21845)<<1,Is=(Is&52428)>>2|(Is&13107)<<2,Is=(Is&61680)>>4|(Is&3855)<<4,$1[Pe]=((Is&65280)>>8|(Is&255)<<8)>>1;var Is,Pe;var nu=new yi(288);for(Pe=0;Pe<144;++Pe)nu[Pe]=8;var Pe;for(Pe=144;Pe<256;++Pe)nu[Pe]=9;var Pe;for(Pe=256;Pe<280;++Pe)nu[Pe]=7;var Pe;for(Pe=280;Pe<288;++Pe)nu[Pe]=8;var Pe,Z1=new yi(32);for(Pe=0;Pe<32;++Pe)Z1[Pe]=5;var Pe;var K1=function(i,t,e){return(t==null||t<0)&&(t=0),(e==null||e>i.length)&&(e=i.length),new yi(i.subarray(t,e))};var J1=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],ar=function(i,t,e){var n=new Error(t||J1[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,ar),!e)throw n;return n};var j1=new yi(0);var Q1=(function(){for(var i=new Int32Array(256),t=0;t<256;++t){for(var e=t,n=9;--n;)e=(e&1&&-306674912)^e>>>1;i[t]=e}return i})(),tE=function(){var i=-1;return{p:function(t){for(var e=i,n=0;n<t.length;++n)e=Q1[e&255^t[n]]^e>>>8;i=e},d:function(){return~i}}};var eE=function(i,t){var e={};for(var n in i)e[n]=i[n];for(var n in t)e[n]=t[n];return e};var ln=function(i,t,e){for(;e;++t)i[t]=e,e>>>=8};var L0=typeof TextEncoder<"u"&&new TextEncoder,nE=typeof TextDecoder<"u"&&new TextDecoder,iE=0;try{nE.decode(j1,{stream:!0}),iE=1}catch{}function D0(i,t){if(t){for(var e=new yi(i.length),n=0;n<i.length;++n)e[n]=i.charCodeAt(n);return e}if(L0)return L0.encode(i);for(var s=i.length,r=new yi(i.length+(i.length>>1)),a=0,o=function(h){r[a++]=h},n=0;n<s;++n){if(a+5>r.length){var l=new yi(a+8+(s-n<<1));l.set(r),r=l}var c=i.charCodeAt(n);c<128||t?o(c):c<2048?(o(192|c>>6),o(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|i.charCodeAt(++n)&1023,o(240|c>>18),o(128|c>>12&63),o(128|c>>6&63),o(128|c&63)):(o(224|c>>12),o(128|c>>6&63),o(128|c&63))}return K1(r,0,a)}var eu=function(i){var t=0;if(i)for(var e in i){var n=i[e].length;n>65535&&ar(9),t+=n+4}return t},N0=function(i,t,e,n,s,r,a,o){var l=n.length,c=e.extra,h=o&&o.length,f=eu(c);ln(i,t,a!=null?33639248:67324752),t+=4,a!=null&&(i[t++]=20,i[t++]=e.os),i[t]=20,t+=2,i[t++]=e.flag<<1|(r<0&&8),i[t++]=s&&8,i[t++]=e.compression&255,i[t++]=e.compression>>8;var u=new Date(e.mtime==null?Date.now():e.mtime),p=u.getFullYear()-1980;if((p<0||p>119)&&ar(10),ln(i,t,p<<25|u.getMonth()+1<<21|u.getDate()<<16|u.getHours()<<11|u.getMinutes()<<5|u.getSeconds()>>1),t+=4,r!=-1&&(ln(i,t,e.crc),ln(i,t+4,r<0?-r-2:r),ln(i,t+8,e.size)),ln(i,t+12,l),ln(i,t+14,f),t+=16,a!=null&&(ln(i,t,h),ln(i,t+6,e.attrs),ln(i,t+10,a),t+=14),i.set(n,t),t+=l,f)for(var g in c){var b=c[g],d=b.length;ln(i,t,+g),ln(i,t+2,d),i.set(b,t+4),t+=4+d}return h&&(i.set(o,t),t+=h),t},sE=function(i,t,e,n,s){ln(i,t,101010256),ln(i,t+8,e),ln(i,t+10,e),ln(i,t+12,n),ln(i,t+16,s)},k0=(function(){function i(t){this.filename=t,this.c=tE(),this.size=0,this.compression=0}return i.prototype.process=function(t,e){this.ondata(null,t,e)},i.prototype.push=function(t,e){this.ondata||ar(5),this.c.p(t),this.size+=t.length,e&&(this.crc=this.c.d()),this.process(t,e||!1)},i})();var z0=(function(){function i(t){this.ondata=t,this.u=[],this.d=1}return i.prototype.add=function(t){var e=this;if(this.ondata||ar(5),this.d&2)this.ondata(ar(4+(this.d&1)*8,0,1),null,!1);else{var n=D0(t.filename),s=n.length,r=t.comment,a=r&&D0(r),o=s!=t.filename.length||a&&r.length!=a.length,l=s+eu(t.extra)+30;s>65535&&this.ondata(ar(11,0,1),null,!1);var c=new yi(l);N0(c,0,t,n,o,-1);var h=[c],f=function(){for(var d=0,m=h;d<m.length;d++){var y=m[d];e.ondata(null,y,!1)}h=[]},u=this.d;this.d=0;var p=this.u.length,g=eE(t,{f:n,u:o,o:a,t:function(){t.terminate&&t.terminate()},r:function(){if(f(),u){var d=e.u[p+1];d?d.r():e.d=1}u=1}}),b=0;t.ondata=function(d,m,y){if(d)e.ondata(d,m,y),e.terminate();else if(b+=m.length,h.push(m),y){var C=new yi(16);ln(C,0,134695760),ln(C,4,t.crc),ln(C,8,b),ln(C,12,t.size),h.push(C),g.c=b,g.b=l+b+16,g.crc=t.crc,g.size=t.size,u&&g.r(),u=1}else u&&f()},this.u.push(g)}},i.prototype.end=function(){var t=this;if(this.d&2){this.ondata(ar(4+(this.d&1)*8,0,1),null,!0);return}this.d?this.e():this.u.push({r:function(){t.d&1&&(t.u.splice(-1,1),t.e())},t:function(){}}),this.d=3},i.prototype.e=function(){for(var t=0,e=0,n=0,s=0,r=this.u;s<r.length;s++){var a=r[s];n+=46+a.f.length+eu(a.extra)+(a.o?a.o.length:0)}for(var o=new yi(n+22),l=0,c=this.u;l<c.length;l++){var a=c[l];N0(o,t,a,a.f,a.u,-a.c-2,e,a.o),t+=46+a.f.length+eu(a.extra)+(a.o?a.o.length:0),e+=a.b}sE(o,t,this.u.length,n,e),this.ondata(null,o,!0),this.d=2},i.prototype.terminate=function(){for(var t=0,e=this.u;t<e.length;t++){var n=e[t];n.t()}this.d=2},i})();var $d=(i,t,e)=>{if(!t.has(i))throw TypeError("Cannot "+e)},I=(i,t,e)=>($d(i,t,"read from private field"),e?e.call(i):t.get(i)),Nt=(i,t,e)=>{if(t.has(i))throw TypeError("Cannot add the same private member more than once");t instanceof WeakSet?t.add(i):t.set(i,e)},he=(i,t,e,n)=>($d(i,t,"write to private field"),n?n.call(i,e):t.set(i,e),e),Gt=(i,t,e)=>($d(i,t,"access private method"),e),V0=class{constructor(i){this.value=i}},Zd=class{constructor(i){this.value=i}},G0=i=>i<256?1:i<65536?2:i<1<<24?3:i<2**32?4:i<2**40?5:6,rE=i=>{if(i<127)return 1;if(i<16383)return 2;if(i<(1<<21)-1)return 3;if(i<(1<<28)-1)return 4;if(i<2**35-1)return 5;if(i<2**42-1)return 6;throw new Error("EBML VINT size not supported "+i)},Fa=(i,t,e)=>{let n=0;for(let s=t;s<e;s++){let r=Math.floor(s/8),a=i[r],o=7-(s&7),l=(a&1<<o)>>o;n<<=1,n|=l}return n},aE=(i,t,e,n)=>{for(let s=t;s<e;s++){let r=Math.floor(s/8),a=i[r],o=7-(s&7);a&=~(1<<o),a|=(n&1<<e-s-1)>>e-s-1<<o,i[r]=a}};var mu=class{},Kd=class extends mu{constructor(){super(...arguments),this.buffer=null}},W0=class extends mu{constructor(i){if(super(),this.options=i,typeof i!="object")throw new TypeError("StreamTarget requires an options object to be passed to its constructor.");if(i.onData){if(typeof i.onData!="function")throw new TypeError("options.onData, when provided, must be a function.");if(i.onData.length<2)throw new TypeError("options.onData, when provided, must be a function that takes in at least two arguments (data and position). Ignoring the position argument, which specifies the byte offset at which the data is to be written, can lead to broken outputs.")}if(i.onHeader&&typeof i.onHeader!="function")throw new TypeError("options.onHeader, when provided, must be a function.");if(i.onCluster&&typeof i.onCluster!="function")throw new TypeError("options.onCluster, when provided, must be a function.");if(i.chunked!==void 0&&typeof i.chunked!="boolean")throw new TypeError("options.chunked, when provided, must be a boolean.");if(i.chunkSize!==void 0&&(!Number.isInteger(i.chunkSize)||i.chunkSize<1024))throw new TypeError("options.chunkSize, when provided, must be an integer and not smaller than 1024.")}},oE=class extends mu{constructor(i,t){if(super(),this.stream=i,this.options=t,!(i instanceof FileSystemWritableFileStream))throw new TypeError("FileSystemWritableFileStreamTarget requires a FileSystemWritableFileStream instance.");if(t!==void 0&&typeof t!="object")throw new TypeError("FileSystemWritableFileStreamTarget's options, when provided, must be an object.");if(t&&t.chunkSize!==void 0&&(!Number.isInteger(t.chunkSize)||t.chunkSize<=0))throw new TypeError("options.chunkSize, when provided, must be a positive integer")}},cr,Te,Od,X0,Bd,q0,kd,Y0,iu,zd,Hd,$0,Z0=class{constructor(){Nt(this,Od),Nt(this,Bd),Nt(this,kd),Nt(this,iu),Nt(this,Hd),this.pos=0,Nt(this,cr,new Uint8Array(8)),Nt(this,Te,new DataView(I(this,cr).buffer)),this.offsets=new WeakMap,this.dataOffsets=new WeakMap}seek(i){this.pos=i}writeEBMLVarInt(i,t=rE(i)){let e=0;switch(t){case 1:I(this,Te).setUint8(e++,128|i);break;case 2:I(this,Te).setUint8(e++,64|i>>8),I(this,Te).setUint8(e++,i);break;case 3:I(this,Te).setUint8(e++,32|i>>16),I(this,Te).setUint8(e++,i>>8),I(this,Te).setUint8(e++,i);break;case 4:I(this,Te).setUint8(e++,16|i>>24),I(this,Te).setUint8(e++,i>>16),I(this,Te).setUint8(e++,i>>8),I(this,Te).setUint8(e++,i);break;case 5:I(this,Te).setUint8(e++,8|i/2**32&7),I(this,Te).setUint8(e++,i>>24),I(this,Te).setUint8(e++,i>>16),I(this,Te).setUint8(e++,i>>8),I(this,Te).setUint8(e++,i);break;case 6:I(this,Te).setUint8(e++,4|i/2**40&3),I(this,Te).setUint8(e++,i/2**32|0),I(this,Te).setUint8(e++,i>>24),I(this,Te).setUint8(e++,i>>16),I(this,Te).setUint8(e++,i>>8),I(this,Te).setUint8(e++,i);break;default:throw new Error("Bad EBML VINT size "+t)}this.write(I(this,cr).subarray(0,e))}writeEBML(i){if(i!==null)if(i instanceof Uint8Array)this.write(i);else if(Array.isArray(i))for(let t of i)this.writeEBML(t);else if(this.offsets.set(i,this.pos),Gt(this,iu,zd).call(this,i.id),Array.isArray(i.data)){let t=this.pos,e=i.size===-1?1:i.size??4;i.size===-1?Gt(this,Od,X0).call(this,255):this.seek(this.pos+e);let n=this.pos;if(this.dataOffsets.set(i,n),this.writeEBML(i.data),i.size!==-1){let s=this.pos-n,r=this.pos;this.seek(t),this.writeEBMLVarInt(s,e),this.seek(r)}}else if(typeof i.data=="number"){let t=i.size??G0(i.data);this.writeEBMLVarInt(t),Gt(this,iu,zd).call(this,i.data,t)}else typeof i.data=="string"?(this.writeEBMLVarInt(i.data.length),Gt(this,Hd,$0).call(this,i.data)):i.data instanceof Uint8Array?(this.writeEBMLVarInt(i.data.byteLength,i.size),this.write(i.data)):i.data instanceof V0?(this.writeEBMLVarInt(4),Gt(this,Bd,q0).call(this,i.data.value)):i.data instanceof Zd&&(this.writeEBMLVarInt(8),Gt(this,kd,Y0).call(this,i.data.value))}};cr=new WeakMap;Te=new WeakMap;Od=new WeakSet;X0=function(i){I(this,Te).setUint8(0,i),this.write(I(this,cr).subarray(0,1))};Bd=new WeakSet;q0=function(i){I(this,Te).setFloat32(0,i,!1),this.write(I(this,cr).subarray(0,4))};kd=new WeakSet;Y0=function(i){I(this,Te).setFloat64(0,i,!1),this.write(I(this,cr))};iu=new WeakSet;zd=function(i,t=G0(i)){let e=0;switch(t){case 6:I(this,Te).setUint8(e++,i/2**40|0);case 5:I(this,Te).setUint8(e++,i/2**32|0);case 4:I(this,Te).setUint8(e++,i>>24);case 3:I(this,Te).setUint8(e++,i>>16);case 2:I(this,Te).setUint8(e++,i>>8);case 1:I(this,Te).setUint8(e++,i);break;default:throw new Error("Bad UINT size "+t)}this.write(I(this,cr).subarray(0,e))};Hd=new WeakSet;$0=function(i){this.write(new Uint8Array(i.split("").map(t=>t.charCodeAt(0))))};var su,Nr,gl,ru,Vd,lE=class extends Z0{constructor(i){super(),Nt(this,ru),Nt(this,su,void 0),Nt(this,Nr,new ArrayBuffer(2**16)),Nt(this,gl,new Uint8Array(I(this,Nr))),he(this,su,i)}write(i){Gt(this,ru,Vd).call(this,this.pos+i.byteLength),I(this,gl).set(i,this.pos),this.pos+=i.byteLength}finalize(){Gt(this,ru,Vd).call(this,this.pos),I(this,su).buffer=I(this,Nr).slice(0,this.pos)}};su=new WeakMap;Nr=new WeakMap;gl=new WeakMap;ru=new WeakSet;Vd=function(i){let t=I(this,Nr).byteLength;for(;t<i;)t*=2;if(t===I(this,Nr).byteLength)return;let e=new ArrayBuffer(t),n=new Uint8Array(e);n.set(I(this,gl),0),he(this,Nr,e),he(this,gl,n)};var Oa,as,os,Rr,Sl=class extends Z0{constructor(i){super(),this.target=i,Nt(this,Oa,!1),Nt(this,as,void 0),Nt(this,os,void 0),Nt(this,Rr,void 0)}write(i){if(!I(this,Oa))return;let t=this.pos;if(t<I(this,os)){if(t+i.byteLength<=I(this,os))return;i=i.subarray(I(this,os)-t),t=0}let e=t+i.byteLength-I(this,os),n=I(this,as).byteLength;for(;n<e;)n*=2;if(n!==I(this,as).byteLength){let s=new Uint8Array(n);s.set(I(this,as),0),he(this,as,s)}I(this,as).set(i,t-I(this,os)),he(this,Rr,Math.max(I(this,Rr),t+i.byteLength))}startTrackingWrites(){he(this,Oa,!0),he(this,as,new Uint8Array(2**10)),he(this,os,this.pos),he(this,Rr,this.pos)}getTrackedWrites(){if(!I(this,Oa))throw new Error("Can't get tracked writes since nothing was tracked.");let t={data:I(this,as).subarray(0,I(this,Rr)-I(this,os)),start:I(this,os),end:I(this,Rr)};return he(this,as,void 0),he(this,Oa,!1),t}};Oa=new WeakMap;as=new WeakMap;os=new WeakMap;Rr=new WeakMap;var cE=2**24,hE=2,Pr,Ha,cl,rl,Ns,bi,cu,Gd,Jd,K0,jd,J0,hl,hu,Qd=class extends Sl{constructor(i,t){super(i),Nt(this,cu),Nt(this,Jd),Nt(this,jd),Nt(this,hl),Nt(this,Pr,[]),Nt(this,Ha,0),Nt(this,cl,void 0),Nt(this,rl,void 0),Nt(this,Ns,void 0),Nt(this,bi,[]),he(this,cl,t),he(this,rl,i.options?.chunked??!1),he(this,Ns,i.options?.chunkSize??cE)}write(i){super.write(i),I(this,Pr).push({data:i.slice(),start:this.pos}),this.pos+=i.byteLength}flush(){if(I(this,Pr).length===0)return;let i=[],t=[...I(this,Pr)].sort((e,n)=>e.start-n.start);i.push({start:t[0].start,size:t[0].data.byteLength});for(let e=1;e<t.length;e++){let n=i[i.length-1],s=t[e];s.start<=n.start+n.size?n.size=Math.max(n.size,s.start+s.data.byteLength-n.start):i.push({start:s.start,size:s.data.byteLength})}for(let e of i){e.data=new Uint8Array(e.size);for(let n of I(this,Pr))e.start<=n.start&&n.start<e.start+e.size&&e.data.set(n.data,n.start-e.start);if(I(this,rl))Gt(this,cu,Gd).call(this,e.data,e.start),Gt(this,hl,hu).call(this);else{if(I(this,cl)&&e.start<I(this,Ha))throw new Error("Internal error: Monotonicity violation.");this.target.options.onData?.(e.data,e.start),he(this,Ha,e.start+e.data.byteLength)}}I(this,Pr).length=0}finalize(){I(this,rl)&&Gt(this,hl,hu).call(this,!0)}};Pr=new WeakMap;Ha=new WeakMap;cl=new WeakMap;rl=new WeakMap;Ns=new WeakMap;bi=new WeakMap;cu=new WeakSet;Gd=function(i,t){let e=I(this,bi).findIndex(o=>o.start<=t&&t<o.start+I(this,Ns));e===-1&&(e=Gt(this,jd,J0).call(this,t));let n=I(this,bi)[e],s=t-n.start,r=i.subarray(0,Math.min(I(this,Ns)-s,i.byteLength));n.data.set(r,s);let a={start:s,end:s+r.byteLength};if(Gt(this,Jd,K0).call(this,n,a),n.written[0].start===0&&n.written[0].end===I(this,Ns)&&(n.shouldFlush=!0),I(this,bi).length>hE){for(let o=0;o<I(this,bi).length-1;o++)I(this,bi)[o].shouldFlush=!0;Gt(this,hl,hu).call(this)}r.byteLength<i.byteLength&&Gt(this,cu,Gd).call(this,i.subarray(r.byteLength),t+r.byteLength)};Jd=new WeakSet;K0=function(i,t){let e=0,n=i.written.length-1,s=-1;for(;e<=n;){let r=Math.floor(e+(n-e+1)/2);i.written[r].start<=t.start?(e=r+1,s=r):n=r-1}for(i.written.splice(s+1,0,t),(s===-1||i.written[s].end<t.start)&&s++;s<i.written.length-1&&i.written[s].end>=i.written[s+1].start;)i.written[s].end=Math.max(i.written[s].end,i.written[s+1].end),i.written.splice(s+1,1)};jd=new WeakSet;J0=function(i){let e={start:Math.floor(i/I(this,Ns))*I(this,Ns),data:new Uint8Array(I(this,Ns)),written:[],shouldFlush:!1};return I(this,bi).push(e),I(this,bi).sort((n,s)=>n.start-s.start),I(this,bi).indexOf(e)};hl=new WeakSet;hu=function(i=!1){for(let t=0;t<I(this,bi).length;t++){let e=I(this,bi)[t];if(!(!e.shouldFlush&&!i)){for(let n of e.written){if(I(this,cl)&&e.start+n.start<I(this,Ha))throw new Error("Internal error: Monotonicity violation.");this.target.options.onData?.(e.data.subarray(n.start,n.end),e.start+n.start),he(this,Ha,e.start+n.end)}I(this,bi).splice(t--,1)}}};var uE=class extends Qd{constructor(i,t){super(new W0({onData:(e,n)=>i.stream.write({type:"write",data:e,position:n}),chunked:!0,chunkSize:i.options?.chunkSize}),t)}},$a=1,_l=2,uu=3,fE=1,dE=2,pE=17,mE=2**15,ul=2**13,H0="https://github.com/Vanilagy/webm-muxer",j0=6,Q0=5,gE=["strict","offset","permissive"],Qt,Wt,vl,xl,Ds,Za,Ba,Ur,Ka,hr,Va,Ga,cs,Ml,Wa,or,lr,Ir,fl,dl,Xa,qa,fu,yl,pl,Wd,t_,Xd,e_,tp,n_,ep,i_,np,s_,ip,r_,sp,a_,gu,rp,_u,ap,op,o_,Lr,ka,Dr,za,qd,l_,Yd,c_,al,au,ol,ou,lp,h_,ls,Ls,Ya,bl,ml,du,cp,u_,pu,hp,ll,lu,f_=class{constructor(i){Nt(this,Wd),Nt(this,Xd),Nt(this,tp),Nt(this,ep),Nt(this,np),Nt(this,ip),Nt(this,sp),Nt(this,gu),Nt(this,_u),Nt(this,op),Nt(this,Lr),Nt(this,Dr),Nt(this,qd),Nt(this,Yd),Nt(this,al),Nt(this,ol),Nt(this,lp),Nt(this,ls),Nt(this,Ya),Nt(this,ml),Nt(this,cp),Nt(this,pu),Nt(this,ll),Nt(this,Qt,void 0),Nt(this,Wt,void 0),Nt(this,vl,void 0),Nt(this,xl,void 0),Nt(this,Ds,void 0),Nt(this,Za,void 0),Nt(this,Ba,void 0),Nt(this,Ur,void 0),Nt(this,Ka,void 0),Nt(this,hr,void 0),Nt(this,Va,void 0),Nt(this,Ga,void 0),Nt(this,cs,void 0),Nt(this,Ml,void 0),Nt(this,Wa,0),Nt(this,or,[]),Nt(this,lr,[]),Nt(this,Ir,[]),Nt(this,fl,void 0),Nt(this,dl,void 0),Nt(this,Xa,-1),Nt(this,qa,-1),Nt(this,fu,-1),Nt(this,yl,void 0),Nt(this,pl,!1),Gt(this,Wd,t_).call(this,i),he(this,Qt,{type:"webm",firstTimestampBehavior:"strict",...i}),this.target=i.target;let t=!!I(this,Qt).streaming;if(i.target instanceof Kd)he(this,Wt,new lE(i.target));else if(i.target instanceof W0)he(this,Wt,new Qd(i.target,t));else if(i.target instanceof oE)he(this,Wt,new uE(i.target,t));else throw new Error(`Invalid target: ${i.target}`);Gt(this,Xd,e_).call(this)}addVideoChunk(i,t,e){if(!(i instanceof EncodedVideoChunk))throw new TypeError("addVideoChunk's first argument (chunk) must be of type EncodedVideoChunk.");if(t&&typeof t!="object")throw new TypeError("addVideoChunk's second argument (meta), when provided, must be an object.");if(e!==void 0&&(!Number.isFinite(e)||e<0))throw new TypeError("addVideoChunk's third argument (timestamp), when provided, must be a non-negative real number.");let n=new Uint8Array(i.byteLength);i.copyTo(n),this.addVideoChunkRaw(n,i.type,e??i.timestamp,t)}addVideoChunkRaw(i,t,e,n){if(!(i instanceof Uint8Array))throw new TypeError("addVideoChunkRaw's first argument (data) must be an instance of Uint8Array.");if(t!=="key"&&t!=="delta")throw new TypeError("addVideoChunkRaw's second argument (type) must be either 'key' or 'delta'.");if(!Number.isFinite(e)||e<0)throw new TypeError("addVideoChunkRaw's third argument (timestamp) must be a non-negative real number.");if(n&&typeof n!="object")throw new TypeError("addVideoChunkRaw's fourth argument (meta), when provided, must be an object.");if(Gt(this,ll,lu).call(this),!I(this,Qt).video)throw new Error("No video track declared.");I(this,fl)===void 0&&he(this,fl,e),n&&Gt(this,qd,l_).call(this,n);let s=Gt(this,ol,ou).call(this,i,t,e,$a);for(I(this,Qt).video.codec==="V_VP9"&&Gt(this,Yd,c_).call(this,s),he(this,Xa,s.timestamp);I(this,lr).length>0&&I(this,lr)[0].timestamp<=s.timestamp;){let r=I(this,lr).shift();Gt(this,ls,Ls).call(this,r,!1)}!I(this,Qt).audio||s.timestamp<=I(this,qa)?Gt(this,ls,Ls).call(this,s,!0):I(this,or).push(s),Gt(this,al,au).call(this),Gt(this,Lr,ka).call(this)}addAudioChunk(i,t,e){if(!(i instanceof EncodedAudioChunk))throw new TypeError("addAudioChunk's first argument (chunk) must be of type EncodedAudioChunk.");if(t&&typeof t!="object")throw new TypeError("addAudioChunk's second argument (meta), when provided, must be an object.");if(e!==void 0&&(!Number.isFinite(e)||e<0))throw new TypeError("addAudioChunk's third argument (timestamp), when provided, must be a non-negative real number.");let n=new Uint8Array(i.byteLength);i.copyTo(n),this.addAudioChunkRaw(n,i.type,e??i.timestamp,t)}addAudioChunkRaw(i,t,e,n){if(!(i instanceof Uint8Array))throw new TypeError("addAudioChunkRaw's first argument (data) must be an instance of Uint8Array.");if(t!=="key"&&t!=="delta")throw new TypeError("addAudioChunkRaw's second argument (type) must be either 'key' or 'delta'.");if(!Number.isFinite(e)||e<0)throw new TypeError("addAudioChunkRaw's third argument (timestamp) must be a non-negative real number.");if(n&&typeof n!="object")throw new TypeError("addAudioChunkRaw's fourth argument (meta), when provided, must be an object.");if(Gt(this,ll,lu).call(this),!I(this,Qt).audio)throw new Error("No audio track declared.");I(this,dl)===void 0&&he(this,dl,e),n?.decoderConfig&&(I(this,Qt).streaming?he(this,hr,Gt(this,Ya,bl).call(this,n.decoderConfig.description)):Gt(this,ml,du).call(this,I(this,hr),n.decoderConfig.description));let s=Gt(this,ol,ou).call(this,i,t,e,_l);for(he(this,qa,s.timestamp);I(this,or).length>0&&I(this,or)[0].timestamp<=s.timestamp;){let r=I(this,or).shift();Gt(this,ls,Ls).call(this,r,!0)}!I(this,Qt).video||s.timestamp<=I(this,Xa)?Gt(this,ls,Ls).call(this,s,!I(this,Qt).video):I(this,lr).push(s),Gt(this,al,au).call(this),Gt(this,Lr,ka).call(this)}addSubtitleChunk(i,t,e){if(typeof i!="object"||!i)throw new TypeError("addSubtitleChunk's first argument (chunk) must be an object.");if(!(i.body instanceof Uint8Array))throw new TypeError("body must be an instance of Uint8Array.");if(!Number.isFinite(i.timestamp)||i.timestamp<0)throw new TypeError("timestamp must be a non-negative real number.");if(!Number.isFinite(i.duration)||i.duration<0)throw new TypeError("duration must be a non-negative real number.");if(i.additions&&!(i.additions instanceof Uint8Array))throw new TypeError("additions, when present, must be an instance of Uint8Array.");if(typeof t!="object")throw new TypeError("addSubtitleChunk's second argument (meta) must be an object.");if(Gt(this,ll,lu).call(this),!I(this,Qt).subtitles)throw new Error("No subtitle track declared.");t?.decoderConfig&&(I(this,Qt).streaming?he(this,Va,Gt(this,Ya,bl).call(this,t.decoderConfig.description)):Gt(this,ml,du).call(this,I(this,Va),t.decoderConfig.description));let n=Gt(this,ol,ou).call(this,i.body,"key",e??i.timestamp,uu,i.duration,i.additions);he(this,fu,n.timestamp),I(this,Ir).push(n),Gt(this,al,au).call(this),Gt(this,Lr,ka).call(this)}finalize(){if(I(this,pl))throw new Error("Cannot finalize a muxer more than once.");for(;I(this,or).length>0;)Gt(this,ls,Ls).call(this,I(this,or).shift(),!0);for(;I(this,lr).length>0;)Gt(this,ls,Ls).call(this,I(this,lr).shift(),!0);for(;I(this,Ir).length>0&&I(this,Ir)[0].timestamp<=I(this,Wa);)Gt(this,ls,Ls).call(this,I(this,Ir).shift(),!1);if(I(this,cs)&&Gt(this,pu,hp).call(this),I(this,Wt).writeEBML(I(this,Ga)),!I(this,Qt).streaming){let i=I(this,Wt).pos,t=I(this,Wt).pos-I(this,Dr,za);I(this,Wt).seek(I(this,Wt).offsets.get(I(this,vl))+4),I(this,Wt).writeEBMLVarInt(t,j0),I(this,Ba).data=new Zd(I(this,Wa)),I(this,Wt).seek(I(this,Wt).offsets.get(I(this,Ba))),I(this,Wt).writeEBML(I(this,Ba)),I(this,Ds).data[0].data[1].data=I(this,Wt).offsets.get(I(this,Ga))-I(this,Dr,za),I(this,Ds).data[1].data[1].data=I(this,Wt).offsets.get(I(this,xl))-I(this,Dr,za),I(this,Ds).data[2].data[1].data=I(this,Wt).offsets.get(I(this,Za))-I(this,Dr,za),I(this,Wt).seek(I(this,Wt).offsets.get(I(this,Ds))),I(this,Wt).writeEBML(I(this,Ds)),I(this,Wt).seek(i)}Gt(this,Lr,ka).call(this),I(this,Wt).finalize(),he(this,pl,!0)}};Qt=new WeakMap;Wt=new WeakMap;vl=new WeakMap;xl=new WeakMap;Ds=new WeakMap;Za=new WeakMap;Ba=new WeakMap;Ur=new WeakMap;Ka=new WeakMap;hr=new WeakMap;Va=new WeakMap;Ga=new WeakMap;cs=new WeakMap;Ml=new WeakMap;Wa=new WeakMap;or=new WeakMap;lr=new WeakMap;Ir=new WeakMap;fl=new WeakMap;dl=new WeakMap;Xa=new WeakMap;qa=new WeakMap;fu=new WeakMap;yl=new WeakMap;pl=new WeakMap;Wd=new WeakSet;t_=function(i){if(typeof i!="object")throw new TypeError("The muxer requires an options object to be passed to its constructor.");if(!(i.target instanceof mu))throw new TypeError("The target must be provided and an instance of Target.");if(i.video){if(typeof i.video.codec!="string")throw new TypeError(`Invalid video codec: ${i.video.codec}. Must be a string.`);if(!Number.isInteger(i.video.width)||i.video.width<=0)throw new TypeError(`Invalid video width: ${i.video.width}. Must be a positive integer.`);if(!Number.isInteger(i.video.height)||i.video.height<=0)throw new TypeError(`Invalid video height: ${i.video.height}. Must be a positive integer.`);if(i.video.frameRate!==void 0&&(!Number.isFinite(i.video.frameRate)||i.video.frameRate<=0))throw new TypeError(`Invalid video frame rate: ${i.video.frameRate}. Must be a positive number.`);if(i.video.alpha!==void 0&&typeof i.video.alpha!="boolean")throw new TypeError(`Invalid video alpha: ${i.video.alpha}. Must be a boolean.`)}if(i.audio){if(typeof i.audio.codec!="string")throw new TypeError(`Invalid audio codec: ${i.audio.codec}. Must be a string.`);if(!Number.isInteger(i.audio.numberOfChannels)||i.audio.numberOfChannels<=0)throw new TypeError(`Invalid number of audio channels: ${i.audio.numberOfChannels}. Must be a positive integer.`);if(!Number.isInteger(i.audio.sampleRate)||i.audio.sampleRate<=0)throw new TypeError(`Invalid audio sample rate: ${i.audio.sampleRate}. Must be a positive integer.`);if(i.audio.bitDepth!==void 0&&(!Number.isInteger(i.audio.bitDepth)||i.audio.bitDepth<=0))throw new TypeError(`Invalid audio bit depth: ${i.audio.bitDepth}. Must be a positive integer.`)}if(i.subtitles&&typeof i.subtitles.codec!="string")throw new TypeError(`Invalid subtitles codec: ${i.subtitles.codec}. Must be a string.`);if(i.type!==void 0&&!["webm","matroska"].includes(i.type))throw new TypeError(`Invalid type: ${i.type}. Must be 'webm' or 'matroska'.`);if(i.firstTimestampBehavior&&!gE.includes(i.firstTimestampBehavior))throw new TypeError(`Invalid first timestamp behavior: ${i.firstTimestampBehavior}`);if(i.streaming!==void 0&&typeof i.streaming!="boolean")throw new TypeError(`Invalid streaming option: ${i.streaming}. Must be a boolean.`)};Xd=new WeakSet;e_=function(){I(this,Wt)instanceof Sl&&I(this,Wt).target.options.onHeader&&I(this,Wt).startTrackingWrites(),Gt(this,tp,n_).call(this),I(this,Qt).streaming||Gt(this,ip,r_).call(this),Gt(this,sp,a_).call(this),Gt(this,ep,i_).call(this),Gt(this,np,s_).call(this),I(this,Qt).streaming||(Gt(this,gu,rp).call(this),Gt(this,_u,ap).call(this)),Gt(this,op,o_).call(this),Gt(this,Lr,ka).call(this)};tp=new WeakSet;n_=function(){let i={id:440786851,data:[{id:17030,data:1},{id:17143,data:1},{id:17138,data:4},{id:17139,data:8},{id:17026,data:I(this,Qt).type??"webm"},{id:17031,data:2},{id:17029,data:2}]};I(this,Wt).writeEBML(i)};ep=new WeakSet;i_=function(){he(this,Ka,{id:236,size:4,data:new Uint8Array(ul)}),he(this,hr,{id:236,size:4,data:new Uint8Array(ul)}),he(this,Va,{id:236,size:4,data:new Uint8Array(ul)})};np=new WeakSet;s_=function(){he(this,Ur,{id:21936,data:[{id:21937,data:2},{id:21946,data:2},{id:21947,data:2},{id:21945,data:0}]})};ip=new WeakSet;r_=function(){let i=new Uint8Array([28,83,187,107]),t=new Uint8Array([21,73,169,102]),e=new Uint8Array([22,84,174,107]);he(this,Ds,{id:290298740,data:[{id:19899,data:[{id:21419,data:i},{id:21420,size:5,data:0}]},{id:19899,data:[{id:21419,data:t},{id:21420,size:5,data:0}]},{id:19899,data:[{id:21419,data:e},{id:21420,size:5,data:0}]}]})};sp=new WeakSet;a_=function(){let i={id:17545,data:new Zd(0)};he(this,Ba,i);let t={id:357149030,data:[{id:2807729,data:1e6},{id:19840,data:H0},{id:22337,data:H0},I(this,Qt).streaming?null:i]};he(this,xl,t)};gu=new WeakSet;rp=function(){let i={id:374648427,data:[]};he(this,Za,i),I(this,Qt).video&&i.data.push({id:174,data:[{id:215,data:$a},{id:29637,data:$a},{id:131,data:fE},{id:134,data:I(this,Qt).video.codec},I(this,Ka),I(this,Qt).video.frameRate?{id:2352003,data:1e9/I(this,Qt).video.frameRate}:null,{id:224,data:[{id:176,data:I(this,Qt).video.width},{id:186,data:I(this,Qt).video.height},I(this,Qt).video.alpha?{id:21440,data:1}:null,I(this,Ur)]}]}),I(this,Qt).audio&&(he(this,hr,I(this,Qt).streaming?I(this,hr)||null:{id:236,size:4,data:new Uint8Array(ul)}),i.data.push({id:174,data:[{id:215,data:_l},{id:29637,data:_l},{id:131,data:dE},{id:134,data:I(this,Qt).audio.codec},I(this,hr),{id:225,data:[{id:181,data:new V0(I(this,Qt).audio.sampleRate)},{id:159,data:I(this,Qt).audio.numberOfChannels},I(this,Qt).audio.bitDepth?{id:25188,data:I(this,Qt).audio.bitDepth}:null]}]})),I(this,Qt).subtitles&&i.data.push({id:174,data:[{id:215,data:uu},{id:29637,data:uu},{id:131,data:pE},{id:134,data:I(this,Qt).subtitles.codec},I(this,Va)]})};_u=new WeakSet;ap=function(){let i={id:408125543,size:I(this,Qt).streaming?-1:j0,data:[I(this,Qt).streaming?null:I(this,Ds),I(this,xl),I(this,Za)]};if(he(this,vl,i),I(this,Wt).writeEBML(i),I(this,Wt)instanceof Sl&&I(this,Wt).target.options.onHeader){let{data:t,start:e}=I(this,Wt).getTrackedWrites();I(this,Wt).target.options.onHeader(t,e)}};op=new WeakSet;o_=function(){he(this,Ga,{id:475249515,data:[]})};Lr=new WeakSet;ka=function(){I(this,Wt)instanceof Qd&&I(this,Wt).flush()};Dr=new WeakSet;za=function(){return I(this,Wt).dataOffsets.get(I(this,vl))};qd=new WeakSet;l_=function(i){if(i.decoderConfig){if(i.decoderConfig.colorSpace){let t=i.decoderConfig.colorSpace;if(he(this,yl,t),I(this,Ur).data=[{id:21937,data:{rgb:1,bt709:1,bt470bg:5,smpte170m:6}[t.matrix]},{id:21946,data:{bt709:1,smpte170m:6,"iec61966-2-1":13}[t.transfer]},{id:21947,data:{bt709:1,bt470bg:5,smpte170m:6}[t.primaries]},{id:21945,data:[1,2][Number(t.fullRange)]}],!I(this,Qt).streaming){let e=I(this,Wt).pos;I(this,Wt).seek(I(this,Wt).offsets.get(I(this,Ur))),I(this,Wt).writeEBML(I(this,Ur)),I(this,Wt).seek(e)}}i.decoderConfig.description&&(I(this,Qt).streaming?he(this,Ka,Gt(this,Ya,bl).call(this,i.decoderConfig.description)):Gt(this,ml,du).call(this,I(this,Ka),i.decoderConfig.description))}};Yd=new WeakSet;c_=function(i){if(i.type!=="key"||!I(this,yl))return;let t=0;if(Fa(i.data,0,2)!==2)return;t+=2;let e=(Fa(i.data,t+1,t+2)<<1)+Fa(i.data,t+0,t+1);t+=2,e===3&&t++;let n=Fa(i.data,t+0,t+1);if(t++,n)return;let s=Fa(i.data,t+0,t+1);if(t++,s!==0)return;t+=2;let r=Fa(i.data,t+0,t+24);if(t+=24,r!==4817730)return;e>=2&&t++;let a={rgb:7,bt709:2,bt470bg:1,smpte170m:3}[I(this,yl).matrix];aE(i.data,t+0,t+3,a)};al=new WeakSet;au=function(){let i=Math.min(I(this,Qt).video?I(this,Xa):1/0,I(this,Qt).audio?I(this,qa):1/0),t=I(this,Ir);for(;t.length>0&&t[0].timestamp<=i;)Gt(this,ls,Ls).call(this,t.shift(),!I(this,Qt).video&&!I(this,Qt).audio)};ol=new WeakSet;ou=function(i,t,e,n,s,r){let a=Gt(this,lp,h_).call(this,e,n);return{data:i,additions:r,type:t,timestamp:a,duration:s,trackNumber:n}};lp=new WeakSet;h_=function(i,t){let e=t===$a?I(this,Xa):t===_l?I(this,qa):I(this,fu);if(t!==uu){let n=t===$a?I(this,fl):I(this,dl);if(I(this,Qt).firstTimestampBehavior==="strict"&&e===-1&&i!==0)throw new Error(`The first chunk for your media track must have a timestamp of 0 (received ${i}). Non-zero first timestamps are often caused by directly piping frames or audio data from a MediaStreamTrack into the encoder. Their timestamps are typically relative to the age of the document, which is probably what you want.

If you want to offset all timestamps of a track such that the first one is zero, set firstTimestampBehavior: 'offset' in the options.
If you want to allow non-zero first timestamps, set firstTimestampBehavior: 'permissive'.
`);I(this,Qt).firstTimestampBehavior==="offset"&&(i-=n)}if(i<e)throw new Error(`Timestamps must be monotonically increasing (went from ${e} to ${i}).`);if(i<0)throw new Error(`Timestamps must be non-negative (received ${i}).`);return i};ls=new WeakSet;Ls=function(i,t){I(this,Qt).streaming&&!I(this,Za)&&(Gt(this,gu,rp).call(this),Gt(this,_u,ap).call(this));let e=Math.floor(i.timestamp/1e3),n=e-I(this,Ml),s=t&&i.type==="key"&&n>=1e3,r=n>=mE;if((!I(this,cs)||s||r)&&(Gt(this,cp,u_).call(this,e),n=0),n<0)return;let a=new Uint8Array(4),o=new DataView(a.buffer);if(o.setUint8(0,128|i.trackNumber),o.setInt16(1,n,!1),i.duration===void 0&&!i.additions){o.setUint8(3,+(i.type==="key")<<7);let l={id:163,data:[a,i.data]};I(this,Wt).writeEBML(l)}else{let l=Math.floor(i.duration/1e3),c={id:160,data:[{id:161,data:[a,i.data]},i.duration!==void 0?{id:155,data:l}:null,i.additions?{id:30113,data:i.additions}:null]};I(this,Wt).writeEBML(c)}he(this,Wa,Math.max(I(this,Wa),e))};Ya=new WeakSet;bl=function(i){return{id:25506,size:4,data:new Uint8Array(i)}};ml=new WeakSet;du=function(i,t){let e=I(this,Wt).pos;I(this,Wt).seek(I(this,Wt).offsets.get(i));let n=6+t.byteLength,s=ul-n;if(s<0){let r=t.byteLength+s;t instanceof ArrayBuffer?t=t.slice(0,r):t=t.buffer.slice(0,r),s=0}i=[Gt(this,Ya,bl).call(this,t),{id:236,size:4,data:new Uint8Array(s)}],I(this,Wt).writeEBML(i),I(this,Wt).seek(e)};cp=new WeakSet;u_=function(i){I(this,cs)&&Gt(this,pu,hp).call(this),I(this,Wt)instanceof Sl&&I(this,Wt).target.options.onCluster&&I(this,Wt).startTrackingWrites(),he(this,cs,{id:524531317,size:I(this,Qt).streaming?-1:Q0,data:[{id:231,data:i}]}),I(this,Wt).writeEBML(I(this,cs)),he(this,Ml,i);let t=I(this,Wt).offsets.get(I(this,cs))-I(this,Dr,za);I(this,Ga).data.push({id:187,data:[{id:179,data:i},I(this,Qt).video?{id:183,data:[{id:247,data:$a},{id:241,data:t}]}:null,I(this,Qt).audio?{id:183,data:[{id:247,data:_l},{id:241,data:t}]}:null]})};pu=new WeakSet;hp=function(){if(!I(this,Qt).streaming){let i=I(this,Wt).pos-I(this,Wt).dataOffsets.get(I(this,cs)),t=I(this,Wt).pos;I(this,Wt).seek(I(this,Wt).offsets.get(I(this,cs))+4),I(this,Wt).writeEBMLVarInt(i,Q0),I(this,Wt).seek(t)}if(I(this,Wt)instanceof Sl&&I(this,Wt).target.options.onCluster){let{data:i,start:t}=I(this,Wt).getTrackedWrites();I(this,Wt).target.options.onCluster(i,t,I(this,Ml))}};ll=new WeakSet;lu=function(){if(I(this,pl))throw new Error("Cannot add new video or audio chunks after the file has been finalized.")};var _E=/(?:(\d{2}):)?(\d{2}):(\d{2}).(\d{3})/;var I3=new TextEncoder,vE,xE,yE,bE,SE,ME,wE,EE,TE;vE=new WeakMap;xE=new WeakMap;yE=new WeakMap;bE=new WeakMap;SE=new WeakMap;ME=new WeakSet;wE=function(i){let t=_E.exec(i);if(!t)throw new Error("Expected match.");return 3600*1e3*Number(t[1]||"0")+60*1e3*Number(t[2])+1e3*Number(t[3])+Number(t[4])};EE=new WeakSet;TE=function(i){let t=Math.floor(i/36e5),e=Math.floor(i%(3600*1e3)/(60*1e3)),n=Math.floor(i%(60*1e3)/1e3),s=i%1e3;return t.toString().padStart(2,"0")+":"+e.toString().padStart(2,"0")+":"+n.toString().padStart(2,"0")+"."+s.toString().padStart(3,"0")};var AE=[["1280x720","1280 \xD7 720"],["1920x1080","1920 \xD7 1080"],["3840x2160","3840 \xD7 2160"],["1080x1080","1080 \xD7 1080"]],up=16,Ja=25,vu=class{element;#t;#e=et("input",{type:"number",min:1,step:1,value:1,"aria-label":"First frame"});#r=et("input",{type:"number",min:1,step:1,value:1,"aria-label":"Last frame"});#n;#s;#o=et("p",{class:"hint export-status",role:"status"});#a=et("progress",{max:1,value:0,"aria-label":"Export"});#i=et("span");#h=et("div",{class:"export-told",hidden:!0},this.#a,this.#i);#l=Sn("Stop",()=>this.#f=!0);#c;#f=!1;constructor(t){this.#t=t;let e=Ai("Size",AE,()=>{});this.#n=e.select;let n=si("Write time and colours into pictures",!0,()=>{});this.#s=n.input;let s=et("div",{class:"range-row"},"Frames ",this.#e,"to",this.#r);this.#c=[Sn("PNG",()=>{this.#u(()=>this.#b())}),Sn("PNGs (ZIP)",()=>{this.#u(()=>this.#g())})];let r=et("div",{class:"button-row"},...this.#c,this.#l);RE(...this.#m()).then(o=>{if(o){let l=Sn("Film (WebM)",()=>{this.#u(()=>this.#v())});this.#c.push(l),this.#l.before(l)}}),this.#l.hidden=!0;let a=et("p",{class:"hint"},"An MP4 of the pictures: ",et("code",{},d_));this.element=Qi("Export",e.element,n.element,s,r,this.#h,this.#o,a)}setCount(t){(this.#r.value===this.#r.max||this.#r.max==="")&&(this.#r.value=String(t)),this.#e.max=this.#r.max=String(t)}async#u(t){this.#f=!1,this.#c.forEach(n=>n.disabled=!0),this.#l.hidden=!1,this.#o.textContent="Exporting \u2026";let e=this.#t.index();try{this.#o.textContent=await t()}catch(n){this.#o.textContent=`Not exported: ${n.message}`}finally{this.#l.hidden=this.#h.hidden=!0,this.#c.forEach(n=>n.disabled=!1),await this.#t.show(e).catch(()=>{})}}#d(t,e){this.#h.hidden=!1,[this.#a.max,this.#a.value]=[e,t],this.#i.textContent=`frame ${t+1} of ${e}`}#p(){let t=this.#t.count(),e=(r,a)=>Number.isInteger(r.valueAsNumber)?Math.min(Math.max(r.valueAsNumber,1),t):a,[n,s]=[e(this.#e,1),e(this.#r,t)];if(t===0||n>s)throw new Error("choose a first frame that is not behind the last one.");return[n-1,s-1]}async#b(){let t=await this.#x(this.#t.index());return ea(await p_(t),`${this.#t.name()}_${String(this.#t.index()+1).padStart(5,"0")}.png`),"Saved."}async#g(){let[t,e]=this.#p(),n=[],s=new z0((a,o)=>{if(a)throw a;n.push(o)}),r=0;for(let a=t;a<=e&&!this.#f;a++){this.#d(a-t,e-t+1),await this.#t.show(a);let o=new Uint8Array(await(await p_(await this.#x(a))).arrayBuffer()),l=new k0(`frame_${String(r).padStart(5,"0")}.png`);s.add(l),l.push(o,!0),r+=1}return s.end(),ea(new Blob(n,{type:"application/zip"}),`${this.#t.name()}_frames.zip`),`Saved ${r} pictures. Unpack them and run: ${d_}`}async#v(){let[t,e]=this.#p(),[n,s]=this.#m(),r=new Kd,a=new f_({target:r,video:{codec:"V_VP8",width:n,height:s,frameRate:Ja}}),o=null,l=new VideoEncoder({output:(h,f)=>a.addVideoChunk(h,f),error:h=>o=h});l.configure(m_(n,s));let c=0;for(let h=t;h<=e&&!this.#f&&!o;h++){this.#d(h-t,e-t+1),await this.#t.show(h);let f=new VideoFrame(await this.#x(h),{timestamp:c*1e6/Ja,duration:1e6/Ja});l.encode(f,{keyFrame:c%Ja===0}),f.close(),c+=1}if(await l.flush(),l.close(),o)throw o;return a.finalize(),ea(new Blob([r.buffer],{type:"video/webm"}),`${this.#t.name()}.webm`),`Saved a film of ${c} pictures.`}#m(){let[t,e]=this.#n.value.split("x").map(Number);return[t,e]}async#x(t){let[e,n]=this.#m(),s=await createImageBitmap(await this.#t.scene.screenshot({width:e,height:n})),r=document.createElement("canvas");[r.width,r.height]=[e,n];let a=r.getContext("2d");return a.fillStyle="#ffffff",a.fillRect(0,0,e,n),a.drawImage(s,0,0),s.close(),this.#s.checked&&this.#_(a,t,e,n),r}#_(t,e,n,s){let r=Math.round(s/36);t.font=`600 ${r}px system-ui, sans-serif`,t.textBaseline="middle",t.fillStyle="#1a2129";let a=s-1.2*r;t.fillText(_n(this.#t.time(e),"s"),r,a),this.#t.scales().filter(({scale:l})=>l.scalar!==""&&!l.names).forEach((l,c)=>CE(t,l,{size:r,middle:a-1.6*r*c,width:n}))}};function CE(i,t,{size:e,middle:n,width:s}){let{title:r,low:a,high:o}=Pd(t),[l,c]=[.55*s,.25*s],h=i.createLinearGradient(l,0,l+c,0);for(let u=0;u<=up;u++)h.addColorStop(u/up,`rgb(${Md(t.scale.map,u/up).join(", ")})`);let f=i.fillStyle;i.textAlign="right",i.fillText(`${r}   ${a}`,l-.5*e,n),i.textAlign="left",i.fillText(o,l+c+.5*e,n),i.fillStyle=h,i.fillRect(l,n-.45*e,c,.9*e),i.fillStyle=f}var d_=`ffmpeg -framerate ${Ja} -i frame_%05d.png -c:v libx264 -pix_fmt yuv420p run.mp4`;function m_(i,t){return{codec:"vp8",width:i,height:t,bitrate:12e6,framerate:Ja}}async function RE(i,t){return typeof VideoEncoder<"u"&&((await VideoEncoder.isConfigSupported(m_(i,t))).supported??!1)}function p_(i){return new Promise((t,e)=>i.toBlob(n=>n?t(n):e(new Error("the browser made no picture")),"image/png"))}var PE=6e8,xu=class{#t=new Map;#e=new Map;#r=new Map;#n=new Map;#s=0;clear(){for(let{stop:t}of this.#e.values())t.abort();this.#t.clear(),this.#e.clear(),this.#r.clear(),this.#n.clear(),this.#s=0}peek(t){let e=this.#t.get(t);return e&&(this.#t.delete(t),this.#t.set(t,e)),e}get(t){let e=this.peek(t);return e?Promise.resolve(e):this.#o(t)}prefetch(t,e){for(let n of t){let s=this.#t.get(n);(s?Promise.resolve(s):this.#o(n)).then(a=>e?this.readChains(a):void 0).catch(()=>{})}}async readChains(t){let{contacts:e,step:n}=t;if(!e||e.chains)return;let s=this.#r.get(n);s||(s=sl(`api/contacts/${n}`).finally(()=>this.#r.delete(n)),this.#r.set(n,s));let r=await s;e.chains||(e.chains={ends:r.floats("ends"),normalForce:r.floats("normal_force")},t.bytes+=r.bytes,this.#t.get(n)===t&&(this.#s+=r.bytes,this.#l(n)))}only(t){for(let[e,{stop:n}]of this.#e)t.includes(e)||(n.abort(),this.#e.delete(e))}#o(t){let e=this.#e.get(t);if(e)return e.answer;let n=new AbortController,s=this.#a(t,n.signal).finally(()=>{this.#e.get(t)?.stop===n&&this.#e.delete(t)});return this.#e.set(t,{answer:s,stop:n}),s}async#a(t,e){let n=await sl(`api/frame/${t}`,e),s=IE(n,await this.#i(t,String(n.head.walls)));return e.aborted||this.#h(s),s}#i(t,e){let n=this.#n.get(e);return n||(n=sl(`api/walls/${t}`).then(LE),n.catch(()=>this.#n.delete(e)),this.#n.set(e,n)),n}#h(t){this.#t.set(t.step,t),this.#s+=t.bytes,this.#l(t.step)}#l(t){for(let[e,n]of this.#t){if(this.#s<=PE||e===t)break;this.#t.delete(e),this.#s-=n.bytes}}};function IE(i,t){let e=i.head.scalars,n=i.head.contacts;return{step:i.head.step,time:i.head.time,bytes:i.bytes,grains:{position:i.floats("position"),radius:i.floats("radius"),id:i.counts("id"),scalars:new Map(e.map(({name:s})=>[s,i.floats(s)])),categories:new Map(e.flatMap(({name:s,names:r})=>r?[[s,r]]:[]))},contacts:{count:n.count,meanForce:n.mean_force??0,chains:null},walls:t,scalars:e.map(({name:s,unit:r,meaning:a})=>({name:s,unit:r,meaning:a}))}}function LE(i){let t=i.floats("triangles");return i.head.list.map(({name:n,index:s,start:r,end:a})=>({name:n,index:s,triangles:t.slice(9*r,9*a)}))}var DE="uplot",NE="u-hz",UE="u-vt",FE="u-title",OE="u-wrap",BE="u-under",kE="u-over",zE="u-axis",Br="u-off",HE="u-select",VE="u-cursor-x",GE="u-cursor-y",WE="u-cursor-pt",XE="u-legend",qE="u-live",YE="u-inline",$E="u-series",ZE="u-marker",g_="u-label",KE="u-value",El="width",Tl="height";var __="bottom",ja="left",fp="right",Rp="#000",v_=Rp+"0",dp="mousemove",x_="mousedown",pp="mouseup",y_="mouseenter",b_="mouseleave",S_="dblclick",JE="resize",jE="scroll",M_="change",wu="dppxchange",Pp="--",ro=typeof window<"u",xp=ro?document:null,to=ro?window:null,QE=ro?navigator:null,Ie,yu;function yp(){let i=devicePixelRatio;Ie!=i&&(Ie=i,yu&&Sp(M_,yu,yp),yu=matchMedia(`(min-resolution: ${Ie-.001}dppx) and (max-resolution: ${Ie+.001}dppx)`),kr(M_,yu,yp),to.dispatchEvent(new CustomEvent(wu)))}function Si(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function bp(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Ke(i,t,e){i.style[t]=e+"px"}function Gi(i,t,e,n){let s=xp.createElement(i);return t!=null&&Si(s,t),e?.insertBefore(s,n),s}function Li(i,t){return Gi("div",i,t)}var w_=new WeakMap;function hs(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",a=w_.get(i);r!=a&&(i.style.transform=r,w_.set(i,r),t<0||e<0||t>n||e>s?Si(i,Br):bp(i,Br))}var E_=new WeakMap;function T_(i,t,e){let n=t+e,s=E_.get(i);n!=s&&(E_.set(i,n),i.style.background=t,i.style.borderColor=e)}var A_=new WeakMap;function C_(i,t,e,n){let s=t+""+e,r=A_.get(i);s!=r&&(A_.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var Ip={passive:!0},tT={...Ip,capture:!0};function kr(i,t,e,n){t.addEventListener(i,e,n?tT:Ip)}function Sp(i,t,e,n){t.removeEventListener(i,e,Ip)}ro&&yp();function Wi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:Mi((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function nv(i){return(e,n,s)=>{let r=-1,a=-1;for(let o=n;o<=s;o++)if(i(e[o])){r=o;break}for(let o=s;o>=n;o--)if(i(e[o])){a=o;break}return[r,a]}}var iv=i=>i!=null,sv=i=>i!=null&&i>0,Au=nv(iv),eT=nv(sv);function nT(i,t,e,n=0,s=!1){let r=s?eT:Au,a=s?sv:iv;[t,e]=r(i,t,e);let o=i[t],l=i[t];if(t>-1)if(n==1)o=i[t],l=i[e];else if(n==-1)o=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];a(h)&&(h<o?o=h:h>l&&(l=h))}return[o??He,l??-He]}function Cu(i,t,e,n){let s=I_(i),r=I_(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let a=e==10?Us:rv,o=s==1?Mi:Di,l=r==1?Di:Mi,c=o(a(An(i))),h=l(a(An(t))),f=eo(e,c),u=eo(e,h);return e==10&&(c<0&&(f=Ve(f,-c)),h<0&&(u=Ve(u,-h))),n||e==2?(i=f*s,t=u*r):(i=cv(i,f),t=Ru(t,u)),[i,t]}function Lp(i,t,e,n){let s=Cu(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var Dp=.1,R_={mode:3,pad:Dp},Cl={pad:0,soft:null,mode:0},iT={min:Cl,max:Cl};function Eu(i,t,e,n){return Pu(e)?P_(i,t,e):(Cl.pad=e,Cl.soft=n?0:null,Cl.mode=n?3:0,P_(i,t,iT))}function Ae(i,t){return i??t}function sT(i,t,e){for(t=Ae(t,0),e=Ae(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function P_(i,t,e){let n=e.min,s=e.max,r=Ae(n.pad,0),a=Ae(s.pad,0),o=Ae(n.hard,-He),l=Ae(s.hard,He),c=Ae(n.soft,He),h=Ae(s.soft,-He),f=Ae(n.mode,0),u=Ae(s.mode,0),p=t-i,g=Us(p),b=ii(An(i),An(t)),d=Us(b),m=An(d-g);(p<1e-24||m>10)&&(p=0,(i==0||t==0)&&(p=1e-24,f==2&&c!=He&&(r=0),u==2&&h!=-He&&(a=0)));let y=p||b||1e3,C=Us(y),w=eo(10,Mi(C)),P=y*(p==0?i==0?.1:1:r),T=Ve(cv(i-P,w/10),24),v=i>=c&&(f==1||f==3&&T<=c||f==2&&T>=c)?c:He,E=ii(o,T<v&&i>=v?v:Xi(v,T)),z=y*(p==0?t==0?.1:1:a),U=Ve(Ru(t+z,w/10),24),N=t<=h&&(u==1||u==3&&U>=h||u==2&&U<=h)?h:-He,W=Xi(l,U>N&&t<=N?N:ii(N,U));return E==W&&E==0&&(W=100),[E,W]}var rT=new Intl.NumberFormat(ro?QE.language:"en-US"),Np=i=>rT.format(i),wi=Math,Mu=wi.PI,An=wi.abs,Mi=wi.floor,Tn=wi.round,Di=wi.ceil,Xi=wi.min,ii=wi.max,eo=wi.pow,I_=wi.sign,Us=wi.log10,rv=wi.log2,aT=(i,t=1)=>wi.sinh(i)*t,mp=(i,t=1)=>wi.asinh(i/t),He=1/0;function L_(i){return(Us((i^i>>31)-(i>>31))|0)+1}function Mp(i,t,e){return Xi(ii(i,t),e)}function av(i){return typeof i=="function"}function Me(i){return av(i)?i:()=>i}var oT=()=>{},ov=i=>i,lv=(i,t)=>t,lT=i=>null,D_=i=>!0,N_=(i,t)=>i==t,cT=/\.\d*?(?=9{6,}|0{6,})/gm,zr=i=>{if(uv(i)||fr.has(i))return i;let t=`${i}`,e=t.match(cT);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${zr(s)}e${r}`}return Ve(i,n)};function Fr(i,t){return zr(Ve(zr(i/t))*t)}function Ru(i,t){return zr(Di(zr(i/t))*t)}function cv(i,t){return zr(Mi(zr(i/t))*t)}function Ve(i,t=0){if(uv(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Tn(n)/e}var fr=new Map;function hv(i){return((""+i).split(".")[1]||"").length}function Pl(i,t,e,n){let s=[],r=n.map(hv);for(let a=t;a<e;a++){let o=An(a),l=Ve(eo(i,a),o);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${a}`:n[c]*l,f=(a>=0?0:o)+(a>=r[c]?0:r[c]),u=i==10?h:Ve(h,f);s.push(u),fr.set(u,f)}}return s}var Rl={},Up=[],no=[null,null],ur=Array.isArray,uv=Number.isInteger,hT=i=>i===void 0;function U_(i){return typeof i=="string"}function Pu(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function uT(i){return i!=null&&typeof i=="object"}var fT=Object.getPrototypeOf(Uint8Array),fv="__proto__";function io(i,t=Pu){let e;if(ur(i)){let n=i.find(s=>s!=null);if(ur(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=io(i[s],t)}else e=i.slice()}else if(i instanceof fT)e=i.slice();else if(t(i)){e={};for(let n in i)n!=fv&&(e[n]=io(i[n],t))}else e=i;return e}function vn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=fv&&(Pu(i[s])?vn(i[s],io(n[s])):i[s]=io(n[s]))}return i}var dT=0,pT=1,mT=2;function gT(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let a=t[n];if(a>r){for(s=a-1;s>=0&&i[s]==null;)i[s--]=null;for(s=a+1;s<e&&i[s]==null;)i[r=s++]=null}}}function _T(i,t){if(yT(i)){let a=i[0].slice();for(let o=1;o<i.length;o++)a.push(...i[o].slice(1));return bT(a[0])||(a=xT(a)),a}let e=new Set;for(let a=0;a<i.length;a++){let l=i[a][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((a,o)=>a-o)],s=n[0].length,r=new Map;for(let a=0;a<s;a++)r.set(n[0][a],a);for(let a=0;a<i.length;a++){let o=i[a],l=o[0];for(let c=1;c<o.length;c++){let h=o[c],f=Array(s).fill(void 0),u=t?t[a][c]:pT,p=[];for(let g=0;g<h.length;g++){let b=h[g],d=r.get(l[g]);b===null?u!=dT&&(f[d]=b,u==mT&&p.push(d)):f[d]=b}gT(f,p,s),n.push(f)}}return n}var vT=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function xT(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,a)=>t[r]-t[a]);let s=[];for(let r=0;r<i.length;r++){let a=i[r],o=Array(e);for(let l=0;l<e;l++)o[l]=a[n[l]];s.push(o)}return s}function yT(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function bT(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=ii(1,Mi((s-n+1)/t));for(let a=i[n],o=n+r;o<=s;o+=r){let l=i[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}var dv=["January","February","March","April","May","June","July","August","September","October","November","December"],pv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function mv(i){return i.slice(0,3)}var ST=pv.map(mv),MT=dv.map(mv),wT={MMMM:dv,MMM:MT,WWWW:pv,WWW:ST};function wl(i){return(i<10?"0":"")+i}function ET(i){return(i<10?"00":i<100?"0":"")+i}var TT={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>wl(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>wl(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>wl(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>wl(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>wl(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>ET(i.getMilliseconds())};function Fp(i,t){t=t||wT;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?TT[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<e.length;o++)a+=typeof e[o]=="string"?e[o]:e[o](r,t);return a}}var AT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function CT(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==AT?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var gv=i=>i%1==0,Tu=[1,2,2.5,5],RT=Pl(10,-32,0,Tu),_v=Pl(10,0,32,Tu),PT=_v.filter(gv),Or=RT.concat(_v),Op=`
`,vv="{YYYY}",F_=Op+vv,xv="{M}/{D}",Al=Op+xv,bu=Al+"/{YY}",yv="{aa}",IT="{h}:{mm}",Qa=IT+yv,O_=Op+Qa,B_=":{ss}",De=null;function bv(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,a=s*365,l=(i==1?Pl(10,0,3,Tu).filter(gv):Pl(10,-3,0,Tu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]),c=[[a,vv,De,De,De,De,De,De,1],[s*28,"{MMM}",F_,De,De,De,De,De,1],[s,xv,F_,De,De,De,De,De,1],[n,"{h}"+yv,bu,De,Al,De,De,De,1],[e,Qa,bu,De,Al,De,De,De,1],[t,B_,bu+" "+Qa,De,Al+" "+Qa,De,O_,De,1],[i,B_+".{fff}",bu+" "+Qa,De,Al+" "+Qa,De,O_,De,1]];function h(f){return(u,p,g,b,d,m)=>{let y=[],C=d>=a,w=d>=r&&d<a,P=f(g),T=Ve(P*i,3),v=gp(P.getFullYear(),C?0:P.getMonth(),w||C?1:P.getDate()),E=Ve(v*i,3);if(w||C){let z=w?d/r:0,U=C?d/a:0,N=T==E?T:Ve(gp(v.getFullYear()+U,v.getMonth()+z,1)*i,3),W=new Date(Tn(N/i)),G=W.getFullYear(),D=W.getMonth();for(let V=0;N<=b;V++){let K=gp(G+U*V,D+z*V,1),H=K-f(Ve(K*i,3));N=Ve((+K+H)*i,3),N<=b&&y.push(N)}}else{let z=d>=s?s:d,U=Mi(g)-Mi(T),N=E+U+Ru(T-E,z);y.push(N);let W=f(N),G=W.getHours()+W.getMinutes()/e+W.getSeconds()/n,D=d/n,V=u.axes[p]._space,K=m/V;for(;N=Ve(N+d,i==1?0:3),!(N>b);)if(D>1){let H=Mi(Ve(G+D,6))%24,Q=f(N).getHours()-H;Q>1&&(Q=-1),N-=Q*n,G=(G+D)%24;let rt=y[y.length-1];Ve((N-rt)/d,3)*K>=.7&&y.push(N)}else y.push(N)}return y}}return[l,c,h]}var[LT,DT,NT]=bv(1),[UT,FT,OT]=bv(.001);Pl(2,-53,53,[1]);function k_(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function z_(i,t){return(e,n,s,r,a)=>{let o=t.find(g=>a>=g[0])||t[t.length-1],l,c,h,f,u,p;return n.map(g=>{let b=i(g),d=b.getFullYear(),m=b.getMonth(),y=b.getDate(),C=b.getHours(),w=b.getMinutes(),P=b.getSeconds(),T=d!=l&&o[2]||m!=c&&o[3]||y!=h&&o[4]||C!=f&&o[5]||w!=u&&o[6]||P!=p&&o[7]||o[1];return l=d,c=m,h=y,f=C,u=w,p=P,T(b)})}}function BT(i,t){let e=Fp(t);return(n,s,r,a,o)=>s.map(l=>e(i(l)))}function gp(i,t,e){return new Date(i,t,e)}function H_(i,t){return t(i)}var kT="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function V_(i,t){return(e,n,s,r)=>r==null?Pp:t(i(n))}function zT(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function HT(i,t){return i.series[t].fill(i,t)}var VT={show:!0,live:!0,isolate:!1,mount:oT,markers:{show:!0,width:2,stroke:zT,fill:HT,dash:"solid"},idx:null,idxs:null,values:[]};function GT(i,t){let e=i.cursor.points,n=Li(),s=e.size(i,t);Ke(n,El,s),Ke(n,Tl,s);let r=s/-2;Ke(n,"marginLeft",r),Ke(n,"marginTop",r);let a=e.width(i,t,s);return a&&Ke(n,"borderWidth",a),n}function WT(i,t){let e=i.series[t].points;return e._fill||e._stroke}function XT(i,t){let e=i.series[t].points;return e._stroke||e._fill}function qT(i,t){return i.series[t].points.size}var _p=[0,0];function YT(i,t,e){return _p[0]=t,_p[1]=e,_p}function Su(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function vp(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var $T={show:!0,x:!0,y:!0,lock:!1,move:YT,points:{one:!1,show:GT,size:qT,width:0,stroke:XT,fill:WT},bind:{mousedown:Su,mouseup:Su,click:Su,dblclick:Su,mousemove:vp,mouseleave:vp,mouseenter:vp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Sv={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Bp=vn({},Sv,{filter:lv}),Mv=vn({},Bp,{size:10}),wv=vn({},Sv,{show:!1}),kp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Ev="bold "+kp,Tv=1.5,G_={show:!0,scale:"x",stroke:Rp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ev,side:2,grid:Bp,ticks:Mv,border:wv,font:kp,lineGap:Tv,rotate:0},ZT="Value",KT="Time",W_={show:!0,scale:"x",auto:!1,sorted:1,min:He,max:-He,idxs:[]};function JT(i,t,e,n,s){return t.map(r=>r==null?"":Np(r))}function jT(i,t,e,n,s,r,a){let o=[],l=fr.get(s)||0;e=a?e:Ve(Ru(e,s),l);for(let c=e;c<=n;c=Ve(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function wp(i,t,e,n,s,r,a){let o=[],l=i.scales[i.axes[t].scale].log,c=l==10?Us:rv,h=Mi(c(e));s=eo(l,h),l==10&&(s=Or[Wi(s,Or)]);let f=e,u=s*l;l==10&&(u=Or[Wi(u,Or)]);do o.push(f),f=f+s,l==10&&!fr.has(f)&&(f=Ve(f,fr.get(s))),f>=u&&(s=f,u=s*l,l==10&&(u=Or[Wi(u,Or)]));while(f<=n);return o}function QT(i,t,e,n,s,r,a){let l=i.scales[i.axes[t].scale].asinh,c=n>l?wp(i,t,ii(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?wp(i,t,ii(l,-n),-e,s):[l]).reverse().map(u=>-u).concat(h,c)}var Av=/./,tA=/[12357]/,eA=/[125]/,X_=/1/,Ep=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function nA(i,t,e,n,s){let r=i.axes[e],a=r.scale,o=i.scales[a],l=i.valToPos,c=r._space,h=l(10,a),f=l(9,a)-h>=c?Av:l(7,a)-h>=c?tA:l(5,a)-h>=c?eA:X_;if(f==X_){let u=An(l(1,a)-h);if(u<c)return Ep(t.slice().reverse(),o.distr,f,Di(c/u)).reverse()}return Ep(t,o.distr,f,1)}function iA(i,t,e,n,s){let r=i.axes[e],a=r.scale,o=r._space,l=i.valToPos,c=An(l(1,a)-l(2,a));return c<o?Ep(t.slice().reverse(),3,Av,Di(o/c)).reverse():t}function sA(i,t,e,n){return n==null?Pp:t==null?"":Np(t)}var q_={show:!0,scale:"y",stroke:Rp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Ev,side:3,grid:Bp,ticks:Mv,border:wv,font:kp,lineGap:Tv,rotate:0};function rA(i,t){let e=3+(i||1)*2;return Ve(e*t,3)}function aA(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),a=i.valToPos(s[n[1]],e,!0),o=An(a-r),l=i.series[t],c=o/(l.points.space*Ie);return n[1]-n[0]<=c}var Y_={scale:null,auto:!0,sorted:0,min:He,max:-He},Cv=(i,t,e,n,s)=>s,$_={show:!0,auto:!0,sorted:0,gaps:Cv,alpha:1,facets:[vn({},Y_,{scale:"x"}),vn({},Y_,{scale:"y"})]},Z_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Cv,alpha:1,points:{show:aA,filter:null},values:null,min:He,max:-He,idxs:[],path:null,clip:null};function oA(i,t,e,n,s){return e/10}var Rv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},lA=vn({},Rv,{time:!1,ori:1}),K_={};function Pv(i,t){let e=K_[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,a,o,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,a,o,l,c)}},i!=null&&(K_[i]=e)),e}var so=1,Tp=2;function Hr(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,a=i.scales,o=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?a[s.facets[0].scale]:a[i.series[0].scale],f=n==2?a[s.facets[1].scale]:a[s.scale],u=o.left,p=o.top,g=o.width,b=o.height,d=i.valToPosH,m=i.valToPosV;return h.ori==0?e(s,l,c,h,f,d,m,u,p,g,b,Lu,ao,Nu,Lv,Nv):e(s,l,c,h,f,m,d,p,u,b,g,Du,oo,Vp,Dv,Uv)}function zp(i,t){let e=0,n=0,s=Ae(i.bands,Up);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==t?e=a.dir:a.series[1]==t&&(a.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function cA(i,t,e,n,s){let r=i.mode,a=i.series[t],o=r==2?a.facets[1].scale:a.scale,l=i.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Fs(i,t,e,n,s,r){return Hr(i,t,(a,o,l,c,h,f,u,p,g,b,d)=>{let m=a.pxRound,y=c.dir*(c.ori==0?1:-1),C=c.ori==0?ao:oo,w,P;y==1?(w=e,P=n):(w=n,P=e);let T=m(f(o[w],c,b,p)),v=m(u(l[w],h,d,g)),E=m(f(o[P],c,b,p)),z=m(u(r==1?h.max:h.min,h,d,g)),U=new Path2D(s);return C(U,E,z),C(U,T,z),C(U,T,v),U})}function Iu(i,t,e,n,s,r){let a=null;if(i.length>0){a=new Path2D;let o=t==0?Nu:Vp,l=e;for(let f=0;f<i.length;f++){let u=i[f];if(u[1]>u[0]){let p=u[0]-l;p>0&&o(a,l,n,p,n+r),l=u[1]}}let c=e+s-l,h=10;c>0&&o(a,l,n-h/2,c,n+r+h)}return a}function hA(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Hp(i,t,e,n,s,r,a){let o=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let f=c,u=c;if(s==1)for(;++c<=n&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let p=r(i[f]),g=u==f?p:r(i[u]),b=f-s;p=a<=0&&b>=0&&b<l?r(i[b]):p;let m=u+s;g=a>=0&&m>=0&&m<l?r(i[m]):g,g>=p&&o.push([p,g])}return o}function J_(i){return i==0?ov:i==1?Tn:t=>Fr(t,i)}function Iv(i){let t=i==0?Lu:Du,e=i==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},n=i==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,h=0)=>{c==0&&h==0?n(s,r,a,o,l):(c=Xi(c,o/2,l/2),h=Xi(h,o/2,l/2),t(s,r+c,a),e(s,r+o,a,r+o,a+l,c),e(s,r+o,a+l,r,a+l,h),e(s,r,a+l,r,a,h),e(s,r,a,r+o,a,c),s.closePath())}}var Lu=(i,t,e)=>{i.moveTo(t,e)},Du=(i,t,e)=>{i.moveTo(e,t)},ao=(i,t,e)=>{i.lineTo(t,e)},oo=(i,t,e)=>{i.lineTo(e,t)},Nu=Iv(0),Vp=Iv(1),Lv=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},Dv=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},Nv=(i,t,e,n,s,r,a)=>{i.bezierCurveTo(t,e,n,s,r,a)},Uv=(i,t,e,n,s,r,a)=>{i.bezierCurveTo(e,t,s,n,a,r)};function Fv(i){return(t,e,n,s,r)=>Hr(t,e,(a,o,l,c,h,f,u,p,g,b,d)=>{let{pxRound:m,points:y}=a,C,w;c.ori==0?(C=Lu,w=Lv):(C=Du,w=Dv);let P=Ve(y.width*Ie,3),T=(y.size-y.width)/2*Ie,v=Ve(T*2,3),E=new Path2D,z=new Path2D,{left:U,top:N,width:W,height:G}=t.bbox;Nu(z,U-v,N-v,W+v*2,G+v*2);let D=V=>{if(l[V]!=null){let K=m(f(o[V],c,b,p)),H=m(u(l[V],h,d,g));C(E,K+T,H),w(E,K,H,T,0,Mu*2)}};if(r)r.forEach(D);else for(let V=n;V<=s;V++)D(V);return{stroke:P>0?E:null,fill:E,clip:z,flags:so|Tp}})}function Ov(i){return(t,e,n,s,r,a)=>{n!=s&&(r!=n&&a!=n&&i(t,e,n),r!=s&&a!=s&&i(t,e,s),i(t,e,a))}}var uA=Ov(ao),fA=Ov(oo);function Bv(i){let t=Ae(i?.alignGaps,0);return(e,n,s,r)=>Hr(e,n,(a,o,l,c,h,f,u,p,g,b,d)=>{[s,r]=Au(l,s,r);let m=a.pxRound,y=G=>m(f(G,c,b,p)),C=G=>m(u(G,h,d,g)),w,P;c.ori==0?(w=ao,P=uA):(w=oo,P=fA);let T=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:so},E=v.stroke,z=!1;if(r-s>=b*4){let G=ft=>e.posToVal(ft,c.key,!0),D=null,V=null,K,H,ht,J=y(o[T==1?s:r]),Q=y(o[s]),rt=y(o[r]),dt=G(T==1?Q+1:rt-1);for(let ft=T==1?s:r;ft>=s&&ft<=r;ft+=T){let tt=o[ft],xt=(T==1?tt<dt:tt>dt)?J:y(tt),Ct=l[ft];xt==J?Ct!=null?(H=Ct,D==null?(w(E,xt,C(H)),K=D=V=H):H<D?D=H:H>V&&(V=H)):Ct===null&&(z=!0):(D!=null&&P(E,J,C(D),C(V),C(K),C(H)),Ct!=null?(H=Ct,w(E,xt,C(H)),D=V=K=H):(D=V=null,Ct===null&&(z=!0)),J=xt,dt=G(J+T))}D!=null&&D!=V&&ht!=J&&P(E,J,C(D),C(V),C(K),C(H))}else for(let G=T==1?s:r;G>=s&&G<=r;G+=T){let D=l[G];D===null?z=!0:D!=null&&w(E,y(o[G]),C(D))}let[N,W]=zp(e,n);if(a.fill!=null||N!=0){let G=v.fill=new Path2D(E),D=a.fillTo(e,n,a.min,a.max,N),V=C(D),K=y(o[s]),H=y(o[r]);T==-1&&([H,K]=[K,H]),w(G,H,V),w(G,K,V)}if(!a.spanGaps){let G=[];z&&G.push(...Hp(o,l,s,r,T,y,t)),v.gaps=G=a.gaps(e,n,s,r,G),v.clip=Iu(G,c.ori,p,g,b,d)}return W!=0&&(v.band=W==2?[Fs(e,n,s,r,E,-1),Fs(e,n,s,r,E,1)]:Fs(e,n,s,r,E,W)),v})}function dA(i){let t=Ae(i.align,1),e=Ae(i.ascDesc,!1),n=Ae(i.alignGaps,0),s=Ae(i.extend,!1);return(r,a,o,l)=>Hr(r,a,(c,h,f,u,p,g,b,d,m,y,C)=>{[o,l]=Au(f,o,l);let w=c.pxRound,{left:P,width:T}=r.bbox,v=Q=>w(g(Q,u,y,d)),E=Q=>w(b(Q,p,C,m)),z=u.ori==0?ao:oo,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:so},N=U.stroke,W=u.dir*(u.ori==0?1:-1),G=E(f[W==1?o:l]),D=v(h[W==1?o:l]),V=D,K=D;s&&t==-1&&(K=P,z(N,K,G)),z(N,D,G);for(let Q=W==1?o:l;Q>=o&&Q<=l;Q+=W){let rt=f[Q];if(rt==null)continue;let dt=v(h[Q]),ft=E(rt);t==1?z(N,dt,G):z(N,V,ft),z(N,dt,ft),G=ft,V=dt}let H=V;s&&t==1&&(H=P+T,z(N,H,G));let[ht,J]=zp(r,a);if(c.fill!=null||ht!=0){let Q=U.fill=new Path2D(N),rt=c.fillTo(r,a,c.min,c.max,ht),dt=E(rt);z(Q,H,dt),z(Q,K,dt)}if(!c.spanGaps){let Q=[];Q.push(...Hp(h,f,o,l,W,v,n));let rt=c.width*Ie/2,dt=e||t==1?rt:-rt,ft=e||t==-1?-rt:rt;Q.forEach(tt=>{tt[0]+=dt,tt[1]+=ft}),U.gaps=Q=c.gaps(r,a,o,l,Q),U.clip=Iu(Q,u.ori,d,m,y,C)}return J!=0&&(U.band=J==2?[Fs(r,a,o,l,N,-1),Fs(r,a,o,l,N,1)]:Fs(r,a,o,l,N,J)),U})}function j_(i,t,e,n,s,r,a=He){if(i.length>1){let o=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(o!=null){let h=An(i[l]-i[o]);h<c&&(c=h,a=An(e(i[l],n,s,r)-e(i[o],n,s,r)))}o=l}}return a}function pA(i){i=i||Rl;let t=Ae(i.size,[.6,He,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Me(s),a=1-t[0],o=Ae(t[1],He),l=Ae(t[2],1),c=Ae(i.disp,Rl),h=Ae(i.each,p=>{}),{fill:f,stroke:u}=c;return(p,g,b,d)=>Hr(p,g,(m,y,C,w,P,T,v,E,z,U,N)=>{let W=m.pxRound,G=e,D=n*Ie,V=o*Ie,K=l*Ie,H,ht;w.ori==0?[H,ht]=r(p,g):[ht,H]=r(p,g);let J=w.dir*(w.ori==0?1:-1),Q=w.ori==0?Nu:Vp,rt=w.ori==0?h:(Pt,Jt,ce,wt,ze,Vt,Zt)=>{h(Pt,Jt,ce,ze,wt,Zt,Vt)},dt=Ae(p.bands,Up).find(Pt=>Pt.series[0]==g),ft=dt!=null?dt.dir:0,tt=m.fillTo(p,g,m.min,m.max,ft),gt=W(v(tt,P,N,z)),xt,Ct,Mt,Yt=U,le=W(m.width*Ie),Xt=!1,me=null,fe=null,ae=null,Je=null;f!=null&&(le==0||u!=null)&&(Xt=!0,me=f.values(p,g,b,d),fe=new Map,new Set(me).forEach(Pt=>{Pt!=null&&fe.set(Pt,new Path2D)}),le>0&&(ae=u.values(p,g,b,d),Je=new Map,new Set(ae).forEach(Pt=>{Pt!=null&&Je.set(Pt,new Path2D)})));let{x0:Ge,size:cn}=c;if(Ge!=null&&cn!=null){G=1,y=Ge.values(p,g,b,d),Ge.unit==2&&(y=y.map(ce=>p.posToVal(E+ce*U,w.key,!0)));let Pt=cn.values(p,g,b,d);cn.unit==2?Ct=Pt[0]*U:Ct=T(Pt[0],w,U,E)-T(0,w,U,E),Yt=j_(y,C,T,w,U,E,Yt),Mt=Yt-Ct+D}else Yt=j_(y,C,T,w,U,E,Yt),Mt=Yt*a+D,Ct=Yt-Mt;Mt<1&&(Mt=0),le>=Ct/2&&(le=0),Mt<5&&(W=ov);let Oe=Mt>0,Cn=Yt-Mt-(Oe?le:0);Ct=W(Mp(Cn,K,V)),xt=(G==0?Ct/2:G==J?0:Ct)-G*J*((G==0?D/2:0)+(Oe?le/2:0));let we={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},yn=Xt?null:new Path2D,tn=null;if(dt!=null)tn=p.data[dt.series[1]];else{let{y0:Pt,y1:Jt}=c;Pt!=null&&Jt!=null&&(C=Jt.values(p,g,b,d),tn=Pt.values(p,g,b,d))}let hn=H*Ct,O=ht*Ct;for(let Pt=J==1?b:d;Pt>=b&&Pt<=d;Pt+=J){let Jt=C[Pt];if(Jt==null)continue;if(tn!=null){let q=tn[Pt]??0;if(Jt-q==0)continue;gt=v(q,P,N,z)}let ce=w.distr!=2||c!=null?y[Pt]:Pt,wt=T(ce,w,U,E),ze=v(Ae(Jt,tt),P,N,z),Vt=W(wt-xt),Zt=W(ii(ze,gt)),A=W(Xi(ze,gt)),x=Zt-A;if(Jt!=null){let q=Jt<0?O:hn,ut=Jt<0?hn:O;Xt?(le>0&&ae[Pt]!=null&&Q(Je.get(ae[Pt]),Vt,A+Mi(le/2),Ct,ii(0,x-le),q,ut),me[Pt]!=null&&Q(fe.get(me[Pt]),Vt,A+Mi(le/2),Ct,ii(0,x-le),q,ut)):Q(yn,Vt,A+Mi(le/2),Ct,ii(0,x-le),q,ut),rt(p,g,Pt,Vt-le/2,A,Ct+le,x)}}return le>0?we.stroke=Xt?Je:yn:Xt||(we._fill=m.width==0?m._fill:m._stroke??m._fill,we.width=0),we.fill=Xt?fe:yn,we})}function mA(i,t){let e=Ae(t?.alignGaps,0);return(n,s,r,a)=>Hr(n,s,(o,l,c,h,f,u,p,g,b,d,m)=>{[r,a]=Au(c,r,a);let y=o.pxRound,C=H=>y(u(H,h,d,g)),w=H=>y(p(H,f,m,b)),P,T,v;h.ori==0?(P=Lu,v=ao,T=Nv):(P=Du,v=oo,T=Uv);let E=h.dir*(h.ori==0?1:-1),z=C(l[E==1?r:a]),U=z,N=[],W=[];for(let H=E==1?r:a;H>=r&&H<=a;H+=E)if(c[H]!=null){let J=l[H],Q=C(J);N.push(U=Q),W.push(w(c[H]))}let G={stroke:i(N,W,P,v,T,y),fill:null,clip:null,band:null,gaps:null,flags:so},D=G.stroke,[V,K]=zp(n,s);if(o.fill!=null||V!=0){let H=G.fill=new Path2D(D),ht=o.fillTo(n,s,o.min,o.max,V),J=w(ht);v(H,U,J),v(H,z,J)}if(!o.spanGaps){let H=[];H.push(...Hp(l,c,r,a,E,C,e)),G.gaps=H=o.gaps(n,s,r,a,H),G.clip=Iu(H,h.ori,g,b,d,m)}return K!=0&&(G.band=K==2?[Fs(n,s,r,a,D,-1),Fs(n,s,r,a,D,1)]:Fs(n,s,r,a,D,K)),G})}function gA(i){return mA(_A,i)}function _A(i,t,e,n,s,r){let a=i.length;if(a<2)return null;let o=new Path2D;if(e(o,i[0],t[0]),a==2)n(o,i[1],t[1]);else{let l=Array(a),c=Array(a-1),h=Array(a-1),f=Array(a-1);for(let u=0;u<a-1;u++)h[u]=t[u+1]-t[u],f[u]=i[u+1]-i[u],c[u]=h[u]/f[u];l[0]=c[0];for(let u=1;u<a-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(f[u-1]+f[u])/((2*f[u]+f[u-1])/c[u-1]+(f[u]+2*f[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[a-1]=c[a-2];for(let u=0;u<a-1;u++)s(o,i[u]+f[u]/3,t[u]+l[u]*f[u]/3,i[u+1]-f[u]/3,t[u+1]-l[u+1]*f[u]/3,i[u+1],t[u+1])}return o}var Ap=new Set;function Q_(){for(let i of Ap)i.syncRect(!0)}ro&&(kr(JE,to,Q_),kr(jE,to,Q_,!0),kr(wu,to,()=>{xn.pxRatio=Ie}));var vA=Bv(),xA=Fv();function tv(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,a)=>Cp(r,a,t,e))}function yA(i,t){return i.map((e,n)=>n==0?{}:vn({},t,e))}function Cp(i,t,e,n){return vn({},t==0?e:n,i)}function kv(i,t,e){return t==null?no:[t,e]}var bA=kv;function SA(i,t,e){return t==null?no:Eu(t,e,Dp,!0)}function zv(i,t,e,n){return t==null?no:Cu(t,e,i.scales[n].log,!1)}var MA=zv;function Hv(i,t,e,n){return t==null?no:Lp(t,e,i.scales[n].log,!1)}var wA=Hv;function EA(i,t,e,n,s){let r=ii(L_(i),L_(t)),a=t-i,o=Wi(s/n*a,e);do{let l=e[o],c=n*l/a;if(c>=s&&r+(l<5?fr.get(l):0)<=17)return[l,c]}while(++o<e.length);return[0,0]}function ev(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Tn((e=+s)*Ie))+"px"),[i,t,e]}function TA(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ve(t[2]*Ie,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function xn(i,t,e){let n={mode:Ae(i.mode,1)},s=n.mode;function r(_,S,R,L){let k=S.valToPct(_);return L+R*(S.dir==-1?1-k:k)}function a(_,S,R,L){let k=S.valToPct(_);return L+R*(S.dir==-1?k:1-k)}function o(_,S,R,L){return S.ori==0?r(_,S,R,L):a(_,S,R,L)}n.valToPosH=r,n.valToPosV=a;let l=!1;n.status=0;let c=n.root=Li(DE);if(i.id!=null&&(c.id=i.id),Si(c,i.class),i.title){let _=Li(FE,c);_.textContent=i.title}let h=Gi("canvas"),f=n.ctx=h.getContext("2d"),u=Li(OE,c);kr("click",u,_=>{_.target===g&&(Xe!=Zr||je!=Kr)&&Nn.click(n,_)},!0);let p=n.under=Li(BE,u);u.appendChild(h);let g=n.over=Li(kE,u);i=io(i);let b=+Ae(i.pxAlign,1),d=J_(b);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,y=n.series=s==1?tv(i.series||[],W_,Z_,!1):yA(i.series||[null],$_),C=n.axes=tv(i.axes||[],G_,q_,!0),w=n.scales={},P=n.bands=i.bands||[];P.forEach(_=>{_.fill=Me(_.fill||null),_.dir=Ae(_.dir,-1)});let T=s==2?y[1].facets[0].scale:y[0].scale,v={axes:ps,series:_e},E=(i.drawOrder||["axes","series"]).map(_=>v[_]);function z(_){let S=_.distr==3?R=>Us(R>0?R:_.clamp(n,R,_.min,_.max,_.key)):_.distr==4?R=>mp(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=S(R),{_min:k,_max:Z}=_,lt=Z-k;return(L-k)/lt}}function U(_){let S=w[_];if(S==null){let R=(i.scales||Rl)[_]||Rl;if(R.from!=null){U(R.from);let L=vn({},w[R.from],R,{key:_});L.valToPct=z(L),w[_]=L}else{S=w[_]=vn({},_==T?Rv:lA,R),S.key=_;let L=S.time,k=S.range,Z=ur(k);if((_!=T||s==2&&!L)&&(Z&&(k[0]==null||k[1]==null)&&(k={min:k[0]==null?R_:{mode:1,hard:k[0],soft:k[0]},max:k[1]==null?R_:{mode:1,hard:k[1],soft:k[1]}},Z=!1),!Z&&Pu(k))){let lt=k;k=(pt,bt,Ut)=>bt==null?no:Eu(bt,Ut,lt)}S.range=Me(k||(L?bA:_==T?S.distr==3?MA:S.distr==4?wA:kv:S.distr==3?zv:S.distr==4?Hv:SA)),S.auto=Me(Z?!1:S.auto),S.clamp=Me(S.clamp||oA),S._min=S._max=null,S.valToPct=z(S)}}}U("x"),U("y"),s==1&&y.forEach(_=>{U(_.scale)}),C.forEach(_=>{U(_.scale)});for(let _ in i.scales)U(_);let N=w[T],W=N.distr,G,D;N.ori==0?(Si(c,NE),G=r,D=a):(Si(c,UE),G=a,D=r);let V={};for(let _ in w){let S=w[_];(S.min!=null||S.max!=null)&&(V[_]={min:S.min,max:S.max},S.min=S.max=null)}let K=i.tzDate||(_=>new Date(Tn(_/m))),H=i.fmtDate||Fp,ht=m==1?NT(K):OT(K),J=z_(K,k_(m==1?DT:FT,H)),Q=V_(K,H_(kT,H)),rt=[],dt=n.legend=vn({},VT,i.legend),ft=n.cursor=vn({},$T,{drag:{y:s==2}},i.cursor),tt=dt.show,gt=ft.show,xt=dt.markers;dt.idxs=rt,xt.width=Me(xt.width),xt.dash=Me(xt.dash),xt.stroke=Me(xt.stroke),xt.fill=Me(xt.fill);let Ct,Mt,Yt,le=[],Xt=[],me,fe=!1,ae={};if(dt.live){let _=y[1]?y[1].values:null;fe=_!=null,me=fe?_(n,1,0):{_:0};for(let S in me)ae[S]=Pp}if(tt)if(Ct=Gi("table",XE,c),Yt=Gi("tbody",null,Ct),dt.mount(n,Ct),fe){Mt=Gi("thead",null,Ct,Yt);let _=Gi("tr",null,Mt);Gi("th",null,_);for(var Je in me)Gi("th",g_,_).textContent=Je}else Si(Ct,YE),dt.live&&Si(Ct,qE);let Ge={show:!0},cn={show:!1};function Oe(_,S){if(S==0&&(fe||!dt.live||s==2))return no;let R=[],L=Gi("tr",$E,Yt,Yt.childNodes[S]);Si(L,_.class),_.show||Si(L,Br);let k=Gi("th",null,L);if(xt.show){let pt=Li(ZE,k);if(S>0){let bt=xt.width(n,S);bt&&(pt.style.border=bt+"px "+xt.dash(n,S)+" "+xt.stroke(n,S)),pt.style.background=xt.fill(n,S)}}let Z=Li(g_,k);_.label instanceof HTMLElement?Z.appendChild(_.label):Z.textContent=_.label,S>0&&(xt.show||(Z.style.color=_.width>0?xt.stroke(n,S):xt.fill(n,S)),we("click",k,pt=>{if(ft._lock)return;te(pt);let bt=y.indexOf(_);if((pt.ctrlKey||pt.metaKey)!=dt.isolate){let Ut=y.some((Ft,Bt)=>Bt>0&&Bt!=bt&&Ft.show);y.forEach((Ft,Bt)=>{Bt>0&&Zi(Bt,Ut?Bt==bt?Ge:cn:Ge,!0,pn.setSeries)})}else Zi(bt,{show:!_.show},!0,pn.setSeries)},!1),ee&&we(y_,k,pt=>{ft._lock||(te(pt),Zi(y.indexOf(_),jr,!0,pn.setSeries))},!1));for(var lt in me){let pt=Gi("td",KE,L);pt.textContent="--",R.push(pt)}return[L,R]}let Cn=new Map;function we(_,S,R,L=!0){let k=Cn.get(S)||{},Z=ft.bind[_](n,S,R,L);Z&&(kr(_,S,k[_]=Z),Cn.set(S,k))}function yn(_,S,R){let L=Cn.get(S)||{};for(let k in L)(_==null||k==_)&&(Sp(k,S,L[k]),delete L[k]);_==null&&Cn.delete(S)}let tn=0,hn=0,O=0,Pt=0,Jt=0,ce=0,wt=Jt,ze=ce,Vt=O,Zt=Pt,A=0,x=0,q=0,ut=0;n.bbox={};let ot=!1,vt=!1,yt=!1,nt=!1,st=!1,mt=!1;function F(_,S,R){(R||_!=n.width||S!=n.height)&&at(_,S),de(!1),yt=!0,vt=!0,Bn()}function at(_,S){n.width=tn=O=_,n.height=hn=Pt=S,Jt=ce=0,St(),qt();let R=n.bbox;A=R.left=Fr(Jt*Ie,.5),x=R.top=Fr(ce*Ie,.5),q=R.width=Fr(O*Ie,.5),ut=R.height=Fr(Pt*Ie,.5)}let it=3;function Et(){let _=!1,S=0;for(;!_;){S++;let R=qr(S),L=$i(S);_=S==it||R&&L,_||(at(n.width,n.height),vt=!0)}}function _t({width:_,height:S}){F(_,S)}n.setSize=_t;function St(){let _=!1,S=!1,R=!1,L=!1;C.forEach((k,Z)=>{if(k.show&&k._show){let{side:lt,_size:pt}=k,bt=lt%2,Ut=k.label!=null?k.labelSize:0,Ft=pt+Ut;Ft>0&&(bt?(O-=Ft,lt==3?(Jt+=Ft,L=!0):R=!0):(Pt-=Ft,lt==0?(ce+=Ft,_=!0):S=!0))}}),qi[0]=_,qi[1]=R,qi[2]=S,qi[3]=L,O-=Ni[1]+Ni[3],Jt+=Ni[3],Pt-=Ni[2]+Ni[0],ce+=Ni[0]}function qt(){let _=Jt+O,S=ce+Pt,R=Jt,L=ce;function k(Z,lt){switch(Z){case 1:return _+=lt,_-lt;case 2:return S+=lt,S-lt;case 3:return R-=lt,R+lt;case 0:return L-=lt,L+lt}}C.forEach((Z,lt)=>{if(Z.show&&Z._show){let pt=Z.side;Z._pos=k(pt,Z._size),Z.label!=null&&(Z._lpos=k(pt,Z.labelSize))}})}if(ft.dataIdx==null){let _=ft.hover,S=_.skip=new Set(_.skip??[]);S.add(void 0);let R=_.prox=Me(_.prox),L=_.bias??=0;ft.dataIdx=(k,Z,lt,pt)=>{if(Z==0)return lt;let bt=lt,Ut=R(k,Z,lt,pt)??He,Ft=Ut>=0&&Ut<He,Bt=N.ori==0?O:Pt,oe=ft.left,Ce=t[0],Ee=t[Z];if(S.has(Ee[lt])){bt=null;let xe=null,jt=null,$t;if(L==0||L==-1)for($t=lt;xe==null&&$t-- >0;)S.has(Ee[$t])||(xe=$t);if(L==0||L==1)for($t=lt;jt==null&&$t++<Ee.length;)S.has(Ee[$t])||(jt=$t);if(xe!=null||jt!=null)if(Ft){let Ye=xe==null?-1/0:G(Ce[xe],N,Bt,0),sn=jt==null?1/0:G(Ce[jt],N,Bt,0),Ln=oe-Ye,Be=sn-oe;Ln<=Be?Ln<=Ut&&(bt=xe):Be<=Ut&&(bt=jt)}else bt=jt==null?xe:xe==null?jt:lt-xe<=jt-lt?xe:jt}else Ft&&An(oe-G(Ce[lt],N,Bt,0))>Ut&&(bt=null);return bt}}let te=_=>{ft.event=_};ft.idxs=rt,ft._lock=!1;let ct=ft.points;ct.show=Me(ct.show),ct.size=Me(ct.size),ct.stroke=Me(ct.stroke),ct.width=Me(ct.width),ct.fill=Me(ct.fill);let kt=n.focus=vn({},i.focus||{alpha:.3},ft.focus),ee=kt.prox>=0,Rt=ee&&ct.one,ue=[],We=[],Wn=[];function co(_,S){let R=ct.show(n,S);if(R instanceof HTMLElement)return Si(R,WE),Si(R,_.class),hs(R,-10,-10,O,Pt),g.insertBefore(R,ue[S]),R}function Gr(_,S){if(s==1||S>0){let R=s==1&&w[_.scale].time,L=_.value;_.value=R?U_(L)?V_(K,H_(L,H)):L||Q:L||sA,_.label=_.label||(R?KT:ZT)}if(Rt||S>0){_.width=_.width==null?1:_.width,_.paths=_.paths||vA||lT,_.fillTo=Me(_.fillTo||cA),_.pxAlign=+Ae(_.pxAlign,b),_.pxRound=J_(_.pxAlign),_.stroke=Me(_.stroke||null),_.fill=Me(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=rA(ii(1,_.width),1),L=_.points=vn({},{size:R,width:ii(1,R*.2),stroke:_.stroke,space:R*2,paths:xA,_stroke:null,_fill:null},_.points);L.show=Me(L.show),L.filter=Me(L.filter),L.fill=Me(L.fill),L.stroke=Me(L.stroke),L.paths=Me(L.paths),L.pxAlign=_.pxAlign}if(tt){let R=Oe(_,S);le.splice(S,0,R[0]),Xt.splice(S,0,R[1]),dt.values.push(null)}if(gt){rt.splice(S,0,null);let R=null;Rt?S==0&&(R=co(_,S)):S>0&&(R=co(_,S)),ue.splice(S,0,R),We.splice(S,0,0),Wn.splice(S,0,0)}In("addSeries",S)}function zu(_,S){S=S??y.length,_=s==1?Cp(_,S,W_,Z_):Cp(_,S,{},$_),y.splice(S,0,_),Gr(y[S],S)}n.addSeries=zu;function Nl(_){if(y.splice(_,1),tt){dt.values.splice(_,1),Xt.splice(_,1);let S=le.splice(_,1)[0];yn(null,S.firstChild),S.remove()}gt&&(rt.splice(_,1),ue.splice(_,1)[0].remove(),We.splice(_,1),Wn.splice(_,1)),In("delSeries",_)}n.delSeries=Nl;let qi=[!1,!1,!1,!1];function us(_,S){if(_._show=_.show,_.show){let R=_.side%2,L=w[_.scale];L==null&&(_.scale=R?y[1].scale:T,L=w[_.scale]);let k=L.time;_.size=Me(_.size),_.space=Me(_.space),_.rotate=Me(_.rotate),ur(_.incrs)&&_.incrs.forEach(lt=>{!fr.has(lt)&&fr.set(lt,hv(lt))}),_.incrs=Me(_.incrs||(L.distr==2?PT:k?m==1?LT:UT:Or)),_.splits=Me(_.splits||(k&&L.distr==1?ht:L.distr==3?wp:L.distr==4?QT:jT)),_.stroke=Me(_.stroke),_.grid.stroke=Me(_.grid.stroke),_.ticks.stroke=Me(_.ticks.stroke),_.border.stroke=Me(_.border.stroke);let Z=_.values;_.values=ur(Z)&&!ur(Z[0])?Me(Z):k?ur(Z)?z_(K,k_(Z,H)):U_(Z)?BT(K,Z):Z||J:Z||JT,_.filter=Me(_.filter||(L.distr>=3&&L.log==10?nA:L.distr==3&&L.log==2?iA:lv)),_.font=ev(_.font),_.labelFont=ev(_.labelFont),_._size=_.size(n,null,S,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(qi[S]=!0,_._el=Li(zE,u))}}function fs(_,S,R,L){let[k,Z,lt,pt]=R,bt=S%2,Ut=0;return bt==0&&(pt||Z)&&(Ut=S==0&&!k||S==2&&!lt?Tn(G_.size/3):0),bt==1&&(k||lt)&&(Ut=S==1&&!Z||S==3&&!pt?Tn(q_.size/2):0),Ut}let ho=n.padding=(i.padding||[fs,fs,fs,fs]).map(_=>Me(Ae(_,fs))),Ni=n._padding=ho.map((_,S)=>_(n,S,qi,0)),en,an=null,on=null,Yi=s==1?y[0].idxs:null,oi=null,Os=!1;function uo(_,S){if(t=_??[],n.data=n._data=t,s==2){en=0;for(let R=1;R<y.length;R++)en+=t[R][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),oi=t[0],en=oi.length;let R=t;if(W==2){R=t.slice();let L=R[0]=Array(en);for(let k=0;k<en;k++)L[k]=k}n._data=t=R}if(de(!0),In("setData"),W==2&&(yt=!0),S!==!1){let R=N;R.auto(n,Os)?fo():zs(T,R.min,R.max),nt=nt||ft.left>=0,mt=!0,Bn()}}n.setData=uo;function fo(){Os=!0;let _,S;s==1&&(en>0?(an=Yi[0]=0,on=Yi[1]=en-1,_=t[0][an],S=t[0][on],W==2?(_=an,S=on):_==S&&(W==3?[_,S]=Cu(_,_,N.log,!1):W==4?[_,S]=Lp(_,_,N.log,!1):N.time?S=_+Tn(86400/m):[_,S]=Eu(_,S,Dp,!0))):(an=Yi[0]=_=null,on=Yi[1]=S=null)),zs(T,_,S)}let Wr,Bs,Xr,M,B,j,Y,$,Tt,It;function At(_,S,R,L,k,Z){_??=v_,R??=Up,L??="butt",k??=v_,Z??="round",_!=Wr&&(f.strokeStyle=Wr=_),k!=Bs&&(f.fillStyle=Bs=k),S!=Xr&&(f.lineWidth=Xr=S),Z!=B&&(f.lineJoin=B=Z),L!=j&&(f.lineCap=j=L),R!=M&&f.setLineDash(M=R)}function Lt(_,S,R,L){S!=Bs&&(f.fillStyle=Bs=S),_!=Y&&(f.font=Y=_),R!=$&&(f.textAlign=$=R),L!=Tt&&(f.textBaseline=Tt=L)}function Ht(_,S,R,L,k=0){if(L.length>0&&_.auto(n,Os)&&(S==null||S.min==null)){let Z=Ae(an,0),lt=Ae(on,L.length-1),pt=R.min==null?nT(L,Z,lt,k,_.distr==3):[R.min,R.max];_.min=Xi(_.min,R.min=pt[0]),_.max=ii(_.max,R.max=pt[1])}}let se={min:null,max:null};function ge(){for(let L in w){let k=w[L];V[L]==null&&(k.min==null||V[T]!=null&&k.auto(n,Os))&&(V[L]=se)}for(let L in w){let k=w[L];V[L]==null&&k.from!=null&&V[k.from]!=null&&(V[L]=se)}V[T]!=null&&de(!0);let _={};for(let L in V){let k=V[L];if(k!=null){let Z=_[L]=io(w[L],uT);if(k.min!=null)vn(Z,k);else if(L!=T||s==2)if(en==0&&Z.from==null){let lt=Z.range(n,null,null,L);Z.min=lt[0],Z.max=lt[1]}else Z.min=He,Z.max=-He}}if(en>0){y.forEach((L,k)=>{if(s==1){let Z=L.scale,lt=V[Z];if(lt==null)return;let pt=_[Z];if(k==0){let bt=pt.range(n,pt.min,pt.max,Z);pt.min=bt[0],pt.max=bt[1],an=Wi(pt.min,t[0]),on=Wi(pt.max,t[0]),on-an>1&&(t[0][an]<pt.min&&an++,t[0][on]>pt.max&&on--),L.min=oi[an],L.max=oi[on]}else L.show&&L.auto&&Ht(pt,lt,L,t[k],L.sorted);L.idxs[0]=an,L.idxs[1]=on}else if(k>0&&L.show&&L.auto){let[Z,lt]=L.facets,pt=Z.scale,bt=lt.scale,[Ut,Ft]=t[k],Bt=_[pt],oe=_[bt];Bt!=null&&Ht(Bt,V[pt],Z,Ut,Z.sorted),oe!=null&&Ht(oe,V[bt],lt,Ft,lt.sorted),L.min=lt.min,L.max=lt.max}});for(let L in _){let k=_[L],Z=V[L];if(k.from==null&&(Z==null||Z.min==null)){let lt=k.range(n,k.min==He?null:k.min,k.max==-He?null:k.max,L);k.min=lt[0],k.max=lt[1]}}}for(let L in _){let k=_[L];if(k.from!=null){let Z=_[k.from];if(Z.min==null)k.min=k.max=null;else{let lt=k.range(n,Z.min,Z.max,L);k.min=lt[0],k.max=lt[1]}}}let S={},R=!1;for(let L in _){let k=_[L],Z=w[L];if(Z.min!=k.min||Z.max!=k.max){Z.min=k.min,Z.max=k.max;let lt=Z.distr;Z._min=lt==3?Us(Z.min):lt==4?mp(Z.min,Z.asinh):lt==100?Z.fwd(Z.min):Z.min,Z._max=lt==3?Us(Z.max):lt==4?mp(Z.max,Z.asinh):lt==100?Z.fwd(Z.max):Z.max,S[L]=R=!0}}if(R){y.forEach((L,k)=>{s==2?k>0&&S.y&&(L._paths=null):S[L.scale]&&(L._paths=null)});for(let L in S)yt=!0,In("setScale",L);gt&&ft.left>=0&&(nt=mt=!0)}for(let L in V)V[L]=null}function zt(_){let S=Mp(an-1,0,en-1),R=Mp(on+1,0,en-1);for(;_[S]==null&&S>0;)S--;for(;_[R]==null&&R<en-1;)R++;return[S,R]}function _e(){if(en>0){let _=y.some(S=>S._focus)&&It!=kt.alpha;_&&(f.globalAlpha=It=kt.alpha),y.forEach((S,R)=>{if(R>0&&S.show&&(Qe(R,!1),Qe(R,!0),S._paths==null)){let L=It;It!=S.alpha&&(f.globalAlpha=It=S.alpha);let k=s==2?[0,t[R][0].length-1]:zt(t[R]);S._paths=S.paths(n,R,k[0],k[1]),It!=L&&(f.globalAlpha=It=L)}}),y.forEach((S,R)=>{if(R>0&&S.show){let L=It;It!=S.alpha&&(f.globalAlpha=It=S.alpha),S._paths!=null&&Ne(R,!1);{let k=S._paths!=null?S._paths.gaps:null,Z=S.points.show(n,R,an,on,k),lt=S.points.filter(n,R,Z,k);(Z||lt)&&(S.points._paths=S.points.paths(n,R,an,on,lt),Ne(R,!0))}It!=L&&(f.globalAlpha=It=L),In("drawSeries",R)}}),_&&(f.globalAlpha=It=1)}}function Qe(_,S){let R=S?y[_].points:y[_];R._stroke=R.stroke(n,_),R._fill=R.fill(n,_)}function Ne(_,S){let R=S?y[_].points:y[_],{stroke:L,fill:k,clip:Z,flags:lt,_stroke:pt=R._stroke,_fill:bt=R._fill,_width:Ut=R.width}=R._paths;Ut=Ve(Ut*Ie,3);let Ft=null,Bt=Ut%2/2;S&&bt==null&&(bt=Ut>0?"#fff":pt);let oe=R.pxAlign==1&&Bt>0;if(oe&&f.translate(Bt,Bt),!S){let Ce=A-Ut/2,Ee=x-Ut/2,xe=q+Ut,jt=ut+Ut;Ft=new Path2D,Ft.rect(Ce,Ee,xe,jt)}S?Ot(pt,Ut,R.dash,R.cap,bt,L,k,lt,Z):Ue(_,pt,Ut,R.dash,R.cap,bt,L,k,lt,Ft,Z),oe&&f.translate(-Bt,-Bt)}function Ue(_,S,R,L,k,Z,lt,pt,bt,Ut,Ft){let Bt=!1;bt!=0&&P.forEach((oe,Ce)=>{if(oe.series[0]==_){let Ee=y[oe.series[1]],xe=t[oe.series[1]],jt=(Ee._paths||Rl).band;ur(jt)&&(jt=oe.dir==1?jt[0]:jt[1]);let $t,Ye=null;Ee.show&&jt&&sT(xe,an,on)?(Ye=oe.fill(n,Ce)||Z,$t=Ee._paths.clip):jt=null,Ot(S,R,L,k,Ye,lt,pt,bt,Ut,Ft,$t,jt),Bt=!0}}),Bt||Ot(S,R,L,k,Z,lt,pt,bt,Ut,Ft)}let bn=so|Tp;function Ot(_,S,R,L,k,Z,lt,pt,bt,Ut,Ft,Bt){At(_,S,R,L,k),(bt||Ut||Bt)&&(f.save(),bt&&f.clip(bt),Ut&&f.clip(Ut)),Bt?(pt&bn)==bn?(f.clip(Bt),Ft&&f.clip(Ft),ye(k,lt),un(_,Z,S)):pt&Tp?(ye(k,lt),f.clip(Bt),un(_,Z,S)):pt&so&&(f.save(),f.clip(Bt),Ft&&f.clip(Ft),ye(k,lt),f.restore(),un(_,Z,S)):(ye(k,lt),un(_,Z,S)),(bt||Ut||Bt)&&f.restore()}function un(_,S,R){R>0&&(S instanceof Map?S.forEach((L,k)=>{f.strokeStyle=Wr=k,f.stroke(L)}):S!=null&&_&&f.stroke(S))}function ye(_,S){S instanceof Map?S.forEach((R,L)=>{f.fillStyle=Bs=L,f.fill(R)}):S!=null&&_&&f.fill(S)}function ds(_,S,R,L){let k=C[_],Z;if(L<=0)Z=[0,0];else{let lt=k._space=k.space(n,_,S,R,L),pt=k._incrs=k.incrs(n,_,S,R,L,lt);Z=EA(S,R,pt,L,lt)}return k._found=Z}function fn(_,S,R,L,k,Z,lt,pt,bt,Ut){let Ft=lt%2/2;b==1&&f.translate(Ft,Ft),At(pt,lt,bt,Ut,pt),f.beginPath();let Bt,oe,Ce,Ee,xe=k+(L==0||L==3?-Z:Z);R==0?(oe=k,Ee=xe):(Bt=k,Ce=xe);for(let jt=0;jt<_.length;jt++)S[jt]!=null&&(R==0?Bt=Ce=_[jt]:oe=Ee=_[jt],f.moveTo(Bt,oe),f.lineTo(Ce,Ee));f.stroke(),b==1&&f.translate(-Ft,-Ft)}function qr(_){let S=!0;return C.forEach((R,L)=>{if(!R.show)return;let k=w[R.scale];if(k.min==null){R._show&&(S=!1,R._show=!1,de(!1));return}else R._show||(S=!1,R._show=!0,de(!1));let Z=R.side,lt=Z%2,{min:pt,max:bt}=k,[Ut,Ft]=ds(L,pt,bt,lt==0?O:Pt);if(Ft==0)return;let Bt=k.distr==2,oe=R._splits=R.splits(n,L,pt,bt,Ut,Ft,Bt),Ce=k.distr==2?oe.map($t=>oi[$t]):oe,Ee=k.distr==2?oi[oe[1]]-oi[oe[0]]:Ut,xe=R._values=R.values(n,R.filter(n,Ce,L,Ft,Ee),L,Ft,Ee);R._rotate=Z==2?R.rotate(n,xe,L,Ft):0;let jt=R._size;R._size=Di(R.size(n,xe,L,_)),jt!=null&&R._size!=jt&&(S=!1)}),S}function $i(_){let S=!0;return ho.forEach((R,L)=>{let k=R(n,L,qi,_);k!=Ni[L]&&(S=!1),Ni[L]=k}),S}function ps(){for(let _=0;_<C.length;_++){let S=C[_];if(!S.show||!S._show)continue;let R=S.side,L=R%2,k,Z,lt=S.stroke(n,_),pt=R==0||R==3?-1:1,[bt,Ut]=S._found;if(S.label!=null){let Yn=S.labelGap*pt,hi=Tn((S._lpos+Yn)*Ie);Lt(S.labelFont[0],lt,"center",R==2?"top":__),f.save(),L==1?(k=Z=0,f.translate(hi,Tn(x+ut/2)),f.rotate((R==3?-Mu:Mu)/2)):(k=Tn(A+q/2),Z=hi);let mr=av(S.label)?S.label(n,_,bt,Ut):S.label;f.fillText(mr,k,Z),f.restore()}if(Ut==0)continue;let Ft=w[S.scale],Bt=L==0?q:ut,oe=L==0?A:x,Ce=S._splits,Ee=Ft.distr==2?Ce.map(Yn=>oi[Yn]):Ce,xe=Ft.distr==2?oi[Ce[1]]-oi[Ce[0]]:bt,jt=S.ticks,$t=S.border,Ye=jt.show?jt.size:0,sn=Tn(Ye*Ie),Ln=Tn((S.alignTo==2?S._size-Ye-S.gap:S.gap)*Ie),Be=S._rotate*-Mu/180,rn=d(S._pos*Ie),li=(sn+Ln)*pt,qn=rn+li;Z=L==0?qn:0,k=L==1?qn:0;let Ei=S.font[0],Ui=S.align==1?ja:S.align==2?fp:Be>0?ja:Be<0?fp:L==0?"center":R==3?fp:ja,Ji=Be||L==1?"middle":R==2?"top":__;Lt(Ei,lt,Ui,Ji);let ci=S.font[1]*S.lineGap,Ti=Ce.map(Yn=>d(o(Yn,Ft,Bt,oe))),Fi=S._values;for(let Yn=0;Yn<Fi.length;Yn++){let hi=Fi[Yn];if(hi!=null){L==0?k=Ti[Yn]:Z=Ti[Yn],hi=""+hi;let mr=hi.indexOf(`
`)==-1?[hi]:hi.split(/\n/gm);for(let $n=0;$n<mr.length;$n++){let cm=mr[$n];Be?(f.save(),f.translate(k,Z+$n*ci),f.rotate(Be),f.fillText(cm,0,0),f.restore()):f.fillText(cm,k,Z+$n*ci)}}}jt.show&&fn(Ti,jt.filter(n,Ee,_,Ut,xe),L,R,rn,sn,Ve(jt.width*Ie,3),jt.stroke(n,_),jt.dash,jt.cap);let ji=S.grid;ji.show&&fn(Ti,ji.filter(n,Ee,_,Ut,xe),L,L==0?2:1,L==0?x:A,L==0?ut:q,Ve(ji.width*Ie,3),ji.stroke(n,_),ji.dash,ji.cap),$t.show&&fn([rn],[1],L==0?1:0,L==0?1:2,L==1?x:A,L==1?ut:q,Ve($t.width*Ie,3),$t.stroke(n,_),$t.dash,$t.cap)}In("drawAxes")}function de(_){y.forEach((S,R)=>{R>0&&(S._paths=null,_&&(s==1?(S.min=null,S.max=null):S.facets.forEach(L=>{L.min=null,L.max=null})))})}let nn=!1,Xn=!1,Fe=[];function dn(){Xn=!1;for(let _=0;_<Fe.length;_++)In(...Fe[_]);Fe.length=0}function Bn(){nn||(vT(Xp),nn=!0)}function Ul(_,S=!1){nn=!0,Xn=S,_(n),Xp(),S&&Fe.length>0&&queueMicrotask(dn)}n.batch=Ul;function Xp(){if(ot&&(ge(),ot=!1),yt&&(Et(),yt=!1),vt){if(Ke(p,ja,Jt),Ke(p,"top",ce),Ke(p,El,O),Ke(p,Tl,Pt),Ke(g,ja,Jt),Ke(g,"top",ce),Ke(g,El,O),Ke(g,Tl,Pt),Ke(u,El,tn),Ke(u,Tl,hn),h.width=Tn(tn*Ie),h.height=Tn(hn*Ie),C.forEach(({_el:_,_show:S,_size:R,_pos:L,side:k})=>{if(_!=null)if(S){let Z=k===3||k===0?R:0,lt=k%2==1;Ke(_,lt?"left":"top",L-Z),Ke(_,lt?"width":"height",R),Ke(_,lt?"top":"left",lt?ce:Jt),Ke(_,lt?"height":"width",lt?Pt:O),bp(_,Br)}else Si(_,Br)}),Wr=Bs=Xr=B=j=Y=$=Tt=M=null,It=1,go(!0),Jt!=wt||ce!=ze||O!=Vt||Pt!=Zt){de(!1);let _=O/Vt,S=Pt/Zt;if(gt&&!nt&&ft.left>=0){ft.left*=_,ft.top*=S,Yr&&hs(Yr,Tn(ft.left),0,O,Pt),$r&&hs($r,0,Tn(ft.top),O,Pt);for(let R=0;R<ue.length;R++){let L=ue[R];L!=null&&(We[R]*=_,Wn[R]*=S,hs(L,Di(We[R]),Di(Wn[R]),O,Pt))}}if(qe.show&&!st&&qe.left>=0&&qe.width>0){qe.left*=_,qe.width*=_,qe.top*=S,qe.height*=S;for(let R in qu)Ke(Jr,R,qe[R])}wt=Jt,ze=ce,Vt=O,Zt=Pt}In("setSize"),vt=!1}tn>0&&hn>0&&(f.clearRect(0,0,h.width,h.height),In("drawClear"),E.forEach(_=>_()),In("draw")),qe.show&&st&&(Fl(qe),st=!1),gt&&nt&&(pr(null,!0,!1),nt=!1),dt.show&&dt.live&&mt&&(Wu(),mt=!1),l||(l=!0,n.status=1,In("ready")),Os=!1,nn=!1}n.redraw=(_,S)=>{yt=S||!1,_!==!1?zs(T,N.min,N.max):Bn()};function Hu(_,S){let R=w[_];if(R.from==null){if(en==0){let L=R.range(n,S.min,S.max,_);S.min=L[0],S.max=L[1]}if(S.min>S.max){let L=S.min;S.min=S.max,S.max=L}if(en>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;_==T&&R.distr==2&&en>0&&(S.min=Wi(S.min,t[0]),S.max=Wi(S.max,t[0]),S.min==S.max&&S.max++),V[_]=S,ot=!0,Bn()}}n.setScale=Hu;let Vu,Gu,Yr,$r,qp,Yp,Zr,Kr,$p,Zp,Xe,je,ks=!1,Nn=ft.drag,Rn=Nn.x,Pn=Nn.y;gt&&(ft.x&&(Vu=Li(VE,g)),ft.y&&(Gu=Li(GE,g)),N.ori==0?(Yr=Vu,$r=Gu):(Yr=Gu,$r=Vu),Xe=ft.left,je=ft.top);let qe=n.select=vn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Jr=qe.show?Li(HE,qe.over?g:p):null;function Fl(_,S){if(qe.show){for(let R in _)qe[R]=_[R],R in qu&&Ke(Jr,R,_[R]);S!==!1&&In("setSelect")}}n.setSelect=Fl;function cx(_){if(y[_].show)tt&&bp(le[_],Br);else if(tt&&Si(le[_],Br),gt){let R=Rt?ue[0]:ue[_];R!=null&&hs(R,-10,-10,O,Pt)}}function zs(_,S,R){Hu(_,{min:S,max:R})}function Zi(_,S,R,L){S.focus!=null&&px(_),S.show!=null&&y.forEach((k,Z)=>{Z>0&&(_==Z||_==null)&&(k.show=S.show,cx(Z),s==2?(zs(k.facets[0].scale,null,null),zs(k.facets[1].scale,null,null)):zs(k.scale,null,null),Bn())}),R!==!1&&In("setSeries",_,S),L&&_o("setSeries",n,_,S)}n.setSeries=Zi;function hx(_,S){vn(P[_],S)}function ux(_,S){_.fill=Me(_.fill||null),_.dir=Ae(_.dir,-1),S=S??P.length,P.splice(S,0,_)}function fx(_){_==null?P.length=0:P.splice(_,1)}n.addBand=ux,n.setBand=hx,n.delBand=fx;function dx(_,S){y[_].alpha=S,gt&&ue[_]!=null&&(ue[_].style.opacity=S),tt&&le[_]&&(le[_].style.opacity=S)}let ms,Hs,dr,jr={focus:!0};function px(_){if(_!=dr){let S=_==null,R=kt.alpha!=1;y.forEach((L,k)=>{if(s==1||k>0){let Z=S||k==0||k==_;L._focus=S?null:Z,R&&dx(k,Z?1:kt.alpha)}}),dr=_,R&&Bn()}}tt&&ee&&we(b_,Ct,_=>{ft._lock||(te(_),dr!=null&&Zi(null,jr,!0,pn.setSeries))});function Ki(_,S,R){let L=w[S];R&&(_=_/Ie-(L.ori==1?ce:Jt));let k=O;L.ori==1&&(k=Pt,_=k-_),L.dir==-1&&(_=k-_);let Z=L._min,lt=L._max,pt=_/k,bt=Z+(lt-Z)*pt,Ut=L.distr;return Ut==3?eo(10,bt):Ut==4?aT(bt,L.asinh):Ut==100?L.bwd(bt):bt}function mx(_,S){let R=Ki(_,T,S);return Wi(R,t[0],an,on)}n.valToIdx=_=>Wi(_,t[0]),n.posToIdx=mx,n.posToVal=Ki,n.valToPos=(_,S,R)=>w[S].ori==0?r(_,w[S],R?q:O,R?A:0):a(_,w[S],R?ut:Pt,R?x:0),n.setCursor=(_,S,R)=>{Xe=_.left,je=_.top,pr(null,S,R)};function Kp(_,S){Ke(Jr,ja,qe.left=_),Ke(Jr,El,qe.width=S)}function Jp(_,S){Ke(Jr,"top",qe.top=_),Ke(Jr,Tl,qe.height=S)}let po=N.ori==0?Kp:Jp,mo=N.ori==1?Kp:Jp;function gx(){if(tt&&dt.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&fe)continue;let S=dt.values[_],R=0;for(let L in S)Xt[_][R++].firstChild.nodeValue=S[L]}}function Wu(_,S){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{rt[L]=R}):hT(_.idx)||rt.fill(_.idx),dt.idx=rt[0]),tt&&dt.live){for(let R=0;R<y.length;R++)(R>0||s==1&&!fe)&&_x(R,rt[R]);gx()}mt=!1,S!==!1&&In("setLegend")}n.setLegend=Wu;function _x(_,S){let R=y[_],L=_==0&&W==2?oi:t[_],k;fe?k=R.values(n,_,S)??ae:(k=R.value(n,S==null?null:L[S],_,S),k=k==null?ae:{_:k}),dt.values[_]=k}function pr(_,S,R){$p=Xe,Zp=je,[Xe,je]=ft.move(n,Xe,je),ft.left=Xe,ft.top=je,gt&&(Yr&&hs(Yr,Tn(Xe),0,O,Pt),$r&&hs($r,0,Tn(je),O,Pt));let L,k=an>on;ms=He,Hs=null;let Z=N.ori==0?O:Pt,lt=N.ori==1?O:Pt;if(Xe<0||en==0||k){L=ft.idx=null;for(let pt=0;pt<y.length;pt++){let bt=ue[pt];bt!=null&&hs(bt,-10,-10,O,Pt)}ee&&Zi(null,jr,!0,_==null&&pn.setSeries),dt.live&&(rt.fill(L),mt=!0)}else{let pt,bt,Ut;s==1&&(pt=N.ori==0?Xe:je,bt=Ki(pt,T),L=ft.idx=Wi(bt,t[0],an,on),Ut=G(t[0][L],N,Z,0));let Ft=-10,Bt=-10,oe=0,Ce=0,Ee=!0,xe="",jt="";for(let $t=s==2?1:0;$t<y.length;$t++){let Ye=y[$t],sn=rt[$t],Ln=sn==null?null:s==1?t[$t][sn]:t[$t][1][sn],Be=ft.dataIdx(n,$t,L,bt),rn=Be==null?null:s==1?t[$t][Be]:t[$t][1][Be];if(mt=mt||rn!=Ln||Be!=sn,rt[$t]=Be,$t>0&&Ye.show){let li=Be==null?-10:Be==L?Ut:G(s==1?t[0][Be]:t[$t][0][Be],N,Z,0),qn=rn==null?-10:D(rn,s==1?w[Ye.scale]:w[Ye.facets[1].scale],lt,0);if(ee&&rn!=null){let Ei=N.ori==1?Xe:je,Ui=An(kt.dist(n,$t,Be,qn,Ei));if(Ui<ms){let Ji=kt.bias;if(Ji!=0){let ci=Ki(Ei,Ye.scale),Ti=rn>=0?1:-1,Fi=ci>=0?1:-1;Fi==Ti&&(Fi==1?Ji==1?rn>=ci:rn<=ci:Ji==1?rn<=ci:rn>=ci)&&(ms=Ui,Hs=$t)}else ms=Ui,Hs=$t}}if(mt||Rt){let Ei,Ui;N.ori==0?(Ei=li,Ui=qn):(Ei=qn,Ui=li);let Ji,ci,Ti,Fi,ji,Yn,hi=!0,mr=ct.bbox;if(mr!=null){hi=!1;let $n=mr(n,$t);Ti=$n.left,Fi=$n.top,Ji=$n.width,ci=$n.height}else Ti=Ei,Fi=Ui,Ji=ci=ct.size(n,$t);if(Yn=ct.fill(n,$t),ji=ct.stroke(n,$t),Rt)$t==Hs&&ms<=kt.prox&&(Ft=Ti,Bt=Fi,oe=Ji,Ce=ci,Ee=hi,xe=Yn,jt=ji);else{let $n=ue[$t];$n!=null&&(We[$t]=Ti,Wn[$t]=Fi,C_($n,Ji,ci,hi),T_($n,Yn,ji),hs($n,Di(Ti),Di(Fi),O,Pt))}}}}if(Rt){let $t=kt.prox,Ye=dr==null?ms<=$t:ms>$t||Hs!=dr;if(mt||Ye){let sn=ue[0];sn!=null&&(We[0]=Ft,Wn[0]=Bt,C_(sn,oe,Ce,Ee),T_(sn,xe,jt),hs(sn,Di(Ft),Di(Bt),O,Pt))}}}if(qe.show&&ks)if(_!=null){let[pt,bt]=pn.scales,[Ut,Ft]=pn.match,[Bt,oe]=_.cursor.sync.scales,Ce=_.cursor.drag;if(Rn=Ce._x,Pn=Ce._y,Rn||Pn){let{left:Ee,top:xe,width:jt,height:$t}=_.select,Ye=_.scales[Bt].ori,sn=_.posToVal,Ln,Be,rn,li,qn,Ei=pt!=null&&Ut(pt,Bt),Ui=bt!=null&&Ft(bt,oe);Ei&&Rn?(Ye==0?(Ln=Ee,Be=jt):(Ln=xe,Be=$t),rn=w[pt],li=G(sn(Ln,Bt),rn,Z,0),qn=G(sn(Ln+Be,Bt),rn,Z,0),po(Xi(li,qn),An(qn-li))):po(0,Z),Ui&&Pn?(Ye==1?(Ln=Ee,Be=jt):(Ln=xe,Be=$t),rn=w[bt],li=D(sn(Ln,oe),rn,lt,0),qn=D(sn(Ln+Be,oe),rn,lt,0),mo(Xi(li,qn),An(qn-li))):mo(0,lt)}else Yu()}else{let pt=An($p-qp),bt=An(Zp-Yp);if(N.ori==1){let oe=pt;pt=bt,bt=oe}Rn=Nn.x&&pt>=Nn.dist,Pn=Nn.y&&bt>=Nn.dist;let Ut=Nn.uni;Ut!=null?Rn&&Pn&&(Rn=pt>=Ut,Pn=bt>=Ut,!Rn&&!Pn&&(bt>pt?Pn=!0:Rn=!0)):Nn.x&&Nn.y&&(Rn||Pn)&&(Rn=Pn=!0);let Ft,Bt;Rn&&(N.ori==0?(Ft=Zr,Bt=Xe):(Ft=Kr,Bt=je),po(Xi(Ft,Bt),An(Bt-Ft)),Pn||mo(0,lt)),Pn&&(N.ori==1?(Ft=Zr,Bt=Xe):(Ft=Kr,Bt=je),mo(Xi(Ft,Bt),An(Bt-Ft)),Rn||po(0,Z)),!Rn&&!Pn&&(po(0,0),mo(0,0))}if(Nn._x=Rn,Nn._y=Pn,_==null){if(R){if(lm!=null){let[pt,bt]=pn.scales;pn.values[0]=pt!=null?Ki(N.ori==0?Xe:je,pt):null,pn.values[1]=bt!=null?Ki(N.ori==1?Xe:je,bt):null}_o(dp,n,Xe,je,O,Pt,L)}if(ee){let pt=R&&pn.setSeries,bt=kt.prox;dr==null?ms<=bt&&Zi(Hs,jr,!0,pt):ms>bt?Zi(null,jr,!0,pt):Hs!=dr&&Zi(Hs,jr,!0,pt)}}mt&&(dt.idx=L,Wu()),S!==!1&&In("setCursor")}let Vs=null;Object.defineProperty(n,"rect",{get(){return Vs==null&&go(!1),Vs}});function go(_=!1){_?Vs=null:(Vs=g.getBoundingClientRect(),In("syncRect",Vs))}function jp(_,S,R,L,k,Z,lt){ft._lock||ks&&_!=null&&_.movementX==0&&_.movementY==0||(Xu(_,S,R,L,k,Z,lt,!1,_!=null),_!=null?pr(null,!0,!0):pr(S,!0,!1))}function Xu(_,S,R,L,k,Z,lt,pt,bt){if(Vs==null&&go(!1),te(_),_!=null)R=_.clientX-Vs.left,L=_.clientY-Vs.top;else{if(R<0||L<0){Xe=-10,je=-10;return}let[Ut,Ft]=pn.scales,Bt=S.cursor.sync,[oe,Ce]=Bt.values,[Ee,xe]=Bt.scales,[jt,$t]=pn.match,Ye=S.axes[0].side%2==1,sn=N.ori==0?O:Pt,Ln=N.ori==1?O:Pt,Be=Ye?Z:k,rn=Ye?k:Z,li=Ye?L:R,qn=Ye?R:L;if(Ee!=null?R=jt(Ut,Ee)?o(oe,w[Ut],sn,0):-10:R=sn*(li/Be),xe!=null?L=$t(Ft,xe)?o(Ce,w[Ft],Ln,0):-10:L=Ln*(qn/rn),N.ori==1){let Ei=R;R=L,L=Ei}}bt&&(S==null||S.cursor.event.type==dp)&&((R<=1||R>=O-1)&&(R=Fr(R,O)),(L<=1||L>=Pt-1)&&(L=Fr(L,Pt))),pt?(qp=R,Yp=L,[Zr,Kr]=ft.move(n,R,L)):(Xe=R,je=L)}let qu={width:0,height:0,left:0,top:0};function Yu(){Fl(qu,!1)}let Qp,tm,em,nm;function im(_,S,R,L,k,Z,lt){ks=!0,Rn=Pn=Nn._x=Nn._y=!1,Xu(_,S,R,L,k,Z,lt,!0,!1),_!=null&&(we(pp,xp,sm,!1),_o(x_,n,Zr,Kr,O,Pt,null));let{left:pt,top:bt,width:Ut,height:Ft}=qe;Qp=pt,tm=bt,em=Ut,nm=Ft}function sm(_,S,R,L,k,Z,lt){ks=Nn._x=Nn._y=!1,Xu(_,S,R,L,k,Z,lt,!1,!0);let{left:pt,top:bt,width:Ut,height:Ft}=qe,Bt=Ut>0||Ft>0,oe=Qp!=pt||tm!=bt||em!=Ut||nm!=Ft;if(Bt&&oe&&Fl(qe),Nn.setScale&&Bt&&oe){let Ce=pt,Ee=Ut,xe=bt,jt=Ft;if(N.ori==1&&(Ce=bt,Ee=Ft,xe=pt,jt=Ut),Rn&&zs(T,Ki(Ce,T),Ki(Ce+Ee,T)),Pn)for(let $t in w){let Ye=w[$t];$t!=T&&Ye.from==null&&Ye.min!=He&&zs($t,Ki(xe+jt,$t),Ki(xe,$t))}Yu()}else ft.lock&&(ft._lock=!ft._lock,pr(S,!0,_!=null));_!=null&&(yn(pp,xp),_o(pp,n,Xe,je,O,Pt,null))}function vx(_,S,R,L,k,Z,lt){if(ft._lock)return;te(_);let pt=ks;if(ks){let bt=!0,Ut=!0,Ft=10,Bt,oe;N.ori==0?(Bt=Rn,oe=Pn):(Bt=Pn,oe=Rn),Bt&&oe&&(bt=Xe<=Ft||Xe>=O-Ft,Ut=je<=Ft||je>=Pt-Ft),Bt&&bt&&(Xe=Xe<Zr?0:O),oe&&Ut&&(je=je<Kr?0:Pt),pr(null,!0,!0),ks=!1}Xe=-10,je=-10,rt.fill(null),pr(null,!0,!0),pt&&(ks=pt)}function rm(_,S,R,L,k,Z,lt){ft._lock||(te(_),fo(),Yu(),_!=null&&_o(S_,n,Xe,je,O,Pt,null))}function am(){C.forEach(TA),F(n.width,n.height,!0)}kr(wu,to,am);let Qr={};Qr.mousedown=im,Qr.mousemove=jp,Qr.mouseup=sm,Qr.dblclick=rm,Qr.setSeries=(_,S,R,L)=>{let k=pn.match[2];R=k(n,S,R),R!=-1&&Zi(R,L,!0,!1)},gt&&(we(x_,g,im),we(dp,g,jp),we(y_,g,_=>{te(_),go(!1)}),we(b_,g,vx),we(S_,g,rm),Ap.add(n),n.syncRect=go);let Ol=n.hooks=i.hooks||{};function In(_,S,R){Xn?Fe.push([_,S,R]):_ in Ol&&Ol[_].forEach(L=>{L.call(null,n,S,R)})}(i.plugins||[]).forEach(_=>{for(let S in _.hooks)Ol[S]=(Ol[S]||[]).concat(_.hooks[S])});let om=(_,S,R)=>R,pn=vn({key:null,setSeries:!1,filters:{pub:D_,sub:D_},scales:[T,y[1]?y[1].scale:null],match:[N_,N_,om],values:[null,null]},ft.sync);pn.match.length==2&&pn.match.push(om),ft.sync=pn;let lm=pn.key,$u=Pv(lm);function _o(_,S,R,L,k,Z,lt){pn.filters.pub(_,S,R,L,k,Z,lt)&&$u.pub(_,S,R,L,k,Z,lt)}$u.sub(n);function xx(_,S,R,L,k,Z,lt){pn.filters.sub(_,S,R,L,k,Z,lt)&&Qr[_](null,S,R,L,k,Z,lt)}n.pub=xx;function yx(){$u.unsub(n),Ap.delete(n),Cn.clear(),Sp(wu,to,am),c.remove(),Ct?.remove(),In("destroy")}n.destroy=yx;function Zu(){In("init",i,t),uo(t||i.data,!1),V[T]?Hu(T,V[T]):fo(),st=qe.show&&(qe.width>0||qe.height>0),nt=mt=!0,F(i.width,i.height)}return y.forEach(Gr),C.forEach(us),e?e instanceof HTMLElement?(e.appendChild(c),Zu()):e(n,Zu):Zu(),n}xn.assign=vn;xn.fmtNum=Np;xn.rangeNum=Eu;xn.rangeLog=Cu;xn.rangeAsinh=Lp;xn.orient=Hr;xn.pxRatio=Ie;xn.join=_T;xn.fmtDate=Fp,xn.tzDate=CT;xn.sync=Pv;{xn.addGap=hA,xn.clipGaps=Iu;let i=xn.paths={points:Fv};i.linear=Bv,i.stepped=dA,i.bars=pA,i.spline=gA}function Gv(i){return`Plot of ${i.lines.map(e=>Gn(e.label,e.unit)).join(", ")} over ${Gn(i.x.label,i.x.unit)}. Plus and minus zoom, arrows move, 0 shows everything. The numbers follow as a table.`}function Wv(i,t){return{label:i.label,unit:i.unit,colour:Vr(`--line-${t%8+1}`),dash:t>=8}}function Vr(i){return getComputedStyle(document.documentElement).getPropertyValue(i).trim()||"#888888"}function Xv(i){for(let t=1;t<i.length;t++)if(!(i[t]>=i[t-1]))return!1;return i.length===0||Number.isFinite(i[0])}function Il(i){let[t,e]=[1/0,-1/0];for(let s of i)for(let r=0;r<s.length;r++){let a=s[r];Number.isFinite(a)&&(t=Math.min(t,a),e=Math.max(e,a))}if(t>e)return[0,1];let n=.5*Math.abs(t)||.5;return e>t?[t,e]:[t-n,e+n]}function qv(i,t){return Array.from(i,e=>Number.isFinite(e)&&(!t||e>0)?e:null)}function AA(i){let t={stroke:Vr("--ink-soft"),grid:{stroke:Vr("--grid"),width:1},ticks:{stroke:Vr("--grid"),width:1}},e=[...new Set(i.lines.map(o=>o.unit))],n=i.lines.length===1?i.lines[0].label:"",s=i.yLabel??(e.length===1?Gn(n,e[0]):""),r=(o,l)=>{let c=l.reduce((h,f)=>Math.max(h,Math.abs(f??0)),0);return l.map(h=>PA(h,c))},a=(o,l)=>Math.max(...(l??[]).map(c=>c.length*CA+16),RA);return[{...t,label:Gn(i.x.label,i.x.unit),labelSize:20,size:36,values:r},{...t,label:s,labelSize:s?20:4,size:a,values:i.log?(o,l)=>l.map(IA):r}]}var CA=7.2,RA=46;function PA(i,t){return i==null?"":(i!==0&&(t>=1e5||t<.01)?i.toExponential(2).replace(/\.?0+e/,"e").replace("e+","e"):String(Number(i.toPrecision(6)))).replaceAll("-","\u2212")}function IA(i){return i!=null&&Math.abs(Math.log10(i)-Math.round(Math.log10(i)))<1e-6?`1e${Math.round(Math.log10(i))}`.replace("-","\u2212"):""}function Yv(i,t){let e=i.bars?xn.paths.bars({size:[1,1/0],align:0}):null,n=t.map(r=>({label:r.label,stroke:r.colour,width:1.6,points:{show:i.bars?!1:i.x.values.length<40,size:5},...r.dash?{dash:[6,4]}:{},...e?{paths:e,fill:`${r.colour}59`,width:1}:{}})),s=i.marks?.length?18:8;return{legend:{show:!1},axes:AA(i),series:n,padding:[s,12,0,0]}}function $v(i,t){let e=Yv(i,t),n=Il([i.x.values]);if(i.bars&&i.x.values.length>1){let l=(i.x.values[1]-i.x.values[0])/2;n[0]-=l,n[1]+=l}let s=i.log??!1,[r,a]=Il([i.x.values]),o=(l,c)=>l==null||c==null||!(c>l)||l<=r&&c>=a?n:DA([l,c],n);return{options:{...e,series:[{},...e.series],scales:{x:{time:!1,range:(l,c,h)=>o(c,h)},y:s?{distr:3}:i.bars?{range:(l,c,h)=>[0,1.05*h||1]}:{range:(l,c,h)=>LA(c,h)}},cursor:{drag:{x:!0,y:!1},y:!1,points:{show:!i.bars}}},data:[Array.from(i.x.values),...i.lines.map(l=>qv(l.values,s))],whole:{x:n}}}function LA(i,t){if(i==null||t==null)return[0,1];let e=Math.abs(i)||1;return i===t?[i-e,t+e]:xn.rangeNum(i,t,.1,!0)}function DA([i,t],[e,n]){let s=Math.min(t-i,n-e),r=Math.min(Math.max(i,e),n-s);return[r,r+s]}function Zv(i,t){let e=i.log??!1,n=Yv(i,t),s=Vv(Il([i.x.values])),r=i.lines.map(h=>qv(h.values,e)),a=Il(r.map(h=>h.filter(f=>f!==null))),o=e?a:Vv(a),l=["x","y"].map(h=>({scale:h,auto:!0})),c=Array.from(i.x.values);return{options:{...n,mode:2,series:[null,...n.series.map(h=>({...h,facets:l,paths:NA,points:{show:!1}}))],scales:{x:{time:!1,auto:!1,range:(h,f,u)=>f==null||u==null||!(u>f)?s:[f,u]},y:{auto:!1,...e?{distr:3}:{},range:(h,f,u)=>f==null||u==null||!(u>f)?o:[f,u]}},cursor:{drag:{x:!0,y:!0,uni:30},points:{show:!1}}},data:[null,...r.map(h=>[c,h])],whole:{x:s,y:o}}}function Vv([i,t]){let e=.04*(t-i);return[i-e,t+e]}var NA=(i,t)=>{let[e,n]=i.data[t],s=new Path2D,r=!1;for(let a=0;a<e.length;a++){let[o,l]=[e[a],n[a]??null];if(l===null||!Number.isFinite(o)){r=!1;continue}let c=[i.valToPos(o,"x",!0),i.valToPos(l,"y",!0)];r?s.lineTo(...c):s.moveTo(...c),r=!0}return{stroke:s,fill:null,clip:null,flags:0}};function Kv(i){let{left:t,top:e}=i.cursor,n=i.data.slice(1);if(t==null||e==null||t<0||n.length===0)return[null,[]];let[s,r]=[-1,60**2];for(let[a,o]of n)for(let l=0;l<a.length;l++){let c=o[l],h=c==null?1/0:(i.valToPos(a[l],"x")-t)**2+(i.valToPos(c,"y")-e)**2;h<r&&([s,r]=[l,h])}return s<0?[null,[]]:[n[0][0][s],n.map(([,a])=>a[s]??null)]}var Uu=class{element=document.createElement("div");#t=[];#e=document.createElement("span");constructor(t,e,n){this.element.className="plot-legend",e.forEach((s,r)=>this.#r(s,r,n)),this.#e.className="plot-at",this.#e.dataset.title=Gn(t.label,t.unit),this.element.append(this.#e)}#r(t,e,n){let s=document.createElement("button");s.type="button",s.setAttribute("aria-pressed","true"),s.title="Show or hide";let r=document.createElement("span");r.className=t.dash?"swatch dash":"swatch",r.style.color=t.colour;let a=document.createElement("output");this.#t.push(a),s.append(r,Gn(t.label,t.unit),a),s.addEventListener("click",()=>{let o=s.getAttribute("aria-pressed")!=="true";s.setAttribute("aria-pressed",String(o)),n(e+1,o)}),this.element.append(s)}show(t,e){this.#e.textContent=t===null?"":`${this.#e.dataset.title}: ${ni(t)}`,this.#t.forEach((n,s)=>n.textContent=t===null?"":ni(e[s]??NaN))}};function Jv(i){let t=i.cursor.idx;return t==null?[null,[]]:[i.data[0][t]??null,i.data.slice(1).map(e=>e[t]??null)]}function jv(i,t){let{ctx:e,bbox:n}=i;e.save(),e.strokeStyle=e.fillStyle=Vr("--ink-soft"),e.lineWidth=window.devicePixelRatio,e.setLineDash([2*window.devicePixelRatio,3*window.devicePixelRatio]),e.font=`${11*window.devicePixelRatio}px system-ui, sans-serif`,e.textAlign="left",e.textBaseline="alphabetic";let s=-1/0;for(let{at:r,label:a}of t){let o=i.valToPos(r,"x",!0);if(o<n.left||o>n.left+n.width)continue;e.beginPath(),e.moveTo(o,n.top),e.lineTo(o,n.top+n.height),e.stroke();let l=e.measureText(a).width;o>s&&o+l<n.left+n.width&&(e.fillText(a,o+4*window.devicePixelRatio,n.top-5*window.devicePixelRatio),s=o+l+12*window.devicePixelRatio)}e.restore()}function Qv(i,t){let{ctx:e,bbox:n}=i,s=t===null?NaN:i.valToPos(t,"x",!0);s>=n.left&&s<=n.left+n.width&&(e.save(),e.strokeStyle=Vr("--accent"),e.lineWidth=2*window.devicePixelRatio,e.beginPath(),e.moveTo(s,n.top),e.lineTo(s,n.top+n.height),e.stroke(),e.restore())}var UA=200;function tx(i,t){let e=t[0]?.values.length??0,n=Math.max(1,Math.ceil(e/UA)),s=document.createElement("table");s.createCaption().textContent=n>1?`${i}: one row in ${n} of ${e}`:i;let r=s.createTHead().insertRow();for(let{label:l,unit:c}of t){let h=document.createElement("th");h.scope="col",h.textContent=Gn(l,c),r.append(h)}let a=s.createTBody();for(let l=0;l<e;l+=n){let c=a.insertRow();for(let{values:h}of t)c.insertCell().textContent=ni(h[l]??NaN)}let o=document.createElement("div");return o.className="table-scroller",o.tabIndex=0,o.setAttribute("role","region"),o.setAttribute("aria-label",`Numbers of ${i}`),o.append(s),o}function Gp(i,t){let e=document.createElement("details");e.className="data-table";let n=document.createElement("summary");return n.textContent="Numbers",e.append(n),e.addEventListener("toggle",()=>{e.open&&e.replaceChildren(n,tx(i,t()))}),e}var FA={"+":i=>Ll(i,.7142857142857143),"=":i=>Ll(i,.7142857142857143),"-":i=>Ll(i,1.4),ArrowLeft:i=>ex(i,-.15),ArrowRight:i=>ex(i,.15),0:Dl,Home:Dl};function Dl(i,t){i.batch(()=>{for(let[e,[n,s]]of Object.entries(t))i.setScale(e,{min:n,max:s})})}function Ll(i,t){let{min:e,max:n}=i.scales.x;if(e!=null&&n!=null){let[s,r]=[(e+n)/2,t*(n-e)/2];i.setScale("x",{min:s-r,max:s+r})}}function ex(i,t){let{min:e,max:n}=i.scales.x;if(e!=null&&n!=null){let s=t*(n-e);i.setScale("x",{min:e+s,max:n+s})}}function nx(i,t,e){i.addEventListener("keydown",n=>{let s=FA[n.key];s&&n.target===i&&!n.ctrlKey&&!n.metaKey&&!n.altKey&&(s(t(),e()),n.preventDefault())})}function ix(i,t){let e=document.createElement("span");e.className="zoom-buttons";let n=(s,r,a)=>{let o=document.createElement("button");o.type="button",o.textContent=s,o.setAttribute("aria-label",r),o.title=r,o.addEventListener("click",a),e.append(o)};return n("\u2212","Zoom out",()=>Ll(i(),1.4)),n("+","Zoom in",()=>Ll(i(),1/1.4)),n("Reset","Reset: see everything",()=>Dl(i(),t())),e}var OA=300,lo=class{element=document.createElement("figure");#t=document.createElement("div");#e;#r=window.matchMedia("(prefers-color-scheme: dark)");#n=()=>this.#d();#s;#o;#a;#i={};#h=null;constructor(t,e){this.#s=e,this.element.className="plot",this.#t.className="plot-surface",this.#t.tabIndex=0,this.#t.setAttribute("role","application"),nx(this.#t,()=>this.#o,()=>this.#i),t.append(this.element),this.#d(),e.link?.join(this),this.#e=new ResizeObserver(()=>this.#o.setSize(this.#u())),this.#e.observe(this.#t),this.#r.addEventListener("change",this.#n),window.addEventListener("demeter:colours",this.#n)}update(t){let n=t.lines.map(s=>s.label).join()===this.#s.lines.map(s=>s.label).join()&&this.zoomed()?{...this.#o.scales.x}:null;this.#s=t,this.#d(),n&&n.min!=null&&n.max!=null&&this.#o.setScale("x",{min:n.min,max:n.max})}zoomed(){let{min:t,max:e}=this.#o.scales.x,n=this.#i.x;return n!==void 0&&t!=null&&e!=null&&(t>n[0]||e<n[1])}range(){let{min:t,max:e}=this.#o.scales.x;return[t??NaN,e??NaN]}see([t,e]){this.#o.setScale("x",{min:t,max:e})}setNow(t){t!==this.#h&&(this.#h=t,this.#o.redraw(!1,!1))}reset(){Dl(this.#o,this.#i)}dispose(){this.#s.link?.leave(this),this.#e.disconnect(),this.#r.removeEventListener("change",this.#n),window.removeEventListener("demeter:colours",this.#n),this.#o.destroy(),this.element.remove()}#l(){let t=this.#s.log??!1,e=Sn("log",()=>{this.update({...this.#s,log:!t}),this.element.querySelector("[aria-pressed].log")?.focus()},{class:"log","aria-pressed":t,title:"Logarithmic vertical axis"});return e.setAttribute("aria-pressed",String(t)),e}#c(t,e){let{min:n,max:s}=t.scales.x;e==="x"&&n!=null&&s!=null&&(this.element.dataset.range=`${n} ${s}`,this.#s.link?.spread(this,[n,s]))}#f(t){let{onPlace:e}=this.#s;if(e){let n=NaN;t.over.addEventListener("mousedown",s=>n=s.clientX),t.over.addEventListener("click",s=>{Math.abs(s.clientX-n)<4&&e(t.posToVal(s.offsetX,"x"))})}}#u(){return{width:Math.max(this.#t.clientWidth,200),height:this.#s.height??OA}}#d(){let t=this.#s;this.#o?.destroy();let e=t.lines.map((l,c)=>Wv(l,c)),n=document.createElement("figcaption");n.textContent=t.title;let s=ix(()=>this.#o,()=>this.#i);t.canBeLog&&s.prepend(this.#l()),n.append(s),this.#t.setAttribute("aria-label",Gv(t)),this.#a=new Uu(t.x,e,(l,c)=>this.#o.setSeries(l,{show:c}));let r=Gp(t.title,()=>[t.x,...t.lines]);r.open=this.element.querySelector("details")?.open??!1,this.element.replaceChildren(n,this.#t,this.#a.element,r);let a=!Xv(t.x.values),o=a?Zv(t,e):$v(t,e);if(o.options.hooks={setCursor:[l=>this.#a.show(...a?Kv(l):Jv(l))],draw:[l=>jv(l,t.marks??[]),l=>Qv(l,this.#h)],ready:[l=>this.#f(l)],setScale:[(l,c)=>this.#c(l,c)]},t.link&&!a){let l=c=>c==="mousemove"||c==="mouseleave";o.options.cursor={...o.options.cursor,sync:{key:t.link.key,setSeries:!1,scales:["x",null],filters:{pub:l,sub:l}}}}this.#o=new xn({...o.options,...this.#u()},o.data,this.#t),this.#i=o.whole}};var BA=24,kA=2,Fu=class{id;#t=[];#e=!1;#r=0;#n=!1;constructor(t){this.id=t}stop(){this.#n=!0}known(){return[...this.#t.entries()].filter(t=>t[1]!==void 0)}async read(t,e){if(this.#e){this.#r=t;return}let n=zA(t).filter(r=>this.#t[r]===void 0);this.#e=!0,this.#r=0;let s=async()=>{for(;n.length>0&&!this.#n;){let r=n.splice(0,BA),{moments:a}=await P0(this.id,r);n.unshift(...a.length>0?r.slice(a.length):[]),a.forEach((o,l)=>this.#t[r[l]]=o),this.#n||e()}};try{await Promise.all(Array.from({length:kA},s))}finally{this.#e=!1}this.#r>t&&!this.#n&&await this.read(this.#r,e)}};function zA(i){let t=i>1?[0,i-1]:i>0?[0]:[],e=1;for(;2*e<i;)e*=2;for(;e>=1;e/=2)for(let n=e;n<i-1;n+=2*e)t.push(n);return t}var HA=300,VA={position:"m",radius:"m",mass:"kg",velocity:"m/s",angular_velocity:"1/s",force:"N",torque:"N m",contact_force:"N",mean_normal_stress:"Pa"},GA=["id","diameter","orientation"],sx=[["speed","speed","m/s",i=>i.speed],["contact_force","contact force","N",i=>i.contact_force],["force","total force","N",i=>i.force],["coordination","coordination","",i=>i.coordination],["x","x","m",i=>i.position[0]],["y","y","m",i=>i.position[1]],["z","z","m",i=>i.position[2]]],Ou=class{element=et("section",{class:"grain-panel","aria-label":"Picked grain"});#t;#e=et("input",{type:"number",min:1,max:4294967295,step:1,"aria-label":"Id of a grain"});#r=et("div",{class:"grain-values"});#n=et("div",{class:"grain-plots"});#s=et("p",{class:"hint",role:"status"});#o;#a=null;#i=null;#h=[];#l=null;#c=0;#f=null;#u=0;#d=0;constructor(t){this.#t=t;let e=Ai("History of",sx.map(([s,r,a])=>[s,a?`${r} [${a}]`:r]),()=>this.#m());this.#o=e.select;let n=et("form",{class:"grain-form"},et("label",{},"Grain ",this.#e),et("button",{type:"submit"},"Show"),Sn("None",()=>this.#t.pick(null)));n.addEventListener("submit",s=>{s.preventDefault(),Number.isInteger(this.#e.valueAsNumber)&&this.#e.valueAsNumber>=0&&this.#t.pick(this.#e.valueAsNumber)}),this.#n.append(e.element),this.#n.hidden=!0,this.element.append(et("h2",{},"Grain"),n,this.#s,this.#r,this.#n),this.#s.textContent="Click a grain in the picture, or type its id."}get grain(){return this.#a}show(t){this.#c+=1,this.#a=t,this.#l?.stop(),this.#l=t===null?null:new Fu(t),this.#f?.dispose(),this.#f=null,this.#n.hidden=t===null,this.#r.replaceChildren(),this.#s.textContent=t===null?"Click a grain in the picture, or type its id.":"",this.#e.value=t===null?"":String(t),t!==null&&(this.#p(),this.#v())}setTimes(t,e){this.#h=t,this.#a!==null&&(e?(this.#i=null,this.show(this.#a)):this.#v())}setFrame(t){if(this.#i=t,this.#f?.setNow(t.time),this.#a===null)return;clearTimeout(this.#d);let e=Math.max(HA-(performance.now()-this.#u),0);this.#d=window.setTimeout(()=>{this.#p()},e)}async#p(){let[t,e,n]=[this.#c,this.#i,this.#a];if(!(n===null||e===null)){if(!e.grains.id.includes(n)){this.#r.replaceChildren(),this.#s.textContent=`Grain ${n} is not there at this moment.`;return}this.#u=performance.now();try{let s=await R0(e.step,n);t===this.#c&&e===this.#i&&(this.#s.textContent="",this.#r.replaceChildren(...this.#b(s)))}catch(s){t===this.#c&&(this.#r.replaceChildren(),this.#s.textContent=s.message)}}}#b(t){let e=et("dl",{class:"values"});for(let[n,s]of Object.entries(t.values))!GA.includes(n)&&s!==null&&e.append(et("div",{},et("dt",{},n.replaceAll("_"," ")),et("dd",{},WA(s,VA[n]??""))));return[e,this.#g(t.contacts)]}#g(t){if(t.length===0)return et("p",{class:"hint"},"No contact acts on it at this moment.");let e=et("table");e.createCaption().textContent=`${t.length} ${t.length===1?"contact":"contacts"} at this moment; repulsion is positive`;let n=e.createTHead().insertRow();for(let a of["Partner","Normal force","Tangential force","Overlap"])n.append(et("th",{scope:"col"},a));let s=e.createTBody(),r=a=>Math.abs(a.normal_force??0);for(let a of[...t].sort((o,l)=>r(l)-r(o))){let o=s.insertRow(),l=et("th",{scope:"row"});l.append(a.wall>=0?`wall ${this.#t.wallName(a.wall)}`:Sn(`grain ${a.partner}`,()=>this.#t.pick(a.partner),{class:"link"})),o.append(l);for(let[c,h]of[[a.normal_force,"N"],[a.tangential_force,"N"],[a.overlap,"m"]])o.insertCell().textContent=_n(c??NaN,h)}return et("div",{class:"table-scroller",tabindex:0,role:"region","aria-label":"Contacts of the grain"},e)}async#v(){let t=this.#l;try{await t?.read(this.#h.length,()=>t===this.#l&&this.#m())}catch(e){t===this.#l&&(this.#s.textContent=e.message)}}#m(){let[,t,e,n]=sx.find(([l])=>l===this.#o.value),s=(this.#l?.known()??[]).filter(([l])=>l<this.#h.length);if(s.length===0)return;let r=s.map(([l])=>this.#h[l]),a=s.map(([,l])=>l?n(l)??NaN:NaN),o={title:`${t} of grain ${this.#a} over time`,x:{label:"time",unit:"s",values:r},lines:[{label:t,unit:e,values:a}],height:220,onPlace:this.#t.seek};this.#f?this.#f.update(o):this.#f=new lo(this.#n,o),this.#f.setNow(this.#i?.time??null)}};function WA(i,t){return typeof i=="string"?i:Array.isArray(i)?`(${i.map(e=>_n(e??NaN,t)).join(", ")})`:t===""?ni(i):_n(i,t)}var XA=["kinetic energy","elastic energy"],rx=12,Bu=class{element=et("section",{class:"series-panel","aria-label":"Series"});#t;#e=et("div",{class:"series-plot"});#r=et("div",{class:"column-list"});#n=et("p",{class:"hint",role:"status"});#s=et("input",{type:"search",placeholder:"energy, wall top, \u2026"});#o;#a=null;#i=null;#h=0;#l=!1;#c=new Set;#f=new Map;#u=null;#d=!1;constructor(t){this.#t=t;let e=Ai("Horizontal axis",[],o=>{this.#h=Number(o),this.#m()});this.#o=e.select;let n=si("Logarithmic vertical axis",!1,o=>{this.#l=o,this.#S()});this.#s.addEventListener("input",()=>this.#v());let s=et("label",{class:"field"},et("span",{},"Find columns"),this.#s),r=et("fieldset",{},et("legend",{},"Vertical axis"),s,this.#n,this.#r),a=et("div",{class:"own-choices"},e.element,n.element,r);this.element.append(et("h2",{},"Series"),et("div",{class:"own-plot"},a,this.#e))}update(t,e){e&&this.#f.clear();let n=a=>a?.columns.map(o=>o.name).join(`
`)??"",s=n(t)===n(this.#a),r=t?.rows!==this.#a?.rows;this.#a=t,s||this.#p(),(!s||r||e)&&this.#m()}setTime(t){this.#i=t,this.#u?.setNow(this.#y())}#p(){let t=this.#a?.columns??[],e=t.map((n,s)=>[n,s]).filter(([n])=>n.numbers);this.#f.clear(),this.#c=new Set(e.filter(([n])=>XA.includes(n.name)).map(([,n])=>n)),this.#h=Math.max(t.findIndex(n=>n.name==="time"),0),this.#o.replaceChildren(...e.map(([n,s])=>et("option",{value:s},Gn(n.name,n.unit)))),this.#o.value=String(this.#h),this.#r.replaceChildren(...e.map(([n,s])=>this.#b(n,s))),this.#v(),this.#g()}#b(t,e){let n=si(Gn(t.name,t.unit),this.#c.has(e),s=>{s?this.#c.add(e):this.#c.delete(e),this.#g(),this.#m()});return n.element.dataset.name=t.name.toLowerCase(),n.element}#g(){let t=this.#c.size>=rx;for(let e of this.#r.querySelectorAll("input"))e.disabled=t&&!e.checked;this.#n.textContent=t?`${rx} columns are ticked, which is the most; untick one to tick another.`:""}#v(){let t=this.#s.value.toLowerCase().split(/\s+/);for(let e of this.#r.children)e.hidden=!t.every(n=>e.dataset.name.includes(n))}async#m(){if(!this.#d){this.#d=!0;try{for(let t=0;t<100;t++){let e=this.#a?.rows??0,n=this.#x().filter(a=>(this.#f.get(a)?.length??0)<e);if(n.length===0)break;let s=Math.min(...n.map(a=>this.#f.get(a)?.length??0)),r=await I0(n,s);for(let a of n)this.#f.set(a,qA(this.#f.get(a),r.doubles(String(a)),r.head.from))}}catch(t){this.#e.dataset.fault=String(t)}finally{this.#d=!1}this.#S()}}#x(){let t=this.#a?.columns.findIndex(n=>n.name==="time")??-1,e=[...this.#c].sort((n,s)=>n-s);return[...new Set([this.#h,t,...e])].filter(n=>n>=0)}#_(t,e){let{name:n,unit:s}=this.#a.columns[t];return{label:n,unit:s,values:this.#f.get(t).subarray(0,e)}}#S(){let t=[...this.#c].sort((c,h)=>c-h),e=[this.#h,...t].map(c=>this.#f.get(c)?.length??0),n=Math.min(...e);if(!this.#a||t.length===0||n===0){this.#u?.dispose(),this.#u=null;let c=this.#a&&this.#a.rows>0?"Tick the columns to plot; any column may be the horizontal axis.":"The run has no row yet.";this.#e.replaceChildren(et("p",{class:"hint"},c));return}let s=this.#_(this.#h,n),r=t.map(c=>this.#_(c,n)),a=s.label==="time",o=a?this.#a.stages.filter(c=>c.from<n).map(c=>({at:s.values[c.from],label:c.name})):[],l={title:`${r.map(c=>c.label).join(", ")} over ${s.label}`,x:s,lines:r,log:this.#l,marks:o,height:320,...a?{onPlace:this.#t}:{}};this.#u?this.#u.update(l):(this.#e.replaceChildren(),this.#u=new lo(this.#e,l)),this.#u.setNow(this.#y())}#y(){let t=this.#a?.columns.findIndex(s=>s.name==="time")??-1,[e,n]=[this.#f.get(t),this.#f.get(this.#h)];return this.#i===null||!e||!n?null:t===this.#h?this.#i:n[YA(e,this.#i)]??null}};function qA(i,t,e){let n=i?.subarray(0,e)??new Float64Array,s=new Float64Array(n.length+t.length);return s.set(n),s.set(t,n.length),s}function YA(i,t){let[e,n]=[0,i.length-1];for(;e<n;){let s=e+n>>1;i[s]<t?e=s+1:n=s}return e>0&&t-i[e-1]<i[e]-t?e-1:e}var $A=[1,2,5,10,15,25,30,60],ZA=4,ax="demeter-keys-narrow",ox=[["Space","play or pause"],["Left and right arrow, or , and .","one frame back or on"],["Home and End","first and last frame"]],ku=class{element=et("section",{class:"timeline","aria-label":"Timeline"});#t;#e=et("input",{type:"range",min:0,max:0,step:1,value:0,"aria-label":"Frame"});#r=et("p",{class:"time-told"});#n=et("p",{class:"unseen",role:"status","aria-live":"polite"});#s;#o;#a;everywhere=si("These keys work wherever the focus is on the page",!KA(ax),t=>JA(ax,!t));#i=[];#h=[];#l=-1;#c=-1;#f=10;#u=!1;#d=-1;#p=!1;#b=Promise.resolve();#g=0;constructor(t){this.#t=t;let e=(l,c,h)=>Sn(l,h,{"aria-label":c,title:c});this.#s=e("Play","Play",()=>this.toggle()),this.#s.classList.add("play");let n=Ai("Frames per second",$A.map(l=>[String(l),String(l)]),l=>this.#f=Number(l));n.select.value=String(this.#f);let s=si("Loop",!1,()=>{}),r=si("Live",!1,l=>l&&this.#v());r.element.title="Follow the run: show the newest frame as soon as it is there",[this.#o,this.#a]=[r.input,s.input],this.#e.addEventListener("input",()=>this.seek(this.#e.valueAsNumber));let a=et("div",{class:"time-buttons"},e("|\u25C0","First frame",()=>this.seek(0)),e("\u25C0","One frame back",()=>this.seek(this.#c-1)),this.#s,e("\u25B6","One frame on",()=>this.seek(this.#c+1)),e("\u25B6|","Last frame",()=>this.seek(this.#i.length-1))),o=et("div",{class:"time-choices"},n.element,s.element,r.element);this.element.append(et("div",{class:"time-row"},a,this.#e,this.#r),o,this.#n),document.addEventListener("keydown",l=>this.#E(l)),this.#w()}get index(){return this.#l}get playing(){return this.#u}get live(){return this.#o.checked}set live(t){this.#o.checked=t,t&&this.#v()}setMoments(t,e,n){[this.#h,this.#i]=[t,e],this.#e.max=String(Math.max(e.length-1,0)),this.#e.disabled=e.length<2,this.#l>=e.length&&(this.#l=this.#c=-1),e.length>0&&(this.#l<0||this.live||n)&&this.#x(this.live?e.length-1:Math.max(this.#l,0)),this.#w()}seek(t){let e=Math.min(Math.max(t,0),this.#i.length-1);e<this.#i.length-1&&(this.#o.checked=!1),this.pause(),this.#x(e)}seekTime(t){let e=0;this.#i.forEach((n,s)=>{Math.abs(n-t)<Math.abs(this.#i[e]-t)&&(e=s)}),this.seek(e)}toggle(){this.#u?this.pause():this.#i.length>1&&(this.#o.checked=!1,this.#u=!0,this.#m(),this.#y())}pause(){this.#u&&(this.#u=!1,this.#m(),this.#M())}#v(){this.pause(),this.#i.length>0&&this.#x(this.#i.length-1)}#m(){this.#t.plays(this.#u),this.#s.textContent=this.#u?"Pause":"Play";let t=this.#u?"Pause":"Play";this.#s.setAttribute("aria-label",t),this.#s.title=t}#x(t){this.#d=this.#c=t,this.#e.value=String(t),this.#T(t),this.#p||(this.#b=this.#_())}async#_(){for(this.#p=!0;this.#d>=0;){let t=this.#d;this.#d=-1,await this.#S(t)}this.#p=!1,this.#M()}async#S(t){try{await this.#t.show(t)}finally{this.#l=t,this.element.dataset.shown=String(t+1),this.#w()}}async#y(){let t=++this.#g;for(await this.#b,this.#l>=this.#i.length-1&&(this.#l=-1);this.#u&&t===this.#g;){let e=this.#l+1,n=performance.now();if(e>=this.#i.length&&!this.#a.checked){this.pause();break}let s=e%this.#i.length;this.#c=s,this.#t.ahead(this.#A(s)),this.#p=!0,await this.#S(s),this.#p=!1;let r=Math.max(1e3/this.#f-(performance.now()-n),0);await new Promise(a=>setTimeout(a,r))}this.#d>=0&&!this.#p&&(this.#b=this.#_())}#A(t){let e=this.#i.length,n=Array.from({length:ZA+1},(s,r)=>t+r);return this.#a.checked?n.map(s=>s%e):n.filter(s=>s<e)}#w(){this.#T(this.#c)}#T(t){let e=this.#i[t],n=e===void 0?"no frame yet":`${_n(e,"s")} \xB7 frame ${t+1} of ${this.#i.length}`;this.#r.textContent=n,this.#r.title=e===void 0?"":`step ${this.#h[t]}`,this.#e.setAttribute("aria-valuetext",n),(document.activeElement!==this.#e||this.#u)&&(this.#e.value=String(Math.max(t,0)))}#M(){this.#u||(this.#n.textContent=`Time ${this.#r.textContent}`)}#E(t){if(t.ctrlKey||t.metaKey||t.altKey||t.shiftKey||t.defaultPrevented)return;let e=t.target,n=e instanceof HTMLInputElement?e.type:"";if(e instanceof HTMLTextAreaElement||["text","number","search"].includes(n)||e instanceof HTMLSelectElement||!(this.element.contains(e)||e instanceof HTMLCanvasElement)&&!this.everywhere.input.checked)return;let a=e instanceof HTMLAnchorElement||e instanceof HTMLButtonElement||e.tagName==="SUMMARY"||n==="checkbox",o=n==="range"||["application","region"].includes(e.getAttribute("role")??""),c={...a?{}:{" ":()=>this.toggle()},...o?{}:{ArrowLeft:()=>this.seek(this.#c-1),ArrowRight:()=>this.seek(this.#c+1),Home:()=>this.seek(0),End:()=>this.seek(this.#i.length-1)},",":()=>this.seek(this.#c-1),".":()=>this.seek(this.#c+1)}[t.key];c&&(t.preventDefault(),c())}};function KA(i){try{return localStorage.getItem(i)==="true"}catch{return!1}}function JA(i,t){try{localStorage.setItem(i,String(t))}catch{return}}var lx={live:700,idle:4e3},Wp=class{#t=new xu;#e=et("h1",{},"\u2026");#r=et("p",{class:"badge",role:"status"});#n=et("p",{class:"about"});#s=et("p",{class:"notice bad",role:"alert",hidden:!0});#o=et("div");#a=new Set;#i;#h;#l;#c;#f;#u=[];#d=[];#p=-1;#b=null;#g=new Map;#v="run";constructor(){let t=et("div"),e=et("main",{id:"main"},this.#s,t);document.body.append(et("a",{class:"skip",href:"#main"},"Skip to the picture"),et("header",{},et("div",{class:"title"},this.#e,this.#r),this.#n),e),this.#h=new ku({show:r=>this.#S(r),ahead:r=>this.#t.prefetch(r.map(a=>this.#u[a]),this.#i.showsChains),plays:r=>this.#i.scene&&(this.#i.scene.plays=r)}),this.#i=new tu(t,{label:"The run",fileName:"packing",describes:!1,onPick:r=>this.#c.show(r),needsChains:()=>{this.#S(this.#h.index)}}),this.#i.view.append(this.#h.element);let n=r=>this.#h.seekTime(r);this.#l=new Bu(n),this.#c=new Ou({pick:r=>this.#i.pick(r),seek:n,wallName:r=>this.#g.get(r)??String(r)}),e.append(et("div",{class:"below"},this.#c.element,this.#l.element),QA(this.#h.everywhere.element));let s=this.#i.scene;this.#f=s&&new vu({scene:s,name:()=>this.#v,count:()=>this.#d.length,index:()=>this.#h.index,time:r=>this.#d[r]??NaN,scales:()=>this.#i.scales,show:r=>this.#S(r)}),this.#f&&this.#i.controls.append(Qi("Walls",this.#o),this.#f.element),this.#m()}async#m(){for(;;){let t=!0;try{let e=this.#p<0?0:this.#d.length;t=await this.#x(await Fd(e)),this.#w(null)}catch(e){this.#w(e)}await new Promise(e=>setTimeout(e,t?lx.live:lx.idle))}}async#x(t){let e=t,n=this.#p<0,s=e.epoch!==this.#p;s&&(n||(e=await Fd(0)),this.#t.clear(),this.#g.clear(),this.#o.replaceChildren(),[this.#u,this.#d]=[[],[]],this.#p=e.epoch),this.#v=e.folder;let{moments:r}=e,a=r.times.length>0&&r.from===this.#d.length;return a&&(this.#u=[...this.#u,...r.steps],this.#d=[...this.#d,...r.times]),this.#_(e),this.#l.update(e.series,s&&!n),(a||s)&&(this.#h.setMoments(this.#u,this.#d,s),this.#c.setTimes(this.#d,s&&!n),this.#f?.setCount(this.#d.length)),n&&e.going_on&&(this.#h.live=!0),e.going_on}#_(t){this.#e.textContent=t.title||t.folder,document.title=`${t.title||t.folder} \u2013 Demeter`;let[e,n]=t.going_on?["running","good"]:t.summary?[t.summary.finished?"finished":"stopped",t.summary.finished?"good":"warn"]:["not ended","warn"];this.#r.textContent!==e&&(this.#r.textContent=e,this.#r.className=`badge ${n}`);let s=this.#d.at(-1),r=[`folder ${t.folder}`,`${this.#d.length} frames`,...s===void 0?[]:[`to ${_n(s,"s")}`],`${t.series?.rows??0} rows`,`Demeter ${t.version}`],a=t.summary&&!t.summary.finished?`; it ended because ${t.summary.stopped_by}`:"";this.#n.textContent=`${r.join(" \xB7 ")}${a}`,t.fault&&this.#w(new rr(t.fault))}async#S(t){let[e,n]=[this.#u[t],this.#p];if(e!==void 0){this.#h.playing||this.#t.only([e]);try{let s=await this.#t.get(e);if(this.#i.showsChains&&await this.#t.readChains(s),n!==this.#p)return;this.#b=s,this.#y(),await jA(),this.#w(null)}catch(s){s.name!=="AbortError"&&(this.#w(s),this.#h.pause())}}}#y(){let t=this.#b;t.walls.some(e=>!this.#g.has(e.index))&&this.#A(t),this.#i.show({...t,walls:t.walls.filter(e=>!this.#a.has(e.name))}),this.#l.setTime(t.time),this.#c.setFrame(t)}#A(t){t.walls.forEach(({index:n,name:s})=>this.#g.set(n,s));let e=[...this.#g.values()].map(n=>si(n,!this.#a.has(n),r=>{r?this.#a.delete(n):this.#a.add(n),this.#y()}).element);this.#o.replaceChildren(...e)}#w(t){this.#s.hidden=t===null,t&&this.#s.textContent!==t.message&&(this.#s.textContent=t.message,t instanceof rr||console.error(t))}};function jA(){return new Promise(i=>requestAnimationFrame(()=>setTimeout(i,0)))}function QA(i){let t=et("dl",{class:"keys"},...ox.flatMap(([n,s])=>[et("dt",{},n),et("dd",{},s)])),e=et("a",{href:"licences.txt"},"Licences of the libraries in this page");return et("footer",{},et("details",{},et("summary",{},"Keys of the timeline"),t,i),e)}new Wp;})();
