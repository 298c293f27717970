/**
 * Shows what methods make of a scene of the lab of clipping, step by step, beside the exact answer.
 * Coordinates are the scene's. Start reading at {@link ClipResults}.
 */
package rasterlab.app.clip.outcome;
