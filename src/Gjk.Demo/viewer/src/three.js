// What the pages take of three.js. It is one script, which stands before each page's own; build.mjs makes both.
export {
  AmbientLight, Box3, BoxGeometry, BufferAttribute, BufferGeometry, CircleGeometry, Color, ConeGeometry,
  CylinderGeometry, DataTexture, DirectionalLight, DoubleSide, EdgesGeometry, Group, HemisphereLight,
  InstancedBufferAttribute, InstancedMesh, LineBasicMaterial, LineDashedMaterial, LineSegments, Matrix4, Mesh,
  MeshBasicMaterial, MeshLambertMaterial, NearestFilter, PCFShadowMap, PerspectiveCamera, Plane, PlaneGeometry,
  Quaternion, Raycaster, RepeatWrapping, Scene, ShadowMaterial, SphereGeometry, Spherical, Vector2, Vector3,
  WebGLRenderer
} from 'three';
export { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
