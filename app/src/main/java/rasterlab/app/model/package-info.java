/**
 * Models and scenes from files.
 *
 * <p>A file may name others; only those in its own folder and below it are opened. Start with
 * {@link rasterlab.app.model.ModelFile} and {@link rasterlab.app.model.SceneText}.
 */
package rasterlab.app.model;
