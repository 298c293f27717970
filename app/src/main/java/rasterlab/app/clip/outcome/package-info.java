/**
 * The answers of methods for a scene of the lab of clipping, step by step, beside the exact one.
 * Coordinates are the scene's. Start reading at {@link ClipResults}.
 */
package rasterlab.app.clip.outcome;
