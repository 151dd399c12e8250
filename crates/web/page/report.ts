import "./base.css";
import { createScene } from "./scene";
import { Plot } from "./plots";

console.info(createScene, Plot);
