/**
 * Reads models in the Wavefront OBJ format with their materials (MTL).
 *
 * <p>Text comes from readers that the caller opens. Coordinates are taken as they are, as world
 * units; faces run counter-clockwise seen from outside. Start with {@link
 * rasterlab.engine.scene.obj.ObjReader}; {@link rasterlab.engine.scene.obj.ObjModel} is what it
 * gives. Whatever a file leaves out of the picture is refused or named in the model's notes.
 */
package rasterlab.engine.scene.obj;
