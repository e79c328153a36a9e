'use strict';
// How faces and borders are drawn, in space and on the square, between the first candidate (0) and the best (1).

/// numbers that all materials share, so that a switch changes all pictures
function makeUniforms(scale) {
  const colors = new Uint8Array(scale.colors.flat());
  const texture = new THREE.DataTexture(colors, scale.colors.length, 1, THREE.RGBFormat);
  texture.unpackAlignment = 1;
  texture.magFilter = texture.minFilter = THREE.NearestFilter;
  texture.needsUpdate = true;
  return { best: { value: 1 }, coloring: { value: 0 }, colors: { value: texture } };
}

const CHECKERBOARD = 0, STRETCH = 1, FACE_NUMBERS = 2; // values of the uniform `coloring`

function makeFaceMaterial(uniforms, isFlat) {
  return new THREE.ShaderMaterial({
    uniforms,
    side: THREE.DoubleSide,
    extensions: { derivatives: true },
    polygonOffset: true, // borders lie before the faces
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    vertexShader: `
      uniform float best;
      attribute vec2 uvFirst;
      attribute float share, shareFirst;
      attribute vec4 faceColor;
      varying vec2 vUv;
      varying float vShare;
      varying vec3 vNormal, vFaceColor, vCorner;
      void main() {
        vUv = mix(uvFirst, uv, best);
        vShare = mix(shareFirst, share, best);
        vNormal = normalMatrix * normal;
        vFaceColor = faceColor.rgb;
        vCorner = faceColor.a < 0.25 ? vec3(1, 0, 0) : faceColor.a < 0.75 ? vec3(0, 1, 0) : vec3(0, 0, 1);
        gl_Position = projectionMatrix * modelViewMatrix * vec4(${isFlat ? 'vUv, 0.0' : 'position'}, 1.0);
      }`,
    fragmentShader: `
      uniform int coloring;
      uniform sampler2D colors;
      varying vec2 vUv;
      varying float vShare;
      varying vec3 vNormal, vFaceColor, vCorner;
      // how much of the pixel is an edge, nothing where faces are no more than a few pixels wide
      float edgeShare() {
        vec3 width = fwidth(vCorner), distance = vCorner / width;
        float nearest = min(min(distance.x, distance.y), distance.z);
        float faceWidth = 1.0 / max(max(width.x, width.y), width.z);
        return (1.0 - smoothstep(0.3, 1.0, nearest)) * smoothstep(4.0, 12.0, faceWidth);
      }
      // the share of light squares in a pixel: the checkerboard does not flicker where it is small
      float lightShare(vec2 place) {
        vec2 width = fwidth(place) + 1e-6;
        vec2 integral = 2.0 * (abs(fract((place - 0.5 * width) * 0.5) - 0.5)
                             - abs(fract((place + 0.5 * width) * 0.5) - 0.5)) / width;
        return 0.5 - 0.5 * integral.x * integral.y;
      }
      void main() {
        if (coloring == ${FACE_NUMBERS}) {
          gl_FragColor = vec4(vFaceColor, 1.0);
          return;
        }
        vec3 color = coloring == ${STRETCH} ? texture2D(colors, vec2(vShare, 0.5)).rgb
          : mix(vec3(0.235, 0.353, 0.549), vec3(0.94, 0.94, 0.92), lightShare(vUv * 32.0));
        ${isFlat ? 'color = mix(color, vec3(0.1), 0.45 * edgeShare());' : `color *= (gl_FrontFacing ? 1.0 : 0.6) * (0.4 + 0.6 * abs(normalize(vNormal).z));`}
        gl_FragColor = vec4(color, 1.0);
      }`
  });
}

/// \param size of the panel, a uniform that is set before each picture
function makeBorderMaterial(uniforms, size, isFlat) {
  return new THREE.ShaderMaterial({
    uniforms: Object.assign({ size }, uniforms),
    side: THREE.DoubleSide,
    vertexShader: `
      uniform float best;
      uniform vec2 size;
      attribute vec3 target, color;
      attribute vec2 targetUv, uvFirst, targetUvFirst, place;
      varying vec3 vColor;
      void main() {
        mat4 view = projectionMatrix * modelViewMatrix;
        vec4 a = view * vec4(${isFlat ? 'mix(uvFirst, uv, best), 0.0' : 'position'}, 1.0);
        vec4 b = view * vec4(${isFlat ? 'mix(targetUvFirst, targetUv, best), 0.0' : 'target'}, 1.0);
        vec2 along = (b.xy / b.w - a.xy / a.w) * size;
        along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
        vec2 across = vec2(-along.y, along.x) * place.y + along * (2.0 * place.x - 1.0); // a little beyond its ends
        gl_Position = place.x > 0.5 ? b : a;
        gl_Position.xy += across * (${isFlat ? '5.0' : '3.0'} / size) * gl_Position.w;
        vColor = color;
      }`,
    fragmentShader: `
      varying vec3 vColor;
      void main() { gl_FragColor = vec4(vColor, 1.0); }`
  });
}
