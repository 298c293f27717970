/**
 * The step player below a stage: to the start, back, play, step, to the end, position and speed. A
 * lab gives it its {@link Steps}; start reading at {@link StepPlayer}.
 */
package rasterlab.app.canvas.player;
